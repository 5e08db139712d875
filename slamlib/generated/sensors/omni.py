"""Generated from slamlib/sensors/omni.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, sqrt, stumpff

DIGESTS = {
    "angles": "5e8d63abc72cce73",
    "image": "75419c6ad59a17dc",
    "pixel": "561f0c53e2622622",
    "project": "540312961ba33d81",
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
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = arctan_ratio(t2, point2 + t5)
    t7 = t6 + t6
    return (
        point0*t7,
        point1*t7,
    )


def angles_jac(point):
    """angles: value and Jacobians."""
    point0, point1, point2, _ = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = point2 + t5
    t7 = arctan_ratio(t2, t6)
    t8 = t7 + t7
    t9 = 1/t5
    t10 = t6*t6
    t11 = t2 + t10
    t12 = 1/t11
    t13 = arctan_ratio_slope(t2, t6)
    t14 = t13 + t13
    t15 = -t12*t9 + t14
    t16 = t0 + t0
    t17 = point0 + point0
    t18 = point1*t15*t17
    t19 = (point2*t9 + 1)*t12
    t20 = t1 + t1
    t21 = point1 + point1
    return (
        point0*t8,
        point1*t8,
        t16*t15 + t8,
        t18,
        -t17*t19,
        0,
        t18,
        t20*t15 + t8,
        -t21*t19,
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
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = arctan_ratio(t2, point2 + t5)
    t7 = t6 + t6
    angles1 = point1*t7
    angles0 = point0*t7
    t8 = angles0*angles0
    t9 = angles1*angles1
    t10 = t8 + t9
    t11 = sqrt(t10)
    t12 = t10*t11
    t13 = lens0 + (lens2 + (lens4 + (lens6 + (lens10*t10 + lens8)*t10)*t10)*t10)*t12 + (lens1 + (lens3 + (lens5 + (lens7 + lens9*t10)*t10)*t10)*t10)*t10
    t14 = angles1*t13
    t15 = angles0*t13
    return (
        intrinsics0 + intrinsics4*t14 + t15,
        intrinsics1 + intrinsics2*t14 + intrinsics3*t15,
    )


def project_jac(point, intrinsics, lens):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = point2*point2
    t4 = t3 + t2
    t5 = sqrt(t4)
    t6 = point2 + t5
    t7 = arctan_ratio(t2, t6)
    t8 = t7 + t7
    angles1 = point1*t8
    angles0 = point0*t8
    t9 = angles0*angles0
    t10 = angles1*angles1
    t11 = t9 + t10
    t12 = lens9*t11
    t13 = lens5 + (lens7 + t12)*t11
    t14 = lens3 + t11*t13
    t15 = lens1 + t11*t14
    t16 = sqrt(t11)
    t17 = t11*t16
    t18 = lens10*t11
    t19 = lens6 + (lens8 + t18)*t11
    t20 = lens4 + t11*t19
    t21 = lens2 + t11*t20
    t22 = lens0 + t11*t15 + t17*t21
    t23 = intrinsics4*t22
    t24 = angles0*t22
    t25 = intrinsics2*t22
    t26 = t15 + t15
    t27 = t18 + t18
    t28 = (t20 + (t19 + (lens8 + t27)*t11)*t11)
    t29 = t28 + t28
    t30 = t12 + t12
    t31 = (t14 + (t13 + (lens7 + t30)*t11)*t11)
    t32 = t31 + t31
    t33 = t26 + t29*t17 + 3*t16*t21 + t32*t11
    t34 = angles0*t33
    t35 = t10*t33
    t36 = angles1*t34 + intrinsics4*t35 + t23
    t37 = point1*t36
    t38 = 1/t5
    t39 = t6*t6
    t40 = t2 + t39
    t41 = 1/t40
    t42 = arctan_ratio_slope(t2, t6)
    t43 = t42 + t42
    t44 = -t38*t41 + t43
    t45 = point0*t44
    t46 = t37 + t37
    t47 = t0*t44 + t7
    t48 = angles1*intrinsics4
    t49 = t33*t9
    t50 = t22 + t34*t48 + t49
    t51 = t47 + t47
    t52 = t1*t44 + t7
    t53 = t36 + t36
    t54 = point0*t50
    t55 = point1*t44
    t56 = t54 + t54
    t57 = (point2*t38 + 1)
    t58 = t57 + t57
    t59 = t58*t41
    t60 = angles0*intrinsics3
    t61 = angles1*t33*t60 + intrinsics2*t35 + t25
    t62 = point1*t61
    t63 = t45 + t45
    t64 = angles1*intrinsics2
    t65 = intrinsics3*t22 + intrinsics3*t49 + t34*t64
    t66 = point0*t65
    t67 = t55 + t55
    t68 = t52 + t52
    t69 = angles1*t22
    t70 = angles0 + t48
    t71 = t11*t11
    t72 = t71*t16
    t73 = t71*t11
    t74 = t73*t16
    t75 = t71*t71
    t76 = t75*t16
    t77 = t73*t71
    t78 = t77*t16
    t79 = t60 + t64
    return (
        angles1*t23 + intrinsics0 + t24,
        angles1*t25 + intrinsics1 + intrinsics3*t24,
        t46*t45 + t51*t50,
        t53*t52 + t56*t55,
        -(t37 + t54)*t59,
        0,
        t63*t62 + t51*t65,
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
        t24,
        0,
        t70,
        t11*t70,
        t17*t70,
        t70*t71,
        t70*t72,
        t70*t73,
        t70*t74,
        t70*t75,
        t70*t76,
        t70*t77,
        t70*t78,
        t79,
        t11*t79,
        t17*t79,
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
