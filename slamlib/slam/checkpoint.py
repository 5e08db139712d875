"""A filter's state and front ends as plain data and arrays, from which it continues bit for bit; and the file of them.

The file is a ZIP of NumPy arrays (np.load reads it): `header`, the text of a JSON object; `P`, the joint covariance;
`means`, all blocks' means one after another; `abscissas`, the two endpoints of each line (nan for points).
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.entities import Landmark, State
from slamlib.manifolds import Array
from slamlib.observation import parametrization
from slamlib.plain_data.files import read_archive, write_archive
from slamlib.slam.data_association.front_end import FrontEnd

FORMAT, VERSION = "slamlib filter", 4
HISTORY = ("id", "first_seen", "searched", "matched", "inliers", "sensor", "last_seen")  # saved fields of a landmark
NONE = np.full(2, np.nan)  # abscissas of what has no endpoints


def write(path: str | Path, header: dict[str, Any], arrays: dict[str, Array]) -> None:
    """Write a file, atomically."""
    write_archive(path, FORMAT, VERSION, header, arrays)


def read(path: str | Path) -> tuple[dict[str, Any], dict[str, Array]]:
    """Return the header and the arrays of a file. Raises SlamlibError for any other file, or an incomplete one."""
    return read_archive(path, FORMAT, VERSION, "run it anew and save it")


def pack(state: State, front_ends: Sequence[FrontEnd]) -> tuple[dict[str, Any], dict[str, Array]]:
    """The state, with what the front ends know of its landmarks, as plain data and arrays."""
    blocks, landmarks = state.belief.blocks, state.landmarks
    order = {id(block): i for i, block in enumerate(blocks)}
    header = {
        "robots": [order[id(r.block)] for r in state.robots],
        "sensors": [None if s.block is None else order[id(s.block)] for s in state.sensors],
        "sizes": [len(block.mean) for block in blocks],
        "landmarks": [
            {
                **{name: getattr(lm, name) for name in HISTORY},
                "kind": lm.kind.name,
                "block": order[id(lm.block)],
                "signature": front_ends[lm.sensor].pack(lm.signature),
                "first_measured": None if lm.first_measured is None else lm.first_measured.tolist(),
            }
            for lm in landmarks
        ],
        "front_ends": [front_end.dump() for front_end in front_ends],
    }
    arrays = {
        "P": state.belief.matrix,
        "means": np.concatenate([block.mean for block in blocks]),
        "abscissas": np.array([NONE if lm.abscissas is None else lm.abscissas for lm in landmarks]).reshape(-1, 2),
    }
    if state.linearization is not None:
        arrays["linearization"] = np.concatenate([state.linearization.at(block) for block in blocks])
    return header, arrays


def unpack(state: State, front_ends: Sequence[FrontEnd], header: dict[str, Any], arrays: dict[str, Array]) -> None:
    """Fill the state of a new filter, without landmarks yet, and its front ends, with what `pack` packed."""
    stops = np.cumsum(header["sizes"])
    means = np.split(arrays["means"], stops[:-1])
    own = {i: r.block for i, r in zip(header["robots"], state.robots, strict=True)}
    own |= {i: s.block for i, s in zip(header["sensors"], state.sensors, strict=True) if s.block is not None}
    kinds = {row["block"]: parametrization(row["kind"]) for row in header["landmarks"]}
    blocks = {i: state.belief.add(kinds[i].manifold, means[i], np.eye(kinds[i].manifold.dof)) for i in sorted(kinds)}
    state.belief.overwrite({**own, **blocks}, dict(enumerate(means)), arrays["P"])
    for row, abscissas in zip(header["landmarks"], arrays["abscissas"], strict=True):
        block, first = row["block"], row["first_measured"]
        state.landmarks.append(Landmark(
            kind=kinds[block],
            block=blocks[block],
            abscissas=None if np.isnan(abscissas).any() else abscissas,
            signature=front_ends[row["sensor"]].unpack(row["signature"]),
            first_measured=None if first is None else np.array(first),
            **{name: row[name] for name in HISTORY},
        ))  # fmt: skip
    if state.linearization is not None:
        state.linearization.added(state.belief.blocks, np.split(arrays["linearization"], stops[:-1]))
    for front_end, own_state in zip(front_ends, header["front_ends"], strict=True):
        front_end.restore(own_state)
