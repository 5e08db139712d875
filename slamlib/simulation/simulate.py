"""A run of robots in a world: frames for the filter, and the truth beside them."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from slamlib.data.records import Frame, Truth, World
from slamlib.data.setup import Rig
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.simulation.draws import streams
from slamlib.simulation.faults import Faults
from slamlib.simulation.robots import NOISE_IN, SimulatedRobot, plans
from slamlib.simulation.sensors import SimulatedSensor


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
    count, seen = len(rig.robots), world if occlusion else World(world.features)
    own = streams(rng, count + len(rig.sensors))
    planned = zip(rig.robots, plans(controls, rig.robots, frames), own[:count], strict=True)
    robots = [SimulatedRobot(setup, plan, NOISE_IN[noise_in], stream) for setup, plan, stream in planned]
    sensors = [
        SimulatedSensor(setup, seen, faults, minimum_length, stream)
        for setup, stream in zip(rig.sensors, own[count:], strict=True)
    ]
    return (_frame(number, float(dt), robots, sensors) for number in range(1, int(frames) + 1))


def _frame(number: int, dt: float, robots: list[SimulatedRobot], sensors: list[SimulatedSensor]) -> tuple[Frame, Truth]:
    """All robots move, then all sensors look."""
    controls = tuple(robot.move(number, dt) for robot in robots)
    scans = tuple(sensor.scan(robots[sensor.robot].state[:7]) for sensor in sensors)
    truth = Truth(tuple(r.state for r in robots), tuple(s.extrinsics for s in sensors))
    return Frame(number, dt, controls, scans), truth
