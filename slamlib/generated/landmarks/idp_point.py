"""Generated from slamlib/landmarks/idp_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "direction": "e6c75b77c4a0c4f4",
    "angles_of": "ebf5ffef4876e667",
    "to_frame": "23b7a86e8136bfea",
    "from_frame": "25681d8610b6b5ad",
    "to_point": "45fb3fad630d61ff",
}
SHAPES = {
    "direction": (3,),
    "angles_of": (2,),
    "to_frame": (4,),
    "from_frame": (6,),
    "to_point": (3,),
}


def direction(angles):
    """direction: value."""
    angles0, angles1 = angles
    t0 = cos(angles0)
    return (
        t0*cos(angles1),
        t0*sin(angles1),
        sin(angles0),
    )


def direction_jac(angles):
    """direction: value and Jacobians."""
    angles0, angles1 = angles
    t0 = cos(angles0)
    t1 = cos(angles1)
    t2 = t0*t1
    t3 = sin(angles1)
    t4 = t0*t3
    t5 = sin(angles0)
    return (
        t2,
        t4,
        t5,
        -t1*t5,
        -t4,
        -t3*t5,
        t2,
        t0,
        0,
    )


def angles_of(vector):
    """angles_of: value."""
    vector0, vector1, vector2 = vector
    return (
        arctan2(vector2, sqrt(vector0*vector0 + vector1*vector1)),
        arctan2(vector1, vector0),
    )


def angles_of_jac(vector):
    """angles_of: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector0*vector0 + vector1*vector1
    t1 = sqrt(t0)
    t2 = 1/(t0 + vector2*vector2)
    t3 = t2*vector2/t1
    t4 = 1/(t0)
    return (
        arctan2(vector2, t1),
        arctan2(vector1, vector0),
        -t3*vector0,
        -t3*vector1,
        t1*t2,
        -t4*vector1,
        t4*vector0,
        0,
    )


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = landmark5*(landmark2 - pose2) + sin(landmark3)
    t3 = 2*t2
    t4 = pose3*pose6
    t5 = pose4*pose5
    t6 = cos(landmark3)
    t7 = landmark5*(landmark1 - pose1) + t6*sin(landmark4)
    t8 = 2*t7
    t9 = landmark5*(landmark0 - pose0) + t6*cos(landmark4)
    t10 = pose4*pose4
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose6*pose6
    t15 = t13 - t14
    t16 = pose3*pose4
    t17 = pose5*pose6
    t18 = 2*t9
    t19 = -t10
    return (
        -t3*(t0 - t1) + t8*(t4 + t5) + t9*(t10 + t12 + t15),
        -t18*(t4 - t5) + t3*(t16 + t17) + t7*(t11 + t15 + t19),
        t18*(t0 + t1) + t2*(t12 + t13 + t14 + t19) - t8*(t16 - t17),
        landmark5,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = sin(landmark3)
    t4 = landmark2 - pose2
    t5 = landmark5*t4 + t3
    t6 = 2*t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = t7 + t8
    t10 = sin(landmark4)
    t11 = cos(landmark3)
    t12 = landmark1 - pose1
    t13 = landmark5*t12 + t10*t11
    t14 = 2*t13
    t15 = cos(landmark4)
    t16 = landmark0 - pose0
    t17 = landmark5*t16 + t11*t15
    t18 = pose4*pose4
    t19 = pose5*pose5
    t20 = -t19
    t21 = pose3*pose3
    t22 = pose6*pose6
    t23 = t21 - t22
    t24 = t18 + t20 + t23
    t25 = pose3*pose4
    t26 = pose5*pose6
    t27 = t25 + t26
    t28 = t7 - t8
    t29 = 2*t17
    t30 = -t18
    t31 = t19 + t23 + t30
    t32 = t0 + t1
    t33 = t25 - t26
    t34 = t20 + t21 + t22 + t30
    t35 = landmark5*t24
    t36 = 2*landmark5
    t37 = t36*t9
    t38 = t2*t36
    t39 = pose4*t17 + pose5*t13 + pose6*t5
    t40 = pose3*t17 - pose5*t5 + pose6*t13
    t41 = pose3*t13 + pose4*t5 - pose6*t17
    t42 = pose3*t5 - pose4*t13 + pose5*t17
    t43 = pose3*t39 - pose4*t40 - pose5*t41 - pose6*t42
    t44 = pose3*t42 - pose4*t41 + pose5*t40 + pose6*t39
    t45 = pose3*t41 + pose4*t42 + pose5*t39 - pose6*t40
    t46 = t28*t36
    t47 = landmark5*t31
    t48 = t27*t36
    t49 = pose3*t40 + pose4*t39 - pose5*t42 + pose6*t41
    t50 = t32*t36
    t51 = t33*t36
    t52 = landmark5*t34
    t53 = 2*t2
    t54 = 2*t9
    t55 = t10*t3
    t56 = t15*t3
    t57 = 2*t27
    t58 = 2*t28
    t59 = 2*t32
    t60 = 2*t33
    return (
        t14*t9 + t17*t24 - t2*t6,
        t13*t31 + t27*t6 - t28*t29,
        -t14*t33 + t29*t32 + t34*t5,
        landmark5,
        -t35,
        -t37,
        t38,
        t43,
        -t44,
        t45,
        t46,
        -t47,
        -t48,
        t44,
        t43,
        -t49,
        -t50,
        t51,
        -t52,
        -t45,
        t49,
        t43,
        0,
        0,
        0,
        0,
        0,
        0,
        t35,
        t37,
        -t38,
        -t11*t53 - t24*t56 - t54*t55,
        t11*(-t10*t24 + t15*t54),
        t12*t54 + t16*t24 - t4*t53,
        -t46,
        t47,
        t48,
        t11*t57 - t31*t55 + t56*t58,
        t11*(t10*t58 + t15*t31),
        t12*t31 - t16*t58 + t4*t57,
        t50,
        -t51,
        t52,
        t11*t34 + t55*t60 - t56*t59,
        -2*t11*(t10*t32 + t15*t33),
        -t12*t60 + t16*t59 + t34*t4,
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
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = sin(landmark3)
    t4 = landmark2 - pose2
    t5 = landmark5*t4 + t3
    t6 = 2*t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = t7 + t8
    t10 = sin(landmark4)
    t11 = cos(landmark3)
    t12 = landmark1 - pose1
    t13 = landmark5*t12 + t10*t11
    t14 = 2*t13
    t15 = cos(landmark4)
    t16 = landmark0 - pose0
    t17 = landmark5*t16 + t11*t15
    t18 = pose4*pose4
    t19 = pose5*pose5
    t20 = -t19
    t21 = pose3*pose3
    t22 = pose6*pose6
    t23 = t21 - t22
    t24 = t18 + t20 + t23
    t25 = pose3*pose4
    t26 = pose5*pose6
    t27 = t25 + t26
    t28 = t7 - t8
    t29 = 2*t17
    t30 = -t18
    t31 = t19 + t23 + t30
    t32 = t0 + t1
    t33 = t25 - t26
    t34 = t20 + t21 + t22 + t30
    t35 = landmark5*t24
    t36 = 2*landmark5
    t37 = t36*t9
    t38 = t2*t36
    t39 = pose3*t17 - pose5*t5 + pose6*t13
    t40 = 2*t39
    t41 = 2*pose4*t17 + 2*pose5*t13 + 2*pose6*t5
    t42 = pose3*t5 - pose4*t13 + pose5*t17
    t43 = pose3*t13 + pose4*t5 - pose6*t17
    t44 = 2*t43
    t45 = t28*t36
    t46 = landmark5*t31
    t47 = t27*t36
    t48 = 2*t42
    t49 = t32*t36
    t50 = t33*t36
    t51 = landmark5*t34
    t52 = 2*t2
    t53 = 2*t9
    t54 = t10*t3
    t55 = t15*t3
    t56 = 2*t27
    t57 = 2*t28
    t58 = 2*t32
    t59 = 2*t33
    return (
        t14*t9 + t17*t24 - t2*t6,
        t13*t31 + t27*t6 - t28*t29,
        -t14*t33 + t29*t32 + t34*t5,
        landmark5,
        -t35,
        -t37,
        t38,
        t40,
        t41,
        -2*t42,
        t44,
        t45,
        -t46,
        -t47,
        t44,
        t48,
        t41,
        -2*t39,
        -t49,
        t50,
        -t51,
        t48,
        -2*t43,
        t40,
        t41,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t35,
        t37,
        -t38,
        -t11*t52 - t24*t55 - t53*t54,
        t11*(-t10*t24 + t15*t53),
        t12*t53 + t16*t24 - t4*t52,
        -t45,
        t46,
        t47,
        t11*t56 - t31*t54 + t55*t57,
        t11*(t10*t57 + t15*t31),
        t12*t31 - t16*t57 + t4*t56,
        t49,
        -t50,
        t51,
        t11*t34 + t54*t59 - t55*t58,
        -2*t11*(t10*t32 + t15*t33),
        -t12*t59 + t16*t58 + t34*t4,
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
    t0 = pose3*pose4
    t1 = pose5*pose6
    t2 = 2*point1
    t3 = pose3*pose5
    t4 = pose4*pose6
    t5 = 2*point0
    t6 = pose6*pose6
    t7 = pose4*pose4
    t8 = -t7
    t9 = pose3*pose3
    t10 = pose5*pose5
    t11 = -t10 + t9
    t12 = pose3*pose6
    t13 = pose4*pose5
    t14 = 2*point2
    t15 = -t6
    t16 = point1*(t10 + t15 + t8 + t9) - t14*(t0 - t1) + t5*(t12 + t13)
    t17 = point0*(t11 + t15 + t7) + t14*(t3 + t4) - t2*(t12 - t13)
    return (
        pose0,
        pose1,
        pose2,
        arctan2(point2*(t11 + t6 + t8) + t2*(t0 + t1) - t5*(t3 - t4), sqrt(t16*t16 + t17*t17)),
        arctan2(t16, t17),
        point3/sqrt(point0*point0 + point1*point1 + point2*point2),
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = 2*point0
    t4 = pose6*pose6
    t5 = pose4*pose4
    t6 = -t5
    t7 = pose3*pose3
    t8 = pose5*pose5
    t9 = t7 - t8
    t10 = t4 + t6 + t9
    t11 = pose3*pose4
    t12 = pose5*pose6
    t13 = t11 + t12
    t14 = 2*point1
    t15 = point2*t10 + t13*t14
    t16 = t15 - t2*t3
    t17 = t11 - t12
    t18 = 2*point2
    t19 = -t4
    t20 = t19 + t6 + t7 + t8
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = point1*t20 + t23*t3
    t25 = -t17*t18 + t24
    t26 = t0 + t1
    t27 = t21 - t22
    t28 = t19 + t5 + t9
    t29 = point0*t28 - t14*t27 + t18*t26
    t30 = t25*t25 + t29*t29
    t31 = sqrt(t30)
    t32 = point0*point0 + point1*point1 + point2*point2
    t33 = 1/(sqrt(t32))
    t34 = 1/(t16*t16 + t30)
    t35 = point0*pose3 - point1*pose6 + point2*pose5
    t36 = point0*pose4 + point1*pose5 + point2*pose6
    t37 = -point0*pose5 + point1*pose4 + point2*pose3
    t38 = t29*t37
    t39 = 1/(t31)
    t40 = t39*(t15 - t2*t3)
    t41 = t31*t35 + t40*(t25*t36 + t38)
    t42 = point0*pose6 + point1*pose3 - point2*pose4
    t43 = -t25*t37 + t29*t36
    t44 = -t31*t42 + t40*t43
    t45 = t25*t42 + t29*t35
    t46 = -t31*t37 + t40*t45
    t47 = -t29*t42
    t48 = -t31*t36 + t40*(t25*t35 + t47)
    t49 = 1/(t30)
    t50 = -t17*t18 + t24
    t51 = t36*t50 + t38
    t52 = t35*t50 + t47
    t53 = 2*t31
    t54 = 2*t23
    t55 = 2*t27
    t56 = point3/(t32*sqrt(t32))
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t31),
        arctan2(t25, t29),
        point3*t33,
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
        t34*(-pose3*t44 + pose4*t46 + pose5*t48 - pose6*t41),
        t34*(-pose3*t41 - pose4*t48 + pose5*t46 + pose6*t44),
        t34*(-pose3*t48 + pose4*t41 - pose5*t44 + pose6*t46),
        0,
        0,
        0,
        t49*(-pose3*t51 + pose4*t52 - pose5*t45 + pose6*t43),
        t49*(pose3*t43 + pose4*t45 + pose5*t52 + pose6*t51),
        t49*(pose3*t45 - pose4*t43 - pose5*t51 + pose6*t52),
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
        -t34*(t2*t53 + t40*(t25*t54 + t28*t29)),
        t34*(t13*t53 + t16*t39*(-t20*t25 + t29*t55)),
        t34*(t10*t31 - 2*t40*(-t17*t25 + t26*t29)),
        0,
        t49*(-t25*t28 + t29*t54),
        t49*(t20*t29 + t25*t55),
        -2*t49*(t17*t29 + t26*t50),
        0,
        -point0*t56,
        -point1*t56,
        -point2*t56,
        t33,
    )


def from_frame_storage_jac(pose, point):
    """from_frame: value and derivatives by stored numbers."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose3*pose5
    t1 = pose4*pose6
    t2 = t0 - t1
    t3 = 2*point0
    t4 = pose6*pose6
    t5 = pose4*pose4
    t6 = -t5
    t7 = pose3*pose3
    t8 = pose5*pose5
    t9 = t7 - t8
    t10 = t4 + t6 + t9
    t11 = pose3*pose4
    t12 = pose5*pose6
    t13 = t11 + t12
    t14 = 2*point1
    t15 = point2*t10 + t13*t14
    t16 = t15 - t2*t3
    t17 = t11 - t12
    t18 = 2*point2
    t19 = -t4
    t20 = t19 + t6 + t7 + t8
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = point1*t20 + t23*t3
    t25 = -t17*t18 + t24
    t26 = t0 + t1
    t27 = t21 - t22
    t28 = t19 + t5 + t9
    t29 = point0*t28 - t14*t27 + t18*t26
    t30 = t25*t25 + t29*t29
    t31 = sqrt(t30)
    t32 = point0*point0 + point1*point1 + point2*point2
    t33 = 1/(sqrt(t32))
    t34 = -point0*pose5 + point1*pose4 + point2*pose3
    t35 = point0*pose3 - point1*pose6 + point2*pose5
    t36 = point0*pose6 + point1*pose3 - point2*pose4
    t37 = t25*t36 + t29*t35
    t38 = 1/(t31)
    t39 = t38*(t15 - t2*t3)
    t40 = 1/(t16*t16 + t30)
    t41 = 2*t40
    t42 = point0*pose4 + point1*pose5 + point2*pose6
    t43 = -t25*t34 + t29*t42
    t44 = t29*t34
    t45 = -t29*t36
    t46 = -t17*t18 + t24
    t47 = 1/(t30)
    t48 = 2*t47
    t49 = 2*t31
    t50 = 2*t23
    t51 = 2*t27
    t52 = point3/(t32*sqrt(t32))
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t31),
        arctan2(t25, t29),
        point3*t33,
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
        t41*(t31*t34 - t37*t39),
        t41*(t31*t36 - t39*t43),
        -t41*(t31*t35 + t39*(t25*t42 + t44)),
        t41*(t31*t42 - t39*(t25*t35 + t45)),
        0,
        0,
        0,
        t48*(-t35*t46 - t45),
        -t48*(t42*t46 + t44),
        t43*t48,
        t37*t48,
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
        -t40*(t2*t49 + t39*(t25*t50 + t28*t29)),
        t40*(t13*t49 + t16*t38*(-t20*t25 + t29*t51)),
        t40*(t10*t31 - 2*t39*(-t17*t25 + t26*t29)),
        0,
        t47*(-t25*t28 + t29*t50),
        t47*(t20*t29 + t25*t51),
        -t48*(t17*t29 + t26*t46),
        0,
        -point0*t52,
        -point1*t52,
        -point2*t52,
        t33,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = 1/(landmark5)
    t1 = t0*cos(landmark3)
    return (
        landmark0 + t1*cos(landmark4),
        landmark1 + t1*sin(landmark4),
        landmark2 + t0*sin(landmark3),
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = cos(landmark4)
    t1 = cos(landmark3)
    t2 = 1/(landmark5)
    t3 = t1*t2
    t4 = t0*t3
    t5 = sin(landmark4)
    t6 = t3*t5
    t7 = sin(landmark3)
    t8 = t2*t7
    t9 = 1/(landmark5*landmark5)
    t10 = t1*t9
    return (
        landmark0 + t4,
        landmark1 + t6,
        landmark2 + t8,
        1,
        0,
        0,
        -t0*t8,
        -t6,
        -t0*t10,
        0,
        1,
        0,
        -t5*t8,
        t4,
        -t10*t5,
        0,
        0,
        1,
        t3,
        0,
        -t7*t9,
    )
