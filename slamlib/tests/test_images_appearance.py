"""What a landmark's signature holds, what it predicts, when it is renewed, and that files lose nothing of it."""

import json

import numpy as np
import pytest

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.plain_data.fields import read, written
from slamlib.tests.pictures import grid, photograph
from slamlib.tests.test_images_warping import CAMERAS, FIRST, IDEAL, drawn, posed
from slamlib.vision.appearance import Appearance, predict, recognizable, view_change
from slamlib.vision.patches import cut, zncc
from slamlib.vision.search import Match, search
from slamlib.vision.warping import in_camera

PLANE, SURE = np.array([0, 0, 0.5]), Match(np.zeros(2), 0.95, 0.1)


def picture(camera: np.ndarray, name: str = "ideal", seed: int = 3) -> np.ndarray:
    """What a camera sees of a painted wall two metres before the first one, (240, 320)."""
    u, v = grid(240, 320)
    return drawn(CAMERAS[name], camera, PLANE, np.stack([u, v], axis=-1), seed)


def on_wall(pixels: np.ndarray, name: str = "ideal") -> np.ndarray:
    """The points of the wall (n, 4) that the first camera sees at pixels (n, 2)."""
    calibration = CAMERAS[name]
    rays = calibration.sensor.back_project(pixels, np.ones((len(pixels), 1)), **calibration.given)
    return np.concatenate([rays[:, :3], rays[:, :3] @ PLANE[:, None]], axis=1)


def predicted(own: Appearance, camera: np.ndarray, point: np.ndarray, size: int = 11) -> np.ndarray | None:
    return predict([own], camera, IDEAL, point[None], size)[0]


def true_pixel(camera: np.ndarray, point: np.ndarray, name: str = "ideal") -> np.ndarray:
    return CAMERAS[name].project(in_camera(camera, point))


def test_from_where_it_was_taken_it_is_the_template():
    image, pixel = photograph("camera"), np.array([100.0, 120])
    own = Appearance.taken(image, pixel, FIRST, 11, quality=900.5)
    assert own.pixels.shape == (33, 33)
    np.testing.assert_array_equal(own.template, image[115:126, 95:106])
    point = IDEAL.sensor.back_project(pixel, np.array([0.3]), **IDEAL.given)
    np.testing.assert_allclose(predicted(own, FIRST, point), own.template, atol=1e-6)
    assert predicted(own, FIRST, point, size=15).shape == (15, 15)
    assert own.angle_change(FIRST, point) < 1e-7
    assert view_change(own.camera, FIRST, point)[1] == 1


def test_between_pixels_the_template_is_cut_there():
    image = photograph("camera")
    own = Appearance.taken(image, (100.3, 119.6), FIRST)
    np.testing.assert_allclose(own.template, cut(image, (100.3, 119.6), 11))


@pytest.mark.parametrize("name", CAMERAS)
def test_landmarks_of_a_wall_are_found_from_elsewhere(name):
    # whose normal is not quite the one that is assumed: the wall is seen up to 15 degrees off its own
    calibration, camera = CAMERAS[name], posed([0.6, 0.2, 0.5], [0.05, -0.25, 0.4])
    pixels = np.stack(np.meshgrid(np.arange(100, 221, 15.0), np.arange(80, 161, 15.0)), axis=-1).reshape(-1, 2)
    first, now, points = picture(FIRST, name), picture(camera, name), on_wall(pixels, name)
    all_, shift, rows = [Appearance.taken(first, p, FIRST) for p in pixels], np.array([2, -1]), []
    for own, template, point in zip(all_, predict(all_, camera, calibration, points, 11), points, strict=True):
        place = true_pixel(camera, point, name)
        if template is not None and calibration.inside(place, 20):
            match, plain = (search(now, t, place + shift, 16 * np.eye(2)) for t in (template, own.template))
            rows.append([match.score, plain.score, np.linalg.norm(match.pixel - place), match.ratio])
    score, plain, away, ratio = np.array(rows).T
    sure = (score > 0.9) & (ratio < 0.9)
    assert len(rows) > 30
    assert sure.mean() > 0.5
    assert np.median(score) > 0.97
    assert np.median(plain) < np.median(score) - 0.04
    assert np.median(away[sure]) < 0.3
    assert (away[sure] < 1).mean() > 0.95


def test_all_at_once_is_one_by_one():
    camera = posed([0.5, 0, 0.3], [0, -0.2, 0.3])
    pixels = np.array([[100.0, 100], [200, 80.5], [16, 120], [150, 150]])
    image, points = picture(FIRST), on_wall(pixels)
    points[3] = [0, 0, -1, 0.5]  # behind
    all_ = [Appearance.taken(image, p, FIRST) for p in pixels]
    batch = predict(all_, camera, IDEAL, points, 11)
    for own, template, point in zip(all_, batch, points, strict=True):
        alone = predicted(own, camera, point)
        assert (template is None) == (alone is None)
        if template is not None:
            np.testing.assert_allclose(template, alone, atol=1e-9)
    assert batch[0] is not None
    assert batch[3] is None
    assert predict([], camera, IDEAL, np.zeros((0, 4)), 11) == []


