"""Pictures and the cameras that made them, together: checked against each other, made ideal if wanted, opened again.

Ideal are pictures of a pin-hole without distortion, and pairs of which rows correspond.
"""

from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.setup import tuples
from slamlib.datasets.calibrations import read_calibration, read_lens
from slamlib.datasets.lens import Lens, Undistortion, fitted
from slamlib.datasets.pair_calibrations import PairCalibration, read_pair
from slamlib.datasets.pair_sources import CAMERAS, pairs_at, reopen_pairs, two_cameras
from slamlib.datasets.rectification import Rectification, check_order, rectified_setup, why_not_rectified
from slamlib.datasets.sources import Source, open_source, reopen
from slamlib.errors import SlamlibError
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.matching import check_pair

# By layout: files of the calibration in a data set's folder, for camera {n}; and whether its pictures are raw.
KEPT = {
    "KITTI": ("calib.txt", "calibration.json"),
    "EuRoC": ("mav0/cam{n}/sensor.yaml", "cam{n}/sensor.yaml"),
}
RAW = ("EuRoC",)
Opened = tuple[Source, dict[str, Any]]  # the pictures, and plain data of the SensorSetup that they fit


def open_images(
    source: str, calibration: str, *, camera: int = 0, fps: float | None = None, undistort: bool = False
) -> Opened:
    """The pictures of one camera; the first of them is read, to know their size.

    undistort: free the pictures of the lens's distortion. Raises SlamlibError.
    """
    pictures = open_source(source, fps=fps, camera=camera)
    size = _size(pictures)
    if not undistort:
        return pictures, fitted(read_calibration(calibration, camera), size, pictures.where)
    lens = read_lens(calibration, camera)
    _check_size(lens, size, pictures.where)
    return _undistorted(pictures, lens, size)


def open_stereo(
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
    """The pairs of two cameras, also as in Opened, and the settings with the calibration's offset of disparities.

    The first pair is read: its size, its rows and the sign of its disparities are checked. Raises SlamlibError.
    """
    pairs = pairs_at(source, left, right, fps, cameras)
    numbers = cameras or (two_cameras(source) if source else CAMERAS[0])
    known = read_pair(calibration or _kept(source, pairs.layout, numbers), numbers)
    check_order(known)
    size, offset, why = _size(pairs), 0.0, why_not_rectified(known)
    for lens in (known.left, known.right):
        _check_size(lens, size, pairs.where)
    if rectify or (pairs.layout in RAW and why):
        pairs, setup = _rectified(pairs, known, size)
    elif why is not None:
        raise SlamlibError(
            f"the calibration is not that of a rectified pair: {why}. If the pictures are as the lenses made them, "
            "rectify them with --rectify; if they are rectified, give the calibration of the rectified pair"
        )
    else:
        setup, offset = rectified_setup(known, size)
    chosen = settings or StereoSettings()
    chosen = replace(chosen, offset=chosen.offset or offset)
    first = next(iter(pairs))
    check_pair(first.image, first.name, chosen)
    return pairs, setup, chosen


def reopened(recipe: dict[str, Any], count: int | None = None) -> Source:
    """The source of a recipe, made ideal as it was, with `count` pictures if that is given. Raises SlamlibError."""
    if "left" not in recipe:
        pictures = reopen(recipe, count)
        if "undistort" not in recipe:
            return pictures
        plain = tuples(recipe["undistort"])
        return _undistorted(pictures, Lens(**plain["lens"]), plain["size"])[0]
    pairs = reopen_pairs(recipe)
    if "rectify" in recipe:
        plain = tuples(recipe["rectify"])
        left, right = (Lens(**lens) for lens in plain["lenses"])
        pairs, _ = _rectified(pairs, PairCalibration(left, right, np.array(plain["place"])), plain["size"])
    return pairs.again(recipe, count)


def _size(pictures: Source) -> tuple[int, int]:
    """(width, height) of the first picture."""
    *_, height, width = next(iter(pictures)).image.shape
    return width, height


def _check_size(lens: Lens, size: tuple[int, int], where: str) -> None:
    known = {} if lens.image is None else {"image": lens.image}
    fitted({**known, "parameters": {"intrinsics": lens.intrinsics}}, size, where)


def _undistorted(pictures: Source, lens: Lens, size: tuple[int, int]) -> Opened:
    """The pictures without their distortion, and the pin-hole that would have made them."""
    change = Undistortion(lens, size)
    recipe = {**pictures.recipe, "undistort": {"lens": asdict(lens), "size": list(size)}}
    return pictures.through(change, recipe), change.setup


def _rectified(pairs: Source, known: PairCalibration, size: tuple[int, int]) -> Opened:
    """The pairs, rectified, and the sensor that would have made them."""
    change = Rectification(known, size)
    lenses = [asdict(lens) for lens in (known.left, known.right)]
    recipe = {**pairs.recipe, "rectify": {"lenses": lenses, "place": known.place.tolist(), "size": list(size)}}
    return pairs.through(change, recipe), change.setup


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
