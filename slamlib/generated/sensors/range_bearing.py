"""Generated from slamlib/sensors/range_bearing.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "project": "6b16f36684db0b4a",
    "back_project": "4945db1ddede9d9e",
}
SHAPES = {
    "project": (3,),
    "back_project": (4,),
}


def project(point):
    """project: value."""
    point0, point1, point2, point3 = point
    t0 = point0*point0 + point1*point1
    return (
        sqrt(point2*point2 + t0)/point3,
        arctan2(point1, point0),
        arctan2(-point2, sqrt(t0)),
    )


def project_jac(point):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    t0 = 1/(point3)
    t1 = point0*point0 + point1*point1
    t2 = point2*point2 + t1
    t3 = sqrt(t2)
    t4 = sqrt(t1)
    t5 = t0/t3
    t6 = 1/(t1)
    t7 = 1/(t2)
    t8 = point2*t7/t4
    return (
        t0*t3,
        arctan2(point1, point0),
        arctan2(-point2, t4),
        point0*t5,
        point1*t5,
        point2*t5,
        (-t3)/(point3*point3),
        -point1*t6,
        point0*t6,
        0,
        0,
        point0*t8,
        point1*t8,
        -t4*t7,
        0,
    )


def back_project(measurement):
    """back_project: value."""
    measurement0, measurement1, measurement2 = measurement
    t0 = cos(measurement2)
    return (
        t0*cos(measurement1),
        t0*sin(measurement1),
        -sin(measurement2),
        1/(measurement0),
    )


def back_project_jac(measurement):
    """back_project: value and Jacobians."""
    measurement0, measurement1, measurement2 = measurement
    t0 = cos(measurement1)
    t1 = cos(measurement2)
    t2 = t0*t1
    t3 = sin(measurement1)
    t4 = t1*t3
    t5 = sin(measurement2)
    return (
        t2,
        t4,
        -t5,
        1/(measurement0),
        0,
        -t4,
        -t0*t5,
        0,
        t2,
        -t3*t5,
        0,
        0,
        -t1,
        (-1)/(measurement0*measurement0),
        0,
        0,
    )
