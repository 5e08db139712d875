"""The fisheye and Davison's lens: definitions, OpenCV's pixels, nasty points, inverses, bad input."""

import json
from dataclasses import replace

import numpy as np
import pytest
from slambook import rendering

from slamlib.cli import main
from slamlib.codegen import check_model
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.observation.lines import image_line, undistort_segments
from slamlib.rigs.setup import SensorSetup
from slamlib.sensors import davison, fisheye, omni, pinhole
from slamlib.sensors.sensor import Calibration
from slamlib.tests.differences import differences
from slamlib.vision.two_views import _depths

K = np.array([0.0034823894022493434, 0.0007150348452162257, -0.0020532361418706202, 0.00020293673591811182])
INTRINSICS = np.array([254.93, 256.90, 190.98, 192.5])
WIDE = [320.0, 240.0, 300.0, 310.0]


def camera(distortion=K, intrinsics=INTRINSICS, **changes):
    return Calibration(fisheye.FISHEYE, np.eye(2), intrinsics=intrinsics, distortion=distortion, **changes)


def lens(strength, **changes):
    given = {"intrinsics": WIDE, "distortion": [strength], **changes}
    return Calibration(davison.DAVISON, np.eye(2), **given)


def towards(angle, azimuth, w=0.3):
    """Homogeneous point at an angle from the axis."""
    across = np.sin(angle)
    return np.stack(np.broadcast_arrays(across * np.cos(azimuth), across * np.sin(azimuth), np.cos(angle), w), axis=-1)


@pytest.fixture
def rng():
    return np.random.default_rng(5)


def nearby(model):
    """Random arguments where a model is defined: Davison's root is real for small coefficients near the axis."""
    middle = {"point": [0, 0, 1, 0], "intrinsics": [0, 0, 1, 1]}
    return lambda rng: [rng.uniform(-0.3, 0.3, a.size) + middle.get(a.name, 0) for a in model.arguments]


MODELS = [fisheye.project, davison.distorted, davison.undistorted, davison.project, davison.back_project]
every_model = pytest.mark.parametrize("model", MODELS, ids=lambda m: f"{m.module}.{m.name}")


@every_model
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, sample=nearby(model), silent=True)


@every_model
def test_central_differences_agree(model, rng):
    item = nearby(model)(rng)
    value, jacobians = model.jac(*item)
    assert model(*item) == pytest.approx(value, rel=1e-13)
    for index in range(len(item)):
        numerical = differences(model, item, index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))


def test_opencv_projects_and_undistorts_the_same(rng):
    cv2 = pytest.importorskip("cv2", reason="OpenCV is compared with")
    points = np.concatenate([rng.standard_normal((2000, 4)), [[0, 0, 1, 1], [1e-9, 0, 1, 1]]])
    points = points[points[:, 2] > 0]
    u, v, a, b = INTRINSICS
    matrix = np.array([[a, 0, u], [0, b, v], [0, 0, 1]])
    for k in (K, [-0.01, 0.02, -0.01, 0.003], [0.0, 0, 0, 0]):
        there, J = cv2.fisheye.projectPoints(points[:, None, :3], np.zeros(3), np.zeros(3), matrix, np.array(k))
        found, own = camera(k).project_jac(points)
        np.testing.assert_allclose(found, there[:, 0], atol=1e-9)
        J = J.reshape(len(points), 2, -1)  # by focal lengths, principal point, coefficients, ...
        np.testing.assert_allclose(own.distortion, J[..., 4:8], atol=1e-7)
        np.testing.assert_allclose(own.intrinsics, J[..., [2, 3, 0, 1]], atol=1e-7)
        near = np.linalg.norm(points[:, :2] / points[:, 2:3], axis=1) < 3
        back = cv2.fisheye.undistortPoints(there[near], matrix, np.array(k))[:, 0]
        rays, _ = camera(k).back_project_jac(found[near], [0.3])
        np.testing.assert_allclose(rays[:, :2] / rays[:, 2:3], back, atol=1e-7)


@pytest.mark.parametrize("degrees", [0.0, 1e-13, 1e-6, 45.0, 89.999, 90.0, 90.001, 120.0, 170.0])
def test_the_fisheye_is_smooth_on_its_axis_and_behind_itself(degrees):
    cal, point = camera([-0.02, 0.004]), towards(np.radians(degrees), 0.7)
    assert cal.visible(point)
    pixel, J = cal.project_jac(point)
    numerical = np.stack([cal.project(point + d) - cal.project(point - d) for d in 1e-6 * np.eye(4)], axis=-1) / 2e-6
    assert J.point == pytest.approx(numerical, abs=2e-5)
    again, G = cal.back_project_jac(pixel, point[3:])
    assert again == pytest.approx(point, abs=1e-11)
    tangent = np.eye(3) - np.outer(point[:3], point[:3])
    assert G.measurement[:3] @ J.point[:, :3] == pytest.approx(tangent, abs=1e-9)


