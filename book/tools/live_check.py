"""Run every live cell of the book in the page's own Python, compare what it prints, and do what readers do wrong.

`python -m book.tools.live_check` checks; with `--store` it also writes the table of the appendix on parity.
"""

import argparse
import contextlib
import json
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import nbformat

from book.tools import browser, layout, notebooks, parity, workers
from book.tools.live_page import PATIENCE, SAID, open_page, panel
from book.tools.live_readers import manners

RUN = "(i) => { const cell = Live.page.cells[i]; return [cell.element.dataset.ran, cell.ok]; }"
UNFOLD = """(cell) => { for (let e = cell; e; e = e.parentElement) {
  if (e.tagName === 'DETAILS') e.open = true;
  if (e.classList.contains('toggle-hidden')) e.querySelector('.toggle-button').click(); } }"""


@dataclass
class Done:
    """What a job has run, what it says, and what it found wrong."""

    cells: int = 0
    sliders: int = 0
    lines: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)


Job = Callable[[Any, Any, str], Done]  # of a browser, a context of it that reaches nothing else, and the site's URL


def live_cells(file: Path) -> list[Any]:
    """The notebook's cells that run in the page."""
    return [c for c in nbformat.read(file, as_version=4).cells if "live" in c.metadata.get("tags", [])]


def first_files() -> list[str]:
    """The files that the first run of a cell fetches."""
    manifest = json.loads((layout.SITE / "_static" / "live" / "manifest.json").read_text("utf-8"))
    return [*manifest["first"], *manifest["data"], "manifest.json", "pyodide.js", "worker.js"]


def stored_text(cell: Any) -> str:
    """What the notebook has stored as the text output of a cell."""
    parts = []
    for output in cell.outputs:
        parts.append(output.text if output.output_type == "stream" else output.data.get("text/plain", "") + "\n")
    return "".join(parts)


def run_all(page: Any, file: Path, faults: list[str]) -> int:
    """Run a chapter's live cells by keyboard, in order, and compare texts with the notebook; returns how many."""
    cells = live_cells(file)
    for i, cell in enumerate(cells):
        box = page.locator("div.cell.tag_live").nth(i)
        box.evaluate(UNFOLD)
        area, figure = box.locator("textarea"), box.locator("figure.sweep, .picture").count()
        if figure or not area.is_visible():
            box.locator(".live-bar button").first.press("Enter")
        else:
            area.press("Shift+Enter")
        try:
            page.wait_for_function("(i) => Live.page.cells[i].element.dataset.ran", arg=i, timeout=PATIENCE)
        except Exception:
            faults.append(f"cell {i + 1} gave no answer in {PATIENCE / 1000:.0f} s; the panel says: {panel(page)}")
            return i
        status, ok = page.evaluate(RUN, i)
        if not ok:
            faults.append(f"cell {i + 1} {status}: {page.evaluate(SAID, i)[-600:]}")
        elif notebooks.FIGURE not in cell.metadata.get("tags", []):
            said, wanted = page.evaluate(SAID, i).strip(), stored_text(cell).strip()
            if said != wanted:
                faults.append(f"cell {i + 1} prints\n{said[:1500]}\n  where the notebook has stored\n{wanted[:1500]}")
    return len(cells)


def drive_sliders(page: Any, faults: list[str]) -> int:
    """Move every live slider to both ends by keyboard; returns how many there are."""
    figures = page.locator("figure.sweep.live")
    for i in range(figures.count()):
        slider = figures.nth(i).locator("input")
        for key in ("Home", "End"):
            before, started = figures.nth(i).locator("svg").evaluate("e => e.outerHTML"), slider.input_value()
            slider.press(key)
            place = slider.input_value()
            if place == started:
                continue  # it stands at that end already
            try:
                page.wait_for_function(
                    "([i, v]) => document.querySelectorAll('figure.sweep.live')[i].dataset.position === v",
                    arg=[i, place],
                )
            except Exception:
                faults.append(f"live slider {i + 1} does not answer the key {key}")
            if figures.nth(i).locator("svg").evaluate("e => e.outerHTML") == before:
                faults.append(f"live slider {i + 1}: the key {key} draws nothing new")
    return figures.count()


