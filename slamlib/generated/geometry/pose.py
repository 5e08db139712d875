"""Generated from slamlib/geometry/pose.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "from_frame": "8e968060cba70639",
    "to_frame": "c72c11f36a56f545",
    "compose": "674ef6f67e99881a",
    "inverse": "875714460303a3bc",
    "relative": "50c5049cd48612e2",
}
SHAPES = {
    "from_frame": (3,),
    "to_frame": (3,),
    "compose": (7,),
    "inverse": (7,),
    "relative": (7,),
}


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose6*pose6
    t1 = pose3*pose3
    t2 = -t0 + t1
    t3 = pose4*pose4
    t4 = pose5*pose5
    t5 = -t4
    t6 = point2 + point2
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = point1 + point1
    t10 = pose3*pose6
    t11 = pose4*pose5
    t12 = -t3
    t13 = point0 + point0
    t14 = pose3*pose4
    t15 = pose5*pose6
    return (
        (t2 + t3 + t5)*point0 + pose0 + (t7 + t8)*t6 - (t10 - t11)*t9,
        (t2 + t12 + t4)*point1 + pose1 + (t10 + t11)*t13 - (t14 - t15)*t6,
        (t0 + t12 + t5 + t1)*point2 + pose2 - (t7 - t8)*t13 + (t14 + t15)*t9,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
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
    t10 = point2 + point2
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = t11 - t12
    t14 = point1 + point1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = point0 + point0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = point0*pose6 + point1*pose3 - point2*pose4
    t26 = pose5*t25
    t27 = point0*pose3 - point1*pose6 + point2*pose5
    t28 = pose4*t27
    t29 = point0*pose4 + point1*pose5 + point2*pose6
    t30 = pose3*t29
    t31 = -point0*pose5 + point1*pose4 + point2*pose3
    t32 = pose6*t31
    t33 = t30 + t32
    t34 = pose6*t29
    t35 = pose3*t31
    t36 = pose4*t25 + pose5*t27
    t37 = pose3*t25
    t38 = pose5*t29
    t39 = pose4*t31 + pose6*t27
    t40 = pose4*t29
    t41 = pose3*t27
    t42 = pose5*t31 + pose6*t25
    t43 = t13 + t13
    t44 = t9 + t9
    t45 = t17 + t17
    t46 = t21 + t21
    t47 = t23 + t23
    t48 = t24 + t24
    return (
        point0*t6 + pose0 + t10*t9 - t13*t14,
        point1*t16 + pose1 + t17*t18 - t10*t21,
        point2*t22 + pose2 - t18*t23 + t14*t24,
        1,
        0,
        0,
        t26 - t28 + t33,
        -t34 + t35 - t36,
        -t37 + t38 - t39,
        0,
        1,
        0,
        t34 - t35 - t36,
        -t26 + t28 + t33,
        -t40 + t41 - t42,
        0,
        0,
        1,
        t37 - t38 - t39,
        t40 - t41 - t42,
        t26 + t28 + t30 - t32,
        t6,
        -t43,
        t44,
        t45,
        t16,
        -t46,
        -t47,
        t48,
        t22,
    )


def to_frame(pose, point):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = point1 - pose1
    t1 = t0 + t0
    t2 = pose3*pose6
    t3 = pose4*pose5
    t4 = point2 - pose2
    t5 = t4 + t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = point0 - pose0
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = pose4*pose4
    t15 = t8 + t8
    t16 = -t14
    t17 = pose3*pose4
    t18 = pose5*pose6
    return (
        (t2 + t3)*t1 - (t6 - t7)*t5 + (t10 + t13 + t14)*t8,
        -(t2 - t3)*t15 + (t9 + t13 + t16)*t0 + (t17 + t18)*t5,
        (t6 + t7)*t15 - (t17 - t18)*t1 + (t10 + t11 + t12 + t16)*t4,
    )


def to_frame_jac(pose, point):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = point0 - pose0
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
    t11 = point1 - pose1
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = point2 - pose2
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
    t31 = t10 + t10
    t32 = t15 + t15
    t33 = t22 + t22
    t34 = t21 + t21
    t35 = t27 + t27
    t36 = t28 + t28
    return (
        t18,
        t26,
        t30,
        -t7,
        -t31,
        t32,
        0,
        -t30,
        t26,
        t33,
        -t25,
        -t34,
        t30,
        0,
        -t18,
        -t35,
        t36,
        -t29,
        -t26,
        t18,
        0,
        t7,
        t31,
        -t32,
        -t33,
        t25,
        t34,
        t35,
        -t36,
        t29,
    )


def compose(outer, inner):
    """compose: value."""
    outer0, outer1, outer2, outer3, outer4, outer5, outer6 = outer
    inner0, inner1, inner2, inner3, inner4, inner5, inner6 = inner
    t0 = outer6*outer6
    t1 = outer3*outer3
    t2 = -t0 + t1
    t3 = outer4*outer4
    t4 = outer5*outer5
    t5 = -t4
    t6 = inner2 + inner2
    t7 = outer3*outer5
    t8 = outer4*outer6
    t9 = inner1 + inner1
    t10 = outer3*outer6
    t11 = outer4*outer5
    t12 = -t3
    t13 = inner0 + inner0
    t14 = outer3*outer4
    t15 = outer5*outer6
    return (
        (t2 + t3 + t5)*inner0 + outer0 + (t7 + t8)*t6 - (t10 - t11)*t9,
        (t2 + t12 + t4)*inner1 + outer1 + (t10 + t11)*t13 - (t14 - t15)*t6,
        (t0 + t12 + t5 + t1)*inner2 + outer2 - (t7 - t8)*t13 + (t14 + t15)*t9,
        inner3*outer3 - inner4*outer4 - inner5*outer5 - inner6*outer6,
        inner3*outer4 + inner4*outer3 - inner5*outer6 + inner6*outer5,
        inner3*outer5 + inner4*outer6 + inner5*outer3 - inner6*outer4,
        inner3*outer6 - inner4*outer5 + inner5*outer4 + inner6*outer3,
    )


def compose_jac(outer, inner):
    """compose: value and Jacobians."""
    outer0, outer1, outer2, outer3, outer4, outer5, outer6 = outer
    inner0, inner1, inner2, inner3, inner4, inner5, inner6 = inner
    t0 = outer5*outer5
    t1 = -t0
    t2 = outer3*outer3
    t3 = outer6*outer6
    t4 = t2 - t3
    t5 = outer4*outer4
    t6 = t1 + t4 + t5
    t7 = outer3*outer5
    t8 = outer4*outer6
    t9 = t7 + t8
    t10 = inner2 + inner2
    t11 = outer3*outer6
    t12 = outer4*outer5
    t13 = t11 - t12
    t14 = inner1 + inner1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = inner0 + inner0
    t19 = outer3*outer4
    t20 = outer5*outer6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = inner4*outer4
    t26 = inner3*outer3
    t27 = inner5*outer5
    t28 = inner6*outer6
    t29 = t27 + t28
    t30 = t25 - t26 + t29
    t31 = inner6*outer5
    t32 = inner5*outer6
    t33 = inner3*outer4
    t34 = inner4*outer3
    t35 = t33 + t34
    t36 = t31 - t32 + t35
    t37 = inner5*outer3
    t38 = inner6*outer4
    t39 = inner3*outer5
    t40 = inner4*outer6
    t41 = t39 + t40
    t42 = t37 - t38 + t41
    t43 = inner3*outer6
    t44 = inner4*outer5
    t45 = inner5*outer4
    t46 = inner6*outer3
    t47 = t45 + t46
    t48 = t43 - t44 + t47
    t49 = inner0*outer6 + inner1*outer3 - inner2*outer4
    t50 = outer5*t49
    t51 = inner0*outer3 - inner1*outer6 + inner2*outer5
    t52 = outer4*t51
    t53 = inner0*outer4 + inner1*outer5 + inner2*outer6
    t54 = outer3*t53
    t55 = -inner0*outer5 + inner1*outer4 + inner2*outer3
    t56 = outer6*t55
    t57 = t54 + t56
    t58 = outer6*t53
    t59 = outer3*t55
    t60 = outer4*t49 + outer5*t51
    t61 = outer3*t49
    t62 = outer5*t53
    t63 = outer4*t55 + outer6*t51
    t64 = outer4*t53
    t65 = outer3*t51
    t66 = outer5*t55 + outer6*t49
    t67 = t30*t30
    t68 = t36*t36
    t69 = t42*t42
    t70 = t48*t48
    t71 = t67 + t68 + t69 + t70
    t72 = 1/t71
    t73 = -t25 + t26 + t29
    t74 = -t31 + t32 + t35
    t75 = -t37 + t38 + t41
    t76 = -t43 + t44 + t47
    t77 = t43 + t44
    t78 = t45 - t46 + t77
    t79 = t37 + t38
    t80 = t39 - t40 + t79
    t81 = t31 + t32
    t82 = -t33 + t34 + t81
    t83 = t25 + t26
    t84 = -t27 + t28 + t83
    t85 = -t39 + t40 + t79
    t86 = -t45 + t46 + t77
    t87 = t27 - t28 + t83
    t88 = t33 - t34 + t81
    t89 = t13 + t13
    t90 = t9 + t9
    t91 = t17 + t17
    t92 = t21 + t21
    t93 = t23 + t23
    t94 = t24 + t24
    return (
        inner0*t6 + outer0 + t10*t9 - t13*t14,
        inner1*t16 + outer1 + t17*t18 - t10*t21,
        inner2*t22 + outer2 - t18*t23 + t14*t24,
        -t30,
        t36,
        t42,
        t48,
        1,
        0,
        0,
        t50 - t52 + t57,
        -t58 + t59 - t60,
        -t61 + t62 - t63,
        0,
        1,
        0,
        t58 - t59 - t60,
        -t50 + t52 + t57,
        -t64 + t65 - t66,
        0,
        0,
        1,
        t61 - t62 - t63,
        t64 - t65 - t66,
        t50 + t52 + t54 - t56,
        0,
        0,
        0,
        -(t30*t73 - t36*t74 - t42*t75 + t48*t76)*t72,
        (t30*t78 + t36*t80 + t42*t82 + t48*t84)*t72,
        (t30*t85 + t36*t86 - t42*t87 - t48*t88)*t72,
        0,
        0,
        0,
        (t30*t76 - t36*t75 + t42*t74 - t48*t73)*t72,
        -(t30*t84 + t36*t82 - t42*t80 - t48*t78)*t72,
        (t30*t88 + t36*t87 + t42*t86 + t48*t85)*t72,
        0,
        0,
        0,
        (t30*t75 + t36*t76 + t42*t73 + t48*t74)*t72,
        (t30*t82 - t36*t84 - t42*t78 + t48*t80)*t72,
        -(t30*t87 - t36*t88 + t42*t85 - t48*t86)*t72,
        t6,
        -t89,
        t90,
        0,
        0,
        0,
        t91,
        t16,
        -t92,
        0,
        0,
        0,
        -t93,
        t94,
        t22,
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
    )


def inverse(pose):
    """inverse: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose6*pose6
    t1 = pose3*pose3
    t2 = -t0 + t1
    t3 = pose4*pose4
    t4 = pose5*pose5
    t5 = -t4
    t6 = pose1 + pose1
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = pose2 + pose2
    t10 = pose3*pose5
    t11 = pose4*pose6
    t12 = -t3
    t13 = pose0 + pose0
    t14 = pose3*pose4
    t15 = pose5*pose6
    return (
        -(t2 + t3 + t5)*pose0 - (t7 + t8)*t6 + (t10 - t11)*t9,
        -(t2 + t12 + t4)*pose1 + (t7 - t8)*t13 - (t14 + t15)*t9,
        -(t0 + t12 + t5 + t1)*pose2 - (t10 + t11)*t13 + (t14 - t15)*t6,
        pose3,
        -pose4,
        -pose5,
        -pose6,
    )


