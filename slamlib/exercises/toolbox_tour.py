"""Checks of the chapter: the toolbox, toured."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, holds, same


@exercise("toolbox_tour.1", "a line moves with the world")
def shifted_line(candidate: Any) -> None:
    """Every point of the line, moved, is on the moved line, and the line still points the same way."""
    rng = np.random.default_rng(171)
    for size in (0.0, 1.0, 30.0):
        p, v, c = 3 * rng.standard_normal(3), rng.standard_normal(3), size * rng.standard_normal(3)
        line = np.concatenate([np.cross(p, v), v])
        kept = line.copy()
        moved = array_of(candidate(line, c), (6,), "the moved line")
        same(line, kept, "the line that was given is left as it was")
        same(moved[3:], v, "the direction is the same")
        for step in (0.0, 5.0):
            point = p + step * v + c
            same(np.cross(point, v), moved[:3], "the moved points are on the moved line", given=f"the shift {c}")


@exercise("toolbox_tour.2", "what no look can see")
def unseen(candidate: Any) -> None:
    """An orthonormal basis of all directions that every look maps to zero, and of no other."""
    rng = np.random.default_rng(172)
    for n, hidden, count in ((7, 3, 2), (5, 0, 3), (6, 6, 1), (9, 1, 8)):
        basis = np.linalg.qr(rng.standard_normal((n, n)))[0]
        seen = basis[:, hidden:]
        predictions = np.array([rng.standard_normal((2, n - hidden)) @ seen.T for _ in range(count)])
        given = f"{count} looks at {n} numbers, {hidden} of them hidden"
        found = array_of(candidate(predictions), (n, hidden), "the directions")
        same(found.T @ found, np.eye(hidden), "the directions are orthonormal", given=given)
        for prediction in predictions:
            same(prediction @ found, np.zeros((2, hidden)), "no look sees them", given=given)
    predictions = np.array([[[1.0, 0, 0]], [[0, 1000.0, 0]]])
    found = array_of(candidate(predictions), (3, 1), "what two looks of one number leave")
    same(np.abs(found[:, 0]), [0, 0, 1], "each look is used, whatever its scale")


@exercise("toolbox_tour.3", "a stream for every run")
def streams(candidate: Any) -> None:
    """Reproducible, all different, the first ones the same for more runs, and none shared with another experiment."""
    first = _numbers(candidate(7, 6))
    holds(len(first) == 6, "one generator for each run", f"there are {len(first)}")
    same(_numbers(candidate(7, 6)), first, "the same seed gives the same runs")
    holds(len(np.unique(first)) == first.size, "all runs are different", "some numbers come twice")
    longer = _numbers(candidate(7, 9))
    same(longer[:6], first, "a longer experiment begins with the runs of the shorter one")
    for seed in (6, 8, 13):
        together = np.concatenate([first, _numbers(candidate(seed, 6))])
        holds(
            len(np.unique(together)) == together.size,
            "experiments with other seeds have other runs",
            f"some run of seed {seed} is one of seed 7",
        )


def _numbers(generators: Any) -> Any:
    return np.array([generator.standard_normal(3) for generator in generators])
