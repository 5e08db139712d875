"""The pin-hole camera: models, inverse, fold, visibility; against the toolbox's numbers, and against OpenCV."""

from pathlib import Path

import numpy as np
import pytest

import slamlib
from slamlib.codegen import check_model
from slamlib.errors import NonFiniteError, ShapeError, SingularPointError, SlamlibError, UnknownNameError
from slamlib.sensors import Calibration, sensor
from slamlib.sensors import pinhole as ph
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

K = np.array([320.0, 240.0, 320.0, 300.0])
BARREL, PINCUSHION, MIXED, FOLDING = [-0.3, 0.1], [0.2, 0.05, 0.01], [-0.2, 0.15, -0.03, 0.01], [-0.3]
KINDS = {"none": [], "barrel": BARREL, "pincushion": PINCUSHION, "mixed": MIXED, "folding": FOLDING}


def padded(distortion):
    return np.pad(np.array(distortion, dtype=float), (0, 8 - len(distortion)))


def camera(distortion=(), **more):
    return Calibration(sensor("pinHole"), np.eye(2), intrinsics=K, distortion=distortion, **more)


def point(x, y, z=1.0, w=0.5):
    return np.array([x, y, z, w])


@pytest.fixture
def rng():
    return np.random.default_rng(8)


@pytest.fixture(params=KINDS, ids=str)
def distortion(request):
    return KINDS[request.param]


# -- the direct model --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", [ph.distort, ph.pixel, ph.project, ph.project_line, ph.ray], ids=lambda m: m.name)
def test_values_and_jacobians_are_those_of_the_definitions(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", [ph.distort, ph.pixel, ph.project, ph.project_line, ph.ray], ids=lambda m: m.name)
def test_central_differences_agree(model, rng):
    item = [0.5 * rng.standard_normal(a.shape) + 0.2 for a in model.arguments]
    value, jacobians = model.jac(*item)
    assert model(*item) == pytest.approx(value, rel=1e-13)
    for index in range(len(item)):
        numerical = differences(model, item, index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))


@pytest.mark.parametrize(("x", "y"), [(0, 0), (1e-9, 0), (0, -1), (1, 0.8), (-1.0, 0.8), (3, 4), (1e3, 1)])
@pytest.mark.parametrize(("z", "w"), [(1, 0), (-1, 0.1), (1e-3, 1), (7, 1)])
def test_jacobians_at_the_centre_the_border_behind_and_at_infinity(x, y, z, w):
    check_model(ph.project, sample=lambda _: [point(x, y, z, w), K, padded(MIXED)], points=1, silent=True)


def test_only_the_direction_counts(rng):
    p = rng.standard_normal(4)
    for scale, w in ((1, 0), (3.7, 1), (-2, 5)):
        scaled = np.append(scale * p[:3], w)
        assert ph.project(scaled, K, padded(BARREL)) == pytest.approx(ph.project(p, K, padded(BARREL)), rel=1e-13)
    _, J = ph.project.jac(p, K, padded(BARREL))
    assert np.array_equal(J.point[:, 3], [0, 0])
    assert J.point[:, :3] @ p[:3] == pytest.approx([0, 0], abs=1e-9)


def test_the_optical_axis_meets_the_principal_point(distortion):
    assert np.array_equal(ph.project(point(0, 0, 5), K, padded(distortion)), K[:2])


def test_a_point_in_the_plane_of_the_lens_has_no_pixel():
    with pytest.raises(SingularPointError):
        ph.project(point(1, 0, 0), K, padded([]))


# -- the inverse -------------------------------------------------------------------------------------------------------


