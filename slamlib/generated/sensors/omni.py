"""Generated from slamlib/sensors/omni.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, sqrt, stumpff

DIGESTS = {
    "angles": "427f97239d708025",
    "image": "c92bfd211ae9e382",
    "pixel": "4a9677e40d5b7c94",
    "project": "ba746a931756f24d",
    "ray": "f828436f8602591d",
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
    t0 = point0*point0 + point1*point1
    t1 = 2*arctan_ratio(t0, point2 + sqrt(point2*point2 + t0))
    return (
        point0*t1,
        point1*t1,
    )


def angles_jac(point):
    """angles: value and Jacobians."""
    point0, point1, point2, _ = point
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(point2*point2 + t2)
    t4 = point2 + t3
    t5 = arctan_ratio(t2, t4)
    t6 = 2*t5
    t7 = 1/(t3)
    t8 = 1/(t2 + t4*t4)
    t9 = -t7*t8 + 2*arctan_ratio_slope(t2, t4)
    t10 = 2*point0
    t11 = point1*t10*t9
    t12 = t8*(point2*t7 + 1)
    return (
        point0*t6,
        point1*t6,
        2*t0*t9 + 2*t5,
        t11,
        -t10*t12,
        0,
        t11,
        2*t1*t9 + 2*t5,
        -2*point1*t12,
        0,
    )


def image(angles, lens):
    """image: value."""
    angles0, angles1 = angles
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0 + angles1*angles1
    t1 = lens0 + t0*sqrt(t0)*(lens2 + t0*(lens4 + t0*(lens6 + t0*(lens10*t0 + lens8)))) + t0*(lens1 + t0*(lens3 + t0*(lens5 + t0*(lens7 + lens9*t0))))
    return (
        angles0*t1,
        angles1*t1,
    )


def image_jac(angles, lens):
    """image: value and Jacobians."""
    angles0, angles1 = angles
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = lens9*t2
    t4 = lens5 + t2*(lens7 + t3)
    t5 = lens3 + t2*t4
    t6 = t2*t5
    t7 = t2*sqrt(t2)
    t8 = lens10*t2
    t9 = lens6 + t2*(lens8 + t8)
    t10 = lens4 + t2*t9
    t11 = lens2 + t10*t2
    t12 = lens0 + t11*t7 + t2*(lens1 + t6)
    t13 = 2*lens1 + 3*t11*sqrt(t2) + 2*t2*(t2*(t2*(lens7 + 2*t3) + t4) + t5) + 2*t6 + 2*t7*(t10 + t2*(t2*(lens8 + 2*t8) + t9))
    t14 = angles0*angles1*t13
    t15 = t2*t2
    t16 = t2*t2*sqrt(t2)
    t17 = t2*t2*t2
    t18 = t2*t2*t2*sqrt(t2)
    t19 = t2*t2*t2*t2
    t20 = t2*t2*t2*t2*sqrt(t2)
    t21 = t2*t2*t2*t2*t2
    t22 = t2*t2*t2*t2*t2*sqrt(t2)
    return (
        angles0*t12,
        angles1*t12,
        t0*t13 + t12,
        t14,
        t14,
        t1*t13 + t12,
        angles0,
        angles0*t2,
        angles0*t7,
        angles0*t15,
        angles0*t16,
        angles0*t17,
        angles0*t18,
        angles0*t19,
        angles0*t20,
        angles0*t21,
        angles0*t22,
        angles1,
        angles1*t2,
        angles1*t7,
        angles1*t15,
        angles1*t16,
        angles1*t17,
        angles1*t18,
        angles1*t19,
        angles1*t20,
        angles1*t21,
        angles1*t22,
    )


def pixel(angles, intrinsics, lens):
    """pixel: value."""
    angles0, angles1 = angles
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0 + angles1*angles1
    t1 = lens0 + t0*sqrt(t0)*(lens2 + t0*(lens4 + t0*(lens6 + t0*(lens10*t0 + lens8)))) + t0*(lens1 + t0*(lens3 + t0*(lens5 + t0*(lens7 + lens9*t0))))
    t2 = angles0*t1
    t3 = angles1*t1
    return (
        intrinsics0 + intrinsics4*t3 + t2,
        intrinsics1 + intrinsics2*t3 + intrinsics3*t2,
    )


def pixel_jac(angles, intrinsics, lens):
    """pixel: value and Jacobians."""
    angles0, angles1 = angles
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = angles0*angles0
    t1 = angles1*angles1
    t2 = t0 + t1
    t3 = lens9*t2
    t4 = lens5 + t2*(lens7 + t3)
    t5 = lens3 + t2*t4
    t6 = t2*t5
    t7 = t2*sqrt(t2)
    t8 = lens10*t2
    t9 = lens6 + t2*(lens8 + t8)
    t10 = lens4 + t2*t9
    t11 = lens2 + t10*t2
    t12 = lens0 + t11*t7 + t2*(lens1 + t6)
    t13 = angles0*t12
    t14 = intrinsics4*t12
    t15 = intrinsics2*t12
    t16 = 2*lens1 + 3*t11*sqrt(t2) + 2*t2*(t2*(t2*(lens7 + 2*t3) + t4) + t5) + 2*t6 + 2*t7*(t10 + t2*(t2*(lens8 + 2*t8) + t9))
    t17 = t0*t16
    t18 = angles1*intrinsics4
    t19 = angles0*t16
    t20 = t1*t16
    t21 = angles1*intrinsics2
    t22 = angles0*intrinsics3
    t23 = angles1*t12
    t24 = angles0 + t18
    t25 = t2*t2
    t26 = t2*t2*sqrt(t2)
    t27 = t2*t2*t2
    t28 = t2*t2*t2*sqrt(t2)
    t29 = t2*t2*t2*t2
    t30 = t2*t2*t2*t2*sqrt(t2)
    t31 = t2*t2*t2*t2*t2
    t32 = t2*t2*t2*t2*t2*sqrt(t2)
    t33 = t21 + t22
    return (
        angles1*t14 + intrinsics0 + t13,
        angles1*t15 + intrinsics1 + intrinsics3*t13,
        t12 + t17 + t18*t19,
        angles1*t19 + intrinsics4*t20 + t14,
        intrinsics3*t12 + intrinsics3*t17 + t19*t21,
        angles1*t16*t22 + intrinsics2*t20 + t15,
        1,
        0,
        0,
        0,
        t23,
        0,
        1,
        t23,
        t13,
        0,
        t24,
        t2*t24,
        t24*t7,
        t24*t25,
        t24*t26,
        t24*t27,
        t24*t28,
        t24*t29,
        t24*t30,
        t24*t31,
        t24*t32,
        t33,
        t2*t33,
        t33*t7,
        t25*t33,
        t26*t33,
        t27*t33,
        t28*t33,
        t29*t33,
        t30*t33,
        t31*t33,
        t32*t33,
    )


def project(point, intrinsics, lens):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = point0*point0 + point1*point1
    t1 = arctan_ratio(t0, point2 + sqrt(point2*point2 + t0))
    t2 = t1*t1
    t3 = 4*t0*t2
    t4 = 2*t1*(lens0 + 8*t0*sqrt(t0)*t2*sqrt(t2)*(lens2 + t3*(lens4 + t3*(lens6 + t3*(lens10*t3 + lens8)))) + t3*(lens1 + t3*(lens3 + t3*(lens5 + t3*(lens7 + lens9*t3)))))
    t5 = point0*t4
    t6 = point1*t4
    return (
        intrinsics0 + intrinsics4*t6 + t5,
        intrinsics1 + intrinsics2*t6 + intrinsics3*t5,
    )


def project_jac(point, intrinsics, lens):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    lens0, lens1, lens2, lens3, lens4, lens5, lens6, lens7, lens8, lens9, lens10 = lens
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(point2*point2 + t2)
    t4 = point2 + t3
    t5 = arctan_ratio(t2, t4)
    t6 = t5*t5
    t7 = 4*t6
    t8 = t2*t7
    t9 = lens5 + t8*(lens7 + lens9*t8)
    t10 = lens3 + t8*t9
    t11 = lens1 + t10*t8
    t12 = t11*t2
    t13 = t2*sqrt(t2)
    t14 = lens6 + t8*(lens10*t8 + lens8)
    t15 = lens4 + t14*t8
    t16 = lens2 + t15*t8
    t17 = t13*t16
    t18 = t6*sqrt(t6)
    t19 = 8*t18
    t20 = lens0 + t12*t7 + t17*t19
    t21 = t20*t5
    t22 = 2*t21
    t23 = point0*t22
    t24 = intrinsics4*point1
    t25 = intrinsics2*point1
    t26 = intrinsics3*point0
    t27 = 1/(t3)
    t28 = 1/(t2 + t4*t4)
    t29 = -t27*t28 + 2*arctan_ratio_slope(t2, t4)
    t30 = t0*t29
    t31 = t20*t30
    t32 = point0*t20
    t33 = t29*t32
    t34 = t1*t29
    t35 = 3*sqrt(t6)
    t36 = 8*t6
    t37 = t2*t36
    t38 = t10 + t8*(t8*(lens7 + lens9*t37) + t9)
    t39 = t19*(t15 + t8*(t14 + t8*(lens10*t37 + lens8)))
    t40 = t36*(t30 + t34 + t5)*(t11 + t13*t39 + t16*sqrt(t2)*t35 + t38*t8)
    t41 = t0*t40
    t42 = point0*t40
    t43 = t20*t34
    t44 = t1*t40
    t45 = t2*t2
    t46 = t2*t2*sqrt(t2)
    t47 = t36*(t12 + t17*t35 + t38*t45*t7 + t39*t46)
    t48 = 2*t28*(point2*t27 + 1)
    t49 = intrinsics3*t32
    t50 = point1*t22
    t51 = point0 + t24
    t52 = 2*t5
    t53 = 8*t2*t5*t5*t5
    t54 = t5*t51
    t55 = 16*t13*t18
    t56 = 32*t45*t5*t5*t5*t5*t5
    t57 = 64*t46*t6*t6*sqrt(t6)
    t58 = 128*t2*t2*t2*t5*t5*t5*t5*t5*t5*t5
    t59 = 256*t2*t2*t2*sqrt(t2)*t6*t6*t6*sqrt(t6)
    t60 = 512*t2*t2*t2*t2*t5*t5*t5*t5*t5*t5*t5*t5*t5
    t61 = 1024*t2*t2*t2*t2*sqrt(t2)*t6*t6*t6*t6*sqrt(t6)
    t62 = 2048*t2*t2*t2*t2*t2*t5*t5*t5*t5*t5*t5*t5*t5*t5*t5*t5
    t63 = 4096*t2*t2*t2*t2*t2*sqrt(t2)*t6*t6*t6*t6*t6*sqrt(t6)
    t64 = t25 + t26
    t65 = t5*t64
    return (
        intrinsics0 + t22*t24 + t23,
        intrinsics1 + t22*t25 + t22*t26,
        2*t21 + 2*t24*t33 + 2*t24*t42 + 2*t31 + 2*t41,
        2*intrinsics4*t21 + 2*intrinsics4*t43 + 2*intrinsics4*t44 + 2*point1*t33 + 2*point1*t42,
        -t48*(point0*t47 + t20*t24 + t24*t47 + t32),
        0,
        2*intrinsics3*t21 + 2*intrinsics3*t31 + 2*intrinsics3*t41 + 2*t25*t33 + 2*t25*t42,
        2*intrinsics2*t21 + 2*intrinsics2*t43 + 2*intrinsics2*t44 + 2*point1*t26*t40 + 2*point1*t29*t49,
        -t48*(t20*t25 + t25*t47 + t26*t47 + t49),
        0,
        1,
        0,
        0,
        0,
        t50,
        0,
        1,
        t50,
        t23,
        0,
        t51*t52,
        t51*t53,
        t54*t55,
        t51*t56,
        t54*t57,
        t51*t58,
        t54*t59,
        t51*t60,
        t54*t61,
        t51*t62,
        t54*t63,
        t52*t64,
        t53*t64,
        t55*t65,
        t56*t64,
        t57*t65,
        t58*t64,
        t59*t65,
        t60*t64,
        t61*t65,
        t62*t64,
        t63*t65,
    )


def ray(angles, unmeasured):
    """ray: value."""
    angles0, angles1 = angles
    unmeasured, = unmeasured
    t0 = angles0*angles0 + angles1*angles1
    t1 = stumpff(1, t0)
    return (
        angles0*t1,
        angles1*t1,
        stumpff(0, t0),
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
    t6 = -t3
    t7 = stumpff(2, t2) - stumpff(3, t2)
    t8 = -angles0*angles1*t7
    return (
        t4,
        t5,
        stumpff(0, t2),
        unmeasured,
        -t0*t7 - t6,
        t8,
        t8,
        -t1*t7 - t6,
        -t4,
        -t5,
        0,
        0,
        0,
        0,
        0,
        1,
    )
