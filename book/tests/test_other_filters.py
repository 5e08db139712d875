"""Chapter other_filters: FastSLAM 2.0 is right, and the file stores what the code gives."""

from dataclasses import replace

import numpy as np
import pytest
from slambook.report.angles import wrapped
from slambook.report.fastslam import FastSlam, FastSlam2
from slambook.report.planar import LOOK, MOTION, PlanarScan, drive, moved, seen, seen_by_point
from slambook.report.planar_ekf import PlanarEkf

from book.experiments import other_filters as tool
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from slamlib.evaluation.consistency import nees

RENEW = "run `make other-filters` and `python -m book.tools.notebooks run` for chapter other_filters"
TURN = np.array([0.8, 0, 2 * np.pi / 60])


def drawn(kind, data, particles, steps):
    """A filter after so many steps."""
    filter = kind(data, particles, np.random.default_rng(3))
    for u, scan in zip(data.odometry[:steps], data.scans[1:], strict=False):
        filter.step(u, scan)
    return filter


@pytest.mark.parametrize("measured", [1, 3])
def test_proposal_and_weight_are_those_of_brute_force(measured):
    """Poses drawn from the motion alone and weighted one by one: the same mean, covariance and integral."""
    data = drive(np.random.default_rng(1), 8, motion_std=MOTION, scan_std=LOOK / 2)
    filter = drawn(FastSlam2, data, 4, 6)
    scan = data.scans[7]
    known = np.flatnonzero(filter.known[scan.names])[:measured]
    scan = PlanarScan(scan.names[known], scan.z[known])
    means, covariances, logs = filter.proposal(data.odometry[6], scan)
    rng, n = np.random.default_rng(2), 200_000
    integrals = []
    for k in range(4):
        poses = moved(filter.poses[k], data.odometry[6] + MOTION * rng.standard_normal((n, 3)))
        likelihood = np.ones(n)
        for name, z in zip(scan.names, scan.z, strict=True):
            m = filter.means[k, name][None]
            H = seen_by_point(poses, m)[:, 0]
            S = H @ filter.covariances[k, name] @ H.swapaxes(-1, -2) + np.diag(data.look_std**2)
            innovation = z - seen(poses, m)[:, 0]
            innovation[:, 1] = wrapped(innovation[:, 1])
            square = (innovation * np.linalg.solve(S, innovation[..., None])[..., 0]).sum(-1)
            likelihood *= np.exp(-square / 2) / np.sqrt(np.linalg.det(S))
        integrals.append(likelihood.mean())
        mean = likelihood @ poses / likelihood.sum()
        away = poses - mean
        covariance = (likelihood * away.T) @ away / likelihood.sum()
        assert nees(means[k] - mean, covariance) < 0.03  # a sixth of a standard deviation: of the tangent
        sigmas = np.sqrt(np.diag(covariance))
        np.testing.assert_allclose(
            covariances[k] / np.outer(sigmas, sigmas), covariance / np.outer(sigmas, sigmas), atol=0.05
        )
    quotients = np.exp(logs) / integrals
    np.testing.assert_allclose(quotients / quotients.mean(), 1, rtol=0.05)


def test_without_a_measurement_the_proposal_is_the_motion():
    data = drive(np.random.default_rng(1), 4)
    filter = drawn(FastSlam2, data, 5, 3)
    nothing = PlanarScan(np.zeros(0, dtype=int), np.zeros((0, 2)))
    means, covariances, logs = filter.proposal(TURN, nothing)
    np.testing.assert_allclose(means, moved(filter.poses, TURN), atol=1e-12)
    np.testing.assert_allclose(np.linalg.det(covariances), np.prod(MOTION**2), rtol=1e-9)
    np.testing.assert_allclose(logs, logs[0], rtol=1e-9)


def test_where_nothing_bends_many_particles_are_the_kalman_filter():
    data = drive(np.random.default_rng(4), 4, motion_std=MOTION / 20, scan_std=LOOK / 20)
    filter, ekf = drawn(FastSlam2, data, 20_000, 4), PlanarEkf(data)
    for u, scan in zip(data.odometry, data.scans[1:], strict=True):
        ekf.step(u, scan)
    (x, P), (y, Q) = ekf.pose(), filter.pose()
    assert nees(y - x, P) < 0.01
    sigmas = np.sqrt(np.diag(P))
    np.testing.assert_allclose(Q / np.outer(sigmas, sigmas), P / np.outer(sigmas, sigmas), atol=0.06)
    for name, (m, C) in ekf.map().items():
        assert nees(filter.map()[name][0] - m, C) < 0.02
        np.testing.assert_allclose(np.diag(filter.map()[name][1]), np.diag(C), rtol=0.1)


def test_with_a_precise_scanner_more_particles_count():
    data = drive(np.random.default_rng(5), 40, scan_std=LOOK / 10)
    one, two = (np.mean(drawn(kind, data, 100, 40).effective[1:]) for kind in (FastSlam, FastSlam2))
    assert one < 10 < 40 < two


def test_the_same_draws_give_the_same_particles():
    data = drive(np.random.default_rng(5), 5)
    np.testing.assert_array_equal(*(drawn(FastSlam2, data, 7, 5).poses for _ in range(2)))


def test_the_filter_of_a_particle_is_seen_from_the_pose_that_was_drawn():
    data = replace(drive(np.random.default_rng(8), 3), motion_std=np.full(3, 1e-7))
    data = replace(data, odometry=np.tile(TURN, (3, 1)))
    for name, (m, C) in drawn(FastSlam2, data, 3, 3).map().items():
        other, covariance = drawn(FastSlam, data, 3, 3).map()[name]
        np.testing.assert_allclose(m, other, atol=1e-5)
        np.testing.assert_allclose(C, covariance, atol=1e-5)


# The stored file.


@pytest.fixture(scope="module")
def stored():
    return results.kept(tool.FILE)


def test_form_of_the_stored_runs_is_as_many_as_the_tool_makes(stored):
    assert (stored["runs"], stored["seeds"], stored["lost"]) == (tool.RUNS, list(tool.SEEDS), tool.LOST), RENEW
    for scene in tool.SCANNERS:
        assert set(stored[scene]) == {str(seed) for seed in tool.SEEDS}, RENEW


def test_the_first_runs_come_out_again(stored):
    kept = {
        scene: {name: {key: values[:1] for key, values in row.items()} for name, row in rows.items()}
        for scene, rows in stored["first"].items()
    }
    comes_out_again(tool.first(1), kept, RENEW)
