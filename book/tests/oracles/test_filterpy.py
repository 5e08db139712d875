"""The Kalman filter beside filterpy (Labbe, github.com/rlabbe/filterpy); `python -m book.tools.oracles`.

Three of its filters: the usual one, one on square roots of covariances, and one on their inverses.
"""

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.motions.white_noise import held_noise, white_noise
from slamlib.tests.peers import covariance

REASON = "filterpy is fetched by `python -m book.tools.oracles`, which runs these tests"
kalman = pytest.importorskip("filterpy.kalman", reason=REASON)
common = pytest.importorskip("filterpy.common", reason=REASON)

SEEDS = range(12)
CLOSE = {"rtol": 1e-9, "atol": 1e-11}
FILTERS = ["KalmanFilter", "SquareRootKalmanFilter", "InformationFilter"]


def drawn(seed, singular=False):
    """A linear system (F, Q, H, R), a start, and ten measurements; singular: noise and start of too low a rank."""
    rng = np.random.default_rng(seed)
    n, m = int(rng.integers(2, 6)), int(rng.integers(1, 4))
    more = 0.0 if singular else 0.1
    Q, P = covariance(rng, n) + more * np.eye(n), covariance(rng, n) + more * np.eye(n)
    F, H, R = (
        rng.standard_normal((n, n)) / np.sqrt(n),
        rng.standard_normal((m, n)),
        covariance(rng, m) + 0.1 * np.eye(m),
    )
    return F, Q, H, R, rng.standard_normal(n), P, rng.standard_normal((10, m))


def theirs(kind, F, Q, H, R, x, P):
    """One of filterpy's filters."""
    made = getattr(kalman, kind)(dim_x=len(x), dim_z=len(R))
    made.x, made.F, made.Q, made.H, made.R = x.copy(), F, Q, H, R
    if kind == "InformationFilter":
        made.P_inv, made.R_inv = np.linalg.inv(P), np.linalg.inv(R)
        made.compute_log_likelihood = False  # its own needs as many measurements as states
    else:
        made.P = P
    return made


def covariance_of(found):
    return np.linalg.inv(found.P_inv) if hasattr(found, "P_inv") else found.P


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", FILTERS)
@pytest.mark.parametrize("method", ["batch", "scalar"])
def test_predictions_and_updates(seed, kind, method):
    F, Q, H, R, x, P, seen = drawn(seed)
    other, belief = theirs(kind, F, Q, H, R, x, P), Belief()
    block = belief.add(len(x), x, P)
    for y in seen:
        other.predict()
        belief.predict(block, F @ block.mean, F, Q)
        np.testing.assert_allclose(block.mean, other.x.ravel(), **CLOSE)
        np.testing.assert_allclose(belief.matrix, covariance_of(other), **CLOSE)
        other.update(y)
        belief.update([block], [H], y - H @ block.mean, R, method=method)
        np.testing.assert_allclose(block.mean, other.x.ravel(), **CLOSE)
        np.testing.assert_allclose(belief.matrix, covariance_of(other), **CLOSE)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("singular", [False, True])
def test_innovations_their_squares_and_likelihoods(seed, singular):
    F, Q, H, R, x, P, seen = drawn(seed, singular)
    other, belief = theirs("KalmanFilter", F, Q, H, R, x, P), Belief()
    block = belief.add(len(x), x, P)
    for y in seen:
        other.predict()
        belief.predict(block, F @ block.mean, F, Q)
        other.update(y)
        found = belief.update([block], [H], y - H @ block.mean, R)
        np.testing.assert_allclose(found.innovation, other.y.ravel(), **CLOSE)
        np.testing.assert_allclose(found.covariance, other.S, **CLOSE)
        np.testing.assert_allclose(found.nis, other.mahalanobis**2, **CLOSE)
        likelihood = -(found.nis + np.linalg.slogdet(2 * np.pi * found.covariance)[1]) / 2
        np.testing.assert_allclose(likelihood, other.log_likelihood, **CLOSE)
        np.testing.assert_allclose(belief.matrix, other.P, **CLOSE)


@pytest.mark.parametrize("seed", SEEDS)
def test_all_states_in_one_belief_are_its_smoother(seed):
    F, Q, H, R, x, P, seen = drawn(seed)
    other, belief = theirs("KalmanFilter", F, Q, H, R, x, P), Belief()
    means, covariances, *_ = other.batch_filter(seen)
    smooth, smooth_covariances, *_ = other.rts_smoother(means, covariances)
    states = [belief.add(len(x), F @ x, F @ P @ F.T + Q)]
    for y in seen:
        belief.update([states[-1]], [H], y - H @ states[-1].mean, R)
        states.append(belief.add(len(x), F @ states[-1].mean, Q, given=[states[-1]], jacobians=[F]))
    for state, mean, covariance_there in zip(states, smooth, smooth_covariances, strict=False):
        np.testing.assert_allclose(state.mean, mean.ravel(), **CLOSE)
        np.testing.assert_allclose(belief.covariance(state), covariance_there, **CLOSE)


@pytest.mark.parametrize("order", [2, 3, 4])
@pytest.mark.parametrize("axes", [1, 3])
@pytest.mark.parametrize("dt", [0.05, 1.7])
def test_q_of_white_noise(order, axes, dt):
    """filterpy's order_by_dim=False is our order: all positions, then all velocities.

    Held, its noise is that of the last number of the state itself; what it does to those before is our held noise.
    """
    wanted = common.Q_continuous_white_noise(order, dt, 0.7, axes, order_by_dim=False)
    np.testing.assert_allclose(white_noise(order, dt, [0.7] * axes), wanted, **CLOSE)
    wanted = common.Q_discrete_white_noise(order, dt, 0.7, axes, order_by_dim=False)
    if order == 2:  # there it is a held acceleration
        np.testing.assert_allclose(held_noise(2, dt, [0.7] * axes), wanted, **CLOSE)
    else:
        n = (order - 1) * axes
        np.testing.assert_allclose(held_noise(order - 1, dt, [0.7] * axes), wanted[:n, :n], **CLOSE)
