"""`make error-coordinates`: the right-invariant EKF beside the filters of slambook.error_coordinates and slamlib's.

The same runs for all, each in two sets of seeds: two laps of a rounded square, in the plane and in space, with noise of
three sizes, and with a start whose orientation is hardly known; the runs of chapter ekf_slam; and the drives of chapter
other_filters. All measurements of a frame are one batch update, except on the runs of ekf_slam: there one by one.
NEES of the robot in two errors: the linear one, and log(X X_hat^-1). Failed: a run whose mean NEES in that error is
above twice its degrees of freedom. Times: CPU, as ratios to the ordinary EKF's, or, of slamlib's filters, to slamlib's
ordinary one; they are compared with nothing.
"""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from slambook.error_coordinates import (
    Fej2Ekf,
    FirstEstimatesEkf,
    IteratedEkf,
    OrdinaryEkf,
    TransportEkf,
)
from slambook.invariant_ekf import (
    RANGE_BEARING,
    RANGE_YAW_PITCH,
    InvariantEkf,
    PointSensor,
    exponential,
    squared_errors,
)
from slambook.report.planar import SCANNERS, drive
from slambook.report.planar_ekf import PlanarEkf
from slambook.report.planar_invariant import PlanarFilter

from book.experiments import other_filters, stored
from book.tools import layout
from slamlib.geometry.pose2 import from_space
from slamlib.geometry.quaternion import rotation
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array
from slamlib.records.inputs import Control, Features, Frame, Scan, Truth, World
from slamlib.rigs.setup import ZERO, Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate
from slamlib.slam import Options, Slam

FILE = layout.BOOK / "chapters" / "data" / "error_coordinates.json"
COARSE = "coarse scanner"
RUNS, SEEDS = {2: 60, 3: 20}, (27, 28)  # by the dimension of the world
DRIVES, DRIVE_SEEDS = {scene: 60 if scene == COARSE else 30 for scene in SCANNERS}, other_filters.SEEDS
FRAMES, SKIPPED = 160, 5  # in the first frames the covariance of the pose is still singular
FILTERS: dict[str, type[InvariantEkf]] = {
    "EKF": OrdinaryEkf,
    "first estimates": FirstEstimatesEkf,
    "FEJ2": Fej2Ekf,
    "RI-EKF": InvariantEkf,
    "transport": TransportEkf,
}
SLAMLIB = "local", "world"  # its errors

PLACES = np.array([
    [3, -2], [7, -2.2], [9.8, 1], [9.9, 5], [7, 9.2], [3, 9.3], [-0.8, 8], [-1.5, 4.5], [1.5, 1.8], [4, 1.6], [6.5, 2],
    [7.3, 4], [6.5, 6], [4, 6.3], [1.8, 6], [0.8, 4],
])  # [m], those of chapter ekf_slam  # fmt: skip
SIDE = [(0.4, 0.0)] * 15 + [(0.4, np.radians(18))] * 5  # ahead [m] and turn [rad] of a side and a corner


@dataclass(frozen=True, eq=False)
class Setting:
    """Runs that differ by their seeds: a rig, the places of the landmarks (n, d) [m], the controls (FRAMES, c)."""

    rig: Rig
    places: Array
    controls: Array
    sensor: PointSensor

    @property
    def d(self) -> int:
        """Dimension of the world."""
        return self.places.shape[1]


def plane(
    wheels: tuple[float, float], noise: tuple[float, float], heading: float = 0.0, count: int = 8, far: float = 4.0
) -> Setting:
    """wheels: noise of a step [m] and of its turn [deg]; noise: of range [m] and bearing [deg]; heading: start's [deg].

    count landmarks, seen up to `far` [m]: of eight up to 4 m 1.7 are in view on average, of sixteen up to 6 m seven.
    """
    robot = RobotSetup(
        motion="planeOdometry", control_std=(wheels[0], 0.0, wheels[1]), orientation_std=(0.0, 0.0, heading)
    )
    std = noise[0], float(np.radians(noise[1]))
    sensor = SensorSetup(type="planeRangeBearing", name="scanner", euler=ZERO, std=std, limits={"far": far})
    controls = np.zeros((FRAMES, 3))
    controls[:, [0, 2]] = SIDE * 8
    return Setting(Rig((robot,), (sensor,)), PLACES[:count], controls, RANGE_BEARING)


