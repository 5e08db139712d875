"""Which landmarks to observe, and which measurements pass the gate. Chapter ekf_slam.

A landmark's row of `columns` holds the rows of the joint covariance that its measurement depends on: the robot's pose,
the extrinsics if they are estimated, the landmark.
"""

import math
from collections.abc import Callable

import numpy as np

from slamlib.kalman import linalg
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array, Indices


def innovation_covariances(covariance: Array, columns: Indices, H: Array, R: Array) -> Array:
    """S = H P H' + R (n, d, d) of n measurements, one by one; covariance (s, s), columns (n, k), H (n, d, k)."""
    half = H @ linalg.principal_blocks(covariance, columns) @ H.swapaxes(-1, -2) / 2
    return half + half.swapaxes(-1, -2) + R


def mahalanobis_squared(z: Array, S: Array) -> Array:
    """z' S^-1 z (n,) of innovations (n, d) with covariances (n, d, d); of 2 x 2, most pixels', by their factors."""
    if S.shape[1:] != (2, 2):
        return (z * np.linalg.solve(S, z[..., None])[..., 0]).sum(-1)
    a, b, c = S[:, 0, 0], S[:, 0, 1], S[:, 1, 1]
    x, y, ratio = z[:, 0], z[:, 1], b / a
    return x * x / a + (y - ratio * x) ** 2 / (c - ratio * b)


def by_information(S: Array, count: int) -> Indices:
    """The `count` rows whose innovation covariance (n, d, d) has the largest determinant, largest first.

    A measurement lowers the entropy of the state by log(det S / det R) / 2: with one R for all, the most uncertain
    prediction is the most informative. Davison (2005); the toolbox leaves R out. Ties: the earlier row.
    """
    return np.argsort(-linalg.log_determinants(S), kind="stable")[:count]


SELECTIONS: dict[str, Callable[[Array, int], Indices]] = {
    "information": by_information,
    "order": lambda S, count: np.arange(len(S))[:count],
}


def gate(probability: float, dof: int) -> float:
    """What z' S^-1 z has to be below to pass: a true measurement of `dof` numbers passes with this probability."""
    return math.inf if probability == 1 else chi2_quantile(probability, dof)
