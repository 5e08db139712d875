"""Wrong solutions of chapter 3."""

import numpy as np

from slamlib.tests.wrong_solutions import wrong


@wrong("3.2", "one step only: the ordinary EKF")
def one_step(x0, P, z, R, h, jacobian):
    H = jacobian(x0)
    return x0 + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x0))


@wrong("3.2", "restarts each iteration from the last state, and so forgets the prior")
def forgets_prior(x0, P, z, R, h, jacobian):
    x = x0
    for _ in range(20):
        H = jacobian(x)
        x = x + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x))
    return x


@wrong("3.2", "leaves out the term H (x0 - x)")
def without_shift(x0, P, z, R, h, jacobian):
    x = x0
    for _ in range(20):
        H = jacobian(x)
        x = x0 + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x))
    return x


def _moved(x, u):
    return x + np.array([u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]])


def _jacobians(x, u):
    c, s = np.cos(x[2]), np.sin(x[2])
    return np.array([[1, 0, -u[0] * s], [0, 1, u[0] * c], [0, 0, 1]]), np.array([[c, 0], [s, 0], [0, 1]])


@wrong("3.3", "Jacobians after the motion, as in PythonRobotics issue 305")
def after_the_motion(x, P, u, Q):
    x = _moved(x, u)
    F, G = _jacobians(x, u)
    return x, F @ P @ F.T + G @ Q @ G.T


@wrong("3.3", "adds the control's covariance without its Jacobian")
def noise_in_the_wrong_frame(x, P, u, Q):
    F, _ = _jacobians(x, u)
    return _moved(x, u), F @ P @ F.T + np.diag([Q[0, 0], Q[0, 0], Q[1, 1]])


@wrong("3.3", "forgets the control's noise")
def without_noise(x, P, u, Q):
    F, _ = _jacobians(x, u)
    return _moved(x, u), F @ P @ F.T
