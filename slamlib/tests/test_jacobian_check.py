"""check_jacobian passes what is right, and of what is wrong says which entries, and which slip where it can be told."""

import re

import numpy as np
import pytest

from slamlib import analytic
from slamlib.checks import CheckError, check_jacobian
from slamlib.errors import NonFiniteError, ShapeError
from slamlib.geometry.quaternion import left_matrix
from slamlib.models.numerical import complex_differences, differences

X, P = np.array([1.0, 2.0, 0.3]), np.array([4.0, 6.0])


def measure(x, p):
    """Range and bearing of a point from a pose in the plane."""
    dx, dy = p - x[:2]
    return np.array([np.hypot(dx, dy), np.arctan2(dy, dx) - x[2]])


def by_pose(x, p):
    (dx, dy), r = p - x[:2], np.hypot(*(p - x[:2]))
    return np.array([[-dx / r, -dy / r, 0.0], [dy / r**2, -dx / r**2, -1.0]])


def by_point(x, p):
    return -by_pose(x, p)[:, :2]


def power(x):
    """What takes complex numbers."""
    return np.array([x[0] * x[1], x[0] ** 2 + np.sin(x[1])])


def by_power(x):
    return np.array([[x[1], x[0]], [2 * x[0], np.cos(x[1])]])


def refused(f, J, *place):
    """The message of the refusal."""
    with pytest.raises(CheckError) as caught:
        check_jacobian(f, J, *place, silent=True)
    return str(caught.value)


@pytest.mark.parametrize(
    ("f", "J", "place", "by"),
    [
        (measure, by_pose, (X, P), "central differences"),
        (measure, by_pose(X, P), (X, P), "central differences"),
        (measure, lambda x, p: (by_pose(x, p), by_point(x, p)), (X, P), r"central differences \(2 comparisons\)"),
        (measure, (None, by_point(X, P)), (X, P), "central differences"),
        (power, by_power, ([2.0, 3.0],), "complex step"),
        (np.sin, np.cos, (0.3,), "complex step"),
        (np.linalg.norm, lambda x: x / np.linalg.norm(x), (X,), "central differences"),
        (lambda x: np.abs(x), lambda x: np.diag(np.sign(x)), (np.array([-2.0, 3.0]),), "central differences"),
        (lambda x, scale: {"m": 1.0, "mm": 1e3}[scale] * x, np.array([1e3]) * np.eye(2), (P, "mm"), "complex step"),
        (lambda x: 1e8 * x, 1e8 * np.eye(2), (1e6 * P,), "complex step"),
        (lambda x: 1e-8 * np.sqrt(x), lambda x: np.diag(0.5e-8 / np.sqrt(x)), (P,), "complex step"),
    ],
)
def test_a_right_jacobian_passes_and_it_is_said_by_what(f, J, place, by, capsys):
    check_jacobian(f, J, *place)
    assert re.search(f"holds: the Jacobian is the derivative, by {by}\n", capsys.readouterr().out)
    check_jacobian(f, J, *place, silent=True)
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("at", [(0, 0), (0, 1), (1, 0), (1, 1)])
@pytest.mark.parametrize("factor", [1.001, -1.0, np.nan])
def test_each_wrong_entry_is_named_with_its_two_values(at, factor):
    J = by_power(P)
    J[at] *= factor
    said = refused(power, J, P)
    assert f"entry {list(at)} is {J[at]:.6g}, should be {by_power(P)[at]:.6g}" in said
    assert said.count("entry") == 1


def test_a_hundredth_is_seen_by_differences_at_a_place_of_large_numbers():
    far = 1e7 * P
    J = far / np.hypot(*far)
    check_jacobian(lambda x: np.hypot(*x), J, far, silent=True)
    assert "entry [1]" in refused(lambda x: np.hypot(*x), J * [1.0, 1.01], far)


def test_a_small_error_is_seen_by_the_complex_step_also_of_a_small_entry_beside_large_ones():
    J = by_power(P)
    J[1, 1] += 1e-7
    assert "entry [1, 1]" in refused(power, J, P)
    pixels = np.array([[500.0, 1e-3]])
    check_jacobian(lambda x: pixels @ x, pixels, P, silent=True)
    assert "entry [0, 1]" in refused(lambda x: pixels @ x, pixels * [1.0, 1.0 + 1e-5], P)


