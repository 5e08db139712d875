"""What is remembered from picture to picture (section 5.4): two pictures, a window of some, or all of them.

A robot whose sensor faces ahead drives round a ring of points and a part of it once more: a filter that keeps the
first of them closes the loop when they come back into view.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from slambook.report.filter import BatchUpdateFilter
from slambook.report.runs import DOF, monte_carlo
from slambook.report.scenes import Scene, ahead, circle
from slamlib.errors import UnknownNameError
from slamlib.evaluation.consistency import Consistency
from slamlib.manifolds import Array

ROUND = 60  # steps of the way round


@dataclass
class WindowFilter(BatchUpdateFilter):
    """A filter that deletes a landmark when it has not been seen for `window` pictures; None: never.

    window 1 keeps what is in the present picture: two pictures at a time, as in section 5.4, but nothing starts anew.
    The rest keeps mean and covariance: rows and columns taken out of a Gaussian leave exactly its marginal.
    """

    window: int | None = None
    sizes: list[int] = field(default_factory=list)  # landmarks in the map after each step

    def __post_init__(self) -> None:
        super().__post_init__()
        self._seen: dict[int, int] = {}

    def predict(self, answer: Array, U: Array) -> None:
        """As Memory.predict; starts a new step."""
        super().predict(answer, U)
        self.step += 1

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """As BatchUpdateFilter.update; these landmarks have been seen now."""
        super().update(seen, names, R)
        self._seen |= dict.fromkeys(names, self.step)

    def initialize(self, seen: Array, names: list[int], R: Array, first: bool = False) -> None:
        """As Memory.initialize; these landmarks have been seen now."""
        super().initialize(seen, names, R, first)
        self._seen |= dict.fromkeys(names, self.step)
        self.sizes.append(len(self.names))

    def prune(self) -> None:
        """Section 5.4: delete what the equations delete, and what was not seen for too long."""
        super().prune()
        if self.window is None:
            return
        stays = [self.step - self._seen[name] < self.window for name in self.names]
        rows = np.flatnonzero([True] * 6 + [s for s in stays for _ in range(3)])
        self.x, self.P = self.x[:, rows], self.P[:, rows[:, None], rows]
        self.names = [name for name, s in zip(self.names, stays, strict=True) if s]


@dataclass(frozen=True)
class Way:
    """A variant: its errors of the list, its window, and whether new landmarks take a second measurement."""

    errors: tuple[str, ...] = ()
    window: int | None = None
    again: bool = False


WAYS = {
    "two pictures, as printed": Way(("E22",)),
    "two pictures, P kept": Way(("E22 kept",)),
    "two pictures, P kept, second look": Way(("E22 kept",), again=True),
    "window 1": Way(window=1),
    "window 5": Way(window=5),
    "window 20": Way(window=20),
    "everything": Way(),
}


@dataclass(frozen=True, eq=False)
class Remembered:
    """Results of one variant, at each of n steps (n,), over all runs.

    position [m]: root mean square error; claimed [m]: the filter's own standard deviation of the
    position; landmarks: in the map; consistency: NEES of the pose, 6 degrees of freedom.
    """

    name: str
    position: Array
    claimed: Array
    landmarks: Array
    consistency: Consistency

    @property
    def ratio(self) -> float:
        """NEES over its degrees of freedom, averaged over runs and the second half of the steps: 1 if consistent."""
        average = self.consistency.average
        return float(average[len(average) // 2 :].mean() / DOF)


def ring(rng: np.random.Generator, steps: int = 75, points: int = 36) -> Scene:
    """A robot, tilted a little, drives round in 60 steps (18 m), and on; points around its path, seen when ahead."""
    control, std = np.array([0.3, 0, 0, 360 / ROUND, 0, 0]), np.array([0.02] * 3 + [0.5] * 3)
    scene = replace(circle(3, 2, control, std, steps), sees=ahead(5.0, 0.8))
    angle = 2 * np.pi * (np.arange(points) + rng.uniform(0, 1, points)) / points
    far = rng.uniform(2, 5.5, points)  # from the middle of the path, whose radius is 2.9 m
    around = np.stack([far * np.cos(angle), far * np.sin(angle), rng.uniform(-1, 1, points)], -1)
    return replace(scene, points=around + scene.path()[:ROUND, :3].mean(0))


def compare(
    rng: np.random.Generator, runs: int = 20, steps: int = 75, names: Sequence[str] = tuple(WAYS)
) -> list[Remembered]:
    """The variants of these names on the same path, with the same noise. Raises UnknownNameError."""
    scene, seed = ring(rng, steps), int(rng.integers(2**31))
    found = []
    for name in names:
        if name not in WAYS:
            raise UnknownNameError.of("way to remember", name, WAYS)
        way = WAYS[name]
        make = partial(WindowFilter, window=way.window)
        outcome = monte_carlo(scene, *way.errors, runs=runs, seed=seed, again=way.again, make=make)
        last = outcome.last
        assert isinstance(last, WindowFilter)
        sizes, nees = np.array(last.sizes[1:]), Consistency.of(outcome.nees, DOF)
        found.append(Remembered(name, outcome.position_error, outcome.claimed_deviation, sizes, nees))
    return found
