"""The clocks of two trajectories: the unit of their times, and the offset between them.

Speeds and angular rates need no common axes: a body that is fixed to another turns as fast as it, and moves about as
fast. So the offset at which they correlate most is that of the clocks, whatever the two trajectories are aligned to.
"""

from dataclasses import dataclass, replace

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory, angles, matched_times
from slamlib.evaluation.trajectory_files import UNIT_NAMES
from slamlib.geometry.quaternion import product
from slamlib.manifolds import Array

LEAST_TOLERANCE = 0.02  # [s], of pairs: times of pictures, and of what they are compared with, jitter
WINDOW = 0.1  # [s], of speeds and angular rates, at least: over less they are noise
LEAST_WINDOWS = 5  # that a trajectory must last
SAMPLES = 20_000  # of a grid in time, at most
LEAST_CORRELATION = 0.6  # of an offset that is believed
AMBIGUOUS = 0.05  # two offsets are, unless the other leaves twice as much unexplained, and this share more


def interval(trajectory: Trajectory) -> float:
    """Median time [s] from one pose to the next; 0 for a single one."""
    return float(np.median(np.diff(trajectory.times))) if len(trajectory) > 1 else 0.0


def denser(one: Trajectory, other: Trajectory) -> float:
    """The interval [s] of the one of two trajectories whose poses are closer together."""
    return min(interval(one), interval(other))


def in_one_unit(path: Trajectory, reference: Trajectory) -> tuple[Trajectory, Trajectory, list[str]]:
    """The two with times in one unit, and a note where they were not: of 10^3, 10^6 and 10^9 the factor that pairs.

    Times pair if they are within half of the denser one's interval. They stay as they are where another unit doesn't
    pair ten times as many.
    """

    def pairs(factor: float) -> int:
        two = np.sort([factor * interval(path), interval(reference)])
        return len(matched_times(factor * path.times, reference.times, 0.5 * two[0])[0])

    factors = [10.0**power for power in (3, 6, 9)]
    best = max([*factors, *(1 / factor for factor in factors)], key=pairs)
    if pairs(best) < max(10 * pairs(1.0), 3):
        return path, reference, []
    larger, unit = ("reference", 1 / best) if best > 1 else ("path", best)
    name = next(name for size, name in UNIT_NAMES.items() if np.isclose(size, unit))
    note = f"the times of the {larger} are {1 / unit:.0f} times as large as the others: taken for {name}"
    if best > 1:
        return path, replace(reference, times=unit * reference.times), [note]
    return replace(path, times=unit * path.times), reference, [note]


@dataclass(frozen=True)
class TimeOffset:
    """What is added to a path's times [s]; what it was found from, and the correlation there."""

    seconds: float
    source: str
    correlation: float


def time_offset(path: Trajectory, reference: Trajectory) -> TimeOffset:
    """The offset [s] that, added to the times of a path, makes it move and turn when its reference does.

    The normalized correlation of speeds, and of angular rates, has its peak there, over all offsets at which half of
    the shorter trajectory is in both; the kind with the higher peak counts, and between the steps of the denser
    trajectory a parabola. Raises SlamlibError where nothing determines it: steady motion, or one that repeats itself.
    """
    spans = [t.times[-1] - t.times[0] for t in (path, reference)]
    step = max(denser(path, reference), max(spans) / SAMPLES)
    window = max(2 * interval(path), 2 * interval(reference), WINDOW)
    if min(spans) < LEAST_WINDOWS * window:
        raise SlamlibError("the time offset cannot be found from so few poses: give it (option offset)")
    moved, there = (_motion(trajectory, step, window) for trajectory in (path, reference))
    found = []
    for kind, own, other in zip(("speeds", "angular rates"), moved, there, strict=True):
        shares = _correlation(other, own)
        if shares is not None:
            found.append((float(np.nanmax(shares)), kind, shares))
    if not found or max(found)[0] < LEAST_CORRELATION:
        best = f": their correlation is {max(found)[0]:.2f} at most" if found else ""
        raise SlamlibError(
            "the time offset is not determined: neither speeds nor angular rates of path and reference vary alike"
            f"{best}; give it (option offset)"
        )
    peak, kind, shares = max(found)
    at, second = _peaks(shares)
    start = reference.times[0] - path.times[0] - (len(moved[0]) - 1) * step
    if second is not None and 1 - shares[second] < 2 * (1 - peak) + AMBIGUOUS:
        raise SlamlibError(
            f"the time offset is not determined: {start + at * step:.3f} s and {start + second * step:.3f} s fit "
            "alike, as of a motion that repeats itself; give it (option offset)"
        )
    return TimeOffset(float(start + (at + _vertex(shares[at - 1 : at + 2])) * step), kind, peak)


