"""Simulate robots in a world: frames for the filter, and the ground truth.

True motion follows the filter's own motion models, with noise drawn into the truth or into the control.
"""

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError, entry
from slamlib.manifolds import Array, finite, numbers, read_only_copy
from slamlib.records.inputs import Control, Frame, Truth, World
from slamlib.rigs.setup import Rig, RobotSetup
from slamlib.simulation.sensors import Faults, SimulatedSensor, Streams, drawn, root, streams
from slamlib.simulation.worlds import check_world

# By name: the shares of the drawn noise in the truth, and in the control given to the estimator.
NOISE_IN = {"truth": (1.0, 0.0), "control": (0.0, 1.0)}

Plan = Callable[[int], Array]
Given = ArrayLike | Callable[[int], ArrayLike] | None  # a robot's controls, as `simulate` takes them


class SimulatedRobot:
    """A true robot. Its start is drawn around the mean given to the filter, with the setup's covariance."""

    def __init__(self, setup: RobotSetup, plan: Plan, shares: tuple[float, float], streams: Streams) -> None:
        self.motion, self.plan, self.shares, self.rng = setup.model, plan, shares, streams["control"]
        self.covariance = read_only_copy(setup.noise)
        self.root = root(setup.noise)
        self.state = read_only_copy(drawn(self.motion.manifold, setup.state, setup.covariance, streams["start"]))

    @property
    def pose(self) -> Array:
        """Its pose (7,)."""
        return self.motion.pose(self.state)

    def move(self, number: int, dt: float) -> Control:
        """Move one step; return the control given to the estimator, with its noise covariance."""
        wanted = self.plan(number)
        noise = self.root @ self.rng.standard_normal(len(self.root))
        in_truth, in_control = self.shares
        self.state = read_only_copy(self.motion.step(self.state, wanted + in_truth * noise, dt))
        return Control(wanted + in_control * noise, self.covariance)


def _plan(given: Given, robot: RobotSetup, frames: int) -> Plan:
    """A function from the frame's number (from 1) to a robot's nominal control (c,)."""
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
    controls: Sequence[Given] | None = None,
    minimum_length: float = 1.0,
) -> Iterator[tuple[Frame, Truth]]:
    """Generate frames with their ground truth; dt [s] between them. Frame 1 is one motion after the start.

    noise_in: "truth": the robot deviates from the nominal control by the noise; the filter is given the nominal
    control. "control": the robot follows the nominal control exactly, and the noise is in the control given to the
    filter, as in the toolbox. Both have the same noise in the difference of the two, so that odometry errors have the
    same distribution to first order; but "control" repeats one path in all runs. With constant velocity the controls
    are impulses: "truth" makes a robot that wanders, "control" one that flies straight while the filter is given
    impulses.

    controls: one entry per robot: None for the control of its setup, an array (frames, c) in metres and radians, or a
    function of the frame's number. faults: rates of the sensors' faults. occlusion: whether the world's faces hide
    what is behind them. minimum_length [px]: of segments. The starts of the robots and the estimated extrinsics are
    drawn with the standard deviations of their setups. Measurements that the noise moves out of the image are dropped.

    The frames depend on `rng` as it is at this call, and on nothing that is done with it, or with them, afterwards.
    Raises SlamlibError at the call, not at the first frame.
    """
    if not isinstance(frames, int | np.integer) or frames < 0:
        raise SlamlibError(f"simulate: frames is a whole number, 0 or more, got {frames}")
    if not 0 < dt < np.inf:
        raise SlamlibError(f"simulate: dt is a time above zero [s], got {dt}")
    shares = entry("noise_in", noise_in, NOISE_IN)
    given: Sequence[Given] = [None] * len(rig.robots) if controls is None else controls
    if len(given) != len(rig.robots):
        raise SlamlibError(
            f"controls holds one entry for each of the {len(rig.robots)} robots (None: its setup's own), got "
            f"{len(given)}; put the controls of a single robot into a list: controls=[...]"
        )
    check_world(world, "simulate")
    own, seen = streams(rng, len(rig.robots) + len(rig.sensors)), world if occlusion else World(world.features)
    robots = [
        SimulatedRobot(setup, _plan(control, setup, frames), shares, stream)
        for setup, control, stream in zip(rig.robots, given, own, strict=False)
    ]
    sensors = [
        SimulatedSensor(setup, seen, faults, minimum_length, stream)
        for setup, stream in zip(rig.sensors, own[len(robots) :], strict=True)
    ]
    return (_frame(number, float(dt), robots, sensors) for number in range(1, int(frames) + 1))


def _frame(number: int, dt: float, robots: list[SimulatedRobot], sensors: list[SimulatedSensor]) -> tuple[Frame, Truth]:
    """Move all robots, then let all sensors measure."""
    controls = tuple(robot.move(number, dt) for robot in robots)
    scans = tuple(sensor.scan(robots[sensor.robot].pose) for sensor in sensors)
    states, poses = tuple(robot.state for robot in robots), tuple(robot.pose for robot in robots)
    truth = Truth(states, tuple(sensor.extrinsics for sensor in sensors), poses)
    return Frame(number, dt, controls, scans), truth
