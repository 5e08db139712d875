"""Stored figures of real recordings: complete, within bounds, and, where a recording is at hand, true again."""

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from slambook import recording_runs, recordings

from book.experiments import real_sequences, stored
from book.tests.stored_results import comes_out_again
from slamlib.datasets.public import VARIABLE, public_recordings
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.consistency import rmse
from slamlib.evaluation.trajectory import Trajectory
from slamlib.rigs import builders
from slamlib.rigs.setup import Rig

KEPT = stored.kept(real_sequences.FILE)
RENEW = "run `make real-sequences ARGS='--only {}'` and the notebooks many and your_own_data"
DATA = Path(os.environ.get(VARIABLE) or "no-data")


def found(name):
    folders = public_recordings()[name].found(DATA)
    if not folders:
        pytest.skip(f"{name} is not at hand")
    return folders[0]


def test_form_of_the_file_is_a_row_per_recording():
    assert set(KEPT) == set(real_sequences.RUNS)


@pytest.mark.parametrize("name", [name for name in KEPT if "matched" in KEPT[name] and "of" in KEPT[name]])
def test_form_of_a_run_on_pictures_is_to_the_end_or_says_why_it_stopped(name):
    row = KEPT[name]
    assert (row["frames"] == row["of"]) == (not row["stopped"])
    assert len(row["times"]) == len(row["errors"])
    assert 0 < row["matched"] <= 1
    rms = np.sqrt(np.mean(np.square(row["errors"])))
    assert rms == pytest.approx(row["ate"], rel=0.1)  # of the poses that are kept, and of all


def test_form_of_what_may_be_handed_on_has_positions():
    shown = {name for name, row in KEPT.items() if "reference" in row}
    assert shown == {"visp-cube", *real_sequences.SHIPPED}
    for name in shown:
        path, reference = (np.array(KEPT[name][key]) for key in ("path", "reference"))
        apart = np.linalg.norm(path - reference, axis=1)
        assert apart == pytest.approx(np.array(KEPT[name]["errors"]), abs=1e-3 * np.abs(reference).max())
    assert all(public_recordings()[name].licence.startswith("CC BY 4.0") for name in real_sequences.SHIPPED)


@pytest.mark.parametrize("name", ["visp-cube", "tum-fr1-xyz"])
def test_the_errors_of_a_stored_path_come_out_again(name):
    """By the alignment; the runs themselves, which need the recordings, take 3 s to minutes."""
    row = KEPT[name]
    own, true = (
        Trajectory(np.array(row["times"]), np.insert(np.array(row[key]), [3] * 4, [1, 0, 0, 0], axis=1))
        for key in ("path", "reference")
    )
    found, kept = align_trajectory(own, true, scale=not row["metric"]).position, np.array(row["errors"])
    # The positions are stored to four digits, the camera of the cube 37 units from the origin; and they are not all.
    comes_out_again(rmse(found[:, None]), rmse(kept[:, None]), RENEW.format(name), share=5e-3)


def test_stored_claim_five_robots_are_nearer_together_than_alone():
    robots = [robot["cases"] for robot in KEPT["mrclam-6"]["robots"]]
    assert len(robots) == 5
    assert all(cases["meetings"]["ate"] < 0.7 * cases["alone"]["ate"] for cases in robots)
    assert KEPT["mrclam-6"]["met"][1] > 0.98 * KEPT["mrclam-6"]["met"][0]


def test_stored_claim_smoothing_is_the_yardstick_of_the_runs_on_pictures_and_of_the_woods():
    films = [row for row in KEPT.values() if "of" in row]
    assert len(films) == 5
    for row in films:
        assert row["frames_per_second"] > 1
        assert 0.5 * row["ate"] < row["smoothing"]["ate"] < 2 * row["ate"]
        assert row["smoothing"]["converged"] == row["metric"]  # one camera's world shrinks on and on
    assert KEPT["lost-in-the-woods"]["smoothing"]["nees"]["inside"] < 0.2  # the model is wrong, not the filter


def test_stored_claim_a_judge_with_errors_and_a_calibration_with_errors_explain_most_of_nees():
    judged = {name: row["nees"] for name, row in KEPT.items() if "std" in row}
    assert len(judged) == 4
    for name, nees in judged.items():
        known = nees.get("considered", nees["reference"])
        assert known <= nees["reference"] < nees["median"]
        assert (known < 10 * nees["dof"]) == (name != "tum-fr1-rpy")  # which started from priors, and turns only
    assert {name for name, nees in judged.items() if "considered" in nees} == {"euroc-mh01", "kitti-odometry"}


