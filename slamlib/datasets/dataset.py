"""What a file of slamlib.datasets.formats says: a Dataset for a layout of pictures, a CalibrationReader for a format.

Both are found by walking that folder, so that another data set, or another calibration tool, is one written file.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.lens import Lens
from slamlib.datasets.pictures import TimedImage, read_image
from slamlib.errors import SlamlibError

FPS = 30.0
Numbers = range | list[int]


@dataclass(frozen=True)
class Sequence:
    """Names and times [s] of all pictures, `interval` [s] between two of them as a rule.

    read(numbers, ascending) yields some of them. has_times: whether a list says the times, so that they tell which
    pictures of two cameras belong together; otherwise they are counted.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    interval: float
    read: Callable[[Numbers], Iterator[TimedImage]]
    has_times: bool = False


@dataclass(frozen=True)
class Dataset:
    """A layout of pictures on disk.

    cameras(path): the file or folder of each camera, by its number; none where this is not the layout. open(that,
    pictures a second or None): its sequence. general: whether layouts of more special files are asked first.
    calibrations: where a data set's folder holds them, with {camera} for its number. raw: whether its pictures are as
    the lenses made them, so that pairs must be rectified. lenses: of its cameras, by names that need no file.
    """

    name: str
    cameras: Callable[[Path], Mapping[int, Path]]
    open: Callable[[Path, float | None], Sequence]
    general: bool = False
    calibrations: tuple[str, ...] = ()
    raw: bool = False
    lenses: Mapping[str, Lens] = field(default_factory=dict)


@dataclass(frozen=True)
class CalibrationReader:
    """A format of calibration files, recognised by what is in them.

    fits(text): whether a file is of this format. read(path, text): for the number of each camera (None in a file of
    one, which has no number) what gives its lens, or a camera of another type with setup() and lens. Both may raise
    SlamlibError, AttributeError, IndexError, KeyError, TypeError or ValueError.
    """

    name: str
    fits: Callable[[str], bool]
    read: Callable[[Path, str], Mapping[int | None, Callable[[], Any]]]


def table(path: Path, columns: int, separator: str | None) -> list[tuple[float, list[str]]]:
    """The rows of a list: time, and the words after it; # begins a comment. Raises SlamlibError, naming the line."""
    rows = []
    for number, line in enumerate(path.read_text("utf-8", errors="replace").splitlines(), 1):
        time, *words = [word.strip() for word in line.split(separator)] or [""]
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        if len(words) < columns - 1:
            raise SlamlibError(f"{path}, line {number}: {columns} columns are wanted, got {line!r}")
        try:
            rows.append((float(time), words))
        except ValueError:
            raise SlamlibError(f"{path}, line {number}: {time!r} is no time") from None
    if not rows:
        raise SlamlibError(f"{path} lists no picture")
    return rows


def counted(paths: list[Path], fps: float) -> Sequence:
    """Images without times, `fps` a second."""
    return listed(paths, [number / fps for number in range(len(paths))], Path("."), 1 / fps)


def listed(paths: list[Path], times: list[float], listing: Path, interval: float | None = None) -> Sequence:
    """Images with the times [s] of a list. Raises SlamlibError for times that do not grow, and for files not there."""
    wrong = np.flatnonzero(~(np.diff(times) > 0))
    if len(wrong):
        i, j = wrong[0], wrong[0] + 1
        raise SlamlibError(
            f"{listing}: times must grow, but {paths[i].name} is of {times[i]} s and {paths[j].name} of {times[j]} s "
            f"({len(wrong)} such places): sort the rows, and leave out what is there twice"
        )
    missing = [path for path in paths if not path.is_file()]
    if missing:
        raise SlamlibError(f"{listing} lists {len(missing)} files that are not there, the first of them {missing[0]}")

    def read(numbers: Numbers) -> Iterator[TimedImage]:
        return (TimedImage(paths[number].name, times[number], read_image(paths[number])) for number in numbers)

    typical = float(np.median(np.diff(times))) if len(times) > 1 else 1 / FPS
    return Sequence(tuple(path.name for path in paths), tuple(times), interval or typical, read, interval is None)
