"""`make predictions`: what is left of a camera's roll that no measurement tells, and the bias of scale; stored.

Two sets of seeds each. "roll": a robot drives straight on, its camera's extrinsics are estimated (chapter many). What
is left of the roll's standard deviation by filters whose predictions carry trades by the step told, by the step made,
and by the step as the next picture tells it; by all data at once, from the curvature of its cost ("all data": that of
Gauss and Newton) and from the cost itself, with the roll held at five values ("held"). "nothing": the same on a figure
of eight, where five of six directions can be learned. "scale": one camera, whose distances come from odometry: the
scale of the path that it estimates, by the noise in the control. "exact": the same with pictures that have no noise,
where it is one number: by least squares on the steps told, by the most likely scale and steps together, and by the most
likely scale, the steps integrated out. "many measurements": preset points_and_lines, whose scale is biased, with half
of odometry's noise.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from slambook.filters_compared import poses, run
from slambook.smoothing import Smoother
from slambook.smoothing.least_squares import Factor, Minimum, Terms, Values, Variable
from slambook.trade_carried import TradeCarried, estimated_step

from book.experiments import stored
from book.tools import layout
from slamlib.experiments.monte_carlo import seeds
from slamlib.experiments.presets import Preset, points, points_and_lines, self_calibration
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.records.inputs import Control, Frame
from slamlib.rigs.setup import Rig
from slamlib.simulation import controls, simulate
from slamlib.slam import Options, Slam

FILE = layout.BOOK / "chapters" / "data" / "predictions.json"
SEEDS, RUNS, SCALE_RUNS, STEPS = (50, 51), 10, 20, 120
ROLL = 5  # the rotation about the camera's front axis, among the errors of the extrinsics
HELD = (-1.0, -0.5, 0.0, 0.5, 1.0)  # of its prior standard deviation
TIGHT = 1e-5  # [rad] by which it is held there
NOISES = (0.5, 1.0, 2.0)  # times the preset's, of the odometry

PRESET = self_calibration()
ALONE = replace(PRESET.rig.sensors[1], name="camera")  # known to 2 cm and 1.5 degrees
START = np.sqrt(np.diag(ALONE.covariance))
STRAIGHT, EIGHT = controls.straight(STEPS, 6.0), controls.figure_of_eight(STEPS, 1.5)
RIG = Rig((replace(PRESET.rig.robots[0], position=(0, 0, 0)),), (ALONE,))
BATCH = replace(PRESET.options, reproject=False)


def frames(path: Array, seed: int, noise_in: str = "control") -> list[Frame]:
    """What the robot hears along a path (n, 6)."""
    run = simulate(
        RIG,
        PRESET.world,
        frames=len(path),
        dt=0.1,
        rng=np.random.default_rng(seed),
        noise_in=noise_in,
        controls=[path],
    )
    return [frame for frame, _ in run]


def options(error: str) -> Options:
    """The preset's, one batch update a frame, with this error."""
    return replace(BATCH, error=error)


def filtered(heard: list[Frame], error: str) -> Array:
    """What is left (6,) of the standard deviations of the extrinsics, by slamlib's filter."""
    slam = Slam(RIG, options=options(error))
    for frame in heard:
        slam.step(frame)
    return left(slam)


def left(slam: Slam) -> Array:
    """What is left (6,) of the standard deviations of the extrinsics."""
    (sensor,) = slam.sensors
    assert sensor.block
    return np.asarray(np.sqrt(np.diag(slam.belief.covariance(sensor.block))) / START)


def carried(heard: list[Frame], steps: Callable[[int], Array | None]) -> Array:
    """The same, where predictions carry trades by the step of each frame's index."""
    slam = TradeCarried(RIG, options=options("world"))
    for i, frame in enumerate(heard):
        slam.step_of = lambda control, i=i: steps(i)  # type: ignore[misc]
        slam.step(frame)
    return left(slam)


def carried_twice(heard: list[Frame]) -> tuple[Array, Array]:
    """The same by steps as the next picture tells them: one filter learns the step, then another one uses it.

    Also the errors (n, 6) of these steps on the straight road.
    """
    first, second = (TradeCarried(RIG, options=options("world")) for _ in range(2))
    found = []
    for frame in heard:
        departure, control = first.robots[0].block.mean, frame.controls[0]
        assert isinstance(control, Control)
        first.step(frame)
        step = estimated_step(departure, control, first.predicted, first.belief)
        second.step_of = lambda control, step=step: step  # type: ignore[misc]
        second.step(frame)
        found.append(step)
    return left(second), np.array(found) - STRAIGHT


class RollHeld(Smoother):
    """All data at once, with the roll's error held at a number of its prior standard deviations; None: free."""

    at: float | None = None

    def _motions(self, variables: list[Variable], values: Values, loose: float = 1.0) -> list[Factor]:
        found = super()._motions(variables, values, loose)
        return found if self.at is None else [*found, self._holds(variables[1], self.at * START[ROLL])]

    def _holds(self, extrinsics: Variable, angle: float) -> Factor:
        def terms(values: Values) -> Terms:
            e, J = Pose.minus(values[extrinsics.index][0], self._start[1][0])[ROLL], np.zeros((1, 1, Pose.dof))
            J[..., ROLL] = 1 / TIGHT
            residual = np.array([[(e - angle) / TIGHT]])
            return Terms(float((residual**2).sum()), residual, [(extrinsics, np.zeros(1, dtype=int), J)])

        return terms


