"""Kalibr's camchain.yaml, as OpenVINS and TUM-VI have it too: cam0, cam1, ..., with their places in a chain.

T_cn_cnm1 takes points of the camera *before* to this one, T_cam_imu those of the inertial sensor, T_imu_cam back to it.
"""

import re
from functools import partial
from pathlib import Path

import numpy as np

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
_CAMERA = re.compile(r"cam(\d+)")
_ITS_OWN = {"intrinsics", "cameramodel", "tcncnm1"}  # other tools' cameras may be called cam0, too
_PLACED = ("T_cn_cnm1", "T_cam_imu", "T_imu_cam")


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
        "distortion_coefficients", "distortion_coeffs", "distortion_parameters", needed=False
    )
    if said == "none" and any(coefficients):
        raise SlamlibError(
            f"distortion_model is none, or missing, and the coefficients are {coefficients}: which model?"
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
    """Of every camera in the frame of the first one, or of the inertial sensor; None of those without such a place."""
    steps, to, back = ({n: e.numbers(name, count=16, needed=False) for n, e in chain.items()} for name in _PLACED)
    first, *others = sorted(chain)
    if not all(steps[n] for n in others) or not others:  # the chain is broken, or there is none
        given = {n: rigid(back[n] or to[n], f"cam{n}'s place", inverse=not back[n]) for n in chain if back[n] or to[n]}
        if given or not others:
            return {n: given.get(n) for n in chain}
    found: dict[int, Numbers | None] = {first: placed((0, 0, 0))}
    for n in others:
        before, step = found.get(n - 1), steps[n]
        if before and step:
            step = rigid(step, f"T_cn_cnm1 of cam{n}", inverse=True)
            found[n] = tuple((np.reshape(before, (4, 4)) @ np.reshape(step, (4, 4))).ravel().tolist())
    return {n: found.get(n) for n in chain}


CALIBRATION = CalibrationReader("Kalibr", _fits, _read)
