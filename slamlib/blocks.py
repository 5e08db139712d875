"""Blocks of a belief, and what a belief was at one moment."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from slamlib import linalg
from slamlib.spaces import Array, Euclidean, Space


class Block:
    """A handle to one part of the belief; its mean is read-only, its covariance is belief.covariance(block)."""

    def __init__(self, space: Space, mean: Array, start: int) -> None:
        self.start = start
        self.take(space, mean)

    def take(self, space: Space, mean: Array) -> None:
        """Become a point of another space; dof are its estimated degrees of freedom."""
        self.space, self.mean, self.dof = space, mean, space.dof

    @property
    def slice(self) -> slice:
        """Its rows and columns of the joint covariance."""
        return slice(self.start, self.start + self.dof)

    def __repr__(self) -> str:
        return f"<block {self.space!r} at {self.start}>"


class Layout:
    """How blocks lie among the rows of the covariance: vectors, which are moved in one sum, and points of manifolds.

    rows: of the vectors' numbers, one block after the other; places: of each vector among these.
    """

    def __init__(self, blocks: Iterable[Block]) -> None:
        blocks = list(blocks)
        are_vectors = [type(block.space) is Euclidean for block in blocks]
        self.vectors = [block for block, is_vector in zip(blocks, are_vectors, strict=True) if is_vector]
        self.points = [block for block, is_vector in zip(blocks, are_vectors, strict=True) if not is_vector]
        dofs = np.array([block.dof for block in blocks], dtype=int)
        self.rows = np.flatnonzero(np.repeat(np.array(are_vectors, dtype=bool), dofs))
        self.places = [slice(*pair) for pair in pairwise(accumulate((v.dof for v in self.vectors), initial=0))]

    def flat(self) -> Array:
        """The vectors' means as one array of its own."""
        return np.concatenate([np.zeros(0), *(block.mean for block in self.vectors)])

    def share(self, flat: Array) -> None:
        """Let the vectors' means be read-only views of one array: they change with it."""
        view = flat.view()
        view.flags.writeable = False
        for block, place in zip(self.vectors, self.places, strict=True):
            block.mean = view[place]


@dataclass(frozen=True, eq=False)
class BeliefSnapshot:
    """Means and covariance at one moment, as read-only arrays of their own; Belief.restore goes back to it."""

    means: tuple[Array, ...]
    slices: tuple[slice, ...]
    covariance: Array
    spaces: tuple[Space, ...] = field(repr=False)
    blocks: tuple[Block, ...] = field(repr=False)
    belief: Any = field(repr=False)


def point_of(space: Space, mean: Array, function: str) -> Array:
    """A read-only copy of a mean that is checked to be a point of its space."""
    mean = linalg.finite(mean, (space.size,), function, "mean")
    space.check(mean, f"{function}: mean")
    return linalg.frozen(mean)
