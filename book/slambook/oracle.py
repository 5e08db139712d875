"""An oracle: Jacobians w.r.t. the state at the truth. It is the limit for what moving linearization points do.

They have one null space N, that of the true state, so the filter gains no false information; Jacobians w.r.t. the noise
of a new landmark are at the estimate. It needs the truth of each frame before the filter's step, and of each landmark
in its own parametrization, with the true sensor's position as its anchor. Bailey et al. (2006) judge filters by it.

It is no limit for anything else. With noise in the truth its Jacobians contain that noise. And where the truth of a
landmark is many states, among which the estimate slides (a line by two of its points), it settles at another of them.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from slamlib.entities import RigSensor
from slamlib.entities.generator import generator
from slamlib.entities.linearization import FirstEstimates, HasMotion
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, compose, inverse
from slamlib.kalman.state import Block
from slamlib.manifolds import Array
from slamlib.records.inputs import Scan, Truth, World
from slamlib.slam import Slam

ROUNDS = 30  # of the search for the true landmark: as many as a distance that is wrong by far needs


class Oracle(FirstEstimates):
    """Linearization points at the truth. Assign `truth` before each step of the filter to which it was given."""

    def __init__(self, slam: Slam, world: World) -> None:
        """slam: before its first frame, with sensors whose extrinsics are given. Raises SlamlibError."""
        super().__init__()
        if any(sensor.block for sensor in slam.sensors):
            raise SlamlibError("Oracle: estimated extrinsics have no truth here; give those of the sensors")
        self.truth: Truth | None = None
        self._slam, self._new = slam, np.zeros(0)
        slam.linearization = self
        slam.families = {name: _at_truth(family, self, world) for name, family in slam.families.items()}

    def motion(self, robot: HasMotion, state: Array, control: Array, dt: float) -> tuple[Array, Array]:
        """Jacobians of the motion between the robot's two true states, that takes N of one to N of the other."""
        return super().motion(robot, self._true(robot.block), control, dt)

    def predicted(self, block: Block) -> None:
        """The robot is where it is in truth."""
        self.first[block] = self._true(block)

    def added(self, blocks: Iterable[Block], means: Iterable[Array]) -> None:
        """A new landmark's truth has just been found, by its initialization."""
        for block, mean in zip(blocks, means, strict=True):
            self.first[block] = self._new if len(self._new) else mean

    def _true(self, block: Block) -> Array:
        robots = zip(self._slam.robots, cast(Truth, self.truth).robots, strict=True)
        return next(state for robot, state in robots if robot.block is block)

    def initialized(self, sensor: RigSensor, kind: Any, mean: Array, noise: Array, feature: Array) -> Array:
        """The Jacobian (dof, 6) w.r.t. the robot's pose at the truth; the true landmark is kept for `added`.

        It is that of equivariance, J N(robot) = N(landmark). feature: of the world, which the landmark is.
        """
        robot, motion = self._true(sensor.robot.block), sensor.robot.motion
        here, there = (compose(pose, sensor.extrinsics) for pose in (sensor.robot.pose, motion.pose(robot)))
        self._new = nearest(kind, kind.moved(compose(there, inverse(here)), mean), noise, feature)
        by: Array = generator(kind, self._new) @ np.linalg.inv(generator(motion, robot)[: motion.pose_dof])
        return by


def missed(kind: Any, state: Array, feature: Array) -> tuple[Array, Array]:
    """By how much the landmark is not the feature, (m,), and its Jacobian (m, dof); zero if it is, up to scale.

    A point (h, w) is p if h = w p, and lies on the line through p along d if d x (h - w p) = 0: both are linear, as is
    the part of a line's six coordinates across those of the feature, for states that are these coordinates.
    """
    if len(feature) == 3 or kind.constrain is not None:
        h, J = kind.to_frame.jac(ORIGIN, state)
        h, by = h[None], J[1][None]
    else:
        h, J = kind.point_at.jac(np.tile(state, (2, 1)), np.array(kind.abscissas, dtype=float))
        by = J[0]
    if h.shape[-1] == 6:
        line = np.concatenate([np.cross(feature[:3], feature[3:]), feature[3:] - feature[:3]])
        C = np.eye(6) - np.outer(line, line) / (line @ line)
    else:
        C = np.column_stack([np.eye(3), -feature[:3]])
        if len(feature) == 6:
            along = feature[3:] - feature[:3]
            C = np.cross(np.eye(3), along / np.linalg.norm(along)) @ C
    return (h @ C.T).ravel(), (C @ by).reshape(-1, by.shape[-1])


def nearest(kind: Any, start: Array, noise: Array, feature: Array) -> Array:
    """The state (size,) of this parametrization which is the feature, from `start` by what its noise (dof, dof) allows.

    The noise of a new landmark moves its direction and its distance, and hardly its anchor. feature: a point (3,), or
    a segment (6,) of the line.
    """
    noise = noise + 1e-7 * np.trace(noise) * np.eye(len(noise))  # a line's tangent space does not hold all lines
    state = start
    for _ in range(ROUNDS):
        off, H = missed(kind, state, feature)
        state = kind.manifold.plus(state, -noise @ H.T @ np.linalg.pinv(H @ noise @ H.T, rcond=1e-12) @ off)
    return np.asarray(state)


@dataclass(frozen=True)
class _Belief:
    """A belief whose blocks are replaced by Jacobians that take N of the old truth to N of the new one."""

    belief: Any
    replace: Callable[..., None]

    def __getattr__(self, name: str) -> Any:
        return getattr(self.belief, name)


def _at_truth(family: Any, oracle: Oracle, world: World) -> Any:
    """The family, with Jacobians of initialization, conversion and constraint at the truth."""
    features = world.features[family.name]
    known = dict(zip(features.ids.tolist(), features.values, strict=True))

    class AtTruth(type(family)):  # type: ignore[misc]
        def initialize(self, sensor: RigSensor, kind: Any, value: Array, options: Any) -> Any:
            mean, noise, _ = super().initialize(sensor, kind, value, options)
            scan = cast(Scan, oracle._slam.scans[oracle._slam.sensors.index(sensor)])
            measured = scan.features[self.name]
            row = int(np.flatnonzero((measured.values == value).all(1))[0])
            feature = known[int(measured.ids[row])]
            return mean, noise, [oracle.initialized(sensor, kind, mean, noise, feature)]

        def after_update(self, belief: Any, sensor: Any, landmarks: Any, measured: Array, options: Any) -> None:
            by_block = {landmark.block: landmark for landmark in landmarks}

            def replace(block: Block, manifold: Any, mean: Array, J: Array, **by_eye: Any) -> None:
                kind, old = by_block[block].kind, oracle.at(block)
                if len(mean) == len(old):  # a constraint, which the truth fulfils
                    _, (J, *_) = kind.constrain.jac(old, sensor.camera[:3])
                else:
                    oracle.first[block], (J,) = kind.to_point.jac(old)
                belief.replace(block, manifold, mean, J)

            super().after_update(_Belief(belief, replace), sensor, landmarks, measured, options)

    return AtTruth()
