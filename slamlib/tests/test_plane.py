"""A robot whose state is smaller than a pose in space: in the plane, by a motion of the reader's own.

Its filter is that of a robot in space which cannot leave the plane: the same estimates, by half as many numbers.
"""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.analytic import cos, sin
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band, share_inside
from slamlib.experiments.presets import Preset
from slamlib.experiments.runs import Run
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose2 import Pose2, from_space, in_space
from slamlib.models import model
from slamlib.motions import MOTIONS, Motion
from slamlib.records.inputs import Control, RobotMeasurement
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Options, Slam


@model(state=Pose2, control=3, dt=(), returns=Pose2)
def drive(state, control, dt):
    """Forward and to the left [m], and a turn [rad], in the robot's own frame."""
    c, s = cos(state[2]), sin(state[2])
    ahead, left, turn = control
    return np.array([state[0] + c * ahead - s * left, state[1] + s * ahead + c * left, state[2] + turn])


PLANE = Motion("drive", Pose2, control=3, step=drive, moved=None, angles=(2,), pose_of=in_space, from_pose=from_space)
PRESET = Preset(
    "plane",
    Rig(
        (RobotSetup(motion=PLANE, position=(0, -5, 0), control=(0.08, 0, 0.9), control_std=(0.02, 0.01, 0.2)),),
        (SensorSetup(type="rangeBearing", euler=(0, 0, 0), position=(0.2, 0.1, 0.6), std=(0.05, 0.01, 0.01)),),
    ),
    Options(points="eucPnt"),
    frames=60,
    noise_in="truth",
)  # fmt: skip


def lifted_rig():
    """The same robot, with a pose in space which it cannot leave."""
    six = [0, 1, 5]
    control = np.zeros((6, 6))
    control[np.ix_(six, six)] = PRESET.rig.robots[0].noise
    robot = RobotSetup(
        position=(0, -5, 0), control=(0.08, 0, 0, 0, 0, 0.9), control_covariance=tuple(map(tuple, control))
    )
    return Rig((robot,), PRESET.rig.sensors)


def lifted(frame):
    """The frame with the control of the robot in space."""
    (control,) = frame.controls
    value, covariance = np.zeros(6), np.zeros((6, 6))
    value[[0, 1, 5]], covariance[np.ix_([0, 1, 5], [0, 1, 5])] = control.value, control.covariance
    return replace(frame, controls=(Control(value, covariance),))


@pytest.mark.parametrize("changes", [
    {}, {"reproject": False}, {"points": "ahmPnt"},
    {"outlier_rejection": "joint"}, {"outlier_rejection": "one-point-ransac"},
], ids=str)  # fmt: skip
def test_the_filter_is_that_of_a_robot_in_space_which_cannot_leave_the_plane(changes):
    options = replace(PRESET.options, **changes)
    plane, space = Slam(PRESET.rig, options=options), Slam(lifted_rig(), options=options)
    for frame, _ in PRESET.simulate():
        plane.step(frame)
        space.step(lifted(frame))
    assert plane.belief.size == space.belief.size - 3
    assert len(plane.landmarks) > 20
    assert np.abs(Pose.minus(plane.robots[0].pose, space.robots[0].pose)).max() < 1e-9
    assert plane.robot.pose_covariance == pytest.approx(space.robot.pose_covariance, abs=1e-12)
    for one, other in zip(plane.landmarks, space.landmarks, strict=True):
        assert (one.id, one.inliers) == (other.id, other.inliers)
        assert one.block.mean == pytest.approx(other.block.mean, abs=1e-9)
        P = space.belief.covariance(other.block)
        assert plane.belief.covariance(one.block) == pytest.approx(P, abs=1e-10)


