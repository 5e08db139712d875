"""Calibration files of all kinds, as a sensor's plain data; lenses that must be undistorted; what does not fit."""

import json
import re

import numpy as np
import pytest

from slamlib.datasets.calibrations import read_calibration, read_lens
from slamlib.datasets.formats.tum import LENSES as TUM
from slamlib.datasets.lens import Lens, fitted
from slamlib.datasets.rectification import undistortion
from slamlib.errors import SlamlibError
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.tests.pictures import DATA, KALIBR

cv2 = pytest.importorskip("cv2", reason="OpenCV reads and undistorts")
yaml = pytest.importorskip("yaml", reason="PyYAML reads the calibrations in YAML")
EUROC = """# General sensor definitions.
sensor_type: camera
T_BS:
  cols: 4
  rows: 4
  data: [0.0, -1.0, 0.0, -0.02,
         1.0, 0.0, 0.0, -0.06,
         0.0, 0.0, 1.0, 0.01,
         0.0, 0.0, 0.0, 1.0]
rate_hz: 20
resolution: [752, 480]
camera_model: pinhole
intrinsics: [458.654, 457.296, 367.215, 248.375] #fu, fv, cu, cv
distortion_model: radial-tangential
distortion_coefficients: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]
"""
KITTI = """P0: 7.188560e+02 0 6.071928e+02 0 0 7.188560e+02 1.852157e+02 0 0 0 1 0
P1: 7.188560e+02 0 6.071928e+02 -3.861448e+02 0 7.188560e+02 1.852157e+02 0 0 0 1 0
"""


def write(folder, text, name="calib.txt"):
    (folder / name).write_text(text)
    return folder / name


def test_slamlibs_own_files(tmp_path):
    omni = SensorSetup(type="omniCam", parameters={"intrinsics": (320.0, 240.0, 1.0, 0.0, 0.0), "lens": (170.0, -3.0)})
    rig = Rig((RobotSetup(),), (SensorSetup(name="left"), SensorSetup(name="right", position=(0, 0.1, 0)), omni))
    path = write(tmp_path, json.dumps(rig.to_dict()), "rig.json")
    for i, setup in enumerate(rig.sensors):
        assert Rig.from_dict({"robots": [{}], "sensors": [read_calibration(path, i)]}).sensors[0] == setup
    with pytest.raises(SlamlibError, match="no camera 3"):
        read_calibration(path, 3)
    with pytest.raises(SlamlibError, match="works on this camera's pictures as they are"):
        read_lens(path, 2)
    toml = "image = [640, 480]\n[parameters]\nintrinsics = [320, 240, 500, 501]\ndistortion = [-0.3, 0.1]\n"
    path = write(tmp_path, toml, "camera.toml")
    assert read_calibration(path)["parameters"]["distortion"] == (-0.3, 0.1)
    assert read_lens(path) == Lens((320, 240, 500, 501), (640, 480), distortion=(-0.3, 0.1, 0.0, 0.0, 0.0))
    with pytest.raises(SlamlibError, match="did you mean 'parameters'"):
        read_calibration(write(tmp_path, '{"parameters": {}, "parametres": 1}', "a.json"))


def test_euroc_and_kalibr(tmp_path):
    path = write(tmp_path, EUROC, "sensor.yaml")
    lens = read_lens(path)
    assert (lens.intrinsics, lens.image) == ((367.215, 248.375, 458.654, 457.296), (752, 480))
    assert lens.distortion == (-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05)
    np.testing.assert_allclose(np.reshape(lens.transform, (4, 4))[:3, 3], [-0.02, -0.06, 0.01])
    assert read_calibration(path) == {
        "type": "brownConrady",
        "image": (752.0, 480.0),
        "parameters": {"intrinsics": lens.intrinsics, "distortion": lens.distortion},
    }
    radial = write(tmp_path, EUROC.replace("0.00019359, 1.76187114e-05", "0, 0.0"))
    assert read_calibration(radial)["parameters"]["distortion"] == (-0.28340811, 0.07395907)
    chain = write(tmp_path, KALIBR, "camchain.yaml")
    assert read_lens(chain).model == "equidistant"
    assert read_calibration(chain) == {
        "type": "fisheye",
        "image": (640, 480),
        "parameters": {"intrinsics": (320.0, 240.0, 380.0, 381.0), "distortion": (-0.01, 0.02, -0.01, 0.003)},
    }
    right = read_calibration(chain, 1)
    assert right["parameters"] == {"intrinsics": (321.0, 241.0, 390.0, 391.0), "distortion": (0.0,)}
    with pytest.raises(SlamlibError, match="no camera 2, but 0, 1"):
        read_lens(chain, 2)


