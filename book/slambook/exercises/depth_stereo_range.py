"""Checks of the chapter: depth, stereo, range and bearing."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, given, holds, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("depth_stereo_range.1", "the covariance of a stereo pair's position", seed=101)
def stereo_covariance(candidate: Candidate, rng: Rng) -> None:
    """Against differences of the triangulation itself; it scales with sigma squared."""
    for _ in cases(range(4)):
        f, b, sigma = rng.uniform(300, 900), rng.uniform(0.05, 0.5), rng.uniform(0.2, 1)
        x, y, z = rng.uniform(-2, 2), rng.uniform(-1, 1), rng.uniform(3, 12)
        given(f"x, y, z = {x:.3f} {y:.3f} {z:.3f} m, in units of the depth's variance")
        seen = np.array([f * x / z, f * y / z, f * (x - b) / z])
        J = sigma * differences(lambda p, f=f, b=b: b / (p[0] - p[2]) * np.array([p[0], p[1], f]), seen)
        wanted = J @ J.T
        scale = wanted[2, 2]
        found = covariance(candidate(x, y, z, f, b, sigma), 3) / scale
        same(found[2, 2], 1.0, "the variance of the depth", tolerance=1e-5)
        same(np.diag(found), np.diag(wanted) / scale, "the variances of x and y", tolerance=1e-5)
        same(found, wanted / scale, "the covariances between them", tolerance=1e-5)
        twice = array_of(candidate(x, y, z, f, b, 2 * sigma), (3, 3), "the covariance")
        same(twice / scale, 4 * wanted / scale, "twice the noise, four times the covariance", tolerance=1e-5)


@exercise("depth_stereo_range.2", "an innovation that wraps", seed=102)
def innovation(candidate: Candidate, rng: Rng) -> None:
    """The short way round, for any number of turns; range and pitch are left alone; batches."""
    turn = 2 * np.pi * np.array([0, 1, 0])
    for _ in cases(range(10)):
        expected, step = rng.uniform(-3, 3, 3), rng.uniform(-3, 3, 3) * [4, 1, 2]
        turns = rng.integers(-3, 4)
        given(f"{turns} turns apart")
        found = array_of(candidate(expected + step + turns * turn, expected), (3,), "the innovation")
        same(found[1], step[1], "the yaw goes the short way round")
        same(found[[0, 2]], step[[0, 2]], "range and pitch are plain differences")
    expected, step = rng.uniform(-3, 3, (4, 5, 3)), rng.uniform(-3, 3, (4, 5, 3))
    same(candidate(expected + step + rng.integers(-2, 3, (4, 5, 1)) * turn, expected), step, "batches of measurements")


@exercise("depth_stereo_range.3", "points from ranges", seed=103)
def points_from_ranges(candidate: Candidate, rng: Rng) -> None:
    """There and back through the pin-hole; a flat wall stays flat."""
    for _ in range(3):
        intrinsics = rng.uniform([200, 100, 200, 200], [400, 300, 500, 500])

        def found(points: Array, k: Array = intrinsics) -> Array:
            u, v = (k[:2] + k[2:] * points[:, :2] / points[:, 2:]).T
            return array_of(candidate(u, v, np.sqrt((points**2).sum(1)), k), points.shape, "the points")

        points = np.column_stack([rng.uniform(-3, 3, (30, 2)), rng.uniform(1, 6, 30)])
        seen = found(points)
        same((seen**2).sum(1) ** 0.5, (points**2).sum(1) ** 0.5, "the points are as far away as was measured")
        same(seen[:, :2] / seen[:, 2:], points[:, :2] / points[:, 2:], "they are seen at their pixels")
        same(seen, points, "they are the points")
        wall = np.column_stack([rng.uniform(-2, 2, (20, 2)), np.full(20, 2.5)])
        same(found(wall)[:, 2], wall[:, 2], "a flat wall stays flat")


@exercise("depth_stereo_range.5", "where two ranges meet", seed=105)
def two_places(candidate: Candidate, rng: Rng) -> None:
    """Both have both ranges, and the first lies to the left; ways in every direction."""
    for _ in cases(range(6)):
        a, way = rng.uniform(-5, 5, 2), rng.uniform(2, 6) * np.array([np.cos(t := rng.uniform(-3, 3)), np.sin(t)])
        beacon = a + rng.uniform(-1, 2) * way + rng.choice([-1, 1]) * rng.uniform(0.3, 1) * np.array([-way[1], way[0]])
        r, s = np.linalg.norm(beacon - a), np.linalg.norm(beacon - a - way)
        given(f"a = {a.round(3)}, b = {(a + way).round(3)}, r = {r:.3f}, s = {s:.3f} m")
        found = array_of(candidate(a, a + way, float(r), float(s)), (2, 2), "the two places")
        same(np.linalg.norm(found - a, axis=1), [r, r], "both have the first range from a")
        same(np.linalg.norm(found - a - way, axis=1), [s, s], "both have the second range from b")
        sides = way[0] * (found - a)[:, 1] - way[1] * (found - a)[:, 0]
        holds(sides[0] > 0, "the first lies to the left of the way")
        holds(sides[1] < 0, "the second lies to the right of it")
