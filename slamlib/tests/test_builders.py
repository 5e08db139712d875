"""Builders: the setups that one would write by hand, and errors that say what is wrong before a filter is made."""

import json
from dataclasses import fields, replace

import numpy as np
import pytest

import slamlib as sl
from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError, UnknownNameError
from slamlib.records.inputs import Control
from slamlib.rigs.builders import RobotFields, SensorFields
from slamlib.rigs.setup import Rig

K = np.array([[500.0, 0, 330], [0, 510, 250], [0, 0, 1]])
LENS = {"intrinsics": (330.0, 250.0, 500.0, 510.0), "distortion": (-0.2, 0.1)}
CAMERA = {"position": (0, 0.25, 0.6), "robot": 1, "name": "left"}
R = np.array([[0.04, 0.001, 0], [0.001, 0.01, 0], [0, 0, 0.09]])


def test_every_type_of_sensor_has_a_builder():
    built = (
        sl.camera(K),
        sl.brown_conrady(K, (-0.2, 0.1, 0.001, -0.002)),
        sl.davison(K, 0.1),
        sl.fisheye(K),
        sl.unified(K, 0.8),
        sl.extended_unified(K, (0.6, 1.1)),
        sl.double_sphere(K, (-0.2, 0.6)),
        sl.omnidirectional((330, 250), [200.0]),
        sl.depth_camera(K),
        sl.stereo(K, 0.1),
        sl.range_bearing(0.1),
        sl.range_bearing((0.1, 0.01), name="laser"),
        sl.bearing_only(0.01),
        sl.range_only(0.1),
        sl.relative_position(0.1),
    )
    assert {setup.type for setup in built} == set(sl.SENSORS)
    assert len({setup.name for setup in built}) == len(built)  # so that one of each fits in a rig
    Rig((sl.robot(),), built)


def test_a_builder_passes_on_every_field_that_it_does_not_compute():
    computed = {"motion", "control_std", "control_covariance"}
    assert {*RobotFields.__annotations__} == {field.name for field in fields(sl.RobotSetup)} - computed
    computed = {"type", "std", "noise", "image", "parameters"}
    assert {*SensorFields.__annotations__} == {field.name for field in fields(sl.SensorSetup)} - computed


def test_a_camera_is_the_setup_that_one_would_write():
    wanted = sl.SensorSetup(std=(0.5, 0.5), image=(640, 480), parameters=LENS, **CAMERA)
    made = sl.camera(K, distortion=(-0.2, 0.1), image=(640, 480), noise=0.5, **CAMERA)
    assert made == wanted
    assert sl.camera(LENS["intrinsics"], [-0.2, 0.1], image=(640, 480), noise=(0.5, 0.5), **CAMERA) == wanted
    assert sl.camera(K.tolist(), np.array([-0.2, 0.1]), image=(640, 480), noise=[0.5, 0.5], **CAMERA) == wanted
    assert sl.camera(K).image == (660.0, 500.0)  # the principal point is its middle
    assert sl.camera(K, image=None).image is None
    assert not sl.camera(K).calibration.given["distortion"].any()


def test_opencvs_coefficients_are_taken_as_it_returns_them():
    returned = np.array([[0.26, -0.95, -0.005, 0.003, 1.16]])  # calibrateCamera's, (1, 5)
    assert sl.brown_conrady(K, returned).parameters["distortion"] == (0.26, -0.95, -0.005, 0.003, 1.16)


def test_a_sensor_that_is_no_camera_has_the_axes_of_its_robot():
    for made in (sl.range_bearing(0.1), sl.relative_position(0.1)):
        assert made.extrinsics.tolist() == [0, 0, 0, 1, 0, 0, 0]
        assert made.image is None
    assert sl.range_bearing(0.1, euler=(0, 0, 90)).euler == (0, 0, 90)
    assert sl.stereo(K, 0.1).euler == sl.camera(K).euler == sl.SensorSetup().euler


def test_noise_is_deviations_or_a_covariance():
    for noise in (0.1, (0.1, 0.1, 0.1), np.eye(3) * 0.01):
        assert sl.range_bearing(noise).calibration.noise == pytest.approx(np.eye(3) * 0.01)
    made = sl.range_bearing(R)
    assert np.array_equal(made.calibration.noise, R)
    assert np.array_equal(sl.stereo(K, 0.1, noise=R).calibration.noise, R)
    rig = Rig((sl.robot(),), (made,))
    assert Rig.from_dict(json.loads(json.dumps(rig.to_dict()))) == rig


