"""Dataclasses as plain data (JSON, TOML, NAME=VALUE): one writer, and one reader that names the key that is wrong.

The type of a field determines what it accepts: bool, int, float, str, tuples, dictionaries, other dataclasses, None.
Limits and lists of names are annotations: Annotated[float, Range(gt=0, unit="m")], Annotated[str, OneOf(NAMES)]. None
is not written; therefore a field that may be None is None when plain data lacks it. Arrays are packed without loss.
"""

import base64
import zlib
from collections.abc import Callable, Collection
from contextlib import suppress
from dataclasses import MISSING, Field, dataclass, fields, is_dataclass
from functools import cache
from inspect import signature
from math import inf, isfinite
from numbers import Integral, Real
from operator import ge, gt, le, lt
from types import NoneType, UnionType
from typing import Annotated, Any, Self, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from slamlib.errors import SlamlibError, UnknownNameError, entry

T = TypeVar("T")


_LIMITS = {"ge": ("{:g} or more", ge), "gt": ("above {:g}", gt), "le": ("up to {:g}", le), "lt": ("below {:g}", lt)}


@dataclass(frozen=True)
class Range:
    """Limits of a number, in this unit: at least ge, or above gt; at most le, or below lt, which may be infinity."""

    ge: float | None = None
    gt: float | None = None
    le: float | None = None
    lt: float | None = None
    unit: str = ""

    def check(self, value: float, path: str) -> None:
        """Raise SlamlibError for a number outside the limits."""
        limits = [(*_LIMITS[name], limit) for name in _LIMITS if (limit := getattr(self, name)) is not None]
        if not all(holds(value, limit) for _, holds, limit in limits):
            words = " and ".join(text.format(limit) for text, _, limit in limits if isfinite(limit)) or "finite"
            _refuse(path, words + f" [{self.unit}]" * bool(self.unit), value)


@dataclass(frozen=True, eq=False)
class OneOf:
    """A text must be one of these names, or of the keys of a registry."""

    names: Collection[str]

    def check(self, value: str, path: str) -> None:
        """Raise UnknownNameError, with the nearest name."""
        if value not in self.names:
            raise UnknownNameError.of(path, value, self.names)


@dataclass(frozen=True)
class Length:
    """A list must have one of these lengths."""

    lengths: tuple[int, ...]

    def check(self, value: tuple[Any, ...], path: str) -> None:
        """Raise SlamlibError for another length."""
        if len(value) not in self.lengths:
            _refuse(path, f"a list of {' or '.join(map(str, self.lengths))}", value)


class FileName:
    """A text must be usable as a part of a file's name."""

    def check(self, value: str, path: str) -> None:
        """Raise SlamlibError for an empty text, one that starts with a dot, or has signs that a path could need."""
        if not value or value.startswith(".") or not all(c.isalnum() or c in "-_+. ()=," for c in value):
            _refuse(path, "a name of letters, digits, blanks and -_+.()=,", value)


Count = Annotated[int, Range(ge=0)]
Whole = Annotated[int, Range(gt=0)]
NotNegative = Annotated[float, Range(ge=0)]
Magnitude = Annotated[float, Range(ge=0, lt=inf)]
Finite = Annotated[float, Range(gt=-inf, lt=inf)]
Positive = Annotated[float, Range(gt=0, lt=inf)]
Share = Annotated[float, Range(ge=0, le=1)]


class Plain:
    """A dataclass that can be written as plain data and read from it; what is as by default is not shown."""

    def __repr__(self) -> str:
        return call_of(self)

    def to_dict(self) -> dict[str, Any]:
        """Return plain data for JSON or TOML; fields that are None are left out."""
        return {f.name: written(v) for f in fields(self) if (v := getattr(self, f.name)) is not None}  # type: ignore[arg-type]

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> Self:
        """Read from plain data; missing fields get their default, or None where that is allowed.

        Raises SlamlibError for an unknown, missing or wrong key, named by its path.
        """
        return read(cls, data, cls.__name__.lower())


def call_of(value: Any) -> str:
    """The call that makes a dataclass, without the arguments that have their default."""
    own = ((f, repr(getattr(value, f.name))) for f in fields(value))
    shown = [f"{f.name}={text}" for f, text in own if text != repr(default_of(f))]
    return f"{type(value).__name__}({', '.join(shown)})"


def default_of(field: Field[Any]) -> Any:
    """The default of a field; MISSING where it has none."""
    return field.default if field.default_factory is MISSING else field.default_factory()


