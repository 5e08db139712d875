"""Gate and update: by one landmark after another, by all in one batch, or by a robot's measurement of itself.

Chapter ekf_slam reads it line by line.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import RigSensor, Robot
from slamlib.entities.landmark import group_by_kind
from slamlib.entities.linearization import Linearization
from slamlib.kalman.linalg import touched_rows
from slamlib.kalman.update import StackedMeasurements
from slamlib.manifolds import Array, Euclidean, Indices
from slamlib.observation.family import FamilyOptions
from slamlib.plain_data.fields import Range
from slamlib.records.inputs import RobotMeasurement
from slamlib.slam.data_association.gates import gate, innovation_squares
from slamlib.slam.prediction import LANDMARK_KIND, PredictionOptions, Predictions, innovations

# Takes a Jacobian at the present means, w.r.t. rows of the covariance, to the errors that the covariance is of.
Projection = Callable[[Indices, Array], Array]


@dataclass(frozen=True, repr=False)
class UpdateOptions(PredictionOptions):
    """gate: probability with which a true measurement passes, for the innovation's own degrees of freedom; 1: all."""

    gate: Annotated[float, Range(gt=0, le=1)] = 0.99


def unprojected(columns: Indices, H: Array) -> Array:
    """The projection of a filter whose covariance is of the errors of the present means."""
    return H


def update_sequentially(
    belief: Belief,
    sensor: RigSensor,
    predictions: Predictions,
    options: UpdateOptions,
    project: Projection = unprojected,
    *,
    moved: bool = False,
) -> None:
    """Gate and update, one landmark after another, each predicted anew where the means have moved since.

    moved: whether they have moved already between the predictions and this call.
    """
    with belief.sequential_update() as sequence:
        for prediction in predictions:
            found = prediction.innovation_anew(sensor, options) if moved else prediction.innovation(sensor)
            if found is not None:
                limit = gate(options.gate, len(found.z))
                proposed = sequence.propose(prediction.columns, project(prediction.columns, found.H), found.z, found.R)
                if prediction.apply_gate(proposed.nis, limit):
                    sequence.apply(proposed)
                    moved = True


def update_in_batch(belief: Belief, sensor: RigSensor, predictions: Predictions, options: UpdateOptions) -> None:
    """Update by all measurements in one batch, linearized at the predicted mean."""
    parts = []
    for group in group_by_kind(predictions, LANDMARK_KIND):
        expected, found = innovations(sensor, group)
        squares, limit = innovation_squares(belief, expected, found), gate(options.gate, found.z.shape[1])
        passed = [prediction.apply_gate(nis, limit) for prediction, nis in zip(group, squares, strict=True)]
        if any(passed):
            keep = slice(None) if all(passed) else np.flatnonzero(passed)  # a slice takes no copies
            parts.append((expected.columns[keep], found.z[keep], found.H[keep], found.R[keep]))
    if parts:
        belief.update_stacked(_stacked(belief.size, parts))


def _stacked(size: int, parts: list[tuple[Indices, Array, Array, Array]]) -> StackedMeasurements:
    """All innovations as one; of each part the columns (n, k), z (n, d), H (n, d, k) and R (n, d, d)."""
    touched, places = touched_rows(size, [columns for columns, _, _, _ in parts])
    z = np.concatenate([part[1].ravel() for part in parts])
    H, R = np.zeros((len(z), len(touched))), np.zeros((len(z), len(z)))
    start = 0
    for at, (_, innovation, J, noise) in zip(places, parts, strict=True):
        rows = start + np.arange(innovation.size).reshape(innovation.shape)
        H[rows[:, :, None], at[:, None, :]] = J
        R[rows[:, :, None], rows[:, None, :]] = noise / 2 + noise.swapaxes(-1, -2) / 2
        start += innovation.size
    return StackedMeasurements(z, H, R, touched)


def convert(belief: Belief, sensor: RigSensor, predictions: Predictions, options: FamilyOptions) -> None:
    """Let each family treat its updated landmarks: convert points, constrain lines, move endpoints."""
    for group in group_by_kind((prediction for prediction in predictions if prediction.inlier), LANDMARK_KIND):
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
    belief: Belief,
    robot: Robot,
    measured: RobotMeasurement,
    linearization: Linearization | None,
    options: UpdateOptions,
) -> RobotUpdate:
    """Gate a measurement of a robot's own pose, and update all blocks by it if it passes. Raises ShapeError."""
    value, J = measured.model.jac(robot.pose)
    state = robot.block.mean
    if linearization is not None:
        state = linearization.at(robot.block)
        J = measured.model.jac(robot.motion.pose(state))[1]
    result = measured.model.result
    z = ((result.manifold if result else None) or Euclidean(len(value))).minus(measured.value, value)
    limit = gate(options.gate, len(z))
    with belief.sequential_update() as sequence:
        H = robot.motion.by_state(J[0], state)
        found = sequence.update(robot.columns, H, z, measured.covariance, limit)
    return RobotUpdate(measured.name, z, found.covariance, found.nis, found.nis < limit)
