"""slamlib's own calibrations, JSON, TOML or YAML: a SensorSetup (any camera, or stereo), a Rig, a rectified pair."""

from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, placed
from slamlib.datasets.lens_models import DOUBLE_SPHERE, EXTENDED, FISHEYE, RADIAL, UNIFIED
from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import rotation
from slamlib.plain_data.entries import Numbers, named_values
from slamlib.plain_data.fields import Range, read, read_fields
from slamlib.rigs.setup import SensorSetup

KEYS = {"parameters", "sensors", "intrinsics", "baseline"}
# The model that OpenCV has for a type of camera, and the places of its coefficients among that model's.
UNDISTORTED = {
    "pinHole": (RADIAL, (0, 1, 4)),
    "pinHoleDepth": (RADIAL, (0, 1, 4)),
    "brownConrady": (RADIAL, tuple(range(8))),
    "fisheye": (FISHEYE, tuple(range(4))),
    "unified": (UNIFIED, tuple(range(6))),
    "extendedUnified": (EXTENDED, (0, 1)),
    "doubleSphere": (DOUBLE_SPHERE, (0, 1)),
}
Focal = Annotated[float, Range(gt=0, unit="px")]


@dataclass(frozen=True)
class RectifiedPair:
    """Of both cameras: intrinsics (u0, v0, au, av) [px]; image (width, height) [px]; std of u, v and disparity [px].

    offset [px]: column of the right principal point minus that of the left one.
    """

    intrinsics: tuple[float, float, Focal, Focal]
    baseline: Annotated[float, Range(gt=0, lt=np.inf, unit="m")] | None = None
    image: tuple[float, float] | None = None
    offset: float = 0.0
    std: Numbers | None = None

    def lens(self, right: bool) -> Lens:
        """One of the two."""
        u, *others = self.intrinsics
        transform = None if right and not self.baseline else placed((right * (self.baseline or 0.0), 0, 0))
        said = {} if self.std is None else {"std": self.std}
        return Lens((u + right * self.offset, *others), self.image, transform=transform, extra=said)


@dataclass(frozen=True)
class OwnCamera:
    """A camera of any type; data: plain data of its SensorSetup."""

    data: dict[str, Any]
    of_rig: bool

    def setup(self) -> dict[str, Any]:
        """Plain data of its SensorSetup. Raises SlamlibError if its parameters are empty."""
        if self.data.get("parameters") == {}:
            raise SlamlibError("parameters is empty: it has the intrinsics and the other parameters of the camera")
        return self.data

    @property
    def lens(self) -> Lens:
        """The lens, if it is one that OpenCV can undistort. Raises SlamlibError."""
        sensor = SensorSetup(**self.data)
        model, places = UNDISTORTED.get(sensor.type, ("", ()))
        coefficients = sensor.parameters.get("distortion", ())
        if any(coefficients[len(places) :]) or not model:
            raise SlamlibError(
                "OpenCV undistorts pin-holes with up to three radial coefficients, and fisheyes with up to four; leave "
                "--undistort out, since slamlib works on this camera's pictures as they are"
            )
        at = dict(zip(places, coefficients, strict=False))
        distortion = tuple(at.get(place, 0.0) for place in range(places[-1] + 1))
        transform = placed(sensor.extrinsics[:3], rotation(sensor.extrinsics[3:])) if self.of_rig else None
        return Lens(sensor.parameters["intrinsics"], self.data.get("image"), model, distortion, transform)


def _fits(text: str) -> bool:
    return bool(KEYS & named_values(text).keys())


def _read(path: object, text: str) -> Cameras:
    data = named_values(text)
    setups = data.get("sensors", [data])
    stereo = next((setup for setup in setups if setup.get("type") == "stereo"), None)
    if stereo is not None or not {"parameters", "sensors"} & data.keys():
        pair = read(RectifiedPair, data, "pair").lens if stereo is None else partial(_half, stereo)
        return {number: partial(pair, number % 2 == 1) for number in range(4)}
    numbers: list[int | None] = list(range(len(setups))) if "sensors" in data else [None]
    return {number: partial(_camera, number, setup) for number, setup in zip(numbers, setups, strict=True)}


def _camera(number: int | None, setup: dict[str, Any]) -> OwnCamera:
    of_rig = number is not None
    return OwnCamera(read_fields(SensorSetup, setup, f"sensors[{number}]" if of_rig else "camera"), of_rig)


def _half(setup: dict[str, Any], right: bool) -> Lens:
    """The left or the right lens of a stereo sensor."""
    sensor = SensorSetup(**read_fields(SensorSetup, setup, "stereo"))
    given = sensor.calibration.given  # checked
    transform = placed((right * given["baseline"][0], 0, 0))
    said = {"std": sensor.std, "noise": sensor.noise, "limits": sensor.limits}
    return Lens(tuple(given["intrinsics"].tolist()), sensor.image, transform=transform, extra=said)


CALIBRATION = CalibrationReader("slamlib", _fits, _read, in_metres=True)
