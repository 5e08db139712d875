"""Unified camera: a wide lens or a mirror, by a sphere seen from behind: a pixel; axes right, down, front."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SlamlibError
from slamlib.models import AtMost, model
from slamlib.models.implicit import Implicit
from slamlib.sensors import brown
from slamlib.sensors.sensor import Sensor
from slamlib.sensors.stages import BackProjection

TERMS = 6  # xi, k1, k2, p1, p2, k3


@model(direction=3, shift=1)
def plane(direction, shift):
    """Image on the plane at distance 1 from the shifted centre. Chapter omnidirectional, eq. (om-unified)."""
    x, y, z = direction
    return direction[:2] / (z + shift[0] * sqrt(x * x + y * y + z * z))


@model(direction=3, shift=1)
def pierced(direction, shift):
    """Unit ray to where a direction from the shifted centre pierces the sphere. Eq. (om-pierced)."""
    (x, y, z), (xi,) = direction, shift
    squared = x * x + y * y
    length = (xi * z + sqrt(z * z + (1 - xi * xi) * squared)) / (squared + z * z)
    return length * direction - np.array([0, 0, xi])


@model(ideal=2, intrinsics=4, distortion=AtMost(TERMS))
def pixel(ideal, intrinsics, distortion):
    """Pixel of an image on the plane; intrinsics (u0, v0, au, av) [px]. Chapter omnidirectional, eq. (om-mei)."""
    return brown.pixel(ideal, intrinsics, np.array([*distortion[1:], 0, 0, 0]))


@model(point=4, intrinsics=4, distortion=AtMost(TERMS))
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point; distortion (xi, k1, k2, p1, p2, k3). Chapter omnidirectional, eq. (om-mei)."""
    return pixel(plane(point[:3], distortion[:1]), intrinsics, distortion)


@model(ideal=2, unmeasured=1, distortion=AtMost(TERMS))
def ray(ideal, unmeasured, distortion):
    """Unit ray and inverse distance [1/m] behind an image on the plane. Chapter omnidirectional, eq. (om-pierced)."""
    return np.array([*pierced(np.array([*ideal, 1]), distortion[:1]), *unmeasured])


def _first_guess(measurement, intrinsics, distortion):
    return brown.ideal_point.start(measurement, intrinsics, distortion[..., 1:])


back_project = BackProjection(Implicit("ideal_point", pixel, unknown="ideal", start=_first_guess), ray, size=2)


def angle(seen, shift):
    """Angle [rad] from the axis of what the shifted centre sees at an angle. Eq. (om-sines)."""
    return float(seen + np.arcsin(min(shift * np.sin(seen), 1.0)))


def largest_angle(xi, *bending):
    """The angle [rad] from the axis at which the image ends or folds back. Eq. (om-unified-ends)."""
    fold = float(brown.fold_radius(bending))
    return angle(min(np.arcsin(1 / max(xi, 1.0)), np.arctan(fold)), xi)


def visible(point, calibration):
    """Mask of the points within the field of view, by their angle from the axis. Eq. (om-visible)."""
    x, y, z = np.moveaxis(point[..., :3], -1, 0)
    return np.arctan2(np.hypot(x, y), z) < calibration.limits["angle"]


def check_field(calibration, largest):
    """Raise SlamlibError for invalid intrinsics and a field beyond the largest angle [rad], which is its default."""
    name, intrinsics = calibration.sensor.name, calibration.given["intrinsics"]
    if len(intrinsics) != 4 or not (intrinsics[2:] > 0).all():
        raise SlamlibError(f"{name}: intrinsics are (u0, v0, au, av) with au, av > 0, got {intrinsics.tolist()}")
    if not 0 < calibration.limits.setdefault("angle", largest) <= largest:
        raise SlamlibError(
            f"{name}: by its coefficients the image ends {largest:.4f} rad from the axis, before the field of view, at "
            f"{calibration.limits['angle']} rad: give a smaller limit 'angle', or calibrate with points out there"
        )


def check(calibration):
    """Raise SlamlibError for invalid parameters; the default field of view is the largest possible."""
    distortion = calibration.given["distortion"]
    if not (len(distortion) and distortion[0] > -1):
        raise SlamlibError(
            "unified: distortion is (xi, k1, k2, p1, p2, k3), xi above -1, where the last ones may be left out; got "
            f"{distortion.tolist()}"
        )
    check_field(calibration, largest_angle(*distortion))


PARAMETERS = ("intrinsics", "distortion")
UNIFIED = Sensor("unified", project, back_project, PARAMETERS, visible, check, limits=("angle",), pixels=True)
