"""Line through two homogeneous points, (m, w) and (m, w), each an hmgPnt: eight numbers."""

import numpy as np

from slamlib.geometry.moved import Parts
from slamlib.geometry.plucker import join
from slamlib.geometry.pose import Pose
from slamlib.landmarks import hmg_point
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=8)
def to_frame(pose, landmark):
    """Line in the frame. Chapter lines, eq. (li-two)."""
    return join(hmg_point.to_frame(pose, landmark[:4]), hmg_point.to_frame(pose, landmark[4:]))


@model(pose=Pose, rays=6, prior=2)
def from_frame(pose, rays, prior):
    """Prior: inverse distances of the two endpoints [1/m]. Chapter lines, eq. (li-two-init)."""
    first, second = np.concatenate([rays[:3], prior[:1]]), np.concatenate([rays[3:], prior[1:]])
    return np.concatenate([hmg_point.from_frame(pose, first), hmg_point.from_frame(pose, second)])


@model(landmark=8, abscissa=())
def point_at(landmark, abscissa):
    """Homogeneous point: the first endpoint at 0, the second at 1. Chapter lines, eq. (li-between)."""
    first, second = landmark[:4], landmark[4:]
    return (1 - abscissa) * second[3] * first + abscissa * first[3] * second


MOVED = Parts(hmg_point.from_frame, hmg_point.from_frame)
HMG_LINE = LineLandmark("hmgLin", as_manifold(8), to_frame, from_frame, point_at, (0, 1), moved=MOVED)
