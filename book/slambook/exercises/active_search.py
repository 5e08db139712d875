"""Checks of the chapter: active search."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, between, cases, exercise, given, holds, number, same
from slamlib.evaluation.consistency import band
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.manifolds import Array, Image, Mask


@exercise("active_search.1", "where to look", seed=191)
def where(candidate: Candidate, rng: Rng) -> None:
    """The share of true measurements inside over many draws, and the nearest pixels before the others."""
    for probability, thickness in cases(((0.45, 3.0), (0.87, 3.0), (0.98, 3.0), (0.96, 0.3)), "probability {}"):
        turn, centre, R = rng.uniform(0.4, 1.1), np.array([58.3, 43.8]), np.array([[6.0, 3.0], [3.0, 4.0]])
        axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        E = axes @ np.diag([9.0, thickness]) ** 2 @ axes.T
        mask = _mask(candidate, centre, E, R, probability, (120, 90))
        seen = np.rint(centre + rng.standard_normal((20000, 2)) @ np.linalg.cholesky(E + R).T).astype(int)
        share = np.mean(mask[seen[:, 1], seen[:, 0]])
        margin = 4 * np.sqrt(probability * (1 - probability) / 20000) + 0.005  # draws, and pixels cut by the border
        between(share, probability - margin, probability + margin, "it holds the stated share of measurements")
        z = np.moveaxis(np.indices(mask.shape)[::-1], 0, -1) - centre
        distance = (z * (z @ np.linalg.inv(E + R))).sum(-1)
        last, next_ = distance[mask].max(initial=0), distance[~mask].min(initial=np.inf)
        holds(last <= next_ + 1e-9, "no pixel is left out that is more probable than one inside")
        held = np.exp(-last / 2) + 1e-9 >= 1 - probability >= np.exp(-next_ / 2) - 1e-9
        holds(held, "its pixels are those of the stated probability, not one more or less", "its size is not exact")
    cut = _mask(candidate, np.array([2.0, 1.0]), np.diag([30.0, 8.0]), np.eye(2), 0.9, (40, 30))
    holds(cut[0, 0] and not cut[:, -1].any(), "at the border the region is cut off", "it is moved or wrapped")
    none = _mask(candidate, np.array([-50.0, 10.0]), np.diag([30.0, 8.0]), np.eye(2), 0.9, (40, 30))
    holds(not none.any(), "far outside of the image nothing is left of it", f"{none.sum()} pixels")


def _mask(candidate: Candidate, centre: Array, E: Array, R: Array, share: float, size: tuple[int, int]) -> Mask:
    found = np.asarray(candidate(centre, E, R, share, size))
    shape = size[::-1]
    holds(found.shape == shape, "a row of the mask is a row of the image", f"it has shape {found.shape}, not {shape}")
    holds(found.dtype == bool, "the mask is True or False", f"its numbers are of type {found.dtype}")
    return found


@exercise("active_search.2", "how well a patch can be found again", seed=192)
def matching(candidate: Candidate, rng: Rng) -> None:
    """Displacements by least squares over many draws of the noise in both images, and how they scale."""
    for shape in cases(((11, 11), (9, 15), (13, 9))):
        patch, noise = _patch(rng, shape), float(rng.uniform(1, 6))
        given(f"a patch of shape {shape}, noise {noise:.1f}")
        C = array_of(candidate(patch, noise), (2, 2), "the covariance")
        gradient = np.stack([(patch[1:-1, 2:] - patch[1:-1, :-2]).ravel(), (patch[2:] - patch[:-2])[:, 1:-1].ravel()])
        draws = 4000, gradient.shape[1]
        differences = noise * (rng.standard_normal(draws) - rng.standard_normal(draws))
        moved = np.linalg.lstsq(gradient.T / 2, differences.T, rcond=None)[0]
        squared = (moved * (np.linalg.pinv(C) @ moved)).sum(0).mean()
        between(squared, *band(2, 4000, 0.9999), "displacements have this covariance, noise in both images")
        for name, way in (("u", [1, 0]), ("v", [0, 1]), ("u - v", [1, -1])):  # the last tells the correlation
            ratio = ((way @ moved) ** 2).mean() / max(way @ C @ way, 1e-300)
            between(ratio, *band(1, 4000, 0.9999), f"that of {name}, too")
        same(candidate(patch + 40, noise), C, "a brighter patch is found as well")
        same(4 * np.asarray(candidate(2 * patch, noise)), C, "twice the contrast, a quarter of the variance")
        same(candidate(patch, 3 * noise), 9 * C, "three times the noise, nine times it")


def _patch(rng: Rng, shape: tuple[int, int]) -> Array:
    """A smooth patch: a few waves, steeper across than along."""
    v, u = np.indices(shape)
    a, b, c, d = rng.uniform(0.3, 0.7, 4)
    waves = 60 * np.sin(a * u + 0.5 * b * v + 6 * c) + 25 * np.cos(0.5 * c * u - d * v)
    return np.asarray(120 + (waves + 3 * rng.standard_normal(shape)))


@exercise("active_search.3", "the image of a plane in another camera", seed=193)
def plane(candidate: Candidate, rng: Rng) -> None:
    """Points of the plane, projected by either camera; and the way back."""
    for _ in range(6):
        K1, K2 = _intrinsics(rng), _intrinsics(rng)
        axis, angle, t = rng.standard_normal(3), rng.uniform(0.1, 0.5), rng.uniform(-0.5, 0.5, 3)
        R = rotation(exponential(angle * axis / np.linalg.norm(axis)))
        n = np.array([*rng.uniform(-0.4, 0.4, 2), 1.0])
        n, d = n / np.linalg.norm(n), float(rng.uniform(2, 5))
        H = array_of(candidate(R, t, n, d, K1, K2), (3, 3), "the homography")
        ways = np.column_stack([rng.uniform(-0.3, 0.3, (8, 2)), np.ones(8)])
        points = ways * (d / (ways @ n))[:, None]
        pixels, wanted = _mapped(K1, points), _mapped(K2, points @ R.T + t)
        ones = np.ones((8, 1))
        mapped = _mapped(H, np.hstack([pixels, ones]))
        same(mapped, wanted, "each point of the plane goes from its pixel to its pixel", tolerance=1e-7)
        back = array_of(candidate(R.T, -R.T @ t, R @ n, d + float(n @ R.T @ t), K2, K1), (3, 3), "the way back")
        returned = _mapped(back, np.hstack([wanted, ones]))
        same(returned, pixels, "the other camera's own plane leads back", tolerance=1e-7)
        far = _mapped(np.asarray(candidate(R, t, n, 1e12, K1, K2)), np.hstack([pixels, ones]))
        same(far, _mapped(K2, points @ R.T), "of a plane far away only the turn matters", tolerance=1e-6)


def _intrinsics(rng: Rng) -> Array:
    f = float(rng.uniform(150, 400))
    return np.array([[f, 0, rng.uniform(70, 90)], [0, f * rng.uniform(0.9, 1.1), rng.uniform(50, 70)], [0, 0, 1]])


def _mapped(matrix: Array, points: Array) -> Array:
    """Pixels (n, 2) of the points (n, 3)."""
    homogeneous = points @ matrix.T
    return np.asarray(homogeneous[:, :2] / homogeneous[:, 2:])


@exercise("active_search.4", "a correlation that cannot be fooled", seed=194)
def correlation(candidate: Candidate, rng: Rng) -> None:
    """Bounds, invariances, what the best gain and bias of I leave of J, and the cases in which others failed."""

    def score(I: Image, J: Image) -> float:  # noqa: E741
        value = number(candidate(I, J), "the score")
        holds(abs(value) <= 1 + 1e-12, "the score lies between -1 and 1", f"found {value:.6g}")
        return value

    for shape in ((9, 9), (11, 15), (5, 7)):
        I = rng.uniform(20, 200, shape)  # noqa: E741
        J = 0.6 * I + rng.normal(30, 25, shape)
        z = score(I, J)
        same(score(J, I), z, "it does not matter which patch comes first")
        same(score(1.7e-12 * I + 12e-12, 0.4e-12 * J - 3e-12), z, "gain and bias change nothing")
        same(score(-I, J), -z, "a negative is worth the opposite")
        same(score(I, 3 * I + 5), 1.0, "equal up to gain and bias is worth 1")
        rest = J.ravel() - np.polyval(np.polyfit(I.ravel(), J.ravel(), 1), I.ravel())
        share = float((rest @ rest) / (J.size * J.var()))
        same(1 - z**2, share, "1 - z^2 is the share of J that no gain and bias of I explains")
        flat = np.full(shape, 77.7)
        for pair in ((I, flat), (flat, I), (flat, flat), (np.zeros(shape), I)):
            same(score(*pair), 0.0, "a flat patch is like nothing")
        # images as they come from files: bytes; and in single precision, faint on a bright ground
        a = rng.integers(0, 256, shape).astype(np.uint8)
        b = (a // 2 + rng.integers(0, 60, shape)).astype(np.uint8)
        same(score(a, b), score(a.astype(float), b.astype(float)), "bytes are treated like other numbers")
        faint = (20000 + 0.02 * I).astype(np.float32)
        exact = score(faint.astype(float), I)
        same(score(faint, I), exact, "a faint pattern on a bright ground is not lost", tolerance=1e-6)
