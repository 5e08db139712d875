"""KITTI's raw recordings, synchronized and rectified: Geiger, Lenz, Stiller and Urtasun (2013).

PATH/image_0N/data holds pictures, PATH/image_0N/timestamps.txt their dates and times; the calibration is that of a day,
in the folder above.
"""

from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import Dataset, ImageSource, counted, listed
from slamlib.datasets.formats.kitti import FPS
from slamlib.datasets.pictures import images_in
from slamlib.errors import SlamlibError
from slamlib.plain_data.files import read_text


def _cameras(where: Path) -> dict[int, Path]:
    return {n: folder for n in range(4) if images_in(folder := where / f"image_{n:02d}" / "data")}


def _open(folder: Path, fps: float | None) -> ImageSource:
    paths, listing = images_in(folder), folder.parent / "timestamps.txt"
    if not listing.is_file():
        return counted(paths, fps, FPS)
    rows = [line.strip() for line in read_text(listing).splitlines() if line.strip()]
    if len(rows) != len(paths):
        raise SlamlibError(f"{listing} has {len(rows)} times for {len(paths)} pictures in {folder}")
    try:
        times = [float(np.datetime64(row, "ns").astype(np.int64)) for row in rows if ":" in row]
    except ValueError:
        times = []
    if len(times) != len(rows):
        raise SlamlibError(f"{listing}: dates and times such as 2011-09-26 13:02:25.964389445 are wanted")
    return listed(paths, times, listing, "nanoseconds")


KITTI_RAW = Dataset("KITTI raw", _cameras, _open, calibrations=("calib_cam_to_cam.txt", "../calib_cam_to_cam.txt"))
