"""Figures: self-sufficient, repeatable, themed, told apart, and sliders that a keyboard moves without any kernel."""

import re
import shutil
import subprocess
import sys
from dataclasses import asdict
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="drawing needs matplotlib")

from slamlib.drawing import (
    colors,
    draw_axes3d,
    draw_ellipse,
    draw_frame,
    draw_map,
    ellipse,
    figure,
    figure3d,
    picture,
    sweep,
)
from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.evaluation import chi2_cdf

STATIC = Path(__file__).parents[2] / "book" / "_static"
ALT = "A bell curve over the position in metres."


def bell(width):
    fig, ax = figure()
    x = np.linspace(-3, 3, 121)
    ax.plot(x, np.exp(-((x / width) ** 2)), label=r"prior, $p = 0.9991$")
    ax.fill_between(x, 0, np.exp(-((x / width) ** 2)), alpha=0.2)
    ax.scatter([0.0, 1.0], [0.2, 0.1], color="k", edgecolor="white", label="a < b & c")
    ax.set(xlim=(-3, 3), ylim=(0, 1.2), xlabel="x [m]", yticks=[0, 0.125, 1])
    ax.legend()
    return fig, f"The width is {width:.2f} m."


def html_of(value):
    return value._repr_html_()


# -- one picture -------------------------------------------------------------------------------------------------------


def test_a_picture_is_the_same_on_each_run_and_its_text_is_its_description():
    first, second = (picture(bell(1.0)[0], alt=ALT) for _ in range(2))
    assert html_of(first) == html_of(second)
    assert repr(first) == f"Picture: {ALT}"


def test_a_picture_is_well_formed_named_and_scales():
    svg = ElementTree.fromstring(picture(bell(1.0)[0], alt='A "quoted" curve & more of it.').svg)
    assert svg.get("role") == "img"
    assert svg.get("aria-label") == 'A "quoted" curve & more of it.'
    assert svg.get("viewBox") == "0 0 417.6 252"
    assert "width:100%;max-width:557px;height:auto" in svg.get("style")


def test_compacting_touches_no_word_of_the_figure():
    words = "".join(ElementTree.fromstring(picture(bell(1.0)[0], alt=ALT).svg).itertext())
    for word in ("0.9991", "0.125", "a < b & c", "x [m]"):
        assert word in words


def test_coordinates_are_kept_to_a_hundredth_of_a_point():
    fig, ax = figure()
    fig.set_layout_engine("none")
    ax.set(xlim=(0, 1), ylim=(0, 1), position=(0, 0, 1, 1))
    ax.axis("off")
    ax.plot([0.123456789, 0.5], [0.0, 1.0])
    path = re.search(r'<path d="M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)"', picture(fig, alt=ALT).svg)
    assert np.allclose([float(g) for g in path.groups()], [0.123456789 * 417.6, 252, 0.5 * 417.6, 0], atol=0.0051)


def test_pictures_in_one_page_share_no_name_and_refer_only_to_their_own():
    svgs = [picture(bell(w)[0], alt=ALT).svg for w in (1.0, 2.0)]
    svgs.append(picture(bell(1.0)[0], alt="The same curve, with other words.").svg)
    names = [set(re.findall(r' id="([^"]+)"', svg)) for svg in svgs]
    assert all(names)
    assert not any(a & b for a, b in combinations(names, 2))
    for svg, own in zip(svgs, names, strict=True):
        referred = {a or b for a, b in re.findall(r'url\(#([^)]+)\)|href="#([^"]+)"', svg)}
        assert referred == own


def test_every_colour_follows_the_theme_black_and_white_too():
    svg = picture(bell(1.0)[0], alt=ALT).svg
    assert not re.findall(r"(?<!, )#[0-9a-f]{6}\b", svg)
    assert {"text", "paper", "faint", "blue"} <= set(re.findall(r"var\(--figure-(\w+)", svg))
    assert "<style" not in svg  # it would reach the whole page


def test_nothing_is_left_open_and_no_setting_is_touched():
    import matplotlib as mpl
    from matplotlib import pyplot

    before = dict(mpl.rcParams)
    picture(bell(1.0)[0], alt=ALT)
    assert pyplot.get_fignums() == []
    assert dict(mpl.rcParams) == before


def test_misuse_is_named():
    fig, ax = figure()
    with pytest.raises(SlamlibError, match="a matplotlib figure is wanted, not Axes"):
        picture(ax, alt=ALT)
    with pytest.raises(SlamlibError, match="alt should be a sentence"):
        picture(fig, alt="a plot")
    with pytest.raises(SlamlibError, match="at least two values"):
        sweep(bell, "width [m]", [1.0], alt=ALT)
    with pytest.raises(SlamlibError, match="index of a frame, 0 to 1, got 2"):
        sweep(bell, "width [m]", [1.0, 2.0], alt=ALT, start=2)
    picture(fig, alt=ALT)


