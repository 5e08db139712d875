"""A source of images, and what a file of slamlib.datasets.formats defines: a Dataset, or a CalibrationReader.

Both are found by walking that folder, so another data set, or another calibration tool, needs one new file.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

from slamlib.datasets.brightness import divided
from slamlib.datasets.lens import Lens
from slamlib.datasets.pictures import TimedImage, grey, pixels, whole
from slamlib.datasets.times import FPS, Times, of_list, of_names, table
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array

Numbers = range | list[int]


@dataclass(frozen=True, eq=False)
class ImageSource:
    """A sized iterable of images, all of one size; each iteration reads them again.

    names, times [s]: of the whole sequence; interval [s]: typical, between two neighbours of it. read(numbers,
    ascending) yields some of them. frames: the numbers of its own images in the whole. has_times: whether a list gives
    the times, by which images of two cameras can be paired; otherwise they follow from the numbers. layout: its name;
    where: the absolute path; recipe: plain data to open the same source again. original (7,): pose of the camera that
    took the images in the frame of the one whose images they are now: a rectification turns it. guess, unclear: of
    their times, as of Times. notes: what else is to be said of them, in sentences.
    Iterating raises SlamlibError, which names the picture, for one that cannot be read or has another size.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    interval: float
    read: Callable[[Numbers], Iterator[TimedImage]]
    frames: range
    has_times: bool = False
    layout: str = "memory"
    where: str = "memory"
    recipe: dict[str, Any] = field(default_factory=dict)
    original: Array = field(default_factory=lambda: ORIGIN)
    guess: str = ""
    unclear: str = ""
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.frames)

    def __iter__(self) -> Iterator[TimedImage]:
        first: TimedImage | None = None
        for picture in self.read(self.frames):
            first = first or picture
            if picture.image.shape != first.image.shape:
                one, other = (f"{p.name} is {p.image.shape[-1]}x{p.image.shape[-2]}" for p in (first, picture))
                raise SlamlibError(
                    f"the pictures change their size: {one}, {other}; pictures of one camera are wanted (are there two "
                    f"in {self.where}?)"
                )
            yield picture

    def part(self, start: int = 0, every: int = 1, count: int | None = None) -> "ImageSource":
        """The images from number `start` on (0: the first), each `every`-th, at most `count` of them."""
        if start < 0 or every < 1 or (count is not None and count < 1):
            raise SlamlibError(f"start is 0 or more, every and frames 1 or more, got {start}, {every}, {count}")
        frames = self.frames[start::every][:count]
        if not frames:
            raise SlamlibError(f"{self.where} has {len(self)} pictures: none is left from number {start} on")
        return replace(self, frames=frames, recipe={**self.recipe, "frames": [frames.start, frames.stop, frames.step]})

    def again(self, recipe: dict[str, Any], count: int | None = None) -> "ImageSource":
        """The part given by a recipe, or `count` images from its first one on. Raises SlamlibError."""
        chosen = range(*recipe.get("frames", (len(self),)))
        if chosen[-1] >= len(self):
            raise SlamlibError(f"{self.where} has {len(self)} pictures, and had more when the run was saved")
        if count is None and "frames" not in recipe:
            return self
        return self.part(chosen.start, chosen.step, len(chosen) if count is None else count)

    def timed(self, order: list[int], times: Times) -> "ImageSource":
        """The images in this order, with these times. Raises SlamlibError for another number of them."""
        if len(order) != len(self):
            raise SlamlibError(f"{self.where} has {len(self)} pictures, and {len(order)} times are given")

        def read(numbers: Numbers) -> Iterator[TimedImage]:
            for number, picture in zip(numbers, self.read([order[number] for number in numbers]), strict=False):
                yield replace(picture, time=times.values[number])

        recipe = {**self.recipe, "times": [order, times.values, times.interval]}
        changed: dict[str, Any] = {
            "names": tuple(self.names[i] for i in order),
            "times": times.values,
            "interval": times.interval,
        }
        return replace(self, **changed, read=read, has_times=True, recipe=recipe, guess=times.guess, unclear="")

    def through(self, change: Callable[[Array], Array], recipe: dict[str, Any], original: Array) -> "ImageSource":
        """The same images, each changed, as by an undistortion; recipe: plain data that includes the change."""

        def read(frames: Numbers) -> Iterator[TimedImage]:
            return (replace(picture, image=change(picture.image)) for picture in self.read(frames))

        return replace(self, read=read, recipe=recipe, original=original)


