"""Axes as matplotlib's are called: what is drawn is made of the renderer's lines, areas and words."""

from typing import Any

import numpy as np
from slambook.figures.axes import Axes as Drawn
from slambook.figures.colors import CYCLE, color_named
from slambook.figures.marks import Area, Edges, Line
from slambook.figures.notes import Words
from slambook.figures.paths import pieces
from slambook.figures.scales import SCALES
from slambook.figures.style import COMMON, fill_of, marker_of, named, numbers, row_of, rows_of, stroke_of
from slambook.figures.ticks import nice_ticks

from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

from . import missing
from .contours import contour_lines, regions

SCATTERED = {
    "color": "color",
    "marker": "marker",
    "linewidth": "markeredgewidth",
    "edgecolor": "markeredgecolor",
    "facecolor": "markerfacecolor",
}
LEVELED = ("levels", "colors", "linewidth", "linestyle", "alpha", "zorder", "label")
GAP = np.full((2, 1), np.nan)


class Axes(Drawn):
    """The renderer's axes, with what matplotlib's have beyond it."""

    def __getattr__(self, name: str) -> Any:
        try:
            return super().__getattr__(name)
        except AttributeError:
            raise missing("axes", name, self._known()) from None

    # -- lines and marks -----------------------------------------------------------------------------------------------

    def loglog(self, *data: Any, **style: Any) -> list[Line]:
        """As plot, both axes logarithmic."""
        self.x.scale = self.y.scale = SCALES["log"]
        return self.plot(*data, **style)

    def semilogx(self, *data: Any, **style: Any) -> list[Line]:
        """As plot, the x axis logarithmic."""
        self.x.scale = SCALES["log"]
        return self.plot(*data, **style)

    def semilogy(self, *data: Any, **style: Any) -> list[Line]:
        """As plot, the y axis logarithmic."""
        self.y.scale = SCALES["log"]
        return self.plot(*data, **style)

    def step(self, x: Any, y: Any, form: str = "", *, where: str = "pre", **style: Any) -> list[Line]:
        """Stairs through the points: y holds before its x ("pre"), after it ("post"), or about it ("mid")."""
        x, y = rows_of("step", x=x, y=y)
        corners = {
            "pre": (np.repeat(x, 2)[:-1], np.repeat(y, 2)[1:]),
            "post": (np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1]),
            "mid": (np.concatenate([x[:1], np.repeat((x[1:] + x[:-1]) / 2, 2), x[-1:]]), np.repeat(y, 2)),
        }
        if where not in corners:
            raise UnknownNameError.of("where of step", where, corners)
        return self.plot(*corners[where], form, **style)

    def hlines(self, y: Any, xmin: Any, xmax: Any, **style: Any) -> Line:
        """Lines across from xmin to xmax at each y."""
        y, xmin, xmax = rows_of("hlines", y=y, xmin=xmin, xmax=xmax)
        return self._parted([[xmin, xmax], [y, y]], style)

    def vlines(self, x: Any, ymin: Any, ymax: Any, **style: Any) -> Line:
        """Upright lines from ymin to ymax at each x."""
        x, ymin, ymax = rows_of("vlines", x=x, ymin=ymin, ymax=ymax)
        return self._parted([[x, x], [ymin, ymax]], style)

    def _parted(self, ends: Any, style: dict[str, Any]) -> Line:
        """Lines from end to end, ends (2, 2, N), as one with gaps."""
        lines = np.concatenate([np.asarray(ends), np.full((2, 1, np.shape(ends)[-1]), np.nan)], axis=1)
        (line,) = self.plot(*lines.transpose(0, 2, 1).reshape(2, -1), **{"color": CYCLE[0], **style})
        return line

    def errorbar(
        self, x: Any, y: Any, yerr: Any = None, xerr: Any = None, fmt: str = "", *, capsize: float = 0.0, **style: Any
    ) -> list[Line]:
        """A line through points with the bars of their errors: one number, one each, or (below, above)."""
        x, y = rows_of("errorbar", x=x, y=y)
        found = self.plot(x, y, fmt, **style)
        prediction = {"color": found[0].stroke.color if found[0].stroke else found[0].marker.edge.color}  # type: ignore[union-attr]
        for axis, error in ((0, xerr), (1, yerr)):
            if error is None:
                continue
            below, above = np.broadcast_to(np.asarray(error, dtype=float), (2, len(x)))
            low, high = np.array([x, y]), np.array([x, y])
            low[axis], high[axis] = low[axis] - below, high[axis] + above
            found.append(self._parted(np.stack([low, high], axis=1), prediction))
            for caps in (low, high) if capsize else ():
                found += self.plot(*caps, "_|"[axis == 0], ms=2 * capsize, **prediction)
        found[0].zorder += 0.1  # above its bars
        return found

    def scatter(self, x: Any, y: Any, s: Any = 36.0, c: Any = None, **style: Any) -> list[Line]:
        """Marks at points; s: area in square points, one or one each; c or color: one or one each."""
        chosen = named("scatter", style, (*COMMON, *SCATTERED))
        x, y, s = rows_of("scatter", x=x, y=y, s=s)
        shades = self._shades(chosen.pop("color", c), len(x))
        sizes = np.sqrt(s)
        found: list[Line] = []
        for shade, size in dict.fromkeys(zip(shades, sizes.tolist(), strict=True)):
            here = (np.array(shades) == shade) & (sizes == size)
            prediction = {"marker": "o", **{SCATTERED.get(k, k): v for k, v in chosen.items()}, "markersize": size}
            line = Line(x=x[here], y=y[here], stroke=None, marker=marker_of(prediction, shade), zorder=1.0)
            found.append(self._add(line, {**chosen, "label": None} if found else chosen))
        return found

    def _shades(self, given: Any, count: int) -> list[str]:
        """One colour for each of so many points."""
        if given is None or isinstance(given, str) or (len(given) == 3 != count and np.ndim(given) == 1):
            return [self._next("areas", given)] * count
        if len(given) != count:
            raise ShapeError(f"scatter: {count} points need one color or {count}, got {len(given)}")
        return [color_named(color) for color in given]

    def quiver(self, x: Any, y: Any, u: Any, v: Any, *, scale: float | None = None, **style: Any) -> list[Words]:
        """Arrows (u, v) at points, in units of the axes; scale: how many of them are one of the axes'."""
        for name in ("angles", "scale_units"):
            if style.pop(name, "xy") != "xy":
                raise UnknownNameError.of(f"{name} of quiver", "that", ("xy",))
        x, y, u, v = rows_of("quiver", **{n: np.ravel(a) for n, a in (("x", x), ("y", y), ("u", u), ("v", v))})
        self.plot(x, y, ls="")
        prediction = {"arrowstyle": "-|>", "shrinkA": 0.0, "shrinkB": 0.0, **style}
        tips = np.stack([x, y]) + np.stack([u, v]) / (scale or 1.0)
        return [
            self.annotate("", tip, tail, arrowprops=prediction)
            for tip, tail in zip(tips.T, zip(x, y, strict=True), strict=True)
        ]

    # -- areas ---------------------------------------------------------------------------------------------------------

    def fill_between(self, x: Any, y1: Any, y2: Any = 0.0, where: Any = None, **style: Any) -> Area:
        """The area between two curves over x, as far as `where` is true."""
        x, y1, y2 = rows_of("fill_between", x=x, y1=y1, y2=y2)
        shown = np.where(np.ones(len(x)) if where is None else np.asarray(where), 1.0, np.nan)
        rings = []  # in matplotlib's order
        for piece in pieces(np.stack([x, y1, y2]) * shown):
            there, back = piece[[0, 1]], piece[[0, 2]]
            rings.append(np.concatenate([back[:, :1], there, back[:, ::-1]], axis=1))
        return self._area("fill_between", rings, style)

    def bar(
        self, x: Any, height: Any, width: Any = 0.8, bottom: Any = 0.0, *, align: str = "center", **style: Any
    ) -> Area:
        """Upright bars; align: x is a bar's "center" or its left "edge"; words for x stand below their bars."""
        rings, feet = self._bars(self.x, x, height, width, bottom, align)
        return self._area("bar", rings, style, ((), tuple(feet.tolist())))

    def barh(
        self, y: Any, width: Any, height: Any = 0.8, left: Any = 0.0, *, align: str = "center", **style: Any
    ) -> Area:
        """Bars from the left, as bar."""
        rings, feet = self._bars(self.y, y, width, height, left, align)
        return self._area("barh", [ring[::-1] for ring in rings], style, (tuple(feet.tolist()), ()))

    def _bars(self, axis: Any, at: Any, length: Any, thick: Any, foot: Any, align: str) -> tuple[list[Array], Array]:
        if align not in ("center", "edge"):
            raise UnknownNameError.of("align of bar", align, ("center", "edge"))
        if len(np.atleast_1d(at)) and isinstance(np.atleast_1d(at)[0], str):
            axis.set_places(np.arange(len(at)), at)
            at = np.arange(len(at))
        at, length, thick, foot = rows_of("bar", x=at, height=length, width=thick, bottom=foot)
        low = at - thick / 2 * (align == "center")
        sides = [low, low + thick, low + thick, low], [foot, foot, foot + length, foot + length]
        rings = list(np.array(sides).transpose(2, 0, 1))
        return [r for r in rings if np.all(np.isfinite(r))], foot

    def hist(self, values: Any, bins: Any = 10, range: Any = None, density: bool = False, **style: Any) -> Any:
        """Bars of how many values fall into each bin; returns (counts, edges, bars)."""
        counts, edges = np.histogram(row_of("hist", "values", values), bins=bins, density=density, range=range)
        bars = self.bar(edges[:-1], counts, np.diff(edges), align="edge", **style)
        return counts, edges, bars

    # -- functions of the plane ----------------------------------------------------------------------------------------

    def contour(self, *data: Any, **style: Any) -> list[Line]:
        """Lines of equal value of z (rows, columns), or of x, y, z; levels: a number of them, or the values."""
        x, y, z, levels, chosen = _field("contour", data, style)
        found: list[Line] = []
        for level, color in zip(levels, _level_colors(chosen, len(levels)), strict=False):
            lines = contour_lines(x, y, z, level) or [np.empty((2, 0))]
            points = np.concatenate([part for line in lines for part in (line, GAP)], axis=1)
            line = Line(x=points[0], y=points[1], stroke=stroke_of(chosen, color, 1.2), tight=_whole(x, y))
            found.append(self._add(line, {**chosen, "label": None} if found else chosen))
        return found

    def contourf(self, *data: Any, **style: Any) -> list[Area]:
        """Filled level sets of z, or of x, y, z: the bands from each level to the next."""
        x, y, z, levels, chosen = _field("contourf", data, style)
        found: list[Area] = []
        for i, color in enumerate(_level_colors(chosen, len(levels) - 1)):
            rings = regions(x, y, z, levels[i]) + regions(x, y, z, levels[i + 1])
            fill = fill_of({"alpha": chosen.get("alpha")}, color)
            area = Area(rings=rings, fill=fill, holes=True, tight=_whole(x, y))
            found.append(self._add(area, {**chosen, "label": None} if found else chosen))
        return found


