"""Axes: marks, two scales, words around them; in matplotlib's names."""

from collections.abc import Callable
from itertools import groupby
from typing import Any

import numpy as np

from slambook.figures import frame
from slambook.figures.calls import Calls
from slambook.figures.canvas import Canvas
from slambook.figures.legend import Legend
from slambook.figures.paths import Box
from slambook.figures.scales import DataView
from slamlib.errors import SlamlibError, UnknownCallError, UnknownNameError
from slamlib.manifolds import Array


class Axes(Calls):
    """A rectangle with an x axis and a y axis; figure() makes it.

    Equal aspect is matplotlib's: adjustable "box" makes the rectangle smaller, "datalim" widens the limits.
    """

    def __init__(self) -> None:
        super().__init__()
        self.title, self.framed, self.ruled = "", True, True
        self.key: Legend | None = None
        self._setters: dict[str, Callable[[Any], None]] = {
            "title": lambda v: setattr(self, "title", str(v or "")),
            "aspect": self.set_aspect,
            "adjustable": lambda v: self.set_aspect(adjustable=v),
        }
        for axis in (self.x, self.y):
            self._setters |= {
                f"{axis.name}label": lambda v, axis=axis: setattr(axis, "label", str(v or "")),  # type: ignore[misc]
                f"{axis.name}lim": axis.set_ends,
                f"{axis.name}ticks": axis.set_places,
                f"{axis.name}ticklabels": axis.set_names,
                f"{axis.name}scale": axis.set_scale,
            }

    def set(self, **what: Any) -> None:
        """xlabel, ylabel, title; xlim, ylim (None: an end that follows the data); xticks, yticks, xticklabels,
        yticklabels; xscale, yscale ("linear", "log"); aspect ("auto", "equal"), adjustable ("box", "datalim")."""
        for name in what:
            if name not in self._setters:
                raise UnknownNameError.of("keyword of set", name, self._setters)
        for name, value in sorted(what.items(), key=lambda item: item[0].endswith("labels")):
            self._setters[name](value)

    def __getattr__(self, name: str) -> Any:
        """set_xlabel and the like; anything else is named in an UnknownCallError."""
        setters = self.__dict__.get("_setters", {})
        if name.startswith("set_") and name[4:] in setters:
            return lambda *value: setters[name[4:]](value[0] if len(value) == 1 else value)
        raise UnknownCallError.of_object("axes", name, self._known())

    def _known(self) -> list[str]:
        own = [n for n in dir(type(self)) if not n.startswith("_")]
        return [*dict.fromkeys([*own, *(f"set_{n}" for n in self.__dict__.get("_setters", {}))])]

    def set_xticks(self, ticks: Any, labels: Any = None) -> None:
        """Ticks of x at these numbers, with these labels."""
        self.x.set_places(ticks, labels)

    def set_yticks(self, ticks: Any, labels: Any = None) -> None:
        """Ticks of y at these numbers, with these labels."""
        self.y.set_places(ticks, labels)

    def set_aspect(self, aspect: Any = None, adjustable: str | None = None) -> None:
        """ "equal" (or 1): a metre is a metre on both axes; "auto"; adjustable: the "box" gives way, or "datalim"."""
        if aspect not in (None, "auto", "equal", 1):
            raise UnknownNameError.of("aspect", aspect, ("auto", "equal"))
        if adjustable not in (None, "box", "datalim"):
            raise UnknownNameError.of("adjustable", adjustable, ("box", "datalim"))
        self.equal = self.equal if aspect is None else aspect != "auto"
        self.adjustable = adjustable or self.adjustable

    def invert_xaxis(self) -> None:
        """Let x grow to the left."""
        self.x.inverted = not self.x.inverted

    def invert_yaxis(self) -> None:
        """Let y grow downwards, as in images."""
        self.y.inverted = not self.y.inverted

    def axis(self, what: str) -> None:
        """ "off": no frame, ticks or labels; "on"; "equal": a metre is a metre on both axes, whose limits give way."""
        if what not in ("off", "on", "equal"):
            raise UnknownNameError.of("axis", what, ("off", "on", "equal"))
        if what == "equal":
            self.set_aspect("equal", "datalim")
        else:
            self.framed = what == "on"

    def grid(self, visible: bool = True) -> None:
        """Lines at the ticks, or none."""
        self.ruled = bool(visible)

    def legend(self, handles: Any = None, labels: Any = None, **options: Any) -> Legend:
        """What the labelled marks are called: loc, ncols, bbox_to_anchor, title, fontsize, markerscale: see Legend.

        handles, labels: other marks, other words; a list of words alone is taken for the labels.
        """
        if labels is None and handles is not None and all(isinstance(h, str) for h in handles):
            handles, labels = self.marks, handles
        named = [m for m in self.marks if m.label and not m.label.startswith("_")] if handles is None else handles
        marks = [part[0] if isinstance(part, list) else part for part in named]
        words = [m.label for m in marks] if labels is None else [str(label) for label in labels]
        self.key = Legend.of(options, list(zip(marks, words, strict=False)))
        return self.key

    # -- for the figure ------------------------------------------------------------------------------------------------

    def get_xlim(self) -> tuple[float, float]:
        """First and last x shown, before equal aspect is seen to."""
        return self._limits()[0]

    def get_ylim(self) -> tuple[float, float]:
        """First and last y shown, before equal aspect is seen to."""
        return self._limits()[1]

    def _limits(self) -> list[tuple[float, float]]:
        bounds = np.array([m.bounds(self.x.scale, self.y.scale) for m in self.marks] or [np.full((2, 2), np.nan)])
        found = []
        for i, axis in enumerate((self.x, self.y)):
            low, high = (v[np.isfinite(v)] for v in bounds[:, i].T)
            ends = np.array([low.min(), high.max()]) if low.size else np.array([np.nan, np.nan])
            found.append(axis.limits(ends, tuple(v for m in self.marks for v in m.tight[i])))
        return found

    def view(self, box: Box) -> DataView:
        """The axes in a place of the sheet, with equal aspect if that is wanted."""
        xlim, ylim = self._limits()
        if self.equal:
            box, xlim, ylim = self._equal(box, xlim, ylim)
        return DataView(box, xlim, ylim, self.x.scale, self.y.scale)

    def _equal(self, box: Box, xlim: Any, ylim: Any) -> tuple[Box, tuple[float, float], tuple[float, float]]:
        if self.x.scale is not self.y.scale:
            raise SlamlibError("equal aspect needs both axes linear, or both logarithmic")
        left, top, right, bottom = box
        spans = [abs(float(np.diff(self.x.scale.forward(np.array(lim)))[0])) for lim in (xlim, ylim)]
        wide, high = (right - left) / spans[0], (bottom - top) / spans[1]  # points per unit
        if self.adjustable == "datalim":
            if wide > high:
                return box, self._widened(xlim, wide / high), ylim
            return box, xlim, self._widened(ylim, high / wide)
        cut_x, cut_y = (right - left) * max(0, 1 - high / wide) / 2, (bottom - top) * max(0, 1 - wide / high) / 2
        return (left + cut_x, top + cut_y, right - cut_x, bottom - cut_y), xlim, ylim

    def _widened(self, limits: tuple[float, float], factor: float) -> tuple[float, float]:
        a, b = self.x.scale.forward(np.array(limits))
        middle, half = (a + b) / 2, (b - a) / 2 * factor
        low, high = self.x.scale.backward(np.array([middle - half, middle + half]))
        return float(low), float(high)

    def room(self, box: Box, sheet: tuple[float, float]) -> Array:
        """Points that words need to the left, above, to the right and below."""
        view = self.view(box)
        needed = [frame.room(self, view), *(mark.room(view) for mark in self.marks)]
        if self.key is not None:
            needed.append(self.key.room(view, sheet))
        return np.max(needed, axis=0)

    def draw(self, canvas: Canvas, box: Box) -> None:
        """Put all on the sheet."""
        view = self.view(box)
        frame.draw_grid(self, canvas, view)
        if any(mark.gid for mark in self.marks):
            with canvas.group(view=view.written()):
                self._draw_marks(canvas, view)
        else:
            self._draw_marks(canvas, view)
        frame.draw_frame(self, canvas, view)
        if self.key is not None:
            self.key.draw(self.marks, canvas, view)

    def _draw_marks(self, canvas: Canvas, view: DataView) -> None:
        for clip, marks in groupby(sorted(self.marks, key=lambda m: m.zorder), lambda m: m.clip):
            with canvas.group(clip=view.box if clip else None):
                for mark in marks:
                    if mark.gid:
                        with canvas.group(part=mark.gid):
                            mark.draw(canvas, view)
                    else:
                        mark.draw(canvas, view)

    def described(self) -> str:
        """What its words say."""
        named = " over ".join(filter(None, (self.y.label, self.x.label)))
        return ": ".join(filter(None, (self.title, named)))
