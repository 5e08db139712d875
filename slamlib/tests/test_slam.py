"""The whole filter: every preset runs, is consistent, and manages its map as its options specify."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.data.records import Control, Features, Frame, Scan
from slamlib.data.setup import Rig, RobotSetup, SensorSetup
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.evaluation.consistency import band
from slamlib.experiments.presets import PRESETS, preset
from slamlib.geometry.pose import Pose
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.landmarks import LINES, POINTS
from slamlib.observation.lines import RESIDUALS
from slamlib.slam import Options, Slam


def error_of(slam, truth, robot=0):
    return Pose.minus(truth.robots[robot][:7], slam.robots[robot].pose)


def nees_of(slam, truth, robot=0):
    e = error_of(slam, truth, robot)
    return float(e @ np.linalg.solve(slam.belief.covariance(slam.robots[robot].block)[:6, :6], e))


def run(experiment, *, rng=None):
    """The filter after all frames, the robot's NEES at each, and the last truth."""
    slam, statistic = experiment.slam(), []
    truth = None
    for frame, truth in experiment.simulate(rng):
        slam.step(frame)
        statistic.append(nees_of(slam, truth))
    return slam, np.array(statistic), truth


def is_healthy(slam):
    """P is symmetric and positive semi-definite, and the blocks fill its rows without a gap."""
    P = slam.belief.matrix
    assert np.array_equal(P, P.T)
    assert np.linalg.eigvalsh(P).min() > -1e-9 * P.max()
    rows = [i for block in slam.belief.blocks for i in range(block.slice.start, block.slice.stop)]
    assert rows == list(range(len(P)))
    known = {id(block) for block in slam.belief.blocks}
    assert {id(lm.block) for lm in slam.landmarks} <= known
    assert all(lm.block.manifold.size == lm.kind.manifold.size for lm in slam.landmarks)


@pytest.mark.parametrize("name", PRESETS)
@pytest.mark.parametrize("reproject", [True, False])
def test_every_preset_runs_and_finds_its_way(name, reproject):
    p = preset(name)
    slam, statistic, truth = run(replace(p, frames=60, options=replace(p.options, reproject=reproject)))
    is_healthy(slam)
    assert len(slam.landmarks) >= 10
    assert np.linalg.norm(error_of(slam, truth)[:3]) < 0.15  # 4.8 m of path
    assert statistic.max() < chi2_quantile(1 - 1e-6, 6)


@pytest.mark.parametrize("kind", POINTS)
def test_every_point_serves(kind):
    p = preset("points")
    slam, _, _ = run(replace(p, frames=40, options=replace(p.options, points=kind, convert=False)))
    is_healthy(slam)
    assert {lm.kind.name for lm in slam.landmarks} == {kind}


@pytest.mark.parametrize("kind", LINES)
@pytest.mark.parametrize("innovation", RESIDUALS)
def test_every_line_serves_with_every_innovation(kind, innovation):
    p = preset("lines")
    options = replace(p.options, lines=kind, innovation=innovation, max_new=2)
    slam, _, truth = run(replace(p, frames=40, options=options))
    is_healthy(slam)
    assert len(slam.landmarks) >= 15
    assert np.linalg.norm(error_of(slam, truth)[:3]) < 0.1


@pytest.mark.parametrize("reproject", [True, False])
def test_twenty_runs_are_consistent_at_first(reproject):
    p = replace(preset("points"), frames=60)
    p = replace(p, options=replace(p.options, reproject=reproject))
    streams = np.random.default_rng(14).spawn(20)
    statistic = np.array([run(p, rng=rng)[1] for rng in streams])
    low, high = band(6, 20)
    average = statistic.mean(0)
    inside = np.mean((average >= low) & (average <= high))
    assert inside > 0.8, f"{inside:.0%} of 60 steps inside [{low:.2f}, {high:.2f}], 6 dof, 20 runs"


def test_lines_see_the_same_with_every_innovation():
    """To first order the three line residuals carry the same information: after some frames the estimates agree."""
    p = replace(preset("lines"), frames=25)
    poses = [run(replace(p, options=replace(p.options, innovation=i)))[0].robots[0].pose for i in RESIDUALS]
    sigma = 0.02
    assert np.abs(poses[1] - poses[0]).max() < sigma / 3
    assert np.abs(poses[2] - poses[0]).max() < sigma / 3


def test_batch_and_sequence_agree_where_the_noise_is_small():
    p = preset("points")
    camera = replace(p.rig.sensors[0], std=(1e-3,))
    robot = replace(p.rig.robots[0], control_std=(1e-6,) * 6)
    options = replace(p.options, points="eucPnt", inverse_distance=(0.2, 1e-4), gate=0.999999999)
    endpoints = []
    for reproject in (True, False):
        q = replace(p, rig=Rig((robot,), (camera,)), frames=3, options=replace(options, reproject=reproject))
        slam = q.slam()
        for frame, _ in q.simulate():
            slam.step(Frame(frame.number, frame.dt, frame.controls, frame.scans))
        endpoints.append(slam)
    assert np.allclose(endpoints[0].robots[0].pose, endpoints[1].robots[0].pose, atol=1e-6)


def test_the_map_of_self_calibration_holds_the_extrinsics():
    p = replace(preset("self_calibration"), frames=80)
    slam, _, truth = run(p)
    sensor = slam.sensors[1]
    P = slam.belief.covariance(sensor.block)
    e = Pose.minus(truth.extrinsics[1], sensor.extrinsics)
    first = np.sqrt(p.rig.sensors[1].covariance.diagonal())
    assert (np.sqrt(P.diagonal())[3:] < first[3:] / 10).all()
    assert e @ np.linalg.solve(P, e) < chi2_quantile(0.9999, 6)


