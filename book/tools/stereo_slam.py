"""`python -m book.tools.stereo_slam`: the longer runs of chapter 22, stored as one small file, part by part.

The report's errors turned on together and repaired one after another, and the filter with wrong covariances
(slambook.report); slamlib's own system in the rendered stereo room (book.tools.stereo_room), and on KITTI's street,
where that is at hand (benchmarks.street). Times belong to a machine and are not stored. `--only NAME` makes one part
again and keeps the others.
"""

import argparse
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from slambook.report.findings import RUNS, SEED, ran
from slambook.report.runs import Outcome, monte_carlo
from slambook.report.scenes import SCENES, Scene
from slambook.report.switches import SWITCHES, Switch

from benchmarks import street as bench
from book.tools import layout, stereo_room
from slamlib.experiments.progress import progress
from slamlib.manifolds import Array

FILE = layout.BOOK / "chapters" / "data" / "stereo_slam.json"
# All errors that a program can have at once, in the order in which they are repaired.
ORDER = ["E20", "E16", "E05", "E10", "E15", "E08", "E19", "E18 dropped", "E07", "E02", "E01", "E12"]
FACTORS = (0.25, 0.5, 1.0, 2.0, 4.0)  # of a standard deviation, as the filter believes, to the true one


def summary(outcome: Outcome) -> dict[str, Any]:
    """NEES over its degrees of freedom and errors (second half), share of the steps inside, rounded."""
    values = outcome.ratio, outcome.inside, outcome.position, outcome.rotation
    return dict(zip(("ratio", "inside", "position", "rotation"), map(_rounded, values), strict=True))


def _rounded(value: float) -> float | str:
    return float(f"{value:.4g}") if np.isfinite(value) else str(value)


def repairs() -> dict[str, list[dict[str, Any]]]:
    """By scene, what comes of the errors that are left after each repair; the first row has all of them."""
    work = [(scene, i) for scene in ("gentle", "hard") for i in range(len(ORDER) + 1)]
    found: dict[str, list[dict[str, Any]]] = {}
    for scene, i in progress(work, len(work), "repairs"):
        done = ORDER[i - 1] if i else ""
        found.setdefault(scene, []).append({"repaired": done, **summary(ran(scene, *ORDER[i:]))})
    return found


@dataclass(frozen=True, eq=False)
class Believed(Scene):
    """A scene whose filter believes another covariance of the control: factor times the deviations."""

    factor: float = 1.0

    @property
    def U(self) -> Array:
        """As the filter believes."""
        return self.factor**2 * super().U


def tuning() -> list[dict[str, Any]]:
    """The corrected filter with deviations of the measurement, or of the control, that are wrong by a factor."""
    rows, scene = [], SCENES["gentle"]()
    for factor in progress(FACTORS, len(FACTORS), "covariances"):
        name = f"deviations times {factor:g}"
        SWITCHES[name] = Switch("(5.26)", name, {"noise": lambda s, f=factor: np.diag((f * s) ** 2)})
        measured = monte_carlo(scene, name, runs=RUNS, seed=SEED)
        del SWITCHES[name]
        moved = monte_carlo(Believed(**vars(scene), factor=factor), runs=RUNS, seed=SEED)
        rows.append({"factor": factor, "measurement": summary(measured), "control": summary(moved)})
    return rows


def street() -> dict[str, Any] | None:
    """KITTI's street, without times; None where it is not at hand: its licence forbids shipping it."""
    if not bench.KITTI.is_dir():
        return None
    found: dict[str, Any] = bench.figures()
    return _shortened(found)


def _shortened(value: Any) -> Any:
    """Plain data with rounded numbers, and without times of a machine."""
    if isinstance(value, dict):
        return {k: _shortened(v) for k, v in value.items() if k != "milliseconds"}
    if isinstance(value, list):
        return [_shortened(v) for v in value]
    return _rounded(value) if isinstance(value, float) else value


PARTS: dict[str, Callable[[], Any]] = {
    "repairs": repairs,
    "tuning": tuning,
    "ways": stereo_room.ways,
    "round": stereo_room.around,
    "light": stereo_room.light,
    "street": street,
}


def main() -> None:
    """Make the parts, and write the file when all of it is done."""
    parser = argparse.ArgumentParser(description="Make the longer runs of chapter 22 again.")
    parser.add_argument("--only", nargs="+", choices=sorted(PARTS), default=sorted(PARTS), help="these parts alone")
    given = parser.parse_args()
    made = {name: PARTS[name]() for name in given.only}
    found = json.loads(FILE.read_text("utf-8")) if FILE.is_file() else {}
    found |= {name: value for name, value in made.items() if value is not None}
    layout.store(FILE, dict(sorted(found.items())))


if __name__ == "__main__":
    main()
