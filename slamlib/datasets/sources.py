"""Where pictures come from: a folder, a glob, a video, or a public layout (slamlib.datasets.formats).

    layout      files                                       times
    TUM RGB-D   PATH/rgb.txt                                of rgb.txt
    EuRoC       PATH/[mav0/]camN/data.csv, or PATH/data.csv of data.csv
    KITTI       PATH/image_N/, best with PATH/times.txt     of times.txt, or 10 images per second
    folder      PATH/*.png, *.jpg, *.pgm, ...               30 per second by default
    video       one file that OpenCV can open               its own images per second
    glob        "PATH/left_*.png", or one image             30 per second by default

Images are read one at a time, on demand, in the order of their times, or of the numbers in their names.
"""

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from slamlib.datasets.dataset import Dataset, ImageSource
from slamlib.datasets.formats import DATASETS
from slamlib.datasets.pictures import TimedImage
from slamlib.errors import SlamlibError


def of_pictures(pictures: list[TimedImage], interval: float) -> ImageSource:
    """A source of images in memory, typically `interval` [s] apart; it cannot be reopened."""
    names, times = zip(*((p.name, p.time) for p in pictures), strict=True) if pictures else ((), ())
    return ImageSource(names, times, interval, lambda frames: (pictures[i] for i in frames), range(len(pictures)))


def open_source(text: str | Path, *, fps: float | None = None, camera: int = 0) -> ImageSource:
    """The pictures at a path or a glob; no image is read yet, only a video's header.

    fps: images per second, if there are no times, or instead of a video's own. camera: its number, in layouts with
    several (EuRoC, KITTI). Raises SlamlibError for a missing path, and for invalid lists.
    """
    if fps is not None and not fps > 0:
        raise SlamlibError(f"fps is the number of pictures a second, above 0, got {fps}")
    where = os.path.abspath(text)
    dataset, cameras = _found(where)
    if dataset is None:
        raise SlamlibError(f"{text}: {_why_not(where)}")
    if camera not in cameras:
        raise SlamlibError(f"{text} ({dataset.name}) has no camera {camera}; it has {', '.join(map(str, cameras))}")
    recipe = {"text": where, "fps": fps, "camera": camera}
    return replace(dataset.open(cameras[camera], fps), layout=dataset.name, where=where, recipe=recipe)


def cameras_at(where: str | Path) -> list[int]:
    """Numbers of the cameras at a path."""
    return sorted(_found(os.path.abspath(where))[1])


def _found(where: str) -> tuple[Dataset | None, Mapping[int, Path]]:
    """The layout of what is at a path, and its cameras; more special layouts come first."""
    for dataset in sorted(DATASETS.values(), key=lambda dataset: dataset.general):
        if cameras := dataset.cameras(Path(where)):
            return dataset, cameras
    return None, {}


def _why_not(where: str) -> str:
    path = Path(where)
    if not path.exists():
        return "there is nothing: neither a file nor a folder has that name, nor one that matches it"
    inside = ", ".join(sorted(p.name for p in path.iterdir() if p.is_dir())[:8]) if path.is_dir() else ""
    return "there is no image in this folder" + (
        f"; it holds the folders {inside}: is one of them meant?" if inside else ""
    )
