"""Odometry, the filter and smoothing side by side, on tracks of a car's drive round a block of houses (KITTI 07).

The tracks are given, some 65 of a pair (Geiger and others 2012; tracked for a course on visual-inertial SLAM); the
licence forbids shipping them. All three have the same measurements, noise and odometry; the filter and smoothing have
both with twice the variance (covariance intersection), since the odometry uses the same matches. Of the odometry's
motions, one in twelve is missing, and is extrapolated from the one before:

Where few tracks were left, their pixels were written down once more for the next pair, and tracking went on from there:
in a picture in which these pixels show something else. `drive` begins new tracks after each such copy.

The tracks say nothing about the loop: a point that was lost has a new number when it is seen again. What a recognition
of places would say is taken from the truth: tracks of the last pairs that, triangulated by the true poses, are each
other's nearest and within NEAR of one of the first. "No loop" is without these. Landmarks not seen for WINDOW pairs are
deleted, but for those of the first pairs.

Found: at each of the 91 gaps the orientation is uncertain by half a degree. The right-invariant filter adds this up and
is consistent; the ordinary one claims an orientation that nothing measured, and is four times as far off as odometry.
The points of the loop are predicted outside the image, 12 m off, and change nothing.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from slambook.smoothing import Smoother
from slambook.stereo_films import DATA

from slamlib.evaluation.comparison import compared
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import from_frame
from slamlib.manifolds import Array, Indices, Mask
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam
from slamlib.vision.stereo import motion_between
from slamlib.vision.stereo.fitting import triangulate
from slamlib.vision.stereo.motion_source import CovarianceIntersection, MotionFallback

TRACKS = DATA / "stereo_kitti07_tracks"
STD = (0.2, 0.2, 0.2)  # px, of u, v and disparity: what the odometry's NIS finds
ROWS, LEAST = 2.0, 1.0  # px: largest difference of the rows of a match, and least disparity
FIRST, LAST, NEAR = 80, 1035, 0.3  # pairs on the street that is driven twice; [m]
NEARBY = 3.0  # px: least disparity of what is triangulated for the names
WINDOW = 8  # pairs
OPTIONS = Options(points="eucPnt", error="world", updates=100, max_new_first=100, max_new=100, reproject=False)


@dataclass(frozen=True, eq=False)
class Drive:
    """values (n, k, 3): (u, v, disparity) [px] of n tracks in k pairs, nan where one is not seen; numbers (n, k): of
    the points that they show; the rig, and the true path of the left camera."""

    values: Array
    numbers: Indices
    rig: Rig
    truth: Trajectory

    @property
    def calibration(self) -> Calibration:
        """Of the rig's one sensor."""
        return self.rig.sensors[0].calibration

    def seen(self, pair: int) -> Mask:
        """Mask (n,) of the tracks that are seen in a pair."""
        mask: Mask = np.isfinite(self.values[:, pair, 0])
        return mask


def drive() -> Drive:
    """The tracks and the true path; must be at hand."""
    held, truth = np.load(TRACKS / "tracks.npz"), read_trajectory(TRACKS / "groundtruth.txt")
    left_u, left_v, right_u, right_v = held["features"][..., : len(truth)]
    values = np.stack([left_u, left_v, left_u - right_u], axis=-1)
    values[(left_u < 0) | (np.abs(left_v - right_v) > ROWS) | (values[..., 2] < LEAST)] = np.nan
    lasting = np.isfinite(values[:, 1:, 0]) & np.isfinite(values[:, :-1, 0])
    again = lasting & (values[:, 1:] == values[:, :-1]).all(-1)
    copies = np.concatenate([[False], again.sum(0) == lasting.sum(0)])
    values[:, 1:][again & copies[1:]] = np.nan
    numbers = 1 + np.arange(len(values))[:, None] + len(values) * np.cumsum(copies)
    K = held["K"]
    lens = {"intrinsics": (K[0, 2], K[1, 2], K[0, 0], K[1, 1]), "baseline": (float(held["b"]),)}
    sensor = SensorSetup(type="stereo", image=(1226, 370), std=STD, parameters=lens)
    return Drive(values, numbers, Rig((RobotSetup(motion="odometry"),), (sensor,)), truth)


