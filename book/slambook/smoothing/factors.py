"""The factors of a smoother's problem: whitened residuals over all frames, with the Jacobians of the filter's models.

A motion's residual is the noise w itself, the one with which step(x, control + w) is the next state: its covariance is
that of the control, and its Jacobians follow from those of the step (implicit functions). Where a control has fewer
numbers than the state (constant velocity, a car), the other directions are held by SLACK; what has no noise at all is
held by EXACT. That valley is narrow and winding: where the steps get stuck in it, `loose` widens both.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.smoothing.least_squares import EXACT, Factor, Terms, Values, Variable
from slamlib.entities import RigSensor
from slamlib.geometry.pose import Pose, compose
from slamlib.manifolds import Array, Euclidean, Indices, Manifold, Mask
from slamlib.motions import ODOMETRY, Motion
from slamlib.sensors.sensor import Calibration

SLACK = 1e-3  # standard deviation where a control has no noise, relative to what its noise does there one step later
HUBER, CAUCHY = 1.345, 2.385  # of a whitened residual: 95 % efficient without outliers (Zhang, IVC 15(1), 1997)
OPEN = {"near": 0.0, "far": np.inf, "yaw": np.pi, "pitch": np.pi}  # [m, rad]; other limits are the models' own
NOWHERE = Terms(np.inf, np.zeros((0, 1)), [])  # what cannot be
Loss = Callable[[Array], tuple[Array, Array]]  # from squared whitened residuals to their costs and weights
LOSSES: dict[str, Loss] = {
    "squares": lambda s: (s, np.ones_like(s)),
    "huber": lambda s: (
        np.where(s <= HUBER**2, s, 2 * HUBER * np.sqrt(s) - HUBER**2),
        HUBER / np.sqrt(np.maximum(s, HUBER**2)),
    ),
    "cauchy": lambda s: (CAUCHY**2 * np.log1p(s / CAUCHY**2), 1 / (1 + s / CAUCHY**2)),
}


def whitening(covariance: Array, exact: float = EXACT) -> Array:
    """W (..., m, m) with W'W = covariance^-1; variances below exact^2 are raised to it."""
    values, vectors = np.linalg.eigh(covariance)
    whitened: Array = (vectors / np.sqrt(np.maximum(values, exact**2))[..., None, :]).swapaxes(-1, -2)
    return whitened


def prior(variable: Variable, mean: Array, covariance: Array) -> Factor:
    """The variable's first item, known beforehand: a state, or extrinsics, with this mean and covariance."""
    W, first, turns = whitening(covariance), np.zeros(1, dtype=int), list(rotations(variable.manifold))

    def terms(values: Values) -> Terms:
        e = variable.manifold.minus(values[variable.index][0], mean)
        J = np.eye(len(e))
        for stored, at in turns:
            pose, turn = (np.concatenate([np.zeros(3), numbers]) for numbers in (mean[stored], e[at]))
            J[at, at] = np.linalg.inv(ODOMETRY.step.jac(pose, turn, 0.0)[1].control[3:, 3:])
        return Terms(float(((W @ e) ** 2).sum()), (W @ e)[None], [(variable, first, (W @ J)[None])])

    return terms


def rotations(manifold: Manifold, stored: int = 0, start: int = 0) -> Iterator[tuple[slice, slice]]:
    """Where quaternions stand in a point, and their rotation vectors in a difference of two.

    What else is in a difference is a sum: a step of the first point adds to it.
    """
    if manifold.size > manifold.dof and not hasattr(manifold, "parts"):
        yield slice(stored, stored + manifold.size), slice(start, start + manifold.dof)
    for part in getattr(manifold, "parts", ()):
        yield from rotations(part, stored, start)
        stored, start = stored + part.size, start + part.dof


def motion(
    variable: Variable, step: Any, controls: Sequence[tuple[Array, Array, float]], states: Array, loose: float = 1.0
) -> Factor:
    """The noise in each control (value, covariance, dt), between a robot's states; states: the initial ones.

    loose: factor of the standard deviations of what has no noise.
    """
    exact = loose * EXACT
    u, Q, dt = (np.array(column) for column in zip(*controls, strict=True))
    items, c = np.arange(len(dt)), u.shape[1]
    _, (F, G, _) = step.jac(states[:-1], u, dt)
    root = np.linalg.inv(whitening(Q, exact))
    U, moved, V = np.linalg.svd(G @ root)
    root, works = root @ V.swapaxes(-1, -2), moved > exact  # the noise, in parts; does this one move the state?
    later = U[..., c:].swapaxes(-1, -2) @ F @ G @ root
    slack = np.linalg.inv(whitening((loose * SLACK) ** 2 * later @ later.swapaxes(-1, -2), exact))
    held = np.concatenate([exact * U[..., :c], U[..., c:] @ slack], axis=-1)

    def terms(values: Values) -> Terms:
        x, after, w = values[variable.index][:-1], values[variable.index][1:], np.zeros_like(u)
        for _ in range(20):  # Newton's method for the parts w of the noise that move the state
            reached, (F, G, _) = step.jac(x, u + (root @ w[..., None])[..., 0], dt)
            by = held.copy()
            by[..., :c] = np.where(works[:, None], G @ root, by[..., :c])
            J = np.linalg.inv(by)
            r = (J @ variable.manifold.minus(after, reached)[..., None])[..., 0]
            change = works * r[:, :c]
            w = w + change
            if np.abs(change).max() < 1e-6:  # of a standard deviation; what is left is its square
                r[:, :c] = np.where(works, w, r[:, :c])
                return Terms(float((r**2).sum()), r, [(variable, items, -J @ F), (variable, items + 1, J)])
        return NOWHERE

    return terms


