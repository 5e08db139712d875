"""Print expressions as plain arithmetic, line by line; each power, reciprocal and root is a line of its own."""

from collections.abc import Iterator

import sympy
from sympy.printing.pycode import PythonCodePrinter

from slamlib.errors import WritingRuleError
from slamlib.symbolic import ArctanRatio, ArctanRatioSlope, NormPlus, Stumpff

_NAMES = {
    Stumpff: "stumpff", ArctanRatio: "arctan_ratio", ArctanRatioSlope: "arctan_ratio_slope", NormPlus: "norm_plus",
    sympy.atan2: "arctan2",
    **{getattr(sympy, name): name for name in ("sin", "cos", "exp", "log")},
}  # fmt: skip
_HALF = sympy.Rational(1, 2)


class Printer(PythonCodePrinter):
    """Python arithmetic with the functions of slamlib.analytic; `lines` collects the lines that the printed text uses.

    names: unused names for those lines. Each line is written once: equal texts get the same name.
    shared, stages: symbols that stand for an expression, which is a line before the first use; a stage keeps its name.
    """

    def __init__(
        self,
        names: Iterator[str],
        shared: dict[sympy.Expr, sympy.Expr] | None = None,
        stages: dict[sympy.Symbol, sympy.Expr] | None = None,
    ) -> None:
        super().__init__({"fully_qualified_modules": False})
        self.lines: list[str] = []
        self.used: set[sympy.Symbol] = set()
        self._stands_for, self._stages = {**(shared or {}), **(stages or {})}, stages or {}
        self._unused, self._name_of, self._renamed = names, {}, {}  # type: ignore[var-annotated]

    def line(self, text: str, name: str = "") -> str:
        """The name of a line that computes `text`."""
        if text.isidentifier():
            return text
        if text not in self._name_of:
            self._name_of[text] = name or next(self._unused)
            self.lines.append(f"{self._name_of[text]} = {text}")
        return self._name_of[text]

    def _print_Symbol(self, expr: sympy.Symbol) -> str:
        self.used.add(expr)
        if expr in self._stands_for and expr not in self._renamed:
            text = self.doprint(self._stands_for[expr])
            self._renamed[expr] = self.line(text, expr.name if expr in self._stages else "")
        return self._renamed.get(expr, expr.name)

    def _print_Pow(self, expr: sympy.Expr, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if not (2 * exponent).is_Integer:
            raise WritingRuleError(f"no code for the power {expr}: only integer and half-integer powers")
        if exponent < 0:
            return self._power(self.line(f"1/{self.line(self._print(base))}"), -exponent)
        return self._power(self.line(self._print(base)), exponent)

    def _power(self, base: str, exponent: sympy.Expr) -> str:
        """The name of a power of the variable `base`: x^5 from x^3 and x^2, x^3 from x^2 and x."""
        if exponent == 1:
            return base
        if exponent == _HALF:
            return self.line(f"sqrt({base})")
        half = exponent - _HALF if not exponent.is_Integer else (exponent + 1) // 2
        return self.line(f"{self._power(base, half)}*{self._power(base, exponent - half)}")

    def _print_Mul(self, expr: sympy.Expr) -> str:
        # A quotient by an integer is printed as one, so that 1/2 stays exact and readable.
        coefficient, rest = expr.as_coeff_Mul()
        if coefficient.is_Rational and coefficient.q != 1:
            return f"{self.parenthesize(rest * coefficient.p, 50)}/{coefficient.q}"
        sign, size = "-" if coefficient < 0 else "", abs(coefficient)
        first, *others = sorted(self._factors(sympy.Mul.make_args(rest)))
        if size == 2:  # for arrays a sum is half as expensive as a product with a number
            twice = self.line(first.removeprefix("(").removesuffix(")") if rest.is_Add else first)
            first = self.line(f"{twice} + {twice}")
        elif size != 1:
            first = f"{size}*{first}"
        return sign + "*".join([first, *others])

    def _factors(self, factors: tuple[sympy.Expr, ...]) -> list[str]:
        """Texts of factors; x^4 z^-9 becomes (x z^-2)^4 z^-1, which overflows only where the whole product does."""
        powers = [f.as_base_exp() for f in factors]
        high = [abs(e) for _, e in powers if e.is_Integer and abs(e) > 1]
        if len(high) < 2:
            return [self.parenthesize(f, 50) for f in factors]
        k = min(high)
        whole = [(b, int(e / k) if e.is_Integer else 0, e) for b, e in powers]
        ratio = self.line(self._print(sympy.Mul(*(b**n for b, n, _ in whole))))
        rest = [b ** (e - k * n) for b, n, e in whole if e != k * n]
        return [self._power(ratio, k), *(self.parenthesize(f, 50) for f in rest)]

    def _print_Function(self, expr: sympy.Expr) -> str:
        name = _NAMES.get(expr.func)
        if name is None:
            raise WritingRuleError(f"no code for the function {expr.func.__name__}; add it to slamlib.analytic")
        return f"{name}({', '.join(self._print(a) for a in expr.args)})"

    _print_sin = _print_cos = _print_exp = _print_log = _print_atan2 = _print_Function
