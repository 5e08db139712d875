"""Detection, matching and refinement of rectified pairs; cases with known answers."""

import sys

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering import stereo_rig
from slambook.stereo_films import Tracks, pixel_noise, stereo_film

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import compose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.rigs.setup import Rig
from slamlib.tests.stereo import LENS, calibration, points_seen, seen_from
from slamlib.vision.stereo import (
    StereoFeatureExtractor,
    StereoSettings,
    circular_matches,
    mutual_nearest,
    pair,
    triangulate,
)
from slamlib.vision.stereo.detect import detect, spread
from slamlib.vision.stereo.features import hamming_distances, row_mask, track_features
from slamlib.vision.stereo.refine import ALONG_ROW, align, cut


@pytest.fixture(scope="module")
def film():
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    return stereo_film(2)


def smooth(u, v):
    """A picture whose values are known between the pixels."""
    return 120 + 40 * np.sin(0.31 * u + 0.2 * v) + 30 * np.cos(0.23 * v - 0.11 * u) + 20 * np.sin(0.5 * v)


def test_pairs_that_do_not_fit_are_refused():
    grey = np.zeros((240, 320), np.uint8)
    with pytest.raises(SlamlibError, match=r"\(240, 320\) on the left and \(240, 319\) on the right"):
        pair(grey, grey[:, 1:])
    with pytest.raises(SlamlibError, match="float64"):
        pair(grey.astype(float), grey.astype(float))
    with pytest.raises(SlamlibError, match="calibration of 320x240"):
        StereoFeatureExtractor(calibration()).extract(np.zeros((2, 100, 320), np.uint8))


def test_cameras_that_are_no_rectified_pair_are_refused():
    way = rendering.path("sideways")
    with pytest.raises(SlamlibError, match="distort"):
        stereo_rig(rendering.rig_along_path(way, baseline=0.12))
    with pytest.raises(SlamlibError, match="left and a right"):
        stereo_rig(rendering.rig_along_path(way))
    left, right = rendering.rig_along_path(way, baseline=0.12, parameters=LENS).sensors
    with pytest.raises(SlamlibError, match="should be to the right alone: rectify them, or exchange them"):
        stereo_rig(Rig(rendering.rig_along_path(way).robots, (right, left)))


def test_without_opencv_the_error_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "cv2", None)
    with pytest.raises(SlamlibError, match=r"pip install 'slamlib\[images\]'"):
        detect(np.zeros((240, 320), np.uint8))


def test_each_cell_keeps_its_strongest():
    pixels = np.array([[5.0, 5], [6, 6], [7, 7], [95, 5], [96, 95]])
    rows = spread(pixels, np.array([1.0, 3, 2, 9, 4]), (100, 100), (2, 2), 2)
    assert rows.tolist() == [3, 4, 1, 2]


def test_features_spread_over_the_picture(film):
    _, frames, _ = film
    image = frames[0][0].scans[0].image[0]
    s = StereoSettings(cells=(8, 6), per_cell=3)
    found = detect(image, s)
    counts = np.zeros((6, 8), int)
    place = (found.pixels / [40, 40]).astype(int)
    np.add.at(counts, (place[:, 1], place[:, 0]), 1)
    assert counts.max() <= 3 + 1  # a sub-pixel step may cross a cell's border
    assert (counts > 0).mean() > 0.6
    assert found.descriptors.shape == (len(found), 32)
    assert (found.pixels >= s.border - 0.5).all()


def test_an_unknown_detector_is_named():
    with pytest.raises(SlamlibError, match="did you mean 'corners'"):
        detect(np.zeros((240, 320), np.uint8), StereoSettings(detector="corner"))


@pytest.mark.parametrize(("name", "value"), [("border", 10**20), ("cells", (12, 10**20)), ("zoom", 10**20)])
def test_settings_that_no_library_s_integers_hold_are_refused(name, value):
    with pytest.raises(SlamlibError, match=rf"StereoSettings\.{name}.* and up to \d+.*, got 100000000000000000000"):
        StereoSettings(**{name: value})


