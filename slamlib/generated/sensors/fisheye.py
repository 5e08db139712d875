"""Generated from slamlib/sensors/fisheye.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, norm_plus, sqrt

DIGESTS = {
    "project": "c0b105ec60262837",
}
SHAPES = {
    "project": (2,),
}


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = arctan_ratio(t2, norm_plus(t2, point2))
    t4 = t3 + t3
    ideal0 = point0*t4
    t5 = ideal0*ideal0
    ideal1 = point1*t4
    t6 = ideal1*ideal1
    t7 = t5 + t6
    t8 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t7)*t7)*t7)*t7)*t7)*t7)*t7)*t7 + 1
    return (
        ideal0*intrinsics2*t8 + intrinsics0,
        ideal1*intrinsics3*t8 + intrinsics1,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = norm_plus(t2, point2)
    t4 = arctan_ratio(t2, t3)
    t5 = t4 + t4
    ideal0 = point0*t5
    t6 = ideal0*ideal0
    ideal1 = point1*t5
    t7 = ideal1*ideal1
    t8 = t6 + t7
    t9 = distortion7*t8
    t10 = distortion5 + (distortion6 + t9)*t8
    t11 = distortion4 + t10*t8
    t12 = distortion3 + t11*t8
    t13 = distortion2 + t12*t8
    t14 = distortion1 + t13*t8
    t15 = distortion0 + t14*t8
    t16 = t15*t8 + 1
    t17 = ideal0*t16
    t18 = ideal1*t16
    t19 = intrinsics2 + intrinsics2
    t20 = point2*point2
    t21 = t20 + t2
    t22 = 1/t21
    t23 = sqrt(t22)
    t24 = t3*t3
    t25 = t2 + t24
    t26 = 1/t25
    t27 = t23*t26
    t28 = arctan_ratio_slope(t2, t3)
    t29 = t28 + t28
    t30 = -t27 + t29
    t31 = point1*t30
    t32 = t9 + t9
    t33 = (t14 + (t13 + (t12 + (t11 + (t10 + (distortion6 + t32)*t8)*t8)*t8)*t8)*t8)*t8
    t34 = (t15 + t33)
    t35 = t34 + t34
    t36 = t35*ideal0*ideal1
    t37 = point0*t36
    t38 = t31*t37
    t39 = t0*t30 + t4
    t40 = t15 + t15
    t41 = t33 + t33
    t42 = t16 + t40*t6 + t41*t6
    t43 = point0*t42
    t44 = t1*t30 + t4
    t45 = t27*t3
    t46 = intrinsics3 + intrinsics3
    t47 = t16 + t40*t7 + t41*t7
    t48 = point1*t47
    t49 = ideal0*intrinsics2
    t50 = t8*t8
    t51 = t50*t8
    t52 = t50*t50
    t53 = t51*t50
    t54 = t51*t51
    t55 = t52*t51
    t56 = t52*t52
    t57 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t17,
        intrinsics1 + intrinsics3*t18,
        (t38 + t39*t42)*t19,
        (t31*t43 + t36*t44)*t19,
        -(point1*t36 + t43)*t19*t45,
        0,
        (point0*t30*t48 + t36*t39)*t46,
        (t38 + t44*t47)*t46,
        -(t37 + t48)*t45*t46,
        0,
        1,
        0,
        t17,
        0,
        0,
        1,
        0,
        t18,
        t49*t8,
        t49*t50,
        t49*t51,
        t49*t52,
        t49*t53,
        t49*t54,
        t49*t55,
        t49*t56,
        t57*t8,
        t50*t57,
        t51*t57,
        t52*t57,
        t53*t57,
        t54*t57,
        t55*t57,
        t56*t57,
    )
