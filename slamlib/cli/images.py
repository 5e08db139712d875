"""Run the filter on real pictures: a folder, a glob, a video, or TUM RGB-D, EuRoC and KITTI layouts."""

import argparse
from dataclasses import fields
from typing import Any

import numpy as np

from slamlib.cli import choices, reporting
from slamlib.data.setup import SensorSetup, tuples
from slamlib.datasets.opening import opened
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.landmarks import POINTS
from slamlib.motions import MOTIONS
from slamlib.slam.data_association.consensus import CONSENSUS
from slamlib.vision.active_search import Settings
from slamlib.vision.combined_front_end import front_end_of
from slamlib.vision.hand_held import IMPULSE, NOISE, OPTIONS, VELOCITY, hand_held, options
from slamlib.vision.run import ImageRun
from slamlib.vision.target import Target

ALIASES = {"constant-velocity": "constVel"}


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `slamlib run images` takes."""
    reporting.groups(parser, _what, _how)


def _what(group: Any) -> None:
    group.add_argument(
        "--source", metavar="PATH", help="a folder, a glob in quotation marks, a video, or a data set's folder"
    )
    group.add_argument(
        "--calibration", metavar="FILE", help="slamlib's, EuRoC's, OpenCV's, KITTI's, or plain text; or fr1, fr2, fr3"
    )
    group.add_argument(
        "--camera", type=choices.from_zero, default=0, metavar="N", help="of several cameras, which (default 0)"
    )
    group.add_argument("--undistort", action="store_true", help="free the pictures of the lens's distortion (OpenCV)")
    reporting.which(group, "pictures")
    group.add_argument(
        "--scale", default="free", metavar="free|FILE",
        help='"free": the unit of length is arbitrary; or a JSON file with "points" (n, 3), n at least 4, and their '
        '"pixels" (n, 2) in the first picture, "std" of the points',
    )  # fmt: skip


def _how(group: Any) -> None:
    group.add_argument(
        "--motion", default="constant-velocity", help="constant-velocity, or a name of `slamlib list motions`"
    )
    for name, default, what in (
        ("--impulse", IMPULSE, "changes of velocity from one picture to the next"),
        ("--velocity", VELOCITY, "velocities at the start, whose mean is zero"),
    ):
        text = (
            f"std of {what} (default {default[0]:g} times the target's distance, if there is one, and {default[1]:g})"
        )
        group.add_argument(name, nargs=2, type=float, metavar=("M/S", "DEG/S"), help=text)
    group.add_argument(
        "--noise",
        type=float,
        metavar="PX",
        help=f"std of a measured pixel (default: the calibration file's, or {NOISE})",
    )
    group.add_argument(
        "--landmark", default=OPTIONS.points, help=f"parametrization of points (default {OPTIONS.points})"
    )
    group.add_argument(
        "--lines",
        metavar="LANDMARK",
        help="also straight edges, in this parametrization, such as idpLin (default: none)",
    )
    group.add_argument(
        "--updates",
        type=choices.count,
        metavar="N",
        help=f"landmarks a frame (default {OPTIONS.updates}, more with a target)",
    )
    group.add_argument(
        "--consensus", choices=CONSENSUS, help=f"which matches are believed together (default {OPTIONS.consensus})"
    )
    group.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help=choices.OPTION)
    names = ", ".join(f.name for f in fields(Settings))
    group.add_argument("--search", action="append", default=[], metavar="NAME=VALUE", help=f"of active search: {names}")
    group.add_argument(
        "--patience", type=choices.count, metavar="N", help="stop after N frames without a match (default 30)"
    )
    group.add_argument("--seed", type=int, default=1, metavar="N", help="of where new landmarks are sought (default 1)")


def execute(given: argparse.Namespace) -> int:
    """Run it; a run that stops, by itself or by Ctrl-C, is saved, and can be gone on with."""
    return reporting.carry_out(_resumed(given) if given.resume else _begun(given), given, "run images")


def _begun(given: argparse.Namespace) -> ImageRun:
    if not given.source or not given.calibration:
        raise SlamlibError("--source and --calibration are wanted, or --resume PATH; see slamlib run images --help")
    motion = ALIASES.get(given.motion, given.motion)
    if motion not in MOTIONS:
        raise UnknownNameError.of("motion", given.motion, [*ALIASES, *MOTIONS])
    source, camera = opened(
        given.source, given.calibration, camera=given.camera, fps=given.fps, undistort=given.undistort
    )
    if given.noise is not None:
        camera["std"] = (given.noise,)
    target = None if given.scale == "free" else Target.load(given.scale)
    unit = 1.0 if target is None else target.distance(SensorSetup(**tuples(camera)).calibration)
    rig = hand_held(camera, unit=unit, motion=motion, impulse=given.impulse, velocity=given.velocity)
    settings = Settings(**choices.assignments(given.search, Settings, "--search"))
    chosen = options(unit, 0 if target is None else len(target.points), **_said(given))
    return ImageRun(
        source.part(given.start, given.every, given.frames),
        rig,
        chosen,
        front_end_of(chosen, rig.sensors[0].calibration, np.random.default_rng(given.seed), settings),
        scale=target,
        **({} if given.patience is None else {"patience": given.patience}),
    )


def _said(given: argparse.Namespace) -> dict[str, Any]:
    """The filter's options that the command line says."""
    if given.landmark not in POINTS:
        raise UnknownNameError.of("point landmark (for lines there is --lines)", given.landmark, POINTS)
    named = {"points": given.landmark, "lines": given.lines, "updates": given.updates, "consensus": given.consensus}
    said = {name: value for name, value in named.items() if value is not None}
    return {**said, **choices.assignments(given.option)}


def _resumed(given: argparse.Namespace) -> ImageRun:
    if given.source or given.calibration:
        raise SlamlibError("--resume goes on with the pictures and the calibration of its file: leave them out")
    run = ImageRun.load(given.resume, frames=given.frames)
    run.patience = given.patience or run.patience
    return run
