"""One axis: its scale, its limits as far as they are set, and its ticks."""

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from slambook.figures.scales import SCALES, Scale, spread
from slambook.figures.style import row_of
from slambook.figures.words import width_of
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

SIZE = 10.6  # of the ticks' labels, in points
MOST = 7  # ticks, unless there is room for fewer only


@dataclass(frozen=True)
class Ticks:
    """Where an axis has its marks, what they say, and where the small marks are."""

    places: Array
    labels: list[str]
    minor: Array


@dataclass
class Axis:
    """The x or the y axis; an end that is None follows the data."""

    name: str
    scale: Scale = SCALES["linear"]
    ends: tuple[float | None, float | None] = (None, None)
    inverted: bool = False
    label: str = ""
    places: Array | None = None
    names: list[str] | None = None

    def set_scale(self, name: str) -> None:
        """To "linear" or "log"; raises UnknownNameError."""
        if name not in SCALES:
            raise UnknownNameError.of(f"{self.name}scale", name, SCALES)
        self.scale = SCALES[name]

    def set_ends(self, ends: Any) -> None:
        """To (low, high); None leaves an end to the data. Raises SlamlibError."""
        if ends is None or len(ends) != 2:
            raise SlamlibError(f"{self.name}lim should be two numbers, or None for an end that follows the data")
        low, high = (None if e is None else float(row_of(f"{self.name}lim", "an end", e)[0]) for e in ends)
        if (low is not None and low == high) or not np.all(np.isfinite([v for v in (low, high) if v is not None])):
            raise SlamlibError(f"{self.name}lim: the ends should be two different numbers, got {low} and {high}")
        self.ends, self.inverted = (low, high), self.inverted and None in (low, high)

    def set_places(self, places: Any, names: Any = None) -> None:
        """Ticks at these numbers, with these names; no ticks for an empty list."""
        self.places = np.atleast_1d(row_of(f"{self.name}ticks", "places", list(places)))
        if names is not None:
            self.set_names(names)

    def set_names(self, names: Any) -> None:
        """What the ticks say, an empty list: nothing, wherever they are; raises ShapeError."""
        self.names = [str(name) for name in names]
        if self.names and (self.places is None or len(self.places) != len(self.names)):
            raise ShapeError(f"{self.name}ticklabels: give {self.name}ticks first, as many as labels")

    @property
    def free(self) -> bool:
        """Whether both ends follow the data."""
        return self.ends == (None, None)

    def limits(self, bounds: Array, tight: tuple[float, ...]) -> tuple[float, float]:
        """First and last number shown, for data within bounds; no margin beyond the values in tight."""
        low, high = float(bounds[0]), float(bounds[1])
        found = spread(low, high, self.scale, (low in tight, high in tight))
        if self.places is not None and len(self.places):
            found = min(found[0], float(self.places.min())), max(found[1], float(self.places.max()))
        a, b = (auto if end is None else end for auto, end in zip(found, self.ends, strict=True))
        if a >= b and None in self.ends:  # one end is set, beyond the data
            a, b = (a, spread(a, a, self.scale)[1]) if self.ends[0] is not None else (spread(b, b, self.scale)[0], b)
        if self.scale.positive and min(a, b) <= 0:
            raise SlamlibError(f"a logarithmic axis cannot span {a:g} to {b:g}: both ends must be positive")
        return (b, a) if self.inverted else (a, b)

    def ticks(self, limits: tuple[float, float], length: float, across: bool) -> Ticks:
        """Ticks for limits along so many points, across the sheet or up."""
        low, high = min(limits), max(limits)
        if self.places is None:
            found = automatic(self.scale, low, high, length, across)
            return found if self.names is None else replace(found, labels=[""] * len(found.places))
        places = self.places[(self.places >= low) & (self.places <= high)]
        if not self.names:
            labels = self.scale.labels(places) if self.names is None else [""] * len(places)
            return Ticks(places, labels, np.empty(0))
        names = [name for place, name in zip(self.places, self.names, strict=True) if place in places]
        return Ticks(places, names, np.empty(0))


@lru_cache(maxsize=256)
def automatic(scale: Scale, low: float, high: float, length: float, across: bool) -> Ticks:
    """As many ticks as there is room for between their labels."""
    for most in range(MOST, 3, -1):
        places = scale.ticks(low, high, most)
        names = scale.labels(places)
        steps = np.abs(np.diff(scale.forward(places))) / np.ptp(scale.forward(np.array([low, high])))
        needed = max((width_of(name, SIZE) + 6 if across else 1.6 * SIZE for name in names), default=0.0)
        if min(steps, default=1.0) * length >= needed:
            break
    else:
        names = [name if i % 2 == 0 else "" for i, name in enumerate(names)]
    return Ticks(places, names, scale.minor(low, high, places))
