"""Homogeneous point (m, w): the world point m / w, with the world's origin as its anchor."""

import numpy as np

from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=4)
def to_frame(pose, landmark):
    """Homogeneous point in the frame. Chapter points, eq. (pt-hmg)."""
    m, w = landmark[:3], landmark[3:]
    return np.concatenate([rotation(pose[3:]).T @ (m - w * pose[:3]), w])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Homogeneous point in the world. Chapter points, eq. (pt-hmg)."""
    h, w = point[:3], point[3:]
    return np.concatenate([rotation(pose[3:]) @ h + w * pose[:3], w])


@model(landmark=4)
def to_point(landmark):
    """Point (3,) in the world [m]. Chapter points, eq. (pt-hmg)."""
    return landmark[:3] / landmark[3]


HMG_POINT = PointLandmark("hmgPnt", as_manifold(4), to_frame, from_frame, to_point, from_frame)
