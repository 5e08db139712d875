"""Checks of the chapter: Gaussians."""

import numpy as np

from slambook.exercises import Candidate, Rejected, Rng, exercise
from slambook.exercises.kit import between, covariance, holds, parts, random_covariance, same


@exercise("gaussians.2", "points of an ellipse", seed=12)
def ellipse_points(candidate: Candidate, rng: Rng) -> None:
    """One Mahalanobis distance all round, all round indeed, and the right share of samples inside."""
    for probability in (0.3, 0.95, 0.99):
        P, mean = random_covariance(rng, 2, 0.1), rng.standard_normal(2)
        points = np.asarray(candidate(mean, P, probability), dtype=float)
        if points.ndim != 2 or points.shape[0] != 2 or points.shape[1] < 12:
            raise Rejected(f"the points should have shape (2, m) with m at least 12, but have shape {points.shape}")
        white = np.linalg.solve(np.linalg.cholesky(P), points - mean[:, None])
        distances = (white**2).sum(0)
        same(distances, np.full(points.shape[1], distances.mean()), "the same Mahalanobis distance all round")
        angles = np.sort(np.arctan2(white[1], white[0]))
        gap = max(np.diff(angles).max(), angles[0] + 2 * np.pi - angles[-1])
        holds(gap < 1.0, "goes all the way round", f"a gap of {np.degrees(gap):.0f} degrees")
        samples = (rng.standard_normal((20000, 2)) ** 2).sum(1)
        share = np.mean(samples <= distances.mean())
        between(share, probability - 0.015, probability + 0.015, "holds that share of samples")


@exercise("gaussians.3", "a slice through a Gaussian", seed=13)
def conditional(candidate: Candidate, rng: Rng) -> None:
    """The slice's density peaks at the mean, and its precision is a block of the inverse of P."""
    for n, i in ((2, 0), (2, 1), (4, 2)):
        P, at, value = random_covariance(rng, n, 0.1), rng.standard_normal(n), rng.standard_normal()
        mean, found = parts(candidate(at, P, i, value), {"the mean": (n - 1,), "the covariance": (n - 1, n - 1)})
        covariance(found, n - 1)
        information = np.linalg.inv(P)
        rest = np.delete(np.arange(n), i)
        same(np.linalg.inv(found), information[np.ix_(rest, rest)], "its inverse is a block of the inverse of P")
        e = np.insert(mean, i, value) - at
        same((information @ e)[rest], np.zeros(n - 1), "the mean is where the density along the slice is largest")


@exercise("gaussians.4", "a gate that keeps the good ones", seed=14)
def accepts(candidate: Candidate, rng: Rng) -> None:
    """The share of deviations that pass, in one, two and three dimensions; and that none passes but the nearest."""
    for m in (1, 2, 3):
        S = random_covariance(rng, m, 0.1)
        L = np.linalg.cholesky(S)
        white = rng.standard_normal((3000, m))
        distances = (white**2).sum(1)
        for probability in (0.5, 0.95):
            passed = np.array([bool(candidate(e, S, probability)) for e in white @ L.T])
            what = f"keeps the right share with {m} degree(s) of freedom"
            between(passed.mean(), probability - 0.04, probability + 0.04, what)
            nearest = distances[passed].max() < distances[~passed].min()
            holds(nearest, "keeps the nearest by Mahalanobis distance", "refused one that is nearer than one it kept")
        holds(not candidate(100 * L[:, 0], S, 0.999), "refuses what is a hundred sigmas away", "accepted it")
