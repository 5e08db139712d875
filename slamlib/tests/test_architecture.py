"""The acceptance test of the architecture: a type is one written file and one generated file, and nothing else changes.

Chapter your_own_model's cells with a landmark and a sensor of the reader's own are written into a scratch copy of the
package, as the chapter asks the reader to do.
"""

import ast
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Collection, Iterable
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import slamlib
from slamlib.codegen import __main__ as command
from slamlib.errors import UnknownNameError

PACKAGE = Path(slamlib.__file__).parent
CHAPTER = PACKAGE.parent / "book" / "chapters" / "your_own_model.ipynb"
OWN = {  # tag of the cell, where the chapter puts it, the name of the type
    "own-landmark": ("landmarks/parallax_point.py", "parPnt"),
    "own-sensor": ("sensors/doppler_sonar.py", "dopplerSonar"),
}


def cell(tag: str) -> str:
    """The one cell of chapter your_own_model that has a tag."""
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
    """What a Python prints that knows the package in this folder only; pytest loads none of the installed plugins."""
    call, plain = [sys.executable, "-B", *arguments], {**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    run = subprocess.run(call, cwd=folder, env=plain, capture_output=True, text=True, timeout=300)
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
    # and the tests of every type judge it without any change to them
    printed = python(
        tmp_path, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", name, "slamlib/tests/test_every_type.py"
    )
    passed = int(printed.split(" passed")[0].split()[-1])
    assert passed >= 4  # itself, and each pair that it is in


# A run with planes, in the scratch copy: records, simulation, filter, snapshot, recording and checkpoint know them.
WITH_PLANES = """
import numpy as np
from slamlib.records.inputs import Features, World
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.observation import FAMILIES
from slamlib.simulation import load, save, simulate
from slamlib.slam import Options, Slam

assert set(FAMILIES) == {"planes", "points", "segments"}
feet = np.array([[3.0, 0, 0], [0, 4, 0], [0, 0, -2], [-5, 1, 0]])
world = World({"planes": Features(np.arange(4), feet), "points": Features(np.arange(4, 8), feet + 0.5)})
robot = RobotSetup(control=(0.05, 0, 0, 0, 0, 1.0), control_std=(0.01,) * 3 + (0.2,) * 3)
rig = Rig((robot,), (SensorSetup(type="relativePosition", euler=(0.0, 0.0, 0.0), std=(0.02,)),))
options = Options(points="eucPnt", others={"planes": "footPln"}, error="world")
slam, rng = Slam(rig, options=options), np.random.default_rng(1)
run = list(simulate(rig, world, frames=60, dt=0.1, rng=rng))
nis = []
for frame, truth in run:
    slam.step(frame)
    nis += [p.nis for p in slam.predictions[0] if p.inlier and p.family.name == "planes"]
shown = slam.snapshot()
assert len(shown.points.ids) == len(shown.landmarks["planes"].ids) == 4
planes = shown.landmarks["planes"]
error = planes.geometry - feet[planes.ids]
assert np.abs(error).max() < 0.3 and 2.5 < np.mean(nis) < 3.5, (error, np.mean(nis))
assert np.linalg.norm(slam.robots[0].pose[:3] - truth.robots[0][:3]) < 0.2
slam.save("slam.npz")
again = Slam.load("slam.npz")
assert np.array_equal(again.belief.matrix, slam.belief.matrix)
save("run.npz", run, rig=rig, world=world)
assert np.array_equal(load("run.npz").frames[7].scans[0].of("planes").values, run[7][0].scans[0].of("planes").values)
print("planes", len(nis))
"""


def test_a_new_family_is_one_written_and_one_generated_file(tmp_path):
    path, copy = "observation/planes.py", tmp_path / "slamlib"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", ".*_cache"))
    before = contents(copy)
    shutil.copyfile(PACKAGE / "tests" / "planes.py", copy / path)
    python(tmp_path, "-m", "slamlib.codegen", path)
    after = contents(copy)
    assert {f for f in after | before if after.get(f) != before.get(f)} - {"generated/observation/__init__.py"} == {
        path,
        f"generated/{path}",
    }
    assert python(tmp_path, "-c", WITH_PLANES).startswith("planes")


def test_only_the_named_modules_are_generated_and_nothing_is_removed(tmp_path):
    (tmp_path / "left_over.py").write_text("")
    assert command.write(tmp_path, ["geometry/polar.py"]) == 3
    found = set(command.texts(tmp_path))
    assert found == {"__init__.py", "geometry/__init__.py", "geometry/polar.py", "left_over.py"}
    committed = PACKAGE / "generated" / "geometry" / "polar.py"
    assert (tmp_path / "geometry" / "polar.py").read_text() == committed.read_text()
    with pytest.raises(UnknownNameError, match=r"did you mean 'geometry/polar\.py'"):
        command.write(tmp_path, ["geometry/poler.py"])


# -- who may know whom: the import contract ----------------------------------------------------------------------------

LAYERS = [  # each may import those above it, and itself
    {"errors"},
    {"plain_data"},
    {"symbolic"},
    {"analytic", "manifolds"},
    {"models"},
    {"registry"},
    {"kalman"},
    {"belief"},
    {"geometry"},
    {"landmarks", "sensors", "motions"},
    {"records", "rigs"},
    {"entities"},
    {"observation"},
    {"evaluation"},
    {"slam", "simulation", "checks"},
    {"experiments", "datasets"},
    {"vision"},
    {"cli", "codegen"},
]
NEVER = {  # beyond the layers: the algebra knows no types, simulator and filter meet only in records
    "kalman": {"models", "analytic"},
    "belief": {"models", "analytic"},
    "simulation": {"slam"},
    "slam": {"simulation"},
    "checks": {"slam", "simulation"},
    "datasets": {"slam", "experiments"},
}
LAZY = {"codegen": {"sympy", "IPython"}, "symbolic": {"sympy"}}  # heavy packages that a part may load with itself
HEAVY = {"sympy", "matplotlib", "scipy", "IPython", "cv2", "skimage", "joblib"}


def imports(nodes: Iterable[ast.AST]) -> set[str]:
    """Parts of slamlib, and other top-level packages, that these statements import."""
    found = set()
    for node in nodes:
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module] if node.module != "slamlib" else [f"slamlib.{a.name}" for a in node.names]
        elif isinstance(node, ast.Import):
            names = [a.name for a in node.names]
        else:
            continue
        found |= {n.split(".")[1] if n.startswith("slamlib.") else n.split(".")[0] for n in names}
    return found


