"""The command line: what it prints, what it refuses, and that an interrupted run is not lost."""

import io
import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from slamlib.cli import main, runner
from slamlib.experiments.presets import Preset, points, preset
from slamlib.experiments.progress import progress
from slamlib.experiments.runs import Run, run
from slamlib.tests.interruptions import interrupted_at

SHORT = ["--frames", "12"]


def test_run_prints_a_table(capsys):
    assert main(["run", "points", *SHORT]) == 0
    text = capsys.readouterr().out
    for word in (
        "points, seed 1, 12 frames",
        "NEES, 6 dof, linear error",
        "NEES, 6 dof, invariant error",
        "ms per frame",
    ):
        assert word in text


def test_run_prints_json(capsys):
    assert main(["run", "lines", "--landmark", "plkLin", "--seed", "5", "--json", "--batch", *SHORT]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["preset"], found["seed"], found["frames"]) == ("lines", 5, 12)
    assert found["robots"][0]["position_error"] < 0.1
    assert found["line_error_median"] < 1  # [m]; without updates 5
    assert found["point_error_median"] is None


def test_json_goes_to_a_file_that_is_not_replaced_unasked(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for words, known in (
        (["run", "points"], "robots"),
        (["compare", "ahmPnt", "--runs", "1"], None),
    ):
        name = f"out/{words[0]}.json"
        assert main([*words, *SHORT, "--json", name]) == 0
        assert "NEES" in capsys.readouterr().out  # the table is printed all the same
        found = json.loads(Path(name).read_text())
        assert known is None or known in found
        assert main([*words, *SHORT, "--json", name]) == 2
        assert f"--json: {name} exists: choose another name, or replace it with --overwrite" in capsys.readouterr().err
        assert main([*words, *SHORT, "--json", name, "--overwrite"]) == 0
    with pytest.raises(SystemExit) as stopped:
        main(["run", "--json", "points"])
    assert stopped.value.code == 2
    assert "a file ending in .json is expected, not points; to print, put --json last" in capsys.readouterr().err


def test_a_short_preset_of_ones_own_has_the_prior_of_the_presets(tmp_path):
    """The toolbox's, which makes the filter overconfident at first, has to be asked for."""
    short = tmp_path / "mine.toml"
    short.write_text('name = "mine"\n[[rig.robots]]\n[[rig.sensors]]\n')
    assert Preset.load(short).options.inverse_distance == preset("points").options.inverse_distance == (0.25, 0.25)


def test_the_same_seed_gives_the_same_numbers(capsys):
    found = []
    for _ in range(2):
        main(["run", "points", "--json", *SHORT])
        found.append(json.loads(capsys.readouterr().out))
        del found[-1]["milliseconds_per_frame"]
    assert found[0] == found[1]


def test_options_of_the_filter(tmp_path, capsys):
    words = ["--option", "capacity=11", "--option", "inverse_distance=[0.2, 0.2]", "--option", "convert=false"]
    path = tmp_path / "run.npz"
    assert main(["run", "points", *words, "--save", str(path), *SHORT]) == 0
    options = Run.load(path).preset.options
    assert (options.capacity, options.inverse_distance, options.convert) == (11, (0.2, 0.2), False)
    assert "11 in the map" in capsys.readouterr().out


def test_calibrate_puts_the_second_extrinsics_into_the_map(tmp_path):
    path = tmp_path / "run.npz"
    assert main(["run", "stereo", "--calibrate", "--save", str(path), *SHORT]) == 0
    assert [s.block is not None for s in Run.load(path).slam.sensors] == [False, True]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["run", "pints"], "did you mean 'points'?"),
        (["run"], "which preset?"),
        (["run", "absent.toml"], "cannot be read"),
        (["run", "points", "--landmark", "ahmPt"], "did you mean 'ahmPnt'?"),
        (["run", "points", "--landmark", "plkLin"], "has no lines"),
        (["run", "points", "--calibrate"], "this rig has one sensor"),
        (["run", "points", "--option", "gat=0.9"], "did you mean 'gate'?"),
        (["run", "points", "--option", "gate"], "NAME=VALUE"),
        (["run", "points", "--option", "gate=2"], "gate should be"),
        (["run", "--resume", "absent.npz"], "no such file"),
        (["run", "--resume", "absent.npz", "--seed", "3"], "leave --seed out"),
        (["run", "points", "--resume", "absent.npz"], "leave the preset's name out"),
    ],
)
def test_mistakes_are_named(words, message, capsys):
    assert main(words) == 2
    found = capsys.readouterr()
    assert message in found.err
    assert found.err.startswith("slamlib: ")
    assert not found.out


