"""Films: determinism, truth, what a camera does to light, and how well features can be followed in them."""

from dataclasses import replace

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering.effects import Chip, blurred, falloff
from slambook.rendering.judging import patches, strong_corners, zncc

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.geometry.pose import compose
from slamlib.motions import CONSTANT_VELOCITY, ODOMETRY
from slamlib.rigs.setup import Rig
from slamlib.tests.rooms import pixels_of

SMALL = {"image": (160.0, 120.0), "parameters": {"intrinsics": (79.5, 59.5, 130.0, 130.0), "distortion": (-0.1, 0.01)}}
PATH = rendering.path("sideways")


@pytest.fixture(scope="module")
def room():
    return rendering.default_room("drawn")


def shot(room, frames=3, seed=1, path=PATH, rig=None, **more):
    """A film of small pictures."""
    rig = rendering.rig_along_path(path, **SMALL) if rig is None else rig
    return rendering.film(room, rig, path, frames=frames, rng=np.random.default_rng(seed), **more)


def images(film):
    return [frame.scans[0].image for frame, _ in film]


def test_a_film_is_the_same_each_time_and_depends_on_its_seed_alone(room):
    rng = np.random.default_rng(1)
    film = rendering.film(room, rendering.rig_along_path(PATH, **SMALL), PATH, frames=3, rng=rng)
    rng.standard_normal(10)
    first, again, anew, other = images(film), images(film), images(shot(room)), images(shot(room, seed=2))
    assert len(film) == len(first) == 3
    assert all((a == b).all() and (a == c).all() for a, b, c in zip(first, again, anew, strict=True))
    assert (first[0] != other[0]).mean() > 0.5
    assert first[0].dtype == np.uint8
    assert first[0].shape == (120, 160)


def test_frames_and_truth(room):
    for number, (frame, truth) in enumerate(shot(room), 1):
        assert (frame.number, frame.controls) == (number, (None,))
        assert np.isclose(frame.dt, 1 / 30)
        assert len(frame.scans[0].points) == 0
        assert np.allclose(truth.robots[0], PATH.state(number / 30))
        assert truth.robots[0].shape == (13,)


def test_the_rigs_start_is_the_paths(room):
    rig = rendering.rig_along_path(PATH)
    assert np.allclose(rig.robots[0].state, PATH.state(0))
    step = CONSTANT_VELOCITY.step(rig.robots[0].state, np.zeros(6), 1e-3)
    assert np.allclose(step[:7], PATH.pose(1e-3), atol=1e-6)
    elsewhere = Rig((replace(rig.robots[0], position=(0.0, 0.0, 0.0)),), rig.sensors)
    with pytest.raises(SlamlibError, match="rig_along_path"):
        shot(room, rig=elsewhere)


def test_odometry_gets_the_true_steps_and_noise(room):
    exact = rendering.rig_along_path(PATH, motion="odometry", control_std=(0.0,) * 6, **SMALL)
    before = PATH.pose(0)
    for frame, truth in shot(room, rig=exact):
        assert np.allclose(ODOMETRY.step(before, frame.controls[0].value, frame.dt), truth.robots[0])
        before = truth.robots[0]
    noisy = rendering.rig_along_path(PATH, motion="odometry", control_std=(0.1,) * 3 + (1.0,) * 3, **SMALL)
    pairs = zip(shot(room, 40, rig=noisy, samples=1), shot(room, 40, rig=exact, samples=1), strict=True)
    errors = np.array([a.controls[0].value - b.controls[0].value for (a, _), (b, _) in pairs])
    assert np.allclose(errors.std(0), [0.1] * 3 + [np.radians(1)] * 3, rtol=0.4)


def test_a_stereo_pair_sees_the_same_points(room):
    rig = rendering.rig_along_path(PATH, baseline=0.12, **SMALL)
    film = shot(room, 1, rig=rig, effects=rendering.NO_EFFECTS)
    ((frame, truth),) = film
    left = strong_corners(frame.scans[0].image, border=25)
    points = film.truth_of(truth, left)
    right = pixels_of(rig.sensors[1].calibration, compose(truth.poses[0], truth.extrinsics[1]), points)
    disparity, depth = left[:, 0] - right[:, 0], points[:, 0] - truth.robots[0][0]
    assert np.allclose(disparity, 130 * 0.12 / depth, rtol=0.35)  # nearly: the lens distorts, the hand turns
    likeness = zncc(patches(frame.scans[0].image, left), patches(frame.scans[1].image, right))
    assert np.median(likeness) > 0.9
    assert film.renderers[0] is film.renderers[1]


def test_mounts_that_are_estimated_are_drawn(room):
    rig = rendering.rig_along_path(PATH, **SMALL)
    loose = Rig(rig.robots, (replace(rig.sensors[0], estimated=True, position_std=(0.02,), orientation_std=(1.0,)),))
    ((_, truth),) = shot(room, 1, rig=loose)
    off = np.linalg.norm(truth.extrinsics[0][:3] - rig.sensors[0].extrinsics[:3])
    assert 0.001 < off < 0.1


