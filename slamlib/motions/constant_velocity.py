"""Constant velocity: the robot keeps its velocities but for unknown impulses, one per step."""

import numpy as np

from slamlib.geometry.moved import Parts, number, vector
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import plus
from slamlib.manifolds import Euclidean, Product
from slamlib.models import model
from slamlib.motions.motion import Motion

MovingPose = Product("pose and velocities", Pose, Euclidean(6))


@model(state=MovingPose, control=6, dt=(), returns=MovingPose)
def step(state, control, dt):
    """State (pose, v [m/s] in world axes, omega [rad/s] in the body's) after dt [s] and impulses added to both.

    Position and orientation move with the velocities before the impulse, exactly. Chapter motion_models, eq.
    (mo-constvel).
    """
    position, orientation, velocity, spin = state[:3], state[3:7], state[7:10], state[10:]
    moved = [position + velocity * dt, plus(orientation, spin * dt)]
    return np.concatenate([*moved, velocity + control[:3], spin + control[3:]])


MOVED = Parts(compose, vector, number, number, number)  # omega, in the body's axes, does not notice
CONSTANT_VELOCITY = Motion("constVel", MovingPose, control=6, step=step, moved=MOVED)
