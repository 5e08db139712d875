"""Two-view initialization and relocalization of one camera, in rendered films of a room."""

import numpy as np
import pytest

pytest.importorskip("cv2")

from slambook import rendering

from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.sources import of_pictures
from slamlib.geometry.pose import Pose, compose, relative, to_frame
from slamlib.geometry.quaternion import rotation
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.sensors.omni import OMNI, powers
from slamlib.sensors.pinhole import distort_radius
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Slam
from slamlib.vision.active_search import ActiveSearch
from slamlib.vision.opening import options_for
from slamlib.vision.relocalization import close_loop, relocalize
from slamlib.vision.target import Target, focal_length
from slamlib.vision.two_views import direction_error, turning_rate, two_view_target

DT = 1 / 30


def film(name, frames, start=0, seed=1):
    """The rig, the frames, and the true poses of the robot, from frame `start` on."""
    way = rendering.path(name)
    rig = rendering.rig_along_path(way, std=(0.035,))
    made = rendering.film(
        rendering.default_room("drawn"), rig, way, frames=start + frames, dt=DT, rng=np.random.default_rng(seed)
    )
    steps = list(made)[start:]
    return rig, [frame for frame, _ in steps], np.array([truth.poses[0] for _, truth in steps])


def pictures(frames):
    """The images as a run gets them."""
    return [TimedImage(str(i), i * DT, np.asarray(f.scans[0].image)) for i, f in enumerate(frames)]


@pytest.fixture(scope="module")
def started():
    """A camera that moves in its first image already."""
    return film("sideways", 45, start=30)


def test_two_views_find_the_depths_up_to_one_scale(started):
    rig, frames, truth = started
    sensor = rig.sensors[0]
    target = two_view_target(iter(pictures(frames)), sensor.calibration, compose(truth[0], sensor.extrinsics))
    camera = compose(truth[0], sensor.extrinsics)
    # The room's wall with its posters is the plane x = 3; what is seen of it lies there at one scale.
    rays = target.points - camera[:3]
    on_wall = (3.0 - camera[0]) / rays[:, 0]  # the scale that would put each point on the wall
    scale = np.median(on_wall)
    assert len(target.points) >= 10
    assert np.mean(np.abs(on_wall / scale - 1) < 0.02) >= 0.5  # the others are behind the window
    assert (target.std > 0).all()
    assert np.median((rays @ rotation(camera[3:]))[:, 2]) == pytest.approx(1, abs=0.3)  # in units of the median depth


def as_omni(calibration):
    """Nearly the same lens as an omniCam, whose intrinsics hold no focal length."""
    u, v, focal, _ = calibration.given["intrinsics"]
    angle = np.linspace(0, 0.8, 200)
    radius = focal * distort_radius(np.tan(angle), calibration.given["distortion"])
    lens = np.linalg.lstsq(angle[:, None] ** powers(8), radius, rcond=None)[0]
    return Calibration(OMNI, calibration.noise, image=calibration.image, intrinsics=[u, v, 1, 0, 0], lens=lens)


def test_a_focal_length_is_one_of_the_lens_not_of_its_third_number(started):
    calibration = started[0].sensors[0].calibration
    assert focal_length(calibration) == pytest.approx(calibration.given["intrinsics"][2], rel=1e-6)
    assert focal_length(as_omni(calibration)) == pytest.approx(calibration.given["intrinsics"][2], rel=1e-3)


def test_an_omnidirectional_camera_finds_the_same_two_views(started):
    rig, frames, truth = started
    camera = compose(truth[0], rig.sensors[0].extrinsics)
    both = [rig.sensors[0].calibration, as_omni(rig.sensors[0].calibration)]
    one, other = (two_view_target(iter(pictures(frames)), calibration, camera) for calibration in both)
    np.testing.assert_array_equal(one.pixels, other.pixels)
    np.testing.assert_allclose(one.points, other.points, rtol=0.1, atol=0.02)


