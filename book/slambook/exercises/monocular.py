"""Checks of the chapter: monocular SLAM."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import array_of, cases, holds, least_squares, parts, rotation_matrix, same
from slamlib.geometry.quaternion import UnitQuaternion, exponential, rotation
from slamlib.landmarks.ahm_point import to_frame
from slamlib.manifolds import Array
from slamlib.motions.constant_velocity import step


@exercise("monocular.1", "an inverse distance from parallaxes", seed=201)
def parallax(candidate: Candidate, rng: Rng) -> None:
    """It is what one batch of normal equations gives, with any number of measurements."""
    for n in cases((1, 2, 5, 12), "{} measurements"):
        f, sigma_u, rho_0, sigma_0 = (float(rng.uniform(*r)) for r in ((100, 300), (0.1, 1), (0.2, 1), (0.1, 0.5)))
        b = rng.uniform(-0.02, 0.05, n)
        u = f * b * rng.uniform(0, 1) + sigma_u * rng.standard_normal(n)
        values = [np.squeeze(v) for v in candidate(u, b, f, sigma_u, rho_0, sigma_0)]
        found = array_of(values, (2,), "mean and standard deviation")
        looks = zip(f * b, u, [sigma_u**2] * n, strict=True)
        mean, P = least_squares(np.array([rho_0]), np.array([[sigma_0**2]]), looks)
        same(found[1], np.sqrt(P[0, 0]), "the standard deviation is that of least squares")
        same(found[0], mean[0], "the mean is that of least squares")


@exercise("monocular.2", "a path laid over its reference", seed=202)
def similarity(candidate: Candidate, rng: Rng) -> None:
    """It undoes a similarity; R is a rotation; and nothing near it is better, for clouds, planes and mirrored noise."""
    clouds = (6, 0.0, 1.0), (12, 0.3, 1.0), (5, 0.0, 0.0), (30, 0.5, 0.02), (4, 1.0, 0.05)
    for n, noise, flat in cases(clouds, "{} points, noise {}"):
        x = rng.standard_normal((n, 3)) * [2, 1, flat] + rng.uniform(-5, 5, 3)
        turn, scale, shift = rotation(UnitQuaternion.random(rng)), float(rng.uniform(0.2, 5)), rng.uniform(-5, 5, 3)
        y = scale * x @ turn.T + shift + noise * rng.standard_normal((n, 3))
        s, R, t = parts(candidate(x, y), {"s": (), "R": (3, 3), "t": (3,)})
        rotation_matrix(R, "R")
        if not noise:
            what = "scale, rotation and shift are found again where there is no noise"
            same([s, *R.ravel(), *t], [scale, *turn.ravel(), *shift], what)
        _is_best(x, y, s, R, t, rng)


def _is_best(x: Array, y: Array, s: Array, R: Array, t: Array, rng: Rng) -> None:
    """Scales, rotations and shifts near the found ones, and other ones, are not better."""
    best = _cost(x, y, s, R, t)
    slack = 1e-9 * (1 + best)
    for size in np.repeat([1e-3, 1e-2, 0.1, 1.0, 3.0], 8):
        turn = rotation(exponential(size * rng.standard_normal(3)))
        for other in ((s * np.exp(size * rng.standard_normal()), R, t), (s, R, t + size * rng.standard_normal(3))):
            holds(best <= _cost(x, y, *other) + slack, "no other scale or shift is better", "one is")
        # with another rotation, the scale and the shift that go with it best
        moved = (x - x.mean(0)) @ (turn @ R).T
        k = max(float((moved * (y - y.mean(0))).sum() / (moved**2).sum()), 0.0)
        cost = _cost(x, y, k, turn @ R, y.mean(0) - k * turn @ R @ x.mean(0))
        holds(best <= cost + slack, "no other rotation is better", "one is")


def _cost(x: Array, y: Array, s: Array | float, R: Array, t: Array) -> float:
    return float(((y - s * x @ R.T - t) ** 2).sum())


@exercise("monocular.3", "the same film in a larger world", seed=203)
def larger(candidate: Candidate, rng: Rng) -> None:
    """Positions and points are k times as large; the camera sees the same; the motion keeps it so."""
    for k, n in cases(((k, n) for n in (1, 4) for k in (0.5, 3.0, 7.0)), "k = {:g}, {} points"):
        state = np.concatenate([rng.uniform(-3, 3, 3), UnitQuaternion.random(rng), rng.standard_normal(6)])
        points = np.column_stack([rng.uniform(-3, 3, (n, 3)), rng.standard_normal((n, 3)), rng.uniform(0.1, 1, (n, 1))])
        large, far = parts(candidate(state, points, k), {"the state": (13,), "the points": (n, 7)})
        same(large[:3], k * state[:3], "the camera is k times as far from the origin")
        place, farther = (p[:, :3] + p[:, 3:6] / p[:, 6:] for p in (points, far))
        same(farther, k * place, "the points are k times as far from the origin")
        before, after = (np.atleast_2d(to_frame(s[:7], p))[:, :3] for s, p in ((state, points), (large, far)))
        before, after = (seen / np.linalg.norm(seen, axis=1, keepdims=True) for seen in (before, after))
        same(after, before, "the camera sees each point in the same direction")
        moved, moved_large = step(state, np.zeros(6), 0.3), step(large, np.zeros(6), 0.3)
        same(moved_large[:3], k * moved[:3], "after a motion it is so still")
        same(moved_large[3:7], moved[3:7], "it turns as before")
