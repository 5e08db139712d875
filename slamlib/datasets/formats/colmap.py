"""COLMAP's cameras.txt: a row "CAMERA_ID MODEL WIDTH HEIGHT PARAMS" for each camera; without extrinsics.

A file of one camera gives it, whatever its number. COLMAP's pixels have their centres at halves, slamlib's at whole
numbers.
"""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import FISHEYE, RADIAL, Lens
from slamlib.errors import SlamlibError, entry

# How many focal lengths, the model, and how many coefficients: all in OpenCV's order, after the principal point.
MODELS = {
    "SIMPLE_PINHOLE": (1, RADIAL, 0),
    "PINHOLE": (2, RADIAL, 0),
    "SIMPLE_RADIAL": (1, RADIAL, 1),
    "RADIAL": (1, RADIAL, 2),
    "OPENCV": (2, RADIAL, 4),
    "FULL_OPENCV": (2, RADIAL, 8),
    "SIMPLE_RADIAL_FISHEYE": (1, FISHEYE, 1),
    "RADIAL_FISHEYE": (1, FISHEYE, 2),
    "OPENCV_FISHEYE": (2, FISHEYE, 4),
}


def _fits(text: str) -> bool:
    rows = _rows(text)
    return bool(rows) and all(
        len(row) >= 4 and re.fullmatch("[A-Z_]{3,}", row[1]) and "".join((row[0], *row[2:4])).isdecimal()
        for row in rows
    )


def _read(path: Path, text: str) -> Cameras:
    cameras: Cameras = {int(number): partial(_lens, *row) for number, *row in _rows(text)}
    return cameras if len(cameras) > 1 else {None: next(iter(cameras.values()))}


def _rows(text: str) -> list[list[str]]:
    return [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]


def _lens(name: str, width: str, height: str, *given: str) -> Lens:
    focals, model, count = entry("camera model of COLMAP", name, MODELS)
    numbers = tuple(map(float, given))
    if len(numbers) != focals + 2 + count:
        raise SlamlibError(f"{name} has {focals + 2 + count} parameters, got {len(numbers)}")
    (cx, cy), coefficients = numbers[focals : focals + 2], numbers[focals + 2 :]
    return Lens(
        (cx - 0.5, cy - 0.5, numbers[0], numbers[focals - 1]), (float(width), float(height)), model, coefficients
    )


CALIBRATION = CalibrationReader("COLMAP", _fits, _read)
