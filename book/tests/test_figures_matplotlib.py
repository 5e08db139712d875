"""matplotlib's figures, drawn again by the small renderer, beside those of the page's stand-in: the same bytes."""

import ast
import json
import re
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from slambook.figures import colors, draw_ellipse, draw_frame, draw_robot, picture
from slambook.figures.reading import CannotReplayError
from slambook.figures.replay import native_svg, replayed

from book.live.standin import pyplot as stand_in
from book.live.standin.axes import Axes
from book.tests.test_figures_engine import vertices
from book.tools import layout

ROOT = Path(__file__).parents[2]
ALT = "A figure that is drawn by two libraries."
rng = np.random.default_rng(7)
T = np.linspace(0, 10, 200)
GRID = np.meshgrid(np.linspace(-2, 2, 201), np.linspace(-2, 2, 201))
CLOUD = rng.standard_normal((2, 60))


@pytest.fixture(autouse=True)
def _the_book_s_look():
    with plt.style.context("slambook.book"):
        yield
    plt.close("all")


def lines(plt):
    fig, ax = plt.subplots(figsize=(5.8, 3.2))
    ax.plot(T, np.sin(T), label="$x_1$ [m]")
    ax.plot(T[::10], np.cos(T[::10]), "o--", ms=4, mew=2, mfc="none", label="measured")
    ax.plot(T, 0.1 * T, ":", color="k", lw=1, alpha=0.5)
    ax.plot([1, 2, np.nan, 3], [0, 1, 0, 1], "x-.", color=colors.red, zorder=5, clip_on=False)
    ax.set(xlabel="t [s]", ylabel="x [m]", title="two lines\nof words", ylim=(-1.5, None), xticks=range(0, 11, 5))
    ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=2, fontsize=8)
    return fig


def bands(plt):
    fig, (left, right) = plt.subplots(1, 2, figsize=(6.4, 3))
    left.axhspan(0.2, 0.5, color=colors.green, alpha=0.2, lw=0, label="95 % band")
    left.axvspan(3, 4, color=colors.orange, alpha=0.2)
    left.axvline(5, color=colors.grey, lw=0.8)
    left.axhline(0, ls="--", color=colors.text)
    left.plot(T, np.sin(T) ** 2, label="NEES")
    left.legend(loc="upper right")
    right.fill_between(T, np.sin(T) - 0.2, np.sin(T) + 0.2, alpha=0.25)
    right.fill_between(T, -1, 1, where=T > 8, color=colors.red, alpha=0.3)
    right.fill([1, 2, 2, 1], [0, 0, 1, 1], color=colors.blue, alpha=0.3, edgecolor=colors.text)
    right.step([1, 2, 3], [1, 0, 2], where="post", color=colors.purple)
    return fig


def logarithmic(plt):
    fig, axes = plt.subplots(2, 2, figsize=(6, 5))
    axes[0, 0].semilogy(np.exp(T))
    axes[0, 1].loglog(T[1:], T[1:] ** 3, "s-", ms=3)
    axes[1, 0].semilogx(T[1:], T[1:])
    axes[1, 1].plot(np.exp(T), color="C3")
    axes[1, 1].set(yscale="log", ylim=(1, 1e4), xlim=(0, 150))
    axes[0, 1].invert_xaxis()
    return fig


def maps(plt):
    fig, (left, right) = plt.subplots(1, 2, figsize=(6, 3))
    for ax, adjustable in ((left, "box"), (right, "datalim")):
        draw_ellipse(ax, [1, 2], [[2, 0.5], [0.5, 1]], color=colors.red, label="95 %")
        draw_robot(ax, [0, 1, 0.5])
        draw_frame(ax, [2, 1, 0.3], label="W")
        ax.set_aspect("equal", adjustable=adjustable)
        ax.legend(loc="upper right")
    left.set(xlim=(-3, 5), ylim=(-1, 5))
    return fig


