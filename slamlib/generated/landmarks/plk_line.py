"""Generated from slamlib/landmarks/plk_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "to_frame": "aee6a34f4866d567",
    "from_frame": "081207329798bf8d",
    "point_at": "ac9ac0ca3878e409",
    "constrain": "5e07b4e4de060c57",
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
    t0 = landmark0 + landmark4*pose2 - landmark5*pose1
    t1 = pose4*pose4
    t2 = pose5*pose5
    t3 = -t2
    t4 = pose3*pose3
    t5 = pose6*pose6
    t6 = t4 - t5
    t7 = t1 + t3 + t6
    t8 = pose3*pose6
    t9 = pose4*pose5
    t10 = t8 + t9
    t11 = landmark1 - landmark3*pose2 + landmark5*pose0
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = landmark2 + landmark3*pose1 - landmark4*pose0
    t17 = t16 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t8 - t9
    t22 = t0 + t0
    t23 = -t1
    t24 = t2 + t6 + t23
    t25 = t13 + t14
    t26 = t18 - t19
    t27 = t3 + t4 + t5 + t23
    t28 = landmark4 + landmark4
    t29 = landmark5 + landmark5
    t30 = landmark3 + landmark3
    return (
        t0*t7 + t10*t12 - t15*t17,
        t17*t20 - t21*t22 + t11*t24,
        t22*t25 - t12*t26 + t16*t27,
        landmark3*t7 + t10*t28 - t15*t29,
        landmark4*t24 + t20*t29 - t21*t30,
        landmark5*t27 + t25*t30 - t26*t28,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = landmark0 + landmark4*pose2 - landmark5*pose1
    t1 = pose4*pose4
    t2 = pose5*pose5
    t3 = -t2
    t4 = pose3*pose3
    t5 = pose6*pose6
    t6 = t4 - t5
    t7 = t1 + t3 + t6
    t8 = pose3*pose6
    t9 = pose4*pose5
    t10 = t8 + t9
    t11 = landmark1 - landmark3*pose2 + landmark5*pose0
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = landmark2 + landmark3*pose1 - landmark4*pose0
    t17 = t16 + t16
    t18 = t0*t7 + t10*t12 - t15*t17
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 + t20
    t22 = t8 - t9
    t23 = t0 + t0
    t24 = -t1
    t25 = t2 + t6 + t24
    t26 = t17*t21 - t22*t23 + t11*t25
    t27 = t13 + t14
    t28 = t19 - t20
    t29 = t3 + t4 + t5 + t24
    t30 = t23*t27 - t12*t28 + t16*t29
    t31 = landmark4 + landmark4
    t32 = landmark5 + landmark5
    t33 = landmark3*t7 + t10*t31 - t15*t32
    t34 = landmark3 + landmark3
    t35 = landmark4*t25 + t21*t32 - t22*t34
    t36 = landmark5*t29 + t27*t34 - t28*t31
    t37 = t10 + t10
    t38 = t15 + t15
    t39 = -t38
    t40 = t22 + t22
    t41 = -t40
    t42 = t21 + t21
    t43 = t27 + t27
    t44 = t28 + t28
    t45 = -t44
    t46 = pose2 + pose2
    t47 = pose0 + pose0
    t48 = pose1 + pose1
    return (
        t18,
        t26,
        t30,
        t33,
        t35,
        t36,
        t10*t32 + t15*t31,
        -landmark5*t7 - t15*t34,
        landmark4*t7 - t10*t34,
        0,
        -t30,
        t26,
        landmark5*t25 - t21*t31,
        t21*t34 + t22*t32,
        -landmark3*t25 - t22*t31,
        t30,
        0,
        -t18,
        -landmark4*t29 - t28*t32,
        landmark3*t29 - t27*t32,
        t27*t31 + t28*t34,
        -t26,
        t18,
        0,
        0,
        0,
        0,
        0,
        -t36,
        t35,
        0,
        0,
        0,
        t36,
        0,
        -t33,
        0,
        0,
        0,
        -t35,
        t33,
        0,
        t7,
        t37,
        t39,
        -pose1*t38 - pose2*t37,
        pose0*t38 + pose2*t7,
        pose0*t37 - pose1*t7,
        t41,
        t25,
        t42,
        pose1*t42 - pose2*t25,
        -pose0*t42 - pose2*t40,
        pose0*t25 + pose1*t40,
        t43,
        t45,
        t29,
        pose1*t29 + t28*t46,
        -pose0*t29 + t27*t46,
        -t47*t28 - t48*t27,
        0,
        0,
        0,
        t7,
        t37,
        t39,
        0,
        0,
        0,
        t41,
        t25,
        t42,
        0,
        0,
        0,
        t43,
        t45,
        t29,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = rays1*rays5 - rays2*rays4
    t1 = t0*t0
    t2 = rays0*rays4 - rays1*rays3
    t3 = t2*t2
    t4 = rays0*rays5 - rays2*rays3
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = 1/t6
    t8 = sqrt(t7)
    line0 = t0*t8
    t9 = pose4*pose4
    t10 = pose6*pose6
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose5*pose5
    t14 = t12 - t13
    t15 = t9 + t11 + t14
    t16 = rays0 - rays3
    t17 = t16*t16
    t18 = rays1 - rays4
    t19 = t18*t18
    t20 = rays2 - rays5
    t21 = t20*t20
    t22 = t17 + t19 + t21
    t23 = 1/t22
    t24 = sqrt(t23)
    t25 = prior1*t8
    t26 = -t18
    t27 = -t4
    line5 = -(prior0*t20 + (-t0*t26 - t16*t27)*t25)*t24
    t28 = -t9
    t29 = t10 + t14 + t28
    t30 = pose3*pose4
    t31 = pose5*pose6
    t32 = t30 + t31
    line4 = -(prior0*t18 - (t0*t20 - t16*t2)*t25)*t24
    t33 = line4 + line4
    t34 = pose3*pose5
    t35 = pose4*pose6
    t36 = t34 - t35
    line3 = -(prior0*t16 + (t2*t26 + t20*t27)*t25)*t24
    t37 = line3 + line3
    t38 = line5*t29 + t32*t33 - t36*t37
    t39 = t11 + t12 + t13 + t28
    t40 = pose3*pose6
    t41 = pose4*pose5
    t42 = t40 + t41
    t43 = t30 - t31
    t44 = line5 + line5
    t45 = line4*t39 + t37*t42 - t43*t44
    t46 = t34 + t35
    line2 = t2*t8
    t47 = line2 + line2
    t48 = t40 - t41
    line1 = -t4*t8
    t49 = line1 + line1
    t50 = line3*t15 + t44*t46 - t33*t48
    t51 = line0 + line0
    return (
        line0*t15 + pose1*t38 - pose2*t45 + t46*t47 - t48*t49,
        line1*t39 - pose0*t38 + pose2*t50 - t43*t47 + t42*t51,
        line2*t29 + pose0*t45 - pose1*t50 + t32*t49 - t36*t51,
        t50,
        t45,
        t38,
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
    t4 = rays1*rays5
    t5 = rays2*rays4
    t6 = t4 - t5
    t7 = t6*t6
    t8 = rays0*rays4
    t9 = rays1*rays3
    t10 = t8 - t9
    t11 = t10*t10
    t12 = t7 + t11
    t13 = t3 + t12
    t14 = 1/t13
    t15 = sqrt(t14)
    line0 = t15*t6
    t16 = pose4*pose4
    t17 = pose6*pose6
    t18 = -t17
    t19 = pose3*pose3
    t20 = pose5*pose5
    t21 = t19 - t20
    t22 = t16 + t18 + t21
    t23 = rays0 - rays3
    t24 = t23*t23
    t25 = rays1 - rays4
    t26 = t25*t25
    t27 = rays2 - rays5
    t28 = t27*t27
    t29 = t24 + t26 + t28
    t30 = 1/t29
    t31 = sqrt(t30)
    t32 = prior1*t15
    t33 = -t2
    t34 = -t23
    t35 = t33*t34
    t36 = -t25
    t37 = t36*t6
    t38 = t35 - t37
    line5 = -(prior0*t27 + t32*t38)*t31
    t39 = -t16
    t40 = t17 + t21 + t39
    t41 = pose3*pose4
    t42 = pose5*pose6
    t43 = t41 + t42
    t44 = t10*t23
    t45 = -t27*t6 + t44
    t46 = -t45
    t47 = prior0*t25
    line4 = -(-t32*t46 + t47)*t31
    t48 = line4 + line4
    t49 = pose3*pose5
    t50 = pose4*pose6
    t51 = t49 - t50
    t52 = prior0*t23
    t53 = t10*t36
    t54 = -t27
    t55 = t33*t54
    t56 = t53 - t55
    line3 = -(t52 + t32*t56)*t31
    t57 = line3 + line3
    t58 = line5*t40 + t43*t48 - t51*t57
    t59 = t18 + t19 + t20 + t39
    t60 = pose3*pose6
    t61 = pose4*pose5
    t62 = t60 + t61
    t63 = t41 - t42
    t64 = line5 + line5
    t65 = line4*t59 + t57*t62 - t63*t64
    t66 = t49 + t50
    line2 = t10*t15
    t67 = line2 + line2
    t68 = t60 - t61
    line1 = -t15*t2
    t69 = line1 + line1
    t70 = line3*t22 + t64*t66 - t48*t68
    t71 = line0 + line0
    t72 = line3*pose6 + line4*pose3 - line5*pose4
    t73 = pose1*t72
    t74 = -line3*pose5 + line4*pose4 + line5*pose3
    t75 = line0*pose4
    t76 = line1*pose5
    t77 = line2*pose6
    t78 = pose2*t74 + t75 + t76 + t77
    t79 = t73 + t78
    t80 = pose2*t72
    t81 = line1*pose6
    t82 = line0*pose3 + line2*pose5 + pose1*t74 - t81
    t83 = -t80 + t82
    t84 = line3*pose4 + line4*pose5 + line5*pose6
    t85 = pose1*t84
    t86 = line3*pose3 - line4*pose6 + line5*pose5
    t87 = line2*pose4
    t88 = line0*pose6 + line1*pose3 + pose2*t86 - t87
    t89 = -t85 + t88
    t90 = line0*pose5
    t91 = line1*pose4
    t92 = line2*pose3
    t93 = pose2*t84
    t94 = pose1*t86
    t95 = t90 - t91 - t92 + t93 + t94
    t96 = -t95
    t97 = pose0*t72 - t90 + t91 + t92
    t98 = -t93 + t97
    t99 = pose0*t74
    t100 = t88 - t99
    t101 = pose0*t84
    t102 = -line0*pose3 - line2*pose5 + t80 + t81 + t101
    t103 = -t102
    t104 = pose0*t86
    t105 = t78 + t104
    t106 = -line0*pose6 - line1*pose3 + t85 + t87 + t99
    t107 = -t106
    t108 = -t94 + t97
    t109 = t73 + t75 + t76 + t77 + t104
    t110 = t82 - t101
    t111 = pose5*t72
    t112 = pose4*t86
    t113 = pose3*t84
    t114 = pose6*t74
    t115 = t113 + t114
    t116 = pose6*t84
    t117 = pose3*t74
    t118 = pose4*t72 + pose5*t86
    t119 = pose3*t72
    t120 = pose5*t84
    t121 = pose4*t74 + pose6*t86
    t122 = pose4*t84
    t123 = pose3*t86
    t124 = pose5*t74 + pose6*t72
    t125 = rays4*t10
    t126 = rays5*t2 + t125
    t127 = t14*t15
    t128 = t127*t6
    t129 = t10*t14
    t130 = rays4 - t126*t129
    t131 = t66 + t66
    t132 = t131*t15
    t133 = -rays5*t33 + t125
    t134 = t14*t2
    t135 = rays5 - t133*t134
    t136 = t68 + t68
    t137 = t136*t15
    t138 = t24*t30
    t139 = -prior0*t138 + prior0
    t140 = rays4*t36
    t141 = rays5*t54
    t142 = t34*t34
    t143 = t36*t36
    t144 = t54*t54
    t145 = t142 + t143 + t144
    t146 = 1/t145
    t147 = t146*t34
    t148 = t147*t53
    t149 = t147*t55
    t150 = t33*t33
    t151 = t150 + t12
    t152 = 1/t151
    t153 = -t133
    t154 = t152*t153
    t155 = t139 + (t140 + t141 + t148 - t149 + t154*t53 - t154*t55)*t32
    t156 = pose1*t51 + pose2*t62
    t157 = t156 + t156
    t158 = t157*t31
    t159 = t30*t52
    t160 = t159*t27
    t161 = t2*t23
    t162 = t126*t14
    t163 = t25*t6
    t164 = -t0 + t1
    t165 = -rays5*t23 + t163*t23*t30 + t138*t2 + t164
    t166 = t160 + (t161*t162 + t162*t163 + t165)*t32
    t167 = pose2 + pose2
    t168 = pose1*t40 + t167*t63
    t169 = t168*t31
    t170 = t159*t25
    t171 = t10*t146
    t172 = t10*t152
    t173 = t172*t34
    t174 = t152*t6
    t175 = t174*t54
    t176 = t146*t6
    t177 = t176*t54
    t178 = -t8 + t9
    t179 = rays4*t34 + t142*t171 + t153*t173 - t153*t175 - t177*t34 + t178
    t180 = t170 + t179*t32
    t181 = pose1 + pose1
    t182 = -pose2*t59 + t181*t43
    t183 = t182*t31
    t184 = rays3*t10 - rays5*t6
    t185 = t14*t6
    t186 = rays5 + t184*t185
    t187 = t127 + t127
    t188 = t26*t30
    t189 = t2*t27
    t190 = t25*t30
    t191 = t14*t184
    t192 = t10*t25
    t193 = rays3*t25 + t178 + t10*t188 + t189*t190 - t189*t191 - t191*t192
    t194 = t170 - t193*t32
    t195 = t27*t30
    t196 = t195*t47
    t197 = t152*t184
    t198 = t146*t35
    t199 = -t4 + t5
    t200 = rays5*t36 + t143*t176 - t197*t35 + t197*t37 - t198*t36 + t199
    t201 = t196 + t200*t32
    t202 = prior0*t188
    t203 = prior0 - t202
    t204 = rays3*t34
    t205 = t146*t54
    t206 = t205*t37
    t207 = t172*t184
    t208 = t203 + (t141 - t148 + t175*t184 + t204 + t206 - t207*t34)*t32
    t209 = rays4*t6
    t210 = rays3*t33 - t209
    t211 = rays3 + t134*t210
    t212 = t28*t30
    t213 = prior0*t212
    t214 = prior0 - t213
    t215 = -t210
    t216 = t152*t215
    t217 = t214 + (t140 + t149 + t204 - t206 + t216*t35 - t216*t37)*t32
    t218 = -t217
    t219 = t27*t6
    t220 = rays4*t27 - t10*t14*t210*t23 - t10*t23*t27*t30 + t14*t210*t219 + t199 + t212*t6
    t221 = t196 - t220*t32
    t222 = rays3*t54 + t144*t146*t33 - t10*t146*t36*t54 - t10*t152*t215*t36 + t216*t55 + t2
    t223 = t160 + t222*t32
    t224 = -t157
    t225 = t10*t127
    t226 = t131*t225
    t227 = rays4 - t174*t215
    t228 = t15*t22
    t229 = rays1*t10
    t230 = rays2*t2 + t229
    t231 = rays1 - t129*t230
    t232 = rays2 - t134*t230
    t233 = t14*t230
    t234 = rays1*t25
    t235 = rays2*t27
    t236 = t190*t44
    t237 = t161*t195
    t238 = t139 + (t189*t233 + t192*t233 - t234 - t235 + t236 + t237)*t32
    t239 = t238*t31
    t240 = t146*t37
    t241 = -rays2*t33 + t229
    t242 = t152*t241
    t243 = t160 + (rays2*t34 + t198*t23 - t23*t240 + t164 + t242*t35 - t242*t37)*t32
    t244 = t170 + (rays1*t34 + t177*t23 - t147*t44 - t173*t241 + t175*t241 + t178)*t32
    t245 = rays0*t10 - rays2*t6
    t246 = rays0 - t129*t245
    t247 = t127*t2
    t248 = t146*t25
    t249 = -t245
    t250 = t152*t249
    t251 = t170 + (rays0*t36 + t248*t53 + t250*t53 - t248*t55 - t250*t55 + t10)*t32
    t252 = t196 + (rays2*t36 + t198*t25 - t240*t25 + t199 + t250*t35 - t250*t37)*t32
    t253 = -prior0
    t254 = t14*t245
    t255 = rays0*t23
    t256 = t190*t219
    t257 = t219*t254 + t235 + t236 + t255 - t256 - t254*t44
    t258 = -t202 - t253 - t257*t32
    t259 = rays2 + t185*t245
    t260 = rays1*t6
    t261 = rays0*t2 + t260
    t262 = -t261
    t263 = rays0 + t134*t262
    t264 = t146*t27
    t265 = rays0*t33 - t260
    t266 = t152*t265
    t267 = t160 + (rays0*t54 + t264*t53 + t266*t53 - t264*t55 - t266*t55 + t2)*t32
    t268 = t14*t262
    t269 = t161*t268 + t163*t268 + t234 + t237 + t255 + t256
    t270 = -t213 - t253 - t269*t32
    t271 = t196 + (rays1*t54 - t171*t27*t34 - t173*t265 + t175*t265 + t205*t219 + t6)*t32
    t272 = rays1 - t185*t261
    t273 = t62 + t62
    t274 = t128*t273
    t275 = pose0 + pose0
    t276 = pose2*t22
    t277 = (-t275*t51 - t276)*t31
    t278 = t63 + t63
    t279 = t15*t278
    t280 = t15*t59
    t281 = t152*t33
    t282 = t31 + t31
    t283 = pose0*t43
    t284 = (pose2*t68 + t283)*t282
    t285 = pose0*t40 - t167*t66
    t286 = t285*t31
    t287 = t133*t14
    t288 = t247*t59
    t289 = t15*t273
    t290 = rays3 - t207
    t291 = -t208
    t292 = t225*t278
    t293 = t283 + t283
    t294 = t167*t68 + t293
    t295 = -t275*t51 - t276
    t296 = t51 + t51
    t297 = t128*t296
    t298 = t15*t40
    t299 = t43 + t43
    t300 = t15*t299
    t301 = -pose1*t22 + t275*t62
    t302 = t301*t31
    t303 = pose0*t63 + pose1*t66
    t304 = t282*t303
    t305 = pose0*t59 + t181*t68
    t306 = t305*t31
    t307 = t247*t299
    t308 = t15*t296
    t309 = t303 + t303
    t310 = -t309
    t311 = -rays3*t2 - t209
    t312 = t225*t40
    t313 = t15 + t15
    t314 = t243 + t243
    t315 = t166 + t166
    t316 = t194 + t194
    t317 = t221 + t221
    t318 = t15*t31
    t319 = t161 + t163
    t320 = -t189 - t192
    t321 = t319 + t319
    t322 = t320 + t320
    return (
        line0*t22 + pose1*t58 - pose2*t65 + t66*t67 - t68*t69,
        line1*t59 - pose0*t58 + pose2*t70 - t63*t67 + t62*t71,
        line2*t40 + pose0*t65 - pose1*t70 + t43*t69 - t51*t71,
        t70,
        t65,
        t58,
        0,
        t58,
        -t65,
        pose3*t79 - pose4*t83 + pose5*t89 - pose6*t95,
        pose3*t96 - pose4*t89 - pose5*t83 - pose6*t79,
        -pose3*t89 - pose4*t96 + pose5*t79 - pose6*t83,
        -t58,
        0,
        t70,
        -pose3*t98 - pose4*t100 - pose5*t103 + pose6*t105,
        pose3*t105 - pose4*t102 - pose5*t100 + pose6*t98,
        pose3*t103 - pose4*t105 - pose5*t98 - pose6*t100,
        t65,
        -t70,
        0,
        pose3*t107 - pose4*t108 - pose5*t109 - pose6*t110,
        -pose3*t110 + pose4*t109 - pose5*t108 - pose6*t107,
        pose3*t109 + pose4*t110 - pose5*t106 - pose6*t108,
        0,
        0,
        0,
        t111 - t112 + t115,
        -t116 + t117 - t118,
        -t119 + t120 - t121,
        0,
        0,
        0,
        t116 - t117 - t118,
        -t111 + t112 + t115,
        -t122 + t123 - t124,
        0,
        0,
        0,
        t119 - t120 - t121,
        t122 - t123 - t124,
        t111 + t112 + t113 - t114,
        -t126*t128*t22 + t130*t132 + t135*t137 + t155*t158 + t166*t169 + t180*t183,
        t15*t186*t22 + t187*t184*t2*t68 - (rays3 - t129*t184)*t132 - t158*t194 + t168*t201*t31 - t183*t208,
        -t137*t211 + t169*t218 + t183*t221 + t223*t224*t31 - t210*t226 - t227*t228,
        t127*t22*t230*t6 - t132*t231 - t137*t232 - t157*t239 - t169*t243 - t183*t244,
        t132*t246 - t136*t245*t247 + t158*t251 - t169*t252 + t183*t258 - t228*t259,
        t137*t263 + t158*t267 + t169*t270 - t183*t271 - t226*t261 + t228*t272,
        -t133*t274 + t155*t277 - (rays4 - t129*t133)*t279 - (rays5 - t153*t281)*t280 - (t170 + t179*t32)*t284 - (t160 + (t161*t287 + t163*t287 + t165)*t32)*t286,
        -t184*t288 + t186*t289 + t279*t290 - t284*t291 - t201*t286 - t194*t277,
        t210*t292 + t211*t280 - t227*t289 - t223*t277 - t221*t284 - t218*t286,
        t244*t294*t31 + t230*t274 + t231*t279 + t232*t280 - t239*t295 + t243*t286,
        t245*t288 - t246*t279 + t251*t277 + t252*t286 - (t203 - t257*t32)*t284 - (rays2 - t174*t249)*t289,
        -t262*t292 + t267*t277 + t271*t284 - (rays0 - t265*t281)*t280 - (t214 - t269*t32)*t286 + (rays1 + t185*t262)*t289,
        t126*t297 + t130*t298 - t135*t300 - t155*t302 - t166*t304 + t180*t306,
        -t184*t307 - t186*t308 + t201*t31*t310 - t290*t298 + t291*t306 + t194*t302,
        t217*t304 + (rays3 + t134*t311)*t300 + t221*t306 + t223*t302 + (rays4 + t185*t210)*t308 - t311*t312,
        t313*t232*t43 + t238*t301*t31 + t314*t303*t31 - t230*t297 - t231*t298 - t244*t306,
        t245*t307 + t246*t298 + t259*t308 - t251*t302 + t258*t306 + t252*t304,
        -t261*t312 - t263*t300 - t272*t308 - t267*t302 - t270*t304 - t271*t306,
        (-t136*t180 - t155*t22 + t315*t66)*t31,
        (t131*t201 + t136*t208 + t194*t22)*t31,
        (-t131*t217 - t136*t221 + t22*t223)*t31,
        (-t131*t243 + t136*t244 + t22*t238)*t31,
        (-t131*t252 - t136*t258 - t22*t251)*t31,
        (t131*t270 + t136*t271 - t22*t267)*t31,
        (-t155*t273 - t166*t278 + t180*t59)*t31,
        (t316*t62 - t201*t278 - t208*t59)*t31,
        (t217*t278 + t223*t273 + t221*t59)*t31,
        (t238*t273 - t244*t59 + t243*t278)*t31,
        (-t251*t273 + t258*t59 + t252*t278)*t31,
        (-t267*t273 - t270*t278 - t271*t59)*t31,
        (t155*t296 + t166*t40 + t180*t299)*t31,
        (-t194*t296 + t201*t40 - t208*t299)*t31,
        (-t217*t40 - t223*t296 + t317*t43)*t31,
        (-t238*t296 - t244*t299 - t243*t40)*t31,
        (t251*t296 + t258*t299 - t252*t40)*t31,
        (t267*t296 + t270*t40 - t271*t299)*t31,
        -(t224*t23 + t182*t25 + t168*t27)*t31,
        -(t168*t38 - t182*t46 + t224*t56)*t318,
        (t23*t295 + t25*t294 + t27*t285)*t31,
        (t285*t319 + t294*t45 + t295*t320)*t318,
        -(t23*t301 + t25*t305 + t27*t310)*t31,
        -(t301*t56 - t305*t46 + t310*t38)*t318,
        -(t22*t23 + t131*t27 - t136*t25)*t31,
        -(t131*t38 + t136*t46 + t22*t56)*t318,
        -(t23*t273 + t25*t59 - t27*t278)*t31,
        (-t273*t320 - t45*t59 + t321*t63)*t318,
        -(-t23*t296 + t25*t299 + t27*t40)*t31,
        (-t299*t45 - t319*t40 + t322*t51)*t318,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    abscissa, = abscissa
    t0 = landmark3*landmark3
    t1 = landmark4*landmark4
    t2 = landmark5*landmark5
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = abscissa*t4
    return (
        -landmark1*landmark5 + landmark2*landmark4 + landmark3*t5,
        landmark0*landmark5 - landmark2*landmark3 + landmark4*t5,
        -landmark0*landmark4 + landmark1*landmark3 + landmark5*t5,
        t3,
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
    t8 = 1/t4
    t9 = abscissa*landmark3*t8
    t10 = landmark4*t9
    t11 = landmark5*t9
    t12 = abscissa*landmark4*landmark5*t8
    t13 = landmark3 + landmark3
    t14 = landmark4 + landmark4
    t15 = landmark5 + landmark5
    return (
        abscissa*t5 - landmark1*landmark5 + landmark2*landmark4,
        abscissa*t6 + landmark0*landmark5 - landmark2*landmark3,
        abscissa*t7 - landmark0*landmark4 + landmark1*landmark3,
        t3,
        0,
        -landmark5,
        landmark4,
        (t0*t8 + t4)*abscissa,
        landmark2 + t10,
        -landmark1 + t11,
        landmark5,
        0,
        -landmark3,
        -landmark2 + t10,
        (t1*t8 + t4)*abscissa,
        landmark0 + t12,
        -landmark4,
        landmark3,
        0,
        landmark1 + t11,
        -landmark0 + t12,
        (t2*t8 + t4)*abscissa,
        0,
        0,
        0,
        t13,
        t14,
        t15,
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
    t1 = t0*t0
    t2 = eye0*landmark5 - eye2*landmark3 + landmark1
    t3 = t2*t2
    t4 = -eye1*landmark5 + eye2*landmark4 + landmark0
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = 1/t6
    t8 = (landmark3*t4 + landmark4*t2 + landmark5*t0)*t7
    t9 = landmark5 - t0*t8
    t10 = landmark4 - t2*t8
    t11 = landmark3 - t4*t8
    return (
        eye1*t9 - eye2*t10 + t4,
        -eye0*t9 + eye2*t11 + t2,
        eye0*t10 - eye1*t11 + t0,
        t11,
        t10,
        t9,
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
    t11 = 1/t10
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
    t25 = t22 + t22
    t26 = landmark3 - t25
    t27 = t11*t26
    t28 = eye1*t2
    t29 = t12 + t12
    t30 = t17 + t17
    t31 = t29 + t15 - t30*t7
    t32 = t20 + t20
    t33 = landmark4 - t32
    t34 = t14 + t14
    t35 = t12 + t13 + t34 - t3*t30
    t36 = t18 + t18
    t37 = landmark5 - t36
    t38 = -t24 + t28
    t39 = eye1*t16
    t40 = landmark0*t2 - t36*t38 + t39
    t41 = eye2*t16
    t42 = landmark0*t6 - t32*t38 - t41
    t43 = eye0*t2
    t44 = eye2*t8
    t45 = t43 - t44
    t46 = eye0*t16
    t47 = landmark1*t2 + t36*t45 - t46
    t48 = t11*t47
    t49 = t11*t6
    t50 = t11*t11
    t51 = t16*t50
    t52 = t51 + t51
    t53 = landmark1*t49 + t45*t52*t6 - 1
    t54 = t11*t2
    t55 = eye0*t6
    t56 = -eye1*t8 + t55
    t57 = t2*t52
    t58 = landmark2*t6 - t32*t56 + t46
    t59 = t11*t58
    t60 = t13 + t13
    t61 = t12 + t60 + t14 - t30*t9
    t62 = t11*t33
    t63 = t11*t40
    t64 = t11*t8
    t65 = t52*t8
    t66 = landmark1*t8 + t25*t45 + t41
    t67 = -landmark2*t11*t2 + t56*t57 + 1
    t68 = landmark2*t8 - t25*t56 - t39
    t69 = t11*t68
    t70 = eye1*t8
    t71 = t11*t37
    t72 = t11*t42
    t73 = -landmark0*t11*t8 + t38*t65 + 1
    t74 = t11*t66
    t75 = landmark4 + landmark4
    t76 = landmark5 + landmark5
    t77 = t75*t2 - t76*t6
    t78 = landmark4 - t54*t77
    t79 = landmark5 + t49*t77
    t80 = landmark3 + landmark3
    t81 = t80*t2 - t76*t8
    t82 = landmark3 - t54*t81
    t83 = t11*t81
    t84 = t80*t6 - t75*t8
    t85 = landmark3 - t49*t84
    t86 = t11*t84
    t87 = t11*t77
    t88 = landmark5 + t64*t81
    t89 = landmark4 + t64*t84
    return (
        eye1*t19 - eye2*t21 + t8,
        -eye0*t19 + eye2*t23 + t6,
        eye0*t21 - eye1*t23 + t2,
        t23,
        t21,
        t19,
        t24*t27 - t27*t28 + 1,
        -(-eye2*t31 + t28*t33)*t11,
        -(eye1*t35 - t24*t37)*t11,
        -(eye1*t40 - eye2*t42)*t11,
        -eye1*t48 + eye2*t53 + eye2,
        -(landmark2*t54 - t56*t57 - 1)*eye1 - eye1 + eye2*t59,
        (-eye2*t61 + t26*t43)*t11,
        t43*t62 - t44*t62 + 1,
        (eye0*t35 - t37*t44)*t11,
        eye0*t63 - (landmark0*t64 - t38*t65 - 1)*eye2 - eye2,
        (eye0*t47 - eye2*t66)*t11,
        -eye0*t67 + eye0 - eye2*t69,
        -(-eye1*t61 + t26*t55)*t11,
        -(eye0*t31 - t33*t70)*t11,
        -t55*t71 + t70*t71 + 1,
        -eye0*t72 - eye1*t73 + eye1,
        -eye0*t53 - eye0 + eye1*t74,
        -(eye0*t58 - eye1*t68)*t11,
        -t11*t61,
        -t33*t64,
        -t37*t64,
        t73,
        -t74,
        -t69,
        -t26*t49,
        -t11*t31,
        -t37*t49,
        -t72,
        -t53,
        -t59,
        -t26*t54,
        -t33*t54,
        -t11*t35,
        -t63,
        -t48,
        t67,
        (eye1*t78 + eye2*t79)*t17,
        -(eye1*t82 + t2 + t24*t83)*t17,
        -(eye2*t85 - landmark1 + t28*t86 - t4 + t5)*t17,
        -(eye0*t78 - landmark2 - t0 + t1 + t44*t87)*t17,
        (eye0*t82 + eye2*t88)*t17,
        -(eye2*t89 - t43*t86 + t8)*t17,
        -(eye0*t79 + t6 - t70*t87)*t17,
        -(eye1*t88 - t55*t83 - t8)*t17,
        (eye0*t85 + eye1*t89)*t17,
        -t51*t77*t8,
        t17*t88,
        -t17*t89,
        -t17*t79,
        t51*t6*t81,
        t17*t85,
        t17*t78,
        -t17*t82,
        -t2*t51*t84,
    )
