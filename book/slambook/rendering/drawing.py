"""Textures that are drawn: polygons, blobs and strokes of many sizes over a cloudy ground, nothing of it periodic.

They need NumPy alone. Grey values are whole numbers, so that a seed gives the same picture on any machine.
"""

import numpy as np

from slambook.rendering.textures import Texture
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image


def poster(rng: np.random.Generator, shape: tuple[int, int] = (384, 384), shapes: int = 260) -> Texture:
    """Shapes of all sizes, in strong contrast: corners at every distance. shape (h, w) [texels]."""
    image = 128 + 45 * clouds(rng, shape, 4)
    return _drawn(image, rng, shapes, largest=0.25, contrast=1.0)


def plaster(rng: np.random.Generator, shape: tuple[int, int] = (512, 512), shapes: int = 240) -> Texture:
    """A wall: pale, cloudy, with a fine grain and some small marks; poor in texture, but not without."""
    image = 165 + 14 * clouds(rng, shape, 6) + 5 * rng.standard_normal(shape)
    return _drawn(image, rng, shapes, largest=0.05, contrast=0.4)


def terrazzo(rng: np.random.Generator, shape: tuple[int, int] = (768, 768), shapes: int = 1500) -> Texture:
    """A floor of broken stones."""
    image = 95 + 12 * clouds(rng, shape, 5) + 4 * rng.standard_normal(shape)
    return _drawn(image, rng, shapes, largest=0.05, contrast=0.7)


def blank(rng: np.random.Generator, shape: tuple[int, int] = (256, 256), grey: float = 190.0) -> Texture:
    """Nearly nothing to see: paint, a little uneven."""
    return _whole(grey + 5 * clouds(rng, shape, 2) + 1.5 * rng.standard_normal(shape))


def clouds(rng: np.random.Generator, shape: tuple[int, int], octaves: int) -> Array:
    """Smooth noise (h, w) of standard deviation one: grids of random numbers, twice as fine each, half as strong."""
    if octaves < 1 or min(shape) < 2:
        raise SlamlibError(f"clouds: one octave or more on 2 x 2 texels or more, got {octaves} on {shape}")
    total = np.zeros(shape)
    for octave in range(octaves):
        cells = 2 ** (octave + 1)
        total += _enlarged(rng.standard_normal((cells + 1, cells + 1)), shape) / 2**octave
    return (total - total.mean()) / total.std()


def _enlarged(grid: Array, shape: tuple[int, int]) -> Array:
    """The grid (n, n) over a picture (h, w), with smooth steps between its numbers."""
    for axis, size in enumerate(shape):
        place = np.linspace(0, len(grid) - 1, size) if axis == 0 else np.linspace(0, grid.shape[1] - 1, size)
        low = np.minimum(place.astype(int), grid.shape[axis] - 2)
        share = (place - low) ** 2 * (3 - 2 * (place - low))
        share = share[:, None] if axis == 0 else share
        grid = np.take(grid, low, axis) * (1 - share) + np.take(grid, low + 1, axis) * share
    return grid


def _drawn(image: Image, rng: np.random.Generator, shapes: int, largest: float, contrast: float) -> Texture:
    """The picture with so many shapes, from `largest` (of its smaller side) down to a few texels, large ones first."""
    side = min(image.shape)
    sizes = np.geomspace(largest * side, 4.0, shapes)
    for size in sizes:
        kind = _KINDS[int(rng.integers(len(_KINDS)))]
        center = rng.uniform((0, 0), image.shape)
        grey = 127.5 + contrast * rng.uniform(-127.5, 127.5)
        if contrast < 1:  # the mean of the whole picture, for every shape: half of the time
            grey += (1 - contrast) * (image.mean() - 127.5)
        _stamp(image, center, kind(rng, float(size)), grey)
    return _whole(image)


def _stamp(image: Image, center: Array, planes: Array, grey: float) -> None:
    """Paint a convex shape: the texels whose height above all planes (n, 3: normal and offset) is negative."""
    reach = int(np.ceil(planes[:, 2].max() * 1.5)) + 2
    low = np.maximum(center.astype(int) - reach, 0)
    high = np.minimum(center.astype(int) + reach + 1, image.shape)
    rows, columns = (np.arange(a, b) - c for a, b, c in zip(low, high, center, strict=True))
    above = np.full((len(rows), len(columns)), -np.inf)
    for down, across, offset in planes:  # one by one, in the processor's cache
        np.maximum(above, (down * rows)[:, None] + across * columns - offset, out=above)
    cover = np.clip(0.5 - above, 0, 1)
    part = image[low[0] : high[0], low[1] : high[1]]
    part += cover * (grey - part)


def _planes(angles: Array, offsets: Array) -> Array:
    return np.column_stack([np.sin(angles), np.cos(angles), offsets])


def _polygon(rng: np.random.Generator, size: float) -> Array:
    """Three to six sides."""
    sides = int(rng.integers(3, 7))
    angles = 2 * np.pi * (np.arange(sides) + rng.uniform(-0.3, 0.3, sides)) / sides + rng.uniform(0, 2 * np.pi)
    return _planes(angles, size / 2 * rng.uniform(0.6, 1.0, sides))


def _blob(rng: np.random.Generator, size: float) -> Array:
    """Round: sixteen sides of an ellipse."""
    angles, turn = 2 * np.pi * np.arange(16) / 16, rng.uniform(0, np.pi)
    along, across = size / 2 * rng.uniform(0.5, 1.0, 2)
    return _planes(angles, np.hypot(along * np.cos(angles - turn), across * np.sin(angles - turn)))


def _stroke(rng: np.random.Generator, size: float) -> Array:
    """Long and thin."""
    turn, width = rng.uniform(0, np.pi), max(1.0, size * rng.uniform(0.04, 0.12))
    return _planes(turn + np.pi / 2 * np.arange(4.0), np.array([size, width, size, width]) / 1.5)


_KINDS = (_polygon, _blob, _stroke)


def _whole(image: Image) -> Texture:
    return Texture(np.clip(np.rint(image), 0, 255) + 0.0)  # no minus zero
