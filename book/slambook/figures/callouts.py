"""The calls that put words into axes, with matplotlib's names and arguments."""

from typing import Any

from slambook.figures.colors import colors
from slambook.figures.data import row_of
from slambook.figures.holder import Holder
from slambook.figures.notes import ARROWS, PLACES, Arrow, Words
from slambook.figures.style import LETTERS, lettering_of, named, positive, stroke_of
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError


class Callouts(Holder):
    """Words, and arrows from them to points."""

    transAxes = "axes fraction"
    transData = "data"

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
        words = Words(
            xy=pair,
            text=str(text),
            look=lettering_of(style),
            place=PLACES[place],
        )
        return self._add(words, style)

    def _arrow(self, words: Words, xy: Any, place: str, given: dict[str, Any]) -> Arrow:
        style = named("arrowprops", given, ("arrowstyle", "color", "linewidth", "linestyle", "alpha", *_GAPS))
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


_GAPS = ("shrinkA", "shrinkB")
