"""COLMAP's cameras.txt: a row "CAMERA_ID MODEL WIDTH HEIGHT PARAMS" for each camera; without extrinsics.

A file of one camera gives it, whatever its number. COLMAP's pixels have their centres at halves, slamlib's at whole
numbers.
"""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, lens_of
from slamlib.datasets.lens_models import DIVISION, EXTENDED, FISHEYE, FOV, RADIAL, THIN_PRISM
from slamlib.errors import SlamlibError, entry

# How many focal lengths, the model, and how many coefficients: all in its order, after the principal point.
MODELS = {
    "SIMPLE_PINHOLE": (1, RADIAL, 0),
    "PINHOLE": (2, RADIAL, 0),
    "SIMPLE_RADIAL": (1, RADIAL, 1),
    "RADIAL": (1, RADIAL, 2),
    "OPENCV": (2, RADIAL, 4),
    "FULL_OPENCV": (2, RADIAL, 8),
    "SIMPLE_FISHEYE": (1, FISHEYE, 0),
    "FISHEYE": (2, FISHEYE, 0),
    "SIMPLE_RADIAL_FISHEYE": (1, FISHEYE, 1),
    "RADIAL_FISHEYE": (1, FISHEYE, 2),
    "OPENCV_FISHEYE": (2, FISHEYE, 4),
    "THIN_PRISM_FISHEYE": (2, THIN_PRISM, 8),
    "FOV": (2, FOV, 1),
    "EUCM": (2, EXTENDED, 2),
    "SIMPLE_DIVISION": (1, DIVISION, 1),
    "DIVISION": (2, DIVISION, 1),
}


def _fits(text: str) -> bool:
    rows = _rows(text)
    return bool(rows) and all(
        len(row) >= 4 and re.fullmatch("[A-Z_]{3,}", row[1]) and "".join((row[0], *row[2:4])).isdecimal()
        for row in rows
    )


def _read(path: Path, text: str) -> Cameras:
    cameras: Cameras = {int(number): partial(_lens, *row) for number, *row in _rows(text)}
    if len(cameras) < len(_rows(text)):
        raise SlamlibError("two cameras have the same number: delete one of them")
    return cameras if len(cameras) > 1 else {None: next(iter(cameras.values()))}


def _rows(text: str) -> list[list[str]]:
    lines = (line.partition("#")[0].split() for line in text.splitlines())
    return [line for line in lines if line]


def _lens(name: str, width: str, height: str, *given: str) -> Lens:
    focals, model, count = entry("camera model of COLMAP", name, MODELS)
    try:
        numbers = tuple(map(float, given))
    except ValueError as error:
        raise SlamlibError(f"the parameters of {name} are numbers: {error}") from None
    if len(numbers) != focals + 2 + count:
        raise SlamlibError(f"{name} has {focals + 2 + count} parameters, got {len(numbers)}")
    (cx, cy), coefficients = numbers[focals : focals + 2], numbers[focals + 2 :]
    size = float(width), float(height)
    return lens_of(
        numbers[0], numbers[focals - 1], cx - 0.5, cy - 0.5, image=size, model=model, distortion=coefficients
    )


CALIBRATION = CalibrationReader("COLMAP", _fits, _read)