def space(wheels: tuple[float, float], noise: tuple[float, float], start: float = 0.0) -> Setting:
    """As `plane`, with noise along and about all three axes; landmarks above and below; start: of its angles [deg]."""
    robot = RobotSetup(control_std=(wheels[0],) * 3 + (wheels[1],) * 3, orientation_std=(start,) * 3)
    angle = float(np.radians(noise[1]))
    limits = {"far": 5.0}
    sensor = SensorSetup(type="rangeBearing", name="scanner", euler=ZERO, std=(noise[0], angle, angle), limits=limits)
    controls = np.zeros((FRAMES, 6))
    controls[:, [0, 5]] = SIDE * 8
    heights = np.where(np.arange(len(PLACES)) % 2, 1.0, -1.0)
    return Setting(Rig((robot,), (sensor,)), np.column_stack([PLACES, heights]), controls, RANGE_YAW_PITCH)


SETTINGS = {
    "plane, 0.3 m, 3 deg": plane((0.05, 1.0), (0.3, 3.0)),
    "plane, 0.1 m, 1 deg": plane((0.05, 1.0), (0.1, 1.0)),
    "plane, 0.05 m, 0.5 deg, wheels 2 deg": plane((0.05, 2.0), (0.05, 0.5)),
    "plane, 0.05 m, 0.5 deg, wheels 2 deg, more in view": plane((0.05, 2.0), (0.05, 0.5), count=16, far=6.0),
    "plane, start known to 20 deg": plane((0.03, 0.5), (0.1, 1.0), 20.0),
    "space, 0.3 m, 3 deg": space((0.05, 1.0), (0.3, 3.0)),
    "space, 0.1 m, 1 deg": space((0.05, 1.0), (0.1, 1.0)),
    "space, start known to 5 deg": space((0.03, 0.5), (0.1, 1.0), 5.0),
}


def record(setting: Setting, seed: int) -> Iterator[tuple[Frame, Truth]]:
    """One run: frames with their truth."""
    count = len(setting.places)
    points = np.column_stack([setting.places, np.zeros((count, 3 - setting.d))])
    world = World({"points": Features(np.arange(count), points)})
    rng = np.random.default_rng(seed)
    return simulate(setting.rig, world, frames=FRAMES, dt=1.0, rng=rng, controls=[setting.controls])


def pose(state: Array) -> tuple[Array, Array]:
    """Rotation (d, d) and position (d,) of a state of slamlib's: (x, y, heading) or a pose (7,)."""
    return (exponential(state[2:], 2)[0], state[:2]) if len(state) == 3 else (rotation(state[3:]), state[:3])


def start(setting: Setting) -> tuple[Array, Array, Array, PointSensor, Array]:
    """What a filter is made of: rotation, position, their covariance, and the sensor with its noise."""
    (robot,), (sensor,), d = setting.rig.robots, setting.rig.sensors, setting.d
    R, position = pose(robot.state)
    first = [*range(d, len(robot.covariance)), *range(d)]  # the rotation; it starts without any, so its axes are one
    return R, position, robot.covariance[np.ix_(first, first)], setting.sensor, sensor.calibration.noise


