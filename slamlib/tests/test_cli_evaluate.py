"""`slamlib evaluate`, and what runs export: trajectories with covariances, maps, plots of the errors."""

import json
from pathlib import Path

import numpy as np
import pytest

from slamlib.cli import main
from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import Similarity
from slamlib.evaluation.comparison import compared, evaluate
from slamlib.evaluation.trajectory import Trajectory, read_trajectory, write_tum
from slamlib.experiments.runs import Run
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.tests.test_trajectories import smooth

COUNT, DT = 400, 0.1


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """Files are written to the present folder."""
    monkeypatch.chdir(tmp_path)


def truth(count=COUNT):
    """A path around a bent circle of 10 m."""
    a = np.linspace(0, 6, count)
    places = np.stack([10 * np.cos(a), 10 * np.sin(a), np.sin(3 * a)], axis=1)
    return Trajectory(DT * np.arange(count), np.concatenate([places, exponential(np.outer(a, [0, 0, 1]))], axis=1))


def estimated(path, rng, scale=1.0):
    """Each pose with an error of its own covariance, which is larger or smaller than claimed by a factor `scale`.

    The first second, by which the truth is placed, is known.
    """
    roots = rng.standard_normal((len(path), 6, 6)) * [0.1, 0.1, 0.1, 0.01, 0.01, 0.01]
    covariances = roots.swapaxes(1, 2) @ roots
    errors = np.einsum("nij,ni->nj", roots, scale * rng.standard_normal((len(path), 6)))
    errors[path.times <= 1.0] = 0
    return Trajectory(path.times, Pose.plus(path.poses, errors), covariances)


def printed(words, capsys):
    assert main(words) == 0
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(("scale", "low", "high"), [(1.0, 0.92, 0.98), (0.2, -1, 0.1), (3.0, -1, 0.2)])
def test_nees_says_whether_the_covariances_are_right(scale, low, high, capsys):
    rng = np.random.default_rng(5)
    moved = np.concatenate([[3.0, -2, 1], exponential(np.array([0.3, 0.1, -2]))])
    path = estimated(truth(), rng, scale)
    write_tum("path.txt", path)
    write_tum("truth.txt", Trajectory(path.times, compose(moved, truth().poses)))  # in axes of its own
    found = printed(["evaluate", "path.txt", "truth.txt", "--json"], capsys)
    assert low < found["nees"]["inside"] < high
    assert found["scale"] == 1.0
    assert found["nees"]["dof"] == 6
    end = found["nees"]["at_end"]
    assert 0.05 < end["position_sigma"] < 1
    assert end["position"] < 5 * scale * end["position_sigma"]


@pytest.mark.parametrize(("said", "low", "high"), [("0 0", -1, 0.2), ("0.5 3", 0.92, 0.98), ("5 30", -1, 0.1)])
def test_a_reference_may_have_errors_too(said, low, high, capsys):
    rng = np.random.default_rng(9)
    path, sigma = estimated(truth(), rng), np.repeat([0.5, np.radians(3)], 3)
    errors = sigma * rng.standard_normal((len(path), 6))
    errors[path.times <= 1.0] = 0
    write_tum("path.txt", path)
    write_tum("truth.txt", Trajectory(path.times, Pose.plus(truth().poses, errors)))
    found = printed(["evaluate", "path.txt", "truth.txt", "--reference-std", *said.split(), "--json"], capsys)
    assert low < found["nees"]["inside"] < high


