"""Checks of the chapter: other filters, and all data at once."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, between, cases, exercise, holds, number, parts, same
from slamlib.manifolds import Array

DRAWN = 400_000  # particles
VARIANCES = (1.0, 1.0), (1.0, 0.1), (0.5, 2.0), (0.3, 0.004)  # of the motion, of the measurement


@exercise("other_filters.1", "the share of particles that count", seed=251)
def share(candidate: Candidate, rng: Rng) -> None:
    """Between none and all; the same in any unit; all of a sensor that says nothing; as of particles that are drawn."""
    for q, r in cases(VARIANCES, "q = {}, r = {}"):
        found = number(candidate(q, r), "the share")
        holds(0 < found <= 1, "it is a share: above 0, and not above 1", f"found {found:.4g}")
        in_other_units = candidate(1e4 * q, 1e4 * r)
        same(in_other_units, found, "centimetres instead of metres, 10^4 q and 10^4 r, make no difference")
        blind = candidate(q, 1e6 * q)
        between(blind, 1 - 1e-3, 1.0, "of a sensor that says nothing, r = 10^6 q, all particles count")
        ratio = number(candidate(q, 4e-8 * q) / candidate(q, 1e-8 * q), "the ratio of two shares")
        between(ratio, 1.99, 2.01, "of a precise sensor, four times the variance r makes it twice as large")
        w = np.exp(-(rng.normal(0, np.sqrt(q), DRAWN) ** 2) / r / 2)
        what = "it is not the mean weight: 1 / sum w^2 is of weights whose sum is one"
        wanted = float(w.sum() ** 2 / (w**2).sum() / DRAWN)
        holds(abs(found - w.mean()) > 0.01 or abs(found - wanted) < 0.01, what, f"the mean weight is {w.mean():.3f}")
        between(found, wanted - 0.01, wanted + 0.01, f"{DRAWN:,} particles, drawn and weighted, give the same")


@exercise("other_filters.2", "unknowns are eliminated", seed=252)
def elimination(candidate: Candidate, rng: Rng) -> None:
    """The rest, in its order, with the covariance and the step that it has among all unknowns."""
    kinds = (6, [0]), (12, [0, 3, 6, 9]), (5, [4]), (7, [1, 2, 3, 4, 5])
    for n, numbers in cases(kinds, "{} unknowns, numbers {} gone"):
        A, g = rng.standard_normal((3 * n, n)), rng.standard_normal(n)
        L, gone = A.T @ A, np.isin(np.arange(n), numbers)
        rest, shapes = ~gone, {"the matrix": (n - len(numbers),) * 2, "the right-hand side": (n - len(numbers),)}
        apart = L * (gone[:, None] == gone)
        left, right = parts(candidate(apart, g, gone), shapes)
        what = "if nothing links them to the rest, matrix and right-hand side of the rest are as they were"
        same(np.column_stack([left, right]), np.column_stack([L[np.ix_(rest, rest)], g[rest]]), what)
        left, right = parts(candidate(L, g, gone), shapes)
        untouched = np.abs(left - L[np.ix_(rest, rest)]).max() < 1e-9
        holds(not untouched, "what is linked to an eliminated unknown is linked to each other", "nothing has changed")
        same(_inverse(left), np.linalg.inv(L)[np.ix_(rest, rest)], "the covariance of the rest is what it was", 1e-8)
        step = np.linalg.solve(L, g)[rest]
        same(np.linalg.solve(left, right), step, "the step of the rest is the one of all unknowns together", 1e-8)


def _inverse(matrix: Array) -> Array:
    """The inverse, or Rejected for one that has none."""
    holds(np.linalg.cond(matrix) < 1e12, "the matrix of the rest has an inverse", "it has none")
    return np.asarray(np.linalg.inv(matrix))


@exercise("other_filters.3", "a measurement used twice", seed=253)
def used_twice(candidate: Candidate, rng: Rng) -> None:
    """Less than the posterior's, which is right; that of particles from the proposal, weighted by the likelihood."""
    for q, r in cases(VARIANCES[:3], "q = {}, r = {}"):
        claimed, right = number(candidate(q, r), "the standard deviation"), np.sqrt(q * r / (q + r))
        in_other_units = candidate(1e4 * q, 1e4 * r)
        same(in_other_units, 100 * claimed, "in centimetres, 10^4 q and 10^4 r, it is a hundred times the number")
        told = f"found {claimed:.4g}, and that of the posterior is {right:.4g}"
        holds(claimed < (1 - 1e-6) * right, "it is less than that of the true posterior: something counts twice", told)
        z = rng.normal(0, np.sqrt(q + r))
        drawn = rng.normal(z * q / (q + r), right, DRAWN)
        w = np.exp(-((z - drawn) ** 2) / r / 2)
        mean = w @ drawn / w.sum()
        spread = float(np.sqrt(w @ (drawn - mean) ** 2 / w.sum()))
        what = f"{DRAWN:,} particles, drawn from the proposal and weighted by the likelihood, have it"
        between(claimed, 0.99 * spread, 1.01 * spread, what)
