"""Visual odometry by plain OpenCV beside slamlib's, part by part: each one's features with each one's motion.

Features: slamlib's corners with upright descriptors (by default, and twice as many); Lucas-Kanade tracks of OpenCV's
corners; SIFT; all of them matched in a circle: old left, old right, new right, new left, and back. Motions: OpenCV's
solvePnPRansac, which refines by all its inliers, with their old points taken for exact; and slamlib's, the motion of a
sample by the same function, then the most likely one of the measurements of both pairs, with its covariance.

On real sequences at hand: KITTI's street, which is passed once, and EuRoC's rig that is waved by hand. Each row has
RUNS runs, each with nine tenths of the matches, drawn at random: their mean, and their standard deviation, which tells
what chance there is in a difference. Numbers and windows of Lucas-Kanade's tracks were chosen on the street, in favour
of OpenCV. Times are the processor's, of one thread; slamlib's features include one motion, by which their regions are
predicted.
"""

import argparse
import json
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from book.experiments import stereo_sequences, street
from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.pictures import opencv
from slamlib.evaluation.comparison import compared
from slamlib.evaluation.trajectory import Trajectory, associate
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import ORIGIN, compose, inverse, relative
from slamlib.geometry.quaternion import exponential
from slamlib.manifolds import Array, Image, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.opening import stereo_run
from slamlib.vision.stereo import StereoFeatureExtractor, StereoSettings, VisualOdometry, motion_between
from slamlib.vision.stereo.fitting import triangulate

RUNS, SHARE = 6, 0.9
CORNERS, QUALITY, SPACING = 1000, 0.01, 8  # of Lucas-Kanade's tracks; the spacing in px
LEVELS, SIDE = 3, 15  # of its pyramids, and of its windows [px]
CLOSED = 1.0  # px: a circle ends at most so far from where it began
RATIO = 0.8  # of SIFT's best distance to the second (Lowe 2004)
ROWS, LEAST = 1.5, 1.0  # px: largest difference of the rows of a pair's points, and least disparity
REACH = 2.0  # px, of an inlier: that of slamlib's sample

Matches = tuple[Array, Array]  # (n, 3) [px]: of the old pair and of the new one
Motion = Callable[[Calibration, Array, Array], "Array | None"]


def ours(calibration: Calibration, pairs: Iterable[Image], **settings: Any) -> Iterator[Matches]:
    """slamlib's features, around the circle, in regions predicted from the step before."""
    odometry = VisualOdometry(StereoFeatureExtractor(calibration, StereoSettings(**settings)))
    for image in pairs:
        old = odometry.old
        odometry.step(image)
        if old is not None:
            yield old.values[odometry.pairs[:, 0]], odometry.matched


def lucas_kanade(calibration: Calibration, pairs: Iterable[Image]) -> Iterator[Matches]:
    """OpenCV's corners of the old left picture, tracked around the circle."""
    cv2 = opencv("to track")
    before: Image | None = None
    for image in pairs:
        if before is not None:
            start = cv2.goodFeaturesToTrack(before[0], CORNERS, QUALITY, SPACING)
            places, good = [start], np.ones(len(start), dtype=bool)
            for one, other in ((0, 1), (1, 3), (3, 2), (2, 0)):  # of the four pictures
                four = (*before, *image)
                there, found, _ = cv2.calcOpticalFlowPyrLK(
                    four[one], four[other], places[-1], None, winSize=(SIDE, SIDE), maxLevel=LEVELS
                )
                places.append(there)
                good &= found[:, 0] > 0
            left, right, new_right, new_left, back = (place[:, 0].astype(float) for place in places)
            good &= np.linalg.norm(back - left, axis=1) < CLOSED
            yield _measured(left, right, new_left, new_right, good)
        before = image


def sift(calibration: Calibration, pairs: Iterable[Image]) -> Iterator[Matches]:
    """SIFT, each match the other's best, and the circle of four of them closed."""
    cv2 = opencv("to find features")
    detector, matcher = cv2.SIFT_create(), cv2.BFMatcher()
    old: Any = None
    for image in pairs:
        found = [detector.detectAndCompute(picture, None) for picture in image]
        if old is not None:
            pictures = [old[0], old[1], found[1], found[0]]
            steps = [_nearest(matcher, a, b) for a, b in zip(pictures, pictures[1:] + pictures[:1], strict=True)]
            rows = [np.arange(len(old[0][0]))]
            for step in steps:
                rows.append(np.where(rows[-1] >= 0, step[rows[-1]], -1))
            closed = np.flatnonzero((rows[4] == rows[0]) & (np.array(rows).min(0) >= 0))
            left, right, new_right, new_left = (
                np.array([picture[0][i].pt for i in row[closed]]).reshape(-1, 2)
                for picture, row in zip(pictures, rows, strict=False)
            )
            yield _measured(left, right, new_left, new_right, np.ones(len(closed), dtype=bool))
        old = found


