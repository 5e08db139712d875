"""The omnidirectional camera: definitions, nasty points, the toolbox's numbers, published polynomials, bad input."""

import mpmath
import numpy as np
import pytest

from slamlib.codegen import check_model
from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError, UnknownNameError
from slamlib.geometry.quaternion import pi_matrix
from slamlib.landmarks.ahm_point import AHM_POINT
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.observation.points import initialize, observe
from slamlib.sensors import omni, scaramuzza, sensor
from slamlib.sensors.sensor import Calibration
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

FORWARD = np.array([644.7, -341.0, -29.01, -57.70, 18.49, 5.415, 50.65, -56.14, 15.91])
BACKWARD = np.array([447.3, 0, -1.068e-3, 1.184e-6, -1.856e-9])
FIELD = np.radians(95)
LENS = scaramuzza.polynomials(FIELD, backward=BACKWARD).lens
INTRINSICS = np.array([668.0, 438.0, 1.01, 0.002, -0.003])
MODELS = [omni.angles, omni.image, omni.pixel, omni.project, omni.ray, scaramuzza.project, scaramuzza.back_project]


def camera(lens=LENS, **changes):
    given = {"image": (1280, 800), "limits": {"angle": FIELD}, "intrinsics": INTRINSICS, "lens": lens, **changes}
    return Calibration(omni.OMNI, np.eye(2), **given)


def towards(angle, azimuth, w=0.3):
    """Homogeneous point at an angle from the axis."""
    angle, azimuth = np.broadcast_arrays(angle, azimuth)
    across = np.sin(angle)
    return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), np.cos(angle), w + 0 * across], axis=-1)


@pytest.fixture
def rng():
    return np.random.default_rng(9)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module.split(".")[-1] + "." + m.name)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.module.split(".")[-1] + "." + m.name)
def test_central_differences_and_a_batch_agree(model, rng):
    items = [[0.5 * rng.standard_normal(a.shape) + 0.2 for a in model.arguments] for _ in range(3)]
    _, jacobians = model.jac(*items[0])
    for index in range(len(items[0])):
        numerical = differences(model, items[0], index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))
    value, many = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, single = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-12)
        assert many[0][n] == pytest.approx(single[0], abs=1e-12)


@pytest.mark.parametrize("short", [0.5, 1e-2, 1e-6, 1e-8, 1e-10, 1e-14])
def test_close_to_straight_back_the_angle_and_its_jacobian_keep_their_digits(short):
    point = np.array([0.6 * short, 0.8 * short, -1.0, 0.0])
    with mpmath.workdps(60):

        def angles(*place):
            x, y, z = place
            n = mpmath.hypot(x, y)
            return mpmath.matrix([mpmath.atan2(n, z) / n * x, mpmath.atan2(n, z) / n * y])

        place = [mpmath.mpf(float(number)) for number in point[:3]]
        wanted = np.array(angles(*place).tolist(), dtype=float)[:, 0]
        step = short * mpmath.mpf(10) ** -25
        slopes = []
        for k in range(3):
            ahead, behind = ([p + sign * step * (i == k) for i, p in enumerate(place)] for sign in (1, -1))
            slopes.append(np.array(((angles(*ahead) - angles(*behind)) / (2 * step)).tolist(), dtype=float)[:, 0])
    found, J = omni.angles.jac(point)
    assert found == pytest.approx(wanted, abs=2e-15)
    assert np.abs(J.point[:, :3] - np.transpose(slopes)).max() < 3e-15 * np.abs(slopes).max()
    assert np.linalg.norm(found) < np.pi


@pytest.mark.parametrize("degrees", [0.0, 1e-13, 1e-6, 0.3, 45.0, 89.999, 90.0, 90.001, 94.9])
@pytest.mark.parametrize("azimuth", [0.0, 0.7, np.pi / 2, -np.pi])
def test_the_whole_field_is_smooth_also_on_the_axis_and_behind_the_chip(degrees, azimuth):
    cal, point = camera(), towards(np.radians(degrees), azimuth)
    assert cal.visible(point)
    pixel, J = cal.project_jac(point)
    numerical = np.stack([cal.project(point + d) - cal.project(point - d) for d in 1e-6 * np.eye(4)], axis=-1) / 2e-6
    assert J.point == pytest.approx(numerical, abs=2e-5)
    assert (J.point[:, 3] == 0).all()
    again, K = cal.back_project_jac(pixel, point[3:])
    assert again == pytest.approx(point, abs=1e-12)
    tangent = np.eye(3) - np.outer(point[:3], point[:3])
    assert K.measurement[:3] @ J.point[:, :3] == pytest.approx(tangent, abs=1e-9)
    assert K.unmeasured.ravel() == pytest.approx([0, 0, 0, 1])
    for name, size in (("intrinsics", 5), ("lens", 9)):  # y(x(y, k), k) = y: the Jacobians by k cancel
        assert getattr(K, name).shape == (4, size)
        left = getattr(J, name) + J.point @ getattr(K, name)
        assert left == pytest.approx(np.zeros((2, size)), abs=1e-8 * max(1, np.abs(getattr(J, name)).max()))


