"""The belief against textbook filters: full matrices, batch least squares, and the seed toolbox's own numbers."""

import subprocess
import sys

import mpmath as mp
import numpy as np
import pytest

from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError, UnitError, UnknownNameError
from slamlib.geometry.pose import Pose
from slamlib.kalman import linalg, update
from slamlib.kalman.state import stacked_means
from slamlib.manifolds import Euclidean
from slamlib.tests.beliefs import Circle, grown, random_covariance, state
from slamlib.tests.reference import cases


def textbook(x, P, H, z, R):
    """Mean and covariance after an update with full matrices and an explicit gain."""
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ z, (np.eye(len(x)) - K @ H) @ P


def full(belief, blocks, jacobians):
    """A Jacobian with its zeros."""
    H = np.zeros((len(jacobians[0]), belief.size))
    for block, J in zip(blocks, jacobians, strict=True):
        H[:, block.slice] += J
    return H


def vector(belief):
    return np.concatenate([b.mean for b in belief.blocks])


@pytest.fixture
def rng():
    return np.random.default_rng(2)


def test_a_block_by_itself(rng):
    belief, P = Belief(), random_covariance(rng, 3)
    assert belief.matrix.shape == (0, 0)
    block = belief.add(3, [1, 2, 3], P)
    assert (belief.size, block.dof, block.slice, belief.blocks) == (3, 3, slice(0, 3), (block,))
    assert np.allclose(belief.matrix, P, rtol=0, atol=1e-15)
    assert block.mean.dtype == float
    for array in (block.mean, belief.matrix):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    copy = belief.covariance(block)
    copy[:] = 0
    assert np.allclose(belief.covariance(block), P)


def test_variances_stand_for_a_diagonal():
    belief = Belief()
    belief.add(2, [0, 0], 4)
    belief.add(2, [0, 0], [1, 2])
    assert np.array_equal(belief.matrix, np.diag([4.0, 4, 1, 2]))


def test_asymmetry_of_rounding_is_taken_out():
    belief = Belief()
    block = belief.add(2, [0, 0], [[1, 0.5 + 1e-14], [0.5, 1]])
    assert np.array_equal(belief.matrix, belief.matrix.T)
    belief.predict(block, [0, 0], np.eye(2), [[1, 1e-14], [0, 1]])
    assert np.array_equal(belief.matrix, belief.matrix.T)
    R = np.array([[1, 1e-14], [0, 1]])
    S = belief.update([block], [np.eye(2)], [0, 0], R).covariance
    assert np.array_equal(S, S.T)


def test_a_block_that_follows_from_others(rng):
    belief = Belief()
    a, b, c = grown(belief, rng, 2, 3, 1)
    G_a, G_c, Q = rng.standard_normal((2, 2)), rng.standard_normal((2, 1)), random_covariance(rng, 2)
    before = belief.matrix.copy()
    G = full(belief, [a, c], [G_a, G_c])
    new = belief.add(2, [0, 0], Q, given=[a, c], jacobians=[G_a, G_c])
    assert np.allclose(belief.matrix, np.block([[before, before @ G.T], [G @ before, G @ before @ G.T + Q]]))
    assert np.allclose(belief.covariance(new, b), G @ before[:, b.slice])


def test_remove_is_the_marginal_and_other_handles_stay_right(rng):
    belief = Belief()
    a, b, c = grown(belief, rng, 2, 3, 1)
    P_ac, P_cc = belief.covariance(a, c), belief.covariance(c)
    belief.remove(b)
    assert (belief.size, c.slice, belief.blocks) == (3, slice(2, 3), (a, c))
    assert np.array_equal(belief.covariance(a, c), P_ac)
    assert np.array_equal(belief.covariance(c), P_cc)
    with pytest.raises(SlamlibError, match=r"no block of this belief \(was it removed\?\)"):
        belief.covariance(b)
    with pytest.raises(SlamlibError, match="no block"):
        belief.update([a, b], [np.eye(2), np.eye(2, 3)], np.zeros(2), np.eye(2))


def test_replace_turns_rows_and_columns(rng):
    belief = Belief()
    a, b, c = grown(belief, rng, 2, 3, 2)
    before, J = belief.matrix.copy(), rng.standard_normal((1, 3))
    left = np.zeros((5, 7))
    left[:2, a.slice], left[2:3, b.slice], left[3:, c.slice] = np.eye(2), J, np.eye(2)
    assert belief.replace(b, 1, [7], J) is b
    assert (b.slice, c.slice, b.mean) == (slice(2, 3), slice(3, 5), 7)
    assert np.allclose(belief.matrix, left @ before @ left.T)


def test_predict_moves_one_block_and_its_correlations(rng):
    belief = Belief()
    _, b, _ = grown(belief, rng, 2, 3, 2)
    before, F, Q = belief.matrix.copy(), rng.standard_normal((3, 3)), random_covariance(rng, 3)
    big_F, big_Q = np.eye(7), np.zeros((7, 7))
    big_F[b.slice, b.slice], big_Q[b.slice, b.slice] = F, Q
    belief.predict(b, [1, 2, 3], F, Q)
    assert np.allclose(belief.matrix, big_F @ before @ big_F.T + big_Q)
    assert np.array_equal(b.mean, [1, 2, 3])


@pytest.mark.parametrize("method", ["batch", "scalar"])
def test_a_linear_filter_is_batch_least_squares(rng, method):
    """A constant-velocity track, forty steps: the filter's last estimate is that of all measurements at once."""
    F, Q, H = np.array([[1, 0.5], [0, 1]]), np.array([[0.02, 0.01], [0.01, 0.04]]), np.array([[1, 0], [0.3, 1]])
    R, P0 = np.array([[0.5, 0.2], [0.2, 0.3]]), np.diag([4.0, 1])
    y = rng.standard_normal((40, 2))
    belief = Belief()
    block = belief.add(2, np.zeros(2), P0)
    rows, right = [np.eye(2, 80)], [np.zeros(2)]
    weights = [P0]
    for k, measured in enumerate(y):
        if k:
            belief.predict(block, F @ block.mean, F, Q)
            motion = np.zeros((2, 80))
            motion[:, 2 * k - 2 : 2 * k], motion[:, 2 * k : 2 * k + 2] = -F, np.eye(2)
            rows, right, weights = [*rows, motion], [*right, np.zeros(2)], [*weights, Q]
        belief.update([block], [H], measured - H @ block.mean, R, method=method)
        seen = np.zeros((2, 80))
        seen[:, 2 * k : 2 * k + 2] = H
        rows, right, weights = [*rows, seen], [*right, measured], [*weights, R]
    white = [np.linalg.inv(np.linalg.cholesky(w)) for w in weights]
    A = np.concatenate([w @ a for w, a in zip(white, rows, strict=True)])
    b = np.concatenate([w @ r for w, r in zip(white, right, strict=True)])
    assert np.allclose(block.mean, np.linalg.lstsq(A, b, rcond=None)[0][-2:], rtol=0, atol=1e-9)
    assert np.allclose(belief.matrix, np.linalg.inv(A.T @ A)[-2:, -2:], rtol=0, atol=1e-9)


