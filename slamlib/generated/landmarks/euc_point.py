"""Generated from slamlib/landmarks/euc_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "4cd5e9bfc21d1b38",
    "from_frame": "bf1e0351f66c4e4b",
    "to_point": "53872251799d31d7",
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
    t0 = landmark1 - pose1
    t1 = t0 + t0
    t2 = pose3*pose6
    t3 = pose4*pose5
    t4 = landmark2 - pose2
    t5 = t4 + t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = landmark0 - pose0
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
        1,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2 = landmark
    t0 = landmark0 - pose0
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
    t11 = landmark1 - pose1
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = landmark2 - pose2
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
        1,
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
        0,
        0,
        0,
        0,
        0,
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
        0,
        0,
        0,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/point3
    point0_ = point0*t0
    t1 = pose3*pose3
    t2 = pose6*pose6
    t3 = t1 - t2
    t4 = pose4*pose4
    t5 = pose5*pose5
    t6 = -t5
    point2_ = point2*t0
    t7 = point2_ + point2_
    t8 = pose3*pose5
    t9 = pose4*pose6
    point1_ = point1*t0
    t10 = point1_ + point1_
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = -t4
    t14 = point0_ + point0_
    t15 = pose3*pose4
    t16 = pose5*pose6
    return (
        (t3 + t4 + t6)*point0_ + pose0 + (t8 + t9)*t7 - (t11 - t12)*t10,
        (t3 + t13 + t5)*point1_ + pose1 + (t11 + t12)*t14 - (t15 - t16)*t7,
        (t1 + t2 + t13 + t6)*point2_ + pose2 - (t8 - t9)*t14 + (t15 + t16)*t10,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/point3
    point0_ = point0*t0
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    t6 = pose4*pose4
    t7 = t2 + t5 + t6
    t8 = pose3*pose5
    t9 = pose4*pose6
    t10 = t8 + t9
    point2_ = point2*t0
    t11 = point2_ + point2_
    t12 = pose3*pose6
    t13 = pose4*pose5
    t14 = t12 - t13
    point1_ = point1*t0
    t15 = point1_ + point1_
    t16 = -t6
    t17 = t1 + t5 + t16
    t18 = t12 + t13
    t19 = point0_ + point0_
    t20 = pose3*pose4
    t21 = pose5*pose6
    t22 = t20 - t21
    t23 = t2 + t3 + t4 + t16
    t24 = t8 - t9
    t25 = t20 + t21
    t26 = point0_*pose6 + point1_*pose3 - point2_*pose4
    t27 = pose5*t26
    t28 = point0_*pose3 - point1_*pose6 + point2_*pose5
    t29 = pose4*t28
    t30 = point0_*pose4 + point1_*pose5 + point2_*pose6
    t31 = pose3*t30
    t32 = -point0_*pose5 + point1_*pose4 + point2_*pose3
    t33 = pose6*t32
    t34 = t31 + t33
    t35 = pose6*t30
    t36 = pose3*t32
    t37 = pose4*t26 + pose5*t28
    t38 = pose3*t26
    t39 = pose5*t30
    t40 = pose4*t32 + pose6*t28
    t41 = pose4*t30
    t42 = pose3*t28
    t43 = pose5*t32 + pose6*t26
    t44 = t0 + t0
    t45 = t0*t0
    t46 = point2 + point2
    t47 = point1 + point1
    t48 = point0 + point0
    return (
        point0_*t7 + pose0 + t10*t11 - t14*t15,
        point1_*t17 + pose1 + t18*t19 - t11*t22,
        point2_*t23 + pose2 - t19*t24 + t15*t25,
        1,
        0,
        0,
        t27 - t29 + t34,
        -t35 + t36 - t37,
        -t38 + t39 - t40,
        0,
        1,
        0,
        t35 - t36 - t37,
        -t27 + t29 + t34,
        -t41 + t42 - t43,
        0,
        0,
        1,
        t38 - t39 - t40,
        t41 - t42 - t43,
        t27 + t29 + t31 - t33,
        t0*t7,
        -t14*t44,
        t10*t44,
        -(point0*t7 + t10*t46 - t14*t47)*t45,
        t18*t44,
        t0*t17,
        -t22*t44,
        -(point1*t17 + t18*t48 - t22*t46)*t45,
        -t24*t44,
        t25*t44,
        t0*t23,
        -(point2*t23 + t25*t47 - t24*t48)*t45,
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
