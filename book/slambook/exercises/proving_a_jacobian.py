"""Checks of the chapter: proving a Jacobian."""

from collections.abc import Callable

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, given, holds, number, same
from slamlib.manifolds import Array


@exercise("proving_a_jacobian.1", "the best step of a one-sided difference", seed=41)
def best_step(candidate: Candidate, rng: Rng) -> None:
    """No other step has a smaller bound of the error; for values of any size and sign, in any precision."""
    for precision in cases(np.repeat([2.0**-53, 2.0**-24], 10)):
        value, second = 10 ** rng.uniform(-3, 3, 2) * rng.choice([-1.0, 1.0], 2)
        h = number(candidate(value, second, float(precision)), "the step")
        given(f"f = {value:.3g}, f'' = {second:.3g}, precision {precision:.3g}")
        holds(h > 0, "the step is positive", f"it is {h:.3g}")
        steps = h * np.array([1, rng.uniform(0.5, 0.99), 1.01])
        bound, smaller, larger = 2 * precision * abs(value) / steps + steps * abs(second) / 2
        holds(bound < smaller, "no smaller step has a smaller bound", f"the step {h:.3g} is too large")
        holds(bound < larger, "no larger step has a smaller bound", f"the step {h:.3g} is too small")


@exercise("proving_a_jacobian.2", "the Jacobian by the complex step", seed=42)
def complex_jacobian(candidate: Candidate, rng: Rng) -> None:
    """Exact to rounding, which no difference is; and right for functions of several results."""
    A = rng.standard_normal((3, 4))
    x = rng.standard_normal(4)
    linear = candidate(lambda v: A @ v, x)
    dropped = "all are: an array of real numbers drops the imaginary step"
    holds(np.any(np.asarray(linear) != 0), "not every entry is zero", dropped)
    same(linear, A, "a linear function gives its matrix", tolerance=1e-6)
    found = candidate(lambda v: np.exp(v[:2] * v[2:]), x)
    e = np.exp(x[:2] * x[2:])
    expected = np.hstack([np.diag(e * x[2:]), np.diag(e * x[:2])])
    same(found, expected, "products and exponentials have their derivatives", tolerance=1e-6)
    exact = "to the last digits, which no difference of two values gives"
    same(found, expected, exact, tolerance=1e-14)
    same(linear, A, exact, tolerance=1e-14)


@exercise("proving_a_jacobian.3", "the derivative of a bearing", seed=43)
def bearing_jacobian(candidate: Candidate, rng: Rng) -> None:
    """Entry by entry: a turn, the distance, a step along the line of sight; then against a complex logarithm."""
    for _ in range(10):
        robot, d = rng.standard_normal(3), 5 * rng.standard_normal(2)
        found = array_of(candidate(robot, robot[:2] + d), (1, 3), "the Jacobian")[0]
        given(f"robot {robot.round(3)}, landmark {np.hypot(*d):.3g} m away")
        turn = "entry [0, 2] is that of the heading: to turn the robot turns the bearing back as much, at any distance"
        same(found[2], -1.0, turn)
        far = array_of(candidate(robot, robot[:2] + 2 * d), (1, 3), "the Jacobian")[0]
        same(far[:2], found[:2] / 2, "twice as far away, entries [0, 0] and [0, 1] are half as large")
        along = found[:2] @ d / np.hypot(*d)
        same(along, 0.0, "a step straight to the landmark does not change the bearing")
        expected = [np.imag(-1 / complex(*d)), np.imag(-1j / complex(*d))]  # bearing = imaginary part of log(d)
        for entry, axis in enumerate("xy"):
            what = f"entry [0, {entry}] is the derivative with respect to {axis}"
            same(found[entry], expected[entry], what)


