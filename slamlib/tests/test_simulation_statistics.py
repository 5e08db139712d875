"""The noise that is drawn has the specified covariance: chi-square tests with their degrees of freedom.

Each test would be wrong once in a thousand seeds; the seeds are fixed.
"""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.evaluation.consistency import Consistency
from slamlib.geometry.pose import Pose, relative
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.landmarks import POINTS
from slamlib.landmarks.segments import length
from slamlib.motions import CONSTANT_VELOCITY
from slamlib.observation.points import observe
from slamlib.records.inputs import World
from slamlib.rigs.setup import RobotSetup
from slamlib.simulation import Faults, controls, simulate, world
from slamlib.tests.simulated import ALL_SENSORS, CAMERA, CLOISTER, LENS, WALKER, rig_of

STILL = replace(WALKER, control=(0.0,) * 6, control_std=(0.0,) * 6)


def run(rig, there=CLOISTER, frames=5, seed=1, **more):
    return list(simulate(rig, there, frames=frames, dt=0.1, rng=np.random.default_rng(seed), **more))


def assert_covariance(errors, covariance):
    """The likelihood ratio for "zero mean, this covariance": chi-square, m (m + 1) / 2 + m degrees of freedom."""
    n, m = errors.shape
    white = np.linalg.solve(np.linalg.cholesky(covariance), errors.T).T
    mean, S = white.mean(0), np.cov(white.T, bias=True)
    statistic = n * (np.trace(S) - np.log(np.linalg.det(S)) - m + mean @ mean)
    assert statistic < chi2_quantile(0.999, m * (m + 1) // 2 + m)


@pytest.mark.parametrize("sensor", ALL_SENSORS, ids=lambda s: s.type)
def test_measurements_have_the_noise_of_the_calibration(sensor):
    """Of points so far inside the image that the border takes none away."""
    rig = rig_of(STILL, sensor)
    calibration, errors = rig.sensors[0].calibration, []
    expected = observe(POINTS["eucPnt"], calibration, STILL.state, sensor.extrinsics, CLOISTER.points.values)
    inner = calibration.inside(expected.value, margin=6 * np.sqrt(calibration.noise.max())) & expected.visible
    for frame, _ in run(rig, frames=400):
        seen = frame.scans[0].points
        kept = inner[seen.ids - 1]
        difference = calibration.sensor.manifold.minus(seen.values[kept], expected.value[seen.ids[kept] - 1])
        errors.append(difference)
        assert kept.sum() == inner.sum() > 3
    assert_covariance(np.concatenate(errors), calibration.noise)


@pytest.mark.parametrize("noise_in", ["truth", "control"])
def test_controls_differ_from_the_truth_by_the_noise_of_the_setup(noise_in):
    before, errors = WALKER.state, []
    for frame, truth in run(rig_of(WALKER), World(), frames=1000, noise_in=noise_in):
        step, before = relative(before, truth.robots[0]), truth.robots[0]
        went = np.concatenate([step[:3], Pose.minus(step, np.array([0, 0, 0, 1.0, 0, 0, 0]))[3:]])
        errors.append(frame.controls[0].value - went)
    assert_covariance(np.array(errors), WALKER.noise)


FLYER = RobotSetup(
    motion="constVel",
    position_std=(0.1, 0.1, 0.1),
    orientation_std=(1.0, 1.0, 1.0),
    velocity=(0.8, 0.0, 0.0, 0.0, 0.0, 10.0),
    velocity_std=(0.1, 0.1, 0.1, 1.0, 1.0, 1.0),
    control_std=(0.02, 0.02, 0.02, 0.2, 0.2, 0.2),
)
DRIVER = replace(WALKER, position_std=(0.05, 0.05, 0.05), orientation_std=(0.5, 0.5, 0.5))


def prediction_nees(setup, noise_in, seed, steps=30):
    """NEES (steps,) of a belief that only follows the controls."""
    belief, manifold = Belief(), setup.model.manifold
    block, nees = belief.add(manifold, setup.state, setup.covariance), []
    for frame, truth in run(rig_of(setup), World(), frames=steps, seed=seed, noise_in=noise_in):
        control = frame.controls[0]
        mean, J = setup.model.step.jac(block.mean, control.value, frame.dt)
        belief.predict(block, mean, J.state, J.control @ control.covariance @ J.control.T)
        error = manifold.minus(truth.robots[0], block.mean)
        nees.append(error @ np.linalg.solve(belief.covariance(block), error))
    return nees


@pytest.mark.parametrize("noise_in", ["truth", "control"])
@pytest.mark.parametrize("setup", [DRIVER, FLYER], ids=lambda s: s.motion)
def test_a_filter_that_only_predicts_is_consistent(setup, noise_in):
    """The NEES averaged over 200 runs lies inside its band at each of 30 steps; 6 or 12 degrees of freedom a run.

    The band is the one that all steps together leave once in a thousand seeds, or less. The share of the steps inside
    the 95 % band means little for 200 runs, since neighbouring steps are correlated.
    """
    dof = setup.model.manifold.dof
    statistic = np.array([prediction_nees(setup, noise_in, seed) for seed in range(200)])
    consistency = Consistency.of(statistic, dof, probability=1 - 0.001 / 30)
    assert consistency.inside == 1, consistency


def test_the_ends_of_cut_segments_are_off_their_line_by_the_whole_noise():
    """Chi-square of the distances, one degree of freedom for each end; noise before the cut would make it less."""
    rig = rig_of(replace(STILL, position=(-4.0, 0.0, 0.0)), replace(CAMERA, std=(2.0,), euler=(-90.0, 0.0, -80.0)))
    exact = rig_of(rig.robots[0], replace(rig.sensors[0], std=(0.0,)))
    (frame, _), *_ = run(exact, world("house"), frames=1, minimum_length=80.0)
    endpoints = frame.scans[0].segments.values.reshape(-1, 2, 2)
    image = np.array([640.0, 480.0])
    cut = ((endpoints < 1e-6) | (endpoints > image - 1e-6)).any((1, 2))
    assert cut.sum() >= 5
    along = endpoints[cut, 1] - endpoints[cut, 0]
    normal = np.stack([along[:, 1], -along[:, 0]], -1) / length(endpoints[cut].reshape(-1, 4))[:, None]
    ids, distances = frame.scans[0].segments.ids[cut], []
    for frame, _ in run(rig, world("house"), frames=300):
        seen = frame.scans[0].segments
        assert ((seen.values >= 0) & (seen.values.reshape(-1, 2, 2) <= image).reshape(-1, 4)).all()
        rows = np.array([np.flatnonzero(seen.ids == i)[0] for i in ids])
        off = ((seen.values[rows].reshape(-1, 2, 2) - endpoints[cut, :1]) * normal[:, None]).sum(-1)
        distances.append(off / 2.0)
    squares, dof = np.square(distances).sum(), np.size(distances)
    assert chi2_quantile(0.0005, dof) < squares < chi2_quantile(0.9995, dof)


def test_ends_of_segments_have_the_full_noise_of_a_lens():
    rig = rig_of(replace(STILL, position=(-9.0, 0.5, 0.0)), LENS)
    exact = rig_of(rig.robots[0], replace(LENS, noise=None, std=(0.0,)))
    (frame, _), *_ = run(exact, world("house"), frames=1)
    expected, errors = frame.scans[0].segments, []
    assert len(expected) == 23
    for frame, _ in run(rig, world("house"), frames=100):
        errors.append(frame.scans[0].segments.values - expected.values)
    errors = np.concatenate(errors)
    assert_covariance(errors, np.kron(np.eye(2), rig.sensors[0].calibration.noise))


def share_test(count, total, rate):
    """Binomial counts, by the normal distribution: one degree of freedom."""
    assert (count - total * rate) ** 2 / (total * rate * (1 - rate)) < chi2_quantile(0.999, 1)


def test_faults_come_at_their_rates():
    rig = rig_of(STILL, replace(CAMERA, std=(0.0,)))
    clean = [frame.scans[0].points for frame, _ in run(rig, frames=600)]
    total, places = sum(map(len, clean)), {tuple(v): i for i, v in zip(clean[0].ids, clean[0].values, strict=True)}
    missing = [frame.scans[0].points for frame, _ in run(rig, frames=600, faults=Faults(miss=0.2))]
    share_test(total - sum(map(len, missing)), total, 0.2)
    wild = [frame.scans[0].points for frame, _ in run(rig, frames=600, faults=Faults(outlier=0.1))]
    outliers = np.concatenate([w.values[(w.values != c.values).any(1)] for w, c in zip(wild, clean, strict=True)])
    share_test(len(outliers), total, 0.1)
    counts = np.histogram2d(*outliers.T, bins=4, range=[[0, 640], [0, 480]])[0]
    expected = len(outliers) / 16  # uniform in the image: 16 cells, 15 degrees of freedom
    assert ((counts - expected) ** 2 / expected).sum() < chi2_quantile(0.999, 15)
    traded = [frame.scans[0].points for frame, _ in run(rig, frames=600, faults=Faults(swap=0.05))]
    wrong = sum(places[tuple(v)] != i for t in traded for i, v in zip(t.ids, t.values, strict=True))
    assert wrong / total == pytest.approx(0.05, abs=0.01)  # a trade makes two: no binomial count
    assert all(sorted(t.ids) == sorted(c.ids) for t, c in zip(traded, clean, strict=True))


@pytest.mark.parametrize("sensor", ALL_SENSORS, ids=lambda s: s.type)
def test_outliers_are_measurements_that_the_sensor_could_have_made(sensor):
    rig = rig_of(STILL, sensor)
    calibration = rig.sensors[0].calibration
    values = np.concatenate([f.scans[0].points.values for f, _ in run(rig, frames=10, faults=Faults(outlier=1.0))])
    assert calibration.inside(values).all()
    open_numbers = len(calibration.sensor.back_project.arguments) - 1 - len(calibration.sensor.parameters)
    points, _ = calibration.back_project_jac(values, *[np.full((len(values), 1), 0.1)] * open_numbers)
    assert calibration.visible(points).all()
    assert values.std(0).min() > 3 * np.sqrt(calibration.noise.max())


def test_a_wandering_flyer_and_one_that_flies_straight():
    straight = run(rig_of(replace(FLYER, velocity_std=(0.0,) * 6)), World(), frames=30, noise_in="control")
    speeds = np.array([truth.robots[0][7:] for _, truth in straight])
    assert (speeds == speeds[0]).all()
    wandering = run(rig_of(FLYER), World(), frames=30)
    assert (np.diff([truth.robots[0][7:] for _, truth in wandering], axis=0) != 0).all()
    assert CONSTANT_VELOCITY.manifold.size == len(wandering[0][1].robots[0])
    pushed = run(rig_of(FLYER), World(), frames=2, controls=[controls.straight(2, 2.0)], noise_in="control")
    assert pushed[1][1].robots[0][7] - pushed[0][1].robots[0][7] == pytest.approx(1.0)
