"""A front end for a stereo sensor: landmarks are found again by their descriptors, within the filter's own gate."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.data.records import Scan
from slamlib.datasets.pairs import checked
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import Sight
from slamlib.slam.data_association.gates import gate
from slamlib.vision.front_end import PictureFrontEnd
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import Eyes, Observed, remeasured
from slamlib.vision.stereo.matching import distances, mutual
from slamlib.vision.stereo.odometry import halves
from slamlib.vision.stereo.refine import cut


@dataclass(frozen=True, eq=False)
class View:
    """Descriptor (32,), patch (s, s) round the left pixel, its margin of one included, and disparity [px]."""

    descriptor: Array
    patch: Array
    disparity: float

    def zoom(self, disparity: float) -> float:
        """How much larger or smaller it looks at another disparity, 1 or more: its distance changed by as much."""
        ratio = disparity / self.disparity
        return max(ratio, 1 / ratio) if ratio > 0 else np.inf


@dataclass(frozen=True, eq=False)
class Views:
    """All views of a landmark, the first one first. The first is never given up, so that a chain does not drift."""

    all: tuple[View, ...]

    def nearest(self, disparity: float) -> View:
        """The one whose distance is most like that of a disparity [px]; of equals the oldest."""
        return min(self.all, key=lambda view: view.zoom(disparity))

    def with_view(self, view: View, most: int) -> "Views":
        """With one more; of more than `most`, the oldest but the first goes."""
        first, rest = self.all[:1], (*self.all[1:], view)
        return Views(first + rest[-(most - 1) :] if most > 1 else first)

    def pack(self) -> Any:
        """Plain data, for JSON: nothing is lost."""
        return [[v.descriptor.tolist(), v.patch.tolist(), v.disparity] for v in self.all]

    @classmethod
    def unpack(cls, packed: Any) -> "Views":
        """What `pack` packed."""
        return cls(tuple(View(np.array(d, np.uint8), np.array(p, float), float(z)) for d, p, z in packed))


class StereoSearch(PictureFrontEnd):
    """Measures (u, v, disparity) [px] in the pair that is a scan's image, an array (2, h, w) of uint8.

    A landmark keeps its number as long as the filter keeps it: however long it was out of view, it is matched again by
    its descriptor as soon as it lies in the gate.
    """

    def __init__(
        self,
        calibration: Calibration,
        settings: StereoSettings | None = None,
        *,
        eyes: Eyes | None = None,
        half: int | None = None,
    ) -> None:
        """eyes: shared with an odometry, so that a pair is looked at once. half: 0 or 1 measures in a part of the
        picture only, and leaves the other half to an odometry (E21). Raises SlamlibError for another sensor."""
        if calibration.image is None or calibration.sensor.size != 3 or "baseline" not in calibration.given:
            raise SlamlibError(
                f"StereoSearch: a stereo sensor with an image is wanted, not {calibration.sensor.name}: "
                "SensorSetup(type='stereo', image=(w, h), parameters={'intrinsics': ..., 'baseline': ...})"
            )
        super().__init__(calibration)
        self.half = half
        self.settings = settings or (eyes.settings if eyes else StereoSettings())
        self.eyes = eyes or Eyes(calibration, self.settings)
        self.found: dict[int, int] = {}  # rows of the present features, by the landmarks that they show
        self.others = np.zeros(0, dtype=int)  # rows of the present features that are left to an odometry
        self.begun: list[int] = []  # rows of the present features that began a landmark
        self.frame = 0

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan whose image is no pair of the calibration's size."""
        checked(scan.image, self.calibration)

    def findable(self, sight: Sight) -> list[Any]:
        """The looks at what was seen from about this distance before, and does not rest."""
        s = self.settings
        able = [
            look
            for look in sight.looks
            if look.landmark.signature.nearest(look.value[2]).zoom(look.value[2]) <= s.zoom
            and self.calibration.inside(look.value, s.border)
            and self.mine(look.value[None])[0]
        ]
        self.frame += 1
        self.found, self.begun = {}, []
        return [look for look in self.awake(able) if self.has_turn(look.landmark, self.frame)]

    def has_turn(self, landmark: Any, frame: int) -> bool:
        """Whether a landmark is measured in a frame, counted from 1."""
        return bool((frame + landmark.id) % self.settings.turns == 0)

    def mine(self, values: Array) -> Mask:
        """Mask (n,) of the measurements (n, .) in this front end's part of the picture."""
        return np.ones(len(values), dtype=bool) if self.half is None else halves(values) == self.half

    def match(self, sight: Sight, family: str, looks: list[Any]) -> tuple[Array, Mask]:
        """Measurements (n, 3) of what is looked for, nan where it is not found, and the mask (n,) of those found."""
        measured = np.full((len(looks), 3), np.nan)
        with self.seconds.timed("search"):
            seen = self.eyes.look(sight.scan.image)
            views = [look.landmark.signature.nearest(look.value[2]) for look in looks]
            pairs = mutual(self.costs(seen, looks, views), largest=self.settings.distance, ratio=self.settings.ratio)
            values, good = self.measure(seen, [views[i] for i in pairs[:, 0].tolist()], seen.values[pairs[:, 1]])
            good &= self.mine(values)
            measured[pairs[good, 0]] = values[good]
            self.found = {looks[i].landmark.id: j for i, j in pairs[good].tolist()}
        self.remember(looks, [look.landmark.id in self.found for look in looks], self.settings.longest)
        return measured, np.isfinite(measured[:, 0])

    def costs(self, seen: Observed, looks: list[Any], views: list[View]) -> Array:
        """Differing bits (n, m) of looks and features; inf where a feature lies outside the look's gate."""
        if not looks or not len(seen):
            return np.zeros((len(looks), len(seen)))
        bits = distances(np.array([view.descriptor for view in views]), seen.descriptors(0))
        Z = np.array([look.Z for look in looks])
        # What is detected lies on a corner of this picture, up to a pixel from where the landmark was begun.
        Z = Z + np.diag([1.0, 1.0, 0.5]) / 3
        z = seen.values[None] - np.array([look.value for look in looks])[:, None]
        squares = (z * (z @ np.linalg.inv(Z))).sum(-1)
        allowed: Array = np.where(squares <= gate(self.settings.probability, 3), bits, np.inf)
        allowed[:, self.others] = np.inf
        return allowed

    def measure(self, seen: Observed, views: list[View], values: Array) -> tuple[Array, Mask]:
        """Values (n, 3) refined with the patches of the views, and the mask of those to believe."""
        if not self.settings.patch or not views:
            return values, np.ones(len(values), dtype=bool)
        templates = np.array([view.patch for view in views])
        return remeasured(seen.image, templates, values, self.settings, free=True)

    def detect(
        self, sight: Sight, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[tuple[int, Array, Any]]:
        """Up to `count` new landmarks (id, value (3,), signature), the strongest, apart from all that is in view."""
        with self.seconds.timed("detection"):
            seen = self.eyes.look(sight.scan.image)
            self.renew(seen, sight)
            expected = np.array([look.value for look in sight.looks]).reshape(-1, 3)
            # What is hidden, and rests, leaves its place to what stands before it.
            present = sum(look.landmark.id not in self.rests for look in sight.looks)
            count = min(count, self.settings.enough - present)
            rows = self.begun = self.fresh(seen, expected, usable, count)
            return [(self.new_id(known), seen.values[i], Views((self.view(seen, seen.values[i]),))) for i in rows]

    def fresh(self, seen: Observed, expected: Array, usable: Callable[[Array], Mask], count: int) -> list[int]:
        """Rows of features far enough from all that is expected (n, 3) and from each other, the strongest first."""
        if count <= 0 or not len(seen):
            return []
        good = usable(seen.values) & self.mine(seen.values)
        good[self.others] = False
        taken, rows = list(expected[:, :2]), list[int]()
        for i in np.argsort(-seen.strengths, kind="stable").tolist():
            place = seen.values[i, :2]
            if good[i] and (not taken or np.abs(np.array(taken) - place).max(1).min() >= self.settings.apart):
                taken.append(place)
                rows.append(i)
            if len(rows) == count:
                break
        return rows

    def view(self, seen: Observed, value: Array) -> View:
        """How a feature looks now: the descriptor of the feature nearest to the value."""
        nearest = int(np.abs(seen.values[:, :2] - value[:2]).max(1).argmin())
        patch = cut(seen.image[0], value[None, :2], max(self.settings.patch, 1) + 2)[0]
        return View(seen.descriptors(0)[nearest], patch, float(value[2]))

    def renew(self, seen: Observed, sight: Sight) -> None:
        """Landmarks that were believed, and look larger or smaller than ever, get one more view."""
        s = self.settings
        for look in sight.looks:
            landmark = look.landmark
            if not look.inlier or landmark.id not in self.found:
                continue
            d = float(look.measured[2])
            if landmark.signature.nearest(d).zoom(d) > np.sqrt(s.zoom):
                landmark.signature = landmark.signature.with_view(self.view(seen, look.measured), s.views)

    def dump(self) -> Any:
        """How many pairs it looked at, beside the state of every front end on pictures."""
        return {**super().dump(), "frame": self.frame}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        super().restore(state)
        self.frame = state["frame"]

    def pack(self, signature: Any) -> Any:
        """A landmark's views as plain data."""
        return signature.pack()

    def unpack(self, packed: Any) -> Any:
        """The views that `pack` packed."""
        return Views.unpack(packed)
