"""Depth camera, stereo pair, relative position, range and bearing: definitions, nasty points, noise, bad input."""

import numpy as np
import pytest

from slamlib.codegen import check_model
from slamlib.errors import (
    CovarianceError,
    NonFiniteError,
    ShapeError,
    SingularPointError,
    SlamlibError,
    UnknownNameError,
)
from slamlib.geometry import pose as frames
from slamlib.geometry.pose import Pose
from slamlib.landmarks.ahm_point import AHM_POINT
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.observation.points import initialize, observe
from slamlib.sensors import depth, pinhole, range_bearing, relative_position, sensor, stereo
from slamlib.sensors.sensor import Calibration
from slamlib.tests.differences import differences

INTRINSICS, DISTORTION = np.array([320.0, 240, 400, 410]), np.array([-0.2, 0.05])
NOISE = np.array([[1.0, 0.2, 0.1], [0.2, 1.5, -0.1], [0.1, -0.1, 0.3]])
MODELS = [
    depth.project, depth.lift, stereo.project, stereo.back_project,
    relative_position.project, relative_position.back_project, range_bearing.project, range_bearing.back_project,
]  # fmt: skip


def calibrations():
    camera = {"image": (640, 480), "intrinsics": INTRINSICS}
    return [
        Calibration(depth.PINHOLE_DEPTH, NOISE, distortion=DISTORTION, **camera),
        Calibration(stereo.STEREO, NOISE, baseline=[0.3], **camera),
        Calibration(relative_position.RELATIVE_POSITION, NOISE),
        Calibration(range_bearing.RANGE_BEARING, NOISE / 100),
    ]


NAMES = ["pinHoleDepth", "stereo", "relativePosition", "rangeBearing"]
ALL = pytest.mark.parametrize("calibration", calibrations(), ids=NAMES)


@pytest.fixture
def rng():
    return np.random.default_rng(10)


def ahead(rng, count):
    """Euclidean points that all four sensors see, in a frame whose third axis points ahead."""
    return np.stack([*rng.uniform(-0.4, 0.4, (2, count)), np.ones(count)], axis=-1) * rng.uniform(1, 20, (count, 1))


def homogeneous(points, w=1.0):
    return np.concatenate([points, np.full((*points.shape[:-1], 1), w)], axis=-1)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module.split(".")[-1] + "." + m.name)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module.split(".")[-1] + "." + m.name)
def test_central_differences_and_a_batch_agree(model, rng):
    items = [[0.4 * rng.standard_normal(a.shape) + 1 for a in model.arguments] for _ in range(3)]
    _, jacobians = model.jac(*items[0])
    for index in range(len(items[0])):
        numerical = differences(model, items[0], index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-6 * max(1, np.abs(numerical).max()))
    value, many = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, single = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-12)
        assert many[0][n] == pytest.approx(single[0], rel=1e-10, abs=1e-10)


@ALL
def test_there_and_back(calibration, rng):
    points = ahead(rng, 50)
    measured, J = calibration.project_jac(homogeneous(points))
    assert calibration.visible(homogeneous(points)).all()
    again, K = calibration.back_project_jac(measured)
    assert again[:, :3] / again[:, 3:] == pytest.approx(points, rel=1e-9)
    assert np.linalg.norm(again[:, :3], axis=1) == pytest.approx(np.ones(50))
    by_again = calibration.project_jac(again)[1]
    assert by_again.point @ K.measurement == pytest.approx(np.tile(np.eye(3), (50, 1, 1)), abs=1e-8)
    for name in calibration.given:
        total = getattr(by_again, name) + by_again.point @ getattr(K, name)
        assert total == pytest.approx(np.zeros_like(total), abs=1e-7 * np.abs(getattr(J, name)).max())


@ALL
def test_only_the_ratio_of_the_homogeneous_point_matters(calibration, rng):
    point = homogeneous(ahead(rng, 5))
    assert calibration.project(7 * point) == pytest.approx(calibration.project(point), rel=1e-12)
    point[:, 3] = 0.2
    assert calibration.project_jac(point)[1].point @ point[..., None] == pytest.approx(np.zeros((5, 3, 1)), abs=1e-10)


