"""Pairs of pictures and the calibrations of two cameras: formats, rectification against geometry, offset, checks."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from slambook.stereo_films import stereo_film

from slamlib.datasets.calibrations import read_pair
from slamlib.datasets.lens import Lens, PairCalibration
from slamlib.datasets.opening import open_pairs, reopen
from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.rectification import rectification, rectified_setup, why_not_rectified
from slamlib.datasets.sources import of_pictures
from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import rotation
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.tests.pictures import KALIBR
from slamlib.vision.opening import PAIRS, load, open_stereo, stereo_run
from slamlib.vision.stereo import StereoSettings
from slamlib.vision.stereo.features import check_pair, extract_features

cv2 = pytest.importorskip("cv2", reason="OpenCV reads, rectifies and searches the pictures")
yaml = pytest.importorskip("yaml", reason="PyYAML reads the calibrations in YAML")
K = np.array([[400.0, 0, 310], [0, 405.0, 235], [0, 0, 1]])
SIZE = (640, 480)
TURN = cv2.Rodrigues(np.array([0.02, -0.03, 0.01]))[0]
SHIFT = np.array([0.11, 0.004, -0.003])  # of the right camera, in the left one's frame
PLACE = """  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
"""  # of the right camera, as Kalibr gives it
CHAIN = KALIBR.replace("cam1:\n", f"cam1:\n{PLACE}")


def place(turn=TURN, shift=SHIFT):
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = turn, shift
    return found


def lens(distortion=(), matrix=K, model="radial-tangential"):
    (a, _, u), (_, b, v), _ = matrix.tolist()
    return Lens((u, v, a, b), SIZE, model, distortion)


def written(folder, name, text):
    (folder / name).write_text(text)
    return str(folder / name)


def test_kitti_and_the_coloured_pair(tmp_path):
    rows = [f"P{i}: 700 0 600 {x} 0 700 180 {y} 0 0 1 0" for i, (x, y) in enumerate(((0, 0), (-375, 0), (45, 0.2)))]
    path = written(tmp_path, "calib.txt", "\n".join([*rows, "P3: 700 0 600 -330 0 700 180 2.2 0 0 1 0"]))
    assert read_pair([path]).transform[0, 3] == pytest.approx(375 / 700)
    colour = read_pair([path], (2, 3))
    assert colour.transform[0, 3] == pytest.approx(375 / 700)
    assert why_not_rectified(colour) is None  # 2 px at 1 m: KITTI's own rows are so far apart
    setup, offset = rectified_setup(colour, (1241, 376))
    assert setup["parameters"] == {"intrinsics": (600, 180, 700, 700), "baseline": (pytest.approx(375 / 700),)}
    assert offset == 0


def test_slamlibs_own_and_plain_files(tmp_path):
    text = {"intrinsics": [300, 200, 500, 501], "baseline": 0.2, "offset": 3.5, "std": [0.2, 0.2, 0.3]}
    plain = read_pair([written(tmp_path, "a.json", json.dumps(text))])
    setup, offset = rectified_setup(plain, (640, 400))
    assert (offset, setup["std"], setup["parameters"]["baseline"]) == (3.5, (0.2, 0.2, 0.3), (0.2,))
    stereo = SensorSetup(type="stereo", parameters={"intrinsics": (320, 240, 500, 500), "baseline": (0.3,)}, std=(0.4,))
    rig = Rig((RobotSetup(),), (stereo,))
    for name, data in (("b.json", rig.to_dict()), ("c.json", rig.to_dict()["sensors"][0])):
        setup, offset = rectified_setup(read_pair([written(tmp_path, name, json.dumps(data))]), SIZE)
        assert (setup["parameters"]["baseline"], tuple(setup["std"]), offset) == ((0.3,), (0.4,), 0)
        assert SensorSetup(**setup).calibration.noise[0, 0] == pytest.approx(0.16)
    two = Rig((RobotSetup(),), (SensorSetup("left"), SensorSetup("right", position=(0.0, -0.1, 0.0))))
    found = read_pair([written(tmp_path, "d.json", json.dumps(two.to_dict()))])
    np.testing.assert_allclose(found.transform, place(np.eye(3), [0.1, 0, 0]), atol=1e-12)


def test_kalibrs_and_opencvs_files_of_two_cameras(tmp_path):
    alone = written(tmp_path, "alone.yaml", KALIBR)
    for path in (alone, Path(alone)):
        with pytest.raises(SlamlibError, match=r"alone\.yaml: the baseline is missing"):
            read_pair([path])
    found = read_pair([written(tmp_path, "camchain.yaml", CHAIN)])
    assert (found.left.model, found.right.model) == ("equidistant", "radial-tangential")
    np.testing.assert_allclose(found.transform, place(np.eye(3), [0.11, 0, 0]), atol=1e-12)
    storage = cv2.FileStorage(str(tmp_path / "stereo.yml"), cv2.FILE_STORAGE_WRITE)
    moved = np.linalg.inv(place())
    for name, value in (("M1", K), ("D1", np.zeros(5)), ("M2", K), ("D2", np.zeros(5)), ("R", moved[:3, :3])):
        storage.write(name, value)
    storage.write("T", moved[:3, 3:].copy())
    storage.release()
    np.testing.assert_allclose(read_pair([str(tmp_path / "stereo.yml")]).transform, place(), atol=1e-12)


def camera(**more):
    """One of Kalibr's cameras."""
    return {"camera_model": "pinhole", "intrinsics": [400.0, 405, 310, 235], "resolution": [640, 480],
            "distortion_model": "radtan", "distortion_coeffs": [0.0] * 4, **more}  # fmt: skip


