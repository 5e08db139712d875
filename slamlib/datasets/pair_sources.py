"""Pairs of pictures: of two cameras of one data set, or of two folders, globs or videos; matched, and checked.

Pictures belong together by their times where a list tells them (EuRoC: one that the other camera lacks is left out),
and otherwise by their order, which the numbers in their names must agree with. A pair is a Picture whose image is
(2, h, w): a Source of pairs is one as of pictures, with parts, changes, and a recipe to open it again.
"""

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.datasets.layouts import Numbers, Sequence
from slamlib.datasets.pairs import pair
from slamlib.datasets.pictures import Picture
from slamlib.datasets.sources import Source, cameras_at, open_source
from slamlib.errors import SlamlibError

CAMERAS = ((0, 1), (2, 3))  # left and right; KITTI's 2 and 3 are the coloured ones
TOGETHER = 0.1  # of the interval: times of one pair may differ by so much


def two_cameras(where: str | os.PathLike[str]) -> tuple[int, int]:
    """The numbers of the left and the right camera in a data set's folder. Raises SlamlibError where there are none."""
    there = cameras_at(where)
    found = next((two for two in CAMERAS if set(two) <= set(there)), None)
    if found is None:
        have = f"it has camera {', '.join(map(str, there))}" if there else "it is no KITTI or EuRoC folder"
        raise SlamlibError(
            f"{where} has no pair of cameras, 0 and 1 or 2 and 3 ({have}): name the pictures with --left and --right"
        )
    return found


def open_pairs(left: Source, right: Source) -> Source:
    """The pairs of two cameras; no picture is read yet. Raises SlamlibError for lists that do not fit together."""
    i, j = _by_time(left, right) if left.whole.told and right.whole.told else _by_order(left, right)
    whole = left.whole
    names, times = (tuple(np.array(values)[i].tolist()) for values in (whole.names, whole.times))

    def read(numbers: Numbers) -> Iterator[Picture]:
        rows = np.array(numbers, dtype=int)
        both = zip(whole.read(i[rows].tolist()), right.whole.read(j[rows].tolist()), strict=True)
        return (_together(one, other) for one, other in both)

    sequence = Sequence(names, times, whole.interval, read, whole.told)
    recipe = {"left": left.recipe, "right": right.recipe}
    return Source(left.layout, _where(left, right), range(len(i)), sequence, recipe)


def pairs_at(
    source: str | None, left: str | None, right: str | None, fps: float | None, cameras: tuple[int, int] | None
) -> Source:
    """The pairs of a data set's folder, or of a left and a right folder, glob or video. Raises SlamlibError."""
    if source is not None:
        numbers = cameras or two_cameras(source)
        return open_pairs(*(open_source(source, fps=fps, camera=camera) for camera in numbers))
    if left is None or right is None:
        raise SlamlibError("--left and --right are wanted, both, or --source for a KITTI or EuRoC folder")
    return open_pairs(*(open_source(place, fps=fps) for place in (left, right)))


def reopen_pairs(recipe: dict[str, Any]) -> Source:
    """The whole source of pairs of a recipe. Raises SlamlibError if it is not there any more."""
    one, other = (open_source(r["text"], fps=r["fps"], camera=r["camera"]) for r in (recipe["left"], recipe["right"]))
    return open_pairs(one, other)


def _by_time(left: Source, right: Source) -> tuple[Any, Any]:
    """Rows of pictures of one time; what has no partner is left out."""
    one, other = np.array(left.whole.times), np.array(right.whole.times)
    after = np.searchsorted(other, one).clip(1, max(len(other) - 1, 1))
    near = np.stack([after - 1, after.clip(max=len(other) - 1)])
    gaps = np.abs(other[near] - one)
    j, gap = near[gaps.argmin(0), np.arange(len(one))], gaps.min(0)
    i = np.flatnonzero(gap <= TOGETHER * left.interval)
    if not len(i):
        raise SlamlibError(
            f"the times of the two cameras do not match: no left picture of {one[0]:.3f} to {one[-1]:.3f} s has a "
            f"right one ({other[0]:.3f} to {other[-1]:.3f} s) within {TOGETHER * left.interval:.3g} s"
        )
    return i, j[i]


def _by_order(left: Source, right: Source) -> tuple[Any, Any]:
    """All rows, if there are as many left as right, and the numbers that count in their names agree."""
    one, other = left.whole.names, right.whole.names
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


def _together(left: Picture, right: Picture) -> Picture:
    try:
        return replace(left, image=pair(left.image, right.image))
    except SlamlibError as error:
        raise SlamlibError(f"{left.name} and {right.name}: {error}") from None


def _where(left: Source, right: Source) -> str:
    return left.where if left.where == right.where else f"{left.where}, {right.where}"
