"""Checks of the chapter: proving a Jacobian."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, same


@exercise("proving_a_jacobian.1", "the best step of a one-sided difference")
def best_step(candidate: Any) -> None:
    """No other step has a smaller bound of the error; for values of any size and sign, in any precision."""
    rng = np.random.default_rng(41)
    for precision in (2.0**-53, 2.0**-24):
        for _ in range(10):
            value, second = 10 ** rng.uniform(-3, 3, 2) * rng.choice([-1.0, 1.0], 2)
            h = float(array_of(candidate(value, second, precision), (), "the step"))
            given = f"for f = {value:.3g}, f'' = {second:.3g}, precision {precision:.3g}"
            holds(h > 0, "the step is positive", f"{given} it is {h:.3g}")
            bound, other = (
                2 * precision * abs(value) / s + s * abs(second) / 2 for s in (h, h * rng.uniform(0.5, 0.99))
            )
            holds(bound < other, "no smaller step has a smaller bound", f"{given} the step {h:.3g} is too large")
            other = 2 * precision * abs(value) / (h * 1.01) + h * 1.01 * abs(second) / 2
            holds(bound < other, "no larger step has a smaller bound", f"{given} the step {h:.3g} is too small")


@exercise("proving_a_jacobian.2", "the Jacobian by the complex step")
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


@exercise("proving_a_jacobian.3", "the derivative of a bearing")
def bearing_jacobian(candidate: Any) -> None:
    """Against the complex step of the bearing, at many places."""
    rng = np.random.default_rng(43)
    for _ in range(10):
        robot, landmark = rng.standard_normal(3), 5 * rng.standard_normal(2)
        found = array_of(candidate(robot, landmark), (1, 3), "the Jacobian")
        d = (landmark[0] - robot[0]) + 1j * (landmark[1] - robot[1])  # bearing = imaginary part of log(d)
        expected = [np.imag(-1 / d), np.imag(-1j / d), -1.0]
        same(found, [expected], "agrees with the derivative of the logarithm of a complex number")


@exercise("proving_a_jacobian.5", "finding the wrong entry")
def wrong_entries(candidate: Any) -> None:
    """Nothing found in a right Jacobian; one damaged entry found, in any unit, of either sign, at any of the points."""
    rng = np.random.default_rng(45)
    points = rng.uniform(0.5, 2, (4, 3))
    points[0] = 1.0  # where x = x^2 = x^3, and many a mistake does not show
    points[3] = rng.uniform(-2, -0.5, 3)
    found = array_of(candidate(_function, _derivative, points), (3, 3), "the table of wrong entries")
    holds(not found.any(), "finds nothing in a right Jacobian", f"found {found.astype(int).tolist()}")
    names = {
        "a sign": lambda entry, x: -entry,
        "one in a thousand too large": lambda entry, x: 1.001 * entry,
        "one in a thousand too small": lambda entry, x: 0.999 * entry,
        "a factor x forgotten": lambda entry, x: entry / x[2],
        "a factor that is right where x is positive": lambda entry, x: entry * np.sign(x[2]),
    }
    for name, damage in names.items():
        for i, j in ((0, 0), (0, 2), (1, 1), (2, 0), (2, 2)):
            expected = np.zeros((3, 3))
            expected[i, j] = 1
            _one_found(candidate, damage, (i, j), points, f"finds {name}, in every unit", expected)
    expected = np.zeros((3, 3))
    expected[1, 0] = 1
    _one_found(candidate, lambda entry, x: entry + 1e-3, (1, 0), points, "finds a number where zero belongs", expected)


def _one_found(candidate: Any, damage: Any, at: tuple[int, int], points: Any, what: str, expected: Any) -> None:
    def damaged(x: Any) -> Any:
        J = _derivative(x)
        J[at] = damage(J[at], x)
        return J

    found = array_of(candidate(_function, damaged, points), (3, 3), "the table of wrong entries")
    otherwise = f"damaged was entry {at}, found was {found.astype(int).tolist()}"
    holds(np.array_equal(found != 0, expected != 0), what, otherwise)


def _function(x: Any) -> Any:
    """Three results in three units: one of order 1, one a million times larger, one a million times smaller."""
    return np.array([x[0] * x[2] ** 2, 1e6 * np.sin(x[1]), 1e-6 * x[0] ** 2 / x[2]])


def _derivative(x: Any) -> Any:
    return np.array(
        [
            [x[2] ** 2, 0.0, 2 * x[0] * x[2]],
            [0.0, 1e6 * np.cos(x[1]), 0.0],
            [2e-6 * x[0] / x[2], 0.0, -1e-6 * x[0] ** 2 / x[2] ** 2],
        ]
    )
