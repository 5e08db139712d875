"""Wrong solutions of chapter other_filters."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("other_filters.1", "the mean weight instead of the effective share")
def mean_weight(q, r):
    return np.sqrt(r / (q + r))


@wrong("other_filters.1", "the mean of the squares is left out")
def square_of_the_mean(q, r):
    return r / (q + r)


@wrong("other_filters.1", "upside down")
def upside_down(q, r):
    return (q + r) / np.sqrt(r * (2 * q + r))


@wrong("other_filters.1", "squares a weight by halving q instead of r")
def halved(q, r):
    return (r / (q + r)) / np.sqrt(2 * r / (q + 2 * r))


@wrong("other_filters.1", "of a precise sensor only")
def precise(q, r):
    return np.sqrt(2 * r / q)


@wrong("other_filters.1", "takes q and r for standard deviations")
def as_deviations(q, r):
    return right_share(q**2, r**2)


def right_share(q, r):
    return np.sqrt(r * (2 * q + r)) / (q + r)


@wrong("other_filters.2", "drops the rows and columns")
def dropped(L, g, gone):
    keep = ~gone
    return L[np.ix_(keep, keep)], g[keep]


@wrong("other_filters.2", "the right-hand side is forgotten")
def matrix_only(L, g, gone):
    return _eliminated(L, g, gone)[0], g[~gone]


@wrong("other_filters.2", "adds what should be subtracted")
def added(L, g, gone):
    keep = ~gone
    K = np.linalg.solve(L[np.ix_(gone, gone)], L[np.ix_(gone, keep)]).T
    return L[np.ix_(keep, keep)] + K @ L[np.ix_(gone, keep)], g[keep] + K @ g[gone]


@wrong("other_filters.2", "adds to the right-hand side alone")
def added_right(L, g, gone):
    left, right = _eliminated(L, g, gone)
    return left, 2 * g[~gone] - right


@wrong("other_filters.2", "keeps those that should go")
def other_ones(L, g, gone):
    return _eliminated(L, g, ~gone)


@wrong("other_filters.2", "returns the covariance, whose rows are simply dropped")
def of_the_covariance(L, g, gone):
    P = np.linalg.inv(L)
    return P[np.ix_(~gone, ~gone)], (P @ g)[~gone]


def _eliminated(L, g, gone):
    keep = ~gone
    K = np.linalg.solve(L[np.ix_(gone, gone)], L[np.ix_(gone, keep)]).T
    return L[np.ix_(keep, keep)] - K @ L[np.ix_(gone, keep)], g[keep] - K @ g[gone]


@wrong("other_filters.3", "the true posterior: the weight is taken to have no part")
def posterior(q, r):
    return np.sqrt(1 / (1 / q + 1 / r))


@wrong("other_filters.3", "the motion counts twice, too")
def both_twice(q, r):
    return np.sqrt(1 / (2 / q + 2 / r))


@wrong("other_filters.3", "a variance")
def variance(q, r):
    return 1 / (1 / q + 2 / r)


@wrong("other_filters.3", "the measurement's noise is doubled instead of halved")
def doubled(q, r):
    return np.sqrt(1 / (1 / q + 1 / (2 * r)))
