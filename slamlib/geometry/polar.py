"""Polar coordinates of the plane: range [m] and bearing [rad]."""

import numpy as np

from slamlib.analytic import arctan2, cos, sin, sqrt
from slamlib.models import model


@model(point=2)
def to_polar(point):
    """Range and bearing of a point (x, y); not defined at the origin. Chapter proving_a_jacobian."""
    x, y = point
    return np.array([sqrt(x * x + y * y), arctan2(y, x)])


@model(polar=2)
def from_polar(polar):
    """Point (x, y) at a range and bearing. Chapter proving_a_jacobian."""
    distance, bearing = polar
    return np.array([distance * cos(bearing), distance * sin(bearing)])
