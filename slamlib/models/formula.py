"""A model: one short function that states a formula once, with its generated value and Jacobians.

`f(...)` returns the value and `value, J = f.jac(...)` the value with its Jacobians, both from generated NumPy code that
broadcasts over leading axes. The definition itself runs on sympy symbols (to generate the code) and on floats (to test
it): `f.definition(...)`.
"""

import functools
import importlib
import inspect
from abc import ABC, abstractmethod
from collections import namedtuple
from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from types import ModuleType
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.ma import MaskedArray
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError, StaleCodeError
from slamlib.manifolds import Array, Manifold, real
from slamlib.models import fingerprint, in_memory
from slamlib.models.argument import Argument
from slamlib.models.compiler import compile_in_memory
from slamlib.models.kernel import Kernel
from slamlib.models.masked import over_unmasked

Spec: TypeAlias = int | tuple[int, ...] | Manifold
_defining: ContextVar[bool] = ContextVar("_defining", default=False)
# what it is to call a model, with its arguments, inside another model's definition
calling: ContextVar[Callable[..., Array]] = ContextVar("calling", default=lambda model, given: model.definition(*given))
FORMULA_PARTS = ("geometry", "landmarks", "motions", "observation", "sensors")


class Jacobians(Protocol):
    """A named tuple with an array for each argument, called as that is."""

    def __getattr__(self, name: str) -> Array: ...

    def __getitem__(self, place: int) -> Array: ...

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[Array]: ...


def model(*, returns: Spec | None = None, **arguments: Spec) -> Callable[[Callable[..., Array]], "Model"]:
    """Declare a function as a model: for each argument its size (int), shape (tuple; () is a scalar) or manifold.

    AtMost(8) is the size of a list of coefficients that may be shorter; its Jacobian is then as short.

    returns: the manifold of the result, if it has one (its Jacobian rows are then on the tangent space).

        >>> import slamlib as sl
        >>> from slamlib.analytic import sqrt
        >>> @sl.model(point=2)
        ... def distance(point):
        ...     return sqrt(point @ point)
        >>> float(distance.definition([3, 4]))  # distance(...), distance.jac(...): generated code, which needs SymPy
        5.0
    """

    def declare(function: Callable[..., Array]) -> "Model":
        return Model(function, [Argument(n, s) for n, s in arguments.items()], returns)

    return declare


class Formula(ABC):
    """Anything called like a model: a Model, an Implicit, or a chain of them."""

    name: str
    arguments: list[Argument]

    def __init__(self, name: str, arguments: list[Argument]) -> None:
        self.name, self.arguments = name, arguments
        self.parameters = [a.name for a in arguments]
        self._jacobians: Any = namedtuple(f"{name}_jacobians", self.parameters)  # type: ignore[misc]

    @abstractmethod
    def __call__(self, *args: ArrayLike, **kwargs: ArrayLike) -> Array:
        """Value."""

    @abstractmethod
    def jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Jacobians]:
        """Value and Jacobians."""

    def _bind(self, args: tuple[ArrayLike, ...], kwargs: dict[str, ArrayLike]) -> list[Array]:
        """Return the arguments as arrays, in their order."""
        names = self.parameters
        if len(args) + len(kwargs) != len(names) or (kwargs and not kwargs.keys() <= set(names[len(args) :])):
            raise SlamlibError(
                f"{self.name} takes ({', '.join(names)}); got {len(args)} by position and {sorted(kwargs)} by name"
            )
        given = (*args, *[kwargs[n] for n in names[len(args) :]]) if kwargs else args
        return [a if isinstance(a, MaskedArray) else np.asarray(a) for a in given]


