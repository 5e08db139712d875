"""Generated from slamlib/geometry/euler.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin

DIGESTS = {
    "to_rotation": "176391b3f83229ae",
    "to_quaternion": "d5f3a4b8c3c3d2cd",
    "yaw_of": "3e981e1d1568893b",
    "roll_pitch_of": "bbf6bea6c4545d82",
}
SHAPES = {
    "to_rotation": (3, 3),
    "to_quaternion": (4,),
    "yaw_of": (),
    "roll_pitch_of": (2,),
}


def to_rotation(angles):
    """to_rotation: value."""
    angles0, angles1, angles2 = angles
    t0 = cos(angles1)
    t1 = cos(angles2)
    t2 = sin(angles2)
    t3 = cos(angles0)
    t4 = sin(angles1)
    t5 = sin(angles0)
    t6 = t1*t5
    t7 = t2*t5
    t8 = t1*t3
    return (
        t0*t1,
        -t2*t3 + t4*t6,
        t4*t8 + t7,
        t0*t2,
        t4*t7 + t8,
        t2*t3*t4 - t6,
        -t4,
        t0*t5,
        t0*t3,
    )


def to_rotation_jac(angles):
    """to_rotation: value and Jacobians."""
    angles0, angles1, angles2 = angles
    t0 = cos(angles1)
    t1 = cos(angles2)
    t2 = t0*t1
    t3 = sin(angles2)
    t4 = cos(angles0)
    t5 = t3*t4
    t6 = sin(angles1)
    t7 = sin(angles0)
    t8 = t1*t7
    t9 = -t5 + t6*t8
    t10 = t3*t7
    t11 = t1*t4
    t12 = t10 + t11*t6
    t13 = t0*t3
    t14 = t10*t6 + t11
    t15 = -t3*t4*t6 + t8
    t16 = -t15
    t17 = t0*t7
    t18 = t0*t4
    t19 = -t14
    return (
        t2,
        t9,
        t12,
        t13,
        t14,
        t16,
        -t6,
        t17,
        t18,
        0,
        -t1*t6,
        -t13,
        t12,
        t2*t7,
        t19,
        -t9,
        t2*t4,
        t15,
        0,
        -t3*t6,
        t2,
        t16,
        t0*t10,
        t9,
        t19,
        t0*t5,
        t12,
        0,
        -t0,
        0,
        t18,
        -t6*t7,
        0,
        -t17,
        -t4*t6,
        0,
    )


def to_quaternion(angles):
    """to_quaternion: value."""
    angles0, angles1, angles2 = angles
    t0 = angles0/2
    t1 = sin(t0)
    t2 = angles1/2
    t3 = sin(t2)
    t4 = angles2/2
    t5 = sin(t4)
    t6 = t3*t5
    t7 = cos(t0)
    t8 = cos(t2)
    t9 = cos(t4)
    t10 = t8*t9
    t11 = t3*t9
    return (
        t1*t6 + t10*t7,
        t1*t10 - t6*t7,
        t1*t5*t8 + t11*t7,
        -t1*t11 + t5*t7*t8,
    )


def to_quaternion_jac(angles):
    """to_quaternion: value and Jacobians."""
    angles0, angles1, angles2 = angles
    t0 = angles0/2
    t1 = sin(t0)
    t2 = angles1/2
    t3 = sin(t2)
    t4 = angles2/2
    t5 = sin(t4)
    t6 = t3*t5
    t7 = t1*t6
    t8 = cos(t0)
    t9 = cos(t2)
    t10 = cos(t4)
    t11 = t10*t9
    t12 = t11*t8
    t13 = t12 + t7
    t14 = t1*t11
    t15 = t6*t8
    t16 = t14 - t15
    t17 = t5*t9
    t18 = t1*t17
    t19 = t10*t3
    t20 = t19*t8
    t21 = t18 + t20
    t22 = t1*t19
    t23 = t22 - t5*t8*t9
    t24 = t21*t21
    t25 = t16*t16
    t26 = t13*t13 + t23*t23
    t27 = 1/(t24 + t25 + t26)
    t28 = t14 + t15
    t29 = t17*t8 + t22
    t30 = -t12 + t7
    t31 = t18 - t20
    t32 = 2*t27
    return (
        t13,
        t16,
        t21,
        -t23,
        1,
        t27*(-t13*t29 - t16*t31 + t21*t28 + t23*t30),
        -t32*(t13*t21 + t16*t23),
        0,
        -t27*(t13*t30 + t16*t28 + t21*t31 + t23*t29),
        t32*(t13*t16 - t21*t23),
        0,
        t27*(-t13*t28 + t16*t30 - t21*t29 + t23*t31),
        t27*(-t24 - t25 + t26),
    )


def to_quaternion_storage_jac(angles):
    """to_quaternion: value and derivatives by stored numbers."""
    angles0, angles1, angles2 = angles
    t0 = angles0/2
    t1 = sin(t0)
    t2 = angles1/2
    t3 = sin(t2)
    t4 = angles2/2
    t5 = sin(t4)
    t6 = t3*t5
    t7 = t1*t6
    t8 = cos(t0)
    t9 = cos(t2)
    t10 = cos(t4)
    t11 = t10*t9
    t12 = t11*t8 + t7
    t13 = t1*t11
    t14 = t6*t8
    t15 = t13 - t14
    t16 = t5*t9
    t17 = t1*t16
    t18 = t10*t3
    t19 = t18*t8
    t20 = t17 + t19
    t21 = t1*t18
    t22 = t21 - t5*t8*t9
    t23 = -t22
    t24 = t12/2
    t25 = (-t20)/2
    return (
        t12,
        t15,
        t20,
        t23,
        (-t15)/2,
        t17/2 + (-t19)/2,
        t22/2,
        t24,
        (-t16*t8)/2 + (-t21)/2,
        t25,
        t23/2,
        (t10*t8*t9)/2 + (-t7)/2,
        t15/2,
        t25,
        (-t13)/2 + (-t14)/2,
        t24,
    )


def yaw_of(matrix):
    """yaw_of: value."""
    matrix0, _, _, matrix3, _, _, _, _, _ = matrix
    return (
        arctan2(matrix3, matrix0),
    )


def yaw_of_jac(matrix):
    """yaw_of: value and Jacobians."""
    matrix0, _, _, matrix3, _, _, _, _, _ = matrix
    t0 = 1/(matrix0*matrix0 + matrix3*matrix3)
    return (
        arctan2(matrix3, matrix0),
        -matrix3*t0,
        0,
        0,
        matrix0*t0,
        0,
        0,
        0,
        0,
        0,
    )


def roll_pitch_of(matrix, yaw):
    """roll_pitch_of: value."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, _, _ = matrix
    yaw, = yaw
    t0 = sin(yaw)
    t1 = cos(yaw)
    return (
        arctan2(matrix2*t0 - matrix5*t1, -matrix1*t0 + matrix4*t1),
        arctan2(-matrix6, matrix0*t1 + matrix3*t0),
    )


def roll_pitch_of_jac(matrix, yaw):
    """roll_pitch_of: value and Jacobians."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, _, _ = matrix
    yaw, = yaw
    t0 = sin(yaw)
    t1 = cos(yaw)
    t2 = matrix2*t0 - matrix5*t1
    t3 = matrix1*t0 - matrix4*t1
    t4 = matrix0*t1 + matrix3*t0
    t5 = 1/(t2*t2 + t3*t3)
    t6 = t0*t5
    t7 = t1*t5
    t8 = 1/(matrix6*matrix6 + t4*t4)
    t9 = matrix6*t8
    return (
        arctan2(t2, -t3),
        arctan2(-matrix6, t4),
        0,
        t2*t6,
        -t3*t6,
        0,
        -t2*t7,
        t3*t7,
        0,
        0,
        0,
        t1*t9,
        0,
        0,
        t0*t9,
        0,
        0,
        -t4*t8,
        0,
        0,
        t5*(t2*(matrix1*t1 + matrix4*t0) - t3*(matrix2*t1 + matrix5*t0)),
        -t9*(matrix0*t0 - matrix3*t1),
    )
