"""The filter on a sequence of rectified pairs: one at a time, with what happened; saved at any, and gone on with.

Lengths are true: the baseline tells them. The robot's first pose is the world's origin, known exactly; it looks along
x, and its left camera is at its own origin. Where the prediction of each step comes from is one of WAYS.
"""

import os
from collections.abc import Callable
from dataclasses import asdict, replace
from typing import Any, ClassVar

import numpy as np

from slamlib.data.records import Control, Frame, Scan
from slamlib.data.setup import Rig, SensorSetup, tuples
from slamlib.data.snapshots import Snapshot
from slamlib.datasets.opening import reopen
from slamlib.datasets.pairs import checked
from slamlib.datasets.pictures import Picture
from slamlib.datasets.sources import Source
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.slam import Options, Report, Slam
from slamlib.vision.hand_held import hand_held
from slamlib.vision.results import COLUMNS
from slamlib.vision.sequence_run import TIME, Stepping
from slamlib.vision.stereo.motion_source import MOVING
from slamlib.vision.stereo.settings import StereoSettings
from slamlib.vision.stopwatch import Stopwatch
from slamlib.vision.tracking_loss import Lost

OPTIONS = Options(points="eucPnt", updates=100, first=100, later=30, margin=0.0)
# Of a car: changes of velocity [m/s] and spin [deg/s] from one pair to the next, and both at the start, unknown.
IMPULSE, VELOCITY = (0.3, 2.0), (15.0, 10.0)
NOISE = (0.2, 0.2, 0.2)  # px, of u, v and disparity


class StereoRun(Stepping):
    """A run in progress. Iterate over it; `save` between two steps, `StereoRun.load` goes on exactly where it was."""

    kind, of = "stereo-images", "pairs"
    columns = (*COLUMNS, "odometry")
    has_map: ClassVar[bool] = True  # whether there are landmarks to be shown
    ways: ClassVar[dict[str, Callable[..., Any]]] = MOVING
    moving: Any

    def __init__(
        self,
        source: Source,
        camera: dict[str, Any],
        options: Options = OPTIONS,
        *,
        moving: str = "halves",
        settings: StereoSettings | None = None,
        impulse: tuple[float, float] = IMPULSE,
        velocity: tuple[float, float] = VELOCITY,
        patience: int = 30,
    ) -> None:
        """source: of pairs; camera: plain data of their stereo SensorSetup (open_pairs gives both).

        moving: of `ways`. impulse, velocity: standard deviations of changes of velocity and spin [m/s, deg/s] from one
        pair of the whole source to the next, and at the start, where the robot's motion has velocities. patience:
        frames without a match, after which the run stops. Raises SlamlibError.
        """
        setup = SensorSetup(**{"std": NOISE, **tuples(camera)})
        self.moving = self._moving(moving, setup, settings)
        rig = hand_held({"std": NOISE, **camera}, motion=self.moving.motion, impulse=impulse, velocity=velocity)
        self.name, self.seconds = moving, Stopwatch("odometry")
        slam = Slam(rig, options, front_ends=[self.moving.front_end])
        super().__init__(source, slam, patience, metric=True)

    @classmethod
    def _moving(cls, name: str, setup: SensorSetup, settings: StereoSettings | None) -> Any:
        if name not in cls.ways:
            raise UnknownNameError.of("motion of a stereo run", name, cls.ways)
        return cls.ways[name](setup.calibration, setup.mount, settings)

    def _frame(self, picture: Picture) -> Frame:
        try:
            image = checked(picture.image, self.slam.sensors[0].calibration)
        except SlamlibError as error:
            raise SlamlibError(f"{picture.name}: {error}") from None
        dt = picture.time - self.history[-1][TIME] if self.history else 0.0
        return Frame(len(self.history) + 1, dt, (None,), (Scan(image=image),))

    def _advance(self, frame: Frame) -> Report:
        with self.seconds.timed("odometry"):
            control = self.moving.control(frame.scans[0].image, frame.dt, self.slam)
        if not self._has_begun():  # nothing can move before something was seen
            frame, control = replace(frame, dt=0.0), Control(np.zeros(6), np.zeros((6, 6)))
        frame = self._impulses(frame) if control is None else replace(frame, controls=(control,))
        return self._next(frame)

    def _impulses(self, frame: Frame) -> Frame:
        """The frame of a robot that nobody tells anything."""
        robot = self.slam.robots[0]
        noise = robot.noise * (frame.dt / self.source.interval)
        return self._wait(replace(frame, controls=(Control(np.zeros(robot.motion.control), noise),)))

    def _has_begun(self) -> bool:
        return any(row[_LANDMARKS] for row in self.history)

    def _check_gap(self) -> None:
        if self.gap.frames >= self.patience:
            raise Lost(
                f"lost: {self.gap.frames} pairs in a row without a match, from frame {self.gap.first} on; was there a "
                "cut, or was a camera covered? Did they move so far that little is seen twice, or more than the "
                "motion's impulses allow for? There is no relocalization: go on with more patience, or begin anew at "
                "a later pair"
            )

    def _spent(self) -> dict[str, float]:
        return {**super()._spent(), **self.seconds}

    def snapshot(self) -> Snapshot:
        """What may be shown of the filter now: of the pair, the left picture."""
        shown = super().snapshot()
        left = [
            v if v.scan is None or v.scan.image is None else replace(v, scan=replace(v.scan, image=v.scan.image[0]))
            for v in shown.sensors
        ]
        return replace(shown, sensors=tuple(left))

    def _settings(self) -> dict[str, Any]:
        settings = asdict(self.moving.front_end.settings)
        return {"moving": self.name, "settings": settings, "state": self.moving.dump()}

    @classmethod
    def load(
        cls, path: str | os.PathLike[str], *, source: Source | None = None, frames: int | None = None
    ) -> "StereoRun":
        """Go on with a saved run. Raises SlamlibError for a file that holds none.

        source: in place of the one that it was begun with. frames: how many pairs in all, if not as many as before.
        """
        header, saved = cls._read(path, "stereo pairs")
        if source is None:
            source = cls._source(path, saved, lambda recipe: reopen(recipe, frames))
        run = cls.__new__(cls)
        settings = StereoSettings(**tuples(saved["settings"]))
        run.moving = cls._moving(saved["moving"], Rig.from_dict(header["rig"]).sensors[0], settings)
        run.name, run.seconds = saved["moving"], Stopwatch("odometry")
        slam = Slam.load(path, front_ends=[run.moving.front_end])
        run.moving.restore(saved["state"])
        run._go_on(source, slam, saved)
        return run


_LANDMARKS = COLUMNS.index("landmarks")
