"""Generated from slamlib/sensors/double_sphere.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "project": "1e9944cd10d390b3",
    "back_project": "430d92b236225170",
}
SHAPES = {
    "project": (2,),
    "back_project": (4,),
}


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = point2*point2
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = sqrt(t4)
    direction2 = distortion0*t5 + point2
    t6 = direction2*direction2
    t7 = t6 + t3
    t8 = sqrt(t7)
    t9 = (distortion1 - 1)*direction2 - distortion1*t8
    t10 = 1/t9
    return (
        intrinsics0 - intrinsics2*point0*t10,
        intrinsics1 - intrinsics3*point1*t10,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1 = distortion
    t0 = point2*point2
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = sqrt(t4)
    direction2 = distortion0*t5 + point2
    t6 = direction2*direction2
    t7 = t6 + t3
    t8 = sqrt(t7)
    t9 = (distortion1 - 1)*direction2 - distortion1*t8
    t10 = 1/t9
    t11 = point0*t10
    t12 = point1*t10
    t13 = 1/t8
    t14 = distortion1*t13
    t15 = -t10
    t16 = t14*t15
    t17 = direction2*t14 - distortion1 + 1
    t18 = 1/t5
    t19 = distortion0*t18
    t20 = t17*t19
    t21 = t15*t20
    t22 = t14 + t20
    t23 = t10*t10
    t24 = intrinsics2*point0
    t25 = t23*t24
    t26 = (point2*t19 + 1)*t17
    t27 = intrinsics3*point1
    t28 = t23*t27
    t29 = t17*t5
    t30 = (direction2 - t8)*t23
    return (
        intrinsics0 - intrinsics2*t11,
        intrinsics1 - intrinsics3*t12,
        (t1*t16 + t1*t21 - 1)*intrinsics2*t10,
        -point1*t22*t25,
        -t25*t26,
        0,
        -point0*t22*t28,
        (t16*t2 + t2*t21 - 1)*intrinsics3*t10,
        -t26*t28,
        0,
        1,
        0,
        -t11,
        0,
        0,
        1,
        0,
        -t12,
        -t25*t29,
        t24*t30,
        -t28*t29,
        t27*t30,
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
    t5 = distortion1 + distortion1
    t6 = -(t5 - 1)*t4 + 1
    t7 = sqrt(t6)
    t8 = distortion1*t7 - distortion1 + 1
    t9 = 1/t8
    t10 = distortion1*distortion1
    direction2 = -(t10*t4 - 1)*t9
    t11 = direction2*direction2
    t12 = t4 + t11
    t13 = 1/t12
    t14 = distortion0*distortion0
    t15 = -(t14 - 1)*t4 + t11
    t16 = sqrt(t15)
    t17 = (direction2*distortion0 + t16)*t13
    return (
        ideal0*t17,
        ideal1*t17,
        direction2*t17 - distortion0,
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
    t2 = ideal0*ideal0
    t3 = 1/intrinsics3
    t4 = intrinsics1 - measurement1
    ideal1 = -t3*t4
    t5 = ideal1*ideal1
    t6 = t2 + t5
    t7 = distortion1 + distortion1
    t8 = t7 - 1
    t9 = -t6*t8 + 1
    t10 = sqrt(t9)
    t11 = distortion1*t10 - distortion1 + 1
    t12 = 1/t11
    t13 = distortion1*distortion1
    t14 = t13*t6 - 1
    t15 = t12*t14
    direction2 = -t15
    t16 = direction2*direction2
    t17 = t16 + t6
    t18 = 1/t17
    t19 = direction2*distortion0
    t20 = distortion0*distortion0
    t21 = t20 - 1
    t22 = t16 - t21*t6
    t23 = sqrt(t22)
    t24 = t19 + t23
    t25 = t18*t24
    t26 = direction2*t25
    t27 = 1/t23
    t28 = t21*t27
    t29 = t25 + t25
    t30 = t26 + t26
    t31 = direction2*t27 + distortion0
    t32 = -t30 + t31
    t33 = distortion1*t12
    t34 = 1/t10
    t35 = t34*t8
    t36 = (t12*t14*t35 + t7)*t32*t33
    t37 = -t19 - t23
    t38 = t2*t28 + t2*t29 + t2*t36 + t37
    t39 = t0*t18
    t40 = t38*t39
    t41 = t18*t3
    t42 = ideal1*t41
    t43 = t28 + t29
    t44 = t36 + t43
    t45 = ideal0*t44
    t46 = t42*t45
    t47 = ideal0*t39
    t48 = ideal1*t44*t47
    t49 = t28*t5 + t29*t5 + t36*t5 + t37
    t50 = t41*t49
    t51 = direction2*t31 - t16*t29 + t24
    t52 = -direction2*t43 - (t15*t35 + t7)*t33*t51
    t53 = t47*t52
    t54 = t42*t52
    t55 = t0*t0
    t56 = t1*t18*t55
    t57 = t3*t3
    t58 = t18*t4*t57
    t59 = ideal1*t58
    t60 = (direction2 - distortion0*t27*t6)*t18
    t61 = ((distortion1*t34*t6 - t10 + 1)*t15 + t6*t7)*t12*t18
    t62 = t32*t61
    return (
        ideal0*t25,
        ideal1*t25,
        -distortion0 + t26,
        unmeasured,
        -t40,
        -t46,
        -t48,
        -t50,
        t53,
        t54,
        0,
        0,
        0,
        0,
        0,
        1,
        t40,
        t46,
        -t38*t56,
        -t45*t59,
        t48,
        t50,
        -ideal1*t45*t56,
        -t49*t58,
        -t53,
        -t54,
        ideal0*t52*t56,
        t52*t59,
        0,
        0,
        0,
        0,
        ideal0*t60,
        -ideal0*t62,
        ideal1*t60,
        -ideal1*t62,
        direction2*t60 - 1,
        -t51*t61,
        0,
        0,
    )
