"""Generated from slamlib/motions/constant_velocity.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import stumpff

DIGESTS = {
    "step": "df7881d3d7d03508",
}
SHAPES = {
    "step": (13,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2, state3, state4, state5, state6, state7, state8, state9, state10, state11, state12 = state
    control0, control1, control2, control3, control4, control5 = control
    dt, = dt
    t0 = dt*dt
    t1 = state10*state10
    t2 = state11*state11
    t3 = state12*state12
    t4 = ((t1 + t2 + t3)*t0)/4
    right0 = stumpff(0, t4)
    t5 = (dt*stumpff(1, t4))/2
    right1 = state10*t5
    right2 = state11*t5
    right3 = state12*t5
    return (
        dt*state7 + state0,
        dt*state8 + state1,
        dt*state9 + state2,
        right0*state3 - right1*state4 - right2*state5 - right3*state6,
        right0*state4 + right1*state3 - right2*state6 + right3*state5,
        right0*state5 + right1*state6 + right2*state3 - right3*state4,
        right0*state6 - right1*state5 + right2*state4 + right3*state3,
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
    t7 = stumpff(1, t6)
    t8 = dt*t7
    t9 = t8/2
    right1 = state10*t9
    t10 = right1*state4
    right0 = stumpff(0, t6)
    t11 = right0*state3
    right2 = state11*t9
    t12 = right2*state5
    right3 = state12*t9
    t13 = right3*state6
    t14 = t12 + t13
    t15 = t10 - t11 + t14
    t16 = right3*state5
    t17 = right2*state6
    t18 = right0*state4
    t19 = right1*state3
    t20 = t18 + t19
    t21 = t16 - t17 + t20
    t22 = right2*state3
    t23 = right3*state4
    t24 = right0*state5
    t25 = right1*state6
    t26 = t24 + t25
    t27 = t22 - t23 + t26
    t28 = right0*state6
    t29 = right1*state5
    t30 = right2*state4
    t31 = right3*state3
    t32 = t30 + t31
    t33 = t28 - t29 + t32
    t34 = t15*t15
    t35 = t21*t21
    t36 = t27*t27
    t37 = t33*t33
    t38 = t34 + t35 + t36 + t37
    t39 = 1/t38
    t40 = -t10 + t11 + t14
    t41 = -t16 + t17 + t20
    t42 = -t22 + t23 + t26
    t43 = -t28 + t29 + t32
    t44 = t28 + t29
    t45 = t30 - t31 + t44
    t46 = t22 + t23
    t47 = t24 - t25 + t46
    t48 = t16 + t17
    t49 = -t18 + t19 + t48
    t50 = t10 + t11
    t51 = -t12 + t13 + t50
    t52 = -t24 + t25 + t46
    t53 = -t30 + t31 + t44
    t54 = t12 - t13 + t50
    t55 = t18 - t19 + t48
    t56 = t39/4
    t57 = dt*t56
    t58 = dt + dt
    t59 = stumpff(2, t6) - stumpff(3, t6)
    t60 = t0*t59
    t61 = 4*t7
    t62 = -t61
    t63 = -t1*t60 - t62
    t64 = state10*state6
    t65 = state11*t60
    t66 = t64*t65
    t67 = state12*t60
    t68 = state10*state5
    t69 = t67*t68
    t70 = t58*state10*state4*t7 - state3*t63 - t66 + t69
    t71 = t8 + t8
    t72 = state10*state3
    t73 = state11*state5
    t74 = state10*t60
    t75 = t73*t74
    t76 = state12*state6
    t77 = t74*t76
    t78 = -state4*t63 - t71*t72 + t75 + t77
    t79 = state10*state4
    t80 = t65*t79
    t81 = t67*t72
    t82 = state5*t63 + t64*t71 + t80 + t81
    t83 = t65*t72
    t84 = t67*t79
    t85 = -state6*t63 + t68*t71 + t83 - t84
    t86 = state11*t71
    t87 = -t2*t60 - t62
    t88 = t67*t73
    t89 = state4*t86 + state6*t87 + t83 + t88
    t90 = t65*t76
    t91 = -state3*t86 - state5*t87 + t80 + t90
    t92 = state12*t65
    t93 = state3*t92
    t94 = t58*state11*state6*t7 - state4*t87 - t75 + t93
    t95 = -state4*t92
    t96 = -state3*t87 + t71*t73 + t66 + t95
    t97 = state12*t71
    t98 = -t3*t60 - t62
    t99 = state4*t97 - state5*t98 + t81 - t90
    t100 = -state3*t97 - state6*t98 + t84 + t88
    t101 = t58*state12*state6*t7 - state3*t98 - t69 - t95
    t102 = state4*t98 + state5*t97 + t77 + t93
    t103 = -t0*t59
    t104 = state12*t103
    t105 = state11*t104
    t106 = t104*t68
    t107 = t5*t59 + t62
    t108 = t58*state3*t4*t7 - t107*t79 - t107*t73 - t107*t76
    t109 = -t107
    t110 = state10*t109
    t111 = t4*t71
    t112 = state12*t109
    t113 = state11*t109
    t114 = -state3*t110 + state4*t111 - state5*t112 + state6*t113
    t115 = -state3*t112 - state4*t113 + state5*t110 + state6*t111
    t116 = -state3*t113 + state4*t112 + state5*t111 - state6*t110
    return (
        dt*state7 + state0,
        dt*state8 + state1,
        dt*state9 + state2,
        -t15,
        t21,
        t27,
        t33,
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
        -(t15*t40 - t21*t41 - t27*t42 + t33*t43)*t39,
        (t15*t45 + t21*t47 + t27*t49 + t33*t51)*t39,
        (t15*t52 + t21*t53 - t27*t54 - t33*t55)*t39,
        0,
        0,
        0,
        (t15*t70 - t21*t78 + t27*t82 - t33*t85)*t57,
        (t15*t89 - t21*t91 + t27*t94 - t33*t96)*t57,
        (t15*t99 - t100*t21 + t101*t27 - t102*t33)*t57,
        0,
        0,
        0,
        (t15*t43 - t21*t42 + t27*t41 - t33*t40)*t39,
        -(t15*t51 + t21*t49 - t27*t47 - t33*t45)*t39,
        (t15*t55 + t21*t54 + t27*t53 + t33*t52)*t39,
        0,
        0,
        0,
        (t15*t85 - t21*t82 - t27*t78 + t33*t70)*t57,
        -(-t15*t96 + (state10*t103*t73 - state3*t105 - (t103*t2 + t61)*state4 + state6*t86)*t21 + t27*t91 - t33*t89)*t57,
        -(-t102*t15 + (-(t103*t3 + t61)*state3 - state4*t105 + t106 + t71*t76)*t21 + t100*t27 - t33*t99)*t57,
        0,
        0,
        0,
        (t15*t42 + t21*t43 + t27*t40 + t33*t41)*t39,
        (t15*t49 - t21*t51 - t27*t45 + t33*t47)*t39,
        -(t15*t54 - t21*t55 + t27*t52 - t33*t53)*t39,
        0,
        0,
        0,
        -(-t15*t82 - t21*t85 + (state11*t103*t64 - (t1*t103 + t61)*state3 - t106 + t71*t79)*t27 + t33*t78)*t57,
        (t15*t94 + t21*t96 - t27*t89 - t33*t91)*t57,
        (t101*t15 + t102*t21 - t27*t99 - t100*t33)*t57,
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
        (t108*t21 + t114*t15 + t115*t27 - t116*t33)*t56,
        (t108*t27 + t114*t33 - t115*t21 + t116*t15)*t56,
        (t108*t33 - t114*t27 + t115*t15 + t116*t21)*t56,
        0,
        0,
        0,
        0,
        0,
        0,
    )
