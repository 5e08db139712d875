"""Motions in the plane: planar odometry and the unicycle, by themselves and as the motion of a robot in the filter."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.codegen import check_model
from slamlib.errors import SlamlibError
from slamlib.experiments.presets import Preset
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose2 import Pose2, exponential, from_space, in_space
from slamlib.motions import MOTIONS, odometry
from slamlib.motions.plane_odometry import PLANE_ODOMETRY
from slamlib.motions.plane_odometry import step as plane_step
from slamlib.motions.unicycle import UNICYCLE
from slamlib.motions.unicycle import step as unicycle_step
from slamlib.records.inputs import Control
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Options, Slam
from slamlib.tests.differences import differences

BOTH = [PLANE_ODOMETRY, UNICYCLE]
RATES = [0.0, 1e-9, -1e-4, 0.4, -2.0, np.pi, 40.0]  # [rad/s]; the last turns more than once
FLOOR = [0, 1, 5]  # of six numbers those that a robot on the floor has: x, y and the turn about the vertical


@pytest.fixture
def rng():
    return np.random.default_rng(77)


def lifted(displacement):
    """The same small motion (3,) as six numbers."""
    six = np.zeros(6)
    six[FLOOR] = displacement
    return six


def test_both_are_known_by_their_names_and_say_which_numbers_are_angles():
    for kind, angles in ((PLANE_ODOMETRY, (2,)), (UNICYCLE, (1,))):
        assert MOTIONS[kind.name] is kind
        assert kind.angles == angles
        control = [1.0] * kind.control
        radians = np.array(control)
        radians[list(angles)] = np.radians(1.0)
        robot = RobotSetup(motion=kind.name, control=tuple(control), control_std=tuple(control))
        assert robot.nominal == pytest.approx(radians, abs=1e-15)
        assert np.sqrt(robot.noise.diagonal()) == pytest.approx(radians, abs=1e-15)


@pytest.mark.parametrize("model", [plane_step, unicycle_step], ids=lambda m: m.module)
def test_value_and_jacobians_are_those_of_the_definition(model, rng):
    check_model(model, silent=True)
    arguments = [Pose2.random(rng), rng.standard_normal(model.arguments[1].shape), 0.7]
    _, J = model.jac(*arguments)
    for index in range(3):
        assert J[index] == pytest.approx(differences(model, arguments, index), abs=1e-7)


@pytest.mark.parametrize("rate", RATES)
def test_jacobians_of_the_unicycle_at_every_rate_of_turn(rate, rng):
    check_model(unicycle_step, sample=lambda r: [Pose2.random(r), np.array([1.5, rate]), 0.5], points=3, silent=True)


def test_jacobians_of_planar_odometry_by_hand(rng):
    state, control = Pose2.random(rng), rng.standard_normal(3)
    c, s = np.cos(state[2]), np.sin(state[2])
    C, right_angle = np.array([[c, -s], [s, c]]), np.array([[0, -1], [1, 0]])
    F, F_u = np.eye(3), np.eye(3)
    F[:2, 2], F_u[:2, :2] = C @ right_angle @ control[:2], C
    _, J = plane_step.jac(state, control, 0.1)
    assert J.state == pytest.approx(F, abs=1e-14)
    assert J.control == pytest.approx(F_u, abs=1e-14)
    assert np.array_equal(J.dt.ravel(), np.zeros(3))


@pytest.mark.parametrize("rate", RATES)
def test_the_unicycle_ends_where_fine_steps_along_its_arc_end(rate, rng):
    state, speed, dt = Pose2.random(rng), 1.5, 0.5
    moved = unicycle_step(state, np.array([speed, rate]), dt)
    headings = state[2] + rate * dt * (np.arange(20000) + 0.5) / 20000
    there = state[:2] + speed * dt * np.array([np.cos(headings).mean(), np.sin(headings).mean()])
    assert moved[:2] == pytest.approx(there, abs=1e-7)
    assert moved[2] == pytest.approx(state[2] + rate * dt, abs=1e-14)
    euler = state[:2] + speed * dt * np.array([np.cos(state[2]), np.sin(state[2])])
    assert (np.abs(moved[:2] - euler).max() > 0.01) == (abs(rate) > 0.1)


@pytest.mark.parametrize("rate", RATES)
def test_the_unicycle_drives_where_it_points(rate, rng):
    """Its rates of change, by the time, are v cos(theta), v sin(theta) and omega, at the end of any step."""
    state, speed = Pose2.random(rng), 1.5
    moved, J = unicycle_step.jac(state, np.array([speed, rate]), 0.5)
    rates = [speed * np.cos(moved[2]), speed * np.sin(moved[2]), rate]
    assert J.dt.ravel() == pytest.approx(rates, abs=1e-12)


@pytest.mark.parametrize("rate", RATES)
def test_two_steps_are_one_of_the_whole_time(rate, rng):
    state, control = Pose2.random(rng), np.array([1.5, rate])
    halfway = unicycle_step(state, control, 0.2)
    whole = unicycle_step(state, control, 0.5)
    assert unicycle_step(halfway, control, 0.3) == pytest.approx(whole, abs=1e-13)


def test_a_robot_that_does_not_turn_drives_straight_on():
    state = np.array([1.0, 2.0, np.radians(30)])
    ahead = 0.75 * np.array([np.cos(state[2]), np.sin(state[2])])
    assert unicycle_step(state, np.array([1.5, 0.0]), 0.5) == pytest.approx([*(state[:2] + ahead), state[2]], abs=1e-15)
    assert unicycle_step(state, np.array([0.0, 0.5]), 0.5) == pytest.approx([*state[:2], state[2] + 0.25], abs=1e-15)


def test_half_a_circle_ends_across_its_diameter():
    moved = unicycle_step(np.zeros(3), np.array([0.5, np.radians(18)]), 10.0)
    assert moved == pytest.approx([0, 2 * 0.5 / np.radians(18), np.pi], abs=1e-14)


@pytest.mark.parametrize("kind", BOTH, ids=lambda k: k.name)
def test_in_space_the_same_motion_is_odometry(kind, rng):
    """in_space(step(x, u)) = step in space(in_space(x), lifted u), and so for their Jacobians."""
    for _ in range(10):
        state, control, dt = Pose2.random(rng), rng.standard_normal(kind.control), 0.3
        moved, J = kind.step.jac(state, control, dt)
        displacement, J_d = small_motion(kind, control, dt)
        there, J_space = odometry.step.jac(in_space(state), lifted(displacement), dt)
        assert Pose.minus(in_space(moved), there) == pytest.approx(np.zeros(6), abs=1e-14)
        assert kind.pose(moved) == pytest.approx(in_space(moved), abs=1e-15)
        assert Pose2.minus(from_space(there), moved) == pytest.approx(np.zeros(3), abs=1e-14)
        assert J_space.state[np.ix_(FLOOR, FLOOR)] == pytest.approx(J.state, abs=1e-14)
        assert J_space.control[np.ix_(FLOOR, FLOOR)] @ J_d == pytest.approx(J.control, abs=1e-14)


def small_motion(kind, control, dt):
    """The displacement and turn (3,) of a step in the robot's own frame, and their Jacobian (3, c) by the control."""
    if kind is PLANE_ODOMETRY:
        return control, np.eye(3)
    by_control = np.array([[dt, 0], [0, 0], [0, dt]])
    displacement, J = exponential.jac(by_control @ control)
    return displacement, J.twist @ by_control