def _nearest(matcher: Any, one: Any, other: Any) -> Any:
    """Row (n + 1,) in the other picture of each keypoint's match, mutual and by Lowe's ratio; -1 for none."""
    back = {m.queryIdx: m.trainIdx for m in matcher.match(other[1], one[1])}
    rows = np.full(len(one[0]) + 1, -1)  # the last one: of no keypoint
    for best, second in matcher.knnMatch(one[1], other[1], k=2):
        if best.distance < RATIO * second.distance and back[best.trainIdx] == best.queryIdx:
            rows[best.queryIdx] = best.trainIdx
    return rows


def _measured(left: Array, right: Array, new_left: Array, new_right: Array, good: Mask) -> Matches:
    """Measurements (n, 3) of both pairs, of those that lie in one row, with a disparity."""
    for a, b in ((left, right), (new_left, new_right)):
        good = good & (np.abs(a[:, 1] - b[:, 1]) < ROWS) & (a[:, 0] - b[:, 0] > LEAST)
    old, new = (np.column_stack([a, a[:, 0] - b[:, 0]])[good] for a, b in ((left, right), (new_left, new_right)))
    return old, new


def most_likely(calibration: Calibration, old: Array, new: Array) -> Array | None:
    """slamlib's motion: the camera's new pose (7,) in its old frame."""
    found = motion_between(calibration, old, new)
    return None if found is None else found.pose


def pnp(calibration: Calibration, old: Array, new: Array) -> Array | None:
    """OpenCV's, as its documentation has it."""
    if len(old) < 8:
        return None
    u, v, au, av = calibration.given["intrinsics"]
    found, turn, shift, _ = opencv("to find a motion").solvePnPRansac(
        triangulate(calibration, old)[0], new[:, :2].copy(), np.array([[au, 0, u], [0, av, v], [0, 0, 1]]), None,
        reprojectionError=REACH, confidence=0.999, iterationsCount=200,
    )  # fmt: skip
    return inverse(np.concatenate([shift[:, 0], exponential(turn[:, 0])])) if found else None


FEATURES: dict[str, Callable[..., Iterator[Matches]]] = {
    "slamlib": ours,
    "slamlib, twice": partial(ours, **street.FEATURES),
    "Lucas-Kanade": lucas_kanade,
    "SIFT": sift,
}
MOTIONS: dict[str, Motion] = {"PnP": pnp, "slamlib": most_likely}


@dataclass(frozen=True)
class Sequence:
    """Pairs in memory, the calibration of their cameras, and the true path of the left one."""

    source: ImageSource
    camera: dict[str, Any]
    truth: Trajectory

    @property
    def calibration(self) -> Calibration:
        """As a run's filter has it, but for its pose."""
        run = stereo_run(self.source, self.camera, motion_source="odometry")
        return run.slam.sensors[0].calibration


def path_of(
    sequence: Sequence, motion: Motion, matches: list[Matches], calibration: Calibration, rng: np.random.Generator
) -> Trajectory:
    """The camera's poses by one motion after another, of a share of the matches; one not found repeats the last."""
    poses, step = [ORIGIN], ORIGIN
    for old, new in matches:
        kept = rng.random(len(old)) < SHARE
        found = motion(calibration, old[kept], new[kept])
        step = step if found is None else found
        poses.append(compose(poses[-1], step))
    path = Trajectory(np.array(sequence.source.times), np.array(poses))
    return path.sensor_trajectory(sequence.source.original)


