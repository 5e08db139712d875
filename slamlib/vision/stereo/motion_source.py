"""The source of a stereo filter's predictions, without counting a measurement twice (E21). Chapter stereo_ekf_slam."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slamlib.manifolds import Array, Image, Mask
from slamlib.plain_data.fields import read, written
from slamlib.records.inputs import Control
from slamlib.rigs.setup import Rig
from slamlib.sensors.sensor import Calibration
from slamlib.slam.filter import Slam
from slamlib.vision.image_front_end import MotionSource, Stopwatch
from slamlib.vision.results import NEAR
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import StereoFeatures
from slamlib.vision.stereo.fitting import fit
from slamlib.vision.stereo.odometry import MIN_MATCHES, RelativeMotion, VisualOdometry, as_control
from slamlib.vision.stereo.stereo_search import StereoSearch

UNINFORMATIVE = 1e4  # factor of a covariance that makes a control uninformative
NEAR_SIGMAS = 3.5  # standard deviations: a feature so near to a predicted landmark may be that landmark
SLACK = 2.0  # px, largest distance of a detected feature from its landmark
RESERVED_PER_LANDMARK = 2  # strongest features per new landmark that are left for initializations
UNKNOWN = (1.0, 0.3)  # [m], [rad]: standard deviations of a step without any known before
NEWEST_SHARE = 0.2  # weight of the newest change in the mean of their squares
INFLATION = 9.0  # factor of the variances: a motion is lost where it changes more than usual


class StereoMotionSource(MotionSource):
    """Base of the motion sources of stereo pairs; it gives no control: the robot keeps its velocities.

    motion: motion model of the robot. found: the odometry's motion to the present pair, or None. landmark_half: half of
    the image in which landmarks are measured; None: all of it. variance: factor of the measurements' variances.
    """

    motion, variance = "constVel", 1.0
    landmark_half: int | None = None
    front_end: StereoSearch

    def __init__(self, calibration: Calibration, extrinsics: Array, settings: StereoSettings | None = None) -> None:
        super().__init__(StereoSearch(calibration, settings, half=self.landmark_half))
        self.found: RelativeMotion | None = None
        self.seconds = Stopwatch("odometry")

    @classmethod
    def inflated(cls, rig: Rig) -> Rig:
        """The rig with the variances that this source wants its one sensor's measurements to have."""
        noise = cls.variance * rig.sensors[0].calibration.noise
        return replace(rig, sensors=(replace(rig.sensors[0], noise=tuple(map(tuple, noise.tolist()))),))

    def counts(self, slam: Slam) -> dict[str, float]:
        """Near points among the inliers."""
        return {"near": self.near([p.measured for p in slam.predictions[0] if p.inlier])}

    def near(self, values: Sequence[Array] | Array) -> int:
        """How many of these measurements (u, v, disparity) are of points nearer than NEAR baselines."""
        limit = self.front_end.calibration.given["intrinsics"][2] / NEAR
        return sum(float(value[2]) > limit for value in values)


@dataclass
class MotionFallback:
    """The control of a step whose odometry failed: the last one, with a large covariance.

    Estimates how controls (6,) change from step to step, separately for displacement [m] and rotation [rad]. rate: the
    last control, per second; changes (2,): mean squared changes of one coordinate of it; lost: failures in a row.
    """

    rate: Array | None = None
    changes: Array | None = None
    lost: int = 0

    def record(self, control: Control, dt: float) -> None:
        """Record the control of a step of dt [s]."""
        rate = control.value / dt
        if self.rate is not None:
            square = ((rate - self.rate) ** 2).reshape(2, 3).mean(1)
            before = square if self.changes is None else self.changes
            self.changes = before + NEWEST_SHARE * (square - before)
        self.rate, self.lost = rate, 0

    def extrapolate(self, dt: float) -> Control:
        """The last rate over dt [s]; a random walk of the rate: its covariance grows with the steps lost in a row."""
        self.lost += 1
        if self.rate is None:
            return Control(np.zeros(6), np.repeat(np.square(UNKNOWN), 3))
        example = np.square(self.rate).reshape(2, 3).mean(1) if self.changes is None else self.changes
        return Control(self.rate * dt, np.repeat(INFLATION * self.lost * example * dt**2, 3))


