"""`make conversion`: are points converted to Euclidean ones, or left as they are? By both errors, on the same data.

Every preset whose camera begins with points that are converted later, in two sets of seeds; the film once round the
rendered room; and recordings, where they are at hand (SLAMLIB_DATA). One batch update a frame with noise in the truth,
unless a name says otherwise. Four filters a run, one after the other, so that shares of processor time can be taken:
a time belongs to a machine, a share much less. `--only NAME` makes one part again and keeps the others.
"""

import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from slambook import rendering
from slambook.stereo_films import EUROC_CAMERAS

from book.experiments import monocular, real_sequences, stored
from book.experiments.real_sequences import Opened, listed, opened
from book.experiments.toolbox_tour import theory, with_options
from book.tools import layout
from slamlib.datasets.public import data_folder, public_recordings
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.comparison import compared
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.experiments.monte_carlo import run_once, seeds
from slamlib.experiments.presets import OF_TOOLBOX, Preset, points
from slamlib.experiments.progress import progress
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.slam import Slam
from slamlib.vision.active_search import ActiveSearch
from slamlib.vision.results import summary
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.tracking_loss import TrackingLostError

FILE = layout.BOOK / "chapters" / "data" / "conversion.json"
RUNS, SEEDS = 20, (17, 18)  # of each set; the sets
ROUND, FRAMES = ("points", 400), 200  # a whole round of this preset; most frames of the others
FILMS = (1, 2, 11, 12)  # seeds
FILTERS: dict[str, dict[str, Any]] = {
    f"{said}, {error}": {"convert": convert, "error": error}
    for said, convert in (("converted", True), ("left", False))
    for error in ("local", "world")
}
FIRST, DOF = next(iter(FILTERS)), 6
LIMIT = chi2_quantile(0.95, DOF)
LIGHT = 2, 30  # runs and frames that a test makes again


def unsure(degrees: float) -> Preset:
    """`points` with a start whose orientation is known to so many degrees."""
    preset = points()
    robot = replace(preset.rig.robots[0], orientation_std=(degrees,))
    return replace(preset, rig=replace(preset.rig, robots=(robot,)))


def cases() -> dict[str, Preset]:
    """The presets by name: those of one batch update with noise in the truth; then one as the preset has it."""
    batch = {f.__name__: f() for f in OF_TOOLBOX if f().options.points not in (None, "eucPnt")}
    batch |= {f"points {name}": with_options(points(), points=name) for name in ("fhmPnt", "hmgPnt", "idpPnt")}
    batch["points, start known to 1 degree"] = unsure(1.0)
    quiet = "theory start known to 0.1 degrees"
    found = {name: replace(with_options(p, reproject=False), noise_in="truth") for name, p in batch.items()}
    found |= {"points, in sequence, noise in the control": points(), quiet: theory()[quiet]}
    longest = dict([ROUND])
    return {name: replace(p, frames=min(p.frames, longest.get(name, FRAMES))) for name, p in found.items()}


def one(preset: Preset, seed: int) -> dict[str, Any]:
    """One run: mean NEES, rms of the position's error [m], landmarks at the end, NEES by quarters; seconds of a frame.

    Of several robots the mean over all.
    """
    row = run_once(preset, seed)[1]
    nees = np.where(row["nees_dof"] == DOF, row["nees"], np.nan)
    return {
        "nees": float(np.nanmean(nees)),
        "rms": float(np.sqrt((row["errors"] ** 2).mean())),
        "landmarks": float(row["landmarks"]),
        "quarters": [float(np.nanmean(part)) for part in np.array_split(nees, 4)],
        "seconds": float(row["seconds"]),
    }


def joined(rows: list[dict[str, Any]], first: list[dict[str, Any]]) -> dict[str, Any]:
    """What is kept of the runs of one filter: each run's mean NEES and rms, and the averages of the others.

    cpu: processor time of a frame, as a share of the first filter's in the same run: the median of the runs.
    """
    kept = {name: [row[name] for row in rows] for name in ("nees", "rms")}
    means = {name: np.mean([row[name] for row in rows], axis=0) for name in ("landmarks", "quarters")}
    shares = [row["seconds"] / other["seconds"] for row, other in zip(rows, first, strict=True)]
    return {**kept, **means, "cpu": float(np.median(shares))}


