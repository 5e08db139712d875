"""Figures: self-sufficient, repeatable, themed, distinct, and sliders that a keyboard moves without any kernel."""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import asdict
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import matplotlib.pyplot as plt
import numpy as np
import pytest
from slambook.figures import colors, draw_ellipse, draw_frame, draw_robot, ellipse, figure, live, picture, sweep
from slambook.figures.colors import standing_alone

from book.live.standin import pyplot as stand_in
from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.kalman.chi_square import chi2_cdf

ROOT = Path(__file__).parents[2]
STATIC = ROOT / "book" / "_static"
ALT = "A bell curve over the position in metres."


@pytest.fixture(autouse=True)
def _the_book_s_look():
    with plt.style.context("slambook.book"):
        yield
    plt.close("all")


def bell(width, plt=plt):
    fig, ax = plt.subplots()
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


def test_numpy_alone_draws_the_same_bytes_in_every_process():
    program = (
        "import sys\n"
        "for name in ('matplotlib', 'scipy', 'IPython', 'ipywidgets', 'sympy', 'PIL'): sys.modules[name] = None\n"
        "import hashlib, numpy as np\n"
        "from slambook.figures import *\n"
        "from book.live.standin import pyplot as plt\n"
        "fig, ax = plt.subplots(1, 2)\n"
        "ax[0].plot(np.linspace(0, 1, 99) ** 3, 'o-', alpha=0.5, label='a')\n"
        "ax[0].contourf(np.outer(np.arange(9.0), np.arange(9.0)), levels=[1, 5, 70]); ax[0].legend()\n"
        "ax[1].imshow(np.arange(12.0).reshape(3, 4)); ax[1].annotate('b', (1, 1), (2, 2), arrowprops={'color': 'r'})\n"
        "s = sweep(lambda v: fig, 'v', [1, 2], alt='Some pictures side by side.')\n"
        "print(hashlib.sha256(s._repr_html_().encode()).hexdigest())"
    )
    seen = set()
    for seed in ("0", "1", "4711"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", program]
        run = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=ROOT, check=False)
        assert run.returncode == 0, run.stderr
        seen.add(run.stdout)
    assert len(seen) == 1


def test_a_picture_is_well_formed_named_and_scales():
    svg = ElementTree.fromstring(picture(bell(1.0)[0], alt='A "quoted" curve & more of it.').svg)
    assert svg.get("role") == "img"
    assert svg.get("aria-label") == 'A "quoted" curve & more of it.'
    assert svg.get("viewBox") == "0 0 417.6 252"
    assert "width:100%;max-width:557px;height:auto" in svg.get("style")


def test_the_words_of_a_figure_stay_words():
    words = "".join(ElementTree.fromstring(picture(bell(1.0)[0], alt=ALT).svg).itertext())
    for word in ("prior, p = 0.9991", "0.125", "a < b & c", "x [m]"):
        assert word in words


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


def test_misuse_is_named():
    fig, ax = plt.subplots()
    with pytest.raises(SlamlibError, match=r"a figure of matplotlib's is wanted, not Axes: pass the figure"):
        picture(ax, alt=ALT)
    with pytest.raises(SlamlibError, match="alt should be a sentence"):
        picture(fig, alt="a plot")
    with pytest.raises(SlamlibError, match="at least two values"):
        sweep(bell, "width [m]", [1.0], alt=ALT)
    with pytest.raises(SlamlibError, match="index of a frame, 0 to 1, got 2"):
        sweep(bell, "width [m]", [1.0, 2.0], alt=ALT, start=2)
    with pytest.raises(ZeroDivisionError):  # a mistake in `draw` is found at once, not when the page shows it
        sweep(lambda v: 1 / 0, "width [m]", [1.0, 2.0], alt=ALT)
    with pytest.raises(SlamlibError, match="wanted, not tuple"):
        sweep(lambda v: (plt.subplots(), "note"), "width [m]", [1.0, 2.0], alt=ALT)


