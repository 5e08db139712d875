"""A function defined by its inverse: solved by Newton's method, differentiated by the implicit function theorem."""

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.manifolds import Array
from slamlib.models.argument import Argument
from slamlib.models.formula import Formula, Jacobians, Model
from slamlib.models.kernel import common

STEPS = 60


class Implicit(Formula):
    """x with model(x, ...) = value, where `unknown` names the model's argument x; called as f(value, ...).

    start(value, ...) gives the first guess. Jacobians: dx/dvalue = (dmodel/dx)^-1, dx/dother = -(dmodel/dx)^-1
    dmodel/dother. Raises SingularPointError where there is no solution, or Newton's method finds none.
    """

    def __init__(self, name: str, model: Model, unknown: str, start: Callable[..., Array]) -> None:
        if unknown not in model.parameters:
            raise SlamlibError(
                f"{name}: {model.name} has no argument {unknown!r}; it has {', '.join(model.parameters)}"
            )
        self.model, self.unknown, self.start = model, unknown, start
        self.place = model.parameters.index(unknown)
        solved = model.arguments[self.place]
        if len(solved.shape) != 1 or solved.is_manifold or model.result:
            raise SlamlibError(f"{name}: {unknown!r} and the value of {model.name} should be plain vectors")
        self.others = [a for a in model.arguments if a.name != unknown]
        super().__init__(name, [Argument("value", solved.size), *self.others])

    def __call__(self, *args: ArrayLike, **kwargs: ArrayLike) -> Array:
        """The solution (..., n) for a value (..., n); all arguments broadcast over their leading axes."""
        return self._solve(*self._bind(args, kwargs))

    def jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Jacobians]:
        """The solution, and its Jacobians w.r.t. the value and the model's other arguments.

        Raises SingularPointError also where there is a solution without a derivative.
        """
        value, *others = self._bind(args, kwargs)
        x = self._solve(value, *others)
        _, jacobians = self.model.jac(*self._arguments(x, others))
        matrix = jacobians[self.place]
        inverse = _solved(matrix, np.broadcast_to(np.eye(value.shape[-1]), matrix.shape), np.nan)
        if (lost := ~np.isfinite(inverse).all((-2, -1))).any():
            first = np.broadcast_to(value, x.shape)[lost][0].tolist()
            raise SingularPointError(f"{self.name} has no derivative at {first}")
        by_others = [_times(-inverse, getattr(jacobians, a.name), len(a.tangent)) for a in self.others]
        return x, self._jacobians(inverse, *by_others)

    def _bind(self, args: tuple[ArrayLike, ...], kwargs: dict[str, ArrayLike]) -> list[Array]:
        bound = super()._bind(args, kwargs)
        for argument, array in zip(self.arguments, bound, strict=True):
            argument.check(array, self.name)
        return [array.astype(float, copy=False) for array in bound]

    def _arguments(self, x: Array, others: Sequence[Array]) -> list[Array]:
        return [*others[: self.place], x, *others[self.place :]]

    def _solve(self, value: Array, *others: Array) -> Array:
        leads = [a.shape[: a.ndim - len(s.shape)] for s, a in zip(self.arguments, [value, *others], strict=True)]
        shape = (*common(self.name, self.arguments, leads), value.shape[-1])
        value, x = np.broadcast_to(value, shape), np.broadcast_to(self.start(value, *others), shape)
        try:
            x, solved = self._iterate(x, value, others)
        except SingularPointError:
            solved = False
        if solved:
            return x
        if len(shape) == 1:
            raise SingularPointError(
                f"{self.name}: no {self.unknown} gives the value {value.tolist()}; mask such values"
            )
        lead = shape[:-1]  # one by one, so that a failed item does not affect the others, and can be reported
        items = [np.broadcast_to(a, lead + s.fitting(a).shape) for s, a in zip(self.others, others, strict=True)]
        return np.array([self._solve(value[i], *(a[i] for a in items)) for i in np.ndindex(lead)]).reshape(shape)

    def _iterate(self, x: Array, value: Array, others: Sequence[Array]) -> tuple[Array, bool]:
        """The last iterate of Newton's method, and whether the model has the given value there."""
        for _ in range(STEPS):
            found, jacobians = self.model.jac(*self._arguments(x, others))
            step = _solved(jacobians[self.place], (value - found)[..., None], 0.0)[..., 0]
            step = np.where(np.isfinite(step).all(-1, keepdims=True), step, 0)  # a singular item is tested at the end
            x = x + step
            if (np.abs(step) <= 1e-15 * (1 + np.abs(x))).all():
                break
        error = self.model(*self._arguments(x, others)) - value
        scale = 1 + np.abs(value).max(-1, keepdims=True, initial=0)  # a long polynomial rounds at more than its value
        return x, bool((np.abs(error) <= 1e-10 * scale).all())


def _solved(matrix: Array, right: Array, otherwise: float) -> Array:
    """matrix^-1 right for matrices (..., n, n) and right (..., n, k); `otherwise` where the matrix is singular."""
    try:
        solution: Any = np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        regular = (np.linalg.matrix_rank(matrix) == matrix.shape[-1])[..., None, None]
        safe = np.where(regular, matrix, np.eye(matrix.shape[-1]))
        solution = np.where(regular, np.linalg.solve(safe, right), otherwise)
    return solution


def _times(matrix: Array, jacobian: Array, axes: int) -> Array:
    """matrix (..., n, n) @ jacobian (..., n, ...), whose last `axes` belong to the argument."""
    split = jacobian.ndim - axes
    flat = jacobian.reshape(*jacobian.shape[:split], math.prod(jacobian.shape[split:]))
    return (matrix @ flat).reshape(jacobian.shape)
