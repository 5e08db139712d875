"""What all runs on pictures share: one after another, numbers and path by frame, a file that goes on exactly."""

import os
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any, ClassVar

import numpy as np

from slamlib.data.records import Frame
from slamlib.data.snapshots import Snapshot
from slamlib.datasets.pictures import Picture
from slamlib.datasets.sources import Source
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory
from slamlib.slam import Report, Slam, checkpoint
from slamlib.vision.results import COLUMNS, ImageResult, counts
from slamlib.vision.tracking_loss import Gap


@dataclass(frozen=True, eq=False)
class ImageStep:
    """One picture, as it has just been worked on: what the filter reports, and the run's row of numbers by name."""

    number: int
    picture: Picture
    report: Report
    row: dict[str, float]


class Stepping(ABC):
    """A run in progress. Iterate over it; `save` between two steps. metric: whether its lengths are true."""

    kind: ClassVar[str]  # the name of its data in a file
    of: ClassVar[str] = "pictures"
    columns: ClassVar[tuple[str, ...]] = COLUMNS  # of its history
    source: Source
    slam: Slam
    patience: int
    metric: bool

    def __init__(self, source: Source, slam: Slam, patience: int, metric: bool) -> None:
        """patience: frames without a match, after which the run stops."""
        self.source, self.slam, self.patience, self.metric = source, slam, patience, metric
        self.history: list[list[float]] = []
        self.path: list[list[float]] = []
        self.gap = Gap()
        self.whole = True  # False while a frame is being worked on

    def __len__(self) -> int:
        """Pictures still to do."""
        return len(self.source) - len(self.history)

    def __iter__(self) -> Iterator[ImageStep]:
        """Work on the pictures still to do. Raises Lost, and SlamlibError for a picture that cannot be read."""
        if not len(self):
            return
        began = time.perf_counter()
        for picture in self.source.part(len(self.history)):
            yield self._step(picture, time.perf_counter() - began)
            if len(self):
                self._check_gap()
            began = time.perf_counter()

    def _step(self, picture: Picture, reading: float) -> ImageStep:
        frame = self._frame(picture)
        self.whole = False
        began, before = time.perf_counter(), self._spent()
        report = self._advance(frame)
        inside = {name: after - before[name] for name, after in self._spent().items()}
        spent = time.perf_counter() - began
        row = {"time": picture.time, **self._counts(report), "reading": reading, **inside}
        row["filter"] = spent - sum(inside.values())
        self.history.append([row[name] for name in self.columns])
        self.path.append(self.slam.sensors[0].camera.tolist())
        self._follow(frame.number)
        self.whole = True
        return ImageStep(frame.number, picture, report, row)

    @abstractmethod
    def _frame(self, picture: Picture) -> Frame:
        """What the filter is given of a picture. Raises SlamlibError for one that does not fit; nothing is changed."""

    @abstractmethod
    def _advance(self, frame: Frame) -> Report:
        """Work on a frame."""

    @abstractmethod
    def _settings(self) -> dict[str, Any]:
        """Plain data of a file, beside those of every run."""

    def _wait(self, frame: Frame) -> Frame:
        """Let the pictures that are missing before a frame pass as dark ones would; the frame of what is left.

        An impulse comes with each interval of the source: in one long step all of them would come at its end, and move
        nothing. frame: its control is None, or zeros whose covariance is of all its time.
        """
        steps = round(frame.dt / self.source.interval)
        if steps < 2:
            return frame
        (whole,) = frame.controls
        share = None if whole is None else replace(whole, covariance=whole.covariance / steps)
        for _ in range(steps - 1):
            self.slam.wait((share,), frame.dt / steps)
        return replace(frame, dt=frame.dt / steps, controls=(share,))

    def _next(self, frame: Frame) -> Report:
        """One frame of the filter; into an empty map as many landmarks are begun as in a first frame."""
        if not self.slam.landmarks:
            self.slam.frames_of[0] = 0
        return self.slam.step(frame)

    def _counts(self, report: Report) -> dict[str, float]:
        return counts(self.slam, report)

    def _follow(self, number: int) -> None:
        self.gap.follow(number, self.slam.looks[0], len(self.slam.landmarks))

    def _check_gap(self) -> None:
        self.gap.check(self.patience, len(self.slam.landmarks))

    def _spent(self) -> dict[str, float]:
        """Seconds that the front end has spent so far, by part."""
        return {"search": 0.0, "detection": 0.0, **getattr(self.slam.front_ends[0], "seconds", {})}

    def snapshot(self) -> Snapshot:
        """What may be shown of the filter now."""
        return self.slam.snapshot()

    def trajectory(self) -> Trajectory:
        """Poses of the camera in the world, as they were estimated at each picture. Raises SlamlibError before one."""
        if not self.history:
            raise SlamlibError("nothing has been run yet")
        return Trajectory(np.array(self.history)[:, TIME], np.array(self.path))

    def result(self) -> ImageResult:
        """What has been done so far. Raises SlamlibError before the first picture."""
        return ImageResult.of(self.history, self.trajectory(), self.slam.belief.size, self.columns)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all of it to one file, whole or not at all. Raises SlamlibError in the middle of a frame."""
        if not self.whole:
            raise SlamlibError(f"frame {len(self.history) + 1} was broken off, and the filter is not whole any more")
        common = {
            "source": self.source.recipe,
            "history": self.history,
            "path": self.path,
            "gap": asdict(self.gap),
            "patience": self.patience,
            "metric": self.metric,
        }
        self.slam.save(path, **{self.kind: {**common, **self._settings()}})

    @classmethod
    def holds(cls, path: str | os.PathLike[str]) -> bool:
        """Whether a file has a run of this kind. Raises SlamlibError for a file that no filter was saved to."""
        return cls.kind in checkpoint.read(path)[0]["extra"]

    @classmethod
    def _read(cls, path: str | os.PathLike[str], what: str) -> tuple[dict[str, Any], dict[str, Any]]:
        """Header of a file, and a run's own data in it. Raises SlamlibError for a file of another kind."""
        header, _ = checkpoint.read(path)
        saved = header["extra"].get(cls.kind)
        if saved is None:
            raise SlamlibError(f"{path} holds no run on {what}: `slamlib run --resume` goes on with a simulated one")
        return header, saved

    @classmethod
    def _source(
        cls, path: str | os.PathLike[str], saved: dict[str, Any], reopen: Callable[[dict[str, Any]], Source]
    ) -> Source:
        """The source of a saved run, opened again. Raises SlamlibError if it was in memory."""
        if not saved["source"]:
            raise SlamlibError(f"{path}: its {cls.of} were in memory; give them as source=...")
        return reopen(saved["source"])

    def _go_on(self, source: Source, slam: Slam, saved: dict[str, Any]) -> None:
        """Be where the saved run was."""
        self.source, self.slam, self.whole = source, slam, True
        self.patience, self.metric = saved["patience"], saved["metric"]
        self.history, self.path, self.gap = saved["history"], saved["path"], Gap(**saved["gap"])


TIME = COLUMNS.index("time")
