"""The renderer of rooms: geometry, depth, occlusion, anti-aliasing."""

import functools
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering import renderer as module
from slambook.rendering.judging import patches, strong_corners, zncc
from slambook.rendering.rays import rays, tiles

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.quaternion import rotation
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.simulation.occlusion import hidden
from slamlib.tests.rooms import camera, fisheye, flat, pinhole, pixels_of, upright

CAMERAS = {
    "pinhole": pinhole(),
    "ideal": pinhole(distortion=(0.0,)),
    "odd size": pinhole((150, 101)),
    "fisheye": fisheye(),
}
POSES = [
    camera((0.8, -0.3, 1.3)),
    camera((0.5, 0.3, 1.3), (0, 10, 60)),
    camera((-2.0, 1.0, 1.6), (20, 25, -30)),
    camera((0.0, 0.0, 1.3), (5, -15, 180)),
]


cached_tiles = functools.cache(tiles)


@pytest.fixture(autouse=True)
def _rays_are_computed_once(monkeypatch):
    monkeypatch.setattr(module, "tiles", cached_tiles)


@pytest.fixture(scope="module")
def room():
    return rendering.default_room("drawn")


def centroid(image):
    """Of the light (2,), and how much there is."""
    total = image.sum(dtype=float)
    v, u = np.indices(image.shape)
    return np.array([(u * image).sum(dtype=float), (v * image).sum(dtype=float)]) / total, total


def polygon(corners):
    """Centroid and area of a polygon (n, 2), by Green's theorem."""
    x, y = (corners - corners[0]).T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    at = [((p + np.roll(p, -1)) * cross).sum() / (3 * cross.sum()) for p in (x, y)]
    return corners[0] + at, abs(cross.sum()) / 2


@pytest.mark.parametrize("name", ["pinhole", "ideal", "fisheye"])
def test_a_square_is_where_the_camera_model_puts_it(name):
    calibration, rng, quad = CAMERAS[name], np.random.default_rng(3), upright((2.0, 0.0, 0.0), 0.4, 0.4, flat(200))
    renderer = rendering.Renderer(rendering.Room([quad]), calibration, samples=6)
    outline = quad.corners + (np.roll(quad.corners, -1, 0) - quad.corners) * np.linspace(0, 1, 20)[:-1, None, None]
    errors = []
    for _ in range(40):
        pose = camera(rng.uniform(-0.4, 0.4, 3), rng.uniform(-10, 10, 3))
        expected, area = polygon(pixels_of(calibration, pose, outline.transpose(1, 0, 2).reshape(-1, 3)))
        found, light = centroid(renderer.render(pose).image)
        errors.append(found - expected)
        assert np.isclose(light / 200, area, rtol=0.02)
    assert np.abs(errors).max() < 0.06  # [px]; measured 0.036: where edges run along the lattice of samples
    assert np.sqrt(np.mean(np.square(errors))) < 0.02  # measured: 0.003 to 0.008
    assert np.abs(np.mean(errors, axis=0)).max() < 0.005  # measured: 0.0012


@pytest.mark.parametrize("name", CAMERAS)
def test_depth_is_where_the_ray_meets_the_plane(room, name):
    calibration = CAMERAS[name]
    for pose in POSES:
        seen = rendering.render(room, calibration, pose, samples=1)
        v, u = np.indices(seen.image.shape)
        directions = rays(calibration, np.stack([u, v], -1).reshape(-1, 2).astype(float)).reshape(*u.shape, 3)
        outside = ~directions.any(-1)
        assert (np.isinf(seen.depth) == outside).all()  # a room is closed
        assert (seen.surface[outside] == -1).all()
        assert (seen.image[outside] == 0).all()
        chosen = np.random.default_rng(1).choice(np.flatnonzero(~outside), 200)
        for at in zip(*np.unravel_index(chosen, u.shape), strict=True):
            assert np.isclose(nearest(room, pose, directions[at]), seen.depth[at], rtol=1e-9)


