"""Jacobians of the exponential, slerp, the mean, twists in space: beside mpmath's matrix exponential, and SciPy."""

import re

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp

from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError, UnitError
from slamlib.geometry import euler, pose, pose2, quaternion
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.geometry.quaternion import UnitQuaternion
from slamlib.models.numerical import differences

ANGLES = [0.0, 1e-300, 1e-12, 1e-8, 1e-4, 0.7, np.sqrt(2), 2.0, 2 * np.sqrt(2), np.pi - 1e-9, np.pi, 4.0, 6.0]
AXES = [np.array(axis) for axis in ([1.0, 0, 0], [0, 0, -1.0], [2 / 3, -1 / 3, 2 / 3])]
PLACES = [pytest.param(angle * axis, id=f"{angle:.10g} {axis.round(2)}") for angle in ANGLES for axis in AXES]
numbers = st.floats(-1.8, 1.8)
vectors = st.tuples(numbers, numbers, numbers).map(np.array)
quaternions = st.integers(0, 2**32).map(lambda seed: UnitQuaternion.random(np.random.default_rng(seed)))


def hat(vector):
    """The matrix of the cross product, with 50 digits."""
    x, y, z = map(mpmath.mpf, vector)
    return mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def reference_left_jacobian(vector):
    """The integral of exp(s [v]x) over 0 to 1, as a block of a matrix exponential: without its closed form."""
    big = mpmath.zeros(6, 6)
    big[:3, :3], big[:3, 3:] = hat(vector), mpmath.eye(3)
    return mpmath.expm(big)[:3, 3:]


def as_floats(matrix):
    return np.array(matrix.tolist(), dtype=float)


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


# -- the Jacobians of the exponential ----------------------------------------------------------------------------------


@pytest.mark.parametrize("v", PLACES)
def test_both_jacobians_and_their_inverses_have_twelve_digits(v):
    left = reference_left_jacobian(v)
    inverse = left**-1
    assert quaternion.left_jacobian(v) == pytest.approx(as_floats(left), abs=1e-12)
    assert quaternion.right_jacobian(v) == pytest.approx(as_floats(left.T), abs=1e-12)
    assert quaternion.left_jacobian_inverse(v) == pytest.approx(as_floats(inverse), abs=1e-12)
    assert quaternion.right_jacobian_inverse(v) == pytest.approx(as_floats(inverse.T), abs=1e-12)
    for function in (quaternion.left_jacobian, quaternion.right_jacobian, quaternion.left_inverse):
        assert function.jac(v)[1].vector == pytest.approx(differences(function, v), abs=3e-8)


@pytest.mark.parametrize("v", PLACES)
def test_a_change_of_the_vector_is_a_rotation_on_either_side(v):
    q = quaternion.exponential(v)
    on_the_right = differences(lambda w: quaternion.minus(quaternion.exponential(w), q), v)
    assert quaternion.right_jacobian(v) == pytest.approx(on_the_right, abs=1e-8)
    back = quaternion.conjugate(q)

    def turned(w):
        return quaternion.product(quaternion.exponential(w), back)

    on_the_left = differences(lambda w: quaternion.logarithm(turned(w)), v)
    assert quaternion.left_jacobian(v) == pytest.approx(on_the_left, abs=1e-8)


@pytest.mark.parametrize("short", [1e-2, 1e-5, 1e-9])
def test_close_to_a_whole_turn_the_inverse_loses_the_digits_that_the_angle_has_lost(short):
    v = (2 * np.pi - short) * AXES[2]
    wanted = as_floats(reference_left_jacobian(v) ** -1)
    error = np.abs(quaternion.left_jacobian_inverse(v) - wanted).max() / np.abs(wanted).max()
    assert error < 1e-14 / short
    assert np.abs(wanted).max() > 1 / short


@pytest.mark.parametrize("turns", [1, 2, -3])
def test_a_whole_turn_has_no_inverse_and_is_refused_by_name(turns):
    v = 2 * np.pi * turns * np.array([1.0, 0, 0])
    for function in (quaternion.left_jacobian_inverse, quaternion.right_jacobian_inverse):
        with pytest.raises(SingularPointError, match=rf"{function.__name__}: .* a whole turn long"):
            function(np.array([[0.1, 0, 0], v]))
    assert abs(np.linalg.det(quaternion.left_jacobian(v))) < 1e-30


