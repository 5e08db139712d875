"""Maps and scores of patches beside those that the active search uses, which slamlib.vision has. Chapter active_search.

By zoom and roll, as the toolbox's manual has it; by the homography of a plane, for cameras without distortion. The
manual's scores ssd and census (section 6.1.2); and how well a patch's position can be known.
"""

import numpy as np

from slamlib.errors import SingularPointError
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array
from slamlib.vision.patches import as_floats, as_pair, grey


def zoom_and_roll(relative: Array, point: Array) -> tuple[float, float]:
    """Zoom and roll of the new camera's view of a homogeneous point (4,) of the old one, relative to the old view.

    Zoom: the quotient of the depths, old by new, along the optical axes. Roll [rad]: of the image's content, from u
    towards v; of all rotations about the axis the nearest to R. Section 6.1.3, step 2e of the toolbox's manual.
    """
    R = rotation(relative[3:])
    depth = (R @ point[:3] + relative[:3] * point[3])[2]
    if not (point[2] > 0 and depth > 0):
        raise SingularPointError("zoom_and_roll: the point is not in front of both cameras, so it has no zoom")
    return float(point[2] / depth), float(np.arctan2(R[1, 0] - R[0, 1], R[0, 0] + R[1, 1]))


def similarity(zoom: float, roll: float) -> Array:
    """The map (3, 3) of a patch that is seen `zoom` times larger and rotated by `roll` [rad]."""
    c, s = np.cos(roll) / zoom, np.sin(roll) / zoom
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])


def plane_homography(K_new: Array, K_old: Array, relative: Array, plane: Array) -> Array:
    """K_new (R + t m') K_old^-1 (3, 3): takes pixels (u, v, 1) of a plane from the old image to the new one.

    For cameras without distortion, K = [[au, 0, u0], [0, av, v0], [0, 0, 1]]. Hartley and Zisserman (2004), sec. 13.1.
    """
    return K_new @ (rotation(relative[3:]) + np.outer(relative[:3], plane)) @ np.linalg.inv(K_old)


def offsets_map(H: Array, old: Array) -> Array:
    """The map between offsets of a homography (3, 3) from old to new pixels, about an old pixel (2,) and its image."""
    image = H @ np.array([*old, 1])
    from_new, to_old = np.eye(3), np.eye(3)
    from_new[:2, 2], to_old[:2, 2] = image[:2] / image[2], -np.asarray(old)
    result: Array = to_old @ np.linalg.solve(H, from_new)
    return result / result[2, 2]


def ssd(a: Array, b: Array) -> Array:
    """Root of the mean squared difference (...) of patches (..., h, w), in grey levels: 0 for equal ones.

    The name is that of the sum of squared differences, whose order it keeps; the toolbox's has the same scale.
    """
    first, second = as_pair(a, b, "ssd")
    return np.sqrt(((first - second) ** 2).mean((-2, -1)))


def census(a: Array, b: Array) -> Array:
    """Share (...) of the pixels of patches (..., h, w) that are brighter than the centre in both, or in none.

    1 for equal patches; invariant to monotonically increasing changes of the grey levels. Zabih and Woodfill (1994).
    """
    first, second = as_pair(a, b, "census")
    brighter = [x > x[..., x.shape[-2] // 2, None, x.shape[-1] // 2, None] for x in (first, second)]
    return (brighter[0] == brighter[1]).mean((-2, -1))


def matching_covariance(patch: Array, sigma: float, free: bool = False) -> Array:
    """Covariance (2, 2) [px^2] of the matched position of a patch (h, w), for differences with noise sigma per pixel.

    sigma^2 (sum of g g')^-1 over the patch; two images with noise s differ by sigma = s sqrt(2). free: gain and offset
    are unknown, as for ZNCC: the components of the gradients along either give no information on the position. Raises
    SingularPointError for a patch without texture along some direction.
    """
    pixels = as_floats(grey(patch, "matching_covariance"), "matching_covariance")
    gv, gu = np.gradient(pixels)
    slopes = np.stack([gu.ravel(), gv.ravel()], axis=1)
    if free:
        known = np.linalg.qr(np.stack([np.ones(pixels.size), pixels.ravel()], axis=1))[0]
        slopes = slopes - known @ (known.T @ slopes)
    S = slopes.T @ slopes
    if np.linalg.eigvalsh(S)[0] <= 1e-9 * max(np.trace(S), 1e-300):
        raise SingularPointError("matching_covariance: the patch has no texture along some direction; it slides there")
    return sigma**2 * np.linalg.inv(S)
