"""Run every live cell of the book in the page's own Python, compare what it prints, and do what readers do wrong.

`python -m book.tools.live_check` checks; with `--store` it also writes the table of the appendix on parity.
"""

import argparse
import json
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import nbformat

from book.tools import browser, layout, notebooks, parity

RUN = "(i) => { const cell = Live.page.cells[i]; return [cell.element.dataset.ran, cell.ok]; }"
SAID = """(i) => [...Live.page.cells[i].output.querySelectorAll('[data-kind]')]
  .filter(e => e.dataset.kind !== 'hint').map(e => e.dataset.text ?? e.textContent).join('')"""
UNFOLD = """(cell) => { for (let e = cell; e; e = e.parentElement) {
  if (e.tagName === 'DETAILS') e.open = true;
  if (e.classList.contains('toggle-hidden')) e.querySelector('.toggle-button').click(); } }"""
PATIENCE = 60_000  # milliseconds for a cell, on a machine that does other things too


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


def open_page(context: Any, base: str, file: Path, faults: list[str]) -> Any:
    """The page of a notebook, with its errors noted."""
    page = context.new_page()
    page.on("pageerror", lambda e: faults.append(f"script error: {e}"))
    page.on("console", lambda m: faults.append(f"console: {m.text}") if m.type == "error" else None)
    page.goto(f"{base}/{file.relative_to(layout.ROOT).with_suffix('.html').as_posix()}", wait_until="load")
    page.wait_for_function("() => window.Live && Live.page")
    return page


def panel(page: Any) -> str:
    """What the panel says that Python is doing."""
    return str(page.locator(".live-panel").inner_text()).replace("\n", " ")


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
            before = figures.nth(i).locator("svg").evaluate("e => e.outerHTML")
            slider.press(key)
            place = slider.evaluate("e => e.value")
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


# -- what readers do ---------------------------------------------------------------------------------------------------


def write(page: Any, text: str, cell: int = 0) -> None:
    """Replace the text of a cell, as a reader would."""
    area = page.locator("div.cell.tag_live textarea").nth(cell)
    area.focus()
    area.press("Control+a")
    area.press("Delete")
    page.keyboard.insert_text(text)


def run_one(page: Any, text: str, cell: int = 0) -> str:
    """Write and run a cell; what it shows."""
    write(page, text, cell)
    page.evaluate("(i) => { delete Live.page.cells[i].element.dataset.ran; }", cell)
    page.locator("div.cell.tag_live textarea").nth(cell).press("Shift+Enter")
    page.wait_for_function("(i) => Live.page.cells[i].element.dataset.ran", arg=cell, timeout=PATIENCE)
    return str(page.evaluate(SAID, cell))


def typed_text_is_kept(page: Any) -> bool:
    """An edit survives a reload; Reset and Forget bring the book's text back."""
    original = page.evaluate("() => Live.page.cells[0].code.original")
    write(page, "print('mine')")
    page.reload()
    page.wait_for_function("() => window.Live && Live.page")
    kept = page.evaluate("() => Live.page.cells[0].code.text") == "print('mine')"
    page.locator("div.cell.tag_live .live-bar button", has_text="Reset").first.click()
    reset = page.evaluate("() => Live.page.cells[0].code.text") == original
    write(page, "print('again')")
    page.evaluate("() => { Live.page.panel.hidden = false; }")
    page.get_by_role("button", name="Forget my text").click()
    page.reload()
    page.wait_for_function("() => window.Live && Live.page")
    return kept and reset and page.evaluate("() => Live.page.cells[0].code.text") == original


def an_endless_loop_is_stopped(page: Any) -> bool:
    """Stop ends it, and Python is there again afterwards."""
    write(page, "while True:\n    pass")
    page.evaluate("() => { delete Live.page.cells[0].element.dataset.ran; }")
    page.locator("div.cell.tag_live textarea").first.press("Shift+Enter")
    page.wait_for_function("() => Live.page.panel.dataset.state === 'running'", timeout=PATIENCE)
    time.sleep(0.5)
    page.get_by_role("button", name="Stop").click()
    page.wait_for_function("() => Live.page.cells[0].element.dataset.ran === 'stopped'")
    return run_one(page, "print(6 * 7)").strip() == "42"


