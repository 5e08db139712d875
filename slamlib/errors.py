"""Errors for misuse: each message says what is wrong and what to do."""

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from importlib import import_module
from typing import Any, TypeVar

T = TypeVar("T")


class SlamlibError(Exception):
    """Any misuse that slamlib detects."""


class ShapeError(SlamlibError):
    """An array has a shape that the function does not accept."""

    @classmethod
    def of(cls, function: str, argument: str, wanted: tuple[int, ...], given: tuple[int, ...]) -> "ShapeError":
        """The standard message, with the argument, the expected shape and the given shape."""
        form = ", ".join(["...", *map(str, wanted)])
        return cls(
            f"{function}: argument '{argument}' should have shape ({form}), leading axes free, but has shape {given}"
        )


class NonFiniteError(SlamlibError):
    """An argument holds nan or infinity."""


class CovarianceError(SlamlibError):
    """A matrix that should be a covariance is not symmetric, or not positive (semi-)definite."""


class UnitError(SlamlibError):
    """A quaternion is not of unit length, or an angle not in radians."""


class SingularPointError(SlamlibError):
    """A model was evaluated where it, or its derivative, is not defined."""


class WritingRuleError(SlamlibError):
    """A model's definition breaks a writing rule, so that no code can be generated from it."""


class StaleCodeError(SlamlibError):
    """The generated code does not belong to the present definition of a model."""


class UnknownNameError(SlamlibError):
    """A name that is not among the known ones."""

    @classmethod
    def of(cls, what: str, name: object, known: Iterable[str]) -> "UnknownNameError":
        """The standard message, with the choices and the nearest one."""
        choices = sorted(known)
        near = get_close_matches(str(name), choices, n=1)
        hint = f"; did you mean {near[0]!r}?" if near else "."
        return cls(f"unknown {what} {name!r}{hint} Known: {', '.join(choices)}")


def entry(what: str, name: str, table: Mapping[str, T]) -> T:
    """The value of this name in a table; raises UnknownNameError, which calls the name a `what`."""
    if name not in table:
        raise UnknownNameError.of(what, name, table)
    return table[name]


class MissingNameError(UnknownNameError, AttributeError):
    """A name that the package does not have, or not without another package."""


class UnknownCallError(UnknownNameError, AttributeError):
    """Axes or a figure have no method of this name."""

    @classmethod
    def of_object(cls, what: str, name: str, known: list[str]) -> "UnknownCallError":
        """The message, with the known names; names that Python itself looks up get a short one."""
        if name.startswith("_"):
            return cls(f"{what} has no {name}")
        return cls(str(UnknownNameError.of(f"call of {what}", name, known)))


def optional(module: str, purpose: str, extra: str) -> Any:
    """Import a module of an optional package; raises SlamlibError that states the purpose ("to read images") and the
    extra of slamlib that installs it."""
    try:
        return import_module(module)
    except ImportError as error:
        package = module.split(".")[0]
        raise SlamlibError(
            f"{package} is needed {purpose}, and cannot be imported ({error}): pip install 'slamlib[{extra}]'"
        ) from None
