"""Benchmarks are commands: nothing else imports them; and each part of what they time must still be there."""

import ast
import json
import subprocess
import sys

import pytest

from book.tools import layout

FOLDERS = "slamlib", "book", "examples"


def imports_benchmarks(text):
    """Whether a module's or a cell's text imports them, wherever in it."""
    names = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names.append(node.module or "")
    return any(name.split(".")[0] == "benchmarks" for name in names)


def code(file):
    """The Python of a module or of a notebook, without lines that are for IPython."""
    text = file.read_text("utf-8")
    if file.suffix == ".py":
        return text
    cells = ("".join(cell["source"]) for cell in json.loads(text)["cells"] if cell["cell_type"] == "code")
    return "\n".join(line for cell in cells for line in cell.split("\n") if not line.lstrip().startswith(("%", "!")))


def test_nothing_outside_imports_a_benchmark():
    files = [f for folder in FOLDERS for suffix in ("py", "ipynb") for f in (layout.ROOT / folder).rglob(f"*.{suffix}")]
    found = {file.relative_to(layout.ROOT).as_posix() for file in files if imports_benchmarks(code(file))}
    assert not found, "what is shared belongs to slambook or to an experiment; a page prints what the command prints"


@pytest.mark.parametrize(
    "text",
    ["import benchmarks.slam", "from benchmarks import slam", "def late():\n    from benchmarks.slam import run"],
)
def test_every_way_to_import_one_is_seen(text):
    assert imports_benchmarks(text)
    assert not imports_benchmarks(text.replace("benchmarks", "experiments"))


def printed(*words):
    """The lines that a benchmark prints."""
    command = [sys.executable, "-m", *words]
    done = subprocess.run(command, cwd=layout.ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_the_parts_of_the_stereo_filter_are_timed():
    pytest.importorskip("cv2")
    motion = "--moving", "covariance-intersection"
    _, first, *parts, _, _ = printed("benchmarks.stereo", "--only", "speed", "--frames", "3", "--full", "20", *motion)
    assert "with 20 landmarks" in first
    assert {line[:18].strip() for line in parts} == {"control", "features", "filter", "new landmarks", "search"}


def test_the_strategies_of_an_update_agree():
    """The benchmark stops where one differs from the textbook's covariance."""
    head, *rows = printed("benchmarks.covariance_update", "--seconds", "0.01", "--sizes", "36/3", "100/10")
    assert head.split() == ["states/points", "seen", "36/3", "100/10"]
    assert [row[:34].strip() for row in rows[:3]] == [
        "dense (I - K H) P",
        "one point after another",
        "one number after another",
    ]
