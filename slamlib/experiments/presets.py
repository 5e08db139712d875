"""Experiments as plain data: copy one, change it with `dataclasses.replace`, and run it.

Numbers are those of the toolbox's userData files and of its quick start, except where a comment says otherwise; the two
in the plane, and `right_invariant`, are the book's own.

    >>> import slamlib as sl
    >>> sorted(sl.presets.PRESETS)[:4]
    ['default', 'five_minutes', 'lines', 'omni']
    >>> sl.presets.stereo().rig
    Rig: robots robot (odometry); sensors left (pinHole), right (pinHole)
"""

import json
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Array
from slamlib.plain_data.fields import Count, FileName, OneOf, Plain, Range, Whole, check
from slamlib.plain_data.files import read_text, write_whole
from slamlib.records.inputs import Frame, Truth, World
from slamlib.rigs.setup import ZERO, Numbers, Rig, RobotSetup, SensorSetup
from slamlib.sensors.scaramuzza import polynomials
from slamlib.simulation import NOISE_IN, WORLDS, Faults, join, simulate, world
from slamlib.slam import Options, Slam


@dataclass(frozen=True)
class Preset(Plain):
    """An experiment: the world, the robots and sensors, the filter's options, and the duration.

    worlds: (name, arguments) of each part of the world (slamlib.simulation.WORLDS). noise_in: "control" or "truth", see
    slamlib.simulation.simulate. dt [s]. seed: of all random numbers. legs: by a robot's name what it drives, over and
    over: for so many frames each, a control as in its setup; robots that are not named keep the one of their setup.
    """

    name: Annotated[str, FileName()]
    rig: Rig
    options: Options = field(default_factory=Options)
    worlds: tuple[tuple[Annotated[str, OneOf(WORLDS)], dict[str, Any]], ...] = (("thickCloister", {"n": 7}),)
    frames: Whole = 400
    dt: Annotated[float, Range(gt=0, lt=np.inf, unit="s")] = 0.1
    noise_in: Annotated[str, OneOf(NOISE_IN)] = "control"
    faults: Faults = field(default_factory=Faults)
    occlusion: bool = False
    seed: Count = 1
    legs: dict[str, tuple[tuple[Whole, Numbers], ...]] | None = None

    def __post_init__(self) -> None:
        check(self)
        for sensor in self.rig.sensors:
            if not all(sensor.std):
                raise SlamlibError(f"{sensor.name}: std should be above 0, for the filter, got {sensor.std}")
        robots = {robot.name: robot for robot in self.rig.robots}
        for name, legs in (self.legs or {}).items():
            driven(entry("robot of the legs", name, robots), legs)

    def __repr__(self) -> str:
        """What is run, without all the numbers: `to_dict` has these."""
        worlds = ", ".join(name for name, _ in self.worlds)
        return f"Preset {self.name}: {self.frames} frames of {self.dt:g} s in {worlds}; {self.rig}; {self.options}"

    @cached_property
    def world(self) -> World:
        """The world."""
        return join(*(world(name, **arguments) for name, arguments in self.worlds))

    def simulate(self, rng: np.random.Generator | None = None) -> Iterator[tuple[Frame, Truth]]:
        """Frames and truths of one run; drawn with `rng`, or with the preset's seed."""
        return simulate(
            self.rig,
            self.world,
            frames=self.frames,
            dt=self.dt,
            rng=np.random.default_rng(self.seed) if rng is None else rng,
            noise_in=self.noise_in,
            faults=self.faults,
            occlusion=self.occlusion,
            controls=[driven(robot, (self.legs or {}).get(robot.name, ())) for robot in self.rig.robots],
            minimum_length=self.options.minimum_length,
        )

    def slam(self) -> Slam:
        """Make a filter for it, before the first frame."""
        return Slam(self.rig, options=self.options)

    def save(self, path: str | Path) -> None:
        """Write it as JSON, atomically."""
        write_whole(path, json.dumps(self.to_dict(), indent=2) + "\n")

    @classmethod
    def load(cls, path: str | Path) -> "Preset":
        """Read a preset as JSON (from `save` or by hand) or, by the file's suffix, TOML. Raises SlamlibError."""
        source = Path(path)
        text = read_text(source)
        try:
            data = tomllib.loads(text) if source.suffix == ".toml" else json.loads(text)
        except (RecursionError, ValueError) as error:
            raise SlamlibError(f"{path} cannot be read as a preset: {error}") from None
        return cls.from_dict(data)


def driven(robot: RobotSetup, legs: tuple[tuple[int, Numbers], ...]) -> Callable[[int], Array] | None:
    """A robot's control (c,) by the frame's number (from 1), leg after leg and over again; None: no legs."""
    table = [row for frames, control in legs for row in [replace(robot, control=control).nominal] * frames]
    return (lambda number: table[(number - 1) % len(table)]) if table else None


ROBOT = RobotSetup(position=(0.0, -5.0, 0.0), control=(0.08, 0, 0, 0, 0, 0.9), control_std=(0.005,) * 3 + (0.05,) * 3)
CAMERA = SensorSetup(position=(0.0, 0.0, 0.6))
LASER = SensorSetup(type="planeRangeBearing", name="range and bearing", euler=ZERO, limits={"far": 4.0})


def default() -> Preset:
    """userData: two rounds in a cloister of 72 points, with a lens that distorts."""
    lens = {"intrinsics": (320.0, 240.0, 320.0, 320.0), "distortion": (-0.3, 0.1)}
    camera = replace(CAMERA, parameters=lens)
    return Preset("default", Rig((ROBOT,), (camera,)), Options(max_new_first=5), frames=800)


def points() -> Preset:
    """userDataPnt: one round in a cloister of 72 points."""
    return Preset("points", Rig((ROBOT,), (CAMERA,)), Options(points="ahmPnt"))


