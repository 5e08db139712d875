"""Straight edges of the world in an image: detection, direction by the gradient, sub-pixel fit. Chapter monocular.

A lens bends straight edges. So a strip is sampled where the edge would be without distortion, in ideal pixels, and the
calibration distorts the sample positions: in a strip, straight edges of the world are straight.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError
from slamlib.landmarks.segments import length
from slamlib.manifolds import Array, Image, Mask
from slamlib.observation.lines import undistort_segments
from slamlib.sensors.sensor import Calibration
from slamlib.vision.patches import grey, sample, zncc

STEP = 0.5  # [px] between the samples across
SPACING, LEAST, MOST = 1.0, 9, 65  # [px] between the samples along, and their least and greatest number
SMOOTH, WIDE = 0.8, 5  # Gaussian smoothing of a slope: standard deviation [px], and half its width in steps
PROFILE = np.arange(-4, 4.25, STEP)  # [px] across an edge: positions of its profile
LIMIT = 0.75  # [px]: a point farther from the line is an outlier
ROUNDS = 5
FLOOR = 0.05  # share of the largest slope below which neighbouring slopes belong to other edges
STRONG = 0.4  # of the median slope: where it is less, the edge has ended, and the slope is texture
GAP = 5  # points that may be missing in a row within one edge
SIDE = 1.5  # [px] to either side of a segment, where the brightnesses are compared
REACH = 1.5  # [px]: largest error of the detector


@dataclass(frozen=True, eq=False)
class EdgeStrip:
    """Grey values (k, n), nan outside the image, at `across` (k,) and `along` (n,) [px] of a segment `ideal` (4,).

    along is counted from the first endpoint; across to the right of the direction along: towards larger v if u grows.
    """

    ideal: Array
    along: Array
    across: Array
    grey: Array

    @cached_property
    def slope(self) -> Array:
        """Derivative of the grey value to the right (k, n) [1/px], smoothed across; nan at the sides and outside."""
        found, count = np.full_like(self.grey, np.nan), len(self.grey) - 2 * WIDE
        found[WIDE:-WIDE] = sum(w * self.grey[i : i + count] for i, w in enumerate(_DERIVATIVE.tolist()))
        return found

    @property
    def share(self) -> Array:
        """Positions (n,) along, from 0 at the segment's first endpoint to 1 at its second."""
        return self.along / np.hypot(*(self.ideal[2:] - self.ideal[:2]))

    def at(self, values: Array, lines: Array) -> Array:
        """Values (k, n) of the strip along lines (..., n) [px across], linear between the samples."""
        place = np.clip((lines - self.across[0]) / STEP, 0, len(self.across) - 1.001)
        low, columns = place.astype(int), np.arange(len(self.along))
        part = place - low
        return (1 - part) * values[low, columns] + part * values[low + 1, columns]


_AWAY = STEP * np.arange(-WIDE, WIDE + 1)
_DERIVATIVE = _AWAY * np.exp(-(_AWAY**2) / (2 * SMOOTH**2))
_DERIVATIVE /= _AWAY @ _DERIVATIVE  # exact for a ramp


def line(offsets: Array, share: Array) -> Array:
    """Lines (..., n) [px across] with offsets (..., 2) at the endpoints of the segment."""
    return offsets[..., :1] * (1 - share) + offsets[..., 1:] * share


def axes(ideal: Array) -> tuple[Array, Array]:
    """Unit vectors (..., 2) along segments (..., 4), and to their right."""
    along = ideal[..., 2:] - ideal[..., :2]
    forward = along / np.linalg.norm(along, axis=-1, keepdims=True)
    return forward, np.stack([-forward[..., 1], forward[..., 0]], axis=-1)


def places(ideal: Array, along: Array, across: Array) -> Array:
    """Ideal pixels (..., 2) of positions along and across [px] in the strip of a segment (4,)."""
    forward, right = axes(ideal)
    return ideal[:2] + along[..., None] * forward + across[..., None] * right


def distort_pixels(calibration: Calibration, ideal: Array) -> Array:
    """Distorted pixels (..., 2) of ideal pixels (..., 2)."""
    centre, scale = calibration.given["intrinsics"][:2], calibration.given["intrinsics"][2:]
    ahead = np.ones((*ideal.shape[:-1], 2))
    return calibration.project(np.concatenate([(ideal - centre) / scale, ahead], axis=-1))


def edge_strip(image: Image, calibration: Calibration, ideal: Array, half: float, beyond: float = 0.0) -> EdgeStrip:
    """The image `half` [px] to either side of a segment (4,) of ideal pixels, `beyond` [px] past both endpoints."""
    if np.shape(ideal) != (4,) or not np.isfinite(ideal).all():
        raise SlamlibError(f"strip: a segment is four pixel coordinates (u, v, u, v), got {ideal}")
    ideal = np.asarray(ideal, dtype=float)
    length = float(np.hypot(*(ideal[2:] - ideal[:2])))
    if length == 0:
        raise SlamlibError("strip: both endpoints of the segment are the same pixel, so it has no direction")
    count = int(np.clip(round((length + 2 * beyond) / SPACING) + 1, LEAST, MOST))
    along, reach = np.linspace(-beyond, length + beyond, count), int(np.ceil(half / STEP)) + WIDE
    across = np.arange(-reach, reach + 1, dtype=float) * STEP
    pixels = distort_pixels(calibration, places(ideal, *np.meshgrid(along, across)))
    return EdgeStrip(ideal, along, across, sample(image, pixels))


