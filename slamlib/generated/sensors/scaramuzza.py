"""Generated from slamlib/sensors/scaramuzza.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, sqrt

DIGESTS = {
    "project": "863f0ea29b54ec00",
    "back_project": "c115cf5343e72e45",
}
SHAPES = {
    "project": (2,),
    "back_project": (4,),
}


def project(point, intrinsics, forward):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    forward0, forward1, forward2, forward3, forward4, forward5, forward6, forward7, forward8, forward9, forward10, forward11 = forward
    t0 = sqrt(point0*point0 + point1*point1)
    t1 = arctan2(point2, t0)
    t2 = (forward0 + t1*(forward1 + t1*(forward2 + t1*(forward3 + t1*(forward4 + t1*(forward5 + t1*(forward6 + t1*(forward7 + t1*(forward8 + t1*(forward9 + t1*(forward10 + forward11*t1)))))))))))/t0
    t3 = point0*t2
    t4 = point1*t2
    return (
        intrinsics0 + intrinsics4*t4 + t3,
        intrinsics1 + intrinsics2*t4 + intrinsics3*t3,
    )


def project_jac(point, intrinsics, forward):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    forward0, forward1, forward2, forward3, forward4, forward5, forward6, forward7, forward8, forward9, forward10, forward11 = forward
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = 1/(t3)
    t5 = arctan2(point2, t3)
    t6 = forward11*t5
    t7 = forward9 + t5*(forward10 + t6)
    t8 = forward8 + t5*t7
    t9 = forward7 + t5*t8
    t10 = forward6 + t5*t9
    t11 = forward5 + t10*t5
    t12 = forward4 + t11*t5
    t13 = forward3 + t12*t5
    t14 = forward2 + t13*t5
    t15 = forward1 + t14*t5
    t16 = forward0 + t15*t5
    t17 = t16*t4
    t18 = point0*t17
    t19 = intrinsics4*point1
    t20 = intrinsics2*point1
    t21 = intrinsics3*point0
    t22 = t16/(t2*sqrt(t2))
    t23 = t0*t22
    t24 = point0*t22
    t25 = (t15 + t5*(t14 + t5*(t13 + t5*(t12 + t5*(t11 + t5*(t10 + t5*(t5*(t5*(t5*(forward10 + 2*t6) + t7) + t8) + t9)))))))/(point2*point2 + t2)
    t26 = point2*t25/t2
    t27 = t0*t26
    t28 = point0*t26
    t29 = t1*t22
    t30 = t1*t26
    t31 = point0 + t19
    t32 = point1*t21
    t33 = t20 + t21
    t34 = point1*t17
    t35 = t31*t4
    t36 = t5*t5
    t37 = t5*t5*t5
    t38 = t5*t5*t5*t5
    t39 = t5*t5*t5*t5*t5
    t40 = t5*t5*t5*t5*t5*t5
    t41 = t5*t5*t5*t5*t5*t5*t5
    t42 = t5*t5*t5*t5*t5*t5*t5*t5
    t43 = t5*t5*t5*t5*t5*t5*t5*t5*t5
    t44 = t5*t5*t5*t5*t5*t5*t5*t5*t5*t5
    t45 = t5*t5*t5*t5*t5*t5*t5*t5*t5*t5*t5
    t46 = t33*t4
    return (
        intrinsics0 + t17*t19 + t18,
        intrinsics1 + t17*t20 + t17*t21,
        t16*t4 - t19*t24 - t19*t28 - t23 - t27,
        intrinsics4*t16*t4 - intrinsics4*t29 - intrinsics4*t30 - point1*t24 - point1*t28,
        t25*t31,
        0,
        intrinsics3*t16*t4 - intrinsics3*t23 - intrinsics3*t27 - t20*t24 - t20*t28,
        intrinsics2*t16*t4 - intrinsics2*t29 - intrinsics2*t30 - t22*t32 - t26*t32,
        t25*t33,
        0,
        1,
        0,
        0,
        0,
        t34,
        0,
        1,
        t34,
        t18,
        0,
        t35,
        t35*t5,
        t35*t36,
        t35*t37,
        t35*t38,
        t35*t39,
        t35*t40,
        t35*t41,
        t35*t42,
        t35*t43,
        t35*t44,
        t35*t45,
        t46,
        t46*t5,
        t36*t46,
        t37*t46,
        t38*t46,
        t39*t46,
        t40*t46,
        t41*t46,
        t42*t46,
        t43*t46,
        t44*t46,
        t45*t46,
    )


def back_project(measurement, unmeasured, intrinsics, backward):
    """back_project: value."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    backward0, backward1, backward2, backward3, backward4, backward5, backward6, backward7, backward8, backward9, backward10, backward11 = backward
    t0 = intrinsics0 - measurement0
    t1 = intrinsics2*t0 - intrinsics4*(intrinsics1 - measurement1)
    t2 = intrinsics2 - intrinsics3*intrinsics4
    t3 = 1/(t2*t2)
    t4 = intrinsics1 - intrinsics3*t0 - measurement1
    t5 = t4*t4
    t6 = t1*t1
    t7 = sqrt(t5 + t6)/abs(t2)
    t8 = backward0 + t7*(backward1 + t7*(backward2 + t7*(backward3 + t7*(backward4 + t7*(backward5 + t7*(backward6 + t7*(backward7 + t7*(backward8 + t7*(backward9 + t7*(backward10 + backward11*t7))))))))))
    t9 = 1/(sqrt(t3*t5 + t3*t6 + t8*t8))
    t10 = t9/t2
    return (
        -t1*t10,
        -t10*t4,
        t8*t9,
        unmeasured,
    )


