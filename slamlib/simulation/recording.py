"""Recorded runs: a file with all that another filter needs to repeat one, in a layout that NumPy and JSON read.

A recording is a compressed .npz, with arrays of 64-bit floats and integers under these names. F is the number of
frames, i counts robots, j counts sensors, both from 0; X is points, segments, or another family of landmarks:

    header              text: JSON with format "slamlib recording", version 1, rig (robots and sensors: the fields of
                        RobotSetup and SensorSetup, in metres and degrees), truth (whether it is there)
    digest              text: SHA-256 of all the others, by which changes are noticed; may be missing
    number, dt          (F,): each frame's number, and the time since the one before [s]
    robot{i}.control    (F, c) [m, rad]: the control input, or its measurement by odometry; nan: none
    robot{i}.noise      (F, c, c): the covariance of its noise
    sensor{j}.X.first   (F + 1,): the features of frame number f are rows first[f] up to first[f + 1] of the next two
    sensor{j}.X.ids     (n,)
    sensor{j}.X.values  (n, m): measurements; of segments two pixels (u, v, u, v)
    world.X.ids         (n,): the true landmarks; world.points.values (n, 3), world.segments.values (k, 6) [m]
    world.faces         (f, 3, 3) [m]: opaque triangles
    truth.robot{i}      (F, s): state, which starts with position [m] and unit quaternion (w, x, y, z)
    truth.mount{j}      (F, 7): pose of the sensor on its robot

A control moves the robot before its frame's features are measured. Values are stored exactly, without rounding.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slamlib.errors import SlamlibError
from slamlib.observation import FAMILIES
from slamlib.plain_data.files import complete, read_archive, write_archive
from slamlib.records.ids import joined, packed, unpacked
from slamlib.records.inputs import Control, Features, Frame, Scan, Truth, World
from slamlib.rigs.setup import Rig
from slamlib.simulation.worlds import check_world

FORMAT, VERSION = "slamlib recording", 1
Pairs = list[tuple[Frame, Truth | None]]
Arrays = dict[str, NDArray[Any]]


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
    """Write a run, atomically; if it fails, a file of that name stays as it was. Raises SlamlibError.

    frames: the result of simulate(...), or a Recording, or your own pairs with the truth in all of them or None.
    """
    pairs = list(frames)
    _check_fit(pairs, rig)
    own, truths = [frame for frame, _ in pairs], [truth for _, truth in pairs if truth is not None]
    arrays = {
        "number": np.array([f.number for f in own], np.int64),
        "dt": np.array([f.dt for f in own], float),
        "world.faces": world.faces,
    }
    check_world(world, "save")
    for x, family in FAMILIES.items():
        things = world.features.get(x, Features.none(family.world_size))
        arrays |= {f"world.{x}.ids": packed(things.ids.tolist()), f"world.{x}.values": things.values}
    for i, setup in enumerate(rig.robots):
        arrays |= _from_controls(f"robot{i}", [f.controls[i] for f in own], setup.model.control)
        if truths:
            arrays[f"truth.robot{i}"] = np.array([t.robots[i] for t in truths])
    for j, sensor in enumerate(rig.sensors):
        for x, family in FAMILIES.items():
            none = Features.none(family.size(sensor.calibration))
            arrays |= _from_features(f"sensor{j}.{x}", [f.scans[j].features.get(x, none) for f in own], none)
        if truths:
            arrays[f"truth.mount{j}"] = np.array([t.extrinsics[j] for t in truths])
    write_archive(path, FORMAT, VERSION, {"rig": rig.to_dict(), "truth": bool(truths)}, arrays)


def load(path: str | Path) -> Recording:
    """Read a run. Raises SlamlibError for a file that is missing, damaged, or no recording."""
    header, arrays = read_archive(path, FORMAT, VERSION, foreign=True)
    with complete(path):
        rig = Rig.from_dict(header["rig"])
        names = [x for x in FAMILIES if f"world.{x}.ids" in arrays]  # all families that there were when it was written
        seen = {x: Features(unpacked(arrays[f"world.{x}.ids"]), arrays[f"world.{x}.values"]) for x in names}
        world = World(seen, arrays["world.faces"])
        controls = zip(*(_to_controls(arrays, f"robot{i}") for i in range(len(rig.robots))), strict=True)
        scans = zip(*(_to_scans(arrays, f"sensor{j}", names) for j in range(len(rig.sensors))), strict=True)
        rows = zip(arrays["number"].tolist(), arrays["dt"].tolist(), controls, scans, strict=True)
        frames = tuple(Frame(*row) for row in rows)
        truths: list[Truth | None] = [None] * len(frames)
        if header["truth"]:
            states = zip(*(arrays[f"truth.robot{i}"] for i in range(len(rig.robots))), strict=True)
            all_extrinsics = zip(*(arrays[f"truth.mount{j}"] for j in range(len(rig.sensors))), strict=True)
            motions = [setup.model for setup in rig.robots]
            truths = [
                Truth(tuple(s), tuple(e), tuple(motion.pose(x) for motion, x in zip(motions, s, strict=True)))
                for s, e in zip(states, all_extrinsics, strict=True)
            ]
    return Recording(rig, world, frames, tuple(truths))


def _check_fit(pairs: Pairs, rig: Rig) -> None:
    for frame, _ in pairs:
        if (len(frame.controls), len(frame.scans)) != (len(rig.robots), len(rig.sensors)):
            raise SlamlibError(
                f"frame {frame.number} has {len(frame.controls)} controls and {len(frame.scans)} scans, but the rig "
                f"has {len(rig.robots)} robots and {len(rig.sensors)} sensors: save it with its own rig"
            )
        if any(scan.image is not None for scan in frame.scans):
            raise SlamlibError(f"frame {frame.number} holds an image, and recordings hold none: keep images in files")
        if frame.absolute:
            raise SlamlibError(f"frame {frame.number} holds measurements of a robot's own pose; recordings hold none")
    if len({truth is None for _, truth in pairs}) > 1:
        raise SlamlibError("the truth is known of some frames only: give it for all of them, or None for all")


def _from_controls(name: str, controls: list[Control | None], size: int) -> Arrays:
    value, noise = np.full((len(controls), size), np.nan), np.zeros((len(controls), size, size))
    for row, control in enumerate(controls):
        if control is not None:
            value[row], noise[row] = control.value, control.covariance
    return {f"{name}.control": value, f"{name}.noise": noise}


def _from_features(name: str, features: list[Features], none: Features) -> Arrays:
    parts = [none, *features]
    return {
        f"{name}.first": np.cumsum([0, *(len(f) for f in features)], dtype=np.int64),
        f"{name}.ids": packed(joined(f.ids for f in parts)),
        f"{name}.values": np.concatenate([f.values for f in parts]),
    }


def _to_controls(arrays: Arrays, name: str) -> list[Control | None]:
    rows = zip(arrays[f"{name}.control"], arrays[f"{name}.noise"], strict=True)
    return [None if np.isnan(value).all() else Control(value, noise) for value, noise in rows]


def _to_scans(arrays: Arrays, sensor: str, families: list[str]) -> list[Scan]:
    seen = []
    for x in families:
        first, ids, values = (arrays[f"{sensor}.{x}.{part}"] for part in ("first", "ids", "values"))
        ids = unpacked(ids)
        seen.append([Features(ids[a:b], values[a:b]) for a, b in pairwise(first)])
    return [Scan(dict(zip(families, features, strict=True))) for features in zip(*seen, strict=True)]
