"""A robot of one's own: a bicycle, whose state is x, y, heading and the angle of its steering (extra `derive`)."""

import numpy as np

import slamlib as sl
from slamlib.analytic import cos, sin
from slamlib.checks import check_motion
from slamlib.experiments.presets import Preset
from slamlib.geometry.pose2 import from_space, in_space
from slamlib.manifolds import Angle, Euclidean, Product
from slamlib.motions import Motion

Bicycle = Product("x, y, heading, steering", Euclidean(2), Angle(1), Angle(1))


@sl.model(state=Bicycle, control=2, dt=(), returns=Bicycle)
def step(state, control, dt):  # wheels one metre apart; the steering follows the handlebar within half a second
    (x, y, heading, steering), (speed, handlebar) = state, control
    ahead, turn = dt * speed, dt * speed * sin(steering) / cos(steering)
    steering = steering + 2 * dt * (handlebar - steering)
    return np.array([x + ahead * cos(heading), y + ahead * sin(heading), heading + turn, steering])


@sl.model(state=Bicycle, returns=sl.Pose)
def pose_of(state):
    return in_space(state[:3])


@sl.model(pose=sl.Pose, returns=Bicycle)
def from_pose(pose):  # it starts with its wheels straight
    return np.array([*from_space(pose), 0])


BICYCLE = Motion("bicycle", Bicycle, 2, step, None, angles=(1,), pose_of=pose_of, from_pose=from_pose)
check_motion(BICYCLE, silent=True)
sl.MOTIONS.add(BICYCLE)
rider = sl.robot(
    "bicycle", noise=(0.1, 0.05), position=(0, -5, 0), position_std=0.1, orientation_std=1, control=(1, 12)
)
rig = sl.Rig((rider,), (sl.range_bearing(noise=(0.1, 0.02), limits={"far": 8.0}),))
print(sl.run(Preset("ride", rig, worlds=(("cloister", {}),), noise_in="truth")))
