"""`make stereo-slam`: store chapter stereo_ekf_slam's longer runs as one small file, part by part.

For the pages report_audited and report_experiments: the report's errors turned on together and repaired one after
another, and the filter with wrong covariances (slambook.report). For the chapter: slamlib's own system in the rendered
stereo room (stereo_room), on KITTI's street (street), and by defaults on it and on a waved rig (stereo_sequences),
beside plain OpenCV (opencv_stereo), where they are at hand.
Times belong to a machine and are not stored. `--only NAME` makes one part again and keeps the others.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from slambook import kitti_street
from slambook.report.findings import RUNS, SEED, ran
from slambook.report.runs import Outcome, monte_carlo
from slambook.report.scenes import SCENES, Scene
from slambook.report.switches import SWITCHES, Switch

from book.experiments import opencv_stereo, stereo_room, stereo_sequences, stored
from book.experiments import street as kitti
from book.tools import layout
from slamlib.experiments.progress import progress
from slamlib.manifolds import Array

FILE = layout.BOOK / "chapters" / "data" / "stereo_slam.json"
# All errors that a program can have at once, in the order in which they are repaired.
ORDER = ["E20", "E16", "E05", "E10", "E15", "E08", "E19", "E18 dropped", "E07", "E02", "E01", "E12"]
FACTORS = (0.25, 0.5, 1.0, 2.0, 4.0)  # of a standard deviation, as the filter assumes it, to the true one


def summary(outcome: Outcome) -> dict[str, Any]:
    """NEES over its degrees of freedom and errors (second half), share of the steps inside, rounded."""
    return stored.plain({n: getattr(outcome, n) for n in ("ratio", "inside", "position", "rotation")})


def repairs() -> dict[str, list[dict[str, Any]]]:
    """By scene, results with the errors that are left after each repair; the first row has all of them."""
    work = [(scene, i) for scene in ("gentle", "hard") for i in range(len(ORDER) + 1)]
    found: dict[str, list[dict[str, Any]]] = {}
    for scene, i in progress(work, len(work), "repairs"):
        done = ORDER[i - 1] if i else ""
        found.setdefault(scene, []).append({"repaired": done, **summary(ran(scene, *ORDER[i:]))})
    return found


@dataclass(frozen=True, eq=False)
class Believed(Scene):
    """A scene whose filter assumes another covariance of the control: factor times the standard deviations."""

    factor: float = 1.0

    @property
    def U(self) -> Array:
        """As the filter assumes it."""
        return self.factor**2 * super().U


def tuning() -> list[dict[str, Any]]:
    """The corrected filter with standard deviations of measurement, or of control, that are wrong by a factor."""
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
    if kitti_street.found() is None:
        return None
    return stored.plain(_without_times(kitti.figures()))


def sequences() -> dict[str, Any] | None:
    """The real sequences at hand by the command's defaults, without times; None where there is none."""
    return stored.plain(_without_times(stereo_sequences.figures())) or None


def _without_times(value: Any) -> Any:
    """Plain data without times of a machine."""
    if isinstance(value, dict):
        return {k: _without_times(v) for k, v in value.items() if k != "milliseconds"}
    return [_without_times(v) for v in value] if isinstance(value, list) else value


PARTS: dict[str, Callable[[], Any]] = {
    "beginning": lambda: stored.plain(stereo_room.beginning()),
    "light": stereo_room.light,
    "opencv": lambda: stored.plain(_without_times(opencv_stereo.at_hand(["street"]))) or None,
    "repairs": repairs,
    "round": lambda: stored.plain(stereo_room.around()),
    "sequences": sequences,
    "street": street,
    "tuning": tuning,
    "turns": lambda: stored.plain(stereo_room.turns(stereo_room.TURN_SEEDS, at_once=True)),
    "turns, other seeds": lambda: stored.plain(stereo_room.turns(stereo_room.OTHER_SEEDS)),
    "ways": stereo_room.ways,
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