def smoothed(heard: list[Frame]) -> tuple[float, float]:
    """What is left of the roll by all data at once: by Gauss-Newton, and by the cost along the roll."""
    slam = Slam(RIG, options=options("world"))
    smoother = RollHeld(slam)
    for frame in heard:
        slam.step(frame)
        smoother.record(frame)
    minimum: Minimum = smoother.solve().minimum
    by_gauss = minimum.marginals(minimum.variables[1], np.zeros(1, dtype=int))[0][ROLL, ROLL]
    costs = []
    for smoother.at in HELD:
        costs.append(smoother.solve().costs[-1])
    return float(np.sqrt(by_gauss) / START[ROLL]), float(np.polyfit(HELD, costs, 2)[0] ** -0.5)


def roll(seed: int) -> dict[str, float]:
    """What is left of the roll on the straight road in one run."""
    heard = frames(STRAIGHT, seed)
    by_picture, errors = carried_twice(heard)
    told = np.array([frame.controls[0].value for frame in heard if frame.controls[0]]) - STRAIGHT
    at_once, held = smoothed(heard)
    return {
        "local": filtered(heard, "local")[ROLL],
        "step told": filtered(heard, "world")[ROLL],
        "a straight step told": filtered(frames(STRAIGHT, seed, "truth"), "world")[ROLL],
        "step made": carried(heard, lambda i: STRAIGHT[i])[ROLL],
        "step by the next picture": by_picture[ROLL],
        "all data": at_once,
        "held": held,
        "error of steps across, told [mm]": 1e3 * np.sqrt((told[:, 1:3] ** 2).mean()),
        "error of steps across, by the next picture [mm]": 1e3 * np.sqrt((errors[:, 1:3] ** 2).mean()),
    }


def nothing(seed: int) -> dict[str, Array]:
    """What is left of all six on the figure of eight: by the step told, by the step made, and if all is carried."""
    heard = frames(EIGHT, seed)
    ways = {"step told": None, "step made": lambda i: EIGHT[i], "all trades": lambda i: None}
    return {name: carried(heard, way) if way else filtered(heard, "world") for name, way in ways.items()}


def noisier(preset: Preset, times: float) -> Preset:
    """Odometry with so many times the noise."""
    robot = preset.rig.robots[0]
    robot = replace(robot, control_std=tuple(times * std for std in robot.control_std))
    return replace(preset, rig=replace(preset.rig, robots=(robot,)))


def scale(seed: int) -> dict[str, float]:
    """How much too large the path is, as a share, by the noise of odometry and where it is."""
    base = points()
    base = replace(base, options=replace(base.options, points="idpPnt", reproject=False))
    found = {}
    for noise_in, times in [*(("control", times) for times in NOISES), ("truth", NOISES[-1])]:
        true, estimated, _ = poses(replace(noisier(base, times), noise_in=noise_in, frames=200), seed, "world")
        arms, own = (p[:, 0, :3] - base.rig.robots[0].state[:3] for p in (true, estimated))
        found[f"{noise_in}, {times:g}"] = float((arms * own).sum() / (arms * arms).sum() - 1)
    return found


def many_measurements(seed: int) -> dict[str, float]:
    """Points and lines together, odometry with half the noise, in the truth: one run by the filter "world".

    Means over the steps: NEES (6 is right), that of all directions but the one away from the start (5), the error along
    this one and what is claimed of it [m].
    """
    base = points_and_lines()
    base = replace(base, options=replace(base.options, reproject=False), noise_in="truth")
    found = run(noisier(base, 0.5), seed, "world")
    error, claim = found["scale"].T
    return {
        "nees": float(found["nees"].mean()),
        "rest": float(np.nanmean(found["rest"])),
        "away": float(error.mean()),
        "claim": float(np.sqrt((claim**2).mean())),
    }


def exact(seed: int) -> dict[str, float]:
    """How much too large the scale is, as a share, where pictures tell all steps (n, 3) but for the scale.

    Told are u = x + n, of steps x of 8 cm straight ahead and 5 mm of noise; or x = u + n. The pictures' steps are y,
    and x = s y. Least squares of y = u / s; the minimum of |u - s y|^2; that of |u - s y|^2 / 2 sigma^2 - 3 n log s,
    as x = s y has a volume of s^3 for each step.
    """
    rng, n, d, variance = np.random.default_rng(seed), 400, 0.08, 0.005**2
    noise, ahead, found = rng.normal(0, np.sqrt(variance), (n, 3)), d * np.eye(3)[[0] * n], {}
    for noise_in, (u, y) in {"control": (ahead + noise, ahead), "truth": (ahead, ahead + noise)}.items():
        uu, uy, yy = (u * u).sum(), (u * y).sum(), (y * y).sum()
        found[f"{noise_in}, on the steps told"] = uu / uy - 1
        found[f"{noise_in}, with the steps"] = uy / yy - 1
        found[f"{noise_in}, alone"] = (uy + np.sqrt(uy**2 + 12 * n * variance * yy)) / (2 * yy) - 1
    return found


def runs(one: Callable[[int], dict[str, Any]], count: int) -> dict[str, Any]:
    """By set of seeds: each quantity of all its runs."""
    found = {}
    for number in SEEDS:
        rows = [one(seed) for seed in seeds(number, count)]
        found[str(number)] = {name: stored.plain([row[name] for row in rows], 5) for name in rows[0]}
    return found


PARTS = {
    "roll": lambda: runs(roll, RUNS),
    "nothing": lambda: runs(nothing, 3),
    "scale": lambda: runs(scale, SCALE_RUNS),
    "many measurements": lambda: runs(many_measurements, RUNS),
    "exact": lambda: runs(exact, 100),
}


def main() -> None:
    """Make the parts that are asked for, and store them."""
    stored.main(FILE, PARTS, __doc__, resumable=True)


if __name__ == "__main__":
    main()
