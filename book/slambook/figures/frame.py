"""What surrounds the marks of axes: grid, axes' lines, ticks, labels, title, and the room that they take."""

from typing import Protocol

import numpy as np

from slambook.figures.axis import SIZE, Axis, Ticks
from slambook.figures.canvas import Canvas
from slambook.figures.colors import colors, paint
from slambook.figures.paths import hundredths, joined, number, settled
from slambook.figures.scales import DataView
from slambook.figures.words import LINE, Lettering, width_of
from slamlib.manifolds import Array

TICK, LABEL, TITLE = SIZE, 11.0, 11.5  # sizes of the words, in points
MARK, SMALL_MARK, GAP = 3.5, 2.0, 3.5  # lengths of the ticks, and the gap between a tick and its label
BETWEEN, ABOVE = 3.0, 5.0  # points from the tick labels to the axis's label, and from the axes to the title
HIGH = 1.1  # height of a label, in sizes of its font


class Framed(Protocol):
    """Axes, as far as their surroundings are concerned: framed and ruled say whether there is a frame, and a grid."""

    x: Axis
    y: Axis
    title: str
    framed: bool
    ruled: bool


def ticks(axes: Framed, view: DataView) -> tuple[Ticks, Ticks]:
    """The ticks of x and y."""
    left, top, right, bottom = view.box
    return axes.x.ticks(view.xlim, right - left, across=True), axes.y.ticks(view.ylim, bottom - top, across=False)


def room(axes: Framed, view: DataView) -> Array:
    """Points that the words need to the left, above, to the right and below the axes' rectangle."""
    title = (LINE * TITLE * (1 + axes.title.count("\n")) + ABOVE) if axes.title else 0.0
    if not axes.framed:
        return np.array([0.0, title, 0.0, 0.0])
    across, up = ticks(axes, view)
    left, top, right, _ = view.box
    wide = max((width_of(name, TICK) for name in up.labels), default=0.0)
    x, y = view.along(0, across.places), view.along(1, up.places)
    over = [place + width_of(name, TICK) / 2 - right for place, name in zip(x, across.labels, strict=True)]
    under = [left - place + width_of(name, TICK) / 2 for place, name in zip(x, across.labels, strict=True)]
    high = [top - place + 0.6 * TICK for place in y]
    low = MARK + GAP + HIGH * TICK * bool(any(across.labels)) + _label_room(axes.x.label)
    side = MARK + GAP * bool(wide) + wide + _label_room(axes.y.label)
    return np.array([max([side, *under]), max([title, *high]), max([1.0, *over]), low])


def _label_room(label: str) -> float:
    return HIGH * LABEL * (1 + label.count("\n")) + BETWEEN if label else 0.0


def draw_grid(axes: Framed, canvas: Canvas, view: DataView) -> None:
    """Faint lines at the ticks."""
    if not (axes.ruled and axes.framed):
        return
    across, up = ticks(axes, view)
    left, top, right, bottom = view.box
    data = _strokes(view, 0, across.places, bottom, f"V{number(top)}")
    data += _strokes(view, 1, up.places, left, f"H{number(right)}")
    canvas.path(data, f"stroke:{paint(colors.faint)};stroke-width:.8;stroke-opacity:.35")


def _strokes(view: DataView, axis: int, values: Array, start: float, stroke: str) -> str:
    """Path data: at each number of an axis a stroke that starts from a line across it."""
    foot = int(hundredths(start))
    places = hundredths(view.along(axis, values)).tolist()
    return "".join(f"M{joined((foot, place) if axis else (place, foot))}{stroke}" for place in places)


def draw_frame(axes: Framed, canvas: Canvas, view: DataView) -> None:
    """The lines of both axes with their ticks and words, and the title."""
    left, top, right, bottom = view.box
    if axes.framed:
        corners = [(left, top), (left, bottom), (right, bottom)]
        data = "M" + "L".join(joined(hundredths(np.array(corner)).tolist()) for corner in corners)
        canvas.path(data, f"stroke:{paint(colors.faint)};stroke-width:.8;stroke-linecap:square")
        across, up = ticks(axes, view)
        data = _strokes(view, 0, across.places, bottom, f"v{number(MARK)}")
        data += _strokes(view, 1, up.places, left, f"h{number(-MARK)}")
        data += _strokes(view, 0, across.minor, bottom, f"v{number(SMALL_MARK)}")
        data += _strokes(view, 1, up.minor, left, f"h{number(-SMALL_MARK)}")
        canvas.path(data, f"stroke:{paint(colors.text)};stroke-width:.8")
        below, beside = Lettering(TICK, ha="center", va="top"), Lettering(TICK, ha="right", va="center")
        with canvas.group(below.css()):
            for place, name in zip(settled(view.along(0, across.places)), across.labels, strict=True):
                canvas.text(place, bottom + MARK + GAP, name, below, bare=True)
        with canvas.group(beside.css()):
            for place, name in zip(settled(view.along(1, up.places)), up.labels, strict=True):
                canvas.text(left - MARK - GAP, place, name, beside, bare=True)
        under = bottom + (MARK + GAP + HIGH * TICK * bool(any(across.labels)) + BETWEEN)
        canvas.text((left + right) / 2, under, axes.x.label, Lettering(LABEL, ha="center", va="top"))
        wide = max((width_of(name, TICK) for name in up.labels), default=0.0)
        look = Lettering(LABEL, ha="center", va="bottom", turned=90)
        canvas.text(left - MARK - GAP - wide - BETWEEN, (top + bottom) / 2, axes.y.label, look)
    canvas.text((left + right) / 2, top - ABOVE, axes.title, Lettering(TITLE, ha="center", va="bottom"))
