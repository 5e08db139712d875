"""The whole filter: every preset runs, is consistent, and manages its map as its options specify."""

import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.evaluation.consistency import band, rmse, share_inside
from slamlib.experiments.presets import PRESETS, preset
from slamlib.geometry.pose import Pose
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.landmarks import LINES, POINTS
from slamlib.observation.lines import RESIDUALS
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.tests.compared import ORIENTATION, POSITION, compared, is_healthy, shaken


def is_right(found, *, pose=0.5, map=0.2):
    """The map's error is a small share of what it was at first, the poses' of dead reckoning's; and each is believable.

    Without measurements all these shares are 1, and with a Jacobian of the wrong sign above.
    """
    is_healthy(found.slam)
    assert np.isfinite(found.first_map_errors).all()
    assert found.map_ratio < map
    for i, dof in enumerate(found.slam.rig.dof):
        assert np.nanmax(found.nees[:, i]) < chi2_quantile(1 - 1e-6, dof)
        assert found.ratio(POSITION, i) < pose
        assert found.ratio(ORIENTATION, i) < pose
    assert (found.sigma < pose * found.reckoned_sigma).all()


# Presets whose measurements tell at once where a landmark is: what SLAM adds shows when the loop is closed.
WHOLE = {name: {"turns": 1.0, "seed": 2} for name in ("plane", "five_minutes")}


@pytest.mark.parametrize("name", PRESETS)
@pytest.mark.parametrize("reproject", [True, False])
def test_every_preset_runs_and_finds_its_way(name, reproject):
    p = preset(name)
    change = WHOLE.get(name, {"turns": 10.0, "frames": 40})
    found = compared(shaken(p, **change, options=replace(p.options, reproject=reproject)))
    assert len(found.slam.landmarks) >= min(10, len(p.world.points) + len(p.world.segments))
    # The edges of one house, of which one is new in each frame, say less of the pose than points all around; in the
    # plane wheels say more, and a point's range and bearing place it at once.
    is_right(found, pose=0.95 if name == "lines" or name in WHOLE else 0.5, map=0.7 if name in WHOLE else 0.2)


@pytest.mark.parametrize("kind", POINTS)
def test_every_point_serves(kind):
    in_plane = POINTS[kind].plane
    p, change = (preset("plane"), WHOLE["plane"]) if in_plane else (preset("points"), {"frames": 40})
    found = compared(shaken(p, **change, options=replace(p.options, points=kind, convert=False)))
    assert {lm.kind.name for lm in found.slam.landmarks} == {kind}
    if kind == "eucPnt":  # of a new point its depth is no Gaussian in metres: the filter is far too sure
        is_healthy(found.slam)
        assert max(found.map_ratio, found.ratio(ORIENTATION)) < 0.6
        assert found.ratio(POSITION) < 0.9
    else:
        is_right(found, pose=0.95 if in_plane else 0.5, map=0.7 if in_plane else 0.2)


@pytest.fixture(scope="module")
def of_lines():
    """A run of every parametrization with every innovation, each with random numbers of its own."""
    p, found = preset("lines"), {}
    for seed, (kind, innovation) in enumerate(itertools.product(LINES, RESIDUALS), 1):
        options = replace(p.options, lines=kind, innovation=innovation, max_new=2)
        found[kind, innovation] = compared(replace(p, seed=seed, frames=40, options=options))
    return found


@pytest.mark.parametrize("kind", LINES)
@pytest.mark.parametrize("innovation", RESIDUALS)
def test_every_line_serves_with_every_innovation(kind, innovation, of_lines):
    found = of_lines[kind, innovation]
    is_healthy(found.slam)
    assert len(found.slam.landmarks) >= 15
    assert np.median(found.first_map_errors) > 5  # [m]; the house is ten metres long
    assert np.median(found.map_errors) < 0.15
    assert found.nees.max() < chi2_quantile(1 - 1e-6, 6)


def test_lines_are_consistent(of_lines):
    """NEES of the pose, 6 degrees of freedom, averaged over 15 independent runs, each of other lines."""
    average = np.mean([found.nees[:, 0] for found in of_lines.values()], axis=0)
    low, high = band(6, len(of_lines), 0.999)
    inside = share_inside(average, (low, high))
    assert inside > 0.8, f"{inside:.0%} of 40 steps inside [{low:.2f}, {high:.2f}], 6 dof, 15 runs"
    errors, reckoned = (
        rmse(np.stack([getattr(f, name)[:, 0, ORIENTATION] for f in of_lines.values()]))
        for name in ("errors", "reckoned")
    )
    assert errors < reckoned


@pytest.mark.parametrize("reproject", [True, False])
def test_twenty_runs_are_consistent_at_first(reproject):
    p = replace(preset("points"), frames=40)
    p = replace(p, options=replace(p.options, reproject=reproject))
    runs = [compared(p, rng) for rng in np.random.default_rng(14).spawn(20)]
    low, high = band(6, 20)
    inside = share_inside(np.mean([found.nees[:, 0] for found in runs], axis=0), (low, high))
    assert inside > 0.8, f"{inside:.0%} of 40 steps inside [{low:.2f}, {high:.2f}], 6 dof, 20 runs"

    # Dead reckoning is as consistent as that: what the measurements are worth is how small the errors are.
    for part in (POSITION, ORIENTATION):
        assert rmse(np.array([found.errors[:, 0, part] for found in runs])) < 0.75 * rmse(
            np.array([found.reckoned[:, 0, part] for found in runs])
        )
    assert max(found.map_ratio for found in runs) < 0.1
    first = [point_nees(found.slam, p.world) for found in runs]  # one of each run: they are independent
    low, high = band(3, 20, 0.999)
    assert low < np.mean(first) < high, f"{np.mean(first):.2f} is outside [{low:.2f}, {high:.2f}], 3 dof, 20 runs"


