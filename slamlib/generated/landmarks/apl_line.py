"""Generated from slamlib/landmarks/apl_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "to_frame": "c76708fa8cf96e27",
    "from_frame": "0320859a86505da6",
    "point_at": "b0d09f33d1ee7242",
    "constrain": "c8e9e66eb698a58e",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (9,),
    "point_at": (4,),
    "constrain": (9,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark2 - pose2
    t4 = landmark0 - pose0
    t5 = landmark4 + landmark6*t3 - landmark8*t4
    t6 = 2*t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 - t8
    t10 = landmark1 - pose1
    t11 = landmark5 - landmark6*t10 + landmark7*t4
    t12 = 2*t11
    t13 = landmark3 - landmark7*t3 + landmark8*t10
    t14 = pose4*pose4
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose6*pose6
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t0 - t1
    t25 = 2*t13
    t26 = -t14
    t27 = t15 + t19 + t26
    t28 = t7 + t8
    t29 = t21 - t22
    t30 = t16 + t17 + t18 + t26
    t31 = 2*landmark7
    t32 = 2*landmark8
    t33 = 2*landmark6
    return (
        -t12*t9 + t13*t20 + t2*t6,
        t12*t23 - t24*t25 + t27*t5,
        t11*t30 + t25*t28 - t29*t6,
        landmark6*t20 + t2*t31 - t32*t9,
        landmark7*t27 + t23*t32 - t24*t33,
        landmark8*t30 + t28*t33 - t29*t31,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark2 - pose2
    t4 = landmark0 - pose0
    t5 = landmark4 + landmark6*t3 - landmark8*t4
    t6 = 2*t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 - t8
    t10 = landmark1 - pose1
    t11 = landmark5 - landmark6*t10 + landmark7*t4
    t12 = 2*t11
    t13 = landmark3 - landmark7*t3 + landmark8*t10
    t14 = pose4*pose4
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose6*pose6
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t0 - t1
    t25 = 2*t13
    t26 = -t14
    t27 = t15 + t19 + t26
    t28 = t7 + t8
    t29 = t21 - t22
    t30 = t16 + t17 + t18 + t26
    t31 = 2*landmark7
    t32 = 2*landmark8
    t33 = 2*landmark6
    t34 = 2*landmark7*t9 + 2*landmark8*t2
    t35 = landmark8*t20 + t33*t9
    t36 = -landmark7*t20 + t2*t33
    t37 = pose4*t13 + pose5*t5 + pose6*t11
    t38 = pose3*t13 - pose5*t11 + pose6*t5
    t39 = pose3*t5 + pose4*t11 - pose6*t13
    t40 = pose3*t11 - pose4*t5 + pose5*t13
    t41 = pose3*t37 - pose4*t38 - pose5*t39 - pose6*t40
    t42 = pose3*t40 - pose4*t39 + pose5*t38 + pose6*t37
    t43 = pose3*t39 + pose4*t40 + pose5*t37 - pose6*t38
    t44 = -landmark8*t27 + t23*t31
    t45 = 2*landmark6*t23 + 2*landmark8*t24
    t46 = landmark6*t27 + t24*t31
    t47 = pose3*t38 + pose4*t37 - pose5*t40 + pose6*t39
    t48 = landmark7*t30 + t29*t32
    t49 = landmark6*t30 - t28*t32
    t50 = 2*landmark6*t29 + 2*landmark7*t28
    t51 = landmark6*pose4 + landmark7*pose5 + landmark8*pose6
    t52 = landmark6*pose3 + landmark7*pose6 - landmark8*pose5
    t53 = -landmark6*pose6 + landmark7*pose3 + landmark8*pose4
    t54 = landmark6*pose5 - landmark7*pose4 + landmark8*pose3
    t55 = pose3*t51 - pose4*t52 - pose5*t53 - pose6*t54
    t56 = pose3*t54 - pose4*t53 + pose5*t52 + pose6*t51
    t57 = pose3*t53 + pose4*t54 + pose5*t51 - pose6*t52
    t58 = pose3*t52 + pose4*t51 - pose5*t54 + pose6*t53
    t59 = 2*t2
    t60 = -2*t9
    t61 = 2*t4
    t62 = -2*t24
    t63 = 2*t23
    t64 = 2*t10
    t65 = 2*t28
    t66 = -2*t29
    t67 = 2*t3
    return (
        -t12*t9 + t13*t20 + t2*t6,
        t12*t23 - t24*t25 + t27*t5,
        t11*t30 + t25*t28 - t29*t6,
        landmark6*t20 + t2*t31 - t32*t9,
        landmark7*t27 + t23*t32 - t24*t33,
        landmark8*t30 + t28*t33 - t29*t31,
        t34,
        -t35,
        -t36,
        t41,
        -t42,
        t43,
        -t44,
        t45,
        -t46,
        t42,
        t41,
        -t47,
        -t48,
        t49,
        t50,
        -t43,
        t47,
        t41,
        0,
        0,
        0,
        t55,
        -t56,
        t57,
        0,
        0,
        0,
        t56,
        t55,
        -t58,
        0,
        0,
        0,
        -t57,
        t58,
        t55,
        -t34,
        t35,
        t36,
        t20,
        t59,
        t60,
        2*t10*t9 + 2*t2*t3,
        -t20*t3 - t61*t9,
        t10*t20 - t2*t61,
        t44,
        -t45,
        t46,
        t62,
        t27,
        t63,
        -t23*t64 + t27*t3,
        2*t23*t4 + 2*t24*t3,
        -t24*t64 - t27*t4,
        t48,
        -t49,
        -t50,
        t65,
        t66,
        t30,
        -t10*t30 - t29*t67,
        -t28*t67 + t30*t4,
        2*t10*t28 + 2*t29*t4,
        0,
        0,
        0,
        0,
        0,
        0,
        t20,
        t59,
        t60,
        0,
        0,
        0,
        0,
        0,
        0,
        t62,
        t27,
        t63,
        0,
        0,
        0,
        0,
        0,
        0,
        t65,
        t66,
        t30,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark2 - pose2
    t4 = landmark0 - pose0
    t5 = landmark4 + landmark6*t3 - landmark8*t4
    t6 = 2*t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 - t8
    t10 = landmark1 - pose1
    t11 = landmark5 - landmark6*t10 + landmark7*t4
    t12 = 2*t11
    t13 = landmark3 - landmark7*t3 + landmark8*t10
    t14 = pose4*pose4
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose6*pose6
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t0 - t1
    t25 = 2*t13
    t26 = -t14
    t27 = t15 + t19 + t26
    t28 = t7 + t8
    t29 = t21 - t22
    t30 = t16 + t17 + t18 + t26
    t31 = 2*landmark7
    t32 = 2*landmark8
    t33 = 2*landmark6
    t34 = 2*landmark7*t9 + 2*landmark8*t2
    t35 = landmark8*t20 + t33*t9
    t36 = -landmark7*t20 + t2*t33
    t37 = pose3*t13 - pose5*t11 + pose6*t5
    t38 = 2*t37
    t39 = 2*pose4*t13 + 2*pose5*t5 + 2*pose6*t11
    t40 = pose3*t11 - pose4*t5 + pose5*t13
    t41 = pose3*t5 + pose4*t11 - pose6*t13
    t42 = 2*t41
    t43 = -landmark8*t27 + t23*t31
    t44 = 2*landmark6*t23 + 2*landmark8*t24
    t45 = landmark6*t27 + t24*t31
    t46 = 2*t40
    t47 = landmark7*t30 + t29*t32
    t48 = landmark6*t30 - t28*t32
    t49 = 2*landmark6*t29 + 2*landmark7*t28
    t50 = landmark6*pose3 + landmark7*pose6 - landmark8*pose5
    t51 = 2*t50
    t52 = 2*(landmark6*pose4 + landmark7*pose5 + landmark8*pose6)
    t53 = landmark6*pose5 - landmark7*pose4 + landmark8*pose3
    t54 = -landmark6*pose6 + landmark7*pose3 + landmark8*pose4
    t55 = 2*t54
    t56 = 2*t53
    t57 = 2*t2
    t58 = -2*t9
    t59 = 2*t4
    t60 = -2*t24
    t61 = 2*t23
    t62 = 2*t10
    t63 = 2*t28
    t64 = -2*t29
    t65 = 2*t3
    return (
        -t12*t9 + t13*t20 + t2*t6,
        t12*t23 - t24*t25 + t27*t5,
        t11*t30 + t25*t28 - t29*t6,
        landmark6*t20 + t2*t31 - t32*t9,
        landmark7*t27 + t23*t32 - t24*t33,
        landmark8*t30 + t28*t33 - t29*t31,
        t34,
        -t35,
        -t36,
        t38,
        t39,
        -2*t40,
        t42,
        -t43,
        t44,
        -t45,
        t42,
        t46,
        t39,
        -2*t37,
        -t47,
        t48,
        t49,
        t46,
        -2*t41,
        t38,
        t39,
        0,
        0,
        0,
        t51,
        t52,
        -2*t53,
        t55,
        0,
        0,
        0,
        t55,
        t56,
        t52,
        -2*t50,
        0,
        0,
        0,
        t56,
        -2*t54,
        t51,
        t52,
        -t34,
        t35,
        t36,
        t20,
        t57,
        t58,
        2*t10*t9 + 2*t2*t3,
        -t20*t3 - t59*t9,
        t10*t20 - t2*t59,
        t43,
        -t44,
        t45,
        t60,
        t27,
        t61,
        -t23*t62 + t27*t3,
        2*t23*t4 + 2*t24*t3,
        -t24*t62 - t27*t4,
        t47,
        -t48,
        -t49,
        t63,
        t64,
        t30,
        -t10*t30 - t29*t65,
        -t28*t65 + t30*t4,
        2*t10*t28 + 2*t29*t4,
        0,
        0,
        0,
        0,
        0,
        0,
        t20,
        t57,
        t58,
        0,
        0,
        0,
        0,
        0,
        0,
        t60,
        t27,
        t61,
        0,
        0,
        0,
        0,
        0,
        0,
        t63,
        t64,
        t30,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays5 - rays2*rays3
    t1 = rays0*rays4 - rays1*rays3
    t2 = rays1*rays5 - rays2*rays4
    t3 = t1*t1 + t2*t2
    t4 = 1/(sqrt(t0*t0 + t3))
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 + t6
    t8 = 2*t1
    t9 = pose3*pose6
    t10 = pose4*pose5
    t11 = -t10 + t9
    t12 = 2*t0
    t13 = pose4*pose4
    t14 = pose5*pose5
    t15 = -t14
    t16 = pose3*pose3
    t17 = pose6*pose6
    t18 = t16 - t17
    t19 = t13 + t15 + t18
    t20 = t10 + t9
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 - t22
    t24 = -t13
    t25 = t14 + t18 + t24
    t26 = t21 + t22
    t27 = t5 - t6
    t28 = t15 + t16 + t17 + t24
    t29 = rays0 - rays3
    t30 = rays1 - rays4
    t31 = rays2 - rays5
    t32 = 1/(sqrt(t29*t29 + t30*t30 + t31*t31))
    t33 = prior0*t30 - prior1*t4*(-t1*t29 + t2*t31)
    t34 = prior0*t32
    t35 = -t29
    t36 = -t0
    t37 = -t30
    t38 = -t31
    t39 = prior1/(sqrt(t3 + t36*t36)*sqrt(t35*t35 + t37*t37 + t38*t38))
    t40 = t31*t34 + t39*(-t2*t37 + t35*t36)
    t41 = t29*t34 + t39*(t1*t37 - t36*t38)
    t42 = t32*t33
    return (
        pose0,
        pose1,
        pose2,
        t4*(t11*t12 + t19*t2 + t7*t8),
        t4*(-t0*t25 + 2*t2*t20 - t23*t8),
        t4*(t1*t28 - t12*t26 - 2*t2*t27),
        2*t11*t32*t33 - t19*t41 - 2*t40*t7,
        -2*t20*t41 + 2*t23*t40 - t25*t42,
        -2*t26*t42 + 2*t27*t41 - t28*t40,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays5
    t1 = rays2*rays3
    t2 = t0 - t1
    t3 = rays0*rays4
    t4 = rays1*rays3
    t5 = t3 - t4
    t6 = rays1*rays5
    t7 = rays2*rays4
    t8 = t6 - t7
    t9 = t5*t5 + t8*t8
    t10 = t2*t2 + t9
    t11 = 1/(sqrt(t10))
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 + t13
    t15 = 2*t5
    t16 = t14*t15
    t17 = pose3*pose6
    t18 = pose4*pose5
    t19 = t17 - t18
    t20 = 2*t2
    t21 = t19*t20
    t22 = pose4*pose4
    t23 = pose5*pose5
    t24 = -t23
    t25 = pose3*pose3
    t26 = pose6*pose6
    t27 = t25 - t26
    t28 = t22 + t24 + t27
    t29 = t28*t8
    t30 = t17 + t18
    t31 = pose3*pose4
    t32 = pose5*pose6
    t33 = t31 - t32
    t34 = t15*t33
    t35 = -t22
    t36 = t23 + t27 + t35
    t37 = t2*t36
    t38 = t31 + t32
    t39 = t20*t38
    t40 = t12 - t13
    t41 = 2*t8
    t42 = t40*t41
    t43 = t24 + t25 + t26 + t35
    t44 = rays0 - rays3
    t45 = t44*t44
    t46 = rays1 - rays4
    t47 = t46*t46
    t48 = rays2 - rays5
    t49 = t48*t48
    t50 = t45 + t47 + t49
    t51 = 1/(sqrt(t50))
    t52 = prior0*t46
    t53 = t44*t5
    t54 = -t48*t8 + t53
    t55 = -t54
    t56 = prior1*t11
    t57 = t52 - t55*t56
    t58 = prior0*t51
    t59 = -t44
    t60 = -t2
    t61 = t59*t60
    t62 = -t46
    t63 = t62*t8
    t64 = t61 - t63
    t65 = -t48
    t66 = t59*t59 + t62*t62 + t65*t65
    t67 = 1/(sqrt(t66))
    t68 = t60*t60 + t9
    t69 = 1/(sqrt(t68))
    t70 = prior1*t69
    t71 = t67*t70
    t72 = t48*t58 + t64*t71
    t73 = t5*t62
    t74 = t60*t65
    t75 = t73 - t74
    t76 = t44*t58 + t71*t75
    t77 = t51*t57
    t78 = 2*t38
    t79 = pose4*t8 - pose5*t2 + pose6*t5
    t80 = pose3*t79
    t81 = pose3*t8 + pose5*t5
    t82 = pose6*t2 + t81
    t83 = pose4*t82
    t84 = pose4*t5
    t85 = pose3*t2 - pose6*t8 + t84
    t86 = -t85
    t87 = pose5*t8
    t88 = pose3*t5
    t89 = pose4*t2 + t87 - t88
    t90 = pose6*t89
    t91 = pose5*t11
    t92 = t82*t91
    t93 = t69*(pose3*t60 + pose6*t8 - t84)
    t94 = pose6*t11
    t95 = t79*t94
    t96 = -t89
    t97 = t11*t96
    t98 = pose4*t97
    t99 = t79*t91
    t100 = t69*(pose4*t60 - t87 + t88)
    t101 = pose4*t11
    t102 = pose5*t85
    t103 = t80 + t83
    t104 = t101*t79
    t105 = t86*t94
    t106 = t69*(-pose6*t60 + t81)
    t107 = pose4*t76 + pose6*t72
    t108 = pose3*(pose5*t77 + t107)
    t109 = pose3*t76 + pose5*t72
    t110 = pose4*(pose6*t51*t57 - t109)
    t111 = -t57
    t112 = t111*t51
    t113 = pose6*t76
    t114 = pose3*t112 + pose4*t72 - t113
    t115 = pose3*t72
    t116 = pose6*(-pose4*t77 + pose5*t76 - t115)
    t117 = t5*t59
    t118 = t65*t8
    t119 = prior0*t62 + t70*(t117 - t118)
    t120 = prior0*t59 - t70*t75
    t121 = prior0*t65 - t64*t70
    t122 = t67*(pose3*t119 - pose4*t121 + pose6*t120)
    t123 = pose6*t112 + t109
    t124 = pose4*t112 + pose5*t76 - t115
    t125 = pose5*t111*t51 - t107
    t126 = -pose6*t125
    t127 = pose4*t124
    t128 = pose5*t125
    t129 = t67*(pose3*t121 + pose4*t119 - pose5*t120)
    t130 = pose5*(-pose3*t77 + pose4*t72 - t113)
    t131 = pose6*t114
    t132 = t67*(pose3*t120 + pose5*t121 - pose6*t119)
    t133 = 1/(t10)
    t134 = rays4*t5
    t135 = -rays5*t60 + t134
    t136 = t133*t135
    t137 = t133*t29
    t138 = 2*t14
    t139 = rays3*t5 - rays5*t8
    t140 = t133*t139
    t141 = 2*t19
    t142 = rays4*t8
    t143 = rays3*t60 - t142
    t144 = t133*t143
    t145 = rays1*t5
    t146 = rays2*t2 + t145
    t147 = t133*t146
    t148 = rays0*t5 - rays2*t8
    t149 = t133*t148
    t150 = rays1*t8
    t151 = rays0*t2 + t150
    t152 = t133*t151
    t153 = 2*t33
    t154 = t30*t41
    t155 = 2*t30
    t156 = t133*t37
    t157 = rays3*t2 + t142
    t158 = t133*t157
    t159 = 2*rays5
    t160 = rays5*t2 + t134
    t161 = t133*t160
    t162 = t133*t43*t5
    t163 = 2*t40
    t164 = 1/(t50)
    t165 = t164*t44
    t166 = prior0*t165*t48
    t167 = t164*t45
    t168 = t46*t8
    t169 = t2*t44
    t170 = -t0 + t1
    t171 = t166 + t56*(-rays5*t44 + t161*t168 + t161*t169 + t165*t168 + t167*t2 + t170)
    t172 = t165*t52
    t173 = t48*t8
    t174 = t172 - t56*(rays4*t44 + t136*t173 - t136*t53 + t165*t173 - t167*t5 + t5)
    t175 = t141*t51
    t176 = 1/(t50*sqrt(t50))
    t177 = prior0*t176
    t178 = rays4*t62
    t179 = rays5*t65
    t180 = 1/(t66)
    t181 = t180*t59
    t182 = t181*t73
    t183 = t181*t74
    t184 = 1/(t68)
    t185 = -t135*t184
    t186 = -t177*t45 + t58 + t71*(t178 + t179 + t182 - t183 + t185*t73 - t185*t74)
    t187 = t164*t48
    t188 = t187*t52
    t189 = t164*t47
    t190 = t164*t46
    t191 = t188 - t56*(rays5*t46 + t140*t168 + t140*t169 - t169*t190 - t189*t8 + t8)
    t192 = t138*t51
    t193 = t2*t48
    t194 = t46*t5
    t195 = -t3 + t4
    t196 = t172 - t56*(rays3*t46 - t140*t193 - t140*t194 + t189*t5 + t190*t193 + t195)
    t197 = t28*t51
    t198 = rays3*t59
    t199 = t180*t63
    t200 = t199*t65
    t201 = t139*t184
    t202 = -t177*t47 + t58 + t71*(-t117*t201 + t118*t201 + t179 - t182 + t198 + t200)
    t203 = t164*t49
    t204 = -t6 + t7
    t205 = t188 - t56*(rays4*t48 + t144*t173 - t144*t53 - t187*t53 + t203*t8 + t204)
    t206 = t166 - t56*(rays3*t48 + t144*t193 + t144*t194 + t170 + t187*t194 + t2*t203)
    t207 = -t143*t184
    t208 = -t177*t49 + t58 + t71*(t178 + t183 + t198 - t200 + t207*t61 - t207*t63)
    t209 = t177*t44*t48
    t210 = t180*t44
    t211 = t184*(-rays2*t60 + t145)
    t212 = t209 + t71*(rays2*t59 + t170 - t199*t44 + t210*t61 + t211*t61 - t211*t63)
    t213 = t176*t52
    t214 = t213*t44
    t215 = t214 + t71*(rays1*t59 - t117*t211 + t118*t210 + t118*t211 - t181*t53 + t195)
    t216 = rays1*t46
    t217 = rays2*t48
    t218 = t190*t53
    t219 = t169*t187
    t220 = -prior0*t167 + prior0 + t56*(t147*t193 + t147*t194 - t216 - t217 + t218 + t219)
    t221 = t213*t48
    t222 = t180*t46
    t223 = -t148*t184
    t224 = t221 + t71*(rays2*t62 - t199*t46 + t204 + t222*t61 + t223*t61 - t223*t63)
    t225 = -prior0
    t226 = rays0*t44
    t227 = t173*t190
    t228 = -prior0*t189 - t225 - t56*(t149*t173 - t149*t53 + t217 + t218 + t226 - t227)
    t229 = t214 + t71*(rays0*t62 + t222*t73 - t222*t74 + t223*t73 - t223*t74 + t5)
    t230 = -prior0*t203 - t225 - t56*(-t152*t168 - t152*t169 + t216 + t219 + t226 + t227)
    t231 = t184*(rays0*t60 - t150)
    t232 = t180*t48
    t233 = t221 + t71*(rays1*t65 - t117*t231 - t117*t232 + t118*t231 + t173*t180*t65 + t8)
    t234 = t209 + t71*(rays0*t65 + t2 + t231*t73 - t231*t74 + t232*t73 - t232*t74)
    t235 = t153*t51
    t236 = t155*t51
    t237 = t36*t51
    t238 = t51*t78
    t239 = t43*t51
    t240 = t163*t51
    t241 = t67*t69
    t242 = t11*t51
    t243 = t193 + t194
    t244 = t168 + t169
    return (
        pose0,
        pose1,
        pose2,
        t11*(t16 + t21 + t29),
        t11*(2*t30*t8 - t34 - t37),
        t11*(-t39 - t42 + t43*t5),
        -2*t14*t72 + 2*t19*t51*t57 - t28*t76,
        -2*t30*t76 + 2*t33*t72 - t36*t77,
        2*t40*t76 - t43*t72 - t77*t78,
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
        t11*(pose5*t86 + t80 - t83 - t90),
        pose3*t11*t96 - pose4*t93 - t92 - t95,
        -pose3*t93 - t82*t94 - t98 + t99,
        0,
        0,
        0,
        -pose3*t100 - t101*t86 - t92 + t95,
        t11*(pose6*t96 + t102 + t103),
        pose3*t11*t82 - pose5*t100 - t104 - t105,
        0,
        0,
        0,
        pose3*t11*t86 - pose6*t106 - t98 - t99,
        -pose3*t106 - pose5*t97 + t104 - t105,
        t11*(-t102 + t103 + t90),
        0,
        0,
        0,
        pose5*t114 - t108 - t110 + t116,
        pose3*t124 - pose4*t122 + pose5*t123 + t126,
        -pose3*t122 + pose6*t123 - t127 + t128,
        0,
        0,
        0,
        -pose3*t129 - pose4*t114 + pose5*t123 - t126,
        pose6*t124 - t108 + t110 - t130,
        -pose3*t123 - pose4*t125 - pose5*t129 - t131,
        0,
        0,
        0,
        pose3*t114 - pose6*t132 - t127 - t128,
        -pose3*t132 + pose4*t125 - pose5*t124 - t131,
        -pose4*t123 - t108 - t116 + t130,
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
        t11*(2*rays4*t14 + 2*rays5*t19 - t135*t137 - t136*t16 - t136*t21),
        t11*(-rays3*t138 + rays5*t28 + t137*t139 + t140*t16 + t140*t21),
        -t11*(rays3*t141 + rays4*t28 + t137*t143 + t144*t16 + t144*t21),
        t11*(-rays1*t138 - rays2*t141 + t137*t146 + t147*t16 + t147*t21),
        t11*(2*rays0*t14 - rays2*t28 - t137*t148 - t149*t16 - t149*t21),
        t11*(2*rays0*t19 + rays1*t28 - t137*t151 - t152*t16 - t152*t21),
        t11*(-rays4*t153 - rays5*t36 + t133*t135*t2*t36 + 2*t133*t135*t33*t5 - t136*t154),
        t11*(rays3*t153 + rays5*t155 - t139*t156 + t140*t154 - t140*t34),
        t11*(rays3*t36 - rays4*t155 + 2*t133*t157*t30*t8 - t156*t157 - t158*t34),
        t11*(rays1*t153 + rays2*t36 - t146*t156 + t147*t154 - t147*t34),
        t11*(-rays0*t153 - rays2*t155 + t133*t148*t2*t36 + 2*t133*t148*t33*t5 - t149*t154),
        t11*(-rays0*t36 + rays1*t155 + t151*t156 - t152*t154 + t152*t34),
        t11*(rays4*t43 - t159*t38 - t160*t162 + t161*t39 + t161*t42),
        t11*(-rays3*t43 + t133*t139*t43*t5 - t140*t39 - t140*t42 - t159*t40),
        t11*(rays3*t78 + rays4*t163 + t157*t162 - t158*t39 - t158*t42),
        t11*(-rays1*t43 + 2*rays2*t38 + t133*t146*t43*t5 - t147*t39 - t147*t42),
        t11*(rays0*t43 + rays2*t163 - t148*t162 + t149*t39 + t149*t42),
        t11*(-rays0*t78 - rays1*t163 + 2*t133*t151*t2*t38 + 2*t133*t151*t40*t8 - t151*t162),
        2*t14*t171*t51 - t174*t175 - t186*t28,
        t141*t202 + t191*t192 + t196*t197,
        -t138*t208 - t175*t205 + t206*t28*t51,
        -t138*t212 + t141*t215 + t197*t220,
        -t138*t224 - t175*t228 - t229*t28,
        t141*t233 + t192*t230 - t234*t28,
        -t155*t186 - t171*t235 + t174*t36*t51,
        -t191*t235 + 2*t196*t30*t51 - t202*t36,
        t153*t208 + t205*t237 + t206*t236,
        t153*t212 - t215*t36 + t220*t236,
        t153*t224 - t155*t229 + t228*t237,
        -t155*t234 - t230*t235 - t233*t36,
        t163*t186 + t171*t239 + t174*t238,
        t191*t43*t51 - t196*t240 - t202*t78,
        2*t205*t38*t51 - t206*t240 - t208*t43,
        -t212*t43 - t215*t78 - t220*t240,
        t163*t229 - t224*t43 + t228*t238,
        t163*t234 + t230*t239 - t233*t78,
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
        t51*(-t138*t48 + 2*t19*t46 - t28*t44),
        -t138*t241*t64 - t141*t242*t55 - t241*t28*t75,
        t51*(-t155*t44 + 2*t33*t48 - t36*t46),
        t242*(t153*t244 + t155*t243 - t36*t54),
        t51*(2*t40*t44 - t43*t48 - t46*t78),
        -t242*(t163*t243 + t244*t43 + t54*t78),
    )


def from_frame_storage_jac(pose, rays, prior):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays5
    t1 = rays2*rays3
    t2 = t0 - t1
    t3 = rays0*rays4
    t4 = rays1*rays3
    t5 = t3 - t4
    t6 = rays1*rays5
    t7 = rays2*rays4
    t8 = t6 - t7
    t9 = t5*t5 + t8*t8
    t10 = t2*t2 + t9
    t11 = 1/(sqrt(t10))
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 + t13
    t15 = 2*t5
    t16 = t14*t15
    t17 = pose3*pose6
    t18 = pose4*pose5
    t19 = t17 - t18
    t20 = 2*t2
    t21 = t19*t20
    t22 = pose4*pose4
    t23 = pose5*pose5
    t24 = -t23
    t25 = pose3*pose3
    t26 = pose6*pose6
    t27 = t25 - t26
    t28 = t22 + t24 + t27
    t29 = t28*t8
    t30 = t17 + t18
    t31 = pose3*pose4
    t32 = pose5*pose6
    t33 = t31 - t32
    t34 = t15*t33
    t35 = -t22
    t36 = t23 + t27 + t35
    t37 = t2*t36
    t38 = t31 + t32
    t39 = t20*t38
    t40 = t12 - t13
    t41 = 2*t8
    t42 = t40*t41
    t43 = t24 + t25 + t26 + t35
    t44 = rays0 - rays3
    t45 = t44*t44
    t46 = rays1 - rays4
    t47 = t46*t46
    t48 = rays2 - rays5
    t49 = t48*t48
    t50 = t45 + t47 + t49
    t51 = 1/(sqrt(t50))
    t52 = prior0*t46
    t53 = t44*t5
    t54 = -t48*t8 + t53
    t55 = -t54
    t56 = prior1*t11
    t57 = t52 - t55*t56
    t58 = prior0*t51
    t59 = -t44
    t60 = -t2
    t61 = t59*t60
    t62 = -t46
    t63 = t62*t8
    t64 = t61 - t63
    t65 = -t48
    t66 = t59*t59 + t62*t62 + t65*t65
    t67 = t60*t60 + t9
    t68 = 1/(sqrt(t66)*sqrt(t67))
    t69 = prior1*t68
    t70 = t48*t58 + t64*t69
    t71 = t5*t62
    t72 = t60*t65
    t73 = t71 - t72
    t74 = t44*t58 + t69*t73
    t75 = t51*t57
    t76 = 2*t38
    t77 = 2*t11
    t78 = t77*(pose3*t8 + pose5*t5 + pose6*t2)
    t79 = t77*(pose4*t8 - pose5*t2 + pose6*t5)
    t80 = -pose3*t5 + pose4*t2 + pose5*t8
    t81 = -t77*t80
    t82 = pose3*t2 + pose4*t5 - pose6*t8
    t83 = -t77*t82
    t84 = pose3*t74 + pose5*t70
    t85 = 2*pose6*t51*t57 - 2*t84
    t86 = -2*pose4*t74 - 2*pose5*t75 - 2*pose6*t70
    t87 = pose3*t70
    t88 = pose5*t74
    t89 = -2*pose4*t75 - 2*t87 + 2*t88
    t90 = -t51*t57
    t91 = pose4*t70
    t92 = pose6*t74
    t93 = -2*pose3*t75 + 2*t91 - 2*t92
    t94 = 1/(t10)
    t95 = rays4*t5
    t96 = -rays5*t60 + t95
    t97 = t94*t96
    t98 = t29*t94
    t99 = 2*t14
    t100 = rays3*t5 - rays5*t8
    t101 = t100*t94
    t102 = 2*t19
    t103 = rays4*t8
    t104 = rays3*t60 - t103
    t105 = t104*t94
    t106 = rays1*t5
    t107 = rays2*t2 + t106
    t108 = t107*t94
    t109 = rays0*t5 - rays2*t8
    t110 = t109*t94
    t111 = rays1*t8
    t112 = rays0*t2 + t111
    t113 = t112*t94
    t114 = 2*t33
    t115 = t30*t41
    t116 = 2*t30
    t117 = t37*t94
    t118 = rays3*t2 + t103
    t119 = t118*t94
    t120 = 2*rays5
    t121 = rays5*t2 + t95
    t122 = t121*t94
    t123 = t43*t5*t94
    t124 = 2*t40
    t125 = 1/(t50)
    t126 = t125*t44
    t127 = prior0*t126*t48
    t128 = t125*t45
    t129 = t46*t8
    t130 = t2*t44
    t131 = -t0 + t1
    t132 = t127 + t56*(-rays5*t44 + t122*t129 + t122*t130 + t126*t129 + t128*t2 + t131)
    t133 = t126*t52
    t134 = t48*t8
    t135 = t133 - t56*(rays4*t44 + t126*t134 - t128*t5 + t134*t97 + t5 - t53*t97)
    t136 = t102*t51
    t137 = 1/(t50*sqrt(t50))
    t138 = prior0*t137
    t139 = rays4*t62
    t140 = rays5*t65
    t141 = 1/(t66)
    t142 = t141*t59
    t143 = t142*t71
    t144 = t142*t72
    t145 = 1/(t67)
    t146 = -t145*t96
    t147 = -t138*t45 + t58 + t69*(t139 + t140 + t143 - t144 + t146*t71 - t146*t72)
    t148 = t125*t48
    t149 = t148*t52
    t150 = t125*t47
    t151 = t125*t46
    t152 = t149 - t56*(rays5*t46 + t101*t129 + t101*t130 - t130*t151 - t150*t8 + t8)
    t153 = t51*t99
    t154 = t2*t48
    t155 = t46*t5
    t156 = -t3 + t4
    t157 = t133 - t56*(rays3*t46 - t101*t154 - t101*t155 + t150*t5 + t151*t154 + t156)
    t158 = t28*t51
    t159 = rays3*t59
    t160 = t141*t63
    t161 = t160*t65
    t162 = t100*t145
    t163 = t65*t8
    t164 = t5*t59
    t165 = -t138*t47 + t58 + t69*(t140 - t143 + t159 + t161 + t162*t163 - t162*t164)
    t166 = t125*t49
    t167 = -t6 + t7
    t168 = t149 - t56*(rays4*t48 + t105*t134 - t105*t53 - t148*t53 + t166*t8 + t167)
    t169 = t127 - t56*(rays3*t48 + t105*t154 + t105*t155 + t131 + t148*t155 + t166*t2)
    t170 = -t104*t145
    t171 = -t138*t49 + t58 + t69*(t139 + t144 + t159 - t161 + t170*t61 - t170*t63)
    t172 = t138*t44*t48
    t173 = t141*t44
    t174 = t145*(-rays2*t60 + t106)
    t175 = t172 + t69*(rays2*t59 + t131 - t160*t44 + t173*t61 + t174*t61 - t174*t63)
    t176 = t137*t52
    t177 = t176*t44
    t178 = t177 + t69*(rays1*t59 - t142*t53 + t156 + t163*t173 + t163*t174 - t164*t174)
    t179 = rays1*t46
    t180 = rays2*t48
    t181 = t151*t53
    t182 = t130*t148
    t183 = -prior0*t128 + prior0 + t56*(t108*t154 + t108*t155 - t179 - t180 + t181 + t182)
    t184 = t176*t48
    t185 = t141*t46
    t186 = -t109*t145
    t187 = t184 + t69*(rays2*t62 - t160*t46 + t167 + t185*t61 + t186*t61 - t186*t63)
    t188 = -prior0
    t189 = rays0*t44
    t190 = t134*t151
    t191 = -prior0*t150 - t188 - t56*(t110*t134 - t110*t53 + t180 + t181 + t189 - t190)
    t192 = t177 + t69*(rays0*t62 + t185*t71 - t185*t72 + t186*t71 - t186*t72 + t5)
    t193 = -prior0*t166 - t188 - t56*(-t113*t129 - t113*t130 + t179 + t182 + t189 + t190)
    t194 = t145*(rays0*t60 - t111)
    t195 = t184 + t69*(rays1*t65 + t134*t141*t65 - t142*t48*t5 + t163*t194 - t164*t194 + t8)
    t196 = t141*t48
    t197 = t172 + t69*(rays0*t65 + t194*t71 - t194*t72 + t196*t71 - t196*t72 + t2)
    t198 = t114*t51
    t199 = t116*t51
    t200 = t36*t51
    t201 = t51*t76
    t202 = t43*t51
    t203 = t124*t51
    t204 = t154 + t155
    t205 = t129 + t130
    t206 = t11*t51
    return (
        pose0,
        pose1,
        pose2,
        t11*(t16 + t21 + t29),
        t11*(2*t30*t8 - t34 - t37),
        t11*(-t39 - t42 + t43*t5),
        -2*t14*t70 + 2*t19*t51*t57 - t28*t74,
        -2*t30*t74 + 2*t33*t70 - t36*t75,
        2*t40*t74 - t43*t70 - t75*t76,
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
        t78,
        t79,
        t81,
        t77*t82,
        0,
        0,
        0,
        t83,
        t77*t80,
        t79,
        t78,
        0,
        0,
        0,
        t81,
        t83,
        -t78,
        t79,
        0,
        0,
        0,
        t85,
        t86,
        t89,
        -2*pose3*t90 - 2*t91 + 2*t92,
        0,
        0,
        0,
        t93,
        -2*pose4*t90 + 2*t87 - 2*t88,
        t86,
        t85,
        0,
        0,
        0,
        t89,
        t93,
        2*pose6*t90 + 2*t84,
        t86,
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
        t11*(2*rays4*t14 + 2*rays5*t19 - t16*t97 - t21*t97 - t96*t98),
        t11*(-rays3*t99 + rays5*t28 + t100*t98 + t101*t16 + t101*t21),
        -t11*(rays3*t102 + rays4*t28 + t104*t98 + t105*t16 + t105*t21),
        t11*(-rays1*t99 - rays2*t102 + t107*t98 + t108*t16 + t108*t21),
        t11*(2*rays0*t14 - rays2*t28 - t109*t98 - t110*t16 - t110*t21),
        t11*(2*rays0*t19 + rays1*t28 - t112*t98 - t113*t16 - t113*t21),
        t11*(-rays4*t114 - rays5*t36 - t115*t97 + t2*t36*t94*t96 + 2*t33*t5*t94*t96),
        t11*(rays3*t114 + rays5*t116 - t100*t117 + t101*t115 - t101*t34),
        t11*(rays3*t36 - rays4*t116 - t117*t118 + 2*t118*t30*t8*t94 - t119*t34),
        t11*(rays1*t114 + rays2*t36 - t107*t117 + t108*t115 - t108*t34),
        t11*(-rays0*t114 - rays2*t116 + t109*t2*t36*t94 + 2*t109*t33*t5*t94 - t110*t115),
        t11*(-rays0*t36 + rays1*t116 + t112*t117 - t113*t115 + t113*t34),
        t11*(rays4*t43 - t120*t38 - t121*t123 + t122*t39 + t122*t42),
        t11*(-rays3*t43 + t100*t43*t5*t94 - t101*t39 - t101*t42 - t120*t40),
        t11*(rays3*t76 + rays4*t124 + t118*t123 - t119*t39 - t119*t42),
        t11*(-rays1*t43 + 2*rays2*t38 + t107*t43*t5*t94 - t108*t39 - t108*t42),
        t11*(rays0*t43 + rays2*t124 - t109*t123 + t110*t39 + t110*t42),
        t11*(-rays0*t76 - rays1*t124 - t112*t123 + 2*t112*t2*t38*t94 + 2*t112*t40*t8*t94),
        2*t132*t14*t51 - t135*t136 - t147*t28,
        t102*t165 + t152*t153 + t157*t158,
        -t136*t168 + t169*t28*t51 - t171*t99,
        t102*t178 + t158*t183 - t175*t99,
        -t136*t191 - t187*t99 - t192*t28,
        t102*t195 + t153*t193 - t197*t28,
        -t116*t147 - t132*t198 + t135*t36*t51,
        -t152*t198 + 2*t157*t30*t51 - t165*t36,
        t114*t171 + t168*t200 + t169*t199,
        t114*t175 - t178*t36 + t183*t199,
        t114*t187 - t116*t192 + t191*t200,
        -t116*t197 - t193*t198 - t195*t36,
        t124*t147 + t132*t202 + t135*t201,
        t152*t43*t51 - t157*t203 - t165*t76,
        2*t168*t38*t51 - t169*t203 - t171*t43,
        -t175*t43 - t178*t76 - t183*t203,
        t124*t192 - t187*t43 + t191*t201,
        t124*t197 + t193*t202 - t195*t76,
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
        t51*(2*t19*t46 - t28*t44 - t48*t99),
        -t19*t51*t55*t77 - t28*t68*t73 - t64*t68*t99,
        t51*(-t116*t44 + 2*t33*t48 - t36*t46),
        t206*(t114*t205 + t116*t204 - t36*t54),
        t51*(2*t40*t44 - t43*t48 - t46*t76),
        -t206*(t124*t204 + t205*t43 + t54*t76),
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark0*landmark7 - landmark1*landmark6 + landmark5
    t1 = -landmark0*landmark8 + landmark2*landmark6 + landmark4
    t2 = landmark6*landmark6 + landmark7*landmark7 + landmark8*landmark8
    t3 = abscissa*sqrt(t2)
    t4 = landmark1*landmark8 - landmark2*landmark7 + landmark3
    return (
        landmark6*t3 + landmark7*t0 - landmark8*t1,
        -landmark6*t0 + landmark7*t3 + landmark8*t4,
        landmark6*t1 - landmark7*t4 + landmark8*t3,
        t2,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark0*landmark7
    t1 = landmark1*landmark6
    t2 = landmark5 - t1
    t3 = t0 + t2
    t4 = landmark2*landmark6
    t5 = landmark0*landmark8
    t6 = landmark4 - t5
    t7 = t4 + t6
    t8 = landmark6*landmark6
    t9 = landmark7*landmark7
    t10 = landmark8*landmark8
    t11 = t10 + t9
    t12 = t11 + t8
    t13 = sqrt(t12)
    t14 = abscissa*t13
    t15 = landmark1*landmark8
    t16 = landmark2*landmark7
    t17 = landmark3 - t16
    t18 = t15 + t17
    t19 = landmark6*landmark7
    t20 = -t19
    t21 = landmark6*landmark8
    t22 = -t21
    t23 = -landmark1*landmark7
    t24 = abscissa/t13
    t25 = -landmark2*landmark8 + t14
    t26 = t19*t24
    t27 = t21*t24
    t28 = landmark7*landmark8
    t29 = -t28
    t30 = -landmark0*landmark6
    t31 = t24*t28
    return (
        landmark6*t14 + landmark7*t3 - landmark8*t7,
        -landmark6*t3 + landmark7*t14 + landmark8*t18,
        landmark6*t7 - landmark7*t18 + landmark8*t14,
        t12,
        t11,
        t20,
        t22,
        0,
        -landmark8,
        landmark7,
        t23 + t24*t8 + t25,
        2*t0 + t2 + t26,
        -landmark4 + t27 - t4 + 2*t5,
        t20,
        t10 + t8,
        t29,
        landmark8,
        0,
        -landmark6,
        -landmark5 - t0 + 2*t1 + t26,
        t24*t9 + t25 + t30,
        2*t15 + t17 + t31,
        t22,
        t29,
        t8 + t9,
        -landmark7,
        landmark6,
        0,
        t27 + 2*t4 + t6,
        -landmark3 - t15 + 2*t16 + t31,
        t10*t24 + t14 + t23 + t30,
        0,
        0,
        0,
        0,
        0,
        0,
        2*landmark6,
        2*landmark7,
        2*landmark8,
        landmark6*t13,
        landmark7*t13,
        landmark8*t13,
        0,
    )


def constrain(landmark, eye):
    """constrain: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    eye0, eye1, eye2 = eye
    t0 = eye1 - landmark1
    t1 = eye0 - landmark0
    t2 = landmark5 + landmark6*t0 - landmark7*t1
    t3 = eye2 - landmark2
    t4 = landmark3 + landmark7*t3 - landmark8*t0
    t5 = landmark4 - landmark6*t3 + landmark8*t1
    t6 = (landmark6*t4 + landmark7*t5 + landmark8*t2)/(t2*t2 + t4*t4 + t5*t5)
    t7 = landmark8 - t2*t6
    t8 = landmark7 - t5*t6
    t9 = landmark6 - t4*t6
    return (
        landmark0,
        landmark1,
        landmark2,
        t0*t7 - t3*t8 + t4,
        -t1*t7 + t3*t9 + t5,
        -t0*t9 + t1*t8 + t2,
        t9,
        t8,
        t7,
    )