@given(vectors)
def test_the_inverses_are_inverses_and_the_jacobians_differ_by_the_rotation(v):
    left, right = quaternion.left_jacobian(v), quaternion.right_jacobian(v)
    assert left @ quaternion.left_jacobian_inverse(v) == pytest.approx(np.eye(3), abs=1e-14)
    assert right @ quaternion.right_jacobian_inverse(v) == pytest.approx(np.eye(3), abs=1e-14)
    assert left == pytest.approx(quaternion.rotation(quaternion.exponential(v)) @ right, abs=1e-14)


def test_jacobians_of_many_at_once():
    many = np.random.default_rng(1).standard_normal((2, 30, 3))
    for function in (quaternion.left_jacobian, quaternion.left_jacobian_inverse, quaternion.right_jacobian_inverse):
        found = function(many)
        assert found.shape == (2, 30, 3, 3)
        assert found[1, 7] == pytest.approx(function(many[1, 7]), abs=1e-14)


# -- slerp -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-6, 0.3, 2.0, np.pi - 1e-9])
def test_slerp_is_that_of_scipy(size):
    rng = np.random.default_rng(2)
    for _ in range(5):
        a, axis = UnitQuaternion.random(rng), rng.standard_normal(3)
        b = UnitQuaternion.plus(a, size * axis / np.linalg.norm(axis))
        shares = np.linspace(0, 1, 7)
        wanted = Slerp([0, 1], Rotation.from_quat(np.roll([a, b], -1, axis=-1)))(shares).as_matrix()
        for end in (b, -b):
            assert quaternion.rotation(quaternion.slerp(a, end, shares)) == pytest.approx(wanted, abs=1e-12)


@given(quaternions, quaternions, st.floats(0, 1))
def test_slerp_turns_evenly_the_short_way(a, b, share):
    q = quaternion.slerp(a, b, share)
    whole = np.linalg.norm(quaternion.minus(b, a))
    assert q @ q == pytest.approx(1, abs=1e-14)
    assert np.linalg.norm(quaternion.minus(q, a)) == pytest.approx(share * whole, abs=1e-7)
    assert np.linalg.norm(quaternion.minus(b, q)) == pytest.approx((1 - share) * whole, abs=1e-7)


def test_slerp_takes_unit_quaternions_alone():
    with pytest.raises(UnitError, match="slerp: argument 'end' should be a unit quaternion, but has length 2"):
        quaternion.slerp([1.0, 0, 0, 0], [0, 2.0, 0, 0], 0.5)
    with pytest.raises(UnitError, match="slerp: argument 'start'"):
        quaternion.slerp([2.0, 0, 0, 0], [0, 1.0, 0, 0], 0.5)


def test_at_half_a_turn_the_sign_of_the_end_says_which_way():
    a, b = np.eye(4)[0], np.eye(4)[3]
    one, other = quaternion.slerp(a, b, 0.5), quaternion.slerp(a, -b, 0.5)
    assert quaternion.logarithm(one) == pytest.approx([0, 0, np.pi / 2])
    assert quaternion.logarithm(other) == pytest.approx([0, 0, -np.pi / 2])


# -- the mean ----------------------------------------------------------------------------------------------------------


def cost(q, points, weights):
    return (weights * (quaternion.minus(points, q) ** 2).sum(-1)).sum()


def scattered(rng, n, size):
    """Quaternions around one of them, some with the other sign."""
    center = UnitQuaternion.random(rng)
    steps = rng.standard_normal((n, 3))
    steps *= size * rng.random((n, 1)) / np.linalg.norm(steps, axis=-1, keepdims=True)
    return UnitQuaternion.plus(center, steps) * rng.choice([-1, 1], (n, 1))


@pytest.mark.parametrize("size", [0.0, 1e-9, 1e-3, 0.5, 1.5])
def test_the_mean_is_where_the_weighted_rotation_vectors_add_up_to_nothing(size):
    rng = np.random.default_rng(3)
    for n in (1, 2, 3, 50):
        points, weights = scattered(rng, n, size), rng.uniform(0.1, 2, n)
        q = quaternion.mean(points, weights)
        assert q @ q == pytest.approx(1, abs=1e-14)
        assert weights / weights.sum() @ quaternion.minus(points, q) == pytest.approx(np.zeros(3), abs=1e-14)
        for step in 1e-3 * np.vstack([np.eye(3), -np.eye(3)]):
            assert cost(UnitQuaternion.plus(q, step), points, weights) > cost(q, points, weights)
        assert q @ points[0] >= 0


