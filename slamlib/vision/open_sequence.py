"""Pictures and the camera that made them, together: checked against each other, undistorted if wanted, opened again."""

from dataclasses import asdict
from typing import Any

from slamlib.data.setup import tuples
from slamlib.datasets.calibrations import read_calibration, read_lens
from slamlib.datasets.lens import Lens, Undistortion, fitted
from slamlib.datasets.sources import Source, open_source, reopen


def opened(
    source: str, calibration: str, *, camera: int = 0, fps: float | None = None, undistort: bool = False
) -> tuple[Source, dict[str, Any]]:
    """The pictures, and plain data of the SensorSetup that they fit; the first picture is read to know their size.

    undistort: free the pictures of the lens's distortion. Raises SlamlibError.
    """
    pictures = open_source(source, fps=fps, camera=camera)
    size = size_of(pictures)
    if not undistort:
        return pictures, fitted(read_calibration(calibration, camera), size, pictures.where)
    lens = read_lens(calibration, camera)
    known = {} if lens.image is None else {"image": lens.image}
    fitted({**known, "parameters": {"intrinsics": lens.intrinsics}}, size, pictures.where)
    return undistorted(pictures, lens, size)


def size_of(pictures: Source) -> tuple[int, int]:
    """(width, height) of the first picture."""
    height, width = next(iter(pictures)).image.shape
    return width, height


def undistorted(pictures: Source, lens: Lens, size: tuple[int, int]) -> tuple[Source, dict[str, Any]]:
    """The pictures without their distortion, and plain data of the pin-hole that would have made them."""
    change = Undistortion(lens, size)
    recipe = {**pictures.recipe, "undistort": {"lens": asdict(lens), "size": list(size)}}
    return pictures.through(change, recipe), change.setup


def reopened(recipe: dict[str, Any], count: int | None = None) -> Source:
    """The source of a recipe, undistorted as it was, with `count` pictures if that is given. Raises SlamlibError."""
    pictures = reopen(recipe, count)
    if "undistort" not in recipe:
        return pictures
    plain = tuples(recipe["undistort"])
    return undistorted(pictures, Lens(**plain["lens"]), plain["size"])[0]
