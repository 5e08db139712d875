"""Robots, sensors and landmarks of the filter: which part of the belief each of them is a handle to."""

import numpy as np

from slamlib.experiments.presets import preset
from slamlib.geometry.euler import to_quaternion
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Slam


def test_the_pose_of_a_robot_that_also_has_a_velocity_is_its_pose_alone():
    walker = RobotSetup(motion="constVel", position=(1, 2, 3), euler=(0, 0, 90), velocity=(4, 5, 6, 7, 8, 9))
    slam = Slam(Rig((walker,), (SensorSetup(),)))
    turned = to_quaternion(np.radians([0.0, 0.0, 90.0]))
    assert np.array_equal(slam.robots[0].pose, [1, 2, 3, *turned])


def test_a_sensor_depends_on_its_own_robot_and_on_extrinsics_only_if_they_are_estimated():
    _, of_second = preset("two_robots").slam().sensors
    assert of_second.columns.tolist() == [6, 7, 8, 9, 10, 11]
    fixed, estimated = preset("self_calibration").slam().sensors
    assert fixed.columns.tolist() == [0, 1, 2, 3, 4, 5]
    assert estimated.columns.tolist() == [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]