@pytest.mark.parametrize(
    "change",
    [
        lambda text: "\ufeff" + text,
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace(": ", ":\t"),
        lambda text: text.replace("\n", " # caf\u00e9\n"),
        lambda text: yaml.dump(yaml.safe_load(text)),
        lambda text: yaml.dump(yaml.safe_load(text), default_flow_style=True),
        lambda text: text.replace("coefficients", "parameters"),
        lambda text: json.dumps(yaml.safe_load(text)),
    ],
)
@pytest.mark.parametrize("text", [EUROC, KALIBR])
def test_one_lens_is_read_however_it_is_written(tmp_path, change, text):
    expected = read_lens(write(tmp_path, text), 1)
    assert read_lens(write(tmp_path, change(text)), 1) == expected
    (tmp_path / "utf16").write_bytes(change(text).encode("utf-16"))
    assert read_lens(tmp_path / "utf16", 1) == expected


@pytest.mark.parametrize(
    ("camera", "intrinsics", "model", "coefficients", "expected"),
    [
        ("omni", (1.2, 700, 701, 376, 240), "radtan", (-0.1, 0.02, 0.001, 0), ("unified", (1.2, -0.1, 0.02, 0.001, 0))),
        ("omni", (1.2, 700, 701, 376, 240), "none", (), ("unified", (1.2,))),
        ("ds", (-0.2, 0.55, 700, 701, 376, 240), "none", (0, 0), ("double-sphere", (-0.2, 0.55))),
        ("eucm", (0.6, 1.1, 700, 701, 376, 240), "none", (), ("extended-unified", (0.6, 1.1))),
        ("pinhole", (700, 701, 376, 240), "fov", (0.9,), ("fov", (0.9,))),
    ],
)
def test_kalibrs_other_lenses(tmp_path, camera, intrinsics, model, coefficients, expected):
    entries = {"camera_model": camera, "intrinsics": list(intrinsics), "resolution": [752, 480]}
    entries |= {
        "distortion_model": model,
        "distortion_coeffs": list(coefficients),
        "rostopic": "/a",
        "cam_overlaps": [1],
    }
    path = write(tmp_path, yaml.dump({"cam0": entries}))
    assert read_lens(path) == Lens((376, 240, 700, 701), (752, 480), *expected)
    last_first = [*intrinsics[-4:], *intrinsics[:-4]]
    if camera != "pinhole":
        with pytest.raises(SlamlibError, match=r"(xi|alpha) is from -?\d to \d+, got 700: .* in another order\?"):
            read_lens(write(tmp_path, yaml.dump({"cam0": entries | {"intrinsics": last_first}})))
    for wrong in ({"distortion_model": "equidistan"}, {"camera_model": "dss"}, {"intrinsics": [1, 2]}, {"shift": 0.1}):
        with pytest.raises(SlamlibError, match=r"calib\.txt \(Kalibr\)"):
            read_lens(write(tmp_path, yaml.dump({"cam0": entries | wrong})))


def test_kitti(tmp_path):
    path = write(tmp_path, KITTI)
    assert read_calibration(path)["parameters"]["intrinsics"] == (607.1928, 185.2157, 718.856, 718.856)
    baseline = np.reshape(read_lens(path, 1).transform, (4, 4))[:3, 3]
    np.testing.assert_allclose(baseline, [0.5371657, 0, 0], atol=1e-6)
    bare = write(tmp_path, KITTI.replace("P0: ", "").replace("P1: ", ""))
    assert read_lens(bare, 1) == read_lens(path, 1)
    with pytest.raises(SlamlibError, match="no camera 2, but 0, 1"):
        read_lens(path, 2)


def test_twelve_words_on_one_line_are_no_matrix(tmp_path):
    """KITTI's bare rows are twelve numbers; a camera of slamlib's own may be twelve words."""
    text = '{"parameters": {"intrinsics": [320, 240, 400, 410], "distortion": [0.1]}, "image": [640, 480] }'
    assert len(text.split()) == 12
    assert read_calibration(write(tmp_path, text))["parameters"]["intrinsics"] == (320, 240, 400, 410)


MESSAGE = """header:
  seq: 0
  frame_id: "camera"
height: 480
width: 640
distortion_model: "plumb_bob"
D: [-0.3, 0.1, 0.0, 0.0, 0.0]
K: [500.5, 0.0, 320.0, 0.0, 501.0, 240.0, 0.0, 0.0, 1.0]
R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
P: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]
roi:
  height: 0
  width: 0
"""


