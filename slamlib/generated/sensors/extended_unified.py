"""Generated from slamlib/sensors/extended_unified.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "plane": "b19053538bef793c",
    "direction": "9e70d5686cb62150",
    "project": "6930775fc5abcbe9",
    "back_project": "a8b061f50c76377f",
}
SHAPES = {
    "plane": (2,),
    "direction": (3,),
    "project": (2,),
    "back_project": (4,),
}


def plane(direction, distortion):
    """plane: value."""
    direction0, direction1, direction2 = direction
    distortion0, distortion1 = distortion
    t0 = direction2*direction2
    t1 = direction0*direction0
    t2 = direction1*direction1
    t3 = t0 + (t1 + t2)*distortion1
    t4 = sqrt(t3)
    t5 = (distortion0 - 1)*direction2 - distortion0*t4
    t6 = 1/t5
    return (
        -direction0*t6,
        -direction1*t6,
    )


def plane_jac(direction, distortion):
    """plane: value and Jacobians."""
    direction0, direction1, direction2 = direction
    distortion0, distortion1 = distortion
    t0 = direction2*direction2
    t1 = direction0*direction0
    t2 = direction1*direction1
    t3 = t1 + t2
    t4 = t0 + distortion1*t3
    t5 = sqrt(t4)
    t6 = (distortion0 - 1)*direction2 - distortion0*t5
    t7 = 1/t6
    t8 = 1/t5
    t9 = distortion0*t8
    t10 = distortion1*t9
    t11 = -t10*t7
    t12 = t7*t7
    t13 = direction0*t12
    t14 = -direction1*t10*t13
    t15 = (direction2*t9 - distortion0 + 1)*t12
    t16 = (direction2 - t5)*t12
    t17 = (t3*t9)/2
    return (
        -direction0*t7,
        -direction1*t7,
        (t1*t11 - 1)*t7,
        t14,
        -direction0*t15,
        t14,
        (t11*t2 - 1)*t7,
        -direction1*t15,
        direction0*t16,
        -t13*t17,
        direction1*t16,
        -direction1*t12*t17,
    )


def direction(ideal, distortion):
    """direction: value."""
    ideal0, ideal1 = ideal
    distortion0, distortion1 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = (t0 + t1)*distortion1
    t3 = distortion0 + distortion0
    t4 = -(t3 - 1)*t2 + 1
    t5 = sqrt(t4)
    t6 = distortion0*t5 - distortion0 + 1
    t7 = 1/t6
    t8 = distortion0*distortion0
    return (
        ideal0,
        ideal1,
        -(t2*t8 - 1)*t7,
    )


def direction_jac(ideal, distortion):
    """direction: value and Jacobians."""
    ideal0, ideal1 = ideal
    distortion0, distortion1 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion1*t2
    t4 = distortion0 + distortion0
    t5 = t4 - 1
    t6 = -t3*t5 + 1
    t7 = sqrt(t6)
    t8 = distortion0*t7 - distortion0 + 1
    t9 = 1/t8
    t10 = distortion0*distortion0
    t11 = (t10*t3 - 1)*t9
    t12 = 1/t7
    t13 = (t4 + t11*t12*t5)*distortion0*t9
    t14 = distortion1*t13
    return (
        ideal0,
        ideal1,
        -t11,
        1,
        0,
        0,
        1,
        -ideal0*t14,
        -ideal1*t14,
        0,
        0,
        0,
        0,
        -(t3*t4 + (distortion0*t12*t3 - t7 + 1)*t11)*t9,
        (-t13*t2)/2,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = point2*point2
    t3 = (t0 + t1)*distortion1 + t2
    t4 = sqrt(t3)
    t5 = distortion0*t4 - (distortion0 - 1)*point2
    t6 = 1/t5
    return (
        intrinsics0 + intrinsics2*point0*t6,
        intrinsics1 + intrinsics3*point1*t6,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = point2*point2
    t4 = distortion1*t2 + t3
    t5 = sqrt(t4)
    t6 = distortion0*t5 - (distortion0 - 1)*point2
    t7 = 1/t6
    t8 = point0*t7
    t9 = point1*t7
    t10 = 1/t5
    t11 = distortion0*t10
    t12 = distortion1*t11
    t13 = t12*t7
    t14 = intrinsics2*point0
    t15 = t7*t7
    t16 = t12*t15
    t17 = (-distortion0 + point2*t11 + 1)*t15
    t18 = intrinsics3*point1
    t19 = (point2 - t5)*t15
    t20 = (t11*t15*t2)/2
    return (
        intrinsics0 + intrinsics2*t8,
        intrinsics1 + intrinsics3*t9,
        -(t0*t13 - 1)*intrinsics2*t7,
        -point1*t14*t16,
        -t14*t17,
        0,
        -point0*t16*t18,
        -(t1*t13 - 1)*intrinsics3*t7,
        -t17*t18,
        0,
        1,
        0,
        t8,
        0,
        0,
        1,
        0,
        t9,
        t14*t19,
        -t14*t20,
        t18*t19,
        -t18*t20,
    )


def back_project(measurement, unmeasured, intrinsics, distortion):
    """back_project: value."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = 1/intrinsics2
    ideal0 = -(intrinsics0 - measurement0)*t0
    t1 = ideal0*ideal0
    t2 = 1/intrinsics3
    ideal1 = -(intrinsics1 - measurement1)*t2
    t3 = ideal1*ideal1
    t4 = t1 + t3
    t5 = distortion1*t4
    t6 = distortion0*distortion0
    t7 = t5*t6 - 1
    t8 = distortion0 + distortion0
    t9 = -(t8 - 1)*t5 + 1
    t10 = sqrt(t9)
    t11 = distortion0*t10 - distortion0 + 1
    t12 = 1/t11
    t13 = t12*t7
    t14 = t13*t13
    t15 = t4 + t14
    t16 = 1/t15
    t17 = sqrt(t16)
    return (
        ideal0*t17,
        ideal1*t17,
        -t12*t17*t7,
        unmeasured,
    )


