"""Active search: a front end that searches for landmarks near their predictions, and for new ones elsewhere.

Each function is one step of section 6.1.3 of the toolbox's manual. Chapter active_search walks through them.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import compress
from typing import Annotated, Any

import numpy as np

from slamlib.entities import Landmark
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, Image
from slamlib.plain_data.fields import Count, Positive, Range, Share, Whole, check
from slamlib.records.ids import Id
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import Detected, FrontEndInput, Usable
from slamlib.slam.data_association.gates import gate
from slamlib.slam.prediction import PredictedMeasurement, Predictions
from slamlib.vision.appearance import Appearance, predict, recognizable
from slamlib.vision.corners import QUALITY, Corner, best_corner
from slamlib.vision.grid import Grid
from slamlib.vision.image_front_end import ImageFrontEnd
from slamlib.vision.patches import cut
from slamlib.vision.search import Match, register, search


def _point(landmark: Landmark) -> Array:
    """The estimated position of a landmark, a homogeneous point (4,) in the world frame."""
    return landmark.kind.to_frame(ORIGIN, landmark.block.mean)


@dataclass(frozen=True)
class ActiveSearchSettings:
    """Settings of active search. The names in parentheses are those of the toolbox.

    cells, skip_outer: of the grid in which new landmarks are searched for (Sen.imGrid). patch: side of a template [px],
    odd. quality: least quality of a new landmark's corner (Opt.init.featQualityTh). max_in_view: with so many landmarks
    in view, none is initialized. threshold: least score of a match (Opt.correct.appScTh). max_second_ratio: a match is
    ambiguous if another peak of its region has more than this share of its score. probability: that a region contains
    the true measurement, if the filter is consistent. largest: half the side [px] of the largest region that is
    searched; of a larger one, only the middle is. max_backoff: most frames for which a missed landmark is skipped.
    """

    cells: tuple[Whole, Whole] = (8, 6)
    skip_outer: bool = True
    patch: Annotated[int, Range(ge=3, le=101)] = 11
    quality: Positive = QUALITY
    max_in_view: Count = 30
    threshold: Share = 0.85
    max_second_ratio: Share = 0.95
    probability: Annotated[float, Range(gt=0, lt=1)] = 0.99
    largest: Annotated[int, Range(gt=0, unit="px")] = 40
    max_backoff: Count = 16

    def __post_init__(self) -> None:
        check(self)
        if not self.patch % 2:
            raise SlamlibError(f"ActiveSearchSettings: patch is odd, got {self.patch}")


class ActiveSearch(ImageFrontEnd[Appearance, ActiveSearchSettings]):
    """A front end for the points of one camera with an image."""

    size, signature_type = 2, Appearance

    def __init__(
        self, calibration: Calibration, rng: np.random.Generator, settings: ActiveSearchSettings | None = None
    ) -> None:
        """rng: draws the cells searched for new landmarks. Raises SlamlibError for a sensor without an image."""
        if calibration.image is None:
            raise SlamlibError(f"ActiveSearch: {calibration.sensor.name} has no image; give its calibration one")
        super().__init__(calibration, settings or ActiveSearchSettings())
        self.rng = rng
        self.grid = Grid(self.shape[::-1], self.settings.cells, self.settings.skip_outer)
        self.found: dict[Id, Match] = {}

    def searchable(self, inputs: FrontEndInput) -> Predictions:
        """2a: the predictions whose template lies in the image, and is seen similarly enough to a stored view."""
        values = np.array([prediction.value for prediction in inputs.predictions]).reshape(-1, 2)
        points = np.array([_point(prediction.landmark) for prediction in inputs.predictions]).reshape(-1, 4)
        looks_like = [prediction.landmark.signature for prediction in inputs.predictions]
        mask = recognizable(looks_like, inputs.sensor.camera, points)
        mask &= self.calibration.inside(values, self.settings.patch // 2 + 1)
        return self.ready(compress(inputs.predictions, mask))

    def find(self, inputs: FrontEndInput, predictions: Predictions) -> Iterator[tuple[int, Array]]:
        """Row and pixel (2,) of each landmark with an accepted match. 2c, 2h."""
        image = np.asarray(inputs.scan.image)
        self.found.clear()
        self.predict_appearances(inputs, predictions)
        for row, prediction in enumerate(predictions):
            if (template := prediction.predicted_patch) is None:
                continue
            found = self.scan(image, prediction)
            if found is not None and self.accepted(found):
                self.found[prediction.landmark.id] = found
                # To sub-pixel accuracy: where the template fits best up to a gain and an offset.
                pixel = register(image, template, found.pixel)
                yield row, found.pixel if pixel is None else pixel

    def predict_appearances(self, inputs: FrontEndInput, predictions: Predictions) -> None:
        """2e: predict each template as seen from the present pose; None where it cannot be predicted."""
        looks_like = [prediction.landmark.signature for prediction in predictions]
        points = np.array([_point(prediction.landmark) for prediction in predictions]).reshape(-1, 4)
        templates = predict(looks_like, inputs.sensor.camera, self.calibration, points, self.settings.patch)
        for prediction, template in zip(predictions, templates, strict=True):
            prediction.predicted_patch = template

    def scan(self, image: Image, prediction: PredictedMeasurement) -> Match | None:
        """2d and 2f: the best match of the template in the ellipse of the predicted measurement, or None."""
        s = self.settings
        assert prediction.predicted_patch is not None, "find skips those without a template"
        reach = np.sqrt(gate(s.probability, 2) * prediction.S.diagonal().max())
        S = prediction.S * min(1.0, s.largest / reach) ** 2
        found = search(image, prediction.predicted_patch, prediction.value, S, probability=s.probability)
        if found is not None:
            prediction.score, prediction.found_patch = found.score, cut(image, np.rint(found.pixel), s.patch)
        return found

    def accepted(self, found: Match) -> bool:
        """2g: whether the score is high enough, and no other peak of the region nearly as high."""
        return found.score >= self.settings.threshold and found.second <= self.settings.max_second_ratio * found.score

    def new_landmarks(
        self, inputs: FrontEndInput, usable: Usable, count: int
    ) -> Iterator[tuple[Array, Appearance | None]]:
        """Pixel and appearance of up to `count` landmarks, each in a cell of its own without landmarks. 1a to 1h."""
        image = np.asarray(inputs.scan.image)
        self.renew(image, inputs)
        seen = np.array([prediction.value for prediction in inputs.predictions]).reshape(-1, 2)
        for corner in self.new_corners(image, seen, usable, count):
            yield corner.pixel, self.signature(image, inputs, corner)

    def new_corners(self, image: Image, seen: Array, usable: Usable, count: int) -> list[Corner]:
        """1a to 1e: the best corners of cells without landmarks, drawn at random, if good enough; each cell once.

        seen (n, 2): predicted pixels of landmarks. A corner on the border of two cells belongs to both: one nearer to
        another than a patch is not taken, so that no point is measured twice as if independently.
        """
        s, taken, corners = self.settings, self.grid.occupied(seen), list[Corner]()  # 1a, 1b
        while len(corners) < min(count, s.max_in_view - len(seen)):
            cell = self.grid.free(taken, self.rng)  # 1c
            if cell is None:
                break
            taken[cell] = True
            corner = best_corner(image, self.grid.rectangle(cell), quality=s.quality, border=s.patch)  # 1d, 1e
            if corner is not None and usable(corner.pixel[None])[0]:
                others = np.concatenate([seen, *(c.pixel[None] for c in corners)])
                if (np.abs(others - corner.pixel).max(-1) >= s.patch).all():
                    corners.append(corner)
        return corners

    def signature(self, image: Image, inputs: FrontEndInput, corner: Corner) -> Appearance | None:
        """1f: the landmark's appearance, and the camera pose it was seen from; None where no patch can be cut."""
        return Appearance.taken(image, corner.pixel, inputs.sensor.camera, self.settings.patch, corner.quality)

    def renew(self, image: Image, inputs: FrontEndInput) -> None:
        """Add a patch of this image to landmarks with a reliable match and a changed appearance."""
        camera = inputs.sensor.camera
        for prediction in inputs.predictions:
            landmark = prediction.landmark
            found = self.found.get(landmark.id) if prediction.inlier else None
            if found is not None and landmark.signature.needs_renewal(found, camera, _point(landmark)):
                landmark.signature = landmark.signature.renewed(image, found, prediction.predicted_patch, camera)

    def initialize_at(self, inputs: FrontEndInput, family: str, values: Array) -> list[Detected | None]:
        """Detect landmarks at given pixels (n, 2), whatever their texture; None where no patch can be cut."""
        signatures = [self.signature(inputs.scan.image, inputs, Corner(pixel, 0.0)) for pixel in values]
        return [None if s is None else (self.new_id(set()), p, s) for p, s in zip(values, signatures, strict=True)]

    def dump(self) -> Any:
        """The state of every front end on images, and that of the random numbers."""
        return {"rng": self.rng.bit_generator.state, **super().dump()}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        super().restore(state)
        self.rng.bit_generator.state = state["rng"]
