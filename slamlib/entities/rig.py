"""Robots and sensors of the filter: handles to blocks of the belief, and the data kept with them."""

from dataclasses import dataclass

import numpy as np

from slamlib.entities.linearization import Linearization
from slamlib.geometry.pose import compose
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.motions import Motion
from slamlib.sensors.sensor import Calibration


@dataclass(eq=False)
class Robot:
    """A robot in the map; its motion says what pose follows from its state.

    noise: covariance of the process noise without a control.
    """

    name: str
    motion: Motion
    block: Block
    noise: Array

    @property
    def pose(self) -> Array:
        """Pose (7,) in the world."""
        return self.motion.pose(self.block.mean)

    @property
    def columns(self) -> Indices:
        """Rows of the joint covariance on which the pose depends."""
        return self.block.start + np.arange(self.motion.pose_dof)


@dataclass(eq=False)
class RigSensor:
    """A sensor on a robot; its extrinsics are given, or a block of the map that is estimated.

    linearization: the linearization points of its measurements; None: the present means. landmark: the parametrization
    of the landmarks that it initializes; None: what the filter's options say.
    """

    name: str
    robot: Robot
    calibration: Calibration
    given_extrinsics: Array
    block: Block | None = None
    linearization: Linearization | None = None
    landmark: str | None = None

    @property
    def extrinsics(self) -> Array:
        """Pose (7,) of the sensor in the robot's frame."""
        return self.given_extrinsics if self.block is None else self.block.mean

    @property
    def camera(self) -> Array:
        """Estimated pose (7,) of the sensor in the world."""
        return compose(self.robot.pose, self.extrinsics)

    @property
    def columns(self) -> Indices:
        """Rows of the joint covariance of the robot's pose, and of the extrinsics if they are estimated."""
        robot, own = self.robot.columns, self.block
        return robot if own is None else np.concatenate([robot, own.start + np.arange(own.dof)])

    @property
    def blocks(self) -> list[Block]:
        """The blocks of the map on which its measurements depend: robot, and extrinsics if they are estimated."""
        return [self.robot.block] + ([] if self.block is None else [self.block])