def _motion(trajectory: Trajectory, step: float, window: float) -> tuple[Array, Array]:
    """Speeds [m/s] and angular rates [rad/s] (k,), over a window [s], at times that are a step [s] apart."""
    middle = np.arange(trajectory.times[0] + window / 2, trajectory.times[-1] - window / 2, step)
    before, after = (_interpolated(trajectory, middle + sign * window / 2) for sign in (-1, 1))
    turned = product(before[:, 3:] * [1, -1, -1, -1], after[:, 3:])
    return np.linalg.norm(after[:, :3] - before[:, :3], axis=1) / window, angles(turned) / window


def _interpolated(trajectory: Trajectory, times: Array) -> Array:
    """Poses (k, 7) at other times (k,) [s], linear between those there are; outside the first or the last."""
    turns = trajectory.poses[:, 3:]
    flips = np.cumprod(np.where((turns[1:] * turns[:-1]).sum(1) < 0, -1.0, 1.0))  # q and -q are one rotation
    known = np.concatenate([trajectory.positions, turns * np.concatenate([[1.0], flips])[:, None]], axis=1)
    found = np.stack([np.interp(times, trajectory.times, column) for column in known.T], axis=1)
    found[:, 3:] /= np.linalg.norm(found[:, 3:], axis=1, keepdims=True)
    return found


def _correlation(a: Array, b: Array) -> Array | None:
    """Normalized correlations of a (n,) with b (m,) at each shift of b, from 1 - m to n - 1; None if one is constant.

    nan where less than half of the shorter one is in both. All sums over the common part are convolutions.
    """
    if min(a.std() / (abs(a).mean() + 1e-12), b.std() / (abs(b).mean() + 1e-12)) < 1e-6:
        return None
    size = len(a) + len(b) - 1
    length = 1 << (size - 1).bit_length()

    def sums(x: Array, y: Array) -> Array:
        found = np.fft.irfft(np.fft.rfft(x, length) * np.fft.rfft(y[::-1], length), length)
        return np.asarray(found[:size])

    a, b = (x - x.mean() for x in (a, b))  # digits are kept
    here, there = np.ones_like(a), np.ones_like(b)
    n = np.round(sums(here, there))
    cross = sums(a, b) - sums(a, there) * sums(here, b) / np.maximum(n, 1)
    square_a = sums(a * a, there) - sums(a, there) ** 2 / np.maximum(n, 1)
    square_b = sums(here, b * b) - sums(here, b) ** 2 / np.maximum(n, 1)
    least = 1e-3 * np.array([a @ a / len(a), b @ b / len(b)])
    usable = (n >= 0.5 * min(len(a), len(b))) & (square_a > least[0] * n) & (square_b > least[1] * n)
    return np.where(usable, cross / np.sqrt(np.where(usable, square_a * square_b, 1)), np.nan)


def _peaks(shares: Array) -> tuple[int, int | None]:
    """The index of the highest correlation, and of the highest one outside its peak, which ends at half its height."""
    known = np.where(np.isfinite(shares), shares, -1.0)
    at = int(known.argmax())
    low = np.flatnonzero(known < 0.5 * known[at])
    first, last = max(low[low < at], default=0), min(low[low > at], default=len(known))
    others = np.concatenate([np.arange(first), np.arange(last, len(known))])
    return at, int(others[known[others].argmax()]) if len(others) else None


def _vertex(three: Array) -> float:
    """Where the parabola through three values, at -1, 0 and 1, is highest; 0 where one is missing."""
    if len(three) < 3 or not np.isfinite(three).all():
        return 0.0
    return float(0.5 * (three[0] - three[2]) / (three[0] - 2 * three[1] + three[2]))
