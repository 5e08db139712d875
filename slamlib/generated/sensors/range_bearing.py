"""Generated from slamlib/sensors/range_bearing.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "project": "048171479618448b",
    "back_project": "7ce01b5ab977d2b2",
}
SHAPES = {
    "project": (3,),
    "back_project": (4,),
}


def project(point):
    """project: value."""
    point0, point1, point2, point3 = point
    t0 = 1/point3
    t1 = point2*point2
    t2 = point0*point0
    t3 = point1*point1
    t4 = t2 + t3
    t5 = t1 + t4
    t6 = sqrt(t5)
    t7 = sqrt(t4)
    return (
        t0*t6,
        arctan2(point1, point0),
        arctan2(-point2, t7),
    )


def project_jac(point):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    t0 = 1/point3
    t1 = point2*point2
    t2 = point0*point0
    t3 = point1*point1
    t4 = t2 + t3
    t5 = t1 + t4
    t6 = sqrt(t5)
    t7 = sqrt(t4)
    t8 = 1/t6
    t9 = t0*t8
    t10 = t0*t0
    t11 = 1/t4
    t12 = 1/t5
    t13 = 1/t7
    t14 = point2*t12*t13
    return (
        t0*t6,
        arctan2(point1, point0),
        arctan2(-point2, t7),
        point0*t9,
        point1*t9,
        point2*t9,
        -t10*t6,
        -point1*t11,
        point0*t11,
        0,
        0,
        point0*t14,
        point1*t14,
        -t12*t7,
        0,
    )


def back_project(measurement):
    """back_project: value."""
    measurement0, measurement1, measurement2 = measurement
    t0 = cos(measurement2)
    t1 = 1/measurement0
    return (
        cos(measurement1)*t0,
        sin(measurement1)*t0,
        -sin(measurement2),
        t1,
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
    t6 = 1/measurement0
    t7 = t6*t6
    return (
        t2,
        t4,
        -t5,
        t6,
        0,
        -t4,
        -t0*t5,
        0,
        t2,
        -t3*t5,
        0,
        0,
        -t1,
        -t7,
        0,
        0,
    )
