"""Generated from slamlib/landmarks/ahm_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "3a73e6983fd33ff2",
    "from_frame": "1c6c64f666062d99",
    "to_point": "5eef459ecc12c1f7",
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
    t0 = landmark4 + (landmark1 - pose1)*landmark6
    t1 = t0 + t0
    t2 = pose3*pose6
    t3 = pose4*pose5
    t4 = landmark5 + (landmark2 - pose2)*landmark6
    t5 = t4 + t4
    t6 = pose3*pose5
    t7 = pose4*pose6
    t8 = landmark3 + (landmark0 - pose0)*landmark6
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
        landmark6,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = landmark2 - pose2
    t1 = landmark5 + landmark6*t0
    t2 = t1 + t1
    t3 = pose3*pose5
    t4 = pose4*pose6
    t5 = t3 - t4
    t6 = landmark0 - pose0
    t7 = landmark3 + landmark6*t6
    t8 = pose4*pose4
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = t8 + t10 + t13
    t15 = pose3*pose6
    t16 = pose4*pose5
    t17 = t15 + t16
    t18 = landmark1 - pose1
    t19 = landmark4 + landmark6*t18
    t20 = t19 + t19
    t21 = -t2*t5 + t14*t7 + t17*t20
    t22 = pose3*pose4
    t23 = pose5*pose6
    t24 = t22 + t23
    t25 = t15 - t16
    t26 = t7 + t7
    t27 = -t8
    t28 = t9 + t13 + t27
    t29 = t2*t24 - t25*t26 + t19*t28
    t30 = t10 + t11 + t12 + t27
    t31 = t3 + t4
    t32 = t22 - t23
    t33 = t1*t30 + t26*t31 - t20*t32
    t34 = landmark6*t14
    t35 = landmark6 + landmark6
    t36 = t17*t35
    t37 = t35*t5
    t38 = t25*t35
    t39 = landmark6*t28
    t40 = t24*t35
    t41 = t31*t35
    t42 = t32*t35
    t43 = landmark6*t30
    t44 = t17 + t17
    t45 = t5 + t5
    t46 = t18 + t18
    t47 = t0 + t0
    t48 = t25 + t25
    t49 = t24 + t24
    t50 = t6 + t6
    t51 = t31 + t31
    t52 = t32 + t32
    return (
        t21,
        t29,
        t33,
        landmark6,
        -t34,
        -t36,
        t37,
        0,
        -t33,
        t29,
        t38,
        -t39,
        -t40,
        t33,
        0,
        -t21,
        -t41,
        t42,
        -t43,
        -t29,
        t21,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t34,
        t36,
        -t37,
        t14,
        t44,
        -t45,
        t14*t6 + t17*t46 - t47*t5,
        -t38,
        t39,
        t40,
        -t48,
        t28,
        t49,
        t24*t47 - t25*t50 + t18*t28,
        t41,
        -t42,
        t43,
        t51,
        -t52,
        t30,
        t31*t50 - t32*t46 + t0*t30,
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
        pose0,
        pose1,
        pose2,
        (t2 + t3 + t5)*point0 + (t7 + t8)*t6 - (t10 - t11)*t9,
        (t2 + t12 + t4)*point1 + (t10 + t11)*t13 - (t14 - t15)*t6,
        (t0 + t12 + t5 + t1)*point2 - (t7 - t8)*t13 + (t14 + t15)*t9,
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
        pose0,
        pose1,
        pose2,
        point0*t6 + t10*t9 - t13*t14,
        point1*t16 + t17*t18 - t10*t21,
        point2*t22 - t18*t23 + t14*t24,
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
        t6,
        -t43,
        t44,
        0,
        t45,
        t16,
        -t46,
        0,
        -t47,
        t48,
        t22,
        0,
        0,
        0,
        0,
        1,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = 1/landmark6
    return (
        landmark0 + landmark3*t0,
        landmark1 + landmark4*t0,
        landmark2 + landmark5*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6 = landmark
    t0 = 1/landmark6
    t1 = t0*t0
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
