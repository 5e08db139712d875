"""Changed options, settings, saved runs and files of every format give a result, or one clear line."""

import dataclasses
import json
import re
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from slamlib.cli import main
from slamlib.cli.starting import toml
from slamlib.evaluation.trajectory import read_trajectory, write_tum
from slamlib.experiments.presets import Preset
from slamlib.slam import Options
from slamlib.tests.pictures import KALIBR
from slamlib.tests.test_cli_hostile import BASE, ROS, WRONG, called, changed, places
from slamlib.vision.active_search import ActiveSearchSettings
from slamlib.vision.opening import IMAGES, PAIRS, load
from slamlib.vision.stereo.detect import StereoSettings

FEW = settings(
    max_examples=60,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
WORDS = st.one_of(
    st.sampled_from(
        ["", "0", "1", "-1", "0.5", "1,2", "1,2,3", "nan", "inf", "-inf", "1e400", "true", "none", "[]", "{}"]
    ),
    st.sampled_from(["[[1,2],3]", '"a"', "1,,2", "ahmPnt", "idpLin", "{", "99999999999999999999", "1e-300", "../x"]),
    st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=6),
)
KITTI = "".join(f"1 0 0 {i} 0 1 0 {i % 2} 0 0 1 0\n" for i in range(6))
TUM = "".join(f"{i} {i}.5 {i % 2} 0.25 0 0 0 1\n" for i in range(6))
EUROC = "".join(f"{10**9 * i},{i},{i % 2},0,1,0,0,0\n" for i in range(1, 7))
LENS = """
  camera_model: pinhole
  intrinsics: [150, 150, 80, 60]
  resolution: [160, 120]
  distortion_model: radtan
  distortion_coeffs: [-0.1, 0.01, 0, 0]
"""
BOOFCV = (
    "pinhole: {fx: 150, fy: 150, cx: 80, cy: 60, width: 160, height: 120, skew: 0}\n"
    "radial_tangential: {radial: [-0.1, 0.01], t1: 0, t2: 0}\n"
)
NEXT = "\n"
MATRIX = [[150.0, 0, 80], [0, 150.0, 60], [0, 0, 1]]


def small(text):
    """A calibration of pictures of 640x480 for those of 160x120."""
    sizes = {"640": "160", "480": "120", "320": "80", "321": "80", "240": "60", "241": "60"}
    return re.sub("|".join(sizes), lambda found: sizes[found[0]], text)


