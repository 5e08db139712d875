"""What a sensor saw, frame by frame, as little data for the player: numbers, not outlines."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slambook.scene.image_scene import OUTCOMES, beside, converged, delivered, numbers_of, regions, scores, sensor_view
from slambook.scene.layers import lower
from slambook.scene.options import SensorOptions
from slambook.scene.photographs import Photograph, photograph
from slamlib.errors import SlamlibError
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array
from slamlib.records.ids import Id
from slamlib.records.snapshots import MeasurementView, SensorView, Snapshot

ROUND = 1  # decimals of a pixel
WIDE = 200  # pixels: the widest images that are sent, if nobody asks for others
ENOUGH = 4  # significant digits of a number that is no pixel


class ImageFrames:
    """Predictions and measurements of one sensor in the shown frames, two numbers of each; if asked, its images."""

    def __init__(
        self, snapshots: Sequence[Snapshot], sensor: int | str, options: SensorOptions, images: bool = False
    ) -> None:
        self.sensor, self.options, self.pair, self.images = sensor, options, list(options.numbers), images
        self.view = sensor_view(snapshots[-1], sensor)
        self.limits = self._limits(snapshots)
        span = min(abs(self.limits[1] - self.limits[0]), abs(self.limits[3] - self.limits[2]))
        self.decimals = ROUND if self.view.image is not None else ENOUGH - int(np.floor(np.log10(span)))

    def _limits(self, snapshots: Sequence[Snapshot]) -> list[float]:
        """Left, right, low and high end of the picture: the image, or the range of all measurements."""
        if self.view.image is not None:
            return [0.0, float(self.view.image[0]), float(self.view.image[1]), 0.0]
        rows = delivered([sensor_view(s, self.sensor) for s in snapshots], self.pair)
        if not len(rows):
            raise SlamlibError(f"player: {self.view.name} has seen nothing that could be shown")
        low, high = rows.min(axis=0), rows.max(axis=0)
        spare = 0.1 * np.maximum(high - low, 1e-6)
        (left, bottom), (right, top) = low - spare, high + spare
        return [float(left), float(right), float(bottom), float(top)]

    def frame(self, snapshot: Snapshot) -> dict[str, Any]:
        """One frame: what was delivered, and the predictions of points and of segments, as rows of numbers."""
        view = sensor_view(snapshot, self.sensor)
        raw: dict[str, Any] = {"points": [], "segments": []}
        if view.scan is not None and self.options.raw:
            points = numbers_of(view.scan.points.values, self.pair)
            raw = {"points": self._rounded(points), "segments": self._rounded(view.scan.segments.values)}
        known, photo = converged(snapshot), self.photo(snapshot)
        places, words = scores(view, self.pair) if self.options.scores else (np.zeros((0, 2)), ())
        found = {
            "raw": raw,
            "points": self._points(view, known),
            "segments": self._segments(view.segments, known),
            "scores": [[*place, word] for place, word in zip(self._rounded(places), words, strict=True)],
        }
        return found | ({} if photo is None else {"image": photo.uri, "extent": photo.extent})

    def photo(self, snapshot: Snapshot) -> Photograph | None:
        """The small image of a frame, if images are asked for and it has one."""
        view = sensor_view(snapshot, self.sensor)
        return photograph(view, self.options.image_width or WIDE) if self.images else None

    def _rounded(self, values: Array) -> Any:
        return np.round(np.asarray(values, dtype=float), self.decimals).tolist()

    def _points(self, view: SensorView, known: set[Id]) -> list[list[float]]:
        """Rows: landmark number, outcome, whether converged, prediction, factor of the gate's ellipse, measurement."""
        predictions, rows = view.points, []
        if not len(predictions.ids):
            return []
        ids = predictions.ids.tolist()
        shapes = self.options.ellipses * regions(view, self.pair, self.options)
        for i, outcome in enumerate(_outcomes(predictions)):
            factor = lower(shapes[i])
            measured = self._rounded(predictions.measured[i, self.pair]) if predictions.matched[i] else []
            numbers = [*self._rounded(predictions.expected[i, self.pair]), *self._rounded(factor), *measured]
            number = ids[i]
            rows.append([_label(number), outcome, int(number in known), *numbers])
        return rows

    def _segments(self, predictions: MeasurementView, known: set[Id]) -> list[list[Any]]:
        """Rows: landmark number, outcome, whether converged, label's position, prediction, endpoints, measurement.

        endpoints: the position of each one in view, and the factor of its ellipse.
        """
        if not len(predictions.ids):
            return []
        ids = predictions.ids.tolist()
        places, rows = beside(predictions.expected.reshape(-1, 2, 2)), []
        radius = np.sqrt(chi2_quantile(self.options.gate, 2)) * self.options.ellipses
        for i, outcome in enumerate(_outcomes(predictions)):
            measured = self._rounded(predictions.measured[i]) if predictions.matched[i] else []
            both = zip(predictions.endpoints[i], predictions.endpoint_covariances[i], strict=True)
            endpoints = [
                [*self._rounded(e), *self._rounded(radius * lower(P))] for e, P in both if np.isfinite(e).all()
            ]
            number = ids[i]
            where = [*self._rounded(places[i]), *self._rounded(predictions.expected[i])]
            rows.append([_label(number), outcome, int(number in known), *where, endpoints, *measured])
        return rows


def _label(number: Id) -> Id:
    """An id as a page shows it: its numbers are exact up to 2^53 alone."""
    return number if isinstance(number, str) or abs(number) < 2**53 else str(number)


def _outcomes(predictions: MeasurementView) -> list[int]:
    """The outcome of each prediction, as an index into OUTCOMES."""
    return np.argmax([holds(predictions) for holds in OUTCOMES.values()], axis=0).tolist()
