"""Odometry: the control is a small displacement and a small rotation, both measured in the robot's own frame."""

import numpy as np

from slamlib.geometry.pose import Pose, from_frame
from slamlib.geometry.quaternion import plus
from slamlib.models import model
from slamlib.motions.motion import Motion


@model(state=Pose, control=6, dt=(), returns=Pose)
def step(state, control, dt):
    """Pose after the control (dx [m], rotation vector [rad]); dt [s] is not used. Eq. (mo-odometry)."""
    return np.concatenate([from_frame(state, control[:3]), plus(state[3:], control[3:])])


ODOMETRY = Motion("odometry", Pose, control=6, step=step)
