"""Functions known by their inverse: the solution against brute force, the Jacobians, and what has no solution."""

import numpy as np
import pytest

from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError
from slamlib.geometry.pose import Pose
from slamlib.models import model
from slamlib.models.implicit import Implicit
from slamlib.sensors.pinhole import ideal_point


@model(bend=3, x=2, stretch=())
def bent(bend, x, stretch):
    """A plane that is bent a little; one to one for small coefficients. The unknown is not the first argument."""
    (a, b, c), (u, v) = bend, x
    return np.array([stretch * u + a * v * v + c * u * u * u, v + b * u * u])


@model(x=1, a=1)
def square(x, a):
    return x * x + a


def zero(value, *others):
    return 0 * value


def one(value, *others):
    return np.ones_like(value)


flatten = Implicit("flatten", bent, unknown="x", start=lambda value, bend, stretch: value)
root = Implicit("root", square, unknown="x", start=one)
BEND, STRETCH = np.array([0.1, -0.08, 0.05]), np.array(1.3)


def brute_force(value, bend, stretch):
    """The point of ever finer grids whose image is nearest to the value."""
    centre, width = np.array(value, dtype=float), 2.0
    for _ in range(70):
        grid = centre + width * np.stack(np.meshgrid(*[np.linspace(-1, 1, 9)] * 2), -1).reshape(-1, 2)
        images = np.array([bent.definition(bend, p, stretch) for p in grid])
        centre, width = grid[((images - value) ** 2).sum(-1).argmin()], width * 0.6
    return centre


@pytest.mark.parametrize("value", [[0.0, 0.0], [0.7, -0.4], [-1.0, 1.0], [1.2, 0.9]])
def test_the_solution_is_that_of_brute_force(value):
    x = flatten(value, BEND, STRETCH)
    np.testing.assert_allclose(x, brute_force(value, BEND, STRETCH), atol=1e-7)
    np.testing.assert_allclose(bent(BEND, x, STRETCH), value, rtol=0, atol=1e-15)


def bisected(radius, distortion):
    """Radius below the fold whose distorted value is `radius`, by halving an interval."""
    low, high = 0.0, 1 / np.sqrt(-3 * distortion[0])
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if middle * (1 + distortion[0] * middle**2) < radius else (low, middle)
    return low


@pytest.mark.parametrize("pixel", [[320.0, 240.0], [320.0, 241.0], [0.0, 0.0], [640.0, 480.0], [77.5, 311.25]])
def test_the_ideal_point_of_a_pixel_is_that_of_bisection(pixel):
    intrinsics, distortion = np.array([320, 240, 400, 410.0]), np.array([-0.1, *[0] * 7])
    distorted = (np.array(pixel) - intrinsics[:2]) / intrinsics[2:]
    radius = np.hypot(*distorted)
    wanted = distorted * (bisected(radius, distortion) / radius if radius else 1)
    np.testing.assert_allclose(ideal_point(pixel, intrinsics, distortion), wanted, atol=1e-14)


def test_its_jacobians_are_central_differences():
    value = np.array([0.7, -0.4])
    x, J = flatten.jac(value, BEND, STRETCH)
    assert J._fields == ("value", "bend", "stretch")
    assert J.stretch.shape == (2,)  # by a scalar
    for name, given in (("value", value), ("bend", BEND), ("stretch", STRETCH)):
        steps = 1e-6 * np.eye(given.size).reshape(-1, *given.shape)
        own = {"value": value, "bend": BEND, "stretch": STRETCH}
        columns = [(flatten(**{**own, name: given + d}) - flatten(**{**own, name: given - d})) / 2e-6 for d in steps]
        np.testing.assert_allclose(getattr(J, name), np.array(columns).T.reshape(2, *given.shape), atol=1e-9)
    np.testing.assert_array_equal(flatten(value, BEND, STRETCH), x)


def test_a_batch_is_a_loop_over_any_leading_axes():
    rng = np.random.default_rng(0)
    values, bends, stretches = (
        rng.uniform(-1, 1, (4, 2)),
        BEND + 0.02 * rng.standard_normal((3, 1, 3)),
        1 + rng.random(4),
    )
    x, J = flatten.jac(values, bends, stretches)
    assert x.shape == (3, 4, 2)
    assert [j.shape for j in J] == [(3, 4, 2, 2), (3, 4, 2, 3), (3, 4, 2)]
    for i, j in np.ndindex(3, 4):
        alone, own = flatten.jac(values[j], bends[i, 0], stretches[j])
        np.testing.assert_allclose(x[i, j], alone, atol=1e-15)
        for whole, item in zip(J, own, strict=True):
            np.testing.assert_allclose(whole[i, j], item, atol=1e-13)
    # one value, many of the others
    np.testing.assert_allclose(flatten(values[0], bends, STRETCH)[2, 0], flatten(values[0], bends[2, 0], STRETCH))
    assert flatten(values[:0], BEND, STRETCH).shape == (0, 2)
    assert flatten.jac(values[:0], BEND, STRETCH)[1].bend.shape == (0, 2, 3)


def test_a_batch_of_pixels_with_several_distortions():
    intrinsics = np.array([320, 240, 400, 410.0])
    distortions = np.array([[-0.1, *[0] * 7], [0.1, *[0] * 7], [0.0] * 8])
    found = ideal_point([300.0, 200.0], intrinsics, distortions)
    np.testing.assert_allclose(found, [ideal_point([300.0, 200.0], intrinsics, d) for d in distortions], atol=1e-15)