def _field(function: str, data: tuple[Any, ...], style: dict[str, Any]) -> tuple[Array, Array, Array, list[float], Any]:
    """Grid, values and levels of a call, and its other keywords."""
    if len(data) in (2, 4):
        data, style = data[:-1], {**style, "levels": data[-1]}
    chosen = named(function, style, LEVELED)
    if len(data) not in (1, 3):
        raise SlamlibError(f"{function} takes z, or x, y and z; got {len(data)} arrays")
    z = numbers(function, "z", data[-1])
    if z.ndim != 2 or min(z.shape) < 2:
        raise ShapeError(f"{function}: z should be (rows, columns), two of each at least, but has shape {z.shape}")
    counted = np.arange(float(z.shape[1])), np.arange(float(z.shape[0]))
    x, y = (numbers(function, n, v) for n, v in zip("xy", data[:2] or counted, strict=False)) if data[1:] else counted
    if x.ndim == y.ndim == 1:
        x, y = np.meshgrid(x, y)
    if not x.shape == y.shape == z.shape:
        raise ShapeError(f"{function}: x {x.shape} and y {y.shape} do not go with z {z.shape}")
    return x, y, z, _levels(function, z, chosen.get("levels")), chosen


def _levels(function: str, z: Array, given: Any) -> list[float]:
    if given is None or np.ndim(given) == 0:
        if not np.any(np.isfinite(z)) or np.nanmin(z) == np.nanmax(z):
            raise SlamlibError(f"{function}: z has one value only, so levels cannot be chosen for it")
        given = nice_ticks(float(np.nanmin(z)), float(np.nanmax(z)), min(max(int(given or 7), 4), 9))
    levels = row_of(function, "levels", given)
    if len(levels) < 1 + (function == "contourf") or np.any(np.diff(levels) <= 0):
        raise SlamlibError(f"{function}: levels must increase, and be {1 + (function == 'contourf')} at least")
    return [float(v) for v in levels]


def _level_colors(chosen: dict[str, Any], count: int) -> list[str]:
    """A colour for each level, repeated as needed."""
    given = chosen.get("colors") or [CYCLE[0]]
    shades = [color_named(c) for c in ([given] if isinstance(given, str) else given)]
    return [shades[i % len(shades)] for i in range(count)]


def _whole(x: Array, y: Array) -> Edges:
    return (float(x.min()), float(x.max())), (float(y.min()), float(y.max()))
