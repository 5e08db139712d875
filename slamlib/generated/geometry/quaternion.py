"""Generated from slamlib/geometry/quaternion.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, sqrt, stumpff

DIGESTS = {
    "left_matrix": "554befca3f2248be",
    "right_matrix": "fdb7c26a36094267",
    "pi_matrix": "d9a66a6713c2c1da",
    "product": "ed70c0da46b4008f",
    "conjugate": "b280f541515a66a7",
    "exponential": "58692098a3553fb8",
    "logarithm": "c1497c1df8eac33c",
    "plus": "3bedf4199a97775b",
    "minus": "75a7213ae9a66a2f",
    "rotation": "615144ffd557d53c",
    "from_rotation": "12065197006a240d",
    "skew": "d886ebcde37afc31",
    "right_jacobian": "8a2c86eaddd0a197",
    "left_jacobian": "edcd770c58d79cc5",
    "left_inverse": "1f5b1cb0493b86d4",
}
SHAPES = {
    "left_matrix": (4, 4),
    "right_matrix": (4, 4),
    "pi_matrix": (4, 3),
    "product": (4,),
    "conjugate": (4,),
    "exponential": (4,),
    "logarithm": (3,),
    "plus": (4,),
    "minus": (3,),
    "rotation": (3, 3),
    "from_rotation": (4,),
    "skew": (3, 3),
    "right_jacobian": (3, 3),
    "left_jacobian": (3, 3),
    "left_inverse": (3, 3),
}


def left_matrix(q):
    """left_matrix: value."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        q0,
        t0,
        t1,
        t2,
        q1,
        q0,
        t2,
        q2,
        q2,
        q3,
        q0,
        t0,
        q3,
        t1,
        q1,
        q0,
    )


def left_matrix_jac(q):
    """left_matrix: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        q0,
        t0,
        t1,
        t2,
        q1,
        q0,
        t2,
        q2,
        q2,
        q3,
        q0,
        t0,
        q3,
        t1,
        q1,
        q0,
        1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        1,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        1,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        1,
        1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        0,
        1,
        0,
        0,
        -1,
        0,
        0,
        1,
        0,
        0,
        1,
        0,
        0,
        0,
    )


def right_matrix(q):
    """right_matrix: value."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        q0,
        t0,
        t1,
        t2,
        q1,
        q0,
        q3,
        t1,
        q2,
        t2,
        q0,
        q1,
        q3,
        q2,
        t0,
        q0,
    )


def right_matrix_jac(q):
    """right_matrix: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        q0,
        t0,
        t1,
        t2,
        q1,
        q0,
        q3,
        t1,
        q2,
        t2,
        q0,
        q1,
        q3,
        q2,
        t0,
        q0,
        1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        1,
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
        -1,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        -1,
        1,
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
        1,
        0,
        0,
        1,
        0,
        0,
        -1,
        0,
        0,
        1,
        0,
        0,
        0,
    )


def pi_matrix(q):
    """pi_matrix: value."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        t0,
        t1,
        t2,
        q0,
        t2,
        q2,
        q3,
        q0,
        t0,
        t1,
        q1,
        q0,
    )


