"""ROS: what its package camera_calibration saves (camera_matrix, ...), or a printed message camera_info (K, D, ...)."""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.formats.euroc import MODELS, word_of
from slamlib.datasets.lens import Lens, Numbers
from slamlib.errors import SlamlibError, entry


def _fits(text: str) -> bool:
    message = re.search(r"^distortion_model:", text, re.M) and re.search(r"^[Kk]:", text, re.M)
    return bool(message or re.search(r"^camera_matrix:\s*$", text, re.M)) and not text.startswith("%YAML")


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, text)}


def _lens(text: str) -> Lens:
    matrix, coefficients = _numbers(text, "camera_matrix|[Kk]"), _numbers(text, "distortion_coefficients|[Dd]")
    if len(matrix) != 9:
        raise SlamlibError(f"a camera matrix (camera_matrix, K) has nine numbers, got {len(matrix)}")
    au, _, u0, _, av, v0, *_ = matrix
    width, height = (float(word_of(text, f"(?:image_)?{name}", "nan")) for name in ("width", "height"))
    model = entry("model of distortion", word_of(text, "distortion_model", "plumb_bob").lower(), MODELS)
    return Lens((u0, v0, au, av), (width, height) if width == width else None, model, coefficients)


def _numbers(text: str, name: str) -> Numbers:
    """The numbers of a field: after "data:" in it, in brackets, or in rows that begin with a dash."""
    found = re.search(rf"^(?:{name}):(.*?)(?=^[A-Za-z]|\Z)", re.sub("#.*", "", text), re.M | re.S)
    inside = found[1].rpartition("data:")[2] if found else ""
    return tuple(map(float, re.sub(r"[\[\],]|^\s*-\s", " ", inside, flags=re.M).split()))


CALIBRATION = CalibrationReader("ROS", _fits, _read)
