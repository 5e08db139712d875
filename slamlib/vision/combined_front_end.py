"""Two front ends for one camera: one for points, one for segments."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.data.records import Scan
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import Detected, FrontEndInput
from slamlib.slam.options import Options
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.line_search import SegmentSearch


class CombinedFrontEnd:
    """Forwards what the filter asks to the front end of the family that it asks about."""

    def __init__(self, points: ActiveSearch, segments: SegmentSearch) -> None:
        self.points, self.settings = points, points.settings
        self.front_ends: dict[str, ActiveSearch | SegmentSearch] = {"points": points, "segments": segments}

    @property
    def seconds(self) -> dict[str, float]:
        """Spent so far, by both, in "search" and in "detection"."""
        return {part: sum(f.seconds[part] for f in self.front_ends.values()) for part in ("search", "detection")}

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that one of them cannot look at."""
        for front_end in self.front_ends.values():
            front_end.check(scan)

    def searchable(self, inputs: FrontEndInput) -> list[Any]:
        """The looks that their front ends could find."""
        return [p for name, f in self.front_ends.items() for p in f.searchable(_own(inputs, name))]

    def match(self, inputs: FrontEndInput, family: str, predictions: list[Any]) -> tuple[Array, Mask]:
        """What the family's front end finds of them."""
        return self.front_ends[family].match(_own(inputs, family), family, predictions)

    def detect(
        self, inputs: FrontEndInput, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[Detected]:
        """What the family's front end begins, with numbers that neither of them has given before."""
        self._share_last_id()
        return self.front_ends[family].detect(_own(inputs, family), family, known, usable, count)

    def initialize_at(self, inputs: FrontEndInput, family: str, values: Array) -> list[Detected | None]:
        """Landmarks at given values; only points can be adopted."""
        self._share_last_id()
        return self.points.initialize_at(_own(inputs, family), family, values)

    def _share_last_id(self) -> None:
        last = max(f.last for f in self.front_ends.values())
        for front_end in self.front_ends.values():
            front_end.last = last

    def dump(self) -> Any:
        """The states of both, by family."""
        return {name: f.dump() for name, f in self.front_ends.items()}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        for name, f in self.front_ends.items():
            f.restore(state[name])

    def pack(self, signature: Any) -> Any:
        """A signature as plain data, with the family whose front end gave it."""
        name = next(name for name, f in self.front_ends.items() if isinstance(signature, f.signature_type))
        return {"family": name, "signature": self.front_ends[name].pack(signature)}

    def unpack(self, packed: Any) -> Any:
        """The signature that `pack` packed."""
        return self.front_ends[packed["family"]].unpack(packed["signature"])


def make_front_end(
    options: Options, calibration: Calibration, rng: np.random.Generator, settings: ActiveSearchSettings | None = None
) -> ActiveSearch | CombinedFrontEnd:
    """What finds the landmarks that these options ask for: points, and lines beside them if there are to be any."""
    points = ActiveSearch(calibration, rng, settings)
    return CombinedFrontEnd(points, SegmentSearch(calibration)) if options.lines else points


def _own(inputs: FrontEndInput, family: str) -> FrontEndInput:
    """The sight with the looks of one family alone."""
    return replace(inputs, predictions=[p for p in inputs.predictions if p.family.name == family])
