"""Where an axis has its ticks and what they say: round numbers, powers of ten."""

from typing import Any

import numpy as np

from slambook.figures.words import power_of_ten
from slamlib.manifolds import Array

STEPS = ((1.0, 0), (2.0, 2), (2.5, 0), (5.0, 0))  # and how many ticks more than `most` they may have
MINUS = "\N{MINUS SIGN}"


def nice_ticks(low: float, high: float, most: int = 7) -> Array:
    """Multiples of 1, 2, 2.5 or 5 times a power of ten in [low, high]: at least two, at most about `most` (4 to 7).

    Steps of 2 may be two more: they read better than the next ones.
    """
    span = high - low
    first = np.floor(np.log10(span / most)) - 1
    for step, spare in ((s * 10.0 ** (first + k), spare) for k in range(4) for s, spare in STEPS):
        slack = 1e-9 * span / step
        start, stop = np.ceil(low / step - slack), np.floor(high / step + slack)
        if stop - start + 1 <= most + spare:
            return np.clip(np.arange(start, stop + 1) * step, low, high) + 0.0
    return np.array([low, high])


def decades(low: float, high: float, most: int = 7) -> Array:
    """Powers of ten in [low, high], evenly thinned to `most`; within less than two decades, 1, 2 and 5 times those."""
    first, last = int(np.ceil(np.log10(low) - 1e-9)), int(np.floor(np.log10(high) + 1e-9))
    stride = next(k for k in range(1, 10_000) if (last // k) - -(-first // k) + 1 <= most)
    if last - first >= 1 and last // stride > -(-first // stride):
        return 10.0 ** np.arange(-(-first // stride) * stride, last + 1, stride, dtype=float)
    fine = [m * 10.0**k for k in range(first - 1, last + 1) for m in (1, 2, 5)]
    chosen = np.array([v for v in fine if low * (1 - 1e-9) <= v <= high * (1 + 1e-9)])
    return chosen if 2 <= len(chosen) <= most else nice_ticks(low, high, most)


def minor_decades(low: float, high: float, major: Array) -> Array:
    """2 to 9 times the powers of ten in [low, high], where each power has a tick of its own."""
    exponents = np.log10(major)
    if len(major) < 2 or not np.allclose(np.diff(exponents), 1):
        return np.empty(0)
    values = np.outer(10.0 ** np.arange(round(exponents[0]) - 1, round(exponents[-1]) + 1), np.arange(2, 10)).ravel()
    return values[(values >= low) & (values <= high)]


def labels(values: Any) -> list[str]:
    """What ticks say: one number of decimals for all, no offset, and powers of ten where digits would be too many."""
    values = np.asarray(values, dtype=float)
    if not len(values):
        return []
    largest = float(np.abs(values).max())
    exponent = int(np.floor(np.log10(largest) + 1e-9)) if largest > 0 else 0
    plain, scaled = _decimal(values), _decimal(values / 10.0**exponent)
    if -4 < exponent < 6 or max(map(len, plain)) <= max(map(len, scaled)) + 2:
        return plain
    return [f"{mantissa}·{power_of_ten(exponent)}" if mantissa.strip("0.") else "0" for mantissa in scaled]


def decade_labels(values: Any) -> list[str]:
    """What ticks of a logarithmic axis say: 10 to the power, or the number itself where it is not a power of ten."""
    exponents = np.log10(np.asarray(values, dtype=float))
    if len(exponents) and np.allclose(exponents, np.round(exponents)):
        return [power_of_ten(round(float(e))) for e in exponents]
    if np.all((exponents > -4) & (exponents < 5)):
        return [short(v) for v in values]
    return labels(values)


def short(value: float) -> str:
    """A number as short as possible, with a minus sign."""
    return f"{value + 0.0:.6g}".replace("-", MINUS)


def _decimal(values: Array) -> list[str]:
    apart = np.diff(np.unique(values))
    near = min(1e-3 * float(apart.min(initial=np.inf)), 1e-6 * float(np.abs(values).max())) if len(apart) else 1e-9
    digits = next((d for d in range(17) if np.abs(values - np.round(values, d)).max() <= near), 17)
    return [f"{round(float(v), digits) + 0.0:.{digits}f}".replace("-", MINUS) for v in values]
