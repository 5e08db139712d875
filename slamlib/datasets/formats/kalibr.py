"""Kalibr's camchain.yaml, as OpenVINS and TUM-VI have it too: cam0, cam1, ..., with their places in a chain.

T_cn_cnm1 takes points of the camera *before* to this one, T_cam_imu those of the inertial sensor, T_imu_cam back to it.
"""

import re
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, lens_of, placed, rigid
from slamlib.datasets.lens_models import DOUBLE_SPHERE, EXTENDED, FISHEYE, FOV, RADIAL, UNIFIED
from slamlib.errors import SlamlibError, entry
from slamlib.plain_data.entries import Entries, Numbers, alike, named_values

UNUSED = (*METADATA, "camoverlaps", "rostopic", "linedelay", "*topic", "imu*")
# By camera_model: the intrinsics before (fu, fv, pu, pv), and the lens for each distortion_model.
_RADIAL = dict.fromkeys(("radtan", "radialtangential", "radtan5", "plumbbob", "rationalpolynomial", "none"), RADIAL)
_FISHEYE = dict.fromkeys(("equi", "equidistant", "fisheye", "kannalabrandt"), FISHEYE)
CAMERAS = {
    "pinhole": ((), {**_RADIAL, **_FISHEYE, "fov": FOV}),
    "omni": (("xi",), dict.fromkeys(("radtan", "radialtangential", "none"), UNIFIED)),
    "ds": (("xi", "alpha"), {"none": DOUBLE_SPHERE}),
    "eucm": (("alpha", "beta"), {"none": EXTENDED}),
}
# How many coefficients of distortion there may be, for each lens that has them; none at all is no distortion.
COUNTS = {RADIAL: (0, 4, 5, 8), FISHEYE: (4,), FOV: (1,), UNIFIED: (0, 4, 5)}
_CAMERA = re.compile(r"cam(\d+)")
_ITS_OWN = {"intrinsics", "cameramodel", "tcncnm1"}  # other tools' cameras may be called cam0, too
_PLACED = ("T_cn_cnm1", "T_cam_imu", "T_imu_cam")
MOST_APART, MOST_TURNED = 0.005, 0.5  # [m, and as a share], [degrees]: between two statements of one place


def lens(entries: Entries, transform: Numbers | None) -> Lens:
    """The lens of one camera's entries, with its pose."""
    camera = entries.word("camera_model", default="pinhole")
    first, distortions = entry("camera_model", camera, CAMERAS)
    said = entries.word("distortion_model", default="none")
    model = entry(f"model of distortion of {camera}", said, distortions)
    names = (*first, "fu", "fv", "pu", "pv")
    intrinsics = entries.numbers("intrinsics")
    if len(intrinsics) != len(names):
        raise SlamlibError(f"{camera} has the intrinsics ({', '.join(names)}), got {len(intrinsics)} numbers")
    coefficients = entries.numbers(
        "distortion_coefficients", "distortion_coeffs", "distortion_parameters", needed=said != "none"
    )
    if said == "none" and any(coefficients):
        raise SlamlibError(
            f"distortion_model is none, or missing, and the coefficients are {coefficients}: which model?"
        )
    counts = COUNTS.get(model, ())
    if said != "none" and len(coefficients) not in counts:
        raise SlamlibError(
            f"{said} has {' or '.join(map(str, counts))} coefficients of distortion, got {len(coefficients)}"
        )
    size = entries.numbers("resolution", count=2, needed=False) or None
    own, pinhole = intrinsics[: len(first)], intrinsics[len(first) :]
    distortion = own if said == "none" else (*own, *coefficients)
    return lens_of(*pinhole, image=size, model=model, distortion=distortion, transform=transform)


def _fits(text: str) -> bool:
    cameras = (value for name, value in named_values(text).items() if _CAMERA.fullmatch(name))
    return any(isinstance(value, dict) and _ITS_OWN & set(map(alike, value)) for value in cameras)


def _read(path: Path, text: str) -> Cameras:
    whole = Entries(named_values(text))
    cameras = {int(found[1]): found[0] for found in map(_CAMERA.fullmatch, whole.data) if found}
    chain = {number: Entries(whole.value(cameras[number]), cameras[number]) for number in sorted(cameras)}
    whole.close(UNUSED)
    return {number: partial(_lens, chain, number) for number in chain}


def _lens(chain: dict[int, Entries], number: int) -> Lens:
    found = lens(chain[number], _poses(chain)[number])
    chain[number].close(UNUSED)
    return found


def _poses(chain: dict[int, Entries]) -> dict[int, Numbers | None]:
    """Of every camera in the frame of the first one, or of the inertial sensor; None of those without such a place.

    Raises SlamlibError for places that are stated twice, and differ.
    """
    by_sensor = {n: found for n, entries in chain.items() if (found := _by_sensor(entries, n))}
    by_chain, first = _by_chain(chain), min(chain)
    if first in by_sensor:
        origin = np.reshape(by_sensor[first], (4, 4))
        for n in by_sensor.keys() & by_chain.keys():
            stated = next(name for name in _PLACED[1:] if name in chain[n])
            there = np.linalg.solve(origin, np.reshape(by_sensor[n], (4, 4)))
            _check_alike(n, by_chain[n], there, _PLACED[0], stated)
    is_whole = 1 < len(chain) == len(by_chain)  # else it is broken, or there is none
    best = by_chain if is_whole or not by_sensor else by_sensor
    return {n: best.get(n) if len(chain) > 1 else by_sensor.get(n) for n in chain}


def _by_chain(chain: dict[int, Entries]) -> dict[int, Numbers]:
    """The poses of the cameras that T_cn_cnm1 leads to, in the frame of the first one."""
    first, *others = sorted(chain)
    found = {first: placed((0, 0, 0))}
    for n in others:
        before, step = found.get(n - 1), chain[n].numbers(_PLACED[0], count=16, needed=False)
        if before and step:
            step = rigid(step, f"T_cn_cnm1 of cam{n}", inverse=True)
            found[n] = tuple((np.reshape(before, (4, 4)) @ np.reshape(step, (4, 4))).ravel().tolist())
    return found


def _by_sensor(entries: Entries, n: int) -> Numbers | None:
    """The pose of camera n in the inertial sensor's frame, which its entries state or not."""
    to, back = (entries.numbers(name, count=16, needed=False) for name in _PLACED[1:])
    if not to and not back:
        return None
    found = rigid(back or to, f"cam{n}'s place", inverse=not back)
    if to and back:
        _check_alike(n, found, rigid(to, f"cam{n}'s place", inverse=True), *_PLACED[1:])
    return found


def _check_alike(n: int, one: ArrayLike, other: ArrayLike, *names: str) -> None:
    """Raise SlamlibError for two poses (4, 4) of camera n that differ by more than what files round."""
    a, b = (np.reshape(pose, (4, 4)) for pose in (one, other))
    apart = float(np.linalg.norm(a[:3, 3] - b[:3, 3]))
    turned = np.degrees(np.linalg.norm(a[:3, :3] - b[:3, :3]) / np.sqrt(2))  # of small angles
    if apart > MOST_APART * (1 + np.linalg.norm(a[:3, 3])) or turned > MOST_TURNED:
        raise SlamlibError(
            f"cam{n}'s places by {' and '.join(names)} differ, by {apart:.3g} m and {turned:.3g} degrees: delete the "
            "one that is wrong"
        )


CALIBRATION = CalibrationReader("Kalibr", _fits, _read)
