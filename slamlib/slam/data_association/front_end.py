"""What finds a sensor's measurements: the contract of a front end, what it gets to see, and association by identity."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from slamlib.data.records import Features, Scan
from slamlib.manifolds import Array, Mask

if TYPE_CHECKING:
    from slamlib.slam.entities import MountedSensor
    from slamlib.slam.measurement_update import PredictedMeasurement

NONE = Features.none(0)
Detected = tuple[int, Array, Any]  # of a new landmark: its id, its first measurement (m,), its signature


@dataclass(frozen=True, eq=False)
class FrontEndInput:
    """What a front end gets to see: the scan, the mounted sensor as it is estimated now, and all that it expects.

    predictions: one for each landmark that should be in view, with its expectation (`value`, `S`) before any
    correction.
    """

    scan: Scan
    sensor: MountedSensor
    predictions: list[PredictedMeasurement]


class FrontEnd(Protocol):
    """Finds the measurements of one sensor, frame by frame: `searchable`, `match` for each family, `detect` for each.

    A signature is what it knows a landmark by; the filter keeps it with the landmark, and hands it back unread.
    """

    def searchable(self, inputs: FrontEndInput) -> list[PredictedMeasurement]:
        """Of the looks of a sight, those that it could find at all if the landmarks are there."""

    def match(self, inputs: FrontEndInput, family: str, predictions: list[PredictedMeasurement]) -> tuple[Array, Mask]:
        """Measurements (n, m) of what is looked for, nan where there is none, and the mask (n,) of those found."""

    def detect(
        self, inputs: FrontEndInput, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[Detected]:
        """Up to `count` measurements to begin a landmark with; known: ids of the landmarks in the map.

        usable(values) is the mask of the values (n, m) that a landmark may begin with.
        """

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that it cannot look at, before anything is changed. Here: any will do."""
        return None

    def dump(self) -> Any:
        """Its own state as plain data. Here: it has none."""
        return None

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        return None

    def pack(self, signature: Any) -> Any:
        """A landmark's signature as plain data. Here: it gives none."""
        return None

    def unpack(self, packed: Any) -> Any:
        """The signature that `pack` packed."""
        return None


class KnownAssociation(FrontEnd):
    """Association by identity: simulated features, and those of labelled data, carry the id of what they show."""

    def searchable(self, inputs: FrontEndInput) -> list[PredictedMeasurement]:
        """All looks."""
        return inputs.predictions

    def match(self, inputs: FrontEndInput, family: str, predictions: list[PredictedMeasurement]) -> tuple[Array, Mask]:
        """The features with the ids of the landmarks."""
        features = inputs.scan.features.get(family, NONE)
        row_of = {number: row for row, number in enumerate(features.ids.tolist())}
        rows = np.array([row_of.get(prediction.landmark.id, -1) for prediction in predictions], dtype=int)
        size = features.values.shape[1] if len(features) or not predictions else len(predictions[0].value)
        measured = np.full((len(predictions), size), np.nan)
        matched = rows >= 0
        if matched.any():  # a scan without this family has features of no numbers
            measured[matched] = features.values[rows[matched]]
        return measured, matched

    def detect(
        self, inputs: FrontEndInput, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[Detected]:
        """The features with the lowest ids that are not known."""
        features = inputs.scan.features.get(family, NONE)
        fresh = sorted((number, row) for row, number in enumerate(features.ids.tolist()) if number not in known)
        if not fresh or not count:
            return []
        mask = usable(features.values[[row for _, row in fresh]])
        good = [pair for pair, is_usable in zip(fresh, mask.tolist(), strict=True) if is_usable][:count]
        return [(number, features.values[row], None) for number, row in good]
