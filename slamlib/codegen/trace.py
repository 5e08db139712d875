"""Run a model's definition on symbols: expressions, and Jacobians on storage and on the tangent space."""

import traceback
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import count
from typing import Any

import numpy as np
import sympy

from slamlib.codegen.rules import broken, check_rules
from slamlib.errors import SlamlibError, WritingRuleError
from slamlib.manifolds import Product
from slamlib.models import Argument, Model, calling

Symbols = Any  # object array of sympy symbols


@dataclass(frozen=True)
class Trace:
    """A model's expressions: value (object array), and flat (rows, columns) Jacobians per argument.

    They may hold the symbols of `stages`, each of which stands for an expression, in the order of their making.
    """

    model: Model
    symbols: list[Symbols]
    value: Symbols
    stages: dict[sympy.Symbol, sympy.Expr]

    @cached_property
    def stored(self) -> list[sympy.Matrix]:
        """Derivatives w.r.t. the stored numbers of each argument."""
        flat = sympy.Matrix(self.value.ravel().tolist())
        return [_jacobian(flat, self.stages, list(s.ravel())) for s in self.symbols]

    @cached_property
    def tangent(self) -> list[sympy.Matrix]:
        """Jacobians on the tangent space of each argument, and of the result if it has one."""
        result = self.model.result
        left = local(result.manifold, self.value) if result is not None and result.is_manifold else None
        found = []
        for argument, symbol, jacobian in zip(self.model.arguments, self.symbols, self.stored, strict=True):
            right = jacobian * lift(argument.manifold, symbol) if argument.is_manifold else jacobian
            found.append(left * right if left is not None else right)
        return found


class Stages:
    """The arguments of inner models, kept as symbols, so that the chain rule is applied and not multiplied out.

    Only quotients, roots and the like become stages: sums and products of symbols stay as they are.
    """

    def __init__(self, taken: set[str]) -> None:
        self.taken, self.symbols = taken, {}  # type: ignore[var-annotated]

    def __call__(self, model: Model, arguments: list[Symbols]) -> Symbols:
        """The value of a call with a symbol in place of each entry of an argument that is not polynomial."""
        pairs = zip(model.arguments, arguments, strict=True)
        return model.definition(*(self._staged(a, v) if v.dtype == object else v for a, v in pairs))

    def _staged(self, argument: Argument, value: Symbols) -> Symbols:
        pairs = zip(symbols_for(argument).ravel(), value.ravel(), strict=True)
        kept = [e if sympy.sympify(e).is_polynomial() else self._symbol(str(s), e) for s, e in pairs]
        return np.array(kept, dtype=object).reshape(value.shape)

    def _symbol(self, name: str, expression: sympy.Expr) -> sympy.Expr:
        if expression not in self.symbols:
            name = next(n for n in (name + "_" * i for i in count()) if n not in self.taken)
            self.taken.add(name)
            self.symbols[expression] = sympy.Symbol(name, real=True)
        return self.symbols[expression]


def symbols_for(argument: Argument) -> Symbols:
    """One real symbol per stored number: pose0, pose1, ..., in the argument's shape."""
    single = np.array(sympy.Symbol(argument.name, real=True), dtype=object)
    return (_vector(argument.name, argument.size) if argument.size > 1 else single).reshape(argument.shape)


def _vector(name: str, size: int) -> Symbols:
    return np.array([sympy.Symbol(f"{name}{i}", real=True) for i in range(size)], dtype=object)


def trace(model: Model, *, staged: bool = False) -> Trace:
    """Expressions of the value and of all Jacobians; raises WritingRuleError for what cannot be traced.

    staged: keep the arguments of inner models as symbols of their own.
    """
    check_rules(model.function)
    symbols = [symbols_for(a) for a in model.arguments]
    stages = Stages({str(s) for symbol in symbols for s in symbol.ravel()})
    token = calling.set(stages) if staged else None
    try:
        value = run(model, symbols)
    finally:
        if token:
            calling.reset(token)
    result = model.result
    if result is not None and result.shape != value.shape:
        raise SlamlibError(
            f"{model.name} declares returns={result.manifold!r} of shape {result.shape} but returns shape {value.shape}"
        )
    return Trace(model, symbols, value, {symbol: expression for expression, symbol in stages.symbols.items()})


