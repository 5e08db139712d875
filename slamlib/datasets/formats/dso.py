"""The camera.txt of DSO, of LSD-SLAM and of TUM's monocular data set; one camera.

A row "[MODEL] fx fy cx cy ..."; "width height"; then what becomes of the pictures, which nobody here needs. Relative to
the picture's size, as they mostly are, its pixels have their centres at halves.
"""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, lens_of
from slamlib.datasets.lens_models import FISHEYE, FOV, RADIAL
from slamlib.errors import SlamlibError
from slamlib.plain_data.entries import Numbers
from slamlib.plain_data.parsing import value_of

# The model, and how many coefficients; of rows without a name, those of five numbers are FOV, those of eight RadTan.
MODELS = {
    "Pinhole": (RADIAL, 1),
    "FOV": (FOV, 1),
    "ATAN": (FOV, 1),
    "RadTan": (RADIAL, 4),
    "EquiDistant": (FISHEYE, 4),
    "KannalaBrandt": (FISHEYE, 4),
}
_OUTPUT = ("crop", "full", "none")


def _fits(text: str) -> bool:
    rows = _rows(text)
    lengths = [*map(len, rows)]
    unnamed = (
        lengths[:2] in ([5, 2], [8, 2]) and lengths[3:4] == [2] and (rows[2][0] in _OUTPUT or lengths[2] in (4, 5))
    )
    return len(rows) > 1 and (rows[0][0] in MODELS or unnamed)


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, _rows(text))}


def _rows(text: str) -> list[list[str]]:
    lines = (re.split(r"[\s,]+", line.partition("#")[0].strip()) for line in text.splitlines())
    return [line for line in lines if line != [""]]


def _numbers(row: list[str], counts: tuple[int, ...], what: str) -> Numbers:
    found = tuple(value for word in row if isinstance(value := value_of(word), int | float))
    if len(found) != len(row) or len(row) not in counts:
        raise SlamlibError(f"{what} are {' or '.join(map(str, counts))} numbers, got {' '.join(row)!r}")
    return found


def _lens(rows: list[list[str]]) -> Lens:
    first, size, *output = rows
    if first[0] in MODELS:
        model, count = MODELS[first[0]]
        given = _numbers(first[1:], (4 + count,), f"the parameters of {first[0]}")
    else:
        given = _numbers(first, (5, 8), "the parameters of a camera")
        model, _ = MODELS["RadTan" if len(given) == 8 else "FOV" if given[4] else "Pinhole"]
    width, height = _numbers(size, (2,), "the pictures' width and height")
    if len(output) > 2:
        raise SlamlibError(f"four lines are known, and there is another one: {' '.join(output[2])!r}")
    (fx, fy, cx, cy), coefficients = given[:4], given[4:]
    if cx < 1 and cy < 1:
        fx, fy, cx, cy = width * fx, height * fy, width * cx - 0.5, height * cy - 0.5
    if first[0] == "Pinhole" and any(coefficients):
        raise SlamlibError(f"a Pinhole has no distortion, and its fifth number is {coefficients[0]:g}")
    return lens_of(fx, fy, cx, cy, image=(width, height), model=model, distortion=coefficients)


CALIBRATION = CalibrationReader("DSO", _fits, _read)
