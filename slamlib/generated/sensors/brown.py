"""Generated from slamlib/sensors/brown.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "distort": "b80c546ad27c6f4e",
    "pixel": "52254cf107120c6f",
    "project": "cf413aa2ea50d05c",
}
SHAPES = {
    "distort": (2,),
    "pixel": (2,),
    "project": (2,),
}


def distort(ideal, distortion):
    """distort: value."""
    ideal0, ideal1 = ideal
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion2 + distortion2
    t4 = distortion3 + distortion3
    t5 = (distortion5 + (distortion6 + distortion7*t2)*t2)*t2 + 1
    t6 = 1/t5
    t7 = t3*ideal1 + t4*ideal0 + ((distortion0 + (distortion1 + distortion4*t2)*t2)*t2 + 1)*t6
    return (
        distortion3*t2 + ideal0*t7,
        distortion2*t2 + ideal1*t7,
    )


def distort_jac(ideal, distortion):
    """distort: value and Jacobians."""
    ideal0, ideal1 = ideal
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = ideal1 + ideal1
    t4 = distortion7*t2
    t5 = distortion5 + (distortion6 + t4)*t2
    t6 = t2*t5 + 1
    t7 = 1/t6
    t8 = distortion4*t2
    t9 = distortion0 + (distortion1 + t8)*t2
    t10 = t2*t9 + 1
    t11 = t10*t7
    t12 = distortion2*t3 + t11
    t13 = ideal0 + ideal0
    t14 = distortion3*t13
    t15 = t12 + t14
    t16 = t8 + t8
    t17 = ((distortion1 + t16)*t2 + t9)*t7
    t18 = t7*t7
    t19 = t10*t18
    t20 = t4 + t4
    t21 = ((distortion6 + t20)*t2 + t5)*t19
    t22 = distortion3 + distortion3
    t23 = distortion2 + ideal1*t17 - ideal1*t21
    t24 = t22*ideal1 + t13*t23
    t25 = ideal0*t7
    t26 = t2*t2
    t27 = ideal0*t3
    t28 = t26*t2
    t29 = ideal0*t19
    t30 = ideal1*t7
    t31 = ideal1*t19
    return (
        distortion3*t2 + ideal0*t15,
        distortion2*t2 + ideal1*t15,
        4*distortion3*ideal0 + t12 + (distortion3 + ideal0*t17 - ideal0*t21)*t13,
        t24,
        t24,
        4*distortion2*ideal1 + t11 + t23*t3 + t14,
        t2*t25,
        t25*t26,
        t27,
        3*t0 + t1,
        t25*t28,
        -t2*t29,
        -t26*t29,
        -t28*t29,
        t2*t30,
        t26*t30,
        t0 + 3*t1,
        t27,
        t28*t30,
        -t2*t31,
        -t26*t31,
        -t28*t31,
    )


def pixel(ideal, intrinsics, distortion):
    """pixel: value."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion2 + distortion2
    t4 = distortion3 + distortion3
    t5 = (distortion5 + (distortion6 + distortion7*t2)*t2)*t2 + 1
    t6 = 1/t5
    t7 = t3*ideal1 + t4*ideal0 + ((distortion0 + (distortion1 + distortion4*t2)*t2)*t2 + 1)*t6
    return (
        intrinsics0 + (distortion3*t2 + ideal0*t7)*intrinsics2,
        intrinsics1 + (distortion2*t2 + ideal1*t7)*intrinsics3,
    )


