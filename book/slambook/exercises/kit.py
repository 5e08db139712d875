"""What checks are written in: exercises and their cases, and properties, which are noted or raise Rejected."""

import functools
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

Candidate = Any  # the reader's function, or what else an exercise asks for
Rng = np.random.Generator
Case = TypeVar("Case")
KNOWN: dict[str, tuple[str, Callable[[Candidate], None]]] = {}
_HERE = str(Path(__file__).parent)


def exercise(number: str, title: str, seed: int | None = None) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Register a check: a function of the candidate, and of a generator with the seed, that calls the properties."""

    def register(function: Callable[..., None]) -> Callable[..., None]:
        if number in KNOWN and KNOWN[number][1].__module__ != function.__module__:
            raise SlamlibError(f"exercise {number} is registered twice: give each exercise a number of its own")

        @functools.wraps(function)
        def checker(candidate: Candidate) -> None:
            function(candidate, *([] if seed is None else [np.random.default_rng(seed)]))

        KNOWN[number] = title, checker
        return function

    return register


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
    """What has been found out about a candidate so far, and the case that it is judged for."""

    def __init__(self, candidate: Candidate) -> None:
        self.candidate = functools.partial(_guarded, candidate) if callable(candidate) else candidate
        self.lines: list[str] = []
        self.case = ""
        self.asked: Callable[[], str] | None = None  # writes the input of its last call


current: ContextVar[Found] = ContextVar("current")
current.set(Found(None))  # of a property that is called outside of a check


def _guarded(function: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
    """The reader's function: failures of any kind become readable, and its arguments must stay as they are."""
    given = [*arguments, *named.values()]
    before, names = _copied(given), [*[""] * len(arguments), *(f"{name}=" for name in named)]

    def shown() -> str:  # only of an input that is told: to write arrays takes longer than most functions do
        return ", ".join(name + _shown(value) for name, value in zip(names, before, strict=True))

    current.get().asked = shown
    try:
        result = function(*arguments, **named)
    except Exception as error:
        raise Rejected(f"for the input ({shown()}) your function raised {type(error).__name__}: {error}") from error
    for was, now in zip(_arrays(before), _arrays(given), strict=False):
        if was.shape != now.shape or was.tobytes() != now.tobytes():
            raise Rejected(f"your function changed its argument in place; it was {_shown(was)}: work on a copy")
    if result is None:
        raise Rejected(f"for the input ({shown()}) your function returned None: is a `return` missing?")
    return result


def _copied(value: Any) -> Any:
    """The value with copies of its arrays, also of those in its lists and tuples."""
    if isinstance(value, np.ndarray):
        return value.copy()
    return [_copied(item) for item in value] if isinstance(value, list | tuple) else value


def _arrays(value: Any) -> list[Array]:
    """The arrays in an argument, also those in its lists and tuples."""
    if isinstance(value, np.ndarray):
        return [value]
    return [a for item in value for a in _arrays(item)] if isinstance(value, list | tuple) else []


# -- cases -------------------------------------------------------------------------------------------------------------


def cases(values: Iterable[Case], told: str = "") -> Iterator[Case]:
    """Each of the values, a rejection being *for* it: `told`, with its numbers filled in."""
    for value in values:
        numbers = value if isinstance(value, tuple) else (value,)
        given(told.format(*(_shown(n) if isinstance(n, np.ndarray) else n for n in numbers)))
        yield value
    given("")


def given(told: str) -> None:
    """What the properties that follow are judged for; the end of the cases ends it too."""
    current.get().case = told


def random_covariance(rng: Rng, n: int, least: float = 0.0) -> Array:
    """A full covariance (n, n), `least` on its diagonal included, which keeps it away from a singular one."""
    root = rng.standard_normal((n, n))
    return np.asarray(root @ root.T + least * np.eye(n))


def least_squares(mean: Array, covariance: Array, measurements: Iterable[tuple[Any, Any, Any]]) -> tuple[Array, Array]:
    """Mean (n,) and covariance (n, n) by one batch of normal equations: what any linear filter must end with.

    measurements: (H (m, n), y (m,), R (m, m)) each, or a row, a number and its variance. It shares no formula with the
    Kalman gain.
    """
    information = np.linalg.inv(covariance)
    vector = information @ np.asarray(mean, dtype=float)
    for row, y, R in measurements:
        H = np.atleast_2d(np.asarray(row, dtype=float))
        weighted = np.linalg.solve(np.atleast_2d(R), H).T
        information, vector = information + weighted @ H, vector + weighted @ np.atleast_1d(y)
    final = np.linalg.inv(information)
    return final @ vector, (final + final.T) / 2


# -- what was returned -------------------------------------------------------------------------------------------------


