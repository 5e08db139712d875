"""Generated from slamlib/landmarks/plane_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "7abe492a1618075f",
    "from_frame": "3fe015a345e80f34",
    "to_point": "82d1d021bdfe3ab3",
}
SHAPES = {
    "to_frame": (4,),
    "from_frame": (2,),
    "to_point": (3,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1 = landmark
    t0 = pose2 + pose2
    t1 = pose3*pose5
    t2 = pose4*pose6
    t3 = landmark1 - pose1
    t4 = t3 + t3
    t5 = pose3*pose6
    t6 = pose4*pose5
    t7 = landmark0 - pose0
    t8 = pose5*pose5
    t9 = -t8
    t10 = pose3*pose3
    t11 = pose6*pose6
    t12 = t10 - t11
    t13 = pose4*pose4
    t14 = t7 + t7
    t15 = pose3*pose4
    t16 = pose5*pose6
    t17 = -t13
    return (
        (t1 - t2)*t0 + (t5 + t6)*t4 + (t9 + t12 + t13)*t7,
        -(t5 - t6)*t14 - (t15 + t16)*t0 + (t12 + t17 + t8)*t3,
        -(t9 + t10 + t11 + t17)*pose2 + (t1 + t2)*t14 - (t15 - t16)*t4,
        1,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1 = landmark
    t0 = pose4*pose4
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = landmark0 - pose0
    t8 = pose3*pose5
    t9 = pose4*pose6
    t10 = t8 - t9
    t11 = pose2 + pose2
    t12 = pose3*pose6
    t13 = pose4*pose5
    t14 = t12 + t13
    t15 = landmark1 - pose1
    t16 = t15 + t15
    t17 = t6*t7 + t10*t11 + t14*t16
    t18 = pose3*pose4
    t19 = pose5*pose6
    t20 = t18 + t19
    t21 = t12 - t13
    t22 = t7 + t7
    t23 = -t0
    t24 = t1 + t5 + t23
    t25 = t11*t20 + t21*t22 - t15*t24
    t26 = -t25
    t27 = t2 + t3 + t4 + t23
    t28 = t8 + t9
    t29 = t18 - t19
    t30 = pose2*t27 - t22*t28 + t16*t29
    t31 = -t30
    t32 = t14 + t14
    t33 = t10 + t10
    t34 = t21 + t21
    t35 = t20 + t20
    t36 = t28 + t28
    t37 = t29 + t29
    return (
        t17,
        t26,
        t31,
        1,
        -t6,
        -t32,
        t33,
        0,
        t30,
        t26,
        t34,
        -t24,
        -t35,
        t31,
        0,
        -t17,
        -t36,
        t37,
        -t27,
        t25,
        t17,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t6,
        t32,
        -t34,
        t24,
        t36,
        -t37,
        0,
        0,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/point3
    point0_ = point0*t0
    t1 = pose4*pose4
    t2 = pose5*pose5
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    point1_ = point1*t0
    t6 = pose3*pose6
    t7 = pose4*pose5
    t8 = (t6 - t7)
    t9 = t8 + t8
    point2_ = point2*t0
    t10 = point2_ + point2_
    t11 = (t6 + t7)
    t12 = t11 + t11
    return (
        (t1 - t2 + t5)*point0_ - t9*point1_ + pose0 + (pose3*pose5 + pose4*pose6)*t10,
        t12*point0_ + (-t1 + t2 + t5)*point1_ + pose1 - (pose3*pose4 - pose5*pose6)*t10,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = 1/point3
    point0_ = point0*t0
    t1 = pose4*pose4
    t2 = pose5*pose5
    t3 = pose3*pose3
    t4 = pose6*pose6
    t5 = t3 - t4
    t6 = t1 - t2 + t5
    point1_ = point1*t0
    t7 = pose3*pose6
    t8 = t7 + t7
    t9 = pose4*pose5
    t10 = t9 + t9
    t11 = t8 - t10
    t12 = pose3*pose5 + pose4*pose6
    point2_ = point2*t0
    t13 = point2_ + point2_
    t14 = t8 + t10
    t15 = -t1 + t2 + t5
    t16 = pose3*pose4 - pose5*pose6
    t17 = point0_*pose6 + point1_*pose3 - point2_*pose4
    t18 = pose5*t17
    t19 = point0_*pose3 - point1_*pose6 + point2_*pose5
    t20 = pose4*t19
    t21 = point0_*pose4 + point1_*pose5 + point2_*pose6
    t22 = -point0_*pose5 + point1_*pose4 + point2_*pose3
    t23 = pose3*t21 + pose6*t22
    t24 = pose6*t21
    t25 = pose3*t22
    t26 = pose4*t17 + pose5*t19
    t27 = t12 + t12
    t28 = t0*t0
    t29 = t16 + t16
    return (
        point0_*t6 - point1_*t11 + pose0 + t12*t13,
        point0_*t14 + point1_*t15 + pose1 - t13*t16,
        1,
        0,
        0,
        t18 - t20 + t23,
        -t24 + t25 - t26,
        -pose3*t17 - pose4*t22 + pose5*t21 - pose6*t19,
        0,
        1,
        0,
        t24 - t25 - t26,
        -t18 + t20 + t23,
        pose3*t19 - pose4*t21 - pose5*t22 - pose6*t17,
        t0*t6,
        -t0*t11,
        t0*t27,
        -(point0*t6 - point1*t11 + point2*t27)*t28,
        t0*t14,
        t0*t15,
        -t0*t29,
        -(point0*t14 + point1*t15 - point2*t29)*t28,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1 = landmark
    return (
        landmark0,
        landmark1,
        0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1 = landmark
    return (
        landmark0,
        landmark1,
        0,
        1,
        0,
        0,
        1,
        0,
        0,
    )
