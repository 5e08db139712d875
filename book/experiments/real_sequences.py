"""`make real-sequences`: the filter on every public recording that is below SLAMLIB_DATA, by defaults; figures stored.

`slamlib datasets` lists the recordings. Pictures are run as `slamlib run images` and `slamlib run stereo-images` do it,
numbered landmarks by slambook.recordings; all beside their data at once. What is not here is skipped; what is stored
is not run again, unless --only names it. Positions are stored where the licence allows it, or where they are our own.
"""

import argparse
import json
import sys
import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from slambook import recording_runs, recordings
from slambook.smoothing import Smoother
from slambook.stereo_films import EUROC_CAMERAS

from book.experiments import real_images, street_tracks
from book.experiments.stored import plain
from book.tools import layout
from slamlib.cli import COMMANDS, parser
from slamlib.cli.images import ImageCommand
from slamlib.datasets.calibrations import read_lens
from slamlib.datasets.public import VARIABLE, data_folder, public_recordings
from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.comparison import compared
from slamlib.evaluation.trajectory import Trajectory, associate, read_trajectory
from slamlib.experiments.progress import progress
from slamlib.geometry import quaternion
from slamlib.vision.considered import Errors, single_errors
from slamlib.vision.results import summary
from slamlib.vision.sequence_run import SequenceRun

FILE = layout.BOOK / "chapters" / "data" / "real_sequences.json"
SHIPPED = ("tum-fr1-xyz", "tum-fr1-rpy")  # whose positions may be handed on (CC BY 4.0)
POINTS = 160  # of a path, as it is stored
HALF = "258.65 258.25 159.05 127.4 0.2624 -0.9531 -0.0054 0.0026 1.1633"  # fr1's lens, for pictures that were halved
PAIRS = "run stereo-images", "--source"
Opened = tuple[SequenceRun, Trajectory]
Row = dict[str, Any]


def opened(*words: str, errors: Errors | None = None) -> SequenceRun:
    """The run that these words of the command `slamlib` would start, with these errors in its calibration."""
    given = parser().parse_args([*words])
    command = COMMANDS[given.command]
    assert isinstance(command, ImageCommand)
    run = command.new_run(given, errors)
    return run


def listed(folder: Path, listing: str, columns: dict[int, Path], unit: float, separator: str) -> None:
    """Lists of times and pictures, in a layout that is read, of the columns of an excerpt's own list."""
    for column, target in columns.items():
        rows = [row.split() for row in (folder / listing).read_text().splitlines() if row[0] != "#"]
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text("".join(f"{float(row[0]) * unit:.9f}{separator}{folder / row[column]}\n" for row in rows))


def tum(folder: Path, made: Path) -> Opened:
    """TUM RGB-D, or an excerpt in grey."""
    calibration = "fr1"
    if not (folder / "rgb.txt").is_file():
        listed(folder, "frames.txt", {1: made / "rgb.txt"}, 1.0, " ")
        if folder.name.endswith("rpy"):  # of half the size
            calibration = str(made / "half.txt")
            Path(calibration).write_text(HALF)
    source = folder if (folder / "rgb.txt").is_file() else made
    words = "run images", "--source", str(source), "--calibration", calibration, "--undistort"
    return opened(*words), read_trajectory(folder / "groundtruth.txt")


def cube(folder: Path, made: Path) -> Opened:
    """ViSP's cube, with the calibration and the reference of chapter monocular."""
    words = "--source", str(folder), "--calibration", str(real_images.CALIBRATION), "--fps", str(real_images.FPS)
    reference = read_trajectory(real_images.DATA / real_images.REFERENCES["structure from motion"])
    run = opened("run images", *words)
    return run, Trajectory(np.array(run.source.times), reference.poses)


def euroc(folder: Path, made: Path, errors: Errors | None = None) -> Opened:
    """EuRoC, or an excerpt."""
    if (folder / "mav0").is_dir():
        truth = read_trajectory(folder / "mav0" / "state_groundtruth_estimate0" / "data.csv")
        T = np.array(read_lens(folder / "mav0" / "cam0" / "sensor.yaml").transform).reshape(4, 4)[:3]
        turn = quaternion.from_rotation(T[:, :3], quaternion.best_pivot(T[:, :3]))
        return opened(*PAIRS, str(folder), errors=errors), truth.sensor_trajectory(np.append(T[:, 3], turn))
    listed(folder, "frames.txt", {i + 1: made / "mav0" / f"cam{i}" / "data.csv" for i in (0, 1)}, 1e9, ",")
    for i, camera in enumerate(EUROC_CAMERAS):
        (made / "mav0" / f"cam{i}" / "data").mkdir()
        (made / "mav0" / f"cam{i}" / "sensor.yaml").write_text(camera)
    return opened(*PAIRS, str(made), errors=errors), read_trajectory(folder / "groundtruth.txt")


