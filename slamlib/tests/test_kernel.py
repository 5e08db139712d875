"""The generator's arithmetic and the batches: shared entries, powers, constants, products of Jacobians."""

import inspect

import numpy as np
import pytest
import sympy

from slamlib.analytic import arctan2, norm_plus, sin, stumpff
from slamlib.codegen import check_model
from slamlib.codegen.emit import factored, unified
from slamlib.codegen.printer import Printer
from slamlib.errors import ShapeError, SingularPointError
from slamlib.geometry import plucker
from slamlib.geometry.pose import ORIGIN, Pose, compose, from_frame
from slamlib.landmarks.ahm_point import to_frame
from slamlib.landmarks.idp_point import angles_moved
from slamlib.models import model
from slamlib.models.in_memory import is_affine
from slamlib.observation.points import product
from slamlib.sensors.pinhole import PINHOLE, pixel, project
from slamlib.sensors.sensor import Calibration

x, y, z = sympy.symbols("x y z", real=True)


def printed(expression):
    printer = Printer(f"t{i}" for i in range(99))
    return printer.doprint(expression), printer.lines


def test_powers_and_reciprocals_are_lines_and_are_computed_once():
    assert printed(x / y**4) == ("t2*x", ["t0 = 1/y", "t1 = t0*t0", "t2 = t1*t1"])
    text, lines = printed(x**4 * z**-9)
    assert text == "t0*t4"
    assert lines == ["t0 = 1/z", "t1 = t0*t0", "t2 = t1*x", "t3 = t2*t2", "t4 = t3*t3"]


@pytest.mark.parametrize(
    "expression",
    [x * y**-3 / 2, -2 * x * y, x**12 / y, -x / (y + z) ** 3, sympy.sqrt(x) ** 3 / z, 3 / x, x**8 * z**-17],
)
def test_printed_lines_compute_the_expression(expression):
    text, lines = printed(expression)
    values = {"x": 1.3, "y": -0.7, "z": 1.9, "sqrt": np.sqrt}
    exec("\n".join([*lines, f"result = {text}"]), values)
    assert values["result"] == pytest.approx(float(expression.subs({x: 1.3, y: -0.7, z: 1.9})), rel=1e-14)


def test_entries_that_are_equal_once_expanded_share_an_expression():
    first = (x + y) * z
    assert unified([first, x * z + y * z, -x * z - y * z, x * (y + 1) - x * y - x]) == [first, first, -first, 0]
    assert unified([1 / (x + y), (x + y) / (x + y) ** 2]) == [1 / (x + y), 1 / (x + y)]


def test_the_turn_of_a_pose_is_the_cross_product_with_the_value():
    rng = np.random.default_rng(0)
    pose, landmark = Pose.random(rng), rng.standard_normal((5, 7))
    value, jacobians = to_frame.jac(pose, landmark)
    assert np.array_equal(jacobians.pose[:, 0, 4], -value[:, 2])
    assert (jacobians.pose[:, [0, 1, 2], [3, 4, 5]] == 0).all()


@pytest.mark.parametrize("depth", [1e-4, 1e4])
def test_high_powers_of_the_depth_do_not_leave_single_precision(depth):
    point = (depth * np.array([[0.3, -0.2, 1, 0.1]])).astype(np.float32)
    wide = project.jac(point.astype(float), np.array([320.0, 240, 500, 500]), np.full(8, 0.01))
    narrow = project.jac(point, *(np.array(a, dtype=np.float32) for a in ([320, 240, 500, 500], np.full(8, 0.01))))
    assert narrow[0].dtype == np.float32
    for a, b in zip([narrow[0], *narrow[1]], [wide[0], *wide[1]], strict=True):
        assert np.allclose(a, b, rtol=1e-4, atol=1e-4 * np.abs(b).max())