def chapter(file: Path, chromium: Any, context: Any, base: str) -> Done:
    """Run a chapter's live cells in its page, and move its sliders."""
    start, done = time.perf_counter(), Done()
    page = open_page(context, base, file, done.faults)
    done.cells = run_all(page, file, done.faults)
    done.sliders = drive_sliders(page, done.faults)
    page.close()
    seconds, number = time.perf_counter() - start, len(done.faults)
    done.lines.append(
        f"  {file.stem:<36} {done.cells:>3} cells, {done.sliders} sliders, {number} faults {seconds:6.1f} s"
    )
    done.faults = [f"{file.stem}: {f}" for f in done.faults]
    return done


def readers(file: Path, chromium: Any, context: Any, base: str) -> Done:
    """Do to a page what readers and their browsers do."""
    lines, faults = manners(chromium, context, base, file)
    return Done(lines=lines, faults=faults)


def compared(file: Path, keep: bool, chromium: Any, context: Any, base: str) -> Done:
    """Compare this Python with the page's."""
    page = open_page(context, base, file, [])
    answer = page.evaluate(
        """async (code) => { let out = ''; let errors = '';
          const done = await Live.page.python.run('cell parity', code, (kind, text) => {
            if (kind === 'stdout') out += text; else errors += text; }, 1e8);
          return done.ok ? out : 'failed: ' + errors; }""",
        parity.PROGRAM.read_text("utf-8"),
    )
    page.close()
    if answer.startswith("failed"):
        return Done(faults=[answer])
    rows, faults = parity.compare(parity.here(), json.loads(answer))
    if keep and not faults:
        parity.store(rows)
    if parity.stale(rows):
        faults.append("book/appendices/parity.csv is about other models: run `make parity`")
    count = sum(int(r[1]) for r in rows)
    return Done(lines=[f"parity: {len(rows)} things computed, {count} numbers, {len(faults)} faults"], faults=faults)


@contextlib.contextmanager
def worker(executable: str) -> Iterator[Callable[[Job], Done]]:
    """What does a job, in a browser of its own that is shut off from the world."""
    with browser.site_in_chromium(executable) as (base, chromium):
        context = chromium.new_context(viewport={"width": 1280, "height": 900})
        outside = browser.shut_off(context, base)

        def does(job: Job) -> Done:
            done = job(chromium, context, base)
            done.faults += [f"asks for {url}" for url in outside]
            outside.clear()
            return done

        yield does


def jobs(files: list[Path], whole: bool, keep: bool) -> list[Job]:
    """What there is to do, long jobs first, so that no worker is left alone with one at the end."""
    pages = sorted(files, key=lambda f: -len(live_cells(f)))
    around = [partial(readers, files[0]), partial(compared, files[0], keep)] if files and whole else []
    return [*around[:1], *(partial(chapter, f) for f in pages), *around[1:]]


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if every cell prints in the page what it prints in the notebook, and readers get along."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.live_check", description=__doc__.split("\n")[0])
    parser.add_argument("--store", action="store_true", help="write the table of the appendix on parity")
    parser.add_argument("--only", default="", help="run the cells of pages whose name contains this, and nothing else")
    options = parser.parse_args(arguments)
    executable = browser.browser_path()
    if executable is None:
        return browser.without_browser("live")
    files = [f for f in layout.notebooks() if live_cells(f) and options.only in f.stem]
    found, cells, sliders = list[str](), 0, 0
    for done in workers.each(partial(worker, executable), jobs(files, not options.only, options.store)):
        for line in done.lines:
            print(line, flush=True)
        cells, sliders, found = cells + done.cells, sliders + done.sliders, [*found, *done.faults]
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"live: {cells} cells run in {len(files)} pages, {sliders} live sliders driven, {len(found)} faults")
    return 1 if found or not cells else 0


if __name__ == "__main__":
    sys.exit(main())