def test_a_chain_of_kalibr_is_composed_for_every_pair(tmp_path):
    """Each camera is told in the frame of the one before; the order in the file is of no account."""
    steps = [place(cv2.Rodrigues(0.1 * np.array([i, 1.0, -1]))[0], [0.1 + 0.05 * i, 0.01, 0.02 * i]) for i in range(3)]
    chain = {f"cam{i + 1}": camera(T_cn_cnm1=np.linalg.inv(step).tolist()) for i, step in enumerate(steps)}
    text = yaml.dump({**dict(reversed(chain.items())), "cam0": camera()}, sort_keys=False)
    path, poses = written(tmp_path, "camchain.yaml", text), [np.eye(4)]
    for step in steps:
        poses.append(poses[-1] @ step)
    for i, j in ((0, 1), (1, 2), (2, 3), (0, 2), (0, 3), (1, 3), (3, 1)):
        expected = np.linalg.solve(poses[i], poses[j])
        np.testing.assert_allclose(read_pair([path], (i, j)).transform, expected, atol=1e-12)
    with pytest.raises(SlamlibError, match="no camera 4, but 0, 1, 2, 3"):
        read_pair([path], (0, 4))
    del chain["cam2"]["T_cn_cnm1"]
    with pytest.raises(SlamlibError, match="the baseline is missing"):
        read_pair([written(tmp_path, "broken.yaml", yaml.dump({"cam0": camera(), **chain}))], (0, 3))


@pytest.mark.parametrize(("name", "turned"), [("T_imu_cam", False), ("T_cam_imu", True)])
def test_places_by_the_inertial_sensor(tmp_path, name, turned):
    """OpenVINS has the cameras' poses in its frame, Kalibr the inverses, beside the sensor's own entries."""
    one, other = place(np.eye(3), [0.3, 0.2, 0.1]), place(np.eye(3), [0.3, 0.2, 0.1]) @ place()
    given = [np.linalg.inv(pose) if turned else pose for pose in (one, other)]
    text = {f"cam{i}": camera(**{name: pose.tolist()}, timeshift_cam_imu=0.01) for i, pose in enumerate(given)}
    path = written(tmp_path, "chain.yaml", "%YAML:1.0\n" + yaml.dump({**text, "imu0": {"update_rate": 200}}))
    np.testing.assert_allclose(read_pair([path]).transform, place(), atol=1e-12)
    np.testing.assert_allclose(read_pair([path], (1, 0)).transform, np.linalg.inv(place()), atol=1e-12)
    for half in ({**text, "cam1": camera()}, {**text, "cam0": camera()}):  # the other one's place is not in its frame
        with pytest.raises(SlamlibError, match="the baseline is missing"):
            read_pair([written(tmp_path, "half.yaml", yaml.dump(half))])


