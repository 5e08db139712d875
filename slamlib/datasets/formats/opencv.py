"""Camera matrices and coefficients, as cv2.FileStorage writes them (YAML, XML, JSON), and scripts that call OpenCV.

Of one camera, or of two: M1, D1, M2, D2; left_K, right_K; or a map for each; with R, T of cv2.stereoCalibrate, which
take points of the first camera's frame to the second's.
"""

import re
from collections.abc import Iterable, Iterator
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, focals_and_centre, lens_of, placed, rigid
from slamlib.datasets.lens_models import FISHEYE, RADIAL, UNDISTORTED, UNIFIED, WORDS
from slamlib.errors import SlamlibError, entry
from slamlib.plain_data.entries import Entries, Numbers, alike, named_values

MATRIX = (
    "camera_matrix", "K", "M", "intrinsics", "intrinsic", "intrinsic_matrix", "intrinsics_matrix", "camera_intrinsics",
    "camera_intrinsic", "cam_matrix", "mtx", "camera_mtx", "cam_mtx", "KK",
)  # fmt: skip
DISTORTION = (
    "distortion_coefficients", "dist_coeffs", "dist_coeff", "dist_coefs", "dist_coef", "dist_coefficients",
    "distortion_coeffs", "distortion_coeff", "distortion_coefs", "distortion_coefficient", "distortion",
    "distortion_parameters", "distortion_params", "distortion_vector", "camera_distortion", "cam_dist", "dist", "D",
)  # fmt: skip
WIDTH = "image_width", "width", "img_width"
HEIGHT = "image_height", "height", "img_height"
SIZE = "image_size", "img_size", "resolution", "image_resolution"
SHAPE = "image_shape", "img_shape", "shape"  # of arrays: rows, columns
KINDS = "distortion_model", "distortion_type", "lens_model", "lens_type", "camera_model", "camera_type", "model", "type"
FISHEYES = "fisheye_model", "fisheye", "is_fisheye", "use_fisheye"
YES, NO = {"true", "yes", "on", "1", "y"}, {"false", "no", "off", "0", "n", "none", ""}  # as words; YAML has some
TURN = "R", "rotation", "rotation_matrix", "rot", "stereo_R", "R_stereo"
SHIFT = "T", "translation", "translation_vector", "trans", "stereo_T", "T_stereo"
COUNTS = 0, 1, 2, 4, 5, 8, 12, 14  # of coefficients of OpenCV's; those of the first two mean the same everywhere
# Of the pair's geometry, and of pictures that are rectified already.
UNUSED = (
    *METADATA, "e", "f", "q", "r1", "r2", "p1", "p2", "roi*", "validroi*", "validpixroi*", "new*", "optimal*", "*map1*",
    "*map2*", "essential*", "fundamental*", "disparitytodepth*", "rectif*", "proj*",
)  # fmt: skip
ALONE = "r", "t", "p", "rot*", "trans*"  # of a single camera: its place in the room, or its rectification


def camera_lens(entries: Entries, sides: tuple[str, ...] = ("",), transform: Numbers | None = None) -> Lens:
    """The lens of entries whose names have one of these marks, before or after them; the size may be without."""
    pinhole = focals_and_centre(entries.numbers(*_marked(MATRIX, sides)))
    coefficients = entries.numbers(*_marked(DISTORTION, sides), needed=False)
    model = model_of(entries)
    xi = entries.numbers(*_marked(("xi",), sides), count=1, needed=False)
    if xi:
        model, coefficients = UNIFIED, (*xi, *coefficients)
    if model == RADIAL and len(coefficients) not in COUNTS:
        raise SlamlibError(f"OpenCV has 4, 5, 8, 12 or 14 coefficients of distortion, got {coefficients}")
    return lens_of(*pinhole, image=size_of(entries, sides), model=model, distortion=coefficients, transform=transform)


def size_of(entries: Entries, sides: tuple[str, ...] = ("",)) -> Numbers | None:
    """The pictures' width and height, or None where the entries do not say. Raises SlamlibError for one of the two."""
    width, height, size, shape = (
        entries.numbers(*_marked(names, (*sides, "")), needed=False) for names in (WIDTH, HEIGHT, SIZE, SHAPE)
    )
    found = (*width, *height) or size or shape[1::-1]
    if len(found) not in (0, 2):
        raise SlamlibError(f"a picture has a width and a height, got {found}")
    return found or None


