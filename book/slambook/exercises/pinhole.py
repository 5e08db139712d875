"""Checks of the chapter: the pin-hole camera."""

from typing import Any

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import array_of, cases, given, holds, is_finite, parts, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


def _factor(radius: Any, coefficients: Any) -> Any:
    """1 + d1 r^2 + d2 r^4 + ..., by which the distortion lengthens a radius."""
    return 1 + sum(c * radius ** (2 * i) for i, c in enumerate(coefficients, start=1))


@exercise("pinhole.1", "where the distortion folds", seed=81)
def fold(candidate: Candidate, rng: Rng) -> None:
    """The slope vanishes there, and nowhere before; where the answer is infinity, it vanishes nowhere."""
    known = [(-0.3, 0.0), (-0.3, 0.1), (0.0, 0.0), (0.0, -0.1), (-0.4, 0.03), (-0.3, 1e-16), (-0.625, 0.17578125)]
    for d1, d2 in cases([*known, *map(tuple, rng.uniform(-0.4, 0.4, (40, 2)))], "d1 = {:.4g}, d2 = {:.4g}"):
        found = float(np.asarray(candidate(d1, d2), dtype=float))
        slope = 3 * d1, 5 * d2  # of r (1 + d1 r^2 + d2 r^4)
        holds(not np.isnan(found), "the answer is a radius or infinity", f"found {found}")
        holds(found > 0, "the radius is above zero", f"found {found:.6g}")
        before = np.linspace(0, min(found, 1e3), 20001)[:-1]
        holds((_factor(before, slope) > 0).all(), "the slope is positive before the fold", f"found {found:.6g}")
        if np.isfinite(found):
            there = _factor(found, slope)
            holds(abs(there) <= 1e-8, "the slope is zero at the fold", f"at {found:.6g} it is {there:.3g}")
        elif d1 < 0 < d2:  # the slope falls and rises again
            least = _factor(np.sqrt(-0.3 * d1 / d2), slope)
            holds(least > 1e-9, "where the answer is infinity, the slope is zero nowhere", f"it falls to {least:.3g}")


@exercise("pinhole.2", "a pixel and its Jacobian", seed=82)
def pinhole(candidate: Candidate, rng: Rng) -> None:
    """Symmetry, scale and the centre fix the value; the Jacobian is that of the candidate's own value."""
    for d in ([], [-0.3, 0.1], [0.2], [-0.1, 0.05, -0.02, 0.01]):
        k = np.array([320, 240, 300, 400]) + rng.uniform(-20, 20, 4)

        def seen(point: Array, k: Array = k, d: Array = np.array(d)) -> list[Any]:  # noqa: B008
            found = parts(candidate(point, k, d), {"the pixel": None, "the Jacobian": None})
            holds(all(map(is_finite, found)), "pixel and Jacobian are numbers", f"found {found[0]} and {found[1]}")
            return parts(found, {"the pixel": (2,), "the Jacobian": (2, 3)})

        told = f"d = {d}, k = {k.round(1).tolist()} and the point "
        given(f"{told}[0, 0, 2]")
        same(seen(np.array([0, 0, 2.0]))[0], k[:2], "a point on the axis is seen at (u0, v0)")
        for _ in cases(range(4)):
            point = np.array([*rng.uniform(-1, 1, 2), rng.uniform(1, 3)])
            given(f"{told}{point.round(4).tolist()}")
            pixel, J = seen(point)
            same(seen(point / 3)[0], pixel, "a point on the same ray has the same pixel")
            ideal, distorted = point[:2] / point[2], (pixel - k[:2]) / k[2:]
            r = np.hypot(*ideal)
            same(distorted[0] * ideal[1], distorted[1] * ideal[0], "distortion moves along the radius", tolerance=1e-12)
            same(distorted @ ideal / r, r * _factor(r, d), "the distorted radius is r + d1 r^3 + d2 r^5 + ...")
            own = differences(lambda p, seen=seen: seen(p)[0], point)
            same(J, own, "the Jacobian is that of the pixel", tolerance=1e-6)


@exercise("pinhole.3", "undoing distortion")
def undistort(candidate: Candidate) -> None:
    """What was distorted comes back, from below the fold; where there is no ideal point, nan."""
    turns = np.array([[0.6, 0.8], [-1.0, 0.0], [0.28, -0.96]])
    lenses: list[tuple[list[float], list[float], float]] = [
        ([], [0.0, 0.3, 5.0], np.inf),
        ([-0.3, 0.1], [0.0, 0.3, 1.0, 2.5], np.inf),
        ([-0.3], [0.3, 0.9, 1.04], 1 / np.sqrt(0.9)),
        ([0.5], [0.3, 1.4, 3.0], np.inf),
        ([0.2, 0.05, 0.01], [0.5, 2.0], np.inf),
        ([-0.4, 0.04], [0.5, 0.9], 1.0),
        ([0.5216, 0.2841, -0.2112], [1.2203], 1.3316),  # Newton's method alone ends beyond the fold
    ]
    for d, radii, fold in lenses:
        for r, turn in cases((r, turn) for r in radii for turn in turns):
            distorted = r * turn * _factor(r, d)
            given(f"distorted {np.round(distorted, 4).tolist()}, d = {d}")
            found = np.asarray(candidate(distorted, np.array(d)), dtype=float)
            there = found.shape != (2,) or np.isfinite(found).all()
            holds(there, "where there is an ideal point, it is found", f"found {found}")
            radius = np.hypot(*array_of(found, (2,), "the ideal point"))
            otherwise = f"found radius {radius:.4g}, and the fold is at {fold:.4g}"
            holds(radius <= fold + 1e-9, "the ideal point lies below the fold", otherwise)
            same(found, r * turn, "the point that was distorted comes back, to ten digits", tolerance=1e-10)
    lost = ([-0.3], 0.71), ([-0.3], 3.0), ([-0.4, 0.04], 0.9), ([-0.4, 0.04], 2.0)
    for d, radius in cases(lost, "d = {} and the distorted radius {}"):
        found = np.asarray(candidate(radius * turns[0], np.array(d)), dtype=float)
        nan = found.shape == (2,) and np.isnan(found).all()
        holds(nan, "where there is no ideal point, the result is two nan", f"found {found}")


@exercise("pinhole.5", "half the image", seed=85)
def halved(candidate: Candidate, rng: Rng) -> None:
    """Where the four large pixels of a small one lie, their mean is the small one's centre."""
    for _ in range(5):
        k = np.array([320, 240, 300, 400]) + rng.uniform(-50, 50, 4)
        given(f"k = {k.round(2).tolist()}")
        small = array_of(candidate(k.copy()), (4,), "the intrinsics")
        same(small[2:], k[2:] / 2, "the focal lengths are halved")
        for pixel in rng.integers(0, 300, (4, 2)):
            given(f"k = {k.round(2).tolist()} and the small pixel {pixel.tolist()}")
            four = 2 * pixel + np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
            seen = small[:2] + small[2:] * ((four - k[:2]) / k[2:]).mean(axis=0)
            same(seen, pixel, "the mean ray of its four large pixels is the ray of a small one", tolerance=1e-10)
