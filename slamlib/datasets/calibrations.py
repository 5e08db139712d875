"""Calibration files of one camera or of a pair, recognised by what is in them.

slamlib's own    JSON or TOML with the fields of a SensorSetup (any type of camera, or "stereo"), or of a Rig
rectified pair   JSON or TOML with the fields of RectifiedPair
others           a file in slamlib.datasets.formats for each: EuRoC and Kalibr, KITTI, OpenCV, plain text
fr1, fr2, fr3    the colour cameras of TUM RGB-D, by name: no file is needed
"""

import json
import os
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from slamlib.data.plain import Range, checked, read
from slamlib.data.setup import SensorSetup
from slamlib.datasets.formats import DATASETS, READERS
from slamlib.datasets.lens import Lens, Numbers, PairCalibration, shifted
from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import rotation

Path_ = str | os.PathLike[str]
Positive = Annotated[float, Range(gt=0)]
NO_BASELINE = (
    "the baseline is missing: how far the right camera is from the left one. Write a JSON file with "
    '{"intrinsics": [u0, v0, au, av], "baseline": metres}, or give a file of both cameras'
)


@dataclass(frozen=True)
class RectifiedPair:
    """Of both cameras: intrinsics (u0, v0, au, av) [px]; image (width, height) [px]; std of u, v and disparity [px].

    offset [px]: column of the right principal point minus that of the left one.
    """

    intrinsics: tuple[float, float, Positive, Positive]
    baseline: Annotated[float, Range(gt=0, lt=np.inf, unit="m")]
    image: tuple[float, float] | None = None
    offset: float = 0.0
    std: Numbers | None = None

    @property
    def calibration(self) -> PairCalibration:
        """The two lenses and their places."""
        u, v, a, b = self.intrinsics
        said = {} if self.std is None else {"std": self.std}
        right = Lens((u + self.offset, v, a, b), self.image, place=shifted(self.baseline))
        return PairCalibration(Lens((u, v, a, b), self.image), right, said)


def read_calibration(path: Path_, camera: int = 0) -> dict[str, Any]:
    """Plain data of a SensorSetup; camera: its number in files of several.

    Raises SlamlibError for what cannot be read, and for lenses that slamlib's pin-hole cannot hold.
    """
    own = _own(path)
    return read_lens(path, camera).setup() if own is None else _setup(own, path, camera)


def read_lens(path: Path_, camera: int = 0) -> Lens:
    """The lens of a pin-hole or fisheye camera as its file describes it, to undistort pictures. Raises SlamlibError."""
    named = _named()
    if str(path) in named and not Path(path).exists():
        return named[str(path)]
    own = _own(path)
    if own is not None:
        return _lens_of(_setup(own, path, camera), path, "sensors" in own)
    text = _text(Path(path))
    reader = next((reader for reader in READERS.values() if reader.fits(text)), None)
    if reader is None:
        raise SlamlibError(f"{path} is no calibration that slamlib knows: its own JSON or TOML, {', '.join(READERS)}")
    try:
        lenses = reader.read(Path(path), text)
        number = None if None in lenses and camera not in lenses else camera
        return _numbered(lenses, number)()
    except SlamlibError as error:
        raise SlamlibError(f"{path} ({reader.name}): {error}") from None
    except (KeyError, ValueError, IndexError) as error:
        raise SlamlibError(f"{path} looks like a calibration of {reader.name}, but is no whole one: {error}") from None


