"""Checks of the chapter: Gaussians."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import Rejected, array_of, covariance, holds, pair, same


@exercise("gaussians.2", "points of an ellipse")
def ellipse_points(candidate: Any) -> None:
    """One Mahalanobis distance all round, all round indeed, and the right share of samples inside."""
    rng = np.random.default_rng(12)
    for probability in (0.3, 0.95, 0.99):
        root = rng.standard_normal((2, 2))
        P, mean = root @ root.T + 0.1 * np.eye(2), rng.standard_normal(2)
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
        holds(
            abs(share - probability) < 0.015, "holds that share of samples", f"{share:.1%} instead of {probability:.0%}"
        )


@exercise("gaussians.3", "a slice through a Gaussian")
def conditional(candidate: Any) -> None:
    """The slice's density peaks at the mean, and its precision is a block of the inverse of P."""
    rng = np.random.default_rng(13)
    for n, i in ((2, 0), (2, 1), (4, 2)):
        root = rng.standard_normal((n, n))
        P, mean, value = root @ root.T + 0.1 * np.eye(n), rng.standard_normal(n), rng.standard_normal()
        result = pair(candidate(mean, P, i, value), "a mean and a covariance")
        rest = [k for k in range(n) if k != i]
        found = covariance(result[1], n - 1, "the covariance")
        information = np.linalg.inv(P)
        same(np.linalg.inv(found), information[np.ix_(rest, rest)], "its inverse is a block of the inverse of P")
        e = np.zeros(n)
        e[i] = value - mean[i]
        e[rest] = array_of(result[0], (n - 1,), "the mean") - mean[rest]
        same((information @ e)[rest], np.zeros(n - 1), "the mean is where the density along the slice is largest")


@exercise("gaussians.4", "a gate that keeps the good ones")
def accepts(candidate: Any) -> None:
    """The share of good innovations that pass, in one, two and three dimensions, for two probabilities."""
    rng = np.random.default_rng(14)
    for m in (1, 2, 3):
        root = rng.standard_normal((m, m))
        S = root @ root.T + 0.1 * np.eye(m)
        L = np.linalg.cholesky(S)
        innovations = rng.standard_normal((3000, m)) @ L.T
        for probability in (0.5, 0.95):
            share = np.mean([bool(candidate(z, S, probability)) for z in innovations])
            holds(
                abs(share - probability) < 0.04,
                f"keeps the right share of good innovations with {m} degree(s) of freedom",
                f"kept {share:.0%}, should keep {probability:.0%}",
            )
        holds(not candidate(100 * L[:, 0], S, 0.999), "refuses what is a hundred sigmas away", "accepted it")