def odometry(d: Drive, variance: float = 1.0) -> Iterator[tuple[Control, float]]:
    """The control to each pair after the first, by the tracks common to both, and its NIS by dof; nan where it is
    extrapolated. variance: factor of the measurements' variances."""
    fallback, sensor = MotionFallback(), CovarianceIntersection.inflated(d.rig).sensors[0]
    calibration = sensor.calibration if variance > 1 else d.calibration
    for pair, dt in enumerate(np.diff(d.truth.times), start=1):
        both = d.seen(pair - 1) & d.seen(pair) & (d.numbers[:, pair - 1] == d.numbers[:, pair])
        found = motion_between(calibration, d.values[both, pair - 1], d.values[both, pair], sensor.extrinsics)
        if found is None:
            yield fallback.extrapolate(dt), np.nan
        else:
            fallback.record(found.control, dt)
            yield found.control, found.nis_per_dof


def with_loop(d: Drive) -> Drive:
    """The drive whose last points have the numbers of the first ones, where they are the same."""
    (early, old), (late, new) = (_points(d, pairs) for pairs in (range(FIRST), range(LAST, len(d.truth))))
    apart = np.linalg.norm(old[:, None] - new[None], axis=-1)
    rows, columns = np.arange(len(old)), apart.argmin(1)
    same = (apart.argmin(0)[columns] == rows) & (apart[rows, columns] < NEAR)
    numbers = d.numbers.copy()
    for first, again in zip(early[same], late[columns[same]], strict=True):
        numbers[numbers == again] = first
    return replace(d, numbers=numbers)


def _points(d: Drive, pairs: range) -> tuple[Indices, Array]:
    """Numbers (k,) of what is seen in these pairs, and points (k, 3) by the true poses, weighted by disparity^4."""
    rows = [np.flatnonzero(d.seen(pair) & (np.nan_to_num(d.values[:, pair, 2]) > NEARBY)) for pair in pairs]
    seen = [(d.numbers[near, pair], d.values[near, pair], pair) for near, pair in zip(rows, pairs, strict=True)]
    points = [from_frame(d.truth.poses[pair], triangulate(d.calibration, values)[0]) for _, values, pair in seen]
    weights = np.concatenate([values[:, 2] ** 4 for _, values, _ in seen])
    numbers, of = np.unique(np.concatenate([own for own, _, _ in seen]), return_inverse=True)
    sums = [np.bincount(of, weights * column) for column in np.concatenate(points).T]
    return numbers, np.stack(sums, axis=1) / np.bincount(of, weights)[:, None]


def run(
    d: Drive, moves: list[Control], rig: Rig, options: Options = OPTIONS
) -> tuple[Trajectory, Smoother, dict[str, int]]:
    """The camera's path as filtered; the smoother that has listened; how often points of the first pairs that are in
    the map were seen in the last ones, and how often the filter predicted them in the image."""
    slam, again = Slam(rig, options=options), {"seen": 0, "predicted": 0}
    smoother, poses, covariances = Smoother(slam), [], []
    still = Control(np.zeros(6), np.zeros((6, 6)))
    steps = [(still, 0.0), *zip(moves, np.diff(d.truth.times).tolist(), strict=True)]
    for pair, (control, dt) in enumerate(progress(steps, len(steps), "filter")):
        seen = d.seen(pair)
        ids, rows = np.unique(d.numbers[seen, pair], return_index=True)
        frame = Frame(pair + 1, dt, (control,), (Scan({"points": Features(ids, d.values[seen, pair][rows])}),))
        old = {lm.id for lm in slam.landmarks if lm.first_seen <= FIRST} & set(ids) if pair >= LAST else set()
        slam.step(frame)
        again["seen"] += len(old)
        again["predicted"] += sum(prediction.landmark.id in old for prediction in slam.predictions[0])
        smoother.record(frame)
        for landmark in [lm for lm in slam.landmarks if lm.first_seen > FIRST and pair + 1 - lm.last_seen > WINDOW]:
            slam.prune(landmark)
        poses.append(slam.robots[0].pose)
        covariances.append(slam.belief.covariance(slam.robots[0].block))
    path = Trajectory(d.truth.times, np.array(poses), np.array(covariances))
    return path.sensor_trajectory(rig.sensors[0].extrinsics), smoother, again


