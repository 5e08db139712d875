"""Generated from slamlib/landmarks/fhm_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "ab67adb7dbd0c51e",
    "from_frame": "144e2d75b860c315",
    "to_point": "cdeec2a0b366a79a",
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
    t0 = landmark3*landmark3
    t1 = landmark6*landmark6
    t2 = t0 - t1
    t3 = landmark5*landmark5
    t4 = landmark4*landmark4
    t5 = -t4
    t6 = landmark3*landmark4
    t7 = t6 + t6
    t8 = landmark5*landmark6
    t9 = t8 + t8
    t10 = landmark7 + landmark7
    t11 = landmark3*landmark6
    t12 = landmark4*landmark5
    t13 = (t2 + t3 + t5)*landmark8 + (landmark1 - pose1)*landmark9 - t7 + t9 + (t11 + t12)*t10
    t14 = t13 + t13
    t15 = pose3*pose6
    t16 = pose4*pose5
    t17 = -t3
    t18 = landmark8 + landmark8
    t19 = landmark3*landmark5
    t20 = landmark4*landmark6
    t21 = (landmark2 - pose2)*landmark9 + t0 + t1 + t17 + (t6 + t8)*t18 - (t19 - t20)*t10 + t5
    t22 = t21 + t21
    t23 = pose3*pose5
    t24 = pose4*pose6
    t25 = t19 + t19
    t26 = t20 + t20
    t27 = (t2 + t17 + t4)*landmark7 + (landmark0 - pose0)*landmark9 - (t11 - t12)*t18 + t25 + t26
    t28 = pose4*pose4
    t29 = pose5*pose5
    t30 = -t29
    t31 = pose3*pose3
    t32 = pose6*pose6
    t33 = t31 - t32
    t34 = -t28
    t35 = pose3*pose4
    t36 = pose5*pose6
    t37 = t27 + t27
    return (
        (t15 + t16)*t14 - (t23 - t24)*t22 + (t28 + t30 + t33)*t27,
        (t29 + t33 + t34)*t13 + (t35 + t36)*t22 - (t15 - t16)*t37,
        -(t35 - t36)*t14 + (t30 + t31 + t32 + t34)*t21 + (t23 + t24)*t37,
        landmark9,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = landmark5*landmark5
    t1 = landmark4*landmark4
    t2 = -t1
    t3 = landmark3*landmark3
    t4 = landmark6*landmark6
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = landmark1 - pose1
    t8 = landmark3*landmark4
    t9 = t8 + t8
    t10 = landmark5*landmark6
    t11 = t10 + t10
    t12 = landmark3*landmark6
    t13 = landmark4*landmark5
    t14 = t12 + t13
    t15 = landmark7 + landmark7
    t16 = landmark8*t6 + landmark9*t7 - t9 + t11 + t14*t15
    t17 = t16 + t16
    t18 = pose3*pose6
    t19 = pose4*pose5
    t20 = t18 + t19
    t21 = pose3*pose5
    t22 = pose4*pose6
    t23 = t21 - t22
    t24 = landmark2 - pose2
    t25 = -t0
    t26 = t8 + t10
    t27 = landmark8 + landmark8
    t28 = landmark3*landmark5
    t29 = landmark4*landmark6
    t30 = t28 - t29
    t31 = landmark9*t24 + t2 + t3 + t4 + t25 + t26*t27 - t15*t30
    t32 = t31 + t31
    t33 = pose4*pose4
    t34 = pose5*pose5
    t35 = -t34
    t36 = pose3*pose3
    t37 = pose6*pose6
    t38 = t36 - t37
    t39 = t33 + t35 + t38
    t40 = t1 + t5 + t25
    t41 = landmark0 - pose0
    t42 = t12 - t13
    t43 = t28 + t28
    t44 = t29 + t29
    t45 = landmark7*t40 + landmark9*t41 - t27*t42 + t43 + t44
    t46 = t17*t20 - t23*t32 + t39*t45
    t47 = -t33
    t48 = t34 + t38 + t47
    t49 = pose3*pose4
    t50 = pose5*pose6
    t51 = t49 + t50
    t52 = t18 - t19
    t53 = t45 + t45
    t54 = t16*t48 + t32*t51 - t52*t53
    t55 = t49 - t50
    t56 = t35 + t36 + t37 + t47
    t57 = t21 + t22
    t58 = -t17*t55 + t31*t56 + t53*t57
    t59 = landmark9*t39
    t60 = landmark9 + landmark9
    t61 = t20*t60
    t62 = t23*t60
    t63 = t52*t60
    t64 = landmark9*t48
    t65 = t51*t60
    t66 = t57*t60
    t67 = t55*t60
    t68 = landmark9*t56
    t69 = landmark4*landmark7 + landmark5*landmark8 + landmark6
    t70 = landmark3 + landmark4*landmark8 - landmark5*landmark7
    t71 = t20 + t20
    t72 = landmark3*landmark8 - landmark4 + landmark6*landmark7
    t73 = t23 + t23
    t74 = -t39*t69 + t70*t71 + t72*t73
    t75 = landmark3*landmark7 + landmark5 - landmark6*landmark8
    t76 = t39*t75 - t70*t73 + t71*t72
    t77 = t75 + t75
    t78 = t69 + t69
    t79 = -t20*t77 + t23*t78 + t39*t72
    t80 = t20*t78 + t23*t77 + t39*t70
    t81 = 4*t14
    t82 = 4*t23
    t83 = t39 + t39
    t84 = t51 + t51
    t85 = t52*t78 + t48*t70 - t72*t84
    t86 = -t52*t77 + t48*t72 + t70*t84
    t87 = t52 + t52
    t88 = t51*t78 + t48*t75 + t72*t87
    t89 = t51*t77 - t48*t69 + t70*t87
    t90 = 4*t51
    t91 = t14 + t14
    t92 = 4*t42
    t93 = t55 + t55
    t94 = t57*t78 + t56*t72 + t70*t93
    t95 = t57*t77 + t56*t70 - t72*t93
    t96 = t57 + t57
    t97 = t55*t77 - t56*t69 + t72*t96
    t98 = t55*t78 + t56*t75 - t70*t96
    t99 = t56 + t56
    return (
        t46,
        t54,
        t58,
        landmark9,
        -t59,
        -t61,
        t62,
        0,
        -t58,
        t54,
        t63,
        -t64,
        -t65,
        t58,
        0,
        -t46,
        -t66,
        t67,
        -t68,
        -t54,
        t46,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t59,
        t61,
        -t62,
        -landmark3*t74 - landmark4*t76 + landmark5*t79 + landmark6*t80,
        landmark3*t80 - landmark4*t79 - landmark5*t76 + landmark6*t74,
        -landmark3*t79 - landmark4*t80 - landmark5*t74 - landmark6*t76,
        t20*t81 + t30*t82 + t39*t40,
        t6*t71 - t26*t82 - t83*t42,
        -t24*t73 + t39*t41 + t7*t71,
        -t63,
        t64,
        t65,
        -landmark3*t85 - landmark4*t86 - landmark5*t88 - landmark6*t89,
        -landmark3*t89 + landmark4*t88 - landmark5*t86 + landmark6*t85,
        landmark3*t88 + landmark4*t89 - landmark5*t85 - landmark6*t86,
        -t30*t90 - t40*t87 + t91*t48,
        t48*t6 + t26*t90 + t52*t92,
        t24*t84 - t41*t87 + t48*t7,
        t66,
        -t67,
        t68,
        landmark3*t94 - landmark4*t95 + landmark5*t97 - landmark6*t98,
        -landmark3*t98 - landmark4*t97 - landmark5*t95 - landmark6*t94,
        -landmark3*t97 + landmark4*t98 + landmark5*t94 - landmark6*t95,
        -t30*t99 + t40*t96 - t55*t81,
        -t6*t93 + t26*t99 - t57*t92,
        t24*t56 + t41*t96 - t7*t93,
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
    t0 = 1/point2
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
    t0 = 1/point2
    t1 = t0*t0
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


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = 1/landmark9
    t1 = landmark6*landmark6
    t2 = landmark3*landmark3
    t3 = -t1 + t2
    t4 = landmark4*landmark4
    t5 = landmark5*landmark5
    t6 = -t5
    t7 = landmark3*landmark5
    t8 = t7 + t7
    t9 = landmark4*landmark6
    t10 = t9 + t9
    t11 = landmark8 + landmark8
    t12 = landmark3*landmark6
    t13 = landmark4*landmark5
    t14 = -t4
    t15 = landmark3*landmark4
    t16 = t15 + t15
    t17 = landmark5*landmark6
    t18 = t17 + t17
    t19 = landmark7 + landmark7
    return (
        landmark0 + ((t3 + t4 + t6)*landmark7 + t8 + t10 - (t12 - t13)*t11)*t0,
        landmark1 + ((t3 + t14 + t5)*landmark8 - t16 + t18 + (t12 + t13)*t19)*t0,
        landmark2 + (t1 - (t7 - t9)*t19 + t14 + (t15 + t17)*t11 + t6 + t2)*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8, landmark9 = landmark
    t0 = 1/landmark9
    t1 = landmark3*landmark3
    t2 = landmark6*landmark6
    t3 = t1 - t2
    t4 = landmark4*landmark4
    t5 = landmark5*landmark5
    t6 = -t5
    t7 = t3 + t4 + t6
    t8 = landmark3*landmark5
    t9 = t8 + t8
    t10 = landmark4*landmark6
    t11 = t10 + t10
    t12 = landmark3*landmark6
    t13 = landmark4*landmark5
    t14 = t12 - t13
    t15 = landmark8 + landmark8
    t16 = landmark7*t7 + t9 + t11 - t14*t15
    t17 = -t4
    t18 = t3 + t17 + t5
    t19 = landmark3*landmark4
    t20 = t19 + t19
    t21 = landmark5*landmark6
    t22 = t21 + t21
    t23 = t12 + t13
    t24 = landmark7 + landmark7
    t25 = landmark8*t18 - t20 + t22 + t23*t24
    t26 = t8 - t10
    t27 = t19 + t21
    t28 = t1 + t2 - t24*t26 + t17 + t15*t27 + t6
    t29 = landmark3*landmark8 - landmark4 + landmark6*landmark7
    t30 = landmark5*t29
    t31 = landmark3*landmark7 + landmark5 - landmark6*landmark8
    t32 = landmark4*t31
    t33 = landmark4*landmark7 + landmark5*landmark8 + landmark6
    t34 = landmark3*t33
    t35 = landmark3 + landmark4*landmark8 - landmark5*landmark7
    t36 = landmark6*t35
    t37 = t34 + t36
    t38 = landmark6*t33
    t39 = landmark3*t35
    t40 = landmark4*t29 + landmark5*t31
    t41 = landmark3*t29
    t42 = landmark5*t33
    t43 = landmark4*t35 + landmark6*t31
    t44 = t0 + t0
    t45 = t0*t0
    t46 = landmark4*t33
    t47 = landmark3*t31
    t48 = landmark5*t35 + landmark6*t29
    return (
        landmark0 + t0*t16,
        landmark1 + t0*t25,
        landmark2 + t0*t28,
        1,
        0,
        0,
        (t30 - t32 + t37)*t0,
        -(t38 - t39 + t40)*t0,
        -(t41 - t42 + t43)*t0,
        t0*t7,
        -t14*t44,
        -t16*t45,
        0,
        1,
        0,
        -(-t38 + t39 + t40)*t0,
        (-t30 + t32 + t37)*t0,
        -(t46 - t47 + t48)*t0,
        t23*t44,
        t0*t18,
        -t25*t45,
        0,
        0,
        1,
        -(-t41 + t42 + t43)*t0,
        -(-t46 + t47 + t48)*t0,
        (t30 + t32 + t34 - t36)*t0,
        -t26*t44,
        t27*t44,
        -t28*t45,
    )
