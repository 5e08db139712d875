"""Wrong solutions of chapter gaussians."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.kalman.chi_square import chi2_quantile

ANGLE = np.linspace(0, 2 * np.pi, 100)
CIRCLE = np.array([np.cos(ANGLE), np.sin(ANGLE)])
COIN = np.random.default_rng(4)


@wrong("gaussians.2", "eigenvalues instead of their square roots: variances drawn as lengths")
def without_root(mean, P, probability):
    values, vectors = np.linalg.eigh(P)
    return mean[:, None] + np.sqrt(-2 * np.log(1 - probability)) * vectors @ (values[:, None] * CIRCLE)


@wrong("gaussians.2", "the quantile of one dimension")
def one_dimension(mean, P, probability):
    return mean[:, None] + np.sqrt(chi2_quantile(probability, 1)) * np.linalg.cholesky(P) @ CIRCLE


@wrong("gaussians.2", "the transposed Cholesky factor")
def transposed(mean, P, probability):
    return mean[:, None] + np.sqrt(-2 * np.log(1 - probability)) * np.linalg.cholesky(P).T @ CIRCLE


@wrong("gaussians.3", "the marginal: what was seen is ignored")
def marginal(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    return mean[rest], P[np.ix_(rest, rest)]


@wrong("gaussians.3", "a block of the inverse taken for the covariance")
def block_of_inverse(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    return mean[rest] + P[rest, i] / P[i, i] * (value - mean[i]), np.linalg.inv(P)[np.ix_(rest, rest)]


@wrong("gaussians.4", "the wrong tail, as in msckf_vio issue 124")
def wrong_tail(z, S, probability):
    return z @ np.linalg.solve(S, z) <= chi2_quantile(1 - probability, len(z))


@wrong("gaussians.4", "the same threshold for every dimension")
def fixed_dof(z, S, probability):
    return z @ np.linalg.solve(S, z) <= chi2_quantile(probability, 2)


@wrong("gaussians.4", "the right share by chance: a coin, and no distance but the absurd ones")
def coin(e, S, probability):
    return COIN.random() < probability and e @ np.linalg.solve(S, e) < 1e3


@wrong("gaussians.4", "the distance of the first whitened component alone")
def first_component(e, S, probability):
    white = np.linalg.solve(np.linalg.cholesky(S), e)
    return abs(white[0]) < np.sqrt(chi2_quantile(probability, 1)) and white @ white < 5000


@wrong("gaussians.4", "S is taken for its inverse")
def not_inverted(z, S, probability):
    return z @ S @ z <= chi2_quantile(probability, len(z))
