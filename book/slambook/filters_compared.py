"""One preset by filters that differ in the error whose covariance they keep, by the oracle, and by all data at once.

The same data, the same seeds. FILTERS: two of the options' errors, and "oracle"; WITH_ANCHORS: a third of the options';
ALL_DATA: smoothing, with the data association and the start of the ordinary filter. For estimated extrinsics: LATER,
"world" with the first frames by the other sensors alone; SECOND_ORDER, "world" with the second-order term's variance.
Chapter observability.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slambook.oracle import Oracle
from slambook.smoothing import Smoother
from slamlib.evaluation import pose_errors
from slamlib.evaluation.consistency import band, nees_in_range, share_inside
from slamlib.evaluation.pose_errors import UNITS, pose_nees
from slamlib.experiments.presets import Preset
from slamlib.geometry.pose import Pose
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array
from slamlib.records.inputs import Scan
from slamlib.slam.snapshot import robot_view

FILTERS, WITH_ANCHORS, ALL_DATA = ("local", "world", "oracle"), "anchors", "all data"
LATER, ALONE = "later", 20  # frames
SECOND_ORDER = "second order"
# The option `error` of those that are not named after it.
ERRORS = {"oracle": "local", ALL_DATA: "local", LATER: "world", SECOND_ORDER: "world"}
DOF = 6


def known_to(preset: Preset, share: float) -> Preset:
    """The second sensor's estimated extrinsics are known to this share of their standard deviations; 0: exactly."""
    first, second = preset.rig.sensors
    position, turn = (tuple(share * std for std in stds) for stds in (second.position_std, second.orientation_std))
    second = replace(second, estimated=share > 0, position_std=position, orientation_std=turn)
    return replace(preset, rig=replace(preset.rig, sensors=(first, second)))


def poses(preset: Preset, seed: int, name: str) -> tuple[Array, Array, Array]:
    """Of each robot in one run by this name: true poses (n, r, 7), estimated ones, their covariances (n, r, 6, 6)."""
    true, estimates, covariances, smoother = _filtered(preset, seed, name)
    return (true, *_smoothed(smoother, len(true))) if smoother else (true, estimates, covariances)


def _filtered(preset: Preset, seed: int, name: str) -> tuple[Array, Array, Array, Smoother | None]:
    """Poses as the filter has them, and the smoother that listened to it, for ALL_DATA."""
    second_order = "variance" if name == SECOND_ORDER else None
    options = replace(preset.options, error=ERRORS.get(name, name), second_order=second_order)
    preset = replace(preset, seed=seed, options=options)
    slam = preset.slam()
    oracle = Oracle(slam, preset.world) if name == "oracle" else None
    smoother = Smoother(slam) if name == ALL_DATA else None
    true, estimates, covariances = [], [], []
    for frame, truth in preset.simulate():
        if oracle:
            oracle.truth = truth
        if name == LATER and frame.number <= ALONE:
            pairs = zip(slam.sensors, frame.scans, strict=True)
            frame = replace(frame, scans=tuple(Scan() if sensor.block else scan for sensor, scan in pairs))
        slam.step(frame)
        if smoother:
            smoother.record(frame)
        true.append(list(truth.poses))
        estimates.append([robot.pose for robot in slam.robots])
        covariances.append([robot_view(slam.belief, robot).pose_covariance for robot in slam.robots])
    return np.array(true), np.array(estimates), np.array(covariances), smoother


def _smoothed(smoother: Smoother, frames: int) -> tuple[Array, Array]:
    """Poses (n, r, 7) and their covariances (n, r, 6, 6)."""
    found = smoother.solve()
    robots = range(found.poses.shape[1])
    return found.poses, np.stack([found.covariance(np.arange(frames), robot) for robot in robots], axis=1)


def nees_by_error(preset: Preset, seed: int, name: str) -> dict[str, Array]:
    """NEES (n, r) of each robot's pose in one run by this name, of each of `pose_errors.ERRORS`.

    The oracle's covariance is written in the coordinates at the truth, the others' in those at the estimate.
    """
    true, estimates, covariances = poses(preset, seed, name)
    pair = (estimates, true) if name == "oracle" else (true, estimates)  # a sign, which a square does not see
    free = [robot.model.free for robot in preset.rig.robots]

    def of_frame(errors: Array, P: Array) -> list[float]:
        return [pose_nees(*own)[0] for own in zip(errors, P, free, strict=True)]

    return {
        error: np.array([of_frame(*each) for each in zip(of(*pair), covariances, strict=True)])
        for error, of in pose_errors.ERRORS.items()
    }