def judged(path: Trajectory, sequence: Sequence) -> dict[str, float]:
    """KITTI's measure where the path has its parts; end: error of the last position, by the first pose, and length,
    both as shares of the true length; ATE [m]; RPE, from each pair to the next [m, degrees]."""
    i, j = associate(path, sequence.truth, 0.5 * sequence.source.interval)
    mine, true = path[i], sequence.truth[j]
    errors, _ = compared(path, sequence.truth, True)
    step, found = errors["rpe"], errors["parts"] or {}
    reached = [relative(poses[0], poses[-1])[:3] for poses in (mine.poses, true.poses)]
    return {
        "translation": found.get("translation_mean", np.nan),
        "rotation": found.get("rotation_mean", np.nan),
        "end": float(np.linalg.norm(reached[0] - reached[1]) / true.distances[-1]),
        "length": float(mine.distances[-1] / true.distances[-1]),
        "ate": errors["ate"],
        "rpe": step["position"]["rmse"],
        "turn": step["orientation"]["rmse"],
    }


def figures(sequence: Sequence) -> dict[str, Any]:
    """By features and motion: mean and standard deviation of each error; matches a pair; the processor's time a pair
    of features, and of a motion [ms]. The filter by defaults, and its time."""
    cv2, calibration, found = opencv("to compare"), sequence.calibration, {}
    cv2.setNumThreads(1)
    pairs = [picture.image for picture in sequence.source]
    for name, features in FEATURES.items():
        began = time.process_time()
        matches = list(progress(features(calibration, iter(pairs)), len(pairs) - 1, name))
        spent, rows = (time.process_time() - began) / len(matches), {}
        for called, motion in MOTIONS.items():
            began, rng = time.process_time(), np.random.default_rng(1)
            runs = [judged(path_of(sequence, motion, matches, calibration, rng), sequence) for _ in range(RUNS)]
            each = 1e3 * (time.process_time() - began) / len(matches) / RUNS
            means = {key: [float(f([run[key] for run in runs])) for f in (np.mean, np.std)] for key in runs[0]}
            rows[called] = {**means, "milliseconds": each}
        count = float(np.mean([len(old) for old, _ in matches]))
        found[name] = {"matches": count, "milliseconds": 1e3 * spent, "motions": rows}
    run = stereo_run(sequence.source, sequence.camera)
    began = time.process_time()
    street.finished("filter", run)
    spent = 1e3 * (time.process_time() - began) / len(run.history)
    path = judged(run.trajectory(), sequence)
    return {"parts": found, "filter": {**{key: [value, 0.0] for key, value in path.items()}, "milliseconds": spent}}


UNITS = {"translation": (100, "6.3f"), "rotation": (1, "7.4f"), "end": (100, "5.2f"), "length": (1, "6.4f"),
         "ate": (1e3, "6.1f"), "rpe": (1e3, "6.2f"), "turn": (1, "6.3f")}  # fmt: skip
HEADS = ("KITTI's, %", "deg/m", "end, %", "length", "ATE, mm", "RPE, mm", "RPE, deg")


def tables(found: dict[str, Any]) -> Iterator[str]:
    """As printed lines, of all sequences."""
    for name, row in found.items():
        yield f"\n{name:14} motion   matches " + "".join(f"{head:>16}" for head in HEADS) + "  pairs/s"
        for features, part in row["parts"].items():
            for motion, errors in part["motions"].items():
                spent = part["milliseconds"] + errors["milliseconds"] * (not features.startswith("slamlib"))
                yield f"{features:14} {motion:8} {part['matches']:7.0f} {_line(errors, spent)}"
        yield f"{'slamlib':14} filter           {_line(row['filter'], row['filter']['milliseconds'])}"


def _line(errors: dict[str, Any], spent: float) -> str:
    """Means and standard deviations, and pairs a second."""
    shown = (f"{f * errors[key][0]:{form}} +-{f * errors[key][1]:.1g}" for key, (f, form) in UNITS.items())
    return "".join(f"{one:>16}" for one in shown) + f"{1e3 / spent:9.1f}"


def at_hand(names: Iterable[str] = stereo_sequences.SEQUENCES) -> dict[str, Any]:
    """The figures of the named sequences, of those at hand."""
    known = {name: stereo_sequences.SEQUENCES[name] for name in names}
    return {name: figures(Sequence(*opened())) for name, (there, opened) in known.items() if there()}


def main() -> None:
    """Print the tables of the sequences at hand."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=stereo_sequences.SEQUENCES, action="append", help="these sequences alone")
    parser.add_argument("--json", action="store_true", help="print plain data")
    given = parser.parse_args()
    found = at_hand(given.only or stereo_sequences.SEQUENCES)
    if not found:
        print("no sequence is at hand: set SLAMLIB_DATA")
        return
    print(json.dumps(found, indent=2) if given.json else "\n".join(tables(found)))


if __name__ == "__main__":
    main()
