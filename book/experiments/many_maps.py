"""`make many-maps`: one map and many, in the same runs, for chapter many; stored.

A robot with poor odometry and a stereo camera goes once round the cloister. Two sets of runs, and of each the last
pose: its error and what is claimed of it [m], and its NEES (6 is right). "one map": by the ordinary filter ("local")
and by one that carries the motions of the world ("world"). "many maps": closed when they are full, then joined and
tied, each map by either filter. "all data": all of it at once.
"""

from dataclasses import replace
from typing import Any

import numpy as np
from slambook.smoothing import Smoother
from slambook.submaps import SubmapSlam

from book.experiments import stored
from book.tools import layout
from slamlib.evaluation.consistency import nees
from slamlib.experiments.presets import Preset, points, two_robots
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.rigs.setup import Rig, SensorSetup
from slamlib.slam import Options, Slam

FILE = layout.BOOK / "chapters" / "data" / "many_maps.json"
SETS, RUNS, FULL = (180, 181), 50, 30  # of seeds; runs of each; landmarks of a map
ERRORS = ("local", "world")


def tour(error: str = "local") -> Preset:
    """Once round the cloister, in 108 steps of 32 cm, which odometry knows to 2 cm in each direction, 0.2 degrees."""
    robot = replace(two_robots().rig.robots[0], control=(0.32, 0, 0, 0, 0, 3.6), control_std=(0.02,) * 3 + (0.2,) * 3)
    eyes = SensorSetup(
        type="stereo",
        position=(0.0, 0.0, 0.6),
        parameters={"intrinsics": (320, 240, 320, 320), "baseline": (0.5,)},
    )
    options = Options(points="eucPnt", max_new_first=5, max_new=2, error=error)
    return replace(points(), rig=Rig((robot,), (eyes,)), options=options, frames=108)


def run(number: int, seed: int) -> dict[str, list[float]]:
    """What one run is by all of them: (error [m], claim [m], NEES) of the last pose."""
    presets = {error: tour(error) for error in ERRORS}
    one = {error: preset.slam() for error, preset in presets.items()}
    many = {error: SubmapSlam(preset.rig, preset.options, max_landmarks=FULL) for error, preset in presets.items()}
    every: list[Slam | SubmapSlam] = [*one.values(), *many.values()]
    recorded, last = Smoother(one["local"]), np.empty(7)
    for frame, truth in presets["local"].simulate(np.random.default_rng([number, seed])):
        for each in every:
            each.step(frame)
        recorded.record(frame)
        last = truth.poses[0]
    found = {}
    for error, slam in one.items():
        block = slam.robots[0].block
        found[f"one map, {error}"] = judged(last, block.mean, slam.belief.covariance(block))
    for error, maps in many.items():
        maps.close()
        maps.atlas.merge_duplicates()
        found[f"many maps, {error}"] = judged(last, maps.atlas.pose, maps.atlas.covariance())
    solution = recorded.solve()
    return found | {"all data": judged(last, solution.poses[-1, 0], solution.covariance())}


def judged(truth: Array, pose: Array, P: Array) -> list[float]:
    """Error [m], claim [m] and NEES of a pose (7,) with covariance (6, 6)."""
    error = Pose.minus(truth, pose)
    return [float(np.linalg.norm(error[:3])), float(np.sqrt(np.trace(P[:3, :3]))), float(nees(error, P))]


def runs(number: int) -> dict[str, Any]:
    """A set: by filter, the three numbers of each run."""
    rows = [run(number, seed) for seed in range(RUNS)]
    return {name: stored.plain([row[name] for row in rows]) for name in rows[0]}


PARTS = {str(number): lambda number=number: runs(number) for number in SETS}


def main() -> None:
    """Make the sets that are asked for, and store them."""
    stored.main(FILE, PARTS, __doc__, resumable=True)


if __name__ == "__main__":
    main()
