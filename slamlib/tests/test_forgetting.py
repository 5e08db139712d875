"""A window of memory, and what makes room in a full map."""

import json
from dataclasses import replace

import numpy as np
import pytest

from slamlib.entities import Landmark
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.experiments.presets import preset
from slamlib.records.inputs import Features, Scan
from slamlib.slam import Options, Slam
from slamlib.slam.map_management import is_bad, out_of_window, prune_candidate

FRAMES = 90


def mark(number, seen, inliers=10):
    """A landmark with a history, in no map."""
    return Landmark(number, None, None, first_seen=1, searched=10, matched=10, inliers=inliers, last_seen=seen)


def run(frames=FRAMES, **options):
    """The filter after the frames of a preset, and its reports."""
    p = preset("points")
    p = replace(p, frames=frames, options=replace(p.options, **options))
    slam = p.slam()
    return slam, [slam.step(frame) for frame, _ in p.simulate()]


def test_the_longest_unseen_makes_room():
    rows = [mark(1, 7), mark(2, 4), mark(3, 8, inliers=0), mark(4, 4, inliers=3)]
    assert prune_candidate(rows, 9, Options(pruning="least-recently-seen")).id == 4
    assert prune_candidate(rows, 9, Options(pruning="least-reliable")).id == 3
    assert prune_candidate(rows, 9, Options()) is None


@pytest.mark.parametrize("first", [0, 5])
def test_a_new_landmark_was_last_seen_when_it_was_first_seen(first):
    """The first frame may have the number 0."""
    assert Landmark(1, None, None, first_seen=first).last_seen == first


def test_what_was_seen_in_this_frame_does_not_make_room():
    assert prune_candidate([mark(1, 9, inliers=0), mark(2, 9)], 9, Options(pruning="least-reliable")) is None


def test_a_window_counts_from_the_last_accepted_measurement():
    rows = [mark(1, 3), mark(2, 5), mark(3, 3), mark(4, 4)]  # 5, 3, 5 and exactly 4 frames ago
    assert [lm.id for lm in out_of_window(rows, 8, Options(window=4))] == [1, 3]
    assert not out_of_window(rows, 8, Options())
    assert [lm.last_seen for lm in rows] == [3, 5, 3, 4]  # asking changes nothing


def test_a_match_that_the_gate_rejects_is_no_sight_of_the_landmark():
    p = preset("points")
    p = replace(p, frames=6, options=replace(p.options, updates=100))
    slam, (*frames, last) = p.slam(), [frame for frame, _ in p.simulate()]
    for frame in frames:
        slam.step(frame)
    points, known = last.scans[0].points, {lm.id for lm in slam.landmarks}
    wrong = next(i for i, number in enumerate(points.ids.tolist()) if number in known)
    values = points.values.copy()
    values[wrong] += 40  # px
    slam.step(replace(last, scans=(Scan({"points": Features(points.ids, values)}),)))
    matched = [prediction for prediction in slam.predictions[0] if prediction.matched]
    (refused,) = (prediction for prediction in matched if not prediction.inlier)
    assert refused.landmark.id == points.ids[wrong]
    assert refused.landmark.last_seen == last.number - 1
    assert {prediction.landmark.last_seen for prediction in matched if prediction.inlier} == {last.number}


@pytest.mark.parametrize(
    ("searched", "matched", "inliers", "bad"),
    [
        (9, 0, 0, False),  # never found, but not searched for often enough to tell
        (10, 0, 0, True),
        (10, 3, 3, False),  # found in exactly the least share
        (10, 2, 2, True),
        (20, 5, 5, True),
        (10, 8, 4, False),  # an inlier in exactly the least share
        (10, 8, 3, True),
        (10, 9, 4, True),
        (9, 9, 0, False),
    ],
)
def test_what_is_searched_for_in_vain_or_often_wrong_is_bad(searched, matched, inliers, bad):
    landmark = Landmark(1, None, None, first_seen=1, searched=searched, matched=matched, inliers=inliers)
    assert is_bad(landmark, Options(min_searches=10, min_matched_ratio=0.3, min_inlier_ratio=0.5)) is bad


def test_a_landmark_out_of_the_window_is_gone():
    slam, reports = run(window=5)
    assert all(slam.number - landmark.last_seen <= 5 for landmark in slam.landmarks)
    assert sum(len(report.deleted) for report in reports) > 10
    full, _ = run()
    assert len(full.landmarks) > len(slam.landmarks) + 10


@pytest.mark.parametrize("rule", ["least-recently-seen", "least-reliable"])
def test_a_full_map_does_not_starve(rule):
    starved, _ = run(capacity=12)
    slam, reports = run(capacity=12, pruning=rule)
    assert len(slam.landmarks) <= 12
    assert max(landmark.first_seen for landmark in slam.landmarks) > max(
        landmark.first_seen for landmark in starved.landmarks
    )
    assert sum(len(report.refused) for report in reports) < FRAMES
    inliers = [sum(prediction.inlier for prediction in s.predictions[0]) for s in (starved, slam)]
    assert inliers[1] > inliers[0]


def test_defaults_change_nothing_and_are_not_written():
    assert {"window", "pruning"}.isdisjoint(Options().to_dict())
    told = Options(window=7, pruning="least-recently-seen", capacity=3)
    assert Options.from_dict(json.loads(json.dumps(told.to_dict()))) == told
    with pytest.raises(UnknownNameError, match="did you mean 'least-recently-seen'"):
        Options(pruning="least-recently-sen")


def test_a_saved_filter_remembers_when_it_saw_what(tmp_path):
    slam, _ = run(30)
    slam.save(tmp_path / "slam.npz")
    again = Slam.load(tmp_path / "slam.npz")
    assert [lm.last_seen for lm in again.landmarks] == [lm.last_seen for lm in slam.landmarks]
    assert len({lm.last_seen for lm in again.landmarks}) > 1


def test_files_of_before_are_refused_with_what_to_do(tmp_path):
    slam, _ = run(30)
    slam.save(tmp_path / "slam.npz")
    with np.load(tmp_path / "slam.npz") as file:
        arrays = dict(file)
    header = {**json.loads(str(arrays["header"])), "version": 1}
    np.savez_compressed(tmp_path / "old.npz", **{**arrays, "header": np.array(json.dumps(header))})
    with pytest.raises(SlamlibError, match=r"version 1, and this slamlib reads 4: run it anew"):
        Slam.load(tmp_path / "old.npz")
