"""Reading mode: folds with names, results above their code, buttons where the reader points, prose of a good width."""

import importlib.util
import re
from collections.abc import Iterator
from typing import Any

import pytest

from book.tests.site.live_page import SHOWN, address, live_pages
from book.tools import browser as loading
from book.tools import layout

PAGES = {name: address(layout.BOOK / "chapters" / f"{name}.ipynb") for name in ("points", "slam_in_five_minutes")}
WIDE = address(layout.BOOK / "chapters" / "frames_and_quaternions.ipynb")  # has formulas that a phone scrolls
SUMMED = address(layout.BOOK / "chapters" / "stochastic_map.ipynb")  # proves much in a cell whose code is seen
HOW = "proved by computer algebra", "equal to 50 digits"
OPEN = "() => [...document.querySelectorAll('details.hide.above-input')].map(e => e.open)"
OPACITY = "e => getComputedStyle(e).opacity"
BELOW = """() => [...document.querySelectorAll('div.cell:has(> details.above-input) > .cell_output:not([hidden])')]
  .filter(e => e.textContent.trim() || e.querySelector('svg'))
  .map(e => [e, e.parentElement.querySelector(':scope > details')].map(e => e.getBoundingClientRect()))
  .map(([result, fold]) => result.bottom - fold.top)"""
UNDER = """(cells) => cells.map(e => ['figure.of-cell', '.cell_output:not([hidden])']
  .map(part => e.querySelector(':scope > ' + part).getBoundingClientRect()))
  .map(([caption, drawn]) => caption.top - drawn.bottom)"""
FORMULAS = """[...document.querySelectorAll('.bd-article mjx-container[display="true"]')]
  .map(e => [e.scrollWidth > e.clientWidth, e.tabIndex])"""
WIDTHS = """() => [...document.querySelectorAll('.bd-article section > p')]
  .map(e => e.getBoundingClientRect().width).filter(w => w)"""


@pytest.fixture(scope="module", params=PAGES)
def url(request: Any, site: str) -> str:
    return f"{site}/{PAGES[request.param]}"