def array_of(value: Any, shape: tuple[int, ...], what: str) -> Array:
    """The value as finite numbers of this shape, or Rejected."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise Rejected(f"{what} should be an array of numbers of shape {shape}, got {type(value).__name__}") from None
    if array.shape != shape:
        raise Rejected(f"{_of_input()}{what} should have shape {shape}, but has shape {array.shape}")
    if not np.isfinite(array).all():
        raise Rejected(f"{_of_input()}{what} holds nan or infinity: {_shown(array)}")
    return array


def _of_input() -> str:
    """The input of the candidate's last call, which its result was returned for."""
    asked = current.get().asked
    return "" if asked is None else f"for the input ({asked()}): "


def is_finite(value: Any) -> bool:
    """Whether these are finite numbers, or no numbers at all: of what kind they are, array_of says."""
    try:
        return bool(np.isfinite(np.asarray(value, dtype=float)).all())
    except (TypeError, ValueError):
        return True


def number(value: Any, what: str) -> float:
    """The value as one finite number, or Rejected."""
    return float(array_of(value, (), what))


def parts(value: Any, shapes: Mapping[str, tuple[int, ...] | None]) -> list[Any]:
    """The things that a candidate should return together, each an array of its shape, or anything; or Rejected.

    A tuple, a list and an array are as good.
    """
    value = [*value] if isinstance(value, np.ndarray) and value.ndim else value
    if not isinstance(value, tuple | list) or len(value) != len(shapes):
        group = {2: "pair", 3: "triple"}.get(len(shapes), "tuple")
        found = f"{len(value)} things" if isinstance(value, tuple | list) else type(value).__name__
        raise Rejected(f"your function should return the {group} ({', '.join(shapes)}), but returned {found}")
    return [v if s is None else array_of(v, s, what) for v, (what, s) in zip(value, shapes.items(), strict=True)]


# -- properties --------------------------------------------------------------------------------------------------------


def holds(condition: Any, what: str, otherwise: str = "it is not so") -> None:
    """Note a property, or reject with the reason."""
    found = current.get()
    if not condition:
        found.lines = [line for line in found.lines if line != what]  # it held for earlier cases, not for all
        raise Rejected(f"{what}{', for ' if found.case else ''}{found.case}: {otherwise}")
    if what not in found.lines:
        found.lines.append(what)


def same(found: Any, expected: Any, what: str, tolerance: float = 1e-9) -> None:
    """Two arrays agree: to `tolerance` of the largest expected entry, absolutely where that is below one."""
    expected = np.asarray(expected, dtype=float)
    found = array_of(found, expected.shape, what)
    scale = max(1.0, float(np.max(np.abs(expected), initial=0)))
    worst = float(np.max(np.abs(found - expected), initial=0)) / scale
    agree = worst <= tolerance
    holds(agree, what, "" if agree else _difference(found, expected))


def _difference(found: Array, expected: Array) -> str:
    """Both arrays, with as many digits as tell them apart."""
    pairs = [(_shown(found, digits), _shown(expected, digits)) for digits in (4, 8, 12, 17)]
    unsigned = ({text.replace("-0.", "0.").replace(" ", "") for text in pair} for pair in pairs)  # -0 is 0
    one, other = next((p for p, texts in zip(pairs, unsigned, strict=True) if len(texts) > 1), pairs[-1])
    return f"differs: found {one}, the property asks for {other}"


def between(value: Any, low: float, high: float, what: str) -> None:
    """A number, or each of several, lies within its band."""
    found = array_of(value, np.shape(value), what)
    inside = np.all((low <= found) & (found <= high))
    holds(inside, what, f"found {_shown(found[()])}, outside the band from {low:.4g} to {high:.4g}")


def covariance(matrix: Any, size: int, what: str = "the covariance") -> Array:
    """A symmetric matrix without negative eigenvalues."""
    P = array_of(matrix, (size, size), what)
    scale = max(float(np.abs(P).max()), 1e-300)
    holds(np.abs(P - P.T).max() <= 1e-9 * scale, f"{what} is symmetric", f"found {_shown(P)}")
    least = float(np.linalg.eigvalsh((P + P.T) / 2)[0])
    holds(least >= -1e-9 * scale, f"{what} has no negative eigenvalue", f"the smallest is {least:.4g}")
    return P


def rotation_matrix(matrix: Any, what: str) -> Array:
    """A matrix (3, 3), or (2, 2), that turns: orthogonal, and with determinant +1."""
    R = array_of(matrix, (2, 2) if np.shape(matrix) == (2, 2) else (3, 3), what)
    error = np.abs(R @ R.T - np.eye(len(R))).max()
    holds(error <= 1e-9, f"{what} is orthogonal", f"R R' differs from the identity by {error:.3g}: {_shown(R)}")
    holds(np.linalg.det(R) > 0, f"{what} does not mirror", "its determinant is -1")
    return R


def _shown(value: Any, digits: int = 4) -> str:
    if isinstance(value, np.ndarray | Sequence) and not isinstance(value, str):
        text = np.array2string(np.asarray(value), precision=digits, suppress_small=digits == 4, threshold=12)
        return text.replace("\n", "")
    return f"{value:.6g}" if isinstance(value, float) else repr(value)[:80]
