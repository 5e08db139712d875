"""One frame of a sensor: what it delivered, the predicted measurement of each landmark, and its outcome.

Two numbers of each measurement are drawn: of a camera the pixel, of another sensor those that the reader chooses. A
segment is four numbers, the pixels of its endpoints.
"""

from collections.abc import Callable, Sequence

import numpy as np

from slambook.scene.layers import Flat, strung
from slambook.scene.options import SensorOptions
from slambook.scene.view import rings
from slamlib.errors import SlamlibError
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array, Mask
from slamlib.records.ids import Id
from slamlib.records.snapshots import MeasurementView, SensorView, Snapshot

AWAY = 8.0  # pixels from a segment to its label, along its normal
RING = 0.022  # of the image's width: the least radius of a search region as it is drawn
# Outcomes of a predicted measurement, by the role that shows it: not searched for, not found, inlier, outlier.
OUTCOMES: dict[str, Callable[[MeasurementView], Mask]] = {
    "predicted_patch": lambda predictions: ~predictions.chosen & ~predictions.matched,
    "missed": lambda predictions: predictions.chosen & ~predictions.matched,
    "updated": lambda predictions: predictions.matched & predictions.inlier,
    "rejected": lambda predictions: predictions.matched & ~predictions.inlier,
}


def sensor_view(snapshot: Snapshot, sensor: int | str) -> SensorView:
    """A sensor of a snapshot by its index or its name; raises SlamlibError."""
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
    expected, known = _means(view, pair, converged(snapshot))
    layers = [
        *(_outcome(name, view, pair, options) for name in OUTCOMES),
        Flat("new point", marks=expected[~known]),
        Flat("point", marks=expected[known]),
        _measured(view, pair),
    ]
    if options.raw and view.scan is not None:
        segments = strung(view.scan.segments.values.reshape(-1, 2, 2), 2)
        layers.insert(0, Flat("raw", lines=segments, marks=numbers_of(view.scan.points.values, pair)))
    if options.labels:  # of points above their predictions, of segments beside their midpoints
        middles = beside(numbers_of(view.segments.expected, range(4)).reshape(-1, 2, 2))
        expected = numbers_of(view.points.expected, pair)
        layers.append(Flat("label", places=expected, words=tuple(map(str, view.points.ids))))
        layers.append(Flat("line label", places=middles, words=tuple(map(str, view.segments.ids))))
    if options.scores:
        places, words = scores(view, pair)
        layers.append(Flat("score", places=places, words=words))
    return tuple(layers)


def converged(snapshot: Snapshot) -> set[Id]:
    """The ids of the landmarks that have converged."""
    views = snapshot.landmarks.values()
    return {i for view in views for i, c in zip(view.ids.tolist(), view.converged, strict=True) if c}


def _means(view: SensorView, pair: list[int], known: set[Id]) -> tuple[Array, Mask]:
    """Predicted points and endpoints of segments in view (n, 2), and the mask of those converged."""
    endpoints = view.segments.endpoints.reshape(-1, 2)
    marks = np.concatenate([numbers_of(view.points.expected, pair), endpoints])
    ids = [*view.points.ids.tolist(), *np.repeat(view.segments.ids, 2).tolist()]
    found = np.array([i in known for i in ids], dtype=bool)
    shown = np.isfinite(marks).all(axis=1)
    return marks[shown], found[shown]


def numbers_of(rows: Array, columns: Sequence[int]) -> Array:
    """These numbers (n, k) of measurements (n, m); of none, whatever they measure, none."""
    return rows[:, list(columns)] if len(rows) else np.zeros((0, len(columns)))


def delivered(views: Sequence[SensorView], pair: list[int]) -> Array:
    """Two numbers (n, 2) of each point that was predicted or delivered in these views."""
    rows = [numbers_of(view.points.expected, pair) for view in views]
    rows += [numbers_of(v.scan.points.values, pair) for v in views if v.scan is not None]
    return np.concatenate(rows)


def _check_numbers(view: SensorView, pair: list[int]) -> None:
    sizes = [view.points.expected.shape[1]] if len(view.points.ids) else []
    sizes += [view.scan.points.values.shape[1]] if view.scan is not None and len(view.scan.points) else []
    if sizes and max(pair) >= min(sizes):
        raise SlamlibError(
            f"{view.name} measures {min(sizes)} numbers, counted from 0: numbers {pair} are not all there"
        )


def _outcome(role: str, view: SensorView, pair: list[int], options: SensorOptions) -> Flat:
    """Ellipses around predicted points and endpoints of segments, and the predicted segments, of one outcome."""
    some, seen = OUTCOMES[role](view.points), OUTCOMES[role](view.segments)
    found: list[Array] = []
    if options.ellipses and some.any():
        found += list(view.points.expected[some][:, None, pair] + rings(regions(view, pair, options)[some]))
    if options.ellipses and seen.any():
        endpoints = view.segments.endpoints[seen].reshape(-1, 2)
        shown = np.isfinite(endpoints).all(axis=1)
        shapes = view.segments.endpoint_covariances[seen].reshape(-1, 2, 2)[shown]
        found += list(endpoints[shown, None] + np.sqrt(chi2_quantile(options.gate, 2)) * rings(shapes))
    segments = numbers_of(view.segments.expected[seen], range(4)).reshape(-1, 2, 2)
    return Flat(role, lines=strung(segments, 2), shells=strung(found, 2))


def regions(view: SensorView, pair: list[int], options: SensorOptions) -> Array:
    """Gates of the predicted points, as covariances (n, 2, 2) whose one-sigma ellipses bound them.

    In an image, an ellipse smaller than the mark in its middle becomes a ring around that, so that it stays visible.
    """
    covariances = view.points.covariance[:, pair][:, :, pair]
    shapes = chi2_quantile(options.gate, view.points.covariance.shape[-1]) * covariances
    if view.image is not None:
        least = (RING * float(view.image[0])) ** 2
        shapes[np.linalg.eigvalsh(shapes)[:, -1] < least] = least * np.eye(2)
    return shapes


def _measured(view: SensorView, pair: list[int]) -> Flat:
    """Matched measurements: a line from each point to its prediction, and the endpoints of each segment."""
    points, segments = view.points, view.segments
    expected, marks = (numbers_of(rows[points.matched], pair) for rows in (points.expected, points.measured))
    lines = strung(np.stack([expected, marks], axis=1), 2)
    endpoints = numbers_of(segments.measured[segments.matched], range(4)).reshape(-1, 2)
    return Flat("measured", lines=lines, marks=np.concatenate([marks, endpoints]))


def scores(view: SensorView, pair: list[int]) -> tuple[Array, tuple[str, ...]]:
    """Positions (n, 2) of the matching scores, at the match or else at the prediction; and the scores as text."""
    places, words = [np.zeros((0, 2))], []
    for predictions, columns in ((view.points, pair), (view.segments, [0, 1, 2, 3])):
        known = np.isfinite(predictions.scores)
        if known.any():
            found = np.where(predictions.matched[:, None], predictions.measured, predictions.expected)
            places.append(found[known][:, columns].reshape(int(known.sum()), -1, 2).mean(axis=1))
            words += [f"{score:.2f}" for score in predictions.scores[known]]
    return np.concatenate(places), tuple(words)


def beside(segments: Array) -> Array:
    """Positions (n, 2) a little off the midpoints of segments (n, 2, 2), along their normals, on the upper side."""
    along = segments[:, 1] - segments[:, 0]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.where(length > 0, length, 1)
    upwards = np.where(normal[:, 1:] > 0, -1.0, 1.0)
    return segments.mean(axis=1) + AWAY * upwards * normal
