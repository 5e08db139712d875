"""Observation of a landmark and its update, (5.24) to (5.32), and the initialization of a new one, (5.33) to (5.35)."""

import numpy as np

from slambook.report.angles import rotation
from slambook.report.motion import by_angles
from slamlib.manifolds import Array


def by_vectors(pose: Array, points: Array) -> Array:
    """(5.24), (5.25) corrected: points (..., m, 3) relative to the poses (..., 6), R'(m - t)."""
    return (points - pose[..., None, :3]) @ rotation(pose[..., 3:])


def by_matrices(pose: Array, points: Array) -> Array:
    """(5.24), (5.25), as printed: each landmark as a 4x4 matrix with a zero block (E11)."""
    T = np.zeros((*pose.shape[:-1], 4, 4))
    T[..., :3, :3], T[..., :3, 3], T[..., 3, 3] = rotation(pose[..., 3:]), pose[..., :3], 1
    M = np.zeros((*points.shape[:-1], 4, 4))
    M[..., :3, 3], M[..., 3, 3] = points, 1
    return (np.linalg.inv(T)[..., None, :, :] @ M)[..., :3, 3]


def by_pose(pose: Array, points: Array) -> Array:
    """Derivative (..., m, 3, 6) of the relative point w.r.t. the pose, which is missing in the report (E27)."""
    R, d = rotation(pose[..., 3:]), points - pose[..., None, :3]
    axes = np.broadcast_to(np.eye(3).reshape(3, *[1] * (pose.ndim - 1), 3), (3, *pose.shape[:-1], 3))
    turned = np.stack([by_angles(pose[..., 3:], axis) for axis in axes], -3)  # by axis, row, angle
    left = np.broadcast_to(-R.swapaxes(-1, -2)[..., None, :, :], (*d.shape, 3))
    return np.concatenate([left, np.einsum("...kia,...mi->...mka", turned, d)], -1)


def scalar_variance(hx: Array, hm: Array, Pxx: Array, Pmx: Array, Pmm: Array) -> Array:
    """(5.27) corrected, without R: h P h' of one component, from the blocks that it touches."""
    return _form(hx, Pxx, hx) + 2 * _form(hm, Pmx, hx) + _form(hm, Pmm, hm)


def last_factor_by_point(hx: Array, hm: Array, Pxx: Array, Pmx: Array, Pmm: Array) -> Array:
    """(5.27), as printed: the last factor of the mixed term is a derivative w.r.t. x_i; NumPy refuses (E13)."""
    return _form(hx, Pxx, hx) + 2 * _form(hm, Pmx, hm) + _form(hm, Pmm, hm)


def _form(left: Array, matrix: Array, right: Array) -> Array:
    return (left[..., None, :] @ matrix @ right[..., :, None])[..., 0, 0]


def whitened(R: Array, *rows: Array) -> tuple[Array, ...]:
    """Variances (..., 3) and rows (..., 3, n) of independent numbers: L^-1 rows, with R = L L'."""
    L = np.linalg.cholesky(R)
    return (np.ones(R.shape[:-1]), *(np.linalg.solve(L, row) for row in rows))


def diagonal_only(R: Array, *rows: Array) -> tuple[Array, ...]:
    """(5.27), as printed: R_jj, without the entries beside the diagonal (E17)."""
    return (np.diagonal(R, axis1=-2, axis2=-1), *rows)


def batch(x: Array, P: Array, difference: Array, H: Array, R: Array) -> tuple[Array, Array]:
    """(3.11) to (3.14): one update by all m components. difference (..., m), H (..., m, n), R (..., m, m)."""
    HP = H @ P
    K = np.linalg.solve(HP @ H.swapaxes(-1, -2) + R, HP).swapaxes(-1, -2)
    return x + (K @ difference[..., None])[..., 0], P - K @ HP


def placed(pose: Array, seen: Array) -> Array:
    """(5.33): points (..., m, 3) in the world, t + R z."""
    return pose[..., None, :3] + seen @ rotation(pose[..., 3:]).swapaxes(-1, -2)


def placed_by_pose(pose: Array, seen: Array) -> Array:
    """Derivative (..., m, 3, 6) of (5.33) w.r.t. the pose: identity, and F14 to F36 of (5.20) with z for u (E23)."""
    orientation = np.broadcast_to(pose[..., None, 3:], seen.shape)
    left = np.broadcast_to(np.eye(3), (*seen.shape, 3))
    return np.concatenate([left, by_angles(orientation, seen)], -1)


def each_alone(corner: Array) -> Array:
    """First term of (5.35) for each new landmark, and nothing between them (E18)."""
    blocks = np.kron(np.eye(corner.shape[-1] // 3), np.ones((3, 3)))
    return corner * blocks
