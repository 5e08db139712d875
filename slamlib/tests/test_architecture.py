"""The acceptance test of the architecture: a type is one written file and one generated file, and nothing else changes.

Chapter 13's cells with a landmark and a sensor of the reader's own are written into a scratch copy of the package, as
the chapter tells the reader to do.
"""

import ast
import hashlib
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import slamlib
from slamlib.codegen import __main__ as command
from slamlib.errors import UnknownNameError

PACKAGE = Path(slamlib.__file__).parent
CHAPTER = PACKAGE.parent / "book" / "chapters" / "13_your_own_model.ipynb"
OWN = {  # tag of the cell, where the chapter puts it, the name of the type
    "own-landmark": ("landmarks/parallax_point.py", "parPnt"),
    "own-sensor": ("sensors/doppler_sonar.py", "dopplerSonar"),
}


def cell(tag: str) -> str:
    """The one cell of chapter 13 that has a tag."""
    if not CHAPTER.is_file():
        pytest.skip("the book is not beside the package")
    cells = json.loads(CHAPTER.read_text("utf-8"))["cells"]
    (source,) = ("".join(c["source"]) for c in cells if tag in c["metadata"].get("tags", []))
    return source + "\n"


def contents(folder: Path) -> dict[str, str]:
    """A digest of every file."""
    files = (f for f in folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
    return {f.relative_to(folder).as_posix(): hashlib.sha256(f.read_bytes()).hexdigest() for f in files}


def python(folder: Path, *arguments: str) -> str:
    """What a Python prints that knows the package in this folder only."""
    call = [sys.executable, "-B", *arguments]
    run = subprocess.run(call, cwd=folder, capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    return run.stdout


@pytest.mark.parametrize("tag", OWN)
def test_a_new_type_is_one_written_and_one_generated_file(tag, tmp_path):
    path, name = OWN[tag]
    copy = tmp_path / "slamlib"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", ".*_cache"))
    before = contents(copy)
    (copy / path).write_text(cell(tag), encoding="utf-8")
    python(tmp_path, "-m", "slamlib.codegen", path)
    after = contents(copy)
    changed = {f for f in after | before if after.get(f) != before.get(f)}
    assert changed == {path, f"generated/{path}"}
    # and the tests of every type judge it without having been told of it
    printed = python(
        tmp_path, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", name, "slamlib/tests/test_every_type.py"
    )
    passed = int(printed.split(" passed")[0].split()[-1])
    assert passed >= 4  # itself, and each pair that it is in


def test_only_the_named_modules_are_generated_and_nothing_is_removed(tmp_path):
    (tmp_path / "left_over.py").write_text("")
    assert command.write(tmp_path, ["geometry/polar.py"]) == 3
    found = command.existing(tmp_path)
    assert found == {"__init__.py", "geometry/__init__.py", "geometry/polar.py", "left_over.py"}
    committed = PACKAGE / "generated" / "geometry" / "polar.py"
    assert (tmp_path / "geometry" / "polar.py").read_text() == committed.read_text()
    with pytest.raises(UnknownNameError, match=r"did you mean 'geometry/polar\.py'"):
        command.write(tmp_path, ["geometry/poler.py"])


# -- who may know whom -------------------------------------------------------------------------------------------------

LAYERS = [  # each may import those above it, and itself
    {"errors", "analytic", "spaces", "digest"},
    {"model", "kernel", "shortened", "linalg", "small"},
    {"geometry", "implicit", "registry"},
    {"landmarks", "sensors", "motions"},
    {"observation", "line_observation"},
]
CORE = {"errors", "spaces", "linalg", "small", "blocks", "correction", "series"}  # all that the belief may know


def imports(file: Path) -> set[str]:
    """Parts of slamlib that a file imports when it is loaded."""
    found = set()
    for node in ast.parse(file.read_text("utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module == "slamlib":
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("slamlib."):
            found.add(node.module.split(".")[1])
        elif isinstance(node, ast.Import):
            found |= {a.name.split(".")[1] for a in node.names if a.name.startswith("slamlib.")}
    return found


def files(part: str) -> list[Path]:
    """The source of a part: a module, or the modules of a folder."""
    single = PACKAGE / f"{part}.py"
    return [single] if single.is_file() else sorted((PACKAGE / part).rglob("*.py"))


@pytest.mark.parametrize("height", range(len(LAYERS)))
def test_a_layer_knows_only_those_below_it(height):
    allowed = set().union(*LAYERS[: height + 1])
    for part in LAYERS[height]:
        for file in files(part):
            assert imports(file) <= allowed, file


def test_the_belief_knows_nothing_of_landmarks_and_sensors():
    for part in ("belief", "blocks", "correction"):
        assert imports(PACKAGE / f"{part}.py") <= CORE


def test_no_type_is_named_outside_its_own_file():
    """No switch statement: what runs the filter must not ask for the type."""
    from slamlib.landmarks import LINES, POINTS
    from slamlib.sensors import SENSORS

    names = {*POINTS, *LINES, *SENSORS}
    for part in ("observation", "line_observation", "belief", "correction", "checks", "implicit", "registry"):
        for file in files(part):
            strings = {n.value for n in ast.walk(ast.parse(file.read_text("utf-8"))) if isinstance(n, ast.Constant)}
            assert not strings & names, file
