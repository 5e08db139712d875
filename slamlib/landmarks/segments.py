"""The visible part of a segment: clipped to the image's border before it is projected. Chapter segments.

A plane through the camera's centre bounds the half-space of the points h with a . h >= 0. Four of them, through the
four sides of the image, bound all that a pin-hole camera sees, and exclude what lies behind it. Clipping before the
division by the depth needs no special case for endpoints behind the camera, nor for endpoints at infinity.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Mask, finite

PIXELS = np.array([0.0, 0.0, 1.0, 1.0])  # the "intrinsics" of points that are pixels already


class Segment(NamedTuple):
    """Pixels (..., 4) of both endpoints, (u, v, u, v), and the mask (...) of visible segments; others are nan."""

    pixels: Array
    seen: Mask


def frustum(intrinsics: Array, image: ArrayLike, margin: float = 0.0) -> Array:
    """Four planes (4, 3) through the camera and the image's sides, moved in by `margin` [px]. Eq. (li-frustum)."""
    u, v, fu, fv = finite(np.asarray(intrinsics, dtype=float), (4,), "frustum", "intrinsics")
    width, height = finite(np.asarray(image, dtype=float), (2,), "frustum", "image")
    if not min(width, height) > 2 * margin:
        raise SlamlibError(f"frustum: an image of {width:g} x {height:g} px has nothing inside a margin of {margin:g}")
    left, right, top, low = margin, width - margin, margin, height - margin
    return np.array([[fu, 0, u - left], [-fu, 0, right - u], [0, fv, v - top], [0, -fv, low - v]])


def clip(first: Array, second: Array, planes: Array) -> tuple[Array, Array, Mask]:
    """Clip segments between homogeneous points to the planes (k, 3): endpoints (..., 3), and the mask of those left.

    first, second: (..., 4) with w >= 0, in the camera's frame; w = 0 makes a half-line. Eq. (li-clip).
    """
    first, second = _finite_side(first), _finite_side(second)
    at_first, at_second = first[..., :3] @ planes.T, second[..., :3] @ planes.T
    enters, leaves = (at_first < 0) & (at_second >= 0), (at_first >= 0) & (at_second < 0)
    change = at_first - at_second
    at = at_first / np.where(change == 0, 1, change)
    start, end = np.where(enters, at, 0).max(-1), np.where(leaves, at, 1).min(-1)
    seen = (start <= end) & ~((at_first < 0) & (at_second < 0)).any(-1)
    endpoints = [(1 - s)[..., None] * first[..., :3] + s[..., None] * second[..., :3] for s in (start, end)]
    return endpoints[0], endpoints[1], seen


def visible(
    first: Array,
    second: Array,
    intrinsics: Array,
    image: ArrayLike,
    *,
    minimum_length: float = 1.0,
    margin: float = 0.0,
) -> Segment:
    """Project segments between homogeneous points (..., 4) of its frame into an ideal pin-hole camera's image.

    A segment that is shorter than `minimum_length` [px] in the image is not visible.
    """
    start, end, seen = clip(first, second, frustum(intrinsics, image, margin))
    seen = seen & (start[..., 2] > 0) & (end[..., 2] > 0)
    depths = [np.where(seen, h[..., 2], 1)[..., None] for h in (start, end)]
    scale, centre = np.asarray(intrinsics)[2:], np.asarray(intrinsics)[:2]
    pixels = np.concatenate([centre + scale * h[..., :2] / z for h, z in zip((start, end), depths, strict=True)], -1)
    seen = seen & (length(pixels) >= minimum_length)
    return Segment(np.where(seen[..., None], pixels, np.nan), seen)


def trim(segment: Array, image: ArrayLike, *, minimum_length: float = 1.0, margin: float = 0.0) -> Segment:
    """Clip segments (..., 4), pixels already, to the image."""
    endpoints = _pixel(np.asarray(segment)[..., :2]), _pixel(np.asarray(segment)[..., 2:])
    return visible(*endpoints, PIXELS, image, minimum_length=minimum_length, margin=margin)


def span(line: Array, image: ArrayLike) -> Segment:
    """Clip infinite image lines (..., 3) to the image."""
    line, centre = np.asarray(line, dtype=float), np.asarray(image) / 2
    norm = np.linalg.norm(line[..., :2], axis=-1, keepdims=True)
    normal = line[..., :2] / np.where(norm == 0, 1, norm)
    offset = (line[..., :2] @ centre + line[..., 2])[..., None] / np.where(norm == 0, 1, norm)
    foot = centre - offset * normal
    reach = np.hypot(*np.asarray(image)) * np.stack([normal[..., 1], -normal[..., 0]], -1)
    found = trim(np.concatenate([foot - reach, foot + reach], -1), image, minimum_length=0)
    seen = found.seen & (norm[..., 0] > 0)
    return Segment(np.where(seen[..., None], found.pixels, np.nan), seen)


def length(segment: Array) -> Array:
    """Lengths (...) [px] of segments (..., 4)."""
    return np.hypot(segment[..., 2] - segment[..., 0], segment[..., 3] - segment[..., 1])


def _finite_side(point: Array) -> Array:
    """The same point with w >= 0."""
    point = np.asarray(point, dtype=float)
    return np.where(point[..., 3:] < 0, -point, point)


def _pixel(pixel: Array) -> Array:
    one = np.ones((*pixel.shape[:-1], 1))
    return np.concatenate([pixel, one, one], -1)
