"""How the calibration files of others are read. What is no number, or is missing, raises KeyError or ValueError."""

import re
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.lens import Lens, Numbers
from slamlib.datasets.optional_imports import opencv
from slamlib.errors import SlamlibError, UnknownNameError

# Names that the models of slamlib.datasets.lens have elsewhere.
NAMES = {
    "radial-tangential": "radial-tangential",
    "radtan": "radial-tangential",
    "radtan5": "radial-tangential",
    "plumb_bob": "radial-tangential",
    "rational_polynomial": "radial-tangential",
    "none": "radial-tangential",
    "equidistant": "equidistant",
    "equi": "equidistant",
    "fisheye": "equidistant",
}


def is_euroc(text: str) -> bool:
    """Whether "intrinsics: [" and a model are there."""
    return re.search(r"^\s*intrinsics:\s*\[", text, re.M) is not None


def euroc(path: Path, text: str, camera: int) -> Lens:
    """EuRoC's sensor.yaml, or one camera of Kalibr's camchain.yaml."""
    sections = re.split(r"^cam(\d+):\s*$", text, flags=re.M)
    if len(sections) > 1:
        chain = dict(zip(map(int, sections[1::2]), sections[2::2], strict=True))
        if camera not in chain:
            raise SlamlibError(f"there is no camera {camera}, but {', '.join(map(str, chain))}")
        text = chain[camera]
    if _word(text, "camera_model", "pinhole") != "pinhole":
        raise SlamlibError(f"the camera model {_word(text, 'camera_model', '')!r} is not known, pinhole is")
    au, av, u0, v0 = _list(text, "intrinsics")
    coefficients = _list(text, "distortion_coefficients", "distortion_coeffs")
    size = _list(text, "resolution") or None
    model = _model(_word(text, "distortion_model", "none"))
    place = _list(text.partition("T_BS:")[2], "data") or _beside(text)
    return Lens((u0, v0, au, av), size, model, coefficients, place)


def _beside(text: str) -> Numbers | None:
    """Kalibr's T_cn_cnm1 takes points of the camera before to this one: its inverse is the place. None without it."""
    _, there, after = text.partition("T_cn_cnm1:")
    if not there:
        return None
    rows = re.findall(r"^\s*-\s*\[([^\]]*)\]", after, re.M)[:4]
    moved = np.array([[float(word) for word in row.replace(",", " ").split()] for row in rows])
    return tuple(np.linalg.inv(moved.reshape(4, 4)).ravel().tolist())


def _model(name: str) -> str:
    if name.lower() not in NAMES:
        raise UnknownNameError.of("model of distortion", name, NAMES)
    return NAMES[name.lower()]


def _list(text: str, *names: str) -> Numbers:
    """The numbers in "name: [...]" of the first name that is there."""
    for name in names:
        found = re.search(rf"^\s*{name}:\s*\[([^\]]*)\]", text, re.M)
        if found:
            return tuple(float(word) for word in found[1].replace(",", " ").split())
    return ()


def _word(text: str, name: str, default: str) -> str:
    found = re.search(rf"^\s*{name}:\s*([\w-]+)", text, re.M)
    return found[1] if found else default


def is_opencv(text: str) -> bool:
    """Whether cv2.FileStorage wrote it."""
    return text.startswith(("%YAML", "<?xml")) or "opencv-matrix" in text or "<opencv_storage>" in text


