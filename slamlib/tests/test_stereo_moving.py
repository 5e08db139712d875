"""Where the prediction comes from: nothing is used twice, by Monte Carlo; and the three ways on pictures."""

import json
from dataclasses import replace

import numpy as np
import pytest
from slambook.stereo_films import stereo_film

from slamlib.entities.state import KindRows
from slamlib.evaluation.consistency import nees
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.motions import ODOMETRY
from slamlib.observation.family import viewpoint
from slamlib.plain_data.fields import read, written
from slamlib.records.inputs import Control
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Options, Slam
from slamlib.tests.shared_noise import derivatives
from slamlib.tests.stereo import MOUNT, calibration, points_seen, seen_from
from slamlib.tests.stereo_points import run, simulate
from slamlib.vision.stereo import MOTION_SOURCES
from slamlib.vision.stereo.fitting import fit
from slamlib.vision.stereo.motion_source import INFLATION, CorrelatedFeatures, MotionFallback
from slamlib.vision.stereo.odometry import checkerboard_half

pytest.importorskip("cv2", reason="OpenCV is not installed")
RUNS, STEPS, POINTS, STD = 40, 5, 48, 0.1
OPTIONS = Options(points="eucPnt", updates=40, max_new_first=40, max_new=5, reproject=False)


@pytest.fixture(scope="module")
def averages():
    """NEES / 6 at each step (STEPS - 1,), the mean of the runs, by the way to move."""
    data = [simulate(np.random.default_rng(seed), STEPS, POINTS, STD) for seed in range(RUNS)]
    names = (
        "twice",
        "constant-velocity",
        "covariance-intersection",
        "split-features",
        "split-features, each pair once",
        "correlated",
        "correlated, half of it mapped",
    )
    found = {name: np.mean([nees(*run(name, d, STD)) for d in data], axis=0) / 6 for name in names}
    low, high = (chi2_quantile(p, 6 * RUNS) / (6 * RUNS) for p in (0.025, 0.975))
    for name, mean in found.items():
        print(f"{name}: {mean.round(2)}, {((mean > low) & (mean < high)).mean():.0%} in [{low:.2f}, {high:.2f}]")
    return found


@pytest.mark.parametrize(
    "name", ["constant-velocity", "split-features, each pair once", "correlated", "correlated, half of it mapped"]
)
def test_what_uses_nothing_twice_is_consistent(averages, name):
    low, high = (chi2_quantile(p, 6 * RUNS) / (6 * RUNS) for p in (0.0005, 0.9995))
    assert (averages[name] > low).all()
    assert (averages[name] < high).all()


def test_the_same_matches_twice_are_not(averages):
    """E21: at the first step everything is known twice."""
    high = chi2_quantile(0.9995, 6 * RUNS) / (6 * RUNS)
    assert averages["twice"][0] > 1.8
    assert (averages["twice"] > high).all()


def test_covariance_intersection_is_never_too_sure(averages):
    """Half the NEES of all matches twice; not exactly, since by larger deviations more matches agree."""
    low, high = (chi2_quantile(p, 6 * RUNS) / (6 * RUNS) for p in (0.0005, 0.9995))
    np.testing.assert_allclose(2 * averages["covariance-intersection"], averages["twice"], rtol=0.01)
    assert low < averages["covariance-intersection"][0] < high
    assert (averages["covariance-intersection"] < high).all()


def test_a_doubled_block_diagonal_bounds_any_cross_covariance():
    """2 diag(A, B) - [[A, C], [C', B]] = [[A, -C], [-C', B]], which is a covariance, too: of a and -b."""
    for J in np.random.default_rng(7).normal(size=(20, 9, 9)):
        joint = J @ J.T
        bound = np.zeros((9, 9))
        bound[:6, :6], bound[6:, 6:] = 2 * joint[:6, :6], 2 * joint[6:, 6:]
        assert np.linalg.eigvalsh(bound - joint).min() > -1e-9


def test_inflated_variances_are_the_filter_s_and_the_odometry_s():
    sensor = SensorSetup(type="stereo", image=(320, 240), std=(0.1, 0.2, 0.3), parameters=calibration(0.1).given)
    rig = MOTION_SOURCES["covariance-intersection"].inflated(Rig((RobotSetup(),), (sensor,)))
    np.testing.assert_allclose(rig.sensors[0].calibration.noise, np.diag([0.02, 0.08, 0.18]))