@pytest.mark.parametrize("method", ["batch", "scalar"])
@pytest.mark.parametrize("diagonal", [True, False])
def test_correct_is_the_textbook_filter(rng, method, diagonal):
    belief = Belief()
    a, _, c = grown(belief, rng, 2, 3, 4)
    jacobians = [rng.standard_normal((3, 2)), rng.standard_normal((3, 4))]
    R = np.diag([1.0, 2, 3]) if diagonal else random_covariance(rng, 3)
    x, P, H, z = vector(belief), belief.matrix.copy(), full(belief, [a, c], jacobians), rng.standard_normal(3)
    found = belief.update([a, c], jacobians, z, R, method=method)
    x, P_after = textbook(x, P, H, z, R)
    S = H @ P @ H.T + R
    assert np.allclose(vector(belief), x, rtol=0, atol=1e-12)
    assert np.allclose(belief.matrix, P_after, rtol=0, atol=1e-12)
    assert np.array_equal(belief.matrix, belief.matrix.T)
    assert np.allclose(found.covariance, S)
    assert np.isclose(found.nis, z @ np.linalg.inv(S) @ z)
    assert np.array_equal(found.innovation, z)


@pytest.mark.parametrize("method", ["batch", "scalar"])
def test_several_observations_at_once_are_one_after_another(rng, method):
    """Linear models and independent noises: the order and the grouping do not matter."""
    at_once, in_turn = Belief(), Belief()
    seed = int(rng.integers(1000))
    first, second = (grown(b, np.random.default_rng(seed), 3, 2, 2, 2) for b in (at_once, in_turn))
    observations, before = [], {}
    for i in (1, 3, 2):
        jacobians, R = [rng.standard_normal((2, 3)), rng.standard_normal((2, 2))], random_covariance(rng, 2)
        before[i] = jacobians, R, rng.standard_normal(2)
        observations.append(LinearizedMeasurement([first[0], first[i]], jacobians, before[i][2], R))
    x = vector(in_turn)
    at_once.update_all(observations, method=method)
    for i, (jacobians, R, z) in before.items():
        blocks = [second[0], second[i]]
        moved = full(in_turn, blocks, jacobians) @ (vector(in_turn) - x)  # the innovation runs along (E16)
        in_turn.update(blocks, jacobians, z - moved, R, method=method)
    assert np.allclose(vector(at_once), vector(in_turn), rtol=0, atol=1e-12)
    assert np.allclose(at_once.matrix, in_turn.matrix, rtol=0, atol=1e-12)


def test_a_sequence_of_updates_is_the_textbook_filter_one_after_another(rng):
    """Forty numbers, more than the first store of rows holds; every S and nis is that of the moment."""
    belief = Belief()
    grown(belief, rng, 3, 2, 4)
    x, P = vector(belief), belief.matrix.copy()
    with belief.sequential_update() as sequence:
        for _ in range(20):
            columns, H, R = rng.permutation(9)[:4], rng.standard_normal((2, 4)), random_covariance(rng, 2)
            dense = np.zeros((2, 9))
            dense[:, columns] = H
            z, S = rng.standard_normal(2) - dense @ x, dense @ P @ dense.T + R
            refused = sequence.update(columns, H, z, R, gate=0)
            found = sequence.update(columns, H, z, R)
            x, P = textbook(x, P, dense, z, R)
            assert np.allclose(found.covariance, S, rtol=1e-9, atol=0)
            assert np.array_equal(found.covariance, found.covariance.T)
            assert np.isclose(found.nis, z @ np.linalg.inv(S) @ z)
            assert refused.nis == found.nis
            assert np.allclose(vector(belief), x, rtol=0, atol=1e-10)
    assert np.allclose(belief.matrix, P, rtol=0, atol=1e-10)
    assert np.array_equal(belief.matrix, belief.matrix.T)


def test_a_gate_lets_pass_what_is_below_it_and_the_end_comes_once(rng):
    belief = Belief()
    block = belief.add(2, [0, 0], 3)
    with belief.sequential_update() as sequence:
        # S = 4, so that nis is (2^2 + 2^2) / 4 = 2
        assert sequence.update(np.arange(2), I2, np.array([2.0, 2]), I2, gate=2.0).nis == 2
        assert np.array_equal(block.mean, [0, 0])
        sequence.update(np.arange(2), I2, np.array([2.0, 2]), I2, gate=np.nextafter(2, 3))
        assert np.array_equal(block.mean, [1.5, 1.5])
    assert np.allclose(belief.matrix, 0.75 * I2, rtol=0, atol=1e-15)
    sequence.finish()
    assert np.allclose(belief.matrix, 0.75 * I2, rtol=0, atol=1e-15)


def test_an_update_of_rows_is_that_of_their_blocks(rng):
    at_once, by_rows = Belief(), Belief()
    (a, _, c), _ = (grown(b, np.random.default_rng(4), 2, 3, 4) for b in (at_once, by_rows))
    H, R, z = rng.standard_normal((3, 6)), random_covariance(rng, 3), rng.standard_normal(3)
    columns = np.r_[c.slice, a.slice]
    found = by_rows.update_rows(columns, H, z, R)
    expected = at_once.update([c, a], [H[:, :4], H[:, 4:]], z, R)
    assert np.allclose(vector(by_rows), vector(at_once), rtol=0, atol=1e-13)
    assert np.allclose(by_rows.matrix, at_once.matrix, rtol=0, atol=1e-13)
    assert np.allclose(found.covariance, expected.covariance, rtol=0, atol=1e-13)
    assert found.nis == pytest.approx(expected.nis)


