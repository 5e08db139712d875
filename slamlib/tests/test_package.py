"""Importing the package is light."""

import subprocess
import sys
from pathlib import Path

import slamlib

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
