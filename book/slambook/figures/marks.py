"""What axes hold: lines, areas, rules and bands across. Each mark knows its data's bounds and how to draw itself."""

from dataclasses import dataclass

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.colors import Fill, Stroke
from slambook.figures.markers import Marker
from slambook.figures.paths import Box, outline
from slambook.figures.scales import DataView, Scale
from slamlib.manifolds import Array

NOWHERE = np.full((2, 2), np.nan)
FAR = 1000.0  # points: where marks that are not cut at their axes end
Edges = tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(kw_only=True, repr=False)
class Mark:
    """Something in the axes; marks of a higher zorder lie above; clip: it ends where the axes end.

    gid: the name by which a script of the page finds it (slambook.figures.dragging).
    """

    label: str = ""
    zorder: float = 2.0
    clip: bool = True
    gid: str = ""
    tight: Edges = ((), ())  # values of x and of y beyond which the axes need no margin

    def bounds(self, xscale: Scale, yscale: Scale) -> Array:
        """Least and greatest x (first row) and y that the axes should show; nan where it does not matter."""
        return NOWHERE

    def draw(self, canvas: Canvas, view: DataView) -> None:
        """Put it on the sheet."""

    def ink(self, view: DataView) -> Array:
        """Points (2, N) on the sheet that a legend should rather not cover."""
        return np.empty((2, 0))

    def swatch(self, canvas: Canvas, box: Box, scale: float) -> None:
        """Its sample in a legend; scale: size of its marks, in their own."""

    def room(self, view: DataView) -> Array:
        """Points that it needs to the left of the axes, above, to the right and below."""
        return np.zeros(4)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.label!r})"

    def sight(self, view: DataView, spare: float = 15.0) -> Box:
        """The part of the sheet worth drawing to."""
        reach = spare if self.clip else FAR
        left, top, right, bottom = view.box
        return left - reach, top - reach, right + reach, bottom + reach


def beyond(box: Box, other: Box) -> Array:
    """Points by which another box is beyond a box to the left, above, to the right and below."""
    return np.maximum(0, np.array([1, 1, -1, -1]) * (np.array(box) - np.array(other)))


def extent(values: Array, scale: Scale) -> Array:
    """Least and greatest number that the scale can show; nan for none."""
    shown = values[np.isfinite(scale.forward(values))]
    return np.array([shown.min(), shown.max()]) if shown.size else np.array([np.nan, np.nan])


@dataclass(kw_only=True, repr=False)
class Line(Mark):
    """A polyline, with marks at its vertices or without; nan breaks it."""

    x: Array
    y: Array
    stroke: Stroke | None
    marker: Marker | None = None

    def bounds(self, xscale: Scale, yscale: Scale) -> Array:
        return np.array([extent(self.x, xscale), extent(self.y, yscale)])

    def draw(self, canvas: Canvas, view: DataView) -> None:
        points, sight = view.points(self.x, self.y), self.sight(view)
        if self.stroke is not None and self.stroke.seen:
            canvas.path(outline(points, sight, closed=False), self.stroke.css())
        if self.marker is not None:
            low, high = np.reshape(sight[:2], (2, 1)), np.reshape(sight[2:], (2, 1))
            self.marker.draw(canvas, points[:, np.all((points >= low) & (points <= high), axis=0)])

    def ink(self, view: DataView) -> Array:
        points = view.points(self.x, self.y)
        return points if self.stroke is None else dense(points)

    def swatch(self, canvas: Canvas, box: Box, scale: float) -> None:
        line = middle(box)
        if self.stroke is not None and self.stroke.seen:
            canvas.path(outline(line, None, closed=False), self.stroke.css())
        if self.marker is not None:
            self.marker.scaled(scale).draw(canvas, line.mean(axis=1, keepdims=True))


def dense(points: Array, step: float = 4.0, most: int = 200) -> Array:
    """Points along a line (2, N), about a step apart, to tell what it passes."""
    if points.shape[1] < 2:
        return points
    lengths = np.nan_to_num(np.hypot(*np.diff(points, axis=1)))
    count = np.clip(np.ceil(lengths / step), 1, most).astype(int)
    start = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(start)) - np.repeat(np.cumsum(count) - count, count)) / count[start]
    return points[:, start] + share * (points[:, start + 1] - points[:, start])


@dataclass(kw_only=True, repr=False)
class Area(Mark):
    """Closed rings, each (2, N), filled; with `holes`, a ring within a ring is left out."""

    rings: list[Array]
    fill: Fill
    holes: bool = False
    zorder: float = 1.0

    def bounds(self, xscale: Scale, yscale: Scale) -> Array:
        if not self.rings:
            return NOWHERE
        x, y = np.concatenate(self.rings, axis=1)
        return np.array([extent(x, xscale), extent(y, yscale)])

    def draw(self, canvas: Canvas, view: DataView) -> None:
        sight = self.sight(view)
        data = "".join(outline(view.points(ring[0], ring[1], floored=True), sight, closed=True) for ring in self.rings)
        canvas.path(data, self.fill.css() + (";fill-rule:evenodd" if self.holes else ""))

    def ink(self, view: DataView) -> Array:
        return np.concatenate(
            [np.empty((2, 0)), *(dense(view.points(r[0], r[1], floored=True)) for r in self.rings)], axis=1
        )

    def swatch(self, canvas: Canvas, box: Box, scale: float) -> None:
        canvas.rectangle(box, self.fill.css())


@dataclass(kw_only=True, repr=False)
class Across(Mark):
    """A straight line across the axes at a value of x (axis 0) or y (axis 1), or a band between two values.

    reach: from and to, in shares of the axes.
    """

    axis: int
    values: tuple[float, ...]
    look: Stroke | Fill
    reach: tuple[float, float] = (0.0, 1.0)

    def bounds(self, xscale: Scale, yscale: Scale) -> Array:
        found = NOWHERE.copy()
        found[self.axis] = extent(np.array(self.values), (xscale, yscale)[self.axis])
        return found

    def _points(self, view: DataView) -> Array:
        """The ends of the line, or the corners of the band."""
        left, top, right, bottom = view.box
        shares = np.array([*self.reach, *self.reach[::-1]][: 2 * len(self.values)])
        there = view.along(self.axis, np.repeat(self.values, 2), floored=True)
        if self.axis == 0:
            return np.stack([there, bottom + shares * (top - bottom)])
        return np.stack([left + shares * (right - left), there])

    @property
    def banded(self) -> bool:
        """Whether it is a band."""
        return len(self.values) == 2

    def draw(self, canvas: Canvas, view: DataView) -> None:
        canvas.path(outline(self._points(view), self.sight(view), closed=self.banded), self.look.css())

    def ink(self, view: DataView) -> Array:
        return np.empty((2, 0)) if self.banded else dense(self._points(view))

    def swatch(self, canvas: Canvas, box: Box, scale: float) -> None:
        if self.banded:
            canvas.rectangle(box, self.look.css())
        else:
            canvas.path(outline(middle(box), None, closed=False), self.look.css())


def middle(box: Box) -> Array:
    """The ends (2, 2) of a level line through the middle of a box."""
    return np.array([[box[0], box[2]], [(box[1] + box[3]) / 2] * 2])
