"""Textures of rooms: photographs, drawings, and their mip-maps; the rooms that are made of them."""

import sys

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering import drawing

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.tests.rooms import upright

DRAWN = {"poster": drawing.poster, "plaster": drawing.plaster, "terrazzo": drawing.terrazzo, "blank": drawing.blank}
SPREAD = {"poster": (45, 80), "plaster": (12, 35), "terrazzo": (20, 60), "blank": (2, 10)}  # of grey values


@pytest.mark.parametrize("name", DRAWN)
def test_drawings_are_whole_grey_values_and_a_seed_is_one_picture(name):
    one, same, other = (DRAWN[name](np.random.default_rng(seed)).image for seed in (1, 1, 2))
    assert (one == same).all()
    assert (one != other).mean() > 0.4
    assert (one == np.rint(one)).all()
    low, high = SPREAD[name]
    assert low < one.std() < high


@pytest.mark.parametrize("name", ["poster", "terrazzo"])
def test_drawings_do_not_repeat_themselves(name):
    image = DRAWN[name](np.random.default_rng(1)).image[::2, ::2].astype(float)
    image -= image.mean()
    spectrum = np.abs(np.fft.fft2(image, [2 * n for n in image.shape])) ** 2
    likeness = np.fft.ifft2(spectrum).real
    likeness /= likeness[0, 0]
    reach = image.shape[0] // 6
    likeness[:reach, :reach] = likeness[-reach:, :reach] = likeness[:reach, -reach:] = likeness[-reach:, -reach:] = 0
    assert likeness.max() < 0.3


@pytest.mark.parametrize("shape", [(256, 256), (300, 451), (7, 90), (2, 2)])
def test_levels_of_a_pyramid_are_means(shape):
    image = np.random.default_rng(1).uniform(0, 255, shape)
    levels = rendering.Texture(image).levels
    assert np.allclose(levels[0][: shape[0], : shape[1]], image)
    for k, level in enumerate(levels):
        assert min(level.shape) >= 2
        assert np.allclose([s * 2**k for s in level.shape], levels[0].shape)
        assert np.isclose(level[1, 1], levels[0][2**k : 2 ** (k + 1), 2**k : 2 ** (k + 1)].mean(), rtol=1e-4)
    assert len(levels) == {2: 1, 7: 2}.get(shape[0], 6)


def test_what_is_no_texture_is_refused():
    for wrong in (np.zeros((4, 4, 3)), np.zeros((1, 9)), np.full((4, 4), 256), np.full((4, 4), np.nan), "text"):
        with pytest.raises(SlamlibError):
            rendering.Texture(wrong)


def test_photographs_are_grey_pictures():
    pytest.importorskip("skimage")
    for name in rendering.PHOTOGRAPHS:
        image = rendering.photograph(name).image
        assert min(image.shape) >= 150
        assert 10 < image.std() < 90
    with pytest.raises(UnknownNameError, match="did you mean 'coffee'"):
        rendering.photograph("cofee")


def test_without_scikit_image_the_message_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "skimage", None)
    rendering.photograph.cache_clear()
    with pytest.raises(SlamlibError, match=r"slamlib\[images\]"):
        rendering.default_room("photographs", seed=67)  # one that no other test has had drawn
    assert rendering.default_room("drawn").quads


@pytest.mark.parametrize("textures", rendering.ROOM_STYLES)
def test_the_default_room_has_a_world(textures):
    if textures == "photographs":
        pytest.importorskip("skimage")
    room = rendering.default_room(textures)
    assert 40 <= len(room.quads) <= 60
    world = room.world
    assert len(world.faces) == 2 * len(room.quads)
    outlined = [q for q in room.quads if q.outlined]
    assert all(any(np.allclose(c, p) for p in world.points.values) for q in outlined for c in q.corners)
    stops = world.segments.values.reshape(-1, 2, 3)
    assert (np.linalg.norm(stops[:, 0] - stops[:, 1], axis=1) > 0.2).all()
    # 4 boxes of 8 corners and 12 edges, and posters of 4 and 4
    posters = len(outlined) - 4 * 5
    assert (len(world.points), len(world.segments)) == (4 * 8 + 4 * posters, 4 * 12 + 4 * posters)


def test_a_room_of_ones_own_has_its_edges_once():
    texture = rendering.Texture(np.full((4, 4), 100))
    left, right = upright((2, 0.5, 0), 1, 1, texture), upright((2, -0.5, 0), 1, 1, texture)
    world = rendering.Room([left, right]).world
    assert (len(world.points), len(world.segments), len(world.faces)) == (6, 7, 4)
    bare = rendering.Room(
        [rendering.TexturedQuad(left.corner, left.edge_u, left.edge_v, texture, outlined=False)]
    ).world
    assert (len(bare.points), len(bare.segments), len(bare.faces)) == (0, 0, 2)


def test_names_that_are_not_known_are_named():
    with pytest.raises(UnknownNameError, match="drawn, photographs"):
        rendering.default_room("painted")
    with pytest.raises(UnknownNameError, match="sideways"):
        rendering.path("sidewise")
