"""A Gaussian belief over blocks: each block has a mean in its own space, all share one dense covariance.

The covariance is over tangent vectors, so a pose takes six rows and the matrix is never singular by construction. Every
change is checked first and made whole or not at all. The same few functions serve a linear Kalman filter, an extended
one, and SLAM. Derived in chapters 2, 3 and 9.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from slamlib import linalg
from slamlib.correction import Correction, Observation, method_named, stack
from slamlib.errors import SlamlibError
from slamlib.spaces import Array, Space, as_space

__all__ = ["Belief", "BeliefSnapshot", "Block", "Correction", "Observation"]


class Block:
    """A handle to one part of the belief; its mean is read-only, its covariance is belief.covariance(block)."""

    def __init__(self, space: Space, mean: Array, start: int) -> None:
        self.space, self.start = space, start
        self.mean = mean

    @property
    def dof(self) -> int:
        return self.space.dof

    @property
    def slice(self) -> slice:
        return slice(self.start, self.start + self.dof)

    def __repr__(self) -> str:
        return f"<block {self.space!r} at {self.start}>"


@dataclass(frozen=True)
class BeliefSnapshot:
    """Means and covariance at one moment, as arrays of their own."""

    means: tuple[Array, ...]
    slices: tuple[slice, ...]
    covariance: Array


class Belief:
    """Means of blocks and their joint covariance."""

    def __init__(self) -> None:
        self.blocks: list[Block] = []
        self._store = np.zeros((0, 0))
        self._size = 0

    @property
    def size(self) -> int:
        """Number of estimated degrees of freedom."""
        return self._size

    @property
    def matrix(self) -> Array:
        """The joint covariance (size, size), as a read-only view."""
        view = self._P.view()
        view.flags.writeable = False
        return view

    @property
    def _P(self) -> Array:
        return self._store[: self._size, : self._size]

    def covariance(self, a: Block, b: Block | None = None) -> Array:
        """Covariance of one block (dof, dof), or between two, as a copy."""
        self._own(a, *([b] if b else []))
        return self._P[a.slice, (b or a).slice].copy()

    def snapshot(self) -> BeliefSnapshot:
        """Means and covariance as they are now."""
        return BeliefSnapshot(tuple(b.mean for b in self.blocks), tuple(b.slice for b in self.blocks), self._P.copy())

    def add(
        self,
        space: int | Space,
        mean: Array,
        covariance: Array,
        *,
        given: Sequence[Block] = (),
        jacobians: Sequence[Array] = (),
    ) -> Block:
        """A new block, independent, or a function of the blocks `given` plus noise of this covariance (dof, dof).

        jacobians: of the new block by each given block, (dof, dof of the given block). The new rows are then
        sum G_i P_i and the new corner sum G_i P_ij G_j' + covariance (Report eq. 5.34-5.35, corrected: errata E18).
        """
        space = as_space(space)
        mean, noise = _point(space, mean, "add"), linalg.covariance(covariance, space.dof, "add", "covariance")
        self._own(*given)
        gains = self._compact(given, jacobians, space.dof, "add")
        rows = sum((G @ self._P[b.slice] for b, G in zip(given, gains, strict=True)), np.zeros((space.dof, self._size)))
        corner = noise + sum((rows[:, b.slice] @ G.T for b, G in zip(given, gains, strict=True)), np.zeros_like(noise))
        block = Block(space, mean, self._size)
        self._grow(self._size + space.dof)
        self._P[block.slice] = self._P[:, block.slice] = 0
        self._P[block.slice, : block.start] = rows
        self._P[: block.start, block.slice] = rows.T
        self._P[block.slice, block.slice] = (corner + corner.T) / 2
        self.blocks.append(block)
        return block

    def remove(self, block: Block) -> None:
        """Forget a block: its rows and columns go, which is exactly the marginal of the rest."""
        self._own(block)
        keep = np.r_[0 : block.start, block.slice.stop : self._size]
        self._set(self._P[np.ix_(keep, keep)])
        self.blocks.remove(block)
        for other in self.blocks:
            other.start -= block.dof if other.start > block.start else 0

    def replace(self, block: Block, space: int | Space, mean: Array, jacobian: Array) -> Block:
        """Another parametrization of a block: its rows become J P, J (new dof, old dof). Other handles stay."""
        space = as_space(space)
        mean = _point(space, mean, "replace")
        self._own(block)
        J = linalg.finite(jacobian, (space.dof, block.dof), "replace", "jacobian")
        before, after = slice(0, block.start), slice(block.slice.stop, self._size)
        left = np.zeros((self._size - block.dof + space.dof, self._size))
        left[before, before] = np.eye(block.start)
        left[block.start : block.start + space.dof, block.slice] = J
        left[block.start + space.dof :, after] = np.eye(self._size - after.start)
        P = left @ self._P @ left.T
        self._set((P + P.T) / 2)
        for other in self.blocks:
            other.start += space.dof - block.dof if other.start > block.start else 0
        block.space, block.mean = space, mean
        return block

    def predict(self, block: Block, mean: Array, F: Array, Q: Array) -> None:
        """Move a block: its mean becomes `mean`, its rows F P, its corner F P F' + Q (Report eq. 5.23 with E10)."""
        self._own(block)
        mean, n = _point(block.space, mean, "predict"), block.dof
        F, Q = linalg.finite(F, (n, n), "predict", "F"), linalg.covariance(Q, n, "predict", "Q")
        P, at = self._P, block.slice
        corner = F @ P[at, at] @ F.T + Q
        P[at] = F @ P[at]
        P[:, at] = P[at].T
        P[at, at] = (corner + corner.T) / 2
        block.mean = mean

    def innovation_covariance(self, blocks: Sequence[Block], jacobians: Sequence[Array], R: Array) -> Array:
        """H P H' + R, (m, m), for the blocks that a measurement depends on."""
        m = np.asarray(jacobians[0]).shape[0]
        R = linalg.covariance(R, m, "innovation_covariance", "R")
        HP, H, touched = self._project([Observation(blocks, jacobians, np.zeros(m), R)])
        return HP[:, touched] @ H.T + R

    def correct(
        self, blocks: Sequence[Block], jacobians: Sequence[Array], innovation: Array, R: Array, *, method: str = "batch"
    ) -> Correction:
        """Correct all blocks by one measurement: innovation z = y - e (m,), Jacobians of e, noise R (m, m)."""
        return self.correct_all([Observation(blocks, jacobians, innovation, R)], method=method)

    def correct_all(self, observations: Sequence[Observation], *, method: str = "batch") -> Correction:
        """Correct all blocks by several measurements at once; Jacobians and innovations at the present means.

        method: "batch" (one factorization), or "scalar": whitened by R and then one number after another, with the
        innovation running along (errata E16, E17). Both give the same result but for rounding; "scalar" needs R > 0.
        The covariance stays that of the tangent space before the correction: re-centring it would multiply a rotation's
        rows by I - [dtheta/2]x, a change of the order of the correction itself times P, which the first-order filter
        neglects as it neglects the curvature of the models (Sola 2017, section 6.3).
        """
        solve = method_named(method)
        z, R = stack(observations)
        HP, H, touched = self._project(observations)
        S = HP[:, touched] @ H.T + R
        step, rows, nis = solve(HP, H, touched, (S + S.T) / 2, R, z)
        means = [b.space.plus(b.mean, step[b.slice]) for b in self.blocks]
        for block, mean in zip(self.blocks, means, strict=True):
            linalg.finite(mean, (block.space.size,), "correct", f"the corrected mean of {block!r}")
        P = self._P
        linalg.subtract_square(P, rows)
        for block, mean in zip(self.blocks, means, strict=True):
            block.mean = _frozen(mean)
        return Correction(z, S, nis)

    def _project(self, observations: Sequence[Observation]) -> tuple[Array, Array, Array]:
        """H P for all columns, and H on the touched degrees of freedom only, with their indices."""
        parts: list[Block] = []
        for observation in observations:
            self._own(*observation.blocks)
            parts += [b for b in observation.blocks if b not in parts]
        starts = dict(zip(map(id, parts), np.cumsum([0, *(b.dof for b in parts)]), strict=False))
        touched = np.concatenate([np.arange(b.start, b.slice.stop) for b in parts])
        sizes = [np.asarray(o.innovation).size for o in observations]
        H, row = np.zeros((sum(sizes), len(touched))), 0
        for observation, m in zip(observations, sizes, strict=True):
            for block, J in zip(
                observation.blocks, self._compact(observation.blocks, observation.jacobians, m, "correct"), strict=True
            ):
                H[row : row + m, starts[id(block)] : starts[id(block)] + block.dof] += J
            row += m
        return H @ self._P[touched], H, touched

    def _compact(self, blocks: Sequence[Block], jacobians: Sequence[Array], rows: int, what: str) -> list[Array]:
        if len(blocks) != len(jacobians):
            raise SlamlibError(
                f"{what}: {len(blocks)} blocks but {len(jacobians)} Jacobians; give one Jacobian a block"
            )
        return [
            linalg.finite(J, (rows, b.dof), what, f"Jacobian {i} (by {b!r})")
            for i, (b, J) in enumerate(zip(blocks, jacobians, strict=True))
        ]

    def _own(self, *blocks: Block) -> None:
        for block in blocks:
            if not any(block is b for b in self.blocks):
                raise SlamlibError(f"{block!r} is no block of this belief (was it removed?)")

    def _grow(self, size: int) -> None:
        if size > len(self._store):
            store = np.zeros((max(size, 2 * len(self._store), 32),) * 2)
            store[: self._size, : self._size] = self._P
            self._store = store
        self._size = size

    def _set(self, P: Array) -> None:
        self._size = 0
        self._grow(len(P))
        self._P[...] = P


def _point(space: Space, mean: Array, function: str) -> Array:
    mean = linalg.finite(mean, (space.size,), function, "mean")
    space.check(mean, f"{function}: mean")
    return _frozen(mean)


def _frozen(array: Array) -> Array:
    array = np.array(array, dtype=float)
    array.flags.writeable = False
    return array
