"""Pictures of a room by ray casting: the nearest quad on each ray, and its texture there.

With c, e and f the corner and the edges of a quad in the camera's frame, the ray d meets its plane where
t d = c + u e + v f, so that (u, v, 1) / t = inv([e f c]) d: three linear functions of the ray. The third is the inverse
distance, the largest of which is what is seen; u and v lie between 0 and 1 where the first two lie between 0 and it.
"""

import functools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from slambook.rendering.quads import Room, TexturedQuad
from slambook.rendering.rays import Tiles, rays, tiles
from slambook.rendering.textures import LEVELS
from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array, Image, Indices, Mask, finite
from slamlib.sensors.sensor import Calibration

CHUNK = 1 << 15  # samples that are shaded at a time: their numbers stay in the processor's cache
FLAT = 1e-9  # [m]: a quad whose plane is nearer to the eye than this is seen from its edge, that is, not
BIAS = -0.5  # levels: how much finer than a sample its texels are; as near to 64 samples a pixel as 4 come


class TextureAtlas:
    """All textures of a room in one array, so that the samples of one picture are looked up together.

    They are the pyramids of the quads' textures; entry i of the tables belongs to quad i, the one behind the last to
    black. A sample's row in the tables of levels is quad * LEVELS + level.
    """

    def __init__(self, quads: Sequence[TexturedQuad]) -> None:
        textures = list({id(q.texture): q.texture for q in quads}.values())
        black = np.zeros((2, 2), np.float32)
        pyramids = [t.levels for t in textures] + [(black,)]
        flat = [level.ravel() for pyramid in pyramids for level in pyramid]
        self.texels = np.concatenate(flat).astype(np.float32)
        starts: Iterator[int] = iter(np.cumsum([0, *map(len, flat)])[:-1].tolist())
        rows = [_table(pyramid, starts) for pyramid in pyramids]
        which = [textures.index(q.texture) for q in quads] + [len(textures)]
        self.starts = np.concatenate([rows[i][0] for i in which])
        self.widths = np.concatenate([rows[i][1] for i in which])
        self.heights = np.concatenate([rows[i][2] for i in which])
        self.top = np.array([len(pyramids[i]) - 1 for i in which], np.float32)
        self.light = np.array([*(q.light for q in quads), 0], np.float32)
        self.size = np.array([q.texture.image.shape[::-1] for q in quads], float)  # (q, 2): columns, rows
        self.scale = np.tile(np.float32(0.5) ** np.arange(LEVELS, dtype=np.float32), len(which))

    def look_up(self, quad: Image, level: Image, x: Image, y: Image) -> Image:
        """Bilinear grey values (...) at places x, y [texels of level 0, from the corner], in levels of quads."""
        row = quad * np.int32(LEVELS) + level
        scale, width = self.scale.take(row), self.widths.take(row)
        x, left = _cell(x * scale, width)
        y, top = _cell(y * scale, self.heights.take(row))
        first = self.starts.take(row) + top * width + left
        a, b = self.texels.take(first), self.texels.take(first + 1)
        first += width
        c, d = self.texels.take(first), self.texels.take(first + 1)
        upper = a + x * (b - a)
        return (upper + y * (c + x * (d - c) - upper)) * self.light.take(quad)


def _cell(place: Image, size: Image) -> tuple[Image, Image]:
    """Shares (...) between a texel's centre and the next one's, and the texels' numbers; held at the borders."""
    place = place - np.float32(0.5)
    np.maximum(place, 0, out=place)
    low = np.minimum(place.astype(np.int32), size - np.int32(2))
    place -= low
    return np.minimum(place, 1, out=place), low