def test_ros_messages(tmp_path):
    expected = {
        "type": "pinHole",
        "image": (640.0, 480.0),
        "parameters": {"intrinsics": (320.0, 240.0, 500.5, 501.0), "distortion": (-0.3, 0.1)},
    }
    assert read_calibration(write(tmp_path, MESSAGE)) == expected
    second = re.sub(
        r"^([DKRP]): \[(.*)\]", lambda m: "\n- ".join([m[1].lower() + ":", *m[2].split(", ")]), MESSAGE, flags=re.M
    )
    assert "\n- 500.5\n- 0.0\n" in second  # as ROS 2 prints it
    assert read_calibration(write(tmp_path, second)) == expected
    assert read_lens(write(tmp_path, re.sub("D:.*\n", "", MESSAGE))).distortion == ()
    with pytest.raises(SlamlibError, match="X is not known, and holds numbers"):
        read_lens(write(tmp_path, MESSAGE.replace("D:", "X:")))
    wide = MESSAGE.replace("0.1, 0.0, 0.0, 0.0]", "0.1, 0.01, 0.0]")
    for name in ("equidistant", "fisheye"):
        found = read_calibration(write(tmp_path, wide.replace("plumb_bob", name)))
        assert (found["type"], found["parameters"]["distortion"]) == ("fisheye", (-0.3, 0.1, 0.01, 0.0))
    rational = MESSAGE.replace("plumb_bob", "rational_polynomial").replace(
        "0.0, 0.0, 0.0]\nK", "0, 0, 0.2, {}, 0, 0]\nK"
    )
    assert read_calibration(write(tmp_path, rational.format(0)))["parameters"]["distortion"] == (-0.3, 0.1, 0.2)
    lens = read_lens(write(tmp_path, rational.format(0.1)))
    assert lens.distortion == (-0.3, 0.1, 0, 0, 0.2, 0.1, 0, 0)
    found = read_calibration(write(tmp_path, rational.format(0.1)))
    assert (found["type"], found["parameters"]["distortion"]) == ("brownConrady", lens.distortion)


COLMAP = """# Camera list with one line of data per camera:
#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]
"""


@pytest.mark.parametrize(
    ("row", "kind", "focals", "distortion"),
    [
        ("SIMPLE_PINHOLE 640 480 500 320.5 240.5", "pinHole", (500, 500), (0.0,)),
        ("PINHOLE 640 480 500 501 320.5 240.5", "pinHole", (500, 501), (0.0,)),
        ("SIMPLE_RADIAL 640 480 500 320.5 240.5 -0.1", "pinHole", (500, 500), (-0.1,)),
        ("RADIAL 640 480 500 320.5 240.5 -0.1 0.02", "pinHole", (500, 500), (-0.1, 0.02)),
        ("OPENCV 640 480 500 501 320.5 240.5 -0.1 0.02 0 0", "pinHole", (500, 501), (-0.1, 0.02)),
        ("FULL_OPENCV 640 480 500 501 320.5 240.5 -0.1 0.02 0 0 0.3 0 0 0", "pinHole", (500, 501), (-0.1, 0.02, 0.3)),
        ("SIMPLE_RADIAL_FISHEYE 640 480 300 320.5 240.5 0.01", "fisheye", (300, 300), (0.01,)),
        ("RADIAL_FISHEYE 640 480 300 320.5 240.5 0.01 0.02", "fisheye", (300, 300), (0.01, 0.02)),
        ("OPENCV_FISHEYE 640 480 300 301 320.5 240.5 0.01 0.02 0 0.1", "fisheye", (300, 301), (0.01, 0.02, 0, 0.1)),
        ("SIMPLE_FISHEYE 640 480 300 320.5 240.5", "fisheye", (300, 300), (0.0,)),
    ],
)
def test_colmap(tmp_path, row, kind, focals, distortion):
    parameters = {"intrinsics": (320, 240, *focals), "distortion": distortion}  # its pixels' centres are at halves
    expected = {"type": kind, "image": (640, 480), "parameters": parameters}
    assert read_calibration(write(tmp_path, f"{COLMAP}7 {row}\n")) == expected
    two = write(tmp_path, f"{COLMAP}\t# indented\n1 PINHOLE 64 48 50 50 32 24  # one\n  2 {row}\n")
    assert read_calibration(two, 2) == expected
    with pytest.raises(SlamlibError, match="no camera 0, but 1, 2"):
        read_lens(two)


def test_slamlibs_own_pinholes_can_be_undistorted(tmp_path):
    for kind, given, opencvs in (
        ("pinHole", [-0.1, 0.02, 0.03], (-0.1, 0.02, 0.0, 0.0, 0.03)),
        ("pinHoleDepth", [-0.1], (-0.1, 0.0, 0.0, 0.0, 0.0)),
        ("brownConrady", [-0.1, 0.02, 0.001, 0.002], (-0.1, 0.02, 0.001, 0.002, 0.0, 0.0, 0.0, 0.0)),
        ("brownConrady", range(1, 9), tuple(map(float, range(1, 9)))),
    ):
        data = {"type": kind, "parameters": {"intrinsics": [320, 240, 300, 300], "distortion": list(given)}}
        assert read_lens(write(tmp_path, json.dumps(data), "own.json")).distortion == opencvs


