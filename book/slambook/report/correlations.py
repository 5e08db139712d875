"""Correlations between landmarks, and between landmarks and robot (section 9.3): by experiment, and by the filter.

The experiment is the report's: map and path are known, a robot drives the same path many times, and the errors of
its estimates are compared, component by component. `odometry` is that of 9.3, without updates: landmarks stay where
the robot's estimated pose put them when it observed them first.
"""

from dataclasses import dataclass

import numpy as np

from slambook.report.filter import BatchUpdateFilter, Memory
from slambook.report.memory import ring
from slambook.report.runs import DOF, Outcome, monte_carlo
from slambook.report.scenes import Scene
from slamlib.evaluation.consistency import rmse
from slamlib.manifolds import Array


@dataclass
class Odometry(Memory):
    """A filter that never updates: pose by odometry alone, landmarks as first observed from it."""

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """Nothing."""


WAYS = {"SLAM": BatchUpdateFilter, "odometry": Odometry}


@dataclass(frozen=True, eq=False)
class Compared:
    """Correlations (6 + 3L, 6 + 3L) at the end of the path: over the runs, and as the filter estimates them.

    nees: of pose and map together, averaged over the runs; its degrees of freedom are the size of the matrices.
    """

    name: str
    runs: int
    measured: Array
    claimed: Array
    nees: float

    @property
    def z(self) -> Array:
        """Measured minus claimed in units of the sampling error: by Fisher's atanh, which makes it 1/sqrt(runs - 3).

        Zero on the diagonal. About 1 if only the number of runs makes the difference.
        """
        beside = 1 - np.eye(len(self.measured))
        apart = np.arctanh(self.measured * beside) - np.arctanh(self.claimed * beside)
        return apart * np.sqrt(self.runs - 3)


@dataclass(frozen=True)
class CorrelationRow:
    """A line of the table: which numbers with which, how many pairs, and root mean squares over them.

    correlation: by the filter; difference: measured minus estimated; sampling: `difference` expected from the number
    of runs alone; z: of `Compared.z`; largest: correlation, in size.
    """

    what: str
    pairs: int
    correlation: float
    difference: float
    sampling: float
    z: float
    largest: float


def experiment(rng: np.random.Generator, runs: int = 1000, landmarks: int = 10, steps: int = 40) -> dict[str, Compared]:
    """Runs of the same path among the same landmarks, by SLAM and by odometry alone."""
    scene, seed = ring(rng, steps, landmarks), int(rng.integers(2**31))
    return {
        name: compared(name, scene, monte_carlo(scene, runs=runs, seed=seed, make=make)) for name, make in WAYS.items()
    }


def compared(name: str, scene: Scene, outcome: Outcome) -> Compared:
    """Errors of pose and map at the end, against the covariances that the runs claim."""
    last, truth = outcome.last, scene.path()[-1]
    errors = last.x - np.concatenate([truth, scene.points[last.names].ravel()])
    errors[:, 3:6] = outcome.errors[:, -1, 3:]
    P = (last.P + last.P.swapaxes(-1, -2)) / 2
    squared = (errors * np.linalg.solve(P, errors[..., None])[..., 0]).sum(-1)
    return Compared(name, len(errors), normalised(np.cov(errors.T)), normalised(P.mean(0)), float(squared.mean()))


def normalised(P: Array) -> Array:
    """Correlations (n, n) of a covariance (n, n)."""
    sigma = np.sqrt(np.diag(P))
    return P / np.outer(sigma, sigma)


def table(found: Compared) -> list[CorrelationRow]:
    """Landmark with landmark, landmark with robot, and the robot's six numbers among themselves."""
    owner = np.concatenate([np.full(DOF, -1), np.repeat(np.arange((len(found.claimed) - DOF) // 3), 3)])
    first, second = np.triu_indices(len(owner), 1)
    robot = (owner == -1).astype(int)
    count, apart = robot[first] + robot[second], owner[first] != owner[second]
    groups = {
        "landmark, landmark": (count == 0) & apart,
        "landmark, itself": (count == 0) & ~apart,
        "landmark, robot": count == 1,
        "robot, robot": count == 2,
    }
    rows = []
    for what, chosen in groups.items():
        i, j = first[chosen], second[chosen]
        rho, difference, z = found.claimed[i, j], (found.measured - found.claimed)[i, j], found.z[i, j]
        sampling = (1 - rho**2) / np.sqrt(found.runs)  # of a correlation over so many runs, to first order
        numbers = [float(rmse(x[:, None])) for x in (rho, difference, sampling, z)] + [float(np.abs(rho).max())]
        rows.append(CorrelationRow(what, len(i), *numbers))
    return rows
