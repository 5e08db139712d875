"""Wrong solutions of chapter stochastic_map."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _looked(P, v):
    h = np.array([-1.0, 1, 0])
    return P - np.outer(P @ h, P @ h) / (h @ P @ h + v)


@wrong("stochastic_map.1", "the landmarks inherit the robot's variance at the time of the second one")
def same_robot(p, q, v):
    return _looked(np.full((3, 3), p + q) + np.diag([0, v, v]), v)


@wrong("stochastic_map.1", "corrects the robot and landmark 1 only, as if landmark 2 were not concerned")
def only_the_seen(p, q, v):
    P = np.array([[p + q, p, p + q], [p, p + v, p], [p + q, p, p + q + v]])
    P[:2, :2] = _looked(P, v)[:2, :2]
    return P


@wrong("stochastic_map.1", "the motion moves the landmark along with the robot")
def carried(p, q, v):
    return _looked(np.array([[p + q, p + q, p + q], [p + q, p + q + v, p + q], [p + q, p + q, p + q + v]]), v)


@wrong("stochastic_map.1", "forgets the covariance of the two landmarks")
def no_cross(p, q, v):
    return _looked(np.array([[p + q, p, p + q], [p, p + v, 0.0], [p + q, 0.0, p + q + v]]), v)


@wrong("stochastic_map.2", "rewrites the corner and leaves out what it shares with the others")
def corner_only(P, start, J):
    k, m = J.shape
    rest = np.delete(np.arange(len(P)), np.s_[start : start + m])
    order = np.argsort(np.concatenate([rest, np.full(k, start)]), kind="stable")
    D = np.zeros((len(rest) + k,) * 2)
    D[: len(rest), : len(rest)] = P[np.ix_(rest, rest)]
    D[len(rest) :, len(rest) :] = J @ P[start : start + m, start : start + m] @ J.T
    return D[np.ix_(order, order)]


@wrong("stochastic_map.2", "puts the rewritten block at the end")
def at_the_end(P, start, J):
    T = np.delete(np.eye(len(P)), np.s_[start : start + J.shape[1]], axis=0)
    row = np.zeros((len(J), len(P)))
    row[:, start : start + J.shape[1]] = J
    T = np.vstack([T, row])
    return T @ P @ T.T


@wrong("stochastic_map.2", "J once only, on the rows and on the columns but not twice in the corner")
def corner_once(P, start, J):
    k, m = J.shape
    T = np.insert(np.delete(np.eye(len(P)), np.s_[start : start + m], 0), start, np.zeros((k, len(P))), 0)
    T[start : start + k, start : start + m] = J
    D = T @ P @ T.T
    if k == m:
        D[start : start + k, start : start + k] = P[start : start + m, start : start + m]
    return D


@wrong("stochastic_map.3", "keeps the rows of the old matrix, as in rgbdslam_v2 3")
def not_shifted(sizes, removed):
    stops = np.cumsum([0, *sizes])
    return {i: slice(int(stops[i]), int(stops[i + 1])) for i in range(len(sizes)) if i not in removed}


@wrong("stochastic_map.3", "moves up by one row for each removed block, whatever its size")
def one_row_each(sizes, removed):
    stops = np.cumsum([0, *sizes])
    up = {i: sum(r < i for r in removed) for i in range(len(sizes))}
    return {i: slice(int(stops[i]) - up[i], int(stops[i + 1]) - up[i]) for i in up if i not in removed}


@wrong("stochastic_map.3", "moves everybody up, those before the gap too")
def all_move(sizes, removed):
    stops, gone = np.cumsum([0, *sizes]), sum(sizes[r] for r in removed)
    start = {i: max(0, int(stops[i]) - gone) for i in range(len(sizes)) if i not in removed}
    return {i: slice(s, s + sizes[i]) for i, s in start.items()}


@wrong("stochastic_map.3", "takes all blocks for as large as the last one")
def equal_sizes(sizes, removed):
    left = [i for i in range(len(sizes)) if i not in removed]
    return {i: slice(k * sizes[-1], (k + 1) * sizes[-1]) for k, i in enumerate(left)}


def _blocks(P, sizes, factor):
    label = np.repeat(np.arange(len(sizes)), sizes)
    return np.where(label[:, None] == label, factor * P, 0.0)


@wrong("stochastic_map.4", "drops the blocks and asks no price")
def for_nothing(P, sizes):
    return _blocks(P, sizes, 1)


@wrong("stochastic_map.4", "two is right for two groups, and not for more")
def twice(P, sizes):
    return _blocks(P, sizes, 2 if len(sizes) > 1 else 1)


@wrong("stochastic_map.4", "multiplies by the number of rows, where that of the groups will do")
def by_rows(P, sizes):
    return _blocks(P, sizes, len(P))


@wrong("stochastic_map.4", "a large number is surely safe")
def surely(P, sizes):
    return _blocks(P, sizes, 100)