def test_distances_count_bits():
    rng = np.random.default_rng(1)
    one, other = rng.integers(0, 256, (2, 7, 32)).astype(np.uint8)
    counted = [[bin(int.from_bytes((a ^ b).tobytes(), "big")).count("1") for b in other] for a in one]
    np.testing.assert_array_equal(hamming_distances(one, other), counted)
    assert hamming_distances(one[:0], other).shape == (0, 7)


def test_mutual_matches_are_best_both_ways():
    cost = np.array([[1.0, 5, 9], [2, 8, 9], [9, 9, 3]])
    # Row 1 prefers column 0, which prefers row 0.
    assert mutual_nearest(cost, largest=100).tolist() == [[0, 0], [2, 2]]
    assert mutual_nearest(cost, largest=2).tolist() == [[0, 0]]
    # The second best of column 0 is 2: a ratio of 0.5 is not below 0.5.
    assert mutual_nearest(cost, largest=100, ratio=0.5).tolist() == [[2, 2]]
    assert mutual_nearest(np.full((2, 2), np.inf), largest=100).tolist() == []
    assert mutual_nearest(np.zeros((0, 3)), largest=1).shape == (0, 2)


def test_rows_and_disparities_bound_the_matches():
    left, right = np.array([[50.0, 10]]), np.array([[40.0, 11], [40, 12], [51, 10], [5, 10]])
    assert row_mask(left, right, 1.5, (1, 30)).tolist() == [[True, False, False, False]]


def test_the_cycle_is_closed_only_where_both_pictures_agree():
    lefts, rights = np.array([[0, 0], [1, 2], [3, 1]]), np.array([[0, 0], [1, 1], [3, 1]])
    assert circular_matches(lefts, rights).tolist() == [[0, 0], [3, 1]]
    assert circular_matches(lefts, rights[:0]).shape == (0, 2)


def test_alignment_finds_fractions_of_pixels_whatever_the_light():
    v, u = np.mgrid[:60, :80].astype(float)
    template, shift = smooth(u, v), np.array([0.37, -0.62])
    image = 0.7 * smooth(u - shift[0], v - shift[1]) + 25
    at = np.array([[30.0, 25], [44.25, 31.5]])
    place, score = align(image, cut(template, at, 13), at)
    np.testing.assert_allclose(place, at + shift, atol=0.03)  # bilinear
    assert (score > 0.999).all()
    along = smooth(u - shift[0], v)
    place, _ = align(along, cut(template, at, 13), at, ALONG_ROW)
    np.testing.assert_allclose(place, at + np.array([shift[0], 0]), atol=0.03)


def test_a_patch_of_another_shape_is_found_where_it_is():
    """Turned by 10 degrees, stretched by 10 %: the position is right with a free shape, and wrong with a fixed one."""
    v, u = np.mgrid[:60, :80].astype(float)
    template, at, shift = smooth(u, v), np.array([[34.0, 27.0], [45, 30]]), np.array([0.4, -0.3])
    a = np.radians(10)
    back = np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]]) / [[1.1], [1.0]]
    for (x, y), place in zip(at, at + shift, strict=True):
        du, dv = u - place[0], v - place[1]
        image = smooth(x + back[0, 0] * du + back[0, 1] * dv, y + back[1, 0] * du + back[1, 1] * dv)
        patch, start = cut(template, np.array([[x, y]]), 13), place[None] + 0.3
        rigid, low = align(image, patch, start)
        free, high = align(image, patch, start, free=True)
        assert np.abs(free - place).max() < 0.02
        assert np.abs(rigid - place).max() > 0.05
        assert high[0] > max(0.999, low[0])


def test_flat_patches_stay_where_they_were():
    place, score = align(np.full((40, 40), 7.0), np.full((1, 13, 13), 3.0), np.array([[20.0, 20]]))
    assert place.tolist() == [[20.0, 20.0]]
    assert score.tolist() == [0.0]