def _jacobian(value: sympy.Matrix, stages: dict[sympy.Symbol, sympy.Expr], symbols: list[sympy.Symbol]) -> sympy.Matrix:
    """d value / d symbols, by the chain rule through the stages, each of which may depend on those before it."""
    inner, by_symbols = list(stages), sympy.zeros(0, len(symbols))

    def total(part: sympy.Matrix) -> sympy.Matrix:
        before = inner[: by_symbols.rows]
        direct = part.jacobian(symbols)
        return direct + part.jacobian(before) * by_symbols if before else direct

    for expression in stages.values():
        by_symbols = by_symbols.col_join(total(sympy.Matrix([expression])))
    return total(value)


def run(model: Model, symbols: list[Symbols]) -> Symbols:
    """The definition's value on symbols, free of floats."""
    try:
        value = model.definition(*symbols)
    except SlamlibError:
        raise
    except Exception as error:
        frames = [f for f in traceback.extract_tb(error.__traceback__) if f.name == model.name]
        line, text = (frames[-1].lineno or 0, frames[-1].line or "") if frames else (0, "")
        what = f"a model must run on symbols, but this raised {type(error).__name__}: {error}"
        raise broken(model.function, line, text, what) from error
    value = np.array([sympy.sympify(e) for e in value.ravel()], dtype=object).reshape(value.shape)
    for entry in value.ravel():
        if entry.atoms(sympy.Float):
            decimal = entry.atoms(sympy.Float).pop()
            raise WritingRuleError(
                f"{model.name}: the formula contains the decimal {decimal}; write integers and ratios"
            )
    return value


def lift(manifold: Any, point: Symbols) -> sympy.Matrix:
    """d plus(point, step) / d step at step = 0, (size, dof): how stored numbers move with the tangent vector."""
    if isinstance(manifold, Product):
        return sympy.diag(*map(lift, manifold.parts, manifold.split(point)))
    if manifold.dof == manifold.size:
        return sympy.eye(manifold.size)
    generic, jacobian = _lift(manifold)
    return jacobian.xreplace(dict(zip(generic, point, strict=True)))


@cache
def _lift(manifold: Any) -> tuple[Symbols, sympy.Matrix]:
    """Symbols for a point of a manifold that is no product, and its `lift` there."""
    point, step = _vector("point", manifold.size), _vector("step", manifold.dof)
    moved = sympy.Matrix(manifold.plus.definition(point, step).tolist())
    return point, moved.jacobian(step.tolist()).subs(dict.fromkeys(step, 0))


def local(manifold: Any, point: Symbols) -> sympy.Matrix:
    """d minus(other, point) / d other at other = point, (dof, size): the tangent vector of a change in storage."""
    if isinstance(manifold, Product):
        return sympy.diag(*map(local, manifold.parts, manifold.split(point)))
    if manifold.dof == manifold.size:
        return sympy.eye(manifold.size)
    generic, jacobian = _local(manifold)
    return jacobian.subs(dict(zip(generic, point, strict=True)))


@cache
def _local(manifold: Any) -> tuple[Symbols, sympy.Matrix]:
    """Symbols for a point of a manifold that is no product, and its `local` there."""
    here, other = _vector("here", manifold.size), _vector("other", manifold.size)
    step = sympy.Matrix(manifold.minus.definition(other, here).tolist())
    at_here = step.jacobian(other.tolist()).subs(dict(zip(other, here, strict=True)))
    return here, at_here.applyfunc(sympy.simplify)