def constrain_jac(landmark, eye):
    """constrain: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    eye0, eye1, eye2 = eye
    t0 = eye1 - landmark1
    t1 = eye0 - landmark0
    t2 = landmark7*t1
    t3 = landmark6*t0
    t4 = landmark5 + t3
    t5 = -t2 + t4
    t6 = eye2 - landmark2
    t7 = landmark3 + landmark7*t6
    t8 = -landmark8*t0 + t7
    t9 = t8*t8
    t10 = landmark6*t6
    t11 = landmark8*t1
    t12 = landmark4 + t11
    t13 = -t10 + t12
    t14 = t13*t13
    t15 = t5*t5
    t16 = t14 + t15 + t9
    t17 = 1/(t16)
    t18 = landmark7*t13
    t19 = landmark6*t8
    t20 = landmark8*t5
    t21 = t19 + t20
    t22 = t18 + t21
    t23 = t17*t22
    t24 = t23*t5
    t25 = landmark8 - t24
    t26 = t13*t23
    t27 = landmark7 - t26
    t28 = t23*t8
    t29 = landmark6 - t28
    t30 = landmark7*t5 - landmark8*t13
    t31 = t17*t5
    t32 = 2*t31
    t33 = landmark7 - t30*t32
    t34 = t13*t17
    t35 = 2*t34
    t36 = landmark8 + t30*t35
    t37 = t36*t6
    t38 = landmark6*t5 - landmark8*t8
    t39 = landmark6 - t32*t38
    t40 = t13*t6
    t41 = 2*t17
    t42 = t38*t40*t41 + t5
    t43 = landmark6*t13 - landmark7*t8
    t44 = landmark6 - t35*t43
    t45 = t0*t5
    t46 = -landmark4 + t10 - t11 + t41*t43*t45
    t47 = 2*t28
    t48 = landmark6 - t47
    t49 = t17*t48
    t50 = -t13
    t51 = 2*t23
    t52 = landmark7 + t50*t51
    t53 = 2*t26
    t54 = 2*t18 + t21
    t55 = t50*t53 + t54
    t56 = -t5
    t57 = landmark8 + t51*t56
    t58 = 2*t24
    t59 = t18 + t19 + 2*t20
    t60 = t56*t58 + t59
    t61 = -t6
    t62 = landmark7*t61 + t7
    t63 = t0*t22
    t64 = t13*t61 + t45
    t65 = -t58*t64 + t63
    t66 = t5*t62 + t65
    t67 = t53*t64
    t68 = -t1
    t69 = t6*t8
    t70 = t5*t68 + t69
    t71 = (2*t22)/(t16*t16)
    t72 = t13*t71
    t73 = t70*t72 + 1
    t74 = -landmark4*t13*t17 + t73
    t75 = t1*t22
    t76 = t58*t70
    t77 = -landmark4*t5 + t75 + t76
    t78 = t0*t17
    t79 = -t0
    t80 = landmark6*t79 + t4
    t81 = t1*t13
    t82 = t79*t8 + t81
    t83 = t5*t71
    t84 = t82*t83 + 1
    t85 = -t53*t82 + t75
    t86 = t13*t80 + t85
    t87 = t17*t69
    t88 = 2*t30
    t89 = -landmark5 + t2 - t3 + t87*t88
    t90 = t17*t8
    t91 = 2*t90
    t92 = landmark8 + t38*t91
    t93 = t6*t92
    t94 = landmark7 + t43*t91
    t95 = -t1*t32*t43 + t6*t94 + t8
    t96 = -t8
    t97 = landmark6 + t51*t96
    t98 = t18 + 2*t19 + t20
    t99 = t47*t96 + t98
    t100 = landmark7 - t53
    t101 = t71*t8
    t102 = t101*t64 + 1
    t103 = landmark8*t68 + t12
    t104 = t22*t6
    t105 = t104 - t47*t70
    t106 = t103*t8 + t105
    t107 = -landmark5*t17*t5 + t84
    t108 = t47*t82
    t109 = -landmark5*t8 + t108 + t63
    t110 = t78*t8
    t111 = t1*t36 - t110*t88 + t13
    t112 = t17*t81
    t113 = -t0*t92 + 2*t112*t38 + t8
    t114 = t0*t94
    t115 = landmark8 - t58
    t116 = -landmark3*t17*t8 + t102
    t117 = -landmark3*t13 + t104 + t67
    t118 = t101*t30
    t119 = t23*t92
    t120 = t23*t94
    t121 = -t100
    t122 = -t115
    t123 = t23*t36
    t124 = t38*t72
    t125 = landmark6 - 2*t13*t17*t43
    t126 = -t48
    t127 = landmark7 - 2*t17*t30*t5
    t128 = t43*t83
    t129 = landmark6 - t32*t38
    return (
        landmark0,
        landmark1,
        landmark2,
        t0*t25 - t27*t6 + t8,
        -t1*t25 + t13 + t29*t6,
        -t0*t29 + t1*t27 + t5,
        t29,
        t27,
        t25,
        1,
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
        -t23*(t0*t33 + t37),
        t23*(t0*t39 + t42),
        t23*(t44*t6 + t46),
        t40*t49 - t45*t49 + 1,
        t17*(-t45*t52 + t55*t6),
        t17*(-t0*t60 + t13*t57*t6),
        t17*(-t0*t66 + t6*(t13*t62 + t22*t61 - t67)),
        -t6*t74 + t6 + t77*t78,
        -t0*(t17*t5*t80 - t84) - t0 + t17*t6*t86,
        t23*(t1*t33 + t89),
        -t23*(t1*t39 + t93),
        t23*t95,
        t17*(t1*t5*t97 - t6*t99),
        t1*t100*t31 - t100*t87 + 1,
        t17*(t1*t60 - t57*t69),
        t1*t17*t66 - t6*(-t102 + t17*t62*t8) - t6,
        t17*(t1*(t103*t5 + t22*t68 - t76) - t106*t6),
        -t1*t107 + t1 + t109*t17*t6,
        t111*t23,
        -t113*t23,
        -t23*(t1*t44 + t114),
        t17*(t0*t99 - t81*t97),
        t17*(t0*t52*t8 - t1*t55),
        t110*t115 - t112*t115 + 1,
        -t0*t116 + t0 + t1*t117*t17,
        t0*t106*t17 - t1*(t103*t13*t17 - t73) - t1,
        t17*(t0*(-t108 + t22*t79 + t8*t80) - t1*t86),
        t118,
        -t119,
        t120,
        t17*(2*t17*t22*t9 - t98),
        t121*t90,
        t122*t90,
        t116,
        t17*(-landmark4*t8 - t105),
        t109*t17,
        t123,
        -t124,
        -t125*t23,
        t126*t34,
        t17*(2*t14*t17*t22 - t54),
        t122*t34,
        t117*t17,
        t74,
        t17*(-landmark5*t13 - t85),
        -t127*t23,
        t23*t39,
        t128,
        t126*t31,
        t121*t31,
        t17*(2*t15*t17*t22 - t59),
        t17*(-landmark3*t5 - t65),
        t17*t77,
        t107,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t23*(t0*t127 + t37),
        -t23*(t0*t129 + t42),
        t23*(-t125*t6 - t46),
        t23*(-t1*t127 - t89),
        t23*(t1*t129 + t93),
        -t23*t95,
        -t111*t23,
        t113*t23,
        t23*(t1*t125 + t114),
        -t118,
        t119,
        -t120,
        -t123,
        t124,
        t125*t23,
        t127*t23,
        -t23*t39,
        -t128,
    )
