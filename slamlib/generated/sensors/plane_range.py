"""Generated from slamlib/sensors/plane_range.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import cos, sin, sqrt

DIGESTS = {
    "project": "178099b86d759f86",
    "back_project": "e3909801d2cbaf59",
}
SHAPES = {
    "project": (1,),
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
    return (
        t0*t4,
        point0*t6,
        point1*t6,
        0,
        -t4*t7,
    )


def back_project(measurement, unmeasured):
    """back_project: value."""
    measurement, = measurement
    unmeasured, = unmeasured
    t0 = 1/measurement
    return (
        cos(unmeasured),
        sin(unmeasured),
        0,
        t0,
    )


def back_project_jac(measurement, unmeasured):
    """back_project: value and Jacobians."""
    measurement, = measurement
    unmeasured, = unmeasured
    t0 = cos(unmeasured)
    t1 = sin(unmeasured)
    t2 = 1/measurement
    t3 = t2*t2
    return (
        t0,
        t1,
        0,
        t2,
        0,
        0,
        0,
        -t3,
        -t1,
        t0,
        0,
        0,
    )