def lines() -> Preset:
    """userDataLin: one round about a house of 23 edges, with the camera pointing at it."""
    robot = replace(ROBOT, position=(-5.0, 0.0, 0.0), euler=(0.0, 0.0, -90.0), control_std=(0.002,) * 3 + (0.02,) * 3)
    camera = replace(CAMERA, position=(0.0, 0.0, 1.5), euler=(-90.0, 0.0, 0.0))
    options = Options(points=None, lines="idpLin", max_new_first=1, inverse_distance=(0.1, 0.5), minimum_length=10.0)
    return Preset("lines", Rig((robot,), (camera,)), options, (("house", {"x": -2, "y": -2, "z": 0}),))


def omni() -> Preset:
    """Quick start 13: `points` with the omnidirectional camera of userData, which points forward and down."""
    lens = polynomials(np.radians(95), backward=(447.3, 0.0, -1.068e-3, 1.184e-6, -1.856e-9))
    camera = SensorSetup(
        type="omniCam",
        position=(0.2, 0.0, 1.2),
        euler=(-120.0, 0.0, -90.0),
        image=(1280.0, 800.0),
        parameters={"intrinsics": (668.0, 438.0, 1.0, 0.0, 0.0), "lens": tuple(lens.lens.tolist())},
        limits={"angle": lens.angle},
    )
    return replace(points(), name="omni", rig=Rig((ROBOT,), (camera,)))


def _pair(**right: Any) -> Rig:
    one = replace(CAMERA, name="left", position=(0.0, 0.25, 0.6))
    return Rig((ROBOT,), (one, replace(CAMERA, name="right", position=(0.0, -0.25, 0.6), **right)))


def stereo() -> Preset:
    """Quick start 14: two cameras on one robot, half a metre apart."""
    return replace(points(), name="stereo", rig=_pair())


def self_calibration() -> Preset:
    """Quick start 14, second half: the right camera's pose is known to 2 cm and 1.5 degrees, and estimated.

    Both cameras start together, as in the toolbox: the filter is then overconfident of the extrinsics. Chapter many
    shows by how much, and that it is not when the left camera maps alone at first.
    """
    return replace(
        points(), name="self_calibration", rig=_pair(estimated=True, position_std=(0.02,), orientation_std=(1.5,))
    )


def two_robots() -> Preset:
    """Quick start 15: two robots on opposite sides of one circle, in one map."""
    ahead = replace(ROBOT, name="first")
    behind = replace(ROBOT, name="second", position=(0.0, 5.0, 0.0), euler=(0.0, 0.0, 180.0))
    cameras = (replace(CAMERA, name="camera 1"), replace(CAMERA, name="camera 2", robot=1))
    return replace(points(), name="two_robots", rig=Rig((ahead, behind), cameras))


def points_and_lines() -> Preset:
    """Points and lines in one run: the cloister with the house in its middle (manual, section 6)."""
    camera = replace(CAMERA, position=(0.0, 0.0, 1.0))
    looking_in = replace(camera, name="left camera", euler=(-90.0, 0.0, 0.0))
    options = Options(points="ahmPnt", lines="ahmLin", max_new_first=5, updates=20)
    worlds = (("thickCloister", {"n": 7}), ("house", {"x": -2, "y": -2, "z": 0}))
    return Preset("points_and_lines", Rig((ROBOT,), (camera, looking_in)), options, worlds)


def right_invariant() -> Preset:
    """`points` with a covariance that claims no more than can be known, in one batch update a frame.

    Points become Euclidean ones as ever: here the filter with this error stays as consistent, and has four numbers less
    a point. With error="local" it does not, where the start is less certain than the sensor; and in `points_and_lines`,
    where the scale is biased, with neither (`make conversion`).
    """
    options = replace(points().options, error="world", reproject=False)
    return replace(points(), name="right_invariant", options=options)


def plane() -> Preset:
    """In the plane: a lap and more among the 36 points of a cloister, by range and bearing; it closes the loop."""
    robot = replace(ROBOT, motion="unicycle", control=(0.8, 9.0), control_std=(0.05, 1.5))
    sensor = replace(LASER, std=(0.1, float(np.radians(2.0))))
    around = (("cloister", {"n": 7}),)
    return Preset("plane", Rig((robot,), (sensor,)), worlds=around, frames=120, dt=0.4, noise_in="truth")


def five_minutes() -> Preset:
    """SLAM in five minutes, the chapter: two laps of a rounded square past eight landmarks in the plane."""
    robot = RobotSetup(motion="planeOdometry", control_std=(0.03, 0.0, 0.5))
    sensor = replace(LASER, std=(0.1, float(np.radians(1.0))))
    landmarks = (3, -2), (7, -2.2), (9.8, 1), (9.9, 5), (7, 9.2), (3, 9.3), (-0.8, 8), (-1.5, 4.5)
    return Preset(
        "five_minutes",
        Rig((robot,), (sensor,)),
        Options(gate=1.0, selection="order", max_new=10),  # as the chapter's filter does it
        (("listed", {"points": landmarks}),),
        frames=160,
        dt=1.0,
        noise_in="truth",
        legs={"robot": ((15, (0.4, 0.0, 0.0)), (5, (0.4, 0.0, 18.0)))},
    )


OF_TOOLBOX = default, points, lines, omni, stereo, self_calibration, two_robots, points_and_lines
PRESETS: dict[str, Callable[[], Preset]] = {f.__name__: f for f in (*OF_TOOLBOX, right_invariant, plane, five_minutes)}


def preset(name: str) -> Preset:
    """The preset of this name, in which hyphens count as underscores. Raises UnknownNameError."""
    return entry("preset", name.replace("-", "_"), PRESETS)()
