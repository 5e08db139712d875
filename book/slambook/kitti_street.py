"""KITTI's street: the first 51 pairs of sequence 06 of its odometry benchmark, where they are at hand.

A nearly straight street of 59.9 m (Geiger, Lenz and Urtasun, 2012). The licence is for non-commercial use, so it is not
shipped; `slamlib datasets kitti-odometry` says where it is offered. Below the folder of SLAMLIB_DATA it is found as it
is offered, or as an excerpt of these pairs alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from slambook.stereo_films import DATA
from slamlib.datasets.calibrations import read_pair
from slamlib.datasets.pictures import read_image
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.manifolds import Array
from slamlib.sensors.sensor import Calibration
from slamlib.sensors.stereo import STEREO
from slamlib.vision.stereo import pair

PAIRS, FPS = 51, 10.0
STD = 0.2  # px, of u, v and disparity: the noise that plain odometry is given
# Left and right pictures, calibration, true path of the left camera.
OFFERED = ("sequences/06/image_0", "sequences/06/image_1", "sequences/06/calib.txt", "poses/06.txt")
EXCERPT = ("image_l", "image_r", "calib.txt", "poses.txt")
PLACES: dict[str, Sequence[str]] = {"dataset": OFFERED, "stereo_kitti_a": EXCERPT}


@dataclass(frozen=True)
class Street:
    """Where it is: folders of the left and of the right pictures, and the files of the calibration and true path."""

    left: Path
    right: Path
    calibration: Path
    poses: Path

    @property
    def whole(self) -> bool:
        """Whether both files are there, and the last pair that is wanted."""
        pictures = [side / f"{PAIRS - 1:06d}.png" for side in (self.left, self.right)]
        return all(file.is_file() for file in (*pictures, self.calibration, self.poses))


def found(root: Path | None = None) -> Street | None:
    """The street below a folder, that of SLAMLIB_DATA if none is given; or None."""
    at = (Street(*((root or DATA) / place / name for name in names)) for place, names in PLACES.items())
    return next((street for street in at if street.whole), None)


def needed(root: Path | None = None) -> Street:
    """As `found`; raises SlamlibError, which says what is wanted, where the street is not at hand."""
    street = found(root)
    if street is None:
        files = ", ".join(f"dataset/{name}" for name in OFFERED)
        raise SlamlibError(
            f"KITTI's street is not at hand: frames 0 to {PAIRS - 1} of sequence 06 of its odometry benchmark. Below "
            f"the folder that SLAMLIB_DATA names, {files} are wanted; `slamlib datasets kitti-odometry` says where "
            "they are offered"
        )
    return street


def pairs(count: int = PAIRS, root: Path | None = None) -> tuple[Calibration, list[Array], Trajectory]:
    """Calibration, pairs and true trajectory; raises SlamlibError where the street is not at hand."""
    street = needed(root)
    known = read_pair([str(street.calibration)])
    images = [
        pair(*(read_image(side / f"{number:06d}.png") for side in (street.left, street.right)))
        for number in range(count)
    ]
    height, width = images[0].shape[1:]
    baseline = [known.transform[0, 3]]
    made = Calibration(
        STEREO, STD**2 * np.eye(3), image=(width, height), intrinsics=known.left.intrinsics, baseline=baseline
    )
    return made, images, truth(street, count)


def truth(street: Street, count: int = PAIRS) -> Trajectory:
    """The true path of the left camera at the first pairs, ten a second."""
    times = np.arange(len(np.loadtxt(street.poses))) / FPS
    return read_trajectory(street.poses, times=times)[np.arange(count)]
