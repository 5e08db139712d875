"""One sensor looks at the map: choose, match, gate, correct. Chapter 16 reads it line by line."""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slamlib.belief import Belief
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import Family, PredictedBatch, viewpoint
from slamlib.slam.data_association.front_end import FrontEnd, FrontEndInput
from slamlib.slam.data_association.gates import SELECTIONS, gate, innovation_covariances, mahalanobis_squared
from slamlib.slam.entities import Landmark, MountedSensor

if TYPE_CHECKING:
    from slamlib.slam.options import Options

T = TypeVar("T")


def group_by_kind(items: Iterable[T]) -> list[list[T]]:
    """Landmarks, or looks at them, by the landmark's kind, so that each kind is computed in one batch."""
    found: dict[int, list[T]] = defaultdict(list)
    for item in items:
        landmark: Any = getattr(item, "landmark", item)
        found[id(landmark.kind)].append(item)
    return list(found.values())


@dataclass(eq=False)
class PredictedMeasurement:
    """One expected landmark on its way through a frame.

    score, predicted_patch, found_patch: what a front end that looks at images leaves here for pictures: how well the
    best place agrees, the patch that it looked for, and the one that it found, both grey images.
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
        """The expected measurement (m,)."""
        return self.batch.value[self.row]

    def apply_gate(self, nis: float, limit: float) -> None:
        """Believe the measurement if a true one would be as far off with the probability of the gate."""
        self.nis, self.inlier = nis, nis < limit
        self.landmark.inliers += self.inlier


def predict_measurements(
    belief: Belief,
    sensor: MountedSensor,
    families: Mapping[str, Family],
    landmarks: list[Landmark],
    options: "Options",
    robot: Array | None = None,
) -> list[PredictedMeasurement]:
    """Everything that the sensor should see, with the covariance of each innovation.

    robot (7,): from another pose of its robot than the estimated one, with the covariance as it is.
    """
    predictions = []
    kinds, view = group_by_kind(landmarks), viewpoint(sensor, robot)
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


def predict_from_pose(slam: Any, motion: Array, sensor: int = 0) -> list[PredictedMeasurement]:
    """What a sensor should see after its robot has moved by a pose (7,) in its frame; nothing of the filter changes."""
    mounted = slam.sensors[sensor]
    robot = compose(mounted.robot.pose, motion)
    return predict_measurements(slam.belief, mounted, slam.families, slam.landmarks, slam.options, robot)


def select_and_match(inputs: FrontEndInput, front_end: FrontEnd, options: "Options") -> list[PredictedMeasurement]:
    """The looks that tell most and were matched, the one that tells most first; the landmarks' histories go on."""
    sizes: dict[int, list[PredictedMeasurement]] = defaultdict(list)
    for prediction in front_end.searchable(inputs):
        sizes[len(prediction.S)].append(prediction)
    # Determinants of different sizes do not compare: points and segments both count two pixels, and share the budget.
    choose = SELECTIONS[options.selection]
    chosen = [g[int(i)] for g in sizes.values() for i in choose(_stack_covariances(g), options.updates)]
    by_family: dict[str, list[PredictedMeasurement]] = defaultdict(list)
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


def update_sequentially(
    belief: Belief, sensor: MountedSensor, predictions: list[PredictedMeasurement], options: "Options"
) -> None:
    """One landmark after another, each expected anew at the mean of that moment."""
    with belief.sequential_update() as sequence:
        for prediction in predictions:
            found = prediction.family.innovation(viewpoint(sensor), prediction.landmark, prediction.measured, options)
            if found is not None:
                limit = gate(options.gate, len(found.z))
                columns = prediction.batch.columns[prediction.row]
                prediction.apply_gate(sequence.update(columns, found.H, found.z, found.R, limit).nis, limit)


def update_in_batch(
    belief: Belief, sensor: MountedSensor, predictions: list[PredictedMeasurement], options: "Options"
) -> None:
    """All at once, with the expectations of the predicted mean."""
    parts = []
    for group in group_by_kind(predictions):
        expected = group[0].batch.take([prediction.row for prediction in group])
        measured = np.array([prediction.measured for prediction in group])
        found = group[0].family.batch_innovation(sensor, expected, measured)
        S = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
        for prediction, nis in zip(group, mahalanobis_squared(found.z, S).tolist(), strict=True):
            prediction.apply_gate(nis, gate(options.gate, found.z.shape[1]))
        keep = np.array([prediction.inlier for prediction in group])
        parts.append((expected.columns[keep], found.H[keep], found.z[keep], found.R[keep]))
    if any(len(z) for _, _, z, _ in parts):
        belief.update_rows(*_stacked(parts))


def after_update(
    belief: Belief, sensor: MountedSensor, predictions: list[PredictedMeasurement], options: "Options"
) -> None:
    """What each family does with the landmarks that were corrected: convert, constrain, move ends."""
    for group in group_by_kind(prediction for prediction in predictions if prediction.inlier):
        landmarks, measured = (
            [prediction.landmark for prediction in group],
            np.array([prediction.measured for prediction in group]),
        )
        group[0].family.after_update(belief, sensor, landmarks, measured, options)


def _stacked(parts: list[tuple[Indices, Array, Array, Array]]) -> tuple[Indices, Array, Array, Array]:
    """Touched rows, and one Jacobian, innovation and noise of all parts."""
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


def _stack_covariances(predictions: list[PredictedMeasurement]) -> Array:
    return np.concatenate([prediction.S for prediction in predictions]).reshape(-1, *predictions[0].S.shape)
