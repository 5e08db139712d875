"""MRPT's Kalman filter (C++) on the same update: an extra row, where MRPT and a compiler are installed.

It is the filter that the report's chapter 6 takes its results from (Blanco 2008, in the Mobile Robot Programming
Toolkit, BSD licence; Debian: libmrpt-bayes-dev). Its two methods are "naive", whole matrices, and "davison", component
by component, which predicts anew for each landmark but not for each of its three components: E16 within a landmark.
"""

import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from slambook.report.updates import Problem, State

from slamlib.errors import SlamlibError

SOURCE = Path(__file__).with_suffix(".cpp")
HEADERS = Path("/usr/include/mrpt")
LIBRARIES = "math", "system", "config", "containers", "serialization", "rtti", "core", "bayes"


@dataclass(frozen=True, eq=False)
class Corrected:
    """Result of a method of MRPT: median CPU seconds of a whole step, and the updated state."""

    seconds: float
    state: State


def available() -> bool:
    """Whether MRPT and a compiler are installed."""
    return HEADERS.is_dir() and shutil.which("g++") is not None


@contextmanager
def compiled() -> Iterator[Path]:
    """The compiled program, in a temporary folder. Raises SlamlibError."""
    if not available():
        raise SlamlibError("MRPT is not installed: apt-get install libmrpt-bayes-dev g++, or do without its row")
    with tempfile.TemporaryDirectory() as own:
        program = Path(own) / "mrpt"
        paths = [f"-I{folder}" for folder in sorted(HEADERS.glob("*/include"))]
        libraries = [f"-lmrpt-{name}" for name in LIBRARIES]
        command = ["g++", "-O2", "-std=c++17", *paths, "-I/usr/include/eigen3", str(SOURCE), "-o", str(program)]
        done = subprocess.run([*command, *libraries], capture_output=True, text=True)
        if done.returncode:
            raise SlamlibError(f"MRPT is installed, but {SOURCE.name} does not compile: {done.stderr[-500:]}")
        yield program


def run_update(program: Path, problem: Problem, repeats: int = 5) -> dict[str, Corrected]:
    """The update by MRPT's methods "naive" and "davison"; all observations must have the same variances."""
    n = len(problem.x)
    numbers = [np.array([(n - 6) / 3, len(problem.places)]), problem.x, problem.P, problem.variances[0]]
    for place, H, difference in zip(problem.places, problem.H, problem.difference, strict=True):
        numbers += [np.array([float(place)]), H[:, :6], H[:, 6:], difference]
    file = program.with_suffix(".bin")
    file.write_bytes(np.concatenate([a.ravel() for a in numbers]).astype("<f8").tobytes())
    done = subprocess.run([program, file, str(repeats)], capture_output=True, text=True, check=True)
    rows = [line.split(" ") for line in done.stdout.splitlines()]
    found = {row[0]: np.array(row[1:], dtype=float) for row in rows}
    return {name: Corrected(float(v[0]), (v[1 : n + 1], v[n + 1 :].reshape(n, n))) for name, v in found.items()}
