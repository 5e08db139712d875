"""The motion of a step that nobody could tell: as the last one, and not well known."""

from typing import Any

import numpy as np

from slamlib.data.records import Control
from slamlib.manifolds import Array

UNKNOWN = (1.0, 0.3)  # [m], [rad]: standard deviations of a step of which there is no example
SHARE = 0.2  # of the newest change in the mean of their squares
SURPRISE = 9.0  # a motion is lost where it changes more than usual: variances are larger by so much


class Steady:
    """Remembers how controls (6,) change from step to step: displacement [m] and rotation [rad] by themselves."""

    def __init__(self) -> None:
        self.rate: Array | None = None  # the last control by its time
        self.changes: Array | None = None  # (2,) mean squares of a change of the rate, of one coordinate
        self.lost = 0

    def told(self, control: Control, dt: float) -> None:
        """A step whose control is known."""
        rate = control.value / dt
        if self.rate is not None:
            square = ((rate - self.rate) ** 2).reshape(2, 3).mean(1)
            before = square if self.changes is None else self.changes
            self.changes = before + SHARE * (square - before)
        self.rate, self.lost = rate, 0

    def untold(self, dt: float) -> Control:
        """The last control again, the less certain the more steps in a row were lost; a random walk of the rate."""
        self.lost += 1
        if self.rate is None:
            return Control(np.zeros(6), np.repeat(np.square(UNKNOWN), 3))
        example = np.square(self.rate).reshape(2, 3).mean(1) if self.changes is None else self.changes
        return Control(self.rate * dt, np.repeat(SURPRISE * self.lost * example * dt**2, 3))

    def dump(self) -> Any:
        """Plain data."""
        return [None if a is None else a.tolist() for a in (self.rate, self.changes)] + [self.lost]

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        self.rate, self.changes = (None if a is None else np.array(a) for a in state[:2])
        self.lost = state[2]
