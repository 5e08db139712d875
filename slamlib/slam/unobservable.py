"""N of a whole state: the changes of all errors that no measurement of landmarks tells, and how N follows the means."""

from functools import cached_property

import numpy as np

from slamlib.entities import RigSensor, State
from slamlib.entities.generator import change_of_generator, changing_columns, check_moved, generator
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices


def generators(state: State) -> Array:
    """N (size, f): the change of all blocks' errors by a motion (tau [m], phi [rad]) of the world.

    As many as all robots can make with it: six, or three where one of them is in the plane.
    """
    return Unobservable(state).N


def directions(state: State) -> Array:
    """Basis (6, f) of the motions of the world that all robots can make with it."""
    return min((robot.motion.free for robot in state.robots), key=np.size)


def trade(size: int, sensor: RigSensor, extrinsics: Block) -> Array:
    """N (size, f) of the motions of robot and extrinsics against each other, which leave the sensor where it is.

    As many as the robot is free to make: six, or three in the plane.
    """
    robot, free = sensor.robot, sensor.robot.motion.free
    N, by_pose = np.zeros((size, free.shape[1])), robot.motion.at(robot.pose, np.zeros(6))[1]
    N[robot.columns] = by_pose[: len(robot.columns), :6] @ compose.jac(robot.pose, ORIGIN)[1].inner @ free
    N[extrinsics.slice] = -compose.jac_where(ORIGIN, extrinsics.mean) @ free
    return N


class Unobservable:
    """N (size, f) at the means that a state has when this is made, and how it changes from there.

    sensor: N of what this one's measurements cannot tell; it has more columns where its extrinsics are estimated.
    Raises SlamlibError where the motion of the world is not defined for a type.
    """

    def __init__(self, state: State, sensor: RigSensor | None = None) -> None:
        self._state, self._sensor, self._free = state, sensor, directions(state)
        self._kinds = state.kinds()
        for group in self._kinds:
            check_moved(group.kind)  # here, where nothing has been changed yet
        self._means = [group.means() for group in self._kinds]
        self._robots, self._trade = self._robots_now(), self._trade_now()

    def _robots_now(self) -> list[Array]:
        return [generator(robot.motion, robot.block.mean) for robot in self._state.robots]

    def _trade_now(self) -> Array | None:
        if self._sensor is None or self._sensor.block is None:
            return None
        return trade(self._state.belief.size, self._sensor, self._sensor.block)

    @cached_property
    def N(self) -> Array:
        """All rows."""
        groups = [generator(group.kind, means) for group, means in zip(self._kinds, self._means, strict=True)]
        return self._rows(self._robots, groups, self._trade)

    def of_robots(self, rows: Indices) -> Array:
        """These rows (k, f) of N, of robots and extrinsics."""
        return self._rows(self._robots, [], self._trade)[rows]

    def change(self) -> Array:
        """N at the means of now, less N."""
        robots = [now - then for now, then in zip(self._robots_now(), self._robots, strict=True)]
        each = zip(self._kinds, self._means, strict=True)
        groups = [change_of_generator(group.kind, then, group.means()) for group, then in each]
        now, then = self._trade_now(), self._trade
        return self._rows(robots, groups, None if now is None or then is None else now - then)

    def changing(self) -> Indices:
        """The columns of N that can change: a translation of the world adds the same to a point or a pose anywhere."""
        robots = [changing_columns(robot.motion, robot.block.manifold.size) for robot in self._state.robots]
        groups = [changing_columns(group.kind, group.landmarks[0].block.manifold.size) for group in self._kinds]
        world = sorted(frozenset().union(*robots, *groups))
        if self._free.shape[1] < 6:
            world = np.flatnonzero(self._free[world].any(axis=0)).tolist()
        if self._trade is not None:
            world += range(self._free.shape[1], self._free.shape[1] + self._trade.shape[1])
        return np.array(world, dtype=int)

    def _rows(self, robots: list[Array], groups: list[Array], trade: Array | None) -> Array:
        """All rows, of these robots' and groups' six columns: as many as all robots can make, and the trade's."""
        world = np.zeros((self._state.belief.size, 6))
        for robot, own in zip(self._state.robots, robots, strict=True):
            world[robot.block.slice] = own
        for group, own in zip(self._kinds, groups, strict=False):
            world[group.together] = own.reshape(-1, 6)
        if self._free.shape[1] < 6:  # all six are the six themselves
            world = world @ self._free
        return world if trade is None else np.concatenate([world, trade], axis=1)
