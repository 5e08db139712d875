"""Small linear algebra that checks its own results: in WebAssembly a failed factorization is NaN, not an exception.

SciPy's BLAS is used where SciPy is installed and the problem is large enough to gain; it is loaded at first use.
"""

import functools
import importlib
import math
import operator
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import CovarianceError, NonFiniteError
from slamlib.manifolds import Array, Indices, all_finite, finite, numbers

quiet_floats = np.errstate(over="ignore", invalid="ignore")  # results are checked: an overflow is an error

# Sizes from which the triangular product of BLAS repays its mirroring: benchmarks/covariance_update.py.
# Of two products, W'W and a carry's, NumPy makes a matrix each, and reads the second across.
_LARGE, _LARGE_CARRIED = 400, 100
_SMALL = 4  # numbers of a measurement up to which Python's floats are quicker than LAPACK
_SLACK = 1e-9  # of each row: an eigenvalue of correlations, below zero by this, is taken as rounding
_ROUNDING = 4 * float(np.finfo(float).eps)  # of each row, beside the variance


def check_overflow(function: str, *results: Array) -> None:
    """Raise NonFiniteError where finite arguments gave a covariance beyond the range of floating point."""
    if not all(map(all_finite, results)):
        raise NonFiniteError(f"{function}: the covariance overflows; choose units in which the numbers are smaller")


def covariance(value: ArrayLike, size: int, function: str, argument: str) -> Array:
    """Check a symmetric, positive semi-definite (size, size); a number or vector of variances becomes a diagonal.

    Rows may be of different units: each entry is judged beside the standard deviations of its row and its column.
    Asymmetry up to 1e-9 of their product, and eigenvalues of the correlations down to -1e-9, are taken as rounding.
    Raises CovarianceError, ShapeError, NonFiniteError.
    """
    array = numbers(value, function, argument)
    if array.shape in ((), (size,)):
        array = np.diag(np.broadcast_to(array, (size,)))
    array = finite(array, (size, size), function, argument)
    what = f"{function}: {argument}"
    array = _symmetric(array, what)
    if _factor(array + np.diag(_SLACK * size * array.diagonal())) is None:  # as if all correlations had so much more
        _check_semidefinite(array, what)
    return array


def check_variances(matrix: Array, function: str, argument: str) -> None:
    """Raise CovarianceError for a finite matrix (n, n) that is not symmetric, or has a negative variance.

    That is no proof of a covariance, and quick: for one of a whole map that was one when it was saved.
    """
    what = f"{function}: {argument}"
    _check_diagonal(_symmetric(matrix, what), what)


def _symmetric(array: Array, what: str) -> Array:
    if (array == array.T).all():  # mostly the case
        return array.copy()
    half = array / 2
    skew = np.abs(half - half.T)
    array = half + half.T
    std = np.sqrt(np.abs(array.diagonal()))
    if (skew > 0.5e-9 * np.outer(std, std) + _rounding_of(array)).any():
        advice = "use (P + P.T) / 2 if only rounding is to blame"
        raise CovarianceError(f"{what} is not symmetric, as a covariance must be; {advice}")
    return array


def check_covariances(values: Array, function: str, argument: str) -> None:
    """Raise CovarianceError for the first of many matrices (k, n, n) that `covariance` refuses."""
    std = np.sqrt(np.abs(np.diagonal(values, axis1=-2, axis2=-1)))
    products = std[:, :, None] * std[:, None, :]
    skew = np.abs(values - values.swapaxes(-1, -2))
    doubtful = (skew > 1e-12 * products).any((1, 2)) | (std == 0).any(1)
    doubtful[~doubtful] = np.linalg.eigvalsh(values[~doubtful] / products[~doubtful])[:, 0] < 0
    for i in np.flatnonzero(doubtful):
        covariance(values[i], values.shape[-1], function, f"{argument} at index {i}")


def _rounding_of(array: Array) -> float:
    """What an entry of a matrix may be off by, where it was computed from numbers as large as the largest."""
    return _ROUNDING * len(array) * float(np.abs(array).max(initial=0))


def _check_semidefinite(array: Array, what: str) -> None:
    """Raise CovarianceError for a symmetric matrix (n, n) that is no covariance, in whatever units its rows are."""
    _check_diagonal(array, what)
    variances, slack = array.diagonal(), _rounding_of(array)
    std = np.sqrt(np.maximum(variances, 0))
    free = std > 0
    alone = np.abs(array[~free]).max(initial=0)
    if alone > slack:
        i, j = np.argwhere(np.abs(array) * ~free[:, None] == alone)[0].tolist()
        raise CovarianceError(f"{what} has no variance at index {i}, and yet a covariance {alone:.3g} with {j}")
    correlations = array[np.ix_(free, free)] / np.outer(std[free], std[free])
    least = np.linalg.eigvalsh(correlations)[0] if free.any() else 0.0
    if not least >= -_SLACK * len(array):
        raise CovarianceError(
            f"{what} has the negative eigenvalue {np.linalg.eigvalsh(array)[0]:.3g} ({least:.3g} of its correlations); "
            f"{_ADVICE}"
        )


