"""GPS beside landmarks, in filters that differ in what an absolute measurement does to mean and covariance.

    make absolute-measurements        # a quarter of an hour; --only NAME for one table

Two sets of seeds; all filters of a table see the same frames and the same fixes. The robot knows at first where it
stands, and its heading to some degrees. Filters:

    local              each block's own error, as in every EKF
    nothing carried    "world" at landmarks; around GPS mean and covariance are left to each block
    covariance carried around GPS the covariance follows the means, and each block still moves by itself
    world              slamlib's: around GPS the means make one rigid motion, and the covariance follows them
    half-way reset, left reset   as world, and an update of the covariance by the Jacobian of exp, or by its adjoint
    rest as it was     as world, but what is no motion of the world in the errors does not turn with it

The two resets ask what is kept over an update: with the proper reset, errors to the left and to the right are the same
filter (Ge et al. 2025), and to transform the covariance for each kind of measurement (CT-ESKF, arXiv 2511.00453) is
such a reset.

The rest of the errors is in the axes of the world (eq. ob-rest). As it was: depths along the rays that the map had
before it turned. Inverse distances do not notice, as they have no axes; Euclidean points, homogeneous ones and those
that were converted do, once a fix turns the map by many degrees.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import Any
from unittest.mock import patch

import joblib
import numpy as np

from book.experiments.consistency import by_range_and_bearing
from book.experiments.invariant_nees import known_to
from book.experiments.stored import main, plain
from book.experiments.toolbox_tour import with_options
from book.tools import layout
from slamlib.belief import Block
from slamlib.entities import Robot, State
from slamlib.evaluation.pose_errors import invariant_error, pose_nees
from slamlib.experiments.presets import PRESETS, Preset, lines, points
from slamlib.geometry.pose import Pose, adjoint, exponential
from slamlib.geometry.quaternion import left_jacobian, skew
from slamlib.kalman.linalg import Carry, left_inverse
from slamlib.landmarks import LINES, POINTS
from slamlib.manifolds import Array
from slamlib.models import model
from slamlib.records.inputs import RobotMeasurement
from slamlib.slam import Slam
from slamlib.slam import transport as transports
from slamlib.slam.snapshot import robot_view
from slamlib.slam.transport import Transport, carried, kept, told
from slamlib.slam.unobservable import directions, generators

FILE = layout.BOOK / "chapters" / "data" / "absolute_measurements.json"
SETS, RUNS, RUNS_BY_TYPE = (5000, 9000), 40, 16
FAILED = 5.0  # times its degrees of freedom: a run with a larger mean NEES
BEGUN = 5  # frames that are not counted
REST = "rest as it was"


@model(pose=Pose)
def position(pose: Array) -> Array:
    """Position [m] in space."""
    return pose[:3]


@model(pose=Pose)
def floor_position(pose: Array) -> Array:
    """Position [m] on the floor."""
    return pose[:2]


def left_jacobian_of_twists(twist: Array) -> Array:
    """Jacobian (6, 6) of the exponential of a twist, by its series of adjoints: exp(x + d) is exp(J d) exp(x)."""
    turn, shift = skew(twist[3:]), skew(twist[:3])
    small = np.block([[turn, shift], [np.zeros((3, 3)), turn]])
    term, total = np.eye(6), np.eye(6)
    for n in range(2, 30):
        term = term @ small / n
        total = total + term
    assert np.allclose(total[3:, 3:], left_jacobian(twist[3:]))
    return total


@contextmanager
def told_with_reset(by_step: Callable[[Array], Array], state: State, robot: Robot) -> Iterator[None]:
    """As slamlib's `told`, and an error that was a motion e of the world is A e afterwards, A (6, 6) by the step."""
    before, rows, free, belief = generators(state), robot.columns, directions(state), state.belief
    L, steps = left_inverse(before[rows]), []
    with told(state, robot):
        retract = belief.retraction
        assert retract is not None

        def recorded(blocks: Sequence[Block], step: Array) -> Sequence[Array]:
            steps.append(free @ L @ step[rows])
            return retract(blocks, step)

        belief.retraction = recorded
        yield
    N, T = generators(state), np.eye(belief.size)
    T[:, rows] += N @ (free.T @ by_step(steps[-1]) @ free - np.eye(len(L))) @ left_inverse(N[rows])
    blocks = dict(enumerate(belief.blocks))
    belief.overwrite(blocks, {i: block.mean for i, block in blocks.items()}, T @ belief.matrix @ T.T)


def adjoint_of(twist: Array) -> Array:
    """Adjoint (6, 6) of the motion that a twist makes."""
    return adjoint(exponential(twist))


@contextmanager
def followed(state: State, robot: Robot) -> Iterator[None]:
    """The covariance follows the means as by slamlib's `told`; each block moves by itself."""
    with told(state, robot):
        state.belief.retraction = None
        yield


@contextmanager
def rest_as_it_was(state: State, robot: Robot) -> Iterator[None]:
    """As slamlib's `told`, but what is no motion of the world in the errors stays in the axes of the old one."""
    before, rows = generators(state), robot.columns
    L = left_inverse(before[rows])
    with told(state, robot):
        state.belief.transport = lambda: Carry(rows, generators(state) - before, L)
        yield


FILTERS = {
    "local": ("local", Transport()),
    "nothing carried": ("world", Transport(carried, kept)),
    "covariance carried": ("world", Transport(carried, followed)),
    REST: ("world", Transport(carried, rest_as_it_was)),
    "world": ("world", Transport(carried, told)),
    "half-way reset": ("world", Transport(carried, partial(told_with_reset, left_jacobian_of_twists))),
    "left reset": ("world", Transport(carried, partial(told_with_reset, adjoint_of))),
}


