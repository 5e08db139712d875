"""Unified, extended unified and double sphere: their definitions, other packages' pixels, inverses, ends, bad input."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from slamlib.codegen import check_model
from slamlib.datasets.calibrations import read_calibration, read_lens
from slamlib.datasets.lens_models import DOUBLE_SPHERE, EXTENDED, UNIFIED
from slamlib.errors import ShapeError, SingularPointError, SlamlibError
from slamlib.rigs.setup import SensorSetup
from slamlib.sensors import SENSORS, double_sphere, extended_unified, unified
from slamlib.sensors.sensor import Calibration
from slamlib.tests.differences import differences

INTRINSICS = [320.0, 240.0, 210.0, 215.0]
MEI = (1.2, -0.1, 0.02, 0.001, -0.002)
LENSES = [  # on both sides of what changes the formulas: a shift of 1, alpha of 1/2; the ends of what is allowed
    *[
        ("unified", k)
        for k in ((0.0,), (0.7,), (1.0,), (1.6,), (-0.3,), (0.8, -1 / 12), MEI, (0.8, 0.05, -0.02, 0.002, 0.001, 0.003))
    ],
    *[("extendedUnified", k) for k in ((0.6, 1.1), (0.5, 0.8), (0.3, 0.7), (0.0, 2.0), (1.0, 0.9))],
    *[("doubleSphere", k) for k in ((-0.2, 0.55), (0.5, 0.7), (-0.5, 0.3), (0.9, 0.5), (0.0, 0.0), (0.3, 1.0))],
]
every_lens = pytest.mark.parametrize(("name", "k"), LENSES)


def camera(name, k, intrinsics=INTRINSICS, **changes):
    return Calibration(SENSORS[name], np.eye(2), intrinsics=intrinsics, distortion=k, **changes)


def towards(angle, azimuth=0.7, w=0.3):
    """Homogeneous point, a unit ray at an angle from the axis."""
    across = np.sin(angle)
    return np.stack(np.broadcast_arrays(across * np.cos(azimuth), across * np.sin(azimuth), np.cos(angle), w), axis=-1)


def nearby(model):
    """Random arguments where a model is defined: ahead, for small coefficients."""
    middle = {"point": [0, 0, 1, 0], "direction": [0, 0, 1], "intrinsics": [0, 0, 1, 1], "shift": 0.5}
    middle |= {"distortion": 0.4 * (np.arange(6) < 2)}
    low = {a.name: np.resize(middle.get(a.name, 0.0), a.size) for a in model.arguments}
    return lambda rng: [rng.uniform(-0.2, 0.2, a.size) + low[a.name] for a in model.arguments]


MODELS = [
    *(unified.plane, unified.pierced, unified.pixel, unified.project, unified.ray),
    *(extended_unified.plane, extended_unified.direction, extended_unified.project, extended_unified.back_project),
    *(double_sphere.project, double_sphere.back_project),
]
every_model = pytest.mark.parametrize("model", MODELS, ids=lambda m: f"{m.module}.{m.name}")


@every_model
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, sample=nearby(model), silent=True)


@every_model
def test_central_differences_agree(model):
    item = nearby(model)(np.random.default_rng(5))
    value, jacobians = model.jac(*item)
    assert model(*item) == pytest.approx(value, rel=1e-13)
    for index in range(len(item)):
        numerical = differences(model, item, index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))


def in_angles(name, k, angle):
    """Distance from the centre on the plane of an angle from the axis, before any distortion."""
    if name == "unified":
        return np.sin(angle) / (k[0] + np.cos(angle))
    alpha, stretch = (k[0], np.sqrt(k[1])) if name == "extendedUnified" else (k[1], 1.0)
    seen = np.arctan2(stretch * np.sin(angle), np.cos(angle))
    if name == "doubleSphere":
        seen = np.arctan2(np.sin(angle), np.cos(angle) + k[0])
    return np.sin(seen) / (alpha + (1 - alpha) * np.cos(seen)) / stretch


@every_lens
def test_the_pixel_is_the_formula_in_angles(name, k):
    cal = camera(name, k)
    angles, azimuth = np.linspace(0, 0.98 * cal.limits["angle"], 40), 0.7
    a, b = in_angles(name, k, angles) * np.array([[np.cos(azimuth)], [np.sin(azimuth)]])
    if name == "unified":
        k1, k2, p1, p2, k3 = (*k[1:], *(0.0,) * (6 - len(k)))
        r2 = a * a + b * b
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        a, b = (
            a * radial + 2 * p1 * a * b + p2 * (r2 + 2 * a * a),
            b * radial + p1 * (r2 + 2 * b * b) + 2 * p2 * a * b,
        )
    wanted = np.stack([320 + 210 * a, 240 + 215 * b], axis=-1)
    np.testing.assert_allclose(cal.project(5 * towards(angles, azimuth)), wanted, rtol=1e-11, atol=1e-9)


@every_lens
def test_rays_come_back_up_to_where_the_image_ends(name, k):
    cal = camera(name, k)
    end = cal.limits["angle"]
    for angle in (0.0, 1e-11, 0.3, 0.7 * end, *[a for a in (np.pi / 2, 1.9) if a < 0.99 * end], 0.99 * end):
        point = towards(angle)
        assert cal.visible(point)
        pixel, J = cal.project_jac(point)
        again, G = cal.back_project_jac(pixel, point[3:])
        assert again == pytest.approx(point, abs=1e-11)
        numerical = np.stack([cal.project(point + d) - cal.project(point - d) for d in 1e-6 * np.eye(4)], -1) / 2e-6
        assert J.point == pytest.approx(numerical, abs=2e-5 * max(1, np.abs(numerical).max() / 1e3))
        tangent = np.eye(3) - np.outer(point[:3], point[:3])
        assert G.measurement[:3] @ J.point[:, :3] == pytest.approx(tangent, abs=1e-9)
        for parameter in ("intrinsics", "distortion"):  # project(back_project(y, k), k) = y
            total = getattr(J, parameter) + J.point @ getattr(G, parameter)
            assert total == pytest.approx(np.zeros_like(total), abs=1e-8 * max(1, np.abs(getattr(J, parameter)).max()))


@pytest.mark.parametrize(("name", "k"), [(name, k) for name, k in LENSES if len(k) < 3])
def test_the_image_grows_up_to_its_end_and_no_further(name, k):
    """The default field of view is the largest in which no two directions share a pixel."""
    cal = camera(name, k)
    end = cal.limits["angle"]

    def column(angle):
        return cal.project(towards(angle, 0.0))[..., 0]

    columns = column(np.linspace(0, min(end * (1 - 1e-9), 3.1), 2000))
    assert (np.diff(columns) > 0).all()
    if end < np.pi:
        assert cal.visible(towards(end * np.array([0.999, 1.001]))).tolist() == [True, False]
        assert column(end + 1e-3) < columns[-1]  # back, or from the other side
    assert not cal.visible(np.array([0.0, 0.0, -1.0, 0.3]))


@given(
    xi=st.floats(-0.95, 0.95),
    alpha=st.floats(0, 1),
    beta=st.floats(0.2, 4),
    share=st.floats(0, 0.98),
    azimuth=st.floats(-4, 4),
    shift=st.floats(-0.9, 4),
)
def test_there_and_back_for_any_coefficients(xi, alpha, beta, share, azimuth, shift):
    for name, k in (("unified", (shift,)), ("extendedUnified", (alpha, beta)), ("doubleSphere", (xi, alpha))):
        cal = camera(name, k)
        point = towards(share * cal.limits["angle"], azimuth)
        again, _ = cal.back_project_jac(cal.project(point), [0.3])
        assert again == pytest.approx(point, abs=1e-9)


@given(xi=st.floats(0, 3), share=st.floats(0, 0.98), azimuth=st.floats(-4, 4))
def test_one_sphere_is_an_ellipsoid_and_two_spheres(xi, share, azimuth):
    one, alpha = camera("unified", (xi,)), xi / (1 + xi)
    wider = [320, 240, 210 / (1 + xi), 215 / (1 + xi)]
    point = towards(share * one.limits["angle"], azimuth)
    for name, k in (("extendedUnified", (alpha, 1.0)), ("doubleSphere", (0.0, alpha))):
        same = camera(name, k, wider)
        assert same.limits["angle"] == pytest.approx(one.limits["angle"], abs=1e-7)
        assert same.project(point) == pytest.approx(one.project(point), rel=1e-9, abs=1e-9)


def test_a_second_shift_does_nothing_new_where_it_is_zero():
    """Eq. (om-degenerate): the focal lengths and alpha do it, so that a filter cannot tell the three apart."""
    points = towards(np.linspace(0.1, 1.5, 30), np.linspace(0, 5, 30))
    for xi, dependent in ((0.0, True), (0.2, False)):
        _, J = camera("doubleSphere", (xi, 0.6), [0, 0, 1, 1]).project_jac(points)
        columns = np.column_stack([(J.intrinsics[..., 2] + J.intrinsics[..., 3]).ravel(), J.distortion.reshape(-1, 2)])
        assert (np.linalg.matrix_rank(columns, tol=1e-9) == 2) == dependent


def test_opencvs_omnidir_has_the_same_pixels_and_derivatives():
    omnidir = getattr(pytest.importorskip("cv2", reason="OpenCV is compared with"), "omnidir", None)
    if omnidir is None:
        pytest.skip("this build of OpenCV has no omnidir: pip install opencv-contrib-python-headless")
    points = towards(np.concatenate([[0.0, 1e-9], np.linspace(0.05, 2.2, 200)]), np.linspace(0, 6, 202))
    for k in (MEI, (0.7, 0.05, -0.01, 0.001, 0.002), (1.6, 0.0, 0.0, 0.0, 0.0)):
        cal = camera("unified", k)
        seen = points[cal.visible(points)]
        assert len(seen) > 100
        matrix = np.array([[210.0, 0, 320], [0, 215, 240], [0, 0, 1]])
        zero, (xi, *bending) = np.zeros((3, 1)), k
        there, jacobian = omnidir.projectPoints(seen[:, None, :3].copy(), zero, zero, matrix, xi, np.array(bending))
        value, J = cal.project_jac(seen)
        np.testing.assert_allclose(value, there[:, 0], rtol=1e-12, atol=1e-9)
        by = jacobian.reshape(len(seen), 2, -1)  # rotation, translation, fx, fy, skew, cx, cy, xi, k1, k2, p1, p2
        np.testing.assert_allclose(J.point[..., :3], by[..., 3:6], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(J.intrinsics, by[..., [9, 10, 6, 7]], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(J.distortion, by[..., 11:16], rtol=1e-9, atol=1e-9)


def test_gtsams_unified_camera_has_the_same_pixels_and_derivatives():
    gtsam = pytest.importorskip("gtsam", reason="pip install gtsam, to compare with it")
    rng = np.random.default_rng(3)
    for k in (MEI, (0.7, 0.05, -0.01, 0.001, 0.002)):
        xi, k1, k2, p1, p2 = k
        theirs, cal = gtsam.Cal3Unified(210, 215, 0, 320, 240, k1, k2, p1, p2, xi), camera("unified", k)
        for x, y in [(0.0, 0.0), *rng.uniform(-1.5, 1.5, (100, 2))]:
            by_lens, by_plane = np.zeros((2, 10), order="F"), np.zeros((2, 2), order="F")
            there = theirs.uncalibrate(np.array([x, y]), by_lens, by_plane)
            value, J = cal.project_jac(np.array([x, y, 1.0, 0.3]))
            np.testing.assert_allclose(value, there, rtol=1e-12, atol=1e-9)
            np.testing.assert_allclose(J.point[:, :2], by_plane, rtol=1e-9, atol=1e-9)
            np.testing.assert_allclose(J.intrinsics, by_lens[:, [3, 4, 0, 1]], rtol=1e-9, atol=1e-9)
            np.testing.assert_allclose(J.distortion, by_lens[:, [9, 5, 6, 7, 8]], rtol=1e-9, atol=1e-9)


KALIBR = {
    "ds": ("doubleSphere", DOUBLE_SPHERE, (-0.2, 0.55), ()),
    "eucm": ("extendedUnified", EXTENDED, (0.6, 1.1), ()),
    "omni": ("unified", UNIFIED, (1.2,), (-0.1, 0.02, 0.001, -0.002)),
}


def same_pixels(path, kind, model):
    """A file gives a sensor of this type, with the pixels of the table of models; returns its plain data."""
    found, lens = read_calibration(path), read_lens(path)
    assert (found["type"], lens.model) == (kind, model)
    cal = SensorSetup(**found).calibration
    points = np.random.default_rng(8).standard_normal((500, 4))
    points = points[cal.visible(points)]
    assert len(points) > 200
    assert (points[:, 2] < 0).sum() > 20
    np.testing.assert_allclose(cal.project(points), lens.pixels(points[:, :3]), rtol=1e-12, atol=1e-9)
    return found


@pytest.mark.parametrize("word", KALIBR)
def test_kalibrs_files_give_the_sensor(tmp_path, word):
    pytest.importorskip("yaml", reason="PyYAML reads the calibrations in YAML")
    kind, model, first, bending = KALIBR[word]
    (tmp_path / "camchain.yaml").write_text(
        f"cam0:\n  camera_model: {word}\n  intrinsics: {[*first, 150.0, 151.0, 160.0, 120.0]}\n"
        f"  distortion_model: {'radtan' if bending else 'none'}\n  distortion_coeffs: {list(bending)}\n"
        "  resolution: [320, 240]\n"
    )
    found = same_pixels(tmp_path / "camchain.yaml", kind, model)
    (tmp_path / "own.json").write_text(json.dumps(found))  # slamlib's own, which --undistort takes, too
    assert same_pixels(tmp_path / "own.json", kind, model)["parameters"]["distortion"] == (*first, *bending)


def test_camodocals_and_opencvs_files_give_the_sensor(tmp_path):
    pytest.importorskip("yaml", reason="PyYAML reads the calibrations in YAML")
    (tmp_path / "mei.yaml").write_text(
        "%YAML:1.0\n---\nmodel_type: MEI\ncamera_name: a\nimage_width: 320\nimage_height: 240\n"
        "mirror_parameters: {xi: 1.2}\ndistortion_parameters: {k1: -0.1, k2: 0.02, p1: 0.001, p2: -0.002}\n"
        "projection_parameters: {gamma1: 150.0, gamma2: 151.0, u0: 160.0, v0: 120.0}\n"
    )
    (tmp_path / "omnidir.yaml").write_text(
        "K: [150, 0, 160, 0, 151, 120, 0, 0, 1]\nD: [-0.1, 0.02, 0.001, -0.002]\nxi: 1.2\n"
        "image_width: 320\nimage_height: 240\n"
    )
    one, other = (same_pixels(tmp_path / name, "unified", UNIFIED) for name in ("mei.yaml", "omnidir.yaml"))
    assert one == other
    assert one["parameters"]["distortion"] == MEI


def test_pixels_that_no_ray_reaches_are_refused():
    for name, k in (("unified", (1.6,)), ("extendedUnified", (0.6, 1.1)), ("doubleSphere", (-0.2, 0.7))):
        cal = camera(name, k)
        rim = cal.project(towards(0.9999 * cal.limits["angle"], 0.0))
        outside = rim + np.array([5.0, 0.0])
        cal.back_project_jac(rim, [0.3])
        with pytest.raises(SingularPointError):
            cal.back_project_jac(outside, [0.3])
    folding = camera("unified", (0.5, -0.3))
    with pytest.raises(SingularPointError, match="no ray gives the pixel"):
        folding.back_project_jac([320.0 + 210 * 5, 240.0], [0.3])


def test_the_distortion_of_the_plane_ends_the_image():
    """k1 = -1/12 folds at a radius of 2: seen from the centre at arctan(2)."""
    cal, seen = camera("unified", (0.8, -1 / 12)), np.arctan(2)
    assert cal.limits["angle"] == pytest.approx(seen + np.arcsin(0.8 * np.sin(seen)))
    assert unified.largest_angle(0.8) == pytest.approx(np.arccos(-0.8))
    assert unified.largest_angle(2.0) == pytest.approx(np.arccos(-1 / 2))
    assert unified.largest_angle(1.0) == pytest.approx(np.pi)


@pytest.mark.parametrize(
    ("name", "k", "changes", "message"),
    [
        ("unified", (-1.0,), {}, "xi above -1"),
        ("unified", (), {}, r"distortion is \(xi, k1, k2, p1, p2, k3\)"),
        ("extendedUnified", (0.5,), {}, r"distortion is \(alpha, beta\)"),
        ("extendedUnified", (1.1, 1.0), {}, "alpha from 0 to 1"),
        ("extendedUnified", (-0.1, 1.0), {}, "alpha from 0 to 1"),
        ("extendedUnified", (0.5, 0.0), {}, "beta above 0"),
        ("doubleSphere", (0.5,), {}, r"distortion is \(xi, alpha\)"),
        ("doubleSphere", (1.0, 0.5), {}, "xi between -1 and 1"),
        ("doubleSphere", (0.2, 1.2), {}, "alpha from 0 to 1"),
        ("doubleSphere", (0.2, 0.5), {"intrinsics": [320, 240, 0, 200]}, r"doubleSphere: intrinsics .* au, av > 0"),
        ("extendedUnified", (0.5, 1.0), {"intrinsics": [320, 240, 200]}, "extendedUnified: intrinsics are"),
        (
            "unified",
            (2.0,),
            {"limits": {"angle": 2.2}},
            r"unified: .* the image ends 2\.0944 rad from the axis.* 2\.2 rad",
        ),
        ("unified", (2.0,), {"limits": {"angle": 0.0}}, r"the image ends"),
    ],
)
def test_senseless_lenses_are_refused(name, k, changes, message):
    with pytest.raises(SlamlibError, match=message):
        camera(name, k, **changes)


def test_too_many_coefficients_are_refused():
    with pytest.raises(ShapeError, match="distortion has at most 6 numbers"):
        camera("unified", (1.0,) * 7)