def test_without_matplotlib_the_message_says_what_to_install():
    program = (
        "import sys; sys.modules['matplotlib'] = None\n"
        "from slamlib.drawing import colors, ellipse, figure\n"
        "ellipse([0, 0], [[1, 0], [0, 1]]); print(colors.blue)\n"
        "try: figure()\nexcept Exception as error: print(type(error).__name__, error)"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "SlamlibError drawing needs matplotlib: pip install 'slamlib[draw]'" in run.stdout


def test_the_drawing_helpers_draw():
    fig, ax = figure(equal=True)
    covariances = np.array([np.eye(2), 0.1 * np.eye(2)])
    draw_map(ax, [[1, 2], [3, 1]], covariances, truth=[[1, 1]], path=[[0, 0], [1, 0]], pose=[1, 0, 0.3])
    draw_map(ax, [], truth=[[1, 1]], pose=[1, 0, 0.3], pose_covariance=0.1 * np.eye(3))
    draw_frame(ax, [0, 0, 0.5], label="W")
    draw_ellipse(ax, [0, 0], np.eye(2), sigmas=1, color=colors.red)
    assert "true landmarks" in [line.get_label() for line in ax.lines]
    assert picture(fig, alt="A small map, with a frame and ellipses.").svg.count("<path") > 8
    fig, ax = figure3d()
    draw_axes3d(ax, [1, 2, 3, np.sqrt(0.5), 0, 0, np.sqrt(0.5)], label="R")  # a quarter turn to the left about z
    np.testing.assert_allclose(ax.lines[0].get_data_3d(), [[1, 1], [2, 3], [3, 3]], atol=1e-12)
    with pytest.raises(ShapeError):
        draw_axes3d(ax, [1, 2, 3])
    assert ">R<" in picture(fig, alt="The axes of a frame in space.").svg


# -- ellipses ----------------------------------------------------------------------------------------------------------


def test_the_ellipse_holds_its_share_and_touches_its_sigmas():
    mean, covariance = np.array([1.0, -2.0]), np.array([[2.0, 0.9], [0.9, 0.5]])
    for probability in (0.5, 0.95, 0.99):
        d = ellipse(mean, covariance, probability=probability) - mean[:, None]
        squared = np.sum(d * np.linalg.solve(covariance, d), axis=0)
        assert squared == pytest.approx(np.full(73, squared[0]))
        assert chi2_cdf(squared[0], 2) == pytest.approx(probability)
    widest = ellipse([0, 0], covariance, sigmas=1, points=20001).max(axis=1)
    assert widest == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-6)


def test_a_singular_covariance_is_a_line_and_a_wrong_one_is_named():
    assert ellipse([0, 0], [[1, 1], [1, 1]])[0] == pytest.approx(ellipse([0, 0], [[1, 1], [1, 1]])[1])
    with pytest.raises(ShapeError):
        ellipse([0, 0, 0], np.eye(3))
    with pytest.raises(NonFiniteError):
        ellipse([0, np.nan], np.eye(2))
    with pytest.raises(SlamlibError, match="negative eigenvalue"):
        ellipse([0, 0], [[1, 0], [0, -1]])
    with pytest.raises(SlamlibError, match="probability"):
        ellipse([0, 0], np.eye(2), probability=0)
    with pytest.raises(SlamlibError, match="not both"):
        ellipse([0, 0], np.eye(2), probability=0.9, sigmas=1)


# -- colours -----------------------------------------------------------------------------------------------------------

# Machado, Oliveira, Fernandes (2009): what a reader without red, green or blue cones sees, on linear RGB.
SEEN = {
    "all cones": np.eye(3),
    "no red": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "no green": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "no blue": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}
SIX = ("blue", "orange", "green", "red", "purple", "grey")


def linear(colour):
    c = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def contrast(one, other):
    dark, light = sorted(0.05 + linear(c) @ [0.2126, 0.7152, 0.0722] for c in (one, other))
    return light / dark


def oklab(rgb):
    to_cones = [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566]]
    cones = np.cbrt(np.array([*to_cones, [0.0883024619, 0.2817188376, 0.6299787005]]) @ np.clip(rgb, 0, 1))
    rows = [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099]]
    return np.array([*rows, [0.0259040371, 0.7827717662, -0.8086757660]]) @ cones


def style_sheet():
    """The two palettes of figures.css: light, dark."""
    light, dark = (STATIC / "figures.css").read_text("utf-8").split('html[data-theme="dark"] {', 1)
    return [dict(re.findall(r"--figure-(\w+): (#[0-9a-f]{6});", part)) for part in (light, dark)]