def preset(kind):
    """A robot of this motion that drives on an arc among landmarks."""
    control, std = {
        "planeOdometry": ((0.08, 0.01, 0.9), (0.02, 0.01, 0.2)),
        "unicycle": ((0.8, 9.0), (0.2, 2.0)),  # the same path, at ten frames a second
    }[kind.name]
    robot = RobotSetup(motion=kind, position=(0, -5, 0), euler=(0, 0, 10), control=control, control_std=std)
    sensor = SensorSetup(type="rangeBearing", euler=(0, 0, 0), position=(0.2, 0.1, 0.6), std=(0.05, 0.01, 0.01))
    return Preset(kind.name, Rig((robot,), (sensor,)), Options(points="eucPnt"), frames=40, noise_in="truth")


def frame_in_space(kind, frame, *, straight_on=False):
    """The frame with the control of a robot in space; straight_on: as if it pointed straight ahead."""
    (control,) = frame.controls
    displacement, J = small_motion(kind, control.value, frame.dt)
    if straight_on:
        displacement = np.array([np.linalg.norm(displacement[:2]), 0, displacement[2]])
    covariance = np.zeros((6, 6))
    covariance[np.ix_(FLOOR, FLOOR)] = J @ control.covariance @ J.T
    return replace(frame, controls=(Control(lifted(displacement), covariance),))


@pytest.mark.parametrize("kind", BOTH, ids=lambda k: k.name)
def test_the_filter_ends_where_that_of_a_robot_in_space_ends(kind):
    rig = preset(kind).rig
    (robot,) = rig.robots
    in_air = Rig((RobotSetup(position=robot.position, euler=robot.euler),), rig.sensors)
    plane, space, wrong = (Slam(r, options=preset(kind).options) for r in (rig, in_air, in_air))
    for frame, _ in preset(kind).simulate():
        plane.step(frame)
        space.step(frame_in_space(kind, frame))
        wrong.step(frame_in_space(kind, frame, straight_on=True))
    assert plane.belief.size == space.belief.size - 3
    assert len(plane.landmarks) > 20
    assert np.abs(Pose.minus(plane.robots[0].pose, space.robots[0].pose)).max() < 1e-9
    assert plane.robot.pose_covariance == pytest.approx(space.robot.pose_covariance, abs=1e-12)
    for one, other in zip(plane.landmarks, space.landmarks, strict=True):
        assert one.block.mean == pytest.approx(other.block.mean, abs=1e-9)
        P = space.belief.covariance(other.block)
        assert plane.belief.covariance(one.block) == pytest.approx(P, abs=1e-10)
    assert np.abs(Pose.minus(plane.robots[0].pose, wrong.robots[0].pose)).max() > 1e-6


@pytest.mark.parametrize("kind", BOTH, ids=lambda k: k.name)
def test_a_start_off_the_floor_is_refused(kind):
    robot = RobotSetup(motion=kind, position=(1, 2, 0), euler=(0, 0, 190))
    assert Pose2.minus(robot.state, np.array([1, 2, np.radians(190)])) == pytest.approx(np.zeros(3), abs=1e-14)
    for wrong in ({"position": (0, 0, 1.0)}, {"euler": (0, 10.0, 0)}):
        with pytest.raises(SlamlibError, match=f"robot: by {kind.name} no robot can have the pose"):
            _ = RobotSetup(motion=kind, **wrong).state
