"""Strips of an image along a straight edge of the world. Chapter 20.

A lens bends straight edges. So a strip is sampled where the edge would be without distortion, in ideal pixels, and the
calibration bends the places back: in a strip, straight edges of the world are straight.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image
from slamlib.sensors.sensor import Calibration
from slamlib.vision.patches import sample

STEP = 0.5  # [px] between the samples across
SPACING, LEAST, MOST = 1.0, 9, 65  # [px] between the samples along, and how many there are
SMOOTH, WIDE = 0.8, 5  # a slope is smoothed by a Gaussian of so many px, cut after so many steps to either side


@dataclass(frozen=True, eq=False)
class Strip:
    """Grey values (k, n), nan outside the image, at `across` (k,) and `along` (n,) [px] of a segment `ideal` (4,).

    along is counted from its first end; across to its right as one goes along: to where v grows if u does.
    """

    ideal: Array
    along: Array
    across: Array
    grey: Array

    @cached_property
    def slope(self) -> Array:
        """How the grey value grows to the right (k, n) [1/px], smoothed across; nan at the sides and outside."""
        found, count = np.full_like(self.grey, np.nan), len(self.grey) - 2 * WIDE
        found[WIDE:-WIDE] = sum(w * self.grey[i : i + count] for i, w in enumerate(_DERIVATIVE.tolist()))
        return found

    @property
    def share(self) -> Array:
        """Places (n,) along from 0 at the segment's first end to 1 at its second."""
        return self.along / np.hypot(*(self.ideal[2:] - self.ideal[:2]))

    def at(self, values: Array, lines: Array) -> Array:
        """Values (k, n) of the strip along lines (..., n) [px across], linear between the samples."""
        place = np.clip((lines - self.across[0]) / STEP, 0, len(self.across) - 1.001)
        low, columns = place.astype(int), np.arange(len(self.along))
        part = place - low
        found: Array = (1 - part) * values[low, columns] + part * values[low + 1, columns]
        return found


_AWAY = STEP * np.arange(-WIDE, WIDE + 1)
_DERIVATIVE = _AWAY * np.exp(-(_AWAY**2) / (2 * SMOOTH**2))
_DERIVATIVE /= _AWAY @ _DERIVATIVE  # a ramp's slope is its own


def line(offsets: Array, share: Array) -> Array:
    """Lines (..., n) [px across] with offsets (..., 2) at the ends of the segment."""
    found: Array = offsets[..., :1] * (1 - share) + offsets[..., 1:] * share
    return found


def axes(ideal: Array) -> tuple[Array, Array]:
    """Unit vectors (..., 2) along segments (..., 4), and to their right."""
    along = ideal[..., 2:] - ideal[..., :2]
    forward = along / np.linalg.norm(along, axis=-1, keepdims=True)
    return forward, np.stack([-forward[..., 1], forward[..., 0]], axis=-1)


def places(ideal: Array, along: Array, across: Array) -> Array:
    """Ideal pixels (..., 2) of places in the strip of a segment (4,)."""
    forward, right = axes(ideal)
    found: Array = ideal[:2] + along[..., None] * forward + across[..., None] * right
    return found


def bent_pixels(calibration: Calibration, ideal: Array) -> Array:
    """Where the lens puts ideal pixels (..., 2)."""
    centre, scale = calibration.given["intrinsics"][:2], calibration.given["intrinsics"][2:]
    ahead = np.ones((*ideal.shape[:-1], 2))
    return calibration.project(np.concatenate([(ideal - centre) / scale, ahead], axis=-1))


def strip(image: Image, calibration: Calibration, ideal: Array, half: float, beyond: float = 0.0) -> Strip:
    """The image `half` [px] to either side of a segment (4,) of ideal pixels, and `beyond` [px] longer at both ends."""
    if np.shape(ideal) != (4,) or not np.isfinite(ideal).all():
        raise SlamlibError(f"strip: a segment is four pixel coordinates (u, v, u, v), got {ideal}")
    ideal = np.asarray(ideal, dtype=float)
    length = float(np.hypot(*(ideal[2:] - ideal[:2])))
    if length == 0:
        raise SlamlibError("strip: both ends of the segment are the same pixel, so it has no direction")
    count = int(np.clip(round((length + 2 * beyond) / SPACING) + 1, LEAST, MOST))
    along, reach = np.linspace(-beyond, length + beyond, count), int(np.ceil(half / STEP)) + WIDE
    across = np.arange(-reach, reach + 1, dtype=float) * STEP
    pixels = bent_pixels(calibration, places(ideal, *np.meshgrid(along, across)))
    return Strip(ideal, along, across, sample(image, pixels))
