"""The rays of a calibrated camera, through all samples of its image, in square tiles that can be left out together."""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration

TILE = 16  # pixels across
INWARDS = 0.95  # where no ray reaches this share of a distance from the centre, none reaches farther: lenses are round


def rays(calibration: Calibration, pixels: Array) -> Array:
    """Unit rays (n, 3) in the camera's frame of pixels (n, 2); zeros for those that no ray reaches."""
    found = np.zeros((len(pixels), 3))
    try:
        points = calibration.sensor.back_project(pixels, np.zeros(1), **calibration.given)
    except SingularPointError:  # find the ones without a ray by halves, until none of a half has one
        centre, half = calibration.given["intrinsics"][:2], len(pixels) // 2
        nearest = pixels[np.linalg.norm(pixels - centre, axis=1).argmin()] - centre
        if half and rays(calibration, centre + INWARDS * nearest[None]).any():
            return np.concatenate([rays(calibration, pixels[:half]), rays(calibration, pixels[half:])])
        return found
    seen = calibration.visible(points)
    found[seen] = points[seen, :3]
    return found


@dataclass(frozen=True, eq=False)
class Tiles:
    """All rays of an image, tile by tile: directions (t, 3, p), float32, p samples a tile, all of one kind together.

    Of a tile, the s * s samples of a pixel lie in s * s pictures of TILE x TILE. fineness (t, p): the binary logarithm
    of the angle [rad] from one sample to the next. planes (t, 4, 3), slack (t, 4): all rays d of a tile have
    planes @ d >= slack.
    """

    size: tuple[int, int]
    samples: int
    grid: tuple[int, int]
    directions: Array
    fineness: Array
    planes: Array
    slack: Array

    def touched(self, corners: Array) -> Mask:
        """Mask (t, q) of the tiles in which quads may be seen, of corners (q, 4, 3) in the camera's frame.

        A point q can lie in a tile only if planes @ q >= slack * |q|; the points that fail make a convex set, so that a
        quad whose corners all fail at one plane is not there.
        """
        corners = corners.astype(np.float32)
        heights = np.einsum("tij,qkj->tqik", self.planes, corners, optimize=True)
        reach = np.linalg.norm(corners, axis=-1)
        outside: Mask = (heights < self.slack[:, None, :, None] * reach[None, :, None]).all(-1).any(-1)
        return ~outside

    def image(self, values: Array) -> Array:
        """The means over each pixel's samples of values (t, p), as an image (h, w)."""
        rows, columns = self.grid
        pixels = values.reshape(rows, columns, self.samples**2, TILE, TILE).mean(2)
        height, width = self.size
        return pixels.transpose(0, 2, 1, 3).reshape(rows * TILE, columns * TILE)[:height, :width]


def tiles(calibration: Calibration, samples: int) -> Tiles:
    """The rays through samples x samples places of every pixel. Raises SlamlibError if it has no image."""
    if calibration.image is None or calibration.sensor.size != 2:
        raise SlamlibError(
            f"a {calibration.sensor.name} cannot be rendered: give the setup an image, of a sensor that measures pixels"
        )
    width, height = (round(float(n)) for n in calibration.image)
    grid = -(-height // TILE), -(-width // TILE)
    pixels = _pixels((height, width), grid, samples)
    directions = rays(calibration, pixels.reshape(-1, 2)).reshape(*pixels.shape[:-1], 3)
    flat = directions.reshape(len(pixels), -1, 3)
    planes, slack = _bounds(directions[:, 0], flat)
    return Tiles(
        (height, width),
        samples,
        grid,
        np.ascontiguousarray(flat.transpose(0, 2, 1), np.float32),
        _fineness(directions, samples).reshape(len(pixels), -1).astype(np.float32),
        planes.astype(np.float32),
        slack.astype(np.float32),
    )


def _pixels(size: tuple[int, int], grid: tuple[int, int], samples: int) -> Array:
    """Places (t, s * s, TILE, TILE, 2) of the samples; tiles that reach beyond the image repeat its border.

    A pixel's samples are a grid that is turned a little: no two are in one column or one row, so that edges along the
    image's axes pass through as many shades as others.
    """
    v, u = (np.minimum(np.arange(n * TILE), limit - 1).reshape(n, TILE) for n, limit in zip(grid, size, strict=True))
    i, j = (n.ravel() for n in np.meshgrid(np.arange(samples), np.arange(samples)))
    across = (i + (j + 0.5) / samples) / samples - 0.5  # from the pixel's centre [px]
    down = (j + (samples - i - 0.5) / samples) / samples - 0.5
    shape = (grid[0], grid[1], samples**2, TILE, TILE)
    columns = np.broadcast_to(u[None, :, None, None, :] + across[:, None, None], shape)
    rows = np.broadcast_to(v[:, None, None, :, None] + down[:, None, None], shape)
    return np.stack([columns, rows], -1).reshape(-1, samples**2, TILE, TILE, 2)


def _fineness(directions: Array, samples: int) -> Array:
    """The logarithm of the root of the solid angle of each sample (t, s * s, TILE, TILE)."""
    down, right = (np.gradient(directions, axis=axis) for axis in (2, 3))
    area = np.linalg.norm(np.cross(down, right), axis=-1)
    usual = np.median(area[area > 0]) if (area > 0).any() else 1.0
    return np.log2(np.where(area > 0, area, usual)) / 2 - np.log2(samples)


def _bounds(grids: Array, flat: Array) -> tuple[Array, Array]:
    """Planes (t, 4, 3) through the eye and the sides of each tile, and the least products (t, 4) with its rays.

    The slack covers what bulges over a side that distortion bends. A tile with rays missing is bounded by nothing.
    """
    corners = grids[:, [0, 0, -1, -1], [0, -1, -1, 0]]
    planes = np.cross(corners, np.roll(corners, -1, 1))
    length = np.linalg.norm(planes, axis=-1, keepdims=True)
    planes = planes / np.where(length > 0, length, 1)
    planes *= np.sign((planes * flat.mean(1)[:, None]).sum(-1, keepdims=True))
    planes[~(flat != 0).any(-1).all(-1)] = 0
    slack = (flat @ planes.transpose(0, 2, 1)).min(1)
    return planes, np.minimum(slack, 0) - 1e-5
