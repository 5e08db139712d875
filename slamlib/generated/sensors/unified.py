"""Generated from slamlib/sensors/unified.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "plane": "02daf93fa9dfc712",
    "pierced": "f91c8c95c3680a24",
    "pixel": "7a2868a919105d7e",
    "project": "6652cbca33266a67",
    "ray": "27c494ed6360e53b",
}
SHAPES = {
    "plane": (2,),
    "pierced": (3,),
    "pixel": (2,),
    "project": (2,),
    "ray": (4,),
}


def plane(direction, shift):
    """plane: value."""
    direction0, direction1, direction2 = direction
    shift, = shift
    t0 = direction0*direction0
    t1 = direction1*direction1
    t2 = direction2*direction2
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = direction2 + shift*t4
    t6 = 1/t5
    return (
        direction0*t6,
        direction1*t6,
    )


def plane_jac(direction, shift):
    """plane: value and Jacobians."""
    direction0, direction1, direction2 = direction
    shift, = shift
    t0 = direction2*direction2
    t1 = direction0*direction0
    t2 = direction1*direction1
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = direction2 + shift*t4
    t6 = 1/t5
    t7 = 1/t4
    t8 = shift*t7
    t9 = t6*t8
    t10 = t6*t6
    t11 = -direction0*direction1*t10*t8
    t12 = (direction2*t8 + 1)*t10
    t13 = t10*t4
    return (
        direction0*t6,
        direction1*t6,
        -(t1*t9 - 1)*t6,
        t11,
        -direction0*t12,
        t11,
        -(t2*t9 - 1)*t6,
        -direction1*t12,
        -direction0*t13,
        -direction1*t13,
    )


def pierced(direction, shift):
    """pierced: value."""
    direction0, direction1, direction2 = direction
    shift, = shift
    t0 = direction2*direction2
    t1 = direction0*direction0
    t2 = direction1*direction1
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = 1/t4
    t6 = shift*shift
    t7 = t0 - (t6 - 1)*t3
    t8 = sqrt(t7)
    t9 = (direction2*shift + t8)*t5
    return (
        direction0*t9,
        direction1*t9,
        direction2*t9 - shift,
    )


def pierced_jac(direction, shift):
    """pierced: value and Jacobians."""
    direction0, direction1, direction2 = direction
    shift, = shift
    t0 = direction2*direction2
    t1 = direction0*direction0
    t2 = direction1*direction1
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = 1/t4
    t6 = direction2*shift
    t7 = shift*shift
    t8 = t7 - 1
    t9 = t0 - t3*t8
    t10 = sqrt(t9)
    t11 = t6 + t10
    t12 = t11*t5
    t13 = direction2*t12
    t14 = 1/t10
    t15 = t14*t8
    t16 = t12 + t12
    t17 = -t6 - t10
    t18 = t15 + t16
    t19 = direction0*t18*t5
    t20 = -direction1*t19
    t21 = t13 + t13
    t22 = direction2*t14 + shift
    t23 = (-t21 + t22)*t5
    t24 = (direction2 - shift*t14*t3)*t5
    return (
        direction0*t12,
        direction1*t12,
        -shift + t13,
        -(t1*t15 + t1*t16 + t17)*t5,
        t20,
        direction0*t23,
        t20,
        -(t15*t2 + t16*t2 + t17)*t5,
        direction1*t23,
        -direction2*t19,
        -direction1*direction2*t18*t5,
        (direction2*t22 - t0*t16 + t11)*t5,
        direction0*t24,
        direction1*t24,
        direction2*t24 - 1,
    )


def pixel(ideal, intrinsics, distortion):
    """pixel: value."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    _, distortion1, distortion2, distortion3, distortion4, distortion5 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion3 + distortion3
    t4 = distortion4 + distortion4
    t5 = t3*ideal1 + t4*ideal0 + (distortion1 + (distortion2 + distortion5*t2)*t2)*t2 + 1
    return (
        intrinsics0 + (distortion4*t2 + ideal0*t5)*intrinsics2,
        intrinsics1 + (distortion3*t2 + ideal1*t5)*intrinsics3,
    )


