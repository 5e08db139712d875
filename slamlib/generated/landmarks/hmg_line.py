"""Generated from slamlib/landmarks/hmg_line.py by `make generate` (sympy 1.14.0); never edited by hand."""

DIGESTS = {
    "to_frame": "3b66265063d42386",
    "from_frame": "62feeb9a7e9089aa",
    "point_at": "291ca6820b137862",
}
SHAPES = {
    "to_frame": (6,),
    "from_frame": (8,),
    "point_at": (4,),
}


def to_frame(pose, landmark):
    """to_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    t0 = pose6*pose6
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose4*pose4
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = landmark2 - landmark3*pose2
    t8 = pose3*pose5
    t9 = pose4*pose6
    t10 = t8 + t9
    t11 = landmark0 - landmark3*pose0
    t12 = t11 + t11
    t13 = landmark1 - landmark3*pose1
    t14 = pose3*pose4
    t15 = t14 + t14
    t16 = pose5*pose6
    t17 = t16 + t16
    t18 = t15 - t17
    t19 = t6*t7 + t10*t12 - t13*t18
    t20 = landmark6 - landmark7*pose2
    t21 = t15 + t17
    t22 = pose3*pose6
    t23 = pose4*pose5
    t24 = t22 - t23
    t25 = landmark4 - landmark7*pose0
    t26 = t25 + t25
    t27 = landmark5 - landmark7*pose1
    t28 = -t0
    t29 = t1 + t5 + t28
    t30 = t20*t21 - t24*t26 + t27*t29
    t31 = t21*t7 - t12*t24 + t13*t29
    t32 = t20*t6 + t10*t26 - t18*t27
    t33 = t8 + t8
    t34 = t9 + t9
    t35 = t33 - t34
    t36 = t2 + t3 + t4 + t28
    t37 = t22 + t22
    t38 = t23 + t23
    t39 = t37 + t38
    t40 = -t20*t35 + t25*t36 + t27*t39
    t41 = t11*t36 + t13*t39 - t35*t7
    return (
        -t19*t30 + t31*t32,
        t19*t40 - t32*t41,
        t30*t41 - t31*t40,
        landmark3*t40 - landmark7*t41,
        landmark3*t30 - landmark7*t31,
        landmark3*t32 - landmark7*t19,
    )


def to_frame_jac(pose, landmark):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    t0 = pose6*pose6
    t1 = pose5*pose5
    t2 = -t1
    t3 = pose3*pose3
    t4 = pose4*pose4
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = landmark2 - landmark3*pose2
    t8 = pose3*pose5
    t9 = pose4*pose6
    t10 = t8 + t9
    t11 = landmark0 - landmark3*pose0
    t12 = t11 + t11
    t13 = landmark1 - landmark3*pose1
    t14 = pose3*pose4
    t15 = t14 + t14
    t16 = pose5*pose6
    t17 = t16 + t16
    t18 = t15 - t17
    t19 = t6*t7 + t10*t12 - t13*t18
    t20 = landmark6 - landmark7*pose2
    t21 = t14 + t16
    t22 = t21 + t21
    t23 = pose3*pose6
    t24 = pose4*pose5
    t25 = t23 - t24
    t26 = landmark4 - landmark7*pose0
    t27 = t26 + t26
    t28 = landmark5 - landmark7*pose1
    t29 = -t0
    t30 = t1 + t5 + t29
    t31 = t20*t22 - t25*t27 + t28*t30
    t32 = t22*t7 - t12*t25 + t13*t30
    t33 = t20*t6 + t10*t27 - t18*t28
    t34 = t19*t31 - t32*t33
    t35 = -t34
    t36 = t8 + t8
    t37 = t9 + t9
    t38 = t36 - t37
    t39 = t2 + t3 + t4 + t29
    t40 = t23 + t24
    t41 = t40 + t40
    t42 = -t20*t38 + t26*t39 + t28*t41
    t43 = t11*t39 + t13*t41 - t38*t7
    t44 = t19*t42 - t33*t43
    t45 = -t31*t43 + t32*t42
    t46 = -t45
    t47 = landmark3*t42
    t48 = landmark7*t43
    t49 = t47 - t48
    t50 = landmark3*t31
    t51 = landmark7*t32
    t52 = t50 - t51
    t53 = landmark3*t33
    t54 = landmark7*t19
    t55 = t53 - t54
    t56 = t10 + t10
    t57 = t25 + t25
    t58 = landmark7 + landmark7
    t59 = pose0*t56 - pose1*t18 + pose2*t6
    t60 = -pose0*t57 + pose1*t30 + pose2*t22
    t61 = pose0*t39 + pose1*t41 - pose2*t38
    return (
        t35,
        t44,
        t46,
        t49,
        t52,
        t55,
        t50*t56 - t51*t56 + t53*t57 - t54*t57,
        -t30*t53 + t30*t54 - t18*t50 + t18*t51,
        landmark3*t31*t6 + t58*t19*t21 - t51*t6 - t22*t53,
        0,
        t45,
        t44,
        landmark3*t33*t39 + t58*t10*t43 - t39*t54 - t47*t56,
        t41*t53 - t41*t54 + t18*t47 - t18*t48,
        -t47*t6 + t48*t6 - t38*t53 + t38*t54,
        t46,
        0,
        t34,
        -t39*t50 + t39*t51 - t47*t57 + t48*t57,
        landmark3*t30*t42 + t58*t32*t40 - t30*t48 - t41*t50,
        t22*t47 - t22*t48 + t38*t50 - t38*t51,
        -t44,
        t35,
        0,
        0,
        0,
        0,
        0,
        -t55,
        t52,
        0,
        0,
        0,
        t55,
        0,
        -t49,
        0,
        0,
        0,
        -t52,
        t49,
        0,
        -t31*t56 - t33*t57,
        t30*t33 + t18*t31,
        -t31*t6 + t22*t33,
        t31*t59 - t33*t60,
        t19*t57 + t32*t56,
        -t19*t30 - t18*t32,
        t32*t6 - t19*t22,
        t19*t60 - t32*t59,
        -t33*t39 + t42*t56,
        -t33*t41 - t18*t42,
        t42*t6 + t33*t38,
        t33*t61 - t42*t59,
        t19*t39 - t43*t56,
        t19*t41 + t18*t43,
        -t43*t6 - t19*t38,
        -t19*t61 + t43*t59,
        t31*t39 + t42*t57,
        -t30*t42 + t31*t41,
        -t22*t42 - t31*t38,
        -t31*t61 + t42*t60,
        -t32*t39 - t43*t57,
        t30*t43 - t32*t41,
        t22*t43 + t32*t38,
        t32*t61 - t43*t60,
        -landmark7*t39,
        -landmark7*t41,
        landmark7*t38,
        landmark7*t61 + t42,
        landmark3*t39,
        landmark3*t41,
        -landmark3*t38,
        -landmark3*t61 - t43,
        landmark7*t57,
        -landmark7*t30,
        -landmark7*t22,
        landmark7*t60 + t31,
        -landmark3*t57,
        landmark3*t30,
        landmark3*t22,
        -landmark3*t60 - t32,
        -landmark7*t56,
        landmark7*t18,
        -landmark7*t6,
        landmark7*t59 + t33,
        landmark3*t56,
        -landmark3*t18,
        landmark3*t6,
        -landmark3*t59 - t19,
    )


def from_frame(pose, rays, prior):
    """from_frame: value."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose5*pose5
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose6*pose6
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 + t8
    t10 = rays2 + rays2
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = t11 - t12
    t14 = rays1 + rays1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = rays0 + rays0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = rays5 + rays5
    t26 = rays4 + rays4
    t27 = rays3 + rays3
    return (
        pose0*prior0 + rays0*t6 + t10*t9 - t13*t14,
        pose1*prior0 + rays1*t16 + t17*t18 - t10*t21,
        pose2*prior0 + rays2*t22 - t18*t23 + t14*t24,
        prior0,
        pose0*prior1 + rays3*t6 + t25*t9 - t13*t26,
        pose1*prior1 + rays4*t16 + t17*t27 - t21*t25,
        pose2*prior1 + rays5*t22 + t24*t26 - t23*t27,
        prior1,
    )


