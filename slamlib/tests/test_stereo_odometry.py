"""Motion between pairs: its direction, its covariance, and what it is worth on pictures."""

import numpy as np
import pytest
from slambook.stereo_films import Tracks, pixel_noise, stereo_film

from slamlib.evaluation.consistency import nees
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.geometry.quaternion import exponential
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.motions import ODOMETRY
from slamlib.tests.stereo import MOUNT, calibration, kitti, points_seen, seen_from
from slamlib.vision.stereo import StereoFeatureExtractor, VisualOdometry, motion_between
from slamlib.vision.stereo.odometry import checkerboard_half

cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")

CONTROL = np.array([0.08, -0.02, 0.01, 0.01, -0.02, 0.04])  # of a robot whose x axis points ahead


def moved(control=CONTROL):
    """The robot's new pose in its old frame."""
    return ODOMETRY.step(ORIGIN, control, 0.1)


def test_the_control_has_the_right_direction():
    """E20: solvePnP gives the way of the points; the robot's is its inverse. Ahead is ahead."""
    rng = np.random.default_rng(1)
    points = points_seen(rng, 60, MOUNT)
    ahead = np.array([0.4, 0, 0, 0, 0, 0])
    old, new = seen_from(points, ORIGIN, MOUNT), seen_from(points, moved(ahead), MOUNT)
    found = motion_between(calibration(), old, new, MOUNT)
    np.testing.assert_allclose(found.control.value, ahead, atol=1e-8)


def test_exact_matches_give_the_exact_control():
    rng = np.random.default_rng(2)
    points = points_seen(rng, 40, MOUNT)
    old, new = seen_from(points, ORIGIN, MOUNT), seen_from(points, moved(), MOUNT)
    found = motion_between(calibration(), old, new, MOUNT)
    np.testing.assert_allclose(found.control.value, CONTROL, atol=1e-8)
    np.testing.assert_allclose(found.pose, moved(), atol=1e-8)
    assert found.inliers.all()
    assert found.nis_per_dof < 1e-10


def test_wrong_matches_are_left_out():
    rng = np.random.default_rng(3)
    points = points_seen(rng, 80, MOUNT)
    old, new = seen_from(points, ORIGIN, MOUNT), seen_from(points, moved(), MOUNT)
    new[:24] = new[rng.permutation(24)] + rng.uniform(-30, 30, (24, 3)) * [1, 1, 0.2]
    found = motion_between(calibration(), old, new, MOUNT)
    assert found.inliers[24:].all()
    assert found.inliers[:24].sum() <= 2
    np.testing.assert_allclose(found.control.value, CONTROL, atol=1e-3)


@pytest.mark.parametrize("shift", [-1.8, 1.8])
def test_a_far_match_may_be_wrong_in_its_parallax(shift):
    """An inlier of RANSAC, off by less than its limit: its best old disparity may be below zero, of no point."""
    rng, aside = np.random.default_rng(5), np.array([0, 0.2, 0, 0, 0, 0])
    points = np.concatenate([points_seen(rng, 40, MOUNT), points_seen(rng, 1, MOUNT) * [100, 1, 1]])
    old, new = seen_from(points, ORIGIN, MOUNT), seen_from(points, moved(aside), MOUNT)
    new[-1, 0] += shift
    found = motion_between(calibration(), old, new, MOUNT)
    np.testing.assert_allclose(found.control.value, aside, atol=2e-3)


def test_too_few_matches_are_no_motion():
    rng = np.random.default_rng(4)
    old = seen_from(points_seen(rng, 7), ORIGIN)
    assert motion_between(calibration(), old, old) is None
    assert motion_between(calibration(), old[:0], old[:0]) is None


@pytest.mark.parametrize("noise", [0.3**2 * np.eye(3), pixel_noise(0.3, 0.3)], ids=["refined", "detected"])
def test_the_control_s_covariance_by_monte_carlo(noise):
    """NEES of 300 draws, noise in both pairs, inside its 99.9 % band; and no bias of the mean."""
    rng, draws = np.random.default_rng(5), 300
    made = calibration(noise)
    errors, covariances = [], []
    for _ in range(draws):
        points = points_seen(rng, 50, MOUNT)
        exact = [seen_from(points, pose, MOUNT) for pose in (ORIGIN, moved())]
        old, new = (z + rng.multivariate_normal(np.zeros(3), noise, len(z)) for z in exact)
        found = motion_between(made, old, new, MOUNT)
        errors.append(found.control.value - CONTROL)
        covariances.append(found.control.covariance)
    squares = nees(np.array(errors), np.array(covariances))
    low, high = (chi2_quantile(p, 6 * draws) / draws for p in (0.0005, 0.9995))
    assert low < squares.mean() < high, (squares.mean(), low, high)


def test_halves_share_no_measurement():
    values = np.random.default_rng(6).uniform(0, 640, (500, 3))
    half = checkerboard_half(values)
    assert set(half) == {0, 1}
    assert 0.4 < half.mean() < 0.6


def test_odometry_in_the_room_stays_near():
    rig, frames, _ = stereo_film(25)
    sensor = rig.sensors[0]
    true = np.array([truth.poses[0] for _, truth in frames])
    odometry, pose = VisualOdometry(StereoFeatureExtractor(sensor.calibration), sensor.extrinsics), true[0]
    tracks = Tracks()
    for i, (frame, _) in enumerate(frames):
        motion = odometry.step(frame.scans[0].image)
        assert (motion is None) == (i == 0)
        pose = pose if motion is None else compose(pose, motion.pose)
        reobserved = tracks.step(len(odometry.old), odometry.pairs)
        assert len(tracks.ids) == len(odometry.old) == len(set(tracks.ids.tolist()))
        assert reobserved.sum() == len(odometry.pairs)
    assert tracks.ages.max() > 10
    path = np.linalg.norm(np.diff(true[:, :3], axis=0), axis=1).sum()
    error = Pose.minus(true[-1], pose)
    assert np.linalg.norm(error[:3]) < 0.02 * path
    assert np.degrees(np.linalg.norm(error[3:])) < 0.5


def test_a_prediction_bounds_the_matches():
    rig, frames, _ = stereo_film(2)
    sensor = rig.sensors[0]
    images = [frame.scans[0].image for frame, _ in frames]
    odometry = VisualOdometry(StereoFeatureExtractor(sensor.calibration), sensor.extrinsics)
    odometry.step(images[0])
    away = np.concatenate([[0, 0, 0], exponential(np.array([0, 0, np.radians(25)]))])
    assert odometry.step(images[1], away) is None  # searched for where nothing is
    assert len(odometry.pairs) < 10


def test_odometry_on_a_real_street():
    made, pairs, truth = kitti(15)
    odometry, pose, inliers = VisualOdometry(StereoFeatureExtractor(made)), truth.poses[0], []
    for image in pairs:
        motion = odometry.step(image)
        if motion is not None:
            pose = compose(pose, motion.pose)
            inliers.append(motion.inliers.sum())
    error = np.linalg.norm(pose[:3] - truth.poses[-1, :3]) / truth.distances[-1]
    assert len(inliers) == 14
    assert min(inliers) > 30
    assert error < 0.025
