"""Runs on images of one camera, or on stereo pairs: created, and loaded.

**Scale.** One camera cannot observe it (chapter monocular): priors of inverse distance, velocity and impulse give the
unit of length, which drifts; a trajectory is compared after a similarity. A target or a baseline gives true lengths.

**Frame of reference.** The robot's first pose is the world's origin, known exactly; the optical axis is along x, and
the (left) camera is at the robot's origin. With a target the world is the target's.

**Without matches** a frame is a prediction only, and the next image may be searched for the map. A run stops with
TrackingLostError if a tracking loss lasts too long all the same (slamlib.vision.sequence_run).
"""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets import opening
from slamlib.datasets.dataset import ImageSource
from slamlib.errors import SlamlibError, entry
from slamlib.plain_data.fields import read, read_fields
from slamlib.plain_data.files import check_columns, complete
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam, checkpoint
from slamlib.slam.data_association.front_end import FrontEnd
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.image_front_end import CombinedFrontEnd, MotionSource
from slamlib.vision.line_search import SegmentSearch
from slamlib.vision.sequence_run import SequenceKind, SequenceRun
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import check_pair
from slamlib.vision.stereo.motion_source import MOTION_SOURCES, OdometryOnly, StereoMotionSource
from slamlib.vision.target import Target


def make_front_end(
    options: Options, calibration: Calibration, rng: np.random.Generator, settings: ActiveSearchSettings | None = None
) -> ActiveSearch | CombinedFrontEnd:
    """The front end for these options: of points, and also of lines if there are any."""
    points = ActiveSearch(calibration, rng, settings)
    return CombinedFrontEnd(points, SegmentSearch(calibration)) if options.lines else points


def _image_source(setup: SensorSetup, options: Options, name: str, settings: Any) -> MotionSource:
    known = read(ActiveSearchSettings, settings)
    return MotionSource(make_front_end(options, setup.calibration, np.random.default_rng(0), known))


def _pair_source(setup: SensorSetup, options: Options, name: str, settings: Any) -> MotionSource:
    return PAIR_MOTION_SOURCES[name](setup.calibration, setup.extrinsics, read(StereoSettings, settings))


PAIR_MOTION_SOURCES: dict[str, type[StereoMotionSource]] = {**MOTION_SOURCES, "odometry": OdometryOnly}
IMAGES = SequenceKind(
    "images",
    "picture",
    (
        "was there a cut, or was the camera covered? Did it move more than the motion's impulses allow for, or are "
        "they so large that only the middle of the regions was searched (active search's setting `largest`)?",
        "no landmark could be initialized: is there enough light and texture?",
    ),
    _image_source,
    Options(
        points="ahmPnt", updates=40, max_new_first=12, max_new=8, inverse_distance=(1.0, 1.0), outlier_rejection="joint"
    ),
    impulse=(0.1, 5.0),
    velocity=(0.3, 10.0),
    noise=(0.5,),  # of a matched patch in a hand-held camera's images, by their NIS
)
PAIRS = SequenceKind(
    "stereo-images",
    "pair",
    (
        "was there a cut, or was a camera covered? Did they move so far that little is seen twice, or more than the "
        "motion's impulses allow for?",
    )
    * 2,
    _pair_source,
    Options(points="eucPnt", updates=100, max_new_first=100, max_new=30, margin=0.0, error="world"),
    impulse=(0.3, 2.0),  # of a car
    velocity=(15.0, 10.0),
    noise=(0.2, 0.2, 0.2),
)


def camera_rig(
    camera: dict[str, Any],
    kind: SequenceKind = IMAGES,
    *,
    unit: float = 1.0,
    motion: str = "constVel",
    impulse: tuple[float, float] | None = None,
    velocity: tuple[float, float] | None = None,
) -> Rig:
    """A rig of a hand-held camera (plain data of a SensorSetup); it starts at the origin, its optical axis along x.

    impulse, velocity: standard deviations as of a SequenceKind, by default its own. unit: typical distance of the
    landmarks [m], by which these are scaled; with a free scale the unit of the run itself, 1.
    """
    velocity_std, control_std = (
        tuple(np.repeat((default[0] * unit, default[1]) if given is None else given, 3).tolist())
        for given, default in ((velocity, kind.velocity), (impulse, kind.impulse))
    )
    robot = RobotSetup(motion=motion, velocity_std=velocity_std, control_std=control_std)
    return Rig((robot,), (SensorSetup(**{"std": kind.noise, **read_fields(SensorSetup, camera, "camera")}),))


def options_for(unit: float = 1.0, known: int = 0, **said: Any) -> Options:
    """The options of IMAGES for landmarks about `unit` [m] away, overridden by those given.

    A prior that is wrong for most landmarks is a wrong measurement of the scale, repeated with each of them. known:
    number of points of a target. They are observed in addition to the others, and first: by information gain alone the
    most uncertain landmarks are selected, and the known ones, which fix the scale, never.
    """
    mean, std = IMAGES.options.inverse_distance
    first = {"selection": "order", "updates": IMAGES.options.updates + known} if known else {}
    return replace(IMAGES.options, **{"inverse_distance": (mean / unit, std / unit), **first, **said})


