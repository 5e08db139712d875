"""Anchored homogeneous line (anchor, m, rho, m, rho): two ahmPnt with one anchor [m, -, 1/m]."""

import numpy as np

from slamlib.geometry.moved import Parts, number, vector
from slamlib.geometry.plucker import join
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import ahm_point
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=11)
def to_frame(pose, landmark):
    """Line in the frame. Chapter lines, eq. (li-two)."""
    first, second = landmark[:7], np.concatenate([landmark[:3], landmark[7:]])
    return join(ahm_point.to_frame(pose, first), ahm_point.to_frame(pose, second))


@model(pose=Pose, rays=6, prior=2)
def from_frame(pose, rays, prior):
    """Prior: inverse distances of the two endpoints [1/m]. Chapter lines, eq. (li-two-init)."""
    turn = rotation(pose[3:])
    return np.concatenate([pose[:3], turn @ rays[:3], prior[:1], turn @ rays[3:], prior[1:]])


@model(landmark=11, abscissa=())
def point_at(landmark, abscissa):
    """Homogeneous point: the first endpoint at 0, the second at 1. Chapter lines, eq. (li-between)."""
    first, second = landmark[3:7], landmark[7:]
    h = (1 - abscissa) * second[3] * first + abscissa * first[3] * second
    return np.concatenate([h[:3] + h[3] * landmark[:3], h[3:]])


MOVED = Parts(into_world, vector, number, vector, number)
AHM_LINE = LineLandmark("ahmLin", as_manifold(11), to_frame, from_frame, point_at, (0, 1), moved=MOVED)
