"""Models: values, Jacobians, broadcasting, precision, and the errors for misuse."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import slamlib
from slamlib.analytic import cos, sin
from slamlib.codegen import check_model
from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError, UnitError
from slamlib.geometry import pose as frames
from slamlib.geometry.pose import Pose
from slamlib.models import compiler, model
from slamlib.models.numerical import central_difference, complex_step

GENERATED = Path(slamlib.__file__).parent / "generated"


@model(robot=3, control=2, dt=())
def unicycle(robot, control, dt):
    """A robot in the plane that drives and turns."""
    x, y, heading = robot
    speed, rate = control
    return np.array([x + speed * dt * cos(heading), y + speed * dt * sin(heading), heading + rate * dt])


@model(point=2)
def inverse_norm(point):
    """One over the squared norm: not defined at the origin."""
    return 1 / (point @ point)


@pytest.fixture
def rng():
    return np.random.default_rng(4)


def test_a_model_of_the_reader_compiles_in_memory_and_is_right(rng):
    robot, control, dt = rng.standard_normal(3), rng.standard_normal(2), 0.3
    value, jacobian = unicycle.jac(robot, control, dt)
    assert value == pytest.approx(unicycle.definition(robot, control, dt), abs=1e-15)
    by_hand = np.eye(3)
    by_hand[:2, 2] = control[0] * dt * np.array([-np.sin(robot[2]), np.cos(robot[2])])
    assert jacobian.robot == pytest.approx(by_hand, abs=1e-15)
    assert jacobian.control.shape == (3, 2)
    assert jacobian.dt.shape == (3,)
    check_model(unicycle, silent=True)


def test_arguments_by_name_and_by_position_are_the_same(rng):
    robot, control = rng.standard_normal(3), rng.standard_normal(2)
    assert np.array_equal(unicycle(robot, control, 0.1), unicycle(dt=0.1, control=control, robot=robot))
    with pytest.raises(SlamlibError, match=r"takes \(robot, control, dt\)"):
        unicycle(robot, control)
    with pytest.raises(SlamlibError, match="speed"):
        unicycle(robot, control, speed=1)


@pytest.mark.parametrize("lead", [(5,), (2, 3), (1,), (0,)])
def test_a_batch_is_a_loop(rng, lead):
    pose, points = Pose.random(rng), rng.standard_normal((*lead, 3))
    value, jacobian = frames.to_frame.jac(pose, points)
    assert value.shape == (*lead, 3)
    assert jacobian.pose.shape == (*lead, 3, 6)
    for item in np.ndindex(*lead):
        one, one_jacobian = frames.to_frame.jac(pose, points[item])
        assert value[item] == pytest.approx(one, abs=1e-14)
        assert jacobian.pose[item] == pytest.approx(one_jacobian.pose, abs=1e-14)
        assert jacobian.point[item] == pytest.approx(one_jacobian.point, abs=1e-14)


def test_leading_axes_broadcast_against_each_other(rng):
    poses = np.array([[Pose.random(rng)], [Pose.random(rng)]])
    points = rng.standard_normal((4, 3))
    value, jacobian = frames.to_frame.jac(poses, points)
    assert value.shape == (2, 4, 3)
    assert jacobian.point.shape == (2, 4, 3, 3)
    assert value[1, 2] == pytest.approx(frames.to_frame(poses[1, 0], points[2]), abs=1e-14)
    with pytest.raises(ShapeError, match=r"pose .*2.*point .*4"):
        frames.to_frame(poses[:, 0], points)


@pytest.mark.parametrize("lead", [(), (3,)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int64])
def test_precision_of_the_result_is_that_of_the_arguments(rng, lead, dtype):
    point = (10 * rng.standard_normal((*lead, 2))).astype(dtype)
    value, jacobian = inverse_norm.jac(point)
    expected = np.float32 if dtype == np.float32 else np.float64
    assert value.dtype == jacobian.point.dtype == expected
    assert value == pytest.approx(1 / (point.astype(float) ** 2).sum(-1), rel=1e-6 if dtype == np.float32 else 1e-14)


def test_complex_step_and_central_differences_agree_with_the_generated_jacobian(rng):
    arguments = [Pose.random(rng), Pose.random(rng)]
    _, jacobian = frames.compose.jac(*arguments)
    for index in (0, 1):
        assert jacobian[index] == pytest.approx(complex_step(frames.compose, arguments, index), abs=1e-13)
        assert jacobian[index] == pytest.approx(central_difference(frames.compose, arguments, index), abs=1e-8)


def test_storage_jacobian_is_the_plain_derivative(rng):
    pose, point = Pose.random(rng), rng.standard_normal(3)
    value, stored = frames.to_frame.storage_jac(pose, point)
    assert stored.pose.shape == (3, 7)
    for k in range(7):
        moved = pose.astype(complex)
        moved[k] += 1e-30j
        assert stored.pose[:, k] == pytest.approx(frames.to_frame.definition(moved, point).imag / 1e-30, abs=1e-13)
    assert value == pytest.approx(frames.to_frame(pose, point))


@pytest.mark.parametrize(
    ("by_storage", "what"), [(False, "it is not part of"), (True, "stored numbers are not kept in")]
)
def test_what_is_generated_at_the_first_use_says_that_it_needs_sympy(monkeypatch, by_storage, what):
    monkeypatch.setattr(compiler, "_registered", [])
    monkeypatch.setitem(sys.modules, compiler.COMPILER, None)
    with pytest.raises(SlamlibError, match=f"^to_frame: .*{what} slamlib .* needs sympy: pip install"):
        compiler.compile_in_memory(frames.to_frame, by_storage=by_storage)


ONES_OWN = """
import sys
import numpy as np
from slamlib.models import compiler, model

