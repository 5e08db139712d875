"""Wrong solutions of chapter 4."""

import numpy as np

from slamlib.tests.wrong_solutions import wrong


@wrong("4.2", "central differences: good, but not to the last digit")
def central(f, x):
    h = 1e-5
    return np.stack([(f(x + h * e) - f(x - h * e)) / (2 * h) for e in np.eye(len(x))], axis=-1)


@wrong("4.2", "the transposed Jacobian: derivatives along rows")
def transposed(f, x):
    return np.stack([np.imag(f(x + 1e-30j * e)) / 1e-30 for e in np.eye(len(x))])


@wrong("4.3", "-1/q, as published in PythonRobotics (issue 255)")
def one_over_q(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[1 / q, -dx / q, -1.0]])


@wrong("4.3", "the derivative by the landmark")
def by_landmark(robot, landmark):
    dx, dy = landmark - robot[:2]
    q = dx * dx + dy * dy
    return np.array([[-dy / q, dx / q, -1.0]])
