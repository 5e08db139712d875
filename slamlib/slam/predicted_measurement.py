"""What a sensor expects of the landmarks that it should see, whatever they are."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from slamlib.geometry.pose import compose
from slamlib.kalman import state
from slamlib.kalman.linalg import sealed
from slamlib.manifolds import Array, Indices
from slamlib.observation.points import product
from slamlib.slam.entities import Landmark, MountedSensor


@dataclass(frozen=True, eq=False)
class Expected:
    """n landmarks of one kind in view of one sensor.

    value (n, m): their measurements; inner (n, q): what the innovation is computed from, with its Jacobian
    by (n, q, k) by the rows `columns` (n, k) of the joint covariance.
    """

    landmarks: list[Landmark]
    value: Array
    inner: Array
    by: Array
    columns: Indices

    def take(self, rows: list[int]) -> "Expected":
        """Some of the landmarks, in this order."""
        value, inner, by = (array.take(rows, axis=0) for array in (self.value, self.inner, self.by))
        return Expected([self.landmarks[i] for i in rows], value, inner, by, self.columns.take(rows, axis=0))

    @classmethod
    def nothing(cls, size: int) -> "Expected":
        """No landmark in view, of those whose measurements have `size` numbers."""
        return cls([], np.zeros((0, size)), np.zeros((0, size)), np.zeros((0, size, 0)), np.zeros((0, 0), dtype=int))


@dataclass(frozen=True, eq=False)
class Innovation:
    """z (n, d), its Jacobian H (n, d, k) of the expectation, and its noise R (n, d, d); of a single one without n."""

    z: Array
    H: Array
    R: Array


def means_of(landmarks: list[Landmark]) -> Array:
    """Means (n, size) of landmarks of one kind."""
    return state.means_of([landmark.block for landmark in landmarks])


def columns_of(sensor: MountedSensor, landmarks: list[Landmark]) -> Indices:
    """Rows (n, k) of the joint covariance that a look at each of the landmarks, all of one kind, depends on."""
    starts = np.array([landmark.block.start for landmark in landmarks])
    shared, dof = sensor.columns, landmarks[0].block.dof
    columns = np.empty((len(starts), len(shared) + dof), dtype=int)
    columns[:, : len(shared)], columns[:, len(shared) :] = shared, starts[:, None] + np.arange(dof)
    return columns


@dataclass(frozen=True, eq=False)
class Place:
    """A sensor's pose (7,) in the world, and its Jacobian (6, k) by the rows `columns` of the joint covariance."""

    pose: Array
    by: Array


def place_of(sensor: MountedSensor) -> Place:
    """Where the sensor is now: its pose depends on the robot's, and on the mount if that is estimated."""
    robot, mount = (np.asarray(pose, dtype=float).tobytes() for pose in (sensor.robot.pose, sensor.mount))
    return _place(robot, mount, sensor.block is not None)


@lru_cache(maxsize=8)  # by the numbers themselves: one frame asks several times between two corrections
def _place(robot: bytes, mount: bytes, is_estimated: bool) -> Place:
    pose, J = compose.jac(np.frombuffer(robot), np.frombuffer(mount))
    return Place(sealed(pose), sealed(np.concatenate(J, axis=1) if is_estimated else J.outer))


def by_columns(place: Place, camera: Array, landmark: Array) -> Array:
    """Jacobians by the sensor's pose (..., q, 6) and by the landmark (..., q, dof) as one by its rows (..., q, k)."""
    return np.concatenate([product(camera, place.by), landmark], axis=-1)
