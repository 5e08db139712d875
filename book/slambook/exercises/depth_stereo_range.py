"""Checks of the chapter: depth, stereo, range and bearing."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, given, holds, same
from slamlib.models.numerical import differences


@exercise("depth_stereo_range.1", "the covariance of a stereo pair's position", seed=101)
def stereo_covariance(candidate: Candidate, rng: Rng) -> None:
    """Against differences of the triangulation itself; it scales with sigma squared."""
    low, high = (-2, -1, 3, 300, 0.05, 0.2), (2, 1, 12, 900, 0.5, 1)
    inputs = [(2.0, 0.5, 10.0, 700.0, 0.3, 0.5), (0.0, 0.0, 5.0, 500.0, 0.1, 1.0)]
    inputs += [tuple(rng.uniform(low, high).round(2).tolist()) for _ in range(3)]
    for x, y, z, f, b, sigma in cases(inputs, "x = {}, y = {}, z = {} m, f = {} px, b = {} m, sigma = {} px"):
        seen = np.array([f * x / z, f * y / z, f * (x - b) / z])
        J = sigma * differences(lambda p, f=f, b=b: b / (p[0] - p[2]) * np.array([p[0], p[1], f]), seen)
        wanted = J @ J.T
        found = covariance(candidate(x, y, z, f, b, sigma), 3)
        variances, expected = np.diag(found) * 1e4, np.diag(wanted) * 1e4
        same(variances[2], expected[2], "the variance of the depth, in cm²", tolerance=1e-5)
        same(variances[:2], expected[:2], "the variances of x and y, in cm²", tolerance=1e-5)
        pairs = [0, 0, 1], [1, 2, 2]
        scale = np.sqrt(np.outer(np.diag(wanted), np.diag(wanted)))
        same((found / scale)[pairs], (wanted / scale)[pairs], "the correlations of x and y, x and z, y and z", 1e-4)
        twice = array_of(candidate(x, y, z, f, b, 2 * sigma), (3, 3), "the covariance")
        same(np.diag(twice) * 1e4, 4 * expected, "twice the noise, four times the variances, in cm²", tolerance=1e-5)


@exercise("depth_stereo_range.2", "an innovation that wraps", seed=102)
def innovation(candidate: Candidate, rng: Rng) -> None:
    """The short way round, for any number of turns; range and pitch are left alone; batches."""
    inputs = [
        (np.array([10.0, 3.1, 0.1]), np.array([9.5, -3.1, 0.2])),
        (np.array([2.0, 0.5, 2.0]), np.array([9, 0.2, -2])),
    ]
    for turns in (1, -1, 3, -2):
        expected = rng.uniform(-3, 3, 3).round(2)
        inputs.append(((expected + rng.uniform(-3, 3, 3) * [4, 1, 2] + [0, 2 * np.pi * turns, 0]).round(2), expected))
    for measured, expected in cases(inputs, "measured = {}, expected = {}"):
        found, plain = array_of(candidate(measured, expected), (3,), "the innovation"), measured - expected
        same(found[[0, 2]], plain[[0, 2]], "range and pitch are plain differences")
        same(found[1], np.angle(np.exp(1j * plain[1])), "the bearing goes the short way round")
    for shape in ((2, 3), (2, 2, 3)):
        expected, step = rng.uniform(-3, 3, shape), rng.uniform(-3, 3, shape)
        turned = expected + step + 2 * np.pi * rng.choice([-2, -1, 1, 2], (*shape[:-1], 1)) * np.array([0, 1, 0])
        given(f"two arrays of shape {shape}")
        same(candidate(turned, expected), step, "batches of measurements")


@exercise("depth_stereo_range.3", "points from ranges", seed=103)
def points_from_ranges(candidate: Candidate, rng: Rng) -> None:
    """They have the ranges, and are seen at their pixels."""
    inputs = [
        (np.array([320.0, 620.0]), np.array([240.0, 240.0]), np.array([2.0, 5.0]), np.array([320.0, 240, 300, 400]))
    ]
    for _ in range(4):
        u, v, ranges = rng.uniform([[0], [0], [1]], [[640], [480], [8]], (3, 2)).round(1)
        inputs.append((u, v, ranges, rng.uniform([300, 200, 200, 350], [340, 280, 330, 500]).round(0)))
    for u, v, ranges, intrinsics in cases(inputs, "u = {}, v = {}, ranges = {}, intrinsics = {}"):
        points = array_of(candidate(u, v, ranges, intrinsics), (2, 3), "the points")
        same(np.linalg.norm(points, axis=1), ranges, "the points are as far away as was measured")
        holds((points[:, 2] > 0).all(), "they lie in front of the camera", f"found the depths {points[:, 2].round(4)}")
        seen = intrinsics[:2] + intrinsics[2:] * points[:, :2] / points[:, 2:]
        same(seen, np.column_stack([u, v]), "they are seen at their pixels, here as rows (u, v)")


@exercise("depth_stereo_range.5", "where two ranges meet", seed=105)
def two_places(candidate: Candidate, rng: Rng) -> None:
    """Both have both ranges, and the first lies to the left; ways in every direction, beacons behind both places."""
    inputs = [
        ([0, 0], [4, 0], 3.0, 5.0),
        ([1, 1], [-2, 1], 2.0, 2.0),
        ([0, 0], [2, 0], 2.5, 4.0),
        ([3, 2], [3, -1], 5.0, 3.0),
    ]
    for _ in range(3):
        a, b, beacon = rng.uniform(-5, 5, (3, 2)).round(2)
        inputs.append((a, b, float(np.linalg.norm(beacon - a)), float(np.linalg.norm(beacon - b))))
    given_all = [(np.array(a, dtype=float), np.array(b, dtype=float), r, s) for a, b, r, s in inputs]
    for a, b, r, s in cases(given_all, "a = {}, b = {}, r = {:.3f}, s = {:.3f} m"):
        found, way = array_of(candidate(a, b, r, s), (2, 2), "the two places"), b - a
        same(np.linalg.norm(found - a, axis=1), [r, r], "both have the first range from a")
        same(np.linalg.norm(found - b, axis=1), [s, s], "both have the second range from b")
        sides = way[0] * (found - a)[:, 1] - way[1] * (found - a)[:, 0]
        holds(sides[0] > 0, "the first lies to the left of the way", f"found {found[0].round(3)}")
        holds(sides[1] < 0, "the second lies to the right of it", f"found {found[1].round(3)}")
