"""How the filter treats straight lines: expectation, innovation, first estimate, constraint, and their two ends."""

from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.data.snapshots import MapView
from slamlib.kalman.small_matrices import corners
from slamlib.landmarks import LINES, endpoints, hmg_point, segments
from slamlib.landmarks.line import LineLandmark
from slamlib.manifolds import Array, Mask
from slamlib.observation.lines import initialize_line
from slamlib.sensors.sensor import Calibration
from slamlib.slam.entities import Landmark, MountedSensor
from slamlib.slam.line_endpoints import settled
from slamlib.slam.line_residuals import READINGS, bent, rays_of
from slamlib.slam.options import Options
from slamlib.slam.predicted_measurement import Expected, Innovation, by_columns, columns_of, means_of, place_of


@dataclass(frozen=True)
class LineFamily:
    """Everything about straight lines that the filter asks for."""

    options: Options
    name: str = "segments"
    kinds: type = LineLandmark

    @property
    def new(self) -> LineLandmark | None:
        """The parametrization of new lines, or None for none."""
        return LINES[self.options.lines] if self.options.lines else None

    def sees(self, sensor: MountedSensor) -> bool:
        """Lines are for cameras that map them to straight lines, and have an image."""
        return sensor.calibration.sensor.project_line is not None and sensor.calibration.image is not None

    def usable(self, sensor: MountedSensor, values: Array) -> Mask:
        """Mask of the segments (n, 4) that a landmark may begin with: long enough."""
        return segments.length(values) >= self.options.minimum_length

    def expect(self, sensor: MountedSensor, landmarks: list[Landmark]) -> Expected:
        """The segments that the camera should see, between the lines' ends; those out of view are left out."""
        kind, means = landmarks[0].kind, means_of(landmarks)
        place = place_of(sensor)
        ends = hmg_point.to_frame(place.pose, endpoints.ends(kind, means, np.array([lm.abscissas for lm in landmarks])))
        calibration, least = sensor.calibration, self.options.minimum_length
        intrinsics = calibration.given["intrinsics"]
        found = segments.visible(ends[:, 0], ends[:, 1], intrinsics, calibration.image, minimum_length=least)
        seen = found.seen
        looked = [landmark for landmark, s in zip(landmarks, seen.tolist(), strict=True) if s]
        if not looked:
            return Expected.nothing(4)
        line, J = kind.to_frame.jac(place.pose, means[seen])
        by = by_columns(place, J.pose, J.landmark)
        return Expected(looked, bent(calibration, found.pixels[seen]), line, by, columns_of(sensor, looked))

    def innovate(self, sensor: MountedSensor, expected: Expected, measured: Array) -> Innovation:
        """How far the measured segments (n, 4) are off the expected lines (n, 2), by the reading of the options."""
        return self._innovation(sensor, expected.inner, expected.by, measured)

    def innovation(self, sensor: MountedSensor, landmark: Landmark, measured: Array) -> Innovation:
        """The innovation of one line at the present means. A line has no border: whoever saw it, sees it."""
        place = place_of(sensor)
        line, J = landmark.kind.to_frame.jac(place.pose, landmark.block.mean)
        by = by_columns(place, J.pose, J.landmark)
        return self._innovation(sensor, line, by, measured)

    def _innovation(self, sensor: MountedSensor, line: Array, by: Array, measured: Array) -> Innovation:
        z, by_line, by_segment = READINGS[self.options.innovation](sensor.calibration, line, measured)
        return Innovation(z, -by_line @ by, by_segment @ _noise(sensor) @ by_segment.swapaxes(-1, -2))

    def inner(self, calibration: Calibration, in_frame: Array) -> Array:
        """What the innovation is computed from: lines (..., 6) of the sensor's frame themselves."""
        return in_frame

    def begin(self, sensor: MountedSensor, kind: LineLandmark, value: Array) -> tuple[Array, Array, list[Array]]:
        """Mean, own noise and Jacobians by robot and mount of a line that is seen for the first time. Chapter 15."""
        means, stds = (np.array(numbers) for numbers in self.options.line_prior(kind.name))
        x, J = initialize_line(kind, sensor.calibration, sensor.robot.pose, sensor.mount, value, means)
        own = J.measurement @ _noise(sensor) @ J.measurement.T + J.unmeasured @ np.diag(stds**2) @ J.unmeasured.T
        return x, own, [J.robot, J.mount]

    def abscissas(self, kind: LineLandmark) -> Array:
        """Where the two ends of a new line are."""
        return np.array(kind.abscissas, dtype=float)

    def corrected(self, belief: Belief, sensor: MountedSensor, landmarks: list[Landmark], measured: Array) -> None:
        """After a correction: lines of one kind are made lines again, their ends follow what was seen. Chapter 12."""
        kind = landmarks[0].kind
        camera = place_of(sensor).pose
        if kind.constrain is not None:
            for landmark in landmarks:
                mean, J = kind.constrain.jac(landmark.block.mean, camera[:3])
                belief.replace(landmark.block, landmark.block.space, mean, J.landmark)
        rule = endpoints.Extension(self.options.extend, self.options.extend_switch)
        if not rule.extend:
            return
        found = endpoints.seen_ends(kind, means_of(landmarks), camera, rays_of(sensor.calibration, measured)[0])
        old = np.array([landmark.abscissas for landmark in landmarks])
        spreads = self._spread(belief, sensor, camera, landmarks, np.where(found.usable[:, None], found.abscissas, old))
        for landmark, new in zip(landmarks, rule.update(old, found, spreads), strict=True):
            landmark.abscissas = new

    def _spread(
        self, belief: Belief, sensor: MountedSensor, camera: Array, landmarks: list[Landmark], abscissas: Array
    ) -> Array:
        """The larger standard deviation of the lines' two ends in the image (n,) [px]; inf where one is not in view."""
        kind = landmarks[0].kind
        h, J = kind.point_at.jac(means_of(landmarks)[:, None, :], abscissas)
        point, F = hmg_point.to_frame.jac(camera, h)
        seen = sensor.calibration.visible(point)
        by_point = sensor.calibration.project_jac(np.where(seen[..., None], point, _AHEAD))[1].point
        H = by_point @ F.landmark @ J.landmark
        rows = np.array([lm.block.start for lm in landmarks])[:, None] + np.arange(landmarks[0].block.dof)
        P = corners(belief.matrix, rows)
        spread = endpoints.spread(H @ P[:, None] @ H.swapaxes(-1, -2))
        return np.where(seen, spread, np.inf).max(-1)

    def lost(self, belief: Belief, landmarks: list[Landmark]) -> set[Landmark]:
        """None: lines have no place beyond infinity. Their points may lie there, the lines are where they are."""
        return set()

    def view(self, belief: Belief, landmarks: list[Landmark]) -> MapView:
        """Both ends in the world and their covariances; nan for those at or beyond infinity."""
        geometry, covariance = np.full((len(landmarks), 2, 3), np.nan), np.full((len(landmarks), 2, 3, 3), np.nan)
        for i, landmark in enumerate(landmarks):
            h, J = landmark.kind.point_at.jac(np.tile(landmark.block.mean, (2, 1)), landmark.abscissas)
            P = belief.covariance(landmark.block)
            for end in np.flatnonzero(h[:, 3] > 0):
                x, w = h[end, :3] / h[end, 3], h[end, 3]
                by = (J.landmark[end, :3] - np.outer(x, J.landmark[end, 3])) / w
                geometry[i, end], covariance[i, end] = x, by @ P @ by.T
        kinds = tuple(landmark.kind.name for landmark in landmarks)
        ids = np.array([lm.id for lm in landmarks], dtype=int)
        return MapView(ids, kinds, geometry, covariance, settled(geometry, covariance))


def _noise(sensor: MountedSensor) -> Array:
    """Noise (4, 4) of a segment: of two pixels."""
    noise = np.zeros((4, 4))
    noise[:2, :2] = noise[2:, 2:] = sensor.calibration.noise[:2, :2]
    return noise


_AHEAD = np.array([0.25, 0.5, 1, 1])  # stands in for ends out of view, so that their rows are finite
