"""The functions that a model may use: one name each, for symbols, floats, arrays and complex steps.

While a model is traced they build sympy expressions; in generated code they compute with `math` for a single item
and with NumPy for a batch. Angles in radians.
"""

import math
from functools import cache
from typing import Any

import numpy as np

Value = Any  # float, complex, numpy array, or sympy expression


def _is_symbolic(*values: Value) -> bool:
    return any(hasattr(v, "free_symbols") for v in values)


def _function(name: str) -> Any:
    """The function `name` for each kind of argument."""
    scalar, array = getattr(math, name), getattr(np, name)

    def call(x: Value) -> Value:
        if type(x) is float:
            return scalar(x)
        if not isinstance(x, np.ndarray | np.generic) and _is_symbolic(x):
            import sympy

            return getattr(sympy, name)(x)
        return array(x)

    call.__name__ = call.__qualname__ = name
    call.__doc__ = f"{name}(x), elementwise."
    return call


sin, cos, sqrt, exp, log = map(_function, ("sin", "cos", "sqrt", "exp", "log"))


def arctan2(y: Value, x: Value) -> Value:
    """Angle of the point (x, y), in (-pi, pi]; a complex argument carries its derivative to first order."""
    if type(x) is float and type(y) is float:
        return math.atan2(y, x)
    if _is_symbolic(x, y):
        import sympy

        return sympy.atan2(y, x)
    y, x = np.asarray(y), np.asarray(x)
    if np.iscomplexobj(y) or np.iscomplexobj(x):
        slope = (x.real * y.imag - y.real * x.imag) / (x.real**2 + y.real**2)
        return np.arctan2(y.real, x.real) + 1j * slope
    return np.arctan2(y, x)


def stumpff(order: int, s: Value) -> Value:
    """Stumpff function c_k(s) = sum_j (-s)^j / (2j + k)!, for the squared angle s >= 0: smooth at s = 0.

    c_0 = cos(sqrt s), c_1 = sin(sqrt s)/sqrt s, c_2 = (1 - cos(sqrt s))/s, c_3 = (sqrt s - sin(sqrt s))/s^(3/2);
    the family is closed under differentiation: c_k' = (k c_(k+2) - c_(k+1)) / 2. Source: Battin, An Introduction to
    the Mathematics and Methods of Astrodynamics (1999), section 4.5 (as U-functions); derived in chapter
    frames_and_quaternions.
    """
    if type(s) is float:
        return _stumpff_series(order, s) if s < _SERIES else _stumpff_closed(order, s, math)
    if _is_symbolic(s):
        from slamlib.symbolic import Stumpff

        return Stumpff(order, s)
    s = np.asarray(s)
    small = s.real < _SERIES
    near = _stumpff_series(order, np.where(small, s, 0))
    return np.where(small, near, _stumpff_closed(order, np.where(small, _SERIES, s), np))


_SERIES = 2.0  # below this squared angle the series is exact to the last digit with 13 terms


def _stumpff_series(order: int, s: Value) -> Value:
    total = s * 0.0
    for coefficient in _stumpff_coefficients(order):
        total = total * -s + coefficient
    return total


@cache
def _stumpff_coefficients(order: int) -> list[float]:
    """1 / (2j + order)! for j = 12, ..., 0."""
    return [1.0 / math.factorial(2 * j + order) for j in range(12, -1, -1)]


def _stumpff_closed(order: int, s: Value, library: Any) -> Value:
    angle = library.sqrt(s)
    value = library.cos(angle) if order % 2 == 0 else library.sin(angle) / angle
    for k in range(order % 2, order, 2):  # c_(k+2) = (1/k! - c_k) / s
        value = (1.0 / math.factorial(k) - value) / s
    return value


def arctan_ratio(s: Value, w: Value) -> Value:
    """arctan(sqrt(s)/w) / sqrt(s), smooth at s = 0 and odd in w.

    With s the squared norm of a quaternion's vector part and w its scalar part, twice this value times the vector part
    is the rotation vector; odd in w, so that a quaternion and its negative give the same one. Derived in chapter
    frames_and_quaternions.
    """
    return _arctan(s, w, "ArctanRatio", _ratio_series, _ratio_closed)


def arctan_ratio_slope(s: Value, w: Value) -> Value:
    """Derivative of arctan_ratio with respect to s: (w/(s + w^2) - arctan_ratio(s, w)) / (2 s), smooth at s = 0."""
    return _arctan(s, w, "ArctanRatioSlope", _slope_series, _slope_closed)


def _arctan(s: Value, w: Value, symbol: str, series: Any, closed: Any) -> Value:
    if type(s) is float and type(w) is float:
        return series(s, w) if s < w * w / _NEAR else closed(s, w)
    if _is_symbolic(s, w):
        from slamlib import symbolic

        return getattr(symbolic, symbol)(s, w)
    s, w = np.asarray(s), np.asarray(w)
    small = s.real < w.real**2 / _NEAR
    near = series(np.where(small, s, 0), np.where(small, w, 1))
    return np.where(small, near, closed(np.where(small, 1, s), w))


_NEAR = 10  # below s = w^2 / 10 the 17 terms of the series are exact to the last digit


def _ratio_series(s: Value, w: Value) -> Value:
    z, total = s / w**2, 0.0
    for j in range(16, -1, -1):
        total = total * -z + 1.0 / (2 * j + 1)
    return total / w


def _ratio_closed(s: Value, w: Value) -> Value:
    sign = 1.0 - 2.0 * (w.real < 0)  # fold onto w >= 0: arctan, not arctan2, of sqrt(s)/w
    y = sqrt(s)
    return sign * arctan2(y, sign * w) / y


def _slope_series(s: Value, w: Value) -> Value:
    z, total = s / w**2, 0.0
    for j in range(17, 0, -1):
        total = total * -z - j / (2 * j + 1)
    return total / w**3


def _slope_closed(s: Value, w: Value) -> Value:
    return (w / (s + w**2) - _ratio_closed(s, w)) / (2 * s)


def norm_plus(s: Value, z: Value) -> Value:
    """sqrt(s + z^2) + z for s >= 0, with all digits for z < 0 too, where it is s / (sqrt(s + z^2) - z)."""
    if type(s) is float and type(z) is float:
        norm = math.sqrt(s + z * z)
        return norm + z if z >= 0 else s / (norm - z)
    if _is_symbolic(s, z):
        from slamlib.symbolic import NormPlus

        return NormPlus(s, z)
    s, z = np.asarray(s), np.asarray(z)
    norm, behind = np.sqrt(s + z * z), z.real < 0
    return np.where(behind, s / np.where(behind, norm - z, 1), norm + z)
