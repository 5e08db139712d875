"""Pages with live cells: which ones to test; open one, write into a cell, run it, see what it shows."""

import subprocess
from pathlib import Path
from typing import Any

import nbformat

from book.tools import layout

SAID = """(i) => [...Live.page.cells[i].output.querySelectorAll('[data-kind]')]
  .filter(e => e.dataset.kind !== 'hint').map(e => e.dataset.text ?? e.textContent).join('')"""
ALWAYS = ("slam_in_five_minutes", "proving_a_jacobian", "kalman_filter", "active_search")  # one of each kind of page
FIRST = layout.BOOK / "chapters" / "slam_in_five_minutes.ipynb"  # for what is done to one chapter
BEHIND = ("slamlib/", "book/slambook/", "book/live/", "book/tools/", "book/tests/site/", "requirements.txt")
LOOKS = ("book/slambook/figures/", "book/slambook/scene/", "book/live/", "book/_", "book/tests/site/", "_config.yml")
SHOWN = 30_000  # milliseconds for what a page shows by itself, or at a click
# Milliseconds for what the page's Python does: to start it, or to run a cell. The slowest cell takes 67 s with two
# pages at a time on two hyperthreads, and 155 s beside four more processes (each run prints which one it was).
PATIENCE = 240_000


def live_cells(file: Path) -> list[Any]:
    """The notebook's cells that run in the page."""
    return [c for c in nbformat.read(file, as_version=4).cells if "live" in c.metadata.get("tags", [])]


def live_pages(every: bool = True) -> list[Path]:
    """The notebooks with live cells; unless `every`, those changed since the merge base, and four more."""
    return _chosen([file for file in layout.notebooks() if live_cells(file)], BEHIND, every)


def shown_pages(every: bool = True) -> list[Path]:
    """The sources of all pages; unless `every`, those changed since the merge base, and four more."""
    return _chosen(layout.pages(), (*LOOKS, "requirements.txt"), every)


def _chosen(files: list[Path], behind: tuple[str, ...], every: bool) -> list[Path]:
    """All of them if something behind them has changed."""
    changed = None if every else changed_files()
    if changed is None or any(name.startswith(behind) for name in changed):
        return files
    return _touched(files)


def most_urgent_first(files: list[Path]) -> list[Path]:
    """Live pages that have changed and the four, then the others; long ones first, to keep both workers busy."""
    urgent = _touched(files)
    return sorted(files, key=lambda file: (file not in urgent, -len(live_cells(file))))


def _touched(files: list[Path]) -> list[Path]:
    """Those changed since the merge base, and four more."""
    changed = changed_files() or set()
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


def panel_button(page: Any, name: str) -> Any:
    """One of the buttons behind the pill."""
    page.evaluate("() => { Live.page.panel.hidden = false; Live.page.more.open = true; }")
    return page.get_by_role("button", name=name)


def write(page: Any, text: str, cell: int = 0) -> None:
    """Replace the text of a cell, as a reader would."""
    area = page.locator("div.cell.tag_live textarea").nth(cell)
    area.evaluate("(e) => { const fold = e.closest('details'); if (fold) fold.open = true; }")
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