def scattered(plt):
    fig, ax = plt.subplots()
    ax.scatter(*CLOUD, s=10, color=colors.blue, alpha=0.5, label="samples")
    ax.scatter([0, 1], [0, 1], s=80, c=["r", "k"], marker="^", label="two")
    ax.errorbar([0, 1, 2], [2, 2.5, 2], yerr=0.3, fmt="o", capsize=3)
    ax.hlines([1, 2], 0, 1, color=colors.green)
    ax.vlines([1.5], 0, 1, color=colors.orange)
    ax.legend(loc="upper left")
    return fig


def bars(plt):
    fig, (left, right) = plt.subplots(1, 2)
    left.bar([1, 2, 3], [3, 1, 2], color=colors.orange, label="counts")
    left.legend()
    right.hist(CLOUD[0], bins=8)
    return fig


def fields(plt):
    fig, (left, right, last) = plt.subplots(1, 3, figsize=(6, 3))
    left.imshow(np.arange(12.0).reshape(3, 4), cmap="viridis", vmin=0, vmax=15)
    left.plot([1], [1], "x", color=colors.red)
    left.set(xlim=(-0.5, 3.5), ylim=(2.5, -0.5), xticks=[0, 3], xticklabels=["a", "b"], yticks=[])
    right.imshow(CLOUD.reshape(12, 10), extent=(0, 10, 0, 12), origin="lower", interpolation="bilinear")
    right.axis("off")
    last.imshow(np.abs(np.sin(np.arange(48.0))).reshape(3, 4, 4))
    return fig


def words(plt):
    fig, ax = plt.subplots()
    ax.set(xlim=(0, 1), ylim=(0, 1))
    ax.text(0.2, 0.3, "here", color=colors.red, ha="center", va="top", fontsize=8, rotation=30)
    ax.text(0.5, 0.9, "share", transform=ax.transAxes)
    ax.annotate("there", (0.8, 0.5), (0.3, 0.6), arrowprops={"arrowstyle": "->", "color": colors.blue, "lw": 2})
    ax.annotate("1899", (0.4, 0.4), (3, 5), textcoords="offset points", ha="center")
    ax.annotate("", xy=(0.9, 0.9), xytext=(0.6, 0.7), arrowprops={"arrowstyle": "<|-|>", "shrinkA": 0})
    ax.grid(False)
    return fig


def arrows(plt):
    fig, ax = plt.subplots()
    ax.quiver([0.0, 1], [0.5, 1], [2.0, -1], [0, 3.0], angles="xy", scale_units="xy", scale=4.0, color=colors.red)
    ax.set(xlim=(-1, 2), ylim=(0, 2))
    return fig


def named(plt):
    fig, ax = plt.subplots()
    (a,) = ax.plot([0, 1])
    (b,) = ax.plot([1, 0], "s")
    ax.legend([a, b], ["up", "down"], title="which", loc="center", frameon=False)
    return fig


FIGURES = (lines, bands, logarithmic, maps, scattered, bars, fields, words, arrows, named)


@pytest.mark.parametrize("draw", FIGURES, ids=lambda f: f.__name__)
def test_the_page_draws_what_the_kernel_draws(draw):
    """The ranges, ticks, legends, colours: all that stands in the file, but for names that are made of the rest."""
    real, page = (re.sub(r"\b[0-9a-f]{8}-(?=\d)", "", picture(draw(p), ALT).svg) for p in (plt, stand_in))
    assert real.replace("<", "\n<").split("\n") == page.replace("<", "\n<").split("\n")


def test_contours_have_the_same_positions_and_styles():
    x, y = GRID
    drawn = []
    for library in (plt, stand_in):
        fig, ax = library.subplots()
        ax.contour(x, y, np.exp(-(x**2) - y**2), levels=[0.2, 0.6], colors=[colors.red])
        ax.contourf(x, y, x * y, levels=[0.5, 1, 2], colors=[colors.blue], alpha=0.4)
        drawn.append(picture(fig, ALT).svg)
    boxes, looks = [], []
    for svg in drawn:
        found = re.findall(r'd="(M[^"]*)" style="((?:stroke|fill):var\(--figure-(?:red|blue)[^"]*)', svg)
        looks.append([look for _, look in found])
        points = [np.concatenate(vertices(path)) for path, _ in found]
        boxes.append([(*p.min(axis=0), *p.max(axis=0)) for p in points])
    assert len(looks[0]) == 4
    assert looks[0] == looks[1]
    np.testing.assert_allclose(*boxes, atol=0.1)
    assert all(len(p) > 20 for p in points)
    assert len({tuple(re.findall(r"<text[^>]*>([^<]*)", svg)) for svg in drawn}) == 1


