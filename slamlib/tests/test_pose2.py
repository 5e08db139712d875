"""Poses in the plane: every model against its definition, against matrices, and against poses in space."""

import numpy as np
import pytest
from scipy.linalg import expm

from slamlib.codegen import check_model
from slamlib.errors import NonFiniteError, ShapeError
from slamlib.geometry import euler, pose, pose2
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose2 import Pose2
from slamlib.models import Model
from slamlib.models.numerical import complex_step
from slamlib.motions.plane_odometry import PLANE_ODOMETRY
from slamlib.motions.unicycle import UNICYCLE
from slamlib.tests.differences import differences

MODELS = [v for v in vars(pose2).values() if isinstance(v, Model) and v.module == pose2.__name__]
TURNS = [0.0, 1e-300, 1e-9, -1e-9, 1e-3, 1.0, np.pi / 2, np.pi, -np.pi, 4.0, 2 * np.pi, -9.0]
ORIGIN = np.zeros(3)


@pytest.fixture
def rng():
    return np.random.default_rng(62)


def draw(model, rng):
    return [rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments]


def same(one, other, accuracy=1e-14):
    """Whether two poses in the plane are the same, headings but for whole turns."""
    return Pose2.minus(one, other) == pytest.approx(ORIGIN, abs=accuracy)


def matrix(planar):
    """The matrix of a pose: its product with (x, y, 1) of a point in the frame is that of the point in the world."""
    x, y, heading = planar
    c, s = np.cos(heading), np.sin(heading)
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


def twist_matrix(twist):
    x, y, turn = twist
    return np.array([[0, -turn, x], [turn, 0, y], [0, 0, 0]])


# -- each model --------------------------------------------------------------------------------------------------------


def test_all_models_are_tried():
    assert len(MODELS) == 8


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_jacobians_agree_with_central_differences_too(model, rng):
    arguments = draw(model, rng)
    _, jacobians = model.jac(*arguments)
    for index in range(len(arguments)):
        assert jacobians[index] == pytest.approx(differences(model, arguments, index), abs=1e-7)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_a_batch_is_a_loop(model, rng):
    items = [draw(model, rng) for _ in range(4)]
    value, jacobians = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, one_jacobians = model.jac(*item)
        assert model(*item) == pytest.approx(one, abs=1e-15)
        assert value[n] == pytest.approx(one, abs=1e-15)
        for many, single in zip(jacobians, one_jacobians, strict=True):
            assert many[n] == pytest.approx(single, abs=1e-14)


def test_bad_input_is_named():
    with pytest.raises(ShapeError, match=r"from_frame: argument 'pose' should have shape \(\.\.\., 3\)"):
        pose2.from_frame(np.zeros(7), np.zeros(2))
    with pytest.raises(NonFiniteError, match=r"'twist' holds nan at index \(2,\)"):
        pose2.exponential(np.array([1, 0, np.nan]))


# -- a group -----------------------------------------------------------------------------------------------------------


def test_poses_in_the_plane_form_a_group(rng):
    for _ in range(10):
        a, b, c = (3 * Pose2.random(rng) for _ in range(3))
        assert same(pose2.compose(pose2.compose(a, b), c), pose2.compose(a, pose2.compose(b, c)), 1e-13)
        assert same(pose2.compose(a, pose2.inverse(a)), ORIGIN)
        assert same(pose2.compose(pose2.inverse(a), a), ORIGIN)
        assert matrix(pose2.compose(a, b)) == pytest.approx(matrix(a) @ matrix(b), abs=1e-13)
        assert matrix(pose2.inverse(a)) == pytest.approx(np.linalg.inv(matrix(a)), abs=1e-13)
        assert not same(pose2.compose(a, b), pose2.compose(b, a), 1e-2)


def test_points_go_to_the_world_and_back(rng):
    a, point = Pose2.random(rng), rng.standard_normal(2)
    there = pose2.from_frame(a, point)
    assert there == pytest.approx((matrix(a) @ [*point, 1])[:2], abs=1e-15)
    assert pose2.to_frame(a, there) == pytest.approx(point, abs=1e-14)
    left = pose2.from_frame(np.array([1.0, 2, np.pi / 2]), np.array([3.0, 0]))  # ahead of who looks along y
    assert left == pytest.approx([1, 5], abs=1e-15)


def test_the_jacobians_of_a_composition_are_those_of_the_book(rng):
    a, b = Pose2.random(rng), Pose2.random(rng)
    _, J = pose2.compose.jac(a, b)
    C = matrix(a)[:2, :2]
    lever = C @ [-b[1], b[0]]
    assert J.outer == pytest.approx(np.array([[1, 0, lever[0]], [0, 1, lever[1]], [0, 0, 1]]), abs=1e-14)
    assert J.inner == pytest.approx(np.block([[C, np.zeros((2, 1))], [np.zeros((1, 2)), np.eye(1)]]), abs=1e-14)


