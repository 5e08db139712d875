"""Checks of the chapter: the Kalman filter."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import (
    array_of,
    cases,
    holds,
    least_squares,
    number,
    parts,
    random_covariance,
    same,
)
from slamlib.manifolds import Array


@exercise("kalman_filter.1", "two thermometers")
def fuse(candidate: Candidate) -> None:
    """Limits and symmetries of a fusion, that it knows its own error, and that no other weights have a smaller one."""

    def fused(*readings: float) -> list[Array]:
        return parts(candidate(*readings), {"the mean": (), "the variance": ()})

    told = "z1 = {}, v1 = {}, z2 = {}, v2 = {}, c = {}"
    independent = (20.0, 1.0, 21.0, 4.0, 0.0), (-3.0, 0.2, 5.0, 0.1, 0.0), (7.0, 2.0, 7.5, 2.0, 0.0)
    for z1, v1, z2, v2, c in cases(independent, told):
        mean, variance = fused(z1, v1, z2, v2, c)
        holds(min(z1, z2) < mean < max(z1, z2), "the mean lies between independent readings", f"found {mean:.4g}")
        known = f"found the variance {variance:.4g}"
        holds(0 < variance < min(v1, v2), "two independent readings know more than one", known)
        same(fused(z2, v2, z1, v1, c), (mean, variance), "the order does not matter")
        same((mean - z1) / v1, (z2 - mean) / v2, "each independent one pulls with the inverse of its variance")
        same(1 / variance, 1 / v1 + 1 / v2, "information adds, of independent readings")
    correlated = (20.0, 1.0, 21.0, 4.0, 0.5), (-3.0, 0.2, 5.0, 0.1, -0.05), (7.0, 1.0, 8.0, 4.0, 1.5)
    # only these: with c = 0 another share was rejected above, and would seem to hold for whoever neglects c
    for z1, v1, z2, v2, c in cases(correlated, told):
        mean, variance = fused(z1, v1, z2, v2, c)
        same(fused(z1 + 100, v1, z2 + 100, v2, c), (mean + 100, variance), "the zero of the scale is free")
        share = float(fused(0.0, v1, 1.0, v2, c)[0])
        same(variance, _variance(share, v1, v2, c), "the claimed variance is that of the error")
        other = min(_variance(share + step, v1, v2, c) for step in (-0.01, 0.01))
        worse = f"found K = {share:.4g}, of variance {variance:.6g}; a share that differs by 0.01 has {other:.6g}"
        holds(variance <= other, "no other share does better", worse)
        same(fused(z2, v2, z1, v1, c), (mean, variance), "the order does not matter")
    for z1, v1, z2, v2, c in cases(((20.0, 1.0, 21.0, 0.0, 0.0), (20.0, 0.0, 21.0, 4.0, 0.0)), told):
        same(fused(z1, v1, z2, v2, c), (z2 if v1 else z1, 0.0), "a perfect thermometer determines the estimate")
    for z1, v1, z2, v2, c in cases(((20.0, 1.0, 21.0, 1e14, 0.0),), told):
        same(fused(z1, v1, z2, v2, c), (z1, v1), "a useless one changes nothing")


def _variance(share: float, v1: float, v2: float, c: float) -> float:
    """Of the error of (1 - share) z1 + share z2."""
    return (1 - share) ** 2 * v1 + share**2 * v2 + 2 * share * (1 - share) * c


@exercise("kalman_filter.2", "one number at a time", seed=22)
def scalar_update(candidate: Candidate, rng: Rng) -> None:
    """The order of the numbers, weighted least squares, and what each surprises those before it."""
    # order first: it names the mistake of whoever uses the state, or the covariance, of the prediction throughout
    two = np.array([1.0, 0.5]), np.array([[4.0, 1.0], [1.0, 2.0]]), np.array([3.0, 1.0])
    H_two = np.array([[1.0, 0.0], [1.0, 1.0]])
    inputs = [(*two, H_two, np.diag([1.0, 2.0])), (*two, H_two, np.array([[1.0, 0.8], [0.8, 2.0]]))]
    for full in (False, True):
        n, m = 4, 3
        P, R, H = random_covariance(rng, n, 1.0), random_covariance(rng, m, 1.0), rng.standard_normal((m, n))
        inputs.append((rng.standard_normal(n), P, rng.standard_normal(m), H, R if full else np.diag(np.diag(R))))
    for x, P, z, H, R in cases(inputs, "x = {}, P = {}, z = {}, H = {}, R = {}"):
        kind = "diagonal R" if np.array_equal(R, np.diag(np.diag(R))) else "full R"
        estimate = {"the state": x.shape, "the covariance": P.shape, "NIS of each number": z.shape}
        mean, found, nis = parts(candidate(x, P, z, H, R), estimate)
        back = np.arange(len(z))[::-1]
        again, after, _ = parts(candidate(x, P, z[back], H[back], R[np.ix_(back, back)]), estimate)
        same(again, mean, f"the order of the numbers does not matter for the state, {kind}")
        same(after, found, f"the order of the numbers does not matter for the covariance, {kind}")
        best, least = least_squares(x, P, [(H, z, R)])
        same(found, least, f"information adds, {kind}")
        same(mean, best, f"the state is that of least squares, {kind}")
        nu, S = z - H @ x, H @ P @ H.T + R
        whole = [nu[:k] @ np.linalg.solve(S[:k, :k], nu[:k]) for k in range(1, len(z) + 1)]
        same(np.cumsum(nis), whole, f"NIS of the first numbers adds up to that of their batch, {kind}")


@exercise("kalman_filter.3", "the gain of one cycle")
def gain(candidate: Candidate) -> None:
    """How the gain must answer to each variance, and its two limits."""
    for P, Q, R in cases(((1.0, 0.5, 2.0), (0.1, 3.0, 1.0), (5.0, 0.2, 0.3)), "P = {}, Q = {}, R = {}"):
        K = number(candidate(P, Q, R), "the gain")

        def compared(name: str, now: tuple[float, float, float], before: float = K) -> tuple[float, str]:
            other = number(candidate(*now), "the gain")
            return other, f"found {before:.4g}, and {other:.4g} with twice the {name}"

        holds(0 < K < 1, "the gain lies between 0 and 1", f"found {K:.4g}")
        noisier, told = compared("R", (P, Q, 2 * R))
        holds(noisier < K, "a noisier measurement gets less weight", told)
        wandering, told = compared("Q", (P, 2 * Q, R))
        holds(wandering > K, "a level that wanders more gets a larger gain", told)
        vaguer, told = compared("P", (2 * P, Q, R))
        holds(vaguer > K, "a less certain level gets a larger gain", told)
        same(candidate(P, Q, 1e12), 0.0, "a useless measurement is ignored", 1e-4)
        same(candidate(P, Q, 0.0), 1.0, "a perfect measurement determines the estimate")
        same(1 / ((1 - K) * (P + Q)), 1 / (P + Q) + 1 / R, "information adds")


@exercise("kalman_filter.5", "variances that change", seed=25)
def levels(candidate: Candidate, rng: Rng) -> None:
    """What each year's variances must do, and least squares of all that was measured so far."""
    n, level, P = 5, 10.0, 4.0
    flow, Q, R = rng.integers(5, 20, n).astype(float), rng.uniform(0.5, 2, n).round(2), rng.uniform(1, 4, n).round(2)

    def found(Q: object, R: object) -> Array:
        return array_of(candidate(flow, Q, R, level, P), (n,), "the levels")

    def alike(value: float) -> Array:
        return np.full(n, value)

    told = f"flow = {flow}, level = {level}, P = {P}, Q = {Q}, R = {R}"
    for k in cases(range(n - 1), told + ", and k = {}"):
        later = np.arange(n) > k
        changed = found(np.where(later, 3 * Q, Q), np.where(later, 5 * R, R))
        same(changed[: k + 1], found(Q, R)[: k + 1], "what comes later does not matter to year k")
    for k in cases(range(n), told + ", and k = {}"):
        one = np.arange(n) == k
        same(found(np.where(one, 1e12, Q), R)[k], flow[k], "with Q[k] = 1e12, year k follows its flow", 1e-6)
        before = found(Q, R)[k - 1] if k else level
        same(found(Q, np.where(one, 1e12, R))[k], before, "with R[k] = 1e12, the flow of year k changes nothing", 1e-6)
    for q, r in cases(((1.0, 2.0), (0.3, 4.0)), "Q = {}, R = {}"):
        once = found(q, r)
        same(found(alike(q), alike(r)), once, "a number is an array of it")
        same(found(q, alike(r)), once, "a number is an array of it, also for Q alone")
    together = np.minimum.outer(P + np.cumsum(Q), P + np.cumsum(Q))
    rows, all_levels = np.eye(n), found(Q, R)
    for k in cases(range(n), told + ", and k = {}"):
        seen = [(rows[i], flow[i], R[i]) for i in range(k + 1)]
        best, _ = least_squares(np.full(n, level), together, seen)
        same(all_levels[k], best[k], "the level of year k is that of least squares")