def test_the_noise_of_a_robot_is_in_metres_and_radians():
    std = np.array([0.01, 0.02, 0.03, 0.001, 0.002, 0.003])
    assert sl.robot(noise=std).noise == pytest.approx(np.diag(std**2))
    assert sl.robot(noise=std).control_std[3:] == pytest.approx(np.degrees(std[3:]))  # a setup's angles are in degrees
    Q = np.diag(std**2)
    Q[0, 5] = Q[5, 0] = 1e-5
    made = sl.robot(noise=Q, name="rover", position=(1, 2, 0), euler=(0, 0, 90))
    assert np.array_equal(made.noise, Q)
    assert made == sl.RobotSetup(
        "rover", position=(1, 2, 0), euler=(0, 0, 90), control_covariance=tuple(map(tuple, Q.tolist()))
    )
    rig = Rig((made,), (sl.camera(K),))
    assert np.array_equal(Rig.from_dict(json.loads(json.dumps(rig.to_dict()))).robots[0].noise, Q)
    assert "control_covariance" not in Rig((sl.robot(),), rig.sensors).to_dict()["robots"][0]
    assert sl.robot(sl.MOTIONS["constVel"]).model is sl.robot("constVel").model
    assert sl.robot(noise=0.1).noise == pytest.approx(0.01 * np.eye(6))


def test_the_simulator_draws_the_noise_of_a_full_covariance_and_the_filter_is_told():
    """Two numbers that are one: with control that is drawn so, forward and sideways steps have the same error."""
    std = np.array([0.05, 0.05, 0, 0, 0, 0])
    Q = np.outer(std, std)
    preset = sl.presets.points()
    rig = replace(preset.rig, robots=(sl.robot(noise=Q, control=(0.08, 0, 0, 0, 0, 0)),))
    run = list(replace(preset, rig=rig, frames=20, noise_in="truth").simulate())
    control = run[0][0].controls[0]
    assert isinstance(control, Control)
    assert np.array_equal(control.covariance, Q)
    steps = np.diff([truth.robots[0][:3] for _, truth in run], axis=0) - [0.08, 0, 0]
    assert steps[:, 0] == pytest.approx(steps[:, 1], abs=1e-12)
    assert np.std(steps[:, 0]) > 0.02
    alone = replace(preset, rig=replace(rig, robots=(sl.robot(noise=std, control=(0.08, 0, 0, 0, 0, 0)),)))
    steps = np.diff([t.robots[0][:3] for _, t in replace(alone, frames=20, noise_in="truth").simulate()], axis=0)
    assert np.abs(steps[:, 0] - 0.08 - steps[:, 1]).max() > 0.02


WRONG = [
    (lambda: sl.camera(np.eye(4)), ShapeError, r"camera: K is a matrix \(3, 3\), or \(u0, v0, au, av\)"),
    (lambda: sl.camera(K.T), SlamlibError, r"camera: K is \[\[au, 0, u0\], .* without skew"),
    (lambda: sl.camera(K + np.eye(3, k=1)), SlamlibError, "without skew"),
    (lambda: sl.camera(K * [[np.nan, 1, 1], [1, 1, 1], [1, 1, 1]]), NonFiniteError, "camera: K holds nan"),
    (lambda: sl.camera((0, 0, 0, 0), image=None), SlamlibError, "au, av > 0"),
    (lambda: sl.camera(K, range(9)), ShapeError, "distortion has at most 8 numbers"),
    (lambda: sl.camera(K, (-0.9,)), SlamlibError, "folds back"),
    (lambda: sl.camera(K, image=(0, 480)), SlamlibError, "image"),
    (lambda: sl.camera(K, noise=(1, 1, 1)), ShapeError, r"one standard deviation, 2 of them, or a covariance \(2, 2\)"),
    (lambda: sl.camera(K, noise=-1), SlamlibError, "camera: standard deviations are zero or more"),
    (lambda: sl.camera(K, noise=[[1, 2], [2, 1]]), CovarianceError, "noise"),
    (lambda: sl.camera(K, noise=np.nan), NonFiniteError, "camera: noise holds nan"),
    (lambda: sl.camera(K, positon=(0, 0, 1)), UnknownNameError, "did you mean 'position'"),
    (lambda: sl.camera(K, limits={"near": 1}), UnknownNameError, "limit of pinHole 'near'"),
    (lambda: sl.brown_conrady(K, (0.1, 0.2)), SlamlibError, "k1 k2 p1 p2, then k3, then k4 k5 k6"),
    (lambda: sl.davison(K, (0.1, 0.2)), ShapeError, "distortion"),
    (lambda: sl.stereo(K, 0.0), SlamlibError, "the baseline is one length above zero"),
    (lambda: sl.omnidirectional((1, 2, 3), [200.0]), ShapeError, "omnidirectional: centre"),
    (lambda: sl.range_bearing(R, image=(640, 480)), UnknownNameError, "range and bearing"),
    (lambda: sl.range_bearing(0.1, limits={"near": 3, "far": 2}), SlamlibError, "'near'"),
    (lambda: sl.robot("odometri"), UnknownNameError, "did you mean 'odometry'"),
    (lambda: sl.robot(noise=np.eye(3)), ShapeError, r"6 of them, or a covariance \(6, 6\)"),
    (lambda: sl.robot(noise=-np.eye(6)), CovarianceError, "robot: control_covariance"),
    (lambda: sl.robot(control=(1, 2)), ShapeError, "robot: control should have shape"),
    (lambda: sl.robot(std=1), UnknownNameError, "builder of a robot"),
]


@pytest.mark.parametrize("case", range(len(WRONG)))
def test_what_is_wrong_is_said_at_once(case):
    make, error, words = WRONG[case]
    with pytest.raises(error, match=words):
        make()
