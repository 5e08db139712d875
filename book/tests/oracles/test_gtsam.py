"""Poses, lenses and their Jacobians beside GTSAM (github.com/borglab/gtsam); `python -m book.tools.oracles`.

GTSAM moves a pose by a twist in its own axes, rotation first (in the plane last); ours is a displacement along the
world's axes, then a rotation. `own` is the matrix from the former to the latter.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.belief import Belief
from slamlib.evaluation.alignment import align, nearest_rotation
from slamlib.geometry import euler, pose, pose2, quaternion
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose2 import Pose2
from slamlib.sensors import Calibration, brown, fisheye, pinhole, plane_range_bearing, range_bearing, stereo, unified
from slamlib.tests.peers import NUMBERS, PLANAR, POSES, QUATERNIONS, SEEDS, covariance, several, turns, with_jacobians

REASON = "gtsam is fetched by `python -m book.tools.oracles`, on CPython 3.11 and Linux (x86-64) alone"
gtsam = pytest.importorskip("gtsam", reason=REASON)
many = settings(max_examples=60, deadline=None, derandomize=True)
K = np.array([320.0, 240.0, 500.0, 510.0])
POINTS = st.tuples(several(NUMBERS, 2), st.floats(0.3, 9.0)).map(lambda pair: np.append(*pair))


def close(found, wanted, tolerance=1e-12):
    """To so many digits of the largest of the numbers."""
    size = max(1.0, np.abs(wanted).max(initial=0))
    np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance * size)


def slots(rows, *columns):
    """Arrays that GTSAM writes Jacobians into."""
    return [np.zeros((rows, n), order="F") for n in columns]


def rot3(q):
    return gtsam.Rot3.Quaternion(*q)


def theirs(point):
    """Our pose in space or in the plane as GTSAM's."""
    return gtsam.Pose2(*point) if len(point) == 3 else gtsam.Pose3(rot3(point[3:]), point[:3])


def own(found):
    """Our step (rows) by GTSAM's (columns), at one of its poses."""
    R = found.rotation().matrix()
    if len(R) == 2:
        return np.block([[R, np.zeros((2, 1))], [np.zeros((1, 2)), np.eye(1)]])
    return np.block([[np.zeros((3, 3)), R], [np.eye(3), np.zeros((3, 3))]])


def step(result, given, H):
    """A Jacobian from pose to pose in our steps."""
    return own(result) @ H @ np.linalg.inv(own(given))


# -- rotations ---------------------------------------------------------------------------------------------------------


@many
@given(v=turns(), q=QUATERNIONS)
def test_rotations(v, q):
    """GTSAM's series for short rotation vectors are as good as ours; its logarithm near half a turn is not."""
    (H,) = slots(3, 3)
    wanted = gtsam.Rot3.Expmap(v, H)
    value, J = with_jacobians(quaternion.exponential, v)
    close(quaternion.rotation(value), wanted.matrix(), 1e-9)
    about_own = np.hstack([np.zeros((3, 1)), np.eye(3)]).T / 2
    close(J.vector, quaternion.left_matrix(value) @ about_own @ H, 1e-9)
    if np.linalg.norm(v) < 3.0:
        found = gtsam.Rot3.Logmap(wanted, H)
        close(quaternion.logarithm(value), found, 1e-9)
        close(quaternion.logarithm.jac(value)[1].q @ quaternion.left_matrix(value) @ about_own, H, 1e-9)
    close(quaternion.rotation(q), rot3(q).matrix())
    close(np.abs(quaternion.from_rotation(rot3(q).matrix(), q) @ q), 1.0)


@many
@given(v=turns(3.0), p=QUATERNIONS, q=QUATERNIONS, share=st.floats(0, 1))
def test_jacobians_of_the_exponential_and_ways_between_rotations(v, p, q, share):
    close(quaternion.right_jacobian(v), gtsam.Rot3.ExpmapDerivative(v), 1e-9)
    close(quaternion.right_jacobian_inverse(v), gtsam.Rot3.LogmapDerivative(v), 1e-9)
    if np.abs(p @ q) > 0.05:  # GTSAM's logarithm near half a turn
        close(quaternion.rotation(quaternion.slerp(p, q, share)), rot3(p).slerp(share, rot3(q)).matrix(), 1e-9)


