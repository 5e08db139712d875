"""Checks of the chapter: the extended Kalman filter."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, differences, holds, pair, same

RETURNS = "a mean and a covariance"


@exercise("extended_kalman_filter.1", "how a range bends")
def range_bias(candidate: Any) -> None:
    """The mean of what the tangent leaves out, against second differences of the distance itself."""
    rng = np.random.default_rng(31)
    for _ in range(5):
        x, landmark, root = rng.standard_normal(2), 2 + rng.standard_normal(2), rng.standard_normal((2, 2))
        P = 0.1 * (root @ root.T)
        ahead = (landmark - x) / np.hypot(*(landmark - x))
        sharp = candidate(x, landmark, 0.3 * np.outer(ahead, ahead))
        same(sharp, 0.0, "an error along the line of sight has no bias")
        found = float(array_of(candidate(x, landmark, P), (), "the bias"))
        holds(found > 0, "a robot beside its place is farther away, never nearer", f"found {found:.4g}")
        total, step = 0.0, 1e-3
        for variance, axis in zip(*_axes(P), strict=True):  # the trace, along the principal axes of P
            stops = [np.hypot(*(x + s * axis - landmark)) for s in (-step, 0, step)]
            total += variance * (stops[0] - 2 * stops[1] + stops[2]) / step**2 / 2
        same(found, total, "half the trace of second derivatives times P", given=f"P = {P}", tolerance=1e-5)
        farther = candidate(x, x + 2 * (landmark - x), P)
        same(farther, found / 2, "half the bias at twice the distance")


def _axes(P: Any) -> tuple[Any, Any]:
    variances, axes = np.linalg.eigh(P)
    return variances, axes.T


@exercise("extended_kalman_filter.2", "the most probable state")
def map_estimate(candidate: Any) -> None:
    """The gradient of the least-squares cost vanishes, for a curved and for a linear measurement."""
    rng = np.random.default_rng(32)
    place = np.array([2.5, 1.0])

    def h(x: Any) -> Any:
        return np.array([np.hypot(*(x - place)), x[0] * x[1]])

    def jacobian(x: Any) -> Any:
        return np.stack([(x - place) / np.hypot(*(x - place)), x[::-1]])

    P, R = np.diag([0.5, 0.3]) ** 2, np.diag([0.05, 0.1]) ** 2
    for _ in range(5):
        x0 = 0.3 * rng.standard_normal(2)
        z = h(x0 + 0.4 * rng.standard_normal(2))
        x = array_of(candidate(x0, P, z, R, h, jacobian), (2,), "the state")
        gradient = np.linalg.solve(P, x - x0) - jacobian(x).T @ np.linalg.solve(R, z - h(x))
        same(gradient, np.zeros(2), "the gradient of the cost vanishes", tolerance=1e-6)
    A = rng.standard_normal((2, 2))
    z = rng.standard_normal(2)
    linear = candidate(np.zeros(2), P, z, R, lambda x: A @ x, lambda x: A)
    same(linear, P @ A.T @ np.linalg.solve(A @ P @ A.T + R, z), "a linear measurement gives the Kalman filter")


@exercise("extended_kalman_filter.3", "predicting a driving robot")
def predict(candidate: Any) -> None:
    """The covariance moves with the derivative of the candidate's own mean, at the old state."""
    rng = np.random.default_rng(33)
    P, Q = np.diag([0.2, 0.1, 0.3]) ** 2, np.diag([0.05, 0.1]) ** 2
    for _ in range(5):
        x, u = rng.standard_normal(3), np.array([0.5, 0.7]) + rng.standard_normal(2)
        mean, found = pair(candidate(x, P, u, Q), RETURNS)
        expected = x + np.array([u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]])
        same(array_of(mean, (3,), "the mean"), expected, "drives along the old heading, then turns")
        covariance(found, 3, "the covariance")
        J = differences(lambda both: pair(candidate(both[:3], P, both[3:], Q), RETURNS)[0], np.concatenate([x, u]))
        F, G = J[:, :3], J[:, 3:]
        same(found, F @ P @ F.T + G @ Q @ G.T, "Jacobians are those of the mean at the old state", tolerance=1e-6)


@exercise("extended_kalman_filter.4", "the innovation of a bearing")
def innovation(candidate: Any) -> None:
    """Full turns do not count, small differences come back as they are, and a range is no angle."""
    rng = np.random.default_rng(34)
    for _ in range(20):
        e, small = np.array([rng.uniform(1, 9), rng.uniform(-np.pi, np.pi)]), 0.1 * rng.standard_normal(2)
        z = e + small
        same(candidate(z, e), small, "a small difference comes back as it is")
        for turns in (-2, -1, 1, 2):
            full = np.array([0, 2 * np.pi * turns])
            same(candidate(z + full, e), small, "full turns in the measured bearing do not count", given=f"{turns}")
            same(candidate(z, e + full), small, "full turns in the expected bearing do not count", given=f"{turns}")
        far = array_of(candidate(np.array([9.5, z[1]]), np.array([0.5, e[1]])), (2,), "the innovation")
        same(far[0], 9.0, "a range is not wrapped")
        wide = array_of(candidate(np.array([1.0, e[1] + rng.uniform(-9, 9)]), e), (2,), "the innovation")
        within = bool(abs(wide[1]) <= np.pi + 1e-12)
        holds(within, "the bearing's part lies between -pi and pi", f"found {wide[1]:.4g}")
        turned = rng.uniform(2, 3)
        same(candidate(np.array([1, turned]), np.zeros(2))[1], turned, "a large turn keeps its size and its sign")