@dataclass(frozen=True, eq=False)
class Edge:
    """A straight edge found in a strip, brighter on its right.

    segment (4,): its visible part, in the image's pixels; ideal (4,): in ideal ones. offsets (2,) [px]: across, of the
    infinite line, at the endpoints of the strip's segment. support: share of the segment's points that lie on it; rms
    [px] of these about it. slope [1/px]: mean derivative of the grey value there. profile (17,): mean grey values
    across it.
    """

    segment: Array
    ideal: Array
    offsets: Array
    support: float
    rms: float
    slope: float
    profile: Array

    def good(self, support: float, straightness: float, slope: float) -> bool:
        """Whether its support, rms [px] and slope [1/px] are within these limits."""
        return self.support >= support and self.rms <= straightness and self.slope >= slope

    def likeness(self, profile: Array) -> float:
        """ZNCC of its profile with another (17,)."""
        return float(zncc(self.profile[None], profile[None]))


def steepest(s: EdgeStrip, near: Array, reach: float) -> Array:
    """Positions (n,) [px across] of the steepest rise to the right within `reach` [px] of a line (n,); nan: none.

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


def fitted(s: EdgeStrip, calibration: Calibration, near: Array, reach: float) -> Edge | None:
    """The straight edge within `reach` [px] of the line with the offsets `near` (2,): weighted least squares.

    Outliers, of other edges, are left out, and points beyond a gap: an edge ends there. None if too few are left.
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
        error = np.abs(points - line(offsets, share))
        keep = _longest(strong & (error < limit))
    if keep.sum() < LEAST // 2:
        return None
    own = np.isfinite(s.grey).all(0) & (share >= 0) & (share <= 1)
    endpoints, lie = np.flatnonzero(keep)[[0, -1]], line(offsets, share)
    ideal = places(s.ideal, s.along[endpoints], lie[endpoints])
    return Edge(
        segment=distort_pixels(calibration, ideal).ravel(),
        ideal=ideal.ravel(),
        offsets=offsets,
        support=float((keep & own).sum() / max(own.sum(), 1)),
        rms=float(np.sqrt((error[keep] ** 2).mean())),
        slope=float(s.at(s.slope, lie)[keep].mean()),
        profile=s.at(s.grey, (lie + PROFILE[:, None]))[:, keep].mean(1),
    )


def _longest(mask: Mask) -> Mask:
    """The longest part of a mask (n,) without a gap of more than GAP."""
    true = np.flatnonzero(mask)
    if not len(true):
        return mask
    part = max(np.split(true, np.flatnonzero(np.diff(true) > GAP) + 1), key=len)
    found = np.zeros_like(mask)
    found[part] = True
    return found


def segments_of(image: Image, minimum_length: float = 20.0) -> Array:
    """Straight segments (n, 4) [px] of an image (h, w), the longest first, each with its brighter side to its right.

    To the right of the direction from the first endpoint to the second: towards larger v if u grows. So an edge and its
    opposite have opposite directions. Found by OpenCV's LSD (von Gioi, Jakubowicz, Morel and Randall, 2010):
    regions of pixels whose gradients agree. Endpoints err by a quarter of a pixel, those of `refined` by hundredths.
    Raises SlamlibError.
    """
    if not (np.isfinite(minimum_length) and minimum_length > 0):
        raise SlamlibError(f"segments_of: minimum_length is above zero [px], got {minimum_length}")
    pixels = np.clip(np.rint(grey(image, "segments_of")), 0, 255).astype(np.uint8)
    detector = opencv("to find straight segments").createLineSegmentDetector()
    found = detector.detect(np.ascontiguousarray(pixels))[0]
    segments = np.zeros((0, 4)) if found is None else np.asarray(found, dtype=float).reshape(-1, 4)
    lengths = length(segments)
    order = np.argsort(-lengths, kind="stable")
    return directed(pixels, segments[order[lengths[order] >= minimum_length]])


def directed(image: Image, segments: Array) -> Array:
    """The same segments (n, 4), reversed where their left side is brighter."""
    endpoints = segments.reshape(-1, 1, 2, 2)
    share = np.linspace(0.1, 0.9, 16)[:, None]
    middle = (1 - share) * endpoints[:, :, 0] + share * endpoints[:, :, 1]
    right = SIDE * axes(segments)[1][:, None]
    rise = np.nan_to_num(sample(image, middle + right) - sample(image, middle - right)).mean(-1)
    return np.where(rise[:, None] < 0, segments[:, [2, 3, 0, 1]], segments)


def refined(image: Image, calibration: Calibration, segment: Array) -> Edge | None:
    """The edge of a segment (4,) of `segments_of`, fitted to the steepest rise of the grey value.

    None where there is no edge that is straight in the world.
    """
    ideal = undistort_segments(calibration, np.asarray(segment, dtype=float))[0]
    return fitted(edge_strip(image, calibration, ideal, REACH + PROFILE[-1]), calibration, np.zeros(2), REACH)
