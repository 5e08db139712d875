"""Images in a folder, or those that match a glob such as "left_*.png", or one image: 30 per second by default."""

import glob
from collections.abc import Callable
from pathlib import Path

from slamlib.datasets.dataset import FPS, Dataset, counted
from slamlib.datasets.pictures import images_in, in_natural_order, is_image


def _matches(where: Path) -> list[Path]:
    found = [where] if where.exists() else [Path(name) for name in glob.glob(str(where), recursive=True)]
    return in_natural_order([path for path in found if is_image(path)])


def _dataset(name: str, images: Callable[[Path], list[Path]]) -> Dataset:
    return Dataset(
        name,
        lambda where: {0: where} if images(where) else {},
        lambda where, fps: counted(images(where), fps or FPS),
        general=True,
    )


FOLDER, GLOB = _dataset("folder", images_in), _dataset("glob", _matches)