def test_the_style_sheet_has_every_colour_twice_and_the_light_ones_are_those_of_notebooks():
    light, dark = style_sheet()
    assert set(light) == set(dark) == set(asdict(colors))
    assert {n: light[n] for n in SIX} == {n: getattr(colors, n) for n in SIX}


@pytest.mark.parametrize("theme", [0, 1], ids=["light", "dark"])
def test_colours_stand_out_and_are_told_apart(theme):
    palette = style_sheet()[theme]
    assert contrast(palette["text"], palette["paper"]) >= 7
    assert min(contrast(palette[n], palette["paper"]) for n in (*SIX, "faint")) >= 3
    for seen in SEEN.values():
        points = [oklab(np.array(seen) @ linear(palette[n])) for n in SIX]
        assert min(np.linalg.norm(a - b) for a, b in combinations(points, 2)) >= 0.06


def test_without_a_style_sheet_the_colours_stand_out_on_white_and_on_black():
    for name in (*SIX, "faint"):
        assert min(contrast(getattr(colors, name), paper) for paper in ("#ffffff", "#121212")) >= 3


# -- sliders -----------------------------------------------------------------------------------------------------------


def test_a_sweep_is_repeatable_light_and_its_text_is_its_description():
    sweeps = [sweep(bell, "width [m]", np.linspace(0.5, 2, 15), alt=ALT) for _ in range(2)]
    assert html_of(sweeps[0]) == html_of(sweeps[1])
    assert repr(sweeps[0]) == f"Sweep of width [m] over 15 values: {ALT}"
    assert len(html_of(sweeps[0])) < 400_000
    names = re.findall(r' id="([^"]+)"', html_of(sweeps[0]))
    assert len(names) == len(set(names))


def test_without_a_script_the_first_frame_is_the_one_that_shows():
    text = html_of(sweep(bell, "width <s> [m]", [-1.0, 2.0, 4.0], alt=ALT, start=2))
    assert re.findall(r'data-frame="(\d)"[^>]*( hidden)', text) == [("0", " hidden"), ("1", " hidden")]
    assert 'value="2"' in text
    assert "width &lt;s&gt; [m]</label>" in text
    assert "\N{MINUS SIGN}1" in text


CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SHOWN = "() => [...document.querySelectorAll('[data-frame]')].filter(e => e.checkVisibility()).map(e => e.innerText)"


@pytest.fixture(scope="module")
def page():
    playwright = pytest.importorskip("playwright.sync_api", reason="the slider is driven by playwright")
    if CHROMIUM is None:
        pytest.skip("no Chromium found (apt-get install chromium): the slider was not driven")
    with playwright.sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        yield browser.new_page(viewport={"width": 390, "height": 800})
        browser.close()


@pytest.mark.parametrize("style", ["figures.css", None], ids=["book", "notebook"])
def test_a_keyboard_moves_the_slider_without_a_kernel(page, style):
    css = (STATIC / style).read_text("utf-8") if style else ""
    body = html_of(sweep(bell, "width [m]", [0.5, 1.0, 2.0], alt=ALT)) + html_of(picture(bell(3.0)[0], alt=ALT))
    page.set_content(f'<html data-theme="dark"><style>{css}</style><body>{body}</body></html>')
    slider, output = page.get_by_label("width [m]", exact=True), page.locator("output")
    slider.focus()
    for key, value in (("", "1"), ("ArrowRight", "2"), ("Home", "0.5"), ("End", "2"), ("ArrowLeft", "1")):
        if key:
            page.keyboard.press(key)
        assert output.inner_text() == value
        assert slider.get_attribute("aria-valuetext") == value
        assert [f"The width is {float(value):.2f} m." in words for words in page.evaluate(SHOWN)] == [True]
    assert page.get_by_role("img", name=ALT).count() == 2
    assert page.evaluate("() => document.documentElement.scrollWidth <= window.innerWidth")


def test_the_page_s_theme_decides_the_colours(page):
    css = (STATIC / "figures.css").read_text("utf-8")
    body = html_of(picture(bell(1.0)[0], alt=ALT))
    seen = []
    for theme in ("light", "dark"):
        page.set_content(f'<html data-theme="{theme}"><style>{css}</style><body>{body}</body></html>')
        seen.append(page.evaluate("() => getComputedStyle(document.querySelector('svg text')).fill"))
    expected = [tuple(int(p["text"][i : i + 2], 16) for i in (1, 3, 5)) for p in style_sheet()]
    assert seen == [f"rgb{value}" for value in expected]
