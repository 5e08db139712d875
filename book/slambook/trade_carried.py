"""What of robot and extrinsics is taken for a trade of the two, when a filter predicts: by the step that it is told.

A trade moves the robot's frame by a twist a, R -> R exp(a), and the sensor back on it, S -> exp(-a) S: the sensor
stays. A step U makes of the robot's part R U exp(Ad(U)^-1 a), and a trade it remains only where Ad(U) a = a, eq.
(ms-commute). A filter asks this of the step that it was told, and not of the step that was made. `TradeCarried` is told
another step for this one purpose, also the true one: no filter can be, and it shows what the difference costs. Chapter
many.
"""

from collections.abc import Callable, Sequence

import numpy as np

from slamlib.belief import Belief
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.state import BeliefSnapshot
from slamlib.manifolds import Array
from slamlib.motions import ODOMETRY
from slamlib.records.inputs import Control
from slamlib.slam import Slam


def after_step(end: Array, step: Array) -> Array:
    """Error (6, 6) of a pose `end` (7,) by twists of its frame before the step (7,): E(end) Ad(step)^-1."""
    by_twist, by_own_twist = compose.jac(end, ORIGIN)[1].inner, compose.jac(step, ORIGIN)[1].inner
    return np.asarray(by_twist @ np.linalg.solve(by_own_twist, compose.jac(ORIGIN, step)[1].outer))


def correction(end: Array, extrinsics: Array, told: Array, step: Array | None) -> Array:
    """B (6, 6), which takes a prediction by the step told to one that carries trades as another step does.

    The robot's error at `end` (7,) has then B times the error of the extrinsics (7,) added to it. Steps (7,); None: as
    if every trade remained one.
    """
    wanted = compose.jac(end, ORIGIN)[1].inner if step is None else after_step(end, step)
    by_trade = -compose.jac(ORIGIN, extrinsics)[1].outer
    return np.asarray((wanted - after_step(end, told)) @ np.linalg.inv(by_trade))


class TradeCarried(Slam):
    """EKF-SLAM of one robot with odometry and one sensor whose extrinsics are estimated.

    step: given the control of a prediction, the step (6,) by which trades are carried, or None for all of them. As in
    every filter if it is the control itself. predicted: the belief after the last prediction.
    """

    step_of: Callable[[Control], Array | None] = staticmethod(lambda control: control.value)
    predicted: BeliefSnapshot

    def predict(self, controls: Sequence[Control | None], dt: float) -> None:
        """As every filter does; then trades are carried by the step of `step_of`."""
        (control,) = controls
        assert control is not None
        super().predict(controls, dt)
        (robot,), (sensor,) = self.robots, self.sensors
        assert sensor.block
        step, told = self.step_of(control), pose_of(control.value)
        T = np.eye(self.belief.size)
        by = correction(robot.block.mean, sensor.block.mean, told, None if step is None else pose_of(step))
        T[robot.block.slice, sensor.block.slice] = by
        P = T @ self.belief.matrix @ T.T
        blocks = dict(enumerate(self.belief.blocks))
        self.belief.overwrite(blocks, {i: block.mean for i, block in blocks.items()}, P / 2 + P.T / 2)
        self.predicted = self.belief.snapshot()


def pose_of(control: Array) -> Array:
    """A control (6,) of odometry as a pose (7,)."""
    return np.asarray(ODOMETRY.step(ORIGIN, control, 0.0))


def estimated_step(departure: Array, control: Control, before: BeliefSnapshot, belief: Belief) -> Array:
    """A step (6,) as the pictures after it tell: what was told, and the mean of its noise given the update.

    departure (7,): the robot's pose before the step; before: the belief between prediction and update. The robot is its
    first block. Blocks that the update has changed the kind of, or deleted, are left out.
    """
    now = set(belief.blocks)
    kept = [
        (rows, block.manifold.minus(block.mean, mean))
        for block, rows, mean, manifold in zip(
            before.blocks, before.slices, before.means, before.manifolds, strict=True
        )
        if block in now and block.manifold is manifold
    ]
    rows = np.concatenate([np.arange(rows.start, rows.stop) for rows, _ in kept])
    moved = np.concatenate([step for _, step in kept])
    P, G = before.covariance[np.ix_(rows, rows)], ODOMETRY.step.jac(departure, control.value, 0.0)[1].control
    weights = np.linalg.lstsq(P, moved, rcond=1e-13)[0]
    return np.asarray(control.value + control.covariance @ G.T @ weights[: len(G)])
