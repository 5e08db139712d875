"""Show a model: as mathematics, expression and Jacobians as sympy matrices, and as source, written or generated."""

import inspect
from typing import Any

import numpy as np
import sympy

from slamlib.codegen.trace import symbols_for, trace
from slamlib.errors import ShapeError
from slamlib.models import Argument, Model, fingerprint
from slamlib.plain_data.fields import OneOf


class Derivation:
    """Value and Jacobians of a model: `.value`, one per argument, and `.stored[name]` w.r.t. stored numbers."""

    def __init__(self, model: Model, symbols: list[Any]) -> None:
        traced = trace(model)
        own = [s for argument in traced.symbols for s in argument.ravel()]
        given = dict(zip(own, [sympy.sympify(g) for argument in symbols for g in argument.ravel()], strict=True))
        self.model, self.symbols = model, symbols
        self.value = sympy.Matrix(np.atleast_1d(traced.value).tolist()).xreplace(given)
        self.jacobians = {n: j.xreplace(given) for n, j in zip(model.parameters, traced.tangent, strict=True)}
        self.stored = {n: j.xreplace(given) for n, j in zip(model.parameters, traced.stored, strict=True)}

    def __getattr__(self, name: str) -> sympy.Matrix:
        if name in self.__dict__.get("jacobians", {}):
            return self.jacobians[name]
        raise AttributeError(
            f"{self.model.name} has no argument {name!r}; it has {', '.join(self.jacobians)}, and .value, .stored"
        )

    def _repr_latex_(self) -> str:
        left = rf"\text{{{self.model.name}}}".replace("_", r"\_")
        return rf"$\displaystyle {left} = {sympy.latex(self.value)}$"

    def __repr__(self) -> str:
        return f"{self.model.name} = {self.value}"


def derive(model: Model, **symbols: Any) -> Derivation:
    """Expressions of a model; an argument may be given symbols or expressions: a matrix, a list, or 'x y theta'.

    >>> import slamlib as sl
    >>> found = sl.derive(sl.quaternion.product, left="a b c d", right="w x y z")
    >>> found.value[0]
    a*w - b*x - c*y - d*z
    >>> found.right[0, :]  # the derivatives of the first number w.r.t. w, x, y, z
    Matrix([[a, -b, -c, -d]])
    """
    for name in symbols:
        OneOf(model.parameters).check(name, f"argument of {model.name}")
    return Derivation(model, [_chosen(model, a, symbols.get(a.name)) for a in model.arguments])


def _chosen(model: Model, argument: Argument, given: Any) -> Any:
    default = symbols_for(argument)
    if given is None:
        return default
    if isinstance(given, str):
        given = [sympy.Symbol(n, real=True) for n in given.replace(",", " ").split()]
    flat = np.array(list(np.array(given, dtype=object).ravel()), dtype=object)
    if flat.size != default.size:
        raise ShapeError.of(f"derive({model.name})", argument.name, default.shape, flat.shape)
    return flat.reshape(default.shape)


class CodeListing:
    """A piece of source text, highlighted where it is displayed."""

    def __init__(self, text: str) -> None:
        self.text = text.rstrip() + "\n"

    def _repr_markdown_(self) -> str:
        return f"```python\n{self.text}```"

    def __repr__(self) -> str:
        return self.text


def show(thing: Any, *, generated: bool = False) -> CodeListing:
    """Source of a model, function, class or module; generated=True shows the NumPy code generated from a model."""
    if not isinstance(thing, Model):
        return CodeListing(inspect.getsource(thing))
    if not generated:
        return CodeListing(fingerprint.source(thing.function))
    return CodeListing("\n\n".join(inspect.getsource(thing.generated(kind)) for kind in ("", "_jac")))