def from_frame_jac(pose, rays, prior):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2, pose3, pose4, pose5, pose6 = pose
    rays0, rays1, rays2, rays3, rays4, rays5 = rays
    prior0, prior1 = prior
    t0 = pose5*pose5
    t1 = -t0
    t2 = pose3*pose3
    t3 = pose6*pose6
    t4 = t2 - t3
    t5 = pose4*pose4
    t6 = t1 + t4 + t5
    t7 = pose3*pose5
    t8 = pose4*pose6
    t9 = t7 + t8
    t10 = rays2 + rays2
    t11 = pose3*pose6
    t12 = pose4*pose5
    t13 = t11 - t12
    t14 = rays1 + rays1
    t15 = -t5
    t16 = t4 + t15 + t0
    t17 = t11 + t12
    t18 = rays0 + rays0
    t19 = pose3*pose4
    t20 = pose5*pose6
    t21 = t19 - t20
    t22 = t1 + t2 + t3 + t15
    t23 = t7 - t8
    t24 = t19 + t20
    t25 = rays5 + rays5
    t26 = rays4 + rays4
    t27 = rays3 + rays3
    t28 = pose3*rays1 - pose4*rays2 + pose6*rays0
    t29 = pose5*t28
    t30 = pose3*rays0 + pose5*rays2 - pose6*rays1
    t31 = pose4*t30
    t32 = pose4*rays0 + pose5*rays1 + pose6*rays2
    t33 = pose3*t32
    t34 = pose3*rays2 + pose4*rays1 - pose5*rays0
    t35 = pose6*t34
    t36 = t33 + t35
    t37 = pose6*t32
    t38 = pose3*t34
    t39 = pose4*t28 + pose5*t30
    t40 = pose3*t28
    t41 = pose5*t32
    t42 = pose4*t34 + pose6*t30
    t43 = pose4*t32
    t44 = pose3*t30
    t45 = pose5*t34 + pose6*t28
    t46 = pose3*rays4 - pose4*rays5 + pose6*rays3
    t47 = pose5*t46
    t48 = pose3*rays3 + pose5*rays5 - pose6*rays4
    t49 = pose4*t48
    t50 = pose4*rays3 + pose5*rays4 + pose6*rays5
    t51 = pose3*t50
    t52 = pose3*rays5 + pose4*rays4 - pose5*rays3
    t53 = pose6*t52
    t54 = t51 + t53
    t55 = pose6*t50
    t56 = pose3*t52
    t57 = pose4*t46 + pose5*t48
    t58 = pose3*t46
    t59 = pose5*t50
    t60 = pose4*t52 + pose6*t48
    t61 = pose4*t50
    t62 = pose3*t48
    t63 = pose5*t52 + pose6*t46
    t64 = t13 + t13
    t65 = -t64
    t66 = t9 + t9
    t67 = t17 + t17
    t68 = t21 + t21
    t69 = -t68
    t70 = t23 + t23
    t71 = -t70
    t72 = t24 + t24
    return (
        pose0*prior0 + rays0*t6 + t10*t9 - t13*t14,
        pose1*prior0 + rays1*t16 + t17*t18 - t10*t21,
        pose2*prior0 + rays2*t22 - t18*t23 + t14*t24,
        prior0,
        pose0*prior1 + rays3*t6 + t25*t9 - t13*t26,
        pose1*prior1 + rays4*t16 + t17*t27 - t21*t25,
        pose2*prior1 + rays5*t22 + t24*t26 - t23*t27,
        prior1,
        prior0,
        0,
        0,
        t29 - t31 + t36,
        -t37 + t38 - t39,
        -t40 + t41 - t42,
        0,
        prior0,
        0,
        t37 - t38 - t39,
        -t29 + t31 + t36,
        -t43 + t44 - t45,
        0,
        0,
        prior0,
        t40 - t41 - t42,
        t43 - t44 - t45,
        t29 + t31 + t33 - t35,
        0,
        0,
        0,
        0,
        0,
        0,
        prior1,
        0,
        0,
        t47 - t49 + t54,
        -t55 + t56 - t57,
        -t58 + t59 - t60,
        0,
        prior1,
        0,
        t55 - t56 - t57,
        -t47 + t49 + t54,
        -t61 + t62 - t63,
        0,
        0,
        prior1,
        t58 - t59 - t60,
        t61 - t62 - t63,
        t47 + t49 + t51 - t53,
        0,
        0,
        0,
        0,
        0,
        0,
        t6,
        t65,
        t66,
        0,
        0,
        0,
        t67,
        t16,
        t69,
        0,
        0,
        0,
        t71,
        t72,
        t22,
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
        t6,
        t65,
        t66,
        0,
        0,
        0,
        t67,
        t16,
        t69,
        0,
        0,
        0,
        t71,
        t72,
        t22,
        0,
        0,
        0,
        0,
        0,
        0,
        pose0,
        0,
        pose1,
        0,
        pose2,
        0,
        1,
        0,
        0,
        pose0,
        0,
        pose1,
        0,
        pose2,
        0,
        1,
    )


