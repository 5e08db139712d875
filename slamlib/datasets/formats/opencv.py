"""What cv2.FileStorage wrote (YAML, XML, JSON): of one camera, or of two (M1, D1, M2, D2, R, T)."""

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import Lens, Numbers, placed
from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError

_MATRIX = ("camera_matrix", "cameraMatrix", "Camera_Matrix", "K", "M", "intrinsics")
_DISTORTION = ("distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "D")


def _fits(text: str) -> bool:
    return text.startswith(("%YAML", "<?xml")) or "opencv-matrix" in text or "<opencv_storage>" in text


def _read(path: Path, text: str) -> Cameras:
    cv2 = opencv("to read calibrations that OpenCV wrote")
    try:
        storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
        nodes = {name: storage.getNode(name) for name in storage.root().keys()}  # noqa: SIM118
        found = {
            name: node.mat() if node.isMap() else node.real() if node.isReal() or node.isInt() else None
            for name, node in nodes.items()
        }
    except (cv2.error, SystemError):
        raise ValueError("OpenCV cannot read it") from None
    names: dict[int | None, tuple[tuple[str, ...], tuple[str, ...]]] = {
        i: ((f"M{i + 1}", f"cameraMatrix{i + 1}", f"K{i + 1}"), (f"D{i + 1}", f"distCoeffs{i + 1}")) for i in range(8)
    }
    names[None] = _MATRIX, _DISTORTION
    there = {n: said for n, said in names.items() if _first(found, *said[0]) is not None}
    if not there:
        raise SlamlibError(f"there is no camera matrix; it holds {', '.join(found)}")
    return {n: partial(_lens, found, *said, second=n == 1) for n, said in there.items()}


def _lens(found: dict[str, Any], matrices: tuple[str, ...], distortions: tuple[str, ...], second: bool) -> Lens:
    matrix, distortion = _first(found, *matrices), _first(found, *distortions)
    if np.shape(matrix) != (3, 3):
        raise SlamlibError(f"a camera matrix is of 3 x 3 numbers, got {np.shape(matrix)}")
    coefficients = () if distortion is None else tuple(np.ravel(distortion).tolist())
    width, height = (
        _first(found, f"image_{n}", f"image_{n.title()}", f"image{n.title()}") for n in ("width", "height")
    )
    size = None if width is None or height is None else (width, height)
    model = "equidistant" if _first(found, "fisheye_model", "fisheye") else "radial-tangential"
    (au, _, u0), (_, av, v0), _ = matrix.tolist()
    return Lens((u0, v0, au, av), size, model, coefficients, _place(found) if second else None)


def _place(found: dict[str, Any]) -> Numbers | None:
    """Pose of the second camera: the inverse of R, T, which map points of the first camera's frame. None without."""
    turn, shift = _first(found, "R"), _first(found, "T")
    if turn is None or shift is None:
        return None
    first = np.reshape(placed(np.ravel(shift), turn), (4, 4))
    return tuple(np.linalg.inv(first).ravel().tolist())


def _first(found: dict[str, Any], *names: str) -> Any:
    return next((found[name] for name in names if found.get(name) is not None), None)


CALIBRATION = CalibrationReader("OpenCV", _fits, _read)
