"""Generated from slamlib/landmarks/hmg_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "45b4c0f0a4cddb40",
    "from_frame": "816cc3f38615ce12",
    "to_point": "485ab31d33d8919e",
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
    t0 = landmark1 - landmark3*pose1
    t1 = t0 + t0
    t2 = pose3*pose6
    t3 = pose4*pose5
    t4 = landmark2 - landmark3*pose2
    t5 = t4 + t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = landmark0 - landmark3*pose0
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
        landmark3,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = landmark0 - landmark3*pose0
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
    t11 = landmark1 - landmark3*pose1
    t12 = t11 + t11
    t13 = pose3*pose5
    t14 = pose4*pose6
    t15 = t13 - t14
    t16 = landmark2 - landmark3*pose2
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
    t31 = landmark3 + landmark3
    t32 = t10 + t10
    t33 = t15 + t15
    t34 = pose1 + pose1
    t35 = pose2 + pose2
    t36 = t22 + t22
    t37 = t21 + t21
    t38 = pose0 + pose0
    t39 = t27 + t27
    t40 = t28 + t28
    return (
        t18,
        t26,
        t30,
        landmark3,
        -landmark3*t7,
        -t10*t31,
        t15*t31,
        0,
        -t30,
        t26,
        t22*t31,
        -landmark3*t25,
        -t21*t31,
        t30,
        0,
        -t18,
        -t27*t31,
        t28*t31,
        -landmark3*t29,
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
        t32,
        -t33,
        -pose0*t7 - t10*t34 + t15*t35,
        -t36,
        t25,
        t37,
        -pose1*t25 - t21*t35 + t22*t38,
        t39,
        -t40,
        t29,
        -pose2*t29 - t27*t38 + t28*t34,
        0,
        0,
        0,
        1,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
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
        (t2 + t3 + t5)*point0 + point3*pose0 + (t7 + t8)*t6 - (t10 - t11)*t9,
        (t2 + t12 + t4)*point1 + point3*pose1 + (t10 + t11)*t13 - (t14 - t15)*t6,
        (t0 + t12 + t5 + t1)*point2 + point3*pose2 - (t7 - t8)*t13 + (t14 + t15)*t9,
        point3,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
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
        point0*t6 + point3*pose0 + t10*t9 - t13*t14,
        point1*t16 + point3*pose1 + t17*t18 - t10*t21,
        point2*t22 + point3*pose2 - t18*t23 + t14*t24,
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
        t6,
        -t43,
        t44,
        pose0,
        t45,
        t16,
        -t46,
        pose1,
        -t47,
        t48,
        t22,
        pose2,
        0,
        0,
        0,
        1,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = 1/landmark3
    return (
        landmark0*t0,
        landmark1*t0,
        landmark2*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = 1/landmark3
    t1 = t0*t0
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
