"""Straight lines in Pluecker coordinates (n, v): v along the line, n = p x v for its points p.

n . v = 0, and only the ratio of the six numbers matters. Points are homogeneous, (h, w) for h / w;
planes are (a, b) for a . p + b = 0.
"""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.models import model


@model(first=4, second=4)
def join(first, second):
    """Line through two homogeneous points, also at infinity. Chapter lines, eq. (li-join)."""
    p, q = first[:3], second[:3]
    return np.concatenate([np.cross(p, q), first[3] * q - second[3] * p])


@model(line=6, plane=4)
def meet(line, plane):
    """Homogeneous point where a line meets a plane. Chapter lines, eq. (li-meet)."""
    n, v, a = line[:3], line[3:], plane[:3]
    return np.concatenate([np.cross(a, n) - plane[3] * v, np.array([a @ v])])


@model(pose=Pose, line=6)
def from_frame(pose, line):
    """Transform a line from the frame to the world. Chapter lines, eq. (li-fromframe)."""
    turn = rotation(pose[3:])
    v = turn @ line[3:]
    return np.concatenate([turn @ line[:3] + np.cross(pose[:3], v), v])


@model(pose=Pose, line=6)
def to_frame(pose, line):
    """Transform a line from the world to the frame. Chapter lines, eq. (li-toframe)."""
    back, v = rotation(pose[3:]).T, line[3:]
    return np.concatenate([back @ (line[:3] - np.cross(pose[:3], v)), back @ v])


@model(line=6, abscissa=())
def point_at(line, abscissa):
    """Homogeneous point, `abscissa` [m] from the line's point nearest to the origin. Eq. (li-point)."""
    n, v = line[:3], line[3:]
    squared = v @ v
    return np.concatenate([np.cross(v, n) + abscissa * sqrt(squared) * v, np.array([squared])])


@model(line=6, ray=3)
def crossing(line, ray):
    """Homogeneous point where a ray, turned into the line's plane, meets it. Eq. (li-crossing)."""
    n, v = line[:3], line[3:]
    return np.concatenate([(n @ n) * ray - (n @ ray) * n, np.array([np.cross(n, ray) @ v])])


@model(line=6, eye=3)
def constrain(line, eye):
    """The line with n . v = 0 that has the same image from the point `eye`. Eq. (li-constrain)."""
    seen = line[:3] - np.cross(eye, line[3:])
    v = line[3:] - seen * (seen @ line[3:]) / (seen @ seen)
    return np.concatenate([seen + np.cross(eye, v), v])


@model(rays=6, slopes=2)
def from_rays(rays, slopes):
    """Line seen between two unit rays: v is along the segment and, against the view, `slopes` [1/m].

    Its plane's normal n is of unit length; 1 / |slopes| is the distance. Chapter lines, eq. (li-rays).
    """
    first, second = rays[:3], rays[3:]
    n, along = np.cross(first, second), second - first
    n, along = n / sqrt(n @ n), along / sqrt(along @ along)
    return np.concatenate([n, slopes[0] * along + slopes[1] * np.cross(n, along)])