def image_run(
    source: ImageSource,
    rig: Rig,
    options: Options = IMAGES.options,
    front_end: FrontEnd | None = None,
    *,
    scale: Target | None = None,
    start: Target | None = None,
    patience: int = 30,
    rng: np.random.Generator | None = None,
) -> SequenceRun:
    """A run on images. rig: one robot with one camera. scale: a known target, or None for a free scale.
    start: points to start from, the target's first (slamlib.vision.two_views), or None: the target's alone.

    front_end: default ActiveSearch, which draws with `rng`, and also SegmentSearch if the options have lines.
    patience: frames without a match, after which the run stops. The impulses of the rig's motion are those between two
    neighbours of the whole source: a longer interval is divided into such steps. Raises SlamlibError.
    """
    if len(rig.robots) != 1 or len(rig.sensors) != 1:
        raise SlamlibError("image_run: a rig of one robot with one camera is expected")
    rig = rig if scale is None else scale.placed(rig)
    own = front_end or make_front_end(options, rig.sensors[0].calibration, rng or np.random.default_rng(0))
    slam = Slam(rig, options=options, front_ends=[own])
    metric = scale is not None
    return SequenceRun(source, slam, MotionSource(own), IMAGES, patience=patience, metric=metric, target=start or scale)


def open_stereo(
    source: str | None = None,
    left: str | None = None,
    right: str | None = None,
    calibration: list[str] | None = None,
    *,
    settings: StereoSettings | None = None,
    cameras: tuple[int, int] | None = None,
    fps: float | None = None,
    times: str | None = None,
    rectify: bool = False,
) -> tuple[ImageSource, dict[str, Any], StereoSettings]:
    """As slamlib.datasets.opening.open_rectified_pairs, and the settings with the offset [px] of disparities.

    The first pair is read, to check its rows and the sign of its disparities. Raises SlamlibError.
    """
    pairs, camera, offset = opening.open_rectified_pairs(
        source, left, right, calibration, cameras=cameras, fps=fps, times=times, rectify=rectify
    )
    chosen = settings or StereoSettings()
    chosen = replace(chosen, offset=chosen.offset or offset)
    first = next(iter(pairs))
    check_pair(first.image, first.name, chosen)
    return pairs, camera, chosen


def stereo_run(
    source: ImageSource,
    camera: dict[str, Any],
    options: Options = PAIRS.options,
    *,
    motion_source: str = "covariance-intersection",
    settings: StereoSettings | None = None,
    impulse: tuple[float, float] | None = None,
    velocity: tuple[float, float] | None = None,
    patience: int = 30,
) -> SequenceRun:
    """A run on rectified pairs. camera: plain data of their stereo SensorSetup (open_stereo gives both).

    motion_source: of PAIR_MOTION_SOURCES; "odometry" is visual odometry alone: the filter has no landmarks, and
    composes motions and their covariances. impulse, velocity: as of a SequenceKind, if the motion has velocities.
    patience: pairs without a match, after which the run stops. Raises SlamlibError.
    """
    chosen = entry("motion of a stereo run", motion_source, PAIR_MOTION_SOURCES)
    rig = chosen.inflated(camera_rig(camera, PAIRS, motion=chosen.motion, impulse=impulse, velocity=velocity))
    motion = chosen(rig.sensors[0].calibration, rig.sensors[0].extrinsics, settings)
    options = Options(points=None) if motion_source == "odometry" else options
    return SequenceRun(
        source, Slam(rig, options=options, front_ends=[motion.front_end]), motion, PAIRS, patience=patience
    )


def load(
    path: str | Path,
    kind: SequenceKind = IMAGES,
    *,
    source: ImageSource | None = None,
    front_end: Callable[[Calibration], FrontEnd] | None = None,
    frames: int | None = None,
    places: tuple[str, ...] = (),
) -> SequenceRun:
    """Load a saved run, to resume it exactly. Raises SlamlibError for a file without a run of this kind.

    source: replaces the one of the saved run. front_end(calibration): makes one like that of the run, if it was given
    one. frames: total number of images, if not as before. places: where they are now, one place or, of pairs, a left
    and a right one; the last image that was used must be the same.
    """
    header, _ = checkpoint.read(path)
    saved = header.get("extra", {}).get(kind.name)
    if saved is None:
        raise SlamlibError(f"{path} holds no run on {kind.item}s: `slamlib run --resume` resumes a simulated one")
    with complete(path):
        if source is None and not saved["source"]:
            raise SlamlibError(f"{path}: its {kind.item}s were in memory; give them as source=...")
        done = len(saved["run"]["history"])
        if frames is not None and frames < done:
            raise SlamlibError(f"{path}: {done} {kind.item}s are done already, --frames {frames} is fewer")
        recipe = opening.moved(saved["source"], *places) if places else saved["source"]
        rig, options, told = Rig.from_dict(header["rig"]), Options.from_dict(header["options"]), saved["motion"]
        if front_end is None:
            motion = kind.source(rig.sensors[0], options, told["name"], told["settings"])
        else:
            motion = MotionSource(front_end(rig.sensors[0].calibration))
        slam = Slam.load(path, front_ends=[motion.front_end])
        motion.restore(told["state"])
        run = SequenceRun(source or opening.reopen(recipe, frames), slam, motion, kind)
        run.restore(saved["run"])
        check_columns(run.history, run.columns)
        return run
