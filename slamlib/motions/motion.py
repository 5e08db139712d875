"""The interface of a motion model."""

from dataclasses import dataclass
from typing import Any

from slamlib.geometry.pose import compose
from slamlib.manifolds import Manifold
from slamlib.models import Model
from slamlib.registry import TypeDescription


@dataclass(frozen=True)
class Motion(TypeDescription):
    """A motion: name, manifold of the robot's state, size of the control, and the model step(state, control, dt).

    moved(motion, state): the state after a rigid motion (7,) of the world; the default is that of a pose.
    angles: which numbers of the control are angles; a setup gives those in degrees. Default: of six the last three.
    """

    name: str
    manifold: Manifold
    control: int
    step: Model
    moved: Any = compose
    angles: tuple[int, ...] = (3, 4, 5)