def pi_matrix_jac(q):
    """pi_matrix: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = -q1
    t1 = -q2
    t2 = -q3
    return (
        t0,
        t1,
        t2,
        q0,
        t2,
        q2,
        q3,
        q0,
        t0,
        t1,
        q1,
        q0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        1,
        0,
        0,
        0,
        0,
        1,
        1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        1,
        0,
        0,
        1,
        0,
        0,
        0,
    )


def product(left, right):
    """product: value."""
    left0, left1, left2, left3 = left
    right0, right1, right2, right3 = right
    return (
        left0*right0 - left1*right1 - left2*right2 - left3*right3,
        left0*right1 + left1*right0 + left2*right3 - left3*right2,
        left0*right2 - left1*right3 + left2*right0 + left3*right1,
        left0*right3 + left1*right2 - left2*right1 + left3*right0,
    )


def product_jac(left, right):
    """product: value and Jacobians."""
    left0, left1, left2, left3 = left
    right0, right1, right2, right3 = right
    t0 = -right1
    t1 = -right2
    t2 = -right3
    t3 = -left1
    t4 = -left2
    t5 = -left3
    return (
        left0*right0 - left1*right1 - left2*right2 - left3*right3,
        left0*right1 + left1*right0 + left2*right3 - left3*right2,
        left0*right2 - left1*right3 + left2*right0 + left3*right1,
        left0*right3 + left1*right2 - left2*right1 + left3*right0,
        right0,
        t0,
        t1,
        t2,
        right1,
        right0,
        right3,
        t1,
        right2,
        t2,
        right0,
        right1,
        right3,
        right2,
        t0,
        right0,
        left0,
        t3,
        t4,
        t5,
        left1,
        left0,
        t5,
        left2,
        left2,
        left3,
        left0,
        t3,
        left3,
        t4,
        left1,
        left0,
    )


def conjugate(q):
    """conjugate: value."""
    q0, q1, q2, q3 = q
    return (
        q0,
        -q1,
        -q2,
        -q3,
    )


def conjugate_jac(q):
    """conjugate: value and Jacobians."""
    q0, q1, q2, q3 = q
    return (
        q0,
        -q1,
        -q2,
        -q3,
        1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        0,
        -1,
    )


def exponential(vector):
    """exponential: value."""
    vector0, vector1, vector2 = vector
    t0 = vector0*vector0
    t1 = vector1*vector1
    t2 = vector2*vector2
    t3 = (t0 + t1 + t2)/4
    t4 = stumpff(1, t3)/2
    return (
        stumpff(0, t3),
        t4*vector0,
        t4*vector1,
        t4*vector2,
    )


def exponential_jac(vector):
    """exponential: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector0*vector0
    t1 = vector1*vector1
    t2 = vector2*vector2
    t3 = t0/4 + t1/4 + t2/4
    t4 = stumpff(1, t3)
    t5 = t4/2
    t6 = t4/4
    t7 = stumpff(2, t3)/8 + (-stumpff(3, t3))/8
    t8 = -t5
    t9 = t7*vector0
    t10 = -t9*vector1
    t11 = -t9*vector2
    t12 = -t7*vector1*vector2
    return (
        stumpff(0, t3),
        t5*vector0,
        t5*vector1,
        t5*vector2,
        -t6*vector0,
        -t6*vector1,
        -t6*vector2,
        -t0*t7 - t8,
        t10,
        t11,
        t10,
        -t1*t7 - t8,
        t12,
        t11,
        t12,
        -t2*t7 - t8,
    )


def logarithm(q):
    """logarithm: value."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = q3*q3
    t3 = arctan_ratio(t0 + t1 + t2, q0)
    t4 = t3 + t3
    return (
        q1*t4,
        q2*t4,
        q3*t4,
    )


def logarithm_jac(q):
    """logarithm: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = q3*q3
    t3 = t0 + t1 + t2
    t4 = arctan_ratio(t3, q0)
    t5 = t4 + t4
    t6 = q0*q0
    t7 = t6 + t3
    t8 = 1/t7
    t9 = t8 + t8
    t10 = arctan_ratio_slope(t3, q0)
    t11 = t10 + t10
    t12 = t0 + t0
    t13 = 4*q1*t10
    t14 = q2*t13
    t15 = q3*t13
    t16 = t1 + t1
    t17 = 4*q2*q3*t10
    t18 = t11 + t11
    return (
        q1*t5,
        q2*t5,
        q3*t5,
        -q1*t9,
        t12*t11 + t5,
        t14,
        t15,
        -q2*t9,
        t14,
        t16*t11 + t5,
        t17,
        -q3*t9,
        t15,
        t17,
        t18*t2 + t5,
    )


def plus(q, step):
    """plus: value."""
    q0, q1, q2, q3 = q
    step0, step1, step2 = step
    t0 = step0*step0
    t1 = step1*step1
    t2 = step2*step2
    t3 = (t0 + t1 + t2)/4
    right0 = stumpff(0, t3)
    t4 = stumpff(1, t3)/2
    right1 = step0*t4
    right2 = step1*t4
    right3 = step2*t4
    return (
        q0*right0 - q1*right1 - q2*right2 - q3*right3,
        q0*right1 + q1*right0 + q2*right3 - q3*right2,
        q0*right2 - q1*right3 + q2*right0 + q3*right1,
        q0*right3 + q1*right2 - q2*right1 + q3*right0,
    )


