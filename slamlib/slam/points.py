"""How the filter treats points: expectation, innovation, first estimate, conversion to Euclidean ones."""

from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.geometry.pose import compose
from slamlib.landmarks import POINTS
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.linearity import beyond_infinity, should_convert, to_euclidean
from slamlib.landmarks.point import PointLandmark
from slamlib.observation import initialize, observe
from slamlib.slam.entities import Landmark, MountedSensor
from slamlib.slam.expected import Expected, Innovation, by_columns, columns_of, means_of
from slamlib.slam.options import Options
from slamlib.snapshots import MapView
from slamlib.spaces import Array


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

    def usable(self, sensor: MountedSensor, values: Array) -> Array:
        """Mask of the measurements (n, m) that a landmark may begin with: not too near the image's border."""
        image = sensor.calibration.image
        return sensor.calibration.inside(values, 0.0 if image is None else self.options.margin * image[0])

    def expect(self, sensor: MountedSensor, landmarks: list[Landmark]) -> Expected:
        """What the sensor should measure of landmarks of one kind; those out of view are left out."""
        kind, means = landmarks[0].kind, means_of(landmarks)
        found = observe(kind, sensor.calibration, sensor.robot.pose, sensor.mount, means)
        seen, J = found.visible, found.jacobians
        looked = [landmark for landmark, s in zip(landmarks, seen.tolist(), strict=True) if s]
        by = by_columns(sensor, J.robot, J.mount, J.landmark)
        return Expected(looked, found.value[seen], found.value[seen], by[seen], columns_of(sensor, landmarks)[seen])

    def innovate(self, sensor: MountedSensor, expected: Expected, measured: Array) -> Innovation:
        """Measured minus expected (n, m), in the space of the measurement."""
        z = sensor.calibration.sensor.space.minus(measured, expected.value)
        noise = sensor.calibration.noise
        return Innovation(z, expected.by, np.broadcast_to(noise, (len(z), *noise.shape)))

    def innovation(self, sensor: MountedSensor, landmark: Landmark, measured: Array) -> Innovation | None:
        """The innovation of one landmark at the present means; None if it should not be seen from there."""
        calibration = sensor.calibration
        found = observe(landmark.kind, calibration, sensor.robot.pose, sensor.mount, landmark.block.mean)
        if not found.visible:
            return None
        J = found.jacobians
        z = calibration.sensor.space.minus(measured, found.value)
        return Innovation(z, by_columns(sensor, J.robot, J.mount, J.landmark), calibration.noise)

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
        camera, by = compose.jac(sensor.robot.pose, sensor.mount)
        turn = [by.outer, by.inner][: 1 if sensor.block is None else 2]
        columns, dof = columns_of(sensor, landmarks), landmarks[0].block.dof
        P = belief.matrix[columns[:, :, None], columns[:, None, :]]
        T = np.zeros((dof + 6, columns.shape[1]))  # from (robot, mount, landmark) to (landmark, camera)
        T[:dof, -dof:], T[dof:, :-dof] = np.eye(dof), np.concatenate(turn, axis=1)
        ripe = should_convert(kind, means_of(landmarks), T @ P @ T.T, camera, self.options.convert_below)
        for landmark, is_ripe in zip(landmarks, ripe.tolist(), strict=True):
            if is_ripe:
                belief.replace(landmark.block, EUC_POINT.space, *to_euclidean(kind, landmark.block.mean))
                landmark.kind = EUC_POINT

    def lost(self, belief: Belief, landmarks: list[Landmark]) -> set[Landmark]:
        """The landmarks, of one kind, that lie beyond infinity: no point is there. Chapter 11."""
        if landmarks[0].kind is EUC_POINT:
            return set()
        beyond = beyond_infinity(landmarks[0].kind, means_of(landmarks), _own(belief, landmarks))
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
    return belief.matrix[rows[:, :, None], rows[:, None, :]]
