"""Generated from slamlib/sensors/pinhole.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "distort": "53d935fddfe311db",
    "pixel": "251ce0aaada256f4",
    "project": "c77eb70882005483",
    "ray": "afd8574437e322bb",
    "project_line": "5db0ed55d8de5387",
}
SHAPES = {
    "distort": (2,),
    "pixel": (2,),
    "project": (2,),
    "ray": (4,),
    "project_line": (3,),
}


def distort(ideal, distortion):
    """distort: value."""
    ideal0, ideal1 = ideal
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t2)*t2)*t2)*t2)*t2)*t2)*t2)*t2 + 1
    return (
        ideal0*t3,
        ideal1*t3,
    )


def distort_jac(ideal, distortion):
    """distort: value and Jacobians."""
    ideal0, ideal1 = ideal
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion7*t2
    t4 = distortion5 + (distortion6 + t3)*t2
    t5 = distortion4 + t2*t4
    t6 = distortion3 + t2*t5
    t7 = distortion2 + t2*t6
    t8 = distortion1 + t2*t7
    t9 = distortion0 + t2*t8
    t10 = t2*t9 + 1
    t11 = t9 + t9
    t12 = t3 + t3
    t13 = ((((((distortion6 + t12)*t2 + t4)*t2 + t5)*t2 + t6)*t2 + t7)*t2 + t8)*t2
    t14 = t13 + t13
    t15 = (t13 + t9)
    t16 = t15 + t15
    t17 = t16*ideal0*ideal1
    t18 = t2*t2
    t19 = t18*t2
    t20 = t18*t18
    t21 = t19*t18
    t22 = t19*t19
    t23 = t20*t19
    t24 = t20*t20
    return (
        ideal0*t10,
        ideal1*t10,
        t0*t11 + t0*t14 + t10,
        t17,
        t17,
        t1*t11 + t1*t14 + t10,
        ideal0*t2,
        ideal0*t18,
        ideal0*t19,
        ideal0*t20,
        ideal0*t21,
        ideal0*t22,
        ideal0*t23,
        ideal0*t24,
        ideal1*t2,
        ideal1*t18,
        ideal1*t19,
        ideal1*t20,
        ideal1*t21,
        ideal1*t22,
        ideal1*t23,
        ideal1*t24,
    )


def pixel(ideal, intrinsics, distortion):
    """pixel: value."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t2)*t2)*t2)*t2)*t2)*t2)*t2)*t2 + 1
    return (
        ideal0*intrinsics2*t3 + intrinsics0,
        ideal1*intrinsics3*t3 + intrinsics1,
    )


