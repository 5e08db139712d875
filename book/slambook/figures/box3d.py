"""The box around axes in space: its three back faces with grid lines, and ticks along three of its edges."""

import numpy as np

from slambook.figures import ticks
from slambook.figures.canvas import Canvas
from slambook.figures.colors import colors, paint
from slambook.figures.paths import polyline
from slambook.figures.projection import Projection
from slambook.figures.words import Lettering, width_of
from slamlib.manifolds import Array

TICK, LABEL = 10.0, 11.0
FAINT = f"stroke:{paint(colors.faint)};stroke-width:.8"


def draw_box(canvas: Canvas, projection: Projection, labels: list[str]) -> None:
    """Faces that are seen from inside, ticks on the outer edges, labels of the axes."""
    back = _back(projection)
    places = [ticks.nice_ticks(low, high, 5) for low, high in projection.limits]
    grid = "".join(_line(projection, line) for line in _grid(projection.limits, back, places))
    canvas.path(grid, FAINT + ";stroke-opacity:.35")
    canvas.path("".join(_line(projection, e) for e in _edges(projection.limits, back)), FAINT)
    for axis, label in enumerate(labels):
        _draw_axis(canvas, projection, axis, places[axis], label)


def _back(projection: Projection) -> Array:
    """For each axis, the end of the box that is farther from the viewer."""
    return np.where(projection.rows[2] > 0, projection.limits[:, 0], projection.limits[:, 1])


def _front(projection: Projection) -> Array:
    return np.where(projection.rows[2] > 0, projection.limits[:, 1], projection.limits[:, 0])


def _line(projection: Projection, ends: Array) -> str:
    return polyline(projection.points(ends.T))


def _grid(limits: Array, back: Array, places: list[Array]) -> list[Array]:
    """Lines (2, 3) from end to end on the back faces, at the ticks."""
    lines = []
    for axis in range(3):
        for along in {0, 1, 2} - {axis}:
            for place in places[axis]:
                line = np.array([back, back])
                line[:, axis] = place
                line[:, along] = limits[along]
                lines.append(line)
    return lines


def _edges(limits: Array, back: Array) -> list[Array]:
    """The nine edges (2, 3) of the three back faces."""
    edges = []
    for along in range(3):
        others = [a for a in range(3) if a != along]
        for front in ((), (others[0],), (others[1],)):
            line = np.array([back, back])
            for axis in front:
                line[:, axis] = limits[axis].sum() - back[axis]
            line[:, along] = limits[along]
            edges.append(line)
    return edges


def _outer_edge(projection: Projection, axis: int) -> Array:
    """A point (3,) of the edge with an axis's ticks: of the two in the outline, the lower one; the left one for z."""
    corners = []
    for other in {0, 1, 2} - {axis}:
        corner = _back(projection)
        corner[other] = _front(projection)[other]
        corner[axis] = projection.limits[axis].mean()
        corners.append(corner)
    left, right = (projection.points(corner[:, None])[:, 0] for corner in corners)
    first = left[0] < right[0] if axis == 2 else left[1] > right[1]
    return corners[0] if first else corners[1]


def _draw_axis(canvas: Canvas, projection: Projection, axis: int, places: Array, label: str) -> None:
    corner = _outer_edge(projection, axis)
    low, high = projection.limits[axis]
    at = np.repeat(corner[:, None], len(places) + 1, axis=1)
    at[axis] = [*places, (low + high) / 2]
    *spots, middle = projection.points(at).T
    away = _outwards(projection, axis, corner)
    canvas.path("".join(polyline(np.stack([s, s + 3.5 * away], axis=1)) for s in spots), FAINT)
    names = ticks.labels(places)
    for spot, name in zip(spots, names, strict=True):
        _beside(canvas, spot, away, 5.0, name, TICK)
    wide = max((width_of(name, TICK) for name in names), default=0.0)
    _beside(canvas, middle, away, 10.0 + wide * abs(float(away[0])) + TICK * abs(float(away[1])), label, LABEL)


def _beside(canvas: Canvas, spot: Array, away: Array, gap: float, words: str, size: float) -> None:
    """Words whose box begins so many points away from a spot."""
    reach = np.abs(away) @ [width_of(words, size) / 2, size / 2]
    x, y = spot + (gap + reach) * away
    canvas.text(float(x), float(y), words, Lettering(size, ha="center", va="center"))


def _outwards(projection: Projection, axis: int, corner: Array) -> Array:
    """Unit vector (2,) on the sheet, across the edge and away from the box's middle."""
    ends = np.repeat(corner[:, None], 2, axis=1)
    ends[axis] = projection.limits[axis]
    a, b = projection.points(ends).T
    along = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    across = np.array([-along[1], along[0]])
    return across if across @ ((a + b) / 2 - projection.middle) >= 0 else -across
