"""A fingerprint of a model's definition and of all that it calls, to detect generated code that is out of date."""

import functools
import hashlib
import inspect
import textwrap
from collections.abc import Callable
from types import CodeType, FunctionType
from typing import Any, Protocol

import numpy as np

from slamlib.manifolds import Manifold
from slamlib.models.argument import Argument


class Defined(Protocol):
    """What has a definition: a Model."""

    name: str
    function: Callable[..., Any]
    arguments: list[Argument]
    result: Argument | None

    @property
    def module(self) -> str:
        """The module of the definition."""


@functools.cache
def of(model: Defined) -> str | None:
    """Sixteen hexadecimal digits for a model; None where its source is not available (and so was not edited)."""
    try:
        text = "\n".join(_lines(model, set()))
    except (OSError, TypeError):
        return None
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _lines(model: Defined, seen: set[int]) -> list[str]:
    """Source of the definition, its arguments, and the same of every model, function and constant it uses."""
    if id(model) in seen:
        return []
    seen.add(id(model))
    lines = [source(model.function), repr(model.arguments), repr(model.result)]
    for argument in [*model.arguments, *([model.result] if model.result else [])]:
        lines += [line for m in _manifold_models(argument.manifold) for line in _lines(m, seen)]
    for name in sorted(_names(model.function.__code__)):
        value: Any = model.function.__globals__.get(name)
        if hasattr(value, "definition"):
            lines += _lines(value, seen)
        elif isinstance(value, FunctionType) and not value.__module__.startswith(("numpy", "slamlib.analytic")):
            lines.append(source(value))
        elif isinstance(value, int | float | tuple | np.ndarray):
            lines.append(f"{name} = {value!r}")
    return lines


def source(function: Callable[..., Any]) -> str:
    """The function's source, from its first decorator on, without indentation."""
    return textwrap.dedent(inspect.getsource(function)).replace("\r\n", "\n").strip()


def _names(code: CodeType) -> set[str]:
    inner = [c for c in code.co_consts if isinstance(c, CodeType)]
    return set(code.co_names).union(*map(_names, inner))


def _manifold_models(manifold: Manifold | None) -> list[Defined]:
    parts = getattr(manifold, "parts", [])
    own: list[Any] = [
        m for m in (getattr(manifold, "plus", None), getattr(manifold, "minus", None)) if hasattr(m, "definition")
    ]
    return own + [m for part in parts for m in _manifold_models(part)]
