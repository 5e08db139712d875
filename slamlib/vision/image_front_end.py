"""Components of runs on images: the base of all front ends on images, and the source of the robot's motion."""

import time
from collections.abc import Callable, Iterable, Iterator, Set
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image, Mask
from slamlib.plain_data.fields import read, written
from slamlib.records.ids import Id
from slamlib.records.inputs import Control, Scan
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Slam
from slamlib.slam.data_association.front_end import Detected, FrontEnd, FrontEndInput, Usable
from slamlib.slam.prediction import PredictedMeasurement, Predictions


class Stopwatch(dict[str, float]):
    """A dictionary of processor seconds by part; `timed` adds to it."""

    def __init__(self, *parts: str) -> None:
        super().__init__(dict.fromkeys(parts, 0.0))

    @contextmanager
    def timed(self, part: str) -> Iterator[None]:
        """Count the time of a `with` block to a part."""
        began = time.perf_counter()
        yield
        self[part] += time.perf_counter() - began


@dataclass
class Backoff:
    """Search backoff of a landmark: missed so often in a row, it is not searched for in so many frames."""

    misses: int = 0
    frames: int = 0

    def is_over(self) -> bool:
        """Whether it may be searched for now; called once per frame."""
        self.frames -= 1
        return self.frames < 0

    def increased(self, max_backoff: int) -> "Backoff":
        """After one more miss: 1, 2, 4 ... frames, at most `max_backoff`."""
        return Backoff(self.misses + 1, min(2**self.misses, max_backoff))


class SearchSettings(Protocol):
    """What every front end on images has among its settings."""

    @property
    def max_backoff(self) -> int: ...


Signature = TypeVar("Signature")  # of a front end's landmarks
Settings = TypeVar("Settings", bound=SearchSettings)  # of a front end


class ImageFrontEnd(Generic[Signature, Settings]):
    """Base of a front end on one sensor's image; a subclass defines `searchable`, and two methods called here.

    find(inputs, predictions): rows of the predictions whose landmarks are found, each with its measurement (m,).
    new_landmarks(inputs, usable, count): measurements of up to `count` new landmarks, with their signatures.

    An occluded landmark is usually still occluded in the next frame. Without backoff, occluded landmarks, which are
    never updated, would soon be the most uncertain ones, and always be selected first. backoff: by landmarks' ids;
    last: the last id given; seconds: spent so far in "search" and in "detection". size: dimension of a measurement;
    signature_type: the dataclass of a landmark's signature.
    """

    size: int
    signature_type: type[Signature]
    searchable: Callable[[FrontEndInput], Predictions]
    find: Callable[[FrontEndInput, Predictions], Iterable[tuple[int, Array]]]
    new_landmarks: Callable[[FrontEndInput, Usable, int], Iterable[tuple[Array, Signature | None]]]

    def __init__(self, calibration: Calibration, settings: Settings) -> None:
        self.calibration, self.settings = calibration, settings
        self.seconds = Stopwatch("search", "detection")
        self.last = 0
        self.backoff: dict[Id, Backoff] = {}

    @property
    def shape(self) -> tuple[int, int]:
        """(height, width) of the calibration's image [px]."""
        assert self.calibration.image is not None, "checked by the front end's own __init__"
        width, height = self.calibration.image.astype(int).tolist()
        return height, width

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan without an image, or with one of another size than the calibration's."""
        if scan.image is None or np.shape(scan.image) != self.shape:
            found = "no image" if scan.image is None else f"one of shape {np.shape(scan.image)}"
            name = type(self).__name__
            raise SlamlibError(f"{name}: an image of (height, width) = {self.shape} is expected, got {found}")

    def ready(self, predictions: Iterable[PredictedMeasurement]) -> Predictions:
        """The predictions of landmarks that are not in search backoff; called once per frame."""
        return [p for p in predictions if self.backoff.get(p.landmark.id, Backoff()).is_over()]

    def match(self, inputs: FrontEndInput, family: str, predictions: Predictions) -> tuple[Array, Mask]:
        """Measurements (n, m) of the predictions' landmarks, nan where not found, and the mask (n,) of those found.

        Landmarks not found are in search backoff, the longer the more often in a row; the others are not.
        """
        measured = np.full((len(predictions), self.size), np.nan)
        with self.seconds.timed("search"):
            for row, value in self.find(inputs, predictions):
                measured[row] = value
        found = np.isfinite(measured[:, 0])
        for prediction, is_found in zip(predictions, found.tolist(), strict=True):
            before = self.backoff.pop(prediction.landmark.id, Backoff())
            if not is_found:
                self.backoff[prediction.landmark.id] = before.increased(self.settings.max_backoff)
        return measured, found

    def detect(self, inputs: FrontEndInput, family: str, known: Set[Id], usable: Usable, count: int) -> list[Detected]:
        """Up to `count` new landmarks (id, measurement, signature)."""
        with self.seconds.timed("detection"):
            return [(self.new_id(known), *new) for new in self.new_landmarks(inputs, usable, count)]

    def new_id(self, known: Set[Id]) -> int:
        """A number that no landmark has had; known: ids of the landmarks in the map."""
        self.last = max(self.last, *(number for number in known if isinstance(number, int)), 0) + 1
        return self.last

    def dump(self) -> Any:
        """The last id given, and the landmarks in search backoff."""
        return {"last": self.last, "backoff": written(self.backoff)}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        self.last = state["last"]
        self.backoff = {int(number): Backoff(**backoff) for number, backoff in state["backoff"].items()}

    def pack(self, signature: Signature | None) -> Any:
        """A landmark's signature as plain data."""
        return written(signature)

    def unpack(self, packed: Any) -> Signature:
        """The signature that `pack` packed."""
        return read(self.signature_type, packed)