@many
@given(seed=SEEDS)
def test_the_mean_of_rotations(seed):
    """GTSAM's goes along the gradient until a step is below 1e-5, ours by Newton's steps to the end."""
    rng = np.random.default_rng(seed)
    middle = quaternion.UnitQuaternion.random(rng)
    spread = quaternion.plus(middle, 0.3 * rng.standard_normal((7, 3)))
    wanted = gtsam.FindKarcherMeanRot3([rot3(q) for q in spread])
    close(quaternion.rotation(quaternion.mean(spread)), wanted.matrix(), 1e-4)


@many
@given(angles=several(st.floats(-1.5, 1.5), 3))
def test_euler_angles(angles):
    roll, pitch, yaw = angles
    wanted = gtsam.Rot3.Ypr(yaw, pitch, roll)
    close(euler.to_rotation(angles), wanted.matrix())
    (H,) = slots(3, 3)
    found, J = euler.from_quaternion_jac(euler.to_quaternion(angles))
    close(found, wanted.ypr(H)[::-1], 1e-11)
    close(J, H[::-1], 1e-9)  # GTSAM's is a product of two, each with the cosine of the pitch below


@many
@given(seed=SEEDS)
def test_the_nearest_rotation_and_the_best_motion(seed):
    rng = np.random.default_rng(seed)
    x, M = rng.standard_normal((9, 3)), rng.standard_normal((3, 3))
    close(nearest_rotation(M), gtsam.Rot3.ClosestTo(M).matrix(), 1e-9)
    y = x @ quaternion.rotation(quaternion.exponential(rng.standard_normal(3))).T + rng.normal(0, 0.2, (9, 3))
    found, wanted = align(x, y, scale=False), gtsam.Pose3.Align(np.asfortranarray(y.T), np.asfortranarray(x.T))
    close(found.rotation, wanted.rotation().matrix(), 1e-9)
    close(found.translation, wanted.translation(), 1e-9)


# -- poses -------------------------------------------------------------------------------------------------------------


def check_group(module, a, b, point):
    A, B, n = theirs(a), theirs(b), 3 if len(a) == 3 else 6
    H, G = slots(n, n, n)
    value, J = with_jacobians(module.compose, a, b)
    wanted = A.compose(B, H, G)
    close(theirs(value).matrix(), wanted.matrix())
    close(J.outer, step(wanted, A, H))
    close(J.inner, step(wanted, B, G))
    value, J = with_jacobians(module.inverse, a)
    wanted = A.inverse()
    close(theirs(value).matrix(), wanted.matrix())
    close(J.pose, step(wanted, A, -A.AdjointMap()))
    for ours, other in ((module.from_frame, A.transformFrom), (module.to_frame, A.transformTo)):
        H, G = slots(len(point), n, len(point))
        value, J = with_jacobians(ours, a, point)
        close(value, other(point, H, G))
        close(J.pose, H @ np.linalg.inv(own(A)))
        close(J.point, G)


@many
@given(a=POSES, b=POSES, point=several(NUMBERS, 3))
def test_poses_in_space(a, b, point):
    check_group(pose, a, b, point)
    H, G = slots(6, 6, 6)
    value, J = with_jacobians(pose.relative, a, b)
    wanted = theirs(a).between(theirs(b), H, G)
    close(theirs(value).matrix(), wanted.matrix())
    close(J.origin, step(wanted, theirs(a), H))
    close(J.pose, step(wanted, theirs(b), G))
    close(Pose.minus(b, a)[:3], theirs(b).translation() - theirs(a).translation())


ROTATION_FIRST = np.roll(np.eye(6), 3, axis=1)  # our twist by GTSAM's


@many
@given(v=turns(3.0), d=several(NUMBERS, 3), a=POSES)
def test_twists_in_space(v, d, a):
    twist = np.append(d, v)
    (H,) = slots(6, 6)
    wanted = gtsam.Pose3.Expmap(np.append(v, d), H)
    value, J = with_jacobians(pose.exponential, twist)
    close(theirs(value).matrix(), wanted.matrix(), 1e-9)
    close(J.twist, own(wanted) @ H @ ROTATION_FIRST, 1e-7)  # its derivative divides by powers of the angle
    found, J = with_jacobians(pose.logarithm, value)
    close(found, twist, 1e-11)
    gtsam.Pose3.Logmap(wanted, H)
    close(J.pose, ROTATION_FIRST @ H @ np.linalg.inv(own(wanted)), 1e-7)
    close(pose.adjoint(a), ROTATION_FIRST @ theirs(a).AdjointMap() @ ROTATION_FIRST, 1e-11)


