"""Generated from slamlib/landmarks/hmg_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "b657c4fec3297fa3",
    "from_frame": "3c70e54c3a0c6e76",
    "to_point": "694baf9665c44e8d",
}
SHAPES = {
    "to_frame": (4,),
    "from_frame": (4,),
    "to_point": (3,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = landmark1 - landmark3*pose1
    t3 = 2*t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = landmark2 - landmark3*pose2
    t7 = 2*t6
    t8 = landmark0 - landmark3*pose0
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
        landmark3,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - landmark3*pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 - landmark3*pose2
    t9 = 2*t8
    t10 = landmark0 - landmark3*pose0
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
    t28 = 2*landmark3
    t29 = pose4*t10 + pose5*t3 + pose6*t8
    t30 = pose3*t10 - pose5*t8 + pose6*t3
    t31 = pose3*t3 + pose4*t8 - pose6*t10
    t32 = pose3*t8 - pose4*t3 + pose5*t10
    t33 = pose3*t29 - pose4*t30 - pose5*t31 - pose6*t32
    t34 = pose3*t32 - pose4*t31 + pose5*t30 + pose6*t29
    t35 = pose3*t31 + pose4*t32 + pose5*t29 - pose6*t30
    t36 = pose3*t30 + pose4*t29 - pose5*t32 + pose6*t31
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        landmark3,
        -landmark3*t17,
        -t2*t28,
        t28*t7,
        t33,
        -t34,
        t35,
        t21*t28,
        -landmark3*t24,
        -t20*t28,
        t34,
        t33,
        -t36,
        -t25*t28,
        t26*t28,
        -landmark3*t27,
        -t35,
        t36,
        t33,
        0,
        0,
        0,
        0,
        0,
        0,
        t17,
        2*t2,
        -2*t7,
        -pose0*t17 - 2*pose1*t2 + 2*pose2*t7,
        -2*t21,
        t24,
        2*t20,
        2*pose0*t21 - pose1*t24 - 2*pose2*t20,
        2*t25,
        -2*t26,
        t27,
        -2*pose0*t25 + 2*pose1*t26 - pose2*t27,
        0,
        0,
        0,
        1,
    )


def to_frame_storage_jac(pose, landmark):
    """to_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - landmark3*pose1
    t4 = 2*t3
    t5 = pose3*pose5
    t6 = pose4*pose6
    t7 = t5 - t6
    t8 = landmark2 - landmark3*pose2
    t9 = 2*t8
    t10 = landmark0 - landmark3*pose0
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
    t28 = 2*landmark3
    t29 = pose3*t10 - pose5*t8 + pose6*t3
    t30 = 2*t29
    t31 = 2*pose4*t10 + 2*pose5*t3 + 2*pose6*t8
    t32 = pose3*t8 - pose4*t3 + pose5*t10
    t33 = pose3*t3 + pose4*t8 - pose6*t10
    t34 = 2*t33
    t35 = 2*t32
    return (
        t10*t17 + t2*t4 - t7*t9,
        t20*t9 - t21*t22 + t24*t3,
        t22*t25 - t26*t4 + t27*t8,
        landmark3,
        -landmark3*t17,
        -t2*t28,
        t28*t7,
        t30,
        t31,
        -2*t32,
        t34,
        t21*t28,
        -landmark3*t24,
        -t20*t28,
        t34,
        t35,
        t31,
        -2*t29,
        -t25*t28,
        t26*t28,
        -landmark3*t27,
        t35,
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
        2*t2,
        -2*t7,
        -pose0*t17 - 2*pose1*t2 + 2*pose2*t7,
        -2*t21,
        t24,
        2*t20,
        2*pose0*t21 - pose1*t24 - 2*pose2*t20,
        2*t25,
        -2*t26,
        t27,
        -2*pose0*t25 + 2*pose1*t26 - pose2*t27,
        0,
        0,
        0,
        1,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
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
        point0*(t11 + t6 + t8) + point3*pose0 + t2*(t0 + t1) - t5*(t3 - t4),
        point1*(t11 + t15 + t7) + point3*pose1 + t12*(t3 + t4) - t2*(t13 - t14),
        point2*(t10 + t15 + t8 + t9) + point3*pose2 - t12*(t0 - t1) + t5*(t13 + t14),
        point3,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
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
        point0*t14 + point3*pose0 + t2*t3 - t6*t7,
        point1*t21 + point3*pose1 + t15*t16 - t19*t3,
        point2*t24 + point3*pose2 - t16*t23 + t22*t7,
        point3,
        point3,
        0,
        0,
        t26 - t28 + t33,
        -t34 + t35 - t36,
        -t37 + t38 - t39,
        0,
        point3,
        0,
        t34 - t35 - t36,
        -t26 + t28 + t33,
        -t40 + t41 - t42,
        0,
        0,
        point3,
        t37 - t38 - t39,
        t40 - t41 - t42,
        t26 + t28 + t30 - t32,
        0,
        0,
        0,
        0,
        0,
        0,
        t14,
        -2*t6,
        2*t2,
        pose0,
        2*t15,
        t21,
        -2*t19,
        pose1,
        -2*t23,
        2*t22,
        t24,
        pose2,
        0,
        0,
        0,
        1,
    )


def from_frame_storage_jac(pose, point):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
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
        point0*t14 + point3*pose0 + t2*t3 - t6*t7,
        point1*t21 + point3*pose1 + t15*t16 - t19*t3,
        point2*t24 + point3*pose2 - t16*t23 + t22*t7,
        point3,
        point3,
        0,
        0,
        t26,
        t27,
        t29,
        -2*t30,
        0,
        point3,
        0,
        t31,
        -2*t28,
        t27,
        t26,
        0,
        0,
        point3,
        t29,
        t31,
        -2*t25,
        t27,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t14,
        -2*t6,
        2*t2,
        pose0,
        2*t15,
        t21,
        -2*t19,
        pose1,
        -2*t23,
        2*t22,
        t24,
        pose2,
        0,
        0,
        0,
        1,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = 1/(landmark3)
    return (
        landmark0*t0,
        landmark1*t0,
        landmark2*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = 1/(landmark3)
    t1 = 1/(landmark3*landmark3)
    return (
        landmark0*t0,
        landmark1*t0,
        landmark2*t0,
        t0,
        0,
        0,
        -landmark0*t1,
        0,
        t0,
        0,
        -landmark1*t1,
        0,
        0,
        t0,
        -landmark2*t1,
    )
