"""Where an anchor stands is a convention: no measurement tells it, and a filter that carries it along gains nothing."""

from contextlib import contextmanager
from dataclasses import replace
from unittest.mock import patch

import numpy as np
import pytest

from slamlib.evaluation.consistency import band
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.geometry.pose import Pose
from slamlib.kalman import linalg
from slamlib.landmarks import LINES, POINTS
from slamlib.slam.anchors import anchored_rows, follows
from slamlib.slam.measurement_update import unprojected
from slamlib.slam.prediction import innovations
from slamlib.slam.transport import TRANSPORTS, Transport
from slamlib.slam.unobservable import Unobservable, generators
from slamlib.tests import test_transport
from slamlib.tests.test_transport import with_options

KINDS = {**POINTS, **LINES}
ANCHORED = sorted(name for name, kind in KINDS.items() if kind.anchor)


def with_landmark(name, **options):
    """The preset of a parametrization, without conversion to Euclidean points, unless it is asked for."""
    return replace(test_transport.with_landmark(name, **{"convert": False, **options}), frames=7)


def run(p):
    return test_transport.run(p, p.frames)


def anchors_columns(state):
    """S (size, r) of all anchors, and the rows (r,) of these."""
    columns, rows = [np.empty((state.belief.size, 0))], [np.empty(0, int)]
    for group in anchored_rows(state):
        for anchor, rest, F in zip(group.anchors, group.rest, group.F, strict=True):
            own = np.zeros((state.belief.size, len(anchor)))
            own[anchor], own[rest] = np.eye(len(anchor)), F
            columns.append(own)
            rows.append(anchor)
    return np.concatenate(columns, axis=1), np.concatenate(rows)


def with_anchors(state):
    """N (size, f + r) of the world and of all anchors."""
    return np.concatenate([generators(state), anchors_columns(state)[0]], axis=1)


def made_unsure(slam, N):
    """The filter is told that it may err by any of these columns (size, r), with a standard deviation of one."""
    blocks = dict(enumerate(slam.belief.blocks))
    slam.belief.overwrite(blocks, {i: block.mean for i, block in blocks.items()}, slam.belief.matrix + N @ N.T)


@contextmanager
def whole_matrices(state, sensor):
    """As `carried` with anchors, as chapter observability writes it: one N, of the world and of all anchors."""

    def N():
        return np.concatenate([Unobservable(state, sensor).N, anchors_columns(state)[0]], axis=1)

    before, rows = N(), np.concatenate([sensor.columns, anchors_columns(state)[1]])
    L = linalg.left_inverse(before[rows])
    state.belief.transport = lambda: linalg.Carry(rows, N() - before, L)
    try:
        yield unprojected
    finally:
        state.belief.transport = None


def test_which_types_have_an_anchor():
    assert ANCHORED == ["ahmPnt", "aplLin", "fhmPnt", "idpPnt", "planeIdpPnt"]


@pytest.mark.parametrize("name", ANCHORED)
def test_an_anchor_may_stand_anywhere(name):
    """The landmark, as a homogeneous point or a Plücker line in any frame, changes by its scale at most."""
    kind, rng = KINDS[name], np.random.default_rng(1)
    states = np.array([landmark.block.mean for landmark in run(with_landmark(name)).landmarks])
    F = follows(kind, states)
    S = np.concatenate([np.broadcast_to(np.eye(kind.anchor), (len(F), kind.anchor, kind.anchor)), F], axis=1)
    for pose in Pose.random(rng), Pose.random(rng):
        there, J = kind.to_frame.jac(pose, states)
        change = J.landmark @ S
        unit = there / np.linalg.norm(there, axis=-1, keepdims=True)
        across = change - unit[..., None] * (unit[:, None] @ change)
        assert np.abs(across).max() < 1e-9 * np.abs(J.landmark).max()


