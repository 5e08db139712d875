"""A car, its laser, and a front end for trees that nobody has numbered: what the example Victoria Park adds to slamlib.

The models are a reader's own, as in chapter your_own_model: their code is generated in memory when it is first needed.
The car drives in the plane: height, roll and pitch of its pose have no uncertainty, so that they, and the height of
the trees in the laser's plane, stay zero, and cost nothing but their rows.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.entities import Landmark
from slamlib.geometry.pose import Pose, compose, from_frame
from slamlib.geometry.quaternion import exponential
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Angle, Array, Euclidean, Mask, Product
from slamlib.models import model
from slamlib.motions import Motion
from slamlib.sensors.sensor import Calibration, Sensor
from slamlib.slam.data_association.front_end import Detected, FrontEnd, FrontEndInput
from slamlib.slam.data_association.gates import mahalanobis_squared
from slamlib.slam.prediction import Predictions

AXLES, WHEEL = 283, 76  # [cm]: distance of the axles; of the measured wheel from the middle of the rear axle
RangeYaw = Product("range and yaw", Euclidean(1), Angle(1))


@model(state=Pose, control=2, dt=(), returns=Pose)
def drive(state: Array, control: Array, dt: Array) -> Array:
    """Pose of the rear axle's middle after dt [s] of wheel speed [m/s] and steering angle to the left [rad].

    It moves straight, at half of the turn: for short steps. The speed is that of a wheel left of the middle, which is
    slower in a turn to the left.
    """
    tangent = sin(control[1]) / cos(control[1])
    ahead = control[0] * dt / (1 - tangent * WHEEL / AXLES)
    half = exponential(np.array([0, 0, 1]) * ahead * tangent * 50 / AXLES)
    turn, way = np.concatenate([np.zeros(3), half]), np.concatenate([np.array([1, 0, 0]) * ahead, half])
    return compose(compose(state, turn), way)


@model(point=4, returns=RangeYaw)
def project(point: Array) -> Array:
    """Range [m] and yaw to the left [rad] of a point, in the laser's plane."""
    x, y, _, w = point
    return np.array([sqrt(x * x + y * y) / w, arctan2(y, x)])


@model(measurement=RangeYaw)
def back_project(measurement: Array) -> Array:
    """Unit ray in the laser's plane, and inverse distance [1/m]."""
    distance, yaw = measurement
    return np.array([cos(yaw), sin(yaw), 0, 1 / distance])


def visible(point: Array, calibration: Calibration) -> Mask:
    """Mask of the points ahead of the laser, nearer than the limit `far` [m]."""
    x, y, _, w = np.moveaxis(np.asarray(point), -1, 0)
    seen: Mask = (x > 0) & (w > 0) & (np.hypot(x, y) < calibration.limits["far"] * w)
    return seen


CAR = Motion("car", Pose, control=2, step=drive, angles=(1,))
LASER = Sensor("laser", project, back_project, (), visible, limits=("far",))


@dataclass(eq=False)
class Tentative:
    """What may become a landmark: where it was measured last in the world (3,), how often, and in which scan last."""

    position: Array
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
            predicted, S = (np.array([getattr(p, name) for p in predictions]) for name in ("value", "S"))
            z = inputs.sensor.calibration.sensor.manifold.minus(values, predicted[:, None])
            shape = z.shape[:2]
            squares = mahalanobis_squared(z.reshape(-1, 2), S.repeat(shape[1], axis=0)).reshape(shape)
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
        self, inputs: FrontEndInput, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[Detected]:
        """Measurements of new landmarks that have been measured often enough."""
        self.tentative = [t for t in self.tentative if self.scan - t.scan <= self.window]
        values = inputs.scan.points.values[self.new]
        if family != "points" or not len(values):
            return []
        point = inputs.sensor.calibration.back_project_jac(values)[0]
        found: list[Detected] = []
        for value, there in zip(values, from_frame(inputs.sensor.camera, point[:, :3] / point[:, 3:]), strict=True):
            old = [t for t in self.tentative if t.scan < self.scan]
            near = min(old, key=lambda t: float(np.linalg.norm(t.position - there)), default=None)
            if near is None or np.linalg.norm(near.position - there) > self.radius:
                self.tentative.append(Tentative(there, 1, self.scan))
                continue
            near.position, near.count, near.scan = there, near.count + 1, self.scan
            if near.count >= self.seen and len(found) < count:
                self.tentative.remove(near)
                found.append((self.landmarks, value, None))
                self.landmarks += 1
        return found