@pytest.mark.parametrize(
    "draw",
    [
        lambda fig, ax: fig.colorbar(ax.imshow([[1, 2]])),
        lambda fig, ax: ax.twinx(),
        lambda fig, ax: fig.suptitle("above all"),
        lambda fig, ax: ax.pcolormesh([[1, 2], [3, 4]]),
        lambda fig, ax: ax.plot([1], [1], marker="h"),
        lambda fig, ax: ax.set_xscale("symlog"),
        lambda fig, ax: ax.plot([0, 1], [0, 1], transform=ax.transAxes),
    ],
)
def test_what_the_small_renderer_cannot_draw_is_shown_as_matplotlib_draws_it(draw):
    fig, ax = plt.subplots()
    draw(fig, ax)
    svg = picture(fig, ALT).svg
    assert svg.startswith('<svg class="matplotlib" viewBox="0 0 417.6 252" role="img"')
    assert f'aria-label="{ALT}"' in svg


def test_matplotlib_s_own_drawing_follows_the_theme_too():
    svg = native_svg(lines(plt), ALT)
    assert {"blue", "orange", "red", "faint", "text"} <= set(re.findall(r"var\(--figure-(\w+)", svg))
    assert not re.findall(r"(?<!, )#[0-9a-f]{6}\b", re.sub(r'(id|href|url)[=(]"?[^")]*', "", svg))
    assert "<style" not in svg  # it would reach the whole page
    assert "<?xml" not in svg


def test_a_replayed_figure_is_a_third_as_heavy():
    fig = bands(plt)
    assert 3 * len(replayed(fig).svg(ALT)) < len(native_svg(fig, ALT))


def test_a_figure_that_is_shown_is_closed():
    stand_in.close("all")
    picture(lines(plt), ALT)
    assert plt.get_fignums() == []
    picture(lines(stand_in), ALT)
    assert stand_in.shown() == []
    lines(stand_in)
    assert len(stand_in.shown()) == 1
    with pytest.raises(CannotReplayError, match="no plain table"):
        replayed(plt.figure())


# -- the calls of the chapters -----------------------------------------------------------------------------------------


def figure_cells():
    """The sources of the chapters' cells that draw."""
    for file in layout.lessons():
        for cell in json.loads(file.read_text("utf-8"))["cells"]:
            source = re.sub("^%.*$", "", "".join(cell["source"]), flags=re.MULTILINE)
            if cell["cell_type"] == "code" and "plt.subplots(" in source:
                yield file.stem, ast.parse(source)


def test_the_stand_in_has_every_call_of_the_chapters_with_its_keywords():
    """By name; the page runs them all (`make live`), and compares what it draws with what the kernel drew."""
    known, seen = set(dir(Axes)) | {"set_aspect", "set_xticks", "set_ylabel", "set_xlabel"}, set()
    for name, tree in figure_cells():
        for node in ast.walk(tree):
            if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
                continue
            owner = node.func.value.id if isinstance(node.func.value, ast.Name) else ""
            if owner in ("ax", "mx", "left", "right") or ast.unparse(node.func.value) in ("axes[0]", "axes[1]"):
                seen.add(node.func.attr)
                assert node.func.attr in known, f"{name}: ax.{node.func.attr}"
            if owner == "plt":
                assert node.func.attr in ("subplots",), f"{name}: plt.{node.func.attr}"
    assert {"plot", "imshow", "legend", "set", "axhspan", "contour", "annotate", "semilogy"} <= seen


def test_nothing_named_matplotlib_lies_in_the_repository():
    found = [p for folder in ("book", "slamlib", "benchmarks") for p in (ROOT / folder).rglob("matplotlib*")]
    assert found == []
