"""A landmark of one's own: a point by anchor, direction and the logarithm of its distance (extra `derive`)."""

import numpy as np

import slamlib as sl
from slamlib.analytic import exp, log
from slamlib.landmarks import PointLandmark
from slamlib.manifolds import as_manifold


@sl.model(pose=sl.Pose, landmark=7)
def to_frame(pose, landmark):  # homogeneous, and so without a division
    h = landmark[3:6] + exp(-landmark[6]) * (landmark[:3] - pose[:3])
    return np.array([*(sl.quaternion.rotation(pose[3:]).T @ h), exp(-landmark[6])])


@sl.model(pose=sl.Pose, point=4)
def from_frame(pose, point):  # of a camera's ray, whose fourth number is the inverse distance
    return np.array([*pose[:3], *(sl.quaternion.rotation(pose[3:]) @ point[:3]), -log(point[3])])


@sl.model(landmark=7)
def to_point(landmark):
    return landmark[:3] + exp(landmark[6]) * landmark[3:6]


print(sl.derive(from_frame, point="x y z w").point[6, :])
sl.POINTS.add(PointLandmark("logPnt", as_manifold(7), to_frame, from_frame, to_point))
print(sl.run("points", frames=50, options={"points": "logPnt"}))
