"""From space to the sheet: a parallel projection of a box of data."""

from dataclasses import dataclass

import numpy as np

from slambook.figures.paths import Box
from slamlib.manifolds import Array


def view_axes(elevation: float, azimuth: float) -> Array:
    """Rows: the unit vectors to the right, up, and towards the viewer, for angles in degrees."""
    e, a = np.radians([elevation, azimuth])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.stack([right, np.cross(towards, right), towards])


@dataclass(frozen=True)
class Projection:
    """A box of data (3, 2) seen along a direction, in a place of the sheet; scale: points per unit of each axis."""

    limits: Array
    rows: Array
    scale: Array
    middle: Array

    @classmethod
    def of(cls, limits: Array, rows: Array, box: Box, equal: bool) -> "Projection":
        """As large as the place allows; equal: a metre is a metre on each axis."""
        spans = limits[:, 1] - limits[:, 0]
        unit = np.ones(3) if equal else 1 / spans
        reach = np.abs(rows[:2]) @ (unit * spans)
        left, top, right, bottom = box
        factor = min(max(right - left, 1.0) / reach[0], max(bottom - top, 1.0) / reach[1])
        return cls(limits, rows, factor * unit, np.array([(left + right) / 2, (top + bottom) / 2]))

    def points(self, data: Array) -> Array:
        """Places (2, N) on the sheet of data (3, N)."""
        across, up = self.rows[:2] @ self._centred(data)
        return np.stack([self.middle[0] + across, self.middle[1] - up])

    def depth(self, data: Array) -> Array:
        """How near to the viewer (N,) data (3, N) are, in points."""
        return self.rows[2] @ self._centred(data)

    def _centred(self, data: Array) -> Array:
        return self.scale[:, None] * (data - self.limits.mean(axis=1)[:, None])
