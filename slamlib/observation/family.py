"""The interface of a family of landmarks (points, lines, ...) to the filter and the simulator.

A family is one value in a module of this folder, found by a walk (observation.FAMILIES): planes or tags are one more
file. The methods here are those of a family whose measurements are rows of numbers; what it must define is abstract.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Generic, NamedTuple, Protocol, TypeAlias, TypeVar

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import Landmark, RigSensor
from slamlib.entities.landmark import landmark_means, state_rows
from slamlib.entities.linearization import Linearization
from slamlib.entities.state import KindRows
from slamlib.geometry.pose import compose
from slamlib.landmarks.parametrization import Parametrization
from slamlib.manifolds import Array, Indices, Mask, read_only
from slamlib.plain_data.fields import Finite, Plain, Positive
from slamlib.sensors.sensor import Calibration


@dataclass(frozen=True, repr=False)
class FamilyOptions(Plain):
    """Options of all families. others: parametrizations of new landmarks, of families without an option of their own.

    inverse_distance: mean and standard deviation [1/m] of the prior for what a bearing does not measure.
    """

    inverse_distance: tuple[Finite, Positive] = (0.25, 0.25)
    others: dict[str, str] | None = None

    @property
    def carried(self) -> bool:
        """Whether the covariance is kept of errors that move with the world: then each change of a state moves so."""
        return False


FamilyOptionsT = TypeVar("FamilyOptionsT", bound=FamilyOptions)  # the options of one family


class ViewJacobians(Protocol):
    """Jacobians of what is seen of landmarks: w.r.t. the sensor's pose (n, q, 6), and the landmark (n, q, dof)."""

    @property
    def camera(self) -> Array: ...

    @property
    def landmark(self) -> Array: ...


class Calibrated(Protocol):
    """A sensor, of the filter or simulated, as far as its calibration is concerned."""

    @property
    def calibration(self) -> Calibration: ...


class TrueSensor(Calibrated, Protocol):
    """A simulated sensor: its `shortest` segments [px], and what the world's faces leave to see from its pose (7,)."""

    @property
    def shortest(self) -> float: ...

    def hidden(self, points: Array, camera: Array) -> Mask:
        """Mask (n,) of the points (n, 3) that are hidden."""

    def longest_seen(self, segments: Array, camera: Array) -> tuple[Array, Mask]:
        """The longest visible part (k, 2, 3) of each segment, and the mask (k,) of those visible at all."""


class PredictedBatch(NamedTuple):
    """Predicted measurements of n landmarks of one kind in view of one sensor.

    value (n, m): predicted measurements; innovation_input (n, q): what the innovation is computed from; jacobian
    (n, q, k): of that w.r.t. the rows `columns` (n, k) of the joint covariance; options: those of the prediction.
    S (n, d, d): innovation covariances, where they have been computed.
    """

    landmarks: list[Landmark]
    value: Array
    innovation_input: Array
    jacobian: Array
    columns: Indices
    options: Any = None  # those of its family
    S: Any = None

    def take(self, rows: list[int]) -> "PredictedBatch":
        """Select landmarks, in this order."""
        value, inner, by = (array.take(rows, axis=0) for array in (self.value, self.innovation_input, self.jacobian))
        landmarks, S = [self.landmarks[i] for i in rows], None if self.S is None else self.S.take(rows, axis=0)
        return PredictedBatch(landmarks, value, inner, by, self.columns.take(rows, axis=0), self.options, S)

    @classmethod
    def nothing(cls, size: int) -> "PredictedBatch":
        """No landmark in view; measurements of `size` numbers."""
        return cls([], np.zeros((0, size)), np.zeros((0, size)), np.zeros((0, size, 0)), np.zeros((0, 0), dtype=int))


class Innovation(NamedTuple):
    """z (n, d), Jacobian H (n, d, k) of the prediction, and noise R (n, d, d); without n for a single one."""

    z: Array
    H: Array
    R: Array


class Viewpoint(NamedTuple):
    """A sensor's pose (7,) in the world, and what Jacobians need.

    linearization_pose (7,): its pose at the linearization point, `pose` itself in an ordinary EKF; jacobian (6, k): of
    that w.r.t. the rows `sensor.columns` of the joint covariance.
    """

    sensor: RigSensor
    pose: Array
    linearization_pose: Array
    jacobian: Array
    linearization: Linearization | None

    @property
    def by_block(self) -> list[Array]:
        """The jacobian by each of `sensor.blocks`, (6, dof): a robot's velocities do not move its sensors."""
        k, robot = len(self.sensor.robot.columns), self.sensor.robot.block
        by_robot = np.pad(self.jacobian[:, :k], ((0, 0), (0, robot.dof - k)))
        return [by_robot, self.jacobian[:, k:]][: len(self.sensor.blocks)]

    def linearized(self, landmarks: list[Landmark]) -> Array:
        """Linearization points (n, size) of landmarks of one kind."""
        if self.linearization is None:
            return landmark_means(landmarks)
        return np.array([self.linearization.at(landmark.block) for landmark in landmarks])


