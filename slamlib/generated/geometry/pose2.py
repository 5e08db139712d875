"""Generated from slamlib/geometry/pose2.py by `make generate` (sympy 1.14.0); never edited by hand."""

from slamlib.analytic import arctan2, cos, sin, stumpff

DIGESTS = {
    "from_frame": "1c856a63c92e7f75",
    "to_frame": "f73065ff66c76ac9",
    "compose": "56ed367c3192aee7",
    "inverse": "e5ccd6963dc0d8c1",
    "exponential": "801704b4f3605d00",
    "adjoint": "d8a95eb530f04652",
    "in_space": "10dfc44e1e06b956",
    "from_space": "741ea022a0c9def5",
}
SHAPES = {
    "from_frame": (2,),
    "to_frame": (2,),
    "compose": (3,),
    "inverse": (3,),
    "exponential": (3,),
    "adjoint": (3, 3),
    "in_space": (7,),
    "from_space": (3,),
}


def from_frame(pose, point):
    """from_frame: value."""
    pose0, pose1, pose2 = pose
    point0, point1 = point
    t0 = cos(pose2)
    t1 = sin(pose2)
    return (
        point0*t0 - point1*t1 + pose0,
        point0*t1 + point1*t0 + pose1,
    )


def from_frame_jac(pose, point):
    """from_frame: value and Jacobians."""
    pose0, pose1, pose2 = pose
    point0, point1 = point
    t0 = cos(pose2)
    t1 = sin(pose2)
    t2 = point0*t0 - point1*t1
    t3 = point0*t1 + point1*t0
    return (
        pose0 + t2,
        pose1 + t3,
        1,
        0,
        -t3,
        0,
        1,
        t2,
        t0,
        -t1,
        t1,
        t0,
    )


def to_frame(pose, point):
    """to_frame: value."""
    pose0, pose1, pose2 = pose
    point0, point1 = point
    t0 = cos(pose2)
    t1 = point0 - pose0
    t2 = sin(pose2)
    t3 = point1 - pose1
    return (
        t0*t1 + t2*t3,
        t0*t3 - t1*t2,
    )


def to_frame_jac(pose, point):
    """to_frame: value and Jacobians."""
    pose0, pose1, pose2 = pose
    point0, point1 = point
    t0 = cos(pose2)
    t1 = point0 - pose0
    t2 = sin(pose2)
    t3 = point1 - pose1
    t4 = t0*t1 + t2*t3
    t5 = t0*t3 - t1*t2
    t6 = -t0
    t7 = -t2
    return (
        t4,
        t5,
        t6,
        t7,
        t5,
        t2,
        t6,
        -t4,
        t0,
        t2,
        t7,
        t0,
    )


def compose(outer, inner):
    """compose: value."""
    outer0, outer1, outer2 = outer
    inner0, inner1, inner2 = inner
    t0 = cos(outer2)
    t1 = sin(outer2)
    return (
        inner0*t0 - inner1*t1 + outer0,
        inner0*t1 + inner1*t0 + outer1,
        inner2 + outer2,
    )


def compose_jac(outer, inner):
    """compose: value and Jacobians."""
    outer0, outer1, outer2 = outer
    inner0, inner1, inner2 = inner
    t0 = cos(outer2)
    t1 = sin(outer2)
    t2 = inner0*t0 - inner1*t1
    t3 = inner0*t1 + inner1*t0
    return (
        outer0 + t2,
        outer1 + t3,
        inner2 + outer2,
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
    )


def inverse(pose):
    """inverse: value."""
    pose0, pose1, pose2 = pose
    t0 = cos(pose2)
    t1 = sin(pose2)
    return (
        -pose0*t0 - pose1*t1,
        pose0*t1 - pose1*t0,
        -pose2,
    )


def inverse_jac(pose):
    """inverse: value and Jacobians."""
    pose0, pose1, pose2 = pose
    t0 = cos(pose2)
    t1 = sin(pose2)
    t2 = pose0*t0 + pose1*t1
    t3 = pose0*t1 - pose1*t0
    t4 = -t0
    return (
        -t2,
        t3,
        -pose2,
        t4,
        -t1,
        t3,
        t1,
        t4,
        t2,
        0,
        0,
        -1,
    )


