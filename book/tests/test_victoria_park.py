"""EKF-SLAM with unknown data association: a small park with its truth, and the beginning of the real one."""

import json
import os
from pathlib import Path

import numpy as np
import pytest
from slambook import victoria_park
from slambook.trees import AXLES, WHEEL, dead_reckoning, driven

from book.experiments.stored import kept
from book.tools import layout
from slamlib.errors import SlamlibError
from slamlib.geometry.pose2 import compose, to_frame
from slamlib.motions.unicycle import UNICYCLE
from slamlib.records.inputs import Control, Features, Frame, Scan

io = pytest.importorskip("scipy.io", reason="SciPy writes and reads MATLAB's files")
REAL = Path(os.environ.get("SLAMLIB_DATA") or "no-data") / "landmarks_victoria_park"
STORED = layout.BOOK / "chapters" / "data" / "victoria_park_run.json"
RENEW = "run `python -m slambook.victoria_park --json book/chapters/data/victoria_park_run.json`"
LASER_POSE = np.array([*victoria_park.LASER_AT[:2], 0])


def park(folder, seed=1, seconds=65.0, clutter=0.05):
    """Write a park in the layout of the real files: one and a half rounds among trees; return the trees."""
    rng = np.random.default_rng(seed)
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    radii = np.where(np.arange(24) % 2, 22.0, 8.0) + rng.uniform(-2, 2, 24)
    trees = np.column_stack([radii * np.cos(angles), 15 + radii * np.sin(angles)])
    times = 10 + np.arange(0, seconds, 0.025)
    true = np.tile([2.2, np.arctan(2.83 / 15)], (len(times), 1))
    slow = np.sin(times / 7)[:, None] * [0.05, np.radians(0.3)]  # what the encoders say wrongly, slowly changing
    noise = rng.standard_normal(true.shape) * [0.2, np.radians(1)]
    scan_times = np.arange(9.9, times[-1], 0.2)  # the first one is before the car's first control
    pose, k, scans, path = np.zeros(3), 0, [], []
    for time in scan_times:
        while k + 1 < len(times) and times[k + 1] <= time:
            pose, k = UNICYCLE.step(pose, driven(true[k])[0], times[k + 1] - times[k]), k + 1
        laser = compose(UNICYCLE.step(pose, driven(true[k])[0], max(0.0, time - times[k])), LASER_POSE)
        path.append(laser[:2])
        x, y = to_frame(laser, trees).T
        seen = (x > 0) & (np.hypot(x, y) < 30) & (rng.random(24) < 0.8)
        found = np.column_stack([np.hypot(x, y), np.arctan2(y, x)])[seen]
        found += rng.standard_normal(found.shape) * [0.1, np.radians(0.5)]
        if rng.random() < clutter:  # somebody walks by
            found = np.vstack([found, [rng.uniform(3, 25), rng.uniform(-1.5, 1.5)]])
        order = rng.permutation(len(found))
        scans.append(np.vstack([found.T[0], found.T[1] + np.pi / 2, 0.3 + 0 * found.T[0]])[:, order])
    zt = np.empty((1, len(scans)), dtype=object)
    zt[0] = scans
    zt[0, 5] = np.zeros((0, 0))  # as MATLAB has it where nothing was seen
    values = {"time": times[None], "u": (true + slow + noise).T, "TLsr": scan_times[None], "zt": zt}
    io.savemat(folder / "victoria_park.mat", values)
    fixed = np.arange(0, len(path), 2)
    north, east = np.array(path)[fixed].T + rng.standard_normal((2, len(fixed))) / 10  # turned: x is to the north
    gps = {"timeGps": np.round(1000 * scan_times[fixed])[:, None], "La_m": north[:, None] + 100, "Lo_m": -east[:, None]}
    io.savemat(folder / "aa3_gpsx.mat", gps)
    return trees


@pytest.mark.parametrize("seed", [1, 2])
def test_a_small_park_is_mapped_without_anybody_numbering_its_trees(tmp_path, seed):
    trees = park(tmp_path, seed)
    result = victoria_park.run(victoria_park.load(tmp_path))
    mapped = np.array(result["trees"])
    near = np.linalg.norm(mapped[:, None, :2] - trees, axis=-1)
    assert len(trees) <= len(mapped) <= len(trees) + 2  # each tree once, and hardly anything else
    assert near.min(0).max() < 0.5
    assert result["rmse"] < 0.3
    assert result["dead_reckoning_rmse"] > 3 * result["rmse"]
    assert result["used"] > 0.9 * result["measurements"]
    assert result["nis"] < result["nis_dof"]  # the noise is chosen generously, and the gate takes the large ones away
    assert len(result["path"]) <= victoria_park.POINTS


def test_the_car_drives_circles_about_its_rear_axle_by_its_inner_wheel():
    radius = 10.0  # of the rear axle's middle [m]; the measured wheel runs inside of a turn to the left
    wheel = np.array([2 * (radius - WHEEL) / radius, np.arctan(AXLES / radius)])
    control, _ = driven(wheel)
    assert control == pytest.approx([2, 2 / radius])
    quarter = UNICYCLE.step(np.zeros(3), control, np.pi / 2 * radius / 2)
    assert quarter == pytest.approx([radius, radius, np.pi / 2])
    outer = np.array([2 * (radius + WHEEL) / radius, -wheel[1]])  # in a turn to the right it runs outside
    assert driven(outer)[0] == pytest.approx([2, -2 / radius])