def part(file: Path) -> str:
    """The part of the package to which a file belongs: a folder, or a module at the root."""
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


PARTS = {name for layer in LAYERS for name in layer}
SOURCES = [f for f in sorted(PACKAGE.rglob("*.py")) if part(f) not in ("tests", "generated", "__init__", "__main__")]


def files(name: str) -> list[Path]:
    """The source files of a part."""
    return [f for f in SOURCES if part(f) == name]


def test_every_part_has_its_layer():
    assert {part(f) for f in SOURCES} == PARTS
    assert {f.stem for f in SOURCES if len(f.relative_to(PACKAGE).parts) == 1} == {
        "errors", "symbolic", "analytic", "manifolds", "registry", "belief"
    }  # fmt: skip


@pytest.mark.parametrize("height", range(len(LAYERS)))
def test_a_layer_knows_only_those_below_it(height):
    below = set().union(*LAYERS[:height])
    for name in LAYERS[height]:
        beside = LAYERS[height] if "landmarks" in LAYERS[height] else {name}  # types may know their neighbours
        allowed = (below | beside) - NEVER.get(name, set())
        for file in files(name):
            tree = ast.parse(file.read_text("utf-8"))
            assert imports(ast.walk(tree)) & PARTS <= allowed, file  # under TYPE_CHECKING and inside functions, too
            loaded = imports(tree.body)
            assert not loaded & ({"slambook", "book", "benchmarks"} | HEAVY - LAZY.get(name, set())), file


def test_models_name_their_compiler_in_one_string_and_import_none():
    named = {}
    for file in files("models"):
        tree = ast.walk(ast.parse(file.read_text("utf-8")))
        strings = [node.value for node in tree if isinstance(node, ast.Constant) and isinstance(node.value, str)]
        named[file.name] = sum(text.startswith("slamlib.codegen") for text in strings)
    assert {name: count for name, count in named.items() if count} == {"compiler.py": 1}


def test_no_circle_of_files():
    """Every import counts: those under TYPE_CHECKING, and those inside functions."""
    files_of = {"slamlib." + ".".join(f.relative_to(PACKAGE).with_suffix("").parts): f for f in SOURCES}
    TopologicalSorter({name: imported(f, files_of) for name, f in files_of.items()}).prepare()  # raises CycleError


def imported(file: Path, known: Collection[str]) -> set[str]:
    """The modules among the known ones that a file imports anywhere; a name of a package counts as its __init__."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            whole = [f"{node.module}.{alias.name}" for alias in node.names]
            found |= {name if name in known else node.module for name in whole}
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return {name for name in found | {f"{name}.__init__" for name in found} if name in known}


@pytest.mark.parametrize("folder", ["benchmarks", "book/tools", "book/experiments", "book/live", "book/slambook"])
def test_the_book_and_the_benchmarks_import_no_tests(folder):
    for file in (PACKAGE.parent / folder).rglob("*.py"):
        assert not re.search(r"^\s*(from|import) (slamlib|book)\.tests", file.read_text("utf-8"), re.M), file


def test_no_type_is_named_outside_its_own_file():
    """No switch statement: what runs the filter must not ask for the type. The defaults of options may name one."""
    from slamlib.landmarks import LINES, POINTS
    from slamlib.sensors import SENSORS

    names = {*POINTS, *LINES, *SENSORS}
    for part in ("observation", "belief", "kalman", "checks", "models"):
        for file in files(part):
            tree = ast.parse(file.read_text("utf-8"))
            tree.body = [n for n in tree.body if not (isinstance(n, ast.ClassDef) and n.name.endswith("Options"))]
            strings = {n.value for n in ast.walk(tree) if isinstance(n, ast.Constant)}
            assert not strings & names, file