@ALL
def test_initialize_and_observe_undo_each_other(calibration, rng):
    robot, extrinsics = Pose.random(rng), Pose.random(rng)
    y = calibration.project(homogeneous(ahead(rng, 8)))
    for kind in (EUC_POINT, AHM_POINT):
        landmarks, J = initialize(kind, calibration, robot, extrinsics, y)
        seen = observe(kind, calibration, robot, extrinsics, landmarks)
        assert seen.visible.all()
        assert seen.value == pytest.approx(y, rel=1e-9)
        assert seen.jacobians.landmark @ J.measurement == pytest.approx(np.tile(np.eye(3), (8, 1, 1)), abs=1e-8)
        for name in ("robot", "extrinsics", *calibration.given):
            total = getattr(seen.jacobians, name) + seen.jacobians.landmark @ getattr(J, name)
            assert total == pytest.approx(np.zeros_like(total), abs=1e-7 * np.abs(seen.jacobians.robot).max())


# -- at infinity -------------------------------------------------------------------------------------------------------


def test_a_stereo_pair_sees_points_at_infinity():
    pair, far = calibrations()[1], np.array([0.1, -0.2, 1.0, 0.0])
    assert pair.visible(far)
    value, J = pair.project_jac(far)
    assert value == pytest.approx([360, 158, 0])
    assert J.point[2] == pytest.approx([0, 0, 0, 120])
    assert pair.back_project_jac(value)[0] == pytest.approx(far / np.linalg.norm(far))


@pytest.mark.parametrize("index", [0, 2, 3])
def test_what_measures_a_distance_does_not_see_infinity(index):
    far = np.array([[0.1, -0.2, 1.0, 0.0], [0.1, -0.2, 1.0, 1e-3]])
    assert calibrations()[index].visible(far).tolist() == [False, True]
    with pytest.raises(SingularPointError, match="project is not defined"):
        calibrations()[index].project(far[0])


def test_a_landmark_at_infinity_is_no_trouble_in_a_batch():
    landmarks = np.array([[0, 0, 0, 0.1, 0.1, 1, 0.0], [0, 0, 0, 0.1, 0.1, 1, 0.2]])
    nowhere = np.array([0, 0, 0, 1.0, 0, 0, 0])
    for calibration, seen in zip(
        calibrations(), ([False, True], [True, True], [False, True], [False, True]), strict=True
    ):
        found = observe(AHM_POINT, calibration, nowhere, nowhere, landmarks)
        assert found.visible.tolist() == seen
        assert np.isfinite(found.value).all()


# -- depth camera ------------------------------------------------------------------------------------------------------


def test_depth_is_along_the_axis_not_the_range(rng):
    camera, points = calibrations()[0], ahead(rng, 20)
    measured = camera.project(homogeneous(points))
    assert measured[:, 2] == pytest.approx(points[:, 2])
    same = pinhole.project(homogeneous(points), INTRINSICS, np.pad(DISTORTION, (0, 6)))
    assert measured[:, :2] == pytest.approx(same)


def test_limits_of_depth():
    camera = Calibration(
        depth.PINHOLE_DEPTH, NOISE, intrinsics=INTRINSICS, distortion=[0.0], limits={"near": 0.5, "far": 4.0}
    )
    z = np.array([0.49, 0.51, 3.99, 4.01, -1.0])
    points = homogeneous(np.stack([0 * z, 0 * z, z], axis=-1), 1.0)
    assert camera.visible(points).tolist() == [False, True, True, False, False]
    assert camera.visible(-points).tolist() == [False] * 5  # a negative inverse distance is not seen


# -- stereo pair -------------------------------------------------------------------------------------------------------


def test_disparity_is_the_difference_of_the_two_pin_holes_columns(rng):
    points = ahead(rng, 20)
    left = pinhole.project(homogeneous(points), INTRINSICS, np.zeros(8))
    right = pinhole.project(homogeneous(points - [0.3, 0, 0]), INTRINSICS, np.zeros(8))
    measured = calibrations()[1].project(homogeneous(points))
    assert measured[:, :2] == pytest.approx(left)
    assert measured[:, 2] == pytest.approx(left[:, 0] - right[:, 0])
    assert right[:, 1] == pytest.approx(left[:, 1])  # rectified: the rows are the same


