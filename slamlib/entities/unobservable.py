"""What no measurement of landmarks can tell: how a small motion of the whole world changes the errors of a state."""

from functools import lru_cache
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, read_only


def check_moved(kind: Any) -> None:
    """Raise SlamlibError for a parametrization, or a motion, without the model moved(motion, state)."""
    if getattr(kind, "moved", None) is None:
        raise SlamlibError(
            f"the error that this filter keeps needs the model moved(motion, state) of {kind.name}, which has none: "
            "write it, or use the option error='local'"
        )


def generator(kind: Any, states: Array) -> Array:
    """N (..., dof, 6) of states (..., size) of a parametrization or a motion. Raises SlamlibError."""
    check_moved(kind)
    return _generator(kind.moved, states.tobytes(), states.shape)


@lru_cache(maxsize=32)  # by the numbers themselves: most updates begin with the landmarks that the last one left
def _generator(moved: Any, states: bytes, shape: tuple[int, ...]) -> Array:
    return read_only(moved.jac_where(ORIGIN, np.frombuffer(states).reshape(shape)))
