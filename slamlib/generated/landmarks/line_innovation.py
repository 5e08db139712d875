"""Generated from slamlib/landmarks/line_innovation.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, sqrt

DIGESTS = {
    "image_line": "ffd938729e5c0434",
    "distances": "9f82543dbf88e73f",
    "rho_theta": "95c268f965166494",
    "angles": "86d383d6177b58cf",
}
SHAPES = {
    "image_line": (3,),
    "distances": (2,),
    "rho_theta": (2,),
    "angles": (2,),
}


def image_line(segment):
    """image_line: value."""
    segment0, segment1, segment2, segment3 = segment
    return (
        segment1 - segment3,
        -segment0 + segment2,
        segment0*segment3 - segment1*segment2,
    )


def image_line_jac(segment):
    """image_line: value and Jacobians."""
    segment0, segment1, segment2, segment3 = segment
    t0 = -segment2
    return (
        segment1 - segment3,
        -segment0 - t0,
        segment0*segment3 - segment1*segment2,
        0,
        1,
        0,
        -1,
        -1,
        0,
        1,
        0,
        segment3,
        t0,
        -segment1,
        segment0,
    )


def distances(line, segment):
    """distances: value."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    t0 = 1/(sqrt(line0*line0 + line1*line1))
    return (
        t0*(line0*segment0 + line1*segment1 + line2),
        t0*(line0*segment2 + line1*segment3 + line2),
    )


def distances_jac(line, segment):
    """distances: value and Jacobians."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    t0 = line0*segment0 + line1*segment1 + line2
    t1 = line0*line0 + line1*line1
    t2 = 1/(sqrt(t1))
    t3 = line0*segment2 + line1*segment3 + line2
    t4 = 1/(t1)
    t5 = t0*t4
    t6 = t3*t4
    t7 = line0*t2
    t8 = line1*t2
    return (
        t0*t2,
        t2*t3,
        t2*(-line0*t5 + segment0),
        t2*(-line1*t5 + segment1),
        t2,
        t2*(-line0*t6 + segment2),
        t2*(-line1*t6 + segment3),
        t2,
        t7,
        t8,
        0,
        0,
        0,
        0,
        t7,
        t8,
    )


def rho_theta(line, segment, origin):
    """rho_theta: value."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    origin0, origin1 = origin
    t0 = 1/(sqrt(line0*line0 + line1*line1))
    t1 = segment0 - segment2
    t2 = segment1 - segment3
    t3 = 1/(sqrt(t1*t1 + t2*t2))
    t4 = t0*t3
    return (
        line0*origin0*t0 + line1*origin1*t0 + line2*t0 - origin0*t2*t3 + origin1*t1*t3 - t3*(segment0*segment3 - segment1*segment2),
        arctan2(-t4*(line0*t1 + line1*t2), t4*(line0*t2 - line1*t1)),
    )


def rho_theta_jac(line, segment, origin):
    """rho_theta: value and Jacobians."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    origin0, origin1 = origin
    t0 = line0*line0
    t1 = line1*line1
    t2 = t0 + t1
    t3 = 1/(sqrt(t2))
    t4 = line0*t3
    t5 = line1*t3
    t6 = segment0 - segment2
    t7 = t6*t6
    t8 = -segment3
    t9 = segment1 + t8
    t10 = t9*t9
    t11 = t10 + t7
    t12 = sqrt(t11)
    t13 = 1/(t12)
    t14 = t13*t6
    t15 = t13*t9
    t16 = segment0*segment3 - segment1*segment2
    t17 = line0*t6
    t18 = line1*t9
    t19 = t17 + t18
    t20 = t13*t3
    t21 = line0*t9 - line1*t6
    t22 = -origin0
    t23 = 1/(t2)
    t24 = line2*t23
    t25 = line0*t23
    t26 = line1*t25
    t27 = t0*t23
    t28 = t1*t23
    t29 = 1/(t19*t19 + t21*t21)
    t30 = line1*t17*t23
    t31 = -segment1
    t32 = segment3 + t31
    t33 = t18*t25
    t34 = 1/(t11)
    t35 = t16*t34
    t36 = t34*t7
    t37 = t34*t9
    t38 = t37*t6
    t39 = origin0*t38 - origin1*t36 + origin1 + t35*t6
    t40 = t10*t34
    t41 = origin0*t40 - origin1*t38 + t22 + t35*t9
    t42 = -t6
    t43 = t42*t42
    t44 = t10 + t43
    t45 = 1/(t44)
    t46 = t18*t45
    t47 = line0*t42
    t48 = -t18 + t47
    t49 = t17*t37
    t50 = -line1*t34*t7 + line1 + t49
    t51 = t12/sqrt(t44)
    t52 = t29*t51
    t53 = t18*t34*t6
    t54 = -line0*t40 + line0 + t53
    t55 = -t9
    t56 = t48*t51
    return (
        line2*t3 - origin0*t15 + origin0*t4 + origin1*t14 + origin1*t5 - t13*t16,
        arctan2(-t19*t20, t20*t21),
        t3*(-line0*t24 - origin0*t27 - origin1*t26 - t22),
        t3*(-line1*t24 - origin0*t26 - origin1*t28 + origin1),
        t3,
        t29*(-t19*(t27*t9 - t30 + t32) + t21*(-segment0 + segment2 + t27*t6 + t33)),
        -t29*(t19*(-t28*t6 + t33 + t6) + t21*(-t28*t9 - t30 - t32)),
        0,
        t13*(t39 + t8),
        t13*(segment2 + t41),
        t13*(-t31 - t39),
        t13*(-segment0 - t41),
        -t52*(t21*(-line0*t43*t45 + line0 + t42*t46) - t48*t50),
        -t52*(t21*(line1 - t45*t47*t55 + t46*t55) + t48*t54),
        t29*(t21*(-line0*t36 + line0 - t53) - t50*t56),
        t29*(t21*(-line1*t40 + line1 - t49) + t54*t56),
        -t15 + t4,
        t14 + t5,
        0,
        0,
    )


def angles(line, rays):
    """angles: value."""
    line0, line1, line2, _, _, _ = line
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    t0 = 1/(sqrt(line0*line0 + line1*line1 + line2*line2))
    return (
        t0*(line0*rays0 + line1*rays1 + line2*rays2),
        t0*(line0*rays3 + line1*rays4 + line2*rays5),
    )


def angles_jac(line, rays):
    """angles: value and Jacobians."""
    line0, line1, line2, _, _, _ = line
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    t0 = line0*rays0 + line1*rays1 + line2*rays2
    t1 = line0*line0 + line1*line1 + line2*line2
    t2 = 1/(sqrt(t1))
    t3 = line0*rays3 + line1*rays4 + line2*rays5
    t4 = 1/(t1)
    t5 = t0*t4
    t6 = t3*t4
    t7 = line0*t2
    t8 = line1*t2
    t9 = line2*t2
    return (
        t0*t2,
        t2*t3,
        t2*(-line0*t5 + rays0),
        t2*(-line1*t5 + rays1),
        t2*(-line2*t5 + rays2),
        0,
        0,
        0,
        t2*(-line0*t6 + rays3),
        t2*(-line1*t6 + rays4),
        t2*(-line2*t6 + rays5),
        0,
        0,
        0,
        t7,
        t8,
        t9,
        0,
        0,
        0,
        0,
        0,
        0,
        t7,
        t8,
        t9,
    )