def run(preset: Preset, seed: int, name: str) -> dict[str, Array]:
    """One run: nees (n, r) of each robot; the others of the first robot, at each step.

    heading (n, 2): error of the rotation about the robot's own vertical axis, and its sigma [rad]; scale (n, 2): error
    away from the start, and its sigma [m], above zero if the scale is too small; rest (n,): NEES of the five other
    directions. position (n,): distance of the estimate from the truth [m].
    """
    return _judged(preset, *poses(preset, seed, name))


def beside(preset: Preset, seed: int) -> tuple[dict[str, Array], dict[str, Array]]:
    """One run by the ordinary filter, and by all its data at once: what `run` says of each."""
    true, x, P, smoother = _filtered(preset, seed, ALL_DATA)
    assert smoother
    return _judged(preset, true, x, P), _judged(preset, true, *_smoothed(smoother, len(true)))


def _nees(error: Array, covariance: Array, units: tuple[int, ...]) -> float:
    """NEES of an error; nan where something of it is known exactly, as at the start."""
    nees, rank = nees_in_range(error, covariance, units)
    return nees if rank == len(error) else np.nan


def _judged(preset: Preset, true: Array, x: Array, P: Array) -> dict[str, Array]:
    errors = Pose.minus(true, x)
    nees = [[_nees(e, C, UNITS) for e, C in zip(*step, strict=True)] for step in zip(errors, P, strict=True)]
    errors, P, arm = errors[:, 0], P[:, 0], true[:, 0, :3] - preset.rig.robots[0].state[:3]
    out = arm / np.linalg.norm(arm, axis=-1, keepdims=True)
    scale, rest = [], []
    for e, C, u in zip(errors, P, out, strict=True):
        scale.append((u @ e[:3], np.sqrt(u @ C[:3, :3] @ u)))
        across = np.linalg.svd(np.append(u, np.zeros(3))[None])[2][1:]
        rest.append(_nees(across @ e, across @ C @ across.T, (2, 3)))
    heading = np.stack([errors[:, -1], np.sqrt(P[:, -1, -1])], axis=-1)
    said = {"nees": np.array(nees), "heading": heading, "scale": np.array(scale), "rest": np.array(rest)}
    return {**said, "position": np.linalg.norm(errors[:, :3], axis=-1)}


@dataclass(frozen=True)
class Verdict:
    """What the NEES of k runs of n steps says of a filter with r robots.

    own (k,): mean of each run; average (n, r): over the runs at each step.
    """

    own: Array
    average: Array

    @classmethod
    def of(cls, nees: Array) -> "Verdict":
        """Of NEES (k, n, r)."""
        return cls(nees.mean((1, 2)), nees.mean(0))

    def joined(self, other: "Verdict") -> "Verdict":
        """Of these runs and of others."""
        average = np.average([self.average, other.average], axis=0, weights=[len(self.own), len(other.own)])
        return Verdict(np.concatenate([self.own, other.own]), average)

    def numbers(self) -> dict[str, float]:
        """What is said of them in a table.

        mean: over runs and steps, with its standard error over runs; median: of the runs' means; failed: share of runs
        whose own mean is above the 95 % limit of one step; inside: share of the steps whose average lies in the band.
        """
        limits = band(DOF, len(self.own))
        return {
            "mean": float(self.own.mean()),
            "error": float(self.own.std(ddof=1) / np.sqrt(len(self.own))),
            "median": float(np.median(self.own)),
            "failed": float((self.own > chi2_quantile(0.95, DOF)).mean()),
            "inside": float(np.mean([share_inside(robot, limits) for robot in self.average.T])),
        }


def stacked(rows: Sequence[dict[str, Array]], name: str) -> Array:
    """One column of many runs, (k, n, ...)."""
    return np.array([row[name] for row in rows])


def rows_of_both_errors(found: dict[str, Any], cases: Sequence[str]) -> list[Any]:
    """Rows of a table of cases, each by its filters, of what `book.experiments.presets_by_both_errors` stores.

    A row: name, mean NEES of the linear error and its standard error in each set of seeds, the same of the invariant
    error, and of this the median of the runs and the share of failed ones. Above them the case, and how many runs.
    """
    rows: list[Any] = []
    for case in cases:
        of_case = dict(found[case])
        rows.append(f"{case}, 2 x {of_case.pop('runs')} runs")
        for name, by_error in of_case.items():
            sets = [np.array(own) for error in pose_errors.ERRORS for own in by_error[error]]
            means = [f"{own.mean():.2f} ± {own.std(ddof=1) / np.sqrt(len(own)):.2f}" for own in sets]
            own = np.concatenate(by_error["invariant"])
            rows.append([name, *means, float(np.median(own)), float((own > chi2_quantile(0.95, DOF)).mean())])
    return rows