def nees_of(slam: Slam, truth: Array) -> tuple[float, float, Array]:
    """NEES of the first robot in the linear error and in the invariant one, and the linear error (f,)."""
    own = slam.robots[0]
    P, free, e = robot_view(slam.belief, own).pose_covariance, own.motion.free, Pose.minus(truth, own.pose)
    return pose_nees(e, P, free)[0], pose_nees(invariant_error(truth, own.pose), P, free)[0], free.T @ e


def one_run(preset: Preset, name: str, every: int, sigma: float, seed: int) -> list[float]:
    """Of one run: mean NEES linear and invariant, mean square position error [m^2], heading error at the end [rad]."""
    error, transport = FILTERS[name]
    # By the module: a worker gets a copy of a dictionary that is named here.
    with patch.dict(transports.TRANSPORTS, {error: transport}):
        preset = replace(with_options(preset, error=error), seed=seed)
        slam, rng, e = preset.slam(), np.random.default_rng([4, seed]), np.zeros(6)
        rows: list[list[float]] = []
        fix, place = (floor_position, 2) if slam.robots[0].motion.pose_of else (position, 3)
        for frame, truth in preset.simulate():
            if frame.number % every == 0:
                z = fix(truth.poses[0])
                z, R = z + sigma * rng.standard_normal(len(z)), sigma**2 * np.eye(len(z))
                frame = replace(frame, absolute=(RobotMeasurement("gps", fix, z, R),))
            slam.step(frame)
            if frame.number > BEGUN:
                linear, own, e = nees_of(slam, truth.poses[0])
                rows.append([linear, own, float(e[:place] @ e[:place])])
    return [*np.mean(rows, axis=0), float(e[-1])]


def spread(values: Array) -> list[float]:
    """Mean, its standard error, and median."""
    return [values.mean(), values.std(ddof=1) / len(values) ** 0.5, float(np.median(values))]


def table(preset: Preset, names: tuple[str, ...], every: int, sigma: float, runs: int, jobs: int = 2) -> dict[str, Any]:
    """By filter and set of seeds: spreads of both NEES, rms of all runs and of the median [m], heading [deg]."""
    found: dict[str, Any] = {}
    dof = preset.rig.dof[0]
    for name in names:
        for first in SETS:
            seeds = range(first, first + runs)
            one = joblib.delayed(one_run)
            rows = np.array(joblib.Parallel(n_jobs=jobs)(one(preset, name, every, sigma, seed) for seed in seeds))
            linear, own, squares, heading = rows.T
            found.setdefault(name, {})[str(first)] = said = plain({
                "linear": spread(linear), "invariant": spread(own), "rms": np.sqrt(squares.mean()),
                "median rms": np.sqrt(np.median(squares)), "heading": np.degrees(np.sqrt((heading**2).mean())),
                "failed": (own > FAILED * dof).mean(), "first": rows[0],
            })  # fmt: skip
            print(name, first, {key: said[key] for key in said if key != "first"}, flush=True)
    return {"dof": dof, "runs": runs, **found}


def unsure(preset: Preset, degrees: float, frames: int) -> Preset:
    """The preset with its heading known to these degrees at first."""
    return replace(known_to(preset, 0.0, 0.0, float(degrees)), frames=frames)


def in_space(degrees: float) -> Preset:
    """Points by range and bearing, without a gate."""
    base = replace(with_options(points(), reproject=False, gate=1.0), noise_in="truth")
    return unsure(by_range_and_bearing(base), degrees, 200)


def in_plane(degrees: float) -> Preset:
    """The world of five minutes."""
    return unsure(PRESETS["five_minutes"](), degrees, 160)


def of_type(name: str) -> Preset:
    """A parametrization in its preset, 60 frames, the heading known to 20 degrees."""
    base = points() if name in POINTS else lines()
    base = replace(with_options(base, reproject=False), noise_in="truth")
    own = by_range_and_bearing(base) if name == "eucPnt" else with_options(
        base, **{"points" if name in POINTS else "lines": name}
    )  # fmt: skip
    return unsure(own, 20, 60)


def parts() -> dict[str, Callable[[], Any]]:
    """All tables by name."""
    in_order = tuple(FILTERS)
    space = {f"space, {d:g} degrees": partial(table, in_space(d), in_order, 10, 0.3, RUNS) for d in (5, 20)}
    plane = {
        f"plane, {d} degrees, every {every}": partial(table, in_plane(d), in_order[:5], every, 0.5, RUNS)
        for d, every in ((5, 10), (20, 10), (20, 2))
    }
    kinds = [name for name in sorted(POINTS) if not POINTS[name].plane] + sorted(LINES)
    types = {name: partial(table, of_type(name), ("local", REST, "world"), 5, 0.1, RUNS_BY_TYPE) for name in kinds}
    return {**space, **plane, **types, **of_the_rest()}


def of_the_rest() -> dict[str, Callable[[], Any]]:
    """Tables of what the rest of the errors does: types whose points are converted, and controls of one of them."""
    both, one = (REST, "world"), of_type("idpPnt")
    converted = {f"{n}, fixes of 0.1 m": partial(table, of_type(n), both, 5, 0.1, RUNS) for n in ("idpPnt", "hmgPnt")}
    controls = {
        "fixes of 0.3 m": (one, both),
        "fixes of 0.3 m, not converted": (with_options(one, convert=False), both),
        "fixes of 0.3 m, start known": (unsure(of_type("idpPnt"), 0, 60), both[:1]),
        "fixes of 0.3 m, second order": (with_options(one, second_order="variance"), both[:1]),
    }
    weak = {f"idpPnt, {n}": partial(table, p, names, 5, 0.3, RUNS) for n, (p, names) in controls.items()}
    return {**weak, **converted}


if __name__ == "__main__":
    main(FILE, parts(), __doc__, resumable=True)
