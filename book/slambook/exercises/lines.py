"""Checks of the chapter: lines."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, holds, parts, same
from slamlib.landmarks.apl_line import to_frame


@exercise("lines.1", "the line of two planes", seed=121)
def line_of_planes(candidate: Candidate, rng: Rng) -> None:
    """Points of both planes satisfy n = p x v; parallel planes meet at infinity; the scale is free."""
    simple = np.array([[[0.0, 0, 1, -2], [1, 0, 0, -1]], [[0, 1, 0, 3], [0, 1, 1, 0]]])  # z = 2 and x = 1, ...
    for first, second in cases(map(tuple, (*simple, *rng.standard_normal((4, 2, 4)))), "the planes {} and {}"):
        line = array_of(candidate(first, second), (6,), "the line")
        n, v = line[:3], line[3:]
        same([first[:3] @ v, second[:3] @ v], [0, 0], "v lies in both planes")
        holds(np.linalg.norm(v) > 1e-9, "planes that meet have a direction", "v is zero")
        base = np.linalg.lstsq(np.stack([first[:3], second[:3]]), -np.array([first[3], second[3]]), rcond=None)[0]
        for step in (0.0, 2.0):
            point = base + step * np.cross(first[:3], second[:3])
            same(np.cross(point, v), n, "points of both planes satisfy n = p x v")
    a = rng.standard_normal(3)
    parallel = (np.array([0, 0, 1.0, -2]), np.array([0, 0, 1.0, 3])), (np.array([*a, 1.0]), np.array([*(2 * a), -3.0]))
    for first, second in cases(parallel, "the parallel planes {} and {}"):
        found = candidate(first, second)
        finite = np.shape(found) != (6,) or np.isfinite(np.asarray(found, float)).all()
        holds(finite, "parallel planes are no exception", "the line holds nan or infinity")
        line = array_of(found, (6,), "the line of parallel planes")
        same(line[3:], np.zeros(3), "parallel planes meet at infinity, v = 0")
        holds(np.linalg.norm(line[:3]) > 1e-9, "the line at infinity still has its plane", "n is zero")
        same(np.cross(line[:3], first[:3]), np.zeros(3), "whose normal is that of the planes")


@exercise("lines.2", "a new anchor", seed=122)
def reanchor(candidate: Candidate, rng: Rng) -> None:
    """The same line from everywhere, with the same covariance of what is seen, of each part alone and of all."""
    x, v, anchor = np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), np.array([0.0, 1, 2])
    landmark = np.concatenate([x, np.cross([0.0, 2, 0], v), v])
    alone = ("only the moment", slice(3, 6)), ("only the old anchor", slice(0, 3)), ("only the direction", slice(6, 9))
    inputs = []
    for words, own in alone:
        P = np.zeros((9, 9))
        P[own, own] = np.diag([0.01, 0.04, 0.09])
        inputs.append((words, landmark, P, anchor))
    for far in (0.5, 100.0):
        x, anchor, v = 3 * rng.standard_normal(3), far * rng.standard_normal(3), rng.standard_normal(3)
        root = rng.standard_normal((9, 9)) / 10
        one = np.concatenate([x, np.cross(rng.standard_normal(3), v), v])
        inputs.append(("all", one, root @ root.T, anchor))
    for _, landmark, P, anchor in cases(inputs, "a landmark {1} of which {0} is uncertain, and the anchor {3}"):
        moved, found = parts(candidate(landmark, P, anchor), {"the landmark": (9,), "the covariance": (9, 9)})
        same(moved[:3], anchor, "the anchor is the new one")
        pose = np.array([0.5, -1, 2, 1.0, 0, 0, 0])
        same(to_frame(pose, moved), to_frame(pose, landmark), "the line is seen the same")
        covariance(found, 9)
        same(found[:3, :3], np.zeros((3, 3)), "the new anchor is exactly known")
        pose[:3] = anchor  # there the moment seen is the new one, whatever its correlation with the direction
        J, K = to_frame.jac(pose, landmark)[1], to_frame.jac(pose, moved)[1]
        wanted = J.landmark @ P @ J.landmark.T
        seen, scale = K.landmark @ found @ K.landmark.T, np.abs(wanted).max()
        same(seen[:3, :3] / scale, wanted[:3, :3] / scale, "the moment is as certain as before")
        same(seen / scale, wanted / scale, "the line is as certain as before")


@exercise("lines.3", "the image of a line", seed=123)
def project_line(candidate: Candidate, rng: Rng) -> None:
    """Pixels of points with n . p = 0 lie on it, also where the two focal lengths differ; its scale is free."""
    square, narrow = np.array([320.0, 240, 300, 300]), np.array([350.0, 190, 500, 250])
    simple = np.array([[[0.0, -1, 4], [0, 1, 4]], [[-1, 1, 4], [1, 1, 4]]])  # a vertical line, a level one
    inputs = []
    for k in (square, narrow):
        for points in (*simple, *(rng.standard_normal((3, 2, 3)) + np.array([0, 0, 4]))):
            inputs.append((k, np.cross(*points), points))
    for k, n, points in cases(inputs, "intrinsics {} and n = {}"):
        line = array_of(candidate(k, n), (3,), "the image line")
        holds(np.linalg.norm(line[:2]) > 0, "it has a direction in the image", "its first two numbers are zero")
        pixels = k[:2] + k[2:] * points[:, :2] / points[:, 2:]
        off = (pixels @ line[:2] + line[2]) / np.linalg.norm(line[:2])
        same(off, np.zeros(2), "pixels of the line's points lie on it", tolerance=1e-7)
