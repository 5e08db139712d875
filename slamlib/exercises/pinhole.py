"""Checks of the chapter: the pin-hole camera."""

from functools import partial
from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, jacobian_matches, pair, same

RETURNS = "a pixel and its Jacobian"


def _slope(radius: Any, coefficients: Any) -> Any:
    return 1 + sum((2 * i + 1) * c * radius ** (2 * i) for i, c in enumerate(coefficients, start=1))


@exercise("pinhole.1", "where the distortion folds")
def fold(candidate: Any) -> None:
    """The slope vanishes there, and nowhere before; where the answer is infinity, it vanishes nowhere."""
    rng = np.random.default_rng(81)
    cases = [(-0.3, 0.0), (-0.3, 0.1), (-0.5, 0.1), (0.2, -0.05), (0.2, 0.1), (0.0, 0.0), (0.0, -0.1), (-0.4, 0.03)]
    for d1, d2 in [*cases, *rng.uniform(-0.4, 0.4, (40, 2)).tolist()]:
        found = float(np.asarray(candidate(d1, d2), dtype=float))
        given = f"for d1 = {d1:.4g}, d2 = {d2:.4g}: found {found:.6g}"
        holds(found > 0, "the radius is above zero", given)
        before = np.linspace(0, min(found, 1e3), 20001)[:-1]
        holds((_slope(before, (d1, d2)) > 0).all(), "the slope is positive before the fold", given)
        if np.isfinite(found):
            same(_slope(found, (d1, d2)), 0.0, "the slope is zero at the fold", given=given, tolerance=1e-8)


def _pixel(candidate: Any, k: Any, d: Any, point: Any) -> Any:
    return pair(candidate(point, k, d), RETURNS)[0]


@exercise("pinhole.2", "a pixel and its Jacobian")
def pinhole(candidate: Any) -> None:
    """Symmetry, scale and the centre fix the value; the Jacobian is that of the candidate's own value."""
    rng = np.random.default_rng(82)
    for d in (np.array([]), np.array([-0.3, 0.1]), np.array([0.2]), np.array([-0.1, 0.05, -0.02, 0.01])):
        k = np.array([320, 240, 300, 400]) + rng.uniform(-20, 20, 4)
        axis, _ = pair(candidate(np.array([0, 0, 2.0]), k, d), RETURNS)
        same(array_of(axis, (2,), "the pixel"), k[:2], "a point on the axis is seen at (u0, v0)")
        for _ in range(4):
            point = np.array([*rng.uniform(-1, 1, 2), rng.uniform(1, 3)])
            seen, J = pair(candidate(point, k, d), RETURNS)
            seen = array_of(seen, (2,), "the pixel")
            nearer, _ = pair(candidate(point / 3, k, d), RETURNS)
            same(nearer, seen, "a point on the same ray has the same pixel")
            ideal, distorted = point[:2] / point[2], (seen - k[:2]) / k[2:]
            r = np.hypot(*ideal)
            same(distorted[0] * ideal[1], distorted[1] * ideal[0], "distortion moves along the radius", tolerance=1e-12)
            powers = sum(c * r ** (2 * i + 1) for i, c in enumerate(d, start=1))
            same(np.hypot(*distorted), r + powers, "the distorted radius is r + d1 r^3 + d2 r^5 + ...")
            J = array_of(J, (2, 3), "the Jacobian")
            own = partial(_pixel, candidate, k, d)
            jacobian_matches(J, own, point, "the Jacobian is that of the pixel")


@exercise("pinhole.3", "undoing distortion")
def undistort(candidate: Any) -> None:
    """Distorting the result gives back what was given; it lies below the fold; where none exists, nan."""
    turns = np.array([[0.6, 0.8], [-1.0, 0.0], [0.28, -0.96]])
    for d, radii, fold in (
        ([], [0.0, 0.3, 5.0], np.inf),
        ([-0.3, 0.1], [0.0, 0.3, 1.0, 2.5], np.inf),
        ([-0.3], [0.3, 0.9, 1.04], 1 / np.sqrt(0.9)),
        ([0.5], [0.3, 1.4, 3.0], np.inf),
        ([0.2, 0.05, 0.01], [0.5, 2.0], np.inf),
        ([-0.4, 0.04], [0.5, 0.9], 1.0),
    ):
        coefficients = np.array(d)
        for r in radii:
            for turn in turns:
                ideal = r * turn
                distorted = ideal * (1 + sum(c * r ** (2 * i) for i, c in enumerate(d, start=1)))
                given = f"distorted {np.round(distorted, 4).tolist()}, d = {d}"
                found = array_of(candidate(distorted, coefficients), (2,), "the ideal point")
                holds(
                    np.hypot(*found) <= fold + 1e-9,
                    "the ideal point lies below the fold",
                    f"for {given}: found radius {np.hypot(*found):.4g}, and the fold is at {fold:.4g}",
                )
                same(found, ideal, "distorting the result gives back what was given", given=given, tolerance=1e-9)
    for d, radius in (([-0.3], 0.71), ([-0.3], 3.0), ([-0.4, 0.04], 0.9), ([-0.4, 0.04], 2.0)):
        try:
            found = np.asarray(candidate(radius * turns[0], np.array(d)), dtype=float)
        except (TypeError, ValueError):
            found = np.zeros(2)
        holds(
            found.shape == (2,) and np.isnan(found).all(),
            "where no ideal point exists, the result is nan",
            f"for the distorted radius {radius} and d = {d}: found {found}",
        )


@exercise("pinhole.5", "half the image")
def halved(candidate: Any) -> None:
    """Where the four large pixels of a small one lie, their mean is the small one's centre."""
    rng = np.random.default_rng(85)
    for _ in range(5):
        k = np.array([320, 240, 300, 400]) + rng.uniform(-50, 50, 4)
        small = array_of(candidate(k.copy()), (4,), "the intrinsics")
        for column, row in rng.integers(0, 300, (4, 2)):
            four = np.array([[2 * column + i, 2 * row + j] for i in (0, 1) for j in (0, 1)], dtype=float)
            rays = (four - k[:2]) / k[2:]
            same(
                small[:2] + small[2:] * rays.mean(axis=0),
                np.array([column, row], dtype=float),
                "the mean ray of four pixels is the ray of the small one",
                tolerance=1e-10,
            )
        same(small[2:], k[2:] / 2, "the focal lengths are halved")
