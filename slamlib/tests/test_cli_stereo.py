"""`slamlib run stereo-images`: rendered pairs in every layout, what it refuses, and that nothing is lost."""

import json
import os
import shutil

import numpy as np
import pytest
from slambook import kitti_street, rendering

from slamlib.cli import main, runner
from slamlib.datasets.times import table
from slamlib.evaluation.comparison import evaluate, lengths_of
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.evaluation.trajectory import read_trajectory
from slamlib.geometry.pose import relative
from slamlib.geometry.quaternion import rotation
from slamlib.tests.interruptions import interrupted_at
from slamlib.tests.pictures import windows
from slamlib.vision.opening import PAIRS
from slamlib.vision.opening import load as load_kind

cv2 = pytest.importorskip("cv2", reason="OpenCV reads, rectifies and searches the pictures")
COUNT, DT, BASELINE = 12, 1 / 15, 0.12
LENS = {"intrinsics": (79.5, 59.5, 130.0, 130.0), "distortion": (0.0,)}
QUICK = ["--option", "updates=40", "--option", "max_new_first=40", "--option", "max_new=10"]


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A stereo room in KITTI's layout: image_0, image_1, calibration.json, times.txt, groundtruth_0.txt."""
    folder = tmp_path_factory.mktemp("room") / "kitti"
    arguments = rendering.path("sideways")
    rig = rendering.rig_along_path(arguments, baseline=BASELINE, image=(160.0, 120.0), parameters=LENS)
    film = rendering.film(rendering.default_room(), rig, arguments, frames=COUNT, dt=DT, rng=np.random.default_rng(1))
    return rendering.save_film(folder, film)


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """Runs that are saved without a name go to the present folder."""
    monkeypatch.chdir(tmp_path)


def words(room, *more):
    return ["run", "stereo-images", "--source", str(room), *QUICK, *more]


def beside(room, *more):
    """The same by a left and a right folder."""
    sides = ["--left", str(room / "image_0"), "--right", str(room / "image_1")]
    return ["run", "stereo-images", *sides, *QUICK, *more]


def plain(folder, **more):
    """A plain calibration file of the room."""
    path = folder / "pair.json"
    path.write_text(json.dumps({"intrinsics": LENS["intrinsics"], "baseline": BASELINE, **more}))
    return str(path)


def load(path):
    return load_kind(path, PAIRS)


def from_start(path):
    """The poses in the frame of the first one."""
    return relative(path.poses[0], path.poses)


def found(capsys):
    return json.loads(capsys.readouterr().out)


def copied(room, folder, count=COUNT):
    """The first pairs of the room in `folder`/left and `folder`/right."""
    for side, camera in (("left", "image_0"), ("right", "image_1")):
        (folder / side).mkdir(parents=True)
        for path in sorted((room / camera).iterdir())[:count]:
            shutil.copy(path, folder / side / path.name)
    return folder


def test_the_layout_of_kitti_with_its_table_and_trajectory(room, tmp_path, capsys):
    out = tmp_path / "path.txt"
    assert main(words(room, "--trajectory", str(out), "--reference", str(room / "groundtruth_0.txt"))) == 0
    text = capsys.readouterr().out
    for what in ("(KITTI)", f"{COUNT}, 0.73 s", "tracked features", "odometry", "scale 1,", "(KITTI's metric)"):
        assert what in text
    path, truth = read_trajectory(out), read_trajectory(room / "groundtruth_0.txt")
    assert len(path) == COUNT
    error = from_start(path)[-1, :3] - from_start(truth)[-1, :3]
    assert np.linalg.norm(error) < 0.01 * truth.distances[-1] + 0.002