def motion(setting: Setting, control: Array, covariance: Array) -> tuple[Array, Array, Array]:
    """Turn (d, d), shift (d,) and the noise of both, by a control (shift, rotation vector) whose numbers are noisy.

    exp(u + w) is, to first order, exp(V w) exp(u) with the V of u; in the plane all turns commute, and V is 1.
    """
    d = setting.d
    turn, V = exponential(control[d:], d)
    J = np.eye(len(control))
    J[d:, d:] = V if d == 3 else 1.0
    first = [*range(d, len(control)), *range(d)]
    return turn, control[:d], (J @ covariance @ J.T)[np.ix_(first, first)]


def step(filter: InvariantEkf, setting: Setting, frame: Frame) -> None:
    """One frame of a record."""
    control, seen = frame.controls[0], frame.scans[0].points
    assert control is not None
    given = dict(zip(map(int, seen.ids), seen.values, strict=True))
    filter.step(*motion(setting, control.value, control.covariance), given)


def slamlib(setting: Setting, error: str) -> Slam:
    """slamlib's own filter: all landmarks in one batch; none is out of its view when it is seen, and none deleted."""
    every: dict[str, Any] = {"max_new_first": 100, "max_new": 100, "updates": 100, "gate": 1.0, "reproject": False}
    every |= {"min_searches": FRAMES}
    (sensor,) = setting.rig.sensors
    unlimited = SensorSetup(type=sensor.type, name=sensor.name, euler=ZERO, std=sensor.std)
    return Slam(Rig(setting.rig.robots, (unlimited,)), options=Options(points="eucPnt", error=error, **every))


def as_filter(slam: Slam, setting: Setting) -> OrdinaryEkf:
    """slamlib's robot, its rotation's error taken to the world's axes, as in the filters here."""
    block = slam.robots[0].block
    R, position = pose(block.mean)
    d, C = setting.d, slam.belief.covariance(block)
    J = np.eye(len(C))
    if d == 3:
        J[d:, d:] = R
    first = [*range(d, len(C)), *range(d)]
    return OrdinaryEkf(R, position, (J @ C @ J.T)[np.ix_(first, first)], setting.sensor, np.eye(d))


Run = list[tuple[Frame, Truth]]


def run(
    setting: Setting, frames: Run, name: str, step: Callable[[InvariantEkf, Setting, Frame], None] = step
) -> tuple[Array, float]:
    """By frame: NEES in the linear error and in log(X X_hat^-1), distance [m], (n, 3); CPU time [s] of the filter."""
    found, taken = [], 0.0
    slam = slamlib(setting, name.split()[-1]) if name.startswith("slamlib") else None
    filter: InvariantEkf = OrdinaryEkf(*start(setting)) if slam else FILTERS[name](*start(setting))
    for frame, truth in frames:
        began = time.process_time()
        if slam:
            slam.step(frame)
        else:
            step(filter, setting, frame)
        taken += time.process_time() - began
        if frame.number > SKIPPED:
            view = as_filter(slam, setting) if slam else filter
            R, position = pose(truth.robots[0])
            found.append([*squared_errors(view, R, position), np.linalg.norm(position - view.x[0])])
    return np.array(found), taken


def own(by_frame: Array) -> list[float]:
    """What is kept of a run: means of NEES in both errors, and the root mean square of the distance [m]."""
    return [*by_frame[:, :2].mean(0), float(np.sqrt((by_frame[:, 2] ** 2).mean()))]


def names(setting: Setting) -> list[str]:
    """The filters that are compared; slamlib's own in space."""
    return [*FILTERS, *(f"slamlib {error}" for error in SLAMLIB if setting.d == 3)]


def seeds(number: int, runs: int) -> list[int]:
    """Of the runs of a set; a larger set begins with a smaller one."""
    return [int(seed) for seed in np.random.default_rng(number).integers(2**31, size=runs)]


def numbers(nees: Array, dof: int) -> dict[str, Any]:
    """What is said of the mean NEES of each run, (k,)."""
    error = nees.std(ddof=1) / np.sqrt(len(nees))
    return {"mean": nees.mean(), "error": error, "median": np.median(nees), "failed": np.mean(nees > 2 * dof)}