def plus_jac(q, step):
    """plus: value and Jacobians."""
    q0, q1, q2, q3 = q
    step0, step1, step2 = step
    t0 = step0*step0
    t1 = step1*step1
    t2 = step2*step2
    t3 = t0/4 + t1/4 + t2/4
    right0 = stumpff(0, t3)
    t4 = stumpff(1, t3)
    t5 = t4/2
    right1 = step0*t5
    right2 = step1*t5
    right3 = step2*t5
    t6 = -right1
    t7 = -right2
    t8 = -right3
    t9 = stumpff(2, t3) - stumpff(3, t3)
    t10 = -4*t4
    t11 = t0*t9 + t10
    t12 = (-t11)/8
    t13 = t4/4
    t14 = q0*t13
    t15 = step0*t9
    t16 = t15/8
    t17 = step1*t16
    t18 = -q2*t17
    t19 = q3*step2
    t20 = t16*t19
    t21 = t1*t9 + t10
    t22 = (-t21)/8
    t23 = q1*t17
    t24 = step1*t9
    t25 = t24/8
    t26 = -t19*t25
    t27 = t2*t9 + t10
    t28 = (-t27)/8
    t29 = step2*t16
    t30 = -q1*t29
    t31 = step2*t25
    t32 = q2*t31
    t33 = q1*t13
    t34 = q0/8
    t35 = q2*t29
    t36 = q3*t17
    t37 = t15*t34
    t38 = step1*t37
    t39 = step2*t37
    t40 = q2*t13
    t41 = q1*t31
    t42 = step2*t24*t34
    t43 = q3*t13
    return (
        q0*right0 - q1*right1 - q2*right2 - q3*right3,
        q0*right1 + q1*right0 + q2*right3 - q3*right2,
        q0*right2 - q1*right3 + q2*right0 + q3*right1,
        q0*right3 + q1*right2 - q2*right1 + q3*right0,
        right0,
        t6,
        t7,
        t8,
        right1,
        right0,
        right3,
        t7,
        right2,
        t8,
        right0,
        right1,
        right3,
        right2,
        t6,
        right0,
        -q1*t12 - step0*t14 - t18 + t20,
        -q2*t22 - step1*t14 + t23 - t26,
        -q3*t28 - step2*t14 - t30 + t32,
        -step0*t33 - t11*t34 - t35 + t36,
        -q3*t22 - step1*t33 - t32 - t38,
        q2*t28 - step2*t33 - t26 - t39,
        q3*t12 - step0*t40 - t30 - t38,
        -step1*t40 - t21*t34 - t36 + t41,
        -q1*t28 - step2*t40 - t20 - t42,
        -q2*t12 - step0*t43 - t23 - t39,
        q1*t22 - step1*t43 - t18 - t42,
        -step2*t43 - t27*t34 + t35 - t41,
    )


def minus(q, origin):
    """minus: value."""
    q0, q1, q2, q3 = q
    origin0, origin1, origin2, origin3 = origin
    t0 = origin0*q1 - origin1*q0 - origin2*q3 + origin3*q2
    t1 = t0*t0
    t2 = origin0*q2 + origin1*q3 - origin2*q0 - origin3*q1
    t3 = t2*t2
    t4 = origin0*q3 - origin1*q2 + origin2*q1 - origin3*q0
    t5 = t4*t4
    t6 = arctan_ratio(t1 + t3 + t5, origin0*q0 + origin1*q1 + origin2*q2 + origin3*q3)
    t7 = t6 + t6
    return (
        t0*t7,
        t2*t7,
        t4*t7,
    )


