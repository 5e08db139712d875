"""Generated from slamlib/motions/euler_composition.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "compose": "80fcf0a1e2cb3cd9",
}
SHAPES = {
    "compose": (6,),
}


def compose(pose, control):
    """compose: value."""
    pose0, pose1, pose2, pose3, pose4, pose5 = pose
    control0, control1, control2, control3, control4, control5 = control
    t0 = sin(pose3)
    t1 = cos(pose5)
    t2 = t0*t1
    t3 = cos(pose3)
    t4 = sin(pose5)
    t5 = t3*t4
    t6 = sin(pose4)
    t7 = t2 - t5*t6
    t8 = t0*t4
    t9 = t1*t3
    t10 = t8 + t6*t9
    t11 = cos(pose4)
    t12 = control0*t11
    t13 = t6*t8 + t9
    t14 = t2*t6 - t5
    t15 = t11*t4
    t16 = t1*t11
    t17 = cos(control4)
    t18 = sin(control3)
    t19 = t17*t18
    t20 = sin(control4)
    t21 = cos(control3)
    t22 = t17*t21
    t23 = t11*t22
    t24 = t13*t19 - t14*t20 + t0*t23
    t25 = -t23*t3 + t19*t7 + t10*t20
    t26 = t24*t24
    t27 = t25*t25
    t28 = t26 + t27
    t29 = sqrt(t28)
    t30 = sin(control5)
    t31 = t18*t30
    t32 = cos(control5)
    t33 = t21*t32
    t34 = t16*t17
    t35 = t21*t30
    t36 = t18*t32
    return (
        -control1*t7 + control2*t10 + pose0 + t12*t3,
        control1*t13 + control2*t14 + pose1 + t0*t12,
        -control0*t6 + control1*t15 + control2*t16 + pose2,
        arctan2(t24, -t25),
        arctan2(-t15*t19 + t16*t20 + t22*t6, t29),
        arctan2((t20*t31 + t33)*t15 + t30*t34 + (-t20*t35 + t36)*t6, (t20*t36 - t35)*t15 + t32*t34 - (t20*t33 + t31)*t6),
    )


def compose_jac(pose, control):
    """compose: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5 = pose
    control0, control1, control2, control3, control4, control5 = control
    t0 = sin(pose3)
    t1 = cos(pose5)
    t2 = t0*t1
    t3 = cos(pose3)
    t4 = sin(pose5)
    t5 = t3*t4
    t6 = sin(pose4)
    t7 = t2 - t5*t6
    t8 = t0*t4
    t9 = t1*t3
    t10 = t8 + t6*t9
    t11 = cos(pose4)
    t12 = control0*t11
    t13 = -control1*t7 + control2*t10 + t12*t3
    t14 = t6*t8 + t9
    t15 = t2*t6 - t5
    t16 = control1*t14 + control2*t15 + t0*t12
    t17 = t11*t4
    t18 = t1*t11
    t19 = -control0*t6 + control1*t17 + control2*t18
    t20 = cos(control4)
    t21 = sin(control3)
    t22 = t20*t21
    t23 = sin(control4)
    t24 = t0*t11
    t25 = cos(control3)
    t26 = t20*t25
    t27 = t14*t22 - t15*t23 + t24*t26
    t28 = t11*t3
    t29 = t22*t7 - t26*t28 + t10*t23
    t30 = -t17*t22 + t18*t23 + t26*t6
    t31 = t29*t29
    t32 = t27*t27
    t33 = t31 + t32
    t34 = sqrt(t33)
    t35 = sin(control5)
    t36 = t25*t35
    t37 = cos(control5)
    t38 = t21*t37
    t39 = -t23*t36 + t38
    t40 = t21*t35
    t41 = t25*t37
    t42 = t23*t40 + t41
    t43 = t18*t20
    t44 = t17*t42 + t35*t43
    t45 = t39*t6 + t44
    t46 = t23*t38 - t36
    t47 = t23*t41 + t40
    t48 = t17*t46 + t37*t43 - t47*t6
    t49 = t1*t6
    t50 = 1/t33
    t51 = t10*t20
    t52 = t23*t7
    t53 = t21*t51 - t52
    t54 = t15*t20
    t55 = t14*t23
    t56 = t21*t54 + t55
    t57 = t30*t30
    t58 = t33 + t57
    t59 = 1/t58
    t60 = t21*t6
    t61 = t20*t4
    t62 = 1/t34
    t63 = -t29
    t64 = t63*t63
    t65 = t32 + t64
    t66 = sqrt(t65)
    t67 = t23*t4
    t68 = 1/t66
    t69 = t30*t68
    t70 = t45*t45
    t71 = t48*t48
    t72 = t70 + t71
    t73 = 1/t72
    t74 = t20*t49
    t75 = t46*t6
    t76 = t11*t47
    t77 = t11*t39
    t78 = -t25*t7 - t21*t28
    t79 = t14*t25 - t21*t24
    t80 = t23*t25
    t81 = -t21*t52 + t28*t80 + t51
    t82 = t24*t80 + t21*t55 + t54
    return (
        pose0 + t13,
        pose1 + t16,
        pose2 + t19,
        arctan2(t27, -t29),
        arctan2(t30, t34),
        arctan2(t45, t48),
        1,
        0,
        0,
        -t16,
        t19*t3,
        control1*t10 + control2*t7,
        0,
        1,
        0,
        t13,
        t0*t19,
        control1*t15 - control2*t14,
        0,
        0,
        1,
        0,
        -control1*t4*t6 - control2*t49 - t12,
        (control1*t1 - control2*t4)*t11,
        0,
        0,
        0,
        1,
        -(-t27*t3 - t0*t29)*t30*t50,
        (-t27*t53 - t29*t56)*t50,
        0,
        0,
        0,
        0,
        ((t11*t26 - t23*t49 + t60*t61)*t34 + (-t29*t3 + t0*t27)*t57*t62)*t59,
        -((t1*t22 + t67)*t11*t66 + (t27*t56 + t53*t63)*t69)*t59,
        0,
        0,
        0,
        0,
        -(-(t37*t74 + t4*t75 + t76)*t45 + (t35*t74 + t4*t42*t6 - t77)*t48)*t73,
        (-(-t37*t61 + t1*t46)*t45 + (-t35*t61 + t1*t42)*t48)*t11*t73,
        t28,
        -t7,
        t10,
        0,
        0,
        0,
        t24,
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
        -(t27*t78 - t63*t79)*t20*t50,
        -(-t27*t81 - t29*t82)*t50,
        0,
        0,
        0,
        0,
        -((t17*t25 + t60)*t66 + (t27*t79 + t63*t78)*t69)*t20*t59,
        -(-(t11*t21*t67 + t43 - t6*t80)*t66 - (t27*t82 + t63*t81)*t69)*t59,
        0,
        0,
        0,
        0,
        -(-(-t4*t77 + t42*t6)*t48 + (t39*t6 + t44)*(t4*t76 + t75))*t73,
        -(-t37*t45 + t35*t48)*t30*t73,
        1,
    )
