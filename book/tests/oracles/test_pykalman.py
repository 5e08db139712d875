"""Filter and smoother beside pykalman (github.com/pykalman/pykalman); `python -m book.tools.oracles`.

The smoothed path is had in three ways: pykalman goes back over the filter's estimates, a belief that keeps all states
is updated as ever, and `slambook.smoothing` solves for all states at once.
"""

import numpy as np
import pytest
from slambook.smoothing.least_squares import Terms, Variable, minimize

from slamlib.belief import Belief
from slamlib.manifolds import Euclidean
from slamlib.tests.peers import covariance

REASON = "pykalman is fetched by `python -m book.tools.oracles`, which runs these tests"
pykalman = pytest.importorskip("pykalman", reason=REASON)

SEEDS = range(12)
CLOSE = {"rtol": 1e-9, "atol": 1e-11}
SOLVED = {"rtol": 1e-7, "atol": 1e-7}  # a step that gains less than 1e-10 of the cost is the last


class System:
    """A linear system, a start, and twelve measurements, of which some are missing (masked rows)."""

    def __init__(self, seed):
        rng = np.random.default_rng(seed)
        n, m = int(rng.integers(1, 5)), int(rng.integers(1, 3))
        self.F, self.u = rng.standard_normal((n, n)) / np.sqrt(n), rng.standard_normal(n)
        self.H, self.x, self.n = rng.standard_normal((m, n)), rng.standard_normal(n), n
        self.Q, self.P, self.R = (covariance(rng, k) + 0.1 * np.eye(k) for k in (n, n, m))
        hidden = rng.random(12) < 0.25
        self.seen = np.ma.array(rng.standard_normal((12, m)), mask=np.repeat(hidden[:, None], m, axis=1))

    def theirs(self):
        return pykalman.KalmanFilter(
            transition_matrices=self.F,
            transition_offsets=self.u,
            observation_matrices=self.H,
            transition_covariance=self.Q,
            observation_covariance=self.R,
            initial_state_mean=self.x,
            initial_state_covariance=self.P,
        )

    def rows(self):
        """The measurements, None where one is missing."""
        return [None if np.ma.getmaskarray(y).all() else y.data for y in self.seen]


@pytest.mark.parametrize("seed", SEEDS)
def test_the_filter_and_its_likelihood(seed):
    system, belief, likelihood = System(seed), Belief(), 0.0
    means, covariances = system.theirs().filter(system.seen)
    block = belief.add(system.n, system.x, system.P)
    for k, y in enumerate(system.rows()):
        if k:
            belief.predict(block, system.F @ block.mean + system.u, system.F, system.Q)
        if y is not None:
            found = belief.update([block], [system.H], y - system.H @ block.mean, system.R)
            likelihood -= (found.nis + np.linalg.slogdet(2 * np.pi * found.covariance)[1]) / 2
        np.testing.assert_allclose(block.mean, means[k], **CLOSE)
        np.testing.assert_allclose(belief.matrix, covariances[k], **CLOSE)
    np.testing.assert_allclose(likelihood, system.theirs().loglikelihood(system.seen), **CLOSE)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_belief_that_keeps_all_states_is_the_smoother(seed):
    system, belief, states = System(seed), Belief(), []
    for y in system.rows():
        if states:
            mean = system.F @ states[-1].mean + system.u
            states.append(belief.add(system.n, mean, system.Q, given=[states[-1]], jacobians=[system.F]))
        else:
            states.append(belief.add(system.n, system.x, system.P))
        if y is not None:
            belief.update([states[-1]], [system.H], y - system.H @ states[-1].mean, system.R)
    means, covariances = system.theirs().smooth(system.seen)
    np.testing.assert_allclose([state.mean for state in states], means, **CLOSE)
    np.testing.assert_allclose([belief.covariance(state) for state in states], covariances, **CLOSE)


@pytest.mark.parametrize("seed", SEEDS)
def test_least_squares_over_all_states_is_the_smoother(seed):
    system = System(seed)
    rows, count = system.rows(), len(system.rows())
    variable = Variable(Euclidean(system.n), 0, 0)

    def whitened(noise, residual, parts):
        W = np.linalg.inv(np.linalg.cholesky(noise))
        e = residual @ W.T
        jacobians = [(variable, items, np.broadcast_to(W @ J, (len(items), *J.shape))) for items, J in parts]
        return Terms(float((e * e).sum()), e, jacobians)

    seen = np.array([k for k in range(count) if rows[k] is not None])
    before, after, unit = np.arange(count - 1), np.arange(1, count), np.eye(system.n)

    def start(values):
        return whitened(system.P, values[0][:1] - system.x, [(np.array([0]), unit)])

    def motion(values):
        moved = values[0][after] - values[0][before] @ system.F.T - system.u
        return whitened(system.Q, moved, [(after, unit), (before, -system.F)])

    def measured(values):
        expected = values[0][seen] @ system.H.T
        return whitened(system.R, expected - np.array([rows[k] for k in seen]), [(seen, system.H)])

    found = minimize([start, motion, measured], [variable], [np.zeros((count, system.n))], 50)
    means, covariances = system.theirs().smooth(system.seen)
    np.testing.assert_allclose(found.values[0], means, **SOLVED)
    np.testing.assert_allclose(found.marginals(variable, np.arange(count)), covariances, **SOLVED)