def minus_jac(q, origin):
    """minus: value and Jacobians."""
    q0, q1, q2, q3 = q
    origin0, origin1, origin2, origin3 = origin
    t0 = origin0*q1 - origin1*q0 - origin2*q3 + origin3*q2
    t1 = t0*t0
    t2 = origin0*q2 + origin1*q3 - origin2*q0 - origin3*q1
    t3 = t2*t2
    t4 = origin0*q3 - origin1*q2 + origin2*q1 - origin3*q0
    t5 = t4*t4
    t6 = t1 + t3 + t5
    t7 = origin0*q0 + origin1*q1 + origin2*q2 + origin3*q3
    t8 = arctan_ratio(t6, t7)
    t9 = t8 + t8
    t10 = t7*t7
    t11 = t6 + t10
    t12 = 1/t11
    t13 = arctan_ratio_slope(t6, t7)
    t14 = t13 + t13
    t15 = origin0*t12 + (origin1*t0 + origin2*t2 + origin3*t4)*t14
    t16 = t0 + t0
    t17 = origin1*t8
    t18 = t17 + t17
    t19 = origin0*t9
    t20 = origin1*t12 - (origin0*t0 + origin2*t4 - origin3*t2)*t14
    t21 = origin2*t12 - (origin0*t2 - origin1*t4 + origin3*t0)*t14
    t22 = origin3*t8
    t23 = t22 + t22
    t24 = origin3*t12 - (origin0*t4 + origin1*t2 - origin2*t0)*t14
    t25 = origin2*t8
    t26 = t25 + t25
    t27 = t15 + t15
    t28 = t2 + t2
    t29 = t4 + t4
    t30 = q0*t12 - (q1*t0 + q2*t2 + q3*t4)*t14
    t31 = q1*t9
    t32 = q1*t12
    t33 = q0*t0 + q2*t4 - q3*t2
    t34 = t32 + t14*t33
    t35 = q0*t9
    t36 = q2*t12
    t37 = q0*t2 - q1*t4 + q3*t0
    t38 = t36 + t14*t37
    t39 = q3*t9
    t40 = q3*t12
    t41 = q0*t4 + q1*t2 - q2*t0
    t42 = q2*t9
    t43 = t40 + t14*t41
    return (
        t0*t9,
        t2*t9,
        t4*t9,
        -t16*t15 - t18,
        t19 - t16*t20,
        -t16*t21 + t23,
        -t16*t24 - t26,
        -t27*t2 - t26,
        -t20*t28 - t23,
        t19 - t21*t28,
        -t24*t28 + t18,
        -t27*t4 - t23,
        -t20*t29 + t26,
        -t21*t29 - t18,
        t19 - t24*t29,
        -t16*t30 + t31,
        -t16*t34 - t35,
        -t16*t38 - t39,
        -(t40 + t14*t41)*t16 + t42,
        -t28*t30 + t42,
        -(t32 + t14*t33)*t28 + t39,
        -t28*t38 - t35,
        -t28*t43 - t31,
        -t29*t30 + t39,
        -t29*t34 - t42,
        -(t36 + t14*t37)*t29 + t31,
        -t29*t43 - t35,
    )


def rotation(q):
    """rotation: value."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = -t1
    t3 = q0*q0
    t4 = q3*q3
    t5 = t3 - t4
    t6 = q0*q3
    t7 = t6 + t6
    t8 = q1*q2
    t9 = t8 + t8
    t10 = q0*q2
    t11 = t10 + t10
    t12 = q1*q3
    t13 = t12 + t12
    t14 = -t0
    t15 = q0*q1
    t16 = t15 + t15
    t17 = q2*q3
    t18 = t17 + t17
    return (
        t0 + t2 + t5,
        -t7 + t9,
        t11 + t13,
        t7 + t9,
        t1 + t14 + t5,
        -t16 + t18,
        -t11 + t13,
        t16 + t18,
        t14 + t2 + t3 + t4,
    )


def rotation_jac(q):
    """rotation: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = -t1
    t3 = q0*q0
    t4 = q3*q3
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = q0*q3
    t8 = t7 + t7
    t9 = q1*q2
    t10 = t9 + t9
    t11 = t8 - t10
    t12 = -t11
    t13 = q0*q2
    t14 = t13 + t13
    t15 = q1*q3
    t16 = t15 + t15
    t17 = t14 + t16
    t18 = t8 + t10
    t19 = -t0
    t20 = t1 + t19 + t5
    t21 = q0*q1
    t22 = t21 + t21
    t23 = q2*q3
    t24 = t23 + t23
    t25 = t22 - t24
    t26 = -t25
    t27 = t14 - t16
    t28 = -t27
    t29 = t22 + t24
    t30 = t19 + t2 + t3 + t4
    return (
        t6,
        t12,
        t17,
        t18,
        t20,
        t26,
        t28,
        t29,
        t30,
        0,
        -t17,
        t12,
        t17,
        0,
        -t6,
        t11,
        t6,
        0,
        0,
        t25,
        t20,
        t26,
        0,
        -t18,
        -t20,
        t18,
        0,
        0,
        -t30,
        t29,
        t30,
        0,
        t27,
        -t29,
        t28,
        0,
    )