@pytest.mark.parametrize("n", [5, 70])
def test_a_transport_carries_the_updated_covariance(rng, monkeypatch, n):
    """e becomes T e with T = I + C L E, so that P becomes T P T': as NumPy, as BLAS, and in a sequence of updates."""
    P, H, R = random_covariance(rng, n), rng.standard_normal((2, n)), random_covariance(rng, 2)
    at, C, L = np.array([3, 1]), rng.standard_normal((n, 3)), rng.standard_normal((3, 2))
    T = np.eye(n)
    T[:, at] += C @ L
    _, expected = textbook(np.zeros(n), P, H, np.zeros(2), R)
    expected = T @ expected @ T.T
    for large in (10**6, 0):
        monkeypatch.setattr(linalg, "_LARGE_CARRIED", large)
        for sequential in (False, True):
            belief = Belief()
            belief.add(n, np.zeros(n), P)
            belief.transport = lambda: linalg.Carry(at, C, L)
            if sequential:
                with belief.sequential_update() as sequence:
                    sequence.update(np.arange(n), H, np.zeros(2), R)
            else:
                belief.update_rows(np.arange(n), H, np.zeros(2), R)
            assert np.allclose(belief.matrix, expected, rtol=0, atol=1e-11 * np.abs(expected).max())
            assert np.array_equal(belief.matrix, belief.matrix.T)
    belief.transport = lambda: None
    belief.update_rows(np.arange(n), 0 * H, np.zeros(2), R)
    assert np.allclose(belief.matrix, expected, rtol=0, atol=1e-11 * np.abs(expected).max())


def test_rows_that_are_not_written_yet_take_no_part(rng, monkeypatch):
    """Fresh memory may hold anything."""
    belief = Belief()
    grown(belief, rng, 2, 1)
    monkeypatch.setattr(np, "empty", lambda shape: np.full(shape, np.nan))
    P, H = belief.matrix.copy(), np.ones((1, 3))
    with belief.sequential_update():
        pass
    assert np.array_equal(belief.matrix, P)
    with belief.sequential_update() as sequence:
        sequence.update(np.arange(3), H, np.ones(1), np.eye(1))
    assert np.allclose(belief.matrix, textbook(np.zeros(3), P, H, np.ones(1), np.eye(1))[1], rtol=0, atol=1e-12)


def test_overwrite_sets_saved_values_to_the_bit(rng):
    belief = Belief()
    a, b, c = grown(belief, rng, 2, 3, 1)
    P, means = random_covariance(rng, 6), {0: np.array([7.0]), 1: np.array([1.0, 2]), 2: np.array([3.0, 4, 5])}
    order = {2: b, 0: c, 1: a}
    belief.overwrite(order, means, P)
    assert belief.blocks == (c, a, b)
    assert [x.slice for x in (c, a, b)] == [slice(0, 1), slice(1, 3), slice(3, 6)]
    assert all(np.array_equal(order[i].mean, means[i]) for i in means)
    assert np.array_equal(belief.matrix, P)
    P[0, 0] = 99
    assert belief.matrix[0, 0] != 99
    before, stranger = state(belief), Belief().add(1, [0], 1)
    for wrong in ({0: c, 1: a}, {**order, 3: c}, {**order, 0: stranger}, {0: c, 1: a, 3: b}):
        with pytest.raises(SlamlibError, match="overwrite: give every block of the belief once, with its mean"):
            belief.overwrite(wrong, means, P)
    with pytest.raises(ShapeError, match=r"overwrite: covariance .* \(6, 6\)"):
        belief.overwrite(order, means, P[:5, :5])
    assert state(belief) == before


def test_joseph_form_is_the_same_for_the_optimal_gain_and_right_for_any(rng):
    belief, P, H, R = Belief(), random_covariance(rng, 4), rng.standard_normal((2, 4)), random_covariance(rng, 2)
    block = belief.add(4, np.zeros(4), P)
    belief.update([block], [H], np.ones(2), R)
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    assert np.allclose(linalg.joseph(P, H, R, K), belief.matrix, rtol=0, atol=1e-13)
    e, v = rng.multivariate_normal(np.zeros(4), P, 20000), rng.multivariate_normal(np.zeros(2), R, 20000)
    left = e - (e @ H.T + v) @ (K / 2).T
    claimed = linalg.joseph(P, H, R, K / 2)
    assert np.abs(left.T @ left / 20000 - claimed).max() < 0.05 * claimed.max()
    assert linalg.joseph(*(a.astype(np.float32) for a in (P, H, R, K))).dtype == np.float32
    with pytest.raises(ShapeError, match=r"joseph: H should have shape \(1, 4\), but has shape \(4,\)"):
        linalg.joseph(P, H[0], R, K)
    with pytest.raises(ShapeError, match=r"joseph: K should have shape \(4, 2\), but has shape \(2, 4\)"):
        linalg.joseph(P, H, R, K.T)


def test_the_innovation_covariance_is_what_update_uses(rng):
    belief = Belief()
    a, _, c = grown(belief, rng, 2, 3, 4)
    jacobians, R = [rng.standard_normal((2, 2)), rng.standard_normal((2, 4))], np.eye(2)
    S, before = belief.innovation_covariance([a, c], jacobians, R), belief.matrix.copy()
    assert np.array_equal(belief.matrix, before)
    assert np.array_equal(S, belief.update([a, c], jacobians, np.zeros(2), R).covariance)


def test_a_block_may_be_named_twice(rng):
    belief = Belief()
    a, b = grown(belief, rng, 2, 3)
    J = [rng.standard_normal((2, 2)), rng.standard_normal((2, 3)), rng.standard_normal((2, 2))]
    S = belief.innovation_covariance([a, b, a], J, np.eye(2))
    assert np.allclose(S, belief.innovation_covariance([a, b], [J[0] + J[2], J[1]], np.eye(2)))


