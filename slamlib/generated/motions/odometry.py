"""Generated from slamlib/motions/odometry.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import stumpff

DIGESTS = {
    "step": "35381b6fd8552e29",
}
SHAPES = {
    "step": (7,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2, state3, state4, state5, state6 = state
    control0, control1, control2, control3, control4, control5 = control
    t0 = state3*state5
    t1 = state4*state6
    t2 = 2*control2
    t3 = state3*state6
    t4 = state4*state5
    t5 = 2*control1
    t6 = state4*state4
    t7 = state5*state5
    t8 = -t7
    t9 = state3*state3
    t10 = state6*state6
    t11 = -t10 + t9
    t12 = 2*control0
    t13 = state3*state4
    t14 = state5*state6
    t15 = -t6
    t16 = (control3*control3 + control4*control4 + control5*control5)/4
    t17 = stumpff(0, t16)
    t18 = stumpff(1, t16)/2
    t19 = control3*t18
    t20 = state5*t18
    t21 = state6*t18
    t22 = control4*t18
    t23 = control5*t18
    return (
        control0*(t11 + t6 + t8) + state0 + t2*(t0 + t1) - t5*(t3 - t4),
        control1*(t11 + t15 + t7) + state1 + t12*(t3 + t4) - t2*(t13 - t14),
        control2*(t10 + t15 + t8 + t9) + state2 - t12*(t0 - t1) + t5*(t13 + t14),
        -control4*t20 - control5*t21 + state3*t17 - state4*t19,
        -control4*t21 + control5*t20 + state3*t19 + state4*t17,
        state3*t22 - state4*t23 + state5*t17 + state6*t19,
        state3*t23 + state4*t22 - state5*t19 + state6*t17,
    )


def step_jac(state, control, dt):
    """step: value and Jacobians."""
    state0, state1, state2, state3, state4, state5, state6 = state
    control0, control1, control2, control3, control4, control5 = control
    t0 = state3*state5
    t1 = state4*state6
    t2 = t0 + t1
    t3 = 2*control2
    t4 = state3*state6
    t5 = state4*state5
    t6 = t4 - t5
    t7 = 2*control1
    t8 = state4*state4
    t9 = state5*state5
    t10 = -t9
    t11 = state3*state3
    t12 = state6*state6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*control0
    t17 = state3*state4
    t18 = state5*state6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = control3*control3
    t26 = control4*control4
    t27 = control5*control5
    t28 = t25/4 + t26/4 + t27/4
    t29 = stumpff(0, t28)
    t30 = stumpff(1, t28)
    t31 = control3*t30
    t32 = state4*t31
    t33 = state5*t30
    t34 = control4*t33
    t35 = state6*t30
    t36 = control5*t35
    t37 = state4*t29
    t38 = state3*t31
    t39 = control4*t35
    t40 = control5*t33
    t41 = state5*t29
    t42 = state6*t31
    t43 = control4*t30
    t44 = state3*t43
    t45 = control5*t30
    t46 = state4*t45
    t47 = state6*t29
    t48 = state5*t31
    t49 = state4*t43
    t50 = state3*t45
    t51 = control0*state6 + control1*state3 - control2*state4
    t52 = state5*t51
    t53 = control0*state3 - control1*state6 + control2*state5
    t54 = state4*t53
    t55 = control0*state4 + control1*state5 + control2*state6
    t56 = state3*t55
    t57 = -control0*state5 + control1*state4 + control2*state3
    t58 = state6*t57
    t59 = t56 + t58
    t60 = state6*t55
    t61 = state3*t57
    t62 = state4*t51 + state5*t53
    t63 = state3*t51
    t64 = state5*t55
    t65 = state4*t57 + state6*t53
    t66 = state4*t55
    t67 = state3*t53
    t68 = state5*t57 + state6*t51
    t69 = 2*state3*t29
    t70 = t34 + t36
    t71 = t32 - t69 + t70
    t72 = 2*t37
    t73 = t38 + t72
    t74 = -t39 + t40 + t73
    t75 = 2*t47
    t76 = t49 + t50
    t77 = -t48 + t75 + t76
    t78 = 2*t41
    t79 = t42 + t78
    t80 = t44 - t46 + t79
    t81 = 1/(t71*t71 + t74*t74 + t77*t77 + t80*t80)
    t82 = t39 - t40 + t73
    t83 = -t32 + t69 + t70
    t84 = t48 - t75 + t76
    t85 = -t44 + t46 + t79
    t86 = t39 + t40
    t87 = t38 - t72 + t86
    t88 = t48 + t75
    t89 = t49 - t50 + t88
    t90 = t44 + t46
    t91 = -t42 + t78 + t90
    t92 = t32 + t69
    t93 = -t34 + t36 + t92
    t94 = t42 - t78 + t90
    t95 = -t38 + t72 + t86
    t96 = t34 - t36 + t92
    t97 = -t49 + t50 + t88
    t98 = 4*state4*t30
    t99 = stumpff(2, t28) - stumpff(3, t28)
    t100 = -t99
    t101 = control3*t100
    t102 = control4*state5
    t103 = control5*t101
    t104 = state6*t103
    t105 = t100*t25
    t106 = state4*t105 + t101*t102 + t104 + 2*t38 + t98
    t107 = -4*state3*t30
    t108 = control3*t99
    t109 = control5*t108
    t110 = state5*t109
    t111 = t25*t99
    t112 = control4*t108
    t113 = state6*t112
    t114 = -state3*t111 - t107 - t110 + t113 - 2*t32
    t115 = -4*state6*t30
    t116 = state3*t112
    t117 = state4*t109
    t118 = -state6*t111 - t115 - t116 + t117 - 2*t48
    t119 = 4*t33
    t120 = control4*t101
    t121 = state4*t120
    t122 = -state3*t103 + state5*t105 + t119 - t121 + 2*t42
    t123 = t81/2
    t124 = control5*t100
    t125 = control4*state6
    t126 = t100*t26
    t127 = state5*t126 + t119 + t121 + t124*t125 + 2*t44
    t128 = t102*t124
    t129 = 4*t35
    t130 = t129 + 2*t49
    t131 = -state3*t120 + state6*t126 - t128 + t130
    t132 = t26*t99
    t133 = control5*t99
    t134 = control4*t133
    t135 = state4*t134
    t136 = state3*t132 + t107 + t113 - t135 + 2*t34
    t137 = -t136
    t138 = state3*t134
    t139 = -control3*control4*state5*t99 + state4*t132 - 4*state4*t30 + t138 + 2*t39
    t140 = -t139
    t141 = t100*t27
    t142 = state4*t103 + state6*t141 + t128 + t129 + 2*t50
    t143 = -4*state5*t30
    t144 = t27*t99
    t145 = t125*t133
    t146 = state3*t109 + state5*t144 + t143 - t145 + 2*t46
    t147 = -t146
    t148 = 2*t40 + t98
    t149 = -control4*state3*t124 + state4*t141 - t104 + t148
    t150 = state3*t144 + t107 - t110 + t135 + 2*t36
    t151 = -t150
    t152 = t102*t133
    return (
        control0*t14 + state0 + t2*t3 - t6*t7,
        control1*t21 + state1 + t15*t16 - t19*t3,
        control2*t24 + state2 - t16*t23 + t22*t7,
        state3*t29 + (-t32)/2 + (-t34)/2 + (-t36)/2,
        t37 + t38/2 + (-t39)/2 + t40/2,
        t41 + t42/2 + t44/2 + (-t46)/2,
        t47 + (-t48)/2 + t49/2 + t50/2,
        1,
        0,
        0,
        t52 - t54 + t59,
        -t60 + t61 - t62,
        -t63 + t64 - t65,
        0,
        1,
        0,
        t60 - t61 - t62,
        -t52 + t54 + t59,
        -t66 + t67 - t68,
        0,
        0,
        1,
        t63 - t64 - t65,
        t66 - t67 - t68,
        t52 + t54 + t56 - t58,
        0,
        0,
        0,
        t81*(-t71*t83 + t74*t82 - t77*t84 + t80*t85),
        t81*(t71*t89 + t74*t91 + t77*t93 + t80*t87),
        t81*(t71*t94 + t74*t97 - t77*t95 - t80*t96),
        0,
        0,
        0,
        t81*(t71*t84 - t74*t85 - t77*t83 + t80*t82),
        t81*(-t71*t93 - t74*t87 + t77*t89 + t80*t91),
        t81*(t71*t95 + t74*t96 + t77*t94 + t80*t97),
        0,
        0,
        0,
        t81*(t71*t85 + t74*t84 + t77*t82 + t80*t83),
        t81*(t71*t87 - t74*t93 + t77*t91 - t80*t89),
        t81*(-t71*t96 + t74*t95 + t77*t97 - t80*t94),
        t14,
        -2*t6,
        2*t2,
        0,
        0,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        0,
        0,
        -2*t23,
        2*t22,
        t24,
        0,
        0,
        0,
        0,
        0,
        0,
        t123*(t106*t74 - t114*t71 + t118*t77 + t122*t80),
        t123*(t127*t74 + t131*t71 + t137*t77 - t140*t80),
        t123*(t142*t74 - t147*t71 - t149*t77 - t151*t80),
        0,
        0,
        0,
        t123*(t106*t80 - t114*t77 - t118*t71 - t122*t74),
        t123*(t136*t71 - t139*t74 + t77*(-state6*t132 + t116 + t130 + t152) + t80*(2*control4*state3*t30 - state4*t112 - state5*t132 - t143 - t145)),
        t123*(t146*t77 - t150*t74 + t71*(-state4*t144 + state6*t109 + t138 + t148) + t80*(2*control5*state3*t30 - state6*t144 - t115 - t117 - t152)),
        0,
        0,
        0,
        t123*(t106*t77 + t114*t80 - t118*t74 + t122*t71),
        t123*(t127*t77 - t131*t80 - t137*t74 - t140*t71),
        t123*(t142*t77 + t147*t80 + t149*t74 - t151*t71),
        0,
        0,
        0,
        0,
        0,
        0,
    )


def step_storage_jac(state, control, dt):
    """step: value and derivatives by stored numbers."""
    state0, state1, state2, state3, state4, state5, state6 = state
    control0, control1, control2, control3, control4, control5 = control
    t0 = state3*state5
    t1 = state4*state6
    t2 = t0 + t1
    t3 = 2*control2
    t4 = state3*state6
    t5 = state4*state5
    t6 = t4 - t5
    t7 = 2*control1
    t8 = state4*state4
    t9 = state5*state5
    t10 = -t9
    t11 = state3*state3
    t12 = state6*state6
    t13 = t11 - t12
    t14 = t10 + t13 + t8
    t15 = t4 + t5
    t16 = 2*control0
    t17 = state3*state4
    t18 = state5*state6
    t19 = t17 - t18
    t20 = -t8
    t21 = t13 + t20 + t9
    t22 = t17 + t18
    t23 = t0 - t1
    t24 = t10 + t11 + t12 + t20
    t25 = control3*control3
    t26 = control4*control4
    t27 = control5*control5
    t28 = t25/4 + t26/4 + t27/4
    t29 = stumpff(0, t28)
    t30 = stumpff(1, t28)
    t31 = t30/2
    t32 = control3*t31
    t33 = control4*t31
    t34 = control5*t31
    t35 = control0*state3 - control1*state6 + control2*state5
    t36 = 2*t35
    t37 = 2*(control0*state4 + control1*state5 + control2*state6)
    t38 = -control0*state5 + control1*state4 + control2*state3
    t39 = 2*t38
    t40 = control0*state6 + control1*state3 - control2*state4
    t41 = 2*t40
    t42 = -t32
    t43 = -t33
    t44 = -t34
    t45 = 4*t30
    t46 = state4*t45
    t47 = -t46
    t48 = 2*t30
    t49 = control3*state3
    t50 = stumpff(2, t28) - stumpff(3, t28)
    t51 = control3*t50
    t52 = control4*state5
    t53 = control5*state6
    t54 = t51*t53
    t55 = t25*t50
    t56 = state5*t45
    t57 = -t56
    t58 = state3*t48
    t59 = state4*t51
    t60 = control4*t59
    t61 = control4*t50
    t62 = t26*t50
    t63 = state6*t45
    t64 = -t63
    t65 = control5*t50
    t66 = t52*t65
    t67 = t27*t50
    t68 = -4*state3*t30
    t69 = state4*t48
    t70 = control5*state5
    t71 = t51*t70
    t72 = control4*state6
    t73 = t51*t72
    t74 = t49*t61
    t75 = t49*t65
    t76 = control3*t48
    t77 = control5*t61
    t78 = state4*t77
    t79 = state3*t77
    return (
        control0*t14 + state0 + t2*t3 - t6*t7,
        control1*t21 + state1 + t15*t16 - t19*t3,
        control2*t24 + state2 - t16*t23 + t22*t7,
        state3*t29 - state4*t32 - state5*t33 - state6*t34,
        state3*t32 + state4*t29 + state5*t34 - state6*t33,
        state3*t33 - state4*t34 + state5*t29 + state6*t32,
        state3*t34 + state4*t33 - state5*t32 + state6*t29,
        1,
        0,
        0,
        t36,
        t37,
        t39,
        -2*t40,
        0,
        1,
        0,
        t41,
        -2*t38,
        t37,
        t36,
        0,
        0,
        1,
        t39,
        t41,
        -2*t35,
        t37,
        0,
        0,
        0,
        t29,
        t42,
        t43,
        t44,
        0,
        0,
        0,
        t32,
        t29,
        t34,
        t43,
        0,
        0,
        0,
        t33,
        t44,
        t29,
        t32,
        0,
        0,
        0,
        t34,
        t33,
        t42,
        t29,
        t14,
        -2*t6,
        2*t2,
        0,
        0,
        0,
        2*t15,
        t21,
        -2*t19,
        0,
        0,
        0,
        -2*t23,
        2*t22,
        t24,
        0,
        0,
        0,
        0,
        0,
        0,
        (state4*t55)/8 + t47/8 + (-t48*t49)/8 + (t51*t52)/8 + t54/8,
        (-control4*t58)/8 + (state5*t62)/8 + (t53*t61)/8 + t57/8 + t60/8,
        (-control5*t58)/8 + (control5*t59)/8 + (state6*t67)/8 + t64/8 + t66/8,
        0,
        0,
        0,
        (-control3*t69)/8 + (-state3*t55)/8 + (-t68)/8 + (-t71)/8 + t73/8,
        (-control4*t69)/8 + (state6*t26*t50)/8 + (-t63)/8 + (-t66)/8 + (-t74)/8,
        (control4*control5*state6*t50)/8 + (-control5*t69)/8 + (-state5*t67)/8 + (-t57)/8 + (-t75)/8,
        0,
        0,
        0,
        (control3*control5*state4*t50)/8 + (-state5*t76)/8 + (-state6*t55)/8 + (-t64)/8 + (-t74)/8,
        (-state3*t62)/8 + (-t48*t52)/8 + (-t68)/8 + (-t73)/8 + t78/8,
        (state4*t27*t50)/8 + (-t46)/8 + (-t48*t70)/8 + (-t54)/8 + (-t79)/8,
        0,
        0,
        0,
        (state5*t25*t50)/8 + (-state6*t76)/8 + (-t56)/8 + (-t60)/8 + (-t75)/8,
        (control3*control4*state5*t50)/8 + (-state4*t62)/8 + (-t47)/8 + (-t48*t72)/8 + (-t79)/8,
        (-state3*t67)/8 + (-t48*t53)/8 + (-t68)/8 + t71/8 + (-t78)/8,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    )
