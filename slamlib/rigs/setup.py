"""Robots and their sensors as plain data that a reader copies and changes; simulator and filter are made from it.

Angles of a setup are in degrees, for the people who write them; everything else in slamlib is in radians.
"""

from dataclasses import dataclass, field, replace
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError
from slamlib.geometry.euler import to_quaternion
from slamlib.kalman import linalg
from slamlib.manifolds import Array, finite
from slamlib.motions import MOTIONS, Motion, motion
from slamlib.plain_data.fields import Count, Finite, Length, OneOf, Plain, Positive, Range, call_of, check
from slamlib.plain_data.tables import html_table
from slamlib.sensors import SENSORS, sensor
from slamlib.sensors.sensor import Calibration

# Beyond these limits nothing is left of the arithmetic's 16 digits.
Numbers = tuple[Annotated[float, Range(ge=-1e9, le=1e9)], ...]
Stds = tuple[Annotated[float, Range(ge=0, le=1e6)], ...]
Three = Annotated[Numbers, Length((3,))]
Six = Annotated[Numbers, Length((6,))]
ThreeStds = Annotated[Stds, Length((1, 3))]
ThreeAngles = Annotated[tuple[Annotated[float, Range(ge=0, le=180, unit="deg")], ...], Length((1, 3))]
ZERO = (0.0, 0.0, 0.0)
# The default camera, for setups that specify no other image or parameters for a type of sensor that has an image.
IMAGE: Numbers = (640.0, 480.0)
PARAMETERS: dict[str, Numbers] = {"intrinsics": (320.0, 240.0, 320.0, 320.0), "distortion": (0.0,)}
UNSPECIFIED: Numbers = ()


@dataclass(frozen=True)
class RobotSetup:
    """A robot: its motion model, its start, its control at each step, and the uncertainty of both.

    motion: by its name, or one of your own. position [m]; euler: roll, pitch, yaw [deg]; velocity: (v [m/s] in world
    axes, w [deg/s] in the robot's), for motions whose state has one. control: as many numbers as the motion takes, in
    metres (or m/s), its angles in degrees (or deg/s), zeros by default; control_std the same, the standard
    deviation in one step; control_covariance: a full covariance instead, in metres and radians. The other *_std belong
    to the start: the simulator draws the true start with them, and the filter is given the mean; orientation_std [deg]
    is about the robot's own axes.

        >>> import slamlib as sl
        >>> robot = sl.RobotSetup(position=(1, 2, 0), euler=(0, 0, 90), position_std=0.1)
        >>> robot.state.round(3).tolist()  # position, quaternion (w, x, y, z)
        [1.0, 2.0, 0.0, 0.707, 0.0, 0.0, 0.707]
    """

    name: str = "robot"
    motion: Motion | str = "odometry"
    position: Three = ZERO
    euler: Three = ZERO
    velocity: Six = (0.0,) * 6
    position_std: ThreeStds = ZERO
    orientation_std: ThreeAngles = ZERO
    velocity_std: Annotated[Stds, Length((6,))] = (0.0,) * 6
    control: Numbers = UNSPECIFIED
    control_std: Stds = UNSPECIFIED
    control_covariance: tuple[Numbers, ...] | None = None

    __repr__ = call_of

    def __post_init__(self) -> None:
        check(self)

    @property
    def robots(self) -> tuple["RobotSetup", ...]:
        """As a part of a rig: itself."""
        return (self,)

    @property
    def sensors(self) -> tuple["SensorSetup", ...]:
        """As a part of a rig: none."""
        return ()

    @property
    def model(self) -> Motion:
        """The motion model."""
        return motion(self.motion) if isinstance(self.motion, str) else self.motion

    @property
    def state(self) -> Array:
        """Mean (size,) of the initial state."""
        return self._start[0]

    @property
    def covariance(self) -> Array:
        """Covariance (dof, dof) of the initial state."""
        return self._start[1]

    @property
    def _start(self) -> tuple[Array, Array]:
        pose = pose_of(self.position, self.euler, self.name)
        return self.start_at(pose, _pose_std(self.position_std, self.orientation_std))

    def start_at(self, pose: Array, std: Array) -> tuple[Array, Array]:
        """State and covariance of a start at another pose (7,), with standard deviations (6,). Raises SlamlibError."""
        try:
            state, J = self.model.at(pose, _mixed(self.velocity, self.name, "velocity"))
        except SlamlibError as error:
            raise SlamlibError(f"{self.name}: {error}") from None
        return state, J * np.concatenate([std, _mixed(self.velocity_std, self.name, "velocity_std")]) ** 2 @ J.T

    @property
    def nominal(self) -> Array:
        """Nominal control (c,) of one step, in metres and radians."""
        return self._of_control(self.control, "control")

    @property
    def noise(self) -> Array:
        """Covariance (c, c) of the noise in one step's control. Raises SlamlibError where it is none."""
        if self.control_covariance is not None:
            return linalg.covariance(self.control_covariance, self.model.control, self.name, "control_covariance")
        return np.diag(self._of_control(self.control_std, "control_std") ** 2)

    def _of_control(self, values: Numbers, what: str) -> Array:
        size = self.model.control
        return _mixed(values or (0.0,) * size, self.name, what, size, self.model.angles)


