"""Generated from slamlib/sensors/omni.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, norm_plus, sqrt, stumpff

DIGESTS = {
    "angles": "0cb61d72b39120e4",
    "image": "75419c6ad59a17dc",
    "pixel": "561f0c53e2622622",
    "project": "c79a4612fc59afff",
    "ray": "8fb2471ea16807f4",
}
SHAPES = {
    "angles": (2,),
    "image": (2,),
    "pixel": (2,),
    "project": (2,),
    "ray": (4,),
}


def angles(point):
    """angles: value."""
    point0, point1, point2, _ = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = arctan_ratio(t2, norm_plus(t2, point2))
    t4 = t3 + t3
    return (
        point0*t4,
        point1*t4,
    )


def angles_jac(point):
    """angles: value and Jacobians."""
    point0, point1, point2, _ = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = norm_plus(t2, point2)
    t4 = arctan_ratio(t2, t3)
    t5 = t4 + t4
    t6 = point2*point2
    t7 = t6 + t2
    t8 = 1/t7
    t9 = sqrt(t8)
    t10 = t3*t3
    t11 = t2 + t10
    t12 = 1/t11
    t13 = t12*t9
    t14 = arctan_ratio_slope(t2, t3)
    t15 = t14 + t14
    t16 = -t13 + t15
    t17 = t0 + t0
    t18 = point0 + point0
    t19 = point1*t16*t18
    t20 = t13*t3
    t21 = t1 + t1
    t22 = point1 + point1
    return (
        point0*t5,
        point1*t5,
        t17*t16 + t5,
        t19,
        -t18*t20,
        0,
        t19,
        t21*t16 + t5,
        -t22*t20,
        0,
    )


def image(angles, lens):
    """image: value."""
    angles0, angles1 = angles
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = t2*t3
    t5 = lens0 + (lens2 + (lens4 + (lens6 + (lens10*t2 + lens8)*t2)*t2)*t2)*t4 + (lens1 + (lens3 + (lens5 + (lens7 + lens9*t2)*t2)*t2)*t2)*t2
    return (
        angles0*t5,
        angles1*t5,
    )


def image_jac(angles, lens):
    """image: value and Jacobians."""
    angles0, angles1 = angles
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = lens10*t2
    t4 = lens6 + (lens8 + t3)*t2
    t5 = lens4 + t2*t4
    t6 = lens2 + t2*t5
    t7 = sqrt(t2)
    t8 = t2*t7
    t9 = lens9*t2
    t10 = lens5 + (lens7 + t9)*t2
    t11 = lens3 + t10*t2
    t12 = lens1 + t11*t2
    t13 = lens0 + t6*t8 + t12*t2
    t14 = t9 + t9
    t15 = (((lens7 + t14)*t2 + t10)*t2 + t11)
    t16 = t15 + t15
    t17 = t12 + t12
    t18 = t3 + t3
    t19 = (t5 + ((lens8 + t18)*t2 + t4)*t2)
    t20 = t19 + t19
    t21 = 3*t6*t7 + t16*t2 + t17 + t20*t8
    t22 = angles0*angles1*t21
    t23 = t2*t2
    t24 = t23*t7
    t25 = t23*t2
    t26 = t25*t7
    t27 = t23*t23
    t28 = t27*t7
    t29 = t25*t23
    t30 = t29*t7
    return (
        angles0*t13,
        angles1*t13,
        t0*t21 + t13,
        t22,
        t22,
        t1*t21 + t13,
        angles0,
        angles0*t2,
        angles0*t8,
        angles0*t23,
        angles0*t24,
        angles0*t25,
        angles0*t26,
        angles0*t27,
        angles0*t28,
        angles0*t29,
        angles0*t30,
        angles1,
        angles1*t2,
        angles1*t8,
        angles1*t23,
        angles1*t24,
        angles1*t25,
        angles1*t26,
        angles1*t27,
        angles1*t28,
        angles1*t29,
        angles1*t30,
    )


def pixel(angles, intrinsics, lens):
    """pixel: value."""
    angles0, angles1 = angles
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = t2*t3
    t5 = lens0 + (lens2 + (lens4 + (lens6 + (lens10*t2 + lens8)*t2)*t2)*t2)*t4 + (lens1 + (lens3 + (lens5 + (lens7 + lens9*t2)*t2)*t2)*t2)*t2
    t6 = angles1*t5
    t7 = angles0*t5
    return (
        intrinsics0 + intrinsics4*t6 + t7,
        intrinsics1 + intrinsics2*t6 + intrinsics3*t7,
    )


def pixel_jac(angles, intrinsics, lens):
    """pixel: value and Jacobians."""
    angles0, angles1 = angles
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = lens10*t2
    t4 = lens6 + (lens8 + t3)*t2
    t5 = lens4 + t2*t4
    t6 = lens2 + t2*t5
    t7 = sqrt(t2)
    t8 = t2*t7
    t9 = lens9*t2
    t10 = lens5 + (lens7 + t9)*t2
    t11 = lens3 + t10*t2
    t12 = lens1 + t11*t2
    t13 = lens0 + t6*t8 + t12*t2
    t14 = intrinsics4*t13
    t15 = angles0*t13
    t16 = intrinsics2*t13
    t17 = t9 + t9
    t18 = (((lens7 + t17)*t2 + t10)*t2 + t11)
    t19 = t18 + t18
    t20 = t12 + t12
    t21 = t3 + t3
    t22 = (t5 + ((lens8 + t21)*t2 + t4)*t2)
    t23 = t22 + t22
    t24 = 3*t6*t7 + t19*t2 + t20 + t23*t8
    t25 = t0*t24
    t26 = angles1*intrinsics4
    t27 = angles0*t24
    t28 = t1*t24
    t29 = angles1*intrinsics2
    t30 = angles0*intrinsics3
    t31 = angles1*t13
    t32 = angles0 + t26
    t33 = t2*t2
    t34 = t33*t7
    t35 = t33*t2
    t36 = t35*t7
    t37 = t33*t33
    t38 = t37*t7
    t39 = t35*t33
    t40 = t39*t7
    t41 = t29 + t30
    return (
        angles1*t14 + intrinsics0 + t15,
        angles1*t16 + intrinsics1 + intrinsics3*t15,
        t13 + t25 + t26*t27,
        angles1*t27 + intrinsics4*t28 + t14,
        intrinsics3*t13 + intrinsics3*t25 + t27*t29,
        angles1*t24*t30 + intrinsics2*t28 + t16,
        1,
        0,
        0,
        0,
        t31,
        0,
        1,
        t31,
        t15,
        0,
        t32,
        t2*t32,
        t32*t8,
        t32*t33,
        t32*t34,
        t32*t35,
        t32*t36,
        t32*t37,
        t32*t38,
        t32*t39,
        t32*t40,
        t41,
        t2*t41,
        t41*t8,
        t33*t41,
        t34*t41,
        t35*t41,
        t36*t41,
        t37*t41,
        t38*t41,
        t39*t41,
        t40*t41,
    )


def project(point, intrinsics, lens):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = arctan_ratio(t2, norm_plus(t2, point2))
    t4 = t3 + t3
    angles1 = point1*t4
    angles0 = point0*t4
    t5 = angles0*angles0
    t6 = angles1*angles1
    t7 = t5 + t6
    t8 = sqrt(t7)
    t9 = t7*t8
    t10 = lens0 + (lens2 + (lens4 + (lens6 + (lens10*t7 + lens8)*t7)*t7)*t7)*t9 + (lens1 + (lens3 + (lens5 + (lens7 + lens9*t7)*t7)*t7)*t7)*t7
    t11 = angles1*t10
    t12 = angles0*t10
    return (
        intrinsics0 + intrinsics4*t11 + t12,
        intrinsics1 + intrinsics2*t11 + intrinsics3*t12,
    )


def project_jac(point, intrinsics, lens):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = norm_plus(t2, point2)
    t4 = arctan_ratio(t2, t3)
    t5 = t4 + t4
    angles1 = point1*t5
    angles0 = point0*t5
    t6 = angles0*angles0
    t7 = angles1*angles1
    t8 = t6 + t7
    t9 = lens9*t8
    t10 = lens5 + (lens7 + t9)*t8
    t11 = lens3 + t10*t8
    t12 = lens1 + t11*t8
    t13 = sqrt(t8)
    t14 = t8*t13
    t15 = lens10*t8
    t16 = lens6 + (lens8 + t15)*t8
    t17 = lens4 + t16*t8
    t18 = lens2 + t17*t8
    t19 = lens0 + t12*t8 + t14*t18
    t20 = intrinsics4*t19
    t21 = angles0*t19
    t22 = intrinsics2*t19
    t23 = t12 + t12
    t24 = t15 + t15
    t25 = (t17 + (t16 + (lens8 + t24)*t8)*t8)
    t26 = t25 + t25
    t27 = t9 + t9
    t28 = (t11 + (t10 + (lens7 + t27)*t8)*t8)
    t29 = t28 + t28
    t30 = t23 + t26*t14 + 3*t13*t18 + t29*t8
    t31 = angles0*t30
    t32 = t30*t7
    t33 = angles1*t31 + intrinsics4*t32 + t20
    t34 = point1*t33
    t35 = point2*point2
    t36 = t35 + t2
    t37 = 1/t36
    t38 = sqrt(t37)
    t39 = t3*t3
    t40 = t2 + t39
    t41 = 1/t40
    t42 = t38*t41
    t43 = arctan_ratio_slope(t2, t3)
    t44 = t43 + t43
    t45 = -t42 + t44
    t46 = point0*t45
    t47 = t34 + t34
    t48 = t0*t45 + t4
    t49 = angles1*intrinsics4
    t50 = t30*t6
    t51 = t19 + t31*t49 + t50
    t52 = t48 + t48
    t53 = t1*t45 + t4
    t54 = t33 + t33
    t55 = point0*t51
    t56 = point1*t45
    t57 = t55 + t55
    t58 = t3 + t3
    t59 = t58*t42
    t60 = angles0*intrinsics3
    t61 = angles1*t30*t60 + intrinsics2*t32 + t22
    t62 = point1*t61
    t63 = t46 + t46
    t64 = angles1*intrinsics2
    t65 = intrinsics3*t19 + intrinsics3*t50 + t31*t64
    t66 = point0*t65
    t67 = t56 + t56
    t68 = t53 + t53
    t69 = angles1*t19
    t70 = angles0 + t49
    t71 = t8*t8
    t72 = t71*t13
    t73 = t71*t8
    t74 = t73*t13
    t75 = t71*t71
    t76 = t75*t13
    t77 = t73*t71
    t78 = t77*t13
    t79 = t60 + t64
    return (
        angles1*t20 + intrinsics0 + t21,
        angles1*t22 + intrinsics1 + intrinsics3*t21,
        t47*t46 + t52*t51,
        t54*t53 + t57*t56,
        -(t34 + t55)*t59,
        0,
        t63*t62 + t52*t65,
        t67*t66 + t68*t61,
        -(t62 + t66)*t59,
        0,
        1,
        0,
        0,
        0,
        t69,
        0,
        1,
        t69,
        t21,
        0,
        t70,
        t70*t8,
        t14*t70,
        t70*t71,
        t70*t72,
        t70*t73,
        t70*t74,
        t70*t75,
        t70*t76,
        t70*t77,
        t70*t78,
        t79,
        t79*t8,
        t14*t79,
        t71*t79,
        t72*t79,
        t73*t79,
        t74*t79,
        t75*t79,
        t76*t79,
        t77*t79,
        t78*t79,
    )


def ray(angles, unmeasured):
    """ray: value."""
    angles0, angles1 = angles
    unmeasured, = unmeasured
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = stumpff(1, t2)
    return (
        angles0*t3,
        angles1*t3,
        stumpff(0, t2),
        unmeasured,
    )


def ray_jac(angles, unmeasured):
    """ray: value and Jacobians."""
    angles0, angles1 = angles
    unmeasured, = unmeasured
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = stumpff(1, t2)
    t4 = angles0*t3
    t5 = angles1*t3
    t6 = stumpff(2, t2) - stumpff(3, t2)
    t7 = -t3
    t8 = -angles0*angles1*t6
    return (
        t4,
        t5,
        stumpff(0, t2),
        unmeasured,
        -t0*t6 - t7,
        t8,
        t8,
        -t1*t6 - t7,
        -t4,
        -t5,
        0,
        0,
        0,
        0,
        0,
        1,
    )
