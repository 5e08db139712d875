"""Prove that two formulas are equal, symbolically, else at exact random points to sixty digits; check Jacobians.

The check compares what is generated from a model with numerical derivatives of its definition.
"""

import random
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import mpmath
import numpy as np
import sympy

from slamlib.codegen.derive import Derivation, derive
from slamlib.errors import ShapeError, SingularPointError, SlamlibError
from slamlib.models import Model
from slamlib.models.numerical import complex_step, scaled_differences
from slamlib.symbolic import closed_form

Sampler = Callable[[np.random.Generator], list[Any]]

_DIGITS = 60
_QUICK = 150  # operations
_DRAWS = 100


def assert_same(left: Any, right: Any, *, unit: Any = (), points: int = 5, silent: bool = False) -> None:
    """Prove left = right, entry by entry, and print how; raise AssertionError with a counterexample if they differ.

    left, right: sympy expressions, matrices, arrays of them, models (their value) or derivations (their value).
    unit: sequences of symbols that form a unit vector, such as a quaternion's four: the equality need hold only there.
    """
    a, b = _entries(left), _entries(right)
    if len(a) != len(b):
        raise ShapeError(
            f"assert_same: {len(a)} entries on the left, {len(b)} on the right; give expressions of the same shape"
        )
    several = not len(unit) or isinstance(unit[0], list | tuple | np.ndarray | sympy.MatrixBase)
    units = [list(u) for u in (unit if several else [unit])]
    differences = [closed_form(x) - closed_form(y) for x, y in zip(a, b, strict=True)]
    open_ones = {i: d for i, d in enumerate(differences) if not _vanishes(d, units)}
    if open_ones:
        _at_points(open_ones, units, points)
    if not silent:
        proved = len(a) - len(open_ones)
        where = " on unit vectors" if units else ""
        rest = f", {len(open_ones)} zero to {_DIGITS - 10} digits at {points} exact random points" if open_ones else ""
        print(f"same{where}: {proved} of {len(a)} entries by symbolic difference{rest}")


def _entries(value: Any) -> list[sympy.Expr]:
    if isinstance(value, Model):
        value = derive(value)
    if isinstance(value, Derivation):
        value = value.value
    flat = list(value) if isinstance(value, sympy.MatrixBase) else list(np.array(value, dtype=object).ravel())
    return [sympy.sympify(e) for e in flat]


def _vanishes(difference: sympy.Expr, units: list[list[sympy.Expr]]) -> bool:
    """True if the difference is zero symbolically, using first^2 = 1 - (other squares) for each unit vector.

    Only fast attempts are made: beyond them, exact points prove the same in a hundredth of the time.
    """
    if difference == 0:
        return True
    if not difference.has(sympy.Function, sympy.Pow(sympy.Wild("b"), sympy.Rational(1, 2))):
        with suppress(ValueError, ZeroDivisionError):  # it is no rational function, or none that has a value
            if not _numerator(difference, units):
                return True
        numerator, _ = sympy.fraction(sympy.together(difference))  # slower, but it knows that roots are roots
        for unit in units:
            numerator = sympy.rem(sympy.expand(numerator), sum(u**2 for u in unit) - 1, unit[0])
        return sympy.expand(numerator) == 0
    if difference.count_ops() > _QUICK:
        return False
    return sympy.expand(difference) == 0 or sympy.trigsimp(sympy.simplify(difference)) == 0


def _numerator(difference: sympy.Expr, units: list[list[sympy.Expr]]) -> sympy.Expr:
    """The numerator of a rational function as a polynomial, without the first^2 of each unit vector.

    Inverse roots, constants such as pi, and floats are unknowns too: what holds for all values holds for theirs.
    """
    firsts, atoms = [unit[0] for unit in units], difference.atoms(sympy.Symbol, sympy.NumberSymbol, sympy.Float)
    roots = {power for power in difference.atoms(sympy.Pow) if not power.exp.is_Integer}
    others = atoms.union(roots, *units) - set(firsts)
    field = sympy.field([*firsts, *sorted(others, key=str)], sympy.QQ)[0]  # lexicographic: a first^2 is a leading term
    relations = [field.from_expr(sum(u**2 for u in unit) - 1).numer for unit in units]
    return field.from_expr(difference).numer.rem(relations)


def _at_points(differences: dict[int, sympy.Expr], units: list[list[sympy.Expr]], points: int) -> None:
    """Evaluate at rational points with eighty digits; AssertionError names the entry and the point of a difference."""
    chance = random.Random(20)
    symbols = sorted(set().union(*(d.free_symbols for d in differences.values())), key=str)
    function = sympy.lambdify(symbols, list(differences.values()), "mpmath", cse=True)
    for _ in range(points):
        values = {s: sympy.Rational(chance.randint(-99, 99), chance.randint(50, 150)) for s in symbols}
        for unit in units:
            values.update(zip(unit, _rational_unit(len(unit), chance), strict=True))
        with mpmath.workdps(_DIGITS + 20):
            found = function(*(mpmath.mpf(values[s].p) / values[s].q for s in symbols))
        for (index, difference), size in zip(differences.items(), map(abs, found), strict=True):
            if mpmath.isnan(size):
                raise SlamlibError(f"assert_same: entry {index} has no value at {values}")
            if size > mpmath.mpf(10) ** (10 - _DIGITS):
                raise AssertionError(f"entry {index} differs by {mpmath.nstr(size, 6)} at {values}: {difference}")


def _rational_unit(size: int, chance: random.Random) -> list[sympy.Expr]:
    """An exactly rational unit vector, by stereographic projection of a rational point."""
    flat = [sympy.Rational(chance.randint(-99, 99), chance.randint(50, 150)) for _ in range(size - 1)]
    squared = sum(f**2 for f in flat)
    return [(1 - squared) / (1 + squared), *(2 * f / (1 + squared) for f in flat)]


def check_model(
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
    sample(rng) gives the arguments where a model is seldom defined; the default draws from each manifold.
    """
    rng = np.random.default_rng(seed)
    worst: dict[str, float] = {}
    for _ in range(points):
        arguments = sample(rng) if sample else random_arguments(model, rng)
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


def random_arguments(model: Model, rng: np.random.Generator) -> list[Any]:
    """Draw from each argument's manifold until the model has a value: not every root is real. Raises SlamlibError."""
    for _ in range(_DRAWS):
        drawn = [
            rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments
        ]
        with suppress(SingularPointError):
            model.jac(*drawn)
            return drawn
    raise SlamlibError(f"{model.name} has no value at any of {_DRAWS} random points: say where, check(..., sample=...)")
