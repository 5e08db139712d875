"""The headless Chromium of the checks and pictures."""

import contextlib
import os
import shutil
from collections.abc import Iterator
from typing import Any

from book.tools import serve

SKIPPED = 77  # exit status of what a machine without a browser cannot check
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
ARRIVED = "() => document.readyState === 'complete' && !document.querySelector('meta[http-equiv=Refresh i]')"


def browser_path() -> str | None:
    """A Chromium or Chrome of this machine."""
    named = os.environ.get("BOOK_BROWSER")
    return named or next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def load(page: Any, url: str) -> None:
    """Go to a page, and wait until all of it is there and MathJax has set its formulas; a page may lead to another."""
    page.goto(url, wait_until="load")
    page.wait_for_function(ARRIVED)
    page.wait_for_function("() => !window.MathJax?.startup || MathJax.startup.promise.then(() => true)")


@contextlib.contextmanager
def chromium(executable: str) -> Iterator[Any]:
    """A browser, for as long as the block lasts."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=executable, args=FLAGS)
        yield browser
        browser.close()


@contextlib.contextmanager
def site_in_chromium(executable: str) -> Iterator[tuple[str, Any]]:
    """The URL of the served site, and a browser; for as long as the block lasts."""
    with serve.running(serve.Server()) as base, chromium(executable) as browser:
        yield base, browser
