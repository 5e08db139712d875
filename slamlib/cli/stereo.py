"""`slamlib run stereo-images`: its arguments, and the runs on stereo pairs that it starts."""

import argparse
from dataclasses import replace

from slamlib.cli.arguments import assignments, at_least, count, number
from slamlib.cli.images import Add, ImageCommand, given_options
from slamlib.errors import SlamlibError
from slamlib.vision.run import PAIRS, open_stereo, stereo_run
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.motion_source import MOTION_SOURCES

EXAMPLES = """examples:
  slamlib run stereo-images --source sequences/04 --reference poses/04.txt --trajectory path.txt
  slamlib run stereo-images --source MH_01_easy --frames 200 --video film.mp4
  slamlib run stereo-images --left "left/*.png" --right "right/*.png" --calibration pair.json --fps 10
  slamlib run stereo-images --source sequences/04 --odometry-only

pair.json of a rectified pair, in pixels and metres:
  {"intrinsics": [601.9, 183.1, 707.1, 707.1], "baseline": 0.537}
"""


class PairsCommand(ImageCommand):
    """Run the filter on real stereo pairs: KITTI and EuRoC layouts, or a left and a right folder, glob or video."""

    kind, EXAMPLES = PAIRS, EXAMPLES

    def what(self, add: Add) -> None:
        """Add the input arguments of two cameras."""
        add("--source", metavar="FOLDER", help="of KITTI (image_0, image_1, calib.txt, times.txt) or EuRoC (mav0)")
        for side in ("left", "right"):
            add(f"--{side}", metavar="GLOB", help=f"the {side} images: a folder, a quoted glob, or a video")
        add("--calibration", metavar="FILE", nargs="+",
            help="of both cameras: KITTI's, slamlib's, Kalibr's, OpenCV's or plain JSON, or two files (EuRoC's); a "
                 "data set's folder may contain it")  # fmt: skip
        add("--cameras", nargs=2, type=at_least(0), metavar=("L", "R"), help="their numbers (default 0 1, or 2 3)")
        add("--rectify", action="store_true",
            help="the images are not rectified: rectify them (OpenCV; always done for EuRoC)")  # fmt: skip
        self._which(add)

    def how(self, add: Add) -> None:
        """Add the filter arguments, with visual odometry."""
        add("--motion", choices=MOTION_SOURCES, default="split-features",
            help="where predictions come from: constant-velocity, split-features (odometry of one half of the "
                 "features, landmarks of the other; default), correlated (all for both; needs many)")  # fmt: skip
        add("--odometry-only", action="store_true", help="no filter: visual odometry alone, for comparison")
        self._impulses(add, "with --motion constant-velocity, ", "{:g} {:g}")
        noise = " ".join(f"{n:g}" for n in PAIRS.noise)
        add("--noise", nargs="+", type=number, metavar="PX",
            help=f"std of u, v and disparity, or one for all (default: the calibration's, or {noise})")  # fmt: skip
        points, updates = PAIRS.options.points, PAIRS.options.updates
        add("--landmark", default=points, help=f"parametrization of points (default {points})")
        for name, text in (
            ("window", "delete landmarks not seen for N pairs (default: none)"),
            ("capacity", "most landmarks; beyond it the least recently seen one is deleted"),
            ("updates", f"landmarks measured per pair (default {updates})"),
        ):
            add(f"--{name}", type=count, metavar="N", help=text)
        self._search(add, StereoSettings, "features")

    def new_run(self, given: argparse.Namespace) -> SequenceRun:
        """A run of the filter, or of visual odometry alone."""
        if not given.source and not (given.left and given.right):
            see = "see slamlib run stereo-images --help"
            raise SlamlibError(f"--source, or --left and --right, are needed, or --resume PATH; {see}")
        if given.source and (given.left or given.right):
            raise SlamlibError("--source has both cameras in it: leave --left and --right out")
        settings = StereoSettings(**assignments(given.search, StereoSettings, "--search"))
        full = {} if given.capacity is None else {"pruning": "least-recently-seen"}
        said = given_options(given, "point landmark", "window", "capacity", "updates")
        options = replace(PAIRS.options, **{**full, **said})
        cameras = tuple(given.cameras) if given.cameras else None
        source, camera, settings = open_stereo(
            given.source, given.left, given.right, given.calibration,
            cameras=cameras, fps=given.fps, rectify=given.rectify, settings=settings,
        )  # fmt: skip
        if given.noise is not None:
            if len(given.noise) not in (1, 3) or not min(given.noise) > 0:
                raise SlamlibError(f"--noise takes one number above 0, or three (u, v, disparity), got {given.noise}")
            camera = {**camera, "std": tuple(given.noise * (3 // len(given.noise))), "noise": None}
        return stereo_run(
            source.part(given.start, given.every, given.frames), camera, options,
            motion_source="odometry" if given.odometry_only else given.motion, settings=settings,
            impulse=given.impulse, velocity=given.velocity, patience=given.patience or 30,
        )  # fmt: skip