# -- no solution -------------------------------------------------------------------------------------------------------


def test_without_a_solution_it_says_for_which_value():
    np.testing.assert_allclose(root([9.0], [5.0]), [2.0])
    with pytest.raises(SingularPointError, match=r"root: no x gives the value \[-1.0\]; mask such values"):
        root([-1.0], [0.0])
    with pytest.raises(SingularPointError, match=r"root: no x gives the value \[-1.0\]"):
        root([[4.0], [-1.0], [9.0]], [0.0])
    with pytest.raises(SingularPointError, match=r"root: no x gives the value \[4.0\]"):
        root.jac([4.0], [[0.0], [5.0], [4.0]])


def test_a_lost_item_does_not_make_its_neighbours_wrong():
    """One item starts where the matrix has no inverse: only that one is lost, or found if it is there already."""
    flat = Implicit("flat", square, unknown="x", start=lambda value, a: np.where(value == 0, 0.0, 1.0) * value)
    np.testing.assert_allclose(flat([[0.0], [4.0], [9.0]], [0.0]), [[0.0], [2.0], [3.0]])
    stuck = Implicit("stuck", square, unknown="x", start=lambda value, a: np.where(value > 5, 0.0, 1.0) + 0 * a)
    np.testing.assert_allclose(stuck([[1.0], [4.0]], [0.0]), [[1.0], [2.0]])
    with pytest.raises(SingularPointError, match=r"stuck: no x gives the value \[9.0\]"):
        stuck([[1.0], [9.0], [4.0]], [0.0])


def test_a_solution_without_a_derivative_is_reported():
    at_bottom = Implicit("at_bottom", square, unknown="x", start=zero)
    np.testing.assert_array_equal(at_bottom([0.0], [0.0]), [0.0])
    with pytest.raises(SingularPointError, match=r"at_bottom has no derivative at \[0.0\]"):
        at_bottom.jac([0.0], [0.0])
    with pytest.raises(SingularPointError, match=r"mixed has no derivative at \[2.0\]"):
        Implicit("mixed", square, unknown="x", start=lambda value, a: value - a).jac([[1.0], [2.0]], [[0.0], [2.0]])


def test_pixels_beyond_the_fold_have_no_ideal_point():
    intrinsics, distortion = np.array([320, 240, 400, 400.0]), np.array([-0.2, *[0] * 7])
    fold = 1 / np.sqrt(0.6)
    most = fold * (1 - 0.2 * fold**2)
    inside, outside = [320 + 400 * most * 0.999, 240.0], [320 + 400 * most * 1.001, 240.0]
    assert ideal_point(inside, intrinsics, distortion)[0] < fold
    for lost in (outside, [inside, outside]):
        with pytest.raises(SingularPointError, match="beyond the fold"):
            ideal_point(lost, intrinsics, distortion)


# -- misuse ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (([0.1, 0.2], BEND), SlamlibError, r"flatten takes \(value, bend, stretch\); got 2 by position"),
        (([0.1, 0.2], BEND, STRETCH, 1), SlamlibError, "got 4 by position"),
        (([0.1, 0.2, 0.3], BEND, STRETCH), ShapeError, r"flatten: argument 'value' should have shape \(..., 2\)"),
        ((0.1, BEND, STRETCH), ShapeError, "argument 'value'"),
        (([0.1, 0.2], BEND[:2], STRETCH), ShapeError, r"argument 'bend' should have shape \(..., 3\)"),
        (([0.1, np.nan], BEND, STRETCH), NonFiniteError, "argument 'value' holds nan"),
        (([0.1, 0.2], [0.1, np.inf, 0], STRETCH), NonFiniteError, "argument 'bend' holds inf at index"),
        ((np.zeros((3, 2)), np.zeros((4, 3)), STRETCH), ShapeError, r"do not broadcast together: value \(3,\), bend"),
    ],
)
def test_wrong_arguments_are_named(arguments, error, message):
    before = [np.array(a) for a in arguments]
    for call in (flatten, flatten.jac):
        with pytest.raises(error, match=message):
            call(*arguments)
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(arguments, before, strict=True))


def test_names_of_arguments_are_checked():
    np.testing.assert_array_equal(
        flatten([0.1, 0.2], stretch=STRETCH, bend=BEND), flatten(value=[0.1, 0.2], bend=BEND, stretch=STRETCH)
    )
    with pytest.raises(SlamlibError, match=r"flatten takes .* \['bend', 'strech'\]"):
        flatten([0.1, 0.2], bend=BEND, strech=STRETCH)


def test_what_cannot_be_solved_for_is_refused_at_once():
    with pytest.raises(SlamlibError, match="bent has no argument 'y'"):
        Implicit("wrong", bent, unknown="y", start=zero)
    with pytest.raises(SlamlibError, match="should be plain vectors"):
        Implicit("wrong", bent, unknown="stretch", start=zero)

    @model(pose=Pose)
    def place(pose):
        return pose[:3]

    with pytest.raises(SlamlibError, match="should be plain vectors"):
        Implicit("wrong", place, unknown="pose", start=zero)
