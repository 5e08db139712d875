"""Checks of the chapter: landmark initialization."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, holds, least_squares, pair, same
from slamlib.manifolds import Array

UNKNOWN = 1e9  # the variance of what nothing is known of


@exercise("initialization.1", "one uncertain mount, two pictures")
def two_pictures(candidate: Any) -> None:
    """Against least squares over both places of the robot, the mount and both landmarks."""
    for p, q, s, v in ((1.0, 1.0, 1.0, 1.0), (0.5, 2.0, 0.3, 0.1), (3.0, 0.0, 0.2, 0.7), (0.0, 1.0, 2.0, 0.5)):
        given = f"p {p}, q {q}, s {s}, R {v}"
        P = covariance(candidate(p, q, s, v), 4, "the covariance")
        prior = np.diag([UNKNOWN] * 5)  # robot before and after, mount, two landmarks
        rows = [([1, 0, 0, 0, 0], p), ([-1, 1, 0, 0, 0], q), ([0, 0, 1, 0, 0], s)]
        rows += [([-1, 0, -1, 1, 0], v), ([0, -1, -1, 0, 1], v)]
        measured = [(np.array([row], dtype=float), np.zeros(1), np.array([[r + 1e-9]])) for row, r in rows]
        best = least_squares(np.zeros(5), prior, measured)[1][1:, 1:]
        apart = P[2, 2] + P[3, 3] - 2 * P[2, 3]
        same(apart, q + 2 * v, "between the landmarks stand the motion and two measurements, no mount", given=given)
        same(P, best, "all that was measured is used, and used once", given=given, tolerance=1e-6)


@exercise("initialization.2", "a landmark enters")
def enter(candidate: Any) -> None:
    """The covariance of the errors with the new one's appended, whatever rows it depends on."""
    rng = np.random.default_rng(152)
    for n, rows, m in (
        (6, [0, 1, 2], 2),
        (9, [3, 4, 5, 6], 3),
        (8, [0, 1, 6, 7], 2),
        (5, [4, 0], 1),
        (3, [0, 1, 2], 4),
    ):
        given = f"{n} numbers, a new landmark of {m} that depends on rows {rows}"
        A, G, B = (rng.standard_normal(shape) for shape in ((n, n), (m, len(rows)), (m, m)))
        P, noise, at = A @ A.T, B @ B.T, np.array(rows)
        found = covariance(candidate(P, at, G, noise), n + m, "the covariance")
        same(found[:n, :n], P, "what was there stays as it was", given=given)
        errors = np.vstack([np.hstack([A, np.zeros((n, m))]), np.hstack([G @ A[at], B])])  # rows: errors, in draws
        same(found[n:, :n], errors[n:] @ errors[:n].T, "the new rows reach every old block", given=given)
        same(found, errors @ errors.T, "it is the covariance of the errors, old and new", given=given)


@exercise("initialization.3", "a landmark without an inverse model")
def from_direct(candidate: Any) -> None:
    """The limit of least squares with a landmark of which nothing was known."""
    rng = np.random.default_rng(153)
    cases = [_polar(2.0, 0.5, 0.3), _polar(9.0, -2.0, 1.2)]
    cases += [(rng.standard_normal((m, k)), rng.standard_normal((m, m)) + 2 * np.eye(m)) for m, k in ((1, 1), (3, 6))]
    for H_r, H_l in cases:
        m, k = H_r.shape
        A, B = rng.standard_normal((k, k)), rng.standard_normal((m, m))
        P, R = 0.1 * A @ A.T + 0.01 * np.eye(k), 0.1 * B @ B.T + 0.01 * np.eye(m)
        given = f"a measurement of {m} numbers and a robot of {k}"
        own, cross = pair(candidate(H_r, H_l, P, R), "the pair (P_ll, P_lr)")
        corner = covariance(own, m, "P_ll")
        cross = array_of(cross, (m, k), "P_lr")
        prior = np.zeros((k + m, k + m))
        prior[:k, :k], prior[k:, k:] = P, UNKNOWN * np.eye(m)
        best = least_squares(np.zeros(k + m), prior, [(np.hstack([H_r, H_l]), np.zeros(m), R)])[1]
        same(corner, best[k:, k:], "P_ll is that of a correction without a prior", given=given, tolerance=1e-5)
        same(cross, best[k:, :k], "P_lr is that of a correction without a prior", given=given, tolerance=1e-5)
        joint = np.block([[P, cross.T], [cross, corner]])
        left = np.hstack([H_r, H_l]) @ joint
        holds(
            np.abs(left[:, :k]).max() < 1e-9 * max(1, np.abs(joint).max()),
            "what the sensor sees of the two errors together is its own noise, which the robot does not share",
            "the expected measurement's error is correlated with the robot's",
        )


def _polar(distance: float, bearing: float, heading: float) -> tuple[Array, Array]:
    """Jacobians of range and bearing by a planar pose (x, y, heading) and by a point."""
    c, s = np.cos(bearing + heading), np.sin(bearing + heading)
    H_l = np.array([[c, s], [-s / distance, c / distance]])
    return np.hstack([-H_l, [[0], [-1]]]), H_l
