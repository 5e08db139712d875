"""Extended unified camera: a wide lens, by an ellipsoid seen from behind: a pixel; axes right, down, front."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SlamlibError
from slamlib.models import model
from slamlib.sensors import unified
from slamlib.sensors.sensor import Sensor


@model(direction=3, distortion=2)
def plane(direction, distortion):
    """Image on the plane at distance 1; distortion (alpha, beta). Chapter omnidirectional, eq. (om-extended)."""
    (x, y, z), (alpha, beta) = direction, distortion
    return direction[:2] / (alpha * sqrt(beta * (x * x + y * y) + z * z) + (1 - alpha) * z)


@model(ideal=2, distortion=2)
def direction(ideal, distortion):
    """Direction of an image on the plane, as (ideal, z), of any length. Chapter omnidirectional, eq. (om-height)."""
    alpha, beta = distortion
    squared = beta * (ideal @ ideal)
    root = sqrt(1 - (2 * alpha - 1) * squared)
    return np.array([*ideal, (1 - alpha * alpha * squared) / (1 - alpha + alpha * root)])


@model(point=4, intrinsics=4, distortion=2)
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point; intrinsics (u0, v0, au, av) [px]. Chapter omnidirectional, eq. (om-extended)."""
    return intrinsics[:2] + intrinsics[2:] * plane(point[:3], distortion)


@model(measurement=2, unmeasured=1, intrinsics=4, distortion=2)
def back_project(measurement, unmeasured, intrinsics, distortion):
    """Unit ray and inverse distance [1/m] behind a pixel. Chapter omnidirectional, eq. (om-height)."""
    ray = direction((measurement - intrinsics[:2]) / intrinsics[2:], distortion)
    return np.array([*(ray / sqrt(ray @ ray)), *unmeasured])


def largest_angle(alpha, beta=1.0):
    """The angle [rad] from the axis at which the image ends or folds back. Chapter omnidirectional, eq. (om-ends)."""
    least = min(alpha, 1 - alpha) / max(alpha, 1 - alpha)
    return float(np.arctan2(np.sqrt((1 - least**2) / beta), -least))


def check(calibration):
    """Raise SlamlibError for invalid parameters; the default field of view is the largest possible."""
    distortion = calibration.given["distortion"]
    if len(distortion) != 2 or not (0 <= distortion[0] <= 1 and distortion[1] > 0):
        raise SlamlibError(
            f"extendedUnified: distortion is (alpha, beta), alpha from 0 to 1, beta above 0; got {distortion.tolist()}"
        )
    unified.check_field(calibration, largest_angle(*distortion))


PARAMETERS = ("intrinsics", "distortion")
MODELS = project, back_project
EXTENDED_UNIFIED = Sensor(
    "extendedUnified", *MODELS, PARAMETERS, unified.visible, check, limits=("angle",), pixels=True
)