def inside(rng, distortion, count):
    """Ideal points below the fold, some of them hard: the centre, and near the fold or far out."""
    limit = min(float(ph.fold_radius(np.array(distortion))), 3.0)
    angles = rng.uniform(0, 2 * np.pi, count)
    radii = limit * np.concatenate([[0, 1e-12, 1e-5, 0.999], rng.uniform(0, 0.98, count - 4)])
    return radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def test_the_inverse_undoes_the_direct_model_to_the_last_digits(rng, distortion):
    ideal = inside(rng, distortion, 200)
    d = padded(distortion)
    pixels = ph.pixel(ideal, K, d)
    found = ph.ideal_point(pixels, K, d)
    assert ph.pixel(found, K, d) == pytest.approx(pixels, abs=1e-10)
    regular = np.linalg.norm(ideal, axis=-1) < 0.98 * min(float(ph.fold_radius(d)), 1e9)
    assert found[regular] == pytest.approx(ideal[regular], abs=1e-12)
    rays = ph.back_project(pixels, np.full((200, 1), 0.25), K, d)
    assert np.linalg.norm(rays[:, :3], axis=-1) == pytest.approx(1, abs=1e-14)
    assert np.array_equal(rays[:, 3], np.full(200, 0.25))
    assert ph.project(rays, K, d) == pytest.approx(pixels, abs=1e-9)


def test_the_inverse_has_the_jacobians_of_central_differences(rng, distortion):
    d, w = padded(distortion), np.array([0.3])
    for ideal in [np.zeros(2), *0.9 * inside(rng, distortion, 8)[4:]]:
        arguments = [ph.pixel(ideal, K, d), w, K, d]
        _, J = ph.back_project.jac(*arguments)
        for index, steps in enumerate((1e-3, 1e-3, 1e-3, 1e-7)):
            columns = []
            for k in range(arguments[index].size):
                stops = []
                for sign in (1, -1):
                    moved = [a.copy() for a in arguments]
                    moved[index][k] += sign * steps
                    stops.append(ph.back_project(*moved))
                columns.append((stops[0] - stops[1]) / (2 * steps))
            wanted = np.stack(columns, axis=-1)
            assert J[index] == pytest.approx(wanted, abs=5e-7 * max(1, np.abs(wanted).max()))


def test_the_jacobians_of_the_inverse_are_inverse_to_those_of_the_direct_model(rng, distortion):
    d = padded(distortion)
    pixels = ph.pixel(inside(rng, distortion, 20)[[0, 1, 2, *range(4, 20)]], K, d)
    rays, J = ph.back_project.jac(pixels, np.zeros((19, 1)), K, d)
    _, H = ph.project.jac(rays, K, d)
    assert H.point @ J.measurement == pytest.approx(np.broadcast_to(np.eye(2), (19, 2, 2)), abs=1e-9)
    assert H.point @ J.intrinsics == pytest.approx(-H.intrinsics, abs=1e-8)
    assert H.point @ J.distortion == pytest.approx(-H.distortion, rel=1e-8, abs=1e-6)
    assert np.array_equal(J.unmeasured, np.broadcast_to([[0], [0], [0], [1.0]], (19, 4, 1)))


def test_a_batch_is_a_loop(rng):
    pixels = K[:2] + rng.uniform(-150, 150, (5, 2))
    w, k = rng.uniform(0, 1, (5, 1)), K + rng.uniform(-5, 5, (5, 4))
    d = np.array([padded(v) for v in KINDS.values()])
    value, J = ph.back_project.jac(pixels, w, k, d)
    assert np.array_equal(ph.back_project(pixels, w, k, d), value)
    for i in range(5):
        one, single = ph.back_project.jac(pixels[i], w[i], k[i], d[i])
        assert value[i] == pytest.approx(one, abs=1e-14)
        for many, alone in zip(J, single, strict=True):
            assert many[i] == pytest.approx(alone, abs=1e-12)
    grid = ph.back_project(pixels.reshape(5, 1, 2), w, K, d[1])
    assert grid.shape == (5, 5, 4)


def test_single_precision_is_as_good_as_its_digits(rng):
    p = np.concatenate([rng.uniform(-1, 1, (50, 2)), np.ones((50, 1)), np.zeros((50, 1))], axis=-1)
    low = ph.project(p.astype(np.float32), K.astype(np.float32), padded(BARREL).astype(np.float32))
    assert low.dtype == np.float32
    assert low == pytest.approx(ph.project(p, K, padded(BARREL)), abs=2e-4)


