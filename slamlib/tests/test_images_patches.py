"""Patches, and what compares them: invariances, bounds, and the toolbox's numbers."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from slambook.patch_maps import census, ssd

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.tests.pictures import grid
from slamlib.tests.reference import cases
from slamlib.vision.patches import centred, cut, grey, sample, zncc

seeds, odd = st.integers(0, 2**32 - 1), st.sampled_from([9, 11, 13, 15])
COMPARE = [zncc, ssd, census]


def pair(seed: int, size: int) -> np.ndarray:
    """Two patches (2, size, size) that are somewhat alike."""
    a, b = np.random.default_rng(seed).uniform(0, 255, (2, size, size))
    return np.stack([a, 0.7 * a + 0.3 * b])


@given(seeds, odd, st.floats(1e-3, 1e3), st.floats(-1e4, 1e4))
def test_zncc_does_not_see_gain_and_offset_and_a_negative_is_opposite(seed, size, gain, offset):
    a, b = pair(seed, size)
    expected = zncc(a, b)
    assert -1 <= expected <= 1
    np.testing.assert_allclose(zncc(gain * a + offset, b), expected, atol=1e-7)
    np.testing.assert_allclose(zncc(a, -gain * b + offset), -expected, atol=1e-7)


@given(seeds, odd)
def test_they_are_symmetric_and_a_patch_is_most_like_itself(seed, size):
    a, b = pair(seed, size)
    for compare in COMPARE:
        assert compare(a, b) == compare(b, a)
    assert abs(zncc(a, a) - 1) < 1e-15
    assert ssd(a, a) == 0
    assert census(a, a) == 1


@given(seeds, odd)
def test_they_are_what_the_sums_say(seed, size):
    a, b = pair(seed, size)
    n, SI, SJ, SIJ, SII, SJJ = a.size, a.sum(), b.sum(), (a * b).sum(), (a * a).sum(), (b * b).sum()
    by_sums = (n * SIJ - SI * SJ) / np.sqrt((n * SII - SI**2) * (n * SJJ - SJ**2))
    np.testing.assert_allclose(zncc(a, b), by_sums, atol=1e-12)
    np.testing.assert_allclose(ssd(a, b), np.sqrt((SII - 2 * SIJ + SJJ) / n), atol=1e-9)


@given(seeds)
def test_census_sees_only_the_order(seed):
    a, b = pair(seed, 9)
    assert census(np.exp(a / 50), b) == census(a, b)


@pytest.mark.parametrize("compare", COMPARE)
def test_stacks_are_compared_one_by_one(compare):
    a, b = np.random.default_rng(1).uniform(0, 255, (2, 4, 3, 9, 11))
    result = compare(a, b)
    assert result.shape == (4, 3)
    assert compare(a, b[0, 0]).shape == (4, 3)
    for i in np.ndindex(4, 3):
        assert compare(a[i], b[i]) == result[i]


@pytest.mark.parametrize("level", [0, 0.1, 255, 1e6 / 3])
def test_without_texture_nothing_is_alike(level):
    flat, other = np.full((11, 11), level), np.random.default_rng(0).uniform(0, 1, (11, 11))
    assert zncc(flat, other) == zncc(other, flat) == zncc(flat, flat) == 0
    assert not any(x.any() for x in centred(flat))


@pytest.mark.parametrize(("name", "compare"), [("zncc", zncc), ("ssd", ssd), ("census", census)])
def test_the_toolbox_has_the_same_numbers(name, compare):
    for given_, found in cases("appearance", name):
        np.testing.assert_allclose(compare(given_["I"], given_["J"]), found["sc"], rtol=1e-12)


@given(st.floats(5, 20), st.floats(5, 25), odd)
def test_cut_is_exact_on_a_bilinear_image(u, v, size):
    across, down = grid(31, 26)
    image, half = 3 + 2 * across - down + 0.1 * across * down, size // 2
    patch = cut(image, (u, v), size)
    inside = half <= u <= 25 - half and half <= v <= 30 - half
    assert (patch is not None) == inside
    assume(patch is not None)
    x, y = u + np.arange(-half, half + 1), v + np.arange(-half, half + 1)[:, None]
    np.testing.assert_allclose(patch, 3 + 2 * x - y + 0.1 * x * y, atol=1e-11)
    places = np.stack(np.broadcast_arrays(x, y), axis=-1)
    np.testing.assert_allclose(sample(image, places), patch, atol=1e-11)


def test_samples_outside_are_nan():
    image = np.arange(6.0).reshape(2, 3)
    places = [[0, 0], [2, 1], [1.5, 0.5], [-1e-9, 0], [2.001, 0], [0, 1.1], [np.nan, 0]]
    np.testing.assert_allclose(sample(image, np.array(places)), [0, 5, 3, np.nan, np.nan, np.nan, np.nan])


def test_uint8_and_floats_are_the_same():
    image = np.random.default_rng(1).integers(0, 256, (30, 30), dtype=np.uint8)
    for pixel in ((15, 14), (15.25, 14.75)):
        np.testing.assert_array_equal(cut(image, pixel, 9), cut(image.astype(float), pixel, 9))
    for compare in COMPARE:  # no overflow
        assert compare(image, image.T) == compare(image.astype(float), image.T.astype(float))


def test_a_patch_cannot_be_changed_and_is_no_view_of_the_image():
    image = np.ones((9, 9))
    patch = cut(image, (4, 4), 9)
    image[0, 0] = 7
    assert patch.sum() == 81
    with pytest.raises(ValueError, match="read-only"):
        patch[0, 0] = 1


def test_misuse_is_named():
    image = np.zeros((20, 20))
    with pytest.raises(ShapeError, match="3 channels"):
        cut(np.zeros((20, 20, 3)), (10, 10), 9)
    with pytest.raises(ShapeError, match=r"shape \(h, w\)"):
        grey(np.zeros(5), "f")
    with pytest.raises(SlamlibError, match="holds numbers"):
        grey(np.array([["a"]]), "f")
    with pytest.raises(SlamlibError, match="size is odd"):
        cut(image, (10, 10), 10)
    with pytest.raises(NonFiniteError):
        cut(image, (np.nan, 10), 9)
    image[10, 10] = np.nan
    with pytest.raises(NonFiniteError, match="nan or infinity"):
        cut(image, (10, 10), 9)
    for compare in COMPARE:
        with pytest.raises(ShapeError, match="one size"):
            compare(np.zeros((9, 9)), np.zeros((11, 11)))
