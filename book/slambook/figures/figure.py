"""A figure: axes in rows and columns, with just the room between them that their words need."""

from pathlib import Path
from typing import Any

import numpy as np

from slambook.figures.axes import Axes
from slambook.figures.canvas import Canvas
from slambook.figures.colors import standing_alone
from slambook.figures.paths import Box
from slamlib.errors import SlamlibError, UnknownCallError
from slamlib.plain_data.files import write_whole

PAD, BETWEEN = 3.0, 8.0  # points around all, and between neighbours


class Figure:
    """Axes on a sheet of so many inches; shown by picture(fig, alt), or by itself as a cell's last value."""

    def __init__(self, axes: Any, width: float, height: float) -> None:
        self.grid, self.width, self.height = axes, 72 * width, 72 * height

    @property
    def axes(self) -> list[Any]:
        """All axes, row by row."""
        return list(self.grid.ravel())

    def _boxes(self) -> list[Box]:
        """Each axes' rectangle: as large as the words around them allow; they depend on it, so it is found in steps."""
        rows, columns = self.grid.shape
        rooms = np.full((rows, columns, 4), 20.0)
        for _ in range(4):
            left, top, right, bottom = rooms.transpose(2, 0, 1)
            across = _shared(left.max(axis=0), right.max(axis=0), self.width)
            down = _shared(top.max(axis=1), bottom.max(axis=1), self.height)
            boxes = [(x0, y0, x1, y1) for y0, y1 in down for x0, x1 in across]
            sheet = (self.width, self.height)
            found = [ax.room(box, sheet) for ax, box in zip(self.axes, boxes, strict=True)]
            before, rooms = rooms, np.array(found).reshape(rows, columns, 4)
            if np.array_equal(before, rooms):
                break
        return boxes

    def svg(self, alt: str) -> str:
        """The figure as an SVG element that follows the page's theme; alt describes it."""
        canvas = Canvas(self.width, self.height)
        for ax, box in zip(self.axes, self._boxes(), strict=True):
            ax.draw(canvas, box)
        return canvas.finished(alt)

    def savefig(self, fname: Any, *, alt: str | None = None) -> None:
        """Write a standalone SVG file, light, on white; it is saved atomically."""
        path = Path(fname)
        if path.suffix.lower() != ".svg":
            raise SlamlibError(f"savefig: this figure is written as SVG, so the name should end in .svg: {path.name}")
        svg = standing_alone(self.svg(self.described() if alt is None else alt))
        size = f'width="{self.width:g}pt" height="{self.height:g}pt"'
        svg = svg.replace("<svg ", f'<svg xmlns="http://www.w3.org/2000/svg" {size} ', 1)
        svg = svg.replace("max-width:", "background:#ffffff;max-width:", 1)
        write_whole(path, '<?xml version="1.0" encoding="utf-8"?>\n' + svg + "\n")

    def close(self) -> None:
        """Mark this figure as shown, so that the end of the cell does not show it again."""

    def described(self) -> str:
        """A description made of titles and labels, for a figure that was given none."""
        said = [ax.described() for ax in self.axes]
        return "A figure: " + "; ".join(filter(None, said)) if any(said) else "A figure without words."

    def _repr_html_(self) -> str:
        return f'<div class="picture">{self.svg(self.described())}</div>'

    def _repr_svg_(self) -> str:
        return self.svg(self.described()).replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)

    def __repr__(self) -> str:
        return self.described()

    def __getattr__(self, name: str) -> Any:
        known = [n for n in dir(type(self)) if not n.startswith("_")]
        raise UnknownCallError.of_object("a figure", name, known)


def _shared(before: Any, after: Any, length: float) -> list[tuple[float, float]]:
    """Equal stretches of a length, with so much room before and after each."""
    free = length - float(np.sum(before) + np.sum(after)) - 2 * PAD - BETWEEN * (len(before) - 1)
    size = max(free / len(before), 0.15 * length / len(before))
    starts = (
        PAD
        + np.cumsum(before)
        + np.concatenate([[0], np.cumsum(after)[:-1]])
        + np.arange(len(before)) * (size + BETWEEN)
    )
    return [(float(s), float(s + size)) for s in starts]


def figure(rows: int = 1, columns: int = 1, *, width: float = 5.8, height: float = 3.5, kind: type[Axes] = Axes) -> Any:
    """A figure and its axes (one, or an array of them) in the house style, without matplotlib; sizes in inches.

    Keep to 6.4 inches: on a phone a figure is shrunk to the column, and its words with it.
    """
    if rows < 1 or columns < 1 or not (width > 0 and height > 0):
        raise SlamlibError(f"figure: rows, columns and sizes are positive, got {rows}, {columns}, {width} x {height}")
    axes = np.empty((rows, columns), dtype=object)
    for place in np.ndindex(rows, columns):
        axes[place] = kind()
    shaped = axes.squeeze()
    return Figure(axes, width, height), shaped if shaped.ndim else shaped.item()
