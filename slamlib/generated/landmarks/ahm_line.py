"""Generated from slamlib/landmarks/ahm_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "7a8bf7340249d6ca",
    "from_frame": "01d7933d32df8a0f",
    "point_at": "5946f368a1a8c85f",
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
    t0 = pose3*pose4
    t1 = t0 + t0
    t2 = pose5*pose6
    t3 = t2 + t2
    t4 = t1 - t3
    t5 = landmark1 - pose1
    t6 = landmark4 + landmark6*t5
    t7 = landmark2 - pose2
    t8 = landmark5 + landmark6*t7
    t9 = pose6*pose6
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose4*pose4
    t14 = t12 - t13
    t15 = t9 + t11 + t14
    t16 = pose3*pose5
    t17 = pose4*pose6
    t18 = t16 + t17
    t19 = landmark0 - pose0
    t20 = landmark3 + landmark6*t19
    t21 = t20 + t20
    t22 = -t4*t6 + t15*t8 + t18*t21
    t23 = landmark10*t7 + landmark9
    t24 = t1 + t3
    t25 = pose3*pose6
    t26 = pose4*pose5
    t27 = t25 - t26
    t28 = landmark10*t19 + landmark7
    t29 = t28 + t28
    t30 = landmark10*t5 + landmark8
    t31 = -t9
    t32 = t10 + t14 + t31
    t33 = t23*t24 - t27*t29 + t30*t32
    t34 = t24*t8 - t21*t27 + t32*t6
    t35 = -t30*t4 + t15*t23 + t18*t29
    t36 = t16 + t16
    t37 = t17 + t17
    t38 = t36 - t37
    t39 = t11 + t12 + t13 + t31
    t40 = t25 + t25
    t41 = t26 + t26
    t42 = t40 + t41
    t43 = -t23*t38 + t28*t39 + t30*t42
    t44 = -t38*t8 + t42*t6 + t20*t39
    return (
        -t22*t33 + t34*t35,
        t22*t43 - t35*t44,
        t33*t44 - t34*t43,
        -landmark10*t44 + landmark6*t43,
        -landmark10*t34 + landmark6*t33,
        -landmark10*t22 + landmark6*t35,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    t0 = pose5*pose6
    t1 = t0 + t0
    t2 = pose3*pose4
    t3 = t2 + t2
    t4 = -t1 + t3
    t5 = landmark1 - pose1
    t6 = landmark4 + landmark6*t5
    t7 = t4*t6
    t8 = landmark2 - pose2
    t9 = landmark5 + landmark6*t8
    t10 = pose6*pose6
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose4*pose4
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = t16*t9
    t18 = pose3*pose5
    t19 = pose4*pose6
    t20 = t18 + t19
    t21 = landmark0 - pose0
    t22 = landmark3 + landmark6*t21
    t23 = t22 + t22
    t24 = t20*t23
    t25 = -t7 + t17 + t24
    t26 = landmark10*t8 + landmark9
    t27 = t0 + t2
    t28 = t27 + t27
    t29 = t26*t28
    t30 = pose3*pose6
    t31 = pose4*pose5
    t32 = t30 - t31
    t33 = landmark10*t21 + landmark7
    t34 = t33 + t33
    t35 = t32*t34
    t36 = landmark10*t5 + landmark8
    t37 = -t10
    t38 = t11 + t15 + t37
    t39 = t36*t38
    t40 = t29 - t35 + t39
    t41 = t28*t9
    t42 = t23*t32
    t43 = t38*t6
    t44 = t41 - t42 + t43
    t45 = t20*t34
    t46 = t36*t4
    t47 = t16*t26
    t48 = t45 - t46 + t47
    t49 = t25*t40 - t44*t48
    t50 = -t49
    t51 = t30 + t30
    t52 = t31 + t31
    t53 = t51 + t52
    t54 = t36*t53
    t55 = t18 - t19
    t56 = t55 + t55
    t57 = t26*t56
    t58 = t12 + t13 + t14 + t37
    t59 = t33*t58
    t60 = t54 - t57 + t59
    t61 = t53*t6
    t62 = t56*t9
    t63 = t22*t58
    t64 = t61 - t62 + t63
    t65 = t25*t60 - t48*t64
    t66 = -t40*t64 + t44*t60
    t67 = -t66
    t68 = landmark10*t64
    t69 = -landmark6*t60 + t68
    t70 = -t69
    t71 = landmark10*t44
    t72 = -landmark6*t40 + t71
    t73 = -t72
    t74 = landmark10*t25
    t75 = -landmark6*t48 + t74
    t76 = -t75
    t77 = landmark6 + landmark6
    t78 = t20 + t20
    t79 = t32 + t32
    t80 = -t77*t20*t40 - t77*t32*t48 + t71*t78 + t74*t79
    t81 = landmark6*t40
    t82 = landmark6*t48
    t83 = t4*t71 - t4*t81 + t38*t74 - t38*t82
    t84 = -t16*t71 + t16*t81 + t28*t74 - t28*t82
    t85 = landmark6*t60
    t86 = -t58*t74 + t58*t82 + t68*t78 - t78*t85
    t87 = t4*t68 - t4*t85 + t53*t74 - t53*t82
    t88 = t16*t68 - t16*t85 + t56*t74 - t56*t82
    t89 = t58*t71 - t58*t81 + t68*t79 - t79*t85
    t90 = -t38*t68 + t38*t85 + t53*t71 - t53*t81
    t91 = -t77*t27*t60 - t77*t40*t55 + t28*t68 + t56*t71
    t92 = -t4*t5 + t16*t8 + t21*t78
    t93 = t28*t8 - t21*t79 + t38*t5
    t94 = -t56*t8 + t21*t58 + t5*t53
    return (
        t50,
        t65,
        t67,
        t70,
        t73,
        t76,
        -t80,
        t83,
        t84,
        0,
        t66,
        t65,
        t86,
        -t87,
        t88,
        t67,
        0,
        t49,
        t89,
        t90,
        -t91,
        -t65,
        t50,
        0,
        0,
        0,
        0,
        0,
        t75,
        t73,
        0,
        0,
        0,
        t76,
        0,
        t69,
        0,
        0,
        0,
        t72,
        t70,
        0,
        t80,
        -t83,
        -t84,
        -t40*t78 - t48*t79,
        t4*t40 + t38*t48,
        -t16*t40 + t28*t48,
        -t40*t92 + t48*t93,
        t25*t79 + t44*t78,
        -t4*t44 - t25*t38,
        t16*t44 - t25*t28,
        -t25*t93 + t44*t92,
        -t86,
        t87,
        -t88,
        -t48*t58 + t60*t78,
        -t4*t60 - t48*t53,
        t16*t60 + t48*t56,
        -t48*t94 + t60*t92,
        t25*t58 - t64*t78,
        t4*t64 + t25*t53,
        -t16*t64 - t25*t56,
        t25*t94 - t64*t92,
        -t89,
        -t90,
        t91,
        t40*t58 + t60*t79,
        -t38*t60 + t40*t53,
        -t28*t60 - t40*t56,
        t40*t94 - t60*t93,
        -t44*t58 - t64*t79,
        t38*t64 - t44*t53,
        t28*t64 + t44*t56,
        -t44*t94 + t64*t93,
        0,
        0,
        0,
        -landmark10*t58,
        -landmark10*t53,
        landmark10*t56,
        -landmark10*t94 + t54 - t57 + t59,
        landmark6*t58,
        landmark6*t53,
        -landmark6*t56,
        landmark6*t94 - t61 + t62 - t63,
        0,
        0,
        0,
        landmark10*t79,
        -landmark10*t38,
        -landmark10*t28,
        -landmark10*t93 + t29 - t35 + t39,
        -landmark6*t79,
        landmark6*t38,
        landmark6*t28,
        landmark6*t93 - t41 + t42 - t43,
        0,
        0,
        0,
        -landmark10*t78,
        landmark10*t4,
        -landmark10*t16,
        -landmark10*t92 + t45 - t46 + t47,
        landmark6*t78,
        -landmark6*t4,
        landmark6*t16,
        landmark6*t92 + t7 - t17 - t24,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose5*pose5
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose6*pose6
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 + t8
    t10 = rays2 + rays2
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = t11 - t12
    t14 = rays1 + rays1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = rays0 + rays0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = rays5 + rays5
    t26 = rays4 + rays4
    t27 = rays3 + rays3
    return (
        pose0,
        pose1,
        pose2,
        rays0*t6 + t10*t9 - t13*t14,
        rays1*t16 + t17*t18 - t10*t21,
        rays2*t22 - t18*t23 + t14*t24,
        prior0,
        rays3*t6 + t25*t9 - t13*t26,
        rays4*t16 + t17*t27 - t21*t25,
        rays5*t22 + t24*t26 - t23*t27,
        prior1,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose5*pose5
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose6*pose6
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 + t8
    t10 = rays2 + rays2
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = t11 - t12
    t14 = rays1 + rays1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = rays0 + rays0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = rays5 + rays5
    t26 = rays4 + rays4
    t27 = rays3 + rays3
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
    t64 = t13 + t13
    t65 = -t64
    t66 = t9 + t9
    t67 = t17 + t17
    t68 = t21 + t21
    t69 = -t68
    t70 = t23 + t23
    t71 = -t70
    t72 = t24 + t24
    return (
        pose0,
        pose1,
        pose2,
        rays0*t6 + t10*t9 - t13*t14,
        rays1*t16 + t17*t18 - t10*t21,
        rays2*t22 - t18*t23 + t14*t24,
        prior0,
        rays3*t6 + t25*t9 - t13*t26,
        rays4*t16 + t17*t27 - t21*t25,
        rays5*t22 + t24*t26 - t23*t27,
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
        t6,
        t65,
        t66,
        0,
        0,
        0,
        t67,
        t16,
        t69,
        0,
        0,
        0,
        t71,
        t72,
        t22,
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
        t6,
        t65,
        t66,
        0,
        0,
        0,
        t67,
        t16,
        t69,
        0,
        0,
        0,
        t71,
        t72,
        t22,
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
    t0 = landmark10*landmark6
    t1 = (abscissa - 1)*landmark10
    t2 = abscissa*landmark6
    return (
        landmark0*t0 - landmark3*t1 + landmark7*t2,
        landmark1*t0 - landmark4*t1 + landmark8*t2,
        landmark2*t0 - landmark5*t1 + landmark9*t2,
        t0,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9, landmark10 = landmark
    abscissa, = abscissa
    t0 = landmark10*landmark6
    t1 = abscissa - 1
    t2 = landmark10*t1
    t3 = abscissa*landmark7
    t4 = abscissa*landmark6
    t5 = -t2
    return (
        landmark0*t0 - landmark3*t2 + landmark6*t3,
        landmark1*t0 - landmark4*t2 + landmark8*t4,
        landmark2*t0 - landmark5*t2 + landmark9*t4,
        t0,
        t0,
        0,
        0,
        t5,
        0,
        0,
        landmark0*landmark10 + t3,
        t4,
        0,
        0,
        landmark0*landmark6 - landmark3*t1,
        0,
        t0,
        0,
        0,
        t5,
        0,
        abscissa*landmark8 + landmark1*landmark10,
        0,
        t4,
        0,
        landmark1*landmark6 - landmark4*t1,
        0,
        0,
        t0,
        0,
        0,
        t5,
        abscissa*landmark9 + landmark10*landmark2,
        0,
        0,
        t4,
        landmark2*landmark6 - landmark5*t1,
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
