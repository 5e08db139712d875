"""Motion between two pairs: the control of slamlib.motions.ODOMETRY, with its covariance. Chapter visual_odometry."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.geometry.pose import ORIGIN, compose, inverse
from slamlib.geometry.quaternion import exponential, logarithm, plus
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array, Image, Indices, Mask
from slamlib.observation.points import observe
from slamlib.plain_data.fields import unpacked, written
from slamlib.records.inputs import Control
from slamlib.sensors.sensor import Calibration
from slamlib.vision.stereo.features import StereoFeatureExtractor, StereoFeatures, track_features, within_region
from slamlib.vision.stereo.fitting import Fit, fit, triangulate

MIN_MATCHES = 8  # least number of matches for a motion
INLIER_THRESHOLD = 2.0  # px, largest reprojection error of an inlier of a sample's motion


@dataclass(frozen=True, eq=False)
class RelativeMotion:
    """From the old pair to the new one. inliers (n,): mask of the matches; nis_per_dof: the mean of e' S^-1 e per
    degree of freedom, 1 if the noise of the calibration is that of the measurements."""

    control: Control
    inliers: Mask
    nis_per_dof: float

    @property
    def pose(self) -> Array:
        """The robot's new pose (7,) in its old frame."""
        return np.concatenate([self.control.value[:3], exponential(self.control.value[3:])])


def motion_between(
    calibration: Calibration, old: Array, new: Array, extrinsics: Array = ORIGIN
) -> RelativeMotion | None:
    """The robot's motion between measurements (n, 3) [px] of the same points, old and new; None if none is found.

    extrinsics (7,): the sensor's pose on the robot. The covariance follows from the given noise: nis_per_dof tests
    whether that is consistent.
    """
    if len(old) < MIN_MATCHES:
        return None
    sampled = ransac_pose(calibration, old, new)
    if sampled is None:
        return None
    camera, inliers = sampled
    start = compose(compose(extrinsics, camera), inverse(extrinsics))
    found = fit(calibration, extrinsics, old, new, start, inliers)
    if found is None or found.inliers.sum() < MIN_MATCHES:
        return None
    return RelativeMotion(as_control(found), found.inliers, found.squares / max(3 * found.inliers.sum() - 6, 1))


def ransac_pose(calibration: Calibration, old: Array, new: Array) -> tuple[Array, Mask] | None:
    """The camera's new pose (7,) in its old frame, and the mask (n,) of the inliers: PnP with RANSAC.

    OpenCV's solution takes points of the *old* camera's frame to the new one's, p_new = R p_old + t. The motion of the
    camera is its inverse: when it moves forwards, points come nearer. The report confuses the two (E20).
    """
    cv2 = opencv("to find the motion between two pairs")
    points, _ = triangulate(calibration, old)
    u0, v0, au, av = calibration.given["intrinsics"]
    matrix = np.array([[au, 0, u0], [0, av, v0], [0, 0, 1]])
    how = {"reprojectionError": INLIER_THRESHOLD, "confidence": 0.999, "flags": cv2.SOLVEPNP_EPNP}
    found, turn, shift, rows = cv2.solvePnPRansac(points, new[:, :2].copy(), matrix, None, iterationsCount=200, **how)
    if not found or rows is None or len(rows) < MIN_MATCHES:
        return None
    inliers = np.zeros(len(old), dtype=bool)
    inliers[rows[:, 0]] = True
    return inverse(np.concatenate([shift[:, 0], exponential(turn[:, 0])])), inliers


def as_control(found: Fit) -> Control:
    """Displacement and rotation vector, both in the robot's old frame, of a pose with its covariance (6, 6)."""
    T = control_axes(found.pose)
    P = T @ found.covariance @ T.T
    return Control(np.concatenate([found.pose[:3], logarithm(found.pose[3:])]), (P + P.T) / 2)


def control_axes(pose: Array) -> Array:
    """Jacobian (6, 6) of the control w.r.t. a small step (6,) of its pose (7,)."""
    _, J = logarithm.jac(pose[3:])
    _, by = plus.jac(pose[3:], np.zeros(3))
    T = np.eye(6)
    T[3:, 3:] = J.q @ by.step  # the pose's last three numbers turn about its own axes
    return T


class VisualOdometry:
    """One motion for each pair after the first, from matches around the cycle. half: 0 or 1 uses half of the image.

    Motion and update of a filter must not use the same measurements (E21): each has its own half of the image, as
    squares of a chess board (`split-features`).

    After a step: pairs (k, 2) of old and new features, and matched (k, 3), their new values [px].
    """

    def __init__(self, extractor: StereoFeatureExtractor, extrinsics: Array = ORIGIN, half: int | None = None) -> None:
        self.extractor, self.extrinsics, self.half = extractor, extrinsics, half
        self.old: StereoFeatures | None = None
        self.last: Array | None = None
        self.pairs: Indices = np.zeros((0, 2), dtype=int)
        self.matched: Array = np.zeros((0, 3))

    def step(self, image: Image | None, predicted: Array | None = None) -> RelativeMotion | None:
        """The motion to this pair (2, h, w) from the one before; None for the first, and where none is found.

        predicted (7,): the robot's new pose in its old frame, for the regions of matches; the default is that of the
        step before, and where there was none, the whole image.
        """
        old, new = self.old, self.extractor.extract(image)
        self.old = new
        if old is None:
            return None
        guess = self.last if predicted is None else predicted
        self.pairs, self.matched = track_features(old, new, self.extractor.settings, self.regions(old, new, guess))
        if self.half is not None:
            in_half = checkerboard_half(old.values[self.pairs[:, 0]]) == self.half
            in_half &= checkerboard_half(self.matched) == self.half
            self.pairs, self.matched = self.pairs[in_half], self.matched[in_half]
        before = old.values[self.pairs[:, 0]]
        found = motion_between(self.extractor.calibration, before, self.matched, self.extrinsics)
        self.last = None if found is None else found.pose
        return found

    def regions(self, old: StereoFeatures, new: StereoFeatures, predicted: Array | None) -> Mask | None:
        """Mask (n, m) of the features that may match if the robot has moved as predicted; None: all."""
        if predicted is None:
            return None
        calibration = self.extractor.calibration
        points, _ = triangulate(calibration, old.values, self.extrinsics)
        seen = observe(EUC_POINT, calibration, predicted, self.extrinsics, points)
        expected = np.where(seen.visible[:, None], seen.value, np.nan)
        return within_region(expected, new.values, self.extractor.settings.region)

    def dump(self) -> Any:
        """The last pair, packed, and the motion to it, as plain data."""
        return {"pair": None if self.old is None else written(self.old.image), "last": written(self.last)}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned: the next step is the same."""
        self.old = None if state["pair"] is None else self.extractor.extract(unpacked(state["pair"]))
        self.last = None if state["last"] is None else unpacked(state["last"])


CHECKERBOARD_SQUARE = 64  # px


def checkerboard_half(values: Array) -> Array:
    """0 or 1 (n,), by the square of a chess board over the image that each measurement (n, .) lies in."""
    return np.floor(values[:, :2] / CHECKERBOARD_SQUARE).astype(int).sum(1) % 2
