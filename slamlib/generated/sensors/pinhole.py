"""Generated from slamlib/sensors/pinhole.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import sqrt

DIGESTS = {
    "distort": "38d3fc241b551b7a",
    "pixel": "959bffb06fac57e4",
    "project": "077403c2ac5013e1",
    "ray": "1208cdf6eb284281",
    "project_line": "ccec8efde220f3c3",
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
    t0 = ideal0*ideal0 + ideal1*ideal1
    t1 = t0*(distortion0 + t0*(distortion1 + t0*(distortion2 + t0*(distortion3 + t0*(distortion4 + t0*(distortion5 + t0*(distortion6 + distortion7*t0))))))) + 1
    return (
        ideal0*t1,
        ideal1*t1,
    )


def distort_jac(ideal, distortion):
    """distort: value and Jacobians."""
    ideal0, ideal1 = ideal
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1
    t3 = distortion7*t2
    t4 = distortion5 + t2*(distortion6 + t3)
    t5 = distortion4 + t2*t4
    t6 = distortion3 + t2*t5
    t7 = distortion2 + t2*t6
    t8 = distortion1 + t2*t7
    t9 = distortion0 + t2*t8
    t10 = t2*t9 + 1
    t11 = 2*t9
    t12 = t2*(t2*(t2*(t2*(t2*(t2*(distortion6 + 2*t3) + t4) + t5) + t6) + t7) + t8)
    t13 = 2*t12
    t14 = 2*ideal0*ideal1*(t12 + t9)
    t15 = t2*t2
    t16 = t2*t2*t2
    t17 = t2*t2*t2*t2
    t18 = t2*t2*t2*t2*t2
    t19 = t2*t2*t2*t2*t2*t2
    t20 = t2*t2*t2*t2*t2*t2*t2
    t21 = t2*t2*t2*t2*t2*t2*t2*t2
    return (
        ideal0*t10,
        ideal1*t10,
        t0*t11 + t0*t13 + t10,
        t14,
        t14,
        t1*t11 + t1*t13 + t10,
        ideal0*t2,
        ideal0*t15,
        ideal0*t16,
        ideal0*t17,
        ideal0*t18,
        ideal0*t19,
        ideal0*t20,
        ideal0*t21,
        ideal1*t2,
        ideal1*t15,
        ideal1*t16,
        ideal1*t17,
        ideal1*t18,
        ideal1*t19,
        ideal1*t20,
        ideal1*t21,
    )


def pixel(ideal, intrinsics, distortion):
    """pixel: value."""
    ideal0, ideal1 = ideal
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = ideal0*ideal0 + ideal1*ideal1
    t1 = t0*(distortion0 + t0*(distortion1 + t0*(distortion2 + t0*(distortion3 + t0*(distortion4 + t0*(distortion5 + t0*(distortion6 + distortion7*t0))))))) + 1
    return (
        ideal0*intrinsics2*t1 + intrinsics0,
        ideal1*intrinsics3*t1 + intrinsics1,
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
    t4 = distortion5 + t2*(distortion6 + t3)
    t5 = distortion4 + t2*t4
    t6 = distortion3 + t2*t5
    t7 = distortion2 + t2*t6
    t8 = distortion1 + t2*t7
    t9 = distortion0 + t2*t8
    t10 = t2*t9 + 1
    t11 = ideal0*t10
    t12 = ideal1*t10
    t13 = 2*t9
    t14 = t2*(t2*(t2*(t2*(t2*(t2*(distortion6 + 2*t3) + t4) + t5) + t6) + t7) + t8)
    t15 = 2*t14
    t16 = ideal0*intrinsics2
    t17 = 2*t14 + 2*t9
    t18 = ideal1*intrinsics3
    t19 = t2*t2
    t20 = t2*t2*t2
    t21 = t2*t2*t2*t2
    t22 = t2*t2*t2*t2*t2
    t23 = t2*t2*t2*t2*t2*t2
    t24 = t2*t2*t2*t2*t2*t2*t2
    t25 = t2*t2*t2*t2*t2*t2*t2*t2
    return (
        intrinsics0 + intrinsics2*t11,
        intrinsics1 + intrinsics3*t12,
        intrinsics2*(t0*t13 + t0*t15 + t10),
        ideal1*t16*t17,
        ideal0*t17*t18,
        intrinsics3*(t1*t13 + t1*t15 + t10),
        1,
        0,
        t11,
        0,
        0,
        1,
        0,
        t12,
        t16*t2,
        t16*t19,
        t16*t20,
        t16*t21,
        t16*t22,
        t16*t23,
        t16*t24,
        t16*t25,
        t18*t2,
        t18*t19,
        t18*t20,
        t18*t21,
        t18*t22,
        t18*t23,
        t18*t24,
        t18*t25,
    )


def project(point, intrinsics, distortion):
    """project: value."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = (point0*point0 + point1*point1)/(point2*point2)
    t1 = (t0*(distortion0 + t0*(distortion1 + t0*(distortion2 + t0*(distortion3 + t0*(distortion4 + t0*(distortion5 + t0*(distortion6 + distortion7*t0))))))) + 1)/point2
    return (
        intrinsics0 + intrinsics2*point0*t1,
        intrinsics1 + intrinsics3*point1*t1,
    )


