"""What a motion model must offer."""

from dataclasses import dataclass

from slamlib.model import Model
from slamlib.spaces import Space


@dataclass(frozen=True)
class Motion:
    """A motion: name, space of the robot's state, size of the control, and the model step(state, control, dt)."""

    name: str
    space: Space
    control: int
    step: Model
