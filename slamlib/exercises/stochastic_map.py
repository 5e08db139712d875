"""Checks of the chapter: the stochastic map."""

from itertools import pairwise
from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, holds, least_squares, same
from slamlib.manifolds import Array


@exercise("stochastic_map.1", "a second look")
def second_look(candidate: Any) -> None:
    """Against least squares over both places of the robot and both landmarks, and what must not change."""
    for p, q, v in ((1.0, 1.0, 1.0), (0.5, 2.0, 0.1), (3.0, 0.2, 0.7)):
        given = f"p {p}, q {q}, v {v}"
        P = covariance(candidate(p, q, v), 3, "the covariance")
        unknown = np.diag([p, 1e9, 1e9, 1e9])  # robot before and after, two landmarks of which nothing is known
        rows = [([-1, 1, 0, 0], q), ([-1, 0, 1, 0], v), ([0, -1, 0, 1], v), ([0, -1, 1, 0], v)]
        measured = [(np.array([row], dtype=float), np.zeros(1), np.array([[r]])) for row, r in rows]
        best = least_squares(np.zeros(4), unknown, measured)[1][1:, 1:]
        apart = P[0, 0] + P[2, 2] - 2 * P[0, 2]
        same(apart, v, "landmark 2 is as far from the robot as it was: nothing new about that", given=given)
        same(P, best, "all that was measured is used, and used once", given=given, tolerance=1e-6)
        what = "from a certain start, landmark 1 is known by two independent ways: directly, and by the wheels"
        same(1 / candidate(0.0, q, v)[1][1], 1 / v + 1 / (q + v), what, given=given)


@exercise("stochastic_map.2", "rewriting and taking away")
def convert(candidate: Any) -> None:
    """The covariance of the rewritten errors, for longer, shorter and no numbers; the others stay as they were."""
    rng = np.random.default_rng(142)
    for n, start, old, new in ((6, 2, 2, 3), (9, 6, 3, 1), (7, 0, 4, 2), (6, 1, 3, 0), (5, 3, 2, 2)):
        given = f"{n} numbers, {old} of them from row {start} on become {new}"
        A, J = rng.standard_normal((n, n)), rng.standard_normal((new, old))
        P, rest = A @ A.T, [i for i in range(n) if not start <= i < start + old]
        found = covariance(candidate(P, start, J), n - old + new, "the covariance")
        others = [i if i < start else i - old + new for i in rest]
        what = "the others are as they were, in their order"
        same(found[np.ix_(others, others)], P[np.ix_(rest, rest)], what, given=given)
        errors = np.delete(A, np.s_[start : start + old], axis=0)  # P = A A': rows of A are errors, in 'draws'
        rewritten = np.insert(errors, start, J @ A[start : start + old], axis=0)
        same(found, rewritten @ rewritten.T, "it is the covariance of the rewritten errors", given=given)


@exercise("stochastic_map.3", "rows after a deletion")
def rows_after(candidate: Any) -> None:
    """The survivors tile the smaller matrix without gap or overlap, and find their own block in it."""
    rng = np.random.default_rng(143)
    for sizes, removed in (
        ([6, 3, 3, 3], [2]),
        ([3, 2, 2, 2, 2], [1, 3]),
        ([7, 3, 7, 7, 3], [2]),
        ([6, 6, 3, 7], [0, 2]),
        ([2, 3], []),
    ):
        given = f"blocks of {sizes} numbers, without {removed}"
        found = candidate(list(sizes), list(removed))
        holds(isinstance(found, dict), "a dictionary is returned", f"found {type(found).__name__}")
        left = [i for i in range(len(sizes)) if i not in removed]
        holds(sorted(found) == left, "every survivor is in it, and nobody else", f"found {sorted(found)} for {given}")
        holds(all(isinstance(s, slice) for s in found.values()), "its values are slices", f"not for {given}")
        stops = np.cumsum([0, *sizes])
        old = [slice(int(a), int(b)) for a, b in pairwise(stops)]
        P = rng.standard_normal((stops[-1], stops[-1]))
        out = [row for i in removed for row in range(stops[i], stops[i + 1])]
        smaller = np.delete(np.delete(P, out, 0), out, 1)
        for i in left:
            for j in left:
                what = "each pair of survivors finds its own block"
                block = smaller[found[i], found[j]]
                holds(np.array_equal(block, P[old[i], old[j]]), what, f"blocks {i} and {j} do not, for {given}")


@exercise("stochastic_map.4", "forgetting, honestly")
def decouple(candidate: Any) -> None:
    """Block diagonal, never claims more than P in any direction, and no more careful than one factor must be."""
    rng = np.random.default_rng(144)
    for sizes in ([2, 3], [1, 1, 1], [3, 2, 2, 1], [4]):
        given = f"groups of {sizes}"
        n, groups = sum(sizes), len(sizes)
        label = np.repeat(np.arange(groups), sizes)
        outside = label[:, None] != label
        place = np.arange(n) - np.searchsorted(label, label)  # in its group
        common = 1.0 * (place[:, None] == np.arange(max(sizes)))  # the groups' errors are the same, number by number
        for P in (_random(rng, n), common @ common.T + 1e-9 * np.eye(n), np.diag(rng.uniform(1, 2, n))):
            D = covariance(candidate(P, list(sizes)), n, "the result")
            holds(np.abs(D[outside]).max(initial=0) == 0, "nothing connects the groups", f"not so for {given}")
            least = float(np.linalg.eigvalsh(D - P)[0])
            what = "in no direction does it claim more than P"
            holds(least > -1e-6 * np.abs(P).max(), what, f"P exceeds it by {-least:.3g} for {given}")
            share = float(np.sum(np.diag(P) / np.diag(D)) / n)
            what = "it is no more careful than somebody must be who does not know the correlations"
            holds(share > 1 / groups - 1e-6, what, f"variances grow by a factor {1 / share:.3g} for {given}")


def _random(rng: np.random.Generator, n: int) -> Array:
    A = rng.standard_normal((n, n))
    return array_of(A @ A.T, (n, n), "P")
