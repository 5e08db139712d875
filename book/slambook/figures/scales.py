"""How numbers become places along an axis: evenly, or by their logarithm."""

from dataclasses import dataclass

import numpy as np

from slambook.figures import ticks
from slambook.figures.paths import Box
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

MARGIN = 0.05  # of the span, left free on either side of the data


class Linear:
    """Even steps."""

    empty = (0.0, 1.0)  # the limits of axes without data

    def forward(self, values: Array) -> Array:
        """Numbers as even steps along the axis; nan for what it cannot show."""
        return np.asarray(values, dtype=float)

    def backward(self, values: Array) -> Array:
        """The inverse of forward."""
        return np.asarray(values, dtype=float)

    def ticks(self, low: float, high: float, most: int) -> Array:
        """Numbers worth a label."""
        return ticks.nice_ticks(low, high, most)

    def minor(self, low: float, high: float, major: Array) -> Array:
        """Numbers worth a small mark."""
        return np.empty(0)

    def labels(self, values: Array) -> list[str]:
        """What the ticks say."""
        return ticks.labels(values)

    def limits(self, low: float, high: float) -> None:
        """Raises SlamlibError if an axis cannot span this."""


class Log(Linear):
    """Even factors; only positive numbers have a place."""

    empty = (1.0, 10.0)

    def forward(self, values: Array) -> Array:
        values = np.asarray(values, dtype=float)
        return np.log10(np.where(values > 0, values, np.nan))

    def backward(self, values: Array) -> Array:
        return 10.0 ** np.asarray(values, dtype=float)

    def ticks(self, low: float, high: float, most: int) -> Array:
        return ticks.decades(low, high, most)

    def minor(self, low: float, high: float, major: Array) -> Array:
        return ticks.minor_decades(low, high, major)

    def labels(self, values: Array) -> list[str]:
        return ticks.decade_labels(values)

    def limits(self, low: float, high: float) -> None:
        if low <= 0 or high <= 0:
            raise SlamlibError(f"a logarithmic axis cannot span {low:g} to {high:g}: both ends must be positive")


SMALLEST = 1e-290  # what differs by less is drawn as equal: the steps of its ticks would be zero in floating point
SCALES: dict[str, Linear] = {"linear": Linear(), "log": Log()}


def spread(low: float, high: float, scale: Linear, tight: tuple[bool, bool] = (False, False)) -> tuple[float, float]:
    """Limits with room around data from low to high; a single number gets room of its own size; nan: no data."""
    if not np.isfinite(low + high):
        return scale.empty
    a, b = (float(v) for v in scale.forward(np.array([low, high])))
    size = max(abs(a), abs(b))
    if b - a <= max(1e-12 * size, SMALLEST):
        half = 0.05 * size if size > SMALLEST else 0.05
        a, b, tight = a - half, b + half, (True, True)
    room = MARGIN * (b - a)
    a, b = a - room * (not tight[0]), b + room * (not tight[1])
    return float(scale.backward(np.array(a))), float(scale.backward(np.array(b)))


@dataclass(frozen=True)
class DataView:
    """Axes in their place: data to points on the sheet."""

    box: Box
    xlim: tuple[float, float]
    ylim: tuple[float, float]
    xscale: Linear
    yscale: Linear

    def points(self, x: Array, y: Array) -> Array:
        """Places (2, N) on the sheet of data x (N,) and y (N,)."""
        left, top, right, bottom = self.box
        across = _along(x, self.xlim, self.xscale, left, right)
        return np.stack(np.broadcast_arrays(across, _along(y, self.ylim, self.yscale, bottom, top)))

    def floored(self, x: Array, y: Array) -> Array:
        """As points; a number that has no place on a logarithmic axis lies below the axis's lower end."""
        places = self.points(x, y)
        for row, values, (a, b) in ((0, x, self.xlim), (1, y, self.ylim)):
            lost = np.isnan(places[row]) & ~np.isnan(np.broadcast_to(values, places[row].shape))
            end = (self.box[0], self.box[2]) if row == 0 else (self.box[3], self.box[1])
            places[row, lost] = end[0] if a < b else end[1]
        return places


def _along(values: Array, limits: tuple[float, float], scale: Linear, start: float, stop: float) -> Array:
    a, b = scale.forward(np.array(limits))
    with np.errstate(over="ignore"):
        share = (scale.forward(values) / 2 - a / 2) / (b / 2 - a / 2)
        return np.clip(start + share * (stop - start), -1e12, 1e12)
