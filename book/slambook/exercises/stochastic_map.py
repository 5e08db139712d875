"""Checks of the chapter: the stochastic map."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import cases, covariance, holds, least_squares, random_covariance, same


@exercise("stochastic_map.1", "a second measurement")
def second_look(candidate: Candidate) -> None:
    """Against least squares over both positions of the robot and both landmarks, and what must not change."""
    for p, q, v in cases(((1.0, 1.0, 1.0), (0.5, 2.0, 0.1), (3.0, 0.2, 0.7)), "p {}, q {}, v {}"):
        P = covariance(candidate(p, q, v), 3)
        unknown = np.diag([p, 1e9, 1e9, 1e9])  # robot before and after, two landmarks of which nothing is known
        measured = [([-1, 1, 0, 0], 0, q), ([-1, 0, 1, 0], 0, v), ([0, -1, 0, 1], 0, v), ([0, -1, 1, 0], 0, v)]
        best = least_squares(np.zeros(4), unknown, measured)[1][1:, 1:]
        apart = P[0, 0] + P[2, 2] - 2 * P[0, 2]
        same(apart, v, "landmark 2 is as far from the robot as it was: nothing new about that")
        same(P, best, "all that was measured is used, and used once", tolerance=1e-6)
        what = "from a certain start, landmark 1 is known by two independent sources: directly, and by odometry"
        same(1 / candidate(0.0, q, v)[1][1], 1 / v + 1 / (q + v), what)


@exercise("stochastic_map.2", "rewriting and taking away", seed=142)
def convert(candidate: Candidate, rng: Rng) -> None:
    """The covariance of the rewritten errors, for longer, shorter and no numbers; the others stay as they were."""
    rewrites = (6, 2, 2, 3), (9, 3, 6, 1), (7, 4, 0, 2), (6, 3, 1, 0), (5, 2, 3, 2)
    for n, old, start, new in cases(rewrites, "{} numbers, {} of them from row {} on become {}"):
        A, J = rng.standard_normal((n, n)), rng.standard_normal((new, old))
        P, gone = A @ A.T, np.s_[start : start + old]
        found = covariance(candidate(P, start, J), n - old + new)
        rest = np.delete(np.arange(n), gone)
        others = rest + (rest > start) * (new - old)
        same(found[np.ix_(others, others)], P[np.ix_(rest, rest)], "the others are as they were, in their order")
        rewritten = np.insert(A[rest], start, J @ A[gone], axis=0)  # P = A A': rows of A are errors, in 'draws'
        same(found, rewritten @ rewritten.T, "it is the covariance of the rewritten errors")


@exercise("stochastic_map.3", "rows after a deletion", seed=143)
def rows_after(candidate: Candidate, rng: Rng) -> None:
    """The survivors tile the smaller matrix without gap or overlap, and find their own block in it."""
    maps = [([6, 3, 3, 3], (2,)), ([3, 2, 2, 2, 2], (1, 3)), ([7, 3, 7, 7, 3], (2,))]
    maps += [([6, 6, 3, 7], (0, 2)), ([2, 3], ())]
    for sizes, removed in cases(maps, "blocks of {} numbers, without {}"):
        found = candidate(list(sizes), list(removed))
        holds(isinstance(found, dict), "a dictionary is returned", f"found {type(found).__name__}")
        left = [i for i in range(len(sizes)) if i not in removed]
        holds(sorted(found) == left, "every survivor is in it, and nobody else", f"found {sorted(found)}")
        holds(all(isinstance(s, slice) for s in found.values()), "its values are slices")
        owner = np.repeat(np.arange(len(sizes)), sizes)  # the block of each row
        P = rng.standard_normal((len(owner), len(owner)))
        kept = np.isin(owner, left)
        smaller = P[np.ix_(kept, kept)]
        for i, j in ((i, j) for i in left for j in left):
            right = np.array_equal(smaller[found[i], found[j]], P[np.ix_(owner == i, owner == j)])
            holds(right, "each pair of survivors finds its own block", f"blocks {i} and {j} do not")


@exercise("stochastic_map.4", "deleting correlations consistently", seed=144)
def decouple(candidate: Candidate, rng: Rng) -> None:
    """The groups' own blocks times one factor for every P: the least that never claims more than P in any direction."""
    for sizes in cases(([2, 3], [1, 1, 1], [3, 2, 2, 1], [4]), "groups of {}"):
        n, label = sum(sizes), np.repeat(np.arange(len(sizes)), sizes)
        apart = label[:, None] != label
        place = np.arange(n) - np.searchsorted(label, label)  # in its group
        common = 1.0 * (place[:, None] == np.arange(max(sizes)))  # the groups' errors are the same, number by number
        for P in (random_covariance(rng, n), common @ common.T + 1e-9 * np.eye(n), np.diag(rng.uniform(1, 2, n))):
            D = covariance(candidate(P, list(sizes)), n, "the result")
            holds(np.abs(D[apart]).max(initial=0) == 0, "nothing connects the groups")
            least, factor = float(np.linalg.eigvalsh(D - P)[0]), float(np.trace(D) / np.trace(P))
            what = "in no direction does it claim more than P"
            holds(least > -1e-6 * np.abs(P).max(), what, f"P exceeds it by {-least:.3g}")
            same(D, factor * np.where(apart, 0, P), "the groups keep their own blocks, all multiplied by one factor")
            what = "the factor is what unknown correlations require, no more, and no less for this P"
            holds(abs(factor - len(sizes)) < 1e-6, what, f"variances grow by a factor {factor:.3g}")