def viewpoint(sensor: RigSensor, robot: Array | None = None) -> Viewpoint:
    """The sensor's viewpoint from its robot's pose and its extrinsics; robot (7,): another pose of its robot."""
    linearization, pose = sensor.linearization, sensor.robot.pose if robot is None else robot
    is_estimated = sensor.block is not None
    motion, state = sensor.robot.motion, sensor.robot.block.mean
    now, by = _composed(pose.tobytes(), sensor.extrinsics.tobytes(), is_estimated)
    if linearization is None:
        return Viewpoint(sensor, now, now, motion.by_state(by, state), None)
    extrinsics = sensor.given_extrinsics if sensor.block is None else linearization.at(sensor.block)
    state = linearization.at(sensor.robot.block)
    at, by = _composed(motion.pose(state).tobytes(), extrinsics.tobytes(), is_estimated)
    return Viewpoint(sensor, now, at, motion.by_state(by, state), linearization)


@lru_cache(maxsize=8)  # by the numbers themselves: one frame asks several times between two measurement updates
def _composed(robot: bytes, extrinsics: bytes, is_estimated: bool) -> tuple[Array, Array]:
    pose, J = compose.jac(np.frombuffer(robot), np.frombuffer(extrinsics))
    return read_only(pose), read_only(np.concatenate(J, axis=1) if is_estimated else J.outer)


def state_columns(sensor: RigSensor, landmarks: list[Landmark]) -> Indices:
    """Rows (n, k) of the joint covariance on which each landmark's measurement depends; landmarks of one kind."""
    return with_own_rows(sensor, state_rows(landmarks))


def with_own_rows(sensor: RigSensor, own: Indices) -> Indices:
    """The same from the landmarks' own rows (n, dof)."""
    shared = sensor.columns
    columns = np.empty((len(own), len(shared) + own.shape[1]), dtype=int)
    columns[:, : len(shared)], columns[:, len(shared) :] = shared, own
    return columns


def columns_jacobian(view: Viewpoint, camera: Array, landmark: Array) -> Array:
    """Combine Jacobians w.r.t. the sensor's pose (..., q, 6) and the landmark (..., q, dof) into one w.r.t. its rows
    (..., q, k)."""
    return np.concatenate([product(camera, view.jacobian), landmark], axis=-1)


def product(left: Array, right: Array) -> Array:
    """left @ right for Jacobians (..., m, k), (..., k, n): quick where each entry lies in memory over all items."""
    lead = left.ndim - 2
    if left.ndim == right.ndim == 2:
        return left @ right
    if right.ndim == 2:  # one matrix for all items: (n, k) @ (m, k, items), a product of large matrices
        entries = left.transpose(lead, lead + 1, *range(lead))
        whole = right.T @ entries.reshape(*entries.shape[:2], math.prod(left.shape[:-2]))
        return whole.reshape(len(entries), right.shape[1], *left.shape[:-2]).transpose(*range(2, lead + 2), 0, 1)
    return np.einsum("...ij,...jk->...ik", left, right)