def test_the_mean_of_two_is_halfway_and_weights_are_shares():
    rng = np.random.default_rng(4)
    a, b = scattered(rng, 2, 1.5)
    for share in (0.0, 0.25, 0.5):
        found = quaternion.mean([a, b], [1 - share, share])
        assert np.linalg.norm(quaternion.minus(found, quaternion.slerp(a, b, share))) < 1e-14
    assert quaternion.minus(quaternion.mean([a, b]), quaternion.mean([a, b], [3, 3])) == pytest.approx(np.zeros(3))


def test_the_mean_is_not_scipys_chordal_one_but_close_to_it_where_all_are_close():
    rng = np.random.default_rng(5)
    apart = []
    for size in (0.1, 1.0):
        points = scattered(rng, 40, size)
        chordal = np.roll(Rotation.from_quat(np.roll(points, -1, axis=-1)).mean().as_quat(), 1)
        apart.append(np.linalg.norm(quaternion.minus(chordal, quaternion.mean(points))))
    assert apart[0] < 1e-4 < 1e-3 < apart[1]


def test_turning_all_turns_the_mean_and_batches_are_loops():
    rng = np.random.default_rng(6)
    groups = np.array([scattered(rng, 9, 1.2) for _ in range(4)])
    weights = rng.random((4, 9))
    found = quaternion.mean(groups, weights)
    assert found.shape == (4, 4)
    for q, points, w in zip(found, groups, weights, strict=True):
        assert q == pytest.approx(quaternion.mean(points, w), abs=1e-14)
    turn = UnitQuaternion.random(rng)
    turned = quaternion.mean(quaternion.product(turn, groups), weights)
    assert quaternion.minus(turned, quaternion.product(turn, found)) == pytest.approx(np.zeros((4, 3)), abs=1e-14)
    assert quaternion.mean(groups, weights[0]).shape == (4, 4)


def test_a_mean_that_does_not_exist_and_bad_input_are_named():
    unit = np.eye(4)
    with pytest.raises(SingularPointError, match="none is preferred"):
        quaternion.mean(unit[:2])  # half a turn apart
    with pytest.raises(SingularPointError, match="none is preferred"):
        quaternion.mean(unit)
    with pytest.raises(UnitError, match=r"mean: argument 'quaternions' should be a unit quaternion"):
        quaternion.mean(2 * unit)
    with pytest.raises(NonFiniteError, match=r"mean: argument 'quaternions' holds nan"):
        quaternion.mean([[np.nan, 0, 0, 0]])
    for wrong in (unit[0], np.zeros((0, 4)), np.eye(3)):
        with pytest.raises(ShapeError, match=re.escape("(..., n, 4), n above 0")):
            quaternion.mean(wrong)
    with pytest.raises(ShapeError, match=re.escape("weights should have shape (4,) or (4,), but have shape (3,)")):
        quaternion.mean(unit, np.ones(3))
    for wrong in ([1, -1, 1, 1], [0, 0, 0, 0]):
        with pytest.raises(SlamlibError, match="zero or above, and not all of them zero"):
            quaternion.mean(unit, wrong)


# -- twists in space ---------------------------------------------------------------------------------------------------


def twist_matrix(twist):
    """The 4 x 4 matrix of a twist, with 50 digits."""
    big = mpmath.zeros(4, 4)
    big[:3, :3] = hat(twist[3:])
    big[:3, 3] = mpmath.matrix(list(map(mpmath.mpf, twist[:3])))
    return big


@pytest.mark.parametrize("v", PLACES)
def test_the_exponential_of_a_twist_is_that_of_its_matrix_and_the_logarithm_undoes_it(v):
    twist = np.array([0.3, -2.0, 1.1, *v])
    wanted = as_floats(mpmath.expm(twist_matrix(twist)))
    found = pose.exponential(twist)
    assert found[:3] == pytest.approx(wanted[:3, 3], abs=1e-12)
    assert quaternion.rotation(found[3:]) == pytest.approx(wanted[:3, :3], abs=1e-12)
    again = pose.logarithm(found)
    if np.linalg.norm(v) < np.pi:
        assert again == pytest.approx(twist, abs=1e-12)
    assert np.linalg.norm(again[3:]) <= np.pi
    assert Pose.minus(pose.exponential(again), found) == pytest.approx(np.zeros(6), abs=1e-12)
    _, forward = pose.exponential.jac(twist)
    along = differences(lambda t: Pose.minus(pose.exponential(t), found), twist)
    assert forward.twist == pytest.approx(along, abs=3e-8)
    if np.linalg.norm(v) <= np.pi:
        _, back = pose.logarithm.jac(found)
        assert back.pose @ forward.twist == pytest.approx(np.eye(6), abs=1e-12)


