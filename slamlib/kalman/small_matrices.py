"""Small matrices, one or many: closed forms and Python's floats, where a call of LAPACK would take longer."""

import math
import operator

import numpy as np

from slamlib.manifolds import Array, Indices


def factor(matrix: Array, rounding: float) -> Array | None:
    """Lower Cholesky factor of one matrix (n, n), or None where there is none, or one by the grace of rounding alone.

    Row by row on Python's floats, four times as quick as to prepare a call of LAPACK. l_ij = (a_ij - l_i . l_j) / l_jj
    for j < i, and l_ii^2 = a_ii - l_i . l_i, over the columns before j and i. rounding: beside n and the variance.
    """
    rows: list[list[float]] = []
    for i, row in enumerate(matrix.tolist()):
        found: list[float] = []
        for j in range(i):
            found.append((row[j] - _dot(found, rows[j])) / rows[j][j])
        own = row[i] - _dot(found, found)
        if not own > rounding * len(matrix) * row[i]:
            return None
        rows.append([*found, math.sqrt(own), *[0.0] * (len(matrix) - i - 1)])
    return np.array(rows)


def _dot(a: list[float], b: list[float]) -> float:
    """Sum of the products of two lists' numbers, as many as the shorter one has."""
    return sum(map(operator.mul, a, b))


def corners(matrix: Array, rows: Indices) -> Array:
    """Blocks (n, k, k) of a matrix (s, s): of each row of `rows` (n, k) those rows and columns."""
    return matrix.ravel().take(rows[:, :, None] * len(matrix) + rows[:, None, :])


def log_determinants(matrices: Array) -> Array:
    """Logarithms of the determinants (n,) of positive definite matrices (n, d, d); of 2 x 2, most pixels', directly."""
    if matrices.shape[1:] != (2, 2):
        return np.linalg.slogdet(matrices)[1]
    a, b, c = matrices[:, 0, 0], matrices[:, 0, 1], matrices[:, 1, 1]
    return np.log(a) + np.log(c - b * b / a)


def squares(z: Array, matrices: Array) -> Array:
    """z' Z^-1 z (n,) of vectors (n, d) and positive definite matrices (n, d, d); of 2 x 2 by their Cholesky factors."""
    if matrices.shape[1:] != (2, 2):
        squared: Array = (z * np.linalg.solve(matrices, z[..., None])[..., 0]).sum(-1)
        return squared
    a, b, c = matrices[:, 0, 0], matrices[:, 0, 1], matrices[:, 1, 1]
    x, y, ratio = z[:, 0], z[:, 1], b / a
    return x * x / a + (y - ratio * x) ** 2 / (c - ratio * b)
