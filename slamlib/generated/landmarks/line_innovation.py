"""Generated from slamlib/landmarks/line_innovation.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, sqrt

DIGESTS = {
    "image_line": "ffd938729e5c0434",
    "distances": "bedaf25216dea759",
    "rho_theta": "95c268f965166494",
    "angles": "9a227a23910d2b3e",
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
    t0 = line0*line0
    t1 = line1*line1
    t2 = t0 + t1
    t3 = 1/t2
    t4 = sqrt(t3)
    return (
        (line0*segment0 + line1*segment1 + line2)*t4,
        (line0*segment2 + line1*segment3 + line2)*t4,
    )


def distances_jac(line, segment):
    """distances: value and Jacobians."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    t0 = line0*segment0 + line1*segment1 + line2
    t1 = line0*line0
    t2 = line1*line1
    t3 = t1 + t2
    t4 = 1/t3
    t5 = sqrt(t4)
    t6 = line0*segment2 + line1*segment3 + line2
    t7 = t0*t4
    t8 = t4*t6
    t9 = line0*t5
    t10 = line1*t5
    return (
        t0*t5,
        t5*t6,
        -(line0*t7 - segment0)*t5,
        -(line1*t7 - segment1)*t5,
        t5,
        -(line0*t8 - segment2)*t5,
        -(line1*t8 - segment3)*t5,
        t5,
        t9,
        t10,
        0,
        0,
        0,
        0,
        t9,
        t10,
    )


def rho_theta(line, segment, origin):
    """rho_theta: value."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    origin0, origin1 = origin
    t0 = line0*line0
    t1 = line1*line1
    t2 = t0 + t1
    t3 = 1/t2
    t4 = sqrt(t3)
    t5 = segment1 - segment3
    t6 = segment0 - segment2
    t7 = t6*t6
    t8 = t5*t5
    t9 = t7 + t8
    t10 = 1/t9
    t11 = sqrt(t10)
    t12 = t11*t4
    return (
        line0*origin0*t4 + line1*origin1*t4 + line2*t4 - origin0*t11*t5 + origin1*t11*t6 - (segment0*segment3 - segment1*segment2)*t11,
        arctan2(-(line0*t6 + line1*t5)*t12, (line0*t5 - line1*t6)*t12),
    )


def rho_theta_jac(line, segment, origin):
    """rho_theta: value and Jacobians."""
    line0, line1, line2 = line
    segment0, segment1, segment2, segment3 = segment
    origin0, origin1 = origin
    t0 = line0*line0
    t1 = line1*line1
    t2 = t0 + t1
    t3 = 1/t2
    t4 = sqrt(t3)
    t5 = -segment3
    t6 = segment1 + t5
    t7 = t6*t6
    t8 = segment0 - segment2
    t9 = t8*t8
    t10 = t7 + t9
    t11 = 1/t10
    t12 = sqrt(t11)
    t13 = t12*t6
    t14 = line0*t4
    t15 = t12*t8
    t16 = line1*t4
    t17 = segment0*segment3 - segment1*segment2
    t18 = line0*t8
    t19 = line1*t6
    t20 = t18 + t19
    t21 = t12*t4
    t22 = line0*t6 - line1*t8
    t23 = line2*t3
    t24 = t0*t3
    t25 = line1*t3
    t26 = line0*t25
    t27 = -origin0
    t28 = t1*t3
    t29 = t20*t20
    t30 = t22*t22
    t31 = t29 + t30
    t32 = 1/t31
    t33 = line0*t19*t3
    t34 = -t20
    t35 = t18*t25
    t36 = -segment1
    t37 = segment3 + t36
    t38 = t11*t6
    t39 = t38*t8
    t40 = t11*t17
    t41 = origin0*t39 - origin1*t11*t9 + origin1 + t40*t8
    t42 = t11*t7
    t43 = origin0*t42 - origin1*t39 + t27 + t40*t6
    t44 = -t8
    t45 = t44*t44
    t46 = t7 + t45
    t47 = 1/t46
    t48 = t19*t47
    t49 = line0*t44
    t50 = -t19 + t49
    t51 = ((-line0*t45*t47 + line0 + t44*t48)*t22 + (line1*t11*t9 - line1 - t18*t38)*t50)*t32
    t52 = -t6
    t53 = ((line1 - t47*t49*t52 + t48*t52)*t22 + (-line0*t42 + line0 + t11*t19*t8)*t50)*t32
    return (
        line2*t4 - origin0*t13 + origin0*t14 + origin1*t15 + origin1*t16 - t12*t17,
        arctan2(-t20*t21, t21*t22),
        -(line0*t23 + origin0*t24 + origin1*t26 + t27)*t4,
        -(line1*t23 + origin0*t26 + origin1*t28 - origin1)*t4,
        t4,
        (-(segment0 - segment2 - t24*t8 - t33)*t22 + (t24*t6 - t35 + t37)*t34)*t32,
        (-(-t28*t6 - t35 - t37)*t22 + (-t28*t8 + t33 + t8)*t34)*t32,
        0,
        -(-t41 - t5)*t12,
        -(-segment2 - t43)*t12,
        -(t36 + t41)*t12,
        -(segment0 + t43)*t12,
        -t51,
        -t53,
        t51,
        t53,
        -t13 + t14,
        t15 + t16,
        0,
        0,
    )


def angles(line, rays):
    """angles: value."""
    line0, line1, line2, _, _, _ = line
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    t0 = line0*line0
    t1 = line1*line1
    t2 = line2*line2
    t3 = t0 + t1 + t2
    t4 = 1/t3
    t5 = sqrt(t4)
    return (
        (line0*rays0 + line1*rays1 + line2*rays2)*t5,
        (line0*rays3 + line1*rays4 + line2*rays5)*t5,
    )


def angles_jac(line, rays):
    """angles: value and Jacobians."""
    line0, line1, line2, _, _, _ = line
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    t0 = line0*rays0 + line1*rays1 + line2*rays2
    t1 = line0*line0
    t2 = line1*line1
    t3 = line2*line2
    t4 = t1 + t2 + t3
    t5 = 1/t4
    t6 = sqrt(t5)
    t7 = line0*rays3 + line1*rays4 + line2*rays5
    t8 = t0*t5
    t9 = t5*t7
    t10 = line0*t6
    t11 = line1*t6
    t12 = line2*t6
    return (
        t0*t6,
        t6*t7,
        -(line0*t8 - rays0)*t6,
        -(line1*t8 - rays1)*t6,
        -(line2*t8 - rays2)*t6,
        0,
        0,
        0,
        -(line0*t9 - rays3)*t6,
        -(line1*t9 - rays4)*t6,
        -(line2*t9 - rays5)*t6,
        0,
        0,
        0,
        t10,
        t11,
        t12,
        0,
        0,
        0,
        0,
        0,
        0,
        t10,
        t11,
        t12,
    )