def test_absolute_and_relative_errors_are_those_of_evo(capsys):
    """The definitions of evo, written out: distances and angles after Umeyama's alignment; and from pose to pose."""
    path, there = estimated(truth(), np.random.default_rng(1)), truth()
    write_tum("path.txt", path)
    write_tum("truth.txt", there)
    found = printed(["evaluate", "path.txt", "truth.txt", "--json"], capsys)
    x, y = path.positions - path.positions.mean(0), there.positions - there.positions.mean(0)
    U, _, V = np.linalg.svd(y.T @ x)
    distances = np.linalg.norm(x @ (U @ np.diag([1, 1, np.linalg.det(U @ V)]) @ V).T - y, axis=1)
    assert found["ate"] == found["position"]["rmse"] == pytest.approx(np.sqrt((distances**2).mean()), rel=1e-9)
    for name, f in (("mean", np.mean), ("median", np.median), ("std", np.std), ("min", np.min), ("max", np.max)):
        assert found["position"][name] == pytest.approx(f(distances), rel=1e-8)
    matrices = []
    for trajectory in (there, path):
        T = np.tile(np.eye(4), (COUNT, 1, 1))
        T[:, :3, :3], T[:, :3, 3] = rotation(trajectory.poses[:, 3:]), trajectory.positions
        matrices.append(np.linalg.inv(T[:-1]) @ T[1:])
    error = np.linalg.inv(matrices[0]) @ matrices[1]
    turned = np.degrees(np.arccos(np.clip((np.trace(error[:, :3, :3], axis1=1, axis2=2) - 1) / 2, -1, 1)))
    moved = np.linalg.norm(error[:, :3, 3], axis=1)
    assert found["rpe"]["position"]["rmse"] == pytest.approx(np.sqrt((moved**2).mean()), rel=1e-8)
    assert found["rpe"]["orientation"]["mean"] == pytest.approx(turned.mean(), rel=1e-6)


def test_nees_of_one_camera_is_that_of_the_path_in_the_unit_of_the_reference(capsys):
    there, rng = truth(), np.random.default_rng(4)
    shift, P = 0.02 * rng.standard_normal((COUNT, 3)), np.tile(np.diag([4e-4] * 3 + [1e-4] * 3), (COUNT, 1, 1))
    moved = np.concatenate([there.positions + shift, there.poses[:, 3:]], axis=1)
    write_tum("metric.txt", Trajectory(there.times, moved, P))
    J = np.diag([0.25] * 3 + [1.0] * 3)
    write_tum("small.txt", Trajectory(there.times, moved * np.repeat([0.25, 1.0], [3, 4]), J @ P @ J))
    write_tum("truth.txt", there)
    metric = printed(["evaluate", "metric.txt", "truth.txt", "--json"], capsys)["nees"]
    small = printed(["evaluate", "small.txt", "truth.txt", "--scale", "--json"], capsys)["nees"]
    assert 1 < metric["median"] < 6
    for name in ("median", "last"):
        assert small[name] == pytest.approx(metric[name], rel=0.05)  # its scale is fitted


def test_a_path_of_one_camera_needs_its_scale_aligned(capsys):
    there = truth()
    small = np.concatenate([0.25 * there.positions, there.poses[:, 3:]], axis=1)
    write_tum("path.txt", Trajectory(there.times, small, np.tile(np.eye(6), (COUNT, 1, 1))))
    write_tum("truth.txt", there)
    assert printed(["evaluate", "path.txt", "truth.txt", "--json"], capsys)["ate"] > 1
    found = printed(["evaluate", "path.txt", "truth.txt", "--scale", "--json"], capsys)
    assert (found["scale"], found["ate"]) == (pytest.approx(4), pytest.approx(0, abs=1e-9))
    assert found["nees"]["last"] == pytest.approx(0, abs=1e-9)
    assert main(["evaluate", "path.txt", "truth.txt", "--plot", "errors.svg"]) == 0
    text = capsys.readouterr().out
    assert "NEES, 6 dof" in text
    assert "relative error (RPE)" in text
    assert "(sigma 1.7), " in text  # metres, of three unit variances


def test_kittis_poses_with_their_times(capsys):
    there = truth(30)
    rows = np.concatenate([rotation(there.poses[:, 3:]), there.positions[:, :, None]], axis=2).reshape(-1, 12)
    np.savetxt("poses.txt", rows)
    np.savetxt("times.txt", there.times)
    write_tum("path.txt", there)
    assert printed(["evaluate", "path.txt", "poses.txt", "--times", "times.txt", "--json"], capsys)["ate"] < 1e-9
    Path("empty.txt").write_text("# nothing\n")
    assert main(["evaluate", "path.txt", "poses.txt", "--times", "empty.txt"]) == 2
    assert "empty.txt is no trajectory: there is no row of numbers in it" in capsys.readouterr().err
    assert main(["evaluate", "path.txt", "poses.txt"]) == 2
    assert "poses.txt has 30 poses, but no times: give them (option times)" in capsys.readouterr().err
    Path("times.txt").write_text("\ufeff" + "".join(f"{t:.0f}\n" for t in 1e9 * (1.7e9 + there.times[:29])), "utf-8")
    assert main(["evaluate", "path.txt", "poses.txt", "--times", "times.txt"]) == 2
    assert "poses.txt has 30 poses, but no times: 29 are given, and as many are wanted" in capsys.readouterr().err
    assert main(["evaluate", "poses.txt", "poses.txt"]) == 0
    assert "neither file has times: paired row by row, a second apart" in capsys.readouterr().err
    np.savetxt("short.txt", rows[:29])
    assert main(["evaluate", "poses.txt", "short.txt"]) == 2
    assert "poses.txt has 30 poses, short.txt 29, and neither has times" in capsys.readouterr().err


