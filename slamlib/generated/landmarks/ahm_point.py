"""Generated from slamlib/landmarks/ahm_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "a98cbee92992b5e1",
    "from_frame": "94e740555af27738",
    "to_point": "b84ae92567922cd4",
}
SHAPES = {
    "to_frame": (4,),
    "from_frame": (7,),
    "to_point": (3,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = landmark4 + landmark6*(landmark1 - pose1)
    t3 = 2*t2
    t4 = pose3*pose5
    t5 = pose4*pose6
    t6 = landmark5 + landmark6*(landmark2 - pose2)
    t7 = 2*t6
    t8 = landmark3 + landmark6*(landmark0 - pose0)
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
        landmark6,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - pose1
    t4 = landmark4 + landmark6*t3
    t5 = 2*t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = t6 - t7
    t9 = landmark2 - pose2
    t10 = landmark5 + landmark6*t9
    t11 = 2*t10
    t12 = landmark0 - pose0
    t13 = landmark3 + landmark6*t12
    t14 = pose4*pose4
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose6*pose6
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t0 - t1
    t25 = 2*t13
    t26 = -t14
    t27 = t15 + t19 + t26
    t28 = t6 + t7
    t29 = t21 - t22
    t30 = t16 + t17 + t18 + t26
    t31 = landmark6*t20
    t32 = 2*landmark6
    t33 = t2*t32
    t34 = t32*t8
    t35 = pose4*t13 + pose5*t4 + pose6*t10
    t36 = pose3*t13 - pose5*t10 + pose6*t4
    t37 = pose3*t4 + pose4*t10 - pose6*t13
    t38 = pose3*t10 - pose4*t4 + pose5*t13
    t39 = pose3*t35 - pose4*t36 - pose5*t37 - pose6*t38
    t40 = pose3*t38 - pose4*t37 + pose5*t36 + pose6*t35
    t41 = pose3*t37 + pose4*t38 + pose5*t35 - pose6*t36
    t42 = t24*t32
    t43 = landmark6*t27
    t44 = t23*t32
    t45 = pose3*t36 + pose4*t35 - pose5*t38 + pose6*t37
    t46 = t28*t32
    t47 = t29*t32
    t48 = landmark6*t30
    t49 = 2*t3
    t50 = 2*t9
    t51 = 2*t12
    return (
        -t11*t8 + t13*t20 + t2*t5,
        t11*t23 - t24*t25 + t27*t4,
        t10*t30 + t25*t28 - t29*t5,
        landmark6,
        -t31,
        -t33,
        t34,
        t39,
        -t40,
        t41,
        t42,
        -t43,
        -t44,
        t40,
        t39,
        -t45,
        -t46,
        t47,
        -t48,
        -t41,
        t45,
        t39,
        0,
        0,
        0,
        0,
        0,
        0,
        t31,
        t33,
        -t34,
        t20,
        2*t2,
        -2*t8,
        t12*t20 + t2*t49 - t50*t8,
        -t42,
        t43,
        t44,
        -2*t24,
        t27,
        2*t23,
        t23*t50 - t24*t51 + t27*t3,
        t46,
        -t47,
        t48,
        2*t28,
        -2*t29,
        t30,
        t28*t51 - t29*t49 + t30*t9,
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
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = t0 + t1
    t3 = landmark1 - pose1
    t4 = landmark4 + landmark6*t3
    t5 = 2*t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = t6 - t7
    t9 = landmark2 - pose2
    t10 = landmark5 + landmark6*t9
    t11 = 2*t10
    t12 = landmark0 - pose0
    t13 = landmark3 + landmark6*t12
    t14 = pose4*pose4
    t15 = pose5*pose5
    t16 = -t15
    t17 = pose3*pose3
    t18 = pose6*pose6
    t19 = t17 - t18
    t20 = t14 + t16 + t19
    t21 = pose3*pose4
    t22 = pose5*pose6
    t23 = t21 + t22
    t24 = t0 - t1
    t25 = 2*t13
    t26 = -t14
    t27 = t15 + t19 + t26
    t28 = t6 + t7
    t29 = t21 - t22
    t30 = t16 + t17 + t18 + t26
    t31 = landmark6*t20
    t32 = 2*landmark6
    t33 = t2*t32
    t34 = t32*t8
    t35 = pose3*t13 - pose5*t10 + pose6*t4
    t36 = 2*t35
    t37 = 2*pose4*t13 + 2*pose5*t4 + 2*pose6*t10
    t38 = pose3*t10 - pose4*t4 + pose5*t13
    t39 = pose3*t4 + pose4*t10 - pose6*t13
    t40 = 2*t39
    t41 = t24*t32
    t42 = landmark6*t27
    t43 = t23*t32
    t44 = 2*t38
    t45 = t28*t32
    t46 = t29*t32
    t47 = landmark6*t30
    t48 = 2*t3
    t49 = 2*t9
    t50 = 2*t12
    return (
        -t11*t8 + t13*t20 + t2*t5,
        t11*t23 - t24*t25 + t27*t4,
        t10*t30 + t25*t28 - t29*t5,
        landmark6,
        -t31,
        -t33,
        t34,
        t36,
        t37,
        -2*t38,
        t40,
        t41,
        -t42,
        -t43,
        t40,
        t44,
        t37,
        -2*t35,
        -t45,
        t46,
        -t47,
        t44,
        -2*t39,
        t36,
        t37,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t31,
        t33,
        -t34,
        t20,
        2*t2,
        -2*t8,
        t12*t20 + t2*t48 - t49*t8,
        -t41,
        t42,
        t43,
        -2*t24,
        t27,
        2*t23,
        t23*t49 - t24*t50 + t27*t3,
        t45,
        -t46,
        t47,
        2*t28,
        -2*t29,
        t30,
        t28*t50 - t29*t48 + t30*t9,
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
        pose0,
        pose1,
        pose2,
        point0*(t11 + t6 + t8) + t2*(t0 + t1) - t5*(t3 - t4),
        point1*(t11 + t15 + t7) + t12*(t3 + t4) - t2*(t13 - t14),
        point2*(t10 + t15 + t8 + t9) - t12*(t0 - t1) + t5*(t13 + t14),
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
        pose0,
        pose1,
        pose2,
        point0*t14 + t2*t3 - t6*t7,
        point1*t21 + t15*t16 - t19*t3,
        point2*t24 - t16*t23 + t22*t7,
        point3,
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
        t26 - t28 + t33,
        -t34 + t35 - t36,
        -t37 + t38 - t39,
        0,
        0,
        0,
        t34 - t35 - t36,
        -t26 + t28 + t33,
        -t40 + t41 - t42,
        0,
        0,
        0,
        t37 - t38 - t39,
        t40 - t41 - t42,
        t26 + t28 + t30 - t32,
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
        t14,
        -2*t6,
        2*t2,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        -2*t23,
        2*t22,
        t24,
        0,
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
        pose0,
        pose1,
        pose2,
        point0*t14 + t2*t3 - t6*t7,
        point1*t21 + t15*t16 - t19*t3,
        point2*t24 - t16*t23 + t22*t7,
        point3,
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
        t26,
        t27,
        t29,
        -2*t30,
        0,
        0,
        0,
        t31,
        -2*t28,
        t27,
        t26,
        0,
        0,
        0,
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
        t14,
        -2*t6,
        2*t2,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        -2*t23,
        2*t22,
        t24,
        0,
        0,
        0,
        0,
        1,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = 1/(landmark6)
    return (
        landmark0 + landmark3*t0,
        landmark1 + landmark4*t0,
        landmark2 + landmark5*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = 1/(landmark6)
    t1 = 1/(landmark6*landmark6)
    return (
        landmark0 + landmark3*t0,
        landmark1 + landmark4*t0,
        landmark2 + landmark5*t0,
        1,
        0,
        0,
        t0,
        0,
        0,
        -landmark3*t1,
        0,
        1,
        0,
        0,
        t0,
        0,
        -landmark4*t1,
        0,
        0,
        1,
        0,
        0,
        t0,
        -landmark5*t1,
    )
