"""Pairs and the cameras that made them, together: checked against each other, rectified if wanted, opened again."""

from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.setup import tuples
from slamlib.datasets.lens import Lens, fitted
from slamlib.datasets.pair_calibrations import PairCalibration, read_pair
from slamlib.datasets.pair_sources import CAMERAS, pairs_at, reopen_pairs, two_cameras
from slamlib.datasets.rectification import Rectification, check_order, rectified_setup, why_not_rectified
from slamlib.datasets.sources import Source
from slamlib.errors import SlamlibError
from slamlib.vision.stereo.pair_checks import check_pair
from slamlib.vision.stereo.settings import StereoSettings

# By layout: files of the calibration in a data set's folder, for camera {n}; and whether its pictures are raw.
KEPT = {
    "KITTI": ("calib.txt", "calibration.json"),
    "EuRoC": ("mav0/cam{n}/sensor.yaml", "cam{n}/sensor.yaml"),
}
RAW = ("EuRoC",)


def opened_pairs(
    source: str | None = None,
    left: str | None = None,
    right: str | None = None,
    calibration: list[str] | None = None,
    *,
    cameras: tuple[int, int] | None = None,
    fps: float | None = None,
    rectify: bool = False,
    settings: StereoSettings | None = None,
) -> tuple[Source, dict[str, Any], StereoSettings]:
    """The pairs, plain data of the stereo SensorSetup that they fit, and the settings with the calibration's offset.

    The first pair is read: its size, its rows and the sign of its disparities are checked. Raises SlamlibError.
    """
    pairs = pairs_at(source, left, right, fps, cameras)
    numbers = cameras or (two_cameras(source) if source else CAMERAS[0])
    known = read_pair(calibration or _kept(source, pairs.layout, numbers), numbers)
    check_order(known)
    first = next(iter(pairs))
    size = first.image.shape[2], first.image.shape[1]
    for lens in (known.left, known.right):
        sized = {} if lens.image is None else {"image": lens.image}
        fitted({**sized, "parameters": {"intrinsics": lens.intrinsics}}, size, pairs.where)
    if rectify or (pairs.layout in RAW and why_not_rectified(known)):
        pairs, setup = rectified(pairs, known, size)
        first, offset = next(iter(pairs)), 0.0
    else:
        _check_rectified(known)
        setup, offset = rectified_setup(known, size)
    chosen = settings or StereoSettings()
    chosen = replace(chosen, offset=chosen.offset or offset)
    check_pair(first.image, first.name, chosen)
    return pairs, setup, chosen


def _kept(source: str | None, layout: str, cameras: tuple[int, int]) -> list[str]:
    """The calibration in a data set's folder, one file or one for each camera."""
    for name in KEPT.get(layout, ()) if source else ():
        paths = [str(Path(str(source)) / name.format(n=n)) for n in cameras]
        if all(Path(path).is_file() for path in paths):
            return sorted(set(paths))
    raise SlamlibError(
        "--calibration is wanted: a file of the rectified pair (KITTI's calib.txt, slamlib's JSON), or of both lenses "
        f"with their places{f'; {source} holds none that is known' if source else ''}"
    )


def _check_rectified(known: PairCalibration) -> None:
    why = why_not_rectified(known)
    if why is not None:
        raise SlamlibError(
            f"the calibration is not that of a rectified pair: {why}. If the pictures are as the lenses made them, "
            "rectify them with --rectify; if they are rectified, give the calibration of the rectified pair"
        )


def rectified(pairs: Source, known: PairCalibration, size: tuple[int, int]) -> tuple[Source, dict[str, Any]]:
    """The pairs, rectified, and plain data of the SensorSetup that would have made them."""
    change = Rectification(known, size)
    lenses = [asdict(lens) for lens in (known.left, known.right)]
    recipe = {**pairs.recipe, "rectify": {"lenses": lenses, "place": known.place.tolist(), "size": list(size)}}
    return pairs.through(change, recipe), change.setup


def reopened_pairs(recipe: dict[str, Any], count: int | None = None) -> Source:
    """The source of a recipe, rectified as it was, with `count` pairs if that is given. Raises SlamlibError."""
    pairs = reopen_pairs(recipe)
    if "rectify" in recipe:
        plain = tuples(recipe["rectify"])
        left, right = (Lens(**lens) for lens in plain["lenses"])
        pairs, _ = rectified(pairs, PairCalibration(left, right, np.array(plain["place"])), plain["size"])
    return pairs.again(recipe, count)
