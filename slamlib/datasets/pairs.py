"""Pairs: one array (2, h, w) of two pictures, and the sequence of them that two cameras, folders or videos make.

Pictures belong together by their times where a list tells them (EuRoC: one that the other camera lacks is left out),
and otherwise by their order, which the numbers in their names must agree with. A pair is a Picture whose image is
(2, h, w): a Source of pairs is one as of pictures, with parts, changes, and a recipe to open it again.
"""

import base64
import os
import re
import zlib
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.datasets.dataset import ImageSource, Numbers
from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.sources import cameras_at
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import matched_times
from slamlib.manifolds import Array, Indices
from slamlib.sensors.sensor import Calibration

CAMERAS = ((0, 1), (2, 3))  # left and right; KITTI's 2 and 3 are the coloured ones
MAX_TIME_SHARE = 0.1  # of the interval: times of one pair may differ by so much


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


def pack(image: Array) -> list[Any]:
    """A pair (2, h, w) as plain data, without loss: its shape, and text."""
    return [list(image.shape), base64.b64encode(zlib.compress(image.tobytes(), 1)).decode()]


def unpack(packed: list[Any]) -> Array:
    """What `pack` packed."""
    shape, text = packed
    return np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8).reshape(shape)


def two_cameras(where: str | os.PathLike[str]) -> tuple[int, int]:
    """The numbers of the left and the right camera in a data set's folder. Raises SlamlibError where there are none."""
    there = cameras_at(where)
    found = next((two for two in CAMERAS if set(two) <= set(there)), None)
    if found is None:
        have = f"it has camera {', '.join(map(str, there))}" if there else "there is none"
        raise SlamlibError(
            f"{where} has no pair of cameras, 0 and 1 or 2 and 3 ({have}): name the pictures with --left and --right"
        )
    return found


def open_pairs(left: ImageSource, right: ImageSource) -> ImageSource:
    """The pairs of two cameras; no picture is read yet. Raises SlamlibError for lists that do not fit together."""
    i, j = (_by_time if left.has_times and right.has_times else _by_order)(left, right)
    names, times = (tuple(np.array(values)[i].tolist()) for values in (left.names, left.times))

    def read(numbers: Numbers) -> Iterator[TimedImage]:
        rows = np.array(numbers, dtype=int)
        for one, other in zip(left.read(i[rows].tolist()), right.read(j[rows].tolist()), strict=True):
            try:
                yield replace(one, image=pair(one.image, other.image))
            except SlamlibError as error:
                raise SlamlibError(f"{one.name} and {other.name}: {error}") from None

    where = left.where if left.where == right.where else f"{left.where}, {right.where}"
    recipe = {"left": left.recipe, "right": right.recipe}
    return replace(left, names=names, times=times, read=read, frames=range(len(i)), where=where, recipe=recipe)


def _by_time(left: ImageSource, right: ImageSource) -> tuple[Indices, Indices]:
    """Rows of pictures of one time; what has no partner is left out."""
    one, other, tolerance = np.array(left.times), np.array(right.times), MAX_TIME_SHARE * left.interval
    i, j = matched_times(one, other, tolerance)
    if not len(i):
        raise SlamlibError(
            f"the times of the two cameras do not match: no left picture of {one[0]:.3f} to {one[-1]:.3f} s has a "
            f"right one ({other[0]:.3f} to {other[-1]:.3f} s) within {tolerance:.3g} s"
        )
    return i, j


def _by_order(left: ImageSource, right: ImageSource) -> tuple[Indices, Indices]:
    """All rows, if there are as many left as right, and the numbers that count in their names agree."""
    one, other = left.names, right.names
    if len(one) != len(other):
        alone = [name for name in one if name not in set(other)] + [name for name in other if name not in set(one)]
        which = f" (alone: {', '.join(alone[:3])}{', ...' if len(alone) > 3 else ''})" if len(alone) < len(one) else ""
        raise SlamlibError(
            f"{left.where} has {len(one)} pictures, and {right.where} has {len(other)}{which}: as many are wanted on "
            "the left as on the right"
        )
    for a, b in zip(_counted(one), _counted(other), strict=True):
        for name, partner, n, m in zip(one, other, a, b, strict=True):
            if n != m:
                raise SlamlibError(
                    f"left picture {name} and right picture {partner} come together by their order, and their numbers "
                    "differ: pictures are missing, or the two were not taken together"
                )
    rows = np.arange(len(one))
    return rows, rows


def _counted(names: tuple[str, ...]) -> list[tuple[int, ...]]:
    """Columns of the numbers in names that change from name to name; none where the names are not alike."""
    numbers = [tuple(map(int, re.findall(r"\d+", name))) for name in names]
    if len({len(row) for row in numbers}) != 1:
        return []
    return [column for column in zip(*numbers, strict=True) if len(set(column)) > 1]
