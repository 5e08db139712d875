"""How the filter treats points: expectation, innovation, first estimate, conversion to Euclidean ones."""

from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.data.snapshots import MapView
from slamlib.kalman.small_matrices import corners
from slamlib.landmarks import POINTS
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.linearity import beyond_infinity, should_convert, to_euclidean
from slamlib.landmarks.point import PointLandmark
from slamlib.manifolds import Array, Mask
from slamlib.observation.points import AHEAD, initialize, observe_from
from slamlib.sensors.sensor import Calibration
from slamlib.slam.entities import Landmark, MountedSensor
from slamlib.slam.options import Options
from slamlib.slam.predicted_measurement import Expected, Innovation, by_columns, columns_of, means_of, place_of


@dataclass(frozen=True)
class PointFamily:
    """Everything about points that the filter asks for."""

    options: Options
    name: str = "points"
    kinds: type = PointLandmark

    @property
    def new(self) -> PointLandmark | None:
        """The parametrization of new points, or None for none."""
        return POINTS[self.options.points] if self.options.points else None

    def sees(self, sensor: MountedSensor) -> bool:
        """Every sensor measures points."""
        return True

    def usable(self, sensor: MountedSensor, values: Array) -> Mask:
        """Mask of the measurements (n, m) that a landmark may begin with: not too near the image's border."""
        image = sensor.calibration.image
        return sensor.calibration.inside(values, 0.0 if image is None else self.options.margin * image[0])

    def expect(self, sensor: MountedSensor, landmarks: list[Landmark]) -> Expected:
        """What the sensor should measure of landmarks of one kind; those out of view are left out."""
        kind, means = landmarks[0].kind, means_of(landmarks)
        place = place_of(sensor)
        found = observe_from(kind, sensor.calibration, place.pose, means)
        seen, J = np.flatnonzero(found.visible), found.jacobians
        if not len(seen):
            return Expected.nothing(sensor.calibration.sensor.size)
        looked, value = [landmarks[i] for i in seen.tolist()], found.value.take(seen, axis=0)
        by = by_columns(place, J.camera.take(seen, axis=0), J.landmark.take(seen, axis=0))
        return Expected(looked, value, value, by, columns_of(sensor, looked))

    def innovate(self, sensor: MountedSensor, expected: Expected, measured: Array) -> Innovation:
        """Measured minus expected (n, m), in the space of the measurement."""
        z = sensor.calibration.sensor.space.minus(measured, expected.value)
        noise = sensor.calibration.noise
        return Innovation(z, expected.by, noise[None].repeat(len(z), axis=0))

    def innovation(self, sensor: MountedSensor, landmark: Landmark, measured: Array) -> Innovation | None:
        """The innovation of one landmark at the present means; None if it should not be seen from there."""
        calibration, place = sensor.calibration, place_of(sensor)
        found = observe_from(landmark.kind, calibration, place.pose, landmark.block.mean)
        if not found.visible:
            return None
        J = found.jacobians
        z = calibration.sensor.space.minus(measured, found.value)
        return Innovation(z, by_columns(place, J.camera, J.landmark), calibration.noise)

    def inner(self, calibration: Calibration, in_frame: Array) -> Array:
        """Measurements expected of homogeneous points (..., 4) in the sensor's frame; nan where it cannot see them."""
        seen = calibration.visible(in_frame)[..., None]
        return np.where(seen, calibration.project(np.where(seen, in_frame, AHEAD)), np.nan)

    def begin(self, sensor: MountedSensor, kind: PointLandmark, value: Array) -> tuple[Array, Array, list[Array]]:
        """Mean, own noise and Jacobians by robot and mount of a point that is seen for the first time. Chapter 15."""
        mean, std = self.options.inverse_distance
        calibration = sensor.calibration
        asks = len(calibration.sensor.back_project.arguments) - 1 - len(calibration.sensor.parameters)
        prior = [np.array([mean])] * asks
        x, J = initialize(kind, calibration, sensor.robot.pose, sensor.mount, value, *prior)
        own = J.measurement @ calibration.noise @ J.measurement.T
        if asks:
            own = own + J.unmeasured @ J.unmeasured.T * std**2
        return x, own, [J.robot, J.mount]

    def abscissas(self, kind: PointLandmark) -> None:
        """Points have no ends."""

    def corrected(self, belief: Belief, sensor: MountedSensor, landmarks: list[Landmark], measured: Array) -> None:
        """After a correction: points of one kind that are known well enough become Euclidean. Chapter 11."""
        kind = landmarks[0].kind
        if not self.options.convert or kind is EUC_POINT:
            return
        place = place_of(sensor)
        columns, dof = columns_of(sensor, landmarks), landmarks[0].block.dof
        T = np.zeros((dof + 6, columns.shape[1]))  # from (robot, mount, landmark) to (landmark, camera)
        T[:dof, -dof:], T[dof:, :-dof] = np.eye(dof), place.by
        means, P = means_of(landmarks), corners(belief.matrix, columns)
        ripe = should_convert(kind, means, P, place.pose, self.options.convert_below, T)
        for landmark, is_ripe in zip(landmarks, ripe.tolist(), strict=True):
            if is_ripe:
                belief.replace(landmark.block, EUC_POINT.space, *to_euclidean(kind, landmark.block.mean))
                landmark.kind = EUC_POINT

    def lost(self, belief: Belief, landmarks: list[Landmark]) -> set[Landmark]:
        """The landmarks, of one kind, that lie beyond infinity: no point is there. Chapter 11."""
        kind = landmarks[0].kind
        if kind is EUC_POINT:
            return set()
        means = means_of(landmarks)
        if (kind.to_frame(_WORLD, means)[:, 3] >= 0).all():
            return set()  # as mostly: quick, without Jacobians
        beyond = beyond_infinity(kind, means, _own(belief, landmarks))
        return {landmarks[i] for i in np.flatnonzero(beyond)}

    def view(self, belief: Belief, landmarks: list[Landmark]) -> MapView:
        """Points in the world and their covariances; nan for those at infinity."""
        geometry, covariance = np.full((len(landmarks), 3), np.nan), np.full((len(landmarks), 3, 3), np.nan)
        for i, landmark in enumerate(landmarks):
            kind, mean = landmark.kind, landmark.block.mean
            h, J = kind.to_frame.jac(_WORLD, mean)
            if h[3] > 0:
                by = (J.landmark[:3] - np.outer(h[:3], J.landmark[3]) / h[3]) / h[3]
                geometry[i], covariance[i] = h[:3] / h[3], by @ belief.covariance(landmark.block) @ by.T
        kinds = tuple(landmark.kind.name for landmark in landmarks)
        converged = np.array([landmark.kind is EUC_POINT for landmark in landmarks], dtype=bool)
        return MapView(np.array([lm.id for lm in landmarks], dtype=int), kinds, geometry, covariance, converged)


_WORLD = np.array([0.0, 0, 0, 1, 0, 0, 0])


def _own(belief: Belief, landmarks: list[Landmark]) -> Array:
    """Covariances (n, dof, dof) of landmarks of one kind."""
    rows = np.array([lm.block.start for lm in landmarks])[:, None] + np.arange(landmarks[0].block.dof)
    return corners(belief.matrix, rows)