def test_nees_is_of_the_error_whose_covariance_the_filter_keeps_with_the_linear_one_beside(room, tmp_path, capsys):
    out, truth = tmp_path / "path.txt", str(room / "groundtruth_0.txt")
    for option, kept in (([], "invariant"), (["--option", "error=local"], "linear")):
        given = words(room, *option, "--reference", truth, "--trajectory", str(out), "--overwrite", "--json")
        assert main(given) == 0
        told = found(capsys)["reference"]
        judged = {error: evaluate(out, truth, covariance_error=error).summary["nees"] for error in ERRORS}
        assert judged["invariant"]["median"] != pytest.approx(judged["linear"]["median"], rel=1e-4)
        assert told["nees"]["error"] == kept
        assert told["nees"]["median"] == pytest.approx(judged[kept]["median"], rel=1e-5)
        if kept == "linear":
            assert told["nees_linear"] is None
        else:
            assert told["nees_linear"]["error"] == "linear"
            assert told["nees_linear"]["median"] == pytest.approx(judged["linear"]["median"], rel=1e-5)


# All 33 features of these small pictures become landmarks: "correlated" has none left for its odometry, and in the
# worst pair its position depends on 16 landmarks alone, with an error of 17 mm.
@pytest.mark.parametrize(
    ("motion", "share"), [("constant-velocity", 0.02), ("split-features", 0.02), ("correlated", 0.05)]
)
def test_every_motion_and_plain_odometry_follow_the_path(room, motion, share, capsys):
    for arguments, most in ((["--motion", motion], share), (["--odometry-only"], 0.02)):
        assert main(words(room, *arguments, "--json", "--reference", str(room / "groundtruth_0.txt"))) == 0
        s = found(capsys)
        assert (s["frames"], s["frames_without_match"], s["stopped"]) == (COUNT, 0, None)
        assert s["reference"]["scale"] == 1.0
        assert s["reference"]["relative_ate"] < most
        assert s["reference"]["parts"]["counts"][0] > 3
        assert 6 < s["near_mean"] <= s["tracked_mean"]  # in a room of a few metres
    assert s["landmarks"] == 0
    assert s["innovation_correlation"] is None


def test_nothing_is_drawn_two_runs_are_the_same(room, capsys):
    twice = []
    for _ in range(2):
        assert main(words(room, "--json", "--frames", "5")) == 0
        twice.append(found(capsys))
        assert twice[-1].pop("milliseconds").keys() == {"filter", "search", "detection", "reading", "odometry"}
    assert twice[0] == twice[1]


def test_folders_and_globs_with_a_plain_calibration(room, tmp_path, capsys):
    there = ["--calibration", plain(tmp_path, std=0.3), "--fps", "15", "--json", "--frames", "4"]
    assert main(beside(room, *there)) == 0
    folders = found(capsys)
    globs = ["--left", str(room / "image_0" / "*.png"), "--right", str(room / "image_1" / "*.png")]
    assert main(["run", "stereo-images", *globs, *QUICK, *there]) == 0
    s = found(capsys)
    assert (folders["layout"], s["layout"]) == ("folder", "glob")
    assert (s["frames"], s["seconds"], s["matched_share"]) == (4, pytest.approx(0.2), folders["matched_share"])


def euroc(room, folder, missing=()):
    """The room as EuRoC keeps it, seen by two cameras that are turned and distort; times in nanoseconds."""
    for camera in range(2):
        there = folder / "mav0" / f"cam{camera}"
        (there / "data").mkdir(parents=True)
        rows = []
        for i, path in enumerate(sorted((room / f"image_{camera}").iterdir())[:6]):
            name = f"{1403636579763555584 + round(1e9 * DT) * i}.png"
            if (camera, i) not in missing:
                cv2.imwrite(str(there / "data" / name), raw(cv2.imread(str(path), 0), camera))
                rows.append(f"{name[:-4]},{name}")
        (there / "data.csv").write_text("#timestamp [ns],filename\n" + "\n".join(rows) + "\n")
        T = np.eye(4)
        T[:3, :3], T[0, 3] = TURNS[camera], camera * BASELINE
        numbers = ", ".join(f"{n:.12f}" for n in T.ravel())
        (there / "sensor.yaml").write_text(
            f"T_BS:\n  cols: 4\n  rows: 4\n  data: [{numbers}]\nresolution: [160, 120]\ncamera_model: pinhole\n"
            "intrinsics: [130.0, 130.0, 79.5, 59.5]\ndistortion_model: radial-tangential\n"
            f"distortion_coefficients: [{', '.join(map(str, DISTORTION))}]\n"
        )
    return folder


