"""All textures of a room in one array, so that the samples of one picture are looked up together."""

from collections.abc import Iterator, Sequence

import numpy as np

from slambook.rendering.quads import TexturedQuad
from slambook.rendering.textures import LEVELS
from slamlib.manifolds import Image


class TextureAtlas:
    """The pyramids of the quads' textures; entry i of the tables belongs to quad i, the one behind the last to black.

    A sample's row in the tables of levels is quad * LEVELS + level.
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
