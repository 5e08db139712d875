"""What the filter keeps, or computes in a quicker way: it is what it was, and follows every change."""

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.entities import RigSensor, Robot
from slamlib.errors import NonFiniteError, SingularPointError, UnitError
from slamlib.geometry.pose import Pose, compose
from slamlib.kalman import linalg
from slamlib.landmarks.ahm_point import AHM_POINT
from slamlib.landmarks.linearity import euclidean_index
from slamlib.models import kernel, model
from slamlib.motions import motion
from slamlib.observation.family import columns_jacobian, viewpoint
from slamlib.observation.points import observe, observe_from
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.gates import mahalanobis_squared
from slamlib.tests.beliefs import random_covariance

PLACEHOLDER_POINT = np.array(
    [0.0, 0, 0, 0.1, -0.2, 1, 0.2]
)  # an anchored point in the view of a camera near the origin


@pytest.fixture
def rng():
    return np.random.default_rng(5)


def camera(**changes):
    """A pin-hole camera with two coefficients."""
    given = {"intrinsics": [320.0, 240, 500, 500], "distortion": [-0.2, 0.03], **changes}
    return Calibration(PINHOLE, np.eye(2), image=(640, 480), **given)


def rig_sensor(rng, *, estimated):
    """A camera on a robot, in a belief."""
    belief, odometry = Belief(), motion("odometry")
    near = np.array([0.0, 0, 0, 1, 0, 0, 0])
    robot = Robot("robot", odometry, belief.add(Pose, Pose.plus(near, 0.1 * rng.standard_normal(6)), np.eye(6)), None)
    extrinsics = Pose.plus(near, 0.1 * rng.standard_normal(6))
    block = belief.add(Pose, extrinsics, np.eye(6)) if estimated else None
    return belief, RigSensor("camera", robot, camera(), extrinsics, block)


@pytest.mark.parametrize("estimated", [False, True])
def test_the_viewpoint_a_sensor_follows_every_change(rng, estimated):
    belief, sensor = rig_sensor(rng, estimated=estimated)
    blocks = sensor.blocks
    for _ in range(3):
        for block in blocks:
            moved = Pose.plus(block.mean, 1e-12 + 0.1 * rng.standard_normal(6))
            belief.predict(block, moved, np.eye(6), np.eye(6))
            pose, J = compose.jac(sensor.robot.pose, sensor.extrinsics)
            for _ in range(2):
                assert np.array_equal(viewpoint(sensor).pose, pose)
                assert np.array_equal(viewpoint(sensor).jacobian, np.concatenate(list(J)[: len(blocks)], axis=1))
    sensor.given_extrinsics = Pose.random(rng)
    assert np.array_equal(viewpoint(sensor).pose, sensor.camera)
    before, place = belief.snapshot(), viewpoint(sensor)
    belief.update(blocks[:1], [np.eye(6)], np.full(6, 0.1), np.eye(6))
    assert not np.array_equal(viewpoint(sensor).pose, place.pose)
    belief.restore(before)
    assert np.array_equal(viewpoint(sensor).pose, place.pose)
    with pytest.raises(ValueError, match="read-only"):
        place.pose[0] = 0


@pytest.mark.parametrize("estimated", [False, True])
@pytest.mark.parametrize("lead", [(), (2,), (30,)])
def test_jacobians_wrt_the_sensor_pose_are_those_wrt_robot_and_extrinsics(rng, estimated, lead):
    _, sensor = rig_sensor(rng, estimated=estimated)
    points = PLACEHOLDER_POINT + 0.01 * rng.standard_normal((*lead, 7))
    whole = observe(AHM_POINT, sensor.calibration, sensor.robot.pose, sensor.extrinsics, points)
    place = viewpoint(sensor)
    found = observe_from(AHM_POINT, sensor.calibration, place.pose, points)
    J = whole.jacobians
    expected = np.concatenate([J.robot, J.extrinsics, J.landmark] if estimated else [J.robot, J.landmark], axis=-1)
    assert np.array_equal(found.visible, whole.visible)
    assert np.all(whole.visible)
    assert np.allclose(found.value, whole.value, rtol=0, atol=1e-12)
    by = columns_jacobian(place, found.jacobians.camera, found.jacobians.landmark)
    assert np.allclose(by, expected, rtol=1e-12, atol=1e-10)


