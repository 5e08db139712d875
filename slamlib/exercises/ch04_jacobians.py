"""Checks of chapter 4: proving a Jacobian."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, same


@exercise("4.2", "the Jacobian by the complex step")
def complex_jacobian(candidate: Any) -> None:
    """Exact to rounding, which no difference is; and right for functions of several results."""
    rng = np.random.default_rng(42)
    A = rng.standard_normal((3, 4))
    x = rng.standard_normal(4)
    same(candidate(lambda v: A @ v, x), A, "a linear function gives its matrix", tolerance=1e-14)
    found = candidate(lambda v: np.exp(v[:2] * v[2:]), x)
    e = np.exp(x[:2] * x[2:])
    expected = np.hstack([np.diag(e * x[2:]), np.diag(e * x[:2])])
    same(found, expected, "products and exponentials, to the last digits", tolerance=1e-14)


@exercise("4.3", "the derivative of a bearing")
def bearing_jacobian(candidate: Any) -> None:
    """Against the complex step of the bearing, at many places."""
    rng = np.random.default_rng(43)
    for _ in range(10):
        robot, landmark = rng.standard_normal(3), 5 * rng.standard_normal(2)
        found = array_of(candidate(robot, landmark), (1, 3), "the Jacobian")
        d = (landmark[0] - robot[0]) + 1j * (landmark[1] - robot[1])  # bearing = imaginary part of log(d)
        expected = [np.imag(-1 / d), np.imag(-1j / d), -1.0]
        same(found, [expected], "agrees with the derivative of the logarithm of a complex number")
