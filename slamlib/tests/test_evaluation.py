"""Consistency statistics: chi-square against SciPy, NEES and NIS against their definitions, and clear errors."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError
from slamlib.evaluation.comparison import evaluate
from slamlib.evaluation.consistency import Consistency, band, nees, nees_in_range, nis, rmse, share_inside
from slamlib.evaluation.trajectory import Trajectory, write_tum
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import preset
from slamlib.experiments.runs import Run
from slamlib.geometry.pose import Pose
from slamlib.kalman.chi_square import chi2_cdf, chi2_quantile, chi2_sf
from slamlib.tests.beliefs import random_covariance

stats = pytest.importorskip("scipy.stats")

TAILS = [1e-6, 1e-4, 0.01, 0.025, 0.05]
PROBABILITIES = [*TAILS, 0.3, 0.5, 0.7, *(1 - p for p in TAILS)]


@pytest.mark.parametrize("p", PROBABILITIES)
def test_quantiles_and_probabilities_are_those_of_scipy(p):
    for dof in range(1, 1001):
        expected = stats.chi2.ppf(p, dof)
        assert chi2_quantile(p, dof) == pytest.approx(expected, rel=1e-10)
        assert chi2_cdf(expected, dof) == pytest.approx(p, rel=1e-10)


@pytest.mark.parametrize("dof", [0.5, 2.5, 6000, 100_000, 1_000_000])
def test_other_degrees_of_freedom(dof):
    for p in PROBABILITIES:
        assert chi2_quantile(p, dof) == pytest.approx(stats.chi2.ppf(p, dof), rel=1e-10)


@pytest.mark.parametrize(("p", "dof"), [(1e-12, 1), (1e-100, 4), (1e-6, 0.1), (1e-300, 3)])
def test_far_lower_tails(p, dof):
    assert chi2_quantile(p, dof) == pytest.approx(stats.chi2.ppf(p, dof), rel=1e-10)


@pytest.mark.parametrize("dof", [0.5, 1, 2, 3, 6, 40, 1000])
@pytest.mark.parametrize("tail", [1e-3, 1e-9, 1e-15, 1e-50, 1e-300])
def test_far_upper_tails_keep_ten_digits(tail, dof):
    x = stats.chi2.isf(tail, dof)
    assert chi2_quantile(tail, dof, upper=True) == pytest.approx(x, rel=1e-10)
    assert chi2_sf(x, dof) == pytest.approx(tail, rel=1e-10)
    near_one = 1 - max(tail, 1e-15)  # the tail of this double is known, too
    assert chi2_quantile(near_one, dof) == pytest.approx(stats.chi2.isf(1 - near_one, dof), rel=1e-10)


def test_both_tails_are_one():
    for x, dof in [(1e-3, 2), (3.0, 3), (5.0, 1), (700.0, 700), (40.0, 0.5)]:
        assert chi2_cdf(x, dof) + chi2_sf(x, dof) == 1.0
    assert chi2_quantile(0.3, 4, upper=True) == chi2_quantile(0.7, 4)


def test_the_ends_of_the_distribution():
    assert [chi2_sf(x, 3) for x in (-1.0, 0.0, 1e308, np.inf)] == [1, 1, 0, 0]
    assert [chi2_cdf(x, 3) for x in (-1.0, 0.0, 5e-324, 1e308, np.inf)] == [0, 0, 0, 1, 1]
    assert chi2_quantile(np.nextafter(1, 0), 3) > 70


def test_two_degrees_of_freedom_have_a_closed_form():
    assert chi2_quantile(0.95, 2) == pytest.approx(-2 * np.log(0.05), rel=1e-14)
    assert chi2_cdf(3.0, 2) == pytest.approx(1 - np.exp(-1.5), rel=1e-14)


@pytest.mark.parametrize("function", [nees, nis])
def test_normalized_squares_broadcast(function):
    rng = np.random.default_rng(5)
    P = np.stack([random_covariance(rng, 3) for _ in range(4)])
    e = rng.standard_normal((5, 4, 3))
    found = function(e, P)
    assert found.shape == (5, 4)
    assert np.allclose(found[2, 3], e[2, 3] @ np.linalg.inv(P[3]) @ e[2, 3])
    assert np.allclose(function(e, P[0])[1, 1], function(e[1, 1], P[0]))
    assert function(np.ones(2), np.eye(2)) == 2


def test_nees_has_the_mean_and_the_band_it_should():
    rng = np.random.default_rng(6)
    P = random_covariance(rng, 4)
    values = nees(rng.multivariate_normal(np.zeros(4), P, (25, 2000)), P)
    result = Consistency.of(values, dof=4)
    assert result.average.mean() == pytest.approx(4, abs=0.05)
    assert result.inside == pytest.approx(0.95, abs=0.02)
    assert result.limits == band(4, 25)
    assert str(result) == (
        f"NEES: 4 degrees of freedom, 25 runs, 95% band [2.969, 5.182], {result.inside:.1%} of 2000 steps inside"
    )
    too_sure = Consistency.of(2 * values, dof=4)
    assert too_sure.inside < 0.01


def test_the_band_is_that_of_an_average_over_runs():
    low, high = band(3, 50, 0.99)
    assert low == pytest.approx(stats.chi2.ppf(0.005, 150) / 50, rel=1e-10)
    assert high == pytest.approx(stats.chi2.ppf(0.995, 150) / 50, rel=1e-10)
    assert share_inside([low, high, low - 1e-9, 3], (low, high)) == 0.75


def test_rmse():
    errors = np.array([[[3, 4], [0, 0]], [[0, 0], [6, 8]]])
    assert rmse(errors) == pytest.approx(np.sqrt((25 + 100) / 4))
    assert np.allclose(rmse(errors, 0), np.sqrt([12.5, 50]))


NAN, SKEWED = [1.0, np.nan], [[1.0, 0.5], [0, 1]]
WRONG = {
    "nees: nan": (lambda: nees(NAN, np.eye(2)), NonFiniteError, "nees: vector holds nan at index"),
    "nees: shape": (lambda: nees([1, 2, 3], np.eye(2)), ShapeError, r"needs a matrix \(..., 3, 3\), got \(2, 2\)"),
    "nees: number": (lambda: nees(1.0, 1.0), ShapeError, "nees: a vector of shape"),
    "nees: axes": (lambda: nees(np.ones((3, 2)), np.ones((4, 2, 2))), ShapeError, "leading axes .* do not match"),
    "nees: skewed": (lambda: nees([1, 2], SKEWED), CovarianceError, "nees: the covariance is not symmetric"),
    "nis: singular": (
        lambda: nis([1, 2], np.ones((2, 2))),
        CovarianceError,
        "nis: covariance is not positive definite",
    ),
    "nis: which": (
        lambda: nis([1, 2], np.stack([np.eye(2), -np.eye(2)])),
        CovarianceError,
        r"at index \(1,\) is not positive definite \(smallest eigenvalue -1\)",
    ),
    "nis: infinite": (lambda: nis([1, 2], np.diag([1, np.inf])), NonFiniteError, "holds inf at index"),
    "nis: text": (lambda: nis(["a", "b"], np.eye(2)), SlamlibError, "nis: vector should be an array of real numbers"),
    "rmse: nan": (lambda: rmse([NAN]), NonFiniteError, "rmse: errors holds nan at index"),
    "rmse: empty": (lambda: rmse(np.ones((0, 2))), ShapeError, r"rmse: .* have shape \(0, 2\)"),
    "cdf: nan": (lambda: chi2_cdf(np.nan, 2), NonFiniteError, "chi2_cdf: x is nan"),
    "cdf: dof": (lambda: chi2_cdf(1, 0), SlamlibError, "dof should be positive and finite, got 0"),
    "quantile: 1": (lambda: chi2_quantile(1, 3), SlamlibError, "between 0 and 1, got 1"),
    "quantile: dof": (lambda: chi2_quantile(0.5, np.nan), SlamlibError, "dof should be positive and finite, got nan"),
    "band: percent": (lambda: band(3, 50, 95), SlamlibError, "band: probability should lie between 0 and 1, got 95"),
    "band: signs": (lambda: band(-3, -50), SlamlibError, "band: dof should be positive"),
    "band: runs": (lambda: band(3, 0), SlamlibError, "band: runs should be positive"),
    "share: empty": (lambda: share_inside([], (0, 1)), ShapeError, "the series is empty"),
    "share: nan": (lambda: share_inside(NAN, (0, 1)), NonFiniteError, "series holds nan at index"),
    "of: shape": (lambda: Consistency.of([1, 2], 2), ShapeError, r"\(runs, steps\), but has \(2,\)"),
    "of: nan": (lambda: Consistency.of([NAN], 2), NonFiniteError, "Consistency: statistic holds nan at index"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_misuse_is_reported_clearly(wrong):
    call, error, message = WRONG[wrong]
    with pytest.raises(error, match=message):
        call()


# -- covariances that are singular, or none ----------------------------------------------------------------------------


@pytest.mark.parametrize("scale", [1, 1e-3, 1e6])
def test_nees_of_a_singular_covariance_is_that_of_what_it_leaves_open(scale):
    J = np.array([[1, 0.3], [0.2, 1], [0.5, 0.7]])  # two errors, three numbers
    for units in ((), (2, 1)):
        value, rank = nees_in_range(scale * J @ [1, 2], scale**2 * J @ J.T, units)
        assert rank == 2
        assert value == pytest.approx(5, rel=1e-9)
    value, rank = nees_in_range(scale * np.array([1.0, 2, 3]), scale**2 * (J @ J.T + 0.1 * np.eye(3)))
    assert (value, rank) == (pytest.approx(float(nees([1, 2, 3], J @ J.T + 0.1 * np.eye(3))), rel=1e-9), 3)
    assert nees_in_range(np.array([0.0, 2]), np.diag([0.0, 4])) == (1, 1)


@pytest.mark.parametrize("matrix", [[[1, 2], [2, 1]], [[1, 0], [0, -1e-3]], [[0, 0], [0, 0]], [[0, 0], [0, -1]]])
def test_what_is_no_covariance_has_no_nees(matrix):
    for units in ((), (1, 1)):
        value, rank = nees_in_range(np.array([1.0, -1]), np.array(matrix, dtype=float), units)
        assert np.isnan(value)
        assert rank == 0


def test_units_tell_rounding_from_a_small_variance():
    """An angle of 1e-8 rad beside 1 km; and beside angles of 1 rad, where it is what rounding leaves."""
    P, e = np.diag([1e6, 1e6, 1e-16]), np.array([1e3, 0, 2e-8])
    assert nees_in_range(e, P, (2, 1)) == (pytest.approx(5, rel=1e-9), 3)
    assert nees_in_range(e, P) == (pytest.approx(1, rel=1e-9), 2)


@pytest.mark.parametrize("euler", [(10.0, 20.0, 30.0), (0, 0, 0), (0, 90.0, 0), (45, 80, 10)])
def test_a_robot_that_errs_in_a_plane_of_space_has_three_degrees_of_freedom(euler):
    p = preset("points")
    robot = replace(
        p.rig.robots[0], control=(0.08, 0, 0, 0, 0, 0), control_std=(0.005, 0.005, 0, 0, 0, 0.05), euler=euler
    )
    p = replace(p, rig=replace(p.rig, robots=(robot,)), frames=40)
    found = monte_carlo(p, 10).consistency()
    assert (found.dof, found.runs) == (3, 10)
    low, high = band(3, 10, 1 - 1e-4)
    assert low < found.average[-1] < high
    result = Run(p).finish()
    assert result.dof == (3,)
    assert result.mean_nees[0] < 10
    assert "of 3" in repr(result)


def test_a_path_whose_height_is_known_exactly_is_judged_without_it(tmp_path):
    rng, n = np.random.default_rng(5), 400
    times = np.arange(n) / 10
    truth = np.column_stack([times, np.sin(times), np.zeros(n), np.ones(n), np.zeros((n, 3))])
    std = np.array([0.1, 0.2, 0, 1e-3, 2e-3, 3e-3])
    poses = Pose.plus(truth, std * rng.standard_normal((n, 6)))
    write_tum(tmp_path / "path.txt", Trajectory(times, poses, np.broadcast_to(np.diag(std**2), (n, 6, 6))))
    write_tum(tmp_path / "truth.txt", Trajectory(times, truth))
    found = evaluate(tmp_path / "path.txt", tmp_path / "truth.txt")
    assert found.summary["nees"]["dof"] == 5
    assert "NEES, 5 dof" in repr(found)
    assert any("1 of 6 directions are known exactly" in note for note in found.summary["notes"])
    assert 3 < found.summary["nees"]["median"] < 7


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda P: P - 0.2 * np.eye(6), "index 7.*negative variance"),
        (lambda P: P + np.triu(np.full((6, 6), 0.01), 1), "index 7.*not symmetric"),
        (lambda P: P + 2 * (np.eye(6)[[1, 0, 2, 3, 4, 5]] - np.diag([0, 0, 1, 1, 1, 1])), "index 7.*negative eigenval"),
    ],
)
def test_a_trajectory_takes_covariances_alone(change, words):
    covariances = np.broadcast_to(0.1 * np.eye(6), (20, 6, 6)).copy()
    poses = np.tile([0.0, 0, 0, 1, 0, 0, 0], (20, 1))
    assert len(Trajectory(np.arange(20.0), poses, covariances)) == 20
    covariances[7] = change(covariances[7])
    with pytest.raises(CovarianceError, match=words):
        Trajectory(np.arange(20.0), poses, covariances)
