"""A video file as a sequence of images, read by OpenCV from its start.

Pictures that are not wanted are passed over one by one: jumping to a number is not exact in many files. Times are the
number of the picture by the number of pictures a second; where the file's own times, as those of telephones, differ
from that, they are its own. To know them it is read once from end to end, unless a rate is given.
A film with a flag of rotation is turned by it, as players do.
"""

import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.dataset import Dataset, ImageSource, Numbers
from slamlib.datasets.pictures import TimedImage, grey, is_image, opencv, overheard
from slamlib.datasets.times import FILM, FPS
from slamlib.errors import SlamlibError

VARIES = 0.1  # of the interval: times that differ from even ones by more are the file's own
LONG = 10**6  # pictures, nine hours: a header that states more is not believed
SLACK = 0.02  # the length in a header is often an estimate: this share of it may be missing at the end


def _cameras(where: Path) -> dict[int, Path]:
    return {0: where} if where.is_file() and not is_image(where) else {}


def _open(where: Path, fps: float | None) -> ImageSource:
    """The pictures of a video, at its own rate if no other is given. Raises SlamlibError."""
    cv2 = opencv("to read videos")
    with _opened(where) as film:
        own, count = film.get(cv2.CAP_PROP_FPS), int(film.get(cv2.CAP_PROP_FRAME_COUNT))
        turned = film.get(cv2.CAP_PROP_ORIENTATION_META)
        is_read = not fps or not 0 < count < LONG
        there = _times(film, None if is_read else 1)
    if not there:
        raise SlamlibError(f"{where} is a video without a single picture that can be read")
    stated = count if count > 0 else len(there)  # unknown in some containers
    # the picture after the last one of a film that breaks off tells of it
    count = len(there) + 1 if is_read and _is_missing(stated - len(there), stated) else stated
    notes = [f"{where.name} is turned by {turned:g} degrees, as it says"] * bool(turned)
    is_plausible = math.isfinite(own) and own > 0 and FILM[0] <= 1 / own <= FILM[1]
    rate = fps or (own if is_plausible else FPS)
    interval, times = 1 / rate, [number / rate for number in range(count)]
    if not fps and _vary(there[:count], rate):
        interval, times[: len(there)] = float(np.median(np.diff(there))), there[:count]
        notes.append(f"{where.name} has a varying rate: its own times are taken, a picture every {interval:.3g} s")
    elif not fps and not is_plausible:
        notes.append(f"{where.name} does not tell its rate: {rate:g} pictures a second are assumed (--fps N)")
    names = tuple(f"picture {number}" for number in range(count))

    def read(numbers: Numbers) -> Iterator[TimedImage]:
        with _opened(where) as film:
            for number in range(numbers[-1] + 1):
                if not film.grab():
                    if _is_missing(stated - number, stated):
                        raise SlamlibError(
                            f"{where} breaks off after {number} of {stated} pictures: it is truncated or damaged; with "
                            "--frames fewer of them can be used"
                        )
                    return
                if number in numbers:
                    good, pixels = film.retrieve()
                    if not good or pixels is None:
                        raise SlamlibError(f"{where}: picture {number} is damaged")
                    yield TimedImage(names[number], times[number], grey(pixels, f"{where}, picture {number}"))

    return ImageSource(names, tuple(times), interval, read, range(count), notes=tuple(notes))


def _is_missing(missing: int, stated: int) -> bool:
    """Whether more pictures are missing at the end than a header's estimate explains."""
    return missing > max(2, SLACK * stated)


def _times(film: Any, most: int | None) -> list[float]:
    """The file's own times [s] of its pictures, or of its first ones, from the first one on."""
    found: list[float] = []
    position = opencv("to read videos").CAP_PROP_POS_MSEC
    while len(found) != most and film.grab():
        found.append(film.get(position) / 1000)
    return [time - found[0] for time in found]


def _vary(times: list[float], rate: float) -> bool:
    """Whether a film's own times are plausible, and not those of its rate."""
    steps = np.diff(times)
    if not len(steps) or not (steps > 0).all() or not FILM[0] <= np.median(steps) <= FILM[1]:
        return False
    return bool(np.abs(np.array(times) - np.arange(len(times)) / rate).max() > VARIES / rate)


@contextmanager
def _opened(where: Path) -> Iterator[Any]:
    os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")  # of a damaged film it says thousands of lines
    cv2 = opencv("to read videos")
    with overheard():
        film = cv2.VideoCapture(str(where))
    film.set(cv2.CAP_PROP_ORIENTATION_AUTO, 1)  # the default of some versions alone
    try:
        if not film.isOpened():
            raise SlamlibError(
                f"{where} is no image, and OpenCV cannot open it as a video: is it truncated or no video?"
            )
        yield film
    finally:
        film.release()


VIDEO = Dataset("video", _cameras, _open, general=True)