DISTORTION = (-0.05, 0.01, 0.001, -0.001)
TURNS = [cv2.Rodrigues(np.array([0.0, 0.02, 0.01]))[0], cv2.Rodrigues(np.array([0.02, -0.015, -0.02]))[0]]


def raw(image, camera):
    """What a camera with DISTORTION, turned by TURNS, sees of a picture of the room."""
    K = np.array([[130.0, 0, 79.5], [0, 130.0, 59.5], [0, 0, 1]])
    pixels = np.stack(np.meshgrid(np.arange(160.0), np.arange(120.0)), axis=-1).reshape(-1, 1, 2)
    rays = cv2.undistortPoints(pixels, K, np.array(DISTORTION))[:, 0]
    seen = np.column_stack([rays, np.ones(len(rays))]) @ TURNS[camera].T
    places = (130.0 * seen[:, :2] / seen[:, 2:] + [79.5, 59.5]).reshape(120, 160, 2).astype(np.float32)
    return cv2.remap(image, places[..., 0], places[..., 1], cv2.INTER_LINEAR)


def test_the_layout_of_euroc_is_rectified_and_matched_by_time(room, tmp_path, capsys):
    folder = euroc(room, tmp_path / "euroc", missing={(0, 2), (1, 4)})
    assert main(words(folder, "--motion", "correlated", "--json", "--save", "run.npz")) == 0
    s = found(capsys)
    assert (s["layout"], s["frames"]) == ("EuRoC", 4)
    assert s["inlier_share"] > 0.8
    run = load("run.npz")
    sensor = run.slam.rig.sensors[0]
    assert sensor.parameters["baseline"][0] == pytest.approx(BASELINE, abs=1e-9)
    truth = read_trajectory(room / "groundtruth_0.txt")
    moved = from_start(run.trajectory())[-1, :3]
    assert np.linalg.norm(moved) == pytest.approx(np.linalg.norm(from_start(truth)[5, :3]), rel=0.03)
    # The trajectory is of the camera that took the pictures: its baseline is the rectified one's x axis.
    turn = rotation(relative(np.array(run.path[0]), run.trajectory().poses[0])[3:])
    np.testing.assert_allclose(turn @ TURNS[0].T @ [1, 0, 0], [1, 0, 0], atol=1e-6)
    assert np.linalg.norm(turn - np.eye(3)) > 0.01
    assert next(p.image.shape for p in run.source) == (2, 120, 160)


def test_unrectified_pictures_are_measured_and_named(room, tmp_path, capsys):
    folder = euroc(room, tmp_path / "euroc")
    sides = [str(folder / "mav0" / f"cam{i}" / "data") for i in range(2)]
    yaml = [str(folder / "mav0" / f"cam{i}" / "sensor.yaml") for i in range(2)]
    call = ["run", "stereo-images", "--left", sides[0], "--right", sides[1], *QUICK, "--calibration"]
    assert main([*call, plain(tmp_path)]) == 2
    assert "the rows of a point in the two pictures differ by" in capsys.readouterr().err
    assert main([*call, *yaml]) == 2
    assert "not that of a rectified pair: the lenses distort" in capsys.readouterr().err
    assert main([*call, *yaml, "--rectify", "--frames", "3", "--json"]) == 0
    assert found(capsys)["inlier_share"] > 0.8


