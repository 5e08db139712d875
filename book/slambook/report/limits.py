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

SPACING = 4.0  # [m] between landmarks


@dataclass(frozen=True, eq=False)
class RepeatedObservations:
    """The map's covariance after each of n updates from `first` on, when all L landmarks are known for the first time.

    start: standard deviation of the robot's first position [m]; correlation (n, pairs): of two landmarks; absolute
    (n, L): their standard deviations [m]; relative (n, L - 1): those of the positions relative to the first one [m];
    beside (n,): correlation of the last two of these; bound: limit of `absolute` [m], if every scan shows all.
    """

    start: float
    first: int
    correlation: Array
    absolute: Array
    relative: Array
    beside: Array
    bound: float


def repeated_observations(
    observations: int = 200,
    landmarks: int = 5,
    *,
    start: float = 0.5,
    motion: float = 0.1,
    noise: float = 0.2,
    reach: float = np.inf,
) -> RepeatedObservations:
    """Scans of a robot that goes to and fro, 1 m a step, along landmarks 4 m apart.

    start, motion (each step), noise (each measurement): standard deviations [m]; reach: the sensor's range [m].
    """
    if landmarks < 3 or observations < 1 or reach < SPACING:
        raise SlamlibError("looking: three landmarks or more, one scan or more, and a reach of 4 m or more")
    maps = [P for P in _maps(observations, landmarks, start, motion, noise, reach) if len(P) == landmarks]
    if not maps:
        raise SlamlibError(
            f"looking: after {observations} scans not all {landmarks} landmarks were seen; take more scans"
        )
    P, first = np.array(maps), observations - len(maps)
    absolute = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    i, j = np.triu_indices(landmarks, 1)
    between = P[:, 1:, 1:] - P[:, 1:, :1] - P[:, :1, 1:] + P[:, :1, :1]  # of the positions relative to the first
    relative = np.sqrt(np.diagonal(between, axis1=-2, axis2=-1))
    with np.errstate(invalid="ignore"):
        correlation = (P / absolute[:, :, None] / absolute[:, None, :])[:, i, j]
        beside = between[:, -1, -2] / relative[:, -1] / relative[:, -2]
    bound = limit(start, motion, noise / np.sqrt(landmarks))
    return RepeatedObservations(start, first, correlation, absolute, relative, beside, bound)


def _maps(
    observations: int, landmarks: int, start: float, motion: float, noise: float, reach: float
) -> Iterator[Array]:
    """The map's covariance after each update, of the landmarks seen so far."""
    places, belief, known = SPACING * np.arange(landmarks), Belief(), 0
    robot = belief.add(1, np.zeros(1), np.array([[start**2]]))
    end = int(places[-1])
    steps = np.arange(observations) % (2 * end)  # to the end and back, again and again, 1 m a step
    for look, where in enumerate(np.minimum(steps, 2 * end - steps)):
        if look:
            belief.predict(robot, robot.mean, np.eye(1), np.array([[motion**2]]))
        seen = np.flatnonzero(np.abs(places - where) <= reach)
        if (m := int((seen < known).sum())) > 0:  # position minus that of the robot, which is row 0
            H = np.concatenate([-np.ones((m, 1)), np.eye(m)], axis=1)
            belief.update_rows(np.array([0, *(1 + seen[:m])]), H, np.zeros(m), noise**2 * np.eye(m))
        for i in seen[seen >= known]:  # on the way out they are met in their order
            belief.add(1, places[[i]], np.array([[noise**2]]), given=[robot], jacobians=[np.eye(1)])
        known = max(known, seen[-1] + 1)
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
