"""Weights and times of the book's pages and of the Python in them, in headless Chromium, from a local server.

Run `make book` first, then `python -m benchmarks.page`. Text is compressed, as static hosts do; each page is opened in
a fresh profile, so that nothing comes from a cache.
"""

import json
import statistics
import sys
from typing import Any

from book.tools import browser, layout, site

TRANSFERRED = """() => {
  const entries = ['navigation', 'resource'].flatMap((kind) => performance.getEntriesByType(kind));
  return ['transferSize', 'decodedBodySize'].map((size) => entries.reduce((sum, e) => sum + e[size], 0)); }"""
PAINTED = "() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN"
LOADED = "() => performance.getEntriesByType('navigation')[0].loadEventEnd"
WARM = """async () => { const times = [];
  for (let i = 0; i < 20; i++) { const began = performance.now();
    const done = await Live.page.python.run('cell warm', 'sum(range(1000))', () => {});
    times.push(performance.now() - began - done.milliseconds); }
  return times; }"""
START = """async () => {
  await Live.page.python.run('cell first', 'import slamlib', () => {});
  return Live.page.python.readyAfter; }"""
SYMPY = """async () => {
  const done = await Live.page.python.run('cell sympy', 'import sympy; sympy.sqrt(2)', () => {});
  return done.milliseconds / 1000; }"""


def open_fresh(chromium: Any, base: str, name: str) -> Any:
    """A page in a profile of its own, loaded with its mathematics set."""
    page = chromium.new_context(viewport={"width": 1280, "height": 900}).new_page()
    browser.load(page, f"{base}/{name}")
    return page


def first_files() -> list[str]:
    """The files that the first run of a cell fetches."""
    manifest = json.loads((layout.SITE / "_static" / "live" / "manifest.json").read_text("utf-8"))
    return [*manifest["first"], *manifest["data"], "manifest.json", "pyodide.js", "worker.js"]


def main() -> int:
    """Print the figures."""
    executable = browser.browser_path()
    if executable is None:
        print("benchmark: skipped, no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER")
        return 1
    with browser.site_in_chromium(executable) as (base, chromium):
        print(f"{'page':<42} {'sent':>8} {'unpacked':>9} {'readable':>9} {'loaded':>8}")
        for name in site.wanted():
            page = open_fresh(chromium, base, name)
            sent, unpacked = page.evaluate(TRANSFERRED)
            times = f"{page.evaluate(PAINTED):>6.0f} ms {page.evaluate(LOADED):>5.0f} ms"
            print(f"{name.removeprefix('book/'):<42} {sent / 1e6:>5.2f} MB {unpacked / 1e6:>6.2f} MB {times}")
            page.context.close()
        file = next(f for f in layout.notebooks() if '"live"' in f.read_text("utf-8"))  # the tag of a cell
        name = file.relative_to(layout.ROOT).with_suffix(".html").as_posix()
        ready, warm, sympy = [], [], []
        for _ in range(3):
            page = open_fresh(chromium, base, name)
            ready.append(page.evaluate(START))
            warm += page.evaluate(WARM)
            sympy.append(page.evaluate(SYMPY))
            page.context.close()
    weight = sum((layout.SITE / "_static" / "live" / n).stat().st_size for n in first_files())
    later = (layout.SITE / "_static" / "live" / "sympy.zip").stat().st_size
    print(f"Python in the page: {weight / 1e6:.2f} MB at the first run, {later / 1e6:.2f} MB more for SymPy")
    print(
        f"ready after {statistics.median(ready):.1f} s, first SymPy result after {statistics.median(sympy):.1f} s more"
    )
    print(f"a warm cell costs {statistics.median(warm):.1f} ms beyond its own computation (median of {len(warm)})")
    return 0


if __name__ == "__main__":
    sys.exit(main())
