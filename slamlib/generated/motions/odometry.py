"""Generated from slamlib/motions/odometry.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import stumpff

DIGESTS = {
    "step": "bb3687bae2036f95",
}
SHAPES = {
    "step": (7,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2, state3, state4, state5, state6 = state
    control0, control1, control2, control3, control4, control5 = control
    t0 = state5*state5
    t1 = -t0
    t2 = state3*state3
    t3 = state6*state6
    t4 = t2 - t3
    t5 = state4*state4
    t6 = control2 + control2
    t7 = state3*state5
    t8 = state4*state6
    t9 = control1 + control1
    t10 = state3*state6
    t11 = state4*state5
    t12 = -t5
    t13 = control0 + control0
    t14 = state3*state4
    t15 = state5*state6
    t16 = control3*control3
    t17 = control4*control4
    t18 = control5*control5
    t19 = (t16 + t17 + t18)/4
    right0 = stumpff(0, t19)
    t20 = stumpff(1, t19)/2
    right1 = control3*t20
    right2 = control4*t20
    right3 = control5*t20
    return (
        (t1 + t4 + t5)*control0 + state0 + (t7 + t8)*t6 - (t10 - t11)*t9,
        (t4 + t12 + t0)*control1 + state1 + (t10 + t11)*t13 - (t14 - t15)*t6,
        (t1 + t2 + t3 + t12)*control2 + state2 - (t7 - t8)*t13 + (t14 + t15)*t9,
        right0*state3 - right1*state4 - right2*state5 - right3*state6,
        right0*state4 + right1*state3 - right2*state6 + right3*state5,
        right0*state5 + right1*state6 + right2*state3 - right3*state4,
        right0*state6 - right1*state5 + right2*state4 + right3*state3,
    )


def step_jac(state, control, dt):
    """step: value and Jacobians."""
    state0, state1, state2, state3, state4, state5, state6 = state
    control0, control1, control2, control3, control4, control5 = control
    t0 = state4*state4
    t1 = state5*state5
    t2 = -t1
    t3 = state3*state3
    t4 = state6*state6
    t5 = t3 - t4
    t6 = t0 + t2 + t5
    t7 = state3*state6
    t8 = state4*state5
    t9 = t7 - t8
    t10 = control1 + control1
    t11 = state3*state5
    t12 = state4*state6
    t13 = t11 + t12
    t14 = control2 + control2
    t15 = -t0
    t16 = t1 + t5 + t15
    t17 = t7 + t8
    t18 = control0 + control0
    t19 = state3*state4
    t20 = state5*state6
    t21 = t19 - t20
    t22 = t2 + t3 + t4 + t15
    t23 = t19 + t20
    t24 = t11 - t12
    t25 = control3*control3
    t26 = control4*control4
    t27 = control5*control5
    t28 = t25/4 + t26/4 + t27/4
    t29 = stumpff(1, t28)
    t30 = t29/2
    right1 = control3*t30
    t31 = right1*state4
    right0 = stumpff(0, t28)
    t32 = right0*state3
    right2 = control4*t30
    t33 = right2*state5
    right3 = control5*t30
    t34 = right3*state6
    t35 = t33 + t34
    t36 = t31 - t32 + t35
    t37 = right3*state5
    t38 = right2*state6
    t39 = right0*state4
    t40 = right1*state3
    t41 = t39 + t40
    t42 = t37 - t38 + t41
    t43 = right2*state3
    t44 = right3*state4
    t45 = right0*state5
    t46 = right1*state6
    t47 = t45 + t46
    t48 = t43 - t44 + t47
    t49 = right0*state6
    t50 = right1*state5
    t51 = right2*state4
    t52 = right3*state3
    t53 = t51 + t52
    t54 = t49 - t50 + t53
    t55 = control0*state6 + control1*state3 - control2*state4
    t56 = state5*t55
    t57 = control0*state3 - control1*state6 + control2*state5
    t58 = state4*t57
    t59 = control0*state4 + control1*state5 + control2*state6
    t60 = state3*t59
    t61 = -control0*state5 + control1*state4 + control2*state3
    t62 = state6*t61
    t63 = t60 + t62
    t64 = state6*t59
    t65 = state3*t61
    t66 = state4*t55 + state5*t57
    t67 = state3*t55
    t68 = state5*t59
    t69 = state4*t61 + state6*t57
    t70 = state4*t59
    t71 = state3*t57
    t72 = state5*t61 + state6*t55
    t73 = t36*t36
    t74 = t42*t42
    t75 = t48*t48
    t76 = t54*t54
    t77 = t73 + t74 + t75 + t76
    t78 = 1/t77
    t79 = -t31 + t32 + t35
    t80 = -t37 + t38 + t41
    t81 = -t43 + t44 + t47
    t82 = -t49 + t50 + t53
    t83 = t49 + t50
    t84 = t51 - t52 + t83
    t85 = t43 + t44
    t86 = t45 - t46 + t85
    t87 = t37 + t38
    t88 = -t39 + t40 + t87
    t89 = t31 + t32
    t90 = -t33 + t34 + t89
    t91 = -t45 + t46 + t85
    t92 = -t51 + t52 + t83
    t93 = t33 - t34 + t89
    t94 = t39 - t40 + t87
    t95 = t9 + t9
    t96 = t13 + t13
    t97 = t17 + t17
    t98 = t21 + t21
    t99 = t24 + t24
    t100 = t23 + t23
    t101 = t78/4
    t102 = stumpff(2, t28) - stumpff(3, t28)
    t103 = -4*t29
    t104 = -t102*t25 - t103
    t105 = control3*state6
    t106 = t29 + t29
    t107 = control3*t102
    t108 = control4*state4
    t109 = t107*t108
    t110 = control5*t107
    t111 = state3*t110
    t112 = state5*t104 + t105*t106 + t109 + t111
    t113 = control3 + control3
    t114 = t102*t105
    t115 = control4*t114
    t116 = state5*t110
    t117 = t113*state4*t29 - state3*t104 - t115 + t116
    t118 = control3*t106
    t119 = control4*t107
    t120 = state5*t119
    t121 = control5*t114
    t122 = -state3*t118 - state4*t104 + t120 + t121
    t123 = state3*t119
    t124 = state4*t110
    t125 = state5*t118 - state6*t104 + t123 - t124
    t126 = -t102*t26 - t103
    t127 = control5*t102
    t128 = control4*t127
    t129 = state5*t128
    t130 = state6*t126 + t123 + t129 + t106*t108
    t131 = control4*t106
    t132 = state6*t128
    t133 = -state3*t131 - state5*t126 + t132 + t109
    t134 = control4 + control4
    t135 = state3*t128
    t136 = t134*state6*t29 - state4*t126 - t120 + t135
    t137 = -t108*t127
    t138 = -state3*t126 + state5*t131 + t115 + t137
    t139 = -t102*t27 - t103
    t140 = control5*t106
    t141 = state4*t139 + state5*t140 + t121 + t135
    t142 = state4*t140 - state5*t139 - t132 + t111
    t143 = -state3*t140 - state6*t139 + t124 + t129
    t144 = control5 + control5
    t145 = t144*state6*t29 - state3*t139 - t116 - t137
    t146 = -t102
    t147 = control4*t146
    t148 = 4*t29
    t149 = control3*state5
    t150 = control5*t146
    t151 = t149*t150
    return (
        control0*t6 + state0 - t10*t9 + t13*t14,
        control1*t16 + state1 + t17*t18 - t14*t21,
        control2*t22 + state2 + t10*t23 - t18*t24,
        -t36,
        t42,
        t48,
        t54,
        1,
        0,
        0,
        t56 - t58 + t63,
        -t64 + t65 - t66,
        -t67 + t68 - t69,
        0,
        1,
        0,
        t64 - t65 - t66,
        -t56 + t58 + t63,
        -t70 + t71 - t72,
        0,
        0,
        1,
        t67 - t68 - t69,
        t70 - t71 - t72,
        t56 + t58 + t60 - t62,
        0,
        0,
        0,
        -(t36*t79 - t42*t80 - t48*t81 + t54*t82)*t78,
        (t36*t84 + t42*t86 + t48*t88 + t54*t90)*t78,
        (t36*t91 + t42*t92 - t48*t93 - t54*t94)*t78,
        0,
        0,
        0,
        (t36*t82 - t42*t81 + t48*t80 - t54*t79)*t78,
        -(t36*t90 + t42*t88 - t48*t86 - t54*t84)*t78,
        (t36*t94 + t42*t93 + t48*t92 + t54*t91)*t78,
        0,
        0,
        0,
        (t36*t81 + t42*t82 + t48*t79 + t54*t80)*t78,
        (t36*t88 - t42*t90 - t48*t84 + t54*t86)*t78,
        -(t36*t93 - t42*t94 + t48*t91 - t54*t92)*t78,
        t6,
        -t95,
        t96,
        0,
        0,
        0,
        t97,
        t16,
        -t98,
        0,
        0,
        0,
        -t99,
        t100,
        t22,
        0,
        0,
        0,
        0,
        0,
        0,
        (t112*t48 + t117*t36 - t122*t42 - t125*t54)*t101,
        (t130*t36 - t133*t42 + t136*t48 - t138*t54)*t101,
        (-t141*t54 + t142*t36 - t143*t42 + t145*t48)*t101,
        0,
        0,
        0,
        (-t112*t42 + t117*t54 - t122*t48 + t125*t36)*t101,
        -(-t130*t54 + t133*t48 - t138*t36 + (-control5*state3*t147 - (t146*t26 + t148)*state4 + state6*t131 + t147*t149)*t42)*t101,
        -(-t141*t36 - t142*t54 + t143*t48 + (-(t146*t27 + t148)*state3 + state6*t140 - t108*t150 + t151)*t42)*t101,
        0,
        0,
        0,
        -(-t112*t36 + t122*t54 - t125*t42 + (-(t146*t25 + t148)*state3 + state4*t118 + t105*t147 - t151)*t48)*t101,
        (-t130*t48 - t133*t54 + t136*t36 + t138*t42)*t101,
        (t141*t42 - t142*t48 - t143*t54 + t145*t36)*t101,
        0,
        0,
        0,
        0,
        0,
        0,
    )