# -- the exponential ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("turn", TURNS)
def test_the_exponential_is_that_of_matrices(turn):
    """To the accuracy of scipy's expm, which squares an approximation."""
    twist = np.array([1.5, -0.4, turn])
    assert matrix(pose2.exponential(twist)) == pytest.approx(expm(twist_matrix(twist)), abs=1e-12)


@pytest.mark.parametrize("turn", TURNS)
def test_jacobians_of_the_exponential_are_exact_at_each_turn(turn):
    twist = np.array([1.5, -0.4, turn])
    value, J = pose2.exponential.jac(twist)
    assert value == pytest.approx(pose2.exponential.definition(twist), abs=1e-15)
    assert J.twist == pytest.approx(complex_step(pose2.exponential, [twist], 0), abs=1e-14)


def test_no_turn_is_straight_and_almost_none_is_exact():
    straight, J = pose2.exponential.jac(np.array([2.0, 0.5, 0]))
    assert straight.tolist() == [2, 0.5, 0]
    assert J.twist == pytest.approx(np.array([[1, 0, -0.25], [0, 1, 1], [0, 0, 1]]), abs=0)
    for turn in (1e-200, 1e-9, -1e-9):
        assert pose2.exponential(np.array([1.0, 0, turn]))[1] == pytest.approx(turn / 2, rel=1e-12, abs=0)
    assert 1 - np.cos(1e-9) == 0  # what a quotient by the turn would be made of


def test_half_a_turn_ends_at_the_other_end_of_a_diameter():
    assert pose2.exponential(np.array([np.pi, 0, np.pi])) == pytest.approx([0, 2, np.pi], abs=1e-15)
    assert pose2.exponential(np.array([np.pi, 0, -np.pi])) == pytest.approx([0, -2, -np.pi], abs=1e-15)
    assert pose2.exponential(np.array([5.0, 1, 2 * np.pi])) == pytest.approx([0, 0, 2 * np.pi], abs=1e-15)


@pytest.mark.parametrize("turn", TURNS)
def test_parts_of_a_twist_add_up(turn):
    twist = np.array([1.5, -0.4, turn])
    for s, u in ((0.3, 0.7), (-0.5, 1.5), (2.0, 1.0)):
        parts = pose2.compose(pose2.exponential(s * twist), pose2.exponential(u * twist))
        assert parts == pytest.approx(pose2.exponential((s + u) * twist), abs=1e-14)
    assert same(pose2.exponential(-twist), pose2.inverse(pose2.exponential(twist)))


@pytest.mark.parametrize("turn", [0.0, 1e-9, 1.0, np.pi, -9.0])
def test_the_exponential_solves_its_differential_equation(turn):
    twist = np.array([1.5, -0.4, turn])
    for s in (0.0, 0.4, 1.0):
        here, J = pose2.exponential.jac(s * twist)
        velocity = np.array([*(matrix(here)[:2, :2] @ twist[:2]), turn])
        assert J.twist @ twist == pytest.approx(velocity, abs=1e-14)


def test_the_exponential_is_no_step_of_the_filter():
    """A step keeps position and heading apart; an arc does not."""
    twist = np.array([1.0, 0, 1])
    assert Pose2.plus(ORIGIN, twist).tolist() == [1, 0, 1]
    assert not same(pose2.exponential(twist), Pose2.plus(ORIGIN, twist), 0.1)


# -- the adjoint -------------------------------------------------------------------------------------------------------


def test_the_adjoint_carries_a_twist_to_the_axes_of_the_world(rng):
    for _ in range(10):
        a, twist = 2 * Pose2.random(rng), 2 * rng.standard_normal(3)
        Ad, moved = pose2.adjoint(a), pose2.compose(a, pose2.exponential(twist))
        assert same(pose2.compose(pose2.exponential(Ad @ twist), a), moved, 1e-13)
        assert twist_matrix(Ad @ twist) == pytest.approx(
            matrix(a) @ twist_matrix(twist) @ np.linalg.inv(matrix(a)), abs=1e-13
        )
        turned_alone = np.array([[*Ad[0, :2], 0], [*Ad[1, :2], 0], [0, 0, 1]])
        assert not same(pose2.compose(pose2.exponential(turned_alone @ twist), a), moved, 1e-3)


