"""Every live cell prints in the page's own Python what it prints in the notebook; and the two Pythons agree."""

import base64
import contextlib
import io
import json
import re
import time
from typing import Any

import numpy as np
import pytest

from book.tests.site import parity
from book.tests.site.live_page import FIRST, PATIENCE, SAID, live_cells, open_page, panel, stored_text
from book.tools import layout, notebooks

RUN = "(i) => { const cell = Live.page.cells[i]; return [cell.element.dataset.ran, cell.ok]; }"
UNFOLD = """(cell) => { for (let e = cell; e; e = e.parentElement) {
  if (e.tagName === 'DETAILS') e.open = true;
  if (e.classList.contains('toggle-hidden')) e.querySelector('.toggle-button').click(); } }"""
FOLLOWED = "([i, v]) => document.querySelectorAll('figure.sweep.live')[i].dataset.position === v"
COMPUTE = """async ([code, patience]) => { let out = ''; let errors = '';
  const late = new Promise((give) => setTimeout(give, patience, { ok: false }));
  const done = await Promise.race([late, Live.page.python.run('cell parity', code, (kind, text) => {
    if (kind === 'stdout') out += text; else errors += text; }, { limit: 1e8 })]);
  return done.ok ? out : 'failed: ' + (errors || `no answer in ${patience / 1000} s`); }"""

DECODERS = 2  # grey levels between two decoders of JPEG: each may round as it likes; Chromium's and OpenCV's are one
DESK = """import base64, json
import numpy as np
from slamlib.datasets.opening import open_sequence
from slamlib.datasets.sources import open_source
from slamlib.vision.opening import camera_rig, image_run
DESK = "pictures/tum_fr1_xyz"
source, camera = open_sequence(DESK, DESK + "/camera.txt", undistort=True)
run = image_run(source.part(count=20), camera_rig(camera), rng=np.random.default_rng(1))
both = {"decoded": open_source(DESK), "undistorted": source}
told = {n: base64.b64encode(np.stack([p.image for p in s]).tobytes()).decode() for n, s in both.items()}
print(json.dumps(told | {"path": [run.path[-1][:3] for _ in run]}))"""

# What a reader sees of a figure at a glance: its shape, words, colours, and how many things are drawn.
DRAWN = """(e) => {
  const svg = e.querySelector('figure.sweep [data-frame]:not([hidden]) svg, .picture svg, figure.live svg');
  return svg && [svg.getAttribute('viewBox'), [...svg.querySelectorAll('text')].map(t => t.textContent),
    [...new Set(svg.outerHTML.match(/--figure-\\w+/g))].sort(), svg.querySelectorAll('path, image').length]; }"""
CAPTIONED = """(e) => {
  const [drawn, caption] = ['.live-output', 'figure'].map(part => e.querySelector(':scope > ' + part));
  return !caption || drawn.compareDocumentPosition(caption) === Node.DOCUMENT_POSITION_FOLLOWING; }"""
TIMED = re.compile(r"perf_counter|time\.time")  # what a clock decides is drawn differently on each run


def test_the_cells_print_what_the_notebook_has_stored_and_the_sliders_answer(
    time_left, notebook, context, site, outside, record_property
):
    if not time_left():
        pytest.skip("no time left for this page: `make test-all` tries every page")
    faults: list[str] = []
    page = open_page(context, site, notebook, faults)
    for i, cell in enumerate(live_cells(notebook)):
        if i and not time_left():
            break
        box = page.locator("div.cell.tag_live").nth(i)
        before = box.evaluate(DRAWN)  # by matplotlib's figure
        record_property("took", (run_cell(page, i), f"{notebook.stem}, cell {i + 1}"))
        status, ok = page.evaluate(RUN, i)
        assert ok, f"cell {i + 1} {status}: {page.evaluate(SAID, i)[-600:]}"
        if notebooks.FIGURE not in cell.metadata.get("tags", []):
            assert page.evaluate(SAID, i).strip() == stored_text(cell).strip(), f"cell {i + 1}"
        elif before and not TIMED.search(cell.source):
            after = page.locator("div.cell.tag_live").nth(i).locator(".live-output").evaluate(DRAWN)
            assert after == before, f"cell {i + 1} draws something else than the kernel did"
            assert box.evaluate(CAPTIONED), f"the caption of cell {i + 1} does not stand below what it draws"
    figures = page.locator("figure.sweep.live")
    for i in range(figures.count()):
        drive(page, figures.nth(i), i)
    assert faults == []


def run_cell(page: Any, i: int) -> float:
    """Run a live cell by keyboard; the seconds that a reader waits."""
    box = page.locator("div.cell.tag_live").nth(i)
    box.evaluate(UNFOLD)
    area, figure = box.locator("textarea"), box.locator("figure.sweep, .picture").count()
    start = time.monotonic()
    if figure or not area.is_visible():
        box.locator(".live-bar button").first.press("Enter")
    else:
        area.press("Shift+Enter")
    try:
        page.wait_for_function("(i) => Live.page.cells[i].element.dataset.ran", arg=i, timeout=PATIENCE)
    except Exception:
        pytest.fail(f"cell {i + 1} gave no answer in {PATIENCE / 1000:.0f} s; the panel says: {panel(page)}")
    return time.monotonic() - start


def drive(page: Any, figure: Any, i: int) -> None:
    """Move a live slider to both ends by keyboard: it answers, and draws something new."""
    slider = figure.locator("input, select")
    for key in ("Home", "End"):
        before, started = figure.locator("svg").evaluate("e => e.outerHTML"), slider.input_value()
        slider.press(key)
        place = slider.input_value()
        if place == started:
            continue  # it stands at that end already
        page.wait_for_function(FOLLOWED, arg=[i, place], timeout=PATIENCE)
        assert figure.locator("svg").evaluate("e => e.outerHTML") != before, f"live slider {i + 1}, key {key}"


def test_real_pictures_are_decoded_by_the_browser_as_by_opencv_and_give_the_same_path(context, site, outside):
    page = open_page(context, site, layout.BOOK / "chapters" / "monocular.ipynb", [])
    answer = page.evaluate(COMPUTE, [DESK, PATIENCE])
    assert not answer.startswith("failed"), answer
    there, here = io.StringIO(), json.loads(answer)
    with contextlib.chdir(layout.BOOK / "chapters"), contextlib.redirect_stdout(there):
        exec(DESK, {})
    ours = json.loads(there.getvalue())
    for name, grey_levels in (("decoded", DECODERS), ("undistorted", DECODERS + 1)):
        grey = [np.frombuffer(base64.b64decode(part[name]), np.uint8).astype(int) for part in (here, ours)]
        assert np.abs(grey[0] - grey[1]).max() <= grey_levels
    assert here["path"] == pytest.approx(np.array(ours["path"]), abs=2e-3 * np.abs(ours["path"]).max())


def test_the_two_pythons_agree_number_by_number(context, site, outside, request):
    page = open_page(context, site, FIRST, [])
    answer = page.evaluate(COMPUTE, [parity.PROGRAM.read_text("utf-8"), PATIENCE])
    assert not answer.startswith("failed"), answer
    rows, faults = parity.compare(parity.here(), json.loads(answer))
    assert faults == []
    if request.config.getoption("store_parity"):
        parity.store(rows)
    assert not parity.stale(rows), "book/appendices/parity.csv is about other models: run `make parity`"