def absolute(variable: Variable, motion: Motion, model: Any, rows: Sequence[tuple[int, Any]]) -> Factor:
    """A robot's measurements of itself by one model of its pose: (item, RobotMeasurement)."""
    items = np.array([item for item, _ in rows])
    measured, W = np.array([m.value for _, m in rows]), whitening(np.array([m.covariance for _, m in rows]))
    space = (model.result.manifold if model.result else None) or Euclidean(measured.shape[1])

    def terms(values: Values) -> Terms:
        states = values[variable.index][items]
        predicted, J = model.jac(motion.pose(states))
        r = (W @ space.minus(measured, predicted)[..., None])[..., 0]
        return Terms(float((r**2).sum()), r, [(variable, items, padded(-W @ motion.by_state(J[0], states), variable))])

    return terms


def padded(J: Array, robot: Variable) -> Array:
    """Jacobians (n, m, k) w.r.t. the first degrees of freedom of a robot's states as those w.r.t. all, (n, m, dof)."""
    return np.pad(J, ((0, 0), (0, 0), (0, robot.width - J.shape[-1])))


@dataclass(frozen=True, eq=False)
class Group:
    """Measurements (n, m) by one sensor of landmarks of one kind: items of the robot's states and of the landmarks.

    numbers (n,): where they stand in the list of all measurements.
    """

    sensor: RigSensor
    family: Any
    options: Any
    robot: Variable
    extrinsics: Variable | None
    landmarks: Variable
    numbers: Indices
    items: Indices
    rows: Indices
    measured: Array

    @property
    def calibration(self) -> Calibration:
        """The sensor's, but for its limits of view: what was measured was within them, give or take its noise."""
        given = self.sensor.calibration
        limits = {name: OPEN.get(name, limit) for name, limit in given.limits.items()}
        return Calibration(given.sensor, given.noise, image=given.image, limits=limits, **given.given)

    def _states(self, values: Values) -> Array:
        """The robot's states (n, size)."""
        return values[self.robot.index][self.items]

    def _arguments(self, values: Values) -> tuple[Array, Any, Array]:
        """The sensor's poses (n, 7), their Jacobians w.r.t. robot's pose and extrinsics, the landmarks (n, size)."""
        inner = self.sensor.given_extrinsics if self.extrinsics is None else values[self.extrinsics.index][0]
        cameras, J = compose.jac(self.sensor.robot.motion.pose(self._states(values)), inner)
        return cameras, J, values[self.landmarks.index][self.rows]

    def seen(self, values: Values) -> Mask:
        """Mask (n,) of the measurements that the sensor can make at all."""
        cameras, _, means = self._arguments(values)
        inside = self.landmarks.kind.to_frame(cameras, means)
        return np.isfinite(self.family.innovation_input(self.calibration, inside)).all(-1)

    def terms(self, values: Values, loss: Loss) -> Terms:
        """Terms weighted by the loss; the cost is infinite where a measurement cannot be made."""
        if not self.seen(values).all():
            return NOWHERE
        (cameras, outer, means), motion = self._arguments(values), self.sensor.robot.motion
        inner, _, J = self.family.observe(self.landmarks.kind, self.calibration, cameras, means)
        by = np.concatenate([J.camera @ outer.outer, J.camera @ outer.inner, J.landmark], axis=-1)
        by, k = motion.by_state(by, self._states(values)), motion.pose_dof
        z, H, R = self.family.residual(self.sensor, inner, by, self.measured, self.options)
        W = whitening(R)
        r = (W @ z[..., None])[..., 0]
        costs, weights = loss((r**2).sum(-1))
        root = np.sqrt(weights)[:, None]
        H = -root[..., None] * (W @ H)
        parts = [(self.robot, self.items, padded(H[..., :k], self.robot))]
        parts.append((self.landmarks, self.rows, H[..., k + Pose.dof :]))
        if self.extrinsics is not None:
            parts.append((self.extrinsics, np.zeros_like(self.items), H[..., k : k + Pose.dof]))
        return Terms(float(costs.sum()), root * r, parts)
