"""Checks of the chapter: the toolbox, toured."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, holds, same
from slamlib.manifolds import Array


@exercise("toolbox_tour.1", "a line moves with the world", seed=171)
def shifted_line(candidate: Candidate, rng: Rng) -> None:
    """Every point of the line, moved, is on the moved line, and the line still points the same way."""
    for size in cases((0.0, 1.0, 30.0), "a shift of some {} m"):
        p, v, c = 3 * rng.standard_normal(3), rng.standard_normal(3), size * rng.standard_normal(3)
        line = np.concatenate([np.cross(p, v), v])
        kept = line.copy()
        moved = array_of(candidate(line, c), (6,), "the moved line")
        same(line, kept, "the line that was given is left as it was")
        same(moved[3:], v, "the direction is the same")
        for step in (0.0, 5.0):
            same(np.cross(p + step * v + c, v), moved[:3], "the moved points are on the moved line")


@exercise("toolbox_tour.2", "what no measurement observes", seed=172)
def unseen(candidate: Candidate, rng: Rng) -> None:
    """An orthonormal basis of all directions that every measurement maps to zero, and of no other."""
    sizes = (2, 7, 3), (3, 5, 0), (1, 6, 6), (8, 9, 1)
    for count, n, hidden in cases(sizes, "{} measurements at a state of {} numbers, {} unobserved"):
        basis = np.linalg.qr(rng.standard_normal((n, n)))[0]
        predictions = np.array([rng.standard_normal((2, n - hidden)) @ basis[:, hidden:].T for _ in range(count)])
        found = array_of(candidate(predictions), (n, hidden), "the directions")
        same(found.T @ found, np.eye(hidden), "the directions are orthonormal")
        same(predictions @ found, np.zeros((count, 2, hidden)), "no measurement observes them")
    predictions = 1e-12 * np.array([[[1.0, 0, 0]], [[0, 1e6, 0]], [[0, 0, 1e-5]]])  # the last: 1e-11 of the largest
    found = array_of(candidate(predictions), (3, 1), "what three scalar measurements leave unobserved")
    same(np.abs(found[:, 0]), [0, 0, 1], "the threshold is relative to the largest measurement")


@exercise("toolbox_tour.3", "a stream for every run")
def streams(candidate: Candidate) -> None:
    """Reproducible, all different, the first ones the same for more runs, and none shared with another experiment."""

    def numbers(seed: int, runs: int) -> Array:
        return np.array([generator.standard_normal(3) for generator in candidate(seed, runs)])

    first, long = numbers(7, 6), numbers(7, 10000)
    holds(len(first) == 6, "one generator for each run", f"there are {len(first)}")
    same(numbers(7, 6), first, "the same seed gives the same runs")
    holds(len({id(generator) for generator in candidate(7, 6)}) == 6, "each has a generator of its own")
    holds(len(np.unique(long)) == long.size, "all runs are different", "some numbers come twice")
    same(long[:6], first, "a longer experiment begins with the runs of the shorter one")
    for seed in (6, 8):
        together = np.concatenate([long, numbers(seed, 1200)])
        shared = len(np.unique(together)) < together.size
        holds(not shared, "experiments with other seeds have other runs", f"some run of seed {seed} is one of seed 7")
