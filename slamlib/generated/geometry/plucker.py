"""Generated from slamlib/geometry/plucker.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "join": "fd4fd2033610faf5",
    "meet": "63b7c68c8075d140",
    "from_frame": "729eb8d4f1254579",
    "to_frame": "7c1e848af17f4177",
    "point_at": "262eae0dfe8cbea5",
    "crossing": "7b956690ca73acbe",
    "constrain": "e175be6f65dddf73",
    "from_rays": "ae81c12f24e25e6e",
}
SHAPES = {
    "join": (6,),
    "meet": (4,),
    "from_frame": (6,),
    "to_frame": (6,),
    "point_at": (4,),
    "crossing": (4,),
    "constrain": (6,),
    "from_rays": (6,),
}


def join(first, second):
    """join: value."""
    first0, first1, first2, first3 = first
    second0, second1, second2, second3 = second
    return (
        first1*second2 - first2*second1,
        -first0*second2 + first2*second0,
        first0*second1 - first1*second0,
        -first0*second3 + first3*second0,
        -first1*second3 + first3*second1,
        -first2*second3 + first3*second2,
    )


def join_jac(first, second):
    """join: value and Jacobians."""
    first0, first1, first2, first3 = first
    second0, second1, second2, second3 = second
    t0 = -second3
    t1 = -first2
    t2 = -first0
    t3 = -first1
    return (
        first1*second2 - first2*second1,
        -first0*second2 + first2*second0,
        first0*second1 - first1*second0,
        -first0*second3 + first3*second0,
        -first1*second3 + first3*second1,
        -first2*second3 + first3*second2,
        0,
        second2,
        -second1,
        0,
        -second2,
        0,
        second0,
        0,
        second1,
        -second0,
        0,
        0,
        t0,
        0,
        0,
        second0,
        0,
        t0,
        0,
        second1,
        0,
        0,
        t0,
        second2,
        0,
        t1,
        first1,
        0,
        first2,
        0,
        t2,
        0,
        t3,
        first0,
        0,
        0,
        first3,
        0,
        0,
        t2,
        0,
        first3,
        0,
        t3,
        0,
        0,
        first3,
        t1,
    )


def meet(line, plane):
    """meet: value."""
    line0, line1, line2, line3, line4, line5 = line
    plane0, plane1, plane2, plane3 = plane
    return (
        -line1*plane2 + line2*plane1 - line3*plane3,
        line0*plane2 - line2*plane0 - line4*plane3,
        -line0*plane1 + line1*plane0 - line5*plane3,
        line3*plane0 + line4*plane1 + line5*plane2,
    )


def meet_jac(line, plane):
    """meet: value and Jacobians."""
    line0, line1, line2, line3, line4, line5 = line
    plane0, plane1, plane2, plane3 = plane
    t0 = -plane3
    return (
        -line1*plane2 + line2*plane1 - line3*plane3,
        line0*plane2 - line2*plane0 - line4*plane3,
        -line0*plane1 + line1*plane0 - line5*plane3,
        line3*plane0 + line4*plane1 + line5*plane2,
        0,
        -plane2,
        plane1,
        t0,
        0,
        0,
        plane2,
        0,
        -plane0,
        0,
        t0,
        0,
        -plane1,
        plane0,
        0,
        0,
        0,
        t0,
        0,
        0,
        0,
        plane0,
        plane1,
        plane2,
        0,
        line2,
        -line1,
        -line3,
        -line2,
        0,
        line0,
        -line4,
        line1,
        -line0,
        0,
        -line5,
        line3,
        line4,
        line5,
        0,
    )


def from_frame(pose, line):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*line2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*line1
    t8 = pose4*pose4
    t9 = pose6*pose6
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose5*pose5
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = pose3*pose4
    t16 = pose5*pose6
    t17 = t15 + t16
    t18 = 2*line4
    t19 = t0 - t1
    t20 = 2*line3
    t21 = -t8
    t22 = t13 + t21 + t9
    t23 = line5*t22 + t17*t18 - t19*t20
    t24 = t4 + t5
    t25 = t15 - t16
    t26 = 2*line5
    t27 = t10 + t11 + t12 + t21
    t28 = line4*t27 + t20*t24 - t25*t26
    t29 = 2*line0
    t30 = line3*t14 - t18*t6 + t2*t26
    return (
        line0*t14 + pose1*t23 - pose2*t28 + t2*t3 - t6*t7,
        line1*t27 - pose0*t23 + pose2*t30 + t24*t29 - t25*t3,
        line2*t22 + pose0*t28 - pose1*t30 + t17*t7 - t19*t29,
        t30,
        t28,
        t23,
    )


def from_frame_jac(pose, line):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*line2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*line1
    t8 = pose4*pose4
    t9 = pose6*pose6
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose5*pose5
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = pose3*pose4
    t16 = pose5*pose6
    t17 = t15 + t16
    t18 = 2*line4
    t19 = t0 - t1
    t20 = 2*line3
    t21 = -t8
    t22 = t13 + t21 + t9
    t23 = line5*t22 + t17*t18 - t19*t20
    t24 = t4 + t5
    t25 = t15 - t16
    t26 = 2*line5
    t27 = t10 + t11 + t12 + t21
    t28 = line4*t27 + t20*t24 - t25*t26
    t29 = 2*line0
    t30 = line3*t14 - t18*t6 + t2*t26
    t31 = line3*pose6 + line4*pose3 - line5*pose4
    t32 = pose1*t31
    t33 = line0*pose4
    t34 = line1*pose5
    t35 = line2*pose6
    t36 = -line3*pose5 + line4*pose4 + line5*pose3
    t37 = pose2*t36 + t33 + t34 + t35
    t38 = t32 + t37
    t39 = line3*pose4 + line4*pose5 + line5*pose6
    t40 = pose1*t39
    t41 = line3*pose3 - line4*pose6 + line5*pose5
    t42 = line2*pose4
    t43 = line0*pose6 + line1*pose3 + pose2*t41 - t42
    t44 = -t40 + t43
    t45 = line0*pose5
    t46 = line1*pose4
    t47 = line2*pose3
    t48 = pose2*t39
    t49 = pose1*t41
    t50 = t45 - t46 - t47 + t48 + t49
    t51 = pose2*t31
    t52 = line1*pose6
    t53 = line0*pose3 + line2*pose5 + pose1*t36 - t52
    t54 = -t51 + t53
    t55 = -t50
    t56 = pose0*t31 - t45 + t46 + t47
    t57 = -t48 + t56
    t58 = pose0*t41
    t59 = t37 + t58
    t60 = pose0*t36
    t61 = t43 - t60
    t62 = pose0*t39
    t63 = -line0*pose3 - line2*pose5 + t51 + t52 + t62
    t64 = -t63
    t65 = t32 + t33 + t34 + t35 + t58
    t66 = t53 - t62
    t67 = -t49 + t56
    t68 = -line0*pose6 - line1*pose3 + t40 + t42 + t60
    t69 = -t68
    t70 = pose5*t31
    t71 = pose4*t41
    t72 = pose3*t39
    t73 = pose6*t36
    t74 = t72 + t73
    t75 = pose6*t39
    t76 = pose3*t36
    t77 = pose4*t31 + pose5*t41
    t78 = pose3*t31
    t79 = pose5*t39
    t80 = pose4*t36 + pose6*t41
    t81 = pose4*t39
    t82 = pose3*t41
    t83 = pose5*t36 + pose6*t31
    t84 = -2*t6
    t85 = 2*t2
    t86 = 2*pose1
    t87 = 2*t24
    t88 = -2*t25
    t89 = 2*pose0
    t90 = -2*t19
    t91 = 2*t17
    return (
        line0*t14 + pose1*t23 - pose2*t28 + t2*t3 - t6*t7,
        line1*t27 - pose0*t23 + pose2*t30 + t24*t29 - t25*t3,
        line2*t22 + pose0*t28 - pose1*t30 + t17*t7 - t19*t29,
        t30,
        t28,
        t23,
        0,
        t23,
        -t28,
        pose3*t38 - pose4*t54 + pose5*t44 - pose6*t50,
        pose3*t55 - pose4*t44 - pose5*t54 - pose6*t38,
        -pose3*t44 - pose4*t55 + pose5*t38 - pose6*t54,
        -t23,
        0,
        t30,
        -pose3*t57 - pose4*t61 - pose5*t64 + pose6*t59,
        pose3*t59 - pose4*t63 - pose5*t61 + pose6*t57,
        pose3*t64 - pose4*t59 - pose5*t57 - pose6*t61,
        t28,
        -t30,
        0,
        pose3*t69 - pose4*t67 - pose5*t65 - pose6*t66,
        -pose3*t66 + pose4*t65 - pose5*t67 - pose6*t69,
        pose3*t65 + pose4*t66 - pose5*t68 - pose6*t67,
        0,
        0,
        0,
        t70 - t71 + t74,
        -t75 + t76 - t77,
        -t78 + t79 - t80,
        0,
        0,
        0,
        t75 - t76 - t77,
        -t70 + t71 + t74,
        -t81 + t82 - t83,
        0,
        0,
        0,
        t78 - t79 - t80,
        t81 - t82 - t83,
        t70 + t71 + t72 - t73,
        t14,
        t84,
        t85,
        -2*pose1*t19 - 2*pose2*t24,
        -pose2*t27 + t17*t86,
        pose1*t22 + 2*pose2*t25,
        t87,
        t27,
        t88,
        pose2*t14 + t19*t89,
        -2*pose0*t17 - 2*pose2*t6,
        -pose0*t22 + 2*pose2*t2,
        t90,
        t91,
        t22,
        -pose1*t14 + t24*t89,
        pose0*t27 + t6*t86,
        -2*pose0*t25 - 2*pose1*t2,
        0,
        0,
        0,
        t14,
        t84,
        t85,
        0,
        0,
        0,
        t87,
        t27,
        t88,
        0,
        0,
        0,
        t90,
        t91,
        t22,
    )


def from_frame_storage_jac(pose, line):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 2*line2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = t4 - t5
    t7 = 2*line1
    t8 = pose4*pose4
    t9 = pose6*pose6
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose5*pose5
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = pose3*pose4
    t16 = pose5*pose6
    t17 = t15 + t16
    t18 = 2*line4
    t19 = t0 - t1
    t20 = 2*line3
    t21 = -t8
    t22 = t13 + t21 + t9
    t23 = line5*t22 + t17*t18 - t19*t20
    t24 = t4 + t5
    t25 = t15 - t16
    t26 = 2*line5
    t27 = t10 + t11 + t12 + t21
    t28 = line4*t27 + t20*t24 - t25*t26
    t29 = 2*line0
    t30 = line3*t14 - t18*t6 + t2*t26
    t31 = line3*pose6 + line4*pose3 - line5*pose4
    t32 = pose2*t31
    t33 = line0*pose3
    t34 = line2*pose5
    t35 = -line3*pose5 + line4*pose4 + line5*pose3
    t36 = line1*pose6
    t37 = pose1*t35 + t33 + t34 - t36
    t38 = pose1*t31
    t39 = line0*pose4
    t40 = line1*pose5
    t41 = line2*pose6
    t42 = pose2*t35 + t39 + t40 + t41
    t43 = line0*pose5
    t44 = line1*pose4
    t45 = line2*pose3
    t46 = line3*pose4 + line4*pose5 + line5*pose6
    t47 = pose2*t46
    t48 = line3*pose3 - line4*pose6 + line5*pose5
    t49 = pose1*t48
    t50 = pose1*t46
    t51 = line0*pose6
    t52 = line1*pose3
    t53 = line2*pose4
    t54 = pose2*t48 + t51 + t52 - t53
    t55 = pose0*t35
    t56 = pose0*t31 - t43 + t44 + t45
    t57 = pose0*t48
    t58 = pose0*t46
    t59 = 2*t48
    t60 = 2*t46
    t61 = 2*t35
    t62 = 2*t31
    t63 = -2*t6
    t64 = 2*t2
    t65 = 2*pose1
    t66 = 2*t24
    t67 = -2*t25
    t68 = 2*pose0
    t69 = -2*t19
    t70 = 2*t17
    return (
        line0*t14 + pose1*t23 - pose2*t28 + t2*t3 - t6*t7,
        line1*t27 - pose0*t23 + pose2*t30 + t24*t29 - t25*t3,
        line2*t22 + pose0*t28 - pose1*t30 + t17*t7 - t19*t29,
        t30,
        t28,
        t23,
        0,
        t23,
        -t28,
        -2*t32 + 2*t37,
        2*t38 + 2*t42,
        -2*t43 + 2*t44 + 2*t45 - 2*t47 - 2*t49,
        2*t50 - 2*t54,
        -t23,
        0,
        t30,
        2*t54 - 2*t55,
        2*t47 - 2*t56,
        2*t42 + 2*t57,
        -2*t32 + 2*t33 + 2*t34 - 2*t36 - 2*t58,
        t28,
        -t30,
        0,
        -2*t49 + 2*t56,
        -2*t50 + 2*t51 + 2*t52 - 2*t53 - 2*t55,
        -2*t37 + 2*t58,
        2*t38 + 2*t39 + 2*t40 + 2*t41 + 2*t57,
        0,
        0,
        0,
        t59,
        t60,
        t61,
        -2*t31,
        0,
        0,
        0,
        t62,
        -2*t35,
        t60,
        t59,
        0,
        0,
        0,
        t61,
        t62,
        -2*t48,
        t60,
        t14,
        t63,
        t64,
        -2*pose1*t19 - 2*pose2*t24,
        -pose2*t27 + t17*t65,
        pose1*t22 + 2*pose2*t25,
        t66,
        t27,
        t67,
        pose2*t14 + t19*t68,
        -2*pose0*t17 - 2*pose2*t6,
        -pose0*t22 + 2*pose2*t2,
        t69,
        t70,
        t22,
        -pose1*t14 + t24*t68,
        pose0*t27 + t6*t65,
        -2*pose0*t25 - 2*pose1*t2,
        0,
        0,
        0,
        t14,
        t63,
        t64,
        0,
        0,
        0,
        t66,
        t27,
        t67,
        0,
        0,
        0,
        t69,
        t70,
        t22,
    )


def to_frame(pose, line):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = line1 - line3*pose2 + line5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = line2 + line3*pose1 - line4*pose0
    t9 = 2*t8
    t10 = line0 + line4*pose2 - line5*pose1
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
    t28 = 2*line4
    t29 = 2*line5
    t30 = 2*line3
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        line3*t17 + t2*t28 - t29*t7,
        line4*t24 + t20*t29 - t21*t30,
        line5*t27 + t25*t30 - t26*t28,
    )


def to_frame_jac(pose, line):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = line1 - line3*pose2 + line5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = line2 + line3*pose1 - line4*pose0
    t9 = 2*t8
    t10 = line0 + line4*pose2 - line5*pose1
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
    t28 = 2*line4
    t29 = 2*line5
    t30 = 2*line3
    t31 = pose4*t10 + pose5*t3 + pose6*t8
    t32 = pose3*t10 - pose5*t8 + pose6*t3
    t33 = pose3*t3 + pose4*t8 - pose6*t10
    t34 = pose3*t8 - pose4*t3 + pose5*t10
    t35 = pose3*t31 - pose4*t32 - pose5*t33 - pose6*t34
    t36 = pose3*t34 - pose4*t33 + pose5*t32 + pose6*t31
    t37 = pose3*t33 + pose4*t34 + pose5*t31 - pose6*t32
    t38 = pose3*t32 + pose4*t31 - pose5*t34 + pose6*t33
    t39 = line3*pose4 + line4*pose5 + line5*pose6
    t40 = line3*pose3 + line4*pose6 - line5*pose5
    t41 = -line3*pose6 + line4*pose3 + line5*pose4
    t42 = line3*pose5 - line4*pose4 + line5*pose3
    t43 = pose3*t39 - pose4*t40 - pose5*t41 - pose6*t42
    t44 = pose3*t42 - pose4*t41 + pose5*t40 + pose6*t39
    t45 = pose3*t41 + pose4*t42 + pose5*t39 - pose6*t40
    t46 = pose3*t40 + pose4*t39 - pose5*t42 + pose6*t41
    t47 = 2*t2
    t48 = -2*t7
    t49 = 2*pose0
    t50 = -2*t21
    t51 = 2*t20
    t52 = 2*pose1
    t53 = 2*t25
    t54 = -2*t26
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        line3*t17 + t2*t28 - t29*t7,
        line4*t24 + t20*t29 - t21*t30,
        line5*t27 + t25*t30 - t26*t28,
        2*line4*t7 + 2*line5*t2,
        -line5*t17 - t30*t7,
        line4*t17 - t2*t30,
        t35,
        -t36,
        t37,
        line5*t24 - t20*t28,
        2*line3*t20 + 2*line5*t21,
        -line3*t24 - t21*t28,
        t36,
        t35,
        -t38,
        -line4*t27 - t26*t29,
        line3*t27 - t25*t29,
        2*line3*t26 + 2*line4*t25,
        -t37,
        t38,
        t35,
        0,
        0,
        0,
        t43,
        -t44,
        t45,
        0,
        0,
        0,
        t44,
        t43,
        -t46,
        0,
        0,
        0,
        -t45,
        t46,
        t43,
        t17,
        t47,
        t48,
        -2*pose1*t7 - 2*pose2*t2,
        pose2*t17 + t49*t7,
        -pose1*t17 + t2*t49,
        t50,
        t24,
        t51,
        -pose2*t24 + t20*t52,
        -2*pose0*t20 - 2*pose2*t21,
        pose0*t24 + t21*t52,
        t53,
        t54,
        t27,
        pose1*t27 + 2*pose2*t26,
        -pose0*t27 + 2*pose2*t25,
        -2*pose0*t26 - 2*pose1*t25,
        0,
        0,
        0,
        t17,
        t47,
        t48,
        0,
        0,
        0,
        t50,
        t24,
        t51,
        0,
        0,
        0,
        t53,
        t54,
        t27,
    )


def to_frame_storage_jac(pose, line):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = line1 - line3*pose2 + line5*pose0
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = line2 + line3*pose1 - line4*pose0
    t9 = 2*t8
    t10 = line0 + line4*pose2 - line5*pose1
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
    t28 = 2*line4
    t29 = 2*line5
    t30 = 2*line3
    t31 = pose3*t10 - pose5*t8 + pose6*t3
    t32 = 2*t31
    t33 = 2*pose4*t10 + 2*pose5*t3 + 2*pose6*t8
    t34 = pose3*t8 - pose4*t3 + pose5*t10
    t35 = pose3*t3 + pose4*t8 - pose6*t10
    t36 = 2*t35
    t37 = 2*t34
    t38 = line3*pose3 + line4*pose6 - line5*pose5
    t39 = 2*t38
    t40 = 2*(line3*pose4 + line4*pose5 + line5*pose6)
    t41 = line3*pose5 - line4*pose4 + line5*pose3
    t42 = -line3*pose6 + line4*pose3 + line5*pose4
    t43 = 2*t42
    t44 = 2*t41
    t45 = 2*t2
    t46 = -2*t7
    t47 = 2*pose0
    t48 = -2*t21
    t49 = 2*t20
    t50 = 2*pose1
    t51 = 2*t25
    t52 = -2*t26
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        line3*t17 + t2*t28 - t29*t7,
        line4*t24 + t20*t29 - t21*t30,
        line5*t27 + t25*t30 - t26*t28,
        2*line4*t7 + 2*line5*t2,
        -line5*t17 - t30*t7,
        line4*t17 - t2*t30,
        t32,
        t33,
        -2*t34,
        t36,
        line5*t24 - t20*t28,
        2*line3*t20 + 2*line5*t21,
        -line3*t24 - t21*t28,
        t36,
        t37,
        t33,
        -2*t31,
        -line4*t27 - t26*t29,
        line3*t27 - t25*t29,
        2*line3*t26 + 2*line4*t25,
        t37,
        -2*t35,
        t32,
        t33,
        0,
        0,
        0,
        t39,
        t40,
        -2*t41,
        t43,
        0,
        0,
        0,
        t43,
        t44,
        t40,
        -2*t38,
        0,
        0,
        0,
        t44,
        -2*t42,
        t39,
        t40,
        t17,
        t45,
        t46,
        -2*pose1*t7 - 2*pose2*t2,
        pose2*t17 + t47*t7,
        -pose1*t17 + t2*t47,
        t48,
        t24,
        t49,
        -pose2*t24 + t20*t50,
        -2*pose0*t20 - 2*pose2*t21,
        pose0*t24 + t21*t50,
        t51,
        t52,
        t27,
        pose1*t27 + 2*pose2*t26,
        -pose0*t27 + 2*pose2*t25,
        -2*pose0*t26 - 2*pose1*t25,
        0,
        0,
        0,
        t17,
        t45,
        t46,
        0,
        0,
        0,
        t48,
        t24,
        t49,
        0,
        0,
        0,
        t51,
        t52,
        t27,
    )


def point_at(line, abscissa):
    """point_at: value."""
    line0, line1, line2, line3, line4, line5 = line
    abscissa, = abscissa
    t0 = line3*line3 + line4*line4 + line5*line5
    t1 = abscissa*sqrt(t0)
    return (
        -line1*line5 + line2*line4 + line3*t1,
        line0*line5 - line2*line3 + line4*t1,
        -line0*line4 + line1*line3 + line5*t1,
        t0,
    )


def point_at_jac(line, abscissa):
    """point_at: value and Jacobians."""
    line0, line1, line2, line3, line4, line5 = line
    abscissa, = abscissa
    t0 = line3*line3
    t1 = line4*line4
    t2 = line5*line5
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = line3*t4
    t6 = line4*t4
    t7 = line5*t4
    t8 = 1/(t4)
    t9 = abscissa*line3*t8
    t10 = line4*t9
    t11 = line5*t9
    t12 = abscissa*line4*line5*t8
    return (
        abscissa*t5 - line1*line5 + line2*line4,
        abscissa*t6 + line0*line5 - line2*line3,
        abscissa*t7 - line0*line4 + line1*line3,
        t3,
        0,
        -line5,
        line4,
        abscissa*(t0*t8 + t4),
        line2 + t10,
        -line1 + t11,
        line5,
        0,
        -line3,
        -line2 + t10,
        abscissa*(t1*t8 + t4),
        line0 + t12,
        -line4,
        line3,
        0,
        line1 + t11,
        -line0 + t12,
        abscissa*(t2*t8 + t4),
        0,
        0,
        0,
        2*line3,
        2*line4,
        2*line5,
        t5,
        t6,
        t7,
        0,
    )


def crossing(line, ray):
    """crossing: value."""
    line0, line1, line2, line3, line4, line5 = line
    ray0, ray1, ray2 = ray
    t0 = line0*ray0 + line1*ray1 + line2*ray2
    t1 = line0*line0 + line1*line1 + line2*line2
    return (
        -line0*t0 + ray0*t1,
        -line1*t0 + ray1*t1,
        -line2*t0 + ray2*t1,
        line3*(line1*ray2 - line2*ray1) - line4*(line0*ray2 - line2*ray0) + line5*(line0*ray1 - line1*ray0),
    )


def crossing_jac(line, ray):
    """crossing: value and Jacobians."""
    line0, line1, line2, line3, line4, line5 = line
    ray0, ray1, ray2 = ray
    t0 = line0*ray0
    t1 = line1*ray1
    t2 = line2*ray2
    t3 = t1 + t2
    t4 = t0 + t3
    t5 = line0*line0
    t6 = line1*line1
    t7 = line2*line2
    t8 = t6 + t7
    t9 = t5 + t8
    t10 = line1*ray2
    t11 = -line2*ray1
    t12 = t10 + t11
    t13 = line0*ray1
    t14 = -line1*ray0
    t15 = t13 + t14
    t16 = line0*ray2
    t17 = -line2*ray0
    t18 = t16 + t17
    t19 = -line0*line1
    t20 = -line0*line2
    t21 = -line1*line2
    return (
        -line0*t4 + ray0*t9,
        -line1*t4 + ray1*t9,
        -line2*t4 + ray2*t9,
        line3*t12 - line4*t18 + line5*t15,
        -t3,
        2*line1*ray0 - t13,
        2*line2*ray0 - t16,
        0,
        0,
        0,
        2*t13 + t14,
        -t0 - t2,
        2*line2*ray1 - t10,
        0,
        0,
        0,
        2*t16 + t17,
        2*t10 + t11,
        -t0 - t1,
        0,
        0,
        0,
        -line4*ray2 + line5*ray1,
        line3*ray2 - line5*ray0,
        -line3*ray1 + line4*ray0,
        t12,
        -t18,
        t15,
        t8,
        t19,
        t20,
        t19,
        t5 + t7,
        t21,
        t20,
        t21,
        t5 + t6,
        -line1*line5 + line2*line4,
        line0*line5 - line2*line3,
        -line0*line4 + line1*line3,
    )


def constrain(line, eye):
    """constrain: value."""
    line0, line1, line2, line3, line4, line5 = line
    eye0, eye1, eye2 = eye
    t0 = -eye0*line4 + eye1*line3 + line2
    t1 = eye0*line5 - eye2*line3 + line1
    t2 = -eye1*line5 + eye2*line4 + line0
    t3 = (line3*t2 + line4*t1 + line5*t0)/(t0*t0 + t1*t1 + t2*t2)
    t4 = line5 - t0*t3
    t5 = line4 - t1*t3
    t6 = line3 - t2*t3
    return (
        eye1*t4 - eye2*t5 + t2,
        -eye0*t4 + eye2*t6 + t1,
        eye0*t5 - eye1*t6 + t0,
        t6,
        t5,
        t4,
    )


def constrain_jac(line, eye):
    """constrain: value and Jacobians."""
    line0, line1, line2, line3, line4, line5 = line
    eye0, eye1, eye2 = eye
    t0 = eye1*line3
    t1 = eye0*line4
    t2 = line2 + t0 - t1
    t3 = t2*t2
    t4 = eye0*line5
    t5 = eye2*line3
    t6 = line1 + t4 - t5
    t7 = t6*t6
    t8 = -eye1*line5 + eye2*line4 + line0
    t9 = t8*t8
    t10 = t3 + t7 + t9
    t11 = 1/(t10)
    t12 = line4*t6
    t13 = line3*t8
    t14 = line5*t2
    t15 = t13 + t14
    t16 = t12 + t15
    t17 = t11*t16
    t18 = t17*t2
    t19 = line5 - t18
    t20 = t17*t6
    t21 = line4 - t20
    t22 = t17*t8
    t23 = line3 - t22
    t24 = eye2*t6
    t25 = 2*t22
    t26 = line3 - t25
    t27 = t11*t26
    t28 = eye1*t2
    t29 = -t6
    t30 = 2*t17
    t31 = line4 + t29*t30
    t32 = 2*t20
    t33 = 2*t12 + t15
    t34 = t29*t32 + t33
    t35 = -t2
    t36 = line5 + t30*t35
    t37 = 2*t18
    t38 = t12 + t13 + 2*t14
    t39 = t35*t37 + t38
    t40 = -eye2*t6 + t28
    t41 = -t40
    t42 = eye1*t16
    t43 = line0*t2 + t42
    t44 = t37*t41 + t43
    t45 = eye2*t16
    t46 = t11*t6
    t47 = eye0*t2
    t48 = eye2*t8
    t49 = t47 - t48
    t50 = t16/(t10*t10)
    t51 = 2*t50
    t52 = line1*t46 + t49*t51*t6 - 1
    t53 = eye0*t16
    t54 = line1*t2 + t37*t49 - t53
    t55 = t11*t2
    t56 = eye0*t6
    t57 = -eye1*t8 + t56
    t58 = -t57
    t59 = t2*t51
    t60 = line2*t6 + t53
    t61 = t32*t58 + t60
    t62 = -t8
    t63 = line3 + t30*t62
    t64 = t12 + 2*t13 + t14
    t65 = t25*t62 + t64
    t66 = line4 - t32
    t67 = t11*t66
    t68 = t11*t8
    t69 = t51*t8
    t70 = line1*t8 + t25*t49 + t45
    t71 = -line2*t11*t2 + t57*t59 + 1
    t72 = -line2*t8 + t25*t57 + t42
    t73 = line5 - t37
    t74 = t11*t73
    t75 = -line0*t11*t8 + t40*t69 + 1
    t76 = -line0*t6 + t32*t40 + t45
    t77 = -t66
    t78 = -t73
    t79 = -t26
    t80 = line4*t2 - line5*t6
    t81 = 2*t80
    t82 = line4 - t55*t81
    t83 = line5 + t46*t81
    t84 = line3*t2 - line5*t8
    t85 = line3 - 2*t55*t84
    t86 = 2*t84
    t87 = t11*t86
    t88 = line3*t6 - line4*t8
    t89 = 2*t88
    t90 = line3 - t46*t89
    t91 = line5 + t68*t86
    t92 = line4 + t68*t89
    return (
        eye1*t19 - eye2*t21 + t8,
        -eye0*t19 + eye2*t23 + t6,
        eye0*t21 - eye1*t23 + t2,
        t23,
        t21,
        t19,
        t24*t27 - t27*t28 + 1,
        t11*(eye2*t34 - t28*t31),
        t11*(-eye1*t39 + eye2*t36*t6),
        t11*(-eye1*t44 + eye2*(line0*t6 + t32*t41 - t45)),
        -eye1*t11*t54 + eye2*t52 + eye2,
        -eye1*(line2*t55 + t58*t59 - 1) - eye1 + eye2*t11*t61,
        t11*(-eye2*t65 + t47*t63),
        t47*t67 - t48*t67 + 1,
        t11*(eye0*t39 - t36*t48),
        eye0*t11*t44 - eye2*(line0*t68 + t41*t69 - 1) - eye2,
        t11*(eye0*t54 - eye2*t70),
        -eye0*t71 + eye0 + eye2*t11*t72,
        t11*(eye1*t65 - t56*t63),
        t11*(-eye0*t34 + eye1*t31*t8),
        eye1*t74*t8 - t56*t74 + 1,
        eye0*t11*t76 - eye1*t75 + eye1,
        -eye0*t52 - eye0 + eye1*t11*t70,
        t11*(-eye0*t61 + eye1*(line2*t8 + t25*t58 - t42)),
        t11*(2*t11*t16*t9 - t64),
        t68*t77,
        t68*t78,
        t75,
        -t11*t70,
        t11*t72,
        t46*t79,
        t11*(2*t11*t16*t7 - t33),
        t46*t78,
        t11*t76,
        -t52,
        t11*(2*t11*t16*t57*t6 - t60),
        t55*t79,
        t55*t77,
        t11*(2*t11*t16*t3 - t38),
        t11*(2*t11*t16*t2*t40 - t43),
        -t11*t54,
        t71,
        t17*(eye1*t82 + eye2*t83),
        -t17*(eye1*t85 + t2 + t24*t87),
        t17*(-eye2*t90 + line1 - t11*t28*t89 + t4 - t5),
        t17*(-eye0*t82 + line2 + t0 - t1 - t11*t48*t81),
        t17*(eye0*t85 + eye2*t91),
        t17*(2*eye0*t11*t2*t88 - eye2*t92 - t8),
        t17*(-eye0*t83 + 2*eye1*t11*t8*t80 - t6),
        t17*(-eye1*t91 + t56*t87 + t8),
        t17*(eye0*t90 + eye1*t92),
        -t50*t8*t81,
        t17*t91,
        -t17*t92,
        -t17*t83,
        t50*t6*t86,
        t17*t90,
        t17*t82,
        t17*(-line3 + 2*t11*t2*t84),
        -t2*t50*t89,
    )


def from_rays(rays, slopes):
    """from_rays: value."""
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    slopes0, slopes1 = slopes
    t0 = rays1*rays5 - rays2*rays4
    t1 = rays0*rays5 - rays2*rays3
    t2 = rays0*rays4 - rays1*rays3
    t3 = t0*t0 + t2*t2
    t4 = 1/(sqrt(t1*t1 + t3))
    t5 = rays0 - rays3
    t6 = rays1 - rays4
    t7 = rays2 - rays5
    t8 = 1/(sqrt(t5*t5 + t6*t6 + t7*t7))
    t9 = slopes0*t8
    t10 = -t6
    t11 = -t7
    t12 = -t1
    t13 = -t5
    t14 = slopes1/(sqrt(t12*t12 + t3)*sqrt(t10*t10 + t11*t11 + t13*t13))
    return (
        t0*t4,
        -t1*t4,
        t2*t4,
        -t14*(t10*t2 - t11*t12) - t5*t9,
        t8*(-slopes0*t6 + slopes1*t4*(t0*t7 - t2*t5)),
        -t14*(-t0*t10 + t12*t13) - t7*t9,
    )


def from_rays_jac(rays, slopes):
    """from_rays: value and Jacobians."""
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    slopes0, slopes1 = slopes
    t0 = rays1*rays5
    t1 = rays2*rays4
    t2 = t0 - t1
    t3 = rays0*rays5
    t4 = rays2*rays3
    t5 = t3 - t4
    t6 = rays0*rays4
    t7 = rays1*rays3
    t8 = t6 - t7
    t9 = t2*t2 + t8*t8
    t10 = t5*t5 + t9
    t11 = 1/(sqrt(t10))
    t12 = rays0 - rays3
    t13 = t12*t12
    t14 = rays1 - rays4
    t15 = t14*t14
    t16 = rays2 - rays5
    t17 = t16*t16
    t18 = t13 + t15 + t17
    t19 = 1/(sqrt(t18))
    t20 = slopes0*t19
    t21 = -t14
    t22 = t21*t8
    t23 = -t16
    t24 = -t5
    t25 = t23*t24
    t26 = -t12
    t27 = t21*t21 + t23*t23 + t26*t26
    t28 = t24*t24 + t9
    t29 = slopes1/(sqrt(t27)*sqrt(t28))
    t30 = slopes0*t14
    t31 = t12*t8
    t32 = t16*t2 - t31
    t33 = t24*t26
    t34 = t2*t21
    t35 = rays4*t8
    t36 = rays5*t5 + t35
    t37 = 1/(t10*sqrt(t10))
    t38 = t2*t37
    t39 = rays3*t8 - rays5*t2
    t40 = 1/(t10)
    t41 = t2*t40
    t42 = rays4*t2
    t43 = rays3*t24 - t42
    t44 = rays1*t8
    t45 = rays2*t5 + t44
    t46 = rays0*t8 - rays2*t2
    t47 = rays1*t2
    t48 = rays0*t5 + t47
    t49 = -rays5*t24 + t35
    t50 = t37*t5
    t51 = rays3*t5 + t42
    t52 = t40*t5
    t53 = t40*t8
    t54 = t37*t8
    t55 = 1/(t18*sqrt(t18))
    t56 = rays4*t21
    t57 = rays5*t23
    t58 = 1/(t27)
    t59 = t26*t58
    t60 = t22*t59
    t61 = t25*t59
    t62 = 1/(t28)
    t63 = -t49*t62
    t64 = 1/(t18)
    t65 = t12*t64
    t66 = t30*t65
    t67 = t64*t8
    t68 = t16*t5
    t69 = t14*t64
    t70 = t14*t8
    t71 = t39*t40
    t72 = -t6 + t7
    t73 = slopes1*t11
    t74 = slopes0*t16*t65
    t75 = t17*t64
    t76 = t16*t64
    t77 = t40*t43
    t78 = -t3 + t4
    t79 = rays1*t14
    t80 = rays2*t16
    t81 = t31*t69
    t82 = t65*t68
    t83 = t40*t45
    t84 = t30*t55
    t85 = t12*t84
    t86 = t14*t58
    t87 = -t46*t62
    t88 = slopes0*t12*t16*t55
    t89 = t16*t58
    t90 = t62*(rays0*t24 - t47)
    t91 = t16*t2
    t92 = t40*t49
    t93 = rays3*t26
    t94 = t23*t58
    t95 = t34*t94
    t96 = t39*t62
    t97 = t2*t23
    t98 = t26*t8
    t99 = t30*t76
    t100 = -t0 + t1
    t101 = t62*(-rays2*t24 + t44)
    t102 = -slopes0
    t103 = rays0*t12
    t104 = t69*t91
    t105 = t40*t46
    t106 = t16*t84
    t107 = t14*t2
    t108 = t12*t5
    t109 = t36*t40
    t110 = -t43*t62
    t111 = t12*t58
    t112 = t40*t48
    t113 = t11*t19
    return (
        t11*t2,
        -t11*t5,
        t11*t8,
        -t12*t20 - t29*(t22 - t25),
        t19*(slopes1*t11*t32 - t30),
        -t16*t20 - t29*(t33 - t34),
        -t36*t38,
        t11*(rays5 + t39*t41),
        -t11*(rays4 + t41*t43),
        t38*t45,
        -t11*(rays2 + t41*t46),
        t11*(rays1 - t41*t48),
        t11*(-rays5 + t40*t49*t5),
        -t39*t50,
        t11*(rays3 - t51*t52),
        t11*(rays2 - t45*t52),
        t46*t50,
        t11*(-rays0 + t40*t48*t5),
        t11*(rays4 - t36*t53),
        t11*(-rays3 + t39*t40*t8),
        t51*t54,
        t11*(-rays1 + t40*t45*t8),
        t11*(rays0 - t46*t53),
        -t48*t54,
        slopes0*t13*t55 - t20 - t29*(t22*t63 - t25*t63 + t56 + t57 + t60 - t61),
        t19*(t66 - t73*(rays3*t14 + t15*t67 + t68*t69 - t68*t71 - t70*t71 + t72)),
        t19*(-t73*(rays3*t16 + t5*t75 + t68*t77 + t70*t76 + t70*t77 + t78) + t74),
        t19*(-slopes0*t13*t64 + slopes0 + t73*(t68*t83 + t70*t83 - t79 - t80 + t81 + t82)),
        -t29*(rays0*t21 + t22*t86 + t22*t87 - t25*t86 - t25*t87 + t8) - t85,
        -t29*(rays0*t23 + t22*t89 + t22*t90 - t25*t89 - t25*t90 + t5) - t88,
        t19*(t66 - t73*(rays4*t12 - t13*t67 - t31*t92 + t65*t91 + t8 + t91*t92)),
        slopes0*t15*t55 - t20 - t29*(t57 - t60 + t93 + t95 + t96*t97 - t96*t98),
        t19*(-t73*(rays4*t16 + t100 + t2*t75 - t31*t76 - t31*t77 + t77*t91) + t99),
        -t29*(rays1*t26 + t101*t97 - t101*t98 + t12*t2*t94 - t31*t59 + t72) - t85,
        t19*(-slopes0*t15*t64 - t102 - t73*(t103 - t104 - t105*t31 + t105*t91 + t80 + t81)),
        -t106 - t29*(rays1*t23 - t16*t59*t8 + t2 + t90*t97 - t90*t98 + t91*t94),
        t19*(t73*(-rays5*t12 + t107*t109 + t107*t65 + t108*t109 + t13*t5*t64 + t78) + t74),
        t19*(-t73*(rays5*t14 + t107*t71 - t108*t69 + t108*t71 - t15*t2*t64 + t2) + t99),
        slopes0*t17*t55 - t20 - t29*(t110*t33 - t110*t34 + t56 + t61 + t93 - t95),
        -t29*(rays2*t26 + t101*t33 - t101*t34 + t111*t33 - t111*t34 + t78) - t88,
        -t106 - t29*(rays2*t21 + t100 + t33*t86 + t33*t87 - t34*t86 - t34*t87),
        t19*(-slopes0*t75 - t102 - t73*(t103 + t104 - t107*t112 - t108*t112 + t79 + t82)),
        0,
        0,
        0,
        0,
        0,
        0,
        -t12*t19,
        t113*(t68 + t70),
        -t14*t19,
        t113*t32,
        -t16*t19,
        -t113*(t107 + t108),
    )