def from_rotation(matrix, pivot):
    """from_rotation: value."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, matrix7, matrix8 = matrix
    pivot0, pivot1, pivot2, pivot3 = pivot
    t0 = matrix0 + 1
    t1 = matrix5 - matrix7
    t2 = matrix2 - matrix6
    t3 = matrix1 - matrix3
    t4 = (matrix4 + matrix8 + t0)*pivot0 - pivot1*t1 + pivot2*t2 - pivot3*t3
    t5 = -matrix8
    t6 = -matrix4
    t7 = matrix1 + matrix3
    t8 = matrix2 + matrix6
    t9 = -pivot0*t1 + (t0 + t5 + t6)*pivot1 + pivot2*t7 + pivot3*t8
    t10 = matrix0 - 1
    t11 = matrix5 + matrix7
    t12 = pivot0*t2 + pivot1*t7 - (matrix8 + t6 + t10)*pivot2 + pivot3*t11
    t13 = pivot0*t3 - pivot1*t8 - pivot2*t11 + (matrix4 + t5 + t10)*pivot3
    t14 = pivot0*t4 + pivot1*t9 + pivot2*t12 - pivot3*t13
    t15 = 1/t14
    t16 = sqrt(t15)
    t17 = t16/2
    return (
        t17*t4,
        t17*t9,
        t12*t17,
        -t13*t17,
    )


def from_rotation_jac(matrix, pivot):
    """from_rotation: value and Jacobians."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, matrix7, matrix8 = matrix
    pivot0, pivot1, pivot2, pivot3 = pivot
    t0 = matrix1 - matrix3
    t1 = matrix2 + matrix6
    t2 = matrix5 + matrix7
    t3 = matrix0 - 1
    t4 = -matrix8
    t5 = matrix4 + t3 + t4
    t6 = pivot0*t0 - pivot1*t1 - pivot2*t2 + pivot3*t5
    t7 = matrix0 + 1
    t8 = matrix4 + matrix8
    t9 = t7 + t8
    t10 = matrix5 - matrix7
    t11 = matrix2 - matrix6
    t12 = pivot0*t9 - pivot1*t10 + pivot2*t11 - pivot3*t0
    t13 = -matrix4
    t14 = matrix1 + matrix3
    t15 = -pivot0*t10 + (t7 + t13 + t4)*pivot1 + pivot2*t14 + pivot3*t1
    t16 = matrix8 + t3 + t13
    t17 = pivot0*t11 + pivot1*t14 - pivot2*t16 + pivot3*t2
    t18 = pivot0*t12 + pivot1*t15 + pivot2*t17
    t19 = -pivot3*t6 + t18
    t20 = 1/t19
    t21 = sqrt(t20)
    t22 = t21/2
    t23 = t21/4
    t24 = pivot0 + pivot0
    t25 = pivot1*pivot1
    t26 = pivot2*pivot2
    t27 = -t26
    t28 = pivot0*pivot0
    t29 = pivot3*pivot3
    t30 = t28 - t29
    t31 = t25 + t27 + t30
    t32 = t12*t20
    t33 = pivot0*pivot3
    t34 = pivot1*pivot2
    t35 = t33 - t34
    t36 = -t6
    t37 = pivot3*t36 + t18
    t38 = 1/t37
    t39 = t12*t38
    t40 = pivot0*pivot2
    t41 = pivot1*pivot3
    t42 = t40 + t41
    t43 = t33 + t34
    t44 = -t25
    t45 = t26 + t30 + t44
    t46 = pivot0*pivot1
    t47 = pivot2*pivot3
    t48 = t46 - t47
    t49 = t40 - t41
    t50 = t46 + t47
    t51 = t27 + t28 + t29 + t44
    t52 = t15*t20
    t53 = pivot1 + pivot1
    t54 = t15*t38
    t55 = t17*t38
    t56 = pivot2 + pivot2
    t57 = t17*t20
    t58 = t36*t38
    t59 = pivot3 + pivot3
    t60 = t20*t6
    t61 = t12*t12
    t62 = -(t15*t39 + t10)*t22
    t63 = -(-matrix2 + matrix6 + t17*t39)*t22
    t64 = -(t36*t39 + t0)*t22
    t65 = t15*t15
    t66 = (t14 - t17*t52)*t22
    t67 = (t52*t6 + t1)*t22
    t68 = t17*t17
    t69 = (t57*t6 + t2)*t22
    t70 = t36*t36
    return (
        t12*t22,
        t15*t22,
        t17*t22,
        -t22*t6,
        (t24 - t31*t32)*t23,
        -(pivot3 - t35*t39)*t22,
        (pivot2 - t32*t42)*t22,
        (pivot3 - t32*t43)*t22,
        (t24 - t32*t45)*t23,
        -(pivot1 - t39*t48)*t22,
        -(pivot2 - t39*t49)*t22,
        (pivot1 - t32*t50)*t22,
        (t24 - t32*t51)*t23,
        (-t31*t52 + t53)*t23,
        (pivot2 + t35*t52)*t22,
        (pivot3 - t42*t52)*t22,
        (pivot2 - t43*t52)*t22,
        -(t45*t54 + t53)*t23,
        -(pivot0 - t48*t54)*t22,
        (pivot3 + t49*t52)*t22,
        (pivot0 - t50*t52)*t22,
        -(t51*t54 + t53)*t23,
        -(t31*t55 + t56)*t23,
        (pivot1 + t35*t57)*t22,
        (pivot0 - t42*t57)*t22,
        (pivot1 - t43*t57)*t22,
        (-t45*t57 + t56)*t23,
        (pivot3 + t48*t57)*t22,
        -(pivot0 - t49*t55)*t22,
        (pivot3 - t50*t57)*t22,
        -(t51*t55 + t56)*t23,
        -(t31*t58 + t59)*t23,
        -(pivot0 - t35*t58)*t22,
        (pivot1 + t42*t60)*t22,
        (pivot0 + t43*t60)*t22,
        -(t45*t58 + t59)*t23,
        (pivot2 - t48*t60)*t22,
        (pivot1 - t49*t60)*t22,
        (pivot2 + t50*t60)*t22,
        (t51*t60 + t59)*t23,
        (t9 - t20*t61)*t22,
        t62,
        t63,
        t64,
        t62,
        -(-matrix0 + t8 + t38*t65 - 1)*t22,
        t66,
        t67,
        t63,
        t66,
        -(t16 + t38*t68)*t22,
        t69,
        t64,
        t67,
        t69,
        -(t5 + t38*t70)*t22,
    )