def test_the_fisheye_is_an_omnidirectional_camera_with_odd_powers(rng):
    u, v, a, b = INTRINSICS
    same = Calibration(
        omni.OMNI, np.eye(2), intrinsics=[u, v, b / a, 0, 0], lens=a * np.array([1, K[0], 0, K[1], 0, K[2], 0, K[3]])
    )
    points = rng.standard_normal((200, 4))
    np.testing.assert_allclose(camera().project(points), same.project(points), atol=1e-9)
    assert camera().limits["angle"] == pytest.approx(same.limits["angle"])


def test_the_fisheye_ends_at_its_fold_and_at_half_a_turn():
    folding = camera([-0.1], intrinsics=[0, 0, 300, 300])
    fold = 1 / np.sqrt(0.3)
    assert folding.limits["angle"] == pytest.approx(fold)
    assert folding.visible(towards(fold * np.array([0.999, 1.001]), 0.2)).tolist() == [True, False]
    for share in (0.5, 0.999):
        point = towards(share * fold, 0.4)
        assert folding.back_project_jac(folding.project(point), [0.3])[0] == pytest.approx(point, abs=1e-8)
    with pytest.raises(SingularPointError, match=r"no ray gives the pixel \[500.0, 0.0\].*beyond the fold"):
        folding.back_project_jac([500.0, 0.0], [0.5])
    straight = camera([0.0], intrinsics=[0, 0, 100, 100])  # an equidistant lens: 100 px for a radian
    assert straight.limits["angle"] == np.pi
    assert straight.back_project_jac([0.0, 314.0], [0.5])[0][2] == pytest.approx(np.cos(3.14))
    with pytest.raises(SingularPointError, match=r"pixel \[0.0, 315.0\], more than 180 degrees"):
        straight.back_project_jac([[0.0, 10.0], [0.0, 315.0]], [0.5])


def test_senseless_fisheyes_are_refused():
    with pytest.raises(SlamlibError, match=r"fisheye: intrinsics are \(u0, v0, au, av\)"):
        camera(intrinsics=[320, 240, 1, 0, 0][:3])
    with pytest.raises(SlamlibError, match="au, av > 0"):
        camera(intrinsics=[320, 240, 300, -300])
    with pytest.raises(SlamlibError, match=r"folds back at 1.8257 rad .* 1.9 rad"):
        camera([-0.1], limits={"angle": 1.9})
    with pytest.raises(SlamlibError, match=r"folds back at 3\.1416 rad"):
        camera(limits={"angle": 0.0})


@pytest.mark.parametrize("strength", [0.3, -0.2, 0.0])
def test_davisons_lens_is_the_formula_and_its_inverse_is_closed(strength, rng):
    """Along the radius, in pixels, as MonoSLAM has it: written once more."""
    cal = lens(strength, intrinsics=[320, 240, 300, 300])
    points = np.concatenate([rng.uniform([-1, -1, 1, 0], [1, 1, 3, 1], (200, 4)), [[0, 0, 1, 0.5]]])
    seen = cal.visible(points)
    assert seen.all()
    k1 = strength / 300**2
    offset = 300 * points[:, :2] / points[:, 2:3]
    r = np.linalg.norm(offset, axis=1, keepdims=True)
    pixels = cal.project(points)
    np.testing.assert_allclose(pixels, [320, 240] + offset / np.sqrt(1 + 2 * k1 * r**2), atol=1e-10)
    rays, G = cal.back_project_jac(pixels, points[:, 3:])
    np.testing.assert_allclose(rays[:, :2] / rays[:, 2:3], points[:, :2] / points[:, 2:3], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(rays[:, :3], axis=1), 1, atol=1e-14)
    J = cal.project_jac(rays)[1]
    for name in ("intrinsics", "distortion"):  # y(x(y, k), k) = y
        total = getattr(J, name) + J.point @ getattr(G, name)
        np.testing.assert_allclose(total, 0, atol=1e-10 * max(1, np.abs(getattr(J, name)).max()))


