"""The calls that put something into axes, with matplotlib's names and arguments: lines, areas, images, words."""

from typing import Any, TypeVar

import numpy as np

from slambook.figures.axis import Axis
from slambook.figures.colors import CYCLE, color_named, colors
from slambook.figures.images import Image, pixels_of
from slambook.figures.marks import Across, Area, Edges, Line, Mark
from slambook.figures.notes import ARROWS, PLACES, Arrow, Words
from slambook.figures.paths import pieces
from slambook.figures.style import (
    COMMON,
    FILL,
    LETTERS,
    MARKER,
    STROKE,
    alpha_of,
    fill_of,
    format_of,
    lettering_of,
    marker_of,
    named,
    numbers,
    positive,
    row_of,
    rows_of,
    stroke_of,
)
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

M = TypeVar("M", bound=Mark)


class Calls:
    """A list of marks; colours that are not given come from the palette, one after the other."""

    transAxes = "axes fraction"
    transData = "data"

    def __init__(self) -> None:
        self.marks: list[Mark] = []
        self.x, self.y = Axis("x"), Axis("y")
        self.equal, self.adjustable = False, "box"
        self._turns = {"lines": 0, "areas": 0}

    def _add(self, mark: M, style: dict[str, Any]) -> M:
        mark.label = "" if style.get("label") is None else str(style["label"])
        mark.zorder = mark.zorder if style.get("zorder") is None else float(style["zorder"])
        mark.clip = bool(style.get("clip_on", mark.clip))
        mark.gid = "" if style.get("gid") is None else str(style["gid"])
        self.marks.append(mark)
        return mark

    def _next(self, kind: str, given: Any) -> str:
        """The colour that is asked for, or the next of the palette."""
        if given is not None:
            return color_named(given)
        self._turns[kind] += 1
        return CYCLE[(self._turns[kind] - 1) % len(CYCLE)]

    # -- lines ---------------------------------------------------------------------------------------------------------

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

    def axhline(self, y: float = 0.0, xmin: float = 0.0, xmax: float = 1.0, **style: Any) -> Across:
        """A line across the axes at y, from and to shares of their width."""
        return self._across("axhline", 1, y, style, (xmin, xmax))

    def axvline(self, x: float = 0.0, ymin: float = 0.0, ymax: float = 1.0, **style: Any) -> Across:
        """An upright line across the axes at x, from and to shares of their height."""
        return self._across("axvline", 0, x, style, (ymin, ymax))

    def axhspan(self, ymin: float, ymax: float, **style: Any) -> Across:
        """A band across the axes from ymin to ymax."""
        return self._across("axhspan", 1, [ymin, ymax], style)

    def axvspan(self, xmin: float, xmax: float, **style: Any) -> Across:
        """An upright band across the axes from xmin to xmax."""
        return self._across("axvspan", 0, [xmin, xmax], style)

    def _across(
        self, function: str, axis: int, ends: Any, style: dict[str, Any], reach: tuple[float, float] = (0.0, 1.0)
    ) -> Across:
        """A line at one number, a band between two."""
        band = function.endswith("span")
        chosen = named(function, style, (*COMMON, *(FILL if band else STROKE)))
        look = (fill_of if band else stroke_of)(chosen, CYCLE[0])
        if look is None:
            raise SlamlibError(f"{function}: a line without a linestyle is none")
        values = tuple(float(v) for v in row_of(function, "ends" if band else "xy"[axis], ends))
        mark = Across(axis=axis, values=values, look=look, reach=reach, zorder=1.0 if band else 2.0)
        return self._add(mark, chosen)

    # -- areas and images ----------------------------------------------------------------------------------------------

    def fill(self, x: Any, y: Any, **style: Any) -> Area:
        """The area inside a closed line; nan parts it."""
        return self._area("fill", pieces(np.stack(rows_of("fill", x=x, y=y))), style)

    def _area(self, function: str, rings: list[Array], style: dict[str, Any], tight: Edges = ((), ())) -> Area:
        chosen = named(function, style, (*COMMON, *FILL))
        inside = chosen.get("color") if chosen.get("facecolor") is None else chosen["facecolor"]
        return self._add(Area(rings=rings, fill=fill_of(chosen, self._next("areas", inside)), tight=tight), chosen)

    def imshow(
        self,
        array: Any,
        cmap: str = "gray",
        *,
        extent: Any = None,
        origin: str = "upper",
        vmin: float | None = None,
        vmax: float | None = None,
        interpolation: str = "nearest",
        aspect: str = "equal",
        **style: Any,
    ) -> Image:
        """Pixels (rows, columns) of numbers or (rows, columns, 3 or 4) of colours; y points down unless origin="lower".

        extent: (left, right, bottom, top) in data units, by default half a pixel around whole ones.
        """
        chosen = named("imshow", style, COMMON)
        if origin not in ("upper", "lower"):
            raise UnknownNameError.of("origin of imshow", origin, ("upper", "lower"))
        pixels = pixels_of(array, cmap, vmin, vmax)
        rows, columns = pixels.shape[:2]
        ends = (rows - 0.5, -0.5) if origin == "upper" else (-0.5, rows - 0.5)
        left, right, bottom, top = row_of(
            "imshow", "extent", (-0.5, columns - 0.5, *ends) if extent is None else extent
        )
        for axis, backwards in ((self.x, left > right), (self.y, bottom > top)):
            axis.inverted = bool(backwards) if axis.free else axis.inverted
        self.equal = aspect == "equal"
        across, along = (float(left), float(right)), (float(bottom), float(top))
        image = Image(
            pixels=pixels,
            extent=(*across, *along),
            tight=(across, along),
            lower=origin == "lower",
            smooth=interpolation not in ("nearest", "none", "antialiased", "auto"),
            alpha=alpha_of(chosen),
        )
        return self._add(image, chosen)

    # -- words ---------------------------------------------------------------------------------------------------------

    def text(self, x: float, y: float, s: str, *, transform: str = "data", **style: Any) -> Words:
        """Words at a point; transform: ax.transData, or ax.transAxes for shares of the axes' width and height."""
        return self._words("text", (x, y), s, transform, named("text", style, LETTERS))

    def annotate(
        self,
        text: str,
        xy: Any,
        xytext: Any = None,
        *,
        xycoords: str = "data",
        textcoords: str | None = None,
        arrowprops: dict[str, Any] | None = None,
        **style: Any,
    ) -> Words:
        """Words at xytext (default: xy), with an arrow to xy if arrowprops says how: arrowstyle, color, lw, ls.

        xycoords, textcoords: "data", "axes fraction"; textcoords also "offset points", counted from xy.
        """
        chosen = named("annotate", style, LETTERS)
        moved = (0.0, 0.0)
        spot = xy if xytext is None else xytext
        if textcoords == "offset points":
            right, up = row_of("annotate", "xytext", spot)
            spot, moved, textcoords = xy, (float(right), float(up)), xycoords
        words = self._words("annotate", spot, text, textcoords or xycoords, chosen)
        words.moved = moved
        if arrowprops is not None:
            self._arrow(words, xy, xycoords, arrowprops)
        return words

    def _words(self, function: str, xy: Any, text: str, place: str, style: dict[str, Any]) -> Words:
        pair = row_of(function, "the place", xy)
        if pair.shape != (2,):
            raise ShapeError(f"{function}: a place is two numbers, got {len(pair)}")
        if place not in PLACES:
            raise UnknownNameError.of(f"place in {function}", place, PLACES)
        return self._add(Words(xy=pair, text=str(text), look=lettering_of(style), place=PLACES[place]), style)

    def _arrow(self, words: Words, xy: Any, place: str, given: dict[str, Any]) -> Arrow:
        known = ("arrowstyle", "color", "linewidth", "linestyle", "alpha", "shrinkA", "shrinkB")
        style = named("arrowprops", given, known)
        kind = style.get("arrowstyle", "->")
        if kind not in ARROWS:
            raise UnknownNameError.of("arrowstyle", kind, ARROWS)
        stroke = stroke_of(style, colors.text, 1.0)
        if stroke is None:
            raise SlamlibError("annotate: an arrow without a linestyle is none")
        arrow = Arrow(
            words=words,
            xy=row_of("annotate", "xy", xy),
            place=PLACES[place],
            stroke=stroke,
            heads=ARROWS[kind],
            gap=(positive(style, "shrinkA", 2.0), positive(style, "shrinkB", 2.0)),
        )
        return self._add(arrow, {})
