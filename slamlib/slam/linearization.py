"""At which means Jacobians are taken: the point of linearization of each block, a seam of the filter.

The innovation is always computed at the present means. An ordinary EKF takes its Jacobians there too, and so they are
taken at ever other estimates. What learns nothing that cannot be learned, such as an EKF with first-estimates
Jacobians (Huang, Mourikis and Roumeliotis 2008), takes those of one block always at one point: it is a subclass.
"""

from slamlib.kalman.state import Block
from slamlib.manifolds import Array


class Linearization:
    """The present means. A subclass says at which others, and is assigned to `Slam.linearization`."""

    def at(self, block: Block) -> Array:
        """The mean (size,) of a block at which Jacobians by it are taken."""
        return block.mean

    def predicted(self, block: Block) -> None:
        """A robot's block has been moved by its motion; later Jacobians may be taken where it is now."""
