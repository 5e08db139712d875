"""Words and arrows inside axes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.colors import Fill, Stroke
from slambook.figures.marks import Mark, beyond
from slambook.figures.paths import Box, cut_line, outline
from slambook.figures.scales import DataView
from slambook.figures.words import Lettering
from slamlib.manifolds import Array

Place = Callable[[DataView, Array], Array]  # where (2,) on the sheet a pair of numbers is


def in_data(view: DataView, pair: Array) -> Array:
    """A pair of the axes' own units."""
    return view.points(pair[:1], pair[1:])[:, 0]


def in_axes(view: DataView, pair: Array) -> Array:
    """Shares of the axes' width and height, from the lower left."""
    left, top, right, bottom = view.box
    return np.array([left + pair[0] * (right - left), bottom - pair[1] * (bottom - top)])


PLACES: dict[str, Place] = {"data": in_data, "axes fraction": in_axes}


@dataclass(kw_only=True, repr=False)
class Words(Mark):
    """A text at a point."""

    xy: Array
    text: str
    look: Lettering
    place: Place = in_data
    moved: tuple[float, float] = (0.0, 0.0)  # points to the right, and up
    zorder: float = 3.0
    clip: bool = False

    def where(self, view: DataView) -> Array:
        """Its point on the sheet."""
        return self.place(view, self.xy) + np.array([self.moved[0], -self.moved[1]])

    def box(self, view: DataView) -> Box:
        """Its estimated box on the sheet."""
        x, y = (float(v) for v in self.where(view))
        return self.look.box(x, y, self.text)

    def room(self, view: DataView) -> Array:
        return beyond(view.box, self.box(view)) if self.place is in_axes else np.zeros(4)

    def draw(self, canvas: Canvas, view: DataView) -> None:
        x, y = (float(v) for v in self.where(view))
        if 0 <= x <= canvas.width and 0 <= y <= canvas.height:  # else their point is not to be seen
            canvas.text(x, y, self.text, self.look)

    def ink(self, view: DataView) -> Array:
        left, top, right, bottom = self.box(view)
        return np.array([[left, (left + right) / 2, right] * 2, [top] * 3 + [bottom] * 3])


ARROWS = {  # whether there is a head at the start and at the end, and whether heads are filled
    "-": (False, False, False),
    "->": (False, True, False),
    "<-": (True, False, False),
    "<->": (True, True, False),
    "-|>": (False, True, True),
    "<|-": (True, False, True),
    "<|-|>": (True, True, True),
}


@dataclass(kw_only=True, repr=False)
class Arrow(Mark):
    """An arrow from the words, or from their point if they are empty, to a point."""

    words: Words
    xy: Array
    place: Place
    stroke: Stroke
    heads: tuple[bool, bool, bool]  # as in ARROWS
    gap: tuple[float, float] = (2.0, 2.0)  # points left free at its start and end
    size: float = 11.0
    zorder: float = 3.0
    clip: bool = False

    def _ends(self, view: DataView) -> Array:
        start, end = self.words.where(view), self.place(view, self.xy)
        if self.words.text.strip():
            left, top, right, bottom = self.words.box(view)
            middle = np.array([(left + right) / 2, (top + bottom) / 2])
            inside = cut_line(np.stack([middle, end], axis=1), (left, top, right, bottom))
            start = inside[0][:, -1] if inside else middle
        return np.stack([start, end], axis=1)

    def draw(self, canvas: Canvas, view: DataView) -> None:
        ends = self._ends(view)
        length = float(np.hypot(*(ends[:, 1] - ends[:, 0])))
        if not length > sum(self.gap):
            return
        along = (ends[:, 1] - ends[:, 0]) / length
        ends = ends + np.outer(along, [self.gap[0], -self.gap[1]])
        canvas.path(outline(ends, self.sight(view), closed=False), self.stroke.css())
        *heads, full = self.heads
        look = Fill(self.stroke.color, self.stroke.alpha, self.stroke) if full else self.stroke
        for head, tip, way in zip(heads, ends.T, (-along, along), strict=True):
            if head:
                side = np.array([-way[1], way[0]])
                one, other = (tip - 0.4 * self.size * way + s * 0.2 * self.size * side for s in (1, -1))
                line = np.stack([one, tip, other], axis=1)
                canvas.path(outline(line, self.sight(view), closed=full), look.css())
