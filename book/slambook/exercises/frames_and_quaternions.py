"""Checks of the chapter: frames and quaternions."""

from itertools import pairwise

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, holds, same
from slamlib.geometry.pose import Pose, from_frame, to_frame
from slamlib.geometry.quaternion import UnitQuaternion, exponential, logarithm, minus, product, rotation
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("frames_and_quaternions.2", "the Jacobian of to_frame on the tangent space", seed=62)
def to_frame_jacobian(candidate: Candidate, rng: Rng) -> None:
    """Against differences of the book's own to_frame through plus."""
    for _ in range(5):
        pose, point = Pose.random(rng), 5 * rng.standard_normal(3)
        found = array_of(candidate(pose, point), (3, 6), "the Jacobian")
        wanted = differences(lambda step, at=pose, p=point: to_frame(Pose.plus(at, step), p), np.zeros(6))
        same(found[:, :3], wanted[:, :3], "position columns", tolerance=1e-6)
        same(found[:, 3:], wanted[:, 3:], "rotation columns", tolerance=1e-6)


@exercise("frames_and_quaternions.3", "interpolation that takes the short way", seed=63)
def slerp(candidate: Candidate, rng: Rng) -> None:
    """Ends, unit length, constant speed, and never more than half a turn in all."""
    for size in 4 * (3.0, 0.2):  # the second of each pair: close together, where some interpolate linearly
        q0, step = UnitQuaternion.random(rng), size * rng.standard_normal(3)
        for end in (UnitQuaternion.plus(q0, step), -UnitQuaternion.plus(q0, step)):
            path = [array_of(candidate(q0, end, u), (4,), "the interpolated quaternion") for u in np.linspace(0, 1, 9)]
            same([p @ p for p in path], np.ones(9), "unit length all the way")
            same(rotation(path[0]), rotation(q0), "starts at the first orientation")
            same(rotation(path[-1]), rotation(end), "ends at the second orientation")
            steps = [np.linalg.norm(minus(b, a)) for a, b in pairwise(path)]
            same(steps, np.full(8, np.mean(steps)), "constant speed")
            holds(sum(steps) <= np.pi + 1e-9, "the short way round", f"turned by {np.degrees(sum(steps)):.0f} degrees")
    for angle, sign in ((0, 1), (0, -1), (0.05, 1), (np.pi / 2, -1)):
        middle = array_of(candidate(np.eye(4)[0], sign * exponential(angle * np.eye(3)[2]), 0.5), (4,), "the middle")
        same(middle @ middle, 1, "unit length all the way")
        same(logarithm(middle), [0, 0, angle / 2], "halfway is halfway" if angle else "stays where both are the same")


@exercise("frames_and_quaternions.4", "the perturbation that is still small", seed=64)
def safe_perturbation(candidate: Candidate, rng: Rng) -> None:
    """At the candidate's angle the book's own Jacobian is wrong by the share asked for."""
    asked = ((share, distance) for share in (0.001, 0.01, 0.05, 0.1) for distance in (0.5, 10.0, 300.0))
    for share, distance in cases(asked, "a share of {} and a point at {} m"):
        angle = array_of(candidate(share, distance), (), "the angle")
        holds(0 < angle < np.pi, "an angle between 0 and pi", f"found {angle:.4g} rad")
        pose, axis, away = Pose.random(rng), rng.standard_normal(3), rng.standard_normal(3)
        away -= away @ axis / (axis @ axis) * axis  # at right angles to the axis
        point = from_frame(pose, distance * away / np.linalg.norm(away))
        step = np.concatenate([np.zeros(3), angle * axis / np.linalg.norm(axis)])
        before, J = to_frame.jac(pose, point)
        exact = to_frame(Pose.plus(pose, step), point) - before
        found = np.linalg.norm(J.pose @ step - exact) / np.linalg.norm(exact)
        what = "the prediction is wrong by the share asked for"
        holds(abs(found / share - 1) < 0.03, what, f"it is by {found:.2%}, turned by {angle:.4g} rad")


@exercise("frames_and_quaternions.5", "a covariance from another convention", seed=65)
def to_own_axes(candidate: Candidate, rng: Rng) -> None:
    """Against differences of the other convention's perturbation, measured with this book's minus."""
    for _ in range(4):
        pose, root = Pose.random(rng), rng.standard_normal((6, 6))
        P = root @ root.T
        found = covariance(candidate(pose, P), 6)

        def perturbed(step: Array, pose: Array = pose) -> Array:
            """The step as a tangent vector, taken in the world's axes."""
            moved = np.concatenate([pose[:3] + step[:3], product(exponential(step[3:]), pose[3:])])
            return np.asarray(Pose.minus(moved, pose))

        J = differences(perturbed, np.zeros(6))
        expected = J @ P @ J.T
        for rows, columns, name in ((0, 0, "position"), (0, 3, "position and rotation"), (3, 3, "rotation")):
            block = slice(rows, rows + 3), slice(columns, columns + 3)
            same(found[block], expected[block], f"the block of {name}", tolerance=1e-7)
