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
from slamlib.errors import ShapeError, SingularPointError, SlamlibError
from slamlib.manifolds import CustomManifold, finite
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


@model(vector=3)
def skew(vector):
    """Matrix (3, 3) of the cross product: skew(a) @ b is a x b. Chapter frames_and_quaternions, eq. (fq-rodrigues)."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


@model(vector=3)
def right_jacobian(vector):
    """Matrix (3, 3): a change of a rotation vector [rad] as the rotation on the right of exp. Eq. (fq-right-jacobian).

    exp(vector + change) is exp(vector) (x) exp(right_jacobian(vector) @ change) to first order.
    """
    squared, across = vector @ vector, skew(vector)
    return np.eye(3, dtype=int) - stumpff(2, squared) * across + stumpff(3, squared) * across @ across


@model(vector=3)
def left_jacobian(vector):
    """Matrix (3, 3): the same change as the rotation on the left of exp: right_jacobian(-vector)."""
    return right_jacobian(-vector)


@model(vector=3)
def left_inverse(vector):
    """Inverse (3, 3) of the left Jacobian, for angles below a whole turn. Eq. (fq-jacobian-inverse-smooth)."""
    half = vector / 2
    squared, across = half @ half, skew(half)
    bend = (stumpff(2, squared) - stumpff(3, squared)) / stumpff(1, squared)
    return np.eye(3, dtype=int) - across + bend * across @ across


def left_jacobian_inverse(vector):
    """Inverse (..., 3, 3) of the left Jacobian; SingularPointError at whole turns, where it has none."""
    return _no_whole_turn(left_inverse(vector), "left_jacobian_inverse")


def right_jacobian_inverse(vector):
    """Inverse (..., 3, 3) of the right Jacobian; SingularPointError at whole turns. Eq. (fq-right-jacobian-inverse)."""
    return _no_whole_turn(np.swapaxes(left_inverse(vector), -1, -2), "right_jacobian_inverse")


def _no_whole_turn(inverse, name):
    # the trace is 1 + t cot(t/2) of the angle t: without a digit where rounding cannot tell t from a whole turn
    if (np.abs(np.trace(inverse, axis1=-2, axis2=-1)) > 0.25 / np.finfo(float).eps).any():
        raise SingularPointError(
            f"{name}: a rotation vector is a whole turn long, where the Jacobian has no inverse; "
            "logarithm(exponential(vector)) is the same rotation, at most half a turn long"
        )
    return inverse


def slerp(start, end, share):
    """The orientation at a share (...), 0 to 1, of the shortest turn from `start` to `end` (..., 4). Eq. (fq-slerp).

    At exactly half a turn both ways are equally long: `end` and -`end` then lead along opposite ones. Raises UnitError.
    """
    whole = minus(end, start)
    UnitQuaternion.check(np.asarray(start, dtype=float), "slerp: argument 'start'")
    UnitQuaternion.check(np.asarray(end, dtype=float), "slerp: argument 'end'")
    return plus(start, np.asarray(share)[..., None] * whole)


def mean(quaternions, weights=None):
    """The rotation (..., 4) with the least weighted sum of squared angles to unit quaternions (..., n, 4).

    Of the two such quaternions the one on the side of the first. It is unique where all are less than a quarter turn
    from some rotation; in a wider set the one near the chordal mean. Weights (n,) or (..., n) are above or equal to
    zero. Raises ShapeError, UnitError, and SingularPointError where no rotation is preferred. Eq. (fq-mean).
    """
    points = finite(quaternions, None, "mean", "argument 'quaternions'")
    if points.ndim < 2 or points.shape[-1] != 4 or not points.shape[-2]:
        raise ShapeError(f"mean: quaternions should have shape (..., n, 4), n above 0, but have shape {points.shape}")
    UnitQuaternion.check(points, "mean: argument 'quaternions'")
    share = finite(np.ones(points.shape[-2]) if weights is None else weights, None, "mean", "argument 'weights'")
    if share.shape not in (points.shape[-2:-1], points.shape[:-1]):
        wanted = f"({points.shape[-2]},) or {points.shape[:-1]}"
        raise ShapeError(f"mean: weights should have shape {wanted}, but have shape {share.shape}")
    total = share.sum(-1, keepdims=True)
    if (share < 0).any() or not (total > 0).all():
        raise SlamlibError("mean: weights should be zero or above, and not all of them zero")
    share = share / total
    values, vectors = np.linalg.eigh(np.einsum("...n,...ni,...nj->...ij", share, points, points))
    if (values[..., 3] - values[..., 2] < 1e-12).any():
        raise SingularPointError(_NO_MEAN)
    found = vectors[..., 3]  # the chordal mean
    found = np.where((found * points[..., 0, :]).sum(-1, keepdims=True) < 0, -found, found)
    for _ in range(30):
        apart = minus(points, found[..., None, :])
        slope = np.einsum("...n,...ni->...i", share, apart)
        bend = np.einsum("...n,...nij->...ij", share, left_inverse(apart))
        step = np.linalg.solve((bend + np.swapaxes(bend, -1, -2)) / 2, slope[..., None])[..., 0]
        found = plus(found, step)
        if np.abs(step).max(initial=0) < 1e-9:  # Newton's steps: the next one would be below rounding
            return found
    raise SingularPointError(_NO_MEAN)


_NO_MEAN = "mean: the rotations are spread so widely that none is preferred; average groups within a quarter turn"
