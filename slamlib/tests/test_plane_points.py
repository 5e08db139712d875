"""Points and sensors of the plane: by hand, and as those of space with zeros put in."""

import numpy as np
import pytest

from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.geometry.pose2 import in_space
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.idp_point import IDP_POINT
from slamlib.landmarks.plane_idp_point import PLANE_IDP_POINT
from slamlib.landmarks.plane_point import PLANE_POINT
from slamlib.observation.points import observe
from slamlib.sensors import plane_bearing, plane_range, plane_range_bearing, range_bearing
from slamlib.sensors.sensor import Calibration

KEPT = [0, 1, 4, 5]  # of idpPnt's numbers: without the anchor's height and the elevation
ROBOT = np.array([1.0, -2.0, 0.4])
TREE = np.array([3.0, 4.0])
NEAR = np.array([0, 0, 0, 3.0])  # so that w is above zero
RANGE_BEARING = Calibration(plane_range_bearing.PLANE_RANGE_BEARING, np.eye(2))


@pytest.fixture
def rng():
    return np.random.default_rng(31)


def both(model, *arguments):
    """Value and Jacobians, after the value alone was seen to be the same."""
    value, jacobians = model.jac(*arguments)
    assert model(*arguments) == pytest.approx(value)
    return value, jacobians


def test_range_and_bearing_have_the_jacobians_of_every_textbook():
    pose, lift = in_space.jac(ROBOT)
    seen = observe(PLANE_POINT, RANGE_BEARING, pose, ORIGIN, TREE)
    dx, dy = TREE - ROBOT[:2]
    r = np.hypot(dx, dy)
    assert seen.value == pytest.approx([r, np.arctan2(dy, dx) - ROBOT[2]])
    by_tree = np.array([[dx / r, dy / r], [-dy / r**2, dx / r**2]])
    by_robot = np.column_stack([-by_tree, [0, -1]])
    assert seen.jacobians.landmark == pytest.approx(by_tree)
    assert seen.jacobians.robot @ lift.state == pytest.approx(by_robot)
    assert seen.jacobians.robot[:, 2] == pytest.approx(0), "the height of the robot changes nothing"


def test_one_number_alone_is_a_row_of_both(rng):
    for point in rng.standard_normal((5, 4)) + NEAR:
        pair, J = both(plane_range_bearing.project, point)
        level, G = both(range_bearing.project, point * [1, 1, 0, 1])
        assert pair == pytest.approx(level[:2])
        assert J.point[:, [0, 1, 3]] == pytest.approx(G.point[:2, [0, 1, 3]])
        assert J.point[:, 2] == pytest.approx(0)
        for row, sensor in enumerate((plane_range, plane_bearing)):
            one, K = both(sensor.project, point)
            assert one == pytest.approx(pair[row : row + 1])
            assert K.point == pytest.approx(J.point[row : row + 1])


def test_back_projection_is_that_of_space_at_pitch_zero(rng):
    for r, bearing in zip(rng.uniform(0.5, 9, 5), rng.uniform(-3, 3, 5), strict=True):
        ray, J = both(range_bearing.back_project, np.array([r, bearing, 0]))
        pair, B = both(plane_range_bearing.back_project, np.array([r, bearing]))
        assert pair == pytest.approx(ray)
        assert B.measurement == pytest.approx(J.measurement[:, :2])
        far, F = both(plane_range.back_project, np.array([r]), np.array([bearing]))
        assert far == pytest.approx(ray)
        assert np.c_[F.measurement, F.unmeasured] == pytest.approx(J.measurement[:, :2])
        turned, T = both(plane_bearing.back_project, np.array([bearing]), np.array([1 / r]))
        assert turned == pytest.approx(ray)
        assert T.measurement == pytest.approx(J.measurement[:, 1:2])
        assert T.unmeasured == pytest.approx(np.array([[0, 0, 0, 1]]).T)


def test_in_a_frame_anywhere_they_are_the_points_of_space_at_height_zero(rng):
    for _ in range(5):
        pose, (x, y, azimuth), inverse = Pose.random(rng), rng.standard_normal(3), rng.uniform(0.1, 2)
        value, J = both(PLANE_POINT.to_frame, pose, np.array([x, y]))
        wanted, G = both(EUC_POINT.to_frame, pose, np.array([x, y, 0]))
        assert value == pytest.approx(wanted)
        assert J.pose == pytest.approx(G.pose)
        assert J.landmark == pytest.approx(G.landmark[:, :2])
        value, J = both(PLANE_IDP_POINT.to_frame, pose, np.array([x, y, azimuth, inverse]))
        wanted, G = both(IDP_POINT.to_frame, pose, np.array([x, y, 0, 0, azimuth, inverse]))
        assert value == pytest.approx(wanted)
        assert J.pose == pytest.approx(G.pose)
        assert J.landmark == pytest.approx(G.landmark[:, KEPT])
        value, J = both(PLANE_POINT.to_point, np.array([x, y]))
        assert value == pytest.approx([x, y, 0])
        assert J.landmark == pytest.approx(np.eye(3, 2))
        value, J = both(PLANE_IDP_POINT.to_point, np.array([x, y, azimuth, inverse]))
        wanted, G = both(IDP_POINT.to_point, np.array([x, y, 0, 0, azimuth, inverse]))
        assert value == pytest.approx(wanted)
        assert J.landmark == pytest.approx(G.landmark[:, KEPT])


def test_they_begin_as_the_points_of_space_without_the_height(rng):
    for _ in range(5):
        pose, point = Pose.random(rng), rng.standard_normal(4) + NEAR
        value, J = both(PLANE_POINT.from_frame, pose, point)
        wanted, G = both(EUC_POINT.from_frame, pose, point)
        assert value == pytest.approx(wanted[:2])
        assert J.pose == pytest.approx(G.pose[:2])
        assert J.point == pytest.approx(G.point[:2])
        value, J = both(PLANE_IDP_POINT.from_frame, pose, point)
        wanted, G = both(IDP_POINT.from_frame, pose, point)
        shadow, slope = np.cos(wanted[3]), np.sin(wanted[3])  # of a ray of length one, on the floor and upwards
        assert value == pytest.approx(wanted[KEPT] / [1, 1, 1, shadow])
        for mine, theirs in ((J.pose, G.pose), (J.point, G.point)):
            assert mine[:3] == pytest.approx(theirs[KEPT[:3]])
            by_inverse = theirs[5] / shadow + wanted[5] * slope / shadow**2 * theirs[3]
            assert mine[3] == pytest.approx(by_inverse)
