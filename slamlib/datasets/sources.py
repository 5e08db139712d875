"""Where pictures come from: a folder, a glob, a video, or a public layout (slamlib.datasets.formats).

    layout      what is there                               times
    TUM RGB-D   PATH/rgb.txt                                of rgb.txt
    EuRoC       PATH/[mav0/]camN/data.csv, or PATH/data.csv of data.csv
    KITTI       PATH/image_N/, best with PATH/times.txt     of times.txt, or 10 pictures a second
    folder      PATH/*.png, *.jpg, *.pgm, ...               30 a second, if nothing else is said
    video       one file that OpenCV can open               its number of pictures a second
    glob        "PATH/left_*.png", or one image             30 a second, if nothing else is said

Pictures are read one at a time, when they are asked for, in the order of their times, or of the numbers in their names.
"""

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import accumulate
from pathlib import Path
from typing import Any

from slamlib.datasets.dataset import Dataset, Numbers, Sequence
from slamlib.datasets.formats import DATASETS
from slamlib.datasets.pictures import TimedImage
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image


@dataclass(frozen=True, eq=False)
class ImageSource:
    """A sized iterable of pictures, all of one size; each round reads them anew.

    layout: its name; where: the absolute path; frames: the numbers of its pictures in the whole sequence;
    sequence: names and times of the whole, with the typical time between two neighbours; recipe: plain data to open the
    same again.
    Iterating raises SlamlibError, which names the picture, for one that cannot be read or has another size.
    """

    layout: str
    where: str
    frames: range
    sequence: Sequence
    recipe: dict[str, Any]

    def __len__(self) -> int:
        return len(self.frames)

    @property
    def interval(self) -> float:
        """Typical time [s] between two neighbours of the whole sequence."""
        return self.sequence.interval

    def __iter__(self) -> Iterator[TimedImage]:
        first: TimedImage | None = None
        for picture in self.sequence.read(self.frames):
            first = first or picture
            if picture.image.shape != first.image.shape:
                raise SlamlibError(
                    f"the pictures change their size: {first.name} is {_size(first.image)}, {picture.name} is "
                    f"{_size(picture.image)}; pictures of one camera are wanted (are there two in {self.where}?)"
                )
            yield picture

    def part(self, start: int = 0, every: int = 1, count: int | None = None) -> "ImageSource":
        """From picture number `start` on (0: the first), each so many-th, at most `count` of them."""
        if start < 0 or every < 1 or (count is not None and count < 1):
            raise SlamlibError(f"start is 0 or more, every and frames 1 or more, got {start}, {every}, {count}")
        frames = self.frames[start::every][:count]
        if not frames:
            raise SlamlibError(f"{self.where} has {len(self)} pictures: none is left from number {start} on")
        chosen = [frames.start, frames.stop, frames.step]
        return replace(self, frames=frames, recipe={**self.recipe, "frames": chosen})

    def again(self, recipe: dict[str, Any], count: int | None = None) -> "ImageSource":
        """Of the whole, the part of a recipe, or `count` pictures from its first one on. Raises SlamlibError."""
        chosen = range(*recipe.get("frames", (len(self),)))
        if chosen[-1] >= len(self):
            raise SlamlibError(f"{self.where} has {len(self)} pictures, and had more when the run was saved")
        if count is None and "frames" not in recipe:
            return self
        return self.part(chosen.start, chosen.step, len(chosen) if count is None else count)

    def through(self, change: Callable[[Array], Array], recipe: dict[str, Any]) -> "ImageSource":
        """The same pictures, each changed, as by an undistortion; recipe: plain data that tells of the change too."""

        def read(frames: Numbers) -> Iterator[TimedImage]:
            return (replace(picture, image=change(picture.image)) for picture in self.sequence.read(frames))

        return replace(self, sequence=replace(self.sequence, read=read), recipe=recipe)


def of_pictures(pictures: list[TimedImage], interval: float) -> ImageSource:
    """A source of pictures that are in memory, `interval` [s] apart as a rule; it cannot be opened again."""
    names, times = zip(*((p.name, p.time) for p in pictures), strict=True) if pictures else ((), ())
    whole = Sequence(names, times, interval, lambda frames: (pictures[i] for i in frames))
    return ImageSource("memory", "memory", range(len(pictures)), whole, {})


def of_film(film: Any, sensor: int = 0) -> ImageSource:
    """The images of one sensor of a rendered film (slambook.rendering), made anew each time they are read."""

    def read(frames: Numbers) -> Iterator[TimedImage]:
        for i, (frame, _) in zip(range(frames[-1] + 1), film, strict=False):
            if i in frames:
                yield TimedImage(names[i], times[i], frame.scans[sensor].image)

    names, times = tuple(f"frame {n + 1}" for n in range(len(film))), tuple(accumulate([film.dt] * len(film)))
    return ImageSource("film", "a rendered film", range(len(film)), Sequence(names, times, film.dt, read), {})


def open_source(text: str | os.PathLike[str], *, fps: float | None = None, camera: int = 0) -> ImageSource:
    """The pictures at a path or a glob; no picture is read yet, but of a video's header.

    fps: pictures a second, where there are no times, or in place of a video's own. camera: its number, in layouts with
    several (EuRoC, KITTI). Raises SlamlibError for nothing there, and for lists that make no sense.
    """
    if fps is not None and not fps > 0:
        raise SlamlibError(f"fps is the number of pictures a second, above 0, got {fps}")
    where = os.path.abspath(text)
    dataset, cameras = _found(where)
    if dataset is None:
        raise SlamlibError(f"{text}: {_why_not(where)}")
    if camera not in cameras:
        raise SlamlibError(f"{text} ({dataset.name}) has no camera {camera}; it has {', '.join(map(str, cameras))}")
    whole = dataset.open(cameras[camera], fps)
    recipe = {"text": where, "fps": fps, "camera": camera}
    return ImageSource(dataset.name, where, range(len(whole.times)), whole, recipe)


def cameras_at(where: str | os.PathLike[str]) -> list[int]:
    """Numbers of the cameras whose pictures are there."""
    return sorted(_found(os.path.abspath(where))[1])


def _found(where: str) -> tuple[Dataset | None, Mapping[int, Path]]:
    """The layout of what is at a path, and its cameras; layouts of special files come first."""
    for dataset in sorted(DATASETS.values(), key=lambda dataset: dataset.general):
        if cameras := dataset.cameras(Path(where)):
            return dataset, cameras
    return None, {}


def _size(image: Image) -> str:
    return f"{image.shape[-1]}x{image.shape[-2]}"


def _why_not(where: str) -> str:
    path = Path(where)
    if not path.exists():
        return "there is nothing: neither a file nor a folder has that name, nor one that matches it"
    inside = ", ".join(sorted(p.name for p in path.iterdir() if p.is_dir())[:8]) if path.is_dir() else ""
    return "there is no image in this folder" + (
        f"; it holds the folders {inside}: is one of them meant?" if inside else ""
    )
