"""Checks of the chapter: EKF-SLAM, whole."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, given, holds, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("ekf_slam.1", "what a measurement is worth", seed=161)
def worth(candidate: Candidate, rng: Rng) -> None:
    """Entropies of the state before and after, by least squares on the information matrix; and their sum."""
    for kind in cases(range(6)):
        L = rng.standard_normal((2, 2))
        P = L @ L.T + 0.05 * np.eye(2)
        if kind == 4:
            P = np.diag(np.diag(P))
        a, b, c, v = float(P[0, 0]), float(P[1, 1]), float(P[0, 1]), float(rng.uniform(0.1, 2))
        given(f"a, b, c, v = {a:.3g}, {b:.3g}, {c:.3g}, {v:.3g}")
        first, both, then = array_of(candidate(a, b, c, v), (3,), "the gains")
        before, bits = np.linalg.slogdet(P)[1], np.log(4)
        one = np.linalg.slogdet(np.linalg.inv(P) + np.diag([1 / v, 0]))[1]
        two = np.linalg.slogdet(np.linalg.inv(P) + np.eye(2) / v)[1]
        same(first, (before + one) / bits, "one measurement reduces the entropy [bits] by its gain")
        same(both, (before + two) / bits, "two measurements reduce it by theirs, what they share counted once")
        same(first + then, both, "the gains of the first and then the second add up to that of both")


@exercise("ekf_slam.2", "the greedy choice", seed=162)
def choice(candidate: Candidate, rng: Rng) -> None:
    """Each choice is the best one given those before, judged by determinants of the whole chosen set."""
    sets = (3, 5, 2, 0.0), (6, 6, 2, 3.0), (3, 4, 1, 5.0), (4, 5, 3, 2.0), (1, 3, 2, 1.0)
    for count, n, m, shared in cases(sets, "{} of {} candidates of {} numbers"):
        A = rng.standard_normal((n * m, n * m)) + shared * rng.standard_normal((n * m, 1)) * np.ones(n * m)
        if n > 4:  # the first candidate is made large, and the second a copy of it with noise of its own
            A[:m] *= 4
            A[m : 2 * m] = A[:m]
        S = A @ A.T + 0.1 * np.eye(n * m)
        chosen = [int(i) for i in array_of(candidate(S, m, count), (count,), "the choice")]
        holds(len(set(chosen)) == count, "nobody is chosen twice", f"found {chosen}")
        holds(all(0 <= i < n for i in chosen), "candidates are counted from 0", f"found {chosen}")
        for k in range(count):
            gains = [_logdet(S, m, [*chosen[:k], i]) for i in range(n) if i not in chosen[:k]]
            what = "each choice is the best of the rest, given those before"
            behind = max(gains) - _logdet(S, m, chosen[: k + 1])
            holds(behind < 1e-6, what, f"choice {k + 1} of {chosen} is {behind:.3g} nats behind")
    equals = array_of(candidate(np.eye(10), 2, 3), (3,), "the choice").tolist()
    holds(equals == [0, 1, 2], "of equally good ones the earlier is taken", f"found {equals} of five that are equal")


def _logdet(S: Array, m: int, chosen: list[int]) -> float:
    rows = np.concatenate([np.arange(i * m, i * m + m) for i in chosen])
    return float(np.linalg.slogdet(S[np.ix_(rows, rows)])[1])


@exercise("ekf_slam.3", "what no measurement observes", seed=163)
def directions(candidate: Candidate, rng: Rng) -> None:
    """Three independent columns along which range and bearing of every landmark stay as they are."""
    for landmarks in cases((1, 1, 1, 2, 2, 2, 5, 5, 5), "{} landmarks"):
        x = rng.uniform(-5, 5, 3 + 2 * landmarks)
        N = array_of(candidate(x.copy()), (len(x), 3), "the directions")
        holds(np.linalg.svd(N)[1][-1] > 1e-6, "they are three, not fewer", "the columns are dependent")
        seen = differences(_looks, x) @ N / max(1.0, float(np.abs(N).max()))
        what = "range and bearing of no landmark change along them"
        holds(np.abs(seen).max() < 1e-6, what, f"a measurement changes by {np.abs(seen).max():.3g}")


def _looks(x: Array) -> Array:
    """Ranges and sines and cosines of the bearings, which have no jump."""
    d = x[3:].reshape(-1, 2) - x[:2]
    bearing = np.arctan2(d[:, 1], d[:, 0]) - x[2]
    return np.concatenate([np.hypot(d[:, 0], d[:, 1]), np.sin(bearing), np.cos(bearing)])
