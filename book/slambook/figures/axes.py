"""Axes: marks, two scales, words around them; in matplotlib's names."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slambook.figures import frame
from slambook.figures.areas import Areas
from slambook.figures.callouts import Callouts
from slambook.figures.canvas import Canvas
from slambook.figures.fields import Fields
from slambook.figures.legend import Legend
from slambook.figures.lines import Lines
from slambook.figures.paths import Box
from slambook.figures.scales import View
from slamlib.errors import SlamlibError, UnknownCallError, UnknownNameError
from slamlib.manifolds import Array


class Axes(Lines, Areas, Fields, Callouts):
    """A rectangle with an x axis and a y axis; figure() makes it.

    Equal aspect: axes whose limits follow the data are widened until they fill their place; if the limits are set, the
    rectangle is made smaller, as matplotlib does it.
    """

    def __init__(self, equal: bool = False) -> None:
        super().__init__()
        self.equal, self.title, self.framed, self.ruled = equal, "", True, True
        self.key: Legend | None = None
        self._setters: dict[str, Callable[[Any], None]] = {
            "title": lambda v: setattr(self, "title", str(v or "")),
            "aspect": self._aspect,
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
        yticklabels; xscale, yscale ("linear", "log"); aspect ("auto", "equal")."""
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
        known = [n for n in dir(type(self)) if not n.startswith("_")] + [f"set_{n}" for n in setters]
        raise UnknownCallError.of_object("axes", name, known)

    def _aspect(self, value: str) -> None:
        if value not in ("auto", "equal"):
            raise UnknownNameError.of("aspect", value, ("auto", "equal"))
        self.equal = value == "equal"

    def invert_xaxis(self) -> None:
        """Let x grow to the left."""
        self.x.inverted = not self.x.inverted

    def invert_yaxis(self) -> None:
        """Let y grow downwards, as in images."""
        self.y.inverted = not self.y.inverted

    def axis(self, what: str) -> None:
        """ "off": no frame, ticks or labels; "on"; "equal": a metre is a metre on both axes."""
        if what not in ("off", "on", "equal"):
            raise UnknownNameError.of("axis", what, ("off", "on", "equal"))
        self.framed, self.equal = (self.framed, True) if what == "equal" else (what == "on", self.equal)

    def grid(self, visible: bool = True) -> None:
        """Lines at the ticks, or none."""
        self.ruled = bool(visible)

    def legend(self, **options: Any) -> Legend:
        """What the labelled marks are called: loc, ncols, bbox_to_anchor, title, fontsize, markerscale: see Legend."""
        self.key = Legend.of(options)
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

    def view(self, box: Box) -> View:
        """The axes in a place of the sheet, with equal aspect if that is wanted."""
        xlim, ylim = self._limits()
        if self.equal:
            box, xlim, ylim = self._equal(box, xlim, ylim)
        return View(box, xlim, ylim, self.x.scale, self.y.scale)

    def _equal(self, box: Box, xlim: Any, ylim: Any) -> tuple[Box, tuple[float, float], tuple[float, float]]:
        if self.x.scale is not self.y.scale:
            raise SlamlibError("equal aspect needs both axes linear, or both logarithmic")
        left, top, right, bottom = box
        spans = [abs(float(np.diff(self.x.scale.forward(np.array(lim)))[0])) for lim in (xlim, ylim)]
        wide, high = (right - left) / spans[0], (bottom - top) / spans[1]  # points per unit
        if wide > high and self._free(0, xlim):
            return box, self._widened(xlim, wide / high), ylim
        if high > wide and self._free(1, ylim):
            return box, xlim, self._widened(ylim, high / wide)
        cut_x, cut_y = (right - left) * max(0, 1 - high / wide) / 2, (bottom - top) * max(0, 1 - wide / high) / 2
        return (left + cut_x, top + cut_y, right - cut_x, bottom - cut_y), xlim, ylim

    def _free(self, index: int, limits: tuple[float, float]) -> bool:
        """Whether an axis follows the data, and the data (an image, say) do not fill it from end to end."""
        filled = {v for m in self.marks for v in m.tight[index]}
        return (self.x, self.y)[index].free and not set(limits) <= filled

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
            needed.append(self.key.room(self.marks, view, sheet))
        return np.max(needed, axis=0)

    def draw(self, canvas: Canvas, box: Box) -> None:
        """Put all on the sheet."""
        view = self.view(box)
        frame.draw_grid(self, canvas, view)
        self._draw_marks(canvas, view)
        frame.draw_frame(self, canvas, view)
        if self.key is not None:
            self.key.draw(self.marks, canvas, view)

    def _draw_marks(self, canvas: Canvas, view: View) -> None:
        ordered = sorted(self.marks, key=lambda m: m.zorder)
        while ordered:
            clip = ordered[0].clip
            count = next((i for i, m in enumerate(ordered) if m.clip != clip), len(ordered))
            with canvas.group(clip=view.box if clip else None) if clip else canvas.group():
                for mark in ordered[:count]:
                    mark.draw(canvas, view)
            ordered = ordered[count:]

    def described(self) -> str:
        """What its words say."""
        named = " over ".join(filter(None, (self.y.label, self.x.label)))
        return ": ".join(filter(None, (self.title, named)))
