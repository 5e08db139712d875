"""The true motion of robots: the same motion models as the filter's, with noise drawn into the truth or the control."""

from collections.abc import Callable, Sequence
from typing import Any

from slamlib.data.records import Control
from slamlib.data.setup import RobotSetup
from slamlib.errors import ShapeError, SlamlibError
from slamlib.kalman.linalg import finite, numbers, read_only_copy
from slamlib.manifolds import Array
from slamlib.simulation.draws import Streams, drawn, root

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


def plans(controls: Sequence[Any] | None, robots: Sequence[RobotSetup], frames: int) -> list[Plan]:
    """For each robot a function of the frame's number (from 1) to the control (c,) that it is meant to have."""
    if controls is None:
        controls = [None] * len(robots)
    if len(controls) != len(robots):
        raise SlamlibError(
            f"controls holds one entry for each of the {len(robots)} robots (None: its setup's own), got "
            f"{len(controls)}; put the controls of a single robot into a list: controls=[...]"
        )
    return [_plan(given, robot, frames) for given, robot in zip(controls, robots, strict=True)]


def _plan(given: Any, robot: RobotSetup, frames: int) -> Plan:
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
