"""Generated from slamlib/sensors/depth.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "05c44933e61c2f42",
    "lift": "261645f0740cd397",
}
SHAPES = {
    "project": (3,),
    "lift": (4,),
}


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, point3 = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = (point0*point0 + point1*point1)/(point2*point2)
    t1 = (t0*(distortion0 + t0*(distortion1 + t0*(distortion2 + t0*(distortion3 + t0*(distortion4 + t0*(distortion5 + t0*(distortion6 + distortion7*t0))))))) + 1)/point2
    return (
        intrinsics0 + intrinsics2*point0*t1,
        intrinsics1 + intrinsics3*point1*t1,
        point2/point3,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/(point2*point2)
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = t0*t3
    t5 = distortion7*t4
    t6 = distortion5 + t4*(distortion6 + t5)
    t7 = distortion4 + t4*t6
    t8 = distortion3 + t4*t7
    t9 = distortion2 + t4*t8
    t10 = distortion1 + t4*t9
    t11 = distortion0 + t10*t4
    t12 = t11*t4
    t13 = t12 + 1
    t14 = 1/(point2)
    t15 = intrinsics2*t14
    t16 = intrinsics3*t14
    t17 = 1/(point3)
    t18 = 2*t1
    t19 = t0*t11
    t20 = t10 + t4*(t4*(t4*(t4*(t4*(distortion6 + 2*t5) + t6) + t7) + t8) + t9)
    t21 = t20/(point2*point2*point2*point2)
    t22 = intrinsics2*point0
    t23 = 1/(point2*point2*point2)
    t24 = 2*t23*(t11 + t20*t4)
    t25 = t3*t3
    t26 = 2*t21
    t27 = t0*(3*t12 + t25*t26 + 1)
    t28 = intrinsics3*point1
    t29 = t13*t14
    t30 = t23*t3
    t31 = t25/(point2*point2*point2*point2*point2)
    t32 = t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2)
    t33 = t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t34 = t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t35 = t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t36 = t3*t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t37 = t3*t3*t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    return (
        intrinsics0 + point0*t13*t15,
        intrinsics1 + point1*t13*t16,
        point2*t17,
        t15*(t13 + t18*t19 + t18*t21*t3),
        point1*t22*t24,
        -t22*t27,
        0,
        point0*t24*t28,
        t16*(t13 + 2*t19*t2 + t2*t26*t3),
        -t27*t28,
        0,
        0,
        0,
        t17,
        (-point2)/(point3*point3),
        1,
        0,
        point0*t29,
        0,
        0,
        1,
        0,
        point1*t29,
        0,
        0,
        0,
        0,
        t22*t30,
        t22*t31,
        t22*t32,
        t22*t33,
        t22*t34,
        t22*t35,
        t22*t36,
        t22*t37,
        t28*t30,
        t28*t31,
        t28*t32,
        t28*t33,
        t28*t34,
        t28*t35,
        t28*t36,
        t28*t37,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    )


def lift(ideal, depth):
    """lift: value."""
    ideal0, ideal1 = ideal
    depth, = depth
    t0 = 1/(sqrt(ideal0*ideal0 + ideal1*ideal1 + 1))
    return (
        ideal0*t0,
        ideal1*t0,
        t0,
        t0/depth,
    )


def lift_jac(ideal, depth):
    """lift: value and Jacobians."""
    ideal0, ideal1 = ideal
    depth, = depth
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/(sqrt(t2))
    t4 = 1/(depth)
    t5 = 1/(t2)
    t6 = 1/(t2*sqrt(t2))
    t7 = ideal0*t6
    t8 = -ideal1*t7
    t9 = ideal1*t6
    return (
        ideal0*t3,
        ideal1*t3,
        t3,
        t3*t4,
        t3*(-t0*t5 + 1),
        t8,
        t8,
        t3*(-t1*t5 + 1),
        -t7,
        -t9,
        -t4*t7,
        -t4*t9,
        0,
        0,
        0,
        (-t3)/(depth*depth),
    )
