"""Checks of the chapter: monocular SLAM."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import Rejected, array_of, holds, least_squares, rotation_matrix, same
from slamlib.geometry.quaternion import UnitQuaternion, rotation
from slamlib.landmarks.ahm_point import to_frame
from slamlib.manifolds import Array
from slamlib.motions.constant_velocity import step


@exercise("monocular.1", "an inverse distance from parallaxes")
def parallax(candidate: Any) -> None:
    """It is what one batch of normal equations gives, with any number of looks."""
    rng = np.random.default_rng(201)
    for n in (1, 2, 5, 12):
        f, sigma_u, rho_0, sigma_0 = (float(rng.uniform(*r)) for r in ((100, 300), (0.1, 1), (0.2, 1), (0.1, 0.5)))
        b = rng.uniform(-0.02, 0.05, n)
        u = f * b * rng.uniform(0, 1) + sigma_u * rng.standard_normal(n)
        given = f"{n} looks"
        found = array_of(_numbers(candidate(u, b, f, sigma_u, rho_0, sigma_0)), (2,), "mean and standard deviation")
        predictions = [
            (np.array([[f * x]]), np.array([y]), np.array([[sigma_u**2]])) for x, y in zip(b, u, strict=True)
        ]
        mean, P = least_squares(np.array([rho_0]), np.array([[sigma_0**2]]), predictions)
        same(found[1], np.sqrt(P[0, 0]), "the standard deviation is that of least squares", given=given)
        same(found[0], mean[0], "the mean is that of least squares", given=given)


def _numbers(value: Any) -> Any:
    """The pair as numbers, also if they came as arrays of one."""
    return [float(np.squeeze(v)) for v in value] if isinstance(value, tuple) and len(value) == 2 else value


@exercise("monocular.2", "a path laid over its reference")
def similarity(candidate: Any) -> None:
    """It undoes a similarity; R is a rotation; and nothing near it is better, for clouds, planes and mirrored noise."""
    rng = np.random.default_rng(202)
    for n, flat, noise in ((6, 1.0, 0.0), (12, 1.0, 0.3), (5, 0.0, 0.0), (30, 0.02, 0.5), (4, 0.05, 1.0)):
        x = rng.standard_normal((n, 3)) * [2, 1, flat] + rng.uniform(-5, 5, 3)
        true = rotation(UnitQuaternion.random(rng)), float(rng.uniform(0.2, 5)), rng.uniform(-5, 5, 3)
        y = true[1] * x @ true[0].T + true[2] + noise * rng.standard_normal((n, 3))
        given = f"{n} points, noise {noise}"
        s, R, t = _taken(candidate(x, y))
        rotation_matrix(R, "R")
        if not noise:
            what = "scale, rotation and shift are found again where there is no noise"
            same(np.concatenate([[s], R.ravel(), t]), np.concatenate([[true[1]], true[0].ravel(), true[2]]), what)
        _is_best(x, y, s, R, t, rng, given)


def _taken(found: Any) -> tuple[float, Array, Array]:
    if not isinstance(found, tuple | list) or len(found) != 3:
        raise Rejected("your function should return s, R and t")
    s, R, t = found
    return float(array_of(s, (), "s")), array_of(R, (3, 3), "R"), array_of(t, (3,), "t")


def _is_best(x: Array, y: Array, s: float, R: Array, t: Array, rng: np.random.Generator, given: str) -> None:
    """Scales, rotations and shifts near the found ones, and other ones, are not better."""
    best = _cost(x, y, s, R, t)
    slack = 1e-9 * (1 + best)
    for size in (1e-3, 1e-2, 0.1, 1.0, 3.0):
        for _ in range(8):
            turn = rotation(UnitQuaternion.plus(np.array([1.0, 0, 0, 0]), size * rng.standard_normal(3)))
            for other in ((s * np.exp(size * rng.standard_normal()), R, t), (s, R, t + size * rng.standard_normal(3))):
                holds(best <= _cost(x, y, *other) + slack, "no other scale or shift is better", f"one is, for {given}")
            # with another rotation, the scale and the shift that go with it best
            moved = (x - x.mean(0)) @ (turn @ R).T
            k = max(float((moved * (y - y.mean(0))).sum() / (moved**2).sum()), 0.0)
            there = y.mean(0) - k * turn @ R @ x.mean(0)
            cost = _cost(x, y, k, turn @ R, there)
            holds(best <= cost + slack, "no other rotation is better", f"one is, for {given}")


def _cost(x: Array, y: Array, s: float, R: Array, t: Array) -> float:
    return float(((y - s * x @ R.T - t) ** 2).sum())


@exercise("monocular.3", "the same film in a larger world")
def larger(candidate: Any) -> None:
    """Positions and points are k times as large; the camera sees the same; the motion keeps it so."""
    rng = np.random.default_rng(203)
    for n in (1, 4):
        for k in (0.5, 3.0, 7.0):
            quaternion = UnitQuaternion.random(rng)
            state = np.concatenate([rng.uniform(-3, 3, 3), quaternion, rng.standard_normal(6)])
            points = np.concatenate(
                [rng.uniform(-3, 3, (n, 3)), rng.standard_normal((n, 3)), rng.uniform(0.1, 1, (n, 1))], axis=1
            )
            given = f"k = {k:g}, {n} points"
            large, far = _pair(candidate(state, points, k), n)
            same(large[:3], k * state[:3], "the camera is k times as far from the origin", given=given)
            place, farther = (p[:, :3] + p[:, 3:6] / p[:, 6:] for p in (points, far))
            same(farther, k * place, "the points are k times as far from the origin", given=given)
            before, after = (_rays(s, p) for s, p in ((state, points), (large, far)))
            same(after, before, "the camera sees each point in the same direction", given=given)
            moved, moved_large = step(state, np.zeros(6), 0.3), step(large, np.zeros(6), 0.3)
            same(moved_large[:3], k * moved[:3], "after a motion it is so still", given=given)
            same(moved_large[3:7], moved[3:7], "it turns as before", given=given)


def _rays(state: Array, points: Array) -> Array:
    """Unit directions (n, 3) in which a camera at the state's pose sees the points."""
    seen = np.atleast_2d(to_frame(state[:7], points))[:, :3]
    rays: Array = seen / np.linalg.norm(seen, axis=1, keepdims=True)
    return rays


def _pair(found: Any, n: int) -> tuple[Array, Array]:
    if not isinstance(found, tuple | list) or len(found) != 2:
        raise Rejected("your function should return the state and the points")
    return array_of(found[0], (13,), "the state"), array_of(found[1], (n, 7), "the points")
