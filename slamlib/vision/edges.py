"""A straight edge in a strip of an image, to a fraction of a pixel. Chapter 20."""

from dataclasses import dataclass

import numpy as np

from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.edge_profile import LEAST, STEP, Strip, bent_pixels, line, places
from slamlib.vision.patches import zncc

PROFILE = np.arange(-4, 4.25, STEP)  # [px] across an edge, where its profile is taken
LIMIT = 0.75  # [px]: a point that is farther off the line is of something else
ROUNDS = 5
FLOOR = 0.05  # share of the largest slope below which the ones beside it are of other edges
STRONG = 0.4  # of the median slope: where it is less, some texture stands for the edge, which has ended
GAP = 5  # points that may be missing in a row within one edge


@dataclass(frozen=True, eq=False)
class Edge:
    """A straight edge found in a strip, brighter on its right.

    segment (4,): the part of it that is there, in the image's pixels; ideal (4,): in ideal ones. offsets (2,) [px]:
    across, of the infinite line, at the ends of the strip's segment. support: share of the segment's points that lie on
    it; rms [px] of these about it. slope [1/px]: mean growth of the grey value there. profile (17,): mean grey values
    across it.
    """

    segment: Array
    ideal: Array
    offsets: Array
    support: float
    rms: float
    slope: float
    profile: Array

    def likeness(self, profile: Array) -> float:
        """ZNCC of its profile with another (17,)."""
        return float(zncc(self.profile[None], profile[None]))


def steepest(s: Strip, near: Array, reach: float) -> Array:
    """Where the grey value grows most to the right (n,) [px across], within `reach` of a line (n,); nan: nowhere.

    The slope across a sharp edge, smoothed by a Gaussian, is nearly one: the top of the parabola through three
    logarithms, a pixel apart. Its bias by where the pixels lie is below 0.02 px; a parabola's own is 0.1 px.
    """
    known = np.isfinite(s.slope) & (np.abs(s.across[:, None] - near) <= reach + STEP / 2)
    slope, columns, apart = np.where(known, s.slope, -np.inf), np.arange(len(s.along)), round(1 / STEP)
    top = slope[apart:-apart].argmax(0) + apart
    left, middle, right = (s.slope[top + d, columns] for d in (-apart, 0, apart))
    is_top = (middle > 0) & (middle > left) & (middle > right) & known[top, columns]
    share = np.where(is_top, np.maximum([left, right], FLOOR * middle) / np.where(is_top, middle, 1), 0.5)
    a, b = np.log(share)
    return np.where(is_top, s.across[top] + (a - b) / (2 * (a + b)), np.nan)


def fitted(s: Strip, calibration: Calibration, near: Array, reach: float) -> Edge | None:
    """The straight edge within `reach` [px] of the line with the offsets `near` (2,): weighted least squares.

    Points that lie off the line, of other edges, are left out, and those beyond a gap: an edge ends there.
    """
    share = s.share
    points = steepest(s, line(near, share), reach)
    slope = np.nan_to_num(s.at(np.nan_to_num(s.slope), np.where(np.isfinite(points), points, 0)))
    weights, offsets = np.sqrt(np.maximum(slope, 0)), near
    own = np.isfinite(points) & (share >= 0) & (share <= 1)
    strong = np.isfinite(points) & (slope >= STRONG * np.median(slope[own])) if own.any() else own
    keep = strong
    for limit in np.maximum(LIMIT, reach / 2.0 ** np.arange(ROUNDS)):
        if keep.sum() < LEAST // 2:
            return None
        design = np.stack([1 - share, share], axis=1)[keep] * weights[keep, None]
        offsets = np.linalg.lstsq(design, points[keep] * weights[keep], rcond=None)[0]
        off = np.abs(points - line(offsets, share))
        keep = _longest(strong & (off < limit))
    return _edge(s, calibration, offsets, keep, off) if keep.sum() >= LEAST // 2 else None


def _longest(mask: Mask) -> Mask:
    """The longest part of a mask (n,) without a gap of more than GAP."""
    true = np.flatnonzero(mask)
    if not len(true):
        return mask
    part = max(np.split(true, np.flatnonzero(np.diff(true) > GAP) + 1), key=len)
    found = np.zeros_like(mask)
    found[part] = True
    return found


def _edge(s: Strip, calibration: Calibration, offsets: Array, keep: Mask, off: Array) -> Edge:
    share, inside = s.share, np.isfinite(s.grey).all(0)
    own = inside & (share >= 0) & (share <= 1)
    ends, lie = np.flatnonzero(keep)[[0, -1]], line(offsets, share)
    ideal = places(s.ideal, s.along[ends], lie[ends])
    profile = s.at(s.grey, (lie + PROFILE[:, None]))[:, keep].mean(1)
    return Edge(
        bent_pixels(calibration, ideal).ravel(),
        ideal.ravel(),
        offsets,
        float((keep & own).sum() / max(own.sum(), 1)),
        float(np.sqrt((off[keep] ** 2).mean())),
        float(s.at(s.slope, lie)[keep].mean()),
        profile,
    )
