"""Generated from slamlib/geometry/pose.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, stumpff

DIGESTS = {
    "from_frame": "8e968060cba70639",
    "to_frame": "c72c11f36a56f545",
    "compose": "674ef6f67e99881a",
    "inverse": "875714460303a3bc",
    "relative": "50c5049cd48612e2",
    "exponential": "817b395228c65771",
    "logarithm": "94547f85750845ac",
    "adjoint": "a49a79f7e46e5734",
}
SHAPES = {
    "from_frame": (3,),
    "to_frame": (3,),
    "compose": (7,),
    "inverse": (7,),
    "relative": (7,),
    "exponential": (7,),
    "logarithm": (6,),
    "adjoint": (6, 6),
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


def exponential(twist):
    """exponential: value."""
    twist0, twist1, twist2, twist3, twist4, twist5 = twist
    t0 = twist4*twist4
    t1 = twist3*twist3
    t2 = twist5*twist5
    t3 = t1 + t0 + t2
    t4 = stumpff(3, t3)
    t5 = t0*t4
    t6 = t2*t4 - 1
    t7 = t4*twist3
    t8 = t7*twist4
    t9 = stumpff(2, t3)
    t10 = t9*twist5
    t11 = t9*twist4
    t12 = t7*twist5
    t13 = t1*t4
    t14 = t9*twist3
    t15 = t4*twist4*twist5
    t16 = t3/4
    t17 = stumpff(1, t16)/2
    return (
        -(t5 + t6)*twist0 + (t8 - t10)*twist1 + (t11 + t12)*twist2,
        (t8 + t10)*twist0 - (t6 + t13)*twist1 - (t14 - t15)*twist2,
        (-t11 + t12)*twist0 + (t14 + t15)*twist1 - (t5 + t13 - 1)*twist2,
        stumpff(0, t16),
        t17*twist3,
        t17*twist4,
        t17*twist5,
    )


def exponential_jac(twist):
    """exponential: value and Jacobians."""
    twist0, twist1, twist2, twist3, twist4, twist5 = twist
    t0 = twist3*twist3
    t1 = twist4*twist4
    t2 = twist5*twist5
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = stumpff(2, t4)
    t6 = t5*twist4
    t7 = stumpff(3, t4)
    t8 = t7*twist5
    t9 = t8*twist3
    t10 = t6 + t9
    t11 = t5*twist5
    t12 = t7*twist4
    t13 = t12*twist3
    t14 = -t11 + t13
    t15 = t1*t7
    t16 = t2*t7 - 1
    t17 = t15 + t16
    t18 = t11 + t13
    t19 = t5*twist3
    t20 = t12*twist5
    t21 = t19 - t20
    t22 = t0*t7
    t23 = t16 + t22
    t24 = t19 + t20
    t25 = -t6 + t9
    t26 = t15 + t22 - 1
    t27 = t4/4
    t28 = stumpff(0, t27)
    t29 = stumpff(1, t27)
    t30 = t29/2
    t31 = stumpff(4, t4)
    t32 = t31 - 3*stumpff(5, t4)
    t33 = t32*twist3
    t34 = t0*t32
    t35 = t34*twist4
    t36 = t31 + t31
    t37 = -t36 + t7
    t38 = t37*twist3
    t39 = t38*twist5
    t40 = t12 + t39
    t41 = t34*twist5
    t42 = t38*twist4
    t43 = t42 - t8
    t44 = t1*t32
    t45 = t7 + t7
    t46 = -t45
    t47 = t2*t32
    t48 = t46 + t47
    t49 = t44 + t48
    t50 = t44*twist3
    t51 = t7*twist3
    t52 = twist4*twist5
    t53 = t37*t52
    t54 = t51 + t53
    t55 = t33*t52 - t5
    t56 = -t37
    t57 = t32*t52*twist3 + t5
    t58 = t47*twist3
    t59 = -t51 + t53
    t60 = t34 + t48
    t61 = -t12 + t39
    t62 = t44*twist5
    t63 = t42 + t8
    t64 = t47*twist4
    t65 = t34 + t44 + t46
    t66 = t28*t28
    t67 = t29*t29
    t68 = t0*t67
    t69 = t1*t67
    t70 = t2*t67
    t71 = 4*t66 + t68 + t69 + t70
    t72 = 1/t71
    t73 = -4*t29
    t74 = stumpff(2, t27) - stumpff(3, t27)
    t75 = t0*t74
    t76 = t73 + t75
    t77 = t72/2
    t78 = t1*t74
    t79 = t73 + t78
    t80 = t29*twist5
    t81 = t67 + t67
    t82 = t81*twist3
    t83 = t28 + t28
    t84 = t83*t74
    t85 = t84*twist3
    t86 = -t82*twist4 + t85*twist4
    t87 = t82*twist5
    t88 = t85*twist5
    t89 = t2*t74
    t90 = t29*twist4
    t91 = t73 + t89
    t92 = t29*twist3
    t93 = t52*t81
    t94 = t52*t84
    return (
        t10*twist2 + t14*twist1 - t17*twist0,
        t18*twist0 - t21*twist2 - t23*twist1,
        t24*twist1 + t25*twist0 - t26*twist2,
        t28,
        t30*twist3,
        t30*twist4,
        t30*twist5,
        -t17,
        t14,
        t10,
        t3*t33*twist0 + (-t35 + t40)*twist1 - (t41 + t43)*twist2,
        t49*twist0*twist4 + (-t50 + t54)*twist1 - (t1*t37 + t55)*twist2,
        t49*twist0*twist5 - (t2*t56 + t57)*twist1 + (-t58 - t59)*twist2,
        t18,
        -t23,
        -t21,
        t60*twist1*twist3 + (-t35 - t61)*twist0 - (t0*t56 + t57)*twist2,
        (t0 + t2)*t32*twist1*twist4 - (t50 + t59)*twist0 + (-t62 + t63)*twist2,
        t60*twist1*twist5 - (t2*t37 + t55)*twist0 + (t40 - t64)*twist2,
        t25,
        t24,
        -t26,
        t65*twist2*twist3 + (-t41 + t63)*twist0 - (t0*t37 + t55)*twist1,
        t65*twist2*twist4 - (t1*t56 + t57)*twist0 + (-t43 - t62)*twist1,
        (t0 + t1)*t32*twist2*twist5 + (t54 - t58)*twist0 - (t61 + t64)*twist1,
        0,
        0,
        0,
        (-t28*t76 + t68)*t72,
        (t1*t29*t74*twist5 - t79*t80 - t86)*t77,
        -(-t87 + t88 + t89*t90 - t90*t91)*t77,
        0,
        0,
        0,
        -(t75*t80 - t76*t80 + t86)*t77,
        (-t28*t79 + t69)*t72,
        (t89*t92 - t91*t92 + t93 - t94)*t77,
        0,
        0,
        0,
        (t75*t90 - t76*t90 + t87 - t88)*t77,
        -(t78*t92 - t79*t92 - t93 + t94)*t77,
        (-t28*t91 + t70)*t72,
    )


def logarithm(pose):
    """logarithm: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose1/4
    t1 = pose4*pose4
    t2 = pose5*pose5
    t3 = pose6*pose6
    t4 = arctan_ratio(t1 + t2 + t3, pose3)
    t5 = t4 + t4
    t6 = pose4*t5
    t7 = t6*t6
    t8 = pose5*t5
    t9 = t8*t8
    t10 = pose6*t5
    t11 = t10*t10
    t12 = t7/4 + t9/4 + t11/4
    t13 = stumpff(1, t12)
    t14 = 1/t13
    t15 = (stumpff(2, t12) - stumpff(3, t12))*t14
    t16 = t15*t6
    t17 = t16*t8
    t18 = t10 + t10
    t19 = pose2/4
    t20 = t8 + t8
    t21 = t10*t16
    t22 = pose0/4
    t23 = t15*t9
    t24 = t11*t15 - 4
    t25 = t15*t7
    t26 = t6 + t6
    t27 = t10*t15*t8
    return (
        (t17 + t18)*t0 + (-t20 + t21)*t19 - (t23 + t24)*t22,
        -(t24 + t25)*t0 + (t26 + t27)*t19 + (t17 - t18)*t22,
        -(t26 - t27)*t0 - (t23 + t25 - 4)*t19 + (t20 + t21)*t22,
        t6,
        t8,
        t10,
    )


