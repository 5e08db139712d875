"""Checks of the chapter: developing an observation model of one's own."""

from functools import partial
from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import Rejected, array_of, differences, holds, pair, same
from slamlib.landmarks import PointLandmark
from slamlib.manifolds import Array, Euclidean
from slamlib.testing import CheckError, check_landmark

IDENTITY = np.array([0.0, 0, 0, 1, 0, 0, 0])


@exercise("your_own_model.1", "a prior in another coordinate")
def angle_prior(candidate: Any) -> None:
    """The mean through the definition of the angle, the standard deviation by differences of the candidate's mean."""
    for rho, sigma in ((0.0, 0.1), (0.25, 0.125), (1.0, 0.5), (5.0, 2.5), (-0.01, 0.02)):
        given = f"inverse distance {rho:g} with sigma {sigma:g} per metre"
        angle, spread = pair(candidate(rho, sigma), "the angle and its standard deviation")
        angle = float(array_of(angle, (), "the angle"))
        holds(abs(angle) < np.pi / 2, "the angle lies between -90 and 90 degrees", f"found {angle:.6g} for {given}")
        same(np.tan(angle), rho, "the tangent of the angle is the inverse distance", given=given)
        slope = differences(partial(_mean, candidate, sigma), np.array([rho]))[0, 0]
        same(spread, sigma * abs(slope), "the spread follows the slope of the angle", given=given, tolerance=1e-7)


def _mean(candidate: Any, sigma: float, rho: Array) -> Array:
    return np.atleast_1d(candidate(rho[0], sigma)[0])


@exercise("your_own_model.2", "a point held by its distance")
def distance_point(candidate: Any) -> None:
    """The package's own checks of a landmark; and that the seventh number is what was asked for."""
    kind = candidate()
    if not isinstance(kind, PointLandmark):
        raise Rejected(f"your function should return a PointLandmark, but returned {type(kind).__name__}")
    seven = isinstance(kind.manifold, Euclidean) and kind.manifold.size == 7
    holds(seven, "the landmark has seven numbers", f"its space is {kind.manifold!r}: give as_space(7)")
    try:
        check_landmark(kind, silent=True)
    except CheckError as error:
        raise Rejected(str(error)) from None
    holds(True, "the package's checks of a point landmark", "")
    landmark = kind.from_frame(IDENTITY, np.array([0.6, 0, 0.8, 0.25]))
    same(landmark[6], 4.0, "the seventh number is the distance in metres", given="a point 4 m away")


@exercise("your_own_model.3", "closing speed")
def closing_speed(candidate: Any) -> None:
    """The range, moved a little along the velocity, shrinks at this rate."""
    rng = np.random.default_rng(133)
    forward = np.array([1.5, 0.0, 0.0])
    for point, wanted in ((np.array([9.0, 0, 0]), 1.5), (np.array([0, 4.0, 0]), 0.0), (np.array([-2.0, 0, 0]), -1.5)):
        given = f"a point at {point.tolist()} m and the velocity {forward.tolist()} m/s"
        same(candidate(point, forward), wanted, "ahead the speed itself, abeam zero, behind its negative", given=given)
    for _ in range(5):
        point, velocity = 10 * rng.standard_normal(3), 2 * rng.standard_normal(3)
        ranges = [np.linalg.norm(point - t * velocity) for t in (-1e-5, 1e-5)]
        what = "the rate at which the range shrinks"
        same(candidate(point, velocity), (ranges[0] - ranges[1]) / 2e-5, what, tolerance=1e-6)
        same(candidate(3 * point, velocity), candidate(point, velocity), "the distance does not matter")
