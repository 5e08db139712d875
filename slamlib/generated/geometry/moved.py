"""Generated from slamlib/geometry/moved.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "vector": "3ac73053e05d3a21",
    "number": "77bc28656433d69d",
}
SHAPES = {
    "vector": (3,),
    "number": (1,),
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