def test_a_figure_shows_by_itself_and_is_saved_whole_or_not_at_all(tmp_path):
    fig = bell(1.0, stand_in)[0]
    assert html_of(fig).startswith('<div class="picture"><svg ')
    assert ElementTree.fromstring(fig._repr_svg_()).tag == "{http://www.w3.org/2000/svg}svg"
    assert repr(fig) == "A figure: x [m]"
    file = tmp_path / "bell.svg"
    fig.savefig(file, alt=ALT)
    saved = ElementTree.fromstring(file.read_text("utf-8"))
    assert (saved.get("width"), saved.get("height")) == ("417.6pt", "252pt")
    assert "var(" not in file.read_text("utf-8")
    assert colors.blue in file.read_text("utf-8")
    before = file.read_bytes()
    fig, ax = stand_in.subplots()
    ax.semilogy([1, 2])
    ax.set(ylim=(-1, 2))
    with pytest.raises(SlamlibError, match="cannot span"):
        fig.savefig(file)
    with pytest.raises(SlamlibError, match=r"should end in \.svg"):
        fig.savefig(tmp_path / "bell.png")
    assert file.read_bytes() == before
    assert [f.name for f in tmp_path.iterdir()] == ["bell.svg"]
    with pytest.raises(SlamlibError, match="cannot be written: No such file"):
        bell(1.0, stand_in)[0].savefig(tmp_path / "nowhere" / "bell.svg")


def test_a_drawing_that_stands_alone_has_the_light_colours():
    svg = "fill:var(--figure-paper, var(--jp-layout-color0, var(--vscode-editor-background, Canvas)));stroke:"
    assert standing_alone(svg + "var(--figure-red, #cc0407)") == "fill:#ffffff;stroke:#cc0407"


def test_the_drawing_helpers_draw_on_matplotlib_and_without():
    drawn = []
    for make in (plt.subplots, figure):
        fig, ax = make()
        ax.set(xlim=(-3, 3), ylim=(-3, 3), aspect="equal")
        draw_robot(ax, [1, 0, 0.3])
        draw_frame(ax, [0, 0, 0.5], label="W")
        draw_ellipse(ax, [0, 0], np.eye(2), sigmas=1, color=colors.red)
        drawn.append(picture(fig, alt="A robot, a frame and an ellipse.").svg)
    assert drawn[0] == drawn[1]
    assert drawn[0].count("<path") > 5


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
    with pytest.raises(SlamlibError, match="negative variance"):
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
    assert len(html_of(sweeps[0])) < 80_000
    names = re.findall(r' id="([^"]+)"', html_of(sweeps[0]))
    assert len(names) == len(set(names))


def test_frames_are_drawn_when_the_page_needs_them_and_once():
    drawn = []

    def draw(value):
        drawn.append(value)
        return bell(value)

    made = sweep(draw, "width [m]", [1.0, 2.0, 4.0], alt=ALT)
    assert drawn == [2.0]
    html_of(made)
    html_of(made)
    assert sorted(drawn) == [1.0, 2.0, 4.0]


def test_a_live_slider_finds_every_place_between_the_values():
    made = sweep(bell, "width [m]", [0.5, 1.0, 4.0], alt=ALT)
    assert made.steps == 8
    value, svg, note = made.frame(1.5)
    assert (value, note) == ("2.5", "The width is 2.50 m.")
    assert svg == picture(bell(2.5)[0], f"{ALT} width [m]: 2.5.").svg
    assert made.frame(2)[0] == made.frame(6 * (1 / 3) + 1e-12)[0] == "4"  # a slider's steps are not exact
    assert made.frames[1] == made.frame(1.0)
    for position in (-0.1, 2.1, float("nan")):
        with pytest.raises(SlamlibError, match="a position lies between 0 and 2"):
            made.frame(position)