def logarithm_jac(pose):
    """logarithm: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose4*pose4
    t1 = pose5*pose5
    t2 = pose6*pose6
    t3 = t0 + t1 + t2
    t4 = arctan_ratio(t3, pose3)
    t5 = t4 + t4
    t6 = pose4*t5
    t7 = t6*t6
    t8 = pose5*t5
    t9 = t8*t8
    t10 = pose6*t5
    t11 = t10*t10
    t12 = t7/4 + t9/4 + t11/4
    t13 = stumpff(1, t12)
    t14 = 1/t13
    t15 = stumpff(3, t12)
    t16 = -t15 + stumpff(2, t12)
    t17 = t14*t16
    t18 = t17*t6
    t19 = t18*t8
    t20 = t10 + t10
    t21 = t19 + t20
    t22 = pose1/4
    t23 = t8 + t8
    t24 = t10*t18
    t25 = -t23 + t24
    t26 = pose2/4
    t27 = t17*t9
    t28 = t11*t17
    t29 = t28 - 4
    t30 = t27 + t29
    t31 = pose0/4
    t32 = t17*t7
    t33 = t29 + t32
    t34 = t6 + t6
    t35 = t10*t8
    t36 = t17*t35
    t37 = t34 + t36
    t38 = t19 - t20
    t39 = t34 - t36
    t40 = t27 + t32 - 4
    t41 = t23 + t24
    t42 = t15 - 3*stumpff(4, t12) + 3*stumpff(5, t12)
    t43 = t14*t6
    t44 = t35*t43
    t45 = t16*t16
    t46 = t14*t14
    t47 = t35*t46*t6
    t48 = -t42*t44 + t45*t47 + 8
    t49 = 4*t16
    t50 = t14*t45
    t51 = -t11*t42 + t11*t50
    t52 = t49 + t51
    t53 = pose2*t52
    t54 = pose0*t14
    t55 = t10*t54
    t56 = -t42*t9 + t50*t9
    t57 = t51 + t56
    t58 = 8*t16
    t59 = pose1*t48 + t43*t53 - (t57 + t58)*t55
    t60 = pose6*t59
    t61 = arctan_ratio_slope(t3, pose3)
    t62 = t61 + t61
    t63 = t60*t62
    t64 = -t16
    t65 = -t42
    t66 = t16*t47*t64 - t44*t65 + 8
    t67 = t49 + t56
    t68 = pose1*t43
    t69 = t54*t8
    t70 = t11*t65 - t28*t64 + t58
    t71 = t65*t9 - t27*t64
    t72 = pose2*t66 - t67*t68 + (t70 + t71)*t69
    t73 = pose5*t72
    t74 = t62*t73
    t75 = -t42*t7 + t50*t7
    t76 = t49 + t75
    t77 = pose1*t8
    t78 = pose2*t10
    t79 = pose0*t6
    t80 = (t76*t77 + t76*t78 - t57*t79)*t14
    t81 = t0*t62
    t82 = t4 + t81
    t83 = (pose4*t63)/16 + (-pose4*t74)/16 + (t80*t82)/16
    t84 = pose4*t80
    t85 = pose6*t62
    t86 = t2*t62
    t87 = t4 + t86
    t88 = (-pose6*t74)/16 + (t84*t85)/16 + (t59*t87)/16
    t89 = pose5*t62
    t90 = t1*t62
    t91 = t4 + t90
    t92 = (pose5*t63)/16 + (t84*t89)/16 + (-t72*t91)/16
    t93 = pose3*pose3
    t94 = t93 + t3
    t95 = 1/t94
    t96 = pose4*t95
    t97 = t84/16 + t60/16 + (-t73)/16
    t98 = pose5*t95
    t99 = pose6*t95
    t100 = t14*t8
    t101 = pose1*t10*t14
    t102 = t65*t7 - t32*t64
    t103 = pose0*t66 - t100*t53 + (t102 + t70)*t101
    t104 = pose6*t103
    t105 = t104*t62
    t106 = pose4*t62
    t107 = t75 + t51
    t108 = (-t107*t77 + t67*t78 + t67*t79)*t14
    t109 = pose5*t108
    t110 = pose2*t48 + t69*t76 - (t58 + t107)*t68
    t111 = (-pose4*t105)/16 + (t106*t109)/16 + (t110*t82)/16
    t112 = pose4*t110
    t113 = t112*t62
    t114 = (pose6*t113)/16 + (-t103*t87)/16 + (t109*t85)/16
    t115 = (-pose5*t105)/16 + (pose5*t113)/16 + (t108*t91)/16
    t116 = t112/16 + (-t104)/16 + t109/16
    t117 = t75 + t56
    t118 = (-t117*t78 + t52*t77 + t52*t79)*t14
    t119 = pose6*t118
    t120 = pose0*t48 - (t117 + t58)*pose2*t100 + t101*t67
    t121 = pose5*t120
    t122 = pose1*t66 + (t102 + t58 + t71)*pose2*t43 - t55*t76
    t123 = (t106*t119)/16 + (t106*t121)/16 + (-t122*t82)/16
    t124 = pose4*t122
    t125 = (t118*t87)/16 + (t121*t85)/16 + (-t124*t85)/16
    t126 = (t119*t89)/16 + (t120*t91)/16 + (-t124*t89)/16
    t127 = t119/16 + t121/16 + (-t124)/16
    t128 = pose3*pose5
    t129 = pose5*t96 + t106*t128
    t130 = pose3*pose4*t85 + pose6*t96
    t131 = pose6*t98 + t128*t85
    return (
        t21*t22 + t25*t26 - t30*t31,
        -t22*t33 + t26*t37 + t31*t38,
        -t22*t39 - t26*t40 + t31*t41,
        t6,
        t8,
        t10,
        (-t30)/4,
        t21/4,
        t25/4,
        pose3*t83 - pose5*t88 + pose6*t92 + t96*t97,
        pose3*t92 + pose4*t88 - pose6*t83 + t97*t98,
        pose3*t88 - pose4*t92 + pose5*t83 + t97*t99,
        t38/4,
        (-t33)/4,
        t37/4,
        pose3*t111 - pose5*t114 + pose6*t115 + t116*t96,
        pose3*t115 + pose4*t114 - pose6*t111 + t116*t98,
        pose3*t114 - pose4*t115 + pose5*t111 + t116*t99,
        t41/4,
        (-t39)/4,
        (-t40)/4,
        pose3*t123 - pose5*t125 + pose6*t126 + t127*t96,
        pose3*t126 + pose4*t125 - pose6*t123 + t127*t98,
        pose3*t125 - pose4*t126 + pose5*t123 + t127*t99,
        0,
        0,
        0,
        pose3*t82 + t0*t95,
        pose6*t81 - pose6*t82 + t129,
        -pose5*t81 + pose5*t82 + t130,
        0,
        0,
        0,
        -pose6*t90 + pose6*t91 + t129,
        pose3*t91 + t1*t95,
        pose4*t90 - pose4*t91 + t131,
        0,
        0,
        0,
        pose5*t86 - pose5*t87 + t130,
        -pose4*t86 + pose4*t87 + t131,
        pose3*t87 + t2*t95,
    )


def adjoint(pose):
    """adjoint: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose4*pose4
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = t7 - t8
    t10 = t9 + t9
    t11 = -t10
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 + t13
    t15 = t14 + t14
    t16 = t7 + t8
    t17 = pose2 + pose2
    t18 = t12 - t13
    t19 = pose1 + pose1
    t20 = -t0
    t21 = t1 + t20 + t5
    t22 = pose3*pose4
    t23 = pose5*pose6
    t24 = t22 + t23
    t25 = t2 + t20 + t3 + t4
    t26 = t22 - t23
    t27 = t16 + t16
    t28 = t26 + t26
    t29 = -t28
    t30 = pose0 + pose0
    t31 = t18 + t18
    t32 = -t31
    t33 = t24 + t24
    return (
        t6,
        t11,
        t15,
        -t16*t17 - t18*t19,
        -pose2*t21 + t19*t24,
        pose1*t25 + t17*t26,
        t27,
        t21,
        t29,
        pose2*t6 + t18*t30,
        -t17*t9 - t24*t30,
        -pose0*t25 + t14*t17,
        t32,
        t33,
        t25,
        -pose1*t6 + t16*t30,
        pose0*t21 + t19*t9,
        -t14*t19 - t26*t30,
        0,
        0,
        0,
        t6,
        t11,
        t15,
        0,
        0,
        0,
        t27,
        t21,
        t29,
        0,
        0,
        0,
        t32,
        t33,
        t25,
    )


