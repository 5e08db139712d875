"""Runs on pictures: of one camera, or of stereo pairs; begun, and loaded.

**Scale.** One camera cannot tell how large the world is: all pictures are the same if world, path and velocities are
made k times as large. With a free scale the priors alone choose k: the inverse distance that new landmarks are begun
with, and the velocities and impulses of the motion. The unit of length is then the one in which the first landmarks are
about 1 / mean away (Options.inverse_distance). It drifts as new landmarks take over from old ones, and a trajectory is
compared with a reference after a similarity (slamlib.evaluation.alignment). A known target (slamlib.vision.target)
gives true lengths, and so does the baseline of a stereo pair.

**Frame of reference.** The robot's first pose is the world's origin, known exactly; it looks along x, and its (left)
camera is at its own origin. With a target the world is the target's.

**Without matches** a frame is a prediction. The camera's place is sought by the filter's expectation alone (there is no
relocalization), so that a run stops with TrackingLostError when a gap lasts too long (slamlib.vision.sequence_run).
"""

import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.data.plain import read, read_fields
from slamlib.data.setup import Rig, RobotSetup, SensorSetup
from slamlib.datasets import opening
from slamlib.datasets.dataset import ImageSource
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options, Slam, checkpoint
from slamlib.slam.data_association.front_end import FrontEnd
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.front_end import CombinedFrontEnd, MotionSource
from slamlib.vision.line_search import SegmentSearch
from slamlib.vision.sequence_run import SequenceKind, SequenceRun
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import check_pair
from slamlib.vision.stereo.motion_source import MOTION_SOURCES, OdometryOnly, StereoMotionSource
from slamlib.vision.target import Target


def make_front_end(
    options: Options, calibration: Calibration, rng: np.random.Generator, settings: ActiveSearchSettings | None = None
) -> ActiveSearch | CombinedFrontEnd:
    """What finds the landmarks that these options ask for: points, and lines beside them if there are to be any."""
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
        "was there a cut, or was the camera covered? Did it move more than the motion's impulses allow for, or do "
        "they allow for so much that of regions only the middle was searched (active search's setting `largest`)?",
        "no landmark could be initialized: is there light, and texture?",
    ),
    _image_source,
    Options(
        points="ahmPnt", updates=25, max_new_first=12, max_new=3, inverse_distance=(1.0, 0.5), outlier_rejection="joint"
    ),
    impulse=(0.3, 10.0),
    velocity=(0.3, 10.0),
    noise=(0.1,),  # of a matched patch; the real sequences' NIS says that this is rather too much than too little
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
    Options(points="eucPnt", updates=100, max_new_first=100, max_new=30, margin=0.0),
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
    """A camera (plain data of a SensorSetup) that is carried about, as a rig; it starts at the origin, looking along x.

    impulse, velocity: standard deviations as of a SequenceKind, whose own are the default. unit: typical distance of
    what is seen [m], which these are scaled with; with a free scale it is the metre of the run itself, 1.
    """
    velocity_std, control_std = (
        tuple(np.repeat((default[0] * unit, default[1]) if given is None else given, 3).tolist())
        for given, default in ((velocity, kind.velocity), (impulse, kind.impulse))
    )
    robot = RobotSetup(motion=motion, velocity_std=velocity_std, control_std=control_std)
    return Rig((robot,), (SensorSetup(**{"std": kind.noise, **read_fields(SensorSetup, camera, "camera")}),))