@model(a=2)
def constants(a):
    """Zeros, ones and a half beside a variable."""
    return np.array([0 * a[0], 1 + 0 * a[0], a[1], a[0] - a[0]])


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.complex128])
@pytest.mark.parametrize("lead", [(), (3,), (0,), (2, 2)])
def test_constant_entries_fill_every_item_of_every_batch(dtype, lead):
    for _ in range(2):
        value, jacobian = constants.jac(np.full((*lead, 2), 7, dtype=dtype))
        assert value.dtype == dtype
        assert np.array_equal(value, np.broadcast_to(np.array([0, 1, 7, 0], dtype=dtype), (*lead, 4)))
        assert np.array_equal(jacobian.a, np.broadcast_to([[0, 0], [0, 0], [0, 1], [0, 0]], (*lead, 4, 2)))


@pytest.mark.parametrize(
    "lead", [((), ()), ((4,), ()), ((4,), (4,)), ((2, 3), ()), ((2, 3), (2, 3)), ((0,), ()), ((2, 1), (2, 3))]
)
def test_a_product_of_jacobians_is_the_matrix_product(lead):
    rng = np.random.default_rng(1)
    left, right = rng.standard_normal((*lead[0], 2, 4)), rng.standard_normal((*lead[1], 4, 5))
    assert product(left, right) == pytest.approx(left @ right, abs=1e-14)


def test_a_composed_pose_has_one_item_or_many():
    rng = np.random.default_rng(2)
    outer, inner = Pose.random(rng), np.array([Pose.random(rng) for _ in range(3)])
    value, jacobians = compose.jac(outer, inner)
    for i in range(3):
        one, one_jacobians = compose.jac(outer, inner[i])
        assert value[i] == pytest.approx(one, abs=1e-14)
        assert jacobians.inner[i] == pytest.approx(one_jacobians.inner, abs=1e-14)


def test_what_one_model_hands_on_to_another_is_a_line_with_its_name():
    lines = inspect.getsource(project.code.project_jac)
    assert "ideal0 = point0*t0\n" in lines
    point, others = np.array([0.3, -0.2, 1.5, 0.1]), (np.array([320.0, 240, 500, 500]), np.full(8, 0.01))
    _, jacobians = project.jac(point, *others)
    _, by_ideal = pixel.jac(point[:2] / point[2], *others)
    chain = by_ideal.ideal @ np.array([[1, 0, -0.3 / 1.5], [0, 1, 0.2 / 1.5]]) / 1.5
    assert jacobians.point[:, :3] == pytest.approx(chain, rel=1e-14)


def test_entries_are_recognized_through_roots_and_stages():
    root, s = sympy.sqrt(x * x + y * y), sympy.Symbol("s", real=True)
    assert unified([x * root, x * root**3 / (x * x + y * y), root / root]) == [x * root, x * root, 1]
    assert unified([s * x, x * x + x * y], {s: x + y}) == [s * x, s * x]


def test_common_factors_are_taken_out_of_every_sum():
    assert factored(x * y + x * z, {}) == x * (y + z)
    assert str(factored(-2 * x * y - 4 * z, {})) == "-2*(x*y + 2*z)"
    assert str(factored(sympy.sqrt(x * z + y * z) / 2 + x / 2, {})) == "(x + sqrt(z*(x + y)))/2"


@pytest.mark.parametrize("count", [1, 2, 8])
def test_a_model_for_fewer_coefficients_is_the_model_with_zeros(count):
    point, intrinsics = np.array([[0.3, -0.2, 1.5, 0.1], [-0.1, 0.4, 0.9, 1]]), np.array([320.0, 240, 500, 500])
    given = 0.02 / np.arange(1.0, 1 + count)
    short = project.shortened(4, 4, count)
    check_model(short, points=3, silent=True)
    value, jacobians = short.jac(point, intrinsics, given)
    whole, expected = project.jac(point, intrinsics, np.pad(given, (0, 8 - count)))
    assert np.array_equal(value, whole)
    assert np.array_equal(short(point, intrinsics, given), project(point, intrinsics, np.pad(given, (0, 8 - count))))
    for a, b in zip(jacobians, expected, strict=True):
        assert np.array_equal(a, b[..., : a.shape[-1]])


