"""What a page has of OpenCV: as much as reading a sequence of grey pictures needs, in NumPy. Imported there as cv2.

The browser has decoded the pictures already (worker.js); their files hold plain grey values, PGM.
"""

import re
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image

IMREAD_UNCHANGED, INTER_LINEAR, CV_32FC1 = -1, 1, 5  # OpenCV's numbers
HEADER = re.compile(rb"P5\s+(\d+)\s+(\d+)\s+255\s")
error = SlamlibError


class NotInThePageError(SlamlibError, AttributeError):
    """A function of OpenCV that the page has not."""


def __getattr__(name: str) -> Any:
    raise NotInThePageError(
        f"the page has of OpenCV what reads grey pictures, and no cv2.{name}: download the notebook, and run it"
    )


def imdecode(data: Array, flags: int) -> Image | None:
    """Grey values (h, w), uint8, of a PGM file's bytes; None for anything else."""
    content = np.asarray(data, np.uint8).tobytes()
    header = HEADER.match(content)
    if header is None:
        return None
    width, height = int(header[1]), int(header[2])
    return np.frombuffer(content, np.uint8, width * height, header.end()).reshape(height, width)


def initUndistortRectifyMap(
    matrix: Array, distortion: Array, turn: Array, new: Array, size: tuple[int, int], kind: int
) -> tuple[Array, Array]:
    """Columns and rows (h, w), float32, in the picture of a lens, of the pixels of a pin-hole; OpenCV's radial model.

    matrix, new: camera matrices (3, 3) of both. distortion: k1 k2 p1 p2 k3 to k6. turn (3, 3): from the lens's rays
    to the pin-hole's. size: (width, height) of the new picture.
    """
    k1, k2, p1, p2, k3, k4, k5, k6 = distortion
    pixels = np.stack([*np.meshgrid(*map(np.arange, size)), np.ones(size[::-1])], axis=-1)
    rays = pixels @ np.linalg.inv(new @ turn).T
    x, y = np.moveaxis(rays[..., :2] / rays[..., 2:], -1, 0)
    r = x * x + y * y
    radial = (1 + ((k3 * r + k2) * r + k1) * r) / (1 + ((k6 * r + k5) * r + k4) * r)
    columns = matrix[0, 0] * (x * radial + 2 * p1 * x * y + p2 * (r + 2 * x * x)) + matrix[0, 2]
    rows = matrix[1, 1] * (y * radial + p1 * (r + 2 * y * y) + 2 * p2 * x * y) + matrix[1, 2]
    return columns.astype(np.float32), rows.astype(np.float32)


def remap(image: Image, columns: Array, rows: Array, interpolation: int) -> Image:
    """The picture's values at these places, bilinear; zero outside."""
    padded = np.pad(image, ((1, 2), (1, 2))).astype(np.float32)
    u, v = (np.clip(at, -1, size) for at, size in zip((columns, rows), image.shape[::-1], strict=True))
    i, j = np.floor(v).astype(int), np.floor(u).astype(int)
    b, a = v - i, u - j
    i, j = i + 1, j + 1
    upper, lower = (padded[k, j] + a * (padded[k, j + 1] - padded[k, j]) for k in (i, i + 1))
    return np.rint(upper + b * (lower - upper)).astype(np.uint8)
