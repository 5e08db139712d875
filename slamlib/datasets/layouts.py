"""Sequences of image files: folders, globs, and the layouts of three public data sets.

TUM RGB-D: Sturm, Engelhard, Endres, Burgard and Cremers (2012). EuRoC: Burri and others (2016), times in nanoseconds.
KITTI odometry: Geiger, Lenz and Urtasun (2012), rectified pictures, ten a second.
"""

import glob
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from slamlib.datasets.pictures import Picture, in_natural_order, is_image, read_image
from slamlib.errors import SlamlibError

FPS, KITTI_FPS = 30.0, 10.0
Entries = list[tuple[Path, float]]
Numbers = range | list[int]


@dataclass(frozen=True)
class Sequence:
    """Names and times [s] of all pictures, `interval` [s] between two of them as a rule.

    read(numbers, ascending) yields some of them. told: whether a list says the times, so that they tell which pictures
    of two cameras belong together; otherwise they are counted.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    interval: float
    read: Callable[[Numbers], Iterator[Picture]]
    told: bool = False


def is_folder(where: str) -> bool:
    """Whether it is a folder with an image in it."""
    return Path(where).is_dir() and any(map(is_image, Path(where).iterdir()))


def folder(where: str, fps: float | None, camera: int) -> Sequence:
    """All images of a folder, `fps` a second."""
    return _timed(in_natural_order([p for p in Path(where).iterdir() if is_image(p)]), fps or FPS)


def is_glob(where: str) -> bool:
    """Whether an image has that name, or matches it."""
    return bool(_matches(where))


def matching(where: str, fps: float | None, camera: int) -> Sequence:
    """All images that match, `fps` a second."""
    return _timed(_matches(where), fps or FPS)


def is_tum(where: str) -> bool:
    """Whether rgb.txt is there."""
    return (Path(where) / "rgb.txt").is_file()


def tum(where: str, fps: float | None, camera: int) -> Sequence:
    """Rows of "time file" in rgb.txt."""
    root = Path(where)
    rows = table(root / "rgb.txt", 2, None)
    return _listed([(root / name, _seconds(time, root / "rgb.txt")) for time, name in rows], root / "rgb.txt")


def is_euroc(where: str) -> bool:
    """Whether the data.csv of a camera is there."""
    return bool(euroc_cameras(where))


def euroc(where: str, fps: float | None, camera: int) -> Sequence:
    """Rows of "time in nanoseconds, file" in data.csv; files are in the folder data beside it."""
    cameras = euroc_cameras(where)
    if camera not in cameras:
        raise SlamlibError(f"{where} has no camera {camera}; it has {', '.join(map(str, cameras))}")
    listing = cameras[camera]
    rows = table(listing, 2, ",")
    return _listed([(listing.parent / "data" / name, 1e-9 * _seconds(time, listing)) for time, name in rows], listing)


def euroc_cameras(where: str) -> dict[int, Path]:
    """The lists of the cameras that are there, by number."""
    root = Path(where)
    places = {n: [root / "mav0" / f"cam{n}", root / f"cam{n}"] for n in range(4)}
    places[0].append(root)
    there = {n: [p / "data.csv" for p in folders if (p / "data").is_dir()] for n, folders in places.items()}
    return {n: listing for n, some in there.items() for listing in some[:1] if listing.is_file()}


def is_kitti(where: str) -> bool:
    """Whether the folder of a camera is there."""
    return bool(kitti_cameras(where))


def kitti(where: str, fps: float | None, camera: int) -> Sequence:
    """The images of image_N, with the times of times.txt, if it is there."""
    cameras = kitti_cameras(where)
    if camera not in cameras:
        raise SlamlibError(f"{where} has no image_{camera}; its cameras are {', '.join(map(str, cameras))}")
    paths = in_natural_order([p for p in cameras[camera].iterdir() if is_image(p)])
    listing = Path(where) / "times.txt"
    if not listing.is_file():
        return _timed(paths, fps or KITTI_FPS)
    times = [_seconds(row[0], listing) for row in table(listing, 1, None)]
    if len(times) != len(paths):
        raise SlamlibError(f"{listing} has {len(times)} times for {len(paths)} pictures in {cameras[camera]}")
    return _listed(list(zip(paths, times, strict=True)), listing)


def kitti_cameras(where: str) -> dict[int, Path]:
    """The folders of the cameras that are there, by number."""
    places = {n: Path(where) / f"image_{n}" for n in range(4)}
    return {n: place for n, place in places.items() if place.is_dir() and any(map(is_image, place.iterdir()))}


def _matches(where: str) -> list[Path]:
    path = Path(where)
    found = [path] if path.exists() else [Path(name) for name in glob.glob(where, recursive=True)]
    return in_natural_order([p for p in found if is_image(p)])


def table(path: Path, columns: int, separator: str | None) -> list[list[str]]:
    """Words of the rows of a list; those that begin with # are comments. Raises SlamlibError, naming the line."""
    rows = []
    for number, line in enumerate(path.read_text("utf-8", errors="replace").splitlines(), 1):
        words = [word.strip() for word in line.split(separator)]
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        if len(words) < columns:
            raise SlamlibError(f"{path}, line {number}: {columns} columns are wanted, got {line!r}")
        rows.append(words[:columns])
    if not rows:
        raise SlamlibError(f"{path} lists no picture")
    return rows


def _seconds(text: str, path: Path) -> float:
    try:
        return float(text)
    except ValueError:
        raise SlamlibError(f"{path}: {text!r} is no time") from None


def _timed(paths: list[Path], fps: float) -> Sequence:
    return _listed([(path, number / fps) for number, path in enumerate(paths)], Path("."), 1 / fps)


def _listed(entries: Entries, listing: Path, interval: float | None = None) -> Sequence:
    times = np.array([time for _, time in entries])
    wrong = np.flatnonzero(~(np.diff(times) > 0))
    if len(wrong):
        one, two = entries[wrong[0]], entries[wrong[0] + 1]
        raise SlamlibError(
            f"{listing}: times must grow, but {one[0].name} is of {one[1]} s and {two[0].name} of {two[1]} s "
            f"({len(wrong)} such places): sort the rows, and leave out what is there twice"
        )
    missing = [path for path, _ in entries if not path.is_file()]
    if missing:
        raise SlamlibError(f"{listing} lists {len(missing)} files that are not there, the first of them {missing[0]}")

    def read(numbers: Numbers) -> Iterator[Picture]:
        for number in numbers:
            path, time = entries[number]
            yield Picture(path.name, time, read_image(path))

    typical = float(np.median(np.diff(times))) if len(times) > 1 else 1 / FPS
    names = tuple(path.name for path, _ in entries)
    return Sequence(names, tuple(times.tolist()), interval or typical, read, interval is None)