@pytest.mark.parametrize(
    "arguments", [["--motion", "constant-velocity"], ["--motion", "correlated"], ["--odometry-only"]]
)
def test_an_interrupted_run_goes_on_as_if_it_had_not_been(room, arguments, tmp_path, capsys, monkeypatch):
    whole, cut = tmp_path / "whole.npz", tmp_path / "cut.npz"
    assert main(words(room, *arguments, "--save", str(whole))) == 0
    monkeypatch.setattr(runner, "progress", interrupted_at(4))
    assert main(words(room, *arguments, "--save", str(cut), "--trajectory", "t.txt")) == 130
    monkeypatch.undo()
    assert f"saved after 5 pairs; resume with: slamlib run stereo-images --resume {cut}" in capsys.readouterr().err
    assert len(read_trajectory(tmp_path / "t.txt")) == 5
    os.chdir(tmp_path)
    assert main(["run", "stereo-images", "--resume", str(cut), "--save", str(cut)]) == 0
    one, two = load(whole), load(cut)
    assert np.array_equal(one.trajectory().poses, two.trajectory().poses)
    assert np.array_equal(one.slam.belief.matrix, two.slam.belief.matrix)


def test_choices_reach_the_run(room, tmp_path):
    given = ["--start", "1", "--every", "2", "--frames", "3", "--landmark", "idpPnt", "--noise", "0.3", "0.3", "0.4"]
    given += ["--motion", "constant-velocity", "--impulse", "0.2", "5", "--velocity", "1", "7"]
    given += ["--search", "per_cell=6"]
    assert main(words(room, *given, "--capacity", "50", "--window", "4", "--patience", "3", "--save", "run.npz")) == 0
    run = load("run.npz")
    assert (list(run.source.frames), run.patience, run.motion.name) == ([1, 3, 5], 3, "constant-velocity")
    options, rig = run.slam.options, run.slam.rig
    assert (options.points, options.capacity, options.window, options.max_new_first) == ("idpPnt", 50, 4, 40)
    assert len(run.slam.landmarks) <= 50
    assert run.motion.front_end.settings.per_cell == 6
    assert rig.sensors[0].std == (0.3, 0.3, 0.4)
    assert rig.robots[0].control_std == (0.2, 0.2, 0.2, 5.0, 5.0, 5.0)
    assert rig.robots[0].velocity_std == (1.0, 1.0, 1.0, 7.0, 7.0, 7.0)


def test_a_dark_pair_at_first_and_a_cut(room, tmp_path, capsys):
    folder = copied(room, tmp_path / "dark")
    for side in ("left", "right"):
        for i in (1, *range(7, COUNT + 1)):
            cv2.imwrite(str(folder / side / f"{i:06d}.png"), np.zeros((120, 160), np.uint8))
    there = ["--left", str(folder / "left"), "--right", str(folder / "right"), "--calibration", plain(tmp_path)]
    for arguments in (["--motion", "split-features"], ["--odometry-only"]):
        call = ["run", "stereo-images", *there, "--patience", "3", "--json", *arguments]
        assert main([*call, *QUICK, "--calibration-std", "offset=1"]) == 2
        told = capsys.readouterr()
        s = json.loads(told.out)
        assert s["frames"] == 9
        assert "3 pairs in a row without a match, from frame 7 on" in s["stopped"]
        assert "saved after 9 pairs" in told.err
        assert "taken for exact: the run did not come to its end" in told.err


def test_a_film_shows_the_left_picture(room, tmp_path):
    pytest.importorskip("matplotlib", reason="films need matplotlib")
    assert main(words(room, "--frames", "2", "--video", str(tmp_path / "film"), "--save", "run.npz")) == 0
    assert sorted(f.name for f in (tmp_path / "film").iterdir()) == ["0001.png", "0002.png"]


def test_a_window_shows_every_frame(room, monkeypatch):
    shown = windows(monkeypatch)
    assert main(words(room, "--frames", "3", "--live")) == 0
    assert [s.number for s in shown] == [1, 2, 3]
    assert shown[0].sensors[0].scan.image.shape == (120, 160)