def back_project_jac(measurement, unmeasured, intrinsics, distortion):
    """back_project: value and Jacobians."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = 1/intrinsics2
    t1 = intrinsics0 - measurement0
    ideal0 = -t0*t1
    t2 = distortion0*distortion0
    t3 = ideal0*ideal0
    t4 = 1/intrinsics3
    t5 = intrinsics1 - measurement1
    ideal1 = -t4*t5
    t6 = ideal1*ideal1
    t7 = t3 + t6
    t8 = distortion1*t7
    t9 = t2*t8 - 1
    t10 = t9*t9
    t11 = distortion0 + distortion0
    t12 = t11 - 1
    t13 = -t12*t8 + 1
    t14 = sqrt(t13)
    t15 = distortion0*t14 - distortion0 + 1
    t16 = 1/t15
    t17 = t16*t16
    t18 = t10*t17
    t19 = t18 + t7
    t20 = 1/t19
    t21 = sqrt(t20)
    t22 = ideal0*t21
    t23 = ideal1*t21
    t24 = t16*t9
    t25 = 1/t14
    t26 = distortion0*t25
    t27 = distortion1*t26
    t28 = t17*t16
    t29 = t12*t27*t28
    t30 = -t9
    t31 = t30*t30
    t32 = distortion1 + distortion1
    t33 = t32*t2
    t34 = t17*t33
    t35 = (t29*t31 - t30*t34 + 1)*t20
    t36 = (t3*t35 - 1)*t21
    t37 = t0*t36
    t38 = t20*t21
    t39 = ideal0*t38
    t40 = (t10*t29 + t34*t9 + 1)*ideal1*t39
    t41 = t4*t40
    t42 = t0*t40
    t43 = (t35*t6 - 1)*t21
    t44 = t4*t43
    t45 = t12*t24
    t46 = (t33 + t27*t45 - t35*t9)*t16
    t47 = t22*t46
    t48 = t0*t47
    t49 = t23*t46
    t50 = t4*t49
    t51 = t0*t0
    t52 = t1*t51
    t53 = t4*t4
    t54 = t5*t53
    t55 = t11*t8 + (-t14 + t26*t8 + 1)*t24
    t56 = t17*t9
    t57 = t55*t56
    t58 = t11 + t25*t45
    t59 = (distortion0*t7)/2
    t60 = t56*t58*t59
    t61 = ideal1*t38
    t62 = t16*t21
    t63 = t18*t20
    return (
        t22,
        t23,
        -t21*t24,
        unmeasured,
        -t37,
        -t41,
        -t42,
        -t44,
        -t48,
        -t50,
        0,
        0,
        0,
        0,
        0,
        1,
        t37,
        t41,
        -t36*t52,
        -t40*t54,
        t42,
        t44,
        -t40*t52,
        -t43*t54,
        t48,
        t50,
        -t47*t52,
        -t49*t54,
        0,
        0,
        0,
        0,
        -t39*t57,
        -t39*t60,
        -t57*t61,
        -t60*t61,
        -(-t55*t63 + t55)*t62,
        -(-t58*t63 + t58)*t59*t62,
        0,
        0,
    )
