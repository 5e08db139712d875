"""Bearing alone, in the plane: the angle to the left [rad] of a point; the sensor's axes are front, left, up."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin
from slamlib.manifolds import Angle
from slamlib.models import model
from slamlib.sensors.sensor import Sensor


@model(point=4, returns=Angle(1))
def project(point):
    """Bearing, of points at infinity too; none straight above or below. Eq. (dp-plane)."""
    x, y, _, _ = point
    return np.array([arctan2(y, x)])


@model(measurement=Angle(1), unmeasured=1)
def back_project(measurement, unmeasured):
    """Unit ray along the sensor's floor and the unmeasured inverse distance [1/m]. Eq. (dp-plane-back)."""
    bearing = measurement[0]
    return np.array([cos(bearing), sin(bearing), 0, unmeasured[0]])


def visible(point, calibration):
    """Mask of the points not on the vertical, within the limit `bearing` [rad]."""
    x, y = np.moveaxis(np.asarray(point), -1, 0)[:2]
    seen = np.hypot(x, y) > 0
    if "bearing" in calibration.limits:
        seen = seen & (np.abs(np.arctan2(y, x)) <= calibration.limits["bearing"])
    return seen


PLANE_BEARING = Sensor("planeBearing", project, back_project, (), visible, limits=("bearing",), plane=True)
