"""The landing page: where to start is seen at once, the run plays and pauses as a reader wants, a cell runs there."""

from typing import Any

import nbformat
import pytest

from book.tests.site.live_page import PATIENCE, SAID, address, open_page, run_one, stored_text
from book.tools import browser, landing

PAGE = address(landing.PAGE)
WINDOWS = {"desk": {"width": 1280, "height": 800}, "phone": {"width": 390, "height": 844}}
HEAVIEST = 0.7e6  # bytes on their way to a reader who has clicked on nothing yet
PHOTOGRAPH = 120_000  # bytes at most
FRAME = "[data-player=frame]"
DRAWN = "figure => [figure.querySelector('[data-player=frame]').value, figure.querySelector('svg').innerHTML]"
PLAYED = "() => document.querySelector('.tag_plays [data-player=play]').textContent === 'Pause'"
MOVED = "(before) => document.querySelector('.tag_plays [data-player=frame]').value !== before"
FILLED = "e => { const { top, bottom, width } = e.getBoundingClientRect(); return [top, bottom, width]; }"
SCROLLED = "() => document.querySelector('#where-to-begin h2').getBoundingClientRect().top < innerHeight / 2"
ONCE = 1500  # milliseconds in which a run that starts by itself has started


def opened(context: Any, site: str, script: bool = True) -> Any:
    page = context.new_page()
    browser.load(page, f"{site}/{PAGE}") if script else page.goto(f"{site}/{PAGE}")
    return page


@pytest.fixture
def calm(browser: Any, outside: Any) -> Any:
    """The context of a reader who wants less motion."""
    context = browser.new_context(reduced_motion="reduce", viewport=WINDOWS["desk"])
    yield context
    context.close()


@pytest.mark.parametrize("window", WINDOWS)
def test_where_to_start_is_on_the_first_screen(window, browser, site):
    context = browser.new_context(viewport=WINDOWS[window])
    page = opened(context, site)
    links = page.locator(".first-links a")
    assert links.all_inner_texts() == ["Start in five minutes", "Where to begin"]
    for link in links.all():
        top, bottom, width = link.evaluate(FILLED)
        assert 0 < top < bottom <= WINDOWS[window]["height"]
        assert width > 44
    links.nth(1).click()
    page.wait_for_function(SCROLLED)
    links.nth(0).click()
    page.wait_for_url("**/chapters/slam_in_five_minutes.html", wait_until="commit")
    context.close()


def away_and_back(page: Any) -> None:
    """Scroll until the run is out of sight, and to it again."""
    for place in ("document.documentElement.scrollHeight", "0"):
        page.evaluate(f"() => scrollTo(0, {place})")
        page.wait_for_timeout(ONCE)


def test_the_run_plays_once_by_itself_and_can_be_paused(page, site, outside):
    page.set_viewport_size(WINDOWS["desk"])
    browser.load(page, f"{site}/{PAGE}")
    page.wait_for_function(PLAYED)
    away_and_back(page)  # it starts once, and a second look does not stop it
    assert page.evaluate(PLAYED)
    page.get_by_role("button", name="Play or pause").click()
    figure = page.locator(".tag_plays figure.player")
    before = figure.evaluate(DRAWN)
    away_and_back(page)
    assert figure.evaluate(DRAWN) == before
    page.get_by_role("button", name="Play or pause").click()
    page.wait_for_function(MOVED, arg=before[0])


def test_a_run_that_a_reader_has_touched_does_not_start_by_itself(browser, site):
    context = browser.new_context(viewport={"width": 390, "height": 500})  # the map is not seen whole at first
    page = opened(context, site)
    page.locator(f".tag_plays {FRAME}").press("Home")
    page.locator(".tag_plays .player-stage").scroll_into_view_if_needed()
    page.wait_for_timeout(ONCE)
    assert page.locator(f".tag_plays {FRAME}").input_value() == "0"
    context.close()


def test_nothing_moves_for_a_reader_who_wants_less_motion(calm, site):
    page = opened(calm, site)
    figure = page.locator(".tag_plays figure.player")
    before = figure.evaluate(DRAWN)
    page.wait_for_timeout(ONCE)
    assert figure.evaluate(DRAWN) == before
    assert before[0] == figure.locator(FRAME).get_attribute("max")  # the loop has closed
    assert page.evaluate("() => document.getAnimations().filter(a => a.playState === 'running').length") == 0
    assert page.locator(".bd-article img[src$='.gif']").count() == 0
    page.get_by_role("button", name="Play or pause").click()
    page.wait_for_function(PLAYED)


def test_without_script_the_run_is_a_picture_of_its_end(browser, site):
    context = browser.new_context(java_script_enabled=False)
    page = opened(context, site, script=False)
    figure = page.locator(".tag_plays figure.player")
    assert figure.locator(".player-stage svg").get_attribute("aria-label").startswith("A robot drives two laps")
    assert figure.locator(".player-stage svg path").count() > 5
    assert not figure.locator(".player-bar").first.is_visible()
    context.close()


def test_the_page_and_its_photograph_are_light(page, site, outside):
    sizes: dict[str, int] = {}
    page.on("response", lambda r: sizes.update({r.url: int(r.headers.get("content-length", 0))}))
    browser.load(page, f"{site}/{PAGE}")
    assert sum(sizes.values()) < HEAVIEST
    photographs = [size for url, size in sizes.items() if "/_images/" in url]
    assert len(photographs) == 1
    assert photographs[0] <= PHOTOGRAPH
    assert page.locator(".tag_beside .picture svg").get_attribute("aria-label").startswith("A photograph of a desk")


def test_the_cell_runs_at_a_button_that_is_seen_and_again_with_another_number(context, site, outside):
    page = open_page(context, site, landing.PAGE, [])
    cell = page.locator("div.cell.tag_try-it")
    run = cell.get_by_role("button", name="Run")
    page.mouse.move(0, 0)
    assert run.evaluate("e => getComputedStyle(e.parentElement).opacity") == "1"
    run.click()
    page.wait_for_function("() => Live.page.cells[0].element.dataset.ran", timeout=PATIENCE)
    (stored,) = (c for c in nbformat.read(landing.PAGE, as_version=4).cells if "try-it" in c.metadata.get("tags", []))
    assert page.evaluate(SAID, 0) == stored_text(stored)
    better = run_one(page, stored.source.replace("1.0**2", "0.1**2"))
    assert better.splitlines()[0].endswith(": 0.10, 0.10, 0.14")


@pytest.mark.parametrize("name_of_page", ["catalogue", "glossary"])
def test_formulas_and_words_are_one_link_away(name_of_page, page, site, outside):
    browser.load(page, f"{site}/{PAGE}")
    page.locator(f".bd-article a[href='appendices/{name_of_page}.html']").click()
    page.wait_for_url(f"**/appendices/{name_of_page}.html", wait_until="commit")
