"""The filter on a sequence of real pictures: one at a time, with what happened; saved at any of them, and gone on with.

**Scale.** One camera cannot tell how large the world is: all pictures are the same if world, path and velocities are
made k times as large. With a free scale the priors alone choose k: the inverse distance that new landmarks are begun
with, and the velocities and impulses of the motion. The unit of length is then the one in which the first landmarks are
about 1 / mean away (Options.inverse_distance). It drifts as new landmarks take over from old ones, and a trajectory is
compared with a reference after a similarity (slamlib.evaluation.alignment). A known target (slamlib.vision.target)
gives true lengths.

**Frame of reference.** With a free scale the robot's first pose is the world's origin, known exactly. With a target the
world is the target's.

**Without matches** a frame is a prediction. The camera's place is sought by the filter's expectation alone (there is no
relocalization), so that a run stops with `Lost` when a gap lasts too long (slamlib.vision.tracking_loss).
"""

import os
from collections.abc import Callable
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from slamlib.data.records import Control, Frame, Scan
from slamlib.data.setup import Rig, tuples
from slamlib.datasets.opening import reopen
from slamlib.datasets.pictures import Picture
from slamlib.datasets.sources import Source
from slamlib.errors import SlamlibError
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Report, Slam
from slamlib.vision.active_search import Settings
from slamlib.vision.combined_front_end import front_end_of
from slamlib.vision.hand_held import OPTIONS
from slamlib.vision.results import COLUMNS
from slamlib.vision.sequence_run import TIME, Stepping
from slamlib.vision.target import Target


class ImageRun(Stepping):
    """A run in progress. Iterate over it; `save` between two steps, `ImageRun.load` goes on exactly where it was."""

    kind = "images"

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
        two neighbours of the whole source: a longer time passes in steps of as long. Raises SlamlibError.
        """
        if len(rig.robots) != 1 or len(rig.sensors) != 1:
            raise SlamlibError("ImageRun: a rig of one robot with one camera is wanted")
        self.target = scale
        rig = rig if scale is None else scale.placed(rig)
        calibration = rig.sensors[0].calibration
        own = front_end_of(options, calibration, rng or np.random.default_rng(0)) if front_end is None else front_end
        super().__init__(source, Slam(rig, options, front_ends=[own]), patience, metric=scale is not None)

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
        return Frame(len(self.history) + 1, dt, (control,), (Scan(image=picture.image),))

    def _advance(self, frame: Frame) -> Report:
        return self._first(frame) if not self.history else self._next(self._wait(frame))

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

    def _settings(self) -> dict[str, Any]:
        settings = getattr(self.slam.front_ends[0], "settings", None)
        return {"settings": None if settings is None else asdict(settings)}

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
        header, saved = cls._read(path, "images")
        calibration = Rig.from_dict(header["rig"]).sensors[0].calibration
        chosen, settings = Options.from_dict(header["options"]), saved["settings"]
        make = front_end or (lambda c: front_end_of(chosen, c, np.random.default_rng(0), Settings(**tuples(settings))))
        if source is None:
            source = cls._source(path, saved, lambda recipe: reopen(recipe, frames))
        run = cls.__new__(cls)
        slam = Slam.load(path, front_ends=[make(calibration)])
        run.target = None
        run._go_on(source, slam, saved)
        return run


_TIME, _LANDMARKS = TIME, COLUMNS.index("landmarks")
