"""ICL-NUIM: Handa, Whelan, McDonald and Davison (2014), as TUM RGB-D but without its list: PATH/rgb holds the pictures.

Their numbers are those of frames, 30 a second.
"""

from pathlib import Path

from slamlib.datasets.dataset import Dataset, counted
from slamlib.datasets.pictures import images_in


def _cameras(where: Path) -> dict[int, Path]:
    return {0: where / "rgb"} if images_in(where / "rgb") and not (where / "rgb.txt").is_file() else {}


ICL_NUIM = Dataset("ICL-NUIM", _cameras, lambda folder, fps: counted(images_in(folder), fps))
