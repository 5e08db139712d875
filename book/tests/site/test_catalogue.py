"""The catalogue of Jacobians: its contents lead to every model, and a field shows only those that are wanted."""

from collections.abc import Iterator
from typing import Any

import pytest

from book.tests.site.live_page import PATIENCE, address
from book.tools import browser as loading
from book.tools import layout

PAGE = address(layout.BOOK / "appendices" / "catalogue.ipynb")
FIELD = "Show only models whose name or module contains"
SEEN = "(headings) => headings.filter(e => e.checkVisibility()).map(e => e.textContent)"
MODELS, CHAINS = "#models h3[id]", "#common-chains h3[id]"


@pytest.fixture(scope="module")
def opened(site: str, browser: Any) -> Iterator[Any]:
    """The page, in a window of its own."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(PATIENCE)  # a browser beside others sets its thousand formulas slowly
    loading.load(page, f"{site}/{PAGE}")
    yield page
    page.close()


@pytest.fixture
def catalogue(opened: Any, site: str) -> Any:
    """The page with an empty field."""
    opened.get_by_label(FIELD).fill("")
    return opened


def seen(page: Any, headings: str) -> list[str]:
    """The headings that a reader sees."""
    return [str(text) for text in page.locator(headings).evaluate_all(SEEN)]


def count(page: Any) -> str:
    """How many models the page says are shown."""
    return str(page.get_by_role("status").inner_text())


def test_every_link_of_the_contents_leads_to_the_heading_that_it_names(catalogue):
    links = catalogue.locator("#contents li a").evaluate_all(
        "(all) => all.map(a => [a.textContent, document.querySelector('h3' + a.hash)?.textContent ?? ''])"
    )
    assert len(links) == catalogue.locator(MODELS).count() + catalogue.locator(CHAINS).count() > 90
    for words, heading in links:
        assert heading.endswith(f".{words}") or heading.startswith(f"{words} "), (words, heading)


def test_only_what_contains_the_words_is_shown_and_counted(catalogue):
    every = seen(catalogue, MODELS)
    assert count(catalogue) == f"{len(every)} models"
    catalogue.get_by_label(FIELD).fill("pinhole")
    wanted = [name for name in every if "pinhole" in name]
    assert 3 < len(wanted) < 10
    assert seen(catalogue, MODELS) == wanted
    assert seen(catalogue, CHAINS) == []
    assert count(catalogue) == f"{len(wanted)} of {len(every)} models"
    assert seen(catalogue, "#contents li a") == [name.rsplit(".", 1)[1] for name in wanted]
    formulas = catalogue.locator("#models mjx-container").evaluate_all("(all) => all.map(e => e.checkVisibility())")
    assert 0 < sum(formulas) < 0.2 * len(formulas)
    catalogue.get_by_label(FIELD).fill("LANDMARKS to frame")
    assert {name.rsplit(".", 1)[1] for name in seen(catalogue, MODELS)} == {"to_frame"}
    catalogue.get_by_label(FIELD).fill("ahmPnt")
    assert seen(catalogue, CHAINS) == ["ahmPnt through the pin-hole camera"]
    catalogue.get_by_label(FIELD).fill("no such model")
    assert count(catalogue) == f"0 of {len(every)} models"


@pytest.mark.parametrize("empty", ["emptied", "Escape"])
def test_an_empty_field_shows_all(catalogue, empty):
    everything = seen(catalogue, f"{MODELS}, {CHAINS}, #contents li a")
    field = catalogue.get_by_label(FIELD)
    field.fill("stereo")
    assert seen(catalogue, f"{MODELS}, {CHAINS}, #contents li a") != everything
    if empty == "Escape":
        field.press("Escape")
    else:
        field.fill("")
    assert field.input_value() == ""
    assert seen(catalogue, f"{MODELS}, {CHAINS}, #contents li a") == everything
    assert catalogue.locator(".filtered-out").count() == 0


@pytest.mark.parametrize("by", ["hash", "link"])
def test_a_link_into_what_is_left_out_shows_it(catalogue, by):
    catalogue.get_by_label(FIELD).fill("pinhole")
    target = catalogue.locator("#motions-odometry-step")
    assert not target.is_visible()
    if by == "hash":
        catalogue.evaluate("() => { location.hash = '#motions-odometry-step'; }")
    else:  # also when the address has it already
        catalogue.evaluate("""() => {
          const link = Object.assign(document.createElement('a'), { href: '#motions-odometry-step', textContent: 'x' });
          document.querySelector('h1').append(link);
          link.click();
          link.remove();
        }""")
    target.wait_for(state="visible")
    catalogue.wait_for_function("() => Math.abs(document.querySelector('#motions-odometry-step')"
                                ".getBoundingClientRect().top) < innerHeight")  # fmt: skip
    assert catalogue.get_by_label(FIELD).input_value() == ""
    assert count(catalogue) == f"{len(seen(catalogue, MODELS))} models"


def test_all_models_are_printed_and_the_field_is_not(catalogue):
    every = seen(catalogue, MODELS)
    catalogue.get_by_label(FIELD).fill("pinhole")
    catalogue.emulate_media(media="print")
    printed = seen(catalogue, MODELS)
    field = catalogue.locator("#catalogue-filter").is_visible()
    catalogue.emulate_media(media="screen")
    assert printed == every
    assert not field


def test_a_chain_is_seen_whole_on_one_screen(catalogue):
    heights = catalogue.evaluate("""() => {
      const titles = [...document.querySelectorAll('#common-chains h3')];
      return titles.map((title) => {
        let last = title;
        while (last.nextElementSibling && !last.nextElementSibling.matches('h3')) last = last.nextElementSibling;
        return last.getBoundingClientRect().bottom - title.getBoundingClientRect().top;
      });
    }""")
    header = catalogue.locator(".bd-header-article").bounding_box()["height"]
    assert len(heights) == 4
    assert max(heights) <= 800 - header
    wide = catalogue.locator("#common-chains div.math").evaluate_all(
        "(all) => all.filter(e => e.scrollWidth > e.clientWidth + 1)"
    )
    assert wide == []


def test_without_a_script_all_is_there_and_there_is_no_field(site, browser):
    page = browser.new_page(java_script_enabled=False)
    page.goto(f"{site}/{PAGE}")
    assert page.get_by_label(FIELD).count() == 0
    hidden = page.locator(MODELS).evaluate_all("(all) => all.filter(e => !e.checkVisibility()).length")
    assert hidden == 0
    page.close()


def test_other_pages_have_no_field(site, page, outside):
    page.goto(f"{site}/{address(layout.BOOK / 'appendices' / 'conventions.ipynb')}")
    page.wait_for_load_state("load")
    assert page.locator(".catalogue-filter, .filtered-out").count() == 0
