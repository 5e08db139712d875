"""Run the filter on real stereo pairs: KITTI and EuRoC layouts, or a left and a right folder, glob or video."""

import argparse
from dataclasses import fields, replace
from typing import Any

from slamlib.cli import choices, reporting
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.landmarks import POINTS
from slamlib.vision.stereo.motion_source import MOVING
from slamlib.vision.stereo.odometry_run import OdometryRun, load
from slamlib.vision.stereo.open_pairs import opened_pairs
from slamlib.vision.stereo.run import IMPULSE, NOISE, OPTIONS, VELOCITY, StereoRun
from slamlib.vision.stereo.settings import StereoSettings

COMMAND = "run stereo-images"
EXAMPLES = """examples:
  slamlib run stereo-images --source sequences/04 --reference poses/04.txt --trajectory path.txt
  slamlib run stereo-images --source MH_01_easy --frames 200 --video film.mp4
  slamlib run stereo-images --left "left/*.png" --right "right/*.png" --calibration pair.json --fps 10
  slamlib run stereo-images --source sequences/04 --odometry-only

pair.json of a rectified pair, in pixels and metres:
  {"intrinsics": [601.9, 183.1, 707.1, 707.1], "baseline": 0.537}
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `slamlib run stereo-images` takes."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = EXAMPLES
    reporting.groups(parser, _what, _how)


def _what(group: Any) -> None:
    group.add_argument(
        "--source", metavar="FOLDER", help="of KITTI (image_0, image_1, calib.txt, times.txt) or EuRoC (mav0)"
    )
    for side in ("left", "right"):
        group.add_argument(
            f"--{side}", metavar="GLOB", help=f"the {side} pictures: a folder, a glob in quotation marks, or a video"
        )
    group.add_argument(
        "--calibration",
        metavar="FILE",
        nargs="+",
        help="of both cameras: KITTI's, slamlib's, Kalibr's, OpenCV's or plain JSON, or two files (EuRoC's); a data "
        "set's folder may hold it",
    )
    group.add_argument(
        "--cameras", nargs=2, type=choices.from_zero, metavar=("L", "R"), help="of several (default 0 1, or 2 3)"
    )
    group.add_argument(
        "--rectify",
        action="store_true",
        help="the pictures are as the lenses made them: rectify them (OpenCV; always so for EuRoC)",
    )
    reporting.which(group, "pairs")


def _how(group: Any) -> None:
    group.add_argument(
        "--motion",
        choices=MOVING,
        default="halves",
        help="where predictions come from: velocity (the robot keeps it), halves (odometry of one half of the "
        "features, landmarks of the other; default), correlated (all features for both; wants many)",
    )
    group.add_argument("--odometry-only", action="store_true", help="no filter: visual odometry alone, to compare")
    for name, default, what in (
        ("--impulse", IMPULSE, "changes of velocity from one pair to the next"),
        ("--velocity", VELOCITY, "velocities at the start, whose mean is zero"),
    ):
        text = f"with --motion velocity, std of {what} (default {default[0]:g} {default[1]:g})"
        group.add_argument(name, nargs=2, type=float, default=default, metavar=("M/S", "DEG/S"), help=text)
    group.add_argument(
        "--noise",
        nargs="+",
        type=float,
        metavar="PX",
        help="std of u, v and disparity, or one for all (default: the calibration file's, or "
        f"{' '.join(f'{n:g}' for n in NOISE)})",
    )
    group.add_argument("--landmark", default=OPTIONS.points, help=f"parametrization (default {OPTIONS.points})")
    group.add_argument(
        "--window", type=choices.count, metavar="N", help="forget what was not seen for N pairs (default: nothing)"
    )
    group.add_argument(
        "--capacity", type=choices.count, metavar="N", help="most landmarks: of more, the one unseen for longest goes"
    )
    group.add_argument("--updates", type=choices.count, metavar="N", help=f"landmarks a pair ({OPTIONS.updates})")
    group.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help=choices.OPTION)
    names = ", ".join(f.name for f in fields(StereoSettings))
    group.add_argument("--search", action="append", default=[], metavar="NAME=VALUE", help=f"of features: {names}")
    group.add_argument(
        "--patience", type=choices.count, metavar="N", help="stop after N pairs without a match (default 30)"
    )


def execute(given: argparse.Namespace) -> int:
    """Run it; a run that stops, by itself or by Ctrl-C, is saved, and can be gone on with."""
    run = _resumed(given) if given.resume else _begun(given)
    if not run.has_map and (given.video or given.live):
        raise SlamlibError("--video and --live show the filter's map: with --odometry-only there is none")
    return reporting.carry_out(run, given, COMMAND)


def _begun(given: argparse.Namespace) -> StereoRun:
    if not given.source and not (given.left and given.right):
        raise SlamlibError(
            f"--source, or --left and --right, are wanted, or --resume PATH; see slamlib {COMMAND} --help"
        )
    if given.source and (given.left or given.right):
        raise SlamlibError("--source has both cameras in it: leave --left and --right out")
    settings = StereoSettings(**choices.assignments(given.search, StereoSettings, "--search"))
    options = replace(OPTIONS, **_said(given))
    source, camera, settings = opened_pairs(
        given.source,
        given.left,
        given.right,
        given.calibration,
        cameras=tuple(given.cameras) if given.cameras else None,
        fps=given.fps,
        rectify=given.rectify,
        settings=settings,
    )
    if given.noise is not None:
        camera = {**camera, "std": _three(given.noise), "noise": None}
    pairs = source.part(given.start, given.every, given.frames)
    patience = {} if given.patience is None else {"patience": given.patience}
    if given.odometry_only:
        return OdometryRun(pairs, camera, settings=settings, **patience)
    return StereoRun(
        pairs,
        camera,
        options,
        moving=given.motion,
        settings=settings,
        impulse=tuple(given.impulse),
        velocity=tuple(given.velocity),
        **patience,
    )


def _three(noise: list[float]) -> tuple[float, ...]:
    if len(noise) not in (1, 3) or not min(noise) > 0:
        raise SlamlibError(f"--noise takes one number above 0, or three (u, v, disparity), got {noise}")
    return tuple(noise * (3 // len(noise)))


def _said(given: argparse.Namespace) -> dict[str, Any]:
    """The filter's options that the command line says."""
    if given.landmark not in POINTS:
        raise UnknownNameError.of("point landmark", given.landmark, POINTS)
    named = {"points": given.landmark, "window": given.window, "capacity": given.capacity, "updates": given.updates}
    said = {name: value for name, value in named.items() if value is not None}
    full = {} if given.capacity is None else {"full": "unseen"}
    return {**full, **said, **choices.assignments(given.option)}


def _resumed(given: argparse.Namespace) -> StereoRun:
    if given.source or given.left or given.right or given.calibration:
        raise SlamlibError("--resume goes on with the pictures and the calibration of its file: leave them out")
    run = load(given.resume, frames=given.frames)
    run.patience = given.patience or run.patience
    return run