def test_whole_numbers_stay_whole_and_words_have_nothing_between_them():
    seen = []

    def draw(value):
        seen.append(value)
        return plt.subplots()[0]

    made = sweep(draw, "step", [1, np.int64(3), 4], alt=ALT)
    assert made.steps == 2
    assert [made.frame(p)[0] for p in (0, 0.5, 1, 1.4, 1.6, 2)] == ["1", "2", "3", "3", "4", "4"]
    assert all(isinstance(v, int | np.integer) for v in seen)
    assert sweep(draw, "step", range(0, 100, 20), alt=ALT).steps == 8
    words = sweep(draw, "filter", ["EKF", "UKF"], alt=ALT)
    assert words.steps == 1
    assert words.frame(1.0)[0] == "UKF"
    with pytest.raises(SlamlibError, match="there is nothing between 'EKF' and 'UKF'"):
        words.frame(0.5)


def test_without_a_script_the_first_frame_is_the_one_that_shows():
    text = html_of(sweep(bell, "width <s> [m]", [-1.0, 2.0, 4.0], alt=ALT, start=2))
    assert re.findall(r'data-frame="(\d)"[^>]*( hidden)', text) == [("0", " hidden"), ("1", " hidden")]
    assert 'value="2"' in text
    assert "width &lt;s&gt; [m]</label>" in text
    assert "\N{MINUS SIGN}1" in text


def test_only_the_note_is_read_out_when_the_slider_moves():
    text = html_of(sweep(bell, "width [m]", [1.0, 2.0], alt=ALT, start=0))
    assert re.findall(r'<(\w+)[^>]* aria-live="polite">([^<]*)<', text) == [("p", "The width is 1.00 m.")]


PROGRAM = """import matplotlib.pyplot as plt
from slambook.figures import picture, sweep
plt.style.use("slambook.book")
def draw(a):
    fig, ax = plt.subplots()
    ax.plot([0, 1], [0, a])
    return fig
"""
SHOWS = {
    "sweep": 'sweep(draw, "slope [m/m]", [1.0, 2.0], alt="A line that rises with the slope.")',
    "picture": 'picture(draw(1.0), alt="A line that rises, and no more.")',
}


@pytest.mark.filterwarnings("ignore")
def test_a_notebook_with_a_reader_gets_matplotlib_and_a_widget_and_an_executed_one_the_page_s_frames():
    pytest.importorskip("ipywidgets", reason="live sliders in notebooks need ipywidgets")
    manager = pytest.importorskip("jupyter_client.manager", reason="kernels are started by jupyter_client")
    kernels, client = manager.start_new_kernel(extra_arguments=["--IPKernelApp.log_level=ERROR"])
    found = {}
    try:
        client.execute_interactive(PROGRAM, timeout=120)
        for somebody in (False, True):
            for name, code in SHOWS.items():
                shown = []
                client.execute_interactive(code, allow_stdin=somebody, output_hook=shown.append, timeout=120)
                assert not {m["msg_type"] for m in shown} & {"display_data", "stream", "error"}  # shown once
                (found[name, somebody],) = (m["content"]["data"] for m in shown if m["msg_type"] == "execute_result")
    finally:
        client.stop_channels()
        kernels.shutdown_kernel(now=True)
    for name in SHOWS:
        assert set(found[name, False]) == {"text/plain", "text/html"}
        assert 'class="matplotlib"' not in found[name, False]["text/html"]
    assert set(found["sweep", True]) == {"text/plain", "text/html", "application/vnd.jupyter.widget-view+json"}
    assert 'class="matplotlib"' in found["picture", True]["text/html"]