class FamilyFrontEnd(FrontEnd, Protocol):
    """A front end of one family's landmarks, as an ImageFrontEnd is."""

    last: int

    @property
    def settings(self) -> SearchSettings: ...

    @property
    def seconds(self) -> Stopwatch: ...

    @property
    def signature_type(self) -> type: ...


class PointFrontEnd(FamilyFrontEnd, Protocol):
    """A front end of points, as ActiveSearch is."""

    def initialize_at(self, inputs: FrontEndInput, family: str, values: Array) -> list[Detected | None]:
        """Landmarks at given measurements (n, 2); None where there can be none."""


class CombinedFrontEnd:
    """Two front ends for one camera, of points and of segments: each family has its own."""

    def __init__(self, points: PointFrontEnd, segments: FamilyFrontEnd) -> None:
        self.points, self.settings = points, points.settings
        self.front_ends: dict[str, FamilyFrontEnd] = {"points": points, "segments": segments}

    @property
    def seconds(self) -> dict[str, float]:
        """Seconds spent so far by both, by part."""
        return {part: sum(f.seconds[part] for f in self.front_ends.values()) for part in self.points.seconds}

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that they cannot process."""
        self.points.check(scan)

    def searchable(self, inputs: FrontEndInput) -> Predictions:
        """The predictions that their front ends can search for."""
        return [p for name, f in self.front_ends.items() for p in f.searchable(_own(inputs, name))]

    def match(self, inputs: FrontEndInput, family: str, predictions: Predictions) -> tuple[Array, Mask]:
        """Measurements (n, m) and mask (n,) from the family's front end."""
        return self.front_ends[family].match(_own(inputs, family), family, predictions)

    def detect(self, inputs: FrontEndInput, family: str, known: Set[Id], usable: Usable, count: int) -> list[Detected]:
        """New landmarks of the family's front end, with ids that neither front end has given before."""
        given = {f.last for f in self.front_ends.values()}
        return self.front_ends[family].detect(_own(inputs, family), family, known | given, usable, count)

    def initialize_at(self, inputs: FrontEndInput, family: str, values: Array) -> list[Detected | None]:
        """Landmarks at given measurements (n, 2); points only."""
        self.points.last = max(f.last for f in self.front_ends.values())
        return self.points.initialize_at(_own(inputs, family), family, values)

    def dump(self) -> Any:
        """The states of both, by family."""
        return {name: f.dump() for name, f in self.front_ends.items()}

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
        for name, f in self.front_ends.items():
            f.restore(state[name])

    def pack(self, signature: Any) -> Any:
        """A signature as plain data, with the family whose front end gave it."""
        name = next(name for name, f in self.front_ends.items() if isinstance(signature, f.signature_type))
        return {"family": name, "signature": self.front_ends[name].pack(signature)}

    def unpack(self, packed: Any) -> Any:
        """The signature that `pack` packed."""
        return self.front_ends[packed["family"]].unpack(packed["signature"])


def _own(inputs: FrontEndInput, family: str) -> FrontEndInput:
    """The front-end input with the predictions of one family alone."""
    return replace(inputs, predictions=[p for p in inputs.predictions if p.family.name == family])


class MotionSource:
    """Source of the controls between images; this one gives none: the motion model predicts with its own noise.

    name: the key it is selected by. front_end: the filter's, of the sensor of the images. seconds: spent so far, by
    part, besides the front end's.
    """

    name = "constant-velocity"

    def __init__(self, front_end: FrontEnd) -> None:
        self.front_end = front_end
        self.seconds = Stopwatch()

    def control(self, image: Image | None, dt: float, slam: Slam) -> Control | None:
        """The control of the step of dt [s] to this image, before Slam.step; None: zeros, with the robot's noise."""
        return None

    def counts(self, slam: Slam) -> dict[str, float]:
        """Columns of the run's history that are not the filter's own, after its frame."""
        return {"near": np.nan}

    def dump(self) -> Any:
        """Its state as plain data, without that of the front end, which is in the filter's file."""

    def restore(self, state: Any) -> None:
        """Restore the state that `dump` returned."""