def exponential(twist):
    """exponential: value."""
    twist0, twist1, twist2 = twist
    t0 = twist2*twist2
    t1 = stumpff(1, t0)
    t2 = stumpff(2, t0)*twist2
    return (
        t1*twist0 - t2*twist1,
        t1*twist1 + t2*twist0,
        twist2,
    )


def exponential_jac(twist):
    """exponential: value and Jacobians."""
    twist0, twist1, twist2 = twist
    t0 = twist2*twist2
    t1 = stumpff(1, t0)
    t2 = stumpff(2, t0)
    t3 = t2*twist2
    t4 = stumpff(3, t0)
    t5 = stumpff(4, t0)
    t6 = t5 + t5
    t7 = t4 - t6
    t8 = (t2 - t4)*twist2
    return (
        t1*twist0 - t3*twist1,
        t1*twist1 + t3*twist0,
        twist2,
        t1,
        -t3,
        t0*t7*twist1 - t2*twist1 - t8*twist0,
        t3,
        t1,
        -t0*t7*twist0 + t2*twist0 - t8*twist1,
        0,
        0,
        1,
    )


def adjoint(pose):
    """adjoint: value."""
    pose0, pose1, pose2 = pose
    t0 = cos(pose2)
    t1 = sin(pose2)
    return (
        t0,
        -t1,
        pose1,
        t1,
        t0,
        -pose0,
        0,
        0,
        1,
    )


def adjoint_jac(pose):
    """adjoint: value and Jacobians."""
    pose0, pose1, pose2 = pose
    t0 = cos(pose2)
    t1 = sin(pose2)
    t2 = -t1
    return (
        t0,
        t2,
        pose1,
        t1,
        t0,
        -pose0,
        0,
        0,
        1,
        0,
        0,
        t2,
        0,
        0,
        -t0,
        0,
        1,
        0,
        0,
        0,
        t0,
        0,
        0,
        t2,
        -1,
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
    )


def in_space(state):
    """in_space: value."""
    state0, state1, state2 = state
    t0 = state2/2
    return (
        state0,
        state1,
        0,
        cos(t0),
        0,
        0,
        sin(t0),
    )


def in_space_jac(state):
    """in_space: value and Jacobians."""
    state0, state1, state2 = state
    t0 = state2/2
    return (
        state0,
        state1,
        0,
        cos(t0),
        0,
        0,
        sin(t0),
        1,
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
    )


def from_space(pose):
    """from_space: value."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    t0 = pose3*pose6 + pose4*pose5
    t1 = t0 + t0
    t2 = pose3*pose3
    t3 = pose4*pose4
    t4 = pose5*pose5
    t5 = pose6*pose6
    return (
        pose0,
        pose1,
        arctan2(t1, t2 + t3 - t4 - t5),
    )


def from_space_jac(pose):
    """from_space: value and Jacobians."""
    pose0, pose1, _, pose3, pose4, pose5, pose6 = pose
    t0 = pose3*pose6 + pose4*pose5
    t1 = t0 + t0
    t2 = pose3*pose3
    t3 = pose4*pose4
    t4 = pose5*pose5
    t5 = pose6*pose6
    t6 = t2 + t3 - t4 - t5
    t7 = t0*t0
    t8 = t6*t6
    t9 = 4*t7 + t8
    t10 = 1/t9
    t11 = pose4*t6 + pose5*t1
    t12 = pose3*t6 + pose6*t1
    t13 = pose3*t1 - pose6*t6
    t14 = pose4*t1 - pose5*t6
    return (
        pose0,
        pose1,
        arctan2(t1, t6),
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
        0,
        0,
        (pose3*t11 + pose4*t12 + pose5*t13 + pose6*t14)*t10,
        (pose3*t12 - pose4*t11 - pose5*t14 + pose6*t13)*t10,
    )
