"""Poses (x, y, z, w, x, y, z) of a frame in the world [m, unit quaternion]: seven numbers stored, six estimated.

The six are a displacement in world axes and a rotation vector in the frame's own axes.
"""

import numpy as np

from slamlib.geometry.quaternion import UnitQuaternion, conjugate, left_inverse, left_jacobian, product, rotation, skew
from slamlib.geometry.quaternion import exponential as turn_by
from slamlib.geometry.quaternion import logarithm as rotation_vector
from slamlib.manifolds import Euclidean, Product
from slamlib.models import model

Pose = Product("pose", Euclidean(3), UnitQuaternion)
ORIGIN = np.array([0.0, 0, 0, 1, 0, 0, 0])  # of the world itself: no displacement, no rotation


@model(pose=Pose, point=3)
def from_frame(pose, point):
    """Transform a point from the frame to the world [m]. Chapter frames_and_quaternions, eq. (fq-fromframe)."""
    return pose[:3] + rotation(pose[3:]) @ point


@model(pose=Pose, point=3)
def to_frame(pose, point):
    """Transform a point from the world to the frame [m]. Chapter frames_and_quaternions, eq. (fq-toframe)."""
    return rotation(pose[3:]).T @ (point - pose[:3])


@model(outer=Pose, inner=Pose, returns=Pose)
def compose(outer, inner):
    """Pose in the world of `inner`, given in the frame `outer`. Chapter frames_and_quaternions, eq. (fq-compose)."""
    return np.concatenate([from_frame(outer, inner[:3]), product(outer[3:], inner[3:])])


@model(pose=Pose, returns=Pose)
def inverse(pose):
    """Pose of the world in the frame. Chapter frames_and_quaternions, eq. (fq-inverse)."""
    turned = conjugate(pose[3:])
    return np.concatenate([-rotation(turned) @ pose[:3], turned])


@model(origin=Pose, pose=Pose, returns=Pose)
def relative(origin, pose):
    """`pose` in the frame `origin`: compose(origin, relative) is `pose`. Eq. (fq-relative)."""
    return np.concatenate([to_frame(origin, pose[:3]), product(conjugate(origin[3:]), pose[3:])])


@model(twist=6, returns=Pose)
def exponential(twist):
    """Pose reached from the origin by a twist (displacement [m], rotation vector [rad]) in the frame's axes: a screw.

    Both are constant velocities for a unit of time; straight at no rotation, and smooth there. Eq. (fq-screw-exp).
    """
    return np.concatenate([left_jacobian(twist[3:]) @ twist[:3], turn_by(twist[3:])])


@model(pose=Pose)
def logarithm(pose):
    """Twist (6,) that leads from the origin to the pose, turning by at most pi. Eq. (fq-screw-log)."""
    vector = rotation_vector(pose[3:])
    return np.concatenate([left_inverse(vector) @ pose[:3], vector])


@model(pose=Pose)
def adjoint(pose):
    """Matrix (6, 6): from a twist in the frame's axes to the same motion's in the world's. Eq. (fq-adjoint)."""
    turn = rotation(pose[3:])
    return np.block([[turn, skew(pose[:3]) @ turn], [np.zeros((3, 3), dtype=int), turn]])