class Family(ABC, Generic[FamilyOptionsT]):
    """A family of landmarks: its name, the class of its parametrizations, and these by name.

    world_size: how many numbers describe one in the simulated world (points: 3); exact: the parametrization whose state
    these numbers are; parts: how many of the sensor's measurements make one of the family's (a segment: 2 pixels).
    """

    name: str
    kinds: type
    parametrizations: Mapping[str, Parametrization]
    world_size: int = 3
    exact: Parametrization | None = None
    parts: int = 1

    def chosen(self, options: FamilyOptionsT) -> str | None:
        """The name of the parametrization of new landmarks in the options, or None for none."""
        return (options.others or {}).get(self.name)

    def new_kind(self, options: FamilyOptionsT, sensor: RigSensor) -> Parametrization | None:
        """The parametrization of the landmarks that a sensor initializes, its own or the options'; None for none."""
        name = sensor.landmark if sensor.landmark in self.parametrizations else self.chosen(options)
        return self.parametrizations[name] if name else None

    def size(self, calibration: Calibration) -> int:
        """Numbers in a measurement of one landmark."""
        return calibration.sensor.size

    def supports(self, sensor: Calibrated) -> bool:
        """Whether a sensor, which has `calibration`, measures landmarks of this family: here, every sensor."""
        return True

    def usable(self, sensor: RigSensor, values: Array, options: FamilyOptionsT) -> Mask:
        """Mask (n,) of the measurements (n, m) by which a landmark may be initialized."""
        return np.ones(len(values), dtype=bool)

    @abstractmethod
    def observe(
        self, kind: Any, calibration: Calibration, camera: Array, means: Array
    ) -> tuple[Array, Mask, ViewJacobians]:
        """What the innovation is computed from, (n, q), for landmarks seen from a sensor's pose (7,): the predicted
        measurement, or what `residual` takes; the mask of those in view; and the Jacobians w.r.t. the pose (n, q, 6)
        and the landmark (n, q, dof), as `jacobians.camera` and `jacobians.landmark`."""

    def residual(
        self, sensor: RigSensor, inner: Array, by: Array, measured: Array, options: FamilyOptionsT
    ) -> Innovation:
        """Innovation, measured minus predicted: of one measurement (m,) or many (n, m), from `observe`'s results, with
        its Jacobian `by` w.r.t. the rows of the covariance. If that is H as it is, R is that of `linearized`."""
        z, noise = sensor.calibration.sensor.manifold.minus(measured, inner), sensor.calibration.noise
        return Innovation(z, by, noise if z.ndim == 1 else noise[None].repeat(len(z), axis=0))

    def predict_batch(self, view: Viewpoint, group: KindRows, options: FamilyOptionsT) -> PredictedBatch:
        """Predict the measurements of landmarks of one kind; those out of view are left out."""
        kind, calibration = group.kind, view.sensor.calibration
        value, visible, J = self.observe(kind, calibration, view.pose, group.means())
        if view.linearization is not None:
            J = self.observe(kind, calibration, view.linearization_pose, view.linearized(group.landmarks))[2]
        seen = np.flatnonzero(visible)
        if not len(seen):
            return PredictedBatch.nothing(self.size(calibration))
        looked, value = [group.landmarks[i] for i in seen.tolist()], value.take(seen, axis=0)
        by = columns_jacobian(view, J.camera.take(seen, axis=0), J.landmark.take(seen, axis=0))
        columns = with_own_rows(view.sensor, group.rows.take(seen, axis=0))
        return PredictedBatch(looked, value, value, by, columns, options)

    def linearized(self, sensor: RigSensor, expected: PredictedBatch) -> tuple[Array, Array]:
        """Jacobians H (n, d, k) and noises R (n, d, d) of predicted measurements, at what is predicted."""
        noise = sensor.calibration.noise
        return expected.jacobian, noise[None].repeat(len(expected.landmarks), axis=0)

    def batch_innovation(self, sensor: RigSensor, expected: PredictedBatch, measured: Array) -> Innovation:
        """Innovations of measurements (n, m) of predicted landmarks."""
        return self.residual(sensor, expected.innovation_input, expected.jacobian, measured, expected.options)

    def innovation(
        self, view: Viewpoint, landmark: Landmark, measured: Array, options: FamilyOptionsT
    ) -> Innovation | None:
        """The innovation of one landmark at the present means; None if it is out of view there."""
        kind, calibration = landmark.kind, view.sensor.calibration
        inner, visible, J = self.observe(kind, calibration, view.pose, landmark.block.mean)
        if not visible:
            return None
        if view.linearization is not None:
            J = self.observe(kind, calibration, view.linearization_pose, view.linearization.at(landmark.block))[2]
        return self.residual(view.sensor, inner, columns_jacobian(view, J.camera, J.landmark), measured, options)

    def innovation_input(self, calibration: Calibration, in_frame: Array) -> Array:
        """The innovation's input, for landmarks in the sensor's frame (..., q), as kind.to_frame returns them;
        nan where it cannot see them."""
        return in_frame

    @abstractmethod
    def initialize(
        self, sensor: RigSensor, kind: Any, value: Array, options: FamilyOptionsT
    ) -> tuple[Array, Array, list[Array]]:
        """Mean (size,), own noise (dof, dof) and Jacobians (dof, 6) w.r.t. robot and extrinsics of a new landmark."""

    def abscissas(self, kind: Parametrization) -> Array | None:
        """The abscissas of a new landmark's two endpoints, by its parametrization; None for one without endpoints."""
        return np.array(kind.abscissas, dtype=float) if hasattr(kind, "abscissas") else None

    def after_update(
        self, belief: Belief, sensor: RigSensor, landmarks: list[Landmark], measured: Array, options: FamilyOptionsT
    ) -> None:
        """Treat landmarks of one kind after a measurement update: here, do nothing."""

    def invalid(self, belief: Belief, landmarks: list[Landmark]) -> set[Landmark]:
        """The landmarks, of one kind, whose estimates are impossible: here, none."""
        return set()

    @abstractmethod
    def geometry(self, belief: Belief, landmarks: list[Landmark]) -> tuple[Array, Array, Mask]:
        """For display: positions in the world (n, ...), covariances (n, ...), and the mask of those converged."""

    def distance(self, geometry: Array, there: Array) -> float:
        """Distance [m] of a landmark, as `geometry` returns it, from the true one (world_size,)."""
        return float(np.linalg.norm(geometry - there))

    def check(self, name: str, calibration: Calibration) -> None:
        """Raise SlamlibError if a sensor of this name cannot be simulated with landmarks of the family."""

    def simulate(self, sensor: TrueSensor, camera: Array, places: Array, noise: Array) -> tuple[Indices, Array]:
        """Simulate a sensor's measurements at a pose (7,): rows (k,) of the landmarks in view, values (k, m).

        places (n, world_size): the true landmarks; noise (n, m), or (n, parts, m): of each, in view or not.
        """
        value, visible, _ = self.observe(self.exact, sensor.calibration, camera, places)
        rows = np.flatnonzero(visible)
        return rows, sensor.calibration.sensor.manifold.plus(value[rows], noise[rows])


AnyFamily: TypeAlias = Family[Any]  # of a filter's families each takes its own part of the options
