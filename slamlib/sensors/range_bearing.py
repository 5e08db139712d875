"""Range and bearing: distance [m], yaw and pitch [rad] of a point; the sensor's axes are front, left, up."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.manifolds import Angle, Euclidean, Product
from slamlib.models import model
from slamlib.sensors.sensor import Sensor

RangeBearing = Product("range, yaw and pitch", Euclidean(1), Angle(1), Euclidean(1))


@model(point=4, returns=RangeBearing)
def project(point):
    """Range, yaw to the left and pitch downwards; no yaw on the vertical. Eq. (dp-range)."""
    x, y, z, w = point
    level = x * x + y * y
    return np.array([sqrt(level + z * z) / w, arctan2(y, x), arctan2(-z, sqrt(level))])


@model(measurement=RangeBearing)
def back_project(measurement):
    """Unit ray and inverse distance [1/m]. Chapter depth_stereo_range, eq. (dp-range-back)."""
    distance, yaw, pitch = measurement
    return np.array([cos(pitch) * cos(yaw), cos(pitch) * sin(yaw), -sin(pitch), 1 / distance])


def visible(point, calibration):
    """Mask of the points not on the vertical, within the limits `near`, `far` [m], `yaw` and `pitch` [rad]."""
    x, y, z, w = np.moveaxis(np.asarray(point), -1, 0)
    level = np.hypot(x, y)
    distance, limits = np.hypot(level, z), calibration.limits
    seen = (w > 0) & (level > 0) & (distance >= limits.get("near", 0) * w)
    if "far" in limits:
        seen = seen & (distance <= limits["far"] * w)
    if "yaw" in limits:
        seen = seen & (np.abs(np.arctan2(y, x)) <= limits["yaw"])
    return seen & (np.abs(np.arctan2(z, level)) <= limits.get("pitch", np.pi))


RANGE_BEARING = Sensor("rangeBearing", project, back_project, (), visible, limits=("near", "far", "yaw", "pitch"))
