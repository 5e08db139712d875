"""Generated from slamlib/sensors/stereo.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "4cabd375720741e8",
    "back_project": "b7b2d6c23f1716e2",
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
    t0 = 1/point2
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
    t0 = 1/point2
    t1 = intrinsics2*t0
    t2 = intrinsics3*t0
    t3 = baseline*t1
    t4 = t0*t0
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
    t2 = 1/intrinsics3
    t3 = t1*t2
    t4 = t3*t3
    t5 = 1/intrinsics2
    t6 = t0*t5
    t7 = t6*t6
    t8 = 1 + t4 + t7
    t9 = 1/t8
    t10 = sqrt(t9)
    t11 = t10*t5
    t12 = 1/baseline
    return (
        -t0*t11,
        -t1*t10*t2,
        t10,
        measurement2*t11*t12,
    )


def back_project_jac(measurement, intrinsics, baseline):
    """back_project: value and Jacobians."""
    measurement0, measurement1, measurement2 = measurement
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    baseline, = baseline
    t0 = intrinsics0 - measurement0
    t1 = 1/intrinsics2
    t2 = t1*t1
    t3 = t0*t0
    t4 = t2*t3
    t5 = 1/intrinsics3
    t6 = t5*t5
    t7 = intrinsics1 - measurement1
    t8 = t7*t7
    t9 = t6*t8
    t10 = t4 + t9 + 1
    t11 = 1/t10
    t12 = sqrt(t11)
    t13 = t1*t12
    t14 = t12*t5
    t15 = 1/baseline
    t16 = t13*t15
    t17 = -t11*t4 + 1
    t18 = t13*t17
    t19 = t11*t12
    t20 = t6*t7
    t21 = t19*t20
    t22 = t0*t1
    t23 = t21*t22
    t24 = t0*t2
    t25 = t19*t24
    t26 = t5*t7
    t27 = t25*t26
    t28 = -t11*t9 + 1
    t29 = t14*t28
    t30 = t2*t1
    t31 = t19*t30
    t32 = measurement2*t15
    t33 = t0*t31*t32
    t34 = t1*t32
    t35 = t21*t34
    t36 = t12*t17
    t37 = t6*t5
    t38 = t19*t37*t8
    t39 = t3*t31
    t40 = t15*t15
    return (
        -t0*t13,
        -t14*t7,
        t12,
        measurement2*t16,
        t18,
        -t23,
        0,
        -t27,
        t29,
        0,
        t25,
        t21,
        0,
        t33,
        t35,
        t16,
        -t18,
        t23,
        t24*t36,
        -t22*t38,
        t27,
        -t29,
        -t26*t39,
        t12*t20*t28,
        -t25,
        -t21,
        t39,
        t38,
        -t33,
        -t35,
        -t2*t32*t36,
        t34*t38,
        0,
        0,
        0,
        -measurement2*t13*t40,
    )
