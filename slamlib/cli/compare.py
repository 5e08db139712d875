"""Compare parametrizations on the same simulated runs: error, consistency, landmarks lost, time."""

import argparse
import sys
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.evaluation.consistency import share_inside
from slamlib.experiments.monte_carlo import Experiment, monte_carlo
from slamlib.experiments.runs import NEES
from slamlib.landmarks import LINES, POINTS
from slamlib.plain_data.files import check_writable
from slamlib.slam.transport import TRANSPORTS

EXAMPLES = """examples:
  slamlib compare ahmPnt idpPnt hmgPnt --runs 20 --jobs 2 --folder finished
  slamlib compare plkLin aplLin --preset lines --frames 200
  slamlib compare hmgPnt idpPnt --errors local world
  slamlib compare planePnt planeIdpPnt --runs 10
  slamlib compare ahmPnt hmgPnt --runs 1000 --scheduler tcp://host:8786 --folder finished

NEES is that of the linear error of the pose (position and rotation apart), which fits the option error=local; beside it
that of the invariant one (the motion from the estimate to the truth), which fits error=world. For small errors they are
the same.
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib compare`."""
    parser.add_argument("landmarks", nargs="+", help="parametrizations, of `slamlib list points` or `lines`")
    parser.add_argument("--preset", help="default: points for points, plane for those in the plane, lines for lines")
    parser.add_argument("--errors", nargs="+", choices=TRANSPORTS, metavar="NAME",
        help="also compare filters, by the error whose covariance they keep: " + ", ".join(TRANSPORTS))  # fmt: skip
    parser.add_argument("--runs", type=shared.count, default=20, help="independent runs of each (default 20)")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--jobs", type=shared.count, default=1, help="runs in parallel, one per processor (default 1)")
    where.add_argument("--scheduler", metavar="ADDRESS", help="run on the workers of a Dask cluster: tcp://host:8786")
    parser.add_argument("--wait", type=float, default=30.0, metavar="SECONDS",
        help="at most, for the scheduler and for a worker (default 30)")  # fmt: skip
    parser.add_argument("--folder", metavar="PATH", help="store finished runs there, and reuse them next time")
    shared.result(parser.add_argument)
    shared.add(parser)


def execute(given: argparse.Namespace) -> int:
    """Run all parametrizations, each on the same worlds, motions and noises."""
    rows = []
    runner.check_files(given)
    if given.folder:
        check_writable(Path(given.folder) / "run.npz")
    for name, error in product(given.landmarks, given.errors or [None]):
        base = shared.base(given.preset or _usual_preset(name))
        preset = shared.with_landmark(shared.changed(base, given), name)
        if error:
            preset = replace(preset, options=replace(preset.options, error=error))
        drawn = replace(preset, seed=0)  # the seed draws the runs: their files belong to the preset without it
        try:
            where = {"jobs": given.jobs, "scheduler": given.scheduler, "wait": given.wait}
            found = monte_carlo(drawn, given.runs, seed=preset.seed, folder=given.folder, **where)
        except KeyboardInterrupt:
            kept = f"are in {given.folder}" if given.folder else "would be kept with --folder PATH"
            print(f"slamlib: {name}: finished runs {kept}; the same command goes on from there", file=sys.stderr)
            raise
        rows.append({"preset": base.name, **summary(name, found)})
    groups = [[row for row in rows if row["preset"] == name] for name in dict.fromkeys(row["preset"] for row in rows)]
    runner.print_result(given, rows, "\n\n".join(map(table, groups)))
    return 0


def _usual_preset(landmark: str) -> str:
    """The preset in which landmarks of this parametrization are compared."""
    if landmark in LINES:
        return "lines"
    return "plane" if landmark in POINTS and POINTS[landmark].plane else "points"


def summary(name: str, found: Experiment) -> dict[str, Any]:
    """The result as plain data: lengths in metres, times in milliseconds."""
    statistic, invariant = (found.consistency(error=error) for error in NEES)
    half = statistic.average.size // 2
    return {
        "landmark": name,
        "error": found.preset.options.error,
        "runs": statistic.runs,
        "frames": found.nees.shape[1],
        "position_error_rms": float(np.sqrt((found.errors[:, -1, 0] ** 2).mean())),
        "position_sigma": float(np.sqrt((found.sigmas[:, -1, 0] ** 2).mean())),
        "map_error_median": float(np.nanmedian(found.map_error)),
        "nees_median": float(np.median(statistic.average)),
        "nees_last": float(statistic.average[-1]),
        "nees_dof": statistic.dof,
        "nees_band": list(statistic.limits),
        "inside_first_half": share_inside(statistic.average[: half or 1], statistic.limits),
        "inside": statistic.inside,
        "nees_invariant_median": float(np.median(invariant.average)),
        "nees_invariant_last": float(invariant.average[-1]),
        "inside_invariant": invariant.inside,
        "landmarks": float(found.landmarks.mean()),
        "deleted": float(found.deleted.mean()),
        "milliseconds_per_frame": 1e3 * float(np.median(found.seconds)),
    }


def table(rows: list[dict[str, Any]]) -> str:
    """The results of one preset as a text table."""
    low, high = rows[0]["nees_band"]
    head = (
        f"Preset {rows[0]['preset']}: {rows[0]['runs']} runs of {rows[0]['frames']} frames.\n"
        "At the last frame: position error (rms) and sigma, median error of the map.\n"
        f"NEES of the pose: {rows[0]['nees_dof']} degrees of freedom, averaged over the runs at each frame; "
        f"95 % band [{low:.2f}, {high:.2f}]; share of the frames inside it.\n"
        "NEES, linear error: median over the frames, at the last, shares of the first half and of all.\n"
        "NEES, invariant error: median, share of all."
    )
    several = len({row["error"] for row in rows}) > 1
    names = [f"{row['landmark']} {row['error']}" if several else row["landmark"] for row in rows]
    width = max(8, *map(len, names))
    lines = ["", f"{'':{width}} {'error':>8} {'sigma':>8} {'map':>8} | {'NEES':>6} {'last':>6} {'1st half':>8} "
             f"{'all':>5} {'invariant':>9} {'all':>5} | {'map':>5} {'lost':>5} {'ms/frame':>8}"]  # fmt: skip
    lines += [
        f"{name:{width}} {100 * r['position_error_rms']:5.1f} cm {100 * r['position_sigma']:5.1f} cm "
        f"{100 * r['map_error_median']:5.1f} cm | {r['nees_median']:6.2f} {r['nees_last']:6.2f} "
        f"{r['inside_first_half']:8.0%} {r['inside']:5.0%} {r['nees_invariant_median']:9.2f} "
        f"{r['inside_invariant']:5.0%} | {r['landmarks']:5.1f} {r['deleted']:5.1f} {r['milliseconds_per_frame']:8.2f}"
        for name, r in zip(names, rows, strict=True)
    ]
    return head + "\n".join(lines)
