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


@wrong("gaussians.2", "the mean is forgotten")
def around_zero(mean, P, probability):
    return np.sqrt(-2 * np.log(1 - probability)) * np.linalg.cholesky(P) @ CIRCLE


@wrong("gaussians.2", "c as a radius: the square root is missing")
def squared_radius(mean, P, probability):
    return mean[:, None] - 2 * np.log(1 - probability) * np.linalg.cholesky(P) @ CIRCLE


@wrong("gaussians.2", "half of the circle")
def half_way(mean, P, probability):
    angle = np.linspace(0, np.pi, 100)
    half = np.array([np.cos(angle), np.sin(angle)])
    return mean[:, None] + np.sqrt(-2 * np.log(1 - probability)) * np.linalg.cholesky(P) @ half


@wrong("gaussians.2", "the other tail")
def other_tail(mean, P, probability):
    return mean[:, None] + np.sqrt(-2 * np.log(probability)) * np.linalg.cholesky(P) @ CIRCLE


@wrong("gaussians.2", "the square root of each entry")
def entry_by_entry(mean, P, probability):
    return mean[:, None] + np.sqrt(-2 * np.log(1 - probability)) * np.sqrt(np.abs(P)) @ CIRCLE


@wrong("gaussians.3", "the gain multiplies the value, not the surprise")
def no_surprise(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    gain = P[rest, i] / P[i, i]
    return mean[rest] + gain * value, P[np.ix_(rest, rest)] - np.outer(gain, P[i, rest])


@wrong("gaussians.3", "what was learned is added to the covariance")
def added(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    gain = P[rest, i] / P[i, i]
    return mean[rest] + gain * (value - mean[i]), P[np.ix_(rest, rest)] + np.outer(gain, P[i, rest])


@wrong("gaussians.3", "the gain's sign is turned in the mean")
def away_from_it(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    gain = P[rest, i] / P[i, i]
    return mean[rest] - gain * (value - mean[i]), P[np.ix_(rest, rest)] - np.outer(gain, P[i, rest])


@wrong("gaussians.3", "divided by the standard deviation")
def by_sigma(mean, P, i, value):
    rest = [k for k in range(len(mean)) if k != i]
    gain = P[rest, i] / np.sqrt(P[i, i])
    return mean[rest] + gain * (value - mean[i]), P[np.ix_(rest, rest)] - np.outer(gain, gain)


@wrong("gaussians.3", "all components are kept")
def all_kept(mean, P, i, value):
    gain = P[:, i] / P[i, i]
    return mean + gain * (value - mean[i]), P - np.outer(gain, P[i])


@wrong("gaussians.4", "D compared with the quantile of its square")
def unsquared(e, S, probability):
    return np.sqrt(e @ np.linalg.solve(S, e)) <= chi2_quantile(probability, len(e))


@wrong("gaussians.4", "each number by itself: the rectangle")
def rectangle(e, S, probability):
    return np.all(np.abs(e) <= np.sqrt(chi2_quantile(probability, 1) * np.diag(S)))


@wrong("gaussians.4", "the variances alone: correlations are left out")
def diagonal(e, S, probability):
    return (e**2 / np.diag(S)).sum() <= chi2_quantile(probability, len(e))


@wrong("gaussians.4", "two sigmas in every case")
def two_sigmas(e, S, probability):
    return e @ np.linalg.solve(S, e) <= 4


@wrong("gaussians.4", "keeps what lies outside")
def outside(e, S, probability):
    return e @ np.linalg.solve(S, e) >= chi2_quantile(probability, len(e))
