"""Checks of the chapter: consistency."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, between, cases, exercise, given, holds, number, same
from slamlib.evaluation.consistency import band
from slamlib.manifolds import Array


@exercise("consistency.1", "how many runs a band needs")
def runs_needed(candidate: Candidate) -> None:
    """The exact band of that many runs is as narrow as was asked for, within the error of the approximation."""
    for n, share in cases((n, share) for n in (1, 2, 6, 15) for share in (0.05, 0.1, 0.2)):
        runs = number(candidate(n, share), "the number of runs")
        given(f"n = {n}, +-{share:.0%}: {runs:.6g} runs")
        holds(runs >= 1, "at least one run")
        half, of_one_less = (np.ptp(band(n, max(1, round(runs) - less))) / 2 / n for less in (0, 1))
        holds(half < 1.04 * share, "the band is narrow enough", f"they give +-{half:.1%}")
        holds(of_one_less > 0.985 * share, "no run is wasted", f"one less gives +-{of_one_less:.1%}")


@exercise("consistency.2", "NEES averaged over runs", seed=52)
def average_nees(candidate: Candidate, rng: Rng) -> None:
    """A quarter for twice the claimed std, invariant to units, each step and run by itself; inside its band."""
    runs, steps, n = 200, 15, 3
    roots = rng.standard_normal((runs, steps, n, n)) + 2 * np.eye(n)
    covariances = roots @ roots.transpose(0, 1, 3, 2)
    errors = (roots @ rng.standard_normal((runs, steps, n, 1)))[..., 0]
    found = array_of(candidate(errors, covariances), (steps,), f"the average over {runs} runs at each of {steps} steps")
    same(candidate(errors, 4 * covariances), found / 4, "twice the claimed standard deviation, a quarter of the NEES")
    units = np.diag([1000.0, 1, 0.01])
    same(candidate(errors @ units, units @ covariances @ units), found, "metres or millimetres make no difference")
    alone = candidate(errors[:, [4]], covariances[:, [4]])
    same(alone, found[[4]], "no step has a part in the average of another")
    variances = np.diagonal(covariances[0, 0])
    given(f"errors without correlation, of variances {variances.round(3)}")
    plain = (errors[0, 0] ** 2 / variances).sum()
    same(candidate(errors[:1, :1], np.diag(variances)[None, None])[0], plain, "it is a sum over the numbers")
    given("correlated errors")
    one = (np.linalg.solve(np.linalg.cholesky(covariances[0, 0]), errors[0, 0]) ** 2).sum()
    same(candidate(errors[:1], covariances[:1])[0], one, "one run is e' P^-1 e")
    given("")
    each = [candidate(errors[[i]], covariances[[i]]) for i in range(runs)]
    same(np.mean(each, axis=0), found, "all runs give the average of what each gives alone")
    between(found, *band(n, runs, 0.9999), "the errors of a consistent filter lie in the band")


@exercise("consistency.3", "a gate with the right degrees of freedom", seed=53)
def gate(candidate: Candidate, rng: Rng) -> None:
    """The share of good innovations that pass, in any units; an elliptic boundary; what is missing is marginalized."""
    for m in cases((1, 2, 3), "{} number(s), none missing"):
        distances = np.sqrt([band(m, 1, (k + 0.5) / 40) for k in range(40)]).ravel()  # one in each eightieth
        for scale, probability in ((0.1, 0.5), (10.0, 0.9)):
            root = scale * (np.tril(np.ones((m, m))) + 0.1 * rng.standard_normal((m, m)))
            S, drawn = root @ root.T, distances[:, None] * _directions(rng, 80, m) @ root.T
            passed = np.mean([bool(candidate(z, S, probability)) for z in drawn])
            what = "the chosen share of good innovations passes, in any units"
            between(passed, probability - 0.06, probability + 0.06, what)
        holds(candidate(1e-3 * root[:, 0], S, 0.9), "what is almost as predicted passes", "it does not")
        for distance in (0.5, 1, 1.5, 2, 2.5, 3):
            shell = distance * _directions(rng, 20, m) @ root.T
            what = "whether one passes depends on its distance, not on its direction"
            same_side = len({bool(candidate(z, S, 0.9)) for z in shell}) == 1
            holds(same_side, what, f"it does at distance {distance}")
    for seen in cases(((False, True), (True, False, True), (False, True, False))):
        full = np.tril(np.ones((len(seen), len(seen)))) + 0.1 * rng.standard_normal((len(seen), len(seen)))
        for S, what in (
            (np.diag(rng.uniform(1, 4, len(seen))), "the degrees of freedom are the numbers that were measured"),
            (full @ full.T, "missing numbers are marginalized: their rows and columns leave S before it is inverted"),
        ):
            rest = S[np.ix_(seen, seen)]
            for distance in np.linspace(0.3, 3.5, 30):
                z = np.full(len(seen), np.nan)
                z[list(seen)] = np.linalg.cholesky(rest) @ _directions(rng, 1, sum(seen))[0] * distance
                passes, alone = bool(candidate(z, S, 0.9)), bool(candidate(z[list(seen)], rest, 0.9))
                given(f"{z.round(3)} with S = {S.round(3).tolist()}")
                told = f"the answer is {passes}, and {alone} if only what was measured is given, and its block of S"
                holds(passes == alone, what, told)


def _directions(rng: Rng, count: int, n: int) -> Array:
    vectors = rng.standard_normal((count, n))
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


@exercise("consistency.5", "the whiteness of innovations", seed=55)
def whiteness(candidate: Candidate, rng: Rng) -> None:
    """One at lag zero, none elsewhere for white innovations, the known value for coloured ones, in any units."""
    T, m, a = 6000, 2, 0.8
    L = np.array([[2.0, 1.0], [1.5, 0.5]])  # full: the first number by itself mixes both
    S, white = L @ L.T, rng.standard_normal((T, m))
    coloured = np.zeros((T, m))
    for k in range(1, T):
        coloured[k] = a * coloured[k - 1] + np.sqrt(1 - a * a) * white[k]

    def value(innovations: Array, lag: int, S: Array = S) -> float:
        return number(candidate(innovations, S, lag), "the whiteness")

    same_each, four = np.full((5, 1), 3.0), np.array([[4.0]])
    given("every innovation 3, S = 4 and S = 8")
    same(value(same_each, 1, 2 * four), value(same_each, 1, four) / 2, "twice S, half the result")
    given("the innovations 2, -5, 3, with S = 4")
    same(value(np.array([[2.0], [-5.0], [3.0]]), 2, four), 1.5, "of three innovations, one pair is two steps apart")
    given("every innovation 3, with S = 4")
    same(value(same_each, 1, four), 2.25, "no mean is subtracted")
    for lag in cases((0, 1, 3), "lag {}"):
        mean = float(lag == 0)
        between(value(white @ L.T, lag), mean - 0.06, mean + 0.06, "white innovations: 1 at lag 0, about 0 elsewhere")
        between(value(coloured @ L.T, lag), a**lag - 0.1, a**lag + 0.1, "a first-order memory a shows as a^lag")
    turned = coloured * np.where(np.arange(T) % 2, 1, -1)[:, None]
    once = value(coloured @ L.T, 1)
    same(value(turned @ L.T, 1), -once, "alternating signs give the negative value at lag 1")
    same(once, value(coloured, 1, np.eye(m)), "mixing the numbers, and S with them, changes nothing")
