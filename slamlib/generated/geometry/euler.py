"""Generated from slamlib/geometry/euler.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "to_rotation": "876e20d40b8c3efa",
    "to_quaternion": "ab234bebc639f5d2",
    "yaw_of": "45829a9f5fcfd914",
    "roll_pitch_of": "75f88168ed6c7f4a",
    "half_sums": "0a9626a89f7f5494",
}
SHAPES = {
    "to_rotation": (3, 3),
    "to_quaternion": (4,),
    "yaw_of": (),
    "roll_pitch_of": (2,),
    "half_sums": (3,),
}


def to_rotation(angles):
    """to_rotation: value."""
    angles0, angles1, angles2 = angles
    t0 = cos(angles1)
    t1 = cos(angles2)
    t2 = sin(angles2)
    t3 = cos(angles0)
    t4 = t2*t3
    t5 = sin(angles1)
    t6 = sin(angles0)
    t7 = t1*t6
    t8 = t1*t3
    t9 = t2*t6
    return (
        t0*t1,
        -t4 + t5*t7,
        t5*t8 + t9,
        t0*t2,
        t5*t9 + t8,
        t4*t5 - t7,
        -t5,
        t0*t6,
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
    t15 = -t5*t6 + t8
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
    right0 = cos(t0)
    t1 = angles1/2
    left0 = cos(t1)
    t2 = angles2/2
    left0_ = cos(t2)
    t3 = left0*left0_
    right1 = sin(t0)
    left2 = sin(t1)
    left3 = sin(t2)
    t4 = left2*left3
    t5 = left0_*left2
    t6 = left0*left3
    return (
        right0*t3 + right1*t4,
        -right0*t4 + right1*t3,
        right0*t5 + right1*t6,
        right0*t6 - right1*t5,
    )


def to_quaternion_jac(angles):
    """to_quaternion: value and Jacobians."""
    angles0, angles1, angles2 = angles
    t0 = angles0/2
    right0 = cos(t0)
    t1 = angles1/2
    t2 = cos(t1)
    t3 = angles2/2
    t4 = cos(t3)
    t5 = t2*t4
    right1 = sin(t0)
    t6 = sin(t1)
    t7 = sin(t3)
    t8 = t6*t7
    t9 = right0*t5 + right1*t8
    t10 = -right0*t8 + right1*t5
    t11 = t4*t6
    t12 = t2*t7
    t13 = right0*t11 + right1*t12
    t14 = right0*t12 - right1*t11
    t15 = t10*t10
    t16 = t13*t13
    t17 = t14*t14
    t18 = t9*t9
    t19 = t15 + t16 + t17 + t18
    t20 = 1/t19
    t21 = right0*t7
    t22 = right1*t4
    t23 = t2*t21 - t22*t6
    t24 = right0*t4
    t25 = right1*t7
    t26 = t2*t24 + t25*t6
    t27 = t2*t22 - t21*t6
    t28 = t2*t25 + t24*t6
    t29 = right1*t2
    t30 = right0*t6
    t31 = t29*t4 + t30*t7
    t32 = t30*t4 - t29*t7
    t33 = right1*t6
    t34 = right0*t2
    t35 = t33*t4 + t34*t7
    t36 = t34*t4 - t33*t7
    return (
        t9,
        t10,
        t13,
        t14,
        1,
        0,
        -(-t10*t23 + t13*t26 - t14*t27 + t28*t9)*t20,
        0,
        (-t10*t31 + t13*t32 + t14*t35 + t36*t9)*t20,
        (t10*t26 + t13*t23 + t14*t28 + t27*t9)*t20,
        0,
        -(t10*t36 + t13*t35 - t14*t32 + t31*t9)*t20,
        -(t10*t27 + t13*t28 - t14*t23 - t26*t9)*t20,
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
    t0 = matrix0*matrix0
    t1 = matrix3*matrix3
    t2 = t0 + t1
    t3 = 1/t2
    return (
        arctan2(matrix3, matrix0),
        -matrix3*t3,
        0,
        0,
        matrix0*t3,
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
    t5 = t2*t2
    t6 = t3*t3
    t7 = t5 + t6
    t8 = 1/t7
    t9 = t0*t8
    t10 = t1*t8
    t11 = matrix6*matrix6
    t12 = t4*t4
    t13 = t11 + t12
    t14 = 1/t13
    t15 = matrix6*t14
    return (
        arctan2(t2, -t3),
        arctan2(-matrix6, t4),
        0,
        t2*t9,
        -t3*t9,
        0,
        -t10*t2,
        t10*t3,
        0,
        0,
        0,
        t1*t15,
        0,
        0,
        t0*t15,
        0,
        0,
        -t14*t4,
        0,
        0,
        -(-(matrix1*t1 + matrix4*t0)*t2 + (matrix2*t1 + matrix5*t0)*t3)*t8,
        -(matrix0*t0 - matrix3*t1)*t15,
    )


def half_sums(q):
    """half_sums: value."""
    q0, q1, q2, q3 = q
    t0 = q1 - q3
    t1 = q0 + q2
    t2 = arctan2(-t0, t1)
    t3 = q1 + q3
    t4 = q0 - q2
    t5 = arctan2(t3, t4)
    t6 = q0*q2 - q1*q3
    t7 = t6 + t6
    t8 = t0*t0
    t9 = t1*t1
    t10 = t8 + t9
    t11 = sqrt(t10)
    t12 = t3*t3
    t13 = t4*t4
    t14 = t12 + t13
    t15 = sqrt(t14)
    return (
        -t2 + t5,
        arctan2(t7, t11*t15),
        t2 + t5,
    )


def half_sums_jac(q):
    """half_sums: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = q1 - q3
    t1 = q0 + q2
    t2 = arctan2(-t0, t1)
    t3 = q1 + q3
    t4 = q0 - q2
    t5 = arctan2(t3, t4)
    t6 = q0*q2 - q1*q3
    t7 = t6 + t6
    t8 = t0*t0
    t9 = t1*t1
    t10 = t8 + t9
    t11 = sqrt(t10)
    t12 = t3*t3
    t13 = t4*t4
    t14 = t12 + t13
    t15 = sqrt(t14)
    t16 = t11*t15
    t17 = 1/t14
    t18 = t17*t3
    t19 = 1/t10
    t20 = t0*t19
    t21 = t18 + t20
    t22 = t21/2
    t23 = t1*t19
    t24 = t17*t4
    t25 = t23 + t24
    t26 = t25/2
    t27 = q0/2
    t28 = -t0
    t29 = t28*t28
    t30 = t29 + t9
    t31 = 1/t30
    t32 = -t18
    t33 = -t23 + t24
    t34 = q1/2
    t35 = t20 + t32
    t36 = t6*t6
    t37 = t10*t14 + 4*t36
    t38 = 1/t37
    t39 = q0*t16
    t40 = 1/t11
    t41 = t15*t40
    t42 = t1*t41
    t43 = 1/t15
    t44 = t11*t43
    t45 = t4*t44
    t46 = -t42 + t45
    t47 = t0*t41
    t48 = q2*t16 - (t42 + t45)*t6
    t49 = sqrt(t30)
    t50 = t15*t49
    t51 = -t6
    t52 = 1/t49
    t53 = t15*t52
    t54 = t3*t43*t49
    t55 = q3/2
    t56 = q2/2
    return (
        -t2 + t5,
        arctan2(t7, t16),
        t2 + t5,
        1,
        q2*t22 - q3*t26 - (t0*t31 + t32)*t27 + t33*t34,
        q2*t26 + q3*t22 + t27*t33 + t34*t35,
        0,
        ((t39 + t46*t6)*q0 - (q1*t16 + (t11*t3*t43 - t47)*t6)*q1 - q2*t48 + (q3*t16 + (t3*t44 + t47)*t6)*q3)*t38,
        -((q1*t50 - (t28*t53 + t54)*t51)*q0 + (t39 + t46*t6)*q1 + (q3*t50 - (t0*t53 + t54)*t51)*q2 + q3*t48)*t38,
        0,
        q1*t26 + t21*t27 - t33*t55 - t35*t56,
        -t21*t34 + t25*t27 + t33*t56 - t35*t55,
    )
