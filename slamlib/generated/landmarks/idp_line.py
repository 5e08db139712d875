"""Generated from slamlib/landmarks/idp_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "to_frame": "02e1f358b8e57b91",
    "from_frame": "ea7f7457e565b867",
    "point_at": "5d62be3144732a2d",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (9,),
    "point_at": (4,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = cos(landmark3)
    t4 = landmark0 - pose0
    t5 = landmark5*t4 + t3*cos(landmark4)
    t6 = 2*t5
    t7 = landmark1 - pose1
    t8 = landmark5*t7 + t3*sin(landmark4)
    t9 = pose3*pose4
    t10 = pose5*pose6
    t11 = -2*t10 + 2*t9
    t12 = landmark2 - pose2
    t13 = landmark5*t12 + sin(landmark3)
    t14 = pose6*pose6
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose4*pose4
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = -t11*t8 + t13*t20 + t2*t6
    t22 = landmark8*t12 + sin(landmark6)
    t23 = 2*t10 + 2*t9
    t24 = pose3*pose6
    t25 = pose4*pose5
    t26 = t24 - t25
    t27 = cos(landmark6)
    t28 = landmark8*t4 + t27*cos(landmark7)
    t29 = 2*t28
    t30 = landmark8*t7 + t27*sin(landmark7)
    t31 = -t14
    t32 = t15 + t19 + t31
    t33 = t22*t23 - t26*t29 + t30*t32
    t34 = t13*t23 - t26*t6 + t32*t8
    t35 = -t11*t30 + t2*t29 + t20*t22
    t36 = 2*t0 - 2*t1
    t37 = 2*t24 + 2*t25
    t38 = t16 + t17 + t18 + t31
    t39 = -t22*t36 + t28*t38 + t30*t37
    t40 = -t13*t36 + t37*t8 + t38*t5
    return (
        -t21*t33 + t34*t35,
        t21*t39 - t35*t40,
        t33*t40 - t34*t39,
        landmark5*t39 - landmark8*t40,
        landmark5*t33 - landmark8*t34,
        landmark5*t35 - landmark8*t21,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = sin(landmark4)
    t1 = cos(landmark3)
    t2 = landmark1 - pose1
    t3 = landmark5*t2 + t0*t1
    t4 = pose3*pose4
    t5 = pose5*pose6
    t6 = t4 - t5
    t7 = 2*t6
    t8 = t3*t7
    t9 = sin(landmark3)
    t10 = landmark2 - pose2
    t11 = landmark5*t10 + t9
    t12 = pose6*pose6
    t13 = pose5*pose5
    t14 = -t13
    t15 = pose3*pose3
    t16 = pose4*pose4
    t17 = t15 - t16
    t18 = t12 + t14 + t17
    t19 = t11*t18
    t20 = pose3*pose5
    t21 = pose4*pose6
    t22 = t20 + t21
    t23 = cos(landmark4)
    t24 = landmark0 - pose0
    t25 = landmark5*t24 + t1*t23
    t26 = 2*t25
    t27 = t22*t26
    t28 = t19 + t27
    t29 = t28 - t8
    t30 = pose3*pose6
    t31 = pose4*pose5
    t32 = t30 - t31
    t33 = cos(landmark6)
    t34 = cos(landmark7)
    t35 = landmark8*t24 + t33*t34
    t36 = 2*t35
    t37 = t32*t36
    t38 = sin(landmark7)
    t39 = landmark8*t2 + t33*t38
    t40 = -t12
    t41 = t13 + t17 + t40
    t42 = sin(landmark6)
    t43 = landmark8*t10 + t42
    t44 = t4 + t5
    t45 = 2*t44
    t46 = t39*t41 + t43*t45
    t47 = -t37 + t46
    t48 = t26*t32
    t49 = t3*t41
    t50 = t11*t45
    t51 = t49 + t50
    t52 = -t48 + t51
    t53 = t39*t7
    t54 = t18*t43 + t22*t36
    t55 = -t53 + t54
    t56 = t20 - t21
    t57 = 2*t56
    t58 = t43*t57
    t59 = t14 + t15 + t16 + t40
    t60 = t30 + t31
    t61 = 2*t60
    t62 = t35*t59 + t39*t61
    t63 = -t58 + t62
    t64 = t11*t57
    t65 = t25*t59
    t66 = t3*t61
    t67 = t65 + t66
    t68 = -t64 + t67
    t69 = landmark5*t63
    t70 = landmark8*t68
    t71 = landmark5*t47
    t72 = landmark8*t52
    t73 = landmark5*t55
    t74 = landmark8*t29
    t75 = t22*t71 - t22*t72 + t32*t73 - t32*t74
    t76 = -landmark8*t29*t41 - 2*landmark8*t52*t6 + t41*t73 + t7*t71
    t77 = -landmark5*t18*t47 - 2*landmark8*t29*t44 + t18*t72 + t45*t73
    t78 = pose4*t25 + pose5*t3 + pose6*t11
    t79 = t47*t78
    t80 = pose4*t35 + pose5*t39 + pose6*t43
    t81 = pose3*t25 - pose5*t11 + pose6*t3
    t82 = pose3*t35 - pose5*t43 + pose6*t39
    t83 = -t29*t82 + t55*t81
    t84 = -t52*t80 + t79 + t83
    t85 = -t84
    t86 = -2*t6
    t87 = t28 + t3*t86
    t88 = -t32
    t89 = t36*t88 + t46
    t90 = t39*t86 + t54
    t91 = t26*t88 + t51
    t92 = -t78*t90 + t80*t87 + t81*t89 - t82*t91
    t93 = pose3*t43 - pose4*t39 + pose5*t35
    t94 = pose3*t11 - pose4*t3 + pose5*t25
    t95 = t47*t94
    t96 = pose3*t3 + pose4*t11 - pose6*t25
    t97 = pose3*t39 + pose4*t43 - pose6*t35
    t98 = -t29*t97 + t55*t96
    t99 = t52*t93 - t95 + t98
    t100 = t87*t93 - t89*t96 - t90*t94 + t91*t97
    t101 = t29*t80
    t102 = t55*t78
    t103 = t47*t81 - t52*t82
    t104 = -t29*t93 + t55*t94
    t105 = t47*t96 - t52*t97
    t106 = 2*t22
    t107 = -landmark5*t55*t59 - 2*landmark8*t22*t68 + t106*t69 + t59*t74
    t108 = t6*t69 - t6*t70 + t60*t73 - t60*t74
    t109 = -landmark8*t18*t68 - 2*landmark8*t29*t56 + t18*t69 + t57*t73
    t110 = t63*t78
    t111 = -t110 + t68*t80 + t98
    t112 = t63*t96
    t113 = t68*t97
    t114 = -t101 + t102 + t112 - t113
    t115 = t68*t93
    t116 = t63*t94
    t117 = t115 - t116 + t83
    t118 = t63*t81 - t68*t82
    t119 = t104 + t118
    t120 = -2*t56
    t121 = t11*t120 + t67
    t122 = t120*t43 + t62
    t123 = t121*t93
    t124 = t122*t94
    t125 = 2*t32
    t126 = -2*landmark8*t32*t68 - landmark8*t52*t59 + t125*t69 + t59*t71
    t127 = -landmark5*t41*t63 - 2*landmark8*t52*t60 + t41*t70 + t61*t71
    t128 = t44*t69 - t44*t70 + t56*t71 - t56*t72
    t129 = -t123 + t124 - t78*t89 + t80*t91
    t130 = t110 - t52*t93 - t68*t80 + t95
    t131 = -t130
    t132 = t103 - t112 + t113
    t133 = t121*t82 - t122*t81 - t89*t96 + t91*t97
    t134 = landmark5*t80 - landmark8*t78
    t135 = landmark5*t82 - landmark8*t81
    t136 = landmark5*t97 - landmark8*t96
    t137 = landmark5*t93 - landmark8*t94
    t138 = pose3*t134 - pose4*t135 - pose5*t136 - pose6*t137
    t139 = pose3*t137 - pose4*t136 + pose5*t135 + pose6*t134
    t140 = pose3*t136 + pose4*t137 + pose5*t134 - pose6*t135
    t141 = pose3*t135 + pose4*t134 - pose5*t137 + pose6*t136
    t142 = t1*t45
    t143 = 2*t88
    t144 = t23*t9
    t145 = t0*t9
    t146 = -t142 + t143*t144 + t145*t41
    t147 = t1*t18
    t148 = t106*t144 + t145*t86 - t147
    t149 = 2*t0*t22 + 2*t23*t6
    t150 = t23*t41
    t151 = t0*t143 - t150
    t152 = 2*t24
    t153 = t10*t18 + t152*t22 - t2*t7
    t154 = t10*t45 - t152*t32 + t2*t41
    t155 = t33*t45
    t156 = t34*t42
    t157 = t38*t42
    t158 = t143*t156 - t155 + t157*t41
    t159 = t18*t33
    t160 = t106*t156 + t157*t86 - t159
    t161 = 2*t22*t38 + 2*t34*t6
    t162 = t34*t41
    t163 = t125*t38 + t162
    t164 = t144*t59 + t145*t61
    t165 = -t1*t120 + t164
    t166 = -t0*t59 + t23*t61
    t167 = -t10*t57 + t2*t61 + t24*t59
    t168 = t156*t59 + t157*t61
    t169 = -t120*t33 + t168
    t170 = t34*t61 - t38*t59
    t171 = landmark8*t1
    t172 = landmark5*t33
    return (
        -t29*t47 + t52*t55,
        t29*t63 - t55*t68,
        t47*t68 - t52*t63,
        t69 - t70,
        t71 - t72,
        t73 - t74,
        2*t75,
        -t76,
        -t77,
        -pose3*t100 - pose4*t99 - pose5*t85 - pose6*t92,
        -pose3*t92 + pose4*t85 - pose5*t99 + pose6*t100,
        -pose3*t84 + pose4*(t101 - t102 + t103) - pose5*(-t104 - t105) - pose6*t99,
        -t107,
        2*t108,
        -t109,
        -pose3*t114 + pose4*t117 + pose5*t111 + pose6*t119,
        pose3*t119 - pose4*t111 + pose5*t117 + pose6*t114,
        -pose3*(t121*t80 - t122*t78 - t87*t97 + t90*t96) - pose4*t119 - pose5*t114 + pose6*(t123 - t124 + t81*t90 - t82*t87),
        -t126,
        -t127,
        2*t128,
        -pose3*t129 - pose4*t132 + pose5*t133 + pose6*t131,
        -pose3*t130 - pose4*(-t105 - t118) - pose5*t132 + pose6*(-t115 + t116 + t52*t80 - t79),
        -pose3*t133 - pose4*t131 - pose5*t129 - pose6*t132,
        0,
        0,
        0,
        t138,
        -t139,
        t140,
        0,
        0,
        0,
        t139,
        t138,
        -t141,
        0,
        0,
        0,
        -t140,
        t141,
        t138,
        -2*t75,
        t76,
        t77,
        -t146*t55 + t148*t47,
        t1*(t149*t47 - t151*t55),
        -t153*t47 + t154*t55,
        t158*t29 - t160*t52,
        -t33*(t161*t52 + t163*t29),
        t153*t52 - t154*t29,
        t107,
        -2*t108,
        t109,
        -t148*t63 + t165*t55,
        -t1*(t149*t63 + t166*t55),
        t153*t63 - t167*t55,
        t160*t68 - t169*t29,
        t33*(t161*t68 + t170*t29),
        -t153*t68 + t167*t29,
        t126,
        t127,
        -2*t128,
        t146*t63 - t165*t47,
        t1*(t151*t63 + t166*t47),
        -t154*t63 + t167*t47,
        -t158*t68 + t169*t52,
        -t33*(t170*t52 + t68*(t143*t38 - t162)),
        t154*t68 - t167*t52,
        0,
        0,
        0,
        landmark8*(t1*t57 + t164),
        -t166*t171,
        -landmark8*t167 + t35*t59 + 2*t39*t60 - t58,
        -landmark5*(t168 + t33*t57),
        t170*t172,
        landmark5*t167 + t64 - t65 - t66,
        0,
        0,
        0,
        landmark8*(t0*t41*t9 - t125*t144 - t142),
        -t171*(t0*t125 + t150),
        -landmark8*t154 - t37 + t39*t41 + 2*t43*t44,
        -landmark5*(-t125*t156 - t155 + t38*t41*t42),
        t163*t172,
        landmark5*t154 + t48 - t49 - t50,
        0,
        0,
        0,
        landmark8*(-t145*t7 - t147 + 2*t22*t23*t9),
        t149*t171,
        -landmark8*t153 + t18*t43 + 2*t22*t35 - t53,
        -landmark5*(-t157*t7 - t159 + 2*t22*t34*t42),
        -t161*t172,
        landmark5*t153 - t19 - t27 + t8,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = cos(landmark3)
    t4 = cos(landmark4)
    t5 = landmark0 - pose0
    t6 = landmark5*t5 + t3*t4
    t7 = 2*t6
    t8 = t2*t7
    t9 = sin(landmark4)
    t10 = landmark1 - pose1
    t11 = landmark5*t10 + t3*t9
    t12 = pose3*pose4
    t13 = pose5*pose6
    t14 = t12 - t13
    t15 = 2*t14
    t16 = t11*t15
    t17 = sin(landmark3)
    t18 = landmark2 - pose2
    t19 = landmark5*t18 + t17
    t20 = pose6*pose6
    t21 = pose5*pose5
    t22 = -t21
    t23 = pose3*pose3
    t24 = pose4*pose4
    t25 = t23 - t24
    t26 = t20 + t22 + t25
    t27 = t19*t26
    t28 = -t16 + t27 + t8
    t29 = sin(landmark6)
    t30 = landmark8*t18 + t29
    t31 = t12 + t13
    t32 = 2*t31
    t33 = pose3*pose6
    t34 = pose4*pose5
    t35 = t33 - t34
    t36 = cos(landmark6)
    t37 = cos(landmark7)
    t38 = landmark8*t5 + t36*t37
    t39 = 2*t38
    t40 = t35*t39
    t41 = sin(landmark7)
    t42 = landmark8*t10 + t36*t41
    t43 = -t20
    t44 = t21 + t25 + t43
    t45 = t30*t32 - t40 + t42*t44
    t46 = t19*t32
    t47 = t35*t7
    t48 = t11*t44
    t49 = t46 - t47 + t48
    t50 = t15*t42
    t51 = t2*t39 + t26*t30 - t50
    t52 = t0 - t1
    t53 = 2*t52
    t54 = t30*t53
    t55 = t33 + t34
    t56 = 2*t55
    t57 = t22 + t23 + t24 + t43
    t58 = t38*t57 + t42*t56 - t54
    t59 = t19*t53
    t60 = t11*t56
    t61 = t57*t6
    t62 = -t59 + t60 + t61
    t63 = landmark5*t58
    t64 = landmark8*t62
    t65 = landmark5*t45
    t66 = landmark8*t49
    t67 = landmark5*t51
    t68 = landmark8*t28
    t69 = t2*t65 - t2*t66 + t35*t67 - t35*t68
    t70 = -2*landmark8*t14*t49 - landmark8*t28*t44 + t15*t65 + t44*t67
    t71 = -landmark5*t26*t45 - 2*landmark8*t28*t31 + t26*t66 + t32*t67
    t72 = pose3*t30 - pose4*t42 + pose5*t38
    t73 = pose3*t19 - pose4*t11 + pose5*t6
    t74 = t45*t73
    t75 = pose3*t11 + pose4*t19 - pose6*t6
    t76 = pose3*t42 + pose4*t30 - pose6*t38
    t77 = -t28*t76 + t51*t75
    t78 = -t28*t72 + t51*t73
    t79 = t45*t75 - t49*t76
    t80 = pose4*t38 + pose5*t42 + pose6*t30
    t81 = t28*t80
    t82 = pose4*t6 + pose5*t11 + pose6*t19
    t83 = t51*t82
    t84 = pose3*t6 - pose5*t19 + pose6*t11
    t85 = pose3*t38 - pose5*t30 + pose6*t42
    t86 = t45*t84 - t49*t85
    t87 = t45*t82
    t88 = t49*t80
    t89 = -t28*t85 + t51*t84
    t90 = 2*t2
    t91 = -landmark5*t51*t57 - 2*landmark8*t2*t62 + t57*t68 + t63*t90
    t92 = t14*t63 - t14*t64 + t55*t67 - t55*t68
    t93 = -landmark8*t26*t62 - 2*landmark8*t28*t52 + t26*t63 + t53*t67
    t94 = t62*t72
    t95 = t58*t73
    t96 = t58*t75
    t97 = t58*t84 - t62*t85
    t98 = t62*t80
    t99 = t58*t82
    t100 = 2*t35
    t101 = -2*landmark8*t35*t62 - landmark8*t49*t57 + t100*t63 + t57*t65
    t102 = -landmark5*t44*t58 - 2*landmark8*t49*t55 + t44*t64 + t56*t65
    t103 = t31*t63 - t31*t64 + t52*t65 - t52*t66
    t104 = landmark5*t85 - landmark8*t84
    t105 = 2*t104
    t106 = 2*landmark5*t80 - 2*landmark8*t82
    t107 = landmark5*t72 - landmark8*t73
    t108 = landmark5*t76 - landmark8*t75
    t109 = 2*t108
    t110 = 2*t107
    t111 = t3*t32
    t112 = -2*t35
    t113 = t17*t4
    t114 = t17*t9
    t115 = -t111 + t112*t113 + t114*t44
    t116 = -2*t14
    t117 = t26*t3
    t118 = t113*t90 + t114*t116 - t117
    t119 = 2*t14*t4 + 2*t2*t9
    t120 = t4*t44
    t121 = t112*t9 - t120
    t122 = 2*t5
    t123 = -t10*t15 + t122*t2 + t18*t26
    t124 = t10*t44 - t122*t35 + t18*t32
    t125 = t32*t36
    t126 = t29*t37
    t127 = t29*t41
    t128 = t112*t126 - t125 + t127*t44
    t129 = t26*t36
    t130 = t116*t127 + t126*t90 - t129
    t131 = 2*t14*t37 + 2*t2*t41
    t132 = t37*t44
    t133 = t100*t41 + t132
    t134 = -2*t52
    t135 = t113*t57 + t114*t56
    t136 = -t134*t3 + t135
    t137 = t4*t56 - t57*t9
    t138 = t10*t56 - t18*t53 + t5*t57
    t139 = t126*t57 + t127*t56
    t140 = -t134*t36 + t139
    t141 = t37*t56 - t41*t57
    t142 = landmark8*t3
    t143 = landmark5*t36
    return (
        -t28*t45 + t49*t51,
        t28*t58 - t51*t62,
        t45*t62 - t49*t58,
        t63 - t64,
        t65 - t66,
        t67 - t68,
        2*t69,
        -t70,
        -t71,
        2*t49*t72 - 2*t74 + 2*t77,
        2*t78 + 2*t79,
        -2*t81 + 2*t83 - 2*t86,
        -2*t87 + 2*t88 - 2*t89,
        -t91,
        2*t92,
        -t93,
        -2*t89 - 2*t94 + 2*t95,
        2*t62*t76 + 2*t81 - 2*t83 - 2*t96,
        2*t78 + 2*t97,
        -2*t77 - 2*t98 + 2*t99,
        -t101,
        -t102,
        2*t103,
        2*t62*t76 + 2*t86 - 2*t96,
        2*t87 - 2*t88 + 2*t94 - 2*t95,
        2*t49*t72 - 2*t74 + 2*t98 - 2*t99,
        2*t79 + 2*t97,
        0,
        0,
        0,
        t105,
        t106,
        -2*t107,
        t109,
        0,
        0,
        0,
        t109,
        t110,
        t106,
        -2*t104,
        0,
        0,
        0,
        t110,
        -2*t108,
        t105,
        t106,
        -2*t69,
        t70,
        t71,
        -t115*t51 + t118*t45,
        t3*(t119*t45 - t121*t51),
        -t123*t45 + t124*t51,
        t128*t28 - t130*t49,
        -t36*(t131*t49 + t133*t28),
        t123*t49 - t124*t28,
        t91,
        -2*t92,
        t93,
        -t118*t58 + t136*t51,
        -t3*(t119*t58 + t137*t51),
        t123*t58 - t138*t51,
        t130*t62 - t140*t28,
        t36*(t131*t62 + t141*t28),
        -t123*t62 + t138*t28,
        t101,
        t102,
        -2*t103,
        t115*t58 - t136*t45,
        t3*(t121*t58 + t137*t45),
        -t124*t58 + t138*t45,
        -t128*t62 + t140*t49,
        -t36*(t141*t49 + t62*(t112*t41 - t132)),
        t124*t62 - t138*t49,
        0,
        0,
        0,
        landmark8*(t135 + t3*t53),
        -t137*t142,
        -landmark8*t138 + t38*t57 + 2*t42*t55 - t54,
        -landmark5*(t139 + t36*t53),
        t141*t143,
        landmark5*t138 + t59 - t60 - t61,
        0,
        0,
        0,
        landmark8*(-t100*t113 - t111 + t17*t44*t9),
        -t142*(t100*t9 + t120),
        -landmark8*t124 + 2*t30*t31 - t40 + t42*t44,
        -landmark5*(-t100*t126 - t125 + t29*t41*t44),
        t133*t143,
        landmark5*t124 - t46 + t47 - t48,
        0,
        0,
        0,
        landmark8*(-t114*t15 - t117 + 2*t17*t2*t4),
        t119*t142,
        -landmark8*t123 + 2*t2*t38 + t26*t30 - t50,
        -landmark5*(-t127*t15 - t129 + 2*t2*t29*t37),
        -t131*t143,
        landmark5*t123 + t16 - t27 - t8,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose4
    t1 = pose5*pose6
    t2 = t0 + t1
    t3 = 2*rays1
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = t4 - t5
    t7 = 2*rays0
    t8 = pose6*pose6
    t9 = pose4*pose4
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose5*pose5
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = pose3*pose6
    t16 = pose4*pose5
    t17 = t15 + t16
    t18 = t0 - t1
    t19 = 2*rays2
    t20 = -t8
    t21 = t10 + t11 + t12 + t20
    t22 = rays1*t21 + t17*t7 - t18*t19
    t23 = t4 + t5
    t24 = t15 - t16
    t25 = t13 + t20 + t9
    t26 = rays0*t25 + t19*t23 - t24*t3
    t27 = 2*rays4
    t28 = 2*rays3
    t29 = 2*rays5
    t30 = rays4*t21 + t17*t28 - t18*t29
    t31 = rays3*t25 + t23*t29 - t24*t27
    return (
        pose0,
        pose1,
        pose2,
        arctan2(rays2*t14 + t2*t3 - t6*t7, sqrt(t22*t22 + t26*t26)),
        arctan2(t22, t26),
        prior0,
        arctan2(rays5*t14 + t2*t27 - t28*t6, sqrt(t30*t30 + t31*t31)),
        arctan2(t30, t31),
        prior1,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = 2*rays0
    t4 = pose6*pose6
    t5 = pose4*pose4
    t6 = -t5
    t7 = pose3*pose3
    t8 = pose5*pose5
    t9 = t7 - t8
    t10 = t4 + t6 + t9
    t11 = pose3*pose4
    t12 = pose5*pose6
    t13 = t11 + t12
    t14 = 2*rays1
    t15 = rays2*t10 + t13*t14
    t16 = t15 - t2*t3
    t17 = t11 - t12
    t18 = 2*rays2
    t19 = -t4
    t20 = t19 + t6 + t7 + t8
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = rays1*t20 + t23*t3
    t25 = -t17*t18 + t24
    t26 = t0 + t1
    t27 = t21 - t22
    t28 = t19 + t5 + t9
    t29 = rays0*t28 - t14*t27 + t18*t26
    t30 = t25*t25 + t29*t29
    t31 = sqrt(t30)
    t32 = 2*rays3
    t33 = 2*rays4
    t34 = rays5*t10 + t13*t33
    t35 = -t2*t32 + t34
    t36 = 2*rays5
    t37 = rays4*t20 + t23*t32
    t38 = -t17*t36 + t37
    t39 = rays3*t28 + t26*t36 - t27*t33
    t40 = t38*t38 + t39*t39
    t41 = sqrt(t40)
    t42 = 1/(t16*t16 + t30)
    t43 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t44 = pose4*rays0 + pose5*rays1 + pose6*rays2
    t45 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t46 = t29*t45
    t47 = 1/(t31)
    t48 = -t2
    t49 = t47*(t15 + t3*t48)
    t50 = t31*t43 + t49*(t25*t44 + t46)
    t51 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t52 = -t29*t44
    t53 = -t31*t51 + t49*(-t25*t45 - t52)
    t54 = t25*t51 + t29*t43
    t55 = -t31*t45 + t49*t54
    t56 = -t29*t51
    t57 = -t31*t44 + t49*(t25*t43 + t56)
    t58 = 1/(t30)
    t59 = -t17
    t60 = t18*t59 + t24
    t61 = t44*t60 + t46
    t62 = t45*t60 + t52
    t63 = t43*t60 + t56
    t64 = 1/(t35*t35 + t40)
    t65 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t66 = pose4*rays3 + pose5*rays4 + pose6*rays5
    t67 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t68 = t39*t67
    t69 = 1/(t41)
    t70 = t69*(t32*t48 + t34)
    t71 = t41*t65 + t70*(t38*t66 + t68)
    t72 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t73 = -t39*t66
    t74 = -t41*t72 + t70*(-t38*t67 - t73)
    t75 = t38*t72 + t39*t65
    t76 = -t41*t67 + t70*t75
    t77 = -t39*t72
    t78 = -t41*t66 + t70*(t38*t65 + t77)
    t79 = 1/(t40)
    t80 = t36*t59 + t37
    t81 = t66*t80 + t68
    t82 = t67*t80 + t73
    t83 = t65*t80 + t77
    t84 = 2*t31
    t85 = 2*t23
    t86 = 2*t27
    t87 = 2*t41
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t31),
        arctan2(t25, t29),
        prior0,
        arctan2(t35, t41),
        arctan2(t38, t39),
        prior1,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        t42*(-pose3*t53 + pose4*t55 + pose5*t57 - pose6*t50),
        t42*(-pose3*t50 - pose4*t57 + pose5*t55 + pose6*t53),
        t42*(-pose3*t57 + pose4*t50 - pose5*t53 + pose6*t55),
        0,
        0,
        0,
        t58*(-pose3*t61 + pose4*t63 - pose5*t54 - pose6*t62),
        t58*(-pose3*t62 + pose4*t54 + pose5*t63 + pose6*t61),
        t58*(pose3*t54 + pose4*t62 - pose5*t61 + pose6*t63),
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t64*(-pose3*t74 + pose4*t76 + pose5*t78 - pose6*t71),
        t64*(-pose3*t71 - pose4*t78 + pose5*t76 + pose6*t74),
        t64*(-pose3*t78 + pose4*t71 - pose5*t74 + pose6*t76),
        0,
        0,
        0,
        t79*(-pose3*t81 + pose4*t83 - pose5*t75 - pose6*t82),
        t79*(-pose3*t82 + pose4*t75 + pose5*t83 + pose6*t81),
        t79*(pose3*t75 + pose4*t82 - pose5*t81 + pose6*t83),
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
        -t42*(t2*t84 + t49*(t25*t85 + t28*t29)),
        t42*(t13*t84 + t16*t47*(-t20*t25 + t29*t86)),
        t42*(t10*t31 - 2*t49*(-t17*t25 + t26*t29)),
        0,
        0,
        0,
        t58*(-t25*t28 + t29*t85),
        t58*(t20*t29 + t25*t86),
        -2*t58*(t17*t29 + t26*t60),
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
        -t64*(t2*t87 + t70*(t28*t39 + t38*t85)),
        t64*(t13*t87 + t35*t69*(-t20*t38 + t39*t86)),
        t64*(t10*t41 - 2*t70*(-t17*t38 + t26*t39)),
        0,
        0,
        0,
        t79*(-t28*t38 + t39*t85),
        t79*(t20*t39 + t38*t86),
        -2*t79*(t17*t39 + t26*t80),
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
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
    )


def from_frame_storage_jac(pose, rays, prior):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = 2*rays0
    t4 = pose6*pose6
    t5 = pose4*pose4
    t6 = -t5
    t7 = pose3*pose3
    t8 = pose5*pose5
    t9 = t7 - t8
    t10 = t4 + t6 + t9
    t11 = pose3*pose4
    t12 = pose5*pose6
    t13 = t11 + t12
    t14 = 2*rays1
    t15 = rays2*t10 + t13*t14
    t16 = t15 - t2*t3
    t17 = t11 - t12
    t18 = 2*rays2
    t19 = -t4
    t20 = t19 + t6 + t7 + t8
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = rays1*t20 + t23*t3
    t25 = -t17*t18 + t24
    t26 = t0 + t1
    t27 = t21 - t22
    t28 = t19 + t5 + t9
    t29 = rays0*t28 - t14*t27 + t18*t26
    t30 = t25*t25 + t29*t29
    t31 = sqrt(t30)
    t32 = 2*rays3
    t33 = 2*rays4
    t34 = rays5*t10 + t13*t33
    t35 = -t2*t32 + t34
    t36 = 2*rays5
    t37 = rays4*t20 + t23*t32
    t38 = -t17*t36 + t37
    t39 = rays3*t28 + t26*t36 - t27*t33
    t40 = t38*t38 + t39*t39
    t41 = sqrt(t40)
    t42 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t43 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t44 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t45 = t25*t44 + t29*t43
    t46 = 1/(t31)
    t47 = -t2
    t48 = t46*(t15 + t3*t47)
    t49 = 1/(t16*t16 + t30)
    t50 = 2*t49
    t51 = pose4*rays0 + pose5*rays1 + pose6*rays2
    t52 = -t29*t51
    t53 = t29*t42
    t54 = -t29*t44
    t55 = -t17
    t56 = t18*t55 + t24
    t57 = 1/(t30)
    t58 = 2*t57
    t59 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t60 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t61 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t62 = t38*t61 + t39*t60
    t63 = 1/(t41)
    t64 = t63*(t32*t47 + t34)
    t65 = 1/(t35*t35 + t40)
    t66 = 2*t65
    t67 = pose4*rays3 + pose5*rays4 + pose6*rays5
    t68 = -t39*t67
    t69 = t39*t59
    t70 = -t39*t61
    t71 = t36*t55 + t37
    t72 = 1/(t40)
    t73 = 2*t72
    t74 = 2*t31
    t75 = 2*t23
    t76 = 2*t27
    t77 = 2*t41
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t31),
        arctan2(t25, t29),
        prior0,
        arctan2(t35, t41),
        arctan2(t38, t39),
        prior1,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t50*(t31*t42 - t45*t48),
        t50*(t31*t44 - t48*(-t25*t42 - t52)),
        -t50*(t31*t43 + t48*(t25*t51 + t53)),
        t50*(t31*t51 - t48*(t25*t43 + t54)),
        0,
        0,
        0,
        t58*(-t43*t56 - t54),
        -t58*(t51*t56 + t53),
        t58*(-t42*t56 - t52),
        t45*t58,
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
        t66*(t41*t59 - t62*t64),
        t66*(t41*t61 - t64*(-t38*t59 - t68)),
        -t66*(t41*t60 + t64*(t38*t67 + t69)),
        t66*(t41*t67 - t64*(t38*t60 + t70)),
        0,
        0,
        0,
        t73*(-t60*t71 - t70),
        -t73*(t67*t71 + t69),
        t73*(-t59*t71 - t68),
        t62*t73,
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
        0,
        -t49*(t2*t74 + t48*(t25*t75 + t28*t29)),
        t49*(t13*t74 + t16*t46*(-t20*t25 + t29*t76)),
        t49*(t10*t31 - 2*t48*(-t17*t25 + t26*t29)),
        0,
        0,
        0,
        t57*(-t25*t28 + t29*t75),
        t57*(t20*t29 + t25*t76),
        -t58*(t17*t29 + t26*t56),
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
        -t65*(t2*t77 + t64*(t28*t39 + t38*t75)),
        t65*(t13*t77 + t35*t63*(-t20*t38 + t39*t76)),
        t65*(t10*t41 - 2*t64*(-t17*t38 + t26*t39)),
        0,
        0,
        0,
        t72*(-t28*t38 + t39*t75),
        t72*(t20*t39 + t38*t76),
        -t73*(t17*t39 + t26*t71),
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
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark5*landmark8
    t1 = abscissa*landmark5
    t2 = t1*cos(landmark6)
    t3 = landmark8*(abscissa - 1)
    t4 = t3*cos(landmark3)
    return (
        landmark0*t0 + t2*cos(landmark7) - t4*cos(landmark4),
        landmark1*t0 + t2*sin(landmark7) - t4*sin(landmark4),
        landmark2*t0 + t1*sin(landmark6) - t3*sin(landmark3),
        t0,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark5*landmark8
    t1 = cos(landmark7)
    t2 = cos(landmark6)
    t3 = abscissa*t2
    t4 = t1*t3
    t5 = landmark5*t4
    t6 = cos(landmark4)
    t7 = abscissa - 1
    t8 = cos(landmark3)
    t9 = t7*t8
    t10 = t6*t9
    t11 = -landmark8*t10
    t12 = sin(landmark7)
    t13 = t12*t3
    t14 = landmark5*t13
    t15 = sin(landmark4)
    t16 = t15*t9
    t17 = landmark8*t16
    t18 = sin(landmark6)
    t19 = abscissa*t18
    t20 = landmark5*t19
    t21 = sin(landmark3)
    t22 = t21*t7
    t23 = landmark8*t22
    t24 = landmark5*t2
    t25 = landmark8*t8
    return (
        landmark0*t0 + t11 + t5,
        landmark1*t0 + t14 - t17,
        landmark2*t0 + t20 - t23,
        t0,
        t0,
        0,
        0,
        t23*t6,
        t17,
        landmark0*landmark8 + t4,
        -t1*t20,
        -t14,
        landmark0*landmark5 - t10,
        0,
        t0,
        0,
        t15*t23,
        t11,
        landmark1*landmark8 + t13,
        -t12*t20,
        t5,
        landmark1*landmark5 - t16,
        0,
        0,
        t0,
        -landmark8*t9,
        0,
        landmark2*landmark8 + t19,
        landmark5*t3,
        0,
        landmark2*landmark5 - t22,
        0,
        0,
        0,
        0,
        0,
        landmark8,
        0,
        0,
        landmark5,
        t1*t24 - t25*t6,
        t12*t24 - t15*t25,
        landmark5*t18 - landmark8*t21,
        0,
    )
