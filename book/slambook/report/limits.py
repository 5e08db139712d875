"""Limits of a map that is observed again and again, in the linear case: Dissanayake et al. (2001), in numbers.

A robot on a line, whose heading is known, observes the positions of landmarks relative to it. Everything is linear: the
covariance depends on no measurement, one run is all runs, and the innovations may as well be zero.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array


@dataclass(frozen=True, eq=False)
class RepeatedObservations:
    """The map's covariance after each of n scans of all L landmarks.

    correlation (n, pairs): of two landmarks; absolute (n, L): their standard deviations [m]; relative (n, L - 1): those
    of the positions relative to the first one [m]; bound: limit of `absolute` [m].
    """

    correlation: Array
    absolute: Array
    relative: Array
    bound: float


def repeated_observations(
    observations: int = 200,
    landmarks: int = 5,
    *,
    start: float = 0.5,
    motion: float = 0.1,
    noise: float = 0.2,
) -> RepeatedObservations:
    """Scans of a robot that goes to and fro, 1 m a step, along landmarks 4 m apart, all of which each scan shows.

    start, motion (each step), noise (each measurement): standard deviations [m].
    """
    if landmarks < 2 or observations < 1:
        raise SlamlibError("repeated observations: two landmarks or more, and one scan or more")
    P = np.array(list(_maps(observations, landmarks, start, motion, noise)))
    absolute = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    i, j = np.triu_indices(landmarks, 1)
    between = P[:, 1:, 1:] - P[:, 1:, :1] - P[:, :1, 1:] + P[:, :1, :1]  # of the positions relative to the first
    relative = np.sqrt(np.diagonal(between, axis1=-2, axis2=-1))
    with np.errstate(invalid="ignore"):
        correlation = (P / absolute[:, :, None] / absolute[:, None, :])[:, i, j]
    return RepeatedObservations(correlation, absolute, relative, limit(start, motion, noise / np.sqrt(landmarks)))


def _maps(observations: int, landmarks: int, start: float, motion: float, noise: float) -> Iterator[Array]:
    """The map's covariance after each scan. It does not depend on where the robot is."""
    belief, R = Belief(), noise**2 * np.eye(landmarks)
    robot = belief.add(1, np.zeros(1), np.array([[start**2]]))
    for _ in range(landmarks):  # the first scan
        belief.add(1, np.zeros(1), R[:1, :1], given=[robot], jacobians=[np.eye(1)])
    yield belief.matrix[1:, 1:].copy()
    H = np.concatenate([-np.ones((landmarks, 1)), np.eye(landmarks)], axis=1)  # position minus that of the robot
    for _ in range(observations - 1):
        belief.predict(robot, robot.mean, np.eye(1), np.array([[motion**2]]))
        belief.update_rows(np.arange(landmarks + 1), H, np.zeros(landmarks), R)
        yield belief.matrix[1:, 1:].copy()


def limit(start: float, motion: float, noise: float) -> float:
    """Limit of every landmark's standard deviation [m]; noise: of one scan of all of them together [m].

    In the end the landmarks' relative positions are known. Then a scan is one number, the position of the map relative
    to the robot, and all scans together leave the variance p of the map relative to the start: one scan has the
    variance r, the others are the same problem one step later, so 1/p = 1/r + 1/(p + q). The position of the start is
    not observable, hence start^2 + p.
    """
    q, r = motion**2, noise**2
    return float(np.sqrt(start**2 + (np.sqrt(q * q + 4 * q * r) - q) / 2))
