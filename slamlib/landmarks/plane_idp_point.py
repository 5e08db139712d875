"""Inverse-distance point on the floor (anchor x, y, azimuth, inverse distance) [m, rad, 1/m]: four numbers."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.geometry.moved import Parts, number, plane_pose
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import Angle, Euclidean, Product
from slamlib.models import model

AnchoredInPlane = Product("anchor, azimuth and inverse distance", Euclidean(2), Angle(1), Euclidean(1))


@model(pose=Pose, landmark=AnchoredInPlane)
def to_frame(pose, landmark):
    """Homogeneous point in a frame anywhere in space. Chapter points, eq. (pt-plane-idp)."""
    x, y, azimuth, inverse_distance = landmark
    ray = np.array([cos(azimuth), sin(azimuth), 0])
    h = ray + inverse_distance * (np.array([x, y, 0]) - pose[:3])
    return np.concatenate([rotation(pose[3:]).T @ h, np.array([inverse_distance])])


@model(pose=Pose, point=4, returns=AnchoredInPlane)
def from_frame(pose, point):
    """Anchored below the frame's origin; the ray must not be vertical. Chapter points, eq. (pt-plane-idp)."""
    x, y, _ = rotation(pose[3:]) @ point[:3]
    return np.array([pose[0], pose[1], arctan2(y, x), point[3] / sqrt(x * x + y * y)])


@model(landmark=AnchoredInPlane)
def to_point(landmark):
    """Point (3,) in the world [m], at height zero; not defined at infinity. Chapter points, eq. (pt-plane-idp)."""
    x, y, azimuth, inverse_distance = landmark
    return np.array([x + cos(azimuth) / inverse_distance, y + sin(azimuth) / inverse_distance, 0])


MOVED = Parts(plane_pose, number)  # anchor and azimuth are a pose in the plane
PLANE_IDP_POINT = PointLandmark(
    "planeIdpPnt", AnchoredInPlane, to_frame, from_frame, to_point, MOVED, plane=True, anchor=2
)
