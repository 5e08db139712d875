"""What artists of matplotlib have in common: where they are, their colours, their strokes."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib.colors import to_hex, to_rgba

from slambook.figures.style import DASHES
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

GAP = np.full((2, 1), np.nan)  # between one line and the next


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
    return {"zorder": artist.get_zorder(), "clip_on": artist.get_clip_on(), "gid": artist.get_gid()}


def color_of(color: Any, alpha: float | None = None) -> tuple[str, float]:
    """A colour as the renderer takes it, and its opacity."""
    r, g, b, a = to_rgba(color, alpha)
    return ("none", 1.0) if a == 0 else (to_hex((r, g, b)), a)


def fill_style(face: Any, edge: Any, width: float) -> dict[str, Any]:
    """Of an area; an edge of the area's own colour is none."""
    (inside, alpha), (outline, _) = color_of(face), color_of(edge)
    edged = {"edgecolor": outline, "lw": width} if outline not in ("none", inside) and width > 0 else {}
    return {"facecolor": inside, "alpha": alpha, **edged}


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


def alike(styles: Iterable[Any], items: Iterable[Any]) -> dict[Any, list[Any]]:
    """The items that look alike, by their style."""
    found: dict[Any, list[Any]] = {}
    for style, item in zip(styles, items, strict=True):
        found.setdefault(style, []).append(item)
    return found


def pieces_of(path: Any, ax: Any) -> list[Array]:
    """The lines (2, N) of a path, each with a gap behind it; curves are divided as finely as one sees.

    Not by to_polygons alone: in the units of the data that would leave out what is less than a pixel of a canvas.
    """
    codes = np.full(len(path.vertices), path.LINETO) if path.codes is None else np.asarray(path.codes)
    if np.any((codes == path.CURVE3) | (codes == path.CURVE4)):
        fine = type(path)(path.vertices, path.codes, readonly=False)
        fine.should_simplify = False
        rings = [ax.transData.inverted().transform(ring) for ring in fine.to_polygons(ax.transData, closed_only=False)]
        return [np.concatenate([np.asarray(ring).T, GAP], axis=1) for ring in rings]
    starts = np.flatnonzero(codes == path.MOVETO)
    found = []
    for part, kinds in zip(np.split(path.vertices, starts), np.split(codes, starts), strict=True):
        line = np.where((kinds == path.CLOSEPOLY)[:, None], part[:1], part)
        found += [np.concatenate([line.T, GAP], axis=1)] if len(line) else []
    return found
