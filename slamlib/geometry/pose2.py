"""Poses (x, y, heading) of a frame in the plane [m, rad]: three numbers, all of them estimated.

A step is a displacement in world axes and a turn to the left; headings that differ by whole turns are the same.
"""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, stumpff
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Angle, Euclidean, Product
from slamlib.models import model

Pose2 = Product("pose in the plane", Euclidean(2), Angle(1))


def rotation2(heading):
    """Rotation matrix (2, 2) of a heading [rad]: its columns are the frame's axes in the world. Eq. (fq-plane-turn)."""
    c, s = cos(heading), sin(heading)
    return np.array([[c, -s], [s, c]])


@model(pose=Pose2, point=2)
def from_frame(pose, point):
    """Transform a point from the frame to the world [m]. Chapter frames_and_quaternions, eq. (fq-plane-fromframe)."""
    return pose[:2] + rotation2(pose[2]) @ point


@model(pose=Pose2, point=2)
def to_frame(pose, point):
    """Transform a point from the world to the frame [m]. Chapter frames_and_quaternions, eq. (fq-plane-toframe)."""
    return rotation2(pose[2]).T @ (point - pose[:2])


@model(outer=Pose2, inner=Pose2, returns=Pose2)
def compose(outer, inner):
    """Pose in the world of `inner`, given in the frame `outer`. Eq. (fq-plane-compose)."""
    return np.array([*from_frame(outer, inner[:2]), outer[2] + inner[2]])


@model(pose=Pose2, returns=Pose2)
def inverse(pose):
    """Pose of the world in the frame. Eq. (fq-plane-inverse)."""
    return np.array([*(-rotation2(pose[2]).T @ pose[:2]), -pose[2]])


@model(twist=3, returns=Pose2)
def exponential(twist):
    """Pose reached from the origin by a twist (x, y [m], turn [rad]) at constant velocity in the frame's axes: an arc.

    Straight at no turn, and smooth there. Chapter frames_and_quaternions, eq. (fq-plane-exp).
    """
    x, y, turn = twist
    ahead, aside = stumpff(1, turn * turn), turn * stumpff(2, turn * turn)
    return np.array([ahead * x - aside * y, aside * x + ahead * y, turn])


@model(pose=Pose2)
def adjoint(pose):
    """Matrix (3, 3): from a twist in the frame's axes to the same motion's in the world's. Eq. (fq-plane-adjoint)."""
    x, y, heading = pose
    c, s = cos(heading), sin(heading)
    return np.array([[c, -s, y], [s, c, -x], [0, 0, 1]])


@model(state=Pose2, returns=Pose)
def in_space(state):
    """The pose in space (7,) of a frame that stands upright on the floor. Eq. (fq-plane-space)."""
    x, y, heading = state
    return np.array([x, y, 0, cos(heading / 2), 0, 0, sin(heading / 2)])


@model(pose=Pose, returns=Pose2)
def from_space(pose):
    """Position and heading of a pose in space, whose height, roll and pitch are left out. Eq. (fq-plane-from)."""
    x, y, _, w, a, b, c = pose
    return np.array([x, y, arctan2(2 * (w * c + a * b), w * w + a * a - b * b - c * c)])
