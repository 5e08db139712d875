"""Paths through a room, as smooth functions of time: for a hand-held camera, with exact velocities.

A path is a cubic spline through knots of position and roll, pitch, yaw: twice continuously differentiable, without
acceleration at both ends. The moving frame has x ahead and z up, as robots do.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.geometry.euler import to_quaternion
from slamlib.manifolds import Array, finite, numbers, read_only_copy


@dataclass(frozen=True, eq=False)
class CameraPath:
    """times (n,) [s], rising, and knots (n, 6): position [m], then roll, pitch, yaw [rad], which may exceed a turn."""

    times: Array
    knots: Array

    def __post_init__(self) -> None:
        times, knots = numbers(self.times, "Path", "times"), numbers(self.knots, "Path", "knots")
        if times.ndim != 1 or len(times) < 3 or not (np.diff(times) > 0).all():
            raise SlamlibError("Path: times are three or more, each after the one before")
        object.__setattr__(self, "times", read_only_copy(finite(times, times.shape, "Path", "times")))
        object.__setattr__(self, "knots", read_only_copy(finite(knots, (len(times), 6), "Path", "knots")))
        object.__setattr__(self, "_bends", read_only_copy(_bends(times, knots)))

    _bends: Any = None

    @property
    def duration(self) -> float:
        """Time [s] from the first knot to the last."""
        return float(self.times[-1] - self.times[0])

    def pose(self, time: float) -> Array:
        """Pose (7,) of the moving frame at a time [s] since the first knot. Raises SlamlibError outside the path."""
        place, _ = self._at(time)
        return np.concatenate([place[:3], to_quaternion(place[3:])])

    def velocity(self, time: float) -> Array:
        """Velocity [m/s] in world axes, and angular velocity [rad/s] in the frame's own (6,)."""
        place, change = self._at(time)
        return np.concatenate([change[:3], _spin(place[3:], change[3:])])

    def state(self, time: float) -> Array:
        """Pose and velocities (13,)."""
        return np.concatenate([self.pose(time), self.velocity(time)])

    def _at(self, time: float) -> tuple[Array, Array]:
        """The six numbers at a time, and their derivatives."""
        if not -1e-9 <= time <= self.duration + 1e-9:
            raise SlamlibError(f"the path takes {self.duration:g} s, and has no place at {time:g} s: make it longer")
        at = self.times[0] + time
        i = int(np.clip(np.searchsorted(self.times, at, side="right") - 1, 0, len(self.times) - 2))
        h = self.times[i + 1] - self.times[i]
        b = (at - self.times[i]) / h
        a = 1 - b
        (p, q), (m, n) = self.knots[i : i + 2], self._bends[i : i + 2] * h * h / 6
        place = a * p + b * q + (a**3 - a) * m + (b**3 - b) * n
        return place, (q - p - (3 * a**2 - 1) * m + (3 * b**2 - 1) * n) / h


def _bends(times: Array, knots: Array) -> Array:
    """Second derivatives (n, 6) at the knots of the natural spline, which has none at its ends."""
    h = np.diff(times)
    n = len(times)
    system = np.eye(n)
    inner = np.arange(1, n - 1)
    system[inner, inner - 1], system[inner, inner], system[inner, inner + 1] = h[:-1], 2 * (h[:-1] + h[1:]), h[1:]
    slopes = np.diff(knots, axis=0) / h[:, None]
    return np.linalg.solve(system, np.concatenate([np.zeros((1, 6)), 6 * np.diff(slopes, axis=0), np.zeros((1, 6))]))


def _spin(angles: Array, change: Array) -> Array:
    """Angular velocity (3,) in the frame's axes, of roll, pitch, yaw and their derivatives."""
    (cr, cp), (sr, sp) = np.cos(angles[:2]), np.sin(angles[:2])
    r, p, y = change
    return np.array([r - y * sp, p * cr + y * cp * sr, y * cp * cr - p * sr])


# -- paths in the default room ----------------------------------------------------------------------------------------

KNOT = 0.25  # [s] between knots
RAMP = 1.0  # [s] from standing still to full speed
HAND = 1.3  # [m]: the height of a camera in a hand


def sideways(duration: float = 12.0, speed: float = 0.5, swing: float = 0.9) -> CameraPath:
    """To and fro in front of the wall x = 3 with its posters and the window, facing it.

    From y = swing to -swing [m] and back, with `speed` [m/s] in the middle.
    """
    times = _times(duration)
    return CameraPath(times, _swept(times, speed, swing))


def still_then_move(duration: float = 12.0, still: float = 1.0, speed: float = 0.5, swing: float = 0.9) -> CameraPath:
    """As sideways, after so many seconds [s] in which nothing moves (by more than a hundredth of a millimetre)."""
    times = np.linspace(0, duration, 2 * len(_times(duration)) - 1)
    moving = np.maximum(times - still, 0)
    return CameraPath(times, _swept(np.where(moving < RAMP, moving**2 / (2 * RAMP), moving - RAMP / 2), speed, swing))


def _swept(times: Array, speed: float, swing: float) -> Array:
    y = swing * np.cos(speed / swing * times)
    return _hand(times, np.column_stack([0 * y + 0.9, y, 0 * y, 0 * y, 0 * y, 0 * y]))


def around(duration: float = 30.0, radius: float = 1.0) -> CameraPath:
    """Once round the room, facing outwards, back to the starting pose, then half a second more of it."""
    times = _times(duration)
    turn = 2 * np.pi * times / (duration - 0.5)
    flat = np.column_stack([radius * np.cos(turn), radius * np.sin(turn), 0 * turn, 0 * turn, 0.12 + 0 * turn, turn])
    return CameraPath(times, _hand(times, flat, period=duration - 0.5))


def _times(duration: float) -> Array:
    if not duration >= 4 * KNOT:
        raise SlamlibError(f"a path takes {4 * KNOT:g} s or more, got {duration}")
    return np.linspace(0, duration, round(duration / KNOT) + 1)


def _hand(times: Array, knots: Array, period: float = 12.0) -> Array:
    """The knots with a hand's slow sway, a few centimetres and degrees, which repeats after `period` [s]."""
    waves = np.array([[3, 0.025], [5, 0.03], [7, 0.03], [5, 0.02], [4, 0.02], [6, 0.025]])
    phases = np.array([0.3, 1.1, 2.0, 0.7, 1.9, 2.6])
    rounds = waves[:, 0] * max(1.0, round(period / 12.0))
    sway = waves[:, 1] * np.sin(2 * np.pi * times[:, None] / period * rounds + phases)
    return knots + sway + np.array([0, 0, HAND, 0, 0, 0])


PATHS: dict[str, Callable[..., CameraPath]] = {"sideways": sideways, "round": around, "still": still_then_move}


def path(name: str, **arguments: Any) -> CameraPath:
    """The path of a name (PATHS) through the default room: path("sideways", duration=12)."""
    if name not in PATHS:
        raise UnknownNameError.of("path", name, PATHS)
    return PATHS[name](**arguments)
