"""What axes in space hold, and the painter's order in which it is drawn."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.markers import Marker
from slambook.figures.marks import Line, Mark
from slambook.figures.paths import outline
from slambook.figures.projection import Projection
from slambook.figures.style import Stroke
from slambook.figures.words import Lettering
from slamlib.manifolds import Array

PIECES = 12  # of a line, at most, that lie before or behind other marks on their own
Brush = Callable[[Canvas, list[int]], None]  # draws the pieces of a mark with these numbers


@dataclass
class Mark3d:
    """Something at places (3, N) in space; counts: the limits of the axes follow it."""

    data: Array
    label: str = ""
    counts = True

    def pieces(self, projection: Projection) -> Iterable[tuple[Array, Brush]]:
        """Depths (K,) of the parts that may lie before or behind other marks, and how to draw some of them."""
        return ()

    def flat(self, projection: Projection) -> Mark:
        """As a mark of the sheet, for the legend."""
        return Mark(label=self.label)


class Line3d(Mark3d):
    """A polyline, with marks at its vertices or without."""

    def __init__(self, data: Array, stroke: Stroke | None, marker: Marker | None) -> None:
        super().__init__(data)
        self.stroke, self.marker = stroke, marker

    def pieces(self, projection: Projection) -> Iterable[tuple[Array, Brush]]:
        stroke, marker = self.stroke, self.marker
        line = _divided(self.data)
        points, depth = projection.points(line), projection.depth(line)
        if stroke is not None and stroke.seen and points.shape[1] > 1:
            yield _nearness(depth), lambda canvas, some: canvas.path(_strokes(points, some), stroke.css())
        if marker is not None:
            spots = projection.points(self.data)
            yield projection.depth(self.data), lambda canvas, some: marker.draw(canvas, spots[:, some])

    def flat(self, projection: Projection) -> Mark:
        x, y = projection.points(self.data)
        return Line(x=x, y=-y, stroke=self.stroke, marker=self.marker, label=self.label)


def _nearness(depth: Array) -> Array:
    """For each segment between vertices of these depths (N,), the depth of the piece that it belongs to."""
    middles = (depth[1:] + depth[:-1]) / 2
    size = -(-len(middles) // PIECES)
    pieces = np.pad(middles, (0, -len(middles) % size), constant_values=np.nan).reshape(-1, size)
    mean = np.nansum(pieces, axis=1) / np.maximum(np.sum(np.isfinite(pieces), axis=1), 1)
    return np.where(np.isnan(middles), np.nan, np.repeat(mean, size)[: len(middles)])


def _divided(line: Array) -> Array:
    """A line (3, N) of few long segments as one of many short ones: part of it may lie before, part behind others."""
    parts = PIECES // max(line.shape[1] - 1, 1)
    if parts < 2 or line.shape[1] < 2:
        return line
    place = np.arange((line.shape[1] - 1) * parts + 1) / parts
    return np.stack([np.interp(place, np.arange(line.shape[1]), row) for row in line])


def _strokes(points: Array, some: list[int]) -> str:
    """Path data of the line's pieces; neighbours are drawn as one line."""
    some = sorted(some)
    breaks = [0, *(i for i in range(1, len(some)) if some[i] != some[i - 1] + 1), len(some)]
    runs = [points[:, some[a] : some[b - 1] + 2] for a, b in pairwise(breaks)]
    return "".join(outline(run, (-1e3, -1e3, 2e3, 2e3), closed=False) for run in runs)


class Words3d(Mark3d):
    """A text at a point; it is drawn after all lines."""

    counts = False

    def __init__(self, data: Array, text: str, look: Lettering) -> None:
        super().__init__(data)
        self.text, self.look = text, look

    def pieces(self, projection: Projection) -> Iterable[tuple[Array, Brush]]:
        x, y = (float(v) for v in projection.points(self.data)[:, 0])
        yield np.array([np.inf]), lambda canvas, _: canvas.text(x, y, self.text, self.look)


def drawn(marks: list[Mark3d], canvas: Canvas, projection: Projection) -> None:
    """Draw the farthest pieces first; consecutive pieces of one mark are drawn together."""
    brushes: list[Brush] = []
    order: list[tuple[float, int, int]] = []
    for mark in marks:
        for depths, brush in mark.pieces(projection):
            order += [(round(float(d), 6), len(brushes), i) for i, d in enumerate(depths) if not np.isnan(d)]
            brushes.append(brush)
    order.sort()
    start = 0
    for i in range(1, len(order) + 1):
        if i == len(order) or order[i][1] != order[start][1]:
            brushes[order[start][1]](canvas, [piece for _, _, piece in order[start:i]])
            start = i
