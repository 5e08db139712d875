"""EKF-SLAM on Victoria Park, four kilometres by car among trees: `python -m slambook.victoria_park FOLDER`.

The recording is that of J. Guivant and E. Nebot (IEEE Trans. Robotics and Automation 17(3), 2001): wheel speed and
steering 40 times a second, a laser scan five times a second, and fixes by GPS, which are compared with and used for
nothing else. The trees in each scan have been detected by E. Zamora; which tree is which nobody says.
"""

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from slambook.figures import colors, draw_ellipse, figure
from slambook.trees import NearestNeighbor, dead_reckoning, driven
from slamlib.errors import SlamlibError, optional
from slamlib.evaluation.consistency import rmse
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import compose
from slamlib.geometry.pose2 import in_space
from slamlib.manifolds import Array
from slamlib.plain_data.files import check_writable, complete, write_whole
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.rigs.builders import range_bearing, robot
from slamlib.slam import Options, Slam

FILES = {"victoria_park.mat": ("time", "u", "TLsr", "zt"), "aa3_gpsx.mat": ("timeGps", "La_m", "Lo_m")}
SOURCE = (
    "in github.com/ezamorag/EKFSLAM_for_Victoria_Park_Benchmark they are VictoriaParkSinSincronizar.mat (rename it to "
    "victoria_park.mat) and EKFSLAM/aa3_gpsx.mat"
)
EXAMPLES = f"""examples:
  python -m slambook.victoria_park ~/landmarks_victoria_park --svg map.svg
  python -m slambook.victoria_park --scans 500 --json result.json     # the first 100 s

FOLDER holds two files; {SOURCE}.
"""
# Of wheel speed [m/s] and steering [deg], of the average over one second: slip and the play of the steering, generous.
CONTROL_STD = (0.3, 1.0)
LASER_AT, LASER_STD, FAR = (
    (3.78, 0.5, 0.0),
    (0.3, np.radians(1.5)),
    80.0,
)  # [m] of the rear axle's middle; [m, rad]; [m]
GATE = 0.99
OPTIONS = Options(
    points="planePnt", updates=1000, max_new_first=100, max_new=100, reproject=False, gate=GATE,
    outlier_rejection="joint", min_searches=20, min_matched_ratio=0.05, min_inlier_ratio=0.3,
)  # fmt: skip
POINTS = 500  # of a path, as it is stored


@dataclass(frozen=True, eq=False)
class ParkRecording:
    """frames: one for each scan; times (n,) [s] of these; fixes (f, 3): time [s], east and north [m]."""

    frames: list[Frame]
    times: Array
    fixes: Array


def load(folder: str | Path) -> ParkRecording:
    """Read the recording. Raises SlamlibError for a file that is missing or another one, and without SciPy."""
    with complete(folder):
        park, gps = (_variables(Path(folder) / name, names) for name, names in FILES.items())
        started, ends = park["time"].ravel(), park["TLsr"].ravel()
        kept = np.flatnonzero(ends > started[0])
        # Between two scans there are eight controls. The filter gets their mean: its arc ends within 1.5 mm of theirs.
        edges = np.concatenate([started[:1], ends[kept]])
        done = np.cumsum(park["u"][:, :-1] * np.diff(started), axis=1)
        sums = np.array([np.interp(edges, started, np.concatenate([[0.0], row])) for row in done])
        steps, noise = np.diff(edges), np.diag([CONTROL_STD[0], np.radians(CONTROL_STD[1])]) ** 2
        frames = []
        for number, (i, dt, u, J) in enumerate(zip(kept, steps, *driven((np.diff(sums) / steps).T), strict=True), 1):
            distance, bearing, _ = park["zt"].ravel()[i].reshape(3, -1)
            trees = np.column_stack([distance, bearing - np.pi / 2])[distance < FAR]  # 90 degrees are straight ahead
            scan = Scan({"points": Features(np.arange(len(trees)), trees)})
            control = Control(u, J @ noise @ J.T / dt)  # of a mean: less noise where it is of a longer time
            frames.append(Frame(number, float(dt), (control,), (scan,)))
        fixes = np.column_stack([gps["timeGps"].ravel() / 1000, gps["Lo_m"].ravel(), gps["La_m"].ravel()])
        return ParkRecording(frames, ends[kept], fixes)


