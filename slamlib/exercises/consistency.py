"""Checks of the chapter: consistency."""

from typing import Any

import numpy as np

from slamlib.evaluation.consistency import band, chi2_quantile
from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, same


@exercise("consistency.1", "how many runs a band needs")
def runs_needed(candidate: Any) -> None:
    """The exact band of that many runs is as narrow as was asked for, within the error of the approximation."""
    for n in (1, 2, 6, 15):
        for share in (0.05, 0.1, 0.2):
            runs = float(array_of(candidate(n, share), (), "the number of runs"))
            given = f"n = {n}, +-{share:.0%}: {runs:.6g} runs"
            holds(runs >= 1, "at least one run", f"{given} are not enough")
            low, high = band(n, max(1, round(runs)))
            half = (high - low) / 2 / n
            holds(half < 1.04 * share, "the band is narrow enough", f"{given} give +-{half:.1%}")
            holds(half > 0.94 * share, "no run is wasted", f"{given} give +-{half:.1%}")


@exercise("consistency.2", "NEES averaged over runs")
def average_nees(candidate: Any) -> None:
    """Inside its band for honest errors, blind to a change of units, a quarter for twice the claimed deviation."""
    rng = np.random.default_rng(52)
    runs, steps, n = 200, 15, 3
    roots = rng.standard_normal((runs, steps, n, n)) + 2 * np.eye(n)
    covariances = roots @ roots.transpose(0, 1, 3, 2)
    errors = (roots @ rng.standard_normal((runs, steps, n, 1)))[..., 0]
    found = array_of(candidate(errors, covariances), (steps,), "the average")
    low, high = band(n, runs, 0.9999)
    holds(np.all((found > low) & (found < high)), "honest errors lie in the band", f"found {np.round(found, 2)}")
    units = np.diag([1000.0, 1, 0.01])
    scaled = candidate(errors @ units, units @ covariances @ units)
    same(scaled, found, "metres or millimetres make no difference")
    same(candidate(errors, 4 * covariances), found / 4, "twice the claimed deviation, a quarter of the NEES")
    same(candidate(errors[:1], covariances[:1])[0], _one(errors[0, 0], covariances[0, 0]), "one run is e' P^-1 e")


def _one(error: Any, covariance: Any) -> float:
    return float((np.linalg.solve(np.linalg.cholesky(covariance), error) ** 2).sum())


@exercise("consistency.3", "a gate with the right degrees of freedom")
def gate(candidate: Any) -> None:
    """The share of good innovations that pass, in any units, whichever numbers are missing; an elliptic boundary."""
    rng = np.random.default_rng(53)
    for seen in ((True,), (True, True), (False, True), (True, True, True), (True, False, True), (False, True, False)):
        m, n, missing = len(seen), sum(seen), ~np.array(seen)
        given = f"{n} of {m} numbers" if missing.any() else f"{m} number(s)"
        distances = np.sqrt([chi2_quantile((k + 0.5) / 80, n) for k in range(80)])  # one in each eightieth
        for scale, probability in ((0.1, 0.5), (10.0, 0.9)):
            root = scale * (np.tril(np.ones((m, m))) + 0.1 * rng.standard_normal((m, m)))
            S, drawn = root @ root.T, np.full((80, m), np.nan)
            seen_root = np.linalg.cholesky(S[~missing][:, ~missing])
            drawn[:, ~missing] = distances[:, None] * _directions(rng, 80, n) @ seen_root.T
            passed = np.mean([bool(candidate(z, S, probability)) for z in drawn])
            what = "the chosen share of good innovations passes, in any units and with numbers missing"
            otherwise = f"of innovations with {given}, {passed:.0%} passed where {probability:.0%} was asked for"
            holds(abs(passed - probability) < 0.06, what, otherwise)
        for distance in () if missing.any() else (0.5, 1, 1.5, 2, 2.5, 3):
            shell = distance * _directions(rng, 20, m) @ root.T
            what = "whether one passes depends on its distance, not on its direction"
            same_side = len({bool(candidate(z, S, 0.9)) for z in shell}) == 1
            holds(same_side, what, f"it does for {m} numbers at distance {distance}")


def _directions(rng: np.random.Generator, count: int, n: int) -> Any:
    vectors = rng.standard_normal((count, n))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


@exercise("consistency.5", "the whiteness of innovations")
def whiteness(candidate: Any) -> None:
    """One at lag zero, none elsewhere for white innovations, the known value for coloured ones, in any units."""
    rng = np.random.default_rng(55)
    T, m, a = 6000, 2, 0.8
    L = np.array([[2.0, 0.0], [1.5, 0.5]])
    S, white = L @ L.T, rng.standard_normal((T, m))
    coloured = np.zeros((T, m))
    for k in range(1, T):
        coloured[k] = a * coloured[k - 1] + np.sqrt(1 - a * a) * white[k]
    for lag in (0, 1, 3):
        value = _value(candidate, white @ L.T, S, lag)
        holds(
            abs(value - (lag == 0)) < 0.06, "white innovations: 1 at lag 0, about 0 elsewhere", f"{value:.3f} at {lag}"
        )
        value = _value(candidate, coloured @ L.T, S, lag)
        holds(abs(value - a**lag) < 0.1, "a first-order memory a shows as a^lag", f"{value:.3f} at {lag} for a = 0.8")
    turned = coloured * np.where(np.arange(T) % 2, 1, -1)[:, None]
    value = -_value(candidate, coloured @ L.T, S, 1)
    same(_value(candidate, turned @ L.T, S, 1), value, "alternating signs give the negative value at lag 1")
    value = _value(candidate, coloured, np.eye(m), 1)
    same(_value(candidate, coloured @ L.T, S, 1), value, "mixing the numbers, and S with them, changes nothing")


def _value(candidate: Any, innovations: Any, S: Any, lag: int) -> float:
    return float(array_of(candidate(innovations, S, lag), (), "the whiteness"))