def nearest(room, pose, direction):
    """Distance along one ray, by solving for the meeting point with each quad."""
    ahead, found = rotation(pose[3:]) @ direction, np.inf
    for quad in room.quads:
        t, u, v = np.linalg.solve(np.column_stack([ahead, -quad.edge_u, -quad.edge_v]), quad.corner - pose[:3])
        if t > 0 and 0 <= u <= 1 and 0 <= v <= 1:
            found = min(found, t)
    return found


def test_points_seen_at_pixels_project_to_them(room):
    calibration, renderer = CAMERAS["pinhole"], rendering.Renderer(room, CAMERAS["pinhole"])
    pixels = np.random.default_rng(1).uniform((0, 0), (159, 119), (300, 2))
    for pose in POSES:
        points = renderer.seen(pose, pixels)
        assert np.allclose(pixels_of(calibration, pose, points), pixels, atol=1e-9)
        assert np.allclose(np.linalg.norm(points - pose[:3], axis=1), renderer.cast(pose, pixels)[0])


def test_nothing_is_seen_beyond_the_lens_and_beside_the_room():
    renderer = rendering.Renderer(rendering.Room([upright((2, 0, 0), 1, 1, flat(200))]), CAMERAS["fisheye"])
    points = renderer.seen(camera((0, 0, 0)), np.array([[80, 60], [0, 0], [30, 60]]))
    assert np.allclose(points[0, 0], 2)
    assert np.isnan(points[1:]).all()
    behind = renderer.render(camera((3, 0, 0)))
    assert (behind.image == 0).all()
    assert np.isinf(behind.depth).all()
    edge_on = renderer.render(camera((2, -3, 0), (0, 0, 90)))
    assert (edge_on.surface == -1).all()


def test_what_the_world_says_is_hidden_is_behind_what_is_seen(room):
    world, calibration, counted = room.world, CAMERAS["pinhole"], 0
    renderer = rendering.Renderer(room, calibration)
    for pose in POSES:
        points = world.points.values + 1e-3 * (pose[:3] - world.points.values)  # a little before their own surfaces
        homogeneous = np.column_stack([(points - pose[:3]) @ rotation(pose[3:]), np.ones(len(points))])
        points = points[calibration.visible(homogeneous)]
        pixels = pixels_of(calibration, pose, points)
        inside = calibration.inside(pixels, 1)
        distance, _ = renderer.cast(pose, pixels[inside])
        behind = distance < np.linalg.norm(points[inside] - pose[:3], axis=1) - 1e-9
        assert (hidden(points[inside], world.faces, pose[:3]) == behind).all()
        counted += len(behind)
    assert counted > 40


@pytest.mark.parametrize("name", CAMERAS)
def test_leaving_tiles_out_changes_nothing(room, name):
    renderer = rendering.Renderer(room, CAMERAS[name])
    before = [renderer.render(pose).image for pose in POSES]
    renderer.tiles = replace(renderer.tiles, planes=0 * renderer.tiles.planes)  # so that no tile is left out
    for pose, image in zip(POSES, before, strict=True):
        assert (renderer.render(pose).image == image).all()


def test_posters_are_before_their_walls_and_textures_upright():
    corner = np.zeros((8, 8))
    corner[:4, :4] = 255  # the upper left quarter is white
    wall, poster = upright((2, 0, 0), 3, 3, flat(50)), upright((1.999, 0, 0), 1, 1, rendering.Texture(corner))
    for order in ([wall, poster], [poster, wall]):
        seen = rendering.render(rendering.Room(order), CAMERAS["ideal"], camera((0, 0, 0)))
        assert np.isclose(seen.image[59 - 10, 79 - 10], 255)
        assert np.isclose([seen.image[59 + y, 79 + x] for x, y in ((12, -10), (-10, 12), (12, 12))], 0).all()
        assert np.isclose(seen.image[5, 5], 50)


