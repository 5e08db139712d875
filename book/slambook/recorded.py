"""The excerpt of a real street that the benchmarks and the longer films use, where it is at hand."""

import os
from pathlib import Path

import numpy as np

from slamlib.datasets.pictures import read_image
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.manifolds import Array
from slamlib.sensors.sensor import Calibration
from slamlib.sensors.stereo import STEREO
from slamlib.vision.stereo import pair

DATA = Path(os.environ.get("SLAMLIB_DATA", ""))
KITTI = DATA / "stereo_kitti_a"


def kitti(count: int = 51) -> tuple[Calibration, list[Array], Trajectory]:
    """Calibration, pairs and true trajectory of a KITTI excerpt; raises SlamlibError where it is not at hand."""
    if not KITTI.is_dir():
        raise SlamlibError(f"{KITTI} is not at hand: set SLAMLIB_DATA to the folder that holds {KITTI.name}")
    lens = np.loadtxt(KITTI / "calib.txt")
    f, u, v, b = lens[0, 0], lens[0, 2], lens[0, 6], -lens[1, 3] / lens[1, 0]
    made = Calibration(STEREO, 0.2**2 * np.eye(3), image=(1226, 370), intrinsics=[u, v, f, f], baseline=[b])
    names = [f"{i:06d}.png" for i in range(count)]
    pairs = [pair(read_image(KITTI / "image_l" / n), read_image(KITTI / "image_r" / n)) for n in names]
    truth = read_trajectory(KITTI / "poses.txt", times=0.1 * np.arange(51.0))
    return made, pairs, truth[np.arange(count)]
