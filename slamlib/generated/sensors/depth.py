"""Generated from slamlib/sensors/depth.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "62bf0395939b3c8c",
    "lift": "9f28cfbddb17873e",
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
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t3)*t3)*t3)*t3)*t3)*t3)*t3)*t3 + 1
    t5 = 1/point3
    return (
        ideal0*intrinsics2*t4 + intrinsics0,
        ideal1*intrinsics3*t4 + intrinsics1,
        point2*t5,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, point3 = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = distortion7*t3
    t5 = distortion5 + (distortion6 + t4)*t3
    t6 = distortion4 + t3*t5
    t7 = distortion3 + t3*t6
    t8 = distortion2 + t3*t7
    t9 = distortion1 + t3*t8
    t10 = distortion0 + t3*t9
    t11 = t10*t3 + 1
    t12 = ideal0*t11
    t13 = ideal1*t11
    t14 = 1/point3
    t15 = t10 + t10
    t16 = t4 + t4
    t17 = ((((((distortion6 + t16)*t3 + t5)*t3 + t6)*t3 + t7)*t3 + t8)*t3 + t9)*t3
    t18 = t17 + t17
    t19 = t1*t15 + t1*t18 + t11
    t20 = intrinsics2*t0
    t21 = (t10 + t17)
    t22 = t21 + t21
    t23 = t22*ideal0*ideal1
    t24 = t0*t0
    t25 = intrinsics3*t0
    t26 = t11 + t15*t2 + t18*t2
    t27 = t14*t14
    t28 = ideal0*intrinsics2
    t29 = t3*t3
    t30 = t29*t3
    t31 = t29*t29
    t32 = t30*t29
    t33 = t30*t30
    t34 = t31*t30
    t35 = t31*t31
    t36 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t12,
        intrinsics1 + intrinsics3*t13,
        point2*t14,
        t19*t20,
        t20*t23,
        -(point0*t19 + point1*t23)*intrinsics2*t24,
        0,
        t23*t25,
        t25*t26,
        -(point0*t23 + point1*t26)*intrinsics3*t24,
        0,
        0,
        0,
        t14,
        -point2*t27,
        1,
        0,
        t12,
        0,
        0,
        1,
        0,
        t13,
        0,
        0,
        0,
        0,
        t28*t3,
        t28*t29,
        t28*t30,
        t28*t31,
        t28*t32,
        t28*t33,
        t28*t34,
        t28*t35,
        t3*t36,
        t29*t36,
        t30*t36,
        t31*t36,
        t32*t36,
        t33*t36,
        t34*t36,
        t35*t36,
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
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/t2
    t4 = sqrt(t3)
    t5 = 1/depth
    return (
        ideal0*t4,
        ideal1*t4,
        t4,
        t4*t5,
    )


def lift_jac(ideal, depth):
    """lift: value and Jacobians."""
    ideal0, ideal1 = ideal
    depth, = depth
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/t2
    t4 = sqrt(t3)
    t5 = 1/depth
    t6 = t3*t4
    t7 = ideal0*t6
    t8 = -ideal1*t7
    t9 = ideal1*t6
    t10 = t5*t5
    return (
        ideal0*t4,
        ideal1*t4,
        t4,
        t4*t5,
        -(t0*t3 - 1)*t4,
        t8,
        t8,
        -(t1*t3 - 1)*t4,
        -t7,
        -t9,
        -t5*t7,
        -t5*t9,
        0,
        0,
        0,
        -t10*t4,
    )
