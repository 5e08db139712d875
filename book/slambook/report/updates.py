"""One update by five methods: the report's chapter 6, component by component against all at once.

All of them compute (3.10) to (3.14) at one linearisation, and so the same numbers; they differ in what they multiply.
k = 3m numbers are measured of m landmarks, n = 6 + 3L is the size of the state, and each number depends on nine of it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.report import observation
from slambook.report.angles import rotation
from slambook.report.observation import by_pose, by_vectors
from slamlib.belief import Belief
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices

State = tuple[Array, Array]  # x (n,), P (n, n)


@dataclass(frozen=True, eq=False)
class Problem:
    """A state x (n,) with covariance P (n, n), and measurements of m of its landmarks.

    places (m,): which landmarks; H (m, 3, 9): derivatives w.r.t. pose and landmark, (5.29); difference (m, 3): measured
    minus predicted; variances (m, 3) of what is measured. Correlated noise would be whitened first (E17).
    """

    x: Array
    P: Array
    places: Indices
    H: Array
    difference: Array
    variances: Array

    def columns(self, i: int) -> Indices:
        """The nine columns that observation i touches."""
        return np.concatenate([np.arange(6), 6 + 3 * self.places[i] + np.arange(3)])


def observe(x: Array, P: Array, places: Indices, seen: Array, variances: Array) -> Problem:
    """The problem of points (m, 3), seen relative to the robot, of these landmarks."""
    points = x[6:].reshape(-1, 3)[places]
    by_point = np.broadcast_to(rotation(x[3:6]).T, (len(places), 3, 3))
    H = np.concatenate([by_pose(x[:6], points), by_point], -1)
    return Problem(x, P, places, H, seen - by_vectors(x[:6], points), variances)


def problem(rng: np.random.Generator, landmarks: int, seen: int) -> Problem:
    """A map of so many landmarks with a full covariance, of which so many are seen."""
    n, std = 6 + 3 * landmarks, np.array([0.03, 0.03, 0.05])
    x = np.concatenate([rng.uniform(-0.3, 0.3, 6), rng.uniform(-8, 8, 3 * landmarks)])
    root = rng.standard_normal((n, n)) * np.where(np.arange(n) < 6, 0.02, 0.2)[:, None] / np.sqrt(n)
    truth, places = x + root @ rng.standard_normal(n), rng.permutation(landmarks)[:seen]
    relative = by_vectors(truth[:6], truth[6:].reshape(-1, 3)[places])
    z = relative + std * rng.standard_normal((seen, 3))
    return observe(x, root @ root.T, places, z, np.broadcast_to(std**2, (seen, 3)))


def dense(p: Problem) -> Array:
    """H of the whole state (3m, n): mostly zeros, (5.28)."""
    H = np.zeros((p.difference.size, len(p.x)), dtype=p.H.dtype)
    for i in range(len(p.places)):
        H[3 * i : 3 * i + 3, p.columns(i)] = p.H[i]
    return H


def naive(p: Problem, inverse: Callable[[Array], Any] = np.linalg.inv) -> Callable[[], State]:
    """(3.11) to (3.14) as they are printed, with whole matrices."""

    def run() -> State:
        H, R, one = dense(p), np.diag(p.variances.ravel()), np.eye(len(p.x), dtype=p.x.dtype)
        PH = p.P @ H.T
        K = PH @ inverse(H @ PH + R)
        return p.x + K @ p.difference.ravel(), (one - K @ H) @ p.P

    return run


def ordered(p: Problem) -> Callable[[], State]:
    """The same matrices, in a better order: P - K (H P), and no inverse."""
    return lambda: observation.batch(p.x, p.P, p.difference.ravel(), dense(p), np.diag(p.variances.ravel()))


def scalar(p: Problem) -> Callable[[], State]:
    """(5.27) to (5.32), corrected: one component after another, with the nine non-zero columns of H alone."""
    x, P = p.x.copy(), p.P.copy()

    def run() -> State:
        for i in range(len(p.places)):
            at = p.columns(i)
            for h, difference, variance in zip(p.H[i], p.difference[i], p.variances[i], strict=True):
                Ph = P[:, at] @ h
                K = Ph / (Ph[at] @ h + variance)  # (5.27), (5.30)
                x[:] += K * (difference - h @ (x[at] - p.x[at]))  # (5.31), the innovation running along (E16)
                P[:] -= K[:, None] * Ph  # (5.32)
        return x, P

    return run


def as_belief(p: Problem) -> tuple[Belief, list[Block]]:
    """The state as a belief of slamlib: the pose, then the landmarks."""
    belief = Belief()
    whole = belief.add(6, p.x[:6], p.P[:6, :6])
    blocks = [whole, *(belief.add(3, m, np.eye(3)) for m in p.x[6:].reshape(-1, 3))]
    belief.overwrite(dict(enumerate(blocks)), {i: b.mean for i, b in enumerate(blocks)}, p.P)
    return belief, blocks


def state(belief: Belief) -> State:
    """Means and covariance of a belief."""
    return np.concatenate([b.mean for b in belief.blocks]), belief.matrix


def batch(p: Problem) -> Callable[[], State]:
    """slamlib's batch: H of what is touched alone, one Cholesky factor, P - W'W."""
    belief, _ = as_belief(p)

    def run() -> State:
        m = len(p.places)
        H = np.zeros((3 * m, 6 + 3 * m))
        H[:, :6] = p.H[..., :6].reshape(-1, 6)
        for i in range(m):
            H[3 * i : 3 * i + 3, 6 + 3 * i : 9 + 3 * i] = p.H[i, :, 6:]
        columns = np.concatenate([np.arange(6), (6 + 3 * p.places[:, None] + np.arange(3)).ravel()])
        belief.update_rows(columns, H, p.difference.ravel(), np.diag(p.variances.ravel()))
        return state(belief)

    return run


def series(p: Problem) -> Callable[[], State]:
    """slamlib's sequential update: landmark by landmark, and the covariance once at the end, linearised once."""
    belief, blocks = as_belief(p)
    pose = blocks[0]

    def run() -> State:
        with belief.sequential_update() as corrections:
            for i, place in enumerate(p.places):
                moved = np.concatenate([pose.mean, blocks[1 + place].mean]) - p.x[p.columns(i)]
                corrections.update(p.columns(i), p.H[i], p.difference[i] - p.H[i] @ moved, np.diag(p.variances[i]))
        return state(belief)

    return run