class SplitFeatures(StereoMotionSource):
    """Odometry in the squares of one colour of a chess board over the image, landmarks in those of the other."""

    name, motion = "split-features", "odometry"
    odometry_half: int | None = 0
    landmark_half: int | None = 1

    def __init__(self, calibration: Calibration, extrinsics: Array, settings: StereoSettings | None = None) -> None:
        super().__init__(calibration, extrinsics, settings)
        self.odometry = VisualOdometry(self.front_end.extractor, extrinsics, half=self.odometry_half)
        self.fallback = MotionFallback()

    def control(self, image: Image | None, dt: float, slam: Slam) -> Control:
        """The odometry's; zeros for the first pair; where none is found, the last one with a large covariance."""
        with self.seconds.timed("odometry"):
            self.front_end.reserved = np.zeros(0, dtype=int)
            old = self.odometry.old
            self.found = self.odometry.step(image)
            if old is None:
                return Control(np.zeros(6), np.zeros((6, 6)))
            if self.found is None:
                return self.fallback.extrapolate(dt)
            self.fallback.record(self.found.control, dt)
            return self.filter_control(old, self.odometry.extractor.extract(image), self.found, slam)

    def filter_control(self, old: StereoFeatures, new: StereoFeatures, found: RelativeMotion, slam: Slam) -> Control:
        """The filter's control, of a motion found between two pairs."""
        return found.control

    def dump(self) -> Any:
        """The odometry's state, with the last pair, and how motions change."""
        return {"odometry": self.odometry.dump(), "fallback": written(self.fallback)}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        self.odometry.restore(state["odometry"])
        self.fallback = read(MotionFallback, state["fallback"])


class CovarianceIntersection(SplitFeatures):
    """All features for both; the doubled variances of `inflated` bound any cross-correlation. Eq. (se-intersection)."""

    name, variance = "covariance-intersection", 2.0
    odometry_half = landmark_half = None


class CorrelatedFeatures(SplitFeatures):
    """All features for both, their cross-correlation modelled: started at the motion of all of them, the control is
    that of those that do not update the map, as the others tell nothing more (slamlib.tests.shared_noise has the
    proof). A feature reserved for the control is no landmark's measurement, and initializes none.
    """

    name = "correlated"
    odometry_half = landmark_half = None

    def filter_control(self, old: StereoFeatures, new: StereoFeatures, found: RelativeMotion, slam: Slam) -> Control:
        """The motion of unmapped features, starting from that of all; if too few, the latter, uninformative."""
        in_half = self.unmapped(new, found, slam) & found.inliers
        pairs, values = self.odometry.pairs, self.odometry.matched
        extractor, extrinsics = self.odometry.extractor, self.odometry.extrinsics
        own = fit(extractor.calibration, extrinsics, old.values[pairs[:, 0]], values, found.pose, in_half)
        if own is None or own.inliers.sum() < MIN_MATCHES:
            return replace(found.control, covariance=UNINFORMATIVE * found.control.covariance)
        self.front_end.reserved = pairs[in_half, 1]
        return as_control(own)

    def unmapped(self, new: StereoFeatures, found: RelativeMotion, slam: Slam) -> Mask:
        """Mask (k,) of the matches that are no landmark's measurement, and will initialize none."""
        pairs, values = self.odometry.pairs, self.odometry.matched
        front_end = self.front_end
        mask = ~np.isin(pairs[:, 0], [*front_end.found.values(), *front_end.initialized])
        frame = front_end.frame + 1
        due = [p for p in slam.project(motion=found.pose) if front_end.is_due(p.landmark, frame)]
        if due:
            expected = np.array([prediction.value[:2] for prediction in due])
            spread = np.array([np.sqrt(np.diag(prediction.S)[:2]) for prediction in due])
            reach = SLACK + NEAR_SIGMAS * spread
            mask &= ~(np.abs(values[:, None, :2] - expected) <= reach).all(-1).any(1)
        rows, strengths = np.flatnonzero(mask), new.strengths[pairs[mask, 1]]
        mask[rows[np.argsort(-strengths, kind="stable")[: RESERVED_PER_LANDMARK * slam.options.max_new]]] = False
        return mask


class OdometryOnly(SplitFeatures):
    """Plain odometry of all features, for a filter without landmarks.

    searched are the features matched from left to right, matched those that were matched around the cycle, inliers
    those consistent with the motion; nis is the sum of their squares.
    """

    name = "odometry"
    odometry_half = None

    def counts(self, slam: Slam) -> dict[str, float]:
        """Numbers of features, instead of landmarks."""
        inliers = 0 if self.found is None else int(self.found.inliers.sum())
        near = 0 if self.found is None else self.near(self.odometry.matched[self.found.inliers])
        dof = max(3 * inliers - 6, 0)
        return {
            "searched": 0 if self.odometry.old is None else len(self.odometry.old),
            "matched": len(self.odometry.pairs),
            "inliers": inliers,
            "nis": 0.0 if self.found is None else self.found.nis_per_dof * dof,
            "nis_dof": dof,
            "near": near,
        }


MOTION_SOURCES: dict[str, type[StereoMotionSource]] = {
    "constant-velocity": StereoMotionSource,
    "covariance-intersection": CovarianceIntersection,
    "split-features": SplitFeatures,
    "correlated": CorrelatedFeatures,
}
