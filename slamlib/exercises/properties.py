"""The properties that checks are made of; each either notes that it holds or raises Rejected."""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.spaces import Array


class Rejected(SlamlibError):
    """A solution lacks a property: the message says which, for what input, and what was found."""


class Found:
    """What has been found out about a candidate so far."""

    def __init__(self, candidate: Any) -> None:
        self.candidate = _Guarded(candidate) if callable(candidate) else candidate
        self.lines: list[str] = []


_current: ContextVar[Found | None] = ContextVar("_current", default=None)


@contextlib.contextmanager
def hold(candidate: Any) -> Iterator[Found]:
    """Collect the properties that hold for a candidate."""
    found = Found(candidate)
    token = _current.set(found)
    try:
        yield found
    finally:
        _current.reset(token)


class _Guarded:
    """The reader's function: failures of any kind become readable, and its arguments must stay as they are."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.function = function

    def __call__(self, *arguments: Any) -> Any:
        given = [np.array(a, copy=True) if isinstance(a, np.ndarray) else a for a in arguments]
        shown = ", ".join(_shown(a) for a in arguments)
        try:
            result = self.function(*arguments)
        except Exception as error:
            raise Rejected(f"for the input ({shown}) your function raised {type(error).__name__}: {error}") from error
        for before, after in zip(given, arguments, strict=True):
            if isinstance(before, np.ndarray) and not np.array_equal(before, after):
                raise Rejected(f"your function changed its argument in place; it was {_shown(before)}: work on a copy")
        if result is None:
            raise Rejected(f"for the input ({shown}) your function returned None: is a `return` missing?")
        return result


def holds(condition: Any, what: str, otherwise: str) -> None:
    """Note a property, or reject with the reason."""
    if not condition:
        raise Rejected(f"{what}: {otherwise}")
    found = _current.get()
    if found is not None and what not in found.lines:
        found.lines.append(what)


def array_of(value: Any, shape: tuple[int, ...], what: str) -> Array:
    """The value as finite numbers of this shape, or Rejected."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise Rejected(f"{what} should be an array of numbers of shape {shape}, got {type(value).__name__}") from None
    if array.shape != shape:
        raise Rejected(f"{what} should have shape {shape}, but has shape {array.shape}")
    if not np.isfinite(array).all():
        raise Rejected(f"{what} holds nan or infinity: {_shown(array)}")
    return array


def same(found: Any, expected: Any, what: str, *, given: str = "", tolerance: float = 1e-9) -> None:
    """Two arrays agree, relative to the larger one."""
    expected = np.asarray(expected, dtype=float)
    found = array_of(found, expected.shape, what)
    scale = max(1.0, float(np.max(np.abs(expected), initial=0)))
    worst = float(np.max(np.abs(found - expected), initial=0)) / scale
    where = f" for {given}" if given else ""
    holds(worst <= tolerance, what, f"differs{where}: found {_shown(found)}, the property asks for {_shown(expected)}")


def jacobian_matches(
    jacobian: Array, function: Callable[[Array], Any], at: Array, what: str, *, tolerance: float = 1e-6
) -> None:
    """A Jacobian agrees with central differences of a function of one vector."""
    at = np.asarray(at, dtype=float)
    columns = []
    for k in range(at.size):
        step = np.zeros_like(at)
        step[k] = 1e-6
        columns.append((np.asarray(function(at + step)) - np.asarray(function(at - step))) / 2e-6)
    same(jacobian, np.stack(columns, axis=-1), what, given=_shown(at), tolerance=tolerance)


def covariance(matrix: Any, size: int, what: str) -> Array:
    """A symmetric matrix without negative eigenvalues."""
    P = array_of(matrix, (size, size), what)
    scale = max(float(np.abs(P).max()), 1e-300)
    holds(np.abs(P - P.T).max() <= 1e-9 * scale, f"{what} is symmetric", f"found {_shown(P)}")
    least = float(np.linalg.eigvalsh((P + P.T) / 2)[0])
    holds(least >= -1e-9 * scale, f"{what} has no negative eigenvalue", f"the smallest is {least:.4g}")
    return P


def _shown(value: Any) -> str:
    if isinstance(value, np.ndarray | Sequence) and not isinstance(value, str):
        return np.array2string(np.asarray(value), precision=4, suppress_small=True, threshold=12).replace("\n", "")
    return f"{value:.6g}" if isinstance(value, float) else repr(value)[:80]
