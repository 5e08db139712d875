"""Checks for the exercises: they test properties of the reader's own function and store no answers.

    from slambook.exercises import check
    check("kalman_filter.3", my_function)

Each chapter's checks are in a file of the chapter's name: kalman_filter.py holds kalman_filter.1, kalman_filter.2, ...
"""

import dis
import importlib
import pkgutil
from collections.abc import Callable
from typing import Any

from slambook.exercises.kit import KNOWN, Candidate, Found, Rejected, Rng, current, exercise
from slamlib.errors import SlamlibError, entry

__all__ = ["Candidate", "Rejected", "Rng", "check", "exercise", "load_all"]


def load_all() -> dict[str, tuple[str, Callable[[Any], None]]]:
    """Every registered exercise: number -> (title, check)."""
    for info in pkgutil.iter_modules(__path__):
        importlib.import_module(f"{__name__}.{info.name}")
    return dict(KNOWN)


def _unwritten(candidate: Any) -> bool:
    """Whether a function, or the model of a motion, has a body of nothing but words or `...`."""
    model = getattr(candidate, "step", candidate)  # of a motion
    candidate = getattr(model, "function", candidate)
    code = getattr(candidate, "__code__", None)
    if code is None or candidate.__name__ == "<lambda>" or not set(code.co_consts) <= {None, candidate.__doc__}:
        return False
    return {i.opname for i in dis.get_instructions(code)} <= {"RESUME", "LOAD_CONST", "RETURN_VALUE", "RETURN_CONST"}


def check(number: str, candidate: Any) -> None:
    """Test a solution: prints a line for each property that holds; raises Rejected with the first that does not, below
    those that hold so far.

    A function whose body is still `...` is not judged: the check says that it waits to be written.
    """
    chapter = str(number).rpartition(".")[0]
    if chapter in {info.name for info in pkgutil.iter_modules(__path__)}:
        importlib.import_module(f"{__name__}.{chapter}")
    title, function = entry("exercise", number, KNOWN if number in KNOWN else load_all())
    if _unwritten(candidate):
        print(f"Exercise {number}, {title}: write the function, then run the cell again.")
        return
    found = Found(candidate)
    token, word = current.set(found), "so far"
    try:
        function(found.candidate)
        word = "holds"
    except SlamlibError:
        raise
    except Exception as error:  # the check could not take what the reader's function gave, for instance unpack it
        message = f"what your function returned cannot be used: {type(error).__name__}: {error}"
        raise Rejected(f"{message}; see the exercise for what it should return") from error
    finally:
        current.reset(token)
        for line in found.lines:
            print(f"  {word}: {line}")
    print(f"Exercise {number} accepted: {title}.")