@many
@given(a=PLANAR, b=PLANAR, point=several(NUMBERS, 2))
def test_poses_in_the_plane(a, b, point):
    check_group(pose2, a, b, point)
    close(pose2.adjoint(a), theirs(a).AdjointMap())
    turn = theirs(b).between(theirs(a)).theta()
    found = Pose2.minus(a, b)[2]
    close(np.abs(found) if np.abs(turn) > 3.1 else found, np.abs(turn) if np.abs(turn) > 3.1 else turn)


@many
@given(twist=PLANAR.filter(lambda twist: np.abs(twist[2]) > 1e-4 or twist[2] == 0))
def test_the_exponential_of_a_twist_in_the_plane(twist):
    """GTSAM divides by the turn, its derivative by its square: short turns are left to SciPy's expm."""
    value, J = with_jacobians(pose2.exponential, twist)
    wanted = gtsam.Pose2.Expmap(twist)
    close(theirs(value).matrix(), wanted.matrix(), 1e-11)
    close(J.twist, own(wanted) @ gtsam.Pose2.ExpmapDerivative(twist), 1e-7 if np.abs(twist[2]) < 0.01 else 1e-11)


# -- measurements ------------------------------------------------------------------------------------------------------


@many
@given(a=POSES, point=several(NUMBERS, 3).filter(lambda p: np.hypot(*p[:2]) > 0.1))
def test_ranges_and_bearings_in_space(a, point):
    """The whole chain, from the world's point and the pose to the measurement, with its Jacobians.

    GTSAM's bearing is a direction; our two angles turn the x axis into it.
    """
    world = pose.from_frame(a, point)
    there, by = pose.to_frame.jac(a, world)
    value, J = with_jacobians(range_bearing.project, np.append(there, 1.0))
    H, G = slots(1, 6, 3)
    close(value[0], theirs(a).range(world, H, G))
    close(J.point[:1, :3] @ by.pose, H @ np.linalg.inv(own(theirs(a))), 1e-11)
    close(J.point[:1, :3] @ by.point, G, 1e-11)
    direction = theirs(a).bearing(world).point3()
    close(gtsam.Rot3.Ypr(value[1], value[2], 0).matrix()[:, 0], direction, 1e-11)
    close(range_bearing.back_project(value)[:3], direction, 1e-11)


@many
@given(a=PLANAR, point=several(NUMBERS, 2).filter(lambda p: np.hypot(*p) > 0.1))
def test_ranges_and_bearings_in_the_plane(a, point):
    world = pose2.from_frame(a, point)
    there, by = pose2.to_frame.jac(a, world)
    value, J = with_jacobians(plane_range_bearing.project, np.array([*there, 0.0, 1.0]))
    (H, G), (H_bearing, G_bearing) = slots(1, 3, 2), slots(1, 3, 2)
    bearing = theirs(a).bearing(world, H_bearing, G_bearing).theta()
    close(value[0], theirs(a).range(world, H, G))
    close(np.sin(value[1] - bearing), 0.0)
    close(J.point[:, :2] @ by.pose, np.vstack([H, H_bearing]) @ np.linalg.inv(own(theirs(a))), 1e-11)
    close(J.point[:, :2] @ by.point, np.vstack([G, G_bearing]), 1e-11)


def check_lens(a, point, camera, kind, calibration, columns):
    """The whole chain from the pose `a` of a camera, and the point in its frame, to the pixel, with every Jacobian.

    columns: of GTSAM's (fx, fy, skew, u0, v0, ...), those of our distortion.
    """
    world = pose.from_frame(a, point)
    there, by = pose.to_frame.jac(a, world)
    value, J = camera.project_jac(np.append(there, 1.0))
    H, G, C = slots(2, 6, 3, calibration.dim())
    close(value, kind(theirs(a), calibration).project(world, H, G, C), 1e-11)
    close(J.point[:, :3] @ by.pose, H @ np.linalg.inv(own(theirs(a))), 1e-9)
    close(J.point[:, :3] @ by.point, G, 1e-9)
    close(J.intrinsics, C[:, [3, 4, 0, 1]], 1e-11)
    close(J.distortion, C[:, columns], 1e-9)