def skew(vector):
    """skew: value."""
    vector0, vector1, vector2 = vector
    return (
        0,
        -vector2,
        vector1,
        vector2,
        0,
        -vector0,
        -vector1,
        vector0,
        0,
    )


def skew_jac(vector):
    """skew: value and Jacobians."""
    vector0, vector1, vector2 = vector
    return (
        0,
        -vector2,
        vector1,
        vector2,
        0,
        -vector0,
        -vector1,
        vector0,
        0,
        0,
        0,
        0,
        0,
        0,
        -1,
        0,
        1,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
        -1,
        0,
        0,
        0,
        -1,
        0,
        1,
        0,
        0,
        0,
        0,
        0,
    )


def right_jacobian(vector):
    """right_jacobian: value."""
    vector0, vector1, vector2 = vector
    t0 = vector1*vector1
    t1 = vector0*vector0
    t2 = vector2*vector2
    t3 = t0 + t1 + t2
    t4 = stumpff(3, t3)
    t5 = t0*t4
    t6 = t2*t4 - 1
    t7 = t4*vector0
    t8 = t7*vector1
    t9 = stumpff(2, t3)
    t10 = t9*vector2
    t11 = t9*vector1
    t12 = t7*vector2
    t13 = t1*t4
    t14 = t9*vector0
    t15 = t4*vector1*vector2
    return (
        -t5 - t6,
        t8 + t10,
        -t11 + t12,
        t8 - t10,
        -t13 - t6,
        t14 + t15,
        t11 + t12,
        -t14 + t15,
        -t13 - t5 + 1,
    )


