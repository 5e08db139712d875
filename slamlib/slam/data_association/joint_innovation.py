"""The joint innovation of one frame, with its full covariance. Chapter data_association."""

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import RigSensor
from slamlib.entities.landmark import group_by_kind, landmark_means
from slamlib.geometry.pose import Pose, compose
from slamlib.kalman.linalg import touched_rows
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import PredictedBatch
from slamlib.slam.prediction import Predictions, innovations


@dataclass(frozen=True, eq=False)
class JointInnovation:
    """n innovations z (n, d) with their joint covariance S (n, d, n, d) and noises R (n, d, d); dof (n,) of each.

    An innovation of fewer numbers than d is padded with zeros of variance 1, independent of all: its squares, and
    those of every set that it is in, stay what they are. gain (k, n, d) is P H', for the rows `touched` (k,) of the
    joint covariance that any of them depends on.
    """

    z: Array
    S: Array
    R: Array
    dof: Array
    gain: Array
    touched: Indices


def joint_innovation(belief: Belief, sensor: RigSensor, predictions: Predictions) -> JointInnovation:
    """Joint innovation of all predictions, as they were predicted, and S = H P H' + R with all cross-correlations."""
    n, kinds = len(predictions), group_by_kind(range(len(predictions)), lambda i: predictions[i].landmark.kind)
    found = [innovations(sensor, [predictions[i] for i in at]) for at in kinds]
    d = max(own.z.shape[1] for _, own in found)
    touched, places = touched_rows(belief.size, [expected.columns for expected, _ in found])
    z, H, dof = np.zeros((n, d)), np.zeros((n, d, len(touched))), np.zeros(n, dtype=int)
    R = np.eye(d)[None].repeat(n, axis=0)
    for at, columns, (_, own) in zip(kinds, places, found, strict=True):
        rows, each = np.array(at), np.arange(own.z.shape[1])
        z[rows[:, None], each], dof[rows] = own.z, len(each)
        H[rows[:, None, None], each[:, None], columns[:, None, :]] = own.H
        R[rows[:, None, None], each[:, None], each] = own.R
    flat = H.reshape(n * d, -1)
    gain = belief.matrix[touched[:, None], touched] @ flat.T
    S = (flat @ gain).reshape(n, d, n, d)
    S = S / 2 + S.transpose(2, 3, 0, 1) / 2
    S[np.arange(n), :, np.arange(n)] += R
    return JointInnovation(z, S, R, dof, gain.reshape(-1, n, d), touched)


def hypothesis_innovations(sensor: RigSensor, predictions: Predictions, joint: JointInnovation) -> Array:
    """Innovations (n, n, d) of all predictions (second axis) at the mean updated by one of them alone (first axis).

    Mean + P H_i' S_ii^-1 z_i for the poses and the landmarks; the belief is not changed. Not linearized: each
    hypothesis predicts anew. nan where a landmark would be out of view.
    """
    n, d = joint.z.shape
    own = joint.S[np.arange(n), :, np.arange(n)]
    steps = np.einsum("knd,nd->nk", joint.gain, np.linalg.solve(own, joint.z[..., None])[..., 0])
    moved_sensor = steps[:, np.searchsorted(joint.touched, sensor.columns)]  # (n, 6), or (n, 12) with its extrinsics
    robot, k = sensor.robot, sensor.robot.motion.pose_dof
    extrinsics = sensor.extrinsics if sensor.block is None else Pose.plus(sensor.extrinsics, moved_sensor[:, k:])
    moved_robot = Pose.plus(robot.pose, moved_sensor[:, :k] @ robot.motion.pose_jacobian(robot.block.mean).T)
    camera = compose(moved_robot, extrinsics)[:, None]
    in_frame: dict[str, list[tuple[list[int], Array]]] = defaultdict(list)
    for at in group_by_kind(range(n), lambda i: predictions[i].landmark.kind):
        landmarks = [predictions[i].landmark for i in at]
        columns = np.array([predictions[i].columns[len(sensor.columns) :] for i in at])
        step = steps[:, np.searchsorted(joint.touched, columns)]
        kind, moved = landmarks[0].kind, landmarks[0].kind.manifold.plus(landmark_means(landmarks), step)
        in_frame[predictions[at[0]].family.name].append((at, kind.to_frame(camera, moved)))
    z = np.zeros((n, n, d))
    for kinds in in_frame.values():  # projection does not depend on the kind: all points are projected in one batch
        group = [i for at, _ in kinds for i in at]
        there = np.concatenate([places for _, places in kinds], axis=1)
        found = _innovations(sensor, [predictions[i] for i in group], there)
        z[:, group, : found.shape[-1]] = found
    return z


def _innovations(sensor: RigSensor, predictions: Predictions, in_frame: Array) -> Array:
    """Innovations (h, n, d) of predictions of one family, for landmarks in_frame (h, n, q) of the sensor."""
    family = predictions[0].family
    inner = family.innovation_input(sensor.calibration, in_frame)
    h, n, q = inner.shape
    flat, columns = inner.reshape(h * n, q), np.zeros((h * n, 0), dtype=int)
    landmarks, options = [prediction.landmark for prediction in predictions] * h, predictions[0].batch.options
    expected = PredictedBatch(landmarks, flat, flat, np.zeros((h * n, q, 0)), columns, options)
    measured = np.tile(np.array([prediction.measured for prediction in predictions]), (h, 1))
    z: Array = family.batch_innovation(sensor, expected, measured).z
    return z.reshape(h, n, -1)
