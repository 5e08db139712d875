"""Generated from slamlib/geometry/quaternion.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan_ratio, arctan_ratio_slope, sqrt, stumpff

DIGESTS = {
    "left_matrix": "dd3f666aaa06f22b",
    "right_matrix": "2aec087a6a78dab8",
    "pi_matrix": "e2f505da4bf9a9e0",
    "product": "ea0fec02de8acaca",
    "conjugate": "89e039bf6012dee4",
    "exponential": "732620e913df7791",
    "logarithm": "4b348faab3823bff",
    "plus": "dd4feaf308499935",
    "minus": "641ede26348279b8",
    "rotation": "592d683ef3963858",
    "from_rotation": "49ee384aa2ebcb08",
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
    t0 = (vector0*vector0 + vector1*vector1 + vector2*vector2)/4
    t1 = stumpff(1, t0)/2
    return (
        stumpff(0, t0),
        t1*vector0,
        t1*vector1,
        t1*vector2,
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
    t7 = -4*t4
    t8 = stumpff(2, t3) - stumpff(3, t3)
    t9 = (t8*vector0)/8
    t10 = -t9*vector1
    t11 = -t9*vector2
    t12 = (-t8*vector1*vector2)/8
    return (
        stumpff(0, t3),
        t5*vector0,
        t5*vector1,
        t5*vector2,
        -t6*vector0,
        -t6*vector1,
        -t6*vector2,
        (-t0*t8)/8 + (-t7)/8,
        t10,
        t11,
        t10,
        (-t1*t8)/8 + (-t7)/8,
        t12,
        t11,
        t12,
        (-t2*t8)/8 + (-t7)/8,
    )


def logarithm(q):
    """logarithm: value."""
    q0, q1, q2, q3 = q
    t0 = 2*arctan_ratio(q1*q1 + q2*q2 + q3*q3, q0)
    return (
        q1*t0,
        q2*t0,
        q3*t0,
    )


def logarithm_jac(q):
    """logarithm: value and Jacobians."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = q3*q3
    t3 = t0 + t1 + t2
    t4 = arctan_ratio(t3, q0)
    t5 = 2*t4
    t6 = 2/(q0*q0 + t3)
    t7 = arctan_ratio_slope(t3, q0)
    t8 = 2*t7
    t9 = 4*q1*t7
    t10 = q2*t9
    t11 = q3*t9
    t12 = 4*q2*q3*t7
    return (
        q1*t5,
        q2*t5,
        q3*t5,
        -q1*t6,
        2*t0*t8 + 2*t4,
        t10,
        t11,
        -q2*t6,
        t10,
        2*t1*t8 + 2*t4,
        t12,
        -q3*t6,
        t11,
        t12,
        2*t2*t8 + 2*t4,
    )


def plus(q, step):
    """plus: value."""
    q0, q1, q2, q3 = q
    step0, step1, step2 = step
    t0 = (step0*step0 + step1*step1 + step2*step2)/4
    t1 = stumpff(0, t0)
    t2 = stumpff(1, t0)/2
    t3 = step0*t2
    t4 = q2*t2
    t5 = q3*t2
    t6 = q0*t2
    t7 = q1*t2
    return (
        q0*t1 - q1*t3 - step1*t4 - step2*t5,
        q0*t3 + q1*t1 - step1*t5 + step2*t4,
        q2*t1 + q3*t3 + step1*t6 - step2*t7,
        -q2*t3 + q3*t1 + step1*t7 + step2*t6,
    )


