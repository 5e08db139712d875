"""Generated from slamlib/landmarks/plane_idp_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "to_frame": "176d940cb232cb3c",
    "from_frame": "d59842671e7febf5",
    "to_point": "dc4ed774ad260074",
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
    t0 = landmark3*pose2
    t1 = t0 + t0
    t2 = pose3*pose5
    t3 = pose4*pose6
    t4 = (landmark1 - pose1)*landmark3 + sin(landmark2)
    t5 = t4 + t4
    t6 = pose3*pose6
    t7 = pose4*pose5
    t8 = (landmark0 - pose0)*landmark3 + cos(landmark2)
    t9 = pose5*pose5
    t10 = -t9
    t11 = pose3*pose3
    t12 = pose6*pose6
    t13 = t11 - t12
    t14 = pose4*pose4
    t15 = t8 + t8
    t16 = pose3*pose4
    t17 = pose5*pose6
    t18 = -t14
    return (
        (t2 - t3)*t1 + (t6 + t7)*t5 + (t10 + t13 + t14)*t8,
        -(t6 - t7)*t15 - (t16 + t17)*t1 + (t9 + t13 + t18)*t4,
        (t2 + t3)*t15 - (t10 + t11 + t12 + t18)*t0 - (t16 - t17)*t5,
        landmark3,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = landmark3 + landmark3
    t4 = t2*t3
    t5 = landmark1 - pose1
    t6 = sin(landmark2)
    t7 = landmark3*t5 + t6
    t8 = t7 + t7
    t9 = pose3*pose6
    t10 = pose4*pose5
    t11 = t9 + t10
    t12 = landmark0 - pose0
    t13 = cos(landmark2)
    t14 = landmark3*t12 + t13
    t15 = pose4*pose4
    t16 = pose5*pose5
    t17 = -t16
    t18 = pose3*pose3
    t19 = pose6*pose6
    t20 = t18 - t19
    t21 = t15 + t17 + t20
    t22 = pose2*t4 + t11*t8 + t14*t21
    t23 = pose3*pose4
    t24 = pose5*pose6
    t25 = t23 + t24
    t26 = t25*t3
    t27 = -t15
    t28 = t16 + t20 + t27
    t29 = t9 - t10
    t30 = t14 + t14
    t31 = pose2*t26 - t28*t7 + t29*t30
    t32 = -t31
    t33 = t17 + t18 + t19 + t27
    t34 = landmark3*t33
    t35 = t23 - t24
    t36 = t0 + t1
    t37 = pose2*t34 + t35*t8 - t30*t36
    t38 = -t37
    t39 = landmark3*t21
    t40 = t11*t3
    t41 = t29*t3
    t42 = landmark3*t28
    t43 = t3*t36
    t44 = t3*t35
    t45 = t11 + t11
    t46 = pose2 + pose2
    t47 = t29 + t29
    t48 = t35 + t35
    t49 = t36 + t36
    return (
        t22,
        t32,
        t38,
        landmark3,
        -t39,
        -t40,
        t4,
        0,
        t37,
        t32,
        t41,
        -t42,
        -t26,
        t38,
        0,
        -t22,
        -t43,
        t44,
        -t34,
        t31,
        t22,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t39,
        t40,
        t13*t45 - t21*t6,
        t12*t21 + t2*t46 + t45*t5,
        -t41,
        t42,
        t13*t28 + t47*t6,
        -t12*t47 - t25*t46 + t28*t5,
        t43,
        -t44,
        -t13*t48 - t49*t6,
        -pose2*t33 + t12*t49 - t48*t5,
        0,
        0,
        0,
        1,
    )


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose6
    t1 = pose4*pose5
    t2 = (t0 + t1)
    t3 = t2 + t2
    t4 = pose5*pose5
    t5 = pose4*pose4
    t6 = pose3*pose3
    t7 = pose6*pose6
    t8 = t6 - t7
    t9 = point2 + point2
    t10 = t3*point0 + (t4 - t5 + t8)*point1 - (pose3*pose4 - pose5*pose6)*t9
    t11 = (t0 - t1)
    t12 = t11 + t11
    t13 = (-t4 + t5 + t8)*point0 - t12*point1 + (pose3*pose5 + pose4*pose6)*t9
    t14 = t10*t10
    t15 = t13*t13
    t16 = t14 + t15
    t17 = 1/t16
    t18 = sqrt(t17)
    return (
        pose0,
        pose1,
        arctan2(t10, t13),
        point3*t18,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose4 - pose5*pose6
    t1 = point2 + point2
    t2 = pose3*pose6
    t3 = t2 + t2
    t4 = pose4*pose5
    t5 = t4 + t4
    t6 = t3 + t5
    t7 = pose5*pose5
    t8 = pose4*pose4
    t9 = pose3*pose3
    t10 = pose6*pose6
    t11 = t9 - t10
    t12 = t7 - t8 + t11
    t13 = point0*t6 + point1*t12
    t14 = -t0*t1 + t13
    t15 = t2 - t4
    t16 = point1 + point1
    t17 = -t7 + t8 + t11
    t18 = pose3*pose5 + pose4*pose6
    t19 = point0*t17 + t1*t18
    t20 = -t15*t16 + t19
    t21 = t14*t14
    t22 = t20*t20
    t23 = t21 + t22
    t24 = 1/t23
    t25 = sqrt(t24)
    t26 = point0*pose4 + point1*pose5 + point2*pose6
    t27 = -point0*pose5 + point1*pose4 + point2*pose3
    t28 = point0*pose3 - point1*pose6 + point2*pose5
    t29 = point0*pose6 + point1*pose3 - point2*pose4
    t30 = t14*t29 + t20*t28
    t31 = pose5*t30
    t32 = -t14*t27 + t20*t26
    t33 = -pose6*t32
    t34 = pose4*t30
    t35 = t14*t28 - t20*t29
    t36 = pose5*t35
    t37 = t14*t26 + t20*t27
    t38 = pose3*t32 + pose6*t37
    t39 = t24*t25
    t40 = point3*t39
    t41 = t15 + t15
    t42 = (t0*t20 + t14*t18)
    t43 = t42 + t42
    t44 = (t0*t14 - t18*t20)
    t45 = t44 + t44
    return (
        pose0,
        pose1,
        arctan2(t14, t20),
        point3*t25,
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
        0,
        -((t14*t26 + t20*t27)*pose3 - (t14*t28 - t20*t29)*pose4 + t31 + t33)*t24,
        (t34 + t36 + t38)*t24,
        (pose3*t30 - pose4*t32 - pose5*t37 + pose6*t35)*t24,
        0,
        0,
        0,
        -(-t34 - t36 + t38)*t40,
        -(pose3*t37 + pose4*t35 - t31 + t33)*t40,
        -(pose3*t35 - pose4*t37 + pose5*t32 - pose6*t30)*t40,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        (-t14*t17 + t20*t6)*t24,
        -(-t14*t41 - t12*t20)*t24,
        -t43*t24,
        0,
        -(t14*t6 + t17*t20)*t40,
        (-t12*t14 + t20*t41)*t40,
        t45*t40,
        t25,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = 1/landmark3
    return (
        landmark0 + cos(landmark2)*t0,
        landmark1 + sin(landmark2)*t0,
        0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3 = landmark
    t0 = cos(landmark2)
    t1 = 1/landmark3
    t2 = t0*t1
    t3 = sin(landmark2)
    t4 = t1*t3
    t5 = t1*t1
    return (
        landmark0 + t2,
        landmark1 + t4,
        0,
        1,
        0,
        -t4,
        -t0*t5,
        0,
        1,
        t2,
        -t3*t5,
        0,
        0,
        0,
        0,
    )
