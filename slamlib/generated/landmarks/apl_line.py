"""Generated from slamlib/landmarks/apl_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "to_frame": "109049db99d277e4",
    "from_frame": "ebfe1d1ed3a939c9",
    "point_at": "b0d09f33d1ee7242",
    "constrain": "f4b1eb3ac8cd0c0f",
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
    t0 = landmark1 - pose1
    t1 = landmark0 - pose0
    t2 = landmark5 - landmark6*t0 + landmark7*t1
    t3 = t2 + t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = t4 - t5
    t7 = landmark2 - pose2
    t8 = landmark3 - landmark7*t7 + landmark8*t0
    t9 = pose4*pose4
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose6*pose6
    t14 = t12 - t13
    t15 = t9 + t11 + t14
    t16 = pose3*pose6
    t17 = pose4*pose5
    t18 = t16 + t17
    t19 = landmark4 + landmark6*t7 - landmark8*t1
    t20 = t19 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t16 - t17
    t25 = t8 + t8
    t26 = -t9
    t27 = t10 + t14 + t26
    t28 = t11 + t12 + t13 + t26
    t29 = t4 + t5
    t30 = t21 - t22
    t31 = landmark7 + landmark7
    t32 = landmark8 + landmark8
    t33 = landmark6 + landmark6
    return (
        -t3*t6 + t15*t8 + t18*t20,
        t23*t3 - t24*t25 + t19*t27,
        t2*t28 + t25*t29 - t20*t30,
        landmark6*t15 + t18*t31 - t32*t6,
        landmark7*t27 + t23*t32 - t24*t33,
        landmark8*t28 + t29*t33 - t30*t31,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = landmark1 - pose1
    t1 = landmark0 - pose0
    t2 = landmark5 - landmark6*t0 + landmark7*t1
    t3 = t2 + t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = t4 - t5
    t7 = landmark2 - pose2
    t8 = landmark3 - landmark7*t7 + landmark8*t0
    t9 = pose4*pose4
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose6*pose6
    t14 = t12 - t13
    t15 = t9 + t11 + t14
    t16 = pose3*pose6
    t17 = pose4*pose5
    t18 = t16 + t17
    t19 = landmark4 + landmark6*t7 - landmark8*t1
    t20 = t19 + t19
    t21 = -t3*t6 + t15*t8 + t18*t20
    t22 = pose3*pose4
    t23 = pose5*pose6
    t24 = t22 + t23
    t25 = t16 - t17
    t26 = t8 + t8
    t27 = -t9
    t28 = t10 + t14 + t27
    t29 = t24*t3 - t25*t26 + t19*t28
    t30 = t11 + t12 + t13 + t27
    t31 = t4 + t5
    t32 = t22 - t23
    t33 = t2*t30 + t26*t31 - t20*t32
    t34 = landmark7 + landmark7
    t35 = landmark8 + landmark8
    t36 = landmark6*t15 + t18*t34 - t35*t6
    t37 = landmark6 + landmark6
    t38 = landmark7*t28 + t24*t35 - t25*t37
    t39 = landmark8*t30 + t31*t37 - t32*t34
    t40 = t18*t35 + t34*t6
    t41 = landmark8*t15 + t37*t6
    t42 = -landmark7*t15 + t18*t37
    t43 = -landmark8*t28 + t24*t34
    t44 = t24*t37 + t25*t35
    t45 = landmark6*t28 + t25*t34
    t46 = landmark7*t30 + t32*t35
    t47 = landmark6*t30 - t31*t35
    t48 = t31*t34 + t32*t37
    t49 = t18 + t18
    t50 = t6 + t6
    t51 = -t50
    t52 = t25 + t25
    t53 = -t52
    t54 = t24 + t24
    t55 = t31 + t31
    t56 = t32 + t32
    t57 = -t56
    t58 = t7 + t7
    t59 = t0 + t0
    t60 = t1 + t1
    return (
        t21,
        t29,
        t33,
        t36,
        t38,
        t39,
        t40,
        -t41,
        -t42,
        0,
        -t33,
        t29,
        -t43,
        t44,
        -t45,
        t33,
        0,
        -t21,
        -t46,
        t47,
        t48,
        -t29,
        t21,
        0,
        0,
        0,
        0,
        0,
        -t39,
        t38,
        0,
        0,
        0,
        t39,
        0,
        -t36,
        0,
        0,
        0,
        -t38,
        t36,
        0,
        -t40,
        t41,
        t42,
        t15,
        t49,
        t51,
        t0*t50 + t49*t7,
        -t15*t7 - t1*t50,
        t0*t15 - t1*t49,
        t43,
        -t44,
        t45,
        t53,
        t28,
        t54,
        -t0*t54 + t28*t7,
        t52*t7 + t1*t54,
        -t0*t52 - t1*t28,
        t46,
        -t47,
        -t48,
        t55,
        t57,
        t30,
        -t0*t30 - t32*t58,
        -t31*t58 + t1*t30,
        t59*t31 + t60*t32,
        0,
        0,
        0,
        0,
        0,
        0,
        t15,
        t49,
        t51,
        0,
        0,
        0,
        0,
        0,
        0,
        t53,
        t28,
        t54,
        0,
        0,
        0,
        0,
        0,
        0,
        t55,
        t57,
        t30,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays4 - rays1*rays3
    t1 = t0*t0
    t2 = rays0*rays5 - rays2*rays3
    t3 = t2*t2
    t4 = rays1*rays5 - rays2*rays4
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = 1/t6
    t8 = sqrt(t7)
    t9 = pose3*pose6
    t10 = pose4*pose5
    t11 = t9 - t10
    t12 = t2 + t2
    t13 = pose4*pose4
    t14 = pose5*pose5
    t15 = -t14
    t16 = pose3*pose3
    t17 = pose6*pose6
    t18 = t16 - t17
    t19 = t13 + t15 + t18
    t20 = pose3*pose5
    t21 = pose4*pose6
    t22 = t20 + t21
    t23 = t0 + t0
    t24 = -t13
    t25 = t14 + t18 + t24
    t26 = t9 + t10
    t27 = t4 + t4
    t28 = pose3*pose4
    t29 = pose5*pose6
    t30 = t28 - t29
    t31 = t15 + t16 + t17 + t24
    t32 = t28 + t29
    t33 = t20 - t21
    t34 = rays0 - rays3
    t35 = t34*t34
    t36 = rays1 - rays4
    t37 = t36*t36
    t38 = rays2 - rays5
    t39 = t38*t38
    t40 = t35 + t37 + t39
    t41 = 1/t40
    t42 = sqrt(t41)
    t43 = prior1*t8
    t44 = prior0*t36 - (-t0*t34 + t38*t4)*t43
    t45 = t11 + t11
    t46 = -t36
    t47 = -t2
    t48 = prior0*t34 + (t0*t46 + t38*t47)*t43
    t49 = prior0*t38 + (-t4*t46 - t34*t47)*t43
    t50 = t22 + t22
    t51 = t26 + t26
    t52 = t30 + t30
    t53 = t32 + t32
    t54 = t33 + t33
    return (
        pose0,
        pose1,
        pose2,
        (t11*t12 + t19*t4 + t22*t23)*t8,
        -(t2*t25 - t26*t27 + t23*t30)*t8,
        -(-t0*t31 + t12*t32 + t27*t33)*t8,
        (t45*t44 - t19*t48 - t50*t49)*t42,
        (-t51*t48 + t52*t49 - t25*t44)*t42,
        (-t53*t44 + t54*t48 - t31*t49)*t42,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays0*rays5
    t1 = rays2*rays3
    t2 = t0 - t1
    t3 = t2*t2
    t4 = rays0*rays4
    t5 = rays1*rays3
    t6 = t4 - t5
    t7 = t6*t6
    t8 = rays1*rays5
    t9 = rays2*rays4
    t10 = t8 - t9
    t11 = t10*t10
    t12 = t7 + t11
    t13 = t3 + t12
    t14 = 1/t13
    t15 = sqrt(t14)
    t16 = pose3*pose5
    t17 = pose4*pose6
    t18 = t16 + t17
    t19 = t6 + t6
    t20 = t18*t19
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 - t22
    t24 = t2 + t2
    t25 = t23*t24
    t26 = pose4*pose4
    t27 = pose5*pose5
    t28 = -t27
    t29 = pose3*pose3
    t30 = pose6*pose6
    t31 = t29 - t30
    t32 = t26 + t28 + t31
    t33 = t10*t32
    t34 = t21 + t22
    t35 = t10 + t10
    t36 = t34*t35
    t37 = pose3*pose4
    t38 = pose5*pose6
    t39 = t37 - t38
    t40 = t19*t39
    t41 = -t26
    t42 = t27 + t31 + t41
    t43 = t2*t42
    t44 = t37 + t38
    t45 = t24*t44
    t46 = t16 - t17
    t47 = t35*t46
    t48 = t28 + t29 + t30 + t41
    t49 = t48*t6
    t50 = rays0 - rays3
    t51 = t50*t50
    t52 = rays1 - rays4
    t53 = t52*t52
    t54 = rays2 - rays5
    t55 = t54*t54
    t56 = t51 + t53 + t55
    t57 = 1/t56
    t58 = sqrt(t57)
    t59 = prior0*t54
    t60 = -t50
    t61 = -t2
    t62 = t60*t61
    t63 = -t52
    t64 = t10*t63
    t65 = t62 - t64
    t66 = prior1*t15
    t67 = t59 + t65*t66
    t68 = t18 + t18
    t69 = t50*t6
    t70 = -t10*t54 + t69
    t71 = -t70
    t72 = prior0*t52 - t66*t71
    t73 = t23 + t23
    t74 = t6*t63
    t75 = -t54
    t76 = t61*t75
    t77 = t74 - t76
    t78 = prior0*t50
    t79 = t66*t77 + t78
    t80 = t34 + t34
    t81 = t39 + t39
    t82 = t44 + t44
    t83 = t46 + t46
    t84 = pose4*t6
    t85 = pose3*t2 - pose6*t10 + t84
    t86 = -t85
    t87 = pose4*t10 - pose5*t2 + pose6*t6
    t88 = pose3*t87
    t89 = pose3*t10 + pose5*t6
    t90 = pose6*t2 + t89
    t91 = pose4*t90
    t92 = pose5*t10
    t93 = pose3*t6
    t94 = pose4*t2 + t92 - t93
    t95 = pose6*t94
    t96 = -t94
    t97 = pose3*t61 + pose6*t10 - t84
    t98 = pose5*t90
    t99 = pose6*t87
    t100 = pose4*t96
    t101 = pose5*t87
    t102 = pose4*t61 - t92 + t93
    t103 = pose5*t85
    t104 = t88 + t91
    t105 = pose4*t87
    t106 = pose6*t86
    t107 = -pose6*t61 + t89
    t108 = -t72
    t109 = -t67
    t110 = -t79
    t111 = pose3*t108 - pose4*t109 + pose6*t110
    t112 = (-pose3*t67 - pose4*t72 + pose5*t79)*pose6
    t113 = (-pose4*t79 - pose5*t72 - pose6*t67)*pose3
    t114 = (-pose3*t79 - pose5*t67 + pose6*t72)*pose4
    t115 = pose3*t109 + pose4*t108 - pose5*t110
    t116 = t61*t61
    t117 = t116 + t12
    t118 = 1/t117
    t119 = sqrt(t118)
    t120 = prior1*t119
    t121 = t6*t60
    t122 = t10*t75
    t123 = prior0*t63 + (t121 - t122)*t120
    t124 = prior0*t75 - t120*t65
    t125 = prior0*t60 - t120*t77
    t126 = pose3*t123 - pose4*t124 + pose6*t125
    t127 = pose4*t110 + pose5*t108 + pose6*t109
    t128 = pose6*t127
    t129 = pose3*t110 + pose5*t109 - pose6*t108
    t130 = pose5*t129
    t131 = pose4*t115
    t132 = pose5*t127
    t133 = pose3*t124 + pose4*t123 - pose5*t125
    t134 = (-pose3*t72 + pose4*t67 - pose6*t79)*pose5
    t135 = pose4*t127
    t136 = pose6*t111
    t137 = pose3*t125 + pose5*t124 - pose6*t123
    t138 = rays4*t6
    t139 = -rays5*t61 + t138
    t140 = t14*t33
    t141 = t139*t14
    t142 = rays3*t6 - rays5*t10
    t143 = t14*t142
    t144 = rays4*t10
    t145 = rays3*t61 - t144
    t146 = t14*t145
    t147 = rays1*t6
    t148 = rays2*t2 + t147
    t149 = t14*t148
    t150 = rays0*t6 - rays2*t10
    t151 = t14*t150
    t152 = rays0 + rays0
    t153 = rays1*t10
    t154 = rays0*t2 + t153
    t155 = t14*t154
    t156 = t14*t43
    t157 = -rays3*t2 - t144
    t158 = t14*t157
    t159 = -t154
    t160 = t14*t159
    t161 = rays5 + rays5
    t162 = rays5*t2 + t138
    t163 = t14*t49
    t164 = t14*t162
    t165 = t57*t78
    t166 = t165*t52
    t167 = -t118*t139
    t168 = t60*t60
    t169 = t63*t63
    t170 = t75*t75
    t171 = t168 + t169 + t170
    t172 = 1/t171
    t173 = t172*t60
    t174 = -t4 + t5
    t175 = t166 + (rays4*t60 + t121*t167 - t122*t167 - t122*t173 + t168*t172*t6 + t174)*t66
    t176 = t165*t54
    t177 = t10*t52
    t178 = t2*t50
    t179 = t51*t57
    t180 = t50*t57
    t181 = -t0 + t1
    t182 = t176 + (-rays5*t50 + t164*t177 + t164*t178 + t179*t2 + t177*t180 + t181)*t66
    t183 = -prior0*t179 + prior0
    t184 = rays4*t63
    t185 = rays5*t75
    t186 = t173*t74
    t187 = t173*t76
    t188 = t183 + (t167*t74 - t167*t76 + t184 + t185 + t186 - t187)*t66
    t189 = t52*t57
    t190 = t189*t59
    t191 = t118*t142
    t192 = t172*t62
    t193 = -t8 + t9
    t194 = t190 + (rays5*t63 + t10*t169*t172 - t191*t62 + t191*t64 - t192*t63 + t193)*t66
    t195 = t53*t57
    t196 = prior0*t195
    t197 = rays3*t60
    t198 = t172*t75
    t199 = t198*t64
    t200 = prior0 - t196 + (-t121*t191 + t122*t191 + t185 - t186 + t197 + t199)*t66
    t201 = t2*t54
    t202 = t52*t6
    t203 = t166 - (rays3*t52 - t143*t201 - t143*t202 + t174 + t189*t201 + t195*t6)*t66
    t204 = t55*t57
    t205 = prior0*t204
    t206 = -t118*t145
    t207 = prior0 - t205 + (t184 + t187 + t197 - t199 + t206*t62 - t206*t64)*t66
    t208 = t10*t54
    t209 = t190 - (rays4*t54 + t146*t208 - t146*t69 - t54*t57*t69 + t193 + t10*t204)*t66
    t210 = t176 + (rays3*t75 + t170*t172*t61 - t198*t74 - t206*t74 + t206*t76 + t2)*t66
    t211 = (-rays2*t61 + t147)*t118
    t212 = t172*t50
    t213 = t176 + (rays2*t60 + t181 + t192*t50 + t211*t62 - t211*t64 - t212*t64)*t66
    t214 = t166 + (rays1*t60 - t121*t211 + t122*t211 + t122*t212 - t173*t69 + t174)*t66
    t215 = rays1*t52
    t216 = rays2*t54
    t217 = t189*t69
    t218 = t180*t201
    t219 = t183 + (t149*t201 + t149*t202 - t215 - t216 + t217 + t218)*t66
    t220 = -t118*t150
    t221 = t172*t52
    t222 = t190 + (rays2*t63 + t192*t52 + t193 + t220*t62 - t220*t64 - t221*t64)*t66
    t223 = -prior0
    t224 = rays0*t50
    t225 = t189*t208
    t226 = -t196 - t223 - (t151*t208 - t151*t69 + t216 + t217 + t224 - t225)*t66
    t227 = t166 + (rays0*t63 + t220*t74 - t220*t76 + t221*t74 - t221*t76 + t6)*t66
    t228 = -t205 - t223 - (t160*t177 + t160*t178 + t215 + t218 + t224 + t225)*t66
    t229 = (rays0*t61 - t153)*t118
    t230 = t172*t54
    t231 = t190 + (rays1*t75 - t121*t229 - t121*t230 + t122*t229 + t198*t208 + t10)*t66
    t232 = t176 + (rays0*t75 + t2 + t229*t74 - t229*t76 + t230*t74 - t230*t76)*t66
    t233 = t203 + t203
    t234 = t209 + t209
    t235 = t15*t58
    t236 = -t201 - t202
    t237 = t177 + t178
    t238 = t237 + t237
    t239 = t236 + t236
    return (
        pose0,
        pose1,
        pose2,
        (t20 + t25 + t33)*t15,
        -(-t36 + t40 + t43)*t15,
        -(t45 + t47 - t49)*t15,
        (-t68*t67 + t73*t72 - t32*t79)*t58,
        (-t80*t79 + t81*t67 - t42*t72)*t58,
        (-t82*t72 + t83*t79 - t48*t67)*t58,
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
        (pose5*t86 + t88 - t91 - t95)*t15,
        -(-pose3*t96 + pose4*t97 + t98 + t99)*t15,
        -(pose3*t97 + pose6*t90 + t100 - t101)*t15,
        0,
        0,
        0,
        -(pose3*t102 + pose4*t86 + t98 - t99)*t15,
        (pose6*t96 + t103 + t104)*t15,
        -(-pose3*t90 + pose5*t102 + t105 + t106)*t15,
        0,
        0,
        0,
        -(-pose3*t86 + pose6*t107 + t100 + t101)*t15,
        -(pose3*t107 + pose5*t96 - t105 + t106)*t15,
        (t95 - t103 + t104)*t15,
        0,
        0,
        0,
        (pose5*t111 + t112 + t113 - t114)*t58,
        -(-pose3*t115 + pose4*t126 + t128 + t130)*t58,
        -(pose3*t126 + pose6*t129 + t131 - t132)*t58,
        0,
        0,
        0,
        -(pose3*t133 + pose4*t111 - t128 + t130)*t58,
        (pose6*t115 - t134 + t113 + t114)*t58,
        -(-pose3*t129 + pose5*t133 + t135 + t136)*t58,
        0,
        0,
        0,
        -(-pose3*t111 + pose6*t137 + t131 + t132)*t58,
        -(pose3*t137 + pose5*t115 - t135 + t136)*t58,
        (pose4*t129 + t134 - t112 + t113)*t58,
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
        -(-rays4*t68 - rays5*t73 + t139*t140 + t141*t20 + t141*t25)*t15,
        (-rays3*t68 + rays5*t32 + t140*t142 + t143*t20 + t143*t25)*t15,
        -(rays3*t73 + rays4*t32 + t140*t145 + t146*t20 + t146*t25)*t15,
        (-rays1*t68 - rays2*t73 + t140*t148 + t149*t20 + t149*t25)*t15,
        -(-rays0*t68 + rays2*t32 + t140*t150 + t151*t20 + t151*t25)*t15,
        (t152*t23 + rays1*t32 - t140*t154 - t155*t20 - t155*t25)*t15,
        -(rays4*t81 + rays5*t42 - t139*t156 + t141*t36 - t141*t40)*t15,
        (rays3*t81 + rays5*t80 - t142*t156 + t143*t36 - t143*t40)*t15,
        (rays3*t42 - rays4*t80 + t156*t157 - t158*t36 + t158*t40)*t15,
        (rays1*t81 + rays2*t42 - t148*t156 + t149*t36 - t149*t40)*t15,
        -(rays0*t81 + rays2*t80 - t150*t156 + t151*t36 - t151*t40)*t15,
        -(rays0*t42 - rays1*t80 + t156*t159 - t160*t36 + t160*t40)*t15,
        (rays4*t48 - t161*t44 - t162*t163 + t164*t45 + t164*t47)*t15,
        -(rays3*t48 - t142*t163 + t143*t45 + t143*t47 + t161*t46)*t15,
        (rays3*t82 + rays4*t83 - t157*t163 + t158*t45 + t158*t47)*t15,
        -(rays1*t48 - rays2*t82 - t148*t163 + t149*t45 + t149*t47)*t15,
        (rays0*t48 + rays2*t83 - t150*t163 + t151*t45 + t151*t47)*t15,
        -(rays0*t82 + rays1*t83 - t159*t163 + t160*t45 + t160*t47)*t15,
        (-t175*t73 + t68*t182 - t188*t32)*t58,
        (t194*t68 + t200*t73 + t203*t32)*t58,
        (-t207*t68 - t209*t73 + t210*t32)*t58,
        (-t213*t68 + t214*t73 + t219*t32)*t58,
        (-t222*t68 - t226*t73 - t227*t32)*t58,
        (t228*t68 + t231*t73 - t232*t32)*t58,
        (-t182*t81 - t188*t80 + t175*t42)*t58,
        (-t194*t81 - t200*t42 + t233*t34)*t58,
        (t207*t81 + t210*t80 + t209*t42)*t58,
        (t213*t81 + t219*t80 - t214*t42)*t58,
        (t222*t81 - t227*t80 + t226*t42)*t58,
        (-t228*t81 - t232*t80 - t231*t42)*t58,
        (t175*t82 + t188*t83 + t182*t48)*t58,
        (-t200*t82 - t203*t83 + t194*t48)*t58,
        (-t210*t83 - t207*t48 + t234*t44)*t58,
        (-t214*t82 - t219*t83 - t213*t48)*t58,
        (t226*t82 + t227*t83 - t222*t48)*t58,
        (-t231*t82 + t232*t83 + t228*t48)*t58,
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
        -(t54*t68 - t52*t73 + t32*t50)*t58,
        -(t65*t68 + t71*t73 + t32*t77)*t235,
        -(-t54*t81 + t50*t80 + t42*t52)*t58,
        (-t236*t80 + t238*t39 - t42*t70)*t235,
        -(t52*t82 - t50*t83 + t48*t54)*t58,
        (-t70*t82 - t237*t48 + t239*t46)*t235,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark6*landmark6
    t1 = landmark7*landmark7
    t2 = landmark8*landmark8
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = abscissa*t4
    t6 = landmark0*landmark7 - landmark1*landmark6 + landmark5
    t7 = -landmark0*landmark8 + landmark2*landmark6 + landmark4
    t8 = landmark1*landmark8 - landmark2*landmark7 + landmark3
    return (
        landmark6*t5 + landmark7*t6 - landmark8*t7,
        -landmark6*t6 + landmark7*t5 + landmark8*t8,
        landmark6*t7 - landmark7*t8 + landmark8*t5,
        t3,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark8*landmark8
    t1 = landmark7*landmark7
    t2 = t0 + t1
    t3 = landmark6*landmark6
    t4 = t2 + t3
    t5 = sqrt(t4)
    t6 = abscissa*t5
    t7 = landmark0*landmark7
    t8 = landmark1*landmark6
    t9 = landmark5 - t8
    t10 = t7 + t9
    t11 = landmark2*landmark6
    t12 = landmark0*landmark8
    t13 = landmark4 - t12
    t14 = t11 + t13
    t15 = landmark1*landmark8
    t16 = landmark2*landmark7
    t17 = landmark3 - t16
    t18 = t15 + t17
    t19 = landmark6*landmark7
    t20 = -t19
    t21 = landmark6*landmark8
    t22 = -t21
    t23 = -landmark1*landmark7
    t24 = 1/t5
    t25 = abscissa*t24
    t26 = -landmark2*landmark8 + t6
    t27 = t7 + t7
    t28 = t19*t25
    t29 = t21*t25
    t30 = t12 + t12
    t31 = landmark7*landmark8
    t32 = -t31
    t33 = t8 + t8
    t34 = -landmark0*landmark6
    t35 = t15 + t15
    t36 = t25*t31
    t37 = t11 + t11
    t38 = t16 + t16
    t39 = landmark6 + landmark6
    t40 = landmark7 + landmark7
    t41 = landmark8 + landmark8
    return (
        landmark6*t6 + landmark7*t10 - landmark8*t14,
        -landmark6*t10 + landmark7*t6 + landmark8*t18,
        landmark6*t14 - landmark7*t18 + landmark8*t6,
        t4,
        t2,
        t20,
        t22,
        0,
        -landmark8,
        landmark7,
        t23 + t25*t3 + t26,
        t27 + t9 + t28,
        -landmark4 + t29 - t11 + t30,
        t20,
        t0 + t3,
        t32,
        landmark8,
        0,
        -landmark6,
        -landmark5 - t7 + t33 + t28,
        t1*t25 + t26 + t34,
        t35 + t17 + t36,
        t22,
        t32,
        t3 + t1,
        -landmark7,
        landmark6,
        0,
        t29 + t37 + t13,
        -landmark3 - t15 + t38 + t36,
        t0*t25 + t6 + t23 + t34,
        0,
        0,
        0,
        0,
        0,
        0,
        t39,
        t40,
        t41,
        landmark6*t5,
        landmark7*t5,
        landmark8*t5,
        0,
    )


def constrain(landmark, eye):
    """constrain: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    eye0, eye1, eye2 = eye
    t0 = eye1 - landmark1
    t1 = eye0 - landmark0
    t2 = landmark5 + landmark6*t0 - landmark7*t1
    t3 = t2*t2
    t4 = eye2 - landmark2
    t5 = landmark3 + landmark7*t4 - landmark8*t0
    t6 = t5*t5
    t7 = landmark4 - landmark6*t4 + landmark8*t1
    t8 = t7*t7
    t9 = t3 + t6 + t8
    t10 = 1/t9
    t11 = (landmark6*t5 + landmark7*t7 + landmark8*t2)*t10
    t12 = landmark8 - t11*t2
    t13 = landmark7 - t11*t7
    t14 = landmark6 - t11*t5
    return (
        landmark0,
        landmark1,
        landmark2,
        t0*t12 - t13*t4 + t5,
        -t1*t12 + t14*t4 + t7,
        -t0*t14 + t1*t13 + t2,
        t14,
        t13,
        t12,
    )


