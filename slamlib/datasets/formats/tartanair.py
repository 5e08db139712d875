"""TartanAir: Wang and others (2020). PATH/image_left and image_right hold rectified pictures, in its second version
image_lcam_front and image_rcam_front; 10 per second, by the second version's pages."""

from pathlib import Path

from slamlib.datasets.dataset import Dataset, counted
from slamlib.datasets.pictures import images_in

FPS = 10.0
FOLDERS = (("image_left", "image_lcam_front"), ("image_right", "image_rcam_front"))


def _cameras(where: Path) -> dict[int, Path]:
    return {n: where / name for n, names in enumerate(FOLDERS) for name in names if images_in(where / name)}


TARTANAIR = Dataset("TartanAir", _cameras, lambda folder, fps: counted(images_in(folder), fps, FPS))
