"""Changed options, settings, calibrations, saved runs and trajectories give a result, or one clear line."""

import dataclasses
import json
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from slamlib.cli import main
from slamlib.datasets.calibrations import read_calibration
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import read_trajectory
from slamlib.slam import Options
from slamlib.tests.test_cli_hostile import ROS, WRONG, called, changed, places
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
CALIBRATIONS = {
    "own.json": '{"image": [64, 48], "parameters": {"intrinsics": [32, 24, 50, 50], "distortion": [-0.3, 0.1]}}',
    "rig.json": '{"robots": [{}], "sensors": [{"parameters": {"intrinsics": [32, 24, 50, 50], "distortion": [0]}}]}',
    "pair.json": '{"intrinsics": [32, 24, 50, 50], "baseline": 0.1, "std": [0.3, 0.3, 0.3]}',
    "ros.yaml": ROS,
    "opencv.yaml": "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 50., 0., 32., 0., 50., 24., 0., 0., 1. ]\n"
    "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 2\n   dt: d\n   data: [ -0.3, 0.1 ]\n",
    "euroc.yaml": "sensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]\n"
    "rate_hz: 20\nresolution: [64, 48]\ncamera_model: pinhole\nintrinsics: [50, 50, 32, 24]\n"
    "distortion_model: radial-tangential\ndistortion_coefficients: [-0.3, 0.1, 0, 0]\n",
    "kitti.txt": "P0: 50 0 32 0 0 50 24 0 0 0 1 0\nP1: 50 0 32 -5 0 50 24 0 0 0 1 0\n",
    "plain.txt": "fx 50\nfy 50\ncx 32\ncy 24\nwidth 64\nheight 48\nk1 -0.3\n",
}
TUM = "".join(f"{i} {i}.5 0 0.25 0 0 0 1\n" for i in range(4))
KITTI = "".join(f"1 0 0 {i} 0 1 0 0 0 0 1 0\n" for i in range(4))
EUROC = "#timestamp\n" + "".join(f"{10**9 * (1 + i)},{i},0,0,1,0,0,0\n" for i in range(4))


def clear(status, err):
    """A result, or one line that says what is wrong; usage errors have argparse's usage before it."""
    lines = err.strip().splitlines()
    assert "Traceback" not in err
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


@FEW
@given(data=st.data())
def test_calibrations(data, tmp_path):
    name = data.draw(st.sampled_from(list(CALIBRATIONS)))
    text = CALIBRATIONS[name]
    if name.endswith(".json") and data.draw(st.booleans()):
        table = json.loads(text)
        text = json.dumps(changed(data.draw(st.sampled_from(list(places(table)))), data.draw(WRONG), table))
    else:
        text = spoiled(data, text)
    (tmp_path / name).write_text(text, "utf-8")
    try:
        read_calibration(tmp_path / name)
    except SlamlibError as error:
        assert name in str(error)


@FEW
@given(data=st.data())
def test_trajectories(data, tmp_path):
    for text, times in ((TUM, None), (KITTI, np.arange(4.0)), (EUROC, None)):
        (tmp_path / "path.txt").write_text(spoiled(data, text), "utf-8")
        try:
            read_trajectory(tmp_path / "path.txt", times)
        except SlamlibError as error:
            assert re.search(r"path\.txt|^Trajectory: ", str(error))


def spoiled(data, text):
    """A text with one of its words or numbers replaced, or a piece of it cut out."""
    pieces = re.split(r"(\W+)", text)
    at = data.draw(st.integers(0, len(pieces) - 1))
    if data.draw(st.booleans()):
        return "".join([*pieces[:at], data.draw(WORDS), *pieces[at + 1 :]])
    return "".join(pieces[:at] + pieces[at + data.draw(st.integers(1, 9)) :])


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