def _table(pyramid: tuple[Image, ...], starts: Iterator[int]) -> tuple[Image, Image, Image]:
    """First texel, width and height of each level; above the last one, the last one's."""
    begin = [next(starts) for _ in pyramid]
    count = [min(i, len(pyramid) - 1) for i in range(LEVELS)]
    rows = [(begin[i], pyramid[i].shape[1], pyramid[i].shape[0]) for i in count]
    return tuple(np.array(column, np.int32) for column in zip(*rows, strict=True))  # type: ignore[return-value]


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture: image (h, w), grey values 0 to 255; depth (h, w), distance [m] along the ray through each pixel's
    centre, inf where nothing is; surface (h, w), the number of the quad there, or -1.
    """

    image: Image
    renderer: "Renderer"
    camera: Array

    @functools.cached_property
    def _centres(self) -> tuple[Array, Indices]:
        height, width = self.image.shape
        u, v = np.meshgrid(np.arange(width), np.arange(height))
        distance, surface = self.renderer.cast(self.camera, np.stack([u, v], -1).reshape(-1, 2))
        return distance.reshape(u.shape), surface.reshape(u.shape)

    @property
    def depth(self) -> Array:
        return self._centres[0]

    @property
    def surface(self) -> Indices:
        return self._centres[1]


class Renderer:
    """What a calibrated camera sees of a room; it keeps the rays and the textures. samples: per pixel, s x s."""

    def __init__(self, room: Room, calibration: Calibration, samples: int = 2) -> None:
        if not isinstance(samples, int) or samples < 1:
            raise SlamlibError(f"Renderer: samples is a whole number, 1 or more, got {samples}")
        self.room, self.calibration, self.samples = room, calibration, samples
        self.tiles: Tiles = tiles(calibration, samples)
        self.atlas = TextureAtlas(room.quads)
        self.corners = np.stack([q.corners for q in room.quads])
        sides = np.array([[np.linalg.norm(q.edge_u), np.linalg.norm(q.edge_v)] for q in room.quads])
        self.texel = np.sqrt((sides / self.atlas.size).prod(1))  # [m], across

    def render(self, camera: Array) -> Rendered:
        """The picture from a pose (7,) of the camera in the world."""
        camera = finite(camera, (7,), "render", "camera")
        inverse, usable = self._inverses(camera)
        near, u, v, quad = self._nearest(inverse, usable, camera)
        height = 1 / np.linalg.norm(inverse[:, 2], axis=-1)
        levels = np.append(-np.log2(self.texel) - np.log2(height) / 2 + BIAS, 0).astype(np.float32)
        shade = np.empty_like(near)
        step = max(1, CHUNK // shade.shape[1])
        for part in (slice(i, i + step) for i in range(0, len(shade), step)):
            shade[part] = self._shade(near[part], u[part], v[part], quad[part], self.tiles.fineness[part], levels)
        return Rendered(self.tiles.image(shade), self, camera)

    def cast(self, camera: Array, pixels: ArrayLike) -> tuple[Array, Indices]:
        """Distance (n,) [m] along the rays of pixels (n, 2), inf where nothing is, and the quads (n,) there, or -1."""
        inverse, usable = self._inverses(finite(camera, (7,), "cast", "camera"))
        directions = rays(self.calibration, np.asarray(pixels, float))
        near, surface = np.zeros(len(directions)), np.full(len(directions), -1)
        for i in np.flatnonzero(usable):
            a, b, w = inverse[i] @ directions.T
            seen = (a >= 0) & (a <= w) & (b >= 0) & (b <= w) & (w > near)
            near[seen], surface[seen] = w[seen], i
        return np.where(near > 0, 1 / np.where(near > 0, near, 1), np.inf), surface

    def seen(self, camera: Array, pixels: ArrayLike) -> Array:
        """The points (n, 3) of the world [m] that are seen at pixels (n, 2); nan where nothing is."""
        distance, _ = self.cast(camera, pixels)
        directions = rays(self.calibration, np.asarray(pixels, float))
        with np.errstate(invalid="ignore"):
            inside = np.where(np.isinf(distance), np.nan, distance)[:, None] * directions
        return camera[:3] + inside @ rotation(camera[3:]).T

    def _inverses(self, camera: Array) -> tuple[Array, Mask]:
        """For each quad the matrix (q, 3, 3) of the linear functions, and the mask (q,) of those seen from a side."""
        corners = (self.corners - camera[:3]) @ rotation(camera[3:])
        c, e, f = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]
        normal = np.cross(e, f)
        volume = (normal * c).sum(-1)
        usable = np.abs(volume) > FLAT * np.linalg.norm(normal, axis=-1)
        rows = np.stack([np.cross(f, c), np.cross(c, e), normal], 1)
        return rows / np.where(usable, volume, 1)[:, None, None], usable

    def _nearest(self, inverse: Array, usable: Mask, camera: Array) -> tuple[Image, Image, Image, Indices]:
        """Of each sample (t, p): inverse distance, u and v over distance, and the quad; where nothing is, the last."""
        directions = self.tiles.directions
        corners = (self.corners - camera[:3]) @ rotation(camera[3:])
        touched = self.tiles.touched(corners) & usable
        near, u, v = (np.zeros(directions[:, 0].shape, np.float32) for _ in range(3))
        quad = np.full(near.shape, len(inverse), np.int32)
        for i in np.flatnonzero(touched.any(0)):
            where = np.flatnonzero(touched[:, i])
            a, b, w = (inverse[i].astype(np.float32) @ directions[where]).transpose(1, 0, 2)
            before = near[where]
            seen = (a >= 0) & (b >= 0) & (a <= w) & (b <= w) & (w > before)
            near[where] = np.where(seen, w, before)
            u[where], v[where] = np.where(seen, a, u[where]), np.where(seen, b, v[where])
            quad[where] = np.where(seen, np.int32(i), quad[where])
        return near, u, v, quad

    def _shade(self, near: Image, u: Image, v: Image, quad: Indices, fineness: Image, levels: Image) -> Image:
        """Grey values (k, p); levels (q + 1,): what is added to the logarithms of angle and distance for the level.

        Texels are seen from the distance r at an angle: a sample is r * angle wide one way, and longer by r / height
        the other way, height being the eye's above the plane; the geometric mean is angle * r^1.5 / height^0.5. The
        samples of a pixel round to levels at different places, so that their mean passes smoothly from level to level.
        """
        size = np.append(self.atlas.size, [[1, 1]], 0).astype(np.float32)
        with np.errstate(divide="ignore"):
            distance = 1 / np.where(near > 0, near, 1)
        count = self.samples**2
        stagger = ((np.arange(count) + 0.5) / count).repeat(near.shape[1] // count).astype(np.float32)
        level = fineness + stagger + levels.take(quad) + np.float32(1.5) * np.log2(distance)
        level = np.clip(level, 0, self.atlas.top.take(quad)).astype(np.int32)
        x, y = u * distance * size[:, 0].take(quad), v * distance * size[:, 1].take(quad)
        return self.atlas.look_up(quad, level, x, y)


def render(room: Room, calibration: Calibration, camera: Array, *, samples: int = 2) -> Rendered:
    """One picture of a room from a pose (7,); for more of them, keep a Renderer, which keeps the rays."""
    return Renderer(room, calibration, samples).render(camera)
