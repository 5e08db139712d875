"""Ways to go: where a robot gets to that follows them exactly."""

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import exponential
from slamlib.motions import odometry
from slamlib.simulation import controls


def path(steps, heading=0.0):
    """Poses (n + 1, 7) of a robot that starts at the origin."""
    poses = [np.concatenate([np.zeros(3), exponential(np.array([0, 0, heading]))])]
    for control in steps:
        poses.append(odometry.step(poses[-1], control, 1.0))
    return np.array(poses)


def test_straight_ahead():
    poses = path(controls.straight(7, 3.5), heading=np.pi / 2)
    assert poses[-1, :3] == pytest.approx([0, 3.5, 0])
    assert np.diff(poses[:, 1]) == pytest.approx(np.full(7, 0.5))


@pytest.mark.parametrize("turns", [1.0, -1.0, 3.0])
def test_a_circle_closes_and_has_its_radius(turns):
    poses = path(controls.circle(90, 2.0, turns))
    assert Pose.minus(poses[-1], poses[0]) == pytest.approx(np.zeros(6), abs=1e-12)
    middle = poses[:-1, :3].mean(0)
    assert np.linalg.norm(poses[:, :3] - middle, axis=1) == pytest.approx(np.full(91, 2.0))
    assert np.sign(middle[1]) == np.sign(turns)


def test_a_quarter_turn_looks_to_the_left():
    assert path(controls.circle(10, 1.0, 0.25))[-1, 3:] == pytest.approx(exponential(np.array([0, 0, np.pi / 2])))


def test_a_figure_of_eight_closes_and_crosses_itself():
    poses = path(controls.figure_of_eight(200, 3.0))
    for there in (100, 200):
        assert Pose.minus(poses[there], poses[0]) == pytest.approx(np.zeros(6), abs=1e-12)
    assert poses[:, 1].max() == pytest.approx(6, abs=0.2)
    assert poses[:, 1].min() == pytest.approx(-6, abs=0.2)


def test_misuse_is_named():
    for wrong in (lambda: controls.straight(0, 1.0), lambda: controls.circle(2.5, 1.0)):
        with pytest.raises(SlamlibError, match="steps is a whole number"):
            wrong()
    with pytest.raises(SlamlibError, match="an even number of steps"):
        controls.figure_of_eight(9, 1.0)