def right_jacobian_jac(vector):
    """right_jacobian: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector1*vector1
    t1 = vector0*vector0
    t2 = vector2*vector2
    t3 = t0 + t2
    t4 = t1 + t3
    t5 = stumpff(3, t4)
    t6 = t0*t5
    t7 = t2*t5 - 1
    t8 = t5*vector1
    t9 = t8*vector0
    t10 = stumpff(2, t4)
    t11 = t10*vector2
    t12 = t10*vector1
    t13 = t5*vector0
    t14 = t13*vector2
    t15 = t1*t5
    t16 = t10*vector0
    t17 = t8*vector2
    t18 = stumpff(4, t4)
    t19 = t18 - 3*stumpff(5, t4)
    t20 = t19*vector0
    t21 = t0*t19
    t22 = t5 + t5
    t23 = -t22
    t24 = t19*t2
    t25 = t23 + t24
    t26 = t21 + t25
    t27 = t1*t19
    t28 = t27*vector1
    t29 = t18 + t18
    t30 = -t29 + t5
    t31 = t30*vector2
    t32 = t31*vector0
    t33 = -t8 + t32
    t34 = t21*vector0
    t35 = t31*vector1
    t36 = -t13 + t35
    t37 = t20*vector1*vector2
    t38 = t37 - t10
    t39 = t27*vector2
    t40 = t5*vector2
    t41 = t30*vector0*vector1
    t42 = t40 + t41
    t43 = t37 + t10
    t44 = t24*vector0
    t45 = t13 + t35
    t46 = t8 + t32
    t47 = t25 + t27
    t48 = t21*vector2
    t49 = -t40 + t41
    t50 = t24*vector1
    t51 = t21 + t23 + t27
    return (
        -t6 - t7,
        t9 + t11,
        -t12 + t14,
        t9 - t11,
        -t15 - t7,
        t16 + t17,
        t12 + t14,
        -t16 + t17,
        -t15 - t6 + 1,
        t20*t3,
        t26*vector1,
        t26*vector2,
        -t28 - t33,
        -t34 - t36,
        -t2*t30 - t38,
        -t39 + t42,
        t0*t30 - t43,
        -t44 + t45,
        -t28 + t46,
        -t34 + t45,
        t2*t30 - t43,
        t47*vector0,
        (t1 + t2)*t19*vector1,
        t47*vector2,
        -t1*t30 - t38,
        -t48 - t49,
        -t33 - t50,
        -t39 - t49,
        -t0*t30 - t38,
        -t36 - t44,
        t1*t30 - t43,
        t42 - t48,
        t46 - t50,
        t51*vector0,
        t51*vector1,
        (t0 + t1)*t19*vector2,
    )


def left_jacobian(vector):
    """left_jacobian: value."""
    vector0, vector1, vector2 = vector
    t0 = vector1*vector1
    t1 = vector0*vector0
    t2 = vector2*vector2
    t3 = t0 + t1 + t2
    t4 = stumpff(3, t3)
    t5 = t0*t4
    t6 = t2*t4 - 1
    t7 = t4*vector0
    t8 = t7*vector1
    t9 = stumpff(2, t3)
    t10 = t9*vector2
    t11 = t9*vector1
    t12 = t7*vector2
    t13 = t1*t4
    t14 = t9*vector0
    t15 = t4*vector1*vector2
    return (
        -t5 - t6,
        t8 - t10,
        t11 + t12,
        t8 + t10,
        -t13 - t6,
        -t14 + t15,
        -t11 + t12,
        t14 + t15,
        -t13 - t5 + 1,
    )


def left_jacobian_jac(vector):
    """left_jacobian: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector1*vector1
    t1 = vector0*vector0
    t2 = vector2*vector2
    t3 = t0 + t2
    t4 = t1 + t3
    t5 = stumpff(3, t4)
    t6 = t0*t5
    t7 = t2*t5 - 1
    t8 = t5*vector1
    t9 = t8*vector0
    t10 = stumpff(2, t4)
    t11 = t10*vector2
    t12 = t10*vector1
    t13 = t5*vector0
    t14 = t13*vector2
    t15 = t1*t5
    t16 = t10*vector0
    t17 = t8*vector2
    t18 = stumpff(4, t4)
    t19 = t18 - 3*stumpff(5, t4)
    t20 = t19*vector0
    t21 = t0*t19
    t22 = t5 + t5
    t23 = -t22
    t24 = t19*t2
    t25 = t23 + t24
    t26 = t21 + t25
    t27 = t1*t19
    t28 = t27*vector1
    t29 = t18 + t18
    t30 = -t29 + t5
    t31 = t30*vector2
    t32 = t31*vector0
    t33 = t8 + t32
    t34 = t21*vector0
    t35 = t31*vector1
    t36 = t13 + t35
    t37 = t20*vector1*vector2
    t38 = t37 + t10
    t39 = t27*vector2
    t40 = t5*vector2
    t41 = t30*vector0*vector1
    t42 = -t40 + t41
    t43 = t37 - t10
    t44 = t24*vector0
    t45 = -t13 + t35
    t46 = -t8 + t32
    t47 = t25 + t27
    t48 = t21*vector2
    t49 = t40 + t41
    t50 = t24*vector1
    t51 = t21 + t23 + t27
    return (
        -t6 - t7,
        t9 - t11,
        t12 + t14,
        t9 + t11,
        -t15 - t7,
        -t16 + t17,
        -t12 + t14,
        t16 + t17,
        -t15 - t6 + 1,
        t20*t3,
        t26*vector1,
        t26*vector2,
        -t28 + t33,
        -t34 + t36,
        t2*t30 - t38,
        -t39 - t42,
        -t0*t30 - t43,
        -t44 - t45,
        -t28 - t46,
        -t34 - t45,
        -t2*t30 - t43,
        t47*vector0,
        (t1 + t2)*t19*vector1,
        t47*vector2,
        t1*t30 - t38,
        -t48 + t49,
        t33 - t50,
        -t39 + t49,
        t0*t30 - t38,
        t36 - t44,
        -t1*t30 - t43,
        -t42 - t48,
        -t46 - t50,
        t51*vector0,
        t51*vector1,
        (t0 + t1)*t19*vector2,
    )