def broken_code_points_to_its_line(page: Any) -> bool:
    """The traceback names the line, and the editor marks it."""
    said = run_one(page, "a = 1\nb = a / 0\nprint('never')")
    line = page.evaluate("() => document.querySelector('.live-line')?.style.getPropertyValue('--line')")
    missing = run_one(page, "x = = 2")
    return "ZeroDivisionError" in said and "line 2" in said and line == "1" and "SyntaxError" in missing


def huge_output_is_cut(page: Any) -> bool:
    """A million lines neither freeze the page nor fill it."""
    said = run_one(page, "for i in range(1_000_000): print(i)")
    return len(said) < 110_000 and "more characters were printed" in said


def a_restart_keeps_the_text(page: Any) -> bool:
    """Restart forgets variables, not what was typed."""
    run_one(page, "kept = 3\nprint(kept)")
    page.get_by_role("button", name="Restart").click()
    page.wait_for_function("() => Live.page.python.ready", timeout=PATIENCE)
    there = page.evaluate("() => Live.page.cells[0].code.text").startswith("kept = 3")
    return there and "NameError" in run_one(page, "print(kept)")


def a_deep_recursion_does_not_break_the_page(page: Any) -> bool:
    """Either an error or a restart; Python answers afterwards."""
    run_one(page, "import sys\nsys.setrecursionlimit(10**6)\ndef f(n): return f(n + 1)\nf(0)")
    return run_one(page, "print(1 + 1)").strip() == "2"


READERS: list[Callable[[Any], bool]] = [
    typed_text_is_kept,
    an_endless_loop_is_stopped,
    broken_code_points_to_its_line,
    huge_output_is_cut,
    a_restart_keeps_the_text,
    a_deep_recursion_does_not_break_the_page,
]

BROKEN_WORKER = """window.Worker = class {
  constructor() { setTimeout(() => this.onerror(new Event('error')), 50); }
  postMessage() {}
  terminate() {} }"""
# What may be missing in a reader's browser: a script that takes it away, and a word of what the page then says.
HANDICAPS = {
    "no WebAssembly": ("delete window.WebAssembly", "WebAssembly"),
    "no workers": ("window.Worker = class { constructor() { throw new Error('forbidden'); } }", "refuses to start"),
    "a worker that fails": (BROKEN_WORKER, "cannot run here"),
}
NO_STORAGE = "Object.defineProperty(window, 'localStorage', { get() { throw new Error('forbidden'); } })"


def without(context: Any, base: str, file: Path, script: str, word: str) -> bool:
    """The page says what is missing, stays readable, and offers the notebook."""
    page = context.new_page()
    page.add_init_script(script)
    page.goto(f"{base}/{file.relative_to(layout.ROOT).with_suffix('.html').as_posix()}")
    page.wait_for_function("() => window.Live && Live.page")
    page.locator("div.cell.tag_live .live-bar button").first.click()
    page.wait_for_function("() => Live.page.panel.dataset.state === 'failed'")
    said = page.locator(".live-panel").inner_text()
    offered = page.locator(".live-panel a[href$='.ipynb']").count() == 1
    page.close()
    return word in said and offered


def without_storage(context: Any, base: str, file: Path) -> bool:
    """Cells run where nothing can be kept, and the page says so once."""
    page = context.new_page()
    page.add_init_script(NO_STORAGE)
    page.goto(f"{base}/{file.relative_to(layout.ROOT).with_suffix('.html').as_posix()}")
    page.wait_for_function("() => window.Live && Live.page")
    write(page, "print(5)")
    told = "keeps nothing" in page.locator(".live-panel").inner_text()
    ran = run_one(page, "print(5 + 1)").strip() == "6"
    page.close()
    return told and ran


