"""What artists of matplotlib have in common: where they are, their colours, their strokes."""

from typing import Any

import numpy as np
from matplotlib.colors import to_hex, to_rgba

from slambook.figures.style import DASHES
from slamlib.errors import SlamlibError


class CannotReplayError(SlamlibError):
    """The renderer has nothing for what a figure of matplotlib's holds."""


def place_of(transform: Any, ax: Any) -> str:
    """What a transform counts in: "data", "x data" and shares of y, "y data", "axes fraction"."""
    for name, known in (
        ("data", ax.transData),
        ("x data", ax.get_xaxis_transform(which="grid")),
        ("y data", ax.get_yaxis_transform(which="grid")),
        ("axes fraction", ax.transAxes),
    ):
        if transform is known:
            return name
    raise CannotReplayError("something is drawn in units of its own")


def must_be_data(transform: Any, ax: Any) -> None:
    """Raises CannotReplayError for what is not placed by the axes' own units."""
    if place_of(transform, ax) != "data":
        raise CannotReplayError("something is placed by shares of the axes")


def base(artist: Any) -> dict[str, Any]:
    """What every artist has."""
    return {"zorder": artist.get_zorder(), "clip_on": artist.get_clip_on()}


def color_of(color: Any, alpha: float | None = None) -> tuple[str, float]:
    """A colour as the renderer takes it, and its opacity."""
    r, g, b, a = to_rgba(color, alpha)
    return ("none", 1.0) if a == 0 else (to_hex((r, g, b)), a)


def _dashes(style: tuple[float, Any], width: float) -> str:
    """The name of a collection's line style, which is (offset, lengths in points)."""
    lengths = () if style[1] is None else tuple(style[1])
    for name, wanted in DASHES.items():
        if len(wanted) == len(lengths) and np.allclose(np.array(wanted) * width, lengths):
            return name
    raise CannotReplayError("dashes without a name")


def strokes(artist: Any, count: int) -> list[tuple[Any, ...]]:
    """Colour, opacity, width and line style for each of so many items of a collection."""
    found = []
    for i in range(count):
        color, width, style = (
            turn(v, i) for v in (artist.get_edgecolor(), artist.get_linewidth(), artist.get_linestyle())
        )
        found.append((*color_of(color), float(width), _dashes(style, float(width))))
    return found


def turn(values: Any, i: int) -> Any:
    """A collection's styles come round again."""
    return values[i % len(values)] if len(values) else (0, 0, 0, 0)
