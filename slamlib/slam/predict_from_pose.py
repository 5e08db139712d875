"""What the filter would expect to see from a pose that it has not moved to yet."""

import copy
from dataclasses import replace
from typing import Any

from slamlib.geometry.pose import compose
from slamlib.manifolds import Array
from slamlib.slam.measurement_update import Look, expect_all


def looks_from(slam: Any, motion: Array, sensor: int = 0) -> list[Look]:
    """Looks of a sensor after its robot has moved by a pose (7,) in its frame, with the covariance of before.
    Nothing of the filter changes.
    """
    mounted = slam.sensors[sensor]
    block = copy.copy(mounted.robot.block)
    pose = compose(mounted.robot.pose, motion)
    block.take(block.space, _with_pose(block.mean, pose))
    there = replace(mounted, robot=replace(mounted.robot, block=block))
    return expect_all(slam.belief, there, slam.families, slam.landmarks)


def _with_pose(state: Array, pose: Array) -> Array:
    moved = state.copy()
    moved[:7] = pose
    return moved
