"""Checks of chapter 6: frames and quaternions."""

from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, jacobian_matches, same
from slamlib.geometry.pose import Pose, to_frame
from slamlib.geometry.quaternion import UnitQuaternion, exponential, minus, product, rotation


@exercise("6.2", "the Jacobian of to_frame on the tangent space")
def to_frame_jacobian(candidate: Any) -> None:
    """Against differences of the book's own to_frame through plus."""
    rng = np.random.default_rng(62)
    for _ in range(5):
        pose, point = Pose.random(rng), 5 * rng.standard_normal(3)
        found = array_of(candidate(pose, point), (3, 6), "the Jacobian")
        for columns, name in ((slice(0, 3), "position columns"), (slice(3, 6), "rotation columns")):
            jacobian_matches(found[:, columns], partial(_nudged, pose, point, columns), np.zeros(3), name)


def _nudged(pose: Any, point: Any, columns: slice, part: Any) -> Any:
    step = np.zeros(6)
    step[columns] = part
    return to_frame(Pose.plus(pose, step), point)


@exercise("6.3", "interpolation that takes the short way")
def slerp(candidate: Any) -> None:
    """Ends, unit length, constant speed, and never more than half a turn in all."""
    rng = np.random.default_rng(63)
    for _ in range(8):
        q0, q1 = UnitQuaternion.random(rng), UnitQuaternion.random(rng)
        for end in (q1, -q1):
            path = [array_of(candidate(q0, end, u), (4,), "the interpolated quaternion") for u in np.linspace(0, 1, 9)]
            same([p @ p for p in path], np.ones(9), "unit length all the way")
            same(rotation(path[0]), rotation(q0), "starts at the first attitude")
            same(rotation(path[-1]), rotation(q1), "ends at the second attitude")
            steps = [np.linalg.norm(minus(b, a)) for a, b in pairwise(path)]
            same(steps, np.full(8, np.mean(steps)), "constant speed")
            holds(
                sum(steps) <= np.pi + 1e-9,
                "the short way round",
                f"turned by {np.degrees(sum(steps)):.0f} degrees in all",
            )
    quarter = exponential(np.array([0.0, 0, np.pi / 2]))
    same(rotation(candidate(quarter, product(quarter, quarter), 0.5))[0, 0], -np.sqrt(0.5), "halfway is halfway")
