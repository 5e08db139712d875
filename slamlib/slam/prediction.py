"""Project: the predicted measurements of all landmarks in view of a sensor, with the covariances of the innovations."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from operator import attrgetter
from typing import Annotated

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import Landmark, RigSensor
from slamlib.entities.state import KindRows
from slamlib.kalman.linalg import principal_blocks
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import AnyFamily, FamilyOptions, Innovation, PredictedBatch, viewpoint
from slamlib.observation.second_order import SECOND_ORDER
from slamlib.plain_data.fields import OneOf

LANDMARK_KIND = attrgetter("landmark.kind")  # of a prediction


@dataclass(frozen=True, repr=False)
class PredictionOptions(FamilyOptions):
    """second_order: what of it is taken into account (observation.second_order); None: nothing, as in every EKF."""

    second_order: Annotated[str, OneOf(SECOND_ORDER)] | None = None


@dataclass(eq=False, slots=True)
class PredictedMeasurement:
    """The predicted measurement of one landmark, and what becomes of it in a frame.

    measured (m,): the matched measurement; second_order (d, d): noise for what a linearization leaves out, part of S.
    score, predicted_patch, found_patch: left here by an image front end for display: the best match's score, the patch
    searched for and the one found, both grey.
    """

    family: AnyFamily
    landmark: Landmark
    batch: PredictedBatch
    row: int
    measured: Array
    second_order: Array | None = None
    chosen: bool = False
    matched: bool = False
    inlier: bool = False
    nis: float = np.nan
    score: float = np.nan
    predicted_patch: Array | None = None
    found_patch: Array | None = None

    @property
    def value(self) -> Array:
        """The predicted measurement (m,)."""
        return self.batch.value[self.row]

    @property
    def S(self) -> Array:
        """The innovation's covariance (d, d)."""
        S: Array = self.batch.S[self.row]
        return S

    @property
    def columns(self) -> Indices:
        """Rows (k,) of the joint covariance on which the measurement depends."""
        return self.batch.columns[self.row]

    def innovation(self, sensor: RigSensor) -> Innovation:
        """The innovation of its match, linearized where it was predicted."""
        inner, by = self.batch.innovation_input[self.row], self.batch.jacobian[self.row]
        return self._noisier(self.family.residual(sensor, inner, by, self.measured, self.batch.options))

    def innovation_anew(self, sensor: RigSensor, options: FamilyOptions) -> Innovation | None:
        """The innovation of its match, predicted anew at the present means; None if it is out of view there."""
        found = self.family.innovation(viewpoint(sensor), self.landmark, self.measured, options)
        return found and self._noisier(found)

    def _noisier(self, found: Innovation) -> Innovation:
        return found if self.second_order is None else found._replace(R=found.R + self.second_order)

    def apply_gate(self, nis: float, limit: float) -> bool:
        """Accept the match as an inlier if its nis is below the gate's limit, and return whether it is."""
        self.nis, self.inlier = nis, nis < limit
        self.landmark.inliers += self.inlier
        return self.inlier


Predictions = list[PredictedMeasurement]


def predict_measurements(
    belief: Belief,
    sensor: RigSensor,
    families: Mapping[str, AnyFamily],
    kinds: Iterable[KindRows],
    options: PredictionOptions,
    robot: Array | None = None,
) -> Predictions:
    """Predict the measurements of all landmarks in view, with the covariance of each innovation.

    kinds: the landmarks, kind by kind. robot (7,): another pose of its robot than the estimated one; the covariance
    remains as it is.
    """
    predictions = []
    groups, view = list(kinds), viewpoint(sensor, robot)
    for family in families.values():
        for group in groups if family.supports(sensor) else ():
            if not isinstance(group.kind, family.kinds):
                continue
            expected = family.predict_batch(view, group, options)
            if not expected.landmarks:
                continue
            H, R = family.linearized(sensor, expected)
            left_out: Array | list[None] = [None] * len(R)
            if options.second_order is not None:
                covariance = principal_blocks(belief.matrix, expected.columns)
                left_out = SECOND_ORDER[options.second_order](family, sensor, expected, covariance)
                R = R + left_out
            expected = expected._replace(S=innovation_covariances(belief.matrix, expected.columns, H, R))
            nothing = np.full(expected.value.shape[1], np.nan)
            predictions += [
                PredictedMeasurement(family, lm, expected, i, nothing, noise)
                for i, (lm, noise) in enumerate(zip(expected.landmarks, left_out, strict=True))
            ]
    return predictions


def expected_values(predictions: Predictions) -> Array:
    """Predicted measurements (n, m) of predictions of one size, one or more."""
    return _stacked(predictions, attrgetter("value"))


def expected_covariances(predictions: Predictions) -> Array:
    """Innovation covariances (n, d, d) of predictions of one size, one or more."""
    return _stacked(predictions, attrgetter("S"))


def _stacked(predictions: Predictions, of: Callable[[PredictedBatch | PredictedMeasurement], Array]) -> Array:
    """The same array of each: rows of their batch's where they are of one."""
    batch, *others = {id(prediction.batch): prediction.batch for prediction in predictions}.values()
    if others:
        return np.array([of(prediction) for prediction in predictions])
    return of(batch).take([prediction.row for prediction in predictions], axis=0)


def innovation_covariances(covariance: Array, columns: Indices, H: Array, R: Array) -> Array:
    """S = H P H' + R (n, d, d) of n measurements, one by one; covariance (s, s), H (n, d, k).

    columns (n, k): rows of the joint covariance on which each depends: robot, extrinsics if estimated, landmark.
    """
    half = H @ principal_blocks(covariance, columns) @ H.swapaxes(-1, -2) / 2
    return half + half.swapaxes(-1, -2) + R


def innovations(sensor: RigSensor, group: Predictions) -> tuple[PredictedBatch, Innovation]:
    """Predicted measurements of matched landmarks of one kind, and their innovations."""
    expected = group[0].batch.take([prediction.row for prediction in group])
    measured = np.array([prediction.measured for prediction in group])
    found = group[0].family.batch_innovation(sensor, expected, measured)
    left_out = [prediction.second_order for prediction in group if prediction.second_order is not None]
    return expected, found._replace(R=found.R + left_out) if left_out else found
