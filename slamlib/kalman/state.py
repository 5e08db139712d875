"""Blocks of a belief, the layout of its means, and snapshots."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from slamlib.manifolds import Array, Euclidean, Indices, Manifold, finite, ranges, read_only, read_only_copy


class Block:
    """A handle to one part of the belief; its mean is read-only, its covariance is belief.covariance(block)."""

    def __init__(self, manifold: Manifold, mean: Array, start: int) -> None:
        self.start = start
        self.set_mean(manifold, mean)

    def set_mean(self, manifold: Manifold, mean: Array) -> None:
        """Make it a point of another manifold; dof: its estimated degrees of freedom."""
        self.manifold, self.dof = manifold, manifold.dof
        self.layout: StateLayout | None
        self._own, self.layout, self.slice_in_flat = mean, None, slice(0)

    def bind(self, layout: "StateLayout", rows: slice) -> None:
        """Make the mean a view of these rows of the layout's numbers, which changes with them."""
        self.layout, self.slice_in_flat = layout, rows

    @property
    def mean(self) -> Array:
        """The present mean (size,): an array that never changes; the next mean is a new array."""
        return self._own if self.layout is None else self.layout.flat[self.slice_in_flat]

    @mean.setter
    def mean(self, mean: Array) -> None:
        if self.layout is None:
            self._own = mean
        else:
            flat = self.layout.flat.copy()
            flat[self.slice_in_flat] = mean
            self.layout.flat = read_only(flat)

    @property
    def slice(self) -> slice:
        """Its rows and columns of the joint covariance."""
        return slice(self.start, self.start + self.dof)

    def __repr__(self) -> str:
        return f"<block {self.manifold!r} at {self.start}>"


# How a step (size of the covariance,) moves all means together: from the blocks and the step to each block's new mean.
Retraction = Callable[[Sequence[Block], Array], Sequence[Array]]


class StateLayout:
    """How blocks lie among the rows of the covariance: vectors, moved by one sum, and points of manifolds.

    flat: the vectors' means in one read-only array, one after the other; rows: of the covariance, of these numbers.
    """

    def __init__(self, blocks: Iterable[Block]) -> None:
        self.blocks = blocks = list(blocks)
        are_vectors = [type(block.manifold) is Euclidean for block in blocks]
        vectors = [block for block, is_vector in zip(blocks, are_vectors, strict=True) if is_vector]
        self.points = [block for block, is_vector in zip(blocks, are_vectors, strict=True) if not is_vector]
        dofs = np.array([block.dof for block in blocks], dtype=int)
        self.rows = np.flatnonzero(np.repeat(np.array(are_vectors, dtype=bool), dofs))
        self.flat = read_only(np.concatenate([np.zeros(0), *(block.mean for block in vectors)]))
        for block, rows in zip(vectors, ranges(v.dof for v in vectors), strict=True):
            block.bind(self, rows)

    def append(self, block: Block) -> None:
        """Add a block whose rows follow all others': these stay as they are, which is quicker than a new layout."""
        self.blocks.append(block)
        if type(block.manifold) is not Euclidean:
            self.points.append(block)
            return
        before = len(self.flat)
        self.rows = np.concatenate([self.rows, np.arange(block.start, block.start + block.dof)])
        self.flat = read_only(np.concatenate([self.flat, block.mean]))
        block.bind(self, slice(before, len(self.flat)))

    def retract(self, step: Array, retraction: Retraction | None = None) -> tuple[Array, list[Array]]:
        """Return the vectors' means and each point's after a step (size of the covariance,); nothing is changed yet.

        retraction: None moves each block by its own plus.
        """
        if retraction is not None:
            means = dict(zip(self.blocks, retraction(self.blocks, step), strict=True))
            vectors = [np.asarray(mean) for block, mean in means.items() if block.layout is self]
            flat = np.concatenate([np.zeros(0), *vectors])
            return read_only(flat), [read_only_copy(means[block]) for block in self.points]
        points = [read_only_copy(block.manifold.plus(block.mean, step[block.slice])) for block in self.points]
        return read_only(self.flat + step.take(self.rows)), points

    def assign(self, flat: Array, points: Iterable[Array]) -> None:
        """Set the means to the result of `retract`."""
        self.flat = flat
        for block, mean in zip(self.points, points, strict=True):
            block.mean = mean


def stacked_means(blocks: Sequence[Block]) -> Array:
    """Means (n, size) of blocks of one manifold; fast for vectors that lie in one belief."""
    layouts = {block.layout for block in blocks}
    layout = layouts.pop()
    if layouts or layout is None:
        return np.array([block.mean for block in blocks])
    return layout.flat.take(places(blocks))


def places(blocks: Sequence[Block]) -> Indices:
    """Where the means (n, dof) of vectors, of one size, lie among their layout's numbers."""
    starts: Indices = np.array([block.slice_in_flat.start for block in blocks])
    return starts[:, None] + np.arange(blocks[0].dof)


@dataclass(frozen=True, eq=False)
class BeliefSnapshot:
    """Means and covariance at one moment, as read-only copies; Belief.restore returns to it."""

    means: tuple[Array, ...]
    slices: tuple[slice, ...]
    covariance: Array
    manifolds: tuple[Manifold, ...] = field(repr=False)
    blocks: tuple[Block, ...] = field(repr=False)
    belief: object = field(repr=False)  # compared by identity alone


def checked_mean(manifold: Manifold, mean: ArrayLike, function: str) -> Array:
    """Return a read-only copy of a mean, checked to be a point of its manifold."""
    point = finite(mean, (manifold.size,), function, "mean")
    manifold.check(point, f"{function}: mean")
    return read_only_copy(point)
