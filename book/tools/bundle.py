"""Pack the built site into one ZIP that can be read, and run, without a network."""

import zipfile
from pathlib import Path

from book.tools import layout
from slamlib.data.files import atomic_write

NAME = "ekf-slam-book.zip"
FOLDER = "ekf-slam-book"
FIRST_DATE = (1980, 1, 1, 0, 0, 0)
PACKED = {".zip", ".whl", ".bin", ".woff", ".woff2", ".png"}  # what does not become smaller


def pack(site: Path) -> Path:
    """Write the ZIP into the site itself, whole or not at all; the same bytes for the same site."""
    target = site / NAME
    with atomic_write(target) as partial, zipfile.ZipFile(partial, "w") as archive:
        for file in sorted(f for f in site.rglob("*") if f.is_file() and f not in (target, partial)):
            _add(archive, file, file.relative_to(site).as_posix())
        for file in sorted((layout.BOOK / "offline").iterdir()):
            _add(archive, file, file.name)
    return target


def _add(archive: zipfile.ZipFile, file: Path, name: str) -> None:
    entry = zipfile.ZipInfo(f"{FOLDER}/{name}", FIRST_DATE)
    entry.external_attr = 0o644 << 16
    method = zipfile.ZIP_STORED if file.suffix in PACKED else zipfile.ZIP_DEFLATED
    archive.writestr(entry, file.read_bytes(), method)
