"""Odometry in the plane: the control is a small displacement and a small turn, measured in the robot's own frame."""

from slamlib.geometry.moved import plane_pose
from slamlib.geometry.pose2 import Pose2, compose, from_space, in_space
from slamlib.models import model
from slamlib.motions.motion import Motion


@model(state=Pose2, control=3, dt=(), returns=Pose2)
def step(state, control, dt):
    """Pose after the control (dx, dy [m], turn [rad]); dt [s] is not used. Chapter motion_models, eq. (mo-plane)."""
    return compose(state, control)


PLANE_ODOMETRY = Motion(
    "planeOdometry", Pose2, 3, step, moved=plane_pose, angles=(2,), pose_of=in_space, from_pose=from_space
)