def test_slamlibs_own_fisheye_can_be_undistorted_and_davisons_lens_need_not(tmp_path):
    data = {"type": "fisheye", "parameters": {"intrinsics": [320, 240, 300, 300], "distortion": [-0.01, 0.02]}}
    path = write(tmp_path, json.dumps(data), "fisheye.json")
    assert read_lens(path) == Lens((320, 240, 300, 300), model="equidistant", distortion=(-0.01, 0.02, 0.0, 0.0))
    for change in ({"type": "davison"}, {"parameters": {**data["parameters"], "distortion": [0, 0, 0, 0, 0.1]}}):
        with pytest.raises(SlamlibError, match="fisheyes with up to four; leave --undistort out"):
            read_lens(write(tmp_path, json.dumps(data | change), "other.json"))


@pytest.mark.parametrize(
    "text",
    [
        KALIBR,
        "distortion_model: fisheye\nD: [-0.01, 0.02, -0.01, 0.003]\nK: [380, 0, 320, 0, 381, 240, 0, 0, 1]\n",
        "1 OPENCV_FISHEYE 640 480 380 381 320.5 240.5 -0.01 0.02 -0.01 0.003\n",
    ],
    ids=["Kalibr", "ROS", "COLMAP"],
)
def test_fisheyes_of_calibration_files_are_opencvs(tmp_path, text):
    camera = SensorSetup(**read_calibration(write(tmp_path, text))).calibration
    points = np.random.default_rng(3).uniform([-1, -1, 0.1, 0], [1, 1, 1, 1], (100, 4))
    matrix, k = np.array([[380.0, 0, 320], [0, 381, 240], [0, 0, 1]]), np.array([-0.01, 0.02, -0.01, 0.003])
    there, _ = cv2.fisheye.projectPoints(points[:, None, :3], np.zeros(3), np.zeros(3), matrix, k)
    np.testing.assert_allclose(camera.project(points), there[:, 0], atol=1e-9)


@pytest.mark.parametrize("ending", ["yml", "xml", "json"])
def test_opencv(tmp_path, ending):
    path = tmp_path / f"camera.{ending}"
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    storage.write("image_width", 640)
    storage.write("image_height", 480)
    storage.write("camera_matrix", np.array([[500.0, 0, 320], [0, 501, 240], [0, 0, 1]]))
    storage.write("distortion_coefficients", np.array([[0.1, -0.2, 0.0, 0.0, 0.05]]))
    storage.release()
    found = read_calibration(path)
    assert found == {
        "type": "pinHole",
        "image": (640, 480),
        "parameters": {"intrinsics": (320, 240, 500, 501), "distortion": (0.1, -0.2, 0.05)},
    }


MATRIX = [[500.0, 0.0, 320.0], [0.0, 501.0, 240.0], [0.0, 0.0, 1.0]]


def stored(path, **values):
    """What cv2.FileStorage writes."""
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    for name, value in values.items():
        storage.write(name, np.array(value) if isinstance(value, list) else value)
    storage.release()
    return path


@pytest.mark.parametrize("count", [4, 5, 8, 12, 14])
@pytest.mark.parametrize("ending", ["yml", "xml", "json"])
def test_opencv_writes_what_is_read_back(tmp_path, ending, count):
    k = np.random.default_rng(count).standard_normal((1, count))
    others = {"calibration_time": "Mon 1 Jan", "board_width": 9, "square_size": 0.025, "flags": 0, "fisheye_model": 0}
    others |= {"avg_reprojection_error": 0.3, "extrinsic_parameters": np.ones((3, 6)), "rvecs": np.ones((3, 1, 3))}
    path = stored(tmp_path / f"c.{ending}", Camera_Matrix=MATRIX, Distortion_Coefficients=k, image_Width=640,
                  image_Height=480, **others)  # fmt: skip
    assert read_lens(path) == Lens((320, 240, 500, 501), (640, 480), distortion=tuple(k[0]))


NAMES = ("dist_coeff", "distCoeffs", "dist", "D", "distortion", "DIST_COEFS", "distortion_parameters", "distCoef")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("dump", [json.dumps, yaml.dump, lambda data: yaml.dump(data, default_flow_style=True)])
def test_scripts_write_the_coefficients_under_many_names(tmp_path, name, dump):
    """With lists, as Python's scripts do; and inside another map."""
    data = {"camera_matrix": MATRIX, name: [[-0.1, 0.2, 0.0, 0.0, 0.05]], "image_size": [640, 480], "rms": 0.2}
    expected = Lens((320, 240, 500, 501), (640, 480), distortion=(-0.1, 0.2, 0, 0, 0.05))
    assert read_lens(write(tmp_path, dump(data))) == expected
    assert read_lens(write(tmp_path, dump({"calibration": data, "board": {"width": 9}}))) == expected
    with pytest.raises(SlamlibError, match=f"{name[0]}x{name} is not known, and holds numbers"):
        read_lens(write(tmp_path, dump({**data, f"{name[0]}x{name}": 5})))