def test_an_error_of_the_calibration_can_be_put_into_a_run(tmp_path):
    folder = found("kitti-odometry")
    (tmp_path / "plain").mkdir()
    (tmp_path / "wrong").mkdir()
    run, _ = real_sequences.kitti(folder, tmp_path / "plain")
    wrong, _ = real_sequences.kitti(folder, tmp_path / "wrong", {"intrinsics": (0, 0, 2.0, 0), "offset": (0.1,)})
    given, more = (r.slam.sensors[0].calibration.given["intrinsics"] for r in (run, wrong))
    assert more - given == pytest.approx([0, 0, 2.0, 0])
    assert wrong.slam.front_ends[0].settings.offset - run.slam.front_ends[0].settings.offset == pytest.approx(0.1)


def test_stored_claim_the_right_invariant_filter_alone_is_consistent_where_the_odometry_breaks_off():
    paths = KEPT["kitti-07-tracks"]["paths"]
    alone, ordinary = paths["odometry alone"], paths["ordinary filter"]
    assert ordinary["ate"] > 3 * alone["ate"]
    assert ordinary["turn_sigma"] < 0.1 * alone["turn_sigma"]
    assert ordinary["inside"] == 0
    for loop in ("no loop", "loop"):
        one, best = paths[f"filter, {loop}"], paths[f"smoothing, {loop}"]
        assert min(one["inside"], best["inside"]) > 0.8
        assert one["translation"] < 1.05 * alone["translation"]
        assert one["ate"] < 1.1 * min(alone["ate"], best["ate"])


def test_stored_claim_what_the_stars_say_of_the_filter():
    row = KEPT["starry-night"]
    assert row["nees"]["inside"] < 0.1 < 0.7 < min(row[key]["nees"]["inside"] for key in ("smoothing", "world"))
    assert abs(row["correlation"]) < 0.3 < 0.8 < KEPT["lost-in-the-woods"]["correlation"]


def test_stored_claim_a_gate_loses_the_filter_in_the_woods():
    row = KEPT["lost-in-the-woods"]
    assert row["inliers"] == 1
    assert row["gated"]["inliers"] < 0.5
    assert row["gated"]["ate"] > 20 * row["ate"]


def light(recording, count=150):
    """The first frames alone."""
    return replace(recording, frames=recording.frames[:count])


@pytest.mark.parametrize(
    ("name", "read", "largest"),
    [
        ("starry-night", recordings.starry_night, 0.15),
        ("lost-in-the-woods", recordings.woods, 0.1),
        ("mrclam-6", recordings.mrclam, 0.3),
    ],
)
def test_a_recording_is_read_so_that_a_filter_stays_near_its_truth(name, read, largest):
    recording = light(read(found(name)))
    figures, (estimate,) = recording_runs.run(recording, meetings=True, smooth=False)
    assert figures["inliers"] > 0.8
    for robot in range(len(recording.truths)):
        assert recording_runs.judged(recording, estimate, robot)["ate"] < largest


def test_the_beginning_of_a_street_comes_out_again(tmp_path):
    folder = found("kitti-odometry")
    run, reference = real_sequences.kitti(folder, tmp_path)
    run.source = run.source.part(0, 1, 5)
    for _ in run:
        pass
    assert len(run.path) == 5
    assert np.linalg.norm(run.trajectory().positions[-1] - run.trajectory().positions[0]) == pytest.approx(
        np.linalg.norm(reference.positions[4] - reference.positions[0]), rel=0.03
    )


def test_what_wheels_say_between_two_instants_is_the_motion_of_their_arc():
    times = np.arange(0, 3, 0.01)
    speed, turn = 0.2, 0.5
    a, b = (
        control.value
        for control in recordings.driven(
            np.column_stack([times, 0 * times + speed, 0 * times + turn]), np.array([0.1, 1.1, 2.6])
        )
    )
    for control, span in ((a, 1.0), (b, 1.5)):
        radius = speed / turn
        there = [radius * np.sin(turn * span), radius * (1 - np.cos(turn * span)), turn * span]
        assert control == pytest.approx(there, abs=1e-3)


def test_a_robot_that_turned_further_than_half_around_between_two_instants_is_said_to_have_done_so():
    times = np.arange(0, 30, 0.01)
    row = np.column_stack([times, 0 * times, 0 * times + 0.2])
    (control,) = recordings.driven(row, np.array([0.0, 20.0]))
    assert control.value[2] == pytest.approx(4.0, abs=1e-6)
    assert control.covariance[2, 2] == pytest.approx(20 * (recordings.SLIP[1] + recordings.BY_SPEED * 0.04))