def test_halves_are_a_little_too_cautious(averages):
    """The noise of one pair is in two controls, once with each sign: it cancels, and the filter adds it up."""
    assert 0.7 < averages["split-features"][1:].mean() < 0.97
    assert averages["split-features"].max() < chi2_quantile(0.9995, 6 * RUNS) / (6 * RUNS)


def test_a_control_of_landmarks_alone_tells_nothing():
    """With the cross-correlation modelled, it is worth as much as one of infinite covariance."""
    data = simulate(np.random.default_rng(1), STEPS, POINTS, 0.01)
    modelled, nothing, twice = (run(name, data, 0.01) for name in ("correlated", "nothing told", "twice"))
    for a, b in zip(modelled[1], nothing[1], strict=True):
        spread = np.sqrt(np.diag(b))
        np.testing.assert_allclose(a / np.outer(spread, spread), b / np.outer(spread, spread), atol=0.01)
    assert np.abs(modelled[0] - nothing[0]).max() < 0.05 * np.abs(nothing[0]).max()
    assert np.trace(twice[1][-1]) < 0.8 * np.trace(nothing[1][-1])


def test_the_fit_s_derivatives():
    """Against the fit itself, moved a little; and they give its covariance."""
    rng, made = np.random.default_rng(2), calibration(0.1)
    points = points_seen(rng, 12, MOUNT)
    pose = ODOMETRY.step(ORIGIN, np.array([0.05, 0.02, -0.01, 0.01, -0.02, 0.03]), 1.0)
    old, new = (seen_from(points, p, MOUNT) for p in (ORIGIN, pose))
    inliers = np.ones(12, dtype=bool)
    by_old, by_new = derivatives(made, MOUNT, old, new, pose)
    for i, j in ((0, 0), (3, 1), (7, 2)):
        step = np.zeros((12, 3))
        step[i, j] = 1e-4
        for by, moved in ((by_old, (old + step, new)), (by_new, (old, new + step))):
            found = Pose.minus(fit(made, MOUNT, *moved, pose, inliers).pose, pose) / 1e-4
            np.testing.assert_allclose(found, by[i, :, j], rtol=0.02, atol=1e-5)
    both = np.concatenate([by_old, by_new])
    covariance = (both @ made.noise @ both.swapaxes(-1, -2)).sum(0)
    np.testing.assert_allclose(covariance, fit(made, MOUNT, old, new, pose, inliers).covariance, rtol=1e-6, atol=1e-12)


def test_the_motion_fallback_is_the_last_motion_with_a_large_covariance():
    steady = MotionFallback()
    assert np.sqrt(steady.extrapolate(0.1).covariance[0, 0]) == 1.0  # of an unknown motion: a metre
    known = Control(np.array([0.10, 0, 0, 0, 0, 0.010]), 1e-6 * np.eye(6))
    for share in (1.0, 1.2, 1.0, 1.2):
        steady.record(replace(known, value=share * known.value), 0.1)
    lost = [steady.extrapolate(0.1) for _ in range(2)]
    np.testing.assert_allclose(lost[0].value, 1.2 * known.value)
    np.testing.assert_allclose(lost[0].covariance[0, 0], INFLATION * 0.02**2 / 3)
    np.testing.assert_allclose(lost[1].covariance, 2 * lost[0].covariance)
    again = read(MotionFallback, json.loads(json.dumps(written(steady))))
    np.testing.assert_array_equal(again.extrapolate(0.2).covariance, steady.extrapolate(0.2).covariance)


# On pictures


@pytest.fixture(scope="module")
def film():
    return stereo_film(14, std=0.1)


def started(film, name):
    """A filter at the pose of the first pair, and its motion source."""
    rig, frames, _ = film
    motion_source = MOTION_SOURCES[name](rig.sensors[0].calibration, rig.sensors[0].extrinsics)
    slam = Slam(
        Rig((replace(rig.robots[0], motion=motion_source.motion),), rig.sensors),
        options=OPTIONS,
        front_ends=[motion_source.front_end],
    )
    block = slam.robots[0].block
    block.mean = frames[0][1].robots[0][: len(block.mean)]
    return slam, motion_source


def go(slam, motion_source, frames):
    """Through the frames; a row (robot's pose, control) for each."""
    rows = []
    for frame, _ in frames:
        dt = frame.dt if frame.number > 1 else 0.0
        control = motion_source.control(frame.scans[0].image, dt, slam)
        slam.step(replace(frame, dt=dt, controls=(control,)))
        rows.append((slam.robots[0].pose, control))
    return rows


