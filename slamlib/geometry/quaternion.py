"""Quaternions (w, x, y, z), Hamilton product, local to global: q rotates vectors of the frame into the world.

Here a frame is turned by 60 degrees about the z axis, and the first column of its matrix is its x axis in the world:

    >>> import numpy as np
    >>> import slamlib as sl
    >>> q = sl.quaternion.exponential([0, 0, np.pi / 3])
    >>> sl.quaternion.rotation(q).round(3)[:, 0].tolist()
    [0.5, 0.866, 0.0]
"""

import numpy as np

from slamlib.analytic import arctan_ratio, sqrt, stumpff
from slamlib.manifolds import CustomManifold
from slamlib.models import model


@model(q=4)
def left_matrix(q):
    """The matrix of `q (x) p` as a linear function of p. Chapter frames_and_quaternions, eq. (fq-left)."""
    w, x, y, z = q
    return np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]])


@model(q=4)
def right_matrix(q):
    """The matrix of `p (x) q` as a linear function of p. Chapter frames_and_quaternions, eq. (fq-right)."""
    w, x, y, z = q
    return np.array([[w, -x, -y, -z], [x, w, z, -y], [y, -z, w, x], [z, y, -x, w]])


@model(q=4)
def pi_matrix(q):
    """The 4 x 3 matrix of `q (x) (0, v)`, so that dq/dt = pi_matrix(q) @ omega / 2. Eq. (fq-pi)."""
    return left_matrix(q)[:, 1:]


@model(left=4, right=4)
def product(left, right):
    """Hamilton product: the rotation `right`, then `left`. Chapter frames_and_quaternions, eq. (fq-product)."""
    return left_matrix(left) @ right


@model(q=4)
def conjugate(q):
    """The inverse rotation, of a unit quaternion. Chapter frames_and_quaternions, eq. (fq-conjugate)."""
    w, x, y, z = q
    return np.array([w, -x, -y, -z])


@model(vector=3)
def exponential(vector):
    """Quaternion of a rotation vector [rad], smooth at zero. Chapter frames_and_quaternions, eq. (fq-exp)."""
    quarter = vector @ vector / 4
    return np.concatenate([np.array([stumpff(0, quarter)]), stumpff(1, quarter) * vector / 2])


@model(q=4)
def logarithm(q):
    """Rotation vector [rad] of a quaternion, at most pi long; equal for -q except at a half turn. Eq. (fq-log)."""
    return 2 * arctan_ratio(q[1:] @ q[1:], q[0]) * q[1:]


@model(q=4, step=3)
def plus(q, step):
    """Rotate q by a rotation vector given in its own axes. Chapter frames_and_quaternions, eq. (fq-plus)."""
    return product(q, exponential(step))


@model(q=4, origin=4)
def minus(q, origin):
    """Rotation vector, in the axes of `origin`, from `origin` to q. Eq. (fq-minus)."""
    return logarithm(product(conjugate(origin), q))


UnitQuaternion = CustomManifold("unit quaternion", size=4, dof=3, plus=plus, minus=minus)


@model(q=UnitQuaternion)
def rotation(q):
    """Rotation matrix: its columns are the frame's axes in the world. Eq. (fq-rotation)."""
    w, x, y, z = q
    return np.array([
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ])  # fmt: skip


@model(matrix=(3, 3), pivot=4)
def from_rotation(matrix, pivot):
    """Unit quaternion of a rotation matrix, for any pivot with pivot @ q > 0. Eq. (fq-from)."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    outer = np.array([  # 4 q q', of first degree in the matrix
        [1 + a + e + i, h - f, c - g, d - b],
        [h - f, 1 + a - e - i, b + d, c + g],
        [c - g, b + d, 1 - a + e - i, f + h],
        [d - b, c + g, f + h, 1 - a - e + i],
    ])  # fmt: skip
    column = outer @ pivot
    return column / (2 * sqrt(pivot @ column))


def best_pivot(matrix):
    """The unit vector (4,) of the quaternion's largest component, for matrices (..., 3, 3): the safest pivot."""
    a, e, i = np.moveaxis(np.diagonal(matrix, axis1=-2, axis2=-1), -1, 0)
    squares = np.stack([a + e + i, a - e - i, e - a - i, i - a - e], axis=-1)
    return np.eye(4)[np.argmax(squares, axis=-1)]
