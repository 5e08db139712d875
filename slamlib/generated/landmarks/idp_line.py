"""Generated from slamlib/landmarks/idp_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, sqrt

DIGESTS = {
    "to_frame": "bbba632b3d2de4b8",
    "from_frame": "252ab2d11a915e04",
    "point_at": "6001e8500bdb06f4",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (9,),
    "point_at": (4,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = landmark1 - pose1
    t1 = cos(landmark3)
    t2 = landmark5*t0 + sin(landmark4)*t1
    t3 = pose5*pose5
    t4 = pose3*pose3
    t5 = pose6*pose6
    t6 = t4 - t5
    t7 = pose4*pose4
    t8 = -t7
    t9 = t3 + t6 + t8
    t10 = pose3*pose4
    t11 = pose5*pose6
    t12 = t10 + t11
    t13 = landmark2 - pose2
    t14 = landmark5*t13 + sin(landmark3)
    t15 = t14 + t14
    t16 = pose3*pose6
    t17 = pose4*pose5
    t18 = t16 - t17
    t19 = landmark0 - pose0
    t20 = landmark5*t19 + cos(landmark4)*t1
    t21 = t20 + t20
    first1 = t2*t9 + t12*t15 - t18*t21
    t22 = pose3*pose5
    t23 = pose4*pose6
    t24 = t22 + t23
    t25 = cos(landmark6)
    t26 = landmark8*t19 + cos(landmark7)*t25
    t27 = t26 + t26
    t28 = t10 - t11
    t29 = landmark8*t0 + sin(landmark7)*t25
    t30 = t29 + t29
    t31 = -t3
    t32 = t31 + t4 + t5 + t8
    t33 = landmark8*t13 + sin(landmark6)
    second2 = t24*t27 - t28*t30 + t32*t33
    t34 = t2 + t2
    first2 = -t28*t34 + t21*t24 + t14*t32
    t35 = t33 + t33
    second1 = t12*t35 - t18*t27 + t29*t9
    t36 = t16 + t17
    t37 = t7 + t31 + t6
    t38 = t22 - t23
    first0 = t34*t36 + t20*t37 - t15*t38
    second0 = -t35*t38 + t26*t37 + t30*t36
    return (
        first1*second2 - first2*second1,
        -first0*second2 + first2*second0,
        first0*second1 - first1*second0,
        -first0*landmark8 + landmark5*second0,
        -first1*landmark8 + landmark5*second1,
        -first2*landmark8 + landmark5*second2,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    t0 = landmark1 - pose1
    t1 = sin(landmark4)
    t2 = cos(landmark3)
    t3 = landmark5*t0 + t1*t2
    t4 = pose5*pose5
    t5 = pose3*pose3
    t6 = pose6*pose6
    t7 = t5 - t6
    t8 = pose4*pose4
    t9 = -t8
    t10 = t4 + t7 + t9
    t11 = pose3*pose4
    t12 = pose5*pose6
    t13 = t11 + t12
    t14 = landmark2 - pose2
    t15 = sin(landmark3)
    t16 = landmark5*t14 + t15
    t17 = t16 + t16
    t18 = pose3*pose6
    t19 = pose4*pose5
    t20 = t18 - t19
    t21 = landmark0 - pose0
    t22 = cos(landmark4)
    t23 = landmark5*t21 + t2*t22
    t24 = t23 + t23
    first1 = t10*t3 + t13*t17 - t20*t24
    t25 = pose3*pose5
    t26 = pose4*pose6
    t27 = t25 + t26
    t28 = cos(landmark6)
    t29 = cos(landmark7)
    t30 = landmark8*t21 + t28*t29
    t31 = t30 + t30
    t32 = t11 - t12
    t33 = sin(landmark7)
    t34 = landmark8*t0 + t28*t33
    t35 = t34 + t34
    t36 = -t4
    t37 = t36 + t5 + t6 + t9
    t38 = sin(landmark6)
    t39 = landmark8*t14 + t38
    second2 = t27*t31 - t32*t35 + t37*t39
    t40 = t3 + t3
    first2 = -t32*t40 + t24*t27 + t16*t37
    t41 = t39 + t39
    second1 = t13*t41 - t20*t31 + t10*t34
    t42 = first1*second2 - first2*second1
    t43 = t18 + t19
    t44 = t8 + t36 + t7
    t45 = t25 - t26
    first0 = t40*t43 + t23*t44 - t17*t45
    second0 = -t41*t45 + t30*t44 + t35*t43
    t46 = first0*second2 - first2*second0
    t47 = -t46
    t48 = first0*second1 - first1*second0
    t49 = first0*landmark8
    t50 = landmark5*second0
    t51 = t49 - t50
    t52 = -t51
    t53 = first1*landmark8
    t54 = landmark5*second1
    t55 = t53 - t54
    t56 = -t55
    t57 = first2*landmark8
    t58 = landmark5*second2
    t59 = t57 - t58
    t60 = -t59
    t61 = landmark5 + landmark5
    t62 = t27 + t27
    t63 = t20 + t20
    t64 = -t61*second1*t27 - t61*second2*t20 + t53*t62 + t57*t63
    t65 = t32 + t32
    t66 = t10*t57 - t10*t58 + t53*t65 - t54*t65
    t67 = t13 + t13
    t68 = t37*t53 - t37*t54 - t57*t67 + t58*t67
    t69 = -t44*t57 + t44*t58 + t49*t62 - t50*t62
    t70 = t43 + t43
    t71 = t49*t65 - t50*t65 + t57*t70 - t58*t70
    t72 = t45 + t45
    t73 = t37*t49 - t37*t50 + t57*t72 - t58*t72
    t74 = t44*t53 - t44*t54 + t49*t63 - t50*t63
    t75 = t10*t49 - t10*t50 - t53*t70 + t54*t70
    t76 = -t61*second0*t13 - t61*second1*t45 + t49*t67 + t53*t72
    t77 = t15*t22
    t78 = t1*t15
    t79 = -t65
    t80 = t2*t37
    t81 = t62*t77 + t78*t79 - t80
    t82 = -t63
    t83 = t2*t67
    t84 = t10*t78 + t77*t82 - t83
    t85 = t1*t27 + t22*t32
    t86 = second1 + second1
    t87 = t10*t22
    t88 = t1*t82 - t87
    t89 = t21 + t21
    t90 = t0 + t0
    t91 = t27*t89 - t32*t90 + t14*t37
    t92 = t0*t10 - t20*t89 + t14*t67
    t93 = t29*t38
    t94 = t33*t38
    t95 = t28*t37
    t96 = t62*t93 + t79*t94 - t95
    t97 = t28*t67
    t98 = t10*t94 + t82*t93 - t97
    t99 = t27*t33 + t29*t32
    t100 = t99 + t99
    t101 = t10*t29
    t102 = -t33*t63 - t101
    t103 = -t72
    t104 = t44*t77 + t70*t78
    t105 = -t103*t2 + t104
    t106 = t85 + t85
    t107 = -t1*t44 + t22*t70
    t108 = t21*t44 - t14*t72 + t43*t90
    t109 = t44*t93 + t70*t94
    t110 = -t103*t28 + t109
    t111 = first0 + first0
    t112 = -t33*t44 + t29*t70
    t113 = landmark8*t2
    t114 = landmark5*t28
    t115 = t15 + t15
    return (
        t42,
        t47,
        t48,
        t52,
        t56,
        t60,
        -t64,
        t66,
        -t68,
        0,
        -t48,
        t47,
        t69,
        -t71,
        t73,
        t48,
        0,
        -t42,
        t74,
        -t75,
        -t76,
        t46,
        t42,
        0,
        0,
        0,
        0,
        0,
        t59,
        t56,
        0,
        0,
        0,
        t60,
        0,
        t51,
        0,
        0,
        0,
        t55,
        t52,
        0,
        t64,
        -t66,
        t68,
        second1*t81 - second2*t84,
        -(-t86*t85 + second2*t88)*t2,
        -second1*t91 + second2*t92,
        -first1*t96 + first2*t98,
        (-first1*t100 + first2*t102)*t28,
        first1*t91 - first2*t92,
        -t69,
        t71,
        -t73,
        -second0*t81 + second2*t105,
        (-second0*t106 - second2*t107)*t2,
        second0*t91 - second2*t108,
        first0*t96 - first2*t110,
        -(-t111*t99 - first2*t112)*t28,
        -first0*t91 + first2*t108,
        -t74,
        t75,
        t76,
        second0*t84 - second1*t105,
        -(-second0*t88 - second1*t107)*t2,
        -second0*t92 + second1*t108,
        -first0*t98 + first1*t110,
        -((t33*t82 - t101)*first0 + first1*t112)*t28,
        first0*t92 - first1*t108,
        0,
        0,
        0,
        (t104 + t2*t72)*landmark8,
        -t107*t113,
        -landmark8*t108 + second0,
        -(t109 + t28*t72)*landmark5,
        t112*t114,
        -first0 + landmark5*t108,
        0,
        0,
        0,
        (t1*t10*t15 - t63*t77 - t83)*landmark8,
        (-t1*t63 - t87)*t113,
        -landmark8*t92 + second1,
        -(t10*t33*t38 - t63*t93 - t97)*landmark5,
        -t102*t114,
        -first1 + landmark5*t92,
        0,
        0,
        0,
        (t115*t22*t27 - t65*t78 - t80)*landmark8,
        t106*t113,
        -landmark8*t91 + second2,
        -(t62*t29*t38 - t65*t94 - t95)*landmark5,
        -t100*t114,
        -first2 + landmark5*t91,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose4*pose4
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose5*pose5
    t4 = t2 - t3
    t5 = pose6*pose6
    t6 = t1 + t4 + t5
    t7 = pose3*pose4
    t8 = pose5*pose6
    t9 = t7 + t8
    t10 = rays1 + rays1
    t11 = pose3*pose5
    t12 = pose4*pose6
    t13 = t11 - t12
    t14 = rays0 + rays0
    t15 = -t5
    t16 = t1 + t2 + t3 + t15
    t17 = pose3*pose6
    t18 = pose4*pose5
    t19 = t17 + t18
    t20 = t7 - t8
    t21 = rays2 + rays2
    t22 = rays1*t16 + t14*t19 - t20*t21
    t23 = t22*t22
    t24 = t4 + t15 + t0
    t25 = t11 + t12
    t26 = t17 - t18
    t27 = rays0*t24 + t21*t25 - t10*t26
    t28 = t27*t27
    t29 = t23 + t28
    t30 = sqrt(t29)
    t31 = rays4 + rays4
    t32 = rays3 + rays3
    t33 = rays5 + rays5
    t34 = rays4*t16 + t19*t32 - t20*t33
    t35 = t34*t34
    t36 = rays3*t24 + t25*t33 - t26*t31
    t37 = t36*t36
    t38 = t35 + t37
    t39 = sqrt(t38)
    return (
        pose0,
        pose1,
        pose2,
        arctan2(rays2*t6 + t10*t9 - t13*t14, t30),
        arctan2(t22, t27),
        prior0,
        arctan2(rays5*t6 + t31*t9 - t13*t32, t39),
        arctan2(t34, t36),
        prior1,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose6*pose6
    t1 = pose4*pose4
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose5*pose5
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = pose3*pose4
    t8 = pose5*pose6
    t9 = t7 + t8
    t10 = rays1 + rays1
    t11 = rays2*t6 + t10*t9
    t12 = pose3*pose5
    t13 = pose4*pose6
    t14 = t12 - t13
    t15 = rays0 + rays0
    t16 = t11 - t14*t15
    t17 = t7 - t8
    t18 = rays2 + rays2
    t19 = -t0
    t20 = t19 + t2 + t3 + t4
    t21 = pose3*pose6
    t22 = pose4*pose5
    t23 = t21 + t22
    t24 = rays1*t20 + t15*t23
    t25 = -t17*t18 + t24
    t26 = t25*t25
    t27 = t21 - t22
    t28 = t19 + t1 + t5
    t29 = t12 + t13
    t30 = rays0*t28 + t18*t29
    t31 = -t10*t27 + t30
    t32 = t31*t31
    t33 = t26 + t32
    t34 = sqrt(t33)
    t35 = rays3 + rays3
    t36 = rays4 + rays4
    t37 = rays5*t6 + t36*t9
    t38 = -t14*t35 + t37
    t39 = rays5 + rays5
    t40 = rays4*t20 + t23*t35
    t41 = -t17*t39 + t40
    t42 = t41*t41
    t43 = rays3*t28 + t29*t39
    t44 = -t27*t36 + t43
    t45 = t44*t44
    t46 = t42 + t45
    t47 = sqrt(t46)
    t48 = t16*t16
    t49 = t48 + t33
    t50 = 1/t49
    t51 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t52 = -t17
    t53 = t18*t52 + t24
    t54 = t53*t53
    t55 = -t27
    t56 = t10*t55 + t30
    t57 = t56*t56
    t58 = t54 + t57
    t59 = sqrt(t58)
    t60 = 1/t59
    t61 = -t14
    t62 = (t11 + t15*t61)*t60
    t63 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t64 = pose4*rays0 + pose5*rays1 + pose6*rays2
    t65 = t56*t64
    t66 = -t51*t59 + (-t53*t63 + t65)*t62
    t67 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t68 = -t59*t63 + (t51*t53 + t56*t67)*t62
    t69 = t53*t67
    t70 = -t59*t64 + (-t51*t56 + t69)*t62
    t71 = t59*t67 + (t53*t64 + t56*t63)*t62
    t72 = 1/t33
    t73 = t25*t64 + t31*t63
    t74 = t25*t67 - t31*t51
    t75 = t25*t51 + t31*t67
    t76 = t25*t63 - t31*t64
    t77 = t38*t38
    t78 = t77 + t46
    t79 = 1/t78
    t80 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t81 = t39*t52 + t40
    t82 = t81*t81
    t83 = t36*t55 + t43
    t84 = t83*t83
    t85 = t82 + t84
    t86 = sqrt(t85)
    t87 = 1/t86
    t88 = (t35*t61 + t37)*t87
    t89 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t90 = pose4*rays3 + pose5*rays4 + pose6*rays5
    t91 = t83*t90
    t92 = -t80*t86 + (-t81*t89 + t91)*t88
    t93 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t94 = -t86*t89 + (t80*t81 + t83*t93)*t88
    t95 = t81*t93
    t96 = -t86*t90 + (-t80*t83 + t95)*t88
    t97 = t86*t93 + (t81*t90 + t83*t89)*t88
    t98 = 1/t46
    t99 = t41*t90 + t44*t89
    t100 = t41*t93 - t44*t80
    t101 = t41*t80 + t44*t93
    t102 = t41*t89 - t44*t90
    t103 = t34 + t34
    t104 = 1/t34
    t105 = t104*t16
    t106 = t23 + t23
    t107 = t27 + t27
    t108 = (-t17*t25 + t29*t31)
    t109 = t108 + t108
    t110 = (t17*t31 + t25*t29)
    t111 = t110 + t110
    t112 = t47 + t47
    t113 = 1/t47
    t114 = t113*t38
    t115 = (-t17*t41 + t29*t44)
    t116 = t115 + t115
    t117 = (t17*t44 + t29*t41)
    t118 = t117 + t117
    return (
        pose0,
        pose1,
        pose2,
        arctan2(t16, t34),
        arctan2(t25, t31),
        prior0,
        arctan2(t38, t47),
        arctan2(t41, t44),
        prior1,
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
        0,
        -(pose3*t66 - pose4*t68 - pose5*t70 + pose6*t71)*t50,
        -(pose3*t71 + pose4*t70 - pose5*t68 - pose6*t66)*t50,
        -(pose3*t70 - pose4*t71 + pose5*t66 - pose6*t68)*t50,
        0,
        0,
        0,
        (-pose3*t73 + pose4*t74 - pose5*t75 - pose6*t76)*t72,
        -((t53*t63 - t65)*pose3 - pose4*t75 - (-t51*t56 + t69)*pose5 - pose6*t73)*t72,
        (pose3*t75 + pose4*t76 - pose5*t73 + pose6*t74)*t72,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        -(pose3*t92 - pose4*t94 - pose5*t96 + pose6*t97)*t79,
        -(pose3*t97 + pose4*t96 - pose5*t94 - pose6*t92)*t79,
        -(pose3*t96 - pose4*t97 + pose5*t92 - pose6*t94)*t79,
        0,
        0,
        0,
        (-pose3*t99 + pose4*t100 - pose5*t101 - pose6*t102)*t98,
        -((t81*t89 - t91)*pose3 - pose4*t101 - (-t80*t83 + t95)*pose5 - pose6*t99)*t98,
        (pose3*t101 + pose4*t102 - pose5*t99 + pose6*t100)*t98,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        -(t103*t14 + (t106*t25 + t28*t31)*t105)*t50,
        (t103*t9 + (-t20*t25 + t107*t31)*t105)*t50,
        -(-t34*t6 + t109*t105)*t50,
        0,
        0,
        0,
        (-t25*t28 + t106*t31)*t72,
        -(-t20*t31 - t107*t25)*t72,
        -t111*t72,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        -(t112*t14 + (t28*t44 + t106*t41)*t114)*t79,
        (t112*t9 + (-t20*t41 + t107*t44)*t114)*t79,
        -(-t47*t6 + t116*t114)*t79,
        0,
        0,
        0,
        (-t28*t41 + t106*t44)*t98,
        -(-t20*t44 - t107*t41)*t98,
        -t118*t98,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
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
        0,
        1,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark5*landmark8
    t1 = abscissa*landmark5
    t2 = cos(landmark6)*t1
    t3 = (abscissa - 1)*landmark8
    t4 = cos(landmark3)*t3
    return (
        landmark0*t0 + cos(landmark7)*t2 - cos(landmark4)*t4,
        landmark1*t0 + sin(landmark7)*t2 - sin(landmark4)*t4,
        landmark2*t0 + sin(landmark6)*t1 - sin(landmark3)*t3,
        t0,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7, landmark8 = landmark
    abscissa, = abscissa
    t0 = landmark5*landmark8
    t1 = cos(landmark4)
    t2 = abscissa - 1
    t3 = cos(landmark3)
    t4 = t2*t3
    t5 = t1*t4
    t6 = -landmark8*t5
    t7 = cos(landmark7)
    t8 = cos(landmark6)
    t9 = abscissa*t8
    t10 = t7*t9
    t11 = landmark5*t10
    t12 = sin(landmark7)
    t13 = t12*t9
    t14 = landmark5*t13
    t15 = sin(landmark4)
    t16 = t15*t4
    t17 = landmark8*t16
    t18 = sin(landmark6)
    t19 = abscissa*t18
    t20 = landmark5*t19
    t21 = sin(landmark3)
    t22 = t2*t21
    t23 = landmark8*t22
    t24 = landmark5*t8
    t25 = landmark8*t3
    return (
        landmark0*t0 + t6 + t11,
        landmark1*t0 + t14 - t17,
        landmark2*t0 + t20 - t23,
        t0,
        t0,
        0,
        0,
        t1*t23,
        t17,
        landmark0*landmark8 + t10,
        -t20*t7,
        -t14,
        landmark0*landmark5 - t5,
        0,
        t0,
        0,
        t15*t23,
        t6,
        landmark1*landmark8 + t13,
        -t12*t20,
        t11,
        landmark1*landmark5 - t16,
        0,
        0,
        t0,
        -landmark8*t4,
        0,
        landmark2*landmark8 + t19,
        landmark5*t9,
        0,
        landmark2*landmark5 - t22,
        0,
        0,
        0,
        0,
        0,
        landmark8,
        0,
        0,
        landmark5,
        t24*t7 - t1*t25,
        t12*t24 - t15*t25,
        landmark5*t18 - landmark8*t21,
        0,
    )
