"""Whatever is done to a belief, in whatever order: symmetric, positive, the textbook's numbers, or a clear error."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.errors import SlamlibError
from slamlib.tests.beliefs import Circle, grown, state

SIZES = st.sampled_from([1, 2, 3, Circle()])
SCALES = st.sampled_from([1e-3, 1.0, 30.0])


def dof_of(manifold):
    return manifold if isinstance(manifold, int) else manifold.dof


def semidefinite(rng, n, scale):
    """A covariance of any rank, zero included."""
    A = rng.standard_normal((n, rng.integers(0, n + 1))) * scale
    return A @ A.T


class Driver:
    """Random steps on a belief and, beside it, on a covariance with textbook formulas and full matrices."""

    def __init__(self, draw, seed):
        self.draw, self.rng = draw, np.random.default_rng(seed)
        self.belief, self.P, self.largest = Belief(), np.zeros((0, 0)), 0.0

    def point(self, manifold):
        return np.array([0.6, 0.8]) if isinstance(manifold, Circle) else self.rng.standard_normal(dof_of(manifold))

    def some(self):
        return self.draw(st.lists(st.sampled_from(self.belief.blocks), min_size=1, max_size=3, unique=True))

    def jacobians(self, rows, blocks):
        own = [self.rng.standard_normal((rows, b.dof)) for b in blocks]
        full = np.zeros((rows, self.belief.size))
        for block, J in zip(blocks, own, strict=True):
            full[:, block.slice] = J
        return own, full

    def add(self):
        manifold = self.draw(SIZES)
        n, blocks = dof_of(manifold), self.some() if self.belief.blocks and self.draw(st.booleans()) else []
        noise = semidefinite(self.rng, n, self.draw(SCALES))
        own, full = self.jacobians(n, blocks)
        self.belief.add(manifold, self.point(manifold), noise, given=blocks, jacobians=own)
        self.P = np.block([[self.P, self.P @ full.T], [full @ self.P, full @ self.P @ full.T + noise]])

    def remove(self):
        block = self.draw(st.sampled_from(self.belief.blocks))
        keep = np.setdiff1d(np.arange(len(self.P)), np.arange(len(self.P))[block.slice])
        self.belief.remove(block)
        self.P = self.P[np.ix_(keep, keep)]

    def replace(self):
        block, manifold = self.draw(st.sampled_from(self.belief.blocks)), self.draw(SIZES)
        J, n = self.rng.standard_normal((dof_of(manifold), block.dof)), len(self.P)
        head, tail = np.eye(n)[: block.start], np.eye(n)[block.slice.stop :]
        middle = np.zeros((len(J), n))
        middle[:, block.slice] = J
        left = np.concatenate([head, middle, tail])
        self.belief.replace(block, manifold, self.point(manifold), J)
        self.P = left @ self.P @ left.T

    def predict(self):
        block = self.draw(st.sampled_from(self.belief.blocks))
        F, Q = self.rng.standard_normal((block.dof,) * 2), semidefinite(self.rng, block.dof, self.draw(SCALES))
        big_F, big_Q = np.eye(len(self.P)), np.zeros_like(self.P)
        big_F[block.slice, block.slice], big_Q[block.slice, block.slice] = F, Q
        self.belief.predict(block, self.point(block.manifold), F, Q)
        self.P = big_F @ self.P @ big_F.T + big_Q

    def update(self):
        many, method = self.draw(st.integers(1, 3)), self.draw(st.sampled_from(["batch", "scalar"]))
        observations, rows, noise = [], [], []
        for _ in range(many):
            m, blocks = self.draw(st.integers(1, 3)), self.some()
            own, full = self.jacobians(m, blocks)
            scale = self.draw(SCALES)
            R = semidefinite(self.rng, m, scale) + scale**2 * 1e-3 * np.eye(m)
            observations.append(LinearizedMeasurement(blocks, own, self.rng.standard_normal(m), R))
            rows, noise = [*rows, full], [*noise, R]
        H, R, row = np.concatenate(rows), np.zeros((sum(map(len, noise)),) * 2), 0
        for part in noise:
            R[row : row + len(part), row : row + len(part)] = part
            row += len(part)
        S = H @ self.P @ H.T + R
        found = self.belief.update_all(observations, method=method)
        K = np.linalg.solve(S, H @ self.P).T
        left = np.eye(len(self.P)) - K @ H
        self.P = left @ self.P @ left.T + K @ R @ K.T
        assert found.nis >= 0
        assert np.array_equal(found.covariance, found.covariance.T)

    def check(self):
        """Rounding is relative to the largest covariance met: a sharp measurement takes most of a vague prior away."""
        P = self.belief.matrix
        self.largest = max(self.largest, np.abs(self.P).max(initial=0))
        assert P.shape == self.P.shape
        assert np.array_equal(P, P.T)
        assert np.allclose(P, self.P, rtol=0, atol=1e-9 * self.largest)
        assert not len(P) or np.linalg.eigvalsh(P)[0] >= -1e-12 * self.largest
        starts = np.cumsum([0, *(b.dof for b in self.belief.blocks)])
        assert [b.start for b in self.belief.blocks] == list(starts[:-1])
        assert all(np.isfinite(b.mean).all() and b.mean.shape == (b.manifold.size,) for b in self.belief.blocks)


@settings(max_examples=150, deadline=None, derandomize=True)
@given(data=st.data(), seed=st.integers(0, 2**32 - 1))
def test_any_sequence_is_the_textbooks_and_stays_a_covariance(data, seed):
    driver = Driver(data.draw, seed)
    driver.add()
    driver.check()
    for _ in range(data.draw(st.integers(1, 12))):
        names = ["add", "add", "predict", "update", "update", "replace", "remove"] if driver.belief.blocks else ["add"]
        getattr(driver, data.draw(st.sampled_from(names)))()
        driver.check()


NUMBERS = st.one_of(st.floats(-3, 3), st.floats(allow_nan=True, allow_infinity=True))


def array(shape):
    """Mostly of this shape, mostly of usable numbers; sometimes any."""
    shapes = st.one_of(st.just(shape), st.just(shape), array_shapes(min_dims=0, max_dims=3, max_side=4))
    return shapes.flatmap(lambda s: arrays(float, s, elements=st.one_of(st.just(1.0), NUMBERS)))


def square(n):
    """Mostly a covariance; sometimes any array."""
    good = st.integers(0, 99).map(lambda seed: semidefinite(np.random.default_rng(seed), n, 1.0) + 0.01 * np.eye(n))
    return st.one_of(good, good, array((n, n)))


def any_call(draw, belief, blocks):
    """One call with arguments that may be right."""
    a, b = blocks
    lists = st.sampled_from([[a], [b], [a, b], [b, b], [], [Belief().add(1, [0], 1)]])
    given, manifold = draw(lists), draw(st.sampled_from([1, 2, Circle()]))
    n, m = dof_of(manifold), draw(st.integers(1, 2))
    size = manifold if isinstance(manifold, int) else manifold.size
    observation = [draw(array((m, x.dof))) for x in given]
    method = draw(st.sampled_from(["batch", "scalar", "other"]))
    jacobians = [draw(array((n, x.dof))) for x in given]
    calls = {
        "add": lambda: belief.add(manifold, draw(array((size,))), draw(square(n)), given=given, jacobians=jacobians),
        "replace": lambda: belief.replace(a, manifold, draw(array((size,))), draw(array((n, a.dof)))),
        "predict": lambda: belief.predict(b, draw(array((b.dof,))), draw(array((b.dof,) * 2)), draw(square(b.dof))),
        "update": lambda: belief.update(given, observation, draw(array((m,))), draw(square(m)), method=method),
        "gate": lambda: belief.innovation_covariance(given, observation, draw(square(m))),
    }
    return calls[draw(st.sampled_from(sorted(calls)))]


@settings(max_examples=400, deadline=None, derandomize=True)
@given(data=st.data())
def test_any_arguments_work_or_raise_a_clear_error_and_change_nothing(data):
    belief = Belief()
    blocks = grown(belief, np.random.default_rng(3), 1, 2)
    call, before = any_call(data.draw, belief, blocks), state(belief)
    try:
        call()
    except SlamlibError as error:
        assert len(str(error)) > 20
        assert state(belief) == before
    else:
        P = belief.matrix
        assert np.isfinite(P).all()
        assert np.array_equal(P, P.T)
        assert np.linalg.eigvalsh(P)[0] >= -1e-9 * np.abs(P).max()
        assert all(np.isfinite(b.mean).all() for b in belief.blocks)
