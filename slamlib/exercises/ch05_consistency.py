"""Checks of chapter 5: consistency."""

from typing import Any

import numpy as np

from slamlib.evaluation import band
from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, same


@exercise("5.2", "NEES averaged over runs")
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


@exercise("5.3", "a gate with the right degrees of freedom")
def gate(candidate: Any) -> None:
    """The share of good innovations that pass, for measurements of one to three numbers and a state of six."""
    rng = np.random.default_rng(53)
    P = np.diag(rng.uniform(0.1, 1, 6))
    for m in (1, 2, 3):
        root = rng.standard_normal((m, m)) + 2 * np.eye(m)
        S = root @ root.T
        passed = np.mean([bool(candidate(root @ rng.standard_normal(m), S, P, 0.9)) for _ in range(3000)])
        what = "nine in ten good innovations pass"
        holds(abs(passed - 0.9) < 0.03, what, f"{passed:.0%} of those with {m} number(s) passed")
