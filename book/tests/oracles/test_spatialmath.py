"""Rotations and twists beside Spatial Math (Corke, github.com/bdaiinstitute/spatialmath-python).

Run by `python -m book.tools.oracles`. Its functions take what is shorter than 4e-15 for zero, and its logarithm near
half a turn for half a turn.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.geometry import euler, pose, pose2, quaternion
from slamlib.tests.peers import NUMBERS, PLANAR, POSES, QUATERNIONS, several, skew, turns, twisted

REASON = "spatialmath is fetched by `python -m book.tools.oracles`, which runs these tests"
base = pytest.importorskip("spatialmath.base", reason=REASON)
many = settings(max_examples=60, deadline=None, derandomize=True)


def close(found, wanted, tolerance=1e-12):
    np.testing.assert_allclose(found, wanted, rtol=tolerance, atol=tolerance)


def rigid(point):
    """Its matrix of our pose."""
    if len(point) == 3:
        return base.rt2tr(base.rot2(point[2]), point[:2])
    return base.rt2tr(base.q2r(point[3:]), point[:3])


@many
@given(p=QUATERNIONS, q=QUATERNIONS, point=several(NUMBERS, 3))
def test_quaternions(p, q, point):
    close(quaternion.product(p, q), base.qqmul(p, q))
    close(quaternion.conjugate(q), base.qconj(q))
    close(quaternion.left_matrix(q) @ p, base.qqmul(q, p))
    close(quaternion.right_matrix(q) @ p, base.qqmul(p, q))
    close(quaternion.pi_matrix(q) @ point, 2 * base.qdotb(q, point))
    close(quaternion.rotation(q), base.q2r(q))
    close(pose.from_frame(np.append(np.zeros(3), q), point), base.qvmul(q, point), 1e-11)
    found = quaternion.from_rotation(base.q2r(q), quaternion.best_pivot(base.q2r(q)))
    close(np.abs(found @ base.r2q(base.q2r(q))), 1.0, 1e-7)  # its square roots of differences: half the digits


@many
@given(v=turns())
def test_exponential_and_logarithm(v):
    """With the Jacobian of the exponential: its own is from the rates of v to a turn about the world's axes."""
    q, J = quaternion.exponential.jac(v)
    close(quaternion.rotation(q), base.trexp(skew(v)))
    about_own = 2 * (quaternion.left_matrix(q).T @ J.vector)[1:]
    length = np.linalg.norm(v)
    if length > 1e-4:  # it divides by the length, and by its square
        close(quaternion.rotation(q) @ about_own, base.exp2jac(v), 1e-7)
    if length < 3.1:
        close(quaternion.logarithm(q), base.trlog(base.q2r(q), twist=True), 1e-7)  # by the arc cosine of the trace


@many
@given(p=QUATERNIONS, q=QUATERNIONS, share=st.floats(0, 1))
def test_slerp(p, q, share):
    found = quaternion.slerp(p, q, share)
    if np.abs(p @ q) > 0.01:  # else either way is as short
        wanted = base.qslerp(p, q, share, shortest=True)
        close(np.abs(found @ wanted), 1.0)


@many
@given(angles=several(st.floats(-1.5, 1.5), 3))
def test_euler_angles(angles):
    close(euler.to_rotation(angles), base.rpy2r(angles, order="zyx"))
    close(euler.from_rotation(base.rpy2r(angles)), base.tr2rpy(base.rpy2r(angles)), 1e-9)
    found, J = euler.from_quaternion_jac(euler.to_quaternion(angles))
    close(found, angles, 1e-9)
    # Its Jacobian is from rates of angles to a turn about the world's axes
    close(J, np.linalg.inv(euler.to_rotation(angles).T @ base.rpy2jac(angles)), 1e-9)


@many
@given(a=PLANAR, b=PLANAR, twist=PLANAR.filter(lambda twist: np.abs(twist[2]) > 1e-4 or twist[2] == 0))
def test_poses_in_the_plane(a, b, twist):
    close(rigid(pose2.compose(a, b)), rigid(a) @ rigid(b), 1e-11)
    close(rigid(pose2.inverse(a)), base.trinv2(rigid(a)))
    close(rigid(pose2.exponential(twist)), base.trexp2(twisted(twist)), 1e-11)
    close(pose2.adjoint(a), base.tr2adjoint2(rigid(a)))
    if 0 < np.abs(twist[2]) < np.pi / 2:  # beyond, its arc tangent is of the wrong quadrant
        close(twist, base.trlog2(rigid(pose2.exponential(twist)), twist=True), 1e-9)


@many
@given(a=POSES, b=POSES)
def test_poses_in_space(a, b):
    close(rigid(pose.compose(a, b)), rigid(a) @ rigid(b))
    close(rigid(pose.inverse(a)), base.trinv(rigid(a)))
    close(rigid(pose.relative(a, b)), base.trinv(rigid(a)) @ rigid(b))


@many
@given(a=POSES, v=turns(3.0), d=several(NUMBERS, 3))
def test_twists_in_space(a, v, d):
    """Its exponential and logarithm divide by the angle and its square: shorter ones are compared more coarsely."""
    digits = 1e-11 if np.linalg.norm(v) > 1e-3 else 1e-6
    twist = np.append(d, v)
    close(rigid(pose.exponential(twist)), base.trexp(twisted(twist)), digits)
    close(pose.adjoint(a), base.tr2adjoint(rigid(a)), 1e-11)
    if np.linalg.norm(v) > 1e-3:
        close(pose.logarithm(pose.exponential(twist)), base.trlog(rigid(pose.exponential(twist)), twist=True), 1e-8)
