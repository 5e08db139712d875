"""The calls that draw functions of the plane and images, with matplotlib's names and arguments."""

from typing import Any

import numpy as np

from slambook.figures.colors import CYCLE, color_named
from slambook.figures.contours import contour_lines, regions
from slambook.figures.data import numbers, row_of
from slambook.figures.holder import Holder
from slambook.figures.images import Image, pixels_of
from slambook.figures.marks import Area, Edges, Line
from slambook.figures.style import alpha_of, fill_of, named, stroke_of
from slambook.figures.ticks import nice_ticks
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

LEVELED = ("levels", "colors", "linewidth", "linestyle", "alpha", "zorder", "label")


class Fields(Holder):
    """Contour lines, filled level sets, images."""

    def contour(self, *data: Any, **style: Any) -> list[Line]:
        """Lines of equal value of z (rows, columns), or of x, y, z; levels: a number of them, or the values."""
        x, y, z, levels, chosen = _field("contour", data, style)
        found: list[Line] = []
        for level, color in zip(levels, _shades(chosen, len(levels)), strict=False):
            lines = contour_lines(x, y, z, level) or [np.empty((2, 0))]
            gap = np.full((2, 1), np.nan)
            points = np.concatenate([part for line in lines for part in (line, gap)], axis=1)
            line = Line(x=points[0], y=points[1], stroke=stroke_of(chosen, color, 1.2), tight=_whole(x, y))
            found.append(self._add(line, {**chosen, "label": None} if found else chosen))
        return found

    def contourf(self, *data: Any, **style: Any) -> list[Area]:
        """Filled level sets of z, or of x, y, z: from each level up to the last one, painted over the one below it.

        So a single translucent colour deepens from level to level; opaque colours are seen in bands, as in matplotlib.
        """
        x, y, z, levels, chosen = _field("contourf", data, style)
        top = regions(x, y, z, levels[-1])
        found: list[Area] = []
        for level, color in zip(levels[:-1], _shades(chosen, len(levels) - 1), strict=True):
            rings = regions(x, y, z, level) + top
            area = Area(
                rings=rings, fill=fill_of({"alpha": chosen.get("alpha")}, color), holes=True, tight=_whole(x, y)
            )
            found.append(self._add(area, {**chosen, "label": None} if found else chosen))
        return found

    def imshow(
        self,
        array: Any,
        *,
        extent: Any = None,
        origin: str = "upper",
        cmap: str = "gray",
        vmin: float | None = None,
        vmax: float | None = None,
        interpolation: str = "nearest",
        aspect: str = "equal",
        **style: Any,
    ) -> Image:
        """Pixels (rows, columns) of numbers or (rows, columns, 3 or 4) of colours; y points down unless origin="lower".

        extent: (left, right, bottom, top) in data units, by default half a pixel around whole ones.
        """
        chosen = named("imshow", style, ("alpha", "zorder", "label", "clip_on"))
        if origin not in ("upper", "lower"):
            raise UnknownNameError.of("origin of imshow", origin, ("upper", "lower"))
        pixels = pixels_of(array, cmap, vmin, vmax)
        rows, columns = pixels.shape[:2]
        ends = (rows - 0.5, -0.5) if origin == "upper" else (-0.5, rows - 0.5)
        left, right, bottom, top = row_of(
            "imshow", "extent", (-0.5, columns - 0.5, *ends) if extent is None else extent
        )
        if extent is None and origin == "upper":
            self.y.inverted = True
        self.equal = aspect == "equal"
        across, along = (float(left), float(right)), (float(bottom), float(top))
        image = Image(
            pixels=pixels,
            extent=(*across, *along),
            tight=(across, along),
            lower=origin == "lower",
            smooth=interpolation != "nearest",
            alpha=alpha_of(chosen),
        )
        return self._add(image, chosen)


def _field(function: str, data: tuple[Any, ...], style: dict[str, Any]) -> tuple[Array, Array, Array, list[float], Any]:
    """Grid, values and levels of a call, and its other keywords."""
    chosen = named(function, style, LEVELED)
    if len(data) not in (1, 3):
        raise SlamlibError(f"{function} takes z, or x, y and z; got {len(data)} arrays")
    z = numbers(function, "z", data[-1])
    if z.ndim != 2 or min(z.shape) < 2:
        raise ShapeError(f"{function}: z should be (rows, columns), two of each at least, but has shape {z.shape}")
    x, y = (numbers(function, n, v) for n, v in zip("xy", data[:2], strict=True)) if data[1:] else _counted(z)
    if x.ndim == y.ndim == 1:
        x, y = np.meshgrid(x, y)
    if not x.shape == y.shape == z.shape:
        raise ShapeError(f"{function}: x {x.shape} and y {y.shape} do not go with z {z.shape}")
    return x, y, z, _levels(function, z, chosen.get("levels")), chosen


def _counted(z: Array) -> tuple[Array, Array]:
    return np.arange(float(z.shape[1])), np.arange(float(z.shape[0]))


def _levels(function: str, z: Array, given: Any) -> list[float]:
    if given is None or np.ndim(given) == 0:
        if not np.any(np.isfinite(z)) or np.nanmin(z) == np.nanmax(z):
            raise SlamlibError(f"{function}: z has one value only, so levels cannot be chosen for it")
        given = nice_ticks(float(np.nanmin(z)), float(np.nanmax(z)), min(max(int(given or 7), 4), 9))
    levels = row_of(function, "levels", given)
    if len(levels) < 1 + (function == "contourf") or np.any(np.diff(levels) <= 0):
        raise SlamlibError(f"{function}: levels must increase, and be {1 + (function == 'contourf')} at least")
    return [float(v) for v in levels]


def _shades(chosen: dict[str, Any], count: int) -> list[str]:
    """A colour for each level, repeated as needed."""
    given = chosen.get("colors") or [CYCLE[0]]
    colors = [color_named(c) for c in ([given] if isinstance(given, str) else given)]
    return [colors[i % len(colors)] for i in range(count)]


def _whole(x: Array, y: Array) -> Edges:
    return (float(x.min()), float(x.max())), (float(y.min()), float(y.max()))
