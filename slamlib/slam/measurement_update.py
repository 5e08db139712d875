"""One sensor's measurement update: predict, select, match, gate, update. Chapter ekf_slam reads it line by line."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slamlib.belief import Belief
from slamlib.data.records import RobotMeasurement
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Euclidean, Indices
from slamlib.observation.family import Family, Innovation, PredictedBatch, viewpoint
from slamlib.slam.data_association.front_end import FrontEnd, FrontEndInput
from slamlib.slam.data_association.gates import SELECTIONS, gate, innovation_covariances, mahalanobis_squared
from slamlib.slam.entities import POSE, Landmark, RigSensor, Robot

if TYPE_CHECKING:
    from slamlib.slam.linearization import Linearization
    from slamlib.slam.options import Options

T = TypeVar("T")
KIND = attrgetter("kind")  # of a landmark
# Takes a Jacobian at the present means, w.r.t. rows of the covariance, to the errors that the covariance is of.
Projection = Callable[[Indices, Array], Array]


def group_by_kind(items: Iterable[T], kind: Callable[[T], Any] = attrgetter("landmark.kind")) -> list[list[T]]:
    """Group predictions, or whatever has a kind, by the landmark's kind, so that each kind is computed in one batch."""
    found: dict[int, list[T]] = defaultdict(list)
    for item in items:
        found[id(kind(item))].append(item)
    return list(found.values())


@dataclass(eq=False)
class PredictedMeasurement:
    """The predicted measurement of one landmark, and what becomes of it in a frame.

    S (m, m): innovation covariance; measured (m,): the matched measurement. score, predicted_patch, found_patch: left
    here by an image front end for display: the best match's score, the patch searched for and the one found, both grey.
    """

    family: Family
    landmark: Landmark
    batch: PredictedBatch
    row: int
    S: Array
    measured: Array
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

    def apply_gate(self, nis: float, limit: float) -> None:
        """Accept the match as an inlier if its nis is below the gate's limit."""
        self.nis, self.inlier = nis, nis < limit
        self.landmark.inliers += self.inlier


Predictions = list[PredictedMeasurement]


def predict_measurements(
    belief: Belief,
    sensor: RigSensor,
    families: Mapping[str, Family],
    landmarks: list[Landmark],
    options: Options,
    robot: Array | None = None,
) -> Predictions:
    """Predict the measurements of all landmarks in view, with the covariance of each innovation.

    robot (7,): another pose of its robot than the estimated one; the covariance remains as it is.
    """
    predictions = []
    kinds, view = group_by_kind(landmarks, KIND), viewpoint(sensor, robot)
    for family in families.values():
        for group in kinds if family.supports(sensor) else ():
            if not isinstance(group[0].kind, family.kinds):
                continue
            expected = family.predict_batch(view, group, options)
            if not expected.landmarks:
                continue
            found = family.batch_innovation(sensor, expected, expected.value)
            S = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
            nothing = np.full(expected.value.shape[1], np.nan)
            predictions += [
                PredictedMeasurement(family, lm, expected, i, S[i], nothing) for i, lm in enumerate(expected.landmarks)
            ]
    return predictions


def predict_from_pose(slam: Any, motion: Array, sensor: int = 0) -> Predictions:
    """Predict a sensor's measurements after its robot moved by a pose (7,) in its frame; the filter is unchanged."""
    rig_sensor = slam.sensors[sensor]
    robot = compose(rig_sensor.robot.pose, motion)
    return predict_measurements(slam.belief, rig_sensor, slam.families, slam.landmarks, slam.options, robot)


def select_and_match(inputs: FrontEndInput, front_end: FrontEnd, options: Options) -> Predictions:
    """The most informative predictions that were matched, most informative first; updates the landmarks' histories."""
    sizes: dict[int, Predictions] = defaultdict(list)
    for prediction in front_end.searchable(inputs):
        sizes[len(prediction.S)].append(prediction)
    # Determinants of different sizes cannot be compared: each size of measurement has the whole budget for itself.
    chosen: Predictions = []
    for group in sizes.values():
        S = np.concatenate([prediction.S for prediction in group]).reshape(-1, *group[0].S.shape)
        chosen += [group[i] for i in SELECTIONS[options.selection](S, options.updates).tolist()]
    by_family: dict[str, Predictions] = defaultdict(list)
    for prediction in chosen:
        prediction.chosen = True
        prediction.landmark.searched += 1
        by_family[prediction.family.name].append(prediction)
    for name, group in by_family.items():
        measured, found = front_end.match(inputs, name, group)
        for prediction, y, is_found in zip(group, measured, found.tolist(), strict=True):
            prediction.measured, prediction.matched = y, is_found
            prediction.landmark.matched += is_found
    return [prediction for prediction in chosen if prediction.matched]


