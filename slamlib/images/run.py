"""The filter on a sequence of real pictures: one at a time, with what happened; saved at any of them, and gone on with.

**Scale.** One camera cannot tell how large the world is: all pictures are the same if world, path and velocities are
made k times as large. With a free scale the priors alone choose k: the inverse distance that new landmarks are begun
with, and the velocities and impulses of the motion. The unit of length is then the one in which the first landmarks are
about 1 / mean away (Options.inverse_distance). It drifts as new landmarks take over from old ones, and a trajectory is
compared with a reference after a similarity (slamlib.alignment). A known target (slamlib.images.target) gives true
lengths.

**Frame of reference.** With a free scale the robot's first pose is the world's origin, known exactly. With a target the
world is the target's.

**Without matches** a frame is a prediction. The camera's place is sought by the filter's expectation alone (there is no
relocalization), so that a run stops with `Lost` when a gap lasts too long (slamlib.images.gaps).
"""

import os
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.images.active_search import Settings
from slamlib.images.both import front_end_of
from slamlib.images.gaps import Gap
from slamlib.images.hand_held import OPTIONS
from slamlib.images.opening import reopened
from slamlib.images.pictures import Picture
from slamlib.images.results import COLUMNS, ImageResult, counts
from slamlib.images.sources import Source
from slamlib.images.target import Target
from slamlib.records import Control, Features, Frame, Scan
from slamlib.rig import Rig, tuples
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Report, Slam, checkpoint
from slamlib.trajectories import Trajectory


@dataclass(frozen=True, eq=False)
class ImageStep:
    """One picture, as it has just been worked on: what the filter reports, and the run's row of numbers by name."""

    number: int
    picture: Picture
    report: Report
    row: dict[str, float]


