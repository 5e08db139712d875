"""Wrong solutions of chapter ekf_slam."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("ekf_slam.1", "adds the two single gains, and counts twice what the looks share")
def added(a, b, c, v):
    first, second = np.log2((a + v) / v) / 2, np.log2((b + v) / v) / 2
    return np.array([first, first + second, second])


@wrong("ekf_slam.1", "leaves the noise out of S, as the toolbox does (E57)")
def without_noise(a, b, c, v):
    first, both = np.log2(a / v) / 2, np.log2((a * b - c**2) / v**2) / 2
    return np.array([first, both, both - first])


@wrong("ekf_slam.1", "nats instead of bits")
def nats(a, b, c, v):
    first, both = np.log((a + v) / v) / 2, np.log(((a + v) * (b + v) - c**2) / v**2) / 2
    return np.array([first, both, both - first])


@wrong("ekf_slam.1", "forgets the half")
def whole(a, b, c, v):
    first, both = np.log2((a + v) / v), np.log2(((a + v) * (b + v) - c**2) / v**2)
    return np.array([first, both, both - first])


def _blocks(S, m):
    return np.array([S[i : i + m, i : i + m] for i in range(0, len(S), m)])


@wrong("ekf_slam.2", "ranks each alone: the twin of the best comes second")
def alone(S, m, count):
    return np.argsort(-np.linalg.det(_blocks(S, m)), kind="stable")[:count].tolist()


@wrong("ekf_slam.2", "by the trace instead of the determinant")
def by_trace(S, m, count):
    S, chosen = S.copy(), []
    for _ in range(count):
        value = np.trace(_blocks(S, m), axis1=1, axis2=2)
        value[chosen] = -np.inf
        best = int(np.argmax(value))
        chosen.append(best)
        at = slice(best * m, best * m + m)
        S = S - S[:, at] @ np.linalg.solve(S[at, at], S[at])
    return chosen


@wrong("ekf_slam.2", "goes on from the covariance before, so that only the last choice is taken into account")
def last_only(S, m, count):
    given, chosen = S, []
    for _ in range(count):
        value = np.linalg.det(_blocks(given, m))
        value[chosen] = -np.inf
        best = int(np.argmax(value))
        chosen.append(best)
        at = slice(best * m, best * m + m)
        given = S - S[:, at] @ np.linalg.solve(S[at, at], S[at])
    return chosen


@wrong("ekf_slam.2", "of two that are equally good, takes the later")
def the_later(S, m, count):
    S, chosen = S.copy(), []
    for _ in range(count):
        value = np.linalg.det(_blocks(S, m))
        value[chosen] = -np.inf
        best = len(value) - 1 - int(np.argmax(value[::-1]))
        chosen.append(best)
        at = slice(best * m, best * m + m)
        S = S - S[:, at] @ np.linalg.solve(S[at, at], S[at])
    return chosen


@wrong("ekf_slam.3", "turns the landmarks about the origin and leaves the robot where it is")
def robot_stays(x):
    N = _right(x)
    N[:2, 2] = 0
    return N


@wrong("ekf_slam.3", "turns everything, and forgets that the robot's heading turns with it")
def heading_stays(x):
    N = _right(x)
    N[2, 2] = 0
    return N


@wrong("ekf_slam.3", "turns to the other side")
def other_side(x):
    N = _right(x)
    N[:, 2] *= -1
    N[2, 2] = 1
    return N


@wrong("ekf_slam.3", "counts a shift twice")
def dependent(x):
    N = _right(x)
    N[:, 2] = N[:, 0] + N[:, 1]
    return N


def _right(x):
    N = np.zeros((len(x), 3))
    for at in [0, *range(3, len(x), 2)]:
        N[at : at + 2, :2] = np.eye(2)
        N[at : at + 2, 2] = -x[at + 1], x[at]
    N[2, 2] = 1
    return N
