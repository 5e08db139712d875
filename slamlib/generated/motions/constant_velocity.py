"""Generated from slamlib/motions/constant_velocity.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import stumpff

DIGESTS = {
    "step": "bfe994945e1546da",
}
SHAPES = {
    "step": (13,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2, state3, state4, state5, state6, state7, state8, state9, state10, state11, state12 = state
    control0, control1, control2, control3, control4, control5 = control
    dt, = dt
    t0 = (dt*dt*(state10*state10 + state11*state11 + state12*state12))/4
    t1 = stumpff(0, t0)
    t2 = (dt*stumpff(1, t0))/2
    t3 = state10*t2
    t4 = state5*t2
    t5 = state6*t2
    t6 = state11*t2
    t7 = state12*t2
    return (
        dt*state7 + state0,
        dt*state8 + state1,
        dt*state9 + state2,
        -state11*t4 - state12*t5 + state3*t1 - state4*t3,
        -state11*t5 + state12*t4 + state3*t3 + state4*t1,
        state3*t6 - state4*t7 + state5*t1 + state6*t3,
        state3*t7 + state4*t6 - state5*t3 + state6*t1,
        control0 + state7,
        control1 + state8,
        control2 + state9,
        control3 + state10,
        control4 + state11,
        control5 + state12,
    )


def step_jac(state, control, dt):
    """step: value and Jacobians."""
    state0, state1, state2, state3, state4, state5, state6, state7, state8, state9, state10, state11, state12 = state
    control0, control1, control2, control3, control4, control5 = control
    dt, = dt
    t0 = dt*dt
    t1 = state10*state10
    t2 = state11*state11
    t3 = state12*state12
    t4 = t1 + t2 + t3
    t5 = t0*t4
    t6 = t5/4
    t7 = stumpff(0, t6)
    t8 = stumpff(1, t6)
    t9 = dt*t8
    t10 = state10*state4
    t11 = t10*t9
    t12 = state5*t9
    t13 = state11*t12
    t14 = state6*t9
    t15 = state12*t14
    t16 = state4*t7
    t17 = state3*t9
    t18 = state10*t17
    t19 = state11*t14
    t20 = state12*t12
    t21 = state5*t7
    t22 = state10*t14
    t23 = state11*t17
    t24 = state4*t9
    t25 = state12*t24
    t26 = state6*t7
    t27 = state10*t12
    t28 = state11*t24
    t29 = state12*t17
    t30 = 2*state3*t7
    t31 = t13 + t15
    t32 = t11 - t30 + t31
    t33 = 2*t16
    t34 = t18 + t33
    t35 = -t19 + t20 + t34
    t36 = 2*t26
    t37 = t28 + t29
    t38 = -t27 + t36 + t37
    t39 = 2*t21
    t40 = t22 + t39
    t41 = t23 - t25 + t40
    t42 = 1/(t32*t32 + t35*t35 + t38*t38 + t41*t41)
    t43 = t19 - t20 + t34
    t44 = -t11 + t30 + t31
    t45 = t27 - t36 + t37
    t46 = -t23 + t25 + t40
    t47 = t19 + t20
    t48 = t18 - t33 + t47
    t49 = t27 + t36
    t50 = t28 - t29 + t49
    t51 = t23 + t25
    t52 = -t22 + t39 + t51
    t53 = t11 + t30
    t54 = -t13 + t15 + t53
    t55 = t22 - t39 + t51
    t56 = -t18 + t33 + t47
    t57 = t13 - t15 + t53
    t58 = -t28 + t29 + t49
    t59 = 4*t8
    t60 = state4*t59
    t61 = state11*state5
    t62 = stumpff(2, t6) - stumpff(3, t6)
    t63 = -t62
    t64 = state10*t0
    t65 = t63*t64
    t66 = state6*t63
    t67 = state12*t64
    t68 = t66*t67
    t69 = t0*t1
    t70 = t63*t69
    t71 = state4*t70 + 2*t18 + t60 + t61*t65 + t68
    t72 = -4*state3*t8
    t73 = t62*t67
    t74 = state5*t73
    t75 = t62*t69
    t76 = t62*t64
    t77 = state11*state6
    t78 = t76*t77
    t79 = -state3*t75 - 2*t11 - t72 - t74 + t78
    t80 = -4*state6*t8
    t81 = state11*state3
    t82 = t76*t81
    t83 = t0*t10
    t84 = state12*t62
    t85 = t83*t84
    t86 = -state6*t75 - 2*t27 - t80 - t82 + t85
    t87 = state5*t59
    t88 = t63*t83
    t89 = state11*t88
    t90 = state3*t65
    t91 = -state12*t90 + state5*t70 + 2*t22 + t87 - t89
    t92 = t42/2
    t93 = dt*t92
    t94 = state12*t0
    t95 = t0*t2
    t96 = state5*t95
    t97 = state11*t66*t94 + 2*t23 + t63*t96 + t87 + t89
    t98 = t61*t63
    t99 = t94*t98
    t100 = state6*t59
    t101 = t100 + 2*t28
    t102 = -state11*t90 + t101 + t66*t95 - t99
    t103 = t62*t95
    t104 = t0*t84
    t105 = state11*state4
    t106 = t104*t105
    t107 = state3*t103 - t106 + 2*t13 + t72 + t78
    t108 = -t107
    t109 = t104*t81
    t110 = -state10*state11*state5*t0*t62 + state4*t103 - 4*state4*t8 + t109 + 2*t19
    t111 = -t110
    t112 = t0*t3
    t113 = state12*t88 + t100 + t112*t66 + 2*t29 + t99
    t114 = -4*state5*t8
    t115 = t112*t62
    t116 = t104*t77
    t117 = state3*t73 + state5*t115 + t114 - t116 + 2*t25
    t118 = -t117
    t119 = 2*t20 + t60
    t120 = state4*t112*t63 + t119 - t63*t81*t94 - t68
    t121 = state3*t115 + t106 + 2*t15 + t72 - t74
    t122 = -t121
    t123 = t104*t61
    t124 = t10*t5
    t125 = 2*t4
    t126 = state10*t60 + state11*t87 + state12*t100 + t125*t17
    t127 = state12*t5*t66 + t124*t63 + t126 + t5*t98
    t128 = t5*t62
    t129 = state10*t128
    t130 = t5*t84
    t131 = -4*state10*state3*t8 - state11*state6*t0*t4*t62 + state11*t100 - 4*state12*state5*t8 + state3*t129 + state5*t130 + t125*t24
    t132 = -t131
    t133 = -4*state10*state6*t8 - 4*state11*state3*t8 - state12*state4*t0*t4*t62 + state12*t60 + state6*t129 + t12*t125 + t128*t81
    t134 = -t133
    t135 = -state10*state5*t0*t4*t62 + state10*t87 - 4*state11*state4*t8 - 4*state12*state3*t8 + state3*t130 + t105*t128 + t125*t14
    t136 = -t135
    return (
        dt*state7 + state0,
        dt*state8 + state1,
        dt*state9 + state2,
        state3*t7 + (-t11)/2 + (-t13)/2 + (-t15)/2,
        t16 + t18/2 + (-t19)/2 + t20/2,
        t21 + t22/2 + t23/2 + (-t25)/2,
        t26 + (-t27)/2 + t28/2 + t29/2,
        control0 + state7,
        control1 + state8,
        control2 + state9,
        control3 + state10,
        control4 + state11,
        control5 + state12,
        1,
        0,
        0,
        0,
        0,
        0,
        dt,
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
        dt,
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
        dt,
        0,
        0,
        0,
        0,
        0,
        0,
        t42*(-t32*t44 + t35*t43 - t38*t45 + t41*t46),
        t42*(t32*t50 + t35*t52 + t38*t54 + t41*t48),
        t42*(t32*t55 + t35*t58 - t38*t56 - t41*t57),
        0,
        0,
        0,
        t93*(-t32*t79 + t35*t71 + t38*t86 + t41*t91),
        t93*(t102*t32 + t108*t38 - t111*t41 + t35*t97),
        t93*(t113*t35 - t118*t32 - t120*t38 - t122*t41),
        0,
        0,
        0,
        t42*(t32*t45 - t35*t46 - t38*t44 + t41*t43),
        t42*(-t32*t54 - t35*t48 + t38*t50 + t41*t52),
        t42*(t32*t56 + t35*t57 + t38*t55 + t41*t58),
        0,
        0,
        0,
        t93*(-t32*t86 - t35*t91 - t38*t79 + t41*t71),
        t93*(t107*t32 - t110*t35 + t38*(-state6*t103 + t101 + t123 + t82) + t41*(2*dt*state11*state3*t8 - state11*t62*t83 - t114 - t116 - t62*t96)),
        t93*(t117*t38 - t121*t35 + t32*(-state4*t115 + state6*t73 + t109 + t119) + t41*(2*dt*state12*state3*t8 - state6*t115 - t123 - t80 - t85)),
        0,
        0,
        0,
        t42*(t32*t46 + t35*t45 + t38*t43 + t41*t44),
        t42*(t32*t48 - t35*t54 + t38*t52 - t41*t50),
        t42*(-t32*t57 + t35*t56 + t38*t58 - t41*t55),
        0,
        0,
        0,
        t93*(t32*t91 - t35*t86 + t38*t71 + t41*t79),
        t93*(-t102*t41 - t108*t35 - t111*t32 + t38*t97),
        t93*(t113*t38 + t118*t41 + t120*t35 - t122*t32),
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
        1,
        state7,
        state8,
        state9,
        t92*(t127*t35 - t132*t32 + t134*t38 - t136*t41),
        t92*(t131*t38 + t133*t32 - t135*t35 + t41*(-state6*t130 - t124*t62 + t126 - t128*t61)),
        t92*(t127*t38 + t132*t41 - t134*t35 - t136*t32),
        0,
        0,
        0,
        0,
        0,
        0,
    )


def step_storage_jac(state, control, dt):
    """step: value and derivatives by stored numbers."""
    state0, state1, state2, state3, state4, state5, state6, state7, state8, state9, state10, state11, state12 = state
    control0, control1, control2, control3, control4, control5 = control
    dt, = dt
    t0 = dt*dt
    t1 = state10*state10
    t2 = state11*state11
    t3 = state12*state12
    t4 = t1 + t2 + t3
    t5 = t0*t4
    t6 = t5/4
    t7 = stumpff(0, t6)
    t8 = stumpff(1, t6)
    t9 = dt*t8
    t10 = t9/2
    t11 = state10*t10
    t12 = state11*t10
    t13 = state12*t10
    t14 = -t11
    t15 = -t12
    t16 = -t13
    t17 = 4*t8
    t18 = state4*t17
    t19 = -t18
    t20 = 2*t9
    t21 = state10*state3
    t22 = stumpff(2, t6) - stumpff(3, t6)
    t23 = t0*t22
    t24 = state10*t23
    t25 = state11*state5
    t26 = state12*state6
    t27 = t24*t26
    t28 = t1*t23
    t29 = dt/8
    t30 = state5*t17
    t31 = -t30
    t32 = state3*t20
    t33 = state4*t24
    t34 = state11*t33
    t35 = state11*t23
    t36 = t2*t23
    t37 = state6*t17
    t38 = -t37
    t39 = state12*t23
    t40 = t25*t39
    t41 = t23*t3
    t42 = -4*state3*t8
    t43 = state4*t20
    t44 = state12*state5
    t45 = t24*t44
    t46 = state11*state6
    t47 = t24*t46
    t48 = t21*t35
    t49 = t21*t39
    t50 = state10*t20
    t51 = state12*t35
    t52 = state4*t51
    t53 = state3*t51
    t54 = t22*t5
    t55 = t20*t4
    t56 = state3*t54
    return (
        dt*state7 + state0,
        dt*state8 + state1,
        dt*state9 + state2,
        state3*t7 - state4*t11 - state5*t12 - state6*t13,
        state3*t11 + state4*t7 + state5*t13 - state6*t12,
        state3*t12 - state4*t13 + state5*t7 + state6*t11,
        state3*t13 + state4*t12 - state5*t11 + state6*t7,
        control0 + state7,
        control1 + state8,
        control2 + state9,
        control3 + state10,
        control4 + state11,
        control5 + state12,
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        dt,
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
        dt,
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
        dt,
        0,
        0,
        0,
        0,
        0,
        0,
        t7,
        t14,
        t15,
        t16,
        0,
        0,
        0,
        t29*(state4*t28 + t19 - t20*t21 + t24*t25 + t27),
        t29*(-state11*t32 + state5*t36 + t26*t35 + t31 + t34),
        t29*(-state12*t32 + state12*t33 + state6*t41 + t38 + t40),
        0,
        0,
        0,
        t11,
        t7,
        t13,
        t15,
        0,
        0,
        0,
        t29*(-state10*t43 - state3*t28 - t42 - t45 + t47),
        t29*(-state11*t43 + state6*t0*t2*t22 - t37 - t40 - t48),
        t29*(state11*state12*state6*t0*t22 - state12*t43 - state5*t41 - t31 - t49),
        0,
        0,
        0,
        t12,
        t16,
        t7,
        t11,
        0,
        0,
        0,
        t29*(state10*state12*state4*t0*t22 - state5*t50 - state6*t28 - t38 - t48),
        t29*(-state3*t36 - t20*t25 - t42 - t47 + t52),
        t29*(state4*t0*t22*t3 - t18 - t20*t44 - t27 - t53),
        0,
        0,
        0,
        t13,
        t12,
        t14,
        t7,
        0,
        0,
        0,
        t29*(state5*t0*t1*t22 - state6*t50 - t30 - t34 - t49),
        t29*(state10*state11*state5*t0*t22 - state4*t36 - t19 - t20*t46 - t53),
        t29*(-state3*t41 - t20*t26 - t42 + t45 - t52),
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
        1,
        0,
        0,
        0,
        0,
        0,
        0,
        1,
        state7,
        state8,
        state9,
        (state10*state4*t0*t22*t4)/8 + (-state10*t18)/8 + (state11*state5*t0*t22*t4)/8 + (-state11*t30)/8 + (state12*state6*t0*t22*t4)/8 + (-state12*t37)/8 + (-t32*t4)/8,
        (state10*state3*t8)/2 + (state11*state6*t0*t22*t4)/8 + (-state11*t37)/8 + (state12*state5*t8)/2 + (-t21*t54)/8 + (-t4*t43)/8 + (-t44*t54)/8,
        (-state10*state6*t54)/8 + (state10*state6*t8)/2 + (state11*state3*t8)/2 + (-state11*t56)/8 + (state12*state4*t0*t22*t4)/8 + (-state12*t18)/8 + (-state5*t55)/8,
        (state10*state5*t0*t22*t4)/8 + (-state10*t30)/8 + (-state11*state4*t54)/8 + (state11*state4*t8)/2 + (state12*state3*t8)/2 + (-state12*t56)/8 + (-state6*t55)/8,
        0,
        0,
        0,
        0,
        0,
        0,
    )
