"""The lens with tangential and rational distortion: models, inverse, fold, visibility; against OpenCV."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.codegen import check_model
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.sensors import Calibration, brown, sensor
from slamlib.sensors import pinhole as ph
from slamlib.tests.differences import differences

K = np.array([320.0, 240.0, 420.0, 400.0])
FREIBURG = [0.2624, -0.9531, -0.0054, 0.0026, 1.1633]  # TUM's first Kinect: Sturm and others (2012)
LEANING, FOLDING = [-0.2, 0.04, 0.02, -0.03], [-0.3, 0.0, 0.004, -0.003]
RATIONAL = [8.3, 5.0, 3e-4, -2e-4, 0.3, 8.6, 7.0, 1.2]
LENSES = {"leaning": LEANING, "folding": FOLDING, "freiburg": FREIBURG, "rational": RATIONAL}
MODELS = [brown.distort, brown.pixel, brown.project]


def padded(distortion):
    return np.pad(np.array(distortion, dtype=float), (0, 8 - len(distortion)))


def camera(distortion=LEANING, **more):
    return Calibration(sensor("brownConrady"), np.eye(2), **{"intrinsics": K, "distortion": distortion, **more})


def random_lens(rng, strength=0.2):
    lens = strength * rng.standard_normal(rng.choice([4, 5, 8]))
    return np.concatenate([lens[:2], 0.1 * lens[2:4], lens[4:]])


def inside(rng, distortion, count):
    """Ideal points below the fold, the centre and some near the fold among them."""
    limit = min(float(brown.fold_radius(distortion)), 1.5)
    angles = rng.uniform(0, 2 * np.pi, count)
    radii = limit * np.concatenate([[0, 1e-12, 1e-5, 0.999], rng.uniform(0, 0.98, count - 4)])
    return radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


@pytest.fixture
def rng():
    return np.random.default_rng(65)


@pytest.fixture(params=LENSES, ids=str)
def distortion(request):
    return np.array(LENSES[request.param])


# -- the direct model --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_values_and_jacobians_are_those_of_the_definitions(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_central_differences_agree(model, rng):
    item = [0.3 * rng.standard_normal(a.shape) + 0.2 for a in model.arguments]
    value, jacobians = model.jac(*item)
    assert model(*item) == pytest.approx(value, rel=1e-13)
    for index in range(len(item)):
        numerical = differences(model, item, index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))


@pytest.mark.parametrize(("x", "y"), [(0, 0), (1e-9, 0), (0, -1), (1, 0.8), (-1.0, 0.8), (3, 4)])
@pytest.mark.parametrize(("z", "w"), [(1, 0), (-1, 0.1), (7, 1)])
def test_jacobians_at_the_centre_the_border_behind_and_at_infinity(x, y, z, w):
    item = [np.array([x, y, z, w]), K, np.array(RATIONAL)]
    check_model(brown.project, sample=lambda _: item, points=1, silent=True)


def test_radial_coefficients_alone_are_the_pinholes(rng):
    ideal = rng.uniform(-1, 1, (50, 2))
    bent = brown.distort(ideal, [-0.2, 0.15, 0, 0, -0.03])
    assert bent == pytest.approx(ph.distort(ideal, [-0.2, 0.15, -0.03]), abs=1e-15)


def test_tangential_distortion_alone_is_the_gradient_of_its_potential(rng):
    """eq. (ph-potential): by differences of r^2 (p2 x + p1 y), which knows nothing of the model."""
    p1, p2, step = 0.02, -0.03, 1e-5
    for x, y in rng.uniform(-1, 1, (20, 2)):

        def potential(x, y):
            return (x * x + y * y) * (p2 * x + p1 * y)

        slopes = [
            (potential(x + step, y) - potential(x - step, y)) / (2 * step),
            (potential(x, y + step) - potential(x, y - step)) / (2 * step),
        ]
        assert brown.distort([x, y], [0, 0, p1, p2]) - [x, y] == pytest.approx(slopes, abs=1e-10)


@pytest.mark.parametrize("size", [4, 5, 8])
def test_fewer_coefficients_are_zeros_without_columns(rng, size):
    points = np.concatenate([rng.uniform(-1, 1, (20, 2)), np.ones((20, 2))], axis=-1)
    lens = np.array(RATIONAL[:size]) / 10
    value, J = brown.project.jac(points, K, lens)
    whole, full = brown.project.jac(points, K, padded(lens))
    assert value == pytest.approx(whole, abs=1e-12)
    assert J.point == pytest.approx(full.point, abs=1e-11)
    assert J.distortion == pytest.approx(full.distortion[..., :size], abs=1e-11)


# -- the inverse -------------------------------------------------------------------------------------------------------


def test_the_inverse_undoes_the_direct_model_to_the_last_digits(rng, distortion):
    ideal = inside(rng, distortion, 200)
    pixels = brown.pixel(ideal, K, distortion)
    found = brown.ideal_point(pixels, K, distortion)
    assert brown.pixel(found, K, distortion) == pytest.approx(pixels, abs=1e-10)
    regular = np.linalg.norm(ideal, axis=-1) < 0.98 * float(brown.fold_radius(distortion))
    assert found[regular] == pytest.approx(ideal[regular], abs=1e-12)
    rays = brown.back_project(pixels, np.full((200, 1), 0.25), K, distortion)
    assert np.linalg.norm(rays[:, :3], axis=-1) == pytest.approx(1, abs=1e-14)
    assert brown.project(rays, K, distortion) == pytest.approx(pixels, abs=1e-9)


def test_the_jacobians_of_the_inverse_are_inverse_to_those_of_the_direct_model(rng, distortion):
    pixels = brown.pixel(inside(rng, distortion, 20)[[0, 1, 2, *range(4, 20)]], K, distortion)
    rays, J = brown.back_project.jac(pixels, np.zeros((19, 1)), K, distortion)
    _, H = brown.project.jac(rays, K, distortion)
    assert H.point @ J.measurement == pytest.approx(np.broadcast_to(np.eye(2), (19, 2, 2)), abs=1e-9)
    assert H.point @ J.intrinsics == pytest.approx(-H.intrinsics, abs=1e-8)
    assert H.point @ J.distortion == pytest.approx(-H.distortion, rel=1e-8, abs=1e-6)


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_every_point_below_the_fold_of_any_lens_is_found(seed):
    rng = np.random.default_rng(seed)
    lens = random_lens(rng)
    ideal = inside(rng, lens, 30)
    ideal = ideal[np.linalg.norm(ideal, axis=-1) < 0.98 * float(brown.fold_radius(lens))]
    assert brown.undistort(brown.distort(ideal, lens), lens) == pytest.approx(ideal, abs=1e-9)


def test_each_item_of_a_batch_has_its_own_lens(rng):
    lenses = np.array([padded(v) for v in LENSES.values()])
    pixels = K[:2] + rng.uniform(-100, 100, (len(lenses), 2))
    value, J = brown.back_project.jac(pixels, np.zeros((len(lenses), 1)), K, lenses)
    for i, lens in enumerate(lenses):
        one, single = brown.back_project.jac(pixels[i], [0.0], K, lens)
        assert value[i] == pytest.approx(one, abs=1e-14)
        assert J.distortion[i] == pytest.approx(single.distortion, abs=1e-12)


def test_beyond_the_fold_there_is_no_ray():
    top = brown.distort([0.999 * float(brown.fold_radius(FOLDING)), 0], FOLDING)[0]
    found = brown.undistort([[0, 0], [0.99 * top, 0], [1.05 * top, 0], [9.0, 9.0]], FOLDING)
    assert np.isnan(found[:, 0]).tolist() == [False, False, True, True]
    with pytest.raises(SingularPointError, match=r"no ray gives the pixel \[.*\]: it lies beyond the fold"):
        brown.back_project(K[:2] + np.array([[0, 0], [1.1 * top, 0]]) * K[2:], np.zeros((2, 1)), K, FOLDING)


# -- the fold ----------------------------------------------------------------------------------------------------------


def test_the_fold_of_one_coefficient_is_known():
    assert float(brown.fold_radius([-0.3, 0, 0, 0])) == pytest.approx(1 / np.sqrt(0.9), rel=1e-14)
    assert float(brown.fold_radius([0, 0, 0.003, 0.004])) == pytest.approx(1 / 0.03, rel=1e-14)
    assert float(brown.fold_radius([0, 0, 0, 0, 0, -0.25, 0, 0])) == pytest.approx(2, rel=1e-14)  # 1 + k4 r^2 = 0
    assert np.isinf(brown.fold_radius([FREIBURG, [0, 0, 0, 0, 0.0]])).all()


def test_radial_coefficients_alone_fold_where_the_pinholes_do(rng):
    for _ in range(50):
        k1, k2, k3 = rng.standard_normal(3) * [0.3, 0.1, 0.05]
        wanted = float(ph.fold_radius([k1, k2, k3]))
        assert float(brown.fold_radius([k1, k2, 0, 0, k3])) == pytest.approx(wanted, rel=1e-9)


def test_below_the_fold_the_jacobian_is_positive_definite_and_at_it_of_a_barrel_singular(rng):
    angles = np.linspace(0, 2 * np.pi, 721)
    around = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    barrels = 0
    for _ in range(200):
        lens = random_lens(rng)
        fold = float(brown.fold_radius(lens))
        radii = min(fold, 3.0) * np.linspace(0.001, 0.999, 60)
        _, jacobians = brown.distort.jac(radii[:, None, None] * around, lens)
        assert np.linalg.eigvalsh(jacobians.ideal).min() > 0
        plain = np.array([*lens[:2], 0, 0, *lens[4:]])  # without the tangential part: the eigenvalues of eq. (ph-fold)
        if fold < 3:
            J = brown.distort.jac([fold, 0], plain)[1].ideal
            if J[0, 0] <= J[1, 1]:
                barrels += 1
                _, at_fold = brown.distort.jac(fold * around, lens)
                assert np.linalg.eigvalsh(at_fold.ideal).min() == pytest.approx(0, abs=1e-4)
    assert barrels > 50


def test_what_is_behind_or_beyond_the_fold_is_invisible():
    points = np.array([[0, 0, 1, 0], [0, 0, -1, 0], [0, 0, 0, 1], [0.9, 0, 1, 1], [1.2, 0, 1, 1], [2.4, 0, 2, 1.0]])
    assert camera(FOLDING).visible(points).tolist() == [True, False, False, True, False, False]
    assert camera(FOLDING, limits={"radius": 0.8}).visible(points).tolist() == [True, *[False] * 5]
    assert camera(FOLDING, limits={"radius": 9}).visible(points).tolist() == [True, False, False, True, False, False]
    assert camera(FREIBURG).visible(points).tolist() == [True, False, False, True, True, True]
    assert camera(FOLDING).visible(points[0]).shape == ()


# -- bad input ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"intrinsics": [320, 240, 0, 300]}, r"intrinsics are \(u0, v0, au, av\) with au, av > 0, got \[320.0"),
        ({"intrinsics": [320, 240, 300]}, "au, av > 0"),
        ({"distortion": []}, "4, 5 or 8 numbers, got 0"),
        (
            {"distortion": [0.1, 0.2, 0.3]},
            "4, 5 or 8 numbers, got 3; a lens with radial coefficients alone is a pinHole",
        ),
        ({"distortion": np.zeros(6)}, "4, 5 or 8 numbers, got 6"),
        ({"distortion": np.zeros(12)}, "distortion has at most 8 numbers"),
        ({"limits": {"angle": 1.0}}, "unknown limit of brownConrady 'angle'"),
        ({"distortion": [-0.6, 0, 0.01, 0]}, r"folds back at 36.\d degrees off the axis, .* pixel \[0.0, 0.0\]"),
        ({"noise": np.eye(3)}, "noise"),
    ],
)
def test_a_calibration_that_makes_no_sense_is_refused(change, message):
    good = {"noise": np.eye(2), "image": (640, 480), "intrinsics": K, "distortion": LEANING}
    Calibration(sensor("brownConrady"), **good)
    with pytest.raises(SlamlibError, match=message):
        Calibration(sensor("brownConrady"), **{**good, **change})


def test_a_fold_inside_the_image_may_be_fenced_off():
    assert camera([-0.6, 0, 0.01, 0], image=(640, 480), limits={"radius": 0.5}).limits == {"radius": 0.5}


def test_every_pixel_of_an_image_that_is_accepted_has_a_visible_ray(rng):
    u, v = np.meshgrid(np.linspace(0, 640, 33), np.linspace(0, 480, 25))
    pixels = np.stack([u.ravel(), v.ravel()], axis=-1)
    accepted = 0
    for _ in range(100):
        try:
            there = camera(random_lens(rng), image=(640, 480))
        except SlamlibError:
            continue
        accepted += 1
        points, _ = there.back_project_jac(pixels, np.zeros((len(pixels), 1)))
        assert there.visible(points).all()
        assert there.project(points) == pytest.approx(pixels, abs=1e-8)
    assert 20 < accepted < 100


# -- OpenCV ------------------------------------------------------------------------------------------------------------


def opencv():
    return pytest.importorskip("cv2", reason="OpenCV is not installed: pip install opencv-python-headless")


MATRIX = np.array([[K[2], 0, K[0]], [0, K[3], K[1]], [0, 0, 1.0]])


def compare_with_opencv(points, lens):
    """Values, and Jacobians w.r.t. the point (by the translation: the chain rule of x + t), intrinsics, distortion."""
    pixels, jacobian = opencv().projectPoints(np.ascontiguousarray(points), np.zeros(3), np.zeros(3), MATRIX, lens)
    value, J = brown.project.jac(np.concatenate([points, np.ones((len(points), 1))], axis=-1), K, lens)
    theirs = jacobian.reshape(len(points), 2, -1)  # rotation, translation, (fu, fv), (cu, cv), distortion
    assert value == pytest.approx(pixels[:, 0], abs=1e-9)
    assert J.point[..., :3] == pytest.approx(theirs[..., 3:6], abs=1e-9)
    assert J.intrinsics == pytest.approx(theirs[..., [8, 9, 6, 7]], abs=1e-9)
    assert J.distortion == pytest.approx(theirs[..., 10 : 10 + len(lens)], abs=1e-9)


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_opencv_projects_to_the_same_pixels_with_the_same_jacobians(seed):
    rng = np.random.default_rng(seed)
    lens = random_lens(rng, 0.1)
    points = np.concatenate([rng.uniform(-1, 1, (30, 2)), rng.uniform(1, 5, (30, 1))], axis=-1)
    near_the_axis = points * [1e-9, 1e-7, 1]
    compare_with_opencv(np.concatenate([points, near_the_axis, [[0, 0, 1.0]]]), lens)


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_opencv_projects_through_these_lenses_to_the_same_pixels(rng, lens):
    points = np.concatenate([rng.uniform(-0.7, 0.7, (50, 2)), np.ones((50, 1))], axis=-1)
    compare_with_opencv(points, np.array(lens))


@pytest.mark.parametrize("lens", [LEANING, FREIBURG, RATIONAL])
def test_opencv_takes_pixels_back_to_the_same_rays_if_it_may_iterate(lens):
    cv2 = opencv()
    u, v = np.meshgrid(np.linspace(100, 540, 9), np.linspace(100, 380, 7))
    pixels = np.stack([u.ravel(), v.ravel()], axis=-1)
    ours = brown.ideal_point(pixels, K, lens)
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 1000, 1e-13)
    patient = getattr(cv2, "undistortPointsIter", cv2.undistortPoints)  # one name since OpenCV 5
    theirs = patient(pixels[:, None], MATRIX, np.array(lens), R=None, P=None, criteria=criteria)[:, 0]
    assert ours == pytest.approx(theirs, abs=1e-9)
