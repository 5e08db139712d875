"""The filter manages its map as its options say, and refuses what it cannot do; options and presets are plain data."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.experiments.presets import PRESETS, preset
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.slam import Options
from slamlib.tests.compared import is_healthy

# What options do


def test_capacity_is_kept_and_reported():
    p = preset("points")
    p = replace(p, frames=30, options=replace(p.options, capacity=12))
    slam = p.slam()
    refused = []
    for frame, _ in p.simulate():
        refused += slam.step(frame).refused
        assert len(slam.landmarks) <= 12
    assert len(slam.landmarks) == 12
    assert refused


def test_new_landmarks_come_as_the_options_say():
    p = preset("points")
    p = replace(p, frames=4, options=replace(p.options, max_new_first=3, max_new=2))
    slam = p.slam()
    assert [len(slam.step(frame).initialized) for frame, _ in p.simulate()] == [3, 2, 2, 2]


def test_a_landmark_that_is_never_found_again_goes():
    p = replace(preset("points"), frames=40)
    frames = [frame for frame, _ in p.simulate()]
    slam = p.slam()
    slam.step(frames[0])
    gone = slam.landmarks[0].id
    deleted = []
    for frame in frames[1:]:
        points = frame.scans[0].points
        keep = points.ids != gone
        scan = Scan({"points": Features(points.ids[keep], points.values[keep])})
        deleted += slam.step(Frame(frame.number, frame.dt, frame.controls, (scan,))).deleted
    assert gone in deleted
    assert gone not in [lm.id for lm in slam.landmarks]
    is_healthy(slam)


def test_lines_without_a_prior_of_their_own_take_that_of_the_inverse_distance_at_both_ends():
    options = Options(inverse_distance=(0.2, 0.05))
    for name in ("ahmLin", "idpLin", "hmgLin"):
        assert options.line_prior(name) == ((0.2, 0.2), (0.05, 0.05))
    for name in ("plkLin", "aplLin"):  # 0.1 +- 0.25 and 0 +- 1
        assert options.line_prior(name) == ((0.1, 0.0), (0.25, 1.0))
    own = replace(options, line_priors={"hmgLin": ((0.3, 0.4), (0.1, 0.2))})
    assert own.line_prior("hmgLin") == ((0.3, 0.4), (0.1, 0.2))
    assert own.line_prior("plkLin") == ((0.2, 0.2), (0.05, 0.05))


# Errors


def test_frames_that_do_not_fit_are_refused_and_nothing_is_changed():
    p = preset("points")
    slam = p.slam()
    frame, _ = next(iter(p.simulate()))
    before = slam.belief.snapshot()
    bad = [
        Frame(1, 0.1, (), frame.scans),
        Frame(1, 0.1, frame.controls, ()),
        Frame(1, 0.1, (Control(np.zeros(3), np.eye(3)),), frame.scans),
        Frame(1, 0.1, frame.controls, (Scan({"points": Features([1], [[1.0, 2, 3]])}),)),
    ]
    for wrong in bad:
        with pytest.raises(SlamlibError, match="frame 1"):
            slam.step(wrong)
    after = slam.belief.snapshot()
    assert np.array_equal(before.covariance, after.covariance)
    assert slam.number == 0


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"gate": 0.0}, "gate"),
        ({"gate": 1.1}, "gate"),
        ({"updates": -1}, "updates"),
        ({"updates": 2.5}, "updates"),
        ({"capacity": 0}, "capacity"),
        ({"margin": 0.6}, "margin"),
        ({"inverse_distance": (0.1, 0.0)}, "inverse_distance"),
        ({"line_priors": {"plkLin": (0.1, 0.2)}}, "line_priors"),
        ({"reproject": "yes"}, "reproject"),
    ],
)
def test_options_that_make_no_sense(change, match):
    with pytest.raises(SlamlibError, match=match):
        Options(**change)


def test_names_that_do_not_exist_show_the_choices():
    for change in ({"points": "ahmPoint"}, {"lines": "ahmPnt"}, {"innovation": "dist"}, {"selection": "random"}):
        with pytest.raises(UnknownNameError, match="Known:"):
            Options(**change)
    with pytest.raises(UnknownNameError, match="did you mean 'points'"):
        preset("point")
    with pytest.raises(UnknownNameError, match="option"):
        Options.from_dict({"update": 3})


# Plain data, and files


@pytest.mark.parametrize("name", PRESETS)
def test_presets_are_plain_data(name, tmp_path):
    p = preset(name)
    p.save(tmp_path / "p.json")
    q = type(p).load(tmp_path / "p.json")
    assert q == p
    assert np.array_equal(q.slam().belief.matrix, p.slam().belief.matrix)


def test_a_preset_is_read_from_toml(tmp_path):
    (tmp_path / "mine.toml").write_text(
        'name = "mine"\nframes = 7\n[options]\npoints = "idpPnt"\n[[rig.robots]]\nposition = [0, -5, 0]\n'
        "[[rig.sensors]]\nimage = [640, 480]\n"
    )
    p = type(preset("points")).load(tmp_path / "mine.toml")
    assert (p.name, p.frames, p.options.points, p.rig.robots[0].position) == ("mine", 7, "idpPnt", (0, -5, 0))


def test_a_snapshot_does_not_change_later():
    p = replace(preset("points_and_lines"), frames=12)
    slam = p.slam()
    frames = [frame for frame, _ in p.simulate()]
    for frame in frames[:6]:
        slam.step(frame)
    snapshot = slam.snapshot()
    copy = snapshot.points.geometry.copy(), snapshot.robots[0].covariance.copy(), snapshot.sensors[0].points.nis.copy()
    for frame in frames[6:]:
        slam.step(frame)
    now = snapshot.points.geometry, snapshot.robots[0].covariance, snapshot.sensors[0].points.nis
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(copy, now, strict=True))
    assert snapshot.segments.geometry.shape[1:] == (2, 3)
    assert snapshot.camera(0).shape == (7,)
