"""Double-sphere camera: a wide lens, by two spheres seen from behind: a pixel; axes right, down, front."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SlamlibError
from slamlib.models import model
from slamlib.sensors import extended_unified, unified
from slamlib.sensors.sensor import Sensor


@model(point=4, intrinsics=4, distortion=2)
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point; distortion (xi, alpha). Chapter omnidirectional, eq. (om-double)."""
    (x, y, z, _), (xi, alpha) = point, distortion
    second = np.array([x, y, z + xi * sqrt(x * x + y * y + z * z)])
    return intrinsics[:2] + intrinsics[2:] * extended_unified.plane(second, np.array([alpha, 1]))


@model(measurement=2, unmeasured=1, intrinsics=4, distortion=2)
def back_project(measurement, unmeasured, intrinsics, distortion):
    """Unit ray and inverse distance [1/m] behind a pixel. Chapter omnidirectional, eq. (om-double-back)."""
    ideal, (xi, alpha) = (measurement - intrinsics[:2]) / intrinsics[2:], distortion
    second = extended_unified.direction(ideal, np.array([alpha, 1]))
    return np.array([*unified.pierced(second, np.array([xi])), *unmeasured])


def largest_angle(xi, alpha):
    """The angle [rad] from the axis at which the image ends or folds back. Chapter omnidirectional, eq. (om-ends)."""
    return unified.angle(extended_unified.largest_angle(alpha), xi)


def check(calibration):
    """Raise SlamlibError for invalid parameters; the default field of view is the largest possible."""
    distortion = calibration.given["distortion"]
    if len(distortion) != 2 or not (-1 < distortion[0] < 1 and 0 <= distortion[1] <= 1):
        raise SlamlibError(
            "doubleSphere: distortion is (xi, alpha), xi between -1 and 1, alpha from 0 to 1; got "
            f"{distortion.tolist()}"
        )
    unified.check_field(calibration, largest_angle(*distortion))


PARAMETERS = ("intrinsics", "distortion")
MODELS = project, back_project
DOUBLE_SPHERE = Sensor("doubleSphere", *MODELS, PARAMETERS, unified.visible, check, limits=("angle",), pixels=True)
