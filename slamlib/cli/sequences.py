"""`slamlib run images` and `slamlib run stereo-images`: their arguments, and the runs that they start."""

import argparse
import sys
from contextlib import suppress
from dataclasses import replace

import numpy as np

from slamlib.cli.arguments import assignments, at_least, count, number
from slamlib.cli.images import Add, ImageCommand, given_options
from slamlib.datasets import opening
from slamlib.errors import SlamlibError, entry
from slamlib.motions import MOTIONS
from slamlib.plain_data.fields import read
from slamlib.rigs.setup import SensorSetup
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS
from slamlib.vision.active_search import ActiveSearchSettings
from slamlib.vision.considered import OFFSET, Errors, erroneous
from slamlib.vision.opening import (
    IMAGES,
    PAIRS,
    camera_rig,
    image_run,
    make_front_end,
    open_stereo,
    options_for,
    stereo_run,
)
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.motion_source import MOTION_SOURCES
from slamlib.vision.target import Target
from slamlib.vision.two_views import turning_rate, two_view_target

ALIASES = {"constant-velocity": "constVel"}
FAST = 3.0  # standard deviations: a camera whose first pictures turn faster starts with one as large as that rate
FAST_START = "slamlib: the camera turns by {:.0f} deg/s at the start: this is the std of its turning rate (--velocity)"


class ImagesCommand(ImageCommand):
    """Run the filter on real pictures: a folder, a glob, a video, or a public data set's layout."""

    kind, places = IMAGES, ("source",)
    EXAMPLES = """examples:
  slamlib run images --source frames --calibration camera.json --fps 15
  slamlib run images --source film.mp4 --calibration camera.yaml --frames 300 --video map.mp4
  slamlib run images --source rgbd_dataset_freiburg1_xyz --calibration fr1 --trajectory path.txt \\
      --reference rgbd_dataset_freiburg1_xyz/groundtruth.txt
  slamlib run images --source frames --calibration camera.json --scale target.json

camera.json of a pin-hole, in pixels:
  {"image": [640, 480], "parameters": {"intrinsics": [320, 240, 500, 500], "distortion": [-0.3, 0.1]}}
"""

    def options(self, what: Add, how: Add) -> None:
        """Add the arguments of one camera's images, and of the filter, with all motions of slamlib."""
        what("--source", metavar="PATH",
             help="a folder, a quoted glob, a video, a ZIP archive, a list of files, or a data set's folder; "
                  "with --resume: where the pictures are now")  # fmt: skip
        formats = "a file of slamlib's own or of another tool (see slamlib list calibrations); or fr1, fr2, fr3"
        what("--calibration", metavar="FILE", help=formats)
        what("--camera", type=at_least(0), default=0, metavar="N", help="number of the camera (default 0)")
        what("--undistort", action="store_true", help="remove the lens distortion from the images (OpenCV)")
        self._which(what)
        what("--scale", default="free", metavar="free|FILE",
            help='"free": the unit of length is arbitrary; or a JSON file with "points" (n, 3) [m], n at least 4, '
                 'their "pixels" (n, 2) in the first image, and the "std" of the points [m]')  # fmt: skip
        how("--initialization", choices=("two-view", "priors"), default="two-view",
            help="by two images with enough parallax (the default), or by priors")  # fmt: skip
        how("--motion", default="constant-velocity", help="constant-velocity, or a name of `slamlib list motions`")
        self._impulses(how, "", "{:g} times the target's distance, if there is one, and {:g}")
        how("--noise", type=number, metavar="PX",
            help=f"std of a pixel coordinate (default: the calibration file's, or {IMAGES.noise[0]})")  # fmt: skip
        how("--lines", metavar="LANDMARK",
            help="also straight edges, in this parametrization, such as idpLin (default: none)")  # fmt: skip
        how("--updates", type=count, metavar="N",
            help=f"landmarks per frame (default {IMAGES.options.updates}, more with a target)")  # fmt: skip
        how("--outlier-rejection", choices=OUTLIER_REJECTIONS,
            help=f"how outliers among matches are rejected (default {IMAGES.options.outlier_rejection})")  # fmt: skip
        self._search(how, ActiveSearchSettings, "active search")
        how("--seed", type=int, default=1, metavar="N", help="seed of the search for new landmarks (default 1)")

    def new_run(self, given: argparse.Namespace, errors: Errors | None = None) -> SequenceRun:
        """A run with free scale, or with that of a target."""
        if not given.source or not given.calibration:
            raise SlamlibError("--source and --calibration are needed, or --resume PATH; see slamlib run images --help")
        motion = entry("motion", given.motion, {name: name for name in MOTIONS} | ALIASES)
        opened = {name: getattr(given, name) for name in ("camera", "fps", "times", "undistort")}
        source, camera = opening.open_sequence(given.source, given.calibration, **opened)
        if given.noise is not None:
            camera["std"] = (given.noise,)
        target = None if given.scale == "free" else Target.load(given.scale)
        camera = erroneous(camera, errors or {})
        setup = read(SensorSetup, camera, "camera")
        calibration = setup.calibration
        seen_from = setup.extrinsics if target is None else target.camera(calibration)
        unit = 1.0 if target is None else target.distance(calibration)
        search = assignments(given.search, ActiveSearchSettings, "--search")
        settings = ActiveSearchSettings(**{"max_in_view": 60, **search})
        names = "lines", "updates", "outlier_rejection"
        said = given_options(given, "point landmark (for lines there is --lines)", *names)
        chosen = options_for(unit, 0 if target is None else len(target.points), **said)
        front_end = make_front_end(chosen, calibration, np.random.default_rng(given.seed), settings)
        pictures, velocity, start = source.part(given.start, given.every, given.frames), given.velocity, None
        with suppress(SlamlibError):  # of a picture that cannot be read the run tells when it is there
            if velocity is None and (rate := turning_rate(pictures, calibration)) > FAST * IMAGES.velocity[1]:
                velocity = IMAGES.velocity[0] * unit, rate
                print(FAST_START.format(rate), file=sys.stderr)
            if given.initialization == "two-view":
                start = two_view_target(pictures, calibration, seen_from, target)
        if given.initialization == "two-view" and start is None:
            print("slamlib: no two views with enough parallax: the run starts from priors", file=sys.stderr)
        rig = camera_rig(camera, unit=unit, motion=motion, impulse=given.impulse, velocity=velocity)
        run = image_run(pictures, rig, chosen, front_end, scale=target, start=start, patience=given.patience or 30)
        run.relocalizes = True
        return run


