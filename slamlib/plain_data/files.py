"""Files: texts in whatever encoding they come, atomic writes, and archives of arrays with a header of plain data."""

import codecs
import errno
import glob
import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError

# The marks that Windows editors, and PowerShell's >, put before a text.
_MARKS = {codecs.BOM_UTF8: "utf-8", codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be"}


def read_text(path: str | Path) -> str:
    """The text of a file: UTF-8, or what its byte order mark says; line ends become newlines.

    A comment may hold bytes of another encoding: they become replacement characters. Raises SlamlibError for a file
    that cannot be read, and for one of binary data.
    """
    try:
        data = Path(path).expanduser().read_bytes()
    except (OSError, ValueError, RuntimeError) as error:
        why = (error.strerror if isinstance(error, OSError) else None) or error
        raise SlamlibError(f"{path} cannot be read: {why}") from None
    mark = next((mark for mark in _MARKS if data.startswith(mark)), b"")
    text = data[len(mark) :].decode(_MARKS.get(mark, "utf-8"), errors="replace")
    if "\0" in text:
        raise SlamlibError(f"{path} is no text: it holds binary data (or is it UTF-16 without a byte order mark?)")
    return text.replace("\r\n", "\n").replace("\r", "\n")


@contextmanager
def atomic_write(path: str | Path) -> Iterator[Path]:
    """A temporary path beside `path`, with its suffix; it becomes `path` only if the block ends without an error.

    A folder replaces an older one. What a process that was killed left of it is removed. Raises SlamlibError, which
    names the path, where the block or the file system fails with an OSError.
    """
    target = Path(path)
    partial = target.with_name(f".{target.stem}.{os.getpid()}.partial{target.suffix}")
    try:
        for left in target.parent.glob(f".{glob.escape(target.stem)}.*.partial{glob.escape(target.suffix)}"):
            if not _is_alive(left.name.removesuffix(target.suffix).split(".")[-2]):
                _remove(left)
        yield partial
        if partial.is_dir() and target.is_dir():
            shutil.rmtree(target)
        os.replace(partial, target)
    except OSError as error:
        raise SlamlibError(f"{path} cannot be written: {error.strerror or error}") from error
    except ValueError as error:  # a ZIP file that is stopped within an entry says that it cannot be closed
        raise (error.__context__ if isinstance(error.__context__, KeyboardInterrupt) else error) from None
    finally:
        _remove(partial)


def _remove(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)


def _is_alive(process: str) -> bool:
    """Whether a process of this number runs, or may run: Windows cannot be asked in this way."""
    try:
        if os.name == "posix":
            os.kill(int(process), 0)
    except ProcessLookupError:
        return False
    except (OSError, ValueError):
        return True
    return True


def check_writable(path: str | Path) -> None:
    """Make the folder of a file that will be written after long work. Raises SlamlibError if it cannot be written."""
    target = Path(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, "it is a folder")
        with tempfile.TemporaryFile(dir=target.parent):
            pass
    except OSError as error:
        raise SlamlibError(f"{path} cannot be written: {error.strerror or error}") from None


def write_whole(path: str | Path, content: bytes | str) -> None:
    """Write bytes, or a text in UTF-8 with its line ends as they are, atomically."""
    with atomic_write(path) as partial:
        partial.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))


def write_archive(path: str | Path, form: str, version: int, header: dict[str, Any], arrays: dict[str, Any]) -> None:
    """Write a compressed .npz of arrays; `header` is the text of a JSON object, with form and version.

    `digest` is a checksum of all the others: a file in which something was changed is not read.
    """
    text = json.dumps({"format": form, "version": version, **header}, default=lambda value: value.tolist())
    content = {"header": np.array(text), **arrays}
    with atomic_write(path) as partial, partial.open("wb") as file:
        np.savez_compressed(file, digest=np.array(_digest(content)), **content)


def _digest(arrays: dict[str, Any]) -> str:
    """A checksum of arrays: of their names, types, shapes and numbers."""
    found = hashlib.sha256()
    for name, array in sorted(arrays.items()):
        values = np.ascontiguousarray(array)
        found.update(f"{name} {values.dtype.str} {np.shape(array)}".encode() + values.tobytes())
    return found.hexdigest()


def read_archive(
    path: str | Path, form: str, version: int, old: str = "install a newer one", *, foreign: bool = False
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the header and the arrays of an archive; nothing in it is executed.

    Raises SlamlibError for a file that is missing, damaged, changed, of another form, or of another version; old: the
    advice. foreign: whether the checksum may be missing, in files that other programs write.
    """
    try:
        with Path(path).open("rb") as file, np.load(file, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
    except FileNotFoundError:
        raise SlamlibError(f"{path}: there is no such file") from None
    except Exception as error:  # a damaged archive fails in more ways than its modules document
        raise SlamlibError(f"{path} cannot be read: it is damaged, or no {form} at all") from error
    digest = arrays.pop("digest", None)
    is_whole = foreign if digest is None else str(digest) == _digest(arrays)
    try:
        header = dict(json.loads(str(arrays.pop("header"))))
    except (KeyError, ValueError, TypeError):
        header = {}
    if header.get("format") != form:
        raise SlamlibError(f"{path} is no {form}: it has no header that says {form!r}")
    if header.get("version") != version:
        raise SlamlibError(f"{path} has version {header.get('version')!r}, and this slamlib reads {version}: {old}")
    if not is_whole:
        raise SlamlibError(f"{path} has been changed since it was written: its checksum differs; take another copy")
    return header, arrays


def check_columns(rows: list[list[float]], columns: Sequence[str]) -> None:
    """Raise ValueError, within `complete`, unless each row of a saved history has these columns."""
    if any(len(row) != len(columns) for row in rows):
        raise ValueError("its frames have other columns than those of this version")


@contextmanager
def complete(path: str | Path) -> Iterator[None]:
    """Within the block an archive's header and arrays are used: what is missing or wrong raises SlamlibError."""
    try:
        yield
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise SlamlibError(f"{path} is incomplete, or has been changed: {type(error).__name__} {error}") from error
