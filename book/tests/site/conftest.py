"""The built site in headless Chromium, shut off from the world: for the tests of its pages.

They run by themselves, `pytest book/tests/site` after `make book`, and not with the others (`norecursedirs`); `-k` and
`--lf` choose among them, `-n 2` runs two pages at a time. BOOK_BROWSER names a browser; where there is none they are
skipped, or fail if BOOK_BROWSER_NEEDED is set.
"""

import os
import time
from collections.abc import Callable, Iterator
from typing import Any

import playwright.sync_api
import pytest

from book.tests.site.live_page import SHOWN, address, live_cells, live_pages, most_urgent_first, shown_pages
from book.tools import browser, layout, serve

ADDED = ("index.html", "genindex.html", "search.html")  # by Sphinx


def pytest_addoption(parser: Any) -> None:
    """Options of the live pages."""
    group = parser.getgroup("site")
    group.addoption("--every-page", action="store_true", help="try all pages, changed or not")
    group.addoption("--minutes", type=float, default=float("inf"), help="begin with no live cell after that long")
    group.addoption("--store-parity", action="store_true", help="write the appendix's table of the two Pythons")


def pytest_configure(config: Any) -> None:
    """Without a browser or a site there is nothing to test."""
    # pytest-playwright's own fixture, which pytest 9 warns of
    config.addinivalue_line("filterwarnings", "ignore:Session-scoped fixtures defined as instance methods")
    if browser.browser_path() is None:
        needed = bool(os.environ.get("BOOK_BROWSER_NEEDED"))
        advice = "no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER"
        pytest.exit(advice, returncode=1 if needed else browser.SKIPPED)
    if not (layout.SITE / "index.html").is_file():
        pytest.exit("the site is not built: run `make book`", returncode=1)


def pytest_generate_tests(metafunc: Any) -> None:
    """The pages; of the live ones first those that must be tried."""
    if "notebook" in metafunc.fixturenames:
        files = most_urgent_first(live_pages(metafunc.config.getoption("every_page")))
        metafunc.parametrize("notebook", files, ids=[f.stem for f in files])
    if "name" in metafunc.fixturenames:
        names = [address(f) for f in shown_pages(metafunc.config.getoption("every_page"))]
        added = ADDED if "view" in metafunc.fixturenames else ADDED[1:]  # the first one only leads on
        metafunc.parametrize("name", [*names, *(n for n in added if (layout.SITE / n).is_file())])


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """How many live cells ran in time, and which took longest: PATIENCE must be well above it."""
    reports = [report for kind in ("passed", "failed") for report in terminalreporter.getreports(kind)]
    took = [value for report in reports for name, value in report.user_properties if name == "took"]
    if took:
        seconds, where = max(took)
        cells = sum(len(live_cells(file)) for file in live_pages())
        terminalreporter.write_line(f"live cells run: {len(took)} of {cells} (`make test-all` runs all)")
        terminalreporter.write_line(f"slowest live cell: {seconds:.1f} s ({where})")


@pytest.fixture(scope="session")
def browser_type_launch_args() -> dict[str, Any]:
    """The browser of this machine instead of one that Playwright would fetch."""
    return {"executable_path": browser.browser_path(), "args": browser.FLAGS}


@pytest.fixture(scope="session")
def site() -> Iterator[str]:
    """The URL of the served site."""
    with serve.running(serve.Server()) as base:
        yield base


@pytest.fixture(scope="session")
def start_time() -> float:
    """When the first live page was asked for, on a clock in seconds."""
    return time.monotonic()


@pytest.fixture
def time_left(start_time: float, request: Any) -> Callable[[], bool]:
    """Whether another live cell may begin: the first pages are those that must be tried."""
    return lambda: time.monotonic() - start_time <= 60 * request.config.getoption("minutes")


@pytest.fixture
def context(context: Any) -> Any:
    """The browser's context, which waits no longer than a page may take for what it shows by itself."""
    context.set_default_timeout(SHOWN)
    return context


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: Any) -> Iterator[None]:
    """What did not come in time is named with the pages that were open."""
    try:
        return (yield)
    except playwright.sync_api.TimeoutError as error:
        opened = [page.url for context in item.funcargs["browser"].contexts for page in context.pages]
        raise AssertionError(f"{', '.join(opened)}: missing: {error.message}") from error


@pytest.fixture
def outside(context: Any, site: str) -> Iterator[list[str]]:
    """What the context asks for elsewhere; it reaches nothing but the site, and a test fails if it tried."""
    asked: list[str] = []

    def inside_only(route: Any) -> None:
        if route.request.url.startswith((site, "data:", "blob:")):
            route.continue_()
        else:
            asked.append(route.request.url)
            route.abort()

    context.route("**/*", inside_only)
    yield asked
    assert not asked, "the page asks for things outside the site"
