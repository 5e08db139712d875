"""MRPT's camera files: a section [CAMERA_PARAMS], or [..._LEFT], [..._RIGHT] and [..._LEFT2RIGHT_POSE] of a pair.

The pose is that of the right camera in the left one's frame, pose_quaternion = [x y z qr qx qy qz]; other sections are
of other things.
"""

from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, lens_of, placed
from slamlib.datasets.lens_models import RADIAL, WORDS
from slamlib.errors import entry
from slamlib.geometry.quaternion import rotation
from slamlib.plain_data.entries import Entries, Numbers, named_values

UNUSED = (*METADATA, "rawloggrabberignore", "focallengthmeters")
UNUSED_OF_POSE = (*UNUSED, "translationonly", "rotationmatrixonly", "poseyawpitchroll")
LEFT, RIGHT, POSE = "_LEFT", "_RIGHT", "_LEFT2RIGHT_POSE"


def _sections(text: str) -> list[str]:
    """The names of those that are of cameras."""
    values = named_values(text).items()
    return [name for name, value in values if isinstance(value, dict) and {"resolution", "fx"} <= value.keys()]


def _fits(text: str) -> bool:
    return bool(_sections(text))


def _read(path: Path, text: str) -> Cameras:
    whole, names = Entries(named_values(text)), _sections(text)
    prefix = next((name.removesuffix(LEFT) for name in names if name.endswith(LEFT)), None)
    if prefix is None:
        return {None: partial(_lens, whole.inside(names[0]), None)}
    place = whole.inside(prefix + POSE)
    x, y, z, *turn = place.numbers("pose_quaternion", count=7)
    place.close(UNUSED_OF_POSE)
    poses = placed((0, 0, 0)), placed((x, y, z), rotation(np.array(turn) / np.linalg.norm(turn)))
    sides = zip((LEFT, RIGHT), poses, strict=True)
    return {number: partial(_lens, whole.inside(prefix + side), pose) for number, (side, pose) in enumerate(sides)}


def _lens(entries: Entries, pose: Numbers | None) -> Lens:
    focals = map(entries.number, ("fx", "fy", "cx", "cy"))
    size, coefficients = entries.numbers("resolution", count=2), entries.numbers("dist", needed=False)
    word = entries.word("distortion", "distortion_model", "model", default="plumb_bob")
    model = entry("model of distortion", word, {**WORDS, "none": RADIAL})
    found = lens_of(*focals, image=size, model=model, distortion=coefficients, transform=pose)
    entries.close(UNUSED)
    return found


CALIBRATION = CalibrationReader("MRPT", _fits, _read)
