"""Generated from slamlib/geometry/polar.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "to_polar": "7bc2f852f18b9775",
    "from_polar": "aa700768cad9bf12",
}
SHAPES = {
    "to_polar": (2,),
    "from_polar": (2,),
}


def to_polar(point):
    """to_polar: value."""
    point0, point1 = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(t2)
    return (
        t3,
        arctan2(point1, point0),
    )


def to_polar_jac(point):
    """to_polar: value and Jacobians."""
    point0, point1 = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = 1/t3
    t5 = 1/t2
    return (
        t3,
        arctan2(point1, point0),
        point0*t4,
        point1*t4,
        -point1*t5,
        point0*t5,
    )


def from_polar(polar):
    """from_polar: value."""
    polar0, polar1 = polar
    return (
        cos(polar1)*polar0,
        polar0*sin(polar1),
    )


def from_polar_jac(polar):
    """from_polar: value and Jacobians."""
    polar0, polar1 = polar
    t0 = cos(polar1)
    t1 = polar0*t0
    t2 = sin(polar1)
    t3 = polar0*t2
    return (
        t1,
        t3,
        t0,
        -t3,
        t2,
        t1,
    )