def opencv_storage(path: Path, text: str, camera: int) -> Lens:
    """What cv2.FileStorage wrote: by OpenCV's samples for one camera, or for two (M1, D1, M2, D2)."""
    cv2 = opencv("to read calibrations that OpenCV wrote")
    try:
        storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
    except (cv2.error, SystemError):
        raise ValueError("OpenCV cannot read it") from None
    names = storage.root().keys()
    found = {name: storage.getNode(name) for name in names}
    number = camera + 1
    matrix = _node(found, f"M{number}", f"cameraMatrix{number}", f"K{number}", *(_ONE if camera == 0 else ()))
    if matrix is None or matrix.mat() is None or matrix.mat().shape != (3, 3):
        raise SlamlibError(f"there is no camera matrix of camera {camera}; it holds {', '.join(found)}")
    distortion = _node(found, f"D{number}", f"distCoeffs{number}", *(_DISTORTION if camera == 0 else ()))
    coefficients = () if distortion is None else tuple(np.ravel(distortion.mat()).tolist())
    width, height = (_node(found, f"image_{n}", f"image_{n.title()}", f"image{n.title()}") for n in ("width", "height"))
    size = None if width is None or height is None else (width.real(), height.real())
    fisheye = _node(found, "fisheye_model", "fisheye")
    model = "equidistant" if fisheye is not None and fisheye.real() else "radial-tangential"
    (au, _, u0), (_, av, v0), _ = matrix.mat().tolist()
    return Lens((u0, v0, au, av), size, model, coefficients, _second(found) if camera else None)


def _second(found: dict[str, Any]) -> Numbers | None:
    """Place of the second camera of two: the inverse of R, T, which take points of the first to it. None without."""
    turn, shift = _node(found, "R"), _node(found, "T")
    if turn is None or shift is None:
        return None
    moved = np.eye(4)
    moved[:3, :3], moved[:3, 3] = turn.mat(), np.ravel(shift.mat())
    return tuple(np.linalg.inv(moved).ravel().tolist())


_ONE = ("camera_matrix", "cameraMatrix", "Camera_Matrix", "K", "M", "intrinsics")
_DISTORTION = ("distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "D")


def _node(found: dict[str, Any], *names: str) -> Any:
    return next((found[name] for name in names if name in found), None)


_KITTI = re.compile(r"^P(?:_rect_0)?(\d):\s*(.*)$", re.M)


def is_kitti(text: str) -> bool:
    """Whether there are projection matrices, named or not."""
    rows = [line.split() for line in text.splitlines() if line.strip()]
    return _KITTI.search(text) is not None or (bool(rows) and all(len(row) == 12 for row in rows))


def kitti(path: Path, text: str, camera: int) -> Lens:
    """The rectified camera of a projection matrix K [I | t]; its place is that in the frame of camera 0."""
    named = {int(number): row for number, row in _KITTI.findall(text)}
    rows = named or dict(enumerate(line for line in text.splitlines() if line.strip()))
    if camera not in rows:
        raise SlamlibError(f"there is no camera {camera}, but {', '.join(map(str, rows))}")
    P = np.array([float(word) for word in rows[camera].split()]).reshape(3, 4)
    place = np.eye(4)
    place[:3, 3] = -np.linalg.solve(P[:, :3], P[:, 3])
    return Lens((P[0, 2], P[1, 2], P[0, 0], P[1, 1]), place=tuple(place.ravel().tolist()))


ORDER = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")


def is_plain(text: str) -> bool:
    """Whether there is nothing but names with numbers, fx among them, or one row of four, eight or nine numbers."""
    rows = _rows(text)
    if len(rows) == 1 and len(rows[0]) in (4, 8, 9):
        return True
    return bool(rows) and all(len(row) == 2 for row in rows) and "fx" in [row[0].lower() for row in rows]


def plain(path: Path, text: str, camera: int) -> Lens:
    """Rows "name number", or one row of numbers in the order of ORDER."""
    rows = _rows(text)
    named = dict(zip(ORDER, rows[0], strict=False)) if len(rows) == 1 else {name.lower(): n for name, n in rows}
    for name in named:
        if name not in (*ORDER, "width", "height"):
            raise UnknownNameError.of("name", name, (*ORDER, "width", "height"))
    given = {name: float(value) for name, value in named.items()}
    size = (given["width"], given["height"]) if {"width", "height"} <= given.keys() else None
    coefficients = tuple(given.get(name, 0.0) for name in ORDER[4:])
    return Lens((given["cx"], given["cy"], given["fx"], given["fy"]), size, distortion=coefficients)


def _rows(text: str) -> list[list[str]]:
    lines = (re.sub(r"[:=,;]", " ", line.partition("#")[0]).split() for line in text.splitlines())
    return [line for line in lines if line]
