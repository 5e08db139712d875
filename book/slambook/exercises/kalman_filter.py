"""Checks of the chapter: the Kalman filter."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import cases, holds, least_squares, number, parts, random_covariance, same
from slamlib.manifolds import Array


@exercise("kalman_filter.1", "two thermometers")
def fuse(candidate: Candidate) -> None:
    """What a fusion must do in its limits and in any order, and that information adds."""

    def fused(*readings: float) -> list[Array]:
        return parts(candidate(*readings), {"the mean": (), "the variance": ()})

    readings = (20.0, 1.0, 21.0, 4.0), (-3.0, 0.2, 5.0, 0.1), (7.0, 2.0, 7.5, 2.0)
    for z1, v1, z2, v2 in cases(readings, "({}, {}, {}, {})"):
        mean, variance = fused(z1, v1, z2, v2)
        holds(min(z1, z2) < mean < max(z1, z2), "the mean lies between the readings", f"found {mean:.4g}")
        holds(0 < variance < min(v1, v2), "two know more than one", f"found the variance {variance:.4g}")
        same(fused(z2, v2, z1, v1), (mean, variance), "the order does not matter")
        same((mean - z1) / v1, (z2 - mean) / v2, "each pulls with the inverse of its variance")
        same(1 / variance, 1 / v1 + 1 / v2, "information adds")
        same(fused(z1 + 100, v1, z2 + 100, v2), (mean + 100, variance), "the zero of the scale is free")
        same(fused(z1, v1, z2, 0.0), (z2, 0.0), "a perfect thermometer determines the estimate")
        same(fused(z1, 0.0, z2, v2), (z1, 0.0), "a perfect thermometer determines the estimate")
        same(fused(z1, v1, z2, 1e14), (z1, v1), "a useless one changes nothing")


@exercise("kalman_filter.2", "one number at a time", seed=22)
def scalar_update(candidate: Candidate, rng: Rng) -> None:
    """Against weighted least squares, in any order; each number is compared with what those before it said."""
    for what in ("diagonal R", "full R"):
        n, m = 4, 3
        P, full, H = random_covariance(rng, n, 1.0), random_covariance(rng, m, 1.0), rng.standard_normal((m, n))
        R = full if what == "full R" else np.diag(rng.uniform(0.5, 2, m))
        x, z = rng.standard_normal(n), rng.standard_normal(m)
        estimate = {"the state": (n,), "the covariance": (n, n), "NIS of each number": (m,)}
        mean, found, nis = parts(candidate(x, P, z, H, R), estimate)
        best, least = least_squares(x, P, [(H, z, R)])
        same(mean, best, f"the state is that of least squares, {what}")
        same(found, least, f"information adds, {what}")
        order = rng.permutation(m)
        again, *_ = parts(candidate(x, P, z[order], H[order], R[np.ix_(order, order)]), estimate)
        same(again, mean, f"the order of the numbers does not matter, {what}")
        nu, S = z - H @ x, H @ P @ H.T + R
        whole = [nu[:k] @ np.linalg.solve(S[:k, :k], nu[:k]) for k in range(1, m + 1)]
        same(np.cumsum(nis), whole, f"NIS of the first numbers adds up to that of their batch, {what}")


@exercise("kalman_filter.3", "the gain of one cycle")
def gain(candidate: Candidate) -> None:
    """How the gain must answer to each variance, and its two limits."""
    for P, Q, R in cases(((1.0, 0.5, 2.0), (0.1, 3.0, 1.0), (5.0, 0.2, 0.3)), "P {}, Q {}, R {}"):
        K = number(candidate(P, Q, R), "the gain")
        holds(0 < K < 1, "the gain lies between 0 and 1", f"found {K:.4g}")
        holds(candidate(P, Q, 2 * R) < K, "a noisier measurement gets less weight")
        holds(candidate(P, 2 * Q, R) > K, "a level that wanders more gets a larger gain")
        holds(candidate(2 * P, Q, R) > K, "a less certain level gets a larger gain")
        same(candidate(P, Q, 1e12), 0.0, "a useless measurement is ignored")
        same(candidate(P, Q, 0.0), 1.0, "a perfect measurement determines the estimate")
        same(1 / ((1 - K) * (P + Q)), 1 / (P + Q) + 1 / R, "information adds")
