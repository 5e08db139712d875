"""Generated from slamlib/landmarks/hmg_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "14d0acf083dedb60",
    "from_frame": "0c88b2efc33d9f42",
    "point_at": "7d592894a96b4884",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (8,),
    "point_at": (4,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = landmark0 - landmark3*pose0
    t4 = 2*t3
    t5 = landmark1 - landmark3*pose1
    t6 = pose3*pose4
    t7 = pose5*pose6
    t8 = 2*t6 - 2*t7
    t9 = landmark2 - landmark3*pose2
    t10 = pose6*pose6
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose4*pose4
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = t16*t9 + t2*t4 - t5*t8
    t18 = landmark6 - landmark7*pose2
    t19 = 2*t6 + 2*t7
    t20 = pose3*pose6
    t21 = pose4*pose5
    t22 = t20 - t21
    t23 = landmark4 - landmark7*pose0
    t24 = 2*t23
    t25 = landmark5 - landmark7*pose1
    t26 = -t10
    t27 = t11 + t15 + t26
    t28 = t18*t19 - t22*t24 + t25*t27
    t29 = t19*t9 - t22*t4 + t27*t5
    t30 = t16*t18 + t2*t24 - t25*t8
    t31 = 2*t20 + 2*t21
    t32 = 2*t0 - 2*t1
    t33 = t12 + t13 + t14 + t26
    t34 = -t18*t32 + t23*t33 + t25*t31
    t35 = t3*t33 + t31*t5 - t32*t9
    return (
        -t17*t28 + t29*t30,
        t17*t34 - t30*t35,
        t28*t35 - t29*t34,
        landmark3*t34 - landmark7*t35,
        landmark3*t28 - landmark7*t29,
        landmark3*t30 - landmark7*t17,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    t0 = landmark1 - landmark3*pose1
    t1 = pose3*pose4
    t2 = pose5*pose6
    t3 = t1 - t2
    t4 = 2*t3
    t5 = landmark2 - landmark3*pose2
    t6 = pose6*pose6
    t7 = pose5*pose5
    t8 = -t7
    t9 = pose3*pose3
    t10 = pose4*pose4
    t11 = -t10 + t9
    t12 = t11 + t6 + t8
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 + t14
    t16 = landmark0 - landmark3*pose0
    t17 = 2*t16
    t18 = t12*t5 + t15*t17
    t19 = -t0*t4 + t18
    t20 = pose3*pose6
    t21 = pose4*pose5
    t22 = t20 - t21
    t23 = landmark4 - landmark7*pose0
    t24 = 2*t23
    t25 = landmark5 - landmark7*pose1
    t26 = -t6
    t27 = t11 + t26 + t7
    t28 = landmark6 - landmark7*pose2
    t29 = t1 + t2
    t30 = 2*t29
    t31 = t25*t27 + t28*t30
    t32 = -t22*t24 + t31
    t33 = t0*t27 + t30*t5
    t34 = -t17*t22 + t33
    t35 = t12*t28 + t15*t24
    t36 = -t25*t4 + t35
    t37 = t13 - t14
    t38 = 2*t37
    t39 = t10 + t26 + t8 + t9
    t40 = t20 + t21
    t41 = 2*t40
    t42 = t23*t39 + t25*t41
    t43 = -t28*t38 + t42
    t44 = t0*t41 + t16*t39
    t45 = -t38*t5 + t44
    t46 = landmark3*t43
    t47 = landmark7*t45
    t48 = landmark3*t32
    t49 = landmark7*t34
    t50 = landmark3*t36
    t51 = landmark7*t19
    t52 = pose4*t16 + pose5*t0 + pose6*t5
    t53 = t32*t52
    t54 = pose4*t23 + pose5*t25 + pose6*t28
    t55 = pose3*t16 - pose5*t5 + pose6*t0
    t56 = pose3*t23 - pose5*t28 + pose6*t25
    t57 = -t19*t56 + t36*t55
    t58 = -t34*t54 + t53 + t57
    t59 = -t58
    t60 = -2*t3
    t61 = t0*t60 + t18
    t62 = -t22
    t63 = t24*t62 + t31
    t64 = t25*t60 + t35
    t65 = t17*t62 + t33
    t66 = -t52*t64 + t54*t61 + t55*t63 - t56*t65
    t67 = pose3*t28 - pose4*t25 + pose5*t23
    t68 = pose3*t5 - pose4*t0 + pose5*t16
    t69 = t32*t68
    t70 = pose3*t0 + pose4*t5 - pose6*t16
    t71 = pose3*t25 + pose4*t28 - pose6*t23
    t72 = -t19*t71 + t36*t70
    t73 = t34*t67 - t69 + t72
    t74 = t61*t67 - t63*t70 - t64*t68 + t65*t71
    t75 = t19*t54
    t76 = t36*t52
    t77 = t32*t55 - t34*t56
    t78 = -t19*t67 + t36*t68
    t79 = t32*t70 - t34*t71
    t80 = 2*t15
    t81 = t43*t52
    t82 = t45*t54 + t72 - t81
    t83 = t43*t70
    t84 = t45*t71
    t85 = -t75 + t76 + t83 - t84
    t86 = t45*t67
    t87 = t43*t68
    t88 = t57 + t86 - t87
    t89 = t43*t55 - t45*t56
    t90 = t78 + t89
    t91 = -2*t37
    t92 = t44 + t5*t91
    t93 = t28*t91 + t42
    t94 = t67*t92
    t95 = t68*t93
    t96 = 2*t22
    t97 = -t52*t63 + t54*t65 - t94 + t95
    t98 = -t34*t67 - t45*t54 + t69 + t81
    t99 = -t98
    t100 = t77 - t83 + t84
    t101 = -t55*t93 + t56*t92 - t63*t70 + t65*t71
    t102 = landmark3*t54 - landmark7*t52
    t103 = landmark3*t56 - landmark7*t55
    t104 = landmark3*t71 - landmark7*t70
    t105 = landmark3*t67 - landmark7*t68
    t106 = pose3*t102 - pose4*t103 - pose5*t104 - pose6*t105
    t107 = pose3*t105 - pose4*t104 + pose5*t103 + pose6*t102
    t108 = pose3*t104 + pose4*t105 + pose5*t102 - pose6*t103
    t109 = pose3*t103 + pose4*t102 - pose5*t105 + pose6*t104
    t110 = 2*pose0
    t111 = pose2*t12 + t110*t15
    t112 = pose1*t60 + t111
    t113 = pose1*t27 + pose2*t30
    t114 = t110*t62 + t113
    t115 = pose0*t39 + pose1*t41
    t116 = pose2*t91 + t115
    return (
        -t19*t32 + t34*t36,
        t19*t43 - t36*t45,
        t32*t45 - t34*t43,
        t46 - t47,
        t48 - t49,
        t50 - t51,
        2*t15*t48 - 2*t15*t49 + 2*t22*t50 - 2*t22*t51,
        landmark7*t19*t27 + 2*landmark7*t3*t34 - t27*t50 - t4*t48,
        landmark3*t12*t32 + 2*landmark7*t19*t29 - t12*t49 - t30*t50,
        -pose3*t74 - pose4*t73 - pose5*t59 - pose6*t66,
        -pose3*t66 + pose4*t59 - pose5*t73 + pose6*t74,
        -pose3*t58 + pose4*(t75 - t76 + t77) - pose5*(-t78 - t79) - pose6*t73,
        landmark3*t36*t39 + 2*landmark7*t15*t45 - t39*t51 - t46*t80,
        2*t3*t46 - 2*t3*t47 + 2*t40*t50 - 2*t40*t51,
        landmark7*t12*t45 + 2*landmark7*t19*t37 - t12*t46 - t38*t50,
        -pose3*t85 + pose4*t88 + pose5*t82 + pose6*t90,
        pose3*t90 - pose4*t82 + pose5*t88 + pose6*t85,
        -pose3*(-t52*t93 + t54*t92 - t61*t71 + t64*t70) - pose4*t90 - pose5*t85 + pose6*(t55*t64 - t56*t61 + t94 - t95),
        2*landmark7*t22*t45 + landmark7*t34*t39 - t39*t48 - t46*t96,
        landmark3*t27*t43 + 2*landmark7*t34*t40 - t27*t47 - t41*t48,
        2*t29*t46 - 2*t29*t47 + 2*t37*t48 - 2*t37*t49,
        -pose3*t97 - pose4*t100 + pose5*t101 + pose6*t99,
        -pose3*t98 - pose4*(-t79 - t89) - pose5*t100 + pose6*(t34*t54 - t53 - t86 + t87),
        -pose3*t101 - pose4*t99 - pose5*t97 - pose6*t100,
        0,
        0,
        0,
        t106,
        -t107,
        t108,
        0,
        0,
        0,
        t107,
        t106,
        -t109,
        0,
        0,
        0,
        -t108,
        t109,
        t106,
        -2*t15*t32 - 2*t22*t36,
        t27*t36 + t32*t4,
        -t12*t32 + t30*t36,
        t112*t32 - t114*t36,
        2*t15*t34 + 2*t19*t22,
        -t19*t27 - t34*t4,
        t12*t34 - t19*t30,
        -t112*t34 + t114*t19,
        -t36*t39 + t43*t80,
        -2*t3*t43 - 2*t36*t40,
        t12*t43 + t36*t38,
        -t112*t43 + t116*t36,
        t19*t39 - t45*t80,
        2*t19*t40 + 2*t3*t45,
        -t12*t45 - t19*t38,
        t112*t45 - t116*t19,
        t32*t39 + t43*t96,
        -t27*t43 + t32*t41,
        -2*t29*t43 - 2*t32*t37,
        t114*t43 - t116*t32,
        -t34*t39 - t45*t96,
        t27*t45 - t34*t41,
        2*t29*t45 + 2*t34*t37,
        -t114*t45 + t116*t34,
        -landmark7*t39,
        -landmark7*t41,
        landmark7*t38,
        landmark7*(-pose2*t38 + t115) + t43,
        landmark3*t39,
        landmark3*t41,
        -landmark3*t38,
        -landmark3*t116 - t45,
        landmark7*t96,
        -landmark7*t27,
        -landmark7*t30,
        landmark7*(-t110*t22 + t113) + t32,
        -landmark3*t96,
        landmark3*t27,
        landmark3*t30,
        -landmark3*t114 - t34,
        -landmark7*t80,
        landmark7*t4,
        -landmark7*t12,
        landmark7*(-pose1*t4 + t111) + t36,
        landmark3*t80,
        -landmark3*t4,
        landmark3*t12,
        -landmark3*t112 - t19,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = landmark0 - landmark3*pose0
    t4 = 2*t3
    t5 = landmark1 - landmark3*pose1
    t6 = pose3*pose4
    t7 = pose5*pose6
    t8 = t6 - t7
    t9 = 2*t8
    t10 = landmark2 - landmark3*pose2
    t11 = pose6*pose6
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose4*pose4
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = t10*t17 + t2*t4 - t5*t9
    t19 = landmark6 - landmark7*pose2
    t20 = t6 + t7
    t21 = 2*t20
    t22 = pose3*pose6
    t23 = pose4*pose5
    t24 = t22 - t23
    t25 = landmark4 - landmark7*pose0
    t26 = 2*t25
    t27 = landmark5 - landmark7*pose1
    t28 = -t11
    t29 = t12 + t16 + t28
    t30 = t19*t21 - t24*t26 + t27*t29
    t31 = t10*t21 - t24*t4 + t29*t5
    t32 = t17*t19 + t2*t26 - t27*t9
    t33 = t22 + t23
    t34 = 2*t33
    t35 = t0 - t1
    t36 = 2*t35
    t37 = t13 + t14 + t15 + t28
    t38 = -t19*t36 + t25*t37 + t27*t34
    t39 = -t10*t36 + t3*t37 + t34*t5
    t40 = landmark3*t38
    t41 = landmark7*t39
    t42 = landmark3*t30
    t43 = landmark7*t31
    t44 = landmark3*t32
    t45 = landmark7*t18
    t46 = pose3*t19 - pose4*t27 + pose5*t25
    t47 = pose3*t10 - pose4*t5 + pose5*t3
    t48 = t30*t47
    t49 = pose3*t5 + pose4*t10 - pose6*t3
    t50 = pose3*t27 + pose4*t19 - pose6*t25
    t51 = -t18*t50 + t32*t49
    t52 = -t18*t46 + t32*t47
    t53 = t30*t49 - t31*t50
    t54 = pose4*t25 + pose5*t27 + pose6*t19
    t55 = t18*t54
    t56 = pose4*t3 + pose5*t5 + pose6*t10
    t57 = t32*t56
    t58 = pose3*t3 - pose5*t10 + pose6*t5
    t59 = pose3*t25 - pose5*t19 + pose6*t27
    t60 = t30*t58 - t31*t59
    t61 = t30*t56
    t62 = t31*t54
    t63 = -t18*t59 + t32*t58
    t64 = 2*t2
    t65 = t39*t46
    t66 = t38*t47
    t67 = t38*t49
    t68 = t38*t58 - t39*t59
    t69 = t39*t54
    t70 = t38*t56
    t71 = 2*t24
    t72 = landmark3*t59 - landmark7*t58
    t73 = 2*t72
    t74 = 2*landmark3*t54 - 2*landmark7*t56
    t75 = landmark3*t46 - landmark7*t47
    t76 = landmark3*t50 - landmark7*t49
    t77 = 2*t76
    t78 = 2*t75
    t79 = 2*pose0
    t80 = pose2*t17 + t2*t79
    t81 = -2*pose1*t8 + t80
    t82 = pose1*t29 + pose2*t21
    t83 = -t24*t79 + t82
    t84 = pose0*t37 + pose1*t34
    t85 = -2*pose2*t35 + t84
    return (
        -t18*t30 + t31*t32,
        t18*t38 - t32*t39,
        t30*t39 - t31*t38,
        t40 - t41,
        t42 - t43,
        t44 - t45,
        2*t2*t42 - 2*t2*t43 + 2*t24*t44 - 2*t24*t45,
        landmark7*t18*t29 + 2*landmark7*t31*t8 - t29*t44 - t42*t9,
        landmark3*t17*t30 + 2*landmark7*t18*t20 - t17*t43 - t21*t44,
        2*t31*t46 - 2*t48 + 2*t51,
        2*t52 + 2*t53,
        -2*t55 + 2*t57 - 2*t60,
        -2*t61 + 2*t62 - 2*t63,
        landmark3*t32*t37 + 2*landmark7*t2*t39 - t37*t45 - t40*t64,
        2*t33*t44 - 2*t33*t45 + 2*t40*t8 - 2*t41*t8,
        landmark7*t17*t39 + 2*landmark7*t18*t35 - t17*t40 - t36*t44,
        -2*t63 - 2*t65 + 2*t66,
        2*t39*t50 + 2*t55 - 2*t57 - 2*t67,
        2*t52 + 2*t68,
        -2*t51 - 2*t69 + 2*t70,
        2*landmark7*t24*t39 + landmark7*t31*t37 - t37*t42 - t40*t71,
        landmark3*t29*t38 + 2*landmark7*t31*t33 - t29*t41 - t34*t42,
        2*t20*t40 - 2*t20*t41 + 2*t35*t42 - 2*t35*t43,
        2*t39*t50 + 2*t60 - 2*t67,
        2*t61 - 2*t62 + 2*t65 - 2*t66,
        2*t31*t46 - 2*t48 + 2*t69 - 2*t70,
        2*t53 + 2*t68,
        0,
        0,
        0,
        t73,
        t74,
        -2*t75,
        t77,
        0,
        0,
        0,
        t77,
        t78,
        t74,
        -2*t72,
        0,
        0,
        0,
        t78,
        -2*t76,
        t73,
        t74,
        -2*t2*t30 - 2*t24*t32,
        t29*t32 + t30*t9,
        -t17*t30 + t21*t32,
        t30*t81 - t32*t83,
        2*t18*t24 + 2*t2*t31,
        -t18*t29 - t31*t9,
        t17*t31 - t18*t21,
        t18*t83 - t31*t81,
        -t32*t37 + t38*t64,
        -2*t32*t33 - 2*t38*t8,
        t17*t38 + t32*t36,
        t32*t85 - t38*t81,
        t18*t37 - t39*t64,
        2*t18*t33 + 2*t39*t8,
        -t17*t39 - t18*t36,
        -t18*t85 + t39*t81,
        t30*t37 + t38*t71,
        -t29*t38 + t30*t34,
        -2*t20*t38 - 2*t30*t35,
        -t30*t85 + t38*t83,
        -t31*t37 - t39*t71,
        t29*t39 - t31*t34,
        2*t20*t39 + 2*t31*t35,
        t31*t85 - t39*t83,
        -landmark7*t37,
        -landmark7*t34,
        landmark7*t36,
        landmark7*(-pose2*t36 + t84) + t38,
        landmark3*t37,
        landmark3*t34,
        -landmark3*t36,
        -landmark3*t85 - t39,
        landmark7*t71,
        -landmark7*t29,
        -landmark7*t21,
        landmark7*(-t24*t79 + t82) + t30,
        -landmark3*t71,
        landmark3*t29,
        landmark3*t21,
        -landmark3*t83 - t31,
        -landmark7*t64,
        landmark7*t9,
        -landmark7*t17,
        landmark7*(-pose1*t9 + t80) + t32,
        landmark3*t64,
        -landmark3*t9,
        landmark3*t17,
        -landmark3*t81 - t18,
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
        pose0*prior0 + rays0*t14 + t2*t3 - t6*t7,
        pose1*prior0 + rays1*t21 + t15*t16 - t19*t3,
        pose2*prior0 + rays2*t24 - t16*t23 + t22*t7,
        prior0,
        pose0*prior1 + rays3*t14 + t2*t25 - t26*t6,
        pose1*prior1 + rays4*t21 + t15*t27 - t19*t25,
        pose2*prior1 + rays5*t24 + t22*t26 - t23*t27,
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
        pose0*prior0 + rays0*t14 + t2*t3 - t6*t7,
        pose1*prior0 + rays1*t21 + t15*t16 - t19*t3,
        pose2*prior0 + rays2*t24 - t16*t23 + t22*t7,
        prior0,
        pose0*prior1 + rays3*t14 + t2*t25 - t26*t6,
        pose1*prior1 + rays4*t21 + t15*t27 - t19*t25,
        pose2*prior1 + rays5*t24 + t22*t26 - t23*t27,
        prior1,
        prior0,
        0,
        0,
        t29 - t31 + t36,
        -t37 + t38 - t39,
        -t40 + t41 - t42,
        0,
        prior0,
        0,
        t37 - t38 - t39,
        -t29 + t31 + t36,
        -t43 + t44 - t45,
        0,
        0,
        prior0,
        t40 - t41 - t42,
        t43 - t44 - t45,
        t29 + t31 + t33 - t35,
        0,
        0,
        0,
        0,
        0,
        0,
        prior1,
        0,
        0,
        t47 - t49 + t54,
        -t55 + t56 - t57,
        -t58 + t59 - t60,
        0,
        prior1,
        0,
        t55 - t56 - t57,
        -t47 + t49 + t54,
        -t61 + t62 - t63,
        0,
        0,
        prior1,
        t58 - t59 - t60,
        t61 - t62 - t63,
        t47 + t49 + t51 - t53,
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
        pose0,
        0,
        pose1,
        0,
        pose2,
        0,
        1,
        0,
        0,
        pose0,
        0,
        pose1,
        0,
        pose2,
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
        pose0*prior0 + rays0*t14 + t2*t3 - t6*t7,
        pose1*prior0 + rays1*t21 + t15*t16 - t19*t3,
        pose2*prior0 + rays2*t24 - t16*t23 + t22*t7,
        prior0,
        pose0*prior1 + rays3*t14 + t2*t25 - t26*t6,
        pose1*prior1 + rays4*t21 + t15*t27 - t19*t25,
        pose2*prior1 + rays5*t24 + t22*t26 - t23*t27,
        prior1,
        prior0,
        0,
        0,
        t29,
        t30,
        t32,
        -2*t33,
        0,
        prior0,
        0,
        t34,
        -2*t31,
        t30,
        t29,
        0,
        0,
        prior0,
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
        prior1,
        0,
        0,
        t36,
        t37,
        t39,
        -2*t40,
        0,
        prior1,
        0,
        t41,
        -2*t38,
        t37,
        t36,
        0,
        0,
        prior1,
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
        pose0,
        0,
        pose1,
        0,
        pose2,
        0,
        1,
        0,
        0,
        pose0,
        0,
        pose1,
        0,
        pose2,
        0,
        1,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    abscissa, = abscissa
    t0 = abscissa*landmark3
    t1 = landmark7*(abscissa - 1)
    return (
        -landmark0*t1 + landmark4*t0,
        -landmark1*t1 + landmark5*t0,
        -landmark2*t1 + landmark6*t0,
        landmark3*landmark7,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    abscissa, = abscissa
    t0 = abscissa*landmark4
    t1 = abscissa - 1
    t2 = landmark7*t1
    t3 = abscissa*landmark3
    t4 = -t2
    return (
        -landmark0*t2 + landmark3*t0,
        -landmark1*t2 + landmark5*t3,
        -landmark2*t2 + landmark6*t3,
        landmark3*landmark7,
        t4,
        0,
        0,
        t0,
        t3,
        0,
        0,
        -landmark0*t1,
        0,
        t4,
        0,
        abscissa*landmark5,
        0,
        t3,
        0,
        -landmark1*t1,
        0,
        0,
        t4,
        abscissa*landmark6,
        0,
        0,
        t3,
        -landmark2*t1,
        0,
        0,
        0,
        landmark7,
        0,
        0,
        0,
        landmark3,
        -landmark0*landmark7 + landmark3*landmark4,
        -landmark1*landmark7 + landmark3*landmark5,
        -landmark2*landmark7 + landmark3*landmark6,
        0,
    )
