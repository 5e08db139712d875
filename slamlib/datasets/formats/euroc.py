"""EuRoC: Burri and others (2016), and Kalibr. camN/data.csv lists times [ns] and files, beside the folder camN/data.

Calibrations: a sensor.yaml for each camera, or one camchain.yaml: intrinsics: [..], distortion_model: .., ...
"""

import re
from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Cameras, Dataset, ImageSource, listed_files
from slamlib.datasets.lens import Lens, Numbers
from slamlib.errors import SlamlibError, entry

# Names of the models of slamlib.datasets.lens in these files.
_RADIAL = ("radial-tangential", "radtan", "radtan5", "plumb_bob", "rational_polynomial", "none")
MODELS = dict.fromkeys(_RADIAL, "radial-tangential") | dict.fromkeys(("equidistant", "equi", "fisheye"), "equidistant")


def _cameras(where: Path) -> dict[int, Path]:
    places = {n: [where / "mav0" / f"cam{n}", where / f"cam{n}"] for n in range(4)}
    places[0].append(where)
    there = {n: [p / "data.csv" for p in folders if (p / "data").is_dir()] for n, folders in places.items()}
    return {n: listing for n, some in there.items() for listing in some[:1] if listing.is_file()}


def _open(listing: Path, fps: float | None) -> ImageSource:
    return listed_files(listing, listing.parent / "data", ",", 1e-9)


def _fits(text: str) -> bool:
    return re.search(r"^\s*intrinsics:\s*\[", text, re.M) is not None


def _read(path: Path, text: str) -> Cameras:
    sections = re.split(r"^cam(\d+):\s*$", text, flags=re.M)
    if len(sections) == 1:
        return {None: partial(_lens, text)}
    chain = zip(sections[1::2], sections[2::2], strict=True)
    return {int(number): partial(_lens, section) for number, section in chain}


def _lens(text: str) -> Lens:
    if (kind := word_of(text, "camera_model", "pinhole")) != "pinhole":
        raise SlamlibError(
            f"the camera model {kind!r} is not known, pinhole is: calibrate with Kalibr's --models pinhole-radtan, or "
            "pinhole-equi for a wide lens"
        )
    au, av, u0, v0 = list_of(text, "intrinsics")
    coefficients = list_of(text, "distortion_coefficients", "distortion_coeffs")
    size = list_of(text, "resolution") or None
    model = entry("model of distortion", word_of(text, "distortion_model", "none").lower(), MODELS)
    transform = list_of(text.partition("T_BS:")[2], "data") or _beside(text)
    return Lens((u0, v0, au, av), size, model, coefficients, transform)


def _beside(text: str) -> Numbers | None:
    """Kalibr's T_cn_cnm1 maps points of the previous camera to this one: its inverse is the pose. None without it."""
    _, there, after = text.partition("T_cn_cnm1:")
    if not there:
        return None
    rows = re.findall(r"^\s*-\s*\[([^\]]*)\]", after, re.M)[:4]
    moved = np.array([[float(word) for word in row.replace(",", " ").split()] for row in rows])
    return tuple(np.linalg.inv(moved.reshape(4, 4)).ravel().tolist())


def list_of(text: str, *names: str) -> Numbers:
    """The numbers in "name: [...]" of the first name that is there."""
    for name in names:
        found = re.search(rf"^\s*{name}:\s*\[([^\]]*)\]", text, re.M)
        if found:
            return tuple(float(word) for word in found[1].replace(",", " ").split())
    return ()


def word_of(text: str, name: str, default: str) -> str:
    """The word in "name: word", or in quotes."""
    found = re.search(rf"^\s*{name}:\s*[\"']?([\w-]+)", text, re.M)
    return found[1] if found else default


EUROC = Dataset(
    "EuRoC", _cameras, _open, calibrations=("mav0/cam{camera}/sensor.yaml", "cam{camera}/sensor.yaml"), raw=True
)
CALIBRATION = CalibrationReader("EuRoC", _fits, _read)
