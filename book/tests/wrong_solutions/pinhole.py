"""Wrong solutions of chapter pinhole."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _rho(r, d):
    return r * (1 + sum(c * r ** (2 * i) for i, c in enumerate(d, start=1)))


# -- 8.1 ---------------------------------------------------------------------------------------------------------------


@wrong("pinhole.1", "looks at the first coefficient only")
def first_alone(d1, d2):
    return 1 / np.sqrt(-3 * d1) if d1 < 0 else np.inf


@wrong("pinhole.1", "takes the last top instead of the first")
def last_top(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    roots = [t for t in ((-3 * d1 - np.sqrt(max(inside, 0))) / 2, (-3 * d1 + np.sqrt(max(inside, 0))) / 2) if t > 0]
    return 1 / np.sqrt(roots[0]) if inside >= 0 and roots else np.inf


@wrong("pinhole.1", "where the distorted radius is zero, not where it turns")
def zero_of_the_factor(d1, d2):
    inside = d1**2 - 4 * d2
    t = (-d1 + np.sqrt(inside)) / 2 if inside >= 0 else -1
    return 1 / np.sqrt(t) if t > 0 else np.inf


@wrong("pinhole.1", "forgets that the unknown is the square of the radius")
def square_of_it(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    t = (-3 * d1 + np.sqrt(inside)) / 2 if inside >= 0 else -1
    return 1 / t if t > 0 else np.inf


@wrong("pinhole.1", "passes over a double root, where the slope only touches zero")
def without_double_roots(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    t = (-3 * d1 + np.sqrt(inside)) / 2 if inside > 0 else -1
    return 1 / np.sqrt(t) if t > 0 else np.inf


@wrong("pinhole.1", "the quadratic formula in the squared radius, which cancels where d2 is tiny")
def cancelling(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    if d2 == 0:
        return 1 / np.sqrt(-3 * d1) if d1 < 0 else np.inf
    roots = (-3 * d1 + np.array([-1, 1]) * np.sqrt(max(inside, 0))) / (10 * d2)
    return np.sqrt(roots[roots > 0].min()) if inside >= 0 and (roots > 0).any() else np.inf


@wrong("pinhole.1", "nan, where there is no fold")
def nan_for_none(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    t = (-3 * d1 + np.sqrt(inside)) / 2 if inside >= 0 else -1
    return 1 / np.sqrt(t) if t > 0 else np.nan


@wrong("pinhole.1", "the root t itself, which is one over the square of the radius")
def root_of_t(d1, d2):
    inside = 9 * d1**2 - 20 * d2
    t = (-3 * d1 + np.sqrt(inside)) / 2 if inside >= 0 else -1
    return np.sqrt(t) if t > 0 else np.inf


# -- 8.2 ---------------------------------------------------------------------------------------------------------------


def _chain(point, k, d, *, by_radius=True, odd=False, depth=True):
    x, y, z = point
    ideal = np.array([x / z, y / z])
    q = np.hypot(*ideal) if odd else ideal @ ideal
    s = sum(c * q**i for i, c in enumerate(d, start=1))
    slope = sum(i * c * q ** (i - 1) for i, c in enumerate(d, start=1))
    by_ideal = (1 + s) * np.eye(2) + by_radius * 2 * slope * np.outer(ideal, ideal)
    by_point = np.array([[1, 0, -depth * x / z], [0, 1, -depth * y / z]]) / z
    return k[:2] + k[2:] * (1 + s) * ideal, np.diag(k[2:]) @ by_ideal @ by_point


@wrong("pinhole.2", "forgets that the factor of distortion changes too")
def factor_kept(point, k, d):
    return _chain(point, k, d, by_radius=False)


@wrong("pinhole.2", "odd powers too: d1 r instead of d1 r^2")
def odd_powers(point, k, d):
    return _chain(point, k, d, odd=True)


@wrong("pinhole.2", "forgets the derivative by the depth")
def without_depth(point, k, d):
    return _chain(point, k, d, depth=False)


@wrong("pinhole.2", "scales before it distorts")
def scaled_first(point, k, d):
    ideal = k[2:] * point[:2] / point[2]
    pixel, J = _chain(np.array([*ideal, 1.0]), np.array([*k[:2], 1, 1]), d)
    return pixel, J @ np.array([[k[2] / point[2], 0, 0], [0, k[3] / point[2], 0], [0, 0, 0]])


@wrong("pinhole.2", "the upside-down image behind the hole")
def upside_down(point, k, d):
    return _chain(point, np.array([*k[:2], *-k[2:]]), d)


@wrong("pinhole.2", "one factor of two less in the slope of the distortion")
def half_the_slope(point, k, d):
    (pixel, all_), (_, none) = _chain(point, k, d), _chain(point, k, d, by_radius=False)
    return pixel, (all_ + none) / 2


@wrong("pinhole.2", "focal lengths first")
def other_order(point, k, d):
    return _chain(point, np.array([*k[2:], *k[:2]]), d)


@wrong("pinhole.2", "one focal length for columns and rows")
def square_pixels(point, k, d):
    return _chain(point, np.array([*k[:3], k[2]]), d)


@wrong("pinhole.2", "the Jacobian of the distorted point, not of the pixel")
def without_focal_lengths(point, k, d):
    pixel, J = _chain(point, k, d)
    return pixel, J / k[2:, None]


# -- 8.3 ---------------------------------------------------------------------------------------------------------------


def _fixed_point(distorted, d, steps):
    u = np.array(distorted, dtype=float)
    for _ in range(steps):
        with np.errstate(all="ignore"):
            u = distorted / (1 + sum(c * (u @ u) ** i for i, c in enumerate(d, start=1)))
    return u


@wrong("pinhole.3", "five steps of the fixed-point iteration, as published")
def five_steps(distorted, d):
    return _fixed_point(distorted, d, 5)


@wrong("pinhole.3", "the same with two thousand steps, and nan where that does not settle")
def many_steps(distorted, d):
    u = _fixed_point(distorted, d, 2000)
    back = u * (1 + sum(c * (u @ u) ** i for i, c in enumerate(d, start=1)))
    return u if np.abs(back - distorted).max() < 1e-10 else np.full(2, np.nan)


@wrong("pinhole.3", "Newton's method alone, which may end beyond the fold")
def newton(distorted, d):
    goal = r = np.hypot(*distorted)
    for _ in range(300):
        slope = 1 + sum((2 * i + 1) * c * r ** (2 * i) for i, c in enumerate(d, start=1))
        r = r - (_rho(r, d) - goal) / slope
    found = abs(_rho(r, d) - goal) < 1e-9 and r >= 0
    return distorted * (r / goal if goal > 0 else 1) if found else np.full(2, np.nan)


@wrong("pinhole.3", "Newton's method alone, and nan where the fold does not reach so far")
def newton_and_fold(distorted, d):
    goal = np.hypot(*distorted)
    fold = _first_top(d)
    return np.full(2, np.nan) if np.isfinite(fold) and _rho(fold, d) < goal else newton(distorted, d)


def _first_top(d):
    roots = np.roots([1, *((2 * i + 1) * c for i, c in enumerate(d, start=1))])
    tops = roots.real[(np.abs(roots.imag) < 1e-7) & (roots.real > 1e-12)]
    return 1 / np.sqrt(tops.max()) if tops.size else np.inf


@wrong("pinhole.3", "the nearest that there is, instead of nan")
def nearest(distorted, d):
    goal = np.hypot(*distorted)
    low, high = 0.0, min(_first_top(d), 1e3)
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if _rho(middle, d) < goal else (low, middle)
    return distorted * (high / goal if goal > 0 else 1.0)


@wrong("pinhole.3", "the other sign of the coefficients")
def other_sign(distorted, d):
    return distorted * (1 - sum(c * (distorted @ distorted) ** i for i, c in enumerate(d, start=1)))


@wrong("pinhole.3", "the smallest root, also beyond the fold")
def smallest_root(distorted, d):
    goal = np.hypot(*distorted)
    polynomial = np.zeros(2 * len(d) + 2)
    polynomial[0], polynomial[1::2] = -goal, [1, *d]
    roots = np.roots(polynomial[::-1])
    roots = roots.real[(np.abs(roots.imag) < 1e-9) & (roots.real > 0)]
    if goal == 0:
        return np.zeros(2)
    return distorted * roots.min() / goal if roots.size else np.full(2, np.nan)


@wrong("pinhole.3", "nan in the centre, by a division by the radius")
def no_centre(distorted, d):
    with np.errstate(all="ignore"):
        found = smallest_root(distorted, d)
        return found / np.hypot(*distorted) * np.hypot(*distorted)


# -- 8.5 ---------------------------------------------------------------------------------------------------------------


@wrong("pinhole.5", "divides all four by two")
def all_halved(k):
    return k / 2


@wrong("pinhole.5", "moves the centre the wrong way")
def wrong_way(k):
    return np.array([(k[0] + 0.5) / 2, (k[1] + 0.5) / 2, k[2] / 2, k[3] / 2])


@wrong("pinhole.5", "takes half a pixel off after the halving")
def after_halving(k):
    return np.array([k[0] / 2 - 0.5, k[1] / 2 - 0.5, k[2] / 2, k[3] / 2])


@wrong("pinhole.5", "keeps the focal lengths")
def same_scale(k):
    return np.array([(k[0] - 0.5) / 2, (k[1] - 0.5) / 2, k[2], k[3]])


@wrong("pinhole.5", "moves the columns only")
def columns_alone(k):
    return np.array([(k[0] - 0.5) / 2, k[1] / 2, k[2] / 2, k[3] / 2])


@wrong("pinhole.5", "takes half a pixel off everything")
def all_moved(k):
    return (k - 0.5) / 2