def pixel_jac(ideal, intrinsics, distortion):
    """pixel: value and Jacobians."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion7*t2
    t4 = distortion5 + (distortion6 + t3)*t2
    t5 = distortion4 + t2*t4
    t6 = distortion3 + t2*t5
    t7 = distortion2 + t2*t6
    t8 = distortion1 + t2*t7
    t9 = distortion0 + t2*t8
    t10 = t2*t9 + 1
    t11 = ideal0*t10
    t12 = ideal1*t10
    t13 = t9 + t9
    t14 = t3 + t3
    t15 = ((((((distortion6 + t14)*t2 + t4)*t2 + t5)*t2 + t6)*t2 + t7)*t2 + t8)*t2
    t16 = t15 + t15
    t17 = ideal0*intrinsics2
    t18 = t16 + t13
    t19 = ideal1*intrinsics3
    t20 = t2*t2
    t21 = t20*t2
    t22 = t20*t20
    t23 = t21*t20
    t24 = t21*t21
    t25 = t22*t21
    t26 = t22*t22
    return (
        intrinsics0 + intrinsics2*t11,
        intrinsics1 + intrinsics3*t12,
        (t0*t13 + t0*t16 + t10)*intrinsics2,
        ideal1*t17*t18,
        ideal0*t18*t19,
        (t1*t13 + t1*t16 + t10)*intrinsics3,
        1,
        0,
        t11,
        0,
        0,
        1,
        0,
        t12,
        t17*t2,
        t17*t20,
        t17*t21,
        t17*t22,
        t17*t23,
        t17*t24,
        t17*t25,
        t17*t26,
        t19*t2,
        t19*t20,
        t19*t21,
        t19*t22,
        t19*t23,
        t19*t24,
        t19*t25,
        t19*t26,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = (distortion0 + (distortion1 + (distortion2 + (distortion3 + (distortion4 + (distortion5 + (distortion6 + distortion7*t3)*t3)*t3)*t3)*t3)*t3)*t3)*t3 + 1
    return (
        ideal0*intrinsics2*t4 + intrinsics0,
        ideal1*intrinsics3*t4 + intrinsics1,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/point2
    ideal0 = point0*t0
    t1 = ideal0*ideal0
    ideal1 = point1*t0
    t2 = ideal1*ideal1
    t3 = t1 + t2
    t4 = distortion7*t3
    t5 = distortion5 + (distortion6 + t4)*t3
    t6 = distortion4 + t3*t5
    t7 = distortion3 + t3*t6
    t8 = distortion2 + t3*t7
    t9 = distortion1 + t3*t8
    t10 = distortion0 + t3*t9
    t11 = t10*t3 + 1
    t12 = ideal0*t11
    t13 = ideal1*t11
    t14 = t10 + t10
    t15 = t4 + t4
    t16 = ((((((distortion6 + t15)*t3 + t5)*t3 + t6)*t3 + t7)*t3 + t8)*t3 + t9)*t3
    t17 = t16 + t16
    t18 = t1*t14 + t1*t17 + t11
    t19 = intrinsics2*t0
    t20 = (t10 + t16)
    t21 = t20 + t20
    t22 = t21*ideal0*ideal1
    t23 = t0*t0
    t24 = intrinsics3*t0
    t25 = t11 + t14*t2 + t17*t2
    t26 = ideal0*intrinsics2
    t27 = t3*t3
    t28 = t27*t3
    t29 = t27*t27
    t30 = t28*t27
    t31 = t28*t28
    t32 = t29*t28
    t33 = t29*t29
    t34 = ideal1*intrinsics3
    return (
        intrinsics0 + intrinsics2*t12,
        intrinsics1 + intrinsics3*t13,
        t18*t19,
        t19*t22,
        -(point0*t18 + point1*t22)*intrinsics2*t23,
        0,
        t22*t24,
        t24*t25,
        -(point0*t22 + point1*t25)*intrinsics3*t23,
        0,
        1,
        0,
        t12,
        0,
        0,
        1,
        0,
        t13,
        t26*t3,
        t26*t27,
        t26*t28,
        t26*t29,
        t26*t30,
        t26*t31,
        t26*t32,
        t26*t33,
        t3*t34,
        t27*t34,
        t28*t34,
        t29*t34,
        t30*t34,
        t31*t34,
        t32*t34,
        t33*t34,
    )


def ray(ideal, unmeasured):
    """ray: value."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/t2
    t4 = sqrt(t3)
    return (
        ideal0*t4,
        ideal1*t4,
        t4,
        unmeasured,
    )


def ray_jac(ideal, unmeasured):
    """ray: value and Jacobians."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/t2
    t4 = sqrt(t3)
    t5 = t3*t4
    t6 = ideal0*t5
    t7 = -ideal1*t6
    return (
        ideal0*t4,
        ideal1*t4,
        t4,
        unmeasured,
        -(t0*t3 - 1)*t4,
        t7,
        t7,
        -(t1*t3 - 1)*t4,
        -t6,
        -ideal1*t5,
        0,
        0,
        0,
        0,
        0,
        1,
    )


def project_line(line, intrinsics):
    """project_line: value."""
    line0, line1, line2, _, _, _ = line
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    t0 = intrinsics3*line0
    t1 = intrinsics2*line1
    return (
        t0,
        t1,
        -intrinsics0*t0 - intrinsics1*t1 + intrinsics2*intrinsics3*line2,
    )


def project_line_jac(line, intrinsics):
    """project_line: value and Jacobians."""
    line0, line1, line2, _, _, _ = line
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    t0 = intrinsics3*line0
    t1 = intrinsics2*line1
    t2 = intrinsics2*intrinsics3
    return (
        t0,
        t1,
        -intrinsics0*t0 - intrinsics1*t1 + line2*t2,
        intrinsics3,
        0,
        0,
        0,
        0,
        0,
        0,
        intrinsics2,
        0,
        0,
        0,
        0,
        -intrinsics0*intrinsics3,
        -intrinsics1*intrinsics2,
        t2,
        0,
        0,
        0,
        0,
        0,
        0,
        line0,
        0,
        0,
        line1,
        0,
        -t0,
        -t1,
        -intrinsics1*line1 + intrinsics3*line2,
        -intrinsics0*line0 + intrinsics2*line2,
    )
