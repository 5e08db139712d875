"""Euclidean point (x, y, z) in the world [m]: three numbers, for a point at a known distance."""

import numpy as np

from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.pose import to_frame as into_frame
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=3)
def to_frame(pose, landmark):
    """Homogeneous point in the frame; its last number is 1. Chapter points, eq. (pt-euc)."""
    return np.concatenate([into_frame(pose, landmark), np.array([1])])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Point in the world [m]; not defined for a point at infinity. Chapter points, eq. (pt-euc)."""
    return into_world(pose, point[:3] / point[3])


@model(landmark=3)
def to_point(landmark):
    """The point itself [m]. Chapter points, eq. (pt-euc)."""
    return landmark


EUC_POINT = PointLandmark("eucPnt", as_manifold(3), to_frame, from_frame, to_point, into_world)
