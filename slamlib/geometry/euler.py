"""Euler angles (roll, pitch, yaw) [rad]: first yaw about z, then pitch about the new y, then roll about the new x."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.geometry.quaternion import UnitQuaternion, product, rotation
from slamlib.models import model


@model(angles=3)
def to_rotation(angles):
    """Rotation matrix Rz(yaw) Ry(pitch) Rx(roll). Chapter frames_and_quaternions, eq. (fq-euler)."""
    (cr, cp, cy), (sr, sp, sy) = (cos(a) for a in angles), (sin(a) for a in angles)
    return np.array([
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ])  # fmt: skip


@model(angles=3, returns=UnitQuaternion)
def to_quaternion(angles):
    """Unit quaternion of the three rotations. Chapter frames_and_quaternions, eq. (fq-euler-q)."""
    roll, pitch, yaw = angles / 2
    about_x = np.array([cos(roll), sin(roll), 0, 0])
    about_y = np.array([cos(pitch), 0, sin(pitch), 0])
    about_z = np.array([cos(yaw), 0, 0, sin(yaw)])
    return product(about_z, product(about_y, about_x))


@model(matrix=(3, 3))
def yaw_of(matrix):
    """Heading of the frame's x axis [rad]; 0 when that axis is vertical. Eq. (fq-yaw)."""
    return arctan2(matrix[1, 0], matrix[0, 0])


@model(matrix=(3, 3), yaw=())
def roll_pitch_of(matrix, yaw):
    """Roll and pitch [rad], once the yaw is undone; valid at pitch 90 degrees too. Eq. (fq-unwound)."""
    x_ahead = cos(yaw) * matrix[0, 0] + sin(yaw) * matrix[1, 0]
    y_left = cos(yaw) * matrix[1, 1] - sin(yaw) * matrix[0, 1]
    z_right = sin(yaw) * matrix[0, 2] - cos(yaw) * matrix[1, 2]
    return np.array([arctan2(z_right, y_left), arctan2(-matrix[2, 0], x_ahead)])


def from_rotation(matrix):
    """Angles (..., 3) of matrices (..., 3, 3); at pitch 90 degrees yaw is 0 (of -0 or rounding, any), roll the rest."""
    yaw = yaw_of(matrix)
    return np.concatenate([roll_pitch_of(matrix, yaw), np.asarray(yaw)[..., None]], axis=-1)


def from_rotation_jac(matrix):
    """Angles and their Jacobian (..., 3, 3, 3) w.r.t. the matrix; SingularPointError where x is exactly vertical."""
    yaw, by_matrix = yaw_of.jac(matrix)
    rest, partial = roll_pitch_of.jac(matrix, yaw)
    total = partial.matrix + partial.yaw[..., None, None] * by_matrix.matrix[..., None, :, :]
    angles = np.concatenate([rest, np.asarray(yaw)[..., None]], axis=-1)
    return angles, np.concatenate([total, by_matrix.matrix[..., None, :, :]], axis=-3)


@model(q=UnitQuaternion)
def half_sums(q):
    """The angles of a unit quaternion, roll and yaw up to whole turns; exact near the vertical too. Eq. (fq-half)."""
    w, x, y, z = q
    half_sum, half_difference = arctan2(x + z, w - y), arctan2(z - x, w + y)  # of yaw and roll
    level = ((w - y) * (w - y) + (x + z) * (x + z)) * ((w + y) * (w + y) + (z - x) * (z - x))
    pitch = arctan2(2 * (w * y - x * z), sqrt(level))
    return np.array([half_sum - half_difference, pitch, half_sum + half_difference])


def from_quaternion(q):
    """Angles (..., 3) of unit quaternions (..., 4), as from `from_rotation`."""
    return from_rotation(rotation(q))


def from_quaternion_jac(q):
    """Angles and their Jacobian (..., 3, 3) w.r.t. an orientation error: a rotation vector in the frame's axes.

    Raises SingularPointError where the x axis is exactly vertical. Chapter frames_and_quaternions, eq. (fq-euler-jac).
    """
    _, jacobians = half_sums.jac(q)
    return from_quaternion(q), jacobians.q
