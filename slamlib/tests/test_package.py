"""The shape of the package: what imports what, and that importing it is light."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import slamlib

PACKAGE = Path(slamlib.__file__).parent
ORDER = [
    "errors",
    "analytic",
    "spaces",
    "digest",
    "model",
    "geometry",
    "landmarks",
    "sensors",
    "motions",
    "observation",
    "slam",
]
HEAVY = {"sympy", "matplotlib", "scipy", "IPython", "cv2"}


def test_importing_slamlib_loads_numpy_and_nothing_heavy():
    parts = "geometry.pose, slamlib.motions, slamlib.belief, slamlib.evaluation"
    program = f"import sys, slamlib, slamlib.{parts}; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=PACKAGE.parent
    ).stdout.split()
    assert "numpy" in loaded
    assert not HEAVY & set(loaded)


def test_parts_load_when_they_are_named():
    assert slamlib.evaluation.__name__ == "slamlib.evaluation"
    assert "geometry" in dir(slamlib)
    with pytest.raises(AttributeError, match="slamlib has no part 'nothing'"):
        slamlib.nothing  # noqa: B018


def imports(file: Path) -> set[str]:
    """Parts of slamlib, and other top-level packages, that a file imports when it is loaded (not inside functions)."""
    found = set()
    for node in ast.parse(file.read_text("utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module] if node.module != "slamlib" else [f"slamlib.{a.name}" for a in node.names]
        elif isinstance(node, ast.Import):
            names = [a.name for a in node.names]
        else:
            continue
        found |= {n.split(".")[1] if n.startswith("slamlib.") else n.split(".")[0] for n in names}
    return found


def part(file: Path) -> str:
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


SOURCES = [f for f in sorted(PACKAGE.rglob("*.py")) if part(f) not in ("tests", "generated")]


@pytest.mark.parametrize("file", SOURCES, ids=lambda f: f.relative_to(PACKAGE).as_posix())
def test_dependencies_point_one_way(file):
    loaded, own = imports(file), part(file)
    if own not in ("codegen", "tangle"):
        assert "codegen" not in loaded, "codegen needs sympy: import it inside the function that uses it"
        assert not HEAVY & loaded, "heavy packages are imported inside the functions that use them"
    if own in ORDER:
        later = set(ORDER[ORDER.index(own) + 1 :]) - (
            {"landmarks", "sensors", "motions"} if own in ("landmarks", "sensors", "motions") else set()
        )
        assert not loaded & later
        assert not loaded & {"drawing", "exercises", "simulation", "presets"}
    if own == "belief":
        assert not loaded & {"slam", "observation", "landmarks", "sensors", "motions", "geometry"}
    if own == "simulation":
        assert "slam" not in loaded
