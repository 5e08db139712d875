"""Calibration files, recognised by what is in them, as plain data for a SensorSetup.

slamlib's own    JSON or TOML with the fields of a SensorSetup, or of a Rig: any type of camera
EuRoC, Kalibr    sensor.yaml or camchain.yaml: intrinsics: [..], distortion_model: .., distortion_coefficients: [..]
OpenCV           YAML, XML or JSON of cv2.FileStorage: camera_matrix, distortion_coefficients, image_width, ...
KITTI            calib.txt: rows "P0: " and 12 numbers, or 12 numbers alone
plain text       rows such as "fx 500", "width 640", "k1 -0.3"; or one row "fx fy cx cy [k1 k2 p1 p2 [k3]]"
fr1, fr2, fr3    the colour cameras of TUM RGB-D, by name: no file is needed
"""

import json
import os
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from slamlib.data.plain import checked
from slamlib.data.setup import SensorSetup
from slamlib.datasets import calibration_files as files
from slamlib.datasets.lens import Lens
from slamlib.errors import SlamlibError

# Sturm and others, "File formats", on the pages of the TUM RGB-D benchmark: table of the colour cameras' intrinsics.
TUM = {
    "fr1": Lens((318.6, 255.3, 517.3, 516.5), (640, 480), distortion=(0.2624, -0.9531, -0.0054, 0.0026, 1.1633)),
    "fr2": Lens((325.1, 249.7, 520.9, 521.0), (640, 480), distortion=(0.2312, -0.7849, -0.0033, -0.0001, 0.9172)),
    "fr3": Lens((320.1, 247.6, 535.4, 539.2), (640, 480)),
}


@dataclass(frozen=True)
class Format:
    """fits(text) says whether a file's text is of this kind; read(path, text, number of the camera) gives the lens."""

    name: str
    fits: Callable[[str], bool]
    read: Callable[[Path, str, int], Lens]


FORMATS = (
    Format("OpenCV", files.is_opencv, files.opencv_storage),
    Format("EuRoC", files.is_euroc, files.euroc),
    Format("KITTI", files.is_kitti, files.kitti),
    Format("plain text", files.is_plain, files.plain),
)


def read_calibration(path: str | os.PathLike[str], camera: int = 0) -> dict[str, Any]:
    """Plain data of a SensorSetup; camera: its number in files of several.

    Raises SlamlibError for what cannot be read, and for lenses that slamlib's pin-hole cannot hold.
    """
    own = _own(path, camera)
    return read_lens(path, camera).setup() if own is None else own


def read_lens(path: str | os.PathLike[str], camera: int = 0) -> Lens:
    """The lens of a pin-hole or fisheye camera as its file describes it, to undistort pictures. Raises SlamlibError."""
    source = Path(path)
    if str(path) in TUM and not source.exists():
        return TUM[str(path)]
    own = _own(path, camera)
    if own is not None:
        return _lens_of(own, path)
    text = _text(source)
    form = next((form for form in FORMATS if form.fits(text)), None)
    if form is None:
        names = ", ".join(f.name for f in FORMATS)
        raise SlamlibError(f"{path} is no calibration that slamlib knows: its own JSON or TOML, {names}")
    try:
        return form.read(source, text, camera)
    except SlamlibError as error:
        raise SlamlibError(f"{path} ({form.name}): {error}") from None
    except (KeyError, ValueError, IndexError) as error:
        raise SlamlibError(f"{path} looks like a calibration of {form.name}, but is no whole one: {error}") from None


def _own(path: str | os.PathLike[str], camera: int) -> dict[str, Any] | None:
    """The setup in slamlib's own file, or None if it is another one."""
    source = Path(path)
    loads: Callable[[str], Any] | None = {".json": json.loads, ".toml": tomllib.loads}.get(source.suffix)
    if loads is None:
        return None
    try:
        data = loads(_text(source))
    except ValueError as error:
        raise SlamlibError(f"{path} cannot be read: {error}") from None
    if not isinstance(data, dict) or not {"parameters", "sensors"} & data.keys():
        return None
    sensors = data.get("sensors", [data])
    if not 0 <= camera < len(sensors):
        raise SlamlibError(f"{path} has {len(sensors)} cameras, counted from 0: there is no camera {camera}")
    return checked(SensorSetup, sensors[camera], f"{path}: sensors[{camera}]" if "sensors" in data else f"{path}")


def _lens_of(setup: dict[str, Any], path: str | os.PathLike[str]) -> Lens:
    """The lens of slamlib's own setup, if it is a pin-hole's, which OpenCV can undistort."""
    parameters = setup["parameters"]
    radial = tuple(parameters.get("distortion", ()))
    if set(parameters) - {"intrinsics", "distortion"} or "intrinsics" not in parameters or len(radial) > 3:
        raise SlamlibError(
            f"{path}: OpenCV undistorts pin-holes with up to three coefficients; leave --undistort out, since slamlib "
            "works on this camera's pictures as they are"
        )
    k1, k2, k3 = (*radial, 0.0, 0.0, 0.0)[:3]
    image = tuple(setup["image"]) if setup.get("image") else None
    return Lens(tuple(parameters["intrinsics"]), image, distortion=(k1, k2, 0.0, 0.0, k3))


def _text(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        raise SlamlibError(f"the calibration {path} cannot be read: {why}; {', '.join(TUM)} need no file") from None