def a_lost_connection(context: Any, base: str, file: Path) -> bool:
    """A download that breaks off is named; the next run fetches again and works."""
    page = context.new_page()
    page.goto(f"{base}/{file.relative_to(layout.ROOT).with_suffix('.html').as_posix()}")
    page.wait_for_function("() => window.Live && Live.page")
    context.route("**/numpy.zip", lambda route: route.abort())
    page.locator("div.cell.tag_live .live-bar button").first.click()
    page.wait_for_function("() => Live.page.panel.dataset.state === 'failed'", timeout=PATIENCE)
    said = page.locator(".live-panel").inner_text()
    context.unroute("**/numpy.zip")
    again = run_one(page, "print(7)").strip() == "7"
    page.close()
    return "connection was lost while fetching numpy.zip" in said and again


def compared(context: Any, base: str, file: Path, keep: bool) -> list[str]:
    """Faults of the comparison between this Python and the page's."""
    page = open_page(context, base, file, [])
    code = parity.PROGRAM.read_text("utf-8")
    answer = page.evaluate(
        """async (code) => { let out = ''; let errors = '';
          const done = await Live.page.python.run('cell parity', code, (kind, text) => {
            if (kind === 'stdout') out += text; else errors += text; });
          return done.ok ? out : 'failed: ' + errors; }""",
        code.replace("print(json", "import sys; sys.stdout.sent = -10**8\nprint(json"),
    )
    page.close()
    if answer.startswith("failed"):
        return [answer]
    rows, faults = parity.compare(parity.here(), json.loads(answer))
    if keep and not faults:
        parity.store(rows)
    if parity.stale(rows):
        faults.append("book/appendices/parity.csv is about other models: run `make parity`")
    print(f"parity: {len(rows)} things computed, {sum(int(r[1]) for r in rows)} numbers, {len(faults)} faults")
    return faults


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
    found, cells, sliders = [], 0, 0
    with browser.site_in_chromium(executable) as (base, chromium):
        context = chromium.new_context(viewport={"width": 1280, "height": 900})
        outside = browser.shut_off(context, base)
        for file in files:
            start, faults = time.perf_counter(), list[str]()
            page = open_page(context, base, file, faults)
            number = run_all(page, file, faults)
            moved = drive_sliders(page, faults)
            page.close()
            cells, sliders = cells + number, sliders + moved
            seconds = time.perf_counter() - start
            print(
                f"  {file.stem:<36} {number:>3} cells, {moved} sliders, {len(faults)} faults {seconds:6.1f} s",
                flush=True,
            )
            found += [f"{file.stem}: {f}" for f in faults]
        if files and not options.only:
            found += manners(context, base, files[0])
            found += compared(context, base, files[0], options.store)
        found += [f"asks for {url}" for url in outside]
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"live: {cells} cells run in {len(files)} pages, {sliders} live sliders driven, {len(found)} faults")
    return 1 if found or not cells else 0


def manners(context: Any, base: str, file: Path) -> list[str]:
    """Faults of the things that readers do, and of browsers that lack something."""
    faults: list[str] = []
    page = open_page(context, base, file, [])
    checks: dict[str, Callable[[], bool]] = {r.__name__.replace("_", " "): partial(r, page) for r in READERS}
    checks |= {name: partial(without, context, base, file, *how) for name, how in HANDICAPS.items()}
    checks["no storage"] = partial(without_storage, context, base, file)
    checks["a lost connection"] = partial(a_lost_connection, context, base, file)
    for name, action in checks.items():
        try:
            good = action()
        except Exception as error:
            good, name = False, f"{name} ({type(error).__name__}: {str(error)[:300]})"
        print(f"  {name:<60} {'ok' if good else 'FAILED'}", flush=True)
        if not good:
            faults.append(name)
    page.close()
    return faults


if __name__ == "__main__":
    sys.exit(main())
