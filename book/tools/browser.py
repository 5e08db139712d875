"""Open every page in headless Chromium, shut off from the world, and look for what a reader would notice."""

import contextlib
import os
import shutil
import sys
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from book.tools import layout, serve, site, workers

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
VIEWS: list[tuple[Any, int]] = [("light", 1280), ("dark", 1280), ("light", 390)]
FAULTS = """() => {
  const faults = [];
  const shown = [...document.querySelectorAll('.bd-article p, .bd-article li, .bd-article td, .bd-article dd')];
  if (shown.some(e => /\\\\\\(|\\\\\\[|\\$\\$/.test(e.innerText))) faults.push('unrendered mathematics');
  if (document.querySelector('mjx-merror, [data-mjx-error]')) faults.push('mathematics with an error');
  const asked = document.querySelectorAll('.math').length, set = document.querySelectorAll('mjx-container').length;
  if (asked && !set) faults.push('no mathematics set');
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (wide > 1) faults.push('the page is ' + wide + ' px wider than the window');
  return faults;
}"""
MOVED = """range => {
  const figure = range.closest('figure');
  const seen = [...figure.querySelectorAll('[data-frame]')].filter(e => !e.hidden).map(e => e.dataset.frame);
  return seen.length === 1 && seen[0] === range.value && figure.querySelector('output').textContent.length > 0;
}"""


def browser_path() -> str | None:
    """A Chromium or Chrome of this machine."""
    named = os.environ.get("BOOK_BROWSER")
    return named or next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def without_browser(stage: str) -> int:
    """Say that a stage is skipped for want of a browser; its exit status."""
    print(f"{stage}: skipped, no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER")
    return 1 if os.environ.get("BOOK_BROWSER_NEEDED") else 77


ARRIVED = "() => document.readyState === 'complete' && !document.querySelector('meta[http-equiv=Refresh i]')"


def load(page: Any, url: str) -> None:
    """Go to a page, and wait until all of it is there and MathJax has set its formulas; a page may lead to another."""
    page.goto(url, wait_until="load")
    page.wait_for_function(ARRIVED)
    page.evaluate("() => window.MathJax && MathJax.startup ? MathJax.startup.promise : null")


def visit(context: Any, base: str, page_name: str, faults: list[str]) -> int:
    """Open one page, note its faults, drive its sliders to both ends; returns how many sliders it has."""
    page = context.new_page()
    page.on("console", lambda m: faults.append(f"console: {m.text}") if m.type == "error" else None)
    page.on("pageerror", lambda e: faults.append(f"script error: {e}"))
    page.on("response", lambda r: faults.append(f"{r.status} {r.url}") if r.status >= 400 else None)
    load(page, f"{base}/{page_name}")
    faults += page.evaluate(FAULTS)
    sliders = page.query_selector_all("figure.sweep input[type=range]")
    for slider in sliders:
        for key in ("Home", "End", "ArrowLeft"):
            slider.focus()
            slider.press(key)
            if not slider.evaluate(MOVED):
                faults.append(f"a slider does not follow the key {key}")
    page.close()
    return len(sliders)


@contextlib.contextmanager
def site_in_chromium(executable: str) -> Iterator[tuple[str, Any]]:
    """The URL of the served site, and a browser; for as long as the block lasts."""
    from playwright.sync_api import sync_playwright

    with serve.running(serve.server()) as base, sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=executable, args=FLAGS)
        yield base, browser
        browser.close()


def shut_off(context: Any, base: str) -> list[str]:
    """Let the context reach nothing but the site; returns the list of what it asked for elsewhere, as it grows."""
    outside: list[str] = []
    context.route("**/*", lambda route: _inside_only(route, base, outside))
    return outside


@contextlib.contextmanager
def visitor(executable: str) -> Iterator[Callable[[str], tuple[int, list[str]]]]:
    """What visits a page in light and dark and at phone width; gives the number of sliders driven, and the faults."""
    with site_in_chromium(executable) as (base, browser):
        contexts = [
            browser.new_context(color_scheme=scheme, viewport={"width": width, "height": 900})
            for scheme, width in VIEWS
        ]
        asked = [shut_off(context, base) for context in contexts]

        def visits(name: str) -> tuple[int, list[str]]:
            found, sliders = [], 0
            for (scheme, width), context, outside in zip(VIEWS, contexts, asked, strict=True):
                faults: list[str] = []
                sliders += visit(context, base, name, faults)
                found += [f"{name} ({scheme}, {width} px): {f}" for f in [*faults, *(f"asks for {u}" for u in outside)]]
                outside.clear()
            return sliders, found

        yield visits


def check(pages: list[str], executable: str) -> tuple[int, list[str]]:
    """Visit all pages; returns the number of sliders driven, and the faults."""
    results = list(workers.each(partial(visitor, executable), pages))
    return sum(sliders for sliders, _ in results), [fault for _, faults in results for fault in faults]


def _inside_only(route: Any, base: str, outside: list[str]) -> None:
    if route.request.url.startswith((base, "data:", "blob:")):
        route.continue_()
    else:
        outside.append(route.request.url)
        route.abort()


def main() -> int:
    """Exit status 0 if no fault was found; without a browser, 77, or 1 where BOOK_BROWSER_NEEDED is set."""
    executable = browser_path()
    if executable is None:
        return without_browser("browser")
    pages = list(all_pages())
    sliders, found = check(pages, executable)
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"browser: {len(pages)} pages in {len(VIEWS)} views, {sliders} sliders driven, {len(found)} faults")
    return 1 if found or not pages else 0


def all_pages() -> Iterator[str]:
    """The pages of the book, and the ones that Sphinx adds."""
    yield from site.wanted()
    yield from (n for n in ("index.html", "genindex.html", "search.html") if (layout.SITE / n).is_file())


if __name__ == "__main__":
    sys.exit(main())
