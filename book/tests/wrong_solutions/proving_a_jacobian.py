"""Wrong solutions of chapter proving_a_jacobian."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("proving_a_jacobian.1", "the rule of thumb, whatever the function")
def rule_of_thumb(value, second, precision):
    return np.sqrt(precision)


@wrong("proving_a_jacobian.1", "sets the two errors' sum to zero without the factors of two")
def without_factors(value, second, precision):
    return np.sqrt(precision * abs(value / second))


@wrong("proving_a_jacobian.1", "the error of one value only: f(x + h) and f(x) are both rounded")
def one_value(value, second, precision):
    return np.sqrt(2 * precision * abs(value / second))


@wrong("proving_a_jacobian.1", "the cube root of the central difference")
def cube_root(value, second, precision):
    return np.cbrt(3 * precision * abs(value / second))


@wrong("proving_a_jacobian.2", "central differences: good, but not to the last digit")
def central(f, x):
    h = 1e-5
    return np.stack([(f(x + h * e) - f(x - h * e)) / (2 * h) for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.2", "the transposed Jacobian: derivatives along rows")
def transposed(f, x):
    return np.stack([np.imag(f(x + 1e-30j * e)) / 1e-30 for e in np.eye(len(x))])


@wrong("proving_a_jacobian.2", "one-sided differences with the best step")
def one_sided(f, x):
    h = 1e-8
    return np.stack([(f(x + h * e) - f(x)) / h for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.2", "a complex step that is not small")
def large_step(f, x):
    return np.stack([np.imag(f(x + 1e-3j * e)) / 1e-3 for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.2", "a real copy of the vector drops the imaginary step")
def real_copy(f, x):
    return np.stack([np.imag(f((x + 1e-30j * e).real)) / 1e-30 for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.2", "not divided by the step")
def not_divided(f, x):
    return np.stack([np.imag(f(x + 1e-30j * e)) for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.2", "earlier numbers keep their imaginary step")
def accumulated(f, x):
    moved, columns = np.array(x, dtype=complex), []
    for k in range(len(x)):
        moved[k] += 1e-30j
        columns.append(np.imag(f(moved)) / 1e-30)
    return np.stack(columns, axis=-1)


@wrong("proving_a_jacobian.2", "the difference of real parts, with a complex step")
def real_part(f, x):
    return np.stack([np.real(f(x + 1e-8j * e) - f(x)) / 1e-8 for e in np.eye(len(x))], axis=-1)


@wrong(
    "proving_a_jacobian.3",
    "everything divided by q, the heading's -1 too, as published in PythonRobotics (pull request 255)",
)
def all_over_q(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[dy, -dx, -1.0]]) / q


@wrong("proving_a_jacobian.3", "the square is forgotten, as in the chapter's first picture")
def range_for_its_square(robot, landmark):
    dx, dy = landmark - robot[:2]
    r = np.hypot(dx, dy)
    return np.array([[dy / r, -dx / r, -1.0]])


@wrong("proving_a_jacobian.3", "the derivative by the landmark")
def by_landmark(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[-dy / q, dx / q, -1.0]])


@wrong("proving_a_jacobian.3", "the rows' entries exchanged")
def exchanged(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[-dx / q, dy / q, -1.0]])


@wrong("proving_a_jacobian.3", "the heading left out: its derivative is zero")
def without_heading(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[dy / q, -dx / q, 0.0]])


@wrong("proving_a_jacobian.3", "one sign: as if the step moved the landmark along y")
def one_sign(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[dy / q, dx / q, -1.0]])


def step(robot, other, turn):
    """The derivative by a step in a frame that is turned by an angle."""
    d = complex(*(other - robot)[:2])
    return np.array([[np.imag(np.exp(1j * turn) / d), np.imag(1j * np.exp(1j * turn) / d), 0.0]])


@wrong("proving_a_jacobian.4", "by the position in the map, not by the step, as in GTSAM before pull request 2039")
def by_position(robot, other):
    return step(robot, other, 0.0)


@wrong("proving_a_jacobian.4", "turned back: the transposed rotation")
def turned_back(robot, other):
    return step(robot, other, -other[2])


@wrong("proving_a_jacobian.4", "the observer's heading for the other's")
def of_observer(robot, other):
    return step(robot, other, robot[2])


@wrong("proving_a_jacobian.4", "the heading of the one relative to the other")
def relative(robot, other):
    return step(robot, other, other[2] - robot[2])


@wrong("proving_a_jacobian.4", "the derivative by the other's turn, as if it were the observer's")
def turns(robot, other):
    return step(robot, other, other[2]) - [[0, 0, 1]]


@wrong("proving_a_jacobian.4", "the square forgotten")
def square_forgotten_again(robot, other):
    return step(robot, other, other[2]) * np.hypot(*(other - robot)[:2])


def numerical(f, x):
    return np.stack([np.imag(f(x + 1e-30j * e)) / 1e-30 for e in np.eye(len(x))], axis=-1)


@wrong("proving_a_jacobian.5", "one tolerance for all entries: wrong in small units")
def absolute(f, jacobian, points):
    return np.any([np.abs(jacobian(x) - numerical(f, x)) > 1e-6 for x in points], axis=0)


@wrong("proving_a_jacobian.5", "np.isclose as it comes: its absolute tolerance of 1e-8 hides small units")
def isclose(f, jacobian, points):
    return np.any([~np.isclose(jacobian(x), numerical(f, x)) for x in points], axis=0)


@wrong("proving_a_jacobian.5", "a tolerance relative to the largest entry of the matrix")
def largest(f, jacobian, points):
    found = []
    for x in points:
        J, D = jacobian(x), numerical(f, x)
        found.append(np.abs(J - D) > 1e-6 * np.abs(D).max())
    return np.any(found, axis=0)


@wrong("proving_a_jacobian.5", "looks at the first point only")
def first_point(f, jacobian, points):
    return absolute_or_relative(jacobian(points[0]), numerical(f, points[0]))


@wrong("proving_a_jacobian.5", "keeps the table of the last point only")
def last_point(f, jacobian, points):
    return absolute_or_relative(jacobian(points[-1]), numerical(f, points[-1]))


@wrong("proving_a_jacobian.5", "a tolerance of 1e-4 instead of a millionth")
def tolerant(f, jacobian, points):
    pairs = [(jacobian(x), numerical(f, x)) for x in points]
    return np.any([np.abs(J - D) > 1e-4 * np.maximum(np.abs(J), np.abs(D)) for J, D in pairs], axis=0)


@wrong("proving_a_jacobian.5", "any difference at all: half a millionth is not let pass")
def exact(f, jacobian, points):
    pairs = [(jacobian(x), numerical(f, x)) for x in points]
    return np.any([np.abs(J - D) > 1e-9 * np.maximum(np.abs(J), np.abs(D)) for J, D in pairs], axis=0)


@wrong("proving_a_jacobian.5", "an entry counts as wrong only if it is wrong everywhere")
def everywhere(f, jacobian, points):
    return np.all([absolute_or_relative(jacobian(x), numerical(f, x)) for x in points], axis=0)


@wrong("proving_a_jacobian.5", "the mean over the points, which hides what is wrong at one of them")
def on_average(f, jacobian, points):
    J, D = np.array([jacobian(x) for x in points]), np.array([numerical(f, x) for x in points])
    return np.abs(J - D).mean(0) > 1e-6 * np.maximum(np.abs(J), np.abs(D)).mean(0)


@wrong("proving_a_jacobian.5", "compares without the absolute value: what is too small passes")
def signed(f, jacobian, points):
    found = [jacobian(x) - numerical(f, x) > 1e-6 * np.abs(numerical(f, x)) for x in points]
    return np.any(found, axis=0)


@wrong("proving_a_jacobian.5", "passes over entries that are claimed to be zero, so as not to divide by them")
def nonzero_only(f, jacobian, points):
    return np.any([absolute_or_relative(J := jacobian(x), numerical(f, x)) & (J != 0) for x in points], axis=0)


def absolute_or_relative(J, D):
    return np.abs(J - D) > 1e-6 * np.maximum(np.abs(J), np.abs(D))
