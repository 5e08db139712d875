"""FastSLAM beside EKF-SLAM on the same measurements, many times: errors, consistency, and particle depletion."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.report.angles import wrapped
from slambook.report.fastslam import FastSlam
from slambook.report.planar import Data, drive
from slambook.report.planar_ekf import PlanarEkf
from slamlib.evaluation.consistency import Consistency
from slamlib.experiments.progress import progress
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array

DOF = 3
WORST = 1e6  # NEES where the covariance is singular, as that of particles with all weight in one


@dataclass(frozen=True, eq=False)
class Contestant:
    """Results of one filter, at each of n steps (n,), over all runs. particles: 0 for EKF-SLAM.

    position: root mean square error [m]; of_run (runs,): the same over a run's steps; map_error: mean distance [m] of
    the landmarks from the truth at the end; nees (runs, n) of the pose, 3 degrees of freedom, at most a million;
    effective (n,), ancestors (n,), averaged over the runs: number of particles that the weights are worth, and of how
    many particles of that step the last ones descend; seconds: median CPU time of a step.
    """

    particles: int
    position: Array
    of_run: Array
    map_error: float
    nees: Array
    effective: Array
    ancestors: Array
    seconds: float

    @property
    def name(self) -> str:
        """For tables and figures."""
        return f"{self.particles} particles" if self.particles else "EKF"

    @property
    def consistency(self) -> Consistency:
        """NEES averaged over the runs at each step, beside its band."""
        return Consistency.of(self.nees, DOF)

    @property
    def typical(self) -> float:
        """Median over runs and the second half of the steps of NEES, over what it is if consistent: then about 1."""
        return float(np.median(self.nees[:, self.nees.shape[1] // 2 :]) / chi2_quantile(0.5, DOF))


def compare(
    rng: np.random.Generator,
    runs: int = 20,
    steps: int = 120,
    particles: Sequence[int] = (0, 10, 100, 1000),
    share: float = 0.5,
    kind: type[FastSlam] = FastSlam,
    **noise: Any,
) -> list[Contestant]:
    """EKF-SLAM (0) and FastSLAM with so many particles, each on the same runs; share: as of FastSlam.

    kind: FastSLAM 1.0 or 2.0; noise: motion_std (3,), scan_std (2,), reach, as of `drive`.
    """
    seeds = rng.integers(2**31, size=runs).tolist()
    worlds = [drive(np.random.default_rng(s), steps, **noise) for s in seeds]
    return [_contestant(n, worlds, [np.random.default_rng([s, n]) for s in seeds], share, kind) for n in particles]


def _contestant(
    particles: int, worlds: list[Data], draws: list[np.random.Generator], share: float, kind: type[FastSlam]
) -> Contestant:
    errors, nees, maps, seconds, filters = [], [], [], [], []
    pairs = zip(worlds, draws, strict=True)
    for data, rng in progress(pairs, len(worlds), f"{particles or 'no'} particles, {len(worlds)} runs"):
        filter = kind(data, particles, rng, share) if particles else PlanarEkf(data)
        found = [_step(filter, data, k) for k in range(len(data.odometry))]
        errors.append([e for e, _, _ in found])
        nees.append([n for _, n, _ in found])
        seconds.append(np.median([s for _, _, s in found]))
        maps.append(np.mean([np.linalg.norm(m - data.points[i]) for i, (m, _) in filter.map().items()]))
        filters.append(filter)
    square = (np.array(errors)[..., :2] ** 2).sum(-1)
    position, of_run = np.sqrt(square.mean(0)), np.sqrt(square.mean(1))
    memory = _memory([f for f in filters if isinstance(f, FastSlam)], len(position))
    of_map, taken = float(np.mean(maps)), float(np.median(seconds))
    return Contestant(particles, position, of_run, of_map, np.array(nees), *memory, taken)


def _step(filter: FastSlam | PlanarEkf, data: Data, k: int) -> tuple[Array, float, float]:
    """Error of the pose (3,), its NEES, and the seconds that the filter took."""
    began = time.process_time()
    filter.step(data.odometry[k], data.scans[k + 1])
    taken = time.process_time() - began
    mean, covariance = filter.pose()
    error = data.truth[k + 1] - mean
    error[2] = wrapped(error[2])
    try:
        found = float(error @ np.linalg.solve(covariance, error))
    except np.linalg.LinAlgError:
        found = WORST
    return error, found if 0 <= found < WORST else WORST, taken  # below zero: a covariance singular but for rounding


def _memory(filters: list[FastSlam], steps: int) -> tuple[Array, Array]:
    """Effective number and ancestors, averaged over filters."""
    if not filters:
        return np.zeros(steps), np.zeros(steps)
    effective, ancestors = zip(*((f.effective, f.ancestors()) for f in filters), strict=True)
    return np.mean(effective, 0), np.mean(ancestors, 0)
