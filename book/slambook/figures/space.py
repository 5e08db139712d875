"""Axes in three dimensions, with matplotlib's names."""

from typing import Any

import numpy as np

from slambook.figures import box3d
from slambook.figures.canvas import Canvas
from slambook.figures.data import row_of, rows_of
from slambook.figures.holder import Holder
from slambook.figures.legend import Legend
from slambook.figures.marks3d import Line3d, Mark3d, Words3d, drawn
from slambook.figures.paths import Box
from slambook.figures.projection import Projection, view_axes
from slambook.figures.scales import SCALES, View, spread
from slambook.figures.style import (
    MARKER,
    STROKE,
    format_of,
    lettering_of,
    marker_of,
    named,
    positive,
    stroke_of,
)
from slambook.figures.words import Lettering
from slamlib.errors import SlamlibError, UnknownCallError, UnknownNameError
from slamlib.manifolds import Array

NAMES = ("x", "y", "z")
ROOM = np.array([34.0, 8.0, 24.0, 30.0])  # points for words to the left of the box, above, to the right, below


class Space(Holder):
    """A box with x, y and z axes, seen from far away; figure3d() makes it.

    A metre is a metre on each axis, unless set(aspect="auto") makes the box a cube: `equal` changes nothing here.
    """

    def __init__(self, equal: bool = True) -> None:
        super().__init__()
        self.marks3d: list[Mark3d] = []
        self.ends: dict[str, Any] = dict.fromkeys(NAMES)
        self.words = dict.fromkeys((*(f"{n}label" for n in NAMES), "title"), "")
        self.elevation, self.azimuth, self.equal, self.framed = 22.0, -58.0, True, True
        self.key: Legend | None = None

    def plot(self, x: Any, y: Any, z: Any, form: str = "", **style: Any) -> list[Line3d]:
        """A line through points, with a format as "o-"; nan breaks it."""
        chosen = {**format_of(form), **named("plot", style, ("alpha", "label", *STROKE, *MARKER))}
        color = self._next("lines", chosen.get("color"))
        data = np.stack(rows_of("plot", x=x, y=y, z=z))
        return [self._put(Line3d(data, stroke_of(chosen, color), marker_of(chosen, color)), chosen)]

    def scatter(self, x: Any, y: Any, z: Any, s: float = 20.0, **style: Any) -> Line3d:
        """Marks at points; s: area in square points."""
        chosen = {"marker": "o", **named("scatter", style, ("alpha", "label", "color", "marker"))}
        color = self._next("areas", chosen.get("color"))
        size = float(np.sqrt(positive({"s": s}, "s", s)))
        data = np.stack(rows_of("scatter", x=x, y=y, z=z))
        return self._put(Line3d(data, None, marker_of({**chosen, "markersize": size}, color)), chosen)

    def text(self, x: float, y: float, z: float, s: str, **style: Any) -> Words3d:
        """Words at a point of space."""
        chosen = named("text", style, ("color", "fontsize", "ha", "va", "rotation"))
        place = np.stack(rows_of("text", x=x, y=y, z=z))
        return self._put(Words3d(place, str(s), lettering_of(chosen)), chosen)

    def _put(self, mark: Any, style: dict[str, Any]) -> Any:
        mark.label = "" if style.get("label") is None else str(style["label"])
        self.marks3d.append(mark)
        return mark

    def set(self, **what: Any) -> None:
        """xlabel, ylabel, zlabel, title; xlim, ylim, zlim; aspect ("equal", or "auto" for a cube)."""
        for name, value in what.items():
            if name in self.words:
                self.words[name] = str(value or "")
            elif name in (f"{n}lim" for n in NAMES):
                low, high = row_of(name, "the ends", value)
                if not low < high:
                    raise SlamlibError(f"{name}: the ends should grow, got {low:g} and {high:g}")
                self.ends[name[0]] = (float(low), float(high))
            elif name == "aspect" and value in ("auto", "equal"):
                self.equal = value == "equal"
            else:
                raise UnknownNameError.of("keyword of set", name, [*self.words, "xlim", "ylim", "zlim", "aspect"])

    def __getattr__(self, name: str) -> Any:
        settable = [*self.__dict__.get("words", ()), "xlim", "ylim", "zlim", "aspect"]
        if name.startswith("set_") and name[4:] in settable:
            return lambda *value: self.set(**{name[4:]: value[0] if len(value) == 1 else value})
        known = [n for n in dir(type(self)) if not n.startswith("_")] + [f"set_{n}" for n in settable]
        raise UnknownCallError.of_object("axes in space", name, known)

    def view_init(self, elev: float = 22.0, azim: float = -58.0) -> None:
        """Where the viewer is: degrees above the x-y plane, and degrees from the x axis about z."""
        self.elevation, self.azimuth = float(elev), float(azim)

    def legend(self, **options: Any) -> Legend:
        """What the labelled marks are called; see Legend."""
        self.key = Legend.of(options)
        return self.key

    def axis(self, what: str) -> None:
        """ "off": the marks alone, without their box; "on"."""
        if what not in ("off", "on"):
            raise UnknownNameError.of("axis", what, ("off", "on"))
        self.framed = what == "on"

    # -- for the figure ------------------------------------------------------------------------------------------------

    def limits(self) -> Array:
        """Least and greatest x, y and z shown (3, 2)."""
        data = np.concatenate([np.full((3, 1), np.nan), *(m.data for m in self.marks3d if m.counts)], axis=1)
        found = []
        for name, row in zip(NAMES, data, strict=True):
            shown = row[np.isfinite(row)]
            ends = (float(shown.min()), float(shown.max())) if shown.size else (np.nan, np.nan)
            found.append(self.ends[name] or spread(*ends, SCALES["linear"]))
        return np.array(found)

    def projection(self, box: Box) -> Projection:
        """From data to the sheet, for axes in this place."""
        return Projection.of(self.limits(), view_axes(self.elevation, self.azimuth), box, self.equal)

    def room(self, box: Box, sheet: tuple[float, float]) -> Array:
        """Points that words need to the left, above, to the right and below."""
        return ROOM * self.framed + np.array([0.0, 18.0 * bool(self.words["title"]), 0.0, 0.0])

    def draw(self, canvas: Canvas, box: Box) -> None:
        """Put all on the sheet, the farthest first."""
        projection = self.projection(box)
        if self.framed:
            labels = [self.words[f"{n}label"] for n in NAMES]
            box3d.draw_box(canvas, projection, labels)
        drawn(self.marks3d, canvas, projection)
        left, top, right, _ = box
        canvas.text((left + right) / 2, top - 5, self.words["title"], Lettering(11.5, ha="center", va="bottom"))
        if self.key is not None:
            whole = View(box, (box[0], box[2]), (box[3], box[1]), SCALES["linear"], SCALES["linear"])
            self.key.draw([m.flat(projection) for m in self.marks3d], canvas, whole)

    def described(self) -> str:
        """What its words say."""
        return ", ".join(filter(None, self.words.values()))
