"""EKF-SLAM on KITTI's street against visual odometry alone, in the same run, by KITTI's measure.

The street is frames 0 to 50 of sequence 06 of KITTI's odometry benchmark, 51 rectified pairs, almost straight, 59.9 m.
It is not shipped, as its licence is for non-commercial use: slambook.kitti_street finds it below SLAMLIB_DATA. Errors
are means over all parts of 5, 10, ..., 40 m: of the translation, in per cent of the part's length, and of the rotation,
in degrees a metre. ATE: root mean square of the distances [m] after a rigid motion, whose rotation is that of the
orientations: then it is theirs that ATE shows, too.

1. The calibration. A disparity that is wrong by a constant makes all steps too long or too short. Without the truth,
   the pictures show it by how well matches agree with their motion: z' S^-1 z by its degrees of freedom, and how many
   agree.
2. Odometry alone against the filter, with the constant that the pictures chose.
3. The reference. Its camera's frame was calibrated too: a rotation of it against the real one (or a wrong principal
   point) is the same error over each part, however good the estimate is. It is estimated from the mean direction of
   the steps, and removed.
4. NEES, by which the reference is judged, too, and the calibration. In its first twelve pairs the reference turns at a
   constant rate: it is interpolated there, and the runs begin after them. An offset of disparities that is known to
   CHOSEN only is a considered parameter: what it does to the path is the difference of two runs.
"""

import argparse
import json
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from slambook import kitti_street
from slambook.smoothing import Smoother

from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.sources import of_pictures
from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.comparison import compared, parts
from slamlib.evaluation.trajectory import Trajectory
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import relative
from slamlib.geometry.quaternion import exponential, logarithm
from slamlib.manifolds import Array
from slamlib.vision.opening import PAIRS, open_stereo, stereo_run
from slamlib.vision.results import summary
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.stereo import MOTION_SOURCES, StereoSettings

