"""Calibration files of one camera or of a pair, recognised by their content; each format is a file in formats/.

fr1, fr2 and fr3 are the colour cameras of TUM RGB-D, by name: no file is needed.
"""

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Camera
from slamlib.datasets.formats import DATASETS, READERS
from slamlib.datasets.lens import Lens, PairCalibration
from slamlib.errors import SlamlibError
from slamlib.plain_data.files import read_text
from slamlib.plain_data.parsing import parsed
from slamlib.plain_data.rows import decimal_comma, with_a_point
from slamlib.rigs.builders import BASELINES

NO_BASELINE = (
    "the baseline is missing: the distance of the right camera from the left one. Write a JSON file with "
    '{"intrinsics": [u0, v0, au, av], "baseline": metres}, or give a file of both cameras'
)
UNIT = "are its lengths in millimetres ({:g} m), or in centimetres ({:g} m)? "
IN_METRES = (
    "slamlib's lengths are in metres: bring the file's to metres; if {0:g} m is right, write slamlib's own JSON of the "
    'rectified pair, {{"intrinsics": [u0, v0, au, av], "baseline": {0:g}}}'
)
NAMED = 8  # how many names of a file of another kind are shown

Found = TypeVar("Found")  # what is asked of a camera


def read_calibration(path: str | Path, camera: int = 0) -> dict[str, Any]:
    """Plain data of a SensorSetup; camera: its number in files of several.

    Raises SlamlibError for an unreadable file, and for lenses that slamlib's pin-hole cannot represent.
    """
    return _read(path, camera, lambda found: found.setup())


def read_lens(path: str | Path, camera: int = 0) -> Lens:
    """The lens of a pin-hole or fisheye camera as its file describes it, to undistort pictures. Raises SlamlibError."""
    return _read(path, camera, lambda found: found.lens)


def read_pair(paths: list[str] | list[Path], cameras: tuple[int, int] = (0, 1)) -> PairCalibration:
    """The calibration in one file, or in one for each camera; cameras: their numbers in files of several.

    Raises SlamlibError for an unreadable file, and if the baseline is missing, or is of another unit than the metre.
    """
    if len(paths) > 2:
        raise SlamlibError(f"a calibration is one file, or one for each of two cameras, not {len(paths)}")
    pair = PairCalibration(*map(read_lens, paths * (3 - len(paths)), cameras))
    where = " and ".join(map(str, paths))
    if None in (pair.left.transform, pair.right.transform):
        raise SlamlibError(f"{where}: {NO_BASELINE}")
    baseline = float(np.linalg.norm(pair.transform[:3, 3]))
    if not baseline > 0:
        raise SlamlibError(f"{where}: both cameras have the same position; {NO_BASELINE}")
    if not BASELINES[0] <= baseline <= BASELINES[1]:
        unusual = f"{where}: the baseline is {baseline:g} m"
        if all(_recognized(path)[0].in_metres for path in paths):
            warnings.warn(f"{unusual}, which is taken as it is", stacklevel=2)
        else:
            question = UNIT.format(baseline / 1000, baseline / 100) if baseline > BASELINES[1] else ""
            raise SlamlibError(f"{unusual}: {question}{IN_METRES.format(baseline)}")
    return pair


def _named() -> dict[str, Lens]:
    """The lenses that need no file, by their names."""
    return {name: lens for dataset in DATASETS.values() for name, lens in dataset.lenses.items()}


def _recognized(path: str | Path) -> tuple[CalibrationReader, str]:
    """The format of a file, and its text. Raises SlamlibError for a file of another kind."""
    try:
        text = read_text(path)
    except SlamlibError as error:
        raise SlamlibError(f"the calibration {error}; {', '.join(_named())} need no file") from None
    reader = next((reader for reader in READERS.values() if reader.fits(text)), None)
    if reader is None:
        raise SlamlibError(f"{path} is no calibration that slamlib knows{_reason(text)}: {', '.join(READERS)}")
    return reader, text


def _reason(text: str) -> str:
    """What is wrong with a text, or the names that it has, in brackets."""
    try:
        data = parsed(text)
    except SlamlibError as error:
        return f" ({error})"
    names = list(data) if isinstance(data, dict) else []
    with_comma = next(filter(None, map(decimal_comma, text.splitlines())), None)
    if not names and with_comma:
        return f" ({with_a_point(with_comma)})"
    return f" (it has {', '.join(names[:NAMED])}{', ...' * (len(names) > NAMED)})" if names else ""


def _read(path: str | Path, camera: int, what: Callable[[Camera], Found]) -> Found:
    """The value of what(camera), for a camera of the file, which has setup() and lens."""
    if str(path) in _named() and not Path(path).exists():
        return what(_named()[str(path)])
    reader, text = _recognized(path)
    try:
        cameras = reader.read(Path(path), text)
        number = camera if camera in cameras else None
        if number not in cameras:
            raise SlamlibError(f"there is no camera {camera}, but {', '.join(map(str, cameras))}")
        return what(cameras[number]())
    except SlamlibError as error:
        raise SlamlibError(f"{path} ({reader.name}): {error}") from None
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise SlamlibError(f"{path} looks like a calibration of {reader.name}, but is incomplete: {error}") from None
