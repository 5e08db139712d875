"""Generated from slamlib/landmarks/plk_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "to_frame": "782f58126cdf9468",
    "from_frame": "c71a4fb8fbf01fbe",
    "point_at": "ac9ac0ca3878e409",
    "constrain": "7b8f610109c4d2b7",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (6,),
    "point_at": (4,),
    "constrain": (6,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - landmark3*pose2 + landmark5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 + landmark3*pose1 - landmark4*pose0
    t9 = 2*t8
    t10 = landmark0 + landmark4*pose2 - landmark5*pose1
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t0 - t1
    t22 = 2*t10
    t23 = -t11
    t24 = t12 + t16 + t23
    t25 = t5 + t6
    t26 = t18 - t19
    t27 = t13 + t14 + t15 + t23
    t28 = 2*landmark4
    t29 = 2*landmark5
    t30 = 2*landmark3
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        landmark3*t17 + t2*t28 - t29*t7,
        landmark4*t24 + t20*t29 - t21*t30,
        landmark5*t27 + t25*t30 - t26*t28,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - landmark3*pose2 + landmark5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 + landmark3*pose1 - landmark4*pose0
    t9 = 2*t8
    t10 = landmark0 + landmark4*pose2 - landmark5*pose1
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t0 - t1
    t22 = 2*t10
    t23 = -t11
    t24 = t12 + t16 + t23
    t25 = t5 + t6
    t26 = t18 - t19
    t27 = t13 + t14 + t15 + t23
    t28 = 2*landmark4
    t29 = 2*landmark5
    t30 = 2*landmark3
    t31 = pose4*t10 + pose5*t3 + pose6*t8
    t32 = pose3*t10 - pose5*t8 + pose6*t3
    t33 = pose3*t3 + pose4*t8 - pose6*t10
    t34 = pose3*t8 - pose4*t3 + pose5*t10
    t35 = pose3*t31 - pose4*t32 - pose5*t33 - pose6*t34
    t36 = pose3*t34 - pose4*t33 + pose5*t32 + pose6*t31
    t37 = pose3*t33 + pose4*t34 + pose5*t31 - pose6*t32
    t38 = pose3*t32 + pose4*t31 - pose5*t34 + pose6*t33
    t39 = landmark3*pose4 + landmark4*pose5 + landmark5*pose6
    t40 = landmark3*pose3 + landmark4*pose6 - landmark5*pose5
    t41 = -landmark3*pose6 + landmark4*pose3 + landmark5*pose4
    t42 = landmark3*pose5 - landmark4*pose4 + landmark5*pose3
    t43 = pose3*t39 - pose4*t40 - pose5*t41 - pose6*t42
    t44 = pose3*t42 - pose4*t41 + pose5*t40 + pose6*t39
    t45 = pose3*t41 + pose4*t42 + pose5*t39 - pose6*t40
    t46 = pose3*t40 + pose4*t39 - pose5*t42 + pose6*t41
    t47 = 2*t2
    t48 = -2*t7
    t49 = 2*pose0
    t50 = -2*t21
    t51 = 2*t20
    t52 = 2*pose1
    t53 = 2*t25
    t54 = -2*t26
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        landmark3*t17 + t2*t28 - t29*t7,
        landmark4*t24 + t20*t29 - t21*t30,
        landmark5*t27 + t25*t30 - t26*t28,
        2*landmark4*t7 + 2*landmark5*t2,
        -landmark5*t17 - t30*t7,
        landmark4*t17 - t2*t30,
        t35,
        -t36,
        t37,
        landmark5*t24 - t20*t28,
        2*landmark3*t20 + 2*landmark5*t21,
        -landmark3*t24 - t21*t28,
        t36,
        t35,
        -t38,
        -landmark4*t27 - t26*t29,
        landmark3*t27 - t25*t29,
        2*landmark3*t26 + 2*landmark4*t25,
        -t37,
        t38,
        t35,
        0,
        0,
        0,
        t43,
        -t44,
        t45,
        0,
        0,
        0,
        t44,
        t43,
        -t46,
        0,
        0,
        0,
        -t45,
        t46,
        t43,
        t17,
        t47,
        t48,
        -2*pose1*t7 - 2*pose2*t2,
        pose2*t17 + t49*t7,
        -pose1*t17 + t2*t49,
        t50,
        t24,
        t51,
        -pose2*t24 + t20*t52,
        -2*pose0*t20 - 2*pose2*t21,
        pose0*t24 + t21*t52,
        t53,
        t54,
        t27,
        pose1*t27 + 2*pose2*t26,
        -pose0*t27 + 2*pose2*t25,
        -2*pose0*t26 - 2*pose1*t25,
        0,
        0,
        0,
        t17,
        t47,
        t48,
        0,
        0,
        0,
        t50,
        t24,
        t51,
        0,
        0,
        0,
        t53,
        t54,
        t27,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - landmark3*pose2 + landmark5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 + landmark3*pose1 - landmark4*pose0
    t9 = 2*t8
    t10 = landmark0 + landmark4*pose2 - landmark5*pose1
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t0 - t1
    t22 = 2*t10
    t23 = -t11
    t24 = t12 + t16 + t23
    t25 = t5 + t6
    t26 = t18 - t19
    t27 = t13 + t14 + t15 + t23
    t28 = 2*landmark4
    t29 = 2*landmark5
    t30 = 2*landmark3
    t31 = pose3*t10 - pose5*t8 + pose6*t3
    t32 = 2*t31
    t33 = 2*pose4*t10 + 2*pose5*t3 + 2*pose6*t8
    t34 = pose3*t8 - pose4*t3 + pose5*t10
    t35 = pose3*t3 + pose4*t8 - pose6*t10
    t36 = 2*t35
    t37 = 2*t34
    t38 = landmark3*pose3 + landmark4*pose6 - landmark5*pose5
    t39 = 2*t38
    t40 = 2*(landmark3*pose4 + landmark4*pose5 + landmark5*pose6)
    t41 = landmark3*pose5 - landmark4*pose4 + landmark5*pose3
    t42 = -landmark3*pose6 + landmark4*pose3 + landmark5*pose4
    t43 = 2*t42
    t44 = 2*t41
    t45 = 2*t2
    t46 = -2*t7
    t47 = 2*pose0
    t48 = -2*t21
    t49 = 2*t20
    t50 = 2*pose1
    t51 = 2*t25
    t52 = -2*t26
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        landmark3*t17 + t2*t28 - t29*t7,
        landmark4*t24 + t20*t29 - t21*t30,
        landmark5*t27 + t25*t30 - t26*t28,
        2*landmark4*t7 + 2*landmark5*t2,
        -landmark5*t17 - t30*t7,
        landmark4*t17 - t2*t30,
        t32,
        t33,
        -2*t34,
        t36,
        landmark5*t24 - t20*t28,
        2*landmark3*t20 + 2*landmark5*t21,
        -landmark3*t24 - t21*t28,
        t36,
        t37,
        t33,
        -2*t31,
        -landmark4*t27 - t26*t29,
        landmark3*t27 - t25*t29,
        2*landmark3*t26 + 2*landmark4*t25,
        t37,
        -2*t35,
        t32,
        t33,
        0,
        0,
        0,
        t39,
        t40,
        -2*t41,
        t43,
        0,
        0,
        0,
        t43,
        t44,
        t40,
        -2*t38,
        0,
        0,
        0,
        t44,
        -2*t42,
        t39,
        t40,
        t17,
        t45,
        t46,
        -2*pose1*t7 - 2*pose2*t2,
        pose2*t17 + t47*t7,
        -pose1*t17 + t2*t47,
        t48,
        t24,
        t49,
        -pose2*t24 + t20*t50,
        -2*pose0*t20 - 2*pose2*t21,
        pose0*t24 + t21*t50,
        t51,
        t52,
        t27,
        pose1*t27 + 2*pose2*t26,
        -pose0*t27 + 2*pose2*t25,
        -2*pose0*t26 - 2*pose1*t25,
        0,
        0,
        0,
        t17,
        t45,
        t46,
        0,
        0,
        0,
        t48,
        t24,
        t49,
        0,
        0,
        0,
        t51,
        t52,
        t27,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = rays0*rays4 - rays1*rays3
    t4 = rays0*rays5 - rays2*rays3
    t5 = rays1*rays5 - rays2*rays4
    t6 = t3*t3 + t5*t5
    t7 = 1/(sqrt(t4*t4 + t6))
    t8 = t3*t7
    t9 = 2*t8
    t10 = pose3*pose6
    t11 = pose4*pose5
    t12 = t10 - t11
    t13 = t4*t7
    t14 = 2*t13
    t15 = pose3*pose3
    t16 = pose4*pose4
    t17 = pose5*pose5
    t18 = -t17
    t19 = pose6*pose6
    t20 = -t19
    t21 = t15 + t16 + t18 + t20
    t22 = t5*t7
    t23 = rays1 - rays4
    t24 = rays0 - rays3
    t25 = rays2 - rays5
    t26 = prior0*t23 - prior1*t7*(-t24*t3 + t25*t5)
    t27 = pose3*pose4
    t28 = pose5*pose6
    t29 = t27 + t28
    t30 = 1/(sqrt(t23*t23 + t24*t24 + t25*t25))
    t31 = 2*t30
    t32 = t29*t31
    t33 = t0 - t1
    t34 = prior0*t30
    t35 = -t23
    t36 = -t25
    t37 = -t4
    t38 = -t24
    t39 = prior1/(sqrt(t37*t37 + t6)*sqrt(t35*t35 + t36*t36 + t38*t38))
    t40 = t24*t34 + t39*(t3*t35 - t36*t37)
    t41 = t15 - t16
    t42 = t18 + t19 + t41
    t43 = t25*t34 + t39*(-t35*t5 + t37*t38)
    t44 = t42*t43
    t45 = -t26*t32 + 2*t33*t40 - t44
    t46 = t17 + t20 + t41
    t47 = t30*t46
    t48 = t10 + t11
    t49 = 2*t40
    t50 = t48*t49
    t51 = t27 - t28
    t52 = -t26*t47 + 2*t43*t51 - t50
    t53 = -t26
    t54 = 2*t43
    t55 = t2*t54 + t21*t40
    t56 = t12*t31*t53 + t55
    return (
        pose1*t45 - pose2*t52 + t12*t14 + t2*t9 + t21*t22,
        -pose0*(t32*t53 + t33*t49 - t44) - pose2*t56 - t13*t46 + 2*t48*t5*t7 - t51*t9,
        pose0*(t47*t53 - t50 + t51*t54) + pose1*t56 - t14*t29 - 2*t22*t33 + t42*t8,
        2*t12*t26*t30 - t55,
        t52,
        t45,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays4
    t1 = rays1*rays3
    t2 = t0 - t1
    t3 = rays0*rays5
    t4 = rays2*rays3
    t5 = t3 - t4
    t6 = rays1*rays5
    t7 = rays2*rays4
    t8 = t6 - t7
    t9 = t2*t2 + t8*t8
    t10 = t5*t5 + t9
    t11 = 1/(sqrt(t10))
    t12 = t11*t2
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 + t14
    t16 = 2*t15
    t17 = t11*t5
    t18 = pose3*pose6
    t19 = pose4*pose5
    t20 = t18 - t19
    t21 = 2*t20
    t22 = pose3*pose3
    t23 = pose4*pose4
    t24 = pose5*pose5
    t25 = -t24
    t26 = pose6*pose6
    t27 = -t26
    t28 = t22 + t23 + t25 + t27
    t29 = t11*t8
    t30 = rays0 - rays3
    t31 = t30*t30
    t32 = rays1 - rays4
    t33 = t32*t32
    t34 = rays2 - rays5
    t35 = t34*t34
    t36 = t31 + t33 + t35
    t37 = 1/(sqrt(t36))
    t38 = prior0*t32
    t39 = t2*t30
    t40 = -t34*t8 + t39
    t41 = -t40
    t42 = prior1*t11
    t43 = t38 - t41*t42
    t44 = t37*t43
    t45 = pose3*pose4
    t46 = pose5*pose6
    t47 = t45 + t46
    t48 = 2*t47
    t49 = t13 - t14
    t50 = prior0*t37
    t51 = -t32
    t52 = t2*t51
    t53 = -t34
    t54 = -t5
    t55 = t53*t54
    t56 = t52 - t55
    t57 = -t30
    t58 = t51*t51 + t53*t53 + t57*t57
    t59 = 1/(sqrt(t58))
    t60 = t54*t54 + t9
    t61 = 1/(sqrt(t60))
    t62 = prior1*t61
    t63 = t59*t62
    t64 = t30*t50 + t56*t63
    t65 = 2*t64
    t66 = t49*t65
    t67 = t22 - t23
    t68 = t25 + t26 + t67
    t69 = t54*t57
    t70 = t51*t8
    t71 = t69 - t70
    t72 = t34*t50 + t63*t71
    t73 = t68*t72
    t74 = -t44*t48 + t66 - t73
    t75 = t24 + t27 + t67
    t76 = t37*t75
    t77 = t18 + t19
    t78 = t65*t77
    t79 = t45 - t46
    t80 = 2*t72
    t81 = t79*t80
    t82 = -t43*t76 - t78 + t81
    t83 = 2*t79
    t84 = -t43
    t85 = t37*t84
    t86 = t15*t80 + t28*t64
    t87 = t21*t85 + t86
    t88 = t48*t85 + t66 - t73
    t89 = t76*t84 - t78 + t81
    t90 = 2*t20*t37*t43 - t86
    t91 = prior0*t57 - t56*t62
    t92 = prior0*t53 - t62*t71
    t93 = t2*t57
    t94 = t53*t8
    t95 = prior0*t51 + t62*(t93 - t94)
    t96 = t59*(pose3*t91 + pose5*t92 - pose6*t95)
    t97 = pose4*t64 + pose6*t72
    t98 = pose5*t37*t84 - t97
    t99 = pose4*t17
    t100 = pose5*t29
    t101 = pose3*t12
    t102 = pose2*t98 + t100 - t101 + t99
    t103 = pose1*t96 + t102
    t104 = pose6*t64
    t105 = -pose3*t44 + pose4*t72 - t104
    t106 = pose3*t72
    t107 = pose4*t85 + pose5*t64 - t106
    t108 = pose4*t29 - pose5*t17 + pose6*t12
    t109 = pose2*t107 + t108
    t110 = -pose4*t44 + pose5*t64 - t106
    t111 = pose3*t29 + pose5*t12 + pose6*t17
    t112 = pose1*t98
    t113 = pose3*t64 + pose5*t72
    t114 = pose6*t85 + t113
    t115 = pose3*t17
    t116 = pose4*t12
    t117 = -pose6*t11*t8
    t118 = pose2*t114 + t115 + t116 + t117
    t119 = pose3*t61
    t120 = t61*t8
    t121 = pose4*t61
    t122 = t59*(pose4*t91 + pose5*t95 + pose6*t92)
    t123 = -pose1*t122 + pose2*t96 + pose6*t120 + t119*t54 - t121*t2
    t124 = pose3*t92 + pose4*t95 - pose5*t91
    t125 = pose2*t59
    t126 = pose3*t85 + pose4*t72 - t104
    t127 = pose1*t126 + t108
    t128 = t124*t125 + t127
    t129 = -t103
    t130 = pose1*t107
    t131 = -pose2*t126 + t111
    t132 = t130 + t131
    t133 = pose3*t95 - pose4*t92 + pose6*t91
    t134 = pose0*t59
    t135 = -pose2*t122 - pose5*t120 + t119*t2 + t121*t54 + t133*t134
    t136 = pose0*t96 + t109
    t137 = -pose0*t98 + t111
    t138 = -t125*t133 + t137
    t139 = pose0*t107 + t118
    t140 = -t139
    t141 = pose5*t44 + t97
    t142 = -pose0*t114 + t108
    t143 = pose0*t126
    t144 = pose1*t59
    t145 = -pose0*t122 + pose5*t2*t61 - pose6*t54*t61 + t119*t8 + t124*t144
    t146 = t133*t144 + t142
    t147 = t112 + t115 + t116 + t117 + t124*t134
    t148 = -t147
    t149 = pose1*t114 - t100 + t101 + t143 - t99
    t150 = pose6*t37*t43 - t113
    t151 = pose3*t141
    t152 = pose4*t150
    t153 = pose6*t110
    t154 = t133*t59
    t155 = -pose6*t98
    t156 = pose4*t107
    t157 = pose5*t98
    t158 = t124*t59
    t159 = pose5*t105
    t160 = pose6*t126
    t161 = rays4*t2
    t162 = -rays5*t54 + t161
    t163 = 1/(t10*sqrt(t10))
    t164 = t162*t163
    t165 = t21*t5
    t166 = t28*t8
    t167 = 1/(t36)
    t168 = t167*t30
    t169 = prior0*t168*t34
    t170 = t30*t5
    t171 = 1/(t10)
    t172 = t162*t171
    t173 = t32*t8
    t174 = t167*t31
    t175 = -t3 + t4
    t176 = -rays5*t30 + t168*t173 + t174*t5 + t175
    t177 = t169 + t42*(t170*t172 + t172*t173 + t176)
    t178 = t37*t83
    t179 = t168*t38
    t180 = t34*t8
    t181 = rays4*t30 - t162*t171*t2*t30 - t167*t2*t31 + t168*t180 + t172*t180 + t2
    t182 = t179 - t181*t42
    t183 = 1/(t36*sqrt(t36))
    t184 = rays4*t51
    t185 = rays5*t53
    t186 = 1/(t58)
    t187 = t186*t57
    t188 = t187*t52
    t189 = t186*t53
    t190 = t189*t69
    t191 = 1/(t60)
    t192 = -t162*t191
    t193 = -prior0*t183*t31 + t50 + t63*(t184 + t185 + t188 - t190 + t192*t52 - t192*t55)
    t194 = -t193
    t195 = 2*t194
    t196 = t37*t48
    t197 = t37*t68
    t198 = t177*t197 + t182*t196 - t195*t49
    t199 = t11*t16
    t200 = t11*t28
    t201 = rays3*t2 - rays5*t8
    t202 = t163*t2
    t203 = t16*t202
    t204 = t163*t165
    t205 = t163*t166
    t206 = t167*t33
    t207 = t34*t5
    t208 = t167*t32
    t209 = t2*t32
    t210 = t171*t201
    t211 = -t0 + t1
    t212 = rays3*t32 + t2*t206 + t207*t208 - t207*t210 - t209*t210 + t211
    t213 = t179 - t212*t42
    t214 = 2*t37
    t215 = t167*t34
    t216 = t215*t38
    t217 = rays5*t32 - t170*t208 + t170*t210 + t173*t210 - t206*t8 + t8
    t218 = t216 - t217*t42
    t219 = prior0*t183
    t220 = rays3*t57
    t221 = t189*t70
    t222 = t191*t201
    t223 = -t219*t33 + t50 + t63*(t185 - t188 + t220 + t221 - t222*t93 + t222*t94)
    t224 = -t213*t214*t49 + t218*t37*t68 - t223*t48
    t225 = -t178*t218 + 2*t213*t37*t77 - t223*t75
    t226 = t11*t21
    t227 = rays3*t54 - rays4*t8
    t228 = t167*t35
    t229 = t171*t227
    t230 = rays3*t34 + t175 + t207*t229 + t209*t215 + t209*t229 + t228*t5
    t231 = t214*(t169 - t230*t42)
    t232 = -t6 + t7
    t233 = rays4*t34 - t167*t2*t30*t34 - t171*t2*t227*t30 + t180*t229 + t228*t8 + t232
    t234 = t216 - t233*t42
    t235 = -t191*t227
    t236 = -prior0*t183*t35 + t50 + t63*(t184 + t190 + t220 - t221 + t235*t69 - t235*t70)
    t237 = -t236
    t238 = rays1*t2
    t239 = rays2*t5 + t238
    t240 = rays1*t32
    t241 = rays2*t34
    t242 = t208*t39
    t243 = t170*t215
    t244 = t171*t239
    t245 = -prior0*t174 + prior0 + t42*(t207*t244 + t209*t244 - t240 - t241 + t242 + t243)
    t246 = t214*t245
    t247 = t183*t38
    t248 = t247*t30
    t249 = t186*t30
    t250 = t191*(-rays2*t54 + t238)
    t251 = t248 + t63*(rays1*t57 - t187*t39 + t211 + t249*t94 - t250*t93 + t250*t94)
    t252 = t219*t30*t34
    t253 = t252 + t63*(rays2*t57 + t175 + t249*t69 - t249*t70 + t250*t69 - t250*t70)
    t254 = t246*t49 + t251*t48 + t253*t68
    t255 = t246*t77 - t251*t75 + t253*t83
    t256 = rays0*t2 - rays2*t8
    t257 = prior0*t206
    t258 = rays0*t30
    t259 = t180*t208
    t260 = t171*t180*t256 - t171*t2*t256*t30 + t241 + t242 + t258 - t259
    t261 = prior0 - t257 - t260*t42
    t262 = t186*t32
    t263 = -t191*t256
    t264 = t248 + t63*(rays0*t51 + t2 + t262*t52 - t262*t55 + t263*t52 - t263*t55)
    t265 = 2*t264
    t266 = t247*t34
    t267 = t266 + t63*(rays2*t51 + t232 + t262*t69 - t262*t70 + t263*t69 - t263*t70)
    t268 = -t265*t77 + t267*t83
    t269 = t265*t49 - t267*t68
    t270 = t196*t261 + t269
    t271 = rays1*t8
    t272 = rays0*t5 + t271
    t273 = -prior0
    t274 = prior0*t228
    t275 = t171*t272
    t276 = -t170*t275 - t173*t275 + t240 + t243 + t258 + t259
    t277 = -t273 - t274 - t276*t42
    t278 = t191*(rays0*t54 - t271)
    t279 = t186*t34
    t280 = t266 + t63*(rays1*t53 + t180*t189 - t278*t93 + t278*t94 - t279*t93 + t8)
    t281 = t252 + t63*(rays0*t53 + t278*t52 - t278*t55 + t279*t52 - t279*t55 + t5)
    t282 = 2*t281
    t283 = -t280*t48 + t282*t49
    t284 = t197*t277 + t283
    t285 = t280*t75 + t282*t77
    t286 = t178*t277 + t285
    t287 = t11*t83
    t288 = t11*t75
    t289 = 2*t77
    t290 = t289*t8
    t291 = t16*t37
    t292 = t21*t37
    t293 = rays5*t11
    t294 = t163*t290
    t295 = t202*t83
    t296 = t163*t5*t75
    t297 = t28*t37
    t298 = t21*t223 + t213*t297 + t218*t291
    t299 = t11*t289
    t300 = rays3*t5 + rays4*t8
    t301 = t169 - t230*t42
    t302 = t214*t301
    t303 = t216 - t233*t42
    t304 = -t236*t68 - t302*t49 + 2*t303*t37*t47
    t305 = -t16*t236 + t28*t301*t37 - t292*t303
    t306 = -t16*t253 + t21*t251 + t245*t297
    t307 = t16*t267 + t264*t28
    t308 = prior0 - t274 - t276*t42
    t309 = t21*t280 - t28*t281
    t310 = t291*t308 + t309
    t311 = t11*t68
    t312 = rays5*t5 + t161
    t313 = t163*t312
    t314 = t48*t5
    t315 = 2*t49
    t316 = t315*t8
    t317 = t202*t68
    t318 = t171*t312
    t319 = t169 + t42*(t170*t318 + t173*t318 + t176)
    t320 = t179 - t181*t42
    t321 = 2*t193
    t322 = -t178*t319 + t320*t37*t75 - t321*t77
    t323 = 2*t15*t319*t37 - t193*t28 - t292*t320
    t324 = t163*t201
    t325 = t216 - t217*t42
    t326 = t179 - t212*t42
    t327 = -t223
    t328 = t11*t48
    t329 = t11*t315
    t330 = t163*t300
    t331 = t236*t83 + t302*t77 + t303*t76
    t332 = t163*t239
    t333 = t163*t256
    t334 = -t257 - t260*t42 - t273
    t335 = t268 + t334*t76
    t336 = t292*t334 + t307
    t337 = 2*t30
    t338 = t32*t48 - t337*t49 + t34*t68
    t339 = t32*t75 + t337*t77 - t34*t83
    t340 = 2*t207 + 2*t209
    t341 = t170 + t173
    t342 = t340*t49 + t341*t68 + t40*t48
    t343 = t340*t77 + t341*t83 - t40*t75
    t344 = t11*t37
    t345 = -t338
    t346 = t16*t34 - 2*t20*t32 + t28*t30
    t347 = -t346
    t348 = t59*t61
    t349 = t348*t71
    t350 = t344*t41
    t351 = t348*t56
    t352 = t16*t349 + t21*t350 + t28*t351
    t353 = t343*t344
    return (
        pose1*t74 - pose2*t82 + t12*t16 + t17*t21 + t28*t29,
        -pose0*t88 - pose2*t87 + 2*t11*t77*t8 - t12*t83 - t17*t75,
        pose0*t89 + pose1*t87 + t12*t68 - t17*t48 - 2*t29*t49,
        t90,
        t82,
        t74,
        0,
        t74,
        -t89,
        pose3*(pose1*t105 + t109) - pose4*(pose1*t110 - pose2*t105 + t111) + pose5*(-t112 - t118) - pose6*t103,
        pose3*t129 - pose4*t123 - pose5*t132 - pose6*t128,
        -pose3*t123 - pose4*t129 + pose5*t128 - pose6*t132,
        -t88,
        0,
        t90,
        -pose3*t135 - pose4*t140 - pose5*t138 + pose6*t136,
        pose3*(pose2*t110 + t142) + pose4*(pose0*t141 + t131) + pose5*t139 + pose6*(-t102 + t143),
        pose3*t138 - pose4*t136 - pose5*t135 - pose6*t140,
        t82,
        t87,
        0,
        pose3*t148 - pose4*t149 - pose5*t146 - pose6*t145,
        -pose3*t145 + pose4*t146 - pose5*t149 - pose6*t148,
        pose3*(pose0*t150 + t127) + pose4*(t130 + t137) - pose5*t147 - pose6*t149,
        0,
        0,
        0,
        pose5*t126 - t151 - t152 + t153,
        pose3*t107 - pose4*t154 + pose5*t114 + t155,
        -pose3*t154 + pose6*t114 - t156 + t157,
        0,
        0,
        0,
        -pose3*t158 - pose4*t126 + pose5*t114 - t155,
        pose6*t107 - t151 + t152 - t159,
        -pose3*t114 - pose4*t98 - pose5*t158 - t160,
        0,
        0,
        0,
        pose3*t126 - pose6*t96 - t156 - t157,
        -pose3*t96 + pose4*t98 - pose5*t107 - t160,
        -pose4*t114 - t151 - t153 + t159,
        pose1*t198 - pose2*(-t177*t178 + t182*t76 + t195*t77) + 2*rays4*t11*t15 + 2*rays5*t11*t20 - t16*t164*t2 - t164*t165 - t164*t166,
        pose1*t224 - pose2*t225 - rays3*t199 + rays5*t200 + t201*t203 + t201*t204 + t201*t205,
        pose1*(t196*t234 - t231*t49 + t237*t68) - pose2*(t231*t77 + t234*t76 - t237*t83) - rays3*t226 - rays4*t200 - t203*t227 - t204*t227 - t205*t227,
        -pose1*t254 - pose2*t255 - rays1*t199 - rays2*t226 + 2*t15*t163*t2*t239 + 2*t163*t20*t239*t5 + t163*t239*t28*t8,
        pose1*t270 - pose2*(t261*t76 + t268) + 2*rays0*t11*t15 - rays2*t200 - t203*t256 - t204*t256 - t205*t256,
        pose1*t284 + pose2*t286 + rays0*t226 + rays1*t200 - t203*t272 - t204*t272 - t205*t272,
        -pose0*t198 + pose2*(t177*t291 - t182*t292 + t194*t28) - rays4*t287 - rays5*t288 + 2*t162*t163*t2*t79 + t162*t163*t5*t75 - t164*t290,
        -pose0*t224 + pose2*t298 + rays3*t287 + t201*t294 - t201*t295 - t201*t296 + t289*t293,
        -pose0*t304 + pose2*t305 + rays3*t11*t75 - rays4*t299 + 2*t163*t300*t77*t8 - t295*t300 - t296*t300,
        pose0*t254 + pose2*t306 + rays1*t287 + rays2*t288 + t239*t294 - t239*t295 - t239*t296,
        -pose0*t270 - pose2*(t261*t292 + t307) - rays0*t287 - rays2*t299 + 2*t163*t2*t256*t79 + t163*t256*t5*t75 - t256*t294,
        -pose0*(t197*t308 + t283) + pose2*t310 - rays0*t288 + rays1*t299 - t272*t294 + t272*t295 + t272*t296,
        pose0*t322 - pose1*t323 + rays4*t311 - t293*t48 - t312*t317 + t313*t314 + t313*t316,
        pose0*(-t178*t325 + t214*t326*t77 + t327*t75) - pose1*(-t21*t327 + t291*t325 + t297*t326) - rays3*t311 + t163*t2*t201*t68 - t293*t315 - t314*t324 - t316*t324,
        pose0*t331 - pose1*t305 + rays3*t328 + rays4*t329 + t300*t317 - t314*t330 - t316*t330,
        pose0*t255 - pose1*t306 - rays1*t311 + 2*rays2*t11*t47 + t163*t2*t239*t68 - t314*t332 - t316*t332,
        pose0*t335 + pose1*t336 + rays0*t311 + rays2*t329 - t256*t317 + t314*t333 + t316*t333,
        -pose0*(t178*t308 + t285) - pose1*t310 - rays0*t328 - rays1*t329 + 2*t163*t272*t47*t5 + 2*t163*t272*t49*t8 - t272*t317,
        t323,
        t298,
        t305,
        t306,
        -t336,
        t277*t291 + t309,
        t322,
        t225,
        t331,
        t255,
        t335,
        -t286,
        t196*t320 + t197*t319 + t321*t49,
        t224,
        t304,
        -t254,
        t196*t334 + t269,
        t284,
        t37*(-pose1*t338 + pose2*t339),
        -t344*(pose1*t342 + pose2*t343),
        t37*(-pose0*t345 + pose2*t347),
        -pose0*(t315*t351 - t349*t68 + t350*t48) - pose2*t352,
        t37*(-pose0*t339 + pose1*t346),
        pose0*t353 + pose1*t352,
        t347*t37,
        -t352,
        -t339*t37,
        t353,
        t345*t37,
        -t342*t344,
    )


def from_frame_storage_jac(pose, rays, prior):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays4
    t1 = rays1*rays3
    t2 = t0 - t1
    t3 = rays0*rays5
    t4 = rays2*rays3
    t5 = t3 - t4
    t6 = rays1*rays5
    t7 = rays2*rays4
    t8 = t6 - t7
    t9 = t2*t2 + t8*t8
    t10 = t5*t5 + t9
    t11 = 1/(sqrt(t10))
    t12 = t11*t2
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 + t14
    t16 = 2*t15
    t17 = t11*t5
    t18 = pose3*pose6
    t19 = pose4*pose5
    t20 = t18 - t19
    t21 = 2*t20
    t22 = pose3*pose3
    t23 = pose4*pose4
    t24 = pose5*pose5
    t25 = -t24
    t26 = pose6*pose6
    t27 = -t26
    t28 = t22 + t23 + t25 + t27
    t29 = t11*t8
    t30 = rays0 - rays3
    t31 = t30*t30
    t32 = rays1 - rays4
    t33 = t32*t32
    t34 = rays2 - rays5
    t35 = t34*t34
    t36 = t31 + t33 + t35
    t37 = 1/(sqrt(t36))
    t38 = prior0*t32
    t39 = t2*t30
    t40 = -t34*t8 + t39
    t41 = -t40
    t42 = prior1*t11
    t43 = t38 - t41*t42
    t44 = t37*t43
    t45 = pose3*pose4
    t46 = pose5*pose6
    t47 = t45 + t46
    t48 = 2*t47
    t49 = t13 - t14
    t50 = prior0*t37
    t51 = -t32
    t52 = t2*t51
    t53 = -t34
    t54 = -t5
    t55 = t53*t54
    t56 = t52 - t55
    t57 = -t30
    t58 = t51*t51 + t53*t53 + t57*t57
    t59 = 1/(sqrt(t58))
    t60 = t54*t54 + t9
    t61 = 1/(sqrt(t60))
    t62 = prior1*t61
    t63 = t59*t62
    t64 = t30*t50 + t56*t63
    t65 = 2*t64
    t66 = t49*t65
    t67 = t22 - t23
    t68 = t25 + t26 + t67
    t69 = t54*t57
    t70 = t51*t8
    t71 = t69 - t70
    t72 = t34*t50 + t63*t71
    t73 = t68*t72
    t74 = -t44*t48 + t66 - t73
    t75 = t24 + t27 + t67
    t76 = t37*t75
    t77 = t18 + t19
    t78 = t65*t77
    t79 = t45 - t46
    t80 = 2*t72
    t81 = t79*t80
    t82 = -t43*t76 - t78 + t81
    t83 = 2*t79
    t84 = -t43
    t85 = t37*t84
    t86 = t15*t80 + t28*t64
    t87 = t21*t85 + t86
    t88 = t48*t85 + t66 - t73
    t89 = t76*t84 - t78 + t81
    t90 = 2*t20*t37*t43 - t86
    t91 = pose3*t72
    t92 = pose5*t64
    t93 = -pose4*t44 - t91 + t92
    t94 = pose6*t64
    t95 = pose4*t72
    t96 = -pose3*t44 - t94 + t95
    t97 = pose3*t29 + pose5*t12 + pose6*t17
    t98 = pose4*t85 - t91 + t92
    t99 = pose4*t29 - pose5*t17 + pose6*t12
    t100 = prior0*t57 - t56*t62
    t101 = prior0*t53 - t62*t71
    t102 = t2*t57
    t103 = t53*t8
    t104 = prior0*t51 + t62*(t102 - t103)
    t105 = pose4*t64 + pose6*t72
    t106 = pose5*t37*t84 - t105
    t107 = pose4*t17
    t108 = pose5*t29
    t109 = pose3*t12
    t110 = pose2*t106 + t107 + t108 - t109
    t111 = pose1*t106
    t112 = pose3*t64 + pose5*t72
    t113 = pose6*t85 + t112
    t114 = pose3*t17
    t115 = pose4*t12
    t116 = -pose6*t29
    t117 = pose2*t113 + t114 + t115 + t116
    t118 = pose3*t85 - t94 + t95
    t119 = pose0*t118
    t120 = pose5*t44 + t105
    t121 = pose6*t37*t43 - t112
    t122 = 2*t121
    t123 = -2*t120
    t124 = 2*t93
    t125 = 2*t96
    t126 = rays4*t2
    t127 = -rays5*t54 + t126
    t128 = 1/(t10*sqrt(t10))
    t129 = t127*t128
    t130 = t21*t5
    t131 = t28*t8
    t132 = 1/(t36)
    t133 = t132*t30
    t134 = prior0*t133*t34
    t135 = t30*t5
    t136 = 1/(t10)
    t137 = t127*t136
    t138 = t32*t8
    t139 = t132*t31
    t140 = -t3 + t4
    t141 = -rays5*t30 + t133*t138 + t139*t5 + t140
    t142 = t134 + t42*(t135*t137 + t137*t138 + t141)
    t143 = t37*t83
    t144 = t133*t38
    t145 = t34*t8
    t146 = rays4*t30 - t127*t136*t2*t30 - t132*t2*t31 + t133*t145 + t137*t145 + t2
    t147 = t144 - t146*t42
    t148 = 1/(t36*sqrt(t36))
    t149 = rays4*t51
    t150 = rays5*t53
    t151 = 1/(t58)
    t152 = t151*t57
    t153 = t152*t52
    t154 = t151*t53
    t155 = t154*t69
    t156 = 1/(t60)
    t157 = -t127*t156
    t158 = -prior0*t148*t31 + t50 + t63*(t149 + t150 + t153 - t155 + t157*t52 - t157*t55)
    t159 = -t158
    t160 = 2*t159
    t161 = t37*t48
    t162 = t37*t68
    t163 = t142*t162 + t147*t161 - t160*t49
    t164 = t11*t16
    t165 = t11*t28
    t166 = rays3*t2 - rays5*t8
    t167 = t128*t2
    t168 = t16*t167
    t169 = t128*t130
    t170 = t128*t131
    t171 = t132*t33
    t172 = t34*t5
    t173 = t132*t32
    t174 = t2*t32
    t175 = t136*t166
    t176 = -t0 + t1
    t177 = rays3*t32 + t171*t2 + t172*t173 - t172*t175 - t174*t175 + t176
    t178 = t144 - t177*t42
    t179 = 2*t37
    t180 = t132*t34
    t181 = t180*t38
    t182 = rays5*t32 - t135*t173 + t135*t175 + t138*t175 - t171*t8 + t8
    t183 = t181 - t182*t42
    t184 = prior0*t148
    t185 = rays3*t57
    t186 = t154*t70
    t187 = t156*t166
    t188 = -t184*t33 + t50 + t63*(-t102*t187 + t103*t187 + t150 - t153 + t185 + t186)
    t189 = -t178*t179*t49 + t183*t37*t68 - t188*t48
    t190 = -t143*t183 + 2*t178*t37*t77 - t188*t75
    t191 = t11*t21
    t192 = rays3*t54 - rays4*t8
    t193 = t132*t35
    t194 = t136*t192
    t195 = rays3*t34 + t140 + t172*t194 + t174*t180 + t174*t194 + t193*t5
    t196 = t179*(t134 - t195*t42)
    t197 = -t6 + t7
    t198 = rays4*t34 - t132*t2*t30*t34 - t136*t192*t2*t30 + t145*t194 + t193*t8 + t197
    t199 = t181 - t198*t42
    t200 = -t156*t192
    t201 = -prior0*t148*t35 + t50 + t63*(t149 + t155 + t185 - t186 + t200*t69 - t200*t70)
    t202 = -t201
    t203 = rays1*t2
    t204 = rays2*t5 + t203
    t205 = rays1*t32
    t206 = rays2*t34
    t207 = t173*t39
    t208 = t135*t180
    t209 = t136*t204
    t210 = -prior0*t139 + prior0 + t42*(t172*t209 + t174*t209 - t205 - t206 + t207 + t208)
    t211 = t179*t210
    t212 = t148*t38
    t213 = t212*t30
    t214 = t151*t30
    t215 = t156*(-rays2*t54 + t203)
    t216 = t213 + t63*(rays1*t57 - t102*t215 + t103*t214 + t103*t215 - t152*t39 + t176)
    t217 = t184*t30*t34
    t218 = t217 + t63*(rays2*t57 + t140 + t214*t69 - t214*t70 + t215*t69 - t215*t70)
    t219 = t211*t49 + t216*t48 + t218*t68
    t220 = t211*t77 - t216*t75 + t218*t83
    t221 = rays0*t2 - rays2*t8
    t222 = prior0*t171
    t223 = rays0*t30
    t224 = t145*t173
    t225 = t136*t145*t221 - t136*t2*t221*t30 + t206 + t207 + t223 - t224
    t226 = prior0 - t222 - t225*t42
    t227 = t151*t32
    t228 = -t156*t221
    t229 = t213 + t63*(rays0*t51 + t2 + t227*t52 - t227*t55 + t228*t52 - t228*t55)
    t230 = 2*t229
    t231 = t212*t34
    t232 = t231 + t63*(rays2*t51 + t197 + t227*t69 - t227*t70 + t228*t69 - t228*t70)
    t233 = -t230*t77 + t232*t83
    t234 = t230*t49 - t232*t68
    t235 = t161*t226 + t234
    t236 = rays1*t8
    t237 = rays0*t5 + t236
    t238 = -prior0
    t239 = prior0*t193
    t240 = t136*t237
    t241 = -t135*t240 - t138*t240 + t205 + t208 + t223 + t224
    t242 = -t238 - t239 - t241*t42
    t243 = t156*(rays0*t54 - t236)
    t244 = t151*t34
    t245 = t231 + t63*(rays1*t53 - t102*t243 - t102*t244 + t103*t243 + t145*t154 + t8)
    t246 = t217 + t63*(rays0*t53 + t243*t52 - t243*t55 + t244*t52 - t244*t55 + t5)
    t247 = 2*t246
    t248 = -t245*t48 + t247*t49
    t249 = t162*t242 + t248
    t250 = t245*t75 + t247*t77
    t251 = t143*t242 + t250
    t252 = t11*t83
    t253 = t11*t75
    t254 = 2*t77
    t255 = t254*t8
    t256 = t16*t37
    t257 = t21*t37
    t258 = rays5*t11
    t259 = t128*t255
    t260 = t167*t83
    t261 = t128*t5*t75
    t262 = t28*t37
    t263 = t178*t262 + t183*t256 + t188*t21
    t264 = t11*t254
    t265 = rays3*t5 + rays4*t8
    t266 = t134 - t195*t42
    t267 = t179*t266
    t268 = t181 - t198*t42
    t269 = -t201*t68 - t267*t49 + 2*t268*t37*t47
    t270 = -t16*t201 - t257*t268 + t266*t28*t37
    t271 = -t16*t218 + t21*t216 + t210*t262
    t272 = t16*t232 + t229*t28
    t273 = prior0 - t239 - t241*t42
    t274 = t21*t245 - t246*t28
    t275 = t256*t273 + t274
    t276 = t11*t68
    t277 = rays5*t5 + t126
    t278 = t128*t277
    t279 = t48*t5
    t280 = 2*t49
    t281 = t280*t8
    t282 = t167*t68
    t283 = t136*t277
    t284 = t134 + t42*(t135*t283 + t138*t283 + t141)
    t285 = t144 - t146*t42
    t286 = 2*t158
    t287 = -t143*t284 + t285*t37*t75 - t286*t77
    t288 = 2*t15*t284*t37 - t158*t28 - t257*t285
    t289 = t128*t166
    t290 = t181 - t182*t42
    t291 = t144 - t177*t42
    t292 = -t188
    t293 = t11*t48
    t294 = t11*t280
    t295 = t128*t265
    t296 = t201*t83 + t267*t77 + t268*t76
    t297 = t128*t204
    t298 = t128*t221
    t299 = -t222 - t225*t42 - t238
    t300 = t233 + t299*t76
    t301 = t257*t299 + t272
    t302 = 2*t30
    t303 = -t302*t49 + t32*t48 + t34*t68
    t304 = t302*t77 + t32*t75 - t34*t83
    t305 = 2*t172 + 2*t174
    t306 = t135 + t138
    t307 = t305*t49 + t306*t68 + t40*t48
    t308 = t305*t77 + t306*t83 - t40*t75
    t309 = t11*t37
    t310 = -t303
    t311 = t16*t34 - 2*t20*t32 + t28*t30
    t312 = -t311
    t313 = t59*t61
    t314 = t313*t71
    t315 = t309*t41
    t316 = t313*t56
    t317 = t16*t314 + t21*t315 + t28*t316
    t318 = t308*t309
    return (
        pose1*t74 - pose2*t82 + t12*t16 + t17*t21 + t28*t29,
        -pose0*t88 - pose2*t87 + 2*t11*t77*t8 - t12*t83 - t17*t75,
        pose0*t89 + pose1*t87 + t12*t68 - t17*t48 - 2*t29*t49,
        t90,
        t82,
        t74,
        0,
        t74,
        -t89,
        2*pose1*t93 - 2*pose2*t96 + 2*t97,
        2*pose1*t96 + 2*pose2*t98 + 2*t99,
        -2*pose1*t59*(pose3*t100 + pose5*t101 - pose6*t104) - 2*t110,
        2*t111 + 2*t117,
        -t88,
        0,
        t90,
        -2*pose0*t98 - 2*t117,
        2*t110 - 2*t119,
        -2*pose0*t113 + 2*pose2*t93 + 2*t99,
        2*pose0*t120 - 2*pose2*t118 + 2*t97,
        t82,
        t87,
        0,
        2*pose1*t113 - 2*t107 - 2*t108 + 2*t109 + 2*t119,
        -2*pose0*t59*(pose3*t101 + pose4*t104 - pose5*t100) - 2*t111 - 2*t114 - 2*t115 - 2*t116,
        2*pose0*t106 - 2*pose1*t98 - 2*t97,
        2*pose0*t121 + 2*pose1*t118 + 2*t99,
        0,
        0,
        0,
        t122,
        t123,
        t124,
        -2*t118,
        0,
        0,
        0,
        t125,
        -2*t98,
        t123,
        t122,
        0,
        0,
        0,
        t124,
        t125,
        2*t113,
        t123,
        pose1*t163 - pose2*(-t142*t143 + t147*t76 + t160*t77) + 2*rays4*t11*t15 + 2*rays5*t11*t20 - t129*t130 - t129*t131 - t129*t16*t2,
        pose1*t189 - pose2*t190 - rays3*t164 + rays5*t165 + t166*t168 + t166*t169 + t166*t170,
        pose1*(t161*t199 - t196*t49 + t202*t68) - pose2*(t196*t77 + t199*t76 - t202*t83) - rays3*t191 - rays4*t165 - t168*t192 - t169*t192 - t170*t192,
        -pose1*t219 - pose2*t220 - rays1*t164 - rays2*t191 + 2*t128*t15*t2*t204 + 2*t128*t20*t204*t5 + t128*t204*t28*t8,
        pose1*t235 - pose2*(t226*t76 + t233) + 2*rays0*t11*t15 - rays2*t165 - t168*t221 - t169*t221 - t170*t221,
        pose1*t249 + pose2*t251 + rays0*t191 + rays1*t165 - t168*t237 - t169*t237 - t170*t237,
        -pose0*t163 + pose2*(t142*t256 - t147*t257 + t159*t28) - rays4*t252 - rays5*t253 + 2*t127*t128*t2*t79 + t127*t128*t5*t75 - t129*t255,
        -pose0*t189 + pose2*t263 + rays3*t252 + t166*t259 - t166*t260 - t166*t261 + t254*t258,
        -pose0*t269 + pose2*t270 + rays3*t11*t75 - rays4*t264 + 2*t128*t265*t77*t8 - t260*t265 - t261*t265,
        pose0*t219 + pose2*t271 + rays1*t252 + rays2*t253 + t204*t259 - t204*t260 - t204*t261,
        -pose0*t235 - pose2*(t226*t257 + t272) - rays0*t252 - rays2*t264 + 2*t128*t2*t221*t79 + t128*t221*t5*t75 - t221*t259,
        -pose0*(t162*t273 + t248) + pose2*t275 - rays0*t253 + rays1*t264 - t237*t259 + t237*t260 + t237*t261,
        pose0*t287 - pose1*t288 + rays4*t276 - t258*t48 - t277*t282 + t278*t279 + t278*t281,
        pose0*(-t143*t290 + t179*t291*t77 + t292*t75) - pose1*(-t21*t292 + t256*t290 + t262*t291) - rays3*t276 + t128*t166*t2*t68 - t258*t280 - t279*t289 - t281*t289,
        pose0*t296 - pose1*t270 + rays3*t293 + rays4*t294 + t265*t282 - t279*t295 - t281*t295,
        pose0*t220 - pose1*t271 - rays1*t276 + 2*rays2*t11*t47 + t128*t2*t204*t68 - t279*t297 - t281*t297,
        pose0*t300 + pose1*t301 + rays0*t276 + rays2*t294 - t221*t282 + t279*t298 + t281*t298,
        -pose0*(t143*t273 + t250) - pose1*t275 - rays0*t293 - rays1*t294 + 2*t128*t237*t47*t5 + 2*t128*t237*t49*t8 - t237*t282,
        t288,
        t263,
        t270,
        t271,
        -t301,
        t242*t256 + t274,
        t287,
        t190,
        t296,
        t220,
        t300,
        -t251,
        t161*t285 + t162*t284 + t286*t49,
        t189,
        t269,
        -t219,
        t161*t299 + t234,
        t249,
        t37*(-pose1*t303 + pose2*t304),
        -t309*(pose1*t307 + pose2*t308),
        t37*(-pose0*t310 + pose2*t312),
        -pose0*(t280*t316 - t314*t68 + t315*t48) - pose2*t317,
        t37*(-pose0*t304 + pose1*t311),
        pose0*t318 + pose1*t317,
        t312*t37,
        -t317,
        -t304*t37,
        t318,
        t310*t37,
        -t307*t309,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    abscissa, = abscissa
    t0 = landmark3*landmark3 + landmark4*landmark4 + landmark5*landmark5
    t1 = abscissa*sqrt(t0)
    return (
        -landmark1*landmark5 + landmark2*landmark4 + landmark3*t1,
        landmark0*landmark5 - landmark2*landmark3 + landmark4*t1,
        -landmark0*landmark4 + landmark1*landmark3 + landmark5*t1,
        t0,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    abscissa, = abscissa
    t0 = landmark3*landmark3
    t1 = landmark4*landmark4
    t2 = landmark5*landmark5
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = landmark3*t4
    t6 = landmark4*t4
    t7 = landmark5*t4
    t8 = 1/(t4)
    t9 = abscissa*landmark3*t8
    t10 = landmark4*t9
    t11 = landmark5*t9
    t12 = abscissa*landmark4*landmark5*t8
    return (
        abscissa*t5 - landmark1*landmark5 + landmark2*landmark4,
        abscissa*t6 + landmark0*landmark5 - landmark2*landmark3,
        abscissa*t7 - landmark0*landmark4 + landmark1*landmark3,
        t3,
        0,
        -landmark5,
        landmark4,
        abscissa*(t0*t8 + t4),
        landmark2 + t10,
        -landmark1 + t11,
        landmark5,
        0,
        -landmark3,
        -landmark2 + t10,
        abscissa*(t1*t8 + t4),
        landmark0 + t12,
        -landmark4,
        landmark3,
        0,
        landmark1 + t11,
        -landmark0 + t12,
        abscissa*(t2*t8 + t4),
        0,
        0,
        0,
        2*landmark3,
        2*landmark4,
        2*landmark5,
        t5,
        t6,
        t7,
        0,
    )


def constrain(landmark, eye):
    """constrain: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    eye0, eye1, eye2 = eye
    t0 = -eye0*landmark4 + eye1*landmark3 + landmark2
    t1 = eye0*landmark5 - eye2*landmark3 + landmark1
    t2 = -eye1*landmark5 + eye2*landmark4 + landmark0
    t3 = (landmark3*t2 + landmark4*t1 + landmark5*t0)/(t0*t0 + t1*t1 + t2*t2)
    t4 = landmark5 - t0*t3
    t5 = landmark4 - t1*t3
    t6 = landmark3 - t2*t3
    return (
        eye1*t4 - eye2*t5 + t2,
        -eye0*t4 + eye2*t6 + t1,
        eye0*t5 - eye1*t6 + t0,
        t6,
        t5,
        t4,
    )