def test_two_robots_share_one_map():
    slam, _, truth = run(replace(preset("two_robots"), frames=150))
    cross = slam.belief.covariance(slam.robots[0].block, slam.robots[1].block)
    assert np.abs(cross).max() > 0
    assert max(nees_of(slam, truth, i) for i in (0, 1)) < chi2_quantile(1 - 1e-6, 6)


def test_constant_velocity_needs_no_control():
    flying = RobotSetup(
        motion="constVel", velocity=(1, 0, 0, 0, 0, 10), velocity_std=(0.1, 0.1, 0.1, 1, 1, 1),
        control_std=(0.01, 0.01, 0.01, 0.1, 0.1, 0.1), position=(0, -5, 0),
    )  # fmt: skip
    p = replace(preset("stereo"), frames=60, noise_in="truth")
    p = replace(p, rig=Rig((flying,), p.rig.sensors))
    slam, records = p.slam(), list(p.simulate())
    for frame, _ in records:
        slam.step(Frame(frame.number, frame.dt, (None,), frame.scans))
    truth = records[-1][1]
    is_healthy(slam)
    assert slam.robots[0].block.dof == 12
    assert nees_of(slam, truth) < chi2_quantile(0.9999, 6)


@pytest.mark.parametrize(
    ("type", "std", "image", "parameters", "limits"),
    [
        ("stereo", (1.0,), (640.0, 480.0), {"intrinsics": (320.0, 240, 320, 320), "baseline": (0.2,)}, {}),
        ("relativePosition", (0.05,), None, {}, {"far": 10.0}),
        ("rangeBearing", (0.05, 0.01, 0.01), None, {}, {"far": 10.0}),
    ],
)
def test_sensors_that_measure_all_need_no_prior(type, std, image, parameters, limits):
    p = preset("points")
    ahead = (0.0, 0.0, 0.0) if image is None else (-90.0, 0.0, -90.0)
    sensor = SensorSetup(type=type, euler=ahead, std=std, image=image, parameters=parameters, limits=limits)
    p = replace(p, rig=Rig(p.rig.robots, (sensor,)), frames=40, options=replace(p.options, points="eucPnt"))
    slam, statistic, _ = run(p)
    is_healthy(slam)
    assert len(slam.landmarks) >= 20
    assert statistic.max() < chi2_quantile(1 - 1e-6, 6)


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


def test_outliers_are_gated_and_do_not_break_the_filter():
    p = preset("points")
    faults = replace(p.faults, outlier=0.1, miss=0.1)
    slam, statistic, _ = run(replace(p, frames=100, faults=faults))
    assert sum(lm.matched - lm.inliers for lm in slam.landmarks) > 20
    assert np.median(statistic) < chi2_quantile(0.999, 6)


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


@pytest.mark.parametrize("name", ["points_and_lines", "self_calibration"])
def test_a_saved_run_goes_on_bit_for_bit(name, tmp_path):
    p = replace(preset(name), frames=60)
    frames = [frame for frame, _ in p.simulate()]
    whole, begun = p.slam(), p.slam()
    for frame in frames:
        whole.step(frame)
    for frame in frames[:25]:
        begun.step(frame)
    begun.save(tmp_path / "run.npz", note="half way")
    resumed, extra = Slam.resume(tmp_path / "run.npz")
    assert extra == {"note": "half way"}
    for frame in frames[25:]:
        resumed.step(frame)
    assert np.array_equal(whole.belief.matrix, resumed.belief.matrix)
    assert all(np.array_equal(a.mean, b.mean) for a, b in zip(whole.belief.blocks, resumed.belief.blocks, strict=True))
    assert [vars(lm)["searched"] for lm in whole.landmarks] == [vars(lm)["searched"] for lm in resumed.landmarks]
    assert (whole.number, whole.time) == (resumed.number, resumed.time)


def test_files_that_are_no_filter(tmp_path):
    for name, content in (("text", b"hello"), ("empty", b"")):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(SlamlibError, match="no slamlib filter"):
            Slam.load(tmp_path / name)
    with pytest.raises(SlamlibError, match="no such file"):
        Slam.load(tmp_path / "absent")
    slam = preset("points").slam()
    slam.save(tmp_path / "good.npz")
    data = (tmp_path / "good.npz").read_bytes()
    (tmp_path / "cut.npz").write_bytes(data[: len(data) // 2])
    with pytest.raises(SlamlibError, match="damaged"):
        Slam.load(tmp_path / "cut.npz")
    assert not list(tmp_path.glob("*partial*"))


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


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6), name=st.sampled_from(["points", "points_and_lines"]), cut=st.integers(1, 8))
def test_any_mixture_of_faults_and_forgetting_keeps_the_map_whole(seed, name, cut):
    rng = np.random.default_rng(seed)
    p = preset(name)
    miss, outlier, swap = rng.uniform(0, 0.4, 3)
    p = replace(p, frames=12, faults=replace(p.faults, miss=miss, outlier=outlier, swap=swap))
    slam = p.slam()
    for frame, _ in p.simulate(rng):
        slam.step(frame)
        if frame.number == cut and slam.landmarks:
            slam.prune(slam.landmarks[int(rng.integers(len(slam.landmarks)))])
        is_healthy(slam)