def test_kittis_poses_as_a_reference(room, tmp_path, capsys):
    places = from_start(read_trajectory(room / "groundtruth_0.txt"))[:, :3]
    rows = [np.column_stack([np.eye(3), place]).ravel() for place in places]
    text = "\n".join(" ".join(f"{n:.9f}" for n in row) for row in rows)
    (tmp_path / "poses.txt").write_text(text)
    assert main(words(room, "--json", "--start", "2", "--reference", "poses.txt")) == 0
    assert found(capsys)["reference"]["poses"] == COUNT - 2
    (tmp_path / "poses.txt").write_text(text.split("\n")[0])
    assert main(words(room, "--json", "--reference", "poses.txt")) == 2
    assert f"1 poses, but no times: {COUNT} are given" in capsys.readouterr().err


def test_lengths_of_parts_fit_the_path():
    assert lengths_of(3000)[0] == 100
    assert lengths_of(59.9) == (5, 10, 15, 20, 25, 30, 35, 40)
    assert lengths_of(0.5)[-1] == pytest.approx(0.4)
    assert lengths_of(0.0) == ()


def test_a_run_of_pairs_goes_on_elsewhere(room, tmp_path, capsys):
    copied(room, tmp_path / "a", 6)
    sides = ["--left", "a/left", "--right", "a/right"]
    call = ["run", "stereo-images", *sides, *QUICK, "--calibration", plain(tmp_path), "--fps", "15"]
    assert main([*call, "--frames", "3", "--save", "run.npz"]) == 0
    (tmp_path / "a").rename(tmp_path / "b")
    capsys.readouterr()
    again = ["run", "stereo-images", "--resume", "run.npz", "--frames", "5", "--json"]
    assert main([*again, "--left", "b/left"]) == 2
    assert "both --left and --right are needed" in capsys.readouterr().err
    assert main([*again, "--left", "b/right", "--right", "b/left"]) == 2
    assert "with other pixels" in capsys.readouterr().err
    assert main([*again, "--left", "b/left", "--right", "b/right"]) == 0
    assert found(capsys)["frames"] == 5


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ([], "--source, or --left and --right, are needed"),
        (["--left", "{room}/image_0"], "--source, or --left and --right, are needed"),
        (["--source", "{room}", "--left", "{room}/image_0"], "leave --left and --right out"),
        (["--source", "{room}/image_0"], "has no pair of cameras"),
        (["--source", "{room}", "--cameras", "2", "3"], "has no camera 2; it has 0, 1"),
        (["--source", "{room}", "--calibration", "nowhere.txt"], "nowhere.txt cannot be read"),
        (["--left", "{room}/image_0", "--right", "{room}/image_1"], "--calibration is wanted"),
        (["--left", "{room}/image_0", "--right", "nowhere"], "there is nothing"),
        (["--source", "{room}", "--landmark", "idpPt"], "did you mean 'idpPnt'?"),
        (["--source", "{room}", "--search", "zom=2"], "unknown key of search 'zom'; did you mean 'zoom'?"),
        (["--source", "{room}", "--option", "gat=1"], "did you mean 'gate'?"),
        (["--source", "{room}", "--noise", "1", "2"], "--noise takes one number above 0, or three"),
        (["--source", "{room}", "--odometry-only", "--live"], "with --odometry-only there is none"),
        (["--source", "{room}", "--start", "99"], "none is left"),
        (["--source", "{room}", "--trajectory", "{room}/calibration.json/t.txt"], "cannot be written"),
        (["--source", "{room}", "--resume", "run.npz"], "no such file"),
        (["--fps", "9", "--resume", "run.npz"], "leave --fps out"),
        (["--resume", "nowhere.npz"], "no such file"),
        (["--source", "{room}", "--reference", "nowhere.txt"], "cannot be read"),
    ],
)
def test_mistakes_are_named(room, more, message, capsys):
    assert main(["run", "stereo-images", *(word.format(room=room) for word in more)]) == 2
    told = capsys.readouterr()
    assert message in told.err
    assert told.err.startswith("slamlib: ")
    assert not told.out


