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