def read_pair(paths: list[str], cameras: tuple[int, int] = (0, 1)) -> PairCalibration:
    """The calibration in one file, or in one for each camera; cameras: their numbers in files of several.

    Raises SlamlibError for what cannot be read, and where the baseline is missing.
    """
    if len(paths) > 2:
        raise SlamlibError(f"a calibration is one file, or one for each of two cameras, not {len(paths)}")
    data = _data(paths[0]) if len(paths) == 1 else None
    if data is not None and not {"parameters", "sensors"} & data.keys() and {"baseline", "intrinsics"} & data.keys():
        if "baseline" not in data:
            raise SlamlibError(f"{paths[0]}: {NO_BASELINE}")
        return read(RectifiedPair, data, paths[0]).calibration
    setups = [] if data is None else data.get("sensors", [data])
    stereo = next((s for s in setups if isinstance(s, dict) and s.get("type") == "stereo"), None)
    if stereo is not None:
        return _stereo(checked(SensorSetup, stereo, paths[0]))
    left, right = (read_lens(path, camera) for path, camera in zip(paths * (3 - len(paths)), cameras, strict=True))
    pair = PairCalibration(left, right)
    if right.place is None:
        raise SlamlibError(f"{' and '.join(paths)}: {NO_BASELINE}")
    if not np.linalg.norm(pair.place[:3, 3]) > 0:
        raise SlamlibError(f"{' and '.join(paths)}: both cameras are in one place; {NO_BASELINE}")
    return pair


def _named() -> dict[str, Lens]:
    """The lenses that need no file."""
    return {name: lens for dataset in DATASETS.values() for name, lens in dataset.lenses.items()}


def _numbered(cameras: Mapping[Any, Any], number: int | None) -> Any:
    if number not in cameras:
        raise SlamlibError(f"there is no camera {number}, but {', '.join(map(str, cameras))}")
    return cameras[number]


def _data(path: Path_) -> dict[str, Any] | None:
    """What a JSON or TOML file holds, or None if it is none. Raises SlamlibError."""
    loads: Callable[[str], Any] | None = {".json": json.loads, ".toml": tomllib.loads}.get(Path(path).suffix)
    if loads is None:
        return None
    try:
        data = loads(_text(Path(path)))
    except ValueError as error:
        raise SlamlibError(f"{path} cannot be read: {error}") from None
    return data if isinstance(data, dict) else None


def _own(path: Path_) -> dict[str, Any] | None:
    """The plain data of a SensorSetup or a Rig, or None if the file holds neither."""
    data = _data(path)
    return data if data is not None and {"parameters", "sensors"} & data.keys() else None


def _setup(own: dict[str, Any], path: Path_, camera: int) -> dict[str, Any]:
    """The plain data of one camera, checked."""
    if "sensors" not in own:
        return checked(SensorSetup, own, str(path))
    try:
        return checked(SensorSetup, _numbered(dict(enumerate(own["sensors"])), camera), f"sensors[{camera}]")
    except SlamlibError as error:
        raise SlamlibError(f"{path}: {error}") from None


def _lens_of(setup: dict[str, Any], path: Path_, of_rig: bool) -> Lens:
    """The lens of slamlib's own setup, if it is a pin-hole's, which OpenCV can undistort."""
    sensor = SensorSetup(**setup)
    parameters = sensor.parameters
    radial = tuple(parameters.get("distortion", ()))
    if set(parameters) - {"intrinsics", "distortion"} or "intrinsics" not in parameters or len(radial) > 3:
        raise SlamlibError(
            f"{path}: OpenCV undistorts pin-holes with up to three coefficients; leave --undistort out, since slamlib "
            "works on this camera's pictures as they are"
        )
    k1, k2, k3 = (*radial, 0.0, 0.0, 0.0)[:3]
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = rotation(sensor.mount[3:]), sensor.mount[:3]
    lens = Lens(parameters["intrinsics"], setup.get("image"), distortion=(k1, k2, 0.0, 0.0, k3))
    return replace(lens, place=tuple(place.ravel().tolist())) if of_rig else lens


def _stereo(setup: dict[str, Any]) -> PairCalibration:
    """Of slamlib's own stereo sensor."""
    sensor = SensorSetup(**setup)
    given = sensor.calibration.given  # checked
    lens = Lens(tuple(given["intrinsics"].tolist()), sensor.image)
    said = {"std": sensor.std, "noise": sensor.noise, "limits": sensor.limits}
    return PairCalibration(lens, replace(lens, place=shifted(float(given["baseline"][0]))), said)


def _text(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        raise SlamlibError(
            f"the calibration {path} cannot be read: {why}; {', '.join(_named())} need no file"
        ) from None
