"""Generated from slamlib/geometry/moved.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin

DIGESTS = {
    "vector": "3ac73053e05d3a21",
    "number": "77bc28656433d69d",
    "plane_point": "1dcb146a29e0a281",
    "plane_pose": "a3213f7e6b374a56",
}
SHAPES = {
    "vector": (3,),
    "number": (1,),
    "plane_point": (2,),
    "plane_pose": (3,),
}


def vector(motion, vector):
    """vector: value."""
    _, _, _, motion3, motion4, motion5, motion6 = motion
    vector0, vector1, vector2 = vector
    t0 = vector2 + vector2
    t1 = motion3*motion5
    t2 = motion4*motion6
    t3 = vector1 + vector1
    t4 = motion3*motion6
    t5 = motion4*motion5
    t6 = motion6*motion6
    t7 = motion3*motion3
    t8 = -t6 + t7
    t9 = motion4*motion4
    t10 = motion5*motion5
    t11 = -t10
    t12 = vector0 + vector0
    t13 = motion3*motion4
    t14 = motion5*motion6
    t15 = -t9
    return (
        (t1 + t2)*t0 - (t4 - t5)*t3 + (t8 + t9 + t11)*vector0,
        (t4 + t5)*t12 - (t13 - t14)*t0 + (t8 + t15 + t10)*vector1,
        -(t1 - t2)*t12 + (t13 + t14)*t3 + (t6 + t15 + t11 + t7)*vector2,
    )


def vector_jac(motion, vector):
    """vector: value and Jacobians."""
    _, _, _, motion3, motion4, motion5, motion6 = motion
    vector0, vector1, vector2 = vector
    t0 = motion5*motion5
    t1 = -t0
    t2 = motion3*motion3
    t3 = motion6*motion6
    t4 = t2 - t3
    t5 = motion4*motion4
    t6 = t1 + t4 + t5
    t7 = motion3*motion5
    t8 = motion4*motion6
    t9 = t7 + t8
    t10 = vector2 + vector2
    t11 = motion3*motion6
    t12 = motion4*motion5
    t13 = t11 - t12
    t14 = vector1 + vector1
    t15 = t11 + t12
    t16 = vector0 + vector0
    t17 = motion3*motion4
    t18 = motion5*motion6
    t19 = t17 - t18
    t20 = -t5
    t21 = t4 + t20 + t0
    t22 = t7 - t8
    t23 = t17 + t18
    t24 = t1 + t2 + t3 + t20
    t25 = motion3*vector1 - motion4*vector2 + motion6*vector0
    t26 = motion5*t25
    t27 = motion3*vector0 + motion5*vector2 - motion6*vector1
    t28 = motion4*t27
    t29 = motion4*vector0 + motion5*vector1 + motion6*vector2
    t30 = motion3*t29
    t31 = motion3*vector2 + motion4*vector1 - motion5*vector0
    t32 = motion6*t31
    t33 = t30 + t32
    t34 = motion6*t29
    t35 = motion3*t31
    t36 = motion4*t25 + motion5*t27
    t37 = motion3*t25
    t38 = motion5*t29
    t39 = motion4*t31 + motion6*t27
    t40 = motion4*t29
    t41 = motion3*t27
    t42 = motion5*t31 + motion6*t25
    t43 = t13 + t13
    t44 = t9 + t9
    t45 = t15 + t15
    t46 = t19 + t19
    t47 = t22 + t22
    t48 = t23 + t23
    return (
        t6*vector0 + t10*t9 - t13*t14,
        t15*t16 - t10*t19 + t21*vector1,
        -t16*t22 + t14*t23 + t24*vector2,
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
        t6,
        -t43,
        t44,
        t45,
        t21,
        -t46,
        -t47,
        t48,
        t24,
    )


def number(motion, number):
    """number: value."""
    number, = number
    return (
        number,
    )


def number_jac(motion, number):
    """number: value and Jacobians."""
    number, = number
    return (
        number,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
    )


def plane_point(motion, point):
    """plane_point: value."""
    motion0, motion1, _, motion3, motion4, motion5, motion6 = motion
    point0, point1 = point
    t0 = motion4*motion4
    t1 = motion5*motion5
    t2 = motion3*motion3
    t3 = motion6*motion6
    t4 = t2 - t3
    t5 = motion3*motion6
    t6 = motion4*motion5
    t7 = (t5 - t6)
    t8 = t7 + t7
    t9 = (t5 + t6)
    t10 = t9 + t9
    return (
        motion0 + (t0 - t1 + t4)*point0 - t8*point1,
        motion1 + t10*point0 + (-t0 + t1 + t4)*point1,
    )


def plane_point_jac(motion, point):
    """plane_point: value and Jacobians."""
    motion0, motion1, _, motion3, motion4, motion5, motion6 = motion
    point0, point1 = point
    t0 = motion4*motion4
    t1 = motion5*motion5
    t2 = motion3*motion3
    t3 = motion6*motion6
    t4 = t2 - t3
    t5 = t0 - t1 + t4
    t6 = motion3*motion6
    t7 = motion4*motion5
    t8 = t6 - t7
    t9 = point1 + point1
    t10 = t6 + t7
    t11 = point0 + point0
    t12 = -t0 + t1 + t4
    t13 = motion3*point1 + motion6*point0
    t14 = motion5*t13
    t15 = motion3*point0 - motion6*point1
    t16 = motion4*t15
    t17 = motion4*point0 + motion5*point1
    t18 = motion4*point1 - motion5*point0
    t19 = motion3*t17 + motion6*t18
    t20 = motion6*t17
    t21 = motion3*t18
    t22 = motion4*t13 + motion5*t15
    t23 = t8 + t8
    t24 = t10 + t10
    return (
        motion0 + point0*t5 - t9*t8,
        motion1 + t11*t10 + point1*t12,
        1,
        0,
        0,
        t14 - t16 + t19,
        -t20 + t21 - t22,
        -motion3*t13 - motion4*t18 + motion5*t17 - motion6*t15,
        0,
        1,
        0,
        t20 - t21 - t22,
        -t14 + t16 + t19,
        motion3*t15 - motion4*t17 - motion5*t18 - motion6*t13,
        t5,
        -t23,
        t24,
        t12,
    )


def plane_pose(motion, pose):
    """plane_pose: value."""
    motion0, motion1, _, motion3, motion4, motion5, motion6 = motion
    pose0, pose1, pose2 = pose
    t0 = motion3*motion6 + motion4*motion5
    t1 = t0 + t0
    t2 = motion3*motion3
    t3 = motion4*motion4
    t4 = motion5*motion5
    t5 = motion6*motion6
    outer2 = arctan2(t1, t2 + t3 - t4 - t5)
    t6 = cos(outer2)
    t7 = sin(outer2)
    return (
        motion0 + pose0*t6 - pose1*t7,
        motion1 + pose0*t7 + pose1*t6,
        outer2 + pose2,
    )


def plane_pose_jac(motion, pose):
    """plane_pose: value and Jacobians."""
    motion0, motion1, _, motion3, motion4, motion5, motion6 = motion
    pose0, pose1, pose2 = pose
    t0 = motion3*motion6 + motion4*motion5
    t1 = t0 + t0
    t2 = motion3*motion3
    t3 = motion4*motion4
    t4 = motion5*motion5
    t5 = motion6*motion6
    t6 = t2 + t3 - t4 - t5
    outer2 = arctan2(t1, t6)
    t7 = cos(outer2)
    t8 = sin(outer2)
    t9 = pose0*t7 - pose1*t8
    t10 = pose0*t8 + pose1*t7
    t11 = t0*t0
    t12 = t6*t6
    t13 = 4*t11 + t12
    t14 = 1/t13
    t15 = motion4*t6 + motion5*t1
    t16 = motion3*t6 + motion6*t1
    t17 = motion3*t1 - motion6*t6
    t18 = motion4*t1 - motion5*t6
    t19 = (motion3*t15 + motion4*t16 + motion5*t17 + motion6*t18)*t14
    t20 = (motion3*t16 - motion4*t15 - motion5*t18 + motion6*t17)*t14
    return (
        motion0 + t9,
        motion1 + t10,
        outer2 + pose2,
        1,
        0,
        0,
        0,
        -t10*t19,
        -t10*t20,
        0,
        1,
        0,
        0,
        t19*t9,
        t20*t9,
        0,
        0,
        0,
        0,
        t19,
        t20,
        t7,
        -t8,
        0,
        t8,
        t7,
        0,
        0,
        0,
        1,
    )
