"""The covariance carried along what no measurement can tell: the motion of the whole world.

A small motion of the world adds N (tau, phi) to the errors of all blocks, and no measurement of landmarks notices:
H N = 0. But N depends on the means, and after an update the next H has another one. So errors that were a motion of the
world are made one of the new means: the covariance is that of the right-invariant error (Barrau and Bonnabel 2017).
"""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from functools import lru_cache
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.state import Block, places
from slamlib.manifolds import Array, Euclidean, Indices, read_only
from slamlib.observation.family import landmark_means, state_rows
from slamlib.slam.entities import POSE, RigSensor
from slamlib.slam.measurement_update import KIND, Projection, group_by_kind, unprojected


def check_moved(kind: Any) -> None:
    """Raise SlamlibError for a parametrization, or a motion, without the model moved(motion, state)."""
    if getattr(kind, "moved", None) is None:
        raise SlamlibError(
            f"the error that this filter keeps needs the model moved(motion, state) of {kind.name}, which has none: "
            "write it, or use the option error='local'"
        )


def check(slam: Any, options: Any) -> None:
    """Check, before they are used, all motions, and the parametrizations of new landmarks. Raises SlamlibError."""
    if options.error != "local":
        kinds = [family.new_kind(options) for family in slam.families.values()]
        for kind in (*(robot.motion for robot in slam.robots), *filter(None, kinds)):
            check_moved(kind)


def generator(kind: Any, states: Array) -> Array:
    """N (..., dof, 6) of states (..., size) of a parametrization or a motion. Raises SlamlibError."""
    check_moved(kind)
    return _generator(kind.moved, states.tobytes(), states.shape)


@lru_cache(maxsize=32)  # by the numbers themselves: most updates begin with the landmarks that the last one left
def _generator(moved: Any, states: bytes, shape: tuple[int, ...]) -> Array:
    return read_only(moved.jac_where(ORIGIN, np.frombuffer(states).reshape(shape)))


def generators(slam: Any) -> Array:
    """N (size, 6): the change of all blocks' errors by a motion (tau [m], phi [rad]) of the world."""
    N = np.zeros((slam.belief.size, 6))
    for robot in slam.robots:
        N[robot.block.slice] = generator(robot.motion, robot.block.mean)
    layout = slam.landmarks[0].block.layout if slam.landmarks else None
    if layout is None or slam.landmark_groups[0] is not layout:
        groups = [(group, state_rows(group), _places(group)) for group in group_by_kind(slam.landmarks, KIND)]
        slam.landmark_groups = layout, groups
    for group, rows, at in slam.landmark_groups[1]:
        means = landmark_means(group) if layout is None or at is None else layout.flat.take(at)
        N[rows] = generator(group[0].kind, means)
    return N


def _places(group: list[Any]) -> Indices | None:
    """Where the means of landmarks of one kind lie in their layout; None if they are no vectors."""
    return places([landmark.block for landmark in group]) if type(group[0].block.manifold) is Euclidean else None


def trade(size: int, sensor: RigSensor, extrinsics: Block) -> Array:
    """N (size, 6) of the motions of robot and extrinsics against each other, which leave the sensor where it is."""
    N = np.zeros((size, 6))
    N[sensor.robot.block.start + np.arange(POSE)] = compose.jac(sensor.robot.pose, ORIGIN)[1].inner
    N[extrinsics.slice] = -compose.jac(ORIGIN, extrinsics.mean)[1].outer
    return N


def unobservable(slam: Any, sensor: RigSensor) -> Array:
    """What this sensor's measurements cannot tell (size, 6), or (size, 12) where its extrinsics are estimated."""
    N, extrinsics = generators(slam), sensor.block
    return N if extrinsics is None else np.concatenate([N, trade(len(N), sensor, extrinsics)], axis=1)


@contextmanager
def carried(slam: Any, sensor: RigSensor) -> Iterator[Projection]:
    """Within the block one update moves the means, and the covariance follows them: T P T', T N(before) = N(after).

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

    def carry() -> Any:
        change = unobservable(slam, sensor) - before
        moved = change.any(axis=0)  # a translation of the world adds the same to a point or a pose anywhere
        return (rows, change[:, moved], motion[moved]) if moved.any() else None

    slam.belief.transport = carry
    try:
        yield project
    finally:
        slam.belief.transport = None


def kept(slam: Any, sensor: RigSensor) -> AbstractContextManager[Projection]:
    """The covariance stays as the update leaves it."""
    return nullcontext(unprojected)


# What happens to the covariance around an update, by the error whose covariance it is.
TRANSPORTS: dict[str, Callable[[Any, RigSensor], AbstractContextManager[Projection]]] = {
    "local": kept,
    "first-estimates": kept,
    "world": carried,
}
