"""Active search in the rendered room: it finds its own landmarks, and finds them again."""

import json
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from slambook import rendering

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry.pose import compose
from slamlib.records.inputs import Frame, Scan
from slamlib.rigs.setup import SensorSetup
from slamlib.slam import Options, Slam
from slamlib.slam.data_association.front_end import FrontEndInput
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.image_front_end import Backoff

FRAMES, DT = 45, 1 / 30
OPTIONS = Options(updates=12, max_new_first=12, max_new=3, min_matched_ratio=0.5, inverse_distance=(0.4, 0.4))


@pytest.fixture(scope="module")
def film():
    path = rendering.path("sideways")
    rig = rendering.rig_along_path(path, std=(0.1,))
    made = rendering.film(
        rendering.default_room("drawn"), rig, path, frames=FRAMES, dt=DT, rng=np.random.default_rng(5)
    )
    return SimpleNamespace(rig=rig, steps=list(made), truth_of=made.truth_of, renderer=made.renderers[0])


def filter_of(film, **settings):
    calibration = film.rig.sensors[0].calibration
    front_end = ActiveSearch(calibration, np.random.default_rng(3), ActiveSearchSettings(**settings))
    return Slam(film.rig, options=OPTIONS, front_ends=[front_end])


@pytest.fixture(scope="module")
def done(film):
    slam, rows = filter_of(film), []
    for frame, truth in film.steps:
        slam.step(frame)
        chosen = [prediction for prediction in slam.predictions[0] if prediction.chosen]
        rows.append([slam.robots[0].pose.copy(), truth.poses[0], chosen])
    return SimpleNamespace(slam=slam, poses=np.array([r[0] for r in rows]), truth=np.array([r[1] for r in rows]),
                           chosen=[prediction for r in rows for prediction in r[2]])  # fmt: skip


def test_the_room_is_tracked_and_the_path_recovered_up_to_scale(done):
    times = DT * np.arange(FRAMES)
    found = align_trajectory(Trajectory(times, done.poses), Trajectory(times, done.truth))
    assert found.relative_ate < 0.02
    assert np.mean([prediction.matched for prediction in done.chosen]) > 0.85
    inliers = [prediction for prediction in done.chosen if prediction.inlier]
    assert len(inliers) > 0.95 * sum(prediction.matched for prediction in done.chosen)
    assert (
        np.mean([prediction.nis for prediction in inliers]) < 2
    )  # two degrees of freedom: not too sure of the measurements


def on_one_surface(film, truth, pixel, half=6):
    """Whether the patch around a pixel shows one rectangle of the room only."""
    around = pixel + half * np.stack(np.meshgrid([-1, 0, 1], [-1, 0, 1]), -1).reshape(-1, 2)
    _, surface = film.renderer.cast(compose(truth.poses[0], truth.extrinsics[0]), around)
    return len(set(np.asarray(surface).tolist())) == 1


def test_what_is_matched_is_what_was_seen_before(film):
    """Matches show the same points of the room as the pixels where the landmarks were initialized.

    A patch with an edge before something far away shows no one point of the room: those are left out.
    """
    slam, begun, away = filter_of(film), {}, []
    for frame, truth in film.steps[:20]:
        report = slam.step(frame)
        predictions = [
            prediction for prediction in slam.predictions[0] if prediction.inlier and prediction.landmark.id in begun
        ]
        now = film.truth_of(truth, np.array([prediction.measured for prediction in predictions]).reshape(-1, 2))
        away += [
            np.linalg.norm(p - begun[prediction.landmark.id]) for prediction, p in zip(predictions, now, strict=True)
        ]
        for landmark in slam.landmarks:
            if landmark.id in report.initialized and on_one_surface(film, truth, landmark.signature.pixel):
                begun[landmark.id] = film.truth_of(truth, landmark.signature.pixel[None])[0]
    assert len(away) > 100
    assert np.median(away) < 0.002  # [m]; a pixel is about 1 cm of the wall
    assert np.mean(np.array(away) < 0.01) > 0.98


def test_a_saved_run_goes_on_exactly(film, tmp_path):
    whole, half = filter_of(film), filter_of(film)
    for frame, _ in film.steps[:20]:
        whole.step(frame)
    for frame, _ in film.steps[:9]:
        half.step(frame)
    half.save(tmp_path / "half.npz")
    fresh = ActiveSearch(film.rig.sensors[0].calibration, np.random.default_rng(99))
    resumed = Slam.load(tmp_path / "half.npz", front_ends=[fresh])
    for frame, _ in film.steps[9:20]:
        resumed.step(frame)
    assert [lm.id for lm in resumed.landmarks] == [lm.id for lm in whole.landmarks]
    np.testing.assert_array_equal(resumed.belief.matrix, whole.belief.matrix)
    np.testing.assert_array_equal(resumed.robots[0].pose, whole.robots[0].pose)
    json.dumps(fresh.dump())  # plain data