def point_at(landmark, abscissa):
    """point_at: value."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    abscissa, = abscissa
    t0 = (abscissa - 1)*landmark7
    t1 = abscissa*landmark3
    return (
        -landmark0*t0 + landmark4*t1,
        -landmark1*t0 + landmark5*t1,
        -landmark2*t0 + landmark6*t1,
        landmark3*landmark7,
    )


def point_at_jac(landmark, abscissa):
    """point_at: value and Jacobians."""
    landmark0, landmark1, landmark2, landmark3, landmark4, landmark5, landmark6, landmark7 = landmark
    abscissa, = abscissa
    t0 = abscissa - 1
    t1 = landmark7*t0
    t2 = abscissa*landmark4
    t3 = abscissa*landmark3
    t4 = -t1
    return (
        -landmark0*t1 + landmark3*t2,
        -landmark1*t1 + landmark5*t3,
        -landmark2*t1 + landmark6*t3,
        landmark3*landmark7,
        t4,
        0,
        0,
        t2,
        t3,
        0,
        0,
        -landmark0*t0,
        0,
        t4,
        0,
        abscissa*landmark5,
        0,
        t3,
        0,
        -landmark1*t0,
        0,
        0,
        t4,
        abscissa*landmark6,
        0,
        0,
        t3,
        -landmark2*t0,
        0,
        0,
        0,
        landmark7,
        0,
        0,
        0,
        landmark3,
        -landmark0*landmark7 + landmark3*landmark4,
        -landmark1*landmark7 + landmark3*landmark5,
        -landmark2*landmark7 + landmark3*landmark6,
        0,
    )