def test_numbers_that_are_left_over_in_an_opencv_file_are_refused(tmp_path):
    for others, message in (
        ({"distortion_polynomial": [0.1, 0.2]}, "distortion_polynomial is not known.* did you mean 'distortion"),
        ({"lens": {"k1": 0.1}}, "lens.k1 is not known"),
        ({"D": [0.1, 0, 0, 0], "dist": [0.2, 0, 0, 0]}, "dist and D differ|D and dist differ"),
        ({"D": [0.1, 0.2, 0.3]}, "4, 5, 8, 12 or 14 coefficients"),
        ({"D": "0.1 0 0 0"}, "D should be of finite numbers"),
        ({"D": [0.1] * 5, "fisheye_model": 1}, "equidistant: at most 4"),
        ({"lens_model": "fisheye", "distortion_model": "fov"}, "two models of the lens are named"),
        ({"model": "inverse_brown_conrady"}, "unknown model 'inversebrownconrady'; did you mean 'brownconrady'"),
    ):
        with pytest.raises(SlamlibError, match=message):
            read_lens(write(tmp_path, json.dumps({"camera_matrix": MATRIX, **others})))


def test_the_models_that_opencv_files_name(tmp_path):
    wide = {"K": MATRIX, "D": [0.1, 0.2, 0.0, 0.1]}
    said = (
        {"lens_model": "fisheye"},
        {"model": "kannala_brandt"},
        *({"fisheye": v} for v in (1, 1.0, True, "yes", "On")),
    )
    for others in said:
        assert read_lens(write(tmp_path, json.dumps(wide | others))).model == "equidistant"
    for no in (0, 0.0, False, None, "no", "False", "off"):  # YAML's readers differ about the words
        assert read_lens(write(tmp_path, yaml.dump(wide | {"is_fisheye": no}))).model == "radial-tangential"
    with pytest.raises(SlamlibError, match="fisheye is true or false, got perhaps"):
        read_lens(write(tmp_path, json.dumps(wide | {"fisheye": "perhaps"})))
    mei = read_lens(stored(tmp_path / "mei.yml", **wide, xi=[1.2]))
    assert (mei.model, mei.distortion) == ("unified", (1.2, 0.1, 0.2, 0.0, 0.1))
    assert read_lens(write(tmp_path, json.dumps(wide | {"model": "Logitech C920"}))).model == "radial-tangential"


def test_opencvs_two_cameras(tmp_path):
    path = tmp_path / "intrinsics.yml"
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    for i in (1, 2):
        storage.write(f"M{i}", np.array([[500.0 + i, 0, 320], [0, 501, 240], [0, 0, 1]]))
        storage.write(f"D{i}", np.zeros((1, 5)))
    storage.release()
    assert [read_lens(path, i).intrinsics[2] for i in (0, 1)] == [501, 502]
    with pytest.raises(SlamlibError, match="no camera 2, but 0, 1"):
        read_lens(path, 2)


@pytest.mark.parametrize(
    "text",
    [
        "fx 500\nfy 501\ncx 320\ncy 240\nk1 -0.1\n",
        "# ours\nFX: 500\nfy = 501, \ncx: 320\ncy: 240\nk1: -0.1 # radial\n",
        "500 501 320 240 -0.1 0 0 0\n",
        "fx = 500\nfy = 501\ncx = 320\ncy = 240\nk1 = -0.1\n",
        '{"fx": 500, "fy": 501, "ppx": 320, "ppy": 240, "coeffs": [-0.1, 0, 0, 0, 0]}'.replace("coeffs", "dist_coeffs"),
        "camera:\n  {fx: 500, fy: 501, cx: 320, cy: 240, k1: -0.1}\nrms: 0.2\n",
        "500;501;320;240;-0,1;0;0;0\n".replace(",", "."),
        '{"fx":500,"fy":501,"cx":320,"cy":240,"k1":-0.1}',
    ],
)
def test_plain_text(tmp_path, text):
    found = read_calibration(write(tmp_path, text))
    assert found == {
        "type": "pinHole",
        "parameters": {"intrinsics": (320, 240, 500, 501), "distortion": (-0.1,)},
    }


@pytest.mark.parametrize(
    "text",
    [
        "500 0 320\n0 501 240\n0 0 1\n",
        "500, 0, 320, 0, 501, 240, 0, 0, 1",
        "[[500. 0. 320.]\n [0. 501. 240.]\n [0. 0. 1.]]",
        "500 0 320 0\n0 501 240 0\n0 0 1 0\n0 0 0 1\n",
        "K = [500, 0, 320;\n0 501 240; 0 0 1];\n",
    ],
)
def test_a_camera_matrix_alone(tmp_path, text):
    assert read_lens(write(tmp_path, text)) == Lens((320, 240, 500, 501))


