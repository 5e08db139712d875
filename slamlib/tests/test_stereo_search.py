"""The stereo front end in the filter, on rendered pictures."""

import json

import numpy as np
import pytest
from slambook.stereo_films import stereo_film

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.plain_data.fields import read, written
from slamlib.records.inputs import Frame, Scan
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam
from slamlib.tests.stereo import calibration
from slamlib.vision.stereo import StereoSearch, StereoSettings
from slamlib.vision.stereo.odometry import checkerboard_half
from slamlib.vision.stereo.stereo_search import LandmarkView, LandmarkViews

pytest.importorskip("cv2", reason="OpenCV is not installed")
OPTIONS = Options(points="eucPnt", updates=40, max_new_first=40, max_new=5)


@pytest.fixture(scope="module")
def film():
    return stereo_film(18)


def filter_of(rig, **more):
    """A filter with the stereo front end."""
    return Slam(rig, options=OPTIONS, front_ends=[StereoSearch(rig.sensors[0].calibration, **more)])


def run(slam, frames):
    """The filter after the frames."""
    for frame, _ in frames:
        slam.step(frame)
    return slam


def dark(frame):
    """The same frame with nothing to see in it."""
    image = np.zeros_like(frame.scans[0].image)
    return Frame(frame.number, frame.dt, frame.controls, (Scan(image=image),))


def test_the_camera_is_where_the_filter_says(film):
    rig, frames, _ = film
    slam = run(filter_of(rig), frames)
    error = Pose.minus(frames[-1][1].poses[0], slam.robots[0].pose)
    predictions = slam.predictions[0]
    assert np.linalg.norm(error[:3]) < 0.005  # [m], after 0.25 m
    assert np.degrees(np.linalg.norm(error[3:])) < 0.1
    assert sum(prediction.inlier for prediction in predictions) > 20


def test_landmarks_are_where_the_room_is(film):
    rig, frames, made = film
    slam, begun, first = filter_of(rig), {}, {}
    for frame, truth in frames[:12]:
        report = slam.step(frame)
        for landmark in slam.landmarks:
            if landmark.id in report.initialized:
                camera = compose(truth.poses[0], rig.sensors[0].extrinsics)
                pixel = slam.front_ends[0].calibration.project(EUC_POINT.to_frame(camera, landmark.block.mean))
                begun[landmark.id] = made.truth_of(truth, pixel[None, :2])[0]
                first[landmark.id] = np.linalg.norm(landmark.block.mean - begun[landmark.id])
    seen = [lm for lm in slam.landmarks if lm.inliers > 4]
    away = [np.linalg.norm(lm.block.mean - begun[lm.id]) for lm in seen]
    assert len(away) > 30
    assert np.median(away) < 0.02  # [m] at two to four metres
    assert np.median(away) < 0.6 * np.median([first[lm.id] for lm in seen])  # when they were seen once


def test_a_landmark_keeps_its_number_while_it_is_out_of_sight(film):
    rig, frames, _ = film
    slam = run(filter_of(rig), frames[:6])
    before = {landmark.id for landmark in slam.landmarks}
    for frame, _ in frames[6:9]:
        slam.step(dark(frame))
    assert not any(prediction.matched for prediction in slam.predictions[0])
    again = set()
    for frame, _ in frames[9:14]:
        slam.step(frame)
        again |= {prediction.landmark.id for prediction in slam.predictions[0] if prediction.inlier}
    assert len(again & before) > 10


def test_no_landmark_is_initialized_upon_another(film):
    rig, frames, _ = film
    slam = run(filter_of(rig), frames[:8])
    values = np.array([prediction.value for prediction in slam.predictions[0]])
    apart = np.abs(values[:, None, :2] - values[None, :, :2]).max(-1) + 1e3 * np.eye(len(values))
    assert np.mean(apart.min(1) > 4) > 0.97


