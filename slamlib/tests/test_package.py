"""Importing the package is light, and the package knows nothing of the book that is beside it."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import slamlib
from slamlib.cli.drawing import drawing
from slamlib.errors import SlamlibError

PACKAGE = Path(slamlib.__file__).parent
HEAVY = {"sympy", "matplotlib", "scipy", "IPython", "cv2"}


def test_importing_slamlib_loads_numpy_and_nothing_heavy():
    parts = "geometry.pose, slamlib.motions, slamlib.belief, slamlib.evaluation.consistency"
    program = f"import sys, slamlib, slamlib.{parts}; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=PACKAGE.parent
    ).stdout.split()
    assert "numpy" in loaded
    assert not HEAVY & set(loaded)


def test_no_file_of_the_package_imports_the_book_not_even_inside_a_function():
    """What the tests of the package import is not looked at."""
    sources = [file for file in PACKAGE.rglob("*.py") if file.relative_to(PACKAGE).parts[0] != "tests"]
    assert len(sources) > 100
    for file in sources:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            # by its name in a text, as `import_module` takes it
            names += [node.value] if isinstance(node, ast.Constant) and isinstance(node.value, str) else []
            assert not [name for name in names if name == "slambook" or name.startswith("slambook.")], file


def test_where_no_package_draws_the_command_says_so(monkeypatch):
    monkeypatch.setattr("slamlib.cli.drawing.entry_points", lambda group: [])
    with pytest.raises(SlamlibError, match=r"no installed package draws .* 'slamlib\.drawing'\): .*pip install -e"):
        drawing()