@model(a=2)
def twice(a):
    return 2 * a

print(compiler._registered, "slamlib.codegen" in sys.modules)
print(twice(np.ones(2)))
from slamlib.codegen.emit import module
print(compiler._registered == [module])
"""


def test_a_compiler_registers_itself_when_a_model_first_needs_one():
    run = subprocess.run([sys.executable, "-c", ONES_OWN], capture_output=True, text=True, timeout=120)
    assert run.stdout.splitlines() == ["[] False", "[2. 2.]", "True"], run.stderr


def test_derivatives_by_stored_numbers_are_not_in_the_package(rng):
    assert not [f for f in GENERATED.rglob("*.py") if "_storage_jac" in f.read_text("utf-8")]
    assert "def to_frame_storage_jac(pose, point):" in frames.to_frame.storage_code.TEXT


def test_wrong_shape_names_the_argument_the_shape_wanted_and_the_shape_given(rng):
    with pytest.raises(
        ShapeError, match=r"to_frame: argument 'point' should have shape \(\.\.\., 3\).* has shape \(2,\)"
    ):
        frames.to_frame(Pose.random(rng), np.zeros(2))
    with pytest.raises(ShapeError, match="'pose'"):
        frames.to_frame(1.0, np.zeros(3))
    with pytest.raises(ShapeError, match="should hold numbers"):
        inverse_norm(np.array(["a", "b"]))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("lead", [(), (4,)])
def test_non_finite_arguments_are_named_with_their_place(rng, bad, lead):
    points = rng.standard_normal((*lead, 3))
    points[(*(2 for _ in lead), 1)] = bad
    with pytest.raises(NonFiniteError, match=r"to_frame: argument 'point' holds .* at index \(.*1"):
        frames.to_frame(Pose.random(rng), points)


def test_a_quaternion_that_is_not_unit_is_refused_not_normalised(rng):
    pose = Pose.random(rng)
    pose[3:] *= 1.01
    with pytest.raises(UnitError, match=r"to_frame: argument 'pose' should be a unit quaternion, but has length 1\.01"):
        frames.to_frame(pose, np.zeros(3))


def test_a_singular_point_is_reported_and_not_returned_as_nan():
    with pytest.raises(SingularPointError, match="inverse_norm"):
        inverse_norm(np.zeros(2))
    with pytest.raises(SingularPointError, match=r"item \(1,\)"):
        inverse_norm.jac(np.array([[1.0, 2], [0, 0]]))


def test_the_decorator_must_name_the_arguments_of_the_function():
    with pytest.raises(SlamlibError, match="decorator names"):

        @model(a=2)
        def f(b):
            return b


def test_arguments_are_never_written_to(rng):
    robot, control = rng.standard_normal(3), rng.standard_normal(2)
    before = robot.copy(), control.copy()
    robot.flags.writeable = control.flags.writeable = False
    unicycle.jac(robot, control, 0.1)
    assert np.array_equal(robot, before[0])
    assert np.array_equal(control, before[1])