def constrain_jac(landmark, eye):
    """constrain: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    eye0, eye1, eye2 = eye
    t0 = eye1*landmark3
    t1 = eye0*landmark4
    t2 = landmark2 + t0 - t1
    t3 = t2*t2
    t4 = eye0*landmark5
    t5 = eye2*landmark3
    t6 = landmark1 + t4 - t5
    t7 = t6*t6
    t8 = -eye1*landmark5 + eye2*landmark4 + landmark0
    t9 = t8*t8
    t10 = t3 + t7 + t9
    t11 = 1/(t10)
    t12 = landmark4*t6
    t13 = landmark3*t8
    t14 = landmark5*t2
    t15 = t13 + t14
    t16 = t12 + t15
    t17 = t11*t16
    t18 = t17*t2
    t19 = landmark5 - t18
    t20 = t17*t6
    t21 = landmark4 - t20
    t22 = t17*t8
    t23 = landmark3 - t22
    t24 = eye2*t6
    t25 = 2*t22
    t26 = landmark3 - t25
    t27 = t11*t26
    t28 = eye1*t2
    t29 = -t6
    t30 = 2*t17
    t31 = landmark4 + t29*t30
    t32 = 2*t20
    t33 = 2*t12 + t15
    t34 = t29*t32 + t33
    t35 = -t2
    t36 = landmark5 + t30*t35
    t37 = 2*t18
    t38 = t12 + t13 + 2*t14
    t39 = t35*t37 + t38
    t40 = -eye2*t6 + t28
    t41 = -t40
    t42 = eye1*t16
    t43 = landmark0*t2 + t42
    t44 = t37*t41 + t43
    t45 = eye2*t16
    t46 = t11*t6
    t47 = eye0*t2
    t48 = eye2*t8
    t49 = t47 - t48
    t50 = t16/(t10*t10)
    t51 = 2*t50
    t52 = landmark1*t46 + t49*t51*t6 - 1
    t53 = eye0*t16
    t54 = landmark1*t2 + t37*t49 - t53
    t55 = t11*t2
    t56 = eye0*t6
    t57 = -eye1*t8 + t56
    t58 = -t57
    t59 = t2*t51
    t60 = landmark2*t6 + t53
    t61 = t32*t58 + t60
    t62 = -t8
    t63 = landmark3 + t30*t62
    t64 = t12 + 2*t13 + t14
    t65 = t25*t62 + t64
    t66 = landmark4 - t32
    t67 = t11*t66
    t68 = t11*t8
    t69 = t51*t8
    t70 = landmark1*t8 + t25*t49 + t45
    t71 = -landmark2*t11*t2 + t57*t59 + 1
    t72 = -landmark2*t8 + t25*t57 + t42
    t73 = landmark5 - t37
    t74 = t11*t73
    t75 = -landmark0*t11*t8 + t40*t69 + 1
    t76 = -landmark0*t6 + t32*t40 + t45
    t77 = -t66
    t78 = -t73
    t79 = -t26
    t80 = landmark4*t2 - landmark5*t6
    t81 = 2*t80
    t82 = landmark4 - t55*t81
    t83 = landmark5 + t46*t81
    t84 = landmark3*t2 - landmark5*t8
    t85 = landmark3 - 2*t55*t84
    t86 = 2*t84
    t87 = t11*t86
    t88 = landmark3*t6 - landmark4*t8
    t89 = 2*t88
    t90 = landmark3 - t46*t89
    t91 = landmark5 + t68*t86
    t92 = landmark4 + t68*t89
    return (
        eye1*t19 - eye2*t21 + t8,
        -eye0*t19 + eye2*t23 + t6,
        eye0*t21 - eye1*t23 + t2,
        t23,
        t21,
        t19,
        t24*t27 - t27*t28 + 1,
        t11*(eye2*t34 - t28*t31),
        t11*(-eye1*t39 + eye2*t36*t6),
        t11*(-eye1*t44 + eye2*(landmark0*t6 + t32*t41 - t45)),
        -eye1*t11*t54 + eye2*t52 + eye2,
        -eye1*(landmark2*t55 + t58*t59 - 1) - eye1 + eye2*t11*t61,
        t11*(-eye2*t65 + t47*t63),
        t47*t67 - t48*t67 + 1,
        t11*(eye0*t39 - t36*t48),
        eye0*t11*t44 - eye2*(landmark0*t68 + t41*t69 - 1) - eye2,
        t11*(eye0*t54 - eye2*t70),
        -eye0*t71 + eye0 + eye2*t11*t72,
        t11*(eye1*t65 - t56*t63),
        t11*(-eye0*t34 + eye1*t31*t8),
        eye1*t74*t8 - t56*t74 + 1,
        eye0*t11*t76 - eye1*t75 + eye1,
        -eye0*t52 - eye0 + eye1*t11*t70,
        t11*(-eye0*t61 + eye1*(landmark2*t8 + t25*t58 - t42)),
        t11*(2*t11*t16*t9 - t64),
        t68*t77,
        t68*t78,
        t75,
        -t11*t70,
        t11*t72,
        t46*t79,
        t11*(2*t11*t16*t7 - t33),
        t46*t78,
        t11*t76,
        -t52,
        t11*(2*t11*t16*t57*t6 - t60),
        t55*t79,
        t55*t77,
        t11*(2*t11*t16*t3 - t38),
        t11*(2*t11*t16*t2*t40 - t43),
        -t11*t54,
        t71,
        t17*(eye1*t82 + eye2*t83),
        -t17*(eye1*t85 + t2 + t24*t87),
        t17*(-eye2*t90 + landmark1 - t11*t28*t89 + t4 - t5),
        t17*(-eye0*t82 + landmark2 + t0 - t1 - t11*t48*t81),
        t17*(eye0*t85 + eye2*t91),
        t17*(2*eye0*t11*t2*t88 - eye2*t92 - t8),
        t17*(-eye0*t83 + 2*eye1*t11*t8*t80 - t6),
        t17*(-eye1*t91 + t56*t87 + t8),
        t17*(eye0*t90 + eye1*t92),
        -t50*t8*t81,
        t17*t91,
        -t17*t92,
        -t17*t83,
        t50*t6*t86,
        t17*t90,
        t17*t82,
        t17*(-landmark3 + 2*t11*t2*t84),
        -t2*t50*t89,
    )