@pytest.mark.parametrize("textures", rendering.ROOM_STYLES)
def test_corners_can_be_followed(textures):
    if textures == "photographs":
        pytest.importorskip("skimage")
    path, least = rendering.path("round"), {"drawn": 0.95, "photographs": 0.9}[textures]  # measured: 0.99 and 0.97
    rig = rendering.rig_along_path(path)
    film = rendering.film(rendering.default_room(textures), rig, path, frames=31, rng=np.random.default_rng(1))
    calibration, before, likeness = rig.sensors[0].calibration, None, []
    for frame, truth in film:
        image = frame.scans[0].image
        if frame.number % 10 == 1 and before is not None:
            corners = strong_corners(before[0])
            camera = compose(truth.poses[0], truth.extrinsics[0])
            pixels = pixels_of(calibration, camera, film.truth_of(before[1], corners))
            inside = calibration.inside(pixels, 9)
            assert inside.sum() > 60
            likeness.append(zncc(patches(before[0], corners[inside]), patches(image, pixels[inside])))
            assert np.median(np.linalg.norm(pixels - corners, axis=1)) < 5
        before = image, truth
    assert (np.concatenate(likeness) > 0.9).mean() > least


def test_noise_and_gain_have_their_deviations():
    rngs = [np.random.default_rng(i) for i in (1, 2)]
    chip = Chip(rendering.Effects(noise=3, gain=0.1, gain_time=0.2, vignetting=0, blur=0), (20, 30), *rngs)
    pictures = np.array([chip.expose(np.full((20, 30), 120.0), 1 / 30) for _ in range(8000)])
    means = pictures.mean((1, 2))
    assert np.isclose(np.log(means / 120).std(), 0.1, rtol=0.1)
    assert np.isclose(np.corrcoef(np.log(means[1:]), np.log(means[:-1]))[0, 1], np.exp(-1 / 6), atol=0.03)
    noise = (pictures - means[:, None, None]).std((1, 2))
    assert np.isclose(noise.mean(), np.hypot(3, 1 / np.sqrt(12)), rtol=0.01)  # and that of whole numbers


def test_corners_are_dark_and_light_is_cut_at_white():
    shade = falloff((21, 31), 0.3)
    assert np.isclose(shade[10, 15], 1)
    assert np.allclose(shade[[0, 0, -1, -1], [0, -1, 0, -1]], 0.7)
    rng = np.random.default_rng(1)
    bright = Chip(rendering.NO_EFFECTS, (1, 4), rng, rng).expose(np.array([[300.0, -5, 99.4, 99.6]]), 0.1)
    assert bright.tolist() == [[255, 0, 99, 100]]


def test_blur_has_its_variance():
    dot = np.zeros((9, 9))
    dot[4, 4] = 1
    spot, at = blurred(dot, 0.5), np.arange(9) - 4
    assert np.isclose(spot.sum(), 1)
    assert np.allclose([(spot.sum(i) * at**2).sum() for i in (0, 1)], 0.25)
    assert (blurred(dot, 0) == dot).all()
    assert np.allclose(blurred(np.full((3, 3), 7.0), 0.6), 7)


def test_motion_blur_is_the_mean_over_the_exposure(room):
    still = replace(rendering.NO_EFFECTS, exposure=1 / 60, exposures=3)
    film = shot(room, 2, effects=still)
    camera = film.rig.sensors[0].extrinsics
    times = 2 / 30 + np.array([-1, 0, 1]) / 180
    mean = np.mean([film.renderers[0].render(compose(PATH.pose(t), camera)).image for t in times], axis=0)
    assert np.abs(images(film)[1] - mean).max() <= 0.51


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"frames": -1}, "frames"),
        ({"frames": 1000}, "takes|take"),
        ({"dt": 0.0}, "dt"),
        ({"rng": 1}, "generator"),
    ],
)
def test_what_cannot_be_filmed_is_refused_at_the_call(room, wrong, says):
    settings = {"frames": 3, "rng": np.random.default_rng(1), **wrong}
    with pytest.raises(SlamlibError, match=says):
        rendering.film(room, rendering.rig_along_path(PATH, **SMALL), PATH, **settings)


def test_effects_and_motions_that_make_no_sense_are_refused(room):
    for wrong in ({"noise": -1}, {"gain": np.nan}, {"gain_time": 0}, {"vignetting": 1}, {"blur": 3}, {"exposures": 0}):
        with pytest.raises(SlamlibError, match="Effects"):
            rendering.Effects(**wrong)
    rig = rendering.rig_along_path(PATH, **SMALL)
    with pytest.raises(UnknownNameError, match="motion"):
        shot(room, rig=Rig((replace(rig.robots[0], motion="odometri"),), rig.sensors))
    with pytest.raises(SlamlibError, match="one robot"):
        shot(room, rig=Rig((rig.robots[0], replace(rig.robots[0], name="two")), rig.sensors))