@given(st.integers(0, 2**32))
def test_the_adjoint_moves_a_twist_to_the_other_side(seed):
    rng = np.random.default_rng(seed)
    F, twist = Pose.random(rng), rng.standard_normal(6)
    moved = pose.compose(F, pose.exponential(twist))
    same = pose.compose(pose.exponential(pose.adjoint(F) @ twist), F)
    assert Pose.minus(moved, same) == pytest.approx(np.zeros(6), abs=1e-12)
    G = Pose.random(rng)
    assert pose.adjoint(pose.compose(F, G)) == pytest.approx(pose.adjoint(F) @ pose.adjoint(G), abs=1e-12)


def test_halves_of_a_screw_and_the_plane_in_space():
    twist = np.array([1.0, 0, 0.5, 0, 0, 1.2])
    half = pose.exponential(twist / 2)
    assert Pose.minus(pose.compose(half, half), pose.exponential(twist)) == pytest.approx(np.zeros(6), abs=1e-15)
    assert np.array_equal(pose.exponential(np.zeros(6)), ORIGIN)
    assert pose.exponential(twist)[2] == pytest.approx(0.5)  # along the axis of the screw, whatever it turns
    flat = pose2.in_space(pose2.exponential([1.0, 0.2, 1.2]))
    assert pose.exponential([1.0, 0.2, 0, 0, 0, 1.2]) == pytest.approx(flat, abs=1e-15)


def test_the_pose_errors_of_the_filter_are_apart_and_these_are_coupled():
    step = np.array([1.0, 2, 3, 0.4, -0.2, 0.1])
    assert Pose.plus(ORIGIN, step)[:3] == pytest.approx(step[:3])
    assert np.linalg.norm(pose.exponential(step)[:3] - step[:3]) > 0.1


# -- Euler angles close to the vertical --------------------------------------------------------------------------------


def reference_euler_jacobian(q):
    """Rates of roll, pitch and yaw for unit rates about the body's axes, with 50 digits: the textbook's matrix."""
    w, x, y, z = (mpmath.mpf(n) / mpmath.norm(mpmath.matrix(list(map(mpmath.mpf, q)))) for n in map(float, q))
    ahead, side = 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2  # cos(pitch) times sine and cosine of the roll
    cosine = mpmath.hypot(ahead, side)
    s, c, tangent = ahead / cosine, side / cosine, 2 * (w * y - x * z) / cosine
    return np.array([[1, s * tangent, c * tangent], [0, c, -s], [0, s / cosine, c / cosine]], dtype=float)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("short", [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12])
def test_the_jacobian_of_euler_angles_keeps_its_digits_close_to_the_vertical(short, sign):
    rng = np.random.default_rng(7)
    for roll, yaw in rng.uniform(-3, 3, (20, 2)):
        q = euler.to_quaternion([roll, sign * (np.pi / 2 - short), yaw])
        wanted = reference_euler_jacobian(q)
        angles, found = euler.from_quaternion_jac(q)
        assert np.abs(found - wanted).max() < 3e-15 * np.abs(wanted).max()
        assert np.array_equal(angles, euler.from_quaternion(q))


def test_half_sums_and_half_differences_give_the_angles_up_to_turns():
    rng = np.random.default_rng(8)
    q = np.array([UnitQuaternion.random(rng) for _ in range(50)])
    found = euler.half_sums(q)
    assert np.exp(1j * found) == pytest.approx(np.exp(1j * euler.from_quaternion(q)), abs=1e-13)


# -- words -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("vector", [[1e155, 0, 0], [[1e155, 0, 0], [0, 0, 0]], [[1e155, 0, 0]] * 20])
def test_what_is_too_large_to_be_squared_is_named(vector):
    with pytest.raises(SingularPointError, match=r"exponential .*1e\+155 is too large: its square is beyond the range"):
        quaternion.exponential(vector)


@pytest.mark.parametrize("nothing", [None, [None, 1, 2], "abc"])
def test_what_is_no_vector_is_named(nothing):
    for function in (quaternion.exponential, quaternion.right_jacobian, quaternion.left_jacobian_inverse):
        name = function.__name__ if function is not quaternion.left_jacobian_inverse else "left_inverse"
        with pytest.raises(
            SlamlibError, match=rf"^{name}: (argument 'vector' should|vector should be an array of real)"
        ):
            function(nothing)
