"""Plausible wrong solutions, which the exercises' checks must reject; a module for each chapter."""

import importlib
import pkgutil
from collections.abc import Callable
from typing import Any

WRONG: list[tuple[str, str, Any]] = []


def wrong(number: str, why: str) -> Callable[[Any], Any]:
    """Register a wrong solution of an exercise, with the reason why somebody would write it."""

    def register(function: Any) -> Any:
        WRONG.append((number, why, function))
        return function

    return register


def load() -> list[tuple[str, str, Any]]:
    """All wrong solutions: number, why it is plausible, the function."""
    for info in pkgutil.iter_modules(__path__):
        importlib.import_module(f"{__name__}.{info.name}")
    return WRONG
