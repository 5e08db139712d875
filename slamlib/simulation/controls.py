"""Paths as controls of an odometry robot: arrays (steps, 6) of dx [m] and rotation vector [rad], one row a step.

Join paths with np.concatenate. They are the nominal controls; with noise in the truth, the robot deviates from them.
"""

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, numbers


def straight(steps: int, length: float) -> Array:
    """Straight ahead, `length` [m] in `steps` steps."""
    return _rows(steps, length / _whole(steps), 0.0)


def circle(steps: int, radius: float, turns: float = 1.0) -> Array:
    """A circle to the left (turns < 0: to the right): chords of a circle of this radius [m], each before its turn.

    A whole number of turns comes back to the start exactly.
    """
    angle = 2 * np.pi * turns / _whole(steps)
    return _rows(steps, 2 * radius * np.sin(abs(angle) / 2), angle)


def figure_of_eight(steps: int, radius: float) -> Array:
    """A circle to the left and one to the right, each of half the steps; back to the start exactly."""
    if _whole(steps) % 2:
        raise SlamlibError(f"figure_of_eight: an even number of steps makes two circles, got {steps}")
    return np.concatenate([circle(steps // 2, radius, turn) for turn in (1.0, -1.0)])


def waypoints(points: Array, *, heading: float, step: float, turn: float) -> Array:
    """From points[0], heading `heading` [rad], through all points (n, 2) [m]: turn on the spot, then straight ahead.

    No step is longer than `step` [m] or turns by more than `turn` [rad]; those of one leg are equal.
    """
    points = numbers(points, "waypoints", "points")
    if points.ndim != 2 or points.shape[1] != 2 or len(points) < 2:
        raise SlamlibError(f"waypoints: points are two or more rows (x, y), got shape {points.shape}")
    if not (step > 0 and turn > 0):
        raise SlamlibError(f"waypoints: step and turn are above zero, got {step} and {turn}")
    legs: list[Array] = []
    for dx, dy in np.diff(points, axis=0):
        left, length = np.remainder(np.arctan2(dy, dx) - heading + np.pi, 2 * np.pi) - np.pi, np.hypot(dx, dy)
        legs += [_parts(0.0, left, turn), _parts(length, 0.0, step)] if length else []
        heading += left if length else 0.0
    return np.concatenate([np.zeros((0, 6)), *legs])


def _parts(length: float, angle: float, most: float) -> Array:
    """Divide a straight or a turn into the fewest equal steps of at most this size."""
    count = int(np.ceil((abs(angle) + length) / most - 1e-9))
    return _rows(count, length / max(count, 1), angle / max(count, 1))


def _rows(steps: int, ahead: float, left: float) -> Array:
    return np.tile([ahead, 0.0, 0.0, 0.0, 0.0, left], (steps, 1))


def _whole(steps: int) -> int:
    if int(steps) != steps or steps < 1:
        raise SlamlibError(f"steps is a whole number, 1 or more, got {steps}")
    return int(steps)