def test_dark_frames_are_predictions(film):
    slam = filter_of(film)
    for frame, _ in film.steps[:8]:
        slam.step(frame)
    known, spread = len(slam.landmarks), np.trace(slam.belief.covariance(slam.robots[0].block)[:3, :3])
    dark = Scan(image=np.zeros((240, 320), np.uint8))
    for number in range(9, 12):
        report = slam.step(Frame(number, DT, (None,), (dark,)))
        assert not report.initialized
        assert not any(prediction.matched for prediction in slam.predictions[0])
    assert np.trace(slam.belief.covariance(slam.robots[0].block)[:3, :3]) > spread
    slam.step(film.steps[11][0])  # the light is on again
    assert sum(prediction.matched for prediction in slam.predictions[0]) > known / 4


def test_landmarks_that_are_hidden_back_off_longer_and_longer():
    rest, waits = Backoff(), []
    for _ in range(7):
        rest = rest.increased(16)
        waits.append(0)
        while not rest.is_over():
            waits[-1] += 1
    assert waits == [1, 2, 4, 8, 16, 16, 16]


def test_new_landmarks_are_initialized_in_cells_of_their_own_with_texture(film):
    frame, _ = film.steps[0]
    slam = filter_of(film)
    slam.step(frame)
    front_end, pixels = slam.front_ends[0], np.array([lm.signature.pixel for lm in slam.landmarks])
    assert len(pixels) == OPTIONS.max_new_first
    assert front_end.grid.occupied(pixels).sum() == len(pixels)
    assert len({lm.id for lm in slam.landmarks}) == len(pixels)
    assert min(lm.signature.quality for lm in slam.landmarks) >= front_end.settings.quality


def test_nothing_is_initialized_when_enough_is_in_view_or_nothing_is_good_enough(film):
    frames = [frame for frame, _ in film.steps[:3]]
    few, picky = filter_of(film, max_in_view=5), filter_of(film, quality=1e9)
    for frame in frames:
        few.step(frame)
        picky.step(frame)
    assert len(few.landmarks) == 5
    assert not picky.landmarks


def test_adopted_places_need_not_be_corners(film):
    slam = filter_of(film)
    frame, _ = film.steps[0]
    inputs = FrontEndInput(frame.scans[0], slam.sensors[0], [])
    inside, outside = slam.front_ends[0].initialize_at(inputs, "points", np.array([[100.0, 80.0], [2.0, 2.0]]))
    assert inside[1].tolist() == [100, 80]
    assert outside is None


def test_a_prediction_keeps_what_was_searched_and_found(done):
    matched = [prediction for prediction in done.chosen if prediction.matched]
    assert {prediction.predicted_patch.shape for prediction in matched} == {(11, 11)}
    assert {prediction.found_patch.shape for prediction in matched} == {(11, 11)}
    assert all(prediction.score >= ActiveSearchSettings().threshold for prediction in matched)


def test_the_image_must_be_the_calibrated_one(film):
    slam = filter_of(film)
    for image, said in ((None, "no image"), (np.zeros((100, 100), np.uint8), r"shape \(100, 100\)")):
        with pytest.raises(SlamlibError, match=said):
            slam.step(Frame(1, DT, (None,), (Scan(image=image),)))
        assert slam.number == 0  # nothing has been changed
    blind = replace(SensorSetup(), image=None).calibration
    with pytest.raises(SlamlibError, match="has no image"):
        ActiveSearch(blind, np.random.default_rng(0))


def test_the_camera_pose_is_that_of_robot_and_extrinsics(film):
    slam = filter_of(film)
    sensor = slam.sensors[0]
    np.testing.assert_array_equal(sensor.camera, compose(sensor.robot.pose, sensor.extrinsics))


def test_no_corner_is_initialized_twice(film, done):
    """Also not from the other side of a cell's border: new landmarks are a patch apart."""
    slam, size = filter_of(film), ActiveSearchSettings().patch
    for frame, _ in film.steps[:15]:
        report = slam.step(frame)
        begun = [lm.signature.pixel for lm in slam.landmarks if lm.id in report.initialized]
        expected = [prediction.value for prediction in slam.predictions[0]]
        for i, pixel in enumerate(begun):
            others = np.array(begun[:i] + expected).reshape(-1, 2)
            assert (np.abs(others - pixel).max(-1) >= size).all()
