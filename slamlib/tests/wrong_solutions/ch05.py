"""Wrong solutions of chapter 5."""

import numpy as np

from slamlib.evaluation import chi2_quantile
from slamlib.tests.wrong_solutions import wrong


@wrong("5.2", "divides by the variances only: correlations are ignored")
def diagonal(errors, covariances):
    return (errors**2 / np.diagonal(covariances, axis1=-2, axis2=-1)).sum(-1).mean(0)


@wrong("5.2", "averages over the steps instead of the runs, and repeats it")
def over_time(errors, covariances):
    solved = np.linalg.solve(covariances, errors[..., None])[..., 0]
    return np.full(errors.shape[1], (errors * solved).sum(-1)[0].mean())


@wrong("5.2", "the covariance is not inverted")
def not_inverted(errors, covariances):
    return (errors * (covariances @ errors[..., None])[..., 0]).sum(-1).mean(0)


@wrong("5.3", "too many degrees of freedom, as in gpsbabel 1517")
def state_dof(nu, S, P, probability):
    return nu @ np.linalg.solve(S, nu) <= chi2_quantile(probability, len(P))


@wrong("5.3", "the wrong tail")
def wrong_tail(nu, S, P, probability):
    return nu @ np.linalg.solve(S, nu) <= chi2_quantile(1 - probability, len(nu))


@wrong("5.3", "each number by itself at its own gate")
def rectangle(nu, S, P, probability):
    return np.all(nu**2 / np.diag(S) <= chi2_quantile(probability, 1))
