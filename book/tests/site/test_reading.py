"""Reading mode: folds with names, results above their code, buttons where the reader points, prose of a good width."""

from collections.abc import Iterator
from typing import Any

import pytest

from book.tests.site.live_page import address, live_pages
from book.tools import layout

PAGES = {name: address(layout.BOOK / "chapters" / f"{name}.ipynb") for name in ("points", "slam_in_five_minutes")}
OPEN = "() => [...document.querySelectorAll('details.hide.above-input')].map(e => e.open)"
OPACITY = "e => getComputedStyle(e).opacity"
BELOW = """() => [...document.querySelectorAll('div.cell:has(> details.above-input) > .cell_output:not([hidden])')]
  .filter(e => e.textContent.trim() || e.querySelector('svg'))
  .map(e => [e, e.parentElement.querySelector(':scope > details')].map(e => e.getBoundingClientRect()))
  .map(([result, fold]) => result.bottom - fold.top)"""
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
        assert kind in ("Setup", "Code", "Code of this figure", "Output"), name
        assert int(lines.split()[0]) > 1, name
    assert summaries.first.get_attribute("aria-label") is None
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
