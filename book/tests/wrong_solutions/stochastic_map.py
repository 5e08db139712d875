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
    at, gap = np.s_[start : start + J.shape[1]], [start] * len(J)
    D = np.insert(np.insert(np.delete(np.delete(P, at, 0), at, 1), gap, 0, 0), gap, 0, 1)
    D[start : start + len(J), start : start + len(J)] = J @ P[at, at] @ J.T
    return D


@wrong("stochastic_map.2", "puts the rewritten block at the end")
def at_the_end(P, start, J):
    identity, at = np.eye(len(P)), np.s_[start : start + J.shape[1]]
    T = np.vstack([np.delete(identity, at, axis=0), J @ identity[at]])
    return T @ P @ T.T


@wrong("stochastic_map.2", "J once only, on the rows and on the columns but not twice in the corner")
def corner_once(P, start, J):
    (k, m), identity, at = J.shape, np.eye(len(P)), np.s_[start : start + J.shape[1]]
    T = np.insert(np.delete(identity, at, 0), [start] * k, J @ identity[at], 0)
    D = T @ P @ T.T
    if k == m:
        D[at, at] = P[at, at]
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


@wrong("stochastic_map.4", "the smallest factor for this P, not for every one")
def for_this_one(P, sizes):
    D = _blocks(P, sizes, 1)
    return D * np.linalg.eigvals(np.linalg.solve(D, P)).real.max()


@wrong("stochastic_map.4", "adds to each variance the sizes of its covariances with the other groups")
def row_sums(P, sizes):
    D = _blocks(P, sizes, 1)
    return D + np.diag(np.abs(P - D).sum(1))