@pytest.mark.parametrize("error", [1e-4, 0.02])
def test_places_that_are_stated_twice_are_alike_or_refused(tmp_path, error):
    """As in Kalibr's camchain-imucam.yaml, which has the chain and the inertial sensor beside it."""
    one = place(np.eye(3), [0.3, 0.2, 0.1])
    wrong = place(shift=SHIFT + np.array([0, error, 0]))
    chain = {"T_cn_cnm1": np.linalg.inv(place()).tolist()}
    first, sensor = {"T_cam_imu": np.linalg.inv(one).tolist()}, {"T_cam_imu": np.linalg.inv(one @ wrong).tolist()}
    for more, said in (
        ({**chain, **sensor}, "cam1's places by T_cn_cnm1 and T_cam_imu differ, by 0.02 m and"),
        ({**sensor, "T_imu_cam": (one @ place()).tolist()}, "cam1's places by T_cam_imu and T_imu_cam differ"),
        ({**chain, "T_imu_cam": (one @ wrong).tolist()}, "cam1's places by T_cn_cnm1 and T_imu_cam differ"),
    ):
        path = written(tmp_path, "both.yaml", yaml.dump({"cam0": camera(**first), "cam1": camera(**more)}))
        if error > 0.01:
            with pytest.raises(SlamlibError, match=said):
                read_pair([path])
        else:
            np.testing.assert_allclose(read_pair([path]).transform, place(), atol=1.01 * error)
    turned = (one @ place(cv2.Rodrigues(np.array([0.02, -0.01, 0.01]))[0])).tolist()
    text = yaml.dump({"cam0": camera(T_imu_cam=one.tolist()), "cam1": camera(**chain, T_imu_cam=turned)})
    with pytest.raises(SlamlibError, match=r"m and 1\.1.* degrees: delete the one that is wrong"):
        read_pair([written(tmp_path, "turned.yaml", text)])


def test_where_the_chain_has_a_gap_the_inertial_sensor_tells_the_places(tmp_path):
    """Cameras 0 and 2 of a file from which camera 1 was deleted: T_cn_cnm1 of camera 2 refers to nobody."""
    text = {f"cam{n}": camera(T_imu_cam=pose.tolist()) for n, pose in ((0, np.eye(4)), (2, place()))}
    text["cam2"]["T_cn_cnm1"] = np.eye(4).tolist()
    found = read_pair([written(tmp_path, "gap.yaml", yaml.dump(text))], (0, 2))
    np.testing.assert_allclose(found.transform, place(), atol=1e-12)


SIDES = ("M1 D1 M2 D2", "K0 D0 K1 D1", "mtxL distL mtxR distR", "left_K left_D right_K right_D",
         "camera_matrix_left dist_coeffs_left camera_matrix_right dist_coeffs_right")  # fmt: skip


