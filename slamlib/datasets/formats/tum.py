"""TUM RGB-D: Sturm, Engelhard, Endres, Burgard and Cremers (2012). PATH/rgb.txt lists times and files.

The intrinsics of its three colour cameras are those of the table in "File formats", on the benchmark's pages.
"""

from pathlib import Path

from slamlib.datasets.dataset import Dataset, listed_files
from slamlib.datasets.lens import Lens

LENSES = {
    "fr1": Lens((318.6, 255.3, 517.3, 516.5), (640, 480), distortion=(0.2624, -0.9531, -0.0054, 0.0026, 1.1633)),
    "fr2": Lens((325.1, 249.7, 520.9, 521.0), (640, 480), distortion=(0.2312, -0.7849, -0.0033, -0.0001, 0.9172)),
    "fr3": Lens((320.1, 247.6, 535.4, 539.2), (640, 480)),
}


def _cameras(where: Path) -> dict[int, Path]:
    listing = where / "rgb.txt"
    return {0: listing} if listing.is_file() else {}


TUM = Dataset("TUM RGB-D", _cameras, lambda listing, fps: listed_files(listing, listing.parent), lenses=LENSES)
