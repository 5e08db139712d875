"""Checks of the chapter: lines."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, holds, parts, same
from slamlib.landmarks.apl_line import to_frame


@exercise("lines.1", "the line of two planes", seed=121)
def line_of_planes(candidate: Candidate, rng: Rng) -> None:
    """Points of both planes satisfy n = p x v; parallel planes meet at infinity; the scale is free."""
    for first, second in cases(rng.standard_normal((4, 2, 4)), "the planes {}"):
        line = array_of(candidate(first, second), (6,), "the line")
        n, v = line[:3], line[3:]
        same([first[:3] @ v, second[:3] @ v], [0, 0], "v lies in both planes")
        holds(np.linalg.norm(v) > 1e-9, "planes that meet have a direction", "v is zero")
        base = np.linalg.lstsq(np.stack([first[:3], second[:3]]), -np.array([first[3], second[3]]), rcond=None)[0]
        for step in (0.0, 2.0):
            point = base + step * np.cross(first[:3], second[:3])
            same(np.cross(point, v), n, "points of both planes satisfy n = p x v")
    a = rng.standard_normal(3)
    line = array_of(candidate(np.array([*a, 1.0]), np.array([*(2 * a), -3.0])), (6,), "the line of parallel planes")
    same(line[3:], np.zeros(3), "parallel planes meet at infinity, v = 0")
    holds(np.linalg.norm(line[:3]) > 1e-9, "the line at infinity still has its plane", "n is zero")
    same(np.cross(line[:3], a), np.zeros(3), "whose normal is that of the planes")


@exercise("lines.2", "a new anchor", seed=122)
def reanchor(candidate: Candidate, rng: Rng) -> None:
    """The same line from everywhere, with the same covariance of what is seen."""
    for far in cases((0.5, 100.0), "an anchor {:g} m away"):
        x, anchor, v = 3 * rng.standard_normal(3), far * rng.standard_normal(3), rng.standard_normal(3)
        landmark = np.concatenate([x, np.cross(rng.standard_normal(3), v), v])
        root = rng.standard_normal((9, 9)) / 10
        P = root @ root.T
        moved, found = parts(candidate(landmark, P, anchor), {"the landmark": (9,), "the covariance": (9, 9)})
        same(moved[:3], anchor, "the anchor is the new one")
        pose = np.array([*rng.standard_normal(3), 1.0, 0, 0, 0])
        before, J = to_frame.jac(pose, landmark)
        after, K = to_frame.jac(pose, moved)
        same(after, before, "the line is seen the same")
        covariance(found, 9)
        same(found[:3, :3], np.zeros((3, 3)), "the new anchor is exactly known")
        wanted = J.landmark @ P @ J.landmark.T
        scale = np.abs(wanted).max()
        same(K.landmark @ found @ K.landmark.T / scale, wanted / scale, "the line is as certain as before")


@exercise("lines.3", "the image of a line", seed=123)
def image_line(candidate: Candidate, rng: Rng) -> None:
    """Pixels of points with n . p = 0 lie on it, also where the two focal lengths differ; its scale is free."""
    for k in cases([np.array([320.0, 240, 300, 300])] * 3 + [np.array([350.0, 190, 500, 250])] * 3, "intrinsics {}"):
        points = rng.standard_normal((2, 3)) + np.array([0, 0, 4])
        line = array_of(candidate(k, np.cross(*points)), (3,), "the image line")
        holds(np.linalg.norm(line[:2]) > 0, "it has a direction in the image", "its first two numbers are zero")
        pixels = k[:2] + k[2:] * points[:, :2] / points[:, 2:]
        off = (pixels @ line[:2] + line[2]) / np.linalg.norm(line[:2])
        same(off, np.zeros(2), "pixels of the line's points lie on it", tolerance=1e-7)
