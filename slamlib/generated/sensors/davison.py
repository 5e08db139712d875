"""Generated from slamlib/sensors/davison.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "distorted": "eeaafa2cedcdff70",
    "undistorted": "1e5a97ac7d6d2e84",
    "project": "7b460a4de684453e",
    "back_project": "08403073d45efdf1",
}
SHAPES = {
    "distorted": (2,),
    "undistorted": (2,),
    "project": (2,),
    "back_project": (4,),
}


def distorted(ideal, distortion):
    """distorted: value."""
    ideal0, ideal1 = ideal
    distortion, = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = (t0 + t1)
    t3 = t2 + t2
    t4 = t3*distortion + 1
    t5 = 1/t4
    t6 = sqrt(t5)
    return (
        ideal0*t6,
        ideal1*t6,
    )


def distorted_jac(ideal, distortion):
    """distorted: value and Jacobians."""
    ideal0, ideal1 = ideal
    distortion, = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion + distortion
    t4 = t2*t3 + 1
    t5 = 1/t4
    t6 = sqrt(t5)
    t7 = t3*t5
    t8 = t5*t6
    t9 = -ideal0*ideal1*t3*t8
    t10 = t2*t8
    return (
        ideal0*t6,
        ideal1*t6,
        -(t0*t7 - 1)*t6,
        t9,
        t9,
        -(t1*t7 - 1)*t6,
        -ideal0*t10,
        -ideal1*t10,
    )


def undistorted(bent, distortion):
    """undistorted: value."""
    bent0, bent1 = bent
    distortion, = distortion
    t0 = bent0*bent0
    t1 = bent1*bent1
    t2 = (t0 + t1)
    t3 = t2 + t2
    t4 = -t3*distortion + 1
    t5 = 1/t4
    t6 = sqrt(t5)
    return (
        bent0*t6,
        bent1*t6,
    )


def undistorted_jac(bent, distortion):
    """undistorted: value and Jacobians."""
    bent0, bent1 = bent
    distortion, = distortion
    t0 = bent0*bent0
    t1 = bent1*bent1
    t2 = t0 + t1
    t3 = distortion + distortion
    t4 = t2*t3 - 1
    t5 = -t4
    t6 = 1/t5
    t7 = sqrt(t6)
    t8 = 1/t4
    t9 = t3*t8
    t10 = t6*t7
    t11 = bent0*bent1*t10*t3
    t12 = t10*t2
    return (
        bent0*t7,
        bent1*t7,
        -(t0*t9 - 1)*t7,
        t11,
        t11,
        -(t1*t9 - 1)*t7,
        bent0*t12,
        bent1*t12,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion, = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = (t1 + t2)
    t4 = t3 + t3
    t5 = t4*distortion + 1
    t6 = 1/t5
    t7 = sqrt(t6)
    return (
        ideal0*intrinsics2*t7 + intrinsics0,
        ideal1*intrinsics3*t7 + intrinsics1,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion, = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = distortion + distortion
    t5 = t3*t4 + 1
    t6 = 1/t5
    t7 = sqrt(t6)
    t8 = ideal0*t7
    t9 = ideal1*t7
    t10 = t4*t6
    t11 = t1*t10 - 1
    t12 = intrinsics2*t7
    t13 = ideal0*intrinsics2
    t14 = t6*t7
    t15 = t0*t14*t4
    t16 = t0*t0
    t17 = ideal0*ideal1*t10
    t18 = ideal1*intrinsics3
    t19 = t10*t2 - 1
    t20 = intrinsics3*t7
    t21 = t14*t3
    return (
        intrinsics0 + intrinsics2*t8,
        intrinsics1 + intrinsics3*t9,
        -t0*t11*t12,
        -ideal1*t13*t15,
        (point0*t11 + point1*t17)*t12*t16,
        0,
        -ideal0*t15*t18,
        -t0*t19*t20,
        (point0*t17 + point1*t19)*t16*t20,
        0,
        1,
        0,
        t8,
        0,
        0,
        1,
        0,
        t9,
        -t13*t21,
        -t18*t21,
    )


def back_project(measurement, unmeasured, intrinsics, distortion):
    """back_project: value."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion, = distortion
    t0 = 1/intrinsics2
    bent0 = -(intrinsics0 - measurement0)*t0
    t1 = bent0*bent0
    t2 = 1/intrinsics3
    bent1 = -(intrinsics1 - measurement1)*t2
    t3 = bent1*bent1
    t4 = (t1 + t3)
    t5 = t4 + t4
    t6 = -t5*distortion + 1
    t7 = 1/t6
    t8 = sqrt(t7)
    ideal0 = bent0*t8
    t9 = ideal0*ideal0
    ideal1 = bent1*t8
    t10 = ideal1*ideal1
    t11 = t9 + t10 + 1
    t12 = 1/t11
    t13 = sqrt(t12)
    return (
        ideal0*t13,
        ideal1*t13,
        t13,
        unmeasured,
    )