def unprojected(columns: Indices, H: Array) -> Array:
    """The projection of a filter whose covariance is of the errors of the present means."""
    return H


def update_sequentially(
    belief: Belief, sensor: RigSensor, predictions: Predictions, options: Options, project: Projection = unprojected
) -> None:
    """Update by one landmark after another, each predicted anew at the current mean."""
    with belief.sequential_update() as sequence:
        for prediction in predictions:
            found = prediction.family.innovation(viewpoint(sensor), prediction.landmark, prediction.measured, options)
            if found is not None:
                limit = gate(options.gate, len(found.z))
                columns = prediction.batch.columns[prediction.row]
                H = project(columns, found.H)
                prediction.apply_gate(sequence.update(columns, H, found.z, found.R, limit).nis, limit)


def innovations(sensor: RigSensor, group: Predictions) -> tuple[PredictedBatch, Innovation]:
    """Predicted measurements of matched landmarks of one kind, and their innovations."""
    expected = group[0].batch.take([prediction.row for prediction in group])
    measured = np.array([prediction.measured for prediction in group])
    return expected, group[0].family.batch_innovation(sensor, expected, measured)


def innovation_squares(belief: Belief, expected: PredictedBatch, found: Innovation) -> list[float]:
    """The nis of each single innovation."""
    S = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
    return mahalanobis_squared(found.z, S).tolist()


def update_in_batch(belief: Belief, sensor: RigSensor, predictions: Predictions, options: Options) -> None:
    """Update by all measurements in one batch, linearized at the predicted mean."""
    parts = []
    for group in group_by_kind(predictions):
        expected, found = innovations(sensor, group)
        for prediction, nis in zip(group, innovation_squares(belief, expected, found), strict=True):
            prediction.apply_gate(nis, gate(options.gate, found.z.shape[1]))
        keep = np.array([prediction.inlier for prediction in group])
        parts.append((expected.columns[keep], found.H[keep], found.z[keep], found.R[keep]))
    if any(len(z) for _, _, z, _ in parts):
        belief.update_rows(*_stacked(parts))


def _stacked(parts: list[tuple[Indices, Array, Array, Array]]) -> tuple[Indices, Array, Array, Array]:
    """Touched rows (k,), and one stacked Jacobian, innovation and noise of all parts."""
    touched = np.unique(np.concatenate([columns.ravel() for columns, _, _, _ in parts]))
    z = np.concatenate([part[2].ravel() for part in parts])
    H, R = np.zeros((len(z), len(touched))), np.zeros((len(z), len(z)))
    start = 0
    for columns, J, innovation, noise in parts:
        rows = start + np.arange(innovation.size).reshape(innovation.shape)
        at = np.searchsorted(touched, columns)
        H[rows[:, :, None], at[:, None, :]] = J
        R[rows[:, :, None], rows[:, None, :]] = noise
        start += innovation.size
    return touched, H, z, R


def after_update(belief: Belief, sensor: RigSensor, predictions: Predictions, options: Options) -> None:
    """Let each family treat its updated landmarks: convert points, constrain lines, move endpoints."""
    for group in group_by_kind(prediction for prediction in predictions if prediction.inlier):
        landmarks = [prediction.landmark for prediction in group]
        measured = np.array([prediction.measured for prediction in group])
        group[0].family.after_update(belief, sensor, landmarks, measured, options)


@dataclass(frozen=True, eq=False)
class RobotUpdate:
    """The outcome of a robot's measurement of itself: innovation z (m,), its covariance S (m, m), nis, the gate."""

    name: str
    innovation: Array
    covariance: Array
    nis: float
    inlier: bool


def update_by_robot(
    belief: Belief, robot: Robot, measured: RobotMeasurement, linearization: Linearization | None, options: Options
) -> RobotUpdate:
    """Gate a measurement of a robot's own pose, and update all blocks by it if it passes. Raises ShapeError."""
    value, J = measured.model.jac(robot.pose)
    if linearization is not None:
        J = measured.model.jac(linearization.at(robot.block)[:7])[1]
    result = measured.model.result
    z = ((result.manifold if result else None) or Euclidean(len(value))).minus(measured.value, value)
    limit = gate(options.gate, len(z))
    with belief.sequential_update() as sequence:
        columns = robot.block.start + np.arange(POSE)
        found = sequence.update(columns, J[0], z, measured.covariance, limit)
    return RobotUpdate(measured.name, z, found.covariance, found.nis, found.nis < limit)