def options_for(unit: float = 1.0, known: int = 0, **said: Any) -> Options:
    """The options of IMAGES for what is about `unit` [m] away, with those that are said in their places.

    A prior that is wrong for most landmarks is a wrong measurement of the scale, repeated with each of them. known: how
    many points of a target there are. They are looked at besides the others, and first of all: by information alone the
    most uncertain landmarks are chosen, and the known ones, which hold the scale, never.
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
    patience: int = 30,
    rng: np.random.Generator | None = None,
) -> SequenceRun:
    """A run on pictures. rig: one robot with one camera. scale: a known target, or None for a free scale.

    front_end: default ActiveSearch, which draws with `rng`, and beside it SegmentSearch if the options have lines.
    patience: frames without a match, after which the run stops. The impulses of the rig's motion are those between two
    neighbours of the whole source: a longer time passes in steps of as long. Raises SlamlibError.
    """
    if len(rig.robots) != 1 or len(rig.sensors) != 1:
        raise SlamlibError("image_run: a rig of one robot with one camera is wanted")
    rig = rig if scale is None else scale.placed(rig)
    own = front_end or make_front_end(options, rig.sensors[0].calibration, rng or np.random.default_rng(0))
    slam = Slam(rig, options, front_ends=[own])
    metric = scale is not None
    return SequenceRun(source, slam, MotionSource(own), IMAGES, patience=patience, metric=metric, target=scale)


def open_stereo(
    *places: Any, settings: StereoSettings | None = None, **options: Any
) -> tuple[ImageSource, dict[str, Any], StereoSettings]:
    """As slamlib.datasets.opening.open_rectified_pairs, and the settings with the calibration's offset of disparities.

    The first pair is read: its rows and the sign of its disparities are checked. Raises SlamlibError.
    """
    pairs, camera, offset = opening.open_rectified_pairs(*places, **options)
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
    motion_source: str = "split-features",
    settings: StereoSettings | None = None,
    impulse: tuple[float, float] | None = None,
    velocity: tuple[float, float] | None = None,
    patience: int = 30,
) -> SequenceRun:
    """A run on rectified pairs. camera: plain data of their stereo SensorSetup (open_stereo gives both).

    motion_source: of PAIR_MOTION_SOURCES; "odometry" is visual odometry alone: the filter has no landmarks, and adds up
    motions and their covariances. impulse, velocity: as of a SequenceKind, where the robot's motion has velocities.
    patience: pairs without a match, after which the run stops. Raises SlamlibError.
    """
    if motion_source not in PAIR_MOTION_SOURCES:
        raise UnknownNameError.of("motion of a stereo run", motion_source, PAIR_MOTION_SOURCES)
    chosen = PAIR_MOTION_SOURCES[motion_source]
    rig = camera_rig(camera, PAIRS, motion=chosen.motion, impulse=impulse, velocity=velocity)
    motion = chosen(rig.sensors[0].calibration, rig.sensors[0].extrinsics, settings)
    options = Options(points=None) if motion_source == "odometry" else options
    return SequenceRun(source, Slam(rig, options, front_ends=[motion.front_end]), motion, PAIRS, patience=patience)


def load(
    path: str | os.PathLike[str],
    kind: SequenceKind = IMAGES,
    *,
    source: ImageSource | None = None,
    front_end: Callable[[Calibration], FrontEnd] | None = None,
    frames: int | None = None,
) -> SequenceRun:
    """Go on exactly where a saved run was. Raises SlamlibError for a file that holds none of this kind.

    source: in place of the one that it was begun with. front_end(calibration): makes one like that of the run, if it
    was given one. frames: how many pictures in all, if not as many as before.
    """
    header, _ = checkpoint.read(path)
    saved = header["extra"].get(kind.name)
    if saved is None:
        raise SlamlibError(f"{path} holds no run on {kind.item}s: `slamlib run --resume` goes on with a simulated one")
    if source is None and not saved["source"]:
        raise SlamlibError(f"{path}: its {kind.item}s were in memory; give them as source=...")
    rig, options, told = Rig.from_dict(header["rig"]), Options.from_dict(header["options"]), saved["motion"]
    if front_end is None:
        motion = kind.source(rig.sensors[0], options, told["name"], told["settings"])
    else:
        motion = MotionSource(front_end(rig.sensors[0].calibration))
    slam = Slam.load(path, front_ends=[motion.front_end])
    motion.restore(told["state"])
    return SequenceRun(source or opening.reopen(saved["source"], frames), slam, motion, kind, **saved["run"])