def left_inverse(vector):
    """left_inverse: value."""
    vector0, vector1, vector2 = vector
    t0 = vector1*vector1
    t1 = vector0*vector0
    t2 = vector2*vector2
    t3 = t0/4 + t1/4 + t2/4
    t4 = stumpff(1, t3)
    t5 = 1/t4
    t6 = (stumpff(2, t3) - stumpff(3, t3))*t5
    t7 = t0*t6
    t8 = t2*t6 - 4
    t9 = vector2 + vector2
    t10 = t6*vector0
    t11 = t10*vector1
    t12 = vector1 + vector1
    t13 = t10*vector2
    t14 = t1*t6
    t15 = vector0 + vector0
    t16 = t6*vector1*vector2
    return (
        (-t7)/4 + (-t8)/4,
        t9/4 + t11/4,
        (-t12)/4 + t13/4,
        (-t9)/4 + t11/4,
        (-t14)/4 + (-t8)/4,
        t15/4 + t16/4,
        t12/4 + t13/4,
        (-t15)/4 + t16/4,
        (-t14)/4 + (-t7)/4 + 1,
    )


def left_inverse_jac(vector):
    """left_inverse: value and Jacobians."""
    vector0, vector1, vector2 = vector
    t0 = vector2*vector2
    t1 = vector1*vector1
    t2 = vector0*vector0
    t3 = t1/4 + t2/4 + t0/4
    t4 = stumpff(1, t3)
    t5 = 1/t4
    t6 = stumpff(3, t3)
    t7 = -t6 + stumpff(2, t3)
    t8 = t5*t7
    t9 = t0*t8 - 4
    t10 = t1*t8
    t11 = vector2 + vector2
    t12 = t8*vector0
    t13 = t12*vector1
    t14 = vector1 + vector1
    t15 = t12*vector2
    t16 = t2*t8
    t17 = vector0 + vector0
    t18 = vector1*vector2
    t19 = t18*t8
    t20 = t6 - 3*stumpff(4, t3) + 3*stumpff(5, t3)
    t21 = t7*t7
    t22 = t21*t5
    t23 = -t1*t20 + t1*t22
    t24 = -t0*t20 + t0*t22
    t25 = t23 + t24
    t26 = t5/16
    t27 = t26*vector0
    t28 = 8*t7
    t29 = (t25 + t28)*t26
    t30 = 4*t7
    t31 = -t2*t20 + t2*t22
    t32 = (t30 + t31)*t26
    t33 = t32*vector1
    t34 = t23 + t30
    t35 = t27*t34
    t36 = t5*t5
    t37 = t18*t20*t27
    t38 = (t18*t21*t36*vector0)/16 - t37 + 1/2
    t39 = t32*vector2
    t40 = (t21*t36*vector0*vector1*vector2)/16 - t37 - 1/2
    t41 = t24 + t30
    t42 = t27*t41
    t43 = t24 + t31
    t44 = t28 + t43
    t45 = t26*vector1
    t46 = t26*vector2
    t47 = t34*t46
    t48 = t41*t45
    t49 = t23 + t31
    t50 = t28 + t49
    return (
        (-t9)/4 + (-t10)/4,
        t11/4 + t13/4,
        (-t14)/4 + t15/4,
        (-t11)/4 + t13/4,
        (-t9)/4 + (-t16)/4,
        t17/4 + t19/4,
        t14/4 + t15/4,
        (-t17)/4 + t19/4,
        (-t16)/4 + (-t10)/4 + 1,
        -t25*t27,
        -t29*vector1,
        -t29*vector2,
        t33,
        t35,
        t38,
        t39,
        t40,
        t42,
        t33,
        t35,
        t40,
        -t27*t44,
        -t43*t45,
        -t44*t46,
        t38,
        t47,
        t48,
        t39,
        t38,
        t42,
        t40,
        t47,
        t48,
        -t27*t50,
        -t45*t50,
        -t46*t49,
    )
