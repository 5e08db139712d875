"""Strips of an image along a straight edge, and the edge in them to a fraction of a pixel. Chapter 20.

A lens bends straight edges. So a strip is sampled where the edge would be without distortion, in ideal pixels, and the
calibration bends the places back: in a strip, straight edges of the world are straight.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.images.patches import sample, zncc
from slamlib.sensors.sensor import Calibration
from slamlib.slam.segments import bent, straight
from slamlib.spaces import Array

STEP = 0.5  # [px] between the samples across
SPACING, LEAST, MOST = 1.0, 9, 65  # [px] between the samples along, and how many there are
WIDE = 2  # steps to either side over which a slope is taken
PROFILE = np.arange(-4, 4.25, STEP)  # [px] across an edge, where its profile is taken
LIMIT = 0.75  # [px]: a point that is farther off the line is of something else
ROUNDS = 5
GAP = 5  # points that may be missing in a row within one edge


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
        """How the grey value grows to the right (k, n) [1/px], over two pixels; nan where that is not known."""
        found = np.full_like(self.grey, np.nan)
        found[WIDE:-WIDE] = (self.grey[2 * WIDE :] - self.grey[: -2 * WIDE]) / (2 * WIDE * STEP)
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
    flat = ideal.reshape(-1, 2)
    pairs = np.concatenate([flat, flat[: len(flat) % 2]]).reshape(-1, 4)
    return bent(calibration, pairs).reshape(-1, 2)[: len(flat)].reshape(ideal.shape)


def strip(image: Array, calibration: Calibration, segment: Array, half: float, beyond: float = 0.0) -> Strip:
    """The image `half` [px] to either side of a segment (4,) of its pixels, and `beyond` [px] longer at both ends."""
    if np.shape(segment) != (4,) or not np.isfinite(segment).all():
        raise SlamlibError(f"strip: a segment is four pixel coordinates (u, v, u, v), got {segment}")
    ideal = straight(calibration, np.asarray(segment, dtype=float))[0]
    length = float(np.hypot(*(ideal[2:] - ideal[:2])))
    if length == 0:
        raise SlamlibError("strip: both ends of the segment are the same pixel, so it has no direction")
    count = int(np.clip(round((length + 2 * beyond) / SPACING) + 1, LEAST, MOST))
    along, reach = np.linspace(-beyond, length + beyond, count), int(np.ceil(half / STEP)) + WIDE
    across = np.arange(-reach, reach + 1) * STEP
    pixels = bent_pixels(calibration, places(ideal, *np.meshgrid(along, across)))
    return Strip(ideal, along, across, sample(image, pixels))


@dataclass(frozen=True, eq=False)
class Edge:
    """A straight edge found in a strip, brighter on its right.

    segment (4,): the part of it that is there, in the image's pixels. offsets (2,) [px]: across, of the infinite line,
    at the ends of the strip's segment. support: share of the segment's points that lie on it; rms [px] of these about
    it. slope [1/px]: mean growth of the grey value there. profile (17,): mean grey values across it.
    """

    segment: Array
    offsets: Array
    support: float
    rms: float
    slope: float
    profile: Array

    def likeness(self, profile: Array) -> float:
        """ZNCC of its profile with another (17,)."""
        return float(zncc(self.profile[None], profile[None]))


def steepest(s: Strip, near: Array, reach: float) -> Array:
    """Where the grey value grows most to the right (n,) [px across], within `reach` of a line (n,); nan: nowhere."""
    known = np.isfinite(s.slope) & (np.abs(s.across[:, None] - near) <= reach + STEP / 2)
    slope, columns = np.where(known, s.slope, -np.inf), np.arange(len(s.along))
    top = slope[1:-1].argmax(0) + 1
    left, middle, right = (s.slope[top + d, columns] for d in (-1, 0, 1))
    bend = left - 2 * middle + right
    is_top = (bend < 0) & (middle > 0) & (middle >= np.maximum(left, right)) & known[top, columns]
    shift = np.where(is_top, (left - right) / np.where(is_top, 2 * bend, 1), np.nan)
    found: Array = s.across[top] + shift * STEP
    return found


def fitted(s: Strip, calibration: Calibration, near: Array, reach: float) -> Edge | None:
    """The straight edge within `reach` [px] of the line with the offsets `near` (2,): weighted least squares.

    Points that lie off the line, of other edges, are left out, and those beyond a gap: an edge ends there.
    """
    share = s.share
    points = steepest(s, line(near, share), reach)
    slope = np.nan_to_num(s.at(np.nan_to_num(s.slope), np.where(np.isfinite(points), points, 0)))
    weights, keep, offsets = np.sqrt(np.maximum(slope, 0)), np.isfinite(points), near
    for limit in np.maximum(LIMIT, reach / 2.0 ** np.arange(ROUNDS)):
        if keep.sum() < LEAST // 2:
            return None
        design = np.stack([1 - share, share], axis=1)[keep] * weights[keep, None]
        offsets = np.linalg.lstsq(design, points[keep] * weights[keep], rcond=None)[0]
        off = np.abs(points - line(offsets, share))
        keep = _longest(off < limit)
    return _edge(s, calibration, offsets, keep, off) if keep.sum() >= LEAST // 2 else None


def _longest(mask: Array) -> Array:
    """The longest part of a mask (n,) without a gap of more than GAP."""
    true = np.flatnonzero(mask)
    if not len(true):
        return mask
    part = max(np.split(true, np.flatnonzero(np.diff(true) > GAP) + 1), key=len)
    found = np.zeros_like(mask)
    found[part] = True
    return found


def _edge(s: Strip, calibration: Calibration, offsets: Array, keep: Array, off: Array) -> Edge:
    share, inside = s.share, np.isfinite(s.grey).all(0)
    own = inside & (share >= 0) & (share <= 1)
    ends, lie = np.flatnonzero(keep)[[0, -1]], line(offsets, share)
    pixels = bent_pixels(calibration, places(s.ideal, s.along[ends], lie[ends]))
    profile = s.at(s.grey, (lie + PROFILE[:, None]))[:, keep].mean(1)
    return Edge(
        pixels.ravel(),
        offsets,
        float((keep & own).sum() / max(own.sum(), 1)),
        float(np.sqrt((off[keep] ** 2).mean())),
        float(s.at(s.slope, lie)[keep].mean()),
        profile,
    )
