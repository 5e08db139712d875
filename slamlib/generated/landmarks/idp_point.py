"""Generated from slamlib/landmarks/idp_point.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "direction": "27902cccb3ab3131",
    "angles_of": "3bcc1e79b05da071",
    "to_frame": "46b11e977d98dfc8",
    "from_frame": "2917b9d0b1a807fc",
    "to_point": "2fbc0dd46a196fe6",
    "angles_moved": "2f20e9b57c46bc50",
}
SHAPES = {
    "direction": (3,),
    "angles_of": (2,),
    "to_frame": (4,),
    "from_frame": (6,),
    "to_point": (3,),
    "angles_moved": (2,),
}


def direction(angles):
    """direction: value."""
    angles0, angles1 = angles
    t0 = cos(angles0)
    return (
        cos(angles1)*t0,
        sin(angles1)*t0,
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
    t0 = vector0*vector0
    t1 = vector1*vector1
    t2 = t0 + t1
    t3 = sqrt(t2)
    return (
        arctan2(vector2, t3),
        arctan2(vector1, vector0),
    )


def angles_of_jac(vector):
    """angles_of: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector0*vector0
    t1 = vector1*vector1
    t2 = t0 + t1
    t3 = sqrt(t2)
    t4 = vector2*vector2
    t5 = t2 + t4
    t6 = 1/t5
    t7 = 1/t3
    t8 = t6*t7*vector2
    t9 = 1/t2
    return (
        arctan2(vector2, t3),
        arctan2(vector1, vector0),
        -t8*vector0,
        -t8*vector1,
        t3*t6,
        -t9*vector1,
        t9*vector0,
        0,
    )


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = (landmark2 - pose2)*landmark5 + sin(landmark3)
    t1 = t0 + t0
    t2 = pose3*pose5
    t3 = pose4*pose6
    t4 = cos(landmark3)
    t5 = (landmark1 - pose1)*landmark5 + sin(landmark4)*t4
    t6 = t5 + t5
    t7 = pose3*pose6
    t8 = pose4*pose5
    t9 = (landmark0 - pose0)*landmark5 + cos(landmark4)*t4
    t10 = pose4*pose4
    t11 = pose5*pose5
    t12 = -t11
    t13 = pose3*pose3
    t14 = pose6*pose6
    t15 = t13 - t14
    t16 = t9 + t9
    t17 = pose3*pose4
    t18 = pose5*pose6
    t19 = -t10
    return (
        -(t2 - t3)*t1 + (t7 + t8)*t6 + (t10 + t12 + t15)*t9,
        -(t7 - t8)*t16 + (t17 + t18)*t1 + (t11 + t15 + t19)*t5,
        (t2 + t3)*t16 + (t12 + t13 + t14 + t19)*t0 - (t17 - t18)*t6,
        landmark5,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = landmark1 - pose1
    t1 = sin(landmark4)
    t2 = cos(landmark3)
    t3 = landmark5*t0 + t1*t2
    t4 = t3 + t3
    t5 = pose3*pose6
    t6 = pose4*pose5
    t7 = t5 + t6
    t8 = landmark0 - pose0
    t9 = cos(landmark4)
    t10 = landmark5*t8 + t2*t9
    t11 = pose4*pose4
    t12 = pose5*pose5
    t13 = -t12
    t14 = pose3*pose3
    t15 = pose6*pose6
    t16 = t14 - t15
    t17 = t11 + t13 + t16
    t18 = pose3*pose5
    t19 = pose4*pose6
    t20 = t18 - t19
    t21 = landmark2 - pose2
    t22 = sin(landmark3)
    t23 = landmark5*t21 + t22
    t24 = t23 + t23
    t25 = t4*t7 + t10*t17 - t20*t24
    t26 = -t11
    t27 = t12 + t16 + t26
    t28 = pose3*pose4
    t29 = pose5*pose6
    t30 = t28 + t29
    t31 = t5 - t6
    t32 = t10 + t10
    t33 = t27*t3 + t24*t30 - t31*t32
    t34 = t28 - t29
    t35 = t18 + t19
    t36 = t13 + t14 + t15 + t26
    t37 = -t34*t4 + t32*t35 + t23*t36
    t38 = landmark5*t17
    t39 = landmark5 + landmark5
    t40 = t39*t7
    t41 = t20*t39
    t42 = t31*t39
    t43 = landmark5*t27
    t44 = t30*t39
    t45 = t35*t39
    t46 = t34*t39
    t47 = landmark5*t36
    t48 = t20 + t20
    t49 = t22*t9
    t50 = t7 + t7
    t51 = t1*t22
    t52 = t30 + t30
    t53 = t31 + t31
    t54 = t34 + t34
    t55 = t35 + t35
    t56 = (t1*t35 + t34*t9)
    t57 = t56 + t56
    return (
        t25,
        t33,
        t37,
        landmark5,
        -t38,
        -t40,
        t41,
        0,
        -t37,
        t33,
        t42,
        -t43,
        -t44,
        t37,
        0,
        -t25,
        -t45,
        t46,
        -t47,
        -t33,
        t25,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        t38,
        t40,
        -t41,
        -t2*t48 - t17*t49 - t50*t51,
        (-t1*t17 + t50*t9)*t2,
        t0*t50 + t17*t8 - t21*t48,
        -t42,
        t43,
        t44,
        t2*t52 - t27*t51 + t49*t53,
        -(-t1*t53 - t27*t9)*t2,
        t0*t27 - t53*t8 + t21*t52,
        t45,
        -t46,
        t47,
        t2*t36 + t51*t54 - t49*t55,
        -t57*t2,
        -t0*t54 + t55*t8 + t21*t36,
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
    t0 = pose5*pose5
    t1 = pose3*pose3
    t2 = -t0 + t1
    t3 = pose6*pose6
    t4 = pose4*pose4
    t5 = -t4
    t6 = point1 + point1
    t7 = pose3*pose4
    t8 = pose5*pose6
    t9 = point0 + point0
    t10 = pose3*pose5
    t11 = pose4*pose6
    t12 = -t3
    t13 = point2 + point2
    t14 = pose3*pose6
    t15 = pose4*pose5
    t16 = (t0 + t12 + t5 + t1)*point1 - (t7 - t8)*t13 + (t14 + t15)*t9
    t17 = t16*t16
    t18 = (t2 + t12 + t4)*point0 + (t10 + t11)*t13 - (t14 - t15)*t6
    t19 = t18*t18
    t20 = t17 + t19
    t21 = sqrt(t20)
    t22 = point0*point0
    t23 = point1*point1
    t24 = point2*point2
    t25 = t22 + t23 + t24
    t26 = 1/t25
    t27 = sqrt(t26)
    return (
        pose0,
        pose1,
        pose2,
        arctan2((t2 + t3 + t5)*point2 + (t7 + t8)*t6 - (t10 - t11)*t9, t21),
        arctan2(t16, t18),
        point3*t27,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    point0, point1, point2, point3 = point
    t0 = pose6*pose6
    t1 = pose4*pose4
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose5*pose5
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = pose3*pose4
    t8 = pose5*pose6
    t9 = t7 + t8
    t10 = point1 + point1
    t11 = point2*t6 + t10*t9
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 - t13
    t15 = point0 + point0
    t16 = t11 - t14*t15
    t17 = t7 - t8
    t18 = point2 + point2
    t19 = -t0
    t20 = t19 + t2 + t3 + t4
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = point1*t20 + t15*t23
    t25 = -t17*t18 + t24
    t26 = t25*t25
    t27 = t21 - t22
    t28 = t19 + t1 + t5
    t29 = t12 + t13
    t30 = point0*t28 + t18*t29
    t31 = -t10*t27 + t30
    t32 = t31*t31
    t33 = t26 + t32
    t34 = sqrt(t33)
    t35 = point0*point0
    t36 = point1*point1
    t37 = point2*point2
    t38 = t35 + t36 + t37
    t39 = 1/t38
    t40 = sqrt(t39)
    t41 = t16*t16
    t42 = t41 + t33
    t43 = 1/t42
    t44 = point0*pose6 + point1*pose3 - point2*pose4
    t45 = 1/t34
    t46 = (t11 - t14*t15)*t45
    t47 = -point0*pose5 + point1*pose4 + point2*pose3
    t48 = -t47
    t49 = point0*pose4 + point1*pose5 + point2*pose6
    t50 = -t34*t44 + (t25*t48 + t31*t49)*t46
    t51 = point0*pose3 - point1*pose6 + point2*pose5
    t52 = -t34*t47 + (t25*t44 + t31*t51)*t46
    t53 = t25*t51
    t54 = -t34*t49 + (-t31*t44 + t53)*t46
    t55 = t25*t49
    t56 = t34*t51 + (t31*t47 + t55)*t46
    t57 = 1/t33
    t58 = t25*t44 + t31*t51
    t59 = -t25*t47 + t31*t49
    t60 = t25*t51 - t31*t44
    t61 = t25*t49 + t31*t47
    t62 = t34 + t34
    t63 = t16*t45
    t64 = t23 + t23
    t65 = t27 + t27
    t66 = (-t17*t25 + t29*t31)
    t67 = t66 + t66
    t68 = (t17*t31 + t25*t29)
    t69 = t68 + t68
    t70 = t39*t40
    t71 = point3*t70
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t34),
        arctan2(t25, t31),
        point3*t40,
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
        -(pose3*t50 - pose4*t52 - pose5*t54 + pose6*t56)*t43,
        -(pose3*t56 + pose4*t54 - pose5*t52 - pose6*t50)*t43,
        -(pose3*t54 - pose4*t56 + pose5*t50 - pose6*t52)*t43,
        0,
        0,
        0,
        -((-t31*t48 + t55)*pose3 - (-t31*t44 + t53)*pose4 + pose5*t58 - pose6*t59)*t57,
        (pose3*t59 + pose4*t58 + pose5*t60 + pose6*t61)*t57,
        (pose3*t58 - pose4*t59 - pose5*t61 + pose6*t60)*t57,
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
        -(t14*t62 + (t25*t64 + t28*t31)*t63)*t43,
        (t62*t9 + (-t20*t25 + t31*t65)*t63)*t43,
        -(-t34*t6 + t67*t63)*t43,
        0,
        (-t25*t28 + t31*t64)*t57,
        -(-t20*t31 - t25*t65)*t57,
        -t69*t57,
        0,
        -point0*t71,
        -point1*t71,
        -point2*t71,
        t40,
    )


def to_point(landmark):
    """to_point: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = 1/landmark5
    t1 = cos(landmark3)*t0
    return (
        landmark0 + cos(landmark4)*t1,
        landmark1 + sin(landmark4)*t1,
        landmark2 + sin(landmark3)*t0,
    )


def to_point_jac(landmark):
    """to_point: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5 = landmark
    t0 = cos(landmark4)
    t1 = cos(landmark3)
    t2 = 1/landmark5
    t3 = t1*t2
    t4 = t0*t3
    t5 = sin(landmark4)
    t6 = t3*t5
    t7 = sin(landmark3)
    t8 = t2*t7
    t9 = t2*t2
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


def angles_moved(motion, angles):
    """angles_moved: value."""
    _, _, _, motion3, motion4, motion5, motion6 = motion
    angles0, angles1 = angles
    t0 = cos(angles0)
    t1 = cos(angles1)*t0
    t2 = t1 + t1
    t3 = motion3*motion5
    t4 = motion4*motion6
    t5 = sin(angles0)
    t6 = motion5*motion5
    t7 = -t6
    t8 = motion3*motion3
    t9 = motion6*motion6
    t10 = motion4*motion4
    t11 = -t10
    t12 = sin(angles1)*t0
    t13 = t12 + t12
    t14 = motion3*motion4
    t15 = motion5*motion6
    vector2 = -(t3 - t4)*t2 + (t7 + t8 + t9 + t11)*t5 + (t14 + t15)*t13
    t16 = t8 - t9
    t17 = t5 + t5
    t18 = motion3*motion6
    t19 = motion4*motion5
    vector0 = (t7 + t16 + t10)*t1 + (t3 + t4)*t17 - (t18 - t19)*t13
    t20 = vector0*vector0
    vector1 = (t18 + t19)*t2 - (t14 - t15)*t17 + (t6 + t16 + t11)*t12
    t21 = vector1*vector1
    t22 = t20 + t21
    t23 = sqrt(t22)
    return (
        arctan2(vector2, t23),
        arctan2(vector1, vector0),
    )


def angles_moved_jac(motion, angles):
    """angles_moved: value and Jacobians."""
    _, _, _, motion3, motion4, motion5, motion6 = motion
    angles0, angles1 = angles
    t0 = cos(angles0)
    t1 = sin(angles1)
    t2 = t0*t1
    t3 = t2 + t2
    t4 = motion3*motion4
    t5 = motion5*motion6
    t6 = t4 + t5
    t7 = cos(angles1)
    t8 = t0*t7
    t9 = t8 + t8
    t10 = motion3*motion5
    t11 = motion4*motion6
    t12 = t10 - t11
    t13 = sin(angles0)
    t14 = motion5*motion5
    t15 = -t14
    t16 = motion3*motion3
    t17 = motion6*motion6
    t18 = motion4*motion4
    t19 = -t18
    t20 = t15 + t16 + t17 + t19
    vector2 = t3*t6 - t12*t9 + t13*t20
    t21 = motion3*motion6
    t22 = motion4*motion5
    t23 = t21 - t22
    t24 = t16 - t17
    t25 = t18 + t15 + t24
    t26 = t10 + t11
    t27 = t13 + t13
    vector0 = -t23*t3 + t25*t8 + t26*t27
    t28 = vector0*vector0
    t29 = t14 + t24 + t19
    t30 = t4 - t5
    t31 = t21 + t22
    vector1 = t2*t29 - t27*t30 + t31*t9
    t32 = vector1*vector1
    t33 = t28 + t32
    t34 = sqrt(t33)
    t35 = vector2*vector2
    t36 = t33 + t35
    t37 = 1/t36
    t38 = motion3*t2 - motion4*t13 + motion6*t8
    t39 = motion4*t8 + motion5*t2 + motion6*t13
    t40 = t39*vector0
    t41 = 1/t34
    t42 = t41*vector2
    t43 = motion3*t13 + motion4*t2 - motion5*t0*t7
    t44 = t42*vector1
    t45 = -t34*t38 + t40*t42 - t43*t44
    t46 = motion3*t8 + motion5*t13 - motion6*t0*t1
    t47 = t46*vector0
    t48 = t38*vector1
    t49 = -t34*t43 + t42*t47 + t42*t48
    t50 = t42*vector0
    t51 = t46*vector1
    t52 = -t34*t39 - t38*t50 + t42*t51
    t53 = t39*vector1
    t54 = t43*vector0
    t55 = t34*t46 + t42*t53 + t42*t54
    t56 = -(motion3*t52 - motion4*t55 + motion5*t45 - motion6*t49)*t37
    t57 = 1/t33
    t58 = t53 + t54
    t59 = t38*vector0 - t51
    t60 = t47 + t48
    t61 = t40 - t43*vector1
    t62 = (motion3*t60 - motion4*t61 - motion5*t58 - motion6*t59)*t57
    t63 = t1*t27
    t64 = t27*t7
    t65 = t0 + t0
    t66 = t30*t65 + t31*t64 + t1*t13*t29
    t67 = t13*t25*t7 - t26*t65 - t23*t63
    return (
        arctan2(vector2, t34),
        arctan2(vector1, vector0),
        0,
        0,
        0,
        -(motion3*t45 - motion4*t49 - motion5*t52 + motion6*t55)*t37,
        -(motion3*t55 + motion4*t52 - motion5*t49 - motion6*t45)*t37,
        t56,
        0,
        0,
        0,
        (-motion3*t58 - motion4*t59 - motion5*t60 + motion6*t61)*t57,
        (motion3*t61 + motion4*t60 - motion5*t59 + motion6*t58)*t57,
        t62,
        -((t6*t63 - t12*t64 - t0*t20)*t34 - t44*t66 - t50*t67)*t37,
        t56,
        -(-t67*vector1 + t66*vector0)*t57,
        t62,
    )
