"""Predicted appearance: against a plane drawn by tracing rays, and the maps against each other."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slambook.patch_maps import similarity, ssd

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import relative
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.sensors.omni import OMNI
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.tests.pictures import grid, smooth
from slamlib.vision.patches import zncc
from slamlib.vision.warping import (
    affine,
    facing_plane,
    homography_through,
    in_camera,
    seen_by,
    stretch,
    through_camera,
    warp,
)

K = np.array([[260, 0, 159.5], [0, 250, 119.5], [0, 0, 1]])
IDEAL = Calibration(PINHOLE, np.eye(2), image=(320, 240), intrinsics=[159.5, 119.5, 260, 250], distortion=[0])
CAMERAS = {
    "ideal": IDEAL,
    "distorted": Calibration(
        PINHOLE, np.eye(2), image=(320, 240), intrinsics=[159.5, 119.5, 260, 250], distortion=[-0.2, 0.03]
    ),
    "omni": Calibration(
        OMNI, np.eye(2), image=(320, 240), intrinsics=[159.5, 119.5, 1, 0, 0], lens=[150, 0, -5], limits={"angle": 1.5}
    ),
}
FIRST = np.array([0.0, 0, 0, 1, 0, 0, 0])
numbers, seeds = st.floats(-1, 1), st.integers(0, 1000)


def posed(position: list[float], turn: list[float]) -> np.ndarray:
    """A pose (7,) by its position [m] and its rotation vector [rad]."""
    return np.concatenate([position, exponential(np.array(turn, float))])


def plane_homography(K_new: np.ndarray, K_old: np.ndarray, relative: np.ndarray, plane: np.ndarray) -> np.ndarray:
    """K_new (R + t m') K_old^-1 (3, 3): takes pixels (u, v, 1) of a plane from the old image to the new one."""
    return K_new @ (rotation(relative[3:]) + np.outer(relative[:3], plane)) @ np.linalg.inv(K_old)


def offsets_map(H: np.ndarray, old: np.ndarray) -> np.ndarray:
    """The map between offsets of a homography (3, 3) from old to new pixels, about an old pixel (2,) and its image."""
    image = H @ np.array([*old, 1])
    from_new, to_old = np.eye(3), np.eye(3)
    from_new[:2, 2], to_old[:2, 2] = image[:2] / image[2], -np.asarray(old)
    result = to_old @ np.linalg.solve(H, from_new)
    return result / result[2, 2]


def zoom_and_roll(relative: np.ndarray, point: np.ndarray) -> tuple[float, float]:
    """Quotient of the depths of a homogeneous point (4,), old by new, and roll [rad]: the manual's step 2e."""
    R = rotation(relative[3:])
    return point[2] / (R @ point[:3] + relative[:3] * point[3])[2], np.arctan2(R[1, 0] - R[0, 1], R[0, 0] + R[1, 1])


def drawn(calibration: Calibration, camera: np.ndarray, plane: np.ndarray, pixels: np.ndarray, seed: int) -> np.ndarray:
    """Grey levels (...) at pixels (..., 2) of a painted plane m'X = 1 of the world: where each ray meets it."""
    ones = np.ones((*pixels.shape[:-1], 1))
    rays = calibration.sensor.back_project(pixels, ones, **calibration.given)[..., :3] @ rotation(camera[3:]).T
    distance = (1 - camera[:3] @ plane) / (rays @ plane)
    places = camera[:3] + rays * distance[..., None]
    axes = np.linalg.svd(plane[None])[2][1:]  # two directions in the plane
    a, b = np.moveaxis(100 * places @ axes.T, -1, 0)  # 1 cm is a unit of the texture
    return smooth(a, b, seed, shortest=8.0)


def predicted(calibration: Calibration, camera: np.ndarray, pixel: np.ndarray, seed: int, depth: float = 2.0):
    """A template of a facing plane at a distance [m] as it is warped, and as it is drawn; None if it cannot be."""
    point = calibration.sensor.back_project(pixel, np.array([1 / depth]), **calibration.given)
    plane, now = facing_plane(point), in_camera(camera, point)
    assume(calibration.visible(now))
    place = calibration.project(now)
    u, v = grid(61, 61)
    corner = np.rint(pixel) - 30
    reference = drawn(calibration, FIRST, plane, np.stack([u, v], axis=-1) + corner, seed)
    (H,) = through_camera(calibration, relative(camera, FIRST)[None], plane[None], place[None], 11)
    template = warp(reference, pixel - corner, H, 11)
    offsets = np.stack(np.meshgrid(np.arange(-5, 6), np.arange(-5, 6)), axis=-1)
    return template, drawn(calibration, camera, plane, place + offsets, seed), H


@pytest.mark.parametrize("name", CAMERAS)
@settings(max_examples=40)
@given(st.tuples(*[numbers] * 3), st.tuples(*[numbers] * 3), st.tuples(numbers, numbers), seeds)
def test_a_template_is_what_the_camera_draws(name, move, turn, place, seed):
    camera = posed(0.4 * np.array(move), [0.15 * turn[0], 0.15 * turn[1], 0.8 * turn[2]])
    template, expected, H = predicted(CAMERAS[name], camera, 159.5 + 40 * np.array(place) - (0, 40), seed)
    least, largest = stretch(H)
    assert 0.5 < least <= largest < 2
    # bilinear interpolation and averaging smooth a little
    assert zncc(template, expected) > 0.995
    assert ssd(template, expected) < 0.1 * expected.std() + 1


@given(st.tuples(*[numbers] * 3), st.tuples(*[numbers] * 3), st.floats(0, 2))
def test_without_distortion_the_map_is_the_homography_of_the_plane(move, turn, inverse_distance):
    camera, pixel = posed(0.3 * np.array(move), 0.2 * np.array(turn)), np.array([150.0, 130])
    point = IDEAL.sensor.back_project(pixel, np.array([inverse_distance]), **IDEAL.given)
    plane, seen, now = facing_plane(point), relative(camera, FIRST), in_camera(camera, point)
    assume(now[2] > 0.1 * np.linalg.norm(now[:3]))
    H = plane_homography(K, K, seen, plane)
    image = H @ [*pixel, 1]
    np.testing.assert_allclose(image[:2] / image[2], IDEAL.project(now), atol=1e-8)
    (found,) = through_camera(IDEAL, seen[None], plane[None], IDEAL.project(now)[None], 11)
    assume(np.isfinite(found).all())
    np.testing.assert_allclose(found, offsets_map(H, pixel), atol=1e-8)


@pytest.mark.parametrize("name", CAMERAS)
def test_infinitely_far_away_only_the_rotation_counts(name):
    calibration, pixel = CAMERAS[name], np.array([170.0, 110])
    point = calibration.sensor.back_project(pixel, np.array([0.0]), **calibration.given)
    assert not facing_plane(point).any()
    maps = []
    for position in ([0, 0, 0], [5, -3, 100.0]):
        camera = posed(position, [0.05, -0.1, 0.3])
        now = in_camera(camera, point)
        assert now[3] == 0
        place = calibration.project(now)
        maps.append(through_camera(calibration, relative(camera, FIRST)[None], np.zeros((1, 3)), place[None], 11)[0])
    np.testing.assert_allclose(*maps, atol=1e-9)
    np.testing.assert_allclose(np.linalg.det(affine(maps[0])), 1, atol=0.1)


@pytest.mark.parametrize(("depth", "roll"), [(1.0, 0.0), (-1.0, 0.0), (1.2, 0.5), (-2.0, -1.0), (0.0, 3.0)])
def test_zoom_and_roll_are_exact_for_a_facing_patch_on_the_axis(depth, roll):
    # the world turns the other way than the camera; both directions of zoom
    camera, point = posed([0, 0, depth], [0, 0, -roll]), np.array([0, 0, 1, 1 / 4])
    seen = relative(camera, FIRST)
    zoom, turned = zoom_and_roll(seen, point)
    np.testing.assert_allclose([zoom, turned], [4 / (4 - depth), roll], atol=1e-12)
    square = np.diag([250.0, 250, 1])
    H = offsets_map(plane_homography(square, square, seen, facing_plane(point)), (0, 0))
    np.testing.assert_allclose(similarity(zoom, turned), H, atol=1e-12)
    np.testing.assert_allclose(stretch(H), [1 / zoom] * 2, atol=1e-12)


def test_a_better_map_makes_a_better_template():
    off, pixel = {"similarity": [], "affine": [], "homography": []}, np.array([159.0, 119])
    point = IDEAL.sensor.back_project(pixel, np.array([0.5]), **IDEAL.given)
    u, v = grid(121, 121)
    around = np.stack([u, v], axis=-1) - 60
    for seed in range(12):
        camera, plane = posed([1.2, 0.2 * np.cos(seed), 0.3], [0, -0.6, 0.3]), facing_plane(point)
        seen, place = relative(camera, FIRST), IDEAL.project(in_camera(camera, point))
        reference = drawn(IDEAL, FIRST, plane, pixel + around, seed)
        expected = drawn(IDEAL, camera, plane, place + around[45:76, 45:76], seed)
        H = offsets_map(plane_homography(K, K, seen, plane), pixel)
        maps = {"similarity": similarity(*zoom_and_roll(seen, point)), "affine": affine(H), "homography": H}
        for name, own in maps.items():
            off[name].append(ssd(warp(reference, (60, 60), own, 31), expected))
    mean = {name: np.mean(values) for name, values in off.items()}
    assert mean["homography"] < 0.7 * mean["affine"] < 0.5 * mean["similarity"]


@given(st.integers(0, 10**6))
def test_affine_is_the_first_order_of_the_map(seed):
    rng = np.random.default_rng(seed)
    H = np.eye(3) + rng.uniform(-0.2, 0.2, (3, 3)) * [[1, 1, 5], [1, 1, 5], [0.01, 0.01, 1]]

    def at(x: np.ndarray) -> np.ndarray:
        y = H @ np.append(x, 1)
        return y[:2] / y[2]

    step = 1e-5
    slope = np.stack([(at(step * e) - at(-step * e)) / (2 * step) for e in np.eye(2)], axis=1)
    np.testing.assert_allclose(affine(H)[:2, :2], slope, atol=1e-8)
    np.testing.assert_allclose(affine(H)[:2, 2], at(np.zeros(2)), atol=1e-12)
    np.testing.assert_allclose(stretch(H), np.linalg.svd(slope, compute_uv=False)[::-1], atol=1e-7)


@given(st.integers(0, 10**6))
def test_a_homography_takes_four_points_to_four(seed):
    rng = np.random.default_rng(seed)
    source = np.array([[-5, -5], [5, -5], [5, 5], [-5, 5]]) + rng.uniform(-1, 1, (3, 4, 2))
    target = source + rng.uniform(-1, 1, (3, 4, 2))
    image = np.concatenate([source, np.ones((3, 4, 1))], axis=-1) @ homography_through(source, target).swapaxes(1, 2)
    np.testing.assert_allclose(image[..., :2] / image[..., 2:], target, atol=1e-9)


def test_zooming_out_averages():
    # stripes one pixel wide are grey from afar, and not stripes of another width
    stripes = np.tile([0.0, 200.0], (61, 31))[:, :61]
    for zoom in (1 / 2, 1 / 1.7):
        flat = warp(stripes, (30, 30), similarity(zoom, 0), 11)
        assert flat.std() < 40
        assert abs(flat.mean() - 100) < 10
    np.testing.assert_allclose(warp(stripes, (30, 30), similarity(1 / 2, 0), 11), 100)
    unchanged = warp(stripes, (30, 30), np.eye(3), 11)
    np.testing.assert_array_equal(unchanged, stripes[25:36, 25:36])


def test_zooming_in_interpolates():
    u, _ = grid(61, 61)
    template = warp(3 * u, (30, 30), similarity(2.0, 0), 11)
    np.testing.assert_allclose(template, np.tile(90 + 1.5 * np.arange(-5, 6), (11, 1)), atol=1e-12)


def test_what_cannot_be_predicted_is_none_or_nan():
    reference = np.zeros((21, 21))
    assert warp(reference, (10, 10), similarity(1 / 3, 0), 11) is None
    assert warp(reference, (3, 10), np.eye(3), 11) is None
    assert warp(reference, (10, 10), np.array([[1, 0, 0], [0, 1, 0], [0.3, 0, 1.0]]), 11) is None
    point = np.array([0.0, 0, 1, 0.5])
    plane, centre = facing_plane(point)[None], np.full((1, 2, 2), 159.5)
    behind = relative(posed([0, 0, 5], [0, np.pi, 0]), FIRST)[None]  # sees the plane from its other side
    beside = relative(posed([0, 0, 0], [0, np.pi / 2 + 0.1, 0]), FIRST)[None]  # its rays miss the plane
    for seen in (behind, beside):
        assert np.isnan(seen_by(IDEAL, seen, plane, centre)).all()


def test_a_pixel_without_a_ray_leaves_the_others():
    lens = Calibration(
        PINHOLE,
        np.eye(2),
        image=(320, 240),
        intrinsics=[159.5, 119.5, 260, 260],
        distortion=[-0.9],
        limits={"radius": 0.3},
    )
    pixels = np.array([[[160.0, 120]], [[2000.0, 120]], [[150.0, 110]]])
    seen, plane = np.tile(relative(FIRST, FIRST), (3, 1)), np.tile(facing_plane(np.array([0, 0, 1, 0.5])), (3, 1))
    found = seen_by(lens, seen, plane, pixels)
    np.testing.assert_allclose(found[[0, 2]], pixels[[0, 2]], atol=1e-9)
    assert np.isnan(found[1]).all()


def test_misuse_is_named():
    with pytest.raises(SingularPointError, match="on a line"):
        homography_through([[0, 0], [1, 0], [2, 0], [0, 1]], [[0, 0], [1, 0], [2, 1], [0, 1]])
    with pytest.raises(SlamlibError, match="odd"):
        warp(np.zeros((21, 21)), (10, 10), np.eye(3), 10)