def test_the_image_is_that_of_the_formula(rng):
    """Radius along the azimuth, then the affine part: written once more, with an arccosine, from the text alone."""
    for _ in range(20):
        angle, azimuth = rng.uniform(0.1, 1.6), rng.uniform(-np.pi, np.pi)
        r = sum(b * angle**k for b, k in zip(LENS, [1, *range(3, 11)], strict=True))
        u, v = r * np.cos(azimuth), r * np.sin(azimuth)
        xc, yc, c, d, e = INTRINSICS
        assert camera().project(5 * towards(angle, azimuth)) == pytest.approx([u + e * v + xc, d * u + c * v + yc])


def test_the_fisheye_of_opencv_is_a_special_case(rng):
    """Its model: theta_d = theta (1 + k1 theta^2 + ... + k4 theta^8), x = fx theta_d a / r + cx, and likewise for y."""
    k, (fx, fy, cx, cy) = np.array([0.0035, 0.0007, -0.0021, 0.0002]), (190.98, 190.97, 254.93, 256.90)
    lens = fx * np.array([1, k[0], 0, k[1], 0, k[2], 0, k[3]])
    cal = camera(lens, intrinsics=[cx, cy, fy / fx, 0, 0], image=None, limits=None)
    point = rng.standard_normal((50, 4)) + np.array([0, 0, 2, 0])
    point = point[point[:, 2] > 0]
    a, b = point[:, 0] / point[:, 2], point[:, 1] / point[:, 2]
    r = np.hypot(a, b)
    theta = np.arctan(r)
    distorted = theta * (1 + k[0] * theta**2 + k[1] * theta**4 + k[2] * theta**6 + k[3] * theta**8)
    wanted = np.stack([fx * distorted / r * a + cx, fy * distorted / r * b + cy], axis=-1)
    assert cal.project(point) == pytest.approx(wanted, abs=1e-9)


def test_visible_by_the_angle_not_by_the_depth():
    cal = camera()
    degrees = np.array([0.0, 89.0, 91.0, 94.99, 95.01, 120.0, 180.0])
    assert cal.visible(towards(np.radians(degrees), 0.3)).tolist() == [True] * 4 + [False] * 3
    assert cal.visible(np.array([0.0, 0, -1, 1])) == np.False_
    points = towards(np.radians(degrees), np.pi)  # to the left, where the image has room
    nowhere = np.array([0, 0, 0, 1.0, 0, 0, 0])
    seen = observe(EUC_POINT, cal, nowhere, nowhere, points[:, :3])
    assert seen.visible.tolist() == [True, True, True, False, False, False, False]  # 94.99 degrees: beside the image
    assert np.isfinite(seen.value).all()


def test_a_field_that_is_not_given_is_the_largest_there_is():
    assert camera([300.0], limits=None).limits["angle"] == pytest.approx(np.pi)
    folding = camera([300.0, -30.0], limits=None)  # 300 t - 30 t^3 is largest at sqrt(300 / 90)
    assert folding.limits["angle"] == pytest.approx(np.sqrt(300 / 90))


def test_back_projection_up_to_the_fold_and_not_beyond(rng):
    cal = camera([300.0, -30.0], limits=None, intrinsics=[0, 0, 1, 0, 0], image=None)
    fold = cal.limits["angle"]
    for share in (0.5, 0.99, 1 - 1e-6):
        point = towards(share * fold, 0.4)
        assert cal.back_project_jac(cal.project(point), point[3:])[0] == pytest.approx(point, abs=1e-8)
    with pytest.raises(SingularPointError, match=r"no ray gives the pixel \[400.0, 0.0\].*mask such pixels"):
        cal.back_project_jac([400.0, 0.0], [0.5])
    convex = camera([300.0, 60.0], intrinsics=[0, 0, 1, 0, 0], image=None)
    point = towards(rng.uniform(0, 1.6, 30), rng.uniform(-3, 3, 30))
    assert convex.back_project_jac(convex.project(point), [0.3])[0] == pytest.approx(point, abs=1e-11)