OFFSETS = (-0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
CHOSEN = 0.2
# For all variants, odometry alone too: twice as many features as by default, since few of a street are found again.
FEATURES: dict[str, Any] = {"per_cell": 10, "min_strength": 50.0, "ratio": 0.95, "distance": 80}
# What was not seen for 8 pairs lies behind the car. "correlated" leaves more of the features to the odometry.
WAYS: dict[str, dict[str, Any]] = {
    "constant-velocity": {
        "settings": {"max_in_view": 150, "max_backoff": 1},
        "options": {"max_new": 60, "updates": 150, "max_new_first": 150, "window": 8},
        "impulse": (0.1, 1.0),  # twice a car's on this street: 0.04 m/s and 0.6 degrees/s in 0.1 s
    },
    "split-features": {
        "settings": {"max_in_view": 150},
        "options": {"max_new": 60, "updates": 150, "max_new_first": 150, "window": 8},
    },
    "correlated": {"settings": {"max_in_view": 60}, "options": {"max_new": 30, "window": 8}},
}
INTERPOLATED = 12  # pairs, until the reference turns as a car does
REFERENCE = (0.02, 0.1)  # [m], [degrees]: resolution of its sensor (Geiger and others 2013)
HEAD = (
    f"{'':16} translation (5 to 40 m)     rotation         ATE   orient.   matches (least) NIS/dof  searched    ms/pair"
)
ALONE, ALL_DATA = "odometry alone", "all data at once"
AT_ONCE = "split-features"  # the way whose measurements are taken all at once, too


def street() -> tuple[ImageSource, dict[str, Any], Trajectory]:
    """The pairs, in memory, their camera, and the true path. Raises SlamlibError where they are not at hand."""
    files = kitti_street.needed()
    left, right, calibration = (str(file) for file in (files.left, files.right, files.calibration))
    source, camera, _ = open_stereo(left=left, right=right, calibration=[calibration], fps=kitti_street.FPS)
    part = source.part(count=kitti_street.PAIRS)
    pairs = list(progress(part, len(part), "reading"))
    return of_pictures(pairs, source.interval), camera, kitti_street.truth(files)


def errors(path: Trajectory, truth: Trajectory) -> dict[str, float]:
    """Of a path: shares, degrees a metre, metres, degrees."""
    found, whole = parts(path, truth), align_trajectory(path, truth, scale=False, rotation_from="orientations")
    assert found is not None
    return {
        "translation": found["translation_mean"],
        "rotation": found["rotation_mean"],
        "ate": whole.ate,
        "orientation": float(np.degrees(np.sqrt((whole.orientation**2).mean()))),
        "shortest": found["translation"][0],
        "longest": found["translation"][-1],
    }


def offsets(source: ImageSource, camera: dict[str, Any], truth: Trajectory) -> Iterator[dict[str, float]]:
    """Odometry with constants added to all disparities."""
    for offset in OFFSETS:
        run = stereo_run(source, camera, motion_source="odometry", settings=StereoSettings(offset=offset, **FEATURES))
        r = finished(f"offset {offset}", run).result()
        yield {
            "offset": offset,
            "fit": float(r.nis.sum() / r.nis_dof.sum()),
            "matches": int(r.inliers.sum()),
            "length": float(r.trajectory.distances[-1] / truth.distances[-1]),
            **errors(run.trajectory(), truth),
        }


def runs(
    source: ImageSource, camera: dict[str, Any], offset: float, names: list[str]
) -> Iterator[tuple[str, SequenceRun]]:
    """Odometry alone, and each variant of the filter."""
    yield (
        ALONE,
        stereo_run(source, camera, motion_source="odometry", settings=StereoSettings(offset=offset, **FEATURES)),
    )
    for name in names:
        way = WAYS[name]
        settings = StereoSettings(offset=offset, **FEATURES, **way["settings"])
        options = replace(PAIRS.options, **way["options"])
        impulse = way.get("impulse")
        yield name, stereo_run(source, camera, options, motion_source=name, settings=settings, impulse=impulse)


def done(name: str, run: SequenceRun, truth: Trajectory, smoother: Smoother | None = None) -> dict[str, float]:
    """Run one variant and return its figures."""
    began = time.process_time()
    finished(name, run, smoother)
    spent = (time.process_time() - began) / len(run.history)
    s = summary(run.result())
    told = {"matches": s["tracked_mean"], "tracked_least": s["tracked_least"], "fit": s["nis_per_dof"]}
    predictions = float(run.result().inliers.sum() / s["initialized"]) if s["initialized"] else 0.0
    return {**errors(run.trajectory(), truth), **told, "looks": predictions, "milliseconds": 1e3 * spent}


def figures(offset: float = CHOSEN, names: list[str] | None = None) -> dict[str, Any]:
    """All tables as plain data; the street must be at hand."""
    source, camera, truth = street()
    found: dict[str, Any] = {"pairs": len(source), "path": float(truth.distances[-1]), "offset": offset}
    found["offsets"] = list(offsets(source, camera, truth))
    for key, value in (("plain", 0.0), ("corrected", offset)):
        all_of_them = dict(runs(source, camera, value, names or list(WAYS)))
        smoothers = {name: Smoother(run.slam) for name, run in all_of_them.items() if name == AT_ONCE}
        found[key] = {name: done(name, run, truth, smoothers.get(name)) for name, run in all_of_them.items()}
        known = {name: run.trajectory() for name, run in all_of_them.items()}
        for name, smoother in smoothers.items():
            known[ALL_DATA] = at_once(all_of_them[name], smoother)
            found[key][ALL_DATA] = errors(known[ALL_DATA], truth)
    turns = {name: constant_turn(path, truth) for name, path in known.items()}
    found["turns"] = {name: float(np.degrees(2 * np.linalg.norm(turn[4:]))) for name, turn in turns.items()}
    for key, of in (("turned", lambda name: ALONE), ("turned_each", lambda name: name)):
        found[key] = {name: errors(path, truth.sensor_trajectory(turns[of(name)])) for name, path in known.items()}
    found["turning"] = turning(truth)
    later = source.part(INTERPOLATED)
    both = [dict(runs(later, camera, o, names or list(WAYS))) for o in (0.0, offset)]
    paths = [{name: finished(name, run).trajectory() for name, run in part.items()} for part in both]
    found["nees"] = {name: nees(path, paths[1][name], truth) for name, path in paths[0].items()}
    return found


def at_once(run: SequenceRun, smoother: Smoother) -> Trajectory:
    """The path of a run that has been done, by all the measurements that its smoother heard, without covariances."""
    poses, extrinsics = smoother.solve().poses[:, 0], run.slam.sensors[0].extrinsics
    path = Trajectory(run.trajectory().times, poses).sensor_trajectory(extrinsics)
    return path.sensor_trajectory(run.source.original)


def finished(name: str, run: SequenceRun, smoother: Smoother | None = None) -> SequenceRun:
    """The run, done; a smoother, made before its first pair, hears it."""
    for step in progress(run, len(run), name):
        if smoother is not None:
            smoother.record(step.frame)
    return run


def turning(truth: Trajectory) -> list[float]:
    """How much the reference's turn changes from step to step [degrees, rms]: first, and after INTERPOLATED pairs."""
    turns = logarithm(relative(truth.poses[:-1], truth.poses[1:])[:, 3:])
    changes = np.degrees(np.linalg.norm(np.diff(turns, axis=0), axis=1))
    return [float(np.sqrt((part**2).mean())) for part in (changes[: INTERPOLATED - 2], changes[INTERPOLATED:])]


def nees(path: Trajectory, shifted: Trajectory, truth: Trajectory) -> list[float]:
    """Medians of NEES, 6 dof: by the path's covariances; with those of the reference; with its camera turned as in 3;
    and with the disparities' offset considered. shifted: the path with all disparities larger by its deviation."""
    considered = path.considering(shifted)
    turned = truth.sensor_trajectory(constant_turn(path, truth[INTERPOLATED:]))
    known = ((path, truth), (path, turned), (considered, turned))
    judged = [(path, truth, (0.0, 0.0)), *((p, there, REFERENCE) for p, there in known)]
    return [compared(p, there, True, noise)[0]["nees"]["median"] for p, there, noise in judged]


def constant_turn(estimate: Trajectory, truth: Trajectory) -> Array:
    """Pose (7,), a turn alone, of the real camera in the reference's: from the directions of all steps together."""
    found, true = (relative(t.poses[:-1], t.poses[1:])[:, :3].sum(0) for t in (estimate, truth))
    axis = np.cross(found / np.linalg.norm(found), true / np.linalg.norm(true))
    size = np.linalg.norm(axis)
    return np.concatenate([np.zeros(3), exponential(axis / size * np.arcsin(size))])


def tables(found: dict[str, Any]) -> Iterator[str]:
    """The figures as printed tables."""
    yield f"KITTI's street: {found['pairs']} pairs, {found['path']:.1f} m\n"
    yield "offset [px]  z'S^-1z/dof  agreeing matches  |  length by the true one  translation"
    for o in found["offsets"]:
        yield (
            f"{o['offset']:11.1f} {o['fit']:12.4f} {o['matches']:17d}  | {o['length']:23.4f} {o['translation']:12.3%}"
        )
    for key, text in (
        ("plain", "the calibration as it is"),
        ("corrected", f"offset {found['offset']} px"),
        ("turned", "the same, the reference's camera turned as odometry alone says"),
        ("turned_each", "the same, turned for each as it says itself"),
    ):
        yield f"\n{text}\n{HEAD}"
        for name, e in found[key].items():
            told = (
                f"{e['matches']:7.0f} ({e['tracked_least']:2d}) {e['fit']:8.2f} "
                f"{e['looks']:11.1f} {e['milliseconds']:8.0f}"
                if "fit" in e
                else f"turned by {found['turns'][name]:.2f} deg" * (key == "turned_each")
            )
            yield (
                f"{name:16} {e['translation']:8.3%} ({e['shortest']:.2%} to {e['longest']:.2%}) "
                f"{e['rotation']:8.4f} deg/m {e['ate']:6.3f} m {e['orientation']:6.3f} deg {told}"
            )
    first, rest = found["turning"]
    yield f"\nthe reference's turn changes by {first:.4f} degrees a step at first, and by {rest:.4f} later"
    yield f"median NEES, 6 dof, from pair {INTERPOLATED} on: alone; reference {REFERENCE}; turned; offset considered"
    for name, medians in found["nees"].items():
        yield f"{name:18}" + "".join(f"{m:10.1f}" for m in medians)


def main() -> int:
    """Print the tables, or say what is wanted; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--offset", type=float, default=CHOSEN, help=f"of the disparities [px] (default {CHOSEN})")
    parser.add_argument("--only", choices=MOTION_SOURCES, action="append", help="these ways alone")
    parser.add_argument("--json", action="store_true", help="print plain data")
    given = parser.parse_args()
    try:
        found = figures(given.offset, given.only)
    except SlamlibError as error:
        print(f"street: {error}", file=sys.stderr)
        return 2
    print(json.dumps(found, indent=2) if given.json else "\n".join(tables(found)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
