"""Generated from slamlib/landmarks/fhm_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "eee313138177bf3b",
    "from_frame": "980c3cc2c57a04db",
    "to_point": "574c99eaf65ddaca",
}
SHAPES = {
    "to_frame": (4,),
    "from_frame": (10,),
    "to_point": (3,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = landmark3*landmark4
    t3 = landmark5*landmark6
    t4 = landmark3*landmark6
    t5 = landmark4*landmark5
    t6 = 2*landmark7
    t7 = landmark5*landmark5
    t8 = landmark4*landmark4
    t9 = -t8
    t10 = landmark3*landmark3
    t11 = landmark6*landmark6
    t12 = t10 - t11
    t13 = landmark8*(t12 + t7 + t9) + landmark9*(landmark1 - pose1) - 2*t2 + 2*t3 + t6*(t4 + t5)
    t14 = 2*t13
    t15 = pose3*pose5
    t16 = pose4*pose6
    t17 = -t7
    t18 = 2*landmark8
    t19 = landmark3*landmark5
    t20 = landmark4*landmark6
    t21 = landmark9*(landmark2 - pose2) + t10 + t11 + t17 + t18*(t2 + t3) - t6*(t19 - t20) + t9
    t22 = 2*t21
    t23 = pose4*pose4
    t24 = pose5*pose5
    t25 = -t24
    t26 = pose3*pose3
    t27 = pose6*pose6
    t28 = t26 - t27
    t29 = landmark7*(t12 + t17 + t8) + landmark9*(landmark0 - pose0) - t18*(t4 - t5) + 2*t19 + 2*t20
    t30 = pose3*pose4
    t31 = pose5*pose6
    t32 = 2*t29
    t33 = -t23
    return (
        t14*(t0 + t1) - t22*(t15 - t16) + t29*(t23 + t25 + t28),
        t13*(t24 + t28 + t33) + t22*(t30 + t31) - t32*(t0 - t1),
        -t14*(t30 - t31) + t21*(t25 + t26 + t27 + t33) + t32*(t15 + t16),
        landmark9,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark3*landmark4
    t4 = landmark5*landmark6
    t5 = landmark1 - pose1
    t6 = landmark3*landmark6
    t7 = landmark4*landmark5
    t8 = t6 + t7
    t9 = 2*landmark7
    t10 = landmark5*landmark5
    t11 = landmark4*landmark4
    t12 = -t11
    t13 = landmark3*landmark3
    t14 = landmark6*landmark6
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = landmark8*t16 + landmark9*t5 - 2*t3 + 2*t4 + t8*t9
    t18 = 2*t17
    t19 = pose3*pose5
    t20 = pose4*pose6
    t21 = t19 - t20
    t22 = landmark3*landmark5
    t23 = landmark4*landmark6
    t24 = t22 - t23
    t25 = -t10
    t26 = landmark2 - pose2
    t27 = t3 + t4
    t28 = 2*landmark8
    t29 = landmark9*t26 + t12 + t13 + t14 + t25 + t27*t28
    t30 = -t24*t9 + t29
    t31 = 2*t30
    t32 = pose4*pose4
    t33 = pose5*pose5
    t34 = -t33
    t35 = pose3*pose3
    t36 = pose6*pose6
    t37 = t35 - t36
    t38 = t32 + t34 + t37
    t39 = t6 - t7
    t40 = t11 + t15 + t25
    t41 = landmark0 - pose0
    t42 = landmark7*t40 + landmark9*t41 + 2*t22 + 2*t23
    t43 = -t28*t39 + t42
    t44 = pose3*pose4
    t45 = pose5*pose6
    t46 = t44 + t45
    t47 = t0 - t1
    t48 = 2*t43
    t49 = -t32
    t50 = t33 + t37 + t49
    t51 = t44 - t45
    t52 = t19 + t20
    t53 = t34 + t35 + t36 + t49
    t54 = landmark9*t38
    t55 = 2*landmark9
    t56 = t2*t55
    t57 = t21*t55
    t58 = pose6*t17
    t59 = pose3*t43 - pose5*t30 + t58
    t60 = pose4*t59
    t61 = -t24*t9 + t29
    t62 = -pose4*t17
    t63 = -t28*t39 + t42
    t64 = pose3*t61 + pose5*t63 + t62
    t65 = pose3*t17
    t66 = pose4*t30 - pose6*t43 + t65
    t67 = pose4*t43 + pose5*t17 + pose6*t30
    t68 = -pose3*t67
    t69 = pose5*t66 + t68
    t70 = -pose4*t66 + pose5*t59 + pose6*t67
    t71 = pose3*t30 + pose5*t43 + t62
    t72 = pose4*t71 + pose5*t67 - pose6*t59
    t73 = t47*t55
    t74 = landmark9*t50
    t75 = t46*t55
    t76 = pose3*t63 - pose5*t61 + t58
    t77 = pose6*t71
    t78 = pose4*t67 - pose5*t71 + pose6*t66
    t79 = t52*t55
    t80 = t51*t55
    t81 = landmark9*t53
    t82 = pose4*t61 - pose6*t63 + t65
    t83 = landmark4*landmark7 + landmark5*landmark8 + landmark6
    t84 = 2*t83
    t85 = landmark3*landmark7 + landmark5 - landmark6*landmark8
    t86 = 2*t85
    t87 = landmark3 + landmark4*landmark8 - landmark5*landmark7
    t88 = t2*t84 + t21*t86 + t38*t87
    t89 = 2*t2
    t90 = landmark3*landmark8 - landmark4 + landmark6*landmark7
    t91 = 2*t21
    t92 = -t38*t83 + t87*t89 + t90*t91
    t93 = t38*t85 - t87*t91 + t89*t90
    t94 = -t2*t86 + t21*t84 + t38*t90
    t95 = 2*t46
    t96 = t47*t84 + t50*t87 - t90*t95
    t97 = 2*t47
    t98 = t46*t84 + t50*t85 + t90*t97
    t99 = t46*t86 - t50*t83 + t87*t97
    t100 = -t47*t86 + t50*t90 + t87*t95
    t101 = 2*t51
    t102 = t101*t87 + t52*t84 + t53*t90
    t103 = 2*t52
    t104 = -t103*t87 + t51*t84 + t53*t85
    t105 = t103*t90 + t51*t86 - t53*t83
    t106 = -t101*t90 + t52*t86 + t53*t87
    return (
        t18*t2 - t21*t31 + t38*t43,
        t17*t50 + t31*t46 - t47*t48,
        -t18*t51 + t30*t53 + t48*t52,
        landmark9,
        -t54,
        -t56,
        t57,
        -pose6*t64 - t60 - t69,
        -pose3*t64 - t70,
        pose3*t66 + t72,
        t73,
        -t74,
        -t75,
        pose3*t71 + t70,
        -pose4*t76 - t69 - t77,
        -pose3*t76 - t78,
        -t79,
        t80,
        -t81,
        -pose3*t82 - t72,
        pose3*t59 + t78,
        -pose5*t82 - t60 - t68 - t77,
        0,
        0,
        0,
        0,
        0,
        0,
        t54,
        t56,
        -t57,
        -landmark3*t92 - landmark4*t93 + landmark5*t94 + landmark6*t88,
        landmark3*t88 - landmark4*t94 - landmark5*t93 + landmark6*t92,
        -landmark3*t94 - landmark4*t88 - landmark5*t92 - landmark6*t93,
        4*t2*t8 + 4*t21*t24 + t38*t40,
        2*t16*t2 - 2*t27*t91 - 2*t38*t39,
        -t26*t91 + t38*t41 + t5*t89,
        -t73,
        t74,
        t75,
        -landmark3*t96 - landmark4*t100 - landmark5*t98 - landmark6*t99,
        -landmark3*t99 + landmark4*t98 - landmark5*t100 + landmark6*t96,
        landmark3*t98 + landmark4*t99 - landmark5*t96 - landmark6*t100,
        -2*t24*t95 - 2*t40*t47 + 2*t50*t8,
        t16*t50 + 4*t27*t46 + 4*t39*t47,
        t26*t95 - t41*t97 + t5*t50,
        t79,
        -t80,
        t81,
        landmark3*t102 - landmark4*t106 + landmark5*t105 - landmark6*t104,
        -landmark3*t104 - landmark4*t105 - landmark5*t106 - landmark6*t102,
        -landmark3*t105 + landmark4*t104 + landmark5*t102 - landmark6*t106,
        -2*t101*t8 - 2*t24*t53 + 2*t40*t52,
        -2*t103*t39 - 2*t16*t51 + 2*t27*t53,
        -t101*t5 + t103*t41 + t26*t53,
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


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark3*landmark4
    t4 = landmark5*landmark6
    t5 = landmark1 - pose1
    t6 = landmark3*landmark6
    t7 = landmark4*landmark5
    t8 = t6 + t7
    t9 = 2*landmark7
    t10 = landmark5*landmark5
    t11 = landmark4*landmark4
    t12 = -t11
    t13 = landmark3*landmark3
    t14 = landmark6*landmark6
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = landmark8*t16 + landmark9*t5 - 2*t3 + 2*t4 + t8*t9
    t18 = 2*t17
    t19 = pose3*pose5
    t20 = pose4*pose6
    t21 = t19 - t20
    t22 = -t10
    t23 = landmark2 - pose2
    t24 = t3 + t4
    t25 = 2*landmark8
    t26 = landmark3*landmark5
    t27 = landmark4*landmark6
    t28 = t26 - t27
    t29 = landmark9*t23 + t12 + t13 + t14 + t22 + t24*t25 - t28*t9
    t30 = 2*t29
    t31 = pose4*pose4
    t32 = pose5*pose5
    t33 = -t32
    t34 = pose3*pose3
    t35 = pose6*pose6
    t36 = t34 - t35
    t37 = t31 + t33 + t36
    t38 = landmark0 - pose0
    t39 = t6 - t7
    t40 = t11 + t15 + t22
    t41 = landmark7*t40 + landmark9*t38 - t25*t39 + 2*t26 + 2*t27
    t42 = pose3*pose4
    t43 = pose5*pose6
    t44 = t42 + t43
    t45 = t0 - t1
    t46 = 2*t41
    t47 = -t31
    t48 = t32 + t36 + t47
    t49 = t42 - t43
    t50 = t19 + t20
    t51 = t33 + t34 + t35 + t47
    t52 = landmark9*t37
    t53 = 2*landmark9
    t54 = t2*t53
    t55 = t21*t53
    t56 = pose3*t41 - pose5*t29 + pose6*t17
    t57 = 2*t56
    t58 = 2*pose4*t41 + 2*pose5*t17 + 2*pose6*t29
    t59 = pose3*t29 - pose4*t17 + pose5*t41
    t60 = pose3*t17 + pose4*t29 - pose6*t41
    t61 = 2*t60
    t62 = t45*t53
    t63 = landmark9*t48
    t64 = t44*t53
    t65 = 2*t59
    t66 = t50*t53
    t67 = t49*t53
    t68 = landmark9*t51
    t69 = landmark3 + landmark4*landmark8 - landmark5*landmark7
    t70 = 2*t21
    t71 = landmark3*landmark8 - landmark4 + landmark6*landmark7
    t72 = 2*t2
    t73 = landmark3*landmark7 + landmark5 - landmark6*landmark8
    t74 = landmark4*landmark7 + landmark5*landmark8 + landmark6
    t75 = 2*t44
    t76 = 2*t45
    t77 = 2*t50
    t78 = 2*t49
    return (
        t18*t2 - t21*t30 + t37*t41,
        t17*t48 + t30*t44 - t45*t46,
        -t18*t49 + t29*t51 + t46*t50,
        landmark9,
        -t52,
        -t54,
        t55,
        t57,
        t58,
        -2*t59,
        t61,
        t62,
        -t63,
        -t64,
        t61,
        t65,
        t58,
        -2*t56,
        -t66,
        t67,
        -t68,
        t65,
        -2*t60,
        t57,
        t58,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t52,
        t54,
        -t55,
        2*t37*t73 - 2*t69*t70 + 2*t71*t72,
        2*t37*t74 - 2*t69*t72 - 2*t70*t71,
        2*t37*t69 + 2*t70*t73 + 2*t72*t74,
        4*t2*t73 - 2*t37*t71 - 2*t70*t74,
        4*t2*t8 + 4*t21*t28 + t37*t40,
        2*t16*t2 - 2*t24*t70 - 2*t37*t39,
        -t23*t70 + t37*t38 + t5*t72,
        -t62,
        t63,
        t64,
        2*t48*t71 + 2*t69*t75 - 2*t73*t76,
        4*t44*t71 - 2*t48*t69 - 2*t74*t76,
        2*t48*t74 - 2*t69*t76 - 2*t73*t75,
        2*t48*t73 + 2*t71*t76 + 2*t74*t75,
        -2*t28*t75 - 2*t40*t45 + 2*t48*t8,
        t16*t48 + 4*t24*t44 + 4*t39*t45,
        t23*t75 - t38*t76 + t48*t5,
        t66,
        -t67,
        t68,
        2*t51*t69 - 2*t71*t78 + 2*t73*t77,
        2*t51*t71 + 2*t69*t78 + 2*t74*t77,
        4*t50*t69 - 2*t51*t73 - 2*t74*t78,
        2*t51*t74 - 2*t71*t77 - 2*t73*t78,
        -2*t28*t51 + 2*t40*t50 - 2*t78*t8,
        -2*t16*t49 + 2*t24*t51 - 2*t39*t77,
        t23*t51 + t38*t77 - t5*t78,
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
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/(point2)
    return (
        pose0,
        pose1,
        pose2,
        pose3,
        pose4,
        pose5,
        pose6,
        point0*t0,
        point1*t0,
        point3*t0,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/(point2)
    t1 = 1/(point2*point2)
    return (
        pose0,
        pose1,
        pose2,
        pose3,
        pose4,
        pose5,
        pose6,
        point0*t0,
        point1*t0,
        point3*t0,
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
        t0,
        0,
        -point0*t1,
        0,
        0,
        t0,
        -point1*t1,
        0,
        0,
        0,
        -point3*t1,
        t0,
    )


def from_frame_storage_jac(pose, point):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/(point2)
    t1 = 1/(point2*point2)
    return (
        pose0,
        pose1,
        pose2,
        pose3,
        pose4,
        pose5,
        pose6,
        point0*t0,
        point1*t0,
        point3*t0,
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
        t0,
        0,
        -point0*t1,
        0,
        0,
        t0,
        -point1*t1,
        0,
        0,
        0,
        -point3*t1,
        t0,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = 1/(landmark9)
    t1 = landmark3*landmark5
    t2 = landmark4*landmark6
    t3 = landmark3*landmark6
    t4 = landmark4*landmark5
    t5 = 2*landmark8
    t6 = landmark4*landmark4
    t7 = landmark5*landmark5
    t8 = -t7
    t9 = landmark3*landmark3
    t10 = landmark6*landmark6
    t11 = -t10 + t9
    t12 = landmark3*landmark4
    t13 = landmark5*landmark6
    t14 = 2*landmark7
    t15 = -t6
    return (
        landmark0 + t0*(landmark7*(t11 + t6 + t8) + 2*t1 + 2*t2 - t5*(t3 - t4)),
        landmark1 + t0*(landmark8*(t11 + t15 + t7) - 2*t12 + 2*t13 + t14*(t3 + t4)),
        landmark2 + t0*(t10 - t14*(t1 - t2) + t15 + t5*(t12 + t13) + t8 + t9),
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = 1/(landmark9)
    t1 = landmark3*landmark5
    t2 = landmark4*landmark6
    t3 = landmark3*landmark6
    t4 = landmark4*landmark5
    t5 = t3 - t4
    t6 = 2*landmark8
    t7 = landmark4*landmark4
    t8 = landmark5*landmark5
    t9 = -t8
    t10 = landmark3*landmark3
    t11 = landmark6*landmark6
    t12 = t10 - t11
    t13 = t12 + t7 + t9
    t14 = landmark7*t13 + 2*t1 + 2*t2 - t5*t6
    t15 = landmark3*landmark4
    t16 = landmark5*landmark6
    t17 = t3 + t4
    t18 = 2*landmark7
    t19 = -t7
    t20 = t12 + t19 + t8
    t21 = landmark8*t20 - 2*t15 + 2*t16 + t17*t18
    t22 = t15 + t16
    t23 = t1 - t2
    t24 = t10 + t11 - t18*t23 + t19 + t22*t6 + t9
    t25 = landmark3*landmark8 - landmark4 + landmark6*landmark7
    t26 = landmark5*t25
    t27 = landmark3*landmark7 + landmark5 - landmark6*landmark8
    t28 = landmark4*t27
    t29 = landmark4*landmark7 + landmark5*landmark8 + landmark6
    t30 = landmark3*t29
    t31 = landmark3 + landmark4*landmark8 - landmark5*landmark7
    t32 = landmark6*t31
    t33 = t30 + t32
    t34 = landmark6*t29
    t35 = landmark3*t31
    t36 = landmark4*t25 + landmark5*t27
    t37 = landmark3*t25
    t38 = landmark5*t29
    t39 = landmark4*t31 + landmark6*t27
    t40 = 2*t0
    t41 = 1/(landmark9*landmark9)
    t42 = landmark4*t29
    t43 = landmark3*t27
    t44 = landmark5*t31 + landmark6*t25
    return (
        landmark0 + t0*t14,
        landmark1 + t0*t21,
        landmark2 + t0*t24,
        1,
        0,
        0,
        t0*(t26 - t28 + t33),
        t0*(-t34 + t35 - t36),
        t0*(-t37 + t38 - t39),
        t0*t13,
        -t40*t5,
        -t14*t41,
        0,
        1,
        0,
        t0*(t34 - t35 - t36),
        t0*(-t26 + t28 + t33),
        t0*(-t42 + t43 - t44),
        t17*t40,
        t0*t20,
        -t21*t41,
        0,
        0,
        1,
        t0*(t37 - t38 - t39),
        t0*(t42 - t43 - t44),
        t0*(t26 + t28 + t30 - t32),
        -t23*t40,
        t22*t40,
        -t24*t41,
    )


def to_point_storage_jac(landmark):
    """to_point: value and derivatives by stored numbers."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = 1/(landmark9)
    t1 = landmark3*landmark5
    t2 = landmark4*landmark6
    t3 = landmark3*landmark6
    t4 = landmark4*landmark5
    t5 = t3 - t4
    t6 = 2*landmark8
    t7 = landmark4*landmark4
    t8 = landmark5*landmark5
    t9 = -t8
    t10 = landmark3*landmark3
    t11 = landmark6*landmark6
    t12 = t10 - t11
    t13 = t12 + t7 + t9
    t14 = landmark7*t13 + 2*t1 + 2*t2 - t5*t6
    t15 = landmark3*landmark4
    t16 = landmark5*landmark6
    t17 = t3 + t4
    t18 = 2*landmark7
    t19 = -t7
    t20 = t12 + t19 + t8
    t21 = landmark8*t20 - 2*t15 + 2*t16 + t17*t18
    t22 = t15 + t16
    t23 = t1 - t2
    t24 = t10 + t11 - t18*t23 + t19 + t22*t6 + t9
    t25 = 2*t0
    t26 = t25*(landmark3*landmark7 + landmark5 - landmark6*landmark8)
    t27 = t25*(landmark4*landmark7 + landmark5*landmark8 + landmark6)
    t28 = t25*(landmark3 + landmark4*landmark8 - landmark5*landmark7)
    t29 = t25*(landmark3*landmark8 - landmark4 + landmark6*landmark7)
    t30 = 1/(landmark9*landmark9)
    return (
        landmark0 + t0*t14,
        landmark1 + t0*t21,
        landmark2 + t0*t24,
        1,
        0,
        0,
        t26,
        t27,
        t28,
        -t29,
        t0*t13,
        -t25*t5,
        -t14*t30,
        0,
        1,
        0,
        t29,
        -t28,
        t27,
        t26,
        t17*t25,
        t0*t20,
        -t21*t30,
        0,
        0,
        1,
        t28,
        t29,
        -t26,
        t27,
        -t23*t25,
        t22*t25,
        -t24*t30,
    )
