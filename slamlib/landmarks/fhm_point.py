"""Framed homogeneous point (frame, u, v, inverse depth): many points may share one frame."""

import numpy as np

from slamlib.geometry.moved import Parts, number
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import Product, as_manifold
from slamlib.models import model

FramedPoint = Product("framed point", Pose, as_manifold(3))


@model(pose=Pose, landmark=FramedPoint)
def to_frame(pose, landmark):
    """Homogeneous point in the frame `pose`. Chapter points, eq. (pt-fhm)."""
    origin, orientation = landmark[:3], landmark[3:7]
    (u, v), inverse_depth = landmark[7:9], landmark[9:]
    h = rotation(orientation) @ np.array([u, v, 1]) + inverse_depth * (origin - pose[:3])
    return np.concatenate([rotation(pose[3:]).T @ h, inverse_depth])


@model(pose=Pose, point=4, returns=FramedPoint)
def from_frame(pose, point):
    """The frame itself, with a point in front of it (point[2] > 0). Chapter points, eq. (pt-fhm)."""
    x, y, z, w = point
    return np.concatenate([pose, np.array([x / z, y / z, w / z])])


@model(landmark=FramedPoint)
def to_point(landmark):
    """Point (3,) in the world [m]. Chapter points, eq. (pt-fhm)."""
    origin, orientation = landmark[:3], landmark[3:7]
    u, v, inverse_depth = landmark[7:]
    return origin + rotation(orientation) @ np.array([u, v, 1]) / inverse_depth


MOVED = Parts(compose, number, number, number)
FHM_POINT = PointLandmark("fhmPnt", FramedPoint, to_frame, from_frame, to_point, MOVED, anchor=6)