def test_a_batch_is_a_loop_also_of_lenses(rng):
    points = towards(rng.uniform(0, 1.6, (4, 3)), rng.uniform(-3, 3, (4, 3)))
    pixels, J = camera().project_jac(points)
    rays, K = camera().back_project_jac(pixels, [0.3])
    assert rays == pytest.approx(points, abs=1e-11)
    for k in np.ndindex(4, 3):
        pixel, one = camera().project_jac(points[k])
        assert pixels[k] == pytest.approx(pixel)
        assert J.lens[k] == pytest.approx(one.lens)
        assert K.measurement[k] == pytest.approx(camera().back_project_jac(pixel, [0.3])[1].measurement)
    lenses = np.pad(LENS, (0, 2)) * (1 + 0.01 * rng.standard_normal((4, 1)))
    found = omni.back_project(omni.project(points[:, 0], INTRINSICS, lenses), [0.3], INTRINSICS, lenses)
    assert found == pytest.approx(points[:, 0], abs=1e-11)


def test_single_precision_keeps_its_digits(rng):
    point = towards(rng.uniform(0, 1.6, 50), rng.uniform(-3, 3, 50))
    exact = camera().project(point)
    single = omni.project(*(a.astype(np.float32) for a in (point, INTRINSICS, np.pad(LENS, (0, 2)))))
    assert single.dtype == np.float32
    assert np.abs(single - exact).max() < 0.02


# -- published polynomials ---------------------------------------------------------------------------------------------


def test_the_toolboxs_two_polynomials_disagree_by_four_pixels_on_the_axis():
    found = scaramuzza.polynomials(FIELD, backward=BACKWARD, forward=FORWARD)
    assert found.errors["forward"] == pytest.approx(4.064, abs=1e-3)
    assert found.errors["lens"] < 5e-3
    assert found.errors["backward"] < 5e-3
    assert found.backward == pytest.approx(BACKWARD)
    assert omni.radius(0.0, found.lens) == 0


@pytest.mark.parametrize("terms", [1, 3, 8])
def test_a_lens_comes_back_from_its_fitted_inverse(terms):
    lens = np.array([300.0, -12, 0.5, 1.5, -0.3, 0.05, 0.01, 0.002])[:terms]
    seen = np.linspace(0, FIELD, 200)
    forward = np.polynomial.polynomial.polyfit(np.pi / 2 - seen, omni.radius(seen, lens), 10)
    found = scaramuzza.polynomials(FIELD, forward=forward)
    assert found.errors["lens"] < 0.01
    assert found.errors["backward"] < 0.01
    assert omni.radius(seen, found.lens) == pytest.approx(omni.radius(seen, lens), abs=0.01)
    again = scaramuzza.polynomials(FIELD, backward=found.backward)
    assert omni.radius(seen, again.lens) == pytest.approx(omni.radius(seen, lens), abs=0.03)


def test_the_published_inverse_agrees_with_ours_up_to_the_residual(rng):
    point = towards(rng.uniform(0.01, 1.6, 50), rng.uniform(-3, 3, 50))
    pixel = camera().project(point)
    theirs = scaramuzza.back_project(pixel, [0.3], INTRINSICS, np.pad(BACKWARD, (0, 7)))
    assert theirs == pytest.approx(point, abs=0.005 / 340)


@pytest.mark.parametrize("function", ["omniCam", "projEucPntIntoOmniCamOnRob", "projAhmPntIntoOmniCamOnRob"])
def test_the_published_projection_agrees_with_the_toolbox(function):
    """Pixels, and Jacobians by everything; quaternion columns are compared on the tangent space."""
    for given, wanted in cases("omnicam", function):
        forward = np.pad(given.get("pol", given.get("d")), (0, 1))
        if function == "omniCam":
            point, by_frame = np.array([*given["p"], 1]), None
        else:
            kind = EUC_POINT if "Euc" in function else AHM_POINT
            from slamlib.geometry.pose import compose

            frame, outer = compose.jac(given["Rf"], given["Sf"])
            point, by_frame = kind.to_frame.jac(frame, given["l"])
        pixel, J = scaramuzza.project.jac(point, given["k"], forward)
        assert pixel == pytest.approx(wanted["u"], abs=1e-9)
        assert J.intrinsics == pytest.approx(wanted["U_k"], abs=1e-8)
        by_forward = wanted["U_pol"] if function == "omniCam" else wanted["U_d"]
        assert J.forward[:, :11] == pytest.approx(by_forward, rel=1e-9)
        if by_frame is None:
            assert J.point[:, :3] == pytest.approx(wanted["U_p"], abs=1e-8)
            continue
        assert J.point @ by_frame.landmark == pytest.approx(wanted["U_l"], abs=1e-8)
        for pose, mine, theirs in (("Rf", outer.outer, "U_rf"), ("Sf", outer.inner, "U_sf")):
            lift = np.block([
                [np.eye(3), np.zeros((3, 3))],
                [np.zeros((4, 3)), pi_matrix(given[pose][3:]) / 2],
            ])  # fmt: skip
            assert J.point @ by_frame.pose @ mine == pytest.approx(wanted[theirs] @ lift, abs=1e-7)


