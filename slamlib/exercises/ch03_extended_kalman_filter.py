"""Checks of chapter 3: the extended Kalman filter."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, differences, pair, same

RETURNS = "a mean and a covariance"


@exercise("3.2", "the most probable state")
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


@exercise("3.3", "predicting a driving robot")
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
