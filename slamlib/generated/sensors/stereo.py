"""Generated from slamlib/sensors/stereo.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "eee9c2e0f7b8c6ae",
    "back_project": "a6574956194dc730",
}
SHAPES = {
    "project": (3,),
    "back_project": (4,),
}


def project(point, intrinsics, baseline):
    """project: value."""
    point0, point1, point2, point3 = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    baseline, = baseline
    t0 = 1/(point2)
    t1 = intrinsics2*t0
    return (
        intrinsics0 + point0*t1,
        intrinsics1 + intrinsics3*point1*t0,
        baseline*point3*t1,
    )


def project_jac(point, intrinsics, baseline):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    baseline, = baseline
    t0 = 1/(point2)
    t1 = intrinsics2*t0
    t2 = intrinsics3*t0
    t3 = baseline*t1
    t4 = 1/(point2*point2)
    t5 = intrinsics2*t4
    t6 = baseline*point3
    return (
        intrinsics0 + point0*t1,
        intrinsics1 + point1*t2,
        point3*t3,
        t1,
        0,
        -point0*t5,
        0,
        0,
        t2,
        -intrinsics3*point1*t4,
        0,
        0,
        0,
        -t5*t6,
        t3,
        1,
        0,
        point0*t0,
        0,
        0,
        1,
        0,
        point1*t0,
        0,
        0,
        t0*t6,
        0,
        0,
        0,
        point3*t1,
    )


def back_project(measurement, intrinsics, baseline):
    """back_project: value."""
    measurement0, measurement1, measurement2 = measurement
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    baseline, = baseline
    t0 = intrinsics0 - measurement0
    t1 = intrinsics1 - measurement1
    t2 = 1/(sqrt(1 + t1*t1/(intrinsics3*intrinsics3) + t0*t0/(intrinsics2*intrinsics2)))
    t3 = t2/intrinsics2
    return (
        -t0*t3,
        -t1*t2/intrinsics3,
        t2,
        measurement2*t3/baseline,
    )


def back_project_jac(measurement, intrinsics, baseline):
    """back_project: value and Jacobians."""
    measurement0, measurement1, measurement2 = measurement
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    baseline, = baseline
    t0 = intrinsics0 - measurement0
    t1 = 1/(intrinsics2)
    t2 = 1/(intrinsics2*intrinsics2)
    t3 = t0*t0
    t4 = t2*t3
    t5 = 1/(intrinsics3*intrinsics3)
    t6 = intrinsics1 - measurement1
    t7 = t6*t6
    t8 = t5*t7
    t9 = t4 + t8 + 1
    t10 = 1/(sqrt(t9))
    t11 = t1*t10
    t12 = 1/(intrinsics3)
    t13 = t10*t12
    t14 = 1/(baseline)
    t15 = t11*t14
    t16 = 1/(t9)
    t17 = -t16*t4 + 1
    t18 = 1/(t9*sqrt(t9))
    t19 = t5*t6
    t20 = t18*t19
    t21 = t0*t1
    t22 = t20*t21
    t23 = t0*t2
    t24 = t18*t23
    t25 = t12*t6
    t26 = t24*t25
    t27 = -t16*t8 + 1
    t28 = t18/(intrinsics2*intrinsics2*intrinsics2)
    t29 = measurement2*t14
    t30 = t0*t28*t29
    t31 = t1*t29
    t32 = t20*t31
    t33 = -t17
    t34 = (t18*t7)/(intrinsics3*intrinsics3*intrinsics3)
    t35 = t28*t3
    return (
        -t0*t11,
        -t13*t6,
        t10,
        measurement2*t15,
        t11*t17,
        -t22,
        0,
        -t26,
        t13*t27,
        0,
        t24,
        t20,
        0,
        t30,
        t32,
        t15,
        t11*t33,
        t22,
        t10*t17*t23,
        -t21*t34,
        t26,
        -t13*t27,
        -t25*t35,
        t10*t19*t27,
        -t24,
        -t20,
        t35,
        t34,
        -t30,
        -t32,
        t10*t2*t29*t33,
        t31*t34,
        0,
        0,
        0,
        (-measurement2*t11)/(baseline*baseline),
    )
