"""Corners: the structure tensor, what its smaller eigenvalue means, and where the best corner of a rectangle is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from slamlib.errors import NonFiniteError, ShapeError
from slamlib.tests.pictures import NAMES, cube, grid, photograph, smooth
from slamlib.tests.reference import cases
from slamlib.vision.corners import (
    QUALITY,
    SUPPORT,
    best_corner,
    eigenvalues,
    strength,
    structure_tensor,
)
from slamlib.vision.grid import Grid
from slamlib.vision.patches import cut
from slamlib.vision.search import register, search

EVERYWHERE = (0, 0, 10**6, 10**6)


@given(st.floats(-50, 50), st.floats(-50, 50))
def test_the_tensor_of_a_slope_is_its_own_times_the_windows_weight(a, b):
    u, v = grid(60, 60)
    tensor = structure_tensor(7 + a * u + b * v)
    side = 60 - 2 * SUPPORT
    assert tensor.shape == (3, side, side)
    weight = np.exp(-(np.arange(-5, 6) ** 2) / 8).sum() ** 2
    expected = weight * np.array([a * a, a * b, b * b])[:, None, None] * np.ones((side, side))
    np.testing.assert_allclose(tensor, expected, atol=1e-6)


def test_the_tensor_is_that_of_a_plain_sum():
    image, (u, v) = photograph("camera")[60:100, 80:120].astype(float), (17, 22)
    bell = lambda x, s: np.exp(-(x**2) / (2 * s**2))  # noqa: E731
    x = np.arange(-4, 5)
    smoothing, slope = bell(x, 1) / bell(x, 1).sum(), x * bell(x, 1) / (x * x * bell(x, 1)).sum()
    total = np.zeros((2, 2))
    for j in range(-5, 6):
        for i in range(-5, 6):
            piece = image[v + j - 4 : v + j + 5, u + i - 4 : u + i + 5]
            g = np.array([smoothing @ piece @ slope, slope @ piece @ smoothing])
            total += bell(i, 2) * bell(j, 2) * np.outer(g, g)
    tensor = structure_tensor(image)[:, v - SUPPORT, u - SUPPORT]
    np.testing.assert_allclose(tensor, total[[0, 0, 1], [0, 1, 1]], rtol=1e-10)
    np.testing.assert_allclose(eigenvalues(tensor), np.linalg.eigvalsh(total), rtol=1e-10)
    np.testing.assert_allclose(strength(image)[v, u], np.linalg.eigvalsh(total)[0], rtol=1e-10)


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))
def test_eigenvalues_are_those_of_the_matrices(a, b, c):
    matrix = np.array([[a, b], [b, c]]) @ np.array([[a, b], [b, c]])
    found = eigenvalues(matrix[[0, 0, 1], [0, 1, 1]])
    np.testing.assert_allclose(found, np.linalg.eigvalsh(matrix), atol=1e-9 * (1 + matrix.max()))


def matching_covariance(patch: np.ndarray, sigma: float, free: bool = False) -> np.ndarray:
    """Covariance (2, 2) [px^2] of a matched position, sigma^2 (sum of g g')^-1; free: gain and offset are unknown."""
    gv, gu = np.gradient(np.asarray(patch, float))
    slopes = np.stack([gu.ravel(), gv.ravel()], axis=1)
    if free:  # what of the gradients looks like either tells nothing of the position
        known = np.linalg.qr(np.stack([np.ones(patch.size), np.asarray(patch, float).ravel()], axis=1))[0]
        slopes = slopes - known @ (known.T @ slopes)
    return sigma**2 * np.linalg.inv(slopes.T @ slopes)


def blob(u: float, v: float, width: float = 2.0) -> np.ndarray:
    """A round spot (61, 61) around a place between the pixels."""
    x, y = grid(61, 61)
    return 100 + 100 * np.exp(-((x - u) ** 2 + (y - v) ** 2) / (2 * width**2))


@given(st.floats(29, 31), st.floats(29, 31), st.floats(1, 2))
def test_a_spot_is_found_to_hundredths_of_a_pixel(u, v, width):
    # not wider than the window: of a wide one the rim is the better corner
    corner = best_corner(blob(u, v, width), EVERYWHERE)
    assert np.abs(corner.pixel - (u, v)).max() < 0.05


def test_a_corner_moves_with_its_image():
    rng, away = np.random.default_rng(1), []
    u, v = grid(41, 41)
    for seed in range(200):
        by = rng.uniform(-0.5, 0.5, 2)
        first, second = (best_corner(smooth(u - du, v - dv, seed), EVERYWHERE) for du, dv in ((0, 0), by))
        if first is not None and second is not None:
            away.append(np.abs(second.pixel - first.pixel - by).max())
    away = np.array([a for a in away if a < 2])  # others are another corner
    assert len(away) > 100
    assert np.median(away) < 0.1
    assert np.quantile(away, 0.9) < 0.4


def test_the_toolbox_finds_the_same_corners():
    """Its pixels, called MATLAB's, are counted from zero: the mirror below shows which of the two is in the middle."""
    for given_, found in cases("appearance", "harris_strongest"):
        values = strength(given_["im"])
        assert tuple(found["point"].astype(int)) == np.unravel_index(values.argmax(), values.shape)[::-1]


def test_no_side_is_preferred():
    image = np.random.default_rng(1).uniform(0, 255, (40, 50))
    for turned in (lambda a: a[:, ::-1], lambda a: a[::-1], np.transpose):
        assert np.allclose(strength(turned(image)), turned(strength(image)), rtol=1e-12)
    for right in (True, False):
        for down in (
            True,
            False,
        ):  # the corner of a bright quarter, found inside it
            inside = (np.arange(60) > 29.5) == right, (np.arange(60) > 29.5) == down
            corner = best_corner(np.where(np.outer(inside[1], inside[0]), 200, 0).astype(np.uint8), EVERYWHERE)
            assert np.allclose(np.abs(corner.pixel - 29.5), np.abs(corner.pixel - 29.5).mean())
            assert tuple(corner.pixel > 29.5) == (right, down)


@pytest.mark.parametrize("name", NAMES)
def test_the_best_corner_of_a_cell_is_that_of_the_whole_image_there(name):
    image = photograph(name)
    values, cells = strength(image), Grid(image.shape[::-1], (8, 6))
    smaller, larger = eigenvalues(structure_tensor(image))
    edges = np.pad(larger > 20 * smaller, SUPPORT, constant_values=True)
    highest = np.lib.stride_tricks.sliding_window_view(np.pad(values, 1), (3, 3)).max((2, 3))
    for cell in np.argwhere(cells.usable):
        u0, v0, u1, v1 = cells.rectangle(tuple(cell))
        part = np.where(edges | (values < highest), 0, values)[v0:v1, u0:u1]
        corner = best_corner(image, (u0, v0, u1, v1))
        if part.max() < QUALITY:
            assert corner is None
            continue
        np.testing.assert_allclose(corner.quality, part.max(), rtol=1e-9)
        row, column = np.unravel_index(part.argmax(), part.shape)
        assert np.abs(corner.pixel - (u0 + column, v0 + row)).max() <= 1


def test_an_edge_is_none_and_neither_is_what_is_flat_or_too_weak():
    u, v = grid(61, 61)
    edge = 128 + 100 * np.tanh((u - 30 + 0.4 * (v - 30)) / 2)
    assert best_corner(edge, EVERYWHERE) is None
    assert best_corner(np.full((61, 61), 9.0), EVERYWHERE, quality=0) is None
    assert best_corner(blob(30, 30), EVERYWHERE, quality=1e9) is None
    ridge = edge + 0.02 * blob(30, 30)
    assert best_corner(ridge, EVERYWHERE, quality=0, edge=20) is None
    assert best_corner(ridge, EVERYWHERE, quality=0, edge=1e9) is not None


def test_only_the_rectangle_and_what_is_off_the_border_is_looked_at():
    image = blob(30, 30)
    assert best_corner(image, (35, 35, 60, 60)) is None  # the flank of a spot is none
    assert best_corner(image, (25, 25, 31, 31)) is not None
    assert best_corner(image, (25, 25, 31, 31), border=31) is None
    assert best_corner(image, (31, 31, 25, 25)) is None
    assert best_corner(image[:15, :15], EVERYWHERE) is None
    assert best_corner(image, (-50, -50, 200, 200)) is not None
    hidden = image.copy()
    hidden[:10], hidden[-10:] = np.nan, np.nan  # far from the rectangle: never touched
    np.testing.assert_array_equal(best_corner(hidden, (29, 29, 32, 32)).pixel, best_corner(image, EVERYWHERE).pixel)


def test_uint8_and_floats_are_the_same():
    image = photograph("camera")
    first, second = (best_corner(x, (40, 40, 120, 120)) for x in (image, image.astype(float)))
    np.testing.assert_array_equal(first.pixel, second.pixel)
    assert first.quality == second.quality


# -- the meaning of the quality ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("free", "gain"), [(False, 1.0), (True, 0.7)])
def test_the_covariance_of_a_match_is_the_inverse_of_the_tensor(free, gain):
    # one image, seen again and again with other noise: the scatter of the best positions, by registration
    rng, sigma = np.random.default_rng(2), 3.0
    u, v = grid(41, 41)
    for seed in range(4):
        image = smooth(u, v, seed, shortest=9.0)
        patch = image[15:26, 15:26]
        found = [register(gain * (image + sigma * rng.standard_normal(u.shape)), patch, (20, 20)) for _ in range(400)]
        scatter, expected = np.cov(np.array(found).T), matching_covariance(patch, sigma, free=True)
        ratio = np.linalg.eigvals(np.linalg.solve(expected, scatter))
        assert (ratio > 0.6).all()
        assert (ratio < 1.5).all()
        assert np.linalg.eigvalsh(expected - matching_covariance(patch, sigma))[0] >= -1e-12  # what is not known costs
        if not free:
            fixed = np.array(
                [_with_known_gain(image + sigma * rng.standard_normal(u.shape), patch) for _ in range(400)]
            )
            ratio = np.linalg.eigvals(np.linalg.solve(matching_covariance(patch, sigma), np.cov(fixed.T)))
            assert (ratio > 0.6).all()
            assert (ratio < 1.5).all()


def _with_known_gain(image: np.ndarray, patch: np.ndarray) -> np.ndarray:
    """One step of least squares from the true position, for gain 1 and offset 0."""
    down, across = np.gradient(patch)
    slopes = np.stack([across.ravel(), down.ravel()], axis=1)
    return np.linalg.lstsq(slopes, (patch - image[15:26, 15:26]).ravel(), rcond=None)[0]


@pytest.mark.parametrize("name", NAMES)
def test_the_quality_bounds_the_covariance(name):
    image, cells = photograph(name), Grid(photograph(name).shape[::-1], (8, 6))
    corners = [best_corner(image, cells.rectangle(tuple(cell))) for cell in np.argwhere(cells.usable)]
    found = [c for c in corners if c is not None]
    assert found
    for corner in found:
        worst = np.linalg.eigvalsh(matching_covariance(cut(image, np.rint(corner.pixel), 11), 1.0))[1]
        assert worst <= 1.1 / corner.quality


def test_better_corners_are_matched_better_on_a_real_sequence():
    # Noise is added, as a poor camera has it; the right position is the pixel itself
    rng, right, low = np.random.default_rng(1), [], []
    for number in range(0, 80, 16):
        image, cells = cube(number), Grid((384, 288), (24, 18))
        noisy = [np.clip(image + 4 * rng.standard_normal(image.shape), 0, 255) for _ in range(2)]
        for cell in np.argwhere(cells.usable):
            corner = best_corner(noisy[0], cells.rectangle(tuple(cell)), quality=1)
            if corner is None:
                continue
            pixel = np.rint(corner.pixel)
            match = search(noisy[1], cut(noisy[0], pixel, 11), pixel + rng.normal(0, 4, 2), 16 * np.eye(2))
            good = match is not None and np.abs(match.pixel - pixel).max() < 1
            (right if corner.quality >= QUALITY else low).append(good)
    assert len(right) > 500
    assert len(low) > 100
    assert np.mean(right) > 0.97  # the ellipse of 99 % leaves some outside
    assert np.mean(low) < np.mean(right)


def test_misuse_is_named():
    with pytest.raises(ShapeError, match="4 channels"):
        best_corner(np.zeros((60, 60, 4)), EVERYWHERE)
    with pytest.raises(ShapeError, match="more than 18 px a side"):
        structure_tensor(np.zeros((18, 60)))
    with pytest.raises(NonFiniteError):
        strength(np.full((60, 60), np.nan))