def test_a_saved_run_goes_on_exactly(film, tmp_path):
    rig, frames, _ = film
    whole = run(filter_of(rig), frames[:12])
    run(filter_of(rig), frames[:7]).save(tmp_path / "half.npz")
    fresh = StereoSearch(rig.sensors[0].calibration)
    resumed = run(Slam.load(tmp_path / "half.npz", front_ends=[fresh]), frames[7:12])
    assert [lm.id for lm in resumed.landmarks] == [lm.id for lm in whole.landmarks]
    np.testing.assert_array_equal(resumed.belief.matrix, whole.belief.matrix)
    np.testing.assert_array_equal(resumed.robots[0].pose, whole.robots[0].pose)
    json.dumps(fresh.dump())  # plain data


def test_a_half_measures_in_its_squares_only(film):
    rig, frames, _ = film
    slam = filter_of(rig, half=1)
    for frame, _ in frames[:5]:
        slam.step(frame)
        measured = np.array([prediction.measured for prediction in slam.predictions[0] if prediction.matched]).reshape(
            -1, 3
        )
        assert (checkerboard_half(measured) == 1).all()
    assert len(slam.landmarks) > 15


def test_landmarks_take_turns(film):
    rig, frames, _ = film
    slam = filter_of(rig, settings=StereoSettings(update_interval=3))
    looked = dict[int, list[int]]()
    for frame, _ in frames[:10]:
        slam.step(frame)
        for prediction in slam.predictions[0]:
            if prediction.chosen:
                looked.setdefault(prediction.landmark.id, []).append(frame.number)
    assert len(looked) > 20
    assert all(set(np.diff(numbers)) <= {3, 6, 9} for numbers in looked.values())
    assert {numbers[0] % 3 for numbers in looked.values()} == {0, 1, 2}  # in each frame some


def test_what_is_left_to_an_odometry_is_not_measured(film):
    rig, frames, _ = film
    slam = run(filter_of(rig), frames[:3])
    front_end = slam.front_ends[0]
    seen = front_end.extractor.extract(frames[3][0].scans[0].image)
    front_end.reserved = np.arange(0, len(seen), 2)
    slam.step(frames[3][0])
    assert len(front_end.found) > 10
    assert set(front_end.reserved.tolist()).isdisjoint([*front_end.found.values(), *front_end.initialized])


def test_a_shared_prediction_is_made_once(film):
    rig, frames, _ = film
    slam = filter_of(rig)
    extractor = slam.front_ends[0].extractor
    seen = extractor.extract(frames[0][0].scans[0].image)
    slam.step(frames[0][0])
    assert extractor.last is seen


def test_scans_without_a_pair_change_nothing(film):
    rig, frames, _ = film
    slam = run(filter_of(rig), frames[:2])
    before = slam.belief.matrix.copy()
    for image in (None, np.zeros((240, 320), np.uint8), np.zeros((2, 240, 300), np.uint8)):
        with pytest.raises(SlamlibError, match="pair"):
            slam.step(Frame(3, 0.03, (None,), (Scan(image=image),)))
    np.testing.assert_array_equal(slam.belief.matrix, before)


def test_other_sensors_are_refused():
    camera = Calibration(PINHOLE, np.eye(2), image=(320, 240), intrinsics=[159.5, 119.5, 260, 260], distortion=[0])
    with pytest.raises(SlamlibError, match="type='stereo'"):
        StereoSearch(camera)
    with pytest.raises(SlamlibError, match="image"):
        StereoSearch(calibration(image=None))


def test_settings_that_make_no_sense_are_refused():
    with pytest.raises(SlamlibError, match="disparity"):
        StereoSettings(disparity=(5, 2))
    with pytest.raises(SlamlibError, match="patch"):
        StereoSettings(patch=10)


def test_the_first_view_is_never_given_up():
    views = LandmarkViews((LandmarkView(np.zeros(32, np.uint8), np.zeros((13, 13)), 10.0),))
    for d in (12.0, 15.0, 19.0, 24.0, 30.0):
        views = views.with_view(LandmarkView(np.zeros(32, np.uint8), np.zeros((13, 13)), d), 4)
    assert [v.disparity for v in views.all] == [10.0, 19.0, 24.0, 30.0]
    assert views.nearest(11.0).disparity == 10.0
    assert views.nearest(26.0).disparity == 24.0
    assert views.all[0].zoom(-1.0) == np.inf
    packed = json.loads(json.dumps(written(views)))
    assert [v.disparity for v in read(LandmarkViews, packed).all] == [10.0, 19.0, 24.0, 30.0]