def test_a_stereo_pair_sees_what_both_cameras_see():
    pair = calibrations()[1]
    near_left_border = np.array([-0.79, 0, 1.0])  # in the left image at column 4, in the right one at -116
    far_at_left_border = 100 * np.array([-0.79, 0, 1.0])  # there the right column is 2.8
    assert pair.inside(pair.project(homogeneous(near_left_border)))
    assert pair.visible(homogeneous(np.stack([near_left_border, far_at_left_border]))).tolist() == [False, True]
    behind = homogeneous(np.array([[0, 0, -1.0], [0, 0, 0]]))
    assert not pair.visible(behind).any()
    assert not pair.visible(-homogeneous(np.array([0, 0, -1.0])) * [1, 1, 1, 1]).any()
    limited = Calibration(stereo.STEREO, NOISE, intrinsics=INTRINSICS, baseline=[0.3], limits={"disparity": 2.0})
    assert limited.visible(homogeneous(np.array([[0, 0, 59.0], [0, 0, 61.0]]))).tolist() == [True, False]


def test_the_errata_s_stereo_noise_at_ten_metres():
    """f = 700 px, b = 0.3 m, 0.5 px in each column and row: sigma = (0.063, 0.018, 0.337) m (E12)."""
    sigma, x = 0.5, 10 * (75 / 700)
    pixels = sigma**2 * np.array([[1.0, 0, 1], [0, 1, 0], [1, 0, 2]])  # of (u, v, u - u_right), from (u, v, u_right)
    pair = Calibration(stereo.STEREO, pixels, intrinsics=[320, 240, 700, 700], baseline=[0.3])
    position, R = relative_position.converted(pair, pair.project(np.array([x, 0.5, 10, 1.0])))
    assert position == pytest.approx([x, 0.5, 10])
    assert np.sqrt(R[2, 2]) == pytest.approx(np.sqrt(2) * sigma * 100 / 210)
    assert np.sqrt(R[2, 2]) == pytest.approx(0.337, abs=1e-3)
    assert R[0, 2] / np.sqrt(R[0, 0] * R[2, 2]) > 0.9
    samples = pair.project(np.array([x, 0.5, 10, 1.0])) + np.random.default_rng(0).multivariate_normal(
        np.zeros(3), pixels, 200000
    )
    many, _ = relative_position.converted(pair, samples)
    assert np.cov(many.T) == pytest.approx(R, rel=0.05, abs=0.05 * R[0, 0])


# -- relative position -------------------------------------------------------------------------------------------------


def test_relative_position_is_the_reports_model(rng):
    """z = R'(m - t), equations (5.24) and (5.25) of the report, without its 4 x 4 landmark (E11)."""
    robot, m = Pose.random(rng), rng.standard_normal(3)
    nowhere = np.array([0, 0, 0, 1.0, 0, 0, 0])
    seen = observe(EUC_POINT, calibrations()[2], robot, nowhere, m)
    assert seen.value == pytest.approx(frames.to_frame(robot, m))
    assert seen.visible


@ALL
def test_converted_covariance_is_that_of_samples(calibration):
    rng = np.random.default_rng(3)
    small = Calibration(calibration.sensor, 1e-4 * calibration.noise, **calibration.given)
    y = small.project(np.array([0.5, 0.3, 2.0, 1.0]))
    position, R = relative_position.converted(small, y)
    assert position == pytest.approx([0.5, 0.3, 2.0])
    samples, many = relative_position.converted(small, rng.multivariate_normal(y, small.noise, 100000))
    assert np.cov(samples.T) == pytest.approx(R, abs=0.03 * np.abs(R).max())
    assert many.shape == (100000, 3, 3)


def test_a_point_at_the_sensor_has_no_direction():
    relative = calibrations()[2]
    assert not relative.visible(np.array([0.0, 0, 0, 1]))
    with pytest.raises(SingularPointError):
        relative.back_project_jac([0.0, 0, 0])


# -- range and bearing -------------------------------------------------------------------------------------------------


def test_range_yaw_and_pitch_of_the_axes():
    points = {
        (1.0, 0, 0): (1, 0, 0), (0, 2.0, 0.001): (2, np.pi / 2, 0), (1, 0, 1): (np.sqrt(2), 0, -np.pi / 4),
        (1, 0, -1): (np.sqrt(2), 0, np.pi / 4), (-3, 0, 0): (3, np.pi, 0),
    }  # fmt: skip
    for point, wanted in points.items():
        assert calibrations()[3].project(homogeneous(np.array(point, dtype=float))) == pytest.approx(wanted, abs=1e-3)


def test_pitch_is_minus_the_arcsine_of_height_over_range(rng):
    for point in rng.standard_normal((20, 3)):
        r, yaw, pitch = calibrations()[3].project(homogeneous(point))
        assert r == pytest.approx(np.linalg.norm(point))
        assert pitch == pytest.approx(-np.arcsin(point[2] / r))
        assert yaw == pytest.approx(np.arctan2(point[1], point[0]))


