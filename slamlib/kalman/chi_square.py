"""The chi-square distribution: how large a squared error may be before it tells against its covariance."""

import math
from functools import lru_cache

from slamlib.errors import NonFiniteError, SlamlibError


def chi2_cdf(x: float, dof: float) -> float:
    """Probability that a chi-square variable with `dof` degrees of freedom is below x. Numbers, not arrays."""
    return _tails(x, dof, "chi2_cdf")[0]


def chi2_sf(x: float, dof: float) -> float:
    """Probability that it is above x (survival function): 1 - chi2_cdf(x, dof), with all digits however small it is.

    >>> import slamlib as sl
    >>> round(sl.chi2_sf(16.0, dof=2), 7)  # so often a true measurement of two numbers has a nis above 16
    0.0003355
    """
    return _tails(x, dof, "chi2_sf")[1]


def _tails(x: float, dof: float, function: str) -> tuple[float, float]:
    positive(dof, function, "dof")
    if math.isnan(x):
        raise NonFiniteError(f"{function}: x is nan")
    return (0.0, 1.0) if x / 2 <= 0 else (1.0, 0.0) if x == math.inf else _gamma_tails(dof / 2, x / 2)


def chi2_quantile(probability: float, dof: float, *, upper: bool = False) -> float:
    """The x with chi2_cdf(x, dof) = probability, for 0 < probability < 1, to ten digits up to a million dof.

    upper: the x with chi2_sf(x, dof) = probability: a double holds 1e-20, and not 1 - 1e-20. A gate that a true
    measurement passes with probability p is chi2_quantile(p, dof of the innovation).

        >>> import slamlib as sl
        >>> round(sl.chi2_quantile(0.99, dof=2), 2), round(sl.chi2_quantile(0.01, dof=2, upper=True), 2)  # of a pixel
        (9.21, 9.21)
    """
    positive(dof, "chi2_quantile", "dof")
    if not 0 < probability < 1:
        raise SlamlibError(f"chi2_quantile: probability should lie between 0 and 1, got {probability}")
    if probability > 0.5:  # of the smaller of the two tails a double holds all digits
        return _quantile(1 - float(probability), float(dof), not upper)
    return _quantile(float(probability), float(dof), upper)


@lru_cache(maxsize=1024)  # gates and bands ask for the same few again and again
def _quantile(tail: float, dof: float, upper: bool) -> float:
    """By bisection of the probability of one tail."""
    a = dof / 2

    def beyond(x: float) -> bool:
        below, above = _tails(x, dof, "chi2_quantile")
        return above < tail if upper else below > tail

    # Without its factor exp(-x/2) the density is larger, so that its integral reaches the probability sooner.
    low = 2 * math.exp((math.log(0.5 if upper else tail) + math.lgamma(a + 1)) / a) * (1 - 1e-9)
    high = max(dof, 2 * low)
    while not beyond(high):
        low, high = high, 2 * high
    while high - low > 1e-15 * high + 1e-300:
        x = math.sqrt(low) * math.sqrt(high) if high > 4 * low > 0 else (low + high) / 2
        low, high = (low, x) if beyond(x) else (x, high)
    return high


def _gamma_tails(a: float, x: float) -> tuple[float, float]:
    """Regularised lower and upper incomplete gamma function: series below a + 1, continued fraction above.

    DLMF 8.9, 8.11. The one that is computed has all digits: the series that of a lower tail, the fraction of an upper.
    """
    front = math.exp(a * math.log(x) - x - math.lgamma(a))
    if x < a + 1:
        term = total = 1 / a
        k = a
        while abs(term) > 1e-17 * total:
            k += 1
            term *= x / k
            total += term
        return front * total, 1 - front * total
    rest = front * _gamma_fraction(a, x)
    return 1 - rest, rest


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
