"""Generated from slamlib/geometry/plucker.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "join": "91f184b0d318e90a",
    "meet": "eaf4fea11dd5ce61",
    "from_frame": "ab07d96f8cddfd2c",
    "to_frame": "a8daa40c5afb0888",
    "point_at": "262eae0dfe8cbea5",
    "crossing": "7b956690ca73acbe",
    "constrain": "bd01e6c1c6416836",
    "from_rays": "ded7e2a8cacffb48",
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
    t0 = pose6*pose6
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose5*pose5
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = -t5
    t8 = t4 + t7 + t0
    t9 = pose3*pose4
    t10 = pose5*pose6
    t11 = t9 + t10
    t12 = line4 + line4
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = line3 + line3
    t17 = line5*t8 + t11*t12 - t15*t16
    t18 = t1 + t2 + t3 + t7
    t19 = pose3*pose6
    t20 = pose4*pose5
    t21 = t19 + t20
    t22 = t9 - t10
    t23 = line5 + line5
    t24 = line4*t18 + t16*t21 - t22*t23
    t25 = t13 + t14
    t26 = line2 + line2
    t27 = t19 - t20
    t28 = line1 + line1
    t29 = line3*t6 - t12*t27 + t23*t25
    t30 = line0 + line0
    return (
        line0*t6 + pose1*t17 - pose2*t24 + t25*t26 - t27*t28,
        line1*t18 - pose0*t17 + pose2*t29 + t21*t30 - t22*t26,
        line2*t8 + pose0*t24 - pose1*t29 + t11*t28 - t15*t30,
        t29,
        t24,
        t17,
    )


def from_frame_jac(pose, line):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = pose6*pose6
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose5*pose5
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = -t5
    t8 = t4 + t7 + t0
    t9 = pose3*pose4
    t10 = pose5*pose6
    t11 = t9 + t10
    t12 = line4 + line4
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = line3 + line3
    t17 = line5*t8 + t11*t12 - t15*t16
    t18 = t1 + t2 + t3 + t7
    t19 = pose3*pose6
    t20 = pose4*pose5
    t21 = t19 + t20
    t22 = t9 - t10
    t23 = line5 + line5
    t24 = line4*t18 + t16*t21 - t22*t23
    t25 = t13 + t14
    t26 = line2 + line2
    t27 = t19 - t20
    t28 = line1 + line1
    t29 = line3*t6 - t12*t27 + t23*t25
    t30 = line0 + line0
    t31 = line3*pose6 + line4*pose3 - line5*pose4
    t32 = pose1*t31
    t33 = -line3*pose5 + line4*pose4 + line5*pose3
    t34 = line0*pose4
    t35 = line1*pose5
    t36 = line2*pose6
    t37 = pose2*t33 + t34 + t35 + t36
    t38 = t32 + t37
    t39 = pose2*t31
    t40 = line1*pose6
    t41 = line0*pose3 + line2*pose5 + pose1*t33 - t40
    t42 = -t39 + t41
    t43 = line3*pose4 + line4*pose5 + line5*pose6
    t44 = pose1*t43
    t45 = line3*pose3 - line4*pose6 + line5*pose5
    t46 = line2*pose4
    t47 = line0*pose6 + line1*pose3 + pose2*t45 - t46
    t48 = -t44 + t47
    t49 = line0*pose5
    t50 = line1*pose4
    t51 = line2*pose3
    t52 = pose2*t43
    t53 = pose1*t45
    t54 = t49 - t50 - t51 + t52 + t53
    t55 = -t54
    t56 = pose0*t31 - t49 + t50 + t51
    t57 = -t52 + t56
    t58 = pose0*t33
    t59 = t47 - t58
    t60 = pose0*t43
    t61 = -line0*pose3 - line2*pose5 + t39 + t40 + t60
    t62 = -t61
    t63 = pose0*t45
    t64 = t37 + t63
    t65 = -line0*pose6 - line1*pose3 + t44 + t46 + t58
    t66 = -t65
    t67 = -t53 + t56
    t68 = t32 + t34 + t35 + t36 + t63
    t69 = t41 - t60
    t70 = pose5*t31
    t71 = pose4*t45
    t72 = pose3*t43
    t73 = pose6*t33
    t74 = t72 + t73
    t75 = pose6*t43
    t76 = pose3*t33
    t77 = pose4*t31 + pose5*t45
    t78 = pose3*t31
    t79 = pose5*t43
    t80 = pose4*t33 + pose6*t45
    t81 = pose4*t43
    t82 = pose3*t45
    t83 = pose5*t33 + pose6*t31
    t84 = t27 + t27
    t85 = -t84
    t86 = t25 + t25
    t87 = pose1 + pose1
    t88 = pose2 + pose2
    t89 = t21 + t21
    t90 = t22 + t22
    t91 = -t90
    t92 = pose0 + pose0
    t93 = t15 + t15
    t94 = -t93
    t95 = t11 + t11
    return (
        line0*t6 + pose1*t17 - pose2*t24 + t25*t26 - t27*t28,
        line1*t18 - pose0*t17 + pose2*t29 + t21*t30 - t22*t26,
        line2*t8 + pose0*t24 - pose1*t29 + t11*t28 - t15*t30,
        t29,
        t24,
        t17,
        0,
        t17,
        -t24,
        pose3*t38 - pose4*t42 + pose5*t48 - pose6*t54,
        pose3*t55 - pose4*t48 - pose5*t42 - pose6*t38,
        -pose3*t48 - pose4*t55 + pose5*t38 - pose6*t42,
        -t17,
        0,
        t29,
        -pose3*t57 - pose4*t59 - pose5*t62 + pose6*t64,
        pose3*t64 - pose4*t61 - pose5*t59 + pose6*t57,
        pose3*t62 - pose4*t64 - pose5*t57 - pose6*t59,
        t24,
        -t29,
        0,
        pose3*t66 - pose4*t67 - pose5*t68 - pose6*t69,
        -pose3*t69 + pose4*t68 - pose5*t67 - pose6*t66,
        pose3*t68 + pose4*t69 - pose5*t65 - pose6*t67,
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
        t6,
        t85,
        t86,
        -t15*t87 - t21*t88,
        -pose2*t18 + t11*t87,
        pose1*t8 + t22*t88,
        t89,
        t18,
        t91,
        pose2*t6 + t15*t92,
        -t11*t92 - t27*t88,
        -pose0*t8 + t25*t88,
        t94,
        t95,
        t8,
        -pose1*t6 + t21*t92,
        pose0*t18 + t27*t87,
        -t25*t87 - t22*t92,
        0,
        0,
        0,
        t6,
        t85,
        t86,
        0,
        0,
        0,
        t89,
        t18,
        t91,
        0,
        0,
        0,
        t94,
        t95,
        t8,
    )


def to_frame(pose, line):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = line0 + line4*pose2 - line5*pose1
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
    t11 = line1 - line3*pose2 + line5*pose0
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = line2 + line3*pose1 - line4*pose0
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
    t28 = line4 + line4
    t29 = line5 + line5
    t30 = line3 + line3
    return (
        t0*t7 + t10*t12 - t15*t17,
        t17*t20 - t21*t22 + t11*t24,
        t22*t25 - t12*t26 + t16*t27,
        line3*t7 + t10*t28 - t15*t29,
        line4*t24 + t20*t29 - t21*t30,
        line5*t27 + t25*t30 - t26*t28,
    )


def to_frame_jac(pose, line):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    line0, line1, line2, line3, line4, line5 = line
    t0 = line0 + line4*pose2 - line5*pose1
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
    t11 = line1 - line3*pose2 + line5*pose0
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = line2 + line3*pose1 - line4*pose0
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
    t31 = line4 + line4
    t32 = line5 + line5
    t33 = line3*t7 + t10*t31 - t15*t32
    t34 = line3 + line3
    t35 = line4*t25 + t21*t32 - t22*t34
    t36 = line5*t29 + t27*t34 - t28*t31
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
        -line5*t7 - t15*t34,
        line4*t7 - t10*t34,
        0,
        -t30,
        t26,
        line5*t25 - t21*t31,
        t21*t34 + t22*t32,
        -line3*t25 - t22*t31,
        t30,
        0,
        -t18,
        -line4*t29 - t28*t32,
        line3*t29 - t27*t32,
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


def point_at(line, abscissa):
    """point_at: value."""
    line0, line1, line2, line3, line4, line5 = line
    abscissa, = abscissa
    t0 = line3*line3
    t1 = line4*line4
    t2 = line5*line5
    t3 = t0 + t1 + t2
    t4 = sqrt(t3)
    t5 = abscissa*t4
    return (
        -line1*line5 + line2*line4 + line3*t5,
        line0*line5 - line2*line3 + line4*t5,
        -line0*line4 + line1*line3 + line5*t5,
        t3,
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
    t8 = 1/t4
    t9 = abscissa*line3*t8
    t10 = line4*t9
    t11 = line5*t9
    t12 = abscissa*line4*line5*t8
    t13 = line3 + line3
    t14 = line4 + line4
    t15 = line5 + line5
    return (
        abscissa*t5 - line1*line5 + line2*line4,
        abscissa*t6 + line0*line5 - line2*line3,
        abscissa*t7 - line0*line4 + line1*line3,
        t3,
        0,
        -line5,
        line4,
        (t0*t8 + t4)*abscissa,
        line2 + t10,
        -line1 + t11,
        line5,
        0,
        -line3,
        -line2 + t10,
        (t1*t8 + t4)*abscissa,
        line0 + t12,
        -line4,
        line3,
        0,
        line1 + t11,
        -line0 + t12,
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


def crossing(line, ray):
    """crossing: value."""
    line0, line1, line2, line3, line4, line5 = line
    ray0, ray1, ray2 = ray
    t0 = line0*ray0 + line1*ray1 + line2*ray2
    t1 = line0*line0
    t2 = line1*line1
    t3 = line2*line2
    t4 = t1 + t2 + t3
    return (
        -line0*t0 + ray0*t4,
        -line1*t0 + ray1*t4,
        -line2*t0 + ray2*t4,
        (line1*ray2 - line2*ray1)*line3 - (line0*ray2 - line2*ray0)*line4 + (line0*ray1 - line1*ray0)*line5,
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
    t11 = line2*ray1
    t12 = -t11
    t13 = t10 + t12
    t14 = line0*ray2
    t15 = line2*ray0
    t16 = -t15
    t17 = t14 + t16
    t18 = line0*ray1
    t19 = line1*ray0
    t20 = -t19
    t21 = t18 + t20
    t22 = t19 + t19
    t23 = t15 + t15
    t24 = t18 + t18
    t25 = t11 + t11
    t26 = t14 + t14
    t27 = t10 + t10
    t28 = -line0*line1
    t29 = -line0*line2
    t30 = -line1*line2
    return (
        -line0*t4 + ray0*t9,
        -line1*t4 + ray1*t9,
        -line2*t4 + ray2*t9,
        line3*t13 - line4*t17 + line5*t21,
        -t3,
        -t18 + t22,
        -t14 + t23,
        0,
        0,
        0,
        t24 + t20,
        -t0 - t2,
        -t10 + t25,
        0,
        0,
        0,
        t26 + t16,
        t27 + t12,
        -t0 - t1,
        0,
        0,
        0,
        -line4*ray2 + line5*ray1,
        line3*ray2 - line5*ray0,
        -line3*ray1 + line4*ray0,
        t13,
        -t17,
        t21,
        t8,
        t28,
        t29,
        t28,
        t5 + t7,
        t30,
        t29,
        t30,
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
    t1 = t0*t0
    t2 = eye0*line5 - eye2*line3 + line1
    t3 = t2*t2
    t4 = -eye1*line5 + eye2*line4 + line0
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = 1/t6
    t8 = (line3*t4 + line4*t2 + line5*t0)*t7
    t9 = line5 - t0*t8
    t10 = line4 - t2*t8
    t11 = line3 - t4*t8
    return (
        eye1*t9 - eye2*t10 + t4,
        -eye0*t9 + eye2*t11 + t2,
        eye0*t10 - eye1*t11 + t0,
        t11,
        t10,
        t9,
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
    t11 = 1/t10
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
    t25 = t22 + t22
    t26 = line3 - t25
    t27 = t11*t26
    t28 = eye1*t2
    t29 = t12 + t12
    t30 = t17 + t17
    t31 = t29 + t15 - t30*t7
    t32 = t20 + t20
    t33 = line4 - t32
    t34 = t14 + t14
    t35 = t12 + t13 + t34 - t3*t30
    t36 = t18 + t18
    t37 = line5 - t36
    t38 = -t24 + t28
    t39 = eye1*t16
    t40 = line0*t2 - t36*t38 + t39
    t41 = eye2*t16
    t42 = line0*t6 - t32*t38 - t41
    t43 = eye0*t2
    t44 = eye2*t8
    t45 = t43 - t44
    t46 = eye0*t16
    t47 = line1*t2 + t36*t45 - t46
    t48 = t11*t47
    t49 = t11*t6
    t50 = t11*t11
    t51 = t16*t50
    t52 = t51 + t51
    t53 = line1*t49 + t45*t52*t6 - 1
    t54 = t11*t2
    t55 = eye0*t6
    t56 = -eye1*t8 + t55
    t57 = t2*t52
    t58 = line2*t6 - t32*t56 + t46
    t59 = t11*t58
    t60 = t13 + t13
    t61 = t12 + t60 + t14 - t30*t9
    t62 = t11*t33
    t63 = t11*t40
    t64 = t11*t8
    t65 = t52*t8
    t66 = line1*t8 + t25*t45 + t41
    t67 = -line2*t11*t2 + t56*t57 + 1
    t68 = line2*t8 - t25*t56 - t39
    t69 = t11*t68
    t70 = eye1*t8
    t71 = t11*t37
    t72 = t11*t42
    t73 = -line0*t11*t8 + t38*t65 + 1
    t74 = t11*t66
    t75 = line4 + line4
    t76 = line5 + line5
    t77 = t75*t2 - t76*t6
    t78 = line4 - t54*t77
    t79 = line5 + t49*t77
    t80 = line3 + line3
    t81 = t80*t2 - t76*t8
    t82 = line3 - t54*t81
    t83 = t11*t81
    t84 = t80*t6 - t75*t8
    t85 = line3 - t49*t84
    t86 = t11*t84
    t87 = t11*t77
    t88 = line5 + t64*t81
    t89 = line4 + t64*t84
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
        -(line2*t54 - t56*t57 - 1)*eye1 - eye1 + eye2*t59,
        (-eye2*t61 + t26*t43)*t11,
        t43*t62 - t44*t62 + 1,
        (eye0*t35 - t37*t44)*t11,
        eye0*t63 - (line0*t64 - t38*t65 - 1)*eye2 - eye2,
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
        -(eye2*t85 - line1 + t28*t86 - t4 + t5)*t17,
        -(eye0*t78 - line2 - t0 + t1 + t44*t87)*t17,
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


def from_rays(rays, slopes):
    """from_rays: value."""
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    slopes0, slopes1 = slopes
    t0 = rays1*rays5 - rays2*rays4
    t1 = t0*t0
    t2 = rays0*rays4 - rays1*rays3
    t3 = t2*t2
    t4 = rays0*rays5 - rays2*rays3
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = 1/t6
    t8 = sqrt(t7)
    t9 = rays0 - rays3
    t10 = t9*t9
    t11 = rays1 - rays4
    t12 = t11*t11
    t13 = rays2 - rays5
    t14 = t13*t13
    t15 = t10 + t12 + t14
    t16 = 1/t15
    t17 = sqrt(t16)
    t18 = slopes1*t8
    t19 = -t11
    t20 = -t4
    return (
        t0*t8,
        -t4*t8,
        t2*t8,
        -(slopes0*t9 + (t19*t2 + t13*t20)*t18)*t17,
        -(slopes0*t11 - (t0*t13 - t2*t9)*t18)*t17,
        -(slopes0*t13 + (-t0*t19 - t20*t9)*t18)*t17,
    )


def from_rays_jac(rays, slopes):
    """from_rays: value and Jacobians."""
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    slopes0, slopes1 = slopes
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
    t16 = rays0 - rays3
    t17 = t16*t16
    t18 = rays1 - rays4
    t19 = t18*t18
    t20 = rays2 - rays5
    t21 = t20*t20
    t22 = t17 + t19 + t21
    t23 = 1/t22
    t24 = sqrt(t23)
    t25 = slopes0*t16
    t26 = slopes1*t15
    t27 = -t18
    t28 = t10*t27
    t29 = -t20
    t30 = -t2
    t31 = t29*t30
    t32 = t10*t16
    t33 = -t20*t6 + t32
    t34 = slopes0*t18
    t35 = -t16
    t36 = t30*t35
    t37 = t27*t6
    t38 = rays4*t10
    t39 = rays5*t2 + t38
    t40 = t14*t15
    t41 = t40*t6
    t42 = rays3*t10 - rays5*t6
    t43 = t14*t6
    t44 = rays4*t6
    t45 = rays3*t30 - t44
    t46 = rays1*t10
    t47 = rays2*t2 + t46
    t48 = rays0*t10 - rays2*t6
    t49 = rays1*t6
    t50 = rays0*t2 + t49
    t51 = -rays5*t30 + t38
    t52 = t14*t2
    t53 = t2*t40
    t54 = -rays3*t2 - t44
    t55 = -t50
    t56 = t10*t14
    t57 = t10*t40
    t58 = t30*t30
    t59 = t58 + t12
    t60 = 1/t59
    t61 = -t51*t60
    t62 = rays4*t27
    t63 = rays5*t29
    t64 = t35*t35
    t65 = t27*t27
    t66 = t29*t29
    t67 = t64 + t65 + t66
    t68 = 1/t67
    t69 = t35*t68
    t70 = t28*t69
    t71 = t31*t69
    t72 = slopes0*t23
    t73 = slopes0 - t17*t72
    t74 = t18*t23
    t75 = t2*t20
    t76 = t14*t42
    t77 = t10*t18
    t78 = -t8 + t9
    t79 = t25*t74
    t80 = -t45*t60
    t81 = t28*t68
    t82 = t20*t23
    t83 = t25*t82
    t84 = t14*t47
    t85 = rays1*t18
    t86 = rays2*t20
    t87 = t32*t74
    t88 = t16*t23
    t89 = t75*t88
    t90 = t31*t68
    t91 = -t48*t60
    t92 = (rays0*t30 - t49)*t60
    t93 = t6*t68
    t94 = t29*t93
    t95 = t10*t68
    t96 = t10*t35
    t97 = t29*t6
    t98 = t42*t60
    t99 = rays3*t35
    t100 = t29*t68
    t101 = t100*t37
    t102 = t19*t72
    t103 = -t4 + t5
    t104 = t14*t45
    t105 = t20*t6
    t106 = t34*t82
    t107 = (-rays2*t30 + t46)*t60
    t108 = -slopes0
    t109 = rays0*t16
    t110 = t105*t74
    t111 = t14*t48
    t112 = t18*t6
    t113 = t14*t39
    t114 = t16*t2
    t115 = -t0 + t1
    t116 = t36*t68
    t117 = t21*t72
    t118 = t37*t68
    t119 = t14*t55
    t120 = t15*t24
    return (
        t15*t6,
        -t15*t2,
        t10*t15,
        -(t25 + (t28 - t31)*t26)*t24,
        -(t26*t33 + t34)*t24,
        -(slopes0*t20 + (t36 - t37)*t26)*t24,
        -t39*t41,
        (rays5 + t42*t43)*t15,
        -(rays4 + t43*t45)*t15,
        t41*t47,
        -(rays2 + t43*t48)*t15,
        (rays1 - t43*t50)*t15,
        -(rays5 - t51*t52)*t15,
        -t42*t53,
        (rays3 + t52*t54)*t15,
        (rays2 - t47*t52)*t15,
        t48*t53,
        -(rays0 + t52*t55)*t15,
        (rays4 - t39*t56)*t15,
        -(rays3 - t42*t56)*t15,
        -t54*t57,
        -(rays1 - t47*t56)*t15,
        (rays0 - t48*t56)*t15,
        -t50*t57,
        -((t28*t61 - t31*t61 + t62 + t63 + t70 - t71)*t26 + t73)*t24,
        (-(rays3*t18 + t10*t19*t23 + t74*t75 - t75*t76 - t76*t77 + t78)*t26 + t79)*t24,
        ((rays3*t29 - t28*t80 - t29*t81 + t30*t66*t68 + t31*t80 + t2)*t26 + t83)*t24,
        ((t75*t84 + t77*t84 - t85 - t86 + t87 + t89)*t26 + t73)*t24,
        -((rays0*t27 + t18*t81 - t18*t90 + t28*t91 - t31*t91 + t10)*t26 + t79)*t24,
        -((rays0*t29 + t20*t81 - t20*t90 + t28*t92 - t31*t92 + t2)*t26 + t83)*t24,
        ((rays4*t35 - t35*t94 + t64*t95 + t61*t96 - t61*t97 + t78)*t26 + t79)*t24,
        -(slopes0 + (t63 - t70 - t96*t98 + t97*t98 + t99 + t101)*t26 - t102)*t24,
        (-(rays4*t20 + t103 + t21*t23*t6 - t32*t82 - t104*t32 + t104*t105)*t26 + t106)*t24,
        -((rays1*t35 - t107*t96 + t107*t97 + t16*t94 - t32*t69 + t78)*t26 + t79)*t24,
        (-t108 - (t109 - t110 - t111*t32 + t105*t111 + t86 + t87)*t26 - t102)*t24,
        -((rays1*t29 - t20*t35*t95 + t6 - t92*t96 + t92*t97 + t100*t105)*t26 + t106)*t24,
        ((-rays5*t16 + t112*t113 + t112*t88 + t113*t114 + t115 + t17*t2*t23)*t26 + t83)*t24,
        ((rays5*t27 + t103 - t116*t27 - t36*t98 + t37*t98 + t65*t93)*t26 + t106)*t24,
        -(slopes0 - t117 + (t36*t80 - t37*t80 + t62 + t71 + t99 - t101)*t26)*t24,
        -((rays2*t35 + t107*t36 - t107*t37 + t115 + t116*t16 - t118*t16)*t26 + t83)*t24,
        -((rays2*t27 + t103 + t116*t18 - t118*t18 + t36*t91 - t37*t91)*t26 + t106)*t24,
        (-t108 - t117 - (t109 + t110 + t112*t119 + t114*t119 + t85 + t89)*t26)*t24,
        0,
        0,
        0,
        0,
        0,
        0,
        -t16*t24,
        -(-t75 - t77)*t120,
        -t18*t24,
        -t120*t33,
        -t20*t24,
        -(t112 + t114)*t120,
    )