@dataclass(frozen=True)
class Dataset:
    """A layout of images on disk.

    cameras(path): the file or folder of each camera, by its number; none where this is not the layout. open(that,
    images per second or None): its images. general: whether layouts of more special files are tried first.
    calibrations: where a data set's folder holds them, with {camera} for its number. raw: whether its images are
    not rectified, so that pairs must be. lenses: of its cameras, by names that need no file.
    """

    name: str
    cameras: Callable[[Path], Mapping[int, Path]]
    open: Callable[[Path, float | None], ImageSource]
    general: bool = False
    calibrations: tuple[str, ...] = ()
    raw: bool = False
    lenses: Mapping[str, Lens] = field(default_factory=dict)


class Camera(Protocol):
    """A camera of a calibration file: a Lens, or another one."""

    @property
    def lens(self) -> Lens: ...

    def setup(self) -> dict[str, Any]:
        """Plain data of its SensorSetup."""


Cameras = Mapping[int | None, Callable[[], Camera]]
# What tools write beside a calibration, of how it was made: patterns of names, as slamlib.plain_data.entries compares.
METADATA = (
    "*error*", "*rms*", "*deviation*", "*stddev*", "std*", "*uncertainty*", "*covariance*", "*pattern*", "*square*",
    "*board*", "*marker*", "*dictionary*", "*grid*", "*time*", "*date*", "*flags", "nframes", "nrofframes", "nviews",
    "nimages", "num*", "*count", "aspectratio", "fix*", "zerotangent*", "assumezero*", "perview*", "perimage*",
    "extrinsic*", "rvec*", "tvec*", "*imagepoints*", "*objectpoints*", "*version", "fps", "framerate", "rate*",
    "focallength*", "serial*", "cameraid", "id", "comment*",
)  # fmt: skip


@dataclass(frozen=True)
class CalibrationReader:
    """A format of calibration files, recognised by their content.

    fits(text): whether a file is of this format. read(path, text): by the number of each camera (None in a file of
    one, without number), a function that returns its lens, or another camera with setup() and lens. This may raise
    SlamlibError, AttributeError, IndexError, KeyError, TypeError or ValueError. in_metres: whether the format says what
    its lengths are in, so that an unusual one is meant.
    """

    name: str
    fits: Callable[[str], bool]
    read: Callable[[Path, str], Cameras]
    in_metres: bool = False


def listed_files(listing: Path, folder: Path, unit: str = "seconds") -> ImageSource:
    """The images that a list of rows "time, file" names in a folder; unit: of its times, in the list's format."""
    rows = table(listing, 2)
    return listed([folder / name for _, (name, *_) in rows], [time for time, _ in rows], listing, unit)


def listed(paths: list[Path], times: list[float], listing: Path, unit: str = "seconds") -> ImageSource:
    """Images with the times of a list. Raises SlamlibError for times that do not increase, or missing files."""
    found = of_list(times, [path.name for path in paths], listing, unit)
    missing = [path for path in paths if not path.is_file()]
    if missing:
        raise SlamlibError(f"{listing} lists {len(missing)} files that are not there, the first of them {missing[0]}")
    return _of_files(paths, found)


def counted(paths: list[Path], fps: float | None, usual: float = FPS) -> ImageSource:
    """Images with the times that their names give, or `fps` of them per second; usual: if it is not given."""
    order, times = of_names([path.name for path in paths], fps, usual)
    return _of_files([paths[i] for i in order], times)


def _of_files(paths: list[Path], times: Times) -> ImageSource:
    return encoded(list(map(str, paths)), times, lambda numbers: (whole(paths[number]) for number in numbers))


def encoded(places: list[str], times: Times, files: Callable[[Numbers], Iterator[bytes]]) -> ImageSource:
    """Images from the contents of their files. places: what messages call them; a picture's name is the last part."""
    names = tuple(re.split(r"[/\\]", place)[-1] for place in places)
    divisor, notes = divided(places, files)

    def read(numbers: Numbers) -> Iterator[TimedImage]:
        for number, data in zip(numbers, files(numbers), strict=True):
            yield TimedImage(
                names[number], times.values[number], grey(pixels(data, places[number]), places[number], divisor)
            )

    known = times.values, times.interval, read, range(len(names)), times.stated
    return ImageSource(names, *known, guess=times.guess, unclear=times.unclear, notes=notes)
