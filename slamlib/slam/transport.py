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
from slamlib.entities.generator import Movable, check_moved
from slamlib.geometry.pose import exponential
from slamlib.kalman.linalg import Carry, Following, left_inverse
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.slam.anchors import AnchoredRows, anchored_rows
from slamlib.slam.measurement_update import Projection, unprojected
from slamlib.slam.unobservable import Unobservable, directions


def check(robots: Iterable[Robot], kinds: Iterable[Movable], error: str) -> None:
    """Check, before they are used, all motions, and the parametrizations of new landmarks. Raises SlamlibError."""
    if error != "local":
        for kind in (*(robot.motion for robot in robots), *kinds):
            check_moved(kind)


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
    rows, before = sensor.columns, Unobservable(state, sensor)
    motion, own = left_inverse(before.of_robots(rows)), anchored(state)
    anchors = {int(anchor[0]): F for each in own for anchor, F in zip(each.anchors, each.F, strict=True)}

    def project(columns: Indices, H: Array) -> Array:
        H, first, by_world = H.copy(), len(rows), H @ before.N[columns]
        F = anchors.get(int(columns[first]))
        if F is not None:
            end = first + F.shape[1]
            by_shift = H[:, first:end] + H[:, end:] @ F
            H[:, first:end] -= by_shift
            by_world -= by_shift @ before.N[columns[first:end]]
        H[:, :first] -= by_world @ motion
        return H

    belief = state.belief
    belief.transport = partial(_carry, state, before, rows, motion, anchored, own)
    try:
        yield project
    finally:
        belief.transport = None


@contextmanager
def told(state: State, robot: Robot, anchored: Anchored = no_anchors) -> Iterator[None]:
    """As `carried`, for one update by anything but a sensor's landmarks: GPS, a compass, a meeting, a known beacon.

    Such a measurement may tell where the world lies (H N is not 0). So its step holds a motion m = L step of the world,
    which all means make together, as one rigid motion exp(m) of any size; each block adds only what is left of the
    step, step - N m. L reads m from the errors of this robot. Chapter observability, eq. (ob-screw).

    What is no motion of the world in the errors turns with it: N(before) d + r becomes N(after) d + M r, M the Jacobian
    of each moved block by what it was. Eq. (ob-rest).
    """
    before, rows, free = Unobservable(state), robot.columns, directions(state)
    N, turned = before.N, list[Following]()
    L = left_inverse(N[rows])
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
    belief.transport = partial(_carry, state, before, rows, L, anchored, anchored(state), turned)
    try:
        yield
    finally:
        belief.retraction, belief.transport = usual, None


def _carry(
    state: State,
    before: Unobservable,
    rows: Indices,
    motion: Array,
    anchored: Anchored,
    own: list[AnchoredRows],
    turned: Sequence[Following] = (),
) -> Carry | None:
    """How the covariance follows the means of now: T P T', T = (I + C L) (I + D) M. None where N never changes.

    C = N(after) - N(before) - D N(before), and D, of the anchored landmarks, own before and the same after, takes
    each anchor's shift to the rest of its landmark: so T N(before) = N(after), and T S(before) = S(after).

    turned: where the update turned the world, M = I + this, block by block, comes first; all that was before is then
    taken of M's errors: M N(before) for N(before), L (M N(before)) = I, and (I, F) that spans M S(before).
    """
    change, read, anchors = before.change(), motion, own
    if turned:
        then, anchors = before.N.copy(), [each.turned(turned) for each in own]
        for at, _, G in turned:
            then[at] += G @ before.N[at]
        change, read = change + (before.N - then), left_inverse(then[rows])
    following = [after.following(each) for after, each in zip(anchored(state), anchors, strict=True)]
    for at, rest, F in following:
        change[rest] -= F @ (then if turned else before.N)[at]
    if not turned and not following:
        changing = before.changing()
        if not len(changing):
            return None
        change, read = change.take(changing, axis=1), read.take(changing, axis=0)
    return Carry(rows, change, read, [*turned, *following])


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
