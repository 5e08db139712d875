"""Wrong solutions of chapter consistency."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.kalman.chi_square import chi2_quantile


@wrong("consistency.1", "the standard deviation instead of the band: the factor 1.96 is missing")
def one_sigma(n, share):
    return 2 / (n * share**2)


@wrong("consistency.1", "takes n for the variance of a chi-square variable")
def variance_n(n, share):
    return 1.96**2 / (n * share**2)


@wrong("consistency.1", "asks for the share of one, not of n")
def of_one(n, share):
    return 1.96**2 * 2 * n / share**2


@wrong("consistency.1", "two standard deviations in place of 1.96")
def two_sigma(n, share):
    return 2**2 * 2 / (n * share**2)


@wrong("consistency.1", "the band's whole width, not its half")
def whole_width(n, share):
    return 1.96**2 * 2 / (n * (share / 2) ** 2)


@wrong("consistency.2", "divides by the variances only: correlations are ignored")
def diagonal(errors, covariances):
    return (errors**2 / np.diagonal(covariances, axis1=-2, axis2=-1)).sum(-1).mean(0)


@wrong("consistency.2", "averages over the steps instead of the runs, and repeats it")
def over_time(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return np.full(errors.shape[1], (errors * solved).sum(-1)[0].mean())


@wrong("consistency.2", "the covariance averaged over the runs: right on average, and of no run")
def averaged_covariance(errors, covariances):
    solved = np.linalg.solve(covariances.mean(0), errors[..., None])[..., 0]
    return (errors * solved).sum(-1).mean(0)


@wrong("consistency.2", "the sum over the runs is not divided by their number")
def summed(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return (errors * solved).sum(-1).sum(0)


@wrong("consistency.2", "divided by n as well, as some authors define it")
def per_number(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return (errors * solved).mean(-1).mean(0)


@wrong("consistency.2", "the distance in place of its square")
def distance(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return np.sqrt((errors * solved).sum(-1)).mean(0)


@wrong("consistency.2", "averaged over runs and steps, and repeated")
def one_number(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return np.full(errors.shape[1], (errors * solved).sum(-1).mean())


@wrong("consistency.2", "the average error first, then its square")
def average_first(errors, covariances):
    mean, P = errors.mean(0), covariances.mean(0) / len(errors)
    return (mean * np.linalg.solve(P, mean[..., None])[..., 0]).sum(-1)


@wrong("consistency.2", "the covariance is not inverted, as in NaveGo 158")
def not_inverted(errors, covariances):
    return (errors * (covariances @ errors[..., None])[..., 0]).sum(-1).mean(0)


def squared(innovation, S):
    """Squared distance of the measured numbers, and how many they are."""
    seen = ~np.isnan(innovation)
    nu = innovation[seen]
    return nu @ np.linalg.solve(S[np.ix_(seen, seen)], nu), seen.sum()


@wrong(
    "consistency.3", "the degrees of freedom of a full measurement whatever was measured, a relative of gpsbabel 1517"
)
def full(innovation, S, probability):
    return squared(innovation, S)[0] <= chi2_quantile(probability, len(innovation))


@wrong("consistency.3", "the wrong tail, as in msckf_vio 124")
def wrong_tail(innovation, S, probability):
    distance, dof = squared(innovation, S)
    return distance <= chi2_quantile(1 - probability, dof)


@wrong("consistency.3", "a distance against the quantile of its square, as in autoware_core 1464")
def root(innovation, S, probability):
    distance, dof = squared(innovation, S)
    return np.sqrt(distance) <= chi2_quantile(probability, dof)


@wrong("consistency.3", "multiplies by S instead of its inverse, as in NaveGo 158")
def multiplied(innovation, S, probability):
    nu = np.nan_to_num(innovation)
    return nu @ S @ nu <= chi2_quantile(probability, (~np.isnan(innovation)).sum())


@wrong("consistency.3", "a number that was not measured counts as an innovation of zero")
def zero(innovation, S, probability):
    nu = np.nan_to_num(innovation)
    return nu @ np.linalg.solve(S, nu) <= chi2_quantile(probability, (~np.isnan(innovation)).sum())


@wrong("consistency.3", "strikes out rows and columns of the inverse of S, not of S")
def inverse_first(innovation, S, probability):
    seen = ~np.isnan(innovation)
    W = np.linalg.inv(S)[np.ix_(seen, seen)]
    return innovation[seen] @ W @ innovation[seen] <= chi2_quantile(probability, seen.sum())


@wrong("consistency.3", "both tails: a band of the share in place of a gate")
def two_sided(innovation, S, probability):
    distance, dof = squared(innovation, S)
    tail = (1 - probability) / 2
    return chi2_quantile(tail, dof) <= distance <= chi2_quantile(1 - tail, dof)


@wrong("consistency.3", "three sigmas, whatever the share and the numbers")
def three_sigmas(innovation, S, probability):
    return squared(innovation, S)[0] <= 9


@wrong("consistency.3", "the answer upside down: whether it is rejected")
def upside_down(innovation, S, probability):
    distance, dof = squared(innovation, S)
    return distance > chi2_quantile(probability, dof)


@wrong("consistency.3", "one degree of freedom, since the distance is one number")
def one_degree(innovation, S, probability):
    return squared(innovation, S)[0] <= chi2_quantile(probability, 1)


@wrong("consistency.3", "variances only")
def no_correlation(innovation, S, probability):
    seen = ~np.isnan(innovation)
    nu = innovation[seen]
    return (nu**2 / np.diag(S)[seen]).sum() <= chi2_quantile(probability, seen.sum())


@wrong("consistency.3", "each number by itself, at gates that together keep the right share if there is no correlation")
def rectangle(innovation, S, probability):
    each = probability ** (1 / (~np.isnan(innovation)).sum())
    return np.all(np.nan_to_num(innovation) ** 2 / np.diag(S) <= chi2_quantile(each, 1))


@wrong("consistency.5", "divides by the variances only")
def variances_only(innovations, S, lag):
    scaled = innovations / np.sqrt(np.diag(S))
    return np.mean(scaled[: len(scaled) - lag] * scaled[lag:])


@wrong("consistency.5", "correlates NIS with NIS: the sign is lost")
def of_squares(innovations, S, lag):
    d2 = (innovations * np.linalg.solve(S, innovations.T).T).sum(1) / innovations.shape[1] - 1
    return np.mean(d2[: len(d2) - lag] * d2[lag:]) / np.mean(d2**2)


@wrong("consistency.5", "the sum over the numbers is not divided by their count")
def not_per_number(innovations, S, lag):
    early, late = innovations[: len(innovations) - lag], innovations[lag:]
    return np.mean((early * np.linalg.solve(S, late.T).T).sum(1))


@wrong("consistency.5", "divides by the number of innovations, not of pairs")
def by_all(innovations, S, lag):
    early, late = innovations[: len(innovations) - lag], innovations[lag:]
    return (early * np.linalg.solve(S, late.T).T).sum() / innovations.size


@wrong("consistency.5", "np.roll: the last innovations are paired with the first")
def circular(innovations, S, lag):
    return np.mean((innovations * np.linalg.solve(S, np.roll(innovations, -lag, axis=0).T).T).sum(1)) / len(S)


@wrong("consistency.5", "the first number only")
def first_number(innovations, S, lag):
    first = innovations[:, 0]
    return np.mean(first[: len(first) - lag] * first[lag:]) / S[0, 0]


@wrong("consistency.5", "the last whitened number only")
def last_white(innovations, S, lag):
    last = np.linalg.solve(np.linalg.cholesky(S), innovations.T)[-1]
    return np.mean(last[: len(last) - lag] * last[lag:])


@wrong("consistency.5", "the mean is subtracted first")
def centred(innovations, S, lag):
    nu = innovations - innovations.mean(0)
    early, late = nu[: len(nu) - lag], nu[lag:]
    return np.mean((early * np.linalg.solve(S, late.T).T).sum(1)) / len(S)


@wrong("consistency.5", "S in place of its inverse")
def not_inverted_lag(innovations, S, lag):
    early, late = innovations[: len(innovations) - lag], innovations[lag:]
    return np.mean((early @ S * late).sum(1)) / len(S)


@wrong("consistency.5", "the absolute value: whether there is memory, not which")
def absolute_value(innovations, S, lag):
    early, late = innovations[: len(innovations) - lag], innovations[lag:]
    return abs(np.mean((early * np.linalg.solve(S, late.T).T).sum(1)) / len(S))


@wrong("consistency.5", "divided by the value at lag 0: the size of the innovations is lost")
def normalized(innovations, S, lag):
    early, late = innovations[: len(innovations) - lag], innovations[lag:]
    all_of_them = (innovations * np.linalg.solve(S, innovations.T).T).sum(1).mean()
    return np.mean((early * np.linalg.solve(S, late.T).T).sum(1)) / all_of_them
