"""Whole runs: what comes out, that it depends on the seed alone, and that misuse is named."""

import ast
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib import simulation
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import MOTIONS, odometry
from slamlib.observation.points import observe
from slamlib.records.inputs import World
from slamlib.rigs.setup import Rig
from slamlib.sensors import SENSORS
from slamlib.simulation import Faults, controls, join, simulate, world
from slamlib.tests.simulated import ALL_SENSORS, CAMERA, CLOISTER, OMNI, RANGE, STEREO, WALKER, rig_of, same_runs

WHOLE = join(CLOISTER, world("house"))


def run(rig, there=CLOISTER, frames=5, seed=1, **more):
    return list(simulate(rig, there, frames=frames, dt=0.1, rng=np.random.default_rng(seed), **more))


def test_the_first_frame_is_displaced_once_and_has_number_one():
    exact = rig_of(replace(WALKER, control_std=(0.0,) * 6))
    (frame, truth), *_ = run(exact)
    assert (frame.number, frame.dt) == (1, 0.1)
    moved = odometry.step(exact.robots[0].state, exact.robots[0].nominal, 0.1)
    assert truth.robots[0] == pytest.approx(moved, abs=1e-15)
    assert [f.number for f, _ in run(exact)] == [1, 2, 3, 4, 5]


def test_the_first_frame_sees_what_the_toolbox_saw():
    (frame, _), *_ = run(rig_of(WALKER))
    recorded = [19, 20, 24, 25, 30, 31, 32, 36, 55, 56, 60, 61, 66, 67, 68, 72]  # its run pnt_idpPnt with seed 1
    assert frame.scans[0].points.ids.tolist() == recorded


def test_without_noise_a_sensor_delivers_what_the_filter_expects():
    for sensor in ALL_SENSORS:
        exact = rig_of(WALKER, replace(sensor, std=(0.0,), noise=None))
        for frame, truth in run(exact, frames=3):
            seen = frame.scans[0].points
            points = CLOISTER.points.values[seen.ids - 1]
            calibration = exact.sensors[0].calibration
            expected = observe(POINTS["eucPnt"], calibration, truth.robots[0], truth.extrinsics[0], points)
            assert seen.values == pytest.approx(expected.value, abs=1e-10)
            assert expected.visible.all()
            everything = observe(
                POINTS["eucPnt"], calibration, truth.robots[0], truth.extrinsics[0], CLOISTER.points.values
            )
            assert len(seen) == everything.visible.sum() > 0


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32), st.sampled_from(["truth", "control"]), st.floats(0, 0.5), st.booleans())
def test_the_same_seed_gives_the_same_run(seed, noise_in, rate, occlusion):
    rig = Rig((WALKER,), (CAMERA, replace(OMNI, name="omni")))
    how = {"noise_in": noise_in, "faults": Faults(rate, rate, rate), "occlusion": occlusion}
    same_runs(run(rig, WHOLE, seed=seed, **how), run(rig, WHOLE, seed=seed, **how))


def test_other_seeds_and_other_uses_of_one_generator_give_other_runs():
    one, other = run(rig_of(WALKER), seed=1), run(rig_of(WALKER), seed=2)
    assert (one[0][1].robots[0] != other[0][1].robots[0]).any()
    rng = np.random.default_rng(1)
    first, second = (list(simulate(rig_of(WALKER), CLOISTER, frames=1, dt=1, rng=rng)) for _ in range(2))
    assert (first[0][1].robots[0] != second[0][1].robots[0]).any()


def test_the_consumer_cannot_change_what_comes():
    """Nor by using the generator, nor by dawdling, nor by running two at a time, nor by changing its own arrays."""
    rng, way = np.random.default_rng(3), controls.straight(8, 1.0)
    frames = simulate(rig_of(WALKER), CLOISTER, frames=8, dt=0.1, rng=rng, controls=[way])
    rng.standard_normal(1000)
    got = []
    for pair in frames:
        got.append(pair)
        rng.standard_normal(3)
        way += 1
        with pytest.raises(ValueError, match="read-only"):
            pair[1].robots[0][0] = 1.0
    same_runs(got, run(rig_of(WALKER), frames=8, seed=3, controls=[controls.straight(8, 1.0)]))