def project_jac(point, intrinsics, distortion):
    """project: value and Jacobians."""
    point0, point1, point2, _ = point
    intrinsics0, intrinsics1, intrinsics2, intrinsics3 = intrinsics
    distortion0, distortion1, distortion2, distortion3, distortion4, distortion5, distortion6, distortion7 = distortion
    t0 = 1/(point2*point2)
    t1 = point0*point0
    t2 = point1*point1
    t3 = t1 + t2
    t4 = t0*t3
    t5 = distortion7*t4
    t6 = distortion5 + t4*(distortion6 + t5)
    t7 = distortion4 + t4*t6
    t8 = distortion3 + t4*t7
    t9 = distortion2 + t4*t8
    t10 = distortion1 + t4*t9
    t11 = distortion0 + t10*t4
    t12 = t11*t4
    t13 = t12 + 1
    t14 = 1/(point2)
    t15 = intrinsics2*t14
    t16 = intrinsics3*t14
    t17 = 2*t1
    t18 = t0*t11
    t19 = t10 + t4*(t4*(t4*(t4*(t4*(distortion6 + 2*t5) + t6) + t7) + t8) + t9)
    t20 = t19/(point2*point2*point2*point2)
    t21 = intrinsics2*point0
    t22 = 1/(point2*point2*point2)
    t23 = 2*t22*(t11 + t19*t4)
    t24 = t3*t3
    t25 = 2*t20
    t26 = t0*(3*t12 + t24*t25 + 1)
    t27 = intrinsics3*point1
    t28 = t13*t14
    t29 = t22*t3
    t30 = t24/(point2*point2*point2*point2*point2)
    t31 = t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2)
    t32 = t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t33 = t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t34 = t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t35 = t3*t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    t36 = t3*t3*t3*t3*t3*t3*t3*t3/(point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2*point2)
    return (
        intrinsics0 + point0*t13*t15,
        intrinsics1 + point1*t13*t16,
        t15*(t13 + t17*t18 + t17*t20*t3),
        point1*t21*t23,
        -t21*t26,
        0,
        point0*t23*t27,
        t16*(t13 + 2*t18*t2 + t2*t25*t3),
        -t26*t27,
        0,
        1,
        0,
        point0*t28,
        0,
        0,
        1,
        0,
        point1*t28,
        t21*t29,
        t21*t30,
        t21*t31,
        t21*t32,
        t21*t33,
        t21*t34,
        t21*t35,
        t21*t36,
        t27*t29,
        t27*t30,
        t27*t31,
        t27*t32,
        t27*t33,
        t27*t34,
        t27*t35,
        t27*t36,
    )


def ray(ideal, unmeasured):
    """ray: value."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    t0 = 1/(sqrt(ideal0*ideal0 + ideal1*ideal1 + 1))
    return (
        ideal0*t0,
        ideal1*t0,
        t0,
        unmeasured,
    )


def ray_jac(ideal, unmeasured):
    """ray: value and Jacobians."""
    ideal0, ideal1 = ideal
    unmeasured, = unmeasured
    t0 = ideal0*ideal0
    t1 = ideal1*ideal1
    t2 = t0 + t1 + 1
    t3 = 1/(sqrt(t2))
    t4 = 1/(t2)
    t5 = 1/(t2*sqrt(t2))
    t6 = ideal0*t5
    t7 = -ideal1*t6
    return (
        ideal0*t3,
        ideal1*t3,
        t3,
        unmeasured,
        t3*(-t0*t4 + 1),
        t7,
        t7,
        t3*(-t1*t4 + 1),
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
    return (
        t0,
        t1,
        -intrinsics0*t0 - intrinsics1*t1 + intrinsics2*intrinsics3*line2,
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
        intrinsics2*intrinsics3,
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
