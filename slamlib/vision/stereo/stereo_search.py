"""A front end for a stereo sensor: landmarks are matched by their descriptors, within the filter's own gate."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.datasets.pictures import checked
from slamlib.entities import Landmark
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Mask
from slamlib.records.ids import Id
from slamlib.records.inputs import Scan
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import FrontEndInput, Usable
from slamlib.slam.data_association.gates import gate
from slamlib.slam.prediction import Predictions, expected_covariances, expected_values
from slamlib.vision.image_front_end import ImageFrontEnd
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import (
    StereoFeatureExtractor,
    StereoFeatures,
    hamming_distances,
    mutual_nearest,
    refine_by_templates,
)
from slamlib.vision.stereo.odometry import checkerboard_half
from slamlib.vision.stereo.refine import cut


@dataclass(frozen=True, eq=False)
class LandmarkView:
    """Descriptor (32,), patch (s, s) around the left pixel, with its margin of one pixel, and disparity [px]."""

    descriptor: Array
    patch: Array
    disparity: float

    def zoom(self, disparity: float) -> float:
        """Ratio of scales, 1 or more, between this view and one at another disparity [px]."""
        ratio = disparity / self.disparity
        return max(ratio, 1 / ratio) if ratio > 0 else np.inf


@dataclass(frozen=True, eq=False)
class LandmarkViews:
    """All views of a landmark, the first one first. The first is never deleted, to avoid drift."""

    all: tuple[LandmarkView, ...]

    def nearest(self, disparity: float) -> LandmarkView:
        """The view whose distance is nearest to that of a disparity [px]; of equals the oldest."""
        return min(self.all, key=lambda view: view.zoom(disparity))

    def with_view(self, view: LandmarkView, most: int) -> "LandmarkViews":
        """With one more view; of more than `most`, the oldest but the first is deleted."""
        first, rest = self.all[:1], (*self.all[1:], view)
        return LandmarkViews(first + rest[-(most - 1) :] if most > 1 else first)


class StereoSearch(ImageFrontEnd[LandmarkViews, StereoSettings]):
    """Measures (u, v, disparity) [px] in the pair that is a scan's image, an array (2, h, w) of uint8.

    A landmark keeps its id as long as it is in the map: however long it was out of view, it is matched by its
    descriptor as soon as a feature lies in its gate.
    """

    size, signature_type = 3, LandmarkViews

    def __init__(
        self, calibration: Calibration, settings: StereoSettings | None = None, *, half: int | None = None
    ) -> None:
        """half: 0 or 1 measures in one half of the image only, and leaves the other to an odometry (E21), which shares
        the extractor, so that a pair is processed once. Raises SlamlibError for another sensor."""
        if calibration.image is None or calibration.sensor.size != 3 or "baseline" not in calibration.given:
            raise SlamlibError(
                f"StereoSearch: a stereo sensor with an image is expected, not {calibration.sensor.name}: "
                "SensorSetup(type='stereo', image=(w, h), parameters={'intrinsics': ..., 'baseline': ...})"
            )
        super().__init__(calibration, settings or StereoSettings())
        self.half = half
        self.extractor = StereoFeatureExtractor(calibration, self.settings)
        self.found: dict[Id, int] = {}  # rows of the present features, by the ids of the landmarks matched
        self.reserved = np.zeros(0, dtype=int)  # rows of the present features that are left to an odometry
        self.initialized: list[int] = []  # rows of the present features that initialized a landmark
        self.frame = 0

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan whose image is no pair of the calibration's size."""
        checked(scan.image, self.calibration)

    def searchable(self, inputs: FrontEndInput) -> Predictions:
        """The predictions with a view from about this distance, not in search backoff."""
        s = self.settings
        able = [
            p
            for p in inputs.predictions
            if p.landmark.signature.nearest(p.value[2]).zoom(p.value[2]) <= s.zoom
            and self.calibration.inside(p.value, s.border)
            and self.in_own_half(p.value[None])[0]
        ]
        self.frame += 1
        self.found, self.initialized = {}, []
        return [p for p in self.ready(able) if self.is_due(p.landmark, self.frame)]

    def is_due(self, landmark: Landmark, frame: int) -> bool:
        """Whether a landmark is measured in a frame, counted from 1."""
        return bool((frame + int(landmark.id)) % self.settings.update_interval == 0)

    def in_own_half(self, values: Array) -> Mask:
        """Mask (n,) of the measurements (n, .) in this front end's half of the image."""
        return np.ones(len(values), dtype=bool) if self.half is None else checkerboard_half(values) == self.half

    def find(self, inputs: FrontEndInput, predictions: Predictions) -> Iterator[tuple[int, Array]]:
        """Row and measurement (3,) of each landmark that is found."""
        seen = self.extractor.extract(inputs.scan.image)
        views = [prediction.landmark.signature.nearest(prediction.value[2]) for prediction in predictions]
        costs = self.costs(seen, predictions, views)
        pairs = mutual_nearest(costs, largest=self.settings.distance, ratio=self.settings.ratio)
        values, good = seen.values[pairs[:, 1]], np.ones(len(pairs), dtype=bool)
        if self.settings.patch and len(pairs):
            templates = np.array([views[i].patch for i in pairs[:, 0].tolist()])
            values, good = refine_by_templates(seen.image, templates, values, self.settings, free=True)
        good &= self.in_own_half(values)
        self.found = {predictions[i].landmark.id: j for i, j in pairs[good].tolist()}
        return zip(pairs[good, 0].tolist(), values[good], strict=True)

    def costs(self, seen: StereoFeatures, predictions: Predictions, views: list[LandmarkView]) -> Array:
        """Hamming distances (n, m) of predictions and features; inf where a feature is outside of the gate."""
        if not predictions or not len(seen):
            return np.zeros((len(predictions), len(seen)))
        bits = hamming_distances(np.array([view.descriptor for view in views]), seen.descriptors(0))
        expected, S = expected_values(predictions), expected_covariances(predictions)
        # A detected corner lies up to a pixel from the position at which the landmark was initialized.
        S = S + np.diag([1.0, 1.0, 0.5]) / 3
        z = seen.values[None] - expected[:, None]
        squares = (z * (z @ np.linalg.inv(S))).sum(-1)
        allowed: Array = np.where(squares <= gate(self.settings.probability, 3), bits, np.inf)
        allowed[:, self.reserved] = np.inf
        return allowed

    def new_landmarks(self, inputs: FrontEndInput, usable: Usable, count: int) -> Iterator[tuple[Array, LandmarkViews]]:
        """Value (3,) and views of up to `count` new landmarks, the strongest, separated from all in view."""
        seen = self.extractor.extract(inputs.scan.image)
        self.renew(seen, inputs)
        expected = np.array([prediction.value for prediction in inputs.predictions]).reshape(-1, 3)
        # Occluded landmarks in search backoff are not counted: new ones may replace them in the image.
        present = sum(prediction.landmark.id not in self.backoff for prediction in inputs.predictions)
        count, self.initialized = min(count, self.settings.max_in_view - present), []
        if count <= 0 or not len(seen):
            return
        good = usable(seen.values) & self.in_own_half(seen.values)
        good[self.reserved] = False
        taken = list(expected[:, :2])
        for i in np.argsort(-seen.strengths, kind="stable").tolist():
            if len(self.initialized) >= count:
                break
            place = seen.values[i, :2]
            if good[i] and (not taken or np.abs(np.array(taken) - place).max(1).min() >= self.settings.min_separation):
                taken.append(place)
                self.initialized.append(i)
                yield seen.values[i], LandmarkViews((self.view(seen, seen.values[i]),))

    def view(self, seen: StereoFeatures, value: Array) -> LandmarkView:
        """The present view of a measurement (3,): the descriptor of the nearest feature, and a patch."""
        nearest = int(np.abs(seen.values[:, :2] - value[:2]).max(1).argmin())
        patch = cut(seen.image[0], value[None, :2], max(self.settings.patch, 1) + 2)[0]
        return LandmarkView(seen.descriptors(0)[nearest], patch, float(value[2]))

    def renew(self, seen: StereoFeatures, inputs: FrontEndInput) -> None:
        """Add a view to inlier landmarks whose scale differs from all their views."""
        s = self.settings
        for prediction in inputs.predictions:
            landmark = prediction.landmark
            if not prediction.inlier or landmark.id not in self.found:
                continue
            d = float(prediction.measured[2])
            if landmark.signature.nearest(d).zoom(d) > np.sqrt(s.zoom):
                landmark.signature = landmark.signature.with_view(self.view(seen, prediction.measured), s.views)

    def dump(self) -> Any:
        """The state of every front end on images, the number of pairs processed, and the features of the last one that
        were matched to landmarks or initialized some."""
        return {**super().dump(), "frame": self.frame, "found": self.found, "initialized": self.initialized}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        super().restore(state)
        self.frame, self.initialized = state["frame"], state["initialized"]
        self.found = {int(number): row for number, row in state["found"].items()}
