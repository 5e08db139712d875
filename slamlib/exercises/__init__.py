"""Checks for the exercises: they test properties of the reader's own function and store no answers.

    from slamlib.exercises import check
    check("kalman_filter.3", my_function)

Each chapter's checks are in a file of the chapter's name: kalman_filter.py holds kalman_filter.1, kalman_filter.2, ...
"""

import importlib
import pkgutil
from collections.abc import Callable
from typing import Any

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.exercises.properties import Rejected, hold

__all__ = ["Rejected", "check", "exercise", "load_all"]

Checker = Callable[[Any], None]
_known: dict[str, tuple[str, Checker]] = {}


def exercise(number: str, title: str) -> Callable[[Checker], Checker]:
    """Register a check: a function of the candidate that calls the properties and raises Rejected."""

    def register(function: Checker) -> Checker:
        if number in _known and _known[number][1].__module__ != function.__module__:
            raise SlamlibError(f"exercise {number} is registered twice: give each exercise a number of its own")
        _known[number] = (title, function)
        return function

    return register


def load_all() -> dict[str, tuple[str, Checker]]:
    """Every registered exercise: number -> (title, check)."""
    for info in pkgutil.iter_modules(__path__):
        if info.name != "properties":
            importlib.import_module(f"{__name__}.{info.name}")
    return dict(_known)


def _still_to_write() -> None: ...


def _still_to_write_but_described() -> None:
    """A body of nothing but words."""


def _unwritten(candidate: Any) -> bool:
    model = getattr(candidate, "step", candidate)  # of a motion
    candidate = getattr(model, "function", candidate)
    code = getattr(candidate, "__code__", None)
    if code is None or candidate.__name__ == "<lambda>" or not set(code.co_consts) <= {None, candidate.__doc__}:
        return False
    return code.co_code in (_still_to_write.__code__.co_code, _still_to_write_but_described.__code__.co_code)


def check(number: str, candidate: Any) -> None:
    """Test a solution: prints a line for each property that holds; raises Rejected with the first that does not.

    A function whose body is still `...` is not judged: the check says that it waits to be written.
    """
    chapter = str(number).rpartition(".")[0]
    if chapter in {info.name for info in pkgutil.iter_modules(__path__)}:
        importlib.import_module(f"{__name__}.{chapter}")
    if number not in _known:
        raise UnknownNameError.of("exercise", number, load_all())
    title, function = _known[number]
    if _unwritten(candidate):
        print(f"Exercise {number}, {title}: write the function, then run the cell again.")
        return
    with hold(candidate) as found:
        try:
            function(found.candidate)
        except SlamlibError:
            raise
        except Exception as error:  # the check could not take what the reader's function gave, for instance unpack it
            message = f"what your function returned cannot be used: {type(error).__name__}: {error}"
            raise Rejected(f"{message}; see the exercise for what it should return") from error
        finally:
            for line in found.lines:
                print(f"  holds: {line}")
    print(f"Exercise {number} accepted: {title}.")