# -- the fold ----------------------------------------------------------------------------------------------------------


def test_the_fold_of_one_coefficient_is_known():
    assert float(ph.fold_radius([-0.3])) == pytest.approx(1 / np.sqrt(0.9), rel=1e-15)
    assert np.degrees(np.arctan(float(ph.fold_radius([-0.3])))) == pytest.approx(46.5, abs=0.05)
    for never in ([], [0.0], [0.2], [-0.3, 0.1], [0.0, 0.0, 0.0]):
        assert float(ph.fold_radius(never)) == np.inf


def test_the_fold_is_where_a_fine_search_finds_it(rng):
    radii = np.linspace(0, 3, 30001)
    seen = 0
    for _ in range(200):
        n = rng.integers(1, 9)
        d = rng.standard_normal(n) * 0.3 / 2.0 ** np.arange(n)
        rising = np.diff(ph.distort_radius(radii, d)) > 0
        fold = float(ph.fold_radius(d))
        if rising.all():
            assert fold > 2.99
        else:
            seen += 1
            assert fold == pytest.approx(radii[np.argmin(rising)], abs=2e-4)
    assert 50 < seen < 200


def test_beyond_the_fold_there_is_no_ray_and_the_outer_branch_is_not_taken():
    d = np.array([-0.4, 0.04])  # falls after the fold, then rises again without end
    fold = float(ph.fold_radius(d))
    top = float(ph.distort_radius(fold, d))
    assert float(ph.distort_radius(4.0, d)) > top
    found = ph.undistort_radius(np.array([0, 0.5 * top, 0.999999 * top, 1.000001 * top, 2.0]), d)
    assert np.isnan(found).tolist() == [False, False, False, True, True]
    assert (found[:3] <= fold).all()
    pixels = K[:2] + np.array([[0.5 * top, 0], [1.1 * top, 0]]) * K[2:]
    with pytest.raises(SingularPointError, match=r"no ray gives the pixel \[.*\]: it lies beyond the fold"):
        ph.back_project(pixels, np.zeros((2, 1)), K, padded(d))


def test_radii_far_out_and_hard_polynomials_are_inverted(rng):
    for _ in range(200):
        n = rng.integers(1, 9)
        d = rng.standard_normal(n) / 3.0 ** np.arange(n)
        limit = min(float(ph.fold_radius(d)), 5.0)
        r = limit * np.array([0, 1e-8, 0.1, 0.5, 0.9, 0.99])
        goal = ph.distort_radius(r, d)
        found = ph.undistort_radius(goal, d)
        assert ph.distort_radius(found, d) == pytest.approx(goal, rel=1e-14, abs=1e-14)
    d = np.array([0.692, -1.805, 0.25, 0.971, 0.216, -0.654, 0.076, 0.059])  # Newton's method jumps to and fro for ever
    assert ph.distort_radius(ph.undistort_radius(0.843, d), d) == pytest.approx(0.843, rel=1e-14)


def test_what_is_behind_or_beyond_the_fold_is_invisible():
    wide = {"limits": {"radius": 2.0}}
    points = np.array(
        [point(0, 0), point(0, 0, -1), point(0, 0, 0), point(1, 0), point(1.2, 0), point(3, 0), point(1, 0, 1, 0)]
    )
    assert camera().visible(points).tolist() == [True, False, False, True, True, True, True]
    assert camera(FOLDING).visible(points).tolist() == [True, False, False, True, False, False, True]
    assert camera(**wide).visible(points).tolist() == [True, False, False, True, True, False, True]
    phantom = ph.project(point(1.75, 0), K, padded(FOLDING))  # 60 degrees off the axis, and yet near the centre
    assert np.abs(phantom - K[:2]).max() < 60


def test_a_mask_has_the_shape_of_the_batch(rng):
    assert camera(FOLDING).visible(rng.standard_normal((3, 5, 4))).shape == (3, 5)
    assert camera(FOLDING).visible(point(0, 0)).shape == ()


# -- lines -------------------------------------------------------------------------------------------------------------


