"""What a sensor expects of the landmarks that it should see, whatever they are."""

from dataclasses import dataclass

import numpy as np

from slamlib.slam.entities import Landmark, MountedSensor
from slamlib.spaces import Array


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
    columns: Array

    def take(self, rows: list[int]) -> "Expected":
        """Some of the landmarks, in this order."""
        arrays = (self.value[rows], self.inner[rows], self.by[rows], self.columns[rows])
        return Expected([self.landmarks[i] for i in rows], *arrays)


@dataclass(frozen=True, eq=False)
class Innovation:
    """z (n, d), its Jacobian H (n, d, k) of the expectation, and its noise R (n, d, d); of a single one without n."""

    z: Array
    H: Array
    R: Array


def means_of(landmarks: list[Landmark]) -> Array:
    """Means (n, size) of landmarks of one kind."""
    return np.array([landmark.block.mean for landmark in landmarks])


def columns_of(sensor: MountedSensor, landmarks: list[Landmark]) -> Array:
    """Rows (n, k) of the joint covariance that a look at each of the landmarks, all of one kind, depends on."""
    starts = np.array([landmark.block.start for landmark in landmarks])
    own = starts[:, None] + np.arange(landmarks[0].block.dof)
    fixed = sensor.columns
    return np.concatenate([np.broadcast_to(fixed, (len(own), len(fixed))), own], axis=1)


def by_columns(sensor: MountedSensor, robot: Array, mount: Array, landmark: Array) -> Array:
    """Jacobians by the robot, by the mount (if it is estimated), and by the landmark as one (..., q, k)."""
    return np.concatenate([robot, landmark] if sensor.block is None else [robot, mount, landmark], axis=-1)