ONE = "run images --frames 1 --source left --calibration {}"
KNOWN = "run images --frames 1 --calibration camera.json"
TWO = "run stereo-images --frames 1 --left left --right right --calibration {}"
# By the name of a file its content, and a command that reads it.
TEXTS = {
    "own.json": ('{"image": [160, 120], "parameters": {"intrinsics": [80, 60, 150, 150], "distortion": [-0.1]}}', ONE),
    "rig.json": (
        '{"robots": [{}], "sensors": [{"parameters": {"intrinsics": [80, 60, 150, 150], "distortion": [0]}}]}',
        ONE,
    ),
    "two.json": ('{"intrinsics": [80, 60, 150, 150], "baseline": 0.1, "std": [0.3, 0.3, 0.3]}', TWO),
    "ros.yaml": (small(ROS), ONE),
    "opencv.yml": (
        "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 150., 0., 80., 0., 150., 60., 0., 0., 1. ]\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 2\n   dt: d\n   data: [ -0.1, 0.01 ]\n",
        ONE,
    ),
    "euroc.yaml": (
        "sensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]\nrate_hz: 20\n"
        "resolution: [160, 120]\ncamera_model: pinhole\nintrinsics: [150, 150, 80, 60]\n"
        "distortion_model: radial-tangential\ndistortion_coefficients: [-0.1, 0.01, 0, 0]\n",
        ONE,
    ),
    "kalibr.yaml": (small(KALIBR), ONE + " --undistort"),
    "chain.yaml": (
        f"cam0:{LENS}cam1:{LENS}  T_cn_cnm1:\n"
        "  - [1, 0, 0, -0.1]\n  - [0, 1, 0, 0]\n  - [0, 0, 1, 0]\n  - [0, 0, 0, 1]\n",
        TWO + " --rectify",
    ),
    "kitti.txt": ("P0: 150 0 80 0 0 150 60 0 0 0 1 0\nP1: 150 0 80 -15 0 150 60 0 0 0 1 0\n", TWO),
    "colmap.txt": ("# cameras\n1 SIMPLE_RADIAL 160 120 150 80 60 -0.1\n", ONE),
    "boofcv.yaml": (f"{BOOFCV}model: pinhole_radial_tangential\n", ONE),
    "boofcv_pair.yaml": (
        "model: stereo_camera\n"
        + "".join(f"{side}:\n  {BOOFCV.replace(NEXT, NEXT + '  ')}model: pinhole\n" for side in ("left", "right"))
        + "rightToLeft: {rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], x: 0.1, y: 0, z: 0}\n",
        TWO + " --rectify",
    ),
    "camodocal.yml": (
        "%YAML:1.0\n---\nmodel_type: PINHOLE\nimage_width: 160\nimage_height: 120\ndistortion_parameters:\n"
        "   k1: -0.1\n   k2: 0\n   p1: 0\n   p2: 0\n"
        "projection_parameters:\n   fx: 150\n   fy: 150\n   cx: 80\n   cy: 60\n",
        ONE,
    ),
    "omni.yaml": (
        f"cam0:{LENS}".replace("pinhole", "omni").replace("[150, 150", "[1, 300, 300"),
        ONE + " --undistort",
    ),
    "dso.txt": ("0.9375 1.25 0.503125 0.504167 0.3\n160 120\ncrop\n160 120\n", ONE + " --undistort"),
    "mrpt.ini": (
        "".join(
            f"[CAM_{side}]\nresolution = [160 120]\nfx = 150\nfy = 150\ncx = 80\ncy = 60\ndist = [0 0 0 0 0]\n"
            for side in ("LEFT", "RIGHT")
        )
        + "[CAM_LEFT2RIGHT_POSE]\npose_quaternion = [0.1 0 0 1 0 0 0]\n",
        TWO,
    ),
    "calib_cam_to_cam.txt": (
        "calib_time: 09-Jan-2012 13:57:47\nS_rect_00: 1.6e+02 1.2e+02\nP_rect_00: 150 0 80 0 0 150 60 0 0 0 1 0\n"
        "S_rect_01: 1.6e+02 1.2e+02\nP_rect_01: 150 0 80 -15 0 150 60 0 0 0 1 0\n",
        TWO,
    ),
    "opencv.xml": (
        "<?xml version='1.0'?>\n<opencv_storage>\n<K type_id='opencv-matrix'><rows>3</rows><cols>3</cols><dt>d</dt>"
        "<data>150. 0. 80. 0. 150. 60. 0. 0. 1.</data></K>\n<D>-0.1 0. 0. 0.</D></opencv_storage>\n",
        ONE,
    ),
    "opencv_pair.json": (
        json.dumps({**{f"{name}{i}": value for i in (1, 2) for name, value in (("M", MATRIX), ("D", [0.0] * 5))},
                    "R": np.eye(3).tolist(), "T": [-0.1, 0, 0]}),
        TWO,
    ),
    "matrix.txt": ("150 0 80\n0 150 60\n0 0 1\n", ONE),
    "tartanair.txt": (
        "".join(f"{i}.5 {i % 2} 0.25 0 0 0 1\n" for i in range(6)), "evaluate {} kitti.kitti --times kitti.times"
    ),
    "plain.txt": ("fx 150\nfy 150\ncx 80\ncy 60\nwidth 160\nheight 120\nk1 -0.1\n", ONE),
    "tum.txt": (TUM, "evaluate {} tum.tum"),
    "tum_reference.txt": (TUM, "evaluate tum.tum {} --scale"),
    "euroc.csv": ("#timestamp,x,y,z,qw,qx,qy,qz\n" + EUROC, "evaluate {} euroc.euroc"),
    "poses.txt": (KITTI, "evaluate {} kitti.kitti --times kitti.times"),
    "pose_times.txt": ("0.0\n0.1\n0.2\n0.3\n0.4\n0.5\n", "evaluate kitti.kitti kitti.kitti --times {}"),
    "target.json": (
        '{"points": [[0, 0, 5], [1, 0, 5], [0, 1, 5], [1, 1, 5]], "std": 0.01, '
        '"pixels": [[80, 60], [110, 60], [80, 90], [110, 90]]}',
        KNOWN + " --source left --scale {}",
    ),
    "preset.json": (json.dumps(BASE), "run {}"),
    "preset.toml": ("\n".join(toml(Preset.from_dict(BASE).to_dict())), "run {}"),
    "times.txt": ("# times\n0.1 0.png\n0.2 1.png\n0.3 2.png\n", KNOWN + " --source left --times {}"),
    "list.txt": ("left/0.png\nleft/1.png\nleft/2.png\n", KNOWN + " --source {}"),
    "rgb.txt": ("0.1 left/0.png\n0.2 left/1.png\n", KNOWN + " --source ."),
    "cam0/data.csv": ("#timestamp [ns],filename\n100000000,0.png\n200000000,1.png\n", KNOWN + " --source cam0"),
    "kitti/times.txt": ("0.0e+00\n1.0e-01\n2.0e-01\n", KNOWN + " --source kitti"),
    "kitti/image_00/timestamps.txt": (
        "".join(f"2011-09-26 13:02:25.{i}64389445\n" for i in range(3)), KNOWN + " --source kitti"
    ),
}  # fmt: skip
# Files of the folder with pictures, which only their bytes can spoil.
BINARY = {
    "film/1.png": KNOWN + " --source film/1.png",
    "film/1.jpg": KNOWN + " --source film/1.jpg",
    "film/1.tif": KNOWN + " --source film/1.tif",
    "deep.png": KNOWN + " --source deep.png",
    "film.zip": KNOWN + " --source film.zip",
    "film.avi": KNOWN + " --source film.avi",
    "images.npz": "run images --frames 3 --resume {}",
    "stereo-images.npz": "run stereo-images --frames 3 --resume {}",
    "points.npz": "run --frames 4 --resume {}",
    "with.txt.cov": "evaluate with.txt tum.tum",
}
PYTHON = re.compile(r"Traceback|\bnp\.\w+\(|\barray\(|scale=(True|False)|<class|object at 0x|fault of slamlib")


