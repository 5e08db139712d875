"""A chapter reads as well in JupyterLab, as `make lab` opens it, as it does in the page."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest

from book.tests.site.live_page import PATIENCE, SHOWN
from book.tools import layout

CHAPTERS = ("slam_in_five_minutes", "kalman_filter", "frames_and_quaternions", "points", "monocular")
OPENED = ("index", *(f"chapters/{name}" for name in CHAPTERS))
# What MyST writes, and no front end should leave in the text that is read.
RAW = re.compile(r"\$\$|`{3}|:{3}|\{[a-z-]+\}`?|\\(?:begin|frac|partial|mathcal)\b")
RENDERED = """(displayed) => !document.querySelector('.jp-MarkdownCell:not(.jp-mod-rendered)')
  && document.querySelectorAll('.jp-MarkdownCell .katex-display').length >= displayed"""
SAID = "(cells) => cells.filter(e => e.innerText).map(e => e.innerText).join('\\n')"


OPEN = """async (path) => {
  window.opened?.dispose();
  window.opened = await jupyterapp.commands.execute('docmanager:open', { path });
}"""


@pytest.fixture(scope="module")
def served(tmp_path_factory: Any) -> Iterator[str]:
    """Where JupyterLab serves a copy of the landing page and chapters, light or dark as the browser is."""
    folder = tmp_path_factory.mktemp("lab")
    settings = {
        "apputils-extension/themes": {"adaptive-theme": True},
        "apputils-extension/notification": {"fetchNews": "false", "checkForUpdates": False},
        "notebook-extension/tracker": {"windowingMode": "none"},  # else only what is on the screen is there
    }
    for name, setting in settings.items():
        file = folder / "settings" / "@jupyterlab" / f"{name}.jupyterlab-settings"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(setting), "utf-8")
    (folder / "book" / "chapters").mkdir(parents=True)
    for name in OPENED:
        shutil.copy(layout.BOOK / f"{name}.ipynb", folder / "book" / f"{name}.ipynb")
    places = {"SETTINGS": "settings", "WORKSPACES": "workspaces"}
    environment = {f"JUPYTERLAB_{name}_DIR": str(folder / place) for name, place in places.items()}
    environment["JUPYTER_RUNTIME_DIR"] = str(folder / "runtime")
    options = ["--no-browser", "--allow-root", "--port=0", f"--ServerApp.root_dir={folder / 'book'}"]
    options += ["--expose-app-in-browser"]
    with (
        (folder / "log").open("w") as log,
        subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *options], env={**os.environ, **environment}, stdout=log, stderr=log
        ) as process,
    ):
        try:
            server = running(folder / "runtime", process)
            yield f"{server['url']}lab?reset&token={server['token']}"
        finally:
            process.terminate()


def running(folder: Path, process: Any, seconds: float = 60.0) -> dict[str, Any]:
    """What a Jupyter server writes of itself once it answers."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and process.poll() is None:
        for file in folder.glob("jpserver-*.json"):
            return dict(json.loads(file.read_text("utf-8")))
        time.sleep(0.2)
    pytest.fail(f"JupyterLab does not answer: {(folder.parent / 'log').read_text('utf-8')[-2000:]}")


@pytest.fixture(scope="module")
def lab(browser: Any, served: str) -> Iterator[Any]:
    """One window of JupyterLab; it takes longer to load than its notebooks."""
    page = browser.new_page()
    page.set_default_timeout(SHOWN)
    page.goto(served, timeout=PATIENCE)
    page.wait_for_function("() => window.jupyterapp && jupyterapp.restored.then(() => true)", timeout=PATIENCE)
    yield page
    page.close()


@pytest.mark.parametrize("opened", OPENED, ids=lambda name: name.rpartition("/")[2])
def test_a_notebook_reads_well_in_jupyterlab(lab, opened):
    cells = nbformat.read(layout.BOOK / f"{opened}.ipynb", as_version=4).cells
    displayed = "\n".join(c.source for c in cells if c.cell_type == "markdown").count("$$") // 2
    folded = sum(not {"hide-input", "solution"}.isdisjoint(c.metadata.get("tags", [])) for c in cells)
    lab.evaluate(OPEN, f"{opened}.ipynb")
    lab.wait_for_selector(".jp-MarkdownCell")
    lab.wait_for_function(RENDERED, arg=displayed)
    for scheme, light in (("light", "true"), ("dark", "false")):
        lab.emulate_media(color_scheme=scheme)
        lab.wait_for_function("(light) => document.body.dataset.jpThemeLight === light", arg=light)
        assert lab.locator(".jp-MarkdownCell").count() == sum(c.cell_type == "markdown" for c in cells)
        assert RAW.findall(lab.locator(".jp-MarkdownCell").evaluate_all(SAID)) == []
        assert lab.locator(".katex-error").count() == 0
        assert lab.locator(".jp-InputPlaceholder").count() == folded > 0
