"""Generated from slamlib/geometry/pose.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "from_frame": "42506ca9076aa673",
    "to_frame": "24fc2cebaf7669e6",
    "compose": "9ac940cd7dac52c6",
    "inverse": "f59a4f4e8764d398",
    "relative": "fb294965ca657570",
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
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = 2*point2
    t3 = pose3*pose6
    t4 = pose4*pose5
    t5 = 2*point1
    t6 = pose4*pose4
    t7 = pose5*pose5
    t8 = -t7
    t9 = pose3*pose3
    t10 = pose6*pose6
    t11 = -t10 + t9
    t12 = 2*point0
    t13 = pose3*pose4
    t14 = pose5*pose6
    t15 = -t6
    return (
        point0*(t11 + t6 + t8) + pose0 + t2*(t0 + t1) - t5*(t3 - t4),
        point1*(t11 + t15 + t7) + pose1 + t12*(t3 + t4) - t2*(t13 - t14),
        point2*(t10 + t15 + t8 + t9) + pose2 - t12*(t0 - t1) + t5*(t13 + t14),
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*point2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*point1
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*point0
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
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
    return (
        point0*t14 + pose0 + t2*t3 - t6*t7,
        point1*t21 + pose1 + t15*t16 - t19*t3,
        point2*t24 + pose2 - t16*t23 + t22*t7,
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
        t14,
        -2*t6,
        2*t2,
        2*t15,
        t21,
        -2*t19,
        -2*t23,
        2*t22,
        t24,
    )


def from_frame_storage_jac(pose, point):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*point2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*point1
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*point0
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = point0*pose3 - point1*pose6 + point2*pose5
    t26 = 2*t25
    t27 = 2*(point0*pose4 + point1*pose5 + point2*pose6)
    t28 = -point0*pose5 + point1*pose4 + point2*pose3
    t29 = 2*t28
    t30 = point0*pose6 + point1*pose3 - point2*pose4
    t31 = 2*t30
    return (
        point0*t14 + pose0 + t2*t3 - t6*t7,
        point1*t21 + pose1 + t15*t16 - t19*t3,
        point2*t24 + pose2 - t16*t23 + t22*t7,
        1,
        0,
        0,
        t26,
        t27,
        t29,
        -2*t30,
        0,
        1,
        0,
        t31,
        -2*t28,
        t27,
        t26,
        0,
        0,
        1,
        t29,
        t31,
        -2*t25,
        t27,
        t14,
        -2*t6,
        2*t2,
        2*t15,
        t21,
        -2*t19,
        -2*t23,
        2*t22,
        t24,
    )


def to_frame(pose, point):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = point1 - pose1
    t3 = 2*t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = point2 - pose2
    t7 = 2*t6
    t8 = point0 - pose0
    t9 = pose4*pose4
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose6*pose6
    t14 = t12 - t13
    t15 = pose3*pose4
    t16 = pose5*pose6
    t17 = 2*t8
    t18 = -t9
    return (
        t3*(t0 + t1) - t7*(t4 - t5) + t8*(t11 + t14 + t9),
        -t17*(t0 - t1) + t2*(t10 + t14 + t18) + t7*(t15 + t16),
        t17*(t4 + t5) - t3*(t15 - t16) + t6*(t11 + t12 + t13 + t18),
    )


def to_frame_jac(pose, point):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = point1 - pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = point2 - pose2
    t9 = 2*t8
    t10 = point0 - pose0
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t0 - t1
    t22 = 2*t10
    t23 = -t11
    t24 = t12 + t16 + t23
    t25 = t5 + t6
    t26 = t18 - t19
    t27 = t13 + t14 + t15 + t23
    t28 = 2*t2
    t29 = pose4*t10 + pose5*t3 + pose6*t8
    t30 = pose3*t10 - pose5*t8 + pose6*t3
    t31 = pose3*t3 + pose4*t8 - pose6*t10
    t32 = pose3*t8 - pose4*t3 + pose5*t10
    t33 = pose3*t29 - pose4*t30 - pose5*t31 - pose6*t32
    t34 = pose3*t32 - pose4*t31 + pose5*t30 + pose6*t29
    t35 = pose3*t31 + pose4*t32 + pose5*t29 - pose6*t30
    t36 = 2*t20
    t37 = pose3*t30 + pose4*t29 - pose5*t32 + pose6*t31
    t38 = 2*t25
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        -t17,
        -t28,
        2*t7,
        t33,
        -t34,
        t35,
        2*t21,
        -t24,
        -t36,
        t34,
        t33,
        -t37,
        -t38,
        2*t26,
        -t27,
        -t35,
        t37,
        t33,
        t17,
        t28,
        -2*t7,
        -2*t21,
        t24,
        t36,
        t38,
        -2*t26,
        t27,
    )


def to_frame_storage_jac(pose, point):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2 = point
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = point1 - pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = point2 - pose2
    t9 = 2*t8
    t10 = point0 - pose0
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t0 - t1
    t22 = 2*t10
    t23 = -t11
    t24 = t12 + t16 + t23
    t25 = t5 + t6
    t26 = t18 - t19
    t27 = t13 + t14 + t15 + t23
    t28 = 2*t2
    t29 = pose3*t10 - pose5*t8 + pose6*t3
    t30 = 2*t29
    t31 = 2*pose4*t10 + 2*pose5*t3 + 2*pose6*t8
    t32 = pose3*t8 - pose4*t3 + pose5*t10
    t33 = pose3*t3 + pose4*t8 - pose6*t10
    t34 = 2*t33
    t35 = 2*t20
    t36 = 2*t32
    t37 = 2*t25
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        -t17,
        -t28,
        2*t7,
        t30,
        t31,
        -2*t32,
        t34,
        2*t21,
        -t24,
        -t35,
        t34,
        t36,
        t31,
        -2*t29,
        -t37,
        2*t26,
        -t27,
        t36,
        -2*t33,
        t30,
        t31,
        t17,
        t28,
        -2*t7,
        -2*t21,
        t24,
        t35,
        t37,
        -2*t26,
        t27,
    )


def compose(outer, inner):
    """compose: value."""
    outer0, outer1, outer2, outer3, outer4, outer5, outer6 = outer
    inner0, inner1, inner2, inner3, inner4, inner5, inner6 = inner
    t0 = outer3*outer5
    t1 = outer4*outer6
    t2 = 2*inner2
    t3 = outer3*outer6
    t4 = outer4*outer5
    t5 = 2*inner1
    t6 = outer4*outer4
    t7 = outer5*outer5
    t8 = -t7
    t9 = outer3*outer3
    t10 = outer6*outer6
    t11 = -t10 + t9
    t12 = 2*inner0
    t13 = outer3*outer4
    t14 = outer5*outer6
    t15 = -t6
    return (
        inner0*(t11 + t6 + t8) + outer0 + t2*(t0 + t1) - t5*(t3 - t4),
        inner1*(t11 + t15 + t7) + outer1 + t12*(t3 + t4) - t2*(t13 - t14),
        inner2*(t10 + t15 + t8 + t9) + outer2 - t12*(t0 - t1) + t5*(t13 + t14),
        inner3*outer3 - inner4*outer4 - inner5*outer5 - inner6*outer6,
        inner3*outer4 + inner4*outer3 - inner5*outer6 + inner6*outer5,
        inner3*outer5 + inner4*outer6 + inner5*outer3 - inner6*outer4,
        inner3*outer6 - inner4*outer5 + inner5*outer4 + inner6*outer3,
    )


def compose_jac(outer, inner):
    """compose: value and Jacobians."""
    outer0, outer1, outer2, outer3, outer4, outer5, outer6 = outer
    inner0, inner1, inner2, inner3, inner4, inner5, inner6 = inner
    t0 = outer3*outer5
    t1 = outer4*outer6
    t2 = t0 + t1
    t3 = 2*inner2
    t4 = outer3*outer6
    t5 = outer4*outer5
    t6 = t4 - t5
    t7 = 2*inner1
    t8 = outer4*outer4
    t9 = outer5*outer5
    t10 = -t9
    t11 = outer3*outer3
    t12 = outer6*outer6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*inner0
    t17 = outer3*outer4
    t18 = outer5*outer6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = inner4*outer4
    t26 = inner5*outer5
    t27 = inner6*outer6
    t28 = t26 + t27
    t29 = -inner3*outer3 + t25 + t28
    t30 = inner6*outer5
    t31 = inner5*outer6
    t32 = inner3*outer4
    t33 = inner4*outer3
    t34 = t32 + t33
    t35 = t30 - t31 + t34
    t36 = inner5*outer3
    t37 = inner6*outer4
    t38 = inner3*outer5
    t39 = inner4*outer6
    t40 = t38 + t39
    t41 = t36 - t37 + t40
    t42 = inner3*outer6
    t43 = inner4*outer5
    t44 = inner5*outer4
    t45 = inner6*outer3
    t46 = t44 + t45
    t47 = t42 - t43 + t46
    t48 = inner0*outer6 + inner1*outer3 - inner2*outer4
    t49 = outer5*t48
    t50 = inner0*outer3 - inner1*outer6 + inner2*outer5
    t51 = outer4*t50
    t52 = inner0*outer4 + inner1*outer5 + inner2*outer6
    t53 = outer3*t52
    t54 = -inner0*outer5 + inner1*outer4 + inner2*outer3
    t55 = outer6*t54
    t56 = t53 + t55
    t57 = outer6*t52
    t58 = outer3*t54
    t59 = outer4*t48 + outer5*t50
    t60 = outer3*t48
    t61 = outer5*t52
    t62 = outer4*t54 + outer6*t50
    t63 = outer4*t52
    t64 = outer3*t50
    t65 = outer5*t54 + outer6*t48
    t66 = 1/(t29*t29 + t35*t35 + t41*t41 + t47*t47)
    t67 = inner3*outer3
    t68 = -t25 + t28 + t67
    t69 = -t42 + t43 + t46
    t70 = -t30 + t31 + t34
    t71 = -t36 + t37 + t40
    t72 = t42 + t43
    t73 = t44 - t45 + t72
    t74 = t25 + t67
    t75 = -t26 + t27 + t74
    t76 = t30 + t31
    t77 = -t32 + t33 + t76
    t78 = t36 + t37
    t79 = t38 - t39 + t78
    t80 = -t38 + t39 + t78
    t81 = -t44 + t45 + t72
    t82 = t26 - t27 + t74
    t83 = t32 - t33 + t76
    return (
        inner0*t14 + outer0 + t2*t3 - t6*t7,
        inner1*t21 + outer1 + t15*t16 - t19*t3,
        inner2*t24 + outer2 - t16*t23 + t22*t7,
        -t29,
        t35,
        t41,
        t47,
        1,
        0,
        0,
        t49 - t51 + t56,
        -t57 + t58 - t59,
        -t60 + t61 - t62,
        0,
        1,
        0,
        t57 - t58 - t59,
        -t49 + t51 + t56,
        -t63 + t64 - t65,
        0,
        0,
        1,
        t60 - t61 - t62,
        t63 - t64 - t65,
        t49 + t51 + t53 - t55,
        0,
        0,
        0,
        t66*(-t29*t68 + t35*t70 + t41*t71 - t47*t69),
        t66*(t29*t73 + t35*t79 + t41*t77 + t47*t75),
        t66*(t29*t80 + t35*t81 - t41*t82 - t47*t83),
        0,
        0,
        0,
        t66*(t29*t69 - t35*t71 + t41*t70 - t47*t68),
        t66*(-t29*t75 - t35*t77 + t41*t79 + t47*t73),
        t66*(t29*t83 + t35*t82 + t41*t81 + t47*t80),
        0,
        0,
        0,
        t66*(t29*t71 + t35*t69 + t41*t68 + t47*t70),
        t66*(t29*t77 - t35*t75 - t41*t73 + t47*t79),
        t66*(-t29*t82 + t35*t83 - t41*t80 + t47*t81),
        t14,
        -2*t6,
        2*t2,
        0,
        0,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        0,
        0,
        -2*t23,
        2*t22,
        t24,
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


def compose_storage_jac(outer, inner):
    """compose: value and derivatives by stored numbers."""
    outer0, outer1, outer2, outer3, outer4, outer5, outer6 = outer
    inner0, inner1, inner2, inner3, inner4, inner5, inner6 = inner
    t0 = outer3*outer5
    t1 = outer4*outer6
    t2 = t0 + t1
    t3 = 2*inner2
    t4 = outer3*outer6
    t5 = outer4*outer5
    t6 = t4 - t5
    t7 = 2*inner1
    t8 = outer4*outer4
    t9 = outer5*outer5
    t10 = -t9
    t11 = outer3*outer3
    t12 = outer6*outer6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*inner0
    t17 = outer3*outer4
    t18 = outer5*outer6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = inner0*outer3 - inner1*outer6 + inner2*outer5
    t26 = 2*t25
    t27 = 2*(inner0*outer4 + inner1*outer5 + inner2*outer6)
    t28 = -inner0*outer5 + inner1*outer4 + inner2*outer3
    t29 = 2*t28
    t30 = inner0*outer6 + inner1*outer3 - inner2*outer4
    t31 = 2*t30
    t32 = -inner4
    t33 = -inner5
    t34 = -inner6
    t35 = -outer4
    t36 = -outer5
    t37 = -outer6
    return (
        inner0*t14 + outer0 + t2*t3 - t6*t7,
        inner1*t21 + outer1 + t15*t16 - t19*t3,
        inner2*t24 + outer2 - t16*t23 + t22*t7,
        inner3*outer3 - inner4*outer4 - inner5*outer5 - inner6*outer6,
        inner3*outer4 + inner4*outer3 - inner5*outer6 + inner6*outer5,
        inner3*outer5 + inner4*outer6 + inner5*outer3 - inner6*outer4,
        inner3*outer6 - inner4*outer5 + inner5*outer4 + inner6*outer3,
        1,
        0,
        0,
        t26,
        t27,
        t29,
        -2*t30,
        0,
        1,
        0,
        t31,
        -2*t28,
        t27,
        t26,
        0,
        0,
        1,
        t29,
        t31,
        -2*t25,
        t27,
        0,
        0,
        0,
        inner3,
        t32,
        t33,
        t34,
        0,
        0,
        0,
        inner4,
        inner3,
        inner6,
        t33,
        0,
        0,
        0,
        inner5,
        t34,
        inner3,
        inner4,
        0,
        0,
        0,
        inner6,
        inner5,
        t32,
        inner3,
        t14,
        -2*t6,
        2*t2,
        0,
        0,
        0,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        0,
        0,
        0,
        -2*t23,
        2*t22,
        t24,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        outer3,
        t35,
        t36,
        t37,
        0,
        0,
        0,
        outer4,
        outer3,
        t37,
        outer5,
        0,
        0,
        0,
        outer5,
        outer6,
        outer3,
        t35,
        0,
        0,
        0,
        outer6,
        t36,
        outer4,
        outer3,
    )


def inverse(pose):
    """inverse: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = pose3*pose5
    t3 = pose4*pose6
    t4 = pose4*pose4
    t5 = pose5*pose5
    t6 = -t5
    t7 = pose3*pose3
    t8 = pose6*pose6
    t9 = t7 - t8
    t10 = pose3*pose4
    t11 = pose5*pose6
    t12 = -t4
    return (
        -pose0*(t4 + t6 + t9) - 2*pose1*(t0 + t1) + 2*pose2*(t2 - t3),
        2*pose0*(t0 - t1) - pose1*(t12 + t5 + t9) - 2*pose2*(t10 + t11),
        -2*pose0*(t2 + t3) + 2*pose1*(t10 - t11) - pose2*(t12 + t6 + t7 + t8),
        pose3,
        -pose4,
        -pose5,
        -pose6,
    )


