"""Inverse-distance point (anchor, elevation, azimuth, inverse distance) [m, rad, 1/m]."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.geometry.moved import Parts, number
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(angles=2)
def direction(angles):
    """Unit vector of elevation above the x-y plane and azimuth [rad]. Chapter points, eq. (pt-idp)."""
    elevation, azimuth = angles
    return np.array([cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation)])


@model(vector=3)
def angles_of(vector):
    """Elevation and azimuth [rad] of a vector that is not vertical. Chapter points, eq. (pt-angles)."""
    x, y, z = vector
    return np.array([arctan2(z, sqrt(x * x + y * y)), arctan2(y, x)])


@model(pose=Pose, landmark=6)
def to_frame(pose, landmark):
    """Homogeneous point in the frame. Chapter points, eq. (pt-idp)."""
    anchor, inverse_distance = landmark[:3], landmark[5:]
    h = direction(landmark[3:5]) + inverse_distance * (anchor - pose[:3])
    return np.concatenate([rotation(pose[3:]).T @ h, inverse_distance])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Anchored at the frame's origin; the ray must not be vertical. Chapter points, eq. (pt-angles)."""
    h, w = point[:3], point[3:]
    return np.concatenate([pose[:3], angles_of(rotation(pose[3:]) @ h), w / sqrt(h @ h)])


@model(landmark=6)
def to_point(landmark):
    """Point (3,) in the world [m]. Chapter points, eq. (pt-idp)."""
    return landmark[:3] + direction(landmark[3:5]) / landmark[5]


@model(motion=Pose, angles=2)
def angles_moved(motion, angles):
    """Elevation and azimuth [rad] of a direction that turns with the world. Chapter points, eq. (pt-angles)."""
    return angles_of(rotation(motion[3:]) @ direction(angles))


MOVED = Parts(into_world, angles_moved, number)
IDP_POINT = PointLandmark("idpPnt", as_manifold(6), to_frame, from_frame, to_point, MOVED, anchor=3)
