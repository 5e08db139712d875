"""The report's chapter 6: times of the methods of `updates`, and errors of their maps.

Times are medians of one machine; what is asserted anywhere are the results and the multiplications.
"""

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import pairwise

import numpy as np

from slambook.report import updates
from slambook.report.filter import BatchUpdateFilter, Memory
from slambook.report.observation import by_vectors
from slambook.report.runs import monte_carlo
from slambook.report.scenes import SCENES, Scene, gentle, within
from slambook.report.updates import WAYS, Problem, State, multiplications, problem
from slamlib.manifolds import Array


@dataclass(frozen=True)
class Timing:
    """A size of problem: landmarks, how many are seen, size of the state; by way: processor time [s], multiplications.

    apart: largest difference between any way's result and the first one's, relative to the change by the update.
    """

    landmarks: int
    seen: int
    size: int
    seconds: dict[str, float]
    multiplications: dict[str, int]
    apart: float


def timings(
    rng: np.random.Generator,
    sizes: Sequence[tuple[int, int]],
    repeats: int = 5,
    methods: Sequence[str] = tuple(WAYS),
) -> Iterator[Timing]:
    """For each (landmarks, seen): all methods on the same problem, in turns, so that load affects them alike."""
    for landmarks, seen in sizes:
        given = problem(rng, landmarks, seen)
        taken: dict[str, list[float]] = {name: [] for name in methods}
        found: dict[str, State] = {}
        for _ in range(repeats):
            for name in methods:
                run = WAYS[name](given)
                began = time.process_time()
                found[name] = run()
                taken[name].append(time.process_time() - began)
        seconds = {name: statistics.median(times) for name, times in taken.items()}
        counted = {name: multiplications(landmarks, seen)[name] for name in methods}
        x, P = next(iter(found.values()))
        moved, shrunk = np.abs(x - given.x).max(), np.abs(P - given.P).max()
        apart = max(max(np.abs(y - x).max() / moved, np.abs(Q - P).max() / shrunk) for y, Q in found.values())
        yield Timing(landmarks, seen, len(given.x), seconds, counted, apart)


def crossing(rows: Sequence[Timing], one: str, other: str) -> list[float]:
    """Sizes of the state at which the quicker of two ways changes, from rows of growing size; by interpolation.

    Of logarithms, in which times are nearly straight lines. Empty: one of them is quicker everywhere.
    """
    found = []
    for a, b in pairwise(rows):
        left, right = (np.log(row.seconds[one] / row.seconds[other]) for row in (a, b))
        if left * right < 0:
            share = left / (left - right)
            found.append(float(np.exp((1 - share) * np.log(a.size) + share * np.log(b.size))))
    return found


@dataclass
class Measured(Memory):
    """A filter that updates by one of the methods; one run at a time."""

    method: Callable[[Problem], Callable[[], State]] = updates.naive
    observations: list[tuple[int, int]] = field(default_factory=list)  # landmarks in the map, and seen

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """As Memory.update, of a single run, and with independent numbers."""
        places = np.array([self.names.index(name) for name in names])
        run = self.method(updates.observe(self.x[0], self.P[0], places, seen[0], np.diagonal(R[0], axis1=-2, axis2=-1)))
        x, P = run()
        self.observations.append((len(self.names), len(names)))
        self.x, self.P = x[None].copy(), P[None].copy()


@dataclass(frozen=True)
class Mapping:
    """A whole run by one method: landmarks in the map at the end, their mean distance from the truth [m], largest
    difference of state or covariance from the first method's, and the number of multiplications of all updates."""

    method: str
    mapped: int
    error: float
    apart: float
    multiplications: int


def hundred(rng: np.random.Generator, landmarks: int = 100, mapped: int = 92, steps: int = 60) -> Scene:
    """`gentle`'s path among points; the sensor's range is such that a given number of them are ever seen."""
    scene = gentle()
    scene = replace(scene, controls=scene.controls[:steps])
    points = rng.uniform(-1, 1, (landmarks, 3)) * (8, 8, 2.5) + scene.path()[:, :3].mean(0)
    nearest = np.sort(np.linalg.norm(by_vectors(scene.path(), points), axis=-1).min(0))
    return replace(scene, points=points, sees=within(float(nearest[mapped - 1 : mapped + 1].mean())))


def mapping(rng: np.random.Generator, steps: int = 60, methods: Sequence[str] = tuple(WAYS)) -> list[Mapping]:
    """The run of chapter 6, 92 of 100 landmarks mapped: every method on the same measurements."""
    scene, seed, found = hundred(rng, steps=steps), int(rng.integers(2**31)), []
    for name in methods:
        last = monte_carlo(scene, runs=1, seed=seed, make=partial(Measured, method=WAYS[name])).last
        assert isinstance(last, Measured)
        found.append(last)
    first = found[0]
    return [
        Mapping(
            name,
            len(last.names),
            float(np.linalg.norm(last.points[0] - scene.points[last.names], axis=-1).mean()),
            float(max(np.abs(last.x - first.x).max(), np.abs(last.P - first.P).max())),
            sum(multiplications(L, m)[name] for L, m in last.observations),
        )
        for name, last in zip(methods, found, strict=True)
    ]


@dataclass
class Again(BatchUpdateFilter):
    """A filter that linearises anew for every landmark, at the state updated by those before it."""

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """As Memory.update, landmark by landmark."""
        for i, name in enumerate(names):
            super().update(seen[..., [i], :], [name], R[..., [i], :, :])


@dataclass(frozen=True, eq=False)
class Accuracy:
    """Mean distance [m] of the landmarks from the truth in each run (runs,): once with one linearisation for all
    landmarks of a picture, once with a new one for each."""

    batch: Array
    again: Array

    @property
    def gain(self) -> tuple[float, float]:
        """By how much the new linearisation lowers the error, relative; and the standard error of that."""
        apart, size = self.batch - self.again, self.batch.mean()
        return float(apart.mean() / size), float(apart.std(ddof=1) / np.sqrt(len(apart)) / size)


def accuracy(rng: np.random.Generator, runs: int = 20, scene: str = "gentle", steps: int = 60) -> Accuracy:
    """Whether the landmarks' error is smaller component by component: only by linearising anew (E25)."""
    given, seed = SCENES[scene](), int(rng.integers(2**31))
    given = replace(given, controls=given.controls[:steps])
    outcomes = [monte_carlo(given, runs=runs, seed=seed, make=make) for make in (BatchUpdateFilter, Again)]
    errors = [np.linalg.norm(o.last.points - given.points[o.last.names], axis=-1).mean(-1) for o in outcomes]
    return Accuracy(*errors)