@pytest.mark.parametrize(
    "text", ['{"fx":500,"fy":501,"cx":320,"cy":240}', "{fx: 500, fy: 501, cx: 320, cy: 240}", "500 501 320 240"]
)
def test_four_numbers_in_one_line_may_have_names(tmp_path, text):
    assert read_lens(write(tmp_path, text)).intrinsics == (320, 240, 500, 501)


def test_a_y_axis_that_points_up_is_said(tmp_path):
    """As ICL-NUIM's calibration has it: its pictures are upright, and its trajectory is of a left-handed frame."""
    with pytest.warns(UserWarning, match="fy = -480 is read as 480: .* needs the other sign of y"):
        lens = read_lens(write(tmp_path, "481.20 -480.00 319.50 239.50"))
    assert lens.intrinsics == (319.5, 239.5, 481.2, 480)


def test_the_cameras_of_tum(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert read_lens("fr1") == TUM["fr1"]
    assert read_calibration("fr3")["parameters"]["intrinsics"] == (320.1, 247.6, 535.4, 539.2)
    found = read_calibration("fr1")
    assert (found["type"], found["parameters"]["distortion"]) == ("brownConrady", TUM["fr1"].distortion)
    with pytest.raises(SlamlibError, match="fr1, fr2, fr3 need no file"):
        read_calibration("fr4")
    write(tmp_path, "500 500 1 1", "fr1")  # a file comes before a name
    assert read_lens("fr1").intrinsics[0] == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("nothing to see", "no calibration that slamlib knows"),
        ("", "no calibration that slamlib knows"),
        ("fx 500\nfy 500\ncx 320\n", "cy is missing: there is fx, fy, cx"),
        ("fx 500\nfy 500\ncx 320\ncy 240\nkk1 3\n", "did you mean 'k1'"),
        ("fx 0\nfy 500\ncx 320\ncy 240\n", "focal lengths above 0"),
        ("fx five\nfy 500\ncx 320\ncy 240\n", "fx should be of finite numbers, got 'five'"),
        ("fx 500\nfy 500\ncx 320\ncy 240\nk1 .1\nk2 .1\nk3 .1\nk4 .1\n", "are k1 to k4 a fisheye's.*model fisheye"),
        ('{"fx":500,"fy":500,"cx":320,"cy":240,"k1":0,"k2":0,"k3":0,"k4":0.1}', "are k1 to k4 a fisheye's"),
        ("500,5 500,5 320,1 240,1\n", r"slamlib knows \(500,5 has a decimal comma: write .* as 500.5\)"),
        ("501,498 501,502 320,312 240,311\n", "501,498 has a decimal comma"),
        ("500,5 0 320\n0 500,5 240\n0 0 1\n", "500,5 has a decimal comma"),
        ("fx 500,5\nfy 500,5\ncx 320\ncy 240\n", "fx should be of finite numbers, got '500,5'"),
        ("nan 500 320 240", "fx should be of finite numbers, got nan"),
        ("fx 500\nfy 100\ncx 320\ncy 240\n", "500 and 100 px differ by a factor of 5, .*slamlib's own JSON"),
        ("fx 500\nfx 501\nfy 500\ncx 320\ncy 240\n", "fx is there twice"),
        ("500 0 0\n0 500 0\n320 240 1\n", "transposed, as MATLAB writes it"),
        ("500 2 320\n0 500 240\n0 0 1\n", "the pixels are skewed by 2 px"),
        (EUROC.replace("pinhole", "omni"), r"omni has the intrinsics \(xi, fu, fv, pu, pv\), got 4 numbers"),
        (EUROC.replace("pinhole", "spherical"), "unknown camera_model 'spherical'"),
        (EUROC.replace("radial-tangential", "fov"), "fov has 1 coefficients of distortion, got 4"),
        (EUROC.replace(", 1.76187114e-05", ""), "radialtangential has 0 or 4 or 5 or 8 coefficients .*, got 3"),
        (EUROC.replace("radial-tangential", "equi").replace(", 1.76187114e-05", ""), "equi has 4 coeff.*, got 3"),
        (re.sub("distortion_coef.*", "", EUROC), "distortion_coefficients is missing: there is sensor_type, T_BS"),
        (EUROC.replace("radial-tangential", "none"), "distortion_model is none, or missing, and the coefficients are"),
        (EUROC.replace("coefficients", "cofficients"), "missing: is 'distortion_cofficients' meant for it"),
        (EUROC.replace("-1.0", "-2.0"), "T_BS is no rigid motion"),
        (EUROC.replace("-1.0", "1.0"), "T_BS is no rigid motion"),
        (EUROC + "rate_hz: 30\n", "rate_hz is there twice"),
        ("1 FOV 640 480 500 500 320 240 0.9\n", "this lens .fov, coefficients 0.9.*--undistort"),
        ("1 RAD_TAN_THIN_PRISM_FISHEYE 640 480 500\n", "unknown camera model of COLMAP 'RAD_TAN_THIN"),
        ("1 PINHOLE 64 48 50 50 32 24\n1 PINHOLE 64 48 50 50 32 24\n", "the same number"),
        ("1 PINHOLE 640 480 500 320 240\n", "PINHOLE has 4 parameters, got 3"),
        ("1 PINHOLE 640 480\n", "PINHOLE has 4 parameters, got 0"),
        ("1 PINHOLE 640 480 500 500 x 240\n", "parameters of PINHOLE are numbers: could not convert"),
        ("distortion_model: plumb_bob\nD: []\nK: [500, 0]\n", "9 numbers, got 2"),
        ("distortion_model: plumb_bob\nD: []\nK: [0, 0, 0, 0, 0, 0, 0, 0, 1]\n", "focal lengths above 0"),
        (EUROC.replace("radial-tangential", "radial"), "unknown model of distortion of pinhole 'radial'"),
        (EUROC.replace(", 248.375", ""), r"pinhole has the intrinsics \(fu, fv, pu, pv\), got 3"),
        ("P0: 1 2 3\n", "P0 has 12 numbers, got 3"),
        ("P0: 0 0 607 0 0 0 185 0 0 0 1 0\n", r"focal lengths above 0: \(607.0, 185.0, 0.0, 0.0\)"),
        (KITTI + "K_00: 1\nk_1: 2\n", "k_1 is not known"),
        ("%YAML:1.0\n---\ncamera_matrix: [1,\n", r"no calibration that slamlib knows \(it is no YAML, line 4"),
        ("%YAML:1.0\n---\nother: 1\n", r"no calibration that slamlib knows \(it has other\)"),
    ],
)
def test_what_is_no_calibration_is_refused(tmp_path, text, message):
    with pytest.raises(SlamlibError, match=message):
        read_calibration(write(tmp_path, text))


