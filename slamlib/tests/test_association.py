"""Choosing what to measure, gating, and known data association."""

from contextlib import nullcontext
from types import SimpleNamespace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.errors import CovarianceError
from slamlib.kalman.chi_square import chi2_cdf
from slamlib.kalman.linalg import covariance, touched_rows
from slamlib.records.inputs import Features, Scan
from slamlib.slam.data_association.front_end import FrontEndInput, KnownAssociation
from slamlib.slam.data_association.gates import gate, mahalanobis_squared
from slamlib.slam.data_association.selection import SELECTIONS
from slamlib.slam.prediction import innovation_covariances


@pytest.fixture
def rng():
    return np.random.default_rng(16)


def spd(rng, n):
    A = rng.standard_normal((n, n))
    return A @ A.T + 0.1 * np.eye(n)


def test_innovation_covariances_are_those_of_the_belief(rng):
    belief = Belief()
    robot = belief.add(3, np.zeros(3), spd(rng, 3))
    marks = [belief.add(2, np.zeros(2), spd(rng, 2), given=[robot], jacobians=[rng.random((2, 3))]) for _ in range(4)]
    H, R = rng.standard_normal((4, 2, 5)), np.array([spd(rng, 2) for _ in range(4)])
    columns = np.array([[0, 1, 2, *range(m.start, m.start + 2)] for m in marks])
    found = innovation_covariances(belief.matrix, columns, H, R)
    for i, mark in enumerate(marks):
        wanted = belief.innovation_covariance([robot, mark], [H[i][:, :3], H[i][:, 3:]], R[i])
        assert np.allclose(found[i], wanted, rtol=1e-13)
    assert np.array_equal(found, found.swapaxes(1, 2))


def test_rows_update_as_blocks_do(rng):
    beliefs = []
    for _ in range(2):
        r = np.random.default_rng(3)
        belief = Belief()
        belief.add(3, r.random(3), spd(r, 3))
        belief.add(2, r.random(2), spd(r, 2))
        beliefs.append(belief)
    H, R, z = rng.standard_normal((2, 5)), spd(rng, 2), rng.standard_normal(2)
    a = beliefs[0].update(beliefs[0].blocks, [H[:, :3], H[:, 3:]], z, R)
    b = beliefs[1].update_rows(np.arange(5), H, z, R)
    assert a.nis == b.nis
    assert np.array_equal(beliefs[0].matrix, beliefs[1].matrix)
    before = beliefs[1].matrix.copy()
    with beliefs[1].sequential_update() as sequence:
        assert sequence.update(np.arange(5), H, 100 * z, R, 9.0).nis > 9
    assert np.array_equal(before, beliefs[1].matrix)


def test_touched_rows_are_those_that_any_array_names_in_their_order():
    columns = [np.array([[7, 0, 3], [7, 0, 5]]), np.array([[7, 1]])]
    touched, places = touched_rows(9, columns)
    assert touched.tolist() == [0, 1, 3, 5, 7]
    for named, at in zip(columns, places, strict=True):
        assert np.array_equal(touched[at], named)


@pytest.mark.parametrize("n", [2, 3, 6])  # on Python's floats, and by LAPACK
def test_a_covariance_may_have_an_eigenvalue_below_zero_by_rounding_alone(rng, n):
    """Of the correlations, in whatever units; a rank of one less than the size is allowed."""
    Q = np.linalg.qr(rng.standard_normal((n, n)))[0]
    units = 10.0 ** rng.integers(-6, 7, n)
    for least, is_one in ((0.0, True), (-1e-10, True), (-1e-7, False)):
        A = (Q * np.append(np.ones(n - 1), least)) @ Q.T
        A = np.outer(units, units) * (A + A.T) / 2
        with nullcontext() if is_one else pytest.raises(CovarianceError, match="negative eigenvalue"):
            assert np.array_equal(covariance(A, n, "f", "A"), A)


def test_a_broadcast_square_is_that_of_each_pair(rng):
    """Two numbers by their factors, three by a solution."""
    for d in (2, 3):
        z, S = rng.standard_normal((5, 4, d)), np.array([spd(rng, d) for _ in range(5)])
        found = mahalanobis_squared(z, S[:, None])
        assert found.shape == (5, 4)
        for i in range(5):
            for j in range(4):
                assert found[i, j] == pytest.approx(z[i, j] @ np.linalg.inv(S[i]) @ z[i, j])


def test_the_most_uncertain_expectations_come_first():
    S = np.array([np.diag(d) for d in ([1.0, 1.0], [4.0, 2.0], [3.0, 3.0], [4.0, 2.0])])
    assert SELECTIONS["information"](S, 3).tolist() == [2, 1, 3]
    assert SELECTIONS["order"](S, 2).tolist() == [0, 1]
    assert SELECTIONS["information"](S, 10).tolist() == [2, 1, 3, 0]


@pytest.mark.parametrize("dof", [1, 2, 3])
def test_a_gate_lets_its_share_of_the_truth_pass(dof, rng):
    """20000 draws: the share is binomial, with a standard deviation of 0.0007 for p = 0.99."""
    S = spd(rng, dof)
    z = rng.multivariate_normal(np.zeros(dof), S, size=20000)
    share = (mahalanobis_squared(z, np.broadcast_to(S, (20000, dof, dof))) < gate(0.99, dof)).mean()
    assert abs(share - 0.99) < 4 * np.sqrt(0.99 * 0.01 / 20000)


def test_without_a_gate_everything_passes():
    assert gate(1.0, 2) == np.inf


def test_nine_is_another_probability_for_each_size():
    """The toolbox's one threshold for everything (E59)."""
    assert [round(chi2_cdf(9, n), 3) for n in (1, 2, 3, 4)] == [0.997, 0.989, 0.971, 0.939]


def test_known_association_matches_by_id_and_initializes_the_lowest_first():
    scan = Scan({"points": Features([7, 3, 9, 5], [[7.0, 0], [3, 0], [9, 0], [5, 0]])})

    class Wanted:
        def __init__(self, number):
            self.landmark = type("L", (), {"id": number})

    measured, found = KnownAssociation().match(
        FrontEndInput(scan, None, []), "points", [Wanted(9), Wanted(4), Wanted(3)]
    )
    assert found.tolist() == [True, False, True]
    assert measured[[0, 2], 0].tolist() == [9, 3]
    assert np.isnan(measured[1]).all()
    fresh = KnownAssociation().detect(FrontEndInput(scan, None, []), "points", {3}, lambda values: values[:, 0] != 5, 2)
    assert [number for number, _, _ in fresh] == [7, 9]
    assert (
        KnownAssociation().detect(FrontEndInput(Scan(), None, []), "points", set(), lambda v: np.ones(len(v), bool), 3)
        == []
    )


@pytest.mark.parametrize("count", [1, 3])
def test_a_scan_without_features_leaves_everything_unmatched(count):
    wanted = [SimpleNamespace(landmark=SimpleNamespace(id=i), value=np.zeros(4)) for i in range(count)]
    measured, found = KnownAssociation().match(FrontEndInput(Scan(), None, []), "segments", wanted)
    assert measured.shape == (count, 4)
    assert np.isnan(measured).all()
    assert found.tolist() == [False] * count
