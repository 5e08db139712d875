"""Run one experiment, and report its errors and consistency."""

import argparse
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.errors import SlamlibError
from slamlib.evaluation.comparison import magnitudes
from slamlib.evaluation.consistency import band, share_inside
from slamlib.experiments.runs import NEES, Result, Run
from slamlib.manifolds import Array

EXAMPLES = """examples:
  slamlib run points
  slamlib run points --landmark hmgPnt --seed 7 --video run.mp4
  slamlib run plane --video lap.mp4
  slamlib run stereo --calibrate --save run.npz
  slamlib run --resume run.npz --frames 800
  slamlib preset points > mine.toml; slamlib run mine.toml

on real images: slamlib run images --help; on stereo pairs: slamlib run stereo-images --help

NEES is printed of two errors of the pose: linear (position and rotation apart), which fits the option error=local, and
invariant (the motion from the estimate to the truth), which fits error=world. For small errors they are the same.
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib run`."""
    parser.add_argument("preset", nargs="?", help="a name of `slamlib list presets`, or a JSON or TOML file")
    parser.add_argument("--landmark", action="append", default=[], help="parametrization of new points or lines")
    shared.add(parser)
    shared.outputs(parser.add_argument)


def execute(given: argparse.Namespace) -> int:
    """Run the experiment; an interrupted run is saved, and can be resumed."""
    runner.check_files(given)
    run = runner.new_or_resumed(given, _new_run, lambda path: _loaded(path, given.frames))
    name = run.preset.name
    job = runner.Job(
        run, f"{name}, seed {run.preset.seed}", "run", f"slamlib-{name}-{run.preset.seed}.npz",
        shown=lambda step: (run.slam.snapshot(), step.truth if step else None), world=run.preset.world,
    )  # fmt: skip
    ended = runner.execute(job, given)
    result = run.result()
    runner.export_map(given, run.slam.snapshot)
    runner.export_plot(given, result.series)
    runner.print_result(given, summary(result), table(result))
    return ended.status


def _loaded(path: str, frames: int | None) -> Run:
    run = Run.load(path)
    if frames and frames < run.done:
        raise SlamlibError(f"--frames {frames}: {path} has {run.done} frames already")
    if frames:
        run.preset = replace(run.preset, frames=frames)
    return run


def _new_run(given: argparse.Namespace) -> Run:
    if not given.preset:
        raise SlamlibError("which preset? `slamlib list presets` shows them; --resume PATH continues a saved run")
    chosen = shared.base(given.preset)
    for name in given.landmark:
        chosen = shared.with_landmark(chosen, name)
    return Run(shared.changed(chosen, given))


def summary(result: Result) -> dict[str, Any]:
    """The result as plain data: lengths in metres, angles in degrees, times in milliseconds."""
    robots = [
        {
            **_deviation(setup.name, result.errors[-1, i], result.sigmas[-1, i]),
            "nees": float(result.nees[-1, i]),
            "nees_invariant": float(result.nees_invariant[-1, i]),
            "nees_dof": result.dof[i],
            "nees_band": list(band(result.dof[i])),
            "nees_inside": _share_inside(result, i, "linear"),
            "nees_invariant_inside": _share_inside(result, i, "invariant"),
        }
        for i, setup in enumerate(result.preset.rig.robots)
    ]
    nees = {"nees": result.extrinsics_nees, "nees_invariant": result.extrinsics_nees_invariant}
    sensors = enumerate(zip(result.preset.rig.sensors, result.extrinsics, result.extrinsics_dof, strict=True))
    return {
        "preset": result.preset.name,
        "seed": result.preset.seed,
        "frames": len(result.nees),
        "robots": robots,
        "extrinsics": [
            {
                **_deviation(setup.name, *pair),
                **{key: float(values[i]) for key, values in nees.items()},
                "nees_dof": int(dof),
            }
            for i, (setup, pair, dof) in sensors
            if setup.estimated
        ],
        "nis_per_dof": float(result.nis.sum() / max(result.nis_dof.sum(), 1)),
        "landmarks": int(result.landmarks[-1]),
        "initialized": result.initialized,
        "deleted": result.deleted,
        "state": int(result.size[-1]),
        "point_error_median": _median(result.map_errors["points"]),
        "line_error_median": _median(result.map_errors["segments"]),
        "milliseconds_per_frame": 1e3 * float(np.median(result.seconds)),
    }


def _share_inside(result: Result, robot: int, error: str) -> float | None:
    """Share of the frames whose NEES is inside the band of one run; None where the pose is known exactly."""
    series = result.judged(robot, error)
    known = series[np.isfinite(series)]
    return share_inside(known, band(result.dof[robot])) if len(known) else None


def _deviation(name: str, *error_and_sigma: Array) -> dict[str, Any]:
    """A pose's error (6,) and standard deviations (6,) as plain data."""
    found = magnitudes(*error_and_sigma)
    names = {"position_error": "position", "attitude_error": "orientation"}
    names |= {"position_sigma": "position_sigma", "attitude_sigma": "orientation_sigma"}
    return {"name": name, **{key: float(found[own]) for key, own in names.items()}}


def _median(values: Array) -> float | None:
    finite = values[np.isfinite(values)]
    return float(np.median(finite)) if len(finite) else None


def table(result: Result) -> str:
    """The result as a text table."""
    s = summary(result)
    rows = [("preset", f"{s['preset']}, seed {s['seed']}, {s['frames']} frames")]
    at = f"at frame {s['frames']}"
    for pose, what in [(robot, "error") for robot in s["robots"]] + [(e, "extrinsics error") for e in s["extrinsics"]]:
        place = f"{100 * pose['position_error']:.1f} cm (sigma {100 * pose['position_sigma']:.1f} cm)"
        turn = f"{pose['attitude_error']:.2f} degrees (sigma {pose['attitude_sigma']:.2f})"
        rows.append((f"{pose['name']}: {what}", f"{place}, {turn}, {at}"))
    for robot, (error, key) in product(s["robots"], NEES.items()):
        low, high = robot["nees_band"]
        share = "the motion has no noise: the pose is known exactly"
        if robot[f"{key}_inside"] is not None:
            inside = f"{robot[f'{key}_inside']:.0%} of the steps inside [{low:.2f}, {high:.2f}]"
            share = f"{robot[key]:.2f}, {at}; {inside} (1 run, 95 %)"
        rows.append((f"{robot['name']}: NEES, {robot['nees_dof']} dof, {error} error", share))
    for e, (error, key) in product(s["extrinsics"], NEES.items()):
        rows.append((f"{e['name']}: extrinsics NEES, {e['nees_dof']} dof, {error} error", f"{e[key]:.2f}, {at}"))
    rows.append(("NIS per degree of freedom", f"{s['nis_per_dof']:.2f}"))
    rows.append(("landmarks", f"{s['landmarks']} in the map, {s['initialized']} initialized, {s['deleted']} deleted"))
    for name in ("point", "line"):
        if s[f"{name}_error_median"] is not None:
            rows.append((f"{name}s: median error", f"{100 * s[f'{name}_error_median']:.1f} cm"))
    rows.append(("state", f"{s['state']} degrees of freedom"))
    rows.append(("processor time", f"{s['milliseconds_per_frame']:.2f} ms per frame (median)"))
    return shared.aligned_rows(rows)