@pytest.mark.parametrize("names", SIDES)
def test_two_cameras_side_by_side(tmp_path, names):
    k, moved = (np.array([-0.1, 0.02, 0, 0.0, 0.0]), np.array([-0.2, 0.02, 0, 0, 0.0])), np.linalg.inv(place())
    storage = cv2.FileStorage(str(tmp_path / "stereo.yml"), cv2.FILE_STORAGE_WRITE)
    more = {"R": moved[:3, :3], "T": moved[:3, 3:], "E": K, "R1": TURN, "P2": np.eye(3, 4), "Q": np.eye(4)}
    for name, value in {**dict(zip(names.split(), (K, k[0], K, k[1]), strict=True)), **more}.items():
        storage.write(name, value.copy())
    storage.release()
    found = read_pair([str(tmp_path / "stereo.yml")])
    np.testing.assert_allclose(found.transform, place(), atol=1e-12)
    assert [one.distortion for one in (found.left, found.right)] == [tuple(each) for each in k]


def test_two_cameras_in_maps(tmp_path):
    one = {"camera_matrix": K.tolist(), "dist_coeffs": [[-0.1, 0.02, 0, 0]], "width": 640, "height": 480}
    text = {
        "right": {**one, "dist_coeffs": [-0.2, 0, 0, 0]},
        "left": one,
        "R": np.eye(3).tolist(),
        "T": [[-0.2], [0], [0]],
    }
    found = read_pair([written(tmp_path, "stereo.json", json.dumps(text))])
    assert (found.left.distortion[0], found.right.distortion[0], found.right.image) == (-0.1, -0.2, (640, 480))
    np.testing.assert_allclose(found.transform, place(np.eye(3), [0.2, 0, 0]), atol=1e-12)
    apart = {"left": one, "right": one, "extrinsics": {"R": np.eye(3).tolist(), "T": [-0.2, 0, 0]}}
    for whole in (apart, {"made_by": "a script", "calibration": {"result": apart}}):
        assert read_pair([written(tmp_path, "apart.yaml", yaml.dump(whole))]).transform[0, 3] == pytest.approx(0.2)
    counted = {"cam2": one, "cam1": one, "R": np.eye(3).tolist(), "T": [-0.2, 0, 0]}
    there = read_pair([written(tmp_path, "counted.json", json.dumps(counted))], (1, 2)).transform
    np.testing.assert_allclose(there, place(np.eye(3), [0.2, 0, 0]), atol=1e-12)
    with pytest.raises(SlamlibError, match="shift is not known"):
        read_pair([written(tmp_path, "more.yaml", yaml.dump({"shift": 1, "calibration": apart}))])


@pytest.mark.parametrize(("baseline", "message"), [
    (120, r"the baseline is 120 m: are its lengths in millimetres \(0.12 m\), or in centimetres \(1.2 m\)\?"),
    (0.0005, "the baseline is 0.0005 m"),
])  # fmt: skip
def test_an_unusual_baseline_is_asked_for_and_taken_from_slamlibs_own_files(tmp_path, baseline, message):
    kitti = f"P0: 700 0 600 0 0 700 180 0 0 0 1 0\nP1: 700 0 600 {-700 * baseline} 0 700 180 0 0 0 1 0\n"
    with pytest.raises(SlamlibError, match=message) as refused:
        read_pair([written(tmp_path, "calib.txt", kitti)])
    assert f'"baseline": {baseline:g}' in str(refused.value)
    own = written(tmp_path, "own.json", f'{{"intrinsics": [600, 180, 700, 700], "baseline": {baseline}}}')
    with pytest.warns(UserWarning, match=f"own.json: the baseline is {baseline:g} m, which is taken as it is"):
        assert read_pair([own]).transform[0, 3] == pytest.approx(baseline)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (lens((-0.05, 0.01), model="equidistant"), lens((0.9,), model="fov")),
        (lens((-0.1, 0.6), model="double-sphere"), lens((-0.1, 0.02, 0.0, 0.0))),
        (lens((-0.1, 0.02, 0.001, -0.0005)), lens((-0.12, 0.03, 0.0, 0.001), K + 3 * np.eye(3))),
        (lens((-0.01, 0.02, -0.01, 0.003), model="equidistant"), lens((-0.1, 0.02, 0.0, 0.0))),
    ],
)
def test_rectified_pixels_are_those_of_a_stereo_sensor(left, right):
    change, setup = rectification(PairCalibration(left, replace(right, transform=tuple(place().ravel()))), SIZE)
    sensor = SensorSetup(**setup).calibration
    assert sensor.given["baseline"][0] == pytest.approx(np.linalg.norm(SHIFT))
    np.testing.assert_allclose(rotation(change.original[3:]), new_axes(), atol=1e-12)
    rng = np.random.default_rng(1)
    rays = np.column_stack([rng.uniform(-0.5, 0.5, (40, 1)), rng.uniform(-0.35, 0.35, (40, 1)), np.ones((40, 1))])
    points = rays * rng.uniform(1, 6, (40, 1))  # in the left camera's frame
    beside = (points - SHIFT) @ TURN
    turned = new_axes() @ points.T
    expected = sensor.project(np.column_stack([turned.T, np.ones(40)]))
    for camera, (one, seen) in enumerate(((left, points), (right, beside))):
        old = projected(one, seen)
        u = expected[:, 0] - camera * expected[:, 2]
        columns, rows = (
            cv2.remap(m, as_map(u), as_map(expected[:, 1]), cv2.INTER_LINEAR) for m in change._maps[camera]
        )
        inside = sensor.inside(np.column_stack([u, expected[:, 1]]), 2)
        assert inside.sum() > 10
        np.testing.assert_allclose(columns[0][inside], old[inside, 0], atol=0.02)
        np.testing.assert_allclose(rows[0][inside], old[inside, 1], atol=0.02)