def test_left_and_right_exchanged(room, tmp_path, capsys):
    sides = ["--left", str(room / "image_1"), "--right", str(room / "image_0")]
    assert main(["run", "stereo-images", *sides, "--calibration", plain(tmp_path)]) == 2
    assert "left and right are exchanged" in capsys.readouterr().err
    assert main(words(room, "--cameras", "1", "0")) == 2
    assert "left and right are exchanged" in capsys.readouterr().err


def test_pictures_that_do_not_fit_together(room, tmp_path, capsys):
    folder = copied(room, tmp_path / "two", 5)
    there = ["--left", str(folder / "left"), "--right", str(folder / "right"), "--calibration", plain(tmp_path)]
    call = ["run", "stereo-images", *there]
    (folder / "right" / "000003.png").unlink()
    assert main(call) == 2
    told = capsys.readouterr().err
    assert "has 5 pictures" in told
    assert "has 4 (alone: 000003.png)" in told
    (folder / "left" / "000002.png").unlink()
    assert main(call) == 2
    assert "left picture 000003.png and right picture 000002.png" in capsys.readouterr().err
    (folder / "right" / "000002.png").unlink()
    (folder / "left" / "000003.png").unlink()
    cv2.imwrite(str(folder / "right" / "000001.png"), np.zeros((60, 80), np.uint8))
    assert main(call) == 2
    assert (
        "000001.png and 000001.png: a rectified pair has two grey pictures (h, w) of one size"
        in capsys.readouterr().err
    )


def test_times_that_do_not_match(room, tmp_path, capsys):
    folder = euroc(room, tmp_path / "euroc")
    listing = folder / "mav0" / "cam1" / "data.csv"
    rows = table(listing, 2)
    listing.write_text("\n".join(f"{int(time) + 10**12},{name}" for time, (name,) in rows))
    assert main(words(folder)) == 2
    assert "the times of the two cameras do not match" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("P0: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\n", "there is no camera 1"),
        ("P0: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\nP1: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\n", "both cameras have"),
        ("P0: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\nP1: 130 0 79.5 15.6 0 130 59.5 0 0 0 1 0\n", "are exchanged"),
        ("P0: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\nP1: 90 0 79.5 -15.6 0 90 59.5 0 0 0 1 0\n", "focal lengths"),
        ("P0: 130 0 79.5 0 0 130 59.5 0 0 0 1 0\nP1: 130 0 79.5 0 0 130 59.5 -15.6 0 0 1 0\n", "stand side by side"),
        ("130 130 79.5 59.5", "the baseline is missing"),
        ('{"intrinsics": [79.5, 59.5, 130, 130], "baseline": -1}', "pair.baseline should be above 0"),
        ('{"intrinsics": [79.5, 59.5, 130], "baseline": 1}', "intrinsics"),
        ('{"intrinsics": [79.5, 59.5, 130, 130], "baseline": 1, "std_": 1}', "did you mean 'std'?"),
        ('{"intrinsics": [79.5, 59.5, 130, 130], "baseline": 1, "image": [64, 48]}', "of pictures of 64x48"),
        ('{"intrinsics": [79.5, 59.5, 130, 130]}', "the baseline is missing"),
        ('{"parameters": {"intrinsics": [79.5, 59.5, 130, 130]}}', "the baseline is missing"),
    ],
)
def test_calibrations_that_are_none(room, text, message, tmp_path, capsys):
    path = tmp_path / ("a.json" if text.startswith("{") else "calib.txt")
    path.write_text(text)
    assert main(beside(room, "--calibration", str(path))) == 2
    assert message in capsys.readouterr().err


