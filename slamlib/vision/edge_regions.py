"""Where an expected edge may be: lines within an ellipse in the plane of two moves across. Chapter 20."""

from typing import Any

import numpy as np

from slamlib.landmarks.segments import length
from slamlib.manifolds import Array, Mask
from slamlib.observation.lines import bent, straight
from slamlib.vision.edge_profile import STEP, Strip, axes, line

NUDGE = 1e-3  # [px]: to ask how the innovation depends on a move of an end
FLANK = 2.0  # [px]: lines that are nearer to one another are of one edge


def across_covariances(looks: list[Any], sensor: Any) -> Array:
    """Covariances (n, 2, 2) [px^2] of how far across the ends of expected segments are, from those of the innovations.

    An innovation z is linear in small moves a of the ends, z = J a, whatever its reading, so cov(a) = J^-1 Z J^-T.
    """
    found = np.zeros((len(looks), 2, 2))
    for expected in {id(look.expected): look.expected for look in looks}.values():
        rows = [i for i, look in enumerate(looks) if look.expected is expected]
        own, ideal = [looks[i].row for i in rows], straight(sensor.calibration, expected.value)[0]
        right = axes(ideal[own])[1]
        none = np.zeros_like(right)
        moved = [ideal[own] + NUDGE * np.concatenate(m, axis=-1) for m in ((right, none), (none, right))]
        measured = bent(sensor.calibration, np.concatenate(moved))
        z = looks[rows[0]].family.innovate(sensor, expected.take(own + own), measured).z
        inverse = np.linalg.inv(z.reshape(2, len(own), 2).transpose(1, 2, 0) / NUDGE)
        found[rows] = inverse @ np.array([looks[i].Z for i in rows]) @ inverse.swapaxes(-1, -2)
    return found


def side_by_side(one: Array, others: Array, apart: float) -> Mask:
    """Mask (n,) of the ideal segments (n, 4) on the line of one (4,), less than `apart` [px] off, and not only before
    or behind it."""
    forward, right = axes(one)
    ends = others.reshape(-1, 2, 2) - one[:2]
    along, across = ends @ forward, ends @ right
    beside = (along.max(-1) > 0) & (along.min(-1) < length(one))
    return np.asarray(beside & (np.abs(across).max(-1) < apart))


def lines_of(region: Array, limit: float) -> Array:
    """Offsets (n, 2) [px] of lines, STEP apart: all that are the nearest one to some line of a' C^-1 a <= limit.

    region: C (2, 2). A move by r changes the root of a' C^-1 a by at most |r| times the root of C^-1's largest
    eigenvalue; so some more are taken at the tips of a thin ellipse. There is always one.
    """
    half = np.sqrt(limit * np.diag(region)) + STEP / 2
    steps = [STEP * np.arange(-np.floor(h / STEP), np.floor(h / STEP) + 1) for h in half]
    a = np.stack(np.meshgrid(*steps, indexing="ij"), -1).reshape(-1, 2)
    inverse = np.linalg.inv(region)
    root = np.sqrt(np.maximum(np.einsum("ni,ij,nj->n", a, inverse, a), 0))
    found: Array = a[root <= np.sqrt(limit) + STEP / np.sqrt(2) * np.sqrt(np.linalg.eigvalsh(inverse)[-1])]
    return found


def steep_lines(s: Strip, offsets: Array, most: int = 4) -> Array:
    """Of lines with offsets (n, 2), those (k, 2) along which the grey value grows most: local maxima, best first."""
    slope = np.nan_to_num(s.slope)
    index = np.rint((line(offsets, s.share) - s.across[0]) / STEP).astype(int)
    rises = slope[np.clip(index, 0, len(slope) - 1), np.arange(len(s.along))].mean(1)
    found, left = list[Array](), rises.copy()
    while len(found) < most and left.max() > rises.max() / 2 > 0:
        best = offsets[left.argmax()]
        found.append(best)
        left[np.abs(offsets - best).mean(1) < FLANK] = 0
    return np.array(found).reshape(-1, 2)
