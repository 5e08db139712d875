"""The largest jointly compatible set of innovations, by branch and bound (JCBB). Chapter data_association.

Neira and Tardos (2001) let a tree decide, one innovation after another, what it is paired with. Where each innovation
has one candidate at most, the only choice is "in" or "out", and few are out: so this tree starts with all of them
and removes some. With the information matrix A = S^-1 and a = A z of all, removing the set B lowers the joint square by

    drop(B) = a_B' A_BB^-1 a_B,        and leaves        A - A_:B A_BB^-1 A_B:,    a - A_:B A_BB^-1 a_B

of the others (that is marginalization): O(k^2) numbers a step for one innovation out of k.
"""

from collections.abc import Callable

import numpy as np

from slamlib.kalman import linalg
from slamlib.manifolds import Array, Indices, Mask

Threshold = Callable[[int], float]
MAX_NODES = 15  # of the tree, 60 to 100 us each; the greedy set is nearly always the best (benchmarks/consensus.py)


class _Node:
    """What is left of A (n, d, n, d) and a (n, d), and the drop of each innovation; removed ones have none."""

    def __init__(self, A: Array, a: Array) -> None:
        self.A, self.a, self.each = A, a, np.arange(len(a))
        self.own = A[self.each, :, self.each]
        self.drops = (a * np.linalg.solve(self.own, a[..., None])[..., 0]).sum(-1)

    def without(self, i: int) -> "_Node":
        """The node without innovation i, which stays as an innovation of zero that nothing else depends on."""
        n, d = self.a.shape
        gain = np.linalg.solve(self.own[i], self.A[i].reshape(d, n * d))
        A = self.A - (gain.T @ self.A[i].reshape(d, n * d)).reshape(n, d, n, d)
        a = self.a - (self.a[i] @ gain).reshape(n, d)
        A[i], A[:, :, i], a[i] = 0, 0, 0
        A[i, :, i] = np.eye(d)
        return _Node(A, a)

    def tightness(self, count: int) -> float:
        """A number t with drop(B) <= (sum of the drops in B) / t for every B of `count`; 0 where none is known.

        With blocks scaled to A_ii = 1, Gershgorin's circles bound the eigenvalues of A_BB from below by one minus the
        largest sum of norms beside the diagonal, of which B has count - 1 in a row.
        """
        if count == 1:
            return 1.0
        white = np.linalg.inv(np.linalg.cholesky(self.own))
        scaled = white[:, None] @ self.A.transpose(0, 2, 1, 3) @ white.swapaxes(-1, -2)
        norms = np.sqrt((scaled * scaled).sum((-2, -1)))
        norms[self.each, self.each] = 0
        beside = np.sort(norms, axis=1)[:, 1 - count :].sum(1)
        return max(0.0, 1 - float(beside.max()))


class _Search:
    """Search for the fewest innovations (n, d) to remove; keeps the best such set found so far.

    factor (n d, n d): lower Cholesky factor of their joint covariance.
    """

    def __init__(self, z: Array, factor: Array, dof: Array, limit: Threshold, max_nodes: int) -> None:
        n, d = z.shape
        white = linalg.solve_lower(factor, np.eye(n * d))
        A = white.T @ white
        a = A @ z.ravel()
        self.root = _Node(A.reshape(n, d, n, d), a.reshape(n, d))
        self.square, self.dof, self.limit, self.left = float(z.ravel() @ a), dof, limit, max_nodes
        self.total, self.least = int(dof.sum()), int(dof.min())
        self.out: tuple[int, ...] = ()
        self.drop = -np.inf

    def wanted(self, dof: int) -> float:
        """The drop to be exceeded when innovations of `dof` degrees of freedom are removed."""
        rest = self.total - dof
        return self.square - self.limit(rest) if rest > 0 else -np.inf

    def greedy(self) -> tuple[tuple[int, ...], float]:
        """Remove what lowers the square most, until the remaining set is compatible."""
        out: list[int] = []
        drop, node = 0.0, self.root
        while len(out) < len(self.dof) and not drop > self.wanted(int(self.dof[out].sum())):
            drops = node.drops.copy()
            drops[out] = -1
            i = int(drops.argmax())
            out, drop, node = [*out, i], drop + float(drops[i]), node.without(i)
        return tuple(out), drop

    def branch(self, node: _Node, out: tuple[int, ...], drop: float, candidates: Indices, count: int) -> None:
        """Remove `count` more of the `candidates`, wherever that can be enough and better than the best set so far."""
        self.left -= 1
        candidates = candidates[np.argsort(-node.drops[candidates], kind="stable")]
        gone = int(self.dof[list(out)].sum())
        if count == 1:
            self._last(candidates, out, drop + node.drops[candidates], gone)
            return
        sums = np.concatenate([[0.0], np.cumsum(node.drops[candidates])])
        tightness = node.tightness(count)
        for first in range(len(candidates) - count + 1):
            bound = drop + (sums[first + count] - sums[first]) / tightness if tightness > 0 else np.inf
            if self.left <= 0 or bound <= max(self.drop, self.wanted(gone + count * self.least)):
                return
            i = int(candidates[first])
            self.branch(node.without(i), (*out, i), drop + float(node.drops[i]), candidates[first + 1 :], count - 1)

    def _last(self, candidates: Indices, out: tuple[int, ...], drops: Array, gone: int) -> None:
        for i, drop in zip(candidates.tolist(), drops.tolist(), strict=True):
            if drop <= self.drop:
                return
            if drop > self.wanted(gone + int(self.dof[i])):
                self.out, self.drop = (*out, i), drop


def jcbb(z: Array, S: Array, dof: Array, limit: Threshold, max_nodes: int = MAX_NODES) -> Mask:
    """Mask (n,) of the largest set of innovations whose joint square z' S^-1 z is below limit(its degrees of freedom).

    z (n, d), S (n, d, n, d) positive definite, dof (n,). Of sets of one size the one with the smallest square. Exact,
    unless more than `max_nodes` nodes of the tree are needed: then the best set found so far, at worst the greedy one
    (always remove what lowers the square most), which is compatible and rarely another one. Raises CovarianceError.
    """
    factor = linalg.cholesky(S.reshape(z.size, z.size), "jcbb", "the joint covariance of the innovations")
    white = linalg.solve_lower(factor, z.ravel())
    if white @ white < limit(int(dof.sum())):  # as in most frames: there is nothing to search for
        return np.ones(len(z), dtype=bool)
    search = _Search(z, factor, dof, limit, max_nodes)
    greedy, drop = search.greedy()
    for count in range(1, len(greedy) + 1):
        if count == len(greedy):
            search.out, search.drop = greedy, drop
        search.branch(search.root, (), 0.0, np.arange(len(z)), count)
        if search.out or search.left <= 0:
            break
    keep: Mask = np.ones(len(z), dtype=bool)
    keep[list(search.out or greedy)] = False
    return keep
