"""Is a filter consistent? NEES, NIS, their chi-square bands, and RMSE.

What may be concluded: at one step, the average over independent runs is inside its 95 % band in 95 % of all
experiments, if the filter is consistent. What may not: steps of one run are correlated, so an average over time has no
such band; and a statistic inside its band does not prove the model right, it fails to prove it wrong. Bar-Shalom, Li
and Kirubarajan (2001), section 5.4.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.ma import MaskedArray

from slamlib.errors import CovarianceError, ShapeError, SlamlibError
from slamlib.kalman import linalg
from slamlib.kalman.chi_square import chi2_quantile, positive
from slamlib.manifolds import Array, finite, ranges

EXACT = 1e-12  # of the largest variance: what is smaller is rounding


def nees(error: Array, covariance: Array) -> Array:
    """Normalized estimation error squared e' P^-1 e; error (..., n), covariance (..., n, n). Expected value n.

    Of a masked array the numbers that are not masked count, with their marginal covariance: so many are then expected;
    a row without any is masked in the result. Raises CovarianceError where P is not positive definite, ShapeError,
    NonFiniteError.

        >>> import slamlib as sl
        >>> float(sl.nees([0.3, 0.4], [[0.1, 0], [0, 0.1]]).round(3))  # a consistent filter has 2 on average
        2.5
    """
    return _squared(error, covariance, "nees")


def nees_in_range(error: Array, covariance: Array, units: Sequence[int] = ()) -> tuple[float, int]:
    """NEES of an error (n,) within the range of P (n, n), and P's rank, the degrees of freedom of that NEES.

    A robot that drives in a plane of space, or a start without uncertainty, has a P that is singular but for rounding:
    what P claims to be known exactly is not judged. units: the numbers of rows that follow each other in one unit, as
    (3, 3) of a pose; (): all are in one. Rounding is what is 1e-12 of the largest variance in that unit. nan and 0
    where P is indefinite or zero, and so no covariance.
    """
    largest = [covariance.diagonal()[rows].max() for rows in ranges(units or [len(error)])]
    scale = np.repeat(np.sqrt(np.maximum(largest, 0.0)), units or [len(error)])
    scale[scale == 0] = np.inf  # such rows are zero
    values, directions = np.linalg.eigh(covariance / np.outer(scale, scale))
    rounding = EXACT * values[-1]
    if not values[-1] > 0 or values[0] < -rounding or (covariance.diagonal() < 0)[scale == np.inf].any():
        return float("nan"), 0
    kept = values > rounding
    if kept.all():
        return float(error @ np.linalg.solve(covariance, error)), len(error)
    along = directions[:, kept].T @ (error / scale)
    return float(along @ (along / values[kept])), int(kept.sum())


def nis(innovation: Array, covariance: Array) -> Array:
    """Normalized innovation squared z' S^-1 z; innovation (..., m), covariance (..., m, m). Expected value m.

    Masked arrays are treated as `nees` does. Raises CovarianceError where S is not positive definite, ShapeError,
    NonFiniteError.

        >>> import slamlib as sl
        >>> float(sl.nis([3, 4], [[4, 0], [0, 4]]).round(3))  # 5 px off, where 2 px are expected along each axis
        6.25
    """
    return _squared(innovation, covariance, "nis")


def _squared(vector: Array, matrix: Array, function: str) -> Array:
    if isinstance(vector, MaskedArray) and vector.ndim and np.shape(matrix)[-2:] == vector.shape[-1:] * 2:
        hidden = np.ma.getmaskarray(vector)  # an error of zero, with a variance of its own, adds nothing
        aside = hidden[..., :, None] | hidden[..., None, :]
        squares = _squared(vector.filled(0.0), np.where(aside, np.eye(vector.shape[-1]), matrix), function)
        gone = np.broadcast_to(hidden.all(-1), squares.shape)
        return np.ma.array(squares, mask=gone) if gone.any() else squares
    vector, matrix = finite(vector, None, function, "vector"), finite(matrix, None, function, "covariance")
    n = vector.shape[-1] if vector.ndim else 0
    if matrix.shape[-2:] != (n, n) or n == 0:
        raise ShapeError(
            f"{function}: a vector of shape {vector.shape} needs a matrix (..., {n}, {n}), got {matrix.shape}"
        )
    try:
        np.broadcast_shapes(vector.shape[:-1], matrix.shape[:-2])
    except ValueError:
        raise ShapeError(
            f"{function}: leading axes of the vector {vector.shape} and the covariance {matrix.shape} do not match"
        ) from None
    std = np.sqrt(np.abs(np.diagonal(matrix, axis1=-2, axis2=-1)))  # rows may be of different units
    if (np.abs(matrix - matrix.swapaxes(-1, -2)) > 1e-9 * std[..., :, None] * std[..., None, :]).any():
        raise CovarianceError(f"{function}: the covariance is not symmetric, as it must be")
    factor = linalg.cholesky(matrix, function, "covariance")
    white = np.linalg.solve(factor, vector[..., None])[..., 0]
    return (white * white).sum(-1)


def rmse(errors: Array, axis: int | tuple[int, ...] | None = None) -> Array:
    """Root mean square of the norm of errors (..., n), over `axis` of the leading axes (default: all).

    It measures how large the errors are, not whether the filter is consistent (NEES). Compare filters on the same runs.
    """
    errors = finite(errors, None, "rmse", "errors")
    if not errors.ndim or not errors.size:
        raise ShapeError(f"rmse: errors should have shape (..., n) and not be empty, but have shape {errors.shape}")
    return np.sqrt((errors * errors).sum(-1).mean(axis))


def band(dof: int, runs: int = 1, probability: float = 0.95) -> tuple[float, float]:
    """Interval of the average over `runs` independent runs of a chi-square statistic with `dof` degrees of freedom.

    For one step. Not for an average over the steps of a run: they are correlated, and its band is wider.

        >>> import slamlib as sl
        >>> [round(limit, 2) for limit in sl.band(dof=6, runs=50)]  # 95 % of all averages over 50 runs are inside
        [5.08, 7.0]
    """
    positive(dof, "band", "dof")
    positive(runs, "band", "runs")
    if not 0 < probability < 1:
        raise SlamlibError(f"band: probability should lie between 0 and 1, got {probability}")
    tail = (1 - probability) / 2
    return chi2_quantile(tail, dof * runs) / runs, chi2_quantile(tail, dof * runs, upper=True) / runs


def share_inside(series: Array, limits: tuple[float, float]) -> float:
    """Share of the values that lie inside the limits; near the band's probability for a consistent filter.

    How near cannot be inferred from one set of runs: the values at neighbouring steps are correlated.
    """
    series = finite(series, None, "share_inside", "series")
    if not series.size:
        raise ShapeError("share_inside: the series is empty")
    return float(np.mean((series >= limits[0]) & (series <= limits[1])))


@dataclass(frozen=True, eq=False)
class Consistency:
    """A statistic averaged over independent runs at each step, with its chi-square band."""

    name: str
    dof: int
    runs: int
    average: Array
    limits: tuple[float, float]
    probability: float = 0.95

    @classmethod
    def of(cls, statistic: Array, dof: int, *, name: str = "NEES", probability: float = 0.95) -> "Consistency":
        """Average the statistic of every run and step, shape (runs, steps)."""
        statistic = finite(statistic, None, "Consistency", "statistic")
        if statistic.ndim != 2 or not statistic.size:
            raise ShapeError(f"Consistency: the statistic should have shape (runs, steps), but has {statistic.shape}")
        runs = len(statistic)
        return cls(name, dof, runs, statistic.mean(0), band(dof, runs, probability), probability)

    @property
    def inside(self) -> float:
        """Share of the steps whose average lies inside the band."""
        return share_inside(self.average, self.limits)

    def __repr__(self) -> str:
        low, high = self.limits
        return (
            f"{self.name}: {self.dof} degrees of freedom, {self.runs} runs, {self.probability:.0%} band "
            f"[{low:.3f}, {high:.3f}], {self.inside:.1%} of {self.average.size} steps inside"
        )
