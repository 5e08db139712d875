"""What no measurement of landmarks can tell: how a small motion of the whole world changes the errors of a state.

A model moved(motion, state) says how a state moves with the world; N is its derivative by the motion, where nothing has
moved yet. Of points and directions N is affine in the state: one small product gives it of many states.
"""

from functools import lru_cache
from typing import NamedTuple, Protocol

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, read_only
from slamlib.models.argument import Argument
from slamlib.models.in_memory import is_affine
from slamlib.models.kernel import Kernel
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
    moved = check_moved(kind)
    rule = _rule(moved, states.shape[-1])
    if states.ndim == 1:
        return np.array(rule.kernel.function(states.tolist()), dtype=float).reshape(-1, 6)
    if rule.affine is None:
        return _generator(moved, states.tobytes(), states.shape)
    constant, slope = rule.affine
    return (states @ slope + constant).reshape(*states.shape[:-1], -1, 6)


def change_of_generator(kind: Movable, before: Array, after: Array) -> Array:
    """N of the states `after` (..., size) less that of those `before`, (..., dof, 6). Raises SlamlibError."""
    affine = _rule(check_moved(kind), after.shape[-1]).affine
    if affine is None:
        return generator(kind, after) - generator(kind, before)
    return ((after - before) @ affine[1]).reshape(*after.shape[:-1], -1, 6)


def changing_columns(kind: Movable, size: int) -> frozenset[int]:
    """The columns of N that are not the same for all states of this size. Raises SlamlibError."""
    return _rule(check_moved(kind), size).columns


class _Rule(NamedTuple):
    """How a model gives N: its entries, the columns that depend on the state, and of an affine N the constant
    (dof * 6,) and the slope (size, dof * 6)."""

    kernel: Kernel
    columns: frozenset[int]
    affine: tuple[Array, Array] | None


@lru_cache
def _rule(moved: Moved, size: int) -> _Rule:
    entries = moved.entries_where(ORIGIN)
    of_unknown = entries([np.nan] * size)  # what depends on the state is as unknown
    columns = frozenset(place % 6 for place, entry in enumerate(of_unknown) if np.isnan(entry))
    kernel = Kernel(entries, "moved", [Argument("state", size)], [(len(of_unknown) // 6, 6)])
    if not is_affine(entries, size):
        return _Rule(kernel, columns, None)
    constant, *units = (np.array(entries(state), dtype=float) for state in np.eye(size + 1, size, k=-1).tolist())
    return _Rule(kernel, columns, (constant, np.array(units) - constant))


@lru_cache(maxsize=32)  # by the numbers themselves: most updates begin with the landmarks that the last one left
def _generator(moved: Moved, states: bytes, shape: tuple[int, ...]) -> Array:
    given = np.frombuffer(states).reshape(shape)
    try:
        (N,) = _rule(moved, shape[-1]).kernel([given])
    except SingularPointError:
        return moved.jac_where(ORIGIN, given)  # which says of what part
    return read_only(N)
