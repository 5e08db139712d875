"""Generated from slamlib/sensors/scaramuzza.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, sqrt

DIGESTS = {
    "project": "1de3cf82705c9453",
    "back_project": "fe0ebb0ae5e4eb4a",
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
    t0 = point0*point0
    t1 = point1*point1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = 1/t3
    t5 = arctan2(point2, t3)
    t6 = (forward0 + (forward1 + (forward2 + (forward3 + (forward4 + (forward5 + (forward6 + (forward7 + (forward8 + (forward9 + (forward10 + forward11*t5)*t5)*t5)*t5)*t5)*t5)*t5)*t5)*t5)*t5)*t5)*t4
    t7 = point1*t6
    t8 = point0*t6
    return (
        intrinsics0 + intrinsics4*t7 + t8,
        intrinsics1 + intrinsics2*t7 + intrinsics3*t8,
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
    t4 = arctan2(point2, t3)
    t5 = forward11*t4
    t6 = forward9 + (forward10 + t5)*t4
    t7 = forward8 + t4*t6
    t8 = forward7 + t4*t7
    t9 = forward6 + t4*t8
    t10 = forward5 + t4*t9
    t11 = forward4 + t10*t4
    t12 = forward3 + t11*t4
    t13 = forward2 + t12*t4
    t14 = forward1 + t13*t4
    t15 = forward0 + t14*t4
    t16 = 1/t3
    t17 = t15*t16
    t18 = intrinsics4*point1
    t19 = point0*t17
    t20 = intrinsics2*point1
    t21 = intrinsics3*point0
    t22 = 1/t2
    t23 = sqrt(t22)
    t24 = t22*t23
    t25 = t15*t24
    t26 = point0*t25
    t27 = point2*point2
    t28 = t27 + t2
    t29 = 1/t28
    t30 = t5 + t5
    t31 = (t14 + (t13 + (t12 + (t11 + (t10 + (t9 + ((((forward10 + t30)*t4 + t6)*t4 + t7)*t4 + t8)*t4)*t4)*t4)*t4)*t4)*t4)*t29
    t32 = point2*t22*t31
    t33 = point0*t32
    t34 = t0*t25
    t35 = t0*t32
    t36 = t1*t25
    t37 = t1*t32
    t38 = point0 + t18
    t39 = point1*t21
    t40 = t20 + t21
    t41 = point1*t17
    t42 = t16*t38
    t43 = t4*t4
    t44 = t43*t4
    t45 = t43*t43
    t46 = t44*t43
    t47 = t44*t44
    t48 = t45*t44
    t49 = t45*t45
    t50 = t46*t45
    t51 = t46*t46
    t52 = t47*t46
    t53 = t16*t40
    return (
        intrinsics0 + t17*t18 + t19,
        intrinsics1 + t17*t20 + t17*t21,
        t17 - t18*t26 - t18*t33 - t34 - t35,
        intrinsics4*t17 - intrinsics4*t36 - intrinsics4*t37 - point1*t26 - point1*t33,
        t31*t38,
        0,
        intrinsics3*t17 - intrinsics3*t34 - intrinsics3*t35 - t20*t26 - t20*t33,
        intrinsics2*t17 - intrinsics2*t36 - intrinsics2*t37 - t25*t39 - t32*t39,
        t31*t40,
        0,
        1,
        0,
        0,
        0,
        t41,
        0,
        1,
        t41,
        t19,
        0,
        t42,
        t4*t42,
        t42*t43,
        t42*t44,
        t42*t45,
        t42*t46,
        t42*t47,
        t42*t48,
        t42*t49,
        t42*t50,
        t42*t51,
        t42*t52,
        t53,
        t4*t53,
        t43*t53,
        t44*t53,
        t45*t53,
        t46*t53,
        t47*t53,
        t48*t53,
        t49*t53,
        t50*t53,
        t51*t53,
        t52*t53,
    )


def back_project(measurement, unmeasured, intrinsics, backward):
    """back_project: value."""
    measurement0, measurement1 = measurement
    unmeasured, = unmeasured
    intrinsics0, intrinsics1, intrinsics2, intrinsics3, intrinsics4 = intrinsics
    backward0, backward1, backward2, backward3, backward4, backward5, backward6, backward7, backward8, backward9, backward10, backward11 = backward
    t0 = intrinsics0 - measurement0
    t1 = intrinsics2*t0 - (intrinsics1 - measurement1)*intrinsics4
    t2 = intrinsics2 - intrinsics3*intrinsics4
    t3 = 1/t2
    t4 = t3*t3
    t5 = intrinsics1 - intrinsics3*t0 - measurement1
    t6 = t5*t5
    t7 = t1*t1
    t8 = t6 + t7
    t9 = sqrt(t8)
    t10 = abs(t2)
    t11 = 1/t10
    t12 = t11*t9
    t13 = backward0 + (backward1 + (backward2 + (backward3 + (backward4 + (backward5 + (backward6 + (backward7 + (backward8 + (backward9 + (backward10 + backward11*t12)*t12)*t12)*t12)*t12)*t12)*t12)*t12)*t12)*t12)*t12
    t14 = t13*t13
    t15 = t4*t6 + t4*t7 + t14
    t16 = 1/t15
    t17 = sqrt(t16)
    t18 = t17*t3
    return (
        -t1*t18,
        -t18*t5,
        t13*t17,
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
    t4 = abs(t3)
    t5 = 1/t4
    t6 = intrinsics1 - intrinsics3*t0 - measurement1
    t7 = t6*t6
    t8 = t2*t2
    t9 = t7 + t8
    t10 = sqrt(t9)
    t11 = t10*t5
    t12 = backward10 + backward11*t11
    t13 = backward9 + t11*t12
    t14 = backward8 + t11*t13
    t15 = backward7 + t11*t14
    t16 = backward6 + t11*t15
    t17 = backward5 + t11*t16
    t18 = backward4 + t11*t17
    t19 = backward3 + t11*t18
    t20 = backward2 + t11*t19
    t21 = backward1 + t11*t20
    t22 = backward0 + t11*t21
    t23 = t22*t22
    t24 = 1/t3
    t25 = t24*t24
    t26 = t23 + t25*t7 + t25*t8
    t27 = 1/t26
    t28 = sqrt(t27)
    t29 = t24*t28
    t30 = -t0
    t31 = intrinsics3*t30 + t1
    t32 = t31*t31
    t33 = -t2
    t34 = t33*t33
    t35 = t32 + t34
    t36 = sqrt(t35)
    t37 = t36*t5
    t38 = backward10 + backward11*t37
    t39 = backward9 + t37*t38
    t40 = backward8 + t37*t39
    t41 = backward7 + t37*t40
    t42 = backward6 + t37*t41
    t43 = backward5 + t37*t42
    t44 = backward4 + t37*t43
    t45 = backward3 + t37*t44
    t46 = backward2 + t37*t45
    t47 = backward1 + t37*t46
    t48 = backward0 + t37*t47
    t49 = intrinsics2*t33 + intrinsics3*t31
    t50 = 1/t36
    t51 = t4*t50
    t52 = (((((((((backward11 + t38*t51)*t37 + t39*t51)*t37 + t40*t51)*t37 + t41*t51)*t37 + t42*t51)*t37 + t43*t51)*t37 + t44*t51)*t37 + t45*t51)*t37 + t46*t51)*t37 + t47*t51
    t53 = t49*t52
    t54 = t48*t53 + t49
    t55 = t25*t27
    t56 = t2*t55
    t57 = (intrinsics2 + t54*t56)*t29
    t58 = intrinsics2*t30 + intrinsics4*t1
    t59 = intrinsics4*t58 + t31
    t60 = -t31
    t61 = t60*t60
    t62 = t58*t58
    t63 = t61 + t62
    t64 = sqrt(t63)
    t65 = t5*t64
    t66 = backward10 + backward11*t65
    t67 = backward9 + t65*t66
    t68 = backward8 + t65*t67
    t69 = backward7 + t65*t68
    t70 = backward6 + t65*t69
    t71 = backward5 + t65*t70
    t72 = backward4 + t65*t71
    t73 = backward3 + t65*t72
    t74 = backward2 + t65*t73
    t75 = backward1 + t65*t74
    t76 = backward0 + t65*t75
    t77 = 1/t64
    t78 = t4*t77
    t79 = (((((((((backward11 + t66*t78)*t65 + t67*t78)*t65 + t68*t78)*t65 + t69*t78)*t65 + t70*t78)*t65 + t71*t78)*t65 + t72*t78)*t65 + t73*t78)*t65 + t74*t78)*t65 + t75*t78
    t80 = t59*t76*t79 + t59
    t81 = -t80
    t82 = t48*t48
    t83 = t25*t32 + t25*t34 + t82
    t84 = 1/t83
    t85 = t25*t84
    t86 = intrinsics2*t58 - intrinsics3*t60
    t87 = t76*t79
    t88 = t86*t87 + t86
    t89 = t55*t6
    t90 = (-t80*t89 + 1)*t29
    t91 = t25*t28
    t92 = t48*t84
    t93 = (-t53 + t88*t92)*t91
    t94 = (t52*t59 + t81*t92)*t91
    t95 = t24*t61
    t96 = t24*t62
    t97 = -t30*t58 + t95 + t96
    t98 = t30*t58 - t87*t97 - t95 - t96
    t99 = t84*t98
    t100 = intrinsics4*t24
    t101 = -t0*t6 + t100*t7 + t100*t8
    t102 = 1/t10
    t103 = t102*t4
    t104 = ((((((((((backward11 + t103*t12)*t11 + t103*t13)*t11 + t103*t14)*t11 + t103*t15)*t11 + t103*t16)*t11 + t103*t17)*t11 + t103*t18)*t11 + t103*t19)*t11 + t103*t20)*t11 + t103*t21)*t22
    t105 = t101*t104 + t101
    t106 = t24*t27
    t107 = intrinsics3*t24
    t108 = -t1*t2 + t107*t7 + t107*t8
    t109 = t104*t108 + t108
    t110 = t6*t91
    t111 = -t0*t31 + t100*t32 + t100*t34
    t112 = t111*t52
    t113 = t1*t33 + t107*t32 + t107*t34
    t114 = t113*t52
    t115 = t27*t28
    t116 = t115*t22
    t117 = t116*t24
    t118 = t117*t2
    t119 = t116*t2
    t120 = t25*t24
    t121 = t120*t9
    t122 = t120*t25
    t123 = t9*t10
    t124 = t123*t4
    t125 = t122*t124
    t126 = t9*t9
    t127 = t122*t126
    t128 = t25*t25
    t129 = t128*t120
    t130 = t126*t10
    t131 = t130*t4
    t132 = t129*t131
    t133 = t126*t9
    t134 = t129*t133
    t135 = t122*t128
    t136 = t133*t10
    t137 = t136*t4
    t138 = t135*t137
    t139 = t126*t126
    t140 = t135*t139
    t141 = t120*t120
    t142 = t141*t122
    t143 = t139*t10
    t144 = t143*t4
    t145 = t142*t144
    t146 = t133*t126
    t147 = t142*t146
    t148 = t146*t10
    t149 = t148*t4
    t150 = t129*t141
    t151 = t149*t150
    t152 = t117*t6
    t153 = t116*t6
    t154 = (t82*t84 - 1)*t28
    t155 = t128*t154
    t156 = t141*t154
    t157 = t128*t128
    t158 = t154*t157
    t159 = t122*t122
    t160 = t154*t159
    t161 = t141*t141
    return (
        -t2*t29,
        -t29*t6,
        t22*t28,
        unmeasured,
        t57,
        -(intrinsics4 + t33*t81*t85)*t29,
        -(intrinsics3 - t31*t85*t88)*t29,
        t90,
        -t93,
        -t94,
        0,
        0,
        0,
        0,
        0,
        1,
        -t57,
        (intrinsics4 + t56*t80)*t29,
        -(t0 + t24*t33 + t25*t33*t99)*t29,
        -(intrinsics4 - t105*t106)*t2*t91,
        (t1 - t107*t2 + t109*t56)*t29,
        (intrinsics3 - t54*t89)*t29,
        -t90,
        (t24*t99 + 1)*t110,
        (t0 - t100*t6 + t105*t89)*t29,
        -(intrinsics3 - t106*t109)*t110,
        t93,
        t94,
        -(t52*t97 + t92*t98)*t91,
        -(-t112 + (t111 + t112*t48)*t92)*t91,
        -(-t114 + (t113 + t114*t48)*t92)*t91,
        0,
        0,
        0,
        0,
        0,
        t118,
        t11*t118,
        t119*t121,
        t119*t125,
        t119*t127,
        t119*t132,
        t119*t134,
        t119*t138,
        t119*t140,
        t119*t145,
        t119*t147,
        t119*t151,
        t152,
        t11*t152,
        t121*t153,
        t125*t153,
        t127*t153,
        t132*t153,
        t134*t153,
        t138*t153,
        t140*t153,
        t145*t153,
        t147*t153,
        t151*t153,
        -t154,
        -t11*t154,
        -t154*t25*t9,
        -t124*t155,
        -t126*t155,
        -t131*t156,
        -t133*t156,
        -t137*t158,
        -t139*t158,
        -t144*t160,
        -t146*t160,
        -t149*t154*t161,
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
