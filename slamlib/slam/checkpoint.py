"""Save a filter to one file, atomically, and load it: the loaded filter continues bit for bit like the saved one.

The file is a ZIP of NumPy arrays (np.load reads it): `header`, the text of a JSON object; `P`, the joint covariance;
`means`, all blocks' means one after another; `abscissas`, the two endpoints of each line (nan for points).
"""

from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.files import complete, read_archive, write_archive
from slamlib.data.setup import Rig
from slamlib.observation import parametrization
from slamlib.slam.entities import Landmark
from slamlib.slam.options import Options

FORMAT, VERSION = "slamlib filter", 3
HISTORY = ("id", "first_seen", "searched", "matched", "inliers", "sensor", "last_seen")  # saved fields of a landmark


def save(slam: Any, path: str | Path, **extra: Any) -> None:
    """Write the filter to a file; extra: the caller's own plain data, which `load` returns."""
    landmarks = slam.landmarks
    order = {id(block): i for i, block in enumerate(slam.belief.blocks)}
    header = {
        "rig": slam.rig.to_dict(),
        "options": slam.options.to_dict(),
        "number": slam.number,
        "time": slam.time,
        "frame_counts": slam.frame_counts,
        "robots": [order[id(r.block)] for r in slam.robots],
        "sensors": [None if s.block is None else order[id(s.block)] for s in slam.sensors],
        "sizes": [len(block.mean) for block in slam.belief.blocks],
        "landmarks": [
            {
                **{name: getattr(lm, name) for name in HISTORY},
                "kind": lm.kind.name,
                "block": order[id(lm.block)],
                "signature": slam.front_ends[lm.sensor].pack(lm.signature),
            }
            for lm in landmarks
        ],
        "front_ends": [front_end.dump() for front_end in slam.front_ends],
        "extra": extra,
    }
    none = np.full(2, np.nan)
    arrays = {
        "P": slam.belief.matrix,
        "means": np.concatenate([block.mean for block in slam.belief.blocks]),
        "abscissas": np.array([none if lm.abscissas is None else lm.abscissas for lm in landmarks]).reshape(-1, 2),
    }
    if slam.linearization is not None:
        arrays["linearization"] = np.concatenate([slam.linearization.at(block) for block in slam.belief.blocks])
    write_archive(path, FORMAT, VERSION, header, arrays)


def read(path: str | Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the header and the arrays of a file. Raises SlamlibError for any other file, or an incomplete one."""
    return read_archive(path, FORMAT, VERSION, "run it anew and save it")


def load(path: str | Path, front_ends: Any, make: Any) -> tuple[Any, dict[str, Any]]:
    """Return the filter of a file, made by make(rig, options, front_ends=...), and the caller's extra data.

    Raises SlamlibError.
    """
    header, arrays = read(path)
    with complete(path):
        slam = make(Rig.from_dict(header["rig"]), Options.from_dict(header["options"]), front_ends=front_ends)
        stops = np.cumsum(header["sizes"])
        means = np.split(arrays["means"], stops[:-1])
        own = {i: r.block for i, r in zip(header["robots"], slam.robots, strict=True)}
        own |= {i: s.block for i, s in zip(header["sensors"], slam.sensors, strict=True) if i is not None}
        kinds = {row["block"]: parametrization(row["kind"]) for row in header["landmarks"]}
        blocks = {i: slam.belief.add(kinds[i].manifold, means[i], np.eye(kinds[i].manifold.dof)) for i in sorted(kinds)}
        slam.belief.overwrite({**own, **blocks}, dict(enumerate(means)), arrays["P"])
        for row, abscissas in zip(header["landmarks"], arrays["abscissas"], strict=True):
            block, known = row["block"], None if np.isnan(abscissas).any() else abscissas
            signature = slam.front_ends[row["sensor"]].unpack(row["signature"])
            history = {name: row[name] for name in HISTORY}
            landmark = Landmark(kind=kinds[block], block=blocks[block], abscissas=known, signature=signature, **history)
            slam.landmarks.append(landmark)
        if slam.linearization is not None:
            slam.linearization.added(slam.belief.blocks, np.split(arrays["linearization"], stops[:-1]))
        for front_end, state in zip(slam.front_ends, header["front_ends"], strict=True):
            front_end.restore(state)
        slam.number, slam.time, slam.frame_counts = header["number"], header["time"], header["frame_counts"]
        return slam, header["extra"]
