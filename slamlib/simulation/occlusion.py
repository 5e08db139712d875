"""Occlusion by opaque triangles: the region hidden behind a triangle, seen from the eye, is a convex cone (shadow).

A shadow is bounded by four planes: three through the eye and a side of the triangle, and the triangle's own. A point
inside all four is hidden; a point on the triangle, such as a window's frame, is visible. A shadow hides one interval
of a segment; what is seen of a segment is the longest interval that no shadow hides.
"""

import numpy as np

from slamlib.manifolds import Array, Mask

CLEARANCE = 1e-6  # [m]: a shadow starts so far behind its triangle, and is so much wider: no slits at common sides


def shadows(faces: Array, eye: Array) -> Array:
    """Planes (f, 4, 4): a point (p, 1) is in the shadow of a triangle (3, 3) if all four products are positive [m]."""
    corners = faces - eye
    first, second, third = (np.roll(corners, -i, 1) for i in range(3))
    sides = _toward(np.cross(first, second), third)
    own = _toward(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), corners[:, 0])
    height = (own * corners[:, 0]).sum(-1)
    own[height < CLEARANCE] = 0  # seen edge-on, a triangle hides nothing
    offsets = np.concatenate([np.full(sides.shape[:2], CLEARANCE), -height[:, None] - CLEARANCE], 1)
    normals = np.concatenate([sides, own[:, None]], 1)
    return np.concatenate([normals, (offsets - normals @ eye)[..., None]], -1)


def _toward(normals: Array, points: Array) -> Array:
    """Unit normals, oriented toward the points; zero where the orientation is undefined."""
    side = np.sign((normals * points).sum(-1, keepdims=True))
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    return side * normals / np.where(length > 0, length, 1)


def hidden(points: Array, faces: Array, eye: Array) -> Mask:
    """Mask (n,) of the points (n, 3) that opaque triangles (f, 3, 3) hide from the eye (3,)."""
    if not len(faces):
        return np.zeros(len(points), bool)
    return np.any((_heights(points, shadows(faces, eye)) > 0).all(0), axis=-1)


def longest_seen(segments: Array, faces: Array, eye: Array) -> tuple[Array, Mask]:
    """Endpoints (k, 2, 3) of the longest visible part of each segment (k, 2, 3), and the mask (k,) of those visible."""
    if not len(faces):
        return segments, np.ones(len(segments), bool)
    begins, ends = _stretches(segments, shadows(faces, eye))
    order = np.argsort(begins, 1)
    begins, ends = np.take_along_axis(begins, order, 1), np.take_along_axis(ends, order, 1)
    edge = np.zeros((len(segments), 1))
    starts = np.concatenate([edge, np.maximum.accumulate(ends, 1)], 1)  # a gap lies between all that is hidden so far
    stops = np.concatenate([begins, edge + 1], 1)  # and where the next shadow starts
    best = np.argmax(stops - starts, 1)[:, None]
    low, high = np.take_along_axis(starts, best, 1), np.take_along_axis(stops, best, 1)
    first, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    return np.stack([first + low * along, first + high * along], 1), (high > low)[:, 0]


def _stretches(segments: Array, planes: Array) -> tuple[Array, Array]:
    """Where each shadow starts and stops (k, f), as fractions of a segment's length; both 0 where nothing is hidden."""
    first, second = (_heights(segments[:, i], planes) for i in (0, 1))
    change = first - second
    at = np.clip(first / np.where(change == 0, 1, change), 0, 1)
    begin = np.where(first <= 0, at, 0).max(0)
    end = np.where(second <= 0, at, 1).min(0)
    none = ((first <= 0) & (second <= 0)).any(0) | (begin >= end)
    return np.where(none, 0, begin), np.where(none, 0, end)


def _heights(points: Array, planes: Array) -> Array:
    """Heights (4, n, f) [m] of points (n, 3) above the four planes (f, 4, 4) of each shadow."""
    planes = planes.transpose(1, 2, 0)
    return points @ planes[:, :3] + planes[:, 3:]