def inverse_jac(pose):
    """inverse: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose5*pose5
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose6*pose6
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = t7 + t8
    t10 = pose1 + pose1
    t11 = pose3*pose5
    t12 = pose4*pose6
    t13 = t11 - t12
    t14 = pose2 + pose2
    t15 = pose0*t6 + t10*t9 - t13*t14
    t16 = -t15
    t17 = -t5
    t18 = t4 + t17 + t0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 + t20
    t22 = t7 - t8
    t23 = pose0 + pose0
    t24 = pose1*t18 + t14*t21 - t22*t23
    t25 = -t24
    t26 = t2 + t3
    t27 = t1 + t17 + t26
    t28 = t11 + t12
    t29 = t19 - t20
    t30 = pose2*t27 + t23*t28 - t10*t29
    t31 = -t30
    t32 = t9 + t9
    t33 = t13 + t13
    t34 = t22 + t22
    t35 = t21 + t21
    t36 = t28 + t28
    t37 = t29 + t29
    t38 = t26 + t5 + t0
    t39 = 1/t38
    t40 = t39 + t39
    return (
        t16,
        t25,
        t31,
        pose3,
        -pose4,
        -pose5,
        -pose6,
        -t6,
        -t32,
        t33,
        0,
        t30,
        t25,
        t34,
        -t18,
        -t35,
        t31,
        0,
        t15,
        -t36,
        t37,
        -t27,
        t24,
        t16,
        0,
        0,
        0,
        0,
        -t39*t6,
        t22*t40,
        -t28*t40,
        0,
        0,
        0,
        -t40*t9,
        -t18*t39,
        t29*t40,
        0,
        0,
        0,
        t13*t40,
        -t21*t40,
        -t27*t39,
    )


def relative(origin, pose):
    """relative: value."""
    origin0, origin1, origin2, origin3, origin4, origin5, origin6 = origin
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = origin1 - pose1
    t1 = t0 + t0
    t2 = origin3*origin6
    t3 = origin4*origin5
    t4 = origin2 - pose2
    t5 = t4 + t4
    t6 = origin3*origin5
    t7 = origin4*origin6
    t8 = origin0 - pose0
    t9 = origin5*origin5
    t10 = -t9
    t11 = origin3*origin3
    t12 = origin6*origin6
    t13 = t11 - t12
    t14 = origin4*origin4
    t15 = t8 + t8
    t16 = -t14
    t17 = origin3*origin4
    t18 = origin5*origin6
    return (
        -(t2 + t3)*t1 + (t6 - t7)*t5 - (t10 + t13 + t14)*t8,
        (t2 - t3)*t15 - (t9 + t13 + t16)*t0 - (t17 + t18)*t5,
        -(t6 + t7)*t15 + (t17 - t18)*t1 - (t10 + t11 + t12 + t16)*t4,
        origin3*pose3 + origin4*pose4 + origin5*pose5 + origin6*pose6,
        origin3*pose4 - origin4*pose3 - origin5*pose6 + origin6*pose5,
        origin3*pose5 + origin4*pose6 - origin5*pose3 - origin6*pose4,
        origin3*pose6 - origin4*pose5 + origin5*pose4 - origin6*pose3,
    )


def relative_jac(origin, pose):
    """relative: value and Jacobians."""
    origin0, origin1, origin2, origin3, origin4, origin5, origin6 = origin
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = origin0 - pose0
    t1 = origin4*origin4
    t2 = origin5*origin5
    t3 = -t2
    t4 = origin3*origin3
    t5 = origin6*origin6
    t6 = t4 - t5
    t7 = t1 + t3 + t6
    t8 = origin3*origin6
    t9 = origin4*origin5
    t10 = t8 + t9
    t11 = origin1 - pose1
    t12 = t11 + t11
    t13 = origin3*origin5
    t14 = origin4*origin6
    t15 = t13 - t14
    t16 = origin2 - pose2
    t17 = t16 + t16
    t18 = t0*t7 + t10*t12 - t15*t17
    t19 = -t18
    t20 = origin3*origin4
    t21 = origin5*origin6
    t22 = t20 + t21
    t23 = t8 - t9
    t24 = t0 + t0
    t25 = -t1
    t26 = t2 + t6 + t25
    t27 = t17*t22 - t23*t24 + t11*t26
    t28 = -t27
    t29 = t13 + t14
    t30 = t20 - t21
    t31 = t3 + t4 + t5 + t25
    t32 = t24*t29 - t12*t30 + t16*t31
    t33 = -t32
    t34 = origin3*pose3 + origin4*pose4 + origin5*pose5 + origin6*pose6
    t35 = origin3*pose4 - origin4*pose3 - origin5*pose6 + origin6*pose5
    t36 = origin3*pose5 + origin4*pose6 - origin5*pose3 - origin6*pose4
    t37 = origin3*pose6 - origin4*pose5 + origin5*pose4 - origin6*pose3
    t38 = t10 + t10
    t39 = t15 + t15
    t40 = t23 + t23
    t41 = t22 + t22
    t42 = t29 + t29
    t43 = t30 + t30
    t44 = t36*t36
    t45 = t37*t37
    t46 = t34*t34
    t47 = t35*t35
    t48 = t46 + t47
    t49 = t44 + t45 + t48
    t50 = 1/t49
    t51 = -t44
    t52 = -t45
    t53 = t37 + t37
    t54 = t34*t53
    t55 = t36 + t36
    t56 = t35*t55
    t57 = t34*t55
    t58 = t35*t53
    t59 = t46 - t47
    t60 = t34 + t34
    t61 = t60*t35
    t62 = t36*t53
    return (
        t19,
        t28,
        t33,
        t34,
        t35,
        t36,
        t37,
        -t7,
        -t38,
        t39,
        0,
        t32,
        t28,
        t40,
        -t26,
        -t41,
        t33,
        0,
        t18,
        -t42,
        t43,
        -t31,
        t27,
        t19,
        0,
        0,
        0,
        0,
        -(t48 + t51 + t52)*t50,
        -(t54 + t56)*t50,
        (t57 - t58)*t50,
        0,
        0,
        0,
        (t54 - t56)*t50,
        -(t44 + t52 + t59)*t50,
        -(t61 + t62)*t50,
        0,
        0,
        0,
        -(t57 + t58)*t50,
        (t61 - t62)*t50,
        -(t45 + t51 + t59)*t50,
        t7,
        t38,
        -t39,
        0,
        0,
        0,
        -t40,
        t26,
        t41,
        0,
        0,
        0,
        t42,
        -t43,
        t31,
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
    )
