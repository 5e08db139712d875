"""One preset by filters that differ in the error whose covariance they keep, by the oracle, and by all data at once.

The same data, the same seeds. FILTERS: two of the options' errors, and "oracle"; ALL_DATA: smoothing, with the data
association and the start of the ordinary filter. Chapter observability.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from slambook.oracle import Oracle
from slambook.smoothing import Smoother
from slamlib.evaluation.consistency import band, chi2_quantile, nees_where_uncertain, share_inside
from slamlib.experiments.presets import Preset
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array

FILTERS, ALL_DATA = ("local", "world", "oracle"), "all data"
DOF = 6


def poses(preset: Preset, seed: int, name: str) -> tuple[Array, Array, Array]:
    """Of each robot in one run by this name: true poses (n, r, 7), estimated ones, their covariances (n, r, 6, 6)."""
    error = name if name in FILTERS[:2] else "local"
    preset = replace(preset, seed=seed, options=replace(preset.options, error=error))
    slam = preset.slam()
    oracle = Oracle(slam, preset.world) if name == "oracle" else None
    smoother = Smoother(slam) if name == ALL_DATA else None
    true, estimates, covariances = [], [], []
    for frame, truth in preset.simulate():
        if oracle:
            oracle.truth = truth
        slam.step(frame)
        if smoother:
            smoother.record(frame)
        true.append([state[:7] for state in truth.robots])
        estimates.append([robot.pose for robot in slam.robots])
        covariances.append([slam.belief.covariance(robot.block)[:DOF, :DOF] for robot in slam.robots])
    if not smoother:
        return np.array(true), np.array(estimates), np.array(covariances)
    found, frames = smoother.solve(), np.arange(len(true))
    marginals = [found.covariance(frames, robot) for robot in range(len(slam.robots))]
    return np.array(true), found.poses, np.stack(marginals, axis=1)


def run(preset: Preset, seed: int, name: str) -> dict[str, Array]:
    """One run, of each robot: nees (n, r); heading (n, r, 2), its error and its sigma [rad].

    The heading is the rotation about the robot's own vertical axis.
    """
    true, x, P = poses(preset, seed, name)
    errors = Pose.minus(true, x)
    nees = [[nees_where_uncertain(e, C) for e, C in zip(*step, strict=True)] for step in zip(errors, P, strict=True)]
    return {"nees": np.array(nees), "heading": np.stack([errors[..., -1], np.sqrt(P[..., -1, -1])], axis=-1)}


def away(preset: Preset, seed: int, name: str) -> dict[str, Array]:
    """One run of the first robot: away (n, 2), its error away from the start and the sigma [m]; others (n,).

    A scale that is too small leaves it too near: an error above zero. others: NEES of the rest, 5 degrees of freedom.
    """
    true, x, P = (values[:, 0] for values in poses(preset, seed, name))
    arm = true[:, :3] - preset.rig.robots[0].state[:3]
    out = arm / np.linalg.norm(arm, axis=-1, keepdims=True)
    rows, others = [], []
    for e, C, u in zip(Pose.minus(true, x), P, out, strict=True):
        rows.append((u @ e[:3], np.sqrt(u @ C[:3, :3] @ u)))
        across = np.linalg.svd(np.append(u, np.zeros(3))[None])[2][1:]
        others.append(nees_where_uncertain(across @ e, across @ C @ across.T))
    return {"away": np.array(rows), "others": np.array(others)}


@dataclass(frozen=True)
class Verdict:
    """What the NEES of many runs says of a filter, all robots together.

    mean: over runs and steps, with its standard error over runs; median: of the runs' means; failed: share of runs
    whose own mean is above the 95 % limit of one step; inside: share of the steps whose average lies inside the band.
    average (n,): over the runs and robots at each step.
    """

    mean: float
    error: float
    median: float
    failed: float
    inside: float
    average: Array

    @classmethod
    def of(cls, nees: Array) -> "Verdict":
        """Of NEES (k, n, r) of k runs."""
        own = nees.mean((1, 2))
        inside = [share_inside(nees[:, :, robot].mean(0), band(DOF, len(nees))) for robot in range(nees.shape[2])]
        return cls(
            mean=float(own.mean()),
            error=float(own.std(ddof=1) / np.sqrt(len(own))),
            median=float(np.median(own)),
            failed=float((own > chi2_quantile(0.95, DOF)).mean()),
            inside=float(np.mean(inside)),
            average=nees.mean((0, 2)),
        )


def stacked(rows: Sequence[dict[str, Array]], name: str) -> Array:
    """One column of many runs, (k, n, ...)."""
    return np.array([row[name] for row in rows])
