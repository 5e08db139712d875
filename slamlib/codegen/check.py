"""Compare a model's generated Jacobians with numerical derivatives of its definition."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.model import Argument, Model
from slamlib.modeling.numerical import complex_step

Sampler = Callable[[np.random.Generator], list[Any]]


def check(
    model: Model,
    *,
    sample: Sampler | None = None,
    points: int = 20,
    seed: int = 0,
    tolerance: float = 1e-9,
    silent: bool = False,
) -> None:
    """Value and Jacobians against the definition at random points; prints a line per argument, raises AssertionError.

    Derivatives are taken through plus and minus of each space, by a complex step (error of rounding only).
    sample(rng) gives the arguments where a model is not defined for every vector; the default draws from each space.
    """
    rng = np.random.default_rng(seed)
    worst = dict.fromkeys(model.parameters, 0.0)
    for _ in range(points):
        arguments = sample(rng) if sample else [random_point(a, rng) for a in model.arguments]
        value, jacobians = model.jac(*arguments)
        definition = model.definition(*arguments)
        error = np.max(np.abs(value - definition), initial=0) / max(1.0, np.max(np.abs(definition), initial=0))
        _require(model, "value", error, tolerance, value)
        for index, argument in enumerate(model.arguments):
            numerical = complex_step(model, arguments, index)
            error = np.max(np.abs(jacobians[index] - numerical), initial=0) / max(
                1.0, np.max(np.abs(numerical), initial=0)
            )
            _require(model, argument.name, error, tolerance, jacobians[index])
            worst[argument.name] = max(worst[argument.name], error)
    if not silent:
        for name, error in worst.items():
            print(f"{model.name}: J.{name} is the complex step's at {points} random points, to {_decade(error)}")


def random_point(argument: Argument, rng: np.random.Generator) -> Any:
    """A random value for an argument."""
    return rng.standard_normal(argument.shape) if argument.manifold is None else argument.manifold.random(rng)


def _require(model: Model, what: str, error: float, tolerance: float, found: Any) -> None:
    if not np.isfinite(found).all():
        raise SlamlibError(f"{model.name}: {what} is not finite")
    if error > tolerance:
        raise AssertionError(
            f"{model.name}: {what} differs from its definition by {error:.3g}, relative; tolerance {tolerance:.0e}"
        )


def _decade(error: float) -> str:
    """A round bound above the error, the same on every machine: never sharper than 1e-12."""
    return f"1e-{min(12, int(-np.log10(max(error, 1e-300))))}"