@pytest.fixture(scope="module")
def read(url: str, browser: Any) -> Iterator[Any]:
    """The page, with nothing changed in it."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(url)
    page.wait_for_function("() => window.Live && Live.page")
    yield page
    page.close()


@pytest.mark.parametrize("script", [True, False], ids=["script", "no-script"])
def test_a_fold_says_what_it_hides_and_how_long_it_is(url, script, browser, outside):
    page = browser.new_page(java_script_enabled=script)
    page.goto(url)
    summaries = page.locator("details.hide > summary")
    names = [name.strip() for name in summaries.all_inner_texts()]
    assert names[0].startswith("Setup, ")
    assert len(names) > 5
    for name in names:
        kind, _, lines = name.rpartition(", ")
        assert kind in ("Setup", "Code", "Code of this figure", "Output", "Table", *HOW), name
        assert int(lines.split()[0]) > 1, name
    assert summaries.first.get_attribute("aria-label") is None
    page.close()


def test_a_proof_is_one_line_with_its_code_and_what_it_printed_behind_it(browser, site, outside):
    page = browser.new_page()
    page.goto(f"{site}/{PAGES['points']}")
    page.wait_for_function("() => window.Live && Live.page")
    cell = page.locator("div.cell:has(> details.confirmed)").first
    assert re.fullmatch(r"proved by computer algebra, \d+ entries", cell.inner_text().strip().splitlines()[0])
    assert "assert_same" not in cell.inner_text()
    cell.locator("summary").click()
    assert "by symbolic difference" in cell.locator("details .cell_output").inner_text()
    assert "assert_same" in cell.locator("textarea").input_value()
    page.close()


def test_results_stand_above_their_folded_code(read):
    gaps = read.evaluate(BELOW)
    assert gaps
    assert max(gaps) <= 1


def test_buttons_are_there_when_a_reader_points_at_a_cell_or_is_in_it(read):
    read.add_style_tag(content="* { transition: none !important; }")
    cell = read.locator("div.cell.tag_live:not(:has(> details.above-input))").first
    bar = cell.locator(".live-bar")
    read.mouse.move(0, 0)
    assert bar.evaluate(OPACITY) == "0"
    cell.hover()
    assert bar.evaluate(OPACITY) == "1"
    read.mouse.move(0, 0)
    cell.locator("textarea").focus()
    assert bar.evaluate(OPACITY) == "1"


def test_on_touch_the_buttons_are_always_there(url, browser, outside):
    context = browser.new_context(viewport={"width": 390, "height": 800}, has_touch=True, is_mobile=True)
    page = context.new_page()
    page.goto(url)
    page.wait_for_function("() => window.Live && Live.page")
    assert set(page.locator(".live-bar").evaluate_all("bars => bars.map(e => getComputedStyle(e).opacity)")) == {"1"}
    context.close()


def test_show_all_code_opens_every_fold_and_is_remembered(site, page, outside):
    first, second = (f"{site}/{address(file)}" for file in live_pages()[:2])
    page.goto(first)
    button = page.get_by_role("button", name="Show all code")
    assert button.get_attribute("aria-pressed") == "false"
    assert not any(page.evaluate(OPEN))
    button.press("Enter")
    assert button.get_attribute("aria-pressed") == "true"
    assert all(page.evaluate(OPEN))
    page.goto(second)
    assert all(page.evaluate(OPEN))
    page.get_by_role("button", name="Show all code").click()
    page.reload()
    assert not any(page.evaluate(OPEN))


def test_prose_is_as_wide_as_it_reads_well(read):
    assert 680 <= max(read.evaluate(WIDTHS)) <= 720


def test_what_only_confirms_is_a_green_line_that_unfolds(read):
    sums = read.locator(".cell_output.confirmed summary")
    for told in sums.all_inner_texts():
        assert re.search(rf"({'|'.join(HOW)}), \d+ entr(y|ies)|\d+ checks hold", told), told
    lines = read.locator(".cell_output.confirmed").filter(has=read.locator("pre:visible"))
    assert lines.count() > 0


def test_many_confirmations_are_folded_behind_their_sum(browser, site, outside):
    page = browser.new_page()
    page.goto(f"{site}/{SUMMED}")
    whole = page.locator(".cell_output.confirmed details pre").first
    assert not whole.is_visible()
    page.locator(".cell_output.confirmed summary").first.press("Enter")
    assert whole.is_visible()
    assert len(re.findall(r"(?m)\bsame: (\d+) of \1 entries", whole.inner_text())) > 1
    page.close()


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("same: 3 of 3 entries by symbolic difference\nab: same on unit vectors: 4 of 4 entries by symbolic difference",
         "proved by computer algebra, 7 entries"),
        ("same: 0 of 2 entries by symbolic difference, 2 zero to 50 digits at 5 exact random points",
         "equal to 50 digits, 2 entries"),
        ("mean agrees: True\ncovariance agrees: True", "2 checks hold"),
        ("mean agrees: True\ncovariance agrees: False", None),
        ("there: False, and back: True", None),
        ("mean agrees: True\nlargest error: 3 px", None),
        ("", None),
    ],
)  # fmt: skip
def test_only_what_confirms_is_summed_up(said, told):
    place = importlib.util.spec_from_file_location("reading", layout.BOOK / "_ext" / "reading.py")
    module = importlib.util.module_from_spec(place)
    place.loader.exec_module(module)
    assert module.confirmation(said.splitlines()) == told


def test_a_long_listing_fades_until_it_is_asked_for(url, page, outside):
    page.goto(url)
    page.wait_for_function("() => window.Live && Live.page")
    box, button = page.locator(".cell_input.faded").first, page.locator(".all-lines").first
    lines = int(button.inner_text().split()[1])
    heights = "(e) => [e.clientHeight, e.scrollHeight]"
    editor = box.locator(".live-editor")
    shown, whole = editor.evaluate(heights)
    assert lines >= 30
    assert shown < 0.7 * whole
    page.emulate_media(media="print")
    assert len({*page.locator(".cell_input .live-editor").first.evaluate(heights)}) == 1
    page.emulate_media(media="screen")
    button.press("Enter")
    assert button.get_attribute("aria-expanded") == "true"
    assert page.locator(".all-lines").first.inner_text() == "fewer lines"


def test_few_steps_lead_to_the_first_slider(page, site, outside):
    page.goto(f"{site}/{PAGES['slam_in_five_minutes']}")
    page.wait_for_function("() => window.Live && Live.page")
    page.keyboard.press("Tab")
    assert "main content" in page.evaluate("() => document.activeElement.textContent")
    page.keyboard.press("Enter")
    steps = 1
    while not page.evaluate("() => document.activeElement.matches('figure.sweep input, figure.player input')"):
        page.keyboard.press("Tab")
        steps += 1
        assert steps <= 30
    assert page.locator(".bd-article mjx-container").count() > 50
    assert page.locator("mjx-container[tabindex='0']").count() == 0


def test_the_keyboard_reaches_a_formula_that_scrolls_and_passes_by_the_others(page, site, outside):
    page.set_viewport_size({"width": 390, "height": 800})
    loading.load(page, f"{site}/{WIDE}")
    page.wait_for_function(f"() => {FORMULAS}.some(([wide, tab]) => wide && tab === 0)", timeout=SHOWN)
    kinds = page.evaluate(f"() => {FORMULAS}")
    assert all((tab == 0) == wide for wide, tab in kinds)
    assert 0 < sum(wide for wide, _ in kinds) < len(kinds)
    page.set_viewport_size({"width": 1280, "height": 800})
    page.wait_for_function(f"() => {FORMULAS}.every(([wide, tab]) => wide === (tab === 0))", timeout=SHOWN)
    assert sum(wide for wide, _ in page.evaluate(f"() => {FORMULAS}")) < sum(wide for wide, _ in kinds)


def test_a_figure_has_a_number_which_the_text_says_and_its_caption_below_it(page, site, outside):
    page.goto(f"{site}/{PAGES['points']}")
    page.wait_for_function("() => window.Live && Live.page")
    numbers = [number.strip() for number in page.locator("figure.of-cell .caption-number").all_inner_texts()]
    chapter = numbers[0].split()[1].split(".")[0]
    assert numbers == [f"Fig. {chapter}.{i + 1}" for i in range(len(numbers))]
    said = page.locator(".bd-article a.reference[href^='#fig-']").all_inner_texts()
    assert {word.strip() for word in said} == set(numbers)
    gaps = page.locator("div.cell:has(> figure.of-cell)").evaluate_all(UNDER)
    assert len(gaps) == len(numbers)
    assert all(0 <= gap < 60 for gap in gaps), gaps
