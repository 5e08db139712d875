"""The unicycle in the plane: the control is a speed [m/s] and a rate of turn [rad/s], both constant during the step."""

import numpy as np

from slamlib.geometry.moved import plane_pose
from slamlib.geometry.pose2 import Pose2, compose, exponential, from_space, in_space
from slamlib.models import model
from slamlib.motions.motion import Motion


@model(state=Pose2, control=2, dt=(), returns=Pose2)
def step(state, control, dt):
    """Pose after an arc of dt [s]; exact, and straight at no turn. Chapter motion_models, eq. (mo-unicycle)."""
    speed, rate = control
    return compose(state, exponential(np.array([speed * dt, 0, rate * dt])))


UNICYCLE = Motion("unicycle", Pose2, 2, step, moved=plane_pose, angles=(1,), pose_of=in_space, from_pose=from_space)
