"""Paths as controls of an odometry robot: arrays (steps, 6) of dx [m] and rotation vector [rad], one row a step.

Join paths with np.concatenate. They are the nominal controls; with noise in the truth, the robot deviates from them.
"""

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array


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


def _rows(steps: int, ahead: float, left: float) -> Array:
    return np.tile([ahead, 0.0, 0.0, 0.0, 0.0, left], (steps, 1))


def _whole(steps: int) -> int:
    if int(steps) != steps or steps < 1:
        raise SlamlibError(f"steps is a whole number, 1 or more, got {steps}")
    return int(steps)
