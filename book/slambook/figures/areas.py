"""The calls that draw areas, with matplotlib's names and arguments."""

from typing import Any

import numpy as np

from slambook.figures.colors import CYCLE
from slambook.figures.data import row_of, rows_of
from slambook.figures.holder import Holder
from slambook.figures.marks import Area, Edges, Span
from slambook.figures.paths import pieces
from slambook.figures.style import COMMON, FILL, fill_of, named
from slamlib.errors import UnknownNameError
from slamlib.manifolds import Array


class Areas(Holder):
    """Areas under and between curves, bars, bands across the axes."""

    def _area(self, function: str, rings: list[Array], style: dict[str, Any], tight: Edges = ((), ())) -> Area:
        chosen = named(function, style, (*COMMON, *FILL))
        return self._add(
            Area(rings=rings, fill=fill_of(chosen, self._next("areas", _inside(chosen))), tight=tight), chosen
        )

    def fill(self, x: Any, y: Any, **style: Any) -> Area:
        """The area inside a closed line."""
        return self._area("fill", pieces(np.stack(rows_of("fill", x=x, y=y))), style)

    def fill_between(self, x: Any, y1: Any, y2: Any = 0.0, where: Any = None, **style: Any) -> Area:
        """The area between two curves over x, as far as `where` is true."""
        x, y1, y2 = rows_of("fill_between", x=x, y1=y1, y2=y2)
        shown = np.where(np.ones(len(x)) if where is None else np.asarray(where), 1.0, np.nan)
        rings = [np.concatenate([p[[0, 1]], p[[0, 2]][:, ::-1]], axis=1) for p in pieces(np.stack([x, y1, y2]) * shown)]
        return self._area("fill_between", rings, style)

    def bar(
        self, x: Any, height: Any, width: Any = 0.8, bottom: Any = 0.0, *, align: str = "center", **style: Any
    ) -> Area:
        """Upright bars; align: x is a bar's "center" or its left "edge"."""
        x, height, width, bottom = rows_of("bar", x=x, height=height, width=width, bottom=bottom)
        if align not in ("center", "edge"):
            raise UnknownNameError.of("align of bar", align, ("center", "edge"))
        left = x - width / 2 * (align == "center")
        sides = [left, left, left + width, left + width], [bottom, bottom + height, bottom + height, bottom]
        rings = list(np.array(sides).transpose(2, 0, 1))
        return self._area("bar", [r for r in rings if np.all(np.isfinite(r))], style, ((), tuple(bottom.tolist())))

    def hist(self, values: Any, bins: Any = 10, *, density: bool = False, range: Any = None, **style: Any) -> Any:
        """Bars of how many values fall into each bin; returns (counts, edges, bars)."""
        counts, edges = np.histogram(row_of("hist", "values", values), bins=bins, density=density, range=range)
        bars = self.bar(edges[:-1], counts, np.diff(edges), align="edge", **style)
        return counts, edges, bars

    def axhspan(self, ymin: float, ymax: float, **style: Any) -> Span:
        """A band across the axes from ymin to ymax."""
        return self._span("axhspan", 1, ymin, ymax, style)

    def axvspan(self, xmin: float, xmax: float, **style: Any) -> Span:
        """An upright band across the axes from xmin to xmax."""
        return self._span("axvspan", 0, xmin, xmax, style)

    def _span(self, function: str, axis: int, low: float, high: float, style: dict[str, Any]) -> Span:
        chosen = named(function, style, (*COMMON, *FILL))
        low, high = (float(v) for v in row_of(function, "ends", [low, high]))
        return self._add(Span(axis=axis, low=low, high=high, fill=fill_of(chosen, CYCLE[0])), chosen)


def _inside(style: dict[str, Any]) -> Any:
    """The colour that is asked for, of the inside if it has one of its own."""
    return style.get("color") if style.get("facecolor") is None else style["facecolor"]
