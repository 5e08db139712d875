"""Sequences with their cameras: checked for consistency, undistorted or rectified, reopened."""

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.calibrations import read_calibration, read_lens, read_pair
from slamlib.datasets.dataset import ImageSource, Numbers
from slamlib.datasets.formats import DATASETS
from slamlib.datasets.lens import Lens, PairCalibration, fitted
from slamlib.datasets.pictures import TimedImage, pair
from slamlib.datasets.rectification import rectification, rectified_setup, undistortion, why_not_rectified
from slamlib.datasets.sources import cameras_at, open_again, open_source
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import matched_times
from slamlib.manifolds import Indices
from slamlib.plain_data.fields import read, written
from slamlib.rigs.setup import SensorSetup

CAMERAS = ((0, 1), (2, 3))  # left and right; KITTI's 2 and 3 are the coloured ones
MAX_TIME_SHARE = 0.1  # of the interval: largest difference of the times of one pair


def open_sequence(
    source: str,
    calibration: str,
    *,
    camera: int = 0,
    fps: float | None = None,
    times: str | None = None,
    undistort: bool = False,
) -> tuple[ImageSource, dict[str, Any]]:
    """The images, and plain data of their SensorSetup; the first image is read for their size.

    fps, times: as of open_source. undistort: remove the lens distortion from the images. Raises SlamlibError.
    """
    pictures = open_source(source, fps=fps, camera=camera, times=times)
    size = size_of(pictures)
    if not undistort:
        setup = read_calibration(calibration, camera)
        try:
            _ = read(SensorSetup, setup, "camera").calibration  # all of it is there, before a part is used
        except SlamlibError as error:
            raise SlamlibError(f"{calibration}: {error}") from None
        return pictures, fitted(setup, size, pictures.where)
    lens = read_lens(calibration, camera)
    _check_size(lens, size, pictures)
    return remapped(pictures, lens, size)


def open_rectified_pairs(
    source: str | None = None,
    left: str | None = None,
    right: str | None = None,
    calibration: list[str] | None = None,
    *,
    cameras: tuple[int, int] | None = None,
    fps: float | None = None,
    times: str | None = None,
    rectify: bool = False,
) -> tuple[ImageSource, dict[str, Any], float]:
    """Rectified pairs, plain data of their stereo SensorSetup, and the offset [px] of their disparities.

    Of a data set's folder, or of a left and a right folder, glob or video. fps, times: as of open_source, for both.
    Raises SlamlibError.
    """
    rate: dict[str, Any] = {"fps": fps, "times": times}
    numbers = cameras or (two_cameras(source) if source else CAMERAS[0])
    if source is not None:
        pairs = open_pairs(*(open_source(source, camera=camera, **rate) for camera in numbers))
    elif left is not None and right is not None:
        pairs = open_pairs(open_source(left, **rate), open_source(right, **rate))
    else:
        raise SlamlibError("both --left and --right are needed, or --source for a KITTI or EuRoC folder")
    known = read_pair(calibration or _find_calibration(source, pairs.layout, numbers), numbers)
    x, *aside = known.transform[:3, 3]
    if max(map(abs, aside)) > abs(x):
        raise SlamlibError(
            f"the second camera is {x:.3g} m to the right of the first one, {aside[0]:.3g} m below it and "
            f"{aside[1]:.3g} m in front, by the calibration: the cameras of a pair stand side by side; choose two that "
            "do (--cameras)"
        )
    if not x > 0:
        raise SlamlibError(
            f"the right camera is {x:.3g} m to the right of the left one, by the calibration: left "
            "and right are exchanged; give --left and --right (or --cameras, or the two files) the other way round"
        )
    size = size_of(pairs)
    for lens in (known.left, known.right):
        _check_size(lens, size, pairs)
    why = why_not_rectified(known)
    if rectify or (why and DATASETS[pairs.layout].raw):
        return (*remapped(pairs, known, size), 0.0)
    if why:
        raise SlamlibError(
            f"the calibration is not that of a rectified pair: {why}. If the images are not rectified, "
            "rectify them with --rectify; if they are rectified, give the calibration of the rectified pair"
        )
    return (pairs, *rectified_setup(known, size))


def size_of(source: ImageSource) -> tuple[int, int]:
    """(width, height) of the first picture, or of both of the first pair."""
    *_, height, width = next(iter(source)).image.shape
    return width, height


