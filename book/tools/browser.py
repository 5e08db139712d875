"""The headless Chromium of the checks and pictures, and the pages of the site that they open."""

import contextlib
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat

from book.tools import layout, serve, site

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
ALWAYS = ("slam_in_five_minutes", "proving_a_jacobian", "ekf_slam", "active_search")  # one of each kind of page
BEHIND = ("slamlib/", "book/slambook/", "book/live/", "book/tools/", "book/tests/site/", "requirements.txt")


def browser_path() -> str | None:
    """A Chromium or Chrome of this machine."""
    named = os.environ.get("BOOK_BROWSER")
    return named or next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def load(page: Any, url: str) -> None:
    """Go to a page, and wait until all of it is there and MathJax has set its formulas; a page may lead to another."""
    page.goto(url, wait_until="load")
    page.wait_for_function(ARRIVED)
    page.evaluate("() => window.MathJax && MathJax.startup ? MathJax.startup.promise : null")


@contextlib.contextmanager
def site_in_chromium(executable: str) -> Iterator[tuple[str, Any]]:
    """The URL of the served site, and a browser; for as long as the block lasts."""
    from playwright.sync_api import sync_playwright

    with serve.running(serve.server()) as base, sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=executable, args=FLAGS)
        yield base, browser
        browser.close()


def all_pages() -> Iterator[str]:
    """The pages of the book, and the ones that Sphinx adds."""
    yield from site.wanted()
    yield from (n for n in ("index.html", "genindex.html", "search.html") if (layout.SITE / n).is_file())


def live_pages(every: bool = True) -> list[Path]:
    """The notebooks with live cells; unless `every`, those changed since the merge base, and four more."""
    cells = {file: nbformat.read(file, as_version=4).cells for file in layout.notebooks()}
    files = [file for file in cells if any("live" in cell.metadata.get("tags", []) for cell in cells[file])]
    changed = None if every else changed_files()
    if changed is None or any(name.startswith(BEHIND) for name in changed):
        return files
    return [f for f in files if f.stem in ALWAYS or f.relative_to(layout.ROOT).as_posix() in changed]


def changed_files() -> set[str] | None:
    """What differs from where this branch left main, or on main from the commit before; None if git can't say."""
    base = _git("merge-base", "HEAD", "origin/main")
    if base is None or base == _git("rev-parse", "HEAD"):
        base = _git("rev-parse", "HEAD~1")
    changed = _git("diff", "--name-only", base) if base else None
    return None if changed is None else set(changed.splitlines())


def _git(*words: str) -> str | None:
    run = subprocess.run(["git", *words], cwd=layout.ROOT, capture_output=True, text=True)
    return run.stdout.strip() if run.returncode == 0 else None
