"""Wrong solutions of chapter extended_kalman_filter."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _across(x, landmark):
    d = x - landmark
    return np.array([-d[1], d[0]]) / np.hypot(*d), np.hypot(*d)


@wrong("extended_kalman_filter.1", "the half of Taylor's second term is forgotten")
def without_the_half(x, landmark, P):
    b, distance = _across(x, landmark)
    return b @ P @ b / distance


@wrong("extended_kalman_filter.1", "all of P counts, also along the line of sight")
def whole_trace(x, landmark, P):
    return np.trace(P) / (2 * np.hypot(*(x - landmark)))


@wrong("extended_kalman_filter.1", "along the line of sight instead of across it")
def along(x, landmark, P):
    d = (x - landmark) / np.hypot(*(x - landmark))
    return d @ P @ d / (2 * np.hypot(*(x - landmark)))


@wrong("extended_kalman_filter.1", "divides by the square of the distance")
def square_of_distance(x, landmark, P):
    b, distance = _across(x, landmark)
    return b @ P @ b / (2 * distance**2)


@wrong("extended_kalman_filter.1", "the sign of the sonar's bias, whose range is given and not measured")
def shorter(x, landmark, P):
    b, distance = _across(x, landmark)
    return -b @ P @ b / (2 * distance)


@wrong("extended_kalman_filter.4", "plain difference")
def plain(z, e):
    return z - e


@wrong("extended_kalman_filter.4", "each bearing is wrapped, but their difference is not")
def wrapped_before(z, e):
    def wrap(angle):
        return (angle + np.pi) % (2 * np.pi) - np.pi

    return np.array([z[0] - e[0], wrap(z[1]) - wrap(e[1])])


@wrong("extended_kalman_filter.4", "wraps the whole vector, the range with it")
def range_too(z, e):
    return (z - e + np.pi) % (2 * np.pi) - np.pi


@wrong("extended_kalman_filter.4", "takes away one turn at most, and only on one side")
def one_turn(z, e):
    nu = z - e
    return nu - [0, 2 * np.pi] if nu[1] > np.pi else nu


@wrong("extended_kalman_filter.4", "arctan of the tangent: half turns are lost as well")
def half_turns(z, e):
    return np.array([z[0] - e[0], np.arctan(np.tan(z[1] - e[1]))])


@wrong("extended_kalman_filter.4", "the remainder from 0 to 2 pi")
def never_negative(z, e):
    return np.array([z[0] - e[0], (z[1] - e[1]) % (2 * np.pi)])


@wrong("extended_kalman_filter.2", "one step only: the ordinary EKF")
def one_step(x0, P, z, R, h, jacobian):
    H = jacobian(x0)
    return x0 + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x0))


def _iterated(x0, P, z, R, h, jacobian, prior=True, shift=1):
    x = x0
    for _ in range(20):
        H = jacobian(x)
        x = (x0 if prior else x) + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x) - shift * H @ (x0 - x))
    return x


wrong("extended_kalman_filter.2", "full steps, never halved")(lambda *given: _iterated(*given))
wrong("extended_kalman_filter.2", "leaves out the term H (x0 - x)")(lambda *given: _iterated(*given, shift=0))
wrong("extended_kalman_filter.2", "restarts each iteration from the last state, and so forgets the prior")(
    lambda *given: _iterated(*given, prior=False, shift=0)
)
wrong("extended_kalman_filter.2", "of P only the variances")(
    lambda x0, P, *given: _iterated(x0, np.diag(np.diag(P)), *given)
)


def _moved(x, u):
    return x + np.array([u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]])


def _jacobians(x, u):
    c, s = np.cos(x[2]), np.sin(x[2])
    return np.array([[1, 0, -u[0] * s], [0, 1, u[0] * c], [0, 0, 1]]), np.array([[c, 0], [s, 0], [0, 1]])


def _predicted(x, P, u, Q, F_at, G_at):
    F, G = _jacobians(F_at, u)[0], _jacobians(G_at, u)[1]
    return _moved(x, u), F @ P @ F.T + G @ Q @ G.T


@wrong("extended_kalman_filter.3", "adds the control's covariance without its Jacobian")
def noise_in_the_wrong_frame(x, P, u, Q):
    F, _ = _jacobians(x, u)
    return _moved(x, u), F @ P @ F.T + np.diag([Q[0, 0], Q[0, 0], Q[1, 1]])


wrong("extended_kalman_filter.3", "Jacobian after the motion (E02), as in PythonRobotics before its pull request 305")(
    lambda x, P, u, Q: _predicted(x, P, u, Q, _moved(x, u), x)
)
wrong("extended_kalman_filter.3", "the control's Jacobian after the motion")(
    lambda x, P, u, Q: _predicted(x, P, u, Q, x, _moved(x, u))
)
wrong("extended_kalman_filter.3", "of P only the variances")(
    lambda x, P, u, Q: _predicted(x, np.diag(np.diag(P)), u, Q, x, x)
)
wrong("extended_kalman_filter.3", "forgets the control's noise")(lambda x, P, u, Q: _predicted(x, P, u, 0 * Q, x, x))


@wrong("extended_kalman_filter.1", "of P only the variances")
def no_correlation(x, landmark, P):
    b, distance = _across(x, landmark)
    return b**2 @ np.diag(P) / (2 * distance)


@wrong(
    "extended_kalman_filter.1",
    "the matrix of second derivatives at the landmark's own place: the robot is at the origin",
)
def from_the_origin(x, landmark, P):
    b, distance = _across(0 * x, landmark)
    return b @ P @ b / (2 * distance)


@wrong("extended_kalman_filter.1", "the scatter in place of the bias")
def scatter(x, landmark, P):
    b, distance = _across(x, landmark)
    return b @ P @ b / (np.sqrt(2) * distance)


@wrong("extended_kalman_filter.1", "the standard deviation across, not its square")
def not_squared(x, landmark, P):
    b, distance = _across(x, landmark)
    return np.sqrt(b @ P @ b) / (2 * distance)


@wrong("extended_kalman_filter.1", "the second derivatives themselves, without P")
def without_P(x, landmark, P):
    return 1 / (2 * np.hypot(*(x - landmark)))


@wrong("extended_kalman_filter.2", "H and K of the first iteration in all others")
def old_tangent(x0, P, z, R, h, jacobian):
    x, H = x0, jacobian(x0)
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    for _ in range(50):
        x = x0 + K @ (z - h(x) - H @ (x0 - x))
    return x


@wrong("extended_kalman_filter.2", "P is updated within the loop, so that the measurement counts many times")
def many_measurements(x0, P, z, R, h, jacobian):
    x = x0
    for _ in range(20):
        H = jacobian(x)
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        x, P = x0 + K @ (z - h(x) - H @ (x0 - x)), P - K @ H @ P
    return x


@wrong("extended_kalman_filter.2", "halves its steps, but leaves out the term H (x0 - x)")
def halved_without_the_bracket(x0, P, z, R, h, jacobian):
    def cost(x):
        return (x - x0) @ np.linalg.solve(P, x - x0) + (z - h(x)) @ np.linalg.solve(R, z - h(x))

    x = x0
    for _ in range(100):
        H = jacobian(x)
        step = x0 + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x)) - x
        while cost(x + step) > cost(x) and np.linalg.norm(step) > 1e-9:
            step = step / 2
        x = x + step
        if np.linalg.norm(step) < 1e-9:
            break
    return x


@wrong("extended_kalman_filter.2", "two iterations are enough for anybody")
def two_steps(x0, P, z, R, h, jacobian):
    x = x0
    for _ in range(2):
        H = jacobian(x)
        x = x0 + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, z - h(x) - H @ (x0 - x))
    return x


@wrong("extended_kalman_filter.2", "the prior is forgotten: least squares of the measurement alone")
def measurement_alone(x0, P, z, R, h, jacobian):
    x = x0
    for _ in range(50):
        x = x + np.linalg.solve(jacobian(x), z - h(x))
    return x


wrong("extended_kalman_filter.2", "of R only the variances")(
    lambda x0, P, z, R, *given: _iterated(x0, P, z, np.diag(np.diag(R)), *given)
)
wrong("extended_kalman_filter.2", "the last term of the bracket with the wrong sign")(
    lambda *given: _iterated(*given, shift=-1)
)


@wrong("extended_kalman_filter.3", "turns first, then drives")
def turns_first(x, P, u, Q):
    turned = x + np.array([0, 0, u[1]])
    F, G = _jacobians(turned, u)
    return _moved(turned, u) - [0, 0, u[1]], F @ P @ F.T + G @ Q @ G.T


@wrong("extended_kalman_filter.3", "F transposed")
def transposed(x, P, u, Q):
    F, G = _jacobians(x, u)
    return _moved(x, u), F.T @ P @ F + G @ Q @ G.T


@wrong("extended_kalman_filter.3", "the last column of F with the other sign")
def swings_right(x, P, u, Q):
    F, G = _jacobians(x, u)
    F = 2 * np.eye(3) - F
    return _moved(x, u), F @ P @ F.T + G @ Q @ G.T


@wrong("extended_kalman_filter.3", "products of elements: * in place of @")
def elementwise(x, P, u, Q):
    F, G = _jacobians(x, u)
    return _moved(x, u), F * P * F.T + G @ Q @ G.T


@wrong("extended_kalman_filter.3", "moves the state that it was given")
def in_place(x, P, u, Q):
    F, G = _jacobians(x, u)
    x += [u[0] * np.cos(x[2]), u[0] * np.sin(x[2]), u[1]]
    return x, F @ P @ F.T + G @ Q @ G.T


@wrong("extended_kalman_filter.4", "expected minus measured")
def backwards(z, e):
    nu = e - z
    return np.array([nu[0], (nu[1] + np.pi) % (2 * np.pi) - np.pi])


@wrong("extended_kalman_filter.4", "wraps to half a turn")
def half_a_turn(z, e):
    nu = z - e
    return np.array([nu[0], (nu[1] + np.pi / 2) % np.pi - np.pi / 2])


@wrong("extended_kalman_filter.4", "cut off at pi")
def cut_off(z, e):
    nu = z - e
    return np.array([nu[0], np.clip(nu[1], -np.pi, np.pi)])


@wrong("extended_kalman_filter.4", "the sine of the difference")
def sine(z, e):
    return np.array([z[0] - e[0], np.sin(z[1] - e[1])])


@wrong("extended_kalman_filter.4", "one turn at most, on both sides")
def one_turn_each(z, e):
    nu = z - e
    return nu - [0, 2 * np.pi * np.sign(nu[1]) * (abs(nu[1]) > np.pi)]


@wrong("extended_kalman_filter.4", "in degrees")
def in_degrees(z, e):
    nu = z - e
    return np.array([nu[0], (nu[1] + 180) % 360 - 180])