class Model(Formula):
    """A formula with its generated value and Jacobians; made by the decorator `model`."""

    def __init__(self, function: Callable[..., Array], arguments: list[Argument], returns: Spec | None) -> None:
        super().__init__(function.__name__, arguments)
        functools.update_wrapper(self, function)
        self.function = function
        self.result = None if returns is None else Argument("result", returns)
        written = list(inspect.signature(function).parameters)
        if written != self.parameters:
            raise SlamlibError(
                f"{self.name}: the decorator names {self.parameters}, the function takes {written}; make them the same"
            )
        self._whole: Model | None = None
        self._may_be_shorter = any(a.may_be_shorter for a in arguments)

    @property
    def module(self) -> str:
        return self.function.__module__

    @property
    def has_manifold(self) -> bool:
        return any(a.is_manifold for a in [*self.arguments, *([self.result] if self.result else [])])

    def __repr__(self) -> str:
        return f"<model {self.name}({', '.join(map(repr, self.arguments))})>"

    def definition(self, *arguments: Any) -> Any:
        """The formula as written, on floats, complex numbers or symbols; one item, no broadcasting."""
        token = _defining.set(True)
        try:
            return np.asarray(self.function(*(np.asarray(a)[()] for a in arguments)))
        finally:
            _defining.reset(token)

    def __call__(self, *args: ArrayLike, **kwargs: ArrayLike) -> Array:
        """Return the value; arguments (..., shape) broadcast over their leading axes.

        Raises ShapeError, NonFiniteError, UnitError for bad arguments, SingularPointError where no value exists.
        """
        arguments = self._bind(args, kwargs)
        if _defining.get():
            return calling.get()(self, arguments)
        if "O" in [a.dtype.char for a in arguments]:  # symbols; or what a data frame gives
            arguments = [real(a, self.name, n) for n, a in zip(self.parameters, arguments, strict=True)]
            if "O" in [a.dtype.char for a in arguments]:
                return calling.get()(self, arguments)
        return self._evaluate("", arguments)[0]

    def jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Jacobians]:
        """Value and Jacobians (..., result, argument), on the tangent space of each argument or result that has one."""
        value, *jacobians = self._evaluate("_jac", self._bind(args, kwargs))
        return value, self._jacobians(*jacobians)

    def jac_where(self, first: Sequence[float] | Array, *others: ArrayLike) -> Array:
        """The Jacobian (..., result, argument) w.r.t. the first argument alone, at a point for which code is kept."""
        return self._run(self._kernel_where(tuple(first)), [np.asarray(other) for other in others])[0]

    def entries_where(self, first: Sequence[float] | Array) -> in_memory.Generated:
        """The generated function of the other arguments' numbers, unchecked, that gives that Jacobian, row by row."""
        return self._kernel_where(tuple(first)).function

    def storage_jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Jacobians]:
        """Value and plain derivatives w.r.t. the stored numbers: seven of a pose, four of a quaternion.

        Their code is generated when first needed, which requires sympy; raises SlamlibError without it.
        """
        kind = "_storage_jac" if self.has_manifold else "_jac"
        value, *jacobians = self._evaluate(kind, self._bind(args, kwargs))
        return value, self._jacobians(*jacobians)

    @functools.cache  # noqa: B019 - models live as long as their module
    def shortened(self, *sizes: int) -> "Model":
        """The model for shorter lists of coefficients, with `sizes` of all arguments: the omitted ones are zero."""
        arguments = [a if a.size == n else Argument(a.name, (n,)) for a, n in zip(self.arguments, sizes, strict=True)]
        if arguments == self.arguments:
            return self
        short = Model(self.function, arguments, self.result.manifold if self.result else None)
        short._whole = self
        return short

    @functools.cached_property
    def code(self) -> ModuleType:
        """The module of the generated functions, checked against the definition."""
        if self.module.split(".")[:2] not in [["slamlib", part] for part in FORMULA_PARTS]:  # a reader's own
            return compile_in_memory(self)
        command = "run `make generate` (python -m slamlib.codegen)"
        try:
            code = importlib.import_module(self.module.replace("slamlib.", "slamlib.generated.", 1))
            expected = code.DIGESTS[self.name]
        except (ModuleNotFoundError, KeyError) as error:
            raise StaleCodeError(f"no generated code for {self.module}.{self.name}: {command}") from error
        if fingerprint.of(self) not in (expected, None):
            raise StaleCodeError(f"{self.module}.{self.name} has changed since its code was generated: {command}")
        return code

    @functools.cached_property
    def storage_code(self) -> ModuleType:
        """The module of the derivatives w.r.t. stored numbers, which no filter needs: generated when first needed."""
        return compile_in_memory(self, by_storage=True)

    def _evaluate(self, kind: str, arguments: list[Array]) -> list[Array]:
        fitting: Model = self
        if self._may_be_shorter:
            fitting = self.shortened(*(a.fitting(v).size for a, v in zip(self.arguments, arguments, strict=True)))
        return self._run(fitting._kernel(kind), arguments)

    def _run(self, kernel: Kernel, arguments: list[Array]) -> list[Array]:
        if MaskedArray in map(type, arguments):
            specs = self.arguments[-len(arguments) :]
            return over_unmasked(lambda plain: self._run(kernel, plain), self.name, specs, arguments)
        found = kernel.single(arguments)
        if found is None:
            for argument, value in zip(self.arguments[-len(arguments) :], arguments, strict=True):
                argument.check(value, self.name)
            found = kernel(arguments)
        return found

    @functools.cache  # noqa: B019 - models live as long as their module
    def _kernel(self, kind: str) -> Kernel:
        """The generated function of a kind, with the shapes of the arrays that its entries fill."""
        return Kernel(self.generated(kind), self.name, self.arguments, self.shapes(kind))

    @functools.cache  # noqa: B019 - models live as long as their module
    def _kernel_where(self, first: tuple[float, ...]) -> Kernel:
        known, *others = self.arguments
        known.check(np.array(first), self.name)
        shapes = self.shapes("_jac")
        function = in_memory.where_first(self.generated("_jac"), self.arguments, first, shapes)
        return Kernel(function, self.name, others, shapes[1:2])

    def generated(self, kind: str) -> in_memory.Generated:
        """The generated function: of the value "", with Jacobians "_jac", or with "_storage_jac"."""
        if self._whole is not None:
            whole = self._whole
            return in_memory.for_fewer(
                whole.generated(kind), whole.arguments, self.arguments, whole.shapes(kind), self.shapes(kind)
            )
        return getattr(self.storage_code if kind == "_storage_jac" else self.code, self.name + kind)

    def shapes(self, kind: str) -> list[tuple[int, ...]]:
        """Shapes of the arrays that a generated function returns: the value, and the Jacobians."""
        shape = (self._whole or self).code.SHAPES[self.name]
        stored = kind == "_storage_jac" or not self.has_manifold
        rows = self.result.tangent if self.result is not None and not stored else shape
        return [shape, *(rows + (a.shape if stored else a.tangent) for a in self.arguments if kind)]
