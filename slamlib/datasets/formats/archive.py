"""Images in a ZIP archive, PATH.zip, or in a folder of it, PATH.zip/left; they are read where they are."""

import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from slamlib.datasets.dataset import Dataset, ImageSource, Numbers, encoded
from slamlib.datasets.pictures import in_natural_order, is_image_name
from slamlib.datasets.times import of_names
from slamlib.errors import SlamlibError


def _cameras(where: Path) -> dict[int, Path]:
    return {0: where} if _archive(where) else {}


def _archive(where: Path) -> Path | None:
    """The archive that a path is, or leads into."""
    return next((path for path in (where, *where.parents) if path.suffix.lower() == ".zip" and path.is_file()), None)


def _open(where: Path, fps: float | None) -> ImageSource:
    archive = _archive(where)
    assert archive is not None
    try:
        with zipfile.ZipFile(archive) as file:
            inside = [PurePosixPath(name) for name in file.namelist()]
    except (OSError, zipfile.BadZipFile) as error:
        raise SlamlibError(f"{archive} is no ZIP archive, or damaged: {error}") from None
    folder = PurePosixPath(where.relative_to(archive).as_posix())
    images = [
        path for path in inside if path.is_relative_to(folder) and is_image_name(path) and "__MACOSX" not in path.parts
    ]
    if not images:
        raise SlamlibError(f"{where}: there is no image in this archive, or in this folder of it")
    folders = sorted({str(path.parent) for path in images})
    if len(folders) > 1:
        raise SlamlibError(
            f"{where} holds images in {len(folders)} folders ({', '.join(folders[:4])}): name one, as in "
            f"{archive}/{folders[0]}"
        )
    images = in_natural_order(images)
    order, times = of_names([path.name for path in images], fps)
    names = [str(images[i]) for i in order]

    def files(numbers: Numbers) -> Iterator[bytes]:
        with zipfile.ZipFile(archive) as file:
            for number in numbers:
                try:
                    yield file.read(names[number])
                # a password, a method of compression that is not known, a wrong checksum, a damaged stream
                except (OSError, RuntimeError, zipfile.BadZipFile, zlib.error, EOFError) as error:
                    raise SlamlibError(f"{archive}/{names[number]} cannot be read: {error}") from None

    return encoded([f"{archive}/{name}" for name in names], times, files)


ZIP = Dataset("ZIP archive", _cameras, _open)
