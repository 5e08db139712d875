"""Warping of patches: by zoom and rotation, an affine map, or the homography of a plane. Chapter active_search.

All maps are matrices (3, 3) that take an offset (u, v, 1) from the landmark's pixel in the new image to one from its
pixel in the old image, where the patch was taken: so a template is filled pixel by pixel, whatever the zoom. A pose
`relative` (7,) is the old camera's in the new camera's frame: X_new = R X_old + t. A plane is the vector m = n / d (3,)
[1/m] of the old frame, m'X = 1 for its points: m = 0 is infinitely far away.
"""

import numpy as np

from slamlib.errors import SingularPointError
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array, finite
from slamlib.sensors.sensor import Calibration
from slamlib.vision.patches import half_size, sample

_CORNERS = np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]])


def towards(pose: Array, point: Array) -> Array:
    """From poses (..., 7) to homogeneous points (..., 4) of the world: vectors (..., 3) of the world, times the last
    coordinate of the point, so that a point at infinity gives its direction."""
    return point[..., :3] - point[..., 3:] * pose[..., :3]


def angle(a: Array, b: Array) -> Array:
    """Angle (...) [rad] between vectors (..., 3)."""
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(-1))


def in_camera(pose: Array, point: Array) -> Array:
    """Homogeneous points (..., 4) of the world in the frames of poses (..., 7); a last coordinate 0 is infinity."""
    h = np.einsum("...ji,...j->...i", rotation(pose[..., 3:]), towards(pose, point))
    return np.concatenate([h, np.broadcast_to(point[..., 3:], (*h.shape[:-1], 1))], axis=-1)


def facing_plane(point: Array) -> Array:
    """The planes m (..., 3) through homogeneous points (..., 4) facing the camera: n = h / |h|, d = |h| / w."""
    h, w = point[..., :3], point[..., 3:]
    return w * h / (h * h).sum(-1, keepdims=True)


def affine(H: Array) -> Array:
    """The maps' first order (..., 3, 3): their Jacobians at the offset zero, whose image is kept."""
    slope = H[..., :2, :2] * H[..., 2:, 2:] - H[..., :2, 2:] * H[..., 2:, :2]
    result = np.zeros_like(H)
    result[..., :2, :2], result[..., 2, 2] = slope / H[..., 2:, 2:] ** 2, 1
    result[..., :2, 2:] = H[..., :2, 2:] / H[..., 2:, 2:]
    return result


def homography_through(source: Array, target: Array) -> Array:
    """The homographies (..., 3, 3), lower right 1, that take four points (..., 4, 2) to four others (..., 4, 2)."""
    source, target = np.broadcast_arrays(np.asarray(source, dtype=float), np.asarray(target, dtype=float))
    system = np.zeros((*source.shape[:-2], 2, 4, 8))
    for i in (0, 1):
        system[..., i, :, 3 * i : 3 * i + 2], system[..., i, :, 3 * i + 2] = source, 1
        system[..., i, :, 6:] = -target[..., i, None] * source
    right = target.swapaxes(-1, -2).reshape(*source.shape[:-2], 8, 1)
    try:
        found = np.linalg.solve(system.reshape(*source.shape[:-2], 8, 8), right)[..., 0]
    except np.linalg.LinAlgError:
        raise SingularPointError("homography_through: three of the four points lie on a line") from None
    return np.concatenate([found, np.ones((*found.shape[:-1], 1))], axis=-1).reshape(*found.shape[:-1], 3, 3)


def seen_by(calibration: Calibration, relative: Array, plane: Array, pixels: Array) -> Array:
    """Pixels (n, k, 2) of the old images that correspond to pixels (n, k, 2) of the new one, by n planes (n, 3).

    For any calibrated camera, with old poses `relative` (n, 7): back-projected, intersected with the plane, projected
    into the old camera. nan for a plane that a ray misses, or that a camera cannot see.
    """
    try:
        rays = calibration.sensor.back_project(pixels, np.zeros((*pixels.shape[:-1], 1)), **calibration.given)[..., :3]
    except SingularPointError:  # one pixel without a ray: the others one by one
        each = [i for i in range(len(pixels)) if len(pixels) > 1]
        alone = [seen_by(calibration, *(x[i : i + 1] for x in (relative, plane, pixels))) for i in each]
        return np.concatenate(alone) if alone else np.full(pixels.shape, np.nan)
    R, t = rotation(relative[:, 3:]), relative[:, None, :3]
    # m'X = 1 with X = R'(Y - t) is (R m)'Y = 1 + (R m)'t, positive for a camera on the old one's side of the plane.
    m = np.einsum("nij,nj->ni", R, plane)[:, :, None]
    side, w = 1 + t @ m, rays @ m
    points = np.concatenate([(rays * side - w * t) @ R, w], axis=-1)
    good = (side[:, 0, 0] > 0) & (w >= 0).all((1, 2)) & calibration.visible(points).all(-1)
    places = np.full(pixels.shape, np.nan)
    if good.any():
        places[good] = calibration.project(points[good])
    return places


def through_camera(calibration: Calibration, relative: Array, plane: Array, pixel: Array, size: int) -> Array:
    """The maps (n, 3, 3) of templates of `size` px around pixels (n, 2) of the new image: homographies through corners.

    For old poses `relative` (n, 7) and planes (n, 3); nan where a template cannot be seen on its plane by both.
    """
    corners = half_size(size, "through_camera") * _CORNERS
    old = seen_by(calibration, relative, plane, pixel[:, None] + np.concatenate([corners, np.zeros((1, 2))]))
    maps, known = np.full((len(old), 3, 3), np.nan), np.isfinite(old).all((1, 2))
    maps[known] = homography_through(corners, old[known, :4] - old[known, 4:])
    return maps


def stretch(H: Array) -> tuple[Array, Array]:
    """The least and the largest number (...) of old pixels along one new pixel, at the offset zero of maps (..., 3, 3).

    The singular values of their Jacobians; nan for a map of nan.
    """
    (a, b), (c, d) = np.moveaxis(affine(H)[..., :2, :2], (-2, -1), (0, 1))
    plus, minus = np.hypot(a + d, b - c), np.hypot(a - d, b + c)
    return abs(plus - minus) / 2, (plus + minus) / 2


def warp(reference: Array, centre: Array, H: Array, size: int) -> Array | None:
    """The template (size, size) that a map (3, 3) makes of a reference patch (h, w) around its pixel `centre` (2,).

    Bilinear; where a new pixel covers several old ones they are averaged, to avoid aliasing. None where it needs pixels
    outside of the reference.
    """
    half, centre = half_size(size, "warp"), finite(centre, (2,), "warp", "centre")
    counts = [max(1, round(float(n))) for n in np.hypot(*affine(H)[:2, :2])]
    # Each pixel is sampled `count` times, evenly over its width.
    u, v = ((np.arange(-half, half + 1)[:, None] + (np.arange(count) + 0.5) / count - 0.5).ravel() for count in counts)
    grid = np.stack([*np.broadcast_arrays(u, v[:, None]), np.ones((len(v), len(u)))], axis=-1)
    places = grid @ H.T
    if not (places[..., 2] > 0).all():
        return None
    values = sample(reference, places[..., :2] / places[..., 2:] + centre)
    template = values.reshape(size, counts[1], size, counts[0]).mean((1, 3))
    return None if np.isnan(template).any() else template