def test_covariances_stand_beside_the_path():
    path = estimated(truth(50), np.random.default_rng(2))
    write_tum("path.txt", path)
    again = read_trajectory("path.txt")
    np.testing.assert_allclose(again.covariances, path.covariances, rtol=1e-11)
    assert again[3:9].covariances.shape == (6, 6, 6)
    assert [len(line.split()) for line in Path("path.txt").read_text().splitlines()][1] == 8  # what evo reads
    of_others = Path("path.txt.cov").read_bytes()
    write_tum("path.txt", truth(49))
    Path("path.txt.cov").write_bytes(of_others)
    with pytest.raises(SlamlibError, match=r"path\.txt\.cov does not have the covariances of the poses in path\.txt"):
        read_trajectory("path.txt")
    assert read_trajectory("path.txt", covariances=False).covariances is None


def test_a_reference_has_no_covariances_and_paths_have_their_own(capsys):
    for name, rate in (("path_0.5", 1.0), ("path_0.9", 10.0)):
        path = estimated(truth(), np.random.default_rng(2), rate)
        write_tum(name, path)
    write_tum("truth.txt", truth())
    write_tum("truth.txt.cov", truth())  # anything
    sizes = [printed(["evaluate", f"path_0.{k}", "truth.txt", "--json"], capsys)["nees"]["median"] for k in (5, 9)]
    assert 4 < sizes[0] < 7 < 300 < sizes[1]


def test_options_of_the_command_are_those_of_the_function(capsys):
    there = Trajectory(DT * np.arange(COUNT), smooth(np.random.default_rng(1), DT * np.arange(COUNT)))
    write_tum("path.txt", Trajectory(there.times - 0.5, there.poses))
    rows = np.concatenate([1e9 * there.times[:, None], there.poses], axis=1)
    np.savetxt("truth.csv", rows, delimiter=" ", fmt=["%d", *7 * ["%.9g"]])
    words = "--offset 0.5 --tolerance 0.01 --align origin --align-first 50 --delta 2 --delta-unit m --all-pairs"
    options = {"offset": 0.5, "tolerance": 0.01, "align": "origin", "align_first": 50, "delta": 2, "delta_unit": "m"}
    assert main(["evaluate", "path.txt", "truth.csv"]) == 2
    assert "state its format (option format, or reference-format" in capsys.readouterr().err
    found = printed(
        ["evaluate", "path.txt", "truth.csv", "--reference-format", "euroc", *words.split(), "--json"], capsys
    )
    again = evaluate("path.txt", "truth.csv", reference_format="euroc", all_pairs=True, **options).summary
    assert found == json.loads(json.dumps(again))
    assert (found["pairs"]["offset"], found["rotation_from"], found["rpe"]["delta_unit"]) == (0.5, "first pose", "m")
    assert main(["evaluate", "path.txt", "truth.csv", "--reference-format", "euroc", "--offset", "auto"]) == 0
    output = capsys.readouterr()
    assert "s added to the path's times" in output.out
    assert "slamlib: time offset 0.5" in output.err
    assert (
        repr(evaluate("path.txt", "truth.csv", reference_format="euroc", offset="auto")).count("time offset 0.5") == 1
    )
    for name, value in (("tolerance", -1), ("offset", "soon"), ("align_first", 0)):
        with pytest.raises(SlamlibError, match=name.replace("_", "-")):
            evaluate("path.txt", "truth.csv", reference_format="euroc", **{name: value})


