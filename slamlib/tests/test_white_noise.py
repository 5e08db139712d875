"""White noise on a derivative: beside the matrix exponential of Van Loan, beside simulated paths, and by its laws."""

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from slamlib.errors import NonFiniteError, SlamlibError
from slamlib.motions.white_noise import held_noise, reached, white_noise

ORDERS = [1, 2, 3, 4]


def transition(order, dt):
    """exp(A dt) of a chain of integrators."""
    return expm(dt * np.eye(order, k=1))


def van_loan(order, dt, density):
    """Q by one matrix exponential, of 50 digits, without an integral in closed form."""
    A, L = np.eye(order, k=1), np.eye(order)[:, [-1]]
    big = np.block([[-A, L @ L.T], [np.zeros((order, order)), A.T]])
    with mpmath.workdps(50):
        whole = mpmath.expm(mpmath.mpf(dt) * mpmath.matrix(big.tolist()))
        Q = mpmath.mpf(density) * whole[order:, order:].T * whole[:order, order:]
        return np.array(Q.tolist(), dtype=float)


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("dt", [0.0, 1e-3, 0.1, 1.0, 7.0])
def test_the_covariance_is_that_of_van_loan(order, dt):
    wanted = van_loan(order, dt, 0.3)
    assert white_noise(order, dt, 0.3) == pytest.approx(wanted, rel=1e-14, abs=0)


@pytest.mark.parametrize("order", ORDERS)
def test_a_held_derivative_moves_the_state_by_the_end_of_a_longer_chain(order):
    way = transition(order + 1, 0.7)[:order, -1]
    assert reached(order, 0.7) == pytest.approx(way, rel=1e-13)
    assert held_noise(order, 0.7, 0.3) == pytest.approx(0.3 * np.outer(way, way), rel=1e-13)
    assert np.linalg.matrix_rank(held_noise(order, 0.7, 0.3)) == 1
    assert np.linalg.eigvalsh(white_noise(order, 0.7, 0.3)).min() > 0


@given(st.sampled_from(ORDERS), st.floats(0.01, 2), st.floats(0.01, 2))
def test_two_steps_of_white_noise_are_one_and_of_held_noise_are_not(order, first, second):
    F, G = transition(order, second), transition(order, first)
    both = F @ white_noise(order, first, 0.3) @ F.T + white_noise(order, second, 0.3)
    assert both == pytest.approx(white_noise(order, first + second, 0.3), rel=1e-12)
    both = G @ held_noise(order, first, 0.3) @ G.T + held_noise(order, first, 0.3)
    assert both[0, 0] < 0.9 * held_noise(order, 2 * first, 0.3)[0, 0]


@pytest.mark.parametrize("order", ORDERS)
def test_many_short_steps_of_held_noise_with_the_density_per_step_are_white_noise(order):
    n, dt = 2000, 0.002
    found, F, Q = np.zeros((order, order)), transition(order, dt), held_noise(order, dt, 0.3 / dt)
    for _ in range(n):
        found = F @ found @ F.T + Q
    assert found == pytest.approx(white_noise(order, n * dt, 0.3), rel=3e-3)


@pytest.mark.parametrize("seed", [1, 2])
def test_simulated_paths_spread_as_it_says(seed):
    runs, n, T = 4000, 200, 2.0
    rng, path = np.random.default_rng(seed), np.zeros((4000, 3))
    F, way = transition(3, T / n), transition(4, T / n)[:3, -1]
    for _ in range(n):
        path = path @ F.T + np.outer(np.sqrt(0.3 / (T / n)) * rng.standard_normal(runs), way)
    wanted = white_noise(3, T, 0.3)
    scale = np.sqrt(np.diag(wanted))
    apart = (path.T @ path / runs - wanted) / np.outer(scale, scale)
    # a sample covariance of unit variances is off by sqrt(2 / runs), 0.022, and the steps by less than 1 %
    assert np.abs(apart).max() < 4 * np.sqrt(2 / runs)


def test_axes_stand_side_by_side():
    Q = white_noise(2, 0.5, [0.1, 0.2, 0.4])
    H = held_noise(2, 0.5, [0.1, 0.2, 0.4])
    assert Q.shape == H.shape == (6, 6)
    for k, density in enumerate((0.1, 0.2, 0.4)):
        own = np.ix_([k, k + 3], [k, k + 3])
        assert Q[own] == pytest.approx(white_noise(2, 0.5, density))
        assert H[own] == pytest.approx(held_noise(2, 0.5, density))
        assert np.count_nonzero(Q[k]) == np.count_nonzero(H[k]) == 2


@pytest.mark.parametrize("function", [white_noise, held_noise])
def test_bad_input_is_named(function):
    for order in (0, -1, 1.5, True, "2"):
        with pytest.raises(SlamlibError, match=rf"{function.__name__}: order should be 1"):
            function(order, 0.1, 1.0)
    with pytest.raises(SlamlibError, match="dt should be a time of 0 s or more"):
        function(2, -0.1, 1.0)
    with pytest.raises(SlamlibError, match="none below 0"):
        function(2, 0.1, [1.0, -1.0])
    with pytest.raises(SlamlibError, match="one for each axis"):
        function(2, 0.1, np.eye(2))
    with pytest.raises(NonFiniteError, match="holds nan"):
        function(2, 0.1, np.nan)
    assert np.array_equal(function(np.int64(2), 0, 1), np.zeros((2, 2)))
    assert np.array_equal(function(2, 1, 0), np.zeros((2, 2)))
