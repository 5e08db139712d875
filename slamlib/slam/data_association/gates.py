"""The gate: how near a measurement must be to what was predicted, in squared Mahalanobis distance. Chapter ekf_slam.

The update compares (`slam.measurement_update`, `PredictedMeasurement.apply_gate`); the probability is `Options.gate`.
"""

import math

import numpy as np

from slamlib.belief import Belief
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array
from slamlib.observation.family import Innovation, PredictedBatch
from slamlib.slam.prediction import innovation_covariances


def mahalanobis_squared(z: Array, S: Array) -> Array:
    """z' S^-1 z (...) of innovations (..., d), covariances (..., d, d); of 2 x 2, most pixels', by their factors."""
    if S.shape[-2:] != (2, 2):
        return (z * np.linalg.solve(S, z[..., None])[..., 0]).sum(-1)
    a, b, c = S[..., 0, 0], S[..., 0, 1], S[..., 1, 1]
    x, y, ratio = z[..., 0], z[..., 1], b / a
    return x * x / a + (y - ratio * x) ** 2 / (c - ratio * b)


def gate(probability: float, dof: int) -> float:
    """What z' S^-1 z has to be below to pass: a true measurement of `dof` numbers passes with this probability."""
    return math.inf if probability == 1 else chi2_quantile(probability, dof)


def innovation_squares(belief: Belief, expected: PredictedBatch, found: Innovation) -> list[float]:
    """The nis of each single innovation: those linearized as they were predicted have the covariance predicted."""
    S = expected.S if found.H is expected.jacobian else None
    if S is None:
        S = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
    return mahalanobis_squared(found.z, S).tolist()
