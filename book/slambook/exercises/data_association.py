"""Checks of the chapter: data association."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, between, cases, exercise, holds, random_covariance, same
from slamlib.kalman.chi_square import chi2_quantile


@exercise("data_association.1", "what else is in the gate", seed=251)
def others(candidate: Candidate, rng: Rng) -> None:
    """Counts of points that are spread evenly over a box about the gate."""
    for m, probability in cases(((1, 0.99), (2, 0.99), (3, 0.95), (2, 0.5)), "{} numbers, probability {}"):
        S, limit, points = random_covariance(rng, m, 0.2), chi2_quantile(probability, m), 200_000
        reach = np.sqrt(limit * np.diag(S))
        spread = rng.uniform(-reach, reach, (points, m))
        inside = np.sum((spread * (spread @ np.linalg.inv(S))).sum(1) < limit)
        found, error = candidate(S, points / np.prod(2 * reach), probability), 4 * np.sqrt(inside)
        between(found, inside - error, inside + error, "it is what counting finds")


@exercise("data_association.2", "each the other's nearest neighbour", seed=252)
def neighbours(candidate: Candidate, rng: Rng) -> None:
    """Pairs are judged one by one; other orders and other units change nothing."""
    for n, k, m in cases(((6, 9, 2), (9, 6, 2), (5, 5, 3), (1, 4, 1)), "{} measurements, {} landmarks of {} numbers"):
        S = np.array([random_covariance(rng, m, 0.05) * rng.uniform(0.2, 3) for _ in range(k)])
        nu, limit = 5 * rng.standard_normal((n, k, m)), chi2_quantile(0.99, m)
        d2 = np.einsum("nki,kij,nkj->nk", nu, np.linalg.inv(S), nu)
        found = np.asarray(candidate(nu, S, limit))
        holds(found.shape == (n,), "one landmark, or -1, for each measurement", f"its shape is {found.shape}")
        rows, best = np.nonzero((d2 == d2.min(1)[:, None]) & (d2 == d2.min(0)) & (d2 < limit))
        wanted = dict(zip(rows.tolist(), best.tolist(), strict=True))
        for i, landmark in enumerate(found.tolist()):
            holds(landmark == wanted.get(i, -1), "each the other's nearest, inside the gate, and no others",
                  f"measurement {i} is given landmark {landmark}, its d2 are {d2[i].round(2)}")  # fmt: skip
        order = rng.permutation(n)
        same(candidate(nu[order], S, limit), found[order], "the order of the measurements does not matter")
        same(candidate(100 * nu, 1e4 * S, limit), found, "nor does the unit")


@exercise("data_association.3", "what a match adds to the joint square", seed=253)
def added(candidate: Candidate, rng: Rng) -> None:
    """Sums along several orders are the joint square of all."""
    for n, m in cases(((4, 2), (5, 1), (3, 3)), "{} matches of {} numbers"):
        S = random_covariance(rng, n * m, 0.3)
        nu, blocks = rng.standard_normal((n, m)), S.reshape(n, m, n, m)
        for _ in range(4):
            order = rng.permutation(n).tolist()
            terms = [candidate(nu, blocks, order[:k], order[k]) for k in range(n)]
            between(terms, 0, np.inf, "no match lowers the square")
            same(sum(terms), nu.ravel() @ np.linalg.solve(S, nu.ravel()), "in any order they add up to the whole")
        same(candidate(nu, blocks, [], 0), nu[0] @ np.linalg.solve(S[:m, :m], nu[0]), "alone it is its own square")


@exercise("data_association.4", "a gate that keeps its promise", seed=254)
def gated(candidate: Candidate, rng: Rng) -> None:
    """The share of right measurements inside, ahead and behind; and that the nearer ones are inside."""
    for probability, bearing in cases(((0.9, 0.0), (0.99, 3.1), (0.5, -3.12)), "probability {}, bearing {}"):
        S, h = random_covariance(rng, 2) * np.array([[0.02, 6e-3], [6e-3, 2e-3]]), np.array([4.0, bearing])
        noise = np.vstack([rng.standard_normal((3000, 2)) @ np.linalg.cholesky(S).T, [0, np.pi]])  # the last: opposite
        y = h + noise
        y[:, 1] = (y[:, 1] + np.pi) % (2 * np.pi) - np.pi
        passed = np.array([bool(candidate(one, h, S, probability)) for one in y])
        between(passed.mean(), probability - 0.03, probability + 0.03, "of the right ones the stated share passes")
        d2 = (noise * np.linalg.solve(S, noise.T).T).sum(1)
        holds(d2[passed].max() < d2[~passed].min() + 1e-9, "whatever passes is nearer, by D2, than whatever is refused")