@dataclass(frozen=True)
class SensorSetup:
    """A sensor: its type by name, its robot, its extrinsics, and its calibration.

    position [m] and euler [deg] in the robot's frame; a camera that points forward has euler (-90, 0, -90). With
    estimated=True the extrinsics are part of the map, with initial position_std [m] and orientation_std [deg], and the
    simulator draws the true extrinsics with them. std: of each number of a measurement, or one for all; noise: a
    full covariance instead. image: (width, height) [px]; None: an image without a border. parameters and limits: those
    of the sensor's type. Image and parameters that are not given are those of the default camera, if it fits the type.
    landmark: the parametrization of the landmarks that it initializes, by its name; None: what the options say.

        >>> import slamlib as sl
        >>> camera = sl.SensorSetup(position=(0, 0, 0.6), std=0.5)
        >>> camera.calibration.project([0.5, 0, 2, 1]).tolist()  # a point two metres ahead, half a metre to the right
        [400.0, 240.0]
    """

    name: str = "camera"
    robot: Count = 0
    type: Annotated[str, OneOf(SENSORS)] = "pinHole"
    position: Three = ZERO
    euler: Three = (-90.0, 0.0, -90.0)
    estimated: bool = False
    position_std: ThreeStds = ZERO
    orientation_std: ThreeAngles = ZERO
    std: Stds = (1.0,)
    noise: tuple[Numbers, ...] | None = None
    image: Annotated[tuple[Positive, ...], Length((0, 2))] | None = UNSPECIFIED
    parameters: dict[str, Numbers] = field(default_factory=dict)
    limits: dict[str, Finite] = field(default_factory=dict)
    landmark: str | None = None

    __repr__ = call_of

    def __post_init__(self) -> None:
        check(self)
        kind = sensor(self.type)
        if self.image == UNSPECIFIED:
            object.__setattr__(self, "image", IMAGE if kind.pixels else None)
        if not self.parameters and set(kind.parameters) <= set(PARAMETERS):
            object.__setattr__(self, "parameters", {name: PARAMETERS[name] for name in kind.parameters})

    @property
    def robots(self) -> tuple[RobotSetup, ...]:
        """As a part of a rig: none."""
        return ()

    @property
    def sensors(self) -> tuple["SensorSetup", ...]:
        """As a part of a rig: itself."""
        return (self,)

    @property
    def extrinsics(self) -> Array:
        """Pose (7,) in the robot's frame; the initial mean if it is estimated."""
        return pose_of(self.position, self.euler, self.name)

    @property
    def covariance(self) -> Array:
        """Initial covariance of the extrinsics (6, 6); zero if they are not estimated."""
        std = _pose_std(self.position_std, self.orientation_std)
        return np.diag(std**2) if self.estimated else np.zeros((6, 6))

    @property
    def calibration(self) -> Calibration:
        """The calibrated sensor. Raises SlamlibError for an invalid calibration."""
        kind = sensor(self.type)
        noise: ArrayLike | None = self.noise
        if noise is None:
            if len(self.std) not in (1, kind.size):
                raise ShapeError(f"{self.name}: std is one number, or {kind.size}, got {self.std}")
            noise = np.broadcast_to(self.std, (kind.size,)) ** 2
        return Calibration(kind, noise, image=self.image, limits=self.limits, **self.parameters)


