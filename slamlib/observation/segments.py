"""Straight lines as a family of landmarks: measured as segments, estimated as infinite lines with two endpoints."""

from dataclasses import dataclass, field
from typing import Annotated, NamedTuple

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import Landmark, RigSensor
from slamlib.entities.generator import generator
from slamlib.entities.landmark import landmark_means, state_rows
from slamlib.entities.state import KindRows
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.linalg import left_inverse, principal_blocks
from slamlib.landmarks import LINES, endpoints, hmg_point, segments
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array, Indices, Mask
from slamlib.observation.family import (
    Calibrated,
    Family,
    FamilyOptions,
    Innovation,
    PredictedBatch,
    TrueSensor,
    Viewpoint,
    viewpoint,
    with_own_rows,
)
from slamlib.observation.lines import RESIDUALS, distort_segments, initialize_line, rays_of
from slamlib.observation.points import PLACEHOLDER_POINT, NamedJacobians
from slamlib.plain_data.fields import Finite, NotNegative, OneOf, Positive, Range
from slamlib.sensors.sensor import Calibration

CONVERGED_RATIO = 0.1  # of a segment's length: the largest standard deviation of an endpoint of a converged line


Prior = tuple[tuple[Finite, Finite], tuple[Positive, Positive]]
PLUCKER: Prior = ((0.1, 0.0), (0.25, 1.0))


@dataclass(frozen=True, repr=False)
class LineOptions(FamilyOptions):
    """Options of lines, as slamlib.Options explains them."""

    lines: Annotated[str, OneOf(LINES)] | None = None
    line_priors: dict[Annotated[str, OneOf(LINES)], Prior] = field(
        default_factory=lambda: {"plkLin": PLUCKER, "aplLin": PLUCKER}
    )
    innovation: Annotated[str, OneOf(RESIDUALS)] = "ortDst"
    extend: bool = True
    extend_switch: NotNegative = 10.0
    minimum_length: Annotated[float, Range(ge=0, unit="px")] = 20.0

    def line_prior(self, name: str) -> Prior:
        """Prior means and standard deviations of what a segment does not measure of a line of this parametrization."""
        mean, std = self.inverse_distance
        return self.line_priors.get(name, ((mean, mean), (std, std)))


