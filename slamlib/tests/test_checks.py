"""The checks say which definition is wrong, in which argument, where and by how much; nothing wrong passes."""

import dataclasses

import numpy as np
import pytest

from slamlib.checks import CheckError, check_landmark, check_pair, check_sensor
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import LINES, POINTS
from slamlib.model import model
from slamlib.sensors import SENSORS, Calibration
from slamlib.tests.test_every_type import example


@model(pose=Pose, point=4)
def turned_back(pose, point):
    """An anchored point whose ray is not turned into the world but once more into the camera."""
    return np.concatenate([pose[:3], rotation(pose[3:]).T @ point[:3], point[3:]])


@model(pose=Pose, landmark=7)
def divided(pose, landmark):
    """A Euclidean point where a homogeneous one is wanted: it has no place at infinity."""
    point = landmark[:3] + landmark[3:6] / landmark[6] - pose[:3]
    return np.concatenate([rotation(pose[3:]).T @ point, np.array([1])])


@model(landmark=7)
def nearer(landmark):
    """The point, one percent too near."""
    return landmark[:3] + landmark[3:6] / landmark[6] * 99 / 100


@model(point=3)
def other_argument(point):
    """Takes something else."""
    return point


class WrongJacobian:
    """A model whose Jacobian by one argument has one wrong entry."""

    def __init__(self, right, argument):
        self.right, self.argument = right, argument
        self.arguments, self.parameters, self.definition = right.arguments, right.parameters, right.definition
        self.result = right.result

    def __call__(self, *args, **kwargs):
        return self.right(*args, **kwargs)

    def jac(self, *args, **kwargs):
        value, jacobians = self.right.jac(*args, **kwargs)
        wrong = getattr(jacobians, self.argument).copy()
        wrong[..., 1, 2] += 0.1
        return value, jacobians._replace(**{self.argument: wrong})


AHM = POINTS["ahmPnt"]


@pytest.mark.parametrize(
    ("change", "definition", "argument"),
    [
        ({"from_frame": turned_back}, "ahmPnt.from_frame", "point"),
        ({"to_frame": divided}, "ahmPnt.to_frame", "landmark"),
        ({"to_point": nearer}, "ahmPnt.from_frame", "pose"),
        ({"to_point": other_argument}, "ahmPnt.to_point", ""),
        ({"to_frame": WrongJacobian(AHM.to_frame, "landmark")}, "ahmPnt.to_frame", "landmark"),
        ({"from_frame": WrongJacobian(AHM.from_frame, "pose")}, "ahmPnt.from_frame", "pose"),
    ],
)
def test_a_wrong_landmark_is_found_and_named(change, definition, argument, capsys):
    with pytest.raises(CheckError) as caught:
        check_landmark(dataclasses.replace(AHM, **change))
    findings = caught.value.findings
    assert any(f.definition == definition and f.argument == argument for f in findings)
    assert str(caught.value).startswith("ahmPnt: ")
    assert "all" not in capsys.readouterr().out.splitlines()[-1:]


def test_a_finding_says_where_and_by_how_much():
    with pytest.raises(CheckError) as caught:
        check_landmark(dataclasses.replace(AHM, from_frame=turned_back), silent=True)
    finding = next(f for f in caught.value.findings if "ratio" in f.what)
    assert "pose = [" in finding.where
    assert "should be" in finding.how_much
    assert 0.1 < finding.error < 3
    assert caught.value._render_traceback_()[0].startswith("CheckError: ahmPnt")


def test_a_wrong_line_is_found():
    kind = LINES["ahmLin"]
    wrong = dataclasses.replace(kind, to_frame=WrongJacobian(kind.to_frame, "pose"))
    with pytest.raises(CheckError, match=r"ahmLin\.to_frame, argument 'pose'"):
        check_landmark(wrong, silent=True)
    with pytest.raises(CheckError, match="same point"):
        check_landmark(dataclasses.replace(kind, abscissas=(0.5, 0.5)), silent=True)


@model(point=4)
def unscaled(point):
    """A relative position that forgets to divide by w."""
    return point[:3]


def everything(point, calibration):
    """Calls everything visible, points at infinity too."""
    return np.ones(np.shape(point)[:-1], dtype=bool)


def single(point, calibration):
    """Works for one point only."""
    return bool(point[3] > 0)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"project": unscaled}, "only the ratio"),
        ({"visible": everything}, "what is visible can be measured"),
        ({"visible": single}, "mask|truth value|ambiguous"),
        ({"parameters": ("velocity",)}, "takes point; should take point, velocity"),
    ],
)
def test_a_wrong_sensor_is_found(change, message):
    right = SENSORS["relativePosition"]
    calibration = example(right)
    object.__setattr__(calibration, "sensor", dataclasses.replace(right, **change))
    with pytest.raises((CheckError, ValueError), match=message):
        check_sensor(calibration, silent=True)


def test_a_sensor_with_a_wrong_jacobian_is_found_by_both_tests_of_it():
    right = SENSORS["stereo"]
    calibration = example(right)
    wrong = dataclasses.replace(right, project=WrongJacobian(right.project, "point"))
    object.__setattr__(calibration, "sensor", wrong)
    with pytest.raises(CheckError) as caught:
        check_sensor(calibration, silent=True)
    found = {f.what for f in caught.value.findings}
    assert any("complex step" in what for what in found)
    assert any("undo each other" in what for what in found)


def test_misuse_is_told():
    with pytest.raises(SlamlibError, match="give a PointLandmark or a LineLandmark, not str"):
        check_landmark("ahmPnt")
    with pytest.raises(SlamlibError, match="judged with its calibration"):
        check_sensor(SENSORS["stereo"])


def test_a_pair_that_does_not_exist_is_told_from_a_wrong_one():
    behind = Calibration(SENSORS["relativePosition"], np.eye(3))
    assert check_pair(AHM, behind, silent=True)
    with pytest.raises(SlamlibError):
        check_pair(dataclasses.replace(AHM, from_frame=WrongJacobian(AHM.from_frame, "point")), behind, silent=True)
