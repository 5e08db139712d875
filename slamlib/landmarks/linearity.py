"""When may a point be converted to a Euclidean one? One rule for all parametrizations; and the inverse-distance prior.

Everything is stated through the homogeneous point (h, w) in a frame, which every parametrization offers, so that none
is treated specially here. Derived and proved in chapter points; the index is that of Civera, Davison and Montiel
(2007), generalised.
"""

import math

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import Array, Mask

THRESHOLD = 0.1  # of the linearity index, below which a point may become Euclidean; the toolbox's linTestIdp


def inverse_distance_prior(nearest: float) -> tuple[float, float]:
    """Mean and standard deviation [1/m] such that two of them reach from `nearest` [m] to infinity. Eq. (pt-prior)."""
    if not nearest > 0 or not math.isfinite(nearest):
        raise SlamlibError(f"inverse_distance_prior: the nearest distance should be positive and finite, got {nearest}")
    return 1 / (2 * nearest), 1 / (4 * nearest)


def linearity_index(kind: PointLandmark, mean: Array, covariance: Array, camera: Array) -> Array:
    """Nonlinearity (...) of a point's image within two of its standard deviations; 0 if linear. Eq. (pt-index).

    Four times the relative standard deviation of |h|. Means (..., size), the camera's pose (..., 7), and a covariance
    (..., dof, dof) of the landmark alone or (..., dof + 6, dof + 6) of landmark and camera, whose common error cancels.
    Infinite where the point is the camera's centre.
    """
    point, J, P = _seen(kind, mean, covariance, camera, "linearity_index")
    h = point[..., :3]
    return _index((h[..., None, :] @ J[..., :3, :])[..., 0, :], P, (h * h).sum(-1))


def euclidean_index(
    kind: PointLandmark, mean: Array, covariance: Array, camera: Array, by: Array | None = None
) -> Array:
    """The linearity index (...) that the point will have as a Euclidean one; arguments as there. Eq. (pt-index-euc).

    Four times the relative standard deviation of the distance |h| / w. Infinite for points at or beyond infinity. by:
    Jacobian (dof + 6, k) of landmark and camera w.r.t. the errors of the covariance (..., k, k), if it is of others.
    """
    point, J, P = _seen(kind, mean, covariance, camera, "euclidean_index", by)
    h, w = point[..., :3], point[..., 3]
    squared = (h * h).sum(-1)
    # w h' dh - |h|^2 dw, over w |h|^2: no division until the end
    row = w[..., None] * (h[..., None, :] @ J[..., :3, :])[..., 0, :] - squared[..., None] * J[..., 3, :]
    return _index(row, P, np.where(w > 0, w * squared, 0.0))


def should_convert(
    kind: PointLandmark,
    mean: Array,
    covariance: Array,
    camera: Array,
    threshold: float = THRESHOLD,
    by: Array | None = None,
) -> Mask:
    """Mask (...) of the points that may become Euclidean: those whose index will then be below the threshold."""
    return euclidean_index(kind, mean, covariance, camera, by) < threshold


def to_euclidean(kind: PointLandmark, mean: Array) -> tuple[Array, Array]:
    """Euclidean points (..., 3) of means (..., size), and the Jacobians (..., 3, dof) that propagate the covariance.

    In a map: belief.replace(block, 3, *to_euclidean(kind, block.mean)). Raises SingularPointError at infinity.
    """
    point, J = kind.to_point.jac(mean)
    return point, J.landmark


def beyond_infinity(kind: PointLandmark, mean: Array, covariance: Array, sigmas: float = 3.0) -> Mask:
    """Mask (...) of the points whose w is negative by more than `sigmas` standard deviations: delete those.

    An unbiased estimate of a far point has a smaller negative w half of the time: such points are kept unchanged.
    """
    point, J, P = _seen(kind, mean, covariance, ORIGIN, "beyond_infinity")
    row = J[..., 3, :]
    variance = (row[..., None, :] @ P @ row[..., None])[..., 0, 0]
    return point[..., 3] < -sigmas * np.sqrt(np.maximum(variance, 0))


def _seen(
    kind: PointLandmark, mean: Array, covariance: Array, camera: Array, function: str, by: Array | None = None
) -> tuple[Array, ...]:
    """Homogeneous point in the camera, its Jacobian w.r.t. the errors of the covariance, and the covariance."""
    point, J = kind.to_frame.jac(camera, mean)
    P, dof = np.asarray(covariance), kind.manifold.dof
    if by is not None:
        return point, J.landmark @ by[:dof] + J.pose @ by[dof:], P
    if P.shape[-2:] == (dof, dof):
        return point, J.landmark, P
    if P.shape[-2:] == (dof + 6, dof + 6):
        return point, np.concatenate([J.landmark, J.pose], axis=-1), P
    raise ShapeError(
        f"{function}: the covariance of {kind.name} should have shape (..., {dof}, {dof}), or (..., {dof + 6}, "
        f"{dof + 6}) with the camera's pose, but has shape {P.shape}"
    )


def _index(row: Array, covariance: Array, scale: Array) -> Array:
    """Four standard deviations of row @ error, divided by the scale; infinite where the scale is 0."""
    variance = (row[..., None, :] @ covariance @ row[..., None])[..., 0, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(scale > 0, 4 * np.sqrt(np.maximum(variance, 0)) / scale, math.inf)[()]
