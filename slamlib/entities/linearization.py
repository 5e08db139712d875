"""Linearization points: where Jacobians are taken. The innovation is always computed at the present means."""

from collections.abc import Iterable
from typing import Protocol
from weakref import WeakKeyDictionary

import numpy as np

from slamlib.entities.generator import generator
from slamlib.kalman.state import Block
from slamlib.manifolds import Array
from slamlib.motions import Motion


class HasMotion(Protocol):
    """A robot, as far as its motion is concerned."""

    motion: Motion
    block: Block


class Linearization:
    """The linearization point of each block: here the present mean, where an ordinary EKF gains false information.

    A subclass, assigned to `Slam.linearization`, has others.
    """

    def at(self, block: Block) -> Array:
        """The linearization point of a block: a mean (size,)."""
        return block.mean

    def added(self, blocks: Iterable[Block], means: Iterable[Array]) -> None:
        """Called for the blocks that are there, and for each new one; a subclass may note their first means here."""

    def predicted(self, block: Block) -> None:
        """Called after the motion has moved a robot's block; a subclass may choose the new linearization point here."""

    def motion(self, robot: HasMotion, state: Array, control: Array, dt: float) -> tuple[Array, Array]:
        """Jacobians of the motion to `state` with respect to the robot's state and the control."""
        J = robot.motion.step.jac(self.at(robot.block), control, dt)[1]
        return J.state, J.control


class FirstEstimates(Linearization):
    """Each block's first estimate: landmarks where they were initialized, robots where they were predicted.

    With N always at one point, no information is gained along it: H N = 0, and F N(before) = N(after), which `motion`
    enforces. Huang, Mourikis and Roumeliotis (2008).
    """

    def __init__(self) -> None:
        self.first: WeakKeyDictionary[Block, Array] = WeakKeyDictionary()

    def at(self, block: Block) -> Array:
        """The block's first estimate in its present parametrization."""
        if len(self.first[block]) != len(block.mean):
            self.first[block] = block.mean  # the first one after a conversion
        return self.first[block]

    def added(self, blocks: Iterable[Block], means: Iterable[Array]) -> None:
        """New blocks have their first estimates now."""
        self.first.update(zip(blocks, means, strict=True))

    def predicted(self, block: Block) -> None:
        """A robot's prediction is its first estimate at this time."""
        self.first[block] = block.mean

    def motion(self, robot: HasMotion, state: Array, control: Array, dt: float) -> tuple[Array, Array]:
        """Jacobians of the motion, the first one changed so that it takes N of one first estimate to N of the next."""
        (F, G), k = super().motion(robot, state, control, dt), robot.motion.pose_dof
        before, after = (generator(robot.motion, x) @ robot.motion.free for x in (self.at(robot.block), state))
        F = F.copy()
        F[:, :k] += (after - F @ before) @ np.linalg.inv(before[:k])
        return F, G
