"""What no measurement of landmarks can tell: how a small motion of the whole world changes the errors of a state."""

from functools import lru_cache
from typing import Protocol

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, read_only
from slamlib.registry import Moved


class Movable(Protocol):
    """A parametrization, or a motion, as far as the world's motion is concerned."""

    @property
    def name(self) -> str: ...

    @property
    def moved(self) -> Moved | None: ...


def check_moved(kind: Movable) -> Moved:
    """The model moved(motion, state) of a parametrization, or a motion. Raises SlamlibError where there is none."""
    moved: Moved | None = getattr(kind, "moved", None)
    if moved is None:
        raise SlamlibError(
            f"the error that this filter keeps needs the model moved(motion, state) of {kind.name}, which has none: "
            "write it, or use the option error='local'"
        )
    return moved


def generator(kind: Movable, states: Array) -> Array:
    """N (..., dof, 6) of states (..., size) of a parametrization or a motion. Raises SlamlibError."""
    return _generator(check_moved(kind), states.tobytes(), states.shape)


@lru_cache(maxsize=32)  # by the numbers themselves: most updates begin with the landmarks that the last one left
def _generator(moved: Moved, states: bytes, shape: tuple[int, ...]) -> Array:
    return read_only(moved.jac_where(ORIGIN, np.frombuffer(states).reshape(shape)))
