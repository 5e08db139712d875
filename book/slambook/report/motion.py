"""Prediction: (5.5) to (5.23), and where the report's section 5.2.2 takes its control from."""

import numpy as np

from slambook.report import angles
from slambook.report.angles import rotation
from slamlib.manifolds import Array
from slamlib.motions.euler_composition import compose


def by_angles(orientation: Array, u: Array) -> Array:
    """F14 to F36 of (5.20), as printed: derivatives (..., 3, 3) of R u w.r.t. yaw, pitch, roll."""
    (cy, cp, cr), (sy, sp, sr) = np.moveaxis(np.cos(orientation), -1, 0), np.moveaxis(np.sin(orientation), -1, 0)
    xu, yu, zu = np.moveaxis(u, -1, 0)
    F14 = -sy * cp * xu + (-sy * sp * sr - cy * cr) * yu + (-sy * sp * cr + cy * sr) * zu
    F15 = -cy * sp * xu + cy * cp * sr * yu + cy * cp * cr * zu
    F16 = (cy * sp * cr + sy * sr) * yu + (-cy * sp * sr + sy * cr) * zu
    F24 = cy * cp * xu + (cy * sp * sr - sy * cr) * yu + (cy * sp * cr + sy * sr) * zu
    F25 = -sy * sp * xu + sy * cp * sr * yu + sy * cp * cr * zu
    F26 = (sy * sp * cr - cy * sr) * yu + (-sy * sp * sr - cy * cr) * zu
    F35 = -cp * xu - sp * sr * yu - sp * cr * zu
    F36 = cp * cr * yu - cp * sr * zu
    rows = (F14, F15, F16), (F24, F25, F26), (0 * F14, F35, F36)
    return np.stack([np.stack(row, -1) for row in rows], -2)


def inverse(motion: Array) -> Array:
    """The control from PnP's answer, which maps old coordinates to new ones: R_u = R', t_u = -R't (section 5.2.2)."""
    R = rotation(motion[..., 3:]).swapaxes(-1, -2)
    return np.concatenate([-(R @ motion[..., :3, None])[..., 0], angles.extracted(R)], -1)


def exact_by_pose(pose: Array, u: Array) -> Array:
    """Rows 4 to 6 of (5.20), corrected: derivative (..., 3, 3) of the new angles w.r.t. the old ones."""
    return compose.jac(pose, u)[1].pose[..., 3:, 3:]


def exact_by_control(pose: Array, u: Array) -> Array:
    """Last block of (5.21), corrected: derivative (..., 3, 3) of the new angles w.r.t. those of the control."""
    return compose.jac(pose, u)[1].control[..., 3:, 3:]


def identity(pose: Array, u: Array) -> Array:
    """Rows 4 to 6 of (5.20) and of (5.21), as printed (E07, E08)."""
    return np.broadcast_to(np.eye(3), (*u.shape[:-1], 3, 3))


def aligned(before: Array, after: Array, sigma: float) -> tuple[Array, Array]:
    """Control (..., 6) and its covariance (..., 6, 6): before = R after + t, both (..., m, 3) with this std.

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
