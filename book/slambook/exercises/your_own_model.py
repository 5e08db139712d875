"""Checks of the chapter: developing an observation model of one's own."""

import numpy as np

from slambook.exercises.kit import Candidate, Rejected, Rng, cases, exercise, holds, parts, same
from slamlib.checks import CheckError, check_landmark
from slamlib.geometry.pose import ORIGIN
from slamlib.landmarks import PointLandmark
from slamlib.manifolds import Euclidean
from slamlib.models.numerical import differences


@exercise("your_own_model.1", "a prior in another coordinate")
def angle_prior(candidate: Candidate) -> None:
    """The mean through the definition of the angle, the standard deviation by differences of the candidate's mean."""
    priors = (0.25, 0.125), (1.0, 0.5), (5.0, 2.5), (0.0, 0.1), (-0.01, 0.02)
    for rho, sigma in cases(priors, "inverse distance {:g} with sigma {:g} per metre"):
        angle, spread = parts(candidate(rho, sigma), {"the angle": (), "its standard deviation": None})
        if rho == 0:
            same(angle, 0.0, "a point at infinity has no parallax")
        holds(abs(angle) < np.pi / 2, "the angle lies between -90 and 90 degrees", f"found {angle:.6g}")
        same(np.tan(angle), rho, "the tangent of the angle is the inverse distance")
        slope = differences(lambda x, sigma=sigma: candidate(x[0], sigma)[0], np.array([rho]))[0]
        same(spread, sigma * abs(slope), "the spread follows the slope of the angle", tolerance=1e-7)


@exercise("your_own_model.2", "a point held by its distance")
def distance_point(candidate: Candidate) -> None:
    """The package's own checks of a landmark; and that its name and its numbers are those asked for."""
    kind = candidate()
    if not isinstance(kind, PointLandmark) or kind.name != "dstPnt":
        found = getattr(kind, "name", type(kind).__name__)
        raise Rejected(f"your function should return a PointLandmark named dstPnt, but returned {found}")
    seven = isinstance(kind.manifold, Euclidean) and kind.manifold.size == 7
    holds(seven, "the landmark has seven numbers", f"its space is {kind.manifold!r}: give as_manifold(7)")
    try:
        check_landmark(kind, silent=True)
    except CheckError as error:
        raise Rejected(str(error)) from None
    holds(True, "the package's checks of a point landmark")
    landmark = kind.from_frame(np.array([1.0, 2, 3, *ORIGIN[3:]]), np.array([1.2, 0, 1.6, 0.5]))  # 4 m away
    same(landmark, [1, 2, 3, 0.6, 0, 0.8, 4], "anchor, unit direction and distance, in this order")


@exercise("your_own_model.3", "closing speed", seed=133)
def closing_speed(candidate: Candidate, rng: Rng) -> None:
    """The range, moved a little along the velocity, shrinks at this rate."""
    forward = np.array([1.5, 0.0, 0.0])
    for place, wanted in cases(
        (([9.0, 0, 0], 1.5), ([0, 4.0, 0], 0.0), ([-2.0, 0, 0], -1.5)), "a point at {} m, 1.5 m/s straight ahead"
    ):
        found = candidate(np.array(place), forward)
        same(found, wanted, "ahead the speed itself, abeam zero, behind its negative")
    anywhere = [(10 * rng.standard_normal(3), 2 * rng.standard_normal(3)) for _ in range(5)]
    for point, velocity in cases(anywhere, "a point at {} m, velocity {} m/s"):
        ranges = [np.linalg.norm(point - t * velocity) for t in (-1e-5, 1e-5)]
        found = candidate(point, velocity)
        same(found, (ranges[0] - ranges[1]) / 2e-5, "the rate at which the range shrinks", tolerance=1e-6)
        same(candidate(3 * point, velocity), found, "the distance does not matter")