def kitti(folder: Path, made: Path, errors: Errors | None = None) -> Opened:
    """A sequence of KITTI's odometry benchmark, or an excerpt."""
    if not (folder / "image_l").is_dir():
        run = opened(*PAIRS, str(folder), errors=errors)
        return run, read_trajectory(folder.parents[1] / "poses" / f"{folder.name}.txt", np.array(run.source.times))
    for i, side in enumerate("lr"):
        (made / f"image_{i}").symlink_to(folder / f"image_{side}")
    rows = (folder / "calib.txt").read_text().splitlines()
    (made / "calib.txt").write_text("".join(f"P{i}: {row}\n" for i, row in enumerate(rows)))
    run = opened(*PAIRS, str(made), errors=errors)
    return run, read_trajectory(folder / "poses.txt", np.array(run.source.times))


def pictures(open_it: Callable[..., Opened], stds: Errors | None = None, *noise: float) -> Callable[[Path, str], Row]:
    """What runs a sequence of pictures, and judges it. stds: of the calibration; noise: of the reference [m, deg]."""

    def run_it(folder: Path, name: str) -> Row:
        with tempfile.TemporaryDirectory() as made:
            run, reference = open_it(folder, Path(made))
            smoother, stopped, began = Smoother(run.slam), "", time.process_time()
            try:
                for step in progress(run, len(run), name):
                    with suppress(SlamlibError):  # after a gap between the pictures no further frame is recorded
                        smoother.record(step.frame)
            except SlamlibError as error:
                stopped = str(error).split(";")[0]
            spent = time.process_time() - began
            s, path = summary(run.result()), run.trajectory()
        errors = compared(path, reference, run.metric)[0]
        smooth = smoother.solve()
        row = {
            "frames": s["frames"], "of": len(run.source), "stopped": stopped, "metric": run.metric,
            "seconds": s["seconds"], "length": errors["path_length"], "ate": errors["ate"],
            "rpe": [errors["rpe"][key]["rmse"] for key in ("position", "orientation")],
            "orientation": errors["orientation_rms"], "landmarks": s["landmarks"],
            "nees": errors["nees"] and {key: errors["nees"][key] for key in ("dof", "median", "inside")},
            "matched": s["matched_share"], "inliers": s["inlier_share"],
            "frames_per_second": s["frames"] / spent,
        }  # fmt: skip
        if noise:
            paths, row["std"] = {"reference": path}, {**(stds or {}), "reference": noise}
            for label, single in single_errors(stds or {}, run).items():
                with tempfile.TemporaryDirectory() as made:
                    other, _ = open_it(folder, Path(made), single)
                    deque(progress(other, len(other), f"{name}, {label}"), maxlen=0)
                paths["considered"] = paths.get("considered", path).considering(other.trajectory())
            for key, one in paths.items():
                row["nees"][key] = compared(one, reference, run.metric, noise)[0]["nees"]["median"]
        if len(smooth.poses) == len(path):
            known = Trajectory(path.times, smooth.poses[:, 0]).sensor_trajectory(run.slam.sensors[0].extrinsics)
            best = compared(known.sensor_trajectory(run.source.original), reference, run.metric)[0]
            row["smoothing"] = {"ate": best["ate"], "converged": smooth.minimum.converged}
        i, j = associate(path, reference, max(0.02, 0.5 * run.source.interval))
        laid = align_trajectory(path[i], reference[j], scale=not run.metric)
        thin = np.unique(np.linspace(0, len(i) - 1, POINTS).astype(int))
        row |= {"times": path.times[i][thin] - path.times[0], "errors": laid.position[thin]}
        if name in (*SHIPPED, "visp-cube"):
            row |= {"path": laid.estimate.positions[thin], "reference": reference.positions[j][thin]}
        return row

    return run_it


def judged(recording: recordings.Sightings, estimate: recording_runs.Estimate) -> Row:
    """Errors of the first robot's path, and of the map."""
    return recording_runs.judged(recording, estimate) | {"map": recording_runs.judged_map(recording, estimate)}


