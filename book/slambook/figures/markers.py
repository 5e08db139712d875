"""The shapes that mark single points; all marks of one style are one path."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.colors import Fill, Stroke, paint
from slambook.figures.paths import dots, hundredths, joined, number, settled
from slamlib.manifolds import Array

LEAST = 4.0  # points: size of a mark in a legend
STRIP = 8.0  # points: marks are drawn strip by strip, so that the way from one to the next is short


@dataclass(frozen=True)
class Disc:
    """A round mark; filled with its edge's colour it is a dot of a round pen."""

    scale: float = 1.0

    def draw(self, canvas: Canvas, points: Array, mark: "Marker") -> None:
        """Draw it at points (2, N) on the sheet."""
        size, edge = self.scale * mark.size, mark.edge
        if mark.fill.color == edge.color:
            style = f"stroke:{paint(edge.color)};stroke-width:{number(size + edge.width)};stroke-linecap:round"
            canvas.path(dots(points), style + (f";stroke-opacity:{number(edge.alpha)}" if edge.alpha < 1 else ""))
            return
        radius = number(size / 2)
        arc = f"a{radius} {radius} 0 1 0 {number(size)} 0a{radius} {radius} 0 1 0 {number(-size)} 0z"
        starts = _pairs(points - [[size / 2], [0]])
        canvas.path("".join(f"M{joined(start)}{arc}" for start in starts), mark.fill.css())


@dataclass(frozen=True)
class Outline:
    """A mark made of lines, in units of its size; closed ones are filled."""

    lines: tuple[tuple[tuple[float, float], ...], ...]
    closed: bool = True
    scale: float = 1.0

    def draw(self, canvas: Canvas, points: Array, mark: "Marker") -> None:
        """Draw it at points (2, N) on the sheet."""
        shapes = [_pairs(np.array(line).T * [[1], [-1]] * mark.size * self.scale) for line in self.lines]
        data = []
        for x, y in _pairs(points):
            for (dx, dy), *rest in shapes:
                steps = np.diff([(dx, dy), *rest], axis=0).ravel().tolist()
                data.append(f"M{joined((x + dx, y + dy))}l{joined(steps)}{'z' * self.closed}")
        canvas.path("".join(data), mark.fill.css() if self.closed else mark.edge.css())


@dataclass(frozen=True)
class Marker:
    """A shape, its inside and its edge, and its size [pt]."""

    shape: Disc | Outline
    fill: Fill
    size: float = 6.0

    @property
    def edge(self) -> Stroke:
        """Its edge."""
        assert self.fill.edge is not None
        return self.fill.edge

    @property
    def layers(self) -> int:
        """Paths over one another: where translucent marks overlap, neighbours in different ones, they darken."""
        alpha = self.fill.alpha
        return 1 if alpha in (0, 1) else max(2, min(6, round(-3 / np.log(1 - alpha))))

    def scaled(self, factor: float) -> "Marker":
        """The same mark in another size, large enough to be recognised."""
        return replace(self, size=max(factor * self.size, LEAST))

    def draw(self, canvas: Canvas, points: Array) -> None:
        """Draw it at points (2, N) on the sheet; nan is left out."""
        points = settled(points[:, np.all(np.isfinite(points), axis=0)])
        if self.edge.color == self.fill.color == "none" or not self.fill.alpha:
            return
        points = points[:, np.lexsort((points[1], points[0], np.floor(points[1] / STRIP)))]
        for layer in range(min(self.layers, points.shape[1])):
            self.shape.draw(canvas, points[:, layer :: self.layers], self)


def _pairs(points: Array) -> Any:
    return [tuple(p) for p in hundredths(points.T).tolist()]


def _star(corners: int, inner: float) -> Outline:
    """A star of unit height with its inner corners at a share of the radius."""
    angles = np.pi / 2 + np.pi / corners * np.arange(2 * corners)
    radius = 0.5 * np.where(np.arange(2 * corners) % 2, inner, 1.0)
    return Outline((tuple(zip(radius * np.cos(angles), radius * np.sin(angles), strict=True)),))


_H = 0.5
_THICK_PLUS = tuple((x / 6, y / 6) for x, y in [(-1, 3), (1, 3), (1, 1), (3, 1), (3, -1), (1, -1)])
_THICK_PLUS += tuple((-x, -y) for x, y in _THICK_PLUS)
_THICK_X = tuple(((x - y) * 0.75, (x + y) * 0.75) for x, y in _THICK_PLUS)
MARKERS: dict[str, Disc | Outline] = {
    "o": Disc(),
    ".": Disc(0.5),
    "x": Outline((((-_H, -_H), (_H, _H)), ((-_H, _H), (_H, -_H))), closed=False),
    "+": Outline((((-_H, 0), (_H, 0)), ((0, -_H), (0, _H))), closed=False),
    "|": Outline((((0, -_H), (0, _H)),), closed=False),
    "_": Outline((((-_H, 0), (_H, 0)),), closed=False),
    "s": Outline((((-_H, -_H), (_H, -_H), (_H, _H), (-_H, _H)),)),
    "D": Outline((((-0.707, 0), (0, -0.707), (0.707, 0), (0, 0.707)),)),
    "d": Outline((((-0.42, 0), (0, -0.707), (0.42, 0), (0, 0.707)),)),
    "^": Outline((((-_H, -_H), (_H, -_H), (0, _H)),)),
    "v": Outline((((-_H, _H), (_H, _H), (0, -_H)),)),
    "<": Outline((((_H, -_H), (_H, _H), (-_H, 0)),)),
    ">": Outline((((-_H, -_H), (-_H, _H), (_H, 0)),)),
    "*": _star(5, 0.381966),
    "X": Outline((_THICK_X,)),
    "P": Outline((_THICK_PLUS,)),
}