def test_the_image_of_a_line_holds_the_pixels_of_its_points(rng):
    matrix = np.array([[K[2], 0, K[0]], [0, K[3], K[1]], [0, 0, 1]])
    for _ in range(20):
        p, v = rng.standard_normal(3) + np.array([0, 0, 5]), rng.standard_normal(3)
        line = ph.project_line(np.concatenate([np.cross(p, v), v]), K)
        assert line == pytest.approx(np.linalg.det(matrix) * np.linalg.inv(matrix).T @ np.cross(p, v), rel=1e-12)
        for t in (-1, 0, 0.7):
            pixel = ph.project(np.append(p + t * v, 1), K, padded([]))
            assert line @ np.append(pixel, 1) == pytest.approx(0, abs=1e-7 * np.abs(line).max())


def test_a_line_through_the_optical_centre_has_no_image_but_a_derivative():
    line, J = ph.project_line.jac(np.array([0, 0, 0, 0, 0, 1.0]), K)
    assert np.array_equal(line, np.zeros(3))
    assert np.linalg.matrix_rank(J.line) == 3


# -- bad input ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"intrinsics": [320, 240, 0, 300]}, r"intrinsics are \(u0, v0, au, av\) with au, av > 0, got \[320.0"),
        ({"intrinsics": [320, 240, 300, -300]}, "au, av > 0"),
        ({"intrinsics": [320, 240, 300]}, "au, av > 0"),
        ({"intrinsics": [320, 240, 300, 300, 0]}, "intrinsics has at most 4 numbers"),
        ({"distortion": np.zeros(9)}, "distortion has at most 8 numbers"),
        ({"distortion": [np.nan]}, "distortion"),
        ({"limits": {"angle": 1.0}}, "unknown limit of pinHole 'angle'"),
        ({"distortion": [-0.3]}, "folds back at 46.5 degrees off the axis, inside the image"),
        ({"noise": np.eye(3)}, "noise"),
    ],
)
def test_a_calibration_that_makes_no_sense_is_refused(change, message):
    good = {"noise": np.eye(2), "image": (640, 480), "intrinsics": K, "distortion": BARREL}
    Calibration(sensor("pinHole"), **good)
    with pytest.raises(SlamlibError, match=message):
        Calibration(sensor("pinHole"), **{**good, **change})


def test_a_fold_inside_the_image_may_be_fenced_off():
    fenced = camera(FOLDING, image=(640, 480), limits={"radius": 0.9})
    assert fenced.visible(np.array([point(0.8, 0), point(1.0, 0)])).tolist() == [True, False]


def test_every_pixel_of_an_image_that_is_accepted_has_a_visible_ray(rng):
    u, v = np.meshgrid(np.linspace(0, 640, 17), np.linspace(0, 480, 13))
    pixels = np.stack([u.ravel(), v.ravel()], axis=-1)
    accepted = 0
    for _ in range(100):
        d = rng.standard_normal(rng.integers(1, 5)) * 0.3
        try:
            there = camera(d, image=(640, 480))
        except SlamlibError:
            continue
        accepted += 1
        points, _ = there.back_project_jac(pixels, np.zeros((len(pixels), 1)))
        assert there.visible(points).all()
        assert there.project(points) == pytest.approx(pixels, abs=1e-8)
    assert 20 < accepted < 100


@pytest.mark.parametrize(
    ("pixel", "error", "message"),
    [
        ([1.0, 2, 3], ShapeError, r"back_project: argument 'measurement' should have shape \(..., 2\)"),
        ([np.inf, 0], NonFiniteError, "holds inf at index"),
        ([np.nan, 0], NonFiniteError, "holds nan at index"),
    ],
)
def test_a_pixel_that_is_none_is_refused(pixel, error, message):
    with pytest.raises(error, match=message):
        ph.back_project(np.array(pixel), np.array([0.1]), K, padded([]))


def test_a_calibration_hands_on_the_columns_that_it_was_given():
    value, J = camera(BARREL).project_jac(point(0.5, 0.2))
    assert J.distortion.shape == (2, 2)
    assert value == pytest.approx(ph.project(point(0.5, 0.2), K, padded(BARREL)))
    _, J = camera([]).back_project_jac(value, np.array([0.1]))
    assert J.distortion.shape == (4, 0)
    assert issubclass(UnknownNameError, SlamlibError)