def preset_runs(preset: Preset, runs: int = RUNS, frames: int | None = None) -> dict[str, Any]:
    """By the filter's name, a list of what is kept of each set of seeds."""
    found: dict[str, list[Any]] = {name: [] for name in FILTERS}
    preset = replace(preset, frames=frames or preset.frames)
    for number in SEEDS:
        rows: dict[str, list[dict[str, Any]]] = {name: [] for name in FILTERS}
        for seed in progress(seeds(number, runs), runs, f"{preset.name}, seeds {number}"):
            for name, changes in FILTERS.items():
                rows[name].append(one(with_options(preset, **changes), seed))
        for name, those in rows.items():
            found[name].append(joined(those, rows[FIRST]))
    return dict(stored.plain(found))


def numbers(sets: list[dict[str, Any]], beside: list[dict[str, Any]] | None = None) -> dict[str, float]:
    """Of several sets of runs together: mean NEES with its standard error, median, share failed; rms [m]; the rest.

    beside: of another filter: less, the mean difference of NEES from it run by run, and less_error, of that the error.
    """
    nees, rms = (np.concatenate([each[name] for each in sets]) for name in ("nees", "rms"))
    less = nees - np.concatenate([each["nees"] for each in beside or sets])
    return {
        "less": float(less.mean()),
        "less_error": float(less.std(ddof=1) / np.sqrt(len(less))),
        "mean": float(nees.mean()),
        "error": float(nees.std(ddof=1) / np.sqrt(len(nees))),
        "median": float(np.median(nees)),
        "failed": float((nees > LIMIT).mean()),
        "rms": float(np.sqrt((rms**2).mean())),
        **{name: float(np.mean([each[name] for each in sets])) for name in ("landmarks", "cpu")},
    }


def film(seed: int) -> dict[str, Any]:
    """Once round the rendered room: by the filter's name ATE [%], landmarks at the end, and share of processor time."""
    way = rendering.path("round")
    rig = rendering.rig_along_path(way, std=(0.1,), control_std=(0.03,) * 3 + (1.2,) * 3)
    shown = rendering.film(
        rendering.default_room("drawn"),
        rig,
        way,
        frames=monocular.ROUND,
        dt=monocular.ROUND_DT,
        rng=np.random.default_rng(seed),
    )
    steps, first = list(shown), 0.0
    found: dict[str, Any] = {}
    times = monocular.ROUND_DT * np.arange(len(steps), dtype=float)
    true = Trajectory(times, np.array([truth.poses[0] for _, truth in steps]))
    for name, changes in FILTERS.items():
        search = ActiveSearch(rig.sensors[0].calibration, np.random.default_rng([seed, 1]))
        slam, poses = Slam(rig, options=replace(monocular.OPTIONS, **changes), front_ends=[search]), []
        began = time.process_time()
        for frame, _ in steps:
            slam.step(frame)
            poses.append(slam.robots[0].pose.copy())
        spent = time.process_time() - began
        first = first or spent
        off = 100 * align_trajectory(Trajectory(times, np.array(poses)), true).relative_ate
        found[name] = {"off": off, "landmarks": len(slam.landmarks), "cpu": spent / first}
    return dict(stored.plain(found))


def left_camera(folder: Path, made: Path) -> Opened:
    """EuRoC's left camera alone, in an excerpt."""
    listed(folder, "frames.txt", {1: made / "mav0" / "cam0" / "data.csv"}, 1e9, ",")
    (made / "mav0" / "cam0" / "data").mkdir()
    (made / "mav0" / "cam0" / "sensor.yaml").write_text(EUROC_CAMERAS[0])
    calibration = str(made / "mav0" / "cam0" / "sensor.yaml")
    run = opened("run images", "--source", str(made), "--calibration", calibration, "--undistort")
    return run, read_trajectory(folder / "groundtruth.txt")


Open = Callable[[Path, Path], Opened]
# What is run of the recordings: how it is opened, and which errors its reference has [m, deg].
BY_ONE: dict[str, tuple[str, Open, tuple[float, float]]] = {
    "tum-fr1-xyz": ("tum-fr1-xyz", real_sequences.tum, (0.01, 0.5)),
    "tum-fr1-rpy": ("tum-fr1-rpy", real_sequences.tum, (0.01, 0.5)),
    "euroc-mh01, left camera": ("euroc-mh01", left_camera, (0.002, 0.1)),
    "visp-cube": ("visp-cube", real_sequences.cube, (0.0, 0.0)),
}
BY_PAIRS: dict[str, tuple[str, Open, tuple[float, float]]] = {
    "kitti-odometry, pairs": ("kitti-odometry", real_sequences.kitti, (0.02, 0.1)),
    "euroc-mh01, pairs": ("euroc-mh01", real_sequences.euroc, (0.002, 0.1)),
}
PAIR_FILTERS = {"eucPnt": {"points": "eucPnt"}} | {
    f"idpPnt, {name}": {"points": "idpPnt", **changes} for name, changes in FILTERS.items() if "world" in name
}
PAIR_FRAMES = 30


