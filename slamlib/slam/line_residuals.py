"""What a measured segment says about an expected line, in three readings; and segments in images that a lens bends."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.landmarks.line_innovation import angles, distances, oriented, rho_theta
from slamlib.manifolds import Array
from slamlib.sensors.sensor import Calibration

Reading = Callable[[Calibration, Array, Array], tuple[Array, Array, Array]]


def rays_of(calibration: Calibration, segment: Array) -> tuple[Array, Array]:
    """Unit rays (..., 6) of the ends of segments (..., 4), and their Jacobians (..., 6, 4)."""
    lead = segment.shape[:-1]
    points, J = calibration.back_project_jac(segment.reshape(*lead, 2, 2), np.ones((*lead, 2, 1)))
    by = np.zeros((*lead, 6, 4))
    by[..., :3, :2], by[..., 3:, 2:] = J[0][..., 0, :3, :], J[0][..., 1, :3, :]
    return points[..., :3].reshape(*lead, 6), by


def straight(calibration: Calibration, segment: Array) -> tuple[Array, Array]:
    """Segments (..., 4) as a lens without distortion would have seen their ends, and the Jacobians (..., 4, 4)."""
    if not _bends(calibration):
        return segment, _SAME
    rays, by_pixels = rays_of(calibration, segment)
    lead = segment.shape[:-1]
    points = np.concatenate([rays.reshape(*lead, 2, 3), np.ones((*lead, 2, 1))], axis=-1)
    ideal, J = calibration.sensor.project.jac(points, **_unbent(calibration))
    by = np.zeros((*lead, 4, 6))
    by[..., :2, :3], by[..., 2:, 3:] = J.point[..., 0, :, :3], J.point[..., 1, :, :3]
    return ideal.reshape(*lead, 4), by @ by_pixels


_SAME = np.eye(4)


def bent(calibration: Calibration, segment: Array) -> Array:
    """The inverse of `straight`: where the lens puts the ends of ideal segments (..., 4)."""
    if not _bends(calibration):
        return segment
    ends = segment.reshape(*segment.shape[:-1], 2, 2)
    rays = calibration.sensor.back_project(ends, np.ones((*ends.shape[:-1], 1)), **_unbent(calibration))
    return calibration.project(rays).reshape(segment.shape)


def _unbent(calibration: Calibration) -> dict[str, Array]:
    """The parameters, with those that the image of a line does not know, the lens's, at zero."""
    project_line: Any = calibration.sensor.project_line
    return {n: v if n in project_line.parameters else np.zeros_like(v) for n, v in calibration.padded.items()}


def _bends(calibration: Calibration) -> bool:
    project_line: Any = calibration.sensor.project_line
    return any(v.any() for n, v in calibration.given.items() if n not in project_line.parameters)


def _image_line(calibration: Calibration, line: Array) -> tuple[Array, Array]:
    """Image lines (..., 3) of lines (..., 6) of the camera's frame, and the Jacobians (..., 3, 6)."""
    project: Any = calibration.sensor.project_line
    image, J = project.jac(line, **{n: calibration.padded[n] for n in project.parameters if n in calibration.padded})
    return image, J[0]


def _distances(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    image, by_line = _image_line(calibration, line)
    y, by_segment = straight(calibration, segment)
    z, J = distances.jac(image, y)
    return z, J.line @ by_line, J.segment @ by_segment


def _rho_theta(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    image, by_line = _image_line(calibration, line)
    y, by_segment = straight(calibration, segment)
    same = oriented(image, y)
    sign = np.where((same == image).all(-1), 1.0, -1.0)[..., None, None]
    z, J = rho_theta.jac(same, y, calibration.image / 2)
    return z, sign * J.line @ by_line, J.segment @ by_segment


def _angles(calibration: Calibration, line: Array, segment: Array) -> tuple[Array, Array, Array]:
    rays, by_segment = rays_of(calibration, segment)
    z, J = angles.jac(line, rays)
    return z, J.line, J.rays @ by_segment


# Each gives z (..., 2), measured minus expected, and its Jacobians by the line (..., 2, 6) and the segment (..., 2, 4).
READINGS: dict[str, Reading] = {"ortDst": _distances, "rhoThe": _rho_theta, "angles": _angles}
