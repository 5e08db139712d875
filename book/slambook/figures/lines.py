"""The calls that draw lines and marks, with matplotlib's names and arguments."""

from typing import Any

import numpy as np

from slambook.figures.colors import CYCLE, color_named
from slambook.figures.data import numbers, row_of, rows_of
from slambook.figures.holder import Holder
from slambook.figures.marks import Line, Rule
from slambook.figures.scales import SCALES
from slambook.figures.style import COMMON, MARKER, STROKE, format_of, marker_of, named, stroke_of
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

SCATTERED = {
    "color": "color",
    "marker": "marker",
    "linewidth": "markeredgewidth",
    "edgecolor": "markeredgecolor",
    "facecolor": "markerfacecolor",
}


class Lines(Holder):
    """Polylines, points, straight lines across the axes."""

    def plot(self, *data: Any, **style: Any) -> list[Line]:
        """Lines through y, or through x and y, with an optional format as "o-"; columns of y are lines of their own."""
        *values, form = data if data and isinstance(data[-1], str) else (*data, "")
        if len(values) not in (1, 2):
            raise SlamlibError(f"plot takes y, or x and y, and a format; got {len(values)} arrays")
        chosen = {**format_of(form), **named("plot", style, (*COMMON, *STROKE, *MARKER))}
        y = np.atleast_1d(numbers("plot", "y", values[-1]))
        x = np.arange(len(y), dtype=float) if len(values) == 1 else np.atleast_1d(numbers("plot", "x", values[0]))
        if y.ndim == 1 and x.ndim == 1:
            return [self._line(x, y, chosen)]
        if y.ndim != 2 or x.ndim > 2:
            raise ShapeError(f"plot: y should be (N,) or (N, lines), but has shape {y.shape}")
        return [self._line(x if x.ndim == 1 else x[:, i], column, chosen) for i, column in enumerate(y.T)]

    def _line(self, x: Array, y: Array, style: dict[str, Any]) -> Line:
        if len(x) != len(y):
            raise ShapeError(f"plot: x and y should have the same length, got {len(x)} and {len(y)}")
        color = self._next("lines", style.get("color"))
        line = Line(x=x, y=y, stroke=stroke_of(style, color), marker=marker_of(style, color))
        return self._add(line, style)

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

    def scatter(self, x: Any, y: Any, s: Any = 36.0, c: Any = None, **style: Any) -> list[Line]:
        """Marks at points; s: area in square points, one or one each; c or color: one or one each."""
        chosen = named("scatter", style, (*COMMON, *SCATTERED))
        x, y, s = rows_of("scatter", x=x, y=y, s=s)
        shades = self._shades(chosen.pop("color", c), len(x))
        sizes = np.sqrt(s)
        found: list[Line] = []
        for shade, size in dict.fromkeys(zip(shades, sizes.tolist(), strict=True)):
            here = (np.array(shades) == shade) & (sizes == size)
            look = {"marker": "o", **{SCATTERED.get(k, k): v for k, v in chosen.items()}, "markersize": size}
            line = Line(x=x[here], y=y[here], stroke=None, marker=marker_of(look, shade), zorder=1.0)
            found.append(self._add(line, {**chosen, "label": None} if found else chosen))
        return found

    def _shades(self, given: Any, count: int) -> list[str]:
        """One colour for each of so many points."""
        if given is None or isinstance(given, str) or (len(given) == 3 != count and np.ndim(given) == 1):
            return [self._next("areas", given)] * count
        if len(given) != count:
            raise ShapeError(f"scatter: {count} points need one color or {count}, got {len(given)}")
        return [color_named(color) for color in given]

    def axhline(self, y: float = 0.0, xmin: float = 0.0, xmax: float = 1.0, **style: Any) -> Rule:
        """A line across the axes at y, from and to shares of their width."""
        return self._rule("axhline", 1, y, (xmin, xmax), style)

    def axvline(self, x: float = 0.0, ymin: float = 0.0, ymax: float = 1.0, **style: Any) -> Rule:
        """An upright line across the axes at x, from and to shares of their height."""
        return self._rule("axvline", 0, x, (ymin, ymax), style)

    def _rule(self, function: str, axis: int, value: float, reach: tuple[float, float], style: dict[str, Any]) -> Rule:
        chosen = named(function, style, (*COMMON, *STROKE))
        stroke = stroke_of(chosen, CYCLE[0])
        if stroke is None:
            raise SlamlibError(f"{function}: a line without a linestyle is none")
        place = float(row_of(function, "xy"[axis], value)[0])
        return self._add(Rule(axis=axis, value=place, stroke=stroke, reach=reach), chosen)