def test_without_parallax_there_are_no_two_views(started):
    rig, frames, truth = started
    still = [pictures(frames)[0]] * 5
    assert two_view_target(iter(still), rig.sensors[0].calibration, truth[0]) is None
    blank = [TimedImage("blank", 0.0, np.zeros_like(still[0].image))] * 3
    assert two_view_target(iter(blank), rig.sensors[0].calibration, truth[0]) is None


def test_two_views_take_the_unit_of_a_target(started):
    rig, frames, truth = started
    sensor = rig.sensors[0]
    camera = compose(truth[0], sensor.extrinsics)
    on_wall = np.array([[3.0, y, z] for y in (1.1, 1.5, 1.9) for z in (1.0, 1.6)])
    pixels = sensor.calibration.project(np.column_stack([to_frame(camera, on_wall), np.ones(6)]))
    known = Target(on_wall, pixels, 0.001)
    both = two_view_target(iter(pictures(frames)), sensor.calibration, camera, known)
    assert (both.points[:6] == on_wall).all()
    assert (both.pixels[:6] == pixels).all()
    assert (both.std[:6] == 0.001).all()
    assert len(both.points) >= 16
    assert np.mean(np.abs(both.points[6:, 0] - 3.0) < 0.1) >= 0.5  # metres; the others are behind the window


def test_two_views_speak_against_a_reversed_path_alone(started):
    rig, frames, truth = started
    sensor, source = rig.sensors[0], of_pictures(pictures(frames), DT)
    path = np.array([compose(pose, sensor.extrinsics) for pose in truth])
    angle, first, second = direction_error(source, sensor.calibration, path)
    assert angle < 10
    assert first == 0 < second < len(path)
    mirrored = np.column_stack([2 * path[0, :3] - path[:, :3], path[:, 3:]])
    assert direction_error(source, sensor.calibration, mirrored)[0] == pytest.approx(180 - angle, abs=1)
    still = of_pictures([pictures(frames)[0]] * 5, DT)
    assert direction_error(still, sensor.calibration, path[:5]) is None
    assert direction_error(source, sensor.calibration, path[:1]) is None


def test_without_points_no_turn_is_measured(started):
    rig, frames, _ = started
    first, second, *_ = pictures(frames)
    blank = TimedImage("blank", second.time, np.zeros_like(first.image))
    assert turning_rate([first, second], rig.sensors[0].calibration) > 1
    for pair in ([first], [first, blank], [blank, first]):
        assert turning_rate(pair, rig.sensors[0].calibration) == 0


def filter_with_a_map(rig, frames):
    options = options_for(1.0, inverse_distance=(0.4, 0.4))
    slam = Slam(rig, options=options, front_ends=[ActiveSearch(rig.sensors[0].calibration, np.random.default_rng(1))])
    for frame in frames:
        slam.step(frame)
    return slam


def test_a_kidnapped_camera_is_found_by_its_map_and_the_map_is_not_changed(started):
    rig, frames, _ = started
    slam = filter_with_a_map(rig, frames[:30])
    robot = slam.robots[0]
    expected, means = robot.pose.copy(), [landmark.block.mean.copy() for landmark in slam.landmarks]
    lost = robot.block.mean.copy()
    lost[:7] = compose(expected, np.array([0.5, 0.4, 0, np.cos(0.4), 0, 0, np.sin(0.4)]))
    slam.belief.predict(robot.block, lost, np.eye(12), np.zeros((12, 12)))
    image = np.asarray(frames[29].scans[0].image)
    assert relocalize(slam, image)
    off = relative(expected, robot.pose)
    assert np.linalg.norm(off[:3]) < 0.05
    assert 2 * np.linalg.norm(off[4:]) < np.radians(1)
    P = slam.belief.covariance(robot.block)
    assert np.sqrt(P[3, 3]) == pytest.approx(np.radians(1))
    assert all((a == landmark.block.mean).all() for a, landmark in zip(means, slam.landmarks, strict=True))
    assert not slam.belief.covariance(robot.block, slam.landmarks[0].block).any()
    blank = robot.block.mean.copy()
    assert not relocalize(slam, np.zeros_like(image))
    assert (robot.block.mean == blank).all()


