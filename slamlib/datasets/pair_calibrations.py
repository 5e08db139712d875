"""Calibration files of two cameras: lenses and places of both, from one file or from one for each.

plain JSON       "intrinsics": [u0, v0, au, av], "baseline" [m]; perhaps "image": [width, height], "offset" [px], "std"
slamlib's own    JSON or TOML: a SensorSetup of type "stereo", or a Rig with one, or with a left and a right pin-hole
KITTI            calib.txt with P0 and P1 (or P2 and P3): projection matrices of the rectified pair
EuRoC, Kalibr    a sensor.yaml for each camera, or one camchain.yaml: pictures as the lenses made them
OpenCV           M1, D1, M2, D2, with R and T
"""

import json
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.setup import Rig, SensorSetup, tuples
from slamlib.datasets.calibrations import read_lens
from slamlib.datasets.lens import Lens
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.geometry.pose import relative
from slamlib.geometry.quaternion import rotation
from slamlib.kalman.linalg import finite
from slamlib.manifolds import Array

PLAIN = ("intrinsics", "baseline", "image", "offset", "std")
NO_BASELINE = (
    "the baseline is missing: how far the right camera is from the left one. Write a JSON file with "
    '{"intrinsics": [u0, v0, au, av], "baseline": metres}, or give a file of both cameras'
)


@dataclass(frozen=True)
class PairCalibration:
    """The lenses of the left and the right camera; place (4, 4): of the right one in the frame of the left one.

    said: more fields of the SensorSetup, as its std.
    """

    left: Lens
    right: Lens
    place: Array
    said: dict[str, Any] = field(default_factory=dict)


def read_pair(paths: list[str], cameras: tuple[int, int] = (0, 1)) -> PairCalibration:
    """The calibration in one file, or in one for each camera; cameras: their numbers in files of several.

    Raises SlamlibError for what cannot be read, and where the baseline is missing.
    """
    own = _data(paths[0]) if len(paths) == 1 else None
    if own is not None:
        found = next((read for fits, read in OWN if fits(own)), None)
        if found is not None:
            return _named(paths[0], lambda: found(own, cameras))
    if len(paths) > 2:
        raise SlamlibError(f"a calibration is one file, or one for each of two cameras, not {len(paths)}")
    files = paths * (3 - len(paths))
    left, right = (read_lens(path, camera) for path, camera in zip(files, cameras, strict=True))
    return _named(" and ".join(paths), lambda: PairCalibration(left, right, _between(left, right)))


def _named(path: str, read: Callable[[], PairCalibration]) -> PairCalibration:
    try:
        return read()
    except SlamlibError as error:
        raise SlamlibError(f"{path}: {error}") from None
    except (KeyError, TypeError, ValueError) as error:
        raise SlamlibError(f"{path} is no whole calibration of a stereo pair: {error!r}") from None


def _data(path: str) -> dict[str, Any] | None:
    """What a JSON or TOML file holds, or None if it is none."""
    loads: Callable[[str], Any] | None = {".json": json.loads, ".toml": tomllib.loads}.get(Path(path).suffix)
    try:
        data = None if loads is None else loads(Path(path).read_text("utf-8"))
    except (OSError, ValueError):
        return None  # said by read_lens
    return data if isinstance(data, dict) else None


def _between(left: Lens, right: Lens) -> Array:
    """Place of the right camera in the left one's frame (4, 4)."""
    if right.place is None:
        raise SlamlibError(NO_BASELINE)
    origin = np.eye(4) if left.place is None else np.reshape(left.place, (4, 4))
    place: Array = np.linalg.solve(origin, np.reshape(right.place, (4, 4)))
    if not np.linalg.norm(place[:3, 3]) > 0:
        raise SlamlibError(f"both cameras are in one place; {NO_BASELINE}")
    return place


def _plain(data: dict[str, Any], cameras: tuple[int, int]) -> PairCalibration:
    for name in data:
        if name not in PLAIN:
            raise UnknownNameError.of("name", name, PLAIN)
    if "baseline" not in data:
        raise SlamlibError(NO_BASELINE)
    u, v, a, b = finite(data["intrinsics"], (4,), "calibration", "intrinsics").tolist()
    image = tuples(data).get("image")
    said = {"std": tuple(np.atleast_1d(data["std"]).tolist())} if "std" in data else {}
    right = Lens((u + float(data.get("offset", 0)), v, a, b), image)
    return PairCalibration(Lens((u, v, a, b), image), right, _beside(float(data["baseline"])), said)


def _beside(baseline: float) -> Array:
    if not (np.isfinite(baseline) and baseline > 0):
        raise SlamlibError(f"the baseline is one length above zero [m], got {baseline}")
    place = np.eye(4)
    place[0, 3] = baseline
    return place


def _stereo(data: dict[str, Any], cameras: tuple[int, int]) -> PairCalibration:
    """slamlib's own stereo sensor."""
    setup = SensorSetup(**tuples(data.get("sensors", [data])[0]))
    parameters = setup.calibration.given  # checked
    lens = Lens(tuple(parameters["intrinsics"].tolist()), setup.image)
    said = {"std": setup.std, "noise": setup.noise, "limits": setup.limits}
    return PairCalibration(lens, lens, _beside(float(parameters["baseline"][0])), said)


def _rig(data: dict[str, Any], cameras: tuple[int, int]) -> PairCalibration:
    """slamlib's own rig with two pin-holes."""
    sensors = Rig.from_dict({"robots": [{}], **data}).sensors
    if max(cameras) >= len(sensors):
        raise SlamlibError(f"it has {len(sensors)} sensors: there is no camera {max(cameras)}; {NO_BASELINE}")
    left, right = (sensors[camera] for camera in cameras)
    pose = relative(left.mount, right.mount)
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = rotation(pose[3:]), pose[:3]
    return PairCalibration(_pin_hole(left), _pin_hole(right), place)


def _one(data: dict[str, Any], cameras: tuple[int, int]) -> PairCalibration:
    """slamlib's own camera, one alone."""
    raise SlamlibError(NO_BASELINE)


def _pin_hole(setup: SensorSetup) -> Lens:
    k1, k2, k3 = (*setup.parameters.get("distortion", ()), 0.0, 0.0, 0.0)[:3]
    return Lens(setup.parameters["intrinsics"], setup.image, distortion=(k1, k2, 0.0, 0.0, k3))


def _is_stereo(data: dict[str, Any]) -> bool:
    return any(isinstance(s, dict) and s.get("type") == "stereo" for s in (data, *data.get("sensors", ())))


OWN: tuple[tuple[Callable[[dict[str, Any]], bool], Callable[[dict[str, Any], tuple[int, int]], PairCalibration]], ...]
OWN = (
    (_is_stereo, _stereo),
    (lambda data: "sensors" in data, _rig),
    (lambda data: "parameters" in data, _one),
    (lambda data: bool({"baseline", "intrinsics"} & data.keys()), _plain),
)
