"""Generated from slamlib/sensors/plane_bearing.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin

DIGESTS = {
    "project": "45df39d7b248223c",
    "back_project": "b895c7a6faaae8d4",
}
SHAPES = {
    "project": (1,),
    "back_project": (4,),
}


def project(point):
    """project: value."""
    point0, point1, _, _ = point
    return (
        arctan2(point1, point0),
    )


def project_jac(point):
    """project: value and Jacobians."""
    point0, point1, _, _ = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = 1/t2
    return (
        arctan2(point1, point0),
        -point1*t3,
        point0*t3,
        0,
        0,
    )


def back_project(measurement, unmeasured):
    """back_project: value."""
    measurement, = measurement
    unmeasured, = unmeasured
    return (
        cos(measurement),
        sin(measurement),
        0,
        unmeasured,
    )


def back_project_jac(measurement, unmeasured):
    """back_project: value and Jacobians."""
    measurement, = measurement
    unmeasured, = unmeasured
    t0 = cos(measurement)
    t1 = sin(measurement)
    return (
        t0,
        t1,
        0,
        unmeasured,
        -t1,
        t0,
        0,
        0,
        0,
        0,
        0,
        1,
    )
