"""The whole filter: time of a frame beside the toolbox's, of an update beside bare BLAS, of large maps, and by part.

Times are CPU times of one run with one BLAS thread; each frame is done several times and its least time counts. The
toolbox's times (Octave, no graphics, the same presets) were recorded on another machine: ours are scaled by a yardstick
of the same run, the triangular product W'W that updates 600 states with 40 measured numbers, 0.36 ms there.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import cProfile
import importlib
import importlib.util
import pstats
import time
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.covariance_update import Problem
from benchmarks.observation import YARDSTICK, quickest, yardstick
from slamlib.entities import Landmark
from slamlib.experiments.presets import Preset, preset
from slamlib.kalman.linalg import Carry, subtract_square
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.records.inputs import Frame
from slamlib.simulation.worlds import gallery_radius
from slamlib.slam import Slam
from slamlib.slam.transport import TRANSPORTS


@dataclass(frozen=True)
class Case:
    """A preset with one way of updating, the toolbox's CPU time a frame [ms] (least, most), and our goal."""

    preset: str
    landmark: str
    reproject: bool
    toolbox: tuple[float, float]
    goal: int

    @property
    def experiment(self) -> Preset:
        """The preset with these options."""
        chosen = preset(self.preset)
        field = "lines" if self.preset == "lines" else "points"
        changed: dict[str, Any] = {field: self.landmark, "reproject": self.reproject}
        return replace(chosen, options=replace(chosen.options, **changed))


CASES = [
    Case("points", "ahmPnt", True, (48, 66), 25),
    Case("points", "idpPnt", True, (53, 63), 25),
    Case("points", "ahmPnt", False, (48, 66), 50),
    Case("points", "idpPnt", False, (53, 63), 50),
    Case("lines", "idpLin", True, (164, 215), 50),
    Case("lines", "idpLin", False, (164, 215), 50),
]
PARTS = ("_predict", "project", "_update", "_delete", "_initialize")  # of a step; INNER: of _update
INNER = ("select", "match", "update_sequentially", "update_in_batch", "convert")


def frame_times(experiment: Preset, frames: list[Frame], repeats: int) -> Any:
    """Least CPU time [s] of each frame (n,), of several runs."""
    rows = []
    for _ in range(repeats):
        slam, row = experiment.slam(), []
        for frame in frames:
            start = time.process_time_ns()
            slam.step(frame)
            row.append((time.process_time_ns() - start) / 1e9)
        rows.append(row)
    return np.min(rows, axis=0)


def per_frame(repeats: int, frames: int | None = None) -> str:
    """Table 1: median time of a frame, and how many times less than the toolbox's."""
    lines = [f"{'preset, landmark, updates':32} {'ms':>6} {'scaled':>7} {'times less':>12}   goal"]
    for case in CASES:
        experiment = case.experiment
        records = [frame for frame, _ in islice(experiment.simulate(), frames)]
        unit = quickest({"yardstick": yardstick()}, 0.2)["yardstick"]
        median = float(np.median(frame_times(experiment, records, repeats))) * 1e3
        scaled = median * YARDSTICK / unit
        least, most = (t / scaled for t in case.toolbox)
        name = f"{case.preset}, {case.landmark}, {'in sequence' if case.reproject else 'batch'}"
        lines.append(f"{name:32} {median:6.2f} {scaled:7.2f} {f'{least:.0f} to {most:.0f}':>12}   {case.goal}")
    return "\n".join(lines)


def correction_times(n: int, m: int, seconds: float) -> tuple[float, float]:
    """Seconds of the bare triangular product, and of Belief.update_rows with all its checks; n states, m points."""
    problem = Problem.random(n, m)
    belief, _ = problem.belief()
    columns = np.unique(np.concatenate(problem.touched))
    W, P = 1e-9 * np.random.default_rng(1).standard_normal((2 * m, n)), problem.P.copy()
    H, R, z = problem.dense()[:, columns] * 1e-6, np.eye(2 * m), np.zeros(2 * m)
    from scipy.linalg.blas import dsyrk

    least = quickest(
        {
            "bare": partial(dsyrk, -1.0, W.T, 1.0, P.T, overwrite_c=1),
            "correct": partial(belief.update_rows, columns, H, z, R),
        },
        seconds,
    )
    return least["bare"], least["correct"]


def slope(x: Any, y: Any) -> float:
    """Exponent of a power law through points."""
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])