@pytest.mark.parametrize(("motion", "is_found"), [("odometry", True), ("constVel", True), ("unicycle", False)])
def test_a_robot_in_the_plane_is_not_put_at_any_pose(motion, is_found, monkeypatch):
    """The same points in the same pixels: a robot in space is found by them, with the velocities of its start."""
    wall = np.column_stack([np.full((40, 1), 3.0), np.random.default_rng(1).uniform(-1, 1, (40, 2))])
    true = np.array([0.2, 0.3, 0.1, 1, 0, 0, 0])
    setup = RobotSetup(motion=motion, position=(1, 0, 0), velocity=(0.1, 0.2, 0.3, 0, 0, 9), velocity_std=(0.5,) * 6)
    slam = Slam(Rig((setup,), (SensorSetup(),)))
    (robot,), before = slam.robots, slam.belief.matrix.copy()
    pixels = slam.sensors[0].calibration.project(
        np.column_stack([to_frame(compose(true, slam.sensors[0].extrinsics), wall), np.ones(40)])
    )
    monkeypatch.setattr("slamlib.vision.relocalization._matches", lambda *_: zip(wall, pixels, strict=True))
    assert relocalize(slam, np.zeros((480, 640))) == is_found
    if is_found:
        assert np.abs(Pose.minus(robot.pose, true)).max() < 1e-3
        assert np.array_equal(robot.block.mean[7:], setup.state[7:])
        P, Q = slam.belief.covariance(robot.block), setup.covariance
        assert np.sqrt(np.diag(P)[3:6]) == pytest.approx(np.radians([1, 1, 1]))
        assert np.array_equal(P[6:, 6:], Q[6:, 6:])
    else:
        assert np.array_equal(robot.block.mean, setup.state)
        assert np.array_equal(slam.belief.matrix, before)


def test_a_map_whose_patches_are_all_found_in_one_spot_is_not_recognized(started, monkeypatch):
    rig, frames, _ = started
    slam = filter_with_a_map(rig, frames[:1])
    rng = np.random.default_rng(1)
    spots = 90 + 1.5 * rng.standard_normal((40, 2))
    wall = np.column_stack([np.full(40, 3.0), rng.uniform(-1, 1, (40, 2))])
    monkeypatch.setattr("slamlib.vision.relocalization._matches", lambda *_: zip(wall, spots, strict=True))
    assert not relocalize(slam, np.asarray(frames[0].scans[0].image))  # seen from afar, they would be


def test_landmarks_long_unseen_close_a_loop_where_appearance_finds_them(started):
    rig, frames, _ = started
    slam = filter_with_a_map(rig, frames[:29])
    robot, (recent, *old) = slam.robots[0], slam.landmarks
    drifted = robot.block.mean.copy()
    drifted[:7] = compose(robot.pose, np.array([0.05, 0.12, 0, np.cos(0.02), 0, 0, np.sin(0.02)]))
    slam.belief.predict(robot.block, drifted, np.eye(12), np.zeros((12, 12)))
    slam.step(frames[29])
    assert not close_loop(slam, frames[29].scans[0].image)  # they have been seen of late
    for landmark in old:
        landmark.last_seen -= 200
    assert sum(p.inlier and p.landmark in old for p in slam.predictions[0]) < 3  # searched for where they are not

    def spread():
        """Determinants of the innovations' covariances [px^4], by landmark."""
        shown = slam.project()
        return {p.landmark: np.linalg.det(p.S) for p in shown}

    recent.last_seen = slam.number
    before = spread()
    assert close_loop(slam, frames[29].scans[0].image)
    after = spread()
    assert after[recent] == pytest.approx(before[recent], rel=0.2)  # it drifted with the robot, to first order
    assert np.median([after[lm] / before[lm] for lm in after if lm in old]) > 10
    for frame in frames[30:33]:  # the first of them is still their search backoff
        slam.step(frame)
    assert sum(p.inlier and p.landmark in old for p in slam.predictions[0]) >= 5
    assert np.linalg.norm(robot.pose[:3] - drifted[:3]) > 0.1