def pixel_jac(ideal, intrinsics, distortion):
    """pixel: value and Jacobians."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = ideal1 + ideal1
    t4 = distortion7*t2
    t5 = distortion5 + (distortion6 + t4)*t2
    t6 = t2*t5 + 1
    t7 = 1/t6
    t8 = distortion4*t2
    t9 = distortion0 + (distortion1 + t8)*t2
    t10 = t2*t9 + 1
    t11 = t10*t7
    t12 = distortion2*t3 + t11
    t13 = ideal0 + ideal0
    t14 = distortion3*t13
    t15 = t12 + t14
    t16 = distortion3*t2 + ideal0*t15
    t17 = distortion2*t2 + ideal1*t15
    t18 = t8 + t8
    t19 = ((distortion1 + t18)*t2 + t9)*t7
    t20 = t7*t7
    t21 = t10*t20
    t22 = t4 + t4
    t23 = ((distortion6 + t22)*t2 + t5)*t21
    t24 = distortion3 + ideal0*t19 - ideal0*t23
    t25 = distortion2 + ideal1*t19 - ideal1*t23
    t26 = (distortion3*ideal1 + ideal0*t25)
    t27 = t26 + t26
    t28 = (distortion2*ideal0 + ideal1*t24)
    t29 = t28 + t28
    t30 = ideal0*intrinsics2
    t31 = t2*t7
    t32 = t2*t2
    t33 = t30*t7
    t34 = t32*t2
    t35 = t21*t30
    t36 = ideal1*intrinsics3
    t37 = t36*t7
    t38 = t21*t36
    return (
        intrinsics0 + intrinsics2*t16,
        intrinsics1 + intrinsics3*t17,
        (4*distortion3*ideal0 + t12 + t13*t24)*intrinsics2,
        t27*intrinsics2,
        t29*intrinsics3,
        (4*distortion2*ideal1 + t11 + t25*t3 + t14)*intrinsics3,
        1,
        0,
        t16,
        0,
        0,
        1,
        0,
        t17,
        t30*t31,
        t32*t33,
        t3*t30,
        (3*t0 + t1)*intrinsics2,
        t33*t34,
        -t2*t35,
        -t32*t35,
        -t34*t35,
        t31*t36,
        t32*t37,
        (t0 + 3*t1)*intrinsics3,
        ideal0*intrinsics3*t3,
        t34*t37,
        -t2*t38,
        -t32*t38,
        -t34*t38,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = distortion2 + distortion2
    t5 = distortion3 + distortion3
    t6 = (distortion5 + (distortion6 + distortion7*t3)*t3)*t3 + 1
    t7 = 1/t6
    t8 = t4*ideal1 + t5*ideal0 + ((distortion0 + (distortion1 + distortion4*t3)*t3)*t3 + 1)*t7
    return (
        intrinsics0 + (distortion3*t3 + ideal0*t8)*intrinsics2,
        intrinsics1 + (distortion2*t3 + ideal1*t8)*intrinsics3,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = ideal1 + ideal1
    t5 = distortion7*t3
    t6 = distortion5 + (distortion6 + t5)*t3
    t7 = t3*t6 + 1
    t8 = 1/t7
    t9 = distortion4*t3
    t10 = distortion0 + (distortion1 + t9)*t3
    t11 = t10*t3 + 1
    t12 = t11*t8
    t13 = distortion2*t4 + t12
    t14 = ideal0 + ideal0
    t15 = distortion3*t14
    t16 = t13 + t15
    t17 = distortion3*t3 + ideal0*t16
    t18 = distortion2*t3 + ideal1*t16
    t19 = t9 + t9
    t20 = ((distortion1 + t19)*t3 + t10)*t8
    t21 = t8*t8
    t22 = t11*t21
    t23 = t5 + t5
    t24 = (t6 + (distortion6 + t23)*t3)*t22
    t25 = distortion3 + ideal0*t20 - ideal0*t24
    t26 = 4*distortion3*ideal0 + t13 + t14*t25
    t27 = intrinsics2*t0
    t28 = distortion3 + distortion3
    t29 = distortion2 + ideal1*t20 - ideal1*t24
    t30 = t28*ideal1 + t14*t29
    t31 = t0*t0
    t32 = intrinsics3*t0
    t33 = distortion2 + distortion2
    t34 = t33*ideal0 + t4*t25
    t35 = 4*distortion2*ideal1 + t12 + t29*t4 + t15
    t36 = ideal0*intrinsics2
    t37 = t3*t8
    t38 = t3*t3
    t39 = t36*t8
    t40 = t38*t3
    t41 = t22*t36
    t42 = ideal1*intrinsics3
    t43 = t42*t8
    t44 = t22*t42
    return (
        intrinsics0 + intrinsics2*t17,
        intrinsics1 + intrinsics3*t18,
        t26*t27,
        t27*t30,
        -(point0*t26 + point1*t30)*intrinsics2*t31,
        0,
        t32*t34,
        t32*t35,
        -(point0*t34 + point1*t35)*intrinsics3*t31,
        0,
        1,
        0,
        t17,
        0,
        0,
        1,
        0,
        t18,
        t36*t37,
        t38*t39,
        t36*t4,
        (3*t1 + t2)*intrinsics2,
        t39*t40,
        -t3*t41,
        -t38*t41,
        -t40*t41,
        t37*t42,
        t38*t43,
        (t1 + 3*t2)*intrinsics3,
        ideal0*intrinsics3*t4,
        t40*t43,
        -t3*t44,
        -t38*t44,
        -t40*t44,
    )
