"""Range alone, in the plane: the distance [m] of a point along the sensor's floor; its axes are front, left, up."""

import numpy as np

from slamlib.analytic import cos, sin, sqrt
from slamlib.manifolds import Euclidean
from slamlib.models import model
from slamlib.sensors.sensor import Sensor


@model(point=4, returns=Euclidean(1))
def project(point):
    """Distance along the sensor's floor; it has no derivative straight above or below. Eq. (dp-plane)."""
    x, y, _, w = point
    return np.array([sqrt(x * x + y * y) / w])


@model(measurement=1, unmeasured=1)
def back_project(measurement, unmeasured):
    """Unit ray in the direction [rad] that it does not measure, and inverse distance [1/m]. Eq. (dp-plane-back)."""
    bearing = unmeasured[0]
    return np.array([cos(bearing), sin(bearing), 0, 1 / measurement[0]])


def visible(point, calibration):
    """Mask of the points not on the vertical, within the limits `near` and `far` [m]."""
    x, y, _, w = np.moveaxis(np.asarray(point), -1, 0)
    level, limits = np.hypot(x, y), calibration.limits
    seen = (w > 0) & (level > 0) & (level >= limits.get("near", 0) * w)
    return seen & (level <= limits["far"] * w) if "far" in limits else seen


PLANE_RANGE = Sensor(
    "planeRange", project, back_project, (), visible, limits=("near", "far"), plane=True, initializes=False
)
