"""BoofCV's YAML: of one camera (model: pinhole_radial_tangential, ...), or of two (model: stereo_camera).

rightToLeft takes points of the right camera's frame to the left one's, in the unit of its target.
"""

from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, check_skew, lens_of, placed, rigid
from slamlib.datasets.lens_models import RADIAL, UNIFIED
from slamlib.errors import SlamlibError, entry
from slamlib.plain_data.entries import Entries, Numbers, named_values

STEREO = "stereo_camera"
MODELS = {
    "pinhole": (RADIAL, ()),
    "pinhole_radial_tangential": (RADIAL, ()),
    "omnidirectional_universal": (UNIFIED, ("mirror_offset",)),
}


def _fits(text: str) -> bool:
    data = named_values(text)
    return "pinhole" in data or data.get("model") == STEREO


def _read(path: Path, text: str) -> Cameras:
    whole = Entries(named_values(text))
    if whole.data.get("model") != STEREO:
        return {None: partial(_lens, whole, None)}
    place = whole.inside("rightToLeft")
    turn, shift = place.numbers("rotation", count=9), tuple(map(place.number, "xyz"))
    right = rigid(placed(shift, np.reshape(turn, (3, 3))), "rightToLeft")
    sides = {0: (whole.inside("left"), placed((0, 0, 0))), 1: (whole.inside("right"), right)}
    return {number: partial(_lens, *side) for number, side in sides.items()}


def _lens(entries: Entries, pose: Numbers | None) -> Lens:
    model, first = entry("model of BoofCV", str(entries.value("model")), MODELS)
    pinhole, distortion = entries.inside("pinhole"), entries.inside("radial_tangential")
    fx, fy, cx, cy, *size = map(pinhole.number, ("fx", "fy", "cx", "cy", "width", "height"))
    check_skew(pinhole.number("skew"), fx)
    radial = distortion.numbers("radial", needed=False)
    if len(radial) > 3:
        raise SlamlibError(f"radial has more than three coefficients: {radial}")
    k1, k2, k3 = (*radial, *(0.0,) * (3 - len(radial)))
    t1, t2 = (distortion.number(name, default=0.0) for name in ("t1", "t2"))
    coefficients = (*map(entries.number, first), k1, k2, t1, t2, k3)
    entries.close(METADATA)
    return lens_of(fx, fy, cx, cy, image=tuple(size), model=model, distortion=coefficients, transform=pose)


CALIBRATION = CalibrationReader("BoofCV", _fits, _read)