def judged(run: SequenceRun, reference: Trajectory, noise: tuple[float, float], most: int | None) -> dict[str, Any]:
    """One run on pictures: ATE [m, or the reference's unit], orientation [deg], median NEES, landmarks; seconds.

    states: degrees of freedom at the end. stopped: why it did not come to its end.
    """
    stopped, began = "", time.process_time()
    try:
        deque(progress(islice(run, most), most or len(run), "pictures"), maxlen=0)
    except TrackingLostError as error:
        stopped = str(error).split(";")[0]
    spent, path, said = time.process_time() - began, run.trajectory(), summary(run.result())
    errors = compared(path, reference, run.metric, noise)[0]
    numbers = {"ate": errors["ate"], "orientation": errors["orientation_rms"], "frames": said["frames"]}
    nees = errors["nees"]["median"] if errors["nees"] else None
    counts = {"nees": nees, "landmarks": said["landmarks"], "states": run.slam.belief.size}
    return {**numbers, **counts, "stopped": stopped, "seconds": spent}


def recording(
    name: str,
    open_it: Open,
    noise: tuple[float, float],
    filters: Mapping[str, dict[str, Any]],
    most: int | None = None,
) -> dict[str, Any] | None:
    """By the filter's name what `judged` says, with the share of the first one's time; None: it is not at hand."""
    folders = public_recordings()[name].found(data_folder())
    if not folders:
        return None
    found: dict[str, Any] = {}
    for label, changes in filters.items():
        with tempfile.TemporaryDirectory() as made:
            run, reference = open_it(folders[0], Path(made))
            run.slam.options = replace(run.slam.options, **changes)
            found[label] = judged(run, reference, noise, most)
    first = next(iter(found.values()))["seconds"]
    for row in found.values():
        row["cpu"] = row.pop("seconds") / first
    return dict(stored.plain(found))


PARTS: dict[str, Callable[[], Any]] = {
    "light": lambda: preset_runs(cases()["points"], *LIGHT),
    **{name: partial(preset_runs, preset) for name, preset in cases().items()},
    **{f"film {seed}": partial(film, seed) for seed in FILMS},
    **{name: partial(recording, *said, FILTERS) for name, said in BY_ONE.items()},
    **{name: partial(recording, *said, PAIR_FILTERS, PAIR_FRAMES) for name, said in BY_PAIRS.items()},
}


def tables(kept: Mapping[str, Any]) -> Iterator[str]:
    """The figures of a file, in words and columns."""
    for name in (name for name in cases() if name in kept):
        yield name
        for label, sets in kept[name].items():
            n = numbers(sets, kept[name][FIRST])
            quarters = " ".join(f"{q:.1f}" for q in np.mean([each["quarters"] for each in sets], axis=0))
            each = " ".join(f"{np.mean(one['nees']):.2f}" for one in sets)
            yield (
                f"  {label:18} {n['mean']:6.2f} +- {n['error']:.2f} ({each}), less {n['less']:+.2f} +- "
                f"{n['less_error']:.2f}, median {n['median']:.2f}, failed "
                f"{n['failed']:.0%}, rms {1e3 * n['rms']:.1f} mm, {n['landmarks']:.1f} landmarks, cpu {n['cpu']:.2f}; "
                f"quarters {quarters}"
            )
    for name in (name for name in (*BY_ONE, *BY_PAIRS) if name in kept):
        yield name
        for label, row in kept[name].items():
            yield f"  {label:26} {', '.join(f'{key} {value}' for key, value in row.items())}"
    films = [row for name, row in kept.items() if name.startswith("film ")]
    for label in FILTERS if films else ():
        off, landmarks, cpu = ([row[label][key] for row in films] for key in ("off", "landmarks", "cpu"))
        yield f"films {label:18} ATE {off} %, mean {np.mean(off):.3f}; landmarks {np.mean(landmarks):.0f}; cpu {cpu}"


if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__, resumable=True)
    print("\n".join(tables(stored.kept(FILE))))