def test_what_json_has_no_number_for_is_null(capsys):
    still = Trajectory(DT * np.arange(20), np.tile([0.0, 0, 0, 1, 0, 0, 0], (20, 1)))
    write_tum("still.txt", still)
    found = printed(["evaluate", "still.txt", "still.txt", "--json"], capsys)
    assert found["relative_ate"] is None
    there = truth(20)
    write_tum("path.txt", there)
    text = json.dumps(printed(["evaluate", "path.txt", "path.txt", "--json"], capsys), allow_nan=False)
    assert '"translation": [' in text


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("evaluate path.txt truth.txt --plot errors.svg --json path.txt.json", None),
        (
            "evaluate path.txt truth.json --json truth.json --overwrite",
            "--json: truth.json is read by the command (refer",
        ),
        (
            "evaluate path.svg truth.txt --plot ./path.svg --overwrite",
            "--plot: ./path.svg is read by the command (path)",
        ),
        (
            "run points --frames 2 --map a.json --json a.json --overwrite",
            "--json: a.json is also where something else go",
        ),
        (
            "run images --source path.txt --trajectory a --save a.cov",
            "--trajectory: a.cov is also where something else",
        ),
        (
            "run images --source path.txt --trajectory path.txt --overwrite",
            "--trajectory: path.txt is read by the command",
        ),
        (
            "run points --frames 2 --video out --plot out/errors.svg",
            "--video: out is also where something else goes, by --p",
        ),
        (
            "run stereo-images --left seen/left --right seen/right --calibration a.json truth.json --map truth.json",
            "--map: truth.json is read by the command (calibration)",
        ),
        ("run images --source seen/left --calibration a.json --video seen/left", "--video: seen/left is read"),
        ("run images --source seen/left/*.png --calibration a.json --video seen", "--video: seen is read"),
        ("run images --source seen/left/*.png --calibration a.json --trajectory seen/left/1.png", "1.png is read"),
        ("run images --source seen --calibration a.json --save ./seen/../seen/left/1.png", "1.png is read"),
        ("run stereo-images --left seen/left --right seen/right --calibration a.json --video seen/right", "is read by"),
        ("run points --frames 2 --video seen/left", "seen/left is a folder, and holds other things than a film's"),
        ("run points --frames 2 --video .", ". is no name of a film"),
        ("run points --frames 2 --video ..", ".. is no name of a film"),
    ],
)
def test_no_output_replaces_another_or_an_input(words, message, capsys):
    for name in ("path.txt", "path.svg", "truth.txt", "truth.json"):
        write_tum(name, truth(20))
    for name in ("left", "right"):
        Path("seen", name).mkdir(parents=True)
        Path("seen", name, "1.png").write_bytes(b"a picture")
    before = {file: file.read_bytes() for file in Path().rglob("*") if file.is_file()}
    overwrite = [] if message is None else ["--overwrite"]
    assert main([*words.replace(" --overwrite", "").split(), *overwrite]) == (0 if message is None else 2)
    assert message is None or message in capsys.readouterr().err
    assert all(file.read_bytes() == content for file, content in before.items())


def test_covariances_go_with_the_axes():
    """Those of many errors that are drawn, and moved one by one."""
    rng = np.random.default_rng(3)
    root = 1e-4 * rng.standard_normal((6, 6))
    pose, extrinsics = Pose.random(rng), Pose.random(rng)
    errors = rng.standard_normal((20000, 6)) @ root.T
    drawn = Trajectory(np.arange(20000.0), Pose.plus(pose, errors))
    one = Trajectory([0.0], pose[None], (root @ root.T)[None])
    bent = Similarity(2.5, rotation(exponential(np.array([0.4, -1, 2]))), np.array([1.0, 2, 3]))
    for way in (lambda t: t.sensor_trajectory(extrinsics), bent.moved):
        found = Pose.minus(way(drawn).poses, way(one).poses[0])
        expected = way(one).covariances[0]
        scale = np.sqrt(np.outer(expected.diagonal(), expected.diagonal()))
        assert np.abs((np.cov(found.T) - expected) / scale).max() < 0.05


