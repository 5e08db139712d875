"""Blocks of a belief, and what a belief was at one moment."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slamlib import linalg
from slamlib.spaces import Array, Space


class Block:
    """A handle to one part of the belief; its mean is read-only, its covariance is belief.covariance(block)."""

    def __init__(self, space: Space, mean: Array, start: int) -> None:
        self.space, self.start = space, start
        self.mean = mean

    @property
    def dof(self) -> int:
        """Estimated degrees of freedom."""
        return self.space.dof

    @property
    def slice(self) -> slice:
        """Its rows and columns of the joint covariance."""
        return slice(self.start, self.start + self.dof)

    def __repr__(self) -> str:
        return f"<block {self.space!r} at {self.start}>"


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
    return frozen(mean)


def frozen(array: Array) -> Array:
    """A read-only copy."""
    array = np.array(array, dtype=float)
    array.flags.writeable = False
    return array