def new_axes():
    """The rectified axes, in the left camera's frame, as rows: x along the baseline, z between the two old ones."""
    x = SHIFT / np.linalg.norm(SHIFT)
    y = np.cross([0, 0, 1] + TURN[:, 2], x)
    y /= np.linalg.norm(y)
    return np.array([x, y, np.cross(x, y)])


def projected(one, points):
    """Pixels, by OpenCV where it has the model, and in other tests, by the papers' inverses, otherwise."""
    calls = {"radial-tangential": cv2.projectPoints, "equidistant": cv2.fisheye.projectPoints}
    if one.model not in calls:
        return one.pixels(points)
    k = np.pad(one.distortion, (0, max(0, 4 - len(one.distortion))))
    return calls[one.model](points[:, None], np.zeros(3), np.zeros(3), one.matrix, k)[0].reshape(-1, 2)


def as_map(values):
    return values[None].astype(np.float32)


def test_a_pair_with_one_lens_that_distorts_is_not_rectified():
    """Nor is one with a fisheye, though its coefficients are zero."""
    for bent in (lens((-0.1,)), lens((0.0,), model="equidistant"), lens((0.9,), model="fov")):
        aside = tuple(place(np.eye(3), [0.1, 0, 0]).ravel())
        for one, other in ((bent, lens()), (lens((0.0,) * 5), bent)):
            assert why_not_rectified(PairCalibration(one, replace(other, transform=aside))) == "the lenses distort"
    assert why_not_rectified(PairCalibration(lens((0.0,) * 5), replace(lens(), transform=aside))) is None


def test_two_principal_points_are_an_offset_of_the_disparities():
    _, film, _ = stereo_film(1)
    image = film[0][0].scans[0].image
    moved = np.stack([image[0], np.roll(image[1], 6, axis=1)])  # as if the right principal point were 6 px further
    plain, shifted = extract_features(image, StereoSettings()), extract_features(moved, StereoSettings(offset=6.0))
    one = {tuple(v[:2]): v[2] for v in plain.values}
    both = [(v[2], one[tuple(v[:2])]) for v in shifted.values if tuple(v[:2]) in one]
    assert len(both) > 0.8 * len(plain)
    np.testing.assert_allclose(*np.array(both).T, atol=0.02)
    coarse = StereoSettings(offset=6.0, patch=0)
    assert np.median(extract_features(moved, coarse).values[:, 2]) == pytest.approx(
        np.median(plain.values[:, 2]), abs=1
    )


