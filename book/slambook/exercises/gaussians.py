"""Checks of the chapter: Gaussians."""

import numpy as np

from slambook.exercises import Candidate, Rejected, Rng, exercise
from slambook.exercises.kit import between, cases, covariance, holds, parts, random_covariance, same
from slamlib.kalman.chi_square import chi2_cdf, chi2_quantile
from slamlib.manifolds import Array


def short(rng: Rng, n: int) -> Array:
    """A covariance (n, n) of few digits, so that a reader can type what a rejection shows."""
    return np.round(random_covariance(rng, n, 0.3), 1)


@exercise("gaussians.2", "points of an ellipse", seed=12)
def ellipse_points(candidate: Candidate, rng: Rng) -> None:
    """One Mahalanobis distance all round, all round indeed, and the right share of samples inside."""
    squares = (rng.standard_normal((100_000, 2)) ** 2).sum(1)
    asked = [(np.round(3 * rng.standard_normal(2), 1), short(rng, 2), share) for share in (0.3, 0.95, 0.99)]
    for mean, P, probability in cases(asked, "mean {}, P {} and probability {}"):
        points = np.asarray(candidate(mean, P, probability), dtype=float)
        if points.ndim != 2 or points.shape[0] != 2 or points.shape[1] < 12:
            raise Rejected(f"the points should have shape (2, m) with m at least 12, but have shape {points.shape}")
        if not np.isfinite(points).all():
            raise Rejected("the points hold nan or infinity")
        white = np.linalg.solve(np.linalg.cholesky(P), points - mean[:, None])
        distances = (white**2).sum(0)
        low, high = np.sqrt([distances.min(), distances.max()])
        around = (points.min(1) + points.max(1)) / 2
        off = bool(np.abs(around - mean).max() > 0.1 * np.sqrt(P.max()))
        otherwise = f"D from {low:.4g} to {high:.4g}" + f", around {np.round(around, 2)}" * off
        holds(high - low <= 1e-8 * high, "the same Mahalanobis distance all round", otherwise)
        angles = np.sort(np.arctan2(white[1], white[0]))
        gap = max(np.diff(angles).max(), angles[0] + 2 * np.pi - angles[-1])
        holds(gap < 1.0, "goes all the way round", f"a gap of {np.degrees(gap):.0f} degrees")
        share = np.mean(squares <= distances.mean())
        between(share, probability - 0.006, probability + 0.006, "that share of samples is inside")


@exercise("gaussians.3", "a slice through a Gaussian", seed=13)
def conditional(candidate: Candidate, rng: Rng) -> None:
    """What is seen as expected moves no mean; no variance grows; the precision is a block of the inverse of P."""
    asked = [(short(rng, n), np.round(rng.standard_normal(n), 1), i) for n, i in ((2, 0), (2, 1), (4, 2))]
    for P, at, i in cases(asked, "P {}, mean {} and i = {}"):
        n, information, rest = len(P), np.linalg.inv(P), np.delete(np.arange(len(P)), i)
        block = information[np.ix_(rest, rest)]
        shapes = {"the mean": (n - 1,), "the covariance": (n - 1, n - 1)}
        mean, found = parts(candidate(at, P, i, float(at[i])), shapes)
        same(mean, at[rest], "a value as expected moves no mean")
        covariance(found, n - 1)
        grown = float(np.max(np.diag(found) - np.diag(P)[rest]))
        holds(
            grown <= 1e-9, "no variance grows", f"one grew by {grown:.4g}: something is added that should be taken away"
        )
        ignored = np.allclose(found, P[np.ix_(rest, rest)])
        holds(not ignored, "what is seen teaches something", "the covariance is the marginal's, as if nothing was seen")
        what = "the inverse of the covariance is a block of the inverse of P"
        holds(not np.allclose(found, block), what, "this is the block itself: invert it")
        same(found, np.linalg.inv(block), what)
        value = float(at[i]) + 1.5
        mean, after = parts(candidate(at, P, i, value), shapes)
        same(after, found, "the covariance does not depend on the value")
        peak = at[rest] - np.linalg.solve(block, information[rest, i] * 1.5)
        same(mean, peak, "with a value 1.5 above its mean, the means are where the slice's density is largest")


def mistaken(share: float, probability: float, m: int) -> str:
    """Which mistakes in the threshold would keep this share, as the rest of a sentence."""
    bound = chi2_quantile(probability, m)
    thresholds = {"the other tail": chi2_quantile(1 - probability, m), "D in place of its square": bound**2}
    for d in {1, 2, 3} - {m}:
        thresholds[f"the threshold for {d} degree{'s' * (d > 1)} of freedom"] = chi2_quantile(probability, d)
    like = [name for name, c in thresholds.items() if abs(chi2_cdf(c, m) - share) <= 0.02]
    return f", as with {' or '.join(like)}" if like else ""


@exercise("gaussians.4", "a gate that keeps the good ones", seed=14)
def accepts(candidate: Candidate, rng: Rng) -> None:
    """The share of deviations that pass, in one, two and three dimensions; and that none passes but the nearest."""
    asked = [(short(rng, m), probability) for m in (1, 2, 3) for probability in (0.5, 0.95)]
    for S, probability in cases(asked, "deviations of covariance S {} and probability {}"):
        m, L = len(S), np.linalg.cholesky(S)
        white = rng.standard_normal((3000, m))
        distances = (white**2).sum(1)
        passed = np.array([bool(candidate(e, S, probability)) for e in white @ L.T])
        some = 0 < passed.sum() < len(passed)
        nearest = not some or distances[passed].max() < distances[~passed].min()
        holds(nearest, "keeps the nearest by Mahalanobis distance", "refused one that is nearer than one it kept")
        share = float(passed.mean())
        what = f"keeps the right share with {m} degree{'s' * (m > 1)} of freedom"
        holds(abs(share - probability) <= 0.04, what, f"kept {share:.2f}{mistaken(share, probability, m)}")
        holds(not candidate(100 * L[:, 0], S, 0.999), "refuses what is a hundred sigmas away", "accepted it")
