"""`make visual-odometry`: store chapter visual_odometry's longer runs as one file. Needs OpenCV.

Variants of the features in the rendered room and, where it is at hand, on an excerpt of KITTI's street (its licence
forbids shipping it; without it the stored figures stay). Half way round the room with plain odometry, and what it would
cost to keep every point that was seen.
"""

import time
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from slambook import kitti_street, stereo_films
from slambook.stereo_films import Tracks, stereo_film

from book.experiments import stored
from book.tools import layout
from slamlib.datasets.pictures import opencv
from slamlib.evaluation.comparison import parts
from slamlib.evaluation.trajectory import Trajectory
from slamlib.experiments.progress import progress
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array, Image
from slamlib.motions.odometry import ODOMETRY
from slamlib.observation.points import observe
from slamlib.sensors.sensor import Calibration
from slamlib.vision.stereo import StereoFeatureExtractor, StereoFeatures, StereoSettings, VisualOdometry, mutual_nearest
from slamlib.vision.stereo.detect import DETECTORS, Keypoints, spread
from slamlib.vision.stereo.features import hamming_distances, within_region

FILE = layout.BOOK / "chapters" / "data" / "visual_odometry.json"
SEEDS, FRAMES, ROUND, EVERY = (1, 2, 3), 120, 449, 8
STD = 0.035  # px, of the measurements in the room: the mean of z' S^-1 z by its degrees of freedom is near one
LENGTHS = (10.0, 20.0, 30.0, 40.0, 50.0)  # m, of KITTI's measure: the excerpt is 60 m long
OFFSET = 0.2  # px, of all disparities: with it the excerpt's own sum of z' S^-1 z is least
NEAR, FAR = 3.0, 25.0  # px: a match is right within this, and searched for within it where a prediction is used


def orb(image: Image, s: StereoSettings, levels: int) -> Keypoints:
    """ORB's own detector (FAST), with descriptors rotated by its angles; spread over the grid likewise."""
    cv2 = opencv("to find features")
    extractor = cv2.ORB_create(nfeatures=5000, nlevels=levels, edgeThreshold=s.border, fastThreshold=10)
    found = extractor.detect(image, None)
    pixels = np.array([k.pt for k in found]).reshape(-1, 2)
    strengths = np.array([k.response for k in found])
    rows = spread(pixels, strengths, image.shape[::-1], s.cells, s.per_cell)
    chosen, descriptors = extractor.compute(image, [found[i] for i in rows.tolist()])
    return Keypoints(
        np.array([k.pt for k in chosen], dtype=float).reshape(-1, 2),
        np.array([k.response for k in chosen]),
        np.zeros((0, 32), np.uint8) if descriptors is None else descriptors,
    )


DETECTORS |= {"orb": partial(orb, levels=1), "orb8": partial(orb, levels=8)}
VARIANTS = {
    "corners, upright, refined": StereoSettings(),
    "corners, upright": StereoSettings(patch=0),
    "ORB, one level, refined": StereoSettings(detector="orb"),
    "ORB, one level": StereoSettings(detector="orb", patch=0),
    "ORB, eight levels": StereoSettings(detector="orb8", patch=0),
}


@dataclass
class Counts:
    """Of each pair: features matched left to right, matched round the cycle, inliers; and how well noise fits."""

    stereo: list[int] = field(default_factory=list)
    circular: list[int] = field(default_factory=list)
    inliers: list[int] = field(default_factory=list)
    nis_per_dof: list[float] = field(default_factory=list)
    lost_frames: int = 0
    seconds: float = 0.0


def odometry(
    calibration: Calibration, extrinsics: Array, images: list[Array], start: Array, s: Any
) -> tuple[Array, Counts]:
    """The last pose of the robot (7,), and the counts."""
    extractor, counts, pose = StereoFeatureExtractor(calibration, s), Counts(), start
    motion_source = VisualOdometry(extractor, extrinsics)
    began = time.process_time()
    for i, (reached, motion) in enumerate(stereo_films.odometry(motion_source, images, start)):
        pose = reached
        counts.stereo.append(len(extractor.extract(images[i])))
        if i:
            counts.circular.append(len(motion_source.pairs))
        if motion is not None:
            counts.inliers.append(int(motion.inliers.sum()))
            counts.nis_per_dof.append(motion.nis_per_dof)
    counts.seconds = time.process_time() - began
    counts.lost_frames = len(images) - 1 - len(counts.inliers)
    return pose, counts


def variant(
    calibration: Calibration, extrinsics: Array, images: list[Array], truth: Array, settings: Any
) -> dict[str, Any]:
    """Counts of one kind of features, and the error of the last position as a share of the path [%]."""
    pose, c = odometry(calibration, extrinsics, images, truth[0], settings)
    path = np.linalg.norm(np.diff(truth[:, :3], axis=0), axis=1).sum()
    return {
        "stereo": round(float(np.mean(c.stereo))),
        "circular": round(float(np.mean(c.circular))),
        "inliers": round(float(np.mean(c.inliers))),
        "lost": c.lost_frames,
        "fit": round(float(np.mean(c.nis_per_dof)), 2),
        "off": round(100 * float(np.linalg.norm(pose[:3] - truth[-1, :3]) / path), 2),
    }


def room() -> dict[str, Any]:
    """All variants past the wall of the room."""
    rig, film, _ = stereo_film(FRAMES, "sideways", std=0.2)
    images = [frame.scans[0].image for frame, _ in film]
    truth = np.array([t.poses[0] for _, t in film])
    sensor = rig.sensors[0]
    return {n: variant(sensor.calibration, sensor.extrinsics, images, truth, s) for n, s in VARIANTS.items()}


