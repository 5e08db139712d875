"""A rectified pair as one array (2, h, w), checked."""

import base64
import zlib
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image
from slamlib.sensors.sensor import Calibration


def pair(left: Array, right: Array) -> Array:
    """Two grey pictures (h, w), uint8, as the image (2, h, w) of a scan. Raises SlamlibError if they do not fit."""
    left, right = np.asarray(left), np.asarray(right)
    if left.ndim != 2 or left.shape != right.shape:
        raise SlamlibError(
            f"a rectified pair has two grey pictures (h, w) of one size, got {left.shape} on the left and "
            f"{right.shape} on the right: rectify both with one size, and make colours grey"
        )
    return checked(np.stack([left, right]))


def checked(image: Any, calibration: Calibration | None = None) -> Array:
    """The pair (2, h, w) itself. Raises SlamlibError for what is none, or has another size than the calibration's."""
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


def pack(image: Image) -> list[Any]:
    """A pair (2, h, w) as plain data, without loss: its shape, and text."""
    return [list(image.shape), base64.b64encode(zlib.compress(image.tobytes(), 1)).decode()]


def unpack(packed: list[Any]) -> Array:
    """What `pack` packed."""
    shape, text = packed
    return np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8).reshape(shape)
