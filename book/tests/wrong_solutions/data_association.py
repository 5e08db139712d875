"""Wrong solutions of chapter data_association."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.kalman.chi_square import chi2_quantile

UNIT = {1: 2.0, 2: np.pi, 3: 4 / 3 * np.pi}


@wrong("data_association.1", "the determinant without its root")
def whole_determinant(S, density, probability):
    return density * UNIT[len(S)] * chi2_quantile(probability, len(S)) ** (len(S) / 2) * np.linalg.det(S)


@wrong("data_association.1", "an area in every dimension")
def always_an_area(S, density, probability):
    return density * np.pi * chi2_quantile(probability, 2) * np.sqrt(np.linalg.det(S))


@wrong("data_association.1", "three sigma, whatever the probability")
def three_sigma(S, density, probability):
    return density * UNIT[len(S)] * np.sqrt(np.linalg.det(9 * S))


def _squares(nu, S):
    return np.einsum("nki,kij,nkj->nk", nu, np.linalg.inv(S), nu)


@wrong("data_association.2", "one landmark may be taken twice")
def not_mutual(nu, S, limit):
    d2 = _squares(nu, S)
    return np.where(d2.min(1) < limit, d2.argmin(1), -1)


@wrong("data_association.2", "the Euclidean distance")
def euclidean(nu, S, limit):
    return np.where((d := (nu**2).sum(2)).min(1) < limit, d.argmin(1), -1)


@wrong("data_association.2", "a distance that is not squared, against the limit for its square")
def not_squared(nu, S, limit):
    d = np.sqrt(_squares(nu, S))
    best = d.argmin(1)
    return np.where((d.argmin(0)[best] == np.arange(len(nu))) & (d.min(1) < limit), best, -1)


@wrong("data_association.2", "without a gate")
def no_gate(nu, S, limit):
    return not_squared(nu, S, np.inf)


def _parts(nu, S, chosen, j):
    n, m = nu.shape
    rows = [m * i + k for i in chosen for k in range(m)]
    own = [m * j + k for k in range(m)]
    S = S.reshape(n * m, n * m)
    gain = np.linalg.solve(S[np.ix_(rows, rows)], S[np.ix_(rows, own)]).T
    return nu.ravel()[own], gain, nu.ravel()[rows], S[np.ix_(own, own)], S[np.ix_(rows, own)]


@wrong("data_association.3", "its own square, whatever has been chosen")
def alone(nu, S, chosen, j):
    return nu[j] @ np.linalg.solve(S[j, :, j], nu[j])


@wrong("data_association.3", "the innovation is updated, its covariance is not")
def old_covariance(nu, S, chosen, j):
    own, gain, before, part, _ = _parts(nu, S, chosen, j)
    return (own - gain @ before) @ np.linalg.solve(part, own - gain @ before)


@wrong("data_association.3", "the covariance is updated, the innovation is not")
def old_innovation(nu, S, chosen, j):
    own, gain, _, part, across = _parts(nu, S, chosen, j)
    return own @ np.linalg.solve(part - gain @ across, own)


def _wrapped(y, h):
    nu = np.subtract(y, h)
    nu[1] = (nu[1] + np.pi) % (2 * np.pi) - np.pi
    return nu


@wrong("data_association.4", "bearings are subtracted, and not wrapped (MRPT 909)")
def not_wrapped(y, h, S, probability):
    nu = np.subtract(y, h)
    return nu @ np.linalg.solve(S, nu) < chi2_quantile(probability, 2)


@wrong("data_association.4", "bearings are wrapped as the directions of lines are, so that the opposite one passes")
def wrapped_by_half(y, h, S, probability):
    return not_wrapped([y[0], h[1] + (y[1] - h[1] + np.pi / 2) % np.pi - np.pi / 2], h, S, probability)


@wrong("data_association.4", "the quantile of the wrong tail (msckf_vio 124)")
def wrong_tail(y, h, S, probability):
    nu = _wrapped(y, h)
    return nu @ np.linalg.solve(S, nu) < chi2_quantile(1 - probability, 2)


@wrong("data_association.4", "the distance is not squared (autoware_core 1464)")
def root(y, h, S, probability):
    nu = _wrapped(y, h)
    return np.sqrt(nu @ np.linalg.solve(S, nu)) < chi2_quantile(probability, 2)


@wrong("data_association.4", "one degree of freedom")
def one_number(y, h, S, probability):
    nu = _wrapped(y, h)
    return nu @ np.linalg.solve(S, nu) < chi2_quantile(probability, 1)


@wrong("data_association.4", "a gate on the range alone")
def range_alone(y, h, S, probability):
    return (y[0] - h[0]) ** 2 / S[0, 0] < chi2_quantile(probability, 1)


@wrong("data_association.4", "a gate without the correlation")
def variances_alone(y, h, S, probability):
    return (_wrapped(y, h) ** 2 / np.diag(S)).sum() < chi2_quantile(probability, 2)


@wrong("data_association.4", "a coin that falls right with the stated probability")
def coin(y, h, S, probability):
    return 1e6 * y[0] % 1 < probability
