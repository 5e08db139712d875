"""Generated from slamlib/sensors/fisheye.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, sqrt

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
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = arctan_ratio(t2, point2 + t5)
    t7 = t6 + t6
    ideal0 = point0*t7
    t8 = ideal0*ideal0
    ideal1 = point1*t7
    t9 = ideal1*ideal1
    t10 = t8 + t9
    t11 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t10)*t10)*t10)*t10)*t10)*t10)*t10)*t10 + 1
    return (
        ideal0*intrinsics2*t11 + intrinsics0,
        ideal1*intrinsics3*t11 + intrinsics1,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = point2 + t5
    t7 = arctan_ratio(t2, t6)
    t8 = t7 + t7
    ideal0 = point0*t8
    t9 = ideal0*ideal0
    ideal1 = point1*t8
    t10 = ideal1*ideal1
    t11 = t9 + t10
    t12 = distortion7*t11
    t13 = distortion5 + (distortion6 + t12)*t11
    t14 = distortion4 + t11*t13
    t15 = distortion3 + t11*t14
    t16 = distortion2 + t11*t15
    t17 = distortion1 + t11*t16
    t18 = distortion0 + t11*t17
    t19 = t11*t18 + 1
    t20 = ideal0*t19
    t21 = ideal1*t19
    t22 = intrinsics2 + intrinsics2
    t23 = 1/t5
    t24 = t6*t6
    t25 = t2 + t24
    t26 = 1/t25
    t27 = arctan_ratio_slope(t2, t6)
    t28 = t27 + t27
    t29 = -t23*t26 + t28
    t30 = point1*t29
    t31 = t12 + t12
    t32 = (t17 + (t16 + (t15 + (t14 + (t13 + (distortion6 + t31)*t11)*t11)*t11)*t11)*t11)*t11
    t33 = (t18 + t32)
    t34 = t33 + t33
    t35 = t34*ideal0*ideal1
    t36 = point0*t35
    t37 = t30*t36
    t38 = t0*t29 + t7
    t39 = t18 + t18
    t40 = t32 + t32
    t41 = t19 + t39*t9 + t40*t9
    t42 = point0*t41
    t43 = t1*t29 + t7
    t44 = (point2*t23 + 1)*t26
    t45 = intrinsics3 + intrinsics3
    t46 = t19 + t10*t39 + t10*t40
    t47 = point1*t46
    t48 = ideal0*intrinsics2
    t49 = t11*t11
    t50 = t49*t11
    t51 = t49*t49
    t52 = t50*t49
    t53 = t50*t50
    t54 = t51*t50
    t55 = t51*t51
    t56 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t20,
        intrinsics1 + intrinsics3*t21,
        (t37 + t38*t41)*t22,
        (t30*t42 + t35*t43)*t22,
        -(point1*t35 + t42)*t22*t44,
        0,
        (point0*t29*t47 + t35*t38)*t45,
        (t37 + t43*t46)*t45,
        -(t36 + t47)*t44*t45,
        0,
        1,
        0,
        t20,
        0,
        0,
        1,
        0,
        t21,
        t11*t48,
        t48*t49,
        t48*t50,
        t48*t51,
        t48*t52,
        t48*t53,
        t48*t54,
        t48*t55,
        t11*t56,
        t49*t56,
        t50*t56,
        t51*t56,
        t52*t56,
        t53*t56,
        t54*t56,
        t55*t56,
    )
