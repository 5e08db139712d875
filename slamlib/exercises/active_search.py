"""Checks of the chapter: active search."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.evaluation.consistency import band
from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, inside_band, same
from slamlib.manifolds import Array, Image, Mask

Region = tuple[Array, Array, Array]


@exercise("active_search.1", "where to look")
def where(candidate: Any) -> None:
    """The share of true measurements inside over many draws, and the nearest pixels before the others."""
    rng = np.random.default_rng(191)
    for k, probability in enumerate((0.5, 0.9, 0.99, 0.95)):
        centre, E, R = _expectation(rng, narrow=k == 3)
        what = f"probability {probability}"
        mask = _mask(candidate, centre, E, R, probability, (120, 90), what)
        L = np.linalg.cholesky(E)
        truth = centre + rng.standard_normal((20000, 2)) @ L.T
        seen = np.rint(truth + rng.standard_normal((20000, 2)) @ np.linalg.cholesky(R).T).astype(int)
        share = float(np.mean(mask[seen[:, 1], seen[:, 0]]))
        margin = 4 * np.sqrt(probability * (1 - probability) / 20000) + 0.005  # draws, and pixels cut by the border
        holds(abs(share - probability) < margin, "it holds the stated share of measurements", f"{share:.3f}, {what}")
        distance = _distances(mask.shape, centre, E + R)
        nearer = distance[mask].max(initial=0) <= distance[~mask].min(initial=np.inf) + 1e-9
        holds(nearer, "no pixel is left out that is more probable than one inside", what)
    at = np.array([2.0, 1.0]), np.diag([30.0, 8.0]), np.eye(2)
    cut = _mask(candidate, *at, 0.9, (40, 30), "an expectation near the border")
    far = (np.array([-50.0, 10.0]), *at[1:])
    holds(cut[0, 0] and not cut[:, -1].any(), "at the border the region is cut off", "it is moved or wrapped")
    none = _mask(candidate, *far, 0.9, (40, 30), "an expectation far outside")
    holds(not none.any(), "far outside of the image nothing is left of it", f"{none.sum()} pixels")


def _expectation(rng: np.random.Generator, narrow: bool) -> Region:
    """Where a landmark should be in an image of 120 x 90 pixels: centre, E, R [px^2]."""
    a, b, turn = 9.0, 0.3 if narrow else 3.0, rng.uniform(0.4, 1.1)
    axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    return np.array([58.3, 43.8]), axes @ np.diag([a, b]) ** 2 @ axes.T, np.diag([6.0, 4.0])


def _mask(candidate: Any, centre: Array, E: Array, R: Array, share: float, size: tuple[int, int], what: str) -> Mask:
    width, height = size
    found = np.asarray(candidate(centre, E, R, share, size))
    shape = (height, width)
    holds(found.shape == shape, "a row of the mask is a row of the image", f"shape {found.shape}, not {shape}: {what}")
    holds(found.dtype == bool, "the mask is True or False", f"its numbers are of type {found.dtype}")
    return found


def _distances(shape: tuple[int, ...], centre: Array, S: Array) -> Array:
    v, u = np.indices(shape)
    z = np.stack([u, v], axis=-1) - centre
    return np.asarray((z * (z @ np.linalg.inv(S))).sum(-1))


@exercise("active_search.2", "how well a patch can be found again")
def matching(candidate: Any) -> None:
    """Displacements by least squares over many draws of the noise in both images, and how they scale."""
    rng = np.random.default_rng(192)
    for height, width in ((11, 11), (9, 15), (13, 9)):
        patch, noise = _patch(rng, height, width), float(rng.uniform(1, 6))
        what = f"a patch of shape {patch.shape}, noise {noise:.1f}"
        C = array_of(candidate(patch, noise), (2, 2), f"the covariance of {what}")
        gradient = np.stack([(patch[1:-1, 2:] - patch[1:-1, :-2]).ravel(), (patch[2:] - patch[:-2])[:, 1:-1].ravel()])
        differences = noise * (
            rng.standard_normal((4000, gradient.shape[1])) - rng.standard_normal((4000, gradient.shape[1]))
        )
        moved = np.linalg.lstsq(gradient.T / 2, differences.T, rcond=None)[0]
        squared = (moved * (np.linalg.pinv(C) @ moved)).sum(0)
        inside_band(squared.mean(), band(2, 4000, 0.9999), "displacements have this covariance, noise in both images")
        for axis, name in enumerate(("u", "v")):
            ratio = float((moved[axis] ** 2).mean() / max(C[axis, axis], 1e-300))
            inside_band(ratio, band(1, 4000, 0.9999), f"that of {name}, too")
        same(candidate(patch + 40, noise), C, "a brighter patch is found as well", given=what)
        same(
            4 * np.asarray(candidate(2 * patch, noise)), C, "twice the contrast, a quarter of the variance", given=what
        )
        same(candidate(patch, 3 * noise), 9 * C, "three times the noise, nine times it", given=what)


def _patch(rng: np.random.Generator, height: int, width: int) -> Array:
    """A smooth patch: a few waves, steeper across than along."""
    v, u = np.indices((height, width))
    a, b, c, d = rng.uniform(0.3, 0.7, 4)
    waves = (
        60 * np.sin(a * u + 0.5 * b * v + 6 * c) + 25 * np.cos(0.5 * c * u - d * v) + 3 * rng.standard_normal(u.shape)
    )
    return np.asarray(120 + waves)


@exercise("active_search.3", "the image of a plane in another camera")
def plane(candidate: Any) -> None:
    """Points of the plane, projected by either camera; and the way back."""
    rng = np.random.default_rng(193)
    for _ in range(6):
        K1, K2 = _intrinsics(rng), _intrinsics(rng)
        R, t = _turn(rng), rng.uniform(-0.5, 0.5, 3)
        n = np.array([*rng.uniform(-0.4, 0.4, 2), 1.0])
        n, d = n / np.linalg.norm(n), float(rng.uniform(2, 5))
        H = array_of(candidate(R, t, n, d, K1, K2), (3, 3), "the homography")
        ways = np.column_stack([rng.uniform(-0.3, 0.3, (8, 2)), np.ones(8)])
        points = ways * (d / (ways @ n))[:, None]
        pixels, wanted = _project(K1, points), _project(K2, points @ R.T + t)
        mapped = _divided(np.column_stack([pixels, np.ones(8)]) @ H.T)
        same(mapped, wanted, "each point of the plane goes from its pixel to its pixel", tolerance=1e-7)
        back = array_of(candidate(R.T, -R.T @ t, R @ n, d + float(n @ R.T @ t), K2, K1), (3, 3), "the way back")
        returned = _divided(np.column_stack([wanted, np.ones(8)]) @ back.T)
        same(returned, pixels, "the other camera's own plane leads back", tolerance=1e-7)
        far = _divided(np.column_stack([pixels, np.ones(8)]) @ np.asarray(candidate(R, t, n, 1e12, K1, K2)).T)
        same(far, _project(K2, points @ R.T), "of a plane far away only the turn matters", tolerance=1e-6)


def _intrinsics(rng: np.random.Generator) -> Array:
    f = float(rng.uniform(150, 400))
    return np.array([[f, 0, rng.uniform(70, 90)], [0, f * rng.uniform(0.9, 1.1), rng.uniform(50, 70)], [0, 0, 1]])


def _turn(rng: np.random.Generator) -> Array:
    axis = rng.standard_normal(3)
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = float(rng.uniform(0.1, 0.5))
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def _project(K: Array, points: Array) -> Array:
    return _divided(points @ K.T)


def _divided(points: Array) -> Array:
    return np.asarray(points[:, :2] / points[:, 2:])


@exercise("active_search.4", "a correlation that cannot be fooled")
def correlation(candidate: Any) -> None:
    """Bounds, invariances, what the best gain and bias of I leave of J, and the cases in which others failed."""
    rng = np.random.default_rng(194)
    score = _scores(candidate)
    for shape in ((9, 9), (11, 15), (5, 7)):
        I = rng.uniform(20, 200, shape)  # noqa: E741
        J = 0.6 * I + rng.normal(30, 25, shape)
        z = score(I, J)
        same(score(J, I), z, "it does not matter which patch comes first")
        same(score(1.7 * I + 12, 0.4 * J - 3), z, "gain and bias change nothing")
        same(score(-I, J), -z, "a negative is worth the opposite")
        same(score(I, 3 * I + 5), 1.0, "equal up to gain and bias is worth 1")
        rest = J.ravel() - np.polyval(np.polyfit(I.ravel(), J.ravel(), 1), I.ravel())
        share = float((rest @ rest) / (J.size * J.var()))
        same(1 - z**2, share, "1 - z^2 is the share of J that no gain and bias of I explains")
        flat = np.full(shape, 77.7)
        for pair in ((I, flat), (flat, I), (flat, flat), (np.zeros(shape), I)):
            same(score(*pair), 0.0, "a flat patch is like nothing")
        _bytes(score, rng, shape, I)


def _scores(candidate: Any) -> Callable[[Image, Image], float]:
    def score(I: Image, J: Image) -> float:  # noqa: E741
        value = float(array_of(candidate(I, J), (), "the score"))
        holds(abs(value) <= 1 + 1e-12, "the score lies between -1 and 1", f"found {value:.6g}")
        return value

    return score


def _bytes(score: Callable[[Image, Image], float], rng: np.random.Generator, shape: tuple[int, int], I: Array) -> None:  # noqa: E741
    """Images as they come from files: bytes; and in single precision, faint on a bright ground."""
    a = rng.integers(0, 256, shape).astype(np.uint8)
    b = (a // 2 + rng.integers(0, 60, shape)).astype(np.uint8)
    same(score(a, b), score(a.astype(float), b.astype(float)), "bytes are treated like other numbers")
    faint = (20000 + 0.02 * I).astype(np.float32)
    exact = score(faint.astype(float), I)
    same(score(faint, I), exact, "a faint pattern on a bright ground is not lost", tolerance=1e-6)
