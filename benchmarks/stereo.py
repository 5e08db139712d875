"""The stereo front end: features and matches, plain visual odometry, and the filter, with truth beside them.

Rooms are rendered, 320 x 240 pixels, with a baseline of 12 cm. The street is an excerpt of KITTI's, where it is at hand
(its licence forbids shipping it). Errors are of the last position, as shares of the path. Times are CPU times;
those in parentheses are by the clock, which others may have used too.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slamlib.evaluation import chi2_quantile, nees
from slamlib.geometry.pose import Pose, compose
from slamlib.images.stereo import Eyes, StereoSearch, StereoSettings, VisualOdometry
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam
from slamlib.spaces import Array
from slamlib.tests.stereo import KITTI, kitti, stereo_film

VARIANTS = {
    "corners, upright, refined": StereoSettings(),
    "corners, upright": StereoSettings(patch=0),
    "ORB, one level, refined": StereoSettings(detector="orb"),
    "ORB, one level": StereoSettings(detector="orb", patch=0),
    "ORB, eight levels": StereoSettings(detector="orb8", patch=0),
}


@dataclass
class Counts:
    """Of each pair: features matched left to right, matched round the cycle, believed; and how well noise fits."""

    stereo: list[int] = field(default_factory=list)
    circular: list[int] = field(default_factory=list)
    inliers: list[int] = field(default_factory=list)
    fit: list[float] = field(default_factory=list)
    lost: int = 0
    seconds: float = 0.0


def odometry(calibration: Calibration, mount: Array, images: list[Array], start: Array, s: Any) -> tuple[Array, Counts]:
    """The last pose of the robot (7,), and the counts."""
    eyes, counts, pose = Eyes(calibration, s), Counts(), start
    moving = VisualOdometry(eyes, mount)
    began = time.process_time()
    for i, image in enumerate(images):
        motion = moving.step(image)
        counts.stereo.append(len(eyes.look(image)))
        if i:
            counts.circular.append(len(moving.pairs))
        if motion is not None:
            pose = compose(pose, motion.pose)
            counts.inliers.append(int(motion.inliers.sum()))
            counts.fit.append(motion.fit)
    counts.seconds = time.process_time() - began
    counts.lost = len(images) - 1 - len(counts.inliers)
    return pose, counts


def table(calibration: Calibration, mount: Array, images: list[Array], poses: Array) -> Iterator[str]:
    """Rows of plain visual odometry for each variant; poses (n, 7): the robot's true ones."""
    path = np.linalg.norm(np.diff(poses[:, :3], axis=0), axis=1).sum()
    yield f"{'':27} stereo  cycle  inliers (least)  lost  z'S^-1z/dof  end error  ms/pair    (path {path:.2f} m)"
    for name, settings in VARIANTS.items():
        pose, c = odometry(calibration, mount, images, poses[0], settings)
        error = np.linalg.norm(pose[:3] - poses[-1, :3]) / path
        yield (
            f"{name:27} {np.mean(c.stereo):6.0f} {np.mean(c.circular):6.0f} {np.mean(c.inliers):8.0f} "
            f"({min(c.inliers, default=0):5d}) {c.lost:5d} {np.mean(c.fit):12.2f} {error:10.2%} "
            f"{1e3 * c.seconds / len(images):8.0f}"
        )


def street() -> Iterator[str]:
    """Plain visual odometry on KITTI's street."""
    if not KITTI.is_dir():
        yield "KITTI's street is not at hand: skipped"
        return
    calibration, images, truth = kitti()
    yield from table(calibration, np.array([0.0, 0, 0, 1, 0, 0, 0]), images, truth.poses)


def room(frames: int, path: str) -> Iterator[str]:
    """Plain visual odometry in the room, with the noise that the street has too."""
    rig, film, _ = stereo_film(frames, path, std=0.2)
    poses = np.array([truth.robots[0][:7] for _, truth in film])
    images = [frame.scans[0].image for frame, _ in film]
    yield from table(rig.sensors[0].calibration, rig.sensors[0].mount, images, poses)


