"""Small linear algebra that checks its own results: in WebAssembly a failed factorization is NaN, not an exception."""

import functools
import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.errors import CovarianceError, NonFiniteError, ShapeError
from slamlib.spaces import Array


def finite(value: Array, shape: tuple[int, ...], function: str, argument: str) -> Array:
    """`value` as an array of floats of exactly this shape; raises ShapeError, NonFiniteError."""
    array = np.asarray(value, dtype=float)
    if array.shape != shape:
        raise ShapeError(f"{function}: {argument} should have shape {shape}, but has shape {array.shape}")
    bad = ~np.isfinite(array)
    if bad.any():
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        raise NonFiniteError(f"{function}: {argument} holds {array[where]} at index {where}; remove or mask it")
    return array


def covariance(value: Array, size: int, function: str, argument: str) -> Array:
    """A symmetric, positive semi-definite matrix (size, size); a number or a vector of variances is made a diagonal.

    Asymmetry up to 1e-9, and negative eigenvalues down to -1e-9, of the largest entry are taken as rounding.
    Raises CovarianceError, ShapeError, NonFiniteError.
    """
    array = np.asarray(value, dtype=float)
    if array.shape in ((), (size,)):
        array = np.diag(np.broadcast_to(array, (size,)))
    array = finite(array, (size, size), function, argument)
    scale = np.abs(array).max(initial=0)
    if np.abs(array - array.T).max(initial=0) > 1e-9 * scale:
        advice = "use (P + P.T) / 2 if only rounding is to blame"
        raise CovarianceError(f"{function}: {argument} is not symmetric, as a covariance must be; {advice}")
    array = (array + array.T) / 2
    least = np.linalg.eigvalsh(array)[0] if size else 0.0
    if not least >= -1e-9 * scale:
        advice = "a covariance has none (were standard deviations passed, or a difference of covariances?)"
        raise CovarianceError(f"{function}: {argument} has the negative eigenvalue {least:.3g}; {advice}")
    return array


def cholesky(matrix: Array, function: str, argument: str) -> Array:
    """Lower factor of a positive definite matrix; raises CovarianceError where there is none."""
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        factor = np.full_like(matrix, np.nan)
    if not np.isfinite(factor).all():
        least = float(np.linalg.eigvalsh(np.nan_to_num(matrix)).min())
        raise CovarianceError(f"{function}: {argument} is not positive definite (smallest eigenvalue {least:.3g})")
    return factor


def solve_lower(factor: Array, right: Array) -> Array:
    """Solution X of `factor @ X = right` for a lower triangular factor."""
    fast = _scipy("scipy.linalg", "solve_triangular")
    return fast(factor, right, lower=True, check_finite=False) if fast else np.linalg.solve(factor, right)


def subtract_square(matrix: Array, rows: Array) -> None:
    """matrix -= rows.T @ rows in place, for a contiguous symmetric matrix; it stays exactly symmetric."""
    matrix -= rows.T @ rows


@functools.cache
def _scipy(module: str, name: str) -> Callable[..., Any] | None:
    """A SciPy function, loaded at first use, or None where SciPy is not installed."""
    try:
        return getattr(importlib.import_module(module), name)
    except ModuleNotFoundError:
        return None


def joseph(P: Array, H: Array, R: Array, K: Array) -> Array:
    """(I - K H) P (I - K H)' + K R K': the corrected covariance for any gain K, not only the optimal one."""
    rest = np.eye(len(P)) - K @ H
    return rest @ P @ rest.T + K @ R @ K.T