def test_the_difference_of_two_yaws_is_the_short_way_round():
    manifold = range_bearing.project.result.manifold
    step = manifold.minus(np.array([5, np.radians(-179), 0.1]), np.array([4, np.radians(179), 0.3]))
    assert step == pytest.approx([1, np.radians(2), -0.2])
    turns = manifold.minus(np.array([[1, 7.0, 0], [1, -9.0, 0], [1, 0.3, 0]]), np.array([1, 0, 0]))[:, 1]
    assert turns == pytest.approx([7 - 2 * np.pi, -9 + 2 * np.pi, 0.3])


def test_no_yaw_on_the_vertical():
    ranger = calibrations()[3]
    assert ranger.visible(np.array([[0, 0, 1.0, 1], [1e-9, 0, 1, 1]])).tolist() == [False, True]
    with pytest.raises(SingularPointError):
        ranger.project_jac(np.array([0, 0, 1.0, 1]))


def test_limits_of_range_and_bearing():
    ranger = Calibration(
        range_bearing.RANGE_BEARING, NOISE, limits={"near": 0.5, "far": 30, "yaw": np.radians(135), "pitch": 0.2}
    )
    points = [(0.4, 0, 0), (29, 0, 0), (31, 0, 0), (-1, 0.9, 0), (-1, 1.1, 0), (1, -1, 0), (1, 0, 0.21), (1, 0, -0.2)]
    seen = [False, True, False, False, True, True, False, True]
    assert ranger.visible(homogeneous(np.array(points, dtype=float))).tolist() == seen


# -- bad input ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "changes", "error", "message"),
    [
        ("stereo", {"baseline": [-0.1]}, SlamlibError, "baseline is one length above zero"),
        ("stereo", {"baseline": [0.1, 0.2]}, ShapeError, "baseline has at most 1"),
        ("stereo", {"intrinsics": [320.0, 240.0]}, SlamlibError, r"intrinsics are \(u0, v0, au, av\)"),
        ("stereo", {"intrinsics": [320.0, 240.0, 0.0, 400.0]}, SlamlibError, "au, av > 0"),
        ("stereo", {"limits": {"near": 1.0}}, UnknownNameError, "limit of stereo"),
        ("stereo", {"noise": np.diag([1, 1, -1.0])}, CovarianceError, "negative variance"),
        ("pinHoleDepth", {"intrinsics": [320.0, 240.0, -400, 400]}, SlamlibError, "intrinsics are"),
        ("pinHoleDepth", {"limits": {"near": 4.0, "far": 1.0}}, SlamlibError, "'near' .* less than 'far'"),
        ("pinHoleDepth", {"distortion": [-2.0]}, SlamlibError, "folds back"),
        ("relativePosition", {"limits": {"far": -1.0}}, SlamlibError, "zero or more"),
        ("relativePosition", {"intrinsics": [1.0]}, UnknownNameError, "parameter of relativePosition"),
        ("relativePosition", {"image": (640, 480)}, SlamlibError, "relativePosition: its measurements are no pixels"),
        ("rangeBearing", {"image": (640, 480)}, SlamlibError, "bound the view by limits"),
        ("stereo", {"image": (0, 480)}, SlamlibError, "a width and a height above zero"),
        ("rangeBearing", {"limits": {"yaw": [1.0, 2.0]}}, SlamlibError, "should be a number"),
        ("rangeBearing", {"noise": np.eye(2)}, ShapeError, "noise should have shape"),
    ],
)
def test_a_calibration_that_makes_no_sense_is_refused(name, changes, error, message):
    known = calibrations()[NAMES.index(name)]
    given = {"noise": known.noise, "image": known.image, **known.given, **changes}
    noise = given.pop("noise")
    with pytest.raises(error, match=message):
        Calibration(known.sensor, noise, **given)


@ALL
def test_measurements_that_are_no_numbers_are_refused(calibration):
    with pytest.raises(NonFiniteError, match="'measurement' holds nan"):
        calibration.back_project_jac([np.nan, 1.0, 2.0])
    with pytest.raises(ShapeError, match="measurement"):
        calibration.back_project_jac([1.0, 2.0])


def test_a_depth_or_range_of_zero_is_refused():
    for index in (0, 3):
        with pytest.raises(SingularPointError):
            calibrations()[index].back_project_jac([0.0, 0.0, 0.0])


def test_they_are_found_by_name():
    assert [sensor(n).name for n in NAMES] == NAMES
