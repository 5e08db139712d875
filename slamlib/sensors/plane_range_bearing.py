"""Range and bearing in the plane: distance [m] and angle to the left [rad]; the sensor's axes are front, left, up."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.manifolds import Angle, Euclidean, Product
from slamlib.models import model
from slamlib.sensors.sensor import Sensor

PlaneRangeBearing = Product("range and bearing", Euclidean(1), Angle(1))


@model(point=4, returns=PlaneRangeBearing)
def project(point):
    """Distance along the sensor's floor, and bearing; none straight above or below. Eq. (dp-plane)."""
    x, y, _, w = point
    return np.array([sqrt(x * x + y * y) / w, arctan2(y, x)])


@model(measurement=PlaneRangeBearing)
def back_project(measurement):
    """Unit ray along the sensor's floor and inverse distance [1/m]. Eq. (dp-plane-back)."""
    distance, bearing = measurement
    return np.array([cos(bearing), sin(bearing), 0, 1 / distance])


def visible(point, calibration):
    """Mask of the points not on the vertical, within the limits `near`, `far` [m] and `bearing` [rad]."""
    x, y, w = (point[..., i] for i in (0, 1, 3))
    level, limits = np.hypot(x, y), calibration.limits
    seen = (w > 0) & (level > 0) & (level >= limits.get("near", 0) * w)
    if "far" in limits:
        seen = seen & (level <= limits["far"] * w)
    if "bearing" in limits:
        seen = seen & (np.abs(np.arctan2(y, x)) <= limits["bearing"])
    return seen


PLANE_RANGE_BEARING = Sensor(
    "planeRangeBearing", project, back_project, (), visible, limits=("near", "far", "bearing"), plane=True
)
