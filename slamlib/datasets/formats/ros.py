"""ROS's camera_info, as its package camera_calibration writes it: camera_matrix and others with rows, cols and data."""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.formats.euroc import MODELS, list_of, word_of
from slamlib.datasets.lens import Lens
from slamlib.errors import SlamlibError, entry


def _fits(text: str) -> bool:
    return re.search(r"^camera_matrix:\s*$", text, re.M) is not None and not text.startswith("%YAML")


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, text)}


def _lens(text: str) -> Lens:
    matrix, coefficients = (
        list_of(re.split(rf"^{name}:", text + f"\n{name}:", maxsplit=1, flags=re.M)[1], "data")
        for name in ("camera_matrix", "distortion_coefficients")
    )
    if len(matrix) != 9:
        raise SlamlibError(f"camera_matrix has rows: 3, cols: 3 and data: [nine numbers], got {len(matrix)} numbers")
    au, _, u0, _, av, v0, *_ = matrix
    width, height = (float(word_of(text, f"image_{name}", "nan")) for name in ("width", "height"))
    model = entry("model of distortion", word_of(text, "distortion_model", "plumb_bob").lower(), MODELS)
    return Lens((u0, v0, au, av), (width, height) if width == width else None, model, coefficients)


CALIBRATION = CalibrationReader("ROS", _fits, _read)
