"""A run of robots in a world: frames for the filter, and the truth beside them.

Robots truly move by the same motion models as the filter's, with noise drawn into the truth or into the control.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from slamlib.data.records import Control, Frame, Truth, World
from slamlib.data.setup import Rig, RobotSetup
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.kalman.linalg import finite, numbers, read_only_copy
from slamlib.manifolds import Array
from slamlib.simulation.draws import Streams, drawn, root, streams
from slamlib.simulation.sensors import Faults, SimulatedSensor

# By name: the shares of the drawn noise in the truth, and in the control that the estimator is told.
NOISE_IN = {"truth": (1.0, 0.0), "control": (0.0, 1.0)}

Plan = Callable[[int], Array]


class SimulatedRobot:
    """A robot as it really is. Its start is drawn round the mean that the filter is told, by the setup's covariance."""

    def __init__(self, setup: RobotSetup, plan: Plan, shares: tuple[float, float], streams: Streams) -> None:
        self.motion, self.plan, self.shares, self.rng = setup.model, plan, shares, streams["control"]
        self.covariance = read_only_copy(setup.noise)
        self.root = root(setup.noise)
        self.state = read_only_copy(drawn(self.motion.manifold, setup.state, setup.covariance, streams["start"]))

    def move(self, number: int, dt: float) -> Control:
        """Go one step; the control that the estimator is told, with the noise that it is told."""
        wanted = self.plan(number)
        noise = self.root @ self.rng.standard_normal(len(self.root))
        in_truth, in_control = self.shares
        self.state = read_only_copy(self.motion.step(self.state, wanted + in_truth * noise, dt))
        return Control(wanted + in_control * noise, self.covariance)


def _plan(given: Any, robot: RobotSetup, frames: int) -> Plan:
    """From the frame's number (from 1) to the control (c,) that a robot is meant to have."""
    size = robot.model.control
    if given is None:
        nominal = robot.nominal
        return lambda number: nominal
    if callable(given):
        return lambda number: finite(given(number), (size,), robot.name, f"the control of frame {number}")
    table = numbers(given, robot.name, "controls")
    if table.ndim != 2 or len(table) < frames or table.shape[1] != size:
        raise ShapeError(f"{robot.name}: controls should have shape ({frames}, {size}) or more rows, got {table.shape}")
    table = read_only_copy(finite(table, table.shape, robot.name, "controls"))
    return lambda number: table[number - 1]


def simulate(
    rig: Rig,
    world: World,
    *,
    frames: int,
    dt: float,
    rng: np.random.Generator,
    noise_in: str = "truth",
    faults: Faults = Faults(),  # noqa: B008 - frozen
    occlusion: bool = False,
    controls: Sequence[Any] | None = None,
    minimum_length: float = 1.0,
) -> Iterator[tuple[Frame, Truth]]:
    """So many frames with their truths, one after another; dt [s] between them. Frame 1 is one motion after the start.

    noise_in: "truth": the robot is meant to follow the nominal control and does not, by a noise; the filter is told the
    nominal one. "control": the robot follows the nominal control exactly, and the noise is in what the filter is told,
    as the toolbox has it. Both have the same noise in the difference of the two, so that odometry is off by the same
    distribution to the first order; but "control" repeats one path in all runs. With constant velocity the controls are
    impulses: "truth" makes a robot that wanders, "control" one that flies straight and a filter that is told otherwise.

    controls: one entry per robot: None for the control of its setup, an array (frames, c) in metres and radians, or a
    function of the frame's number. faults: what goes wrong with the sensors. occlusion: whether the world's faces hide
    what is behind them. minimum_length [px]: of segments. The starts of the robots and the mounts of estimated sensors
    are drawn with the deviations of their setups. A measurement outside the image, noise included, is not delivered.

    The frames depend on `rng` as it is at this call, and on nothing that is done with it, or with them, afterwards.
    Raises SlamlibError at the call, not at the first frame.
    """
    if not isinstance(frames, int | np.integer) or frames < 0:
        raise SlamlibError(f"simulate: frames is a whole number, 0 or more, got {frames}")
    if not 0 < dt < np.inf:
        raise SlamlibError(f"simulate: dt is a time above zero [s], got {dt}")
    if noise_in not in NOISE_IN:
        raise UnknownNameError.of("noise_in", noise_in, NOISE_IN)
    given: Sequence[Any] = [None] * len(rig.robots) if controls is None else controls
    if len(given) != len(rig.robots):
        raise SlamlibError(
            f"controls holds one entry for each of the {len(rig.robots)} robots (None: its setup's own), got "
            f"{len(given)}; put the controls of a single robot into a list: controls=[...]"
        )
    own, seen = streams(rng, len(rig.robots) + len(rig.sensors)), world if occlusion else World(world.features)
    robots = [
        SimulatedRobot(setup, _plan(control, setup, frames), NOISE_IN[noise_in], stream)
        for setup, control, stream in zip(rig.robots, given, own, strict=False)
    ]
    sensors = [
        SimulatedSensor(setup, seen, faults, minimum_length, stream)
        for setup, stream in zip(rig.sensors, own[len(robots) :], strict=True)
    ]
    return (_frame(number, float(dt), robots, sensors) for number in range(1, int(frames) + 1))


def _frame(number: int, dt: float, robots: list[SimulatedRobot], sensors: list[SimulatedSensor]) -> tuple[Frame, Truth]:
    """All robots move, then all sensors look."""
    controls = tuple(robot.move(number, dt) for robot in robots)
    scans = tuple(sensor.scan(robots[sensor.robot].state[:7]) for sensor in sensors)
    truth = Truth(tuple(r.state for r in robots), tuple(s.extrinsics for s in sensors))
    return Frame(number, dt, controls, scans), truth
