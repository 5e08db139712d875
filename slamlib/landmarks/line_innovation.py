"""Residuals of a measured segment from the predicted line, in three variants."""

import numpy as np

from slamlib.analytic import arctan2, sqrt
from slamlib.models import model


@model(segment=4)
def image_line(segment):
    """Homogeneous image line through the endpoints (u, v, u, v) [px] of a segment. Eq. (li-image)."""
    a, b, c, d = segment
    return np.array([b - d, c - a, a * d - b * c])


@model(line=3, segment=4)
def distances(line, segment):
    """Signed distances [px] of the segment's endpoints from a line. Chapter lines, eq. (li-ortdst)."""
    a, b, c = line
    length = sqrt(a * a + b * b)
    first, second = segment[:2], segment[2:]
    return np.array([line[:2] @ first + c, line[:2] @ second + c]) / length


@model(line=3, segment=4, origin=2)
def rho_theta(line, segment, origin):
    """Segment minus line: distance from `origin` [px] and direction of the normal [rad]. Eq. (li-rhothe).

    The line's sign is that of `oriented`.
    """
    m, e = (x / sqrt(x[:2] @ x[:2]) for x in (image_line(segment), line))
    rho = (e[:2] @ origin + e[2]) - (m[:2] @ origin + m[2])
    return np.array([rho, arctan2(e[0] * m[1] - e[1] * m[0], e[:2] @ m[:2])])


def oriented(line, segment):
    """Lines (..., 3) with the sign for which their normals point to the side of the segments' (..., 4)."""
    along = np.stack([segment[..., 1] - segment[..., 3], segment[..., 2] - segment[..., 0]], axis=-1)
    return np.where((line[..., :2] * along).sum(-1, keepdims=True) < 0, -line, line)


@model(line=6, rays=6)
def angles(line, rays):
    """Sines of the angles of two unit rays with the plane of line and camera. Chapter lines, eq. (li-angles)."""
    n = line[:3]
    return np.array([n @ rays[:3], n @ rays[3:]]) / sqrt(n @ n)
