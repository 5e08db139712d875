"""The search in an ellipse: which pixels it compares, what it finds, how exactly, and when it finds nothing."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError
from slamlib.slam.data_association.gates import gate
from slamlib.tests.pictures import NAMES, cube, grid, photograph, smooth
from slamlib.tests.reference import cases
from slamlib.vision.corners import best_corner
from slamlib.vision.grid import Grid
from slamlib.vision.patches import cut, parabola, top, zncc
from slamlib.vision.search import correlate, ellipse, register, score_map, search

seeds = st.integers(0, 2**32 - 1)
centres = st.tuples(st.floats(-20, 90), st.floats(-20, 70))


def random_covariance(rng: np.random.Generator) -> np.ndarray:
    """Ellipses from one pixel to twenty, of any direction."""
    axes, turn = np.exp(rng.uniform(0, 2, 2)), rng.uniform(0, np.pi)
    R = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    S = R @ np.diag(axes**2) @ R.T
    return (S + S.T) / 2


def least(pixels: np.ndarray, centre: np.ndarray, S: np.ndarray) -> np.ndarray:
    """The least z' S^-1 z (n,) of all the positions to which each pixel (n, 2) is the nearest: its square."""
    A, corners = np.linalg.inv(S), 0.5 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    away = np.asarray(pixels, float) - centre
    values = [np.where((np.abs(away) <= 0.5).all(-1), 0, np.inf)]
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        p, d = away + start, end - start
        t = np.clip(-(p @ A @ d) / (d @ A @ d), 0, 1)
        q = p + t[:, None] * d
        values.append((q * (q @ A)).sum(-1))
    return np.min(values, axis=0)


@given(seeds, centres, st.sampled_from([0.5, 0.95, 0.99]), st.floats(0.01, 1))
def test_looked_at_are_the_pixels_nearest_to_the_ellipse_whose_window_is_in_the_image(seed, centre, probability, small):
    rng = np.random.default_rng(seed)
    image, S = rng.uniform(0, 255, (50, 70)), small * random_covariance(rng)
    u, v = (x.ravel() for x in grid(50, 70))
    expected = least(np.stack([u, v], axis=-1), centre, S) <= gate(probability, 2)
    expected &= (u >= 5) & (u <= 64) & (v >= 4) & (v <= 45)
    scores = score_map(image, rng.uniform(0, 255, (9, 11)), centre, S, probability)
    looked = np.zeros((50, 70), bool)
    if scores is not None:
        (u0, v0), (rows, columns) = scores.corner, scores.inside.shape
        looked[v0 : v0 + rows, u0 : u0 + columns] = scores.inside
    np.testing.assert_array_equal(looked.ravel(), expected)


@given(seeds, centres)
def test_scores_are_those_of_zncc_and_the_best_is_returned(seed, centre):
    rng = np.random.default_rng(seed)
    image, S, template = rng.uniform(0, 255, (50, 70)), random_covariance(rng), rng.uniform(0, 255, (9, 9))
    scores = score_map(image, template, centre, S)
    assume(scores is not None)
    (u, v), (rows, columns) = scores.corner, scores.values.shape
    windows = np.lib.stride_tricks.sliding_window_view(image, (9, 9))[v - 4 : v - 4 + rows, u - 4 : u - 4 + columns]
    np.testing.assert_allclose(scores.values, zncc(windows, template), atol=1e-12)
    match = search(image, template, centre, S)
    assert match.score == scores.values[scores.inside].max()
    row, column = np.argwhere(scores.inside & (scores.values == match.score))[0]
    far = scores.inside.copy()
    far[max(row - 4, 0) : row + 5, max(column - 4, 0) : column + 5] = False
    assert match.second == scores.values[far].max(initial=-1)
    assert 0 <= match.ratio <= 1


@given(seeds, centres, st.floats(0.01, 1))
def test_nothing_outside_of_the_ellipse_is_returned_but_by_the_fraction_of_a_pixel(seed, centre, small):
    rng = np.random.default_rng(seed)
    image, S = rng.uniform(0, 255, (50, 70)), small * random_covariance(rng)
    match = search(image, rng.uniform(0, 255, (9, 9)), centre, S)
    assume(match is not None)
    around = np.rint(match.pixel) + np.stack(np.meshgrid([-1, 0, 1], [-1, 0, 1]), axis=-1).reshape(-1, 2)
    near = around[np.abs(around - match.pixel).max(1) <= 1]
    assert least(near, centre, S).min() <= gate(0.99, 2) * (1 + 1e-9)


@given(seeds)
def test_a_small_ellipse_finds_what_is_between_its_pixels(seed):
    rng = np.random.default_rng(seed)
    by, (u, v) = rng.uniform(-0.5, 0.5, 2), grid(41, 41)
    patch = cut(smooth(u, v, 3), (20, 20), 11)
    match = search(smooth(u - by[0], v - by[1], 3), patch, 20 + by + rng.normal(0, 0.1, 2), 0.1**2 * np.eye(2))
    assert np.abs(match.pixel - 20 - by).max() < 0.25