def test_noise_is_the_same_with_a_second_sensor_with_faults_and_in_a_longer_run():
    base = run(rig_of(WALKER), frames=6)
    more = run(Rig((WALKER,), (CAMERA, replace(CAMERA, name="second"))), frames=9, faults=Faults(miss=0.4))
    for (a, truth), (b, again) in zip(base, more, strict=False):
        assert (truth.robots[0] == again.robots[0]).all()
        kept = np.isin(a.scans[0].points.ids, b.scans[0].points.ids)
        assert (a.scans[0].points.values[kept] == b.scans[0].points.values).all()


def test_both_noise_modes_draw_the_same_noise_and_put_it_elsewhere():
    for (a, real), (b, straight) in zip(run(rig_of(WALKER)), run(rig_of(WALKER), noise_in="control"), strict=True):
        assert a.controls[0].value == pytest.approx(WALKER.nominal)
        noise = b.controls[0].value - WALKER.nominal
        assert np.abs(noise).min() > 0
        assert (a.controls[0].covariance == WALKER.noise).all()
        if a.number == 1:
            moved = odometry.step(WALKER.state, WALKER.nominal + noise, 0.1)
            assert real.robots[0] == pytest.approx(moved, abs=1e-14)
            nominal = odometry.step(WALKER.state, WALKER.nominal, 0.1)
            assert straight.robots[0] == pytest.approx(nominal, abs=1e-14)


def test_starts_and_estimated_mounts_are_drawn_with_their_deviations():
    start = replace(WALKER, position_std=(1.0, 2.0, 0.0), orientation_std=(0.0, 0.0, 3.0), control_std=(0.0,) * 6)
    free = replace(CAMERA, estimated=True, position_std=(0.1, 0.0, 0.0), orientation_std=(1.0, 1.0, 1.0))
    rig = Rig((start,), (free, replace(free, name="fixed", estimated=False)))
    still = [np.zeros((1, 6))]
    truths = [run(rig, frames=1, seed=k, controls=still)[0][1] for k in range(400)]
    for samples, mean, P in (
        ([t.robots[0] for t in truths], start.state, start.covariance),
        ([t.extrinsics[0] for t in truths], free.extrinsics, free.covariance),
    ):
        errors = Pose.minus(np.array(samples), mean)
        std = np.sqrt(np.diag(P))
        assert errors.std(0) == pytest.approx(std, rel=0.15, abs=1e-12)
        assert np.abs(errors.mean(0)) == pytest.approx(np.zeros(6), abs=4 * std.max() / 20)
    assert all((t.extrinsics[1] == rig.sensors[1].extrinsics).all() for t in truths)


def test_each_sensor_rides_on_its_robot():
    second = replace(WALKER, name="second", position=(0.0, 5.0, 0.0), euler=(0.0, 0.0, 180.0))
    rig = Rig((WALKER, second), (replace(CAMERA, std=(0.0,)), replace(CAMERA, name="b", robot=1, std=(0.0,))))
    frame, truth = run(rig, frames=1)[0]
    for j, sensor in enumerate(rig.sensors):
        seen = frame.scans[j].points
        camera = compose(truth.robots[sensor.robot], truth.extrinsics[j])
        inside = POINTS["eucPnt"].to_frame(camera, CLOISTER.points.values[seen.ids - 1])
        assert seen.values == pytest.approx(sensor.calibration.project(inside), abs=1e-12)


