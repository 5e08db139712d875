"""A front end for trees that nobody has numbered, and what the wheels of a car amount to: of the example Victoria Park.

The front end is a reader's own, as in chapter data_association; robot and sensor are slamlib's, in the plane.
"""

import math
from collections.abc import Callable, Set
from dataclasses import dataclass

import numpy as np

from slamlib.entities import Landmark
from slamlib.geometry.pose import from_frame
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array, Mask
from slamlib.motions.unicycle import UNICYCLE
from slamlib.records.ids import Id
from slamlib.slam.data_association.front_end import Detected, FrontEnd, FrontEndInput
from slamlib.slam.data_association.gates import mahalanobis_squared
from slamlib.slam.prediction import Predictions, expected_covariances, expected_values

AXLES, WHEEL = 2.83, 0.76  # [m]: distance of the axles; of the measured wheel from the middle of the rear axle


def driven(wheel: Array) -> tuple[Array, Array]:
    """Speed [m/s] and rate of turn [rad/s] (..., 2) of the rear axle's middle, with their Jacobians (..., 2, 2).

    wheel (..., 2): the speed of the left rear wheel [m/s], slower in a turn to the left, and the steering angle to the
    left [rad].
    """
    measured, tangent = wheel[..., 0], np.tan(wheel[..., 1])
    gain = 1 / (1 - tangent * WHEEL / AXLES)
    by_tangent = np.stack([measured * gain**2 * WHEEL / AXLES, measured * gain**2 / AXLES], axis=-1)
    by_steering = by_tangent * (1 + tangent**2)[..., None]
    by_wheel = np.stack([gain, gain * tangent / AXLES], axis=-1)
    return measured[..., None] * by_wheel, np.stack([by_wheel, by_steering], axis=-1)


def dead_reckoning(controls: Array, times: Array) -> Array:
    """Poses (n, 3) after each of the controls (n, 2), which last so long (n,) [s], from the origin on."""
    ahead, left, turns = UNICYCLE.step(np.zeros(3), controls, times).T  # each arc as if from the origin
    headings = np.cumsum(turns)
    x_y = np.cumsum((ahead + 1j * left) * np.exp(1j * (headings - turns)))
    return np.column_stack([x_y.real, x_y.imag, headings])


@dataclass(eq=False)
class Tentative:
    """What may become a landmark: where it was measured last in the world, how often, and in which scan last."""

    position: list[float]
    count: int
    scan: int


class NearestNeighbor(FrontEnd):
    """Unknown data association by individual compatibility, for sensors that measure the whole place of a point.

    A landmark and a measurement belong together if each is the other's nearest by the Mahalanobis distance, within the
    gate of probability `match`. A measurement beyond the gate `new` of all landmarks is a new one, once it has been
    measured `seen` times within `radius` [m], never more than `window` scans apart. What lies between the two gates is
    used for neither.
    """

    def __init__(
        self, match: float = 0.99, new: float = 1 - 1e-6, seen: int = 3, window: int = 10, radius: float = 1.0
    ) -> None:
        self.limits = chi2_quantile(match, 2), chi2_quantile(new, 2)
        self.seen, self.window, self.radius = seen, window, radius
        self.tentative: list[Tentative] = []
        self.scan = self.landmarks = 0
        self.row_of: dict[Landmark, int] = {}
        self.new = np.zeros(0, dtype=int)

    def searchable(self, inputs: FrontEndInput) -> Predictions:
        """Associate the whole scan, and return all predictions."""
        values, predictions = inputs.scan.points.values, inputs.predictions
        self.scan, self.row_of, self.new = self.scan + 1, {}, np.arange(len(values))
        if len(values) and predictions:
            predicted, S = expected_values(predictions), expected_covariances(predictions)
            z = inputs.sensor.calibration.sensor.manifold.minus(values, predicted[:, None])
            squares = mahalanobis_squared(z, S[:, None])
            nearest, least = squares.argmin(0), squares.min(0)
            mutual = squares.argmin(1)[nearest] == np.arange(len(values))
            matched = np.flatnonzero(mutual & (least < self.limits[0])).tolist()
            self.row_of = {predictions[nearest[row]].landmark: row for row in matched}
            self.new = np.flatnonzero(least > self.limits[1])
        return predictions

    def match(self, inputs: FrontEndInput, family: str, predictions: Predictions) -> tuple[Array, Mask]:
        """The measurements of the landmarks."""
        rows = np.array([self.row_of.get(p.landmark, -1) for p in predictions])
        values = inputs.scan.points.values.reshape(-1, 2)
        return np.vstack([values, [np.nan, np.nan]])[rows], rows >= 0

    def detect(
        self, inputs: FrontEndInput, family: str, known: Set[Id], usable: Callable[[Array], Mask], count: int
    ) -> list[Detected]:
        """Measurements of new landmarks that have been measured often enough."""
        self.tentative = [t for t in self.tentative if self.scan - t.scan <= self.window]
        values = inputs.scan.points.values[self.new]
        if family != "points" or not len(values):
            return []
        point = inputs.sensor.calibration.sensor.back_project(values)
        places = from_frame(inputs.sensor.camera, point[:, :3] / point[:, 3:]).tolist()
        found: list[Detected] = []
        for value, there in zip(values, places, strict=True):
            old = [t for t in self.tentative if t.scan < self.scan]
            near = min(old, key=lambda t: math.dist(t.position, there), default=None)
            if near is None or math.dist(near.position, there) > self.radius:
                self.tentative.append(Tentative(there, 1, self.scan))
                continue
            near.position, near.count, near.scan = there, near.count + 1, self.scan
            if near.count >= self.seen and len(found) < count:
                self.tentative.remove(near)
                found.append((self.landmarks, value, None))
                self.landmarks += 1
        return found
