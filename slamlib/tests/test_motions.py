"""Motion models: against their definitions, fine integration, and the toolbox's numbers."""

import numpy as np
import pytest

from slamlib.codegen import check_model
from slamlib.errors import UnknownNameError
from slamlib.geometry import euler, pose, quaternion
from slamlib.motions import CONSTANT_VELOCITY, ODOMETRY, constant_velocity, euler_composition, motion, odometry
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

MODELS = [odometry.step, constant_velocity.step, euler_composition.compose]


@pytest.fixture
def rng():
    return np.random.default_rng(7)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module)
def test_central_differences_and_a_batch_agree(model, rng):
    items = [
        [rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments]
        for _ in range(3)
    ]
    _, jacobians = model.jac(*items[0])
    for index in range(len(items[0])):
        numerical = differences(model, items[0], index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))
    value, many = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, single = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-13)
        assert many[0][n] == pytest.approx(single[0], abs=1e-12)


def test_odometry_is_a_composition(rng):
    state, control = ODOMETRY.manifold.random(rng), rng.standard_normal(6)
    increment = np.concatenate([control[:3], quaternion.exponential(control[3:])])
    moved = odometry.step(state, control, 0.1)
    assert pose.Pose.minus(moved, pose.compose(state, increment)) == pytest.approx(np.zeros(6), abs=1e-14)


def test_standing_still_changes_nothing_and_has_exact_jacobians(rng):
    state = ODOMETRY.manifold.random(rng)
    moved, J = odometry.step.jac(state, np.zeros(6), 0.1)
    assert moved == pytest.approx(state, abs=1e-15)
    assert J.state == pytest.approx(np.eye(6), abs=1e-15)
    assert J.control[3:, 3:] == pytest.approx(np.eye(3), abs=1e-15)
    state = CONSTANT_VELOCITY.manifold.random(rng)
    moved, J = constant_velocity.step.jac(state, np.zeros(6), 0.0)
    assert moved == pytest.approx(state, abs=1e-15)
    assert J.state == pytest.approx(np.eye(12), abs=1e-14)


def test_constant_velocity_is_integrated_exactly(rng):
    state, dt, parts = CONSTANT_VELOCITY.manifold.random(rng), 0.7, 4000
    q = state[3:7]
    for _ in range(parts):  # midpoint rule for dq/dt = Pi(q) omega / 2
        h = dt / parts
        middle = q + h / 4 * quaternion.pi_matrix(q) @ state[10:]
        q = q + h / 2 * quaternion.pi_matrix(middle) @ state[10:]
    moved = constant_velocity.step(state, np.zeros(6), dt)
    assert moved[3:7] == pytest.approx(q, abs=1e-6)
    assert moved[:3] == pytest.approx(state[:3] + dt * state[7:10], abs=1e-15)
    steps = state
    for _ in range(7):
        steps = constant_velocity.step(steps, np.zeros(6), dt / 7)
    assert CONSTANT_VELOCITY.manifold.minus(steps, moved) == pytest.approx(np.zeros(12), abs=1e-13)


def test_the_reports_composition_is_that_of_poses(rng):
    for _ in range(10):
        before = np.concatenate([rng.standard_normal(3), rng.uniform(-1, 1, 3)])
        control = np.concatenate([rng.standard_normal(3), rng.uniform(-0.5, 0.5, 3)])
        as_pose = [np.concatenate([p[:3], euler.to_quaternion(p[:2:-1])]) for p in (before, control)]
        expected = pose.compose(*as_pose)
        found = euler_composition.compose(before, control)
        assert found[:3] == pytest.approx(expected[:3], abs=1e-13)
        assert euler.to_rotation(found[:2:-1]) == pytest.approx(quaternion.rotation(expected[3:]), abs=1e-13)


def test_motions_are_found_by_the_toolboxs_names():
    assert motion("odometry") is ODOMETRY
    assert motion("constVel") is CONSTANT_VELOCITY
    with pytest.raises(
        UnknownNameError, match=r"unknown motion 'constvel'; did you mean 'constVel'\? Known: constVel, odometry"
    ):
        motion("constvel")


@pytest.mark.parametrize("function", ["odo3", "odo3_default_sim"])
def test_odometry_agrees_with_the_toolbox_on_stored_numbers(function):
    for given, wanted in cases("motion", function):
        moved, J = odometry.step.storage_jac(given["F"], given["u"], 0.0)
        assert moved == pytest.approx(wanted["F"], abs=1e-12)
        assert J.state == pytest.approx(wanted["F_f"], abs=1e-12)
        assert J.control == pytest.approx(wanted["F_u"], abs=1e-9)


def test_constant_velocity_agrees_with_the_toolboxs_simulator():
    """Its filter moves the quaternion by an Euler step instead, an approximation that we do not share."""
    for given, wanted in cases("motion", "constVel_value"):
        assert constant_velocity.step(given["X"], given["u"], given["dt"]) == pytest.approx(wanted["Xo"], abs=1e-12)
