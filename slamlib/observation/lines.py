"""A camera on a robot observes straight lines: the chain rule for every pair of a camera and a parametrization.

landmark --to_frame--> Pluecker coordinates in the camera's frame --project_line--> image line, and back from the two
endpoints of a measured segment. Also the residuals of a segment from a predicted line, in three variants; and segments
in images that a lens bends.
"""

from collections.abc import Callable

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.geometry.pose import compose
from slamlib.landmarks.line_innovation import angles, distances, oriented, rho_theta
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array
from slamlib.models import Jacobians, Model
from slamlib.observation.points import NamedJacobians, Observation, through
from slamlib.sensors.sensor import Calibration

Residual = Callable[[Calibration, Array, Array], tuple[Array, Array, Array]]
_NO_DISTORTION = np.eye(4)


def observe_line(
    kind: LineLandmark, calibration: Calibration, robot: Array, extrinsics: Array, landmarks: Array
) -> Observation:
    """Predicted image lines (..., 3), homogeneous and undistorted, of landmarks (..., size), with Jacobians.

    An infinite line is never out of view: `visible` is true for all; segments are tested by their endpoints
    (slamlib.landmarks.segments). Raises SlamlibError for a sensor that sees no lines. Chapter lines, eq. (li-project).
    """
    _check_lines(calibration, f"observe {kind.name}")
    camera, by_camera = compose.jac(robot, extrinsics)
    line, by_frame = kind.to_frame.jac(camera, landmarks)
    value, J = image_line(calibration, line)
    by_pose = J[0] @ by_frame.pose
    jacobians = NamedJacobians(
        robot=by_pose @ by_camera.outer,
        extrinsics=by_pose @ by_camera.inner,
        landmark=J[0] @ by_frame.landmark,
        **{n: getattr(J, n) for n in calibration.given if n in J._fields},
    )
    return Observation(value, np.ones(value.shape[:-1], dtype=bool), jacobians, line)


def initialize_line(
    kind: LineLandmark, calibration: Calibration, robot: Array, extrinsics: Array, segment: Array, prior: Array
) -> tuple[Array, NamedJacobians]:
    """Initialize a landmark from a segment (..., 4), two pixels, and a prior (..., 2) of two unmeasured numbers.

    jacobians.robot (..., dof, 6), .extrinsics (..., dof, 6), .measurement (..., dof, 4), .unmeasured (..., dof, 2), and
    one for each parameter of the camera. Each endpoint is undistorted by itself. Raises SlamlibError for a sensor that
    sees no lines. Chapter lines, eq. (li-chain).
    """
    _check_lines(calibration, f"initialize {kind.name}")
    segment = np.asarray(segment, dtype=float)
    if segment.shape[-1:] != (4,):
        raise ShapeError.of("initialize_line", "segment", (4,), segment.shape)
    camera, by_camera = compose.jac(robot, extrinsics)
    rays, by_pixels, by_sensor = rays_of(calibration, segment)
    landmark, by_frame = kind.from_frame.jac(camera, rays, prior)
    by_given = {n: getattr(by_sensor, n)[..., :3, :] for n in calibration.given}  # (..., 2, 3, k), ray by ray
    jacobians = NamedJacobians(
        **through(by_camera, by_frame.pose),
        measurement=by_frame.rays @ by_pixels,
        unmeasured=by_frame.prior,
        **{n: by_frame.rays @ J.reshape(*J.shape[:-3], 6, J.shape[-1]) for n, J in by_given.items()},
    )
    return landmark, jacobians


def _check_lines(calibration: Calibration, task: str) -> None:
    """Raise SlamlibError for a sensor that cannot image lines."""
    if calibration.sensor.project_line is None:
        raise SlamlibError(f"{calibration.sensor.name} measures no lines, so it cannot {task}")


# -- residuals of segments -------------------------------------------------------------------------------------------