def test_nees_has_the_three_degrees_of_freedom_of_the_plane():
    """25 runs, seeds 0 to 24: the average of each of 60 frames, with a band of 95 %."""
    nees = []
    for seed in range(25):
        result = Run(PRESET, seed=seed).finish()
        nees.append(result.nees[:, 0])
    assert result.dof == (3,)
    average = np.mean(nees, axis=0)
    assert share_inside(average, band(3, runs=25)) > 0.85
    assert 2.7 < average.mean() < 3.3
    assert (result.sigmas[-1, 0, [0, 1, 5]] > 0).all()
    assert np.abs(result.errors[:, 0, 2:5]).max() < 1e-9
    assert "of 3" in repr(result)


@model(pose=Pose)
def gps(pose):
    """Where it is."""
    return pose[:3]


def test_what_a_robot_measures_of_itself_goes_through_its_state():
    ((frame, truth),) = replace(PRESET, frames=1).simulate()
    measured = RobotMeasurement("gps", gps, truth.poses[0][:3] + np.array([0.1, 0, 0]), 0.01 * np.eye(3))
    plane, space = Slam(PRESET.rig), Slam(lifted_rig())
    plane.step(replace(frame, absolute=(measured,)))
    space.step(replace(lifted(frame), absolute=(measured,)))
    assert np.abs(Pose.minus(plane.robots[0].pose, space.robots[0].pose)).max() < 1e-12
    assert plane.absolute[0].nis == pytest.approx(space.absolute[0].nis)


def test_jacobians_of_predictions_are_those_of_the_state():
    slam = Slam(PRESET.rig, options=PRESET.options)
    for frame, _ in replace(PRESET, frames=5).simulate():
        slam.step(frame)
    block, mean = slam.robots[0].block, slam.robots[0].block.mean
    predictions = slam.project()
    assert len(predictions) > 5
    for column in range(3):
        values = []
        for sign in (1, -1):
            block.mean = Pose2.plus(mean, sign * 1e-6 * np.eye(3)[column])
            values.append({p.landmark: p.value for p in slam.project()})
        block.mean = mean
        for p in predictions:
            slope = (
                slam.sensors[0].calibration.sensor.manifold.minus(values[0][p.landmark], values[1][p.landmark]) / 2e-6
            )
            assert p.batch.jacobian[p.row][:, column] == pytest.approx(slope, abs=1e-6)


def test_a_run_is_saved_and_goes_on(tmp_path, monkeypatch):
    monkeypatch.setattr(MOTIONS, "_values", {**MOTIONS, "drive": PLANE})
    slam, frames = PRESET.slam(), [frame for frame, _ in replace(PRESET, frames=20).simulate()]
    for i, frame in enumerate(frames):
        slam.step(frame)
        if i == 9:
            slam.save(tmp_path / "half.npz")
    again = Slam.load(tmp_path / "half.npz")
    for frame in frames[10:]:
        again.step(frame)
    assert np.array_equal(again.belief.matrix, slam.belief.matrix)
    assert again.robots[0].motion is PLANE


def test_a_pose_that_such_a_robot_cannot_have_is_refused():
    for wrong in ({"position": (0, 0, 1.0)}, {"euler": (10.0, 0, 0)}):
        with pytest.raises(SlamlibError, match=r"robot: by drive no robot can have the pose .*; the nearest is"):
            _ = RobotSetup(motion=PLANE, **wrong).state
    robot = RobotSetup(
        motion=PLANE, position=(1, 2, 0), euler=(0, 0, 90), position_std=(0.1, 0.2, 0.3), orientation_std=5.0
    )
    assert robot.state == pytest.approx([1, 2, np.pi / 2])
    assert np.sqrt(robot.covariance.diagonal()) == pytest.approx([0.1, 0.2, np.radians(5)])
    with pytest.raises(SlamlibError, match="models of both"):
        replace(PLANE, from_pose=None)
    with pytest.raises(SlamlibError, match="models of both"):
        Motion("flat", Pose2, control=3, step=drive, moved=None)


def test_what_the_plane_has_not_yet_is_refused_by_name():
    with pytest.raises(SlamlibError, match="needs the model moved"):
        Slam(PRESET.rig, options=replace(PRESET.options, error="world"))
