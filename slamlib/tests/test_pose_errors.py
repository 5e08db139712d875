"""The invariant error of a pose: the motion from the estimate to the truth, small and large, in space and plane."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.checks.jacobian import check_jacobian
from slamlib.entities.generator import generator
from slamlib.errors import SlamlibError
from slamlib.evaluation.comparison import evaluate
from slamlib.evaluation.consistency import nees_in_range
from slamlib.evaluation.pose_errors import ERRORS, invariant_error, pose_nees
from slamlib.evaluation.trajectory import Trajectory
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import five_minutes, points, self_calibration
from slamlib.experiments.runs import Run
from slamlib.geometry import pose2
from slamlib.geometry.pose import Pose, compose, exponential, inverse, logarithm
from slamlib.kalman.linalg import left_inverse
from slamlib.motions import MOTIONS, ODOMETRY
from slamlib.slam.unobservable import trade


@pytest.fixture
def rng():
    return np.random.default_rng(53)


def covariance(rng, n):
    """A random one (6, 6) of rank n, with standard deviations of some tenths."""
    A = 0.2 * rng.standard_normal((6, n))
    return A @ A.T


@pytest.mark.parametrize("rank", [6, 3])
def test_it_is_the_logarithm_of_the_motion_from_the_estimate_to_the_truth_by_the_covariance_of_that(rng, rank):
    for _ in range(20):
        true, estimate, P = Pose.random(rng), Pose.random(rng), covariance(rng, rank)
        xi = logarithm(compose(true, inverse(estimate)))
        N = generator(ODOMETRY, estimate)
        L, e = left_inverse(N), invariant_error(true, estimate)
        np.testing.assert_allclose(e, N @ xi, atol=1e-11)
        reached = compose(exponential(L @ e), estimate)
        np.testing.assert_allclose(Pose.minus(reached, true), np.zeros(6), atol=1e-11)
        if rank == 6:
            assert pose_nees(e, P)[0] == pytest.approx(xi @ np.linalg.solve(L @ P @ L.T, xi), rel=1e-8)
        else:  # an error within the range of P
            e = N @ (small := L @ P @ rng.standard_normal(6))
            assert pose_nees(e, P) == pytest.approx(nees_in_range(small, L @ P @ L.T, (3, 3)), rel=1e-8)
            assert pose_nees(e, P)[1] == rank


def test_its_derivative_by_the_pose_is_that_of_the_linear_error(rng):
    for _ in range(5):
        x = Pose.random(rng)
        L = left_inverse(generator(ODOMETRY, x))
        check_jacobian(lambda d, x=x: invariant_error(Pose.plus(x, d), x), np.eye(6), np.zeros(6))
        check_jacobian(lambda d, x=x: logarithm(compose(Pose.plus(x, d), inverse(x))), L, np.zeros(6))


def test_small_errors_have_the_linear_nees_with_an_order_of_one(rng):
    """The errors part as the square of their size, and the ratio of their NEES from 1 as the size."""
    sizes = 0.3 * 0.1 ** np.arange(4)
    for _ in range(10):
        x, d, P = Pose.random(rng), rng.standard_normal(6), covariance(rng, 6)
        apart, ratio = [], []
        for size in sizes:
            true = Pose.plus(x, size * d)
            errors = [of(true, x) for of in ERRORS.values()]
            apart.append(np.abs(errors[1] - errors[0]).max())
            linear, invariant = (pose_nees(e, P)[0] for e in errors)
            ratio.append(abs(invariant / linear - 1))
        slopes = [np.log10(np.array(each[:-1]) / each[1:]) for each in (apart, ratio)]
        assert slopes[0][1:] == pytest.approx(2, abs=0.1)
        assert slopes[1][-1] == pytest.approx(1, abs=0.1)
        assert ratio[-1] < 0.1


def test_it_takes_many_poses_at_once(rng):
    true, estimates = np.array([Pose.random(rng) for _ in range(7)]), Pose.random(rng)
    one_by_one = [invariant_error(x, estimates) for x in true]
    np.testing.assert_allclose(invariant_error(true, np.tile(estimates, (7, 1))), one_by_one, atol=1e-14)


@pytest.mark.parametrize("name", ["unicycle", "planeOdometry"])
def test_in_the_plane_it_is_the_logarithm_of_the_plane(rng, name):
    motion = MOTIONS[name]
    for _ in range(20):
        state, twist = pose2.Pose2.random(rng), rng.standard_normal(3)
        true = pose2.compose(pose2.exponential(twist), state)
        N = generator(motion, state) @ motion.free
        A = 0.3 * rng.standard_normal((3, 3))
        P, L = A @ A.T, left_inverse(N)
        there, C = motion.in_space(state, P)
        e = invariant_error(motion.pose(true), there)
        np.testing.assert_allclose(motion.pose_jacobian(state) @ N @ (motion.free.T @ lifted(twist)), e, atol=1e-11)
        nees, dof = pose_nees(e, C, motion.free)
        xi = motion.free.T @ lifted(twist)
        assert dof == 3
        assert nees == pytest.approx(xi @ np.linalg.solve(L @ P @ L.T, xi), rel=1e-7)


def lifted(twist):
    """A twist of the plane (3,) as one of space."""
    x, y, turn = twist
    return np.array([x, y, 0, 0, 0, turn])


def test_a_gaussian_of_motions_has_the_nees_of_its_numbers_however_large_they_are(rng):
    """Starts known to 30 degrees: no linear error is so distributed."""
    there = Pose.random(rng)
    N = generator(ODOMETRY, there)
    P = N @ np.diag([0.1] * 3 + [np.radians(30)] * 3) ** 2 @ N.T
    for _ in range(20):
        drawn = rng.standard_normal(6)
        true = compose(exponential(drawn * np.repeat([0.1, np.radians(30)], 3)), there)
        assert pose_nees(invariant_error(true, there), P)[0] == pytest.approx(drawn @ drawn, rel=1e-9)


def test_a_path_is_judged_by_the_error_that_its_covariances_are_said_to_be_of(rng):
    n = 60
    N = np.array([0.0, 8, 0, 1, 0, 0, 0])
    poses = Pose.plus(np.tile(N, (n, 1)), np.column_stack([np.arange(n) / 10, np.zeros((n, 5))]))
    std = np.array([0.02] * 3 + [0.01, 0.01, np.radians(25)])
    drawn = std * rng.standard_normal((n, 6))
    drawn[:7] = 0  # where the path is placed
    L = np.array([generator(ODOMETRY, pose) for pose in poses])
    truth = compose(exponential(drawn), poses)
    path = Trajectory(np.arange(n) / 10, poses, L @ np.diag(std**2) @ L.swapaxes(1, 2))
    found = {}
    for error in ERRORS:
        summary = evaluate(path, Trajectory(path.times, truth), covariance_error=error).summary["nees"]
        assert summary["error"] == error
        found[error] = summary
    beside = evaluate(path, Trajectory(path.times, truth), covariance_error="invariant")
    assert beside.summary["nees_linear"] == found["linear"]
    said = [name for name in repr(beside).splitlines() if "NEES" in name]
    assert ["invariant error" in name for name in said] == [True, False]
    assert evaluate(path, Trajectory(path.times, truth)).summary["nees_linear"] is None
    assert found["invariant"]["inside"] > 0.85
    assert found["linear"]["median"] > 5 * found["invariant"]["median"]
    assert evaluate(path, Trajectory(path.times, truth)).summary["nees"] == found["linear"]
    with pytest.raises(SlamlibError, match="unknown covariance error 'world'"):
        evaluate(path, path, covariance_error="world")


def test_extrinsics_that_are_estimated_are_judged_by_both_errors():
    """What the filter carries of them, as `error="world"`, is a motion about the robot: their invariant error."""
    p = self_calibration()
    first, second = p.rig.sensors
    second = replace(second, orientation_std=(15.0,) * 3)
    p = replace(p, frames=3, rig=replace(p.rig, sensors=(first, second)), options=replace(p.options, error="world"))
    run = Run(p)
    *_, last = run
    own, found = run.slam.sensors[1], run.result()
    moved = trade(run.slam.belief.size, own, own.block)[own.block.slice]
    N = generator(ODOMETRY, own.extrinsics)
    np.testing.assert_allclose(moved, -N, atol=1e-12)
    xi, L = logarithm(compose(last.truth.extrinsics[1], inverse(own.extrinsics))), left_inverse(N)
    nees = xi @ np.linalg.solve(L @ run.slam.belief.covariance(own.block) @ L.T, xi)
    assert found.extrinsics_nees_invariant.tolist() == pytest.approx([0, nees], rel=1e-7)
    assert found.extrinsics_nees_invariant[1] != pytest.approx(found.extrinsics_nees[1], rel=1e-4)


# -- bands: starts whose orientation is vague --------------------------------------------------------------------------


def start_known_to(p, *degrees):
    robot = replace(p.rig.robots[0], orientation_std=degrees)
    return replace(p, rig=replace(p.rig, robots=(robot,)), options=replace(p.options, error="world", reproject=False))


def space():
    p, laser = points(), {"type": "rangeBearing", "image": None, "limits": {"yaw": np.pi / 4, "pitch": np.pi / 4}}
    sensor = replace(p.rig.sensors[0], std=(0.1, np.radians(0.5), np.radians(0.5)), parameters={}, **laser)
    p = replace(p, rig=replace(p.rig, sensors=(sensor,)), options=replace(p.options, points="eucPnt"))
    return start_known_to(replace(p, frames=60, noise_in="truth"), 5.0, 5.0, 5.0)


def plane():
    return start_known_to(replace(five_minutes(), frames=80), 0.0, 0.0, 20.0)


@pytest.mark.parametrize(("p", "dof", "linear"), [(space(), 6, 1.3), (plane(), 3, 3)], ids=["space", "plane"])
def test_band_a_filter_that_keeps_the_invariant_error_is_consistent_in_it_and_not_in_the_linear_one(p, dof, linear):
    found = monte_carlo(p, 40, seed=17)
    assert found.nees_dof.max() == dof
    own = found.nees_invariant[:, 5:, 0].mean(1)
    assert abs(own.mean() - dof) < 2.5 * own.std(ddof=1) / np.sqrt(len(own))
    assert own.mean() < 1.25 * dof
    assert found.nees[:, 5:, 0].mean() > linear * dof
    assert found.consistency(error="invariant").inside > 2 * found.consistency(error="linear").inside
