"""A grid that spreads landmarks over the image: a cell without predictions may get a new one. Chapter active_search.

Steps 1a to 1c of active search, section 6.1.3 of the toolbox's manual; Davison (2003) asks for the same spread.
"""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.manifolds import Array, Mask, numbers
from slamlib.plain_data.fields import Whole, check

Cell = tuple[int, int]


@dataclass(frozen=True)
class Grid:
    """An image (w, h) [px] in cells (columns, rows); skip_outer leaves the outermost ones free of new landmarks.

    A cell is named (row, column). Raises SlamlibError for cells without pixels, and where no cell would be left.
    """

    image: tuple[Whole, Whole]
    cells: tuple[Whole, Whole] = (8, 6)
    skip_outer: bool = True

    def __post_init__(self) -> None:
        check(self)
        if any(c > n for c, n in zip(self.cells, self.image, strict=True)):
            raise SlamlibError(f"Grid: an image of {self.image} pixels cannot have {self.cells} cells; ask for fewer")
        if self.skip_outer and min(self.cells) < 3:
            raise SlamlibError(f"Grid: of {self.cells} cells none is left without the outer ones; use skip_outer=False")

    @property
    def usable(self) -> Mask:
        """Mask (rows, columns) of the cells in which a landmark may be initialized."""
        mask = np.ones(self.cells[::-1], dtype=bool)
        if self.skip_outer:
            mask[[0, -1]] = mask[:, [0, -1]] = False
        return mask

    def occupied(self, pixels: Array) -> Mask:
        """Mask (rows, columns) of the cells that hold a pixel (n, 2); those outside the image, and nan, are ignored.

        Raises ShapeError.
        """
        pixels = numbers(pixels, "Grid.occupied", "pixels")
        pixels = pixels.reshape(0, 2) if not pixels.size else pixels
        if pixels.ndim != 2 or pixels.shape[1] != 2:
            raise ShapeError(f"Grid.occupied: pixels should have shape (n, 2), but have shape {pixels.shape}")
        mask = np.zeros(self.cells[::-1], dtype=bool)
        # A pixel extends half a pixel each way.
        columns, rows = (np.digitize(pixels[:, i], self._bounds(i) - 0.5) - 1 for i in (0, 1))
        inside = (columns >= 0) & (columns < self.cells[0]) & (rows >= 0) & (rows < self.cells[1])
        mask[rows[inside], columns[inside]] = True
        return mask

    def free(self, occupied: Mask, rng: np.random.Generator) -> Cell | None:
        """One usable cell (row, column) that is not occupied, drawn at random, or None if there is none."""
        occupied = np.asarray(occupied, dtype=bool)
        if occupied.shape != self.cells[::-1]:
            raise ShapeError(f"Grid.free: occupied should have shape {self.cells[::-1]}, got {occupied.shape}")
        candidates = np.argwhere(self.usable & ~occupied)
        if not len(candidates):
            return None
        row, column = candidates[rng.integers(len(candidates))].tolist()
        return row, column

    def rectangle(self, cell: Cell) -> tuple[int, int, int, int]:
        """The cell's pixels (u0, v0, u1, v1): image[v0:v1, u0:u1] is the image of the cell (row, column)."""
        row, column = cell
        if not (0 <= row < self.cells[1] and 0 <= column < self.cells[0]):
            raise SlamlibError(f"Grid.rectangle: there is no cell {cell}; (row, column) go up to {self.cells[::-1]}")
        across, down = self._bounds(0), self._bounds(1)
        return int(across[column]), int(down[row]), int(across[column + 1]), int(down[row + 1])

    def _bounds(self, axis: int) -> Array:
        """First pixel of each column or row, and one past the last."""
        return np.rint(np.linspace(0, self.image[axis], self.cells[axis] + 1)).astype(int)
