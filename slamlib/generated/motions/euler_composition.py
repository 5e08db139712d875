"""Generated from slamlib/motions/euler_composition.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "compose": "ae03fa8a6fc42f40",
}
SHAPES = {
    "compose": (6,),
}


def compose(pose, control):
    """compose: value."""
    pose0, pose1, pose2, pose3, pose4, pose5 = pose
    control0, control1, control2, control3, control4, control5 = control
    t0 = cos(pose3)
    t1 = cos(pose4)
    t2 = control0*t1
    t3 = sin(pose3)
    t4 = sin(pose5)
    t5 = t3*t4
    t6 = sin(pose4)
    t7 = cos(pose5)
    t8 = t0*t7
    t9 = t5 + t6*t8
    t10 = t3*t7
    t11 = t0*t4
    t12 = t10 - t11*t6
    t13 = t5*t6 + t8
    t14 = t10*t6 - t11
    t15 = t1*t4
    t16 = t1*t7
    t17 = cos(control3)
    t18 = cos(control4)
    t19 = t17*t18
    t20 = sin(control4)
    t21 = sin(control3)
    t22 = t18*t21
    t23 = t1*t19*t3 + t13*t22 - t14*t20
    t24 = -t0*t1*t17*t18 + t12*t22 + t20*t9
    t25 = sin(control5)
    t26 = t16*t18
    t27 = cos(control5)
    t28 = t21*t27
    t29 = t17*t25
    t30 = t17*t27
    t31 = t21*t25
    return (
        -control1*t12 + control2*t9 + pose0 + t0*t2,
        control1*t13 + control2*t14 + pose1 + t2*t3,
        -control0*t6 + control1*t15 + control2*t16 + pose2,
        arctan2(t23, -t24),
        arctan2(-t15*t22 + t16*t20 + t19*t6, sqrt(t23*t23 + t24*t24)),
        arctan2(t15*(t20*t31 + t30) + t25*t26 + t6*(-t20*t29 + t28), t15*(t20*t28 - t29) + t26*t27 - t6*(t20*t30 + t31)),
    )


def compose_jac(pose, control):
    """compose: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5 = pose
    control0, control1, control2, control3, control4, control5 = control
    t0 = cos(pose3)
    t1 = cos(pose4)
    t2 = control0*t1
    t3 = sin(pose3)
    t4 = sin(pose5)
    t5 = t3*t4
    t6 = sin(pose4)
    t7 = cos(pose5)
    t8 = t0*t7
    t9 = t5 + t6*t8
    t10 = t3*t7
    t11 = t0*t4
    t12 = t10 - t11*t6
    t13 = -control1*t12 + control2*t9 + t0*t2
    t14 = t5*t6 + t8
    t15 = t10*t6 - t11
    t16 = control1*t14 + control2*t15 + t2*t3
    t17 = t1*t4
    t18 = t1*t7
    t19 = -control0*t6 + control1*t17 + control2*t18
    t20 = t1*t3
    t21 = cos(control3)
    t22 = cos(control4)
    t23 = t21*t22
    t24 = sin(control4)
    t25 = sin(control3)
    t26 = t22*t25
    t27 = t14*t26 - t15*t24 + t20*t23
    t28 = -t0*t1*t21*t22 + t12*t26 + t24*t9
    t29 = -t28
    t30 = -t17*t26 + t18*t24 + t23*t6
    t31 = t27*t27
    t32 = cos(control5)
    t33 = t25*t32
    t34 = sin(control5)
    t35 = t21*t34
    t36 = -t24*t35 + t33
    t37 = t21*t32
    t38 = t25*t34
    t39 = t24*t38 + t37
    t40 = t18*t22
    t41 = t17*t39 + t34*t40
    t42 = t36*t6 + t41
    t43 = t24*t37 + t38
    t44 = t24*t33 - t35
    t45 = t17*t44 + t32*t40 - t43*t6
    t46 = t6*t7
    t47 = t29*t29 + t31
    t48 = 1/(t47)
    t49 = t14*t24
    t50 = t15*t22
    t51 = t25*t50 + t49
    t52 = t22*t9
    t53 = -t12*t24 + t25*t52
    t54 = t30*t30
    t55 = 1/(t47 + t54)
    t56 = t25*t6
    t57 = t22*t4
    t58 = sqrt(t47)
    t59 = 1/(t58)
    t60 = t24*t4
    t61 = t30*t59
    t62 = 1/(t42*t42 + t45*t45)
    t63 = t22*t46
    t64 = -t36
    t65 = t1*t43
    t66 = t44*t6
    t67 = t41 - t6*t64
    t68 = t0*t1
    t69 = -t12
    t70 = t12*t21 + t25*t68
    t71 = t14*t21 - t20*t25
    t72 = t21*t24
    t73 = t20*t72 + t25*t49 + t50
    t74 = t24*t25*t69 + t52 + t68*t72
    return (
        pose0 + t13,
        pose1 + t16,
        pose2 + t19,
        arctan2(t27, t29),
        arctan2(t30, sqrt(t28*t28 + t31)),
        arctan2(t42, t45),
        1,
        0,
        0,
        -t16,
        t0*t19,
        control1*t9 + control2*t12,
        0,
        1,
        0,
        t13,
        t19*t3,
        control1*t15 - control2*t14,
        0,
        0,
        1,
        0,
        -control1*t4*t6 - control2*t46 - t2,
        t1*(control1*t7 - control2*t4),
        0,
        0,
        0,
        1,
        t30*t48*(t0*t27 - t29*t3),
        t48*(-t27*t53 + t29*t51),
        0,
        0,
        0,
        0,
        t55*(t54*t59*(t0*t29 + t27*t3) + t58*(t1*t23 - t24*t46 + t56*t57)),
        -t55*(t1*t58*(t26*t7 + t60) + t61*(t27*t51 + t29*t53)),
        0,
        0,
        0,
        0,
        t62*(-t45*(t1*t64 + t34*t63 + t39*t4*t6) + t67*(t32*t63 + t4*t66 + t65)),
        t1*t62*(-t42*(-t32*t57 + t44*t7) + t45*(-t34*t57 + t39*t7)),
        t68,
        t69,
        t9,
        0,
        0,
        0,
        t20,
        t14,
        t15,
        0,
        0,
        0,
        -t6,
        t17,
        t18,
        0,
        0,
        0,
        0,
        0,
        0,
        t22*t48*(t27*t70 + t29*t71),
        t48*(t27*t74 - t29*t73),
        0,
        0,
        0,
        0,
        -t22*t55*(t58*(t17*t21 + t56) + t61*(t27*t71 - t29*t70)),
        t55*(t58*(t1*t25*t60 + t40 - t6*t72) + t61*(t27*t73 + t29*t74)),
        0,
        0,
        0,
        0,
        t62*(t45*(-t17*t36 + t39*t6) - t67*(t4*t65 + t66)),
        t30*t62*(t32*t67 - t34*t45),
        1,
    )