# -- the toolbox -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("function", ["pinHole", "pinHole_nodist"])
def test_the_toolboxs_projection(function):
    for given, wanted in cases("camera", function):
        value, J = camera_of(given).project_jac(np.append(given["p"], 1.0))
        assert value == pytest.approx(wanted["u"], abs=1e-10)
        assert J.point[:, :3] == pytest.approx(wanted["U_p"], abs=1e-9)
        assert J.intrinsics == pytest.approx(wanted["U_k"], abs=1e-12)
        assert J.distortion == pytest.approx(np.reshape(wanted["U_d"], J.distortion.shape), abs=1e-9)


def test_the_toolboxs_homogeneous_projection():
    for given, wanted in cases("camera", "pinHoleHmg"):
        value, J = camera_of(given).project_jac(given["p"])
        assert value == pytest.approx(wanted["u"], abs=1e-10)
        assert J.point == pytest.approx(wanted["U_p"], abs=1e-9)


def test_the_toolboxs_distortion():
    for given, wanted in cases("camera", "distort"):
        n = len(given["d"])
        value, J = ph.distort.jac(given["up"], padded(given["d"]))
        assert value == pytest.approx(wanted["ud"], abs=1e-14)
        assert J.ideal == pytest.approx(wanted["UD_up"], abs=1e-13)
        assert J.distortion[:, :n] == pytest.approx(wanted["UD_d"], abs=1e-14)


def test_the_toolboxs_back_projection_without_distortion():
    for given, wanted in cases("camera", "invPinHole_nodist"):
        ideal, J = ph.ideal_point.jac(given["u"], given["k"], padded([]))
        s = given["s"]
        assert s * np.append(ideal, 1) == pytest.approx(wanted["p"], abs=1e-12)
        assert s * J.value == pytest.approx(wanted["P_u"][:2], abs=1e-14)
        assert s * J.intrinsics == pytest.approx(wanted["P_k"][:2], abs=1e-12)


def test_its_correction_polynomial_is_our_distortion_with_other_coefficients():
    for given, wanted in cases("camera", "undistort"):
        value, J = ph.distort.jac(given["ud"], padded(given["c"]))
        assert value == pytest.approx(wanted["up"], abs=1e-14)
        assert J.ideal == pytest.approx(wanted["UP_ud"], abs=1e-13)


def test_visibility_is_the_toolboxs_where_nothing_folds():
    for given, wanted in cases("camera", "isVisible"):
        pixel, depth = np.reshape(given["pix"], 2), float(np.ravel(given["depth"])[0])
        there = camera(image=tuple(given["imSize"]))
        ahead = there.visible(point(0, 0, depth))
        assert bool(there.inside(pixel) & ahead) == bool(wanted["vis"])


def camera_of(given):
    return Calibration(sensor("pinHole"), np.eye(2), intrinsics=given["k"], distortion=np.ravel(given["d"]))


# -- OpenCV ------------------------------------------------------------------------------------------------------------


def opencv():
    return pytest.importorskip("cv2", reason="OpenCV is not installed: pip install opencv-python-headless")


def opencvs(distortion):
    """(k1, k2, p1, p2, k3): the tangential two stand between the second and the third of ours."""
    d = padded(distortion)
    return np.array([d[0], d[1], 0, 0, d[2]])


def matrix_of(k):
    return np.array([[k[2], 0, k[0]], [0, k[3], k[1]], [0, 0, 1.0]])


