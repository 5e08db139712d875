"""Anchored Pluecker line (x, n, v): a Pluecker line whose origin is the anchor x [m]."""

import numpy as np

from slamlib.geometry import plucker
from slamlib.geometry.moved import Parts, vector
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=9)
def to_frame(pose, landmark):
    """Line in the frame. Chapter lines, eq. (li-apl)."""
    back, n, v = rotation(pose[3:]).T, landmark[3:6], landmark[6:]
    return np.concatenate([back @ (n + np.cross(landmark[:3] - pose[:3], v)), back @ v])


@model(pose=Pose, rays=6, prior=2)
def from_frame(pose, rays, prior):
    """Anchored at the frame's origin; prior as for plkLin. Chapter lines, eq. (li-apl)."""
    turn, line = rotation(pose[3:]), plucker.from_rays(rays, prior)
    return np.concatenate([pose[:3], turn @ line[:3], turn @ line[3:]])


@model(landmark=9, abscissa=())
def point_at(landmark, abscissa):
    """Homogeneous point, metres from the one nearest to the world's origin. Eq. (li-point)."""
    n, v = landmark[3:6], landmark[6:]
    return plucker.point_at(np.concatenate([n + np.cross(landmark[:3], v), v]), abscissa)


@model(landmark=9, eye=3)
def constrain(landmark, eye):
    """Enforce the line constraint, with the image from `eye` [m] unchanged. Eq. (li-constrain)."""
    anchor = landmark[:3]
    return np.concatenate([anchor, plucker.constrain(landmark[3:], eye - anchor)])


MOVED = Parts(into_world, vector, vector)
APL_LINE = LineLandmark("aplLin", as_manifold(9), to_frame, from_frame, point_at, (-8, 8), constrain, MOVED, anchor=3)
