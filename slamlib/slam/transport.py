"""The covariance carried along what no measurement can tell: the motion of the whole world.

A small motion of the world adds N (tau, phi) to the errors of all blocks, and no measurement of landmarks notices:
H N = 0. But N depends on the means, and after an update the next H has another one. So errors that were a motion of the
world are made one of the new means: the covariance is that of the right-invariant error (Barrau and Bonnabel 2017).
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext

import numpy as np

from slamlib.entities import RigSensor, Robot, State
from slamlib.entities.unobservable import Movable, check_moved, generator
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.linalg import Carry
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.slam.measurement_update import Projection, unprojected


def check(robots: Iterable[Robot], kinds: Iterable[Movable], error: str) -> None:
    """Check, before they are used, all motions, and the parametrizations of new landmarks. Raises SlamlibError."""
    if error != "local":
        for kind in (*(robot.motion for robot in robots), *kinds):
            check_moved(kind)


def generators(state: State) -> Array:
    """N (size, f): the change of all blocks' errors by a motion (tau [m], phi [rad]) of the world.

    As many as all robots can make with it: six, or three where one of them is in the plane.
    """
    N = np.zeros((state.belief.size, 6))
    for robot in state.robots:
        N[robot.block.slice] = generator(robot.motion, robot.block.mean)
    layout = state.layout
    for group in state.kinds():
        N[group.rows] = generator(group.landmarks[0].kind, group.means(layout))
    return N @ min((robot.motion.free for robot in state.robots), key=lambda free: free.shape[1])


def trade(size: int, sensor: RigSensor, extrinsics: Block) -> Array:
    """N (size, f) of the motions of robot and extrinsics against each other, which leave the sensor where it is.

    As many as the robot is free to make: six, or three in the plane.
    """
    robot, free = sensor.robot, sensor.robot.motion.free
    N, by_pose = np.zeros((size, free.shape[1])), robot.motion.at(robot.pose, np.zeros(6))[1]
    N[robot.columns] = by_pose[: len(robot.columns), :6] @ compose.jac(robot.pose, ORIGIN)[1].inner @ free
    N[extrinsics.slice] = -compose.jac(ORIGIN, extrinsics.mean)[1].outer @ free
    return N


def left_inverse(N: Array) -> Array:
    """L (r, n) with L N = I, for N (n, r) of rank r: the inverse where it has as many rows."""
    invert = np.linalg.inv if N.shape[0] == N.shape[1] else np.linalg.pinv
    return np.asarray(invert(N), dtype=float)


def unobservable(state: State, sensor: RigSensor) -> Array:
    """What this sensor's measurements cannot tell (size, f); more columns where its extrinsics are estimated."""
    N, extrinsics = generators(state), sensor.block
    return N if extrinsics is None else np.concatenate([N, trade(len(N), sensor, extrinsics)], axis=1)


@contextmanager
def carried(state: State, sensor: RigSensor) -> Iterator[Projection]:
    """Within the block one update moves the means, and the covariance follows them: T P T', T N(before) = N(after).

    T = I + (N(after) - N(before)) L, where L reads the motion of the world from the errors of the sensor's robot and
    extrinsics. Until then a Jacobian H at other means becomes H T = H (I - N(before) L), as H N(after) = 0.
    """
    rows: Indices = sensor.columns
    before = unobservable(state, sensor)
    motion = left_inverse(before[rows])

    def project(columns: Indices, H: Array) -> Array:
        H = H.copy()
        H[:, : len(rows)] -= H @ before[columns] @ motion
        return H

    def carry() -> Carry | None:
        change = unobservable(state, sensor) - before
        moved = change.any(axis=0)  # a translation of the world adds the same to a point or a pose anywhere
        return (rows, change[:, moved], np.asarray(motion[moved], float)) if moved.any() else None

    state.belief.transport = carry
    try:
        yield project
    finally:
        state.belief.transport = None


def kept(state: State, sensor: RigSensor) -> AbstractContextManager[Projection]:
    """The covariance stays as the update leaves it."""
    return nullcontext(unprojected)


# What happens to the covariance around an update, by the error whose covariance it is.
TRANSPORTS: dict[str, Callable[[State, RigSensor], AbstractContextManager[Projection]]] = {
    "local": kept,
    "first-estimates": kept,
    "world": carried,
}
