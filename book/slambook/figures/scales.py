"""How numbers become places along an axis: evenly, or by their logarithm."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slambook.figures import ticks
from slambook.figures.paths import Box
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

MARGIN = 0.05  # of the span, left free on either side of the data


@dataclass(frozen=True)
class Scale:
    """forward: numbers as even steps along the axis, nan for what has no place; backward: its inverse.

    ticks (low, high, most): numbers worth a label; minor (low, high, ticks): those worth a small mark; labels: what
    ticks say; empty: the limits of axes without data; positive: whether both ends of an axis must be.
    """

    forward: Callable[[Array], Array]
    backward: Callable[[Array], Array]
    ticks: Callable[[float, float, int], Array]
    minor: Callable[[float, float, Array], Array]
    labels: Callable[[Array], list[str]]
    empty: tuple[float, float]
    positive: bool


def _floats(values: Array) -> Array:
    return np.asarray(values, dtype=float)


def _logarithms(values: Array) -> Array:
    values = _floats(values)
    return np.log10(np.where(values > 0, values, np.nan))


SMALLEST = 1e-290  # what differs by less is drawn as equal: the steps of its ticks would be zero in floating point
SCALES = {
    "linear": Scale(_floats, _floats, ticks.nice_ticks, lambda *_: np.empty(0), ticks.labels, (0.0, 1.0), False),
    "log": Scale(
        forward=_logarithms,
        backward=lambda values: 10.0 ** _floats(values),
        ticks=ticks.decades,
        minor=ticks.minor_decades,
        labels=ticks.decade_labels,
        empty=(1.0, 10.0),
        positive=True,
    ),
}


def spread(low: float, high: float, scale: Scale, tight: tuple[bool, bool] = (False, False)) -> tuple[float, float]:
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
    """Axes in their position: data to points on the sheet."""

    box: Box
    xlim: tuple[float, float]
    ylim: tuple[float, float]
    xscale: Scale
    yscale: Scale

    def written(self) -> str:
        """For a script: left, top, right, bottom on the sheet, and the numbers there: x and y, from lower left."""
        if not self.xscale is self.yscale is SCALES["linear"]:
            raise SlamlibError("a mark with a gid can be moved by a script along linear axes alone")
        return " ".join(f"{v:.9g}" for v in (*self.box, *self.xlim, *self.ylim))

    def along(self, axis: int, values: Array, floored: bool = False) -> Array:
        """Places (N,) on the sheet of numbers (N,) of x (axis 0) or y (1).

        floored: a number that has no place on a logarithmic axis lies below the axis's lower end.
        """
        left, top, right, bottom = self.box
        limits, scale = ((self.xlim, self.xscale), (self.ylim, self.yscale))[axis]
        start, stop = ((left, right), (bottom, top))[axis]
        a, b = scale.forward(np.array(limits))
        with np.errstate(over="ignore"):
            share = (scale.forward(values) / 2 - a / 2) / (b / 2 - a / 2)
            places = np.clip(start + share * (stop - start), -1e12, 1e12)
        if not floored:
            return places
        return np.where(np.isnan(places) & ~np.isnan(values), start if limits[0] < limits[1] else stop, places)

    def points(self, x: Array, y: Array, floored: bool = False) -> Array:
        """Places (2, N) on the sheet of data x (N,) and y (N,); floored as in along."""
        return np.stack(np.broadcast_arrays(self.along(0, x, floored), self.along(1, y, floored)))