def test_a_manifold_is_updated_on_its_tangent():
    """A heading as a unit vector: one measurement of the angle, weighed by the variances."""
    belief, circle = Belief(), Circle()
    heading = belief.add(circle, [1, 0], 0.04)
    place = belief.add(1, [5], 1)
    found = belief.update([heading], [np.ones((1, 1))], [0.5], 0.01)
    assert np.allclose(heading.mean, [np.cos(0.4), np.sin(0.4)])
    assert np.isclose(belief.covariance(heading)[0, 0], 0.008)
    assert (place.mean, belief.size, found.nis) == (5, 2, pytest.approx(5))


@pytest.mark.parametrize("sequential", [False, True])
def test_a_retraction_moves_all_means_together(rng, sequential):
    """Here each block by twice its own part of the step."""
    belief = Belief(lambda blocks, step: [b.manifold.plus(b.mean, 2 * step[b.slice]) for b in blocks])
    (a,) = grown(belief, rng, 2)
    heading = belief.add(Circle(), [1, 0], 0.1, given=[a], jacobians=[np.ones((1, 2)) / 9])
    c = belief.add(1, [3], 1, given=[a], jacobians=[np.ones((1, 2))])
    P, H, R, z, before = belief.matrix.copy(), rng.standard_normal((2, 4)), np.eye(2), np.ones(2) / 9, (a.mean, c.mean)
    step, left = textbook(np.zeros(4), P, H, z, R)
    if sequential:
        with belief.sequential_update() as sequence:
            sequence.update(np.arange(4), H, z, R)
    else:
        belief.update_rows(np.arange(4), H, z, R)
    assert np.allclose(a.mean, before[0] + 2 * step[:2], rtol=0, atol=1e-13)
    assert np.allclose(heading.mean, [np.cos(2 * step[2]), np.sin(2 * step[2])], rtol=0, atol=1e-13)
    assert np.allclose(c.mean, before[1] + 2 * step[3:], rtol=0, atol=1e-13)
    assert np.allclose(belief.matrix, left, rtol=0, atol=1e-12)


def test_the_reset_is_of_the_order_of_the_update(rng):
    """What update leaves out, in a pose: at most the update's angle, relative to the covariance."""
    belief, P = Belief(), np.diag([1, 1, 1, 4, 400, 40]) * 1e-4 + 1e-5
    pose = belief.add(Pose, [0, 0, 0, 1, 0, 0, 0], P)
    H = np.hstack([np.zeros((3, 3)), np.eye(3)])
    belief.update([pose], [H], [0.1, 0, 0], np.eye(3) * 1e-2)
    turned, before = 2 * np.arcsin(np.linalg.norm(pose.mean[4:])), belief.matrix.copy()
    x, y, z = 2 * pose.mean[4:]
    G = np.eye(6)
    G[3:, 3:] -= np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / 2
    belief.predict(pose, pose.mean, G, np.zeros((6, 6)))
    change = np.linalg.norm(belief.matrix - before, 2) / np.linalg.norm(before, 2)
    assert turned / 20 < change <= turned


def test_snapshot_and_restore(rng):
    belief = Belief()
    a, b, c = grown(belief, rng, 2, 3, 2)
    saved = belief.snapshot()
    means, P = [x.mean for x in (a, b, c)], belief.matrix.copy()
    belief.predict(a, [9, 9], np.eye(2), np.eye(2))
    belief.remove(b)
    d = belief.add(1, [0], 1, given=[a], jacobians=[np.ones((1, 2))])
    belief.replace(c, 1, [3], np.ones((1, 2)))
    belief.update([a, d], [np.eye(2), np.ones((2, 1))], [1, 2], 1)
    belief.restore(saved)
    assert belief.blocks == (a, b, c)
    assert [x.slice for x in belief.blocks] == list(saved.slices) == [slice(0, 2), slice(2, 5), slice(5, 7)]
    assert all(np.array_equal(x.mean, m) for x, m in zip(belief.blocks, means, strict=True))
    assert np.array_equal(belief.matrix, P)
    belief.predict(a, [9, 9], np.eye(2), np.eye(2))
    assert np.array_equal(saved.covariance, P)
    with pytest.raises(SlamlibError, match="no block"):
        belief.covariance(d)
    with pytest.raises(SlamlibError, match="another belief"):
        Belief().restore(saved)
    with pytest.raises(ValueError, match="read-only"):
        saved.covariance[0, 0] = 1


class Broken(Circle):
    """A space whose plus fails."""

    def plus(self, point, step):
        raise ZeroDivisionError


class Vanished(Circle):
    """A space whose plus gives no number."""

    def plus(self, point, step):
        return point * np.nan


