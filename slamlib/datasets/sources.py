"""Where pictures come from: a folder, a glob, a video, or a public layout (slamlib.datasets.formats).

    layout      files                                       times
    TUM RGB-D   PATH/rgb.txt                                of rgb.txt
    EuRoC       PATH/[mav0/]camN/data.csv, or PATH/data.csv of data.csv, or of the names of camN/data/*
    KITTI       PATH/image_N/, best with PATH/times.txt     of times.txt, or 10 images per second
    KITTI raw   PATH/image_0N/data/, timestamps.txt beside  of timestamps.txt
    TartanAir   PATH/image_left/, image_right/              10 per second
    ICL-NUIM    PATH/rgb/                                   as of a folder
    folder      PATH/*.png, *.jpg, *.pgm, ...               of the names, or 30 per second by default
    glob        "PATH/left_*.png", or one image             as of a folder
    ZIP archive PATH.zip, or PATH.zip/left                  as of a folder
    list        PATH.txt: a file, or time and file, a row   of the list, or as of a folder
    video       one file that OpenCV can open               its own

Images are read one at a time, on demand, in the order of their times, or of the numbers in their names.
TUM-VI is EuRoC's layout, with pictures of 16 bits.
"""

import math
import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from slamlib.datasets.dataset import Dataset, ImageSource
from slamlib.datasets.formats import DATASETS
from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.times import Times, of_file
from slamlib.errors import SlamlibError


def of_pictures(pictures: list[TimedImage], interval: float) -> ImageSource:
    """A source of images in memory, typically `interval` [s] apart; it cannot be reopened."""
    names, times = zip(*((p.name, p.time) for p in pictures), strict=True) if pictures else ((), ())
    return ImageSource(names, times, interval, lambda frames: (pictures[i] for i in frames), range(len(pictures)))


def open_source(
    text: str | Path, *, fps: float | None = None, camera: int = 0, times: str | Path | None = None
) -> ImageSource:
    """The pictures at a path or a glob; of them at most a sample is read, for its number of bits, or a video's times.

    fps: images per second, if there are no times, or instead of a video's own, or those of names. camera: its number,
    in layouts with several (EuRoC, KITTI). times: a file of them instead, with a row for each picture: a time, or a
    time and the picture's name. Raises SlamlibError for a missing path, and for invalid lists.
    """
    if fps is not None and not 0 < fps < math.inf:
        raise SlamlibError(f"fps is the number of pictures a second, above 0, got {fps}")
    recipe = {"text": os.path.abspath(os.path.expanduser(text)), "fps": fps, "camera": camera}
    source = _opened(recipe)
    return _clear(source) if times is None else source.timed(*of_file(times, source.names))


def open_again(recipe: dict[str, Any]) -> ImageSource:
    """The source of a recipe, with all its images. Raises SlamlibError."""
    source = _opened({name: recipe[name] for name in ("text", "fps", "camera")})
    if "times" not in recipe:
        return _clear(source)
    order, values, interval = recipe["times"]
    return source.timed(order, Times(tuple(values), interval, stated=True))


def _opened(recipe: dict[str, Any]) -> ImageSource:
    where, camera = recipe["text"], recipe["camera"]
    dataset, cameras = _found(where)
    if dataset is None:
        raise SlamlibError(f"{where}: {_why_not(where)}")
    if camera not in cameras:
        raise SlamlibError(f"{where} ({dataset.name}) has no camera {camera}; it has {', '.join(map(str, cameras))}")
    return replace(dataset.open(cameras[camera], recipe["fps"]), layout=dataset.name, where=where, recipe=recipe)


def _clear(source: ImageSource) -> ImageSource:
    """The source, if its order is known. Raises SlamlibError."""
    if source.unclear:
        raise SlamlibError(f"{source.where}: {source.unclear}")
    return source


def cameras_at(where: str | Path) -> list[int]:
    """Numbers of the cameras at a path."""
    return sorted(_found(os.path.abspath(os.path.expanduser(where)))[1])


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