def said(by_run: list[list[float]], dof: int) -> dict[str, Any]:
    """Of `own` of each run: numbers of the NEES in both errors, rms of the position [m]; own: these, one by one."""
    linear, log, off = np.array(stored.plain(by_run)).T
    each = {"linear": linear, "log": log, "rms": off}
    return {"linear": numbers(linear, dof), "log": numbers(log, dof), "rms": np.sqrt((off**2).mean()), "own": each}


def summary(setting: Setting) -> Any:
    """By seed and filter: what is said of the runs, and the time."""
    dof, found = {2: 3, 3: 6}[setting.d], dict[str, Any]()
    for number in SEEDS:
        rows: dict[str, list[list[float]]] = {name: [] for name in names(setting)}
        times = dict.fromkeys(names(setting), 0.0)
        for seed in seeds(number, RUNS[setting.d]):
            frames = list(record(setting, seed))
            for name in rows:
                by_frame, taken = run(setting, frames, name)
                rows[name].append(own(by_frame))
                times[name] += taken
        found[str(number)] = {}
        for name, by_run in rows.items():
            unit = times["slamlib local" if name.startswith("slamlib") else "EKF"]
            found[str(number)][name] = {**said(by_run, dof), "time": times[name] / unit}
    return stored.plain(found)


CHAPTER, CHAPTER_SEEDS = 100, (0, 2000)  # runs from seeds so, as of data/plane_filters.csv
CHAPTER_FILTERS = "EKF", "first estimates", "RI-EKF", "transport"  # of one measurement FEJ2 leaves nothing


def of_chapter(seed: int) -> Run:
    """A run of chapter ekf_slam, `runs8`: simulated in space by a rig whose errors stay in the plane, and flattened."""
    angle = float(np.radians(3.0))
    robot = RobotSetup(control_std=(0.05, 0.0, 0.0, 0.0, 0.0, 1.0))
    sensor = SensorSetup("scanner", type="rangeBearing", euler=ZERO, std=(0.3, angle, angle), limits={"far": 4.0})
    points = Features(np.arange(8), np.column_stack([PLACES[:8], np.zeros(8)]))
    controls, rng = np.zeros((FRAMES, 6)), np.random.default_rng(seed)
    controls[:, FLAT] = SETTINGS["plane, 0.3 m, 3 deg"].controls
    given: dict[str, Any] = {"frames": FRAMES, "dt": 1.0, "rng": rng, "controls": [controls]}
    return [flat(*pair) for pair in simulate(Rig((robot,), (sensor,)), World({"points": points}), **given)]


FLAT = [0, 1, 5]  # ahead, to the left, turn: those of a control's six numbers


def flat(frame: Frame, truth: Truth) -> tuple[Frame, Truth]:
    """The same frame as of a robot and a sensor in the plane."""
    control, seen = frame.controls[0], frame.scans[0].points
    assert control is not None
    control = Control(control.value[FLAT], control.covariance[np.ix_(FLAT, FLAT)])
    scan = Scan({"points": Features(seen.ids, seen.values[:, :2])})
    return replace(frame, controls=(control,), scans=(scan,)), replace(truth, robots=(from_space(truth.robots[0]),))


def one_by_one(filter: InvariantEkf, setting: Setting, frame: Frame) -> None:
    """One frame of a record, the most informative measurement first: that of the largest determinant of S."""
    control, seen = frame.controls[0], frame.scans[0].points
    assert control is not None
    given = dict(zip(map(int, seen.ids), seen.values, strict=True))
    filter.predict(*motion(setting, control.value, control.covariance))
    known = [i for i in given if i in filter.rows]
    jacobians = [filter.predicted(i)[1] for i in known]
    worth = [np.linalg.det(H @ filter.P @ H.T + filter.noise) for H in jacobians]
    for k in np.argsort(worth)[::-1]:
        filter.update({known[k]: given[known[k]]})
    for i in given:
        if i not in known:
            filter.initialize(i, given[i])


