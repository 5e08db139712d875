"""What surrounds the marks of axes: grid, axes' lines, ticks, labels, title, and the room that they take."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from slambook.figures.axis import SIZE, Ticks
from slambook.figures.canvas import Canvas
from slambook.figures.colors import colors, paint
from slambook.figures.paths import joined, number
from slambook.figures.scales import DataView
from slambook.figures.words import LINE, Lettering, width_of
from slamlib.manifolds import Array

if TYPE_CHECKING:
    from slambook.figures.axes import Axes

TICK, LABEL, TITLE = SIZE, 11.0, 11.5  # sizes of the words, in points
MARK, SMALL_MARK, GAP = 3.5, 2.0, 3.5  # lengths of the ticks, and the gap between a tick and its label
BETWEEN, ABOVE = 3.0, 5.0  # points from the tick labels to the axis's label, and from the axes to the title
HIGH = 1.1  # height of a label, in sizes of its font


def ticks(axes: Axes, view: DataView) -> tuple[Ticks, Ticks]:
    """The ticks of x and y."""
    left, top, right, bottom = view.box
    return axes.x.ticks(view.xlim, right - left, across=True), axes.y.ticks(view.ylim, bottom - top, across=False)


def room(axes: Axes, view: DataView) -> Array:
    """Points that the words need to the left, above, to the right and below the axes' rectangle."""
    title = (LINE * TITLE * (1 + axes.title.count("\n")) + ABOVE) if axes.title else 0.0
    if not axes.framed:
        return np.array([0.0, title, 0.0, 0.0])
    across, up = ticks(axes, view)
    left, top, right, _ = view.box
    wide = max((width_of(name, TICK) for name in up.labels), default=0.0)
    x = view.points(across.places, np.full(len(across.places), view.ylim[0]))[0]
    y = view.points(np.full(len(up.places), view.xlim[0]), up.places)[1]
    over = [place + width_of(name, TICK) / 2 - right for place, name in zip(x, across.labels, strict=True)]
    under = [left - place + width_of(name, TICK) / 2 for place, name in zip(x, across.labels, strict=True)]
    high = [top - place + 0.6 * TICK for place in y]
    low = MARK + GAP + HIGH * TICK * bool(any(across.labels)) + _label_room(axes.x.label)
    side = MARK + GAP * bool(wide) + wide + _label_room(axes.y.label)
    return np.array([max([side, *under]), max([title, *high]), max([1.0, *over]), low])


def _label_room(label: str) -> float:
    return HIGH * LABEL * (1 + label.count("\n")) + BETWEEN if label else 0.0


def draw_grid(axes: Axes, canvas: Canvas, view: DataView) -> None:
    """Faint lines at the ticks."""
    if not (axes.ruled and axes.framed):
        return
    left, bottom = _hundredths(view.box[0]), _hundredths(view.box[3])
    x, y = _places(axes, view)
    data = "".join(f"M{joined((v, bottom))}V{number(view.box[1])}" for v in x)
    data += "".join(f"M{joined((left, v))}H{number(view.box[2])}" for v in y)
    canvas.path(data, f"stroke:{paint(colors.faint)};stroke-width:.8;stroke-opacity:.35")


def _places(axes: Axes, view: DataView) -> tuple[list[int], list[int]]:
    across, up = ticks(axes, view)
    x = view.points(across.places, np.full(len(across.places), view.ylim[0]))[0]
    y = view.points(np.full(len(up.places), view.xlim[0]), up.places)[1]
    return [_hundredths(v) for v in x], [_hundredths(v) for v in y]


def _hundredths(value: float) -> int:
    return int(np.floor(round(float(value) * 100, 4) + 0.5))


def draw_frame(axes: Axes, canvas: Canvas, view: DataView) -> None:
    """The lines of both axes with their ticks and words, and the title."""
    left, top, right, bottom = view.box
    if axes.framed:
        corners = [(left, top), (left, bottom), (right, bottom)]
        data = "M" + "L".join(joined(map(_hundredths, corner)) for corner in corners)
        canvas.path(data, f"stroke:{paint(colors.faint)};stroke-width:.8;stroke-linecap:square")
        _draw_ticks(axes, canvas, view)
        _draw_labels(axes, canvas, view)
    canvas.text((left + right) / 2, top - ABOVE, axes.title, Lettering(TITLE, ha="center", va="bottom"))


def _draw_ticks(axes: Axes, canvas: Canvas, view: DataView) -> None:
    left, _, _, bottom = view.box
    x, y = _places(axes, view)
    data = "".join(f"M{joined((v, _hundredths(bottom)))}v{number(MARK)}" for v in x)
    data += "".join(f"M{joined((_hundredths(left), v))}h{number(-MARK)}" for v in y)
    across, up = ticks(axes, view)
    small_x = view.points(across.minor, np.full(len(across.minor), view.ylim[0]))[0]
    small_y = view.points(np.full(len(up.minor), view.xlim[0]), up.minor)[1]
    data += "".join(f"M{joined((_hundredths(v), _hundredths(bottom)))}v{number(SMALL_MARK)}" for v in small_x)
    data += "".join(f"M{joined((_hundredths(left), _hundredths(v)))}h{number(-SMALL_MARK)}" for v in small_y)
    canvas.path(data, f"stroke:{paint(colors.text)};stroke-width:.8")
    below, beside = Lettering(TICK, ha="center", va="top"), Lettering(TICK, ha="right", va="center")
    with canvas.group(below.css()):
        for place, name in zip(x, across.labels, strict=True):
            canvas.text(place / 100, bottom + MARK + GAP, name, below, bare=True)
    with canvas.group(beside.css()):
        for place, name in zip(y, up.labels, strict=True):
            canvas.text(left - MARK - GAP, place / 100, name, beside, bare=True)


def _draw_labels(axes: Axes, canvas: Canvas, view: DataView) -> None:
    left, top, right, bottom = view.box
    across, up = ticks(axes, view)
    below = MARK + GAP + HIGH * TICK * bool(any(across.labels)) + BETWEEN
    canvas.text((left + right) / 2, bottom + below, axes.x.label, Lettering(LABEL, ha="center", va="top"))
    wide = max((width_of(name, TICK) for name in up.labels), default=0.0)
    beside = left - MARK - GAP - wide - BETWEEN
    canvas.text(beside, (top + bottom) / 2, axes.y.label, Lettering(LABEL, ha="center", va="bottom", turned=90))
