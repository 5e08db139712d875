"""The interface of a motion model."""

from dataclasses import dataclass

from slamlib.manifolds import Manifold
from slamlib.model import Model


@dataclass(frozen=True)
class Motion:
    """A motion: name, manifold of the robot's state, size of the control, and the model step(state, control, dt).

    angles: which numbers of the control are angles; a setup gives those in degrees. Default: of six the last three.
    """

    name: str
    manifold: Manifold
    control: int
    step: Model
    angles: tuple[int, ...] = (3, 4, 5)
