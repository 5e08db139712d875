"""Two front ends for one camera: one for points, one for segments."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.data.records import Scan
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import Sight
from slamlib.slam.options import Options
from slamlib.vision.active_search import ActiveSearch, Settings
from slamlib.vision.appearance import Appearance
from slamlib.vision.line_search import EdgeLook, SegmentSearch

# Which family's front end gave a signature of this type.
SIGNATURES: dict[type, str] = {Appearance: "points", EdgeLook: "segments"}


class Both:
    """Forwards what the filter asks to the front end of the family that it asks about."""

    def __init__(self, points: ActiveSearch, segments: SegmentSearch) -> None:
        self.of: dict[str, Any] = {"points": points, "segments": segments}

    @property
    def settings(self) -> Any:
        """Those of the points' search."""
        return self.of["points"].settings

    @property
    def seconds(self) -> dict[str, float]:
        """Spent so far, by both, in "search" and in "detection"."""
        return {part: sum(f.seconds[part] for f in self.of.values()) for part in ("search", "detection")}

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that one of them cannot look at."""
        for front_end in self.of.values():
            front_end.check(scan)

    def findable(self, sight: Sight) -> list[Any]:
        """The looks that their front ends could find."""
        return [look for name, f in self.of.items() for look in f.findable(_own(sight, name))]

    def match(self, sight: Sight, family: str, looks: list[Any]) -> tuple[Array, Mask]:
        """What the family's front end finds of them."""
        found: tuple[Array, Mask] = self.of[family].match(_own(sight, family), family, looks)
        return found

    def detect(
        self, sight: Sight, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[tuple[int, Array, Any]]:
        """What the family's front end begins, with numbers that neither of them has given before."""
        self._count_together()
        found: list[tuple[int, Array, Any]] = self.of[family].detect(_own(sight, family), family, known, usable, count)
        return found

    def adopt(self, sight: Sight, family: str, values: Array) -> list[tuple[int, Array, Any] | None]:
        """Landmarks at given values; only points can be adopted."""
        self._count_together()
        found: list[tuple[int, Array, Any] | None] = self.of[family].adopt(_own(sight, family), family, values)
        return found

    def _count_together(self) -> None:
        last = max(f.last for f in self.of.values())
        for front_end in self.of.values():
            front_end.last = last

    def dump(self) -> Any:
        """The states of both, by family."""
        return {name: f.dump() for name, f in self.of.items()}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        for name, f in self.of.items():
            f.restore(state[name])

    def pack(self, signature: Any) -> Any:
        """A signature as plain data, with the family whose front end gave it."""
        name = SIGNATURES[type(signature)]
        return {"family": name, "signature": self.of[name].pack(signature)}

    def unpack(self, packed: Any) -> Any:
        """The signature that `pack` packed."""
        return self.of[packed["family"]].unpack(packed["signature"])


def front_end_of(
    options: Options, calibration: Calibration, rng: np.random.Generator, settings: Settings | None = None
) -> ActiveSearch | Both:
    """What finds the landmarks that these options ask for: points, and lines beside them if there are to be any."""
    points = ActiveSearch(calibration, rng, settings)
    return Both(points, SegmentSearch(calibration)) if options.lines else points


def _own(sight: Sight, family: str) -> Sight:
    """The sight with the looks of one family alone."""
    return replace(sight, looks=[look for look in sight.looks if look.family.name == family])
