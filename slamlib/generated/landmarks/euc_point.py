"""Generated from slamlib/landmarks/euc_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "f38ff6118a6be19c",
    "from_frame": "de367241f493e194",
    "to_point": "b48bee403e1c286b",
}
SHAPES = {
    "to_frame": (4,),
    "from_frame": (3,),
    "to_point": (3,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = landmark1 - pose1
    t3 = 2*t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = landmark2 - pose2
    t7 = 2*t6
    t8 = landmark0 - pose0
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
        1,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 - pose2
    t9 = 2*t8
    t10 = landmark0 - pose0
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
        1,
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
        0,
        0,
        0,
        0,
        0,
        0,
        t17,
        t28,
        -2*t7,
        -2*t21,
        t24,
        t36,
        t38,
        -2*t26,
        t27,
        0,
        0,
        0,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 - pose2
    t9 = 2*t8
    t10 = landmark0 - pose0
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
        1,
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
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t17,
        t28,
        -2*t7,
        -2*t21,
        t24,
        t35,
        t37,
        -2*t26,
        t27,
        0,
        0,
        0,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = 1/(point3)
    t3 = point2*t2
    t4 = 2*t3
    t5 = pose3*pose6
    t6 = pose4*pose5
    t7 = point1*t2
    t8 = 2*t7
    t9 = pose4*pose4
    t10 = pose5*pose5
    t11 = -t10
    t12 = pose3*pose3
    t13 = pose6*pose6
    t14 = t12 - t13
    t15 = point0*t2
    t16 = 2*t15
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = -t9
    return (
        pose0 + t15*(t11 + t14 + t9) + t4*(t0 + t1) - t8*(t5 - t6),
        pose1 + t16*(t5 + t6) - t4*(t17 - t18) + t7*(t10 + t14 + t19),
        pose2 - t16*(t0 - t1) + t3*(t11 + t12 + t13 + t19) + t8*(t17 + t18),
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 1/(point3)
    t4 = 2*t3
    t5 = t2*t4
    t6 = pose3*pose6
    t7 = pose4*pose5
    t8 = t6 - t7
    t9 = t4*t8
    t10 = pose4*pose4
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose6*pose6
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = t16*t3
    t18 = t6 + t7
    t19 = t18*t4
    t20 = pose3*pose4
    t21 = pose5*pose6
    t22 = t20 - t21
    t23 = t22*t4
    t24 = -t10
    t25 = t11 + t15 + t24
    t26 = t25*t3
    t27 = t20 + t21
    t28 = t27*t4
    t29 = t0 - t1
    t30 = t29*t4
    t31 = t12 + t13 + t14 + t24
    t32 = t3*t31
    t33 = point0*pose6 + point1*pose3 - point2*pose4
    t34 = pose5*t33
    t35 = point0*pose3 - point1*pose6 + point2*pose5
    t36 = pose4*t35
    t37 = point0*pose4 + point1*pose5 + point2*pose6
    t38 = pose3*t37
    t39 = -point0*pose5 + point1*pose4 + point2*pose3
    t40 = pose6*t39
    t41 = t38 + t40
    t42 = pose6*t37
    t43 = pose3*t39
    t44 = pose4*t33 + pose5*t35
    t45 = pose3*t33
    t46 = pose5*t37
    t47 = pose4*t39 + pose6*t35
    t48 = pose4*t37
    t49 = pose3*t35
    t50 = pose5*t39 + pose6*t33
    t51 = 1/(point3*point3)
    return (
        point0*t17 - point1*t9 + point2*t5 + pose0,
        point0*t19 + point1*t26 - point2*t23 + pose1,
        -point0*t30 + point1*t28 + point2*t32 + pose2,
        1,
        0,
        0,
        t3*(t34 - t36 + t41),
        t3*(-t42 + t43 - t44),
        t3*(-t45 + t46 - t47),
        0,
        1,
        0,
        t3*(t42 - t43 - t44),
        t3*(-t34 + t36 + t41),
        t3*(-t48 + t49 - t50),
        0,
        0,
        1,
        t3*(t45 - t46 - t47),
        t3*(t48 - t49 - t50),
        t3*(t34 + t36 + t38 - t40),
        t17,
        -t9,
        t5,
        t51*(-point0*t16 + 2*point1*t8 - 2*point2*t2),
        t19,
        t26,
        -t23,
        t51*(-2*point0*t18 - point1*t25 + 2*point2*t22),
        -t30,
        t28,
        t32,
        t51*(2*point0*t29 - 2*point1*t27 - point2*t31),
    )


def from_frame_storage_jac(pose, point):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 + t1
    t3 = 1/(point3)
    t4 = 2*t3
    t5 = t2*t4
    t6 = pose3*pose6
    t7 = pose4*pose5
    t8 = t6 - t7
    t9 = t4*t8
    t10 = pose4*pose4
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose6*pose6
    t15 = t13 - t14
    t16 = t10 + t12 + t15
    t17 = t16*t3
    t18 = t6 + t7
    t19 = t18*t4
    t20 = pose3*pose4
    t21 = pose5*pose6
    t22 = t20 - t21
    t23 = t22*t4
    t24 = -t10
    t25 = t11 + t15 + t24
    t26 = t25*t3
    t27 = t20 + t21
    t28 = t27*t4
    t29 = t0 - t1
    t30 = t29*t4
    t31 = t12 + t13 + t14 + t24
    t32 = t3*t31
    t33 = point0*pose3 - point1*pose6 + point2*pose5
    t34 = t33*t4
    t35 = t4*(point0*pose4 + point1*pose5 + point2*pose6)
    t36 = -point0*pose5 + point1*pose4 + point2*pose3
    t37 = t36*t4
    t38 = point0*pose6 + point1*pose3 - point2*pose4
    t39 = t38*t4
    t40 = 1/(point3*point3)
    return (
        point0*t17 - point1*t9 + point2*t5 + pose0,
        point0*t19 + point1*t26 - point2*t23 + pose1,
        -point0*t30 + point1*t28 + point2*t32 + pose2,
        1,
        0,
        0,
        t34,
        t35,
        t37,
        -t38*t4,
        0,
        1,
        0,
        t39,
        -t36*t4,
        t35,
        t34,
        0,
        0,
        1,
        t37,
        t39,
        -t33*t4,
        t35,
        t17,
        -t9,
        t5,
        t40*(-point0*t16 + 2*point1*t8 - 2*point2*t2),
        t19,
        t26,
        -t23,
        t40*(-2*point0*t18 - point1*t25 + 2*point2*t22),
        -t30,
        t28,
        t32,
        t40*(2*point0*t29 - 2*point1*t27 - point2*t31),
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2 = landmark
    return (
        landmark0,
        landmark1,
        landmark2,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2 = landmark
    return (
        landmark0,
        landmark1,
        landmark2,
        1,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        1,
    )