@pytest.mark.parametrize("function", ["invOmniCam", "retroProjAhmPntFromOmniCamOnRob"])
def test_the_published_inverse_agrees_with_the_toolbox_in_value(function):
    """Not in its Jacobians by pixel and polynomial, which are wrong there: seeds' errata, toolbox-bugs A3."""
    for given, wanted in cases("omnicam", function):
        backward = np.pad(given.get("pol", given.get("c")), (0, 7))
        point, J = scaramuzza.back_project.jac(given["u"], np.atleast_1d(given.get("n", 0.5)), given["k"], backward)
        if function == "invOmniCam":
            assert point[:3] == pytest.approx(wanted["p"], abs=1e-14)
            assert np.abs(J.measurement[:3] - wanted["P_u"]).max() > 1e-5
        else:
            from slamlib.geometry.pose import compose

            frame = compose(given["Rf"], given["Sf"])
            found = AHM_POINT.from_frame(frame, point)
            assert found == pytest.approx(wanted["ahm"], abs=1e-13)


def test_observe_and_initialize_are_each_others_inverse(rng):
    cal = camera()
    robot, extrinsics = (AHM_POINT.to_frame.arguments[0].manifold.random(rng) for _ in range(2))
    pixels = rng.uniform([100, 100], [1100, 700], (20, 2))
    landmarks, J = initialize(AHM_POINT, cal, robot, extrinsics, pixels, np.array([0.2]))
    seen = observe(AHM_POINT, cal, robot, extrinsics, landmarks)
    assert seen.visible.all()
    assert seen.value == pytest.approx(pixels, abs=1e-9)
    assert seen.jacobians.landmark @ J.measurement == pytest.approx(np.tile(np.eye(2), (20, 1, 1)), abs=1e-9)
    for name in ("robot", "extrinsics", "intrinsics", "lens"):
        total = getattr(seen.jacobians, name) + seen.jacobians.landmark @ getattr(J, name)
        assert total == pytest.approx(
            np.zeros_like(total), abs=1e-7 * max(1, np.abs(getattr(seen.jacobians, name)).max())
        )


# -- bad input ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"intrinsics": [668, 438]}, SlamlibError, r"intrinsics are \(xc, yc, c, d, e\)"),
        ({"intrinsics": [668, 438, 1, 1, 1]}, SlamlibError, "c - d e not zero"),
        ({"lens": [-300.0]}, SlamlibError, "first coefficient .* above zero"),
        ({"lens": np.ones(12)}, ShapeError, "lens has at most 11 numbers"),
        ({"lens": [300, np.nan]}, NonFiniteError, "lens holds nan"),
        ({"lens": [300.0, -50.0]}, SlamlibError, r"stops growing at 1\.4142 rad from the axis, before the field"),
        ({"limits": {"angle": 4.0}, "lens": [300.0]}, SlamlibError, "stops growing at 3.1416"),
        ({"limits": {"angle": 0.0}}, SlamlibError, "omniCam"),
        ({"limits": {"angel": 1.0}}, UnknownNameError, "did you mean 'angle'"),
        ({"limits": {"angle": np.nan}}, SlamlibError, "zero or more"),
    ],
)
def test_a_calibration_that_makes_no_sense_is_refused(changes, error, message):
    with pytest.raises(error, match=message):
        camera(**changes)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({}, "a published polynomial is needed"),
        ({"backward": -BACKWARD}, "change the sign of every coefficient"),
        ({"backward": [447, 0.1, -1e-3]}, "c1 = 0"),
        ({"backward": [447.0, 0, 2e-3, 0, -1e-10]}, "the angle does not grow"),
        ({"backward": [447.0]}, "no radius is seen"),
        ({"forward": [100.0, 100.0]}, "the radius does not grow"),
        ({"forward": [100.0, np.inf]}, "forward holds inf"),
        ({"backward": "wide"}, "real numbers"),
    ],
)
def test_polynomials_of_no_lens_are_refused(given, message):
    with pytest.raises(SlamlibError, match=message):
        scaramuzza.polynomials(FIELD, **given)


def test_a_field_of_no_lens_is_refused():
    for angle in (0, -1, np.pi, np.nan):
        with pytest.raises(SlamlibError, match="between 0 and pi"):
            scaramuzza.polynomials(angle, backward=BACKWARD)


def test_pixels_that_are_no_numbers_are_refused():
    with pytest.raises(NonFiniteError, match="'measurement' holds nan"):
        camera().back_project_jac([np.nan, 1.0], [0.5])
    with pytest.raises(ShapeError, match="should have shape"):
        camera().back_project_jac([1.0, 2.0, 3.0], [0.5])


def test_it_is_found_by_the_toolboxs_name():
    assert sensor("omniCam") is omni.OMNI
