"""Relative position: the sensor measures a point in its own frame, (x, y, z) [m]."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.models import model
from slamlib.sensors.sensor import Sensor


@model(point=4)
def project(point):
    """The point in the sensor's frame [m]; none at infinity. Chapter depth_stereo_range, eq. (dp-relative)."""
    return point[:3] / point[3]


@model(measurement=3)
def back_project(measurement):
    """Unit ray and inverse distance [1/m]; not defined at the sensor itself. Eq. (dp-relative-back)."""
    return np.array([*measurement, 1]) / sqrt(measurement @ measurement)


def visible(point, calibration):
    """Mask of the points at a finite distance, between the limits `near` and `far` [m]."""
    point = np.asarray(point)
    distance, w = np.sqrt((point[..., :3] ** 2).sum(-1)), point[..., 3]
    near, far = calibration.limits.get("near", 0), calibration.limits.get("far", np.inf)
    return (w > 0) & (distance > 0) & (distance >= near * w) & (distance <= far * np.where(w > 0, w, 1))


RELATIVE_POSITION = Sensor("relativePosition", project, back_project, (), visible, limits=("near", "far"))


def converted(calibration, measurement):
    """Convert a complete measurement to a relative position: point (..., 3) [m] and its full covariance.

    Chapter depth_stereo_range, eq. (dp-converted); the covariance is that of the first order, at the measurement.
    """
    point, by_sensor = calibration.back_project_jac(measurement)
    position, by_point = project.jac(point)
    J = by_point.point @ by_sensor.measurement
    return position, J @ calibration.noise @ np.swapaxes(J, -1, -2)