def inverse_jac(pose):
    """inverse: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = pose3*pose5
    t4 = pose4*pose6
    t5 = t3 - t4
    t6 = pose4*pose4
    t7 = pose5*pose5
    t8 = -t7
    t9 = pose3*pose3
    t10 = pose6*pose6
    t11 = -t10 + t9
    t12 = t11 + t6 + t8
    t13 = pose3*pose4
    t14 = pose5*pose6
    t15 = t13 + t14
    t16 = t0 - t1
    t17 = -t6
    t18 = t11 + t17 + t7
    t19 = t3 + t4
    t20 = t13 - t14
    t21 = t10 + t9
    t22 = t17 + t21 + t8
    t23 = -t12
    t24 = pose0*pose4 + pose1*pose5 + pose2*pose6
    t25 = pose0*pose3 + pose1*pose6 - pose2*pose5
    t26 = -pose0*pose6 + pose1*pose3 + pose2*pose4
    t27 = pose0*pose5 - pose1*pose4 + pose2*pose3
    t28 = -pose3*t24 + pose4*t25 + pose5*t26 + pose6*t27
    t29 = pose3*t27 - pose4*t26 + pose5*t25 + pose6*t24
    t30 = pose3*t26 + pose4*t27 + pose5*t24 - pose6*t25
    t31 = -t18
    t32 = pose3*t25 + pose4*t24 - pose5*t27 + pose6*t26
    t33 = -t22
    t34 = 1/(t21 + t6 + t7)
    t35 = 2*t34
    return (
        -pose0*t12 - 2*pose1*t2 + 2*pose2*t5,
        2*pose0*t16 - pose1*t18 - 2*pose2*t15,
        -2*pose0*t19 + 2*pose1*t20 - pose2*t22,
        pose3,
        -pose4,
        -pose5,
        -pose6,
        t23,
        -2*t2,
        2*t5,
        t28,
        t29,
        -t30,
        2*t16,
        t31,
        -2*t15,
        -t29,
        t28,
        t32,
        -2*t19,
        2*t20,
        t33,
        t30,
        -t32,
        t28,
        0,
        0,
        0,
        t23*t34,
        t16*t35,
        -t19*t35,
        0,
        0,
        0,
        -t2*t35,
        t31*t34,
        t20*t35,
        0,
        0,
        0,
        t35*t5,
        -t15*t35,
        t33*t34,
    )


def inverse_storage_jac(pose):
    """inverse: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = pose3*pose5
    t4 = pose4*pose6
    t5 = t3 - t4
    t6 = pose4*pose4
    t7 = pose5*pose5
    t8 = -t7
    t9 = pose3*pose3
    t10 = pose6*pose6
    t11 = -t10 + t9
    t12 = t11 + t6 + t8
    t13 = pose3*pose4
    t14 = pose5*pose6
    t15 = t13 + t14
    t16 = t0 - t1
    t17 = -t6
    t18 = t11 + t17 + t7
    t19 = t3 + t4
    t20 = t13 - t14
    t21 = t10 + t17 + t8 + t9
    t22 = pose0*pose3 + pose1*pose6 - pose2*pose5
    t23 = -2*t22
    t24 = -2*(pose0*pose4 + pose1*pose5 + pose2*pose6)
    t25 = pose0*pose5 - pose1*pose4 + pose2*pose3
    t26 = -pose0*pose6 + pose1*pose3 + pose2*pose4
    t27 = -2*t26
    t28 = -2*t25
    return (
        -pose0*t12 - 2*pose1*t2 + 2*pose2*t5,
        2*pose0*t16 - pose1*t18 - 2*pose2*t15,
        -2*pose0*t19 + 2*pose1*t20 - pose2*t21,
        pose3,
        -pose4,
        -pose5,
        -pose6,
        -t12,
        -2*t2,
        2*t5,
        t23,
        t24,
        2*t25,
        t27,
        2*t16,
        -t18,
        -2*t15,
        t27,
        t28,
        t24,
        2*t22,
        -2*t19,
        2*t20,
        -t21,
        t28,
        2*t26,
        t23,
        t24,
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
        -1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        -1,
    )