def test_each_calibration_projects_with_its_own_parameters(rng):
    points = np.array([[0.1, -0.2, 1, 1], [0.3, 0.1, 2, 0.5]])
    cameras = [camera(), camera(distortion=[-0.1, 0.03]), camera(intrinsics=[320.0, 240, 480, 500]), camera()]
    for each in [*cameras, *cameras[::-1]]:
        expected, J = PINHOLE.project.jac(points, each.given["intrinsics"], each.given["distortion"])
        value, found = each.project_jac(points)
        assert np.allclose(value, expected, rtol=0, atol=1e-12)
        assert np.array_equal(each.project(points), value)
        assert np.allclose(found.point, J.point, rtol=1e-12, atol=1e-12)
        assert np.allclose(found.distortion, J.distortion[..., :2], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("margin", [0.0, 20.0])
def test_one_pixel_is_inside_like_many(margin):
    pixels = np.array([[0.0, 0], [640, 480], [20, 20], [19.9, 30], [630, 200], [300, 470], [-0.1, 5], [np.nan, 5]])
    found = camera().inside(pixels, margin)
    assert [camera().inside(pixel, margin).all() for pixel in pixels] == found.tolist()


@model(x=2)
def inverses(x):
    """Singular where a number is zero."""
    return np.array([1 / x[0], x[1] / x[0], 1 / x[1]])


@pytest.mark.parametrize("lead", [(1,), (3,), (2, 2), (1, 4)])
def test_few_items_are_like_many(rng, monkeypatch, lead):
    pose, points = Pose.random(rng), rng.standard_normal((*lead, 7))
    poses = np.array([Pose.random(rng) for _ in range(lead[-1])])  # broadcast over the axes before
    few = [*AHM_POINT.to_frame.jac(pose, points)[1], *AHM_POINT.to_frame.jac(poses, points)[1]]
    bad = np.ones((*lead, 2))
    bad[(-1,) * len(lead)] = 0
    place = ", ".join(str(n - 1) for n in lead)
    for _ in range(2):
        with pytest.raises(SingularPointError, match=rf"item \({place},?\) of the batch"):
            inverses.jac(bad)
        monkeypatch.setattr(kernel, "_FEW", -1)
    many = [*AHM_POINT.to_frame.jac(pose, points)[1], *AHM_POINT.to_frame.jac(poses, points)[1]]
    for a, b in zip(few, many, strict=True):
        assert np.allclose(a, b, rtol=1e-13, atol=1e-13)


def test_one_item_is_checked_as_many_are():
    with pytest.raises(NonFiniteError, match=r"argument 'landmark' holds nan at index \(2,\)"):
        AHM_POINT.to_frame(np.array([0.0, 0, 0, 1, 0, 0, 0]), np.array([0, 0, np.nan, 1, 1, 1, 1]))
    with pytest.raises(UnitError, match="to_frame: argument 'pose'"):
        AHM_POINT.to_frame(np.array([0.0, 0, 0, 1, 1, 0, 0]), PLACEHOLDER_POINT)
    with pytest.raises(SingularPointError, match="inverses is not defined"):
        inverses(np.array([0.0, 1]))
    assert np.array_equal(inverses(np.array([1e308, 1e-308]))[2:], [1 / 1e-308])  # finite, however large together


def test_an_index_by_other_coordinates_is_that_of_their_covariance(rng):
    means, pose = PLACEHOLDER_POINT + 0.01 * rng.standard_normal((3, 7)), np.array([0.0, 0, 0, 1, 0, 0, 0])
    P, T = np.array([random_covariance(rng, 15) for _ in means]), rng.standard_normal((13, 15))
    expected = euclidean_index(AHM_POINT, means, T @ P @ T.T, pose)
    assert np.allclose(euclidean_index(AHM_POINT, means, P, pose, T), expected, rtol=1e-9, atol=0)


@pytest.mark.parametrize("d", [1, 2, 3, 4])
def test_small_algebra_of_many_matrices(rng, d):
    matrices, z = np.array([random_covariance(rng, d) for _ in range(5)]), rng.standard_normal((5, d))
    expected = [x @ np.linalg.solve(S, x) for x, S in zip(z, matrices, strict=True)]
    assert np.allclose(mahalanobis_squared(z, matrices), expected, rtol=1e-9, atol=0)
    assert np.allclose(linalg.log_determinants(matrices), np.linalg.slogdet(matrices)[1], rtol=0, atol=1e-10)
    whole, rows = random_covariance(rng, 9), rng.integers(0, 9, (5, d))
    assert np.array_equal(linalg.principal_blocks(whole, rows), whole[rows[:, :, None], rows[:, None, :]])