@pytest.mark.parametrize("first", [ORIGIN, Pose.random(np.random.default_rng(2))], ids=["origin", "anywhere"])
@pytest.mark.parametrize("known", [compose, from_frame, plucker.from_frame, angles_moved], ids=lambda m: m.module)
def test_a_jacobian_where_the_first_argument_is_known_is_the_same_to_the_bit(known, first):
    second, rng = known.arguments[1], np.random.default_rng(3)
    for count in (1, 3, 50):
        there = np.array([second.manifold.random(rng) for _ in range(count)])
        assert np.array_equal(known.jac_where(first, there), known.jac(first, there)[1][0])
        assert np.array_equal(known.jac_where(first, there[0]), known.jac(first, there[0])[1][0])
    with pytest.raises(ShapeError, match=f"{known.name}: argument '{second.name}'"):
        known.jac_where(first, np.zeros(second.size + 1))
    with pytest.raises(ShapeError, match=f"{known.name}: argument '{known.arguments[0].name}'"):
        known.jac_where(first[:6], second.manifold.random(rng))


@pytest.mark.parametrize("known", [compose, from_frame, plucker.from_frame, angles_moved], ids=lambda m: m.module)
def test_the_entries_where_the_first_argument_is_known_are_those_of_that_jacobian(known):
    second = known.arguments[1]
    there = second.manifold.random(np.random.default_rng(4))
    entries = known.entries_where(ORIGIN)(there.tolist())
    assert np.array_equal(np.array(entries, dtype=float), known.jac_where(ORIGIN, there).ravel())


@pytest.mark.parametrize(
    ("entries", "affine"),
    [
        (lambda n: (1, n[0], -n[1], 2 * n[0] - n[1] / 3 + 1, 1 - (n[0] - 2)), True),
        (lambda n: (n[0] * n[1],), False),
        (lambda n: (n[0] * n[0],), False),
        (lambda n: (1 / n[0],), False),
        (lambda n: (n[0] / n[1],), False),
        (lambda n: (n[0] ** 2,), False),
        (lambda n: (sin(n[1]),), False),
        (lambda n: (arctan2(n[0], n[1]),), False),
        (lambda n: (norm_plus(n[0], n[1]),), False),
        (lambda n: (stumpff(2, n[0]),), False),
        (lambda n: (abs(n[0]),), False),
    ],
)
def test_a_function_is_affine_where_it_takes_sums_and_multiples_alone(entries, affine):
    assert is_affine(entries, 2) is affine


@model(scale=2, vector=3)
def scaled(scale, vector):
    """A vector divided by two numbers."""
    return vector / (scale[0] * scale[1])


def test_a_known_point_without_a_derivative_is_reported():
    with pytest.raises(SingularPointError, match="scaled is not defined, or has no derivative"):
        scaled.jac_where((1.0, 0.0), np.ones(3))


@model(pose=Pose, sequence=3, returns=Pose)
def pushed(pose, sequence):
    """A pose moved ahead by a polynomial of its height."""
    length = sequence[0] + pose[2] * sum(sequence[1:] * pose[2])
    return np.concatenate([pose[:2] + length, pose[2:]])


def test_fewer_coefficients_beside_a_manifold():
    short = pushed.shortened(7, 1)
    check_model(short, points=3, silent=True)
    at = np.array([0.1, 0.2, 0.3, 1, 0, 0, 0])
    assert short.storage_jac(at, np.ones(1))[1].sequence.shape == (7, 1)
    assert short.jac(at, np.ones(1))[1].sequence == pytest.approx(pushed.jac(at, np.eye(3)[0])[1].sequence[:, :1])
    assert pushed.shortened(7, 3) is pushed


def test_a_calibration_computes_with_the_coefficients_that_it_has():
    camera = Calibration(PINHOLE, np.eye(2), intrinsics=[320, 240, 500, 500], distortion=[-0.2])
    point = np.array([[0.3, -0.2, 1.5, 0.1]])
    value, jacobians = camera.project_jac(point)
    assert jacobians.distortion.shape == (1, 2, 1)
    assert np.array_equal(value, project(point, **camera.given))
    bare = Calibration(PINHOLE, np.eye(2), intrinsics=[320, 240, 500, 500], distortion=[])
    assert bare.project_jac(point)[1].distortion.shape == (1, 2, 0)
