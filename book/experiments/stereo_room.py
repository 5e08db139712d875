"""slamlib's stereo system in the rendered room, for chapter stereo_ekf_slam: sources of the motion, and loops."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from slambook import rendering, stereo_films
from slambook.smoothing import Smoother
from slambook.stereo_films import stereo_film

from slamlib.evaluation.consistency import band, nees, share_inside
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.records.inputs import Frame, Truth
from slamlib.rigs.setup import Rig
from slamlib.slam import Options, Slam
from slamlib.slam.snapshot import robot_view
from slamlib.vision.stereo import MOTION_SOURCES, StereoFeatureExtractor, StereoSettings, VisualOdometry
from slamlib.vision.stereo.motion_source import SplitFeatures, StereoMotionSource

STD = (0.06, 0.055, 0.05)  # px, of u, v and d: generous, NIS per number of the films is 0.15 to 0.34
SEEDS, FRAMES, LIGHT = (1, 2, 3), 150, 10
ROUND, ROUND_SEEDS, EVERY = 900, (1, 2), 15  # frames
TURN_SEEDS, OTHER_SEEDS = range(1, 11), range(11, 21)
ERRORS, MOTIONS, INTERVALS = ("local", "world"), ("constant-velocity", "covariance-intersection"), (1, 10)
OLD = 400  # frames: a landmark initialized so long ago and seen now closes the loop
OPTIONS = Options(points="eucPnt", updates=60, max_new_first=30, max_new=5, reproject=False)


class Twice(SplitFeatures):
    """The report's method: all features give the control, and the same ones update the map (E21)."""

    odometry_half = landmark_half = None


@dataclass(frozen=True)
class Way:
    """Where the motion comes from, and in one of how many frames a landmark is measured: its errors come last."""

    motion_source: Any
    update_interval: int = 1


WAYS = {
    "twice": Way(Twice),
    **{name: Way(source) for name, source in MOTION_SOURCES.items()},
    "in turns": Way(MOTION_SOURCES["correlated"], update_interval=10),
}
AT_ONCE = "split-features"  # the way past the wall whose data are taken all at once, too
Film = tuple[Rig, list[tuple[Frame, Truth]]]


def film(path: str, frames: int, seed: int) -> Film:
    """The rig, and pairs of pictures with the truth beside them; seed: of the noise."""
    rig, pairs, _ = stereo_film(frames, path, seed, STD, rendering.default_room())
    return rig, pairs


@dataclass(frozen=True, eq=False)
class Run:
    """Of each pair after the first: error of the pose (n, 6), its covariance (n, 6, 6), NEES (n,), true positions
    (n, 3) [m]."""

    errors: Array
    covariances: Array
    nees: Array
    true: Array
    nis: float
    landmarks: int
    old: list[int]

    @property
    def path(self) -> float:
        """Length of the true path [m]."""
        return float(np.linalg.norm(np.diff(self.true, axis=0), axis=1).sum())

    @property
    def row(self) -> dict[str, float]:
        """Errors of the position in per cent of the path, rms and at the end; orientation at the end [deg]."""
        away = 100 * np.linalg.norm(self.errors[:, :3], axis=1) / self.path
        return {
            "path": round(self.path, 2),
            "rms": round(float(np.sqrt((away**2).mean())), 4),
            "end": round(float(away[-1]), 4),
            "turn": round(float(np.degrees(np.linalg.norm(self.errors[-1, 3:]))), 3),
            "nis": round(self.nis, 3),
            "landmarks": self.landmarks,
        }


def moved_by(motion_source: StereoMotionSource, rig: Rig, options: Options, pose: Array | None = None) -> Slam:
    """A filter of the rig, whose motion is given; pose (7,): where it starts, if not where the rig does."""
    robots = (replace(rig.robots[0], motion=motion_source.motion),)
    slam = Slam(replace(rig, robots=robots), options=options, front_ends=[motion_source.front_end])
    if pose is not None:
        slam.robots[0].block.mean, _ = slam.rig.robots[0].start_at(pose, np.zeros(6))
    return slam


def advance(slam: Slam, motion_source: StereoMotionSource, frame: Frame, dt: float) -> Frame:
    """One pair, the control first; returns the frame with it."""
    image = frame.scans[0].image
    assert image is not None
    frame = replace(frame, dt=dt, controls=(motion_source.control(image, frame.dt, slam),))
    slam.step(frame)
    return frame


def run(film: Film, chosen: Way, options: Options = OPTIONS, at_once: bool = False) -> list[Run]:
    """A run through a film, from the pose of the first pair: by the filter, and, at_once, by all its data, too."""
    (rig, pairs), rows, nis, old = film, [], list[float](), []
    rig = chosen.motion_source.inflated(rig)
    sensor = rig.sensors[0]
    settings = StereoSettings(update_interval=chosen.update_interval, max_in_view=30)
    motion_source: StereoMotionSource = chosen.motion_source(sensor.calibration, sensor.extrinsics, settings)
    slam = moved_by(motion_source, rig, options, pairs[0][1].poses[0])
    smoother = Smoother(slam) if at_once else None
    for i, (frame, truth) in enumerate(pairs):
        frame = advance(slam, motion_source, frame, frame.dt if i else 0.0)
        if smoother is not None:
            smoother.record(frame)
        inliers = [prediction for prediction in slam.predictions[0] if prediction.inlier]
        nis += [prediction.nis for prediction in inliers]
        old.append(sum(prediction.landmark.first_seen < slam.number - OLD for prediction in inliers))
        robot = slam.robots[0]
        rows.append((truth.poses[0], robot.pose, robot_view(slam.belief, robot).pose_covariance))
    true, *estimate = (np.array(column)[1:] for column in zip(*rows, strict=True))
    estimates, fit, size = [estimate], float(np.mean(nis)) / 3, len(slam.landmarks)
    if smoother is not None:
        best = smoother.solve()
        estimates.append([best.poses[1:, 0], best.covariance(np.arange(1, len(pairs)))])
    return [
        Run(errors := Pose.minus(true, found), P, nees(errors, P), true[:, :3], fit, size, old)
        for found, P in estimates
    ]