def test_controls_may_be_a_table_a_function_or_the_setups_own():
    second = replace(WALKER, name="second")
    rig = Rig((WALKER, second), (CAMERA,))
    got = run(rig, frames=3, controls=[lambda number: np.full(6, 0.01 * number), None])
    assert [f.controls[0].value[0] for f, _ in got] == [0.01, 0.02, 0.03]
    assert all((f.controls[1].value == WALKER.nominal).all() for f, _ in got)


def test_a_world_without_features_and_a_run_without_frames():
    frame, _ = run(rig_of(WALKER, STEREO), World(), frames=1, faults=Faults(0.5, 0.5, 0.5))[0]
    assert frame.scans[0].points.values.shape == (0, 3)
    assert frame.scans[0].segments.values.shape == (0, 4)
    assert run(rig_of(WALKER), frames=0) == []


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        ({"frames": -1}, SlamlibError, "frames is a whole number"),
        ({"frames": 2.5}, SlamlibError, "frames is a whole number"),
        ({"dt": 0.0}, SlamlibError, "dt is a time above zero"),
        ({"rng": 1}, SlamlibError, "rng is a generator, such as"),
        ({"noise_in": "thruth"}, UnknownNameError, "did you mean 'truth'"),
        ({"controls": np.zeros((5, 6))}, SlamlibError, r"one entry for each of the 1 robots.*controls=\[...\]"),
        ({"controls": [np.zeros((4, 6))]}, ShapeError, r"controls should have shape \(5, 6\) or more rows"),
        ({"controls": [np.zeros((5, 3))]}, ShapeError, r"controls should have shape \(5, 6\)"),
    ],
)
def test_misuse_is_named_at_the_call(wrong, error, message):
    good = {"frames": 5, "dt": 0.1, "rng": np.random.default_rng(1)}
    with pytest.raises(error, match=message):
        simulate(rig_of(WALKER), CLOISTER, **{**good, **wrong})


def test_segments_need_an_image_to_be_cut_at():
    with pytest.raises(SlamlibError, match="camera: segments are cut at the border of the image"):
        simulate(rig_of(WALKER, replace(CAMERA, image=None)), WHOLE, frames=1, dt=1, rng=np.random.default_rng(1))
    assert len(run(rig_of(WALKER, RANGE), WHOLE)[0][0].scans[0].segments) == 0


def test_faults_befall_segments_too():
    rig, how = rig_of(replace(WALKER, position=(-9.0, 0.5, 0.0))), {"there": world("house"), "frames": 20}
    clean, wild = run(rig, **how), run(rig, faults=Faults(outlier=1.0), **how)
    for (a, _), (b, _) in zip(clean, wild, strict=True):
        one, other = a.scans[0].segments, b.scans[0].segments
        assert (one.ids == other.ids).all()
        assert (one.values != other.values).all()
        assert CAMERA.calibration.inside(other.values.reshape(-1, 2, 2)).all()
    assert sum(len(f.scans[0].segments) for f, _ in run(rig, faults=Faults(miss=1.0), **how)) == 0
    swapped = [f.scans[0].segments for f, _ in run(rig, faults=Faults(swap=0.3), **how)]
    assert any((a.scans[0].segments.ids != b.ids).any() for (a, _), b in zip(clean, swapped, strict=True))


def test_faults_are_shares():
    for wrong in ({"miss": -0.1}, {"outlier": 1.1}, {"swap": float("nan")}):
        with pytest.raises(SlamlibError, match=f"{next(iter(wrong))} should be 0 or more and up to 1"):
            Faults(**wrong)


def test_the_simulator_knows_nothing_of_the_filter_and_names_no_type():
    folder = Path(simulation.__file__).parent
    types = {*POINTS, *LINES, *SENSORS, *MOTIONS}
    for file in folder.glob("*.py"):
        tree = ast.walk(ast.parse(file.read_text("utf-8")))
        for node in tree:
            named = getattr(node, "module", None) or ""
            assert not named.startswith(("slamlib.slam", "slamlib.belief", "slambook.scene", "slambook.figures")), file
            assert not (isinstance(node, ast.Constant) and node.value in types), file