def test_a_widget_draws_between_the_frames():
    pytest.importorskip("ipywidgets", reason="live sliders in notebooks need ipywidgets")
    made = sweep(bell, "width [m]", [1.0, 2.0, 4.0], alt=ALT, start=1)
    assert made._repr_mimebundle_() == {"text/plain": repr(made)}
    view = "application/vnd.jupyter.widget-view+json"
    try:
        live()
        assert set(made._repr_mimebundle_()) == {"text/plain", view}
    finally:
        live(None)
    menu = sweep(lambda name: plt.subplots()[0], "filter", ["EKF", "UKF"], alt=ALT).widget().children[0].children[0]
    assert (menu.options, menu.value) == ((("EKF", 0), ("UKF", 1)), 1)
    bar, drawing = made.widget().children
    slider, value = bar.children
    assert (slider.description, slider.value, slider.max, value.value) == ("width [m]", 8, 16, "2")
    slider.value = 4
    assert value.value == "1.5"
    play = sweep(bell, "step", [1, 5, 9], alt=ALT, start=1, play=True).widget().children[0].children[2]
    assert (play.value, play.max) == (4, 8)
    assert "The width is 1.50 m." in drawing.value
    assert f'aria-label="{ALT} width [m]: 1.5."' in drawing.value


CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SHOWN = (
    "() => [...document.querySelectorAll('[data-frame]')].filter(e => e.checkVisibility()).map(e => e.dataset.value)"
)


@pytest.fixture(scope="module")
def page():
    playwright = pytest.importorskip("playwright.sync_api", reason="the slider is driven by playwright")
    if CHROMIUM is None:
        pytest.skip("no Chromium found (apt-get install chromium): the slider was not driven")
    with playwright.sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        yield browser.new_page(viewport={"width": 390, "height": 800})
        browser.close()


def test_names_are_a_menu(page):
    names = ["none", "<E01>", "E02"]
    made = sweep(lambda name: (plt.subplots()[0], f"this is {name}"), "error", names, alt=ALT, start=1)
    assert made.names == names
    assert sweep(bell, "width [m]", [1.0, 2.0], alt=ALT).names == []
    page.set_content(f"<html><body>{html_of(made)}</body></html>")
    menu = page.get_by_label("error", exact=True)
    assert menu.evaluate("e => e.tagName") == "SELECT"
    assert menu.locator("option").all_inner_texts() == names
    assert page.evaluate(SHOWN) == ["<E01>"]
    menu.select_option("E02")
    assert page.evaluate(SHOWN) == ["E02"]
    menu.press("Home")
    assert page.evaluate(SHOWN) == ["none"]
    assert page.locator(".sweep-note").inner_text() == "this is none"
    assert page.locator("output").is_hidden()


def test_a_slider_over_time_plays_to_its_end_and_pauses(page):
    page.clock.install()
    page.set_content(html_of(sweep(bell, "width [m]", [0.5, 1.0, 2.0, 4.0], alt=ALT, start=1, play=True)))
    button, seen = page.get_by_role("button"), []
    button.click()
    for _ in range(4):
        assert button.inner_text() == "Pause" or seen[-1:] == ["4"]
        page.clock.run_for(1000)
        seen += page.evaluate(SHOWN)
    assert seen == ["2", "4", "4", "4"]
    assert button.inner_text() == "Play"
    button.click()  # at its end it begins again
    page.clock.run_for(1000)
    button.click()
    page.clock.run_for(3000)
    assert page.evaluate(SHOWN) == ["1"]
    assert button.inner_text() == "Play"
    with pytest.raises(SlamlibError, match="only numbers can be played, and one value is 'EKF'"):
        sweep(bell, "filter", ["EKF", "UKF"], alt=ALT, play=True)


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
        assert page.evaluate(SHOWN) == [value]
        assert page.locator(".sweep-note").inner_text() == f"The width is {float(value):.2f} m."
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


def test_a_figure_asks_for_the_width_that_its_smallest_letters_need():
    def least(size):
        fig, ax = plt.subplots()
        ax.plot([0, 1], [0, 1])
        ax.text(0.5, 0.5, "small", fontsize=size)
        svg = picture(fig, "A line that rises, and a word.").svg
        width, asked = (float(re.search(found, svg)[1]) for found in (r'viewBox="0 0 ([\d.]+)', r"--least:(\d+)px"))
        return asked / width

    assert least(11) * 10.6 == pytest.approx(9, rel=0.01)  # those of the ticks
    assert least(9) * 9 == pytest.approx(9, rel=0.01)
