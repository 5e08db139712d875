"""What readers and their browsers do to a page with live cells: loops, broken code, lost connections, files."""

import os
import re
import subprocess
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from book.tests.site.live_page import (
    FIRST,
    PATIENCE,
    SHOWN,
    address,
    answers,
    open_page,
    panel_button,
    run_one,
    write,
)
from book.tools import build, layout, serve


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
    panel_button(page, "Forget my text").click()
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
    panel_button(page, "Restart").click()
    page.wait_for_function("() => Live.page.python.ready", timeout=PATIENCE)
    there = page.evaluate("() => Live.page.cells[0].code.text").startswith("kept = 3")
    return there and "NameError" in run_one(page, "print(kept)")


def a_deep_recursion_does_not_break_the_page(page: Any) -> bool:
    """Calls through C fill the browser's stack, which ends its Python; the next cell has a new one."""
    run_one(page, "import sys\nsys.setrecursionlimit(10**6)\ndef f(n): return sum(map(f, [n]))\nf(0)")
    said = page.locator(".live-panel").inner_text()
    return "Maximum call stack size exceeded" in said and run_one(page, "print(1 + 1)").strip() == "2"


def a_cell_runs_what_it_needs_first(page: Any) -> bool:
    """Those above that have not run as they stand, and those that an edit has put out of date."""
    panel_button(page, "Restart").click()
    write(page, "a = 1", 0)
    write(page, "b = a + 1", 1)
    first = run_one(page, "print(a + b)", 2).strip()
    write(page, "a = 10", 0)
    second = run_one(page, "print(a + b)", 2).strip()
    write(page, "a = 1 / 0", 0)
    broken = run_one(page, "print(a + b)", 2)
    told = page.evaluate("() => Live.page.cells[2].output.textContent")
    return (first, second, broken) == ("3", "21", "") and "cell 1, which it needs, did not end well" in told


def an_accepted_exercise_is_remembered(page: Any) -> bool:
    """It is ticked in the side bar, also after a reload, until the reader forgets it; a rejected one is not."""
    exercise, solution = (
        page.evaluate("(tag) => Live.page.cells.findIndex(c => c.element.matches(tag))", tag)
        for tag in (".tag_exercise", ".tag_solution")
    )
    text = page.evaluate("(i) => Live.page.cells[i].code.original", solution)
    ticks = page.locator(".bd-links .ticks")
    run_one(page, text.replace("return ", "return 7 + "), exercise)
    rejected = ticks.count()
    panel_button(page, "Restart").click()
    run_one(page, text, exercise)
    alone = not page.evaluate("() => Live.page.cells.some(c => c.ok && !c.optional)")
    accepted = ticks.all_inner_texts()
    page.reload()
    page.wait_for_function("() => window.Live && Live.page")
    kept = ticks.all_inner_texts()
    panel_button(page, "Forget my ticks").click()
    return (
        rejected == 0
        and alone
        and len(accepted) == 1
        and accepted[0].startswith("\u2713 1 of ")
        and kept == accepted
        and not ticks.count()
    )