def written(value: Any) -> Any:
    """Return the plain data of a dataclass and its fields, lists as tuples; fields that are None are left out."""
    if isinstance(value, np.ndarray):
        text = base64.b64encode(zlib.compress(value.tobytes(), 1)).decode()
        return {"dtype": value.dtype.str, "shape": value.shape, "zlib": text}
    if is_dataclass(value):
        return value.to_dict() if isinstance(value, Plain) else Plain.to_dict(value)  # type: ignore[arg-type]
    if isinstance(value, dict):
        return {name: written(v) for name, v in value.items()}
    return tuple(map(written, value)) if isinstance(value, list | tuple) else value


def unpacked(data: Any, path: str = "array") -> NDArray[Any]:
    """Return the array, read-only, that `written` packed. Raises SlamlibError for anything else."""
    try:
        content = zlib.decompress(base64.b64decode(data["zlib"]))
        return np.frombuffer(content, data["dtype"]).reshape(data["shape"])
    except (KeyError, TypeError, ValueError, zlib.error) as error:
        raise SlamlibError(f"{path} is no packed array: {error!r}") from None


def read(kind: type[T], data: Any, path: str = "") -> T:
    """Read a dataclass from plain data. Raises SlamlibError for an unknown, missing or wrong key, named by its path."""
    path = path or kind.__name__
    given = read_fields(kind, data, path)
    for f in fields(kind):  # type: ignore[arg-type]
        if f.name not in given and NoneType in get_args(f.type):
            given[f.name] = None
        elif f.name not in given and default_of(f) is MISSING:
            raise SlamlibError(f"{path}: {f.name} is missing")
    return kind(**given)


@cache
def _hints(kind: Any) -> dict[str, Any]:
    """The types of a dataclass's fields, or of a function's arguments; Any where none is written."""
    hints = dict.fromkeys(signature(kind).parameters, Any) | get_type_hints(kind, include_extras=True)
    return {name: hint for name, hint in hints.items() if name != "return"}


def read_fields(kind: Any, data: Any, path: str = "") -> dict[str, Any]:
    """Read some fields of a dataclass, or arguments of a function, from plain data. Raises SlamlibError as `read`."""
    path, hints = path or kind.__name__, _hints(kind)
    if not isinstance(data, dict):
        _refuse(path, "values by name", data)
    known = {name: entry(f"key of {path}", name, hints) for name in data}
    return {name: _read(hint, data[name], f"{path}.{name}") for name, hint in known.items()}


def check(value: Any) -> None:
    """For __post_init__ of a frozen dataclass: check its fields, convert lists and arrays to tuples. SlamlibError."""
    for name, found in read_fields(type(value), {f.name: getattr(value, f.name) for f in fields(value)}).items():
        object.__setattr__(value, name, found)


_SCALARS: dict[Any, tuple[str, Callable[[Any], bool]]] = {
    bool: ("True or False", lambda v: isinstance(v, bool)),
    int: ("a whole number", lambda v: isinstance(v, Integral) and not isinstance(v, bool)),
    float: ("a number", lambda v: isinstance(v, Real) and not isinstance(v, bool)),
    str: ("a text", lambda v: isinstance(v, str)),
    NoneType: ("None", lambda v: v is None),
}


def _read(hint: Any, value: Any, path: str) -> Any:
    """Convert a value to the type of its field."""
    if get_origin(hint) is np.ndarray:
        return value if isinstance(value, np.ndarray) else unpacked(value, path)
    value = value.tolist() if hasattr(value, "tolist") else value
    kind, inner = get_origin(hint) or hint, get_args(hint)
    if kind is Any:
        return written(value)
    if kind is Annotated:
        value = _read(inner[0], value, path)
        inner[1].check(value, path)
        return value
    if kind in (Union, UnionType):  # None first: the error is the last one's
        *others, last = sorted(inner, key=lambda h: h is not NoneType)
        for other in others:
            with suppress(SlamlibError):
                return _read(other, value, path)
        return _read(last, value, path)
    if is_dataclass(kind):
        return value if isinstance(value, kind) else read(kind, value, path)  # type: ignore[arg-type]
    if kind is dict:
        found = value if isinstance(value, dict) else _refuse(path, "values by name", value)
        return {_read(inner[0], name, path): _read(inner[1], v, f"{path}.{name}") for name, v in found.items()}
    if kind is tuple:
        endless = inner[-1] is Ellipsis
        if endless and float in (inner[0], *get_args(inner[0])) and _SCALARS[float][1](value):  # one number for all
            value = (value,)
        if not isinstance(value, list | tuple) or not (endless or len(value) == len(inner)):
            _refuse(path, "a list" if endless else f"{len(inner)} values", value)
        each = inner[:1] * len(value) if endless else inner
        return tuple(_read(h, v, f"{path}[{i}]") for i, (h, v) in enumerate(zip(each, value, strict=True)))
    words, fits = _SCALARS[kind]
    return value if fits(value) else _refuse(path, words, value)


def _refuse(path: str, wanted: str, value: Any) -> Any:
    raise SlamlibError(f"{path} should be {wanted}, got {value!r}")
