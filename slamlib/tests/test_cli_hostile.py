"""Hostile input: whatever is wrong in a file or an option gives one clear line and status 2, never a traceback."""

import contextlib
import io
import json
import os
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from slamlib.cli import main
from slamlib.datasets.calibrations import read_calibration, read_lens
from slamlib.errors import SlamlibError
from slamlib.experiments.presets import PRESETS, Preset, preset
from slamlib.experiments.runs import Run
from slamlib.tests.pictures import KALIBR

BASE = {**json.loads(json.dumps(preset("points").to_dict())), "frames": 2}
WRONG = st.one_of(
    st.none(), st.booleans(), st.integers(-3, 3), st.floats(), st.text(max_size=5), st.just([]), st.just({}),
    st.lists(st.floats(-2, 2), max_size=4), st.just({"bogus": 1}), st.just([[1, 2], "a"]),
)  # fmt: skip


def called(*words):
    """Status and error output of a command."""
    err = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(err):
        try:
            status = main(list(words))
        except SystemExit as stop:
            status = stop.code
    return status, err.getvalue()


def refused(*words):
    status, err = called(*words)
    assert status == 2, err
    assert err.startswith("slamlib: ")
    assert err.count("\n") == 1
    return err


def places(data, path=()):
    """The paths of all values in plain data."""
    inner = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for name, value in inner:
        yield (*path, name)
        yield from places(value, (*path, name))


def changed(path, value, base=BASE):
    """Plain data, the base preset, with one value replaced."""
    data = json.loads(json.dumps(base))
    *outer, last = path
    inner = data
    for name in outer:
        inner = inner[name]
    inner[last] = value
    return data


@settings(
    max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(path=st.sampled_from(list(places(BASE))), value=WRONG)
def test_a_changed_preset_runs_or_is_refused_in_plain_words(path, value, tmp_path):
    file = tmp_path / "preset.json"
    file.write_text(json.dumps(changed(path, value)))
    status, err = called("run", str(file))
    lines = err.splitlines()
    assert (status, err) == (0, "") or (status == 2 and len(lines) <= 2)  # why it stopped, and that it is not saved
    assert all(line.startswith("slamlib: ") for line in lines)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (("faults",), {"bogus": 1}, "unknown key of preset.faults 'bogus'"),
        (("rig",), {**BASE["rig"], "bogus": 1}, "unknown key of preset.rig 'bogus'"),
        (("frames",), "x", "preset.frames should be a whole number"),
        (("seed",), -1, "preset.seed should be 0 or more"),
        (("dt",), 0, "preset.dt should be above 0 [s]"),
        (("name",), "../../evil", "preset.name should be a name of letters"),
        (("worlds",), [["thickCloister", {"n": "seven"}]], "world thickCloister.n should be a whole number"),
        (("worlds",), [["cloud", {"n": 3_000_000}]], "up to 1e+06"),
        (("rig", "robots", 0, "control_std"), [-1.0] * 6, "control_std[0] should be 0 or more"),
        (("rig", "robots", 0, "position_std"), [1, 2], "a list of 1 or 3"),
        (("rig", "sensors", 0, "std"), -1, "should be 0 or more"),
        (("rig", "sensors", 0, "std"), 0, "std should be above 0"),
        (("rig", "sensors", 0, "std"), [1, 2, 3], "std is one number, or 2"),
    ],
)
def test_senseless_values_are_named(path, value, message, tmp_path):
    file = tmp_path / "preset.json"
    file.write_text(json.dumps(changed(path, value)))
    assert message in refused("run", str(file))


def test_a_world_of_every_name_can_be_used_in_a_preset(tmp_path):
    (tmp_path / "preset.json").write_text(json.dumps(changed(("worlds",), [["cloud", {"n": 30}]])))
    assert called("run", str(tmp_path / "preset.json"))[0] == 0


def test_a_motion_without_noise_has_no_nees(tmp_path, capsys):
    (tmp_path / "preset.json").write_text(json.dumps(changed(("rig", "robots", 0, "control_std"), [0.0] * 6)))
    assert main(["run", str(tmp_path / "preset.json")]) == 0
    assert "the pose is known exactly" in capsys.readouterr().out


@pytest.mark.parametrize("text", ["[]", "5", "{", "null", '"a"', "", "\x00"])
def test_files_that_are_no_preset(text, tmp_path):
    (tmp_path / "preset.json").write_text(text)
    refused("run", str(tmp_path / "preset.json"))