def smoothed(d: Drive, smoother: Smoother) -> Trajectory:
    """The camera's path by all measurements at once, with a robust loss."""
    found = smoother.solve(loss="cauchy")
    path = Trajectory(d.truth.times, found.poses[:, 0], found.covariance(np.arange(len(d.truth))))
    return path.sensor_trajectory(d.rig.sensors[0].extrinsics)


def figures() -> dict[str, Any]:
    """By the way in which the path was found, its errors; and about the odometry. The tracks must be at hand."""
    d = drive()
    told, doubled = (list(odometry(d, variance)) for variance in (1.0, CovarianceIntersection.variance))
    fits = np.array([fit for _, fit in told])
    alone, *_ = run(d, [control for control, _ in told], d.rig, Options(points=None))
    found = {"odometry alone": judged(alone, d)}
    moves, rig = [control for control, _ in doubled], CovarianceIntersection.inflated(d.rig)
    found["ordinary filter"] = judged(run(d, moves, rig, replace(OPTIONS, error="local"))[0], d)
    for name, own in (("no loop", d), ("loop", with_loop(d))):
        path, smoother, again = run(own, moves, rig)
        found[f"filter, {name}"] = judged(path, d)
        found[f"smoothing, {name}"] = judged(smoothed(d, smoother), d)
    return {
        "pairs": len(d.truth),
        "path": float(d.truth.distances[-1]),
        "missing": int(np.isnan(fits).sum()),
        "fit": float(np.nanmedian(fits)),
        "same": len(np.unique(own.numbers[own.numbers != d.numbers])),
        "again": again,
        "paths": found,
    }


def judged(path: Trajectory, d: Drive) -> dict[str, float]:
    """ATE after the best rigid motion [m]; KITTI's measure, shares and degrees a metre; RPE from each pair to the next
    [m, degrees]; NEES of 6, placed by the first second, and its share in its band; errors and sigmas at the end [m,
    degrees].
    """
    found, _ = compared(path, d.truth, True)
    part, step, nees = found["parts"], found["rpe"], found["nees"]
    return {
        "ate": found["ate"],
        "translation": part["translation_mean"],
        "rotation": part["rotation_mean"],
        "rpe": step["position"]["rmse"],
        "turn": step["orientation"]["rmse"],
        "nees": nees["median"],
        "inside": nees["inside"],
        "end": nees["at_end"]["position"],
        "sigma": nees["at_end"]["position_sigma"],
        "end_turn": nees["at_end"]["orientation"],
        "turn_sigma": nees["at_end"]["orientation_sigma"],
    }


def table(found: dict[str, Any]) -> Iterator[str]:
    """As printed lines."""
    yield f"{found['pairs']} pairs, {found['path']:.0f} m; {found['missing']} motions extrapolated, of the others"
    yield f"NIS/dof {found['fit']:.2f} (median); {found['same']} of the last points are known from the start,"
    yield f"seen {found['again']['seen']} times, predicted in the image {found['again']['predicted']} times\n"
    yield "                      ATE  KITTI's    deg/m     RPE            median NEES  inside    at the end, sigmas"
    for name, e in found["paths"].items():
        yield (
            f"{name:18} {e['ate']:5.2f} m {e['translation']:8.3%} {e['rotation']:8.4f} {1e3 * e['rpe']:5.1f} mm "
            f"{e['turn']:6.4f} deg {e['nees']:8.1f} {e['inside']:9.0%} {e['end']:10.1f} m {e['sigma']:5.1f} m "
            f"{e['end_turn']:5.1f} deg {e['turn_sigma']:4.1f} deg"
        )


if __name__ == "__main__":
    for line in table(figures()) if TRACKS.is_dir() else ["set SLAMLIB_DATA"]:
        print(line)
