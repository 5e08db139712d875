"""matplotlib.pyplot of the page: figures, and the current axes that plot, title, xlabel and the like draw on."""

from types import SimpleNamespace
from typing import Any

import numpy as np
from slambook.figures.figure import Figure as Drawn
from slambook.figures.figure import figure as drawn

from slamlib.errors import SlamlibError

from . import missing, rcParams
from .axes import Axes

__all__ = ["close", "figure", "gca", "gcf", "rcParams", "savefig", "show", "style", "subplots"]
_open: list["Figure"] = []
_current: dict[str, Any] = {}
_SETTERS = ("title", "xlabel", "ylabel", "xlim", "ylim", "xscale", "yscale", "xticks", "yticks")
style = SimpleNamespace(use=lambda name: None)  # the page's style is the book's


class Figure(Drawn):
    """The renderer's figure; without axes until somebody asks for them."""

    def gca(self) -> Axes:
        """The axes that pyplot draws on: the last ones touched by it, else the first."""
        if not self.grid.size:
            self.add_subplot()
        ax: Axes = self.axes[0]
        return ax

    def add_subplot(self, *place: int) -> Any:
        """The axes of a new figure: the whole of it; for more use subplots."""
        if self.grid.size or place not in ((), (1, 1, 1), (111,)):
            raise SlamlibError("the page's matplotlib makes tables of axes by subplots(rows, columns) only")
        self.grid = np.full((1, 1), Axes(), dtype=object)
        return self.grid[0, 0]

    def subplots(self, nrows: int = 1, ncols: int = 1, *, squeeze: bool = True) -> Any:
        """A table of axes in a new figure."""
        self.grid = drawn(nrows, ncols, kind=Axes)[0].grid
        shaped = self.grid.squeeze() if squeeze else self.grid
        return shaped if shaped.ndim else shaped.item()

    def tight_layout(self, **options: Any) -> None:
        """Nothing to do: the renderer leaves just the room that words need."""

    def show(self) -> None:
        """It is shown when its cell has run."""

    def close(self) -> None:
        """It is not shown by itself any more."""
        close(self)

    def __getattr__(self, name: str) -> Any:
        known = [n for n in dir(type(self)) if not n.startswith("_")]
        raise missing("a figure", name, known)


def figure(*, figsize: tuple[float, float] = (5.8, 3.5), layout: str | None = None) -> Figure:
    """A new figure of so many inches."""
    made = Figure(np.empty((0, 0), dtype=object), *figsize)
    _open.append(made)
    return made


def subplots(
    nrows: int = 1, ncols: int = 1, *, figsize: tuple[float, float] = (5.8, 3.5), squeeze: bool = True, **options: Any
) -> Any:
    """A new figure and its axes: one, or an array of them."""
    for name in options.keys() - {"layout"}:
        raise missing("subplots", name, ["nrows", "ncols", "figsize", "squeeze", "layout"])
    made = figure(figsize=figsize)
    return made, made.subplots(nrows, ncols, squeeze=squeeze)


def gcf() -> Figure:
    """The figure that was made last, or a new one."""
    return _open[-1] if _open else figure()


def gca() -> Axes:
    """The axes that plot and the like draw on."""
    return gcf().gca()


def close(fig: Any = None) -> None:
    """Close a figure (default: the last one; "all": all of them): it is not shown by itself any more."""
    gone = _open[-1:] if fig is None else list(_open) if fig == "all" else [fig]
    _open[:] = [kept for kept in _open if not any(kept is one for one in gone)]


def show(*, block: bool | None = None) -> None:
    """The cell's open figures are shown when it has run."""


def shown() -> list[Figure]:
    """The open figures, which are then closed: what a cell's end shows."""
    found = [fig for fig in _open if fig.grid.size]
    _open.clear()
    return found


def savefig(fname: Any, **options: Any) -> None:
    """Write the current figure as an SVG file."""
    gcf().savefig(fname, **options)


def tight_layout(**options: Any) -> None:
    """Nothing to do: the renderer leaves just the room that words need."""


def __getattr__(name: str) -> Any:
    """Calls of the current axes under pyplot's names: plot, title, xlim, legend ..."""
    known = [n for n in dir(Axes) if not n.startswith(("_", "get_", "set_"))]
    if name in _SETTERS:
        return lambda *values: getattr(gca(), f"set_{name}")(*values)
    if name in known and callable(getattr(Axes, name)):
        return lambda *values, **options: getattr(gca(), name)(*values, **options)
    raise missing("pyplot", name, [*__all__, *_SETTERS, *known])
