"""Checks of the chapter: frames and quaternions."""

from itertools import pairwise

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, holds, parts, same
from slamlib.geometry.pose import ORIGIN, Pose, from_frame, to_frame
from slamlib.geometry.quaternion import UnitQuaternion, exponential, logarithm, minus, product
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("frames_and_quaternions.2", "a point carried from frame to frame", seed=62)
def carried(candidate: Candidate, rng: Rng) -> None:
    """Against the book's own frames, and differences of them through plus; simple frames first."""
    names = {"the point in G": (3,), "the Jacobian by F": (3, 6), "the Jacobian by G": (3, 6)}
    shifted, turned = np.array([1.0, 2, 3, 1, 0, 0, 0]), np.array([0.0, 0, 0, 0.5, 0.5, 0.5, 0.5])
    inputs = [(shifted, ORIGIN), (ORIGIN, shifted), (turned, ORIGIN), (ORIGIN, turned)]
    inputs += [(Pose.random(rng), Pose.random(rng)) for _ in range(4)]
    for F, G, point in cases(((*pair, rng.integers(-5, 6, 3) / 2) for pair in inputs), "F = {}, G = {}, point = {}"):

        def moved(step: Array, F: Array = F, G: Array = G, p: Array = point) -> Array:
            return np.asarray(to_frame(Pose.plus(G, step[6:]), from_frame(Pose.plus(F, step[:6]), p)))

        found, by_F, by_G = parts(candidate(F, G, point), names)
        wanted = differences(moved, np.zeros(12))
        same(found, moved(np.zeros(12)), "the point in G")
        same(by_F[:, :3], wanted[:, :3], "the point's change by a displacement of F", tolerance=1e-6)
        same(by_F[:, 3:], wanted[:, 3:6], "the point's change by a turn of F", tolerance=1e-6)
        same(by_G[:, :3], wanted[:, 6:9], "the point's change by a displacement of G", tolerance=1e-6)
        same(by_G[:, 3:], wanted[:, 9:], "the point's change by a turn of G", tolerance=1e-6)


@exercise("frames_and_quaternions.3", "interpolation that takes the short way", seed=63)
def slerp(candidate: Candidate, rng: Rng) -> None:
    """Ends, unit length, constant speed, and never more than half a turn in all."""

    def at(q0: Array, q1: Array, u: float) -> Array:
        what = f"slerp(q0, q1, u) for q0 = {q0.round(4)}, q1 = {q1.round(4)}, u = {u:g}"
        return array_of(candidate(q0, q1, u), (4,), what)

    one = np.eye(4)[0]  # simple inputs first
    simple = ((angle, sign) for angle in (1.0, 0.0, 0.05, 1e-3, 1e-5, 1e-8, np.pi / 2) for sign in (1, -1))
    for angle, sign in cases(simple, "q0 = (1, 0, 0, 0), q1 at {:.4g} rad about z, times {}, and u = 0.5"):
        middle = at(one, sign * exponential(angle * np.eye(3)[2]), 0.5)
        same(middle @ middle, 1, "unit length all the way")
        holds(abs(middle[0]) > 0.7, "the short way round", f"found {middle}")
        share = logarithm(middle) / (angle or 1.0)  # of the turn, so that a small one counts as much as a large one
        same(share, [0, 0, 0.5 * (angle > 0)], "halfway is halfway" if angle else "stays where both are the same")
    inputs = []
    for size in 4 * (3.0, 0.2):  # the second of each pair: close together, where some interpolate linearly
        q0, step = UnitQuaternion.random(rng), size * rng.standard_normal(3)
        inputs += [(q0, end) for end in (UnitQuaternion.plus(q0, step), -UnitQuaternion.plus(q0, step))]
    for q0, end in cases(inputs, "q0 = {}, q1 = {}"):
        path = [at(q0, end, u) for u in np.linspace(0, 1, 9)]
        same([p @ p for p in path], np.ones(9), "unit length all the way")
        for found, wanted, what in ((path[0], q0, "starts at the first"), (path[-1], end, "ends at the second")):
            off = np.degrees(np.linalg.norm(minus(found, wanted)))
            holds(off < 1e-6, f"{what} orientation", f"it is off by {off:.3g} degrees")
        steps = [np.linalg.norm(minus(b, a)) for a, b in pairwise(path)]
        same(steps, np.full(8, np.mean(steps)), "constant speed")
        holds(sum(steps) <= np.pi + 1e-9, "the short way round", f"turned by {np.degrees(sum(steps)):.0f} degrees")


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
    third = np.array([1.0, 2, 3, 0.5, 0.5, 0.5, 0.5])  # its axes x, y, z are the world's y, z, x
    told = "a frame whose axes x, y, z are the world's y, z, x, and P = diag{}"
    for (variances,) in cases([((0, 0, 0, 1, 0, 0),), ((0, 0, 0, 0, 4, 0),)], told):
        found = np.diag(covariance(candidate(third, np.diag(np.array(variances, dtype=float))), 6))
        world, own = ("x", "z") if variances[3] else ("y", "x")
        what = f"an error about the world's {world} axis is one about the frame's {own} axis"
        same(found[3:], np.roll(variances[3:], -1), what)
        same(found[:3], np.zeros(3), "turning on the left of q does not move t")
    for (variances,) in cases([((1, 0, 0, 0, 0, 0),)], told):
        found = np.diag(covariance(candidate(third, np.diag(np.array(variances, dtype=float))), 6))
        same(found[:3], variances[:3], "a displacement keeps its world axes")
    inputs = []
    for _ in range(4):
        root = rng.standard_normal((6, 6))
        inputs.append((Pose.random(rng), root @ root.T))
    for pose, P in cases(inputs, "pose = {}, P = {}"):
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
