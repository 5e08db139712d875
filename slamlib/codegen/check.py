"""Compare a model's generated Jacobians with numerical derivatives of its definition."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.model import Argument, Model
from slamlib.modeling.numerical import complex_step, scaled_differences

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

    Derivatives are taken through plus and minus of each manifold, by a complex step (rounding errors only).
    sample(rng) gives the arguments where a model is not defined for every vector; the default draws from each manifold.
    """
    rng = np.random.default_rng(seed)
    worst: dict[str, float] = {}
    for _ in range(points):
        arguments = sample(rng) if sample else [random_point(a, rng) for a in model.arguments]
        value, jacobians = model.jac(*arguments)
        numerical = [complex_step(model, arguments, index) for index in range(len(arguments))]
        pairs = [(value, model.definition(*arguments)), *zip(jacobians, numerical, strict=True)]
        for what, (found, wanted) in zip(("value", *model.parameters), pairs, strict=True):
            if not np.isfinite(found).all():
                raise SlamlibError(f"{model.name}: {what} is not finite")
            error = float(np.max(scaled_differences(found, wanted), initial=0))
            if error > tolerance:
                how = f"differs from its definition by {error:.3g}, relative; tolerance {tolerance:.0e}"
                raise AssertionError(f"{model.name}: {what} {how}")
            worst[what] = max(worst.get(what, 0.0), error)
    for name in () if silent else model.parameters:
        # a rounded bound above the error, the same on every machine: never sharper than 1e-12
        bound = f"1e-{min(12, int(-np.log10(max(worst[name], 1e-300))))}"
        print(f"{model.name}: J.{name} is the complex step's at {points} random points, to {bound}")


def random_point(argument: Argument, rng: np.random.Generator) -> Any:
    """Draw a random value for an argument."""
    return rng.standard_normal(argument.shape) if argument.manifold is None else argument.manifold.random(rng)