@pytest.mark.parametrize(
    "camera",
    [
        posed([0, 0, 1.2], [0, 0, 0]),  # 2.5 times as large
        posed([0, 0, -3], [0, 0, 0]),  # 2.5 times as small
        posed([0, 0, 4], [0, np.pi, 0]),  # from the other side
        posed([0, 0, 0], [0, np.pi, 0]),  # looks away
    ],
)
def test_what_cannot_be_recognized_is_not_predicted(camera):
    own, point = Appearance.taken(picture(FIRST), (159.5, 119.5), FIRST), np.array([0, 0, 1, 0.5])
    assert predicted(own, camera, point) is None


@pytest.mark.parametrize("degrees", [0, 30, 59, 61, 80])
def test_what_is_too_oblique_is_not_predicted(degrees):
    own, point = Appearance.taken(picture(FIRST), (159.5, 119.5), FIRST), np.array([0, 0, 1, 0.5])
    a = np.radians(degrees)
    camera = posed([2 * np.sin(a), 0, 2 - 2 * np.cos(a)], [0, -a, 0])
    np.testing.assert_allclose(own.angle_change(camera, point), a, atol=1e-9)
    assert recognizable([own], camera, point[None])[0] == (degrees < 60)
    if degrees > 60:
        assert predicted(own, camera, point) is None
    if degrees < 50:
        assert predicted(own, camera, point) is not None


def test_what_is_predicted_was_recognizable():
    rng, image = np.random.default_rng(1), picture(FIRST)
    own, point = Appearance.taken(image, (159.5, 119.5), FIRST), np.array([0, 0, 1, 0.5])
    for _ in range(60):
        camera = posed(rng.uniform(-2, 1.5, 3), rng.uniform(-0.5, 0.5, 3))
        # the one goes by distances, the other by the map at its very pixel
        if predicted(own, camera, point) is not None and 0.6 < view_change(own.camera, camera, point)[1] < 1.7:
            assert recognizable([own], camera, point[None]).all()


def test_an_infinitely_far_point_turns_with_the_camera_alone():
    image, point = picture(FIRST), np.array([0.0, 0, 1, 0])
    own = Appearance.taken(image, (159.5, 119.5), FIRST)
    near, far = (predicted(own, posed(p, [0, 0, 0.4]), point) for p in ([0, 0, 0], [9, 9, 9]))
    np.testing.assert_allclose(near, far, atol=1e-9)
    assert own.angle_change(posed([9, 9, 9], [0, 0, 0.4]), point) == 0
    assert not own.needs_renewal(SURE, posed([9, 9, 9], [0, 0, 0.4]), point)


@pytest.mark.parametrize(
    ("camera", "due"),
    [
        (posed([0, 0, 0.1], [0, 0, 1]), False),
        (posed([0, 0, 0.7], [0, 0, 0]), True),  # 1.54 times nearer
        (posed([0, 0, -1.1], [0, 0, 0]), True),
        (posed([0.8, 0, 0.1], [0, 0, 0]), False),  # 23 degrees
        (posed([1.1, 0, 0.1], [0, 0, 0]), True),
    ],
)
def test_a_patch_is_renewed_when_the_view_has_changed_and_the_match_is_sure(camera, due):
    own, point = Appearance.taken(picture(FIRST), (159.5, 119.5), FIRST), np.array([0, 0, 1, 0.5])
    assert own.needs_renewal(SURE, camera, point) == due
    assert not own.needs_renewal(Match(np.zeros(2), 0.85, 0.1), camera, point)
    assert not own.needs_renewal(Match(np.zeros(2), 0.95, 0.85), camera, point)


def test_renewed_patches_stay_on_the_landmark():
    # before a wall from side to side, three times, with noise; what a patch is off must not grow from turn to turn
    rng, away = np.random.default_rng(2), []
    pixels = np.stack(np.meshgrid([110.0, 160, 210], [90.0, 120, 150]), axis=-1).reshape(-1, 2)
    image, points = picture(FIRST), on_wall(pixels)
    signatures = [Appearance.taken(image, p, FIRST) for p in pixels]
    for a in np.linspace(0, 6 * np.pi, 36):
        x, z = 1.3 * np.sin(a), 0.7 * np.sin(2 * a) - 0.3
        camera = posed([x, 0, z], [0, -np.arctan2(x, 2 - z), 0.2 * np.sin(a)])
        image = picture(camera) + 2 * rng.standard_normal((240, 320))
        for i, template in enumerate(predict(signatures, camera, IDEAL, points, 11)):
            place = true_pixel(camera, points[i])
            found = None if template is None else search(image, template, place, 4 * np.eye(2))
            if found is not None and found.score > 0.9:
                away.append([a, np.linalg.norm(found.pixel - place)])
                if signatures[i].needs_renewal(found, camera, points[i]):
                    signatures[i] = signatures[i].renewed(image, found, template, camera)
    assert 3 < np.mean([len(s.all) for s in signatures]) < 9
    a, away = np.array(away).T
    assert np.median(away) < 0.25
    assert np.median(away[a > 4 * np.pi]) < 1.5 * np.median(away[a < 2 * np.pi])


