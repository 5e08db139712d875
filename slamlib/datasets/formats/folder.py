"""Images in a folder, or those that match a glob such as "left_*.png", or one image: 30 a second, if not said."""

import glob
from pathlib import Path

from slamlib.datasets.dataset import FPS, Dataset, Sequence, counted
from slamlib.datasets.pictures import images_in, in_natural_order, is_image


def _folder(where: Path) -> dict[int, Path]:
    return {0: where} if images_in(where) else {}


def _open_folder(where: Path, fps: float | None) -> Sequence:
    return counted(images_in(where), fps or FPS)


def _matches(where: Path) -> list[Path]:
    found = [where] if where.exists() else [Path(name) for name in glob.glob(str(where), recursive=True)]
    return in_natural_order([path for path in found if is_image(path)])


def _glob(where: Path) -> dict[int, Path]:
    return {0: where} if _matches(where) else {}


def _open_glob(where: Path, fps: float | None) -> Sequence:
    return counted(_matches(where), fps or FPS)


FOLDER = Dataset("folder", _folder, _open_folder, general=True)
GLOB = Dataset("glob", _glob, _open_glob, general=True)