def test_a_pair_is_checked_by_its_pictures():
    _, film, _ = stereo_film(1)
    image = film[0][0].scans[0].image
    check_pair(image, "this")
    with pytest.raises(SlamlibError, match="exchanged"):
        check_pair(image[::-1], "this")
    with pytest.raises(SlamlibError, match=r"this: the rows of a point .* differ by [45]\.\d px .* --rectify"):
        check_pair(np.stack([image[0], np.roll(image[1], 5, axis=0)]), "this")
    check_pair(np.zeros_like(image), "dark")


def sequence(times, has_times=True):
    pictures = [TimedImage(f"{i}.png", t, np.full((4, 6), i, np.uint8)) for i, t in enumerate(times)]
    source = of_pictures(pictures, 0.1)
    object.__setattr__(source, "has_times", has_times)
    return source


def test_pictures_belong_together_by_their_times():
    pairs = open_pairs(sequence([0.0, 0.1, 0.2, 0.4]), sequence([0.1, 0.201, 0.3, 0.4]))
    assert [p.time for p in pairs] == [0.1, 0.2, 0.4]
    assert [p.image[:, 0, 0].tolist() for p in pairs.part(1)] == [[2, 1], [3, 3]]
    with pytest.raises(SlamlibError, match="do not match"):
        open_pairs(sequence([0.0, 0.1]), sequence([5.0, 5.1]))
    with pytest.raises(SlamlibError, match="has 2 pictures, and memory has 3"):
        open_pairs(sequence([0.0, 0.1], has_times=False), sequence([0.0, 0.1, 0.2], has_times=False))


def folders(tmp_path, film):
    """The pairs of a film in two folders, and a calibration."""
    for i, (frame, _) in enumerate(film):
        for side, image in zip(("left", "right"), frame.scans[0].image, strict=True):
            (tmp_path / side).mkdir(exist_ok=True)
            cv2.imwrite(str(tmp_path / side / f"{side}_{i}.png"), image)
    text = {"intrinsics": [159.5, 119.5, 260.0, 260.0], "baseline": 0.12, "image": [320, 240]}
    written(tmp_path, "pair.json", json.dumps(text))
    return [str(tmp_path / name) for name in ("left", "right")], [str(tmp_path / "pair.json")]


def test_a_run_from_python(tmp_path):
    _, film, _ = stereo_film(4)
    (left, right), calibration = folders(tmp_path, film)
    source, camera, settings = open_stereo(left=left, right=right, calibration=calibration, fps=30)
    run = stereo_run(source, camera, motion_source="split-features", settings=settings)
    steps = iter(run)
    assert [next(steps).picture.name for _ in range(2)] == ["left_0.png", "left_1.png"]
    run.save(tmp_path / "run.npz")
    again = load(tmp_path / "run.npz", PAIRS)
    for _ in range(2):
        np.testing.assert_array_equal(next(steps).row["nis"], next(iter(again)).row["nis"])
    np.testing.assert_array_equal(run.slam.belief.matrix, again.slam.belief.matrix)
    recipe = source.part(1, 2).recipe
    assert [p.name for p in reopen(recipe)] == ["left_1.png", "left_3.png"]
    assert len(reopen(recipe, 1)) == 1
    (tmp_path / "left" / "left_3.png").unlink()
    (tmp_path / "right" / "right_3.png").unlink()
    with pytest.raises(SlamlibError, match="had more when the run was saved"):
        reopen(recipe)
    with pytest.raises(SlamlibError, match="did you mean 'split-features'"):
        stereo_run(source, camera, motion_source="split-feature")
    with pytest.raises(SlamlibError, match=r"left_0.png is 320x240, and the calibration is of 100x80"):
        list(stereo_run(source, {**camera, "image": (100.0, 80.0)}))
