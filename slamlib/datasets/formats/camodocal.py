"""camodocal's YAML, which VINS-Fusion reads: model_type, projection_parameters, distortion_parameters; one camera."""

from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, lens_of
from slamlib.datasets.lens_models import FISHEYE, RADIAL, UNIFIED
from slamlib.errors import SlamlibError, entry
from slamlib.plain_data.entries import Entries, named_values

# The names of (fx, fy, cx, cy), and of the coefficients: its k2 to k5 of a fisheye are k1 to k4 of OpenCV's.
_PINHOLE, _MIRROR = ("fx", "fy", "cx", "cy"), ("gamma1", "gamma2", "u0", "v0")
MODELS = {
    "PINHOLE": (RADIAL, _PINHOLE, ("k1", "k2", "p1", "p2")),
    "PINHOLE_FULL": (RADIAL, _PINHOLE, ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")),
    "KANNALA_BRANDT": (FISHEYE, ("mu", "mv", "u0", "v0"), ("k2", "k3", "k4", "k5")),
    "MEI": (UNIFIED, _MIRROR, ("xi", "k1", "k2", "p1", "p2")),
}


def _fits(text: str) -> bool:
    return "projection_parameters" in named_values(text)


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, Entries(named_values(text)))}


def _lens(entries: Entries) -> Lens:
    model, focals, coefficients = entry("model_type of camodocal", str(entries.value("model_type")), MODELS)
    size = tuple(map(entries.number, ("image_width", "image_height")))
    groups = [entries.value(f"{name}_parameters") or {} for name in ("projection", "distortion", "mirror")]
    parameters = Entries({name: value for group in groups for name, value in Entries(group).data.items()})
    if len(parameters.data) < sum(map(len, groups)):
        raise SlamlibError("a name is both in projection_parameters and in distortion_parameters: delete one of them")
    fx, fy, cx, cy = map(parameters.number, focals)
    distortion = tuple(map(parameters.number, coefficients))
    for read in (entries, parameters):
        read.close(METADATA)
    return lens_of(fx, fy, cx, cy, image=size, model=model, distortion=distortion)


CALIBRATION = CalibrationReader("camodocal", _fits, _read)