@dataclass(frozen=True)
class Rig(Plain):
    """Robots and sensors, in the order of the frames' controls and scans.

    >>> import slamlib as sl
    >>> sl.Rig((sl.RobotSetup(name="rover"),), (sl.SensorSetup(position=(0, 0, 0.6)),))
    Rig: robots rover (odometry); sensors camera (pinHole)
    """

    robots: tuple[RobotSetup, ...]
    sensors: tuple[SensorSetup, ...]

    def __repr__(self) -> str:
        """Who is in it: robots by their motions, sensors by their types."""
        robots = ", ".join(f"{r.name} ({r.model.name})" for r in self.robots)
        return f"Rig: robots {robots}; sensors {', '.join(f'{s.name} ({s.type})' for s in self.sensors)}"

    def _repr_html_(self) -> str:
        """A row for each robot and each sensor: what it is, and where it starts or sits."""
        columns = ("", "type", "on", "position [m]", "roll, pitch, yaw [deg]")
        rows = [(r.name, r.model.name, "", _listed(r.position), _listed(r.euler)) for r in self.robots]
        on = [self.robots[s.robot].name for s in self.sensors]
        rows += [
            (s.name, s.type, robot, _listed(s.position), _listed(s.euler))
            for s, robot in zip(self.sensors, on, strict=True)
        ]
        return html_table(columns, rows)

    def __post_init__(self) -> None:
        if not self.robots or not self.sensors:
            raise SlamlibError("a rig needs at least one robot and one sensor")
        for setups in (self.robots, self.sensors):
            names = [s.name for s in setups]
            if len(set(names)) != len(names):
                raise SlamlibError(f"each robot and each sensor needs a name of its own, got {', '.join(names)}")
        for s in self.sensors:
            if not 0 <= s.robot < len(self.robots):
                raise SlamlibError(f"{s.name} sits on robot {s.robot}; robots are counted 0 to {len(self.robots) - 1}")

    @property
    def dof(self) -> tuple[int, ...]:
        """Degrees of freedom of each robot's pose: 6, or 3 in the plane."""
        return tuple(robot.model.free.shape[1] for robot in self.robots)

    @classmethod
    def of(cls, *parts: "Rig | RobotSetup | SensorSetup") -> "Rig":
        """The rig of robots and sensors, in this order. Raises SlamlibError."""
        others = [type(part).__name__ for part in parts if not isinstance(part, Rig | RobotSetup | SensorSetup)]
        if others:
            what = f"a rig is made of robots and sensors, not of {', '.join(others)}"
            raise SlamlibError(f"{what}; options are given by name: Slam(rig, options=...)")
        robots = (robot for part in parts for robot in part.robots)
        return cls(tuple(robots), tuple(sensor for part in parts for sensor in part.sensors))

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON or TOML, with motions by their names. Raises SlamlibError if these do not find them."""
        for robot in self.robots:
            if MOTIONS.get(name := robot.model.name) is not robot.model:
                why = f"{robot.name}: plain data has a motion by its name, and {name!r} is another one, or none"
                raise SlamlibError(f"{why}; give it a name of its own, and write slamlib.motions.MOTIONS.add(motion)")
        named = (replace(robot, motion=robot.model.name) for robot in self.robots)
        return Plain.to_dict(replace(self, robots=tuple(named)))


def pose_of(position: Numbers, euler: Numbers, name: str) -> Array:
    """Pose (7,) of a position [m] and roll, pitch, yaw [deg]."""
    angles = np.radians(finite(euler, (3,), name, "euler"))
    return np.concatenate([finite(position, (3,), name, "position"), to_quaternion(angles)])


def _listed(values: Numbers) -> str:
    """Numbers as a table shows them."""
    return ", ".join(f"{value:g}" for value in values)


def _pose_std(position: Numbers, orientation: Numbers) -> Array:
    """Standard deviations (6,) of a position [m] and an orientation [deg], three numbers each or one for all."""
    return np.concatenate([np.broadcast_to(np.asarray(s, float), (3,)) for s in (position, np.radians(orientation))])


def _mixed(values: Numbers, name: str, what: str, size: int = 6, angles: tuple[int, ...] = (3, 4, 5)) -> Array:
    """Numbers (size,), of which those at `angles` are converted from degrees to radians."""
    numbers = finite(values, (size,), name, what)
    return np.where(np.isin(np.arange(size), angles), np.radians(numbers), numbers)
