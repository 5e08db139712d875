"""Submaps: several maps one after another, each in its own frame, later joined and merged. Chapter many.

A map's cost grows with the square of its size, and its linearization errors with its uncertainty of orientation. A
small map in the frame of its own first pose knows that pose exactly. The next one shares no measurement with it:
neighbouring maps are independent, as long as each is in its own frame.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, compose, from_frame
from slamlib.geometry.quaternion import rotation
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Euclidean, Product
from slamlib.motions import Motion
from slamlib.records.inputs import Frame
from slamlib.rigs.setup import ZERO, Rig
from slamlib.slam.data_association.front_end import FrontEnd
from slamlib.slam.filter import Slam
from slamlib.slam.map_management import StepReport
from slamlib.slam.options import Options


@dataclass(frozen=True, eq=False)
class Submap:
    """A finished map: the robot's last state (size,), which is its pose, and points (n, 3) [m], the points' ids (n,).

    In the map's frame. covariance (dof + 3n, dof + 3n): joint, of the state's tangent vector and the points.
    """

    state: Array
    ids: Array
    points: Array
    covariance: Array

    @classmethod
    def of(cls, slam: Slam) -> "Submap":
        """The marginal of a one-robot filter over its pose and its Euclidean points; all else is left out."""
        known = [landmark for landmark in slam.landmarks if landmark.kind.name == "eucPnt"]
        robot = slam.robots[0].block
        starts = np.array([lm.block.start for lm in known], dtype=int)
        rows = np.concatenate([robot.start + np.arange(robot.dof), (starts[:, None] + np.arange(3)).ravel()])
        points = np.array([lm.block.mean for lm in known]).reshape(-1, 3)
        ids = np.array([lm.id for lm in known], dtype=int)
        return cls(robot.mean, ids, points, slam.belief.matrix[np.ix_(rows, rows)])


class Atlas:
    """Submaps joined in the frame of the first: a belief with one block for each, its last state and its points."""

    def __init__(self, motion: Motion) -> None:
        """motion: the robot's, whose state is its pose."""
        self.motion, self.dof, self.belief = motion, motion.manifold.dof, Belief()
        self.blocks: list[Block] = []
        self.ids: list[Array] = []

    @property
    def pose(self) -> Array:
        """The robot's pose (7,) at the end of the last map, where the next one starts."""
        return self.motion.pose(self.state(-1)) if self.blocks else ORIGIN

    def state(self, number: int) -> Array:
        """The robot's state (size,) at the end of one map, in the first map's frame."""
        return self.blocks[number].mean[: self.motion.manifold.size]

    def points(self, number: int) -> Array:
        """Points (n, 3) [m] of one map, in the first map's frame."""
        return self.blocks[number].mean[self.motion.manifold.size :].reshape(-1, 3)

    def covariance(self, number: int = -1) -> Array:
        """Covariance (6, 6) of the robot's pose at the end of one map, by default of `pose`."""
        P = self.belief.covariance(self.blocks[number])[: self.dof, : self.dof]
        return self.motion.in_space(self.state(number), P)[1]

    def join(self, submap: Submap) -> None:
        """Append the map that started where the last one ended: y = base (+) x, and its Jacobians. Eq. (ms-join).

        x is independent of everything in the atlas: its covariance acts as the noise.
        """
        motion, d, (base, _) = self.motion, self.dof, self.motion.at(self.pose, np.zeros(6))
        pose, J = compose.jac(self.pose, motion.pose(submap.state))
        state, by_pose = motion.at(pose, np.zeros(6))
        n, points = len(submap.ids), submap.points
        by_base, by_map = np.zeros((d + 3 * n, d)), np.zeros((d + 3 * n,) * 2)
        by_base[:d] = by_pose[:, :6] @ motion.by_state(J.outer, base)
        by_map[:d, :d] = by_pose[:, :6] @ motion.by_state(J.inner, submap.state)
        if n:
            points, J = from_frame.jac(self.pose, points)
            by_base[d:] = motion.by_state(J.pose, base).reshape(-1, d)
            by_map[d:, d:] = np.kron(np.eye(n), rotation(self.pose[3:]))  # J.point: the same for all points
        given = self.blocks[-1:]
        jacobians = [np.pad(by_base, ((0, 0), (0, block.dof - d))) for block in given]
        own = by_map @ submap.covariance @ by_map.T
        mean = np.concatenate([state, points.ravel()])
        self.blocks.append(self.belief.add(self._manifold(n), mean, own, given=given, jacobians=jacobians))
        self.ids.append(submap.ids)

    def _manifold(self, points: int) -> Product:
        return Product("submap", self.motion.manifold, *[Euclidean(3 * points)] * bool(points))

    def shared(self) -> list[tuple[int, int, int, int]]:
        """(map, row, later map, row) of points of the same id, each paired with its first appearance."""
        first: dict[int, tuple[int, int]] = {}
        pairs = []
        for number, ids in enumerate(self.ids):
            for row, point in enumerate(ids.tolist()):
                if point in first:
                    pairs.append((*first[point], number, row))
                else:
                    first[point] = (number, row)
        return pairs

    def merge_duplicates(self, pairs: Sequence[tuple[int, int, int, int]] | None = None) -> int:
        """Fuse duplicates: the difference of two points is measured to be zero, without noise. Eq. (ms-tie).

        pairs: default `shared`, by their ids. One batch; the later point of each pair is then deleted. Returns the
        number of pairs. Raises CovarianceError if the pairs contradict something known without uncertainty.
        """
        pairs = self.shared() if pairs is None else list(pairs)
        if pairs:
            self.belief.update_all([self._equality_constraint(*pair) for pair in pairs])
            for number in {later for _, _, later, _ in pairs}:
                self._drop(number, [row for _, _, later, row in pairs if later == number])
        return len(pairs)

    def _equality_constraint(self, first: int, i: int, later: int, j: int) -> LinearizedMeasurement:
        blocks = [self.blocks[first], self.blocks[later]]
        jacobians = [np.zeros((3, block.dof)) for block in blocks]
        for J, row, sign in zip(jacobians, (i, j), (-1, 1), strict=True):
            J[:, self.dof + 3 * row : self.dof + 3 * row + 3] = sign * np.eye(3)
        innovation = self.points(first)[i] - self.points(later)[j]
        return LinearizedMeasurement(blocks, jacobians, innovation, np.zeros((3, 3)))

    def _drop(self, number: int, rows: list[int]) -> None:
        """Delete points of one map."""
        block, kept = self.blocks[number], np.setdiff1d(np.arange(len(self.ids[number])), rows)
        places = [np.arange(self.dof), (self.dof + 3 * kept[:, None] + np.arange(3)).ravel()]
        mean = np.concatenate([self.state(number), self.points(number)[kept].ravel()])
        self.belief.replace(block, self._manifold(len(kept)), mean, np.eye(block.dof)[np.concatenate(places)])
        self.ids[number] = self.ids[number][kept]