def _variables(path: Path, names: tuple[str, ...]) -> dict[str, Any]:
    io = optional("scipy.io", "to read MATLAB's files", "fast")
    if not path.is_file():
        raise SlamlibError(f"{path}: there is no such file; {' and '.join(FILES)} are wanted, {SOURCE}")
    try:
        found = io.loadmat(path)
    except Exception as error:  # a damaged file fails in more ways than scipy documents
        raise SlamlibError(f"{path} cannot be read as MATLAB's: {error}; {SOURCE}") from None
    return {name: found[name] for name in names}


def park_slam() -> Slam:
    """The filter: the car starts at the origin, and is sure of it."""
    limits = {"far": FAR, "bearing": np.pi / 2}
    laser = range_bearing(LASER_STD, name="laser", position=LASER_AT, limits=limits)
    return Slam(robot("unicycle", name="car"), laser, options=OPTIONS, front_ends=[NearestNeighbor(GATE)])


def run(recording: ParkRecording, scans: int | None = None) -> dict[str, Any]:
    """The filter on the first `scans` scans: figures, and to draw them `path`, `dead_reckoning`, `trees` and `gps`."""
    slam, began = park_slam(), time.perf_counter()
    times, frames, states, nis, measured = recording.times[:scans], recording.frames[:scans], [], [], 0
    for frame in progress(frames, len(times), "scans"):
        slam.step(frame)
        measured += len(frame.scans[0].points)
        states.append(slam.robots[0].block.mean)
        nis += [p.nis for p in slam.predictions[0] if p.inlier]
    seconds, laser = time.perf_counter() - began, slam.sensors[0].extrinsics
    controls = np.array([frame.controls[0].value for frame in frames])  # type: ignore[union-attr]
    odometry = dead_reckoning(controls, np.array([frame.dt for frame in frames]))
    path, by_wheels = (compose(in_space(way), laser)[:, :2] for way in (np.array(states), odometry))
    fixes = recording.fixes[(recording.fixes[:, 0] >= times[0]) & (recording.fixes[:, 0] <= times[-1])]
    if len(fixes) < 3 or not (nis and slam.landmarks):
        raise SlamlibError(f"{len(times)} scans are too few to compare with the GPS: 50 are enough")
    (off, gps), (off_by_wheels, _) = (compared(times, way, fixes) for way in (path, by_wheels))
    thin = slice(None, None, -(-len(times) // POINTS))
    trees = [(lm.block.mean, slam.belief.covariance(lm.block)) for lm in slam.landmarks]
    figures: dict[str, Any] = dict(
        scans=len(times), time=times[-1] - times[0], length=np.linalg.norm(np.diff(path, axis=0), axis=1).sum(),
        measurements=measured, used=len(nis), nis=np.mean(nis), nis_dof=2, seconds=seconds,
        landmarks=len(trees), initialized=slam.front_ends[0].landmarks,  # type: ignore[attr-defined]
        fixes=len(fixes), longest_without_fix=np.diff(fixes[:, 0]).max(), rmse=rmse(off[:, None]),
        median=np.median(off), largest=off.max(), within_5_m=(off < 5).mean(),
        dead_reckoning_rmse=rmse(off_by_wheels[:, None]),
    )  # fmt: skip
    return {name: round(float(n), 3) if isinstance(n, np.floating) else n for name, n in figures.items()} | {
        "path": np.column_stack([times, path])[thin].round(2).tolist(),
        "dead_reckoning": by_wheels[thin].round(1).tolist(),
        "trees": [[*mean.round(2).tolist(), *P[[0, 0, 1], [0, 1, 1]].round(4).tolist()] for mean, P in trees],
        "gps": gps.tolist(),
    }


def compared(times: Array, path: Array, fixes: Array) -> tuple[Array, Array]:
    """Distances (f,) [m] of a path (n, 2) from the fixes, and these (f, 2) in the map, after the best rotation and
    translation in the plane.

    The path is interpolated at the fixes' times, between scans 0.2 s apart. It is the laser's, at the front of the car:
    the files do not say where the antenna is, and the fixes turn with the car as its front does.
    """
    x, y = (np.interp(fixes[:, 0], times, column) for column in path.T)
    ours, theirs = x + 1j * y, fixes[:, 1] + 1j * fixes[:, 2]
    turn = np.vdot(theirs - theirs.mean(), ours - ours.mean())  # the sum of squares is least with its angle
    placed = (theirs - theirs.mean()) * turn / abs(turn) + ours.mean()
    return np.abs(placed - ours), np.column_stack([placed.real, placed.imag])


def draw(ax: Any, result: dict[str, Any]) -> None:
    """Draw the path, that by the wheels alone, the GPS if it is there, and the trees with their 95 % ellipses."""
    if "gps" in result:
        ax.plot(*np.array(result["gps"]).T, ".", color=colors.orange, ms=2, label="GPS")
    ax.plot(*np.array(result["dead_reckoning"]).T, color=colors.red, lw=0.7, label="dead reckoning")
    ax.plot(*np.array(result["path"]).T[1:], color=colors.blue, lw=1, label="EKF-SLAM")
    ax.plot(*np.array(result["trees"])[:, :2].T, ".", color=colors.green, ms=3, label="trees, 95 %")
    for x, y, *P in result["trees"]:
        draw_ellipse(ax, np.array([x, y]), np.array([P[:2], P[1:]]), color=colors.green, lw=0.7)
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.legend()


TABLE = """\
scans        {scans} in {time:.0f} s, {length:.0f} m; {seconds:.0f} s to compute
trees        {landmarks} in the map, of {initialized} initialized; {used} of {measurements} measurements used
from GPS     rmse {rmse:.1f} m, median {median:.1f} m, largest {largest:.0f} m; {within_5_m:.1%} within 5 m
             ({fixes} fixes; a rotation and a translation fitted; without a fix for up to {longest_without_fix:.0f} s)
by wheels    rmse {dead_reckoning_rmse:.1f} m, fitted likewise
NIS          mean {nis:.2f}, {nis_dof} degrees of freedom, of those that passed the gate"""


def stored(folder: Path, result: dict[str, Any]) -> str:
    """JSON of what is ours: without the fixes, and the time of one machine; with a digest of the data."""
    digest = hashlib.sha256(b"".join((folder / name).read_bytes() for name in FILES)).hexdigest()[:16]
    kept = {"data": digest} | {name: value for name, value in result.items() if name not in ("gps", "seconds")}
    return json.dumps(kept).replace(', "', ',\n"') + "\n"


def main(words: Sequence[str] | None = None) -> int:
    """The command; exit status 0, 2 for an error of the user, 130 if interrupted."""
    parser = argparse.ArgumentParser(
        prog="python -m slambook.victoria_park",
        description="EKF-SLAM on the recording of Victoria Park, with unknown data association.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    data = os.environ.get("SLAMLIB_DATA")
    folder = data and Path(data) / "landmarks_victoria_park"
    parser.add_argument("folder", type=Path, metavar="FOLDER", nargs="?" if folder else None, default=folder,
                        help="of both files (default: landmarks_victoria_park in $SLAMLIB_DATA)")  # fmt: skip
    parser.add_argument("--scans", type=int, metavar="N", help="the first N scans only")
    parser.add_argument("--svg", metavar="FILE", help="write a map as SVG")
    parser.add_argument("--json", metavar="FILE", help="write figures, path and trees as JSON")
    given = parser.parse_args(words)
    try:
        if given.scans is not None and given.scans < 2:
            raise SlamlibError(f"--scans is 2 or more, got {given.scans}")
        for file in filter(None, (given.svg, given.json)):
            check_writable(file)
        result = run(load(given.folder), given.scans)
        if given.json:
            write_whole(given.json, stored(given.folder, result))
        if given.svg:
            fig, ax = figure(width=6.4, height=6.4)
            draw(ax, result)
            fig.savefig(given.svg, alt="The path of a car among trees, by EKF-SLAM and by its wheels alone.")
        print(TABLE.format(**result))
    except SlamlibError as error:
        print(f"victoria_park: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("victoria_park: interrupted", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
