"""Point on the floor (x, y) in the world [m]: two numbers, for a map in the plane."""

import numpy as np

from slamlib.geometry.moved import plane_point
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.pose import to_frame as into_frame
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=2)
def to_frame(pose, landmark):
    """Homogeneous point in a frame anywhere in space; its last number is 1. Chapter points, eq. (pt-plane)."""
    x, y = landmark
    return np.concatenate([into_frame(pose, np.array([x, y, 0])), np.array([1])])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Point on the floor below or above a point at a finite distance. Chapter points, eq. (pt-plane)."""
    return into_world(pose, point[:3] / point[3])[:2]


@model(landmark=2)
def to_point(landmark):
    """Point (3,) in the world [m], at height zero. Chapter points, eq. (pt-plane)."""
    x, y = landmark
    return np.array([x, y, 0])


PLANE_POINT = PointLandmark("planePnt", as_manifold(2), to_frame, from_frame, to_point, plane_point, plane=True)
