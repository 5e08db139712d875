"""Images of a sequence, and reading them: grey, eight bits, complete, or an error that names the file.

A rectified pair is one image too: an array (2, h, w), the left image and the right one.
"""

import os
import re
import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Any, TypeVar

import numpy as np

from slamlib.errors import SlamlibError, optional
from slamlib.manifolds import Array, Image
from slamlib.sensors.sensor import Calibration

P = TypeVar("P", bound=PurePath)
ENDINGS = (".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp")
SIGN = r"(?:(?<![^/\\])-)?"  # of a number in a name: a minus begins it, a dash inside it parts words
WHOLE = re.compile(rf"({SIGN}\d+)")
PNG = b"\x89PNG\r\n\x1a\n"
# What libtiff (by OpenCV) and libjpeg say of pictures that are returned all the same, with a part made up.
_DAMAGE = (b"[ERROR", b"premature end")
# Some versions of OpenCV read a truncated file without an error: so its end is checked first.
_WHOLE: dict[bytes, Callable[[bytes], bool]] = {
    PNG: lambda data: b"IEND" in data,
    b"\xff\xd8\xff": lambda data: data.rstrip(b"\0").rfind(b"\xff\xd9") > len(data) // 2,
}


@dataclass(frozen=True, eq=False)
class TimedImage:
    """An image: the file's name (of a video, its number in it), time [s], grey values (h, w) of type uint8."""

    name: str
    time: float
    image: Image


def opencv(purpose: str) -> Any:
    """OpenCV; without it raises SlamlibError, which states the purpose ("to read images") and how to install it."""
    return optional("cv2", purpose, "images")


def read_image(path: str | Path) -> Array:
    """Grey values (h, w), uint8, of an image file; colours become their luminance. Raises SlamlibError."""
    return grey(pixels(whole(path), str(path)), str(path))


def whole(path: str | Path) -> bytes:
    """The content of a file. Raises SlamlibError."""
    try:
        return Path(path).read_bytes()
    except OSError as error:
        raise SlamlibError(f"{path} cannot be read: {error.strerror}") from None


def pixels(data: bytes, name: str) -> Array:
    """What OpenCV makes of an image file: grey, BGR or BGRA, of its own type. Raises SlamlibError, naming the file."""
    if not data:
        raise SlamlibError(f"{name} is empty")
    for beginning, is_whole in _WHOLE.items():
        if data.startswith(beginning) and not is_whole(data):
            raise SlamlibError(f"{name} is truncated: its end is missing; copy it again")
    cv2 = opencv("to read images")
    with overheard() as said:
        try:
            found = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)
        except cv2.error:  # of sizes beyond its limits, for instance
            found = None
    if found is None or any(sign in b"".join(said) for sign in _DAMAGE):
        raise SlamlibError(
            f"{name} cannot be read as an image: it is truncated, damaged, or of a kind OpenCV cannot read"
        )
    return found


@contextmanager
def overheard() -> Iterator[list[bytes]]:
    """What the libraries behind OpenCV, such as libpng, write to the standard error within the block."""
    said: list[bytes] = []
    try:
        own = os.dup(2)
    except OSError:  # there is no standard error
        yield said
        return
    with tempfile.TemporaryFile() as heard:
        os.dup2(heard.fileno(), 2)
        try:
            yield said
        finally:
            os.dup2(own, 2)
            os.close(own)
            heard.seek(0)
            said.append(heard.read())


def grey(pixels: Array, name: str, divisor: int | None = None) -> Array:
    """Grey values (h, w), uint8, of what OpenCV read: grey, BGR or BGRA. Raises SlamlibError, naming the picture.

    divisor: of a sequence of 16 bits a value (slamlib.datasets.brightness); what is brighter than its sample is white.
    """
    bits, wanted = 8 * pixels.dtype.itemsize, np.dtype(np.uint8 if divisor is None else np.uint16)
    if pixels.dtype != wanted:
        raise SlamlibError(
            f"{name} has {bits} bits a value ({pixels.dtype}); {8 * wanted.itemsize} are wanted, as in the first "
            "picture of a sequence: convert the images, with one scale for all of them to keep "
            "their brightness (or is this a depth image?)"
        )
    channels = 1 if pixels.ndim == 2 else pixels.shape[2]
    if channels not in (1, 3, 4):
        raise SlamlibError(f"{name} has {channels} channels: grey or colour pictures are wanted")
    if channels > 1:
        cv2 = opencv("to read images")
        pixels = cv2.cvtColor(pixels, cv2.COLOR_BGR2GRAY if channels == 3 else cv2.COLOR_BGRA2GRAY)
    found = pixels if pixels.ndim == 2 else pixels[..., 0]
    return found if divisor is None else np.minimum(found // divisor, 255).astype(np.uint8)


def in_natural_order(paths: Iterable[P]) -> list[P]:
    """Sorted by name, numbers in it by their value: 2.png comes before 10.png, and -5.png before 2.png."""

    def natural(path: P) -> list[tuple[int, int, str]]:
        return [(1, int(p), p) if p.lstrip("-").isdecimal() else (0, 0, p) for p in WHOLE.split(str(path))]

    return sorted(paths, key=natural)


def images_in(folder: Path) -> list[Path]:
    """The images of a folder in natural order; none where there is no folder."""
    return in_natural_order(path for path in folder.iterdir() if is_image(path)) if folder.is_dir() else []


def is_image(path: Path) -> bool:
    """Whether a file's name ends as an image's does; hidden files are excluded."""
    return is_image_name(path) and path.is_file()


def is_image_name(path: PurePath) -> bool:
    """Whether a name ends as an image's does, and is not hidden."""
    return path.suffix.lower() in ENDINGS and not path.name.startswith(".")


def pair(left: Array, right: Array) -> Array:
    """Two grey pictures (h, w), uint8, as the image (2, h, w) of a scan. Raises SlamlibError for unequal shapes."""
    left, right = np.asarray(left), np.asarray(right)
    if left.ndim != 2 or left.shape != right.shape:
        raise SlamlibError(
            f"a rectified pair has two grey pictures (h, w) of one size, got {left.shape} on the left and "
            f"{right.shape} on the right: rectify both with one size, and make colours grey"
        )
    return checked(np.stack([left, right]))


def checked(image: Image | None, calibration: Calibration | None = None) -> Array:
    """The pair (2, h, w) itself. Raises SlamlibError for anything else, or a size other than the calibration's."""
    array = np.asarray(image)
    if array.ndim != 3 or len(array) != 2 or array.dtype != np.uint8:
        found = "nothing" if image is None else f"{array.dtype} of shape {array.shape}"
        raise SlamlibError(
            f"a stereo scan's image is a rectified pair (2, h, w) of type uint8, got {found}: "
            "slamlib.vision.stereo.pair(left, right) makes it"
        )
    size = array.shape[:0:-1]
    if calibration is not None and calibration.image is not None and tuple(calibration.image) != size:
        width, height = calibration.image
        raise SlamlibError(f"the pair is {size[0]}x{size[1]}, and the calibration of {width:g}x{height:g} pixels")
    return array