def clear(status, err):
    """A result, or one line that says what is wrong; usage errors have argparse's usage before it."""
    lines = err.strip().splitlines()
    assert not PYTHON.search(err), err
    assert status == 0 or (status == 2 and lines and lines[-1].startswith("slamlib")), (status, err)


@FEW
@given(name=st.sampled_from([f.name for f in dataclasses.fields(Options)]), value=WORDS)
def test_options(name, value):
    clear(*called("run", "points_and_lines", "--frames", "2", "--option", f"{name}={value}"))


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    """A folder with left/0.png, right/0.png, ..., calibrations and a saved run of each command."""
    cv2 = pytest.importorskip("cv2", reason="OpenCV writes the pictures")
    folder = tmp_path_factory.mktemp("pictures")
    texture = (np.random.default_rng(0).random((30, 50)) * 255).astype(np.uint8)
    wall = cv2.resize(texture, (400, 240), interpolation=cv2.INTER_CUBIC)
    for side, shift in (("left", 34), ("right", 40)):
        (folder / side).mkdir()
        for i in range(3):
            cv2.imwrite(str(folder / side / f"{i}.png"), wall[60:180, shift + 2 * i : shift + 2 * i + 160])
    lens = {"intrinsics": [80, 60, 150, 150], "distortion": [0.0]}
    (folder / "camera.json").write_text(json.dumps({"image": [160, 120], "parameters": lens}))
    (folder / "pair.json").write_text('{"intrinsics": [80, 60, 150, 150], "baseline": 0.1}')
    for kind in KINDS:
        assert main(words(folder, kind, "--save", str(folder / f"{kind}.npz"))) == 0
    assert main(["run", "points", "--frames", "3", "--save", str(folder / "points.npz")]) == 0
    for there in ("kitti/image_0", "kitti/image_00/data", "cam0/data"):
        shutil.copytree(folder / "left", folder / there)
    (folder / "film").mkdir()
    for ending in ("png", "jpg", "tif"):
        cv2.imwrite(str(folder / "film" / f"1.{ending}"), wall[60:180, 34:194])
    cv2.imwrite(str(folder / "deep.png"), wall[60:180, 34:194].astype(np.uint16) << 8)
    shutil.make_archive(str(folder / "film"), "zip", folder / "left")
    film = cv2.VideoWriter(str(folder / "film.avi"), cv2.VideoWriter_fourcc(*"MJPG"), 30, (160, 120))
    for i in range(3):
        film.write(cv2.imread(str(folder / "left" / f"{i}.png")))
    film.release()
    texts = {
        "tum.tum": TUM,
        "kitti.times": "".join(f"{i}\n" for i in range(6)),
        "kitti.kitti": KITTI,
        "euroc.euroc": "#t\n" + EUROC,
        "with.txt": TUM,
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    path = read_trajectory(folder / "tum.tum")
    write_tum(folder / "with.txt", dataclasses.replace(path, covariances=np.tile(0.01 * np.eye(6), (len(path), 1, 1))))
    return folder


KINDS = {"images": (IMAGES, ActiveSearchSettings), "stereo-images": (PAIRS, StereoSettings)}


def words(folder, kind, *more):
    """The command on the pictures of a folder."""
    sides = [word for side in ("left", "right") for word in (f"--{side}", f"{folder}/{side}")]
    given = {
        "images": ["--source", f"{folder}/left", "--calibration", f"{folder}/camera.json"],
        "stereo-images": [*sides, "--calibration", f"{folder}/pair.json"],
    }
    return ["run", kind, *given[kind], "--frames", "2", *more]


@pytest.mark.parametrize("kind", KINDS)
def test_settings_of_searches(kind, pictures, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    @FEW
    @given(name=st.sampled_from([f.name for f in dataclasses.fields(KINDS[kind][1])]), value=WORDS)
    def tried(name, value):
        clear(*called(*words(pictures, kind, "--search", f"{name}={value}", "--overwrite")))

    tried()


def checked(words):
    """Call a command, and check the form of what it prints of errors: each line is slamlib's own."""
    status, err = called(*words)
    clear(status, err)
    assert all(line.startswith("slamlib: ") for line in err.splitlines()), err


@pytest.mark.filterwarnings("ignore:fy = -:UserWarning")  # which the command prints, and pytest makes an error
@pytest.mark.parametrize("name", TEXTS)
def test_texts(name, pictures, monkeypatch):
    monkeypatch.chdir(pictures)
    text, command = TEXTS[name]
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    words = [word.format(name) for word in command.split()]
    path.write_text(text)
    assert called(*words)[0] == 0, called(*words)[1]
    parsed = structure(path)

    @settings(FEW, max_examples=20)
    @given(data=st.data())
    def tried(data):
        if parsed and data.draw(st.booleans()):
            path.write_bytes(
                rewritten(
                    data, path, changed(data.draw(st.sampled_from(list(places(parsed)))), data.draw(WRONG), parsed)
                )
            )
        else:
            path.write_bytes(data.draw(st.sampled_from([spoiled, recoded, broken]))(data, text.encode()))
        checked(words)

    try:
        tried()
    finally:
        path.unlink()


def structure(path):
    """Plain data of a JSON, YAML or TOML file, or None."""
    if path.suffix == ".json":
        return json.loads(path.read_text())
    if path.suffix == ".toml":
        return json.loads(json.dumps(tomllib.loads(path.read_text())))
    if path.suffix == ".yaml":
        return pytest.importorskip("yaml", reason="PyYAML writes the calibrations").safe_load(path.read_text())
    return None


def rewritten(data, path, table):
    """Plain data as a file of the path's kind, in one of the styles that its writers have."""
    if path.suffix == ".toml":
        try:
            return "\n".join(toml(table)).encode()
        except (AttributeError, TypeError):  # what TOML cannot say
            return json.dumps(table).encode()
    if path.suffix == ".json":
        return json.dumps(table, indent=data.draw(st.sampled_from([None, 2]))).encode()
    import yaml

    flow, marks = data.draw(st.sampled_from([True, False, None])), data.draw(st.booleans())
    return yaml.safe_dump(table, default_flow_style=flow, explicit_start=marks, sort_keys=marks, encoding="utf-8")


def spoiled(data, content):
    """A text with one of its words or numbers replaced, or a piece of it cut out."""
    pieces = re.split(r"(\W+)", content.decode())
    at = data.draw(st.integers(0, len(pieces) - 1))
    if data.draw(st.booleans()):
        return "".join([*pieces[:at], data.draw(WORDS), *pieces[at + 1 :]]).encode()
    return "".join(pieces[:at] + pieces[at + data.draw(st.integers(1, 9)) :]).encode()


def recoded(data, content):
    """A text in another encoding, perhaps with a word of another language before it as a comment."""
    word = data.draw(st.sampled_from(["", "# Länge\n", "# \u7167\n"]))
    code = data.draw(st.sampled_from(["utf-16", "utf-16-le", "utf-8-sig", "latin-1", "utf-32", "cp037"]))
    return (word + content.decode()).encode(code, errors="replace")


def broken(data, content):
    """The beginning of a file, or the file with some bytes replaced."""
    if data.draw(st.booleans()):
        return content[: data.draw(st.integers(0, len(content)))]
    found = bytearray(content)
    for _ in range(data.draw(st.integers(1, 4))):
        found[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    return bytes(found)


@pytest.mark.parametrize("name", BINARY)
def test_bytes(name, pictures, monkeypatch, capfd):
    monkeypatch.chdir(pictures)
    path, words = Path(name), [word.format(name) for word in BINARY[name].split()]
    content = path.read_bytes()
    assert called(*words)[0] == 0, called(*words)[1]

    @settings(FEW, max_examples=20)
    @given(data=st.data())
    def tried(data):
        path.write_bytes(broken(data, content))
        checked(words)
        # Of the libraries behind OpenCV; what reads films may have been told before to speak.
        assert capfd.readouterr().err == "" or name == "film.avi"

    try:
        tried()
    finally:
        path.write_bytes(content)


@pytest.mark.parametrize("kind", KINDS)
def test_saved_runs(kind, pictures, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with np.load(pictures / f"{kind}.npz") as file:
        arrays = dict(file)
    header = json.loads(str(arrays["header"]))
    load(pictures / f"{kind}.npz", KINDS[kind][0])

    @FEW
    @given(path=st.sampled_from([p for p in places(header) if len(p) < 6]), value=WRONG)
    def tried(path, value):
        spoilt = {**arrays, "header": np.array(json.dumps(changed(path, value, header)))}
        np.savez(Path("spoilt.npz"), **spoilt)
        clear(*called("run", kind, "--resume", "spoilt.npz", "--frames", "3", "--overwrite"))

    tried()
