"""What a sensor saw in one frame: what it delivered, what was expected of each landmark, and what became of it.

Two numbers of each measurement are drawn: of a camera the pixel, of another sensor those that the reader chooses. A
segment is four numbers, the pixels of its two ends.
"""

from collections.abc import Callable

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.evaluation import chi2_quantile
from slamlib.scene.layers import Flat, strung
from slamlib.scene.options import SensorOptions
from slamlib.scene.view import rings
from slamlib.snapshots import Looks, SensorView, Snapshot
from slamlib.spaces import Array

AWAY = 8.0  # pixels from a segment to its label, along its normal
# What became of a look, by the role that shows it.
OUTCOMES: dict[str, Callable[[Looks], Array]] = {
    "predicted": lambda looks: ~looks.matched,
    "updated": lambda looks: looks.matched & looks.inlier,
    "rejected": lambda looks: looks.matched & ~looks.inlier,
}


def sensor_view(snapshot: Snapshot, sensor: int | str) -> SensorView:
    """A sensor of a snapshot by its place or its name; raises SlamlibError."""
    names = [view.name for view in snapshot.sensors]
    place = names.index(sensor) if sensor in names else sensor
    if not isinstance(place, int | np.integer) or not 0 <= place < len(names):
        raise SlamlibError(f"there is no sensor {sensor!r}; there are {', '.join(names)}, counted from 0")
    return snapshot.sensors[place]


def sensor_scene(
    snapshot: Snapshot, sensor: int | str = 0, *, options: SensorOptions | None = None
) -> tuple[Flat, ...]:
    """The layers of a sensor's figure in its own units, those that lie below first; raises SlamlibError."""
    options = options or SensorOptions()
    view = sensor_view(snapshot, sensor)
    pair = list(options.numbers)
    _check_numbers(view, pair)
    converged = converged_points(snapshot)
    known = np.array([int(i) in converged for i in view.points.ids], dtype=bool)
    expected = np.reshape(view.points.expected, (len(known), -1))[:, pair] if len(known) else np.zeros((0, 2))
    return (
        *([_raw(view, pair)] if options.raw else []),
        *(_outcome(name, view, pair, options) for name in OUTCOMES),
        Flat("new point", marks=expected[~known]),
        Flat("point", marks=expected[known]),
        _measured(view, pair),
        *(_labels(view, expected) if options.labels else ()),
    )


def converged_points(snapshot: Snapshot) -> set[int]:
    """The numbers of the points that have converged."""
    return {int(i) for i, c in zip(snapshot.points.ids, snapshot.points.converged, strict=True) if c}


def _check_numbers(view: SensorView, pair: list[int]) -> None:
    sizes = [view.points.expected.shape[1]] if len(view.points.ids) else []
    sizes += [view.scan.points.values.shape[1]] if view.scan is not None and len(view.scan.points) else []
    if sizes and max(pair) >= min(sizes):
        raise SlamlibError(
            f"{view.name} measures {min(sizes)} numbers, counted from 0: numbers {pair} are not all there"
        )


def _raw(view: SensorView, pair: list[int]) -> Flat:
    if view.scan is None:
        return Flat("raw")
    points, segments = view.scan.points, view.scan.segments
    marks = points.values[:, pair] if len(points) else np.zeros((0, 2))
    return Flat("raw", lines=strung(segments.values.reshape(-1, 2, 2), 2), marks=marks)


def _outcome(role: str, view: SensorView, pair: list[int], options: SensorOptions) -> Flat:
    """Ellipses around the points expected, and the segments expected, of one outcome."""
    some = OUTCOMES[role](view.points)
    found: list[Array] = []
    if options.ellipses and some.any():
        covariances = view.points.covariance[some][:, pair][:, :, pair]
        radius = np.sqrt(chi2_quantile(options.gate, view.points.covariance.shape[-1]))
        found = list(view.points.expected[some][:, None, pair] + radius * rings(covariances))
    seen = OUTCOMES[role](view.segments)
    segments = view.segments.expected[seen].reshape(-1, 2, 2) if seen.any() else []
    return Flat(role, lines=strung(segments, 2), shells=strung(found, 2))


def _measured(view: SensorView, pair: list[int]) -> Flat:
    """What was matched; from each point a line to what was expected, of each segment the two ends."""
    points, segments = view.points, view.segments
    found = points.matched
    marks = points.measured[found][:, pair] if found.any() else np.zeros((0, 2))
    expected = points.expected[found][:, pair] if found.any() else np.zeros((0, 2))
    lines = strung(np.stack([expected, marks], axis=1), 2)
    ends = segments.measured[segments.matched].reshape(-1, 2) if segments.matched.any() else np.zeros((0, 2))
    return Flat("measured", lines=lines, marks=np.concatenate([marks, ends]))


def _labels(view: SensorView, expected: Array) -> tuple[Flat, Flat]:
    """Numbers of the landmarks: of points above what was expected, of segments beside their middles."""
    ends = view.segments.expected.reshape(-1, 2, 2) if len(view.segments.ids) else np.zeros((0, 2, 2))
    return (
        Flat("label", places=expected, words=tuple(map(str, view.points.ids))),
        Flat("line label", places=beside(ends), words=tuple(map(str, view.segments.ids))),
    )


def beside(segments: Array) -> Array:
    """Places (n, 2) a little away from the middles of segments (n, 2, 2), along their normals, on the upper side."""
    along = segments[:, 1] - segments[:, 0]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.where(length > 0, length, 1)
    upwards = np.where(normal[:, 1:] > 0, -1.0, 1.0)
    return segments.mean(axis=1) + AWAY * upwards * normal