class LineFamily(Family[LineOptions]):
    """Straight lines, measured as segments: prediction, innovation, initialization, constraint, and endpoints."""

    name = "segments"
    kinds = LineLandmark
    parametrizations = LINES
    world_size = 6
    parts = 2

    def size(self, calibration: Calibration) -> int:
        """A segment is two pixels."""
        return 4

    def chosen(self, options: LineOptions) -> str | None:
        """The name of the parametrization of new lines, or None for none."""
        return options.lines

    def linearized(self, sensor: RigSensor, expected: PredictedBatch) -> tuple[Array, Array]:
        """Jacobians H (n, 2, k) and noises R (n, 2, 2) of the residual, which both depend on the segment predicted."""
        found = self.batch_innovation(sensor, expected, expected.value)
        return found.H, found.R

    def supports(self, sensor: Calibrated) -> bool:
        """Lines need a camera that maps them to straight lines, and has an image."""
        return sensor.calibration.sensor.project_line is not None and sensor.calibration.image is not None

    def usable(self, sensor: RigSensor, values: Array, options: LineOptions) -> Mask:
        """Mask (n,) of the segments (n, 4) that may initialize a landmark: long enough."""
        return segments.length(values) >= options.minimum_length

    def predict_batch(self, view: Viewpoint, group: KindRows, options: LineOptions) -> PredictedBatch:
        """Predict segments between the lines' endpoints; those out of view are left out."""
        abscissas = np.array([landmark.abscissas for landmark in group.landmarks])
        end_points = hmg_point.to_frame(view.pose, endpoints.endpoints_at(group.kind, group.means(), abscissas))
        calibration, least = view.sensor.calibration, options.minimum_length
        found = segments.visible(
            end_points[:, 0], end_points[:, 1], calibration.given["intrinsics"], calibration.image, minimum_length=least
        )
        if not found.seen.any():
            return PredictedBatch.nothing(4)
        pixels = distort_segments(calibration, found.pixels[found.seen])
        return super().predict_batch(view, group.take(np.flatnonzero(found.seen)), options)._replace(value=pixels)

    def observe(
        self, kind: LineLandmark, calibration: Calibration, camera: Array, means: Array
    ) -> tuple[Array, Mask, NamedJacobians]:
        """Lines (n, 6) in the sensor's frame; an infinite line is never out of view."""
        line, J = kind.to_frame.jac(camera, means)
        visible: Mask = np.ones(line.shape[:-1], dtype=bool)[()]
        return line, visible, NamedJacobians(camera=J.pose, landmark=J.landmark)

    def residual(self, sensor: RigSensor, inner: Array, by: Array, measured: Array, options: LineOptions) -> Innovation:
        """Residuals (n, 2) of measured segments (n, 4) from lines (n, 6) in the sensor's frame; options.innovation."""
        z, by_line, by_segment = RESIDUALS[options.innovation](sensor.calibration, inner, measured)
        return Innovation(z, -by_line @ by, by_segment @ _noise(sensor) @ by_segment.swapaxes(-1, -2))

    def initialize(
        self, sensor: RigSensor, kind: LineLandmark, value: Array, options: LineOptions
    ) -> tuple[Array, Array, list[Array]]:
        """Mean, own noise and Jacobians w.r.t. robot and extrinsics of a new line. Chapter initialization."""
        means, stds = (np.array(numbers) for numbers in options.line_prior(kind.name))
        x, J = initialize_line(kind, sensor.calibration, sensor.robot.pose, sensor.extrinsics, value, means)
        own = J.measurement @ _noise(sensor) @ J.measurement.T + J.unmeasured @ np.diag(stds**2) @ J.unmeasured.T
        return x, own, [J.robot, J.extrinsics]

    def after_update(
        self, belief: Belief, sensor: RigSensor, landmarks: list[Landmark], measured: Array, options: LineOptions
    ) -> None:
        """After an update: enforce the line constraint, let the endpoints follow the measured ones. Chapter lines.

        The constraint holds the line's image from the camera's place, and an endpoint follows where it is well known in
        the image. The camera's pose is estimated: where errors move with the world, derivatives by it count, eq.
        (ob-constrain), and what no image can tell has no part. The toolbox takes the pose as given.
        """
        kind, view = landmarks[0].kind, viewpoint(sensor)
        camera = view.pose
        if kind.constrain is not None:
            given = sensor.blocks if options.carried else []
            for landmark in landmarks:
                mean, J = kind.constrain.jac(landmark.block.mean, camera[:3])
                by = [J.eye @ each[:3] for each in view.by_block] if given else []
                belief.replace(landmark.block, landmark.block.manifold, mean, J.landmark, given=given, jacobians=by)
        rule = endpoints.EndpointExtension(options.extend, options.extend_switch)
        if not rule.extend:
            return
        rays, old = rays_of(sensor.calibration, measured)[0], np.array([landmark.abscissas for landmark in landmarks])
        means = landmark_means(landmarks)
        found = endpoints.observed_endpoints(kind, means, camera, rays)
        ends = np.where(found.usable[:, None], found.abscissas, old)
        shown = project_endpoints(sensor.calibration, camera, landmarks, ends)
        H, columns = shown.pixel_by_point @ shown.point_by_end @ shown.end_by_line, state_rows(landmarks)
        if options.carried:  # what the world moves by, the camera does
            by_world = H @ generator(kind, means)[:, None]
            by_camera = by_world @ left_inverse(compose.jac(ORIGIN, camera)[1].outer)
            H = np.concatenate([-by_camera @ view.jacobian, H], axis=-1)
            columns = with_own_rows(sensor, columns)
        P = principal_blocks(belief.matrix, columns)
        spread = np.where(shown.visible, endpoints.largest_std(H @ P[:, None] @ H.swapaxes(-1, -2)), np.inf).max(-1)
        for landmark, new in zip(landmarks, rule.update(old, found, spread), strict=True):
            landmark.abscissas = new

    def geometry(self, belief: Belief, landmarks: list[Landmark]) -> tuple[Array, Array, Mask]:
        """Endpoints (n, 2, 3) in the world, their covariances (n, 2, 3, 3); nan for those at or beyond infinity."""
        geometry, covariance = np.full((len(landmarks), 2, 3), np.nan), np.full((len(landmarks), 2, 3, 3), np.nan)
        for i, landmark in enumerate(landmarks):
            h, J = landmark.kind.point_at.jac(np.tile(landmark.block.mean, (2, 1)), landmark.abscissas)
            P = belief.covariance(landmark.block)
            for end in np.flatnonzero(h[:, 3] > 0):
                x, w = h[end, :3] / h[end, 3], h[end, 3]
                by = (J.landmark[end, :3] - np.outer(x, J.landmark[end, 3])) / w
                geometry[i, end], covariance[i, end] = x, by @ P @ by.T
        return geometry, covariance, endpoints_converged(geometry, covariance)

    def distance(self, geometry: Array, there: Array) -> float:
        """The larger distance [m] of the true segment's two endpoints from the estimated line."""
        along = (geometry[1] - geometry[0]) / np.linalg.norm(geometry[1] - geometry[0])
        away = there.reshape(2, 3) - geometry[0]
        return float(np.linalg.norm(away - np.outer(away @ along, along), axis=1).max())

    def check(self, name: str, calibration: Calibration) -> None:
        """Raise SlamlibError for a camera that maps lines to lines, but has no image to clip them to."""
        if calibration.sensor.project_line is not None and calibration.image is None:
            raise SlamlibError(f"{name}: segments are cut at the border of the image; give the setup an image")

    def simulate(self, sensor: TrueSensor, camera: Array, places: Array, noise: Array) -> tuple[Indices, Array]:
        """Clip to the image's border in the ideal image; then distort, then add noise to the clipped endpoints.

        The toolbox adds the noise before it clips, at endpoints that may lie far outside: what is left of it at the
        border is an average of both endpoints' noise, smaller than the filter assumes. The last clipping here moves an
        endpoint by the noise only, along its own segment, which leaves its distance from the line unchanged to first
        order.
        """
        calibration = sensor.calibration
        end_points, seen = sensor.longest_seen(places.reshape(-1, 2, 3), camera)
        inside = EUC_POINT.to_frame(camera, end_points)
        planes = segments.frustum(calibration.given["intrinsics"], calibration.image)
        *cut, within = segments.clip(inside[:, 0], inside[:, 1], planes)
        points = np.concatenate([np.stack(cut, 1), np.ones((len(end_points), 2, 1))], -1)
        rows = np.flatnonzero(seen & within & calibration.visible(points).all(-1))
        exact = calibration.project(points[rows]).reshape(-1, 4)
        measured = segments.trim(exact + noise[rows].reshape(-1, 4), tuple(calibration.image), minimum_length=0)
        found = measured.seen & (segments.length(exact) >= sensor.shortest)
        pixels = np.clip(measured.pixels[found], 0, np.tile(calibration.image, 2))  # rounding of the clipping itself
        return rows[found], pixels