I2, Z2, J23 = np.eye(2), np.zeros(2), np.ones((2, 3))
NEGATIVE, SKEWED = np.diag([1.0, -1]), np.array([[1.0, 0.5], [0, 1]])
NAN = np.array([[1.0, np.nan], [0, 1]])
WRONG = {
    "add: shape": (lambda b, x: b.add(2, [1, 2, 3], I2), ShapeError, r"add: mean .* \(2,\), but has shape \(3,\)"),
    "add: nan": (lambda b, x: b.add(2, [1, np.nan], I2), NonFiniteError, r"add: mean holds nan at index \(1,\)"),
    "add: negative": (
        lambda b, x: b.add(2, Z2, NEGATIVE),
        CovarianceError,
        "covariance has the negative variance -1 at index 1",
    ),
    "add: skewed": (lambda b, x: b.add(2, Z2, SKEWED), CovarianceError, "add: covariance is not symmetric"),
    "add: unit": (lambda b, x: b.add(Circle(), [2, 0], 1), UnitError, "add: mean"),
    "add: text": (lambda b, x: b.add(2, ["1", "2"], I2), SlamlibError, "add: mean should be an array of real numbers"),
    "add: complex": (lambda b, x: b.add(1, [1j], 1), SlamlibError, "real numbers: it holds complex128"),
    "add: ragged": (lambda b, x: b.add(1, [[1], [2, 3]], 1), SlamlibError, "add: mean should be an array"),
    "add: no space": (lambda b, x: b.add("pose", Z2, I2), SlamlibError, "'pose' is no space"),
    "add: empty": (lambda b, x: b.add(0, [], 1), SlamlibError, "at least one number"),
    "add: jacobian": (lambda b, x: b.add(2, Z2, I2, given=x[1:2], jacobians=[I2]), ShapeError, "Jacobian 0"),
    "add: count": (lambda b, x: b.add(2, Z2, I2, given=x[:2], jacobians=[I2]), SlamlibError, "2 blocks but 1 Jaco"),
    "add: too many": (lambda b, x: b.add(2, Z2, I2, jacobians=[I2]), SlamlibError, "0 blocks but 1 Jaco"),
    "add: foreign": (lambda b, x: b.add(2, Z2, I2, given=["r"], jacobians=[I2]), SlamlibError, "'r' is no block"),
    "add: overflow": (
        lambda b, x: b.add(2, Z2, I2, given=x[:1], jacobians=[I2 * 1e200]),
        NonFiniteError,
        "add: the covariance overflows",
    ),
    "remove: foreign": (lambda b, x: b.remove(Belief().add(1, [0], 1)), SlamlibError, "no block of this belief"),
    "replace: shape": (lambda b, x: b.replace(x[1], 2, Z2, I2), ShapeError, r"jacobian .* \(2, 3\), but .* \(2, 2\)"),
    "replace: overflow": (lambda b, x: b.replace(x[1], 2, Z2, J23 * 1e200), NonFiniteError, "replace: the covariance"),
    "predict: F": (
        lambda b, x: b.predict(x[0], Z2, NAN, I2),
        NonFiniteError,
        r"predict: F holds nan at index \(0, 1\)",
    ),
    "predict: Q": (lambda b, x: b.predict(x[0], Z2, I2, NEGATIVE), CovarianceError, "predict: Q has the negative"),
    "predict: mean": (lambda b, x: b.predict(x[0], 0, I2, I2), ShapeError, r"predict: mean .* \(2,\), but .* \(\)"),
    "predict: overflow": (lambda b, x: b.predict(x[0], Z2, I2 * 1e200, I2), NonFiniteError, "predict: the covariance"),
    "correct: z": (
        lambda b, x: b.update(x[:1], [I2], [0, np.inf], I2),
        NonFiniteError,
        "update: innovation holds inf",
    ),
    "correct: scalar z": (lambda b, x: b.update(x[:1], [I2], 0, I2), ShapeError, r"shape \(m,\), m at least 1"),
    "correct: no z": (lambda b, x: b.update(x[:1], [I2], [], I2), ShapeError, r"but has shape \(0,\)"),
    "correct: H": (
        lambda b, x: b.update(x[:1], [J23], Z2, I2),
        ShapeError,
        r"Jacobian 0 .* \(2, 2\), but .* \(2, 3\)",
    ),
    "correct: no block": (lambda b, x: b.update([], [], Z2, I2), SlamlibError, "0 blocks but 0 Jacobians"),
    "correct: not a list": (lambda b, x: b.update(x[0], I2, Z2, I2), SlamlibError, "give a list of blocks"),
    "add: not a list": (lambda b, x: b.add(2, Z2, I2, given=x[0], jacobians=I2), SlamlibError, "give a list of blocks"),
    "correct: R": (lambda b, x: b.update(x[:1], [I2], Z2, np.eye(3)), ShapeError, r"R .* \(2, 2\), but .* \(3, 3\)"),
    "correct: R < 0": (lambda b, x: b.update(x[:1], [I2], Z2, -I2), CovarianceError, "R has the negative variance"),
    "correct: S": (
        lambda b, x: b.update(x[:1], [I2[[0, 0]]], Z2, np.zeros((2, 2))),
        CovarianceError,
        r"number [01] of measurement 0 \(of <block Euclidean\(2\) at 0>\) is claimed to be known exactly",
    ),
    "correct: scalar": (
        lambda b, x: b.update(x[:1], [I2], Z2, np.diag([1.0, 0]), method="scalar"),
        CovarianceError,
        "number 1 of measurement 0",
    ),
    "correct: method": (lambda b, x: b.update(x[:1], [I2], Z2, I2, method="btach"), UnknownNameError, "mean 'batch'"),
    "correct: overflow": (
        lambda b, x: b.update(x[:1], [I2 * 1e200], Z2, I2),
        NonFiniteError,
        "update: the covariance",
    ),
    "correct: mean": (
        lambda b, x: b.update(x[:1], [I2 * 1e-5], [1e308, 1e308], I2 * 1e-20),
        NonFiniteError,
        "update: the updated means",
    ),
    "update_all: none": (lambda b, x: b.update_all([]), SlamlibError, "leave the call out"),
    "update_all: third": (
        lambda b, x: b.update_all([LinearizedMeasurement(x[:1], [I2], Z2, R) for R in (I2, I2, SKEWED)]),
        CovarianceError,
        "R of measurement 2 is not symmetric",
    ),
    "update_all: second": (
        lambda b, x: b.update_all(
            [LinearizedMeasurement(x[:1], [I2], Z2, I2), LinearizedMeasurement(x[1:2], [I2], Z2, I2)]
        ),
        ShapeError,
        "update: Jacobian 0 of measurement 1",
    ),
    "innovation_covariance": (
        lambda b, x: b.innovation_covariance([], [], 1),
        SlamlibError,
        "innovation_covariance: 0",
    ),
    "innovation_covariance: H": (
        lambda b, x: b.innovation_covariance(x[:1], [1.0], 1),
        ShapeError,
        r"Jacobian 0 .* \(1, 2\)",
    ),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_a_call_that_fails_says_why_and_changes_nothing(rng, wrong):
    call, error, message = WRONG[wrong]
    belief = Belief()
    blocks = grown(belief, rng, 2, 3, 2)
    before = state(belief)
    with pytest.raises(error, match=message):
        call(belief, blocks)
    assert state(belief) == before


@pytest.mark.parametrize(("manifold", "error"), [(Broken(), ZeroDivisionError), (Vanished(), NonFiniteError)])
def test_a_space_that_fails_changes_nothing(rng, manifold, error):
    belief = Belief()
    blocks = grown(belief, rng, 2)
    belief.add(manifold, [1, 0], 1)
    before = state(belief)
    with pytest.raises(error):
        belief.update(blocks, [I2], [1, 1], I2)
    assert state(belief) == before


def test_a_number_without_noise_is_allowed_where_it_is_news():
    belief = Belief()
    block = belief.add(2, [0, 0], np.eye(2))
    belief.update([block], [I2], [3, 1], np.diag([0.0, 1]))
    assert np.allclose(block.mean, [3, 0.5])
    assert np.allclose(belief.matrix, np.diag([0, 0.5]))
    with pytest.raises(CovarianceError, match="number 0 of measurement 0"):
        belief.update([block], [I2], [0, 0], np.diag([0.0, 1]))


@pytest.mark.parametrize(("method", "P", "R"), [("batch", [1, 0], [0, 0]), ("scalar", [0.01, 100], [1, 0])])
def test_the_number_that_is_known_exactly_is_named(method, P, R):
    """By the noise where that has to be definite, else by the innovation's covariance."""
    belief = Belief()
    blocks = [belief.add(1, [0], 1), belief.add(2, [0, 0], P)]
    measurements = [
        LinearizedMeasurement([b], [np.eye(b.dof)], np.zeros(b.dof), r) for b, r in zip(blocks, (5, R), strict=True)
    ]
    with pytest.raises(CovarianceError, match=r"number 1 of measurement 1 \(of <block Euclidean\(2\) at 1>\)"):
        belief.update_all(measurements, method=method)


def test_mixed_units_are_not_taken_for_singular():
    belief = Belief()
    block = belief.add(2, [0, 0], np.diag([1e10, 1e-14]))
    belief.update([block], [I2], [0, 0], np.diag([1e10, 1e-14]))
    assert np.allclose(belief.matrix, np.diag([5e9, 5e-15]), atol=0)


def test_near_copies_without_noise_are_singular():
    """A product that exists by the grace of rounding alone would be inverted into noise."""
    belief = Belief()
    block = belief.add(3, np.zeros(3), random_covariance(np.random.default_rng(0), 3))
    h = np.array([0.1, 0.2, 0.3])
    with pytest.raises(CovarianceError, match="not positive definite"):
        belief.update([block], [np.array([h, h * 3])], [0, 0], 0)


def test_a_factor_of_nan_is_an_error(monkeypatch):
    """In WebAssembly a failed factorization is NaN, not an exception."""
    monkeypatch.setattr(np.linalg, "cholesky", lambda a: np.full_like(a, np.nan))
    with pytest.raises(CovarianceError, match="smallest eigenvalue 1"):
        linalg.cholesky(np.eye(6), "f", "S")


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_small_factors_are_those_of_lapack(rng, n):
    for scale in (1e-9, 1, 1e9):
        matrix = scale * random_covariance(rng, n)
        factor = linalg.cholesky(matrix, "f", "S")
        assert np.allclose(factor, np.linalg.cholesky(matrix), rtol=1e-12, atol=0)
        many = linalg.cholesky(np.stack([matrix, matrix]), "f", "S")
        assert np.allclose(many, factor, rtol=1e-12, atol=0)


@pytest.mark.parametrize("n", [3, 6])
@pytest.mark.parametrize("scale", [1e-80, 1e80])
def test_whether_a_matrix_is_singular_does_not_depend_on_the_units(n, scale):
    near = np.ones((n, n)) + 1e-17 * np.eye(n)
    for matrix in (scale * np.eye(n), np.stack([scale * np.eye(n), np.eye(n)])):
        assert np.allclose(linalg.cholesky(matrix, "f", "S") ** 2, matrix, rtol=1e-15, atol=0)
    with pytest.raises(CovarianceError):
        linalg.cholesky(scale * near, "f", "S")


def test_the_least_eigenvalue_and_its_place_are_told():
    with pytest.raises(CovarianceError, match=r"f: S is not positive definite \(smallest eigenvalue -2\)"):
        linalg.cholesky(np.diag([3.0, -2, 1]), "f", "S")
    many = np.array([[np.eye(2), np.diag([3.0, -2])], [np.diag([5.0, -1]), np.eye(2)]])
    with pytest.raises(CovarianceError, match=r"S at index \(0, 1\) is not positive definite .* -2\)"):
        linalg.cholesky(many, "f", "S")


@pytest.mark.parametrize("matrix", [np.ones((2, 2)), -np.eye(3), np.zeros((1, 1)), np.diag([1, np.nan])])
def test_what_is_not_definite_has_no_factor_however_small(matrix):
    for given in (matrix, np.stack([matrix, matrix])):
        with pytest.raises(CovarianceError):
            linalg.cholesky(given, "f", "S")


def test_means_of_many_blocks_are_the_means_of_each(rng):
    belief, other = Belief(), Belief()
    blocks = [belief.add(3, rng.standard_normal(3), np.eye(3)) for _ in range(4)]
    pose = belief.add(Pose, Pose.random(rng), np.eye(6))
    stranger = other.add(3, rng.standard_normal(3), np.eye(3))
    columns, H = np.arange(18), rng.standard_normal((2, 18))
    chosen = [blocks[2], blocks[0]]
    for change in (
        lambda: belief.update_rows(columns, H, np.ones(2), np.eye(2)),
        lambda: belief.predict(blocks[2], np.ones(3), np.eye(3), np.eye(3)),
        lambda: belief.remove(blocks[1]),
        lambda: belief.replace(pose, 3, np.zeros(3), np.eye(3, 6)),
    ):
        kept, numbers = blocks[0].mean, blocks[0].mean.tolist()
        change()
        assert np.array_equal(stacked_means(chosen), [block.mean for block in chosen])
        assert kept.tolist() == numbers
    assert np.array_equal(stacked_means([blocks[0], stranger]), [blocks[0].mean, stranger.mean])
    assert np.array_equal(blocks[2].mean, stacked_means(chosen)[0])


def test_blocks_that_were_added_one_by_one_move_as_those_restored_at_once(rng):
    belief = Belief()
    blocks = [belief.add(manifold, manifold.random(rng), np.eye(manifold.dof)) for manifold in (Pose, Euclidean(3))]
    blocks += [belief.add(manifold, manifold.random(rng), np.eye(manifold.dof)) for manifold in (Euclidean(2), Pose)]
    snapshot, H = belief.snapshot(), rng.standard_normal((2, belief.size))
    found = []
    for _ in range(2):
        belief.update_rows(np.arange(belief.size), H, np.ones(2), np.eye(2))
        found.append([block.mean.tolist() for block in blocks])
        belief.restore(snapshot)  # makes the layout anew
    assert found[0] == found[1]
    assert found[0] != [mean.tolist() for mean in snapshot.means]


def test_means_of_points_are_stacked_too(rng):
    """Points of a manifold lie in no belief's array of vectors."""
    belief = Belief()
    poses = [belief.add(Pose, Pose.random(rng), np.eye(6)) for _ in range(3)]
    assert np.array_equal(stacked_means(poses[:0:-1]), [poses[2].mean, poses[1].mean])


def test_blas_on_a_view_updates_a_copy():
    """The trap that subtract_square avoids: without this, a view of a larger array would silently stay as it was."""
    blas = pytest.importorskip("scipy.linalg.blas")
    store, rows = np.eye(6), np.ones((1, 4))
    view = store[:4, :4]
    blas.dsyrk(-1.0, rows.T, 1.0, view.T, overwrite_c=1)
    assert np.array_equal(view, np.eye(4))
    linalg.subtract_square(view, rows)
    assert np.array_equal(view, np.eye(4) - 1)


@pytest.mark.parametrize("n", [1, 5, 63, 64, 65, 200])
@pytest.mark.parametrize("m", [0, 1, 7])
def test_numpy_and_blas_agree(rng, monkeypatch, n, m):
    pytest.importorskip("scipy.linalg.blas")
    rows, factor, P = rng.standard_normal((m, n)), np.linalg.cholesky(random_covariance(rng, 7)), np.eye(n) * 9 + 1
    monkeypatch.setattr(linalg, "_LARGE", 0)
    results = []
    for scipy in (True, False):
        if not scipy:
            monkeypatch.setattr(linalg, "_scipy", lambda *_: None)
        for order in (lambda a: a, lambda a: a.repeat(2, axis=0)[::2]):  # contiguous; a view
            out = order(P.copy())
            linalg.subtract_square(out, rows)
            assert np.array_equal(out, out.T)
            results.append(out)
    assert all(np.allclose(out, P - rows.T @ rows, rtol=0, atol=1e-12) for out in results)
    right = rng.standard_normal((7, n))
    expected = linalg.solve_lower(factor, right)
    monkeypatch.undo()
    assert np.allclose(linalg.solve_lower(factor, right), expected, rtol=0, atol=1e-10)
    assert np.allclose(factor @ linalg.solve_lower(factor, right[:, 0]), right[:, 0])


def test_scipy_is_loaded_late_and_not_needed():
    program = (
        "import sys; sys.modules['scipy'] = None; import numpy as np; from slamlib.belief import Belief; b = Belief();"
        "x = b.add(2, [0, 0], 1); b.update([x], [np.eye(2)], [1, 1], 1); print(x.mean)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "[0.5 0.5]\n"


def test_large_states_take_the_path_of_blas(rng, monkeypatch):
    monkeypatch.setattr(linalg, "_LARGE", 50)
    belief, n = Belief(), 60
    block = belief.add(n, np.zeros(n), random_covariance(rng, n))
    P, H, R = belief.matrix.copy(), rng.standard_normal((4, n)), np.eye(4)
    belief.update([block], [H], np.ones(4), R)
    x, P = textbook(np.zeros(n), P, H, np.ones(4), R)
    assert np.allclose(block.mean, x, rtol=0, atol=1e-11)
    assert np.allclose(belief.matrix, P, rtol=0, atol=1e-11)
    assert np.array_equal(belief.matrix, belief.matrix.T)


def test_the_methods_are_known_by_name():
    assert set(update._METHODS) == {"batch", "scalar"}


def from_toolbox(given):
    """A belief whose one block holds the used entries of a toolbox map, and which entries those are."""
    used = np.flatnonzero(given["used"])
    belief = Belief()
    P = given["P"][np.ix_(used, used)]
    return belief, belief.add(len(used), given["x"][used, 0], (P + P.T) / 2), used


def rows_of(given, used):
    return np.searchsorted(used, given["r"].ravel().astype(int) - 1)


def test_predict_as_the_toolbox_does():
    for given, expected in cases("ekf", "predictBlockEkf", columns=True):
        belief, block, used = from_toolbox(given)
        r = rows_of(given, used)
        F, Q = np.eye(len(used)), np.zeros((len(used),) * 2)
        F[np.ix_(r, r)], Q[np.ix_(r, r)] = given["F_r"], given["F_u"] @ given["U"] @ given["F_u"].T
        belief.predict(block, block.mean, F, (Q + Q.T) / 2)
        assert np.allclose(belief.matrix, expected["P_after"][np.ix_(used, used)], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("method", ["batch", "scalar"])
def test_correct_as_the_toolbox_does(method):
    for given, expected in cases("ekf", "correctBlockEkf", columns=True):
        belief, block, used = from_toolbox(given)
        r = rows_of(given, used)
        H = np.zeros((len(given["z"]), len(used)))
        H[:, r] = given["H"]
        # The toolbox takes the innovation's covariance Z; what is left of it is the noise.
        R = given["Z"] - H @ belief.matrix @ H.T
        belief.update([block], [H], given["z"].ravel(), (R + R.T) / 2, method=method)
        assert np.allclose(block.mean, expected["x_after"][used, 0], rtol=1e-10, atol=1e-10)
        assert np.allclose(belief.matrix, expected["P_after"][np.ix_(used, used)], rtol=1e-10, atol=1e-10)


def test_add_as_the_toolbox_does():
    for given, expected in cases("ekf", "addToMap", columns=True):
        belief, _, used = from_toolbox(given)
        n = belief.size
        # The toolbox is given the new rows themselves (here not those of any covariance): what adding does with them.
        P = linalg.replace_rows(belief.matrix, slice(n, n), given["P_LX"], given["P_LL"])
        order = np.concatenate([used, expected["r"].ravel().astype(int) - 1])
        assert np.allclose(P, expected["P_after"][np.ix_(order, order)], rtol=1e-12, atol=1e-12)


UNITS = np.array([1e4, 1e-2, 1.0])  # standard deviations in units of three kinds


@pytest.mark.parametrize(
    ("correlations", "said"),
    [
        (np.diag([1.0, -1.0, 1.0]), "the negative variance -0.0001 at index 1"),
        ([[1, 0, 0], [0, 1, 1.1], [0, 1.1, 1]], r"negative eigenvalue .*-0.1 of its correlations"),
        ([[1, 0.5, 0], [0.4, 1, 0], [0, 0, 1]], "not symmetric"),
        ([[1, 0.5, 0], [0.5, 0, 0], [0, 0, 1]], "no variance at index 1, and yet a covariance 50 with 0"),
    ],
)
def test_a_covariance_is_judged_in_the_units_of_its_rows(correlations, said):
    P = np.array(correlations) * np.outer(UNITS, UNITS)
    belief = Belief()
    with pytest.raises(CovarianceError, match=said):
        belief.add(3, np.zeros(3), P)
    block = belief.add(3, np.zeros(3), np.diag(UNITS**2))
    before = belief.matrix.copy()
    for call in (
        lambda: belief.update_rows(np.arange(3), np.eye(3), np.zeros(3), P),
        lambda: belief.update([block], [np.eye(3)], np.zeros(3), P),
        lambda: belief.predict(block, np.zeros(3), np.eye(3), P),
    ):
        with pytest.raises(CovarianceError, match=said):
            call()
        assert np.array_equal(belief.matrix, before)


def test_singular_covariances_of_mixed_units_are_taken():
    rng = np.random.default_rng(8)
    for _ in range(300):
        n, rank = rng.integers(2, 7), rng.integers(1, 4)
        A = rng.standard_normal((n, rank)) * 10.0 ** rng.uniform(-6, 6, (n, 1))
        block = Belief().add(int(n), np.zeros(n), A @ A.T)
        assert block.dof == n


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ([0, 0], "row 0 appears twice"),
        ([0, 3], "from 0 to 2, got 0 to 3"),
        ([-1, 0], "got -1"),
        ([0.0, 1.0], "float64"),
    ],
)
def test_rows_that_are_none_are_refused(columns, said):
    belief = Belief()
    belief.add(3, np.zeros(3), np.eye(3))
    with pytest.raises(SlamlibError, match=said):
        belief.update_rows(np.array(columns), np.eye(2), np.zeros(2), np.eye(2))


# -- priors of any size ------------------------------------------------------------------------------------------------


def right(P, problem):
    """The covariance after measurements with R = 1, in 60 digits."""
    P = mp.matrix(P.tolist())
    for H in map(mp.matrix, problem):
        P = P - P * H.T * (H * P * H.T + mp.eye(H.rows)) ** -1 * H * P
    return P


def in_a_sequence(belief, block, problem):
    with belief.sequential_update() as sequence:
        for H in problem:
            sequence.update(np.arange(block.dof), np.array(H), np.zeros(len(H)), np.eye(len(H)))


def one_by_one(belief, block, problem, method="batch"):
    for H in problem:
        belief.update([block], [np.array(H)], np.zeros(len(H)), np.eye(len(H)), method=method)


def by_numbers(belief, block, problem):
    one_by_one(belief, block, problem, "scalar")


@pytest.mark.parametrize("update", [one_by_one, in_a_sequence, by_numbers])
@pytest.mark.parametrize("seed", [0, 1])
def test_an_update_holds_to_two_digits_or_refuses_whatever_the_prior(update, seed):
    rng, taken = np.random.default_rng(seed), {}
    for power in [*range(4, 13), *np.repeat([13, 14, 15], 20).tolist(), *range(16, 33)]:
        prior = 10.0**power * np.diag(rng.uniform(1, 4, 4))
        problem = [rng.standard_normal((m, 4)).tolist() for m in (2, 2, 1)]
        belief = Belief()
        block = belief.add(4, np.zeros(4), prior)
        try:
            update(belief, block, problem)
        except CovarianceError as error:
            assert "times its noise" in str(error)
            taken[power] = False
            continue
        taken[power] = True
        with mp.workdps(60):
            P, exact = belief.matrix, right(prior, problem)
            assert np.linalg.eigvalsh(P)[0] > 0
            for i, j in np.ndindex(4, 4):
                assert abs(P[i, j] - exact[i, j]) < 0.03 * mp.sqrt(exact[i, i] * exact[j, j])
    assert all(taken[power] for power in range(4, 13))
    assert not any(taken[power] for power in range(16, 33))


@pytest.mark.parametrize("update", [one_by_one, in_a_sequence, by_numbers])
def test_a_refused_update_changes_nothing(update):
    belief = Belief()
    block = belief.add(2, [1.0, 2], 1e16 * np.eye(2))
    with pytest.raises(CovarianceError, match=r"number 0 of the measurement is 1\.1e\+16 times its noise"):
        update(belief, block, [[[1, 0.3]]])
    assert np.array_equal(belief.matrix, 1e16 * np.eye(2))
    assert block.mean.tolist() == [1, 2]


def test_what_holds_exactly_may_have_any_prior():
    """Without noise nothing is compared: a constraint leaves rounding, which is what it is known to."""
    belief = Belief()
    block = belief.add(2, [0.0, 0], 1e16 * np.eye(2))
    belief.update([block], [np.array([[1.0, 0]])], np.array([3.0]), np.zeros((1, 1)))
    assert block.mean.tolist() == [pytest.approx(3, abs=1e-15), 0]
    assert belief.matrix[1, 1] == 1e16
    belief = Belief()
    block = belief.add(3, [0.0, 0, 0], 2.0**42 * np.eye(3))
    belief.update([block], [np.array([[1.0, 0, 0], [0, 0.6, 0.7]])], np.zeros(2), np.diag([1.0, 0]))
    assert belief.matrix[0, 0] == pytest.approx(1, rel=5e-3)


def test_a_number_that_is_well_predicted_counts_with_its_own_noise_beside_one_that_is_not():
    belief = Belief()
    block = belief.add(2, [0.0, 0], np.diag([2.0**42, 1]))
    belief.update([block], [np.eye(2)], np.zeros(2), np.eye(2))  # the second is halved
    assert belief.matrix.diagonal() == pytest.approx([1, 0.5], rel=5e-3)