def test_disparities_in_the_room_are_right(film):
    rig, frames, made = film
    frame, truth = frames[0]
    rig_sensor = rig.sensors[0]
    seen = StereoFeatureExtractor(rig_sensor.calibration).extract(frame.scans[0].image)
    camera = compose(truth.poses[0], rig_sensor.extrinsics)
    points = made.truth_of(truth, seen.values[:, :2])
    expected = rig_sensor.calibration.project(EUC_POINT.to_frame(camera, points))
    error = seen.values[:, 2] - expected[:, 2]
    assert len(seen) > 80
    assert np.median(np.abs(error)) < 0.1  # px
    assert (np.abs(error) < 1).mean() > 0.95


def test_followed_features_are_the_same_points(film):
    rig, frames, made = film
    extrinsics, extractor = rig.sensors[0].extrinsics, StereoFeatureExtractor(rig.sensors[0].calibration)
    old, new = (extractor.extract(frame.scans[0].image) for frame, _ in frames)
    pairs, values = track_features(old, new, extractor.settings)
    before = made.truth_of(frames[0][1], old.values[pairs[:, 0], :2])
    camera = compose(frames[1][1].poses[0], extrinsics)
    expected = rig.sensors[0].calibration.project(EUC_POINT.to_frame(camera, before))
    error = np.linalg.norm(values[:, :2] - expected[:, :2], axis=1)
    assert len(pairs) > 60
    assert np.median(error) < 0.1
    assert (error < 1).mean() > 0.9


def test_a_pair_is_looked_at_once(film):
    rig, frames, _ = film
    extractor = StereoFeatureExtractor(rig.sensors[0].calibration)
    image = frames[0][0].scans[0].image
    assert extractor.extract(image) is extractor.extract(image)


def test_triangulation_inverts_the_projection():
    rng = np.random.default_rng(2)
    points = points_seen(rng, 20)
    found, covariances = triangulate(calibration(), seen_from(points, np.array([0, 0, 0, 1.0, 0, 0, 0])))
    np.testing.assert_allclose(found, points, atol=1e-12)
    assert (np.linalg.eigvalsh(covariances) > 0).all()
    with pytest.raises(SlamlibError, match="no finite point"):
        triangulate(calibration(), np.array([[10.0, 10, 0]]))


def test_the_depth_s_deviation_grows_with_its_square():
    """E12: sigma_z is about sqrt(2) sigma z^2 / (f b), and the error lies along the ray: R is no diagonal matrix."""
    made = calibration(pixel_noise(0.5, 0.5))
    value = made.project(np.array([0.3 * 10, 0, 10, 1.0]))
    _, (P,) = triangulate(made, value[None])
    assert np.sqrt(P[2, 2]) == pytest.approx(np.sqrt(2) * 0.5 * 100 / (260 * 0.12), rel=1e-9)
    assert P[0, 2] / np.sqrt(P[0, 0] * P[2, 2]) > 0.99


def test_covariance_of_triangulated_points_by_monte_carlo():
    rng, noise = np.random.default_rng(3), pixel_noise(0.2, 0.3)
    made, value = calibration(noise), np.array([200.0, 90, 20])
    (point,), (P,) = triangulate(made, value[None])
    drawn = rng.multivariate_normal(value, noise, 4000)
    points, _ = triangulate(made, drawn)
    e = points - point
    mean = (e * np.linalg.solve(P, e.T).T).sum(1).mean()
    assert 3 * 0.93 < mean < 3 * 1.07  # 4000 draws of three: +- 2 % at one sigma, and a little of second order


def test_tracks_keep_one_number_for_each_feature():
    tracks = Tracks()
    tracks.step(3, np.zeros((0, 2), int))
    assert tracks.ids.tolist() == [1, 2, 3]
    mask = tracks.step(4, np.array([[2, 0], [0, 3]]))
    assert mask.tolist() == [True, False, True]
    assert tracks.ids.tolist() == [3, 4, 5, 1]
    assert tracks.ages.tolist() == [2, 1, 1, 2]
    tracks.step(1, np.array([[3, 0]]))
    assert (tracks.ids.tolist(), tracks.ages.tolist()) == ([1], [3])
