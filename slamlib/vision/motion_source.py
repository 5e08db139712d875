"""Where a run on pictures has the robot's motion from: the contract, and the one that tells nothing."""

from typing import Any, Protocol

from slamlib.data.records import Control
from slamlib.manifolds import Image
from slamlib.slam import Slam
from slamlib.slam.data_association.front_end import FrontEnd


class MotionSource(Protocol):
    """Says how the robot moves from picture to picture, and looks for landmarks.

    name: that it is chosen by.
    """

    name: str

    @property
    def seconds(self) -> dict[str, float]:
        """Spent so far, by part, beside the front end's."""

    @property
    def front_end(self) -> FrontEnd:
        """The filter's, of the sensor that made the pictures."""

    def control(self, image: Image, dt: float, slam: Slam) -> Control | None:
        """Of the step of dt [s] to this picture, asked once, before Slam.step; None: zeros, with the robot's noise."""

    def counts(self) -> dict[str, float]:
        """Columns of the run's history that are not the filter's own."""

    def dump(self) -> Any:
        """Its state as plain data, beside that of the front end, which the filter's file holds."""

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""


class OwnMotion:
    """Nobody tells how the robot moves: the noise of its own motion says what may happen."""

    name = "constant-velocity"

    def __init__(self, front_end: FrontEnd) -> None:
        self.front_end = front_end
        self.seconds: dict[str, float] = {}

    def control(self, image: Image, dt: float, slam: Slam) -> Control | None:
        """None: what is not told is drawn with the noise of the robot's setup."""
        return None

    def counts(self) -> dict[str, float]:
        """None."""
        return {}

    def dump(self) -> Any:
        """It has no state."""

    def restore(self, state: Any) -> None:
        """It has no state."""