def test_saved_runs_with_parts_missing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert called("run", "points", "--frames", "3", "--save", "whole.npz")[0] == 0
    with np.load("whole.npz") as file:
        arrays = dict(file)
    header = json.loads(str(arrays["header"]))
    cut = [{**arrays, "header": without(header, name)} for name in header]
    cut += [{**arrays, "header": {**header, "extra": without(header["extra"], name)}} for name in header["extra"]]
    for name in ("P", "means", "abscissas"):
        cut += [without(arrays, name), {**arrays, name: arrays[name][:-1]}]
    for each in cut:
        if isinstance(each["header"], dict):
            each["header"] = np.array(json.dumps(each["header"]))
        np.savez("cut.npz", **each)
        refused("run", "--resume", "cut.npz")
    (tmp_path / "junk.npz").write_text("junk")
    assert "it is damaged, or no slamlib filter" in refused("run", "--resume", "junk.npz")


def test_a_saved_run_without_its_checksum_is_not_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert called("run", "points", "--frames", "3", "--save", "whole.npz")[0] == 0
    with np.load("whole.npz") as file:
        np.savez("cut.npz", **without(dict(file), "digest"))
    assert "has been changed since it was written" in refused("run", "--resume", "cut.npz")


def without(table, name):
    return {key: value for key, value in table.items() if key != name}


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["compare", "ahmPnt", "--jobs", "0"], "an integer, 1 or more"),
        (["run", "images", "--noise", "-1"], "a number, 0 or more"),
        (["run", "images", "--impulse", "-1", "-1"], "a number, 0 or more"),
    ],
)
def test_numbers_out_of_range_are_usage_errors(words, message):
    status, err = called(*words)
    assert status == 2
    assert message in err


@pytest.mark.parametrize("command", ["images", "stereo-images"])
@pytest.mark.parametrize(
    "setting", ["cells=0", "cells=8", "patch=abc", "patch=4", "max_backoff=-1", "bogus=1", "probability=2", "x"]
)
def test_settings_of_the_search(command, setting, tmp_path):
    pytest.importorskip("cv2", reason="OpenCV reads the pictures")
    from slamlib.tests.pictures import photograph

    cv2 = pytest.importorskip("cv2")
    for side in ("left", "right"):
        (tmp_path / side).mkdir()
        for i in range(2):
            cv2.imwrite(str(tmp_path / side / f"{i}.png"), photograph("gravel"))
    (tmp_path / "camera.json").write_text('{"parameters": {"intrinsics": [160, 120, 300, 300], "distortion": [0]}}')
    (tmp_path / "pair.json").write_text('{"intrinsics": [160, 120, 300, 300], "baseline": 0.1}')
    place = {
        "images": ["--source", str(tmp_path / "left"), "--calibration", str(tmp_path / "camera.json")],
        "stereo-images": ["--left", str(tmp_path / "left"), "--right", str(tmp_path / "right"),
                          "--calibration", str(tmp_path / "pair.json")],
    }  # fmt: skip
    refused("run", command, *place[command], "--search", setting)


ROS = """image_width: 640
image_height: 480
camera_name: usb
camera_matrix:
  rows: 3
  cols: 3
  data: [500.5, 0, 320, 0, 501, 240, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.3, 0.1, 0, 0, 0]
projection_matrix:
  rows: 3
  cols: 4
  data: [1, 2]
"""


def test_ros_calibrations(tmp_path):
    (tmp_path / "camera.yaml").write_text(ROS)
    assert read_calibration(tmp_path / "camera.yaml") == {
        "type": "pinHole",
        "image": (640.0, 480.0),
        "parameters": {"intrinsics": (320.0, 240.0, 500.5, 501.0), "distortion": (-0.3, 0.1)},
    }


@pytest.mark.parametrize(
    "text",
    [
        '{"parameters": {}}', '{"parameters": 5}', '{"parameters": {"intrinsics": "a"}}', '{"sensors": 5}',
        '{"sensors": [5]}', '{"intrinsics": null}', "%YAML:1.0\n---\ncamera_matrix: 5\n",
        ROS.replace("501, 240, 0, 0, 1", "501"), ROS.replace("plumb_bob", "mystery"), ROS.replace("501", "x"),
    ],
)  # fmt: skip
def test_calibrations_that_are_none(text, tmp_path):
    (tmp_path / "camera").write_text(text)
    with pytest.raises(SlamlibError, match="camera"):
        read_calibration(tmp_path / "camera")


