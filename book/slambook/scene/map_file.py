"""A map as a file for other programs: PLY for viewers of point clouds, JSON and CSV with the covariances.

A point is one vertex, a segment is two, its endpoints; lengths in metres, in the world's frame.
"""

import csv
import json
from collections.abc import Callable, Iterator
from io import StringIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from slamlib.errors import entry
from slamlib.manifolds import Array
from slamlib.plain_data.files import write_whole
from slamlib.records.ids import Id
from slamlib.records.snapshots import Snapshot

_UPPER = np.triu_indices(3)


class Vertex(NamedTuple):
    """A point (3,) of a landmark with its covariance (3, 3); number: 0, and 1 for a segment's second endpoint."""

    family: str
    id: Id
    kind: str
    converged: bool
    number: int
    position: Array
    covariance: Array

    @property
    def is_finite(self) -> bool:
        """Whether it is known where it is: not at infinity, and with a covariance."""
        return bool(np.isfinite([*self.position, *self.covariance.ravel()]).all())


def vertices(snapshot: Snapshot) -> Iterator[Vertex]:
    """The points of all landmarks of a snapshot."""
    for family, shown in snapshot.landmarks.items():
        for row, landmark in enumerate(shown.ids.tolist()):
            places, covariances = shown.geometry[row].reshape(-1, 3), shown.covariance[row].reshape(-1, 3, 3)
            for number, place in enumerate(places):
                about = landmark, shown.kinds[row], bool(shown.converged[row]), number
                yield Vertex(family, *about, place, covariances[number])


def _json(snapshot: Snapshot) -> str:
    """One object a landmark; null for a point at infinity."""
    landmarks: dict[tuple[str, Id], dict[str, Any]] = {}
    for v in vertices(snapshot):
        about: dict[str, Any] = {"family": v.family, "id": v.id, "kind": v.kind, "converged": v.converged}
        found = landmarks.setdefault((v.family, v.id), about | {"vertices": []})
        numbers = {"position": v.position.tolist(), "covariance": v.covariance.tolist()}
        found["vertices"].append(numbers if v.is_finite else dict.fromkeys(numbers))
    whole = {"frame": snapshot.number, "time": snapshot.time, "unit": "m", "landmarks": [*landmarks.values()]}
    return json.dumps(whole, indent=1) + "\n"


def _csv(snapshot: Snapshot) -> str:
    """One row a vertex; nan for a coordinate of a point at infinity."""
    text = StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["family", "id", "kind", "converged", "vertex", "x", "y", "z", "xx", "xy", "xz", "yy", "yz", "zz"])
    for v in vertices(snapshot):
        about = v.family, v.id, v.kind, int(v.converged), v.number
        table.writerow([*about, *(f"{value:.12g}" for value in (*v.position, *v.covariance[_UPPER]))])
    return text.getvalue()


def _ply(snapshot: Snapshot) -> str:
    """Vertices with the largest standard deviation of each, edges for segments; landmarks at infinity are left out.

    An id that is no 32-bit integer, the only ones of this format, becomes a number from 0 on, which a comment explains.
    """
    found = list(vertices(snapshot))
    left_out = {(v.family, v.id) for v in found if not v.is_finite}
    drawn = [v for v in found if (v.family, v.id) not in left_out]
    ids = list(dict.fromkeys(v.id for v in drawn))
    fit = all(isinstance(number, int) and -(2**31) <= number < 2**31 for number in ids)
    number_of = {number: number if fit else place for place, number in enumerate(ids)}
    names = [] if fit else [f"comment id {place} is {json.dumps(number)}" for number, place in number_of.items()]
    edges = [f"{i - 1} {i}" for i, v in enumerate(drawn) if v.number]
    head = [
        "ply", "format ascii 1.0", "comment slamlib: a map [m]; std is the largest standard deviation of the position",
        *names,
        f"element vertex {len(drawn)}", *(f"property double {name}" for name in ("x", "y", "z", "std")),
        "property int id", f"element edge {len(edges)}", "property int vertex1", "property int vertex2", "end_header",
    ]  # fmt: skip
    rows = [
        " ".join(
            [
                *(f"{x:.9g}" for x in v.position),
                f"{np.sqrt(np.linalg.eigvalsh(v.covariance)[-1]):.6g} {number_of[v.id]}",
            ]
        )
        for v in drawn
    ]
    return "\n".join([*head, *rows, *edges]) + "\n"


FORMATS = {".ply": _ply, ".json": _json, ".csv": _csv}


def check(path: str | Path) -> Callable[[Snapshot], str]:
    """What makes the text of a file with this ending. Raises SlamlibError for one of no format."""
    return entry("ending of a map's file", Path(path).suffix.lower(), FORMATS)


def write(path: str | Path, snapshot: Snapshot) -> None:
    """Write the map of a snapshot, atomically, in the format of the path's ending. Raises SlamlibError."""
    write_whole(path, check(path)(snapshot))