def street() -> dict[str, Any] | None:
    """All variants on the street, and KITTI's measure of the first; None where it is not at hand."""
    if kitti_street.found() is None:
        return None
    calibration, images, truth = kitti_street.pairs()
    origin = np.array([0.0, 0, 0, 1, 0, 0, 0])
    return {
        "std": kitti_street.STD,
        "rows": {n: variant(calibration, origin, images, truth.poses, s) for n, s in VARIANTS.items()},
        "lengths": list(LENGTHS),
        "as told": measured(calibration, images, truth, 0.0),
        "offset": measured(calibration, images, truth, OFFSET),
    }


def measured(calibration: Calibration, images: list[Array], truth: Trajectory, offset: float) -> dict[str, Any]:
    """KITTI's measure [%, deg/m], the length by the true one, and z' S^-1 z by its dof; offset [px]: of disparities."""
    source = VisualOdometry(StereoFeatureExtractor(calibration, StereoSettings(offset=offset)))
    poses, motions = zip(*stereo_films.odometry(source, images, truth.poses[0]), strict=True)
    fits = [motion.nis_per_dof for motion in motions if motion is not None]
    path = Trajectory(truth.times, np.array(poses))
    off: Any = parts(path, truth, LENGTHS, step=5)
    return {
        "translation": np.round(100 * np.array(off["translation"]), 2).tolist(),
        "rotation": np.round(off["rotation"], 4).tolist(),
        "length": round(float(path.distances[-1] / truth.distances[-1]), 4),
        "fit": round(float(np.mean(fits)), 2),
    }


def around(seed: int, frames: int = ROUND) -> dict[str, Any]:
    """Half way round the room by plain odometry: every eighth position error and its standard deviation [m]."""
    rig, film, made = stereo_film(frames, "round", seed, STD)
    sensor = rig.sensors[0]
    truth = np.array([t.poses[0] for _, t in film])
    motion_source = VisualOdometry(StereoFeatureExtractor(sensor.calibration), sensor.extrinsics)
    pose, P, rows, fits, library, tracks = truth[0], np.zeros((6, 6)), [], [], Library(sensor, made), Tracks()
    for number, (frame, there) in enumerate(film):
        motion = motion_source.step(frame.scans[0].image)
        if motion is not None:
            pose, J = ODOMETRY.step.jac(pose, motion.control.value, 0.0)
            P = J.state @ P @ J.state.T + J.control @ motion.control.covariance @ J.control.T
            fits.append(motion.nis_per_dof)
        rows.append([np.linalg.norm(pose[:3] - truth[number, :3]), np.sqrt(np.trace(P[:3, :3]))])
        seen = motion_source.extractor.extract(frame.scans[0].image)
        tracks.step(len(seen), motion_source.pairs)
        library.add(seen, tracks, there)
    return {
        "path": round(float(np.linalg.norm(np.diff(truth[:, :3], axis=0), axis=1).sum()), 3),
        "fit": round(float(np.mean(fits)), 2),
        "rows": np.round(np.array(rows)[::EVERY], 5).tolist(),
        "ages": np.bincount(np.array(list(library.longest.values()))).tolist(),
        "library": library.rows,
    }


class Library:
    """Every feature that was ever seen, with its descriptor and its true position: what matching against all costs.

    What is near a prediction is predicted from the true pose and position: the best that a filter could do.
    """

    def __init__(self, sensor: Any, made: Any) -> None:
        self.sensor, self.made = sensor, made
        self.bits, self.places = np.zeros((0, 32), np.uint8), np.zeros((0, 3))
        self.longest: dict[int, int] = {}
        self.known: set[int] = set()
        self.rows: list[list[int]] = []
        self.frames = 0

    def add(self, seen: StereoFeatures, tracks: Any, truth: Any) -> None:
        """Match the features of a pair against all that is kept; then keep those that are new."""
        if self.frames % 64 == 0 and self.frames:
            self.rows.append(self.tried(seen, truth))
        fresh = np.array([i not in self.known for i in tracks.ids.tolist()], dtype=bool)
        self.known.update(tracks.ids.tolist())
        self.longest.update(zip(tracks.ids.tolist(), tracks.ages.tolist(), strict=True))
        self.bits = np.concatenate([self.bits, seen.descriptors(0)[fresh]])
        self.places = np.concatenate([self.places, self.made.truth_of(truth, seen.values[fresh, :2])])
        self.frames += 1

    def tried(self, seen: StereoFeatures, truth: Any) -> list[int]:
        """Points kept, features seen; matches and wrong ones among all; comparisons, matches, wrong ones near."""
        cost = hamming_distances(self.bits, seen.descriptors(0))
        expected = observe(EUC_POINT, self.sensor.calibration, truth.poses[0], self.sensor.extrinsics, self.places)
        pixels = np.where(expected.visible[:, None], expected.value, np.nan)
        there = within_region(pixels, seen.values, FAR)
        near = np.where(there, cost, np.inf)
        judged = [self.judged(c, pixels, seen) for c in (cost, near)]
        return [len(self.bits), len(seen), *judged[0], int(there.sum()), *judged[1]]

    def judged(self, cost: Array, pixels: Array, seen: StereoFeatures) -> list[int]:
        """Matches, and how many of them are wrong."""
        found = mutual_nearest(cost, largest=60, ratio=0.85)
        off = np.abs(pixels[found[:, 0], :2] - seen.values[found[:, 1], :2]).max(1, initial=0)
        return [len(found), int((~(off <= NEAR)).sum())]


PARTS = {
    "frames": lambda: FRAMES,
    "room": room,
    "street": street,
    "every": lambda: EVERY,
    "round": lambda: [around(seed) for seed in progress(SEEDS, len(SEEDS), "round the room")],
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