def pixel_jac(ideal, intrinsics, distortion):
    """pixel: value and Jacobians."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    _, distortion1, distortion2, distortion3, distortion4, distortion5 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = ideal0 + ideal0
    t4 = distortion4*t3
    t5 = ideal1 + ideal1
    t6 = distortion5*t2
    t7 = distortion1 + (distortion2 + t6)*t2
    t8 = t2*t7
    t9 = distortion3*t5 + t8 + 1
    t10 = t4 + t9
    t11 = distortion4*t2 + ideal0*t10
    t12 = distortion3*t2 + ideal1*t10
    t13 = t6 + t6
    t14 = (distortion2 + t13)*t2
    t15 = distortion4 + ideal0*t14 + ideal0*t7
    t16 = distortion3 + ideal1*t14 + ideal1*t7
    t17 = (distortion4*ideal1 + ideal0*t16)
    t18 = t17 + t17
    t19 = (distortion3*ideal0 + ideal1*t15)
    t20 = t19 + t19
    t21 = ideal0*intrinsics2
    t22 = t2*t2
    t23 = t22*t2
    t24 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t11,
        intrinsics1 + intrinsics3*t12,
        (4*distortion4*ideal0 + t15*t3 + t9)*intrinsics2,
        t18*intrinsics2,
        t20*intrinsics3,
        (4*distortion3*ideal1 + t16*t5 + t4 + t8 + 1)*intrinsics3,
        1,
        0,
        t11,
        0,
        0,
        1,
        0,
        t12,
        0,
        t2*t21,
        t21*t22,
        t21*t5,
        (3*t0 + t1)*intrinsics2,
        t21*t23,
        0,
        t2*t24,
        t22*t24,
        (t0 + 3*t1)*intrinsics3,
        ideal0*intrinsics3*t5,
        t23*t24,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = point2*point2
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = distortion0*t4 + point2
    t6 = 1/t5
    ideal0 = point0*t6
    t7 = ideal0*ideal0
    ideal1 = point1*t6
    t8 = ideal1*ideal1
    t9 = t7 + t8
    t10 = distortion3 + distortion3
    t11 = distortion4 + distortion4
    t12 = t10*ideal1 + t11*ideal0 + (distortion1 + (distortion2 + distortion5*t9)*t9)*t9 + 1
    return (
        intrinsics0 + (distortion4*t9 + ideal0*t12)*intrinsics2,
        intrinsics1 + (distortion3*t9 + ideal1*t12)*intrinsics3,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5 = distortion
    t0 = point2*point2
    t1 = point0*point0
    t2 = point1*point1
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = distortion0*t4 + point2
    t6 = 1/t5
    t7 = point0*t6
    t8 = t7*t7
    ideal1 = point1*t6
    t9 = ideal1*ideal1
    t10 = t8 + t9
    t11 = t7 + t7
    t12 = distortion4*t11
    t13 = ideal1 + ideal1
    t14 = distortion5*t10
    t15 = distortion1 + (distortion2 + t14)*t10
    t16 = t10*t15
    t17 = distortion3*t13 + t16 + 1
    t18 = t12 + t17
    t19 = distortion4*t10 + t18*t7
    t20 = distortion3*t10 + ideal1*t18
    t21 = intrinsics2*t6
    t22 = distortion4 + distortion4
    t23 = t14 + t14
    t24 = (distortion2 + t23)*t10
    t25 = distortion3 + ideal1*t15 + ideal1*t24
    t26 = t25 + t25
    t27 = t22*ideal1 + t26*t7
    t28 = point1*t27
    t29 = 1/t4
    t30 = distortion0*t29
    t31 = t30*t7
    t32 = t30*t6
    t33 = t1*t32 - 1
    t34 = distortion4 + t15*t7 + t24*t7
    t35 = 4*distortion4*t7 + t17 + t11*t34
    t36 = t2*t32 - 1
    t37 = point1*t31
    t38 = t6*t6
    t39 = (point2*t30 + 1)*t38
    t40 = (point0*t35 + t28)*intrinsics2
    t41 = intrinsics3*t6
    t42 = 4*distortion3*ideal1 + t12 + t16 + t13*t25 + 1
    t43 = point1*t42
    t44 = distortion3 + distortion3
    t45 = t44*t7 + t13*t34
    t46 = (point0*t45 + t43)*intrinsics3
    t47 = t38*t4
    t48 = intrinsics2*t7
    t49 = t10*t10
    t50 = t49*t10
    t51 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t19,
        intrinsics1 + intrinsics3*t20,
        -(t28*t31 + t33*t35)*t21,
        -(t27*t36 + t35*t37)*t21,
        -t39*t40,
        0,
        -(t31*t43 + t33*t45)*t41,
        -(t36*t42 + t37*t45)*t41,
        -t39*t46,
        0,
        1,
        0,
        t19,
        0,
        0,
        1,
        0,
        t20,
        -t40*t47,
        t10*t48,
        t48*t49,
        t13*t48,
        (3*t8 + t9)*intrinsics2,
        t48*t50,
        -t46*t47,
        t10*t51,
        t49*t51,
        (t8 + 3*t9)*intrinsics3,
        intrinsics3*t13*t7,
        t50*t51,
    )


def ray(ideal, unmeasured, distortion):
    """ray: value."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    distortion0, _, _, _, _, _ = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = t2 + 1
    t4 = 1/t3
    t5 = distortion0*distortion0
    t6 = -(t5 - 1)*t2 + 1
    t7 = sqrt(t6)
    t8 = distortion0 + t7
    t9 = t4*t8
    return (
        ideal0*t9,
        ideal1*t9,
        -distortion0 + t4*t8,
        unmeasured,
    )


def ray_jac(ideal, unmeasured, distortion):
    """ray: value and Jacobians."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    distortion0, _, _, _, _, _ = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = t2 + 1
    t4 = 1/t3
    t5 = distortion0*distortion0
    t6 = t5 - 1
    t7 = -t2*t6 + 1
    t8 = sqrt(t7)
    t9 = distortion0 + t8
    t10 = t4*t9
    t11 = t10 + t10
    t12 = 1/t8
    t13 = t12*t6
    t14 = (t11 + t13)*t4
    t15 = ideal0*t14
    t16 = -ideal1*t15
    t17 = distortion0*t2
    t18 = (t12*t17 - 1)*t4
    t19 = 1/t7
    t20 = sqrt(t19)
    return (
        ideal0*t10,
        ideal1*t10,
        -distortion0 + t4*t9,
        unmeasured,
        (-t0*t11 - t0*t13 + t9)*t4,
        t16,
        t16,
        (-t1*t11 - t1*t13 + t9)*t4,
        -t15,
        -ideal1*t14,
        0,
        0,
        0,
        0,
        0,
        1,
        -ideal0*t18,
        0,
        0,
        0,
        0,
        0,
        -ideal1*t18,
        0,
        0,
        0,
        0,
        0,
        -(t17*t20 - 1)*t4 - 1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    )
