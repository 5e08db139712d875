"""Points of stereo measurements; the most likely motion between two pairs: Gauss-Newton, the points eliminated."""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array, Mask
from slamlib.observation.points import initialize, observe
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.gates import gate

GATE_PROBABILITY = 0.999  # probability that a correct match passes
ROUNDS = 10


def triangulate(calibration: Calibration, values: Array, extrinsics: Array = ORIGIN) -> tuple[Array, Array]:
    """Points (n, 3) [m] of measurements (n, 3) [px], and covariances (n, 3, 3) = J R J', in the robot's frame.

    extrinsics (7,): the sensor's pose on the robot; the default gives points of the sensor's own frame. R, the noise of
    the calibration, is of (u, v, d); J is the model's own Jacobian. The result is nearly singular, and never diagonal:
    an error of the disparity moves the point along its ray. Raises SlamlibError for a disparity that is not above zero.
    """
    if not (values[:, 2] > 0).all():
        raise SlamlibError("triangulate: a disparity of zero or less belongs to no finite point; mask such features")
    points, J = initialize(EUC_POINT, calibration, ORIGIN, extrinsics, values)
    by = J.measurement
    return points, by @ calibration.noise @ by.swapaxes(-1, -2)


@dataclass(frozen=True, eq=False)
class Fit:
    """The robot's new pose (7,) in its old frame, covariance (6, 6), mask (n,) of the inliers, and sum of e' S^-1 e."""

    pose: Array
    covariance: Array
    inliers: Mask
    squares: float


def fit(calibration: Calibration, extrinsics: Array, old: Array, new: Array, start: Array, inliers: Mask) -> Fit | None:
    """Maximum-likelihood pose for measurements (n, 3) [px] with the calibration's noise in both pairs, from `start`.

    Twice: with the given inliers, and with those that pass the first result's gate. None if too few, or ill placed.
    """
    pose, keep = start, inliers
    for _ in range(2):
        if keep.sum() < 3:
            return None
        try:
            pose, covariance = _minimum(calibration, extrinsics, old[keep], new[keep], pose)
        except np.linalg.LinAlgError:  # points at one spot, or beyond infinity, determine no pose
            return None
        e, _, _, S = _linear(calibration, extrinsics, old, new, pose, old)
        squares = (e * np.linalg.solve(S, e[..., None])[..., 0]).sum(-1)
        chosen, keep = keep, keep & (squares < gate(GATE_PROBABILITY, 3))
    return Fit(pose, covariance, chosen, float(squares[chosen].sum()))


def _minimum(calibration: Calibration, extrinsics: Array, old: Array, new: Array, pose: Array) -> tuple[Array, Array]:
    """Iterate; the noise-free old measurements y are estimated together with the pose.

    The cost is |old - y|^2 + |new - g(X, y)|^2, both in the metric of R. For a step of X by A dx and of y by G dy the
    optimal dy is known, which leaves e = (new - g) - G (old - y) of covariance S = R + G R G' for the pose alone:
    the same as if the points were parameters too (their Schur complement), at the cost of a 6 x 6 system.
    """
    R, y = calibration.noise, old
    for _ in range(ROUNDS):
        e, A, G, S = _linear(calibration, extrinsics, old, new, pose, y)
        W = np.linalg.inv(S)
        weighted = A.swapaxes(-1, -2) @ W
        information = (weighted @ A).sum(0)
        step = np.linalg.solve(information, (weighted @ e[..., None]).sum(0)[:, 0])
        rest = e - A @ step
        y = old + (R @ G.swapaxes(-1, -2) @ W @ rest[..., None])[..., 0]
        y[:, 2] = np.maximum(y[:, 2], old[:, 2] / 10)  # a wrong match must not push its point beyond infinity
        pose = Pose.plus(pose, step)
        if np.abs(step).max() < 1e-8:
            break
    return pose, np.linalg.inv(information)


def _linear(
    calibration: Calibration, extrinsics: Array, old: Array, new: Array, pose: Array, y: Array
) -> tuple[Array, Array, Array, Array]:
    """e (n, 3), A (n, 3, 6), G (n, 3, 3) and S (n, 3, 3) at a pose and at estimates y (n, 3) of the old values."""
    points, back = initialize(EUC_POINT, calibration, ORIGIN, extrinsics, y)
    seen = observe(EUC_POINT, calibration, pose, extrinsics, points)
    A, G = seen.jacobians.robot, seen.jacobians.landmark @ back.measurement
    e = new - seen.value - (G @ (old - y)[..., None])[..., 0]
    R = calibration.noise
    return e, A, G, R + G @ R @ G.swapaxes(-1, -2)