class PairsCommand(ImageCommand):
    """Run the filter on real stereo pairs: KITTI and EuRoC layouts, or a left and a right folder, glob or video."""

    kind, places = PAIRS, ("source", "left", "right")
    EXAMPLES = """examples:
  slamlib run stereo-images --source sequences/04 --reference poses/04.txt --trajectory path.txt
  slamlib run stereo-images --source MH_01_easy --frames 200 --video film.mp4
  slamlib run stereo-images --left "left/*.png" --right "right/*.png" --calibration pair.json --fps 10
  slamlib run stereo-images --source sequences/04 --odometry-only
  slamlib run stereo-images --source sequences/04 --calibration-std intrinsics=1,1,2,2 --calibration-std offset=0.1

pair.json of a rectified pair, in pixels and metres:
  {"intrinsics": [601.9, 183.1, 707.1, 707.1], "baseline": 0.537}
"""

    def options(self, what: Add, how: Add) -> None:
        """Add the arguments of two cameras' images, and of the filter, with visual odometry."""
        what("--source", metavar="FOLDER", help="of KITTI (image_0, image_1, calib.txt, times.txt) or EuRoC (mav0)")
        for side in ("left", "right"):
            what(f"--{side}", metavar="GLOB", help=f"the {side} images: a folder, a quoted glob, or a video")
        what("--calibration", metavar="FILE", nargs="+",
            help="a file of both cameras, or one of each, of slamlib's own or of another tool (see slamlib list "
                 "calibrations); a data set's folder may contain it")  # fmt: skip
        what("--cameras", nargs=2, type=at_least(0), metavar=("L", "R"), help="their numbers (default 0 1, or 2 3)")
        what("--rectify", action="store_true",
            help="the images are not rectified: rectify them (OpenCV; always done for EuRoC)")  # fmt: skip
        self._which(what)
        how("--motion", choices=MOTION_SOURCES, default="covariance-intersection",
            help="where predictions come from: constant-velocity, covariance-intersection (odometry and landmarks of "
                 "all features, all variances doubled; default), split-features (odometry of one half of the features, "
                 "landmarks of the other), correlated (all for both, modelled; needs many)")  # fmt: skip
        how("--odometry-only", action="store_true", help="no filter: visual odometry alone, for comparison")
        self._impulses(how, "with --motion constant-velocity, ", "{:g} {:g}")
        noise = " ".join(f"{n:g}" for n in PAIRS.noise)
        how("--noise", nargs="+", type=number, metavar="PX",
            help=f"std of u, v and disparity, or one for all (default: the calibration's, or {noise})")  # fmt: skip
        for name, text in (
            ("window", "delete landmarks not seen for N pairs (default: none)"),
            ("capacity", "most landmarks; beyond it the least recently seen one is deleted"),
            ("updates", f"landmarks measured per pair (default {PAIRS.options.updates})"),
        ):
            how(f"--{name}", type=count, metavar="N", help=text)
        self._search(how, StereoSettings, "features")

    def new_run(self, given: argparse.Namespace, errors: Errors | None = None) -> SequenceRun:
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
            cameras=cameras, fps=given.fps, times=given.times, rectify=given.rectify, settings=settings,
        )  # fmt: skip
        if given.noise is not None:
            if len(given.noise) not in (1, 3) or not min(given.noise) > 0:
                raise SlamlibError(f"--noise takes one number above 0, or three (u, v, disparity), got {given.noise}")
            camera = {**camera, "std": tuple(given.noise * (3 // len(given.noise))), "noise": None}
        wrong = replace(settings, offset=settings.offset + sum((errors or {}).get(OFFSET, ())))
        return stereo_run(
            source.part(given.start, given.every, given.frames), erroneous(camera, errors or {}), options,
            motion_source="odometry" if given.odometry_only else given.motion, settings=wrong,
            impulse=given.impulse, velocity=given.velocity, patience=given.patience or 30,
        )  # fmt: skip
