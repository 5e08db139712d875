"""Checks of the chapter: EKF-SLAM, whole."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, differences, holds, same
from slamlib.manifolds import Array


@exercise("ekf_slam.1", "what a look is worth")
def worth(candidate: Any) -> None:
    """Entropies of the state before and after, by least squares on the information matrix; and their sum."""
    rng = np.random.default_rng(161)
    for kind in range(6):
        L = rng.standard_normal((2, 2))
        P = L @ L.T + 0.05 * np.eye(2)
        if kind == 4:
            P = np.diag(np.diag(P))
        a, b, c, v = float(P[0, 0]), float(P[1, 1]), float(P[0, 1]), float(rng.uniform(0.1, 2))
        given = f"a, b, c, v = {a:.3g}, {b:.3g}, {c:.3g}, {v:.3g}"
        first, both, then = array_of(candidate(a, b, c, v), (3,), "the gains")
        before = np.linalg.slogdet(P)[1]
        one = np.linalg.slogdet(np.linalg.inv(P) + np.diag([1 / v, 0]))[1]
        two = np.linalg.slogdet(np.linalg.inv(P) + np.eye(2) / v)[1]
        bits = np.log(4)
        same(first, (before + one) / bits, "one look takes away its gain from the entropy [bits]", given=given)
        same(both, (before + two) / bits, "two looks take away theirs, what they share counted once", given=given)
        same(first + then, both, "the first look and the second after it make both", given=given)


@exercise("ekf_slam.2", "the greedy choice")
def choice(candidate: Any) -> None:
    """Each choice is the best one given those before, judged by determinants of the whole chosen set."""
    rng = np.random.default_rng(162)
    for n, m, count, shared in ((5, 2, 3, 0.0), (6, 2, 6, 3.0), (4, 1, 3, 5.0), (5, 3, 4, 2.0), (3, 2, 1, 1.0)):
        given = f"{count} of {n} candidates of {m} numbers"
        A = rng.standard_normal((n * m, n * m)) + shared * rng.standard_normal((n * m, 1)) * np.ones(n * m)
        S = A @ A.T + 0.1 * np.eye(n * m)
        if n > 4:
            S = _twin(S, m)  # the two most uncertain candidates show the same
        chosen = [int(i) for i in array_of(candidate(S, m, count), (count,), "the choice")]
        holds(len(set(chosen)) == count, "nobody is chosen twice", f"found {chosen} for {given}")
        holds(all(0 <= i < n for i in chosen), "candidates are counted from 0", f"found {chosen} for {given}")
        for k in range(count):
            gains = [_logdet(S, m, [*chosen[:k], i]) for i in range(n) if i not in chosen[:k]]
            what = "each choice is the best of the rest, given those before"
            behind = max(gains) - _logdet(S, m, chosen[: k + 1])
            holds(behind < 1e-6, what, f"choice {k + 1} is {behind:.3g} nats behind for {given}: {chosen}")


def _logdet(S: Array, m: int, chosen: list[int]) -> float:
    rows = np.concatenate([np.arange(i * m, i * m + m) for i in chosen])
    return float(np.linalg.slogdet(S[np.ix_(rows, rows)])[1])


def _twin(S: Array, m: int) -> Array:
    """The same candidates, the first of them made large, and the second a copy of it with noise of its own."""
    T = np.eye(len(S))
    T[:m, :m] *= 4
    T[m : 2 * m, :] = T[:m, :]
    return np.asarray(T @ S @ T.T + 0.1 * np.eye(len(S)))


@exercise("ekf_slam.3", "what no look can see")
def directions(candidate: Any) -> None:
    """Three independent columns along which range and bearing of every landmark stay as they are."""
    rng = np.random.default_rng(163)
    for landmarks in (1, 2, 5):
        for _ in range(3):
            x = rng.uniform(-5, 5, 3 + 2 * landmarks)
            given = f"{landmarks} landmarks"
            N = array_of(candidate(x.copy()), (len(x), 3), "the directions")
            smallest = float(np.linalg.svd(N)[1][-1])
            holds(smallest > 1e-6, "they are three, not fewer", f"the columns are dependent for {given}")
            seen = differences(_looks, x) @ N / max(1.0, float(np.abs(N).max()))
            what = "range and bearing of no landmark change along them"
            holds(np.abs(seen).max() < 1e-6, what, f"a look changes by {np.abs(seen).max():.3g} for {given}")


def _looks(x: Array) -> Array:
    """Ranges and sines and cosines of the bearings, which have no jump."""
    d = x[3:].reshape(-1, 2) - x[:2]
    bearing = np.arctan2(d[:, 1], d[:, 0]) - x[2]
    return np.concatenate([np.hypot(d[:, 0], d[:, 1]), np.sin(bearing), np.cos(bearing)])
