"""Write the traced expressions as plain arithmetic with common sub-expressions: works on floats and on arrays."""

import re
from typing import Any

import sympy
from sympy.printing.pycode import PythonCodePrinter

from slamlib import digest
from slamlib.codegen.functions import ArctanRatio, ArctanRatioSlope, Stumpff
from slamlib.codegen.trace import Trace, trace
from slamlib.errors import WritingRuleError
from slamlib.model import Model

_FUNCTIONS = ("arctan2", "arctan_ratio", "arctan_ratio_slope", "cos", "sin", "sqrt", "stumpff")
_NAMES = {Stumpff: "stumpff", ArctanRatio: "arctan_ratio", ArctanRatioSlope: "arctan_ratio_slope"}


class Printer(PythonCodePrinter):
    """Python arithmetic with the functions of slamlib.analytic."""

    def __init__(self) -> None:
        super().__init__({"fully_qualified_modules": False})

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if exponent < 0:
            return f"1/({self._print(base**-exponent)})"
        if exponent == sympy.Rational(1, 2):
            return f"sqrt({self._print(base)})"
        if exponent.is_Integer:
            return "*".join([self.parenthesize(base, 100)] * int(exponent))
        if (2 * exponent).is_Integer:
            return f"{self.parenthesize(base ** (exponent - sympy.Rational(1, 2)), 50)}*sqrt({self._print(base)})"
        raise WritingRuleError(f"no code for the power {expr}: only integer and half-integer powers")

    def _print_Mul(self, expr: Any) -> str:
        # A quotient by an integer is printed as one, so that 1/2 stays exact and readable.
        coefficient, rest = expr.as_coeff_Mul()
        if coefficient.is_Rational and coefficient.q != 1:
            numerator = rest * coefficient.p
            return f"{self.parenthesize(numerator, 50)}/{coefficient.q}"
        # A power is printed as a product, so it needs brackets below a fraction line.
        below = [f for f in sympy.Mul.make_args(expr) if f.is_Pow and f.exp.is_Rational and f.exp < 0]
        if len(below) == 1 and below[0].exp not in (-1, -sympy.Rational(1, 2)):
            return f"{self.parenthesize(expr / below[0], 50)}/({self._print(1 / below[0])})"
        return super()._print_Mul(expr)

    def _print_Function(self, expr: Any) -> str:
        name = _NAMES.get(type(expr)) or {"sin": "sin", "cos": "cos", "atan2": "arctan2"}.get(expr.func.__name__)
        if name is None:
            raise WritingRuleError(f"no code for the function {expr.func.__name__}; add it to slamlib.analytic")
        return f"{name}({', '.join(self._print(a) for a in expr.args)})"

    _print_sin = _print_cos = _print_atan2 = _print_Function


def functions(model: Model, traced: Trace) -> str:
    """The generated functions of one model: value, value with Jacobians, and with storage Jacobians if they differ."""
    flat = list(traced.value.ravel())
    parts = [_function(model, traced, "", "value", flat)]
    parts.append(_function(model, traced, "_jac", "value and Jacobians", flat + [e for j in traced.tangent for e in j]))
    if model.has_manifold:
        entries = flat + [e for j in traced.stored for e in j]
        parts.append(_function(model, traced, "_storage_jac", "value and derivatives by stored numbers", entries))
    return "\n\n".join(parts)


def _function(model: Model, traced: Trace, suffix: str, what: str, entries: list[Any]) -> str:
    taken = {str(s) for symbols in traced.symbols for s in symbols.ravel()}
    names = (sympy.Symbol(n, real=True) for n in (f"t{i}" for i in range(100000)) if n not in taken)
    shared, reduced = sympy.cse(entries, symbols=names, optimizations="basic", order="canonical", list=True)
    printer = Printer()
    used = set().union(*(e.free_symbols for e in reduced), *(e.free_symbols for _, e in shared))
    lines = [f"def {model.name}{suffix}({', '.join(model.parameters)}):", f'    """{model.name}: {what}."""']
    for name, symbols in zip(model.parameters, traced.symbols, strict=True):
        targets = [str(s) if s in used else "_" for s in symbols.ravel()]
        if any(t != "_" for t in targets):
            lines.append(f"    {', '.join(targets)}{',' if len(targets) == 1 else ''} = {name}")
    lines += [f"    {symbol} = {printer.doprint(expression)}" for symbol, expression in shared]
    lines += ["    return (", *(f"        {printer.doprint(e)}," for e in reduced), "    )"]
    return "\n".join(lines) + "\n"


def module(models: list[Model], source: str) -> str:
    """The text of a generated module for the models of one source file."""
    traces = [trace(m) for m in models]
    code = "\n\n".join(functions(m, t) for m, t in zip(models, traces, strict=True))
    used = sorted(n for n in _FUNCTIONS if re.search(rf"\b{n}\(", code))
    head = [
        f'"""Generated from {source} by `make generate` (sympy {sympy.__version__}); never edited by hand."""',
        "",
    ]
    if used:
        head += [f"from slamlib.analytic import {', '.join(used)}", ""]
    head += ["DIGESTS = {", *(f'    "{m.name}": "{digest.of(m)}",' for m in models), "}"]
    head += [
        "SHAPES = {",
        *(f'    "{m.name}": {t.value.shape!r},' for m, t in zip(models, traces, strict=True)),
        "}",
    ]
    return "\n".join(head) + "\n\n\n" + code
