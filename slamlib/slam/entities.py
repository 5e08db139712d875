"""Robots, sensors and landmarks as the filter holds them: handles to blocks of the belief, and what is kept beside."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slamlib.geometry.pose import compose
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.motions import Motion
from slamlib.sensors.sensor import Calibration

POSE = 6  # degrees of freedom of a pose, the first of every robot's state


class Linearization:
    """The point of linearization of each block: at which mean Jacobians by it are taken. Here at the present mean.

    The innovation is always computed at the present means. An ordinary EKF takes its Jacobians there too, and so they
    are taken at ever other estimates. What learns nothing that cannot be learned, such as an EKF with first-estimates
    Jacobians (Huang, Mourikis and Roumeliotis 2008), takes those of one block always at one point: it is a subclass,
    and is assigned to `Slam.linearization`.
    """

    def at(self, block: Block) -> Array:
        """The mean (size,) of a block at which Jacobians by it are taken."""
        return block.mean

    def predicted(self, block: Block) -> None:
        """A robot's block has been moved by its motion; later Jacobians may be taken where it is now."""


@dataclass(eq=False)
class Robot:
    """A robot in the map; its state begins with its pose. noise: of a step without a control."""

    name: str
    motion: Motion
    block: Block
    noise: Array

    @property
    def pose(self) -> Array:
        """Pose (7,) in the world."""
        return self.block.mean[:7]


@dataclass(eq=False)
class MountedSensor:
    """A sensor on a robot: its mount is given, or a block of the map that is estimated.

    linearization: where Jacobians of its measurements are taken; None: at the present means.
    """

    name: str
    robot: Robot
    calibration: Calibration
    given: Array
    block: Block | None = None
    linearization: Linearization | None = None

    @property
    def extrinsics(self) -> Array:
        """Pose (7,) in the robot's frame."""
        return self.given if self.block is None else self.block.mean

    @property
    def camera(self) -> Array:
        """Pose (7,) in the world, as it is estimated now."""
        return compose(self.robot.pose, self.extrinsics)

    @property
    def columns(self) -> Indices:
        """Rows of the joint covariance of the robot's pose, and of the mount if it is estimated."""
        starts = [self.robot.block.start] + ([] if self.block is None else [self.block.start])
        return (np.array(starts)[:, None] + np.arange(POSE)).ravel()

    @property
    def blocks(self) -> list[Block]:
        """The blocks of the map that it depends on."""
        return [self.robot.block] + ([] if self.block is None else [self.block])


@dataclass(eq=False)
class Landmark:
    """A landmark in the map: its parametrization, its block, its history; of a line the abscissas of its two ends.

    searched, matched, inliers: how often it was looked for, found, and believed. sensor: the number of the one that
    began it; signature: what that one's front end keeps of its looks. last_seen: the frame in which it was believed
    last, first_seen: the one in which it was begun.
    """

    id: int
    kind: Any
    block: Block
    first_seen: int
    searched: int = 1
    matched: int = 1
    inliers: int = 1
    abscissas: Array | None = None
    sensor: int = 0
    signature: Any = field(default=None, repr=False)
    last_seen: int = 0

    def __post_init__(self) -> None:
        self.last_seen = max(self.last_seen, self.first_seen)
