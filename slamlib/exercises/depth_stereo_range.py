"""Checks of the chapter: depth, stereo, range and bearing."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, differences, same


@exercise("depth_stereo_range.1", "the covariance of a stereo pair's position")
def stereo_covariance(candidate: Any) -> None:
    """Against differences of the triangulation itself; it scales with sigma squared."""
    rng = np.random.default_rng(101)
    for _ in range(4):
        f, b, sigma = rng.uniform(300, 900), rng.uniform(0.05, 0.5), rng.uniform(0.2, 1)
        x, y, z = rng.uniform(-2, 2), rng.uniform(-1, 1), rng.uniform(3, 12)

        def triangulated(pixels: Any, f: float = f, b: float = b) -> Any:
            left, row, right = pixels
            return b / (left - right) * np.array([left, row, f])

        pixels = np.array([f * x / z, f * y / z, f * (x - b) / z])
        J = sigma * differences(triangulated, pixels)
        found = covariance(candidate(x, y, z, f, b, sigma), 3, "the covariance")
        wanted = J @ J.T
        scale = wanted[2, 2]
        given = f"x, y, z = {x:.3f} {y:.3f} {z:.3f} m, in units of the depth's variance"
        same(found[2, 2] / scale, 1.0, "the variance of the depth", given=given, tolerance=1e-5)
        same(np.diag(found) / scale, np.diag(wanted) / scale, "the variances of x and y", given=given, tolerance=1e-5)
        same(found / scale, wanted / scale, "the covariances between them", given=given, tolerance=1e-5)
        twice = array_of(candidate(x, y, z, f, b, 2 * sigma), (3, 3), "the covariance")
        same(twice / scale, 4 * wanted / scale, "twice the noise, four times the covariance", tolerance=1e-5)


@exercise("depth_stereo_range.2", "an innovation that wraps")
def innovation(candidate: Any) -> None:
    """The short way round, for any number of turns; range and pitch are left alone; batches."""
    rng = np.random.default_rng(102)
    for _ in range(10):
        expected, step = rng.uniform(-3, 3, 3), rng.uniform(-3, 3, 3) * [4, 1, 1]
        turns = rng.integers(-3, 4) * 2 * np.pi * np.array([0, 1, 0])
        found = array_of(candidate(expected + step + turns, expected), (3,), "the innovation")
        same(found[1], step[1], "the yaw goes the short way round", given=f"{turns[1] / 2 / np.pi:g} turns apart")
        same(found[[0, 2]], step[[0, 2]], "range and pitch are plain differences")
    expected, step = rng.uniform(-3, 3, (4, 5, 3)), rng.uniform(-3, 3, (4, 5, 3))
    turns = rng.integers(-2, 3, (4, 5, 1)) * 2 * np.pi * np.array([0, 1, 0])
    same(candidate(expected + step + turns, expected), step, "batches of measurements")


@exercise("depth_stereo_range.3", "points from ranges")
def points_from_ranges(candidate: Any) -> None:
    """There and back through the pin-hole; a flat wall stays flat."""
    rng = np.random.default_rng(103)
    for _ in range(3):
        u0, v0, au, av = intrinsics = rng.uniform([200, 100, 200, 200], [400, 300, 500, 500])
        points = np.column_stack([rng.uniform(-3, 3, (30, 2)), rng.uniform(1, 6, 30)])
        u, v = u0 + au * points[:, 0] / points[:, 2], v0 + av * points[:, 1] / points[:, 2]
        ranges = np.sqrt((points**2).sum(1))
        found = array_of(candidate(u, v, ranges, intrinsics), (30, 3), "the points")
        same(np.sqrt((found**2).sum(1)), ranges, "the points are as far away as was measured")
        same(found[:, :2] / found[:, 2:], points[:, :2] / points[:, 2:], "they are seen at their pixels")
        same(found, points, "they are the points")
        wall = np.column_stack([rng.uniform(-2, 2, (20, 2)), np.full(20, 2.5)])
        u, v = u0 + au * wall[:, 0] / 2.5, v0 + av * wall[:, 1] / 2.5
        flat = array_of(candidate(u, v, np.sqrt((wall**2).sum(1)), intrinsics), (20, 3), "the points")
        same(flat[:, 2], wall[:, 2], "a flat wall stays flat")