def remapped(
    source: ImageSource, known: Lens | PairCalibration, size: tuple[int, int]
) -> tuple[ImageSource, dict[str, Any]]:
    """Images without distortion, or rectified pairs, and plain data of their SensorSetup."""
    change, setup = undistortion(known, size) if isinstance(known, Lens) else rectification(known, size)
    recipe = {**source.recipe, "remap": written(known), "size": list(size)}
    return source.through(change, recipe, change.original), setup


def reopen(recipe: dict[str, Any], count: int | None = None) -> ImageSource:
    """The source of a recipe, of images or of pairs, with the same changes; count: number of images, if not as before.

    Raises SlamlibError if it does not exist any more, or has become shorter.
    """
    source = open_pairs(reopen(recipe["left"]), reopen(recipe["right"])) if "left" in recipe else open_again(recipe)
    if "remap" in recipe:
        kind: type[Lens | PairCalibration] = PairCalibration if "left" in recipe else Lens
        source, _ = remapped(source, read(kind, recipe["remap"]), tuple(recipe["size"]))
    return source.again(recipe, count)


def moved(recipe: dict[str, Any], *places: str) -> dict[str, Any]:
    """The recipe of a source that is elsewhere now: its place, or, of pairs, those of the left and the right images."""
    if "left" not in recipe:
        return {**recipe, "text": os.path.abspath(os.path.expanduser(places[0]))}
    return {**recipe, "left": moved(recipe["left"], places[0]), "right": moved(recipe["right"], places[-1])}


def _check_size(lens: Lens, size: tuple[int, int], source: ImageSource) -> None:
    fitted({"image": lens.image, "parameters": {"intrinsics": lens.intrinsics}}, size, source.where)


def _find_calibration(source: str | None, layout: str, cameras: tuple[int, int]) -> list[str]:
    """The calibration in a data set's folder, one file or one for each camera."""
    for name in DATASETS[layout].calibrations if source else ():
        paths = [str(Path(str(source)) / name.format(camera=camera)) for camera in cameras]
        if all(Path(path).is_file() for path in paths):
            return sorted(set(paths))
    raise SlamlibError(
        "--calibration is wanted: a file of the rectified pair (KITTI's calib.txt, slamlib's JSON), or of both lenses "
        f"with their extrinsics{f'; {source} has none in a known format' if source else ''}"
    )


def two_cameras(where: str | Path) -> tuple[int, int]:
    """The numbers of the left and the right camera in a data set's folder. Raises SlamlibError if there are none."""
    there = cameras_at(where)
    found = next((two for two in CAMERAS if set(two) <= set(there)), None)
    if found is None:
        have = f"it has camera {', '.join(map(str, there))}" if there else "there is none"
        raise SlamlibError(
            f"{where} has no pair of cameras, 0 and 1 or 2 and 3 ({have}): name the pictures with --left and --right"
        )
    return found


def open_pairs(left: ImageSource, right: ImageSource) -> ImageSource:
    """The pairs of two cameras; no picture is read yet. Raises SlamlibError for lists that do not fit together.

    Images are paired by their times if a list gives them (EuRoC: one without a partner is left out), and otherwise by
    their order, which must agree with the numbers in their names.
    """
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
    recipe, notes = {"left": left.recipe, "right": right.recipe}, tuple(dict.fromkeys((*left.notes, *right.notes)))
    if (alone := len(left) - len(i)) or len(right) > len(i):
        notes += (f"{alone} left and {len(right) - len(i)} right pictures are left out: they have no partner in time",)
    return replace(
        left, names=names, times=times, read=read, frames=range(len(i)), where=where, recipe=recipe, notes=notes
    )


def _by_time(left: ImageSource, right: ImageSource) -> tuple[Indices, Indices]:
    """Rows of images with equal times; one without a partner is left out."""
    one, other, tolerance = np.array(left.times), np.array(right.times), MAX_TIME_SHARE * left.interval
    i, j = matched_times(one, other, tolerance)
    if not len(i):
        raise SlamlibError(
            f"the times of the two cameras do not match: no left picture of {one[0]:.3f} to {one[-1]:.3f} s has a "
            f"right one ({other[0]:.3f} to {other[-1]:.3f} s) within {tolerance:.3g} s"
        )
    return i, j


def _by_order(left: ImageSource, right: ImageSource) -> tuple[Indices, Indices]:
    """All rows, if there are as many left as right, and the counting numbers in their names agree."""
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