def model_of(entries: Entries) -> str:
    """The model of the lens that entries say. Raises SlamlibError for one that is not known, and for two."""
    words = {name: entries.word(name) for name in KINDS}
    for name, word in words.items():
        like = name.startswith("distortion") or any(known in word for known in WORDS if len(known) > 3)
        if like and word and word not in UNDISTORTED:
            entry(name.replace("_", " "), word, WORDS)
    found = {WORDS[word] for word in words.values() if word in WORDS}
    if any(_is_said(entries, name) for name in FISHEYES):
        found.add(FISHEYE)
    if len(found) > 1:
        raise SlamlibError(f"two models of the lens are named, {' and '.join(sorted(found))}: which of them is it?")
    return next(iter(found), RADIAL)


def _is_said(entries: Entries, name: str) -> bool:
    """Whether a value says yes: True, 1, or a word for it. Raises SlamlibError for one that says neither yes nor no."""
    value = entries.value(name)
    if value in (None, 0, 1):  # True is 1
        return bool(value)
    if (word := alike(str(value))) not in YES | NO:
        raise SlamlibError(f"{name} is true or false, got {value}")
    return word in YES


def _marked(names: Iterable[str], sides: Iterable[str]) -> Iterator[str]:
    return chain.from_iterable((f"{name}{side}", f"{side}{name}") for side in sides for name in names)


def _has_matrix(data: Any, sides: Iterable[str] = ("",)) -> bool:
    """Whether there is a camera matrix among named values."""
    wanted = set(map(alike, _marked(MATRIX, sides)))
    return isinstance(data, dict) and any(alike(name) in wanted and _may_be(name, data[name]) for name in data)


def _may_be(name: str, value: Any) -> bool:
    """Whether a value is meant for a matrix: k1 may be a number, and intrinsics some numbers of another format."""
    if isinstance(value, list):
        return len(value) == 9 or "intrinsic" not in alike(name) or any(isinstance(row, list) for row in value)
    return "data" in value if isinstance(value, dict) else "matrix" in alike(name)


def _sides(data: dict[str, Any]) -> dict[int, tuple[str, ...]]:
    """The marks of the cameras whose matrices are side by side."""
    counted_from = 0 if _has_matrix(data, ("0",)) else 1
    words = {0: ("left", "l"), 1: ("right", "r")}
    marks = {number: (str(number + counted_from), *words.get(number, ())) for number in range(8)}
    return {number: names for number, names in marks.items() if _has_matrix(data, names)}


def _maps(data: dict[str, Any]) -> dict[int, str]:
    """The names of the cameras that have a map each: by their number, or left and right, or else by their order."""
    names = [name for name, value in data.items() if _has_matrix(value)]
    numbers = [re.search(r"\d+$", name) for name in names]
    if all(numbers):
        return {int(found[0]): name for found, name in zip(numbers, names, strict=True) if found}
    return dict(enumerate(sorted(names, key=lambda name: "right" in alike(name))))


def _path_to(data: Any) -> list[str] | None:
    """The names of the maps, from outside, in which the cameras are; None without cameras."""
    if not isinstance(data, dict):
        return None
    if _has_matrix(data) or _sides(data) or _maps(data):
        return []
    paths = ((name, _path_to(value)) for name, value in data.items())
    return next(([name, *inner] for name, inner in paths if inner is not None), None)


def _fits(text: str) -> bool:
    data = named_values(text)
    return "distortion_model" not in data and _path_to(data) is not None


def _read(path: Path, text: str) -> Cameras:
    outside = whole = Entries(named_values(text))
    for name in _path_to(whole.data) or []:
        whole = whole.inside(name)
    sides, maps = _sides(whole.data), _maps(whole.data)
    if _has_matrix(whole.data):
        found: dict[int | None, Lens] = {None: camera_lens(whole)}
    else:
        poses = dict(zip(sorted({*sides, *maps}), _poses(whole), strict=False))
        found = {n: camera_lens(whole, marks, poses.get(n)) for n, marks in sides.items()}
        found |= {n: camera_lens(whole.inside(name), transform=poses.get(n)) for n, name in maps.items()}
    outside.close((*UNUSED, *ALONE) if len(found) == 1 else UNUSED)
    if len(found) == 1:
        found = {None: next(iter(found.values()))}
    return {number: partial(found.__getitem__, number) for number in found}


def _poses(whole: Entries) -> list[Numbers]:
    """Of both cameras, in the frame of the first one: the inverse of R, T. None without."""
    place = whole if whole.value(*SHIFT) else whole.inside("extrinsics", "extrinsic", "stereo")
    shift = place.numbers(*SHIFT, count=3, needed=False)
    if not shift:
        return []
    turn = np.reshape(place.numbers(*TURN, count=9), (3, 3))
    return [placed((0, 0, 0)), rigid(placed(shift, turn), "R", inverse=True)]


CALIBRATION = CalibrationReader("OpenCV", _fits, _read)
