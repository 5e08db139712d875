"""The largest jointly compatible set: beside exhaustive search, at the gate's rate, and with bounded work."""

from functools import partial
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.errors import CovarianceError
from slamlib.slam.data_association.gates import gate
from slamlib.slam.data_association.jcbb import _Node, jcbb

LIMIT = partial(gate, 0.99)


def drawn(rng, n, d=2, shared=4, spread=3.0):
    """Innovations (n, d) of one draw, and their covariance (n, d, n, d): much of it is shared, as by a camera."""
    H = spread * rng.standard_normal((n * d, shared))
    S = H @ H.T + np.diag(rng.uniform(1, 3, n * d))
    return rng.multivariate_normal(np.zeros(n * d), S).reshape(n, d), S.reshape(n, d, n, d)


def square(z, S, rows):
    """z' S^-1 z of some of the innovations."""
    own = S[rows][:, :, rows].reshape(len(rows) * z.shape[1], -1)
    return z[rows].ravel() @ np.linalg.solve(own, z[rows].ravel())


def exhaustive(z, S, dof):
    """The largest set, of one size that with the least square, by trying them all."""
    for size in range(len(z), 0, -1):
        sets = [np.array(rows) for rows in combinations(range(len(z)), size)]
        squares = [(square(z, S, rows), rows.tolist()) for rows in sets]
        fit = [(s, rows) for s, rows in squares if s < LIMIT(int(dof[rows].sum()))]
        if fit:
            return min(fit)[1]
    return []


@given(st.integers(0, 2**32 - 1), st.integers(1, 9), st.sampled_from([0.0, 4.0, 12.0, 100.0]), st.booleans())
@settings(max_examples=150, deadline=None)
def test_the_compatible_set_is_that_of_exhaustive_search(seed, n, size, mixed):
    rng = np.random.default_rng(seed)
    z, S = drawn(rng, n, d=3 if mixed else 2)
    dof = np.full(n, z.shape[1])
    if mixed:  # some have two numbers only, and are filled up
        short = rng.random(n) < 0.5
        dof[short], z[short, 2], S[short, 2], S[:, :, short, 2] = 2, 0, 0, 0
        S[short, 2, short, 2] = 1
    wrong = rng.permutation(n)[: rng.integers(0, n + 1)]
    z[wrong, :2] += size * rng.standard_normal((len(wrong), 2))
    assert np.flatnonzero(jcbb(z, S, dof, LIMIT, max_nodes=10**9)).tolist() == exhaustive(z, S, dof)


def test_the_tree_keeps_a_pair_that_removing_one_by_one_would_break():
    """The two with the largest squares agree: each lowers the joint square most, so that they are removed first."""
    z, shared = np.array([[-6.0], [-5], [3], [5]]), np.array([1.0, 1, 2, 1])
    S, one_each = (4 * np.outer(shared, shared) + np.eye(4)).reshape(4, 1, 4, 1), np.ones(4, dtype=int)
    assert square(z, S, np.array([0, 1])) < LIMIT(2)
    assert min(square(z, S, np.array(rows)) for rows in combinations(range(4), 3)) > LIMIT(3)
    assert np.flatnonzero(jcbb(z, S, one_each, LIMIT, max_nodes=0)).tolist() == [2]
    assert np.flatnonzero(jcbb(z, S, one_each, LIMIT)).tolist() == [0, 1]


def test_work_is_bounded_and_what_is_found_is_compatible(monkeypatch):
    """Half of 30 are wrong: a full search would take hours. With the cap the greedy set is what remains at worst."""
    made = []
    before = _Node.__init__
    monkeypatch.setattr(_Node, "__init__", lambda self, *a: (made.append(0), before(self, *a))[1])
    rng = np.random.default_rng(5)
    z, S = drawn(rng, 30)
    z[:15] += 20 * rng.standard_normal((15, 2))
    dof = np.full(30, 2)
    for max_nodes in (1, 10, 50):
        made.clear()
        rows = np.flatnonzero(jcbb(z, S, dof, LIMIT, max_nodes))
        assert len(rows) >= 12
        assert square(z, S, rows) < LIMIT(2 * len(rows))
        assert len(made) <= max_nodes + 1 + 30  # the root, and as many as the greedy set leaves out


def test_true_innovations_are_accepted_at_the_rate_of_the_gate():
    """4000 draws of 8 innovations: the share kept is binomial; its 99.9 % band is 3.29 standard deviations."""
    rng, n, draws = np.random.default_rng(6), 8, 4000
    _, S = drawn(rng, n)
    z = rng.multivariate_normal(np.zeros(2 * n), S.reshape(2 * n, 2 * n), size=draws).reshape(draws, n, 2)
    limit = partial(gate, 0.95)
    whole = np.mean([jcbb(one, S, np.full(n, 2), limit).all() for one in z])
    assert abs(whole - 0.95) < 3.29 * np.sqrt(0.95 * 0.05 / draws)


def test_wrong_matches_that_pass_every_single_gate_are_found_together():
    """The camera's turn moves all by 20 px, the noise by 1: two that go the other way pass alone, not together."""
    S = (400 * np.kron(np.ones((6, 6)), np.eye(2)) + np.eye(12)).reshape(6, 2, 6, 2)
    z = np.array([[9.0, 4], [8, 5], [10, 4], [9, 3], [-6, 4], [9, -8]])
    alone = (z * z).sum(1) / 401
    assert (alone < 1).all()
    assert jcbb(z, S, np.full(6, 2), LIMIT).tolist() == [True] * 4 + [False] * 2


def test_a_singular_covariance_is_an_error():
    with pytest.raises(CovarianceError, match="joint covariance of the innovations"):
        jcbb(np.ones((2, 2)), np.ones((2, 2, 2, 2)), np.full(2, 2), LIMIT)
