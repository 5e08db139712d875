"""Maps of patches beside those that the active search uses, as slamlib.vision.warping has them. Chapter active_search.

By zoom and roll, as the toolbox's manual has it; by the homography of a plane, for cameras without distortion.
"""

import numpy as np

from slamlib.errors import SingularPointError
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array


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