def plus_jac(q, step):
    """plus: value and Jacobians."""
    q0, q1, q2, q3 = q
    step0, step1, step2 = step
    t0 = step0*step0
    t1 = step1*step1
    t2 = step2*step2
    t3 = t0/4 + t1/4 + t2/4
    t4 = stumpff(0, t3)
    t5 = stumpff(1, t3)
    t6 = t5/2
    t7 = step0*t6
    t8 = step1*t6
    t9 = step2*t6
    t10 = -t7
    t11 = -t8
    t12 = -t9
    t13 = 4*t5
    t14 = q1*t13
    t15 = -t14
    t16 = 2*t5
    t17 = q0*step0
    t18 = stumpff(2, t3) - stumpff(3, t3)
    t19 = step0*t18
    t20 = q2*step1
    t21 = q3*step2
    t22 = t19*t21
    t23 = t0*t18
    t24 = q2*t13
    t25 = -t24
    t26 = q0*t16
    t27 = q1*t19
    t28 = step1*t27
    t29 = step1*t18
    t30 = t1*t18
    t31 = q3*t13
    t32 = -t31
    t33 = step2*t18
    t34 = t20*t33
    t35 = t18*t2
    t36 = -4*q0*t5
    t37 = q1*t16
    t38 = q2*step2
    t39 = t19*t38
    t40 = q3*step1
    t41 = t19*t40
    t42 = t17*t29
    t43 = t17*t33
    t44 = step0*t16
    t45 = step2*t29
    t46 = q1*t45
    t47 = q0*t45
    return (
        q0*t4 - q1*t7 - q2*t8 - q3*t9,
        q0*t7 + q1*t4 + q2*t9 - q3*t8,
        q0*t8 - q1*t9 + q2*t4 + q3*t7,
        q0*t9 + q1*t8 - q2*t7 + q3*t4,
        t4,
        t10,
        t11,
        t12,
        t7,
        t4,
        t9,
        t11,
        t8,
        t12,
        t4,
        t7,
        t9,
        t8,
        t10,
        t4,
        (q1*t23)/8 + t15/8 + (-t16*t17)/8 + (t19*t20)/8 + t22/8,
        (q2*t30)/8 + (-step1*t26)/8 + (t21*t29)/8 + t25/8 + t28/8,
        (q3*t35)/8 + (-step2*t26)/8 + (step2*t27)/8 + t32/8 + t34/8,
        (-q0*t23)/8 + (-step0*t37)/8 + (-t36)/8 + (-t39)/8 + t41/8,
        (q3*t1*t18)/8 + (-step1*t37)/8 + (-t31)/8 + (-t34)/8 + (-t42)/8,
        (-q2*t35)/8 + (q3*step1*step2*t18)/8 + (-step2*t37)/8 + (-t25)/8 + (-t43)/8,
        (q1*step0*step2*t18)/8 + (-q2*t44)/8 + (-q3*t23)/8 + (-t32)/8 + (-t42)/8,
        (-q0*t30)/8 + (-t16*t20)/8 + (-t36)/8 + (-t41)/8 + t46/8,
        (q1*t18*t2)/8 + (-t14)/8 + (-t16*t38)/8 + (-t22)/8 + (-t47)/8,
        (q2*t0*t18)/8 + (-q3*t44)/8 + (-t24)/8 + (-t28)/8 + (-t43)/8,
        (-q1*t30)/8 + (q2*step0*step1*t18)/8 + (-t15)/8 + (-t16*t40)/8 + (-t47)/8,
        (-q0*t35)/8 + (-t16*t21)/8 + (-t36)/8 + t39/8 + (-t46)/8,
    )


def minus(q, origin):
    """minus: value."""
    q0, q1, q2, q3 = q
    origin0, origin1, origin2, origin3 = origin
    t0 = origin0*q1 - origin1*q0 - origin2*q3 + origin3*q2
    t1 = origin0*q2 + origin1*q3 - origin2*q0 - origin3*q1
    t2 = origin0*q3 - origin1*q2 + origin2*q1 - origin3*q0
    t3 = 2*arctan_ratio(t0*t0 + t1*t1 + t2*t2, origin0*q0 + origin1*q1 + origin2*q2 + origin3*q3)
    return (
        t0*t3,
        t1*t3,
        t2*t3,
    )


