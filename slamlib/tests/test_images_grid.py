"""The grid over the image: which cells hold a landmark, and where a new one may be initialized."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from slamlib.errors import ShapeError, SlamlibError
from slamlib.tests.reference import cases
from slamlib.vision.grid import Grid

sizes = st.tuples(st.integers(20, 700), st.integers(20, 500))
counts = st.tuples(st.integers(3, 12), st.integers(3, 9))


@given(sizes, counts)
def test_the_rectangles_tile_the_image_and_say_what_is_occupied(size, cells):
    grid, (w, h) = Grid(size, cells), size
    seen = np.zeros((h, w), int)
    for cell in np.ndindex(cells[::-1]):
        u0, v0, u1, v1 = grid.rectangle(cell)
        seen[v0:v1, u0:u1] += 1
        corners = [[u0, v0], [u1 - 1, v1 - 1], [u0 - 0.49, v0 - 0.49], [u1 - 0.51, v1 - 0.51]]
        expected = np.zeros(cells[::-1], bool)
        expected[cell] = True
        np.testing.assert_array_equal(grid.occupied(np.array(corners)), expected)
    assert (seen == 1).all()


@given(sizes, counts, st.integers(0, 1000))
def test_a_free_cell_is_usable_and_free_and_they_are_drawn_alike(size, cells, seed):
    grid, rng = Grid(size, cells), np.random.default_rng(seed)
    taken = rng.random(cells[::-1]) < 0.6
    cell = grid.free(taken, rng)
    inner = np.zeros(cells[::-1], bool)
    inner[1:-1, 1:-1] = True
    if cell is None:
        assert taken[inner].all()
    else:
        assert inner[cell]
        assert not taken[cell]
    again = [Grid(size, cells).free(taken, np.random.default_rng(seed)) for _ in range(2)]
    assert again[0] == again[1]


def test_every_free_cell_is_drawn_equally_often():
    grid, rng = Grid((320, 240), (4, 4)), np.random.default_rng(1)
    drawn = [grid.free(np.zeros((4, 4), bool), rng) for _ in range(4000)]
    found, times = np.unique(drawn, axis=0, return_counts=True)
    assert found.tolist() == [[1, 1], [1, 2], [2, 1], [2, 2]]
    assert np.abs(times - 1000).max() < 5 * np.sqrt(1000 * 0.75)


def test_what_is_not_in_the_image_occupies_nothing():
    grid = Grid((320, 240))
    outside = [[-0.51, 10], [319.5, 10], [10, 239.5], [np.nan, 3], [np.inf, 3], [1e300, -1e300]]
    assert not grid.occupied(outside).any()
    assert not grid.occupied(np.zeros((0, 2))).any()
    assert grid.occupied([[-0.5, -0.5]])[0, 0]


def test_the_outer_cells_may_be_used_too():
    grid = Grid((10, 10), (1, 1), skip_outer=False)
    assert grid.usable.all()
    assert grid.free([[False]], np.random.default_rng(0)) == (0, 0)
    assert grid.free([[True]], np.random.default_rng(0)) is None


def test_the_toolbox_finds_the_same_cells():
    for given_, found in cases("appearance", "getCell"):
        grid = Grid(tuple(given_["imSize"].astype(int)), tuple(given_["numCells"].astype(int)))
        # it counts from one, columns first
        cell = tuple(found["cell"].astype(int)[::-1] - 1)
        assert grid.occupied(given_["u"][None])[cell]


@pytest.mark.parametrize(
    ("arguments", "match"),
    [
        (((0, 240),), r"image\[0\] should be above 0"),
        (((320.5, 240),), "a whole number"),
        (((320, 240, 3),), "2 values"),
        (((4, 4), (8, 6)), "ask for fewer"),
        (((320, 240), (2, 6)), "skip_outer=False"),
    ],
)
def test_misuse_is_named(arguments, match):
    with pytest.raises(SlamlibError, match=match):
        Grid(*arguments)


def test_wrong_shapes_are_named():
    grid = Grid((320, 240))
    with pytest.raises(ShapeError, match=r"\(n, 2\)"):
        grid.occupied([[1, 2, 3]])
    with pytest.raises(ShapeError, match=r"\(6, 8\)"):
        grid.free(np.zeros((8, 6)), np.random.default_rng(0))
    with pytest.raises(SlamlibError, match="no cell"):
        grid.rectangle((6, 0))