def test_a_calibration_must_fit_the_pictures():
    setup = Lens((320, 240, 500, 500), (640, 480)).setup()
    assert fitted(setup, (640, 480), "x")["image"] == (640.0, 480.0)
    with pytest.raises(SlamlibError, match="of pictures of 640x480 pixels, and those of room have 320x240"):
        fitted(setup, (320, 240), "room")
    without = Lens((320, 240, 500, 500)).setup()
    assert fitted(without, (640, 480), "x")["image"] == (640.0, 480.0)
    for size in ((320, 240), (1280, 960)):
        with pytest.raises(SlamlibError, match="principal point"):
            fitted(without, size, "room")
    for order, size in (((500, 500, 320, 240), (640, 480)), ((700, 700, 640, 360), (1280, 720))):
        for image in ({}, {"image": size}):  # the focal lengths come first, by mistake
            with pytest.raises(SlamlibError, match=r"are the intrinsics .* \(fx, fy, cx, cy\)\? slamlib's order is"):
                fitted({"parameters": {"intrinsics": order}, **image}, size, "room")
    for focal in (0.8, 4.2, 25.0, 80_000.0):  # shares of the width, millimetres, micrometres
        with pytest.raises(SlamlibError, match=f"focal length of {focal:g} px does not fit .* in millimetres, or a sh"):
            fitted(Lens((320, 240, focal, focal), (640, 480)).setup(), (640, 480), "room")
    for focal in (100.0, 6400.0):
        assert fitted(Lens((320, 240, focal, focal), (640, 480)).setup(), (640, 480), "x")["image"] == (640.0, 480.0)
    aside = Lens((600, 240, 500, 500), (640, 480)).setup()
    assert fitted(aside, (640, 480), "x")["image"] == (640.0, 480.0)  # whoever gives the size may have cut it out
    with pytest.raises(SlamlibError, match="principal point"):
        fitted(Lens((700, 240, 500, 500), (640, 480)).setup(), (640, 480), "x")


LENSES = {
    "euroc": Lens((367.2, 248.4, 458.7, 457.3), (752, 480), distortion=(-0.283, 0.0740, 0.00019, 1.8e-5)),
    "fr1": TUM["fr1"],
    "fisheye": Lens((320, 240, 300, 300), (640, 480), "equidistant", (-0.01, 0.02, -0.01, 0.003)),
}


