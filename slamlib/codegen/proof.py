"""Prove that two formulas are equal: symbolically, else at exact random points to sixty digits."""

import random
from typing import Any

import numpy as np
import sympy

from slamlib.codegen.derive import Derivation, derive
from slamlib.codegen.functions import closed_form
from slamlib.errors import ShapeError, SlamlibError
from slamlib.model import Model

_DIGITS = 60


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
    units = [
        list(u)
        for u in (
            [unit] if len(unit) and not isinstance(unit[0], list | tuple | np.ndarray | sympy.MatrixBase) else unit
        )
    ]
    differences = [sympy.expand(closed_form(x - y)) for x, y in zip(a, b, strict=True)]
    open_ones = [(i, d) for i, d in enumerate(differences) if d != 0 and _reduced(d, units) != 0]
    if open_ones:
        _at_points(open_ones, units, points)
    if not silent:
        proved = len(a) - len(open_ones)
        where = " on unit vectors" if units else ""
        rest = f", {len(open_ones)} zero to {_DIGITS - 10} digits at {points} exact random points" if open_ones else ""
        print(f"same{where}: {proved} of {len(a)} entries by symbolic difference{rest}")


def _entries(value: Any) -> list[Any]:
    if isinstance(value, Model):
        value = derive(value)
    if isinstance(value, Derivation):
        value = value.value
    flat = list(value) if isinstance(value, sympy.MatrixBase) else list(np.array(value, dtype=object).ravel())
    return [sympy.sympify(e) for e in flat]


def _reduced(difference: Any, units: list[list[Any]]) -> Any:
    """The difference after using last^2 = 1 - (other squares) for each unit vector, and sin^2 + cos^2 = 1."""
    if difference.count_ops() > 2000:
        return difference
    for unit in units:
        numerator, denominator = sympy.fraction(sympy.together(difference))
        relation = sum(u**2 for u in unit) - 1
        if numerator.is_polynomial(unit[0]):
            numerator = sympy.rem(sympy.expand(numerator), relation, unit[0])
        difference = numerator / denominator
    return sympy.trigsimp(sympy.simplify(difference)) if difference != 0 else difference


def _at_points(open_ones: list[tuple[int, Any]], units: list[list[Any]], points: int) -> None:
    chance = random.Random(20)
    symbols = sorted(set().union(*(d.free_symbols for _, d in open_ones)), key=str)
    for _ in range(points):
        values = {s: sympy.Rational(chance.randint(-99, 99), chance.randint(50, 150)) for s in symbols}
        for unit in units:
            values.update(zip(unit, _rational_unit(len(unit), chance), strict=True))
        for index, difference in open_ones:
            size = sympy.Abs(difference.subs(values)).evalf(_DIGITS, maxn=400)
            if not size.is_number or size is sympy.nan:
                raise SlamlibError(f"assert_same: entry {index} has no value at {values}")
            if size > sympy.Float(10) ** (10 - _DIGITS):
                raise AssertionError(f"entry {index} differs by {sympy.N(size, 6)} at {values}: {difference}")


def _rational_unit(size: int, chance: random.Random) -> list[Any]:
    """An exactly rational unit vector, by stereographic projection of a rational point."""
    flat = [sympy.Rational(chance.randint(-99, 99), chance.randint(50, 150)) for _ in range(size - 1)]
    squared = sum(f**2 for f in flat)
    return [(1 - squared) / (1 + squared), *(2 * f / (1 + squared) for f in flat)]
