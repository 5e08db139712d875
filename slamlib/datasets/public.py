"""Public recordings, which public.toml lists, and where they are on this machine."""

import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from slamlib.errors import SlamlibError

VARIABLE = "SLAMLIB_DATA"


@dataclass(frozen=True)
class PublicRecording:
    """A public recording: what it is, where it is offered, how much is fetched ("" where unknown), its licence.

    places: folders below the one of all recordings, perhaps with wildcards, each with a file by which it is recognized;
    the first is the one to put it in.
    """

    what: str
    address: str
    size: str
    licence: str
    places: Mapping[str, str]

    def found(self, root: Path | None) -> list[Path]:
        """Its folders below `root`, in the order of their names; none without a root."""
        held = [
            (folder, file)
            for place, file in self.places.items()
            for folder in (sorted(root.glob(place)) if root else ())
        ]
        return [folder for folder, file in held if (folder / file).is_file()]


@cache
def public_recordings() -> dict[str, PublicRecording]:
    """All public recordings, by name."""
    rows = tomllib.loads(Path(__file__).with_suffix(".toml").read_text("utf-8"))
    return {name: PublicRecording(**row) for name, row in rows.items()}


def data_folder(given: str | None = None) -> Path | None:
    """The folder of all recordings: the one given, or that of SLAMLIB_DATA, or None. Raises SlamlibError."""
    text = given or os.environ.get(VARIABLE)
    if text and not Path(text).is_dir():
        raise SlamlibError(f"{text} is no folder: give one that exists, or set {VARIABLE} to it")
    return Path(text) if text else None
