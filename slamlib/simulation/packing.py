"""A run as named arrays, and back; the names are explained in recording.py."""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slamlib.data.records import Control, Features, Frame, Scan, Truth, World
from slamlib.data.setup import Rig
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.observation import FAMILIES

Pairs = list[tuple[Frame, Truth | None]]


def packed(pairs: Pairs, rig: Rig, world: World) -> dict[str, NDArray[Any]]:
    """The arrays of a run. Raises SlamlibError where frames and rig do not match."""
    _fits(pairs, rig)
    frames = [frame for frame, _ in pairs]
    truths = [truth for _, truth in pairs if truth is not None]
    arrays = {
        "number": np.array([f.number for f in frames], np.int64),
        "dt": np.array([f.dt for f in frames], float),
        "world.faces": world.faces,
        **{f"world.{x}.ids": features.ids for x, features in world.features.items()},
        **{f"world.{x}.values": features.values for x, features in world.features.items()},
    }
    for i, setup in enumerate(rig.robots):
        arrays |= _controls(f"robot{i}", [f.controls[i] for f in frames], setup.model.control)
        if truths:
            arrays[f"truth.robot{i}"] = np.array([t.robots[i] for t in truths])
    for j, sensor in enumerate(rig.sensors):
        for x, family in FAMILIES.items():
            none = Features.none(family.size(sensor.calibration))
            arrays |= _features(f"sensor{j}.{x}", [f.scans[j].features.get(x, none) for f in frames], none)
        if truths:
            arrays[f"truth.mount{j}"] = np.array([t.mounts[j] for t in truths])
    return arrays


def _fits(pairs: Pairs, rig: Rig) -> None:
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


def _controls(name: str, controls: list[Control | None], size: int) -> dict[str, NDArray[Any]]:
    value, noise = np.full((len(controls), size), np.nan), np.zeros((len(controls), size, size))
    for row, control in enumerate(controls):
        if control is not None:
            value[row], noise[row] = control.value, control.covariance
    return {f"{name}.control": value, f"{name}.noise": noise}


def _features(name: str, features: list[Features], none: Features) -> dict[str, Array]:
    parts = [none, *features]
    return {
        f"{name}.first": np.cumsum([0, *(len(f) for f in features)], dtype=np.int64),
        f"{name}.ids": np.concatenate([f.ids for f in parts]),
        f"{name}.values": np.concatenate([f.values for f in parts]),
    }


def unpacked(arrays: dict[str, NDArray[Any]], rig: Rig, truth: bool) -> tuple[World, list[Frame], list[Truth | None]]:
    """World, frames and truths of a run's arrays. Raises KeyError, ValueError or SlamlibError if they are no run's."""
    names = [x for x in FAMILIES if f"world.{x}.ids" in arrays]  # all families that there were when it was written
    seen = {x: Features(arrays[f"world.{x}.ids"], arrays[f"world.{x}.values"]) for x in names}
    controls = [_each_control(arrays, f"robot{i}") for i in range(len(rig.robots))]
    scans = [{x: _each_features(arrays, f"sensor{j}.{x}") for x in names} for j in range(len(rig.sensors))]
    frames = [
        Frame(
            int(number),
            float(dt),
            tuple(robot[row] for robot in controls),
            tuple(Scan({x: features[row] for x, features in scan.items()}) for scan in scans),
        )
        for row, (number, dt) in enumerate(zip(arrays["number"], arrays["dt"], strict=True))
    ]
    return World(seen, arrays["world.faces"]), frames, _truths(arrays, rig, len(frames), truth)


def _each_control(arrays: dict[str, NDArray[Any]], name: str) -> list[Control | None]:
    rows = zip(arrays[f"{name}.control"], arrays[f"{name}.noise"], strict=True)
    return [None if np.isnan(value).all() else Control(value, noise) for value, noise in rows]


def _each_features(arrays: dict[str, NDArray[Any]], name: str) -> list[Features]:
    first, ids, values = (arrays[f"{name}.{part}"] for part in ("first", "ids", "values"))
    return [Features(ids[a:b], values[a:b]) for a, b in pairwise(first)]


def _truths(arrays: dict[str, NDArray[Any]], rig: Rig, count: int, known: bool) -> list[Truth | None]:
    if not known:
        return [None] * count
    names = [f"truth.robot{i}" for i in range(len(rig.robots))], [f"truth.mount{j}" for j in range(len(rig.sensors))]
    states, mounts = (zip(*(arrays[name] for name in kind), strict=True) for kind in names)
    return [Truth(tuple(s), tuple(m)) for s, m in zip(states, mounts, strict=True)]
