"""Calibration files of one camera or of a pair, recognised by their content; each format is a file in formats/.

fr1, fr2 and fr3 are the colour cameras of TUM RGB-D, by name: no file is needed.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from slamlib.datasets.dataset import Camera
from slamlib.datasets.formats import DATASETS, READERS
from slamlib.datasets.lens import Lens, PairCalibration
from slamlib.errors import SlamlibError

NO_BASELINE = (
    "the baseline is missing: the distance of the right camera from the left one. Write a JSON file with "
    '{"intrinsics": [u0, v0, au, av], "baseline": metres}, or give a file of both cameras'
)

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

    Raises SlamlibError for an unreadable file, and if the baseline is missing.
    """
    if len(paths) > 2:
        raise SlamlibError(f"a calibration is one file, or one for each of two cameras, not {len(paths)}")
    pair = PairCalibration(*map(read_lens, paths * (3 - len(paths)), cameras))
    if pair.right.transform is None:
        raise SlamlibError(f"{' and '.join(map(str, paths))}: {NO_BASELINE}")
    if not np.linalg.norm(pair.transform[:3, 3]) > 0:
        raise SlamlibError(f"{' and '.join(map(str, paths))}: both cameras have the same position; {NO_BASELINE}")
    return pair


def _read(path: str | Path, camera: int, what: Callable[[Camera], Found]) -> Found:
    """The value of what(camera), for a camera of the file, which has setup() and lens."""
    named = {name: lens for dataset in DATASETS.values() for name, lens in dataset.lenses.items()}
    if str(path) in named and not Path(path).exists():
        return what(named[str(path)])
    try:
        text = Path(path).read_text("utf-8")
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        names = ", ".join(named)
        raise SlamlibError(f"the calibration {path} cannot be read: {why}; {names} need no file") from None
    reader = next((reader for reader in READERS.values() if reader.fits(text)), None)
    if reader is None:
        raise SlamlibError(f"{path} is no calibration that slamlib knows: {', '.join(READERS)}")
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
