"""Generated from slamlib/motions/plane_odometry.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import cos, sin

DIGESTS = {
    "step": "cf9c1053dbf721a7",
}
SHAPES = {
    "step": (3,),
}


def step(state, control, dt):
    """step: value."""
    state0, state1, state2 = state
    control0, control1, control2 = control
    t0 = cos(state2)
    t1 = sin(state2)
    return (
        control0*t0 - control1*t1 + state0,
        control0*t1 + control1*t0 + state1,
        control2 + state2,
    )


def step_jac(state, control, dt):
    """step: value and Jacobians."""
    state0, state1, state2 = state
    control0, control1, control2 = control
    t0 = cos(state2)
    t1 = sin(state2)
    t2 = control0*t0 - control1*t1
    t3 = control0*t1 + control1*t0
    return (
        state0 + t2,
        state1 + t3,
        control2 + state2,
        1,
        0,
        -t3,
        0,
        1,
        t2,
        0,
        0,
        1,
        t0,
        -t1,
        0,
        t1,
        t0,
        0,
        0,
        0,
        1,
        0,
        0,
        0,
    )