def minus_jac(q, origin):
    """minus: value and Jacobians."""
    q0, q1, q2, q3 = q
    origin0, origin1, origin2, origin3 = origin
    t0 = origin0*q1 - origin1*q0 - origin2*q3 + origin3*q2
    t1 = origin0*q2 + origin1*q3 - origin2*q0 - origin3*q1
    t2 = origin0*q3 - origin1*q2 + origin2*q1 - origin3*q0
    t3 = t0*t0 + t1*t1 + t2*t2
    t4 = origin0*q0 + origin1*q1 + origin2*q2 + origin3*q3
    t5 = arctan_ratio(t3, t4)
    t6 = 2*t5
    t7 = origin1*t5
    t8 = 1/(t3 + t4*t4)
    t9 = 2*arctan_ratio_slope(t3, t4)
    t10 = origin0*t8 + t9*(origin1*t0 + origin2*t1 + origin3*t2)
    t11 = origin0*t5
    t12 = origin1*t8 - t9*(origin0*t0 + origin2*t2 - origin3*t1)
    t13 = origin3*t5
    t14 = origin2*t8 - t9*(origin0*t1 - origin1*t2 + origin3*t0)
    t15 = origin2*t5
    t16 = origin3*t8 - t9*(origin0*t2 + origin1*t1 - origin2*t0)
    t17 = q1*t5
    t18 = q0*t8 - t9*(q1*t0 + q2*t1 + q3*t2)
    t19 = q0*t5
    t20 = q1*t8
    t21 = q0*t0 + q2*t2 - q3*t1
    t22 = t20 + t21*t9
    t23 = q3*t5
    t24 = q2*t8
    t25 = q0*t1 - q1*t2 + q3*t0
    t26 = t24 + t25*t9
    t27 = q2*t5
    t28 = q3*t8
    t29 = q0*t2 + q1*t1 - q2*t0
    t30 = t28 + t29*t9
    return (
        t0*t6,
        t1*t6,
        t2*t6,
        -2*t0*t10 - 2*t7,
        -2*t0*t12 + 2*t11,
        -2*t0*t14 + 2*t13,
        -2*t0*t16 - 2*t15,
        -2*t1*t10 - 2*t15,
        -2*t1*t12 - 2*t13,
        -2*t1*t14 + 2*t11,
        -2*t1*t16 + 2*t7,
        -2*t10*t2 - 2*t13,
        -2*t12*t2 + 2*t15,
        -2*t14*t2 - 2*t7,
        2*t11 - 2*t16*t2,
        -2*t0*t18 + 2*t17,
        -2*t0*t22 - 2*t19,
        -2*t0*t26 - 2*t23,
        -2*t0*(t28 + t29*t9) + 2*t27,
        -2*t1*t18 + 2*t27,
        -2*t1*(t20 + t21*t9) + 2*t23,
        -2*t1*t26 - 2*t19,
        -2*t1*t30 - 2*t17,
        -2*t18*t2 + 2*t23,
        -2*t2*t22 - 2*t27,
        2*t17 - 2*t2*(t24 + t25*t9),
        -2*t19 - 2*t2*t30,
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
    t7 = q0*q2
    t8 = -t0
    t9 = q0*q1
    return (
        t0 + t2 + t5,
        2*q1*q2 - 2*t6,
        2*q1*q3 + 2*t7,
        2*q1*q2 + 2*t6,
        t1 + t5 + t8,
        2*q2*q3 - 2*t9,
        2*q1*q3 - 2*t7,
        2*q2*q3 + 2*t9,
        t2 + t3 + t4 + t8,
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
    t8 = -q1*q2 + t7
    t9 = -2*t8
    t10 = q0*q2
    t11 = 2*q1*q3 + 2*t10
    t12 = 2*q1*q2 + 2*t7
    t13 = -t0
    t14 = t1 + t13 + t5
    t15 = q0*q1
    t16 = -q2*q3 + t15
    t17 = -2*t16
    t18 = -q1*q3 + t10
    t19 = -2*t18
    t20 = 2*q2*q3 + 2*t15
    t21 = t13 + t2 + t3 + t4
    return (
        t6,
        t9,
        t11,
        t12,
        t14,
        t17,
        t19,
        t20,
        t21,
        0,
        -t11,
        t9,
        t11,
        0,
        -t6,
        2*t8,
        t6,
        0,
        0,
        2*t16,
        t14,
        t17,
        0,
        -t12,
        -t14,
        t12,
        0,
        0,
        -t21,
        t20,
        t21,
        0,
        2*t18,
        -t20,
        t19,
        0,
    )


def rotation_storage_jac(q):
    """rotation: value and derivatives by stored numbers."""
    q0, q1, q2, q3 = q
    t0 = q1*q1
    t1 = q2*q2
    t2 = -t1
    t3 = q0*q0
    t4 = q3*q3
    t5 = t3 - t4
    t6 = q0*q3
    t7 = q0*q2
    t8 = -t0
    t9 = q0*q1
    t10 = 2*q0
    t11 = 2*q1
    t12 = 2*q2
    t13 = -t12
    t14 = 2*q3
    t15 = -t14
    t16 = -t10
    t17 = -t11
    return (
        t0 + t2 + t5,
        2*q1*q2 - 2*t6,
        2*q1*q3 + 2*t7,
        2*q1*q2 + 2*t6,
        t1 + t5 + t8,
        2*q2*q3 - 2*t9,
        2*q1*q3 - 2*t7,
        2*q2*q3 + 2*t9,
        t2 + t3 + t4 + t8,
        t10,
        t11,
        t13,
        t15,
        t15,
        t12,
        t11,
        t16,
        t12,
        t14,
        t10,
        t11,
        t14,
        t12,
        t11,
        t10,
        t10,
        t17,
        t12,
        t15,
        t17,
        t16,
        t14,
        t12,
        t13,
        t14,
        t16,
        t11,
        t11,
        t10,
        t14,
        t12,
        t10,
        t17,
        t13,
        t14,
    )


def from_rotation(matrix, pivot):
    """from_rotation: value."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, matrix7, matrix8 = matrix
    pivot0, pivot1, pivot2, pivot3 = pivot
    t0 = matrix0 + 1
    t1 = matrix2 - matrix6
    t2 = matrix5 - matrix7
    t3 = matrix1 - matrix3
    t4 = pivot0*(matrix4 + matrix8 + t0) - pivot1*t2 + pivot2*t1 - pivot3*t3
    t5 = matrix1 + matrix3
    t6 = matrix5 + matrix7
    t7 = -matrix4
    t8 = matrix0 - 1
    t9 = pivot0*t1 + pivot1*t5 - pivot2*(matrix8 + t7 + t8) + pivot3*t6
    t10 = matrix2 + matrix6
    t11 = -matrix8
    t12 = -pivot0*t2 + pivot1*(t0 + t11 + t7) + pivot2*t5 + pivot3*t10
    t13 = pivot0*t3 - pivot1*t10 - pivot2*t6 + pivot3*(matrix4 + t11 + t8)
    t14 = 1/(sqrt(pivot0*t4 + pivot1*t12 + pivot2*t9 - pivot3*t13))/2
    return (
        t14*t4,
        t12*t14,
        t14*t9,
        -t13*t14,
    )


def from_rotation_jac(matrix, pivot):
    """from_rotation: value and Jacobians."""
    matrix0, matrix1, matrix2, matrix3, matrix4, matrix5, matrix6, matrix7, matrix8 = matrix
    pivot0, pivot1, pivot2, pivot3 = pivot
    t0 = matrix5 - matrix7
    t1 = matrix1 - matrix3
    t2 = matrix0 + 1
    t3 = matrix4 + matrix8
    t4 = t2 + t3
    t5 = matrix2 - matrix6
    t6 = pivot0*t4 + pivot2*t5
    t7 = -pivot1*t0 - pivot3*t1 + t6
    t8 = matrix2 + matrix6
    t9 = pivot1*t8
    t10 = matrix5 + matrix7
    t11 = pivot2*t10
    t12 = -matrix8
    t13 = matrix0 - 1
    t14 = matrix4 + t12 + t13
    t15 = pivot0*t1 + pivot3*t14 - t11 - t9
    t16 = -matrix4
    t17 = matrix1 + matrix3
    t18 = pivot1*(t12 + t16 + t2) + pivot2*t17 + pivot3*t8
    t19 = -pivot0*t0 + t18
    t20 = matrix8 + t13 + t16
    t21 = pivot0*t5 + pivot1*t17 + pivot3*t10
    t22 = -pivot2*t20 + t21
    t23 = pivot0*t7 + pivot1*t19 + pivot2*t22
    t24 = -pivot3*t15 + t23
    t25 = 1/(sqrt(t24))
    t26 = t25/2
    t27 = 2*pivot0
    t28 = pivot1*pivot1
    t29 = pivot2*pivot2
    t30 = -t29
    t31 = pivot0*pivot0
    t32 = pivot3*pivot3
    t33 = t31 - t32
    t34 = t28 + t30 + t33
    t35 = 1/(t24)
    t36 = t35*t7
    t37 = t25/4
    t38 = pivot0*pivot3
    t39 = pivot1*pivot2
    t40 = t38 - t39
    t41 = -t15
    t42 = pivot3*t41 + t23
    t43 = 1/(t42)
    t44 = 1/(sqrt(t42))
    t45 = t44/2
    t46 = pivot0*pivot2
    t47 = pivot1*pivot3
    t48 = t46 + t47
    t49 = t38 + t39
    t50 = -t28
    t51 = t29 + t33 + t50
    t52 = pivot0*pivot1
    t53 = pivot2*pivot3
    t54 = t52 - t53
    t55 = t46 - t47
    t56 = t52 + t53
    t57 = t30 + t31 + t32 + t50
    t58 = 2*pivot1
    t59 = t19*t35
    t60 = t19*t43
    t61 = t44/4
    t62 = 2*pivot2
    t63 = t22*t43
    t64 = t22*t35
    t65 = 2*pivot3
    t66 = t41*t43
    t67 = t15*t35
    t68 = -t0
    t69 = t43*t7
    t70 = t26*(matrix2 - matrix6 - t22*t36)
    t71 = -t1
    t72 = pivot0*t71 - pivot3*t14 + t11 + t9
    t73 = pivot1*t68 + pivot3*t71 + t6
    t74 = t26*(t17 - t22*t59)
    return (
        t26*t7,
        t19*t26,
        t22*t26,
        -t15*t26,
        t37*(t27 - t34*t36),
        t45*(-pivot3 + t40*t43*t7),
        t26*(pivot2 - t36*t48),
        t26*(pivot3 - t36*t49),
        t37*(t27 - t36*t51),
        t45*(-pivot1 + t43*t54*t7),
        t45*(-pivot2 + t43*t55*t7),
        t26*(pivot1 - t36*t56),
        t37*(t27 - t36*t57),
        t37*(-t34*t59 + t58),
        t26*(pivot2 + t40*t59),
        t26*(pivot3 - t48*t59),
        t26*(pivot2 - t49*t59),
        -t61*(t51*t60 + t58),
        t45*(-pivot0 + t19*t43*t54),
        t26*(pivot3 + t55*t59),
        t26*(pivot0 - t56*t59),
        -t61*(t57*t60 + t58),
        -t61*(t34*t63 + t62),
        t26*(pivot1 + t40*t64),
        t26*(pivot0 - t48*t64),
        t26*(pivot1 - t49*t64),
        t37*(-t51*t64 + t62),
        t26*(pivot3 + t54*t64),
        t45*(-pivot0 + t22*t43*t55),
        t26*(pivot3 - t56*t64),
        -t61*(t57*t63 + t62),
        -t61*(t34*t66 + t65),
        t45*(-pivot0 + t40*t41*t43),
        t26*(pivot1 + t48*t67),
        t26*(pivot0 + t49*t67),
        -t61*(t51*t66 + t65),
        t26*(pivot2 - t54*t67),
        t26*(pivot1 - t55*t67),
        t26*(pivot2 + t56*t67),
        t37*(t57*t67 + t65),
        t26*(-t35*t7*t7 + t4),
        -t45*(t0 + t69*(pivot0*t68 + t18)),
        t70,
        -t45*(t1 + t69*t72),
        -t45*(t0 + t60*t73),
        t26*(matrix0 - t19*t19*t35 - t3 + 1),
        t74,
        t26*(-t41*t59 + t8),
        t70,
        t74,
        -t45*(t20 + t63*(-pivot2*t20 + t21)),
        t26*(t10 - t41*t64),
        -t45*(t1 + t66*t73),
        t26*(t15*t59 + t8),
        t26*(t10 + t15*t64),
        -t45*(t14 + t66*t72),
    )