FILES = {
    "ROS": ROS,
    "camera_info": "height: 480\nwidth: 640\ndistortion_model: 'equidistant'\nD: [0.1, 0, 0, 0]\n"
    "K: [500, 0, 320, 0, 501, 240, 0, 0, 1]\nR: [1]\n",
    "Kalibr": KALIBR,
    "COLMAP": "1 OPENCV_FISHEYE 640 480 500 501 320 240 0.1 0 0 0\n2 SIMPLE_RADIAL 640 480 500 320 240 0.1\n",
}
JUNK = st.sampled_from(
    ["", "x", "-1", "nan", "1e999", "[", "]", ":", "\n", "\n- ", "# ", "0", "1 2", "\u00b2", "{", '"']
)


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
@pytest.mark.parametrize("name", FILES)
@given(place=st.floats(0, 1), length=st.integers(0, 6), junk=JUNK, camera=st.integers(0, 2))
def test_a_changed_calibration_is_a_camera_or_refused(name, place, length, junk, camera, tmp_path):
    text = FILES[name]
    start = int(place * len(text))
    (tmp_path / "camera").write_text(text[:start] + junk + text[start + length :], "utf-8")
    for read in (read_calibration, read_lens):
        with contextlib.suppress(SlamlibError):
            read(tmp_path / "camera", camera)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_as_a_starting_file(name, capsys):
    assert main(["preset", name]) == 0
    assert Preset.from_dict(tomllib.loads(capsys.readouterr().out)) == preset(name)


def test_version_and_lists(capsys):
    from slamlib import __version__

    with pytest.raises(SystemExit):
        main(["--version"])
    assert capsys.readouterr().out == f"slamlib {__version__}\n"
    for what, word in (("points", "1/m"), ("worlds", "n=9"), ("search", "patch = 11"), ("calibrations", "ROS")):
        assert main(["list", what]) == 0
        assert word in capsys.readouterr().out


def test_a_damaged_run_of_a_comparison_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = ["compare", "ahmPnt", "--runs", "2", "--frames", "3", "--folder", "finished", "--json"]
    assert main(words) == 0
    first = capsys.readouterr().out
    damaged = sorted((tmp_path / "finished").iterdir())[1]
    whole = damaged.read_bytes()
    for broken in (whole[: len(whole) // 2], b"", b"PK"):
        damaged.write_bytes(broken)
        assert main(words) == 2
        assert (
            f"finished/{damaged.name} cannot be read: it is damaged, or no slamlib finished run"
            in capsys.readouterr().err
        )
    damaged.unlink()
    assert main(words) == 0
    again = json.loads(capsys.readouterr().out)
    for one, other in zip(again, json.loads(first), strict=True):
        del one["milliseconds_per_frame"], other["milliseconds_per_frame"]
        assert one == other


def test_a_run_of_another_version_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["run", "points", "--frames", "3", "--save", "run.npz"]) == 0
    run = Run.load("run.npz")
    for row in run._history:
        del row[-1]
    run.save("old.npz")
    assert main(["run", "--resume", "old.npz", "--frames", "5"]) == 2
    assert "old.npz is incomplete, or has been changed" in capsys.readouterr().err


def test_a_fault_of_slamlib_s_own_is_one_line_too(monkeypatch):
    monkeypatch.setattr("slamlib.cli.starting.base", lambda name: {}["no\nsuch"])
    status, err = called("preset", "points")
    assert (status, err.count("\n")) == (1, 1)
    assert err.startswith("slamlib: a fault of slamlib's own, KeyError: 'no\\nsuch'; to report it: python -X dev")


@pytest.mark.parametrize(
    "backend", ["nonsense", "module://nowhere.backend", "module://matplotlib_inline.backend_inline"]
)
def test_a_backend_of_a_kernel_does_not_reach_the_command(backend, tmp_path):
    pytest.importorskip("matplotlib", reason="plots need matplotlib")
    here = {**os.environ, "MPLBACKEND": backend}
    plot = [sys.executable, "-m", "slamlib", "run", "points", "--frames", "2", "--plot", "errors.svg", "--overwrite"]
    run = subprocess.run(plot, cwd=tmp_path, env=here, capture_output=True, text=True, timeout=120)
    assert (run.returncode, run.stderr) == (0, "")
    assert (tmp_path / "errors.svg").is_file()
    for variable in ("DISPLAY", "WAYLAND_DISPLAY"):
        here.pop(variable, None)
    if sys.platform == "linux":
        run = subprocess.run([*plot, "--live"], cwd=tmp_path, env=here, capture_output=True, text=True, timeout=120)
        assert (run.returncode, run.stderr.count("\n")) == (2, 1)
        assert run.stderr.startswith("slamlib: matplotlib opens no window here")


def test_blank_pictures_are_no_success(tmp_path, monkeypatch, capsys):
    cv2 = pytest.importorskip("cv2", reason="OpenCV writes the pictures")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "blank").mkdir()
    for i in range(20):
        cv2.imwrite(f"blank/{i}.png", np.full((120, 160), 128, np.uint8))
    camera = {"image": [160, 120], "parameters": {"intrinsics": [80, 60, 120, 120], "distortion": [0.0]}}
    (tmp_path / "camera.json").write_text(json.dumps(camera))
    assert main(["run", "images", "--source", "blank", "--calibration", "camera.json"]) == 2
    assert "nothing was matched in any picture: are they blank, dark" in capsys.readouterr().err
