"""EuRoC: Burri and others (2016). camN/data.csv lists times [ns] and files, beside the folder camN/data.

Calibrations: a sensor.yaml for each camera, with its pose T_BS in the body's frame.
"""

from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras, Dataset, ImageSource, counted, listed_files
from slamlib.datasets.formats.kalibr import lens
from slamlib.datasets.lens import Lens, rigid
from slamlib.datasets.pictures import images_in
from slamlib.plain_data.entries import Entries, alike, named_values

UNUSED = (*METADATA, "exposure*")
# What tells such a file from another one with intrinsics.
_BESIDE = {"cameramodel", "distortionmodel", "distortioncoefficients", "distortioncoeffs", "resolution", "tbs"}


def _cameras(where: Path) -> dict[int, Path]:
    places = {n: [where / "mav0" / f"cam{n}", where / f"cam{n}"] for n in range(4)}
    places[0].append(where)
    there = {n: [p / "data.csv" for p in folders if (p / "data").is_dir()] for n, folders in places.items()}
    return {n: one for n, some in there.items() for one in some[:1] if one.is_file() or _is_camera(one.parent, n)}


def _is_camera(folder: Path, number: int) -> bool:
    """Whether a folder holds a camera's pictures without their list: their names are their times."""
    return folder.name == f"cam{number}" and bool(images_in(folder / "data"))


def _open(listing: Path, fps: float | None) -> ImageSource:
    folder = listing.parent / "data"
    return listed_files(listing, folder, "nanoseconds") if listing.is_file() else counted(images_in(folder), fps)


def _fits(text: str) -> bool:
    names = set(map(alike, named_values(text)))
    return "intrinsics" in names and bool(_BESIDE & names)


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, Entries(named_values(text)))}


def _lens(entries: Entries) -> Lens:
    pose = entries.numbers("T_BS", count=16, needed=False)
    found = lens(entries, rigid(pose, "T_BS") if pose else None)
    entries.close(UNUSED)
    return found


EUROC = Dataset(
    "EuRoC", _cameras, _open, calibrations=("mav0/cam{camera}/sensor.yaml", "cam{camera}/sensor.yaml"), raw=True
)
CALIBRATION = CalibrationReader("EuRoC", _fits, _read)