def landmarks(read: Callable[[Path], recordings.Sightings], **others: dict[str, Any]) -> Callable[[Path, str], Row]:
    """What runs a recording of numbered landmarks, and all its data at once, and judges the estimates.

    others: by the name of a case, options of the filter in it.
    """

    def run_it(folder: Path, name: str) -> Row:
        recording = read(folder)
        row, (own, best) = recording_runs.run(recording)
        row |= judged(recording, own) | {"smoothing": judged(recording, best)}
        for name, said in others.items():
            figures, (estimate,) = recording_runs.run(recording, smooth=False, **said)
            row[name] = judged(recording, estimate) | {"inliers": figures["inliers"]}
        return row

    return run_it


def robots(folder: Path, name: str) -> Row:
    """MRCLAM: each robot alone, all in one map, and in one map with what they measure of each other."""
    whole, smooth = recordings.mrclam(folder), ("alone", "smoothing")
    together = {key: recording_runs.run(whole, key == "meetings", False) for key in ("one map", "meetings")}
    row: Row = {"met": together["meetings"][0]["met"], "robots": []}
    row |= {f"map, {key}": recording_runs.judged_map(whole, one) for key, (_, (one,)) in together.items()}
    for i in range(len(whole.truths)):
        own = recordings.mrclam(folder, (i + 1,))
        figures, both = recording_runs.run(own)
        cases = {key: recording_runs.judged(own, one) for key, one in zip(smooth, both, strict=True)}
        maps = {key: recording_runs.judged_map(own, one) for key, one in zip(smooth, both, strict=True)}
        _, (world,) = recording_runs.run(own, smooth=False, error="world")
        cases["world"] = recording_runs.judged(own, world)
        same = np.isin(np.round(together["one map"][1][0].times, 6), np.round(both[0].times, 6))
        cases |= {key: recording_runs.judged(whole, one, i, same) for key, (_, (one,)) in together.items()}
        row["robots"].append({"figures": figures, "cases": cases, "maps": maps})
    (estimate,) = together["meetings"][1]
    thin = np.unique(np.linspace(0, len(estimate.times) - 1, POINTS).astype(int))
    row["estimates"] = {"paths": [poses[thin, :2] for poses in estimate.poses]}
    row["estimates"]["points"] = [[*mean[:2], *P[[0, 0, 1], [0, 1, 1]]] for mean, P in estimate.points.values()]
    return row


RUNS: dict[str, Callable[[Path, str], Row]] = {
    "tum-fr1-xyz": pictures(tum, {}, 0.01, 0.5),
    "tum-fr1-rpy": pictures(tum, {}, 0.01, 0.5),
    "visp-cube": pictures(cube),
    "euroc-mh01": pictures(euroc, {"intrinsics": (1, 1, 1.4, 1.4), "offset": (0.1,)}, 0.002, 0.1),
    "kitti-odometry": pictures(kitti, {"intrinsics": (1, 1, 2.1, 2.1), "offset": (0.1,)}, 0.02, 0.1),
    "starry-night": landmarks(recordings.starry_night, world={"error": "world"}),
    "lost-in-the-woods": landmarks(recordings.woods, world={"error": "world"}, gated={"gate": 0.99}),
    "mrclam-6": robots,
    "kitti-07-tracks": lambda folder, name: street_tracks.figures(),
}


def found(root: Path | None) -> Iterator[tuple[str, str, Path]]:
    """Recording, name of the row, and folder; a recording of several folders, as KITTI's, has a row of each."""
    for name in RUNS:
        folders = public_recordings()[name].found(root)
        if not folders:
            print(f"{name}: not here; `slamlib datasets {name}` says where it is offered", file=sys.stderr)
        for folder in folders:
            yield name, name if len(folders) == 1 else f"{name} {folder.name}", folder


def main() -> int:
    """Run what is here and not stored, and store each at once."""
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--only", nargs="+", choices=RUNS, default=(), help="run these, and again if they are stored")
    given = words.parse_args()
    try:
        root = data_folder()
        if root is None:
            raise SlamlibError(f"set {VARIABLE} to the folder of the recordings; `slamlib datasets` lists them")
        for name, label, folder in found(root):
            rows = json.loads(FILE.read_text("utf-8")) if FILE.is_file() else {}
            if name in given.only or (label not in rows and not given.only):
                rows[label] = plain(RUNS[name](folder, name))
                text = ",\n".join(f"{json.dumps(key)}: {json.dumps(row)}" for key, row in sorted(rows.items()))
                layout.write_whole(FILE, f"{{{text}}}\n".encode())
                print(f"{label}: stored")
    except SlamlibError as error:
        print(f"real_sequences: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
