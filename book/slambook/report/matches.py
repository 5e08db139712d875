"""A control from two pictures: the motion that brings the points of one upon those of the next (section 5.2.2)."""

import numpy as np

from slambook.report import angles
from slambook.report.motion import by_angles
from slamlib.manifolds import Array


def others(own: Array, other: Array) -> Array:
    """The control comes from matches that the correction does not use."""
    return other


def the_same(own: Array, other: Array) -> Array:
    """The control comes from the same matches as the correction (E21)."""
    return own


def aligned(before: Array, after: Array, sigma: float) -> tuple[Array, Array]:
    """Control (..., 6) and its covariance (..., 6, 6): before = R after + t, both (..., m, 3) with this deviation.

    Least squares by the singular value decomposition; its answer is already the robot's motion, not PnP's inverse.
    """
    a, b = before.mean(-2, keepdims=True), after.mean(-2, keepdims=True)
    U, _, Vt = np.linalg.svd((before - a).swapaxes(-1, -2) @ (after - b))
    flip = np.ones(U.shape[:-1])
    flip[..., 2] = np.linalg.det(U @ Vt)
    R = (U * flip[..., None, :]) @ Vt
    t = (a - b @ R.swapaxes(-1, -2))[..., 0, :]
    turn = angles.extracted(R)
    by_turn = by_angles(np.broadcast_to(turn[..., None, :], after.shape), after)
    J = np.concatenate([np.broadcast_to(np.eye(3), by_turn.shape), by_turn], -1)
    information = np.einsum("...mij,...mik->...jk", J, J) / (2 * sigma**2)
    return np.concatenate([t, turn], -1), np.linalg.inv(information)
