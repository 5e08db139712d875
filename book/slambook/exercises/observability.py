"""Checks of the chapter: A filter that knows what it cannot know."""

from functools import partial

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, between, cases, exercise, holds, same
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("observability.1", "a landmark that moves with the world", seed=171)
def moved(candidate: Candidate, rng: Rng) -> None:
    """Nothing is noticed from a robot that moves along, exactly and to first order; and new landmarks inherit it."""
    drawn = [(rng.uniform(-3, 3, 3), rng.uniform(-3, 3, 3), rng.uniform(1, 3, 4)) for _ in range(6)]
    for motion, robot, landmark in cases(drawn, "motion {}, robot {}, landmark {}"):
        after = array_of(candidate(motion, landmark), (4,), "the moved landmark")
        same(candidate(np.zeros(3), landmark), landmark, "where nothing moves, nothing changes")
        what = "range and bearing are the same from a robot that moves along"
        seen = _measured(np.append(robot, landmark))
        same(_nearest(_measured(np.append(_carried(motion, robot), after)), seen, 1), seen, what)
        there, new = _carried(motion, robot), np.append(robot, landmark[3])
        found = array_of(candidate(motion, new), (4,), "the moved landmark")
        wanted = np.append(there, landmark[3])
        same(_nearest(found, wanted, 2), wanted, "a new landmark moves with its robot")
        movers = partial(_carried, robot=robot), lambda m, x=landmark: candidate(m, x)
        both = [differences(mover, np.zeros(3)) for mover in movers]
        change = differences(_measured, np.append(robot, landmark)) @ np.concatenate(both)
        holds(np.abs(change).max() < 1e-5, "H N = 0", f"a measurement changes by {np.abs(change).max():.3g}")


def _carried(motion: Array, robot: Array) -> Array:
    """The robot's pose (3,) after a motion (x, y [m], angle [rad]) of the world."""
    c, s = np.cos(motion[2]), np.sin(motion[2])
    return np.append(motion[:2] + np.array([[c, -s], [s, c]]) @ robot[:2], motion[2] + robot[2])


def _nearest(found: Array, wanted: Array, angle: int) -> Array:
    """What was found, its angle [rad] with so many whole turns that it lies next to the wanted one."""
    turns = np.round((wanted - found)[angle] / (2 * np.pi))
    return found + 2 * np.pi * turns * (np.arange(len(found)) == angle)


def _measured(x: Array) -> Array:
    """Range and bearing of robot (3,) and landmark (anchor, angle, distance)."""
    d = x[3:5] + x[6] * np.array([np.cos(x[5]), np.sin(x[5])]) - x[:2]
    c, s = np.cos(x[2]), np.sin(x[2])
    return np.array([np.hypot(*d), np.arctan2(c * d[1] - s * d[0], c * d[0] + s * d[1])])


@exercise("observability.2", "the rank of what a filter believes to see", seed=172)
def observability_matrix(candidate: Candidate, rng: Rng) -> None:
    """The derivative of all measurements where points are consistent; and the ranks of four choices of points."""
    for steps, m in cases(((3, 2), (4, 3), (6, 1)), "{} steps, {} landmarks"):
        size = 3 + 2 * m
        poses = rng.uniform(-1, 1, (steps, 3)) + np.linspace(0, 2, steps)[:, None] * [1, 0.3, 0.2]
        marks = rng.uniform(4, 8, (m, 2)) * rng.choice([-1, 1], (m, 2))
        fixed = np.tile(marks, (steps, 1, 1))
        stacked = array_of(candidate(poses, poses, fixed), (2 * m * steps, size), "the matrix")
        wanted = differences(partial(_drive, start=poses[0], moves=np.diff(poses, axis=0)), np.append(poses[0], marks))
        same(stacked, wanted, "at the points of one trajectory it is the derivative of all measurements", 1e-6)
        first, updated = poses + 0.2 * rng.standard_normal((2, *poses.shape))
        changing = fixed + 0.2 * rng.standard_normal(fixed.shape)
        for name, points, missing in (
            ("first estimates: three directions unobservable", (first, np.r_[first[:-1], updated[-1:]], fixed), 3),
            ("changing estimates: one direction less", (poses, updated, changing), 2),
            ("changing estimates of the landmarks alone: one direction less, too", (poses, poses, changing), 2),
            ("first estimates in H but not in F: one direction less, too", (poses, updated, fixed), 2),
        ):
            values = np.linalg.svd(array_of(candidate(*points), stacked.shape, "the matrix"))[1]
            rank = int((values > 1e-9 * values[0]).sum())
            holds(rank == size - missing, name, f"its rank is {rank} of {size}")


def _drive(x: Array, start: Array, moves: Array) -> Array:
    """Ranges and bearings of all landmarks along a path whose moves were made, from its start, in the robot's axes."""
    turn = x[2] - start[2]
    c, s = np.cos(turn), np.sin(turn)
    path = np.concatenate([np.zeros((1, 3)), np.cumsum(moves, axis=0)])
    places, headings = x[:2] + path[:, :2] @ np.array([[c, s], [-s, c]]), x[2] + path[:, 2]
    d = x[3:].reshape(-1, 2) - places[:, None]
    bearing = np.arctan2(d[..., 1], d[..., 0]) - headings[:, None]
    return np.stack([np.hypot(d[..., 0], d[..., 1]), bearing], axis=-1).ravel()


@exercise("observability.3", "the scale that noisy displacements give", seed=173)
def expected_scale(candidate: Candidate, rng: Rng) -> None:
    """The limit of least squares, simulated; exact reports give the scale; units do not matter."""
    for count in cases((1, 3, 8), "{} displacements"):
        scale, sigma = float(rng.uniform(0.5, 2)), float(rng.uniform(0.4, 0.6))
        d = np.geomspace(2, 0.2, count) * rng.choice([-1, 1], count)  # unlike: the mean square is no square of a mean
        found = float(array_of(candidate(scale, d, sigma), (), "the scale"))
        same(candidate(scale, d, 0.0), scale, "exact reports: the scale itself")
        same(candidate(scale, 1000 * d, 1000 * sigma), found, "metres or millimetres make no difference")
        reported = d + sigma * rng.standard_normal((200_000 // count, count))
        measured = scale * d + 0.1 * rng.standard_normal(reported.shape)
        limit = (reported * measured).sum() / (reported**2).sum()
        between(found / limit, 0.985, 1.015, "least squares of many runs gives it")