SEEN = {"planeOdometry": [np.hypot(3.1, 1), np.arctan2(1, 3.1)], "odometry": [np.hypot(3.1, 1), np.arctan2(1, 3.1), 0]}


def two_robots(motion, extrinsics=(0.0, 0.0, 0.0)):
    """Two robots that stand, the second of which is known badly, and what the first measures of it."""
    far, measured = np.array([3.0, 1, 0, 1, 0, 0, 0]), np.array(SEEN[motion])
    starts = (
        recordings.robot_at(np.array([0.0, 0, 0, 1, 0, 0, 0]), motion, "one"),
        recordings.robot_at(far, motion, "two"),
    )
    noise = (0.1, 0.01, 0.01)[: len(measured)]
    sensors = [builders.range_bearing(noise, name=f"sensor {i}", robot=i, position=extrinsics) for i in range(2)]
    slam = recordings.Sightings([], Rig(starts, tuple(sensors)), []).slam(points="idpPnt")
    for robot in slam.robots:
        free = np.diag([0.04, 0.04, 0, 0, 0, 1e-4]) if robot.block.dof == 6 else np.diag([0.04, 0.04, 1e-4])
        slam.belief.predict(robot.block, robot.block.mean, np.eye(robot.block.dof), free)
    return slam, measured


@pytest.mark.parametrize("motion", SEEN)
def test_a_meeting_moves_both_robots_and_ties_them(motion):
    slam, measured = two_robots(motion)
    before = [robot.pose for robot in slam.robots]
    assert recording_runs.meet(slam, 0, 1, measured)
    after = [robot.pose for robot in slam.robots]
    assert after[1][0] > before[1][0]
    assert after[0][0] < before[0][0]
    assert np.abs(slam.belief.covariance(*(robot.block for robot in slam.robots))).max() > 1e-3
    assert not recording_runs.meet(slam, 0, 1, measured + 3 * np.eye(len(measured))[0])  # beyond the gate
    assert np.array_equal(slam.robots[1].pose, after[1])  # nothing changes


def test_a_meeting_in_the_plane_is_one_in_space_without_what_nobody_measures():
    found = []
    for motion in SEEN:
        slam, measured = two_robots(motion, (0.2, 0.1, 0.0))
        assert recording_runs.meet(slam, 0, 1, measured)
        P = slam.belief.matrix
        own = np.array([0, 1, 2, 3, 4, 5] if len(P) == 6 else [0, 1, 5, 6, 7, 11])
        found.append((np.array([robot.pose for robot in slam.robots]), P[np.ix_(own, own)]))
    for plane, space in zip(*found, strict=True):
        assert plane == pytest.approx(space, abs=1e-12)


def test_what_is_not_here_is_skipped_with_a_line(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    monkeypatch.setattr("sys.argv", ["real_sequences"])
    assert real_sequences.main() == 0
    assert capsys.readouterr().err.count("not here; `slamlib datasets") == len(real_sequences.RUNS)
    monkeypatch.delenv(VARIABLE)
    assert real_sequences.main() == 2
    assert "set SLAMLIB_DATA" in capsys.readouterr().err


def test_each_run_is_stored_at_once_and_not_made_again(tmp_path, monkeypatch, capsys):
    for name in ("starry-night", "lost-in-the-woods"):
        for place, file in public_recordings()[name].places.items():
            (tmp_path / place).mkdir(exist_ok=True)
            (tmp_path / place / file).touch()
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    monkeypatch.setattr(real_sequences, "FILE", tmp_path / "kept.json")
    done = []

    def ran(folder, name):
        if name == "lost-in-the-woods" and not done[1:]:
            done.append(name)
            raise KeyboardInterrupt
        done.append(name)
        return {"frames": 1}

    monkeypatch.setattr(real_sequences, "RUNS", {"starry-night": ran, "lost-in-the-woods": ran})
    monkeypatch.setattr("sys.argv", ["real_sequences"])
    with pytest.raises(KeyboardInterrupt):
        real_sequences.main()
    assert real_sequences.main() == 0
    assert done == ["starry-night", "lost-in-the-woods", "lost-in-the-woods"]
    assert json.loads((tmp_path / "kept.json").read_text()) == {name: {"frames": 1} for name in set(done)}
