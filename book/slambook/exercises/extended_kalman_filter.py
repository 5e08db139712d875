"""Checks of the chapter: the extended Kalman filter."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, covariance, exercise, holds, parts, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences

ESTIMATE = {"the mean": (3,), "the covariance": (3, 3)}


@exercise("extended_kalman_filter.1", "how a range bends", seed=31)
def range_bias(candidate: Candidate, rng: Rng) -> None:
    """The mean of what the tangent leaves out, against second differences of the distance itself."""
    for _ in range(5):
        x, landmark, root = rng.standard_normal(2), 2 + rng.standard_normal(2), rng.standard_normal((2, 2))
        P = 0.1 * (root @ root.T)
        ahead = (landmark - x) / np.hypot(*(landmark - x))
        same(candidate(x, landmark, 0.3 * np.outer(ahead, ahead)), 0.0, "an error along the line of sight has no bias")
        found = array_of(candidate(x, landmark, P), (), "the bias")
        holds(found > 0, "a robot displaced sideways is farther away, never nearer", f"found {found:.4g}")
        variances, axes = np.linalg.eigh(P)
        stops = [np.hypot(*(x[:, None] + step * axes - landmark[:, None])) for step in (-1e-3, 0, 1e-3)]
        total = variances @ (stops[0] - 2 * stops[1] + stops[2]) / 1e-6 / 2  # the trace, along the principal axes
        same(found, total, "half the trace of second derivatives times P", tolerance=1e-5)
        same(candidate(x, x + 2 * (landmark - x), P), found / 2, "half the bias at twice the distance")


@exercise("extended_kalman_filter.2", "the most probable state", seed=32)
def map_estimate(candidate: Candidate, rng: Rng) -> None:
    """The gradient of the least-squares cost vanishes, for a curved and for a linear measurement."""
    place = np.array([2.5, 1.0])

    def h(x: Array) -> Array:
        return np.array([np.hypot(*(x - place)), x[0] * x[1]])

    def jacobian(x: Array) -> Array:
        return np.stack([(x - place) / np.hypot(*(x - place)), x[::-1]])

    P, R = np.array([[0.25, 0.1], [0.1, 0.09]]), np.array([[0.0025, 0.003], [0.003, 0.01]])
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


@exercise("extended_kalman_filter.3", "predicting a driving robot", seed=33)
def predict(candidate: Candidate, rng: Rng) -> None:
    """The covariance moves with the derivative of the candidate's own mean, at the old state."""
    P, Q = (root @ root.T for root in (0.2 * rng.standard_normal((3, 3)), 0.1 * rng.standard_normal((2, 2))))
    for _ in range(5):
        x, u = rng.standard_normal(3), np.array([0.5, 0.7]) + rng.standard_normal(2)
        mean, found = parts(candidate(x, P, u, Q), ESTIMATE)
        expected = x + np.array([u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]])
        same(mean, expected, "drives along the old heading, then turns")
        covariance(found, 3)
        F = differences(lambda at, u=u: candidate(at, P, u, Q)[0], x)
        G = differences(lambda at, x=x: candidate(x, P, at, Q)[0], u)
        same(found, F @ P @ F.T + G @ Q @ G.T, "Jacobians are those of the mean at the old state", tolerance=1e-6)


@exercise("extended_kalman_filter.4", "the innovation of a bearing", seed=34)
def innovation(candidate: Candidate, rng: Rng) -> None:
    """Full turns do not count, small differences come back as they are, and a range is no angle."""
    for _ in range(20):
        e, small = np.array([rng.uniform(1, 9), rng.uniform(-np.pi, np.pi)]), 0.1 * rng.standard_normal(2)
        z = e + small
        same(candidate(z, e), small, "a small difference comes back as it is")
        for turns in (-2, -1, 1, 2):
            full = np.array([0, 2 * np.pi * turns])
            same(candidate(z + full, e), small, "full turns in the measured bearing do not count")
            same(candidate(z, e + full), small, "full turns in the expected bearing do not count")
        far = array_of(candidate(np.array([9.5, z[1]]), np.array([0.5, e[1]])), (2,), "the innovation")
        same(far[0], 9.0, "a range is not wrapped")
        wide = array_of(candidate(np.array([1.0, e[1] + rng.uniform(-9, 9)]), e), (2,), "the innovation")
        holds(abs(wide[1]) <= np.pi + 1e-12, "the bearing's part lies between -pi and pi", f"found {wide[1]:.4g}")
        turned = rng.uniform(2, 3)
        same(candidate(np.array([1, turned]), np.zeros(2))[1], turned, "a large turn keeps its size and its sign")