def back_project_jac(measurement, unmeasured, intrinsics, backward):
    """back_project: value and Jacobians."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    backward0, backward1, backward2, backward3, backward4, backward5, backward6, backward7, backward8, backward9, backward10, backward11 = backward
    t0 = intrinsics0 - measurement0
    t1 = intrinsics1 - measurement1
    t2 = intrinsics2*t0 - intrinsics4*t1
    t3 = intrinsics2 - intrinsics3*intrinsics4
    t4 = 1/(t3*t3)
    t5 = intrinsics3*t0
    t6 = intrinsics1 - measurement1 - t5
    t7 = t6*t6
    t8 = t2*t2
    t9 = t7 + t8
    t10 = abs(t3)
    t11 = 1/(t10)
    t12 = t11*sqrt(t9)
    t13 = backward0 + t12*(backward1 + t12*(backward2 + t12*(backward3 + t12*(backward4 + t12*(backward5 + t12*(backward6 + t12*(backward7 + t12*(backward8 + t12*(backward9 + t12*(backward10 + backward11*t12))))))))))
    t14 = t13*t13 + t4*t7 + t4*t8
    t15 = 1/(sqrt(t14))
    t16 = 1/(t3)
    t17 = t15*t16
    t18 = -t0
    t19 = intrinsics3*t18 + t1
    t20 = t19*t19
    t21 = -t2
    t22 = t21*t21
    t23 = t20 + t22
    t24 = sqrt(t23)
    t25 = t11*t24
    t26 = backward10 + backward11*t25
    t27 = backward9 + t25*t26
    t28 = backward8 + t25*t27
    t29 = backward7 + t25*t28
    t30 = backward6 + t25*t29
    t31 = backward5 + t25*t30
    t32 = backward4 + t25*t31
    t33 = backward3 + t25*t32
    t34 = backward2 + t25*t33
    t35 = backward1 + t25*t34
    t36 = backward0 + t25*t35
    t37 = intrinsics2*t21 + intrinsics3*t19
    t38 = t10/t24
    t39 = t25*(t25*(t25*(t25*(t25*(t25*(t25*(t25*(t25*(backward11 + t26*t38) + t27*t38) + t28*t38) + t29*t38) + t30*t38) + t31*t38) + t32*t38) + t33*t38) + t34*t38) + t35*t38
    t40 = 1/(t14)
    t41 = t4*t40
    t42 = t2*t41
    t43 = intrinsics2*t18 + intrinsics4*t1
    t44 = intrinsics4*t43 + t19
    t45 = -t19
    t46 = t45*t45
    t47 = t43*t43
    t48 = sqrt(t46 + t47)
    t49 = t11*t48
    t50 = backward10 + backward11*t49
    t51 = backward9 + t49*t50
    t52 = backward8 + t49*t51
    t53 = backward7 + t49*t52
    t54 = backward6 + t49*t53
    t55 = backward5 + t49*t54
    t56 = backward4 + t49*t55
    t57 = backward3 + t49*t56
    t58 = backward2 + t49*t57
    t59 = backward1 + t49*t58
    t60 = backward0 + t49*t59
    t61 = t10/t48
    t62 = t49*(t49*(t49*(t49*(t49*(t49*(t49*(t49*(t49*(backward11 + t50*t61) + t51*t61) + t52*t61) + t53*t61) + t54*t61) + t55*t61) + t56*t61) + t57*t61) + t58*t61) + t59*t61
    t63 = -t44*t60*t62 - t44
    t64 = t36*t36
    t65 = t20*t4 + t22*t4 + t64
    t66 = 1/(t65)
    t67 = t21*t4*t66
    t68 = 1/(sqrt(t65))
    t69 = t16*t68
    t70 = intrinsics3*t45
    t71 = intrinsics2*t43
    t72 = -t70 + t71
    t73 = t60*t62
    t74 = t72*t73 + t72
    t75 = intrinsics4*t21
    t76 = t39*t44
    t77 = t41*t6
    t78 = t36*t66
    t79 = t4*t68
    t80 = t70 - t71 - t72*t73
    t81 = t1 - t5 + t75
    t82 = t36*t39*t81 + t81
    t83 = t16*t46
    t84 = t16*t47
    t85 = -t18*t43 + t83 + t84
    t86 = t18*t43 - t73*t85 - t83 - t84
    t87 = t16*t20
    t88 = t16*t22
    t89 = intrinsics4*t87 + intrinsics4*t88 - t0*t19
    t90 = t36*t39*t89 + t89
    t91 = t15*t4
    t92 = t16*t2
    t93 = intrinsics3*t87 + intrinsics3*t88 + t1*t21
    t94 = t39*t72
    t95 = t39*t85
    t96 = t16*t6
    t97 = intrinsics3*t83 + intrinsics3*t84 + t1*t43
    t98 = t73*t97 + t97
    t99 = intrinsics4*t83 + intrinsics4*t84 + t0*t45
    t100 = 1/(t14*sqrt(t14))
    t101 = t100*t36
    t102 = t100*t13
    t103 = t102*t12
    t104 = t102*t2
    t105 = t9/(t3*t3*t3)
    t106 = t10*t104
    t107 = 1/(t3*t3*t3*t3*t3)
    t108 = t107*t9*sqrt(t9)
    t109 = t107*t9*t9
    t110 = 1/(t3*t3*t3*t3*t3*t3*t3)
    t111 = t110*t9*t9*sqrt(t9)
    t112 = t110*t9*t9*t9
    t113 = 1/(t3*t3*t3*t3*t3*t3*t3*t3*t3)
    t114 = t113*t9*t9*t9*sqrt(t9)
    t115 = t113*t9*t9*t9*t9
    t116 = 1/(t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3)
    t117 = t116*t9*t9*t9*t9*sqrt(t9)
    t118 = t116*t9*t9*t9*t9*t9
    t119 = t9*t9*t9*t9*t9*sqrt(t9)/(t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3)
    t120 = t102*t6
    t121 = t10*t120
    t122 = -t64*t66 + 1
    t123 = t122*t68
    t124 = t123/(t3*t3*t3*t3)
    t125 = t123/(t3*t3*t3*t3*t3*t3)
    t126 = t123/(t3*t3*t3*t3*t3*t3*t3*t3)
    t127 = t123/(t3*t3*t3*t3*t3*t3*t3*t3*t3*t3)
    return (
        -t17*t2,
        -t17*t6,
        t13*t15,
        unmeasured,
        t17*(intrinsics2 + t42*(t36*t37*t39 + t37)),
        -t69*(intrinsics4 + t63*t67),
        t69*(-intrinsics3 + t19*t4*t66*t74),
        t17*(-t77*(t19 + t36*t76 + t75) + 1),
        t79*(t37*t39 - t74*t78),
        -t79*(t63*t78 + t76),
        0,
        0,
        0,
        0,
        0,
        1,
        -t69*(intrinsics2 + t67*t80),
        t17*(intrinsics4 + t42*t82),
        -t69*(t0 + t16*t21 + t67*t86),
        t2*t91*(-intrinsics4 + t16*t40*t90),
        t17*(-intrinsics3*t92 + t1 + t42*(t36*t39*t93 + t93)),
        t17*(intrinsics3 - t77*(t36*t94 + t37)),
        t17*(t4*t40*t6*t82 - 1),
        t6*t91*(-t16*t40*(t0*t21 + t36*t95 + t87 + t88) + 1),
        t17*(-intrinsics4*t96 + t0 + t77*t90),
        t19*t79*(-intrinsics3 + t16*t66*t98),
        -t79*(t78*t80 + t94),
        t79*(t39*t81 - t78*(t44*t73 + t44)),
        -t79*(t78*t86 + t95),
        t79*(t39*t89 - t78*(t73*t99 + t99)),
        t79*(t39*t93 - t78*t98),
        0,
        0,
        0,
        0,
        0,
        t101*t92,
        t103*t92,
        t104*t105,
        t106*t108,
        t104*t109,
        t106*t111,
        t104*t112,
        t106*t114,
        t104*t115,
        t106*t117,
        t104*t118,
        t106*t119,
        t101*t96,
        t103*t96,
        t105*t120,
        t108*t121,
        t109*t120,
        t111*t121,
        t112*t120,
        t114*t121,
        t115*t120,
        t117*t121,
        t118*t120,
        t119*t121,
        t68*(-t60*t78 + 1),
        t123*t25,
        t122*t23*t79,
        t10*t124*t23*sqrt(t23),
        t124*t23*t23,
        t10*t125*t23*t23*sqrt(t23),
        t125*t23*t23*t23,
        t10*t126*t23*t23*t23*sqrt(t23),
        t126*t23*t23*t23*t23,
        t10*t127*t23*t23*t23*t23*sqrt(t23),
        t127*t23*t23*t23*t23*t23,
        (t10*t123*t23*t23*t23*t23*t23*sqrt(t23))/(t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3*t3),
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    )