@exercise("proving_a_jacobian.4", "the derivative by a step of the other robot", seed=44)
def bearing_by_step(candidate: Candidate, rng: Rng) -> None:
    """No heading, a turn, a step along the line of sight and across; then against a complex logarithm."""
    for k in range(10):
        robot, other = 4 * rng.standard_normal((2, 3))
        other[2] = 0.0 if k == 0 else other[2]
        found = array_of(candidate(robot, other), (1, 3), "the Jacobian")[0]
        given(f"robot {robot.round(3)}, other {other.round(3)}")
        d, heading = complex(*(other - robot)[:2]), np.exp(1j * other[2])
        expected = [np.imag(heading / d), np.imag(1j * heading / d)]  # bearing = imaginary part of log(d)
        same(found[2], 0.0, "entry [0, 2]: the other robot may turn, its bearing stays")
        if k == 0:
            same(found[:2], expected, "with heading zero a step ahead is one along x")
            continue
        looks = np.append(other[:2], np.angle(d))  # away from the observer: its step ahead is along the line of sight
        given(f"robot {robot.round(3)}, other {looks.round(3)}, which looks away from it")
        away = array_of(candidate(robot, looks), (1, 3), "the Jacobian")[0]
        same(away[0], 0.0, "entry [0, 0]: a step ahead, along the line of sight, does not change the bearing")
        same(away[1], 1 / abs(d), "entry [0, 1]: a step to the left, across it, changes the bearing by step / range")
        given(f"robot {robot.round(3)}, other {other.round(3)}")
        same(found[:2], expected, "entries [0, 0] and [0, 1]: ahead and left are those of the other robot's heading")


@exercise("proving_a_jacobian.5", "finding the wrong entry", seed=45)
def wrong_entries(candidate: Candidate, rng: Rng) -> None:
    """Nothing found in a right Jacobian; one damaged entry found, in any unit, of either sign, at any of the points."""
    points = rng.uniform(0.5, 2, (4, 3))
    points[[0, 3]] = 1.0  # where x = x^2 = x^3, and many a mistake does not show
    points[1] = rng.uniform(-2, -0.5, 3)

    def table(derivative: Callable[..., Array]) -> Array:
        return array_of(candidate(_function, derivative, points), (3, 3), "the table of wrong entries")

    for share, what in (0, "finds nothing in a right Jacobian"), (5e-7, "lets half a millionth pass"):
        found = table(lambda x, share=share: (1 + share) * _derivative(x))
        holds(not found.any(), what, f"found {found.astype(int).tolist()}")
    damages = {
        "a sign": lambda J, x: -J,
        "two in a million too large": lambda J, x: (1 + 2e-6) * J,
        "two in a million too small": lambda J, x: (1 - 2e-6) * J,
        "a factor x forgotten": lambda J, x: J / x[2],
        "a factor that is right where x is positive": lambda J, x: J * np.sign(x[2]),
        "two in a million, where x is negative": lambda J, x: (1 + 2e-6 * (x[2] < 0)) * J,
        "zero where a number belongs": lambda J, x: 0 * J,
        "a number where zero belongs": lambda J, x: J + 1e-3,
    }
    for name, damage in damages.items():
        zero = name == "a number where zero belongs"
        what = f"finds {name}" + ("" if zero else ", in every unit")
        for at in [(1, 0)] if zero else [(0, 0), (0, 2), (1, 1), (2, 0), (2, 2)]:
            expected = np.arange(9).reshape(3, 3) == 3 * at[0] + at[1]
            found = table(lambda x, damage=damage, at=expected: np.where(at, damage(_derivative(x), x), _derivative(x)))
            otherwise = f"damaged was entry {at}, found was {found.astype(int).tolist()}"
            holds(np.array_equal(found != 0, expected), what, otherwise)


def _function(x: Array) -> Array:
    """Three results in three units: one of order 1, one a million times larger, one a million times smaller."""
    return np.array([x[0] * x[2] ** 2, 1e6 * np.sin(x[1]), 1e-6 * x[0] ** 2 / x[2]])


def _derivative(x: Array) -> Array:
    return np.array([
        [x[2] ** 2, 0.0, 2 * x[0] * x[2]],
        [0.0, 1e6 * np.cos(x[1]), 0.0],
        [2e-6 * x[0] / x[2], 0.0, -1e-6 * x[0] ** 2 / x[2] ** 2],
    ])  # fmt: skip