def lens(sensor, distortion, **limits):
    return Calibration(sensor, np.eye(2), intrinsics=K, distortion=distortion, limits=limits)


U, V, FX, FY = K


@many
@given(a=POSES, point=POINTS)
def test_pin_hole_cameras(a, point):
    check_lens(a, point, lens(pinhole.PINHOLE, []), gtsam.PinholeCameraCal3_S2, gtsam.Cal3_S2(FX, FY, 0, U, V), [])


@many
@given(a=POSES, point=POINTS, d=several(st.floats(-0.2, 0.2), 2))
def test_radial_distortion(a, point, d):
    calibration = gtsam.Cal3DS2(FX, FY, 0, U, V, *d)
    check_lens(a, point, lens(pinhole.PINHOLE, d, radius=100.0), gtsam.PinholeCameraCal3DS2, calibration, [5, 6])


@many
@given(a=POSES, point=POINTS, d=several(st.floats(-0.1, 0.1), 4))
def test_lenses_that_are_not_centred(a, point, d):
    calibration = gtsam.Cal3DS2(FX, FY, 0, U, V, *d)
    check_lens(a, point, lens(brown.BROWN, d, radius=100.0), gtsam.PinholeCameraCal3DS2, calibration, [5, 6, 7, 8])


@many
@given(a=POSES, point=POINTS, d=several(st.floats(-0.1, 0.1), 4), xi=st.floats(0, 2))
def test_the_unified_model(a, point, d, xi):
    """GTSAM has xi last."""
    camera, calibration = lens(unified.UNIFIED, [xi, *d]), gtsam.Cal3Unified(FX, FY, 0, U, V, *d, xi)
    check_lens(a, point, camera, gtsam.PinholeCameraCal3Unified, calibration, [9, 5, 6, 7, 8])


@many
@given(a=POSES, point=POINTS, d=several(st.floats(-0.02, 0.02), 4))
def test_fisheyes(a, point, d):
    calibration = gtsam.Cal3Fisheye(FX, FY, 0, U, V, *d)
    check_lens(a, point, lens(fisheye.FISHEYE, d), gtsam.PinholeCameraCal3Fisheye, calibration, [5, 6, 7, 8])


@many
@given(a=POSES, point=POINTS, baseline=st.floats(0.05, 1))
def test_stereo_pairs(a, point, baseline):
    """GTSAM has both columns, (uL, uR, v); ours are one and their difference."""
    u, v, fx, fy = K
    H, G = slots(3, 6, 3)
    world, to_ours = pose.from_frame(a, point), np.array([[1, 0, 0], [0, 0, 1], [1, -1, 0]])
    pair = gtsam.StereoCamera(theirs(a), gtsam.Cal3_S2Stereo(fx, fy, 0, u, v, baseline))
    wanted = to_ours @ pair.project2(world, H, G).vector()
    camera = Calibration(stereo.STEREO, np.eye(3), intrinsics=K, baseline=[baseline])
    there, by = pose.to_frame.jac(a, world)
    value, J = camera.project_jac(np.append(there, 1.0))
    close(value, wanted, 1e-11)
    close(J.point[:, :3] @ by.pose, to_ours @ H @ np.linalg.inv(own(theirs(a))), 1e-11)
    close(J.point[:, :3] @ by.point, to_ours @ G, 1e-11)


# -- the filter --------------------------------------------------------------------------------------------------------


@many
@given(seed=SEEDS)
def test_the_kalman_filter(seed):
    """GTSAM's eliminates factors: it never has a covariance."""
    rng = np.random.default_rng(seed)
    n, m = 4, 2
    F, H, B = rng.standard_normal((n, n)), rng.standard_normal((m, n)), rng.standard_normal((n, 1))
    P, Q, R = (covariance(rng, k) + 0.1 * np.eye(k) for k in (n, n, m))
    mean, control, belief, other = rng.standard_normal(n), rng.standard_normal(1), Belief(), gtsam.KalmanFilter(n)
    block, state = belief.add(n, mean, P), other.init(mean, P)
    for _ in range(5):
        state = other.predictQ(state, F, B, control, Q)
        belief.predict(block, F @ block.mean + B @ control, F, Q)
        y = rng.standard_normal(m)
        state = other.updateQ(state, H, y, R)
        belief.update([block], [H], y - H @ block.mean, R)
        close(block.mean, state.mean(), 1e-9)
        close(belief.matrix, state.covariance(), 1e-9)
