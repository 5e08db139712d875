"""The filter on a sequence of images, one at a time, with a history; it can be saved and resumed at each of them.

Runs on single images and on stereo pairs differ by a SequenceKind and a MotionSource only; both, and loading, are in
slamlib.vision.opening. A stereo pair is one image (2, h, w).
"""

import time
import zlib
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.pictures import TimedImage
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory
from slamlib.observation.family import viewpoint
from slamlib.records.inputs import Control, Frame, Scan
from slamlib.records.snapshots import Snapshot
from slamlib.slam import Options, Slam, StepReport
from slamlib.vision.image_front_end import MotionSource
from slamlib.vision.relocalization import LOST, close_loop, relocalize
from slamlib.vision.results import COLUMNS, ImageResult, Whitened, counts, lasting, whitened
from slamlib.vision.target import Target
from slamlib.vision.tracking_loss import TrackingLoss, TrackingLostError

TIME, LANDMARKS, INLIERS = (COLUMNS.index(name) for name in ("time", "landmarks", "inliers"))
SAME_TIME = 1e-3  # of the interval
PLAIN = ("history", "path", "covariances", "patience", "metric", "relocalizes")  # what a run keeps as plain data


@dataclass(frozen=True)
class SequenceKind:
    """What distinguishes runs on single images from those on stereo pairs.

    name: of the run in a file; item: what one of its images is called; causes: of a tracking loss, with landmarks in
    the map and without. source(sensor, options, name, settings): the MotionSource of a saved run. The others are the
    defaults of a run: options, standard deviations of the changes of velocity [m/s, deg/s] from one image to the next
    (impulse), of the velocities at the start, and of a measurement [px] (noise).
    """

    name: str
    item: str
    causes: tuple[str, str]
    source: Callable[..., MotionSource]
    options: Options
    impulse: tuple[float, float]
    velocity: tuple[float, float]
    noise: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class ImageStep:
    """One processed image: the frame as the filter took it, its report, and the run's row of numbers by name."""

    frame: Frame
    picture: TimedImage
    report: StepReport
    row: dict[str, float]


