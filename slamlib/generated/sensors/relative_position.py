"""Generated from slamlib/sensors/relative_position.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "65fa4db8b578433b",
    "back_project": "6dc76607a00345f8",
}
SHAPES = {
    "project": (3,),
    "back_project": (4,),
}


def project(point):
    """project: value."""
    point0, point1, point2, point3 = point
    t0 = 1/point3
    return (
        point0*t0,
        point1*t0,
        point2*t0,
    )


def project_jac(point):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    t0 = 1/point3
    t1 = t0*t0
    return (
        point0*t0,
        point1*t0,
        point2*t0,
        t0,
        0,
        0,
        -point0*t1,
        0,
        t0,
        0,
        -point1*t1,
        0,
        0,
        t0,
        -point2*t1,
    )


def back_project(measurement):
    """back_project: value."""
    measurement0, measurement1, measurement2 = measurement
    t0 = measurement0*measurement0
    t1 = measurement1*measurement1
    t2 = measurement2*measurement2
    t3 = t0 + t1 + t2
    t4 = 1/t3
    t5 = sqrt(t4)
    return (
        measurement0*t5,
        measurement1*t5,
        measurement2*t5,
        t5,
    )


def back_project_jac(measurement):
    """back_project: value and Jacobians."""
    measurement0, measurement1, measurement2 = measurement
    t0 = measurement0*measurement0
    t1 = measurement1*measurement1
    t2 = measurement2*measurement2
    t3 = t0 + t1 + t2
    t4 = 1/t3
    t5 = sqrt(t4)
    t6 = t4*t5
    t7 = measurement0*t6
    t8 = -measurement1*t7
    t9 = -measurement2*t7
    t10 = measurement1*t6
    t11 = -measurement2*t10
    return (
        measurement0*t5,
        measurement1*t5,
        measurement2*t5,
        t5,
        -(t0*t4 - 1)*t5,
        t8,
        t9,
        t8,
        -(t1*t4 - 1)*t5,
        t11,
        t9,
        t11,
        -(t2*t4 - 1)*t5,
        -t7,
        -t10,
        -measurement2*t6,
    )
