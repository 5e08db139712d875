"""The chi-square distribution: how large a squared error may be before it tells against its covariance."""

import math
from functools import lru_cache

from slamlib.errors import NonFiniteError, SlamlibError


def chi2_cdf(x: float, dof: float) -> float:
    """Probability that a chi-square variable with `dof` degrees of freedom is below x. Numbers, not arrays."""
    positive(dof, "chi2_cdf", "dof")
    if math.isnan(x):
        raise NonFiniteError("chi2_cdf: x is nan")
    return 1.0 if x == math.inf else _gamma_p(dof / 2, x / 2) if x / 2 > 0 else 0.0


def chi2_quantile(probability: float, dof: float) -> float:
    """The x with chi2_cdf(x, dof) = probability, for 0 < probability < 1, to ten digits up to a million dof.

    A gate that a true measurement passes with probability p is chi2_quantile(p, dof of the innovation).

        >>> import slamlib as sl
        >>> round(sl.chi2_quantile(0.99, dof=2), 2)  # the gate of a pixel
        9.21
    """
    positive(dof, "chi2_quantile", "dof")
    if not 0 < probability < 1:
        raise SlamlibError(f"chi2_quantile: probability should lie between 0 and 1, got {probability}")
    return _quantile(float(probability), float(dof))


@lru_cache(maxsize=1024)  # gates and bands ask for the same few again and again
def _quantile(probability: float, dof: float) -> float:
    """By bisection of the distribution function."""
    a = dof / 2
    # Without its factor exp(-x/2) the density is larger, so that its integral reaches the probability sooner.
    low = 2 * math.exp((math.log(probability) + math.lgamma(a + 1)) / a) * (1 - 1e-9)
    high = max(dof, 2 * low)
    while chi2_cdf(high, dof) < probability:
        low, high = high, 2 * high
    while high - low > 1e-15 * high + 1e-300:
        x = math.sqrt(low) * math.sqrt(high) if high > 4 * low > 0 else (low + high) / 2
        low, high = (low, x) if chi2_cdf(x, dof) > probability else (x, high)
    return high


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


def positive(value: float, function: str, name: str) -> None:
    """Raise SlamlibError unless the value is."""
    if not value > 0 or not math.isfinite(value):
        raise SlamlibError(f"{function}: {name} should be positive and finite, got {value}")
