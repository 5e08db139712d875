"""Runs in a file: what somebody else's filter needs to repeat one, in a layout that NumPy and JSON read.

A recording is a compressed .npz, with arrays of 64-bit floats and integers under these names. F is the number of
frames, i counts robots, j counts sensors, both from 0; X is points, segments, or another family of
landmarks:

    header              text: JSON with format "slamlib recording", version 1, rig (robots and sensors: the fields of
                        RobotSetup and SensorSetup, in metres and degrees), truth (whether it is there)
    number, dt          (F,): each frame's number, and the time since the one before [s]
    robot{i}.control    (F, c) [m, rad]: what the robot was told, or felt itself do; nan: nothing was
    robot{i}.noise      (F, c, c): the covariance of the noise in it
    sensor{j}.X.first   (F + 1,): the features of frame number f are rows first[f] up to first[f + 1] of the next two
    sensor{j}.X.ids     (n,)
    sensor{j}.X.values  (n, m): measurements; of segments two pixels (u, v, u, v)
    world.X.ids         (n,): what there is to see; world.points.values (n, 3), world.segments.values (k, 6) [m]
    world.faces         (f, 3, 3) [m]: opaque triangles
    truth.robot{i}      (F, s): state, which begins with position [m] and unit quaternion (w, x, y, z)
    truth.mount{j}      (F, 7): pose of the sensor on its robot

A control moves the robot before its frame's features are seen. Nothing is rounded: what is read is what was written.
"""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.files import whole
from slamlib.data.records import Frame, Truth, World
from slamlib.data.setup import Rig
from slamlib.errors import SlamlibError
from slamlib.simulation.packing import packed, unpacked

FORMAT, VERSION = "slamlib recording", 1


@dataclass(frozen=True, eq=False)
class Recording:
    """A run: its rig, its world, its frames, and for each the truth, or None. Iterates over pairs (frame, truth)."""

    rig: Rig
    world: World
    frames: tuple[Frame, ...]
    truths: tuple[Truth | None, ...]

    def __iter__(self) -> Iterator[tuple[Frame, Truth | None]]:
        return iter(zip(self.frames, self.truths, strict=True))

    def __len__(self) -> int:
        return len(self.frames)


def save(path: str | Path, frames: Iterable[tuple[Frame, Truth | None]], *, rig: Rig, world: World) -> None:
    """Write a run, whole or not at all; if it fails, a file of that name stays as it was. Raises SlamlibError.

    frames: what simulate(...) gives, or a Recording, or pairs of one's own with the truth in all of them or None.
    """
    pairs = list(frames)
    known = any(truth is not None for _, truth in pairs)
    header = {"format": FORMAT, "version": VERSION, "rig": rig.to_dict(), "truth": known}
    arrays: dict[str, Any] = {"header": np.array(json.dumps(header, default=_plain)), **packed(pairs, rig, world)}
    with whole(path) as partial, partial.open("wb") as file:
        np.savez_compressed(file, **arrays)


def load(path: str | Path) -> Recording:
    """Read a run. Raises SlamlibError for a damaged file or no recording, FileNotFoundError if there is none."""
    path = Path(path)
    arrays = _arrays(path)
    header = _header(path, arrays)
    try:
        rig = Rig.from_dict(header["rig"])
        world, frames, truths = unpacked(arrays, rig, header["truth"])
    except (KeyError, ValueError, TypeError, IndexError, SlamlibError) as error:
        raise SlamlibError(f"{path.name} is a recording, but not a whole one: {error!r}; take another copy") from error
    return Recording(rig, world, tuple(frames), tuple(truths))


def _arrays(path: Path) -> dict[str, Any]:
    """All arrays of the file; nothing in it is run."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
            return {name: archive[name] for name in archive.files}
    except FileNotFoundError:
        raise
    except Exception as error:  # a damaged archive fails in more ways than its modules name
        raise SlamlibError(f"{path.name} cannot be read ({error}): it is damaged, or no recording at all") from error


def _header(path: Path, arrays: dict[str, Any]) -> dict[str, Any]:
    try:
        header = json.loads(str(arrays["header"]))
        form, version = header["format"], header["version"]
    except (KeyError, ValueError, TypeError):
        form, version, header = None, None, {}
    if form != FORMAT:
        raise SlamlibError(f"{path.name} is no recording: it has no header that says {FORMAT!r}; save(...) writes one")
    if version != VERSION:
        raise SlamlibError(
            f"{path.name} has version {version!r}, and this slamlib reads {VERSION}: install a newer one"
        )
    return dict(header)


def _plain(value: Any) -> Any:
    """Arrays and their numbers, where a setup was given them, as plain data."""
    return value.tolist()