@pytest.mark.parametrize("name", LENSES)
def test_undistorted_pictures_are_those_of_a_pinhole(name):
    lens = LENSES[name]
    size = tuple(map(int, lens.image))
    undistort, setup = undistortion(lens, size)
    camera = SensorSetup(**setup).calibration
    rng = np.random.default_rng(1)
    points = np.concatenate([rng.uniform(-0.4, 0.4, (40, 2)), np.ones((40, 1))], axis=1)
    there = _project(lens, points)
    points, there = (a[((there > 20) & (there < np.array(size) - 20)).all(1)][:12] for a in (points, there))
    assert len(points) == 12
    bright = np.zeros(size[::-1], np.uint8)
    assert undistort(np.full_like(bright, 200)).min() == 200  # nowhere the lens did not see
    v, u = np.mgrid[: size[1], : size[0]]
    pixels = camera.project(np.concatenate([points, np.ones((len(points), 1))], axis=1))
    for seen, wanted in zip(there, pixels, strict=True):
        spot = 250 * np.exp(-((u - seen[0]) ** 2 + (v - seen[1]) ** 2) / 18)
        found = undistort(spot.round().astype(np.uint8)).astype(float)
        centre = np.array([(found * u).sum(), (found * v).sum()]) / found.sum()
        np.testing.assert_allclose(centre, wanted, atol=0.25)


def _project(lens, points):
    """Pixels of points in front of the camera by the equations in OpenCV's documentation, written down anew."""
    x, y = points[:, 0] / points[:, 2], points[:, 1] / points[:, 2]
    r2 = x * x + y * y
    if lens.model == "equidistant":
        t, r = np.arctan(np.sqrt(r2)), np.sqrt(r2)
        stretch = t * (1 + sum(k * t ** (2 * i + 2) for i, k in enumerate(lens.distortion))) / r
        x, y = x * stretch, y * stretch
    else:
        k1, k2, p1, p2, k3 = (*lens.distortion, 0.0)[:5]
        radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
        x, y = (
            x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
            y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
        )
    u0, v0, au, av = lens.intrinsics
    return np.stack([u0 + au * x, v0 + av * y], axis=1)


@pytest.mark.parametrize(
    ("given", "kind", "own"),
    [
        ((), "pinHole", (0.0,)),
        ((0, 0, 0, 0), "pinHole", (0.0,)),
        ((-0.2, 0.05, 0, 0, -0.01), "pinHole", (-0.2, 0.05, -0.01)),
        ((-0.2, 0.05, 0, 0, 0, 0, 0, 0), "pinHole", (-0.2, 0.05)),
        ((-0.2, 0.05, 1e-3, 0), "brownConrady", (-0.2, 0.05, 1e-3, 0)),
        ((-0.2, 0.05, 0, -2e-3, 0), "brownConrady", (-0.2, 0.05, 0, -2e-3)),
        ((-0.2, 0.05, 1e-3, 2e-3, -0.01), "brownConrady", (-0.2, 0.05, 1e-3, 2e-3, -0.01)),
        ((-0.2, 0.05, 0, 0, 0.1, 0.02, 0, 0.01), "brownConrady", (-0.2, 0.05, 0, 0, 0.1, 0.02, 0, 0.01)),
        ((-0.2, 0.05, 1e-3, 0, 0, 0, 0, 0, 0, 0, 0, 0), "brownConrady", (-0.2, 0.05, 1e-3, 0)),
    ],
)
def test_opencvs_lenses_need_no_undistortion_and_agree_with_it(given, kind, own):
    """Radial coefficients alone are the pin-hole's, which has a file of its own and is quicker."""
    lens = Lens((320, 240, 500, 501), (640, 480), distortion=given)
    setup = lens.setup()
    assert (setup["type"], setup["parameters"]["distortion"]) == (kind, own)
    assert lens.is_pinhole == (not any(given))
    points = np.random.default_rng(2).uniform(-0.3, 0.3, (20, 4)) + np.array([0, 0, 1, 1])
    K, k = np.array([[500.0, 0, 320], [0, 501, 240], [0, 0, 1]]), np.array(given, dtype=float)
    there = cv2.projectPoints(points[:, None, :3], np.zeros(3), np.zeros(3), K, k)[0]
    np.testing.assert_allclose(SensorSetup(**setup).calibration.project(points), there[:, 0], atol=1e-9)


def test_a_lens_that_makes_no_sense_is_not_undistorted():
    with pytest.raises(SlamlibError, match="does not describe pictures"):
        undistortion(Lens((900, 240, 500, 500), (640, 480)), (640, 480))
    with pytest.raises(SlamlibError, match="at most 4"):
        Lens((320, 240, 500, 500), model="equidistant", distortion=(1,) * 5)
    with pytest.raises(SlamlibError, match="did you mean 'equidistant'"):
        Lens((320, 240, 500, 500), model="equidistan")


def test_real_calibrations():
    if not (DATA / "mono_visp_cube").is_dir():
        pytest.skip("the excerpts of real sequences are not at hand")
    visp = read_calibration(DATA / "mono_visp_cube" / "calib.txt")
    assert (visp["image"], visp["parameters"]["intrinsics"]) == ((384, 288), (192, 144, 576.63, 554.99))
    kitti = read_lens(DATA / "stereo_kitti_a" / "calib.txt", 1)
    assert np.reshape(kitti.transform, (4, 4))[0, 3] == pytest.approx(0.537, abs=1e-3)