@pytest.mark.parametrize("name", ANCHORED)
def test_no_measurement_tells_where_an_anchor_stands(name):
    slam = run(with_landmark(name))
    N = with_anchors(slam.state)
    anchors = sum(landmark.kind.anchor for landmark in slam.landmarks)
    assert np.linalg.matrix_rank(N) == N.shape[1] == generators(slam.state).shape[1] + anchors
    for prediction in slam.project():
        prediction.measured = prediction.value + 1e-3
        _, found = innovations(slam.sensors[0], [prediction])
        H, own = found.H[0], N[prediction.columns]
        assert np.abs(H @ own).max() < 1e-9 * np.abs(H).max() * np.abs(own).max()


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize("name", ANCHORED)
def test_an_update_gains_nothing_on_where_an_anchor_stands(name, reproject):
    """Of two filters one is unsure of the world's motion and of each anchor; it stays exactly as unsure.

    Lines are not put back on their constraint, which is done as seen from where the robot is: that leaves 2e-5 of it.
    """
    far = {}
    free = replace(KINDS[name], constrain=None) if name in LINES else KINDS[name]
    for error in ("world", "anchors"):
        p = with_landmark(name, error=error, reproject=reproject)
        *frames, last = [frame for frame, _ in p.simulate()]
        sure, unsure = p.slam(), p.slam()
        for slam in (sure, unsure):
            for frame in frames:
                slam.step(frame)
            slam.predict(last.controls, last.dt)
            for landmark in slam.landmarks:
                landmark.kind = free
        made_unsure(unsure, with_anchors(unsure.state))
        was = sure.robots[0].pose.copy()
        for slam in (sure, unsure):
            slam.predictions[0] = slam.project()
            slam._update(0, last.scans[0])
        assert not np.allclose(sure.robots[0].pose, was, atol=1e-6)
        N, difference = with_anchors(sure.state), unsure.belief.matrix - sure.belief.matrix
        far[error] = np.linalg.norm(difference - N @ N.T) / np.linalg.norm(N @ N.T)
    assert far["anchors"] < 1e-9, far
    assert far["world"] > 1e-6, far


@pytest.mark.parametrize("name", ANCHORED)
def test_what_is_told_from_outside_gains_nothing_on_where_an_anchor_stands(name):
    far = {}
    for error in ("world", "anchors"):
        sure, unsure = (run(with_landmark(name, error=error, reproject=False)) for _ in range(2))
        made_unsure(unsure, anchors_columns(unsure.state)[0])
        for slam in (sure, unsure):
            place = np.eye(3, slam.robots[0].block.dof)
            slam.update([slam.robots[0].block], [place], np.array([0.02, -0.01, 0.01]), 1e-4 * np.eye(3))
        N, difference = anchors_columns(sure.state)[0], unsure.belief.matrix - sure.belief.matrix
        far[error] = np.linalg.norm(difference - N @ N.T) / np.linalg.norm(N @ N.T)
    assert far["anchors"] < 1e-9, far
    assert far["world"] > 1e-6, far


@pytest.mark.parametrize("name", [*ANCHORED, "self_calibration"])
def test_block_by_block_is_what_whole_matrices_do(name):
    """Points of which some are converted to Euclidean ones, and lines, which are put back on their constraint."""
    options = {"error": "anchors", "reproject": False, "convert": True}
    p = replace((with_landmark if name in KINDS else with_options)(name, **options), frames=12)
    found, dense = p.slam(), p.slam()
    for frame, _ in p.simulate():
        found.step(frame)
        with patch.dict(TRANSPORTS, {"anchors": Transport(whole_matrices)}):
            dense.step(frame)
    P = dense.belief.matrix
    np.testing.assert_allclose(found.belief.matrix, P, atol=1e-9 * np.abs(P).max())
    np.testing.assert_allclose(found.robots[0].pose, dense.robots[0].pose, atol=1e-11)
    assert anchored_rows(found.state)


@pytest.mark.parametrize("n", [30, 450])
def test_some_errors_follow_others_as_the_matrix_says(n):
    rng = np.random.default_rng(2)
    A, W = rng.standard_normal((n, n)), rng.standard_normal((4, n))
    P, at = A @ A.T, np.array([0, 1, 2])
    C, L, F = rng.standard_normal((n, 2)), rng.standard_normal((2, 3)), rng.standard_normal((3, 2, 3))
    sources, targets = np.array([[5, 6, 7], [12, 11, 10], [20, 21, 22]]), np.array([[8, 9], [14, 13], [23, 24]])
    D = np.zeros((n, n))
    for s, t, f in zip(sources, targets, F, strict=True):
        D[np.ix_(t, s)] = f
    T = (np.eye(n) + C @ L @ np.eye(n)[at]) @ (np.eye(n) + D)
    found, given = P.copy(), W.copy()
    linalg.subtract_square(found, W, linalg.Carry(at, C, L, [(sources, targets, F)]))
    expected = T @ (P - W.T @ W) @ T.T
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
    assert np.array_equal(found, found.T)
    assert np.array_equal(W, given)


@pytest.mark.parametrize("name", ["aplLin", "idpPnt"])
def test_a_filter_that_carries_its_anchors_is_consistent(name):
    """NEES of the pose, averaged over 8 runs at each of 60 frames, as with error="world"."""
    p = replace(with_landmark(name, error="anchors", reproject=False), noise_in="truth", frames=60)
    found = monte_carlo(p, 8, seed=5).nees[:, :, 0]
    average, (low, high) = found.mean(0), band(6, 8)
    assert found.mean() < 1.25 * 6
    assert np.mean((low < average) & (average < high)) > 0.9
