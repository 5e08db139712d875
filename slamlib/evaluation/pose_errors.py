"""The error of an estimated pose, linear or invariant, and its NEES.

The linear error keeps displacement and rotation apart. The right-invariant error is the motion of the world that would
bring the estimate to the truth, xi = log(X_true X^-1); it is what `error="world"` keeps the covariance of, written in
the linear error's coordinates by N, the error that a small motion of the world makes: e = N xi. For small errors both
are the same, for large ones a Gaussian of the one is none of the other. Chapter observability.
"""

from collections.abc import Callable

import numpy as np

from slamlib.evaluation.consistency import nees_in_range
from slamlib.geometry.pose import Pose, logarithm, relative
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array

UNITS = (3, 3)  # of a pose: positions and rotations


def invariant_error(true: Array, estimate: Array) -> Array:
    """Error (..., 6) of poses (..., 7), a displacement [m] in world axes and a rotation vector [rad] in the frame's.

    N log(X_true X^-1), which is log(X^-1 X_true) with its displacement turned into world axes: eq. (ob-invariant). So
    e' P^-1 e is the NEES of log(X_true X^-1) with the covariance L P L', L = N^-1; with the same rank where P is
    singular. In the plane it is the plane's own logarithm.
    """
    twist = logarithm(relative(estimate, true))
    along = rotation(estimate[..., 3:]) @ twist[..., :3, None]
    return np.concatenate([along[..., 0], twist[..., 3:]], axis=-1)


# What a covariance of a pose may be of, and the error that is judged by it: both in the same coordinates.
ERRORS: dict[str, Callable[[Array, Array], Array]] = {"linear": Pose.minus, "invariant": invariant_error}

KEPT = {False: "linear", True: "invariant"}  # of which a filter's covariances are: by `Options.carried`


def pose_nees(error: Array, covariance: Array, free: Array | None = None) -> tuple[float, int]:
    """NEES of an error (6,) of a pose by its covariance (6, 6), and its degrees of freedom.

    free (6, f): the directions in which the pose can be, each a position or a rotation, of which the NEES is; None:
    all. What of them is known exactly is not among the dof.
    """
    if free is None:
        return nees_in_range(error, covariance, UNITS)
    lengths = int(free[:3].any(0).sum())
    units = (lengths, free.shape[1] - lengths)
    return nees_in_range(free.T @ error, free.T @ covariance @ free, units)


def pose_error(
    true: Array, estimate: Array, covariance: Array, free: Array | None = None
) -> tuple[Array, Array, float, int]:
    """Error (6,) of a pose (7,), true minus estimate in the tangent space, its deviations (6,), its NEES with its dof.

    The error is the linear one; free: see `pose_nees`.
    """
    error, sigma = Pose.minus(true, estimate), np.sqrt(covariance.diagonal())
    return error, sigma, *pose_nees(error, covariance, free)
