"""The covariance carried along what no measurement can tell: the motion of the whole world.

A small motion of the world adds N (tau, phi) to the errors of all blocks, and no measurement of landmarks notices:
H N = 0. But N depends on the means, and after an update the next H has another one. So errors that were a motion of the
world are made one of the new means: the covariance is that of the right-invariant error (Barrau and Bonnabel 2017).
"""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import compose
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import landmark_means, state_rows
from slamlib.slam.entities import POSE, MountedSensor
from slamlib.slam.measurement_update import KIND, Projection, group_by_kind, unprojected

NO_MOTION = np.array([0.0, 0, 0, 1, 0, 0, 0])


def check_moved(kind: Any) -> None:
    """Raise SlamlibError for a parametrization, or a motion, without the model moved(motion, state)."""
    if getattr(kind, "moved", None) is None:
        raise SlamlibError(
            f"the error that this filter keeps needs the model moved(motion, state) of {kind.name}, which has none: "
            "write it, or use the option error='local'"
        )


def check(slam: Any) -> None:
    """Check, before a run, all motions, and the parametrizations of new landmarks. Raises SlamlibError."""
    if slam.options.error != "local":
        kinds = [family.new_kind(slam.options) for family in slam.families.values()]
        for kind in (*(robot.motion for robot in slam.robots), *filter(None, kinds)):
            check_moved(kind)


def generator(kind: Any, states: Array) -> Array:
    """N (..., dof, 6) of states (..., size) of a parametrization or a motion. Raises SlamlibError."""
    check_moved(kind)
    return np.asarray(kind.moved.jac(NO_MOTION, states)[1][0])


def generators(slam: Any) -> Array:
    """N (size, 6): the change of all blocks' errors by a motion (tau [m], phi [rad]) of the world."""
    N = np.zeros((slam.belief.size, 6))
    for robot in slam.robots:
        N[robot.block.slice] = generator(robot.motion, robot.block.mean)
    for group in group_by_kind(slam.landmarks, KIND):
        N[state_rows(group)] = generator(group[0].kind, landmark_means(group))
    return N


def trade(size: int, sensor: MountedSensor, extrinsics: Block) -> Array:
    """N (size, 6) of the motions of robot and extrinsics against each other, which leave the sensor where it is."""
    N = np.zeros((size, 6))
    N[sensor.robot.block.start + np.arange(POSE)] = compose.jac(sensor.robot.pose, NO_MOTION)[1].inner
    N[extrinsics.slice] = -compose.jac(NO_MOTION, extrinsics.mean)[1].outer
    return N


def unobservable(slam: Any, sensor: MountedSensor) -> Array:
    """What this sensor's measurements cannot tell (size, 6), or (size, 12) where its extrinsics are estimated."""
    N, extrinsics = generators(slam), sensor.block
    return N if extrinsics is None else np.concatenate([N, trade(len(N), sensor, extrinsics)], axis=1)


@contextmanager
def carried(slam: Any, sensor: MountedSensor) -> Iterator[Projection]:
    """Within the block the means are updated; at its end the covariance follows: T P T', T N(before) = N(after).

    T = I + (N(after) - N(before)) L, where L reads the motion of the world from the errors of the sensor's robot and
    extrinsics. Until then a Jacobian H at other means becomes H T = H (I - N(before) L), as H N(after) = 0.
    """
    rows: Indices = sensor.columns
    before = unobservable(slam, sensor)
    motion = np.linalg.inv(before[rows])

    def project(columns: Indices, H: Array) -> Array:
        H = H.copy()
        H[:, : len(rows)] -= H @ before[columns] @ motion
        return H

    yield project
    change = unobservable(slam, sensor) - before
    if change.any():
        slam.belief.transport(rows, change @ motion)


def kept(slam: Any, sensor: MountedSensor) -> AbstractContextManager[Projection]:
    """The covariance stays as the update leaves it."""
    return nullcontext(unprojected)


# What happens to the covariance around an update, by the error whose covariance it is.
TRANSPORTS: dict[str, Callable[[Any, MountedSensor], AbstractContextManager[Projection]]] = {
    "local": kept,
    "first-estimates": kept,
    "world": carried,
}