_ADVICE = "a covariance has none (were standard deviations passed, or a difference of covariances?)"


def _check_diagonal(array: Array, what: str) -> None:
    variances = array.diagonal()
    if (variances < -_rounding_of(array)).any():
        i = int(variances.argmin())
        raise CovarianceError(f"{what} has the negative variance {variances[i]:.3g} at index {i}; {_ADVICE}")


def _factor(matrix: Array) -> Array | None:
    """Lower Cholesky factors of (..., n, n); None where there is none, or only by rounding."""
    if matrix.ndim == 2 and 0 < len(matrix) <= _SMALL:
        return small_cholesky(matrix, _ROUNDING)
    try:
        factor: Any = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return None
    # What earlier rows leave of each variance, relative to that variance: so mixed units do no harm. NaN is not >.
    own = np.diagonal(factor, axis1=-2, axis2=-1) ** 2
    rounding = _ROUNDING * matrix.shape[-1] * np.diagonal(matrix, axis1=-2, axis2=-1)
    return factor if (own > rounding).all() else None


def cholesky(matrix: Array, function: str, argument: str) -> Array:
    """Lower factors of positive definite matrices (..., n, n); raises CovarianceError, also where it is so nearly
    singular that rounding decides."""
    factor = _factor(matrix)
    if factor is None:
        least = np.linalg.eigvalsh(np.nan_to_num(matrix))[..., 0]
        where = tuple(int(i) for i in np.unravel_index(np.argmin(least), least.shape))
        place = f" at index {where}" if where else ""
        raise CovarianceError(
            f"{function}: {argument}{place} is not positive definite (smallest eigenvalue {least[where]:.3g})"
        )
    return factor


def solve_lower(factor: Array, right: Array) -> Array:
    """Solution X of `factor @ X = right` for a lower triangular factor (n, n) and right (n,) or (n, k).

    Never through an inverse of the factor: that is quicker, and thirty times less accurate where S is near singular.
    """
    fast = _scipy("scipy.linalg.blas", "dtrsv" if right.ndim == 1 else "dtrsm") if right.size else None
    if not fast:
        solution: Any = np.linalg.solve(factor, right)
        return solution
    # BLAS counts columns first: factor' is upper triangular, and X' = right' (factor')^-1.
    return fast(factor.T, right, trans=1) if right.ndim == 1 else fast(1.0, factor.T, right.T, side=1).T


def left_inverse(N: Array) -> Array:
    """L (..., r, n) with L N = I, for N (..., n, r) of rank r: the inverse where it has as many rows."""
    invert = np.linalg.inv if N.shape[-2] == N.shape[-1] else np.linalg.pinv
    return np.asarray(invert(N), dtype=float)


Following = tuple[Indices, Indices, Array]  # rows (k, a), rows (k, b), F (k, b, a)


class Carry(NamedTuple):
    """A change of the coordinates of errors, T = (I + C L E) (I + D_n) ... (I + D_1); E picks `rows`.

    rows (k,) of the covariance, C (n, r), L (r, k). following: in each D some rows follow others near them: to the
    errors of rows (k, b) it adds F times those of rows (k, a). These may be the same: blocks that become I + F times
    what they were.
    """

    rows: Indices
    C: Array
    L: Array
    following: Sequence[Following] = ()


def subtract_square(matrix: Array, rows: Array, carry: Carry | None = None) -> None:
    """matrix -= rows.T @ rows in place; a symmetric matrix stays exactly symmetric.

    carry: the result P then becomes T P T' = P + C h + h' C'. These two have as many positive eigenvalues as negative
    ones, so that no product of one sign adds them together with -W'W: they are a pass of their own over the triangle,
    and 2 r / m of the flops of W'W.

    NumPy computes W'W as a symmetric product. BLAS can update one triangle in place, which is then mirrored; but only
    a contiguous matrix: of a view into a larger array its wrapper silently updates a copy.
    """
    if carry:
        at, C, L, following = carry
        if following:
            rows = rows.copy()
            for each in following:
                _follow(matrix, rows, *each)
        h = np.dot(L, matrix.take(at, axis=0))  # np.dot: of matrices so small it is quicker than @
        h -= np.dot(np.dot(rows.take(at, axis=1), L.T).T, rows)  # L E (P - W'W)
        h += np.dot(np.dot(h.take(at, axis=1), L.T / 2), C.T)
    large = len(matrix) >= (_LARGE_CARRIED if carry else _LARGE) and len(rows) and matrix.flags.c_contiguous
    fast, twice = (_scipy("scipy.linalg.blas", name) if large else None for name in ("dsyrk", "dsyr2k"))
    if fast:
        fast(-1.0, rows.T, 1.0, matrix.T, overwrite_c=1)
        if carry and twice:
            twice(1.0, C, h.T, 1.0, matrix.T, overwrite_c=1)
        _mirror(matrix)
    else:
        matrix -= rows.T @ rows
        if carry:
            change = C @ h
            matrix += change + change.T