def large_map(landmarks: int, updates: int = 20) -> tuple[Slam, list[Frame]]:
    """A filter with so many Euclidean points in its map, all seen before, and frames that follow."""
    chosen = preset("points")
    world = (("gallery", {"n": landmarks}),)
    radius = 0.5 * gallery_radius(landmarks)  # half way, so that more than 20 are in view
    robot = replace(
        chosen.rig.robots[0], position=(0.0, -radius, 0.0), control=(0.08, 0, 0, 0, 0, np.degrees(0.08 / radius))
    )
    camera = replace(chosen.rig.sensors[0], euler=(-90.0, 0.0, 180.0))
    rig = replace(chosen.rig, robots=(robot,), sensors=(camera,))
    options = replace(chosen.options, updates=updates, reproject=False, max_new_first=0, max_new=0)
    experiment = replace(chosen, rig=rig, options=options, worlds=world, frames=30)
    slam = experiment.slam()
    _known(slam, experiment)
    return slam, [frame for frame, _ in experiment.simulate()]


def _known(slam: Slam, experiment: Preset) -> None:
    """Put every point of the world in the map, with 5 cm, as a Euclidean one."""
    points, rng = experiment.world.points, np.random.default_rng(1)
    for number, x in zip(points.ids.tolist(), points.values, strict=True):
        block = slam.belief.add(3, x + 0.05 * rng.standard_normal(3), 0.05**2)
        slam.landmarks.append(Landmark(number, EUC_POINT, block, 0))