@pytest.mark.parametrize("coefficients", [[], BARREL, PINCUSHION, FOLDING])
def test_opencv_projects_to_the_same_pixels_with_the_same_jacobians(rng, coefficients):
    cv2 = opencv()
    points = np.concatenate([rng.uniform(-1, 1, (50, 2)), rng.uniform(1, 5, (50, 1))], axis=-1)
    zero = np.zeros(3)
    pixels, jacobian = cv2.projectPoints(points, zero, zero, matrix_of(K), opencvs(coefficients))
    value, J = ph.project.jac(np.concatenate([points, np.ones((50, 1))], axis=-1), K, padded(coefficients))
    assert value == pytest.approx(pixels[:, 0], abs=1e-9)
    theirs = jacobian.reshape(50, 2, -1)  # rotation, translation, (fu, fv), (cu, cv), (k1, k2, p1, p2, k3)
    assert J.point[..., :3] == pytest.approx(theirs[..., 3:6], abs=1e-8)
    assert J.intrinsics == pytest.approx(theirs[..., [8, 9, 6, 7]], abs=1e-9)
    assert J.distortion[..., :3] == pytest.approx(theirs[..., [10, 11, 14]], abs=1e-8)


@pytest.mark.parametrize("coefficients", [[], BARREL, PINCUSHION])
def test_opencv_takes_pixels_back_to_the_same_rays_if_it_may_iterate(coefficients):
    cv2 = opencv()
    u, v = np.meshgrid(np.linspace(60, 580, 9), np.linspace(60, 420, 7))
    pixels = np.stack([u.ravel(), v.ravel()], axis=-1)
    rays = ph.back_project(pixels, np.zeros((63, 1)), K, padded(coefficients))
    ours = rays[:, :2] / rays[:, 2:3]
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 1000, 1e-13)
    given = (pixels[:, None], matrix_of(K), opencvs(coefficients))
    patient = getattr(cv2, "undistortPointsIter", cv2.undistortPoints)  # one name since OpenCV 5
    theirs = patient(*given, R=None, P=None, criteria=criteria)[:, 0]
    assert ours == pytest.approx(theirs, abs=1e-9)
    quick = cv2.undistortPoints(*given)[:, 0]  # five steps of a fixed-point iteration
    error = np.abs(quick - ours).max() * K[2]
    assert error < (1e-9 if not coefficients else 3.0)
    if coefficients == BARREL:
        assert error > 0.01


def test_opencvs_calibration_of_the_books_corners_is_where_our_gradient_vanishes():
    """OpenCV finds the numbers of chapter pinhole too, and by our Jacobians they are the least squares."""
    cv2 = opencv()
    file = Path(slamlib.__file__).parents[1] / "book" / "chapters" / "data" / "chessboard_corners.csv"
    corners = np.loadtxt(file, delimiter=",", skiprows=2)
    views = [corners[corners[:, 0] == n, 1:].astype(np.float32) for n in np.unique(corners[:, 0])]
    row, column = np.divmod(np.arange(54), 9)
    board = (0.025 * np.stack([column, row, 0 * row], axis=-1)).astype(np.float32)
    flags = cv2.CALIB_ZERO_TANGENT_DIST | cv2.CALIB_FIX_K3
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 200, 1e-14)
    rms, matrix, dist, turns, shifts = cv2.calibrateCamera(
        [board] * len(views), views, (640, 480), None, None, flags=flags, criteria=criteria
    )
    assert rms == pytest.approx(0.204, abs=5e-4)
    k = matrix[[0, 1, 0, 1], [2, 2, 0, 1]]
    assert k == pytest.approx([342.4, 233.2, 533.1, 533.5], abs=0.06)
    d = padded(dist.ravel()[:2])
    assert d[:2] == pytest.approx([-0.291, 0.109], abs=6e-4)
    gradient, scale = np.zeros(6), np.zeros(6)
    for seen, turn, shift in zip(views, turns, shifts, strict=True):
        points = board @ cv2.Rodrigues(turn)[0].T + shift.ravel()
        value, J = ph.project.jac(np.concatenate([points, np.ones((54, 1))], axis=-1), k, d)
        own = np.concatenate([J.intrinsics, J.distortion[..., :2]], axis=-1)
        gradient += np.einsum("nij,ni->j", own, seen - value)
        scale += np.abs(np.einsum("nij,ni->nj", own, seen - value)).sum(axis=0)
    assert gradient / scale == pytest.approx(np.zeros(6), abs=1e-5)