def odometry(film: Film) -> dict[str, float]:
    """The same film by visual odometry alone: the motions of all features, one after another, and nothing else."""
    rig, pairs = film
    source = VisualOdometry(StereoFeatureExtractor(rig.sensors[0].calibration), rig.sensors[0].extrinsics)
    real = np.array([truth.poses[0] for _, truth in pairs])
    images = (frame.scans[0].image for frame, _ in pairs)
    found = np.array([pose for pose, _ in stereo_films.odometry(source, images, real[0])])
    errors = np.array([Pose.minus(a, b) for a, b in zip(real, found, strict=True)])[1:]
    nothing = np.zeros((len(errors), 6, 6))
    return Run(errors, nothing, np.zeros(len(errors)), real[1:, :3], 0.0, 0, []).row


def ways() -> dict[str, Any]:
    """Past the wall, with each way of using the matches, and with odometry alone."""
    found: dict[str, Any] = {"frames": FRAMES, "seeds": len(SEEDS), "odometry": []}
    squares = dict[str, list[Array]]()
    for seed in progress(SEEDS, len(SEEDS), "past the wall"):
        pairs = film("sideways", FRAMES, seed)
        found["odometry"].append(odometry(pairs))
        for way in WAYS:
            for name, made in zip((way, "all data"), run(pairs, WAYS[way], at_once=way == AT_ONCE), strict=False):
                found.setdefault(name, {"runs": []})["runs"].append(made.row)
                squares.setdefault(name, []).append(made.nees)
    limits = band(6, len(SEEDS))
    for name, all_runs in squares.items():
        average = np.mean(all_runs, axis=0)
        shares = [round(share_inside(part, limits), 3) for part in np.split(average, [len(average) // 2])]
        found[name] |= {"nees": np.round(average / 6, 3).tolist(), "inside": shares}
    return found


def light() -> list[dict[str, float]]:
    """The start of one run, by the filter and by all data at once, which a test runs again."""
    return [made.row for made in run(film("sideways", LIGHT, SEEDS[0]), WAYS["in turns"], at_once=True)]


def beginning() -> list[dict[str, Any]]:
    """Once round, the first pairs of the first film by each of the eight filters, which a test runs again."""
    return turned(film("round", LIGHT, TURN_SEEDS[0]))


def around() -> dict[str, Any]:
    """Once round by constant velocity, the figure's runs: errors and claimed deviations of the position [m]."""
    found: dict[str, Any] = {"frames": ROUND, "every": EVERY, "runs": []}
    for seed in progress(ROUND_SEEDS, len(ROUND_SEEDS), "round the room"):
        pairs = film("round", ROUND, seed)
        for error, interval in product(ERRORS, INTERVALS):
            (made,) = run(pairs, Way(MOTION_SOURCES[MOTIONS[0]], interval), replace(OPTIONS, error=error))
            found["path"] = made.row["path"]
            away = np.linalg.norm(made.errors[::EVERY, :3], axis=1)
            claimed = np.sqrt(np.trace(made.covariances[::EVERY, :3, :3], axis1=1, axis2=2))
            found["runs"].append({"error": error, "interval": interval, "away": away, "claimed": claimed, **laps(made)})
    return found


def turns(seeds: Sequence[int], at_once: bool = False) -> list[dict[str, Any]]:
    """Films once round the room, by each of the eight filters, and, at_once, by all data, too."""
    found = []
    for seed in progress(seeds, len(seeds), "two by two, twice"):
        found += turned(film("round", ROUND, seed), at_once)
    return found


def turned(pairs: Film, at_once: bool = False) -> list[dict[str, Any]]:
    """A film by two errors, two sources of the motion, landmarks in each pair or in one of ten; and at once."""
    found = []
    for error, motion, interval in product(ERRORS, MOTIONS, INTERVALS):
        smoothed = at_once and error == "world" and interval > 1
        made = run(pairs, Way(MOTION_SOURCES[motion], interval), replace(OPTIONS, error=error), smoothed)
        for by, one in zip((error, "all data"), made, strict=False):
            found.append({"error": by, "motion": motion, "interval": interval, **laps(one)})
    return found


def laps(made: Run) -> dict[str, Any]:
    """Of a run once round: errors in per cent of the path, NEES / 6 by quarters, most old landmarks of a late pair."""
    quarters = [float(q.mean()) / 6 for q in np.array_split(made.nees, 4)]
    return {"rms": made.row["rms"], "end": made.row["end"], "quarters": quarters, "old": max(made.old[-200:])}
