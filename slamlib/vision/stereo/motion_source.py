"""Where the prediction of a stereo filter comes from, without using a measurement twice (E21). Chapter 22.

"velocity": the robot keeps its velocities, and all features correct. "halves": those in one half of the picture give
the control, those in the other one correct. "correlated": all features do both, and their cross-correlation is
modelled. That needs no more than this (slamlib.tests.shared_noise has the proof): a control of features that
correct as well tells nothing new, so that only the others, strangers, say how well it is known; all together say where
to linearize. A stranger of this pair is no landmark's measurement, and begins none, in this pair.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from slamlib.data.records import Control
from slamlib.manifolds import Array, Image, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.slam.measurement_update import looks_from
from slamlib.vision.stereo.features import Eyes, Observed
from slamlib.vision.stereo.fitting import fit
from slamlib.vision.stereo.front_end import StereoSearch
from slamlib.vision.stereo.motion_fallback import Steady
from slamlib.vision.stereo.odometry import FEWEST, Motion, VisualOdometry, as_control
from slamlib.vision.stereo.settings import StereoSettings

HARDLY = 1e4  # times its covariance, a control tells nothing that its measurements do not tell as well
NEARNESS = 3.5  # standard deviations: a feature so near to where a landmark is expected may be that landmark
SLACK = 2.0  # px, by which what is detected may lie beside the landmark that it shows
RESERVED = 2  # of the strongest features, so many for each landmark that may be begun are left to begin it


class Moving(Protocol):
    """Gives each pair's control; a filter of the robot's motion `motion` takes `front_end` for its stereo sensor.

    found: the odometry's motion to the present pair, or None where there is none.
    """

    motion: str
    front_end: StereoSearch
    found: Motion | None

    def control(self, image: Image, dt: float, slam: Any) -> Control | None:
        """Of the step of dt [s] to this pair (2, h, w), to be asked once, before slam.step; None: the robot's own."""

    def dump(self) -> Any:
        """Its state as plain data, beside that of the front end, which the filter's file holds."""

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""


class Velocity:
    """Nobody tells anything: the robot's own noise says how its velocities may change."""

    motion = "constVel"
    found: Motion | None = None

    def __init__(self, calibration: Calibration, mount: Array, settings: StereoSettings | None = None) -> None:
        self.front_end = StereoSearch(calibration, settings)

    def control(self, image: Image, dt: float, slam: Any) -> Control | None:
        """None: what is not told is drawn with the noise of the robot's setup."""
        return None

    def dump(self) -> Any:
        """It has no state."""

    def restore(self, state: Any) -> None:
        """It has no state."""


class Halves:
    """Odometry in the squares of one colour of a chess board over the picture, landmarks in those of the other."""

    motion = "odometry"
    odometry_half: int | None = 0
    landmark_half: int | None = 1

    def __init__(self, calibration: Calibration, mount: Array, settings: StereoSettings | None = None) -> None:
        eyes = Eyes(calibration, settings)
        self.odometry = VisualOdometry(eyes, mount, half=self.odometry_half)
        self.front_end = StereoSearch(calibration, eyes=eyes, half=self.landmark_half)
        self.steady = Steady()
        self.found: Motion | None = None

    def control(self, image: Image, dt: float, slam: Any) -> Control | None:
        """The odometry's; zeros for the first pair; where none is found, the last one with a large covariance."""
        old = self.odometry.old
        self.found = self.odometry.step(image)
        if old is None:
            return Control(np.zeros(6), np.zeros((6, 6)))
        if self.found is None:
            return self.steady.untold(dt)
        self.steady.told(self.found.control, dt)
        return self.told(old, self.odometry.eyes.look(image), self.found, slam)

    def told(self, old: Observed, new: Observed, found: Motion, slam: Any) -> Control:
        """What the filter is told of a motion that was found between two pairs."""
        return found.control

    def dump(self) -> Any:
        """The odometry's state, with the last pair, and how motions change."""
        return {"odometry": self.odometry.dump(), "steady": self.steady.dump()}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        self.odometry.restore(state["odometry"])
        self.steady.restore(state["steady"])


class Correlated(Halves):
    """All features for both: the control of the strangers, linearized where all features say that the robot is."""

    odometry_half = landmark_half = None

    def control(self, image: Image, dt: float, slam: Any) -> Control | None:
        """As of halves, of the strangers."""
        self.front_end.others = np.zeros(0, dtype=int)
        return super().control(image, dt, slam)

    def told(self, old: Observed, new: Observed, found: Motion, slam: Any) -> Control:
        """The motion of the strangers, from all features' motion on; if they are too few, the latter, hardly known."""
        mine = self.strangers(new, found, slam) & found.inliers
        pairs, values = self.odometry.pairs, self.odometry.matched
        eyes, mount = self.odometry.eyes, self.odometry.mount
        own = fit(eyes.calibration, mount, old.values[pairs[:, 0]], values, found.pose, mine)
        if own is None or own.inliers.sum() < FEWEST:
            return replace(found.control, covariance=HARDLY * found.control.covariance)
        self.front_end.others = pairs[mine, 1]
        return as_control(own)

    def strangers(self, new: Observed, found: Motion, slam: Any) -> Mask:
        """Mask (k,) of the matches that show no landmark, and will begin none."""
        pairs, values = self.odometry.pairs, self.odometry.matched
        front_end = self.front_end
        mask = ~np.isin(pairs[:, 0], [*front_end.found.values(), *front_end.begun])
        frame = front_end.frame + 1
        looks = [look for look in looks_from(slam, found.pose) if front_end.has_turn(look.landmark, frame)]
        if looks:
            expected = np.array([look.value[:2] for look in looks])
            spread = np.array([np.sqrt(np.diag(look.Z)[:2]) for look in looks])
            reach = SLACK + NEARNESS * spread
            mask &= ~(np.abs(values[:, None, :2] - expected) <= reach).all(-1).any(1)
        rows, strengths = np.flatnonzero(mask), new.strengths[pairs[mask, 1]]
        mask[rows[np.argsort(-strengths, kind="stable")[: RESERVED * slam.options.later]]] = False
        return mask

    def dump(self) -> Any:
        """Beside that of halves: which features of the last pair showed landmarks, and which began some."""
        return {**super().dump(), "shown": self.front_end.found, "begun": self.front_end.begun}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        super().restore(state)
        self.front_end.found = {int(number): row for number, row in state["shown"].items()}
        self.front_end.begun = state["begun"]


MOVING: dict[str, Callable[..., Moving]] = {"velocity": Velocity, "halves": Halves, "correlated": Correlated}