def test_the_ellipse_is_pi_quarters_of_its_rectangle():
    # errata E59: and holds the truth with the probability of chi-square with two degrees of freedom, 9 -> 98.89 %
    rng, ratios = np.random.default_rng(1), []
    for _ in range(50):
        S = np.diag(rng.uniform(60, 90, 2) ** 2)
        _, mask = ellipse((2000, 2000), (9, 9), rng.uniform(900, 1100, 2), S, 9.0)
        ratios.append(mask.mean())
    assert abs(np.mean(ratios) / (np.pi / 4) - 1) < 0.01
    drawn = rng.multivariate_normal([0, 0], S, 200_000)
    inside = ((drawn @ np.linalg.inv(S)) * drawn).sum(1) <= 9
    assert abs(inside.mean() - 0.9889) < 0.001


@pytest.mark.parametrize("name", NAMES)
def test_a_patch_is_found_where_it_was_taken(name):
    image, rng = photograph(name), np.random.default_rng(1)
    for place in rng.integers(25, np.array(image.shape[::-1]) - 25, (40, 2)):
        patch = cut(image, place, 11)
        if patch.std() < 1:  # a clear sky
            continue
        S = random_covariance(rng)
        S *= min(1.0, 100 / S.max())
        match = search(0.5 * image + 20, patch, rng.multivariate_normal(place, S / 9), S)
        # the nearest whole pixel has the score 1; the paraboloid moves it by less than one
        assert match.score > 1 - 1e-9
        assert np.abs(match.pixel - place).max() <= 1


def test_a_patch_of_a_real_sequence_is_found_in_the_next_images():
    # no truth is needed: the way there and back must end where it began
    away, grid_ = [], Grid((384, 288), (16, 12))
    for first in range(20, 60, 5):
        a, b = cube(first), cube(first + 2)
        for cell in np.argwhere(grid_.usable):
            corner = best_corner(a, grid_.rectangle(tuple(cell)))
            if corner is None:
                continue
            patch, S = cut(a, corner.pixel, 11), 16 * np.eye(2)
            there = search(b, patch, corner.pixel, S)
            back = search(a, cut(b, there.pixel, 11), there.pixel, S)
            if there.score > 0.9 and there.ratio < 0.9:
                away.append(np.linalg.norm(back.pixel - corner.pixel))
    assert len(away) > 500
    assert np.mean(np.array(away) < 0.5) > 0.95
    assert np.median(away) < 0.15


def errors(noise: float, shift: float = 0.5, count: int = 150) -> np.ndarray:
    """Errors (n, 3, 2) [px] of whole pixels, of a match, and of its registration, on images known between pixels."""
    rng, rows = np.random.default_rng(5), []
    u, v = grid(41, 41)
    for seed in range(count):
        by = rng.uniform(-shift, shift, 2)
        a = smooth(u, v, seed) + noise * rng.standard_normal(u.shape)
        b = smooth(u - by[0], v - by[1], seed) + noise * rng.standard_normal(u.shape)
        patch, place = cut(a, (20, 20), 11), 20 + by
        match = search(b, patch, (20, 20), 4 * np.eye(2))
        if np.abs(match.pixel - place).max() < 1.5:
            finer = register(b, patch, match.pixel)
            rows.append([np.rint(match.pixel) - place, match.pixel - place, finer - place])
    assert len(rows) > 0.95 * count
    return np.array(rows)


def test_a_match_is_exact_to_a_fraction_of_a_pixel():
    whole, match, registered = np.sqrt((errors(noise=3.0) ** 2).mean((0, 2)))
    assert whole > 0.25
    assert match < 0.1
    assert registered < 0.6 * match


def test_registration_without_noise_is_exact_to_hundredths():
    assert np.abs(errors(noise=0.0)[:, 2]).max() < 0.08


def test_registration_does_not_see_gain_and_offset_and_says_when_it_cannot():
    u, v = grid(41, 41)
    image = smooth(u, v)
    patch = cut(image, (20.3, 19.8), 11)
    np.testing.assert_allclose(register(3 * image - 50, patch, (20, 20)), (20.3, 19.8), atol=0.02)
    assert register(-image, patch, (20.3, 19.8)) is None  # a negative
    assert register(image, patch, (3, 20)) is None  # beyond the border
    assert register(np.zeros((41, 41)), patch, (20, 20)) is None
    assert register(image, np.ones((11, 11)), (20, 20)) is None


def test_parabolas_are_those_of_the_toolbox():
    for given_, found in cases("appearance", "maxParab"):
        np.testing.assert_allclose(parabola(given_["yl"], given_["yc"], given_["yr"]), found["xm"], rtol=1e-12)
    for given_, found in cases("appearance", "maxParab2"):
        around = np.full((3, 3), np.nan)
        around[1] = given_["yl"], given_["yc"], given_["yr"]
        around[0, 1], around[2, 1] = given_["yu"], given_["yd"]
        np.testing.assert_allclose(top(around), found["xm"], rtol=1e-12)