def point_nees(slam, world):
    """NEES of the map's oldest point, which is a Euclidean one by now."""
    shown = slam.snapshot().points
    assert shown.converged[0]
    e = shown.geometry[0] - world.points.values[world.points.ids == shown.ids[0]][0]
    return e @ np.linalg.solve(shown.covariance[0], e)


def test_lines_see_the_same_with_every_innovation():
    """To first order the three line residuals carry the same information: from one state they lead to one estimate."""
    p = preset("lines")
    options = replace(p.options, max_new_first=15, max_new=0, updates=50, reproject=False, gate=1.0)
    p = shaken(p, frames=40, options=options)
    slam, (*frames, last) = p.slam(), [frame for frame, _ in p.simulate()]
    for frame in frames:
        slam.step(frame)
    before = slam.belief.snapshot()
    slam.predict(last.controls, last.dt)
    reckoned, alone = slam.robots[0].pose, slam.belief.covariance(slam.robots[0].block)
    found = []
    for innovation in RESIDUALS:
        slam.belief.restore(before)
        slam.options = replace(options, innovation=innovation)
        slam.step(last)
        found.append((Pose.minus(slam.robots[0].pose, reckoned), alone - slam.belief.covariance(slam.robots[0].block)))
    (told, gained), *others = found
    for other, gain in others:
        for part in (POSITION, ORIENTATION):
            assert np.linalg.norm((other - told)[part]) < np.linalg.norm(told[part]) / 30
        assert np.abs(gain - gained).max() < np.abs(gained).max() / 30


def test_batch_and_sequence_agree_where_the_noise_is_small():
    p = preset("points")
    small = SensorSetup(type="relativePosition", std=(1e-4,), limits={"far": 10.0})
    robot = replace(p.rig.robots[0], control_std=(1e-3,) * 3 + (0.01,) * 3)
    ends = []
    for reproject in (True, False):
        options = replace(p.options, points="eucPnt", reproject=reproject)
        ends.append(compared(replace(p, rig=Rig((robot,), (small,)), frames=3, options=options)))
    one, other = (found.errors[-1, 0] for found in ends)
    told = ends[0].reckoned[-1, 0] - one  # what the measurements changed
    for part in (POSITION, ORIENTATION):
        assert np.linalg.norm((one - other)[part]) < np.linalg.norm(told[part]) / 50
        assert ends[0].ratio(part) < 0.6


def test_the_map_of_self_calibration_holds_the_extrinsics():
    p = replace(preset("self_calibration"), frames=80)
    found = compared(p)
    sensor = found.slam.sensors[1]
    P = found.slam.belief.covariance(sensor.block)
    e = Pose.minus(found.truth.extrinsics[1], sensor.extrinsics)
    first = np.sqrt(p.rig.sensors[1].covariance.diagonal())
    assert (np.sqrt(P.diagonal())[3:] < first[3:] / 10).all()
    assert e @ np.linalg.solve(P, e) < chi2_quantile(0.9999, 6)


def test_two_robots_share_one_map():
    found = compared(replace(preset("two_robots"), frames=150))
    robots = found.slam.robots
    cross = found.slam.belief.covariance(robots[0].block, robots[1].block)
    assert np.abs(cross).max() > 0
    assert found.nees[-1].max() < chi2_quantile(1 - 1e-6, 6)
    for i in (0, 1):
        assert found.ratio(POSITION, i) < 0.6
        assert found.ratio(ORIENTATION, i) < 0.6
    assert found.map_ratio < 0.1


def test_constant_velocity_needs_no_control():
    flying = RobotSetup(
        motion="constVel", velocity=(1, 0, 0, 0, 0, 10), velocity_std=(0.1, 0.1, 0.1, 1, 1, 1),
        control_std=(0.01, 0.01, 0.01, 0.1, 0.1, 0.1), position=(0, -5, 0),
    )  # fmt: skip
    p = replace(preset("stereo"), frames=60, noise_in="truth")
    p = replace(p, rig=Rig((flying,), p.rig.sensors))
    found = compared(p, frame=lambda frame: replace(frame, controls=(None,)))
    assert found.slam.robots[0].block.dof == 12
    is_right(found)


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
    found = compared(shaken(p))
    assert len(found.slam.landmarks) >= 20
    is_right(found, pose=0.7, map=0.7)  # from the first measurement on, a point is known to centimetres


def test_outliers_are_gated_and_do_not_break_the_filter():
    p = preset("points")
    faults = replace(p.faults, outlier=0.1, miss=0.1)
    found = compared(shaken(p, frames=60, faults=faults))
    assert sum(lm.matched - lm.inliers for lm in found.slam.landmarks) > 20
    is_right(found)


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