def relative(origin, pose):
    """relative: value."""
    origin0, origin1, origin2, origin3, origin4, origin5, origin6 = origin
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = origin3*origin6
    t1 = origin4*origin5
    t2 = origin1 - pose1
    t3 = origin2 - pose2
    t4 = origin3*origin5
    t5 = origin4*origin6
    t6 = origin0 - pose0
    t7 = origin4*origin4
    t8 = origin5*origin5
    t9 = -t8
    t10 = origin3*origin3
    t11 = origin6*origin6
    t12 = t10 - t11
    t13 = origin3*origin4
    t14 = origin5*origin6
    t15 = -t7
    return (
        -2*t2*(t0 + t1) + 2*t3*(t4 - t5) - t6*(t12 + t7 + t9),
        -t2*(t12 + t15 + t8) - 2*t3*(t13 + t14) + 2*t6*(t0 - t1),
        2*t2*(t13 - t14) - t3*(t10 + t11 + t15 + t9) - 2*t6*(t4 + t5),
        origin3*pose3 + origin4*pose4 + origin5*pose5 + origin6*pose6,
        origin3*pose4 - origin4*pose3 - origin5*pose6 + origin6*pose5,
        origin3*pose5 + origin4*pose6 - origin5*pose3 - origin6*pose4,
        origin3*pose6 - origin4*pose5 + origin5*pose4 - origin6*pose3,
    )


