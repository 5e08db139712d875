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
from slamlib.manifolds import Array, Euclidean, Indices
from slamlib.observation.family import FamilyOptions
from slamlib.plain_data.fields import Range
from slamlib.records.inputs import RobotMeasurement
from slamlib.slam.data_association.gates import gate, innovation_squares
from slamlib.slam.prediction import LANDMARK_KIND, Predictions, innovations

# Takes a Jacobian at the present means, w.r.t. rows of the covariance, to the errors that the covariance is of.
Projection = Callable[[Indices, Array], Array]


@dataclass(frozen=True, repr=False)
class UpdateOptions(FamilyOptions):
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
