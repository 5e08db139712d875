"""Sequential updates: the same as one after another, and consistent also where an error ends them."""

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.errors import CovarianceError
from slamlib.geometry.pose import Pose
from slamlib.tests.beliefs import grown, random_covariance


def started():
    """A belief over a pose and three vectors, always the same."""
    rng, belief = np.random.default_rng(3), Belief()
    belief.add(Pose, Pose.random(rng), 0.01 * random_covariance(rng, 6))
    grown(belief, rng, 3, 2, 4)
    return belief


def measurements(count):
    """(columns, H, z, R) by the pose and one vector."""
    rng = np.random.default_rng(4)
    for i in range(count):
        start, stop = [(6, 9), (9, 11), (11, 15)][i % 3]
        columns = np.r_[0:6, start:stop]
        H, z = rng.standard_normal((2, len(columns))), 0.1 * rng.standard_normal(2)
        yield columns, H, z, random_covariance(rng, 2)


def test_a_series_is_one_after_another():
    one, all_ = started(), started()
    expected = [one.update_rows(*m) for m in measurements(7)]
    with all_.sequential_update() as sequence:
        found = [sequence.update(*m) for m in measurements(7)]
    assert np.allclose(one.matrix, all_.matrix, rtol=0, atol=1e-13 * np.abs(one.matrix).max())
    assert np.array_equal(all_.matrix, all_.matrix.T)
    for a, b in zip(one.blocks, all_.blocks, strict=True):
        assert np.allclose(a.mean, b.mean, rtol=0, atol=1e-12)
    for c, d in zip(expected, found, strict=True):
        assert np.isclose(c.nis, d.nis, rtol=1e-10, atol=0)
        assert np.allclose(c.covariance, d.covariance, rtol=1e-10, atol=1e-12)


def test_means_follow_at_once_and_are_read_only():
    belief = started()
    block, before = belief.blocks[1], belief.blocks[1].mean.copy()
    with belief.sequential_update() as sequence:
        sequence.update(*next(measurements(1)))
        assert not np.array_equal(block.mean, before)
        with pytest.raises(ValueError, match="read-only"):
            block.mean[0] = 0
    kept = block.mean
    copy = kept.copy()
    with belief.sequential_update() as sequence:
        sequence.update(*next(measurements(1)))
    assert np.array_equal(kept, copy)


def test_what_does_not_pass_the_gate_changes_nothing():
    belief, other = started(), started()
    with belief.sequential_update() as sequence:
        for i, m in enumerate(measurements(4)):
            correction = sequence.update(*m, gate=np.inf if i % 2 else 0.0)
            assert correction.nis > 0
    for m in list(measurements(4))[1::2]:
        other.update_rows(*m)
    assert np.allclose(belief.matrix, other.matrix, rtol=0, atol=1e-13 * np.abs(other.matrix).max())


def test_an_error_leaves_what_was_updated_before():
    belief, other = started(), started()
    good, (columns, H, z, R) = measurements(2)

    def corrected():
        with belief.sequential_update() as sequence:
            sequence.update(*good)
            sequence.update(columns, 0 * H, z, 0 * R)

    with pytest.raises(CovarianceError, match="innovation covariance"):
        corrected()
    other.update_rows(*good)
    assert np.allclose(belief.matrix, other.matrix, rtol=0, atol=1e-13 * np.abs(other.matrix).max())
    assert np.allclose(belief.blocks[2].mean, other.blocks[2].mean, rtol=0, atol=1e-13)