def chapter() -> Any:
    """By first seed and filter: what is said of the runs of chapter ekf_slam, in its order of updates."""
    setting, found = SETTINGS["plane, 0.3 m, 3 deg"], dict[str, Any]()
    for first in CHAPTER_SEEDS:
        runs = [of_chapter(seed) for seed in range(first, first + CHAPTER)]
        found[str(first)] = {
            name: said([own(run(setting, frames, name, one_by_one)[0]) for frames in runs], 3)
            for name in CHAPTER_FILTERS
        }
    return stored.plain(found)


ON_DRIVES: dict[str, type[InvariantEkf]] = {
    "iterated": IteratedEkf,
    **{name: FILTERS[name] for name in ("first estimates", "RI-EKF", "transport")},
}


def drives(scene: str) -> Any:
    """By seed and filter, on the drives of chapter other_filters: numbers of the pose's NEES, 3 dof, and errors.

    rmse: of the position, over runs and steps [m]; map_rmse: of the landmarks at the end; inside: share of these in
    their 95 % ellipses; map_nees: their NEES, 2 dof, mean and median of the runs' means; lost: as of that file.
    """
    found: dict[str, Any] = {}
    kinds = {name: partial(PlanarFilter, kind=kind) for name, kind in ON_DRIVES.items()}
    by_log: dict[str, type[InvariantEkf]] = {"EKF": OrdinaryEkf, **ON_DRIVES}
    for number in DRIVE_SEEDS:
        filters = {"EKF": PlanarEkf, "secants": other_filters.chapter()["SecantSlam"], **kinds}
        made = other_filters.by_chapter(scene, number, DRIVES[scene], filters)
        usual = np.median(np.sqrt(made["EKF"][0].mean(1)))
        found[str(number)] = {}
        for name, (square, nees, map_square, map_nees) in made.items():
            inside = map_nees < chi2_quantile(0.95, 2)
            found[str(number)][name] = {
                "linear": numbers(nees.mean(1), 3),
                "rmse": np.sqrt(square.mean()),
                "map_rmse": np.sqrt(map_square.mean()),
                "map_median": np.median(np.sqrt(map_square.mean(1))),
                "inside": inside.mean(),
                "map_nees": {"mean": map_nees.mean(), "median": np.median(map_nees.mean(1))},
                "lost": np.mean(np.sqrt(square.mean(1)) > other_filters.LOST * usual),
                "own": {"linear": nees.mean(1), "map_rmse": np.sqrt(map_square.mean(1))},
            }
            if kind := by_log.get(name):
                logs = np.array([drive_log(scene, seed, kind) for seed in seeds(number, DRIVES[scene])])
                found[str(number)][name]["log"] = numbers(logs, 3)
    return stored.plain(found)


def drive_log(scene: str, seed: int, kind: type[InvariantEkf]) -> float:
    """Mean NEES of a drive's poses in log(X X_hat^-1)."""
    data = drive(np.random.default_rng(seed), **SCANNERS[scene])
    driven, found = PlanarFilter(data, kind), []
    for u, scan, truth in zip(data.odometry, data.scans[1:], data.truth[1:], strict=True):
        driven.step(u, scan)
        found.append(squared_errors(driven.filter, *pose(truth))[1])
    return float(np.mean(found))


PARTS: dict[str, Callable[[], Any]] = {
    "runs": lambda: {"plane": RUNS[2], "space": RUNS[3], "chapter": CHAPTER, "drives": DRIVES},
    "seeds": lambda: {"settings": list(SEEDS), "chapter": list(CHAPTER_SEEDS), "drives": list(DRIVE_SEEDS)},
    "chapter ekf_slam": chapter,
    **{name: partial(summary, setting) for name, setting in SETTINGS.items()},
    **{f"drives, {scene}": partial(drives, scene) for scene in SCANNERS},
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__, resumable=True)