class SubmapSlam:
    """A filter that is closed and started anew whenever its map is full.

    slam: the filter of the present map; atlas: the finished maps. Call `close` before `merge_duplicates`.
    """

    def __init__(
        self,
        rig: Rig,
        options: Options | None = None,
        *,
        max_landmarks: int = 30,
        front_ends: Callable[[], Sequence[FrontEnd]] | None = None,
    ) -> None:
        """max_landmarks: landmarks with which a map is closed. front_ends(): makes the front ends of the next map.

        Raises SlamlibError for several robots, for a robot whose state is more than a pose, and for estimated
        extrinsics: the maps would not be independent of each other.
        """
        if len(rig.robots) != 1 or rig.robots[0].model.manifold.dof != rig.dof[0]:
            raise SlamlibError("SubmapSlam: a rig of one robot whose state is its pose is wanted (motion='odometry')")
        if any(sensor.estimated for sensor in rig.sensors):
            raise SlamlibError(
                "SubmapSlam: estimated extrinsics tie all maps together; let one map estimate them first"
            )
        if max_landmarks < 1:
            raise SlamlibError(f"SubmapSlam: max_landmarks (of one map) should be 1 or more, got {max_landmarks}")
        self.rig, self.options, self.max_landmarks = rig, options or Options(), max_landmarks
        self.front_ends, self.atlas = front_ends, Atlas(rig.robots[0].model)
        self.slam = self._new_filter(rig)

    @property
    def pose(self) -> Array:
        """The robot's pose (7,) in the frame of the first map."""
        return compose(self.atlas.pose, self.slam.robots[0].pose)

    def step(self, frame: Frame) -> StepReport:
        """Process one frame; then close the map if it is full."""
        report = self.slam.step(frame)
        if len(self.slam.landmarks) >= self.max_landmarks:
            self.close()
        return report

    def close(self) -> None:
        """Join the present map to the atlas, and start the next one in the frame of the robot's present pose."""
        self.atlas.join(Submap.of(self.slam))
        start = replace(self.rig.robots[0], position=ZERO, euler=ZERO, position_std=ZERO, orientation_std=ZERO)
        self.slam = self._new_filter(replace(self.rig, robots=(start,)))

    def _new_filter(self, rig: Rig) -> Slam:
        return Slam(rig, options=self.options, front_ends=self.front_ends() if self.front_ends else None)