@pytest.mark.parametrize("words", [["--help"], ["run", "--help"], ["compare", "--help"], ["list", "--help"]])
def test_help(words, capsys):
    with pytest.raises(SystemExit) as stop:
        main(words)
    assert stop.value.code == 0
    assert "usage: slamlib" in capsys.readouterr().out


@pytest.mark.parametrize(
    "words", [[], ["walk"], ["run", "points", "--frames", "0"], ["run", "points", "--frames", "x"]]
)
def test_usage_errors(words):
    with pytest.raises(SystemExit) as stop:
        main(words)
    assert stop.value.code == 2


def test_list_shows_everything(capsys):
    assert main(["list"]) == 0
    text = capsys.readouterr().out
    for name in ("two_robots", "fhmPnt", "aplLin", "omniCam", "constVel", "thickCloister"):
        assert name in text
    assert main(["list", "options"]) == 0
    assert "gate = 0.99" in capsys.readouterr().out


def test_compare_on_the_same_runs(capsys, tmp_path):
    words = ["compare", "ahmPnt", "idpPnt", "--runs", "2", "--json", "--folder", str(tmp_path), *SHORT]
    assert main(words) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [r["landmark"] for r in rows] == ["ahmPnt", "idpPnt"]
    assert rows[0]["position_error_rms"] == pytest.approx(rows[1]["position_error_rms"], rel=0.1)
    assert len(list(tmp_path.glob("*.npz"))) == 4
    assert main(words[:-4] + words[-4:]) == 0  # again, from the files
    assert json.loads(capsys.readouterr().out) == rows
    assert main(["compare", "plkLin", "--runs", "1", *SHORT]) == 0
    text = capsys.readouterr().out
    assert "95 % band" in text
    assert "NEES, invariant error: median" in text


