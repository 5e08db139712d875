"""Runs of recorded landmarks through the filter, and of all their data at once; errors and NEES against the truth."""

import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.recordings import Sightings
from slambook.smoothing import Smoother
from slamlib.evaluation.alignment import align
from slamlib.evaluation.comparison import ComparisonOptions, compared
from slamlib.evaluation.consistency import band, nees, rmse, share_inside
from slamlib.evaluation.trajectory import Trajectory, associate
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import Pose, to_frame
from slamlib.landmarks import POINTS
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import viewpoint
from slamlib.records.ids import Id
from slamlib.slam import Slam
from slamlib.slam.data_association.gates import gate
from slamlib.slam.snapshot import robot_view
from slamlib.vision.results import PRODUCTS, innovation_correlation, lasting, whitened

KNOWN = 40  # poses, evenly spread, whose covariances are taken of what was smoothed


def meet(slam: Slam, observer: int, observed: int, measured: Array) -> bool:
    """A robot's sensor has measured another robot: an update of two poses, if it passes the gate."""
    view, other = viewpoint(slam.sensors[observer]), slam.robots[observed]
    blocks, calibration = [view.sensor.robot.block, other.block], view.sensor.calibration
    there, J = to_frame.jac(view.pose, other.pose[:3])
    expected, by = calibration.project_jac(np.append(there, 1.0))
    H = by.point[:, :3]
    by_other = np.pad(H @ J.point, ((0, 0), (0, 3)))  # its orientation is not seen
    jacobians = [H @ J.pose @ view.jacobian, other.motion.by_state(by_other, other.block.mean)]
    innovation = calibration.sensor.manifold.minus(measured, expected)
    S = slam.belief.innovation_covariance(blocks, jacobians, calibration.noise)
    is_inlier = bool(innovation @ np.linalg.solve(S, innovation) < gate(slam.options.gate, len(innovation)))
    if is_inlier:
        slam.update(blocks, jacobians, innovation, calibration.noise, robot=slam.robots.index(view.sensor.robot))
    return is_inlier


@dataclass(frozen=True, eq=False)
class Estimate:
    """times (n,) [s]; by robot its poses (n, 7), the frames (k,) whose covariances are known, and these (k, 6, 6).

    points: means (3,) and covariances (3, 3) by number.
    """

    times: Array
    poses: list[Array]
    known: Indices
    covariances: list[Array]
    points: dict[Any, tuple[Array, Array]]


def run(
    recording: Sightings, meetings: bool = False, smooth: bool = True, **said: Any
) -> tuple[dict[str, Any], list[Estimate]]:
    """Figures of a run that do not depend on the truth, the filter's estimate, and that of all its data at once.

    meetings: whether the robots' measurements of each other are used, which only the filter can. said: options.
    """
    slam = recording.slam(**said)
    smoother = Smoother(slam) if smooth else None
    poses, covariances, matched, met, began = [], [], np.zeros(2, int), np.zeros(2, int), time.process_time()
    now, products = dict[Id, Array](), []
    for frame in progress(recording.frames, len(recording.frames), "frames"):
        slam.step(frame)
        if smoother:
            smoother.record(frame)
        before, now = now, whitened(slam)
        found_again = lasting(now, before)
        products.append([found_again[name] for name in PRODUCTS])
        matched += [sum(getattr(p, n) for own in slam.predictions for p in own) for n in ("matched", "inlier")]
        for meeting in recording.meetings.get(frame.number, []) if meetings else ():
            met += [1, meet(slam, *meeting)]
        poses.append([robot.pose for robot in slam.robots])
        covariances.append([robot_view(slam.belief, robot).pose_covariance for robot in slam.robots])
    times = np.cumsum([frame.dt for frame in recording.frames])
    figures = {"frames": len(times), "seconds": times[-1], "landmarks": len(slam.landmarks), "matched": int(matched[0])}
    figures |= {"inliers": matched[1] / matched[0], "met": met.tolist()}
    if lasts := innovation_correlation(np.array(products)):  # of the first sensor's innovations
        figures["correlation"] = lasts[0]
    figures["frames_per_second"] = len(times) / (time.process_time() - began)
    points = {lm.id: in_world(lm.kind, lm.block.mean, slam.belief.covariance(lm.block)) for lm in slam.landmarks}
    own, known = ([*np.swapaxes(rows, 0, 1)] for rows in (poses, covariances))
    found = [Estimate(times, own, np.arange(len(times)), known, points)]
    if smoother:
        best, at = smoother.solve(), np.unique(np.linspace(0, len(times) - 1, KNOWN).astype(int))
        own, known = [*best.poses.swapaxes(0, 1)], [best.covariance(at, robot) for robot in range(len(slam.robots))]
        found.append(Estimate(times, own, at, known, {number: best.point(number) for number in best.landmarks}))
    return figures, found


def in_world(kind: Any, mean: Array, covariance: Array) -> tuple[Array, Array]:
    """The place (3,) of a point of this kind, and its covariance (3, 3)."""
    place, J = kind.to_point.jac(mean)
    return place, J.landmark @ covariance @ J.landmark.T


def judged(recording: Sightings, found: Estimate, robot: int = 0, frames: Any = slice(None)) -> dict[str, Any]:
    """Errors of a robot's poses, of these frames alone; NEES of where it can be at all, after the first second."""
    truth, poses, free = recording.truths[robot], found.poses[robot], recording.rig.robots[robot].model.free
    rows = np.arange(len(poses))[frames]
    errors = compared(Trajectory(found.times, poses)[rows], truth, True, how=ComparisonOptions(tolerance=0.02))[0]
    known = Trajectory(found.times[found.known], poses[found.known], found.covariances[robot])
    known = known[np.isin(found.known, rows)]
    i, j = associate(known, truth, 0.02)
    late = known.times[i] > 1
    e = Pose.minus(truth.poses[j], known.poses[i])[late] @ free
    P = free.T @ np.asarray(known.covariances)[i][late] @ free
    values, dof = nees(e, P), free.shape[1]
    return {
        "poses": errors["poses"], "length": errors["path_length"], "ate": errors["ate"],
        "rpe": [errors["rpe"][name]["rmse"] for name in ("position", "orientation")],
        "orientation": errors["orientation_rms"],
        "nees": {"dof": dof, "count": len(values), "mean": values.mean(), "median": np.median(values),
                 "inside": share_inside(values, band(dof))},
    }  # fmt: skip


def judged_map(recording: Sightings, found: Estimate) -> dict[str, Any]:
    """Errors [m] of the points that the truth has: as they stand, and after a rigid motion; their NEES."""
    ids = sorted(set(found.points) & set(recording.points))
    size = POINTS[str(recording.options.points)].manifold.dof  # two of a point of the floor: x, y
    mean, P = (np.array([found.points[i][part] for i in ids]) for part in (0, 1))
    true = np.array([recording.points[i] for i in ids])
    off = align(mean, true, scale=False)(mean) - true
    values = nees((true - mean)[:, :size], P[:, :size, :size])
    return {"points": len(ids), "of": len(recording.points), "rms": rmse(true - mean), "aligned": rmse(off),
            "nees": {"dof": size, "mean": values.mean(), "median": np.median(values)}}  # fmt: skip
