"""Robots, sensors and landmarks of the filter: which part of the belief each of them is a handle to."""

from dataclasses import replace

import numpy as np

from slamlib.experiments.presets import preset
from slamlib.geometry.euler import to_quaternion
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Slam
from slamlib.slam.prediction import expected_covariances, expected_values


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


def test_the_numbers_of_the_landmarks_are_those_of_the_map_whatever_comes_and_goes():
    p = preset("points_and_lines")
    slam = p.slam()
    for frame, _ in replace(p, frames=4).simulate():
        assert slam.state.ids() == {landmark.id for landmark in slam.landmarks}
        slam.step(frame)
    for landmark in slam.landmarks[:3]:
        slam.prune(landmark)
        assert slam.state.ids() == {own.id for own in slam.landmarks}
        assert landmark.id not in slam.state.ids()


def test_values_and_covariances_of_many_predictions_are_those_of_each():
    """Of one batch, in any order, and of points of two kinds, which are two batches."""
    p = preset("points")
    slam = p.slam()
    for frame, _ in replace(p, frames=25).simulate():
        slam.step(frame)
    predictions = slam.project()
    batches = {id(one.batch): one.batch for one in predictions}
    assert len(batches) == 2
    for some in ([one for one in predictions if one.batch is predictions[0].batch][::-2], predictions[::-1]):
        assert np.array_equal(expected_values(some), [one.value for one in some])
        assert np.array_equal(expected_covariances(some), [one.S for one in some])
