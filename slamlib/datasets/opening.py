"""Sequences and their cameras together: checked against each other, undistorted or rectified, opened again."""

from pathlib import Path
from typing import Any

from slamlib.data.plain import read, written
from slamlib.datasets.calibrations import read_calibration, read_lens, read_pair
from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.formats import DATASETS
from slamlib.datasets.lens import Lens, PairCalibration, fitted
from slamlib.datasets.pairs import CAMERAS, open_pairs, two_cameras
from slamlib.datasets.rectification import Rectification, Undistortion, rectified_setup, why_not_rectified
from slamlib.datasets.sources import open_source
from slamlib.errors import SlamlibError


def open_sequence(
    source: str, calibration: str, *, camera: int = 0, fps: float | None = None, undistort: bool = False
) -> tuple[ImageSource, dict[str, Any]]:
    """The pictures, and plain data of the SensorSetup that they fit; the first picture is read to know their size.

    undistort: free the pictures of the lens's distortion. Raises SlamlibError.
    """
    pictures = open_source(source, fps=fps, camera=camera)
    size = size_of(pictures)
    if not undistort:
        return pictures, fitted(read_calibration(calibration, camera), size, pictures.where)
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
    rectify: bool = False,
) -> tuple[ImageSource, dict[str, Any], float]:
    """Rectified pairs, plain data of the stereo SensorSetup that they fit, and the offset [px] of their disparities.

    Of a data set's folder, or of a left and a right folder, glob or video. Raises SlamlibError.
    """
    numbers = cameras or (two_cameras(source) if source else CAMERAS[0])
    if source is not None:
        pairs = open_pairs(*(open_source(source, fps=fps, camera=camera) for camera in numbers))
    elif left is not None and right is not None:
        pairs = open_pairs(open_source(left, fps=fps), open_source(right, fps=fps))
    else:
        raise SlamlibError("--left and --right are wanted, both, or --source for a KITTI or EuRoC folder")
    known = read_pair(calibration or _find_calibration(source, pairs.layout, numbers), numbers)
    if not known.transform[0, 3] > 0:
        raise SlamlibError(
            f"the right camera is {known.transform[0, 3]:.3g} m to the right of the left one, by the calibration: left "
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
            f"the calibration is not that of a rectified pair: {why}. If the pictures are as the lenses made them, "
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
    """Pictures without their distortion, or rectified pairs, and plain data of the SensorSetup that they fit."""
    change = Undistortion(known, size) if isinstance(known, Lens) else Rectification(known, size)
    return source.through(change, {**source.recipe, "remap": written(known), "size": list(size)}), change.setup


def reopen(recipe: dict[str, Any], count: int | None = None) -> ImageSource:
    """The source of a recipe, of pictures or of pairs, changed as it was; count: how many, if not as many as before.

    Raises SlamlibError if it is not there any more, or has become shorter.
    """
    if "left" in recipe:
        source = open_pairs(reopen(recipe["left"]), reopen(recipe["right"]))
    else:
        source = open_source(recipe["text"], fps=recipe["fps"], camera=recipe["camera"])
    if "remap" in recipe:
        kind: type[Lens | PairCalibration] = PairCalibration if "left" in recipe else Lens
        source, _ = remapped(source, read(kind, recipe["remap"]), tuple(recipe["size"]))
    return source.again(recipe, count)


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
        f"with their places{f'; {source} holds none that is known' if source else ''}"
    )