def filtered(frames: int, path: str, seed: int, std: float, options: Options) -> dict[str, Any]:
    """EKF-SLAM with constant velocity and StereoSearch through the room: numbers of one run."""
    rig, film, _ = stereo_film(frames, path, seed, std)
    front_end = StereoSearch(rig.sensors[0].calibration)
    slam = Slam(rig, options, front_ends=[front_end])
    errors, squares, innovations, seconds, believed = [], [], [], 0.0, []
    for frame, truth in film:
        began = time.process_time()
        slam.step(frame)
        seconds += time.process_time() - began
        block = slam.robots[0].block
        errors.append(Pose.minus(truth.robots[0][:7], slam.robots[0].pose))
        squares.append(float(nees(errors[-1], slam.belief.covariance(block)[:6, :6])))
        inliers = [look.nis for look in slam.looks[0] if look.inlier]
        innovations += inliers
        believed.append(len(inliers))
    poses = np.array([truth.robots[0][:3] for _, truth in film])
    length = np.linalg.norm(np.diff(poses, axis=0), axis=1).sum()
    away = np.linalg.norm(np.array(errors)[:, :3], axis=1)
    return {
        "path": length,
        "rms": np.sqrt((away**2).mean()) / length,
        "end": away[-1] / length,
        "turn": np.degrees(np.linalg.norm(errors[-1][3:])),
        "nees": np.array(squares),
        "nis": np.mean(innovations) / 3,
        "believed": np.mean(believed),
        "map": len(slam.landmarks),
        "ms": 1e3 * seconds / frames,
        **{part: 1e3 * spent / frames for part, spent in front_end.seconds.items()},
    }


def slam(frames: int, path: str, seeds: int, std: float, options: Options) -> Iterator[str]:
    """The filter's rows, one for each seed, and its NEES over them."""
    yield (
        f"path {path}, {frames} frames, std {std} px, {'in sequence' if options.reproject else 'in one batch'}:\n"
        "seed  path    rms error  end error  turn     NIS/3  believed  map  ms/frame (search, detection)"
    )
    runs = []
    for seed in range(1, seeds + 1):
        r = filtered(frames, path, seed, std, options)
        runs.append(r["nees"])
        yield (
            f"{seed:4} {r['path']:5.2f} m {r['rms']:10.2%} {r['end']:10.2%} {r['turn']:6.2f} deg {r['nis']:5.2f} "
            f"{r['believed']:8.0f} {r['map']:5d} {r['ms']:8.0f} ({r['search']:.0f}, {r['detection']:.0f})"
        )
    mean, half = np.mean(runs, axis=0) / 6, frames // 2
    low, high = (chi2_quantile(p, 6 * seeds) / (6 * seeds) for p in (0.025, 0.975))
    inside = np.mean((mean[:half] >= low) & (mean[:half] <= high))
    yield (
        f"NEES/6 over {seeds} runs: first half {mean[:half].mean():.2f}, second {mean[half:].mean():.2f}; "
        f"95 % band of one step [{low:.2f}, {high:.2f}], {inside:.0%} of the first half inside"
    )


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=150, help="of the films (default 150)")
    parser.add_argument("--seeds", type=int, default=3, help="of the filter (default 3)")
    parser.add_argument("--std", type=float, default=0.15, help="of the filter's measurements [px] (default 0.15)")
    parser.add_argument("--path", default="sideways", help="through the room (default sideways)")
    parser.add_argument("--batch", action="store_true", help="correct in one batch")
    parser.add_argument("--only", choices=["street", "room", "filter"], help="one of the tables")
    given = parser.parse_args()
    options = Options(points="eucPnt", updates=60, first=60, later=10, reproject=not given.batch)
    tables: dict[str, Callable[[], Iterator[str]]] = {
        "street": street,
        "room": lambda: room(given.frames, given.path),
        "filter": lambda: slam(given.frames, given.path, given.seeds, given.std, options),
    }
    for name, rows in tables.items():
        if given.only in (None, name):
            print(f"--- {name}", *rows(), sep="\n", end="\n\n", flush=True)


if __name__ == "__main__":
    main()
