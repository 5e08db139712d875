"""`make other-filters`: run chapter other_filters's comparison of FastSLAM 1.0 and 2.0 with EKF-SLAM, and store it.

Three scanners, each with two sets of seeds; beside the filters all data at once, by the chapter's functions. "first"
has the first runs one by one, which chapter and test make again. Times are ratios to the EKF's, compared with nothing.
"""

import json
from collections.abc import Callable
from contextlib import redirect_stdout
from functools import cache, partial
from io import StringIO
from typing import Any

import numpy as np
from slambook.report.fastslam import FastSlam, FastSlam2
from slambook.report.planar import SCANNERS
from slambook.report.planar_ekf import PlanarEkf
from slambook.report.planar_runs import Contestant, compare

from book.experiments import stored
from book.tools import layout

FILE = layout.BOOK / "chapters" / "data" / "other_filters.json"
RUNS, FIRST = 200, 3
SEEDS = 25, 26
FILTERS: dict[str, tuple[type[FastSlam], tuple[int, ...]]] = {
    "FastSLAM 1.0": (FastSlam, (0, 100)),
    "FastSLAM 2.0": (FastSlam2, (10, 100)),
}
LOST = 3.0  # times as far off as the EKF in its median run
CELLS = "25-002", "25-004", "25-010", "25-012", "25-023", "25-061"  # of the chapter: secants, all data, the contest


def contestants(scene: str, seed: int, runs: int) -> dict[str, Contestant]:
    """The filters by their names, on the same runs."""
    found = {}
    for name, (kind, particles) in FILTERS.items():
        for c in compare(np.random.default_rng(seed), runs, particles=particles, kind=kind, **SCANNERS[scene]):
            found[f"{name}, {c.name}" if c.particles else c.name] = c
    return {**found, "all data": at_once(scene, seed, runs)}


def by_chapter(scene: str, seed: int, runs: int, filters: dict[str, Callable[..., Any]]) -> Any:
    """The chapter's `contest`: filters of its drives, and "all data" begun at PlanarEkf's answer, which is one of them.

    By name: squared errors [m^2] and NEES of the position (runs, n), of the map at the end (runs, 20).
    """
    return chapter()["contest"](scene, seed, runs, filters)


@cache
def chapter() -> dict[str, Any]:
    """What some cells of the chapter define, by its name; what they print is left out."""
    cells = json.loads((layout.BOOK / "chapters" / "other_filters.ipynb").read_text("utf-8"))["cells"]
    own: dict[str, Any] = {"__name__": "__main__"}
    with redirect_stdout(StringIO()):
        exec("\n".join("".join(cell["source"]) for cell in cells if cell["id"] in CELLS), own)
    return own


def at_once(scene: str, seed: int, runs: int) -> Contestant:
    """All data of the same runs at once, begun at the EKF's answer."""
    square, nees, of_map, _ = by_chapter(scene, seed, runs, {"tangents": PlanarEkf})["all data"]
    none, off = np.zeros(square.shape[1]), float(np.sqrt(of_map).mean())
    return Contestant(0, np.sqrt(square.mean(0)), np.sqrt(square.mean(1)), off, nees, none, none, np.nan)


def summary(scene: str, runs: int = RUNS) -> Any:
    """By seed and filter: means over the runs, of NEES with its standard error, and the share of lost runs."""
    found: dict[str, Any] = {}
    for seed in SEEDS:
        made = contestants(scene, seed, runs)
        ekf = made["EKF"]
        found[str(seed)] = {
            name: {
                "rmse": np.sqrt(np.mean(c.of_run**2)),
                "map_error": c.map_error,
                "nees": c.nees.mean(),
                "nees_error": c.nees.mean(1).std(ddof=1) / np.sqrt(runs),
                "nees_median": np.median(c.nees),
                "lost": np.mean(c.of_run > LOST * np.median(ekf.of_run)),
                "effective": c.effective[1:].mean() / max(c.particles, 1),
                "ancestors": c.ancestors[0],
                "time": c.seconds / ekf.seconds,
            }
            for name, c in made.items()
        }
    return stored.plain(found)


def first(runs: int = FIRST) -> Any:
    """By scene and filter, for each of the first runs: root mean square error of the position [m], median NEES."""
    return stored.plain({
        scene: {
            name: {"rmse": c.of_run, "nees_median": np.median(c.nees, axis=1)}
            for name, c in contestants(scene, SEEDS[0], runs).items()
        }
        for scene in SCANNERS
    })  # fmt: skip


PARTS: dict[str, Callable[[], Any]] = {
    "runs": lambda: RUNS,
    "seeds": lambda: list(SEEDS),
    "lost": lambda: LOST,
    "first": first,
    **{scene: partial(summary, scene) for scene in SCANNERS},
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
