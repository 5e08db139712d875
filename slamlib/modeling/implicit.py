"""A function known by its inverse: solved by Newton's method, differentiated by the implicit function theorem."""

import math
from collections import namedtuple
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError
from slamlib.manifolds import Array
from slamlib.model import Argument, Model

STEPS = 60


class Implicit:
    """x with model(x, ...) = value, where `unknown` names the model's argument x; called as f(value, ...).

    start(value, ...) gives the first guess. Jacobians: dx/dvalue = (dmodel/dx)^-1, dx/dother = -(dmodel/dx)^-1
    dmodel/dother. Raises SingularPointError where there is no solution, or Newton's method finds none.
    """

    def __init__(self, name: str, model: Model, unknown: str, start: Callable[..., Array]) -> None:
        if unknown not in model.parameters:
            raise SlamlibError(
                f"{name}: {model.name} has no argument {unknown!r}; it has {', '.join(model.parameters)}"
            )
        self.name, self.model, self.unknown, self.start = name, model, unknown, start
        self.place = model.parameters.index(unknown)
        if len(model.arguments[self.place].shape) != 1 or model.arguments[self.place].is_manifold or model.result:
            raise SlamlibError(f"{name}: {unknown!r} and the value of {model.name} should be plain vectors")
        size = model.arguments[self.place].size
        self.others = [a for a in model.arguments if a.name != unknown]
        self.arguments = [Argument("value", size), *self.others]
        self.parameters = [a.name for a in self.arguments]
        self._jacobians = namedtuple(f"{name}_jacobians", self.parameters)  # type: ignore[misc]

    def __call__(self, *args: ArrayLike, **kwargs: ArrayLike) -> Array:
        """The solution (..., n) for a value (..., n); all arguments broadcast over their leading axes."""
        return self._solve(*self._bind(args, kwargs))

    def jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Any]:
        """The solution, and its Jacobians by the value and by the model's other arguments.

        Raises SingularPointError also where there is a solution without a derivative.
        """
        value, *others = self._bind(args, kwargs)
        x = self._solve(value, *others)
        _, jacobians = self.model.jac(*self._arguments(x, others))
        inverse = _inverse(jacobians[self.place])
        if inverse is None:
            raise SingularPointError(f"{self.name} has no derivative at {self._example(value, x, others)}")
        by_others = [_times(-inverse, getattr(jacobians, a.name), a) for a in self.others]
        return x, self._jacobians(inverse, *by_others)

    def _bind(self, args: tuple[ArrayLike, ...], kwargs: dict[str, ArrayLike]) -> list[Array]:
        names, own = self.parameters, f"{self.name} takes ({', '.join(self.parameters)})"
        if len(args) + len(kwargs) != len(names) or any(k not in names[len(args) :] for k in kwargs):
            raise SlamlibError(f"{own}; got {len(args)} by position and {sorted(kwargs)} by name")
        bound = [np.asarray(a, dtype=float) for a in (*args, *(kwargs[n] for n in names[len(args) :]))]
        for argument, array in zip(self.arguments, bound, strict=True):
            wanted = argument.shape
            if array.ndim < len(wanted) or array.shape[array.ndim - len(wanted) :] != wanted:
                raise ShapeError.of(self.name, argument.name, wanted, array.shape)
            if not np.isfinite(array).all():
                raise NonFiniteError(
                    f"{self.name}: argument '{argument.name}' holds nan or infinity; remove or mask it"
                )
        return bound

    def _arguments(self, x: Array, others: Sequence[Array]) -> list[Array]:
        return [*others[: self.place], x, *others[self.place :]]

    def _solve(self, value: Array, *others: Array) -> Array:
        leads = [a.shape[: a.ndim - len(s.shape)] for s, a in zip(self.arguments, [value, *others], strict=True)]
        try:
            shape = (*np.broadcast_shapes(*leads), value.shape[-1])
        except ValueError:
            given = ", ".join(f"{n} {lead}" for n, lead in zip(self.parameters, leads, strict=True))
            raise ShapeError(f"{self.name}: the leading axes do not broadcast together: {given}") from None
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
        lead = shape[:-1]  # one by one, so that a lost item takes no other with it, and is named
        items = [np.broadcast_to(a, lead + s.shape) for s, a in zip(self.others, others, strict=True)]
        return np.array([self._solve(value[i], *(a[i] for a in items)) for i in np.ndindex(lead)]).reshape(shape)

    def _iterate(self, x: Array, value: Array, others: Sequence[Array]) -> tuple[Array, bool]:
        """Where Newton's method ends, and whether the model has the wanted value there."""
        for _ in range(STEPS):
            found, jacobians = self.model.jac(*self._arguments(x, others))
            step = _newton(jacobians[self.place], value - found)
            x = x + step
            if (np.abs(step) <= 1e-15 * (1 + np.abs(x))).all():
                break
        error = self.model(*self._arguments(x, others)) - value
        scale = 1 + np.abs(value).max(-1, keepdims=True, initial=0)  # a long polynomial rounds at more than its value
        return x, bool((np.abs(error) <= 1e-10 * scale).all())

    def _example(self, value: Array, x: Array, others: Sequence[Array]) -> list[float]:
        """The value of the first item without a derivative."""
        _, jacobians = self.model.jac(*self._arguments(x, others))
        matrices = jacobians[self.place].reshape(-1, x.shape[-1], x.shape[-1])
        first = next(i for i, matrix in enumerate(matrices) if _inverse(matrix) is None)
        found: list[float] = np.broadcast_to(value, x.shape).reshape(-1, x.shape[-1])[first].tolist()
        return found


def _newton(matrix: Array, residual: Array) -> Array:
    """Newton's step (..., n); zero for items whose matrix (..., n, n) has no inverse, which are judged at the end."""
    try:
        step = np.linalg.solve(matrix, residual[..., None])[..., 0]
    except np.linalg.LinAlgError:
        regular = np.linalg.matrix_rank(matrix)[..., None] == matrix.shape[-1]
        safe = np.where(regular[..., None], matrix, np.eye(matrix.shape[-1]))
        step = np.where(regular, np.linalg.solve(safe, residual[..., None])[..., 0], 0)
    return np.where(np.isfinite(step).all(-1, keepdims=True), step, 0)


def _inverse(matrix: Array) -> Array | None:
    """The inverses of (..., n, n), or None if one has none."""
    try:
        found: Any = np.linalg.inv(matrix)
    except np.linalg.LinAlgError:
        return None
    return found if np.isfinite(found).all() else None


def _times(matrix: Array, jacobian: Array, argument: Argument) -> Array:
    """matrix (..., n, n) @ jacobian (..., n, *shape), by an argument whose tangent vectors have this shape."""
    shape = argument.tangent
    flat = jacobian.reshape(*jacobian.shape[: jacobian.ndim - len(shape)], math.prod(shape))
    return (matrix @ flat).reshape(jacobian.shape)