def test_the_noise_of_wheel_and_steering_becomes_that_of_the_control():
    wheels = np.array([[2.0, 0.3], [0.7, -0.4], [-1.0, 0.1], [3.0, 0.0]])
    _, by_wheel = driven(wheels)
    near = np.stack([driven(wheels + step)[0] - driven(wheels - step)[0] for step in 1e-6 * np.eye(2)], axis=-1)
    assert by_wheel == pytest.approx(near / 2e-6, abs=1e-8)


def test_dead_reckoning_is_one_step_after_another():
    rng = np.random.default_rng(3)
    controls, times = rng.standard_normal((40, 2)), rng.uniform(0.1, 1, 40)
    pose = np.zeros(3)
    for control, time, found in zip(controls, times, dead_reckoning(controls, times), strict=True):
        pose = UNICYCLE.step(pose, control, time)
        assert found == pytest.approx(pose, abs=1e-12)


def test_the_real_park_begins_as_it_is_stored():
    if not REAL.is_dir():
        pytest.skip("the recording is not at hand")
    result, stored = victoria_park.run(victoria_park.load(REAL), 500), kept(STORED)
    assert 50 < result["landmarks"] < 150
    assert result["rmse"] < 2
    ours, theirs = np.array(result["path"]), np.array(stored["path"])
    last = theirs[theirs[:, 0] <= ours[-1, 0]][-1]
    again = ours[ours[:, 0] == last[0], 1:]
    assert again == pytest.approx(last[None, 1:], abs=0.05), RENEW


def test_form_of_the_stored_run_is_a_path_with_a_map():
    """Without the recording nothing can be computed again; with it the test above runs 500 of its 7248 scans."""
    stored = kept(STORED)
    path, wheels, trees = (np.array(stored[name]) for name in ("path", "dead_reckoning", "trees"))
    assert len(path) == len(wheels) == -(-stored["scans"] // -(-stored["scans"] // victoria_park.POINTS))
    assert (np.diff(path[:, 0]) > 0).all()
    assert np.ptp(path[:, 0]) <= stored["time"] < np.ptp(path[:, 0]) + 5  # [s]; of the scans, one in 15 is stored
    assert 0.9 * stored["length"] < np.linalg.norm(np.diff(path[:, 1:], axis=0), axis=1).sum() < stored["length"]
    assert trees.shape == (stored["landmarks"], 5)
    assert (np.linalg.det(trees[:, [[2, 3], [3, 4]]]) > 0).all()


@pytest.mark.parametrize(
    ("break_it", "message"),
    [
        (lambda f: (f / "aa3_gpsx.mat").unlink(), "aa3_gpsx.mat: there is no such file"),
        (lambda f: (f / "victoria_park.mat").write_bytes(b"nothing"), "cannot be read as MATLAB"),
        (
            lambda f: (f / "victoria_park.mat").write_bytes((f / "aa3_gpsx.mat").read_bytes()),
            "is incomplete, or has been changed: KeyError 'time'",
        ),
    ],
)
def test_what_is_wrong_with_the_files_is_one_line(tmp_path, capsys, break_it, message):
    park(tmp_path, seconds=3.0)
    break_it(tmp_path)
    assert victoria_park.main([str(tmp_path)]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert message in said.err
    assert said.err.count("\n") == 1


def test_the_command_writes_a_map_and_figures(tmp_path, capsys):
    park(tmp_path, seconds=12.0)
    wanted = ["--scans", "50", "--svg", str(tmp_path / "new" / "map.svg"), "--json", str(tmp_path / "result.json")]
    assert victoria_park.main([str(tmp_path), *wanted]) == 0
    assert "a rotation and a translation fitted" in capsys.readouterr().out
    assert (tmp_path / "new" / "map.svg").read_text().endswith("</svg>\n")
    result = json.loads((tmp_path / "result.json").read_text())
    assert result["scans"] == 50
    assert len(result["data"]) == 16
    assert "gps" not in result
    for few in ("1", "2"):
        assert victoria_park.main([str(tmp_path), "--scans", few]) == 2
    with pytest.raises(SystemExit) as stop:
        victoria_park.main(["--help"])
    assert stop.value.code == 0
    assert "--svg map.svg" in capsys.readouterr().out


def test_without_scipy_it_says_what_to_install(tmp_path, monkeypatch):
    park(tmp_path, seconds=3.0)
    monkeypatch.setitem(__import__("sys").modules, "scipy.io", None)
    with pytest.raises(SlamlibError, match=r"pip install 'slamlib\[fast\]'"):
        victoria_park.load(tmp_path)


def scan_of(*trees):
    values = np.array(trees, float).reshape(-1, 2)
    return Scan({"points": Features(np.arange(len(values)), values)})


def stand(slam, number, *trees):
    """The car stands, and measures trees (range, yaw)."""
    return slam.step(Frame(number, 0.2, (Control(np.zeros(2), 1e-8 * np.eye(2)),), (scan_of(*trees),)))


def test_a_tree_is_initialized_when_it_was_measured_three_times_and_matched_with_its_nearest_only():
    slam = victoria_park.park_slam()
    assert [len(stand(slam, n, (10, 0.1)).initialized) for n in range(3)] == [0, 0, 1]
    for number in range(3, 20):
        assert not stand(slam, number, *([(10, 0.1)] if number % 2 else [])).initialized
    assert not stand(slam, 20, (10, 0.1), (10.2, 0.1)).initialized  # twice the same tree: the nearer one is matched
    (prediction,) = slam.predictions[0]
    assert prediction.measured == pytest.approx([10, 0.1])
    assert prediction.landmark.inliers > 8
    for number in range(21, 30):  # between the two gates it is neither the tree nor a new one
        assert not stand(slam, number, (11.5, 0.1)).initialized
        assert not slam.predictions[0][0].matched
    assert slam.front_ends[0].limits == pytest.approx((9.21, 27.63), abs=0.01)
