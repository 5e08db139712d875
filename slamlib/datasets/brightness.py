"""Pictures of sixteen bits a value: one divisor for a whole sequence, so that its brightness stays comparable.

Cameras of 10, 12 or 14 bits write their values as they are, or shifted up to fill sixteen bits (TUM-VI: eight bits, of
which the lower byte says little). The largest value in a sample of the sequence tells how many bits are in use.

Depth images have sixteen bits, too, and are no pictures. They are known by the name of their folder or file, and by
their holes: pixels of zero whose neighbours are as far as the rest. In a picture black and bright are no neighbours.
"""

import re
from collections.abc import Callable, Iterator

import numpy as np

from slamlib.datasets.pictures import PNG, pixels
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

SAMPLE = 16  # pictures
BITS = (8, 10, 12, 14, 16)
HOLES = 4.0  # edges of holes a row of pixels; a lens whose picture is a circle has two
_DEPTH = re.compile(r"(?i)(?<![a-z])(depth|disp|disparity)(?![a-z])")


def divided(places: list[str], files: Callable[[list[int]], Iterator[bytes]]) -> tuple[int | None, tuple[str, ...]]:
    """The divisor of pictures of 16 bits, and what is to be said of it; None for pictures of 8 bits.

    places: what messages call the files; files(numbers): contents of some. Raises SlamlibError for depth images.
    """
    if not _has_sixteen(places[0], next(files([0]))):
        return None, ()
    sample = sorted({round(number) for number in np.linspace(0, len(places) - 1, SAMPLE)})
    images = [pixels(data, places[number]) for number, data in zip(sample, files(sample), strict=True)]
    for number, image in zip(sample, images, strict=True):
        if _DEPTH.search("/".join(re.split(r"[/\\]", places[number])[-2:])) or _has_holes(image):
            raise SlamlibError(f"{places[number]} is a depth image, by its name or its holes: pictures are wanted")
    most = max(int(image.max()) for image in images)
    bits = next(bits for bits in BITS if most < 2**bits)
    return 2 ** (bits - 8), (f"the pictures have 16 bits a value, {bits} in use: all are divided by {2 ** (bits - 8)}",)


def _has_sixteen(place: str, data: bytes) -> bool:
    """Whether a picture has 16 bits a value; only one whose header does not tell is decoded."""
    if data.startswith(PNG):
        return data[24:25] == b"\x10"
    return data[:2] in (b"P5", b"P6", b"II", b"MM") and pixels(data, place).dtype == np.uint16


def _has_holes(image: Array) -> bool:
    if image.ndim != 2 or not image.any():
        return False
    jump = (image[:, 1:] == 0) != (image[:, :-1] == 0)
    far = np.maximum(image[:, 1:], image[:, :-1]) > np.median(image[image > 0]) / 2
    return bool(np.count_nonzero(jump & far) > HOLES * len(image))