def _follow(matrix: Array, rows: Array, sources: Indices, targets: Indices, F: Array) -> None:
    """matrix becomes (I + D) matrix (I + D)', and rows (d, n) become rows (I + D)', in place; D as of Carry."""
    by, to = F.swapaxes(1, 2), targets.ravel()
    change = rows.take(sources, axis=1).swapaxes(0, 1) @ by  # (k, d, b)
    rows[:, to] += change.swapaxes(0, 1).reshape(len(rows), -1)
    own = matrix.take(targets, axis=0) + F @ matrix.take(sources, axis=0)  # (k, b, n)
    own = own.reshape(len(to), -1)
    corner = (own.take(sources, axis=1).swapaxes(0, 1) @ by).swapaxes(0, 1).reshape(len(to), -1)
    corner += own.take(to, axis=1)
    own[:, to] = (corner + corner.T) / 2
    matrix[to] = own
    matrix[:, to] = own.T


_WIDTH = 64  # of the blocks in which a matrix is mirrored: they fit the cache
_BELOW = np.tri(_WIDTH, k=-1, dtype=bool)


def _mirror(matrix: Array) -> None:
    """Copy the lower triangle over the upper one, block by block."""
    for start in range(0, len(matrix), _WIDTH):
        stop = min(start + _WIDTH, len(matrix))
        matrix[:start, start:stop] = matrix[start:stop, :start].T
        corner, size = matrix[start:stop, start:stop], stop - start
        np.copyto(corner.T, corner, where=_BELOW[:size, :size])


def replace_rows(matrix: Array, old: slice, rows: Array, corner: Array) -> Array:
    """Replace the rows and columns `old` of a symmetric matrix by others: `rows` (k, n), whose columns
    `old` are not used, and `corner` (k, k)."""
    head, tail = slice(0, old.start), slice(old.stop, len(matrix))
    end = old.start + len(corner)
    result = np.empty((len(matrix) - old.stop + end,) * 2)
    result[head, head], result[head, end:] = matrix[head, head], matrix[head, tail]
    result[end:, head], result[end:, end:] = matrix[tail, head], matrix[tail, tail]
    result[old.start : end, head], result[old.start : end, end:] = rows[:, head], rows[:, tail]
    result[head, old.start : end], result[end:, old.start : end] = rows[:, head].T, rows[:, tail].T
    result[old.start : end, old.start : end] = corner / 2 + corner.T / 2
    return result


@functools.cache
def _scipy(module: str, name: str) -> Callable[..., Any] | None:
    """A SciPy function, loaded at first use, or None where SciPy is not installed."""
    try:
        return getattr(importlib.import_module(module), name)
    except ModuleNotFoundError:
        return None


def joseph(P: Array, H: Array, R: Array, K: Array) -> Array:
    """(I - K H) P (I - K H)' + K R K': the updated covariance for any gain K, not only the optimal one.

    P (n, n), H (m, n), R (m, m), K (n, m); single precision stays single. The belief does not use it: for the optimal
    gain it equals P - W'W, and costs two dense products of size n where the touched rows need none.
    """
    P, H, R, K = (np.asarray(a) for a in (P, H, R, K))
    m, n = H.shape if H.ndim == 2 else (1, len(np.atleast_1d(P)))
    for name, array, shape in (("P", P, (n, n)), ("H", H, (m, n)), ("R", R, (m, m)), ("K", K, (n, m))):
        finite(array, shape, "joseph", name)
    rest = np.eye(n, dtype=P.dtype) - K @ H
    return rest @ P @ rest.T + K @ R @ K.T


# -- small matrices, one or many: closed forms and Python's floats, where a call of LAPACK would take longer -----------


def small_cholesky(matrix: Array, rounding: float) -> Array | None:
    """Lower Cholesky factor of one matrix (n, n); None where there is none, or only by rounding.

    Row by row on Python's floats, four times as fast as preparing a call of LAPACK. l_ij = (a_ij - l_i . l_j) / l_jj
    for j < i, and l_ii^2 = a_ii - l_i . l_i, over the columns before j and i. rounding: relative to n and the variance.
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


def principal_blocks(matrix: Array, rows: Indices) -> Array:
    """Blocks (n, k, k) of a matrix (s, s): for each row of `rows` (n, k), those rows and columns."""
    return matrix.ravel().take(rows[:, :, None] * len(matrix) + rows[:, None, :])


def touched_rows(size: int, columns: Sequence[Indices]) -> tuple[Indices, list[Indices]]:
    """The rows (k,) of a matrix (size, size) that any array of `columns` names, in their order, and of each array the
    places of its rows among these: what np.unique tells, without sorting."""
    place = np.zeros(size, dtype=int)
    for named in columns:
        place[named] = 1
    touched = np.flatnonzero(place)
    place[touched] = np.arange(len(touched))
    return touched, [place[named] for named in columns]


def log_determinants(matrices: Array) -> Array:
    """Logarithms of the determinants (n,) of positive definite matrices (n, d, d); of 2 x 2, most pixels', directly."""
    if matrices.shape[1:] != (2, 2):
        return np.linalg.slogdet(matrices)[1]
    a, b, c = matrices[:, 0, 0], matrices[:, 0, 1], matrices[:, 1, 1]
    return np.log(a) + np.log(c - b * b / a)
