"""`slamlib run images`: on pictures of a rendered room in every layout, what it refuses, and that nothing is lost."""

import json
import os
import re
import shutil

import numpy as np
import pytest
from slambook import rendering

from slamlib.cli import main, runner
from slamlib.evaluation.trajectory import Trajectory, read_trajectory, write_tum
from slamlib.tests.interruptions import interrupted_at
from slamlib.tests.pictures import DATA, windows
from slamlib.vision.opening import load

cv2 = pytest.importorskip("cv2", reason="OpenCV reads and writes the pictures")
COUNT, DT = 24, 1 / 30


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A folder with left/0.png, ..., calibration.json and truth.txt of a rendered room."""
    folder = tmp_path_factory.mktemp("room")
    path = rendering.path("sideways")
    rig = rendering.rig_along_path(path)
    film = rendering.film(rendering.default_room("drawn"), rig, path, frames=COUNT, dt=DT, rng=np.random.default_rng(1))
    (folder / "left").mkdir()
    poses = []
    for i, (frame, truth) in enumerate(film):
        cv2.imwrite(str(folder / "left" / f"{i}.png"), frame.scans[0].image)
        poses.append(truth.poses[0])
    (folder / "calibration.json").write_text(json.dumps(rig.to_dict()))
    truth = Trajectory(DT * np.arange(COUNT), np.array(poses)).sensor_trajectory(rig.sensors[0].extrinsics)
    write_tum(folder / "truth.txt", truth)
    return folder


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """Runs that are saved without a name go to the present folder."""
    monkeypatch.chdir(tmp_path)


def words(room, *more):
    return ["run", "images", "--source", str(room / "left"), "--calibration", str(room / "calibration.json"), *more]


def found(capsys):
    return json.loads(capsys.readouterr().out)


def test_a_folder_with_its_table_and_trajectory(room, tmp_path, capsys):
    out = tmp_path / "path.txt"
    assert main(words(room, "--trajectory", str(out), "--reference", str(room / "truth.txt"))) == 0
    text = capsys.readouterr().out
    for what in (
        "(folder)",
        "24, 0.77 s",
        "tracked features",
        "NIS per degree",
        "milliseconds per frame",
        "rotation from the",
    ):
        assert what in text
    path = read_trajectory(out)
    assert len(path) == COUNT
    assert (np.linalg.eigvalsh(path.covariances[1:]) > 0).all()
    out.unlink()  # its covariances are not replaced unasked
    assert main(words(room, "--trajectory", str(out))) == 2
    assert "path.txt.cov exists: choose another name" in capsys.readouterr().err


def test_json_and_the_same_seed(room, capsys):
    twice = []
    for _ in range(2):
        assert main(words(room, "--json", "--seed", "3", "--reference", str(room / "truth.txt"))) == 0
        twice.append(found(capsys))
        del twice[-1]["milliseconds"]
    assert twice[0] == twice[1]
    s = twice[0]
    assert (s["frames"], s["frames_without_match"], s["stopped"]) == (COUNT, 0, None)
    assert s["matched_share"] > 0.5
    assert s["reference"]["poses"] == COUNT


def test_a_reference_of_other_times_does_not_hide_the_run(room, tmp_path, capsys):
    write_tum(tmp_path / "late.txt", Trajectory([1e9, 1e9 + 1], np.tile([0.0, 0, 0, 1, 0, 0, 0], (2, 1))))
    assert main(words(room, "--frames", "3", "--reference", str(tmp_path / "late.txt"), "--json")) == 2
    told = capsys.readouterr()
    assert "only 0 of 3 poses have one of the reference's 2 within" in told.err
    assert json.loads(told.out)["frames"] == 3


def test_choices_reach_the_run(room, tmp_path):
    given = [
        "--start",
        "2",
        "--every",
        "3",
        "--frames",
        "5",
        "--updates",
        "9",
        "--outlier-rejection",
        "joint",
        "--landmark",
        "idpPnt",
    ]
    given += [
        "--option",
        "max_new_first=7",
        "--option",
        "inverse_distance=0.8,0.4",
        "--search",
        "patch=9",
        "--noise",
        "0.3",
        "--impulse",
        "0.2",
        "5",
        "--velocity",
        "1",
        "7",
    ]
    path = tmp_path / "run.npz"
    assert main(words(room, *given, "--patience", "4", "--fps", "15", "--save", str(path))) == 0
    run = load(path)
    assert (list(run.source.frames), run.source.interval, run.patience) == ([2, 5, 8, 11, 14], 1 / 15, 4)
    options, rig = run.slam.options, run.slam.rig
    assert (options.updates, options.outlier_rejection, options.points, options.max_new_first) == (
        9,
        "joint",
        "idpPnt",
        7,
    )
    assert options.inverse_distance == (0.8, 0.4)
    assert run.slam.front_ends[0].settings.patch == 9
    assert rig.sensors[0].std == (0.3,)
    assert rig.robots[0].control_std == (0.2, 0.2, 0.2, 5.0, 5.0, 5.0)
    assert rig.robots[0].velocity_std == (1.0, 1.0, 1.0, 7.0, 7.0, 7.0)


def test_a_glob_a_video_and_the_public_layouts(room, tmp_path, capsys):
    images = [cv2.imread(str(room / "left" / f"{i}.png")) for i in range(6)]
    tum, euroc, kitti = (tmp_path / name for name in ("tum", "euroc", "kitti"))
    for folder in (tum / "rgb", euroc / "mav0" / "cam0" / "data", kitti / "image_0"):
        folder.mkdir(parents=True)
        for i in range(6):
            shutil.copy(room / "left" / f"{i}.png", folder / f"{i}.png")
    times = [100 + DT * i for i in range(6)]
    (tum / "rgb.txt").write_text("".join(f"{t:.6f} rgb/{i}.png\n" for i, t in enumerate(times)))
    rows = "".join(f"{int(1e9 * t)},{i}.png\n" for i, t in enumerate(times))
    (euroc / "mav0" / "cam0" / "data.csv").write_text("#timestamp [ns],filename\n" + rows)
    (kitti / "times.txt").write_text("".join(f"{t:.6e}\n" for t in times))
    film = cv2.VideoWriter(str(tmp_path / "film.avi"), cv2.VideoWriter_fourcc(*"MJPG"), 30, (320, 240))
    for image in images:
        film.write(image)
    film.release()
    layouts = {str(tum): "TUM RGB-D", str(euroc): "EuRoC", str(kitti): "KITTI", str(tmp_path / "film.avi"): "video"}
    for source, layout in {**layouts, str(room / "left" / "[0-5].png"): "glob"}.items():
        call = ["run", "images", "--source", source, "--calibration", str(room / "calibration.json"), "--json"]
        assert main(call) == 0
        s = found(capsys)
        assert (s["layout"], s["frames"]) == (layout, 6)
        assert s["matched_share"] > 0.5


def test_an_interrupted_run_goes_on_as_if_it_had_not_been(room, tmp_path, capsys, monkeypatch):
    whole, cut = tmp_path / "whole.npz", tmp_path / "cut.npz"
    assert main(words(room, "--save", str(whole))) == 0
    monkeypatch.setattr(runner, "progress", interrupted_at(9))
    assert main(words(room, "--save", str(cut), "--trajectory", str(tmp_path / "t.txt"))) == 130
    assert f"slamlib run images --resume {cut}" in capsys.readouterr().err
    assert len(read_trajectory(tmp_path / "t.txt")) == 10
    monkeypatch.undo()
    os.chdir(tmp_path)
    assert main(["run", "images", "--resume", str(cut), "--save", str(cut), "--json"]) == 0
    assert found(capsys)["frames"] == COUNT
    one, two = load(whole), load(cut)
    assert np.array_equal(one.trajectory().poses, two.trajectory().poses)
    assert np.array_equal(one.slam.belief.matrix, two.slam.belief.matrix)


def test_lines_beside_points_also_after_a_resume(room, tmp_path, capsys):
    whole, half = tmp_path / "whole.npz", tmp_path / "half.npz"
    assert main(words(room, "--lines", "idpLin", "--frames", "8", "--save", str(whole))) == 0
    assert main(words(room, "--lines", "idpLin", "--frames", "4", "--save", str(half))) == 0
    assert main(["run", "images", "--resume", str(half), "--frames", "8", "--save", str(half)]) == 0
    runs = [load(path).slam for path in (whole, half)]
    kinds = [[landmark.kind.name for landmark in slam.landmarks] for slam in runs]
    assert "idpLin" in kinds[0]
    assert kinds[0] == kinds[1]
    np.testing.assert_array_equal(runs[0].belief.matrix, runs[1].belief.matrix)
    capsys.readouterr()


def test_more_frames_after_a_resume(room, tmp_path, capsys):
    path = str(tmp_path / "run.npz")
    assert main(words(room, "--frames", "5", "--start", "1", "--save", path)) == 0
    capsys.readouterr()
    assert main(["run", "images", "--resume", path, "--frames", "8", "--json"]) == 0
    assert found(capsys)["frames"] == 8


def test_a_run_goes_on_where_its_pictures_are_now(room, tmp_path, capsys):
    shutil.copytree(room / "left", tmp_path / "first")
    call = ["run", "images", "--source", "first", "--calibration", str(room / "calibration.json")]
    assert main([*call, "--frames", "5", "--save", "run.npz"]) == 0
    (tmp_path / "first").rename(tmp_path / "second")
    capsys.readouterr()
    assert main(["run", "images", "--resume", "run.npz", "--frames", "3"]) == 2
    assert "5 pictures are done already, --frames 3 is fewer" in capsys.readouterr().err
    assert main(["run", "images", "--resume", "run.npz"]) == 2
    assert "there is nothing" in capsys.readouterr().err
    assert main(["run", "images", "--resume", "run.npz", "--source", "second", "--frames", "8", "--json"]) == 0
    told = capsys.readouterr()
    assert (json.loads(told.out)["frames"], json.loads(told.out)["source"]) == (8, str(tmp_path / "second"))
    assert "slamlib:" not in told.err
    cv2.imwrite(str(tmp_path / "second" / "4.png"), np.zeros((240, 320), np.uint8))
    assert main(["run", "images", "--resume", "run.npz", "--source", "second", "--frames", "8"]) == 2
    assert "with other pixels" in capsys.readouterr().err


def test_a_run_whose_times_have_changed_does_not_go_on(room, tmp_path, capsys):
    shutil.copytree(room / "left", tmp_path / "rgb")
    for interval in (0.04, 0.05):
        (tmp_path / "rgb.txt").write_text("".join(f"{9 + interval * i:.3f} rgb/{i}.png\n" for i in range(COUNT)))
        if interval == 0.04:
            call = ["run", "images", "--source", ".", "--calibration", str(room / "calibration.json")]
            assert main([*call, "--frames", "5", "--save", "run.npz"]) == 0
    assert main(["run", "images", "--resume", "run.npz", "--frames", "6"]) == 2
    assert "4.png was of 9.160000 s, and is of 9.200000 s now" in capsys.readouterr().err


@pytest.mark.parametrize("form", ["--{}=~/{}", "--{} ~/{}"])
def test_the_folder_of_the_owner_in_quotes_and_after_an_equals_sign(room, tmp_path, monkeypatch, form):
    home = tmp_path / "home"
    shutil.copytree(room / "left", home / "left")
    shutil.copy(room / "calibration.json", home)
    shutil.copy(room / "truth.txt", home)
    for variable in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(variable, str(home))
    files = {"source": "left", "calibration": "calibration.json", "reference": "truth.txt", "save": "new/run.npz"}
    files |= {"trajectory": "new/path.txt", "json": "new/found.json", "map": "new/map.csv"}
    given = [word for name, file in files.items() for word in form.format(name, file).split(" ")]
    assert main(["run", "images", *given, "--frames", "3"]) == 0
    assert {f.name for f in (home / "new").iterdir()} >= {
        "run.npz",
        "path.txt",
        "path.txt.cov",
        "found.json",
        "map.csv",
    }
    assert [f.name for f in tmp_path.iterdir()] == ["home"]


def test_what_was_guessed_of_the_times_is_said_once(room, tmp_path, capsys):
    for i in range(4):
        (tmp_path / "film").mkdir(exist_ok=True)
        shutil.copy(room / "left" / f"{i}.png", tmp_path / "film" / f"{1700000000 + i / 30:.3f}.png")
    call = ["run", "images", "--source", "film", "--calibration", str(room / "calibration.json")]
    assert main([*call, "--calibration-std", "intrinsics=1"]) == 0
    assert capsys.readouterr().err.count("taken for their times in seconds: a picture every 0.033 s\n") == 1
    (tmp_path / "times.txt").write_text("0\n50\n100\n150\n")
    assert main([*call, "--times", "times.txt", "--json"]) == 0
    told = capsys.readouterr()
    assert "times.txt: its times are taken for milliseconds, not seconds: a picture every 0.05 s" in told.err
    assert json.loads(told.out)["seconds"] == pytest.approx(0.15)
    (tmp_path / "times.txt").write_text("0\n1\n")
    assert main([*call, "--times", "times.txt"]) == 2
    assert "has 2 times, and there are 4 pictures" in capsys.readouterr().err


def test_a_picture_that_cannot_be_read_stops_the_run_and_nothing_is_lost(room, tmp_path, capsys):
    shutil.copytree(room / "left", tmp_path / "left")
    (tmp_path / "left" / "7.png").write_bytes((room / "left" / "7.png").read_bytes()[:500])
    call = ["run", "images", "--source", str(tmp_path / "left"), "--calibration", str(room / "calibration.json")]
    assert main([*call, "--json"]) == 2
    told = capsys.readouterr()
    s = json.loads(told.out)
    assert s["frames"] == 7
    assert "7.png is truncated" in s["stopped"]
    assert "saved after 7 pictures" in told.err
    shutil.copy(room / "left" / "7.png", tmp_path / "left" / "7.png")
    assert main(["run", "images", "--resume", "slamlib-images.npz", "--json"]) == 0
    assert found(capsys)["frames"] == COUNT


def test_a_cut_is_warned_of_once_and_stops_the_run(room, tmp_path, capsys):
    shutil.copytree(room / "left", tmp_path / "left")
    for i in range(10, COUNT):
        cv2.imwrite(str(tmp_path / "left" / f"{i}.png"), np.zeros((240, 320), np.uint8))
    call = ["run", "images", "--source", str(tmp_path / "left"), "--calibration", str(room / "calibration.json")]
    assert main([*call, "--patience", "5", "--json"]) == 2
    told = capsys.readouterr()
    s = json.loads(told.out)
    assert (s["frames"], s["frames_without_match"]) == (15, 5)
    assert "more patience" in s["stopped"]
    assert told.err.count("no match in 10.png") == 1
    assert main(["run", "images", "--resume", "slamlib-images.npz", "--patience", "50", "--json"]) == 0
    assert found(capsys)["frames"] == COUNT


def test_a_run_against_which_its_own_pictures_speak_is_named(room, capsys, monkeypatch):
    assert main(words(room, "--frames", "8")) == 0
    assert not any(word in capsys.readouterr().err for word in ("reversed", "calibration"))
    monkeypatch.setattr("slamlib.cli.images.JUDGED", 8)
    monkeypatch.setattr("slamlib.cli.images.ENOUGH", 1.01)
    monkeypatch.setattr(
        "slamlib.cli.images.direction_error", lambda source, calibration, path: (143.2, 0, len(path) - 1)
    )
    assert main(words(room, "--frames", "8", "--json")) == 0
    told = capsys.readouterr().err
    assert "or the calibration is of another camera" in told
    assert "may be reversed" in told
    assert "from picture 0 to 7 it goes 143 degrees off" in told


def test_a_camera_that_turns_fast_in_its_first_picture_is_not_lost(tmp_path, capsys):
    times, start = np.linspace(0, 1, 11), np.array([0, 0, 1.3, 0, 0, 0])
    path = rendering.CameraPath(times, start + np.outer(times, [0, 0.1, 0, 0, 0, 1.8]))
    rig = rendering.rig_along_path(path)
    film = rendering.film(rendering.default_room("drawn"), rig, path, frames=12, dt=DT, rng=np.random.default_rng(1))
    (tmp_path / "left").mkdir()
    for i, (frame, _) in enumerate(film):
        cv2.imwrite(str(tmp_path / "left" / f"{i:02}.png"), frame.scans[0].image)
    (tmp_path / "calibration.json").write_text(json.dumps(rig.to_dict()))
    assert main(words(tmp_path, "--json")) == 0
    told = capsys.readouterr()
    rate = float(re.search(r"turns by (\d+) deg/s", told.err)[1])
    assert rate == pytest.approx(np.degrees(1.8), rel=0.15)
    assert json.loads(told.out)["tracked_least"] >= 10


def test_a_lens_with_tangential_distortion_goes_into_the_filter(room, tmp_path, capsys):
    (tmp_path / "calib.txt").write_text("260 260 159.5 119.5 -0.01 0.001 0.0005 0.0002")
    call = ["run", "images", "--source", str(room / "left"), "--calibration", str(tmp_path / "calib.txt")]
    assert main([*call, "--frames", "6", "--save", "own.npz", "--json"]) == 0
    assert found(capsys)["matched_share"] > 0.5
    (camera,) = load("own.npz", frames=10).slam.rig.sensors
    assert (camera.type, len(camera.parameters["distortion"])) == ("brownConrady", 4)


def test_undistortion(room, tmp_path, capsys):
    text = "1 FOV 320 240 260 260 160 120 0.3\n"
    (tmp_path / "calib.txt").write_text(text)
    call = [
        "run",
        "images",
        "--source",
        str(room / "left"),
        "--calibration",
        str(tmp_path / "calib.txt"),
        "--frames",
        "6",
    ]
    assert main(call) == 2
    assert "--undistort" in capsys.readouterr().err
    assert main([*call, "--undistort", "--save", "run.npz", "--json"]) == 0
    assert found(capsys)["matched_share"] > 0.5
    run = load("run.npz", frames=10)
    assert run.slam.rig.sensors[0].parameters["distortion"] == (0.0,)
    assert len(list(run)) == 4  # undistorted again
    assert run.result().matched[-1] > 3


def test_a_target(room, tmp_path, capsys):
    path = rendering.path("sideways")
    rig = rendering.rig_along_path(path)
    film = rendering.film(rendering.default_room("drawn"), rig, path, frames=1, dt=DT, rng=np.random.default_rng(1))
    ((_, truth),) = film
    pixels = np.array([[60, 60], [250, 70], [240, 180], [80, 170], [160, 100], [120, 200.0]])
    points = film.truth_of(truth, pixels)
    assert np.isfinite(points).all()
    (tmp_path / "target.json").write_text(
        json.dumps({"points": points.tolist(), "pixels": pixels.tolist(), "std": 0.002})
    )
    call = words(room, "--scale", str(tmp_path / "target.json"), "--reference", str(room / "truth.txt"), "--json")
    assert main(call) == 0
    s = found(capsys)
    assert s["reference"]["scale"] == 1.0
    assert s["reference"]["ate"] < 0.03  # metres, at two metres' distance


def test_a_film(room, tmp_path):
    pytest.importorskip("matplotlib", reason="films need matplotlib")
    assert main(words(room, "--frames", "2", "--video", str(tmp_path / "film"))) == 0
    assert sorted(f.name for f in (tmp_path / "film").iterdir()) == ["0001.png", "0002.png"]
    assert main(words(room, "--frames", "2", "--video", str(tmp_path / "film"))) == 2  # it is there already


def test_a_film_that_fails_does_not_lose_the_run(room, tmp_path, capsys, monkeypatch):
    pytest.importorskip("matplotlib", reason="films need matplotlib")
    monkeypatch.setattr("slambook.scene.window.Window.pixels", lambda window: 1 / 0)
    assert main(words(room, "--frames", "6", "--video", "film.gif", "--json")) == 2
    told = capsys.readouterr()
    assert "the video cannot be written: division by zero" in json.loads(told.out)["stopped"]
    assert "saved after" in told.err
    assert sorted(f.name for f in tmp_path.iterdir()) == ["slamlib-images.npz"]
    (tmp_path / "left").mkdir()
    (tmp_path / "left" / "0.png").write_bytes((room / "left" / "0.png").read_bytes())
    call = ["run", "images", "--source", str(tmp_path / "left"), "--calibration", str(room / "calibration.json")]
    monkeypatch.setattr("slamlib.vision.sequence_run.SequenceRun._frame", lambda run, picture: run.source.part(9))
    assert main([*call, "--video", "film.gif"]) == 2
    assert "none is left from number 9" in capsys.readouterr().err


def test_a_window_that_cannot_be_opened_is_said_before_the_run(room, capsys, monkeypatch):
    plot = pytest.importorskip("matplotlib.pyplot", reason="windows need matplotlib")
    plot.switch_backend("agg")
    monkeypatch.setattr("slamlib.slam.filter.Slam.step", None)  # no frame may be run
    assert main(words(room, "--live")) == 2
    assert "opens no window" in capsys.readouterr().err


def test_a_window_shows_every_frame(room, monkeypatch):
    shown = windows(monkeypatch)
    assert main(words(room, "--frames", "3", "--live")) == 0
    assert [s.number for s in shown] == [1, 2, 3]


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ([], "--source and --calibration are needed"),
        (["--source", "nowhere", "--calibration", "fr3"], "there is nothing"),
        (["--source", "{room}/left", "--calibration", "nowhere"], "need no file"),
        (["--source", "{room}/left", "--calibration", "fr3"], "of pictures of 640x480 pixels, and those of"),
        (["--source", "{room}/left", "--calibration", "{room}/truth.txt"], "no calibration that slamlib knows"),
        (["--motion", "constant"], "did you mean 'constant-velocity'?"),
        (["--landmark", "plkLin"], "for lines there is --lines"),
        (["--lines", "idpPnt"], "unknown Options.lines 'idpPnt'"),
        (["--option", "gat=1"], "unknown key of option 'gat'; did you mean 'gate'?"),
        (["--option", "inverse_distance=1,a"], "inverse_distance should be 2 values"),
        (["--search", "patsch=1"], "unknown key of search 'patsch'; did you mean 'patch'?"),
        (["--search", "patch"], "--search takes NAME=VALUE"),
        (["--start", "24"], "none is left"),
        (["--scale", "nowhere.json"], "nowhere.json cannot be read"),
        (["--camera", "1"], "no camera 1; it has 0"),
        (["--video", "film.avi"], "ending of a video"),
        (["--resume", "nowhere.npz"], "leave --calibration out"),
        (["--trajectory", "{room}/calibration.json/t.txt"], "cannot be written"),
        (["--save", "."], "it is a folder"),
        (["--reference", "nowhere.txt"], "cannot be read"),
    ],
)
def test_mistakes_are_named(room, more, message, capsys):
    given = [word.format(room=room) for word in more]
    complete = words(room, *given) if given and given[0] != "--source" else ["run", "images", *given]
    assert main(complete) == 2
    told = capsys.readouterr()
    assert message in told.err
    assert told.err.startswith("slamlib: ")
    assert not told.out


def test_help_and_resuming_what_is_not_there(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["run", "images", "--help"])
    assert stop.value.code == 0
    assert "usage: slamlib run images" in capsys.readouterr().out
    assert main(["run", "images", "--resume", "nowhere.npz"]) == 2
    assert "no such file" in capsys.readouterr().err
    assert main(["run", "points", "--frames", "2", "--save", "points.npz"]) == 0
    assert main(["run", "images", "--resume", "points.npz"]) == 2
    assert "holds no run on pictures" in capsys.readouterr().err


def test_a_real_sequence(capsys):
    there = DATA / "mono_visp_cube"
    if not there.is_dir():
        pytest.skip("the excerpt mono_visp_cube is not at hand")
    call = [
        "run",
        "images",
        "--source",
        str(there / "frames"),
        "--calibration",
        str(there / "calib.txt"),
        "--fps",
        "25",
    ]
    assert main([*call, "--frames", "25", "--json"]) == 0
    s = found(capsys)
    assert s["frames_without_match"] == 0
    assert s["matched_share"] > 0.7


def test_the_scale_of_a_real_sequence_is_that_of_its_dots(tmp_path, capsys):
    there = DATA / "mono_visp_cube"
    if not there.is_dir():
        pytest.skip("the excerpt mono_visp_cube is not at hand")
    dots = next(line.split()[1:] for line in (there / "dots_px.txt").read_text().splitlines() if line[0] == "0")
    rim = [(x, y, 0) for y in range(4) for x in range(4) if {x, y} & {0, 3}]
    target = {"points": rim, "pixels": np.array(dots, float).reshape(-1, 2).tolist()}
    (tmp_path / "dots.json").write_text(json.dumps(target))
    files = ["--calibration", str(there / "calib.txt"), "--scale", str(tmp_path / "dots.json")]
    assert main(["run", "images", "--source", str(there / "frames"), "--fps", "25", *files, "--json"]) == 0
    assert found(capsys)["path_length"] == pytest.approx(21.48, rel=0.05)  # spacings, by structure from motion
