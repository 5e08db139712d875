"""Numerical derivatives of plain functions, and of models or their definitions, to check Jacobians."""

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.manifolds import Array
from slamlib.models.argument import Argument
from slamlib.models.formula import Formula, Model


def complex_step(model: Model, place: Sequence[Array], index: int, step: float = 1e-30) -> Array:
    """Jacobian of a definition w.r.t. one argument, on the tangent space; exact but for rounding (chapter
    proving_a_jacobian).

    place: one array for each argument; index: which argument.
    """
    here = model.definition(*place)
    manifold = model.result.manifold if model.result is not None else None

    def slope(direction: Array) -> Array:
        moved = model.definition(*_moved(model.arguments[index], place, index, 1j * step * direction))
        return np.imag(manifold.minus(moved, here.astype(complex)) if manifold else moved) / step

    return _columns(model.arguments[index], slope)


def central_difference(model: Formula, place: Sequence[Array], index: int, step: float = 1e-6) -> Array:
    """The same by central differences: about nine digits, also for models without a definition in one formula."""
    function, result = getattr(model, "definition", model), getattr(model, "result", None)
    manifold = None if result is None else result.manifold

    def slope(direction: Array) -> Array:
        stops = [function(*_moved(model.arguments[index], place, index, sign * step * direction)) for sign in (1, -1)]
        return (manifold.minus(*stops) if manifold else stops[0] - stops[1]) / (2 * step)

    return _columns(model.arguments[index], slope)


def differences(function: Callable[..., Any], at: Array, *others: Any, step: ArrayLike = 1e-6) -> Array:
    """Derivative (..., n) of function(at, *others) w.r.t. `at` (..., n), by central differences: about nine digits.

    Not the complex step: a reader's function may use a norm or an arctangent, for which that is silently wrong. step:
    one, or one for each of the n numbers.
    """
    at = np.asarray(at, dtype=float)
    steps = np.broadcast_to(step, at.shape[-1:])
    stops = [(np.asarray(function(at + e, *others)), np.asarray(function(at - e, *others))) for e in np.diag(steps)]
    return np.stack([(ahead - behind) / (2 * h) for (ahead, behind), h in zip(stops, steps, strict=True)], axis=-1)


def complex_differences(function: Callable[..., Any], at: Array, step: float = 1e-30) -> Array | None:
    """The same of one item, exact but for rounding; None where the function does not take complex numbers.

    One that takes them but is no power series, such as a norm or `abs`, has another derivative: compare.
    """
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")  # "discards the imaginary part"
            return np.stack([np.imag(function(at + 1j * step * e)) / step for e in np.eye(at.size)], axis=-1)
    except Exception:  # whatever a reader's function says to numbers that it was not written for
        return None


def scaled_differences(found: Array, wanted: Array) -> Array:
    """Differences relative to the largest wanted entry, absolute where that is below one; infinite for nan."""
    errors = np.abs(found - wanted) / max(1.0, float(np.max(np.abs(wanted), initial=0)))
    return np.where(np.isfinite(errors), errors, np.inf)


def _moved(argument: Argument, place: Sequence[Array], index: int, direction: Any) -> list[Array]:
    moved = list(place)
    moved[index] = argument.manifold.plus(place[index], direction) if argument.manifold else place[index] + direction
    return moved


def _columns(argument: Argument, slope: Callable[[Array], Array]) -> Array:
    """The slopes along the unit vectors of an argument's tangent space, as the last axes of one array."""
    units = np.eye(int(np.prod(argument.tangent))).reshape(-1, *argument.tangent)
    columns = [slope(unit) for unit in units]
    return np.moveaxis(np.array(columns), 0, -1).reshape(*columns[0].shape, *argument.tangent)
