"""Does a filter know what it does not know? NEES, NIS, their chi-square bands, and errors.

What may be concluded: at one step, the average over independent runs is inside its 95 % band in 95 % of all
experiments, if the filter is consistent. What may not: steps of one run are correlated, so an average over time has no
such band; and a statistic inside its band does not prove the model right, it fails to prove it wrong. Bar-Shalom, Li
and Kirubarajan (2001), section 5.4.
"""

import math
from dataclasses import dataclass

import numpy as np

from slamlib import linalg
from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.spaces import Array


def nees(error: Array, covariance: Array) -> Array:
    """Normalized estimation error squared e' P^-1 e; error (..., n), covariance (..., n, n). Expected value n.

    Raises CovarianceError where P is not positive definite, ShapeError, NonFiniteError.
    """
    return _squared(error, covariance, "nees", "covariance")


def nis(innovation: Array, covariance: Array) -> Array:
    """Normalized innovation squared z' Z^-1 z; innovation (..., m), covariance (..., m, m). Expected value m."""
    return _squared(innovation, covariance, "nis", "covariance")


def _squared(vector: Array, matrix: Array, function: str, argument: str) -> Array:
    vector, matrix = np.asarray(vector, dtype=float), np.asarray(matrix, dtype=float)
    n = vector.shape[-1] if vector.ndim else 0
    if matrix.shape[-2:] != (n, n) or n == 0:
        raise ShapeError(
            f"{function}: a vector of shape {vector.shape} needs a matrix (..., {n}, {n}), got {matrix.shape}"
        )
    for name, array in (("vector", vector), (argument, matrix)):
        if not np.isfinite(array).all():
            raise NonFiniteError(
                f"{function}: the {name} holds nan or infinity; leave out the steps that were not estimated"
            )
    factor = linalg.cholesky(matrix, function, argument)
    white = np.linalg.solve(factor, vector[..., None])[..., 0]
    return (white * white).sum(-1)


def rmse(errors: Array, axis: int | tuple[int, ...] | None = None) -> Array:
    """Root mean square of the norm of errors (..., n), over `axis` of the leading axes (default: all)."""
    errors = np.asarray(errors, dtype=float)
    return np.sqrt((errors * errors).sum(-1).mean(axis))


def chi2_cdf(x: float, dof: float) -> float:
    """Probability that a chi-square variable with `dof` degrees of freedom is below x."""
    _positive(dof, "chi2_cdf", "dof")
    return _gamma_p(dof / 2, x / 2) if x > 0 else 0.0


def chi2_quantile(probability: float, dof: float) -> float:
    """The x with chi2_cdf(x, dof) = probability, for 0 < probability < 1."""
    _positive(dof, "chi2_quantile", "dof")
    if not 0 < probability < 1:
        raise SlamlibError(f"chi2_quantile: probability should lie between 0 and 1, got {probability}")
    low, high = 0.0, dof
    while chi2_cdf(high, dof) < probability:
        low, high = high, 2 * high
    x = (low + high) / 2
    for _ in range(200):
        excess = chi2_cdf(x, dof) - probability
        low, high = (low, x) if excess > 0 else (x, high)
        slope = math.exp((dof / 2 - 1) * math.log(x / 2) - x / 2 - math.lgamma(dof / 2)) / 2
        newton = x - excess / slope if slope > 0 else low
        following = newton if low < newton < high else (low + high) / 2
        if abs(following - x) <= 1e-15 * x:
            break
        x = following
    return x


def _gamma_p(a: float, x: float) -> float:
    """Regularised lower incomplete gamma function: series below a + 1, continued fraction above (DLMF 8.9, 8.11)."""
    front = math.exp(a * math.log(x) - x - math.lgamma(a))
    if x < a + 1:
        term = total = 1 / a
        k = a
        while abs(term) > 1e-17 * total:
            k += 1
            term *= x / k
            total += term
        return front * total
    return 1 - front * _gamma_fraction(a, x)


def _gamma_fraction(a: float, x: float) -> float:
    """Lentz's evaluation of the continued fraction of the upper incomplete gamma function."""
    b = x + 1 - a
    c, d = 1e300, 1 / b
    value = d
    for i in range(1, 10000):
        step = -i * (i - a)
        b += 2
        d = 1 / (step * d + b)
        c = b + step / c
        value *= d * c
        if abs(d * c - 1) < 1e-16:
            break
    return value


def _positive(value: float, function: str, name: str) -> None:
    if not value > 0 or not math.isfinite(value):
        raise SlamlibError(f"{function}: {name} should be positive, got {value}")


def band(dof: int, runs: int = 1, probability: float = 0.95) -> tuple[float, float]:
    """Where the average over `runs` independent runs of a chi-square statistic with `dof` degrees of freedom lies."""
    tail = (1 - probability) / 2
    return chi2_quantile(tail, dof * runs) / runs, chi2_quantile(1 - tail, dof * runs) / runs


def share_inside(series: Array, limits: tuple[float, float]) -> float:
    """Share of the values that lie inside the limits."""
    series = np.asarray(series)
    return float(np.mean((series >= limits[0]) & (series <= limits[1])))


@dataclass(frozen=True)
class Consistency:
    """A statistic averaged over independent runs at each step, beside its chi-square band."""

    name: str
    dof: int
    runs: int
    average: Array
    limits: tuple[float, float]
    probability: float = 0.95

    @classmethod
    def of(cls, statistic: Array, dof: int, *, name: str = "NEES", probability: float = 0.95) -> "Consistency":
        """From the statistic of every run and step, shape (runs, steps)."""
        statistic = np.asarray(statistic, dtype=float)
        if statistic.ndim != 2:
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
