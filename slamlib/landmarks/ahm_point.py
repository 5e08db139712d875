"""Anchored homogeneous point (anchor, direction, inverse distance): seven numbers [m, -, 1/m]."""

import numpy as np

from slamlib.geometry.moved import Parts, number, vector
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=7)
def to_frame(pose, landmark):
    """Homogeneous point in the frame. Chapter points, eq. (pt-ahm)."""
    anchor, direction, inverse_distance = landmark[:3], landmark[3:6], landmark[6:]
    h = direction + inverse_distance * (anchor - pose[:3])
    return np.concatenate([rotation(pose[3:]).T @ h, inverse_distance])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Anchored at the frame's origin. Chapter points, eq. (pt-ahm)."""
    return np.concatenate([pose[:3], rotation(pose[3:]) @ point[:3], point[3:]])


@model(landmark=7)
def to_point(landmark):
    """Point (3,) in the world [m]. Chapter points, eq. (pt-ahm)."""
    return landmark[:3] + landmark[3:6] / landmark[6]


AHM_POINT = PointLandmark(
    "ahmPnt", as_manifold(7), to_frame, from_frame, to_point, Parts(into_world, vector, number), anchor=3
)
