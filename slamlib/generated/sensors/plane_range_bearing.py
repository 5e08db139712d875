"""Generated from slamlib/sensors/plane_range_bearing.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "project": "0f5a092721a93fd4",
    "back_project": "c290d7a9358c5082",
}
SHAPES = {
    "project": (2,),
    "back_project": (4,),
}


def project(point):
    """project: value."""
    point0, point1, _, point3 = point
    t0 = 1/point3
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = sqrt(t3)
    return (
        t0*t4,
        arctan2(point1, point0),
    )


def project_jac(point):
    """project: value and Jacobians."""
    point0, point1, _, point3 = point
    t0 = 1/point3
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = sqrt(t3)
    t5 = 1/t4
    t6 = t0*t5
    t7 = t0*t0
    t8 = 1/t3
    return (
        t0*t4,
        arctan2(point1, point0),
        point0*t6,
        point1*t6,
        0,
        -t4*t7,
        -point1*t8,
        point0*t8,
        0,
        0,
    )


def back_project(measurement):
    """back_project: value."""
    measurement0, measurement1 = measurement
    t0 = 1/measurement0
    return (
        cos(measurement1),
        sin(measurement1),
        0,
        t0,
    )


def back_project_jac(measurement):
    """back_project: value and Jacobians."""
    measurement0, measurement1 = measurement
    t0 = cos(measurement1)
    t1 = sin(measurement1)
    t2 = 1/measurement0
    t3 = t2*t2
    return (
        t0,
        t1,
        0,
        t2,
        0,
        -t1,
        0,
        t0,
        0,
        0,
        -t3,
        0,
    )