def test_the_adjoint_of_a_composition_is_a_product(rng):
    a, b = Pose2.random(rng), Pose2.random(rng)
    assert pose2.adjoint(pose2.compose(a, b)) == pytest.approx(pose2.adjoint(a) @ pose2.adjoint(b), abs=1e-14)
    assert pose2.adjoint(pose2.inverse(a)) == pytest.approx(np.linalg.inv(pose2.adjoint(a)), abs=1e-14)


# -- headings beyond half a turn ---------------------------------------------------------------------------------------


def test_headings_that_differ_by_whole_turns_are_the_same():
    beyond, short = np.radians([[0, 0, 190.0], [0, 0, -170.0]])
    assert same(beyond, short)
    assert Pose2.minus(np.radians([0, 0, 170.0]), short) == pytest.approx(np.radians([0, 0, -20.0]), abs=1e-15)
    assert Pose2.minus(np.array([1.0, 2, 5]), np.array([0.5, 0, 4])) == pytest.approx([0.5, 2, 1])
    point = np.array([1.0, 2])
    assert pose2.from_frame(beyond, point) == pytest.approx(pose2.from_frame(short, point), abs=1e-15)


def test_a_heading_counts_its_laps_and_a_difference_does_not():
    robot, eighth = ORIGIN, pose2.exponential(np.array([1.0, 0, np.pi / 4]))
    for _ in range(16):
        robot = pose2.compose(robot, eighth)
    assert robot == pytest.approx([0, 0, 4 * np.pi], abs=1e-14)
    assert same(robot, ORIGIN)
    assert not np.allclose(robot, ORIGIN)


def test_plus_and_minus_are_inverse(rng):
    poses, steps = 5 * rng.standard_normal((20, 3)), rng.uniform(-3, 3, (20, 3))
    assert Pose2.minus(Pose2.plus(poses, steps), poses) == pytest.approx(steps, abs=1e-14)


# -- into space and back -----------------------------------------------------------------------------------------------


def test_composing_in_the_plane_and_in_space_is_one(rng):
    for _ in range(20):
        a, b = 3 * Pose2.random(rng), 3 * Pose2.random(rng)
        A, B = pose2.in_space(a), pose2.in_space(b)
        assert pose2.in_space(pose2.compose(a, b)) == pytest.approx(pose.compose(A, B), abs=1e-14)
        assert pose2.in_space(pose2.inverse(a)) == pytest.approx(pose.inverse(A), abs=1e-14)
        point = rng.standard_normal(2)
        flat = [*pose2.from_frame(a, point), 0]
        assert pose.from_frame(A, np.array([*point, 0])) == pytest.approx(flat, abs=1e-14)


@pytest.mark.parametrize("heading", [0.0, 1e-9, 3.1, np.pi, -np.pi, 4.0, 7.0, -20.0])
def test_a_pose_comes_back_from_space_as_it_was_but_for_whole_turns(heading):
    planar = np.array([1.5, -0.4, heading])
    back, J = pose2.from_space.jac(pose2.in_space(planar))
    assert same(back, planar)
    assert abs(back[2]) <= np.pi
    _, K = pose2.in_space.jac(planar)
    assert J.pose @ K.state == pytest.approx(np.eye(3), abs=1e-14)


def test_the_heading_of_a_pose_in_space_is_its_yaw_whatever_its_tilt(rng):
    for _ in range(20):
        angles = rng.uniform([-np.pi, -1.5, -np.pi], [np.pi, 1.5, np.pi])
        tilted = np.array([*rng.standard_normal(3), *euler.to_quaternion(angles)])
        assert pose2.from_space(tilted) == pytest.approx([*tilted[:2], angles[2]], abs=1e-12)
        flipped = np.array([*tilted[:3], *-tilted[3:]])
        assert pose2.from_space(flipped) == pytest.approx(pose2.from_space(tilted), abs=1e-14)


def test_in_space_a_pose_in_the_plane_moves_along_two_axes_and_turns_about_one(rng):
    planar, step = Pose2.random(rng), np.array([0.1, -0.2, 0.3])
    _, J = pose2.in_space.jac(planar)
    assert J.state == pytest.approx(np.eye(6)[:, [0, 1, 5]], abs=1e-15)
    stepped = Pose.minus(pose2.in_space(Pose2.plus(planar, step)), pose2.in_space(planar))
    assert stepped == pytest.approx(J.state @ step, abs=1e-14)


@pytest.mark.parametrize("motion", [UNICYCLE, PLANE_ODOMETRY], ids=lambda m: m.name)
def test_motions_in_the_plane_know_in_which_directions_their_pose_can_be(motion):
    assert motion.free @ motion.free.T == pytest.approx(np.diag([1, 1, 0, 0, 0, 1]), abs=1e-15)