def test_what_davisons_lens_can_see():
    barrel, cushion = lens(0.3), lens(-0.2)
    points = np.array([[0, 0, 1, 1], [0, 0, -1, 1], [1, 0, 0, 1], [100, 0, 1, 1], [1.58, 0, 1, 1], [1.59, 0, 1, 1.0]])
    assert barrel.visible(points).tolist() == [True, False, False, True, True, True]
    assert cushion.visible(points).tolist() == [True, False, False, False, True, False]  # 1 / sqrt(0.4) = 1.581
    with pytest.raises(SingularPointError):
        barrel.back_project_jac([320.0 + 300 * 1.3, 240.0], [0.5])  # 1 / sqrt(0.6) = 1.291


def test_davisons_lens_images_lines_once_its_distortion_is_undone(rng):
    cal = lens(0.3)
    ends = rng.uniform([-1, -1, 1], [1, 1, 3], (2, 3))
    seen = cal.project(np.column_stack([ends, [1, 1]])).ravel()
    ideal, _ = undistort_segments(cal, seen)
    np.testing.assert_allclose(ideal, lens(0.0).project(np.column_stack([ends, [1, 1]])).ravel(), atol=1e-9)
    image = image_line(cal, np.concatenate([np.cross(*ends), ends[1] - ends[0]]))[0]
    np.testing.assert_allclose(
        np.column_stack([ideal.reshape(2, 2), [1, 1]]) @ image / np.abs(image).max(), 0, atol=1e-9
    )


def test_one_coefficient_of_davison_and_one_of_the_polynomial_agree_to_first_order():
    r = np.array([[0.1, 0.0]])
    bent = davison.distorted(r, [0.3])
    assert np.abs(bent - pinhole.distort(r, [-0.3])).max() < 2 * 0.1**5


def test_senseless_lenses_of_davison_are_refused():
    with pytest.raises(SlamlibError, match="distortion is one number"):
        lens(0.3, distortion=[])
    with pytest.raises(SlamlibError, match="au, av > 0"):
        lens(0.3, intrinsics=[320, 240, 0, 300])
    lens(0.28, image=(640, 480))
    with pytest.raises(SlamlibError, match=r"corner is at radius 1.32, and with the distortion 0.3 .* beyond 1.29"):
        lens(0.3, image=(640, 480))


def test_two_views_use_the_middle_of_a_wide_picture():
    folding = camera([-0.1], intrinsics=[0, 0, 300, 300])
    pixels = folding.project(towards(np.array([0.0, 1.0, 1.8]), 0.3))
    found = _depths(folding, np.concatenate([pixels, [[500.0, 0.0]]]))
    np.testing.assert_allclose(found, [1, np.cos(1.0), np.cos(1.8), -1], atol=1e-9)


def test_pictures_of_a_fisheye_run_as_they_are(tmp_path, capsys):
    """A film through a wide lens, with two of Kalibr's files, one of them right; it starts by two views."""
    pytest.importorskip("cv2", reason="OpenCV reads the pictures")
    pytest.importorskip("skimage", reason="its photographs hang in the room")
    focal = 60.0  # the corners are some 120 degrees off the axis
    path, k = rendering.path("sideways"), (-0.02, 0.004, -0.001, 0.0002)
    lens = {"intrinsics": (99.5, 74.5, focal, focal), "distortion": k}
    camera = SensorSetup(type="fisheye", image=(200.0, 150.0), parameters=lens, std=(0.15,))
    rig, room = replace(rendering.rig_along_path(path), sensors=(camera,)), rendering.default_room("photographs")
    film = rendering.film(room, rig, path, frames=24, dt=1 / 15, rng=np.random.default_rng(1), samples=1)
    folder, off = rendering.save_film(tmp_path / "film", film), {}
    for model, coefficients in (("equidistant", list(k)), ("none", [])):
        (tmp_path / f"{model}.yaml").write_text(
            f"cam0:\n  camera_model: pinhole\n  intrinsics: [{focal}, {focal}, 99.5, 74.5]\n  resolution: [200, 150]\n"
            f"  distortion_model: {model}\n  distortion_coeffs: {coefficients}\n"
        )
        words = ["--source", str(folder / "image_0"), "--calibration", str(tmp_path / f"{model}.yaml"), "--fps", "15"]
        words += ["--seed", "0", "--reference", str(folder / "groundtruth_0.txt"), "--json"]
        assert main(["run", "images", *words]) == 0
        out, err = capsys.readouterr()
        off[model] = json.loads(out)["reference"]["relative_ate"]
        assert "no two views" not in err or model == "none"
    assert off["equidistant"] < 0.025
    assert off["none"] > 2 * off["equidistant"]
