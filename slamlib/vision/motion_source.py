"""Where a run on pictures has the robot's motion from: here from nobody; slamlib.vision.stereo has others."""

from typing import Any

from slamlib.data.records import Control
from slamlib.manifolds import Image
from slamlib.slam import Slam
from slamlib.slam.data_association.front_end import FrontEnd
from slamlib.vision.front_end import Stopwatch


class MotionSource:
    """Says how the robot moves from picture to picture; this one, nothing: the noise of its motion says what may be.

    name: that it is chosen by. front_end: the filter's, of the sensor that made the pictures. seconds: spent so far, by
    part, beside the front end's.
    """

    name = "constant-velocity"

    def __init__(self, front_end: FrontEnd) -> None:
        self.front_end = front_end
        self.seconds = Stopwatch()

    def control(self, image: Image | None, dt: float, slam: Slam) -> Control | None:
        """Of the step of dt [s] to this picture, asked once, before Slam.step; None: zeros, with the robot's noise."""
        return None

    def counts(self) -> dict[str, float]:
        """Columns of the run's history that are not the filter's own."""
        return {}

    def dump(self) -> Any:
        """Its state as plain data, beside that of the front end, which the filter's file holds."""

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