CLOSE_UP = Calibration(PINHOLE, np.eye(2), image=(160, 120), intrinsics=[79.5, 59.5, 260, 260], distortion=[-0.1, 0.01])


def against_64_samples(room, poses, monkeypatch):
    """Per pose: ZNCC of strong corners' patches, and rms differences with mip-maps and without [grey values]."""
    quick = rendering.Renderer(room, CLOSE_UP)
    images = [quick.render(pose).image for pose in poses]
    monkeypatch.setattr(module, "BIAS", -100.0)  # the finest level always
    plain = [quick.render(pose).image for pose in poses]
    exact = rendering.Renderer(room, CLOSE_UP, samples=8)
    for pose, image, without in zip(poses, images, plain, strict=True):
        reference = exact.render(pose).image
        corners = strong_corners(reference)
        likeness = zncc(patches(image, corners), patches(reference, corners))
        yield likeness, *(float(np.sqrt(np.mean((i - reference) ** 2))) for i in (image, without))


def test_four_samples_a_pixel_are_like_sixty_four(room, monkeypatch):
    for likeness, error, _ in against_64_samples(room, POSES[:3], monkeypatch):
        assert len(likeness) > 20
        assert np.quantile(likeness, 0.05) > 0.975  # measured: 0.987 to 0.998
        assert error < 3.0  # grey values; measured: 1.1 to 2.2


def test_mipmaps_help_where_texels_are_finer_than_pixels(monkeypatch):
    texture = rendering.Texture(255 * np.random.default_rng(1).integers(2, size=(256, 256)))
    far = rendering.Room([upright((6, 0, 0), 1.0, 1.0, texture)])
    ((likeness, error, without),) = against_64_samples(far, [camera((0, 0, 0))], monkeypatch)
    assert error < 0.7 * without
    assert np.median(likeness) > 0.95  # measured: 0.977


def test_what_cannot_be_rendered_is_refused(room):
    with pytest.raises(SlamlibError, match="give the setup an image"):
        rendering.Renderer(room, Calibration(PINHOLE, np.eye(2), intrinsics=[80, 60, 100, 100], distortion=[0]))
    with pytest.raises(SlamlibError, match="samples"):
        rendering.Renderer(room, CAMERAS["ideal"], samples=0)
    with pytest.raises(SlamlibError, match="at least one quad"):
        rendering.Room([])
    with pytest.raises(SlamlibError, match="span no area"):
        rendering.TexturedQuad([0, 0, 0], [1, 0, 0], [2, 0, 0], flat(1))
    with pytest.raises(SlamlibError, match="light"):
        rendering.TexturedQuad([0, 0, 0], [1, 0, 0], [0, 1, 0], flat(1), light=2)
    with pytest.raises(SlamlibError, match="camera"):
        rendering.render(room, CAMERAS["ideal"], np.zeros(3))


def test_pixels_beyond_a_lens_s_reach_are_found_without_asking_for_each():
    """A fold inside the image: of thousands of pixels without a ray, each was inverted alone, which seemed to hang."""
    asked = []

    def back_project(pixels, unmeasured, **given):
        asked.append(len(pixels))
        if not reached(pixels).all():
            raise SingularPointError("no ray")
        return np.tile([0, 0, 1, 0.0], (len(pixels), 1))

    def reached(pixels):
        """An ellipse: pixels need not be square."""
        return np.hypot(*(pixels - [80, 60]).T * [[1], [0.97]]) < 45

    lens = SimpleNamespace(
        sensor=SimpleNamespace(back_project=back_project),
        given={"intrinsics": np.array([80.0, 60.0, 100, 97])},
        visible=lambda points: np.ones(len(points), dtype=bool),
    )
    pixels = np.stack(np.meshgrid(np.arange(160.0), np.arange(120.0)), axis=-1).reshape(-1, 2)
    np.testing.assert_array_equal(rays(lens, pixels).any(1), reached(pixels))
    assert len(asked) < 0.6 * (~reached(pixels)).sum()  # by halves alone, twice as many