def adjoint_jac(pose):
    """adjoint: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose4*pose4
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = t7 - t8
    t10 = t9 + t9
    t11 = -t10
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 + t13
    t15 = t14 + t14
    t16 = t7 + t8
    t17 = pose2 + pose2
    t18 = t12 - t13
    t19 = pose1 + pose1
    t20 = t16*t17 + t18*t19
    t21 = -t20
    t22 = -t0
    t23 = t1 + t22 + t5
    t24 = pose3*pose4
    t25 = pose5*pose6
    t26 = t24 + t25
    t27 = -pose2*t23 + t19*t26
    t28 = t2 + t22 + t3 + t4
    t29 = t24 - t25
    t30 = pose1*t28 + t17*t29
    t31 = t16 + t16
    t32 = t29 + t29
    t33 = -t32
    t34 = pose0 + pose0
    t35 = pose2*t6 + t18*t34
    t36 = t17*t9 + t26*t34
    t37 = -t36
    t38 = pose0*t28 - t14*t17
    t39 = -t38
    t40 = t18 + t18
    t41 = -t40
    t42 = t26 + t26
    t43 = -pose1*t6 + t16*t34
    t44 = pose0*t23 + t19*t9
    t45 = t14*t19 + t29*t34
    t46 = -t45
    t47 = -t15
    t48 = -t6
    t49 = -t31
    t50 = -t23
    t51 = -t42
    t52 = -t28
    return (
        t6,
        t11,
        t15,
        t21,
        t27,
        t30,
        t31,
        t23,
        t33,
        t35,
        t37,
        t39,
        t41,
        t42,
        t28,
        t43,
        t44,
        t46,
        0,
        0,
        0,
        t6,
        t11,
        t15,
        0,
        0,
        0,
        t31,
        t23,
        t33,
        0,
        0,
        0,
        t41,
        t42,
        t28,
        0,
        0,
        0,
        0,
        t47,
        t11,
        0,
        0,
        0,
        t15,
        0,
        t48,
        0,
        0,
        0,
        t10,
        t6,
        0,
        0,
        t41,
        t49,
        0,
        -t30,
        t27,
        0,
        t42,
        t50,
        t30,
        0,
        t20,
        0,
        t28,
        t32,
        -t27,
        t21,
        0,
        0,
        0,
        0,
        0,
        t32,
        t23,
        0,
        0,
        0,
        t33,
        0,
        t49,
        0,
        0,
        0,
        t50,
        t31,
        0,
        t40,
        0,
        t6,
        0,
        t38,
        t37,
        t51,
        0,
        t11,
        t39,
        0,
        -t35,
        t52,
        0,
        t15,
        t36,
        t35,
        0,
        0,
        0,
        0,
        0,
        t52,
        t42,
        0,
        0,
        0,
        t28,
        0,
        t40,
        0,
        0,
        0,
        t51,
        t41,
        0,
        t31,
        t48,
        0,
        0,
        t45,
        t44,
        t23,
        t10,
        0,
        t46,
        0,
        -t43,
        t33,
        t47,
        0,
        -t44,
        t43,
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
        t47,
        t11,
        0,
        0,
        0,
        t15,
        0,
        t48,
        0,
        0,
        0,
        t10,
        t6,
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
        t32,
        t23,
        0,
        0,
        0,
        t33,
        0,
        t49,
        0,
        0,
        0,
        t50,
        t31,
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
        t52,
        t42,
        0,
        0,
        0,
        t28,
        0,
        t40,
        0,
        0,
        0,
        t51,
        t41,
        0,
    )
