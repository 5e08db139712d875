"""KITTI odometry: Geiger, Lenz and Urtasun (2012). PATH/image_N holds rectified pictures, PATH/times.txt their times.

calib.txt: rows "P0: " and 12 numbers, or 12 numbers alone: the projection matrices K [I | t] of the rectified cameras;
KITTI's raw data call them P_rect_00, ..., in calib_cam_to_cam.txt, beside the cameras before the rectification.
"""

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import CalibrationReader, Cameras, Dataset, ImageSource, counted, listed
from slamlib.datasets.lens import Lens, focals_and_centre, lens_of, placed
from slamlib.datasets.pictures import images_in
from slamlib.datasets.times import table
from slamlib.errors import SlamlibError
from slamlib.plain_data.entries import Entries, Numbers
from slamlib.plain_data.parsing import named, value_of

FPS = 10.0
# Of the pictures before they were rectified, of the laser scanner and of the inertial sensor.
UNUSED = ("calibtime", "cornerdist", "[skdrt]0?", "rrect0?", "srect0?", "prect0?", "r?rect", "tr*")
_PROJECTION = re.compile(r"P(?:_rect_0)?(\d)")
_NAMED = re.compile(r"^P(?:_rect_0)?(\d):\s*([-+.\d].*)$", re.M)
_MATRIX = re.compile(r"\s*(?:[-+.\de]+\s+){11}[-+.\de]+\s*", re.I)


def _cameras(where: Path) -> dict[int, Path]:
    return {n: where / f"image_{n}" for n in range(4) if images_in(where / f"image_{n}")}


def _open(folder: Path, fps: float | None) -> ImageSource:
    paths, listing = images_in(folder), folder.parent / "times.txt"
    if not listing.is_file():
        return counted(paths, fps, FPS)
    times = [time for time, _ in table(listing, 1)]
    if len(times) != len(paths):
        raise SlamlibError(f"{listing} has {len(times)} times for {len(paths)} pictures in {folder}")
    return listed(paths, times, listing)


def _fits(text: str) -> bool:
    rows = [line for line in text.splitlines() if line.strip()]
    return _NAMED.search(text) is not None or (bool(rows) and all(map(_MATRIX.fullmatch, rows)))


def _read(path: Path, text: str) -> Cameras:
    lines = [line for line in text.splitlines() if line.strip()]
    rows = [line.partition(":")[::2] for line in lines if ":" in line]
    rows = rows or [(f"P{number}", line) for number, line in enumerate(lines)]
    entries = Entries(named((name.strip(), list(map(value_of, row.split()))) for name, row in rows))
    names = {int(found[1]): found[0] for found in map(_PROJECTION.fullmatch, entries.data) if found}
    projections = {number: entries.numbers(name, count=12) for number, name in names.items()}
    sizes = {number: entries.numbers(f"S_rect_0{number}", count=2, needed=False) for number in names}
    entries.close(UNUSED)
    return {number: partial(_lens, projections[number], sizes[number] or None) for number in names}


def _lens(projection: Numbers, size: Numbers | None) -> Lens:
    """The rectified camera of a projection matrix; its pose is in the frame of camera 0."""
    P = np.reshape(projection, (3, 4))
    found = lens_of(*focals_and_centre(tuple(P[:, :3].ravel().tolist())), image=size)
    return replace(found, transform=placed(-np.linalg.solve(P[:, :3], P[:, 3])))


KITTI = Dataset("KITTI", _cameras, _open, calibrations=("calib.txt", "calibration.json"))
CALIBRATION = CalibrationReader("KITTI", _fits, _read)
