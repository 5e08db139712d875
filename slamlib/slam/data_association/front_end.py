"""The interface of a front end, which finds a sensor's measurements; its input; and known data association."""

from collections import defaultdict
from collections.abc import Callable, Set
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from slamlib.entities import RigSensor
from slamlib.manifolds import Array, Mask
from slamlib.records.ids import Id
from slamlib.records.inputs import Scan
from slamlib.slam.prediction import PredictedMeasurement, Predictions

Detected = tuple[Id, Array, Any]  # of a new landmark: its id, its first measurement (m,), its signature
Usable = Callable[[Array], Mask]  # which of the values (n, m) may initialize a landmark: a mask (n,)


@dataclass(frozen=True, eq=False)
class FrontEndInput:
    """The input of a front end: the scan, the sensor with its estimated extrinsics, and all predictions.

    predictions: one for each landmark that should be in view, with `value` and `S` as they were before any update.
    """

    scan: Scan
    sensor: RigSensor
    predictions: list[PredictedMeasurement]


class FrontEnd(Protocol):
    """Finds the measurements of one sensor, frame by frame: `searchable`, then `match` and `detect` for each family.

    A signature is what it recognizes a landmark by; the filter keeps it with the landmark and never reads it.
    """

    def searchable(self, inputs: FrontEndInput) -> list[PredictedMeasurement]:
        """The predictions of the input whose landmarks it could find at all if they are there."""

    def match(self, inputs: FrontEndInput, family: str, predictions: list[PredictedMeasurement]) -> tuple[Array, Mask]:
        """Measurements (n, m) of the landmarks searched for, nan where not found, and the mask (n,) of those found."""

    def detect(self, inputs: FrontEndInput, family: str, known: Set[Id], usable: Usable, count: int) -> list[Detected]:
        """Return up to `count` usable measurements of new landmarks; known: ids of the landmarks in the map."""

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that it cannot process, before anything is changed. Here: it accepts all."""
        return None

    def dump(self) -> Any:
        """Return its own state as plain data. Here: it has none."""
        return None

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        return None

    def pack(self, signature: Any) -> Any:
        """Return a landmark's signature as plain data. Here: None."""
        return None

    def unpack(self, packed: Any) -> Any:
        """Return the signature that `pack` packed."""
        return None


class KnownAssociation(FrontEnd):
    """Known data association: simulated features, and those of labelled data, carry their landmark's id."""

    def searchable(self, inputs: FrontEndInput) -> list[PredictedMeasurement]:
        """Return all predictions."""
        return inputs.predictions

    def match(self, inputs: FrontEndInput, family: str, predictions: list[PredictedMeasurement]) -> tuple[Array, Mask]:
        """Match the features with the ids of the landmarks."""
        features = inputs.scan.of(family)
        row_of = {number: row for row, number in enumerate(features.ids.tolist())}
        rows = np.array([row_of.get(prediction.landmark.id, -1) for prediction in predictions], dtype=int)
        size = features.values.shape[1] if len(features) or not predictions else len(predictions[0].value)
        measured = np.full((len(predictions), size), np.nan)
        matched = rows >= 0
        if matched.any():  # a scan without this family has features of width 0
            measured[matched] = features.values[rows[matched]]
        return measured, matched

    def detect(self, inputs: FrontEndInput, family: str, known: Set[Id], usable: Usable, count: int) -> list[Detected]:
        """Return the features with the lowest ids that are not known."""
        features = inputs.scan.of(family)
        fresh = sorted((number, row) for row, number in enumerate(features.ids.tolist()) if number not in known)
        if not fresh or not count:
            return []
        mask = usable(features.values[[row for _, row in fresh]])
        good = [pair for pair, is_usable in zip(fresh, mask.tolist(), strict=True) if is_usable][:count]
        return [(number, features.values[row], None) for number, row in good]


def match(inputs: FrontEndInput, front_end: FrontEnd, chosen: Predictions) -> Predictions:
    """Those of the chosen predictions that the front end has matched; counts the match in each landmark's history."""
    by_family: dict[str, Predictions] = defaultdict(list)
    for prediction in chosen:
        by_family[prediction.family.name].append(prediction)
    for name, group in by_family.items():
        measured, found = front_end.match(inputs, name, group)
        for prediction, y, is_found in zip(group, measured, found.tolist(), strict=True):
            prediction.measured, prediction.matched = y, is_found
            prediction.landmark.matched += is_found
    return [prediction for prediction in chosen if prediction.matched]
