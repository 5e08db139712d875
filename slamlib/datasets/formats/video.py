"""A video file as a sequence of images, read by OpenCV from its start.

Pictures that are not wanted are passed over one by one: jumping to a number is not exact in many files. Times are the
number of the picture by the number of pictures a second: files with a varying rate are not worth trusting for less.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from slamlib.datasets.dataset import FPS, Dataset, ImageSource, Numbers
from slamlib.datasets.pictures import TimedImage, grey, is_image, opencv
from slamlib.errors import SlamlibError

SLACK = 0.02  # the length in a header is often an estimate: this share of it may be missing at the end


def _cameras(where: Path) -> dict[int, Path]:
    return {0: where} if where.is_file() and not is_image(where) else {}


def _open(where: Path, fps: float | None) -> ImageSource:
    """The pictures of a video, at its own rate if no other is given. Raises SlamlibError."""
    cv2 = opencv("to read videos")
    with _opened(where) as film:
        own, count = film.get(cv2.CAP_PROP_FPS), int(film.get(cv2.CAP_PROP_FRAME_COUNT))
        if count <= 0:  # unknown in some containers: then they are counted
            count = sum(1 for _ in iter(film.grab, False))
        elif not film.grab():
            count = 0
    if not count:
        raise SlamlibError(f"{where} is a video without a single picture that can be read")
    rate = fps or (own if math.isfinite(own) and own > 0 else FPS)
    times = tuple(number / rate for number in range(count))
    names = tuple(f"picture {number}" for number in range(count))

    def read(numbers: Numbers) -> Iterator[TimedImage]:
        with _opened(where) as film:
            for number in range(numbers[-1] + 1):
                if not film.grab():
                    if count - number > max(2, SLACK * count):
                        raise SlamlibError(
                            f"{where} breaks off after {number} of {count} pictures: it is truncated or damaged; with "
                            "--frames fewer of them can be used"
                        )
                    return
                if number in numbers:
                    good, pixels = film.retrieve()
                    if not good:
                        raise SlamlibError(f"{where}: picture {number} is damaged")
                    yield TimedImage(names[number], times[number], grey(pixels, f"{where}, picture {number}"))

    return ImageSource(names, times, 1 / rate, read, range(count))


@contextmanager
def _opened(where: Path) -> Iterator[Any]:
    film = opencv("to read videos").VideoCapture(str(where))
    try:
        if not film.isOpened():
            raise SlamlibError(
                f"{where} is no image, and OpenCV cannot open it as a video: is it truncated or no video?"
            )
        yield film
    finally:
        film.release()


VIDEO = Dataset("video", _cameras, _open, general=True)