def relative_jac(origin, pose):
    """relative: value and Jacobians."""
    origin0, origin1, origin2, origin3, origin4, origin5, origin6 = origin
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = origin3*origin6
    t1 = origin4*origin5
    t2 = t0 + t1
    t3 = origin1 - pose1
    t4 = origin2 - pose2
    t5 = origin3*origin5
    t6 = origin4*origin6
    t7 = t5 - t6
    t8 = origin0 - pose0
    t9 = origin4*origin4
    t10 = origin5*origin5
    t11 = -t10
    t12 = origin3*origin3
    t13 = origin6*origin6
    t14 = t12 - t13
    t15 = t11 + t14 + t9
    t16 = origin3*origin4
    t17 = origin5*origin6
    t18 = t16 + t17
    t19 = t0 - t1
    t20 = -t9
    t21 = t10 + t14 + t20
    t22 = t5 + t6
    t23 = t16 - t17
    t24 = t11 + t12 + t13 + t20
    t25 = origin3*pose3 + origin4*pose4 + origin5*pose5 + origin6*pose6
    t26 = origin3*pose4 - origin4*pose3 - origin5*pose6 + origin6*pose5
    t27 = origin3*pose5 + origin4*pose6 - origin5*pose3 - origin6*pose4
    t28 = origin3*pose6 - origin4*pose5 + origin5*pose4 - origin6*pose3
    t29 = 2*t2
    t30 = origin3*t8 - origin5*t4 + origin6*t3
    t31 = -t30
    t32 = origin4*t31
    t33 = -t4
    t34 = -t8
    t35 = -t3
    t36 = origin3*t33 - origin4*t35 + origin5*t34
    t37 = origin4*t8 + origin5*t3 + origin6*t4
    t38 = origin3*t37
    t39 = origin3*t3 + origin4*t4 - origin6*t8
    t40 = -t39
    t41 = origin5*t40 + t38
    t42 = origin6*t37
    t43 = origin5*t31
    t44 = origin5*t37
    t45 = origin3*t4 - origin4*t3 + origin5*t8
    t46 = -t45
    t47 = origin4*t46
    t48 = 2*t18
    t49 = origin3*t34 - origin5*t33 + origin6*t35
    t50 = origin6*t46
    t51 = origin4*t37
    t52 = origin6*t40
    t53 = 2*t22
    t54 = origin3*t35 + origin4*t33 - origin6*t34
    t55 = t27*t27
    t56 = t28*t28
    t57 = t25*t25
    t58 = t26*t26
    t59 = t57 + t58
    t60 = 1/(t55 + t56 + t59)
    t61 = -t55
    t62 = -t56
    t63 = t25*t28
    t64 = t26*t27
    t65 = 2*t60
    t66 = t25*t27
    t67 = t26*t28
    t68 = t57 - t58
    t69 = t25*t26
    t70 = t27*t28
    return (
        -t15*t8 - 2*t2*t3 + 2*t4*t7,
        -2*t18*t4 + 2*t19*t8 - t21*t3,
        -2*t22*t8 + 2*t23*t3 - t24*t4,
        t25,
        t26,
        t27,
        t28,
        -t15,
        -t29,
        2*t7,
        -origin6*t36 - t32 - t41,
        -origin3*t36 + origin4*t40 + t42 - t43,
        -origin3*t39 + origin6*t30 - t44 + t47,
        2*t19,
        -t21,
        -t48,
        -origin3*t45 + origin4*t39 - t42 + t43,
        -origin4*t49 - t41 - t50,
        -origin3*t49 + origin5*t46 + t51 - t52,
        -t53,
        2*t23,
        -t24,
        -origin3*t54 + origin6*t31 + t44 - t47,
        -origin3*t30 + origin5*t45 - t51 + t52,
        -origin5*t54 - t32 - t38 - t50,
        0,
        0,
        0,
        t60*(-t59 - t61 - t62),
        -t65*(t63 + t64),
        t65*(t66 - t67),
        0,
        0,
        0,
        t65*(t63 - t64),
        t60*(-t55 - t62 - t68),
        -t65*(t69 + t70),
        0,
        0,
        0,
        -t65*(t66 + t67),
        t65*(t69 - t70),
        t60*(-t56 - t61 - t68),
        t15,
        t29,
        -2*t7,
        0,
        0,
        0,
        -2*t19,
        t21,
        t48,
        0,
        0,
        0,
        t53,
        -2*t23,
        t24,
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


def relative_storage_jac(origin, pose):
    """relative: value and derivatives by stored numbers."""
    origin0, origin1, origin2, origin3, origin4, origin5, origin6 = origin
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    t0 = origin3*origin6
    t1 = origin4*origin5
    t2 = t0 + t1
    t3 = origin1 - pose1
    t4 = origin2 - pose2
    t5 = origin3*origin5
    t6 = origin4*origin6
    t7 = t5 - t6
    t8 = origin0 - pose0
    t9 = origin4*origin4
    t10 = origin5*origin5
    t11 = -t10
    t12 = origin3*origin3
    t13 = origin6*origin6
    t14 = t12 - t13
    t15 = t11 + t14 + t9
    t16 = origin3*origin4
    t17 = origin5*origin6
    t18 = t16 + t17
    t19 = t0 - t1
    t20 = -t9
    t21 = t10 + t14 + t20
    t22 = t5 + t6
    t23 = t16 - t17
    t24 = t11 + t12 + t13 + t20
    t25 = 2*t2
    t26 = origin3*t8 - origin5*t4 + origin6*t3
    t27 = -2*t26
    t28 = -2*origin4*t8 - 2*origin5*t3 - 2*origin6*t4
    t29 = origin3*t4 - origin4*t3 + origin5*t8
    t30 = origin3*t3 + origin4*t4 - origin6*t8
    t31 = -2*t30
    t32 = 2*t18
    t33 = -2*t29
    t34 = 2*t22
    t35 = -pose3
    t36 = -origin4
    t37 = -origin5
    t38 = -origin6
    return (
        -t15*t8 - 2*t2*t3 + 2*t4*t7,
        -2*t18*t4 + 2*t19*t8 - t21*t3,
        -2*t22*t8 + 2*t23*t3 - t24*t4,
        origin3*pose3 + origin4*pose4 + origin5*pose5 + origin6*pose6,
        origin3*pose4 - origin4*pose3 - origin5*pose6 + origin6*pose5,
        origin3*pose5 + origin4*pose6 - origin5*pose3 - origin6*pose4,
        origin3*pose6 - origin4*pose5 + origin5*pose4 - origin6*pose3,
        -t15,
        -t25,
        2*t7,
        t27,
        t28,
        2*t29,
        t31,
        2*t19,
        -t21,
        -t32,
        t31,
        t33,
        t28,
        2*t26,
        -t34,
        2*t23,
        -t24,
        t33,
        2*t30,
        t27,
        t28,
        0,
        0,
        0,
        pose3,
        pose4,
        pose5,
        pose6,
        0,
        0,
        0,
        pose4,
        t35,
        -pose6,
        pose5,
        0,
        0,
        0,
        pose5,
        pose6,
        t35,
        -pose4,
        0,
        0,
        0,
        pose6,
        -pose5,
        pose4,
        t35,
        t15,
        t25,
        -2*t7,
        0,
        0,
        0,
        0,
        -2*t19,
        t21,
        t32,
        0,
        0,
        0,
        0,
        t34,
        -2*t23,
        t24,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        origin3,
        origin4,
        origin5,
        origin6,
        0,
        0,
        0,
        t36,
        origin3,
        origin6,
        t37,
        0,
        0,
        0,
        t37,
        t38,
        origin3,
        origin4,
        0,
        0,
        0,
        t38,
        origin5,
        t36,
        origin3,
    )
