"""A list of images: PATH.txt or .csv, one file a row, or its time and the file; relative to the list's folder."""

from pathlib import Path

from slamlib.datasets.dataset import Dataset, ImageSource, counted, listed_files
from slamlib.errors import SlamlibError
from slamlib.plain_data.files import read_text

ENDINGS = (".txt", ".csv", ".lst")


def _cameras(where: Path) -> dict[int, Path]:
    return {0: where} if where.suffix.lower() in ENDINGS and where.is_file() else {}


def _open(listing: Path, fps: float | None) -> ImageSource:
    lines = [line.strip() for line in read_text(listing).splitlines()]
    paths = [listing.parent / Path(line).expanduser() for line in lines if line and not line.startswith("#")]
    if not any(path.is_file() for path in paths):
        return listed_files(listing, listing.parent)
    missing = [path for path in paths if not path.is_file()]
    if missing:
        raise SlamlibError(f"{listing} lists {len(missing)} files that are not there, the first of them {missing[0]}")
    return counted(paths, fps)


LISTING = Dataset("list", _cameras, _open)