@given(st.floats(-0.6, 0.6), st.floats(-0.6, 0.6), st.floats(-0.9, 0.9))
def test_the_paraboloid_knows_slanted_ridges(x, y, slant):
    v, u = np.mgrid[-1:2, -1:2] - np.array([y, x])[:, None, None]
    np.testing.assert_allclose(top(5 - u * u - v * v - 2 * slant * u * v), [x, y], atol=1e-9)
    assert (top(np.ones((3, 3))) == 0).all()
    assert (top(u * u + v * v) == 0).all()


@pytest.mark.parametrize("name", NAMES)
def test_opencv_has_the_same_scores(name):
    cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")
    image, compared = photograph(name).astype(float), 0
    for u, v in np.random.default_rng(1).integers(20, np.array(image.shape[::-1]) - 60, (20, 2)):
        piece, patch = image[v : v + 40, u : u + 40], cut(image, (u + 20, v + 20), 11)
        deviation = np.lib.stride_tricks.sliding_window_view(piece, (11, 11)).std((2, 3))
        if patch.std() < 20:
            continue
        # theirs is of single precision, and wants grey levels near zero, and texture
        single = ((x - piece.mean()).astype(np.float32) for x in (piece, patch))
        theirs, ours = cv2.matchTemplate(*single, cv2.TM_CCOEFF_NORMED), correlate(piece, patch)
        np.testing.assert_allclose(ours[deviation > 20], theirs[deviation > 20], atol=1e-5)
        compared += 1
    assert compared > 3


def test_where_there_is_no_texture_the_score_is_zero():
    rng = np.random.default_rng(1)
    textured, flat = rng.uniform(0, 255, (11, 11)), np.full((60, 60), 77.7)
    assert search(flat, textured, (30, 30), 9 * np.eye(2)).score == 0
    image = flat.copy()
    image[:20] = rng.uniform(0, 255, (20, 60))
    assert search(image, np.ones((11, 11)), (30, 30), 9 * np.eye(2)).score == 0
    scores = score_map(image, textured, (30, 30), 1e3 * np.eye(2))
    rows = np.arange(len(scores.values)) + scores.corner[1]
    assert (scores.values[rows >= 25] == 0).all()
    assert search(flat, textured, (30, 30), np.eye(2)).ratio == 1


def test_expected_events_are_none():
    rng = np.random.default_rng(1)
    image, template = rng.uniform(0, 255, (60, 60)), rng.uniform(0, 255, (11, 11))
    assert search(image, template, (-30, 30), np.eye(2)) is None
    assert search(image, template, (2, 30), 0.25 * np.eye(2)) is None
    assert search(rng.uniform(0, 255, (9, 9)), template, (4, 4), np.eye(2)) is None  # smaller than the template
    small = search(image, template, (30, 30), 0.2 * np.eye(2))
    assert small.second == -1


@given(seeds)
@settings(max_examples=20)
def test_uint8_floats_and_other_units_are_the_same(seed):
    rng = np.random.default_rng(seed)
    image = rng.integers(0, 256, (50, 60), dtype=np.uint8)
    template = image[20:31, 20:31]
    first = search(image, template, (27, 24), 9 * np.eye(2))
    for scale in (1.0, 1 / 255, 1e6):
        other = search(scale * image.astype(float), scale * template.astype(float), (27, 24), 9 * np.eye(2))
        np.testing.assert_allclose(other.pixel, first.pixel, atol=1e-6)
        np.testing.assert_allclose([other.score, other.second], [first.score, first.second], atol=1e-9)


def test_a_whole_image_may_be_searched():
    image = photograph("camera")
    match = search(image, cut(image, (200, 60), 13), (100, 100), np.eye(2), probability=1)
    assert np.abs(match.pixel - (200, 60)).max() < 0.5


def test_misuse_is_named():
    image, template = np.random.default_rng(0).uniform(0, 255, (2, 40, 40))
    with pytest.raises(ShapeError, match="3 channels"):
        search(np.zeros((40, 40, 3)), template[:9, :9], (20, 20), np.eye(2))
    with pytest.raises(ShapeError, match="channels"):
        search(image, np.zeros((9, 9, 3)), (20, 20), np.eye(2))
    with pytest.raises(SlamlibError, match="odd sizes"):
        search(image, template[:10, :9], (20, 20), np.eye(2))
    for S in ([[1, 2], [2, 1]], [[1, 0.5], [0, 1]], [[0, 0], [0, 0]], [[-1, 0], [0, -1]]):
        with pytest.raises(CovarianceError, match="positive definite"):
            search(image, template[:9, :9], (20, 20), np.array(S))
    with pytest.raises(ShapeError):
        search(image, template[:9, :9], (20, 20, 1), np.eye(2))
    with pytest.raises(NonFiniteError):
        search(image, template[:9, :9], (np.nan, 20), np.eye(2))
    image[20, 20] = np.inf
    with pytest.raises(NonFiniteError, match="nan or infinity"):
        search(image, template[:9, :9], (20, 20), np.eye(2))
