"""Errors for misuse: each message says what is wrong and what to do."""

from collections.abc import Iterable
from difflib import get_close_matches
from importlib import import_module
from typing import Any


class SlamlibError(Exception):
    """Any misuse that slamlib can name."""


class ShapeError(SlamlibError):
    """An array has another shape than the function takes."""

    @classmethod
    def of(cls, function: str, argument: str, wanted: tuple[int, ...], given: tuple[int, ...]) -> "ShapeError":
        """The standard message: names the argument, the shape wanted and the shape given."""
        form = ", ".join(["...", *map(str, wanted)])
        return cls(
            f"{function}: argument '{argument}' should have shape ({form}), leading axes free, but has shape {given}"
        )


class NonFiniteError(SlamlibError):
    """An argument holds nan or infinity."""


class CovarianceError(SlamlibError):
    """A matrix that should be a covariance is not symmetric or not positive."""


class UnitError(SlamlibError):
    """A quaternion is not of unit length."""


class SingularPointError(SlamlibError):
    """A model was evaluated where it, or its derivative, is not defined."""


class WritingRuleError(SlamlibError):
    """A model's definition breaks a writing rule, so that no code can be generated from it."""


class StaleCodeError(SlamlibError):
    """The generated code does not belong to the present definition of a model."""


class UnknownNameError(SlamlibError):
    """A name is none of those that are known."""

    @classmethod
    def of(cls, what: str, name: object, known: Iterable[str]) -> "UnknownNameError":
        """The standard message: names the choices and the nearest one."""
        choices = sorted(known)
        near = get_close_matches(str(name), choices, n=1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        return cls(f"unknown {what} {name!r}{hint} Known: {', '.join(choices)}")


class UnknownCallError(UnknownNameError, AttributeError):
    """Axes or a figure are asked for something that they do not have."""

    @classmethod
    def of_object(cls, what: str, name: str, known: list[str]) -> "UnknownCallError":
        """The message, with what is possible; names that Python asks for by itself get a short one."""
        if name.startswith("_"):
            return cls(f"{what} has no {name}")
        return cls(str(UnknownNameError.of(f"call of {what}", name, known)))


def optional(module: str, purpose: str, extra: str) -> Any:
    """A module of a package that slamlib does without; raises SlamlibError that says what for ("to read images"), and
    which extra of slamlib holds it."""
    try:
        return import_module(module)
    except ImportError as error:
        package = module.split(".")[0]
        raise SlamlibError(
            f"{package} is needed {purpose}, and cannot be imported ({error}): pip install 'slamlib[{extra}]'"
        ) from None