def test_a_vague_start_is_told_by_both_nees_with_their_names(capsys, tmp_path):
    robot = replace(points().rig.robots[0], orientation_std=(20.0,) * 3)
    replace(points(), rig=replace(points().rig, robots=(robot,))).save(tmp_path / "vague.json")
    assert main(["run", str(tmp_path / "vague.json"), "--frames", "20", "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["robots"]
    result = run(Preset.load(tmp_path / "vague.json"), frames=20)
    assert (found["nees"], found["nees_invariant"]) == (result.nees[-1, 0], result.nees_invariant[-1, 0])
    assert found["nees_invariant"] != pytest.approx(found["nees"], rel=0.05)
    assert main(["compare", "idpPnt", "--preset", str(tmp_path / "vague.json"), "--runs", "2", "--json", *SHORT]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row["nees_invariant_last"] != pytest.approx(row["nees_last"], rel=0.01)
    assert row["nees_invariant_median"] != pytest.approx(row["nees_median"], rel=0.01)


def test_presets_have_a_table_each(capsys):
    assert main(["compare", "ahmPnt", "plkLin", "idpPnt", "--runs", "1", "--frames", "3"]) == 0
    points, lines = capsys.readouterr().out.split("\n\n")
    assert points.startswith("Preset points: 1 runs of 3 frames")
    assert [line.split()[0] for line in points.splitlines()[-2:]] == ["ahmPnt", "idpPnt"]
    assert lines.startswith("Preset lines:")
    assert "plkLin" in lines


def test_filters_are_compared_by_their_errors(capsys):
    words = ["compare", "hmgPnt", "eucPnt", "--runs", "1", "--frames", "3", "--errors", "local", "world"]
    assert main(words) == 0
    rows = [line.split()[:2] for line in capsys.readouterr().out.splitlines()[-4:]]
    assert rows == [["hmgPnt", "local"], ["hmgPnt", "world"], ["eucPnt", "local"], ["eucPnt", "world"]]
    assert main([*words, "--json"]) == 0
    assert [row["error"] for row in json.loads(capsys.readouterr().out)] == ["local", "world"] * 2


def test_the_estimated_extrinsics_are_in_the_table(capsys):
    assert main(["run", "stereo", "--calibrate", "--frames", "20", "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["extrinsics"]
    assert found["name"] == "right"
    assert 0 < found["position_error"] < 4 * found["position_sigma"] < 0.08
    assert 0 < found["attitude_error"] < 4 * found["attitude_sigma"] < 2
    assert main(["run", "stereo", "--calibrate", "--frames", "20"]) == 0
    text = capsys.readouterr().out
    assert "right: extrinsics error" in text
    assert f"(sigma {100 * found['position_sigma']:.1f} cm)" in text
    rows = [" ".join(row.split()) for row in text.splitlines() if "extrinsics NEES" in row]
    nees = {"linear": found["nees"], "invariant": found["nees_invariant"]}
    assert rows == [f"right: extrinsics NEES, 6 dof, {e} error {x:.2f}, at frame 20" for e, x in nees.items()]
    assert 0.2 < found["nees"] < 30
    assert text.count("at frame 20") == 6
    assert main(["run", "stereo", "--frames", "5", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["extrinsics"] == []


def test_an_interrupted_run_goes_on(tmp_path, monkeypatch, capsys):
    whole = Run.load(_saved(tmp_path, "whole", ["run", "points", *SHORT])).result()

    monkeypatch.setattr(runner, "progress", interrupted_at(5))
    path = tmp_path / "cut.npz"
    assert main(["run", "points", "--save", str(path), *SHORT]) == 130
    assert f"slamlib run --resume {path}" in capsys.readouterr().err
    monkeypatch.undo()
    assert main(["run", "--resume", str(path), "--save", str(path)]) == 0
    cut = Run.load(path).result()
    for name in ("errors", "nees", "nis", "landmarks"):
        assert np.array_equal(getattr(whole, name), getattr(cut, name), equal_nan=True)
    assert np.array_equal(whole.map_errors["points"], cut.map_errors["points"], equal_nan=True)


def _saved(folder, name, words):
    path = folder / f"{name}.npz"
    assert main([*words, "--save", str(path)]) == 0
    return path


def test_a_film_that_cannot_be_written_is_said_before_the_run(tmp_path, capsys, monkeypatch):
    pytest.importorskip("matplotlib", reason="films need matplotlib")
    monkeypatch.setattr("slamlib.slam.filter.Slam.step", None)  # no frame may be run
    (tmp_path / "there.gif").touch()
    for name, message in (("there.gif", "replace it"), ("film.avi", "ending of a video")):
        assert main(["run", "points", "--video", str(tmp_path / name), *SHORT]) == 2
        assert message in capsys.readouterr().err


def test_a_film_as_numbered_pictures(tmp_path):
    pytest.importorskip("matplotlib", reason="films need matplotlib")
    assert main(["run", "points", "--video", str(tmp_path / "film"), "--frames", "2"]) == 0
    assert sorted(f.name for f in (tmp_path / "film").iterdir()) == ["0001.png", "0002.png"]


def test_python_m_slamlib():
    call = [sys.executable, "-m", "slamlib", "list", "sensors"]
    assert "pinHole" in subprocess.run(call, capture_output=True, text=True, check=True).stdout


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize(("said", "used"), [({}, "1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3")])
@pytest.mark.parametrize("module", ["slamlib.cli", "slambook.trees"])
def test_commands_load_numpy_with_one_thread_of_blas_unless_told_otherwise(module, said, used):
    watch = f"""
import os, sys
class Watch:
    def find_spec(self, name, *of):
        if name == "numpy": print(os.environ.get("OPENBLAS_NUM_THREADS"))
sys.meta_path.insert(0, Watch())
import {module}
"""
    known = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"} | said
    call = [sys.executable, "-c", watch]
    assert subprocess.run(call, capture_output=True, text=True, check=True, env=known).stdout.split() == [used]


def test_progress_draws_on_terminals_only():
    quiet, seen = io.StringIO(), Terminal()
    assert list(progress(iter(range(3)), 3, "work", quiet)) == [0, 1, 2]
    assert quiet.getvalue() == ""
    assert list(progress(iter(range(3)), 3, "work", seen)) == [0, 1, 2]
    assert seen.getvalue().endswith("\n")
    assert "3/3" in seen.getvalue()
    assert list(progress([], 0, "nothing", seen)) == []
