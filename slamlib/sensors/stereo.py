"""Rectified stereo pair: the measurement is the left pixel and the disparity (u, v, d) [px]."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SlamlibError
from slamlib.models import model
from slamlib.sensors.sensor import Sensor


@model(point=4, intrinsics=4, baseline=1)
def project(point, intrinsics, baseline):
    """Left pixel and disparity [px] of a homogeneous point; the disparity is 0 at infinity. Eq. (dp-stereo)."""
    x, y, z, w = point
    u0, v0, au, av = intrinsics
    (b,) = baseline
    return np.array([u0 + au * x / z, v0 + av * y / z, au * b * w / z])


@model(measurement=3, intrinsics=4, baseline=1)
def back_project(measurement, intrinsics, baseline):
    """Unit ray and inverse distance [1/m]; no division by the disparity. Eq. (dp-stereo-back)."""
    u, v, d = measurement
    u0, v0, au, av = intrinsics
    (b,) = baseline
    ray = np.array([(u - u0) / au, (v - v0) / av, 1])
    return np.array([*ray, d / (au * b)]) / sqrt(ray @ ray)


def visible(point, calibration):
    """Mask of the points in front of both cameras, in both images, and with at least the limit `disparity` [px]."""
    x, _, z, w = np.moveaxis(np.asarray(point), -1, 0)
    u0, _, au, _ = calibration.given["intrinsics"]
    (b,) = calibration.given["baseline"]
    front = z > 0
    depth = np.where(front, z, 1)
    seen = front & (au * b * w / depth >= calibration.limits.get("disparity", 0))
    if calibration.image is None:
        return seen
    right = u0 + au * (x - b * w) / depth
    return seen & (right >= 0) & (right <= calibration.image[0])


def check(calibration):
    """Raise SlamlibError unless there are four intrinsics, and focal lengths and baseline are above zero."""
    intrinsics, baseline = calibration.given["intrinsics"], calibration.given["baseline"]
    if len(intrinsics) != 4 or not (intrinsics[2:] > 0).all():
        raise SlamlibError(f"stereo: intrinsics are (u0, v0, au, av) with au, av > 0, got {intrinsics.tolist()}")
    if len(baseline) != 1 or not baseline[0] > 0:
        raise SlamlibError(f"stereo: the baseline is one length above zero [m], got {baseline.tolist()}")


PARAMETERS, LIMITS = ("intrinsics", "baseline"), ("disparity",)
STEREO = Sensor("stereo", project, back_project, PARAMETERS, visible, check, limits=LIMITS, pixels=True)
