"""Generated from slamlib/landmarks/ahm_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "613555bdc6798a35",
    "from_frame": "8b01dc09f5a1b352",
    "point_at": "5053ef8f96fd50b8",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (11,),
    "point_at": (4,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = landmark0 - pose0
    t4 = landmark3 + landmark6*t3
    t5 = 2*t4
    t6 = landmark1 - pose1
    t7 = landmark4 + landmark6*t6
    t8 = pose3*pose4
    t9 = pose5*pose6
    t10 = 2*t8 - 2*t9
    t11 = landmark2 - pose2
    t12 = landmark5 + landmark6*t11
    t13 = pose6*pose6
    t14 = pose5*pose5
    t15 = -t14
    t16 = pose3*pose3
    t17 = pose4*pose4
    t18 = t16 - t17
    t19 = t13 + t15 + t18
    t20 = -t10*t7 + t12*t19 + t2*t5
    t21 = landmark10*t11 + landmark9
    t22 = 2*t8 + 2*t9
    t23 = pose3*pose6
    t24 = pose4*pose5
    t25 = t23 - t24
    t26 = landmark10*t3 + landmark7
    t27 = 2*t26
    t28 = landmark10*t6 + landmark8
    t29 = -t13
    t30 = t14 + t18 + t29
    t31 = t21*t22 - t25*t27 + t28*t30
    t32 = t12*t22 - t25*t5 + t30*t7
    t33 = -t10*t28 + t19*t21 + t2*t27
    t34 = 2*t23 + 2*t24
    t35 = 2*t0 - 2*t1
    t36 = t15 + t16 + t17 + t29
    t37 = -t21*t35 + t26*t36 + t28*t34
    t38 = -t12*t35 + t34*t7 + t36*t4
    return (
        -t20*t31 + t32*t33,
        t20*t37 - t33*t38,
        t31*t38 - t32*t37,
        -landmark10*t38 + landmark6*t37,
        -landmark10*t32 + landmark6*t31,
        -landmark10*t20 + landmark6*t33,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    t0 = landmark1 - pose1
    t1 = landmark4 + landmark6*t0
    t2 = pose3*pose4
    t3 = pose5*pose6
    t4 = t2 - t3
    t5 = 2*t4
    t6 = t1*t5
    t7 = landmark2 - pose2
    t8 = landmark5 + landmark6*t7
    t9 = pose6*pose6
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose4*pose4
    t14 = t12 - t13
    t15 = t11 + t14 + t9
    t16 = t15*t8
    t17 = pose3*pose5
    t18 = pose4*pose6
    t19 = t17 + t18
    t20 = landmark0 - pose0
    t21 = landmark3 + landmark6*t20
    t22 = 2*t21
    t23 = t19*t22
    t24 = t16 + t23
    t25 = t24 - t6
    t26 = pose3*pose6
    t27 = pose4*pose5
    t28 = t26 - t27
    t29 = landmark10*t20 + landmark7
    t30 = 2*t29
    t31 = t28*t30
    t32 = landmark10*t0 + landmark8
    t33 = -t9
    t34 = t10 + t14 + t33
    t35 = landmark10*t7 + landmark9
    t36 = t2 + t3
    t37 = 2*t36
    t38 = t32*t34 + t35*t37
    t39 = -t31 + t38
    t40 = t22*t28
    t41 = t1*t34
    t42 = t37*t8
    t43 = t41 + t42
    t44 = -t40 + t43
    t45 = t32*t5
    t46 = t15*t35 + t19*t30
    t47 = -t45 + t46
    t48 = t17 - t18
    t49 = 2*t48
    t50 = t35*t49
    t51 = t11 + t12 + t13 + t33
    t52 = t26 + t27
    t53 = 2*t52
    t54 = t29*t51 + t32*t53
    t55 = -t50 + t54
    t56 = t49*t8
    t57 = t21*t51
    t58 = t1*t53
    t59 = t57 + t58
    t60 = -t56 + t59
    t61 = landmark10*t60
    t62 = landmark10*t44
    t63 = landmark10*t25
    t64 = -landmark6*t19*t39 - landmark6*t28*t47 + t19*t62 + t28*t63
    t65 = landmark6*t39
    t66 = landmark6*t47
    t67 = t34*t63 - t34*t66 + t5*t62 - t5*t65
    t68 = -t15*t62 + t15*t65 + t37*t63 - t37*t66
    t69 = pose4*t21 + pose5*t1 + pose6*t8
    t70 = t39*t69
    t71 = pose4*t29 + pose5*t32 + pose6*t35
    t72 = pose3*t21 - pose5*t8 + pose6*t1
    t73 = pose3*t29 - pose5*t35 + pose6*t32
    t74 = -t25*t73 + t47*t72
    t75 = -t44*t71 + t70 + t74
    t76 = -t75
    t77 = -2*t4
    t78 = t1*t77 + t24
    t79 = -t28
    t80 = t30*t79 + t38
    t81 = t32*t77 + t46
    t82 = t22*t79 + t43
    t83 = -t69*t81 + t71*t78 + t72*t80 - t73*t82
    t84 = pose3*t35 - pose4*t32 + pose5*t29
    t85 = pose3*t8 - pose4*t1 + pose5*t21
    t86 = t39*t85
    t87 = pose3*t1 + pose4*t8 - pose6*t21
    t88 = pose3*t32 + pose4*t35 - pose6*t29
    t89 = -t25*t88 + t47*t87
    t90 = t44*t84 - t86 + t89
    t91 = -t87
    t92 = -t88
    t93 = t78*t84 + t80*t91 - t81*t85 - t82*t92
    t94 = t25*t71
    t95 = t47*t69
    t96 = t39*t72 - t44*t73
    t97 = -t25*t84 + t47*t85
    t98 = t39*t87 - t44*t88
    t99 = 2*t19
    t100 = landmark6*t55
    t101 = -t100*t99 - t51*t63 + t51*t66 + t61*t99
    t102 = -landmark6*t4*t55 - landmark6*t47*t52 + t4*t61 + t52*t63
    t103 = -t100*t15 + t15*t61 + t49*t63 - t49*t66
    t104 = t55*t69
    t105 = -t104 + t60*t71 + t89
    t106 = t55*t87
    t107 = t60*t88
    t108 = t106 - t107 - t94 + t95
    t109 = t60*t84
    t110 = t55*t85
    t111 = t109 - t110 + t74
    t112 = t55*t72 - t60*t73
    t113 = t112 + t97
    t114 = -2*t48
    t115 = t114*t8 + t59
    t116 = t114*t35 + t54
    t117 = t115*t84
    t118 = t116*t85
    t119 = 2*t28
    t120 = -t100*t119 + t119*t61 + t51*t62 - t51*t65
    t121 = t100*t34 - t34*t61 + t53*t62 - t53*t65
    t122 = -landmark6*t36*t55 - landmark6*t39*t48 + t36*t61 + t48*t62
    t123 = -t117 + t118 - t69*t80 + t71*t82
    t124 = t104 - t44*t84 - t60*t71 + t86
    t125 = -t124
    t126 = -t106 + t107 + t96
    t127 = -t72
    t128 = -t73
    t129 = -t115*t128 + t116*t127 - t80*t87 + t82*t88
    t130 = -landmark10*t85 + landmark6*t84
    t131 = landmark10*t72 - landmark6*t73
    t132 = -pose4*t131
    t133 = landmark10*t69 - landmark6*t71
    t134 = pose3*t133
    t135 = landmark10*t87 - landmark6*t88
    t136 = -pose5*t135 + t134
    t137 = pose6*t133
    t138 = pose4*t135
    t139 = pose5*t133
    t140 = pose6*t131
    t141 = landmark10*t85 - landmark6*t84
    t142 = landmark10*t127 - landmark6*t128
    t143 = -pose6*t141
    t144 = pose4*t133
    t145 = pose5*t141
    t146 = landmark10*t91 - landmark6*t92
    t147 = 2*t20
    t148 = -t0*t5 + t147*t19 + t15*t7
    t149 = t0*t34 - t147*t28 + t37*t7
    t150 = t0*t53 + t20*t51 - t49*t7
    return (
        -t25*t39 + t44*t47,
        t25*t55 - t47*t60,
        t39*t60 - t44*t55,
        landmark6*t55 - t61,
        landmark6*t39 - t62,
        landmark6*t47 - t63,
        -2*t64,
        t67,
        t68,
        -pose3*t93 - pose4*t90 - pose5*t76 - pose6*t83,
        -pose3*t83 + pose4*t76 - pose5*t90 + pose6*t93,
        -pose3*t75 + pose4*(t94 - t95 + t96) - pose5*(-t97 - t98) - pose6*t90,
        t101,
        -2*t102,
        t103,
        -pose3*t108 + pose4*t111 + pose5*t105 + pose6*t113,
        pose3*t113 - pose4*t105 + pose5*t111 + pose6*t108,
        -pose3*(t115*t71 - t116*t69 - t78*t88 + t81*t87) - pose4*t113 - pose5*t108 + pose6*(t117 - t118 + t72*t81 - t73*t78),
        t120,
        t121,
        -2*t122,
        -pose3*t123 - pose4*t126 + pose5*t129 + pose6*t125,
        -pose3*t124 - pose4*(-t112 - t98) - pose5*t126 + pose6*(-t109 + t110 + t44*t71 - t70),
        -pose3*t129 - pose4*t125 - pose5*t123 - pose6*t126,
        0,
        0,
        0,
        -pose6*t130 - t132 - t136,
        -pose3*t130 + pose5*t131 + t137 - t138,
        -pose3*t135 + pose4*t130 - t139 + t140,
        0,
        0,
        0,
        -pose3*t141 + pose5*t142 - t137 + t138,
        -pose4*t142 - t136 - t143,
        -pose3*t142 + pose6*t135 + t144 - t145,
        0,
        0,
        0,
        -pose3*t146 + pose4*t141 + t139 - t140,
        -pose3*t131 + pose6*t146 - t144 + t145,
        -pose5*t146 - t132 - t134 - t143,
        2*t64,
        -t67,
        -t68,
        -2*t19*t39 - 2*t28*t47,
        t34*t47 + t39*t5,
        -t15*t39 + t37*t47,
        -t148*t39 + t149*t47,
        2*t19*t44 + 2*t25*t28,
        -t25*t34 - t44*t5,
        t15*t44 - t25*t37,
        t148*t44 - t149*t25,
        -t101,
        2*t102,
        -t103,
        -t47*t51 + t55*t99,
        -2*t4*t55 - 2*t47*t52,
        t15*t55 + t47*t49,
        t148*t55 - t150*t47,
        t25*t51 - t60*t99,
        2*t25*t52 + 2*t4*t60,
        -t15*t60 - t25*t49,
        -t148*t60 + t150*t25,
        -t120,
        -t121,
        2*t122,
        t119*t55 + t39*t51,
        -t34*t55 + t39*t53,
        -2*t36*t55 - 2*t39*t48,
        -t149*t55 + t150*t39,
        -t119*t60 - t44*t51,
        t34*t60 - t44*t53,
        2*t36*t60 + 2*t44*t48,
        t149*t60 - t150*t44,
        0,
        0,
        0,
        -landmark10*t51,
        -landmark10*t53,
        landmark10*t49,
        -landmark10*t150 + t29*t51 + 2*t32*t52 - t50,
        landmark6*t51,
        landmark6*t53,
        -landmark6*t49,
        landmark6*t150 + t56 - t57 - t58,
        0,
        0,
        0,
        landmark10*t119,
        -landmark10*t34,
        -landmark10*t37,
        -landmark10*t149 - t31 + t32*t34 + 2*t35*t36,
        -landmark6*t119,
        landmark6*t34,
        landmark6*t37,
        landmark6*t149 + t40 - t41 - t42,
        0,
        0,
        0,
        -landmark10*t99,
        landmark10*t5,
        -landmark10*t15,
        -landmark10*t148 + t15*t35 + 2*t19*t29 - t45,
        landmark6*t99,
        -landmark6*t5,
        landmark6*t15,
        landmark6*t148 - t16 - t23 + t6,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = landmark0 - pose0
    t4 = landmark3 + landmark6*t3
    t5 = 2*t4
    t6 = t2*t5
    t7 = landmark1 - pose1
    t8 = landmark4 + landmark6*t7
    t9 = pose3*pose4
    t10 = pose5*pose6
    t11 = -t10 + t9
    t12 = 2*t11
    t13 = t12*t8
    t14 = landmark2 - pose2
    t15 = landmark5 + landmark6*t14
    t16 = pose6*pose6
    t17 = pose5*pose5
    t18 = -t17
    t19 = pose3*pose3
    t20 = pose4*pose4
    t21 = t19 - t20
    t22 = t16 + t18 + t21
    t23 = t15*t22
    t24 = -t13 + t23 + t6
    t25 = landmark10*t14 + landmark9
    t26 = t10 + t9
    t27 = 2*t26
    t28 = pose3*pose6
    t29 = pose4*pose5
    t30 = t28 - t29
    t31 = landmark10*t3 + landmark7
    t32 = 2*t31
    t33 = t30*t32
    t34 = landmark10*t7 + landmark8
    t35 = -t16
    t36 = t17 + t21 + t35
    t37 = t25*t27 - t33 + t34*t36
    t38 = t15*t27
    t39 = t30*t5
    t40 = t36*t8
    t41 = t38 - t39 + t40
    t42 = t12*t34
    t43 = t2*t32 + t22*t25 - t42
    t44 = t28 + t29
    t45 = 2*t44
    t46 = t0 - t1
    t47 = 2*t46
    t48 = t25*t47
    t49 = t18 + t19 + t20 + t35
    t50 = t31*t49 + t34*t45 - t48
    t51 = t45*t8
    t52 = t15*t47
    t53 = t4*t49
    t54 = t51 - t52 + t53
    t55 = landmark10*t54
    t56 = landmark10*t41
    t57 = landmark10*t24
    t58 = -landmark6*t2*t37 - landmark6*t30*t43 + t2*t56 + t30*t57
    t59 = landmark6*t37
    t60 = landmark6*t43
    t61 = t12*t56 - t12*t59 + t36*t57 - t36*t60
    t62 = -t22*t56 + t22*t59 + t27*t57 - t27*t60
    t63 = pose3*t25 - pose4*t34 + pose5*t31
    t64 = pose3*t15 - pose4*t8 + pose5*t4
    t65 = t37*t64
    t66 = pose3*t8 + pose4*t15 - pose6*t4
    t67 = pose3*t34 + pose4*t25 - pose6*t31
    t68 = -t24*t67 + t43*t66
    t69 = -t24*t63 + t43*t64
    t70 = t37*t66 - t41*t67
    t71 = pose4*t31 + pose5*t34 + pose6*t25
    t72 = t24*t71
    t73 = pose4*t4 + pose5*t8 + pose6*t15
    t74 = t43*t73
    t75 = pose3*t4 - pose5*t15 + pose6*t8
    t76 = pose3*t31 - pose5*t25 + pose6*t34
    t77 = t37*t75 - t41*t76
    t78 = t37*t73
    t79 = t41*t71
    t80 = -t24*t76 + t43*t75
    t81 = 2*t2
    t82 = landmark6*t50
    t83 = -t49*t57 + t49*t60 + t55*t81 - t81*t82
    t84 = -landmark6*t11*t50 - landmark6*t43*t44 + t11*t55 + t44*t57
    t85 = t22*t55 - t22*t82 + t47*t57 - t47*t60
    t86 = t54*t63
    t87 = t50*t64
    t88 = t50*t66
    t89 = t50*t75 - t54*t76
    t90 = t54*t71
    t91 = t50*t73
    t92 = 2*t30
    t93 = t49*t56 - t49*t59 + t55*t92 - t82*t92
    t94 = -t36*t55 + t36*t82 + t45*t56 - t45*t59
    t95 = -landmark6*t26*t50 - landmark6*t37*t46 + t26*t55 + t46*t56
    t96 = landmark10*t75 - landmark6*t76
    t97 = -2*t96
    t98 = -2*landmark10*t73 + 2*landmark6*t71
    t99 = landmark10*t64 - landmark6*t63
    t100 = landmark10*t66 - landmark6*t67
    t101 = -2*t100
    t102 = -2*t99
    t103 = 2*t3
    t104 = t103*t2 - t12*t7 + t14*t22
    t105 = -t103*t30 + t14*t27 + t36*t7
    t106 = -t14*t47 + t3*t49 + t45*t7
    return (
        -t24*t37 + t41*t43,
        t24*t50 - t43*t54,
        t37*t54 - t41*t50,
        landmark6*t50 - t55,
        landmark6*t37 - t56,
        landmark6*t43 - t57,
        -2*t58,
        t61,
        t62,
        2*t41*t63 - 2*t65 + 2*t68,
        2*t69 + 2*t70,
        -2*t72 + 2*t74 - 2*t77,
        -2*t78 + 2*t79 - 2*t80,
        t83,
        -2*t84,
        t85,
        -2*t80 - 2*t86 + 2*t87,
        2*t54*t67 + 2*t72 - 2*t74 - 2*t88,
        2*t69 + 2*t89,
        -2*t68 - 2*t90 + 2*t91,
        t93,
        t94,
        -2*t95,
        2*t54*t67 + 2*t77 - 2*t88,
        2*t78 - 2*t79 + 2*t86 - 2*t87,
        2*t41*t63 - 2*t65 + 2*t90 - 2*t91,
        2*t70 + 2*t89,
        0,
        0,
        0,
        t97,
        t98,
        2*t99,
        t101,
        0,
        0,
        0,
        t101,
        t102,
        t98,
        2*t96,
        0,
        0,
        0,
        t102,
        2*t100,
        t97,
        t98,
        2*t58,
        -t61,
        -t62,
        -2*t2*t37 - 2*t30*t43,
        t12*t37 + t36*t43,
        -t22*t37 + t27*t43,
        -t104*t37 + t105*t43,
        2*t2*t41 + 2*t24*t30,
        -t12*t41 - t24*t36,
        t22*t41 - t24*t27,
        t104*t41 - t105*t24,
        -t83,
        2*t84,
        -t85,
        -t43*t49 + t50*t81,
        -2*t11*t50 - 2*t43*t44,
        t22*t50 + t43*t47,
        t104*t50 - t106*t43,
        t24*t49 - t54*t81,
        2*t11*t54 + 2*t24*t44,
        -t22*t54 - t24*t47,
        -t104*t54 + t106*t24,
        -t93,
        -t94,
        2*t95,
        t37*t49 + t50*t92,
        -t36*t50 + t37*t45,
        -2*t26*t50 - 2*t37*t46,
        -t105*t50 + t106*t37,
        -t41*t49 - t54*t92,
        t36*t54 - t41*t45,
        2*t26*t54 + 2*t41*t46,
        t105*t54 - t106*t41,
        0,
        0,
        0,
        -landmark10*t49,
        -landmark10*t45,
        landmark10*t47,
        -landmark10*t106 + t31*t49 + 2*t34*t44 - t48,
        landmark6*t49,
        landmark6*t45,
        -landmark6*t47,
        landmark6*t106 - t51 + t52 - t53,
        0,
        0,
        0,
        landmark10*t92,
        -landmark10*t36,
        -landmark10*t27,
        -landmark10*t105 + 2*t25*t26 - t33 + t34*t36,
        -landmark6*t92,
        landmark6*t36,
        landmark6*t27,
        landmark6*t105 - t38 + t39 - t40,
        0,
        0,
        0,
        -landmark10*t81,
        landmark10*t12,
        -landmark10*t22,
        -landmark10*t104 + 2*t2*t31 + t22*t25 - t42,
        landmark6*t81,
        -landmark6*t12,
        landmark6*t22,
        landmark6*t104 + t13 - t23 - t6,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*rays2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*rays1
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*rays0
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = 2*rays5
    t26 = 2*rays4
    t27 = 2*rays3
    return (
        pose0,
        pose1,
        pose2,
        rays0*t14 + t2*t3 - t6*t7,
        rays1*t21 + t15*t16 - t19*t3,
        rays2*t24 - t16*t23 + t22*t7,
        prior0,
        rays3*t14 + t2*t25 - t26*t6,
        rays4*t21 + t15*t27 - t19*t25,
        rays5*t24 + t22*t26 - t23*t27,
        prior1,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*rays2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*rays1
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*rays0
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = 2*rays5
    t26 = 2*rays4
    t27 = 2*rays3
    t28 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t29 = pose5*t28
    t30 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t31 = pose4*t30
    t32 = pose4*rays0 + pose5*rays1 + pose6*rays2
    t33 = pose3*t32
    t34 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t35 = pose6*t34
    t36 = t33 + t35
    t37 = pose6*t32
    t38 = pose3*t34
    t39 = pose4*t28 + pose5*t30
    t40 = pose3*t28
    t41 = pose5*t32
    t42 = pose4*t34 + pose6*t30
    t43 = pose4*t32
    t44 = pose3*t30
    t45 = pose5*t34 + pose6*t28
    t46 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t47 = pose5*t46
    t48 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t49 = pose4*t48
    t50 = pose4*rays3 + pose5*rays4 + pose6*rays5
    t51 = pose3*t50
    t52 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t53 = pose6*t52
    t54 = t51 + t53
    t55 = pose6*t50
    t56 = pose3*t52
    t57 = pose4*t46 + pose5*t48
    t58 = pose3*t46
    t59 = pose5*t50
    t60 = pose4*t52 + pose6*t48
    t61 = pose4*t50
    t62 = pose3*t48
    t63 = pose5*t52 + pose6*t46
    t64 = -2*t6
    t65 = 2*t2
    t66 = 2*t15
    t67 = -2*t19
    t68 = -2*t23
    t69 = 2*t22
    return (
        pose0,
        pose1,
        pose2,
        rays0*t14 + t2*t3 - t6*t7,
        rays1*t21 + t15*t16 - t19*t3,
        rays2*t24 - t16*t23 + t22*t7,
        prior0,
        rays3*t14 + t2*t25 - t26*t6,
        rays4*t21 + t15*t27 - t19*t25,
        rays5*t24 + t22*t26 - t23*t27,
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
        t29 - t31 + t36,
        -t37 + t38 - t39,
        -t40 + t41 - t42,
        0,
        0,
        0,
        t37 - t38 - t39,
        -t29 + t31 + t36,
        -t43 + t44 - t45,
        0,
        0,
        0,
        t40 - t41 - t42,
        t43 - t44 - t45,
        t29 + t31 + t33 - t35,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t47 - t49 + t54,
        -t55 + t56 - t57,
        -t58 + t59 - t60,
        0,
        0,
        0,
        t55 - t56 - t57,
        -t47 + t49 + t54,
        -t61 + t62 - t63,
        0,
        0,
        0,
        t58 - t59 - t60,
        t61 - t62 - t63,
        t47 + t49 + t51 - t53,
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
        t14,
        t64,
        t65,
        0,
        0,
        0,
        t66,
        t21,
        t67,
        0,
        0,
        0,
        t68,
        t69,
        t24,
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
        t14,
        t64,
        t65,
        0,
        0,
        0,
        t66,
        t21,
        t67,
        0,
        0,
        0,
        t68,
        t69,
        t24,
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
        1,
        0,
        0,
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
    t2 = t0 + t1
    t3 = 2*rays2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*rays1
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*rays0
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = 2*rays5
    t26 = 2*rays4
    t27 = 2*rays3
    t28 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t29 = 2*t28
    t30 = 2*(pose4*rays0 + pose5*rays1 + pose6*rays2)
    t31 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t32 = 2*t31
    t33 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t34 = 2*t33
    t35 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t36 = 2*t35
    t37 = 2*(pose4*rays3 + pose5*rays4 + pose6*rays5)
    t38 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t39 = 2*t38
    t40 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t41 = 2*t40
    t42 = -2*t6
    t43 = 2*t2
    t44 = 2*t15
    t45 = -2*t19
    t46 = -2*t23
    t47 = 2*t22
    return (
        pose0,
        pose1,
        pose2,
        rays0*t14 + t2*t3 - t6*t7,
        rays1*t21 + t15*t16 - t19*t3,
        rays2*t24 - t16*t23 + t22*t7,
        prior0,
        rays3*t14 + t2*t25 - t26*t6,
        rays4*t21 + t15*t27 - t19*t25,
        rays5*t24 + t22*t26 - t23*t27,
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
        t29,
        t30,
        t32,
        -2*t33,
        0,
        0,
        0,
        t34,
        -2*t31,
        t30,
        t29,
        0,
        0,
        0,
        t32,
        t34,
        -2*t28,
        t30,
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
        t36,
        t37,
        t39,
        -2*t40,
        0,
        0,
        0,
        t41,
        -2*t38,
        t37,
        t36,
        0,
        0,
        0,
        t39,
        t41,
        -2*t35,
        t37,
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
        t14,
        t42,
        t43,
        0,
        0,
        0,
        t44,
        t21,
        t45,
        0,
        0,
        0,
        t46,
        t47,
        t24,
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
        t14,
        t42,
        t43,
        0,
        0,
        0,
        t44,
        t21,
        t45,
        0,
        0,
        0,
        t46,
        t47,
        t24,
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
        1,
        0,
        0,
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
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    abscissa, = abscissa
    t0 = abscissa*landmark6
    t1 = landmark10*landmark6
    t2 = landmark10*(abscissa - 1)
    return (
        landmark0*t1 - landmark3*t2 + landmark7*t0,
        landmark1*t1 - landmark4*t2 + landmark8*t0,
        landmark2*t1 - landmark5*t2 + landmark9*t0,
        t1,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    abscissa, = abscissa
    t0 = abscissa*landmark7
    t1 = landmark10*landmark6
    t2 = abscissa - 1
    t3 = landmark10*t2
    t4 = abscissa*landmark6
    t5 = -t3
    return (
        landmark0*t1 - landmark3*t3 + landmark6*t0,
        landmark1*t1 - landmark4*t3 + landmark8*t4,
        landmark2*t1 - landmark5*t3 + landmark9*t4,
        t1,
        t1,
        0,
        0,
        t5,
        0,
        0,
        landmark0*landmark10 + t0,
        t4,
        0,
        0,
        landmark0*landmark6 - landmark3*t2,
        0,
        t1,
        0,
        0,
        t5,
        0,
        abscissa*landmark8 + landmark1*landmark10,
        0,
        t4,
        0,
        landmark1*landmark6 - landmark4*t2,
        0,
        0,
        t1,
        0,
        0,
        t5,
        abscissa*landmark9 + landmark10*landmark2,
        0,
        0,
        t4,
        landmark2*landmark6 - landmark5*t2,
        0,
        0,
        0,
        0,
        0,
        0,
        landmark10,
        0,
        0,
        0,
        landmark6,
        -landmark10*landmark3 + landmark6*landmark7,
        -landmark10*landmark4 + landmark6*landmark8,
        -landmark10*landmark5 + landmark6*landmark9,
        0,
    )
