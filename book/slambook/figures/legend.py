"""What the marks are called: in the corner with the fewest points, or where the caller wants it."""

from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.colors import colors, paint
from slambook.figures.marks import Mark, beyond
from slambook.figures.paths import Box
from slambook.figures.scales import DataView
from slambook.figures.words import Lettering, width_of
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.manifolds import Array

# Shares of the room, to the right and up.
PLACES = {
    "upper right": (1.0, 1.0),
    "upper left": (0.0, 1.0),
    "lower left": (0.0, 0.0),
    "lower right": (1.0, 0.0),
    "center right": (1.0, 0.5),
    "center left": (0.0, 0.5),
    "upper center": (0.5, 1.0),
    "lower center": (0.5, 0.0),
    "center": (0.5, 0.5),
}
ROW = 1.42  # height of a row, in sizes of its font
AWAY, SAMPLE, GAP, PAD, COLUMN = 4.0, 20.0, 7.0, 2.0, 16.0  # points; AWAY from the axes, PAD within the legend


@dataclass
class Legend:
    """Samples and labels of marks, on a slightly transparent ground.

    loc: "best", "upper right", "center left", ..., or where its lower left corner is; bbox_to_anchor: where the corner
    named by loc is, both in shares of the axes. fontsize [pt]; markerscale: size of the marks here, in their own.
    """

    loc: Any = "best"
    ncols: int = 1
    bbox_to_anchor: tuple[float, float] | None = None
    title: str = ""
    fontsize: float = 10.6
    frameon: bool = True
    markerscale: float = 1.0
    entries: list[tuple[Mark, str]] = field(default_factory=list)

    def __post_init__(self) -> None:
        if not isinstance(self.loc, str):
            self.loc, self.bbox_to_anchor = "lower left", self.loc
        if self.loc not in (*PLACES, "best"):
            raise UnknownNameError.of("loc of legend", self.loc, ["best", *PLACES])
        if self.bbox_to_anchor is not None and (len(self.bbox_to_anchor) != 2 or self.loc == "best"):
            raise SlamlibError("legend: bbox_to_anchor is a point (x, y), and loc says which corner lies on it")
        if self.ncols < 1:
            raise SlamlibError(f"legend: ncols is a number of columns, at least 1, got {self.ncols}")

    @classmethod
    def of(cls, options: dict[str, Any], entries: list[tuple[Mark, str]]) -> "Legend":
        """A legend with these options; raises UnknownNameError for one that it does not have."""
        known = [f.name for f in fields(cls) if f.name != "entries"]
        options = {("ncols" if name == "ncol" else name): value for name, value in options.items()}
        for name in options:
            if name not in known:
                raise UnknownNameError.of("keyword of legend", name, known)
        return cls(**options, entries=entries)

    def columns(self) -> list[list[tuple[Mark, str]]]:
        """The entries, column by column."""
        parts = np.array_split(np.arange(len(self.entries)), min(self.ncols, max(len(self.entries), 1)))
        return [[self.entries[i] for i in part] for part in parts]

    def _size(self, widest: float) -> tuple[float, list[float], tuple[float, float]]:
        """Font size, widths of the columns, and width and height; the words shrink if they would be too wide."""
        columns = self.columns()
        words = [max((width_of(label, 1.0) for _, label in column), default=0.0) for column in columns]
        fixed = len(columns) * (SAMPLE + GAP) + (len(columns) - 1) * COLUMN + 2 * PAD
        size = min(self.fontsize, max(widest - fixed, 1.0) / max(sum(words), 1e-9))
        size = max(np.floor(100 * size) / 100, 0.01)
        widths = [SAMPLE + GAP + size * w for w in words]
        rows = max(map(len, columns)) + bool(self.title)
        wide = max(sum(widths) + (len(widths) - 1) * COLUMN, width_of(self.title, size)) + 2 * PAD
        return size, widths, (wide, rows * ROW * size + 2 * PAD)

    def _box(self, view: DataView, size: tuple[float, float], loc: str) -> Box:
        left, top, right, bottom = view.box
        (wide, high), (x, y) = size, PLACES[loc]
        if self.bbox_to_anchor is not None:
            spot_x = left + self.bbox_to_anchor[0] * (right - left) + AWAY * (1 - 2 * x)
            spot_y = bottom + self.bbox_to_anchor[1] * (top - bottom) + AWAY * (2 * y - 1)
        else:
            spot_x, spot_y = left + AWAY + x * (right - left - 2 * AWAY), bottom - AWAY + y * (top - bottom + 2 * AWAY)
        return spot_x - x * wide, spot_y - (1 - y) * high, spot_x + (1 - x) * wide, spot_y + y * high

    def _widest(self, view: DataView, sheet: float) -> float:
        """Points that its width may take: of the axes', or half the sheet if it stands beside them."""
        beside = self.bbox_to_anchor is not None and not 0 <= self.bbox_to_anchor[0] < 1
        return 0.5 * sheet if beside else view.box[2] - view.box[0] - 2 * AWAY

    def room(self, view: DataView, sheet: tuple[float, float]) -> Array:
        """Points that an anchored legend needs to the left, above, to the right and below the axes."""
        if self.bbox_to_anchor is None or not self.entries:
            return np.zeros(4)
        box = self._box(view, self._size(self._widest(view, sheet[0]))[2], self.loc)
        return beyond(view.box, box)

    def covered(self, ink: Array, box: Box) -> int:
        """How many points (2, N) of the marks lie under a box."""
        low, high = np.reshape(box[:2], (2, 1)), np.reshape(box[2:], (2, 1))
        return int(np.sum(np.all((ink > low) & (ink < high), axis=0)))

    def place(self, marks: list[Mark], view: DataView, size: tuple[float, float]) -> Box:
        """The legend's box on the sheet; "best" is the place that covers the fewest points."""
        if self.loc != "best":
            return self._box(view, size, self.loc)
        ink = np.concatenate([np.empty((2, 0)), *(mark.ink(view) for mark in marks)], axis=1)
        return min((self._box(view, size, loc) for loc in PLACES), key=lambda box: self.covered(ink, box))

    def draw(self, marks: list[Mark], canvas: Canvas, view: DataView) -> None:
        """Put it on the sheet."""
        if not self.entries:
            return
        size, widths, whole = self._size(self._widest(view, canvas.width))
        left, top, right, bottom = self.place(marks, view, whole)
        if self.frameon:
            canvas.rectangle((left, top, right, bottom), f"fill:{paint(colors.paper)};fill-opacity:.75", radius=3)
        look = Lettering(size, va="center")
        row, x, y = ROW * size, left + PAD, top + PAD
        if self.title:
            canvas.text(x, y + row / 2, self.title, look)
            y += row
        for column, width in zip(self.columns(), widths, strict=True):
            for i, (mark, label) in enumerate(column):
                middle = y + (i + 0.5) * row
                mark.swatch(canvas, (x, middle - 0.35 * size, x + SAMPLE, middle + 0.35 * size), self.markerscale)
                canvas.text(x + SAMPLE + GAP, middle, label, look)
            x += width + COLUMN