WAYS: dict[str, Callable[[Problem], Callable[[], State]]] = {
    "whole matrices": naive,
    "whole matrices, ordered": ordered,
    "number by number": scalar,
    "slamlib, batch": batch,
    "slamlib, series": series,
}


def multiplications(landmarks: int, seen: int) -> dict[str, int]:
    """Multiplications of each method, divisions counted, for L landmarks of which m are seen.

    Whole matrices: P H', H P H', an inverse, K, K y, K H, (1 - K H) P. Ordered: the last is K (H P), and a system of
    k equations is solved. slamlib: H P of c = 6 + 3m columns, its factor, W, and half of W'W, which is symmetric. In a
    series: of nine columns for each landmark, less what the rows of W so far take away.
    """
    n, k, c = 6 + 3 * landmarks, 3 * seen, 6 + 3 * seen
    return {
        "whole matrices": 2 * k * n * n + 2 * n * k * k + k**3 + n * k + n**3,
        "whole matrices, ordered": 2 * k * n * n + 2 * n * k * k + k**3 // 3 + n * k,
        "number by number": k * (n * n + 11 * n + 18),
        "slamlib, batch": k * c * n + k * k * c + k**3 // 6 + n * k * (k + 1) // 2 + n * k + k * n * (n + 1) // 2,
        "slamlib, series": k * 9 * n + n * k * (k - 3) // 2 + 3 * n * k + k * n * (n + 1) // 2,
    }