def test_the_patch_seen_most_as_now_is_used():
    point, cameras = (
        np.array([0, 0, 1, 0.5]),
        [FIRST, posed([1.2, 0, 0.2], [0, -0.6, 0]), posed([0, 0, 0.8], [0, 0, 0])],
    )
    own = Appearance.taken(picture(FIRST), (159.5, 119.5), FIRST)
    for camera in cameras[1:]:
        assert own.needs_renewal(SURE, camera, point)
        image, place = picture(camera), true_pixel(camera, point)
        own = own.renewed(image, Match(place, 0.95, 0.1), cut(image, place, 11), camera)
        np.testing.assert_allclose(own.pixel, place, atol=0.02)
    assert len(own.all) == 3
    for camera in cameras:
        np.testing.assert_array_equal(own.nearest(camera, point).camera, camera)
        np.testing.assert_allclose(
            predicted(own, camera, point), cut(picture(camera), true_pixel(camera, point), 11), atol=6
        )
        assert not own.needs_renewal(SURE, camera, point)


def test_a_landmark_near_the_border_keeps_what_there_is_and_none_without_its_template():
    image = photograph("camera")
    own = Appearance.taken(image, (6, 120), FIRST)
    assert own.corner == (0, 104)
    np.testing.assert_array_equal(own.template, image[115:126, 1:12])
    assert Appearance.taken(image, (4, 120), FIRST) is None
    same = own.renewed(image, Match(np.array([4.0, 120]), 1.0, 0.0), own.template, FIRST)
    assert same is own


@pytest.mark.parametrize("kind", [np.uint8, np.float32, np.float64])
def test_files_lose_nothing(kind):
    image = photograph("camera").astype(kind) + (0 if kind is np.uint8 else kind(0.1))
    own = Appearance.taken(image, (100.123456789, 50 + 1 / 3), posed([0.1, 1 / 3, 2], [0.1, 0.2, 0.3]), 13, 1234.5)
    own = Appearance.taken(image, (100, 50), FIRST, 13, previous=own)
    again = read(Appearance, json.loads(json.dumps(written(own))))
    assert again.pixels.dtype == own.pixels.dtype
    assert len(again.all) == 2
    for copy, original in zip(again.all, own.all, strict=True):
        for name in ("pixels", "pixel", "camera", "corner", "size", "quality"):
            np.testing.assert_array_equal(getattr(copy, name), getattr(original, name))
    assert json.dumps(written(again)) == json.dumps(written(own))


def test_it_cannot_be_changed_by_the_image():
    image = photograph("camera").copy()
    own = Appearance.taken(image, (100, 100), FIRST)
    before = own.template.copy()
    image[:] = 0
    np.testing.assert_array_equal(own.template, before)
    with pytest.raises(ValueError, match="read-only"):
        own.pixels[0, 0] = 1


def test_misuse_is_named():
    image = photograph("camera")
    with pytest.raises(ShapeError, match="channels"):
        Appearance.taken(np.zeros((40, 40, 3)), (20, 20), FIRST)
    with pytest.raises(SlamlibError, match="odd"):
        Appearance.taken(image, (100, 100), FIRST, 10)
    with pytest.raises(ShapeError, match="camera"):
        Appearance.taken(image, (100, 100), FIRST[:6])
    with pytest.raises(NonFiniteError):
        Appearance.taken(image, (100, np.nan), FIRST)
    own = Appearance.taken(image, (100, 100), FIRST)
    packed = written(own)
    pixels = packed["pixels"]
    wrong = [("pixels", change) for change in ("no", {**pixels, "dtype": "int7"}, {**pixels, "shape": [3]}, {})]
    for name, value in (
        *wrong,
        ("pixels", packed["pixel"]),
        ("camera", packed["pixel"]),
        ("corner", [1]),
        ("size", None),
    ):
        with pytest.raises(SlamlibError, match=rf"(?i)appearance.*\b{name}|a grey image"):
            read(Appearance, {**packed, name: value})
    with pytest.raises(SlamlibError, match="Appearance: pixels is missing"):
        read(Appearance, {})
    assert zncc(own.template, own.template) > 1 - 1e-12