LINE_FAMILY = LineFamily()


def _noise(sensor: RigSensor) -> Array:
    """Noise (4, 4) of a segment: of two pixels."""
    noise = np.zeros((4, 4))
    noise[:2, :2] = noise[2:, 2:] = sensor.calibration.noise[:2, :2]
    return noise


class ProjectedEndpoints(NamedTuple):
    """Two points of each of n lines in an image: the mask (n, 2) of those in view, and pixels (n, 2, 2).

    The chain of Jacobians (n, 2, ...): of the pixel w.r.t. the point in the sensor's frame, of that point w.r.t. the
    sensor's pose and w.r.t. the endpoint in the world, and of the endpoint w.r.t. its line.
    """

    visible: Mask
    pixels: Array
    pixel_by_point: Array
    point_by_pose: Array
    point_by_end: Array
    end_by_line: Array


def project_endpoints(
    calibration: Calibration, camera: Array, landmarks: list[Landmark], abscissas: Array
) -> ProjectedEndpoints:
    """Project the points at two abscissas (n, 2) of each line of one kind."""
    h, by_line = landmarks[0].kind.point_at.jac(landmark_means(landmarks)[:, None, :], abscissas)
    point, by = hmg_point.to_frame.jac(camera, h)
    visible = calibration.visible(point)
    pixels, by_sensor = calibration.project_jac(np.where(visible[..., None], point, PLACEHOLDER_POINT))
    return ProjectedEndpoints(visible, pixels, by_sensor.point, by.pose, by.landmark, by_line.landmark)


def endpoints_converged(geometry: Array, covariance: Array) -> Mask:
    """Mask (n,) of the segments (n, 2, 3) whose endpoint covariances (n, 2, 3, 3) are small beside their length.

    A new line is known in the plane of its first image alone: its endpoints may lie anywhere along their rays.
    """
    found = np.zeros(len(geometry), dtype=bool)
    known = np.isfinite(geometry).all((-2, -1))
    worst = np.linalg.eigvalsh(covariance[known])[..., -1].max(-1)
    length = np.linalg.norm(geometry[known, 1] - geometry[known, 0], axis=-1)
    found[known] = np.sqrt(worst.clip(0)) < CONVERGED_RATIO * length
    return found
