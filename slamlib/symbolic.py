"""The smooth functions of slamlib.analytic as sympy functions that know their derivatives."""

from typing import Any

import sympy


class Smooth(sympy.Function):
    """A function of two arguments that is smooth where its closed form is 0 / 0; latex: how it is typeset."""

    nargs = 2
    latex: str

    def _latex(self, printer: Any) -> str:
        return self.latex.format(*map(printer._print, self.args))


class Stumpff(Smooth):
    """c_k(s); see slamlib.analytic.stumpff."""

    latex = r"c_{{{}}}\left({}\right)"

    @classmethod
    def eval(cls, order: sympy.Expr, s: sympy.Expr) -> sympy.Expr:
        if s.is_zero:
            return 1 / sympy.factorial(order)
        return None

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        if argindex != 2:
            raise sympy.function.ArgumentIndexError(self, argindex)
        order, s = self.args
        return (order * Stumpff(order + 2, s) - Stumpff(order + 1, s)) / 2

    def closed_form(self) -> sympy.Expr:
        """The same function in terms of cosine and sine of the square root of s."""
        order, s = self.args
        angle = sympy.sqrt(s)
        value = sympy.cos(angle) if order % 2 == 0 else sympy.sin(angle) / angle
        for k in range(order % 2, int(order), 2):
            value = (1 / sympy.factorial(k) - value) / s
        return value


class ArctanRatio(Smooth):
    """arctan(sqrt(s)/w)/sqrt(s); see slamlib.analytic.arctan_ratio."""

    latex = r"a\left({}, {}\right)"

    @classmethod
    def eval(cls, s: sympy.Expr, w: sympy.Expr) -> sympy.Expr:
        return 1 / w if s.is_zero else None

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        s, w = self.args
        return ArctanRatioSlope(s, w) if argindex == 1 else -1 / (s + w**2)

    def closed_form(self) -> sympy.Expr:
        """The same function in terms of arctangent and square root."""
        s, w = self.args
        return sympy.atan(sympy.sqrt(s) / w) / sympy.sqrt(s)


class ArctanRatioSlope(Smooth):
    """Derivative of ArctanRatio with respect to s."""

    latex = r"a_s\left({}, {}\right)"

    @classmethod
    def eval(cls, s: sympy.Expr, w: sympy.Expr) -> sympy.Expr:
        return -1 / (3 * w**3) if s.is_zero else None

    def closed_form(self) -> sympy.Expr:
        """The same function in terms of arctangent and square root."""
        s, w = self.args
        return (w / (s + w**2) - ArctanRatio(s, w).closed_form()) / (2 * s)


class NormPlus(Smooth):
    """sqrt(s + z^2) + z; see slamlib.analytic.norm_plus."""

    latex = r"n_+\left({}, {}\right)"

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        s, z = self.args
        return (sympy.Rational(1, 2) if argindex == 1 else self) / sympy.sqrt(s + z**2)

    def closed_form(self) -> sympy.Expr:
        """The same function in terms of the square root."""
        s, z = self.args
        return sympy.sqrt(s + z**2) + z


def closed_form(expression: sympy.Expr) -> sympy.Expr:
    """The expression with every smooth function written out (valid away from s = 0)."""
    return expression.replace(lambda e: isinstance(e, Smooth), lambda e: e.closed_form())