def constrain_jac(landmark, eye):
    """constrain: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    eye0, eye1, eye2 = eye
    t0 = eye1 - landmark1
    t1 = eye0 - landmark0
    t2 = landmark4 + landmark8*t1
    t3 = eye2 - landmark2
    t4 = landmark6*t3
    t5 = t2 - t4
    t6 = t5*t5
    t7 = landmark7*t1
    t8 = landmark5 + landmark6*t0
    t9 = -t7 + t8
    t10 = t9*t9
    t11 = landmark3 + landmark7*t3
    t12 = -landmark8*t0 + t11
    t13 = t12*t12
    t14 = t6 + t10 + t13
    t15 = 1/t14
    t16 = landmark7*t5
    t17 = landmark6*t12
    t18 = landmark8*t9
    t19 = t17 + t18
    t20 = t16 + t19
    t21 = t15*t20
    t22 = t21*t9
    t23 = landmark8 - t22
    t24 = t21*t5
    t25 = landmark7 - t24
    t26 = t12*t21
    t27 = landmark6 - t26
    t28 = t15*t9
    t29 = landmark7 + landmark7
    t30 = landmark8 + landmark8
    t31 = t29*t9 - t30*t5
    t32 = landmark7 - t28*t31
    t33 = t15*t5
    t34 = landmark8 + t31*t33
    t35 = (t0*t32 + t3*t34)*t21
    t36 = landmark6 + landmark6
    t37 = t36*t9 - t30*t12
    t38 = landmark6 - t28*t37
    t39 = t3*t5
    t40 = t15*t37
    t41 = (t0*t38 + t39*t40 + t9)*t21
    t42 = t0*t9
    t43 = t36*t5 - t29*t12
    t44 = t15*t43
    t45 = landmark6 - t33*t43
    t46 = -landmark4 - landmark8*t1 + t42*t44 + t3*t45 + t4
    t47 = t26 + t26
    t48 = landmark6 - t47
    t49 = t15*t48
    t50 = t24 + t24
    t51 = landmark7 - t50
    t52 = t21 + t21
    t53 = t16 + t16
    t54 = -t52*t6 + t53 + t19
    t55 = t18 + t18
    t56 = -t10*t52 + t16 + t17 + t55
    t57 = t22 + t22
    t58 = landmark8 - t57
    t59 = -t3
    t60 = landmark7*t59 + t11
    t61 = t5*t59 + t42
    t62 = t0*t20
    t63 = t60*t9 - t57*t61 + t62
    t64 = t5*t60 + t20*t59 - t50*t61
    t65 = landmark4*t33
    t66 = t1*t9
    t67 = -t12*t3 + t66
    t68 = -t67
    t69 = t15*t15
    t70 = t20*t69
    t71 = t70 + t70
    t72 = t5*t71
    t73 = -t65 + t68*t72 + 1
    t74 = -t1
    t75 = landmark8*t74 + t2
    t76 = t12*t3
    t77 = t74*t9 + t76
    t78 = t20*t74 + t75*t9 - t57*t77
    t79 = t0*t15
    t80 = -eye2 + landmark2
    t81 = t1*t5
    t82 = t0*t12
    t83 = t81 - t82
    t84 = -landmark5*t28 + t71*t83*t9 + 1
    t85 = -t0
    t86 = landmark6*t85 + t8
    t87 = t12*t85 + t81
    t88 = t1*t20
    t89 = t5*t86 - t50*t87 + t88
    t90 = t15*t3
    t91 = -eye1 + landmark1
    t92 = t15*t31
    t93 = -landmark5 - landmark6*t0 + t1*t32 + t7 + t76*t92
    t94 = t12*t15
    t95 = landmark8 + t37*t94
    t96 = (t1*t38 + t3*t95)*t21
    t97 = landmark7 + t43*t94
    t98 = (-t44*t66 + t3*t97 + t12)*t21
    t99 = t17 + t17
    t100 = t16 + t99 + t18 - t13*t52
    t101 = t15*t51
    t102 = -t39 + t42
    t103 = -landmark3*t94 + t102*t12*t71 + 1
    t104 = t1*t15
    t105 = t20*t3
    t106 = -t47*t77 + t12*t75 + t105
    t107 = t20*t85 - t47*t87 + t12*t86
    t108 = -eye0 + landmark0
    t109 = (t1*t34 + t5 - t82*t92)*t21
    t110 = (-t0*t95 + t40*t81 + t12)*t21
    t111 = (t0*t97 + t1*t45)*t21
    t112 = t15*t58
    t113 = t12*t31*t70
    t114 = t21*t95
    t115 = t21*t97
    t116 = t21*t34
    t117 = t37*t5*t70
    t118 = t21*t45
    t119 = t21*t32
    t120 = t21*t38
    t121 = t43*t70*t9
    return (
        landmark0,
        landmark1,
        landmark2,
        t0*t23 - t25*t3 + t12,
        -t1*t23 + t5 + t27*t3,
        -t0*t27 + t1*t25 + t9,
        t27,
        t25,
        t23,
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
        -t35,
        t41,
        t21*t46,
        t39*t49 - t42*t49 + 1,
        -(t42*t51 - t3*t54)*t15,
        -(t0*t56 - t39*t58)*t15,
        -(t0*t63 - t3*t64)*t15,
        -t3*t73 - t78*t79 - t80,
        t0*t84 + t89*t90 + t91,
        t21*t93,
        -t96,
        t98,
        (t48*t66 - t100*t3)*t15,
        t101*t66 - t101*t76 + 1,
        (t1*t56 - t58*t76)*t15,
        t103*t3 + t104*t63 + t80,
        -(-t1*t78 + t106*t3)*t15,
        -t1*t84 - t107*t90 - t108,
        t109,
        -t110,
        -t111,
        -(-t0*t100 + t48*t81)*t15,
        -(t1*t54 - t51*t82)*t15,
        -t112*t81 + t112*t82 + 1,
        -t0*t103 - t104*t64 - t91,
        t1*t73 + t108 + t106*t79,
        -(-t0*t107 + t1*t89)*t15,
        t113,
        -t114,
        t115,
        -t100*t15,
        -t51*t94,
        -t58*t94,
        t103,
        -(landmark4*t12 - t47*t68 + t105)*t15,
        -(landmark5*t12 - t47*t83 - t62)*t15,
        t116,
        -t117,
        -t118,
        -t33*t48,
        -t15*t54,
        -t33*t58,
        -(landmark3*t5 - t102*t50 - t105)*t15,
        -t65 - t67*t72 + 1,
        -(landmark5*t5 - t50*t83 + t88)*t15,
        -t119,
        t120,
        t121,
        -t28*t48,
        -t28*t51,
        -t15*t56,
        -(landmark3*t9 - t102*t57 + t62)*t15,
        -(landmark4*t9 - t57*t68 - t88)*t15,
        t84,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t35,
        -t41,
        -t21*t46,
        -t21*t93,
        t96,
        -t98,
        -t109,
        t110,
        t111,
        -t113,
        t114,
        -t115,
        -t116,
        t117,
        t118,
        t119,
        -t120,
        -t121,
    )