def scaling(seconds: float) -> str:
    """Table 2: an update beside the bare product, and whole steps beside it; fitted exponents."""
    lines = [f"{'states, points':>16} {'bare ms':>8} {'update':>11} {'whole step':>11}"]
    sizes, corrections = (300, 600, 1200), []
    for n in sizes:
        bare, correct = correction_times(n, 20, seconds)
        slam, frames = large_map((n - 6) // 3)
        whole = float(np.median(_steps(slam, frames)))
        corrections.append(correct)
        lines.append(f"{f'{n}, 20':>16} {bare * 1e3:8.3f} {correct / bare:9.2f} x {whole / bare:9.2f} x")
    counts = (10, 20, 40, 80)
    many = [correction_times(1200, m, seconds)[1] for m in counts]
    lines.append(f"cost grows as states^{slope(sizes[1:], corrections[1:]):.2f} (600 to 1200, 20 points seen)")
    lines.append(f"and as landmarks^{slope(counts, many):.2f} (10 to 80 of 1200 states)")
    return "\n".join(lines)


def _steps(slam: Slam, frames: list[Frame]) -> list[float]:
    times = []
    for frame in frames:
        start = time.process_time_ns()
        slam.step(frame)
        times.append((time.process_time_ns() - start) / 1e9)
    return times


def errors(repeats: int) -> str:
    """Table 3: the measurement update of 600 states by 20 points, and whole frames, by the error that is kept."""
    lines = []
    for reproject in (True, False):
        least: dict[str, float] = {}
        for error in [*TRANSPORTS] * repeats:
            slam, frames = large_map(198)
            slam.options = replace(slam.options, reproject=reproject, error=error)
            spent = sum(_updates(slam, frames))
            least[error] = min(spent, least.get(error, spent))
        times = [f"{error} {spent / least['local']:.2f}" for error, spent in least.items() if error != "local"]
        how = "in sequence" if reproject else "batch"
        lines.append(f"update of 600 states by 20 points, {how}: times that of local: {', '.join(times)}")
    ratios = [
        f"{name} {world_in_batch(name, repeats):.2f}" for name in ("points", "omni", "stereo", "points_and_lines")
    ]
    lines.append(f"a whole frame, batch, error='world': times that of local: {', '.join(ratios)}")
    return "\n".join(lines)


def world_in_batch(name: str, repeats: int) -> float:
    """The time of all frames of a preset, updated in batch, with error="world": how many times that with "local"."""
    chosen = preset(name)
    frames, spent = [frame for frame, _ in chosen.simulate()], []
    for error in ("world", "local"):
        own = replace(chosen, options=replace(chosen.options, reproject=False, error=error))
        spent.append(float(frame_times(own, frames, repeats).sum()))
    return spent[0] / spent[1]


def _updates(slam: Slam, frames: list[Frame]) -> list[float]:
    """CPU time [s] of the measurement update of each frame, after prediction and the predicted measurements."""
    times, update = [], slam._update

    def timed(i: int, scan: Any) -> None:
        start = time.process_time_ns()
        update(i, scan)
        times.append((time.process_time_ns() - start) / 1e9)

    slam._update = timed  # type: ignore[method-assign]
    for frame in frames:
        slam.step(frame)
    return times


def thousand() -> str:
    """Table 4: steps per second with 1000 Euclidean points in the map."""
    slam, frames = large_map(1000)
    times, looked = [], []
    for frame in frames:
        start = time.perf_counter()
        slam.step(frame)
        times.append(time.perf_counter() - start)
        looked.append(sum(prediction.inlier for prediction in slam.predictions[0]))
    size, rate = f"{len(slam.landmarks)} Euclidean points ({slam.belief.size} states)", 1 / np.median(times)
    return f"{size}, {np.median(looked):.0f} inliers a step: {rate:.0f} steps per second (goal 10)"


def parts(case: Case, frames: int = 200) -> str:
    """Table 6: share of the time of a step by part."""
    experiment, profiler = case.experiment, cProfile.Profile()
    records = [frame for frame, _ in islice(experiment.simulate(), frames)]
    slam = experiment.slam()
    profiler.enable()
    for frame in records:
        slam.step(frame)
    profiler.disable()
    calls = pstats.Stats(profiler).stats.items()  # type: ignore[attr-defined]
    found = {name: row[3] for (file, _, name), row in calls if Path(file).parent.name == "slam"}
    whole = found["step"]
    outer = [f"{name.strip('_')} {found[name] / whole:.0%}" for name in PARTS]
    inner = [f"{name} {found[name] / whole:.0%}" for name in INNER if name in found]
    return f"{', '.join(outer)}; of update: {', '.join(inner)}"


def peers(seconds: float) -> str:
    """Table 5: the same update by a peer, if it is installed."""
    if importlib.util.find_spec("filterpy") is None:
        return "filterpy is not installed: skipped (pip install filterpy)"
    KalmanFilter = importlib.import_module("filterpy.kalman").KalmanFilter
    lines = []
    for n, m in ((100, 10), (300, 20), (600, 20)):
        problem, R = Problem.random(n, m), np.eye(2 * m)
        H, z = problem.dense() * 1e-6, np.zeros(2 * m)
        filter = KalmanFilter(dim_x=n, dim_z=2 * m)
        filter.P, filter.R = problem.P.copy(), R
        theirs = quickest({"filterpy": partial(filter.update, z, R, H)}, seconds)["filterpy"]
        ours = correction_times(n, m, seconds)[1]
        lines.append(f"update, {n} states, {m} points: filterpy takes {theirs / ours:.0f} times as long as slamlib")
    return "\n".join(lines)


def anchors(seconds: float) -> str:
    """Table 7: what error="anchors" adds, for k of 85 points (3 + 4 numbers), beside an update of all by 20."""
    update, times = correction_times(600, 20, seconds)[1], []
    rng, P, W = np.random.default_rng(1), np.eye(600), np.zeros((40, 600))
    world = Carry(np.arange(6), 1e-9 * rng.standard_normal((600, 3)), 1e-9 * rng.standard_normal((3, 6)))
    for k in (5, 20, 85):
        rows, F = 600 - 7 * k + np.arange(7 * k).reshape(k, 7), 1e-6 * rng.standard_normal((k, 4, 3))
        both = world._replace(following=[(rows[:, :3], rows[:, 3:], F)])
        ways = {name: partial(subtract_square, P, W, carry) for name, carry in (("world", world), ("anchors", both))}
        least = quickest(ways, seconds)
        times.append(f"{k}: {(least['anchors'] - least['world']) / update:.2f}")
    return f"anchors carried, of so many points in 600 states, times an update by 20: {', '.join(times)}"


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=3, help="runs of each preset (default 3)")
    parser.add_argument("--frames", type=int, default=None, help="frames of each run (default: all 400)")
    parser.add_argument("--seconds", type=float, default=0.5, help="CPU time spent on each update (default 0.5)")
    options = parser.parse_args()
    print(per_frame(options.repeats, options.frames), flush=True)
    print(f"\n{scaling(options.seconds)}\n\n{errors(options.repeats)}\n\n{thousand()}\n", flush=True)
    for case in CASES[:1] + CASES[2:3] + CASES[4:5]:
        print(f"{case.preset} {'in sequence' if case.reproject else 'batch'}: {parts(case)}")
    print(f"\n{anchors(options.seconds)}\n\n{peers(options.seconds)}")


if __name__ == "__main__":
    main()