def rays_of(calibration: Calibration, segment: Array) -> tuple[Array, Array, Jacobians]:
    """Unit rays (..., 6) of the endpoints of segments (..., 4), and their Jacobians (..., 6, 4) w.r.t. the pixels.

    Third the Jacobians of the endpoints' homogeneous points (..., 2, 4) w.r.t. all that they depend on.
    """
    lead = segment.shape[:-1]
    points, J = calibration.back_project_jac(segment.reshape(*lead, 2, 2), np.ones((*lead, 2, 1)))
    by = np.zeros((*lead, 6, 4))
    by[..., :3, :2], by[..., 3:, 2:] = J[0][..., 0, :3, :], J[0][..., 1, :3, :]
    return points[..., :3].reshape(*lead, 6), by, J


def undistort_segments(calibration: Calibration, segment: Array) -> tuple[Array, Array]:
    """Undistort the endpoints of segments (..., 4); with the Jacobians (..., 4, 4)."""
    if not _distorts(calibration):
        return segment, _NO_DISTORTION
    rays, by_pixels, _ = rays_of(calibration, segment)
    lead = segment.shape[:-1]
    points = np.concatenate([rays.reshape(*lead, 2, 3), np.ones((*lead, 2, 1))], axis=-1)
    ideal, J = calibration.sensor.project.jac(points, **without_distortion(calibration))
    by = np.zeros((*lead, 4, 6))
    by[..., :2, :3], by[..., 2:, 3:] = J.point[..., 0, :, :3], J.point[..., 1, :, :3]
    return ideal.reshape(*lead, 4), by @ by_pixels


def distort_segments(calibration: Calibration, segment: Array) -> Array:
    """The inverse of `undistort_segments`: distort the endpoints of ideal segments (..., 4)."""
    if not _distorts(calibration):
        return segment
    endpoints = segment.reshape(*segment.shape[:-1], 2, 2)
    rays = calibration.sensor.back_project(
        endpoints, np.ones((*endpoints.shape[:-1], 1)), **without_distortion(calibration)
    )
    return calibration.project(rays).reshape(segment.shape)


def _line_model(calibration: Calibration) -> Model:
    """The model of the images of lines, of a sensor that has one."""
    assert calibration.sensor.project_line is not None, "checked before lines are measured"
    return calibration.sensor.project_line


def ideal_parameters(calibration: Calibration) -> dict[str, Array]:
    """The parameters that project_line takes; the others are the lens's distortion, which lines' images are free of."""
    project_line = _line_model(calibration)
    return {n: calibration.given[n] for n in project_line.parameters if n in calibration.given}


def without_distortion(calibration: Calibration) -> dict[str, Array]:
    """The parameters, with the lens's distortion at zero."""
    ideal = ideal_parameters(calibration)
    return {n: v if n in ideal else np.zeros_like(v) for n, v in calibration.given.items()}


def _distorts(calibration: Calibration) -> bool:
    ideal = ideal_parameters(calibration)
    return any(v.any() for n, v in calibration.given.items() if n not in ideal)


def image_line(calibration: Calibration, line: Array) -> tuple[Array, Jacobians]:
    """Image lines (..., 3) of lines (..., 6) of the camera's frame, and the Jacobians w.r.t. line and parameters."""
    project_line = _line_model(calibration)
    return project_line.jac(line, **ideal_parameters(calibration))


def _distances(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    image, by_line = image_line(calibration, line)
    y, by_segment = undistort_segments(calibration, segment)
    z, J = distances.jac(image, y)
    return z, J.line @ by_line[0], J.segment @ by_segment


def _rho_theta(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    image, by_line = image_line(calibration, line)
    y, by_segment = undistort_segments(calibration, segment)
    same = oriented(image, y)
    sign = np.where((same == image).all(-1), 1.0, -1.0)[..., None, None]
    z, J = rho_theta.jac(same, y, calibration.image / 2)
    return z, sign * J.line @ by_line[0], J.segment @ by_segment


def _angles(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    rays, by_segment, _ = rays_of(calibration, segment)
    z, J = angles.jac(line, rays)
    return z, J.line, J.rays @ by_segment


# Each gives z (..., 2), measured minus predicted, and its Jacobians w.r.t. line (..., 2, 6) and segment (..., 2, 4).
RESIDUALS: dict[str, Residual] = {"ortDst": _distances, "rhoThe": _rho_theta, "angles": _angles}
