"""The properties that checks are made of; each either notes that it holds or raises Rejected."""

import contextlib
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array


class Rejected(SlamlibError):
    """A solution lacks a property: the message says which, for what input, and what was found."""

    def _render_traceback_(self) -> list[str]:
        """What IPython shows: the message, and where the reader's function failed; not how the check is built."""
        lines = [f"Rejected: {self}"]
        if self.__cause__ is not None:
            frames = traceback.extract_tb(self.__cause__.__traceback__)
            own = [f for f in frames if not f.filename.startswith(_HERE)]
            lines += ["", *"".join(traceback.format_list(own)).splitlines()]
        return lines


class Found:
    """What has been found out about a candidate so far."""

    def __init__(self, candidate: Any) -> None:
        self.candidate = _Guarded(candidate) if callable(candidate) else candidate
        self.lines: list[str] = []


_HERE = str(Path(__file__).parent)
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

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        given = [*arguments, *named.values()]
        before = [[np.array(a, copy=True) for a in _arrays(g)] for g in given]
        shown = ", ".join([*map(_shown, arguments), *(f"{k}={_shown(v)}" for k, v in named.items())])
        try:
            result = self.function(*arguments, **named)
        except Exception as error:
            raise Rejected(f"for the input ({shown}) your function raised {type(error).__name__}: {error}") from error
        for old, new in zip(before, given, strict=True):
            for was, now in zip(old, _arrays(new), strict=False):
                if was.shape != now.shape or was.tobytes() != now.tobytes():
                    raise Rejected(f"your function changed its argument in place; it was {_shown(was)}: work on a copy")
        if result is None:
            raise Rejected(f"for the input ({shown}) your function returned None: is a `return` missing?")
        return result


def _arrays(value: Any) -> list[Array]:
    """The arrays in an argument, also those in its lists and tuples."""
    if isinstance(value, np.ndarray):
        return [value]
    return [a for item in value for a in _arrays(item)] if isinstance(value, list | tuple) else []


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
    """Two arrays agree: to `tolerance` of the largest expected entry, absolutely where that is below one."""
    expected = np.asarray(expected, dtype=float)
    found = array_of(found, expected.shape, what)
    scale = max(1.0, float(np.max(np.abs(expected), initial=0)))
    worst = float(np.max(np.abs(found - expected), initial=0)) / scale
    where = f" for {given}" if given else ""
    holds(worst <= tolerance, what, f"differs{where}: found {_shown(found)}, the property asks for {_shown(expected)}")


def jacobian_matches(
    jacobian: Array, function: Callable[[Array], Any], at: Array, what: str, *, tolerance: float = 1e-6
) -> None:
    """A Jacobian agrees with central differences of a function of one vector.

    Differences, not the complex step: a reader's own function may use a norm or an arctangent, for which that is
    silently wrong.
    """
    same(jacobian, differences(function, at), what, given=_shown(np.asarray(at)), tolerance=tolerance)


def differences(function: Callable[[Array], Any], at: Array) -> Array:
    """Jacobian of a function of one vector by central differences, about nine digits."""
    at = np.asarray(at, dtype=float)
    stops = [(np.asarray(function(at + step)), np.asarray(function(at - step))) for step in 1e-6 * np.eye(at.size)]
    return np.stack([(ahead - behind) / 2e-6 for ahead, behind in stops], axis=-1)


def pair(value: Any, what: str) -> tuple[Any, Any]:
    """The two things that a candidate should return, named in `what`, or Rejected."""
    if not isinstance(value, tuple) or len(value) != 2:
        raise Rejected(f"your function should return {what}, but returned {type(value).__name__}")
    return value


def covariance(matrix: Any, size: int, what: str) -> Array:
    """A symmetric matrix without negative eigenvalues."""
    P = array_of(matrix, (size, size), what)
    scale = max(float(np.abs(P).max()), 1e-300)
    holds(np.abs(P - P.T).max() <= 1e-9 * scale, f"{what} is symmetric", f"found {_shown(P)}")
    least = float(np.linalg.eigvalsh((P + P.T) / 2)[0])
    holds(least >= -1e-9 * scale, f"{what} has no negative eigenvalue", f"the smallest is {least:.4g}")
    return P


def rotation_matrix(matrix: Any, what: str, *, tolerance: float = 1e-9) -> Array:
    """A matrix (3, 3), or (2, 2), that turns: orthogonal, and with determinant +1."""
    R = array_of(matrix, (2, 2) if np.shape(matrix) == (2, 2) else (3, 3), what)
    error = np.abs(R @ R.T - np.eye(len(R))).max()
    holds(error <= tolerance, f"{what} is orthogonal", f"R R' differs from the identity by {error:.3g}: {_shown(R)}")
    holds(np.linalg.det(R) > 0, f"{what} does not mirror", "its determinant is -1")
    return R


def round_trip(there: Callable[[Any], Any], back: Callable[[Any], Any], inputs: Iterable[Array], what: str) -> None:
    """`back` undoes `there` for each input."""
    for value in inputs:
        same(back(there(value)), value, what, given=_shown(value))


def inside_band(value: float, limits: tuple[float, float], what: str) -> None:
    """A statistic lies within its band."""
    found = float(array_of(value, (), what))
    low, high = limits
    holds(low <= found <= high, what, f"found {found:.4g}, outside the band from {low:.4g} to {high:.4g}")


def least_squares(
    mean: Array, covariance: Array, measurements: Iterable[tuple[Array, Array, Array]]
) -> tuple[Array, Array]:
    """Mean (n,) and covariance (n, n) by one batch of normal equations: what any linear filter must end with.

    measurements: (H (m, n), y (m,), R (m, m)) each. It shares no formula with the Kalman gain.
    """
    information = np.linalg.inv(covariance)
    vector = information @ np.asarray(mean, dtype=float)
    for H, y, R in measurements:
        weighted = np.linalg.solve(R, np.atleast_2d(H)).T
        information, vector = information + weighted @ np.atleast_2d(H), vector + weighted @ np.atleast_1d(y)
    final = np.linalg.inv(information)
    return final @ vector, (final + final.T) / 2


def _shown(value: Any) -> str:
    if isinstance(value, np.ndarray | Sequence) and not isinstance(value, str):
        return np.array2string(np.asarray(value), precision=4, suppress_small=True, threshold=12).replace("\n", "")
    return f"{value:.6g}" if isinstance(value, float) else repr(value)[:80]