class ImageRun:
    """A run in progress. Iterate over it; `save` between two steps, `ImageRun.load` goes on exactly where it was."""

    def __init__(
        self,
        source: Source,
        rig: Rig,
        options: Options = OPTIONS,
        front_end: Any = None,
        *,
        scale: Target | None = None,
        patience: int = 30,
        rng: np.random.Generator | None = None,
    ) -> None:
        """rig: one robot with one camera. scale: a known target, or None for a free scale.

        front_end: default ActiveSearch, which draws with `rng`, and beside it SegmentSearch if the options have lines.
        patience: frames without a match, after which the run stops. The impulses of the rig's motion are those between
        two neighbours of the whole source: over a longer time there are as many more of them. Raises SlamlibError.
        """
        if len(rig.robots) != 1 or len(rig.sensors) != 1:
            raise SlamlibError("ImageRun: a rig of one robot with one camera is wanted")
        self.source, self.patience, self.target = source, patience, scale
        self.metric = scale is not None  # whether lengths are true
        rig = rig if scale is None else scale.placed(rig)
        calibration = rig.sensors[0].calibration
        own = front_end_of(options, calibration, rng or np.random.default_rng(0)) if front_end is None else front_end
        self.slam = Slam(rig, options, front_ends=[own])
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
                self.gap.check(self.patience, len(self.slam.landmarks))
            began = time.perf_counter()

    def _step(self, picture: Picture, reading: float) -> ImageStep:
        frame = self._frame(picture)
        self.whole = False
        began, before = time.perf_counter(), self._spent()
        report = self._first(frame) if not self.history else self._next(frame)
        inside = {name: after - before[name] for name, after in self._spent().items()}
        spent = time.perf_counter() - began
        row = {"time": picture.time, **counts(self.slam, report), "reading": reading, **inside}
        row["filter"] = spent - sum(inside.values())
        self.history.append([row[name] for name in COLUMNS])
        self.path.append(self.slam.sensors[0].camera.tolist())
        self.gap.follow(frame.number, self.slam.looks[0], len(self.slam.landmarks))
        self.whole = True
        return ImageStep(frame.number, picture, report, row)

    def _frame(self, picture: Picture) -> Frame:
        image = self.slam.sensors[0].calibration.image
        size = picture.image.shape[::-1]
        if image is not None and tuple(image) != size:
            raise SlamlibError(
                f"{picture.name} is {size[0]}x{size[1]}, and the calibration is of {image[0]:g}x{image[1]:g} pixels"
            )
        # Nothing can move before something was seen: the first landmarks are begun from the start that is known.
        seen = any(row[_LANDMARKS] for row in self.history)
        dt = picture.time - self.history[-1][_TIME] if seen else 0.0
        robot = self.slam.robots[0]
        control = Control(np.zeros(robot.motion.control), robot.noise * (dt / self.source.interval))
        return Frame(len(self.history) + 1, dt, (control,), (Scan(Features.none(2), image=picture.image),))

    def _first(self, frame: Frame) -> Report:
        """The first picture: of a known target nothing is looked for, since its pixels have just been used."""
        if self.target is None:
            return self._next(frame)
        self.target.put(self.slam, frame.scans[0])
        options = self.slam.options
        self.slam.options = replace(options, updates=0)
        try:
            return self.slam.step(frame)
        finally:
            self.slam.options = options

    def _next(self, frame: Frame) -> Report:
        if not self.slam.landmarks:
            self.slam.frames_of[0] = 0  # as many landmarks are begun as in a first frame
        return self.slam.step(frame)

    def _spent(self) -> dict[str, float]:
        """Seconds that the front end has spent so far, by part."""
        return {"search": 0.0, "detection": 0.0, **getattr(self.slam.front_ends[0], "seconds", {})}

    def trajectory(self) -> Trajectory:
        """Poses of the camera in the world, as they were estimated at each picture. Raises SlamlibError before one."""
        if not self.history:
            raise SlamlibError("nothing has been run yet")
        return Trajectory(np.array(self.history)[:, _TIME], np.array(self.path))

    def result(self) -> ImageResult:
        """What has been done so far. Raises SlamlibError before the first picture."""
        return ImageResult.of(self.history, self.trajectory(), self.slam.belief.size)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all of it to one file, whole or not at all. Raises SlamlibError in the middle of a frame."""
        if not self.whole:
            raise SlamlibError(f"frame {len(self.history) + 1} was broken off, and the filter is not whole any more")
        settings = getattr(self.slam.front_ends[0], "settings", None)
        images = {
            "source": self.source.recipe,
            "settings": None if settings is None else asdict(settings),
            "history": self.history,
            "path": self.path,
            "gap": asdict(self.gap),
            "patience": self.patience,
            "metric": self.metric,
        }
        self.slam.save(path, images=images)

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        *,
        source: Source | None = None,
        front_end: Callable[[Calibration], Any] | None = None,
        frames: int | None = None,
    ) -> "ImageRun":
        """Go on with a saved run. Raises SlamlibError for a file that holds none.

        source: in place of the one that it was begun with. front_end(calibration): makes one like that of the run, if
        it was not ActiveSearch. frames: how many pictures in all, if not as many as before.
        """
        header, _ = checkpoint.read(path)
        saved = header["extra"].get("images")
        if saved is None:
            raise SlamlibError(f"{path} holds no run on images: `slamlib run --resume` goes on with a simulated one")
        calibration = Rig.from_dict(header["rig"]).sensors[0].calibration
        chosen, settings = Options.from_dict(header["options"]), saved["settings"]
        make = front_end or (lambda c: front_end_of(chosen, c, np.random.default_rng(0), Settings(**tuples(settings))))
        if source is None and not saved["source"]:
            raise SlamlibError(f"{path}: its pictures were in memory; give them as source=...")
        run = cls.__new__(cls)
        run.slam, _ = Slam.resume(path, front_ends=[make(calibration)])
        run.source = reopened(saved["source"], frames) if source is None else source
        run.patience, run.metric, run.target, run.whole = saved["patience"], saved["metric"], None, True
        run.history, run.path, run.gap = saved["history"], saved["path"], Gap(**saved["gap"])
        return run


_TIME, _LANDMARKS = COLUMNS.index("time"), COLUMNS.index("landmarks")