def back_project_jac(measurement, unmeasured, intrinsics, distortion):
    """back_project: value and Jacobians."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion, = distortion
    t0 = 1/intrinsics2
    t1 = intrinsics0 - measurement0
    bent0 = -t0*t1
    t2 = bent0*bent0
    t3 = 1/intrinsics3
    t4 = intrinsics1 - measurement1
    bent1 = -t3*t4
    t5 = bent1*bent1
    t6 = t2 + t5
    t7 = distortion + distortion
    t8 = t6*t7 - 1
    t9 = -t8
    t10 = 1/t9
    t11 = sqrt(t10)
    ideal0 = bent0*t11
    t12 = ideal0*ideal0
    ideal1 = bent1*t11
    t13 = ideal1*ideal1
    t14 = t12 + t13 + 1
    t15 = 1/t14
    t16 = sqrt(t15)
    t17 = bent0*ideal0
    t18 = bent1*ideal1
    t19 = 1/t8
    t20 = t19*t7
    t21 = t15*t17*t18*t20
    t22 = t12*t15 - 1
    t23 = t2*t20 - 1
    t24 = -t23
    t25 = t21 - t22*t24
    t26 = t11*t16
    t27 = t0*t26
    t28 = t26*t3
    t29 = t20*t5 - 1
    t30 = ideal0*t15
    t31 = ideal1*t30
    t32 = bent0*t22
    t33 = bent1*t20
    t34 = t32*t33
    t35 = t13*t15 - 1
    t36 = bent1*t35
    t37 = bent0*t20
    t38 = t36*t37
    t39 = -t29
    t40 = t21 - t35*t39
    t41 = t15*t16
    t42 = t11*t41
    t43 = ideal0*t24
    t44 = (t18*t37 - t43)*t42
    t45 = t0*t44
    t46 = ideal1*t39
    t47 = (t17*t33 - t46)*t42
    t48 = t3*t47
    t49 = -t30*t46 + t34
    t50 = t0*t0
    t51 = t1*t50
    t52 = t26*t51
    t53 = t3*t3
    t54 = t4*t53
    t55 = t26*t54
    t56 = ideal1*t15
    t57 = t38 - t43*t56
    t58 = t10*t11
    t59 = t58*t6
    t60 = t16*t59
    return (
        ideal0*t16,
        ideal1*t16,
        t16,
        unmeasured,
        t25*t27,
        (t29*t31 + t34)*t28,
        (t23*t31 + t38)*t27,
        t28*t40,
        t45,
        t48,
        0,
        0,
        0,
        0,
        0,
        1,
        -t25*t27,
        -t28*t49,
        t25*t52,
        t49*t55,
        -t27*t57,
        -t28*t40,
        t52*t57,
        t40*t55,
        -t45,
        -t48,
        t44*t51,
        t47*t54,
        0,
        0,
        0,
        0,
        -(t18*t30 + t32)*t60,
        -(t17*t56 + t36)*t60,
        -(t17 + t18)*t41*t59,
        0,
    )
