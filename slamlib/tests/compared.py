"""A run of the filter beside the truth and beside dead reckoning, which is what remains of it without measurements."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slamlib.entities import Landmark
from slamlib.evaluation.consistency import rmse
from slamlib.evaluation.pose_errors import pose_error
from slamlib.experiments.presets import Preset
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.records.inputs import Frame, Truth
from slamlib.rigs.setup import Rig
from slamlib.slam import Slam
from slamlib.slam.snapshot import robot_view

POSITION, ORIENTATION = slice(0, 3), slice(3, 6)


@dataclass(frozen=True, eq=False)
class Compared:
    """A finished run of n frames and r robots.

    errors, reckoned (n, r, 6): true poses minus those of the filter, and of dead reckoning by the same controls; nees
    (n, r): of the filter's, nan where a pose is partly known exactly; sigma, reckoned_sigma (r,): at the end, the root
    of the trace of the orientation's covariance. map_errors, first_map_errors (k,): distances [m] of the final map's
    landmarks, in its order, from the truth, at the end and when each was initialized.
    """

    slam: Slam
    truth: Truth
    errors: Array
    reckoned: Array
    nees: Array
    sigma: Array
    reckoned_sigma: Array
    map_errors: Array
    first_map_errors: Array

    def ratio(self, part: slice, robot: int = 0) -> float:
        """RMSE of a part of the robot's pose, over all frames, as a share of dead reckoning's."""
        return float(rmse(self.errors[:, robot, part]) / rmse(self.reckoned[:, robot, part]))

    @property
    def map_ratio(self) -> float:
        """Median error of the map, as a share of what it was when each landmark was initialized: the worst family's."""
        rows = [
            np.array([isinstance(lm.kind, f.kinds) for lm in self.slam.landmarks]) for f in self.slam.families.values()
        ]
        return max(
            float(np.median(self.map_errors[of]) / np.median(self.first_map_errors[of])) for of in rows if of.any()
        )


def shaken(p: Preset, *, turns: float = 10.0, **changes: Any) -> Preset:
    """The preset, of which the robots turn `turns` times as unpredictably: dead reckoning is soon degrees off."""
    robots = []
    for robot in p.rig.robots:
        noise = np.where(np.isin(np.arange(robot.model.control), robot.model.angles), turns, 1.0)
        robots.append(replace(robot, control_std=tuple((noise * robot.control_std).tolist())))
    return replace(p, rig=Rig(tuple(robots), p.rig.sensors), **changes)


def compared(
    p: Preset, rng: np.random.Generator | None = None, *, frame: Callable[[Frame], Frame] = lambda one: one
) -> Compared:
    """Run a preset, with what it is compared with; frame: what the filter is given of each frame."""
    slam, alone = p.slam(), p.slam()
    rows: list[Any] = []
    begun: dict[int, float] = {}
    for simulated, truth in p.simulate(rng):
        given = frame(simulated)
        report = slam.step(given)
        alone.predict(given.controls, given.dt)
        errors, reckoned = (
            np.array([Pose.minus(pose, robot.pose) for pose, robot in zip(truth.poses, s.robots, strict=True)])
            for s in (slam, alone)
        )
        squares = [
            pose_error(true, robot.pose, P, robot.motion.free)[2]
            for true, robot, P in zip(truth.poses, slam.robots, poses(slam), strict=True)
        ]
        rows.append((errors, reckoned, squares))
        begun |= distances(slam, p, [lm for lm in slam.landmarks if lm.id in report.initialized])
    now = distances(slam, p, slam.landmarks)
    return Compared(
        slam,
        truth,
        *map(np.array, zip(*rows, strict=True)),
        *(np.array([np.sqrt(P[3:, 3:].trace()) for P in poses(s)]) for s in (slam, alone)),
        *(np.array([away[lm.id] for lm in slam.landmarks]) for away in (now, begun)),
    )


def poses(slam: Slam) -> list[Array]:
    """Covariance (6, 6) of each robot's pose."""
    return [robot_view(slam.belief, robot).pose_covariance for robot in slam.robots]


def distances(slam: Slam, p: Preset, landmarks: list[Landmark]) -> dict[int, float]:
    """By the landmark's number its distance [m] from the truth; infinite where it is estimated to lie at infinity."""
    found = {}
    for name, family in slam.families.items():
        things = p.world.features[name]
        there = dict(zip(things.ids.tolist(), things.values, strict=True))
        for landmark in landmarks:
            if isinstance(landmark.kind, family.kinds):
                geometry = family.geometry(slam.belief, [landmark])[0][0]
                away = family.distance(geometry, there[landmark.id])
                found[landmark.id] = np.inf if np.isnan(away) else away
    return found


def is_healthy(slam: Slam) -> None:
    """Assert that P is symmetric and positive semi-definite, and the blocks fill its rows without a gap."""
    P = slam.belief.matrix
    assert np.array_equal(P, P.T)
    assert np.linalg.eigvalsh(P).min() > -1e-9 * P.max()
    rows = [i for block in slam.belief.blocks for i in range(block.slice.start, block.slice.stop)]
    assert rows == list(range(len(P)))
    known = {id(block) for block in slam.belief.blocks}
    assert {id(lm.block) for lm in slam.landmarks} <= known
    assert all(lm.block.manifold.size == lm.kind.manifold.size for lm in slam.landmarks)
