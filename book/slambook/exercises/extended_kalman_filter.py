"""Checks of the chapter: the extended Kalman filter."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, given, holds, parts, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences

ESTIMATE = {"the mean": (3,), "the covariance": (3, 3)}


@exercise("extended_kalman_filter.1", "how a range bends", seed=31)
def range_bias(candidate: Candidate, rng: Rng) -> None:
    """The mean of what the tangent leaves out, against second differences of the distance itself."""
    places = [(rng.standard_normal(2), 2 + rng.standard_normal(2), rng.standard_normal((2, 2))) for _ in range(5)]
    drawn = [(x, landmark, 0.1 * (root @ root.T)) for x, landmark, root in places]
    for x, landmark, P in cases(drawn, "x = {}, landmark = {}, P = {}"):
        ahead = (landmark - x) / np.hypot(*(landmark - x))
        found = array_of(candidate(x, landmark, P), (), "the bias")
        holds(found > 0, "a robot displaced sideways is farther away, never nearer", f"found {found:.4g}")
        turn, shift = np.array([[0.8, -0.6], [0.6, 0.8]]), np.array([3.0, -1.0])
        moved = candidate(turn @ x + shift, turn @ landmark + shift, turn @ P @ turn.T)
        same(moved, found, "turned and moved as a whole, the bias stays")
        along = candidate(x, landmark, P + 0.3 * np.outer(ahead, ahead))
        same(along, found, "an error along the line of sight adds no bias")
        same(candidate(x, landmark, 4 * P), 4 * found, "four times the bias with four times P")
        same(candidate(x, x + 2 * (landmark - x), P), found / 2, "half the bias at twice the distance")
        variances, axes = np.linalg.eigh(P)
        stops = [np.hypot(*(x[:, None] + step * axes - landmark[:, None])) for step in (-1e-3, 0, 1e-3)]
        total = variances @ (stops[0] - 2 * stops[1] + stops[2]) / 1e-6 / 2  # the trace, along the principal axes
        same(found, total, "half the trace of second derivatives times P", tolerance=1e-5)


@exercise("extended_kalman_filter.2", "the most probable state", seed=32)
def map_estimate(candidate: Candidate, rng: Rng) -> None:
    """The gradient of the least-squares cost vanishes, for a linear and for two curved measurements."""
    place = np.array([2.5, 1.0])

    def h(x: Array) -> Array:
        return np.array([np.hypot(*(x - place)), x[0] * x[1]])

    def jacobian(x: Array) -> Array:
        return np.stack([(x - place) / np.hypot(*(x - place)), x[::-1]])

    P, R = np.array([[0.25, 0.1], [0.1, 0.09]]), np.array([[0.0025, 0.003], [0.003, 0.01]])
    A, x0, z = rng.standard_normal((2, 2)), rng.standard_normal(2), rng.standard_normal(2)
    linear = array_of(candidate(x0, P, z, R, lambda x: A @ x, lambda x: A), (2,), "the state")
    expected = x0 + P @ A.T @ np.linalg.solve(A @ P @ A.T + R, z - A @ x0)
    what = "a linear measurement gives the Kalman filter, however often repeated"
    same(linear, expected, what, tolerance=1e-3)  # halving hides a missing bracket here; the gradient shows it plainly
    starts = 0.3 * rng.standard_normal((5, 2))
    drawn = [(x0, h(x0 + 0.4 * rng.standard_normal(2))) for x0 in starts]
    for x0, z in cases(drawn, "x0 = {}, z = {}"):
        x = array_of(candidate(x0, P, z, R, h, jacobian), (2,), "the state")
        gradient = np.linalg.solve(P, x - x0) - jacobian(x).T @ np.linalg.solve(R, z - h(x))
        same(gradient, np.zeros(2), "the gradient of the cost vanishes", tolerance=1e-6)
    x0, P, R = np.zeros(1), np.array([[9.0]]), np.array([[np.radians(2.0) ** 2]])
    road = np.linspace(-12, 12, 24001)
    for (z,) in cases([(np.arctan2([1.0], [4 - robot]),) for robot in (5.0, 5.5, 6.0)], "the road, z = {}"):
        best = road[(road**2 / P[0] + (z - np.arctan2(1, 4 - road)) ** 2 / R[0]).argmin()]
        x = candidate(x0, P, z, R, lambda x: np.arctan2(1, 4 - x), lambda x: np.array([1 / ((4 - x) ** 2 + 1)]))
        same(x, [best], "on the road, where full steps leap to and fro, the best of all places", tolerance=1e-3)


@exercise("extended_kalman_filter.3", "predicting a driving robot", seed=33)
def predict(candidate: Candidate, rng: Rng) -> None:
    """The covariance moves with the derivative of the candidate's own mean, at the old state."""
    P, Q = (root @ root.T for root in (0.2 * rng.standard_normal((3, 3)), 0.1 * rng.standard_normal((2, 2))))
    drawn = [(rng.standard_normal(3), np.array([0.5, 0.7]) + rng.standard_normal(2)) for _ in range(5)]
    for x, u in cases(drawn, "x = {}, u = {}"):
        mean, found = parts(candidate(x, P, u, Q), ESTIMATE)
        expected = x + np.array([u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]])
        same(mean, expected, "drives along the old heading, then turns")
        F = differences(lambda at, u=u: candidate(at, P, u, Q)[0], x)
        G = differences(lambda at, x=x: candidate(x, P, at, Q)[0], u)
        moved = parts(candidate(x, P, u, 0 * Q), ESTIMATE)[1]
        same(moved, F @ P @ F.T, "with an exact control, F P F', F at the old state", tolerance=1e-6)
        driven = parts(candidate(x, 0 * P, u, Q), ESTIMATE)[1]
        same(driven, G @ Q @ G.T, "from an exact state, G Q G', G at the old state", tolerance=1e-6)
        covariance(found, 3)
        same(found, F @ P @ F.T + G @ Q @ G.T, "together, the sum of both", tolerance=1e-6)


@exercise("extended_kalman_filter.4", "the innovation of a bearing", seed=34)
def innovation(candidate: Candidate, rng: Rng) -> None:
    """Full turns do not count, small differences come back as they are, and a range is no angle."""

    def difference(z: Array, e: Array) -> Array:
        given(f"z = {np.round(z, 3)}, e = {np.round(e, 3)}")
        return array_of(candidate(z, e), (2,), "the innovation")

    for _ in range(20):
        e, small = np.array([rng.uniform(1, 9), rng.uniform(-np.pi, np.pi)]), 0.1 * rng.standard_normal(2)
        z = e + small
        same(difference(z, e), small, "a small difference comes back as it is")
        far = difference(np.array([9.5, z[1]]), np.array([0.5, e[1]]))
        same(far[0], 9.0, "a range is not wrapped")
        for turns in (-1, 1, -2, 2):
            full = np.array([0, 2 * np.pi * turns])
            same(difference(z + full, e), small, "full turns in the measured bearing do not count")
            same(difference(z, e + full), small, "full turns in the expected bearing do not count")
        wide = difference(np.array([1.0, e[1] + rng.uniform(-9, 9)]), e)
        holds(abs(wide[1]) <= np.pi + 1e-12, "the bearing's part lies between -pi and pi", f"found {wide[1]:.4g}")
        turned = rng.choice([-1, 1]) * rng.uniform(2, 3)
        wide = difference(np.array([1, turned]), np.zeros(2))
        same(wide[1], turned, "a large turn keeps its size and its sign")
    given("")
