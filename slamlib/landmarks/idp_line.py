"""Inverse-distance line (anchor, angles, rho, angles, rho): two idpPnt with one anchor [m, rad, 1/m]."""

import numpy as np

from slamlib.geometry.moved import Parts, number
from slamlib.geometry.plucker import join
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import idp_point
from slamlib.landmarks.idp_point import angles_moved, angles_of, direction
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=9)
def to_frame(pose, landmark):
    """Line in the frame. Chapter lines, eq. (li-two)."""
    first, second = landmark[:6], np.concatenate([landmark[:3], landmark[6:]])
    return join(idp_point.to_frame(pose, first), idp_point.to_frame(pose, second))


@model(pose=Pose, rays=6, prior=2)
def from_frame(pose, rays, prior):
    """Prior: inverse distances of the endpoints [1/m]; no ray is vertical. Eq. (li-two-init)."""
    turn = rotation(pose[3:])
    first, second = angles_of(turn @ rays[:3]), angles_of(turn @ rays[3:])
    return np.concatenate([pose[:3], first, prior[:1], second, prior[1:]])


@model(landmark=9, abscissa=())
def point_at(landmark, abscissa):
    """Homogeneous point: the first endpoint at 0, the second at 1. Chapter lines, eq. (li-between)."""
    near, far = landmark[5], landmark[8]
    w = near * far
    h = (1 - abscissa) * far * direction(landmark[3:5]) + abscissa * near * direction(landmark[6:8])
    return np.concatenate([h + w * landmark[:3], np.array([w])])


MOVED = Parts(into_world, angles_moved, number, angles_moved, number)
IDP_LINE = LineLandmark("idpLin", as_manifold(9), to_frame, from_frame, point_at, (0, 1), moved=MOVED)
