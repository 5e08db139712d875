"""The covariance carried along what no measurement can tell: the motion of the whole world.

A small motion of the world adds N (tau, phi) to the errors of all blocks, and no measurement of landmarks notices:
H N = 0. But N depends on the means, and after an update the next H has another one. So errors that were a motion of the
world are made one of the new means: the covariance is that of the right-invariant error (Barrau and Bonnabel 2017).
Where an absolute measurement turns the whole world, the rest of the errors turns with it.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass
from functools import partial

import numpy as np

from slamlib.entities import RigSensor, Robot, State
from slamlib.entities.unobservable import Movable, check_moved, generator
from slamlib.geometry.pose import ORIGIN, compose, exponential
from slamlib.kalman.linalg import Carry, Following, left_inverse
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.slam.anchors import AnchoredRows, anchored_rows
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
    for group in state.kinds():
        N[group.together] = generator(group.kind, group.means()).reshape(-1, 6)
    free = directions(state)
    return N if free.shape[1] == 6 else N @ free  # all six are the six themselves


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
    N[extrinsics.slice] = -compose.jac(ORIGIN, extrinsics.mean)[1].outer @ free
    return N


def unobservable(state: State, sensor: RigSensor) -> Array:
    """What this sensor's measurements cannot tell (size, f); more columns where its extrinsics are estimated."""
    N, extrinsics = generators(state), sensor.block
    return N if extrinsics is None else np.concatenate([N, trade(len(N), sensor, extrinsics)], axis=1)


Anchored = Callable[[State], list[AnchoredRows]]  # the landmarks whose anchors the covariance follows, too


def no_anchors(state: State) -> list[AnchoredRows]:
    """The covariance follows the world alone."""
    return []


@contextmanager
def carried(state: State, sensor: RigSensor, anchored: Anchored = no_anchors) -> Iterator[Projection]:
    """Within the block one update moves the means, and the covariance follows them: T P T', T N(before) = N(after).

    T = I + (N(after) - N(before)) L, where L reads the motion of the world from the errors of the sensor's robot and
    extrinsics. Until then a Jacobian H at other means becomes H T = H (I - N(before) L), as H N(after) = 0.

    anchored: N has columns of these landmarks' anchors, too, S = (I, F) of each. L reads their shift off their own
    rows, less what the world's motion makes of them, N_a: so S adds (F(after) - F(before)) (I - N_a L) to the rest of
    the landmark, and H (I - N L) loses H S (I - N_a L) as well, of the landmark that H measures.
    """
    rows = sensor.columns
    before = unobservable(state, sensor)
    motion, own = left_inverse(before[rows]), anchored(state)
    anchors = {int(anchor[0]): F for each in own for anchor, F in zip(each.anchors, each.F, strict=True)}

    def project(columns: Indices, H: Array) -> Array:
        H, first, by_world = H.copy(), len(rows), H @ before[columns]
        F = anchors.get(int(columns[first]))
        if F is not None:
            end = first + F.shape[1]
            by_shift = H[:, first:end] + H[:, end:] @ F
            H[:, first:end] -= by_shift
            by_world -= by_shift @ before[columns[first:end]]
        H[:, :first] -= by_world @ motion
        return H

    with _followed(state, partial(unobservable, state, sensor), before, rows, motion, anchored, own):
        yield project


