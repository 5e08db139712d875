"""Davison's wide-angle camera: one coefficient of distortion, inverted in closed form; axes right, down, front."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SlamlibError
from slamlib.models import model
from slamlib.sensors.pinhole import project_line, ray
from slamlib.sensors.sensor import Sensor


@model(ideal=2, distortion=1)
def distorted(ideal, distortion):
    """Distort an ideal point of the plane z = 1. Chapter pinhole, eq. (ph-davison)."""
    return ideal / sqrt(1 + 2 * distortion[0] * (ideal @ ideal))


@model(bent=2, distortion=1)
def undistorted(bent, distortion):
    """Ideal point of a distorted one. Chapter pinhole, eq. (ph-davison-back)."""
    return bent / sqrt(1 - 2 * distortion[0] * (bent @ bent))


@model(point=4, intrinsics=4, distortion=1)
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point; intrinsics (u0, v0, au, av) [px]. Chapter pinhole, eq. (ph-davison)."""
    return intrinsics[:2] + intrinsics[2:] * distorted(point[:2] / point[2], distortion)


@model(measurement=2, unmeasured=1, intrinsics=4, distortion=1)
def back_project(measurement, unmeasured, intrinsics, distortion):
    """Unit ray and inverse distance [1/m] behind a pixel. Chapter pinhole, eq. (ph-davison-back)."""
    return ray(undistorted((measurement - intrinsics[:2]) / intrinsics[2:], distortion), unmeasured)


def visible(point, calibration):
    """Mask of the points in front of the camera at which the root of the distortion is real."""
    x, y, z = (point[..., i] for i in range(3))
    return (z > 0) & (z**2 + 2 * calibration.given["distortion"][0] * (x**2 + y**2) > 0)


def check(calibration):
    """Raise SlamlibError for invalid parameters, and for an image whose corners no ray reaches."""
    k, distortion = calibration.given["intrinsics"], calibration.given["distortion"]
    if len(k) != 4 or not (k[2:] > 0).all() or len(distortion) != 1:
        raise SlamlibError(
            "davison: intrinsics are (u0, v0, au, av) with au, av > 0, and distortion is one number, got "
            f"{k.tolist()} and {distortion.tolist()}"
        )
    if calibration.image is None:
        return
    corner = np.hypot(*(np.maximum(np.abs(k[:2]), np.abs(calibration.image - k[:2])) / k[2:]))
    if 2 * distortion[0] * corner**2 >= 1:
        raise SlamlibError(
            f"davison: the image's corner is at radius {corner:.3g}, and with the distortion {distortion[0]:g} nothing "
            f"comes out beyond {(2 * distortion[0]) ** -0.5:.3g}: calibrate with points near the border"
        )


PARAMETERS = ("intrinsics", "distortion")
DAVISON = Sensor("davison", project, back_project, PARAMETERS, visible, check, project_line, limits=(), pixels=True)