class SequenceRun:
    """A run in progress. Iterate over it; `save` between two steps, slamlib.vision.opening.load resumes it exactly."""

    def __init__(
        self,
        source: ImageSource,
        slam: Slam,
        motion: MotionSource,
        kind: SequenceKind,
        *,
        patience: int = 30,
        metric: bool = True,
        target: Target | None = None,
    ) -> None:
        """slam: with the motion source's front end. patience: frames without a match, after which the run stops.

        metric: whether the scale is known. target: seen in the first image.
        """
        self.source, self.slam, self.motion, self.kind = source, slam, motion, kind
        self.patience, self.metric, self.target = patience, metric, target
        self.relocalizes = False  # whether a lost camera is sought, and loops closed
        self.history: list[list[float]] = []
        self.path: list[list[float]] = []
        self.covariances: list[list[list[float]]] = []
        self.tracking_loss = TrackingLoss()
        self.innovations: Whitened = {}
        self.is_intact = True  # False while a frame is being processed
        self.picture: TimedImage | None = None  # the last one processed

    def __len__(self) -> int:
        """Number of remaining images."""
        return len(self.source) - len(self.history)

    @property
    def done(self) -> int:
        """Number of images processed."""
        return len(self.history)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the numbers in a row of the history."""
        return (*COLUMNS, *self.motion.seconds)

    @property
    def has_map(self) -> bool:
        """Whether the filter has a map; odometry alone has none."""
        return bool(self.slam.options.points or self.slam.options.lines)

    def __iter__(self) -> Iterator[ImageStep]:
        """Process the remaining images. Raises TrackingLostError, and SlamlibError for an unreadable one."""
        if not len(self):
            return
        began = time.perf_counter()
        for picture in self.source.part(len(self.history)):
            yield self._step(picture, time.perf_counter() - began)
            if len(self) and self.tracking_loss.frames >= self.patience:
                raise TrackingLostError(
                    f"lost: {self.tracking_loss.frames} {self.kind.item}s in a row without a match, from frame "
                    f"{self.tracking_loss.first} on; {self.kind.causes[not self.slam.landmarks]} Resume with more "
                    f"patience, or start again at a later {self.kind.item}"
                )
            began = time.perf_counter()

    def _step(self, picture: TimedImage, reading: float) -> ImageStep:
        frame = self._frame(picture)
        elapsed = picture.time - self.history[-1][TIME] if self.history else 0.0
        self.is_intact = False
        began, clocks = time.perf_counter(), self._seconds_spent()
        frame, report = self._process(frame, elapsed)
        inside = {name: after - clocks[name] for name, after in self._seconds_spent().items()}
        spent = time.perf_counter() - began
        before, self.innovations = self.innovations, whitened(self.slam)
        row = {"time": picture.time, **counts(self.slam, report), **lasting(self.innovations, before)}
        row |= {**self.motion.counts(self.slam), "reading": reading, **inside, "filter": spent - sum(inside.values())}
        self.history.append([row[name] for name in self.columns])
        camera = self.slam.sensors[0]
        J, rows = viewpoint(camera).jacobian, camera.columns
        self.path.append(camera.camera.tolist())
        self.covariances.append((J @ self.slam.belief.matrix[np.ix_(rows, rows)] @ J.T).tolist())
        inliers = [prediction.landmark.first_seen for prediction in self.slam.predictions[0] if prediction.inlier]
        births = inliers if self.has_map else [0] * int(row["inliers"])
        self.tracking_loss.update(frame.number, births, len(self.slam.landmarks))
        self.picture = picture
        self.is_intact = True
        return ImageStep(frame, picture, report, row)

    def _frame(self, picture: TimedImage) -> Frame:
        """A frame of the image, with a control of zeros. Raises SlamlibError for a wrong size, with no side effects."""
        calibration, robot = self.slam.sensors[0].calibration, self.slam.robots[0]
        *_, height, width = picture.image.shape
        if calibration.image is not None and tuple(calibration.image) != (width, height):
            known = "{:g}x{:g}".format(*calibration.image)
            raise SlamlibError(f"{picture.name} is {width}x{height}, and the calibration is of {known} pixels")
        dt = picture.time - self.history[-1][TIME] if self._can_move() else 0.0
        control = Control(np.zeros(robot.motion.control), robot.noise * (dt / self.source.interval))
        return Frame(len(self.history) + 1, dt, (control,), (Scan(image=picture.image),))

    def _can_move(self) -> bool:
        """Whether there is a measurement already: the first landmarks are initialized from the known start."""
        return any(row[LANDMARKS] for row in self.history) if self.has_map else bool(self.history)

    def _process(self, frame: Frame, elapsed: float) -> tuple[Frame, StepReport]:
        """The frame as the filter took it, and its report; an empty map gets as many landmarks as a first frame."""
        control = self.motion.control(image := frame.scans[0].image, elapsed, self.slam)
        told = control is not None and self._can_move()
        is_lost = self.relocalizes and self._can_move() and self.history[-1][INLIERS] <= LOST
        if is_lost and relocalize(self.slam, image):
            frame = replace(frame, dt=0.0)  # its pose is that of this image: there is nothing to predict
        else:
            frame = replace(frame, controls=(control,)) if told else self._predict_missing(frame)
        is_target = self.target is not None and not self.history
        if self.target is not None and is_target:  # its pixels are used by this update: it is not searched for again
            self.target.put(self.slam, frame.scans[0])
        report = self.slam.step(frame, update=not is_target, first=not self.slam.landmarks)
        if self.relocalizes:
            close_loop(self.slam, image)
        return frame, report

    def _predict_missing(self, frame: Frame) -> Frame:
        """Predict over images missing before a frame, one interval at a time; return the frame of the last interval.

        An impulse acts in each interval of the source: in one long step all of them would act at its end, and have no
        effect on the position. frame: the covariance of its control is that of its whole time.
        """
        steps = round(frame.dt / self.source.interval)
        if steps < 2:
            return frame
        (control,) = frame.controls
        assert control is not None
        share = replace(control, covariance=control.covariance / steps)
        for _ in range(steps - 1):
            self.slam.predict((share,), frame.dt / steps)
        return replace(frame, dt=frame.dt / steps, controls=(share,))

    def _seconds_spent(self) -> dict[str, float]:
        """Seconds spent so far, by part."""
        inside = getattr(self.slam.front_ends[0], "seconds", {})
        return {"search": 0.0, "detection": 0.0, **inside, **self.motion.seconds}

    def snapshot(self) -> Snapshot:
        """The filter's snapshot for display: of a pair, the left image."""
        shown = self.slam.snapshot()
        scans = [
            s if s is None or s.image is None or s.image.ndim == 2 else replace(s, image=s.image[0])
            for s in (view.scan for view in shown.sensors)
        ]
        return replace(shown, sensors=tuple(replace(v, scan=s) for v, s in zip(shown.sensors, scans, strict=True)))

    def trajectory(self) -> Trajectory:
        """Poses of the camera that took the images, as estimated at each. Raises SlamlibError before the first."""
        if not self.history:
            raise SlamlibError("nothing has been run yet")
        path = Trajectory(np.array(self.history)[:, TIME], np.array(self.path), np.array(self.covariances))
        return path.sensor_trajectory(self.source.original)

    def result(self) -> ImageResult:
        """The result so far. Raises SlamlibError before the first image."""
        path, columns = self.trajectory(), np.array(self.history, dtype=float).T
        return ImageResult(dict(zip(self.columns, columns, strict=True)), path, self.slam.belief.size)

    def save(self, path: str | Path) -> None:
        """Write the run to one file, atomically. Raises SlamlibError within a frame."""
        if not self.is_intact:
            raise SlamlibError(f"frame {self.done + 1} was interrupted, and the state of the filter is incomplete")
        settings = getattr(self.slam.front_ends[0], "settings", None)
        motion = {"name": self.motion.name, "settings": settings and asdict(settings), "state": self.motion.dump()}
        self.slam.save(path, **{self.kind.name: {"source": self.source.recipe, "run": self.dump(), "motion": motion}})

    def dump(self) -> dict[str, Any]:
        """Its state as plain data, without those of the filter and of the motion source."""
        return {
            **{name: getattr(self, name) for name in PLAIN},
            "tracking_loss": asdict(self.tracking_loss),
            "last": self.picture and _identity(self.picture),
            "innovations": {str(number): value.tolist() for number, value in self.innovations.items()},
        }

    def restore(self, state: dict[str, Any]) -> None:
        """Restore the state that `dump` returned. Raises SlamlibError if its last image is not the source's."""
        for name in PLAIN:
            setattr(self, name, state[name])
        self.tracking_loss = TrackingLoss(**state["tracking_loss"])
        self.innovations = {int(number): np.array(value) for number, value in state["innovations"].items()}
        if (last := state["last"]) is not None:
            self.picture = next(iter(self.source.part(self.done - 1)))
            if (found := _identity(self.picture)) != last:
                pixels = " with other pixels" * (found[0] == last[0])
                raise SlamlibError(
                    f"the {self.kind.item}s in {self.source.where} have changed since the run was saved: the last one "
                    f"that it used was {last[0]}, and its place has {found[0]} now{pixels}"
                )
            before, now = self.history[-1][TIME], self.picture.time
            if abs(now - before) > SAME_TIME * self.source.interval:
                raise SlamlibError(
                    f"the times of the {self.kind.item}s have changed since the run was saved: {last[0]} was of "
                    f"{before:.6f} s, and is of {now:.6f} s now; start a new run"
                )


def _identity(picture: TimedImage) -> list[str | int]:
    """What distinguishes an image from others, as plain data: its name and a checksum of its pixels."""
    return [picture.name, zlib.crc32(picture.image.tobytes())]