def test_maps_in_three_formats():
    words = ["run", "points_and_lines", "--frames", "12", "--overwrite"]
    for ending in ("ply", "json", "csv"):
        assert main([*words, "--map", f"new/map.{ending}", "--save", "run.npz"]) == 0
    shown = Run.load("run.npz").slam.snapshot()
    points, lines = shown.points, shown.landmarks["segments"]
    table = np.genfromtxt("new/map.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert len(table) == len(points.ids) + 2 * len(lines.ids) > 5
    rows = table[table["family"] == "points"]
    np.testing.assert_allclose(np.stack([rows[n] for n in "xyz"], axis=1), points.geometry, rtol=1e-10)
    np.testing.assert_allclose(rows["xy"], points.covariance[:, 0, 1], rtol=1e-10)
    held = json.loads(Path("new/map.json").read_text())
    assert [each["id"] for each in held["landmarks"]] == [*points.ids.tolist(), *lines.ids.tolist()]
    assert held["landmarks"][-1]["vertices"][1]["position"] == lines.geometry[-1, 1].tolist()
    head, body = Path("new/map.ply").read_text().split("end_header\n")
    vertices = int(head.split("element vertex ")[1].split()[0])
    edges = int(head.split("element edge ")[1].split()[0])
    rows = [line.split() for line in body.splitlines()]
    finite = np.isfinite(lines.geometry).all((1, 2)) & np.isfinite(lines.covariance).all((1, 2, 3))
    assert (len(rows), edges) == (vertices + edges, finite.sum())
    assert 0 < edges < len(lines.ids)  # one has an endpoint at infinity
    assert np.isfinite(np.array(rows[:vertices], dtype=float)).all()
    assert float(rows[0][3]) == pytest.approx(np.sqrt(np.linalg.eigvalsh(points.covariance[0])[-1]), rel=1e-5)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["run", "points", "--map", "map.xyz"], "unknown ending of a map's file '.xyz'"),
        (["run", "points", "--plot", "errors.bmp"], "unknown ending of a plot '.bmp'"),
        (["run", "images", "--plot", "errors.svg"], "are about errors: they need --reference FILE"),
        (["run", "images", "--reference-std", "0.1", "1"], "are about errors: they need --reference FILE"),
        (["evaluate", "nothing.txt", "nothing.txt"], "nothing.txt cannot be read"),
        (["evaluate", "words.txt", "words.txt"], "words.txt is no trajectory: there is no row of numbers in it"),
    ],
)
def test_mistakes_are_named_before_the_run(words, message, capsys):
    Path("words.txt").write_text("these are words")
    assert main(words) == 2
    assert message in capsys.readouterr().err


def test_plots_are_pictures_and_not_replaced_unasked(capsys):
    for name in ("errors.svg", "errors.png", "errors.pdf"):
        assert main(["run", "two_robots", "--frames", "5", "--plot", name]) == 0
    assert "<svg" in Path("errors.svg").read_text()[:500]
    assert Path("errors.png").read_bytes()[:4] == b"\x89PNG"
    capsys.readouterr()
    assert main(["run", "two_robots", "--frames", "5", "--plot", "errors.svg"]) == 2
    assert "errors.svg exists" in capsys.readouterr().err


def test_what_is_drawn_beside_deviations_is_their_error():
    """Not that after the best alignment, which a covariance of the pose from its start does not describe."""
    path = estimated(truth(), np.random.default_rng(6))
    _, series = compared(path, truth(), metric=True)
    own = Pose.minus(truth().poses, path.poses)
    np.testing.assert_allclose(series["position"], np.linalg.norm(own[:, :3], axis=1), atol=1e-12)
    np.testing.assert_allclose(series["orientation"], np.degrees(np.linalg.norm(own[:, 3:], axis=1)), atol=1e-9)
    np.testing.assert_allclose(series["position_sigma"] ** 2, path.covariances[:, :3, :3].trace(axis1=1, axis2=2))


def test_one_pose_is_not_compared():
    there = truth(5)
    assert compared(there, there, metric=True)[0]["parts"] is not None
    with pytest.raises(SlamlibError, match="only 0 of 5 poses have one of the reference's 1 within"):
        compared(there, Trajectory([100.0], there.poses[:1]), metric=True)
