"""Drive a page with live cells: open it, write into a cell, run it, see what it shows."""

from pathlib import Path
from typing import Any

import nbformat

from book.tools import layout

SAID = """(i) => [...Live.page.cells[i].output.querySelectorAll('[data-kind]')]
  .filter(e => e.dataset.kind !== 'hint').map(e => e.dataset.text ?? e.textContent).join('')"""
PATIENCE = 240_000  # milliseconds for a cell, on a machine that runs a second page and does other things too


def live_cells(file: Path) -> list[Any]:
    """The notebook's cells that run in the page."""
    return [c for c in nbformat.read(file, as_version=4).cells if "live" in c.metadata.get("tags", [])]


def stored_text(cell: Any) -> str:
    """What the notebook has stored as the text output of a cell."""
    parts = []
    for output in cell.outputs:
        parts.append(output.text if output.output_type == "stream" else output.data.get("text/plain", "") + "\n")
    return "".join(parts)


def address(file: Path) -> str:
    """The page of a notebook, as a path in the site."""
    return file.relative_to(layout.ROOT).with_suffix(".html").as_posix()


def open_page(context: Any, base: str, file: Path, faults: list[str]) -> Any:
    """The page of a notebook, with its errors noted."""
    page = context.new_page()
    page.on("pageerror", lambda e: faults.append(f"script error: {e}"))
    page.on("console", lambda m: faults.append(f"console: {m.text}") if m.type == "error" else None)
    page.goto(f"{base}/{address(file)}", wait_until="load")
    page.wait_for_function("() => window.Live && Live.page")
    return page


def panel(page: Any) -> str:
    """What the panel says that Python is doing."""
    return str(page.locator(".live-panel").inner_text()).replace("\n", " ")


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


def answers(chromium: Any, url: str) -> bool:
    """True if the first cell of a page computes."""
    page = chromium.new_page()
    page.goto(url)
    page.wait_for_function("() => window.Live && Live.page")
    good = run_one(page, "import slamlib\nprint(6 * 7)").strip() == "42"
    page.close()
    return good