@pytest.mark.parametrize("name", MOTION_SOURCES)
def test_every_way_goes_through_the_room(film, name):
    slam, motion_source = started(film, name)
    go(slam, motion_source, film[1])
    error = Pose.minus(film[1][-1][1].poses[0], slam.robots[0].pose)
    covariance = slam.belief.covariance(slam.robots[0].block)[:6, :6]
    assert sum(prediction.inlier for prediction in slam.predictions[0]) > 10  # beside the odometry the map counts
    assert np.linalg.norm(error[:3]) < 0.003  # [m], after 0.18 m
    assert nees(error, covariance) < chi2_quantile(0.9995, 6)
    assert (motion_source.found is None) == (name == "constant-velocity")


@pytest.mark.parametrize("name", MOTION_SOURCES)
def test_a_resumed_run_goes_on_exactly(film, name, tmp_path):
    whole, motion_source = started(film, name)
    go(whole, motion_source, film[1][:10])
    half, motion_source = started(film, name)
    go(half, motion_source, film[1][:6])
    half.save(tmp_path / "half.npz", motion_source=motion_source.dump())
    _, fresh = started(film, name)
    resumed, extra = Slam.resume(tmp_path / "half.npz", front_ends=[fresh.front_end])
    fresh.restore(extra["motion_source"])
    go(resumed, fresh, film[1][6:10])
    np.testing.assert_array_equal(resumed.robots[0].pose, whole.robots[0].pose)
    np.testing.assert_array_equal(resumed.belief.matrix, whole.belief.matrix)


def test_halves_share_no_measurement_with_the_control(film):
    slam, motion_source = started(film, "split-features")
    for one in film[1][:5]:
        go(slam, motion_source, [one])
        measured = np.array([prediction.measured for prediction in slam.predictions[0] if prediction.matched]).reshape(
            -1, 3
        )
        assert (checkerboard_half(measured) == 1).all()
        assert (checkerboard_half(motion_source.odometry.matched) == 0).all()


def test_a_feature_left_to_the_odometry_is_no_landmark(film):
    slam, motion_source = started(film, "correlated")
    told = 0
    for one in film[1][:8]:
        before = {landmark.id for landmark in slam.landmarks}
        go(slam, motion_source, [one])
        others = set(motion_source.front_end.reserved.tolist())
        assert others.isdisjoint(motion_source.front_end.found.values())
        values = motion_source.odometry.extractor.last.values
        new = [lm for lm in slam.landmarks if lm.id not in before]
        begun = {int(np.abs(values - seen(slam, lm)).max(1).argmin()) for lm in new}
        assert others.isdisjoint(begun)
        told += len(others)
    assert told > 50


def seen(slam, landmark):
    """The measurement (3,) of a landmark that was just initialized."""
    view, group = viewpoint(slam.sensors[0]), KindRows.of([landmark])
    return slam.families["points"].predict_batch(view, group, slam.options).value[0]


def test_a_black_picture_is_a_motion_that_nobody_could_tell(film):
    slam, motion_source = started(film, "split-features")
    go(slam, motion_source, film[1][:5])
    spread = slam.belief.covariance(slam.robots[0].block).trace()
    frame, truth = film[1][5]
    dark = replace(frame.scans[0], image=np.zeros_like(frame.scans[0].image))
    go(slam, motion_source, [(replace(frame, scans=(dark,)), truth)])
    assert motion_source.found is None
    assert slam.belief.covariance(slam.robots[0].block).trace() > 2 * spread
    go(slam, motion_source, film[1][6:12])
    assert motion_source.found is not None
    error = Pose.minus(film[1][11][1].poses[0], slam.robots[0].pose)
    assert np.linalg.norm(error[:3]) < 0.01


def test_with_landmarks_alone_all_give_the_mean_and_none_the_covariance(film, monkeypatch):
    monkeypatch.setattr(
        CorrelatedFeatures, "unmapped", lambda self, new, found, slam: np.zeros(len(found.inliers), dtype=bool)
    )
    slam, motion_source = started(film, "correlated")
    (*_, (_, control)) = go(slam, motion_source, film[1][:3])
    np.testing.assert_array_equal(control.value, motion_source.found.control.value)
    assert np.sqrt(np.trace(control.covariance)) > 50 * np.sqrt(np.trace(motion_source.found.control.covariance))
