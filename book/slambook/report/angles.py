"""Rotation matrices from yaw, pitch, roll and back, (5.7) and (5.11) to (5.18); angles (..., 3) in that order [rad]."""

from collections.abc import Callable

import numpy as np

from slamlib.geometry import euler
from slamlib.manifolds import Array

Extraction = Callable[[Array], Array]


def rotation(angles: Array) -> Array:
    """(5.7), as printed: matrices (..., 3, 3)."""
    (cy, cp, cr), (sy, sp, sr) = np.moveaxis(np.cos(angles), -1, 0), np.moveaxis(np.sin(angles), -1, 0)
    rows = (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )
    return np.stack([np.stack(row, -1) for row in rows], -2)


def composed(angles: Array, turn: Array, extract: Extraction) -> Array:
    """Angles of the product of both rotations, as (5.6) requires."""
    return extract(rotation(angles) @ rotation(turn))


def added(angles: Array, turn: Array, extract: Extraction) -> Array:
    """(5.11) to (5.13), as printed: angles added one by one (E04)."""
    return wrapped(angles + turn)


def extracted(matrix: Array) -> Array:
    """Yaw, pitch, roll of rotation matrices; at pitch 90 degrees yaw is 0 (of -0 or rounding, any), roll the rest."""
    return euler.from_rotation(matrix)[..., ::-1]


def without_branch(matrix: Array) -> Array:
    """(5.15) to (5.18) with yaw and roll exchanged, and no word on pitch 90 degrees (E06)."""
    return as_printed(matrix)[..., ::-1]


def as_printed(matrix: Array) -> Array:
    """(5.15) to (5.18), as printed: yaw from R32 and R33, roll from R21 and R11 (E05)."""
    yaw = np.arctan2(matrix[..., 2, 1], matrix[..., 2, 2])  # (5.15)
    c2 = np.hypot(matrix[..., 2, 1], matrix[..., 2, 2])  # (5.16)
    pitch = np.arctan2(-matrix[..., 2, 0], c2)  # (5.17)
    roll = np.arctan2(matrix[..., 1, 0], matrix[..., 0, 0])  # (5.18)
    return np.stack([yaw, pitch, roll], -1)


def wrapped(angles: Array) -> Array:
    """The same angles between minus half a turn and half a turn."""
    return (angles + np.pi) % (2 * np.pi) - np.pi


def apart(one: Array, other: Array) -> Array:
    """Angle (...,) [rad] of the rotation from one orientation to the other."""
    trace = np.einsum("...ij,...ij->...", rotation(one), rotation(other))
    return np.arccos(np.clip((trace - 1) / 2, -1, 1))
