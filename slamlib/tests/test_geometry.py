"""Rotations and frames: every model against its definition, against scipy, and against the toolbox's numbers."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from slamlib.codegen import check_model
from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, UnitError
from slamlib.geometry import euler, moved, polar, pose, quaternion
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import UnitQuaternion
from slamlib.models import Model
from slamlib.models.numerical import complex_step
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

MODELS = [
    v
    for m in (quaternion, euler, pose, polar, moved)
    for v in vars(m).values()
    if isinstance(v, Model) and v.module == m.__name__
]


def sample(model):
    """Arguments where the model is defined: rotation matrices for the inverse of `rotation`."""

    def draw(rng):
        matrix = quaternion.rotation(UnitQuaternion.random(rng))
        return [matrix, quaternion.best_pivot(matrix)]

    return draw if model.name == "from_rotation" else None


@pytest.fixture
def rng():
    return np.random.default_rng(6)


def scipy_rotation(q):
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, sample=sample(model), silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_jacobians_agree_with_central_differences_too(model, rng):
    draw = sample(model) or (
        lambda r: [r.standard_normal(a.shape) if a.manifold is None else a.manifold.random(r) for a in model.arguments]
    )
    arguments = draw(rng)
    _, jacobians = model.jac(*arguments)
    for index in range(len(arguments)):
        numerical = differences(model, arguments, index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_a_batch_is_a_loop(model, rng):
    draw = sample(model) or (
        lambda r: [r.standard_normal(a.shape) if a.manifold is None else a.manifold.random(r) for a in model.arguments]
    )
    items = [draw(rng) for _ in range(4)]
    value, jacobians = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, one_jacobians = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-13)
        for many, single in zip(jacobians, one_jacobians, strict=True):
            assert many[n] == pytest.approx(single, abs=1e-12)


# -- scipy as an independent oracle ------------------------------------------------------------------------------------


def test_rotations_agree_with_scipy(rng):
    for _ in range(20):
        p, q, v = UnitQuaternion.random(rng), UnitQuaternion.random(rng), rng.standard_normal(3)
        assert quaternion.rotation(q) == pytest.approx(scipy_rotation(q).as_matrix(), abs=1e-14)
        both = scipy_rotation(p) * scipy_rotation(q)
        assert quaternion.rotation(quaternion.product(p, q)) == pytest.approx(both.as_matrix(), abs=1e-14)
        turned = quaternion.exponential(v)
        assert quaternion.rotation(turned) == pytest.approx(Rotation.from_rotvec(v).as_matrix(), abs=1e-14)
        assert quaternion.logarithm(q) == pytest.approx(scipy_rotation(q).as_rotvec(), abs=1e-13)
        angles = rng.uniform([-np.pi, -np.pi / 2, -np.pi], [np.pi, np.pi / 2, np.pi])
        assert euler.to_rotation(angles) == pytest.approx(
            Rotation.from_euler("ZYX", angles[::-1]).as_matrix(), abs=1e-14
        )
        assert euler.from_rotation(euler.to_rotation(angles)) == pytest.approx(angles, abs=1e-13)
        matrix = quaternion.rotation(q)
        again = quaternion.from_rotation(matrix, quaternion.best_pivot(matrix))
        assert abs(again @ q) == pytest.approx(1, abs=1e-14)


def test_every_pivot_on_its_side_gives_the_quaternion_and_its_derivatives(rng):
    """The best pivot is a unit vector, for which most terms of the derivatives vanish."""
    for _ in range(5):
        q = UnitQuaternion.random(rng)
        pivot, matrix = q + 0.3 * UnitQuaternion.random(rng), quaternion.rotation(q)
        assert quaternion.from_rotation(matrix, pivot) == pytest.approx(q, abs=1e-14)
        nearby = matrix + rng.uniform(-0.1, 0.1, (3, 3))
        value, jacobians = quaternion.from_rotation.jac(nearby, pivot)
        assert value == pytest.approx(quaternion.from_rotation(nearby, pivot), abs=1e-14)
        for index in range(2):
            numerical = differences(quaternion.from_rotation, [nearby, pivot], index)
            assert jacobians[index] == pytest.approx(numerical, abs=1e-8)


# -- singular and exactly representable places -------------------------------------------------------------------------

TINY = [0.0, 1e-300, 1e-160, 1e-20, 1e-8, 1e-4]


@pytest.mark.parametrize("size", TINY)
def test_small_rotations_are_exact_with_their_jacobians(size):
    v = size * np.array([1.0, -2, 2]) / 3
    q, J = quaternion.exponential.jac(v)
    assert q[1:] == pytest.approx(v / 2, rel=1e-7, abs=0)
    assert J.vector[1:] == pytest.approx(np.eye(3) / 2, abs=1e-8)
    back, J = quaternion.logarithm.jac(q)
    assert back == pytest.approx(v, rel=1e-14, abs=0)
    assert J.q[:, 1:] == pytest.approx(2 * np.eye(3), abs=1e-7)


def test_half_turns_and_opposite_signs():
    for axis in np.eye(4)[1:]:
        for sign in (1, -1):
            matrix, _ = quaternion.rotation.jac(sign * axis)
            assert matrix == pytest.approx(np.diag(2 * axis[1:] - 1), abs=0)
            assert np.linalg.norm(quaternion.logarithm(sign * axis)) == pytest.approx(np.pi)
            again, _ = quaternion.from_rotation.jac(matrix, quaternion.best_pivot(matrix))
            assert abs(again) == pytest.approx(axis, abs=1e-15)


def test_the_logarithm_is_the_same_for_both_signs_with_its_jacobian(rng):
    for _ in range(10):
        q = UnitQuaternion.random(rng)
        (plus_log, plus), (minus_log, minus) = quaternion.logarithm.jac(q), quaternion.logarithm.jac(-q)
        assert plus_log == pytest.approx(minus_log, abs=1e-15)
        assert plus.q == pytest.approx(-minus.q, abs=1e-13)
        assert np.linalg.norm(plus_log) <= np.pi


def test_minus_does_not_see_the_sign_of_a_pose(rng):
    a, b = Pose.random(rng), Pose.random(rng)
    flipped = np.concatenate([b[:3], -b[3:]])
    assert Pose.minus(flipped, a) == pytest.approx(Pose.minus(b, a), abs=1e-14)
    assert Pose.minus(a, a) == pytest.approx(np.zeros(6), abs=1e-15)


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2])
def test_a_vertical_nose_is_rebuilt_from_its_angles(pitch, rng):
    for _ in range(20):
        roll, yaw = rng.uniform(-np.pi, np.pi, 2)
        matrix = euler.to_rotation(np.array([roll, pitch, yaw])) + 1e-17 * rng.standard_normal((3, 3))
        assert euler.to_rotation(euler.from_rotation(matrix)) == pytest.approx(matrix, abs=1e-14)
    exact = np.array([[0.0, 1, 0], [0, 0, -1], [-1, 0, 0]])
    assert euler.from_rotation(exact)[2] == 0
    minus_zero = exact * [[-1.0, 1, 1], [1, 1, 1], [1, 1, 1]]
    assert euler.from_rotation(minus_zero)[2] == np.pi  # and roll turns back
    assert euler.to_rotation(euler.from_rotation(minus_zero)) == pytest.approx(exact, abs=1e-15)
    with pytest.raises(SingularPointError):
        euler.from_rotation_jac(exact)


def test_the_jacobian_of_the_angles_is_the_inverse_of_that_of_the_matrix(rng):
    angles = rng.uniform(-1, 1, 3)
    matrix, forward = euler.to_rotation.jac(angles)
    back, backward = euler.from_rotation_jac(matrix)
    assert back == pytest.approx(angles)
    assert np.einsum("aij,ijb->ab", backward, forward.angles) == pytest.approx(np.eye(3), abs=1e-13)


def test_the_angles_of_a_quaternion_and_their_jacobian(rng):
    q = np.array([UnitQuaternion.random(rng) for _ in range(20)])
    angles, J = euler.from_quaternion_jac(q)
    assert np.array_equal(angles, euler.from_quaternion(q))
    assert euler.to_rotation(angles) == pytest.approx(quaternion.rotation(q), abs=1e-13)
    for k, step in enumerate(np.eye(3) * 1e-6):
        ahead, behind = (euler.from_quaternion(UnitQuaternion.plus(q, s)) for s in (step, -step))
        slope = np.sin(ahead - behind) / 2e-6  # an angle may go from 180 to -180 degrees on the way
        assert np.abs(slope - J[..., k]).max() < 1e-7 * np.abs(J).max()
    with pytest.raises(SingularPointError):
        euler.from_quaternion_jac(np.array([0.5, 0.5, 0.5, -0.5]))  # its x axis points straight down


# -- frames ------------------------------------------------------------------------------------------------------------


def test_frames_form_a_group(rng):
    a, b, c = (Pose.random(rng) for _ in range(3))
    identity = np.array([0, 0, 0, 1.0, 0, 0, 0])
    assert Pose.minus(pose.compose(pose.compose(a, b), c), pose.compose(a, pose.compose(b, c))) == pytest.approx(
        np.zeros(6), abs=1e-14
    )
    assert Pose.minus(pose.compose(a, pose.inverse(a)), identity) == pytest.approx(np.zeros(6), abs=1e-14)
    assert Pose.minus(pose.compose(a, pose.relative(a, b)), b) == pytest.approx(np.zeros(6), abs=1e-14)
    point = rng.standard_normal(3)
    assert pose.to_frame(a, pose.from_frame(a, point)) == pytest.approx(point, abs=1e-14)


def test_plus_and_minus_are_inverse_and_batched(rng):
    poses = np.array([Pose.random(rng) for _ in range(5)])
    steps = rng.uniform(-1, 1, (5, 6))
    moved = Pose.plus(poses, steps)
    assert Pose.minus(moved, poses) == pytest.approx(steps, abs=1e-13)
    assert np.linalg.norm(moved[:, 3:], axis=-1) == pytest.approx(np.ones(5), abs=1e-14)
    with pytest.raises(ShapeError, match="pose: argument 'step'"):
        Pose.plus(poses[0], np.zeros(7))


def test_bad_input_is_named():
    with pytest.raises(UnitError, match=r"length 2\b"):
        quaternion.rotation(np.array([2.0, 0, 0, 0]))
    with pytest.raises(ShapeError, match=r"rotation: argument 'q' should have shape \(\.\.\., 4\)"):
        quaternion.rotation(np.eye(3)[0])
    with pytest.raises(NonFiniteError, match=r"'outer' holds nan at index \(2,\)"):
        pose.compose(np.array([0, 0, np.nan, 1, 0, 0, 0]), np.eye(7)[3])
    with pytest.raises(SingularPointError):
        polar.to_polar.jac(np.zeros(2))


# -- the toolbox's numbers ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("function", "model", "inputs", "output", "jacobians"),
    [
        ("qProd", quaternion.product, ["q1", "q2"], "q", {"Q_q1": "left", "Q_q2": "right"}),
        ("q2qc", quaternion.conjugate, ["q"], "qc", {"QC_q": "q"}),
        ("v2q", quaternion.exponential, ["v"], "q", {"Q_v": "vector"}),
        ("v2q_small", quaternion.exponential, ["v"], "q", {"Q_v": "vector"}),
        ("q2v", quaternion.logarithm, ["q"], "v", {}),
        ("q2Pi", quaternion.pi_matrix, ["q"], "Pi", {}),
        ("e2R", euler.to_rotation, ["e"], "R", {}),
    ],
)
def test_rotations_agree_with_the_toolbox(function, model, inputs, output, jacobians):
    for given, wanted in cases("rotations", function):
        value, J = model.jac(*(given[name] for name in inputs))
        assert value == pytest.approx(wanted[output], abs=1e-12)
        for theirs, ours in jacobians.items():
            assert getattr(J, ours) == pytest.approx(wanted[theirs], abs=2e-6)  # theirs uses a threshold near zero


def test_quaternion_of_euler_angles_agrees_with_the_toolbox():
    for given, wanted in cases("rotations", "e2q"):
        value, stored = euler.to_quaternion.storage_jac(given["e"])
        assert value == pytest.approx(wanted["q"], abs=1e-14)
        assert stored.angles == pytest.approx(wanted["Q_e"], abs=1e-13)


def test_the_toolbox_takes_the_long_way_round_where_we_do_not():
    """Its q2v of a quaternion with negative real part gives a rotation vector longer than pi, for the same rotation."""
    for given, wanted in cases("rotations", "q2v_negative_real_part"):
        ours = quaternion.logarithm(given["q"])
        assert np.linalg.norm(ours) <= np.pi
        assert Rotation.from_rotvec(ours).as_matrix() == pytest.approx(
            Rotation.from_rotvec(wanted["v"]).as_matrix(), abs=1e-12
        )


def test_storage_jacobian_of_rotation_agrees_with_the_toolbox():
    for given, wanted in cases("rotations", "q2R"):
        value, J = quaternion.rotation.storage_jac(given["q"])
        assert value == pytest.approx(wanted["R"], abs=1e-14)
        columns_first = J.q.transpose(1, 0, 2).reshape(9, 4)  # it stacks the matrix by columns
        assert columns_first == pytest.approx(wanted["R_q"], abs=1e-14)


@pytest.mark.parametrize(
    ("function", "model", "inputs", "output", "jacobians"),
    [
        ("toFrame", pose.to_frame, ["F", "p_W"], "p_F", {"P_f": "pose", "P_p": "point"}),
        ("fromFrame", pose.from_frame, ["F", "p_F"], "p_W", {"P_f": "pose", "P_p": "point"}),
        ("composeFrames", pose.compose, ["F", "G"], "H", {"H_f": "outer", "H_g": "inner"}),
    ],
)
def test_frames_agree_with_the_toolbox_on_stored_numbers(function, model, inputs, output, jacobians):
    """The toolbox differentiates by the seven stored numbers; our storage Jacobians are the same ones."""
    for given, wanted in cases("frames", function):
        arguments = [given[name] for name in inputs]
        value, J = model.storage_jac(*arguments)
        assert value == pytest.approx(wanted[output], abs=1e-12)
        for theirs, ours in jacobians.items():
            assert getattr(J, ours) == pytest.approx(wanted[theirs], abs=1e-12)
        _, tangent = model.jac(*arguments)
        for index, name in enumerate(model.parameters):
            assert getattr(tangent, name) == pytest.approx(complex_step(model, arguments, index), abs=1e-12)


def test_the_inverse_frame_agrees_with_the_toolbox():
    for given, wanted in cases("frames", "invertFrame"):
        assert pose.inverse(given["F"]) == pytest.approx(wanted["iF"], abs=1e-12)
