"""Generated from slamlib/motions/unicycle.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import cos, sin, stumpff

DIGESTS = {
    "step": "ba1c92ccee8116ee",
}
SHAPES = {
    "step": (3,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2 = state
    control0, control1 = control
    dt, = dt
    t0 = dt*dt
    t1 = control1*control1
    t2 = t0*t1
    inner0 = control0*dt*stumpff(1, t2)
    t3 = cos(state2)
    inner1 = control0*control1*stumpff(2, t2)*t0
    t4 = sin(state2)
    return (
        inner0*t3 - inner1*t4 + state0,
        inner0*t4 + inner1*t3 + state1,
        control1*dt + state2,
    )


def step_jac(state, control, dt):
    """step: value and Jacobians."""
    state0, state1, state2 = state
    control0, control1 = control
    dt, = dt
    t0 = dt*dt
    t1 = control1*control1
    t2 = t0*t1
    t3 = stumpff(1, t2)
    inner0 = control0*dt*t3
    t4 = cos(state2)
    t5 = stumpff(2, t2)
    t6 = control0*t0
    inner1 = control1*t5*t6
    t7 = sin(state2)
    t8 = inner0*t4 - inner1*t7
    t9 = inner0*t7 + inner1*t4
    t10 = control1*dt
    t11 = t10*t5
    t12 = stumpff(3, t2)
    t13 = -t12 + t5
    t14 = t10*t13
    t15 = stumpff(4, t2)
    t16 = t15 + t15
    t17 = (t12 - t16)*t2
    t18 = -t17 + t5
    t19 = t13*t2 - t3
    t20 = t5 + t5
    t21 = t17 - t20
    return (
        state0 + t8,
        state1 + t9,
        state2 + t10,
        1,
        0,
        -t9,
        0,
        1,
        t8,
        0,
        0,
        1,
        -(t11*t7 - t3*t4)*dt,
        -(t14*t4 + t18*t7)*t6,
        (t11*t4 + t3*t7)*dt,
        -(t14*t7 - t18*t4)*t6,
        0,
        dt,
        -(t19*t4 - t10*t21*t7)*control0,
        (-t19*t7 - t10*t21*t4)*control0,
        control1,
    )