@contextmanager
def told(state: State, robot: Robot, anchored: Anchored = no_anchors) -> Iterator[None]:
    """As `carried`, for one update by anything but a sensor's landmarks: GPS, a compass, a meeting, a known beacon.

    Such a measurement may tell where the world lies (H N is not 0). So its step holds a motion m = L step of the world,
    which all means make together, as one rigid motion exp(m) of any size; each block adds only what is left of the
    step, step - N m. L reads m from the errors of this robot. Chapter observability, eq. (ob-screw).

    What is no motion of the world in the errors turns with it: N(before) d + r becomes N(after) d + M r, M the Jacobian
    of each moved block by what it was. Eq. (ob-rest).
    """
    N, rows, free = generators(state), robot.columns, directions(state)
    L, turned = left_inverse(N[rows]), list[Following]()
    movable: list[tuple[Movable, Indices, list[Block]]] = [  # extrinsics are in no world
        *((own.motion, np.arange(N.shape[0])[None, own.block.slice], [own.block]) for own in state.robots),
        *((group.kind, group.rows, [landmark.block for landmark in group.landmarks]) for group in state.kinds()),
    ]

    def retract(blocks: Sequence[Block], step: Array) -> list[Array]:
        m = L @ step[rows]
        motion, left = exponential(free @ m), step - N @ m
        means = {block: block.manifold.plus(block.mean, left[block.slice]) for block in blocks}
        turned.clear()
        for kind, at, own in movable:
            there, J = check_moved(kind).jac(motion, np.array([means[block] for block in own]))
            means.update(zip(own, there, strict=True))
            turned.append((at, at, J[1] - np.eye(at.shape[1])))
        return list(means.values())

    belief = state.belief
    usual, belief.retraction = belief.retraction, retract
    try:
        with _followed(state, partial(generators, state), N, rows, L, anchored, anchored(state), turned):
            yield
    finally:
        belief.retraction = usual


@contextmanager
def _followed(
    state: State,
    unobservable_now: Callable[[], Array],
    before: Array,
    rows: Indices,
    motion: Array,
    anchored: Anchored,
    own: list[AnchoredRows],
    turned: Sequence[Following] = (),
) -> Iterator[None]:
    """Within the block an update of the covariance ends with T P T', T = (I + C L) (I + D) M.

    C = N(after) - N(before) - D N(before), and D, of the anchored landmarks, own before and the same after, takes
    each anchor's shift to the rest of its landmark: so T N(before) = N(after), and T S(before) = S(after).

    turned: where the update turned the world, M = I + this, block by block, comes first; all that was before is then
    taken of M's errors: M N(before) for N(before), L (M N(before)) = I, and (I, F) that spans M S(before).
    """
    belief = state.belief

    def carry() -> Carry | None:
        then, read, anchors = before, motion, own
        if turned:
            then, anchors = before.copy(), [each.turned(turned) for each in own]
            for at, _, G in turned:
                then[at] += G @ before[at]
            read = left_inverse(then[rows])
        change = unobservable_now() - then
        following = [after.following(each) for after, each in zip(anchored(state), anchors, strict=True)]
        for at, rest, F in following:
            change[rest] -= F @ then[at]
        # A translation of the world adds the same to a point or a pose anywhere: such columns do not change.
        moved = np.ones(len(change)) @ np.abs(change) > 0  # quicker than change.any(axis=0)
        if not moved.any() and not following:
            return None
        return Carry(rows, change[:, moved], np.asarray(read[moved], float), [*turned, *following])

    belief.transport = carry
    try:
        yield
    finally:
        belief.transport = None


def kept(state: State, source: RigSensor | Robot) -> AbstractContextManager[Projection]:
    """The covariance stays as the update leaves it."""
    return nullcontext(unprojected)


@dataclass(frozen=True)
class Transport:
    """What happens to the covariance around an update.

    by_sensor: by what a sensor measures of landmarks. by_robot: by anything else; the robot is the one whose errors say
    what motion of the world there is in the state's.
    """

    by_sensor: Callable[[State, RigSensor], AbstractContextManager[Projection]] = kept
    by_robot: Callable[[State, Robot], AbstractContextManager[object]] = kept

    @property
    def carries(self) -> bool:
        """Whether the covariance follows the means."""
        return self.by_sensor is not kept


# By the error whose covariance the filter keeps.
TRANSPORTS = {
    "local": Transport(),
    "first-estimates": Transport(),
    "world": Transport(carried, told),
    "anchors": Transport(partial(carried, anchored=anchored_rows), partial(told, anchored=anchored_rows)),
}