READERS: list[Callable[[Any], bool]] = [
    typed_text_is_kept,
    an_endless_loop_is_stopped,
    broken_code_points_to_its_line,
    huge_output_is_cut,
    a_restart_keeps_the_text,
    a_deep_recursion_does_not_break_the_page,
    a_cell_runs_what_it_needs_first,
    an_accepted_exercise_is_remembered,
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
    page.goto(f"{base}/{address(file)}")
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
    page.goto(f"{base}/{address(file)}")
    page.wait_for_function("() => window.Live && Live.page")
    write(page, "print(5)")
    told = "keeps nothing" in page.locator(".live-panel").inner_text()
    ran = run_one(page, "print(5 + 1)").strip() == "6"
    page.close()
    return told and ran


def a_lost_connection(context: Any, base: str, file: Path) -> bool:
    """A download that breaks off is named; the next run fetches again and works."""
    page = context.new_page()
    page.goto(f"{base}/{address(file)}")
    page.wait_for_function("() => window.Live && Live.page")
    context.route("**/numpy.zip", lambda route: route.abort())
    page.locator("div.cell.tag_live .live-bar button").first.click()
    page.wait_for_function("() => Live.page.panel.dataset.state === 'failed'", timeout=PATIENCE)
    said = page.locator(".live-panel").inner_text()
    context.unroute("**/numpy.zip")
    again = run_one(page, "print(7)").strip() == "7"
    page.close()
    return "connection was lost while fetching numpy.zip" in said and again


def lost_pictures(context: Any, base: str, file: Path) -> bool:
    """Pictures that break off are named, the cell runs all the same, and the next run fetches them."""
    look = "import pathlib\nprint(len(list(pathlib.Path('pictures/tum_fr1_xyz').rglob('*.jpg'))))"
    page = open_page(context, base, file, [])
    context.route("**/pictures/*.zip", lambda route: route.abort())
    said = run_one(page, look)
    context.unroute("**/pictures/*.zip")
    again = run_one(page, look).strip()
    page.close()
    return "The pictures are not here: the connection was lost" in said and said.strip()[-1] == "0" and again == "100"


def under_a_prefix(chromium: Any, file: Path) -> bool:
    """The site works below any path of a host, not only at its root."""
    with serve.running(serve.Server(folder=layout.BUILD)) as base:
        return answers(chromium, f"{base}/{layout.SITE.name}/{address(file)}")


def from_the_zip(chromium: Any, file: Path) -> bool:
    """The book that a reader takes along is served by its own script, and its cells run."""
    with tempfile.TemporaryDirectory() as folder:
        with zipfile.ZipFile(layout.SITE / build.ZIP) as archive:
            archive.extractall(folder)
        script = Path(folder) / build.FOLDER / "open_the_book.py"
        with subprocess.Popen(
            [sys.executable, "-u", str(script)],
            env={**os.environ, "BROWSER": "true"},
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        ) as process:
            assert process.stdout is not None
            found = re.search(r"http://\S+/", process.stdout.readline())
            try:
                return found is not None and answers(chromium, found[0] + address(file))
            finally:
                process.terminate()


def opened_as_a_file(chromium: Any, file: Path) -> bool:
    """A page opened without any server can be read, and says what its cells need."""
    page = chromium.new_page()
    page.goto((layout.SITE / address(file)).as_uri())
    page.wait_for_function("() => window.Live && Live.page")
    page.locator("div.cell.tag_live .live-bar button").first.click()
    page.wait_for_function("() => Live.page.panel.dataset.state === 'failed'")
    said = page.locator(".live-panel").inner_text()
    figures = page.locator("figure.sweep svg").count()
    page.close()
    return "opened as a file" in said and figures > 0


def on_a_phone(chromium: Any, base: str, file: Path) -> bool:
    """With the panel open and a result shown, nothing is wider than a phone, and every button can be touched."""
    context = chromium.new_context(viewport={"width": 390, "height": 800}, has_touch=True, color_scheme="dark")
    context.set_default_timeout(SHOWN)
    page = context.new_page()
    page.goto(f"{base}/{address(file)}")
    page.wait_for_function("() => window.Live && Live.page")
    ran = run_one(page, "print('x' * 500)").strip() == "x" * 500
    wide = page.evaluate("() => document.documentElement.scrollWidth - document.documentElement.clientWidth")
    sizes = page.evaluate(
        "() => [...document.querySelectorAll('.live-bar button, .live-panel button')].filter(e => e.checkVisibility())"
        ".map(e => Math.min(e.getBoundingClientRect().width, e.getBoundingClientRect().height))"
    )
    context.close()
    return bool(ran and wide <= 0 and min(sizes) >= 24)


@pytest.fixture(scope="module")
def first() -> Path:
    """The page that all this is done to."""
    return FIRST


@pytest.fixture(scope="module")
def running(browser, site, first) -> Any:
    """One page whose Python runs: whatever a reader does to it, it answers afterwards."""
    context = browser.new_context()
    context.set_default_timeout(SHOWN)
    yield open_page(context, site, first, [])
    context.close()


@pytest.mark.parametrize("action", READERS, ids=lambda f: f.__name__)
def test_what_readers_do(action, running):
    assert run_one(running, "print('Python is there')").strip() == "Python is there"
    assert action(running)


@pytest.mark.parametrize("lacking", HANDICAPS)
def test_a_browser_that_lacks_something_says_so(lacking, context, site, first):
    assert without(context, site, first, *HANDICAPS[lacking])


@pytest.mark.parametrize("action", [without_storage, a_lost_connection, lost_pictures], ids=lambda f: f.__name__)
def test_what_happens_to_readers(action, context, site, first):
    assert action(context, site, first)


@pytest.mark.parametrize("action", [under_a_prefix, from_the_zip, opened_as_a_file], ids=lambda f: f.__name__)
def test_where_readers_have_the_book_from(action, browser, first):
    assert action(browser, first)


def test_a_phone_in_the_dark(browser, site, first):
    assert on_a_phone(browser, site, first)
