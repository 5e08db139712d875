"""A camera on a robot looks at straight lines: the chain rule for every pair of a camera and a parametrization.

landmark --to_frame--> Pluecker coordinates in the camera's frame --project_line--> image line, and back from the two
endpoints of a measured segment.
"""

from typing import Any

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.geometry.pose import compose
from slamlib.landmarks.line import LineLandmark
from slamlib.manifolds import Array
from slamlib.model import Model
from slamlib.observation.points import Observation, named
from slamlib.sensors.sensor import Calibration


def observe_line(
    kind: LineLandmark, calibration: Calibration, robot: Array, mount: Array, landmarks: Array
) -> Observation:
    """Expected image lines (..., 3), homogeneous and undistorted, of landmarks (..., size), with Jacobians.

    A line has no ends, so it has no border to lie in: `visible` is true for all; segments are judged by their ends
    (slamlib.landmarks.segments). Raises SlamlibError for a sensor that sees no lines. Chapter 12, eq. (li-project).
    """
    project = _sees_lines(calibration, f"observe {kind.name}")
    camera, by_camera = compose.jac(robot, mount)
    line, by_frame = kind.to_frame.jac(camera, landmarks)
    names = [n for n in project.parameters if n in calibration.given]
    value, by_sensor = project.jac(line, **{n: calibration.padded[n] for n in names})
    to_camera = by_sensor[0] @ by_frame.pose
    parts = {
        "robot": to_camera @ by_camera.outer,
        "mount": to_camera @ by_camera.inner,
        "landmark": by_sensor[0] @ by_frame.landmark,
        **{n: getattr(by_sensor, n)[..., : len(calibration.given[n])] for n in names},
    }
    return Observation(value, np.ones(value.shape[:-1], dtype=bool), named(parts))


def initialize_line(
    kind: LineLandmark, calibration: Calibration, robot: Array, mount: Array, segment: Array, prior: Array
) -> tuple[Array, Any]:
    """The landmark of a segment (..., 4), two pixels, and of the two numbers `prior` that it does not tell; Jacobians.

    jacobians.robot (..., dof, 6), .mount (..., dof, 6), .measurement (..., dof, 4), .unmeasured (..., dof, 2), and one
    for each parameter of the camera. Each endpoint is undistorted by itself. Raises SlamlibError for a sensor that sees
    no lines. Chapter 12, eq. (li-chain).
    """
    _sees_lines(calibration, f"initialize {kind.name}")
    segment = np.asarray(segment, dtype=float)
    if segment.shape[-1:] != (4,):
        raise ShapeError.of("initialize_line", "segment", (4,), segment.shape)
    camera, by_camera = compose.jac(robot, mount)
    ends = segment.reshape(*segment.shape[:-1], 2, 2)
    points, by_sensor = calibration.back_project_jac(ends, np.ones((*ends.shape[:-1], 1)))
    rays = points[..., :3].reshape(*segment.shape[:-1], 6)
    landmark, by_frame = kind.from_frame.jac(camera, rays, prior)
    by_pixels = np.zeros((*segment.shape[:-1], 6, 4))
    by_pixels[..., :3, :2], by_pixels[..., 3:, 2:] = by_sensor[0][..., 0, :3, :], by_sensor[0][..., 1, :3, :]
    parts = {
        "robot": by_frame.pose @ by_camera.outer,
        "mount": by_frame.pose @ by_camera.inner,
        "measurement": by_frame.rays @ by_pixels,
        "unmeasured": by_frame.prior,
        **{n: by_frame.rays @ _stacked(getattr(by_sensor, n)) for n in calibration.given},
    }
    return landmark, named(parts)


def _sees_lines(calibration: Calibration, task: str) -> Model:
    """The model of a line's image; raises SlamlibError for a sensor that has none."""
    project = calibration.sensor.project_line
    if project is None:
        raise SlamlibError(f"{calibration.sensor.name} measures no lines, so it cannot {task}")
    return project


def _stacked(by_parameter: Array) -> Array:
    """Jacobians of two homogeneous points (..., 2, 4, n) as that of their two rays (..., 6, n)."""
    rays = by_parameter[..., :3, :]
    return rays.reshape(*rays.shape[:-3], 6, rays.shape[-1])
