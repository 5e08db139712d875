"""Write the traced expressions as plain arithmetic with common sub-expressions: works on floats and on arrays."""

import itertools
import re
from collections.abc import Iterator
from functools import reduce
from operator import add, mul
from random import Random

import sympy
from sympy.core.parameters import distribute
from sympy.simplify.cse_opts import sub_post, sub_pre

from slamlib.codegen.printer import Printer
from slamlib.codegen.trace import Trace, trace
from slamlib.models import Model, fingerprint

PRIME = 2**61 - 1
_FUNCTIONS = (
    "arctan2", "arctan_ratio", "arctan_ratio_slope", "cos", "exp", "log", "norm_plus", "sin", "sqrt", "stumpff"
)  # fmt: skip


def functions(model: Model, traced: Trace, *, by_storage: bool = False) -> str:
    """The generated functions of one model: value, and value with Jacobians; by_storage: with storage Jacobians."""
    flat = list(traced.value.ravel())
    if by_storage:
        entries = flat + [e for j in traced.stored for e in j]
        return _function(model, traced, "_storage_jac", "value and derivatives by stored numbers", entries)
    with_jacobians = _function(
        model, traced, "_jac", "value and Jacobians", flat + [e for j in traced.tangent for e in j]
    )
    return _function(model, traced, "", "value", flat) + "\n\n" + with_jacobians


def _function(model: Model, traced: Trace, suffix: str, what: str, entries: list[sympy.Expr]) -> str:
    taken = {str(s) for symbols in traced.symbols for s in symbols.ravel()} | {str(s) for s in traced.stages}
    known: dict[sympy.Expr, sympy.Expr] = {}
    shared, reduced = sympy.cse(
        [factored(e, known) for e in [*traced.stages.values(), *unified(entries, traced.stages)]],
        (sympy.Symbol(n, real=True) for n in _unused(taken)),
        [(sub_pre, sub_post)],
        order="canonical",
        list=True,
    )
    stages = dict(zip(traced.stages, reduced, strict=False))
    printer = Printer(_unused(taken), dict(shared), stages)
    results = [printer.doprint(e) for e in reduced[len(stages) :]]
    lines = []
    for name, symbols in zip(model.parameters, traced.symbols, strict=True):
        targets = [str(s) if s in printer.used else "_" for s in symbols.ravel()]
        if any(t != "_" for t in targets):
            lines.append(f"{', '.join(targets)}{',' if len(targets) == 1 else ''} = {name}")
    body = [f'"""{model.name}: {what}."""', *lines, *printer.lines, "return (", *(f"    {r}," for r in results), ")"]
    return "\n    ".join([f"def {model.name}{suffix}({', '.join(model.parameters)}):", *body]) + "\n"


def _unused(taken: set[str]) -> Iterator[str]:
    return (n for n in map("t{}".format, itertools.count()) if n not in taken)


def factored(expression: sympy.Expr, known: dict[sympy.Expr, sympy.Expr]) -> sympy.Expr:
    """Take the common factors out of every sum of the expression; `known` holds earlier results."""
    if not expression.args:
        return expression
    if expression not in known:
        arguments = [factored(a, known) for a in expression.args]
        with distribute(False):
            rebuilt = expression.func(*arguments)
            known[expression] = _common(rebuilt) if rebuilt.is_Add else rebuilt
    return known[expression]


def _common(total: sympy.Expr) -> sympy.Expr:
    """A sum as the product of its terms' common factors and the rest."""
    coefficients = [a.as_coeff_Mul()[0] for a in total.args]
    content, rest = total.primitive()
    if content.q != 1 and any(c.is_Integer for c in coefficients):
        content, rest = sympy.Integer(1), total
    if all(c < 0 for c in coefficients):
        content, rest = -content, sympy.Add(*(-a for a in rest.args))
    return content * sympy.gcd_terms(rest, isprimitive=True, clear=False, fraction=False)


def unified(entries: list[sympy.Expr], stages: dict[sympy.Expr, sympy.Expr] | None = None) -> list[sympy.Expr]:
    """Replace entries that are equal up to the sign by one expression; also those equal to 0, 1 and -1.

    Two that agree at a random point of the numbers modulo a prime are equal (Schwartz and Zippel), but for a chance of
    their degree in 2^61.
    """
    residues: dict[sympy.Expr, int] = {}
    for symbol, expression in (stages or {}).items():
        residues[symbol] = _residue(expression, residues)
    first = {n % PRIME: sympy.Integer(n) for n in (0, 1, -1)}
    results = []
    for entry in entries:
        residue = _residue(entry, residues)
        if residue not in first:
            first[-residue % PRIME], first[residue] = -entry, entry
        results.append(first[residue])
    return results


def _residue(expression: sympy.Expr, known: dict[sympy.Expr, int]) -> int:
    """The expression at a random point of the numbers modulo a prime; a function is a random number of its own."""
    if expression not in known:
        if expression.is_Rational:
            value = expression.p * pow(expression.q, -1, PRIME)
        elif expression.is_Add or expression.is_Mul:
            value = reduce(add if expression.is_Add else mul, (_residue(a, known) for a in expression.args))
        elif expression.is_Pow and (2 * expression.exp).is_Integer:
            whole, half = divmod(int(2 * expression.exp), 2)
            base = _residue(expression.base, known)
            value = pow(base, whole, PRIME) * (Random(f"sqrt {base}").randrange(PRIME) if half else 1)
        else:
            inner = [_residue(a, known) for a in expression.args]
            value = Random(f"{expression.func.__name__} {inner or expression}").randrange(PRIME)
        known[expression] = value % PRIME
    return known[expression]


def module(models: list[Model], source: str, *, by_storage: bool = False) -> str:
    """The text of a generated module for the models of one source file; by_storage: of their storage Jacobians."""
    traces = [trace(m, staged=True) for m in models]
    code = "\n\n".join(functions(m, t, by_storage=by_storage) for m, t in zip(models, traces, strict=True))
    used = sorted(n for n in _FUNCTIONS if re.search(rf"\b{n}\(", code))
    head = [f'"""Generated from {source} by `make generate` (sympy {sympy.__version__}); never edited by hand."""', ""]
    if used:
        head += [f"from slamlib.analytic import {', '.join(used)}", ""]
    head += ["DIGESTS = {", *(f'    "{m.name}": "{fingerprint.of(m)}",' for m in models), "}", "SHAPES = {"]
    head += [*(f'    "{m.name}": {t.value.shape!r},' for m, t in zip(models, traces, strict=True)), "}"]
    return "\n".join(head) + "\n\n\n" + code
