"""Checks of the chapter: landmark initialization."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, cases, covariance, exercise, holds, least_squares, parts, same
from slamlib.manifolds import Array

UNKNOWN = 1e9  # the variance of what nothing is known of


@exercise("initialization.1", "uncertain extrinsics, two images")
def two_pictures(candidate: Candidate) -> None:
    """Against least squares over both poses of the robot, the extrinsics and both landmarks."""
    variances = (1.0, 1.0, 1.0, 1.0), (0.5, 2.0, 0.3, 0.1), (3.0, 0.0, 0.2, 0.7), (0.0, 1.0, 2.0, 0.5)
    for p, q, s, v in cases(variances, "p {}, q {}, s {}, R {}"):
        P = covariance(candidate(p, q, s, v), 4)
        rows = [([1, 0, 0, 0, 0], p), ([-1, 1, 0, 0, 0], q), ([0, 0, 1, 0, 0], s)]  # robot twice, extrinsics, landmarks
        rows += [([-1, 0, -1, 1, 0], v), ([0, -1, -1, 0, 1], v)]
        best = least_squares(np.zeros(5), UNKNOWN * np.eye(5), [(row, 0, r + 1e-9) for row, r in rows])[1][1:, 1:]
        apart = P[2, 2] + P[3, 3] - 2 * P[2, 3]
        same(apart, q + 2 * v, "between the landmarks are the motion and two measurements, not the extrinsics")
        same(P, best, "all that was measured is used, and used once", tolerance=1e-6)


@exercise("initialization.2", "a landmark enters", seed=152)
def enter(candidate: Candidate, rng: Rng) -> None:
    """The covariance of the errors with the new one's appended, whatever rows it depends on."""
    sizes = (6, 2, [0, 1, 2]), (9, 3, [3, 4, 5, 6]), (8, 2, [0, 1, 6, 7]), (5, 1, [4, 0]), (3, 4, [0, 1, 2])
    for n, m, rows in cases(sizes, "{} numbers, a new landmark of {} that depends on rows {}"):
        A, G, B = (rng.standard_normal(shape) for shape in ((n, n), (m, len(rows)), (m, m)))
        P, noise, at = A @ A.T, B @ B.T, np.array(rows)
        found = covariance(candidate(P, at, G, noise), n + m)
        same(found[:n, :n], P, "what was there stays as it was")
        errors = np.block([[A, np.zeros((n, m))], [G @ A[at], B]])  # rows: errors, in draws
        same(found[n:, :n], errors[n:] @ errors[:n].T, "the new rows reach every old block")
        same(found, errors @ errors.T, "it is the covariance of the errors, old and new")


@exercise("initialization.3", "a landmark without an inverse model", seed=153)
def from_direct(candidate: Candidate, rng: Rng) -> None:
    """The limit of least squares with a landmark of which nothing was known."""
    models = [_polar(2.0, 0.5, 0.3), _polar(9.0, -2.0, 1.2)]
    models += [(rng.standard_normal((m, k)), rng.standard_normal((m, m)) + 2 * np.eye(m)) for m, k in ((1, 1), (3, 6))]
    sizes = [(*H_r.shape, H_r, H_l) for H_r, H_l in models]
    for m, k, H_r, H_l in cases(sizes, "a measurement of {} numbers and a robot of {}"):
        A, B = rng.standard_normal((k, k)), rng.standard_normal((m, m))
        P, R = 0.1 * A @ A.T + 0.01 * np.eye(k), 0.1 * B @ B.T + 0.01 * np.eye(m)
        corner, cross = parts(candidate(H_r, H_l, P, R), {"P_ll": (m, m), "P_lr": (m, k)})
        covariance(corner, m, "P_ll")
        H, unknown = np.hstack([H_r, H_l]), np.zeros((k, m))
        prior = np.block([[P, unknown], [unknown.T, UNKNOWN * np.eye(m)]])
        best = least_squares(np.zeros(k + m), prior, [(H, np.zeros(m), R)])[1]
        same(corner, best[k:, k:], "P_ll is that of an update without a prior", tolerance=1e-5)
        same(cross, best[k:, :k], "P_lr is that of an update without a prior", tolerance=1e-5)
        joint = np.block([[P, cross.T], [cross, corner]])
        shared = np.abs((H @ joint)[:, :k]).max() / max(1, np.abs(joint).max())
        what = "what the sensor sees of the two errors together is its own noise, which the robot does not share"
        holds(shared < 1e-9, what, "the expected measurement's error is correlated with the robot's")


def _polar(distance: float, bearing: float, heading: float) -> tuple[Array, Array]:
    """Jacobians of range and bearing by a planar pose (x, y, heading) and by a point."""
    c, s = np.cos(bearing + heading), np.sin(bearing + heading)
    H_l = np.array([[c, s], [-s / distance, c / distance]])
    return np.hstack([-H_l, [[0], [-1]]]), H_l
