"""KITTI odometry: Geiger, Lenz and Urtasun (2012). PATH/image_N holds rectified pictures, PATH/times.txt their times.

calib.txt: rows "P0: " and 12 numbers, or 12 numbers alone: the projection matrices K [I | t] of the rectified cameras.
"""

import re
from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Cameras, Dataset, ImageSource, counted, listed, table
from slamlib.datasets.lens import Lens, placed
from slamlib.datasets.pictures import images_in
from slamlib.errors import SlamlibError

FPS = 10.0
_NAMED = re.compile(r"^P(?:_rect_0)?(\d):\s*([-+.\d].*)$", re.M)
_MATRIX = re.compile(r"\s*(?:[-+.\de]+\s+){11}[-+.\de]+\s*", re.I)


def _cameras(where: Path) -> dict[int, Path]:
    return {n: where / f"image_{n}" for n in range(4) if images_in(where / f"image_{n}")}


def _open(folder: Path, fps: float | None) -> ImageSource:
    paths, listing = images_in(folder), folder.parent / "times.txt"
    if not listing.is_file():
        return counted(paths, fps or FPS)
    times = [time for time, _ in table(listing, 1, None)]
    if len(times) != len(paths):
        raise SlamlibError(f"{listing} has {len(times)} times for {len(paths)} pictures in {folder}")
    return listed(paths, times, listing)


def _fits(text: str) -> bool:
    rows = [line for line in text.splitlines() if line.strip()]
    return _NAMED.search(text) is not None or (bool(rows) and all(map(_MATRIX.fullmatch, rows)))


def _read(path: Path, text: str) -> Cameras:
    named = {int(number): row for number, row in _NAMED.findall(text)}
    rows = named or dict(enumerate(line for line in text.splitlines() if line.strip()))
    return {number: partial(_lens, row) for number, row in rows.items()}


def _lens(row: str) -> Lens:
    """The rectified camera of a projection matrix; its pose is in the frame of camera 0."""
    P = np.array([float(word) for word in row.split()]).reshape(3, 4)
    return Lens((P[0, 2], P[1, 2], P[0, 0], P[1, 1]), transform=placed(-np.linalg.solve(P[:, :3], P[:, 3])))


KITTI = Dataset("KITTI", _cameras, _open, calibrations=("calib.txt", "calibration.json"))
CALIBRATION = CalibrationReader("KITTI", _fits, _read)