def test_help_has_examples_and_other_files_are_refused(room, capsys):
    with pytest.raises(SystemExit) as stop:
        main(["run", "stereo-images", "--help"])
    assert stop.value.code == 0
    assert "--odometry-only\n" in capsys.readouterr().out
    assert main(["run", "points", "--frames", "2", "--save", "points.npz"]) == 0
    assert main(["run", "stereo-images", "--resume", "points.npz"]) == 2
    assert "holds no run on pairs" in capsys.readouterr().err


def test_the_street(capsys):
    street = kitti_street.found()
    if street is None:
        pytest.skip("KITTI's street is not at hand")
    sides = ["--left", str(street.left), "--right", str(street.right)]
    there = [*sides, "--calibration", str(street.calibration), "--fps", "10", "--reference", str(street.poses)]
    assert main(["run", "stereo-images", *there, "--frames", "12", "--json"]) == 0
    s = found(capsys)
    assert s["frames_without_match"] == 0
    assert s["reference"]["poses"] == 12
    assert s["reference"]["relative_ate"] < 0.02


def considered(room, capsys, *more):
    """The summary of six pairs, with a calibration that has errors."""
    assert main(words(room, "--json", "--frames", "6", "--odometry-only", *more)) == 0
    return found(capsys)


def test_an_error_of_the_baseline_is_one_of_every_length(room, tmp_path, capsys):
    out, share = tmp_path / "path.txt", 0.05
    s = considered(room, capsys, "--calibration-std", f"baseline={share * BASELINE}", "--trajectory", str(out))
    path, told = read_trajectory(out), s["calibration"]
    moved = np.linalg.norm(path.positions[-1] - path.positions[0])
    claimed, known = told["without"]["position_sigma"], told["with"]["position_sigma"]
    assert np.sqrt(known**2 - claimed**2) == pytest.approx(share * moved, rel=0.05)
    assert told["with"]["orientation_sigma"] == pytest.approx(told["without"]["orientation_sigma"], rel=0.05)
    assert np.sqrt(path.covariances[-1].diagonal()[:3] @ np.ones(3)) == pytest.approx(known)


def test_a_considered_calibration_is_judged_with_and_without(room, tmp_path, capsys):
    truth = str(room / "groundtruth_0.txt")
    wrong = ["--calibration-std", "intrinsics=0,0,3,3", "--calibration-std", "offset=0.3", "--reference", truth]
    s = considered(room, capsys, *wrong)
    assert list(s["calibration"]["errors"]) == ["intrinsics[2]", "intrinsics[3]", "offset[0]"]
    assert s["reference"]["nees"]["median"] < s["calibration"]["without"]["nees"]
    plain_run = considered(room, capsys, "--reference", truth)
    assert plain_run["calibration"] is None
    assert plain_run["reference"]["nees"]["median"] == s["calibration"]["without"]["nees"]
    assert main(words(room, "--frames", "6", "--odometry-only", *wrong)) == 0
    assert "calibration considered " in (shown := capsys.readouterr().out)
    assert "; without its errors " in shown


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("focal=1", "parameter of this calibration"),
        ("intrinsics=1,2", "4 numbers"),
        ("offset=-1", "from zero on"),
        ("offset=much", "from zero on"),
        ("offset", "NAME=VALUE"),
    ],
)
def test_calibration_errors_that_cannot_be_considered_are_refused_before_the_run(room, said, why, capsys):
    assert main(words(room, "--calibration-std", said)) == 2
    assert why in capsys.readouterr().err


def test_a_run_that_is_lost_with_a_wrong_calibration_keeps_what_is_known(room, capsys):
    assert (
        main(words(room, "--json", "--frames", "6", "--patience", "2", "--calibration-std", "intrinsics=0,0,1e9,0"))
        == 2
    )
    out = capsys.readouterr()
    assert "the calibration is taken for exact" in out.err
    assert json.loads(out.out)["frames"] == 6
    assert json.loads(out.out)["calibration"] is None
