"""Images in a folder, or those that match a glob such as "left_*.png", or one image: 30 per second by default."""

import glob
from collections.abc import Callable
from pathlib import Path

from slamlib.datasets.dataset import Dataset, counted
from slamlib.datasets.pictures import images_in, in_natural_order, is_image


def _matches(where: Path) -> list[Path]:
    """The images that match; brackets in the name of a folder that is there are its own."""
    if where.exists():
        return [where] if is_image(where) else []
    there = next(folder for folder in where.parents if folder.is_dir())
    literal = f"{glob.escape(str(there))}/{where.relative_to(there).as_posix()}"
    found = glob.glob(literal, recursive=True) or glob.glob(str(where), recursive=True)
    return in_natural_order([path for path in map(Path, found) if is_image(path)])


def _dataset(name: str, images: Callable[[Path], list[Path]]) -> Dataset:
    return Dataset(
        name,
        lambda where: {0: where} if images(where) else {},
        lambda where, fps: counted(images(where), fps),
        general=True,
    )


FOLDER, GLOB = _dataset("folder", images_in), _dataset("glob", _matches)