@pytest.mark.parametrize(
    ("wrong", "slip"),
    [
        (lambda J: -J, "each of them has the wrong sign"),
        (lambda J: J * [[1, 1], [-1, 1]], "it has the wrong sign"),
        (lambda J: J.T, "this is the transpose"),
        (lambda J: J * [[1, 1], [0, 1]], "it is missing"),
        (lambda J: J * [[1, 1], [0.5, 1]], "it lacks a factor of 2"),
        (lambda J: 2 * J, "each of them is twice too large"),
        (lambda J: J * [1, 180 / np.pi], "each of them is off by 180/pi: degrees and radians"),
        (lambda J: J * [1, np.pi / 180], "each of them is off by pi/180: degrees and radians"),
        (lambda J: J * [1, 7.25], "each of them is 7.25 times what it should be"),
    ],
)
def test_a_likely_slip_is_recognized(wrong, slip):
    assert slip in refused(power, wrong(by_power(P)), P)


def test_what_is_no_single_slip_is_not_explained():
    said = refused(power, by_power(P) + np.array([[0.1, 0.0], [0.3, 0.0]]), P)
    assert "entry [0, 0]" in said
    assert "entry [1, 0]" in said
    assert not re.search("sign|transpose|missing|factor|times|degrees", said)


def test_the_worst_entries_come_first_and_the_others_are_counted():
    said = refused(measure, -10 * by_pose(X, P), X, P)
    assert said.index("entry [1, 2]") < said.index("entry [1, 0]")
    assert "and 1 more" in said


def test_the_argument_that_is_wrong_is_named():
    said = refused(measure, (by_pose(X, P), -by_point(X, P)), X, P)
    assert "argument 'p'" in said
    assert "argument 'x'" not in said


def test_shapes_and_places_at_which_nothing_can_be_checked():
    assert "has shape (3, 2), should have (2, 3)" in (said := refused(measure, by_pose(X, P).T, X, P))
    assert "transposed, it would fit" in said
    assert "transposed" not in refused(measure, np.eye(4), X, P)
    with pytest.raises(ShapeError, match="given 1 arguments, and J has 2"):
        check_jacobian(power, (by_power(P), np.eye(2)), P)
    with pytest.raises(NonFiniteError, match="check its Jacobian where the value is finite"):
        check_jacobian(lambda x: x + np.inf, np.eye(2), P)


def test_a_generated_model_is_a_function_like_others():
    q = np.array([0.1, 0.7, 0.5, 0.5])
    _, J = left_matrix.jac(q)
    check_jacobian(left_matrix, J, q, silent=True)
    assert "has the wrong sign" in refused(left_matrix, (-J[0],), q)


def test_differences_of_one_item_of_a_batch_and_with_other_arguments():
    at = np.random.default_rng(3).normal(size=(5, 3))
    found = differences(lambda x, s: s * np.sin(x), at, 2.0, step=[1e-5, 1e-6, 1e-7])
    assert found.shape == (5, 3, 3)
    assert found == pytest.approx(2 * np.cos(at)[..., None] * np.eye(3), abs=1e-7)
    assert complex_differences(np.sin, at[0]) == pytest.approx(np.diag(np.cos(at[0])), rel=1e-15)
    assert complex_differences(lambda x: np.arctan2(x, 1.0), at[0]) is None


@pytest.mark.parametrize("arctangent", [np.arctan2, analytic.arctan2])
@pytest.mark.parametrize("aside", [0, 1e-7, -1e-7])
def test_an_angle_may_jump_by_a_whole_turn(arctangent, aside):
    """A beacon straight behind the robot: the bearing is pi or -pi, and has a derivative all the same."""

    def bearing(robot, beacon):
        d = beacon - robot[:2]
        return np.array([arctangent(d[1], d[0]) - robot[2]])

    def right(robot, beacon):
        d = beacon - robot[:2]
        return np.array([[d[1], -d[0], -(d @ d)]]) / (d @ d)

    place = np.array([4, 1 + aside, 0.3]), np.array([-8.0, 1])
    check_jacobian(bearing, right, *place, silent=True)
    with pytest.raises(CheckError, match=r"entry \[0, 1\] .*\n.*it has the wrong sign"):
        check_jacobian(bearing, lambda *at: right(*at) * [1, -1, 1], *place)


@pytest.mark.parametrize("turns", [1, 2, -1])
def test_a_steep_function_that_gains_whole_turns_is_no_jump(turns):
    slope = turns * np.pi / 6e-6

    def steep(x):
        return slope * np.abs(x)

    check_jacobian(steep, np.array([[slope]]), np.array([0.5]), silent=True)
